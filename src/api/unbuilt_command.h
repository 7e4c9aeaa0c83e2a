#pragma once

namespace softgl {

/// What a door without a command behind it does: GL_INVALID_OPERATION in the current context, if there is
/// one.
void unbuilt_command();

} // namespace softgl
