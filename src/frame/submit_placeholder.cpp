// Until geometry draws: nothing is drawn.
#include "frame/draw_call.h"

namespace softgl {
[[gnu::weak]] void submit(Context&, const DrawCall&) {}
} // namespace softgl
