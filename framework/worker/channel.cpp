#include "worker/channel.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pathmark {

namespace {

// Reads exactly `size` bytes; takes a descriptor that comes along. False at the end of the wire.
bool receiveAll(std::byte* to, std::size_t size, int& descriptor) {
  while (size > 0) {
    iovec part{to, size};
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))];
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    const ssize_t got = recvmsg(kWorkerSocket, &message, MSG_CMSG_CLOEXEC);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    for (cmsghdr* c = CMSG_FIRSTHDR(&message); c; c = CMSG_NXTHDR(&message, c))
      if (c->cmsg_level == SOL_SOCKET && c->cmsg_type == SCM_RIGHTS)
        std::memcpy(&descriptor, CMSG_DATA(c), sizeof descriptor);
    to += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

void sendAll(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = send(kWorkerSocket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) _exit(EXIT_FAILURE);  // the host is gone, and nobody is left to work for
    bytes = bytes.subspan(static_cast<std::size_t>(sent));
  }
}

void sendMessage(MessageKind kind, std::uint32_t sequence, std::span<const std::byte> body) {
  MessageHeader header;
  header.kind = kind;
  header.sequence = sequence;
  header.length = body.size();
  sendAll(asBytes(header));
  sendAll(body);
}

}  // namespace

Message::~Message() {
  if (descriptor >= 0) close(descriptor);
}

std::optional<Message> receiveRequest() {
  Message message;
  if (!receiveAll(reinterpret_cast<std::byte*>(&message.header), sizeof message.header,
                  message.descriptor))
    return std::nullopt;
  message.body.resize(message.header.length);
  if (!receiveAll(message.body.data(), message.body.size(), message.descriptor))
    return std::nullopt;
  return message;
}

void sendHello() { sendMessage(MessageKind::kHello, 0, asBytes(Hello{})); }

// What coursework has printed goes before the answer: afterwards the host may end this process.
void sendReply(const Message& request, std::span<const std::byte> body) {
  std::cout.flush();
  std::fflush(nullptr);
  sendMessage(request.header.kind, request.header.sequence, body);
}

std::optional<SharedBlock> SharedBlock::map(int descriptor, std::size_t bytes, bool writable) {
  void* memory = mmap(nullptr, bytes, writable ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED,
                      descriptor, 0);
  if (memory == MAP_FAILED) return std::nullopt;
  return SharedBlock(static_cast<std::byte*>(memory), bytes);
}

SharedBlock::~SharedBlock() {
  if (data_) munmap(data_, size_);
}

const SharedBlock* FilmBlock::map(int descriptor, std::size_t bytes) {
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return nullptr;
  if (!block_ || status.st_dev != device_ || status.st_ino != node_ ||
      block_->bytes().size() != bytes) {
    block_.reset();
    block_ = SharedBlock::map(descriptor, bytes, true);
    device_ = status.st_dev;
    node_ = status.st_ino;
  }
  return block_ ? &*block_ : nullptr;
}

}  // namespace pathmark
