// Which files a run needs, for --sandbox.
#pragma once

#include "common/sandbox.h"
#include "options/program_options.h"

namespace softgl::cli {

// Models, what lies in their folders, and what options name; the folders of the pictures. Throws ProgramError
// as plan_pictures() does.
SandboxPaths sandbox_paths(const ProgramOptions& options);

} // namespace softgl::cli
