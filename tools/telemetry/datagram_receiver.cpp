// SPDX-License-Identifier: MIT
#include "telemetry/datagram_receiver.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include "telemetry/lcm_format.hpp"

namespace fantail::telemetry {
namespace {

void signal_event(int descriptor) {
  const std::uint64_t one = 1;
  (void)!::write(descriptor, &one, sizeof one);
}

}  // namespace

DatagramReceiver::Descriptor::~Descriptor() {
  if (number >= 0) {
    ::close(number);
  }
}

DatagramReceiver::DatagramReceiver(const Url& url)
    : socket_{::socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)},
      end_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)},
      news_{::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)} {
  open(url);
  // Ctrl-C is for the thread that waits.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread{[this] { receive(); }};
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

DatagramReceiver::~DatagramReceiver() {
  signal_event(end_.number);
  thread_.join();
}

// At the address of the group, and not at every address: what goes to another group, or to this computer alone, is not
// for us.
void DatagramReceiver::open(const Url& url) const {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(url.port());
  (void)inet_pton(AF_INET, url.address().c_str(), &address.sin_addr);
  const ip_mreq group{.imr_multiaddr = address.sin_addr, .imr_interface = {.s_addr = htonl(INADDR_ANY)}};
  constexpr int on = 1;
  const int size = url.receive_buffer_bytes().value_or(0);
  const auto set = [this](int level, int option, const auto& value) {
    return ::setsockopt(socket_.number, level, option, &value, sizeof value) == 0;
  };
  // More than one program may listen.
  if (socket_.number < 0 || end_.number < 0 || news_.number < 0 || !set(SOL_SOCKET, SO_REUSEADDR, on) ||
      (size > 0 && !set(SOL_SOCKET, SO_RCVBUF, size)) ||
      ::bind(socket_.number, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      !set(IPPROTO_IP, IP_ADD_MEMBERSHIP, group)) {
    throw TelemetryError{url.text() + ": cannot receive there: " + std::strerror(errno)};
  }
}

void DatagramReceiver::receive() {
  std::array<std::byte, longest_datagram + 1> datagram{};
  std::array<pollfd, 2> both{
      {{.fd = socket_.number, .events = POLLIN, .revents = 0}, {.fd = end_.number, .events = POLLIN, .revents = 0}}};
  while (both[1].revents == 0) {
    if (::poll(both.data(), both.size(), -1) <= 0) {
      continue;
    }
    const ssize_t size = ::recv(socket_.number, datagram.data(), datagram.size(), 0);  // one that is longer is cut
    if (size > 0) {
      keep(std::span{datagram}.first(static_cast<std::size_t>(size)));
    }
  }
}

void DatagramReceiver::keep(std::span<const std::byte> datagram) {
  const auto message = read_datagram(datagram);
  if (!message || !message->channel.starts_with(channel_prefix)) {
    return;
  }
  const std::scoped_lock lock{mutex_};
  if (messages_.size() < most_waiting) {
    messages_.push_back({std::string{message->channel}, {message->bytes.begin(), message->bytes.end()}});
    signal_event(news_.number);
  }
}

void DatagramReceiver::wait(std::chrono::milliseconds at_most) const {
  pollfd news{.fd = news_.number, .events = POLLIN, .revents = 0};
  (void)::poll(&news, 1, static_cast<int>(at_most.count()));
}

void DatagramReceiver::hand_over(
    const std::function<void(std::string_view channel, std::span<const std::byte> bytes)>& take) {
  std::vector<Message> messages;
  {
    const std::scoped_lock lock{mutex_};
    std::uint64_t count = 0;
    (void)!::read(news_.number, &count, sizeof count);
    messages = std::exchange(messages_, {});
  }
  for (const Message& message : messages) {
    take(message.channel, message.bytes);
  }
}

}  // namespace fantail::telemetry
