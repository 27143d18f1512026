// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/section_table.h"

#include <utility>

namespace tiprub {

namespace {

constexpr std::size_t section_columns = 4;

BladePoint section_point(const NamedText& file, const NumberLine& line, const FileUnits& units) {
  if (line.words.size() != section_columns)
    refuse_line(file, line.number,
                "holds " + std::to_string(line.words.size()) +
                    " words; a point is four numbers, z, r, theta of one side and of the other, and a new section "
                    "begins with the word \"section\"");
  const auto number = [&](std::size_t word, const char* meaning) { return number_in(file, line, word, meaning); };
  const MeridionalPoint at{number(0, "z") * units.length, number(1, "r") * units.length};
  require_on_wheel(file, line.number, at);
  const double one = angle_in(file, line, 2, "theta of side 1", units.angle);
  const double other = angle_in(file, line, 3, "theta of side 2", units.angle);
  return {at, 0.5 * (one + other), 0.5 * (one - other)};
}

}  // namespace

FileBlade read_section_table(const NamedText& file, const FileUnits& units) {
  FileBlade blade;
  blade.file = file.name;
  int begun = 0;  // the line where the last section began
  const auto close = [&] {
    if (blade.sections.empty()) return;
    blade.sections.back() = upright_section(file, begun, std::move(blade.sections.back()));
  };
  for (const NumberLine& line : lines_of(file)) {
    if (line.words.empty()) continue;
    if (line.words[0] == "section") {
      close();
      blade.sections.emplace_back();
      begun = line.number;
      if (blade.sections.size() > most_sections) refuse_line(file, line.number, "more sections than any blade has");
    } else if (blade.sections.empty()) {
      refuse_line(file, line.number, "must begin with a line \"section\", then its points");
    } else {
      blade.sections.back().push_back(section_point(file, line, units));
      if (blade.sections.back().size() > most_points)
        refuse_line(file, line.number, "more points than any section has");
    }
  }
  close();
  require_blade(file, blade.sections);
  return blade;
}

}  // namespace tiprub
