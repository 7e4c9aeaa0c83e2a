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
#define GL2_FUNCTION(name) decltype(&::gl##name) name = nullptr;
#define GL2_FUNCTIONS \
  GL2_FUNCTION(CreateShader) GL2_FUNCTION(ShaderSource) GL2_FUNCTION(CompileShader) GL2_FUNCTION(GetShaderiv) GL2_FUNCTION(GetShaderInfoLog) \
  GL2_FUNCTION(CreateProgram) GL2_FUNCTION(AttachShader) GL2_FUNCTION(LinkProgram) GL2_FUNCTION(GetProgramiv) GL2_FUNCTION(GetProgramInfoLog) \
  GL2_FUNCTION(UseProgram) GL2_FUNCTION(GetUniformLocation) GL2_FUNCTION(Uniform1i) GL2_FUNCTION(Uniform1iv) GL2_FUNCTION(Uniform4fv)
  GL2_FUNCTIONS
#undef GL2_FUNCTION
};

Gl osmesa;
Gl2 gl2;

// What the current context has been told.
struct Context {
  Twins twins = Twins::Phong;
  bool phong = false, reflection = false;
  GLint terms = GL_ALL_TERM_BITS_SOFTGL;
  GLuint phong_program = 0, gouraud_program = 0; // once they have been needed
} context;

GLuint compile(GLenum stage, const std::string& file) {
  const std::string path = std::string(SOFTGL_TEST_SOURCE_DIR "/shaders/glsl/") + file;
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << in.rdbuf();
  const std::string source = text.str();
  const char* pointer = source.c_str();
  const GLuint shader = gl2.CreateShader(stage);
  gl2.ShaderSource(shader, 1, &pointer, nullptr);
  gl2.CompileShader(shader);
  GLint ok = 0;
  gl2.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  char log[2000] = "";
  if (!ok) gl2.GetShaderInfoLog(shader, sizeof log, nullptr, log), throw std::runtime_error(path + ": " + log);
  return shader;
}

GLuint link(const std::vector<std::string>& vertex, const std::vector<std::string>& fragment) {
  const GLuint program = gl2.CreateProgram();
  for (const std::string& file : vertex) gl2.AttachShader(program, compile(GL_VERTEX_SHADER, file));
  for (const std::string& file : fragment) gl2.AttachShader(program, compile(GL_FRAGMENT_SHADER, file));
  gl2.LinkProgram(program);
  GLint ok = 0;
  gl2.GetProgramiv(program, GL_LINK_STATUS, &ok);
  char log[2000] = "";
  if (!ok) gl2.GetProgramInfoLog(program, sizeof log, nullptr, log), throw std::runtime_error(std::string("shaders/glsl does not link: ") + log);
  return program;
}

// Which of emission, ambient, diffuse, specular follow the colour on a face.
void set_tracked(GLuint program, const char* name, GLenum face) {
  GLint tracking_face = 0, parameter = 0;
  osmesa.GetIntegerv(GL_COLOR_MATERIAL_FACE, &tracking_face);
  osmesa.GetIntegerv(GL_COLOR_MATERIAL_PARAMETER, &parameter);
  const bool on = osmesa.IsEnabled(GL_COLOR_MATERIAL) && (GLenum(tracking_face) == face || tracking_face == GL_FRONT_AND_BACK);
  const bool both = parameter == GL_AMBIENT_AND_DIFFUSE;
  const GLfloat tracks[4] = {GLfloat(on && parameter == GL_EMISSION), GLfloat(on && (both || parameter == GL_AMBIENT)),
                             GLfloat(on && (both || parameter == GL_DIFFUSE)), GLfloat(on && parameter == GL_SPECULAR)};
  gl2.Uniform4fv(gl2.GetUniformLocation(program, name), 1, tracks);
}

