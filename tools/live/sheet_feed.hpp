// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "core/inputs.hpp"
#include "json/value.hpp"
#include "live/plot_history.hpp"

namespace fantail::live {

/// Turns what a bench does with the canards of a rocket into frames for its page: their angles, what is done now, and
/// the sheet as far as it is filled. Every function for any thread.
class SheetFeed {
 public:
  template <typename T>
  using Each = std::array<T, core::canard_count>;

  /// Before the first angle.
  void begin(double duration_s, const Each<double>& limit_rad);
  /// `time_s` since the beginning, by the rocket's clock; `done_s` of the exercise are done, less on a slow PC. `now`
  /// is what is done, in words.
  void move(double time_s, double done_s, std::string_view now, const Each<std::optional<double>>& command_rad,
            const Each<std::optional<double>>& encoder_rad);
  /// HTML, trusted: it is put into the page as it is.
  void fill(std::string html);
  /// Nothing moves any more. `why` it ended early, for people; empty: it did not.
  void end(std::string why = {});

  /// One line of JSON; the sheet is in it when it is new.
  [[nodiscard]] std::string frame();
  /// For a new viewer: everything in the frames so far.
  [[nodiscard]] std::string greeting() const;

 private:
  // Canard 1's command and encoder, canard 2's, ...
  static constexpr std::size_t signal_count = 2 * core::canard_count;
  static constexpr hal::Microseconds longest{120'000'000};
  [[nodiscard]] json::Value now_json() const;

  mutable std::mutex mutex_;
  PlotHistory plots_{signal_count, longest};
  double duration_s_ = 0.0;
  Each<double> limit_rad_{};
  double done_s_ = 0.0;
  std::string now_;
  Each<std::optional<double>> command_rad_{};
  Each<std::optional<double>> encoder_rad_{};
  std::string sheet_html_;
  bool sheet_is_new_ = false;
  bool ended_ = false;
  std::string why_;
  std::uint64_t number_ = 0;  ///< of the last frame
};

}  // namespace fantail::live
