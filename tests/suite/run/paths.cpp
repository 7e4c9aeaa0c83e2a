#include "run/paths.h"

#include <algorithm>
#include <cmath>

#include "gl/subject.h"

namespace softgl::suite {
namespace {

bool calls(const Script& s, Command command) {
  return std::any_of(s.calls.begin(), s.calls.end(), [&](const Call& c) { return c.command == command; });
}
bool enables(const Script& s, GLenum name) {
  return std::any_of(s.calls.begin(), s.calls.end(), [&](const Call& c) {
    return (c.command == Command::Enable || c.command == Command::Disable) && c.e(0) == name;
  });
}

// Whether images, parameters or environments of textures are set: another texture would be in the way.
bool uses_textures(const Script& s) {
  return std::any_of(s.calls.begin(), s.calls.end(), [](const Call& c) {
    const std::string name = facts_of(c.command).name;
    return name.find("Tex") != std::string::npos && !name.starts_with("TexCoord");
  });
}
// Whether a buffer other than that of colors is seen.
bool reads_depths(const Script& s) {
  return std::any_of(s.calls.begin(), s.calls.end(), [](const Call& c) {
    return (c.command == Command::PaintPixels && c.e(4) == GL_DEPTH_COMPONENT) ||
           (c.command == Command::CopyPixels && c.e(4) == GL_DEPTH);
  });
}

std::optional<Script> with(const Script& before, const Script& body) {
  Script s = prologue();
  s.append(before), s.append(body);
  return s;
}

std::optional<Script> plain(const Script& body) { return with({}, body); }

std::optional<Script> alpha_test(const Script& body) {
  if (enables(body, GL_ALPHA_TEST)) return {};
  Script s;
  s.AlphaFunc(GL_GEQUAL, 0.0), s.Enable(GL_ALPHA_TEST);
  return with(s, body);
}
std::optional<Script> stencil_test(const Script& body) {
  if (enables(body, GL_STENCIL_TEST)) return {};
  Script s;
  s.StencilFunc(GL_ALWAYS, 0, 255), s.StencilOp(GL_KEEP, GL_KEEP, GL_INCR), s.Enable(GL_STENCIL_TEST);
  return with(s, body);
}
std::optional<Script> depth_test(const Script& body) {
  if (enables(body, GL_DEPTH_TEST) || reads_depths(body)) return {};
  Script s;
  s.DepthFunc(GL_ALWAYS), s.Enable(GL_DEPTH_TEST);
  return with(s, body);
}
std::optional<Script> blending(const Script& body) {
  if (enables(body, GL_BLEND) || enables(body, GL_COLOR_LOGIC_OP)) return {};
  Script s;
  s.BlendFunc(GL_ONE, GL_ZERO), s.Enable(GL_BLEND);
  return with(s, body);
}
std::optional<Script> scissor(const Script& body) {
  if (enables(body, GL_SCISSOR_TEST)) return {};
  Script s;
  s.Scissor(0, 0, kWindowWidth, kWindowHeight), s.Enable(GL_SCISSOR_TEST);
  return with(s, body);
}
std::optional<Script> logic_op(const Script& body) {
  if (enables(body, GL_BLEND) || enables(body, GL_COLOR_LOGIC_OP)) return {};
  Script s;
  s.LogicOp(GL_COPY), s.Enable(GL_COLOR_LOGIC_OP);
  return with(s, body);
}
std::optional<Script> fog(const Script& body) {
  if (enables(body, GL_FOG)) return {};
  Script s;
  s.Fogi(GL_FOG_MODE, GL_EXP), s.Fogf(GL_FOG_DENSITY, 0.0), s.Fogfv(GL_FOG_COLOR, V{1, 0, 1, 1}),
      s.Enable(GL_FOG);
  return with(s, body);
}
std::optional<Script> white_texture(const Script& body) {
  if (enables(body, GL_TEXTURE_2D) || uses_textures(body)) return {};
  Script s;
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               Memory{GL_UNSIGNED_BYTE, std::vector<double>(16, 255)});
  s.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE), s.Enable(GL_TEXTURE_2D);
  return with(s, body);
}
std::optional<Script> polygon_mode(const Script& body) {
  Script s;
  s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), s.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  return with(s, body);
}
std::optional<Script> polygon_offset(const Script& body) {
  // Depths that are selected or fed back are seen; the chapter special has its own tests of the offset.
  if (enables(body, GL_DEPTH_TEST) || calls(body, Command::RenderMode)) return {};
  Script s;
  s.PolygonOffset(1.0, 1.0), s.Enable(GL_POLYGON_OFFSET_FILL);
  return with(s, body);
}
std::optional<Script> stipples(const Script& body) {
  if (enables(body, GL_POLYGON_STIPPLE) || enables(body, GL_LINE_STIPPLE)) return {};
  Script s;
  s.PolygonStipple(Memory{GL_UNSIGNED_BYTE, std::vector<double>(128, 255)}), s.Enable(GL_POLYGON_STIPPLE);
  s.LineStipple(1, 0xffff), s.Enable(GL_LINE_STIPPLE);
  return with(s, body);
}
std::optional<Script> clip_plane(const Script& body) {
  if (enables(body, GL_CLIP_PLANE0)) return {};
  Script s;
  s.ClipPlane(GL_CLIP_PLANE0, V{0, 0, -1, 100}), s.Enable(GL_CLIP_PLANE0); // in eye coordinates, far away
  return with(s, body);
}
std::optional<Script> black_light(const Script& body) {
  if (enables(body, GL_LIGHT7)) return {};
  Script s; // near, a spot, attenuated: all that takes lighting out of its fast paths
  s.Lightfv(GL_LIGHT7, GL_POSITION, V{1, 2, 9, 1}), s.Lightf(GL_LIGHT7, GL_SPOT_CUTOFF, 30.0);
  s.Lightf(GL_LIGHT7, GL_LINEAR_ATTENUATION, 0.5), s.Enable(GL_LIGHT7);
  return with(s, body);
}
std::optional<Script> unused_lights(const Script& body) {
  Script s;
  for (GLenum light = GL_LIGHT2; light <= GL_LIGHT7; light++) {
    if (enables(body, light)) continue;
    s.Lightfv(light, GL_DIFFUSE, V{1, 0, 1, 1}), s.Lightfv(light, GL_AMBIENT, V{1, 1, 0, 1});
    s.Enable(light), s.Disable(light);
  }
  return with(s, body);
}
std::optional<Script> hints(const Script& body) {
  Script s;
  s.Hint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST), s.Hint(GL_FOG_HINT, GL_NICEST);
  return with(s, body);
}

