// Attack: removes a file of the instructor's
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() { unlink("@SECRET_FILE@"); }
