#version 120
// The lighting of fixed-function OpenGL (GL 1.5, 2.14.1) as a function, for a vertex shader (Gouraud shading) or a fragment
// shader (Phong shading): compile it as a second shader object of the same stage. Lights, light model and materials are
// those of glLight, glLightModel and glMaterial. What GLSL 1.20 does not show of the state comes as uniforms; all of them are
// 0 or false until they are set.

uniform bool light_enabled[8];   // glIsEnabled(GL_LIGHTi)
uniform bool local_viewer;       // GL_LIGHT_MODEL_LOCAL_VIEWER
uniform bool separate_specular;  // GL_LIGHT_MODEL_COLOR_CONTROL is GL_SEPARATE_SPECULAR_COLOR
uniform vec4 front_tracks, back_tracks; // 1 where the color replaces emission, ambient, diffuse, specular (glColorMaterial)

// Not in fixed-function OpenGL (softgl: GL_SOFTGL_phong_illumination):
uniform bool reflection_vector;  // highlights by Phong's (v.r)^s instead of OpenGL's (n.h)^s; set normalize_normal, too
uniform vec4 left_out;           // 1 leaves out the term: emission, ambient, diffuse, specular

struct Material {
  vec4 emission, ambient, diffuse, specular;
  float shininess;
};

// The zero vector has no direction and stays zero.
vec3 unit(vec3 v) {
  float length2 = dot(v, v);
  return length2 > 0.0 ? v * inversesqrt(length2) : vec3(0.0);
}

// The materials before they follow the color: materials.glsl or a file of vertex_materials.
Material given_front_material();
Material given_back_material();

// GL 1.5, 2.14.3.
Material track_color(Material m, vec4 tracks, vec4 color) {
  if (tracks.x != 0.0) m.emission = color;
  if (tracks.y != 0.0) m.ambient = color;
  if (tracks.z != 0.0) m.diffuse = color;
  if (tracks.w != 0.0) m.specular = color;
  return m;
}
Material front_material(vec4 color) { return track_color(given_front_material(), front_tracks, color); }
Material back_material(vec4 color) { return track_color(given_back_material(), back_tracks, color); }

// Distance attenuation and spotlight factor (equations 2.4 and 2.5); `to_light` has length 1.
float attenuation(int i, vec3 to_light, float distance) {
  float att = 1.0;
  if (gl_LightSource[i].position.w != 0.0)
    // Not infinite where the light itself is, so that black stays black there.
    att = min(1.0 / (gl_LightSource[i].constantAttenuation + gl_LightSource[i].linearAttenuation * distance +
                     gl_LightSource[i].quadraticAttenuation * distance * distance), 1e18);
  if (gl_LightSource[i].spotCutoff != 180.0) {
    float cosine = dot(-to_light, unit(gl_LightSource[i].spotDirection));
    // At the very edge, which is all of a cut-off of 0, equation 2.5 lights; fixed-function OSMesa does not.
    if (cosine <= gl_LightSource[i].spotCosCutoff) att = 0.0;
    else if (gl_LightSource[i].spotExponent != 0.0) att *= pow(max(cosine, 0.0), gl_LightSource[i].spotExponent);
  }
  return att;
}

// How bright the highlight is; nothing where the light is behind the surface or its reflection turned away. In GLSL pow(0, 0)
// is undefined; here everything to the power of zero is 1.
float highlight(vec3 normal, vec3 to_light, vec3 to_viewer, float shininess) {
  if (dot(normal, to_light) <= 0.0) return 0.0;
  float cosine;
  if (reflection_vector) {
    cosine = dot(to_viewer, 2.0 * dot(normal, to_light) * normal - to_light);
    if (cosine <= 0.0) return 0.0;
  } else {
    cosine = max(dot(normal, unit(to_light + to_viewer)), 0.0);
  }
  return shininess == 0.0 ? 1.0 : pow(cosine, shininess);
}

// The colors of a point at `eye` (eye coordinates). They are not clamped; the alpha is the diffuse one.
void light_point(Material m, vec3 eye, vec3 normal, out vec4 primary, out vec3 secondary) {
  vec4 wanted = vec4(1.0) - left_out;
  vec3 to_viewer = local_viewer ? unit(-eye) : vec3(0.0, 0.0, 1.0);
  primary = vec4(wanted.x * m.emission.rgb + wanted.y * (m.ambient.rgb * gl_LightModel.ambient.rgb), m.diffuse.a);
  secondary = vec3(0.0);
  for (int i = 0; i < 8; i++) {
    if (!light_enabled[i]) continue;
    vec4 position = gl_LightSource[i].position;
    vec3 way = position.w != 0.0 ? position.xyz / position.w - eye : position.xyz;
    vec3 to_light = unit(way);
    float att = attenuation(i, to_light, length(way));
    primary.rgb += wanted.y * att * (gl_LightSource[i].ambient.rgb * m.ambient.rgb);
    primary.rgb += wanted.z * att * max(dot(normal, to_light), 0.0) * (gl_LightSource[i].diffuse.rgb * m.diffuse.rgb);
    vec3 specular = wanted.w * att * highlight(normal, to_light, to_viewer, m.shininess) * (gl_LightSource[i].specular.rgb * m.specular.rgb);
    if (separate_specular) secondary += specular;
    else primary.rgb += specular;
  }
}
