// SPDX-License-Identifier: MIT
// Stored parts: whose they are, that they are what was stored, and what a disk or a kill can make of them.
#include "runs/folder.hpp"

#include <filesystem>
#include <fstream>
#include <future>

#include <sys/resource.h>
#include <unistd.h>

#include "test.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace fantail::runs {
namespace {

namespace fs = std::filesystem;

const std::string part_text = "1 0.25 held\n2 0.5 not held\n";

class StoredParts : public testing::Test {
 protected:
  StoredParts() { fs::remove_all(folder_); }
  ~StoredParts() override { fs::remove_all(folder_); }

  [[nodiscard]] Place place(const Identity& identity = {{"kind", "test"}, {"version", "1 (a)"}, {"seed", "1"}}) const {
    return {.folder = folder_, .identity = identity};
  }
  [[nodiscard]] fs::path file(const char* part) const { return folder_ / "parts" / (std::string{part} + ".part"); }
  [[nodiscard]] std::string content(const char* part) const {
    std::ifstream stream{file(part), std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
  }
  void write(const char* part, const std::string& content) const {
    std::ofstream{file(part), std::ios::binary} << content;
  }
  /// What is found by whoever begins now, and how many parts were not believed.
  [[nodiscard]] std::pair<std::optional<std::string>, std::uint64_t> found(const char* part) const {
    const Folder folder{place()};
    auto there = folder.stored(part);
    return {std::move(there), folder.damaged()};
  }
  [[nodiscard]] std::string refusal(const Place& asked, text::ErrorKind kind = text::ErrorKind::bad_configuration) {
    try {
      const Folder folder{asked};
    } catch (const text::Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
      return error.what();
    }
    return "nothing was refused";
  }

  fs::path folder_ = fs::temp_directory_path() / ("fantail_stored_parts_" + std::to_string(getpid()));
};

const std::pair<std::optional<std::string>, std::uint64_t> damaged{std::nullopt, 1};

TEST_F(StoredParts, AreFoundByWhoeverBeginsAgain) {
  {
    const Folder folder{place()};
    EXPECT_EQ(folder.stored("one"), std::nullopt);
    folder.store("one", part_text);
    folder.store("empty", "");
    EXPECT_EQ(folder.stored("one"), part_text);
    EXPECT_EQ(folder.damaged(), 0U);
  }
  EXPECT_EQ(found("one"), std::pair(std::optional{part_text}, std::uint64_t{0}));
  EXPECT_EQ(found("empty").first, "");
  EXPECT_TRUE(has_parts(place()));
  Folder{place()}.remove();
  EXPECT_FALSE(has_parts(place()));
  EXPECT_EQ(found("one"), std::pair(std::optional<std::string>{}, std::uint64_t{0}));
}

TEST_F(StoredParts, CutAtAnyByteAreNone) {
  Folder{place()}.store("one", part_text);
  const std::string whole = content("one");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write("one", whole.substr(0, size));
    EXPECT_EQ(found("one"), damaged) << size;
  }
  write("one", whole);
  EXPECT_EQ(found("one").first, part_text);
}

TEST_F(StoredParts, WithAnyBitFlippedOrAByteMoreAreNone) {
  Folder{place()}.store("one", part_text);
  const std::string whole = content("one");
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    write("one", flipped);
    EXPECT_EQ(found("one"), damaged) << bit;
  }
  write("one", whole + "\n");
  EXPECT_EQ(found("one"), damaged);
}

TEST_F(StoredParts, CopiedOverAnotherOrOfAnotherSeedAreNone) {
  {
    const Folder folder{place({{"seed", "2"}})};
    folder.store("one", part_text);
    folder.store("two", "x");
    fs::copy_file(file("one"), file("two"), fs::copy_options::overwrite_existing);
    EXPECT_EQ(folder.stored("two"), std::nullopt);
  }
  fs::remove(folder_ / "parts/identity.json");
  EXPECT_EQ(found("one"), damaged);
}

TEST_F(StoredParts, OfAnotherProgramSeedOrKindAreRefusedByWhatDiffers) {
  Folder{place()}.store("one", part_text);
  const std::string said =
      folder_.string() + ": choose another folder with --out, or remove this one; it holds another campaign: ";
  EXPECT_EQ(refusal(place({{"kind", "test"}, {"version", "1 (b)"}, {"seed", "1"}})),
            said + "version is 1 (a) there and 1 (b) here");
  EXPECT_EQ(refusal(place({{"kind", "test"}, {"version", "1 (a)"}, {"seed", "2"}})),
            said + "seed is 1 there and 2 here");
  EXPECT_EQ(refusal(place({{"kind", "other"}})), said + "kind is test there and other here");
  EXPECT_EQ(refusal(place({{"kind", "test"}, {"plan", "x"}})), said + "plan is missing there and x here");
  EXPECT_EQ(found("one").first, part_text) << "and stay";
}

