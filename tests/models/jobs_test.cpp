// softgl batch: lists of jobs, their parts, and what is drawn again.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <sstream>

#include "common/stable_hash.h"
#include "jobs/job_list.h"
#include "jobs/shard.h"
#include "models/picture_files.h"
#include "models/program_runner.h"

using namespace softgl::test;
using namespace softgl::cli;
using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string folder() { return output_folder("jobs"); }

std::string write(const std::string& name, const std::string& text) {
  return write_bytes(folder() + name, text);
}

std::string model(const std::string& name, int height = 1) { return write(name, pyramid(height)); }

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ProgramRun batch(std::vector<std::string> arguments, const std::string& input = {},
                 const std::vector<std::string>& environment = {}) {
  arguments.insert(arguments.begin(), {"batch", "--up", "+Y", "--size", "40x30"});
  return run_softgl(arguments, input, environment);
}

// By the name of the output, without the folder of this test.
std::map<std::string, Json> lines_of(const std::string& text) {
  std::map<std::string, Json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const Json object = Json::parse(line);
    const std::string output = object.at("output");
    lines[output.rfind(folder(), 0) == 0 ? output.substr(folder().size()) : output] = object;
  }
  return lines;
}

std::string alone(const std::string& file, std::vector<std::string> options) {
  options.insert(options.begin(), {file, "--up", "+Y", "-o", "-"});
  const ProgramRun run = run_softgl(options);
  REQUIRE(run.exit_code == 0);
  return run.output;
}

} // namespace

TEST_CASE("jobs: a list in lines of both kinds, and a line about each job", "[models][jobs]") {
  const std::string a = model("list/a.obj"), b = model("list/b.obj", 2), out = folder() + "list/";
  const std::string list = write(
      "list/jobs.tsv",
      "# model, options, output\n\n" + a + "\t--view front\t" + out + "deep/a.ppm\r\n{\"model\": \"" + b +
          "\", \"options\": [\"--size\", \"20x10\"], \"output\": \"" + out + "b.png\"}\n" + b + "\n");
  const ProgramRun run = batch({list, "-o", out + "{model}-2.ppm"});
  INFO(run.errors);
  CHECK(run.exit_code == 0);
  CHECK(has(run.errors, "softgl: 3 jobs: 3 drawn, 0 there already, 0 failed; "));
  CHECK(read_bytes(out + "deep/a.ppm") ==
        alone(a, {"--size", "40x30", "--view", "front", "--format", "ppm"}));
  CHECK(read_bytes(out + "b.png") == alone(b, {"--size", "20x10"}));
  CHECK(read_bytes(out + "b-2.ppm") == alone(b, {"--size", "40x30", "--format", "ppm"}));
  const auto lines = lines_of(run.output);
  REQUIRE(lines.size() == 3);
  const Json& first = lines.at("list/deep/a.ppm");
  CHECK(first.at("where") == list + ":3");
  CHECK(first.at("model") == a);
  CHECK(first.at("exit_code") == 0);
  CHECK(first.at("milliseconds") > 0);
  CHECK(first.at("peak_memory") > (1 << 20));
  CHECK(first.at("warnings") == 0);
  CHECK_FALSE(first.contains("error"));
  CHECK(first.at("pixels") != lines.at("list/{model}-2.ppm").at("pixels"));
  // The hash is that of the pixels, in any format: width, height, channels and bits, then the bytes.
  StableHash hash;
  for (const int number : {40, 30, 3, 8}) hash.add(uint64_t(number));
  const TestPicture picture = read_ppm(out + "deep/a.ppm");
  hash.add(picture.rgb.data(), picture.rgb.size());
  CHECK(first.at("pixels") == hash.text());
  CHECK(lines_of(batch({a, "--view", "front", "-o", out + "a.png"}).output).begin()->second.at("pixels") ==
        hash.text());
  // Several files of one job, and a list from standard input.
  const ProgramRun turn =
      batch({"-", "--turntable", "3", "-o", out + "{frame}-{view}.ppm"}, a + "\t--view front,top\n");
  CHECK(turn.exit_code == 0);
  CHECK(fs::exists(out + "003-top.ppm"));
  CHECK(turn.output.find('\n') == turn.output.size() - 1);
}

TEST_CASE("jobs: words of options as a shell cuts them", "[models][jobs]") {
  using Words = std::vector<std::string>;
  CHECK(split_words("") == Words{});
  CHECK(split_words("  --bg   '#fff'\t\"a b\"c ''") == Words{"--bg", "#fff", "a bc", ""});
  CHECK(split_words("a\\ b '\\' \"\\\"\"") == Words{"a b", "\\", "\""});
  CHECK_THROWS_AS(split_words("'a"), std::invalid_argument);
}

