// SPDX-License-Identifier: MIT
// export_samples FOLDER: one log made by hand, in every format that another program is to read.
#include <fstream>
#include <string>

#include "log_export/formats.hpp"
#include "made_flight.hpp"

int main(int argc, char** argv) {
  using namespace fantail::log_export;
  if (argc != 2) {
    return 64;
  }
  const MadeFlight made;
  const ReplayedFlight source = made.source();
  const auto write = [&](const char* name, const std::string& content) {
    std::ofstream{std::string{argv[1]} + "/" + name, std::ios::binary} << content;
  };
  write("fields.csv", csv(source, every_field(source)));
  write("flight.csv", flight_csv(source, made.report));
  write("flight.ulg", ulog(source, every_field(source)));
  write("flight.log", candump(source));
  write("flight.lcmlog", lcm(source));
  write("flight.mat", mat(source, every_field(source)));
  write("flight.mcap", mcap(source, every_field(source)));
  write("flight.parquet", parquet(source, every_field(source)));
  write("flight.json", json(source, every_field(source)));
}
