// SPDX-License-Identifier: MIT
#pragma once

#include "can/program.hpp"
#include "json/value.hpp"
#include "system/process.hpp"
#include "test.hpp"

namespace fantail::test {

[[nodiscard]] inline bool has_route() { return run("ip", {"route", "get", "239.255.76.67"}).exit_code == 0; }

/// What the message for people without a route tells them to do, done.
inline void follow_the_advice() {
  if (!has_route()) {
    EXPECT_EQ(run("ip", {"route", "add", "224.0.0.0/4", "dev", "lo"}).exit_code, 0);
  }
}

inline void take_the_route_away() {
  if (has_route()) {
    EXPECT_EQ(run("ip", {"route", "del", "224.0.0.0/4", "dev", "lo"}).exit_code, 0);
  }
}

/// Of each line that has come to its end.
[[nodiscard]] inline std::vector<json::Value> objects(const std::string& text) {
  std::vector<json::Value> all;
  std::istringstream lines{text.substr(0, text.rfind('\n') + 1)};
  for (std::string line; std::getline(lines, line);) {
    all.push_back(json::parse(line));
  }
  return all;
}

/// The texts of all events in them, in order.
[[nodiscard]] inline std::vector<std::string> events(const std::vector<json::Value>& objects) {
  std::vector<std::string> all;
  for (const auto& object : objects) {
    for (const auto& event : object["events"]) {
      all.push_back(event["text"].text());
    }
  }
  return all;
}

/// A total of the newest object: total(watch, "FANTAIL_STATE", "received").
[[nodiscard]] inline std::int64_t total(const std::vector<json::Value>& objects, const std::string& channel,
                                        const std::string& figure) {
  return objects.empty() ? 0 : static_cast<std::int64_t>(objects.back()["channels"][channel]["total"][figure].count());
}

/// fantail watch --json, already listening.
class Watcher {
 public:
  explicit Watcher(const std::string& url) : program_{{"watch", "--lcm", url, "--json"}} {
    EXPECT_TRUE(program_.says("\"link\"")) << program_.outcome().err;
  }
  [[nodiscard]] std::vector<json::Value> seen() const { return objects(program_.said()); }
  [[nodiscard]] Program& program() { return program_; }

 private:
  Program program_;
};

}  // namespace fantail::test
