# SPDX-License-Identifier: GPL-3.0-or-later
# Runs PROGRAM on CASE with the line of KEY replaced by LINE, in FOLDER; asserts EXIT_CODE and that PHRASE is on stderr.
# A failed run must leave no file behind.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../expectations.cmake)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
copy_case(${CASE} ${FOLDER}/case.toml "${KEY}" "${LINE}")
set(output sector.msh)
if(DEFINED ENV{OUTPUT})
  set(output $ENV{OUTPUT})
endif()
execute_process(
  COMMAND ${PROGRAM} case.toml -o ${output}
  WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code
  OUTPUT_VARIABLE out
  ERROR_VARIABLE err)
expect_exit_code(${EXIT_CODE} "${code}" "${err}")
expect_phrase("${PHRASE}" "${err}")
if(NOT "${out}" STREQUAL "")
  message(FATAL_ERROR "stdout is for data, but it holds:\n${out}")
endif()
file(GLOB left ${FOLDER}/*.msh)
if(NOT EXIT_CODE EQUAL 0 AND left)
  message(FATAL_ERROR "a failed run left ${left}")
endif()
