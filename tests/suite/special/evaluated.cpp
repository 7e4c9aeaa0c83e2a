#include "special/evaluated.h"

namespace softgl::suite {

void arch(Script& s, double from, double to) {
  s.Map1f(GL_MAP1_VERTEX_3, from, to, 3, 4,
          V{-0.9, -0.7, 0.2, -0.5, 1.3, -1.4, 0.4, 1.1, 0.7, 0.85, -0.6, 0.3});
  s.Enable(GL_MAP1_VERTEX_3);
}

void arch_colors(Script& s) {
  s.Map1f(GL_MAP1_COLOR_4, 0, 1, 4, 3, V{1, 0.1, 0.2, 1, 0.3, 0.9, 0.1, 0.4, 0.2, 0.3, 1, 0.8});
  s.Enable(GL_MAP1_COLOR_4);
}

void hill(Script& s, double u1, double u2, double v1, double v2) {
  V points;
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 3; j++)
      points.insert(points.end(), {-0.83 + 0.57 * i + 0.05 * j, -0.8 + 0.82 * j - 0.07 * i,
                                   (i == 1 || i == 2) && j == 1 ? 1.2 : 0.1 * i - 0.2 * j});
  s.Map2f(GL_MAP2_VERTEX_3, u1, u2, 9, 4, v1, v2, 3, 3, points), s.Enable(GL_MAP2_VERTEX_3);
}

void hill_colors(Script& s) {
  s.Map2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2,
          V{1, 0.1, 0.2, 1, 0.3, 0.9, 0.1, 0.4, 0.2, 0.3, 1, 0.8, 0.9, 0.8, 0.3, 0.6});
  s.Enable(GL_MAP2_COLOR_4);
}

} // namespace softgl::suite
