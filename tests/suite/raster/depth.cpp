// The depth buffer test (4.1.6), its mask (4.2.2) and clear (4.2.3).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

Test depth(const std::string& name, const char* section, const char* sentence,
           std::function<void(Script&)> body) {
  return raster_test("depth." + name, section, sentence, std::move(body));
}

// Four stripes at a depth, which are drawn again before it, at it and behind it.
Test compared(const char* name, GLenum function) {
  return depth(
      name, "4.1.6", "A fragment passes if its depth compares so with that of the buffer.", [=](Script& s) {
        s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_ALWAYS), tint(s, 2);
        for (int i = 0; i < 4; i++) box(s, 8 + 20 * i, 8, 28 + 20 * i, 80);
        s.DepthFunc(function), tint(s, 0), box(s, 8, 8, 28, 80), tint(s, 1), box(s, 28, 20, 48, 70, 2);
        tint(s, 3), box(s, 48, 20, 68, 70, -2), s.DepthFunc(GL_ALWAYS), tint(s, 5), box(s, 8, 84, 88, 92);
      });
}

} // namespace

std::vector<Test> raster_depth_tests() {
  std::vector<Test> tests;
  for (const auto& [name, function] : kComparisons) tests.push_back(compared(name, function));
  for (Test& test : std::vector<Test>{
           depth("mask", "4.2.2", "Without glDepthMask depths are compared, and not written.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), s.DepthMask(0), tint(s, 0), box(s, 10, 10, 50, 60, 2),
                       s.DepthMask(1), tint(s, 1), box(s, 30, 30, 70, 80, -1), tint(s, 2),
                       box(s, 40, 20, 90, 50, -3);
                   s.DepthMask(0), tint(s, 3), box(s, 50, 60, 90, 90, -2);
                 }),
           depth("off", "4.1.6", "Without the depth test no depth is compared or written.",
                 [](Script& s) {
                   s.DepthFunc(GL_LESS), tint(s, 0), box(s, 10, 10, 60, 60, 2), s.Enable(GL_DEPTH_TEST),
                       tint(s, 1), box(s, 30, 30, 80, 80, -1), s.Disable(GL_DEPTH_TEST), tint(s, 2),
                       box(s, 50, 20, 90, 50, -5);
                 }),
           depth("clear", "4.2.3",
                 "The depth buffer is cleared to the depth that was set, in the scissor box.",
                 [](Script& s) {
                   s.ClearDepth(0.1), s.Scissor(30, 20, 40, 50), s.Enable(GL_SCISSOR_TEST),
                       s.Clear(GL_DEPTH_BUFFER_BIT), s.Disable(GL_SCISSOR_TEST), s.Enable(GL_DEPTH_TEST);
                   mesh(s, -0.95, -0.95, 0.95, 0.95, 4), tint(s, 6), box(s, 20, 30, 80, 40, 3.5);
                 }),
           depth("clear_clamped", "4.2.3", "The depth of a clear is clamped to [0, 1].",
                 [](Script& s) {
                   s.ClearDepth(-3), s.Clear(GL_DEPTH_BUFFER_BIT), s.Enable(GL_DEPTH_TEST), tint(s, 0),
                       box(s, 5, 5, 60, 90, 3), s.DepthFunc(GL_GREATER), tint(s, 1), box(s, 20, 5, 90, 40, 3);
                   s.ClearDepth(7), s.Clear(GL_DEPTH_BUFFER_BIT), tint(s, 2), box(s, 30, 30, 90, 60, -14);
                   s.DepthFunc(GL_LESS), tint(s, 3), box(s, 10, 60, 90, 90, -14);
                 }),
           depth("clear_masked", "4.2.3", "Without the depth mask a clear leaves the depths.",
                 [](Script& s) {
                   s.DepthMask(0), s.ClearDepth(0), s.Clear(GL_DEPTH_BUFFER_BIT), s.DepthMask(1),
                       s.Enable(GL_DEPTH_TEST), arrow(s);
                 }),
           depth("range", "2.11.1, 4.1.6", "The depth range is that of window depths, and may be turned.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), s.DepthRange(0.5, 0.7), tint(s, 0), box(s, 10, 10, 60, 60, 3),
                       s.DepthRange(0.0, 0.4), tint(s, 1), box(s, 30, 30, 80, 80, -13),
                       s.DepthRange(1.0, 0.0);
                   tint(s, 2), box(s, 50, 5, 90, 40, -14), tint(s, 3), box(s, 5, 50, 40, 90, 3);
                 }),
           depth("replaced", "4.1.6", "The depth that passes takes the place of the one before.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_GREATER), s.ClearDepth(0.0),
                       s.Clear(GL_DEPTH_BUFFER_BIT);
                   tint(s, 0), box(s, 10, 10, 60, 60, 2), tint(s, 1), box(s, 20, 20, 70, 70, -4), tint(s, 2),
                       box(s, 30, 30, 90, 90, 0);
                 }),
           depth("saved", "6.1.14, table 6.20",
                 "GL_DEPTH_BUFFER_BIT brings back the test, its function and the mask.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_GREATER), s.ClearDepth(0.2),
                       s.Clear(GL_DEPTH_BUFFER_BIT), s.PushAttrib(GL_DEPTH_BUFFER_BIT),
                       s.Disable(GL_DEPTH_TEST), s.DepthFunc(GL_NEVER), s.DepthMask(0), s.ClearDepth(0.9),
                       s.PopAttrib();
                   arrow(s), tint(s, 6), box(s, 30, 30, 80, 60, 2), s.Clear(GL_DEPTH_BUFFER_BIT), tint(s, 5),
                       box(s, 5, 70, 90, 90, -4);
                 }),
       })
    tests.push_back(std::move(test));
  return tests;
}

} // namespace softgl::suite
