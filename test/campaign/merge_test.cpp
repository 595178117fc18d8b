// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "campaign/campaign.hpp"
#include "input/scratch_file.hpp"
#include "text/deflate.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

namespace fs = std::filesystem;

/// The second launch with an unknown mass, in three shards of whole parts. What is drawn is refused by the motor's
/// propellant, so that nothing is flown and the test is quick.
class Shards : public testing::Test {
 protected:
  Shards() {
    for (std::uint64_t number = 1; number <= 3; ++number) {
      fly({.number = number, .of = 3}, part(number), 5);
    }
  }

  void fly(const Shard& shard, const fs::path& out, std::uint64_t seed) const {
    const Campaign campaign{
        .scenario = file.path().string(), .changes = {}, .seed = seed, .runs = 3 * runs_of_a_part + 10, .shard = shard};
    (void)fly_campaign(campaign, out, "test", 2, [](std::uint64_t) {});
  }
  [[nodiscard]] fs::path part(std::uint64_t number) const { return folder / ("part" + std::to_string(number)); }
  [[nodiscard]] std::string refusal(const std::vector<fs::path>& parts) const {
    try {
      merge(parts, folder / "merged");
    } catch (const text::Error& error) {
      return error.what();
    }
    return "they were merged";
  }

  input::ScratchFile file{
      "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n"
      "[[spread]]\nfield = \"body.mass_kg\"\nlaw = \"uniform\"\nlow = 0.2\nhigh = 0.3\n",
      "scenario.toml"};
  fs::path folder = file.path().parent_path();
};

TEST_F(Shards, InAnyOrderAreTheBytesOfTheCampaignFlownAsOne) {
  fly({}, folder / "one", 5);
  merge(std::vector{part(2), part(3), part(1)}, folder / "merged");
  const std::string whole = file_content(folder / "one" / "runs.csv.gz");
  ASSERT_FALSE(whole.empty());
  EXPECT_TRUE(file_content(folder / "merged" / "runs.csv.gz") == whole);
  EXPECT_EQ(file_content(folder / "merged" / "campaign.json"), file_content(folder / "one" / "campaign.json"));
  const std::string text = text::gunzip(whole).value();
  EXPECT_EQ(std::ranges::count(text, '\n'), static_cast<std::ptrdiff_t>(3 * runs_of_a_part + 10 + 1));
}

TEST_F(Shards, AreNotPutOverAnotherCampaign) {
  fly({}, folder / "merged", 6);
  const std::string before = file_content(folder / "merged" / "runs.csv.gz");
  EXPECT_EQ(refusal({part(1), part(2), part(3)}), (folder / "merged").string() +
                                                      ": holds another campaign: seed is 6 there and 5 here; take "
                                                      "another folder, or remove that one");
  EXPECT_EQ(file_content(folder / "merged" / "runs.csv.gz"), before);
}

TEST_F(Shards, ThatAreMissingOrThereTwiceAreNamed) {
  EXPECT_EQ(refusal({part(2)}), "3 shards in all; missing: 1, 3");
  EXPECT_EQ(refusal({}), "no shard is named; allowed: the folders of all shards");
  fs::copy(part(2), folder / "again");
  EXPECT_EQ(refusal({part(1), part(2), part(3), folder / "again"}),
            "shard 2 is there twice: " + part(2).string() + " and " + (folder / "again").string());
  EXPECT_EQ(refusal({part(1), folder / "nowhere", part(3)}),
            (folder / "nowhere").string() + ": no runs.csv.gz; this shard has not been flown to its end");
  EXPECT_FALSE(fs::exists(folder / "merged"));
}

TEST_F(Shards, OfAnotherCampaignAreRefusedByWhatDiffers) {
  fly({.number = 2, .of = 3}, folder / "other", 6);
  EXPECT_EQ(refusal({part(1), folder / "other", part(3)}),
            part(1).string() + " and " + (folder / "other").string() +
                " belong to different campaigns: seed is 5 in the first and 6 in the other");
  fly({.number = 2, .of = 2}, folder / "halves", 5);
  EXPECT_EQ(refusal({part(1), folder / "halves"}),
            part(1).string() + " is one of 3 shards, and " + (folder / "halves").string() + " is one of 2");
}

TEST_F(Shards, WhoseRunsAreDamagedOrNotTheirsAreRefused) {
  const fs::path runs = part(2) / "runs.csv.gz";
  const std::string bytes = file_content(runs);
  const std::string last = file_content(part(3) / "runs.csv.gz");
  std::ofstream{runs, std::ios::binary} << bytes.substr(0, bytes.size() / 2);
  EXPECT_EQ(refusal({part(1), part(2), part(3)}),
            runs.string() + ": is damaged, not complete, or longer than its runs are");
  std::ofstream{runs, std::ios::binary} << last;
  EXPECT_EQ(refusal({part(1), part(2), part(3)}),
            runs.string() + ": run " + std::to_string(runs_of_a_part) + " is missing or has another seed");
  std::ofstream{runs, std::ios::binary} << bytes << text::gzip("x\n");
  EXPECT_EQ(refusal({part(1), part(2), part(3)}), runs.string() + ": has more runs than its shard");
}

TEST_F(Shards, OfWhichARowWasEditedAreRefusedByItsRun) {
  const fs::path runs = part(2) / "runs.csv.gz";
  const std::string text = text::gunzip(file_content(runs)).value();
  const std::string header = text.substr(0, text.find('\n') + 1);
  std::string rows = text.substr(header.size());
  rows.replace(rows.find("refused"), 7, "held");
  std::ofstream{runs, std::ios::binary} << text::gzip(header) << text::gzip(rows);
  EXPECT_EQ(refusal({part(1), part(2), part(3)}),
            runs.string() + ": the row of run " + std::to_string(runs_of_a_part) +
                " is not as it was written; fly this shard again, which replaces it");
}

TEST_F(Shards, OfAnEarlierVersionWhoseRowsCarryNoCheckAreRefused) {
  for (std::uint64_t number = 1; number <= 3; ++number) {
    const fs::path runs = part(number) / "runs.csv.gz";
    const std::string text = text::gunzip(file_content(runs)).value();
    const std::size_t end = text.find(",row_check");
    std::ofstream{runs, std::ios::binary} << text::gzip(text.substr(0, end) + "\n")
                                          << text::gzip(text.substr(end + 11));
  }
  EXPECT_EQ(refusal({part(1), part(2), part(3)}),
            (part(1) / "runs.csv.gz").string() +
                ": was written by an earlier version, whose rows carry no check; fly this shard again, which replaces "
                "it");
}

}  // namespace
}  // namespace fantail::campaign
