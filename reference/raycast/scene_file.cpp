// Reads scenes: one thing a line. NOTES.md has the words.
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "scene.h"

namespace softgl::raycast {
namespace {

struct Line {
  std::istringstream words;
  std::string where; // file and line, for messages

  [[noreturn]] void fail(const std::string& message) const {
    throw std::runtime_error(where + ": " + message);
  }
  double number(const char* what) {
    double value;
    if (!(words >> value) || !std::isfinite(value)) fail(std::string("a number is missing: ") + what);
    return value;
  }
  double positive(const char* what) {
    const double value = number(what);
    if (value <= 0) fail(std::string(what) + " must be greater than 0");
    return value;
  }
  Vec3 vector(const char* what) {
    const double x = number(what), y = number(what);
    return {x, y, number(what)};
  }
  bool word(std::string& out) { return bool(words >> out); }
};

spec::Light read_light(Line& line) {
  spec::Light light;
  const Vec3 p = line.vector("position of the light");
  light.position = {p.x, p.y, p.z, line.number("w of the light: 1, or 0 for a direction")};
  light.diffuse = light.specular = line.vector("color of the light");
  for (std::string word; line.word(word);) {
    if (word == "ambient")
      light.ambient = line.vector("ambient");
    else if (word == "specular")
      light.specular = line.vector("specular");
    else if (word == "attenuation") {
      const Vec3 k = line.vector("attenuation");
      light.constant_attenuation = k.x, light.linear_attenuation = k.y, light.quadratic_attenuation = k.z;
    } else if (word == "spot") {
      light.spot_direction = line.vector("direction of the spotlight");
      light.spot_cutoff = line.number("cut-off angle");
      light.spot_exponent = line.number("exponent of the spotlight");
    } else
      line.fail("a light has no '" + word + "'");
  }
  return light;
}

Material read_material(Line& line) {
  Material m;
  for (std::string word; line.word(word);) {
    if (word == "ambient")
      m.kAmbient = line.vector("ambient");
    else if (word == "diffuse")
      m.kDiffuse = line.vector("diffuse");
    else if (word == "specular")
      m.kSpecular = line.vector("specular");
    else if (word == "emission")
      m.kEmission = line.vector("emission");
    else if (word == "exponent")
      m.phongExponent = line.number("exponent");
    else
      line.fail("a material has no '" + word + "'");
  }
  return m;
}

// Rodrigues: v turned by an angle around a unit axis.
Vec3 turned(Vec3 v, Vec3 axis, double angle) {
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
}

std::unique_ptr<Shape> read_box(Line& line, const Material& material) {
  const Vec3 center = line.vector("centre of the box");
  Vec3 x{line.positive("half width"), 0, 0}, y{0, line.positive("half height"), 0},
      z{0, 0, line.positive("half depth")};
  for (std::string word; line.word(word);) {
    if (word != "turn") line.fail("a box has no '" + word + "'");
    const double angle = line.number("angle") * std::numbers::pi / 180;
    const Vec3 axis = spec::unit(line.vector("axis"));
    x = turned(x, axis, angle), y = turned(y, axis, angle), z = turned(z, axis, angle);
  }
  return std::make_unique<Box>(material, center, x, y, z);
}

// A Wavefront OBJ file: v, vn and f; a vertex without a normal gets the facet's.
std::unique_ptr<Shape> read_mesh(Line& line, const Material& material, const std::string& folder) {
  std::string file;
  if (!line.word(file)) line.fail("a mesh needs a file");
  Vec3 at{0, 0, 0};
  double scale = 1;
  for (std::string word; line.word(word);) {
    if (word == "at")
      at = line.vector("place of the mesh");
    else if (word == "scale")
      scale = line.positive("scale");
    else
      line.fail("a mesh has no '" + word + "'");
  }
  std::ifstream in(folder + file);
  if (!in) line.fail("cannot read " + folder + file);
  std::vector<Vec3> positions, normals;
  std::vector<TriangleMesh::Vertex> vertices;
  std::vector<int> indices;
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    Line row{std::istringstream(text), folder + file + ":" + std::to_string(++number)};
    std::string kind;
    if (!row.word(kind)) continue;
    if (kind == "v")
      positions.push_back(at + scale * row.vector("coordinate"));
    else if (kind == "vn")
      normals.push_back(spec::unit(row.vector("normal")));
    if (kind != "f") continue;
    const int first = int(vertices.size());
    bool complete = true;
    const auto pick = [&](const std::vector<Vec3>& from, const std::string& index) {
      const long i = std::atol(index.c_str()), k = i < 0 ? long(from.size()) + i : i - 1;
      if (k < 0 || k >= long(from.size())) row.fail("there is no number " + index);
      return from[size_t(k)];
    };
    for (std::string corner; row.word(corner);) {
      const size_t slash = corner.rfind('/');
      const bool has_normal = slash != std::string::npos && corner.find('/') != slash;
      complete &= has_normal;
      vertices.push_back(
          {pick(positions, corner), has_normal ? pick(normals, corner.substr(slash + 1)) : Vec3{}});
    }
    const int count = int(vertices.size()) - first;
    if (count < 3) row.fail("a face needs three corners");
    const auto corner = [&](int i) -> TriangleMesh::Vertex& { return vertices[size_t(first + i)]; };
    if (!complete) {
      const Vec3 facet =
          spec::unit(cross(corner(1).position - corner(0).position, corner(2).position - corner(0).position));
      for (int i = 0; i < count; i++) corner(i).normal = facet;
    }
    for (int i = 1; i + 1 < count; i++) indices.insert(indices.end(), {first, first + i, first + i + 1});
  }
  return std::make_unique<TriangleMesh>(material, std::move(vertices), std::move(indices));
}

void read_camera(Line& line, Camera& camera) {
  std::string kind;
  line.word(kind);
  camera.perspective = kind == "perspective";
  if (camera.perspective) {
    camera.field_of_view = line.positive("angle of view");
    if (camera.field_of_view >= 180) line.fail("the angle of view must be smaller than 180");
  } else if (kind == "orthographic")
    camera.half_height = line.positive("half height");
  else
    line.fail("a camera is perspective or orthographic");
}

} // namespace

