# SPDX-License-Identifier: LGPL-2.1-or-later
# Copies the staged workbench STAGE into the Mod folder of the current user, which FREECADCMD tells.
if(NOT FREECADCMD)
  message(FATAL_ERROR "freecadcmd was not found: install FreeCAD, or set FREECADCMD_EXECUTABLE.")
endif()
execute_process(
  COMMAND ${FREECADCMD} -c "import FreeCAD; print('<' + FreeCAD.getUserAppDataDir() + '>')"
  INPUT_FILE /dev/null OUTPUT_VARIABLE output RESULT_VARIABLE status TIMEOUT 60)
if(NOT status EQUAL 0 OR NOT output MATCHES "<([^>\n]+)>")
  message(FATAL_ERROR "${FREECADCMD} did not say where its user data lie (status ${status}): ${output}")
endif()
cmake_path(SET target NORMALIZE "${CMAKE_MATCH_1}/Mod")
file(REMOVE_RECURSE ${target}/Seamwright)
file(INSTALL ${STAGE} DESTINATION ${target} USE_SOURCE_PERMISSIONS PATTERN __pycache__ EXCLUDE)
message(STATUS "Seamwright is in ${target}/Seamwright; restart FreeCAD to see it.")
