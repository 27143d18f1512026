// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/sweep/response_assembly.h"

#include "cases/program/errors.h"
#include "cases/program/output_file.h"
#include "simulate/march/frequency_table.h"
#include "simulate/response/response_file.h"
#include "simulate/sweep/speed_sweep.h"

namespace tiprub {

SweepTally assemble_response(const Scene& scene, int threads, FinishedSpeeds& finished,
                             const std::filesystem::path& output) {
  SweepTally tally;
  OutputFile file(output);
  {
    ResponseWriter writer = finished.writer(file.scratch());
    writer.add(frequency_table(scene.model, scene.parameters.speeds.back(), threads));
    for (const SpeedTask& task : sweep_tasks(scene.parameters)) {
      SpeedResponse response = finished.read(task.speed);
      if (task.check == StepCheck::none) {  // a former, other list of speeds may have asked for it
        response.audit.halving_difference.reset();
        response.audit.halving_measure.clear();
      }
      tally.add(response);
      writer.add(response);
    }
  }
  const std::size_t speeds = scene.parameters.speeds.size();
  if (tally.failed < speeds) file.commit();
  finished.remove();
  if (tally.failed == speeds) throw RunError("no speed could be computed; " + tally.first_failure);
  return tally;
}

}  // namespace tiprub
