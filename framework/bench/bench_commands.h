// The subcommands of bench. Each adds itself to the command line; what it does runs later.
#pragma once

#include "host/commands.h"

namespace pathmark::bench {

void addRaysCommand(CLI::App& bench, CommandAction& action);

}  // namespace pathmark::bench
