# SPDX-License-Identifier: MIT
# The house has floors: tools, sim, firmware, hal. An include only ever points down (layers.cmake).
#
# Each library owns one include root in the build tree that holds nothing but a link to its own folder, so a target
# sees the headers of the libraries it links and no others: a wrong include does not compile. What a compiler cannot
# see (system-wide third-party headers, "../" paths) is checked by check_includes.cmake, which runs in every build.

include(${CMAKE_CURRENT_LIST_DIR}/layers.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/together.cmake)

# The standard library takes most of the compile time: on a PC GCC 12 reads it once for each set of flags. For the processor,
# by other compilers and under the `host-asan` preset it is not, and so an #include that is missing is found there. Targets
# link what is named in FANTAIL_PRECOMPILED, or nothing. A function keeps the level of optimisation at which it was read, in
# files of another level too: read for -O3, the standard library cost a fifth of the time of compiling the tools, which are for -O1.
function(fantail_precompiled name)
  cmake_parse_arguments(ARG "" "" "HEADERS;USES;OPTIONS" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  target_link_libraries(${name} PRIVATE fantail_flags ${ARG_USES})
  target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

# -w: the same files are compiled with all warnings once already, and GCC 12 invents some under the sanitizers.
set(fantail_twin_options ${fantail_sanitizers} -D_GLIBCXX_ASSERTIONS -O1 -g1 -w)
set(FANTAIL_PRECOMPILED "")
set(FANTAIL_PRECOMPILED_FLIGHT "")
# Newer compilers take a precompiled header only for the level of optimisation that it was read for.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13 AND NOT CMAKE_CROSSCOMPILING)
  set(FANTAIL_PRECOMPILED precompiled)
  set(FANTAIL_PRECOMPILED_FLIGHT precompiled_flight)
  set(headers <algorithm> <array> <bit> <chrono> <cmath> <cstdint> <optional> <span> <string_view> <utility> <variant>)
  set(more_headers <filesystem> <functional> <map> <memory> <string> <vector>)
  foreach(twin IN ITEMS "" _sanitized)
    if(twin AND (FANTAIL_SANITIZE OR NOT FANTAIL_TESTS))
      break()
    endif()
    set(options "")
    if(twin)
      set(options ${fantail_twin_options})
    endif()
    fantail_precompiled(precompiled_flight${twin} HEADERS ${headers} USES fantail_flight_flags OPTIONS ${options})
    fantail_precompiled(precompiled${twin} HEADERS ${headers} ${more_headers} OPTIONS ${options})
  endforeach()
  fantail_precompiled(precompiled_tools HEADERS ${headers} ${more_headers} OPTIONS $<$<CONFIG:Release>:-O1>)
  foreach(with_strings IN ITEMS precompiled precompiled_sanitized precompiled_tools)
    # Of std::string out of a precompiled header GCC 12 says so without reason. Clang and the sanitizers look too.
    if(TARGET ${with_strings})
      target_compile_options(${with_strings} INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
    endif()
  endforeach()
endif()

# fantail_library(<name> INCLUDE_AS <prefix> [FLIGHT] SOURCES <file>... [ONLY <folder>...] [USES <library>...]
#   [PRIVATE_USES <library>...])
# Headers of this folder are included as <prefix>/file.hpp. It links the libraries of the folders that stand in its row of
# layers.cmake (ONLY: of these of them, where programs beside it link the others); USES and PRIVATE_USES are what is not ours.
#
# With FANTAIL_TESTS the libraries of FANTAIL_TWINNED have a twin, <name>_sanitized, compiled for the address and
# undefined-behaviour sanitizers and built only for the tests that ask for it (fantail_test(... SANITIZED)): what flies, and
# the reader of its logs. What these link besides is compiled once; ./dev sanitize has everything under the sanitizers.
set(FANTAIL_TWINNED fantail_core fantail_protocol fantail_protocol_generated fantail_hal fantail_hal_sim fantail_avionics
  fantail_flight_log)
function(fantail_library name)
  cmake_parse_arguments(ARG "FLIGHT" "INCLUDE_AS" "SOURCES;ONLY;USES;PRIVATE_USES" ${ARGN})
  if(NOT ARG_ONLY)
    fantail_allowed_here(ARG_ONLY)
  endif()
  foreach(folder IN LISTS ARG_ONLY)
    string(REPLACE "/" "_" library "fantail_${folder}")
    list(APPEND ARG_USES ${library})
  endforeach()
  set(scope PUBLIC)
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_SOURCES})
    fantail_compiled_together(${name} ${ARG_SOURCES})
    target_link_libraries(${name} PRIVATE fantail_flags)
    if(ARG_FLIGHT)
      target_link_libraries(${name} PRIVATE fantail_flight_flags)
      fantail_precompile(${name} ${FANTAIL_PRECOMPILED_FLIGHT})
    else()
      fantail_precompile(${name} ${FANTAIL_PRECOMPILED})
    endif()
  else()
    set(scope INTERFACE)
    add_library(${name} INTERFACE)
  endif()

  set(root ${PROJECT_BINARY_DIR}/include/${name})
  cmake_path(GET ARG_INCLUDE_AS PARENT_PATH parent)
  file(MAKE_DIRECTORY ${root}/${parent})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR} ${root}/${ARG_INCLUDE_AS} SYMBOLIC)
  target_include_directories(${name} ${scope} $<BUILD_INTERFACE:${root}> $<INSTALL_INTERFACE:include/fantail>)

  target_link_libraries(${name} ${scope} ${ARG_USES})
  if(ARG_PRIVATE_USES)
    target_link_libraries(${name} PRIVATE ${ARG_PRIVATE_USES})
  endif()
  if(ARG_SOURCES)
    add_dependencies(${name} check_includes)
  endif()
  if(FANTAIL_TESTS AND NOT FANTAIL_SANITIZE AND name IN_LIST FANTAIL_TWINNED)
    fantail_sanitized_twin(${name})
  endif()
