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
  double point_size = 1; // with the distance in it (3.3)
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

/// The factor of fog at a distance (3.10), clamped.
Interval fog_factor(const FogState& fog, Interval distance);

/// What comes of a test of fragments, if rounding may change it.
enum class Passes { No, Perhaps, Yes };

/// Fragments that an occlusion query may have counted.
struct FragmentCount {
  int low = 0, high = 0;
};

/// Draws into an expectation, with the state's operations on fragments.
class Rasterizer {
public:
  Rasterizer(Expectation& picture, const Precision& precision) : picture_(picture), precision_(precision) {}
  void clear(const State& state, GLbitfield mask);
  void accumulate(const State& state, GLenum operation, double value); // 4.2.4
  // What is drawn is clipped, and of one color if it is flat.
  void polygon(const State& state, const std::vector<LitVertex>& vertices);
  /// `along`: fragments of the same strip before this line, which its stipple has counted. `offset`: of
  /// depths.
  void line(const State& state, const LitVertex& a, const LitVertex& b, Interval along = 0,
            Interval offset = 0);
  /// The fragments of a line, which a stipple counts; one more or less is right.
  static double fragments_of(const LitVertex& a, const LitVertex& b);
  void point(const State& state, const LitVertex& vertex, Interval offset = 0);
  /// A fragment of a bitmap or an image: the color and texture coordinates of the raster position.
  void pixel(const State& state, int x, int y, const LitVertex& at, Interval depth);
  /// A pixel of an image of stencil values: no fragment, so only scissor box and mask matter (4.3.1).
  void stencil(const State& state, int x, int y, int value);
  /// What 4.3.2 reads.
  PixelImage read(int x, int y, int width, int height, PixelKind kind) const;
  /// A square of one color, whatever the state is.
  void paint(int x, int y, int size, const Interval color[4]);
  int width() const { return picture_.width; }
  int height() const { return picture_.height; }
  FragmentCount passed; // of the depth test, since it was set to 0

private:
  struct Fragment {
    ColorBounds color;
    Interval depth, fog = 1, coverage = 1; // fog: the factor
    std::array<TexturePoint, kTextureUnits> texture;
    size_t depth_source = 0; // see Answer
    Interval depth_offset;
    bool certain = true; // that it is there
    bool nominal = true; // it is there by the exact geometry
  };
  double slack() const;        // how far a vertex may be from where the exact geometry has it, in pixels
  double step_of(int c) const; // half a step of the framebuffer
  Passes fragment(const State& state, int x, int y, const Fragment& fragment);
  static void add_answer(std::vector<Answer>& answers, const Answer& answer);
  void write_color(const ColorBufferState& buffer, const Interval drawn[4], const Answer& before,
                   Answer& after) const;
  void apply_textures(const State& state, const Fragment& fragment, Interval color[4]) const;
  void process_color(const State& state, const Fragment& fragment, Interval color[4]) const;
  struct Polygon;
  Interval polygon_offset(const State& state, bool back, const std::vector<LitVertex>& vertices) const;
  void polygon_outline(const State& state, std::vector<LitVertex> vertices, bool back);
  void polygon_fragment(const State& state, const Polygon& polygon, int x, int y, Fragment f);
  void smooth_point(const State& state, const LitVertex& vertex, Fragment f);
  Witness line_witness(const State& state, const Interval color[4], double minor, int major, bool x_major,
                       int width) const;
  bool writes_colors(const State& state) const;
  void add_witness(Witness& witness);

  Expectation& picture_;
  const Precision& precision_;
  std::vector<Answer> answers_; // memory for a pixel's new ones
};

} // namespace softgl::suite
