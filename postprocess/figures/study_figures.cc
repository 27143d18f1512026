// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/figures/study_figures.h"

namespace tiprub {

std::vector<Figure> study_figures(const Study& study) {
  std::vector<Figure> figures = {response_figure(study),
                                 interaction_map_figure(study, study.parameters.edge),
                                 interaction_map_figure(study, other_than(study.parameters.edge)),
                                 interaction_map_parts_figure(study),
                                 contact_map_figure(study, TipEdge::leading),
                                 contact_map_figure(study, TipEdge::trailing),
                                 campbell_figure(study),
                                 interference_figure(study),
                                 tip_motion_figure(study),
                                 tip_spectrum_figure(study),
                                 contact_force_figure(study),
                                 force_of_sectors_figure(study),
                                 force_spectrum_figure(study),
                                 harmonic_bars_figure(study),
                                 nodal_diameter_tracking_figure(study),
                                 engine_order_tracking_figure(study),
                                 waterfall_figure(study),
                                 casing_figure(study)};
  if (!study.response.branches.empty()) figures.insert(figures.begin() + 1, branches_figure(study));
  if (!study.sweeps.empty()) figures.insert(figures.begin() + 1, sweeps_figure(study));
  return figures;
}

}  // namespace tiprub
