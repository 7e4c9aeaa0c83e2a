// The raster position (2.13), which bitmaps show (3.7).
#include "vertices/chapter.h"
#include "vertices/scenes.h"

namespace softgl::suite {
namespace {

constexpr Need kWindowPos{14, "GL_ARB_window_pos"};

// A square of 16 x 16 ones; the raster position moves by (dx, dy).
void stamp(Script& s, double dx = 0, double dy = 0, double origin_x = 0, double origin_y = 0) {
  s.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  s.Bitmap(16, 16, origin_x, origin_y, dx, dy, Memory{GL_UNSIGNED_BYTE, std::vector<double>(32, 255)});
}

// Object coordinates are pixels.
void pixels(Script& s) {
  s.MatrixMode(GL_PROJECTION), s.LoadIdentity(), s.Ortho(0, 96, 0, 96, -10, 10), s.MatrixMode(GL_MODELVIEW),
      s.LoadIdentity();
}

} // namespace

std::vector<Test> vertices_raster_position_tests() {
  return {
      row("raster_position.transformed", "2.13", "The raster position is transformed as a vertex.",
          [](Script& s) {
            tint(s, 0), s.RasterPos3f(-0.51, -0.6, 0), stamp(s), s.Rotatef(90, 0, 0, 1), tint(s, 1),
                s.RasterPos3f(0.43, 0.31, 0.2), stamp(s);
          }),
      row("raster_position.two", "2.13", "glRasterPos2 of each type has z = 0 and w = 1.",
          [](Script& s) {
            pixels(s), s.Translatef(0.4, 0.3, 0);
            tint(s, 0), s.RasterPos2s(5, 5), stamp(s), tint(s, 1), s.RasterPos2sv(V{25, 7}), stamp(s),
                tint(s, 2), s.RasterPos2i(45, 5), stamp(s);
            tint(s, 3), s.RasterPos2iv(V{5, 40}), stamp(s), tint(s, 4), s.RasterPos2f(25.1, 42.2), stamp(s);
            tint(s, 5), s.RasterPos2fv(V{45.1, 44}), stamp(s), tint(s, 6), s.RasterPos2d(65.2, 60.1),
                stamp(s);
            tint(s, 0), s.RasterPos2dv(V{70, 8.1}), stamp(s);
          }),
      row("raster_position.three", "2.13", "glRasterPos3 of each type has w = 1.",
          [](Script& s) {
            pixels(s), s.Translatef(0.4, 0.3, 0);
            tint(s, 0), s.RasterPos3s(5, 5, 1), stamp(s), tint(s, 1), s.RasterPos3sv(V{25, 7, 2}), stamp(s),
                tint(s, 2), s.RasterPos3i(45, 5, 3), stamp(s);
            tint(s, 3), s.RasterPos3iv(V{5, 40, -4}), stamp(s), tint(s, 4), s.RasterPos3fv(V{25.1, 42.2, 5}),
                stamp(s);
            tint(s, 6), s.RasterPos3d(65.2, 60.1, -6), stamp(s), tint(s, 0), s.RasterPos3dv(V{70, 8.1, 7}),
                stamp(s);
          }),
      row("raster_position.four", "2.13", "glRasterPos4 of each type gives w itself.",
          [](Script& s) {
            pixels(s);
            tint(s, 0), s.RasterPos4s(11, 11, 1, 2), stamp(s), tint(s, 1), s.RasterPos4sv(V{51, 15, 2, 2}),
                stamp(s);
            tint(s, 2), s.RasterPos4i(91, 11, 3, 2), stamp(s), tint(s, 3), s.RasterPos4iv(V{11, 81, -4, 2}),
                stamp(s);
            tint(s, 4), s.RasterPos4f(12.7, 21.2, 1, 0.5), stamp(s), tint(s, 5),
                s.RasterPos4fv(V{90.2, 90.2, 1, 2}), stamp(s);
            tint(s, 6), s.RasterPos4d(261, 241, -6, 4), stamp(s), tint(s, 0),
                s.RasterPos4dv(V{281, 33, 7, 4}), stamp(s);
          }),
      row("raster_position.bitmap_moves", "3.7", "A bitmap moves the raster position by what it says.",
          [](Script& s) {
            pixels(s), tint(s, 3), s.RasterPos2f(8.4, 6.4);
            for (int i = 0; i < 4; i++) stamp(s, 20, i % 2 ? -3 : 27);
          }),
      row("raster_position.bitmap_moves_back", "3.7", "The move may be negative or a fraction.",
          [](Script& s) {
            pixels(s), tint(s, 1), s.RasterPos2f(70.25, 70.25);
            for (int i = 0; i < 4; i++) stamp(s, -18.1, -20.2);
          }),
      row("raster_position.bitmap_origin", "3.7",
          "A bitmap lies with its origin at the raster position, rounded down.",
          [](Script& s) {
            pixels(s), tint(s, 3), s.RasterPos2f(40.6, 30.3), stamp(s, 0, 0, 10.2, 3.9), tint(s, 4),
                stamp(s, 0, 0, -10.2, -20.5);
          }),
      row("raster_position.color", "2.13",
          "The raster position keeps the color that was current when it was set.",
          [](Script& s) {
            tint(s, 1), s.RasterPos3f(-0.31, -0.2, 0), tint(s, 0), stamp(s, 20, 0), arrow(s), stamp(s);
          }),
      row("raster_position.invalid", "2.13, 3.7",
          "A position outside of the clip volume is invalid: no bitmap is drawn.",
          [](Script& s) {
            tint(s, 1), s.RasterPos3f(-1.25, 0, 0), stamp(s),
                s.GetFloatv(GL_CURRENT_RASTER_POSITION_VALID, V{0});
            s.RasterPos3f(0, 0, 8), stamp(s), s.RasterPos4f(0.1, 0.1, 0, -1), stamp(s);
            tint(s, 2), s.RasterPos3f(0.21, 0.3, 0), stamp(s),
                s.GetFloatv(GL_CURRENT_RASTER_POSITION_VALID, V{1});
          }),
      row("raster_position.invalid_stays", "3.7",
          "A bitmap does not move an invalid position back into the volume.",
          [](Script& s) {
            pixels(s), tint(s, 0), s.RasterPos2f(-3.5, 20.4), stamp(s, 40, 10), stamp(s, 10, 10);
            tint(s, 1), s.RasterPos2f(60.5, 20.5), stamp(s);
          }),
      row("raster_position.moved_out", "3.7",
          "A valid position that a bitmap moves out of the window stays valid.",
          [](Script& s) {
            pixels(s), tint(s, 5), s.RasterPos2f(10.5, 40.5), stamp(s, -60, 0), stamp(s, 90, 10), stamp(s);
          }),
      row("raster_position.clip_plane", "2.13", "A plane of the user makes a position invalid.",
          [](Script& s) {
            pixels(s), s.ClipPlane(GL_CLIP_PLANE0, V{1, 0, 0, -48}), s.Enable(GL_CLIP_PLANE0);
            tint(s, 0), s.RasterPos2f(20.5, 20.5), stamp(s), tint(s, 1), s.RasterPos2f(60.5, 20.5), stamp(s);
          }),
      row("raster_position.queried", "2.13, table 6.5", "Position, color and validity can be asked for.",
          [](Script& s) {
            s.GetFloatv(GL_CURRENT_RASTER_POSITION, V{0, 0, 0, 1}),
                s.GetFloatv(GL_CURRENT_RASTER_COLOR, V{1, 1, 1, 1});
            s.GetFloatv(GL_CURRENT_RASTER_POSITION_VALID, V{1});
            s.RasterPos3f(0, 0, 0), s.GetFloatv(GL_CURRENT_RASTER_DISTANCE, V{5});
            pixels(s), s.Color4f(0.5, 0.25, 0.75, 0.5), s.RasterPos3f(32.5, 48.5, 5);
            s.GetFloatv(GL_CURRENT_RASTER_POSITION, V{32.5, 48.5, 0.25, 1}),
                s.GetFloatv(GL_CURRENT_RASTER_COLOR, V{0.5, 0.25, 0.75, 0.5});
            stamp(s, 3.5, -2), s.GetFloatv(GL_CURRENT_RASTER_POSITION, V{36, 46.5, 0.25, 1});
          }),
      row("raster_position.saved", "6.1.14, table 6.5",
          "GL_CURRENT_BIT saves the raster position and its color.",
          [](Script& s) {
            pixels(s), tint(s, 1), s.RasterPos2f(20.5, 20.5), s.PushAttrib(GL_CURRENT_BIT), tint(s, 0),
                s.RasterPos2f(60.5, 60.5), s.PopAttrib();
            stamp(s);
          }),
      row("raster_position.viewport", "2.13, 2.11.1", "The viewport is where the raster position comes out.",
          [](Script& s) {
            s.Viewport(20, 30, 60, 50), tint(s, 2), s.RasterPos3f(-0.41, 0.27, 0), stamp(s), tint(s, 3),
                s.RasterPos3f(0.23, -0.61, 0), stamp(s);
          }),
      row("raster_position.depth_range", "2.13, 2.11.1",
          "The depth range maps the depth of the raster position.",
          [](Script& s) {
            pixels(s), s.DepthRange(0.5, 1), s.RasterPos3f(32.5, 48.5, 5), tint(s, 4);
            s.GetFloatv(GL_CURRENT_RASTER_POSITION, V{32.5, 48.5, 0.625, 1}), s.DepthRange(0.75, 0.25),
                s.RasterPos3f(20.5, 12.5, -5),
                s.GetFloatv(GL_CURRENT_RASTER_POSITION, V{20.5, 12.5, 0.375, 1});
          }),
      row(
          "raster_position.window_two", "2.13",
          "glWindowPos2 of each type counts in pixels of the window, whatever matrices and viewport are.",
          [](Script& s) {
            s.Viewport(10, 20, 30, 30), s.Scalef(3, 3, 3);
            tint(s, 0), s.WindowPos2s(5, 5), stamp(s), tint(s, 1), s.WindowPos2sv(V{25, 7}), stamp(s),
                tint(s, 2), s.WindowPos2i(45, 5), stamp(s);
            tint(s, 3), s.WindowPos2iv(V{5, 40}), stamp(s), tint(s, 4), s.WindowPos2f(25.5, 42.5), stamp(s);
            tint(s, 5), s.WindowPos2fv(V{45.5, 44.25}), stamp(s), tint(s, 6), s.WindowPos2d(65.25, 60.5),
                stamp(s);
            tint(s, 0), s.WindowPos2dv(V{70, 8.5}), stamp(s);
          },
          kWindowPos),
      row(
          "raster_position.window_three", "2.13",
          "The z of glWindowPos3 is clamped and goes through the depth range.",
          [](Script& s) {
            const auto is = [&](double x, double y, double z) {
              s.GetFloatv(GL_CURRENT_RASTER_POSITION, V{x, y, z, 1});
            };
            s.DepthRange(0.25, 0.75), s.WindowPos3f(5.5, 7.5, 0.5), is(5.5, 7.5, 0.5);
            s.WindowPos3fv(V{9.5, 8.5, 0.25}), is(9.5, 8.5, 0.375), s.WindowPos3d(1.5, 2.5, -4),
                is(1.5, 2.5, 0.25), s.WindowPos3dv(V{11.5, 12.5, 7}), is(11.5, 12.5, 0.75);
            s.WindowPos3s(3, 4, 1), is(3, 4, 0.75), s.WindowPos3sv(V{30, 40, 0}), is(30, 40, 0.25),
                s.WindowPos3i(-3, 4, 0), is(-3, 4, 0.25), s.WindowPos3iv(V{13, 14, 1}), is(13, 14, 0.75);
            s.WindowPos2i(50, 60), is(50, 60, 0.25), tint(s, 3), stamp(s);
          },
          kWindowPos),
      row(
          "raster_position.window_valid", "2.13",
          "A window position is valid wherever it is, and nothing clips it.",
          [](Script& s) {
            s.ClipPlane(GL_CLIP_PLANE0, V{0, 0, 0, -1}), s.Enable(GL_CLIP_PLANE0), s.RasterPos3f(0, 0, 0),
                s.GetFloatv(GL_CURRENT_RASTER_POSITION_VALID, V{0}), tint(s, 1), s.WindowPos2i(-8, 20);
            s.GetFloatv(GL_CURRENT_RASTER_POSITION_VALID, V{1}),
                s.GetFloatv(GL_CURRENT_RASTER_DISTANCE, V{0}), stamp(s, 60, 30), stamp(s);
          },
          kWindowPos),
      row(
          "raster_position.window_color", "2.13",
          "A window position takes the current color, which is not lit, and clamps it.",
          [](Script& s) {
            s.Enable(GL_LIGHTING), s.Enable(GL_LIGHT0), s.Color4f(0.25, 3, -1, 0.5), s.WindowPos2i(20, 20),
                stamp(s, 30, 30);
            s.GetFloatv(GL_CURRENT_RASTER_COLOR, V{0.25, 1, 0, 0.5}), tint(s, 0), stamp(s);
          },
          kWindowPos),
      row("raster_position.list", "2.13, 5.4", "A list holds raster positions and bitmaps.",
          [](Script& s) {
            pixels(s), s.NewList(4, GL_COMPILE), tint(s, 3), s.RasterPos2f(30.5, 30.5), stamp(s, 20, 20),
                stamp(s), s.EndList();
            s.Translatef(-10, 5, 0), s.CallList(4);
          }),
  };
}

} // namespace softgl::suite
