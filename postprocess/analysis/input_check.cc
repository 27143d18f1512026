// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/analysis/input_check.h"

#include <algorithm>
#include <functional>

#include "cases/program/errors.h"
#include "postprocess/tables/units.h"
#include "postprocess/waves/frequency_curves.h"
#include "reduce/model/model_digest.h"

namespace tiprub {

namespace {

void check_speed(const SpeedResponse& response, Eigen::Index areas, const std::string& name) {
  const std::string where = name + ": the speed " + rpm_text(response.speed) + " ";
  if (!(response.speed > 0)) throw RunError(where + "must be above 0");
  if (response.recorded_revolutions < 1 || response.samples_per_revolution < 1 || response.steps_per_revolution < 1)
    throw RunError(where + "holds no whole revolution");
  if (response.contact_count.cols() < 1) throw RunError(where + "has no contact areas");
  if (response.contact_count.cols() != areas)
    throw RunError(where + "has " + std::to_string(response.contact_count.cols()) + " contact areas, others have " +
                   std::to_string(areas));
}

void check_frequencies(const ReducedModel& model, const FrequencyTable& table, const std::string& name) {
  const Eigen::VectorXd& speeds = table.speed;
  const bool ascending = std::adjacent_find(speeds.begin(), speeds.end(), std::greater_equal<>()) == speeds.end();
  if (speeds.size() < FrequencyCurves::stencil || !ascending)
    throw RunError(name + ": /frequencies/speed must hold at least " + std::to_string(FrequencyCurves::stencil) +
                   " speeds, ascending; run tiprub-simulate");
  const auto diameters = static_cast<std::size_t>(model.nodal_diameter_max()) + 1;
  if (table.by_nodal_diameter.size() != diameters)
    throw RunError(name + ": /frequencies holds " + std::to_string(table.by_nodal_diameter.size()) +
                   " nodal diameters, the model has " + std::to_string(diameters) +
                   "; give the model that the response was made with");
}

}  // namespace

void check_together(const ReducedModel& model, const Response& response, const std::string& name) {
  const SimulatedScene& scene = response.scene;
  if (scene.sector_count != model.sector_count)
    throw InputError(name + ": has " + std::to_string(scene.sector_count) + " sectors, the model has " +
                     std::to_string(model.sector_count) + "; give the model that the response was made with");
  if (scene.clearance.size() != model.contact.size())
    throw InputError(name + ": has " + std::to_string(scene.clearance.size()) + " contact nodes, the model has " +
                     std::to_string(model.contact.size()) + "; give the model that the response was made with");
  if (scene.model_digest != digest(model))
    throw InputError(name + ": was made with another model of the same size; give that one, or run tiprub-simulate");
  if (response.speeds.empty()) throw RunError(name + ": holds no speed; run tiprub-simulate");
  Eigen::Index areas = 0;  // of the first speed that has a response
  for (const SpeedResponse& speed : response.speeds) {
    if (!speed.failure.empty()) continue;
    if (areas == 0) areas = speed.contact_count.cols();
    check_speed(speed, areas, name);
  }
  if (areas == 0)
    throw RunError(name + ": all " + std::to_string(response.speeds.size()) + " speeds failed; the first, " +
                   rpm_text(response.speeds.front().speed) + ", because: " + response.speeds.front().failure);
  check_frequencies(model, response.frequencies, name);
}

}  // namespace tiprub
