// Feedback (5.3): coordinates, colors and texture coordinates of vertices, raster positions, what is clipped.
#include "lighting/scenes.h"
#include "special/chapter.h"
#include "special/scenes.h"

namespace softgl::suite {
namespace {

Test fed_value_row(const char* name, const char* sentence, std::function<void(Script&)> body,
                   const char* section = "5.3", Need need = {}) {
  return special_test(std::string("feedback.") + name, section, sentence, std::move(body), need);
}

// A white light from the side, and a material of each face.
void lit(Script& s) {
  s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT0), s.Lightfv(GL_LIGHT0, GL_POSITION, V{0.3, 0.2, 1, 0});
  s.Materialfv(GL_FRONT, GL_DIFFUSE, V{0.9, 0.3, 0.2, 0.7}),
      s.Materialfv(GL_BACK, GL_DIFFUSE, V{0.1, 0.5, 0.9, 0.4});
  s.Materialfv(GL_FRONT, GL_AMBIENT, V{0.3, 0.3, 0.1, 1}),
      s.Materialfv(GL_BACK, GL_AMBIENT, V{0.1, 0.4, 0.3, 1});
}

// A texture of one white texel.
void textured(Script& s) {
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               Memory{GL_UNSIGNED_BYTE, {255, 255, 255, 255}});
  s.Enable(GL_TEXTURE_2D);
}

// Texture coordinates that come from places, and a matrix for them.
void generated(Script& s) {
  s.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR), s.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
  s.TexGenfv(GL_S, GL_OBJECT_PLANE, V{2, 0, 0.5, 0.25}), s.Enable(GL_TEXTURE_GEN_S),
      s.Enable(GL_TEXTURE_GEN_T);
}
void texture_matrix(Script& s) {
  s.MatrixMode(GL_TEXTURE), s.Translatef(0.5, -2, 0.25), s.Scalef(3, 0.5, 1), s.Rotatef(30, 0, 0, 1),
      s.MatrixMode(GL_MODELVIEW);
}

// Two triangles with normals, the second clockwise.
void lit_faces(Script& s) {
  s.Begin(GL_TRIANGLES), s.Normal3f(0, 0.6, 0.8), pixel_vertex(s, 10.2, 12.4), s.Normal3f(0, 0, 1),
      pixel_vertex(s, 40.3, 15.1), s.Normal3f(0.6, 0, 0.8), pixel_vertex(s, 25.6, 50.2);
  s.Normal3f(0, 0.8, 0.6), pixel_vertex(s, 52.3, 20.4), s.Normal3f(0, 0, 1), pixel_vertex(s, 70.2, 74.6),
      s.Normal3f(-0.6, 0, 0.8), pixel_vertex(s, 88.1, 30.9), s.End();
}

// The image does not matter where a bitmap or a rectangle of pixels is fed back.
void bitmap(Script& s, double move_x = 0, double move_y = 0) {
  s.Bitmap(8, 2, 1, 1, move_x, move_y, Memory{GL_UNSIGNED_BYTE, {170, 0, 0, 0, 85, 0, 0, 0}});
}
void draw_pixels(Script& s) {
  s.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Memory{GL_UNSIGNED_BYTE, {10, 20, 30, 40}});
}

} // namespace

