// SPDX-License-Identifier: MIT
#include "avionics/flight_region.hpp"

#include "board_rig.hpp"
#include "recorder_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

constexpr std::size_t sector = 4096;
constexpr std::size_t sectors = 12;  // of small_flash

struct Looked {
  FlashAccess access;
  FlightRegion region{access};
  explicit Looked(hal::Flash& flash) : access{flash} { run(); }
  void run() {
    for (int i = 0; i < 1000; ++i) {
      region.update({});
    }
  }
};

TEST(FlightRegion, TheNextFlightComesBehindTheLastSectorThatBeginsWithAnything) {
  hal::sim::Flash flash{small_flash};
  EXPECT_EQ(Looked{flash}.region.open(), 0U);
  region_of(flash)[0] = std::byte{0};
  region_of(flash)[5 * sector + 15] = std::byte{0x7F};  // the last byte that is looked at
  EXPECT_EQ(Looked{flash}.region.open(), 6U);
  EXPECT_EQ(Looked{flash}.region.free_bytes(), (sectors - 6) * sector);
  region_of(flash)[(sectors - 1) * sector] = std::byte{0};
  EXPECT_EQ(Looked{flash}.region.open(), std::nullopt);
  EXPECT_EQ(Looked{flash}.region.free_bytes(), 0U);
}

TEST(FlightRegion, WhoKnowsHowMuchIsInUseNeedNoLookAtEverySector) {
  hal::sim::Flash flash{small_flash};
  region_of(flash)[0] = region_of(flash)[sector] = std::byte{0};
  region_of(flash)[2 * sector + 100] = std::byte{0};  // appended since
  FlashAccess access{flash};
  FlightRegion region{access};
  EXPECT_EQ(region.used_sectors(), std::nullopt);
  region.look_from(2);
  int ticks = 0;
  for (; !region.finished(); ++ticks) {
    region.update({});
  }
  EXPECT_EQ(ticks, 1 + 4096 / 256);
  EXPECT_EQ(region.used_sectors(), 3U);
  EXPECT_EQ(region.open(), 3U);
}

TEST(FlightRegion, MoreInUseThanThereIsMeansThatItIsFull) {
  hal::sim::Flash flash{small_flash};
  FlashAccess access{flash};
  FlightRegion region{access};
  region.look_from(sectors + 5);
  EXPECT_TRUE(region.finished());
  EXPECT_EQ(region.open(), std::nullopt);
  EXPECT_EQ(region.free_bytes(), 0U);
}

TEST(FlightRegion, ASectorWithAnythingDeeperInIsSteppedOver) {
  for (std::uint32_t at = 16; at < sector; at += 17) {
    hal::sim::Flash flash{small_flash};
    region_of(flash)[0] = std::byte{0};
    region_of(flash)[sector + at] = std::byte{0xFE};
    EXPECT_EQ(Looked{flash}.region.open(), 2U);
  }
  hal::sim::Flash flash{small_flash};
  region_of(flash)[sector - 1] = std::byte{0};
  EXPECT_EQ(Looked{flash}.region.open(), 1U) << "also the first sector";
}

TEST(FlightRegion, GivesBackWhatIsStored) {
  hal::sim::Flash flash{small_flash};
  Looked rig{flash};
  ASSERT_TRUE(rig.region.open().has_value());
  const Bytes bytes(200, std::byte{0x5A});
  ASSERT_EQ(rig.region.append({}, bytes), Access::done);
  EXPECT_EQ(rig.region.used_bytes(), sector);
  Bytes read(100);
  EXPECT_EQ(rig.region.read({}, 50, read), Access::done);
  EXPECT_EQ(read, Bytes(100, std::byte{0x5A}));
  EXPECT_EQ(rig.region.read({}, sectors * sector - 99, read), Access::failed);
  Bytes too_many(FlashAccess::read_size + 1);
  EXPECT_EQ(rig.region.read({}, 0, too_many), Access::failed);
}

TEST(FlightRegion, AnEraseGivesAllRoomBackAndGoesFromTheLastSectorDown) {
  hal::sim::Flash flash{small_flash};
  std::ranges::fill(region_of(flash).first(7 * sector), std::byte{0});
  Looked rig{flash};
  ASSERT_TRUE(rig.region.begin_erase());
  EXPECT_TRUE(rig.region.erasing());
  EXPECT_EQ(rig.region.open(), std::nullopt);
  for (std::uint32_t left = 7; left > 0; --left) {
    rig.region.update({});
    EXPECT_EQ(region_of(flash)[(left - 1) * sector], std::byte{0xFF});
    EXPECT_TRUE(left == 1 || region_of(flash)[(left - 2) * sector] == std::byte{0});
  }
  rig.run();
  EXPECT_FALSE(rig.region.erasing());
  EXPECT_EQ(rig.region.free_bytes(), sectors * sector);
  EXPECT_EQ(rig.region.open(), 0U);
}

