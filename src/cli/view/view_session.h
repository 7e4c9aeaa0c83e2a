// The models of a window, their pictures and what is saved of them. Knows no window.
#pragma once

#include <list>
#include <memory>
#include <optional>

#include "command/prepared_model.h"
#include "common/program_error.h"
#include "view/drawing_effort.h"
#include "view/file_watch.h"
#include "view/view_state.h"

namespace softgl::cli {

class ViewSession {
public:
  // `save_as`: the file of saved pictures; empty: MODEL-1.png, MODEL-2.png ... in the folder of the run.
  ViewSession(ViewState start, std::string save_as, unsigned threads);
  ~ViewSession();

  const ViewState& state() const { return state_; }
  void handle(const Event& event);

  // Whether draw() would make another picture than the last one.
  bool is_stale() const { return arguments_ != drawn_; }
  // Draws the state's picture. Where that fails the last one stays, and error() says why, on standard error,
  // too.
  void draw(const Reduction& reduction = {});
  const Picture& picture() const { return picture_; } // RGB; empty before the first
  const std::optional<ProgramError>& error() const { return error_; }
  const std::string& message() const { return message_; } // for the window; empty: none
  double seconds() const { return seconds_; }             // that the last picture took, without reading
  std::string title() const;

  // Draws in full quality, writes that to a file, and prints on standard output the command that makes the
  // same file. `file` empty: what `save_as` says.
  void save(const std::string& file = {});

  // True if the model or a file that it names has changed: the picture is then stale.
  bool look_at_files();

private:
  struct LoadedModel;

  ProgramOptions options(const std::string& output) const;
  LoadedModel& loaded(const ProgramOptions& options);
  RenderResult render(ProgramOptions& options, const Reduction& reduction);
  void fail(const ProgramError& error);
  std::string free_name() const;
  void say(const Warnings& warnings, size_t sentences = 0, size_t notices = 0) const;

  ViewState state_;
  const std::string save_as_;
  const unsigned threads_;
  std::vector<std::string> arguments_, drawn_; // of the state, and of the picture
  std::list<LoadedModel> models_;              // the last one that was shown comes first
  Background background_;                      // read already
  FileWatch watch_;
  Picture picture_;
  std::optional<ProgramError> error_;
  std::string message_, said_; // said_: the last error on standard error
  double seconds_ = 0;
};

} // namespace softgl::cli
