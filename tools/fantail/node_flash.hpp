// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "hal/linux/file_flash.hpp"

namespace fantail::tool {

/// The flash of a board that is simulated on this PC; made, with its folder, when it is not there. Throws
/// text::OutputError.
[[nodiscard]] std::unique_ptr<hal::on_linux::FileFlash> open_node_flash(const std::filesystem::path& file);

}  // namespace fantail::tool
