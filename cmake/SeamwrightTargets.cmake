# SPDX-License-Identifier: LGPL-2.1-or-later
# How every target of the project is compiled, and how a library of it is named, exported and installed.

# Headers are included by their place in the tree: <seamwright/core/seam/measure.hpp>.
# The build tree offers that prefix as a link to the sources; the install tree has it for real.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/include)
file(CREATE_LINK ${PROJECT_SOURCE_DIR} ${CMAKE_BINARY_DIR}/include/seamwright SYMBOLIC)

function(seamwright_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  # Contraction is off so that a figure does not depend on whether the compiler fused a product.
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                                           -ffp-contract=off $<$<BOOL:${SEAMWRIGHT_WERROR}>:-Werror>)
  # Where many functions are inlined, GCC 12 gives false alarms of these two kinds inside Eigen and std::optional.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-use-after-free> $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endfunction()

# seamwright_library(NAME SOURCES... HEADERS...): the target seamwright_NAME, alias and exported name seamwright::NAME.
function(seamwright_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS" ${ARGN})
  set(target seamwright_${name})
  add_library(${target} ${ARG_SOURCES} ${ARG_HEADERS})
  add_library(seamwright::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  seamwright_compile_options(${target})
  # In a unity build the files of one folder are compiled together: the names that are local to them must differ.
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARG_SOURCES)
    cmake_path(GET source PARENT_PATH folder)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${folder}")
  endforeach()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${CMAKE_BINARY_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # Header-only, and in sources alone: an installed library does not need fmt.
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:fmt::fmt-header-only>)
  install(TARGETS ${target} EXPORT SeamwrightTargets
          ARCHIVE COMPONENT development LIBRARY COMPONENT runtime RUNTIME COMPONENT runtime)
  file(RELATIVE_PATH place ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  foreach(header IN LISTS ARG_HEADERS)
    cmake_path(GET header PARENT_PATH folder)
    install(FILES ${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/seamwright/${place}/${folder}
            COMPONENT development)
  endforeach()
endfunction()
