// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tiprub {

/// One picture: gnuplot commands without a terminal. File names in it are relative to the folder it is drawn in.
struct Drawing {
  std::string name;  ///< of the files, without ending
  int width = 900;   ///< [px] of the SVG; the PNG has twice as many
  int height = 540;  ///< [px]
  std::string commands;
};

/// Raises RunError if gnuplot can't be started.
void require_gnuplot();

/// Draws name.svg and name.png for each drawing in the folder, with at most `jobs` processes at a time, and calls
/// `drawn` after each. Raises RunError with gnuplot's own words if one fails or leaves no picture, Interrupted if a
/// signal came; no process outlives the call.
void draw(const std::vector<Drawing>& drawings, const std::filesystem::path& folder, int jobs,
          const std::function<void()>& drawn);

/// A text as gnuplot reads it between double quotes, with the letters that its enhanced mode would interpret escaped.
std::string gnuplot_quoted(const std::string& text);

}  // namespace tiprub
