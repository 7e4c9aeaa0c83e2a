// Printing and simplifying fragment keys.
#pragma once

#include <string>

#include "shaders/fragment/fragment_key.h"

namespace softgl {

/// The same picture by a key with as few bits as possible: a depth test that always passes and writes nothing
/// is no depth test, ONE/ZERO with ADD is no blending, and so on.
FragmentKey simplify(FragmentKey key);

/// For bug reports and tests, e.g. "depth:less,write blend:add(src_alpha,one_minus_src_alpha) mask:rgba
/// rgba8".
std::string to_string(const FragmentKey& key);

} // namespace softgl
