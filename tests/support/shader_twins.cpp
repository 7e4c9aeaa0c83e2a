#include "support/shader_twins.h"
#include "test_paths.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace softgl::test {
namespace {

// OpenGL 2.1, as far as it is needed.
struct Gl2 {
// clang-format off
#define GL2_FUNCTION(name) decltype(&::gl##name) name = nullptr;
#define GL2_FUNCTIONS \
  GL2_FUNCTION(CreateShader) GL2_FUNCTION(ShaderSource) GL2_FUNCTION(CompileShader) GL2_FUNCTION(GetShaderiv) GL2_FUNCTION(GetShaderInfoLog) \
  GL2_FUNCTION(CreateProgram) GL2_FUNCTION(AttachShader) GL2_FUNCTION(LinkProgram) GL2_FUNCTION(GetProgramiv) GL2_FUNCTION(GetProgramInfoLog) \
  GL2_FUNCTION(UseProgram) GL2_FUNCTION(GetUniformLocation) GL2_FUNCTION(Uniform1i) GL2_FUNCTION(Uniform1iv) GL2_FUNCTION(Uniform4fv) \
  GL2_FUNCTION(BindAttribLocation) GL2_FUNCTION(VertexAttrib4fv)
  GL2_FUNCTIONS
#undef GL2_FUNCTION
  // clang-format on
};

Gl real; // the library underneath
Gl2 gl2;

// What makes a program another one.
struct Variant {
  bool phong = false;
  bool vertex_materials = false; // for primitives from glBegin, which glMaterial may change
  bool texture = false, fog = false;
};

// What the current context has been told.
struct Context {
  Twins twins = Twins::Phong;
  bool phong = false, reflection = false, inside = false; // glBegin
  GLint terms = GL_ALL_TERM_BITS_SOFTGL;
  GLuint programs[2][2][2][2] = {}; // by variant, once they have been needed
  GLfloat shininess[4] = {};        // front, back
} context;

// Attributes 1 to 9.
const char* const kMaterialAttributes[9] = {"front_emission", "front_ambient", "front_diffuse",
                                            "front_specular", "back_emission", "back_ambient",
                                            "back_diffuse",   "back_specular", "shininess"};
constexpr GLenum kColors[4] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR};

GLuint compile(GLenum stage, const std::string& file, const std::string& defines) {
  const std::string path = std::string(SOFTGL_TEST_SOURCE_DIR "/shaders/glsl/") + file;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << in.rdbuf();
  std::string source = text.str();
  source.insert(source.find('\n') + 1, defines); // behind the #version line
  const char* pointer = source.c_str();
  const GLuint shader = gl2.CreateShader(stage);
  gl2.ShaderSource(shader, 1, &pointer, nullptr);
  gl2.CompileShader(shader);
  GLint ok = 0;
  gl2.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  char log[2000] = "";
  if (!ok)
    gl2.GetShaderInfoLog(shader, sizeof log, nullptr, log), throw std::runtime_error(path + ": " + log);
  return shader;
}

GLuint link(const Variant& v) {
  std::vector<std::string> vertex = {"position.glsl", "normal.glsl"}, fragment = {"finish.glsl"};
  std::vector<std::string>& lighting = v.phong ? fragment : vertex;
  vertex.push_back(v.phong ? "phong.vert" : "gouraud.vert"),
      fragment.push_back(v.phong ? "phong.frag" : "gouraud.frag");
  lighting.push_back("lighting.glsl");
  if (!v.vertex_materials)
    lighting.push_back("materials.glsl");
  else
    vertex.push_back("vertex_materials.vert");
  if (v.vertex_materials && v.phong) fragment.push_back("vertex_materials.frag");
  const std::string defines = std::string(v.vertex_materials ? "#define VERTEX_MATERIALS\n" : "") +
                              (v.texture ? "#define TEXTURE\n" : "") + (v.fog ? "#define FOG\n" : "");

  const GLuint program = gl2.CreateProgram();
  for (const std::string& file : vertex) gl2.AttachShader(program, compile(GL_VERTEX_SHADER, file, defines));
  for (const std::string& file : fragment)
    gl2.AttachShader(program, compile(GL_FRAGMENT_SHADER, file, defines));
  for (GLuint i = 0; i < 9; i++) gl2.BindAttribLocation(program, i + 1, kMaterialAttributes[i]);
  gl2.LinkProgram(program);
  GLint ok = 0;
  gl2.GetProgramiv(program, GL_LINK_STATUS, &ok);
  char log[2000] = "";
  if (!ok)
    gl2.GetProgramInfoLog(program, sizeof log, nullptr, log),
        throw std::runtime_error(std::string("shaders/glsl does not link: ") + log);
  return program;
}