// Three flights are erased; the power goes in the middle of each sector in turn.
TEST(FlightRegion, AnEraseThatWasCutOffLeavesWholeFlightsAndAPlaceForTheNext) {
  hal::sim::Flash flown{{.size = 1U << 18U, .sector_size = sector, .page_size = 256}};
  for (std::uint32_t seed = 1; seed <= 3; ++seed) {
    RecorderRig rig{flown, seed};
    rig.run(core::Phase::armed, 60);
    rig.run(core::Phase::launched, 150);
    rig.tick(core::Phase::armed);
    rig.settle(core::Phase::armed);
  }
  const std::vector<Record> written = records_in(region_of(flown));
  const std::uint32_t used = Looked{flown}.region.used_bytes() / sector;
  ASSERT_GE(used, 12U);
  std::size_t cuts = 0;
  for (std::uint32_t left = used; left > 0; --left) {
    for (std::uint64_t seed = 0; seed < 40; ++seed, ++cuts) {
      hal::sim::Flash flash{flown.geometry()};
      std::ranges::copy(flown.cells(), flash.cells().begin());
      const auto region = region_of(flash);
      std::ranges::fill(region.subspan(std::size_t{left} * sector), std::byte{0xFF});
      hal::sim::tear_erase(region.subspan((left - 1) * sector, sector), seed);
      std::size_t kept = 0;
      for (const Record& record : records_in(region)) {
        EXPECT_TRUE(std::ranges::equal(region.subspan(record.begin, record.end - record.begin),
                                       region_of(flown).subspan(record.begin, record.end - record.begin)));
        kept += record.end <= (left - 1) * sector ? 1 : 0;
      }
      const auto whole = std::ranges::count_if(written, [&](const Record& r) { return r.end <= (left - 1) * sector; });
      EXPECT_EQ(kept, static_cast<std::size_t>(whole));
      const auto next = Looked{flash}.region.open();
      ASSERT_TRUE(next.has_value());
      const auto place = region.subspan(std::size_t{*next} * sector);
      EXPECT_TRUE(std::ranges::all_of(place, [](std::byte b) { return b == std::byte{0xFF}; }));
      RecorderRig again{flash, 9};
      again.run(core::Phase::armed, 60);
      again.run(core::Phase::launched, 50);
      again.tick(core::Phase::armed);
      again.settle(core::Phase::armed);
      protocol::LogFrameReader reader{place};
      std::size_t records = 0;
      while (reader.next()) {
        records += 1;
      }
      EXPECT_EQ(reader.foreign_bytes(), 0U);
      EXPECT_GT(records, 110U);
    }
  }
  std::cout << cuts << " erases cut off\n";
}

// Through the bus, as a bench asks for it.
void ask_for_erase(BoardRig& rig) {
  rig.pc.send(
      encode(protocol::LogRequest{.action = protocol::LogAction::erase, .tag = 1, .offset = rig.pc.session}, 0));
  rig.tick();
}

TEST(FlightRegion, AnEraseThatIsAskedForOutsideOfABenchSessionIsNotDone) {
  for (const bool in_session : {false, true}) {
    BoardRig rig;
    region_of(rig.flash)[3 * sector] = std::byte{0};
    rig.power_cycle();
    rig.run(3 * second);
    if (in_session) {
      rig.open_session();
    }
    ask_for_erase(rig);
    rig.run(second);
    EXPECT_EQ(region_of(rig.flash)[3 * sector], in_session ? std::byte{0xFF} : std::byte{0});
  }
}

TEST(FlightRegion, WhileTheFlightsAreErasedARocketIsNotArmed) {
  BoardRig rig;
  rig.make_ready();
  rig.open_session();
  rig.flash.set_stays_busy(true);
  ask_for_erase(rig);
  rig.pc.say(protocol::ArmAction::begin);
  rig.tick();
  EXPECT_EQ(rig.pc.heard<protocol::ArmReply>()->nonce, std::nullopt);
  rig.flash.set_stays_busy(false);
  rig.pc.say(protocol::BenchSession{.action = protocol::SessionAction::close, .session = 7});
  rig.heartbeat.reset();
  rig.run(second / 2);
  rig.pc.say(protocol::ArmAction::begin);
  rig.tick();
  EXPECT_TRUE(rig.pc.heard<protocol::ArmReply>()->nonce.has_value()) << "when it has ended";
}

}  // namespace
}  // namespace fantail::avionics
