#pragma once

namespace softgl {

struct AttributeStack {};

} // namespace softgl