std::vector<Test> special_feedback_value_tests() {
  return {
      fed_value_row(
          "viewport", "Coordinates are those of the window.",
          [](Script& s) {
            s.Viewport(17, -8, 41, 63),
                fed_back(
                    s, GL_3D, [&] { shape(s, 33, 40, 1), star(s); }, FedOrder::InOrder, 6);
          },
          "5.3, 2.11.1"),
      fed_value_row(
          "depth_range", "Depths are those of the window.",
          [](Script& s) {
            s.DepthRange(0.9, 0.25),
                fed_back(s, GL_3D, [&] { shape(s, 33, 40, 2.5), shape(s, 60, 52, -12); });
          },
          "5.3, 2.11.1"),
      fed_value_row("clip_w", "w is that of clip coordinates.",
                    [](Script& s) {
                      perspective(s), fed_back(
                                          s, GL_4D_COLOR_TEXTURE,
                                          [&] { shape(s, 50, 40, 0.7), shape(s, 30, 52, -4, GL_POINTS); },
                                          FedOrder::InOrder, 6);
                    }),
      fed_value_row("w_of_vertices", "The w of a vertex divides its coordinates, and is given as it was.",
                    [](Script& s) {
                      s.LoadIdentity(), s.MatrixMode(GL_PROJECTION), s.LoadIdentity();
                      fed_back(s, GL_4D_COLOR_TEXTURE, [&] {
                        s.Begin(GL_POINTS), s.Vertex4f(0.5, 0.25, -0.75, 2), s.Vertex4f(0.1, -0.2, 0.1, 0.5),
                            s.Vertex4f(-3, 2.5, 1, 5), s.End();
                      });
                    }),
      fed_value_row(
          "color_clamped", "Colors are clamped to [0, 1].",
          [](Script& s) {
            fed_back(s, GL_3D_COLOR, [&] {
              s.Begin(GL_POINTS), s.Color4f(1.7, -0.4, 0.3, 2), pixel_vertex(s, 20.2, 30.3),
                  s.Color4f(0.2, 0.5, 9, -1), pixel_vertex(s, 60.2, 50.3), s.End();
            });
          },
          "5.3, 2.14.6"),
      fed_value_row(
          "color_lit", "Colors are those of lighting.",
          [](Script& s) { lit(s), fed_back(s, GL_3D_COLOR, [&] { lit_faces(s); }); }, "5.3, 2.14.1"),
      fed_value_row(
          "color_two_sided", "A back face has the colors of its back.",
          [](Script& s) {
            lit(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1),
                fed_back(s, GL_3D_COLOR, [&] { lit_faces(s); });
          },
          "5.3, 2.14.1"),
      fed_value_row(
          "color_two_sided_lines", "The edges of a back face have the colors of its back.",
          [](Script& s) {
            lit(s), s.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1), s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            fed_back(
                s, GL_3D_COLOR, [&] { lit_faces(s); }, FedOrder::AnyOrder);
          },
          "5.3, 3.5.4"),
      fed_value_row(
          "color_primary", "Colors are the primary ones.",
          [](Script& s) {
            lit(s), s.Materialfv(GL_FRONT, GL_SPECULAR, V{0.6, 0.7, 0.5, 1}),
                s.Materialf(GL_FRONT, GL_SHININESS, 2);
            s.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
            fed_back(s, GL_3D_COLOR, [&] { lit_faces(s); });
          },
          "5.3", kSeparateSpecular),
      fed_value_row("color_without_fog_and_texture", "Neither fog nor textures change the colors.",
                    [](Script& s) {
                      s.Fogi(GL_FOG_MODE, GL_EXP), s.Fogf(GL_FOG_DENSITY, 0.4),
                          s.Fogfv(GL_FOG_COLOR, V{1, 0, 0, 1}), s.Enable(GL_FOG);
                      s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
                      s.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
                      s.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                   Memory{GL_UNSIGNED_BYTE, {90, 40, 20, 130}});
                      s.Enable(GL_TEXTURE_2D);
                      fed_back(s, GL_3D_COLOR_TEXTURE, [&] { shape(s, 50, 40); });
                    }),
      fed_value_row("fragment_tests", "Tests of fragments and masks do not matter.",
                    [](Script& s) {
                      s.Scissor(0, 0, 0, 0), s.Enable(GL_SCISSOR_TEST), s.AlphaFunc(GL_NEVER, 0),
                          s.Enable(GL_ALPHA_TEST);
                      s.DepthFunc(GL_NEVER), s.Enable(GL_DEPTH_TEST), s.ColorMask(0, 0, 0, 0);
                      fed_back(s, GL_3D, [&] { shape(s, 50, 40), dot(s, 20.2, 30.3); });
                    }),
      fed_value_row(
          "flat_triangle", "A flat triangle has the color of its last vertex at all three.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), fed_back(s, GL_3D_COLOR, [&] { shape(s, 50, 40), shape(s, 30, 70); });
          },
          "5.3, 2.14.7"),
      fed_value_row(
          "flat_line", "A flat line has the color of its second vertex at both.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), fed_back(
                                       s, GL_3D_COLOR, [&] { star(s); }, FedOrder::InOrder, 6);
          },
          "5.3, 2.14.7"),
      fed_value_row(
          "flat_edges", "The edges of a flat polygon have one color.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT), s.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            fed_back(
                s, GL_3D_COLOR, [&] { shape(s, 50, 40); }, FedOrder::AnyOrder);
          },
          "5.3, corollary 8"),
      fed_value_row(
          "texture_matrix", "Texture coordinates have gone through the texture matrix.",
          [](Script& s) {
            textured(s), texture_matrix(s);
            fed_back(
                s, GL_3D_COLOR_TEXTURE, [&] { shape(s, 50, 40), shape(s, 20, 70, 0, GL_POINTS); },
                FedOrder::InOrder, 6);
          },
          "5.3, 2.11.4"),
      fed_value_row(
          "texture_four", "All four texture coordinates are given.",
          [](Script& s) {
            fed_back(s, GL_3D_COLOR_TEXTURE, [&] {
              s.Begin(GL_POINTS), s.TexCoord4f(0.3, -1.2, 2.6, 4), pixel_vertex(s, 20.3, 30.2),
                  s.TexCoord1f(7.5), pixel_vertex(s, 40.3, 60.2), s.TexCoord3f(1, 2.25, -6.5),
                  pixel_vertex(s, 70.3, 50.2), s.End();
            });
          },
          "5.3, table 5.2"),
      fed_value_row(
          "texture_generated", "Generated texture coordinates are given.",
          [](Script& s) {
            textured(s), generated(s);
            fed_back(
                s, GL_3D_COLOR_TEXTURE, [&] { shape(s, 50, 40), shape(s, 20, 70, 0, GL_POINTS); },
                FedOrder::InOrder, 6);
          },
          "5.3, 2.11.4"),
      fed_value_row(
          "texture_off", "Texture coordinates are the same while no texture is enabled.",
          [](Script& s) {
            generated(s), texture_matrix(s);
            fed_back(
                s, GL_3D_COLOR_TEXTURE, [&] { shape(s, 50, 40), shape(s, 20, 70, 0, GL_POINTS); },
                FedOrder::InOrder, 6);
          },
          "5.3, corollary 2"),
      fed_value_row(
          "texture_first_unit", "Texture coordinates are those of the first unit.",
          [](Script& s) {
            fed_back(s, GL_3D_COLOR_TEXTURE, [&] {
              s.MultiTexCoord2f(GL_TEXTURE0, 0.7, 1.6), s.MultiTexCoord2f(GL_TEXTURE1, 5, 6),
                  s.ActiveTexture(GL_TEXTURE1), dot(s, 30.4, 40.6), dot(s, 50.4, 70.6);
            });
          },
          "5.3", kVersion13),
      fed_value_row(
          "clipped_line",
          "A line is given as it is cut, with the color and the texture coordinates of the cut.",
          [](Script& s) {
            fed_back(
                s, GL_3D_COLOR_TEXTURE,
                [&] {
                  s.Begin(GL_LINES), corner(s, 0, -40.3, 20.2, 1), corner(s, 3, 60.2, 50.3, -2),
                      corner(s, 1, 30.2, 140.7, 2), corner(s, 4, 70.6, 30.2, -3), corner(s, 2, 20.2, 30.5, 8),
                      corner(s, 5, 80.6, 70.2, -9), s.End();
                },
                FedOrder::InOrder, 6);
          },
          "5.3, 2.12"),
      fed_value_row(
          "clipped_triangle",
          "A triangle is given as it is cut, with the data of the corners that come from the cut.",
          [](Script& s) {
            fed_back(
                s, GL_3D_COLOR_TEXTURE,
                [&] {
                  s.Begin(GL_TRIANGLES), corner(s, 0, -40.3, 20.2, 1), corner(s, 3, 60.2, 10.3, -2),
                      corner(s, 4, 50.2, 70.7, 2), s.End();
                },
                FedOrder::AnyOrder, 6);
          },
          "5.3, 2.12, 2.14.8"),
      fed_value_row(
          "clipped_corner", "A triangle that is cut at one plane alone keeps the corner that is inside.",
          [](Script& s) {
            fed_back(
                s, GL_3D_COLOR_TEXTURE,
                [&] {
                  s.Begin(GL_TRIANGLES), corner(s, 5, 40.3, 50.2, 1), corner(s, 1, 30.2, -50.3, -2),
                      corner(s, 2, 70.2, -30.7, 2), s.End();
                },
                FedOrder::AnyOrder, 6);
          },
          "5.3, 2.12, 2.14.8"),
      fed_value_row(
          "clipped_by_plane", "Clip planes cut what is fed back.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE2, V{-1, 0.3, 0, 0.2}), s.Enable(GL_CLIP_PLANE2);
            fed_back(
                s, GL_3D_COLOR,
                [&] { shape(s, 58.2, 40), dot(s, 80, 30), dot(s, 20.2, 31.3), shape(s, 80.3, 25); },
                FedOrder::AnyOrder, 6);
          },
          "5.3, 2.12"),
      fed_value_row(
          "clipped_flat", "A flat triangle that is cut has its color at all corners.",
          [](Script& s) {
            s.ShadeModel(GL_FLAT);
            fed_back(
                s, GL_3D_COLOR, [&] { shape(s, 3, 40); }, FedOrder::AnyOrder);
          },
          "5.3, 2.14.7, 2.14.8"),
      fed_value_row(
          "clipped_away", "What is outside of the clip volume is not given.",
          [](Script& s) {
            fed_back(s, GL_2D, [&] {
              shape(s, 140, 40), dot(s, -5, 30), dot(s, 20.3, 40.2), dot(s, 30, 40, 9), shape(s, 40, -60);
              s.Begin(GL_LINES), pixel_vertex(s, -20, 150), pixel_vertex(s, 80, 130), s.End();
            });
          },
          "5.3, 2.12"),
      fed_value_row("bitmap", "A bitmap is GL_BITMAP_TOKEN and the raster position.",
                    [](Script& s) {
                      fed_back(s, GL_3D, [&] {
                        raster_at(s, 30.3, 40.2, 1), bitmap(s), raster_at(s, 70.3, 20.2, -3), bitmap(s);
                      });
                    }),
      fed_value_row(
          "bitmap_moves", "A bitmap moves the raster position while there is feedback.",
          [](Script& s) {
            fed_back(s, GL_2D,
                     [&] { raster_at(s, 30.3, 40.2), bitmap(s, 11.5, -7), bitmap(s, 5, 20), bitmap(s); });
          },
          "5.3, 3.7"),
      fed_value_row(
          "pixels",
          "glDrawPixels is GL_DRAW_PIXEL_TOKEN and the raster position, glCopyPixels GL_COPY_PIXEL_TOKEN.",
          [](Script& s) {
            fed_back(s, GL_3D, [&] {
              raster_at(s, 30.3, 40.2, 1), draw_pixels(s), raster_at(s, 20.3, 70.2, -1),
                  s.CopyPixels(0, 0, 2, 2, GL_COLOR), draw_pixels(s);
            });
          }),
      fed_value_row(
          "raster_color",
          "A bitmap or image has the color and the texture coordinates of the raster position.",
          [](Script& s) {
            fed_back(s, GL_4D_COLOR_TEXTURE, [&] {
              s.Color4f(0.3, 0.9, 0.6, 0.4), s.TexCoord2f(0.3, -2.4), raster_at(s, 30.3, 40.2, 1);
              s.Color4f(1, 0, 1, 1), s.TexCoord2f(7, 9), bitmap(s), draw_pixels(s),
                  s.CopyPixels(0, 0, 1, 1, GL_COLOR);
            });
          },
          "5.3, 2.13"),
      fed_value_row(
          "raster_w", "A bitmap has the w of the raster position.",
          [](Script& s) {
            perspective(s), s.Color4f(0.3, 0.9, 0.6, 0.4);
            fed_back(s, GL_4D_COLOR_TEXTURE, [&] {
              raster_at(s, 30.3, 40.2, 1), bitmap(s), raster_at(s, 60.3, 40.2, -3), bitmap(s);
            });
          },
          "5.3, 2.13"),
      fed_value_row("raster_invalid", "At an invalid raster position bitmaps and images give nothing.",
                    [](Script& s) {
                      fed_back(s, GL_2D, [&] {
                        raster_at(s, -30, 40), bitmap(s, 50, 0), draw_pixels(s),
                            s.CopyPixels(0, 0, 1, 1, GL_COLOR), s.PassThrough(5), bitmap(s);
                      });
                    }),
      fed_value_row(
          "window_position", "Behind glWindowPos the position is that of the window.",
          [](Script& s) {
            fed_back(s, GL_3D, [&] {
              s.WindowPos3f(33.25, 61.5, 0.3), bitmap(s), s.WindowPos2i(-20, 7), draw_pixels(s);
            });
          },
          "5.3, 2.13", kVersion14),
  };
}

} // namespace softgl::suite
