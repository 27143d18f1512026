// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "cases/program/progress.h"
#include "postprocess/fields/cell_stress.h"
#include "postprocess/fields/cycle_stress.h"
#include "postprocess/fields/field_peak.h"
#include "postprocess/fields/wheel_cycle.h"
#include "reduce/model/fields_file.h"
#include "reduce/model/reduced_model.h"

namespace tiprub::postprocess {

/// How many samples of a cycle SectorStress looks at on the whole sector.
int samples_on_sector(const WheelCycle& cycle);

/// The stress of the whole sector over cycles of the wheel.
///
/// A motion that does not repeat itself has hundreds of samples. On the whole sector, only some 60 of a revolution
/// are looked at; even a wave of engine order 15 has 70 % of its largest value in one of them. Their states are sums
/// of fewer ones, which leaves out of each nodal diameter at most 0.5 % of the cycle's norm of elastic energy. All
/// samples are looked at, and nothing is left out, where they may matter: at the nodes with at least 70 % of the
/// largest displacement, or of the largest stress, alternating stress or utilisation of their zone. The largest
/// values of a zone are therefore those of all samples, unless waves of higher engine orders dominate. At other nodes
/// a value may be a little off, mostly too small, and the mean is that of the samples looked at.
class SectorStress {
 public:
  /// `nodal_diameters`: those of the states of a cycle. The references must outlive this object.
  SectorStress(const FieldsReader& reader, const CellStress& bricks, const ReducedModel& model,
               const std::vector<int>& nodal_diameters, const StressZones& zones,
               const std::optional<MaterialStrength>& strength);
  /// At most so many fields, with their stress, are in memory at once; by default as many as take 1 GiB.
  void set_most_fields(int most) { most_fields_ = most; }

  /// A cycle or an instant, and its speed [rad/s].
  struct At {
    WheelCycle cycle;
    double speed = 0;
  };
  using Take = std::function<void(std::size_t place, const CycleStress& stress)>;
  /// Takes the stress of each cycle, in their order. The fields of as many as the memory holds are read together.
  /// `progress` advances with each sample on the whole sector.
  void over(const std::vector<At>& cycles, Progress& progress, const Take& take) const;
  /// Waves of the whole sector with their stress, as WaveRecovery.
  std::vector<WaveField> recover(std::size_t diameter, const Eigen::MatrixXcd& states) const;

 private:
  /// A cycle as it is looked at on the whole sector, by few states.
  struct OnSector {
    WheelCycle cycle;
    std::vector<FewStates> few;  ///< of all its samples
  };

  OnSector on_sector(const At& at) const;
  WaveField spin_at(double speed) const;
  /// The fields of several cycles, read together; by cycle and nodal diameter.
  std::vector<std::vector<SampledWaves>> recover(const std::vector<OnSector>& cycles) const;
  /// Renews the values of `stress` at the nodes that may have the largest ones, from all samples.
  void look_closer(const WheelCycle& cycle, const Tensors& spin, CycleStress& stress) const;

  const FieldsReader& reader_;
  const CellStress& bricks_;
  const ReducedModel& model_;
  const std::vector<int>& nodal_diameters_;
  const StressZones& zones_;
  const std::optional<MaterialStrength>& strength_;
  int most_fields_;
};

}  // namespace tiprub::postprocess
