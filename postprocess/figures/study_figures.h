// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "postprocess/figures/axes.h"
#include "postprocess/figures/figure.h"

namespace tiprub {

// One builder a figure; each says in its caption what is drawn and how. Those of maps are in maps.h.

// over_speed.cc
/// Tip amplitude over speed, peaks labelled.
Figure response_figure(const SpeedFrame& frame, const TipAmplitudes& amplitudes, const LinearRules& rules,
                       const std::vector<SpeedResponse>& speeds, Component component);
/// Where sweeps up and down differ; `record`: their table.
Figure sweeps_figure(const SpeedFrame& frame, const TipAmplitudes& amplitudes,
                     const std::vector<SweepComparison>& sweeps, Table record);
/// Orbits over speed [rpm], stable or not; needs branches.
Figure branches_figure(const TipAmplitudes& amplitudes, const Eigen::VectorXd& speeds,
                       const std::vector<SweepComparison>& sweeps, const std::vector<OrbitBranch>& branches);
Figure nodal_diameter_tracking_figure(const SpeedFrame& frame, const InteractionMap& map);  ///< paper, fig. 25
Figure engine_order_tracking_figure(const SpeedFrame& frame, const InteractionMap& map);    ///< paper, fig. 26

// natural_frequencies.cc
Figure campbell_figure(const SpeedFrame& frame, const LinearRules& rules);  ///< paper, fig. 8
/// At rest, at the shown speed and at the lowest critical one (paper, figs. 4, 13).
Figure interference_figure(const SpeedFrame& frame, double shown_speed, int asked_families);

// motion.cc
/// What all sectors do at the speed that is shown.
struct SectorSignal {
  std::string what;        ///< begins a caption: "The normal displacement, leading edge"
  std::string unit;        ///< of the values
  Eigen::MatrixXd values;  ///< a row a sample, a column a sector
};
struct FigureName {
  std::string file, title;
};
/// Paper, figs. 10, 16.
Figure sectors_figure(const SectorSignal& signal, const SpeedResponse& shown, const FigureName& name);
/// Paper, figs. 11, 17, made directional.
Figure two_way_spectrum_figure(const SectorSignal& signal, const SpeedResponse& shown, const SpeedFrame& frame,
                               double decades, const FigureName& name);
/// Paper, figs. 14, 15.
Figure contact_force_figure(const SimulatedScene& scene, const SpeedResponse& shown, const ContactLine& contact,
                            int engine_order_max);
Figure harmonic_bars_figure(const MapColumn& shown, int lobes, int engine_order_max);  ///< paper, fig. 20

// casing.cc
/// Paper, fig. 24.
Figure contact_map_figure(const SpeedFrame& frame, TipEdge edge, const ContactMaps& maps,
                          const std::string& of_blade);
/// Paper, fig. 21.
Figure casing_figure(const SimulatedScene& scene, const SpeedResponse& shown, const ContactLine& contact);

/// All of them, in the order of the page; without sweeps or branches, theirs is left out.
std::vector<Figure> study_figures(const Study& study);

}  // namespace tiprub
