// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cmath>
#include <functional>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace tiprub {

/// The parts one after another, numbers with six significant digits, as streams print them.
template <class... Parts>
std::string text_of(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// The number that the whole text is; nothing if it is none, or not finite.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// A number with 6 digits if these are enough to read the same number again, and with 17 if not.
inline std::string shortest(double value) {
  const std::string text = text_of(value);
  return number_of<double>(text) == value ? text : text_of(std::setprecision(17), value);
}

/// The text without blanks at its ends.
std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r");

/// The words between blanks.
std::vector<std::string_view> words_of(std::string_view text, std::string_view blanks = " \t\r");

/// What `text` makes of each item, `between` them; items of which it makes nothing are left out.
template <class Items, class Text = std::identity>
std::string listed(const Items& items, const std::string& between, const Text& text = {}) {
  std::string all;
  for (const auto& item : items)
    if (const std::string one(std::invoke(text, item)); !one.empty()) all += (all.empty() ? "" : between) + one;
  return all;
}

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
