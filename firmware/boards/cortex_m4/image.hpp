// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::boards {

/// Is the image in the processor's flash the one that was built? Its last word is the CRC-32C of everything before it.
[[nodiscard]] bool image_is_intact();

}  // namespace fantail::boards
