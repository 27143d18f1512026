// SPDX-License-Identifier: GPL-3.0-or-later
// The budget of critical speeds whose peaks become one.
#include "postprocess/records/error_budget_record.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "synthetic_scene.h"

namespace tiprub::postprocess {
namespace {

class ErrorBudgets : public ::testing::Test {
 protected:
  ErrorBudgets() : study(make_study({}, synthetic::model(), synthetic::resonant_sweep(synthetic::model()), {})) {
    fields.peaks.resize(study.critical.size());
    fields.varied.resize(study.critical.size());
  }

  /// The peak of a critical speed with less damping.
  void vary(const CriticalSpeed& critical, double speed) {
    PeakVariation less;
    less.what = Variation::damping;
    less.setting = 0.002;
    less.speed = speed;
    less.amplitude = less.excursion = 3 * critical.amplitude;
    study.response.speeds[static_cast<std::size_t>(critical.index)].budget = {less};
  }

  /// The first row of a critical speed.
  BudgetRow varied(const CriticalSpeed& critical) const {
    const auto budgets = error_budgets(study, fields);
    return std::ranges::find(budgets, &critical, &ErrorBudget::critical)->rows.front();
  }

  std::string shown(const CriticalSpeed& critical) const {
    const Table table = critical_speed_budgets(study, fields);
    const auto column = std::ranges::find(table.header, "moves |u| most") - table.header.begin();
    return std::get<std::string>(
        table.rows[static_cast<std::size_t>(&critical - study.critical.data())][static_cast<std::size_t>(column)]);
  }

  Study study;
  FieldResults fields;
};

/// Symptom: less damping was said to make a small peak of a wheel in three lobes 21 times as high. It had become one
/// with a larger peak, 6 % away.
TEST_F(ErrorBudgets, NameTheLargerPeakThatASmallOneJoins) {
  ASSERT_GE(study.critical.size(), 2U);
  const CriticalSpeed& large = study.critical[*largest_critical(study.critical)];
  const CriticalSpeed& small = study.critical[&large == study.critical.data() ? 1 : 0];
  vary(large, 1.01 * large.speed);
  vary(small, 1.011 * large.speed);
  EXPECT_EQ(varied(small).joined, &large);
  EXPECT_EQ(varied(large).joined, nullptr);
  EXPECT_NE(shown(small).find(", joins "), std::string::npos) << shown(small);
  EXPECT_EQ(shown(large).find(", joins "), std::string::npos) << shown(large);
  vary(small, 1.013 * large.speed);
  EXPECT_EQ(varied(small).joined, nullptr);
}

}  // namespace
}  // namespace tiprub::postprocess
