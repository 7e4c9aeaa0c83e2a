#include "figure/exact_shapes.h"

#include "common/trigonometry.h"
#include "mesh/tessellation.h"

namespace softgl::cli {
namespace {

// Everything is in eye coordinates; the plane leans towards the viewer, so that its horizon is above the
// picture.
constexpr double kFieldOfView = 40, kRadius = 0.9;
constexpr Vec3 kPlanePoint = {0, -0.7, -6}, kLight = {-0.5, 0.8, 0.7};
constexpr double kPlaneSize = 40;

struct Surface {
  Vec3 color;
  double specular, exponent;
};
constexpr Surface kFloor = {{0.55, 0.55, 0.5}, 0.0, 1}, kBall = {{0.8, 0.35, 0.15}, 0.6, 40},
                  kBlock = {{0.2, 0.45, 0.7}, 0.3, 12};

raycast::Material for_rays(const Surface& surface) {
  const double s = surface.specular;
  return {surface.color, surface.color, {s, s, s}, surface.exponent, {}};
}

Material for_gl(const Surface& surface) {
  Material material;
  const double color[3] = {surface.color.x, surface.color.y, surface.color.z};
  for (size_t i = 0; i < 3; ++i) {
    material.ambient[i] = material.diffuse[i] = float(color[i]);
    material.specular[i] = float(surface.specular);
  }
  material.shininess = float(surface.exponent);
  return material;
}

void append(GrowingArray<float>& values, Vec3 v) {
  for (const double value : {v.x, v.y, v.z}) values.append(float(value));
}

// A parallelogram from its middle and half of two edges, counter-clockwise around the normal.
void append_face(Mesh& mesh, Vec3 middle, Vec3 a, Vec3 b) {
  const auto first = uint32_t(mesh.positions.size() / 3);
  for (const Vec3 corner : {middle - a - b, middle + a - b, middle + a + b, middle - a + b}) {
    append(mesh.positions, corner);
    append(mesh.normals, spec::unit(spec::cross(a, b)));
  }
  for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.triangles.append(first + i);
}

void close_batch(Mesh& mesh, uint32_t material) {
  const uint32_t first = mesh.triangle_batches.empty()
                             ? 0
                             : mesh.triangle_batches.back().first + mesh.triangle_batches.back().count;
  mesh.triangle_batches.push_back({material, first, uint32_t(mesh.triangles.size()) - first});
}

} // namespace

ExactShapes::ExactShapes() {
  up_ = {0, 0.8, 0.6};
  const Vec3 right{1, 0, 0}, back = spec::cross(right, up_);
  const double turn = 30, size = 0.62;
  half_[0] = size * (cosine(turn) * right + sine(turn) * back);
  half_[1] = size * up_;
  half_[2] = spec::cross(half_[0], up_);
  sphere_center_ = kPlanePoint - 0.95 * right + kRadius * up_;
  box_center_ = kPlanePoint + 1.05 * right + size * up_ + 0.2 * back;
}

Picture ExactShapes::ray_cast(const RenderOptions& options) const {
  raycast::Scene scene;
  scene.camera.width = options.width;
  scene.camera.height = options.height;
  scene.camera.field_of_view = kFieldOfView;
  const uint8_t* background = options.background.color;
  scene.background = {background[0] / 255.0, background[1] / 255.0, background[2] / 255.0};
  raycast::Illumination& illumination = scene.illumination;
  illumination.equation = raycast::Equation::OpenGL;
  const float* ambient = options.lighting.ambient;
  illumination.model.ambient = {double(ambient[0]), double(ambient[1]), double(ambient[2])};
  spec::Light& light = illumination.lights.emplace_back();
  light.position = {kLight.x, kLight.y, kLight.z, 0};
  light.diffuse = light.specular = {0.8, 0.8, 0.8};
  scene.shapes.push_back(std::make_unique<raycast::Plane>(for_rays(kFloor), kPlanePoint, up_));
  scene.shapes.push_back(std::make_unique<raycast::Sphere>(for_rays(kBall), sphere_center_, kRadius));
  scene.shapes.push_back(
      std::make_unique<raycast::Box>(for_rays(kBlock), box_center_, half_[0], half_[1], half_[2]));
  return ray_cast_picture(scene);
}

Picture ExactShapes::triangles(const RenderOptions& options, int slices) const {
  Mesh mesh = sphere_mesh(slices);
  mesh.triangle_batches.clear();
  const double center[3] = {sphere_center_.x, sphere_center_.y, sphere_center_.z};
  for (size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] = float(center[i % 3] + kRadius * double(mesh.normals[i]));
  close_batch(mesh, 1);
  append_face(mesh, kPlanePoint, {kPlaneSize, 0, 0}, kPlaneSize * spec::cross(up_, {1, 0, 0}));
  close_batch(mesh, 0);
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 out = half_[axis], a = half_[(axis + 1) % 3], b = half_[(axis + 2) % 3];
    append_face(mesh, box_center_ + out, a, b);
    append_face(mesh, box_center_ - out, b, a);
  }
  close_batch(mesh, 2);

  Camera camera{};
  for (int i = 0; i < 4; ++i) camera.view[5 * i] = 1;
  const double scale = 1 / tangent(kFieldOfView / 2), near = 1, far = 100;
  camera.projection[0] = scale * options.height / options.width;
  camera.projection[5] = scale;
  camera.projection[10] = (far + near) / (near - far);
  camera.projection[11] = -1;
  camera.projection[14] = 2 * far * near / (near - far);
  camera.eye[2] = 1;
  RenderOptions chosen = options;
  chosen.lighting.shading = Shading::kPhong;
  chosen.lighting.reflection_vector = false;
  LightOptions light;
  light.kind = LightOptions::kDirection;
  light.value[0] = kLight.x, light.value[1] = kLight.y, light.value[2] = kLight.z;
  chosen.lighting.lights = {light};
  const std::vector<Material> materials = {for_gl(kFloor), for_gl(kBall), for_gl(kBlock)};
  const ModelFrame frame;
  Warnings none;
  return MeshRenderer(mesh, materials, frame).draw(camera, chosen, none).picture;
}

} // namespace softgl::cli
