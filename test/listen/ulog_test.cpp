// SPDX-License-Identifier: MIT
#include "listen/ulog.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "listen/load.hpp"
#include "listen/maps.hpp"
#include "listen/refused.hpp"
#include "random/seed.hpp"
#include "system/folder.hpp"

namespace fantail::listen {
namespace {

template <typename T>
std::string bytes(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string message(char type, const std::string& content) {
  return bytes(static_cast<std::uint16_t>(content.size())) + type + content;
}

const std::string sync_message = message('S', std::string{"\x2F\x73\x13\x20\x25\x0C\xBB\x12", 8});

std::string combined(std::uint64_t time_us, float axial) {
  return message('D', bytes<std::uint16_t>(7) + bytes(time_us) + bytes(0.1F) + bytes(0.2F) + bytes(0.3F) +
                          bytes(axial) + bytes(0.0F) + bytes(-1.0F));
}

std::string air(std::uint64_t time_us, float height) {
  return message('D', bytes<std::uint16_t>(9) + bytes(time_us) + bytes(std::uint32_t{12}) + bytes(height));
}

std::string head() {
  return std::string{"ULog\x01\x12\x35\x01", 8} + bytes(std::uint64_t{1'000'000}) +
         message('B', std::string(40, '\0')) +
         message('F', "sensor_combined:uint64_t timestamp;float[3] gyro_rad;float[3] accelerometer_m_s2;") +
         message(
             'F',
             "vehicle_air_data:uint64_t timestamp;uint32_t baro_device_id;float baro_alt_meter;uint8_t[4] _padding0;") +
         message('A', bytes<std::uint8_t>(0) + bytes<std::uint16_t>(7) + "sensor_combined") +
         message('A', bytes<std::uint8_t>(1) + bytes<std::uint16_t>(8) + "sensor_combined") +
         message('A', bytes<std::uint8_t>(0) + bytes<std::uint16_t>(9) + "vehicle_air_data") +
         message('A', bytes<std::uint8_t>(0) + bytes<std::uint16_t>(11) + "cpuload");
}

std::string whole() {
  std::string file = head();
  for (std::uint64_t i = 0; i < 20; ++i) {
    file += combined(1'000'000 + 4000 * i, 9.5F + static_cast<float>(i));
    if (i % 5 == 0) {
      file += air(1'000'500 + 4000 * i, 100.0F + static_cast<float>(i));
      file += message('D', bytes<std::uint16_t>(8) + std::string(32, 'x'));  // a second instance
      file += message('D', bytes<std::uint16_t>(11) + std::string(12, 'y'));
      file += sync_message;
    }
  }
  return file + message('O', bytes<std::uint16_t>(25));
}

const table_file::Column& column(const UlogColumns& read, const std::string& name) {
  const auto found = std::ranges::find(read.columns, name, &table_file::Column::name);
  if (found == read.columns.end()) {
    throw std::runtime_error{"no column " + name};
  }
  return *found;
}

TEST(Ulog, GivesARowForEachMessageOfItsTwoTopicsInOrderOfTime) {
  const UlogColumns read = read_ulog(whole(), "a.ulg");
  const auto& time = column(read, "timestamp").values;
  const auto& axial = column(read, "accelerometer_m_s2[0]").values;
  const auto& height = column(read, "baro_alt_meter").values;
  ASSERT_EQ(time.size(), 24U);
  EXPECT_TRUE(std::ranges::is_sorted(time));
  EXPECT_EQ(time[1], 1'000'500.0);
  EXPECT_TRUE(std::isnan(axial[1]));
  EXPECT_EQ(height[1], 100.0);
  EXPECT_EQ(time[2], 1'004'000.0);
  EXPECT_EQ(axial[2], 10.5);
  EXPECT_TRUE(std::isnan(height[2]));
  EXPECT_NEAR(column(read, "gyro_rad[2]").values[2], 0.3, 1e-7);
  EXPECT_EQ(column(read, "accelerometer_m_s2[2]").values[2], -1.0);
  EXPECT_EQ(column(read, "baro_device_id").values[1], 12.0);
  ASSERT_EQ(read.notes.size(), 1U);
  EXPECT_EQ(read.notes[0], "The logger says that it dropped 25 ms.");
}

// Motion every 4 ms but for 12 ms once, height every 20 ms.
TEST(Ulog, ThatIsSoundHasOneNoteOnItsTwoTopicsWithTheLargestGapOfEach) {
  std::string file = head();
  for (std::uint64_t i = 0; i < 400; ++i) {
    file += i == 200 || i == 201 ? std::string{} : combined(1'000'000 + 4000 * i, 9.5F);
    file += i % 5 == 0 ? air(1'000'000 + 4000 * i, 100.0F) : std::string{};
  }
  const test::Folder folder;
  const Loaded loaded = load(folder.write("a.ulg", file));
  const ImuLog log = imu_log(loaded.table, sources_of(*find_map("px4")), loaded.clocks);
  EXPECT_TRUE(loaded.notes.empty());
  ASSERT_EQ(log.notes.size(), 1U) << log.notes[1];
  EXPECT_EQ(
      log.notes[0],
      "Motion and height were logged apart and are merged, each sample at its own time. The largest gap is 12 ms in "
      "the motion and 20 ms in the height.");
  EXPECT_EQ(log.axial.time_s.size(), 398U);
  EXPECT_EQ(log.height.time_s.size(), 80U);
}

TEST(Ulog, WithoutItsTopicIsRefusedWithThoseThatAreThere) {
  expect_refusal(text::ErrorKind::bad_data, {"a.ulg", "no message of the topic sensor_combined", "cpuload"},
                 [] { (void)read_ulog(head(), "a.ulg"); });
  expect_refusal(text::ErrorKind::bad_data, {"a.ulg", "no ULog", "time_s"},
                 [] { (void)read_ulog("time_s,a\n", "a.ulg"); });
}

// What is read of a damaged file is rows of the whole one, each as it was.
TEST(Ulog, CutOffAnywhereHasTheRowsUpToThere) {
  const std::string file = whole();
  const UlogColumns all = read_ulog(file, "a.ulg");
  std::size_t read_at_all = 0;
  for (std::size_t size = 0; size < file.size(); ++size) {
    try {
      const UlogColumns part = read_ulog(std::string_view{file}.substr(0, size), "a.ulg");
      const auto& axial = column(part, "accelerometer_m_s2[0]").values;
      const auto& whole_axial = column(all, "accelerometer_m_s2[0]").values;
      const auto known = [](double value) { return !std::isnan(value); };
      const auto count = std::ranges::count_if(axial, known);
      double sum = 0.0;
      double whole_sum = 0.0;
      std::ranges::for_each(axial, [&](double value) { sum += known(value) ? value : 0.0; });
      std::ptrdiff_t taken = 0;
      for (const double value : whole_axial) {
        whole_sum += known(value) && taken++ < count ? value : 0.0;
      }
      ASSERT_EQ(sum, whole_sum) << size;
      ++read_at_all;
    } catch (const text::Error& error) {
      EXPECT_TRUE(std::string_view{error.what()}.starts_with("a.ulg")) << error.what();
    }
  }
  EXPECT_GT(read_at_all, file.size() / 2);
}

TEST(Ulog, WithAnyBitFlippedIsReadOrRefused) {
  const std::string file = whole();
  std::size_t read_at_all = 0;
  for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
    std::string damaged = file;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    try {
      const UlogColumns part = read_ulog(damaged, "a.ulg");
      ASSERT_LE(part.columns.front().values.size(), 24U + 5U) << bit;
      for (const auto& one : part.columns) {
        ASSERT_EQ(one.values.size(), part.columns.front().values.size());
      }
      ++read_at_all;
    } catch (const text::Error& error) {
      EXPECT_TRUE(std::string_view{error.what()}.starts_with("a.ulg")) << error.what();
    }
  }
  EXPECT_GT(read_at_all, 4 * file.size()) << "most bits are one figure of one row";
}

TEST(Ulog, IsReadOnBehindDamageFromTheNextSyncMessage) {
  std::string file = whole();
  const std::size_t at = file.find(combined(1'004'000, 10.5F));
  file.replace(at, 3, "\xFF\xFF\xFF");
  const UlogColumns read = read_ulog(file, "a.ulg");
  // Rows 1 to 5, the air data at 5 and its companions lie before that message; 15 to 20 ms are lost.
  EXPECT_EQ(column(read, "timestamp").values.size(), 24U - 6U);
  EXPECT_NE(read.notes[0].find("damaged in one place"), std::string::npos) << read.notes[0];
}

// A size that is wrong reaches over sound messages: they are lost with it, and counted.
TEST(Ulog, CountsWhatAMessageOfAWrongSizeReachesOver) {
  std::string file = whole();
  const std::string message_there = combined(1'004'000, 10.5F);
  const std::size_t at = file.find(message_there);
  file[at] = static_cast<char>(3 * message_there.size() - 3);  // now it ends where the third one ends
  const UlogColumns read = read_ulog(file, "a.ulg");
  EXPECT_EQ(column(read, "timestamp").values.size(), 24U - 6U);
  const std::size_t next = file.find(sync_message, at) + sync_message.size();
  EXPECT_EQ(read.notes[0], fmt::format("The ULog is damaged in one place: {} bytes are left out, the first at byte {}.",
                                       next - at, at));
}

TEST(Ulog, LeavesOutAMessageThatStandsAloneWithItsTime) {
  for (const std::uint64_t time_us : {1'060'000ULL, 1'000'100ULL, 4'000'000'000ULL}) {
    std::string file = whole();
    const std::string was = combined(1'036'000, 18.5F);
    file.replace(file.find(was), was.size(), combined(time_us, 18.5F));
    std::string more;
    for (std::uint64_t i = 0; i < 100; ++i) {
      more += combined(1'100'000 + 4000 * i, 9.5F);
    }
    const UlogColumns read = read_ulog(file + more, "a.ulg");
    EXPECT_EQ(column(read, "timestamp").values.size(), 24U - 1U + 100U) << time_us;
    EXPECT_EQ(read.notes[0], "One message that stands alone with its time is left out.");
  }
}

TEST(Ulog, WhoseTimeGoesBackIsRefused) {
  std::string back;
  for (std::uint64_t i = 0; i < 10; ++i) {
    back += combined(1'050'000 + 4000 * i, 9.5F);
  }
  expect_refusal(text::ErrorKind::bad_data, {"a.ulg", "sensor_combined", "from 1.076000 s to 1.050000 s"},
                 [&] { (void)read_ulog(whole() + back, "a.ulg"); });
  std::string often;
  for (std::uint64_t i = 0; i < 200; ++i) {
    often += combined(1'100'000 + 4000 * i - (i % 50 == 49 ? 8000 : 0), 9.5F);
  }
  expect_refusal(text::ErrorKind::bad_data, {"a.ulg", "again and again: 4 of 224"},
                 [&] { (void)read_ulog(whole() + often, "a.ulg"); });
}

TEST(Ulog, OfAnyBytesEndsInATableOrARefusal) {
  std::mt19937 random{test::seed()};
  for (int i = 0; i < 2000; ++i) {
    std::string file = whole();
    for (int change = 0; change < 1 + i % 20; ++change) {
      file[random() % file.size()] = static_cast<char>(random());
    }
    try {
      (void)read_ulog(file, "a.ulg");
    } catch (const text::Error&) {
    }
  }
}

TEST(Ulog, LeavesOutARowOfAnotherTime) {
  const UlogColumns read =
      read_ulog(whole() + combined(std::uint64_t{1} << 60, 1.0F) + combined(1'100'000, 1.0F), "a.ulg");
  EXPECT_EQ(column(read, "timestamp").values.size(), 25U);
  EXPECT_EQ(read.notes[0], "1 messages with a time that is not near the start of the ULog are left out.");
}

}  // namespace
}  // namespace fantail::listen
