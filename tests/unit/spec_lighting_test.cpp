// reference/spec: every formula against values worked out by hand.
#include <catch2/catch.hpp>

#include <vector>

#include "spec/lighting.h"

using namespace softgl::spec;

namespace {

Approx near(double value) { return Approx(value).margin(1e-12); }
void check(Vec3 got, Vec3 expected) {
  CHECK(got.x == near(expected.x));
  CHECK(got.y == near(expected.y));
  CHECK(got.z == near(expected.z));
}
const double kRoot2 = std::sqrt(2.0);

} // namespace

TEST_CASE("2.11.3: normals go through the inverse, are rescaled and normalized", "[reference][lighting]") {
  Matrix4 scale;
  scale.m[0] = 2, scale.m[5] = 4, scale.m[10] = 5, scale.m[12] = 7; // the translation does not matter
  check(transform_normal(scale, {1, 1, 1}, false, false), {0.5, 0.25, 0.2});
  check(transform_normal(scale, {1, 1, 1}, true, false),
        {2.5, 1.25, 1}); // third row of the inverse: (0, 0, 1/5)
  check(transform_normal(scale, {4, 0, 0}, false, true), {1, 0, 0});
  check(transform_normal(scale, {0, 8, 0}, true, true), {0, 1, 0});
  Matrix4 shear;
  shear.m[4] = 1; // x' = x + y: the surface x = -y becomes x' = 0
  check(transform_normal(shear, {1, 1, 0}, false, false), {1, 0, 0});
  Matrix4 turn; // x to y, y to -x
  turn.m[0] = 0, turn.m[1] = 1, turn.m[4] = -1, turn.m[5] = 0;
  check(transform_normal(turn, {1, 0, 0}, false, false), {0, 1, 0});
  Matrix4 singular;
  singular.m[10] = 0;
  check(transform_normal(singular, {0, 0, 1}, false, true), {0, 0, 0});
  check(transform_normal({}, {0, 0, 0}, false, true), {0, 0, 0});
}

TEST_CASE("2.14.1: directions between homogeneous points", "[reference][lighting]") {
  check(direction_between({1, 2, 3, 1}, {1, 5, 7, 1}), {0, 0.6, 0.8});
  check(direction_between({1, 0, 0, 1}, {6, 0, 0, 2}), {1, 0, 0});  // 6/2 = 3 lies to the right of 1
  check(direction_between({1, 0, 0, 1}, {1, 0, 0, 2}), {-1, 0, 0}); // 1/2 to the left
  check(direction_between({9, 9, 9, 1}, {0, 3, 4, 0}), {0, 0.6, 0.8});
  check(direction_between({0, 3, 4, 0}, {9, 9, 9, 1}), {0, -0.6, -0.8});
  check(direction_between({1, 0, 0, 0}, {0, 1, 0, 0}), {-1 / kRoot2, 1 / kRoot2, 0});
  check(direction_between({1, 1, 1, 1}, {2, 2, 2, 2}), {0, 0, 0}); // no direction
}

TEST_CASE("2.14.1: attenuation by distance, equation 2.4", "[reference][lighting]") {
  Light light;
  light.constant_attenuation = 0.5, light.linear_attenuation = 0.25, light.quadratic_attenuation = 2;
  CHECK(distance_attenuation(light, {5, 5, 5, 1}) == 1); // directional
  light.position = {0, 0, 6, 2};
  CHECK(distance_attenuation(light, {0, 0, 1, 1}) == near(1 / (0.5 + 0.5 + 8)));
  CHECK(distance_attenuation(light, {0, 0, 2, 2}) == near(1 / (0.5 + 0.5 + 8)));
}

