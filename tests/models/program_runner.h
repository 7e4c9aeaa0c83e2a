// The softgl program as its users run it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace softgl::test {

struct ProgramRun {
  int exit_code = -1; // -1: ended by a signal
  std::string output, errors;
};

// A folder for what one process writes, ending in "/": ctest runs the cases side by side, and several write
// the same names. It is gone when the process ends.
std::string output_folder(const std::string& name);

// `environment`: variables as NAME=value, beside those of the tests.
ProgramRun run_softgl(const std::vector<std::string>& arguments, const std::string& input = {},
                      const std::vector<std::string>& environment = {});

// The same for any program: its path or a name that PATH knows, and its arguments.
ProgramRun run_command(const std::vector<std::string>& words, const std::string& input = {},
                       const std::vector<std::string>& environment = {});

struct TestPicture {
  int width = 0, height = 0;
  std::vector<uint8_t> rgb;

  const uint8_t* at(int x, int y) const { return &rgb[3 * (size_t(y) * size_t(width) + size_t(x))]; }
  size_t colors() const; // how many different ones
  // First and last column and row that differ from the top left pixel.
  struct Box {
    int left, right, top, bottom;
  };
  Box drawn() const;
};

TestPicture parse_ppm(const std::string& bytes);
TestPicture read_ppm(const std::string& path);

std::string read_bytes(const std::string& path);
// Makes the file's folder, too. Returns the path.
std::string write_bytes(const std::string& path, const std::string& bytes);

// An OBJ model: a pyramid whose height tells it from others.
std::string pyramid(int height);

} // namespace softgl::test
