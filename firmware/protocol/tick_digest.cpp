// SPDX-License-Identifier: MIT
#include "protocol/tick_digest.hpp"

#include <bit>
#include <concepts>
#include <optional>

#include "core/tick_record_fields.hpp"

namespace fantail::protocol {
namespace {

// One multiplication a word: a tick has fifty of them, and a checksum that sees bursts of errors is what the frame has.
class Digest {
 public:
  void operator()(const core::SignalName&, float value) { word(std::bit_cast<std::uint32_t>(value)); }
  void operator()(const core::SignalName&, core::Angle value) { word(std::bit_cast<std::uint32_t>(value.radians())); }
  void operator()(const core::SignalName&, bool value) { word(value ? 1U : 0U); }
  void operator()(const core::SignalName&, std::uint32_t value) { word(value); }
  void operator()(const core::SignalName&, core::Microseconds value) {
    const auto bits = static_cast<std::uint64_t>(value.count());
    word(static_cast<std::uint32_t>(bits));
    word(static_cast<std::uint32_t>(bits >> 32U));
  }
  void operator()(const core::SignalName& name, const std::optional<core::Angle>& value) {
    (*this)(name, value.has_value());
    (*this)(name, value.value_or(core::Angle{}));
  }
  // A rocket with one gyro has no such signal.
  template <typename T>
    requires std::is_enum_v<T>
  void operator()(const core::SignalName& name, const std::optional<T>& value) {
    if (value) {
      (*this)(name, *value);
    }
  }
  template <typename Enumeration>
    requires std::is_enum_v<Enumeration>
  void operator()(const core::SignalName&, Enumeration value) {
    word(static_cast<std::uint32_t>(value));
  }

  [[nodiscard]] std::uint32_t result() const { return state_ ^ (state_ >> 16U); }

 private:
  // Each step can be undone, so a change of one word is never lost on the way.
  void word(std::uint32_t value) {
    state_ = (state_ ^ value) * 0x9E3779B1U;
    state_ ^= state_ >> 15U;
  }

  std::uint32_t state_ = 0x2545F491U;
};

}  // namespace

std::uint32_t tick_digest(const core::TickRecord& record) {
  Digest digest;
  core::visit_signals(record, digest);
  return digest.result();
}

}  // namespace fantail::protocol
