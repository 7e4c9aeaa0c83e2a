// The process environment that makes OSMesa's pictures the same on every machine.
#pragma once

namespace softgl::test {

/// Call before any library is loaded. OSMesa (llvmpipe) fuses multiplications and additions on processors
/// with FMA; held to SSE4.1 it computes the same bytes on all of them. Its threads and its shader cache
/// change no byte, only the time.
void fix_environment();

/// How many seeds a case draws: `usual`, or at most as many as SOFTGL_TEST_SEEDS says, for slow builds.
int seed_count(int usual);

} // namespace softgl::test
