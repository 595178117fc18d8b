# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Usage: cmake -D SOURCE=<project> -D VERSION=<x.y.z> -D OUT=<file.cpp> -P identity.cmake
# Writes what avionics/identity.hpp declares, and leaves the file alone when nothing has changed.

set(hash "unknown")
find_program(git git)
if(git)
  # A copy of the sources inside of somebody else's repository is not that repository.
  execute_process(COMMAND ${git} -C ${SOURCE} rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${SOURCE}" source)
  if(top STREQUAL source)
    execute_process(
      COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0
        ${git} -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
      OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(answer MATCHES "^[0-9a-f]+(-dirty)?$")
      set(hash ${answer})
    endif()
  endif()
endif()

set(content "// Written by cmake/identity.cmake.
#include \"avionics/identity.hpp\"

namespace fantail::avionics {
std::string_view git_hash() { return \"${hash}\"; }
std::string_view firmware_version() { return \"${VERSION}\"; }
}  // namespace fantail::avionics
")
set(before "")
if(EXISTS ${OUT})
  file(READ ${OUT} before)
endif()
if(NOT before STREQUAL content)
  file(WRITE ${OUT} "${content}")
endif()
