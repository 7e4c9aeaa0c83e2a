// Normals (2.11.3), faces, and materials (2.14.1, 2.14.2).
#include "lighting/chapter.h"
#include "lighting/scenes.h"

namespace softgl::suite {
namespace {

const char* const kNormals = "2.11.3";
const char* const kFaces = "2.14.1, equation 2.6";

// A front material and a back material, and a light from the side of the viewer and one from behind.
void two_materials(Script& s) {
  diffuse_scene(s, {0.5, 0.5, 1, 0}, {1, 1, 1, 1}), lamp(s, GL_LIGHT1, V{-0.5, 0, -1, 0});
  s.Lightfv(GL_LIGHT1, GL_DIFFUSE, V{1, 1, 1, 1});
  s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.9, 0.3, 0.1, 1}),
      s.Materialfv(GL_BACK, GL_DIFFUSE, V{0.1, 0.4, 0.9, 1});
}
// The left half runs counter-clockwise, the right half clockwise.
void both_ways(Script& s) {
  dome(s, {.cells = 6, .x = -0.55, .size = 0.5}),
      dome(s, {.cells = 6, .inward = true, .x = 0.55, .size = 0.5});
}

} // namespace

std::vector<Test> lighting_normal_tests() {
  return {
      {"lighting.normal.unnormalized", kNormals, "Without GL_NORMALIZE the length of a normal counts.", "",
       [](Script& s) { diffuse_scene(s), dome(s, {.normal_length = 0.5}); }},
      {"lighting.normal.long", kNormals, "A long normal makes a surface brighter, up to the clamp.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 2, 3, 0}, {0.5, 0.3, 0.2, 1}), dome(s, {.normal_length = 2});
       }},
      {"lighting.normal.normalize_long", kNormals, "GL_NORMALIZE makes long normals unit ones.", "",
       [](Script& s) { diffuse_scene(s), s.Enable(GL_NORMALIZE), dome(s, {.normal_length = 7}); }},
      {"lighting.normal.normalize_short", kNormals, "GL_NORMALIZE makes short normals unit ones.", "",
       [](Script& s) { diffuse_scene(s), s.Enable(GL_NORMALIZE), dome(s, {.normal_length = 0.01}); }},
      {"lighting.normal.normalize_specular", kNormals, "Highlights see the normalized normal.", "",
       [](Script& s) {
         specular_scene(s, {1, 1, 2, 0}, 10), s.Enable(GL_NORMALIZE), dome(s, {.normal_length = 3});
       }},
      {"lighting.normal.specular_unnormalized", kNormals,
       "Highlights see the length of a normal that is not normalized.", "",
       [](Script& s) {
         specular_scene(s, {1, 1, 2, 0}, 3), dome(s, {.normal_length = 0.8});
       }},
      {"lighting.normal.uniform_scale", kNormals, "A uniform scale of the modelview divides normals.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 2, 3, 0}), s.Scalef(1.1, 1.1, 1.1), s.Scalef(2, 2, 2), dome(s, {.size = 0.4});
       }},
      {"lighting.normal.uniform_scale_normalized", kNormals, "GL_NORMALIZE undoes a uniform scale.", "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_NORMALIZE), s.Scalef(0.5, 0.5, 0.5), dome(s, {.size = 2});
       }},
      {"lighting.normal.rescale", kNormals, "GL_RESCALE_NORMAL undoes a uniform scale.", "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_RESCALE_NORMAL), s.Scalef(0.5, 0.5, 0.5), dome(s, {.size = 2});
       },
       kRescaleNormal},
      {"lighting.normal.rescale_keeps_length", kNormals,
       "GL_RESCALE_NORMAL keeps the length of normals that are not unit ones.", "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_RESCALE_NORMAL), s.Scalef(2, 2, 2),
             dome(s, {.normal_length = 0.6, .size = 0.5});
       },
       kRescaleNormal},
      {"lighting.normal.rescale_nonuniform", "2.11.3, equation 2.1",
       "GL_RESCALE_NORMAL divides by the length of the third row of the inverse, even of a scale that is not "
       "uniform.",
       "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_RESCALE_NORMAL), s.Scalef(1, 1, 1.6), dome(s, {.tilt = 0.6});
       },
       kRescaleNormal},
      {"lighting.normal.rescale_and_normalize", kNormals, "GL_NORMALIZE comes after GL_RESCALE_NORMAL.", "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_RESCALE_NORMAL), s.Enable(GL_NORMALIZE), s.Scalef(0.5, 0.5, 0.7);
         dome(s, {.normal_length = 3, .size = 2});
       },
       kRescaleNormal},
      {"lighting.normal.nonuniform_scale", kNormals,
       "Normals are transformed by the inverse of the modelview.", "",
       [](Script& s) { diffuse_scene(s), s.Enable(GL_NORMALIZE), s.Scalef(0.5, 1, 1), dome(s); }},
      {"lighting.normal.nonuniform_unnormalized", kNormals,
       "A scale that is not uniform changes length and direction of normals.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 2, 3, 0}), s.Scalef(1, 0.8, 1.5), dome(s, {.tilt = 0.8});
       }},
      {"lighting.normal.shear", kNormals, "A shear turns normals by its inverse.", "",
       [](Script& s) {
         diffuse_scene(s), s.Enable(GL_NORMALIZE),
             s.MultMatrixf(V{1, 0, 0, 0, 0.3, 1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1});
         dome(s, {.size = 0.7});
       }},
      {"lighting.normal.rotation", kNormals, "A rotation turns normals with the model.", "",
       [](Script& s) {
         diffuse_scene(s), s.Rotatef(30, 1, 0, 0), s.Rotatef(20, 0, 1, 0), dome(s, {.size = 0.8});
       }},
      {"lighting.normal.translation", kNormals, "A translation does not change normals.", "",
       [](Script& s) { diffuse_scene(s), s.Translatef(0.3, -0.2, -3), dome(s, {.size = 0.7}); }},
      {"lighting.normal.mirror", kNormals, "A mirror turns normals, too.", "",
       [](Script& s) { diffuse_scene(s), s.Scalef(-1, 1, 1), dome(s); }},
      {"lighting.normal.default", "2.7", "The current normal is (0, 0, 1) at first.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}), sheet(s, -1, -1, 1, 1);
       }},
      {"lighting.normal.current", "2.7", "A vertex has the normal that was set last.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}), s.Normal3f(0.6, 0, 0.8), sheet(s, -1, -1, 0, 1);
         s.Normal3f(-0.6, 0, 0.8), sheet(s, 0.1, -1, 1, 1);
       }},
      {"lighting.normal.bytes", "2.7, table 2.9", "Bytes of a normal c are (2c + 1) / 255.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}), s.Normal3b(0, 0, 63), sheet(s, -1, -1, 1, 0),
             s.Normal3b(127, 0, 100), sheet(s, -1, 0.1, 1, 1);
       }},
      {"lighting.normal.shorts", "2.7, table 2.9", "Shorts of a normal c are (2c + 1) / 65535.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}), s.Normal3s(0, 0, 16383), sheet(s, -1, -1, 1, 0),
             s.Normal3s(0, 32767, 28000), sheet(s, -1, 0.1, 1, 1);
       }},
      {"lighting.normal.doubles", "2.7", "Normals of doubles are taken as they are.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}), s.Normal3d(0.3, 0.1, 0.7), sheet(s, -1, -1, 1, 1);
       }},
      {"lighting.normal.zero", kNormals, "A zero normal has neither diffuse nor specular term.", "",
       [](Script& s) {
         diffuse_scene(s), s.Materialfv(GL_FRONT, GL_EMISSION, V{0.2, 0.4, 0.1, 1}), s.Normal3f(0, 0, 0),
             sheet(s, -1, -1, 1, 1);
       }},
  };
}

