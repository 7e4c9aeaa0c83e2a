// Flat shading (2.14.7), the raster position (2.13), display lists (5.4), attribute stacks (6.1.14), and the
// order of calls.
#include <cmath>

#include "lighting/chapter.h"
#include "lighting/scenes.h"

namespace softgl::suite {
namespace {

// Vertices in a zigzag from left to right, each with a normal of its own.
void zigzag(Script& s, GLenum mode, int count) {
  s.Begin(mode);
  for (int i = 0; i < count; i++) {
    const double turn = 0.9 * i;
    s.Normal3f(float(0.8 * std::sin(turn)), float(0.8 * std::cos(turn)), 0.6f);
    s.Vertex3f(float(-0.95 + 1.9 * i / (count - 1)), i % 2 ? 0.83f : -0.81f, 0.0f);
  }
  s.End();
}
// Vertices round the middle; with `center` a fan.
void ring(Script& s, GLenum mode, int count, bool center) {
  s.Begin(mode);
  if (center) s.Normal3f(0, 0, 1), s.Vertex3f(0.03f, 0.02f, 0);
  for (int i = 0; i < count; i++) {
    const double turn = 6.2831853 * i / (count - (center ? 1 : 0)) + 0.1;
    s.Normal3f(float(0.8 * std::cos(2 * turn)), float(0.8 * std::sin(2 * turn)), 0.6f);
    s.Vertex3f(float(0.95 * std::cos(turn)), float(0.95 * std::sin(turn)), 0.0f);
  }
  s.End();
}
// Quadrilaterals beside each other: eight corners each with a normal.
void quads(Script& s) {
  s.Begin(GL_QUADS);
  for (int i = 0; i < 3; i++)
    for (int k = 0; k < 4; k++) {
      const double turn = 1.3 * (4 * i + k), x = -0.95 + 0.65 * i;
      s.Normal3f(float(0.8 * std::sin(turn)), float(0.8 * std::cos(turn)), 0.6f);
      s.Vertex3f(float(x + (k == 1 || k == 2 ? 0.55 : 0)), k >= 2 ? 0.83f : -0.81f, 0.0f);
    }
  s.End();
}

Test flat(const char* name, const char* sentence, std::function<void(Script&)> shape) {
  return {std::string("lighting.flat.") + name, "2.14.7, table 2.12", sentence, "",
          [shape = std::move(shape)](Script& s) {
            diffuse_scene(s, {1, 0.3, 0.5, 0}), s.ShadeModel(GL_FLAT), shape(s);
          }};
}

// A material and a light that are nobody's default.
void set_lighting(Script& s) {
  diffuse_scene(s, {1, 1, 1, 0}, {0.9, 0.5, 0.3, 1}), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.7, 0.9, 1, 1});
  s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.2, 0.3, 0.4, 1}),
      s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.5, 0.5, 0.5, 1});
}
// Changes all of it.
void spoil_lighting(Script& s) {
  s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0, 1, 0, 1}), s.Lightfv(GL_LIGHT0, GL_POSITION, V{0, 0, -1, 1}),
      s.Disable(GL_LIGHT0), s.Enable(GL_LIGHT1);
  s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 10.0), s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 2.0);
  s.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, V{1, 0, 0, 1}),
      s.Materialfv(GL_FRONT, GL_EMISSION, V{0, 0, 0.5, 1});
  s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{1, 1, 1, 1}), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
      s.ShadeModel(GL_FLAT);
  s.ColorMaterial(GL_FRONT, GL_EMISSION), s.Enable(GL_COLOR_MATERIAL);
}

void bitmap(Script& s) {
  s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  s.Bitmap(32, 32, 0, 0, 0, 0, Memory{GL_UNSIGNED_BYTE, std::vector<double>(128, 255)});
}

} // namespace

