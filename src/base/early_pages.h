// Two megabytes of zeroed memory that a thread brings in while the program still prepares its first picture.
#pragma once

#include <cstddef>

#include "base/pages.h"

namespace softgl {

/// Makes the memory, once per process; what shall be brought in (populate_pages), or nothing.
Pages open_early_pages();

/// `bytes` of zeroed memory aligned to 64 bytes, or null: not for so many bytes, or no room.
void* take_early_pages(size_t bytes);
/// False when the memory is none of ours. The last one to give memory back opens all of it again.
bool give_back_early_pages(void* memory);

} // namespace softgl
