// Files of text that may be compressed with gzip or zstd.
#pragma once

#include "common/source_text.h"

namespace softgl::cli {

// As SourceText::open(), and the text inside where the file is compressed, as UTF-8. That has a limit of its
// own: `most`, or without one 64 times the file's size and at least 16 MiB. Throws ProgramError for damaged
// files, and where the program was built without the library.
SourceText open_text(const std::string& path, uint64_t most = 0);

// The same for a file that is open already.
SourceText decompressed(SourceText file, uint64_t most = 0);

} // namespace softgl::cli
