# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Usage: cmake -D SOURCE=<project> -D VERSION=<x.y.z> -D OUT=<file.cpp> -P identity.cmake
# Writes what avionics/identity.hpp declares, and leaves the file alone when nothing has changed.

include(${CMAKE_CURRENT_LIST_DIR}/commit.cmake)
fantail_commit(${SOURCE} hash seconds)
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
