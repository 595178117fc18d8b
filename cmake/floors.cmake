# SPDX-License-Identifier: MIT
# The house has floors: tools, sim, firmware, hal. An include only ever points down.
#
# Each library owns one include root in the build tree that holds nothing but a link to its own folder, so a target
# sees the headers of the libraries it links and no others: a wrong include does not compile. What a compiler cannot
# see (system-wide third-party headers, "../" paths) is checked by check_includes.cmake, which runs in every build.

# fantail_library(<name> INCLUDE_AS <prefix> [FLIGHT] SOURCES <file>... [USES <library>...] [PRIVATE_USES <library>...])
# Headers of this folder are included as <prefix>/file.hpp.
function(fantail_library name)
  cmake_parse_arguments(ARG "FLIGHT" "INCLUDE_AS" "SOURCES;USES;PRIVATE_USES" ${ARGN})
  set(scope PUBLIC)
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE fantail_flags)
    if(ARG_FLIGHT)
      target_link_libraries(${name} PRIVATE fantail_flight_flags)
    endif()
  else()
    set(scope INTERFACE)
    add_library(${name} INTERFACE)
  endif()

  set(root ${PROJECT_BINARY_DIR}/include/${name})
  cmake_path(GET ARG_INCLUDE_AS PARENT_PATH parent)
  file(MAKE_DIRECTORY ${root}/${parent})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/${ARG_INCLUDE_AS} SYMBOLIC)
  target_include_directories(${name} ${scope} ${root})

  target_link_libraries(${name} ${scope} ${ARG_USES})
  if(ARG_PRIVATE_USES)
    target_link_libraries(${name} PRIVATE ${ARG_PRIVATE_USES})
  endif()
  if(ARG_SOURCES)
    add_dependencies(${name} check_includes)
  endif()
endfunction()

# fantail_small(<file>...): of the library in this folder, what runs at power-up, on the ground, or so seldom that in an
# image its size counts and not its speed.
function(fantail_small)
  if(CMAKE_CROSSCOMPILING)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -Os)
  endif()
endfunction()

function(fantail_executable name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE fantail_flags ${ARG_USES})
  add_dependencies(${name} check_includes)
endfunction()

add_custom_target(check_includes ALL
  COMMAND ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/check_includes.cmake
  COMMENT "Checking that includes only point down"
  VERBATIM)
