# SPDX-License-Identifier: GPL-3.0-or-later
# One line a message: bad input in, exact exit code and key phrases out; expect_message.py lists the keywords.
set(TIPRUB_EXPECT_MESSAGE ${CMAKE_CURRENT_LIST_DIR}/expect_message.py)

# Adds the test <room>.message.<name>. A room sets before that: message_room, message_defaults (keywords that hold
# unless a call gives them again), and, if its inputs are made by tests, message_fixtures.
function(expect_message name)
  set(test ${message_room}.message.${name})
  # Bracket arguments keep what would tear a CMake list: semicolons, and brackets that don't close.
  set(keywords)
  math(EXPR last "${ARGC} - 1")
  foreach(i RANGE 1 ${last})
    string(APPEND keywords " [=[${ARGV${i}}]=]")
  endforeach()
  cmake_language(
    EVAL CODE
    "add_test(NAME ${test} COMMAND \${TIPRUB_PYTHON} -B \${TIPRUB_EXPECT_MESSAGE}
       \${CMAKE_CURRENT_BINARY_DIR}/message/${name} \${message_defaults} ${keywords})")
  set_tests_properties(${test} PROPERTIES FIXTURES_REQUIRED "${message_fixtures}")
endfunction()
