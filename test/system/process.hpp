// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fantail::test {

/// What one run of a program came to.
struct Outcome {
  std::optional<int> exit_code;  ///< empty when a signal ended it
  int signal = 0;                ///< the one that ended it
  std::string out;
  std::string err;
};

struct Surroundings {
  std::filesystem::path working_folder = {};
  /// Runs in the new process before the program does: to close a stream, to set a limit.
  std::function<void()> prepare = {};
  /// Runs in the test while the program works.
  std::function<void(int process)> meanwhile = {};
  /// Standard error is a terminal; what the program writes to it is in `err` all the same.
  bool terminal = false;
  /// Set as soon as the program has written to standard error; for `meanwhile`.
  std::atomic<bool>* has_spoken = nullptr;
};

/// Runs the fantail program that this build made, standard input empty, and waits for its end. A run that takes longer
/// than four minutes is killed, so that a test fails instead of hanging.
[[nodiscard]] Outcome fantail(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

/// The same for any program, found through PATH.
[[nodiscard]] Outcome run(const std::string& program, const std::vector<std::string>& arguments,
                          const Surroundings& surroundings = {});

[[nodiscard]] std::string fantail_path();

/// For Surroundings::prepare: another file in the place of a standard stream.
[[nodiscard]] std::function<void()> redirect(int stream, const std::string& file);

}  // namespace fantail::test
