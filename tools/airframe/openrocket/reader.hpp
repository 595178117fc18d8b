// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "airframe/openrocket/component.hpp"
#include "airframe/openrocket/read.hpp"

namespace fantail::airframe::openrocket {

// No rocket of this kind comes near.
inline constexpr double longest_m = 30.0;
inline constexpr double widest_m = 1.0;  ///< radius
inline constexpr double heaviest_kg = 1000.0;
inline constexpr double a_millimetre_m = 0.001;

/// Where a component is: what its children count from.
struct Place {
  double begin_m = 0.0;
  double length_m = 0.0;
  double outer_m = 0.0;  ///< radius
  double inner_m = 0.0;
};

/// What a person has written over a component's mass and centre of gravity, alone or with all that is inside it.
struct Overrides {
  std::optional<double> mass_kg;
  std::optional<double> centre_m;  ///< from the tip of the nose
  bool mass_is_of_all = false;
  bool centre_is_of_all = false;
};

/// The component begins at `begin_m`.
[[nodiscard]] Overrides overrides_of(const Component& c, double begin_m);

/// Tubes side by side, all alike.
struct Cluster {
  int count = 1;
  double ring_m = 0.0;  ///< root mean square of their distances from the middle of all
};

/// Of an inner tube of this radius. Throws text::Error for one that no version has.
[[nodiscard]] Cluster cluster_of(const Component& c, double outer_m);

/// Walks through the components of one stage from nose to tail and adds them to a design.
class Reader {
 public:
  /// `canards`: the name of the fins that are the canards; empty: they are chosen.
  Reader(std::filesystem::path file, std::string canards, Design& design)
      : file_{std::move(file)}, canards_{std::move(canards)}, design_{design} {}

  /// The first stage of a rocket.
  void read(pugi::xml_node rocket);

 private:
  using Masses = std::vector<sim::Geometry::Mass>;

  // The body, one behind the other.
  void add_nose(const Component& c);
  void add_tube(const Component& c);
  void add_transition(const Component& c, pugi::xml_node behind);
  void step_to(const Component& c, double radius_m);
  [[nodiscard]] double radius_behind(const Component& c, pugi::xml_node behind) const;
  void check_places();
  void join_single_fins();
  void choose_fins();
  void choose_canards();
  void leave_out(const Component& c, const std::string& what, bool is_force);

  void weigh_whole(const Component& c);
  void apply_overrides(const Component& c, const Overrides& o, sim::Geometry::Mass& own, Masses& children);

  // What is inside or on it.
  /// The component's own part and those of its children, after its overrides.
  void add_with_children(const Component& c, const Place& place, sim::Geometry::Mass own, Masses& into);
  void add_child(const Component& c, const Place& parent, Masses& into);
  void add_fins(const Component& c, const Place& parent, Masses& into);
  void note_motor(const Component& c, const Place& place, const Cluster& cluster);
  /// What of an element nobody knows what it does to the rocket.
  void note_unknown(const Component& c);

  std::filesystem::path file_;
  std::string canards_;
  Design& design_;
  double end_m_ = 0.0;     ///< of what has been read
  double radius_m_ = 0.0;  ///< there
  std::vector<sim::Geometry::MoreFins> fins_{};
};

}  // namespace fantail::airframe::openrocket
