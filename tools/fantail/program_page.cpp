// SPDX-License-Identifier: MIT
#include "fantail/help.hpp"
#include "manual/roff.hpp"

namespace fantail::tool {

using namespace manual;

std::string program_page(const Command& program, const std::string& date) {
  const Title title{.name = "fantail", .section = 1, .date = date, .version = FANTAIL_VERSION};
  std::string page = command_page(program, title, exit_codes);
  page += heading("TERMINALS");
  page += paragraph(sentence(
      "On a terminal lines are wrapped between words, at its width or at 120 columns. A table that is too wide leaves "
      "out columns and says which, or has its rows as sentences. Verdicts and phases, which say the same in words, are "
      "coloured where "
      "`NO_COLOR` is unset or empty and `TERM` is not `dumb`. Every verb has `--color`, which counts more. Output in a "
      "pipe or a file is never reformatted, and has no colours unless `--color always` asks for them."));
  page += heading("ENVIRONMENT");
  page += item(bold("FANTAIL_DATA"),
               roff("The folder of the shipped scenarios, vehicles, motors and plans, instead of the one that was "
                    "installed."));
  page += item(bold("COLUMNS"), roff("The width of a terminal that does not know its own."));
  page += item(bold("NO_COLOR"), sentence("When it is set to anything but nothing: no colours, unless `--color always` "
                                          "asks for them."));
  page += heading("FILES");
  page += item(italic("PREFIX/share/fantail"), roff("Shipped scenarios, vehicles, motors and plans; the CAN database; "
                                                    "the fields of the plan block; the LCM message types."));
  page += item(
      italic("PREFIX/libexec/fantail"),
      sentence("The program of each verb; and `with_vcan`, which runs a command beside two virtual CAN buses, also "
               "where the kernel has no CAN."));
  return tidied(page + see_also({"fantail-fly(1)", "fantail.toml(5)", "flight.ftl(5)"}));
}

}  // namespace fantail::tool
