// SPDX-License-Identifier: MIT
#include "image_identity.hpp"

#include <string_view>

#include <fmt/format.h>

#include "board.hpp"
#include "text/error.hpp"

namespace fantail::board {
namespace {

constexpr double most_words_s = 0.5;

}  // namespace

ImageIdentity identity_of(const Image& image, const Pace& pace) {
  Board board{image, pace};
  board.switch_on();
  const auto line_ends = [&board] {
    const std::size_t begin = board.console.find("Fantail ");
    return begin == std::string::npos ? begin : board.console.find('\n', begin);
  };
  while (line_ends() == std::string::npos && board.now_s() < most_words_s) {
    board.run_until(board.now_s() + 1e-3);
  }
  constexpr std::string_view before = "Fantail ";
  constexpr std::string_view between = ", git ";
  const std::size_t begin = board.console.find(before);
  const std::size_t middle = board.console.find(between, begin);
  if (line_ends() == std::string::npos || middle == std::string::npos) {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: the image has not said what it is in {} s; {}",
                                                             image.file().string(), most_words_s, board.state(image))};
  }
  const std::size_t hash = middle + between.size();
  return {.version = board.console.substr(begin + before.size(), middle - begin - before.size()),
          .git_hash = board.console.substr(hash, line_ends() - hash)};
}

}  // namespace fantail::board
