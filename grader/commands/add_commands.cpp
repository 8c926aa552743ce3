#include "commands/commands.h"

namespace pathmark {

void addGraderCommands(CLI::App& app, CommandAction& action) {
  addCheckCommand(app, action);
#ifdef PATHMARK_STUDY
  addGradeCommand(app, action);
  addStudyCommand(app, action);
#endif
}

}  // namespace pathmark
