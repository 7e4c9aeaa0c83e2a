// The arguments of a map statement: `map_Kd -s 2 2 1 -o 0.25 0 my picture.png`.
#pragma once

#include <string>
#include <string_view>

#include "obj/file_search.h"
#include "obj/material.h"

namespace softgl::cli {

struct MapStatement {
  TextureReference texture; // file empty: not found
  std::string wanted;       // the name as far as it could be understood, for a message
};

// Options first; what is left is tried as a name, then from each later word on, since names may hold spaces.
MapStatement parse_map_statement(std::string_view arguments, const ModelFiles& files,
                                 const std::string& folder);

} // namespace softgl::cli
