# SPDX-License-Identifier: MIT
# What runs on the processor instead of under an operating system.

find_package(Python3 REQUIRED COMPONENTS Interpreter)

# fantail_image(<name> SOURCES <file>... USES <library>... [DEFINES <symbol>=<value>...]): <name>.elf, .hex, .bin and .map in
# the build folder's top. The ELF is sealed: its last word is the CRC-32C of everything before it.
function(fantail_image name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES" ${ARGN})
  set(script ${PROJECT_SOURCE_DIR}/firmware/boards/cortex_m4/stm32f405.ld)
  set(elf ${PROJECT_BINARY_DIR}/${name}.elf)
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES SUFFIX .unsealed.elf RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}
    LINK_DEPENDS ${script})
  target_link_libraries(${name} PRIVATE fantail_flags fantail_flight_flags fantail_startup ${ARG_USES})
  target_link_options(${name} PRIVATE -nostartfiles -specs=nano.specs -T${script} -Wl,--gc-sections
    -Wl,--fatal-warnings -Wl,-Map=${PROJECT_BINARY_DIR}/${name}.map)
  add_dependencies(${name} check_includes)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/cmake/seal_image.py ${CMAKE_OBJCOPY} $<TARGET_FILE:${name}> ${elf}
    COMMAND ${CMAKE_OBJCOPY} -O ihex ${elf} ${PROJECT_BINARY_DIR}/${name}.hex
    COMMAND ${CMAKE_OBJCOPY} -O binary ${elf} ${PROJECT_BINARY_DIR}/${name}.bin
    VERBATIM)
endfunction()
