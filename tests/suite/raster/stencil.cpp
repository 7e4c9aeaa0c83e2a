// The stencil test (4.1.5), its mask (4.2.2) and clear (4.2.3).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kWrap{14, "GL_EXT_stencil_wrap"};
constexpr std::tuple<const char*, GLenum, Need> kOperations[] = {{"keep", GL_KEEP, {}},
                                                                 {"zero", GL_ZERO, {}},
                                                                 {"replace", GL_REPLACE, {}},
                                                                 {"incr", GL_INCR, {}},
                                                                 {"decr", GL_DECR, {}},
                                                                 {"invert", GL_INVERT, {}},
                                                                 {"incr_wrap", GL_INCR_WRAP, kWrap},
                                                                 {"decr_wrap", GL_DECR_WRAP, kWrap}};

// Stripes of stencil values 0 to 7 and of 255, which are not seen.
void stencil_stripes(Script& s) {
  s.ClearStencil(0), s.Clear(GL_STENCIL_BUFFER_BIT), s.Enable(GL_STENCIL_TEST), s.ColorMask(0, 0, 0, 0);
  s.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  for (int i = 0; i < 9; i++)
    s.StencilFunc(GL_ALWAYS, i == 8 ? 255 : i, 255), box(s, 4 + 10 * i, 8, 14 + 10 * i, 88);
  s.ColorMask(1, 1, 1, 1);
}
// Makes values of the stencil buffer seen: a color for each of `values`.
void show_stencil(Script& s, std::initializer_list<int> values) {
  s.Disable(GL_DEPTH_TEST), s.Enable(GL_STENCIL_TEST), s.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP),
      s.StencilMask(255);
  int i = 0;
  for (int value : values) s.StencilFunc(GL_EQUAL, value, 255), tint(s, i++), box(s, 4, 4, 94, 92);
}

Test stencil(const std::string& name, const char* section, const char* sentence,
             std::function<void(Script&)> body, Need need = {}) {
  return raster_test("stencil." + name, section, sentence, std::move(body), need);
}

Test operation(const char* name, GLenum op, int which, Need need) {
  static const char* const kWhere[] = {"fail_", "depth_fail_", "depth_pass_"};
  static const char* const kSentences[] = {
      "The first operation is that of fragments that fail the stencil test.",
      "The second operation is that of fragments that fail the depth test.",
      "The third operation is that of fragments that pass both tests."};
  return stencil(
      std::string(kWhere[which]) + name, "4.1.5", kSentences[which],
      [=](Script& s) {
        stencil_stripes(s), s.Enable(GL_DEPTH_TEST), s.ColorMask(0, 0, 0, 0),
            s.DepthFunc(which == 1 ? GL_NEVER : GL_ALWAYS);
        // The other operations would be seen.
        GLenum operations[3] = {GL_ZERO, GL_ZERO, GL_ZERO};
        if (op == GL_ZERO) std::fill(operations, operations + 3, GLenum(GL_KEEP));
        operations[which] = op;
        s.StencilOp(operations[0], operations[1], operations[2]),
            s.StencilFunc(which == 0 ? GL_NEVER : GL_ALWAYS, 5, 255);
        box(s, 4, 30, 94, 66), s.ColorMask(1, 1, 1, 1);
        show_stencil(s, {0, 1, 2, 3, 4, 5, 6, 7, 8, 255, 254, 253, 252, 251, 250, 249, 248});
      },
      need);
}

} // namespace

