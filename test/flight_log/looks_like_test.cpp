// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include "flight_log/flight_log.hpp"
#include "flight_log/made_flight.hpp"
#include "test.hpp"
#include "text/error.hpp"

namespace fantail::flight_log {
namespace {

using namespace std::string_view_literals;

std::string looks(std::string_view text) { return looks_like(std::as_bytes(std::span{text})); }

TEST(LooksLike, KindsOfFilesThatPeopleTakeForALogAreNamed) {
  EXPECT_NE(looks("ULog\x01\x12\x35\x01"sv).find("ULog"), std::string::npos);
  EXPECT_NE(looks("MATLAB 5.0 MAT-file, written").find("MAT-file"), std::string::npos);
  EXPECT_NE(looks("PAR1\x15\x04"sv).find("Parquet"), std::string::npos);
  EXPECT_NE(looks("\x89MCAP0\r\n\x01"sv).find("MCAP"), std::string::npos);
  EXPECT_NE(looks("\xED\xA1\xDA\x01\0\0\0\0"sv).find("LCM"), std::string::npos);
  EXPECT_NE(looks("\x7F"
                  "ELF\x02\x01"sv)
                .find("ELF"),
            std::string::npos);
  EXPECT_NE(looks("FTPL\x01\0"sv).find("flight plan"), std::string::npos);
  EXPECT_NE(looks("time_s,phase,roll_angle_deg\n0,safe,0\n").find("CSV"), std::string::npos);
  EXPECT_NE(looks("(1436509052.249713) vcan0 044#2A366C2BBA\n").find("candump"), std::string::npos);
  EXPECT_NE(looks("  vcan0  044   [5]  2A 36 6C 2B BA\n").find("candump"), std::string::npos);
  EXPECT_EQ(looks("{\"a\": 1}"), "JSON");
  EXPECT_EQ(looks("Dear diary\n"), "text");
  EXPECT_EQ(looks(""), "an empty file");
  EXPECT_NE(looks("\xFF\xFF\xFF\xFF").find("erased flash"), std::string::npos);
  EXPECT_NE(looks("\0\0\0"sv).find("zeros"), std::string::npos);
  EXPECT_NE(looks("\x01\x02\x03\x04"sv).find("another kind"), std::string::npos);
}

// A log whose power was cut, or whose download was broken off, before a single record was whole.
TEST(LooksLike, ALogCutInItsFirstRecordSaysWhatIsLeftOfIt) {
  const MadeFlight made = make_flight();
  const std::size_t whole = made.frame_ends[0];
  const auto cut = [&](std::size_t bytes) { return looks_like(std::span{made.bytes}.first(bytes)); };
  EXPECT_EQ(cut(3), "cut off in its first record: 3 bytes, possibly not a flight log");
  EXPECT_EQ(cut(100), "a flight log that is cut off in its first record, after 100 of " + std::to_string(whole) +
                          " bytes; it is too short to read its header");
  EXPECT_NE(cut(whole - 1).find("its header (not checked) gives log format 1, firmware 0.1"), std::string::npos)
      << cut(whole - 1);
  std::vector<std::byte> turned{made.bytes.begin(), made.bytes.begin() + static_cast<std::ptrdiff_t>(whole)};
  turned[40] ^= std::byte{1};
  EXPECT_EQ(looks_like(turned), "a flight log of " + std::to_string(whole) + " bytes in which no record is intact");
}

class LogFileOnDisk : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path{testing::TempDir()} /
              ("fantail_log_" + std::string{testing::UnitTest::GetInstance()->current_test_info()->name()});
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  static std::string refusal(const std::filesystem::path& path, text::ErrorKind fault) {
    try {
      (void)read_log_file(path);
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), fault);
      return error.what();
    }
    ADD_FAILURE() << "was not refused";
    return {};
  }

  std::filesystem::path folder_;
};

TEST_F(LogFileOnDisk, ThatIsSomethingElseIsRefusedWithWhatItIs) {
  const auto file = folder_ / "flight.csv";
  std::ofstream{file} << "time_s,phase,roll_angle_deg\n";
  const std::string message = refusal(file, text::ErrorKind::bad_data);
  EXPECT_NE(message.find(file.string()), std::string::npos);
  EXPECT_NE(message.find("CSV"), std::string::npos);
}

TEST_F(LogFileOnDisk, ThatDoesNotExistIsNoInput) {
  EXPECT_NE(refusal(folder_ / "none.ftl", text::ErrorKind::no_such_input).find("no such file"), std::string::npos);
}

TEST_F(LogFileOnDisk, OfAFolderIsTheFlightInIt) {
  EXPECT_NE(refusal(folder_, text::ErrorKind::no_such_input).find("contains no flight log"), std::string::npos);
  std::ofstream{folder_ / "flight_001.ftl"} << "x";  // as a download names it
  EXPECT_NE(refusal(folder_, text::ErrorKind::bad_data).find("flight_001.ftl"), std::string::npos);
  std::ofstream{folder_ / "flight_002.ftl"} << "x";
  EXPECT_NE(refusal(folder_, text::ErrorKind::no_such_input).find("several"), std::string::npos);
  std::ofstream{folder_ / "flight.ftl"} << "x";
  EXPECT_NE(refusal(folder_, text::ErrorKind::bad_data).find("flight.ftl"), std::string::npos);
}

}  // namespace
}  // namespace fantail::flight_log
