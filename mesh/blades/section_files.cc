// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/blades/blade_files.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace tiprub::mesh {

namespace {

constexpr std::size_t columns = 4;

BladePoint section_point(const NamedText& file, const NumberLine& line, const FileUnits& units) {
  if (line.words.size() != columns)
    refuse_line(file, line.number,
                "holds " + std::to_string(line.words.size()) +
                    " words; a point is four numbers, z, r, theta of one side and of the other, and a new section "
                    "begins with the word \"section\"");
  const auto number = [&](std::size_t word, const char* meaning) { return number_in(file, line, word, meaning); };
  const MeridionalPoint at{number(0, "z") * units.length, number(1, "r") * units.length};
  require_on_wheel(file, line.number, at);
  const double one = angle_in(file, line, 2, "theta of side 1", units.angle);
  const double other = angle_beside(one, angle_in(file, line, 3, "theta of side 2", units.angle));
  return {at, 0.5 * (one + other), 0.5 * (one - other)};
}

constexpr int most_blades = 1000;
constexpr double least_pitch_fraction = 0.2, largest_pitch_fraction = 0.8;

enum class Thickness { normal, tangential };

/// Gives the lines of the file one after the other, without empty ones.
class Cursor {
 public:
  explicit Cursor(const NamedText& file) : file_(file), lines_(lines_of(file)) {
    std::erase_if(lines_, [](const NumberLine& line) { return line.words.empty(); });
  }
  const NumberLine& next(const char* expected) {
    if (at_ < lines_.size()) return lines_[at_++];
    refuse_line(file_, lines_.empty() ? 1 : lines_.back().number, std::string("ends before ") + expected);
  }
  const NumberLine* peek() const { return at_ < lines_.size() ? &lines_[at_] : nullptr; }

