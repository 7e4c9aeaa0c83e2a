// What selection and feedback gave (5.2, 5.3) becomes squares of the window; the same in C.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "gl/gl_table.h"
#include "gl/subject.h"
#include "script/fed_values.h"

namespace softgl::suite {
namespace {

template <class T> std::vector<double> numbers_in(const std::vector<std::byte>* memory) {
  std::vector<T> values(memory ? memory->size() / sizeof(T) : 0);
  if (!values.empty()) std::memcpy(values.data(), memory->data(), values.size() * sizeof(T));
  return {values.begin(), values.end()};
}

} // namespace

void Player::paint_feedback(const Call& call) {
  const FedOrder order = FedOrder(int(call.n(0)));
  const int size = int(call.n(1)), columns = kWindowWidth / size;
  std::vector<double> memory = numbers_in<GLfloat>(feedback_);
  std::vector<Interval> numbers;
  if (order == FedOrder::Raw) {
    numbers.assign(memory.begin(), memory.end());
  } else {
    memory.resize(std::min(memory.size(), size_t(std::max(mode_result_, 0))));
    numbers = painted_numbers(fed_items(feedback_type_, memory), order);
  }
  numbers.insert(numbers.begin(), double(mode_result_));
  for (int i = 0; i < painted_squares(size); i++) {
    Interval color[3];
    if (size_t(i) < numbers.size() && std::isfinite(numbers[size_t(i)].middle()))
      paint_number(numbers[size_t(i)].middle(), color);
    paint(i % columns * size, i / columns * size, size, color[0].low, color[1].low, color[2].low);
  }
}

void Player::paint_selection(const Call& call) {
  const int size = int(call.n(0)), columns = kWindowWidth / size;
  std::vector<double> numbers = numbers_in<GLuint>(selection_);
  numbers.insert(numbers.begin(), double(GLuint(mode_result_)));
  for (int i = 0; i < painted_squares(size); i++) {
    Interval color[3];
    if (size_t(i) < numbers.size()) paint_record_number(numbers[size_t(i)], color);
    paint(i % columns * size, i / columns * size, size, color[0].low, color[1].low, color[2].low);
  }
}

std::string special_in_c(const Script& script) {
  const auto calls = [&](Command command) {
    return std::any_of(script.calls.begin(), script.calls.end(),
                       [&](const Call& c) { return c.command == command; });
  };
  const bool feeds = calls(Command::FeedbackBuffer), selects = calls(Command::SelectBuffer),
             paints_feedback = calls(Command::PaintFeedback),
             paints_selection = calls(Command::PaintSelection);
  std::string text;
  if (calls(Command::RenderMode) || paints_feedback || paints_selection)
    text += "static GLint result; /* of glRenderMode */\n\n";
  if (paints_feedback || paints_selection)
    text += R"(static double wave(double x) {
  x -= 2 * (double)(long long)(x / 2);
  if (x < 0) x += 2;
  return x < 1 ? x : 2 - x;
}

static void paintSquare(int i, int size, double red, double green, double blue) {
  paint(i % (SIZE / size) * size, i / (SIZE / size) * size, size, red, green, blue);
}

)";
  if (feeds || paints_feedback)
    text += R"(static GLfloat fed[4096];
)";
  if (feeds)
    text += R"(static int fedSize;
static GLenum fedType;
static GLfloat* feedbackMemory(int count, GLenum type) {
  for (int i = 0; i < count; i++) fed[i] = -9;
  fedSize = count;
  fedType = type;
  return fed;
}

)";
  if (feeds && paints_feedback)
    text += R"(static double numbers[8192]; /* that are painted */
static int numberCount;
static void add(const GLfloat* values, int count) {
  for (int i = 0; i < count && numberCount < 8192; i++) numbers[numberCount++] = values[i];
}
static double place(const GLfloat* v) { return v[0] + 0.618 * v[1]; }

/* Sorts groups of numbers by the places of the vertices in them. */
static void sortGroups(GLfloat* v, int groups, int vertices, int width) {
  for (int i = 1; i < groups; i++)
    for (int j = i; j > 0; j--) {
      GLfloat *a = v + (j - 1) * vertices * width, *b = a + vertices * width;
      double before = place(a), behind = place(b);
      if (vertices == 2) before += place(a + width), behind += place(b + width);
      if (before <= behind) break;
      for (int k = 0; k < vertices * width; k++) {
        const GLfloat moved = a[k];
        a[k] = b[k];
        b[k] = moved;
      }
    }
}

