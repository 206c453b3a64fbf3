# Options, dependencies and the one way in which a library of this project is declared.
include(GNUInstallDirs)

option(ISOSTACK_BUILD_TESTS "Build the tests" ON)
option(ISOSTACK_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
option(ISOSTACK_SANITIZE "Build with address and undefined-behaviour sanitizers" OFF)
option(ISOSTACK_BUILD_FUZZERS "Build the libFuzzer programs of tests/fuzz (clang only)" OFF)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)

# Debian's interpreter, not one that a shell puts before it: the module and its tests need Debian's packages.
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module NumPy)
if(Python3_Development.Module_FOUND AND Python3_NumPy_FOUND)
  find_package(pybind11 2.10 QUIET)
endif()
set(builds_python OFF)
if(pybind11_FOUND AND NOT ISOSTACK_SANITIZE) # a plain interpreter cannot load sanitized code
  set(builds_python ON)
endif()
option(ISOSTACK_BUILD_PYTHON "Build the Python module" ${builds_python})

add_library(isostack_flags INTERFACE)
target_compile_options(isostack_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
  $<$<BOOL:${ISOSTACK_WARNINGS_AS_ERRORS}>:-Werror>)
if(ISOSTACK_SANITIZE)
  target_compile_options(isostack_flags INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(isostack_flags INTERFACE -fsanitize=address,undefined)
endif()

# isostack_library(NAME sources...): the library isostack_NAME, known as isostack::NAME, installed and exported.
function(isostack_library name)
  add_library(isostack_${name} ${ARGN})
  add_library(isostack::${name} ALIAS isostack_${name})
  set_target_properties(isostack_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(isostack_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/isostack>)
  target_compile_features(isostack_${name} PUBLIC cxx_std_20)
  target_link_libraries(isostack_${name} PRIVATE $<BUILD_INTERFACE:isostack_flags>)
  set_property(GLOBAL APPEND PROPERTY ISOSTACK_LIBRARIES isostack_${name})
endfunction()
