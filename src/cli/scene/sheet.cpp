#include "scene/sheet.h"

#include <algorithm>
#include <cmath>

#include "common/program_error.h"
#include "image/lettering.h"

namespace softgl::cli {
namespace {

constexpr int kGap = 12;  // around the pictures
constexpr int kLine = 12; // of letters of size 11, with the space below
constexpr double kLetter = 11, kAscent = 9;
constexpr int kWidestLabel = 450;
constexpr int kReadable = 200;      // pixels of a picture's width that a label of 30 letters takes
constexpr int kLargestSide = 65535; // of formats of pictures
constexpr Color kTitleColor = {26, 26, 26}, kLabelColor = {77, 77, 77};

// The widest of the text's lines in letters of size 11.
int width_of(const std::string& text) {
  double widest = 0;
  for (size_t at = 0, end; at <= text.size(); at = end + 1) {
    end = std::min(text.find('\n', at), text.size());
    widest = std::max(widest, text_width(text.substr(at, end - at), kLetter));
  }
  return int(std::ceil(widest));
}

class SheetComposer {
public:
  SheetComposer(const std::string& title, const std::vector<SheetRow>& rows) : title_(title), rows_(rows) {}

  Picture compose() {
    measure();
    if (width_ > kLargestSide || height_ > kLargestSide)
      throw ProgramError(kCannotRead, "a sheet of " + std::to_string(width_) + "x" + std::to_string(height_) +
                                          " pixels is too large");
    Picture sheet;
    sheet.width = width_;
    sheet.height = height_;
    sheet.channels = 3;
    sheet.pixels.fill(size_t(3) * size_t(width_) * size_t(height_), 255);
    draw_texts(sheet);
    for (size_t row = 0; row < rows_.size(); ++row)
      for (size_t column = 0; column < rows_[row].entries.size(); ++column)
        place(rows_[row].entries[column].picture, left(column), top(row) + row_title_, sheet);
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
    // A long title has smaller letters; one that is too long even so, loses its middle.
    const int room = width_ - 2 * kGap;
    title_ = shortened(title_, kLetter, room);
    title_letter_ = std::clamp(room / std::max(1, width_of(title_)), 1, 3 * letter_);
    height_ = sheet_title_ + int(rows_.size()) * (row_title_ + part_height_ + label_);
  }

  int left(size_t column) const { return kGap + int(column) * (column_width_ + kGap); }
  int top(size_t row) const { return sheet_title_ + int(row) * (row_title_ + part_height_ + label_); }

  // `x` and `y`: the left top corner of the first line.
  static void draw_line(Picture& sheet, int x, int y, int letter, const std::string& line,
                        const Color& color) {
    draw_text(sheet, x, y + letter * kAscent, letter * kLetter, line, color);
  }

  void draw_texts(Picture& sheet) const {
    draw_line(sheet, kGap, kGap, title_letter_, title_, kTitleColor);
    for (size_t row = 0; row < rows_.size(); ++row) {
      draw_line(sheet, kGap, top(row) + kGap / 2, 2 * letter_, rows_[row].title, kTitleColor);
      for (size_t column = 0; column < rows_[row].entries.size(); ++column) {
        const std::string& label = rows_[row].entries[column].label;
        int y = top(row) + row_title_ + part_height_ + kGap / 3;
        for (size_t at = 0, end; at <= label.size(); at = end + 1, y += letter_ * kLine) {
          end = std::min(label.find('\n', at), label.size());
          draw_line(sheet, left(column), y, letter_,
                    shortened(label.substr(at, end - at), letter_ * kLetter, column_width_), kLabelColor);
        }
      }
    }
  }

  static void place(const Picture& picture, int x, int y, Picture& sheet) {
    const size_t bytes = 3 * size_t(picture.width);
    for (int row = 0; row < picture.height; ++row)
      std::copy_n(&picture.pixels[size_t(row) * bytes], bytes,
                  &sheet.pixels[3 * (size_t(y + row) * size_t(sheet.width) + size_t(x))]);
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
