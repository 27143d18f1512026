// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/input_check.h"

#include <algorithm>

#include "cases/program/case_file.h"
#include "cases/program/errors.h"
#include "postprocess/tables/table.h"
#include "postprocess/waves/wave_label.h"

namespace tiprub::postprocess {

namespace {

constexpr const char* another_model = "; give the model that the response was made with";

/// Squares and fourth powers of these numbers are computed later, and gnuplot scales them: damaged ones must end
/// here.
template <class Values>
void check_measure(const Values& values, const std::string& where) {
  constexpr double largest = 1e30;
  if (values.size() > 0 && values.array().abs().maxCoeff() > largest)
    throw RunError(where + " reaches " + scientific(values.array().abs().maxCoeff(), 0) +
                   ", beyond all measure; the file is damaged, or that motion grew without bound");
}

/// Checks the states from which full fields are recovered.
void check_states(const SpeedResponse& speed, const std::vector<int>& moving, const ReducedModel& model,
                  const std::string& name) {
  const auto require = [&](std::size_t place, Eigen::Index dofs) {
    const Eigen::Index expected = model.nodal_diameters[static_cast<std::size_t>(moving[place])].M.rows();
    if (dofs != expected)
      throw InputError(name + ": at " + rpm_text(speed.speed) + " the states of nodal diameter " +
                       std::to_string(moving[place]) + " have " + std::to_string(dofs) + " dofs, the model has " +
                       std::to_string(expected) + another_model);
  };
  for (std::size_t i = 0; i < moving.size(); ++i) {
    if (speed.snapshot) require(i, speed.snapshot->displacement[i].size());
    if (speed.cycle) require(i, speed.cycle->displacement[i].rows());
    for (const PeakVariation& peak : speed.budget)
      if (peak.cycle && peak.model_digest.empty()) require(i, peak.cycle->displacement[i].rows());
  }
}

void check_frequencies(const ReducedModel& model, const FrequencyTable& table, const std::string& name) {
  if (table.speed.size() < FrequencyCurves::stencil)
    throw FileError(name + ": /frequencies/speed must hold at least " + std::to_string(FrequencyCurves::stencil) +
                    " speeds; run tiprub-simulate");
  for (std::size_t n = 0; n < table.by_nodal_diameter.size(); ++n)
    if (const Eigen::Index modes = table.by_nodal_diameter[n].cols(), dofs = model.nodal_diameters[n].M.rows();
        modes > dofs)
      throw InputError(name + ": /frequencies holds " + std::to_string(modes) + " modes of nodal diameter " +
                       std::to_string(n) + ", the model has " + std::to_string(dofs) + " dofs" + another_model);
}

}  // namespace

void check_measures(const Response& response, const std::string& name) {
  check_measure(response.scene.casing_distortion, name + ": /casing/distortion");
  check_measure(response.scene.node_distortion, name + ": /casing/node_distortion");
  check_measure(response.scene.node_crest, name + ": /casing/node_crest");
  for (const SpeedResponse& speed : response.speeds) {
    const std::string where = name + ": at " + rpm_text(speed.speed) + " ";
    check_measure(Eigen::VectorXd::Constant(1, speed.speed), where + "the speed");
    check_measure(speed.clearance, where + "the clearance");
    check_measure(speed.displacement, where + "the displacement");
    check_measure(speed.contact_force, where + "the contact force");
  }
  check_measure(response.frequencies.speed, name + ": /frequencies/speed");
  for (const Eigen::MatrixXd& frequencies : response.frequencies.by_nodal_diameter)
    check_measure(frequencies, name + ": /frequencies");
}

void check_casing(const std::string& casing, const SimulatedScene& scene, const std::string& name) {
  for (const DifferingKey& differing : differing_keys(scene.casing, casing))
    throw InputError(name + ": was simulated with another [casing] than this case's: " + differing.key + " is " +
                     differing.one.value_or("not given") + " there and " + differing.other.value_or("not given") +
                     " here; run tiprub-simulate again, or give the case (or --set) that it was made with");
}

void check_together(const ReducedModel& model, const Response& response, const std::string& name) {
  const SimulatedScene& scene = response.scene;
  if (scene.sector_count != model.sector_count)
    throw InputError(name + ": has " + std::to_string(scene.sector_count) + " sectors, the model has " +
                     std::to_string(model.sector_count) + another_model);
  if (scene.clearance.size() != model.contact.size())
    throw InputError(name + ": has " + std::to_string(scene.clearance.size()) + " contact nodes, the model has " +
                     std::to_string(model.contact.size()) + another_model);
  if (scene.model_digest != digest(model))
    throw InputError(name + ": was made with another model of the same size; give that one, or run tiprub-simulate");
  if (response.speeds.empty()) throw FileError(name + ": holds no speed; run tiprub-simulate");
  for (const SpeedResponse& speed : response.speeds) check_states(speed, scene.nodal_diameters, model, name);
  const bool all_failed =
      std::ranges::none_of(response.speeds, [](const SpeedResponse& speed) { return speed.failure.empty(); });
  if (all_failed)
    throw RunError(name + ": all " + std::to_string(response.speeds.size()) + " speeds failed; the first, " +
                   rpm_text(response.speeds.front().speed) + ", because: " + response.speeds.front().failure);
  check_frequencies(model, response.frequencies, name);
  check_measures(response, name);
}

}  // namespace tiprub::postprocess
