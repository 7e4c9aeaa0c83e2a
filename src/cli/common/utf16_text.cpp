#include "common/utf16_text.h"

namespace softgl::cli {
namespace {

constexpr uint32_t kNoLetter = 0xfffd;

void append(uint32_t letter, std::string& text) {
  if (letter < 0x80) {
    text += char(letter);
  } else if (letter < 0x800) {
    text += char(0xc0 | letter >> 6);
    text += char(0x80 | (letter & 63));
  } else {
    if (letter < 0x10000) {
      text += char(0xe0 | letter >> 12);
    } else {
      text += char(0xf0 | letter >> 18);
      text += char(0x80 | (letter >> 12 & 63));
    }
    text += char(0x80 | (letter >> 6 & 63));
    text += char(0x80 | (letter & 63));
  }
}

} // namespace

SourceText as_utf8(SourceText file) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(file.begin());
  if (file.size() < 2) return file;
  const bool little = bytes[0] == 0xff && bytes[1] == 0xfe, big = bytes[0] == 0xfe && bytes[1] == 0xff;
  if (!little && !big) return file;
  const auto unit = [&](size_t at) -> uint32_t {
    return uint32_t(bytes[at + (little ? 1 : 0)]) << 8 | bytes[at + (little ? 0 : 1)];
  };
  std::string text;
  text.reserve(file.size() / 2);
  for (size_t at = 2; at + 1 < file.size(); at += 2) {
    uint32_t letter = unit(at);
    if (letter >= 0xd800 && letter < 0xdc00 && at + 3 < file.size() && (unit(at + 2) & 0xfc00) == 0xdc00) {
      letter = 0x10000 + ((letter & 0x3ff) << 10 | (unit(at + 2) & 0x3ff));
      at += 2;
    } else if ((letter & 0xf800) == 0xd800) {
      letter = kNoLetter;
    }
    append(letter, text);
  }
  return SourceText::from_string(std::move(text), file.name());
}

} // namespace softgl::cli