// The part of the state that shaders do not see by themselves.
void set_uniforms(GLuint program) {
  const auto set = [&](const char* name, bool value) { gl2.Uniform1i(gl2.GetUniformLocation(program, name), value); };
  const auto integer = [&](GLenum name) {
    GLint value = 0;
    osmesa.GetIntegerv(name, &value);
    return value;
  };
  GLint enabled[8];
  for (int i = 0; i < 8; i++) enabled[i] = osmesa.IsEnabled(GL_LIGHT0 + GLenum(i));
  gl2.Uniform1iv(gl2.GetUniformLocation(program, "light_enabled"), 8, enabled);
  set("local_viewer", integer(GL_LIGHT_MODEL_LOCAL_VIEWER));
  set("two_sided", integer(GL_LIGHT_MODEL_TWO_SIDE));
  set("separate_specular", integer(GL_LIGHT_MODEL_COLOR_CONTROL) == GL_SEPARATE_SPECULAR_COLOR);
  set("rescale_normal", osmesa.IsEnabled(GL_RESCALE_NORMAL));
  set("normalize_normal", osmesa.IsEnabled(GL_NORMALIZE) || context.reflection);
  set_tracked(program, "front_tracks", GL_FRONT);
  set_tracked(program, "back_tracks", GL_BACK);
  set("reflection_vector", context.reflection);
  GLfloat left_out[4];
  const GLint bits[4] = {GL_EMISSION_TERM_BIT_SOFTGL, GL_AMBIENT_TERM_BIT_SOFTGL, GL_DIFFUSE_TERM_BIT_SOFTGL, GL_SPECULAR_TERM_BIT_SOFTGL};
  for (int i = 0; i < 4; i++) left_out[i] = context.terms & bits[i] ? 0.0f : 1.0f;
  gl2.Uniform4fv(gl2.GetUniformLocation(program, "left_out"), 1, left_out);
}

// Before each primitive: the right program with the right uniforms.
void prepare() {
  const bool lit = osmesa.IsEnabled(GL_LIGHTING);
  if (lit && context.phong) {
    if (!context.phong_program) context.phong_program = link({"phong.vert", "normal.glsl"}, {"phong.frag", "lighting.glsl"});
    gl2.UseProgram(context.phong_program);
    set_uniforms(context.phong_program);
  } else if (lit && context.twins == Twins::PhongAndGouraud) {
    if (!context.gouraud_program) context.gouraud_program = link({"gouraud.vert", "normal.glsl", "lighting.glsl"}, {"gouraud.frag"});
    gl2.UseProgram(context.gouraud_program);
    set_uniforms(context.gouraud_program);
    GLint two_sided = 0;
    osmesa.GetIntegerv(GL_LIGHT_MODEL_TWO_SIDE, &two_sided);
    (two_sided ? osmesa.Enable : osmesa.Disable)(GL_VERTEX_PROGRAM_TWO_SIDE);
  } else {
    gl2.UseProgram(0);
  }
}

// What shaders draw is shaded smoothly, whatever was selected before.
void shade_model(GLenum mode) {
  context.phong = mode == GL_PHONG_WIN;
  osmesa.ShadeModel(context.phong ? GLenum(GL_SMOOTH) : mode);
}

void light_model(GLenum name, GLint value) {
  if (name == GL_LIGHT_MODEL_SPECULAR_VECTOR_SOFTGL) context.reflection = value == GL_REFLECTION_VECTOR_SOFTGL;
  else if (name == GL_LIGHT_MODEL_TERMS_SOFTGL) context.terms = value;
  else osmesa.LightModeli(name, value);
}

void begin(GLenum mode) { prepare(), osmesa.Begin(mode); }
void draw_arrays(GLenum mode, GLint first, GLsizei count) { prepare(), osmesa.DrawArrays(mode, first, count); }
void draw_elements(GLenum mode, GLsizei count, GLenum type, const void* indices) { prepare(), osmesa.DrawElements(mode, count, type, indices); }

template <Twins kTwins> GLboolean make_current(void* c, void* buffer, GLenum type, GLsizei width, GLsizei height) {
  const GLboolean ok = osmesa.OSMesaMakeCurrent(c, buffer, type, width, height);
  context = {};
  context.twins = kTwins;
#define GL2_FUNCTION(name) gl2.name = reinterpret_cast<decltype(gl2.name)>(osmesa.OSMesaGetProcAddress("gl" #name));
  if (ok && c) {
    GL2_FUNCTIONS
  }
#undef GL2_FUNCTION
  return ok;
}

} // namespace

Gl shader_library(Twins twins) {
  osmesa = osmesa_library();
  Gl gl = osmesa;
  gl.name = "OSMesa with shaders/glsl";
  gl.ShadeModel = shade_model;
  gl.LightModeli = light_model;
  gl.Begin = begin;
  gl.DrawArrays = draw_arrays;
  gl.DrawElements = draw_elements;
  gl.OSMesaMakeCurrent = twins == Twins::Phong ? make_current<Twins::Phong> : make_current<Twins::PhongAndGouraud>;
  return gl;
}

} // namespace softgl::test
