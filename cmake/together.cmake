# SPDX-License-Identifier: MIT
# On a PC up to eight files of a target are compiled as one, which takes half the time. Other compilers, the preset
# `host-asan`, the processor and the linter see each alone, so an #include that is missing is found there.

# An unnamed namespace is then one for eight files. These files give a name in it to another thing than a file beside
# them does, and are compiled alone; a new one of this kind does not compile until it stands here. One is there because GCC 12
# invents a warning of it (tools/bench/verdict.cpp). What has compile options of its own is alone without it.
set(FANTAIL_COMPILED_ALONE
  firmware/avionics/flight_memory.cpp firmware/avionics/memory_watch.cpp firmware/avionics/recorder.cpp
  firmware/core/canard_monitor.cpp
  firmware/protocol/bus_decode_bench.cpp
  hal/stm32f4/edge_timer.cpp hal/stm32f4/frozen_counts.cpp hal/stm32f4/imu.cpp hal/stm32f4/second_imu.cpp
  sim/servo.cpp sim/thrust_curve.cpp
  test/avionics/arming_alone_test.cpp test/avionics/arming_refusal_test.cpp test/avionics/avionics_test.cpp test/avionics/board_watch_test.cpp
  test/avionics/bus_receiver_test.cpp test/avionics/flight_memory_starts_test.cpp test/avionics/flight_memory_test.cpp
  test/avionics/bench_mode_alone_test.cpp test/avionics/self_test_alone_test.cpp test/avionics/two_benches_test.cpp
  test/bench/axes_mounting_test.cpp test/bench/cycle_test.cpp test/bench/exercise_test.cpp test/bench/measurement_test.cpp
  test/bench/sheet_test.cpp test/bench/zero_test.cpp
  test/benchmark/recorded_flight.cpp
  test/campaign/merge_test.cpp test/campaign/parallel_for_test.cpp test/campaign/question_test.cpp
  test/campaign/spread_test.cpp test/campaign/statistics_test.cpp test/campaign/unit_points_test.cpp
  test/core/autopilot_flight_test.cpp test/core/autopilot_sharing_test.cpp test/core/canard_mixer_test.cpp
  test/core/canard_monitor_test.cpp test/core/flight_phase_test.cpp test/core/gyro_gate_test.cpp
  test/core/gyro_pair_test.cpp test/core/launch_detector_pair_test.cpp test/core/launch_detector_property_test.cpp
  test/core/launch_detector_reset_test.cpp test/core/launch_detector_test.cpp test/core/loop_overrun_test.cpp
  test/core/motion_estimator_rest_test.cpp test/core/motion_estimator_roll_test.cpp test/core/motion_estimator_test.cpp
  test/core/pad_window_test.cpp test/core/pd_controller_test.cpp test/core/trig_test.cpp
  test/hal/stm32f4/encoder_test.cpp test/hal/stm32f4/fake_ism330dhcx.cpp test/hal/stm32f4/fake_kx134.cpp
  test/hal/stm32f4/flash_test.cpp test/hal/stm32f4/register_world.cpp test/hal/stm32f4/reset_cause_test.cpp
  test/hal/stm32f4/servo_test.cpp test/hal/stm32f4/slow_oscillator_test.cpp test/hal/stm32f4/spi_bus_test.cpp
  test/hal/stm32f4/supply_test.cpp test/hal/stm32f4/watchdog_test.cpp
  test/identify/mistakes_test.cpp
  test/identify/closed_loop/simulation_test.cpp
  test/input/manual_test.cpp test/input/plan_file_test.cpp test/input/scenario_file_test.cpp
  test/input/shipped_plans_test.cpp test/input/vehicle_file_test.cpp
  test/page/chart_test.cpp test/page/heat_map_test.cpp
  test/paper/identification_test.cpp test/paper/launch_roll_test.cpp
  test/predict/drawn_wind_test.cpp test/predict/prediction_test.cpp test/predict/windy_prediction_test.cpp
  test/protocol/log_tick_test.cpp
  test/sil/estimator_test.cpp test/sil/go_oracle_test.cpp test/sil/gyro_silence_test.cpp test/sil/random_launch.cpp
  test/sil/recorded_flight_test.cpp test/sil/replayed_flight_test.cpp test/sil/resumed_flight_test.cpp
  test/sil/six_dof_test.cpp test/sil/slow_pc_test.cpp test/sil/truth_oracle.cpp test/sil/two_gyros_test.cpp
  test/sil/verdict_oracle_test.cpp
  test/sim/felt_motion_test.cpp test/sim/gimbal_test.cpp test/sim/inertial_model_test.cpp test/sim/random_test.cpp
  test/sim/rigid_flight_test.cpp test/sim/roll_plant_test.cpp test/sim/servo_fault_test.cpp test/sim/servo_load_test.cpp
  test/sim/servo_spread_test.cpp test/sim/servo_test.cpp test/sim/wind_test.cpp
  test/stability/loop_at_speed_test.cpp
  test/system/bench_trouble_test.cpp test/system/fly_trajectory_test.cpp test/system/log_export_test.cpp test/system/fly_test.cpp
  test/telemetry/lossy_link_test.cpp
  test/trajectory/trajectory_test.cpp
  test/tune/tuning_test.cpp
  tools/airframe/model/fin_set.cpp
  tools/airframe/openrocket/read.cpp
  tools/bench/axes.cpp tools/bench/sheet.cpp tools/bench/sheet_csv.cpp tools/bench/sheet_text.cpp
  tools/bench/turn_figures.cpp tools/bench/verdict.cpp tools/bench/watch.cpp
  tools/campaign/html.cpp tools/campaign/json.cpp
  tools/fantail/plan_check.cpp tools/fantail/tunnel_flow.cpp tools/fantail/tunnel_stability.cpp
  tools/fantail/tunnel_steps.cpp tools/fantail/tunnel_swirl.cpp
  tools/flight/read_csv.cpp tools/flight/turning.cpp
  tools/identify/lag_doubt.cpp
  tools/input/file_kind.cpp tools/input/geometry_checks.cpp tools/input/number_field.cpp tools/input/scenario_fields.cpp
  tools/input/vehicle_fields.cpp
  tools/link/log_reader.cpp tools/link/plan_reader.cpp tools/link/plan_sender.cpp tools/link/session.cpp
  tools/log_export/ulog.cpp
  tools/page/live.cpp
  tools/predict/json.cpp tools/predict/run.cpp tools/predict/text.cpp
  tools/report/path_section.cpp tools/report/results.cpp tools/report/running_figures.cpp tools/report/summary_json.cpp
  tools/report/verdict.cpp
  tools/tunnel/steps_report.cpp tools/tunnel/swing.cpp tools/tunnel/swing_log.cpp tools/tunnel/swirl.cpp
  tools/tunnel/swirl_report.cpp tools/tunnel/tunnel_log.cpp
)

# fantail_compiled_together(<target> <source of this folder>...)
function(fantail_compiled_together name)
  if(CMAKE_CROSSCOMPILING OR FANTAIL_ONE_BY_ONE)
    return()
  endif()
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE here)
  foreach(source IN LISTS ARGN)
    if(${here}/${source} IN_LIST FANTAIL_COMPILED_ALONE)
      set_property(SOURCE ${source} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()
