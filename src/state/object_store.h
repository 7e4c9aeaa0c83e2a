#pragma once

namespace softgl {

struct SharedObjects {};

} // namespace softgl
