// SPDX-License-Identifier: MIT
#include <csignal>
#include <memory>
#include <string>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "linux/shell.hpp"
#include "telemetry/messages.hpp"
#include "telemetry/multicast.hpp"

namespace fantail::test {
namespace {

constexpr std::uint16_t port = 7669;
const std::string network = "udpm://239.255.76.67:7669?ttl=0";

std::string be(std::uint64_t value, int bytes) {
  std::string text;
  for (int i = bytes - 1; i >= 0; --i) {
    text += static_cast<char>(value >> static_cast<unsigned>(8 * i));
  }
  return text;
}

/// Somebody on the network who sends any packet.
class Stranger {
 public:
  Stranger() : socket_{::socket(AF_INET, SOCK_DGRAM, 0)} {
    to_.sin_family = AF_INET;
    to_.sin_port = htons(port);
    inet_pton(AF_INET, "239.255.76.67", &to_.sin_addr);
  }
  ~Stranger() { ::close(socket_); }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

  void send(const std::string& packet) const {
    EXPECT_EQ(::sendto(socket_, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to_), sizeof to_),
              static_cast<ssize_t>(packet.size()));
  }
  /// One of `count` pieces of an LCM message of `size` bytes.
  void send_fragment(std::uint32_t number, std::uint32_t size, std::uint32_t offset, std::uint16_t piece,
                     std::uint16_t count, const std::string& rest) const {
    send("LC03" + be(number, 4) + be(size, 4) + be(offset, 4) + be(piece, 2) + be(count, 2) + rest);
  }
  /// A message of Fantail in one packet.
  void send_state(std::int64_t sequence) const {
    const telemetry::Packet packet = encode(telemetry::Stamp{.run = 5, .sequence = sequence}, telemetry::State{});
    send("LC02" + be(1, 4) + "FANTAIL_STATE" + '\0' + as_text({packet.content().begin(), packet.content().end()}));
  }

 private:
  int socket_;
  sockaddr_in to_{};
};

// The second piece begins 100 bytes before the message: LCM 1.3.1 adds offset and size in 32 bits, finds 100, and
// copies.
TEST(Stranger, WithFragmentsThatLieDoesNotEndWatchNorWriteIntoIt) {
  follow_the_advice();
  Watcher watcher{network};
  const Stranger stranger;
  for (std::uint32_t number = 0; number < 100; ++number) {
    stranger.send_fragment(number, 1'000, 0, 0, 2, "FANTAIL_STATE" + std::string(1, '\0') + std::string(10, 'x'));
    stranger.send_fragment(number, 1'000, 0xFFFF'FFFFU - 99, 1, 2, std::string(200, 'y'));
  }
  // As long as a packet can be, and as short.
  stranger.send("LC02" + be(1, 4) + "FANTAIL_STATE" + '\0' + std::string(60'000, 'z'));
  for (const char* packet : {"", "L", "LC02", "LC03", "LC02\0\0\0\1no end of the channel"}) {
    stranger.send(packet);
  }
  std::int64_t sequence = 0;
  EXPECT_TRUE(eventually([&] {
    stranger.send_state(sequence++);
    return !watcher.seen().empty() && watcher.seen().back()["link"] == "live";
  })) << "watch hears nothing more";
  watcher.program().signal(SIGINT);
  const Outcome& outcome = watcher.program().outcome();
  EXPECT_EQ(outcome.exit_code, 0) << "signal " << outcome.signal << outcome.err;
  EXPECT_EQ(total(watcher.seen(), "FANTAIL_STATE", "unreadable"), 0);
}

// No program of ours listens but watch: what only sends has no port that a packet could come to.
TEST(Stranger, FindsNoPortOfAProgramThatOnlySends) {
  follow_the_advice();
  const Folder folder;
  const std::string flight = "udpm://239.255.76.67:7670?ttl=0";
  Program program{{"fly", "--out", folder / "out", "--lcm", flight}};
  Watcher watcher{flight};
  EXPECT_TRUE(eventually([&] { return watcher.seen().back()["link"] == "live"; }));
  // 7670 is 0x1DF6; the one that is open is watch's.
  const std::string open = content("/proc/net/udp");
  const std::size_t first = open.find(":1DF6 ");
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(open.find(":1DF6 ", first + 1), std::string::npos) << open;
  EXPECT_EQ(program.outcome().exit_code, 0);
}

}  // namespace
}  // namespace fantail::test
