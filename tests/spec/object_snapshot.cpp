#include "spec/object_snapshot.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace softgl::test {
namespace {

// The answers of one object as a line; the error of each query, too.
class Line {
public:
  Line(const Gl& gl, StateSnapshot& snapshot, std::string name)
      : gl_(gl), snapshot_(snapshot), name_(std::move(name)) {}
  ~Line() { snapshot_.emplace_back(name_, text_); }
  Line(const Line&) = delete;

  /// `ask` gets memory for answers; those that it has written are kept.
  template <class T, class Ask> void add(GLenum what, Ask ask) {
    T values[1024];
    std::fill(std::begin(values), std::end(values), T(77));
    ask(values);
    size_t count = std::size(values);
    while (count > 0 && values[count - 1] == T(77)) --count;
    put(" %x:", what);
    for (size_t i = 0; i < count; ++i) put(" %.9g", double(values[i]));
    if (const GLenum error = gl_.GetError()) put(" error %x", error);
  }
  template <class T> void put(const char* format, T value) {
    char buffer[48];
    std::snprintf(buffer, sizeof buffer, format, value);
    text_ += buffer;
  }

private:
  const Gl& gl_;
  StateSnapshot& snapshot_;
  std::string name_, text_;
};

constexpr GLenum kTextures[] = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP,
                                GL_TEXTURE_RECTANGLE};
constexpr GLenum kTextureParameters[] = {
    GL_TEXTURE_WRAP_S,       GL_TEXTURE_WRAP_T,       GL_TEXTURE_WRAP_R,     GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_MAG_FILTER,   GL_TEXTURE_BORDER_COLOR, GL_TEXTURE_PRIORITY,   GL_TEXTURE_MIN_LOD,
    GL_TEXTURE_MAX_LOD,      GL_TEXTURE_BASE_LEVEL,   GL_TEXTURE_MAX_LEVEL,  GL_TEXTURE_LOD_BIAS,
    GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC, GL_DEPTH_TEXTURE_MODE, GL_GENERATE_MIPMAP};
constexpr GLenum kSamplerParameters[] = {
    GL_TEXTURE_WRAP_S,         GL_TEXTURE_WRAP_T,       GL_TEXTURE_WRAP_R,
    GL_TEXTURE_MIN_FILTER,     GL_TEXTURE_MAG_FILTER,   GL_TEXTURE_BORDER_COLOR,
    GL_TEXTURE_MIN_LOD,        GL_TEXTURE_MAX_LOD,      GL_TEXTURE_LOD_BIAS,
    GL_TEXTURE_COMPARE_MODE,   GL_TEXTURE_COMPARE_FUNC, GL_TEXTURE_MAX_ANISOTROPY_EXT,
    GL_TEXTURE_SRGB_DECODE_EXT};
constexpr GLenum kImageParameters[] = {
    GL_TEXTURE_WIDTH,      GL_TEXTURE_HEIGHT,         GL_TEXTURE_DEPTH,      GL_TEXTURE_RED_SIZE,
    GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_COMPRESSED};
constexpr GLenum kBuffers[] = {GL_ARRAY_BUFFER,        GL_ELEMENT_ARRAY_BUFFER, GL_PIXEL_PACK_BUFFER,
                               GL_PIXEL_UNPACK_BUFFER, GL_COPY_READ_BUFFER,     GL_COPY_WRITE_BUFFER};
constexpr GLenum kAttachmentParameters[] = {
    GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME,
    GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE,
    GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER};
constexpr GLenum kRenderbufferParameters[] = {GL_RENDERBUFFER_WIDTH, GL_RENDERBUFFER_HEIGHT,
                                              GL_RENDERBUFFER_INTERNAL_FORMAT, GL_RENDERBUFFER_SAMPLES};

void add_textures(const Gl& gl, StateSnapshot& snapshot) {
  for (GLenum target : kTextures) {
    Line line(gl, snapshot, "texture " + std::to_string(target));
    for (GLenum parameter : kTextureParameters)
      line.add<GLfloat>(parameter, [&](GLfloat* values) { gl.GetTexParameterfv(target, parameter, values); });
    const GLenum image = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
    for (GLint level = 0; level < (target == GL_TEXTURE_RECTANGLE ? 1 : 3); ++level)
      for (GLenum parameter : kImageParameters)
        line.add<GLint>(parameter,
                        [&](GLint* values) { gl.GetTexLevelParameteriv(image, level, parameter, values); });
  }
}

