#include "commands/commands.h"

namespace pathmark {

void addGraderCommands(CLI::App& app, CommandAction& action) {
  addCheckCommand(app, action);
#ifdef PATHMARK_INSTRUCTOR
  addGradeCommand(app, action);
  addKitCommand(app, action);
  addStudyCommand(app, action);
#endif
}

}  // namespace pathmark
