# `cpack` in the build folder makes the Debian packages isostack (programs, documents), isostack-dev (libraries, headers)
# and, where the Python module is built, python3-isostack, for the Debian it is built on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME isostack)
set(CPACK_PACKAGE_VENDOR isostack)
set(CPACK_PACKAGE_CONTACT "isostack developers <maintainers@isostack.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_NAME} built using CMake") # CPack's default: not put before those below
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian/finish_packages.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_THREADS 0) # all cores
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME isostack)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON) # what the programs need at run time, from the libraries they link
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS "python3:any") # scripts of the cohort workflow
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "xvfb, xauth") # pictures without a screen
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SUGGESTS "snakemake, slurm-wlm") # cohorts
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "smooth closed surfaces from stacks of medical image slices
isostack turns image slices (DICOM, NIfTI, NRRD, MetaImage, pictures,
contours), parallel or not, evenly spaced or not, into one smooth closed
surface per organ, through one variational implicit function; it segments,
compares, morphs and shows them. Research software, not for clinical use.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME isostack-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(JOIN ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  libvtk9-dev libeigen3-dev libgdcm-dev libgdcm-tools libopenimageio-dev openimageio-tools libopencv-core-dev libtbb-dev
  libfmt-dev nlohmann-json3-dev libopenblas-dev libhwy-dev libx11-dev zlib1g-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "libraries and headers of isostack
For C++ programs that use find_package(isostack): static libraries, headers
and CMake's configuration.")

if(TARGET isostack_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-isostack)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-vtk9, python3-notebook")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python module of isostack
Reads, segments, reconstructs, morphs, measures and writes as the program
isostack does, with NumPy arrays and VTK data sets.")
endif()
include(CPack)
