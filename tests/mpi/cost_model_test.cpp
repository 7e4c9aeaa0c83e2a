// The model behind reference/farm/COST.md.
#include <catch2/catch.hpp>

#include "models/program_runner.h"
#include "test_paths.h"

using namespace softgl::test;

TEST_CASE("mpi: the tables of COST.md are those of the cost model", "[mpi]") {
  const std::string script = std::string(SOFTGL_TEST_SOURCE_DIR) + "/reference/farm/cost_model.py";
  const ProgramRun run = run_command({"python3", script, "--check"});
  INFO(run.output << run.errors);
  CHECK(run.exit_code == 0);
}
