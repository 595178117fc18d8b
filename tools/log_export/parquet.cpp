// SPDX-License-Identifier: MIT
#include "log_export/about.hpp"
#include "log_export/formats.hpp"
#include "log_export/tick_columns.hpp"
#include "table_file/parquet_writer.hpp"

namespace fantail::log_export {

std::string parquet(const ReplayedFlight& source, const Selection& selection) {
  return table_file::parquet::file(tick_columns(source, selection), about(source, selection).dump());
}

}  // namespace fantail::log_export
