// SPDX-License-Identifier: GPL-3.0-or-later
// What reaches gnuplot: a text from a case is shown as it stands, and nothing of it is run or read as markup.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "cases/program/errors.h"
#include "postprocess/figures/drawing.h"
#include "tests/cases/full_disk.h"

namespace fs = std::filesystem;

namespace tiprub::postprocess {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DrawingPrologue, QuotesTexts) {
  EXPECT_EQ(gnuplot_text("rotor 37"), "'rotor 37'");
  EXPECT_EQ(gnuplot_text("it's \"so\" `date`"), R"('it'."\047".'s "so" `date`')");
  EXPECT_EQ(gnuplot_text("a_{1}^2 @&~\\n"), "'a\\_\\{1\\}\\^2 \\@\\&\\~\\\\n'");
  EXPECT_EQ(gnuplot_text("two\nlines'\nquit"), R"('two lines'."\047".' quit')");
  EXPECT_EQ(gnuplot_text("''"), R"(''."\047".''."\047".'')");
  EXPECT_EQ(gnuplot_text(""), "''");
  EXPECT_EQ(gnuplot_text("\xE2\x88\x92 4"), "'\xE2\x88\x92 4'");
}

/// gnuplot divides whole numbers as such, and knows no empty array.
TEST(DrawingPrologue, WritesEachKindOfValue) {
  const Drawing drawing{.name = "shown",
                        .script = "wheel",
                        .values = {{"count", 3},
                                   {"speed", 12000.0},
                                   {"gap", 1.25e-7},
                                   {"unknown", std::nan("")},
                                   {"title", std::string("a 'b'")},
                                   {"names", std::vector<std::string>{"x", "y"}},
                                   {"middles", std::vector<double>{1, 0.5}},
                                   {"nothing", std::vector<double>{}}},
                        .tables = {{"rows", {Eigen::MatrixXd::Ones(2, 2), Eigen::MatrixXd::Zero(1, 2)}}}};
  const std::string text = prologue(drawing);
  for (const char* line : {"name = 'shown'\n", "script = 'wheel'\n", "count = 3\n", "speed = 12000.0\n",
                           "gap = 1.25e-07\n", "unknown = NaN\n", "title = 'a '.\"\\047\".'b'.\"\\047\".''\n",
                           "array names[2] = ['x', 'y']\n", "array middles[2] = [1.0, 0.5]\n", "array nothing[1]\n",
                           "$rows << EOD\n1,1\n1,1\n\n\n0,0\nEOD\nrows_rows = 3\n"})
    EXPECT_TRUE(contains(text, line)) << line << "\n" << text;
}

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(DrawingPrologue, LeavesNoRangeWithoutWidth) {
  for (const auto& [range, text] : std::vector<std::pair<DrawnRange, std::string>>{
           {{900, 2100}, "axis_low = 900.0\naxis_high = 2100.0\n"},
           {{0, 0}, "axis_low = 0.0\naxis_high = 1e-12\n"},
           {{0, 3e-300}, "axis_low = 0.0\naxis_high = 1e-12\n"},
           {{1000, 1000}, "axis_low = 999.95\naxis_high = 1000.05\n"},
           {{1000, std::nextafter(1000, 2000)}, "axis_low = 999.95\naxis_high = 1000.05\n"},
           {{-2, -2}, "axis_low = -2.0001\naxis_high = -1.9999\n"}}) {
    const std::string whole = prologue({.name = "shown", .script = "wheel", .values = {{"axis", range}}});
    EXPECT_TRUE(contains(whole, text)) << whole;
  }
}

Drawing drawing_of_curves(const std::string& title, const std::string& curve) {
  Eigen::MatrixXd rows(2, 3);
  rows << 1000, 1, 2, 2000, 3, 4;
  return {.name = "hostile",
          .script = "tracking",
          .values = {{"speed", DrawnRange{900, 2100}},
                     {"panels", 1},
                     {"panel_title", std::vector<std::string>{title}},
                     {"curves", 1},
                     {"curve_name", std::vector<std::string>{curve}}},
          .tables = {{"curves", {rows}}}};
}

/// The whole way through gnuplot: quotes, a command between backticks, markup and a macro in the name of a curve.
TEST(Drawing, ShowsATextAsItStands) {
  const fs::path folder = fs::temp_directory_path() / ("tiprub-drawing-" + std::to_string(getpid()));
  fs::create_directories(folder);
  draw({drawing_of_curves("it's \"hot\" `touch ran` _{low}^2 @x ~a", "'; system('touch ran'); '' #")}, folder, 1);
  const std::string svg = text_of(folder / "hostile.svg");
  EXPECT_TRUE(contains(svg, "it's \"hot\" `touch ran` _{low}^2 @x ~a")) << svg;
  EXPECT_TRUE(contains(svg, "'; system('touch ran'); '' #"));
  EXPECT_FALSE(fs::exists(folder / "ran"));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    EXPECT_TRUE(entry.path().extension() == ".svg" || entry.path().extension() == ".png") << entry.path();
  fs::remove_all(folder);
}

/// gnuplot draws half a picture on a full disk, says nothing, and exits with 0.
TEST(Drawing, NoticesHalfAPicture) {
  const fs::path folder = fs::temp_directory_path() / ("tiprub-drawing-" + std::to_string(getpid()));
  fs::create_directories(folder);
  const Drawing drawing = drawing_of_curves("a", "b");
  draw({drawing}, folder, 1);
  const auto size = static_cast<rlim_t>(fs::file_size(folder / "hostile.png"));
  try {
    const FullDisk disk(size - 1);
    draw({drawing}, folder, 1);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_TRUE(contains(std::string(error.what()), ": is not whole; is the disk full?")) << error.what();
  }
  fs::remove_all(folder);
}

}  // namespace
}  // namespace tiprub::postprocess
