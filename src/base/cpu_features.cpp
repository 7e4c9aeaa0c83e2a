#include "base/cpu_features.h"

#include <cpuid.h>
#include <cstdlib>
#include <cstring>

#include "base/kernel_table.h"

namespace softgl {

const char* isa_name(Isa isa) {
  static const char* const names[kIsaCount] = {"baseline", "v2", "v3", "v4"};
  return names[static_cast<int>(isa)];
}

Isa detect_isa() {
  // The compiler's feature test for AVX and AVX-512 asks XGETBV as well, so it covers the operating system.
  __builtin_cpu_init();
  if (!__builtin_cpu_supports("sse4.2") || !__builtin_cpu_supports("popcnt")) return Isa::Baseline;
  unsigned a = 0, b = 0, c = 0, d = 0, extended = 0;
  __get_cpuid(1, &a, &b, &c, &d);
  const bool movbe = c & bit_MOVBE, f16c = c & bit_F16C;
  if (__get_cpuid(0x80000001u, &a, &b, &c, &d)) extended = c;
  const bool lzcnt = extended & bit_LZCNT;
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("bmi") || !__builtin_cpu_supports("bmi2") ||
      !__builtin_cpu_supports("fma") || !movbe || !f16c || !lzcnt)
    return Isa::V2;
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512bw") || !__builtin_cpu_supports("avx512cd") ||
      !__builtin_cpu_supports("avx512dq") || !__builtin_cpu_supports("avx512vl"))
    return Isa::V3;
  return Isa::V4;
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
