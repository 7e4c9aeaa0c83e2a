#include "run/test.h"

#include "gl/subject.h"
#include "lighting/chapter.h"
#include "pixels/chapter.h"
#include "raster/chapter.h"
#include "special/chapter.h"
#include "texture/chapter.h"
#include "vertices/chapter.h"

namespace softgl::suite {

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> chapters = {
      {"lighting", lighting_tests}, {"vertices", vertices_tests}, {"texture", texture_tests},
      {"pixels", pixels_tests},     {"raster", raster_tests},     {"special", special_tests},
  };
  return chapters;
}

std::vector<Test> joined(std::initializer_list<std::vector<Test> (*)()> files) {
  std::vector<Test> all;
  for (const auto file : files)
    for (Test& test : file()) all.push_back(std::move(test));
  return all;
}

const std::vector<Test>& all_tests() {
  static const std::vector<Test> tests = [] {
    std::vector<Test> all;
    for (const Chapter& chapter : chapters())
      for (Test& test : chapter.tests()) all.push_back(std::move(test));
    return all;
  }();
  return tests;
}

std::string suite_of(const Test& test) { return test.name.substr(0, test.name.find('.')); }

Script prologue() {
  Script s;
  s.Viewport(0, 0, kWindowWidth, kWindowHeight), s.Disable(GL_DITHER);
  s.ClearColor(0.2, 0.1, 0.3, 1.0), s.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  // Not symmetric: edges shall not run through the centers of pixels.
  s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Ortho(-1.2, 1.2, -1.235, 1.195, 1.0, 20.0);
  s.MatrixMode(GL_MODELVIEW), s.LoadIdentity(), s.Translatef(0.0, 0.0, -5.0);
  return s;
}

Script whole_script(const Test& test) {
  Script s = prologue();
  test.body(s);
  return s;
}

} // namespace softgl::suite
