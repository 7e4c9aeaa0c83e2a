// A model that is read, framed and triangulated: all that its pictures need.
#pragma once

#include "command/model_loader.h"
#include "command/report.h"
#include "options/program_options.h"

namespace softgl::cli {

struct PreparedModel {
  std::string name;
  ModelReport report; // the area only with --verbose
  Mesh mesh;
  std::vector<Material> materials;
  std::vector<std::string> files; // what was read: the model and its material libraries
  ModelFrame frame;
  UpAxis up = UpAxis::kPlusY; // that of the command line, or what the model shows
};

// The first step: all files of the model are read.
struct ReadModel {
  SourceText text;
  RemarkList remarks;
  LoadedModel loaded;
  std::string path;
};

ReadModel read_model(const std::string& path, const ProgramOptions& options, unsigned threads,
                     Warnings& warnings, Warnings& notes);

// The second: the mesh, in the frame of a model with these bounds; without edges, and without looking for the
// axis that points up. Takes what it needs of the model.
PreparedModel prepare_model(ReadModel& read, const ModelBounds& bounds, const ProgramOptions& options,
                            Warnings& warnings);

// Both, and the rest. Reads the file with the command line's choice of normals and materials. Adds to the
// times of reading and preparing. Throws ProgramError.
PreparedModel prepare_model(const std::string& path, const ProgramOptions& options, unsigned threads,
                            Warnings& warnings, Warnings& notes, RunTimes& times);

// Where the program that wrote a model may be named, see exporter_evidence(). STL files say nothing but that.
std::string_view first_lines(const SourceText& text, std::string_view format);

// The steps of it that depend on the command line: the colors, and the options of the mesh.
void paint_over(const MaterialOptions& chosen, LoadedModel& loaded);
MeshOptions mesh_options_for(const ProgramOptions& options, const ModelReport& report);

// The reflectances that the command line gives all materials.
void override_reflectances(const MaterialOptions& chosen, std::vector<Material>& materials);

void note_bounds(const ModelFrame& frame, ModelReport& report);

} // namespace softgl::cli