std::vector<Test> lighting_face_tests() {
  return {
      {"lighting.faces.one_sided", "2.14.1",
       "Without two-sided lighting both faces have the front material and its normal.", "",
       [](Script& s) { two_materials(s), both_ways(s); }},
      {"lighting.faces.two_sided", "2.14.1", "A back face has the back material and the opposite normal.", "",
       [](Script& s) { two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), both_ways(s); }},
      {"lighting.faces.clockwise", kFaces, "glFrontFace says which way a front face runs.", "",
       [](Script& s) {
         two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.FrontFace(GL_CW), both_ways(s);
       }},
      {"lighting.faces.mirrored", kFaces, "The way of a polygon is that in window coordinates.", "",
       [](Script& s) {
         two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.Scalef(-1, 1, 1), both_ways(s);
       }},
      {"lighting.faces.emission", "2.14.1", "Each face has its own emission.", "",
       [](Script& s) {
         dark(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
             s.Materialfv(GL_FRONT, GL_EMISSION, V{1, 0.5, 0, 1});
         s.Materialfv(GL_BACK, GL_EMISSION, V{0, 0.5, 1, 1}), both_ways(s);
       }},
      {"lighting.faces.ambient", "2.14.1", "Each face has its own ambient color.", "",
       [](Script& s) {
         dark(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
             s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{1, 1, 1, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.7, 0.2, 0, 1}),
             s.Materialfv(GL_BACK, GL_AMBIENT, V{0, 0.7, 0.3, 1}), both_ways(s);
       }},
      {"lighting.faces.specular", "2.14.1", "Each face has its own specular color and shininess.", "",
       [](Script& s) {
         specular_scene(s, {0.5, 0.5, 2, 0}, 5), lamp(s, GL_LIGHT1, V{-0.5, 0.5, -2, 0}),
             s.Lightfv(GL_LIGHT1, GL_SPECULAR, V{1, 1, 1, 1});
         s.Materialfv(GL_BACK, GL_SPECULAR, V{0.2, 1, 0.2, 1}), s.Materialf(GL_BACK, GL_SHININESS, 1.0);
         s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), both_ways(s);
       }},
      {"lighting.faces.local_viewer", "2.14.1", "A local viewer sees the highlight of a back face.", "",
       [](Script& s) {
         specular_scene(s, {0.5, 0.5, 2, 1}, 5), s.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
         s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.Rotatef(180, 0, 1, 0), dome(s, {.tilt = 0.5});
       }},
      {"lighting.faces.alpha", "2.14.1", "The alpha of a back face is that of its own diffuse color.", "",
       [](Script& s) {
         dark(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
             s.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, V{1, 1, 1, 1});
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 0, 0.25}),
             s.Materialfv(GL_BACK, GL_DIFFUSE, V{0, 0, 0, 0.75});
         s.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), s.Enable(GL_BLEND), both_ways(s);
       }},
      {"lighting.faces.culled", "2.14.1, 3.5.1", "Culling and two-sided lighting know the same faces.", "",
       [](Script& s) {
         two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.CullFace(GL_FRONT),
             s.Enable(GL_CULL_FACE), both_ways(s);
       }},
      {"lighting.faces.strip", "2.6.1", "The triangles of a strip face all one way.", "",
       [](Script& s) {
         two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.Normal3f(0, 0, 1),
             s.Begin(GL_TRIANGLE_STRIP);
         for (int i = 0; i < 8; i++) s.Vertex3f(-0.9 + 0.25 * i, i % 2 ? 0.8 : -0.8, 0);
         s.End();
       }},
      {"lighting.faces.lines", "2.14.1", "A line always has the front color.", "",
       [](Script& s) {
         two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.Normal3f(0, 0, -1), s.Begin(GL_LINES);
         for (int i = 0; i < 6; i++)
           s.Vertex3f(-0.9, -0.83 + 0.3 * i, 0), s.Vertex3f(0.9, -0.73 + 0.3 * i, 0);
         s.End();
       }},
      {"lighting.faces.points", "2.14.1", "A point always has the front color.", "",
       [](Script& s) {
         two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.FrontFace(GL_CW), s.Normal3f(0, 0, 1),
             s.Begin(GL_POINTS);
         for (int i = 0; i < 400; i++) s.Vertex3f(-0.9 + 0.09 * (i % 20), -0.9 + 0.09 * (i / 20), 0);
         s.End();
       }},
  };
}

