// SPDX-License-Identifier: MIT
// Stored chunks: whose they are, and that they are what was stored.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "detection/campaign.hpp"
#include "text/error.hpp"

namespace fantail::detection {
namespace {

namespace fs = std::filesystem;

const auto nobody_looks = [](std::uint64_t) {};

Campaign gusts_and_drops() {
  const std::vector<std::string> names{"tasha3_launch2"};
  Campaign campaign{.rules = rules_of(names), .kinds = {Kind::gust, Kind::drop}};
  campaign.events = 40;
  campaign.launches = 4;
  return campaign;
}

class DetectionParts : public testing::Test {
 protected:
  DetectionParts() : folder_{fs::temp_directory_path() / ("fantail_detection_parts_" + std::to_string(getpid()))} {
    fs::remove_all(folder_);
  }
  ~DetectionParts() override { fs::remove_all(folder_); }

  [[nodiscard]] Results played(const Campaign& campaign, const std::string& program = "1 (a)") const {
    return play(campaign, folder_, program, 1, nobody_looks);
  }
  [[nodiscard]] std::string content() const {
    std::stringstream text;
    text << std::ifstream{folder_ / "parts.jsonl"}.rdbuf();
    return text.str();
  }
  void change(const std::string& from, const std::string& to) const {
    std::string text = content();
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << text;
    write(text.replace(at, from.size(), to));
  }
  void write(const std::string& text) const { std::ofstream{folder_ / "parts.jsonl", std::ios::binary} << text; }
  [[nodiscard]] std::string refusal_of(const Campaign& campaign, const std::string& program = "1 (a)") const {
    try {
      (void)played(campaign, program);
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), text::ErrorKind::bad_configuration);
      return error.what();
    }
    return {};
  }

  fs::path folder_;
};

TEST_F(DetectionParts, APartOfWhichADigitWasChangedIsPlayedAgainAndCounted) {
  const Results whole = played(gusts_and_drops());
  EXPECT_EQ(whole.damaged, 0U);
  for (const auto& [from, to] :
       {std::pair{"\"controlling\":0", "\"controlling\":5"}, std::pair{"\"events\":20", "\"events\":20000"},
        std::pair{"\"seal\":\"", "\"seal\":\"0"}}) {
    change(from, to);
    const Results again = played(gusts_and_drops());
    EXPECT_EQ(again.of_kind[index(Kind::gust)], whole.of_kind[index(Kind::gust)]) << to;
    EXPECT_EQ(again.played, 40U) << to;
    EXPECT_EQ(again.damaged, 1U) << to;
    const Results third = played(gusts_and_drops());
    EXPECT_EQ(third.played, 0U) << to;
    EXPECT_EQ(third.damaged, 0U) << "what was damaged is gone from the file";
  }
}

TEST_F(DetectionParts, ASecondLineForAChunkIsNoneWithoutItsSeal) {
  const Results whole = played(gusts_and_drops());
  write(content() + R"({"kind":"gust","chunk":0,"events":40,"tally":[[{"events":40}]]})" + '\n');
  const Results again = played(gusts_and_drops());
  EXPECT_EQ(again.of_kind[index(Kind::gust)], whole.of_kind[index(Kind::gust)]);
  EXPECT_EQ(again.damaged, 1U);
}

TEST_F(DetectionParts, APartOfAnotherCampaignIsNone) {
  Campaign other = gusts_and_drops();
  other.seed = 2;
  (void)played(other);
  const std::string parts = content();
  const std::string lines = parts.substr(parts.find('\n') + 1);
  fs::remove_all(folder_);
  const Results whole = played(gusts_and_drops());
  const std::string own = content();
  write(own.substr(0, own.find('\n') + 1) + lines);
  const Results again = played(gusts_and_drops());
  EXPECT_EQ(again.damaged, 2U);
  EXPECT_EQ(again.of_kind, whole.of_kind);
}

TEST_F(DetectionParts, AFileThatAFullDiskLeftEmptyOrTornIsBegunAnew) {
  (void)played(gusts_and_drops());
  const std::string whole = content();
  for (const std::size_t left : {std::size_t{0}, std::size_t{1}, whole.find('\n') / 2, whole.find('\n')}) {
    write(whole.substr(0, left));
    EXPECT_EQ(played(gusts_and_drops()).played, 80U) << left;
    EXPECT_EQ(content(), whole) << left;
  }
}

TEST_F(DetectionParts, WhatNoCampaignHasWrittenIsRefusedAndNothingOfItIsPrinted) {
  fs::create_directories(folder_);
  const std::string garbage = "\x1b[31m\xff\x01 something\n";
  write(garbage);
  const std::string said = refusal_of(gusts_and_drops());
  EXPECT_NE(said.find("parts.jsonl: choose another folder with --out, or remove this file"), std::string::npos) << said;
  EXPECT_EQ(said.find("something"), std::string::npos) << said;
  EXPECT_EQ(content(), garbage);
}

TEST_F(DetectionParts, ARefusalSaysWhatToDoAndThenWhichKeyDiffers) {
  (void)played(gusts_and_drops());
  Campaign other = gusts_and_drops();
  other.seed = 2;
  const std::string said = refusal_of(other);
  EXPECT_TRUE(
      said.ends_with(": choose another folder with --out, or remove this one; it holds another campaign: seed is "
                     "1 there and 2 here"))
      << said;
  EXPECT_TRUE(refusal_of(gusts_and_drops(), "1 (b)").ends_with("program is 1 (a) there and 1 (b) here"));
  other = gusts_and_drops();
  other.both_well = true;
  EXPECT_TRUE(refusal_of(other).ends_with("both_well is no there and yes here"));
}

TEST_F(DetectionParts, AFolderOfAnotherKindOfCampaignIsRefused) {
  fs::create_directories(folder_);
  std::ofstream{folder_ / "faults.json"} << "{}\n";
  EXPECT_NE(refusal_of(gusts_and_drops()).find("faults.json of fantail campaign faults"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "parts.jsonl"));
}

TEST_F(DetectionParts, WhoInterruptsDoesNotWaitForAChunkAndSeesEachEvent) {
  Campaign campaign = gusts_and_drops();
  campaign.kinds = {Kind::launch};
  campaign.launches = 1'000'000;
  struct Stop {};
  const std::uint64_t chunk = events_of_a_chunk(Kind::launch);
  // Who waited for chunks would see whole ones alone, and find stored at least what was seen. A chunk may by chance end
  // in the very moment of the interrupt, but not three times.
  bool in_between = false;
  for (int attempt = 0; attempt < 3 && !in_between; ++attempt) {
    fs::remove_all(folder_);
    std::uint64_t seen = 0;
    EXPECT_THROW((void)play(campaign, folder_, "1", 2,
                            [&](std::uint64_t done) {
                              seen = done;
                              if (done > 0) {
                                throw Stop{};
                              }
                            }),
                 Stop);
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(content(), '\n'));
    in_between = seen % chunk != 0 && (lines - 1) * chunk < seen;
  }
  EXPECT_TRUE(in_between);
}

}  // namespace
}  // namespace fantail::detection
