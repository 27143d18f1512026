# SPDX-License-Identifier: GPL-3.0-or-later
# What tests of the programs' messages do and assert; for scripts that run with cmake -P.

# A copy of a case, with the line of a key replaced; an empty key changes nothing.
function(copy_case case copy key line)
  file(READ ${case} text)
  if(NOT "${key}" STREQUAL "")
    string(REGEX REPLACE "\n${key} = [^\n]*" "\n${line}" changed "${text}")
    if("${changed}" STREQUAL "${text}")
      message(FATAL_ERROR "${case} has no line \"${key} = ...\"")
    endif()
    set(text "${changed}")
  endif()
  file(WRITE ${copy} "${text}")
endfunction()

function(expect_exit_code expected code err)
  if(NOT "${code}" STREQUAL "${expected}")
    message(FATAL_ERROR "exit code ${code} instead of ${expected}\n${err}")
  endif()
endfunction()

function(expect_phrase phrase text)
  string(FIND "${text}" "${phrase}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "\"${phrase}\" is not in:\n${text}")
  endif()
endfunction()
