// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace fantail::tool {

struct VerbEntry {
  std::string_view name;
  std::string_view meaning;
};

/// Every verb, in the order in which the help lists them. Each is a program fantail-NAME.
inline constexpr std::array verb_table{
    VerbEntry{"fly", "Fly a scenario through the real control code in the simulated world"},
    VerbEntry{"identify", "Find damping, torque constant and disturbance in a log"},
    VerbEntry{
        "paper",
        "Repeat the published work (Bryson et al. 2016) from its printed numbers, and say where the print is wrong"},
    VerbEntry{"plan", "Check, show or pack a flight plan"},
    VerbEntry{"log", "What is in a flight log, and other formats of it"},
    VerbEntry{"convert", "A table of another program (MAT, Parquet, Excel, HDF5, MCAP, ULog) as CSV, or the other way"},
    VerbEntry{"listen",
              "Fly somebody's IMU log through the flight law: what it would have taken for a launch, and when"},
    VerbEntry{"replay", "Run a recorded flight's inputs through the flight law again"},
    VerbEntry{"node",
              "Run the avionics on this PC in real time: a simulated rocket behind it, a real CAN bus in front"},
    VerbEntry{"bench", "Check and command a rocket over CAN"},
    VerbEntry{"compare", "How far the roll motions in two logs are apart"},
    VerbEntry{"tunnel", "What a session in the wind tunnel says: air, swirl, roll model"},
    VerbEntry{"predict", "Fly a launch over the spread of its tunnel results: go or no go"},
    VerbEntry{"campaign",
              "Fly a scenario thousands of times over what is not known: how often it holds, and what matters"},
    VerbEntry{"tune", "Find gains for a rocket by its roll model and its spread, fly them, and write the plan"},
    VerbEntry{"gateway",
              "From a CAN bus to LCM messages: what the avionics says, for everyone on the network. Sends nothing on "
              "the bus"},
    VerbEntry{"watch",
              "Roll, canards, phase, health and the quality of the link, live from LCM messages; a line a second in a "
              "pipe, and one for every event"},
    VerbEntry{"airframe", "What a vehicle's shape and parts give: stability, roll damping, canard torque, inertia"},
    VerbEntry{"new", "Make vehicle, plan and scenario of a new rocket from its shape"},
    VerbEntry{"report", "A page on a flight that was logged, or on two beside each other"},
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
