# SPDX-License-Identifier: LGPL-2.1-or-later
# Finds what the chosen components need; a missing package is named together with the component it stops.

# seamwright_require(COMPONENT DEBIAN_PACKAGES find_package-arguments...)
macro(seamwright_require component debian_packages package)
  find_package(${package} ${ARGN} QUIET)
  if(NOT ${package}_FOUND)
    message(FATAL_ERROR "Seamwright: ${component} needs ${package}, which was not found. On Debian: "
                        "apt-get install ${debian_packages}. Or switch it off: -DSEAMWRIGHT_BUILD_${component}=OFF")
  endif()
endmacro()

function(seamwright_component_needs component needed)
  if(SEAMWRIGHT_BUILD_${component} AND NOT SEAMWRIGHT_BUILD_${needed})
    message(FATAL_ERROR "Seamwright: ${component} needs ${needed}. Switch it on, or ${component} off: "
                        "-DSEAMWRIGHT_BUILD_${component}=OFF")
  endif()
endfunction()
seamwright_component_needs(CLI OCC)
seamwright_component_needs(PYTHON OCC)
seamwright_component_needs(FREECAD PYTHON)

# Eigen's package answers requests for its own major version alone, and 5 follows 3.4.
find_package(Eigen3 QUIET)
if(NOT Eigen3_FOUND OR Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Seamwright: the core needs Eigen 3.4 or later. On Debian: apt-get install libeigen3-dev")
endif()
find_package(Threads REQUIRED)
find_package(fmt 9 QUIET)
if(NOT fmt_FOUND)
  message(FATAL_ERROR "Seamwright: the core needs fmt 9 or later. On Debian: apt-get install libfmt-dev")
endif()

if(SEAMWRIGHT_BUILD_OCC)
  set(occt_packages "libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev "
                    "libocct-data-exchange-dev libocct-ocaf-dev libocct-visualization-dev libtbb-dev libfontconfig-dev")
  string(CONCAT occt_packages ${occt_packages})
  seamwright_require(OCC "${occt_packages}" OpenCASCADE)
  seamwright_require(OCC "nlohmann-json3-dev" nlohmann_json)
  # The data exchange toolkits were renamed in OpenCASCADE 7.8.
  if(TARGET TKDESTEP)
    set(SEAMWRIGHT_OCCT_EXCHANGE TKDESTEP TKDEIGES)
  else()
    set(SEAMWRIGHT_OCCT_EXCHANGE TKXDESTEP TKXDEIGES TKSTEP TKIGES)
  endif()
endif()
if(SEAMWRIGHT_BUILD_CLI)
  seamwright_require(CLI "libcli11-dev" CLI11)
endif()
if(SEAMWRIGHT_BUILD_PYTHON)
  seamwright_require(PYTHON "python3-dev python3-numpy" Python COMPONENTS Interpreter Development.Module)
  seamwright_require(PYTHON "pybind11-dev" pybind11)
  find_program(SWIG_EXECUTABLE swig)
  if(NOT SWIG_EXECUTABLE)
    message(FATAL_ERROR "Seamwright: PYTHON needs swig (the pointer bridge to FreeCAD). On Debian: apt-get install swig. "
                        "Or switch it off: -DSEAMWRIGHT_BUILD_PYTHON=OFF -DSEAMWRIGHT_BUILD_FREECAD=OFF")
  endif()
endif()
if(SEAMWRIGHT_BUILD_TESTS)
  seamwright_require(TESTS "libgtest-dev libgmock-dev" GTest)
endif()
if(SEAMWRIGHT_BUILD_BENCHMARKS)
  seamwright_require(BENCHMARKS "libbenchmark-dev" benchmark)
endif()
