// Primitives in window coordinates, with the colors that a correct implementation may give to their vertices.
#pragma once

#include "expect/expectation.h"
#include "expect/state.h"

namespace softgl::suite {

struct ColorBounds {
  Interval primary[4], secondary[3];
};

struct LitVertex {
  Vec3 window;
  double w = 1; // of clip coordinates
  Interval fog_distance;
  ColorBounds front, back;
  // Where fragments are lit (GL_WIN_phong_shading):
  spec::Vec3Interval eye, normal;
  spec::Material material[2]; // front, back
};

/// A vertex or fragment lit by the lights that are on (2.14.1), clamped (2.14.6).
ColorBounds lit_color(const LightingState& lighting, const spec::Material& material,
                      const spec::Vec3Interval& eye, const spec::Vec3Interval& normal);
/// Lighting takes place for each fragment of a polygon.
bool lights_fragments(const State& state);
/// The color of a fragment from the normal and eye coordinates that the weights give. Throws std::logic_error
/// if the material is not the same at all vertices.
ColorBounds lit_fragment(const State& state, const std::vector<LitVertex>& vertices, const double* weights,
                         bool back, bool unit_normals);

/// Draws into an expectation, with the state's operations on fragments.
class Rasterizer {
public:
  Rasterizer(Expectation& picture, const Precision& precision) : picture_(picture), precision_(precision) {}
  void clear(const State& state, GLbitfield mask);
  void polygon(const State& state, const std::vector<LitVertex>& vertices, int provoking);
  void line(const State& state, const LitVertex& a, const LitVertex& b, int provoking);
  void point(const State& state, const LitVertex& vertex);
  /// Fragments of a rectangle of pixels, of one color: a bitmap of ones.
  void rectangle(const State& state, int x, int y, int width, int height, const ColorBounds& color,
                 double depth);

private:
  struct Fragment {
    ColorBounds color;
    Interval depth, fog_distance;
    bool certain = true; // that it is there
    bool nominal = true; // it is there by the exact geometry
  };
  double slack() const; // how far a vertex may be from where the exact geometry has it, in pixels
  void fragment(const State& state, int x, int y, const Fragment& fragment);
  void process_color(const State& state, const Fragment& fragment, Interval color[4]) const;
  void polygon_fragment(const State& state, const std::vector<LitVertex>& vertices,
                        const std::vector<const ColorBounds*>& colors, bool back, int x, int y,
                        double inside);

  Expectation& picture_;
  const Precision& precision_;
};

} // namespace softgl::suite
