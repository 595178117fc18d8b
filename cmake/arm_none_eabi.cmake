# SPDX-License-Identifier: MIT
# Toolchain file: Debian's arm-none-eabi GCC for the STM32F405, a Cortex-M4 with a single-precision FPU.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY) # a program needs a linker script, which is the board's
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

# -Wno-psabi: a remark about GCC 6, which nobody links with. Stack use and call graph are for the stack report.
set(CMAKE_C_FLAGS_INIT
  "-mcpu=cortex-m4 -mthumb -mfpu=fpv4-sp-d16 -mfloat-abi=hard -ffunction-sections -fdata-sections -fstack-usage -fcallgraph-info=su")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT} -fno-use-cxa-atexit -Wno-psabi")
# In the cache, because what a toolchain file gives as _INIT stands before CMake's own -O3.
set(CMAKE_C_FLAGS_RELEASE "-O2 -g -DNDEBUG" CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -g -DNDEBUG" CACHE STRING "")
