#include "command/sandbox_paths.h"

#include <filesystem>

#include "command/picture_plan.h"
#include "obj/file_search.h"

namespace softgl::cli {
namespace {

namespace fs = std::filesystem;

// The folder that a file will be written to; where the run makes it, the first that is there.
std::string existing_folder_of(const std::string& file) {
  std::error_code ignored;
  const fs::path target = fs::canonical(file, ignored); // of a symbolic link
  fs::path folder = fs::absolute(target.empty() ? fs::path(file) : target, ignored).parent_path();
  while (!fs::exists(folder, ignored) && folder.has_relative_path()) folder = folder.parent_path();
  return folder.string();
}

} // namespace

SandboxPaths sandbox_paths(const ProgramOptions& options) {
  SandboxPaths paths;
  if (options.limits.load.any_path) paths.read.emplace_back("/");
  for (const std::string& model : options.models) {
    if (model == "-") {
      paths.read.emplace_back("."); // where the files are that it names
      continue;
    }
    paths.read.push_back(model);
    if (!fs::is_directory(model)) paths.read.push_back(folder_of(model));
  }
  for (const std::string* file : {&options.render.background.file, &options.place.file})
    if (!file->empty()) paths.read.push_back(*file);
  const auto add_output = [&paths](const std::string& file) {
    if (!file.empty() && file != "-") paths.write.push_back(existing_folder_of(file));
  };
  if (options.command == ProgramOptions::kInfo) return paths;
  add_output(options.place.output);
  if (options.command == ProgramOptions::kRender) {
    for (const PlannedOutput& output : plan_pictures(options).outputs) add_output(output.path);
  } else {
    add_output(options.figure.folder ? options.output + "/figure" : options.output);
  }
  return paths;
}

} // namespace softgl::cli
