// Occlusion queries (GL 1.5, 4.1.7 and 6.1.12).
#include <algorithm>
#include <limits>
#include <memory>

#include "commands/framebuffer/flush.h"
#include "commands/generated/commands.h"
#include "context/context.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

constexpr GLint kCounterBits = 64;

template <class T> void get_query_object(Context& c, GLuint id, GLenum pname, T* params) {
  const std::shared_ptr<QueryObject> query = c.queries.objects.find(id);
  if (!query && SOFTGL_FAULT(query_of_any_name)) return;
  if (!query || (id == c.queries.active && !SOFTGL_FAULT(query_result_any_time)))
    return set_error(c, GL_INVALID_OPERATION);
  if (pname != GL_QUERY_RESULT && pname != GL_QUERY_RESULT_AVAILABLE)
    return set_error(c, GL_INVALID_ENUM, "pname");
  // Whoever asks whether the result is there may wait for it by asking again: so it is made now.
  if (query->samples.use_count() > 1 && !SOFTGL_FAULT(query_not_waited_for)) flush_rendering(c);
  if (pname == GL_QUERY_RESULT_AVAILABLE)
    *params = SOFTGL_FAULT(query_never_available) ? GL_FALSE : GL_TRUE;
  else if (SOFTGL_FAULT(query_tells_whether))
    *params = *query->samples != 0;
  else
    *params = T(std::min(*query->samples, uint64_t(std::numeric_limits<T>::max())));
}

} // namespace

namespace gl {

void GenQueries(Context& c, GLsizei n, GLuint* ids) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (c.queries.active) return set_error(c, GL_INVALID_OPERATION);
  if (!c.queries.objects.reserve(n, ids)) set_error(c, GL_OUT_OF_MEMORY);
}

void DeleteQueries(Context& c, GLsizei n, const GLuint* ids) {
  if (n < 0) return set_error(c, GL_INVALID_VALUE, "n");
  if (c.queries.active && !SOFTGL_FAULT(query_deleted_any_time)) return set_error(c, GL_INVALID_OPERATION);
  for (GLsizei i = 0; i < n && !SOFTGL_FAULT(query_stays_deleted); ++i) c.queries.objects.erase(ids[i]);
}

GLboolean IsQuery(Context& c, GLuint id) {
  if (SOFTGL_FAULT(every_name_is_query)) return id != 0;
  if (SOFTGL_FAULT(query_is_late) && id == c.queries.active) return GL_FALSE;
  return c.queries.objects.find(id) ? GL_TRUE : GL_FALSE;
}

void BeginQuery(Context& c, GLenum target, GLuint id) {
  if (target != GL_SAMPLES_PASSED && !SOFTGL_FAULT(query_of_any_target))
    return set_error(c, GL_INVALID_ENUM, "target");
  if (id == 0 && !SOFTGL_FAULT(query_0_taken)) return set_error(c, GL_INVALID_OPERATION);
  if (c.queries.active && !SOFTGL_FAULT(query_within_query)) return set_error(c, GL_INVALID_OPERATION);
  // A counter of its own: draws that wait may still count into that of the last time.
  auto samples = std::make_shared<uint64_t>(0);
  const auto query = c.queries.objects.find_or_create(id, [] { return std::make_shared<QueryObject>(); });
  if (SOFTGL_FAULT(query_counts_on) && query->samples) samples = query->samples;
  query->samples = samples;
  c.queries.active = id;
  c.queries.samples = std::move(samples);
}

void EndQuery(Context& c, GLenum target) {
  if (target != GL_SAMPLES_PASSED) return set_error(c, GL_INVALID_ENUM, "target");
  if (!c.queries.active && !SOFTGL_FAULT(query_ends_any_time)) return set_error(c, GL_INVALID_OPERATION);
  c.queries.active = 0;
  if (!SOFTGL_FAULT(query_goes_on)) c.queries.samples.reset();
}

void GetQueryiv(Context& c, GLenum target, GLenum pname, GLint* params) {
  if (target != GL_SAMPLES_PASSED) return set_error(c, GL_INVALID_ENUM, "target");
  switch (pname) {
  case GL_CURRENT_QUERY: *params = SOFTGL_FAULT(query_untold) ? 0 : GLint(c.queries.active); return;
  case GL_QUERY_COUNTER_BITS: *params = kCounterBits; return;
  default: set_error(c, GL_INVALID_ENUM, "pname");
  }
}

void GetQueryObjectiv(Context& c, GLuint id, GLenum pname, GLint* params) {
  get_query_object(c, id, pname, params);
}
void GetQueryObjectuiv(Context& c, GLuint id, GLenum pname, GLuint* params) {
  get_query_object(c, id, pname, params);
}

} // namespace gl
} // namespace softgl
