// SPDX-License-Identifier: MIT
#include "text/local_time.hpp"

#include <cstdlib>
#include <ctime>

#include <gtest/gtest.h>

namespace fantail::text {
namespace {

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

}  // namespace
}  // namespace fantail::text
