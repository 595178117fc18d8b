# SPDX-License-Identifier: MIT
# On a PC up to sixteen files of a target are compiled as one, which takes half the time. Other compilers, the preset
# `host-asan`, the processor and the linter see each alone, so an #include that is missing is found there.

# An unnamed namespace is then one for all of them. These files give a name in it to another thing than a file beside
# them does, but not the files of one row, which are compiled together; a new one of this kind does not compile until it
# stands here or below.
#
# folder | its files that are compiled together, apart from the others
set(FANTAIL_COMPILED_APART
  "hal/stm32f4|edge_timer.cpp frozen_counts.cpp second_imu.cpp"
  "test/avionics|arming_alone_test.cpp avionics_test.cpp board_watch_test.cpp"
  "test/avionics|flight_memory_bytes_test.cpp flight_memory_flights_test.cpp flight_memory_test.cpp two_gyros_state_test.cpp"
  "test/bench|exercise_test.cpp zero_test.cpp"
  "test/bench|filling_sheet_test.cpp measurement_test.cpp sent_wave_test.cpp sheet_page_test.cpp sheet_test.cpp"
  "test/board|board_in_world.cpp device_trial.cpp flip_table.cpp"
  "test/board|flip_trial.cpp"
  "test/campaign|merge_test.cpp spread_test.cpp statistics_test.cpp"
  "test/core|canard_mixer_test.cpp launch_detector_pair_test.cpp launch_detector_test.cpp"
  "test/core|canard_monitor_test.cpp motion_estimator_test.cpp trig_test.cpp"
  "test/core|autopilot_flight_test.cpp motion_estimator_roll_test.cpp control_law_test.cpp"
  "test/core|autopilot_record_test.cpp pad_window_test.cpp"
  "test/core|flight_phase_test.cpp gyro_gate_test.cpp pad_movement_test.cpp"
  "test/core|state_test.cpp chirp_variation_test.cpp gyro_pair_limits_test.cpp pad_window_limits_test.cpp"
  "test/core|motion_estimator_gyros_test.cpp motion_estimator_limits_test.cpp"
  "test/hal/stm32f4|fake_ism330dhcx.cpp backup_memory_test.cpp servo_test.cpp watchdog_test.cpp spi_bus_test.cpp supply_test.cpp"
  "test/hal/stm32f4|encoder_test.cpp fake_kx134.cpp"
  "test/input|manual_test.cpp plan_file_test.cpp shipped_plans_test.cpp"
  "test/input|scenario_file_test.cpp vehicle_file_test.cpp"
  "test/paper|identification_test.cpp launch_roll_test.cpp tunnel_test.cpp"
  "test/sil|any_rocket.cpp plain_judge.cpp"
  "test/sil|estimator_test.cpp recorded_flight_test.cpp slow_pc_test.cpp"
  "test/sil|go_oracle_test.cpp two_gyros_test.cpp"
  "test/sil|gyro_silence_test.cpp random_launch.cpp"
  "test/sil|replayed_flight_test.cpp resumed_flight_test.cpp"
  "test/sil|six_dof_test.cpp truth_oracle.cpp"
  "test/sim|felt_motion_test.cpp rigid_flight_test.cpp roll_plant_test.cpp servo_fault_test.cpp servo_load_test.cpp servo_test.cpp"
  "test/sim|twist_test.cpp world_fault_test.cpp"
  "test/sim|gimbal_test.cpp inertial_model_test.cpp wind_test.cpp"
  "test/system|bench_trouble_test.cpp fly_test.cpp log_export_test.cpp"
  "tools/bench|sheet.cpp sheet_text.cpp turn_figures.cpp watch.cpp"
  "tools/input|file_kind.cpp geometry_checks.cpp number_field.cpp vehicle_fields.cpp"
  "tools/link|plan_transfer.cpp"
  "tools/predict|answer.cpp run.cpp"
  "tools/report|path_section.cpp read_summary.cpp results.cpp running_figures.cpp"
  "tools/tunnel|swing.cpp swirl.cpp"
)

