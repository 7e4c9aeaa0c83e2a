// What a ray can hit. A shape knows where a ray meets it first and what its surface is made of; nothing else.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "material.h"

namespace softgl::raycast {

/// A ray that starts on a surface does not hit it there: rounding must not let a surface meet itself.
constexpr double kNearestDistance = 1e-9;

/// Points origin + t * direction for t > nearest; the direction has length 1.
struct Ray {
  Vec3 origin, direction;
  double nearest = kNearestDistance;
  Vec3 at(double t) const { return origin + t * direction; }
};

/// Where a ray meets a shape.
struct Hit {
  double distance = 0;
  Vec3 point, normal; // the normal has length 1 and points outwards, also where the ray comes from inside
  bool from_behind = false; // the ray meets the side that the normal does not point to
  const Material* material = nullptr;
  int part = 0; // face of a box, triangle of a mesh
  Vec3 weights; // of the triangle's three vertices
};

class Shape {
public:
  explicit Shape(Material material) : material_(material) {}
  virtual ~Shape() = default;
  /// The nearest hit in front of the ray's origin.
  virtual std::optional<Hit> intersect(const Ray& ray) const = 0;

protected:
  Hit hit_at(const Ray& ray, double distance, Vec3 normal) const {
    return {distance, ray.at(distance), normal, dot(normal, ray.direction) > 0, &material_, 0, {}};
  }

private:
  Material material_;
};

class Sphere : public Shape {
public:
  Sphere(Material material, Vec3 center, double radius) : Shape(material), center_(center), radius_(radius) {}
  std::optional<Hit> intersect(const Ray& ray) const override;

private:
  Vec3 center_;
  double radius_;
};

/// All points p with (p - point) . normal = 0.
class Plane : public Shape {
public:
  Plane(Material material, Vec3 point, Vec3 normal)
      : Shape(material), point_(point), normal_(spec::unit(normal)) {}
  std::optional<Hit> intersect(const Ray& ray) const override;

private:
  Vec3 point_, normal_;
};

/// A box that may be turned: a centre and three half edges at right angles to each other.
class Box : public Shape {
public:
  Box(Material material, Vec3 center, Vec3 half_x, Vec3 half_y, Vec3 half_z)
      : Shape(material), center_(center), half_edge_{half_x, half_y, half_z} {}
  std::optional<Hit> intersect(const Ray& ray) const override;

private:
  Vec3 center_, half_edge_[3];
};

/// Triangles with a normal at each vertex; the normal of a hit is interpolated between them (Phong shading).
class TriangleMesh : public Shape {
public:
  struct Vertex {
    Vec3 position, normal;
  };
  /// Three indices a triangle. Its front is where its vertices run counter-clockwise.
  TriangleMesh(Material material, std::vector<Vertex> vertices, std::vector<int> indices);
  std::optional<Hit> intersect(const Ray& ray) const override;

private:
  // A tree of boxes around triangles: a ray that misses a box misses all that is in it.
  struct Node {
    Vec3 low, high;
    int first = 0, count = 0; // triangles of a leaf, in order_
    int right = 0;            // the second child of an inner node; the first one follows the node
  };
  void build(int first, int count);
  bool intersect_triangle(const Ray& ray, int triangle, Hit& nearest) const;

  std::vector<Vertex> vertices_;
  std::vector<int> indices_, order_;
  std::vector<Node> nodes_;
};

} // namespace softgl::raycast
