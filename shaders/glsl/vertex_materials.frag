#version 120
// The interpolated materials of the vertices, for phong.frag.

varying vec4 front[4], back[4];
varying vec2 exponents;

struct Material {
  vec4 emission, ambient, diffuse, specular;
  float shininess;
};

Material given_front_material() { return Material(front[0], front[1], front[2], front[3], exponents.x); }
Material given_back_material() { return Material(back[0], back[1], back[2], back[3], exponents.y); }
