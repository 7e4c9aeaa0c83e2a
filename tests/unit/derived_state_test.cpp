// The table of snapshots (snapshot/derived_state.h): a change of the state whose dirty bit is missing is
// found, with the name of the row and of the first member that differs.
#include <catch2/catch.hpp>

#include "snapshot/derived_state.h"
#include "unit/recorded_draws.h"

using namespace softgl;
using namespace softgl::test;

namespace {

/// A triangle of a lit context whose snapshots are up to date.
struct Drawn {
  std::unique_ptr<Context> context = make_recording_context();
  VertexSource source{1u << kPosition, {}};
  PrimitiveRange triangle{GL_TRIANGLES, 0, 3};
  DrawCall call{&source, context->state.current.slot, &triangle, 1};

  Drawn() {
    context->state.lighting.enabled = context->state.lighting.light[0].enabled = true;
    update();
  }
  void update() { update_snapshots(*context, call); }
  StaleSnapshot stale() { return find_stale_snapshot(*context, call); }
};

struct Edit {
  void (*change)(Context&);
  uint32_t dirty;
  const char *row, *member; // that are out of date without the dirty bit
};
const Edit edits[] = {
    {[](Context& c) { c.state.fog.enabled = true; }, kDirtyFog, "fragment program of the state", "key"},
    {[](Context& c) { c.state.color_buffer.alpha_reference = 1; }, kDirtyColorBuffer,
     "fragment program of the state", "constants.alpha_reference"},
    {[](Context& c) { c.framebuffer.surface.encoding.bits[3] = 0; }, kDirtyFramebuffer,
     "fragment program of the state", "key"},
    {[](Context& c) { c.state.polygon.front_face = GL_CW; }, kDirtyPolygon, "raster constants", "back"},
    {[](Context& c) { c.state.scissor.enabled = true; }, kDirtyScissor, "raster constants", "y0"},
    {[](Context& c) { c.state.lighting.local_viewer = true; }, kDirtyLighting, "space of lighting",
     "the value"},
    {[](Context& c) { c.state.lighting.terms = 0; }, kDirtyLighting, "lighting constants",
     "model_ambient[0]"},
    {[](Context& c) { c.matrices.projection.top().m[3][1] = 1; }, kDirtyProjection, "transform constants",
     "mvp[13]"},
    {[](Context& c) { c.state.viewport.width = 6; }, kDirtyViewport, "transform constants",
     "window_scale[0]"},
    {[](Context& c) { c.state.transform.clip_plane_enabled = 1; }, kDirtyTransform, "clip planes",
     "the value"},
    {[](Context& c) { c.state.lighting.light[0].position.x = 2; }, kDirtyLights, "lighting constants",
     "light[0].position[0]"},
    {[](Context& c) { c.state.current.slot[kMaterial0 + 2].x = 0; }, kDirtyMaterial, "lighting constants",
     "material[1][0][0]"},
    {[](Context& c) { c.state.line.stipple = true, c.state.line.stipple_pattern = 5; }, kDirtyLine,
     "vertex program", "line_stipple"},
    {[](Context& c) { c.state.fog.coordinate_source = GL_FOG_COORDINATE; }, kDirtyFog, "vertex program",
     "fog_from_attribute"},
};

} // namespace

TEST_CASE("a missing dirty bit is found", "[snapshot]") {
  for (const Edit& edit : edits) {
    Drawn drawn;
    CHECK(drawn.stale().name == nullptr);
    edit.change(*drawn.context);
    const StaleSnapshot stale = drawn.stale();
    REQUIRE(stale.name);
    CHECK(std::string(stale.name) == edit.row);
    CHECK(stale.member == edit.member);
    drawn.context->dirty |= edit.dirty;
    CHECK(drawn.stale().name == nullptr);
    drawn.update();
    CHECK(drawn.stale().name == nullptr);
  }
}

TEST_CASE("values of the draw call need no dirty bit", "[snapshot]") {
  Drawn drawn;
  Context& c = *drawn.context;
  c.state.lighting.color_material_enabled = true;
  c.state.point.distance_attenuation = {1, 1, 0};
  c.dirty |= kDirtyMaterial | kDirtyPoint;
  drawn.update();
  const LightingConstants* lighting = c.snapshots.lighting;
  CHECK(lighting->material[kMaterialDiffuse][0][0] == 1.0f);
  CHECK(c.snapshots.layout.point < 0);
  drawn.update();
  CHECK(c.snapshots.lighting == lighting); // nothing has changed
  c.state.current.slot[kColor].x = 0.5f;
  drawn.update();
  CHECK(c.snapshots.lighting->material[kMaterialDiffuse][0][0] == 0.5f);
  drawn.source.present |= 1u << kColor;
  drawn.update();
  CHECK(c.snapshots.lighting->material_source[kMaterialDiffuse][0] == kColor);
  drawn.triangle.mode = GL_POINTS;
  drawn.update();
  CHECK(c.snapshots.layout.point >= 0);
}

TEST_CASE("the comparison with fresh snapshots leaves nothing behind", "[snapshot]") {
  Drawn drawn;
  Context& c = *drawn.context;
  const size_t used = c.frame.arena().used();
  c.state.viewport.width = 6;
  CHECK(drawn.stale().name);
  CHECK(c.frame.arena().used() == used);
  CHECK(drawn.stale().name); // the cache is as it was
}
