// What feedback gives (5.3, figure 5.2), without what the specification leaves open, and numbers as colors.
#pragma once

#include "script/script.h"
#include "spec/interval.h"

namespace softgl::suite {

using spec::Interval;

/// A point, line, polygon, bitmap, pixel rectangle or mark.
struct FedItem {
  GLenum token = GL_NONE;
  std::vector<std::vector<Interval>> vertices; // a mark has one number
};

/// How what is fed back is painted. A polygon may begin with any of its corners, so they are sorted; of more
/// than three corners it may be cut into triangles (5.3).
enum class FedOrder {
  InOrder,  // token and vertices of each item; it does not matter whether a line resets the stipple
  AnyOrder, // all corners of polygons once, and the area; all lines; all points: each group sorted
  Raw,      // the whole buffer, for what holds no polygon
  Resets,   // InOrder, and lines that reset the stipple are told apart
};

/// What memory holds before a GL writes to it.
constexpr double kUntouchedFeedback = -9;
constexpr double kUntouchedName = 0x5a5a5a5a;

/// The numbers of a vertex by table 5.2, of RGBA colors.
int numbers_of_vertex(GLenum type);
/// Reads a buffer as far as it follows the grammar of figure 5.2.
std::vector<FedItem> fed_items(GLenum type, const std::vector<double>& values);
/// The numbers that are painted of them. Not Raw.
std::vector<Interval> painted_numbers(std::vector<FedItem> items, FedOrder order);
/// The place of a vertex in the order in which they are painted.
double place_of(const std::vector<Interval>& vertex);

/// How many squares of a size the window has.
int painted_squares(int size);
/// A number of feedback as red, green and blue. Each is a wave, and goes up and down with the number: red
/// tells thousands, green tens, blue fractions. It has no jumps, so that an interval stays one.
void paint_number(Interval number, Interval color[3]);
/// A number of a hit record: red and green tell depths, blue names below 64.
void paint_record_number(Interval number, Interval color[3]);

} // namespace softgl::suite
