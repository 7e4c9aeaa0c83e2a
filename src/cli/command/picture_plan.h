// Which pictures a run draws, and into which files they go.
#pragma once

#include <string>
#include <vector>

#include "options/program_options.h"

namespace softgl::cli {

struct PictureJob {
  size_t model = 0, view = 0, pass = 0, frame = 0;
  size_t output = 0, slot = 0; // the file, and the place in it
};

struct PlannedOutput {
  std::string path;
  size_t count = 0; // pictures in it: one, the frames of an animation, the cells of a sheet
};

struct PicturePlan {
  std::vector<std::string> models;
  std::vector<PictureJob> jobs; // by model, view, pass, frame
  std::vector<PlannedOutput> outputs;
};

// By the end of its name: OBJ, PLY or STL, which may be compressed.
bool is_model_name(const std::string& path);

// The models in a folder, by name; with `deep` those of the folders in it, too. Throws ProgramError
// (kCannotRead), also if there are none.
std::vector<std::string> models_in(const std::string& folder, bool deep);

// Folders become the OBJ, PLY and STL files in them, by name. With --skip-existing, without the pictures that
// are there. Throws ProgramError: kCannotRead for a folder without models, kUsageError if two pictures would
// have one name or the name asks for what there is not.
PicturePlan plan_pictures(const ProgramOptions& options);

// "folder/model.obj" is "model".
std::string stem_of(const std::string& path);

} // namespace softgl::cli
