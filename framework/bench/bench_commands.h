// The subcommands of bench. Each adds itself to the command line; what it does runs later.
#pragma once

#include "host/commands.h"

namespace pathmark::bench {

void addBenchRaysCommand(CLI::App& bench, CommandAction& action);
void addBenchRenderCommand(CLI::App& bench, CommandAction& action);
void addBenchErrorCommand(CLI::App& bench, CommandAction& action);
void addBenchCostCommand(CLI::App& bench, CommandAction& action);
void addBenchLightsCommand(CLI::App& bench, CommandAction& action);
void addBenchPreviewCommand(CLI::App& bench, CommandAction& action);
void addBenchSkipCommand(CLI::App& bench, CommandAction& action);
void addBenchStressCommand(CLI::App& bench, CommandAction& action);
void addBenchTargetsCommand(CLI::App& bench, CommandAction& action);

}  // namespace pathmark::bench
