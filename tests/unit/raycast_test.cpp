// reference/raycast: where rays hit, where they do not, and what color they bring back.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

#include "raycast/scene.h"
#include "support/random.h"
#include "test_paths.h"

using namespace softgl::raycast;

namespace {

void check(Vec3 got, Vec3 expected) {
  CHECK(got.x == Approx(expected.x).margin(1e-12));
  CHECK(got.y == Approx(expected.y).margin(1e-12));
  CHECK(got.z == Approx(expected.z).margin(1e-12));
}
void check(const std::optional<Hit>& hit, double distance, Vec3 point, Vec3 normal,
           bool from_behind = false) {
  REQUIRE(hit);
  CHECK(hit->distance == Approx(distance));
  check(hit->point, point);
  check(hit->normal, normal);
  CHECK(hit->from_behind == from_behind);
}
Ray along(Vec3 origin, Vec3 direction) { return {origin, softgl::spec::unit(direction)}; }

} // namespace

TEST_CASE("a sphere is hit in front, from inside, at its edge, and not behind", "[reference][raycast]") {
  const Sphere sphere({}, {0, 0, -5}, 2);
  check(sphere.intersect(along({0, 0, 0}, {0, 0, -1})), 3, {0, 0, -3}, {0, 0, 1});
  check(sphere.intersect(along({0, 0, -5}, {0, 1, 0})), 2, {0, 2, -5}, {0, 1, 0}, true); // inside
  check(sphere.intersect(along({2, 0, 0}, {0, 0, -1})), 5, {2, 0, -5}, {1, 0, 0});       // tangent
  CHECK_FALSE(sphere.intersect(along({2.0000001, 0, 0}, {0, 0, -1})));
  CHECK_FALSE(sphere.intersect(along({0, 0, 0}, {0, 0, 1})));  // behind
  CHECK_FALSE(sphere.intersect(along({0, 0, -3}, {0, 0, 1}))); // from the surface outwards
  check(sphere.intersect(along({0, 0, -3}, {0, 0, -1})), 4, {0, 0, -7}, {0, 0, -1}, true); // and inwards
  // Far away: no cancellation.
  const Sphere far({}, {0, 0, -1e6}, 1);
  const auto hit = far.intersect(along({0.5, 0, 0}, {0, 0, -1}));
  REQUIRE(hit);
  CHECK(hit->normal.z == Approx(std::sqrt(0.75)).epsilon(1e-9));
}

TEST_CASE("a plane is hit from both sides and not along itself", "[reference][raycast]") {
  const Plane plane({}, {0, -1, 0}, {0, 2, 0});
  check(plane.intersect(along({0, 0, 0}, {0, -1, 0})), 1, {0, -1, 0}, {0, 1, 0});
  check(plane.intersect(along({0, -3, 0}, {0, 3, 4})), 10.0 / 3, {0, -1, 8.0 / 3}, {0, 1, 0}, true);
  CHECK_FALSE(plane.intersect(along({0, 0, 0}, {1, 0, 0})));
  CHECK_FALSE(plane.intersect(along({0, -1, 0}, {1, 0, 0})));
  CHECK_FALSE(plane.intersect(along({0, 0, 0}, {0, 1, 0})));
}

