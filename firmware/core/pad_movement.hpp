// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/vector3.hpp"

namespace fantail::core {

/// Has a rocket that waits for its launch moved without one? Then it may have flown, or somebody may have raised its
/// rail, and what is known of its attitude no longer holds.
///
/// It has moved when it has turned by 10 degrees, has been pushed for 3 s, has not been supported for 0.3 s, or was
/// not measured for 5 s. It has fallen when it was weightless for 0.8 s, less the time in between: a drop from the
/// hands is shorter, the coast of every flight is longer. Only rest ends either.
///
/// A launch itself is a push; while it lasts, turning does not count, so that a launch that is detected late is not
/// lost. 3 s are longer than the slowest detection of a motor that a launch guide allows.
class PadMovement {
 public:
  /// Means over a tenth of a second. `rate_rad_s`: bias taken off, zero while no bias is known.
  void take(float length_s, const Vector3& rate_rad_s, const Vector3& specific_force_m_s2);

  /// A tenth of a second without a sample.
  void miss();

  /// Nobody watched, or what looked like a launch was none.
  void require_rest() { moved_ = true; }

  /// The attitude has been taken anew, and the rocket has not moved since.
  void rest() {
    turn_y_rad_ = turn_z_rad_ = 0.0F;
    moved_ = fallen_ = false;
  }

  /// False for what lies, hangs or falls, however still it is.
  [[nodiscard]] bool is_supported() const { return unsupported_ < blocks_of_no_support; }

  [[nodiscard]] bool has_moved() const { return moved_; }    ///< and has not rested since
  [[nodiscard]] bool has_fallen() const { return fallen_; }  ///< likewise

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(turn_y_rad_, turn_z_rad_, pushed_, unsupported_, weightless_, missed_, moved_, fallen_);
  }

 private:
  static constexpr std::uint32_t blocks_of_no_support = 3;

  float turn_y_rad_ = 0.0F;  ///< since the last rest; what is long ago counts less and less
  float turn_z_rad_ = 0.0F;
  std::uint32_t pushed_ = 0;  ///< blocks in a row, as the following
  std::uint32_t unsupported_ = 0;
  std::uint32_t weightless_ = 0;
  std::uint32_t missed_ = 0;
  bool moved_ = false;
  bool fallen_ = false;
};

}  // namespace fantail::core
