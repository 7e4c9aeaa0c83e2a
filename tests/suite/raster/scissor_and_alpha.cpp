// The scissor test and the alpha test (4.1.2, 4.1.4).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

Test scissored(const char* name, const char* section, const char* sentence,
               std::function<void(Script&)> body) {
  return raster_test(std::string("scissor.") + name, section, sentence, std::move(body));
}
void set_scissor(Script& s, int left, int bottom, int width, int height) {
  s.Scissor(left, bottom, width, height), s.Enable(GL_SCISSOR_TEST);
}

// Stripes of rising alpha; one of 0, one of 1.
void alpha_stripes(Script& s, double bottom, double top) {
  for (int i = 0; i < 9; i++)
    s.Color4f(1 - 0.1 * i, 0.1 + 0.1 * i, 0.8, 0.125 * i), box(s, 3 + 10 * i, bottom, 12 + 10 * i, top);
}
Test alpha_compared(const char* name, GLenum function) {
  return raster_test(std::string("alpha.") + name, "4.1.4",
                     "A fragment passes if its alpha compares so with the reference.", [=](Script& s) {
                       s.Enable(GL_ALPHA_TEST), s.AlphaFunc(function, 0.44), alpha_stripes(s, 5, 35);
                       s.AlphaFunc(function, 1), alpha_stripes(s, 38, 60), s.AlphaFunc(function, 0),
                           alpha_stripes(s, 63, 82);
                       s.Disable(GL_ALPHA_TEST), tint(s, 3), box(s, 3, 85, 92, 93);
                     });
}

} // namespace

std::vector<Test> raster_scissor_and_alpha_tests() {
  std::vector<Test> tests = {
      scissored("box", "4.1.2", "What lies outside of the box is not drawn.",
                [](Script& s) { set_scissor(s, 20, 30, 41, 23), mesh(s, -1, -1, 1, 1, 4); }),
      scissored("lines_and_points", "4.1.2", "The box cuts lines and points.",
                [](Script& s) {
                  set_scissor(s, 23, 25, 47, 43), s.LineWidth(4), star(s), s.PointSize(15),
                      s.Begin(GL_POINTS);
                  tint(s, 5), pixel_vertex(s, 25.2, 27.3), pixel_vertex(s, 68.2, 66.3), s.End();
                }),
      scissored("empty", "4.1.2", "A box without width lets nothing through.",
                [](Script& s) {
                  mesh(s, -0.8, -0.8, 0.8, 0.8, 3), set_scissor(s, 20, 20, 0, 50), tint(s, 6),
                      box(s, 0, 0, 96, 96);
                }),
      scissored("beyond_the_window", "4.1.2", "A box may reach beyond the window.",
                [](Script& s) { set_scissor(s, -30, -20, 80, 77), mesh(s, -1, -1, 1, 1, 4); }),
      scissored("off", "4.1.2", "Without GL_SCISSOR_TEST the box does nothing.",
                [](Script& s) {
                  s.Scissor(20, 20, 5, 5), s.Disable(GL_SCISSOR_TEST), mesh(s, -0.8, -0.8, 0.8, 0.8, 3);
                }),
      scissored("of_the_window", "4.1.2", "The box is the window at first.",
                [](Script& s) { s.Enable(GL_SCISSOR_TEST), mesh(s, -1.1, -1.1, 1.1, 1.1, 3); }),
      scissored("clear", "4.2.3", "A clear of colors stays in the box.",
                [](Script& s) {
                  set_scissor(s, 10, 50, 61, 33), s.ClearColor(0.9, 0.5, 0.1, 1),
                      s.Clear(GL_COLOR_BUFFER_BIT), arrow(s);
                }),
      scissored("saved", "6.1.14, table 6.19", "GL_SCISSOR_BIT brings back box and switch.",
                [](Script& s) {
                  set_scissor(s, 20, 30, 41, 23), s.PushAttrib(GL_SCISSOR_BIT), s.Scissor(0, 0, 5, 5),
                      s.Disable(GL_SCISSOR_TEST), s.PopAttrib(), mesh(s, -1, -1, 1, 1, 4);
                }),
      raster_test("alpha.reference_clamped", "4.1.4", "The reference is clamped to [0, 1].",
                  [](Script& s) {
                    s.Enable(GL_ALPHA_TEST), s.AlphaFunc(GL_GEQUAL, 3), alpha_stripes(s, 5, 45);
                    s.AlphaFunc(GL_LEQUAL, -2), alpha_stripes(s, 50, 90);
                  }),
      raster_test("alpha.not_clears", "4.2.3", "The alpha test does not matter to clears.",
                  [](Script& s) {
                    s.Enable(GL_ALPHA_TEST), s.AlphaFunc(GL_NEVER, 0), s.ClearColor(0.2, 0.8, 0.3, 0.5),
                        s.Clear(GL_COLOR_BUFFER_BIT), alpha_stripes(s, 10, 50), s.Disable(GL_ALPHA_TEST),
                        arrow(s);
                  }),
      raster_test("alpha.not_depths", "4.1.4", "A fragment that fails the alpha test leaves no depth.",
                  [](Script& s) {
                    s.Enable(GL_DEPTH_TEST), s.Enable(GL_ALPHA_TEST), s.AlphaFunc(GL_GREATER, 0.3),
                        s.Translatef(0, 0, 1), alpha_stripes(s, 20, 70), s.Translatef(0, 0, -2),
                        s.Color4f(0.9, 0.9, 0.2, 1), box(s, 6, 10, 90, 60);
                  }),
      raster_test("alpha.saved", "6.1.14, table 6.19", "GL_COLOR_BUFFER_BIT brings back the alpha test.",
                  [](Script& s) {
                    s.Enable(GL_ALPHA_TEST), s.AlphaFunc(GL_LESS, 0.44), s.PushAttrib(GL_COLOR_BUFFER_BIT),
                        s.Disable(GL_ALPHA_TEST), s.AlphaFunc(GL_NEVER, 0), s.PopAttrib(),
                        alpha_stripes(s, 10, 80);
                  }),
  };
  for (const auto& [name, function] : kComparisons) tests.push_back(alpha_compared(name, function));
  return tests;
}

} // namespace softgl::suite
