// SPDX-License-Identifier: MIT
#include <memory>
#include <string>

#include "fantail/command_line.hpp"
#include "fantail/deliver.hpp"
#include "fantail/log_options.hpp"
#include "fantail/offers.hpp"
#include "fantail/tunnel_options.hpp"
#include "tunnel/flow.hpp"

namespace fantail::tool {
namespace {

constexpr const char* default_folder = "out/tunnel/flow";

struct FlowOptions {
  std::string log;
  ColumnOptions columns;
  std::string steady;
  tunnel::SteadyOptions finding;
  TunnelOutput output;
};

void flow(const FlowOptions& options) {
  const tunnel::TunnelLog log =
      tunnel::read_tunnel_log(options.log, sources(options.columns, "--", tunnel::tunnel_quantities));
  const tunnel::Flow flow = tunnel::examine_flow(log, steady_segments(log, options.steady, options.finding));
  deliver(tunnel::flow_answer(log, flow, made_with({options.log})),
          delivery(options.output, default_folder, "flow", {options.log}));
}

}  // namespace

void add_tunnel_flow(const Verb& tunnel) {
  auto verb = tunnel.verb("flow", "Steady speeds, turbulence, and the fit of speed to fan rpm");
  auto options = std::make_shared<FlowOptions>();
  verb.option("LOG", options->log, "A CSV with time_s, fan_rpm and wind_speed_m_s, or a folder with a tunnel.csv")
      .offers(files)
      .required();
  add_steady_option(verb, "--steady", options->steady,
                    "Steady times, instead of finding them: beginnings in seconds, each until the fan's next set "
                    "point, or begin:end");
  verb.option("--shortest", options->finding.shortest_s, "Shortest steady period")
      .check(within(0.0, 1e6))
      .value_name("S")
      .show_default();
  verb.option("--rpm-tolerance", options->finding.rpm_tolerance,
              "A change of the fan reading beyond this is a new set point")
      .check(within(0.0, 1e4))
      .value_name("RPM")
      .show_default();
  add_tunnel_columns_option(verb, options->columns);
  add_tunnel_output(verb, options->output, default_folder);
  verb.examples(
      "Examples:\n"
      "  fantail tunnel flow out/tunnel_flow                        the session of fantail fly tunnel_flow\n"
      "  fantail tunnel flow kestrel.csv --columns wind_speed=WS:m/s --steady 100,230,390,550,718,858\n"
      "                                                             another logger's file, times by hand\n"
      "  fantail tunnel flow out/tunnel_flow --json                 for a script");
  verb.action([options] { flow(*options); });
}

}  // namespace fantail::tool