std::vector<Test> lighting_flat_tests() {
  return {
      flat("points", "A flat point has its own color.",
           [](Script& s) {
             s.Begin(GL_POINTS);
             for (int i = 0; i < 900; i++)
               s.Normal3f(float(0.8 * std::sin(i * 0.3)), float(0.8 * std::cos(i * 0.3)), 0.6f),
                   s.Vertex3f(float(-0.9 + 0.06 * (i % 30)), float(-0.9 + 0.06 * (i / 30)), 0);
             s.End();
           }),
      flat("lines", "A flat line has the color of its second vertex.",
           [](Script& s) {
             s.Begin(GL_LINES);
             for (int i = 0; i < 8; i++) {
               s.Normal3f(0, 0.8f, 0.6f), s.Vertex3f(-0.9f, float(-0.87 + 0.22 * i), 0);
               s.Normal3f(float(0.8 * std::sin(i)), float(0.8 * std::cos(i)), 0.6f),
                   s.Vertex3f(0.9f, float(-0.82 + 0.22 * i), 0);
             }
             s.End();
           }),
      flat("line_strip", "Each line of a flat strip has the color of its second vertex.",
           [](Script& s) { zigzag(s, GL_LINE_STRIP, 6); }),
      flat("line_loop", "The last line of a flat loop has the color of the first vertex.",
           [](Script& s) { ring(s, GL_LINE_LOOP, 6, false); }),
      flat("triangles", "A flat triangle has the color of its third vertex.",
           [](Script& s) { dome(s, {.cells = 5}); }),
      flat("triangle_strip", "Triangle i of a flat strip has the color of vertex i + 2.",
           [](Script& s) { zigzag(s, GL_TRIANGLE_STRIP, 8); }),
      flat("triangle_fan", "Triangle i of a flat fan has the color of vertex i + 2.",
           [](Script& s) { ring(s, GL_TRIANGLE_FAN, 8, true); }),
      flat("quads", "Quadrilateral i has the color of vertex 4i.", quads),
      flat("quad_strip", "Quadrilateral i of a flat strip has the color of vertex 2i + 2.",
           [](Script& s) { zigzag(s, GL_QUAD_STRIP, 8); }),
      flat("polygon", "A flat polygon has the color of its first vertex.",
           [](Script& s) { ring(s, GL_POLYGON, 7, false); }),
      {"lighting.flat.two_sided", "2.14.1, 2.14.7", "A flat back face has the back color of its vertex.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0.3, 0.5, 0}), s.ShadeModel(GL_FLAT), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
         s.Materialfv(GL_BACK, GL_DIFFUSE, V{0.2, 1, 0.2, 1}),
             dome(s, {.cells = 5, .tilt = 3, .inward = true});
       }},
      {"lighting.flat.separate_specular", "2.14.7",
       "Flat primitives have the secondary color of their vertex, too.", "",
       [](Script& s) {
         specular_scene(s, {0.5, 0.5, 1, 0}, 6), s.ShadeModel(GL_FLAT);
         s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR), dome(s, {.cells = 6});
       },
       kSeparateSpecular},
      {"lighting.flat.color_material", "2.14.3, 2.14.7",
       "A flat triangle has the material that its third vertex tracks.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.ShadeModel(GL_FLAT),
             s.ColorMaterial(GL_FRONT, GL_DIFFUSE), s.Enable(GL_COLOR_MATERIAL);
         s.Begin(GL_TRIANGLES), s.Color3f(1, 0, 0), s.Vertex3f(-1, -1, 0), s.Color3f(0, 1, 0),
             s.Vertex3f(0, -1, 0), s.Color3f(0.2, 0.4, 1);
         s.Vertex3f(-0.5, 1, 0), s.Vertex3f(0.1, -1, 0), s.Vertex3f(1, -1, 0), s.Color3f(1, 0.8, 0),
             s.Vertex3f(0.5, 1, 0), s.End();
       }},
      {"lighting.flat.and_smooth_again", "2.14.7", "Primitives have the shade model of their time.", "",
       [](Script& s) {
         diffuse_scene(s), s.ShadeModel(GL_FLAT), dome(s, {.cells = 4, .x = -0.5, .size = 0.45});
         s.ShadeModel(GL_SMOOTH), dome(s, {.cells = 4, .x = 0.5, .size = 0.45});
       }},
  };
}