endfunction()

# The folders that the one at hand may include, by its row of layers.cmake.
function(fantail_allowed_here result)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE here)
  foreach(row IN LISTS FANTAIL_LAYERS)
    fantail_split("${row}" layer)
    if(layer_0 STREQUAL here)
      set(${result} "${layer_1}" PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "${here} has no row in cmake/layers.cmake")
endfunction()

# What a target links, with the libraries that have twins replaced by them.
function(fantail_twins result)
  set(${result} "")
  foreach(library IN LISTS ARGN)
    if(library IN_LIST FANTAIL_TWINNED)
      string(APPEND library _sanitized)
    endif()
    list(APPEND ${result} ${library})
  endforeach()
  set(${result} ${${result}} PARENT_SCOPE)
endfunction()

function(fantail_sanitized_twin name)
  get_target_property(type ${name} TYPE)
  fantail_twins(uses ${ARG_USES})
  if(type STREQUAL INTERFACE_LIBRARY)
    add_library(${name}_sanitized INTERFACE)
    target_include_directories(${name}_sanitized INTERFACE ${root})
    target_link_libraries(${name}_sanitized INTERFACE ${uses})
    return()
  endif()
  fantail_twins(private_uses ${ARG_PRIVATE_USES})
  add_library(${name}_sanitized STATIC EXCLUDE_FROM_ALL ${ARG_SOURCES})
  target_include_directories(${name}_sanitized PUBLIC ${root})
  target_link_libraries(${name}_sanitized PUBLIC ${uses} PRIVATE fantail_flags ${private_uses})
  set(precompiled precompiled_sanitized)
  if(ARG_FLIGHT)
    target_link_libraries(${name}_sanitized PRIVATE fantail_flight_flags)
    set(precompiled precompiled_flight_sanitized)
  endif()
  target_compile_options(${name}_sanitized PRIVATE ${fantail_twin_options})
  # The same files a second time: the linter would read each of them twice.
  set_target_properties(${name}_sanitized PROPERTIES FANTAIL_IS_TWIN ON EXPORT_COMPILE_COMMANDS OFF)
  fantail_compiled_together(${name}_sanitized ${ARG_SOURCES})
  fantail_precompile(${name}_sanitized ${precompiled})
endfunction()

# fantail_small(<file>...): of the library in this folder, what runs at power-up, on the ground, or so seldom that in an
# image its size counts and not its speed.
function(fantail_small)
  if(CMAKE_CROSSCOMPILING)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -Os)
  endif()
endfunction()

# fantail_kernel(<file>...): of a folder that is compiled for a quick build (-O1: tools and tests), what goes through every
# sample of a log or every cell of a grid, and is worth the optimiser's time. Not in a twin: GCC 12 crashes on some.
function(fantail_kernel)
  fantail_level("$<$<AND:$<CONFIG:Release>,$<NOT:$<BOOL:$<TARGET_PROPERTY:FANTAIL_IS_TWIN>>>>:-O3>" ${ARGN})
endfunction()

# fantail_precompile(<target> [<what fantail_precompiled() has made>])
function(fantail_precompile name)
  if(TARGET "${ARGN}")
    target_precompile_headers(${name} REUSE_FROM ${ARGN})
    target_compile_options(${name} PRIVATE $<TARGET_PROPERTY:${ARGN},INTERFACE_COMPILE_OPTIONS>)
  endif()
endfunction()

function(fantail_executable name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  fantail_compiled_together(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE fantail_flags ${ARG_USES})
  fantail_precompile(${name} ${FANTAIL_PRECOMPILED})
  add_dependencies(${name} check_includes)
endfunction()

# Again when one of the files that it read has changed; a new one has to be named by one of them.
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/includes.checked
  COMMAND ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR} -D EXACT=ON -D STAMP=${PROJECT_BINARY_DIR}/includes.checked
          -P ${PROJECT_SOURCE_DIR}/cmake/check_includes.cmake
  DEPENDS ${PROJECT_SOURCE_DIR}/cmake/check_includes.cmake ${PROJECT_SOURCE_DIR}/cmake/layers.cmake
  DEPFILE ${PROJECT_BINARY_DIR}/includes.checked.d
  COMMENT "Checking that includes only point down"
  VERBATIM)
add_custom_target(check_includes ALL DEPENDS ${PROJECT_BINARY_DIR}/includes.checked)
