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

/// Symptom: with nonlinear prestress, the misfit of the polynomial stiffness stood in the budget as a second row of
/// reduced modes, although the first one contains it.
TEST_F(ErrorBudgets, HaveOneRowOfReducedModes) {
  Verification& verification = study.model.verification;
  verification.speeds = Eigen::VectorXd::Zero(1);
  verification.unreduced.assign(study.model.nodal_diameters.size(), Eigen::MatrixXd::Constant(1, 1, 500.0));
  verification.reduced.assign(study.model.nodal_diameters.size(), Eigen::MatrixXd::Constant(1, 1, 500.2));
  const auto count = static_cast<Eigen::Index>(study.model.nodal_diameters.size());
  verification.polynomial_misfit = Eigen::MatrixXd::Constant(1, count, 1e-4);
  vary(study.critical.front(), 1.01 * study.critical.front().speed);
  const std::vector<ErrorBudget> budgets = error_budgets(study, fields);
  ASSERT_FALSE(budgets.empty());
  std::vector<double> shifts;
  for (const BudgetRow& row : budgets.front().rows)
    if (row.source == "reduced modes") shifts.push_back(row.shift);
  ASSERT_EQ(shifts.size(), 1U);
  EXPECT_NEAR(shifts.front(), 4e-4, 1e-9);
}

/// Symptom: the first screen laid what the settings leave open at the door of "data and physics".
TEST_F(ErrorBudgets, SumDataAndPhysicsWithoutTheSettings) {
  ErrorBudget budget{study.critical.data(), 1e-3, 1e8, {}};
  budget.rows = {{"friction 0.1", "", 0.01, 0.3, 0.3, 0.2, "periodic"}, {"half the time step", "", 0.02, 0.4, 0.4}};
  budget.rows[1].is_setting = true;
  EXPECT_DOUBLE_EQ(sum_of(budget).amplitude, 0.5);
  EXPECT_DOUBLE_EQ(sum_of(budget, BudgetRows::data_and_physics).amplitude, 0.3);
  EXPECT_DOUBLE_EQ(sum_of(budget, BudgetRows::data_and_physics).shift, 0.01);
}

/// The half step of a peak that was lost is no doubt about data.
TEST_F(ErrorBudgets, ALostPeakOfASettingIsNoDoubtAboutData) {
  PeakVariation lost;
  lost.what = Variation::step;
  lost.failure = "another motion";
  study.response.speeds[static_cast<std::size_t>(study.critical.front().index)].budget = {lost};
  const ErrorBudget budget = error_budgets(study, fields).front();
  EXPECT_EQ(not_in_sum(budget), "half the time step");
  EXPECT_EQ(not_in_sum(budget, BudgetRows::data_and_physics), "");
}

/// Symptom: a peak whose stress was not recovered counted as one whose stress does not change.
TEST_F(ErrorBudgets, NameTheRowsWithoutAStress) {
  vary(study.critical.front(), 1.01 * study.critical.front().speed);
  EXPECT_EQ(not_in_stress_sum(error_budgets(study, fields).front()), "");  // no stress at all
  ErrorBudget budget = error_budgets(study, fields).front();
  budget.stress = 1e8;
  EXPECT_EQ(not_in_stress_sum(budget), "damping 0.002");
  EXPECT_EQ(not_in_sum(budget), "");
  budget.rows.front().stress = 0.1;
  EXPECT_EQ(not_in_stress_sum(budget), "");
}

/// Symptom: a change of the motion along the normal was applied to the tangential motion of the table.
TEST_F(ErrorBudgets, AreOfTheMotionAlongTheNormalOnly) {
  vary(study.critical.front(), 1.01 * study.critical.front().speed);
  EXPECT_EQ(error_budgets(study, fields).size(), 1U);
  study.parameters.component = Component::tangential;
  EXPECT_TRUE(error_budgets(study, fields).empty());
}

}  // namespace
}  // namespace tiprub::postprocess
