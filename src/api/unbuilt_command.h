#pragma once

namespace softgl {

/// What a door without a command behind it does: GL_INVALID_OPERATION in the current context, if there is
/// one.
void unbuilt_command();
/// The same for a function that is only there by its name.
void unsupported_command(const char* name);

} // namespace softgl
