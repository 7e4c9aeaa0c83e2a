// What the trace knows of calls and names: tables, generated. Text lies in one piece and is told by where it
// begins, so that nothing of them has to be relocated when the library is loaded.
#pragma once

#include <cstdint>

namespace softgl {

enum class TraceType : uint8_t {
  Void,
  Byte,
  UnsignedByte,
  Short,
  UnsignedShort,
  Int,
  UnsignedInt,
  Long,
  UnsignedLong,
  Float,
  Double,
  Boolean,
  Enum,
  Bits,
  Pointer,
  String
};

/// How many values stand where an argument points to.
enum class TraceLength : uint8_t {
  Value,     // it is the value itself
  Fixed,     // `operand`
  Argument,  // what argument number `operand` says
  Parameter, // as many as the parameter has that the argument before names: count_of(operand, name)
  State,     // as many as the state value has that the argument before names
  Lists,     // of glCallLists: argument 0 says how many, argument 1 of which type
  Attributes // pairs of a name and a value, ended by 0
};

struct TraceParameter {
  uint16_t name;  // in kTraceText
  TraceType type; // of the value, or of the values that it points to
  uint8_t group;  // of the values' names: kNoNames, kAnyName, kNamesOfParameter or another
  TraceLength length;
  uint8_t operand;
  bool out; // the values are there after the call
};

constexpr uint8_t kNoNames = 0, kAnyName = 1, kNamesOfParameter = 255;

struct TraceCall {
  uint16_t name;      // in kTraceText
  uint16_t parameter; // the first one
  uint8_t parameter_count;
  TraceType result;
  uint8_t result_group;
};

struct TraceName {
  uint32_t value, name; // in kTraceText
};

/// The group of the values that a parameter takes.
struct TraceValueGroup {
  uint32_t parameter;
  uint8_t group;
};

extern const TraceCall kTraceCalls[]; // by TracedCall
extern const TraceParameter kTraceParameters[];
extern const uint16_t kTraceGroups[];
extern const TraceName kTraceNames[];
extern const TraceValueGroup kTraceValueGroups[]; // sorted by parameter
extern const int kTraceValueGroupCount;
extern const char kTraceText[];

} // namespace softgl
