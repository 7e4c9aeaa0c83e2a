// The extensions that GL_EXTENSIONS names.
#pragma once

namespace softgl {

/// Their names one by one, and GL_NUM_EXTENSIONS.
int extension_count();

} // namespace softgl
