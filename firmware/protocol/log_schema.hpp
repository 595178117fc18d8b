// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::protocol {

/// What lies where in the payloads of this version's ticks, events and health records: text that goes into every
/// header, so that a reader which knows nothing of this version can still show each value. One line a record ("tick
/// 50": its size), then a line for each of its values, with its offset, type, name and unit:
///   u8 u16 u32 i16 f32   a number
///   u16:9.3              three bits from bit 9 on
[[nodiscard]] std::string_view log_schema();

/// With a record second_gyro, which stands behind each tick, in its payload.
[[nodiscard]] std::string_view log_schema_of_two_gyros();

/// What follows in a log with a barometer: a record barometer, which stands behind all else in the payloads of those
/// ticks in which it had something new. Such a tick is so many bytes longer.
[[nodiscard]] std::string_view log_schema_of_barometer();

}  // namespace fantail::protocol
