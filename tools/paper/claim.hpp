// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::paper {

/// What came of one printed statement.
enum class Finding : std::uint8_t {
  reproduced,        ///< ours agrees within the tolerance that is stated
  differs,           ///< it does not, and the reason is given
  not_reproducible,  ///< it follows from measurements that were not published
  error_in_print,    ///< the publication contradicts itself or its own numbers
};

[[nodiscard]] std::string_view name(Finding finding);   ///< for files: "error_in_print"
[[nodiscard]] std::string_view words(Finding finding);  ///< for readers: "error in print"

/// What our side of a comparison rests on, and so what an agreement proves.
enum class Basis : std::uint8_t {
  derived,     ///< worked out from other printed numbers
  fitted,      ///< our simulation was adjusted to this number, or to one that it follows from
  round_trip,  ///< printed or assumed numbers put into our simulator and found again: it tests our analysis, not theirs
  none,        ///< nothing of ours stands beside it
};

[[nodiscard]] std::string_view name(Basis basis);   ///< for files: "round_trip"
[[nodiscard]] std::string_view words(Basis basis);  ///< for readers: "round trip"

/// One printed statement beside ours.
struct Claim {
  std::string place{};  ///< "Section 4.2", "Eq 38", "Table 2"
  std::string what{};
  std::string theirs{};
  std::string ours{};
  std::string difference{};
  Finding finding = Finding::reproduced;
  Basis basis = Basis::derived;
  std::string why{};  ///< the reason, or what the agreement rests on; may be empty when reproduced
};

/// A printed number and ours.
struct Numbers {
  std::string place{};
  std::string what{};
  double theirs = 0.0;
  double ours = 0.0;
  std::string unit{};
  int decimals = 2;
  double tolerance = 0.0;  ///< largest difference that counts as agreement
  Basis basis = Basis::derived;
  /// When it is larger: what the reason is. Without a reason it still is a difference, and the page says so.
  Finding otherwise = Finding::differs;
  std::string why_otherwise{};
  std::string remark{};  ///< when it agrees
};

[[nodiscard]] Claim compare(const Numbers& numbers);

/// A statement that rests on data nobody else has; `ours` says what a simulated stand-in gave, or is
/// empty.
[[nodiscard]] Claim unpublished(std::string place, std::string what, std::string theirs, std::string why,
                                std::string ours = {});

/// A slip of the print, and what it must read.
[[nodiscard]] Claim slip(std::string place, std::string what, std::string printed, std::string must_be,
                         std::string why);

struct Chapter {
  std::string title{};
  std::string introduction{};
  std::vector<Claim> claims{};
  std::vector<std::string> figures_html{};
};

}  // namespace fantail::paper
