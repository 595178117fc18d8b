// SPDX-License-Identifier: MIT
#include "text/deflate.hpp"

#include <cstdlib>
#include <ctime>

#include "test.hpp"
#include "text/error.hpp"
#include "text/local_time.hpp"
#include "text/sha256.hpp"

namespace fantail::text {
namespace {

TEST(Gzip, GivesTheTextsOfAllMembersBackAndNothingOfADamagedFile) {
  const std::string long_text(200'000, 'x');
  EXPECT_TRUE(gunzip(gzip("run,seed\n") + gzip(long_text) + gzip("")) == "run,seed\n" + long_text);
  const std::string text = "17,4711,0.25,held\n18,4712,0.75,not_held\n";
  const std::string bytes = gzip(text);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_EQ(gunzip(bytes.substr(0, length)), std::nullopt) << length;
  }
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    const auto read = gunzip(damaged);
    EXPECT_TRUE(!read || *read == text) << bit << ": bits that mean nothing may change, no text";
  }
}

TEST(Gzip, UnpacksNoMoreThanIsAskedFor) { EXPECT_EQ(gunzip(gzip(std::string(1'000'000, 'x')), 999'999), std::nullopt); }

TEST(Error, WhatItQuotesFromAFileWritesNothingToATerminal) {
  const Error error{ErrorKind::bad_data, "x.eng:2: propellant mass \"0.2\x1b[2J\x0e\n\x7f\xff\"; allowed: a number"};
  EXPECT_STREQ(error.what(), "x.eng:2: propellant mass \"0.2?[2J????\"; allowed: a number");
}

TEST(Error, QuotesOfAWordOfThousandsOfCharactersItsBeginningAndItsEnd) {
  const std::string error =
      Error{ErrorKind::usage, "--columns \"" + std::string(4000, 'x') + "\"; allowed: a name"}.what();
  EXPECT_LT(error.size(), 3100U);
  EXPECT_TRUE(error.starts_with("--columns \"xxx"));
  EXPECT_TRUE(error.ends_with("xxx\"; allowed: a name"));
  EXPECT_NE(error.find("xxx ... xxx"), std::string::npos);
}

TEST(Error, KeepsTheLettersOfEveryLanguage) {
  const std::string sentence = "Flügel 火箭.toml: no such file; 5 °C, 3 m²";
  EXPECT_EQ(Error(ErrorKind::no_such_input, sentence).what(), sentence);
}

// 1 800 000 000 s after 1970 is 2027-01-15 08:00 UTC.
TEST(LocalTime, SaysHowFarItIsFromUtc) {
  const auto in_zone = [](const char* zone) {
    setenv("TZ", zone, 1);
    tzset();
    return local_minute(std::chrono::system_clock::time_point{std::chrono::seconds{1'800'000'000}});
  };
  EXPECT_EQ(in_zone("UTC0"), "2027-01-15 08:00 UTC+0000");
  EXPECT_EQ(in_zone("IST-5:30"), "2027-01-15 13:30 UTC+0530");
  EXPECT_EQ(in_zone("EST5"), "2027-01-15 03:00 UTC-0500");
  unsetenv("TZ");
  tzset();
}

// FIPS 180-4, examples of NIST.
TEST(Sha256, IsThatOfTheStandard) {
  const std::string message = "abc";
  EXPECT_EQ(sha256(std::as_bytes(std::span{message})),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace

}  // namespace fantail::text
