#include "scene/sheet.h"

#include <algorithm>

#include "scene/gl_context.h"

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

constexpr int kGap = 12;  // around the pictures
constexpr int kLine = 12; // of the font, with the space below
constexpr int kWidestLabel = 450;
constexpr int kReadable = 200; // pixels of a picture's width that a label of 30 letters takes

// Text as quadrilaterals of the current context, drawn with a unit of one pixel and y downwards.
class TextDrawer {
public:
  void draw(int x, int y, int scale, std::string text) {
    vertices_.resize(
        std::max<size_t>(vertices_.size(), 4 * 70 * (text.size() + 1))); // at most 70 quadrilaterals a letter
    const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, vertices_.data(),
                                          int(vertices_.size() * sizeof(Vertex)));
    glLoadIdentity();
    glTranslatef(float(x), float(y), 0);
    glScalef(float(scale), float(scale), 1);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), vertices_.data());
    glEnableClientState(GL_VERTEX_ARRAY);
    glDrawArrays(GL_QUADS, 0, 4 * quads);
  }

private:
  struct Vertex { // stb_easy_font's
    float position[3];
    uint8_t color[4];
  };
  std::vector<Vertex> vertices_;
};

// The font has the letters of ASCII; others, letter by letter of UTF-8, become question marks.
std::string ascii_only(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool ascii = (c >= ' ' && c <= '~') || c == '\n', continued = (uint8_t(c) & 0xc0) == 0x80;
    if (!continued) out += ascii ? c : '?';
  }
  return out;
}

int width_of(std::string text) { return stb_easy_font_width(text.data()); }

// The line without as much of its middle as makes it too long.
std::string shortened(const std::string& line, int most) {
  if (width_of(line) <= most) return line;
  size_t kept = line.size();
  std::string text;
  do {
    --kept;
    text = line.substr(0, kept / 2) + "..." + line.substr(line.size() - (kept - kept / 2));
  } while (width_of(text) > most && kept > 1);
  return text;
}

class SheetComposer {
public:
  SheetComposer(const std::string& title, const std::vector<SheetRow>& rows)
      : title_(ascii_only(title)), rows_(rows) {}

  Picture compose() {
    measure();
    GrowingArray<uint8_t> pixels;
    pixels.extend(size_t(4) * size_t(width_) * size_t(height_));
    draw_text(pixels);
    for (size_t row = 0; row < rows_.size(); ++row)
      for (size_t column = 0; column < rows_[row].entries.size(); ++column)
        place(rows_[row].entries[column].picture, left(column), top(row) + row_title_, pixels);
    Picture sheet;
    sheet.width = width_;
    sheet.height = height_;
    sheet.channels = 3;
    const size_t count = size_t(width_) * size_t(height_);
    for (size_t i = 0; i < count; ++i)
      for (size_t channel = 0; channel < 3; ++channel) pixels[3 * i + channel] = pixels[4 * i + channel];
    pixels.truncate(3 * count);
    sheet.pixels = std::move(pixels);
    return sheet;
  }

private:
  void measure() {
    size_t columns = 0;
    for (const SheetRow& row : rows_) columns = std::max(columns, row.entries.size());
    part_width_ = rows_.front().entries.front().picture.width;
    part_height_ = rows_.front().entries.front().picture.height;
    letter_ = std::clamp(part_width_ / kReadable, 1, 8);
    label_ = letter_ * 2 * kLine + kGap; // two lines
    const bool titled =
        std::any_of(rows_.begin(), rows_.end(), [](const SheetRow& row) { return !row.title.empty(); });
    row_title_ = titled ? 2 * letter_ * kLine + kGap : 0;
    sheet_title_ = title_.empty() ? kGap : 3 * letter_ * kLine + kGap;
    column_width_ = part_width_;
    for (const SheetRow& row : rows_)
      for (const SheetEntry& entry : row.entries)
        column_width_ = std::max(column_width_, letter_ * width_of(entry.label));
    column_width_ = std::min(column_width_, std::max(part_width_, kWidestLabel));
    width_ = kGap + int(columns) * (column_width_ + kGap);
    // A long title has smaller letters; one that is too long even so, loses its end.
    const int room = width_ - 2 * kGap;
    for (size_t length = title_.size(); width_of(title_) > room && length > 0; --length)
      title_ = title_.substr(0, length - 1) + "...";
    title_letter_ = std::clamp(room / std::max(1, width_of(title_)), 1, 3 * letter_);
    height_ = sheet_title_ + int(rows_.size()) * (row_title_ + part_height_ + label_);
  }

  int left(size_t column) const { return kGap + int(column) * (column_width_ + kGap); }
  int top(size_t row) const { return sheet_title_ + int(row) * (row_title_ + part_height_ + label_); }

  // Each of the label's lines, none longer than its column.
  std::string fitted(const std::string& label) const {
    std::string text, line;
    for (const char c : ascii_only(label) + "\n") {
      line += c;
      if (c != '\n') continue;
      line.pop_back();
      text += (text.empty() ? "" : "\n") + shortened(line, column_width_ / letter_);
      line.clear();
    }
    return text;
  }

  void draw_text(GrowingArray<uint8_t>& pixels) const {
    const GlContext context(pixels.data(), width_, height_, 0);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, width_, height_, 0, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    TextDrawer text;
    glColor3f(0.1f, 0.1f, 0.1f);
    text.draw(kGap, kGap, title_letter_, title_);
    for (size_t row = 0; row < rows_.size(); ++row) {
      glColor3f(0.1f, 0.1f, 0.1f);
      text.draw(kGap, top(row) + kGap / 2, 2 * letter_, rows_[row].title);
      glColor3f(0.3f, 0.3f, 0.3f);
      for (size_t column = 0; column < rows_[row].entries.size(); ++column)
        text.draw(left(column), top(row) + row_title_ + part_height_ + kGap / 3, letter_,
                  fitted(rows_[row].entries[column].label));
    }
    GlContext::finish();
  }

  void place(const Picture& picture, int x, int y, GrowingArray<uint8_t>& pixels) const {
    const uint8_t* from = picture.pixels.data();
    for (int row = 0; row < picture.height; ++row) {
      uint8_t* to = &pixels[4 * (size_t(y + row) * size_t(width_) + size_t(x))];
      for (int column = 0; column < picture.width; ++column, from += 3, to += 4)
        std::copy(from, from + 3, to);
    }
  }

  std::string title_;
  const std::vector<SheetRow>& rows_;
  int part_width_ = 0, part_height_ = 0, column_width_ = 0, width_ = 0, height_ = 0;
  int letter_ = 1,
      title_letter_ = 1; // size of the labels' letters; titles are twice and three times as large
  int label_ = 0, row_title_ = 0, sheet_title_ = 0; // heights
};

} // namespace

Picture compose_sheet(const std::string& title, const std::vector<SheetRow>& rows) {
  return SheetComposer(title, rows).compose();
}

} // namespace softgl::cli
