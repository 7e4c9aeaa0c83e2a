// A test: one sentence of the specification, and a scene that shows whether it holds.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "script/script.h"

namespace softgl::suite {

constexpr int kNoVersion = 1000; // has it: an extension only
/// What a test needs beyond OpenGL 1.1: one of a version and an extension.
struct Need {
  int version = 11; // 12 for 1.2
  const char* extension = "";
  /// GL_WIN_phong_shading does not say whether interpolated normals are normalized: a picture may follow
  /// either.
  bool leaves_normals_open = false;
};
constexpr Need kVersion12{12}, kVersion13{13}, kVersion14{14}, kVersion15{15};
constexpr Need kImaging{14, "GL_ARB_imaging"}, kSeparateSpecular{12, "GL_EXT_separate_specular_color"},
    kRescaleNormal{12, "GL_EXT_rescale_normal"};

struct Test {
  std::string name;     // "lighting.diffuse.alone"
  std::string section;  // of the specification of OpenGL 1.5
  std::string sentence; // what must hold
  std::string open;     // what the specification leaves open, beside accuracy (2.1.1) and edges (3.5.1)
  std::function<void(Script&)> body;
  Need need;
};

/// A part of the specification: a folder of tests, whose names begin with the chapter's.
struct Chapter {
  const char* name; // "lighting", as --suite takes it
  std::vector<Test> (*tests)();
};
const std::vector<Chapter>& chapters();
/// The rows of a chapter's files.
std::vector<Test> joined(std::initializer_list<std::vector<Test> (*)()> files);
/// All tests, in the order of the chapters.
const std::vector<Test>& all_tests();
/// The name of a test's chapter.
std::string suite_of(const Test& test);
/// Calls that each test begins with: a cleared window, a projection, and the model five units before the eye.
Script prologue();
/// Prologue and body.
Script whole_script(const Test& test);

} // namespace softgl::suite
