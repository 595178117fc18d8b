// SPDX-License-Identifier: MIT
// The flight record over the bus: a flight of the simulator, downloaded by the bench's own code.
#include <cstdio>

#include "avionics/can_frame.hpp"
#include "input/scenario_file.hpp"
#include "link/log_download.hpp"
#include "random_stream.hpp"
#include "sil/bench_at_world.hpp"
#include "system/folder.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

using link::LogPart;
using link::LogReader;
using Bytes = std::vector<std::byte>;

constexpr std::uint32_t region_begin = 4 * 4096;

// As a flight lay in the flash when the power was cut early on.
const Bytes& flown() {
  static const Bytes bytes = [] {
    const sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
    sim::World world{scenario, sim::World::large_flash};
    for (int ticks = 1; !world.over() && (ticks % 500 != 0 || world.recorded().size() < 60'000); ++ticks) {
      (void)world.tick();
      world.advance();
    }
    return Bytes{world.recorded().begin(), world.recorded().end()};
  }();
  return bytes;
}

std::uint32_t in_sectors(std::size_t bytes) { return static_cast<std::uint32_t>((bytes + 4095) / 4096 * 4096); }

struct BenchLog : testing::Test {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  LogReader reader{place, link};
  test::Folder folder;
  const std::string path = folder / "record.part";

  std::uint32_t put(std::uint32_t at, std::span<const std::byte> bytes) {
    std::ranges::copy(bytes, place.flash.cells().begin() + region_begin + at);
    return at + in_sectors(bytes.size());
  }
  void SetUp() override {
    (void)put(0, flown());
    place.power_cycle();
  }
  std::uint32_t download(LogPart& part, std::uint32_t size) {
    return link::download(reader, {.offset = 0, .size = size}, part, [](std::uint32_t) {});
  }
  void expect_whole(const LogPart& part, std::uint32_t size) {
    ASSERT_EQ(part.size(), size);
    const auto cells = place.flash.cells().subspan(region_begin, size);
    EXPECT_TRUE(std::ranges::equal(part.read(0, size), cells));
  }
};

TEST_F(BenchLog, ArrivesByteForByteAsFastAsTheBusAllows) {
  ASSERT_GE(flown().size(), 60'000U);
  const link::LogInfo info = reader.info();
  EXPECT_EQ(info.used_bytes, in_sectors(flown().size()));
  EXPECT_EQ(info.free_bytes, (1U << 18U) - region_begin - info.used_bytes);
  LogPart part{path};
  const hal::Microseconds begin = place.now();
  EXPECT_EQ(download(part, info.used_bytes), 0U);
  const double seconds = 1e-6 * static_cast<double>((place.now() - begin).count());
  expect_whole(part, info.used_bytes);
  EXPECT_EQ(reader.repeated(), 0U);
  // Five frames of seven bytes a millisecond, and a few milliseconds for each request.
  EXPECT_GT(info.used_bytes / seconds, 28'000.0);
  std::printf("%u bytes in %.2f s of the rocket's time: %.1f kB/s\n", info.used_bytes, seconds,
              1e-3 * info.used_bytes / seconds);
  const Bytes all = part.read(0, info.used_bytes);
  const auto flights = link::split_flights(all);
  ASSERT_EQ(flights.size(), 1U);
  EXPECT_TRUE(flights[0].intact());
  EXPECT_TRUE(std::ranges::equal(std::span{all}.first(flights[0].end), flown()));
}

TEST_F(BenchLog, FramesThatAreLostAreAskedForAgain) {
  for (const double loss : {0.001, 0.01}) {
    const std::uint32_t seed = 20'261'121;
    std::printf("seed %u\n", seed);
    core::RandomStream random{seed};
    const std::uint32_t used = reader.info().used_bytes;
    place.after_tick = [&] {
      if (random.chance(5.0 * loss)) {
        (void)place.pc_bus.receive();
      }
      if (random.chance(loss)) {
        (void)place.board_bus.receive();
      }
    };
    LogPart part{path};
    part.start_anew();
    (void)download(part, used);
    place.after_tick = nullptr;
    expect_whole(part, used);
    EXPECT_GT(reader.repeated(), 0U);
  }
}

TEST_F(BenchLog, AnInterruptedDownloadGoesOnWhereItWas) {
  const std::uint32_t used = reader.info().used_bytes;
  int ticks = 0;
  place.after_tick = [&] {
    if (++ticks == 1'000) {
      throw std::runtime_error{"Ctrl-C"};
    }
  };
  std::uint32_t first = 0;
  {
    LogPart part{path};
    EXPECT_THROW((void)download(part, used), std::runtime_error);
    first = part.size();
  }
  EXPECT_GT(first, 10'000U);
  EXPECT_LT(first, used);
  place.after_tick = nullptr;
  place.power_cycle();
  EXPECT_EQ(reader.info().used_bytes, used);
  LogPart part{path};
  EXPECT_EQ(download(part, used), first);
  expect_whole(part, used);
  EXPECT_EQ(download(part, used), used);  // and once more nothing
}

TEST_F(BenchLog, APartOfAnotherRecordIsStartedAnew) {
  const std::uint32_t used = reader.info().used_bytes;
  for (const std::size_t at : {std::size_t{10}, std::size_t{29'990}}) {  // in its first and in its last bytes
    LogPart part{path};
    part.start_anew();
    Bytes other(flown().begin(), flown().begin() + 30'000);
    other[at] ^= std::byte{1};
    part.append(other);
    EXPECT_EQ(download(part, used), 0U);
    expect_whole(part, used);
  }
  LogPart too_long{path};
  too_long.append(Bytes(10));
  EXPECT_EQ(download(too_long, used), 0U);
  expect_whole(too_long, used);
}

TEST_F(BenchLog, EveryFlightIsListedWithWhereItLiesAndWhoFlewIt) {
  const std::uint32_t second = put(0, flown());
  const std::uint32_t end = put(second, std::span{flown()}.first(30'000));
  place.power_cycle();
  const std::uint32_t used = reader.info().used_bytes;
  EXPECT_EQ(used, end);
  const auto flights = link::list_flights(reader, used, [](std::uint32_t) {});
  ASSERT_EQ(flights.size(), 2U);
  EXPECT_EQ(flights[0].stretch.offset, 0U);
  EXPECT_EQ(flights[0].stretch.size, second);
  EXPECT_EQ(flights[1].stretch.offset, second);
  EXPECT_EQ(flights[1].stretch.size, end - second);
  EXPECT_EQ(flights[0].power_up, 1U);
  EXPECT_FALSE(flights[0].vehicle.empty());
}

TEST_F(BenchLog, IsErasedInASessionOnlyAndGoneAfterTheNextPowerUpToo) {
  const std::uint32_t used = reader.info().used_bytes;
  {
    link::Session session = place.open_session(link);
    std::uint32_t left = used;
    reader.erase(session, [&](std::uint32_t now) {
      EXPECT_LE(now, left);
      left = now;
    });
    EXPECT_TRUE(session.close());
  }
  EXPECT_EQ(reader.info().used_bytes, 0U);
  EXPECT_TRUE(std::ranges::all_of(place.flash.cells().subspan(region_begin),
                                  [](std::byte byte) { return byte == std::byte{0xFF}; }));
  place.power_cycle();
  EXPECT_EQ(reader.info().used_bytes, 0U);
}

TEST_F(BenchLog, AnEraseWithoutASessionIsRefusedAndSoIsOneInTheSessionOfAnotherBench) {
  const std::uint32_t used = reader.info().used_bytes;
  const auto listen = [&](int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      place.wait(millisecond);
      link.listen(place.now());
    }
  };
  listen(3'000);
  const auto expect_refused = [&](std::uint8_t tag, std::uint32_t session) {
    const protocol::LogRequest request{.action = protocol::LogAction::erase, .tag = tag, .offset = session};
    (void)place.bus().send(avionics::can_frame(encode(request, 0)));
    listen(50);
    const auto reply = link.newest<protocol::LogReply>()->message;
    EXPECT_EQ(reply.tag, tag);
    EXPECT_EQ(reply.fault, protocol::LogFault::no_session);
  };
  expect_refused(12, 0);
  expect_refused(13, 5);
  const link::Session session = place.open_session(link);
  ASSERT_EQ(session.number(), 5);
  expect_refused(14, 0);
  expect_refused(15, 6);
  EXPECT_EQ(reader.info().used_bytes, used);
}

TEST_F(BenchLog, ABusThatGoesAwayIsSaidSoAndThePartIsKept) {
  const std::uint32_t used = reader.info().used_bytes;
  int ticks = 0;
  place.after_tick = [&] {
    if (++ticks == 1'000) {
      place.wire.set_state(hal::CanState::down);
    }
  };
  LogPart part{path};
  EXPECT_THROW((void)download(part, used), link::LinkError);
  EXPECT_GT(part.size(), 10'000U);
  EXPECT_TRUE(std::ranges::equal(part.read(0, part.size()), std::span{flown()}.first(part.size())));
}

}  // namespace
}  // namespace fantail::sil