TEST_CASE("jobs: bad jobs fail alone, and the first of the list gives the exit code", "[models][jobs]") {
  const std::string good = model("bad/good.obj"), words = write("bad/words.obj", "Words, and no model.\n"),
                    out = folder() + "bad/";
  const std::string list =
      write("bad/jobs", good + "\t\t" + out + "1.png\n" + words + "\t\t" + out + "2.png\n" + good +
                            "\t--wrong\t" + out + "3.png\n" + out + "none.obj\t\t" + out + "4.png\n" + good +
                            "\n{\"model\": 3}\n{]\n" + good + "\t--threads 2\t" + out + "5.png\n" + good +
                            "\t\t-\n" + out + "\t\t" + out + "6.png\n" + good + "\tview\t" + out + "7.png\n" +
                            good + "\t'\t" + out + "8.png\na\tb\tc\td\n" + good + "\t\t/dev/null/9.png\n" +
                            good + "\t--help\t" + out + "10.png\n" + good + "\t\t" + out + "11.png\n");
  const ProgramRun run = batch({list, "--threads", "2"});
  CHECK(run.exit_code == 3); // that of line 2
  CHECK(has(run.errors, "16 jobs: 2 drawn, 0 there already, 14 failed"));
  std::map<std::string, std::pair<int, std::string>> codes; // by line
  std::istringstream stream(run.output);
  for (std::string text; std::getline(stream, text);) {
    const Json line = Json::parse(text);
    codes[line.at("where").get<std::string>().substr(list.size() + 1)] = {line.at("exit_code"),
                                                                          line.value("error", "")};
    if (line.contains("error")) CHECK(has(run.errors, line.at("error").get<std::string>()));
  }
  REQUIRE(codes.size() == 16);
  const std::vector<std::tuple<const char*, int, const char*>> expected = {
      {"1", 0, ""},
      {"2", 3, "words.obj: no geometry"},
      {"3", 2, "--wrong"},
      {"4", 3, "none.obj: cannot open"},
      {"5", 2, "no output file given"},
      {"6", 2, "\"model\" is a text"},
      {"7", 2, "no JSON object"},
      {"8", 2, "--threads is no option of a job"},
      {"9", 2, "is a file"},
      {"10", 2, "a job draws one model"},
      {"11", 2, "no options of a picture"},
      {"12", 2, "quotation mark"},
      {"13", 2, "MODEL, OPTIONS and OUTPUT"},
      {"14", 4, "cannot write"},
      {"15", 2, "no options of a picture"},
      {"16", 0, ""}};
  for (const auto& [line, code, sentence] : expected) {
    CAPTURE(line, codes[line].second);
    CHECK(codes[line].first == code);
    CHECK(has(codes[line].second, sentence));
  }
  CHECK(batch({out + "no-list"}).exit_code == 3);
  CHECK(batch({}).exit_code == 2);
  for (const char* refused : {"--stats=json", "--skip-existing", "--sheet=2", "-o-", "--report=-"})
    CHECK(batch({list, refused}).exit_code == 2);
}

TEST_CASE("jobs: two jobs of one picture are refused before drawing", "[models][jobs]") {
  const std::string a = model("twice/a.obj"), out = folder() + "twice/";
  const std::string list =
      write("twice/jobs", a + "\t\t" + out + "x.png\n\n" + a + "\t\t" + out + "b/../x.png\n");
  for (const char* shard : {"1/1", "2/2"}) { // in every shard
    const ProgramRun run = batch({list, "--shard", shard});
    CHECK(run.exit_code == 2);
    CHECK(has(run.errors, "x.png would be two pictures: " + list + ":1 and " + list + ":3"));
    CHECK(run.output.empty());
  }
  CHECK_FALSE(fs::exists(out + "x.png"));
}

