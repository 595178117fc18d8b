# SPDX-License-Identifier: MIT
# fantail_commit(<source> <hash> <seconds>): which commit the sources in this folder are, and when it was made. Asked of git, or
# read where `git archive` has written it; "unknown" and nothing where neither knows.
function(fantail_commit source hash seconds)
  set(${hash} "unknown" PARENT_SCOPE)
  set(${seconds} "" PARENT_SCOPE)
  file(STRINGS ${source}/cmake/commit.txt archived REGEX "^[0-9a-f]+ [0-9]+$")
  if(archived MATCHES "^([0-9a-f]+) ([0-9]+)$")
    set(${seconds} ${CMAKE_MATCH_2} PARENT_SCOPE)
    string(SUBSTRING ${CMAKE_MATCH_1} 0 12 digits)
    set(${hash} ${digits}-archive PARENT_SCOPE) # whether they have been changed since then nobody can tell
  endif()
  find_program(git git)
  if(NOT git)
    return()
  endif()
  # A copy of the sources inside of somebody else's repository is not that repository.
  execute_process(COMMAND ${git} -C ${source} rev-parse --show-toplevel
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  file(REAL_PATH "${source}" here)
  if(NOT top STREQUAL here)
    return()
  endif()
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env GIT_OPTIONAL_LOCKS=0
      ${git} -C ${source} describe --always --dirty --abbrev=12 --exclude=*
    OUTPUT_VARIABLE answer OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(answer MATCHES "^[0-9a-f]+(-dirty)?$")
    set(${hash} ${answer} PARENT_SCOPE)
    execute_process(COMMAND ${git} -C ${source} log -1 --format=%ct
      OUTPUT_VARIABLE when OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    set(${seconds} "${when}" PARENT_SCOPE)
  endif()
endfunction()
