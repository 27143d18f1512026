# SPDX-License-Identifier: GPL-3.0-or-later
# Copies CASE and MESH, changes a line of the case (KEY, LINE) or a text in the mesh file (OLD, NEW), runs PROGRAM with
# ARGUMENTS in FOLDER; asserts EXIT_CODE and that PHRASE comes out. A failed run must leave no model behind.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../expectations.cmake)
string(REPLACE "@" ";" PHRASE "${PHRASE}")  # a list's separator on the way here
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(COPY_FILE ${MESH} ${FOLDER}/sector.msh)
copy_case(${CASE} ${FOLDER}/case.toml "${KEY}" "${LINE}")
if(NOT "${OLD}" STREQUAL "")
  file(READ ${FOLDER}/sector.msh mesh)
  string(REPLACE "${OLD}" "${NEW}" changed "${mesh}")
  if("${changed}" STREQUAL "${mesh}")
    message(FATAL_ERROR "sector.msh does not hold \"${OLD}\"")
  endif()
  file(WRITE ${FOLDER}/sector.msh "${changed}")
endif()

execute_process(
  COMMAND ${PROGRAM} ${ARGUMENTS}
  WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code
  OUTPUT_VARIABLE out
  ERROR_VARIABLE err)
expect_exit_code(${EXIT_CODE} "${code}" "${err}")
expect_phrase("${PHRASE}" "${out}${err}")
file(GLOB left ${FOLDER}/*.h5)
list(LENGTH left count)
if(NOT count EQUAL MODELS)
  message(FATAL_ERROR "${MODELS} model files expected, found: ${left}")
endif()
string(REGEX MATCHALL "\n" lines "${err}")
list(LENGTH lines count)
if(NOT EXIT_CODE EQUAL 0 AND NOT count EQUAL 1)
  message(FATAL_ERROR "an error is one line, not:\n${err}")
endif()
