// The public headers: all the program knows of GL, beside the tokens of softgl/softgl.h.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <string>

namespace softgl::cli {

// Whether the current context names the extension.
inline bool has_extension(const char* name) {
  const auto* all = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
  return all && (std::string(" ") + all + " ").find(std::string(" ") + name + " ") != std::string::npos;
}

} // namespace softgl::cli
