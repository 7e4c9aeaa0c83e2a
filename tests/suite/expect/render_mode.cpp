#include "expect/render_mode.h"

#include <algorithm>
#include <stdexcept>

namespace softgl::suite {
namespace {

constexpr double kMost = 4294967295.0;    // of a depth in a hit record
constexpr double kOperations = 8;         // from the vertex to the window, of 2.1.1's accuracy each
constexpr double kColorError = 0.5 / 255; // a GL may hold colors in the bits of its window
constexpr double kDistinct = 5;           // pixels between vertices whose order is to be certain

Interval measured(double number, double size) {
  return spec::widened(number, kOperations * spec::kAccuracy * std::max(std::abs(number), size));
}

std::vector<Interval> vertex_numbers(GLenum type, const LitVertex& v, bool back) {
  const double pixels = 96;
  std::vector<Interval> numbers{measured(v.window.x, pixels), measured(v.window.y, pixels)};
  if (type == GL_2D) return numbers;
  numbers.push_back(measured(v.window.z, 1));
  if (type == GL_3D) return numbers;
  if (type == GL_4D_COLOR_TEXTURE) numbers.push_back(measured(v.w, 1));
  for (const Interval& c : (back ? v.back : v.front).primary)
    numbers.push_back(spec::widened(c, kColorError));
  if (type == GL_3D_COLOR) return numbers;
  const Vec4& t = v.texture[0];
  for (double x : {t.x, t.y, t.z, t.w}) numbers.push_back(measured(x, 1));
  return numbers;
}

// How many numbers the items take: polygons of more corners may be cut into triangles.
Interval count_of(const RenderModeState& s) {
  Interval count;
  for (const FedItem& item : s.items) {
    const double numbers = item.token == GL_PASS_THROUGH_TOKEN ? 1 : numbers_of_vertex(s.feedback_type);
    const double vertices = double(item.vertices.size()), polygon = item.token == GL_POLYGON_TOKEN;
    const double whole = 1 + polygon + vertices * numbers,
                 cut = polygon != 0 ? (vertices - 2) * (2 + 3 * numbers) : whole;
    count = {count.low + std::min(whole, cut), count.high + std::max(whole, cut)};
  }
  return count;
}

std::vector<Interval> raw_numbers(const std::vector<FedItem>& items) {
  std::vector<Interval> numbers;
  for (const FedItem& item : items) {
    if (item.token == GL_POLYGON_TOKEN) throw std::logic_error("the first corner of a polygon is open");
    numbers.push_back(double(item.token));
    for (const auto& v : item.vertices) numbers.insert(numbers.end(), v.begin(), v.end());
  }
  return numbers;
}

void write(std::vector<Interval>& memory, const std::vector<Interval>& numbers, int size) {
  const size_t count = std::min({memory.size(), numbers.size(), size_t(std::max(size, 0))});
  std::copy_n(numbers.begin(), count, memory.begin());
}

// Throws if a GL might sort vertices otherwise.
void check_places(std::vector<double> places) {
  std::sort(places.begin(), places.end());
  for (size_t i = 1; i < places.size(); i++)
    if (const double off = places[i] - places[i - 1]; off < 0.05 && off > 1e-6)
      throw std::logic_error("vertices whose order is not certain");
}

bool same(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](Interval x, Interval y) { return std::abs(x.middle() - y.middle()) < 1e-3; });
}

} // namespace

void note_hit(RenderModeState& s, const std::vector<LitVertex>& vertices) {
  for (const LitVertex& v : vertices) {
    const Interval depth = measured(v.window.z, 1);
    const bool first = !s.hit;
    s.least = first ? depth : Interval(std::min(s.least.low, depth.low), std::min(s.least.high, depth.high));
    s.greatest =
        first ? depth : Interval(std::max(s.greatest.low, depth.low), std::max(s.greatest.high, depth.high));
    s.hit = true;
  }
}

void feed_back(RenderModeState& s, GLenum token, const std::vector<LitVertex>& vertices, bool back) {
  FedItem item{token, {}};
  for (const LitVertex& v : vertices) item.vertices.push_back(vertex_numbers(s.feedback_type, v, back));
  s.items.push_back(std::move(item));
}

