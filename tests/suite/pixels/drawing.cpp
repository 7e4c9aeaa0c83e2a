// Zoom, pixel transfer, depths, and what a raster position gives to images and bitmaps (3.6.4 to 3.7, 2.13).
#include "pixels/chapter.h"
#include "pixels/scenes.h"
#include "texture/scenes.h"

namespace softgl::suite {
namespace {

Test zoomed(const char* name, const char* sentence, double at, double x, double y, int size) {
  return pixel_test(name, "3.6.4", sentence, [=](Script& s) {
    s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), place(s, at, at), s.PixelZoom(x, y);
    s.DrawPixels(size, size, GL_RGB, GL_UNSIGNED_BYTE, elements_of(GL_UNSIGNED_BYTE, size * size * 3));
  });
}

// Pixel transfer for one image, undone behind it.
Test transferred(const char* name, const char* sentence, std::function<void(Script&)> state) {
  return pixel_test(name, "3.6.5", sentence, [=](Script& s) {
    show_alpha(s), state(s), draw_image(s, GL_RGBA, GL_UNSIGNED_BYTE);
    for (GLenum scale : {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE})
      s.PixelTransferf(scale, 1.0);
    for (GLenum bias : {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS}) s.PixelTransferf(bias, 0.0);
    s.PixelTransferi(GL_MAP_COLOR, 0);
  });
}

const Memory kBits{GL_UNSIGNED_BYTE,
                   {0xc3, 0x81, 0x5a, 0x3c, 0xff, 0x01, 0x18, 0x77, 0x80, 0xf0, 0x0f, 0x6e,
                    0x99, 0x42, 0x24, 0xe7, 0xaa, 0x55, 0x33, 0xcc, 0x1f, 0xf8, 0x70, 0x0e,
                    0xc3, 0x81, 0x5a, 0x3c, 0xff, 0x01, 0x18, 0x77, 0x80, 0xf0, 0x0f, 0x6e,
                    0x99, 0x42, 0x24, 0xe7, 0xaa, 0x55, 0x33, 0xcc, 0x1f, 0xf8, 0x70, 0x0e}};

// Bitmaps of 16x12 in rows of two bytes all over the window.
void bitmaps(Script& s, double x_origin = 0, double y_origin = 0) {
  s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.Color3f(0.9f, 0.7f, 0.2f);
  for (int i = 0; i < 4; i++)
    place(s, 10.3 + 18 * i, 12.2 + 15 * i), s.Bitmap(16, 12, x_origin, y_origin, 0, 0, kBits);
}
// Depths of a 8x8 image.
Memory depths() {
  Memory m = elements_of(GL_FLOAT, 64);
  return m;
}

} // namespace

