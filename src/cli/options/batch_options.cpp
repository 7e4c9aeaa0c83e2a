#include "options/batch_options.h"

#include "options/option_kinds.h"

namespace softgl::cli {
namespace {

constexpr const char* kBatchNotes =
    "A line of a list is MODEL, OPTIONS and OUTPUT with tabs between them, or {\"model\": \"a.obj\", "
    "\"options\": \"--view top\", \"output\": \"a.png\"}. Options may be missing, and the output, too, where "
    "-o "
    "names it. Options of the command line are for all jobs; those of the line come after them. Lines that "
    "begin with # are left out. Names are meant from the folder where softgl runs.\n\n"
    "Each job is drawn by one of --threads processes. One that crashes, or needs more than --timeout or "
    "--max-memory allows, fails alone; one that is killed (SIGKILL, as where memory ends) is drawn once more "
    "at the end, alone. Each job that ends makes a JSON line: job, where (its line), model, "
    "output, exit_code, milliseconds, peak_memory (bytes), warnings, pixels (a hash of the picture), written "
    "(a "
    "hash of the file's size and time), error.\n\n"
    "--shard I/N: jobs weigh their model's bytes and 1 MiB. Sorted by weight, those of one weight by a hash "
    "of "
    "their output's name, each goes to the shard that weighs least so far. So the order of the list does not "
    "matter. All machines must see the same files.\n\n"
    "--resume with --report: a picture is there if a line of the report says that this very file was drawn "
    "with "
    "exit code 0 by the same softgl, with the same options, from a model of the same name, size and time. "
    "With "
    "{shard} in the report's name, the reports of all shards count. Without --report: a picture is there if "
    "it "
    "is not older than its model. Material files and textures do not count. A file that is there is whole: "
    "it "
    "gets its name when it is complete. What a killed run left unfinished is removed.\n\n"
    "SIGTERM, SIGINT and SIGHUP: no job is begun, those at work have 10 s to end (none after a second "
    "signal), "
    "and the exit code is 128 and the signal, 143 for SIGTERM.\n\n"
    "Exit codes: 0 all done, 2 wrong usage (also two jobs with one output: nothing is drawn), else that of "
    "the "
    "first job of the list that failed: 3 or 4 as softgl, 128 and a signal for a process that was killed.";

} // namespace

CLI::App* add_batch(CLI::App& app, ProgramOptions& options) {
  CLI::App& batch = *app.add_subcommand(
      "batch", "draw a list of models, in parts on many machines, or what is missing; takes the "
               "options of a picture");
  batch
      .add_option("list", options.models,
                  "list of jobs, - for one from standard input; or models and folders of them, with -o "
                  "'{model}.png'")
      ->type_name("LIST");
  add_parsed(
      batch, "--shard", "I/N",
      "draw part I of N, the first being 1; slurm: that of the Slurm array's task; kubernetes/N: that of "
      "an indexed Job's pod",
      [&options](const std::string& text) { options.batch.shard = parse_shard(text); });
  batch.add_flag("--resume", options.batch.resume, "draw only what is missing, see below");
  batch
      .add_option("--report", options.batch.report,
                  "add the JSON lines to this file; {shard} in its name stands for I-of-N [standard output]")
      ->type_name("FILE");
  add_footer(batch,
             {"softgl batch parts/ -o 'thumbs/{model}.png' --size 256x256 --resume",
              "softgl batch jobs.tsv --shard slurm --resume --report 'log/{shard}.jsonl'",
              "softgl batch - --shard 2/8 --threads 1 --timeout 60 < jobs.jsonl"},
             kBatchNotes);
  batch.fallthrough();
  return &batch;
}

std::string complete_batch(const ProgramOptions& options) {
  if (options.models.empty()) return "no list of jobs given";
  if (options.stats) return "--stats: what each job took stands in its JSON line";
  if (options.skip_existing) return "--skip-existing: in a batch this is --resume";
  if (options.sheet_columns) return "--sheet: jobs have no pictures in common";
  if (options.output == "-") return "the pictures of a batch are files";
  if (options.batch.report == "-") return "--report names a file; without it lines go to standard output";
  return {};
}

} // namespace softgl::cli
