# SPDX-License-Identifier: GPL-3.0-or-later
# --check measures the sector and leaves the folder as it was.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(
  COMMAND ${PROGRAM} ${CASE} --check
  WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code
  ERROR_VARIABLE err)
file(GLOB left ${FOLDER}/*)
if(NOT code EQUAL 0 OR left)
  message(FATAL_ERROR "exit code ${code}, left behind: ${left}\n${err}")
endif()
if(NOT err MATCHES "worst scaled Jacobian")
  message(FATAL_ERROR "--check did not report:\n${err}")
endif()
