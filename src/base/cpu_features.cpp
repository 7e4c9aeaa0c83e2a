#include "base/cpu_features.h"

#include <cstdlib>
#include <cstring>
// Clang does not know the type _Bool in C++, which this header of glibc uses.
#if __has_include(<sys/platform/x86.h>) && !defined(__clang__)
#define SOFTGL_ASK_GLIBC
#include <sys/platform/x86.h>
#else
#include <cpuid.h>
#endif

#include "base/kernel_table.h"

namespace softgl {

const char* isa_name(Isa isa) {
  static const char* const names[kIsaCount] = {"baseline", "v2", "v3", "v4"};
  return names[static_cast<int>(isa)];
}

namespace {

struct Features {
  bool v2, v3, v4; // what each level adds to the one below
};

#ifdef SOFTGL_ASK_GLIBC
/// The C library (glibc 2.33) has asked already. In a virtual machine CPUID takes 12 us, and a dozen of them
/// a fiftieth of the way from loading the library to a first picture.
Features features() {
  auto all = [](auto... feature) { return (x86_cpu_active(feature) && ...); };
  return {
      all(x86_cpu_SSE4_2, x86_cpu_POPCNT),
      all(x86_cpu_AVX2, x86_cpu_BMI1, x86_cpu_BMI2, x86_cpu_FMA, x86_cpu_MOVBE, x86_cpu_F16C, x86_cpu_LZCNT),
      all(x86_cpu_AVX512F, x86_cpu_AVX512BW, x86_cpu_AVX512CD, x86_cpu_AVX512DQ, x86_cpu_AVX512VL)};
}
#else
Features features() {
  // The compiler's feature test for AVX and AVX-512 asks XGETBV as well, so it covers the operating system.
  __builtin_cpu_init();
  unsigned a = 0, b = 0, c = 0, d = 0, extended = 0;
  __get_cpuid(1, &a, &b, &c, &d);
  const bool movbe = c & bit_MOVBE, f16c = c & bit_F16C;
  if (__get_cpuid(0x80000001u, &a, &b, &c, &d)) extended = c;
  const bool lzcnt = extended & bit_LZCNT;
  return {__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt"),
          __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2") &&
              __builtin_cpu_supports("fma") && movbe && f16c && lzcnt,
          __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
              __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
              __builtin_cpu_supports("avx512vl")};
}
#endif

} // namespace

Isa detect_isa() {
  const Features f = features();
  return !f.v2 ? Isa::Baseline : !f.v3 ? Isa::V2 : !f.v4 ? Isa::V3 : Isa::V4;
}

static Isa select() {
  int limit = static_cast<int>(detect_isa());
  if (const char* wanted = std::getenv("SOFTGL_ISA"))
    for (int i = 0; i < limit; ++i)
      if (std::strcmp(wanted, isa_name(static_cast<Isa>(i))) == 0) limit = i;
  while (limit > 0 && !find_kernels(static_cast<Isa>(limit))) --limit;
  return static_cast<Isa>(limit);
}

Isa selected_isa() {
  static const Isa isa = select();
  return isa;
}

} // namespace softgl
