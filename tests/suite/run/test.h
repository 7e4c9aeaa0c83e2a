// A test: one sentence of the specification, and a scene that shows whether it holds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "script/script.h"

namespace softgl::suite {

/// What a test needs beyond OpenGL 1.1: one of a version and an extension.
struct Need {
  int version = 11; // 12 for 1.2
  const char* extension = "";
};
constexpr Need kSeparateSpecular{12, "GL_EXT_separate_specular_color"},
    kRescaleNormal{12, "GL_EXT_rescale_normal"};

struct Test {
  std::string name;     // "lighting.diffuse.alone"
  std::string section;  // of the specification of OpenGL 1.5
  std::string sentence; // what must hold
  std::string open;     // what the specification leaves open, beside accuracy (2.1.1) and edges (3.5.1)
  std::function<void(Script&)> body;
  Need need;
};

/// All tests, in the order of the chapters.
const std::vector<Test>& all_tests();
/// The suite of a test: "lighting".
std::string suite_of(const Test& test);
/// Calls that each test begins with: a cleared window, a projection, and the model five units before the eye.
Script prologue();
/// Prologue and body.
Script whole_script(const Test& test);

// A function for each file of tests; each returns its rows.
std::vector<Test> lighting_term_tests();
std::vector<Test> lighting_attenuation_tests();
std::vector<Test> lighting_spot_tests();
std::vector<Test> lighting_position_tests();
std::vector<Test> lighting_count_tests();
std::vector<Test> lighting_normal_tests();
std::vector<Test> lighting_face_tests();
std::vector<Test> lighting_material_tests();
std::vector<Test> lighting_color_material_tests();
std::vector<Test> lighting_result_tests();
std::vector<Test> lighting_flat_tests();
std::vector<Test> lighting_sequence_tests();

} // namespace softgl::suite
