// Attack: becomes another program
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <unistd.h>
static void attack() { execl("/bin/sh", "sh", "-c", "echo all passed", nullptr); }
