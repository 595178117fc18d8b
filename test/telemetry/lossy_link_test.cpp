// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdio>
#include <memory>
#include <random>
#include <thread>

#include <lcm/lcm.h>

#include "linux/shell.hpp"
#include "seed.hpp"
#include "telemetry/messages.hpp"
#include "telemetry/multicast.hpp"

namespace fantail::test {
namespace {

using telemetry::Packet;
using telemetry::Stamp;
using telemetry::State;

const std::string url = "udpm://239.255.76.67:7668?ttl=0";

struct Destroy {
  void operator()(lcm_t* lcm) const { lcm_destroy(lcm); }
};

/// A sender whose state number N has a height of N metres.
class BadLink {
 public:
  BadLink() : lcm_{lcm_create(url.c_str())} {}

  void send(std::int64_t sequence) {
    const Packet packet =
        encode(Stamp{.run = 77, .sequence = sequence}, State{.height_m = static_cast<double>(sequence)});
    const std::string channel{name(packet.channel)};
    EXPECT_EQ(lcm_publish(lcm_.get(), channel.c_str(), packet.bytes.data(), static_cast<unsigned>(packet.size)), 0);
    std::this_thread::sleep_for(std::chrono::microseconds{200});
  }

 private:
  std::unique_ptr<lcm_t, Destroy> lcm_;
};

// Over real sockets, through the real program. What must come out is counted while it is drawn; the first and the last
// message come in order.
TEST(LossyLink, IsShownAsLinkQualityAndNeverAsWrongData) {
  follow_the_advice();
  std::mt19937 random{test::seed(11)};
  Watcher watcher{url};
  BadLink link;
  constexpr std::int64_t sent = 4'000;
  std::int64_t lost = 0;
  std::int64_t late = 0;
  std::int64_t duplicate = 0;
  for (std::int64_t number = 0; number < sent; ++number) {
    const auto fate = number == 0 || number >= sent - 2 ? 99 : random() % 100;
    if (fate < 10) {
      lost += 1;
    } else if (fate < 15) {
      link.send(number);
      link.send(number);
      duplicate += 1;
    } else if (fate < 25 && number + 1 < sent - 2) {  // its successor overtakes it
      link.send(number + 1);
      link.send(number);
      late += 1;
      number += 1;
    } else {
      link.send(number);
    }
  }
  const bool all_came = eventually([&] {
    const auto seen = watcher.seen();
    return !seen.empty() && seen.back()["state"]["height_m"] == static_cast<double>(sent - 1);
  });
  EXPECT_TRUE(all_came);
  const auto seen = watcher.seen();
  EXPECT_EQ(total(seen, "FANTAIL_STATE", "received"), sent - lost);
  EXPECT_EQ(total(seen, "FANTAIL_STATE", "lost"), lost);
  EXPECT_EQ(total(seen, "FANTAIL_STATE", "late"), late);
  EXPECT_EQ(total(seen, "FANTAIL_STATE", "duplicate"), duplicate);
  double before = -1.0;
  for (const auto& object : seen) {
    if (object["link"] != "silent") {
      const auto height_m = object["state"]["height_m"].number();
      EXPECT_EQ(height_m, object["state"]["sequence"].number());
      EXPECT_GE(height_m, before);
      before = height_m;
    }
  }
}

TEST(LossyLink, RubbishOnOurChannelsIsCountedAndTheWatchGoesOn) {
  follow_the_advice();
  Watcher watcher{url};
  const std::unique_ptr<lcm_t, Destroy> lcm{lcm_create(url.c_str())};
  const std::string rubbish(700, '\xff');
  for (unsigned size = 0; size < rubbish.size(); size += 7) {
    EXPECT_EQ(lcm_publish(lcm.get(), "FANTAIL_EVENT", rubbish.data(), size), 0);
  }
  EXPECT_TRUE(eventually([&] { return total(watcher.seen(), "FANTAIL_EVENT", "unreadable") == 100; }));
  BadLink link;
  std::int64_t sequence = 0;
  EXPECT_TRUE(eventually([&] {
    link.send(sequence++);
    return watcher.seen().back()["link"] == "live";
  }));
}

}  // namespace
}  // namespace fantail::test