std::vector<Test> lighting_material_tests() {
  const char* const section = "2.14.2";
  return {
      {"lighting.material.front_only", section, "glMaterial of GL_FRONT leaves the back material.", "",
       [](Script& s) {
         diffuse_scene(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 0, 0, 1});
         s.Materialfv(GL_BACK, GL_EMISSION, V{0, 0, 0.5, 1}), both_ways(s);
       }},
      {"lighting.material.both", section, "GL_FRONT_AND_BACK sets both materials.", "",
       [](Script& s) {
         two_materials(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
             s.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, V{0.5, 0.8, 0.5, 1}), both_ways(s);
       }},
      {"lighting.material.ambient_and_diffuse", section, "GL_AMBIENT_AND_DIFFUSE sets both colors.", "",
       [](Script& s) {
         diffuse_scene(s), s.LightModelfv(GL_LIGHT_MODEL_AMBIENT, V{0.4, 0.4, 0.4, 1});
         s.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, V{0.9, 0.5, 0.1, 1}), dome(s);
       }},
      {"lighting.material.between_vertices", "2.14.2, 2.6.3",
       "glMaterial may stand between Begin and End, and each vertex has its own.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.Begin(GL_TRIANGLES);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{1, 0, 0, 1}), s.Vertex3f(-1, -1, 0);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 1, 0, 1}), s.Vertex3f(1, -1, 0);
         s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0, 0, 1, 1}), s.Vertex3f(0, 1, 0), s.End();
       }},
      {"lighting.material.all_between_vertices", "2.14.2",
       "Every parameter of a material may change between vertices.", "",
       [](Script& s) {
         diffuse_scene(s, {0.5, 0, 1, 0}, {0.5, 0.5, 0.5, 1}),
             s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{1, 1, 1, 1});
         s.Lightfv(GL_LIGHT0, GL_AMBIENT, V{0.5, 0.5, 0.5, 1}), s.Begin(GL_TRIANGLES);
         s.Materialfv(GL_FRONT, GL_EMISSION, V{0.5, 0, 0, 1}), s.Vertex3f(-1, -1, 0);
         s.Materialfv(GL_FRONT, GL_SPECULAR, V{0, 0.7, 0, 1}), s.Materialf(GL_FRONT, GL_SHININESS, 4.0),
             s.Vertex3f(1, -1, 0);
         s.Materialfv(GL_FRONT, GL_AMBIENT, V{0, 0, 1, 1}), s.Materialf(GL_FRONT, GL_SHININESS, 40.0),
             s.Vertex3f(0, 1, 0), s.End();
       }},
      {"lighting.material.stays", "2.14.2", "A material that was set between Begin and End stays.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.Begin(GL_TRIANGLES);
         s.Vertex3f(-1, -1, 0), s.Vertex3f(0, -1, 0), s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.2, 0.6, 0.2, 1}),
             s.Vertex3f(-0.5, 1, 0), s.End();
         sheet(s, 0.1, -1, 1, 1);
       }},
      {"lighting.material.back_between_vertices", "2.14.2", "The back material may change between vertices.",
       "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1}), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
             s.Normal3f(0, 0, -1), s.Begin(GL_TRIANGLES);
         s.Materialfv(GL_BACK, GL_DIFFUSE, V{1, 0, 0, 1}), s.Vertex3f(-1, -1, 0);
         s.Materialfv(GL_BACK, GL_DIFFUSE, V{0, 1, 0, 1}), s.Vertex3f(0, 1, 0);
         s.Materialfv(GL_BACK, GL_DIFFUSE, V{0, 0, 1, 1}), s.Vertex3f(1, -1, 0), s.End();
       }},
      {"lighting.material.between_draws", "2.14.2", "Primitives have the material of their time.", "",
       [](Script& s) {
         diffuse_scene(s, {0, 0, 1, 0}, {1, 1, 1, 1});
         for (int i = 0; i < 5; i++)
           s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.2 * i, 1 - 0.2 * i, 0.5, 1}),
               sheet(s, -1 + 0.4 * i, -1, -0.65 + 0.4 * i, 1);
       }},
      {"lighting.material.shininess_integer", section, "glMateriali sets the shininess.", "",
       [](Script& s) {
         specular_scene(s, {1, 1, 2, 0}, 1), s.Materiali(GL_FRONT, GL_SHININESS, 20), dome(s);
       }},
      {"lighting.material.default_shininess", "table 2.10", "The shininess is 0 at first.", "",
       [](Script& s) {
         dark(s), lamp(s, GL_LIGHT0, V{1, 1, 1, 0}), s.Lightfv(GL_LIGHT0, GL_SPECULAR, V{1, 0.5, 0.2, 1});
         s.Materialfv(GL_FRONT, GL_SPECULAR, V{0.6, 0.6, 0.6, 1}), dome(s, {.tilt = 0.5});
       }},
      {"lighting.material.shininess_0_positional", "2.14.1",
       "A shininess of 0 makes the highlight of a near light 1, too.", "",
       [](Script& s) {
         specular_scene(s, {0.5, 0.5, 2, 1}, 0), s.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2),
             dome(s, {.tilt = 0.5});
       }},
      {"lighting.material.shininess_0_spot", "2.14.1",
       "A shininess of 0 makes the highlight of a spotlight 1, too.", "",
       [](Script& s) {
         specular_scene(s, {0.2, 0.1, 1.5, 1}, 0), s.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 60.0),
             s.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2.0);
         dome(s, {.tilt = 0.5});
       }},
      {"lighting.material.above_one", "table 2.10", "Colors of materials and lights may be above 1.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}, {4, 0.25, 0.5, 1}),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.2, 3, 1, 1}), dome(s);
       }},
      {"lighting.material.negative", "table 2.10", "Colors of materials may be below 0.", "",
       [](Script& s) {
         diffuse_scene(s, {1, 0, 1, 0}, {1, 1, 1, 1}),
             s.Materialfv(GL_FRONT, GL_DIFFUSE, V{-0.5, 0.8, -1, 1});
         s.Materialfv(GL_FRONT, GL_EMISSION, V{0.8, 0, 0.9, 1}), dome(s);
       }},
  };
}

} // namespace softgl::suite
