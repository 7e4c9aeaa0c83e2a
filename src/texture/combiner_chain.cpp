#include "texture/combiner_chain.h"

#include <cstring>
#include <map>

#include "base/fast_paths.h"
#include "texture/combiner_algebra.h"

namespace softgl {

namespace {

/// Builds the graph of the units' functions (GL 1.5, 3.8.13), the operations in the order of OSMesa 22.3.6.
class ChainBuilder {
public:
  CombinerAlgebra algebra;
  CombinerValue color[4];

  ChainBuilder() {
    for (int k = 0; k < 4; ++k) color[k] = algebra.input(kCombinerPrimary + k);
  }

  void add_unit(const CombinerChain::Unit& unit, int number) {
    unit_ = &unit, number_ = number;
    const bool dot = unit.function[0] >= CombineFunction::Dot3Rgb,
               dot_alpha = unit.function[0] == CombineFunction::Dot3Rgba;
    CombinerValue result[4];
    if (dot)
      result[0] = result[1] = result[2] = dot3();
    else
      for (int k = 0; k < 3; ++k) result[k] = combined(0, k);
    result[3] = dot_alpha ? result[0] : combined(1, 3);
    // A scale of one part makes OSMesa clamp the other too.
    const bool scaled = unit.scale[0] != 1 || unit.scale[1] != 1;
    for (int k = 0; k < 4; ++k) {
      const int part = k == 3;
      if (unit.scale[part] != 1) result[k] = algebra.multiply(result[k], algebra.constant(unit.scale[part]));
      if (scaled || clamps(unit.function[dot_alpha ? 0 : part])) result[k] = algebra.saturate(result[k]);
      color[k] = algebra.handed_on(result[k]);
    }
  }

  void add_color_sum() {
    for (int k = 0; k < 3; ++k) color[k] = algebra.add(color[k], algebra.input(kCombinerSecondary + k));
  }

private:
  const CombinerChain::Unit* unit_ = nullptr;
  int number_ = 0;

  static bool clamps(CombineFunction f) {
    return f != CombineFunction::Replace && f != CombineFunction::Modulate &&
           f != CombineFunction::Interpolate;
  }

  CombinerValue opposite(CombinerValue v) { return algebra.subtract(algebra.constant(1), v); }

  CombinerValue argument(int part, int i, int k) {
    const CombineArgument& a = unit_->argument[part][i];
    if (a.alpha) k = 3;
    const CombinerValue v =
        a.source == CombineSource::Previous   ? color[k]
        : a.source == CombineSource::Zero     ? algebra.constant(0)
        : a.source == CombineSource::One      ? algebra.constant(1)
        : a.source == CombineSource::Constant ? algebra.input(kCombinerEnvironment + 4 * number_ + k)
        : a.source == CombineSource::Primary  ? algebra.input(kCombinerPrimary + k)
                                              : algebra.input(kCombinerTexel + 4 * int(a.source) + k);
    return a.complement ? opposite(v) : v;
  }

  CombinerValue combined(int part, int k) {
    const CombinerValue a = argument(part, 0, k);
    switch (unit_->function[part]) {
    case CombineFunction::Modulate: return algebra.multiply(a, argument(part, 1, k));
    case CombineFunction::Add: return algebra.add(a, argument(part, 1, k));
    case CombineFunction::AddSigned:
      return algebra.add(algebra.add(a, argument(part, 1, k)), algebra.constant(-0.5f));
    case CombineFunction::Subtract: return algebra.subtract(a, argument(part, 1, k));
    case CombineFunction::Interpolate: {
      const CombinerValue weight = argument(part, 2, k), first = algebra.multiply(a, weight),
                          b = argument(part, 1, k);
      return algebra.add(first, algebra.multiply(b, opposite(weight)));
    }
    case CombineFunction::ModulateAdd: return algebra.add(product(part, 0, 2, k), argument(part, 1, k));
    case CombineFunction::ModulateSignedAdd:
      return algebra.add(algebra.add(product(part, 0, 2, k), argument(part, 1, k)), algebra.constant(-0.5f));
    case CombineFunction::ModulateSubtract:
      return algebra.subtract(product(part, 0, 2, k), argument(part, 1, k));
    case CombineFunction::AddProducts: return sum_of_products(part, k);
    case CombineFunction::AddProductsSigned:
      return algebra.add(sum_of_products(part, k), algebra.constant(-0.5f));
    default: return a;
    }
  }

  CombinerValue product(int part, int i, int j, int k) {
    const CombinerValue a = argument(part, i, k);
    return algebra.multiply(a, argument(part, j, k));
  }

  CombinerValue sum_of_products(int part, int k) {
    const CombinerValue a = product(part, 0, 1, k);
    return algebra.add(a, product(part, 2, 3, k));
  }