TEST_CASE("a box has six faces, twelve edges and an inside", "[reference][raycast]") {
  const Box box({}, {0, 0, -5}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3});
  check(box.intersect(along({0, 0, 0}, {0, 0, -1})), 2, {0, 0, -2}, {0, 0, 1});
  check(box.intersect(along({5, 0, -5}, {-1, 0, 0})), 4, {1, 0, -5}, {1, 0, 0});
  check(box.intersect(along({-5, 0, -5}, {1, 0, 0})), 4, {-1, 0, -5}, {-1, 0, 0});
  check(box.intersect(along({0, 9, -5}, {0, -1, 0})), 7, {0, 2, -5}, {0, 1, 0});
  check(box.intersect(along({0, -9, -5}, {0, 1, 0})), 7, {0, -2, -5}, {0, -1, 0});
  check(box.intersect(along({0, 0, -20}, {0, 0, 1})), 12, {0, 0, -8}, {0, 0, -1});
  check(box.intersect(along({0, 0, -5}, {0, 0, 1})), 3, {0, 0, -2}, {0, 0, 1}, true);
  CHECK_FALSE(box.intersect(along({0, 0, 0}, {0, 0, 1})));
  CHECK_FALSE(box.intersect(along({1.001, 0, 0}, {0, 0, -1})));
  // Along an edge and through a corner: hit, with the normal of one of the faces there.
  const auto edge = box.intersect(along({1, 0, 0}, {0, 0, -1}));
  REQUIRE(edge);
  CHECK(edge->distance == Approx(2));
  const auto corner = box.intersect(along({2, 3, -1}, {-1, -1, -1}));
  REQUIRE(corner);
  check(corner->point, {1, 2, -2});
  CHECK(softgl::spec::length(corner->normal) == 1);
  // Turned by 45 degrees the box shows an edge; the ray beside it hits a face at 45 degrees.
  const double h = std::sqrt(0.5);
  const Box turned({}, {0, 0, -5}, {h, 0, h}, {0, 1, 0}, {-h, 0, h});
  check(turned.intersect(along({0.1, 0, 0}, {0, 0, -1})), 5 - std::sqrt(2.0) + 0.1,
        {0.1, 0, -5 + std::sqrt(2.0) - 0.1}, {h, 0, h});
}

TEST_CASE("a triangle mesh interpolates its normals", "[reference][raycast]") {
  const TriangleMesh mesh({}, {{{-1, -1, -2}, {0, 0, 1}}, {{1, -1, -2}, {1, 0, 0}}, {{-1, 1, -2}, {0, 1, 0}}},
                          {0, 1, 2});
  const double third = 1.0 / 3;
  const auto hit = mesh.intersect(along({-third, -third, 0}, {0, 0, -1}));
  REQUIRE(hit);
  check(hit->weights, {third, third, third});
  check(hit->normal, softgl::spec::unit({1, 1, 1}));
  CHECK_FALSE(hit->from_behind);
  CHECK(mesh.intersect(along({-third, -third, -4}, {0, 0, 1}))->from_behind);
  CHECK_FALSE(mesh.intersect(along({0.1, 0.1, 0}, {0, 0, -1})));   // beside the slanted edge
  CHECK_FALSE(mesh.intersect(along({-0.5, -0.5, -2}, {1, 0, 0}))); // in its plane
  CHECK_FALSE(TriangleMesh({}, {}, {}).intersect(along({}, {0, 0, -1})));
}

TEST_CASE("the tree of a mesh finds what a loop over all triangles finds", "[reference][raycast]") {
  softgl::test::Random random(5);
  const auto vector = [&](float size) {
    return Vec3{random.real(-size, size), random.real(-size, size), random.real(-size, size)};
  };
  std::vector<TriangleMesh::Vertex> vertices;
  std::vector<int> indices;
  Scene alone;
  for (int i = 0; i < 200; i++) {
    const Vec3 center = vector(1);
    std::vector<TriangleMesh::Vertex> triangle;
    for (int k = 0; k < 3; k++)
      triangle.push_back({center + vector(0.2f), {0, 0, 1}}), indices.push_back(3 * i + k);
    vertices.insert(vertices.end(), triangle.begin(), triangle.end());
    alone.shapes.push_back(std::make_unique<TriangleMesh>(Material{}, triangle, std::vector<int>{0, 1, 2}));
  }
  const TriangleMesh mesh({}, vertices, indices);
  int hits = 0;
  for (int i = 0; i < 2000; i++) {
    const Ray ray = along(vector(1), vector(1));
    const auto expected = alone.nearest(ray), got = mesh.intersect(ray);
    REQUIRE(bool(got) == bool(expected));
    if (!got) continue;
    hits++;
    CHECK(got->distance == expected->distance);
  }
  CHECK(hits > 300);
}

