// SPDX-License-Identifier: MIT
#include "telemetry/publisher.hpp"

#include <filesystem>
#include <fstream>
#include <latch>

#include <fmt/core.h>
#include <unistd.h>

#include "telemetry/url.hpp"
#include "test.hpp"

namespace fantail::telemetry {
namespace {

Packet packet(std::int64_t sequence) { return encode(Stamp{.sequence = sequence}, State{}); }

std::int64_t sequence_of(const Packet& packet) {
  return decode(packet.channel, packet.content()).value().stamp.sequence;
}

struct Network {
  std::vector<std::int64_t> taken;
  std::latch entered{1};
  std::latch mended{1};
  bool hangs = false;
  bool fails = false;
  bool full = false;
};

class TestOutlet final : public Outlet {
 public:
  explicit TestOutlet(Network& network) : network_{network} {}
  bool put(const Packet& packet) override {
    if (network_.hangs) {
      network_.entered.count_down(network_.taken.empty() ? 1 : 0);
      network_.mended.wait();
    }
    network_.taken.push_back(sequence_of(packet));
    return !network_.fails;
  }
  bool close() override { return !network_.full; }
  [[nodiscard]] std::optional<int> most_per_second() const override { return std::nullopt; }

 private:
  Network& network_;
};

// A flight log or a table with the name that was meant for another folder.
TEST(Publisher, AFileThatIsNoLcmLogStaysAsItWas) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / fmt::format("fantail_{}.ftl", getpid());
  const auto content = [&file] {
    std::ifstream stream{file, std::ios::binary};
    return std::string{std::istreambuf_iterator<char>{stream}, {}};
  };
  std::ofstream{file} << "FTL, not LCM";
  const Url url{"file://" + file.string()};
  EXPECT_THROW((void)open_outlet(url), TelemetryError);
  EXPECT_EQ(content(), "FTL, not LCM");
  std::ofstream{file, std::ios::trunc}.flush();
  for (int i = 0; i < 2; ++i) {  // into an empty file, and over the log that this makes
    const auto outlet = open_outlet(url);
    EXPECT_TRUE(outlet->put(packet(1)));
    EXPECT_TRUE(outlet->close());
  }
  EXPECT_GT(content().size(), 20U);
  std::filesystem::remove(file);
}

TEST(Publisher, WhatIsSentGoesOutInOrder) {
  Network network;
  Publisher publisher{std::make_unique<TestOutlet>(network)};
  std::vector<std::int64_t> wanted;
  for (std::int64_t i = 0; i < 5'000; ++i) {
    publisher.send(packet(i));
    wanted.push_back(i);
  }
  const PublisherFigures figures = publisher.finish();
  EXPECT_EQ(figures.published, 5'000U);
  EXPECT_EQ(figures.dropped, 0U);
  EXPECT_EQ(network.taken, wanted);
}

// Would it wait for the network, this test would never end: nothing is mended before everything has been sent.
TEST(Publisher, ANetworkThatHangsHoldsNobodyUp) {
  Network network;
  network.hangs = true;
  Publisher publisher{std::make_unique<TestOutlet>(network), 100};
  publisher.send(packet(0));
  network.entered.wait();
  for (std::int64_t i = 1; i < 1'000; ++i) {
    publisher.send(packet(i));
  }
  // The one that hangs still has its place in the queue.
  EXPECT_EQ(publisher.figures().dropped, 900U);
  network.mended.count_down();
  const PublisherFigures figures = publisher.finish();
  EXPECT_EQ(figures.published, 100U);
  EXPECT_EQ(network.taken.back(), 99);
}

TEST(Publisher, WhatTheNetworkRefusesIsCounted) {
  Network network;
  network.fails = true;
  Publisher publisher{std::make_unique<TestOutlet>(network)};
  for (std::int64_t i = 0; i < 10; ++i) {
    publisher.send(packet(i));
  }
  const PublisherFigures figures = publisher.finish();
  EXPECT_EQ(figures.failed, 10U);
  EXPECT_EQ(figures.published, 0U);
}

TEST(Publisher, ADiskThatWasFullAtTheEndIsTold) {
  Network network;
  network.full = true;
  Publisher publisher{std::make_unique<TestOutlet>(network)};
  publisher.send(packet(0));
  EXPECT_FALSE(publisher.finish().complete);
}

}  // namespace
}  // namespace fantail::telemetry
