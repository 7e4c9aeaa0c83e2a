#include "texture/combiner_algebra.h"

#include <algorithm>
#include <string_view>

namespace softgl {

namespace {

/// OSMesa 22.3.6 compiles the environments of all units with color sum and fog into one program, and its
/// compiler takes sums and products for associative. These are those of its rules that texture environments
/// can meet, in its order and in prefix notation: + * ~ - as in CombinerNode; ! behind an operation: its
/// value has one use only; a b c any value, x y no constant, K L constants, p q products or their negatives,
/// n none.
struct Rule {
  std::string_view pattern, result;
};
constexpr Rule rules[] = {
    {"+a0", "a"},       {"+*ab*ac", "*a+bc"}, {"+-aa", "0"},         {"+-a+ab", "b"},
    {"+a+-ab", "b"},    {"*a0", "0"},         {"*a1", "a"},          {"--a", "a"},
    {"~ab", "+a-b"},    {"*!*!xyK", "**xKy"}, {"+!+!xpK", "++xKp"},  {"+!+!xyK", "++xKy"},
    {"*K*xL", "**KLx"}, {"+K+xL", "++KLx"},   {"+K-+xL", "++K-L-x"}, {"++!pqn", "++pnq"},
};

bool is_sum_or_product(char kind) { return kind == '+' || kind == '*'; }
bool has_two_operands(char kind) { return is_sum_or_product(kind) || kind == '~'; }
bool is_operation(char kind) { return has_two_operands(kind) || kind == '-' || kind == 's'; }

float clamped(float x) { return x > 0 ? (x < 1 ? x : 1.0f) : 0.0f; }

} // namespace

CombinerValue CombinerAlgebra::input(int input) {
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].kind == 'i' && nodes_[i].input == input) return CombinerValue(i);
  nodes_.push_back({'i', {-1, -1}, 0, int16_t(input)});
  return CombinerValue(nodes_.size() - 1);
}

CombinerValue CombinerAlgebra::constant(float number) {
  for (size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].kind == '#' && nodes_[i].number == number) return CombinerValue(i);
  nodes_.push_back({'#', {-1, -1}, number, 0});
  return CombinerValue(nodes_.size() - 1);
}

CombinerValue CombinerAlgebra::handed_on(CombinerValue v) {
  if (node(v).kind != '#') return v;
  nodes_.push_back({'=', {-1, -1}, node(v).number, 0});
  return CombinerValue(nodes_.size() - 1);
}

CombinerValue CombinerAlgebra::add(CombinerValue a, CombinerValue b) {
  return is(a, 0) ? b : is(b, 0) ? a : folded(operation('+', a, b));
}

CombinerValue CombinerAlgebra::subtract(CombinerValue a, CombinerValue b) {
  return is(b, 0) ? a : folded(is(a, 0) ? operation('-', b) : operation('~', a, b));
}

CombinerValue CombinerAlgebra::multiply(CombinerValue a, CombinerValue b) {
  return is(a, 0) || is(b, 1) ? a : is(b, 0) || is(a, 1) ? b : folded(operation('*', a, b));
}

CombinerValue CombinerAlgebra::operation(char kind, CombinerValue a, CombinerValue b) {
  const CombinerValue v = CombinerValue(nodes_.size());
  nodes_.push_back({kind, {a, b}, 0, 0});
  ++node(a).uses;
  if (b >= 0) ++node(b).uses;
  order_.insert(order_.begin() + ptrdiff_t(place_++), v);
  return v;
}

void CombinerAlgebra::remove(CombinerValue v) {
  node(v).removed = true;
  for (CombinerValue operand : node(v).operand)
    if (operand >= 0) --node(operand).uses;
}

void CombinerAlgebra::replace(CombinerValue from, CombinerValue to) {
  for (CombinerValue v : order_)
    for (CombinerValue& operand : node(v).operand)
      if (operand == from && !node(v).removed) operand = to, --node(from).uses, ++node(to).uses;
  for (int i = 0; i < result_count_; ++i)
    if (results_[i] == from) results_[i] = to, --node(from).uses, ++node(to).uses;
  remove(from);
}

void CombinerAlgebra::remove_unused() {
  for (size_t i = order_.size(); i-- > 0;)
    if (!node(order_[i]).removed && node(order_[i]).uses == 0) remove(order_[i]);
  std::erase_if(order_, [this](CombinerValue v) { return node(v).removed; });
}

void CombinerAlgebra::reveal_constants() {
  for (size_t i = 0, count = nodes_.size(); i < count; ++i)
    if (nodes_[i].kind == '=') replace(CombinerValue(i), constant(nodes_[i].number));
}

void CombinerAlgebra::share_equals() {
  auto equal = [](const CombinerNode& a, const CombinerNode& b) {
    if (a.kind != b.kind) return false;
    if (a.operand[0] == b.operand[0] && a.operand[1] == b.operand[1]) return true;
    return is_sum_or_product(a.kind) && a.operand[0] == b.operand[1] && a.operand[1] == b.operand[0];
  };
  for (size_t i = 0; i < order_.size(); ++i)
    for (size_t earlier = 0; earlier < i; ++earlier)
      if (!node(order_[earlier]).removed && equal(node(order_[earlier]), node(order_[i]))) {
        replace(order_[i], order_[earlier]);
        break;
      }
  std::erase_if(order_, [this](CombinerValue v) { return node(v).removed; });
}

