// Text of two bytes a letter, as some programs of Windows save it.
#pragma once

#include "common/source_text.h"

namespace softgl::cli {

// The same text in UTF-8, if the file begins with the mark of UTF-16, else the file. What is no letter
// becomes U+FFFD.
SourceText as_utf8(SourceText file);

} // namespace softgl::cli
