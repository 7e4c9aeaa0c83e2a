#include "fuzz/argument_forms.h"

#include <map>

namespace softgl::test {
namespace {

// clang-format off
struct Form {
  const char *command, *letters;
};
constexpr Form kForms[] = {
    {"TexStorage1D", ".nfw"}, {"TexStorage2D", ".nfww"}, {"TexStorage3D", ".nfvvv"}, {"LockArraysEXT", "in"},
    {"DebugMessageCallback", "00"}, {"DebugMessageControl", "...d.."}, {"DebugMessageInsert", "....nT"},
    {"GetDebugMessageLog", "dnxxxxxx"}, {"PushDebugGroup", "..nT"}, {"ObjectLabel", ".hnT"},
    {"LabelObjectEXT", ".hnT"}, {"GetObjectLabelEXT", ".hnxx"}, {"MultiModeDrawArraysIBM", "xinds"},
    {"MultiModeDrawElementsIBM", "xn.Kds"}, {"GetObjectLabel", ".hnxx"}, {"ObjectPtrLabel", "mnT"}, {"GetObjectPtrLabel", "mnxx"},
    {"ArrayElement", "i"}, {"DrawArrays", ".in"}, {"DrawElements", ".n.k"}, {"DrawRangeElements", ".iin.k"},
    {"MultiDrawArrays", ".ind"}, {"MultiDrawElements", ".n.Kd"}, {"DrawElementsBaseVertex", ".n.kb"},
    {"DrawRangeElementsBaseVertex", ".iin.kb"}, {"MultiDrawElementsBaseVertex", ".n.Kdb"},
    {"VertexPointer", "5.sm"}, {"ColorPointer", "5.sm"}, {"SecondaryColorPointer", "5.sm"},
    {"TexCoordPointer", "5.sm"}, {"NormalPointer", ".sm"}, {"IndexPointer", ".sm"},
    {"FogCoordPointer", ".sm"}, {"EdgeFlagPointer", "sm"}, {"InterleavedArrays", ".sm"},
    {"BindVertexArray", "h"}, {"GenVertexArrays", "d."}, {"DeleteVertexArrays", "d."},
    {"BufferData", ".zI."}, {"BufferSubData", ".yzm"}, {"GetBufferSubData", ".yzx"},
    {"MapBufferRange", ".yz."}, {"FlushMappedBufferRange", ".yz"}, {"CopyBufferSubData", "..yyz"},
    {"GenBuffers", "d."}, {"DeleteBuffers", "d."}, {"BindBuffer", ".h"}, {"GetBufferPointerv", "..x"},
    {"GetPointerv", ".x"}, {"Bitmap", "rr....m"}, {"DrawPixels", "rr..m"}, {"CopyPixels", "ccrr."},
    {"ReadPixels", "ccrr..x"}, {"PixelStorei", ".P"}, {"PixelStoref", ".P"}, {"PixelMapfv", ".N."},
    {"PixelMapuiv", ".N."}, {"PixelMapusv", ".N."}, {"GetPixelMapfv", ".x"}, {"GetPixelMapuiv", ".x"},
    {"GetPixelMapusv", ".x"}, {"PolygonStipple", "m"}, {"GetPolygonStipple", "x"},
    {"TexImage1D", ".LfwB..M"}, {"TexImage2D", ".LfwwB..M"}, {"TexImage3D", ".LfvvvB..M"},
    {"TexSubImage1D", ".Lor..m"}, {"TexSubImage2D", ".Loorr..m"}, {"TexSubImage3D", ".Looovvv..m"},
    {"CopyTexImage1D", ".LfccwB"}, {"CopyTexImage2D", ".LfccwwB"}, {"CopyTexSubImage1D", ".Loccr"},
    {"CopyTexSubImage2D", ".Looccrr"}, {"CopyTexSubImage3D", ".Loooccrr"},
    {"CompressedTexImage1D", ".LFwBSm"}, {"CompressedTexImage2D", ".LFwwBSm"},
    {"CompressedTexImage3D", ".LFvvvBSm"}, {"CompressedTexSubImage1D", ".LorFSm"},
    {"CompressedTexSubImage2D", ".LoorrFSm"}, {"CompressedTexSubImage3D", ".LooovvvFSm"},
    {"GetTexImage", ".L..x"}, {"GetCompressedTexImage", ".Lx"}, {"GetTexLevelParameterfv", ".L.x"},
    {"GetTexLevelParameteriv", ".L.x"}, {"BindTexture", ".h"}, {"GenTextures", "d."}, {"CopyImageSubData", "h.Loooh.Looorrv"}, {"CopyImageSubDataNV", "h.Loooh.Looorrv"}, {"GenSamplers", "d."},
    {"DeleteSamplers", "d."}, {"IsSampler", "h"}, {"BindSampler", "ih"}, {"SamplerParameterf", "h.."},
    {"SamplerParameterfv", "h.."}, {"SamplerParameteri", "h.."}, {"SamplerParameteriv", "h.."},
    {"SamplerParameterIiv", "h.."}, {"SamplerParameterIuiv", "h.."}, {"GetSamplerParameterfv", "h.x"},
    {"GetSamplerParameteriv", "h.x"}, {"GetSamplerParameterIiv", "h.x"}, {"GetSamplerParameterIuiv", "h.x"},
    {"DeleteTextures", "d."}, {"AreTexturesResident", "d.x"}, {"PrioritizeTextures", "d.."},
    {"FeedbackBuffer", "q.x"}, {"SelectBuffer", "qx"}, {"NewList", "h."}, {"CallList", "h"},
    {"CallLists", "d.l"}, {"GenLists", "d"}, {"DeleteLists", "hd"}, {"EvalMesh1", ".gg"},
    {"EvalMesh2", ".gggg"}, {"Map1f", "...tO."}, {"Map1d", "...tO."}, {"Map2f", "...tO..tO."},
    {"Map2d", "...tO..tO."}, {"MapGrid1f", "D.."}, {"MapGrid1d", "D.."}, {"MapGrid2f", "D..D.."},
    {"MapGrid2d", "D..D.."}, {"GetMapfv", "..x"}, {"GetMapdv", "..x"}, {"GetMapiv", "..x"},
    {"GenQueries", "d."}, {"DeleteQueries", "d."}, {"BeginQuery", ".h"}, {"GetQueryObjectiv", "h.x"},
    {"GetQueryObjectuiv", "h.x"}, {"GenRenderbuffers", "d."}, {"DeleteRenderbuffers", "d."},
    {"GenFramebuffers", "d."}, {"DeleteFramebuffers", "d."}, {"BindRenderbuffer", ".h"},
    {"BindRenderbufferEXT", ".h"}, {"BindFramebuffer", ".h"}, {"BindFramebufferEXT", ".h"},
    {"RenderbufferStorage", "..ww"}, {"RenderbufferStorageMultisample", ".n.ww"},
    {"FramebufferTexture1D", "...hL"}, {"FramebufferTexture2D", "...hL"},
    {"FramebufferTexture3D", "...hLo"}, {"FramebufferTextureLayer", "..hLo"},
    {"FramebufferRenderbuffer", "...h"}, {"BlitFramebuffer", "cccccccc.."},
    {"GetFramebufferAttachmentParameteriv", "...x"}, {"GetRenderbufferParameteriv", "..x"},
};
// clang-format on

} // namespace

std::string_view form_of(std::string_view command) {
  static const std::map<std::string_view, std::string_view> forms = [] {
    std::map<std::string_view, std::string_view> all;
    for (const Form& form : kForms) all[form.command] = form.letters;
    return all;
  }();
  const auto found = forms.find(command);
  return found == forms.end() ? std::string_view() : found->second;
}

} // namespace softgl::test
