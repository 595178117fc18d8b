# SPDX-License-Identifier: MIT
# The layers of the house, from the bottom: each folder and the folders that it may include. This is the one list of them. A
# library links what stands in its row (fantail_library), and check_includes.cmake refuses every other #include and every entry
# that nobody needs. A folder may only name folders above it here, so that no arrow points up.
#
# folder | what it may include, by the folder in the #include | headers of others (regular expressions)
set(FANTAIL_LAYERS
  "hal/include/hal||"
  "hal/linux|hal|fcntl\\.h linux/can net/if poll\\.h sys/ unistd\\.h"
  "hal/sim|hal|"
  "hal/stm32f4|hal|"
  "firmware/core||"
  "firmware/protocol|core|"
  "hal/emulator|hal|"
  "firmware/world_link|protocol hal hal/sim hal/emulator|"
  "firmware/avionics|core protocol hal|"
  "firmware/boards/cortex_m4|protocol|"
  "firmware/boards/stm32f405|core protocol hal hal/stm32f4 avionics boards/cortex_m4|"
  "firmware/boards/emulator|core protocol hal/sim hal/stm32f4 hal/emulator world_link avionics boards/stm32f405|"
  "sim|core protocol hal hal/sim avionics|"
  "tools/text||fmt/"
  "tools/json||fmt/"
  "tools/manual|text|fmt/"
  "tools/distributions||"
  "tools/linear||Eigen/"
  "tools/page|text json|fmt/"
  "tools/result|text json page|fmt/"
  "tools/input|core sim text|fmt/ pugixml\\.hpp"
  "tools/flight|core text input|fmt/"
  "tools/files|text json input flight|fmt/"
  "tools/trajectory|sim text files input flight|fmt/"
  "tools/report|text json page result flight|fmt/"
  "tools/flight_log|core protocol hal avionics text input flight|fmt/"
  "tools/logs|sim text files input flight report flight_log|fmt/"
  "tools/listen|core sim text json page result input files flight report logs|fmt/"
  "tools/identify/model|sim text|Eigen/ fmt/"
  "tools/identify/closed_loop|core text identify/model|Eigen/ fmt/"
  "tools/identify/result|text distributions json linear page result identify/model identify/closed_loop|Eigen/ fmt/"
  "tools/identify|sim text linear input logs identify/model identify/closed_loop identify/result|Eigen/ fmt/"
  "tools/tunnel|text distributions json linear page result files flight flight_log logs identify identify/model|Eigen/ fmt/"
  "tools/replies|core protocol hal|"
  "tools/link|core protocol hal avionics text replies|fmt/"
  "tools/stability|core sim|"
  "tools/airframe/model|sim|"
  "tools/airframe/openrocket|sim text airframe/model|fmt/ pugixml\\.hpp zip\\.h zlib\\.h"
  "tools/airframe|core sim text json page result stability airframe/model|fmt/"
  "tools/fly|core sim input flight replies stability airframe/model|fmt/"
  "tools/hil|core protocol world_link sim text|fmt/ fcntl\\.h poll\\.h sched\\.h sys/ termios\\.h unistd\\.h"
  "tools/telemetry|core hal avionics text json replies|fmt/ lcm/ fantail_lcm/ arpa/inet\\.h netinet/in\\.h poll\\.h sys/ unistd\\.h"
  "tools/live|core hal text json page telemetry|fmt/ arpa/inet\\.h"
  "tools/gateway|hal link telemetry|"
  "tools/log_export|core protocol text files json input flight flight_log telemetry|fmt/"
  "tools/bench|core protocol hal avionics sim text distributions json page result replies link|fmt/"
  "tools/runs|sim text json|fmt/"
  "tools/dormancy|core sim text flight report stability fly runs|fmt/"
  "tools/hardover|core sim text json page result flight fly runs|fmt/"
  "tools/campaign|sim text distributions json linear page result input flight report fly runs dormancy hardover|fmt/"
  "tools/rare|core sim text distributions page result input flight report runs campaign|fmt/"
  "tools/brief|core hal sim text json page result flight report fly campaign hardover|fmt/"
  "tools/predict|core sim text distributions json page result flight report stability airframe/model fly runs dormancy campaign|fmt/"
  "tools/tune|core protocol sim text json page result input flight report stability fly runs campaign predict|fmt/"
  "tools/paper|core sim text json page result input flight report identify identify/model identify/closed_loop tunnel fly|fmt/"
  "tools/detection|core sim text distributions json page result input runs|fmt/"
  "tools/faults|core sim text json page result input flight fly runs campaign|fmt/"
  "tools/playground|core sim text json input flight report fly|fmt/"
  "tools/rules|core sim text result input flight airframe/model|fmt/"
  "tools/fantail|core protocol avionics hal/linux sim text json manual page result input files flight report flight_log logs identify identify/model identify/result tunnel replies link trajectory stability fly hil telemetry live gateway log_export bench runs campaign hardover predict tune paper airframe airframe/openrocket listen detection faults rules brief dormancy rare|fmt/ fcntl\\.h poll\\.h sys/ unistd\\.h"
  "python/bindings|core protocol sim text json manual input flight report flight_log logs fly runs campaign fantail|nanobind/")

# Headers of others that only one file of a folder includes, behind a header of ours. Of our own folders there is no exception.
set(FANTAIL_SINGLE_FILES
  "firmware/boards/cortex_m4/startup.c|stdint\\.h"
  "firmware/core/motion_estimator.cpp|Eigen/"
  "firmware/protocol/crc32c_sse42.cpp|nmmintrin\\.h"
  "firmware/protocol/generated/canard_bus.c|string\\.h"
  "firmware/protocol/generated/canard_bus.h|stdbool\\.h stddef\\.h stdint\\.h"
  "tools/input/toml_tree.cpp|toml\\+\\+/"
  "tools/json/value.cpp|nlohmann/"
  "tools/live/http_server.hpp|httplib\\.h"
  "tools/live/http_server.cpp|poll\\.h"
  "tools/text/input_file.cpp|fcntl\\.h poll\\.h unistd\\.h sys/"
  "tools/text/output_folder.cpp|fcntl\\.h unistd\\.h sys/"
  "tools/files/convert.cpp|poll\\.h spawn\\.h sys/ unistd\\.h"
  "tools/text/folder_lock.cpp|fcntl\\.h unistd\\.h sys/"
  "tools/fantail/command_line.cpp|CLI/"
  "tools/fantail/read_command_line.cpp|CLI/"
  "tools/text/deflate.cpp|zlib\\.h"
  "tools/text/sha256.cpp|sha256\\.h"
  "tools/runs/folder.cpp|fcntl\\.h sys/ unistd\\.h"
  "tools/campaign/sensitivity.cpp|Eigen/")

# Splits a row of either list into <prefix>_0, _1, ... ; the first is a word, the others are lists.
function(fantail_split row prefix)
  string(REPLACE "|" ";" cells "${row}")
  set(i 0)
  foreach(cell IN LISTS cells)
    string(REPLACE " " ";" cell "${cell}")
    set(${prefix}_${i} "${cell}" PARENT_SCOPE)
    math(EXPR i "${i} + 1")
  endforeach()
endfunction()

# What an #include calls a folder: firmware/core is core, hal/sim is hal/sim, tools/identify/model is identify/model.
function(fantail_include_name folder result)
  string(REGEX REPLACE "^(firmware|tools|hal/include)/" "" name "${folder}")
  set(${result} "${name}" PARENT_SCOPE)
endfunction()
