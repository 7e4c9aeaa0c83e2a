// Combiner programs: the order of additions that OSMesa's compiler chooses, and what every program must keep.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/random.h"
#include "texture/combiner_algebra.h"
#include "texture/combiner_chain.h"

using namespace softgl;
using softgl::test::Random;

namespace {

/// A value as a formula in full parentheses; inputs are lower-case letters.
std::string formula(const CombinerAlgebra& algebra, CombinerValue v) {
  const CombinerNode& n = algebra[v];
  if (n.kind == 'i') return std::string(1, char('a' + n.input));
  if (n.kind == '#') return std::to_string(n.number).substr(0, n.number < 0 ? 4 : 3);
  const std::string first = formula(algebra, n.operand[0]);
  if (n.kind == '-') return "-" + first;
  if (n.kind == 's') return "sat" + first;
  return "(" + first + n.kind + formula(algebra, n.operand[1]) + ")";
}

std::string simplified(CombinerAlgebra& algebra, CombinerValue v) {
  algebra.simplify(&v, 1);
  return formula(algebra, v);
}

/// All values that a program may read, and its registers.
struct Values {
  float v[256] = {};
};

void run(const CombinerProgram& p, Values& values, float* result) {
  std::copy_n(p.constant, kCombinerConstants, &values.v[kCombinerConstant]);
  for (int i = 0; i < p.step_count; ++i) {
    const CombinerStep s = p.step[i];
    const float a = values.v[s.a], b = values.v[s.b];
    REQUIRE((s.result >= kCombinerRegister && s.result != s.a && s.result != s.b));
    switch (s.operation) {
    case CombinerOperation::Copy: values.v[s.result] = a; break;
    case CombinerOperation::Negate: values.v[s.result] = -a; break;
    case CombinerOperation::Saturate: values.v[s.result] = std::clamp(a, 0.0f, 1.0f); break;
    case CombinerOperation::Add: values.v[s.result] = a + b; break;
    case CombinerOperation::Subtract: values.v[s.result] = a - b; break;
    case CombinerOperation::Multiply: values.v[s.result] = a * b; break;
    }
  }
  for (int k = 0; k < 4; ++k) result[k] = values.v[p.result[k]];
}

CombinerChain random_chain(Random& r) {
  CombinerChain chain;
  chain.color_sum = r.chance(50);
  const int textures = r.pick({2, 8}); // few inputs give many equal terms, which wait in registers
  const bool interpolates = r.chance(30);
  for (int u = 0; u < 8; ++u) {
    if (r.chance(80)) chain.units = uint8_t(chain.units | 1u << u);
    CombinerChain::Unit& unit = chain.unit[u];
    unit.function[0] = interpolates ? CombineFunction::Interpolate : CombineFunction(r.integer(0, 12));
    unit.function[1] = interpolates ? CombineFunction::Interpolate : CombineFunction(r.integer(0, 10));
    for (int part = 0; part < 2; ++part) {
      for (CombineArgument& a : unit.argument[part])
        a = {r.chance(40)   ? CombineSource::Previous
             : r.chance(30) ? r.pick({CombineSource::Constant, CombineSource::Primary})
                            : CombineSource(r.integer(0, textures - 1)),
             uint8_t(part == 1 || r.chance(50)), uint8_t(r.chance(50))};
      unit.scale[part] = uint8_t(r.chance(90) ? 1 : r.pick({2, 4}));
    }
  }
  return chain;
}

/// GL 1.5, 3.8.13, in double.
void expected(const CombinerChain& chain, const Values& in, double* color) {
  for (int k = 0; k < 4; ++k) color[k] = double(in.v[kCombinerPrimary + k]);
  for (int u = 0; u < 8; ++u) {
    if (!(chain.units >> u & 1)) continue;
    const CombinerChain::Unit& unit = chain.unit[u];
    auto argument = [&](int part, int i, int k) {
      const CombineArgument a = unit.argument[part][i];
      k = a.alpha ? 3 : k;
      const double v =
          a.source == CombineSource::Previous
              ? color[k]
              : double(in.v[a.source == CombineSource::Constant  ? kCombinerEnvironment + 4 * u + k
                            : a.source == CombineSource::Primary ? kCombinerPrimary + k
                                                                 : 4 * int(a.source) + k]);
      return a.complement ? 1 - v : v;
    };
    auto combined = [&](int part, int k) {
      const double a = argument(part, 0, k), b = argument(part, 1, k), c = argument(part, 2, k),
                   d = argument(part, 3, k);
      double dot = 0;
      for (int i = 0; i < 3; ++i) dot += 4 * (argument(0, 0, i) - 0.5) * (argument(0, 1, i) - 0.5);
      const double value[13] = {
          a,         a * b,           a + b,     a + b - 0.5,   a * c + b * (1 - c), a - b,
          a * c + b, a * c + b - 0.5, a * c - b, a * b + c * d, a * b + c * d - 0.5, dot,
          dot};
      return std::clamp(value[int(unit.function[part])] * unit.scale[k == 3], 0.0, 1.0);
    };
    const double result[4] = {combined(0, 0), combined(0, 1), combined(0, 2),
                              combined(unit.function[0] == CombineFunction::Dot3Rgba ? 0 : 1, 3)};
    std::copy_n(result, 4, color);
  }
  for (int k = 0; k < 3 && chain.color_sum; ++k) color[k] += double(in.v[kCombinerSecondary + k]);
}

} // namespace

