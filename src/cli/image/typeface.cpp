#include "image/typeface.h"

#ifdef SOFTGL_TYPEFACE // the path of the font's file

// The assembler copies the file: as a C array it would take seconds to compile.
asm(".pushsection .rodata\n"
    ".balign 16\n"
    ".hidden softgl_typeface\n"
    ".global softgl_typeface\n"
    "softgl_typeface: .incbin \"" SOFTGL_TYPEFACE "\"\n"
    ".hidden softgl_typeface_end\n"
    ".global softgl_typeface_end\n"
    "softgl_typeface_end: .byte 0\n"
    ".popsection\n");

extern "C" {
extern const unsigned char softgl_typeface[], softgl_typeface_end[];
}

namespace softgl::cli {

std::span<const unsigned char> typeface() { return {softgl_typeface, softgl_typeface_end}; }

} // namespace softgl::cli

#else

namespace softgl::cli {

std::span<const unsigned char> typeface() { return {}; }

} // namespace softgl::cli

#endif
