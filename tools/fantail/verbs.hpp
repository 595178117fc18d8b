// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace fantail::tool {

// One file per verb. Each adds itself to the program; its callback throws what the program turns into an exit code.

void add_fly(CLI::App& program);
void add_identify(CLI::App& program);
void add_paper(CLI::App& program);
void add_plan(CLI::App& program);
void add_log(CLI::App& program);
void add_replay(CLI::App& program);
void add_node(CLI::App& program);
void add_bench(CLI::App& program);
void add_compare(CLI::App& program);
void add_tunnel(CLI::App& program);
void add_predict(CLI::App& program);
void add_gateway(CLI::App& program);
void add_watch(CLI::App& program);
void add_report(CLI::App& program);

}  // namespace fantail::tool
