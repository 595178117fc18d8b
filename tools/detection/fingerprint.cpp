// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "detection/campaign.hpp"
#include "detection/rehearsal.hpp"
#include "text/sha256.hpp"

namespace fantail::detection {
namespace {

class Digest {
 public:
  template <typename T>
  void take(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto bytes = std::as_bytes(values);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  template <typename T>
  void take(const T& value) {
    take(std::span<const T>{&value, 1});
  }
  [[nodiscard]] std::string text() const { return text::sha256(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

void take(Digest& digest, const Motion& motion, const Readings& readings) {
  for (const auto* values : {&motion.axial_m_s2, &motion.across_m_s2, &motion.carried, &motion.pitch_rate_rad_s,
                             &readings.axial_m_s2[0], &readings.axial_m_s2[1]}) {
    digest.take(std::span{values->data(), motion.length});
  }
  for (const auto& quality : readings.quality) {
    digest.take(std::span{quality.data(), motion.length});
  }
  digest.take(motion.start_pitch_rad);
  digest.take(readings.errors.bias_m_s2);
  digest.take(readings.errors.gyro_bias_rad_s);
}

void take(Digest& digest, const Answer& answer) {
  constexpr std::size_t never = SIZE_MAX;
  digest.take(answer.detected.value_or(never));
  digest.take(answer.controlling.value_or(never));
  digest.take(answer.crossing.value_or(never));
  digest.take(answer.nearness);
  digest.take(answer.distance_error_m);
}

}  // namespace

std::string fingerprint(std::span<const Rule> rules) {
  constexpr std::array<std::uint64_t, 2> events{0, 5};  // with both accelerometers well, and with one stuck
  Rehearsal rehearsal{rules};
  Digest digest;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (const std::uint64_t event : events) {
      const std::vector<Answer>& answers = rehearsal.play(0, static_cast<Kind>(kind), event, Path::full);
      take(digest, rehearsal.motion(), rehearsal.readings());
      for (const Answer& answer : answers) {
        take(digest, answer);
      }
    }
  }
  return digest.text();
}

}  // namespace fantail::detection
