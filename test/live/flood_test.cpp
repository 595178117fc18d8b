// SPDX-License-Identifier: MIT
// Strangers who ask without an end, over raw sockets.
#include <chrono>

#include "served.hpp"
#include "test.hpp"

namespace fantail::live {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

struct Flood {
  std::size_t taken = 0;  ///< bytes, by whoever has sent them
  Clock::duration lasted{};
  std::string answer;
};

/// Sends `beginning`, and then `more` until the other side has closed the connection, or for 20 s.
Flood flood(const Served& served, const std::string& beginning, const std::string& more, Clock::duration pause) {
  Flood seen;
  Browser stranger{served.port};
  const auto begin = Clock::now();
  stranger.ask(beginning);
  while (seen.lasted < 20s && stranger.ask(more)) {
    seen.taken += more.size();
    std::this_thread::sleep_for(pause);
    seen.lasted = Clock::now() - begin;
  }
  seen.answer = stranger.read_to("\r\n");
  return seen;
}

// What the two systems keep of it is in what the sender could send; without a bound it is gigabytes in five seconds.
constexpr std::size_t most_taken = 8U << 20U;

TEST(Flood, OfHeaderLinesWithoutEndIsCutAtOnce) {
  const Served served;
  std::string lines;
  for (int i = 0; i < 1'000; ++i) {
    lines += "X-" + std::to_string(i) + ": y\r\n";
  }
  const Flood seen = flood(served, "GET / HTTP/1.1\r\nHost: " + served.host + "\r\n", lines, 0ms);
  EXPECT_LT(seen.lasted, 2s);
  EXPECT_LT(seen.taken, most_taken);
  EXPECT_EQ(seen.answer.find("200"), std::string::npos) << seen.answer;
  EXPECT_EQ(served.status_of("GET", "/", served.host), "HTTP/1.1 200 OK\r\n");
}

TEST(Flood, OfALineWithoutEndIsCutAtOnce) {
  const Served served;
  for (const std::string& beginning : {std::string{}, std::string{"GET /"}, std::string{"GET / HTTP/1.1\r\nX: "}}) {
    const Flood seen = flood(served, beginning, std::string(10'000, 'a'), 0ms);
    EXPECT_LT(seen.lasted, 2s) << beginning;
    EXPECT_LT(seen.taken, most_taken) << beginning;
    EXPECT_EQ(seen.answer.find("200"), std::string::npos) << seen.answer;
  }
  EXPECT_EQ(served.status_of("GET", "/", served.host), "HTTP/1.1 200 OK\r\n");
}

TEST(Flood, OfAByteNowAndThenIsCutAfterFiveSeconds) {
  const Served served;
  const Flood seen = flood(served, "GET / HTTP/1.1\r\nX: ", "x", 100ms);
  EXPECT_GT(seen.lasted, 4s);
  EXPECT_LT(seen.lasted, 8s);
  EXPECT_EQ(seen.answer.find("200"), std::string::npos) << seen.answer;
}

TEST(Flood, OfABodyThatNobodyAskedForIsNotRead) {
  const Served served;
  const Flood seen = flood(served, "GET / HTTP/1.1\r\nHost: " + served.host + "\r\nContent-Length: 99999999999\r\n\r\n",
                           std::string(10'000, 'b'), 0ms);
  EXPECT_LT(seen.lasted, 2s);
  EXPECT_LT(seen.taken, most_taken);
}

// A browser with its cookies for other programs of this computer asks so.
TEST(Flood, IsNotWhatAQuestionOfTenKilobytesIs) {
  const Served served;
  const std::string cookies = "Cookie: " + std::string(4'000, 'c') + "\r\n";
  EXPECT_EQ(served.status("GET / HTTP/1.1\r\nHost: " + served.host + "\r\n" + cookies + cookies + "\r\n"),
            "HTTP/1.1 200 OK\r\n");
}

}  // namespace
}  // namespace fantail::live
