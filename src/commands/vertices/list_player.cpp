#include "commands/vertices/list_player.h"
#include "commands/vertices/run_playback.h"
#include "commands/vertices/vertex_stream.h"

#include <cstring>
#include <new>

#include "base/assert.h"
#include "commands/generated/list_playback.h"
#include "commands/vertices/attribute_doors.h"
#include "commands/vertices/list_commands.h"
#include "context/context.h"
#include "context/display_list.h"
#include "shaders/common/seeded_faults.h"

namespace softgl {
namespace {

void play_command_record(Context& c, uint16_t opcode, const void* arguments) {
  if (c.guard & kInsideBeginEnd) {
    if (!allowed_inside_begin_end(opcode)) return set_error(c, GL_INVALID_OPERATION);
  } else if (c.guard & kRunPending) {
    close_run(c);
  }
  try {
    play_command(c, opcode, arguments);
  } catch (const std::bad_alloc&) {
    set_error(c, GL_OUT_OF_MEMORY);
  } // the rest of the list is still executed
}

} // namespace

void play_list(Context& c, const DisplayList& list) {
  const uint64_t* at = list.records.data();
  const uint64_t* const end = at + list.records.size();
  RecordHeader header;
  for (; at != end; at += header.units) {
    std::memcpy(&header, at, sizeof header);
    const uint64_t* arguments = at + 1;
    SOFTGL_ASSERT(header.units >= 1 && header.units <= size_t(end - at));
    switch (header.opcode) {
    case kPlayRun:
      SOFTGL_ASSERT(*arguments < list.runs.size());
      play_run(c, list.runs[*arguments]);
      break;
    case kPlayAttribute: {
      AttributeRecord r;
      SOFTGL_ASSERT(header.units == 1 + sizeof r / 8);
      std::memcpy(&r, arguments, sizeof r);
      SOFTGL_ASSERT(r.slot < kAttributeSlots);
      if (SOFTGL_FAULT(list_color_lost) && r.slot == kColor) break;
      set_attribute4(c, int(r.slot), r.value[0], r.value[1], r.value[2], r.value[3]);
      break;
    }
    case kPlayEnd: gl::End(c); break;
    case kPlayError:
      set_error(c, (c.guard & kInsideBeginEnd) && !(*arguments >> 32) ? GL_INVALID_OPERATION
                                                                      : GLenum(*arguments));
      break;
    case kPlayCallList: call_list(c, GLuint(*arguments)); break;
    case kPlayCallLists: {
      const auto* offsets = reinterpret_cast<const GLuint*>(arguments + 1);
      SOFTGL_ASSERT(header.units >= 2 + (*arguments + 1) / 2);
      for (uint64_t i = 0; i < *arguments; ++i)
        call_list(c, (SOFTGL_FAULT(list_base_at_compile) ? 0 : c.state.list.base) + offsets[i]);
      break;
    }
    default: play_command_record(c, uint16_t(header.opcode), arguments);
    }
  }
}

} // namespace softgl
