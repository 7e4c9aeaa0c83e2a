// Pictures as PNG files, for the report.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "run/test.h"

namespace softgl::suite {

/// A PNG of RGB; `color` is RGBA with rows from below.
std::string png_of(const std::vector<uint8_t>& color, int width, int height);
std::string base64(const std::string& bytes);
/// The expected pictures of the tests beside each other, ten a row; RGBA with rows from below.
std::vector<uint8_t> contact_sheet(const std::vector<const Test*>& tests, int* width, int* height);

} // namespace softgl::suite
