// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/explore/other_data.h"

#include <algorithm>

#include "postprocess/tables/units.h"

namespace tiprub {

namespace {

using nlohmann::json;

/// Where the rows of each speed begin, how many they are, and how many lie in an engine order.
json speeds_of(const CsvTable& table) {
  json speeds = json::array();
  int first = 0;
  for (const MapColumn& column : map_of(table).columns) {
    const int lines = column.spectrum.lines();
    speeds.push_back({{"rpm", column.speed * rpm_per_rad_s},
                      {"first", first},
                      {"lines", lines},
                      {"revolutions", column.spectrum.revolutions}});
    first += lines;
  }
  return speeds;
}

json add_map(PackedArrays& arrays, const CsvTable& map, const std::string& place) {
  arrays.add(place + "total", map.numbers("total [mm]"));
  for (int n = 0;; ++n) {
    const std::string name = "nodal diameter " + std::to_string(n) + " [mm]";
    if (std::find(map.header.begin(), map.header.end(), name) == map.header.end()) break;
    arrays.add(place + std::to_string(n), map.numbers(name));
  }
  return speeds_of(map);
}

}  // namespace

json add_other(PackedArrays& arrays, const OtherReport& other) {
  arrays.add("other/speed", other.speed);
  arrays.add("other/largest", other.amplitude);
  return {{"name", other.name},
          {"leading", add_map(arrays, other.leading_map, "other/leading/")},
          {"trailing", add_map(arrays, other.trailing_map, "other/trailing/")}};
}

}  // namespace tiprub
