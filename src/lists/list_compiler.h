#pragma once

namespace softgl {

struct ListCompiler {};

} // namespace softgl
