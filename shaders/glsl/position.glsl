#version 120
// Where a vertex is, and the coordinates of texture and fog, for vertex shaders.

uniform bool fog_from_coordinate; // GL_FOG_COORDINATE_SOURCE is GL_FOG_COORDINATE

// Returns the eye coordinates.
vec4 place_vertex() {
  vec4 eye = gl_ModelViewMatrix * gl_Vertex;
  gl_Position = ftransform();
  gl_ClipVertex = eye;
#ifdef TEXTURE
  gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
#endif
#ifdef FOG
  gl_FogFragCoord = abs(fog_from_coordinate ? gl_FogCoord : eye.z);
#endif
  return eye;
}
