#include "texture/texture_stages.h"

namespace softgl {

void append_texture_stages(const Context&, Arena&, FragmentProgram&, FragmentConstants&) {}

} // namespace softgl