TEST_CASE("2.14.1: spotlights, equation 2.5", "[reference][lighting]") {
  Light light;
  light.position = {0, 0, 0, 1};
  light.spot_direction = {0, 0, -3}; // of any length
  light.spot_exponent = 2;
  CHECK(spotlight(light, {0, 5, 5, 1}) == 1); // 180: no spotlight
  light.spot_cutoff = 60;
  CHECK(spotlight(light, {1, 0, -1, 1}) == near(0.5)); // 45 degrees: (1/sqrt 2)^2
  CHECK(spotlight(light, {2, 0, -1, 1}) == 0);         // 63 degrees
  light.spot_cutoff = 0;
  CHECK(spotlight(light, {0, 0, -7, 1}) == 1);
  CHECK(spotlight(light, {0.001, 0, -7, 1}) == 0);
  light.spot_cutoff = 90, light.spot_exponent = 0;
  CHECK(spotlight(light, {100, 0, -1, 1}) == 1);
  CHECK(spotlight(light, {100, 0, 1, 1}) == 0);
  light.position = {0, 3, 0, 0}; // a directional light shines along -position
  light.spot_direction = {0, -1, 0};
  CHECK(spotlight(light, {1, 2, 3, 1}) == 1);
}

TEST_CASE("2.14.1: half vector, reflection vector and their highlights", "[reference][lighting]") {
  check(half_vector({1, 0, 0}, {0, 0, 1}), {1 / kRoot2, 0, 1 / kRoot2});
  check(reflection_vector({0.6, 0, 0.8}, {0, 0, 1}), {-0.6, 0, 0.8});
  const Vec3 n{0, 0, 1}, l{0.6, 0, 0.8}, v{0, 0, 1};
  // h = (0.6, 0, 1.8) / sqrt 3.6; n.h = 1.8 / sqrt 3.6 = sqrt 0.9. v.r = 0.8.
  CHECK(highlight(Highlight::HalfVector, n, l, v, 2) == near(0.9));
  CHECK(highlight(Highlight::ReflectionVector, n, l, v, 2) == near(0.64));
  CHECK(highlight(Highlight::HalfVector, n, -l, v, 2) == 0);
  CHECK(highlight(Highlight::HalfVector, n, {1, 0, 0}, v, 0) == 0); // f_i: the light grazes the surface
  CHECK(highlight(Highlight::HalfVector, n, l, v, 0) == 1);
  CHECK(highlight(Highlight::ReflectionVector, n, l, v, 0) == 1);
  CHECK(highlight(Highlight::ReflectionVector, n, l, {0.8, 0, -0.6}, 0) == 0); // v.r = -0.96
}

TEST_CASE("2.14.1: the sum over the lights", "[reference][lighting]") {
  LightModel model;
  model.ambient = {0.5, 0.5, 0.5};
  Material material;
  material.ambient = {0.2, 0.4, 0.6, 0.9};
  material.diffuse = {0.5, 1, 0, 0.25};
  material.specular = {1, 0.5, 0.25, 0.9};
  material.emission = {0.01, 0.02, 0.03, 0.9};
  material.shininess = 1;
  Light above;
  above.ambient = {0.1, 0.1, 0.1}, above.diffuse = {1, 0.5, 1}, above.specular = {0.2, 0.2, 0.4};
  std::vector<Light> lights{above};

  // n.l = 1, n.h = 1: e + a(0.5 + 0.1) + d * (1, 0.5, 1) + s * (0.2, 0.2, 0.4)
  LitColor lit = light_vertex(model, lights, material, {3, 4, 5, 1}, {0, 0, 1});
  check(lit.primary.xyz(), {0.01 + 0.12 + 0.5 + 0.2, 0.02 + 0.24 + 0.5 + 0.1, 0.03 + 0.36 + 0 + 0.1});
  check(lit.secondary, {0, 0, 0});
  CHECK(lit.primary.w == 0.25);

  model.separate_specular = true;
  lit = light_vertex(model, lights, material, {3, 4, 5, 1}, {0, 0, 1});
  check(lit.primary.xyz(), {0.63, 0.76, 0.39});
  check(lit.secondary, {0.2, 0.1, 0.1});
  const Vec4 sum = color_sum(clamped(lit));
  check(sum.xyz(), {0.83, 0.86, 0.49});

  // From behind only the ambient terms are left; attenuation takes the light's own ambient, not the scene's.
  lit = light_vertex(model, lights, material, {0, 0, 0, 1}, {0, 0, -1});
  check(lit.primary.xyz(), {0.13, 0.26, 0.39});
  check(lit.secondary, {0, 0, 0});
  lights[0].position = {0, 0, 2, 1}, lights[0].quadratic_attenuation = 0.25; // att = 1/2
  lit = light_vertex(model, lights, material, {0, 0, 0, 1}, {0, 0, -1});
  check(lit.primary.xyz(), {0.01 + 0.1 + 0.01, 0.02 + 0.2 + 0.02, 0.03 + 0.3 + 0.03});

  // The viewer at the eye: vertex at (0, 0, -1), normal and light towards +x, so h = (1, 0, 1) / sqrt 2.
  model.separate_specular = false, model.local_viewer = true, model.terms = {false, false, false, true};
  lights[0] = above, lights[0].position = {1, 0, 0, 0};
  lit = light_vertex(model, lights, material, {0, 0, -1, 1}, {1, 0, 0});
  check(lit.primary.xyz(), {0.2 / kRoot2, 0.1 / kRoot2, 0.1 / kRoot2});
  model.highlight = Highlight::ReflectionVector; // r = +x, v = +z
  check(light_vertex(model, lights, material, {0, 0, -1, 1}, {1, 0, 0}).primary.xyz(), {0, 0, 0});
}

