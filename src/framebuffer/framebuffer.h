#pragma once

namespace softgl {

struct Framebuffer {};

} // namespace softgl
