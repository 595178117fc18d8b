// SPDX-License-Identifier: MIT
#include "resets.hpp"

#include <cstddef>
#include <cstdint>

#include "text/error.hpp"

namespace fantail::board {
namespace {

constexpr std::uint32_t nowhere = 0x3000'0000;
constexpr std::uint32_t stack_bottom = 0x2000'0000;

// `b .`: 0xE7FE
std::uint32_t endless_loop(const Image& image) {
  for (std::uint32_t at = 0; at + 1 < image.flash().size(); at += 2) {
    if (image.flash()[at] == std::byte{0xFE} && image.flash()[at + 1] == std::byte{0xE7}) {
      return Image::flash_begin + at;
    }
  }
  throw text::Error{text::ErrorKind::bad_data, image.file().string() + ": no endless loop is in it"};
}

}  // namespace

std::vector<ResetCase> all_resets(const Image& image) {
  const std::uint32_t loop = endless_loop(image);
  return {
      {"hang", [loop](Board& board) { board.processor.jump(loop, false); }, true},
      {"hang, interrupts masked", [loop](Board& board) { board.processor.jump(loop, true); }, true},
      {"jump to nowhere", [](Board& board) { board.processor.jump(nowhere, false); }, true},
      {"stack overflow", [](Board& board) { board.processor.move_stack(stack_bottom + 8); }, true},
      {"crystal stops", [](Board& board) { board.set_crystal(false); }, true},
      {"brown-out", [](Board& board) { board.reset(ResetKind::brown_out); }, false},
      {"reset button", [](Board& board) { board.reset(ResetKind::pin); }, false},
      {"power cut",
       [](Board& board) {
         board.flash.cut_power(board.timeline.counts());  // how far it came is chance
         board.reset(ResetKind::power_on);
       },
       false},
  };
}

}  // namespace fantail::board
