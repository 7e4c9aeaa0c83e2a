#include "context/current_context.h"

#include <new>

namespace softgl {
namespace {

/// The context of threads without one: its guard turns every door away. A union, so that the pointer to it is
/// a constant and needs no initialization per thread; never destroyed, because a thread may call a door while
/// the process ends.
union NoContext {
  constexpr NoContext() : nothing(0) {}
  ~NoContext() {}
  char nothing;
  Context context;
};
constinit NoContext no_context;

const bool no_context_constructed = [] {
  new (&no_context.context) Context;
  no_context.context.guard = kNoContext;
  return true;
}();

} // namespace

constinit thread_local Context* current_context = &no_context.context;

Context* none_context() { return &no_context.context; }

} // namespace softgl
