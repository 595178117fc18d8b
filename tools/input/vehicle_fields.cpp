// SPDX-License-Identifier: MIT
#include "core/flight_plan_table.hpp"
#include "input/vehicle_file.hpp"

namespace fantail::input {
namespace {

constexpr std::array<std::string_view, 2> no_or_yes{"no", "yes"};
constexpr std::array<std::string_view, 2> directions{"normal", "reversed"};
constexpr std::array<std::string_view, 2> compressibilities{"none", "prandtl_glauert"};
constexpr Unit hz_of_period{.name = "Hz", .inverted = true};
constexpr Unit deg_s_per_g{.name = "deg/s per g", .scale = sim::radians_per_degree / sim::gravity_m_s2};
constexpr Unit deg_s_per_min{.name = "deg/s per min", .scale = sim::radians_per_degree / 60.0};
constexpr Unit percent{.name = "%", .scale = 0.01};
constexpr Unit g{.name = "g", .scale = sim::gravity_m_s2};
constexpr Limits tolerated_deg{0.05, 10};
constexpr std::array<std::string_view, 5> nose_shapes{"cone", "ogive", "ellipsoid", "parabola", "haack"};

// clang-format off: one field a row reads better than one argument a line
#define AT(expression) FANTAIL_PLACE(sim::Vehicle, expression)
constexpr auto fields = std::to_array<Field<sim::Vehicle>>({
  {"body", "name", text(), must, AT(it.name), "Name of the rocket in reports."},
  {"body", "assumed", list(100, text()), may, AT(grown(it.assumed, i)), "Assumptions in this file that were not measured, one sentence each; reports repeat them."},
  {"body", "mass_kg", number("kg", {0.02, 1000}), must, AT(it.mass_kg), "Mass at lift-off; more than the propellant of its motor."},
  {"body", "drag_area_m2", number("m2", {0, 1}), must, AT(it.drag_area_m2), "Drag coefficient times area."},
  {"body", "drag_mach", list(100, number("", {0, 10})), may, AT(grown(it.drag_over_mach.mach, i)), "Increasing Mach numbers for which `drag_factor` holds; straight lines between them."},
  {"body", "drag_factor", list(100, number("", {0.01, 20})), may, AT(grown(it.drag_over_mach.factor, i)), "Factor on `drag_area_m2` at each of these Mach numbers."},
  {"body", "roll_inertia_kg_m2", number("kg m2", {1e-6, 10}), must, AT(it.roll_plant.inertia_kg_m2), "Moment of inertia about the long axis."},

  {"aerodynamics", "reference_area_m2", number("m2", {1e-8, 1}), must, AT(it.roll_plant.reference_area_m2), "Area by which `damping_m2` and `torque_m` are multiplied; matters in transients only."},
  {"aerodynamics", "reference_area_range_m2", list(2, number("m2", {1e-8, 1})), may, AT(grown(it.reference_area_range_m2, i)), "95 % range of the true area; `reference_area_m2` lies between. `predict` includes it in its spread."},
  {"aerodynamics", "damping_m2", number("m2", {0, 1e4}), must, AT(it.roll_plant.damping_m2), "Roll damping, alpha."},
  {"aerodynamics", "torque_m", number("m", {0, 1e4}), must, AT(it.roll_plant.torque_m), "Roll torque of the canards, beta."},
  {"aerodynamics", "compressibility", choice(compressibilities), may, AT(it.compressibility), "`prandtl_glauert`: damping, torque and normal force grow with 1 / sqrt(1 - M2), up to Mach 0.8."},
  {"aerodynamics", "canard_stall_deg", number(deg, {5, 30}), may, AT(it.canard_air.stall_rad), "The lift of each canard grows up to this angle and then stays constant; 12 to 15 are usual. Absent: no stall."},
  {"aerodynamics", "canard_arm_m", number("m", {0, 2}), may, AT(it.canard_air.arm_m), "Distance from the long axis to the centre of lift of a canard. At most `damping_m2 / torque_m`."},
  {"aerodynamics", "canard_wash", number("", {0, 2}), may, AT(it.canard_air.wash), "Share of the canards' roll torque that the fins behind them take back. `torque_m` is then that of the canards alone; one identified with the fins on includes the wash."},
  {"aerodynamics", "canard_wash_distance_m", number("m", {0, 30}), may, AT(it.canard_air.wash_distance_m), "Distance from the canards back to the fins."},
  {"aerodynamics", "canard_hinge_moment_m3", number("m3", {-0.01, 0.01}), may, AT(it.canard_air.hinge_moment_m3), "Moment about the shaft of one canard over 1/2 rho v2 and its angle to the flow in radians. It is lift slope times area times the distance from the shaft back to the centre of lift. Below zero: the lift acts in front of the shaft. Used with `servo.torque_n_m`."},
  {"aerodynamics", "canard_side_area_m2", number("m2", {0, 1}), may, AT(it.canard_air.side_area_m2), "Side force of one canard over 1/2 rho v2 and its angle in radians: lift slope times area. Without it, a failed canard only rolls the rocket. Needs `canard_position_m`."},
  {"aerodynamics", "canard_position_m", number("m", {0, 30}), may, AT(it.canard_air.position_m), "Distance from the tip of the nose to the side force of the canards. Needs `canard_side_area_m2`."},

  {"airframe", "diameter_m", number("m", {0.01, 2}), must_in_its_section, AT(made(it.airframe).diameter_m), "Diameter of the body. Flights in six degrees of freedom need this section; positions are measured from the tip of the nose."},
  {"airframe", "length_m", number("m", {0.1, 30}), must_in_its_section, AT(made(it.airframe).length_m), "From the tip of the nose to the tail."},
  {"airframe", "normal_force_slope_per_rad", number("1/rad", {0.1, 200}), must_in_its_section, AT(made(it.airframe).normal_force_slope_per_rad), "Slope of the normal force coefficient over the angle of attack, on the cross-section of the body."},
  {"airframe", "centre_of_pressure_m", number("m", {0, 30}), must_in_its_section, AT(made(it.airframe).centre_of_pressure_m), "Where that force acts."},
  {"airframe", "parts_spread_m", number("m", {0, 30}), must_in_its_section, AT(made(it.airframe).parts_spread_m), "Root mean square distance of nose, canards and fins from the centre of pressure, weighted with their slopes: it damps pitch."},
  {"airframe", "body_lift_area_m2", number("m2", {0, 10}), may, AT(made(it.airframe).body_lift_area_m2), "Body lift at large angles: coefficient (about 1.1) times the area of the body seen from the side."},
  {"airframe", "body_lift_position_m", number("m", {0, 30}), may, AT(made(it.airframe).body_lift_position_m), "Where it acts: the centre of that area."},
  {"airframe", "centre_of_gravity_m", number("m", {0, 30}), must_in_its_section, AT(made(it.airframe).at_liftoff.centre_of_gravity_m), "Centre of gravity at lift-off."},
  {"airframe", "centre_of_gravity_after_burnout_m", number("m", {0, 30}), must_in_its_section, AT(made(it.airframe).after_burnout.centre_of_gravity_m), "Centre of gravity after burn-out; the propellant that has moved it must lie between nose and tail."},
  {"airframe", "transverse_inertia_kg_m2", number("kg m2", {1e-5, 1e4}), must_in_its_section, AT(made(it.airframe).at_liftoff.transverse_inertia_kg_m2), "Moment of inertia about an axis across the rocket through its centre of gravity, at lift-off."},
  {"airframe", "transverse_inertia_after_burnout_kg_m2", number("kg m2", {1e-5, 1e4}), must_in_its_section, AT(made(it.airframe).after_burnout.transverse_inertia_kg_m2), "The same after burn-out."},
  {"airframe", "roll_inertia_after_burnout_kg_m2", number("kg m2", {1e-6, 10}), may, AT(made(it.airframe).roll_inertia_after_burnout_kg_m2), "Roll inertia after burn-out; as at lift-off when absent."},
  {"airframe", "nozzle_position_m", number("m", {0, 30}), may, AT(made(it.airframe).nozzle_position_m), "Where the exhaust leaves; at the tail when absent."},
  {"airframe", "assumed", list(100, text()), may, AT(grown(it.airframe_assumed, i)), "Assumptions in this section that were not measured; reports of flights in six degrees of freedom repeat them."},

  {"recovery", "drag_area_m2", number("m2", {0, 100}), may, AT(made(it.recovery).drag_area_m2), "Drag coefficient times area of the parachute, which opens when the rocket first descends. For six degrees of freedom only, like all of this section."},
  {"recovery", "delay_s", number("s", {0, 60}), may, AT(made(it.recovery).delay_s), "Time from then until it begins to open."},
  {"recovery", "opening_time_s", number("s", {0.05, 10}), may, AT(made(it.recovery).opening_time_s), "Time from then until it is fully open."},
  {"recovery", "position_m", number("m", {0, 30}), may, AT(made(it.recovery).position_m), "Where its line is attached, from the tip of the nose."},

  {"shape", "diameter_m", number("m", {0.01, 2}), must_in_its_section, AT(made(it.geometry).diameter_m), "Diameter of nose and body. Only `fantail airframe` and `campaign hardover` compute from the sections from here to `masses`."},
  {"shape", "length_m", number("m", {0.1, 30}), must_in_its_section, AT(made(it.geometry).length_m), "From the tip of the nose to the tail."},
  {"shape", "nose", choice(nose_shapes), must_in_its_section, AT(made(it.geometry).nose_shape), "The shape of the nose cone."},
  {"shape", "nose_length_m", number("m", {0.005, 10}), must_in_its_section, AT(made(it.geometry).nose_length_m), "Length of the nose cone."},
  {"shape", "transition_position_m", number("m", {0, 30}), may, AT(grown(made(it.geometry).transitions, 0).position_m), "Where a change of diameter begins. A boat tail ends at the tail."},
  {"shape", "transition_length_m", number("m", {0, 10}), may, AT(grown(made(it.geometry).transitions, 0).length_m), "Length of the transition; above 0."},
  {"shape", "transition_diameter_m", number("m", {0, 2}), may, AT(grown(made(it.geometry).transitions, 0).aft_diameter_m), "The diameter behind it; above 0."},
  {"shape", "assumed", list(100, text()), may, AT(grown(it.geometry_assumed, i)), "Assumptions in these sections that were not measured, one sentence each."},
  {"more_transitions", "positions_m", list(20, number("m", {0, 30})), must_in_its_section, AT(grown(made(it.geometry).transitions, i + 1).position_m), "Where further changes of diameter begin, behind that of `shape`, from nose to tail."},
  {"more_transitions", "lengths_m", list(20, number("m", {0, 10})), must_in_its_section, AT(grown(made(it.geometry).transitions, i + 1).length_m), "Length of each; above 0."},
  {"more_transitions", "diameters_m", list(20, number("m", {0, 2})), must_in_its_section, AT(grown(made(it.geometry).transitions, i + 1).aft_diameter_m), "The diameter behind each; above 0."},

// Fins and canards are described by the same words.
// NOLINTBEGIN(bugprone-macro-parentheses): as in field.hpp
#define FIN_SET(section, set) \
  {section, "position_m", number("m", {0, 30}), must_in_its_section, AT(made(made(it.geometry).set).position_m), "Where the leading edge meets the body, from the tip of the nose."}, \
  {section, "root_chord_m", number("m", {0.001, 5}), must_in_its_section, AT(made(made(it.geometry).set).root_chord_m), "Chord at the root, along the body."}, \
  {section, "tip_chord_m", number("m", {0, 5}), must_in_its_section, AT(made(made(it.geometry).set).tip_chord_m), "Chord at the tip; 0: a triangle."}, \
  {section, "span_m", number("m", {0.001, 2}), must_in_its_section, AT(made(made(it.geometry).set).span_m), "From the surface of the body to the tip."}, \
  {section, "sweep_m", number("m", {-2, 5}), may, AT(made(made(it.geometry).set).sweep_m), "How far the leading edge of the tip is behind that of the root."}, \
  {section, "thickness_m", number("m", {0.0001, 0.2}), may, AT(made(made(it.geometry).set).thickness_m), "Thickness of the plate."}
// NOLINTEND(bugprone-macro-parentheses)
  FIN_SET("fins", fins),
  {"fins", "count", integer({}, {3, 8}), may, AT(made(made(it.geometry).fins).count), "Number of fins, evenly around the body."},
  {"fins", "cant_deg", number(deg, {-10, 10}), may, AT(made(made(it.geometry).fins).cant_rad), "Cant of all fins: positive rolls the rocket in the same direction as positive canards."},
  FIN_SET("canard_fins", canards),
  {"canard_fins", "hinge_m", number("m", {0, 5}), may, AT(made(it.geometry).canard_hinge_m), "Distance of the shaft behind the leading edge at the root."},

  {"more_fins", "names", list(20, text()), must_in_its_section, AT(grown(made(it.geometry).more_fins, i).name), "Further sets of fins, for `fantail airframe`. One or two fins hold the rocket in one plane only: the margin is that of the worst plane."},
  {"more_fins", "counts", list(20, integer({}, {1, 8})), must_in_its_section, AT(grown(made(it.geometry).more_fins, i).set.count), "Number of fins of each, evenly around the body; as many as `names`, like all lists of this section."},
  {"more_fins", "first_angles_deg", list(20, number(deg, {-360, 360})), may, AT(grown(made(it.geometry).more_fins, i).first_angle_rad), "Where around the body the first of each is."},
  {"more_fins", "positions_m", list(20, number("m", {0, 30})), must_in_its_section, AT(grown(made(it.geometry).more_fins, i).set.position_m), "Where the leading edge of each meets the body, from the tip of the nose."},
  {"more_fins", "root_chords_m", list(20, number("m", {0.001, 5})), must_in_its_section, AT(grown(made(it.geometry).more_fins, i).set.root_chord_m), "Chord of each at the root."},
  {"more_fins", "tip_chords_m", list(20, number("m", {0, 5})), must_in_its_section, AT(grown(made(it.geometry).more_fins, i).set.tip_chord_m), "Chord of each at the tip."},
  {"more_fins", "spans_m", list(20, number("m", {0.001, 2})), must_in_its_section, AT(grown(made(it.geometry).more_fins, i).set.span_m), "Span of each, from the surface of the body to the tip."},
  {"more_fins", "sweeps_m", list(20, number("m", {-2, 5})), may, AT(grown(made(it.geometry).more_fins, i).set.sweep_m), "How far the leading edge of the tip is behind that of the root."},
  {"more_fins", "cants_deg", list(20, number(deg, {-45, 45})), may, AT(grown(made(it.geometry).more_fins, i).set.cant_rad), "Cant of each."},

  {"masses", "names", list(100, text()), may, AT(grown(made(it.geometry).masses, i).name), "The parts of the rocket without its propellant."},
  {"masses", "masses_kg", list(100, number("kg", {0, 1000})), may, AT(grown(made(it.geometry).masses, i).mass_kg), "Mass of each; as many as `names`, like all lists of this section."},
  {"masses", "positions_m", list(100, number("m", {0, 30})), may, AT(grown(made(it.geometry).masses, i).position_m), "Where the middle of each is, from the tip of the nose."},
  {"masses", "lengths_m", list(100, number("m", {0, 30})), may, AT(grown(made(it.geometry).masses, i).length_m), "Length of each; 0: a point."},
  {"masses", "radii_of_gyration_m", list(100, number("m", {0, 2})), may, AT(grown(made(it.geometry).masses, i).radius_of_gyration_m), "Radius of gyration of each about the long axis: the radius for a thin tube, 0.707 times the radius for a solid rod."},
  {"masses", "propellant_position_m", number("m", {0, 30}), may, AT(made(made(it.geometry).propellant).position_m), "Where the middle of the propellant is; its mass comes from the motor."},
  {"masses", "propellant_length_m", number("m", {0, 10}), may, AT(made(made(it.geometry).propellant).length_m), "Length of the propellant."},
  {"masses", "propellant_radius_of_gyration_m", number("m", {0, 1}), may, AT(made(made(it.geometry).propellant).radius_of_gyration_m), "Its radius of gyration about the long axis; at most the radius of the body there."},

  {"design", "file", text(), may, AT(made(made(it.geometry).design).file), "The design file that `fantail new` has read; required in this section, which `fantail airframe` compares with the vehicle. Delete the section when the rocket has been weighed and balanced."},
  {"design", "flight", text(), may, AT(made(made(it.geometry).design).flight), "The simulated flight in that file whose numbers follow."},
  {"design", "mass_kg", number("kg", {0.001, 1000}), may, AT(made(made(it.geometry).design).mass_kg), "Mass of the design at lift-off. A difference of more than 2 % from `body.mass_kg` is doubtful."},
  {"design", "centre_of_gravity_m", number("m", {0, 30}), may, AT(made(made(it.geometry).design).centre_of_gravity_m), "Centre of gravity of the design at lift-off. A difference of more than 0.2 calibres is doubtful, as with the next three."},
  {"design", "centre_of_pressure_m", number("m", {0, 30}), may, AT(made(made(it.geometry).design).centre_of_pressure_m), "Centre of pressure of the design in slow flight."},
  {"design", "angle_of_attack_deg", number(deg, {0, 10}), may, AT(made(made(it.geometry).design).angle_of_attack_rad), "The angle of attack of that centre of pressure."},
  {"design", "margin_calibres", number("", {-100, 100}), may, AT(made(made(it.geometry).design).margin_calibres), "Static margin of the design under thrust, if the file has no centres."},
  {"design", "left_out", list(100, text()), may, AT(grown(made(made(it.geometry).design).left_out, i)), "Parts of the design that were not read, or were read with changes."},

  {"motor", "file", file(), must, {}, "The motor: a RASP file (`.eng`). `motors.eng#K550`: the motor of that name in a file of several."},
  {"motor", "count", integer({}, {1, 9}), may, AT(it.motor_count), "How many of these motors burn at once: a cluster. Thrust and propellant are those of all."},
  {"motor", "thrust_factor", number("", {0.5, 1.5}), may, AT(it.thrust_factor), "Factor on the thrust of the curve, with the same burn time and propellant mass."},

  {"servo", "lag_s", number("s", {0.0005, 1}), may, AT(it.servo.lag_s), "Time constant with which the gear follows the command."},
  {"servo", "delay_s", number("s", {0, 0.05}), may, AT(it.servo.delay_s), "Delay from a pulse to the servo's motion."},
  {"servo", "frame_rate_hz", number(hz_of_period, {40, 1000}), may, AT(it.servo.frame_period_s), "How often the servo takes a new pulse."},
  {"servo", "rate_limit_deg_s", number(deg_s, {1, 1e5}), may, AT(it.servo.rate_limit_rad_s), "Largest rate of the shaft."},
  {"servo", "torque_n_m", number("N m", {0.005, 100}), may, AT(it.servo.torque_n_m), "Stall torque at the shaft: against a load, the servo turns at the rate limit times 1 - load / torque. Used with `aerodynamics.canard_hinge_moment_m3`."},
  {"servo", "stop_deg", number(deg, {1, 90}), may, AT(it.servo.stop_rad), "Mechanical stop of the shaft, either way."},
  {"servo", "backlash_deg", number(deg, {0, 5}), may, AT(it.servo.backlash_rad), "Whole width of the play between gear and shaft."},
  {"servo", "pulse_centre_us", number("us", {500, 2500}), may, AT(it.servo.pulse_centre_us), "Pulse that commands the centre."},
  {"servo", "pulse_per_degree_us", number("us/deg", {-40, 40}), may, AT(it.servo.pulse_per_degree_us), "Pulse per degree of the shaft; below zero it turns the other way."},
  {"servo", "spread", number("", {0, 0.3}), may, AT(it.servo_spread.share), "Lag, delay, rate limit and play of each servo are multiplied by a factor within 1 +- this, drawn from the seed."},
  {"servo", "centre_spread_deg", number(deg, {0, 2}), may, AT(it.servo_spread.centre_rad), "The true centre of each servo is off by up to this, drawn from the seed."},

  {"canard_mounting", "trim_deg", four(number(deg, {-5, 5})), may, AT(it.canards[i].trim_rad), "Shaft angle at which the canard makes no roll moment."},
  {"canard_mounting", "encoder_zero_deg", four(number(deg, {-180, 180})), may, AT(it.canards[i].encoder_zero_rad), "Reading of the encoder at shaft angle zero."},
  {"canard_mounting", "direction", four(choice(directions)), may, AT(it.canards[i].reversed), "`reversed`: a positive shaft angle rolls the rocket negatively."},

// Both IMUs are described by the same words, and so are all inertial sensors.
// NOLINTBEGIN(bugprone-macro-parentheses): as in field.hpp
#define GYRO(section, sensor, feels) \
  {section, "rate_noise_deg_s", number(deg_s, {0, 100}), may, AT(sensor.rate_noise_rad_s), "Standard deviation of each sample of the rates, white."}, \
  {section, "rate_bias_deg_s", number(deg_s, {-50, 50}), may, AT(sensor.rate_bias_rad_s), "Added to every rate."}, \
  {section, "rate_scale_error", number("", {-0.1, 0.1}), may, AT(feels.rate_scale_error), "Share by which it reads every rate too large."}, \
  {section, "rate_per_g_deg_s", number(deg_s_per_g, {-10, 10}), may, AT(feels.rate_per_specific_force_s_m), "g-sensitivity of the gyro: rate that it reads for each g along the same axis."}, \
  {section, "rate_drift_deg_s_per_min", number(deg_s_per_min, {-60, 60}), may, AT(feels.rate_drift_rad_s2), "Drift of every rate's bias from power-up on, as it warms."}, \
  {section, "full_scale_deg_s", number(deg_s, {50, 4000}), may, AT(sensor.full_scale_rad_s), "Largest rate that it can measure."}
#define INERTIAL(section, sensor, feels) \
  {section, "specific_force_noise_m_s2", number("m/s2", {0, 50}), may, AT(sensor.specific_force_noise_m_s2), "Standard deviation of each sample of the specific force, white."}, \
  {section, "specific_force_bias_m_s2", number("m/s2", {-5, 5}), may, AT(sensor.specific_force_bias_m_s2), "Added to every axis."}, \
  {section, "full_scale_g", number(g, {2, 400}), may, AT(sensor.full_scale_m_s2), "Largest specific force that it can measure."}, \
  {section, "misalignment_deg", number(deg, {0, 10}), may, AT(sensor.misalignment_rad), "The package is turned by this about a random axis across the rocket."}, \
  {section, "delay_s", number("s", {0, 0.02}), may, AT(sensor.delay_s), "Delay from measurement to delivery; of an IMU its filters, its sampling, and a tick up to its commands."}, \
  {section, "to_nose", choice(core::plan_table::sensor_axis_names), may, AT(sensor.mounting.to_nose), "Which of its axes truly points to the nose; the plan has what the avionics assume."}, \
  {section, "along_y", choice(core::plan_table::sensor_axis_names), may, AT(sensor.mounting.along_y), "Which of its axes truly points along the rocket's y; the third follows."}, \
  {section, "position_m", number("m", {0, 30}), may, AT(feels.position_m), "Position from the tip of the nose; absent: at the centre of gravity. Used in six degrees of freedom."}, \
  {section, "across_m", number("m", {-0.5, 0.5}), may, AT(feels.across_m), "Distance from the long axis, towards the rocket's y."}, \
  {section, "specific_force_scale_error", number("", {-0.1, 0.1}), may, AT(feels.specific_force_scale_error), "Share by which it reads every specific force too large."}
// NOLINTEND(bugprone-macro-parentheses)
  GYRO("imu", it.imu, it.imu_feels),
  INERTIAL("imu", it.imu, it.imu_feels),
  {"second_imu", "fitted", choice(no_or_yes), may, AT(it.second_imu_is_fitted), "Whether there is a second IMU. The avionics read it if the plan has `sensors.gyros = \"two_agree\"`."},
  GYRO("second_imu", it.second_imu, it.second_imu_feels),
  INERTIAL("second_imu", it.second_imu, it.second_imu_feels),
  INERTIAL("accelerometer", it.accelerometer, it.accelerometer_feels),

  {"barometer", "fitted", choice(no_or_yes), may, AT(it.barometer.is_fitted), "Whether there is a barometer. It has a new sample every 10 ms."},
  {"barometer", "noise_pa", number("Pa", {0, 500}), may, AT(it.barometer.noise_pa), "Standard deviation of each sample, white."},
  {"barometer", "port_error", number("", {-1, 1}), may, AT(it.barometer.port_error), "Pressure coefficient at the static ports: share of the dynamic pressure that is added. Above zero, the height reads too low. Between Mach 0.9 and 1.1 a shock adds up to 0.1."},
  {"barometer", "vent_lag_s", number("s", {0, 5}), may, AT(it.barometer.vent_lag_s), "Time constant with which the pressure in the bay follows the ports."},
  {"barometer", "offset_pa", number("Pa", {-5000, 5000}), may, AT(it.barometer.offset_pa), "Added to every sample."},

  {"vibration", "specific_force_m_s2", number("m/s2", {0, 500}), may, AT(it.vibration.specific_force_m_s2), "Vibration of all sensors while the motor burns: standard deviation along each axis."},
  {"vibration", "rate_deg_s", number(deg_s, {0, 1000}), may, AT(it.vibration.rate_rad_s), "The same for the rate about each axis."},
  {"vibration", "frequency_hz", number("Hz", {1, 450}), may, AT(it.vibration.frequency_hz), "Middle frequency of its band; the width is a fifth of it."},

  {"encoder", "noise_counts", number("counts", {0, 1000}), may, AT(it.encoder.noise_counts), "Standard deviation of each reading; 16384 counts are a turn."},
  {"encoder", "resolution_bits", integer({"bits"}, {4, 14}), may, AT(it.encoder.resolution_bits), "Resolution of a full turn."},

  {"canard_tolerances", "reach_deg", number(deg, tolerated_deg), may, AT(it.canard_tolerances.reach_rad), "At a limit: encoder against command."},
  {"canard_tolerances", "tracking_deg", number(deg, tolerated_deg), may, AT(it.canard_tolerances.tracking_rad), "During a slow ramp: encoder against command, servo lag taken off."},
  {"canard_tolerances", "centring_deg", number(deg, tolerated_deg), may, AT(it.canard_tolerances.centring_rad), "At rest: mean of the approaches from both sides, against command."},
  {"canard_tolerances", "backlash_deg", number(deg, tolerated_deg), may, AT(it.canard_tolerances.backlash_rad), "At rest: difference of those two."},
  {"canard_tolerances", "slowest_slew_deg_s", number(deg_s, {1, 1e5}), may, AT(it.canard_tolerances.slowest_slew_rad_s), "From one limit to the other."},
  {"canard_tolerances", "longest_step_time_s", number("s", {0.001, 5}), may, AT(it.canard_tolerances.longest_step_time_s), "10 to 90 % of a step from the centre to a limit."},
  {"canard_tolerances", "noise_deg", number(deg, {0.01, 10}), may, AT(it.canard_tolerances.noise_rad), "Standard deviation of the encoder at rest."},
  {"canard_tolerances", "dropout_percent", number(percent, {0, 50}), may, AT(it.canard_tolerances.dropout_share), "Share of the encoder's readings that were not valid."},
});
// clang-format on

}  // namespace

std::span<const Field<sim::Vehicle>> vehicle_fields() { return fields; }

}  // namespace fantail::input
