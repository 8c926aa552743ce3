// Attack: talks to services of the machine
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/socket.h>
static void attack() { socket(AF_UNIX, SOCK_STREAM, 0); }
