# `cmake --build BUILD --target docs`: the documents as web pages in BUILD/docs/site, by mkdocs.
find_program(MKDOCS_PROGRAM mkdocs)
if(MKDOCS_PROGRAM)
  # For the target and the test: ${ISOSTACK_BUILD_SITE} -D OUT=FOLDER ${ISOSTACK_BUILD_SITE_SCRIPT}
  set(ISOSTACK_BUILD_SITE ${CMAKE_COMMAND} -D TOP=${PROJECT_SOURCE_DIR} -D VERSION=${PROJECT_VERSION}
    -D MKDOCS=${MKDOCS_PROGRAM} -D OPTIONS_PAGE=${PROJECT_BINARY_DIR}/cli/generated/markdown/options.md)
  set(ISOSTACK_BUILD_SITE_SCRIPT -P ${CMAKE_CURRENT_LIST_DIR}/docs/build_site.cmake)
  add_custom_target(docs VERBATIM
    COMMAND ${ISOSTACK_BUILD_SITE} -D OUT=${PROJECT_BINARY_DIR}/docs ${ISOSTACK_BUILD_SITE_SCRIPT})
  add_dependencies(docs shell_support)
endif()