std::vector<Test> lighting_sequence_tests() {
  return {
      {"lighting.raster_position.lit", "2.13", "The raster position gets a lit color.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}), s.Normal3f(0.6, 0, 0.8), s.RasterPos3f(-0.79f, -0.81f, 0), bitmap(s);
         s.Normal3f(0, 0, 1), s.RasterPos3f(0.11f, 0.09f, 0), bitmap(s);
       }},
      {"lighting.raster_position.positional", "2.13", "The raster position is lit as a vertex at its place.",
       "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 1}), s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.5),
             s.RasterPos3f(-0.79f, -0.81f, 0), bitmap(s);
         s.RasterPos3f(0.01f, 0.02f, 0), bitmap(s);
       }},
      {"lighting.raster_position.keeps_its_color", "2.13",
       "A light that changes later does not change the raster position.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}), s.RasterPos3f(-0.29f, -0.31f, 0),
             s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0, 1, 0, 1}), bitmap(s);
       }},
      {"lighting.raster_position.front", "2.13", "The raster position has the front color.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.FrontFace(GL_CW),
             s.Materialfv(GL_BACK, GL_DIFFUSE, V{1, 0, 0, 1});
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0.7, 0.2, 1}), s.RasterPos3f(-0.29f, -0.31f, 0), bitmap(s);
       }},
      {"lighting.raster_position.color_material", "2.13, 2.14.3",
       "The raster position sees the material that tracks.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.ColorMaterial(GL_FRONT, GL_DIFFUSE),
             s.Enable(GL_COLOR_MATERIAL);
         s.Color3f(0.9, 0.2, 0.6), s.RasterPos3f(-0.29f, -0.31f, 0), s.Color3f(0, 1, 0), bitmap(s);
       }},
      {"lighting.list.lighting_state", "5.4", "A list carries lights, materials and the light model.", "",
       [](Script& s) { s.NewList(1, GL_COMPILE), set_lighting(s), s.EndList(), s.CallList(1), dome(s); }},
      {"lighting.list.not_at_compile", "5.4", "Commands that are only compiled change nothing.", "",
       [](Script& s) { set_lighting(s), s.NewList(1, GL_COMPILE), spoil_lighting(s), s.EndList(), dome(s); }},
      {"lighting.list.compile_and_execute", "5.4", "GL_COMPILE_AND_EXECUTE executes at once.", "",
       [](Script& s) { s.NewList(1, GL_COMPILE_AND_EXECUTE), set_lighting(s), dome(s), s.EndList(); }},
      {"lighting.list.position_at_call", "5.4, 2.14.2",
       "A light position in a list is transformed when the list is called.", "",
       [](Script& s) {
         diffuse_scene(s), s.NewList(1, GL_COMPILE), s.Lightfv(GL_LIGHT0, GL_POSITION, V{0, 0, 1, 0}),
             s.EndList();
         s.PushMatrix(), s.Rotatef(50, 1, 1, 0), s.CallList(1), s.PopMatrix(), dome(s);
       }},
      {"lighting.list.material_inside_primitive", "5.4, 2.14.2",
       "A list may hold materials between vertices.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.NewList(1, GL_COMPILE), s.Begin(GL_TRIANGLES);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 0, 0, 1}), s.Vertex3f(-1, -1, 0),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 1, 0, 1});
         s.Vertex3f(1, -1, 0), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 1, 1}), s.Vertex3f(0, 1, 0),
             s.End(), s.EndList(), s.CallList(1);
       }},
      {"lighting.list.state_at_call", "5.4",
       "A primitive in a list is lit with the state of the time of the call.", "",
       [](Script& s) {
         s.NewList(1, GL_COMPILE), dome(s, {.cells = 6, .x = -0.5, .size = 0.45}), s.EndList(),
             set_lighting(s), s.CallList(1);
         s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0.2, 0.9, 0.4, 1}), s.Translatef(1, 0, 0), s.CallList(1);
       }},
      {"lighting.list.current_color_at_call", "5.4, 2.14.3",
       "Vertices of a list without a color track the color of the time of the call.", "",
       [](Script& s) {
         diffuse_scene(s), s.ColorMaterial(GL_FRONT, GL_DIFFUSE), s.Enable(GL_COLOR_MATERIAL),
             s.NewList(1, GL_COMPILE);
         dome(s, {.cells = 6, .x = -0.5, .size = 0.45}), s.EndList(), s.Color3f(1, 0.3, 0.3), s.CallList(1),
             s.Color3f(0.3, 1, 0.3);
         s.Translatef(1, 0, 0), s.CallList(1);
       }},
      {"lighting.list.normal_at_call", "5.4",
       "Vertices of a list without a normal have the normal of the time of the call.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}), s.NewList(1, GL_COMPILE), sheet(s, -1, -1, -0.1, 1), s.EndList();
         s.Normal3f(0.8, 0, 0.6), s.CallList(1), s.Normal3f(-0.4, 0, 0.9), s.Translatef(1.05, 0, 0),
             s.CallList(1);
       }},
      {"lighting.list.twice", "5.4", "A list gives the same picture each time.", "",
       [](Script& s) {
         s.NewList(1, GL_COMPILE), set_lighting(s), dome(s, {.cells = 6, .x = -0.5, .size = 0.45}),
             s.EndList(), s.CallList(1);
         spoil_lighting(s), s.Disable(GL_COLOR_MATERIAL), s.ShadeModel(GL_SMOOTH),
             s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180.0), s.Disable(GL_LIGHT1);
         s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0), s.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.0),
             s.Translatef(1, 0, 0), s.CallList(1);
       }},
      {"lighting.stack.lighting_bit", "6.1.14, table 6.11",
       "GL_LIGHTING_BIT saves lights, materials, light model, color material and shade model.", "",
       [](Script& s) {
         set_lighting(s), s.PushAttrib(GL_LIGHTING_BIT), spoil_lighting(s), s.PopAttrib(), dome(s);
       }},
      {"lighting.stack.all_bits", "6.1.14", "GL_ALL_ATTRIB_BITS saves all lighting state.", "",
       [](Script& s) {
         set_lighting(s), s.PushAttrib(GL_ALL_ATTRIB_BITS), spoil_lighting(s), s.PopAttrib(), dome(s);
       }},
      {"lighting.stack.enable_bit", "6.1.14, table 6.11", "GL_ENABLE_BIT saves which lights are on.", "",
       [](Script& s) {
         set_lighting(s), lamp(s, GL_LIGHT1, V{-1, 0, 1, 0}),
             s.Lightfv(GL_LIGHT1, GL_DIFFUSE, V{0, 0.6, 0.6, 1});
         s.PushAttrib(GL_ENABLE_BIT), s.Disable(GL_LIGHT0), s.Disable(GL_LIGHT1), s.Enable(GL_LIGHT2),
             s.PopAttrib(), dome(s);
       }},
      {"lighting.stack.enable_bit_lighting", "6.1.14",
       "GL_ENABLE_BIT saves GL_LIGHTING, GL_NORMALIZE and GL_COLOR_MATERIAL.", "",
       [](Script& s) {
         set_lighting(s), s.Enable(GL_NORMALIZE), s.PushAttrib(GL_ENABLE_BIT), s.Disable(GL_LIGHTING),
             s.Disable(GL_NORMALIZE);
         s.ColorMaterial(GL_FRONT, GL_EMISSION), s.PopAttrib(), s.Enable(GL_LIGHT0),
             dome(s, {.normal_length = 3});
       }},
      {"lighting.stack.other_bit", "6.1.14", "A bit that does not name lighting leaves what was changed.", "",
       [](Script& s) { s.PushAttrib(GL_FOG_BIT), set_lighting(s), s.PopAttrib(), dome(s); }},
      {"lighting.stack.nested", "6.1.14", "Attributes may be saved within saved ones.", "",
       [](Script& s) {
         set_lighting(s), s.PushAttrib(GL_LIGHTING_BIT),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 0.2, 0.2, 1}), s.PushAttrib(GL_LIGHTING_BIT);
         spoil_lighting(s), s.PopAttrib(), dome(s, {.cells = 6, .x = -0.5, .size = 0.45}), s.PopAttrib(),
             dome(s, {.cells = 6, .x = 0.5, .size = 0.45});
       }},
      {"lighting.stack.transform_bit", "6.1.14, table 6.8", "GL_TRANSFORM_BIT saves GL_NORMALIZE.", "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_NORMALIZE), s.PushAttrib(GL_TRANSFORM_BIT), s.Disable(GL_NORMALIZE),
             s.PopAttrib(), dome(s, {.normal_length = 4});
       }},
      {"lighting.stack.polygon_bit", "6.1.14, table 6.13",
       "GL_POLYGON_BIT saves which way a front face runs.", "",
       [](Script& s) {
         diffuse_scene(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
             s.Materialfv(GL_BACK, GL_EMISSION, V{1, 0, 0, 1});
         s.PushAttrib(GL_POLYGON_BIT), s.FrontFace(GL_CW), s.PopAttrib(), dome(s);
       }},
      {"lighting.stack.position_in_eye_coordinates", "6.1.14, 2.14.2",
       "A saved light position is not transformed again.", "",
       [](Script& s) {
         set_lighting(s), s.PushAttrib(GL_LIGHTING_BIT), s.Rotatef(70, 0, 1, 0), s.PopAttrib(),
             s.Rotatef(-70, 0, 1, 0), dome(s);
       }},
      {"lighting.order.light_after_draw", "2.1", "A light that changes behind a draw does not change it.", "",
       [](Script& s) {
         set_lighting(s), dome(s, {.cells = 6, .x = -0.5, .size = 0.45}),
             s.Lightfv(GL_LIGHT0, GL_DIFFUSE, V{0.1, 1, 0.3, 1});
         dome(s, {.cells = 6, .x = 0.5, .size = 0.45});
       }},
      {"lighting.order.lighting_off_after_draw", "2.1", "Lighting may go off and on between draws.", "",
       [](Script& s) {
         set_lighting(s), s.Color3f(0.9, 0.1, 0.4), dome(s, {.cells = 4, .x = -0.7, .size = 0.28}),
             s.Disable(GL_LIGHTING), dome(s, {.cells = 4, .size = 0.28});
         s.Enable(GL_LIGHTING), dome(s, {.cells = 4, .x = 0.7, .size = 0.28});
       }},
      {"lighting.order.modelview_between_draws", "2.11.3", "Each draw has the normals of its own modelview.",
       "",
       [](Script& s) {
         set_lighting(s), s.PushMatrix(), s.Translatef(-0.5, 0, 0), s.Rotatef(40, 0, 1, 0),
             dome(s, {.cells = 6, .size = 0.45}), s.PopMatrix();
         s.Translatef(0.5, 0, 0), s.Rotatef(-40, 1, 0, 0), dome(s, {.cells = 6, .size = 0.45});
       }},
      {"lighting.order.position_between_draws", "2.1, 2.14.2",
       "Each draw has the light position of its time.", "",
       [](Script& s) {
         set_lighting(s), dome(s, {.cells = 6, .x = -0.5, .size = 0.45}),
             s.Lightfv(GL_LIGHT0, GL_POSITION, V{-1, -1, 0.5, 0});
         dome(s, {.cells = 6, .x = 0.5, .size = 0.45});
       }},
      {"lighting.order.model_between_draws", "2.1, 2.14.2", "Each draw has the light model of its time.", "",
       [](Script& s) {
         specular_scene(s, {0, 1, 1, 1}, 8), dome(s, {.cells = 6, .tilt = 0.5, .x = -0.5, .size = 0.45}),
             s.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
         s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.5, 0.2, 0.2, 1}),
             s.Materialfv(GL_FRONT, GL_AMBIENT, V{1, 1, 1, 1});
         dome(s, {.cells = 6, .tilt = 0.5, .x = 0.5, .size = 0.45});
       }},
      {"lighting.order.spot_between_draws", "2.1", "Each draw has the spotlights of its time.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 1}), dome(s, {.cells = 8, .tilt = 0.2, .x = -0.5, .size = 0.45}),
             s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30.0);
         dome(s, {.cells = 8, .tilt = 0.2, .x = 0.5, .size = 0.45});
       }},
  };
}

} // namespace softgl::suite