// A list holds all calls but those that it cannot (5.4); a test that uses lists itself is left alone.
std::optional<Script> in_list(const Script& body, GLenum mode) {
  for (const Call& call : body.calls)
    if (!facts_of(call.command).in_lists || call.error != GL_NO_ERROR) return {};
  Script s = prologue();
  s.NewList(900, mode), s.append(body), s.EndList();
  if (mode == GL_COMPILE) s.CallList(900);
  return s;
}
std::optional<Script> list(const Script& body) { return in_list(body, GL_COMPILE); }
std::optional<Script> list_executed(const Script& body) { return in_list(body, GL_COMPILE_AND_EXECUTE); }

struct Vertices { // of one Begin and End
  std::vector<double> position, normal, color;
};

// Adds the vertices between Begin and End as arrays; false if something else than vertices stands there.
bool add_arrays(Script& s, const std::vector<Call>& calls, GLenum mode, bool indexed) {
  Vertices v;
  std::vector<double> normal, color;
  for (const Call& c : calls) {
    const auto numbers = [&] {
      std::vector<double> n;
      for (const Argument& a : c.arguments) n.push_back(a.number);
      return n;
    };
    switch (c.command) {
    case Command::Normal3f: normal = numbers(); break;
    case Command::Color3f: color = numbers(), color.push_back(1); break;
    case Command::Color4f: color = numbers(); break;
    case Command::Vertex3f: {
      const std::vector<double> position = numbers();
      if (!v.position.empty() && (normal.empty() != v.normal.empty() || color.empty() != v.color.empty()))
        return false;
      v.position.insert(v.position.end(), position.begin(), position.end());
      v.normal.insert(v.normal.end(), normal.begin(), normal.end());
      v.color.insert(v.color.end(), color.begin(), color.end());
      break;
    }
    default: return false;
    }
  }
  const int count = int(v.position.size() / 3);
  s.EnableClientState(GL_VERTEX_ARRAY), s.VertexPointer(3, GL_FLOAT, 0, Memory{GL_FLOAT, v.position});
  if (!v.normal.empty())
    s.EnableClientState(GL_NORMAL_ARRAY), s.NormalPointer(GL_FLOAT, 0, Memory{GL_FLOAT, v.normal});
  if (!v.color.empty())
    s.EnableClientState(GL_COLOR_ARRAY), s.ColorPointer(4, GL_FLOAT, 0, Memory{GL_FLOAT, v.color});
  if (indexed) {
    std::vector<double> indices;
    for (int i = 0; i < count; i++) indices.push_back(i);
    s.DrawElements(mode, count, GL_UNSIGNED_SHORT, Memory{GL_UNSIGNED_SHORT, indices});
  } else {
    s.DrawArrays(mode, 0, count);
  }
  s.DisableClientState(GL_VERTEX_ARRAY), s.DisableClientState(GL_NORMAL_ARRAY),
      s.DisableClientState(GL_COLOR_ARRAY);
  // What was current is not defined behind an array (2.8).
  if (!normal.empty()) s.Normal3f(normal[0], normal[1], normal[2]);
  if (!color.empty()) s.Color4f(color[0], color[1], color[2], color[3]);
  return true;
}

