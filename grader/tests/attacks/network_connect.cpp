// Attack: sends to the network
// Verdict: forbidden call
#include <pathmark/coursework.h>

#include <netinet/in.h>
#include <sys/socket.h>
static void attack() {
  const int fd = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(80);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address);
}
