// MTL files: the materials a model names.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "common/source_text.h"
#include "common/warnings.h"
#include "obj/file_search.h"
#include "obj/material.h"
#include "obj/obj_reader.h"

namespace softgl::cli {

class MaterialLibrary {
public:
  // `strict`: a diffuse color of black stays black where there is a diffuse picture, whose alpha is no
  // opacity.
  explicit MaterialLibrary(bool strict = false) : strict_(strict), materials_(1) {}

  // Reads all libraries that the model names. Missing ones are warned of, never an error.
  void load_for(const ObjModel& model, const ModelFiles& files, RemarkList& model_remarks, Warnings& warnings,
                Warnings& notes);
  // Adds the materials of one library, which lies in `folder`. Of two materials with one name the later wins.
  void read(const SourceText& text, const ModelFiles& files, const std::string& folder, Warnings& warnings,
            Warnings& notes);

  // Number 0 is the default material, for faces without a known one.
  const std::vector<Material>& materials() const { return materials_; }
  std::vector<Material>& materials() { return materials_; }
  // 0 if there is no such material.
  uint32_t find(std::string_view name) const;
  // The libraries that load_for() found.
  const std::vector<std::string>& files() const { return files_; }

private:
  bool strict_;
  std::vector<Material> materials_;
  std::vector<std::string> files_;
  std::unordered_map<std::string, uint32_t> by_name_;
};

} // namespace softgl::cli