# What fits into none of these rows is compiled alone. One is here because GCC 12 invents a warning of it
# (tools/bench/verdict.cpp). What has compile options of its own is alone without it.
set(FANTAIL_COMPILED_ALONE
  firmware/avionics/flight_memory.cpp firmware/avionics/memory_watch.cpp firmware/core/canard_monitor.cpp
  firmware/protocol/bus_decode_bench.cpp
  hal/stm32f4/imu.cpp
  sim/servo.cpp sim/thrust_curve.cpp
  test/airframe/openrocket/overrides_test.cpp test/avionics/two_benches_test.cpp test/hal/stm32f4/flash_test.cpp
  test/hal/stm32f4/register_world.cpp test/paper/tunnel_step_test.cpp test/system/spared_input_test.cpp
  test/telemetry/lossy_link_test.cpp
  tools/airframe/openrocket/read.cpp tools/bench/axes.cpp tools/bench/verdict.cpp tools/campaign/question.cpp
  tools/fantail/plan_check.cpp tools/identify/result/validation_answer.cpp tools/identify/result/words.cpp
  tools/input/scenario_fields.cpp tools/input/section.cpp tools/link/await_avionics.cpp tools/link/log_reader.cpp
  tools/link/session.cpp tools/log_export/ulog.cpp tools/logs/rows_of_log.cpp
)

# fantail_compiled_together(<target> <source of this folder>...)
function(fantail_compiled_together name)
  if(CMAKE_CROSSCOMPILING OR FANTAIL_ONE_BY_ONE)
    return()
  endif()
  # At the end of the folder, when it is known which have options of their own.
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE here)
  cmake_language(EVAL CODE "cmake_language(DEFER CALL fantail_groups ${name} ${here} \"${ARGN}\")")
endfunction()

# fantail_level(<option> <file>...): files of this folder that are optimised at a level of their own, and so are compiled
# with each other and not with the rest of their target. They have the precompiled header that was read for that level, where
# there is one.
function(fantail_level option)
  if(CMAKE_CROSSCOMPILING OR FANTAIL_ONE_BY_ONE)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS ${option})
    set_property(SOURCE ${ARGN} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  endif()
  set_property(SOURCE ${ARGN} PROPERTY FANTAIL_LEVEL ${option})
endfunction()

# fantail_groups(<target> <folder> <list of sources of that folder>)
function(fantail_groups name folder sources)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set(together 0)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} OUTPUT_VARIABLE path)
    get_property(level SOURCE ${path} PROPERTY FANTAIL_LEVEL)
    get_property(options SOURCE ${path} PROPERTY COMPILE_OPTIONS)
    set(group "")
    foreach(apart IN LISTS FANTAIL_COMPILED_APART)
      if("${apart} " MATCHES "^${folder}[|](.* )?${source} ")
        string(REGEX REPLACE ".*[|]([a-z0-9_]*).*" "\\1" group "${apart}") # its first file
      endif()
    endforeach()
    if(options OR "${folder}/${source}" IN_LIST FANTAIL_COMPILED_ALONE)
      set(compiled ${path})
    else()
      if(level)
        string(PREPEND group level)
      elseif(NOT group)
        math(EXPR group "${together} / 16")
        math(EXPR together "${together} + 1")
      endif()
      set_property(SOURCE ${path} PROPERTY UNITY_GROUP ${group})
      set(compiled ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${name}.dir/Unity/unity_${group}_cxx.cxx)
    endif()
    if(level)
      get_target_property(is_twin ${name} FANTAIL_IS_TWIN)
      if(FANTAIL_PRECOMPILED_LEVEL AND NOT is_twin)
        get_target_property(headers ${FANTAIL_PRECOMPILED_LEVEL} BINARY_DIR)
        string(APPEND headers /CMakeFiles/${FANTAIL_PRECOMPILED_LEVEL}.dir/cmake_pch.hxx)
        list(APPEND level -include ${headers} $<TARGET_PROPERTY:${FANTAIL_PRECOMPILED_LEVEL},INTERFACE_COMPILE_OPTIONS>)
        set_property(SOURCE ${compiled} PROPERTY OBJECT_DEPENDS ${headers}.gch)
      endif()
      set_property(SOURCE ${compiled} PROPERTY COMPILE_OPTIONS ${options} ${level})
      set_property(SOURCE ${compiled} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()
