#include "context/matrix.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/random.h"

using namespace softgl;
using softgl::test::Random;

namespace {

float distance_from_identity(const glm::mat4& m) {
  float worst = 0;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      worst = std::fmax(worst, std::fabs(m[column][row] - (row == column ? 1.0f : 0.0f)));
  return worst;
}

} // namespace

TEST_CASE("the inverse inverts, whatever a matrix was made of", "[state]") {
  Random r(3);
  for (int i = 0; i < 2000; ++i) {
    Matrix m;
    for (int step = r.integer(0, 5); step > 0; --step) {
      const float x = r.real(0.5f, 2), y = r.real(0.5f, 2), z = r.real(0.5f, 2);
      switch (r.integer(0, 6)) {
      case 0: rotate(m, r.real(-180, 180), x, r.chance(50) ? 0 : y, r.chance(50) ? 0 : z); break;
      case 1: translate(m, x, y, z); break;
      case 2: scale(m, x, x, x); break;
      case 3: scale(m, x, y, z); break;
      case 4: frustum(m, -x, y, -z, x, 1, 3); break;
      case 5: settle_history(m); break;
      default: {
        float v[16] = {x, 0, 0.25f, 0, 0, y, 0, 0, 0.5f, 0, z, 0, 1, 2, 3, 1};
        multiply(m, v);
      }
      }
    }
    const glm::mat4 inverted = inverse(m);
    const float scale_of_error =
        std::fmax(1.0f, std::fabs(glm::determinant(m.m)) + std::fabs(glm::determinant(inverted)));
    REQUIRE(distance_from_identity(m.m * inverted) < 1e-3f * scale_of_error);
  }
}

TEST_CASE("what a matrix was made of is remembered as OSMesa remembers it", "[state]") {
  Matrix m;
  rotate(m, 30, 1, 2, 3);
  translate(m, 1, 2, 3);
  settle_history(m);
  REQUIRE(is_length_preserving(m));
  REQUIRE(m.inverted[1][0] == m.m[0][1]); // a rotation is inverted by transposing it
  scale(m, 2, 2, 2);
  settle_history(m);
  REQUIRE_FALSE(is_length_preserving(m));
  set_identity(m); // the matrix is new, what is known of it is not
  REQUIRE_FALSE(is_length_preserving(m));
  REQUIRE(m.inverted == glm::mat4(1.0f));

  Matrix loaded;
  const float values[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 4, 5, 6, 1};
  load(loaded, values);
  REQUIRE_FALSE(is_length_preserving(loaded)); // not until somebody looks
  settle_history(loaded);
  REQUIRE(is_length_preserving(loaded));
  scale(loaded, 1, 1, 1);
  const Matrix same = loaded;
  load(loaded, same.data()); // an equal matrix is no news
  REQUIRE(loaded.flags == same.flags);
}

TEST_CASE("a singular matrix has the identity as its inverse", "[state]") {
  Matrix m;
  scale(m, 1, 0, 1);
  REQUIRE(inverse(m) == glm::mat4(1.0f));
  REQUIRE((m.flags & kMatrixSingular) != 0);
}

TEST_CASE("the inverse of an affine matrix is affine, whatever it was before", "[state]") {
  Matrix m;
  frustum(m, -1, 1, -1, 1, 1, 3);
  settle_history(m);
  const float shear[16] = {1, 0, 0, 0, 1, 2, 0, 0, 0, 0, 3, 0, 4, 5, 6, 1};
  load(m, shear);
  const glm::mat4 i = inverse(m);
  REQUIRE((i[0][3] == 0 && i[1][3] == 0 && i[2][3] == 0 && i[3][3] == 1));
}

TEST_CASE("multiplying keeps infinities out of affine products", "[state]") {
  Matrix m;
  translate(m, INFINITY, 0, 0);
  rotate(m, 90, 0, 0, 1);
  REQUIRE(std::isinf(m.m[3][0]));
  REQUIRE_FALSE(std::isnan(m.m[0][0]));
  REQUIRE(m.m[0][1] == 1.0f);
}
