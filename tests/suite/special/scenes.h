// What the tests of special functions draw, and how what comes of it is shown.
#pragma once

#include "raster/scenes.h"
#include "run/test.h"
#include "script/fed_values.h"

namespace softgl::suite {

/// `name` without the chapter's.
Test special_test(const std::string& name, const char* section, const char* sentence,
                  std::function<void(Script&)> body, Need need = {}, const char* open = "");

/// Feeds back what is drawn, and paints it in squares of a size. The buffer takes `numbers`.
void fed_back(Script& s, GLenum type, const std::function<void()>& draw, FedOrder order = FedOrder::InOrder,
              int size = 8, int numbers = 600);
/// Selects what is drawn, and paints the first `room` numbers of a buffer that takes `numbers`.
void selected(Script& s, const std::function<void()>& draw, int room = 40, int numbers = 40);

/// Corners with colors and texture coordinates of their own, in pixels of the window.
void corner(Script& s, int color, double x, double y, double z = 0);
/// A triangle around a place, of such corners.
void shape(Script& s, double x, double y, double z = 0, GLenum mode = GL_TRIANGLES);
/// A point that is selected.
void dot(Script& s, double x, double y, double z = 0);
/// Sets a raster position in pixels of the window.
void raster_at(Script& s, double x, double y, double z = 0);

} // namespace softgl::suite
