#version 120
// Materials that change from vertex to vertex (glMaterial between glBegin and glEnd): a shader cannot see them, so that the
// program gives them as attributes. Vertex shaders that light read them here; phong.vert, compiled with VERTEX_MATERIALS,
// passes them on to vertex_materials.frag.

attribute vec4 front_emission, front_ambient, front_diffuse, front_specular;
attribute vec4 back_emission, back_ambient, back_diffuse, back_specular;
attribute vec2 shininess; // front, back

varying vec4 front[4], back[4];
varying vec2 exponents;

struct Material {
  vec4 emission, ambient, diffuse, specular;
  float shininess;
};

Material given_front_material() { return Material(front_emission, front_ambient, front_diffuse, front_specular, shininess.x); }
Material given_back_material() { return Material(back_emission, back_ambient, back_diffuse, back_specular, shininess.y); }

void pass_materials() {
  front[0] = front_emission, front[1] = front_ambient, front[2] = front_diffuse, front[3] = front_specular;
  back[0] = back_emission, back[1] = back_ambient, back[2] = back_diffuse, back[3] = back_specular;
  exponents = shininess;
}
