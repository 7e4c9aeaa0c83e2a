#version 120
// Materials that are the same all over a primitive, for the stage that lights.

struct Material {
  vec4 emission, ambient, diffuse, specular;
  float shininess;
};

Material given_front_material() {
  return Material(gl_FrontMaterial.emission, gl_FrontMaterial.ambient, gl_FrontMaterial.diffuse, gl_FrontMaterial.specular, gl_FrontMaterial.shininess);
}
Material given_back_material() {
  return Material(gl_BackMaterial.emission, gl_BackMaterial.ambient, gl_BackMaterial.diffuse, gl_BackMaterial.specular, gl_BackMaterial.shininess);
}