TEST_CASE("the terms of the sum add up to the whole", "[reference][lighting]") {
  LightModel model;
  Material material;
  material.specular = {0.9, 0.8, 0.7, 1}, material.emission = {0.1, 0, 0.2, 1}, material.shininess = 3;
  std::vector<Light> lights(2);
  lights[0].ambient = {0.1, 0.2, 0.3}, lights[0].diffuse = {1, 0.9, 0.8}, lights[0].specular = {1, 1, 1},
  lights[0].position = {1, 2, 3, 0};
  lights[1] = lights[0], lights[1].position = {1, -2, 3, 1}, lights[1].linear_attenuation = 0.5;
  const auto picture = [&](Terms terms) {
    model.terms = terms;
    return light_vertex(model, lights, material, {0.1, 0.2, -3, 1}, {0, 0.6, 0.8}).primary.xyz();
  };
  const Vec3 sum = picture({true, false, false, false}) + picture({false, true, false, false}) +
                   picture({false, false, true, false}) + picture({false, false, false, true});
  check(sum, picture({}));
  check(picture({false, false, false, false}), {0, 0, 0});
}

TEST_CASE("2.14.1: the sign of a polygon's area selects the face", "[reference][lighting]") {
  const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
      other{{0, 0, 0}, {0, 2, 0}, {2, 2, 0}, {2, 0, 0}};
  CHECK(twice_signed_area(square) == 8);
  CHECK(twice_signed_area(other) == -8);
  CHECK_FALSE(faces_back(8, false));
  CHECK(faces_back(8, true));
  CHECK(faces_back(-8, false));
  CHECK(faces_back(0, false));
  CHECK(faces_back(0, true));
}

TEST_CASE("2.14.3 and 2.14.6: tracked colors, clamping, rounding", "[reference][lighting]") {
  const Vec4 color{0.1, 0.2, 0.3, 0.4};
  CHECK(track_color({}, TrackedColor::Emission, color).emission.w == 0.4);
  CHECK(track_color({}, TrackedColor::Specular, color).specular.x == 0.1);
  CHECK(track_color({}, TrackedColor::Ambient, color).ambient.y == 0.2);
  CHECK(track_color({}, TrackedColor::Ambient, color).diffuse.y == 0.8);
  const Material both = track_color({}, TrackedColor::AmbientAndDiffuse, color);
  CHECK(both.ambient.z == 0.3);
  CHECK(both.diffuse.z == 0.3);
  const LitColor c = clamped({{-1, 0.5, 7, 1}, {2, -2, 0.25}});
  check(c.primary.xyz(), {0, 0.5, 1});
  check(c.secondary, {1, 0, 0.25});
  check(color_sum(c).xyz(), {1, 0.5, 1});
  CHECK(to_fixed_point(0.5) == 128);
  CHECK(to_fixed_point(1.0 / 255) == 1);
  CHECK(to_fixed_point(-3) == 0);
  CHECK(to_fixed_point(3) == 255);
}
