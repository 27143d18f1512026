// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/speed/memory_of_speed.h"

#include <iomanip>
#include <sstream>

#include "cases/program/errors.h"

namespace tiprub {

namespace {

constexpr double real_bytes = 8, complex_bytes = 16, bytes_per_gib = 1024.0 * 1024 * 1024;
constexpr double revolutions_to_judge_by = 32;  // normal displacements of the last ones, and their spectrum
constexpr double values_per_sample = 4;         // three displacements and a force of a contact node
constexpr double copies = 3;                    // of a recording: being made, being halved, the result

double modes_of(const Scene& scene) {
  double modes = 0;
  for (const int n : scene.scope.nodal_diameters)
    modes += static_cast<double>(scene.model.nodal_diameters[static_cast<std::size_t>(n)].M.rows());
  return modes;
}

}  // namespace

double memory_of_speed(const Scene& scene) {
  const double samples = scene.scope.samples_per_revolution;
  const double recorded = samples * scene.parameters.recorded_revolutions;
  const double points = static_cast<double>(scene.scope.independent_sectors) * scene.model.contact.size();
  const bool cycle = scene.parameters.examination != Examination::none;
  const double states = complex_bytes * modes_of(scene) * (samples + (cycle ? copies * recorded : 0));
  return states + real_bytes * points *
                      (copies * values_per_sample * recorded + revolutions_to_judge_by * samples +
                       copies * scene.parameters.casing_areas);
}

void require_memory(const Scene& scene, int threads, double available) {
  const double each = memory_of_speed(scene);
  if (threads * each <= available) return;
  std::ostringstream text;
  text
      << "not enough memory: about " << std::setprecision(3) << threads * each / bytes_per_gib << " GiB are needed ("
      << threads << " speeds at once, " << each / bytes_per_gib << " GiB each), " << available / bytes_per_gib
      << " GiB are available; lower [simulate] samples_per_revolution, recorded_revolutions or casing_areas, or take "
         "fewer threads";
  throw RunError(text.str());
}

}  // namespace tiprub
