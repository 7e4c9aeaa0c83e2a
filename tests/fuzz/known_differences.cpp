#include "fuzz/known_differences.h"

#include <algorithm>
#include <initializer_list>

namespace softgl::test {
namespace {

struct Call {
  std::string_view command;
  const Arguments& arguments;
  const Gl& gl;
  bool in_list;

  bool is(std::initializer_list<std::string_view> commands) const {
    return std::find(commands.begin(), commands.end(), command) != commands.end();
  }
  bool begins(std::string_view text) const { return command.starts_with(text); }
  GLenum name(size_t i) const { return GLenum(arguments[i].whole); }
  bool name_is(size_t i, std::initializer_list<GLenum> names) const {
    return std::find(names.begin(), names.end(), name(i)) != names.end();
  }
  bool negative(size_t i) const { return arguments[i].whole < 0; }
  GLint state(GLenum value) const {
    GLint answer = 0;
    gl.GetIntegerv(value, &answer);
    return answer;
  }
};

bool scalar_form_of_a_vector(const Call& c) {
  if (!c.is({"Fogf", "Fogi", "LightModelf", "LightModeli", "Lightf", "Lighti", "Materialf", "Materiali",
             "TexEnvf", "TexEnvi", "TexGenf", "TexGeni", "TexGend", "TexParameterf", "TexParameteri",
             "SamplerParameterf", "SamplerParameteri", "PointParameterf", "PointParameteri"}))
    return false;
  const size_t parameter = c.begins("Fog") || c.begins("LightModel") || c.begins("PointParameter") ? 0 : 1;
  return c.name_is(parameter, {GL_FOG_COLOR, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                               GL_AMBIENT_AND_DIFFUSE, GL_COLOR_INDEXES, GL_POSITION, GL_SPOT_DIRECTION,
                               GL_LIGHT_MODEL_AMBIENT, GL_TEXTURE_ENV_COLOR, GL_OBJECT_PLANE, GL_EYE_PLANE,
                               GL_TEXTURE_BORDER_COLOR, GL_POINT_DISTANCE_ATTENUATION});
}

bool name_of_a_later_version(const Call& c) {
  const bool unit = c.name(0) < GL_TEXTURE0 || c.name(0) > GL_TEXTURE7;
  if (c.begins("MultiTexCoord") || c.is({"ActiveTexture"})) return unit;
  if (c.begins("BlendFunc"))
    for (size_t i = 0; i < 4; ++i)
      if (c.name_is(i, {GL_SOURCE1_ALPHA}) || (i % 2 == 1 && c.name_is(i, {GL_SRC_ALPHA_SATURATE})))
        return true;
  if (c.is({"BindSampler"})) return c.name(0) > 7; // OSMesa has units that only shaders reach
  if (c.command.find("SamplerParameter") != std::string_view::npos &&
      c.name_is(1, {GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_TEXTURE_REDUCTION_MODE_ARB}))
    return true;
  return c.is({"ReadBuffer"}) ||
         ((c.begins("TexImage") || c.begins("CopyTexImage")) && c.name_is(2, {GL_STENCIL_INDEX}));
}

bool bad_argument_in_a_list(const Call& c) {
  if (!c.in_list) return false;
  if (c.begins("CompressedTex")) // the size, the last argument but one
    for (size_t i = 5; i < 10; ++i)
      if (c.negative(i)) return true;
  return c.is({"DrawElements", "StencilFuncSeparateATI", "ClearIndex", "BlitFramebuffer"}) ||
         c.begins("MultiDraw") || c.begins("MultiMode") || c.begins("Map1") || c.begins("Map2") ||
         (c.is({"PrioritizeTextures"}) && c.negative(0)) || (c.is({"CallList"}) && c.name(0) == 0) ||
         (c.is({"Bitmap"}) && (c.negative(0) || c.negative(1)));
}

bool of_framebuffer_objects(const Call& c) {
  const bool bound = c.state(GL_DRAW_FRAMEBUFFER_BINDING) != 0;
  const bool position = c.begins("RasterPos") || c.begins("WindowPos");
  return (position && c.gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) ||
         (c.is({"BindFramebuffer", "BindRenderbuffer"}) && c.name(1) != 0) ||
         (bound && c.is({"AlphaFunc", "ClearColor", "BlendColor", "Fogfv", "Fogiv", "TexEnvfv", "TexEnviv",
                         "DeleteRenderbuffers"})) ||
         c.is({"GenerateMipmap"});
}

bool of_arrays(const Call& c) { // an address of memory for an array of a vertex array object; four components
  const bool array = (c.command.ends_with("Pointer") && !c.begins("Get")) || c.is({"InterleavedArrays"});
  return (array && c.state(GL_VERTEX_ARRAY_BINDING) != 0 && c.state(GL_ARRAY_BUFFER_BINDING) == 0) ||
         (c.is({"SecondaryColorPointer"}) && c.name(0) == 4);
}

// Answers that have a reason in both libraries: other extensions, other rounding.
bool answers_differ(const Call& c) {
  return c.is({"GetCompressedTexImage", "GetStringi", "GetInteger64v"}) ||
         (c.is({"GetSamplerParameterIiv", "GetSamplerParameterIuiv"}) && // cut and not rounded
          c.name_is(1, {GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD, GL_TEXTURE_LOD_BIAS})) ||
         (c.is({"GetTexImage"}) && c.name_is(2, {GL_COLOR_INDEX, GL_STENCIL_INDEX})) ||
         (c.begins("GetTexLevelParameter") && c.name_is(2, {GL_TEXTURE_COMPONENTS})) ||
         (c.is({"GetIntegerv"}) &&
          c.name_is(0, {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX})) ||
         (c.is({"GetBooleanv", "GetIntegerv", "GetFloatv", "GetDoublev"}) &&
          c.name_is(0, {GL_COMPRESSED_TEXTURE_FORMATS, GL_NUM_COMPRESSED_TEXTURE_FORMATS,
                        GL_IMPLEMENTATION_COLOR_READ_FORMAT, GL_IMPLEMENTATION_COLOR_READ_TYPE}));
}

} // namespace

bool differs_on_purpose(std::string_view command, const Arguments& arguments, const Gl& gl, bool in_list) {
  const Call c{command, arguments, gl, in_list};
  return scalar_form_of_a_vector(c) || name_of_a_later_version(c) || bad_argument_in_a_list(c) ||
         of_framebuffer_objects(c) || of_arrays(c) || answers_differ(c) ||
         c.is({"RenderMode", "GenQueries", "DeleteQueries"}) ||
         (c.is({"MultiModeDrawArraysIBM"}) && c.negative(3)) ||
         (c.is({"MultiModeDrawElementsIBM"}) && c.negative(4)) ||
         (c.is({"ListBase"}) && c.name(0) > 0x7fffffff);
}

} // namespace softgl::test
