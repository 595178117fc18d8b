# SPDX-License-Identifier: MIT
# cpack -G DEB: one package of the programs with what they ship, for Debian 12 and 13 (./dev package).
#
# Three libraries have other names in Debian 13 and go into the package, beside its own programs; every other one is named
# among what it depends on, by dpkg-shlibdeps.
set(carried fmt cpp-httplib zip)
set(private libexec/fantail/lib)
foreach(name IN LISTS carried)
  find_library(library_${name} ${name} REQUIRED NO_CACHE)
  file(REAL_PATH ${library_${name}} file)
  execute_process(COMMAND objdump -p ${file} OUTPUT_VARIABLE header ERROR_QUIET)
  string(REGEX MATCH "SONAME +([^\n]+)" found "${header}")
  install(FILES ${file} DESTINATION ${private} RENAME ${CMAKE_MATCH_1} COMPONENT package EXCLUDE_FROM_ALL)
endforeach()

set(debian ${PROJECT_BINARY_DIR}/debian)
set(documents ${CMAKE_INSTALL_DATADIR}/doc/fantail)
install(FILES ${debian}/copyright ${debian}/changelog.gz ${debian}/CHANGELOG.md.gz DESTINATION ${documents} COMPONENT package EXCLUDE_FROM_ALL)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/package/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME fantail
  COMPONENT package EXCLUDE_FROM_ALL)
# What is written into the board, as ./dev firmware has built it.
foreach(kind IN ITEMS hex bin)
  install(FILES ${PROJECT_SOURCE_DIR}/build/arm/fantail-stm32f405.${kind} DESTINATION ${CMAKE_INSTALL_DATADIR}/fantail/firmware/image
    COMPONENT package EXCLUDE_FROM_ALL)
endforeach()

set(CPACK_PACKAGE_NAME fantail)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "roll control for sounding rockets, from the wind tunnel to flight")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Fantail is avionics that stops a sounding rocket from rolling, with four
canards behind its nose cone, and the tools round it: the simulator in which
the same flight code flies on a desktop, checks of real canards over CAN,
analysis of wind-tunnel sessions, identification of the roll model from logs,
and prediction of the next launch.

This package has every program, the shipped rockets, scenarios and flight
plans, the CAN database, the LCM types, and the image for the board.

It needs a processor of x86-64-v2 (SSE 4.2, POPCNT), as PCs have had since
about 2009; on an older one it says so and ends.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_FILE_NAME fantail_${PROJECT_VERSION}_amd64)
set(CPACK_GENERATOR DEB)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package/as_debian_has_it.cmake)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime package)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "The Fantail authors <fantail@localhost>")
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-venv")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "can-utils, openocd")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
include(CPack)
