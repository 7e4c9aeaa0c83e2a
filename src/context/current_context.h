#pragma once

#include "context/context.h"

namespace softgl {

/// What current_context points at in a thread without a context.
Context* none_context();

} // namespace softgl