// Which of emission, ambient, diffuse, specular follow the color on a face.
void set_tracked(GLuint program, const char* name, GLenum face) {
  GLint tracking_face = 0, parameter = 0;
  real.GetIntegerv(GL_COLOR_MATERIAL_FACE, &tracking_face);
  real.GetIntegerv(GL_COLOR_MATERIAL_PARAMETER, &parameter);
  const bool on = real.IsEnabled(GL_COLOR_MATERIAL) &&
                  (GLenum(tracking_face) == face || tracking_face == GL_FRONT_AND_BACK);
  const bool both = parameter == GL_AMBIENT_AND_DIFFUSE;
  const GLfloat tracks[4] = {
      GLfloat(on && parameter == GL_EMISSION), GLfloat(on && (both || parameter == GL_AMBIENT)),
      GLfloat(on && (both || parameter == GL_DIFFUSE)), GLfloat(on && parameter == GL_SPECULAR)};
  gl2.Uniform4fv(gl2.GetUniformLocation(program, name), 1, tracks);
}

// The part of the state that shaders do not see by themselves.
void set_uniforms(GLuint program) {
  const auto set = [&](const char* name, bool value) {
    gl2.Uniform1i(gl2.GetUniformLocation(program, name), value);
  };
  const auto integer = [&](GLenum name) {
    GLint value = 0;
    real.GetIntegerv(name, &value);
    return value;
  };
  GLint enabled[8];
  for (int i = 0; i < 8; i++) enabled[i] = real.IsEnabled(GL_LIGHT0 + GLenum(i));
  gl2.Uniform1iv(gl2.GetUniformLocation(program, "light_enabled"), 8, enabled);
  set("local_viewer", integer(GL_LIGHT_MODEL_LOCAL_VIEWER));
  set("two_sided", integer(GL_LIGHT_MODEL_TWO_SIDE));
  set("separate_specular", integer(GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR);
  set("rescale_normal", real.IsEnabled(GL_RESCALE_NORMAL));
  set("normalize_normal", real.IsEnabled(GL_NORMALIZE) || context.reflection);
  set_tracked(program, "front_tracks", GL_FRONT);
  set_tracked(program, "back_tracks", GL_BACK);
  set("reflection_vector", context.reflection);
  GLfloat left_out[4];
  const GLint bits[4] = {GL_EMISSION_TERM_BIT_SOFTGL, GL_AMBIENT_TERM_BIT_SOFTGL, GL_DIFFUSE_TERM_BIT_SOFTGL,
                         GL_SPECULAR_TERM_BIT_SOFTGL};
  for (int i = 0; i < 4; i++) left_out[i] = context.terms & bits[i] ? 0.0f : 1.0f;
  gl2.Uniform4fv(gl2.GetUniformLocation(program, "left_out"), 1, left_out);
  set("fog_from_coordinate", integer(GL_FOG_COORDINATE_SOURCE) == GL_FOG_COORDINATE);
  gl2.Uniform1i(gl2.GetUniformLocation(program, "fog_mode"), integer(GL_FOG_MODE));
}

// Before each primitive: the right program with the right uniforms.
void prepare(bool vertex_materials) {
  Variant v{context.phong, vertex_materials, bool(real.IsEnabled(GL_TEXTURE_2D)),
            bool(real.IsEnabled(GL_FOG))};
  if (!real.IsEnabled(GL_LIGHTING) || !(v.phong || context.twins == Twins::PhongAndGouraud))
    return gl2.UseProgram(0);
  GLuint& program = context.programs[v.phong][v.vertex_materials][v.texture][v.fog];
  if (!program) program = link(v);
  gl2.UseProgram(program);
  set_uniforms(program);
  if (v.phong) return;
  GLint two_sided = 0;
  real.GetIntegerv(GL_LIGHT_MODEL_TWO_SIDE, &two_sided);
  (two_sided ? real.Enable : real.Disable)(GL_VERTEX_PROGRAM_TWO_SIDE);
}

// The attributes that stand for a face's (0, 1) material.
void set_material(int face, GLenum parameter, const GLfloat* value) {
  if (parameter == GL_SHININESS) {
    context.shininess[face] = value[0];
    gl2.VertexAttrib4fv(9, context.shininess);
  }
  for (GLuint i = 0; i < 4; i++)
    if (parameter == kColors[i] || (parameter == GL_AMBIENT_AND_DIFFUSE && (i == 1 || i == 2)))
      gl2.VertexAttrib4fv(1 + 4 * GLuint(face) + i, value);
}

void set_all_materials() {
  for (int face = 0; face < 2; face++)
    for (GLenum parameter : {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_SHININESS}) {
      GLfloat value[4] = {};
      real.GetMaterialfv(face ? GL_BACK : GL_FRONT, parameter, value);
      set_material(face, parameter, value);
    }
}

void materialfv(GLenum face, GLenum parameter, const GLfloat* value) {
  real.Materialfv(face, parameter, value);
  if (!context.inside) return;
  if (face != GL_BACK) set_material(0, parameter, value);
  if (face != GL_FRONT) set_material(1, parameter, value);
}
void materialf(GLenum face, GLenum parameter, GLfloat value) { materialfv(face, parameter, &value); }

// What shaders draw is shaded smoothly, whatever was selected before.
void shade_model(GLenum mode) {
  context.phong = mode == GL_PHONG_WIN;
  real.ShadeModel(context.phong ? GLenum(GL_SMOOTH) : mode);
}

void light_model(GLenum name, GLint value) {
  if (name == GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL)
    context.reflection = value == GL_REFLECTION_VECTOR_SOFTGL;
  else if (name == GL_LIGHT_MODEL_TERMS_SOFTGL)
    context.terms = value;
  else
    real.LightModeli(name, value);
}

void get_integerv(GLenum name, GLint* value) {
  real.GetIntegerv(name, value);
  if (name == GL_SHADE_MODEL && context.phong) *value = GL_PHONG_WIN;
}

void begin(GLenum mode) {
  prepare(true);
  set_all_materials();
  context.inside = true;
  real.Begin(mode);
}
void end() { context.inside = false, real.End(); }
void draw_arrays(GLenum mode, GLint first, GLsizei count) {
  prepare(false), real.DrawArrays(mode, first, count);
}
void draw_elements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
  prepare(false), real.DrawElements(mode, count, type, indices);
}

