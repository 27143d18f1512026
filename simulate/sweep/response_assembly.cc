// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/response_assembly.h"

#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "simulate/march/frequency_table.h"
#include "simulate/response/response_file.h"

namespace tiprub {

SweepTally assemble_response(const Scene& scene, const std::vector<double>& speeds,
                             const std::vector<OrbitBranch>& branches, int threads, FinishedSpeeds& finished,
                             const std::filesystem::path& output) {
  SweepTally tally;
  OutputFile file(output);
  ResponseWriter writer = finished.writer(file.scratch());
  writer.add(frequency_table(scene.model, speeds.back(), threads));
  for (const double speed : speeds) {
    const SpeedResponse response = finished.read(speed, Depth::full);
    tally.add(response);
    writer.add(response);
  }
  for (const OrbitBranch& branch : branches) writer.add(branch);
  writer.close();
  if (tally.failed < speeds.size()) file.commit();
  finished.remove();
  if (tally.failed == speeds.size()) throw RunError("no speed could be computed; " + tally.first_failure);
  return tally;
}

}  // namespace tiprub
