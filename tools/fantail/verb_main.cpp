// SPDX-License-Identifier: MIT
#include "fantail/run.hpp"

int main(int argc, char** argv) { return fantail::tool::run(*fantail::tool::VerbCode::first, argc, argv); }
