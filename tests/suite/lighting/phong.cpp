// GL_WIN_phong_shading: lighting for each fragment, of polygons whose vertices alone would give another
// picture.
#include "lighting/chapter.h"
#include "lighting/scenes.h"

namespace softgl::suite {
namespace {

const char* const kSection = "GL_WIN_phong_shading";
constexpr Need kPhong{kNoVersion, "GL_WIN_phong_shading", true};

Test phong(const char* name, const char* sentence, std::function<void(Script&)> body) {
  return {std::string("lighting.phong.") + name,
          kSection,
          sentence,
          "whether interpolated normals are normalized",
          [body = std::move(body)](Script& s) { s.ShadeModel(GL_PHONG_WIN), body(s); },
          kPhong};
}

// Two triangles, whose vertices have normals that bend away from the viewer.
const Dome kBent{.cells = 1, .tilt = 0.6};
const Dome kFlat{.cells = 1, .tilt = 0};

void white_texture_of_half(Script& s) {
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  std::vector<double> texels;
  for (int i = 0; i < 4; i++)
    for (double component : {255, 128, 64, 255}) texels.push_back(component);
  s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               Memory{GL_UNSIGNED_BYTE, texels});
  s.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE), s.Enable(GL_TEXTURE_2D);
}

} // namespace

