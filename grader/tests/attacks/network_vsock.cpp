// Attack: talks to the machine that runs this one
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <sys/socket.h>
static void attack() { socket(AF_VSOCK, SOCK_STREAM, 0); }
