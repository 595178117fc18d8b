// SPDX-License-Identifier: MIT
// Any bytes as packets of LCM, as an LCM log, as an address, or as what a browser asks of a live page: what is shown is
// text, and the next one is answered. Nothing else may happen.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "chosen_input.hpp"
#include "json/value.hpp"
#include "live/server.hpp"
#include "telemetry/lcm_format.hpp"
#include "telemetry/panel.hpp"
#include "telemetry/url.hpp"

namespace fantail::fuzz {
namespace {

using telemetry::Receiver;

void take(Receiver& receiver, std::string_view channel, std::span<const std::byte> bytes, hal::Microseconds now) {
  require(channel.size() <= 63 && bytes.size() <= telemetry::longest_datagram);
  if (channel.starts_with(telemetry::channel_prefix)) {
    receiver.take(channel, bytes, now);
  }
}

void show(Receiver& receiver, hal::Microseconds now) {
  telemetry::Panel panel{"udpm://", receiver};
  panel.look(now);
  require(json::parse(panel.json()).is_object());
  require(!panel.table().empty() && !panel.lines().empty());
  require(receiver.take_events().empty());
}

// Each packet is a byte with the time before it, two with its length, and itself.
void packets(std::string_view bytes) {
  Receiver receiver;
  hal::Microseconds now{};
  while (bytes.size() > 3) {
    now += hal::Microseconds{10'000 * static_cast<unsigned char>(bytes[0])};
    const auto length =
        static_cast<std::size_t>(static_cast<unsigned char>(bytes[1]) * 256 + static_cast<unsigned char>(bytes[2]));
    const std::string_view packet = bytes.substr(3, length);
    if (const auto message = telemetry::read_datagram(std::as_bytes(std::span{packet}))) {
      take(receiver, message->channel, message->bytes, now);
    }
    bytes.remove_prefix(3 + packet.size());
  }
  show(receiver, now);
}

void log(std::string_view bytes) {
  telemetry::LcmLog log{[&bytes](std::span<char> to) {
    const std::size_t count = std::min(to.size(), bytes.size());
    std::copy_n(bytes.begin(), count, to.begin());
    bytes.remove_prefix(count);
    return count;
  }};
  Receiver receiver;
  while (const auto event = log.next()) {
    take(receiver, event->channel, event->bytes, {});
  }
  show(receiver, {});
}

void address(const std::string& text) {
  if (telemetry::objection_to_url(text).empty()) {
    const telemetry::Url url{text};
    require(url.is_file() ? url.speed() >= 0.0 : url.port() > 0);
  }
  if (live::objection_to_address(text).empty()) {
    const live::Address read = live::address_of(text);
    require(!read.host.empty() && read.port >= 0 && read.port <= 65'535);
  }
  require(!live::may_ask({.host = "127.0.0.1", .port = 8080}, text, "x") || text.find("8080") != std::string::npos);
}

/// What a browser that sends this, and then no more, is answered.
std::string answer(const live::Server& server, std::string_view question) {
  const int browser = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const timeval patience{.tv_sec = 8, .tv_usec = 0};
  const linger at_once{.l_onoff = 1, .l_linger = 0};  // no port waits behind it
  ::setsockopt(browser, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setsockopt(browser, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(server.address().port));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  require(::connect(browser, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0);
  (void)::send(browser, question.data(), question.size(), MSG_NOSIGNAL);
  ::shutdown(browser, SHUT_WR);
  std::string first(64, '\0');
  const ssize_t size = ::recv(browser, first.data(), first.size(), 0);
  first.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  ::close(browser);
  return first;
}

void question(std::string_view bytes) {
  static const live::Server server{
      {.port = 0}, {.html = "<p>x</p>", .about = "x"}, [] { return std::string{"hello"}; }};
  const std::string said = answer(server, bytes);
  require(said.empty() || said.starts_with("HTTP/1."));
  static int asked = 0;
  if (++asked % 100 == 0) {
    const std::string host = "127.0.0.1:" + std::to_string(server.address().port);
    require(answer(server, "GET / HTTP/1.1\r\nHost: " + host + "\r\n\r\n").starts_with("HTTP/1.1 200"));
  }
}

// The first byte chooses what the rest is.
void read(std::uint8_t choice, const std::string& bytes) {
  switch (choice % 4) {
    case 0: packets(bytes); return;
    case 1: log(bytes); return;
    case 2: address(bytes); return;
    default: question(bytes);
  }
}

std::string message(const telemetry::Packet& packet) {
  std::string text{name(packet.channel)};
  text += '\0';
  for (const std::byte byte : packet.content()) {
    text += static_cast<char>(byte);
  }
  return text;
}

}  // namespace

std::vector<std::string> seeds() {
  using telemetry::Stamp;
  std::string network(1, '\0');
  std::string log(1, '\1');
  const std::array all{
      encode(Stamp{.run = 1}, telemetry::State{.roll_angle_rad = 1.0}), encode(Stamp{.run = 1}, telemetry::Canards{}),
      encode(Stamp{.run = 1}, telemetry::Event{.phase = telemetry::Event::PhaseChange{.phase = core::Phase::armed}}),
      encode(Stamp{.run = 1},
             telemetry::Health{.bus = telemetry::Health::Bus{}, .gateway = telemetry::Health::Gateway{}}),
      encode(Stamp{.run = 1, .sequence = 2}, telemetry::State{})};
  for (const telemetry::Packet& packet : all) {
    const std::string content = message(packet);
    const std::string datagram = "LC02" + std::string(4, '\0') + content;
    network += std::string{'\1', '\0', static_cast<char>(datagram.size())} + datagram;
    const std::size_t channel = name(packet.channel).size();
    log += "\xED\xA1\xDA\x01" + std::string(16, '\0') + std::string{'\0', '\0', '\0', static_cast<char>(channel)} +
           std::string{'\0', '\0', '\0', static_cast<char>(packet.size)} + content.substr(0, channel) +
           content.substr(channel + 1);
  }
  return {
      network,
      log,
      std::string{"\2udpm://239.255.76.67:7667?ttl=1&recv_buf_size=2000"},
      std::string{"\2file:///tmp/x?speed=2"},
      std::string{"\2[::1]:8080"},
      std::string{"\3GET / HTTP/1.1\r\nHost: 127.0.0.1:8080\r\nRange: bytes=0-1\r\nContent-Length: 3\r\n\r\nabc"},
      std::string{"\3GET /events HTTP/1.1\r\nHost: localhost\r\nConnection: keep-alive\r\n\r\n"},
      std::string{"\3POST /?a=%20b HTTP/1.1\r\nHost: x\r\nTransfer-Encoding: chunked\r\n\r\n3\r\nabc\r\n0\r\n\r\n"}};
}

}  // namespace fantail::fuzz

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fantail::fuzz::read_chosen(data, size, fantail::fuzz::read);
}
