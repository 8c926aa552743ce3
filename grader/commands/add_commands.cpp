#include "commands/commands.h"

namespace pathmark {

void addGraderCommands(CLI::App& app, CommandAction& action) {
  addCheckCommand(app, action);
#ifdef PATHMARK_INSTRUCTOR
  addGalleryCommand(app, action);
  addGradeCommand(app, action);
  addKitCommand(app, action);
  addPairsCommand(app, action);
  addStudyCommand(app, action);
#endif
}

}  // namespace pathmark
