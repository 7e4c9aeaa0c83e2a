#include "command/compare.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "command/compare_report.h"
#include "command/report.h"
#include "common/elapsed_time.h"
#include "common/file_writer.h"
#include "common/parallel.h"
#include "common/program_error.h"
#include "image/image_writer.h"
#include "scene/sheet.h"

namespace softgl::cli {
namespace {

namespace fs = std::filesystem;

void write_text(const std::string& path, const std::string& text) {
  GrowingArray<uint8_t> bytes;
  bytes.append(reinterpret_cast<const uint8_t*>(text.data()), text.size());
  write_file(path, bytes);
}

void write_picture(const std::string& path, const Picture& picture) {
  const std::string format = image_format_of(path);
  write_file(path, encode_image(picture, format.empty() ? "png" : format, PngEffort::kDefault));
}

std::string size_of(const PictureSamples& picture) {
  return std::to_string(picture.width) + "x" + std::to_string(picture.height);
}

class Run {
public:
  explicit Run(const CompareOptions& options) : options_(options) {
    if (!options.mask.empty()) mask_ = read_picture(options.mask);
  }

  int run() {
    const auto start = Clock::now();
    const bool folders = fs::is_directory(options_.first);
    if (folders != fs::is_directory(options_.second))
      throw ProgramError(kUsageError, "a picture and a folder cannot be compared");
    if (folders)
      compare_folders();
    else
      results_.push_back(
          compare(options_.first, options_.second, options_.second, options_.difference, options_.sheet));
    if (!options_.junit.empty()) write_text(options_.junit, as_junit(results_));
    print(folders);
    if (options_.stats) print_stats(seconds_since(start));
    return code();
  }

private:
  PairResult compare(const std::string& first, const std::string& second, const std::string& name,
                     const std::string& difference, const std::string& sheet) const {
    const auto start = Clock::now();
    PairResult result;
    result.name = name;
    result.first = first;
    result.second = second;
    try {
      compare_files(result, difference, sheet);
    } catch (const ProgramError& error) {
      if (error.code != kCannotRead) throw;
      result.outcome = PairResult::kUnreadable;
      result.sentence = error.what();
    }
    result.seconds = seconds_since(start);
    return result;
  }

  void compare_files(PairResult& result, const std::string& difference, const std::string& sheet) const {
    auto start = Clock::now();
    const PictureSamples a = read_picture(result.first), b = read_picture(result.second);
    result.read_seconds = seconds_since(start);
    const auto refuse_size = [&](const PictureSamples& other, const char* what) {
      result.outcome = PairResult::kOtherSize;
      result.sentence = size_of(a) + " against " + size_of(other) + what;
    };
    if (a.width != b.width || a.height != b.height) return refuse_size(b, "");
    if (mask_.width && (a.width != mask_.width || a.height != mask_.height))
      return refuse_size(mask_, " of the mask");
    ComparisonRules rules;
    rules.tolerance = options_.tolerance;
    rules.ignore_edges = options_.ignore_edges;
    if (mask_.width) rules.mask = &mask_;
    start = Clock::now();
    Comparison& numbers = result.numbers = compare_pictures(a, b, rules);
    result.compare_seconds = seconds_since(start);
    start = Clock::now();
    result.width = a.width;
    result.height = a.height;
    result.outcome = is_same(numbers) ? PairResult::kSame : PairResult::kDifferent;
    const bool wanted = result.outcome == PairResult::kDifferent || !fs::is_directory(options_.first);
    if (wanted && !difference.empty()) write_picture(difference, draw_differences(a, numbers));
    if (wanted && !sheet.empty()) write_picture(sheet, compose(result, a, b));
    numbers.verdicts = {};
    result.write_seconds = seconds_since(start);
  }

  // The parts are summed up over threads, the total is of a clock.
  void print_stats(double total) const {
    double read = 0, compare = 0, write = 0;
    for (const PairResult& result : results_) {
      read += result.read_seconds;
      compare += result.compare_seconds;
      write += result.write_seconds;
    }
    print_text("{\n  \"pairs\": " + std::to_string(results_.size()) + ",\n" +
                   usage_as_json({{"read", read}, {"compare", compare}, {"write", write}, {"total", total}}) +
                   "\n}\n",
               stderr);
  }

