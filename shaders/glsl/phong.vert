#version 120
// Phong shading: normal, eye coordinates and color go to the fragments, which are lit each by itself.

varying vec3 eye, normal;
varying vec4 color;

vec4 place_vertex();
vec3 eye_normal();
#ifdef VERTEX_MATERIALS
void pass_materials();
#endif

void main() {
  eye = place_vertex().xyz;
  normal = eye_normal();
  color = gl_Color;
#ifdef VERTEX_MATERIALS
  pass_materials();
#endif
}
