// Blending, dithering and logic operations (4.1.8 to 4.1.10).
#include "raster/chapter.h"
#include "raster/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kBlendSquare{14, "GL_NV_blend_square"}, kSeparate{14};

Test blended(const std::string& name, GLenum source, GLenum destination, Need need = {}) {
  return raster_test(
      "blend." + name, "4.1.8, table 4.1",
      "Source and destination are multiplied by their factors and added.",
      [=](Script& s) {
        stripes(s), s.BlendFunc(source, destination), s.Enable(GL_BLEND);
        if (need.version == kImaging.version && need.extension == kImaging.extension)
          s.BlendColor(0.7, 0.3, 0.9, 0.4);
        crossing_stripes(s);
      },
      need);
}
Test joined_by(const char* name, GLenum equation) {
  return raster_test(
      std::string("blend.equation_") + name, "4.1.8", "The blend equation says how the two are joined.",
      [=](Script& s) {
        stripes(s), s.BlendEquation(equation), s.BlendFunc(GL_ONE, GL_SRC_ALPHA), s.Enable(GL_BLEND),
            crossing_stripes(s);
      },
      kImaging);
}
Test logic(const char* name, GLenum operation) {
  return raster_test(std::string("logic.") + name, "4.1.10, table 4.2",
                     "The bits of source and destination are joined by the operation.", [=](Script& s) {
                       stripes(s), s.LogicOp(operation), s.Enable(GL_COLOR_LOGIC_OP), crossing_stripes(s);
                     });
}
Test other(const char* name, const char* section, const char* sentence, std::function<void(Script&)> body,
           Need need = {}) {
  return raster_test(name, section, sentence, std::move(body), need);
}

constexpr std::pair<const char*, GLenum> kOperations[] = {{"clear", GL_CLEAR},
                                                          {"and", GL_AND},
                                                          {"and_reverse", GL_AND_REVERSE},
                                                          {"copy", GL_COPY},
                                                          {"and_inverted", GL_AND_INVERTED},
                                                          {"noop", GL_NOOP},
                                                          {"xor", GL_XOR},
                                                          {"or", GL_OR},
                                                          {"nor", GL_NOR},
                                                          {"equiv", GL_EQUIV},
                                                          {"invert", GL_INVERT},
                                                          {"or_reverse", GL_OR_REVERSE},
                                                          {"copy_inverted", GL_COPY_INVERTED},
                                                          {"or_inverted", GL_OR_INVERTED},
                                                          {"nand", GL_NAND},
                                                          {"set", GL_SET}};
constexpr std::pair<const char*, GLenum> kFactors[] = {
    {"zero", GL_ZERO},           {"one", GL_ONE},
    {"src_alpha", GL_SRC_ALPHA}, {"one_minus_src_alpha", GL_ONE_MINUS_SRC_ALPHA},
    {"dst_alpha", GL_DST_ALPHA}, {"one_minus_dst_alpha", GL_ONE_MINUS_DST_ALPHA}};

} // namespace