TEST_CASE("jobs: shards are disjoint, complete, balanced and the same in any order", "[models][jobs]") {
  std::vector<JobWeight> jobs;
  uint64_t random = 1;
  for (int i = 0; i < 1000; ++i) {
    random = random * 6364136223846793005 + 1442695040888963407;
    jobs.push_back({"thumbs/" + std::to_string(i) + ".png", (random >> 40) << (random >> 62)});
  }
  std::vector<JobWeight> turned(jobs.rbegin(), jobs.rend());
  uint64_t heaviest = 0;
  for (const JobWeight& job : jobs) heaviest = std::max(heaviest, job.bytes + (1 << 20));
  for (const uint64_t count : {1, 2, 3, 7, 64}) {
    std::vector<int> times(jobs.size());
    std::vector<uint64_t> weights;
    for (uint64_t number = 1; number <= count; ++number) {
      const std::vector<size_t> mine = jobs_of_shard(jobs, {number, count});
      std::set<std::string> names, names_turned;
      uint64_t weight = 0, before = UINT64_MAX;
      for (const size_t job : mine) {
        ++times[job];
        weight += jobs[job].bytes + (1 << 20);
        CHECK(jobs[job].bytes <= before);
        before = jobs[job].bytes;
        names.insert(jobs[job].name);
      }
      weights.push_back(weight);
      for (const size_t job : jobs_of_shard(turned, {number, count})) names_turned.insert(turned[job].name);
      CHECK(names == names_turned);
    }
    CHECK(times == std::vector<int>(jobs.size(), 1));
    const auto [least, most] = std::minmax_element(weights.begin(), weights.end());
    CHECK(*most - *least <= heaviest);
  }
  // More shards than jobs.
  jobs.resize(5);
  size_t all = 0;
  for (uint64_t number = 1; number <= 9; ++number) {
    const size_t count = jobs_of_shard(jobs, {number, 9}).size();
    CHECK(count == (number <= 5 ? 1 : 0));
    all += count;
  }
  CHECK(all == 5);
  // These are what every machine and every later version must say.
  std::string cut;
  for (const size_t job : jobs_of_shard({{"a.png", 5}, {"b.png", 5}, {"c.png", 5}, {"d.png", 5}}, {1, 2}))
    cut += std::to_string(job);
  StableHash hash;
  hash.add("thumbs/1.png");
  CHECK(hash.text() == "36dc5b19b0fd2157");
  CHECK(cut == "31");
}

TEST_CASE("jobs: a shard by its number, and by what an array's task is told", "[models][jobs]") {
  const auto text_of = [](const std::string& text) {
    try {
      const Shard shard = parse_shard(text);
      return std::to_string(shard.number) + "/" + std::to_string(shard.count);
    } catch (const std::invalid_argument&) { return std::string("refused"); }
  };
  CHECK(text_of("3/10") == "3/10");
  for (const char* wrong : {"", "3", "0/3", "4/3", "3/0", "a/3", "-1/3", "1/99999999999", "1/2/3", "slurm/3"})
    CHECK(text_of(wrong) == "refused");
  const auto with = [&](const std::map<std::string, std::string>& variables, const std::string& text) {
    for (const auto& [name, value] : variables) ::setenv(name.c_str(), value.c_str(), 1);
    const std::string shard = text_of(text);
    for (const auto& variable : variables) ::unsetenv(variable.first.c_str());
    return shard;
  };
  using Variables = std::map<std::string, std::string>;
  const auto task = [](const char* id, const char* first, const char* step, const char* count) {
    return Variables{{"SLURM_ARRAY_TASK_ID", id},
                     {"SLURM_ARRAY_TASK_MIN", first},
                     {"SLURM_ARRAY_TASK_STEP", step},
                     {"SLURM_ARRAY_TASK_COUNT", count}};
  };
  CHECK(with(task("3", "1", "1", "10"), "slurm") == "3/10");
  CHECK(with(task("0", "0", "1", "4"), "slurm") == "1/4");
  CHECK(with(task("14", "10", "2", "5"), "slurm") == "3/5");
  CHECK(with(task("9", "1", "1", "3"), "slurm") == "refused"); // --array=1,4,9
  CHECK(with(task("15", "10", "2", "5"), "slurm") == "refused");
  CHECK(text_of("slurm") == "refused");
  CHECK(with({{"JOB_COMPLETION_INDEX", "0"}}, "kubernetes/4") == "1/4");
  CHECK(with({{"JOB_COMPLETION_INDEX", "4"}}, "kubernetes/4") == "refused");
  CHECK(text_of("kubernetes/4") == "refused");

  // The program draws each picture in one shard.
  std::string list;
  for (int i = 0; i < 7; ++i)
    list += model("shards/" + std::to_string(i) + ".obj", i) + "\t\t" + folder() + "shards/" +
            std::to_string(i) + ".png\n";
  std::multiset<std::string> drawn;
  for (const char* number : {"1/3", "2/3", "3/3"}) {
    const ProgramRun run = batch({"-", "--shard", number}, list);
    CHECK(run.exit_code == 0);
    CHECK(has(run.errors, std::string("jobs of shard ") + number));
    const auto lines = lines_of(run.output);
    CHECK(lines.size() >= 2);
    for (const auto& line : lines) drawn.insert(line.first);
  }
  CHECK(drawn.size() == 7);
  CHECK(std::set<std::string>(drawn.begin(), drawn.end()).size() == 7);
  const ProgramRun by_slurm =
      batch({"-", "--shard", "slurm"}, list,
            {"SLURM_ARRAY_TASK_ID=9", "SLURM_ARRAY_TASK_MIN=1", "SLURM_ARRAY_TASK_COUNT=9"});
  CHECK(by_slurm.exit_code == 0); // there are more shards than pictures
  CHECK(has(by_slurm.errors, "0 jobs of shard 9/9: 0 drawn"));
}

