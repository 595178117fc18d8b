# SPDX-License-Identifier: MIT
cmake_minimum_required(VERSION 3.25)
# Usage: cmake -D MODULE=<.wasm> -D NATIVE=<.json> -D VERSION=<x.y.z> -D HASH=<of the sources> -D OUT=<.html> -P make_page.cmake
# One page with all that it needs in itself.
set(page ${CMAKE_CURRENT_LIST_DIR}/page)
cmake_path(SET root NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../..)

function(read_all name) # its files, one behind the other
  set(all "")
  foreach(file IN LISTS ARGN)
    file(READ ${file} text)
    string(APPEND all "${text}")
  endforeach()
  set(${name} "${all}" PARENT_SCOPE)
endfunction()

read_all(html ${page}/playground.html)
read_all(css ${root}/tools/page/assets/chart.css ${root}/third_party/uplot/uPlot.min.css ${page}/playground.css)
read_all(worker ${page}/module_host.js ${page}/worker.js)
read_all(js ${page}/settings.js ${root}/tools/page/assets/rocket.js ${root}/tools/page/assets/plot_frame.js ${page}/plots.js ${page}/flights.js ${page}/controls.js ${page}/playground.js)
read_all(uplot ${root}/third_party/uplot/uPlot.iife.min.js)
read_all(uplot_licence ${root}/third_party/uplot/LICENSE)
read_all(native ${NATIVE})
execute_process(COMMAND base64 -w 0 ${MODULE} OUTPUT_VARIABLE module COMMAND_ERROR_IS_FATAL ANY)
set(version ${VERSION})
set(sources ${HASH})
# Each part once; the largest last, because every step copies the text.
foreach(part IN ITEMS css worker version sources native js uplot_licence uplot module)
  string(REPLACE "{${part}}" "${${part}}" html "${html}")
endforeach()
file(WRITE ${OUT} "${html}")