void receive_polygon(RenderModeState& s, const PolygonState& p, const std::vector<LitVertex>& vertices) {
  double area = 0; // equation 2.6, twice
  for (size_t i = 0; i < vertices.size(); i++) {
    const Vec3 &a = vertices[i].window, &b = vertices[(i + 1) % vertices.size()].window;
    area += a.x * b.y - b.x * a.y;
  }
  if (std::abs(area) < kDistinct) throw std::logic_error("a polygon without an area is selected or fed back");
  const bool back = spec::faces_back(area, p.front_face == GL_CW);
  const GLenum culled = p.cull ? p.cull_face : GL_NONE;
  if (culled == GL_FRONT_AND_BACK || culled == GLenum(back ? GL_BACK : GL_FRONT)) return;
  if (s.mode == GL_SELECT) {
    note_hit(s, vertices);
    return;
  }
  if (p.mode[back] == GL_FILL) {
    feed_back(s, GL_POLYGON_TOKEN, vertices, back);
    return;
  }
  for (size_t i = 0; i < vertices.size(); i++) {
    if (!vertices[i].boundary) continue;
    if (p.mode[back] == GL_POINT)
      feed_back(s, GL_POINT_TOKEN, {vertices[i]}, back);
    else
      feed_back(s, GL_LINE_TOKEN, {vertices[i], vertices[(i + 1) % vertices.size()]}, back);
  }
}

void write_record(RenderModeState& s) {
  if (!s.hit) return;
  s.records.push_back(double(s.names.size()));
  for (const Interval& depth : {s.least, s.greatest})
    s.records.push_back(spec::clamped({depth.low * kMost - 1, depth.high * kMost + 1}, 0, kMost));
  for (GLuint name : s.names) s.records.push_back(name);
  s.hit = false, s.hits++;
}

void change_mode(RenderModeState& s, GLenum mode) {
  s.result = 0, s.given.clear();
  if (s.mode == GL_SELECT) {
    write_record(s), write(s.selection_memory, s.records, s.selection_size);
    s.result = int(s.records.size()) > s.selection_size ? -1 : s.hits;
  } else if (s.mode == GL_FEEDBACK) {
    const Interval count = count_of(s);
    if (count.low <= s.feedback_size && count.high > s.feedback_size)
      throw std::logic_error("a feedback buffer that may be too small");
    s.result = count.low > s.feedback_size ? Interval(-1) : count;
    const bool polygons = std::any_of(s.items.begin(), s.items.end(),
                                      [](const FedItem& i) { return i.token == GL_POLYGON_TOKEN; });
    if (!polygons) write(s.feedback_memory, raw_numbers(s.items), s.feedback_size);
    s.given = s.items;
  }
  s.mode = mode, s.items.clear(), s.records.clear(), s.names.clear(), s.hits = 0, s.hit = false;
}

std::vector<Interval> fed_numbers(const RenderModeState& s, FedOrder order) {
  std::vector<Interval> numbers;
  if (order == FedOrder::Raw) {
    raw_numbers(s.given); // throws for polygons
    numbers = s.feedback_memory;
  } else if (s.result.low >= 0) {
    std::vector<double> corners, lines, points;
    std::vector<std::vector<Interval>> all_corners;
    for (const FedItem& item : s.given) {
      std::vector<double> places;
      const bool polygon = item.token == GL_POLYGON_TOKEN, in_order = order != FedOrder::AnyOrder;
      if (in_order && polygon && item.vertices.size() != 3)
        throw std::logic_error("a polygon that may be cut into triangles");
      if (item.token == GL_PASS_THROUGH_TOKEN || (in_order && !polygon)) {
        if (!in_order) throw std::logic_error("a mark whose place is not painted");
        continue;
      }
      for (const auto& v : item.vertices) places.push_back(place_of(v));
      check_places(places);
      if (polygon) {
        corners.insert(corners.end(), places.begin(), places.end());
        all_corners.insert(all_corners.end(), item.vertices.begin(), item.vertices.end());
      } else if (item.vertices.size() == 2) {
        lines.push_back(places[0] + places[1]);
      } else {
        points.push_back(places[0]);
      }
    }
    if (order == FedOrder::AnyOrder) {
      check_places(corners), check_places(lines), check_places(points);
      for (const auto& a : all_corners)
        for (const auto& b : all_corners)
          if (std::abs(place_of(a) - place_of(b)) < 1e-6 && !same(a, b))
            throw std::logic_error("one corner with different data");
    }
    numbers = painted_numbers(s.given, order);
  }
  numbers.insert(numbers.begin(), s.result);
  return numbers;
}

} // namespace softgl::suite
