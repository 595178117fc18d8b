// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "benchmark/identify_record.hpp"

// Writes the task of one sample rate to standard output, for the solvers that are not C++.
int main(int argc, char** argv) {
  using namespace fantail;
  const std::string rate = argc == 2 ? argv[1] : "";
  if (rate != "100" && rate != "1000") {
    std::cerr << "usage: write_identify_task 100|1000\n";
    return 64;
  }
  const benchmark::IdentifyTask& task =
      benchmark::identify_task(rate == "100" ? benchmark::SampleRate::hz_100 : benchmark::SampleRate::hz_1000);
  const identify::model::Record& record = task.record;
  const identify::model::Grid grid;
  const nlohmann::json json{{"time_s", record.time_s},
                            {"roll_angle_rad", record.roll_angle_rad},
                            {"roll_rate_rad_s", record.roll_rate_rad_s},
                            {"canard_rad", record.canard_rad},
                            {"speed_m_s", record.speed_m_s},
                            {"density_kg_m3", record.density_kg_m3},
                            {"inertia_kg_m2", task.airframe.inertia_kg_m2},
                            {"reference_area_m2", task.airframe.reference_area_m2},
                            {"node_time_s", task.node_time_s},
                            {"alpha_m2", grid.alpha_m2.values()},
                            {"beta_m", grid.beta_m.values()},
                            {"some_alpha_m2", task.some_points.alpha_m2.values()},
                            {"some_beta_m", task.some_points.beta_m.values()},
                            {"mean_abs_angle_error_rad", task.expected.errors.mean_abs_angle_error_rad}};
  std::cout << json << '\n';
  return std::cout ? EXIT_SUCCESS : 74;
}
