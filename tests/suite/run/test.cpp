#include "run/test.h"

#include "gl/subject.h"

namespace softgl::suite {

const std::vector<Test>& all_tests() {
  static const std::vector<Test> tests = [] {
    std::vector<Test> all;
    for (const auto& chapter :
         {lighting_term_tests, lighting_attenuation_tests, lighting_spot_tests, lighting_position_tests,
          lighting_count_tests, lighting_normal_tests, lighting_face_tests, lighting_material_tests,
          lighting_color_material_tests, lighting_result_tests, lighting_flat_tests, lighting_sequence_tests})
      for (Test& test : chapter()) all.push_back(std::move(test));
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
