// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "table_file/column.hpp"

namespace fantail::listen {

/// What a ULog of PX4 says of the motion.
struct UlogColumns {
  table_file::Columns columns{};  ///< "timestamp" in microseconds first; of a row what its topic does not have is NaN
  std::vector<std::string> notes{};  ///< a sentence each: where it is cut off or damaged, what the logger dropped
};

/// The topics sensor_combined and vehicle_air_data (their first instances): every field that is a number, arrays as
/// gyro_rad[0], gyro_rad[1]; a row for each message, in order of time. The format is that of
/// https://docs.px4.io/main/en/dev_log/ulog_file_format.html, version 0 and 1.
///
/// A file that is cut off is read up to there. Behind a message that cannot be one (of no known type, of a topic that
/// nobody subscribed to, of another size than its format) it is read on from the next sync message, if there is one.
/// `name` is what messages call the file. Throws text::Error (bad_data): no ULog, no message of sensor_combined (naming
/// the topics that are there), time that goes back within a topic, but for single messages, one in a hundred at most.
[[nodiscard]] UlogColumns read_ulog(std::string_view file, const std::string& name);

}  // namespace fantail::listen
