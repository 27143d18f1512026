// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/needed_terms.h"

#include <algorithm>
#include <cmath>
#include <iomanip>

#include "cases/program/text.h"
#include "cases/program/units.h"
#include "reduce/model/nodal_diameter.h"

namespace tiprub::simulate {

namespace {

double largest_change(const TermEffect& effect) {
  return std::max(std::abs(effect.shift), std::abs(effect.stress));
}

std::string percent_text(double share) {
  constexpr double large = 0.995;  // from where two digits would need an exponent
  if (std::abs(share) >= large) return text_of(std::fixed, std::setprecision(0), std::showpos, 100 * share, " %");
  return text_of(std::setprecision(2), std::showpos, 100 * share, " %");
}

std::string name_of_term(Variation term, const TermEffect* effect) {
  if (term == Variation::gap) return "the second order of the gap";
  return effect != nullptr ? text_of("friction of ", effect->setting) : "friction";
}

std::string rpm_of(const TermEffect& effect) {
  return text_of(std::fixed, std::setprecision(0), effect.speed * rpm_per_rad_s, " rev/min");
}

std::string not_known(const TermEffect& effect) {
  return "what it does at " + rpm_of(effect) + " is not known: " + effect.failure;
}

}  // namespace

double largest_elastic_energy(const RotorCycle& cycle, const std::vector<int>& nodal_diameters,
                              const ReducedModel& model, double speed) {
  Eigen::ArrayXd energy = Eigen::ArrayXd::Zero(cycle.displacement.front().cols());
  for (std::size_t i = 0; i < nodal_diameters.size(); ++i) {
    const int n = nodal_diameters[i];
    const Eigen::MatrixXcd& u = cycle.displacement[i];
    const Eigen::MatrixXcd forces = model.nodal_diameters[static_cast<std::size_t>(n)].stiffness(speed) * u;
    const double sectors = static_cast<double>(model.sector_count) / wave_count(n, model.sector_count);
    energy += sectors / 2 * (u.conjugate().cwiseProduct(forces)).real().colwise().sum().transpose().array();
  }
  return energy.maxCoeff();
}

std::vector<TermEffect> term_effects(const SpeedResponse& response, const std::vector<int>& nodal_diameters,
                                     const ReducedModel& model) {
  std::vector<TermEffect> effects;
  for (const PeakVariation& row : response.budget) {
    const bool adds_term = row.what == Variation::friction || (row.what == Variation::gap && row.setting > 1);
    if (!adds_term) continue;
    TermEffect effect{row.what, row.setting, response.speed, row.failure};
    if (row.failure.empty() && row.cycle && response.cycle) {
      const auto energy = [&](const RotorCycle& cycle, double speed) {
        return largest_elastic_energy(cycle, nodal_diameters, model, speed);
      };
      effect.shift = row.speed / response.speed - 1;
      effect.stress = std::sqrt(energy(*row.cycle, row.speed) / energy(*response.cycle, response.speed)) - 1;
    }
    effects.push_back(effect);
  }
  return effects;
}

Decision decide(Variation term, const std::vector<TermEffect>& effects, double accuracy) {
  const TermEffect *worst = nullptr, *unknown = nullptr;
  for (const TermEffect& effect : effects) {
    if (effect.term != term) continue;
    if (!effect.failure.empty())
      unknown = &effect;
    else if (worst == nullptr || largest_change(effect) > largest_change(*worst))
      worst = &effect;
  }
  const std::string name = name_of_term(term, worst != nullptr ? worst : unknown);
  if (worst == nullptr)
    return {false, name + " is off" +
                       (unknown != nullptr ? ", but " + not_known(*unknown)
                                           : ": no critical speed was found to judge it by")};
  const bool is_needed = largest_change(*worst) > accuracy;
  std::string text =
      text_of(name, " is ", is_needed ? "on" : "off", ": at ", rpm_of(*worst), " it changes the critical speed by ",
              percent_text(worst->shift), " and stress by about ", percent_text(worst->stress),
              is_needed ? ", more" : ", not more", " than accuracy = ", accuracy);
  if (unknown != nullptr && !is_needed) text += "; " + not_known(*unknown);
  return {is_needed, std::move(text)};
}

}  // namespace tiprub::simulate