TEST_CASE("materials compute the textbook's equation and OpenGL's", "[reference][raycast]") {
  Material material;
  material.kAmbient = {0.5, 0.25, 0}, material.kDiffuse = {1, 0.5, 0}, material.kSpecular = {0.5, 0.5, 0.5},
  material.phongExponent = 2;
  Illumination light;
  light.model.ambient = {0.2, 0.2, 0.2};
  light.lights.resize(1);
  light.lights[0].position = {0.6, 0, 0.8, 0};
  light.lights[0].diffuse = light.lights[0].specular = {0.5, 0.5, 1};
  const Ray ray{{0, 0, 1}, {0, 0, -1}};
  Hit hit{1, {0, 0, 0}, {0, 0, 1}, false, &material, 0, {}};
  // n.s = 0.8, v.r = 0.8: ka LA + kd L 0.8 + ks L 0.64
  check(material.shade(hit, ray, light), {0.1 + 0.4 + 0.16, 0.05 + 0.2 + 0.16, 0.32});
  light.equation = Equation::OpenGL; // n.h = sqrt 0.9
  check(material.shade(hit, ray, light), {0.1 + 0.4 + 0.225, 0.05 + 0.2 + 0.225, 0.45});
  light.model.highlight = softgl::spec::Highlight::ReflectionVector;
  check(material.shade(hit, ray, light), {0.66, 0.41, 0.32});
  light.model.separate_specular = true; // the sum of both colors
  check(material.shade(hit, ray, light), {0.66, 0.41, 0.32});

  // From behind: the light does not reach, unless the surface has two sides.
  hit.normal = {0, 0, -1}, hit.from_behind = true;
  check(material.shade(hit, ray, light), {0.1, 0.05, 0});
  light.model.two_sided = true;
  check(material.shade(hit, ray, light), {0.66, 0.41, 0.32});
  light.equation = Equation::Textbook;
  check(material.shade(hit, ray, light), {0.66, 0.41, 0.32});
}

TEST_CASE("a scene shows the nearest shape through the centre of each pixel", "[reference][raycast]") {
  Scene scene = parse_scene("size 3 3\ncamera orthographic 1.5\nambient 1 1 1\n"
                            "material ambient 1 0 0\nsphere 0 0 -5 0.5\n"
                            "material ambient 0 1 0\nbox 1 1 -3 0.4 0.4 0.4\nbox 1 1 -6 0.4 0.4 0.4\n"
                            "background 0 0 1\n",
                            "test");
  const std::vector<uint8_t> rgb = render(scene);
  REQUIRE(rgb.size() == 27);
  const auto pixel = [&](int x, int row) {
    return rgb[size_t(9 * row + 3 * x)] * 65536 + rgb[size_t(9 * row + 3 * x + 1)] * 256 +
           rgb[size_t(9 * row + 3 * x + 2)];
  };
  CHECK(pixel(1, 1) == 0xff0000);
  CHECK(pixel(2, 0) == 0x00ff00); // y upwards: the top row comes first
  CHECK(pixel(0, 0) == 0x0000ff);
  CHECK(pixel(2, 2) == 0x0000ff);
  const Camera camera{200, 100, true, 90, 1};
  check(camera.ray(100, 100).direction, {0, std::sqrt(0.5), -std::sqrt(0.5)});
  check(camera.ray(200, 50).direction, softgl::spec::unit({2, 0, -1}));
}

