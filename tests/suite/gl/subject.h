// The GL under test: which library, and a current context with a window of RGBA colors.
#pragma once

#include <memory>
#include <string>

#include "gl/gl_table.h"

namespace softgl::suite {

constexpr int kWindowWidth = 96, kWindowHeight = 96;

enum class Binding { OSMesa, Egl, Glx };

struct SubjectName {
  Binding binding = Binding::OSMesa;
  std::string library; // path or name for dlopen
  std::string text;    // as the user wrote it
};

/// Reads osmesa:PATH, egl[:PATH], glx[:PATH] or softgl. Throws std::invalid_argument with a message for the
/// user.
SubjectName parse_subject(const std::string& text);

/// A library that is loaded, with a current context. Only made in a process that may die.
class Subject {
public:
  virtual ~Subject() = default;
  /// Makes a new context current, in its initial state, in place of the last. Throws std::runtime_error.
  virtual void renew() = 0;
  GlTable gl; // filled by the first renew
};

/// Throws std::runtime_error with the reason.
std::unique_ptr<Subject> open_subject(const SubjectName& name);

// One for each binding.
std::unique_ptr<Subject> open_osmesa(const std::string& library);
std::unique_ptr<Subject> open_egl(const std::string& library);
std::unique_ptr<Subject> open_glx(const std::string& library);

/// dlopen, with its message as a std::runtime_error.
void* open_library(const std::string& path);
AnyFunction symbol(void* library, const char* name);

} // namespace softgl::suite