std::vector<Test> pixel_draw_tests() {
  return {
      zoomed("zoom.one", "An image begins at the raster position.", 8.3, 1, 1, 40),
      zoomed("zoom.large", "Each pixel becomes a rectangle of the zoom factors.", 8.3, 9, 6, 8),
      zoomed("zoom.half", "With a zoom below 1 some pixels are not seen.", 8, 0.6, 0.6, 96),
      zoomed("zoom.fraction", "A zoom need not be whole.", 8, 1.4, 2.2, 30),
      zoomed("zoom.negative_x", "A negative zoom draws to the left.", 80.3, -8, 4, 8),
      zoomed("zoom.negative_y", "A negative zoom draws downwards.", 80.3, 1, -8, 8),
      zoomed("zoom.turned", "Two negative zooms turn the image round.", 80.3, -7, -8, 8),
      zoomed("zoom.clipped", "What lies outside of the window is not drawn.", 70.3, 8, 8, 8),

      transferred("transfer.scale", "Each component has a scale.",
                  [](Script& s) {
                    s.PixelTransferf(GL_RED_SCALE, 0.5), s.PixelTransferf(GL_GREEN_SCALE, 2.0);
                    s.PixelTransferf(GL_BLUE_SCALE, 0.0), s.PixelTransferf(GL_ALPHA_SCALE, 0.75);
                  }),
      transferred("transfer.bias", "Each component has a bias, added behind the scale.",
                  [](Script& s) {
                    s.PixelTransferf(GL_RED_SCALE, -1.0), s.PixelTransferf(GL_RED_BIAS, 1.0);
                    s.PixelTransferf(GL_GREEN_BIAS, 0.25), s.PixelTransferf(GL_BLUE_BIAS, -0.5);
                    s.PixelTransferf(GL_ALPHA_BIAS, 0.5);
                  }),
      transferred("transfer.map", "With GL_MAP_COLOR each component goes through its map.",
                  [](Script& s) {
                    s.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 4, V{1, 0.2, 0.6, 0}),
                        s.PixelMapfv(GL_PIXEL_MAP_G_TO_G, 2, V{0.9, 0.3});
                    s.PixelMapfv(GL_PIXEL_MAP_B_TO_B, 7, V{0, 0.1, 0.5, 1, 0.4, 0.3, 0.8}),
                        s.PixelMapfv(GL_PIXEL_MAP_A_TO_A, 3, V{1, 0.5, 0.75});
                    s.PixelTransferi(GL_MAP_COLOR, 1);
                  }),
      transferred("transfer.map_after_scale", "The maps come behind scale and bias, and take [0, 1].",
                  [](Script& s) {
                    for (GLenum map :
                         {GL_PIXEL_MAP_R_TO_R, GL_PIXEL_MAP_G_TO_G, GL_PIXEL_MAP_B_TO_B, GL_PIXEL_MAP_A_TO_A})
                      s.PixelMapfv(map, 4, V{1, 0.3, 0.7, 0.5});
                    s.PixelTransferf(GL_RED_SCALE, 3.0), s.PixelTransferf(GL_GREEN_BIAS, -0.5),
                        s.PixelTransferi(GL_MAP_COLOR, 1);
                  }),
      transferred("transfer.map_off", "Without GL_MAP_COLOR the maps do nothing.",
                  [](Script& s) {
                    s.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, V{1, 0});
                  }),
      pixel_test("transfer.stack", "6.1.14, table 6.22", "GL_PIXEL_MODE_BIT brings back transfer and zoom.",
                 [](Script& s) {
                   place(s, 8.3, 8.2), s.PixelZoom(8, 8), s.PushAttrib(GL_PIXEL_MODE_BIT), s.PixelZoom(2, 3);
                   s.PixelTransferf(GL_RED_SCALE, 0.2), s.PixelTransferf(GL_DEPTH_BIAS, 0.4), s.PopAttrib();
                   s.DrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, elements_of(GL_UNSIGNED_BYTE, 256));
                 }),

      pixel_test("draw.raster_depth", "3.6.4, 4.1.6", "An image has the depth of the raster position.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), varied_sheet(s, -0.8, 0.8),
                       draw_image(s, GL_RGB, GL_UNSIGNED_BYTE);
                 }),
      pixel_test("draw.fog", "3.6.4, 3.10", "The distance of the raster position makes fog.",
                 [](Script& s) {
                   s.Fogi(GL_FOG_MODE, GL_LINEAR), s.Fogf(GL_FOG_START, 0.0), s.Fogf(GL_FOG_END, 9.0);
                   s.Fogfv(GL_FOG_COLOR, V{0.2, 0.9, 0.4, 1}), s.Enable(GL_FOG),
                       draw_image(s, GL_RGB, GL_UNSIGNED_BYTE);
                 }),
      pixel_test("draw.texture", "3.6.4, 3.8",
                 "The texture at the raster position's coordinates meets each pixel.",
                 [](Script& s) {
                   replace_scene(s), environment(s, GL_MODULATE), s.TexCoord2f(0.4f, 0.6f),
                       draw_image(s, GL_RGB, GL_UNSIGNED_BYTE);
                 }),
      pixel_test("draw.current_color", "3.6.4", "An image of colors does not take the current color.",
                 [](Script& s) { s.Color3f(0.2f, 0.1f, 0.9f), draw_image(s, GL_RGB, GL_UNSIGNED_BYTE); }),
      pixel_test("draw.alpha_test", "4.1.4", "Pixels go through the alpha test.",
                 [](Script& s) {
                   s.AlphaFunc(GL_LESS, 0.53), s.Enable(GL_ALPHA_TEST),
                       draw_image(s, GL_RGBA, GL_UNSIGNED_BYTE);
                 }),
      pixel_test("draw.blended", "4.1.7", "Pixels are blended.",
                 [](Script& s) {
                   varied_sheet(s), show_alpha(s), draw_image(s, GL_RGBA, GL_UNSIGNED_BYTE, 6, 6, 10);
                 }),
      pixel_test("draw.invalid_position", "2.13, 3.6.4", "At an invalid raster position nothing is drawn.",
                 [](Script& s) {
                   varied_sheet(s), s.RasterPos3f(-3.0f, 0.0f, 0.0f), s.PixelZoom(8, 8);
                   s.DrawPixels(16, 8, GL_RED, GL_UNSIGNED_BYTE, elements_of(GL_UNSIGNED_BYTE, 128));
                   s.PaintInteger(GL_CURRENT_RASTER_POSITION_VALID, 0, 0, 2, 2);
                 }),
      pixel_test("draw.list", "5.4", "A list draws images.",
                 [](Script& s) {
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.NewList(4, GL_COMPILE), place(s, 8.3, 8.2),
                       s.PixelZoom(7, 7);
                   s.DrawPixels(8, 8, GL_RGB, GL_UNSIGNED_BYTE, elements_of(GL_UNSIGNED_BYTE, 192)),
                       s.EndList(), s.CallList(4);
                 }),
      pixel_test("depth.colors", "3.6.4", "An image of depths has the color of the raster position.",
                 [](Script& s) {
                   s.Color3f(0.9f, 0.6f, 0.1f), place(s, 8.3, 8.2), s.PixelZoom(8, 8),
                       s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_ALWAYS);
                   s.DrawPixels(8, 8, GL_DEPTH_COMPONENT, GL_FLOAT, depths());
                 }),
      pixel_test("depth.written", "3.6.4, 4.1.6", "An image of depths is compared with what is drawn later.",
                 [](Script& s) {
                   s.Color3f(0.9f, 0.6f, 0.1f), place(s, 8.3, 8.2), s.PixelZoom(8, 8),
                       s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_ALWAYS);
                   s.DrawPixels(8, 8, GL_DEPTH_COMPONENT, GL_FLOAT, depths()), s.DepthFunc(GL_LESS),
                       varied_sheet(s, -2, 2);
                 }),
      pixel_test("depth.compared", "3.6.4, 4.1.6",
                 "Each depth of an image is compared with the depth buffer.",
                 [](Script& s) {
                   s.Enable(GL_DEPTH_TEST), varied_sheet(s, -8, 3), s.Color3f(0.9f, 0.6f, 0.1f),
                       place(s, 8.3, 8.2), s.PixelZoom(8, 8);
                   s.DrawPixels(8, 8, GL_DEPTH_COMPONENT, GL_FLOAT, depths());
                 }),
      pixel_test("depth.transfer", "3.6.5", "Depths have a scale and a bias.",
                 [](Script& s) {
                   s.Color3f(0.9f, 0.6f, 0.1f), place(s, 8.3, 8.2), s.PixelZoom(8, 8),
                       s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_ALWAYS);
                   s.PixelTransferf(GL_DEPTH_SCALE, 0.5), s.PixelTransferf(GL_DEPTH_BIAS, 0.3);
                   s.DrawPixels(8, 8, GL_DEPTH_COMPONENT, GL_FLOAT, depths());
                   s.PixelTransferf(GL_DEPTH_SCALE, 1.0), s.PixelTransferf(GL_DEPTH_BIAS, 0.0);
                   s.DepthFunc(GL_LESS), varied_sheet(s, -2, 2);
                 }),
      pixel_test("depth.shorts", "3.6.4", "Depths may be unsigned shorts.",
                 [](Script& s) {
                   s.Color3f(0.9f, 0.6f, 0.1f), place(s, 8.3, 8.2), s.PixelZoom(8, 8),
                       s.Enable(GL_DEPTH_TEST), s.DepthFunc(GL_ALWAYS);
                   s.DrawPixels(8, 8, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT,
                                elements_of(GL_UNSIGNED_SHORT, 64));
                   s.DepthFunc(GL_LESS), varied_sheet(s, -2, 2);
                 }),

      pixel_test("bitmap.bits", "3.7", "Ones of a bitmap are drawn, zeros are not.",
                 [](Script& s) { bitmaps(s); }),
      pixel_test("bitmap.origin", "3.7", "The origin is subtracted from the raster position.",
                 [](Script& s) { bitmaps(s, 3, 5); }),
      pixel_test("bitmap.fractions", "3.7", "Position less origin is rounded down.",
                 [](Script& s) { bitmaps(s, 2.6, -1.9); }),
      pixel_test("bitmap.move", "3.7", "A bitmap moves the raster position.",
                 [](Script& s) {
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.Color3f(0.4f, 0.9f, 0.7f), place(s, 9.3, 9.2);
                   for (int i = 0; i < 4; i++) s.Bitmap(16, 12, 0, 0, 17.5, 11.25, kBits);
                 }),
      pixel_test("bitmap.empty", "3.7", "An empty bitmap moves the raster position, too.",
                 [](Script& s) {
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.Color3f(0.4f, 0.9f, 0.7f), place(s, 9.3, 9.2);
                   s.Bitmap(0, 0, 0, 0, 33, 21, Memory{GL_NONE, {}}), s.Bitmap(16, 12, 0, 0, 0, 0, kBits);
                   s.Bitmap(0, 0, 0, 0, -20, 18, Memory{GL_NONE, {}}), s.Bitmap(16, 12, 0, 0, 0, 0, kBits);
                 }),
      pixel_test("bitmap.not_zoomed", "3.7", "The zoom does not change bitmaps.",
                 [](Script& s) { s.PixelZoom(3, -2), bitmaps(s); }),
      pixel_test("bitmap.lsb_first", "3.6.1, 3.7",
                 "GL_UNPACK_LSB_FIRST begins with the least significant bit.",
                 [](Script& s) { s.PixelStorei(GL_UNPACK_LSB_FIRST, 1), bitmaps(s); }),
      pixel_test("bitmap.alignment", "3.6.4, 3.7", "Rows of bitmaps are aligned.",
                 [](Script& s) {
                   s.Color3f(0.9f, 0.7f, 0.2f), place(s, 20.3, 20.2), s.Bitmap(11, 12, 0, 0, 0, 0, kBits);
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 2), place(s, 50.3, 50.2),
                       s.Bitmap(7, 12, 0, 0, 0, 0, kBits);
                 }),
      pixel_test("bitmap.row_length", "3.6.4, 3.7", "Rows and bits of bitmaps are skipped.",
                 [](Script& s) {
                   s.PixelStorei(GL_UNPACK_ROW_LENGTH, 24), s.PixelStorei(GL_UNPACK_SKIP_PIXELS, 5),
                       s.PixelStorei(GL_UNPACK_SKIP_ROWS, 1);
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.Color3f(0.9f, 0.7f, 0.2f), place(s, 20.3, 20.2);
                   s.Bitmap(13, 12, 0, 0, 0, 0, kBits), place(s, 50.3, 40.2),
                       s.Bitmap(19, 9, 0, 0, 0, 0, kBits);
                 }),
      pixel_test("bitmap.color_of_position", "2.13, 3.7",
                 "A bitmap has the color that was current at the raster position.",
                 [](Script& s) {
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.Color3f(0.9f, 0.7f, 0.2f), place(s, 20.3, 20.2),
                       s.Color3f(0, 0, 1);
                   s.Bitmap(16, 12, 0, 0, 30, 30, kBits), s.Bitmap(16, 12, 0, 0, 0, 0, kBits);
                 }),
      pixel_test("bitmap.texture", "3.7, 3.8",
                 "The texture at the raster position's coordinates meets a bitmap.",
                 [](Script& s) { replace_scene(s), s.TexCoord2f(0.4f, 0.6f), bitmaps(s); }),
      pixel_test("bitmap.depth", "3.7, 4.1.6", "A bitmap has the depth of the raster position.",
                 [](Script& s) { s.Enable(GL_DEPTH_TEST), varied_sheet(s, -0.8, 0.8), bitmaps(s); }),
      pixel_test("bitmap.clipped", "3.7", "What of a bitmap lies outside of the window is not drawn.",
                 [](Script& s) {
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.Color3f(0.9f, 0.7f, 0.2f);
                   for (double at : {0.3, 88.3}) place(s, at, at), s.Bitmap(16, 12, 6, 5, 0, 0, kBits);
                 }),
      pixel_test("bitmap.moved_outside", "3.7",
                 "A bitmap may move a raster position out of the window, where it stays valid.",
                 [](Script& s) {
                   s.PixelStorei(GL_UNPACK_ALIGNMENT, 1), s.Color3f(0.9f, 0.7f, 0.2f), place(s, 5.3, 40.2);
                   s.Bitmap(0, 0, 0, 0, -9, 0, Memory{GL_NONE, {}}), s.Bitmap(16, 12, 0, 0, 30, 10, kBits),
                       s.Bitmap(16, 12, 0, 0, 0, 0, kBits);
                 }),
      pixel_test("bitmap.invalid_position", "2.13, 3.7",
                 "At an invalid raster position a bitmap draws nothing and moves nothing.",
                 [](Script& s) {
                   varied_sheet(s), s.RasterPos3f(-3.0f, 0.0f, 0.0f), s.Bitmap(16, 12, 0, 0, 80, 0, kBits),
                       s.Bitmap(16, 12, 0, 0, 0, 0, kBits);
                   s.PaintInteger(GL_CURRENT_RASTER_POSITION_VALID, 0, 0, 2, 2);
                 }),
  };
}

} // namespace softgl::suite
