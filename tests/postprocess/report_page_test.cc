// SPDX-License-Identifier: GPL-3.0-or-later
// The page and the tables that the executable makes of a made scene: they stand alone, and say what was computed.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "program_fixture.h"
#include "synthetic_fields.h"

namespace fs = std::filesystem;

namespace tiprub {
namespace {

class Page : public Program {};

TEST_F(Page, PageStandsAlone) {
  ASSERT_EQ(run("case.toml model.h5 response.h5 -o alone").exit_code, 0);
  const std::string page = text_of(folder_ / "alone" / "report.html");
  EXPECT_EQ(page.find("http:"), std::string::npos);
  EXPECT_EQ(page.find("https:"), std::string::npos);
  EXPECT_EQ(page.find("//cdn"), std::string::npos);
  EXPECT_NE(page.find("A made wheel &amp; an &lt;oval&gt; casing"), std::string::npos);
  EXPECT_EQ(page.find("<oval>"), std::string::npos);
  for (const char* phrase : {"critical speed", "the casing repeats twice around", "irregular", "1 failed",
                             "energy balance closes", "critical_speeds.csv"})
    EXPECT_NE(page.find(phrase), std::string::npos) << phrase;
  const std::regex link("href=\"([^\"#]+)\"");
  for (std::sregex_iterator match(page.begin(), page.end(), link), end; match != end; ++match)
    EXPECT_TRUE(fs::exists(folder_ / "alone" / (*match)[1].str())) << (*match)[1].str();
}

TEST_F(Page, SaysThatThereAreNoFields) {
  ASSERT_EQ(run("case.toml model.h5 response.h5 -o without").exit_code, 0);
  EXPECT_NE(text_of(folder_ / "without" / "report.html").find("left out, no fields.h5 was given"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "without" / "fields"));
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char letter : line) {
    if (letter == '"')
      quoted = !quoted;
    else if (letter == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += letter;
  }
  return cells;
}

/// Rows of a table that the program wrote, by the names in its header.
std::vector<std::map<std::string, std::string>> rows_of(const fs::path& path) {
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  const std::vector<std::string> header = cells_of(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(stream, line)) {
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(cells.size(), header.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i) rows.back()[header[i]] = i < cells.size() ? cells[i] : "";
  }
  return rows;
}

constexpr const char* stress_columns[] = {"von Mises, vibration [MPa]", "von Mises, spin [MPa]",
                                          "von Mises, both [MPa]"};

/// fields.h5 is in single precision: 6e-8 of a displacement e r, over bricks of r/10, in several terms.
TEST_F(Page, TellsTheStressAtEveryPeak) {
  constexpr double single_precision = 2e-6;
  const Outcome outcome = run("case.toml model.h5 response.h5 --fields fields.h5 -o stressed");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto peaks = rows_of(folder_ / "stressed" / "critical_speeds.csv");
  const auto drawn = rows_of(folder_ / "stressed" / "figures" / "contact_stress.csv");
  ASSERT_GT(peaks.size(), 1U);
  ASSERT_EQ(drawn.size(), peaks.size());
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    const double speed = std::stod(peaks[i].at("speed [rad/s]"));
    const double q = synthetic::vibration_strain(speed), s = synthetic::spin_strain(speed);
    const double exact[] = {std::sqrt(3.0) * q, s, std::sqrt(3 * q * q + s * s)};
    for (int k = 0; k < 3; ++k) {
      const double expected = 2 * synthetic::shear_modulus * exact[k] * 1e-6;
      EXPECT_NEAR(std::stod(peaks[i].at(stress_columns[k])), expected, single_precision * expected)
          << stress_columns[k];
      EXPECT_EQ(peaks[i].at(stress_columns[k]), drawn[i].at(stress_columns[k]));
    }
    EXPECT_EQ(peaks[i].at("vibration stresses most"), "ring");
    EXPECT_EQ(peaks[i].at("at radius [mm]"), drawn[i].at("r [mm]"));
    EXPECT_GT(std::stoi(peaks[i].at("contact areas leading edge")), 0);
  }
  for (const char* column : {"vibration [MPa]", "spin [MPa]", "both [MPa]"}) {
    EXPECT_NE(outcome.out.find(column), std::string::npos);
    EXPECT_NE(text_of(folder_ / "stressed" / "report.html").find(std::string("<th>") + column), std::string::npos);
  }
}

TEST_F(Page, LeavesTheStressOutWithoutFields) {
  const Outcome outcome = run("case.toml model.h5 response.h5 -o unstressed");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto peaks = rows_of(folder_ / "unstressed" / "critical_speeds.csv");
  ASSERT_GT(peaks.size(), 1U);
  for (const auto& peak : peaks)
    for (const char* column : stress_columns) EXPECT_EQ(peak.at(column), "");
  EXPECT_EQ(outcome.out.find("MPa"), std::string::npos);
  EXPECT_NE(text_of(folder_ / "unstressed" / "report.html").find("Stress at the peaks is left out"),
            std::string::npos);
}

}  // namespace
}  // namespace tiprub
