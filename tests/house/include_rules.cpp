#include "house/include_rules.h"

#include <algorithm>
#include <functional>
#include <sstream>

namespace softgl::test {

const std::vector<std::string> kBack = {"src/geometry", "src/raster", "src/fragment", "src/texture",
                                        "src/surface",  "src/frame",  "src/base",     "src/draw"};

namespace {

using Graph = std::map<std::string, std::set<std::string>>; // an arrow from who includes to what is included

bool starts_with(const std::string& text, const std::string& beginning) {
  return text.rfind(beginning, 0) == 0;
}

bool is_below(const std::string& path, const std::string& folder) { return starts_with(path, folder + "/"); }

/// A folder and its generated/ are one room.
std::string room_of(const std::string& folder) {
  return folder.ends_with("/generated") ? folder_of(folder) : folder;
}

/// Only these have rules.
bool is_ruled(const std::string& path) { return starts_with(path, "src/") || starts_with(path, "shaders/"); }

std::vector<std::string> quoted_includes(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line[hash] != '#') continue;
    const size_t word = line.find_first_not_of(" \t", hash + 1);
    if (word == std::string::npos || line.compare(word, 7, "include") != 0) continue;
    const size_t begin = line.find('"', word), end = line.find('"', begin + 1);
    if (begin != std::string::npos && end != std::string::npos)
      names.push_back(line.substr(begin + 1, end - begin - 1));
  }
  return names;
}

/// The file that a compiler takes for #include "name", as CMakeLists.txt tells it where to look.
std::string resolve_include(const SourceTree& tree, const std::string& file, const std::string& name) {
  std::vector<std::string> folders = {folder_of(file), "include", "src", "."};
  if (is_below(file, "shaders")) folders = {folder_of(file), "."};
  if (is_below(file, "src/cli")) folders = {folder_of(file), "src/cli", "include", "reference"};
  for (const std::string& folder : folders)
    if (const std::string path = normal_path(folder + "/" + name); tree.count(path)) return path;
  return "";
}

/// The folders on the line "May include:", which goes on while it ends with a comma. They are named from
/// src, in shaders from the top, and below src/cli from there; include/GL and include/softgl are GL/ and
/// softgl/. Folders of reference, which see nothing of src, are named from the top.
struct MayInclude {
  bool said = false;
  std::set<std::string> folders;

  MayInclude(const SourceTree& tree, const std::string& folder) {
    const auto notes = tree.find(folder + "/NOTES.md");
    if (notes == tree.end()) return;
    const std::string& text = notes->second;
    const std::string word = "\nMay include: ";
    size_t at = text.find(word);
    if (at == std::string::npos) return;
    said = true;
    size_t end = text.find('\n', at += word.size());
    while (end != std::string::npos && text[end - 1] == ',') end = text.find('\n', end + 1);
    std::string line = text.substr(at, end - at);
    std::replace(line.begin(), line.end(), '\n', ' ');
    if (starts_with(line, "nothing")) return;
    const bool program = folder == "src/cli" || is_below(folder, "src/cli");
    for (std::string name : split(line, ",")) {
      name.erase(0, name.find_first_not_of(' '));
      if (!name.empty() && name.back() == '/') name.pop_back();
      if (program && (name == "GL" || name == "softgl"))
        folders.insert("include/" + name);
      else if (starts_with(name, "shaders") || starts_with(name, "reference/"))
        folders.insert(name);
      else
        folders.insert((program ? "src/cli/" : "src/") + name);
    }
  }

  /// In src, shaders/ means every folder of shaders.
  bool allows(const std::string& from, const std::string& to) const {
    return folders.count(to) ||
           (is_below(from, "src") && is_below(to, "shaders") && folders.count("shaders"));
  }
};

/// A sentence "... in this order, from the top: a, b, c." of a folder's NOTES.md: its folders, the highest
/// first. Two at one height are joined by "and".
std::vector<std::vector<std::string>> order_of(const std::string& notes) {
  std::vector<std::vector<std::string>> order;
  const std::string word = "from the top: ";
  const size_t at = notes.find(word);
  if (at == std::string::npos) return order;
  std::string sentence = notes.substr(at + word.size(), notes.find('.', at) - at - word.size());
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  for (const std::string& height : split(sentence, ", ")) order.push_back(split(height, " and "));
  return order;
}

/// The folder directly below `top` that holds the folder; "shaders" stands beside src.
std::string child_of(const std::string& top, const std::string& folder) {
  if (top == "src" && (folder == "shaders" || is_below(folder, "shaders"))) return "shaders";
  if (!is_below(folder, top)) return "";
  const size_t begin = top.size() + 1;
  return folder.substr(begin, folder.find('/', begin) - begin);
}

class Inspector {
public:
  explicit Inspector(const SourceTree& tree) : tree_(tree) {}

