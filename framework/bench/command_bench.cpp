// pathmark bench: how fast this machine is, in ratios that hold on others too.
#include "bench/bench_commands.h"
#include "host/session.h"

#include <CLI/CLI.hpp>

namespace pathmark {

void addBenchCommand(CLI::App& app, CommandAction& action) {
  CLI::App* bench =
      app.add_subcommand("bench", "Measure how fast rays and renders are, and how far they hold");
  bench->require_subcommand(0, 1);
  bench->callback([bench] {
    if (bench->get_subcommands().empty())
      throw UsageError(
          "bench is told what to measure: rays, render, error, cost, lights, preview, skip, "
          "stress or targets.");
  });
  bench::addBenchRaysCommand(*bench, action);
  bench::addBenchRenderCommand(*bench, action);
  bench::addBenchErrorCommand(*bench, action);
  bench::addBenchCostCommand(*bench, action);
  bench::addBenchLightsCommand(*bench, action);
  bench::addBenchPreviewCommand(*bench, action);
  bench::addBenchSkipCommand(*bench, action);
  bench::addBenchStressCommand(*bench, action);
  bench::addBenchTargetsCommand(*bench, action);
  bench->footer(
      "Examples:\n"
      "  ./pathmark bench rays\n"
      "  ./pathmark bench rays --large --json rays.json\n"
      "  ./pathmark bench render\n"
      "  ./pathmark bench render --peer cycles\n"
      "  ./pathmark bench error --html error.html\n"
      "  ./pathmark bench cost\n"
      "  ./pathmark bench lights\n"
      "  ./pathmark bench preview\n"
      "  ./pathmark bench skip cornell_box\n"
      "  ./pathmark bench stress --quick\n"
      "  ./pathmark bench targets --quick\n\n"
      "./pathmark bench COMMAND --help says more about each.");
}

}  // namespace pathmark
