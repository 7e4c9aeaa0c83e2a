#include "fragment/fragment_stages.h"

namespace softgl {

void append_fragment_stages(FragmentProgram&) {}

} // namespace softgl