Scene parse_scene(const std::string& text, const std::string& name) {
  Scene scene;
  Material material;
  Illumination& light = scene.illumination;
  const std::string folder = name.substr(0, name.rfind('/') + 1);
  std::istringstream lines(text);
  int number = 0;
  for (std::string content; std::getline(lines, content);) {
    Line line{std::istringstream(content.substr(0, content.find('#'))),
              name + ":" + std::to_string(++number)};
    std::string word;
    if (!line.word(word)) continue;
    if (word == "size") {
      const double width = line.positive("width"), height = line.positive("height");
      if (width > 16384 || height > 16384) line.fail("the picture is too large");
      scene.camera.width = int(width), scene.camera.height = int(height);
    } else if (word == "camera")
      read_camera(line, scene.camera);
    else if (word == "background")
      scene.background = line.vector("background");
    else if (word == "ambient")
      light.model.ambient = line.vector("ambient light");
    else if (word == "textbook")
      light.equation = Equation::Textbook;
    else if (word == "opengl")
      light.equation = Equation::OpenGL;
    else if (word == "reflection_vector")
      light.model.highlight = spec::Highlight::ReflectionVector;
    else if (word == "half_vector")
      light.model.highlight = spec::Highlight::HalfVector;
    else if (word == "local_viewer")
      light.model.local_viewer = true;
    else if (word == "two_sided")
      light.model.two_sided = true;
    else if (word == "without_test")
      light.tests_light_behind = false;
    else if (word == "shadows") {
      scene.shadows = true;
      scene.shadow_start = line.number("distance from the surface at which a ray to the light starts");
    } else if (word == "light")
      light.lights.push_back(read_light(line));
    else if (word == "material")
      material = read_material(line);
    else if (word == "sphere") {
      const Vec3 center = line.vector("centre of the sphere");
      scene.shapes.push_back(std::make_unique<Sphere>(material, center, line.positive("radius")));
    } else if (word == "plane") {
      const Vec3 point = line.vector("point of the plane"), normal = line.vector("normal of the plane");
      if (length(normal) == 0) line.fail("the normal of a plane must not be zero");
      scene.shapes.push_back(std::make_unique<Plane>(material, point, normal));
    } else if (word == "box")
      scene.shapes.push_back(read_box(line, material));
    else if (word == "mesh")
      scene.shapes.push_back(read_mesh(line, material, folder));
    else
      line.fail("unknown word '" + word + "'");
    if (line.word(word)) line.fail("'" + word + "' is too much");
  }
  return scene;
}

Scene read_scene(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << in.rdbuf();
  return parse_scene(text.str(), path);
}

const char* built_in_scene(const std::string& name) {
  if (name == "sphere")
    return "size 512 512\n"
           "camera perspective 40\n"
           "ambient 0.15 0.15 0.15\n"
           "light 4 4 2 1   1 1 1\n"
           "material ambient 0.8 0.2 0.2  diffuse 0.8 0.2 0.2  specular 0.7 0.7 0.7  exponent 40\n"
           "sphere 0 0 -4 1.2\n";
  if (name == "shapes")
    return "size 640 400\n"
           "camera perspective 45\n"
           "background 0.1 0.12 0.16\n"
           "ambient 0.2 0.2 0.22\n"
           "light -3 4 2 1   0.7 0.7 0.65\n"
           "light 1 1 1 0    0.3 0.3 0.4\n"
           "material ambient 0.6 0.6 0.6  diffuse 0.6 0.6 0.6  specular 0 0 0\n"
           "plane 0 -1 0  0 1 0\n"
           "material ambient 0.9 0.5 0.1  diffuse 0.9 0.5 0.1  specular 0.8 0.8 0.8  exponent 60\n"
           "sphere -1.1 -0.1 -5 0.9\n"
           "material ambient 0.2 0.5 0.8  diffuse 0.2 0.5 0.8  specular 0.3 0.3 0.3  exponent 12\n"
           "box 1.2 -0.3 -5.5  0.7 0.7 0.7  turn 35 0 1 0\n";
  if (name == "spots")
    return "size 640 400\n"
           "camera perspective 45\n"
           "opengl\n"
           "local_viewer\n"
           "ambient 0.1 0.1 0.1\n"
           "light -1.5 2 -3 1  1 0.4 0.3  spot 0.4 -1 -0.6 22 4\n"
           "light 0 2 -3 1     0.3 1 0.4  spot 0 -1 -0.6 22 4\n"
           "light 1.5 2 -3 1   0.4 0.5 1  spot -0.4 -1 -0.6 22 4  attenuation 0.6 0.1 0.02\n"
           "material ambient 0.7 0.7 0.7  diffuse 0.7 0.7 0.7  specular 0.5 0.5 0.5  exponent 30\n"
           "plane 0 -1 0  0 1 0\n"
           "sphere 0 -0.3 -4.6 0.7\n";
  return nullptr;
}

} // namespace softgl::raycast
