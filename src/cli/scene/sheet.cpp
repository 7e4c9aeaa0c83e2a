#include "scene/sheet.h"

#include "scene/gl_functions.h"
#include "common/program_error.h"

#include <algorithm>
#include <memory>

#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#include <stb/stb_easy_font.h>
#ifdef __GNUC__
#pragma GCC diagnostic pop
#endif

namespace softgl::cli {
namespace {

constexpr int kGap = 12;       // around the pictures
constexpr int kLine = 12;      // of the font, with the space below
constexpr int kReadable = 200; // pixels of a picture's width that a label of 30 letters takes

struct DestroyContext {
  void operator()(osmesa_context* context) const { OSMesaDestroyContext(context); }
};

// Text as quadrilaterals of the current context, drawn with a unit of one pixel and y downwards.
class TextDrawer {
public:
  void draw(int x, int y, int scale, std::string text) {
    vertices.resize(
        std::max<size_t>(vertices.size(), 4 * 70 * (text.size() + 1))); // at most 70 quadrilaterals a letter
    const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, vertices.data(),
                                          static_cast<int>(vertices.size() * sizeof(Vertex)));
    glLoadIdentity();
    glTranslatef(static_cast<float>(x), static_cast<float>(y), 0);
    glScalef(static_cast<float>(scale), static_cast<float>(scale), 1);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), vertices.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glDrawArrays(GL_QUADS, 0, 4 * quads);
  }

private:
  struct Vertex { // stb_easy_font's
    float position[3];
    uint8_t colour[4];
  };
  std::vector<Vertex> vertices;
};

// The font has the letters of ASCII; others, letter by letter of UTF-8, become question marks.
std::string printable(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool ascii = (c >= ' ' && c <= '~') || c == '\n',
               continued = (static_cast<unsigned char>(c) & 0xc0) == 0x80;
    if (!continued) out += ascii ? c : '?';
  }
  return out;
}

class SheetComposer {
public:
  SheetComposer(const std::string& title, const std::vector<SheetRow>& rows)
      : title(printable(title)), rows(rows) {}

  Picture compose() {
    measure();
    GrowingArray<uint8_t> pixels;
    pixels.extend(size_t(4) * static_cast<size_t>(width) * static_cast<size_t>(height));
    draw_text(pixels);
    for (size_t row = 0; row < rows.size(); ++row)
      for (size_t column = 0; column < rows[row].entries.size(); ++column)
        place(rows[row].entries[column].picture, left(column), top(row) + row_title, pixels);
    Picture sheet;
    sheet.width = width;
    sheet.height = height;
    sheet.channels = 3;
    const size_t count = static_cast<size_t>(width) * static_cast<size_t>(height);
    for (size_t i = 0; i < count; ++i)
      for (size_t channel = 0; channel < 3; ++channel) pixels[3 * i + channel] = pixels[4 * i + channel];
    pixels.truncate(3 * count);
    sheet.pixels = std::move(pixels);
    return sheet;
  }

private:
  void measure() {
    size_t columns = 0;
    for (const SheetRow& row : rows) columns = std::max(columns, row.entries.size());
    part_width = rows.front().entries.front().picture.width;
    part_height = rows.front().entries.front().picture.height;
    letter = std::clamp(part_width / kReadable, 1, 8);
    label = letter * 2 * kLine + kGap; // two lines
    row_title = 2 * letter * kLine + kGap;
    sheet_title = 3 * letter * kLine + kGap;
    column_width = part_width;
    for (const SheetRow& row : rows)
      for (const SheetEntry& entry : row.entries) {
        std::string text = entry.label;
        column_width = std::max(column_width, letter * stb_easy_font_width(text.data()));
      }
    width = kGap + static_cast<int>(columns) * (column_width + kGap);
    // A long title has smaller letters; one that is too long even so, loses its end.
    const int room = width - 2 * kGap;
    for (size_t length = title.size(); stb_easy_font_width(title.data()) > room && length > 0; --length)
      title = title.substr(0, length - 1) + "...";
    title_letter = std::clamp(room / std::max(1, stb_easy_font_width(title.data())), 1, 3 * letter);
    height = sheet_title + static_cast<int>(rows.size()) * (row_title + part_height + label);
  }

  int left(size_t column) const { return kGap + static_cast<int>(column) * (column_width + kGap); }
  int top(size_t row) const {
    return sheet_title + static_cast<int>(row) * (row_title + part_height + label);
  }

  void draw_text(GrowingArray<uint8_t>& pixels) const {
    const std::unique_ptr<osmesa_context, DestroyContext> context(
        OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, nullptr));
    if (!context || !OSMesaMakeCurrent(context.get(), pixels.data(), GL_UNSIGNED_BYTE, width, height))
      throw ProgramError(kCannotRead, "cannot create a GL context");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, width, height, 0, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    TextDrawer text;
    glColor3f(0.1f, 0.1f, 0.1f);
    text.draw(kGap, kGap, title_letter, title);
    for (size_t row = 0; row < rows.size(); ++row) {
      glColor3f(0.1f, 0.1f, 0.1f);
      text.draw(kGap, top(row) + kGap / 2, 2 * letter, rows[row].title);
      glColor3f(0.3f, 0.3f, 0.3f);
      for (size_t column = 0; column < rows[row].entries.size(); ++column)
        text.draw(left(column), top(row) + row_title + part_height + kGap / 3, letter,
                  rows[row].entries[column].label);
    }
    glFinish();
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  }

  void place(const Picture& picture, int x, int y, GrowingArray<uint8_t>& pixels) const {
    const uint8_t* from = picture.pixels.data();
    for (int row = 0; row < picture.height; ++row) {
      uint8_t* to =
          &pixels[4 * (static_cast<size_t>(y + row) * static_cast<size_t>(width) + static_cast<size_t>(x))];
      for (int column = 0; column < picture.width; ++column, from += 3, to += 4)
        std::copy(from, from + 3, to);
    }
  }

  std::string title;
  const std::vector<SheetRow>& rows;
  int part_width = 0, part_height = 0, column_width = 0, width = 0, height = 0;
  int letter = 1, title_letter = 1; // size of the labels' letters; titles are twice and three times as large
  int label = 0, row_title = 0, sheet_title = 0; // heights
};

} // namespace

Picture compose_sheet(const std::string& title, const std::vector<SheetRow>& rows) {
  return SheetComposer(title, rows).compose();
}

} // namespace softgl::cli
