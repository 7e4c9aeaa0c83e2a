// A model file and all it names, read and triangulated.
#pragma once

#include "command/report.h"
#include "obj/material_library.h"
#include "obj/obj_reader.h"
#include "options/run_limits.h"

namespace softgl::cli {

struct LoadedModel {
  ObjModel model; // triangles, see face_triangulation.h
  MaterialLibrary library;
  ModelReport report;           // without bounds and area
  GrowingArray<uint32_t> edges; // of the faces before they were cut, where asked for: see face_edges()
};

// Remarks about the model's own text stay in `remarks`, so that later steps can add theirs; those about
// libraries go to `warnings`. Throws ProgramError if nothing can be drawn.
LoadedModel load_model(const SourceText& text, unsigned threads, RemarkList& remarks, Warnings& warnings,
                       Warnings& notes, const LoadLimits& limits = {}, bool with_edges = false);

} // namespace softgl::cli
