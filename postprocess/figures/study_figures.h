// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "postprocess/fields/field_study.h"
#include "postprocess/fields/sector_geometry.h"
#include "postprocess/figures/axes.h"
#include "postprocess/figures/drawing.h"
#include "postprocess/records/error_budget_record.h"
#include "postprocess/records/speeds_to_avoid.h"
#include "reduce/model/reduced_model.h"

namespace tiprub::postprocess {

// One builder for each figure; the captions in figures.json say what is drawn and how. Those of maps are in maps.h.

// meridional_section.cc, mesh_error.cc
/// The closed outlines of the area that some faces cover in the meridional plane; r, z [m], 2 x points. Edges of
/// faces are bent at their middle nodes. Pieces with less than a ten-thousandth of the largest area are left out.
std::vector<Eigen::Matrix2Xd> meridional_outline(const Eigen::Matrix3Xd& nodes,
                                                 const std::vector<SurfaceFace>& faces);
/// Paper, fig. 2; `clearance` [m] as the case gives it, by contact node.
Figure meridional_section_figure(const SectorFields& sector, const ContactLine& line,
                                 const Eigen::VectorXd& clearance);
/// What each cell contributes to the error of the mesh, on the sector's surface; needs these numbers.
Figure mesh_error_figure(const FieldStudy& fields);

// over_speed.cc
/// Tip amplitude over speed, peaks labelled.
Figure response_figure(const SpeedFrame& frame, const TipAmplitudes& amplitudes, const LinearRules& rules,
                       const std::vector<SpeedResponse>& speeds, Component component,
                       const std::vector<AvoidedBand>& avoided);
/// Stress of the vibration over speed, with what Goodman's rule allows; needs FieldResults::over_speed.
Figure stress_figure(const SpeedFrame& frame, const FieldResults& fields, const std::vector<AvoidedBand>& avoided);
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
/// A signal of all sectors at the speed that is shown.
struct SectorSignal {
  std::string what;        ///< begins a caption: "The normal displacement, leading edge"
  std::string unit;        ///< of the values
  Eigen::MatrixXd values;  ///< samples x sectors
};
/// Paper, figs. 10, 16: `name` is tip_motion or force_of_sectors.
Figure sectors_figure(const std::string& name, const SectorSignal& signal, const SpeedResponse& shown);
/// Paper, figs. 11, 17, made directional: `name` is tip_spectrum or force_spectrum.
Figure two_way_spectrum_figure(const std::string& name, const SectorSignal& signal, const SpeedResponse& shown,
                               const SpeedFrame& frame, double decades);
/// Paper, figs. 14, 15.
Figure contact_force_figure(const SimulatedScene& scene, const SpeedResponse& shown, const ContactLine& contact,
                            int engine_order_max);
/// Through the largest wave (paper, fig. 20).
Figure harmonic_bars_figure(const MapColumn& shown, int engine_order_max);

// casing.cc
/// Paper, fig. 24.
Figure contact_map_figure(const SpeedFrame& frame, TipEdge edge, const ContactMaps& maps,
                          const std::string& of_blade);
/// Paper, fig. 21.
Figure casing_figure(const SimulatedScene& scene, const SpeedResponse& shown, const ContactLine& contact);

// study_figures.cc
/// Of one critical speed, in its own units.
Figure error_budget_figure(const ErrorBudget& budget);

// The figures of a report in the order of its page. Most of them are study_figures(), which need no full fields and
// can be drawn while these are recovered.

/// Response, error budget and stress, as far as there are any.
std::vector<Figure> response_figures(const Study& study, const FieldResults& fields);
/// Those of sweeps and branches only if there are any.
std::vector<Figure> study_figures(const Study& study);
/// The section, and the mesh's error if it is estimated.
std::vector<Figure> sector_figures(const Study& study, const FieldStudy& fields);

}  // namespace tiprub::postprocess
