#version 120
// The colour sum of Gouraud shading; a texture would be multiplied in between.

void main() { gl_FragColor = vec4(gl_Color.rgb + gl_SecondaryColor.rgb, gl_Color.a); }
