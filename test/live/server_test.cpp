// SPDX-License-Identifier: MIT
#include "live/server.hpp"

#include <atomic>
#include <chrono>
#include <thread>

#include "served.hpp"
#include "test.hpp"

namespace fantail::live {
namespace {

using namespace std::chrono_literals;

TEST(LiveServer, ServesThePageAndLetsNothingElseIntoIt) {
  const Served served;
  Browser browser = served.open("/");
  const std::string head = browser.read_to("\r\n\r\n");
  EXPECT_TRUE(head.starts_with("HTTP/1.1 200")) << head;
  EXPECT_NE(head.find("Content-Security-Policy: default-src 'none'"), std::string::npos);
  EXPECT_NE(head.find("X-Content-Type-Options: nosniff"), std::string::npos);
  EXPECT_EQ(browser.read_to("</p>"), "<p>the page</p>");
}

TEST(LiveServer, AViewerIsGreetedAndThenSentEveryFrame) {
  Served served;
  Browser browser = served.open("/events");
  EXPECT_NE(browser.read_to("\r\n\r\n").find("text/event-stream"), std::string::npos);
  EXPECT_NE(browser.read_to("hello\n\n").find("event: page\ndata: whose\n\ndata: hello\n\n"), std::string::npos);
  for (int i = 0; i < 20; ++i) {
    served.server.show("frame " + std::to_string(i));
    const std::string event = browser.read_to("\n\n");
    EXPECT_NE(event.find("data: frame " + std::to_string(i) + "\n\n"), std::string::npos) << event;
  }
  EXPECT_EQ(served.server.figures().frames_dropped, 0U);
  for (int i = 0; i < 1000 && served.server.figures().frames_sent < 21; ++i) {
    std::this_thread::sleep_for(10ms);  // counted behind the write
  }
  EXPECT_EQ(served.server.figures().frames_sent, 21U);
}

TEST(LiveServer, TheGreetingComesBeforeTheFramesThatWereShownMeanwhile) {
  Server* serving = nullptr;
  Server server{{.port = 0}, {.html = "", .about = "whose"}, [&serving] {
                  serving->show("meanwhile");
                  return std::string{"hello"};
                }};
  serving = &server;
  Browser browser{server.address().port};
  browser.get("/events", "127.0.0.1:" + std::to_string(server.address().port));
  EXPECT_EQ(browser.read_to("data: hello\n\n").find("meanwhile"), std::string::npos);
}

TEST(LiveServer, TenViewersAtOnceGetTheSameFrames) {
  Served served;
  std::vector<Browser> browsers;
  for (int i = 0; i < 10; ++i) {
    browsers.push_back(served.open("/events"));
  }
  served.wait_for_viewers(10);
  served.server.show("for all");
  for (Browser& browser : browsers) {
    EXPECT_NE(browser.read_to("data: for all\n\n").find("data: for all"), std::string::npos);
  }
}

TEST(LiveServer, AViewerThatHasGoneIsForgotten) {
  Served served;
  {
    const Browser browser = served.open("/events");
    served.wait_for_viewers(1);
  }
  served.server.show("x");
  served.wait_for_viewers(0);
}

TEST(LiveServer, WhoAsksUnderAnotherNameWithAnotherMethodOrForSomethingElseIsRefused) {
  const Served served;
  EXPECT_EQ(served.status_of("GET", "/", "evil.example:" + std::to_string(served.port)), "HTTP/1.1 403 Forbidden\r\n");
  EXPECT_EQ(served.status_of("GET", "/events", "evil.example"), "HTTP/1.1 403 Forbidden\r\n");
  EXPECT_EQ(served.status("GET / HTTP/1.1\r\n\r\n"), "HTTP/1.1 403 Forbidden\r\n");
  EXPECT_EQ(served.status("GET / HTTP/1.1\r\nHost: " + served.host + "\r\nHost: evil.example\r\n\r\n"),
            "HTTP/1.1 403 Forbidden\r\n");
  for (const char* method : {"HEAD", "POST", "PUT", "DELETE", "PATCH", "OPTIONS"}) {
    EXPECT_EQ(served.status_of(method, "/", served.host), "HTTP/1.1 405 Method Not Allowed\r\n") << method;
  }
  for (const char* path :
       {"/index.html", "/../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/events/..", "//", "/\xff", "/?x=<script>y"}) {
    const std::string status = served.status_of("GET", path, served.host);
    EXPECT_TRUE(status == "HTTP/1.1 404 Not Found\r\n" || status == "HTTP/1.1 400 Bad Request\r\n" ||
                (std::string{path} == "/?x=<script>y" && status == "HTTP/1.1 200 OK\r\n"))
        << path << ' ' << status;
  }
  // Of what is far too long or no HTTP at all there may be no answer, but there is one for the next.
  (void)served.status("GET /" + std::string(100'000, 'a') + " HTTP/1.1\r\n\r\n");
  (void)served.status("\x16\x03\x01 hello\r\n\r\n");
  EXPECT_EQ(served.status_of("GET", "/", served.host), "HTTP/1.1 200 OK\r\n");
}

TEST(LiveServer, AHundredViewersThatTakeNothingCostNothingAndAreLetGo) {
  Served served;
  std::vector<Browser> stalled;
  for (int i = 0; i < 100; ++i) {
    stalled.push_back(served.open("/events"));
  }
  served.wait_for_viewers(Server::most_viewers);
  const std::string frame(4000, 'x');
  for (int i = 0; i < 400; ++i) {
    served.server.show(frame);
  }
  // All of them are still there, each in the middle of a frame that it does not take: nobody has waited for that.
  EXPECT_EQ(served.server.figures().viewers, Server::most_viewers);
  EXPECT_GT(served.server.figures().frames_dropped, 0U);
  for (int i = 0; i < 1000 && served.server.figures().refused < 100U - Server::most_viewers; ++i) {
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_EQ(served.server.figures().refused, 100U - Server::most_viewers);
  EXPECT_EQ(served.status_of("GET", "/", served.host), "HTTP/1.1 200 OK\r\n") << "the page is there for the next";
  for (int i = 0; i < 20'000 && served.server.figures().viewers > 0; ++i) {
    served.server.show(frame);
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(served.server.figures().viewers, 0U);
  Browser next = served.open("/events");
  EXPECT_NE(next.read_to("data: hello\n\n").find("hello"), std::string::npos);
}

TEST(LiveServer, WhoSendsAByteNowAndThenDoesNotKeepItFromEnding) {
  auto served = std::make_optional<Served>();
  const Browser slow{served->port};
  slow.ask("GET / HTTP/1.1\r\nX: ");
  std::atomic<bool> has_ended = false;
  bool was_let_go = false;
  std::jthread trickle{[&] {
    for (int i = 0; i < 3000 && !was_let_go; ++i) {  // half a minute, and longer than any patience with a single read
      std::this_thread::sleep_for(10ms);
      was_let_go = !slow.ask("x");
    }
    EXPECT_TRUE(has_ended) << "it waited for the client";
  }};
  std::this_thread::sleep_for(50ms);
  served.reset();
  has_ended = true;
  trickle.join();
  EXPECT_TRUE(was_let_go);
}

TEST(LiveServer, ConnectionsThatAskForNothingTakeNoMoreThanTheirPlacesAndForFiveSeconds) {
  const Served served;
  std::vector<Browser> idle;
  for (std::size_t i = 0; i < Server::most_viewers + 28; ++i) {
    idle.emplace_back(served.port);
    idle.back().ask("GET / HTTP/1.1\r\n");
  }
  for (int i = 0; i < 1000 && served.server.figures().refused == 0; ++i) {
    std::this_thread::sleep_for(10ms);
  }
  EXPECT_GT(served.server.figures().refused, 0U);
  // While they are there nobody else can be, and afterwards anybody.
  std::string status;
  for (int i = 0; i < 1000 && status != "HTTP/1.1 200 OK\r\n"; ++i) {
    std::this_thread::sleep_for(20ms);
    status = served.status_of("GET", "/", served.host);
  }
  EXPECT_EQ(status, "HTTP/1.1 200 OK\r\n");
}

TEST(LiveServer, APartOfThePageThatIsAskedForAThousandTimesIsThePageOnce) {
  const Served served;
  Browser browser{served.port};
  std::string ranges = "bytes=0-";
  for (int i = 0; i < 1000; ++i) {
    ranges += ",0-";
  }
  browser.ask("GET / HTTP/1.1\r\nHost: " + served.host + "\r\nRange: " + ranges + "\r\n\r\n");
  const std::string head = browser.read_to("\r\n\r\n");
  EXPECT_TRUE(head.starts_with("HTTP/1.1 200 OK\r\n")) << head;
  EXPECT_EQ(browser.read_to("never"), "<p>the page</p>");
}

TEST(LiveServer, AnAddressThatIsTakenIsSaidAndNotShared) {
  const Served served;
  try {
    const Server second{{.port = served.port}, {}, [] { return std::string{}; }};
    FAIL() << "two servers at one port";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string{error.what()}.find("another program uses this port"), std::string::npos) << error.what();
    EXPECT_NE(std::string{error.what()}.find(std::to_string(served.port)), std::string::npos) << error.what();
  }
  EXPECT_THROW((Server{{.host = "192.0.2.1", .port = 0}, {}, [] { return std::string{}; }}), std::runtime_error)
      << "an address that no computer has";
}

TEST(LiveServer, EndsWithViewersThatWait) {
  auto served = std::make_optional<Served>();
  Browser browser = served->open("/events");
  served->wait_for_viewers(1);
  served.reset();
  EXPECT_NE(browser.read_to("never").find("hello"), std::string::npos)
      << "what was sent before is there, and then the end";
  EXPECT_EQ(Served{}.status_of("GET", "/", "x"), "HTTP/1.1 403 Forbidden\r\n") << "and the next one can begin";
}

}  // namespace
}  // namespace fantail::live
