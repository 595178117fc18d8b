// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "identify/model/roll_model.hpp"
#include "identify/result/agreement.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify {

/// One alpha and one beta for all windows of all studies; disturbance, first angle and rate, and a fitted lag are each
/// window's own. Each window pulls at alpha and beta as its least squares do, weighed with the inverse of the
/// covariance that its own noise, memory included, leaves them: so the result is known at least as well as from any of
/// the windows alone. Takes studies of the open loop with one continuous result and its uncertainty a window, two
/// windows or more in all. Throws text::Error (bad_configuration) when their reference areas differ: alpha and beta
/// then count with different ones.
[[nodiscard]] result::JointFindings fit_jointly(const std::vector<result::Study>& studies);

}  // namespace fantail::identify