/* Order 0: in order, lines alike. 1: corners of polygons, lines and points, each sorted. 2: the whole
 * buffer. 3: in order, with GL_LINE_RESET_TOKEN. */
static void paintFeedback(int order, int size) {
  const int width = fedType == GL_2D ? 2 : fedType == GL_3D ? 3 : fedType == GL_3D_COLOR ? 7 : fedType == GL_3D_COLOR_TEXTURE ? 11 : 12;
  static GLfloat groups[3][8192];
  int counts[3] = {0, 0, 0};
  double area = 0;
  const GLfloat returned = (GLfloat)result;
  numberCount = 0;
  add(&returned, 1);
  if (order == 2) add(fed, fedSize);
  for (int at = 0; order != 2 && at < result && at < fedSize;) {
    const int token = (int)fed[at], polygon = token == GL_POLYGON_TOKEN;
    const int line = token == GL_LINE_TOKEN || token == GL_LINE_RESET_TOKEN;
    const int n = polygon ? (int)fed[at + 1] : line ? 2 : 1, head = polygon ? 2 : 1;
    const int length = head + (token == GL_PASS_THROUGH_TOKEN ? 1 : n * width);
    GLfloat* v = fed + at + head;
    if (token < GL_PASS_THROUGH_TOKEN || token > GL_LINE_RESET_TOKEN || n < 1 || at + length > result) break;
    if (polygon) {
      double twice = 0;
      for (int i = 0; i < n; i++) {
        const GLfloat *a = v + i * width, *b = v + (i + 1) % n * width;
        twice += (double)a[0] * b[1] - (double)b[0] * a[1];
      }
      area += twice < 0 ? -twice / 2 : twice / 2;
    }
    if (polygon || (line && order == 1)) sortGroups(v, n, 1, width);
    if (order == 0 && line) fed[at] = GL_LINE_TOKEN;
    if (order != 1) {
      add(fed + at, length);
    } else {
      const int group = polygon ? 0 : line ? 1 : 2;
      memcpy(groups[group] + counts[group] * width, v, sizeof(GLfloat) * (size_t)(n * width));
      counts[group] += n;
    }
    at += length;
  }
  for (int group = 0; group < 3 && order == 1; group++) {
    GLfloat* v = groups[group];
    const int vertices = group == 1 ? 2 : 1;
    int kept = 0;
    sortGroups(v, counts[group] / vertices, vertices, width);
    for (int i = 0; i < counts[group]; i++) {
      if (group == 0 && kept > 0 && place(v + i * width) - place(v + (kept - 1) * width) < 0.01) continue;
      memmove(v + kept++ * width, v + i * width, sizeof(GLfloat) * (size_t)width);
    }
    const GLfloat count = (GLfloat)(kept / vertices), size8 = (GLfloat)(area / 8);
    add(&count, 1);
    if (group == 0 && kept > 0) add(&size8, 1);
    add(v, kept * width);
  }
  for (int i = 0; i < SIZE / size * (SIZE / size); i++) {
    const double n = numbers[i];
    if (i < numberCount && n == n && n < 1e9 && n > -1e9)
      paintSquare(i, size, wave(n / 2048 + 0.5), wave(n / 32 + 0.5), wave(n + 0.5));
    else
      paintSquare(i, size, 0, 0, 0);
  }
}

)";
  else if (paints_feedback)
    text += R"(static void paintFeedback(int order, int size) {
  const double n = result;
  for (int i = 0; i < SIZE / size * (SIZE / size); i++) paintSquare(i, size, 0, 0, 0 * (order + fed[0]));
  paintSquare(0, size, wave(n / 2048 + 0.5), wave(n / 32 + 0.5), wave(n + 0.5));
}

)";
  if (selects || paints_selection)
    text += R"(static GLuint selected[1024];
static int selectedSize;

)";
  if (selects)
    text += R"(static GLuint* selectionMemory(int count) {
  for (int i = 0; i < count; i++) selected[i] = 0x5a5a5a5a;
  selectedSize = count;
  return selected;
}

)";
  if (paints_selection)
    text += R"(static void paintSelection(int size) {
  for (int i = 0; i < SIZE / size * (SIZE / size); i++) {
    const double n = i == 0 ? (double)(GLuint)result : selected[i - 1];
    if (i <= selectedSize)
      paintSquare(i, size, n / 4294967295.0, wave(n / (1 << 26)), n < 65536 ? wave(n / 64) : 0);
    else
      paintSquare(i, size, 0, 0, 0);
  }
}

)";
  return text;
}

} // namespace softgl::suite
