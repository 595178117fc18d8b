# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Usage: cmake -D ROOT=<project> -P check_includes.cmake
# Reads every #include of the product and refuses those that the table below does not allow.

# folder | project headers it may include | third-party headers it may include (regular expressions)
set(table
  "firmware/core|core/|"
  "firmware/protocol|core/,protocol/|"
  "firmware/avionics|core/,protocol/,hal/[a-z_]+\\.hpp,avionics/|"
  "firmware/boards|core/,protocol/,hal/,avionics/,boards/|"
  "hal/include|hal/[a-z_]+\\.hpp|"
  "hal/linux|hal/[a-z_]+\\.hpp,hal/linux/|fcntl\\.h,linux/can,net/if,poll\\.h,sys/,unistd\\.h"
  "hal/emulator|hal/[a-z_]+\\.hpp,hal/emulator/,hal/sim/,protocol/|"
  "hal/stm32f4|hal/[a-z_]+\\.hpp,hal/stm32f4/|"
  "hal/sim|hal/[a-z_]+\\.hpp,hal/sim/|"
  "sim|core/,protocol/,hal/,avionics/,sim/|"
  "tools/fantail|core/,protocol/,hal/,avionics/,sim/,json/,text/,page/,report/,bench/,logs/,identify/,tunnel/,predict/,paper/,fly/,hil/,telemetry/,gateway/,link/,flight_log/,log_export/,fantail/|fmt/,poll\\.h,unistd\\.h,sys/,fcntl\\.h"
  "tools/bench|core/,protocol/,hal/,avionics/,sim/,json/,text/,page/,report/,link/,bench/|fmt/"
  "tools/text|text/|fmt/"
  "tools/json|json/|fmt/"
  "tools/page|json/,text/,page/|fmt/"
  "tools/link|core/,protocol/,hal/,link/|"
  "tools/gateway|core/,protocol/,hal/,bench/,telemetry/,gateway/|"
  "tools/fly|core/,protocol/,hal/,avionics/,sim/,report/,link/,fly/|fmt/"
  "tools/hil|core/,protocol/,hal/,avionics/,sim/,hil/|fmt/,fcntl\\.h,poll\\.h,sched\\.h,sys/,termios\\.h,unistd\\.h"
  "tools/telemetry|core/,protocol/,hal/,avionics/,link/,json/,telemetry/|fmt/,lcm/,fantail_lcm/,arpa/inet\\.h,netinet/in\\.h,poll\\.h,sys/socket\\.h,unistd\\.h"
  "tools/report|core/,json/,text/,page/,report/|fmt/"
  "tools/flight_log|core/,protocol/,hal/,avionics/,sim/,report/,flight_log/|fmt/"
  "tools/log_export|core/,protocol/,hal/,sim/,json/,report/,flight_log/,telemetry/,log_export/|fmt/"
  "tools/logs|core/,sim/,json/,report/,text/,flight_log/,logs/|fmt/"
  "tools/identify|core/,sim/,json/,text/,page/,report/,logs/,identify/|Eigen/,fmt/"
  "tools/tunnel|core/,sim/,json/,text/,page/,report/,logs/,identify/,tunnel/|Eigen/,fmt/"
  "tools/predict|core/,protocol/,hal/,avionics/,sim/,json/,text/,page/,report/,logs/,identify/,tunnel/,fly/,predict/|Eigen/,fmt/"
  "tools/paper|core/,protocol/,hal/,avionics/,sim/,json/,text/,page/,report/,logs/,identify/,tunnel/,fly/,predict/,paper/|Eigen/,fmt/")
# Single files that may include more than their folder does.
set(exceptions
  "firmware/boards/cortex_m4/startup.c|stdint\\.h"
  "firmware/core/motion_estimator.cpp|Eigen/"
  "firmware/protocol/generated/canard_bus.c|string\\.h"
  "firmware/protocol/generated/canard_bus.h|stdbool\\.h,stddef\\.h,stdint\\.h"
  "sim/toml_tree.cpp|toml\\+\\+/"
  "tools/json/value.cpp|nlohmann/"
  "tools/report/output_folder.cpp|fcntl\\.h,unistd\\.h,sys/"
  "tools/fantail/command_line.cpp|CLI/"
  "tools/report/sha256.cpp|sha256\\.h")

set(standard "^[a-z_]+$") # <vector>, <cmath>: the standard library has no dots and no slashes
# The pure floors have no heap, no clock and no input or output, and so no use for the headers that offer them.
set(pure "firmware/core" "firmware/protocol")
set(pure_standard "^(algorithm|array|bit|chrono|cmath|compare|concepts|cstddef|cstdint|cstring|limits|numbers|numeric|optional|span|string_view|tuple|type_traits|utility|variant)$")
set(wrong "")
foreach(row IN LISTS table)
  string(REPLACE "|" ";" row "${row}")
  list(GET row 0 folder)
  list(GET row 1 own)
  list(GET row 2 third_party)
  string(REPLACE "," ";" own "${own}")
  string(REPLACE "," ";" third_party "${third_party}")
  set(allowed_standard "${standard}")
  if(folder IN_LIST pure)
    set(allowed_standard "${pure_standard}")
  endif()
  file(GLOB_RECURSE sources RELATIVE ${ROOT} ${ROOT}/${folder}/*)
  list(FILTER sources INCLUDE REGEX "\\.(c|cc|cpp|cxx|h|hh|hpp|hxx|inc|inl|ipp)$")
  foreach(source IN LISTS sources)
    set(allowed ${third_party})
    foreach(exception IN LISTS exceptions)
      string(REPLACE "|" ";" exception "${exception}")
      list(GET exception 0 excepted)
      if(source STREQUAL excepted)
        list(GET exception 1 more)
        string(REPLACE "," ";" more "${more}")
        list(APPEND allowed ${more})
      endif()
    endforeach()
    file(STRINGS ${ROOT}/${source} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      set(ok FALSE)
      set(header "")
      if(line MATCHES "include[ \t]*<([^>]+)>")
        set(header "${CMAKE_MATCH_1}")
        if(header MATCHES "${allowed_standard}")
          set(ok TRUE)
        endif()
        foreach(pattern IN LISTS allowed)
          if(header MATCHES "^${pattern}")
            set(ok TRUE)
          endif()
        endforeach()
      elseif(line MATCHES "include[ \t]*\"([^\"]+)\"")
        set(header "${CMAKE_MATCH_1}")
        foreach(pattern IN LISTS own)
          if(header MATCHES "^${pattern}")
            set(ok TRUE)
          endif()
        endforeach()
      endif()
      if(header MATCHES "\\.\\.") # a detour out of the folder that was allowed
        set(ok FALSE)
      endif()
      if(NOT ok)
        string(APPEND wrong "  ${source}: ${line}\n")
      endif()
    endforeach()
  endforeach()
endforeach()
if(wrong)
  message(FATAL_ERROR "includes that do not point down (the table is in cmake/check_includes.cmake):\n${wrong}")
endif()