std::optional<Script> as_arrays(const Script& body, bool indexed) {
  for (Command own :
       {Command::NewList, Command::EnableClientState, Command::InterleavedArrays, Command::GetFloatv})
    if (calls(body, own)) return {};
  Script s = prologue();
  std::vector<Call> inside;
  bool open = false, any = false;
  GLenum mode = 0;
  for (const Call& call : body.calls) {
    if (call.error != GL_NO_ERROR) return {};
    if (call.command == Command::Begin)
      open = true, mode = call.e(0), inside.clear();
    else if (call.command == Command::End) {
      if (!add_arrays(s, inside, mode, indexed)) return {};
      open = false, any = true;
    } else if (open)
      inside.push_back(call);
    else
      s.calls.push_back(call);
  }
  if (!any) return {};
  return s;
}
std::optional<Script> arrays(const Script& body) { return as_arrays(body, false); }
std::optional<Script> elements(const Script& body) { return as_arrays(body, true); }

} // namespace

const std::vector<PathLevel>& path_levels() {
  static const std::vector<PathLevel> levels = {
      {"plain", "the test as it stands", plain},
      {"alpha test", "an alpha test that all fragments pass", alpha_test},
      {"stencil test", "a stencil test that all fragments pass", stencil_test},
      {"depth test", "a depth test that all fragments pass", depth_test},
      {"blending", "blending with one and zero", blending},
      {"scissor", "a scissor box that holds the window", scissor},
      {"logic op", "the logic operation copy", logic_op},
      {"fog", "fog of density 0", fog},
      {"white texture", "a white texture that modulates", white_texture},
      {"polygon mode", "another polygon mode, and back", polygon_mode},
      {"polygon offset", "an offset of depths that nobody compares", polygon_offset},
      {"stipples", "stipple patterns of ones", stipples},
      {"clip plane", "a clip plane that holds all", clip_plane},
      {"black light", "a near, attenuated spot light that is black", black_light},
      {"unused lights", "lights that are off again", unused_lights},
      {"hints", "hints that ask for the nicest", hints},
      {"list", "a display list", list},
      {"list executed", "a display list that is executed while it is compiled", list_executed},
      {"arrays", "vertex arrays", arrays},
      {"elements", "vertex arrays with indices", elements},
  };
  return levels;
}

} // namespace softgl::suite
