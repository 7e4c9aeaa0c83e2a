// The arithmetic of texture environments as a graph, and what OSMesa's compiler makes of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace softgl {

/// A value of the graph, by number: an input, a constant, or the result of an operation.
using CombinerValue = int16_t;

struct CombinerNode {
  char kind; // '+' '*' '~' (a difference) '-' (the negative) 's' (clamped) '#' (a constant) 'i' (an input)
             // '=' (a constant that is not yet known as one)
  CombinerValue operand[2]; // -1: none
  float number;             // of a constant
  int16_t input;
  int16_t uses = 0; // by operations that are still there, and as a result
  bool removed = false;
};

class CombinerAlgebra {
public:
  CombinerValue input(int input);
  CombinerValue constant(float number);
  // What constants make superfluous does not become an operation.
  CombinerValue add(CombinerValue a, CombinerValue b);
  CombinerValue subtract(CombinerValue a, CombinerValue b);
  CombinerValue multiply(CombinerValue a, CombinerValue b);
  CombinerValue saturate(CombinerValue a) { return folded(operation('s', a)); }
  /// What a unit gives to the next ones. They do not see that it is constant before simplify().
  CombinerValue handed_on(CombinerValue v);
  const CombinerNode& operator[](CombinerValue v) const { return nodes_[size_t(v)]; }

  /// Rewrites what leads to these values; they may become others. No differences are left.
  void simplify(CombinerValue* results, int count);

private:
  class Match;
  std::vector<CombinerNode> nodes_;
  std::vector<CombinerValue> order_; // the operations, operands first
  size_t place_ = 0;                 // in order_, of the next operation
  CombinerValue* results_ = nullptr;
  int result_count_ = 0;

  bool is(CombinerValue v, float number) const {
    return (*this)[v].kind == '#' && (*this)[v].number == number;
  }
  CombinerNode& node(CombinerValue v) { return nodes_[size_t(v)]; }
  CombinerValue operation(char kind, CombinerValue a, CombinerValue b = -1);
  void remove(CombinerValue v);
  void replace(CombinerValue from, CombinerValue to);
  void remove_unused();
  void share_equals();
  void reveal_constants();
  CombinerValue folded(CombinerValue v);
  bool fold_constants();
  bool rewrite();
  CombinerValue rewritten(CombinerValue v);
  CombinerValue build(const char*& pattern, const Match& match);
};

} // namespace softgl