  std::vector<std::string> inspect() {
    for (const auto& [path, text] : tree_)
      if (is_ruled(path) && is_source(path)) inspect_file(path, text);
    inspect_lines();
    inspect_orders();
    inspect_cycles();
    for (const auto& [path, text] : tree_)
      if (is_source(path) && std::count(kBack.begin(), kBack.end(), folder_of(path))) inspect_sight(path);
    return faults_;
  }

private:
  void report(const std::string& fault) { faults_.push_back(fault); }

  const MayInclude& may_include(const std::string& folder) {
    return lines_.try_emplace(folder, tree_, folder).first->second;
  }

  void connect(const std::string& from, const std::string& to) {
    if (room_of(from) != room_of(to)) rooms_[room_of(from)].insert(room_of(to));
  }

  void inspect_file(const std::string& path, const std::string& text) {
    const std::string folder = folder_of(path);
    const MayInclude& may = may_include(folder);
    for (const std::string& name : quoted_includes(text)) {
      const std::string included = resolve_include(tree_, path, name), to = folder_of(included);
      if (included.empty()) {
        report(path + " includes " + name + ", which is not there");
        continue;
      }
      files_[path].insert(included);
      if (included == "src/base/thread_pool.h" && folder != "src/base" && folder != "src/frame")
        report(path + " includes base/thread_pool.h");
      if (to == folder) continue;
      connect(folder, to);
      if (!may.allows(folder, to)) report(path + " includes " + included + ", and " + folder + " may not");
    }
  }

  /// What a line allows counts like what is included: two folders that may include each other soon do.
  void inspect_lines() {
    for (const auto& [folder, may] : lines_) {
      if (!may.said) report(folder + "/NOTES.md has no line \"May include:\"");
      for (const std::string& to : may.folders) {
        if (std::none_of(tree_.begin(), tree_.end(), [&](auto& file) { return is_below(file.first, to); }))
          report(folder + "/NOTES.md allows " + to + ", which is not there");
        connect(folder, to);
      }
    }
  }

  void inspect_orders() {
    int stated = 0;
    for (const auto& [path, text] : tree_) {
      const auto order = order_of(text);
      if (!is_ruled(path) || !path.ends_with("/NOTES.md") || order.empty()) continue;
      ++stated;
      const std::string top = folder_of(path);
      std::map<std::string, size_t> height;
      for (size_t i = 0; i < order.size(); ++i)
        for (const std::string& name : order[i]) height[name] = order.size() - i;
      for (const auto& [from, all] : rooms_)
        for (const std::string& to : all) {
          const std::string upper = child_of(top, from), lower = child_of(top, to);
          if (upper.empty() || lower.empty() || upper == lower) continue;
          if (!height.count(upper) || !height.count(lower))
            report(path + " gives " + (height.count(upper) ? lower : upper) + " no place");
          else if (height[upper] <= height[lower])
            report(from + " includes " + to + ", which does not stand below it");
        }
    }
    if (!stated || order_of(tree_.at("src/NOTES.md")).empty()) report("src/NOTES.md states no order");
  }

  void inspect_cycles() {
    std::map<std::string, int> visit; // 1: on the way, 2: done
    std::vector<std::string> way;
    const std::function<void(const std::string&)> go = [&](const std::string& folder) {
      visit[folder] = 1;
      way.push_back(folder);
      for (const std::string& to : rooms_[folder]) {
        if (visit[to] == 0)
          go(to);
        else if (visit[to] == 1) {
          std::string cycle;
          for (auto i = std::find(way.begin(), way.end(), to); i != way.end(); ++i) cycle += *i + " -> ";
          report("a cycle: " + cycle + to);
        }
      }
      way.pop_back();
      visit[folder] = 2;
    };
    const Graph graph = rooms_;
    for (const auto& [folder, all] : graph)
      if (visit[folder] == 0) go(folder);
  }

  /// Nothing that a file of the back includes, at however many removes, is in context/.
  void inspect_sight(const std::string& path) {
    std::map<std::string, std::string> reached = {{path, path}}; // with the way there
    std::vector<std::string> waiting = {path};
    while (!waiting.empty()) {
      const std::string file = waiting.back();
      waiting.pop_back();
      for (const std::string& next : files_[file])
        if (reached.emplace(next, reached[file] + " -> " + next).second) {
          waiting.push_back(next);
          if (is_below(next, "src/context")) report("the back sees a Context: " + reached[next]);
        }
    }
  }

  const SourceTree& tree_;
  Graph files_, rooms_;
  std::map<std::string, MayInclude> lines_;
  std::vector<std::string> faults_;
};

} // namespace

std::vector<std::string> include_faults(const SourceTree& tree) { return Inspector(tree).inspect(); }

} // namespace softgl::test