/// An operation, or the constant that it gives for constants.
CombinerValue CombinerAlgebra::folded(CombinerValue v) {
  const CombinerNode& n = node(v);
  const CombinerNode& a = node(n.operand[0]);
  const CombinerNode& b = n.operand[1] >= 0 ? node(n.operand[1]) : a;
  if (a.kind != '#' || b.kind != '#') return v;
  const float x = a.number, y = b.number;
  return constant(n.kind == '+'   ? x + y
                  : n.kind == '*' ? x * y
                  : n.kind == '~' ? x - y
                  : n.kind == '-' ? -x
                                  : clamped(x));
}

bool CombinerAlgebra::fold_constants() {
  bool progress = false;
  for (CombinerValue v : order_) {
    if (node(v).removed) continue;
    const CombinerValue to = folded(v);
    if (to == v) continue;
    replace(v, to);
    progress = true;
  }
  return progress;
}

/// One try to find a pattern: of each sum or product, in the pattern's order, a bit of `flips` exchanges the
/// operands.
class CombinerAlgebra::Match {
public:
  Match(const CombinerAlgebra& algebra, unsigned flips) : algebra_(algebra), flips_(flips) {
    std::fill_n(bound_, 32, CombinerValue(-1));
  }
  CombinerValue operator[](char name) const { return bound_[name & 31]; }

  bool finds(const char*& pattern, CombinerValue v) {
    const char c = *pattern++;
    const CombinerNode& n = algebra_[v];
    if (!is_operation(c)) return binds(c, v, n);
    if (*pattern == '!' && (++pattern, n.uses != 1)) return false;
    if (n.kind != c) return false;
    if (!has_two_operands(c)) return finds(pattern, n.operand[0]);
    const unsigned flip = is_sum_or_product(c) ? flips_ & 1 : 0;
    if (is_sum_or_product(c)) flips_ >>= 1;
    return finds(pattern, n.operand[flip]) && finds(pattern, n.operand[flip ^ 1]);
  }

private:
  const CombinerAlgebra& algebra_;
  unsigned flips_;
  CombinerValue bound_[32];

  bool is_product(const CombinerNode& n) const {
    return n.kind == '-' ? is_product(algebra_[n.operand[0]]) : n.kind == '*';
  }
  bool binds(char name, CombinerValue v, const CombinerNode& n) {
    if (name == '0' || name == '1') return n.kind == '#' && n.number == float(name - '0');
    CombinerValue& bound = bound_[name & 31];
    if (bound >= 0) return bound == v;
    bound = v;
    switch (name) {
    case 'x':
    case 'y': return n.kind != '#';
    case 'K':
    case 'L': return n.kind == '#';
    case 'p':
    case 'q': return is_product(n);
    case 'n': return !is_product(n);
    default: return true;
    }
  }
};

CombinerValue CombinerAlgebra::build(const char*& pattern, const Match& match) {
  const char c = *pattern++;
  if (c == '0' || c == '1') return constant(float(c - '0'));
  if (!is_operation(c)) return match[c];
  const CombinerValue a = build(pattern, match),
                      b = has_two_operands(c) ? build(pattern, match) : CombinerValue(-1);
  return operation(c, a, b);
}

/// What the first rule that fits makes of a value; the value itself if none does.
CombinerValue CombinerAlgebra::rewritten(CombinerValue v) {
  for (const Rule& rule : rules) {
    if (rule.pattern[0] != node(v).kind) continue;
    const auto sums = std::count_if(rule.pattern.begin(), rule.pattern.end(), is_sum_or_product);
    for (unsigned flips = 0; flips < 1u << sums; ++flips) {
      Match match(*this, flips);
      const char* pattern = rule.pattern.data();
      if (!match.finds(pattern, v)) continue;
      place_ = size_t(std::find(order_.begin(), order_.end(), v) - order_.begin());
      const char* result = rule.result.data();
      return build(result, match);
    }
  }
  return v;
}

/// The last operation first, so that the largest pattern is found first; what follows from a change is looked
/// at again. What a rule makes, and what it leaves without use, stays as it is until the next time.
bool CombinerAlgebra::rewrite() {
  bool progress = false;
  std::vector<CombinerValue> waiting(order_.rbegin(), order_.rend());
  std::vector<bool> changed;
  for (size_t i = 0; i < waiting.size(); ++i) {
    const CombinerValue v = waiting[i];
    if (node(v).removed) continue;
    const CombinerValue to = rewritten(v);
    if (to == v) continue;
    replace(v, to);
    progress = true;
    changed.assign(nodes_.size(), false);
    changed[size_t(to)] = true;
    for (CombinerValue user : order_) {
      const CombinerNode& n = node(user);
      if (n.removed ||
          !(changed[size_t(n.operand[0])] || (n.operand[1] >= 0 && changed[size_t(n.operand[1])])))
        continue;
      changed[size_t(user)] = true;
      waiting.push_back(user);
    }
  }
  std::erase_if(order_, [this](CombinerValue v) { return node(v).removed; });
  return progress;
}

void CombinerAlgebra::simplify(CombinerValue* results, int count) {
  results_ = results, result_count_ = count;
  for (int i = 0; i < count; ++i) ++node(results[i]).uses;
  reveal_constants();
  for (bool progress = true; progress;) {
    remove_unused();
    share_equals();
    progress = rewrite();
    progress |= fold_constants();
  }
  remove_unused();
}

} // namespace softgl
