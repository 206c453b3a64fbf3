# Installs programs, libraries and headers, and exports the targets for find_package(isostack).
# Components: runtime (programs, documents), development (libraries, headers), python (see python/CMakeLists.txt).
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY ISOSTACK_LIBRARIES)
install(TARGETS ${libraries} EXPORT isostack_targets COMPONENT development)
install(TARGETS isostack_program isostack_make_phantom isostack_make_shapes isostack_make_key_shapes
        RUNTIME COMPONENT runtime)
install(PROGRAMS ${PROJECT_SOURCE_DIR}/sample_data/isostack_demo TYPE BIN COMPONENT runtime)
foreach(page isostack_make_phantom isostack_make_shapes isostack_make_key_shapes isostack_demo)
  install(FILES ${PROJECT_SOURCE_DIR}/sample_data/isostack_sample_data.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
          RENAME ${page}.1 COMPONENT runtime)
endforeach()

# Headers that name GDCM, VTK or Highway, and those that include such a header, are for the sources beside them:
# whoever uses the installed libraries need not have those.
set(rooms recon io segmentation viewers)
list(TRANSFORM rooms APPEND "/*.h" OUTPUT_VARIABLE patterns)
file(GLOB_RECURSE headers RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${patterns})
set(pattern "gdcm::|namespace gdcm|<gdcm|<vtk|vtk[A-Z]|<hwy/")
while(pattern)
  set(found "")
  foreach(header ${headers})
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} lines REGEX "${pattern}")
    if(lines)
      list(APPEND found ${header})
    endif()
  endforeach()
  list(REMOVE_ITEM headers ${found})
  list(TRANSFORM found PREPEND "#include \"")
  list(JOIN found "|" pattern)
endwhile()
foreach(header ${headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/isostack/${folder}
          COMPONENT development)
endforeach()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/segmentation/recipes ${PROJECT_SOURCE_DIR}/recon/morphing/recipes
        ${PROJECT_SOURCE_DIR}/sample_data/cohort DESTINATION ${CMAKE_INSTALL_DATADIR}/isostack
        USE_SOURCE_PERMISSIONS COMPONENT runtime
        PATTERN "__pycache__" EXCLUDE PATTERN ".snakemake" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md TYPE DOC COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs TYPE DOC COMPONENT runtime)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/isostack)
install(EXPORT isostack_targets NAMESPACE isostack:: FILE isostack-targets.cmake
        DESTINATION ${config_dir} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/isostack-config.cmake.in
  ${PROJECT_BINARY_DIR}/isostack-config.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/isostack-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/isostack-config.cmake ${PROJECT_BINARY_DIR}/isostack-config-version.cmake
        DESTINATION ${config_dir} COMPONENT development)
