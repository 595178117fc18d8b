// SPDX-License-Identifier: MIT
#pragma once

#include "page/chart.hpp"

namespace fantail::page {

/// Gives both axes of a map one span around all that its series show: a metre to the east is as long as one to the
/// north where the frame is square. Of series without a point nothing.
void give_one_scale(Chart& map);

}  // namespace fantail::page
