// When a snapshot may be used again: a table with a row for each, which names its inputs and its maker.
#pragma once

#include <string>

#include "draw/draw_call.h"

namespace softgl {

struct Context;

/// Makes the snapshots of the context's cache anew whose inputs have changed since they were made.
void update_snapshots(Context& context, const DrawCall& call);

/// A snapshot that update_snapshots() would use again although a fresh one differs: a dirty bit is missing.
struct StaleSnapshot {
  const char* name = nullptr; // of its row; null: there is none
  std::string member;         // the first one that differs
};
/// Makes every snapshot and compares. Changes nothing that a draw could tell.
StaleSnapshot find_stale_snapshot(Context& context, const DrawCall& call);

} // namespace softgl
