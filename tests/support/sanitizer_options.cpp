// What the sanitizers of the presets asan and tsan need to know; without one of them nobody calls these
// functions. Only the system's OSMesa and its LLVM are spared, by their full paths: softgl's own library has
// the same name.
#define SOFTGL_SANITIZER_HOOK extern "C" __attribute__((visibility("default"))) const char*

// A size that nobody has is answered with GL_OUT_OF_MEMORY, which tests ask for.
SOFTGL_SANITIZER_HOOK __asan_default_options() { return "allocator_may_return_null=1"; }
SOFTGL_SANITIZER_HOOK __ubsan_default_options() { return "print_stacktrace=1"; }
// OSMesa does not free what belongs to the process when its last context goes, nor does LLVM.
SOFTGL_SANITIZER_HOOK __lsan_default_suppressions() {
  return "leak:/usr/lib/x86_64-linux-gnu/libOSMesa\n"
         "leak:libLLVM\n";
}
// A test forks, and its child starts threads.
SOFTGL_SANITIZER_HOOK __tsan_default_options() { return "second_deadlock_stack=1:die_after_fork=0"; }
// OSMesa and LLVM are not compiled for ThreadSanitizer, which sees their locks and not what the locks
// protect.
SOFTGL_SANITIZER_HOOK __tsan_default_suppressions() {
  return "called_from_lib:/usr/lib/x86_64-linux-gnu/libOSMesa\n"
         "called_from_lib:libLLVM\n"
         "mutex:_Unwind_Find_FDE\n"; // locked by libgcc, which saw LLVM register its code
}
