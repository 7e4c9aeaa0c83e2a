// Where the files are that a model names: names written on Windows, with spaces, in another case, by absolute
// path.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>

namespace softgl::cli {

// The folder part of a path, "." if there is none.
std::string folder_of(const std::string& path);

// The files that one model may name: a model of unknown origin shall learn nothing of other folders.
class ModelFiles {
public:
  // Those in the folder of `model_path` and below, symbolic links followed; with `anywhere`, all others, too.
  // Devices, pipes and what the kernel writes (/proc, /sys) never.
  explicit ModelFiles(const std::string& model_path, bool anywhere = false);

  const std::string& folder() const { return folder_; }

  // The readable regular file that `name`, found in a file of `folder`, most probably means; empty if there
  // is none. Tried in order: the name as it stands, its last part beside the file, the same ignoring case.
  std::string find(const std::string& folder, std::string_view name, bool any_case = true) const;

  // `what` and the sentence for a file that find() does not find: the same whether there is none or it may
  // not be read.
  std::string not_found(const std::string& what) const;

private:
  bool may_read(const std::string& path) const;
  std::string ignoring_case(const std::string& folder, const std::string& file) const;
  using Listing = std::unordered_map<std::string, std::string>; // the name by the name in small letters
  const Listing& listing_of(const std::string& folder) const;

  std::string folder_;
  bool anywhere_;
  std::string root_; // the folder without symbolic links, and a slash; empty: there is none
  mutable std::map<std::string, Listing> listings_; // of folders that were read
};

} // namespace softgl::cli
