// The accumulation buffer (4.2.4).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

Test sum(const char* name, const char* sentence, std::function<void(Script&)> body,
         const char* section = "4.2.4") {
  return raster_test(std::string("accumulation.") + name, section, sentence, std::move(body));
}
void background(Script& s) { s.ClearColor(0.1, 0.2, 0.15, 1), s.Clear(GL_COLOR_BUFFER_BIT); }

} // namespace

std::vector<Test> raster_accumulation_tests() {
  return {
      sum("load", "GL_LOAD takes the picture times the value, GL_RETURN brings it back.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.75), background(s), crossing_stripes(s), s.Accum(GL_RETURN, 1);
          }),
      sum("load_again", "GL_LOAD takes the place of what was there.",
          [](Script& s) {
            crossing_stripes(s), s.Accum(GL_LOAD, 1), background(s), stripes(s), s.Accum(GL_LOAD, 0.5),
                background(s), s.Accum(GL_RETURN, 1);
          }),
      sum("accumulate", "GL_ACCUM adds the picture times the value.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.5), background(s), crossing_stripes(s), s.Accum(GL_ACCUM, 0.5),
                s.Accum(GL_RETURN, 1);
          }),
      sum("subtract", "Sums may be less than 0.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, -0.6), background(s), crossing_stripes(s), s.Accum(GL_ACCUM, 0.9),
                s.Accum(GL_RETURN, 1);
          }),
      sum("negative", "Sums below 0 are kept: times less than 0 they are seen.",
          [](Script& s) { stripes(s), s.Accum(GL_LOAD, -0.8), background(s), s.Accum(GL_RETURN, -1); }),
      sum("add", "GL_ADD adds the value to each component.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.5), s.Accum(GL_ADD, 0.3), background(s), s.Accum(GL_RETURN, 1);
          }),
      sum("multiply", "GL_MULT multiplies each component.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 1), s.Accum(GL_MULT, 0.4), background(s), s.Accum(GL_RETURN, 1);
          }),
      sum("multiply_clamped", "The value of GL_MULT is clamped to [-1, 1].",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.5), s.Accum(GL_MULT, 7), background(s), s.Accum(GL_RETURN, 1);
          }),
      sum("return_value", "GL_RETURN multiplies by the value.",
          [](Script& s) { stripes(s), s.Accum(GL_LOAD, 0.25), background(s), s.Accum(GL_RETURN, 3); }),
      sum("return_clamped", "What GL_RETURN brings back is clamped to [0, 1].",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.9), s.Accum(GL_ADD, -0.2), background(s), s.Accum(GL_RETURN, 2.5);
          }),
      sum("return_again", "GL_RETURN does not change the sums.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.5), s.Accum(GL_RETURN, 2), background(s), s.Accum(GL_RETURN, 1);
          }),
      sum("not_blended", "What GL_RETURN brings back is not blended or tested.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.8), background(s), s.Enable(GL_BLEND),
                s.BlendFunc(GL_ZERO, GL_ONE), s.Enable(GL_ALPHA_TEST), s.AlphaFunc(GL_NEVER, 0),
                s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_NEVER), s.Accum(GL_RETURN, 1);
          }),
      sum(
          "color_mask", "The mask of colors is about GL_RETURN.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.8), background(s), s.ColorMask(1, 0, 1, 0), s.Accum(GL_RETURN, 1);
          },
          "4.2.4, 4.2.2"),
      sum(
          "scissor_load", "Only sums in the scissor box are changed.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 1), background(s), s.Scissor(20, 30, 50, 41),
                s.Enable(GL_SCISSOR_TEST), s.Accum(GL_LOAD, 0.5), s.Accum(GL_ADD, 0.25),
                s.Accum(GL_MULT, 0.5), s.Disable(GL_SCISSOR_TEST), s.Accum(GL_RETURN, 1);
          },
          "4.2.4, 4.1.2"),
      sum(
          "scissor_return", "Only pixels in the scissor box are brought back.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.7), background(s), s.Scissor(20, 30, 50, 41),
                s.Enable(GL_SCISSOR_TEST), s.Accum(GL_RETURN, 1);
          },
          "4.2.4, 4.1.2"),
      sum(
          "clear", "The accumulation buffer is cleared to the values that were set.",
          [](Script& s) {
            stripes(s), s.ClearAccum(-0.4, 0.5, 0.25, 0.3), s.Clear(GL_ACCUM_BUFFER_BIT),
                s.Accum(GL_ACCUM, 0.5), background(s), s.Accum(GL_RETURN, 1);
          },
          "4.2.3"),
      sum(
          "clear_clamped", "The values of a clear are clamped to [-1, 1].",
          [](Script& s) {
            stripes(s), s.ClearAccum(-7, 0.5, 2, 0.5), s.Clear(GL_ACCUM_BUFFER_BIT), s.Accum(GL_MULT, 0.5),
                s.Accum(GL_ACCUM, 0.5), background(s), s.Accum(GL_RETURN, 1);
          },
          "4.2.3"),
      sum(
          "clear_scissor", "A clear of the accumulation buffer stays in the scissor box.",
          [](Script& s) {
            stripes(s), s.Accum(GL_LOAD, 0.5), s.ClearAccum(0.9, 0.5, 0.1, 1), s.Scissor(20, 30, 50, 41),
                s.Enable(GL_SCISSOR_TEST), s.Clear(GL_ACCUM_BUFFER_BIT), s.Disable(GL_SCISSOR_TEST),
                background(s), s.Accum(GL_RETURN, 1);
          },
          "4.2.3, 4.1.2"),
      sum(
          "clear_saved", "GL_ACCUM_BUFFER_BIT brings back the values of a clear.",
          [](Script& s) {
            stripes(s), s.ClearAccum(0.5, 0.25, 0, 0.3), s.PushAttrib(GL_ACCUM_BUFFER_BIT),
                s.ClearAccum(0, 0, 1, 0), s.PopAttrib(), s.Clear(GL_ACCUM_BUFFER_BIT), s.Accum(GL_ACCUM, 0.5),
                s.Accum(GL_RETURN, 1);
          },
          "6.1.14, table 6.23"),
      sum(
          "list", "A list holds glAccum.",
          [](Script& s) {
            stripes(s), s.NewList(5, GL_COMPILE), s.Accum(GL_ACCUM, 0.25), s.EndList(),
                s.ClearAccum(0, 0, 0, 0), s.Clear(GL_ACCUM_BUFFER_BIT);
            for (int i = 0; i < 3; i++) s.CallList(5);
            background(s), s.Accum(GL_RETURN, 1);
          },
          "5.4"),
  };
}

} // namespace softgl::suite