 private:
  const NamedText& file_;
  std::vector<NumberLine> lines_;
  std::size_t at_ = 0;
};

bool is_letter(std::string_view word, char letter) {
  return word.size() == 1 && std::tolower(static_cast<unsigned char>(word[0])) == letter;
}

// The flag follows the number of layers, or stands on a line of its own.
Thickness read_thickness_flag(const NamedText& file, Cursor& cursor, const NumberLine& layers) {
  const NumberLine* next = cursor.peek();
  const bool own_line = layers.words.size() < 2 && next != nullptr;
  const std::string_view word = own_line ? next->words[0] : layers.words.size() > 1 ? layers.words[1] : "";
  const bool normal = is_letter(word, 'n');
  if (!normal && !is_letter(word, 't'))
    refuse_line(file, layers.number,
                "the number of layers must be followed by N or T: is thickness normal to the mean line, or along the "
                "circle?");
  if (own_line) cursor.next("the layers");
  return normal ? Thickness::normal : Thickness::tangential;
}

// The format allows layers that give only the angle (a) or only the thickness (t).
void require_whole_layer(const NamedText& file, const NumberLine& line) {
  std::string uses;
  for (std::size_t word = 2; word < line.words.size(); ++word)
    for (const char letter : line.words[word])
      uses += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (uses.find_first_not_of("atb") != std::string::npos)
    refuse_line(file, line.number,
                "a layer begins with its span fraction, its number of points, and perhaps a, t or b");
  if (!uses.empty() && uses.find('b') == std::string::npos &&
      (uses.find('a') == std::string::npos) != (uses.find('t') == std::string::npos))
    refuse_line(file, line.number,
                "a layer for the angle or the thickness alone can't be taken; write layers for both");
}

/// A point whose half width is still half of the thickness in metres, not an angle.
BladePoint meanline_point(const NamedText& file, const NumberLine& line, double length) {
  if (line.words.size() != columns)
    refuse_line(file, line.number,
                "holds " + std::to_string(line.words.size()) + " words; a point is r, theta, z, thickness");
  const MeridionalPoint at{length * number_in(file, line, 2, "z"), length * number_in(file, line, 0, "r")};
  require_on_wheel(file, line.number, at);
  const double thickness = length * number_in(file, line, 3, "thickness");
  if (thickness < 0.0 || thickness > at.r)
    refuse_line(file, line.number, "a thickness must be at least 0, and less than the radius");
  return {at, angle_in(file, line, 1, "theta", 1.0), 0.5 * thickness};
}

// At either end one point without thickness is kept: it is a sharp edge.
void leave_out_what_is_no_blade(BladeSection& points) {
  const auto thick = [](const BladePoint& point) { return point.half_width > 0.0; };
  const auto first = std::ranges::find_if(points, thick);
  const auto last = std::find_if(points.rbegin(), points.rend(), thick).base();
  if (first == points.end()) return;
  const auto from = first == points.begin() ? first : first - 1;
  const auto to = last == points.end() ? last : last + 1;
  points = BladeSection(from, to);
}

/// r d theta / dm: by the parabola through three neighbours.
double slope(const BladeSection& points, const std::vector<double>& lengths, std::size_t i) {
  const std::size_t middle = std::clamp<std::size_t>(i, 1, points.size() - 2);
  const double a = lengths[middle - 1], b = lengths[middle], c = lengths[middle + 1], s = lengths[i];
  return points[i].at.r * (points[middle - 1].theta * ((s - b) + (s - c)) / ((a - b) * (a - c)) +
                           points[middle].theta * ((s - a) + (s - c)) / ((b - a) * (b - c)) +
                           points[middle + 1].theta * ((s - a) + (s - b)) / ((c - a) * (c - b)));
}

// Turns half widths in metres into angles.
void spread_along_circles(BladeSection& points, Thickness thickness) {
  const std::vector<double> lengths = lengths_along(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double stretch = thickness == Thickness::normal ? std::hypot(1.0, slope(points, lengths, i)) : 1.0;
    points[i].half_width *= stretch / points[i].at.r;
  }
}

BladeSection read_layer(const NamedText& file, Cursor& cursor, double length, Thickness thickness) {
  const NumberLine& head = cursor.next("a layer's span fraction and number of points");
  number_in(file, head, 0, "a layer's span fraction");
  const int count = count_in(file, head, 1, "a layer's number of points", 2, most_points);
  require_whole_layer(file, head);
  BladeSection points;
  for (int i = 0; i < count; ++i)
    points.push_back(meanline_point(file, cursor.next("the last point of a layer"), length));
  leave_out_what_is_no_blade(points);
  points = upright_section(file, head.number, std::move(points));
  spread_along_circles(points, thickness);
  return points;
}

/// A main blade, or a splitter, with its pitch fraction.
FileSplitter read_blade(const NamedText& file, Cursor& cursor, double length) {
  FileSplitter blade;
  blade.pitch_fraction = number_in(file, cursor.next("the pitch fraction"), 0, "the pitch fraction");
  const NumberLine& layers = cursor.next("the number of layers");
  const int count = count_in(file, layers, 0, "the number of layers", 2, most_sections);
  const Thickness thickness = read_thickness_flag(file, cursor, layers);
  for (int i = 0; i < count; ++i) blade.sections.push_back(read_layer(file, cursor, length, thickness));
  require_blade(file, blade.sections);
  return blade;
}

FileSplitter read_splitter(const NamedText& file, Cursor& cursor, double length) {
  const int line = cursor.peek() != nullptr ? cursor.peek()->number : 0;
  FileSplitter blade = read_blade(file, cursor, length);
  if (blade.pitch_fraction < least_pitch_fraction || blade.pitch_fraction > largest_pitch_fraction)
    refuse_line(file, line, "the pitch fraction of a splitter must be at least 0.2 and at most 0.8");
  return blade;
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
  count_angles_on(blade.sections);
  require_blade(file, blade.sections);
  return blade;
}

FileBlade read_meanline(const NamedText& file, double length) {
  Cursor cursor(file);
  FileBlade blade;
  blade.file = file.name;
  blade.blade_count = count_in(file, cursor.next("the number of blades"), 0, "the number of blades", 1, most_blades);
  const NumberLine& splitters = cursor.next("the number of splitters");
  const bool has_splitter = count_in(file, splitters, 0, "the number of splitters", 0, 1) > 0;
  blade.sections = read_blade(file, cursor, length).sections;
  if (has_splitter) blade.splitter = read_splitter(file, cursor, length);
  if (const NumberLine* more = cursor.peek()) refuse_line(file, more->number, "there is more after the last layer");
  return blade;
}

}  // namespace tiprub::mesh
