// A program of libFuzzer for one target of fuzz/targets.h, which SOFTGL_FUZZ_TARGET names.
#include <cstdlib>

#include "fuzz/linked_gl.h"
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
  static const bool no_threads = setenv("SOFTGL_THREADS", "0", 0) == 0; // a fault is then where it was made
  (void)no_threads;
  softgl::test::SOFTGL_FUZZ_TARGET(softgl::test::linked_gl(), {bytes, size});
  return 0;
}
