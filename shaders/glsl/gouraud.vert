#version 120
// Gouraud shading: the vertex is lit, and its colors are interpolated. Enable GL_VERTEX_PROGRAM_TWO_SIDE where
// GL_LIGHT_MODEL_TWO_SIDE is.

struct Material {
  vec4 emission, ambient, diffuse, specular;
  float shininess;
};
Material front_material(vec4 color);
Material back_material(vec4 color);
void light_point(Material m, vec3 eye, vec3 normal, out vec4 primary, out vec3 secondary);
vec3 eye_normal();
vec4 place_vertex();

void main() {
  vec4 eye = place_vertex();
  vec3 normal = eye_normal(), secondary;
  light_point(front_material(gl_Color), eye.xyz, normal, gl_FrontColor, secondary);
  gl_FrontSecondaryColor = vec4(secondary, 1.0);
  light_point(back_material(gl_Color), eye.xyz, -normal, gl_BackColor, secondary);
  gl_BackSecondaryColor = vec4(secondary, 1.0);
}
