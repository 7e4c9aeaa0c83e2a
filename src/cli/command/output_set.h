// The files of a run: each is written as soon as its last picture is there.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "command/picture_plan.h"
#include "image/gif_encoder.h"
#include "image/png_encoder.h"
#include "scene/renderer.h"

namespace softgl::cli {

// Any thread may call, each job once: take() its picture, or leave() it out.
class OutputSet {
public:
  // Both outlive it.
  OutputSet(const PicturePlan& plan, const ProgramOptions& options);
  ~OutputSet();

  // Throws ProgramError if a file cannot be written.
  void take(size_t job, RenderResult result);
  void leave(size_t job);

private:
  struct Pending;

  void encode(const PictureJob& job, RenderResult result, Pending& pending) const;
  void arrive(size_t job, bool with_picture);
  GrowingArray<uint8_t> assemble(const PlannedOutput& output, Pending& pending, size_t first_job) const;
  Picture compose(const PlannedOutput& output, Pending& pending, size_t first_job) const;
  std::string label_of(const PictureJob& job) const;
  void write(size_t output, GrowingArray<uint8_t> bytes);

  const PicturePlan& plan_;
  const ProgramOptions& options_;
  std::vector<Pending> pending_; // for each output
  std::mutex mutex_;
  // Standard output gets its pictures in order.
  std::map<size_t, GrowingArray<uint8_t>> early_;
  size_t next_ = 0;
};

} // namespace softgl::cli
