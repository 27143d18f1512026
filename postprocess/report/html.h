// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "postprocess/tables/table.h"

namespace tiprub::html {

/// Text with the letters that HTML would read as its own replaced.
std::string escaped(const std::string& text);

/// Names and what they mean, a list.
std::string definitions(const std::vector<std::pair<std::string, std::string>>& entries);

/// A table with a head; numbers to the right, texts to the left.
std::string table(const Table& table);

/// A picture as an address that holds it, for `src="..."`: its own text, with the letters that would end it replaced,
/// is a quarter shorter than base 64.
std::string svg_url(const std::string& svg);

/// A template with every {{name}} replaced by its value, in one pass: what a value holds is not looked at again.
/// Every name of the template must have a value, and every value a place.
std::string filled(std::string_view page, const std::map<std::string, std::string>& values);

}  // namespace tiprub::html
