// Primitives in window coordinates, with the colors that a correct implementation may give to their vertices.
#pragma once

#include <array>

#include "expect/expectation.h"
#include "expect/state.h"

namespace softgl::suite {

struct ColorBounds {
  Interval primary[4], secondary[3];
};

struct LitVertex {
  Vec4 eye4, clip;      // coordinates of the eye, of clipping
  Vec3 window;          // behind clipping
  double w = 1;         // of clip coordinates
  bool boundary = true; // the edge to the next vertex of a polygon is drawn (2.6.2)
  Interval fog_distance;
  ColorBounds front, back;
  // Where fragments are lit (GL_WIN_phong_shading):
  spec::Vec3Interval eye, normal;
  spec::Material material[2];              // front, back
  std::array<Vec4, kTextureUnits> texture; // coordinates
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
  // What is drawn is clipped, and of one color if it is flat.
  void polygon(const State& state, const std::vector<LitVertex>& vertices);
  void line(const State& state, const LitVertex& a, const LitVertex& b);
  void point(const State& state, const LitVertex& vertex);
  /// A fragment of a bitmap or an image: the color and texture coordinates of the raster position.
  void pixel(const State& state, int x, int y, const LitVertex& at, Interval depth);
  /// What 4.3.2 reads.
  PixelImage read(int x, int y, int width, int height, PixelKind kind) const;
  /// A square of one color, whatever the state is.
  void paint(int x, int y, int size, const Interval color[4]);
  int width() const { return picture_.width; }
  int height() const { return picture_.height; }

private:
  struct Fragment {
    ColorBounds color;
    Interval depth, fog_distance;
    std::array<TexturePoint, kTextureUnits> texture;
    bool certain = true; // that it is there
    bool nominal = true; // it is there by the exact geometry
  };
  double slack() const; // how far a vertex may be from where the exact geometry has it, in pixels
  void fragment(const State& state, int x, int y, const Fragment& fragment);
  void apply_textures(const State& state, const Fragment& fragment, Interval color[4]) const;
  void process_color(const State& state, const Fragment& fragment, Interval color[4]) const;
  void polygon_outline(const State& state, std::vector<LitVertex> vertices, bool back);
  void polygon_fragment(const State& state, const std::vector<LitVertex>& vertices,
                        const std::vector<const ColorBounds*>& colors, bool back, int x, int y,
                        double inside);

  Expectation& picture_;
  const Precision& precision_;
};

} // namespace softgl::suite
