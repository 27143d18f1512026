// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace tiprub {

enum class LineBreaks { escaped, kept };

/// A text from anywhere as a terminal may show it. Characters that control the terminal, change the direction of
/// writing or have no width, and bytes that are not UTF-8, become \n, \t, \r or \x1b. All others stay as they are.
std::string printable(std::string_view text, LineBreaks line_breaks = LineBreaks::escaped);

/// The beginning and the end of a text of more than `most` bytes; other texts as they are.
std::string shortened(const std::string& text, std::size_t most);

/// A text in quotes, with the quotes and backslashes in it escaped too, so that it ends at its last quote only.
std::string in_quotes(std::string_view text);

/// The length in bytes of the UTF-8 letter with which the text begins. It is 0 if there is none, and for overlong
/// forms and surrogates.
int letter_length(std::string_view text);

}  // namespace tiprub
