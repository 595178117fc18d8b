// SPDX-License-Identifier: MIT
#include "fantail/offers.hpp"
#include "fantail/run.hpp"
#include "fantail/tunnel_options.hpp"

namespace fantail::tool {

void add_tunnel_output(const Verb& verb, TunnelOutput& output, const std::string& default_folder) {
  verb.option("--out", output.out, "Folder for the results [" + default_folder + "]").offers(folders);
  verb.flag("--json", output.json, "Print the JSON instead of the text");
}

Delivery delivery(const TunnelOutput& output, const std::string& default_folder, const std::string& name,
                  const std::vector<std::filesystem::path>& made_from, const std::vector<std::string>& shown_files) {
  return {.folder = output.out.empty() ? default_folder : output.out,
          .name = name,
          .page = "report",
          .inputs = made_from,
          .json = output.json,
          .shown_files = shown_files};
}

void add_steady_option(const Verb& verb, const std::string& name, std::string& stretches, const std::string& meaning) {
  verb.option(name, stretches, meaning)
      .check([](const std::string& text) {
        return tunnel::parse_stretches(text) ? std::string{}
                                             : '"' + text +
                                                   "\" is not a list of increasing times in seconds, as in "
                                                   "100,230,390 or 100:140,230:290";
      })
      .value_name("T,T,...");
}

tunnel::SteadySegments steady_segments(const tunnel::TunnelLog& log, const std::string& stretches,
                                       const tunnel::SteadyOptions& options) {
  return stretches.empty() ? tunnel::find_steady(log, options)
                           : tunnel::take_steady(log, *tunnel::parse_stretches(stretches), options);
}

namespace {

void fill(const Verb& verb) {
  verb.needs_verb();
  verb.examples(
      "Examples:\n"
      "  fantail tunnel flow out/tunnel_flow                                    how steady the wind is\n"
      "  fantail tunnel swirl out/tunnel_swirl_without out/tunnel_swirl_with    the swirl in degrees of fin offset\n"
      "  fantail tunnel steps out/tunnel_steps                                  the roll model of every step\n"
      "  fantail tunnel stability out/tunnel_stability                          is the pinned rocket stable?\n"
      "\n"
      "The simulated tunnel makes such logs. Its scenarios for fantail fly: tunnel_flow, tunnel_swirl_without,\n"
      "tunnel_swirl_with, tunnel_steps and tunnel_stability.");
  add_tunnel_flow(verb);
  add_tunnel_swirl(verb);
  add_tunnel_steps(verb);
  add_tunnel_stability(verb);
}

const VerbCode code{"tunnel", fill};

}  // namespace
}  // namespace fantail::tool
