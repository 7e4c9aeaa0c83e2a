// A program of libFuzzer for what reads files of unknown origin: models (OBJ, PLY, STL, compressed or not),
// material libraries, pictures, cameras, lists of jobs; and the command line with its file.
// SOFTGL_FUZZ_READER names one of the functions below. Options print: -close_fd_mask=3 silences them.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

#include "command/camera_file.h"
#include "command/model_loader.h"
#include "common/compressed_text.h"
#include "common/program_error.h"
#include "image/picture_decoder.h"
#include "jobs/job_list.h"
#include "jobs/shard.h"
#include "mesh/mesh_builder.h"
#include "mesh/model_frame.h"
#include "mesh/normal_generator.h"
#include "options/command_line.h"

using namespace softgl::cli;

namespace {

void require(bool good) {
  if (!good) std::abort();
}

[[maybe_unused]] void read_model(SourceText text) {
  RemarkList remarks;
  Warnings warnings, notes;
  try {
    const SourceText source = decompressed(std::move(text));
    LoadedModel loaded = load_model(source, 1, remarks, warnings, notes);
    const ModelFrame frame = frame_model(loaded.model);
    generate_normals(loaded.model, frame, {});
    const Mesh mesh = build_mesh(loaded.model, frame, loaded.library, {}, remarks);
    const size_t vertices = mesh.positions.size() / 3;
    require(mesh.normals.size() == mesh.positions.size());
    for (const uint32_t index : mesh.triangles) require(index < vertices);
    for (const float value : mesh.positions) require(std::fabs(value) <= 1.0f);
    for (const float value : mesh.normals) require(std::fabs(value) <= 1.001f);
    for (const float value : mesh.texcoords) require(std::isfinite(value));
    for (const float value : mesh.colors) require(value >= 0 && value <= 1);
  } catch (const ProgramError& error) { require(error.code == kCannotRead); }
}

[[maybe_unused]] void read_materials(const SourceText& text) {
  MaterialLibrary library;
  Warnings warnings, notes;
  library.read(text, ModelFiles("fuzz.mtl"), ".", warnings, notes);
  for (const Material& material : library.materials())
    require(material.opacity >= 0 && material.opacity <= 1 && material.shininess >= 0 &&
            material.shininess <= 128);
}

[[maybe_unused]] void read_picture(const SourceText& text) {
  DecodedPicture picture;
  if (!decode_picture(text, picture).empty()) return;
  require(picture.rgba.size() == size_t(4) * size_t(picture.width) * size_t(picture.height));
  require(int64_t(picture.width) * picture.height <= kMostTexels);
}

[[maybe_unused]] void read_camera_file(const SourceText& text) {
  try {
    const CameraPlacement place = parse_camera(text);
    for (const double value : place.eye) require(std::fabs(value) <= 1e30);
    require(place.field_of_view >= 0 && place.field_of_view < 180 && place.height >= 0);
  } catch (const ProgramError& error) { require(error.code == kCannotRead); }
}

// Each line is a word of the command line; what follows an empty line is the file of options.
[[maybe_unused]] void read_options(const SourceText& text) {
  static const int file = memfd_create("options", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  std::string_view rest(text.begin(), text.size());
  std::vector<std::string> words = {"softgl"};
  while (!rest.empty()) {
    const size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view word = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (word.empty()) break;
    words.emplace_back(word.substr(0, word.find('\0')));
  }
  if (!rest.empty()) {
    require(ftruncate(file, 0) == 0 && pwrite(file, rest.data(), rest.size(), 0) == ssize_t(rest.size()));
    words.insert(words.end(), {"--config", path});
  }
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  pointers.push_back(nullptr);
  try {
    const ParsedOptions parsed = parse_options(int(words.size()), pointers.data());
    require(parsed.options || (parsed.exit_code >= 0 && parsed.exit_code < 128));
    if (parsed.options && parsed.options->command == ProgramOptions::kRender)
      require(!parsed.options->views.empty());
  } catch (const ProgramError& error) {
    require(error.code == kUsageError || error.code == kCannotRead);
    require(*error.what() != 0);
  }
}

// The first line is also read as the shard.
[[maybe_unused]] void read_jobs(const SourceText& text) {
  for (const JobLine& job : read_job_list(text))
    require(!job.where.empty() && (!job.model.empty() || !job.fault.empty()));
  try {
    const Shard shard = parse_shard({text.begin(), std::find(text.begin(), text.end(), '\n')});
    require(shard.number >= 1 && shard.number <= shard.count);
  } catch (const std::invalid_argument& error) { require(*error.what() != 0); }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  SOFTGL_FUZZ_READER(SourceText::from_string({reinterpret_cast<const char*>(bytes), size}, "fuzz"));
  return 0;
}
