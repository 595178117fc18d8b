// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hal/sample.hpp"
#include "hal/servo.hpp"

namespace fantail::hal {

/// The reading of one encoder.
struct EncoderSample {
  std::uint16_t counts = 0;  ///< one turn is 16384, counted in the shaft's positive direction
  Status status = Status::no_reading;
};

/// Counts of a good reading are below it; what is not is taken for no reading.
inline constexpr std::uint16_t encoder_counts_per_turn = 16384;

/// The four canard shaft encoders, read together.
struct EncoderReading {
  Microseconds time{};  ///< when the encoders were asked for it
  std::array<EncoderSample, canards> each{};
};

/// The angle of each canard's shaft, over the whole turn.
class Encoder {
 public:
  virtual ~Encoder() = default;
  /// The latest reading. Never waits.
  virtual EncoderReading read() = 0;
};

}  // namespace fantail::hal
