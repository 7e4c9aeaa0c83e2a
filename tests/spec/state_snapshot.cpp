#include "spec/state_snapshot.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace softgl::test {
namespace {

std::string text(double v) {
  if (std::isnan(v)) return "nan ";
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, v == std::floor(v) && std::fabs(v) < 1e9 ? "%.0f " : "%.17g ", v);
  return buffer;
}

// Values beyond what an integer holds are converted by OSMesa as the processor happens to; GL 1.5, 6.1.2 asks
// for the nearest. Matrices are mapped like colors by OSMesa, against 6.1.2. Neither is compared.
bool integers_comparable(const StateRow& row, const double* v, int count) {
  if (row.name.find("_MATRIX") != std::string::npos) return false;
  const double limit = row.kind == 'N' ? 1.0 : 2147483520.0;
  for (int i = 0; i < count; ++i)
    if (!(std::fabs(v[i]) <= limit)) return false;
  return true;
}

template <class T> int written(const T* values, const T* untouched) {
  int count = 0;
  for (int i = 0; i < 16; ++i)
    if (std::memcmp(&values[i], &untouched[i], sizeof(T)) != 0) count = i + 1;
  return count;
}

// Asks twice with different contents of the array, so that values that are written can be told from those
// that are not.
template <class T, class Ask> std::string answers(Ask ask, double* out = nullptr, int* out_count = nullptr) {
  T a[16], b[16], a0[16], b0[16];
  std::memset(a, 0x5a, sizeof a);
  std::memset(b, 0x25, sizeof b);
  std::memcpy(a0, a, sizeof a);
  std::memcpy(b0, b, sizeof b);
  ask(a);
  ask(b);
  const int count = std::max(written(a, a0), written(b, b0));
  std::string s;
  for (int i = 0; i < count; ++i) {
    s += text(double(a[i]));
    if (out) out[i] = double(a[i]);
  }
  if (out_count) *out_count = count;
  return s;
}

std::string error_text(const Gl& gl) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return "";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "error 0x%04x", error);
  return buffer;
}

void add_rows(const Gl& gl, StateSnapshot& out) {
  GLint active = 0;
  gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (const StateRow& row : state_rows()) {
    if (row.name.ends_with("_WIN") || row.name.ends_with("_SOFTGL")) continue; // extensions that OSMesa lacks
    if (row.name.find("COMPRESSED_TEXTURE_FORMATS") != std::string::npos)
      continue;                                     // OSMesa has 12, softgl three
    if (row.token == GL_DEPTH_BOUNDS_EXT) continue; // OSMesa gives halves of its doubles as floats
    if (row.token == GL_NUM_EXTENSIONS) continue;   // OSMesa has more
    if (row.token == GL_MAX_DRAW_BUFFERS) continue; // OSMesa has 8, softgl 1
    if (row.token == GL_TRANSPOSE_TEXTURE_MATRIX && active != GL_TEXTURE0) continue; // OSMesa gives unit 0's
    double v[16];
    int count = 0;
    out.emplace_back(row.name + " double",
                     answers<GLdouble>([&](GLdouble* p) { gl.GetDoublev(row.token, p); }, v, &count));
    out.emplace_back(row.name + " float", answers<GLfloat>([&](GLfloat* p) { gl.GetFloatv(row.token, p); }));
    out.emplace_back(row.name + " bool",
                     answers<GLboolean>([&](GLboolean* p) { gl.GetBooleanv(row.token, p); }));
    out.emplace_back(row.name + " int", integers_comparable(row, v, count)
                                            ? answers<GLint>([&](GLint* p) { gl.GetIntegerv(row.token, p); })
                                            : std::string("not compared"));
    if (row.kind == 'C' || row.kind == 'A' || row.kind == 'S')
      out.emplace_back(row.name + " enabled", text(gl.IsEnabled(row.token)));
    out.emplace_back(row.name + " error", error_text(gl));
  }
}

void add_lighting(const Gl& gl, StateSnapshot& out, int lights) {
  for (int i = 0; i < lights; ++i)
    for (GLenum pname :
         {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT,
          GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION})
      out.emplace_back("light " + std::to_string(i) + " " + std::to_string(pname),
                       answers<GLfloat>([&](GLfloat* p) { gl.GetLightfv(GL_LIGHT0 + GLenum(i), pname, p); }));
  for (GLenum face : {GL_FRONT, GL_BACK})
    for (GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES})
      out.emplace_back("material " + std::to_string(face) + " " + std::to_string(pname),
                       answers<GLfloat>([&](GLfloat* p) { gl.GetMaterialfv(face, pname, p); }));
}

