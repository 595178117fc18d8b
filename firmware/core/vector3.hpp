// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::core {

/// Three components in the frame that the owner names. Body frame: `x` along the axis towards the nose, `y` and `z`
/// across; positive roll turns y towards z. Earth frame: z up.
struct Vector3 {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;

  /// See core/state_visitor.hpp.
  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(x, y, z);
  }
};

/// a - b, part by part, in their unit.
[[nodiscard]] constexpr Vector3 minus(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

}  // namespace fantail::core
