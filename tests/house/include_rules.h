// The rules of src/NOTES.md: which folder may include which.
#pragma once

#include <string>
#include <vector>

#include "house/source_tree.h"

namespace softgl::test {

/// The folders of the back and of the border, which never see a Context.
extern const std::vector<std::string> kBack;

/// What breaks the rules, one sentence a fault.
std::vector<std::string> include_faults(const SourceTree& tree);

} // namespace softgl::test
