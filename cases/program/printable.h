// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace tiprub {

enum class LineBreaks { escaped, kept };

/// A text as a terminal may show it, whoever wrote it: control characters, and bytes that are no UTF-8, as \n, \t,
/// \r or \x1b; all else as it is.
std::string printable(std::string_view text, LineBreaks line_breaks = LineBreaks::escaped);

/// A text in quotes that ends at its last quote only: quotes and backslashes in it are escaped too.
std::string in_quotes(std::string_view text);

/// Bytes of the UTF-8 letter that the text begins with; 0 if that is none. No overlong ones, no surrogates.
int letter_length(std::string_view text);

}  // namespace tiprub