void add_samplers(const Gl& gl, StateSnapshot& snapshot) {
  for (GLuint sampler = 1; sampler < 4; ++sampler) {
    Line line(gl, snapshot, "sampler " + std::to_string(sampler));
    for (GLenum parameter : kSamplerParameters)
      line.add<GLfloat>(parameter,
                        [&](GLfloat* values) { gl.GetSamplerParameterfv(sampler, parameter, values); });
    line.add<GLint>(GL_TEXTURE_BORDER_COLOR, [&](GLint* values) {
      gl.GetSamplerParameterIiv(sampler, GL_TEXTURE_BORDER_COLOR, values);
    });
  }
}

void add_buffers(const Gl& gl, StateSnapshot& snapshot) {
  for (GLenum target : kBuffers) {
    Line line(gl, snapshot, "buffer " + std::to_string(target));
    for (GLenum parameter : {GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS, GL_BUFFER_MAPPED})
      line.add<GLint>(parameter, [&](GLint* values) { gl.GetBufferParameteriv(target, parameter, values); });
  }
}

void add_framebuffers(const Gl& gl, StateSnapshot& snapshot) {
  for (GLenum target : {GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER}) {
    Line line(gl, snapshot, "framebuffer " + std::to_string(target));
    GLint bound = 0;
    gl.GetIntegerv(target == GL_DRAW_FRAMEBUFFER ? GL_DRAW_FRAMEBUFFER_BINDING : GL_READ_FRAMEBUFFER_BINDING,
                   &bound);
    line.put(" bound %d", bound);
    line.put(" status %x", gl.CheckFramebufferStatus(target));
    if (!bound) continue;
    for (GLenum attachment : {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT})
      for (GLenum parameter : kAttachmentParameters)
        line.add<GLint>(parameter, [&](GLint* values) {
          gl.GetFramebufferAttachmentParameteriv(target, attachment, parameter, values);
        });
  }
  Line line(gl, snapshot, "renderbuffer");
  for (GLenum parameter : kRenderbufferParameters)
    line.add<GLint>(
        parameter, [&](GLint* values) { gl.GetRenderbufferParameteriv(GL_RENDERBUFFER, parameter, values); });
}

void add_maps(const Gl& gl, StateSnapshot& snapshot) {
  for (GLenum first : {GL_MAP1_COLOR_4, GL_MAP2_COLOR_4})
    for (GLenum map = first; map < first + 9; ++map) {
      Line line(gl, snapshot, "map " + std::to_string(map));
      for (GLenum query : {GL_ORDER, GL_DOMAIN})
        line.add<GLfloat>(query, [&](GLfloat* values) { gl.GetMapfv(map, query, values); });
    }
}

void add_names(const Gl& gl, StateSnapshot& snapshot) {
  Line line(gl, snapshot, "names");
  for (GLuint name = 0; name < 8; ++name)
    for (GLboolean is :
         {gl.IsTexture(name), gl.IsBuffer(name), gl.IsList(name), gl.IsQuery(name), gl.IsFramebuffer(name),
          gl.IsRenderbuffer(name), gl.IsVertexArray(name), gl.IsSampler(name)})
      line.put(is ? "%d" : ".", int(name));
  line.add<GLint>(GL_CURRENT_QUERY,
                  [&](GLint* values) { gl.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, values); });
}

void add_pixel_maps(const Gl& gl, StateSnapshot& snapshot) {
  GLint pack = 0;
  gl.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &pack);
  if (pack) return;
  for (GLenum map = GL_PIXEL_MAP_I_TO_I; map <= GL_PIXEL_MAP_A_TO_A; ++map) {
    Line line(gl, snapshot, "pixel map " + std::to_string(map));
    line.add<GLfloat>(map, [&](GLfloat* values) { gl.GetPixelMapfv(map, values); });
  }
}

} // namespace

void add_objects(const Gl& gl, StateSnapshot& snapshot) {
  add_textures(gl, snapshot);
  add_samplers(gl, snapshot);
  add_buffers(gl, snapshot);
  add_framebuffers(gl, snapshot);
  add_maps(gl, snapshot);
  add_names(gl, snapshot);
  add_pixel_maps(gl, snapshot);
}

} // namespace softgl::test
