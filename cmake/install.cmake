# SPDX-License-Identifier: MIT
# cmake --install: the programs with what they ship, and core and protocol for other projects, which say
# find_package(Fantail) and link Fantail::core and Fantail::protocol.
include(GNUInstallDirs)
# Whatever the umask: what root installs is for everyone.
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CMakePackageConfigHelpers)

install(TARGETS fantail RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
get_property(verbs GLOBAL PROPERTY FANTAIL_VERBS)
install(TARGETS ${verbs} RUNTIME DESTINATION libexec/fantail COMPONENT runtime)
install(PROGRAMS tools/with_vcan DESTINATION libexec/fantail COMPONENT runtime)
install(PROGRAMS tools/vcan/guest_init tools/vcan/inside DESTINATION libexec/fantail/vcan COMPONENT runtime)
install(FILES tools/vcan/guest tools/vcan/native tools/vcan/wide_ptrace.c DESTINATION libexec/fantail/vcan COMPONENT runtime)

# The folders keep their places, because scenarios name vehicles and plans by them.
set(data ${CMAKE_INSTALL_DATADIR}/fantail)
install(DIRECTORY sim/scenarios sim/vehicles sim/motors sim/tunnel_results DESTINATION ${data}/sim COMPONENT runtime)
install(DIRECTORY firmware/plans DESTINATION ${data}/firmware COMPONENT runtime)
install(DIRECTORY tools/rules/packs DESTINATION ${data}/tools/rules COMPONENT runtime)
install(DIRECTORY python/fantail/files DESTINATION ${data}/python/fantail COMPONENT runtime PATTERN "__pycache__" EXCLUDE)
install(FILES firmware/protocol/canard_bus.dbc firmware/protocol/plan_block.csv DESTINATION ${data} COMPONENT runtime)
install(DIRECTORY tools/telemetry/types/ DESTINATION ${data}/lcm COMPONENT runtime)
# The pages are made by the target `manual`; what completes in a shell asks the installed program.
install(DIRECTORY ${PROJECT_BINARY_DIR}/manual/ DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT runtime)
set(completions tools/manual/completions)
install(FILES ${completions}/fantail.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME fantail COMPONENT runtime)
install(FILES ${completions}/_fantail DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions COMPONENT runtime)
install(FILES ${completions}/fantail.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT runtime)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES third_party/uplot/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}/uplot COMPONENT runtime)

foreach(library IN ITEMS core protocol)
  install(DIRECTORY firmware/${library} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fantail COMPONENT development FILES_MATCHING PATTERN "*.hpp")
  set_target_properties(fantail_${library} PROPERTIES EXPORT_NAME ${library})
  target_compile_features(fantail_${library} INTERFACE cxx_std_20)
endforeach()
install(TARGETS fantail_core fantail_protocol fantail_protocol_generated fantail_flags fantail_flight_flags
  EXPORT FantailTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Fantail)
install(EXPORT FantailTargets NAMESPACE Fantail:: DESTINATION ${package} COMPONENT development)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/FantailConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(WRITE ${PROJECT_BINARY_DIR}/FantailConfig.cmake "include(\${CMAKE_CURRENT_LIST_DIR}/FantailTargets.cmake)\n")
install(FILES ${PROJECT_BINARY_DIR}/FantailConfig.cmake ${PROJECT_BINARY_DIR}/FantailConfigVersion.cmake DESTINATION ${package} COMPONENT development)
