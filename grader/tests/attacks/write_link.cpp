// Attack: makes a link to a file of the instructor's
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() { symlink("@SECRET_FILE@", "@OUTSIDE@/link"); }
