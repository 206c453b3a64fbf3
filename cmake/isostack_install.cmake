# Installs programs, libraries and headers, and exports the targets for find_package(isostack).
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY ISOSTACK_LIBRARIES)
install(TARGETS ${libraries} EXPORT isostack_targets)
install(TARGETS isostack_program RUNTIME)
foreach(room recon io segmentation viewers)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/isostack
          FILES_MATCHING PATTERN "*.h")
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/segmentation/recipes DESTINATION ${CMAKE_INSTALL_DATADIR}/isostack)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/isostack)
install(EXPORT isostack_targets NAMESPACE isostack:: FILE isostack-targets.cmake DESTINATION ${config_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/isostack-config.cmake.in
  ${PROJECT_BINARY_DIR}/isostack-config.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/isostack-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/isostack-config.cmake ${PROJECT_BINARY_DIR}/isostack-config-version.cmake
        DESTINATION ${config_dir})
