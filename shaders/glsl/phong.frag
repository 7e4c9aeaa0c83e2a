#version 120
// Phong shading: the lighting of a fragment.

uniform bool two_sided; // GL_LIGHT_MODEL_TWO_SIDE

varying vec3 eye, normal;
varying vec4 color;

struct Material {
  vec4 emission, ambient, diffuse, specular;
  float shininess;
};
Material front_material(vec4 color);
Material back_material(vec4 color);
void light_point(Material m, vec3 eye, vec3 normal, out vec4 primary, out vec3 secondary);
vec3 unit(vec3 v);
vec4 finish(vec4 primary, vec3 secondary);

void main() {
  vec4 primary;
  vec3 secondary;
  vec3 n = unit(normal); // interpolation makes it shorter
  if (two_sided && !gl_FrontFacing) light_point(back_material(color), eye, -n, primary, secondary);
  else light_point(front_material(color), eye, n, primary, secondary);
  gl_FragColor = finish(primary, secondary);
}
