// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace fantail::tool {

struct VerbEntry {
  std::string_view group;
  std::string_view name;
  std::string_view meaning;
  bool is_installed = true;
};

/// Every verb, in the order in which the help lists them, group by group. Each is a program fantail-NAME. One
/// that is not installed is built in the sources alone, and has no page of the manual.
inline constexpr std::array verb_table{
    VerbEntry{"Your rocket", "new", "Make vehicle, plan and scenario of a new rocket from its shape or design"},
    VerbEntry{"Your rocket", "airframe", "Compute stability, roll damping, canard torque and inertia from a shape"},
    VerbEntry{"Your rocket", "plan", "Check, show or pack a flight plan"},
    VerbEntry{"Your rocket", "tune", "Find gains for a rocket, fly them over its spread, and write the plan"},
    VerbEntry{"Flights", "fly", "Fly a scenario in the simulator with the flight code"},
    VerbEntry{"Flights", "predict", "Fly a launch over the spread of its tunnel results: go or no-go"},
    VerbEntry{"Flights", "campaign", "Fly a scenario thousands of times over uncertain values, or with failed devices"},
    VerbEntry{"Flights", "brief", "Write one printable page on a rocket for the range safety officer"},
    VerbEntry{"Flights", "report", "Write a page on a logged flight, or on two side by side"},
    VerbEntry{"Flights", "rules", "Check a scenario or a flown log against the rules of a range or competition"},
    VerbEntry{"Flights", "replay", "Run the inputs of a recorded flight through the flight code again"},
    VerbEntry{"Logs and the roll model", "identify", "Find damping, torque constant and fin offset in a log"},
    VerbEntry{"Logs and the roll model", "tunnel", "Analyse a wind tunnel session: air, swirl, roll model, stability"},
    VerbEntry{"Logs and the roll model", "compare", "Compare the roll motions in two logs"},
    VerbEntry{"Logs and the roll model", "listen", "Run launch detection on an IMU log of any rocket"},
    VerbEntry{"Logs and the roll model", "log", "Show a flight log, or export it for other programs"},
    VerbEntry{"Logs and the roll model", "convert",
              "Convert a table (MAT, Parquet, Excel, HDF5, MCAP, ULog) to CSV, or back"},
    VerbEntry{"Logs and the roll model", "paper", "Repeat the published work (Bryson et al. 2016) and list its errors"},
    VerbEntry{"A rocket on the bench", "bench", "Check and command a rocket over CAN"},
    VerbEntry{"A rocket on the bench", "node",
              "Run the avionics on this PC in real time, on CAN, with a simulated rocket"},
    VerbEntry{"A rocket on the bench", "board", "Run the flight image on a virtual board in real time, on CAN", false},
    VerbEntry{"A rocket on the bench", "gateway",
              "Publish what a rocket reports on CAN as LCM messages; sends nothing on the bus"},
    VerbEntry{"A rocket on the bench", "watch", "Show LCM messages in a live panel: roll, canards, phase, link"},
};

/// An option of an earlier version, and what is said to somebody who gives it.
struct RemovedOption {
  std::string_view option;  ///< behind its verb
  std::string_view said;
};

inline constexpr std::array removed_options{
    RemovedOption{"fly --card", "draws no card.png any more: take a screenshot of report.html"},
    RemovedOption{"report --card", "draws no card.png any more: take a screenshot of report.html"},
};

}  // namespace fantail::tool
