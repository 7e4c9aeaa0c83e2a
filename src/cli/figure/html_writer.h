// The lecture as one HTML file that refers to nothing outside of itself.
#pragma once

#include "figure/language.h"
#include "figure/page.h"
#include "image/image_writer.h"

namespace softgl::cli {

std::string html_document(std::vector<Page> pages, Language language, PngEffort effort);

} // namespace softgl::cli
