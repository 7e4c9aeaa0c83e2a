#version 120
// What happens to the colors of a fragment behind the lighting: texture, color sum, fog (GL 1.5, 3.8 to 3.10). Lit colors
// are in [0,1] before that (2.14.6).

#ifdef TEXTURE
uniform sampler2D texels; // texture unit 0: GL_MODULATE by a texture with alpha
#endif
#ifdef FOG
uniform int fog_mode;     // GL_FOG_MODE
#endif

vec4 finish(vec4 primary, vec3 secondary) {
  vec4 color = clamp(primary, 0.0, 1.0);
#ifdef TEXTURE
  color *= texture2DProj(texels, gl_TexCoord[0]);
#endif
  color.rgb = clamp(color.rgb + clamp(secondary, 0.0, 1.0), 0.0, 1.0);
#ifdef FOG
  float c = gl_FogFragCoord, f;
  if (fog_mode == 0x2601) f = (gl_Fog.end - c) * gl_Fog.scale; // GL_LINEAR
  else if (fog_mode == 0x0800) f = exp(-gl_Fog.density * c);   // GL_EXP
  else f = exp(-gl_Fog.density * gl_Fog.density * c * c);      // GL_EXP2
  color.rgb = mix(gl_Fog.color.rgb, color.rgb, clamp(f, 0.0, 1.0));
#endif
  return color;
}