TEST_CASE("jobs: what is missing is drawn again, and what has changed", "[models][jobs]") {
  const std::string a = model("again/a.obj"), out = folder() + "again/";
  const std::string models = out, pattern = out + "{model}.png", report = out + "log/report.jsonl";
  for (const char* name : {"again/b.obj", "again/c.obj"}) model(name);
  // The names of what was drawn. Without a report the JSON lines say it.
  const auto drawn = [&](std::vector<std::string> options) {
    options.insert(options.end(), {models, "--resume"});
    if (std::find(options.begin(), options.end(), "-o") == options.end())
      options.insert(options.end(), {"-o", pattern});
    const size_t size = fs::exists(report) ? fs::file_size(report) : 0;
    const ProgramRun run = batch(options);
    INFO(run.errors);
    CHECK(run.exit_code == 0);
    std::string names, lines = run.output;
    if (fs::exists(report)) lines += read_bytes(report).substr(size);
    std::istringstream stream(lines);
    std::set<std::string> sorted;
    for (std::string line; std::getline(stream, line);)
      if (!line.empty())
        sorted.insert(fs::path(Json::parse(line).at("model").get<std::string>()).stem().string());
    for (const std::string& name : sorted) names += name;
    return names;
  };
  const auto touch = [](const std::string& file, int seconds) {
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(seconds));
  };
  SECTION("without a report: what is older than its model") {
    CHECK(drawn({}) == "abc");
    CHECK(drawn({}) == "");
    fs::remove(out + "b.png");
    std::ofstream(out + "c.png").close(); // empty
    CHECK(drawn({}) == "bc");
    touch(out + "a.png", -1000);
    CHECK(drawn({}) == "a");
    CHECK(drawn({}) == "");
    CHECK(drawn({"--bg", "red"}) == ""); // nothing says with what it was drawn
  }
  SECTION("with a report: what another model, other options or someone else made") {
    const std::vector<std::string> with = {"--report", report};
    const auto more = [&](std::vector<std::string> options) {
      options.insert(options.end(), with.begin(), with.end());
      return options;
    };
    CHECK(drawn(with) == "abc");
    CHECK(drawn(with) == "");
    CHECK(drawn(more({"--threads", "1", "-v"})) == "");
    fs::remove(out + "b.png");
    CHECK(drawn(with) == "b");
    CHECK(drawn(more({"--bg", "red"})) == "abc");
    CHECK(drawn(with) == "abc"); // the lines of before are of other files
    CHECK(drawn(with) == "");
    // A clock that jumps: times are compared with themselves only.
    touch(a, -1000000);
    CHECK(drawn(with) == "a");
    touch(a, 900000000);
    CHECK(drawn(with) == "a");
    CHECK(drawn(with) == "");
    touch(out + "c.png", 5);
    CHECK(drawn(with) == "c");
    std::ofstream(out + "b.png") << "not a picture";
    CHECK(drawn(with) == "b");
    // A line that was cut, as by kill -9, and one that is no report's.
    std::string lines = read_bytes(report);
    lines.pop_back();
    std::ofstream(report, std::ios::binary) << "[]\n{\"exit_code\": \"0\"}\n"
                                            << lines.substr(0, lines.size() - 30);
    const ProgramRun run = batch({models, "-o", pattern, "--resume", "--report", report});
    CHECK(has(run.errors, "3 jobs: 1 drawn, 2 there already"));
    CHECK(drawn(with) == "");
  }
  SECTION("the reports of all shards count") {
    const auto run = [&](const char* shard) {
      return batch({models, "-o", pattern, "--resume", "--report", out + "{shard}.log", "--shard", shard})
          .errors;
    };
    for (const char* shard : {"1/2", "2/2"}) CHECK(has(run(shard), " 0 there already, 0 failed"));
    CHECK(fs::exists(out + "2-of-2.log"));
    for (const char* shard : {"1/3", "2/3", "3/3"}) CHECK(has(run(shard), ": 0 drawn, 1 there already"));
  }
}
