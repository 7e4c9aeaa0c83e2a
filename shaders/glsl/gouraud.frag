#version 120
// Gouraud shading: the colors are interpolated.

vec4 finish(vec4 primary, vec3 secondary);

void main() { gl_FragColor = finish(gl_Color, gl_SecondaryColor.rgb); }
