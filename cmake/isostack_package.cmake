# `cpack` in the build folder makes isostack_VERSION_ARCH.deb for the Debian it is built on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME isostack)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_CONTACT "isostack developers <isostack@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # what the program needs at run time, from the libraries it links
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "xvfb, xauth") # pictures without a screen
include(CPack)
