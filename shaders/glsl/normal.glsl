#version 120
// The normal in eye coordinates (GL 1.5, 2.11.3), for vertex shaders.

uniform bool rescale_normal;   // GL_RESCALE_NORMAL
uniform bool normalize_normal; // GL_NORMALIZE

vec3 eye_normal() {
  vec3 normal = gl_NormalMatrix * gl_Normal;
  if (normalize_normal) return dot(normal, normal) > 0.0 ? normalize(normal) : vec3(0.0);
  return rescale_normal ? gl_NormalScale * normal : normal;
}
