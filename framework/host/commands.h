// The commands of the program. Each adds itself to the command line; what it does runs later, and
// returns an exit code.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace pathmark {

using CommandAction = std::function<int()>;

void addRenderCommand(CLI::App& app, CommandAction& action);
void addPreviewCommand(CLI::App& app, CommandAction& action);
void addDemoCommand(CLI::App& app, CommandAction& action);
void addCompareCommand(CLI::App& app, CommandAction& action);
void addStatusCommand(CLI::App& app, CommandAction& action);
void addContactSheetCommand(CLI::App& app, CommandAction& action);
void addExportCommand(CLI::App& app, CommandAction& action);
void addMeshCommand(CLI::App& app, CommandAction& action);
void addReferenceCommand(CLI::App& app, CommandAction& action);
void addBenchCommand(CLI::App& app, CommandAction& action);
void addBuildCommand(CLI::App& app, CommandAction& action);

// Those of the grader, which defines this function: the host does not know the grader.
void addGraderCommands(CLI::App& app, CommandAction& action);

}  // namespace pathmark
