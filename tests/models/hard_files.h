// Hard cases of OBJ and MTL files: what each holds, and what a good reader makes of it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace softgl::test {

struct HardFile {
  std::string name;
  std::string text;
  uint64_t triangles = 0;
  uint64_t segments = 0, points = 0;
  double area = -1;                  // -1: does not matter
  std::vector<std::string> warnings; // each must be part of some warning; none named: there must be none
  int exit_code = 0;
  std::string error; // part of the sentence that ends the run
};

// In rising order of name; expects the files of hard_file_companions() beside it.
const std::vector<HardFile>& hard_files();
const HardFile& hard_file(const std::string& name);

// Material libraries and pictures: name and bytes.
const std::vector<std::pair<std::string, std::string>>& hard_file_companions();

// Writes everything into a folder and returns it, with a slash at its end.
std::string write_hard_files();

} // namespace softgl::test
