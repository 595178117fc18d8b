// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "airframe/openrocket/component.hpp"
#include "airframe/openrocket/read.hpp"

namespace fantail::airframe::openrocket {

/// Where a component is: what its children count from.
struct Place {
  double begin_m = 0.0;
  double length_m = 0.0;
  double outer_m = 0.0;  ///< radius
  double inner_m = 0.0;
};

/// Walks through the components of one stage from nose to tail and adds them to a design.
class Reader {
 public:
  Reader(std::filesystem::path file, Design& design) : file_{std::move(file)}, design_{design} {}

  void read(pugi::xml_node stage);

 private:
  using Masses = std::vector<sim::Geometry::Mass>;

  // The body, one behind the other.
  void add_nose(const Component& c);
  void add_tube(const Component& c);
  void add_transition(const Component& c, pugi::xml_node behind);
  [[nodiscard]] double radius_behind(const Component& c, pugi::xml_node behind) const;
  void scale_to_stage(const Component& stage);
  void join_single_fins();
  void choose_fins();

  // What is inside or on it.
  /// The component's own part and those of its children, after its overrides.
  void add_with_children(const Component& c, const Place& place, sim::Geometry::Mass own, Masses& into);
  void add_child(const Component& c, const Place& parent, Masses& into);
  void add_fins(const Component& c, const Place& parent, Masses& into);
  void note_motor(const Component& c, const Place& place);

  std::filesystem::path file_;
  Design& design_;
  double end_m_ = 0.0;     ///< of what has been read
  double radius_m_ = 0.0;  ///< there
  std::vector<std::pair<std::string, sim::Geometry::FinSet>> fins_{};
};

/// A component's overrides of its mass, alone or with its children, and of its centre.
void apply_overrides(const Component& c, double begin_m, sim::Geometry::Mass& own,
                     std::vector<sim::Geometry::Mass>& children);

}  // namespace fantail::airframe::openrocket