TEST_F(StoredParts, OfOtherFlightsAreReplacedWhereTheyAreNoMoreThanABeginning) {
  Folder{place()}.store("one", part_text);
  Place other = place({{"seed", "2"}});
  other.replaces_others = true;
  {
    const Folder folder{other};
    EXPECT_EQ(folder.stored("one"), std::nullopt);
    EXPECT_EQ(folder.damaged(), 0U);
    folder.store("one", "x");
  }
  EXPECT_EQ(Folder{other}.stored("one"), "x");
}

TEST_F(StoredParts, OfAnEarlierVersionOrBesideOtherResultsAreRefused) {
  for (const char* const name : {"chunks", "faults.json", "parts.jsonl"}) {
    fs::create_directories(folder_);
    std::ofstream{folder_ / name} << "{}\n";
    EXPECT_EQ(refusal(place()), folder_.string() + ": choose another folder with --out, or remove this one; it holds " +
                                    name + " of an earlier version of Fantail, which this version cannot continue");
    EXPECT_FALSE(fs::exists(folder_ / "parts"));
    fs::remove_all(folder_);
  }
  Place asked = place();
  asked.not_beside = "campaign.json";
  fs::create_directories(folder_);
  std::ofstream{folder_ / "campaign.json"} << "{}\n";
  EXPECT_NE(refusal(asked).find("it holds another campaign: the results that campaign.json describes"),
            std::string::npos);
}

TEST_F(StoredParts, WhoseIdentityFantailHasNotWrittenAreRefusedAndNothingOfItIsPrinted) {
  fs::create_directories(folder_ / "parts");
  std::ofstream{folder_ / "parts/identity.json"} << "\x1b[31m\xff\x01 something\n";
  const std::string said = refusal(place(), text::ErrorKind::bad_data);
  EXPECT_NE(
      said.find(
          "identity.json: choose another folder with --out, or remove this one; this file was not written by Fantail"),
      std::string::npos)
      << said;
  EXPECT_EQ(said.find('\x1b'), std::string::npos);
}

TEST_F(StoredParts, ForWhichTheDiskHasNoRoomAreNotThereAndThoseBeforeStay) {
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  {
    const Folder folder{place()};
    folder.store("one", part_text);
    const rlimit full{.rlim_cur = 200, .rlim_max = before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    EXPECT_THROW(folder.store("two", std::string(1000, 'x')), text::OutputError);
    setrlimit(RLIMIT_FSIZE, &before);
  }
  EXPECT_EQ(found("one").first, part_text);
  EXPECT_EQ(found("two"), std::pair(std::optional<std::string>{}, std::uint64_t{0}));
}

TEST_F(StoredParts, AreThoseOfOneProgramAtATime) {
  const Folder first{place()};
  EXPECT_EQ(refusal(place()), folder_.string() +
                                  ": another run of Fantail is at work in this folder; wait until it ends, or choose "
                                  "another folder with --out");
}

TEST_F(StoredParts, OfTwoThatBeginAtOnceInANewFolderOneIsRefused) {
  for (int round = 0; round < 20; ++round) {
    fs::remove_all(folder_);
    const auto begin = [this](const char* seed) {
      try {
        auto folder = std::make_unique<Folder>(place({{"seed", seed}}));
        folder->store("one", seed);
        return folder;
      } catch (const text::Error&) {
        return std::unique_ptr<Folder>{};
      }
    };
    auto other = std::async(std::launch::async, begin, "2");
    const auto one = begin("1");
    const auto two = other.get();
    ASSERT_NE(one == nullptr, two == nullptr) << round;
    EXPECT_EQ((one ? one : two)->stored("one"), one ? "1" : "2");
  }
}

TEST_F(StoredParts, OfWhichThereAreNoneLeaveNoFolder) {
  {
    const Folder folder{{.folder = folder_ / "a/b", .identity = {}}};
  }
  EXPECT_FALSE(fs::exists(folder_));
  fs::create_directories(folder_);
  {
    const Folder folder{place()};
  }
  EXPECT_TRUE(fs::exists(folder_)) << "whose it was before";
  EXPECT_FALSE(fs::exists(folder_ / "parts"));
}

TEST_F(StoredParts, WhereThereIsAFileInTheWayAreRefusedByTheSystemsReason) {
  std::ofstream{folder_} << "no folder";
  try {
    const Folder folder{place()};
    FAIL() << "it was made";
  } catch (const text::OutputError& error) {
    EXPECT_EQ(std::string{error.what()}, (folder_ / "parts").string() + ": Not a directory");
  }
}

}  // namespace
}  // namespace fantail::runs
