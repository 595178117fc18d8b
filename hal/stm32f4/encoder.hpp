// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/board.hpp"
#include "hal/clock.hpp"
#include "hal/encoder.hpp"
#include "hal/stm32f4/spi_bus.hpp"

namespace fantail::hal::stm32f4 {

/// Four AS5047P on one bus, one frame of 16 bits each in a tick. What comes back answers the frame of the tick before:
/// an angle is as old as the tick is long, and the time of a reading is that of the read() that asked. (Two frames in
/// one tick would give a fresh one; a servo moves at most a few tenths of a degree in a millisecond.)
///
/// Each encoder is on its own: whatever one answers, the others are read. In one tick of 128 an encoder is asked for
/// its diagnosis instead, because an angle does not tell that the magnet is gone; its last angle then comes again.
class Encoder final : public hal::Encoder {
 public:
  /// Which shafts turn against their encoder's sense.
  using Reversed = std::array<bool, canards>;

  /// The bus of the devices and the clock outlive this object.
  Encoder(const std::array<SpiDevice, canards>& devices, const hal::Clock& clock, const Reversed& reversed = {})
      : devices_{devices}, clock_{clock}, reversed_{reversed} {}

  /// Once a tick. Nothing is known yet at the first.
  EncoderReading read() override;
  /// Does one of them not answer? After power-up they have 20 reads to begin.
  [[nodiscard]] BoardFaults faults() const;

  static constexpr std::uint8_t diagnosis_period = 128;

 private:
  enum class Request : std::uint8_t { nothing, angle, errors, diagnosis };
  struct Channel {
    Request asked = Request::nothing;  ///< in the frame before this one
    bool flagged = false;              ///< it has set its error flag, and ERRFL is to be read
    bool magnet_ok = true;
    std::uint16_t angle = 0;  ///< the last good one, in the encoder's own sense
    std::uint8_t zeros = 0;   ///< answers of all zeros, one after the other
    std::uint8_t silent = 0;  ///< reads without an answer, one after the other
    Status status = Status::no_reading;
  };

  [[nodiscard]] Request next_request(std::size_t which) const;
  std::optional<std::uint16_t> exchange(std::size_t which, Request request);
  static void judge(Channel& channel, std::optional<std::uint16_t> frame, Request sent);
  static Status judge_angle(Channel& channel, std::uint16_t frame);
  static bool may_be_zero(const Channel& channel);

  std::array<SpiDevice, canards> devices_;
  const hal::Clock& clock_;
  Reversed reversed_;
  std::array<Channel, canards> channels_{};
  std::uint8_t tick_ = 0;
  Microseconds asked_at_{};
};

}  // namespace fantail::hal::stm32f4