std::vector<Test> lighting_phong_tests() {
  return {
      phong("normal", "The normal is interpolated, and each fragment lit with its own.",
            [](Script& s) {
              diffuse_scene(s, {1, 1, 1, 0}), dome(s, kBent);
            }),
      phong("highlight_inside", "A highlight may lie inside of a triangle whose vertices have none.",
            [](Script& s) {
              specular_scene(s, {0.2, -0.3, 1, 0}, 40), dome(s, kBent);
            }),
      phong("eye_coordinates", "The eye coordinates are interpolated, and with them the vector to the light.",
            [](Script& s) {
              diffuse_scene(s, {0.3, 0.2, 0.6, 1}), dome(s, kFlat);
            }),
      phong("highlight_of_near_light", "The half vector of a light at a point is taken at each fragment.",
            [](Script& s) {
              specular_scene(s, {0.3, 0.2, 0.6, 1}, 12), dome(s, kFlat);
            }),
      phong("attenuation", "The distance to the light is that of the fragment.",
            [](Script& s) {
              diffuse_scene(s, {-0.3, 0.2, 0.5, 1}, {1, 0.8, 0.6, 1}),
                  s.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.3);
              s.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.5),
                  s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.9), dome(s, kFlat);
            }),
      phong("spot_edge", "The edge of a spotlight's cone is round inside of a triangle.",
            [](Script& s) {
              diffuse_scene(s, {0.2, 0.1, 1.2, 1}, {1, 0.8, 0.6, 1}),
                  s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25.0), dome(s, kFlat);
            }),
      phong("spot_exponent", "A spotlight gets weaker towards its rim within a triangle.",
            [](Script& s) {
              diffuse_scene(s, {0.2, 0.1, 1.2, 1}, {1, 0.8, 0.6, 1}),
                  s.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 20.0), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 80.0);
              dome(s, kFlat);
            }),
      phong("local_viewer", "A local viewer sees each fragment from its own direction.",
            [](Script& s) {
              specular_scene(s, {0.5, 0.5, 2, 0}, 20), s.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
              s.LoadIdentity(), s.Translatef(0, 0, -1.6), dome(s, kFlat);
            }),
      phong("two_lights", "The lights are added at each fragment.",
            [](Script& s) {
              diffuse_scene(s, {0.5, 0, 0.6, 1}, {0.6, 0.1, 0.1, 1}), lamp(s, GL_LIGHT1, V{-0.5, 0, 0.6, 1});
              s.Lightfv(GL_LIGHT1, GL_DIFFUSE, V{0.1, 0.3, 0.7, 1}), dome(s, kFlat);
            }),
      phong("clamped", "The color of a fragment is clamped, not that of the vertices.",
            [](Script& s) {
              diffuse_scene(s, {0, 0, 0.6, 1}, {3, 2, 1, 1}),
                  s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 1.0);
              dome(s, kFlat);
            }),
      phong("constant_terms", "Emission and the ambient terms are added at each fragment, too.",
            [](Script& s) {
              diffuse_scene(s, {0.3, 0.2, 0.6, 1}, {0.4, 0.4, 0.4, 1}),
                  s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.1, 0.2, 0, 1});
              s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.2, 0.1, 0.3, 1}),
                  s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.5, 1, 0.5, 1});
              s.Materialfv(GL_FRONT, GL_EMISSION, V{0.1, 0, 0.2, 1}), dome(s, kFlat);
            }),
      phong("two_sided", "A fragment of a back face has the back material and the opposite normal.",
            [](Script& s) {
              diffuse_scene(s, {0.5, 0.5, -2, 0}, {1, 1, 1, 1}), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
              s.Materialfv(GL_BACK, GL_DIFFUSE, V{0.2, 0.9, 0.5, 1}),
                  dome(s, {.cells = 1, .tilt = 0.6, .inward = true});
            }),
      phong("one_sided", "Without two-sided lighting a back face has the front material and its normal.",
            [](Script& s) {
              diffuse_scene(s, {1, 1, 1, 0}), s.Materialfv(GL_BACK, GL_DIFFUSE, V{0.2, 0.9, 0.5, 1}),
                  dome(s, {.cells = 1, .tilt = 0.6, .inward = true});
            }),
      phong("color_material", "The material that tracks the current color is that of the primitive.",
            [](Script& s) {
              diffuse_scene(s, {0.3, 0.2, 0.6, 1}, {1, 1, 1, 1}), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
                  s.Enable(GL_COLOR_MATERIAL);
              s.Color3f(1, 0.4, 0.2), sheet(s, -1, -1, 0, 1), s.Color3f(0.2, 0.5, 1), sheet(s, 0.1, -1, 1, 1);
            }),
      phong("material_between_primitives", "A material may change between primitives.",
            [](Script& s) {
              specular_scene(s, {0, 0, 0.8, 1}, 4), sheet(s, -1, -1, 0, 1);
              s.Materialf(GL_FRONT, GL_SHININESS, 30.0), sheet(s, 0.1, -1, 1, 1);
            }),
      phong("flat_normals", "With one normal and a light at infinity it is smooth shading.",
            [](Script& s) {
              diffuse_scene(s, {1, 0, 1, 0}), s.Normal3f(0.6, 0, 0.8), sheet(s, -1, -1, 1, 1);
            }),
      phong("without_lighting", "Without lighting it is smooth shading.",
            [](Script& s) {
              s.Begin(GL_TRIANGLES), s.Color3f(1, 0, 0.2), s.Vertex3f(-1, -1, 0), s.Color3f(0, 1, 0.2),
                  s.Vertex3f(1, -1, 0), s.Color3f(0.2, 0, 1), s.Vertex3f(0, 1, 0), s.End();
            }),
      phong("points", "A point is shaded as a smooth one.",
            [](Script& s) {
              diffuse_scene(s, {0, 0, 0.6, 1}), s.Begin(GL_POINTS);
              for (int i = 0; i < 400; i++) s.Vertex3f(-0.9 + 0.09 * (i % 20), -0.9 + 0.09 * (i / 20), 0);
              s.End();
            }),
      phong("fog", "Fog comes after the lighting of the fragment.",
            [](Script& s) {
              diffuse_scene(s, {0.3, 0.2, 0.6, 1}), s.Fogi(GL_FOG_MODE, GL_LINEAR), s.Fogf(GL_FOG_START, 3.0),
                  s.Fogf(GL_FOG_END, 7.0);
              s.Fogfv(GL_FOG_COLOR, V{0.2, 0.4, 0.9, 1}), s.Enable(GL_FOG), dome(s, kFlat);
            }),
      phong("texture", "The texture comes after the lighting of the fragment.",
            [](Script& s) {
              white_texture_of_half(s), specular_scene(s, {0.3, 0.2, 0.6, 1}, 12), dome(s, kFlat);
            }),
      phong("separate_specular", "The separate specular color of a fragment is added after the texture.",
            [](Script& s) {
              white_texture_of_half(s), specular_scene(s, {0.3, 0.2, 0.6, 1}, 12);
              s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR), dome(s, kFlat);
            }),
      phong("alpha", "The alpha of a fragment is that of the diffuse material.",
            [](Script& s) {
              diffuse_scene(s, {0.3, 0.2, 0.6, 1}), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 1, 1, 0.5});
              s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND), dome(s, kFlat);
            }),
      phong("each_primitive", "Primitives may be lit at fragments, smooth or flat in turn.",
            [](Script& s) {
              diffuse_scene(s, {0, 0, 0.5, 1}), sheet(s, -1, -1, -0.4, 1), s.ShadeModel(GL_SMOOTH);
              sheet(s, -0.3, -1, 0.3, 1), s.ShadeModel(GL_FLAT), s.Normal3f(0.6, 0, 0.8),
                  sheet(s, 0.4, -1, 0.65, 1);
              s.Normal3f(0, 0, 1), s.ShadeModel(GL_PHONG_WIN), sheet(s, 0.7, -1, 1, 1);
            }),
      phong("stack", "GL_LIGHTING_BIT saves the shade model.",
            [](Script& s) {
              diffuse_scene(s, {0.3, 0.2, 0.6, 1}), s.PushAttrib(GL_LIGHTING_BIT), s.ShadeModel(GL_SMOOTH),
                  s.PopAttrib(), dome(s, kFlat);
            }),
      phong("list", "A list carries the shade model and the primitive.",
            [](Script& s) {
              s.ShadeModel(GL_SMOOTH), s.NewList(1, GL_COMPILE), s.ShadeModel(GL_PHONG_WIN),
                  diffuse_scene(s, {0.3, 0.2, 0.6, 1}), dome(s, kFlat), s.EndList(), s.CallList(1);
            }),
      phong("perspective", "The projection does not change the eye coordinates of a fragment.",
            [](Script& s) {
              perspective(s), diffuse_scene(s, {0.3, 0.2, 0.6, 1}), dome(s, kFlat);
            }),
      phong("normalize", "GL_NORMALIZE makes the normals of vertices unit ones before they are interpolated.",
            [](Script& s) {
              diffuse_scene(s, {1, 0, 1, 0}), s.Enable(GL_NORMALIZE), s.Begin(GL_TRIANGLES);
              s.Normal3f(0, 0, 4), s.Vertex3f(-1, -1, 0), s.Normal3f(0.6, 0, 0.8), s.Vertex3f(1, -1, 0),
                  s.Normal3f(0, 0.4, 0.6), s.Vertex3f(0, 1, 0), s.End();
            }),
      phong("modelview", "Normals are transformed before they are interpolated.",
            [](Script& s) {
              diffuse_scene(s, {1, 1, 1, 0}), s.Enable(GL_NORMALIZE), s.Rotatef(30, 0, 1, 0),
                  s.Scalef(0.9, 0.6, 1);
              dome(s, kBent);
            }),
      phong("queried", "The shade model GL_PHONG_WIN and the hint GL_PHONG_HINT_WIN can be asked for.",
            [](Script& s) {
              const auto is = [&](GLenum name, GLenum value) { s.GetFloatv(name, V{double(value)}); };
              is(GL_SHADE_MODEL, GL_PHONG_WIN), is(GL_PHONG_HINT_WIN, GL_DONT_CARE),
                  s.Hint(GL_PHONG_HINT_WIN, GL_FASTEST), is(GL_PHONG_HINT_WIN, GL_FASTEST);
              s.PushAttrib(GL_LIGHTING_BIT), s.ShadeModel(GL_SMOOTH), is(GL_SHADE_MODEL, GL_SMOOTH),
                  s.PopAttrib(), is(GL_SHADE_MODEL, GL_PHONG_WIN);
              diffuse_scene(s, {0.3, 0.2, 0.6, 1}), dome(s, kFlat);
            }),
      phong("hint", "GL_PHONG_HINT_WIN is a hint.",
            [](Script& s) {
              s.Hint(GL_PHONG_HINT_WIN, GL_NICEST), specular_scene(s, {0.2, -0.3, 1, 0}, 20), dome(s, kBent);
            }),
  };
}

} // namespace softgl::suite
