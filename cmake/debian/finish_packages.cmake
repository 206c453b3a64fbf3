# Before cpack closes the packages: what Debian asks for beside the files that are installed. In each package's folder
# a copyright and a changelog; manual pages compressed.
set(names_runtime isostack)
set(names_development isostack-dev)
set(names_python python3-isostack)

# The newest release of CHANGELOG.md, "## [VERSION] - DATE".
get_filename_component(top ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
file(STRINGS ${top}/CHANGELOG.md releases REGEX "^## \\[[0-9]" LIMIT_COUNT 1)
if(NOT releases MATCHES "^## \\[(.+)\\] - ([0-9-]+)$" OR NOT CMAKE_MATCH_1 STREQUAL CPACK_PACKAGE_VERSION)
  message(FATAL_ERROR "CHANGELOG.md begins with '${releases}', not with version ${CPACK_PACKAGE_VERSION} and its date")
endif()
execute_process(COMMAND date -u -R -d ${CMAKE_MATCH_2} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)

foreach(component ${CPACK_COMPONENTS_ALL})
  set(name ${names_${component}})
  set(share ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr/share)
  file(COPY ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${share}/doc/${name})
  file(WRITE ${share}/doc/${name}/changelog
       "${name} (${CPACK_PACKAGE_VERSION}) bookworm; urgency=medium\n\n"
       "  * See CHANGELOG.md, in the sources and the documents of isostack.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  file(GLOB manuals ${share}/man/man1/*.1)
  execute_process(COMMAND gzip -9n ${share}/doc/${name}/changelog ${manuals} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
