# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Usage: cmake -D COMPILERS=<list> -D SOURCES=<project> -D INCLUDE=<root of core/> -D WORK=<folder> -P same_bits.cmake
# Compiles same_bits.cpp and the files of core it runs with each compiler, at -O0 and -O2, and compares what they print.
# All in one translation unit, because reading the headers once is most of the time this takes.

file(MAKE_DIRECTORY ${WORK})
list(REMOVE_DUPLICATES COMPILERS)
list(TRANSFORM COMPILERS STRIP)
set(unity "#include \"${SOURCES}/test/build/same_bits.cpp\"\n")
foreach(name IN ITEMS canard_mixer canard_monitor chirp flight_plan flight_plan_fields flight_plan_members gain_schedule
    offset_estimator roll_reference trig)
  string(APPEND unity "#include \"${SOURCES}/firmware/core/${name}.cpp\"\n")
endforeach()
file(WRITE ${WORK}/unity.cpp "${unity}")

set(first "")
foreach(compiler IN LISTS COMPILERS)
  foreach(level IN ITEMS -O0 -O2)
    execute_process(COMMAND ${compiler} -std=c++20 ${level} -ffp-contract=off -I${INCLUDE} ${WORK}/unity.cpp -o ${WORK}/program
      COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${WORK}/program OUTPUT_VARIABLE bits COMMAND_ERROR_IS_FATAL ANY)
    message(STATUS "${compiler} ${level}: ${bits}")
    if(first STREQUAL "")
      set(first "${bits}")
    elseif(NOT bits STREQUAL first)
      message(SEND_ERROR "${compiler} ${level} computes other bits")
    endif()
  endforeach()
endforeach()
