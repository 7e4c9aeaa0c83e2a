// The files for file managers: what they say is so, and their command makes a picture.
#include <catch2/catch.hpp>

#include "models/picture_files.h"
#include "models/program_runner.h"

#include "test_paths.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

using namespace softgl;
using namespace softgl::test;

namespace {

const std::string kDesktop = std::string(SOFTGL_TEST_SOURCE_DIR) + "/src/cli/desktop/";
const std::string kModels = std::string(SOFTGL_TEST_SOURCE_DIR) + "/reference/models/";

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

std::map<std::string, std::string> entry() {
  std::map<std::string, std::string> keys;
  const auto lines = split(read_bytes(kDesktop + "softgl.thumbnailer"), '\n');
  REQUIRE(lines.at(0) == "[Thumbnailer Entry]");
  for (size_t i = 1; i < lines.size(); ++i) {
    const size_t equals = lines[i].find('=');
    REQUIRE(equals != std::string::npos);
    REQUIRE(keys.emplace(lines[i].substr(0, equals), lines[i].substr(equals + 1)).second);
  }
  return keys;
}

#ifndef SOFTGL_ADDRESS_SANITIZER
ProgramRun make_thumbnail(const std::string& model, const std::string& picture, const std::string& side) {
  std::vector<std::string> arguments = split(entry().at("Exec"), ' ');
  REQUIRE(arguments.at(0) == "softgl");
  arguments.erase(arguments.begin());
  for (std::string& argument : arguments)
    if (argument.starts_with('%'))
      argument = argument == "%i" ? model : argument == "%o" ? picture : argument == "%s" ? side : "unknown";
  return run_softgl(arguments);
}
#endif

} // namespace

TEST_CASE("thumbnailer: its entry has the keys of one", "[models][thumbnailer]") {
  const auto keys = entry();
  CHECK(keys.size() == 3);
  CHECK(keys.at("TryExec") == "softgl");
  CHECK(keys.at("Exec").find(" --sandbox ") != std::string::npos);
  CHECK(keys.at("MimeType").back() == ';');
  const std::string kinds = read_bytes(kDesktop + "softgl.xml");
  for (const std::string& kind : split(keys.at("MimeType"), ';')) {
    INFO(kind);
    // The system's own list has the others.
    CHECK((kind == "model/stl" || kind == "model/obj" ||
           kinds.find("<mime-type type=\"" + kind + "\">") != std::string::npos));
  }
}

#ifndef SOFTGL_ADDRESS_SANITIZER // which needs more memory than --max-memory allows
TEST_CASE("thumbnailer: its command makes a picture", "[models][thumbnailer]") {
  const std::string folder = output_folder("thumbnailer");
  for (const char* side : {"128", "256"}) {
    const std::string picture = folder + "temporary"; // a name without an end
    std::ofstream(picture, std::ios::trunc).flush();  // tumbler makes the file, and reads from what it holds
    std::ifstream held(picture, std::ios::binary);
    const ProgramRun run = make_thumbnail(kModels + "lantern.obj", picture, side);
    INFO(run.errors);
    CHECK(run.exit_code == 0);
    CHECK(run.output.empty());
    CHECK(run.errors.empty());
    const std::string bytes(std::istreambuf_iterator<char>(held), {});
    REQUIRE(bytes == read_bytes(picture));
    const TestPicture decoded = decode_picture(bytes);
    CHECK(decoded.width == std::atoi(side));
    CHECK(decoded.height == std::atoi(side));
    CHECK(decoded.colors() > 100);
    CHECK(png_chunks(bytes, "IHDR").at(0)[9] == 6); // RGBA
  }
  // Alone in the folder of a manager's own sandbox: without library and pictures.
  std::filesystem::copy_file(kModels + "lantern.obj", folder + "alone.obj");
  const ProgramRun alone = make_thumbnail(folder + "alone.obj", folder + "alone", "64");
  CHECK(alone.exit_code == 0);
  CHECK(alone.errors.empty());
  std::ofstream(folder + "damaged.stl") << "solid nothing";
  const ProgramRun damaged = make_thumbnail(folder + "damaged.stl", folder + "damaged", "64");
  CHECK(damaged.exit_code == 3);
  CHECK_FALSE(std::filesystem::exists(folder + "damaged"));
}
#endif

TEST_CASE("thumbnailer: the kinds of files are well-formed", "[models][thumbnailer]") {
  const std::string folder = output_folder("kinds") + "mime/";
  std::filesystem::create_directories(folder + "packages");
  std::filesystem::copy_file(kDesktop + "softgl.xml", folder + "packages/softgl.xml");
  const std::string program = "/usr/bin/update-mime-database";
  if (!std::filesystem::exists(program)) {
    WARN("SKIPPED: shared-mime-info is not installed");
    return;
  }
  const std::string home = "XDG_DATA_HOME=" + output_folder("kinds");
  CHECK(std::system((home + " " + program + " " + folder + " > " + folder + "errors 2>&1").c_str()) == 0);
  CHECK(read_bytes(folder + "errors") == "");
  const std::string globs = read_bytes(folder + "globs2");
  CHECK(globs.find("50:model/ply:*.ply\n") != std::string::npos);
  CHECK(std::filesystem::exists(folder + "model/ply.xml"));
}
