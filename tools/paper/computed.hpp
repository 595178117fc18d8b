// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "paper/claim.hpp"
#include "paper/print.hpp"

namespace fantail::paper {

/// A printed number, and how the other printed ones give it. `ours` must not look at `theirs`; a test changes the
/// printed number and sees that ours stays.
struct Computed {
  const char* place;
  const char* what;
  Number theirs;
  double (*ours)(const Print& print);
  const char* unit = "%";
  int decimals = 1;
  double tolerance = 0.05;
  const char* why_otherwise = "";
  std::string (*remark)(const Print& print) = nullptr;
};

[[nodiscard]] std::span<const Computed> computed();

/// The only way to a row of the kind `computed`.
[[nodiscard]] Claim worked_out(const Computed& row, const Print& print);

}  // namespace fantail::paper
