// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "fantail/deliver.hpp"
#include "tunnel/steady.hpp"

namespace fantail::tool {

/// Where results of a tunnel verb go.
struct TunnelOutput {
  std::string out;
  bool json = false;
};

/// --out and --json.
void add_tunnel_output(const Verb& verb, TunnelOutput& output, const std::string& default_folder);

/// The page is report.html, whatever the `name` of the JSON. `made_from`: logs that must not be overwritten, nor
/// written into.
[[nodiscard]] Delivery delivery(const TunnelOutput& output, const std::string& default_folder, const std::string& name,
                                const std::vector<std::filesystem::path>& made_from,
                                const std::vector<std::string>& shown_files = {"page"});

/// A list of steady stretches by hand.
void add_steady_option(const Verb& verb, const std::string& name, std::string& stretches, const std::string& meaning);

/// By hand where there is a list, else found.
[[nodiscard]] tunnel::SteadySegments steady_segments(const tunnel::TunnelLog& log, const std::string& stretches,
                                                     const tunnel::SteadyOptions& options);

// Each verb of the tunnel in a file of its own.
void add_tunnel_flow(const Verb& tunnel);
void add_tunnel_swirl(const Verb& tunnel);
void add_tunnel_steps(const Verb& tunnel);
void add_tunnel_stability(const Verb& tunnel);

}  // namespace fantail::tool
