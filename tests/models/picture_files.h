// Pictures as other programs read them: through stb_image.
#pragma once

#include <string>
#include <vector>

#include "models/program_runner.h"

namespace softgl::test {

// RGB; alpha is dropped.
TestPicture decode_picture(const std::string& bytes);
std::vector<uint8_t> decode_alpha(const std::string& bytes); // 255 where the file has none
std::vector<TestPicture> decode_gif(const std::string& bytes);
// Every frame of an animated PNG, each taken for a PNG file of its own.
std::vector<TestPicture> decode_apng(const std::string& bytes);

// Data of a PNG file's chunks of one type, in order.
std::vector<std::string> png_chunks(const std::string& bytes, const std::string& type);

} // namespace softgl::test
