# SPDX-License-Identifier: GPL-3.0-or-later
# Runs PROGRAM on CASE with the line of KEY replaced by LINE, in FOLDER; asserts EXIT_CODE and that PHRASE is on stderr.
# A failed run must leave no file behind.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(READ ${CASE} text)
if(NOT "${KEY}" STREQUAL "")
  string(REGEX REPLACE "\n${KEY} = [^\n]*" "\n${LINE}" changed "${text}")
  if("${changed}" STREQUAL "${text}")
    message(FATAL_ERROR "${CASE} has no line \"${KEY} = ...\"")
  endif()
  set(text "${changed}")
endif()
file(WRITE ${FOLDER}/case.toml "${text}")
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
if(NOT "${code}" STREQUAL "${EXIT_CODE}")
  message(FATAL_ERROR "exit code ${code} instead of ${EXIT_CODE}\n${err}")
endif()
string(FIND "${err}" "${PHRASE}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "\"${PHRASE}\" is not in:\n${err}")
endif()
if(NOT "${out}" STREQUAL "")
  message(FATAL_ERROR "stdout is for data, but it holds:\n${out}")
endif()
file(GLOB left ${FOLDER}/*.msh)
if(NOT EXIT_CODE EQUAL 0 AND left)
  message(FATAL_ERROR "a failed run left ${left}")
endif()
