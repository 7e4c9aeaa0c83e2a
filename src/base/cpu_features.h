// Which instruction sets this processor, its operating system and this build offer.
#pragma once

namespace softgl {

/// The x86-64 levels of the psABI, in rising order.
enum class Isa { Baseline, V2, V3, V4 };
constexpr int kIsaCount = 4;

/// "baseline", "v2", "v3" or "v4".
const char* isa_name(Isa isa);
/// The highest level that the processor and the operating system support.
Isa detect_isa();
/// The level to use: the highest that is supported and built, or, when the environment variable SOFTGL_ISA
/// names a lower one, the highest built level that is not above it. Read once.
Isa selected_isa();

} // namespace softgl
