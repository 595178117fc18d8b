# SPDX-License-Identifier: MIT
# How every Fantail target is compiled: one interface target, linked by fantail_library() and fantail_executable().

add_library(fantail_flags INTERFACE)
target_compile_features(fantail_flags INTERFACE cxx_std_20)
target_compile_options(fantail_flags INTERFACE
  # Where several files are compiled as one, Clang takes a name of another file's unnamed namespace for shadowed; GCC does not.
  -Wall -Wextra -Wconversion $<$<CXX_COMPILER_ID:GNU>:-Wshadow> -Wdouble-promotion -Werror
  # GCC 12's std::stable_sort calls what the standard has deprecated; its own compiler is silent about that.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>
  # Clang warns that code compiled for wider registers could not call what takes a vector: there is none in its builds.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-psabi>
  # A fused multiply-add rounds once where a multiply and an add round twice: with it the rocket, the
  # simulator and a replay would differ in the last bit.
  -ffp-contract=off)
# GCC sweeps its memory at 128 MB, which a precompiled header alone nearly fills, again and again: a tenth of the time of a long
# compilation. Half a gigabyte is more than nearly every file here takes.
target_compile_options(fantail_flags INTERFACE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=524288>")

# The linker gold, of the same package as the usual one, takes a third of its time, and some hundred programs are linked.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT CMAKE_CROSSCOMPILING)
  find_program(FANTAIL_GOLD ld.gold NO_CACHE)
  if(FANTAIL_GOLD)
    target_link_options(fantail_flags INTERFACE $<BUILD_INTERFACE:-fuse-ld=gold>)
  endif()
endif()

# What has been compiled before need not be compiled again, in another clone either, where a compiler cache is installed.
# Not for the processor: the cache does not keep the call graph (-fcallgraph-info), from which the deepest stack is known.
if(NOT CMAKE_CROSSCOMPILING)
  find_program(FANTAIL_CCACHE ccache NO_CACHE)
endif()
if(FANTAIL_CCACHE)
  execute_process(COMMAND ${FANTAIL_CCACHE} --version RESULT_VARIABLE ccache_fails OUTPUT_QUIET ERROR_QUIET)
endif()
if(FANTAIL_CCACHE AND NOT ccache_fails AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  # What it has to overlook so that precompiled headers can be cached; folders are named from the sources on.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${FANTAIL_CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# Every 64-bit PC since about 2009, so that a build can be handed to the next desk.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  target_compile_options(fantail_flags INTERFACE -march=x86-64-v2)
endif()

# The Python module is linked from the same objects as the programs, so nothing is compiled twice. Hidden, a function is called
# in it, and in them, as directly as without.
if(NOT CMAKE_CROSSCOMPILING)
  target_compile_options(fantail_flags INTERFACE -fPIC -fvisibility=hidden)
endif()

set(fantail_sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
if(FANTAIL_SANITIZE)
  target_compile_options(fantail_flags INTERFACE ${fantail_sanitizers})
  target_compile_definitions(fantail_flags INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(fantail_flags INTERFACE -fsanitize=address,undefined)
endif()
if(FANTAIL_FUZZ)
  target_compile_options(fantail_flags INTERFACE
    -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_compile_definitions(fantail_flags INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(fantail_flags INTERFACE -fsanitize=address,undefined)
endif()
# Of the tests too: a function in a header may be taken from their objects, and would not count there.
if(FANTAIL_COVERAGE)
  target_compile_options(fantail_flags INTERFACE -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc)
  target_link_options(fantail_flags INTERFACE -fprofile-instr-generate)
endif()

# What flies is compiled as on the board: no exceptions, no run-time types, and no errno, which would turn sqrtf
# into a library call on the Cortex-M4.
add_library(fantail_flight_flags INTERFACE)
target_compile_options(fantail_flight_flags INTERFACE -fno-exceptions -fno-rtti -fno-math-errno -fno-threadsafe-statics)