  bool is_same(const Comparison& numbers) const {
    if (options_.least_similarity) return numbers.similarity >= *options_.least_similarity;
    const double most = options_.most_pixels_is_percentage
                            ? options_.most_pixels / 100 * double(numbers.compared)
                            : options_.most_pixels;
    return double(numbers.differing) <= most;
  }

  static Picture compose(const PairResult& result, const PictureSamples& a, const PictureSamples& b) {
    SheetRow row;
    row.entries.push_back({as_opaque_picture(a), result.first});
    row.entries.push_back({as_opaque_picture(b), result.second});
    row.entries.push_back({draw_differences(a, result.numbers), as_label(result)});
    std::vector<SheetRow> rows;
    rows.push_back(std::move(row));
    return compose_sheet("", rows);
  }

  static void list(const std::string& folder, std::set<std::string>& names) {
    std::error_code problem;
    for (fs::recursive_directory_iterator i(folder, problem), end; !problem && i != end; i.increment(problem))
      if (i->is_regular_file() && is_readable_picture(i->path().string()))
        names.insert(i->path().lexically_relative(folder).generic_string());
    if (problem) throw ProgramError(kCannotRead, folder + ": cannot read: " + problem.message());
  }

  void compare_folders() {
    std::set<std::string> all;
    list(options_.first, all);
    list(options_.second, all);
    if (all.empty())
      throw ProgramError(kCannotRead, options_.first + ", " + options_.second + ": no pictures to compare");
    const std::vector<std::string> names(all.begin(), all.end());
    const auto within = [](const std::string& folder, const std::string& name) {
      return folder.empty() ? folder : (fs::path(folder) / name).string();
    };
    const auto picture_within = [&](const std::string& folder, const std::string& name) {
      std::string path = within(folder, name);
      if (path.empty()) return path;
      std::error_code ignored; // writing the picture will say it
      fs::create_directories(fs::path(path).parent_path(), ignored);
      return image_format_of(path).empty() ? path + ".png" : path;
    };
    results_.resize(names.size());
    parallel_for(names.size(), options_.threads, [&](size_t i, unsigned) {
      const std::string first = within(options_.first, names[i]), second = within(options_.second, names[i]);
      for (const std::string& path : {first, second})
        if (!fs::exists(path)) {
          results_[i].name = names[i];
          results_[i].first = first;
          results_[i].second = second;
          results_[i].outcome = PairResult::kMissing;
          results_[i].sentence = path + " does not exist";
          return;
        }
      results_[i] = compare(first, second, names[i], picture_within(options_.difference, names[i]),
                            picture_within(options_.sheet, names[i]));
    });
  }

  void print(bool folders) const {
    std::string text;
    if (options_.json) {
      text = folders ? "[\n  " : "";
      for (const PairResult& result : results_)
        text += (&result == &results_.front() ? "" : ",\n  ") + as_json(result, folders ? "  " : "");
      text += folders ? "\n]\n" : "\n";
    } else if (!options_.quiet) {
      size_t same = 0;
      for (const PairResult& result : results_) {
        same += result.outcome == PairResult::kSame;
        if (!folders || result.outcome != PairResult::kSame) text += as_line(result);
      }
      if (folders)
        text += std::to_string(same) + " of " + std::to_string(results_.size()) + " are the same\n";
    }
    print_text(text, stdout);
  }

  int code() const {
    int worst = kSuccess;
    for (const PairResult& result : results_)
      worst = std::max<int>(worst, result.outcome == PairResult::kSame         ? kSuccess
                                   : result.outcome == PairResult::kUnreadable ? kCannotRead
                                                                               : kDiffers);
    return worst;
  }

  const CompareOptions& options_;
  PictureSamples mask_;
  std::vector<PairResult> results_;
};

} // namespace

int run_compare(const CompareOptions& options) { return Run(options).run(); }

} // namespace softgl::cli
