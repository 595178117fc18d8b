// SPDX-License-Identifier: MIT
#include <utility>

#include "identify/closed_loop/closed_loop.hpp"

namespace fantail::identify::closed_loop {
namespace {

using namespace model;

LanePoints<1> one_point(const RollModel& model) {
  LanePoints<1> point;
  point.beta_m[0] = model.beta_m;
  for (const double node_rad : model.node_rad) {
    point.node_rad.push_back({node_rad});
  }
  for (const InitialState& initial : model.initial) {
    point.angle_rad.push_back({initial.angle_rad});
    point.rate_rad_s.push_back({initial.rate_rad_s});
  }
  return point;
}

class Recorder {
 public:
  explicit Recorder(Simulation& simulation) : simulation_{simulation} {}
  void at_sample(std::size_t /*sample*/, const Lane<1>& angle_rad, const Lane<1>& rate_rad_s) {
    simulation_.roll_angle_rad.push_back(angle_rad[0]);
    simulation_.roll_rate_rad_s.push_back(rate_rad_s[0]);
  }
  void at_command(std::size_t /*sample*/, const Lane<1>& command_rad) {
    simulation_.canard_rad.push_back(command_rad[0]);
  }
  void end_segment(std::size_t /*segment*/) {}

 private:
  Simulation& simulation_;
};

class TangentRecorder {
 public:
  TangentRecorder(const Course& course, const Tangents<1>& tangents) : tangents_{tangents}, course_{course} {
    const auto rows = static_cast<Eigen::Index>(course.record->size());
    const auto unknowns = static_cast<Eigen::Index>(tangents.unknowns.count(course.node_count, course.segments()));
    angle_ = Eigen::MatrixXd::Zero(rows, unknowns);
  }

  void at_sample(std::size_t sample, const Lane<1>& /*angle_rad*/, const Lane<1>& /*rate_rad_s*/) {
    const auto row = static_cast<Eigen::Index>(sample);
    for (std::size_t column = 0; column < tangents_.active; ++column) {
      const auto place = static_cast<Eigen::Index>(
          tangents_.unknowns.place(column, tangents_.first_node, course_.node_count, segment_));
      angle_(row, place) = tangents_.angle[column][0];
    }
  }
  void at_command(std::size_t /*sample*/, const Lane<1>& /*command_rad*/) {}
  void end_segment(std::size_t segment) { segment_ = segment + 1; }

  [[nodiscard]] Sensitivities result() const {
    const auto nodes = static_cast<Eigen::Index>(course_.node_count);
    const auto before_nodes = static_cast<Eigen::Index>(tangents_.unknowns.before_nodes());
    const auto segments = static_cast<Eigen::Index>(course_.segments());
    const Eigen::MatrixXd starts = angle_.rightCols(2 * segments);
    Eigen::MatrixXd numbers{angle_.rows(), 2 + nodes};
    numbers << angle_.leftCols(2), angle_.middleCols(before_nodes, nodes);
    // Without play there is nothing to tell of it.
    const Eigen::Index of_servo = !tangents_.unknowns.servo ? 0 : course_.half_play_rad > 0.0 ? 2 : 1;
    return {.numbers = std::move(numbers),
            .start_angle = starts(Eigen::all, Eigen::seqN(0, segments, 2)),
            .start_rate = starts(Eigen::all, Eigen::seqN(1, segments, 2)),
            .lag = angle_.middleCols(2, of_servo)};
  }

 private:
  const Tangents<1>& tangents_;
  const Course& course_;
  std::size_t segment_ = 0;
  Eigen::MatrixXd angle_{};
};

}  // namespace

Simulation simulate(const Record& record, const Airframe& airframe, const Control& control, const RollModel& model) {
  const Course course = make_course(record, airframe, control, model.node_time_s);
  Plant plant;
  plant.set_alpha(course, model.alpha_m2, Slopes::none);
  Simulation result;
  Recorder recorder{result};
  fly_lanes<1, false>(course, plant, one_point(model), nullptr, recorder);
  result.compare_with(record);
  return result;
}

Sensitivities sensitivities(const Record& record, const Airframe& airframe, const Control& control,
                            const RollModel& model) {
  const Course course = make_course(record, airframe, control, model.node_time_s);
  Plant plant;
  plant.set_alpha(course, model.alpha_m2, Slopes::by_alpha);
  Tangents<1> tangents{{.initial = true, .model = true, .servo = control.servo_is_fitted}, course.node_count};
  TangentRecorder recorder{course, tangents};
  fly_lanes<1, true>(course, plant, one_point(model), &tangents, recorder);
  return recorder.result();
}

}  // namespace fantail::identify::closed_loop
