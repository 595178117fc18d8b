# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Usage: cmake -D SOURCE=<project> -D OUT=<file> -P day_of_sources.cmake
# Writes the day that man pages bear: that of the sources and not of the build, so that every build of a commit has the same
# bytes. It is that of SOURCE_DATE_EPOCH, of the commit, or where that is unknown, on which the changelog was last changed.
include(${CMAKE_CURRENT_LIST_DIR}/commit.cmake)
fantail_commit(${SOURCE} hash seconds)
if(NOT "$ENV{SOURCE_DATE_EPOCH}" STREQUAL "")
  set(seconds $ENV{SOURCE_DATE_EPOCH})
endif()
if(seconds STREQUAL "")
  file(TIMESTAMP ${SOURCE}/CHANGELOG.md day "%Y-%m-%d" UTC)
else()
  set(ENV{SOURCE_DATE_EPOCH} ${seconds})
  string(TIMESTAMP day "%Y-%m-%d" UTC)
endif()
set(before "")
if(EXISTS ${OUT})
  file(READ ${OUT} before)
endif()
if(NOT before STREQUAL "${day}\n")
  file(WRITE ${OUT} "${day}\n")
endif()
