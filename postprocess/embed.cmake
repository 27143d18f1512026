# SPDX-License-Identifier: GPL-3.0-or-later
# Files inside the program: texts that are no C++ (gnuplot scripts, HTML, CSS, JavaScript) stay files in the source tree
# and are compiled in, so that the program needs nothing beside it.
#
#   include(embed.cmake)
#   tiprub_embed(tiprub_postprocess page_files report/page.html report/style.css)
#
# writes <build>/embedded/page_files.h whenever one of the files changes, for the sources of tiprub_postprocess:
#
#   #include "embedded/page_files.h"
#   embedded::page_files::style_css  // std::string_view, the file's bytes; the constant's name is the file's
#   embedded::page_files::files      // all of them: std::array of pairs of file name and text
#
# A file may hold any UTF-8 text except NUL and the sequence `)embedded"`.

set(TIPRUB_EMBED_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")

function(tiprub_embed target set_name)
  set(header "${CMAKE_CURRENT_BINARY_DIR}/embedded/${set_name}.h")
  set(files "")
  foreach(file IN LISTS ARGN)
    get_filename_component(file "${file}" ABSOLUTE)
    list(APPEND files "${file}")
  endforeach()
  add_custom_command(
    OUTPUT "${header}"
    COMMAND "${CMAKE_COMMAND}" "-DSET_NAME=${set_name}" "-DHEADER=${header}" "-DFILES=${files}" -P
            "${TIPRUB_EMBED_SCRIPT}"
    DEPENDS ${files} "${TIPRUB_EMBED_SCRIPT}"
    COMMENT "Embedding ${set_name}"
    VERBATIM)
  target_sources(${target} PRIVATE "${header}")
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
endfunction()

# Writes the header.
function(tiprub_write_embedded)
  set(constants "")
  set(entries "")
  foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    string(MAKE_C_IDENTIFIER "${name}" constant)
    file(READ "${file}" text)
    string(FIND "${text}" ")embedded\"" end)
    if(NOT end EQUAL -1)
      message(FATAL_ERROR "${file}: holds )embedded\", which would end the string that it is put into")
    endif()
    string(APPEND constants "inline constexpr std::string_view ${constant} = R\"embedded(${text})embedded\"sv;\n")
    string(APPEND entries "    {\"${name}\", ${constant}},\n")
  endforeach()
  list(LENGTH FILES count)
  file(
    WRITE "${HEADER}"
    "// Written by embed.cmake; edit the files instead.\n#pragma once\n\n#include <array>\n#include <string_view>\n"
    "#include <utility>\n\nnamespace tiprub::embedded::${SET_NAME} {\n\nusing namespace std::string_view_literals;\n\n${constants}\n"
    "inline constexpr std::array<std::pair<std::string_view, std::string_view>, ${count}> files{{\n${entries}}};\n\n"
    "}  // namespace tiprub::embedded::${SET_NAME}\n")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE)
  tiprub_write_embedded()
endif()