void add_unit(const Gl& gl, StateSnapshot& out, const std::string& prefix) {
  for (GLenum pname : {GL_TEXTURE_ENV_MODE, GL_TEXTURE_ENV_COLOR, GL_COMBINE_RGB, GL_COMBINE_ALPHA,
                       GL_SOURCE0_RGB, GL_SOURCE1_RGB, GL_SOURCE2_RGB, GL_SOURCE0_ALPHA, GL_SOURCE1_ALPHA,
                       GL_SOURCE2_ALPHA, GL_OPERAND0_RGB, GL_OPERAND1_RGB, GL_OPERAND2_RGB, GL_OPERAND0_ALPHA,
                       GL_OPERAND1_ALPHA, GL_OPERAND2_ALPHA, GL_RGB_SCALE, GL_ALPHA_SCALE}) {
    out.emplace_back(prefix + "environment " + std::to_string(pname),
                     answers<GLfloat>([&](GLfloat* p) { gl.GetTexEnvfv(GL_TEXTURE_ENV, pname, p); }));
    out.emplace_back(prefix + "environment int " + std::to_string(pname),
                     answers<GLint>([&](GLint* p) { gl.GetTexEnviv(GL_TEXTURE_ENV, pname, p); }));
  }
  out.emplace_back(prefix + "lod bias", answers<GLfloat>([&](GLfloat* p) {
                     gl.GetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, p);
                   }));
  out.emplace_back(prefix + "coord replace",
                   answers<GLint>([&](GLint* p) { gl.GetTexEnviv(GL_POINT_SPRITE, GL_COORD_REPLACE, p); }));
  for (GLenum coord : {GL_S, GL_T, GL_R, GL_Q})
    for (GLenum pname : {GL_TEXTURE_GEN_MODE, GL_OBJECT_PLANE, GL_EYE_PLANE}) {
      out.emplace_back(prefix + "generation " + std::to_string(coord) + " " + std::to_string(pname),
                       answers<GLfloat>([&](GLfloat* p) { gl.GetTexGenfv(coord, pname, p); }));
      out.emplace_back(prefix + "generation double " + std::to_string(coord) + " " + std::to_string(pname),
                       answers<GLdouble>([&](GLdouble* p) { gl.GetTexGendv(coord, pname, p); }));
    }
}

} // namespace

const std::vector<StateRow>& state_rows() {
  static const std::vector<StateRow> rows = {
#define STATE(name, kind, initial, ...) {"GL_" #name, GL_##name, initial, #kind[0]},
#define CAPABILITY(name, initial, ...) {"GL_" #name, GL_##name, {initial}, 'C'},
#define CAPABILITY_BIT(name, ...) {"GL_" #name, GL_##name, {0}, 'C'},
#define ARRAY(name, ...) {"GL_" #name, GL_##name, {0}, 'A'},
#define CLIENT_SWITCH(name, ...) {"GL_" #name, GL_##name, {0}, 'S'},
#include "../src/context/state_table.inc"
  };
  return rows;
}

StateSnapshot take_snapshot(const Gl& gl, bool thorough) {
  StateSnapshot out;
  out.emplace_back("pending error", error_text(gl));
  add_rows(gl, out);
  add_lighting(gl, out, thorough ? 8 : 2);
  for (int i = 0; i < (thorough ? 8 : 2); ++i)
    out.emplace_back("clip plane " + std::to_string(i),
                     answers<GLdouble>([&](GLdouble* p) { gl.GetClipPlane(GL_CLIP_PLANE0 + GLenum(i), p); }));
  if (thorough) {
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    for (GLenum i = 0; i < 8; ++i) {
      gl.ActiveTexture(GL_TEXTURE0 + i);
      const std::string prefix = "unit " + std::to_string(i) + " ";
      add_unit(gl, out, prefix);
      for (const StateRow& row : state_rows())
        if (row.name.rfind("GL_TEXTURE_", 0) == 0 || row.name.rfind("GL_CURRENT_T", 0) == 0)
          out.emplace_back(prefix + row.name,
                           answers<GLfloat>([&](GLfloat* p) { gl.GetFloatv(row.token, p); }));
    }
    gl.ActiveTexture(GLenum(active));
  } else {
    add_unit(gl, out, "");
  }
  std::vector<unsigned char> stipple(1 << 16, 0); // OSMesa clears bits beside a row that begins inside a byte
  GLint skip = 0;
  gl.GetIntegerv(GL_PACK_SKIP_PIXELS, &skip);
  if (skip % 8 == 0) gl.GetPolygonStipple(stipple.data());
  std::string bytes;
  for (size_t i = 0; i < stipple.size(); ++i)
    if (stipple[i] != 0) bytes += std::to_string(i) + ":" + std::to_string(stipple[i]) + " ";
  out.emplace_back("polygon stipple", bytes);
  out.emplace_back("error of queries", error_text(gl));
  return out;
}

std::string compare_snapshots(const StateSnapshot& a, const StateSnapshot& b) {
  if (a.size() != b.size()) return "different number of answers\n";
  std::string s;
  for (size_t i = 0; i < a.size(); ++i)
    if (a[i].second != b[i].second) s += a[i].first + ": " + a[i].second + "| " + b[i].second + "\n";
  return s;
}

CurrentContext::CurrentContext(const Gl& gl, GLenum type) : gl_(gl) {
  context_ = gl.OSMesaCreateContextExt(kOSMesaRgba, 24, 8, 0, nullptr);
  if (!context_ || !gl.OSMesaMakeCurrent(context_, buffer_.data(), type, 64, 64))
    throw std::runtime_error(gl.name + " makes no context");
}
CurrentContext::~CurrentContext() {
  gl_.OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  gl_.OSMesaDestroyContext(context_);
}

} // namespace softgl::test
