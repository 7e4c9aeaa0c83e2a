#version 120
// Phong shading: normal, eye coordinates and colour go to the fragments, which are lit each by itself.

varying vec3 eye, normal;
varying vec4 color;

vec3 eye_normal();

void main() {
  vec4 position = gl_ModelViewMatrix * gl_Vertex;
  eye = position.xyz;
  normal = eye_normal();
  color = gl_Color;
  gl_Position = ftransform();
  gl_ClipVertex = position;
}
