// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tunnel/flow.hpp"

namespace fantail::tunnel {

// What `fantail tunnel flow` says, three times: for the terminal, for a script, and as a page with pictures.

[[nodiscard]] std::string flow_text(const TunnelLog& log, const Flow& flow);
[[nodiscard]] std::string flow_json(const TunnelLog& log, const Flow& flow);
[[nodiscard]] std::string flow_html(const TunnelLog& log, const Flow& flow);

}  // namespace fantail::tunnel