TEST_CASE("sums of products take further terms into the first product", "[combiner]") {
  CombinerAlgebra g;
  const CombinerValue a = g.input(0), b = g.input(1), c = g.input(2), d = g.input(3), e = g.input(4);
  SECTION("after a unit that interpolates") {
    CHECK(simplified(g, g.add(g.add(g.multiply(a, b), g.multiply(c, d)), e)) == "(((a*b)+e)+(c*d))");
  }
  SECTION("but not products") {
    CHECK(simplified(g, g.add(g.add(g.multiply(a, b), g.multiply(c, d)), g.multiply(e, a))) ==
          "(((a*b)+(c*d))+(e*a))");
  }
  SECTION("nor where the sum is clamped") {
    CHECK(simplified(g, g.add(g.saturate(g.add(g.multiply(a, b), g.multiply(c, d))), e)) ==
          "(sat((a*b)+(c*d))+e)");
  }
  SECTION("nor where it has another use") {
    const CombinerValue sum = g.add(g.multiply(a, b), g.multiply(c, d));
    CHECK(simplified(g, g.multiply(sum, g.add(sum, e))) == "(((a*b)+(c*d))*(((a*b)+(c*d))+e))");
  }
}

TEST_CASE("constants go where they fold, and to terms that are no products", "[combiner]") {
  CombinerAlgebra g;
  const CombinerValue a = g.input(0), b = g.input(1), c = g.input(2), half = g.constant(-0.5f),
                      one = g.constant(1);
  SECTION("the first term") { CHECK(simplified(g, g.add(g.add(a, b), half)) == "((a+-0.5)+b)"); }
  SECTION("no product") {
    CHECK(simplified(g, g.add(g.add(g.multiply(a, b), c), half)) == "((c+-0.5)+(a*b))");
  }
  SECTION("1 - a") { CHECK(simplified(g, g.add(g.add(g.subtract(one, a), b), half)) == "((0.5+-a)+b)"); }
  SECTION("1 - (1 - a)") {
    CHECK(simplified(g, g.multiply(b, g.subtract(one, g.subtract(one, a)))) == "(b*a)");
  }
  SECTION("a + (1 - a)") { CHECK(simplified(g, g.add(a, g.subtract(one, a))) == "1.0"); }
  SECTION("1 * a") {
    // It is a before anything is looked at; otherwise a would be a common factor.
    CHECK(simplified(g, g.add(g.multiply(one, a), g.multiply(a, g.subtract(one, a)))) == "(a+(a*(1.0+-a)))");
  }
  SECTION("a difference") {
    // It becomes a sum first; otherwise the third term would be in the first product before the common factor
    // is found.
    const CombinerValue sum = g.add(g.multiply(a, c), g.multiply(a, g.subtract(one, c)));
    CHECK(simplified(g, g.subtract(sum, b)) == "(a+-b)");
  }
  SECTION("a common factor") {
    CHECK(simplified(g, g.add(g.multiply(a, b), g.multiply(c, a))) == "(a*(c+b))");
  }
}

TEST_CASE("programs of random chains compute the environments within their limits", "[combiner]") {
  Random r(7);
  int most_steps = 0, most_registers = 0, most_constants = 0;
  for (int n = 0; n < 3000; ++n) {
    const CombinerChain chain = random_chain(r);
    const auto program = make_combiner_program(chain);
    Values values;
    for (float& v : values.v) v = r.real(0, 1);
    double wanted[4];
    float got[4];
    expected(chain, values, wanted);
    run(*program, values, got);
    for (int k = 0; k < 4; ++k) {
      INFO("chain " << n << ", component " << k);
      CHECK(std::abs(double(got[k]) - wanted[k]) < 1e-4);
    }
    most_steps = std::max(most_steps, program->step_count);
    for (int i = 0; i < program->step_count; ++i)
      most_registers = std::max(most_registers, program->step[i].result - kCombinerRegister + 1);
    while (most_constants < kCombinerConstants && program->constant[most_constants] != 0) ++most_constants;
  }
  // Far from the limits: nobody checks them when programs are made.
  CHECK(most_steps <= CombinerProgram::kMaxSteps / 2);
  CHECK(most_registers <= kCombinerRegisters / 3);
  CHECK(most_constants <= kCombinerConstants / 3);
}

TEST_CASE("a cache of combiner programs gives one chain one program", "[combiner]") {
  Random r(8);
  const CombinerChain a = random_chain(r);
  CombinerChain b = a;
  b.color_sum = !b.color_sum;
  CombinerCache cache;
  const auto first = cache.program(a);
  CHECK(cache.program(b) != first);
  CHECK(cache.program(a) == first);
}
