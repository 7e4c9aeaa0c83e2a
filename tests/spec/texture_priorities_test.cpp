// Priorities and residence of textures (GL 1.5, 3.8.12), and the integer forms of point parameters (3.3).
#include <catch2/catch.hpp>

#include "spec/state_snapshot.h"

using namespace softgl::test;

namespace {

GLfloat priority_of(const Gl& gl, GLuint name) {
  GLfloat priority = -1;
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_PRIORITY, &priority);
  return priority;
}

} // namespace

TEST_CASE("Priorities are clamped, and of names that are no textures ignored", "[spec][textures]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    gl->BindTexture(GL_TEXTURE_2D, 1);
    gl->BindTexture(GL_TEXTURE_2D, 2);
    CHECK(priority_of(*gl, 1) == 1);
    const GLuint names[4] = {1, 0, 9, 2};
    const GLclampf priorities[4] = {0.25f, 0.5f, 0.5f, 7};
    gl->PrioritizeTextures(4, names, priorities);
    CHECK(gl->GetError() == GL_NO_ERROR);
    CHECK(priority_of(*gl, 1) == 0.25f);
    CHECK(priority_of(*gl, 2) == 1);
    CHECK(priority_of(*gl, 0) == 1); // the texture that has no name cannot be meant
    CHECK_FALSE(gl->IsTexture(9));
    const GLclampf negative[1] = {-3};
    gl->PrioritizeTextures(1, names, negative);
    CHECK(priority_of(*gl, 1) == 0);
    gl->NewList(1, GL_COMPILE);
    gl->PrioritizeTextures(1, names, priorities);
    gl->EndList();
    CHECK(priority_of(*gl, 1) == 0);
    gl->CallList(1);
    CHECK(priority_of(*gl, 1) == 0.25f);
  }
}

TEST_CASE("All textures are resident", "[spec][textures]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    for (GLuint name : {1, 2, 3}) gl->BindTexture(GL_TEXTURE_2D, name);
    const GLuint names[3] = {3, 1, 2};
    GLboolean residences[3] = {7, 7, 7}; // are not written where all are resident
    CHECK(gl->AreTexturesResident(3, names, residences) == GL_TRUE);
    CHECK((residences[0] == 7 && residences[1] == 7 && residences[2] == 7));
    const GLuint unknown[2] = {1, 9};
    CHECK(gl->AreTexturesResident(2, unknown, residences) == GL_FALSE);
    CHECK(gl->GetError() == GL_INVALID_VALUE);
    CHECK((residences[0] == 7 && residences[1] == 7));
    GLint resident = 0;
    gl->GetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, &resident);
    CHECK(resident == GL_TRUE);
  }
}

TEST_CASE("Point parameters are given as integers, too", "[spec][points]") {
  for (const Gl* gl : {&softgl_library(), &osmesa_library()}) {
    INFO(gl->name);
    CurrentContext context(*gl);
    gl->PointParameteri(GL_POINT_SIZE_MIN, 3);
    gl->PointParameteri(GL_POINT_FADE_THRESHOLD_SIZE, 5);
    const GLint size = 40, attenuation[3] = {2, 0, 1};
    gl->PointParameteriv(GL_POINT_SIZE_MAX, &size);
    gl->PointParameteriv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
    CHECK(gl->GetError() == GL_NO_ERROR);
    GLfloat values[3] = {};
    gl->GetFloatv(GL_POINT_SIZE_MIN, &values[0]);
    gl->GetFloatv(GL_POINT_FADE_THRESHOLD_SIZE, &values[1]);
    gl->GetFloatv(GL_POINT_SIZE_MAX, &values[2]);
    CHECK((values[0] == 3 && values[1] == 5 && values[2] == 40));
    gl->GetFloatv(GL_POINT_DISTANCE_ATTENUATION, values);
    CHECK((values[0] == 2 && values[1] == 0 && values[2] == 1));
  }
}
