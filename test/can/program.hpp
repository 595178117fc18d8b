// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "system/folder.hpp"
#include "system/process.hpp"

namespace fantail::test {

/// A program that runs while the test goes on, with a person at its keyboard. Killed with the object.
class Program {
 public:
  /// `program` is found through PATH.
  Program(const std::string& program, const std::vector<std::string>& arguments);
  /// The fantail program that this build made.
  explicit Program(const std::vector<std::string>& arguments) : Program{fantail_path(), arguments} {}
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// A line on its standard input.
  void type(const std::string& line) const;
  void close_input();
  /// Nothing happens when it has ended.
  void signal(int number);

  /// What it has written to standard output so far.
  [[nodiscard]] std::string said() const { return content(out_); }
  /// Waits until that holds `text`; false when it never does.
  [[nodiscard]] bool says(const std::string& text, std::chrono::milliseconds longest = std::chrono::minutes{1}) const;

  [[nodiscard]] bool ended();
  /// Waits for its end.
  [[nodiscard]] const Outcome& outcome();

 private:
  void await_its_end(int process);

  Folder folder_;
  std::string out_ = folder_ / "out";
  int keyboard_ = -1;
  std::mutex mutex_;
  std::condition_variable begun_;
  int process_ = 0;  ///< 0: not begun, or ended
  bool started_ = false;
  Outcome outcome_;
  std::thread runner_;
};

}  // namespace fantail::test