template <Twins kTwins>
GLboolean make_current(void* c, void* buffer, GLenum type, GLsizei width, GLsizei height) {
  const GLboolean ok = real.OSMesaMakeCurrent(c, buffer, type, width, height);
  context = {};
  context.twins = kTwins;
#define GL2_FUNCTION(name) \
  gl2.name = reinterpret_cast<decltype(gl2.name)>(real.OSMesaGetProcAddress("gl" #name));
  if (ok && c) { GL2_FUNCTIONS }
#undef GL2_FUNCTION
  return ok;
}

} // namespace

Gl with_shaders(const Gl& library, Twins twins) {
  real = library;
  Gl gl = real;
  gl.name += " with shaders/glsl";
  gl.ShadeModel = shade_model;
  gl.LightModeli = light_model;
  gl.GetIntegerv = get_integerv;
  gl.Materialf = materialf;
  gl.Materialfv = materialfv;
  gl.Begin = begin;
  gl.End = end;
  gl.DrawArrays = draw_arrays;
  gl.DrawElements = draw_elements;
  gl.OSMesaMakeCurrent =
      twins == Twins::Phong ? make_current<Twins::Phong> : make_current<Twins::PhongAndGouraud>;
  return gl;
}

Gl shader_library(Twins twins) { return with_shaders(osmesa_library(), twins); }

} // namespace softgl::test