std::vector<Test> raster_stencil_tests() {
  std::vector<Test> tests = {
      stencil("mask", "4.1.5", "Reference and value are compared in the bits of the mask.",
              [](Script& s) {
                stencil_stripes(s), s.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP), s.StencilFunc(GL_EQUAL, 6, 2);
                mesh(s, -1, -0.8, 1, 0.8, 4);
              }),
      stencil("write_mask", "4.2.2", "Only the bits of glStencilMask are written.",
              [](Script& s) {
                stencil_stripes(s), s.StencilMask(5), s.ColorMask(0, 0, 0, 0),
                    s.StencilOp(GL_KEEP, GL_KEEP, GL_INVERT), s.StencilFunc(GL_ALWAYS, 0, 255);
                box(s, 4, 30, 94, 66), s.ColorMask(1, 1, 1, 1),
                    show_stencil(s, {0, 1, 2, 3, 4, 5, 6, 7, 255, 250});
              }),
      stencil("write_mask_replace", "4.2.2", "Only the bits of glStencilMask are written.",
              [](Script& s) {
                stencil_stripes(s), s.StencilMask(3), s.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE),
                    s.StencilFunc(GL_ALWAYS, 9, 255), tint(s, 2);
                box(s, 4, 30, 94, 66), show_stencil(s, {0, 1, 2, 3, 4, 5, 6, 7, 255, 253});
              }),
      stencil("reference_clamped", "4.1.5", "The reference is clamped to the greatest stencil value.",
              [](Script& s) {
                s.ClearStencil(0), s.Clear(GL_STENCIL_BUFFER_BIT), s.Enable(GL_STENCIL_TEST),
                    s.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE), s.StencilFunc(GL_ALWAYS, 70000, ~0u);
                tint(s, 5), box(s, 20, 20, 70, 70), s.StencilFunc(GL_ALWAYS, -5, ~0u), box(s, 30, 30, 50, 50);
                show_stencil(s, {0, 255});
              }),
      stencil("saturates", "4.1.5", "GL_INCR and GL_DECR stop at the ends.",
              [](Script& s) {
                s.ClearStencil(254), s.Clear(GL_STENCIL_BUFFER_BIT), s.Enable(GL_STENCIL_TEST),
                    s.StencilFunc(GL_ALWAYS, 0, 255), s.StencilOp(GL_KEEP, GL_KEEP, GL_INCR), tint(s, 6);
                for (int i = 0; i < 3; i++) box(s, 8, 8, 30 + 25 * i, 50);
                s.StencilOp(GL_KEEP, GL_KEEP, GL_ZERO), box(s, 8, 56, 88, 88),
                    s.StencilOp(GL_KEEP, GL_KEEP, GL_DECR), box(s, 8, 60, 50, 80),
                    show_stencil(s, {0, 1, 253, 254, 255});
              }),
      stencil("without_depth_test", "4.1.6", "Without the depth test it is as if it passed.",
              [](Script& s) {
                stencil_stripes(s), s.DepthFunc(GL_NEVER), s.Disable(GL_DEPTH_TEST),
                    s.StencilOp(GL_KEEP, GL_ZERO, GL_INCR), s.StencilFunc(GL_ALWAYS, 0, 255), tint(s, 2);
                box(s, 4, 30, 94, 66), show_stencil(s, {0, 1, 2, 3, 4, 5, 6, 7, 8, 255});
              }),
      stencil("before_depth", "4.1.5, 4.1.6", "A fragment that fails the stencil test leaves no depth.",
              [](Script& s) {
                stencil_stripes(s), s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_ALWAYS),
                    s.StencilFunc(GL_LESS, 3, 255), s.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP), tint(s, 1),
                    box(s, 4, 20, 94, 60, 2), s.DepthFunc(GL_LESS), s.Disable(GL_STENCIL_TEST), tint(s, 3),
                    box(s, 10, 10, 86, 50, 0);
              }),
      stencil("off", "4.1.5", "Without GL_STENCIL_TEST stencil values neither matter nor change.",
              [](Script& s) {
                stencil_stripes(s), s.StencilFunc(GL_NEVER, 0, 255), s.StencilOp(GL_ZERO, GL_ZERO, GL_ZERO),
                    s.Disable(GL_STENCIL_TEST), tint(s, 6), box(s, 4, 30, 94, 96);
                s.Enable(GL_STENCIL_TEST), s.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
                for (int i = 0; i < 8; i++) s.StencilFunc(GL_EQUAL, i, 255), tint(s, i), box(s, 4, 4, 94, 60);
              }),
      stencil("clear", "4.2.3", "The stencil buffer is cleared to the value that was set, in its bits.",
              [](Script& s) {
                s.ClearStencil(0x705), s.Clear(GL_STENCIL_BUFFER_BIT), s.ClearStencil(-1),
                    s.Scissor(20, 20, 40, 50), s.Enable(GL_SCISSOR_TEST), s.Clear(GL_STENCIL_BUFFER_BIT),
                    s.Disable(GL_SCISSOR_TEST);
                show_stencil(s, {0, 5, 255});
              }),
      stencil("clear_masked", "4.2.3", "A clear of the stencil buffer writes the bits of the mask only.",
              [](Script& s) {
                stencil_stripes(s), s.StencilMask(2), s.ClearStencil(7), s.Clear(GL_STENCIL_BUFFER_BIT);
                show_stencil(s, {0, 1, 2, 3, 4, 5, 6, 7});
              }),
      stencil("clear_not_tested", "4.2.3", "The stencil test does not matter to clears.",
              [](Script& s) {
                stencil_stripes(s), s.StencilFunc(GL_NEVER, 0, 255), s.StencilOp(GL_ZERO, GL_ZERO, GL_ZERO),
                    s.ClearColor(0.1, 0.5, 0.6, 1), s.Clear(GL_COLOR_BUFFER_BIT), show_stencil(s, {3, 4, 5});
              }),
      stencil("saved", "6.1.14, table 6.20", "GL_STENCIL_BUFFER_BIT brings back the test and its parameters.",
              [](Script& s) {
                stencil_stripes(s), s.StencilFunc(GL_EQUAL, 2, 3), s.StencilOp(GL_KEEP, GL_KEEP, GL_INCR),
                    s.StencilMask(15), s.PushAttrib(GL_STENCIL_BUFFER_BIT);
                s.StencilFunc(GL_NEVER, 0, 1), s.StencilOp(GL_ZERO, GL_ZERO, GL_ZERO), s.StencilMask(0),
                    s.Disable(GL_STENCIL_TEST), s.PopAttrib(), tint(s, 0), box(s, 4, 30, 94, 66);
                show_stencil(s, {0, 1, 3, 4, 5, 7});
              }),
  };
  for (const auto& [name, function] : kComparisons)
    tests.push_back(stencil(name, "4.1.5",
                            "A fragment passes if the reference compares so with the stencil value.",
                            [function = function](Script& s) {
                              stencil_stripes(s), s.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP),
                                  s.StencilFunc(function, 3, 255), mesh(s, -1.1, -0.8, 1.1, 0.8, 4);
                              s.Disable(GL_STENCIL_TEST), tint(s, 3), box(s, 4, 84, 92, 94);
                            }));
  for (int which = 0; which < 3; which++)
    for (const auto& [name, op, need] : kOperations) tests.push_back(operation(name, op, which, need));
  return tests;
}

} // namespace softgl::suite