TEST_CASE("what stands between a point and a light casts a shadow, where it is asked for",
          "[reference][raycast]") {
  // The middle of the plane lies below the sphere, as the light at infinity and the lamp see it.
  const std::string text =
      "camera orthographic 2\nambient 0 0 0\nmaterial diffuse 0.5 0.5 0.5  specular 0 0 0\n"
      "plane 0 0 -5  0 0 1\nsphere 0 1.5 -3.5  0.4\n";
  const std::string from_above = "light 0 1 1 0  1 1 1\n", lamp = "light 0 3 -2 1  1 1 1\n",
                    below = "light 0 0.5 -4.5 1  1 1 1\n"; // a lamp between plane and sphere
  const Ray middle = along({0, 0, 0}, {0, 0, -1}), beside = along({1, 0, 0}, {0, 0, -1});
  const double half = std::sqrt(0.5) / 2;
  const auto color = [&](const std::string& scene, const Ray& ray) {
    return parse_scene(text + scene, "test").color(ray);
  };
  check(color(from_above, middle), {half, half, half});
  check(color(from_above + "shadows 1e-9\n", middle), {0, 0, 0});
  check(color(lamp + "shadows 1e-9\n", middle), {0, 0, 0});
  check(color(below + "shadows 1e-9\n", middle), {half, half, half});
  check(color(from_above + "shadows 1e-9\n", beside), {half, half, half});
  check(color(from_above + "shadows 5\n", middle), {half, half, half}); // it starts behind the sphere
}

TEST_CASE("the textbook's test of light from behind can be left out", "[reference][raycast]") {
  const std::string text =
      "camera orthographic 1\nambient 1 1 1\nlight 0 0.6 -0.8 0  1 1 1\n"
      "material ambient 0.9 0.9 0.9  diffuse 0.5 0.5 0.5  specular 0 0 0\nplane 0 0 -5  0 0 1\n";
  const Ray ray = along({0, 0, 0}, {0, 0, -1});
  check(parse_scene(text, "test").color(ray), {0.9, 0.9, 0.9});
  check(parse_scene(text + "without_test\n", "test").color(ray), {0.5, 0.5, 0.5});
}

TEST_CASE("scene files say what is wrong with them", "[reference][raycast]") {
  for (const char* text : {"sphere 0 0 0", "sphere 0 0 0 -1", "size 0 5", "size 100000 5", "camera fisheye",
                           "camera perspective 180", "light 0 0 1 1 1 1 1 color 3", "material 3",
                           "box 0 0 0 1 1 1 fold", "mesh no-such-file.obj", "blob 1 2 3", "plane 0 0 0 0 0 0",
                           "sphere 0 0 0 1 2", "ambient 1 1 nan", "shadows"}) {
    INFO(text);
    CHECK_THROWS_WITH(parse_scene(std::string("size 4 4\n") + text, "file"), Catch::StartsWith("file:2: "));
  }
  CHECK_THROWS_WITH(read_scene("/nowhere/scene"), "cannot read /nowhere/scene");
  for (const char* name : {"sphere", "shapes", "spots"}) {
    const Scene scene = parse_scene(built_in_scene(name), name);
    CHECK(scene.nearest(scene.camera.ray(scene.camera.width / 2.0, scene.camera.height * 0.3)));
  }
  CHECK(built_in_scene("other") == nullptr);
}

TEST_CASE("softgl_raycast writes pictures", "[reference][raycast][program]") {
  const std::string folder = SOFTGL_TEST_OUTPUT "/raycast/",
                    program = SOFTGL_TEST_BINARY_DIR "/softgl_raycast ";
  REQUIRE(std::system(("mkdir -p " + folder).c_str()) == 0);
  std::ofstream(folder + "mesh.obj")
      << "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvn 0 0 2\nf 1//1 2//1 3//-1 -1\n";
  std::ofstream(folder + "scene.txt")
      << "size 20 10\nlight 0 0 1 0 1 1 1\nmesh mesh.obj at 0 0 -4 scale 0.5 # a square\n";
  CHECK(std::system((program + folder + "scene.txt -o " + folder + "scene.png").c_str()) == 0);
  std::ifstream png(folder + "scene.png", std::ios::binary);
  char signature[4] = {};
  png.read(signature, 4);
  CHECK(std::string(signature + 1, 3) == "PNG");
  CHECK(std::system((program + "no-such-scene 2> /dev/null").c_str()) != 0);
  CHECK(std::system((program + "2> /dev/null").c_str()) != 0);
}
