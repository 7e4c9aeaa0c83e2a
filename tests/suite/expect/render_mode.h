// Selection and feedback (5.2, 5.3), as the specification's machine has them.
#pragma once

#include "expect/primitive.h"
#include "script/fed_values.h"

namespace softgl::suite {

struct RenderModeState {
  GLenum mode = GL_RENDER;
  int selection_size = -1, feedback_size = -1; // -1 before there is a buffer
  GLenum feedback_type = GL_2D;
  std::vector<Interval> selection_memory, feedback_memory; // what the buffers hold
  std::vector<FedItem> items;                              // since feedback began
  std::vector<GLuint> names;
  bool hit = false;
  Interval least, greatest; // depths of the hits
  std::vector<Interval> records;
  int hits = 0;
  // Of the last glRenderMode.
  Interval result;
  std::vector<FedItem> given;
};

/// A primitive in window coordinates that selection hits.
void note_hit(RenderModeState& state, const std::vector<LitVertex>& vertices);
/// A point, a line, a bitmap or an image. `back`: with the colors of the back.
void feed_back(RenderModeState& state, GLenum token, const std::vector<LitVertex>& vertices,
               bool back = false);
/// A polygon by its modes and the culling of its face.
void receive_polygon(RenderModeState& state, const PolygonState& polygon,
                     const std::vector<LitVertex>& vertices);
/// Writes the record of the hits since the names changed last.
void write_record(RenderModeState& state);
void change_mode(RenderModeState& state, GLenum mode);
/// What PaintFeedback paints. Throws std::logic_error where the specification leaves it open.
std::vector<Interval> fed_numbers(const RenderModeState& state, FedOrder order);

} // namespace softgl::suite