std::vector<Test> raster_blend_tests() {
  std::vector<Test> tests;
  for (const auto& [name, factor] : kFactors) {
    tests.push_back(blended(std::string("source_") + name, factor, GL_ONE));
    tests.push_back(blended(std::string("destination_") + name, GL_ONE, factor));
  }
  for (Test& test : std::vector<Test>{
           blended("source_dst_color", GL_DST_COLOR, GL_ZERO),
           blended("source_one_minus_dst_color", GL_ONE_MINUS_DST_COLOR, GL_ONE),
           blended("source_alpha_saturate", GL_SRC_ALPHA_SATURATE, GL_ONE),
           blended("destination_src_color", GL_ZERO, GL_SRC_COLOR),
           blended("destination_one_minus_src_color", GL_ONE, GL_ONE_MINUS_SRC_COLOR),
           blended("transparency", GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA),
           blended("source_src_color", GL_SRC_COLOR, GL_ONE, kBlendSquare),
           blended("source_one_minus_src_color", GL_ONE_MINUS_SRC_COLOR, GL_ONE, kBlendSquare),
           blended("destination_dst_color", GL_ONE, GL_DST_COLOR, kBlendSquare),
           blended("destination_one_minus_dst_color", GL_ONE, GL_ONE_MINUS_DST_COLOR, kBlendSquare),
           blended("constant_color", GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR, kImaging),
           blended("one_minus_constant_color", GL_ONE_MINUS_CONSTANT_COLOR, GL_CONSTANT_COLOR, kImaging),
           blended("constant_alpha", GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, kImaging),
           blended("one_minus_constant_alpha", GL_ONE_MINUS_CONSTANT_ALPHA, GL_CONSTANT_ALPHA, kImaging),
           joined_by("add", GL_FUNC_ADD),
           joined_by("subtract", GL_FUNC_SUBTRACT),
           joined_by("reverse_subtract", GL_FUNC_REVERSE_SUBTRACT),
           other(
               "blend.equation_min", "4.1.8", "With GL_MIN factors do not matter.",
               [](Script& s) {
                 stripes(s), s.BlendEquation(GL_MIN), s.BlendFunc(GL_ZERO, GL_ZERO), s.Enable(GL_BLEND),
                     crossing_stripes(s);
               },
               kImaging),
           other(
               "blend.equation_max", "4.1.8", "With GL_MAX factors do not matter.",
               [](Script& s) {
                 stripes(s), s.BlendEquation(GL_MAX), s.BlendFunc(GL_ZERO, GL_ZERO), s.Enable(GL_BLEND),
                     crossing_stripes(s);
               },
               kImaging),
           other(
               "blend.constant_clamped", "4.1.8", "The constant color is clamped to [0, 1].",
               [](Script& s) {
                 stripes(s), s.BlendColor(2.5, -1, 0.5, 7),
                     s.BlendFunc(GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR), s.Enable(GL_BLEND),
                     crossing_stripes(s);
               },
               kImaging),
           other(
               "blend.separate", "4.1.8", "Factors of alpha may differ from those of red, green and blue.",
               [](Script& s) {
                 stripes(s), s.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE),
                     s.Enable(GL_BLEND), crossing_stripes(s);
                 s.BlendFuncSeparate(GL_DST_ALPHA, GL_ZERO, GL_ONE, GL_ZERO), s.Color4f(1, 0.9, 0.8, 0.7),
                     box(s, 4, 30, 90, 40);
               },
               kSeparate),
           other("blend.overdraw", "4.1.8", "Each fragment is blended with what all before it have left.",
                 [](Script& s) {
                   s.Enable(GL_BLEND), s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                   for (int i = 0; i < 4; i++)
                     s.Color4f(0.9 - 0.2 * i, 0.3 * i, 0.5, 0.5),
                         box(s, 10 + 9 * i, 8 + 10 * i, 50 + 10 * i, 50 + 11 * i);
                 }),
           other("blend.clamped", "4.1.8", "What comes of blending is clamped to [0, 1].",
                 [](Script& s) {
                   s.Enable(GL_BLEND), s.BlendFunc(GL_ONE, GL_ONE);
                   for (int i = 0; i < 4; i++)
                     s.Color4f(0.9, 0.4, 0.1 * i, 0.5), box(s, 10, 10, 40 + 15 * i, 85);
                 }),
           other("blend.off", "4.1.8", "Without GL_BLEND the fragment takes the place of the pixel.",
                 [](Script& s) {
                   stripes(s), s.BlendFunc(GL_ZERO, GL_ONE), s.Disable(GL_BLEND), crossing_stripes(s);
                 }),
           other("blend.saved", "6.1.14, table 6.21", "GL_COLOR_BUFFER_BIT brings back blending.",
                 [](Script& s) {
                   stripes(s), s.BlendFunc(GL_SRC_ALPHA, GL_ONE), s.Enable(GL_BLEND),
                       s.PushAttrib(GL_COLOR_BUFFER_BIT), s.BlendFunc(GL_ZERO, GL_ZERO), s.Disable(GL_BLEND),
                       s.PopAttrib(), crossing_stripes(s);
                 }),
           other("dither.colors", "4.1.9", "A color that is dithered is one of the two nearest.",
                 [](Script& s) { s.Enable(GL_DITHER), mesh(s, -1, -1, 1, 1, 4); }),
           other("logic.not_blended", "4.1.10", "With a logic operation it is as if blending were off.",
                 [](Script& s) {
                   stripes(s), s.LogicOp(GL_XOR), s.Enable(GL_COLOR_LOGIC_OP), s.BlendFunc(GL_ZERO, GL_ONE),
                       s.Enable(GL_BLEND), crossing_stripes(s);
                 }),
           other("logic.erased", "4.1.10, A.2", "A primitive that is drawn twice with GL_XOR is gone.",
                 [](Script& s) {
                   stripes(s), s.LogicOp(GL_XOR), s.Enable(GL_COLOR_LOGIC_OP), tint(s, 3);
                   for (int i = 0; i < 2; i++) box(s, 20, 20, 70, 70);
                   s.PaintSame(24, 10, 24, 40, 40, 20, 0, 0);
                 }),
           other("logic.saved", "6.1.14, table 6.21", "GL_COLOR_BUFFER_BIT brings back the logic operation.",
                 [](Script& s) {
                   stripes(s), s.LogicOp(GL_EQUIV), s.Enable(GL_COLOR_LOGIC_OP),
                       s.PushAttrib(GL_COLOR_BUFFER_BIT), s.LogicOp(GL_CLEAR), s.Disable(GL_COLOR_LOGIC_OP),
                       s.PopAttrib(), crossing_stripes(s);
                 }),
       })
    tests.push_back(std::move(test));
  for (const auto& [name, operation] : kOperations) tests.push_back(logic(name, operation));
  return tests;
}

} // namespace softgl::suite
