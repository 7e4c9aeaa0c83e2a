// What the generated doors are made with: names, argument conversion, the payloads of display lists.
#include <catch2/catch.hpp>

#include <cstring>
#include <string>

#include "api/argument_conversion.h"
#include "api/names.h"
#include "commands/generated/list_playback.h"
#include "commands/generated/list_records.h"

using namespace softgl;

TEST_CASE("Entry points and tokens are sorted, so that they are found", "[api]") {
  for (size_t i = 1; i < kNamedDoorCount; ++i)
    CHECK(std::strcmp(kNamedDoors[i - 1].name, kNamedDoors[i].name) < 0);
  for (size_t i = 1; i < kNamedEnumCount; ++i) CHECK(kNamedEnums[i - 1].value < kNamedEnums[i].value);
  CHECK(std::string(enum_name(GL_DEPTH_TEST)) == "GL_DEPTH_TEST");
  CHECK(std::string(enum_name(0x12345)) == "0x12345");
  CHECK(find_door("glBegin") != nullptr);
  CHECK(find_door("glBeginn") == nullptr);
}

TEST_CASE("Integers become colors as table 2.9 says", "[api]") {
  CHECK(normalized(GLubyte(255)) == 1.0f);
  CHECK(normalized(GLubyte(51)) == 51.0f / 255.0f);
  CHECK(normalized(GLbyte(127)) == 1.0f);
  CHECK(normalized(GLbyte(-128)) == -1.0f);
  CHECK(normalized(GLushort(65535)) == 1.0f);
  CHECK(normalized(GLshort(-32768)) == -1.0f);
  CHECK(normalized(GLuint(0xffffffffu)) == 1.0f);
  CHECK(normalized(GLint(0x7fffffff)) == 1.0f);
  CHECK(normalized(GLint(-0x7fffffff - 1)) == -1.0f);
}

TEST_CASE("Parameters are counted and converted by their names", "[api]") {
  const GLint color[4] = {0x7fffffff, 0, -0x7fffffff - 1, 5};
  const Parameters ambient = vector_parameters(kCountOf_light, GL_AMBIENT, color);
  CHECK(ambient.v[0] == 1.0f);
  CHECK(ambient.v[2] == -1.0f);
  const Parameters position = vector_parameters(kCountOf_light, GL_POSITION, color);
  CHECK(position.v[3] == 5.0f);
  CHECK(count_of(kCountOf_light, GL_SPOT_DIRECTION) == 3);
  CHECK(count_of(kCountOf_light, 0x1234) == 0);
  CHECK(count_of(kCountOf_material, GL_COLOR_INDEXES) == 3);
  CHECK_FALSE(scalar_parameter(kCountOf_fog, GL_FOG_COLOR, 1).valid);
  CHECK(scalar_parameter(kCountOf_fog, GL_FOG_DENSITY, 2).v[0] == 2.0f);
  CHECK(scalar_parameter(kCountOf_fog, 0x1234, 2).valid); // the command itself raises the error
  CHECK(round_to_int(2.5f) == 3);
  CHECK(round_to_int(-3e38f) == -0x7fffffff - 1);
  CHECK(round_to_int(std::nanf("")) == 0);
}

TEST_CASE("Matrices are converted and transposed", "[api]") {
  double m[16];
  for (int i = 0; i < 16; ++i) m[i] = i + 0.1;
  CHECK(matrix_of(m).m[7] == 7.1f);
  CHECK(transposed(m).m[1] == 4.1f);
  CHECK(transposed(m).m[4] == 1.1f);
}

TEST_CASE("Recorded commands know their names and what is allowed between Begin and End", "[api]") {
  CHECK(std::string(opcode_name(uint16_t(Opcode::ShadeModel))) == "ShadeModel");
  CHECK(std::string(opcode_name(0xeeee)) == "?");
  CHECK(allowed_inside_begin_end(uint16_t(Opcode::Material)));
  CHECK_FALSE(allowed_inside_begin_end(uint16_t(Opcode::Enable)));
}
