// The building blocks of random scenes: canvas, camera, state, primitives.
//
// The generator keeps clear of what reference/DEVIATIONS.md lists; each of its rows has a test of its own.
#pragma once

#include "support/scene.h"

namespace softgl::test {

/// Clears with random values; sometimes an odd viewport. The first call of every scene.
void random_canvas(Stage& s);

/// Loads a projection; returns true for a perspective one. Geometry that random_modelview places is in view.
bool random_projection(Stage& s);
/// Loads a modelview: none, rotation, scale, shear; moved into the view volume.
void random_modelview(Stage& s);
/// A rotation, translation and one positive scale at most (for what needs no general inverse).
void rigid_modelview(Stage& s);

void random_culling(Stage& s);
/// Depth test, function, mask and range; off in 100 - `percent` of a hundred cases.
void random_depth(Stage& s, int percent);
void random_scissor(Stage& s, int percent);
void random_blending(Stage& s);
void random_alpha_test(Stage& s);
void random_fog(Stage& s);

/// How images of at most 36 pixels a row lie in memory.
void random_unpacking(Stage& s);

/// Where the vertices of a primitive lie.
enum class Spread { Any, View, Tiny, Sliver, Grid, Huge, Beyond };

struct PrimitiveOptions {
  GLenum mode = GL_TRIANGLES;
  int primitives = 0; // 0: random
  Spread spread = Spread::Any;
  bool colors = true, normals = false, secondary_colors = false, fog_coordinates = false;
  int texture_coordinates = 0; // 0 none, 1 .. 4 components
  float texture_scale = 2;
  bool planar = false;          // z = 0
  bool materials = false;       // glMaterial between Begin and End
  bool front_materials = false; // ... of the front face only
};

/// How many vertices `n` primitives of a mode need.
int vertices_of(GLenum mode, int n);
/// One Begin/End pair. GL_QUADS are drawn flat.
void random_primitive(Stage& s, const PrimitiveOptions& options);
/// The positions of `count` vertices of a mode.
std::vector<Float4> random_positions(Stage& s, GLenum mode, int count, Spread spread, bool planar);
/// A primitive of random colors that fills the whole window: something to blend with.
void backdrop(Stage& s);
/// A sphere with normals as strips: curved surfaces show lighting.
void sphere(Stage& s, int slices, int stacks, float radius, bool texture_coordinates);

/// Numbers that were read from signed texels. OSMesa reads the lowest integer as less than -1
/// (reference/DEVIATIONS.md).
void clamp_at_minus_one(std::vector<uint8_t>& pixels, GLenum type);

GLenum random_filled_mode(Stage& s);
GLenum random_compare(Stage& s);

/// The seed-independent reset of everything that a part of a scene may have set, except matrices.
void reset_state(Stage& s);

} // namespace softgl::test
