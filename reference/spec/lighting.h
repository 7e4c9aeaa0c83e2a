// The lighting of OpenGL 1.5 in double precision, one function for each formula, in the specification's words
// and order; and beside GL's half vector the reflection vector of Phong's own equation
// (reference/extensions/SOFTGL_phong_illumination.txt). Everything is in eye coordinates.
//
// This is what softgl's kernels are measured against. It is written to be compared with the specification
// line by line, not to be fast.
#pragma once

#include <cstdint>
#include <span>

#include "vectors.h"

namespace softgl::spec {

/// Table 2.10, light source parameters, with their initial values (of lights other than light 0).
struct Light {
  Vec3 ambient{0, 0, 0}, diffuse{0, 0, 0}, specular{0, 0, 0}; // a_cli, d_cli, s_cli
  Vec4 position{0, 0, 1, 0};                                  // P_pli
  Vec3 spot_direction{0, 0, -1};                              // s_dli
  double spot_exponent = 0;                                   // s_rli, 0 to 128
  double spot_cutoff = 180; // c_rli in degrees, 0 to 90, or 180: no spotlight
  double constant_attenuation = 1, linear_attenuation = 0, quadratic_attenuation = 0; // k_0i, k_1i, k_2i
};

/// Table 2.10, material parameters.
struct Material {
  Vec4 ambient{0.2, 0.2, 0.2, 1}, diffuse{0.8, 0.8, 0.8, 1}, specular{0, 0, 0, 1},
      emission{0, 0, 0, 1}; // a_cm, d_cm, s_cm, e_cm
  double shininess = 0;     // s_rm, 0 to 128
};

/// What a highlight is measured with: the angle between the normal and the half vector (OpenGL), or between
/// the viewer and the reflected light (Phong's own equation).
enum class Highlight { HalfVector, ReflectionVector };

/// Which terms of the sum are computed; a picture of each one alone adds up to the whole.
struct Terms {
  bool emission = true, ambient = true, diffuse = true, specular = true;
};

/// Table 2.10, lighting model parameters, and the two choices that softgl adds.
struct LightModel {
  Vec3 ambient{0.2, 0.2, 0.2};    // a_cs
  bool local_viewer = false;      // v_bs
  bool separate_specular = false; // c_es = SEPARATE_SPECULAR_COLOR
  bool two_sided = false;         // t_bs
  Highlight highlight = Highlight::HalfVector;
  Terms terms;
};

struct LitColor {
  Vec4 primary{0, 0, 0, 1};
  Vec3 secondary{0, 0, 0};
};

// 2.11.3 Normal transformation

/// The normal in eye coordinates: n M^-1 by the upper 3x3 part, rescaled, normalized. A singular matrix gives
/// zero.
Vec3 transform_normal(const Matrix4& modelview, Vec3 normal, bool rescale_normal, bool normalize);

// 2.14.1 Lighting

/// The unit vector from one homogeneous point to another.
Vec3 direction_between(Vec4 from, Vec4 to);
/// att_i, equation 2.4.
double distance_attenuation(const Light& light, Vec4 vertex);
/// spot_i, equation 2.5.
double spotlight(const Light& light, Vec4 vertex);
/// The unit vector from the vertex to the viewer: to the eye, or along +z to a viewer at infinity.
Vec3 towards_viewer(const LightModel& model, Vec4 vertex);
/// h_i of equation 2.3, of unit length.
Vec3 half_vector(Vec3 towards_light, Vec3 towards_viewer);
/// The direction in which a mirror with this unit normal would send the light.
Vec3 reflection_vector(Vec3 towards_light, Vec3 normal);
/// (n . h)^s or (v . r)^s; 0 where the light is behind the surface (f_i, equation 2.2), and where the viewer
/// does not see the reflection (v . r <= 0).
double highlight(Highlight kind, Vec3 normal, Vec3 towards_light, Vec3 towards_viewer, double shininess);
/// c_pri and c_sec. Lights that are not enabled are left out of `lights`. With the reflection vector the
/// normal is normalized.
LitColor light_vertex(const LightModel& model, std::span<const Light> lights, const Material& material,
                      Vec4 vertex, Vec3 normal);
/// Twice the signed area of a polygon in window coordinates, equation 2.6; the third coordinate is not used.
double twice_signed_area(std::span<const Vec3> window);
/// True where the back color is selected: light_vertex with the back material and -n.
bool faces_back(double area, bool front_face_is_clockwise);

// 2.14.3 ColorMaterial

enum class TrackedColor { Emission, Ambient, Diffuse, Specular, AmbientAndDiffuse };
/// The material whose tracked parameters are the current color.
Material track_color(Material material, TrackedColor parameters, Vec4 color);

// 2.14.6 Clamping, 2.14.9 Final color processing, 3.9 Color sum

LitColor clamped(const LitColor& color);
/// The color of an untextured fragment: primary + secondary, clamped.
Vec4 color_sum(const LitColor& color);
/// A component in [0, 1] rounded to 8 bits.
uint8_t to_fixed_point(double component);

} // namespace softgl::spec
