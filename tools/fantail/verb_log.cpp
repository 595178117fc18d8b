// SPDX-License-Identifier: MIT
#include "fantail/log_info.hpp"
#include "fantail/run.hpp"
#include "telemetry/url.hpp"

namespace fantail::tool {

namespace {

void fill(const Verb& verb) {
  verb.needs_verb();
  verb.examples(
      "Examples:\n"
      "  fantail log info out/tasha3_launch2    vehicle and plan, is it intact, does a replay agree\n"
      "  fantail log info flash.ftl --flight 2  one of several flights from a board's flash\n"
      "  fantail log info flown.ftl --json      every figure and every event, for a script");
  add_log_info(verb);
  add_log_export(verb);
}

const VerbCode code{"log", fill};

}  // namespace
}  // namespace fantail::tool
