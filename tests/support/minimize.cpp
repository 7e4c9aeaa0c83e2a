#include "support/minimize.h"

#include "support/traced_gl.h"

namespace softgl::test {

namespace {

Picture draw_without(const Gl& gl, const Scene& scene, uint64_t seed, const std::vector<bool>& skip,
                     int* calls = nullptr) {
  CallFilter filter;
  filter.skip = &skip;
  const Gl table = traced(gl, filter);
  Picture picture = draw(table, scene, seed);
  if (calls) *calls = filter.next;
  return picture;
}

} // namespace

std::vector<bool> minimize(const Gl& a, const Gl& b, const Scene& scene, uint64_t seed, int tolerance) {
  std::vector<bool> skip;
  int calls = 0;
  const Picture first = draw_without(a, scene, seed, skip, &calls),
                second = draw_without(b, scene, seed, skip);
  const Difference difference = compare(first, second);
  if (!difference.any()) return {};
  const bool only_errors =
      difference.errors && !difference.color_bytes && !difference.floats && first.depth == second.depth;
  skip.assign(calls, false);
  auto still = [&](const std::vector<bool>& candidate) {
    const Picture x = draw_without(a, scene, seed, candidate), y = draw_without(b, scene, seed, candidate);
    if (only_errors) return x.errors != y.errors;
    if (x.errors.size() > first.errors.size() || y.errors.size() > second.errors.size()) return false;
    const Difference d = compare(x, y);
    // Last bits of floats stay last bits: whatever else differs has another cause.
    if (tolerance == 0 && difference.floats && d.max_color > difference.max_color) return false;
    return d.max_color > tolerance || (tolerance == 0 && d.floats) || x.depth != y.depth;
  };
  for (bool progress = true; progress;) {
    progress = false;
    for (int length = calls / 2 ? calls / 2 : 1; length >= 1; length /= 2)
      for (int start = calls - 1; start >= 0;) {
        // The next `length` calls, from `start` downwards, that are still made.
        std::vector<bool> candidate = skip;
        int taken = 0, i = start;
        for (; i >= 0 && taken < length; i--)
          if (!candidate[i]) candidate[i] = true, taken++;
        if (taken && still(candidate)) skip = candidate, progress = true;
        start = i;
      }
  }
  return skip;
}

void print_calls(const Gl& gl, const Scene& scene, uint64_t seed, const std::vector<bool>& skip) {
  CallFilter filter;
  filter.skip = &skip;
  filter.print = stdout;
  const Gl table = traced(gl, filter);
  draw(table, scene, seed);
  std::fflush(stdout);
}

} // namespace softgl::test
