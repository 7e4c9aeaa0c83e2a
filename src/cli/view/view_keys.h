// What each key of the window does.
#pragma once

#include <string>
#include <vector>

#include "view/view_state.h"

namespace softgl::cli {

// A key that means nothing changes nothing.
void press_key(ViewState& state, const std::string& key);

// Keys and mouse for people, a line each, with a tab: "w\twireframe".
std::vector<std::string> key_lines();

} // namespace softgl::cli