  CombinerValue dot3() {
    CombinerValue product[3];
    for (int k = 0; k < 3; ++k) {
      CombinerValue factor[2];
      for (int i = 0; i < 2; ++i)
        factor[i] =
            algebra.add(algebra.multiply(argument(0, i, k), algebra.constant(2)), algebra.constant(-1));
      product[k] = algebra.multiply(factor[0], factor[1]);
    }
    return algebra.add(product[0], algebra.add(product[1], product[2]));
  }
};

/// Lists the operations behind the results, and finds registers for their values.
class StepWriter {
public:
  StepWriter(const CombinerAlgebra& algebra, CombinerProgram& program)
      : algebra_(algebra), program_(program) {}

  void write(const CombinerValue* results) {
    for (int k = 0; k < 4; ++k) visit(results[k]);
    for (CombinerValue v : order_) {
      const Operation o = operation(v);
      const uint8_t a = place(o.a), b = place(o.b);
      place_[v] = step(o.kind, a, b);
      release(o.a);
      if (o.b != o.a) release(o.b);
    }
    for (int k = 0; k < 4; ++k) {
      // The results are stored when all are there, and nothing but the other components of the primary color
      // is in their way.
      const uint8_t v = place(results[k]);
      const bool moves = v >= kCombinerPrimary && v < kCombinerSecondary && v != kCombinerPrimary + k;
      program_.result[k] = moves ? step(CombinerOperation::Copy, v, v) : v;
    }
  }

private:
  struct Operation {
    CombinerOperation kind;
    CombinerValue a, b; // the same where there is one operand
  };
  const CombinerAlgebra& algebra_;
  CombinerProgram& program_;
  std::map<CombinerValue, int> uses_; // that are still to come
  std::map<CombinerValue, uint8_t> place_;
  std::vector<CombinerValue> order_;
  std::vector<uint8_t> free_;
  int registers_ = 0, constants_ = 0;

  bool is_leaf(CombinerValue v) const { return algebra_[v].kind == 'i' || algebra_[v].kind == '#'; }

  Operation operation(CombinerValue v) const {
    const CombinerNode& n = algebra_[v];
    const CombinerValue a = n.operand[0], b = n.operand[1];
    if (n.kind == '-') return {CombinerOperation::Negate, a, a};
    if (n.kind == 's') return {CombinerOperation::Saturate, a, a};
    if (n.kind == '*') return {CombinerOperation::Multiply, a, b};
    if (algebra_[b].kind == '-') return {CombinerOperation::Subtract, a, algebra_[b].operand[0]};
    if (algebra_[a].kind == '-') return {CombinerOperation::Subtract, b, algebra_[a].operand[0]};
    return {CombinerOperation::Add, a, b};
  }

  void visit(CombinerValue v) {
    if (is_leaf(v) || uses_[v]++ > 0) return;
    const Operation o = operation(v);
    visit(o.a);
    if (o.b != o.a) visit(o.b);
    order_.push_back(v);
  }

  uint8_t place(CombinerValue v) {
    const CombinerNode& n = algebra_[v];
    if (n.kind == 'i') return uint8_t(n.input);
    if (n.kind == '#' && !place_.count(v)) {
      program_.constant[constants_] = n.number;
      place_[v] = uint8_t(kCombinerConstant + constants_++);
    }
    return place_[v];
  }

  void release(CombinerValue v) {
    if (!is_leaf(v) && --uses_[v] == 0) free_.push_back(place_[v]);
  }

  uint8_t step(CombinerOperation kind, uint8_t a, uint8_t b) {
    if (free_.empty()) free_.push_back(uint8_t(kCombinerRegister + registers_++));
    const uint8_t result = free_.back();
    free_.pop_back();
    program_.step[program_.step_count++] = {kind, result, a, b};
    return result;
  }
};

} // namespace

std::shared_ptr<const CombinerProgram> make_combiner_program(const CombinerChain& chain) {
  ChainBuilder builder;
  for (int u = 0; u < kMaxTextureUnits; ++u)
    if (chain.units >> u & 1) builder.add_unit(chain.unit[u], u);
  if (chain.color_sum) builder.add_color_sum();
  builder.algebra.simplify(builder.color, 4);
  auto program = std::make_shared<CombinerProgram>();
  StepWriter(builder.algebra, *program).write(builder.color);
  return program;
}

std::shared_ptr<const CombinerProgram> CombinerCache::program(const CombinerChain& chain) {
  if (!takes(FastPath::KeptCombiners)) return make_combiner_program(chain);
  for (const auto& [known, program] : kept_)
    if (std::memcmp(&known, &chain, sizeof chain) == 0) return program;
  if (kept_.size() == kLimit) kept_.clear();
  kept_.emplace_back(chain, make_combiner_program(chain));
  return kept_.back().second;
}

} // namespace softgl
