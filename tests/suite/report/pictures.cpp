#include "report/pictures.h"

#include "expect/machine.h"
#include "gl/subject.h"
#include "run/verdict.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

namespace softgl::suite {

std::string png_of(const std::vector<uint8_t>& color, int width, int height) {
  std::vector<uint8_t> rgb;
  for (int y = height - 1; y >= 0; y--)
    for (int x = 0; x < width; x++)
      for (int c = 0; c < 3; c++) rgb.push_back(color[size_t(4 * (y * width + x) + c)]);
  std::string png;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), size_t(size));
  };
  stbi_write_png_to_func(append, &png, width, height, 3, rgb.data(), 3 * width);
  return png;
}

std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t j = 0; j < 3; j++) group = group << 8 | (i + j < bytes.size() ? uint8_t(bytes[i + j]) : 0);
    for (size_t j = 0; j < 4; j++) text += j <= bytes.size() - i ? digits[group >> (18 - 6 * j) & 63] : '=';
  }
  return text;
}

std::vector<uint8_t> contact_sheet(const std::vector<const Test*>& tests, int* width, int* height) {
  const int columns = 10, cell_width = kWindowWidth + 4, cell_height = kWindowHeight + 4;
  const int rows = (int(tests.size()) + columns - 1) / columns;
  *width = columns * cell_width, *height = rows * cell_height;
  std::vector<uint8_t> sheet(size_t(4 * *width * *height), 255);
  for (size_t t = 0; t < tests.size(); t++) {
    const std::vector<uint8_t> picture =
        expected_bytes(expected_picture(whole_script(*tests[t]), kWindowWidth, kWindowHeight, {}));
    const int left = int(t % columns) * cell_width, bottom = (rows - 1 - int(t / columns)) * cell_height;
    for (int y = 0; y < kWindowHeight; y++)
      std::copy_n(&picture[size_t(4 * y * kWindowWidth)], 4 * kWindowWidth,
                  &sheet[size_t(4 * ((bottom + y) * *width + left))]);
  }
  return sheet;
}

} // namespace softgl::suite
