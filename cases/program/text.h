// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <iomanip>
#include <sstream>
#include <string>

namespace tiprub {

/// The parts one after another, numbers with six significant digits, as streams print them.
template <class... Parts>
std::string text_of(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// A number with 6 digits if these are enough to read the same number again, and with 17 if not.
inline std::string shortest(double value) {
  const std::string text = text_of(value);
  double again = 0;
  std::from_chars(text.data(), text.data() + text.size(), again);
  return again == value ? text : text_of(std::setprecision(17), value);
}

}  // namespace tiprub
