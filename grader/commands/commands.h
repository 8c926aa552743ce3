// The grader's commands.
#pragma once

#include "host/commands.h"

namespace pathmark {

void addCheckCommand(CLI::App& app, CommandAction& action);

// Only where the solutions are.
void addGalleryCommand(CLI::App& app, CommandAction& action);
void addGradeCommand(CLI::App& app, CommandAction& action);
void addKitCommand(CLI::App& app, CommandAction& action);
void addPairsCommand(CLI::App& app, CommandAction& action);
void addStudyCommand(CLI::App& app, CommandAction& action);

}  // namespace pathmark
