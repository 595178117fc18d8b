// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "fantail/run.hpp"

namespace fantail::tool {

/// A stream that the caller closed would lend its number to the next file opened, and messages would land in results:
/// from here on writing to it fails instead. Broken pipes and file-size limits become write errors, which are reported,
/// instead of signals, which kill. Call it before anything else.
void guard_standard_streams();

/// Standard error, wrapped where that is a terminal, as far as it takes anything: a message that cannot be written must
/// not change the exit code.
void say(std::string_view text);

/// Who hears it from now on instead of standard error, of any thread; lines that are for now nobody does.
void hear_instead(std::function<void(std::string_view text)> listener);

/// A line on the terminal that standard error is, until the next such line or anything else is written there; an empty
/// one takes it away.
void say_for_now(std::string_view line);

/// False when standard output has lost anything of what was printed.
[[nodiscard]] bool output_was_taken();

/// To a program that has lost output: a full disk is a fault to tell of, a reader that has left (`| head`) has seen
/// enough and hears nothing.
[[nodiscard]] ExitCode complain_about_output();

/// Writes what a person is watching to standard output, at once. False: there is no use in going on. A reader that has
/// left has seen enough; that is no fault, and a full disk is one, which the end of the program will say.
[[nodiscard]] bool show_live(const std::string& text);

/// Lines from standard input, taken without ever waiting for them, so that a bus can be served meanwhile.
class LineInput {
 public:
  /// Without its end and without spaces around it; empty when no whole line is there yet.
  [[nodiscard]] std::optional<std::string> next();

  /// No more will come.
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  void read_what_is_there();

  std::string text_;
  bool ended_ = false;
};

}  // namespace fantail::tool
