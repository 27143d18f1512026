// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "postprocess/analysis/study.h"
#include "postprocess/figures/figure.h"

namespace tiprub {

// One builder a figure; each says in its caption what is drawn and how.

// maps/
Figure interaction_map_figure(const Study& study, TipEdge edge);  ///< paper, fig. 22a
Figure interaction_map_parts_figure(const Study& study);          ///< paper, fig. 22b-g
Figure waterfall_figure(const Study& study);                      ///< paper, fig. 18a
Figure contact_map_figure(const Study& study, TipEdge edge);      ///< paper, fig. 24

// speeds/
Figure response_figure(const Study& study);                 ///< tip amplitude over speed, peaks labelled
Figure sweeps_figure(const Study& study);                   ///< where sweeps up and down differ
Figure branches_figure(const Study& study);                 ///< orbits over speed, stable or not; needs branches
Figure campbell_figure(const Study& study);                 ///< paper, fig. 8
Figure interference_figure(const Study& study);             ///< paper, figs. 4, 13
Figure nodal_diameter_tracking_figure(const Study& study);  ///< paper, fig. 25
Figure engine_order_tracking_figure(const Study& study);    ///< paper, fig. 26

// motion/
Figure tip_motion_figure(const Study& study);        ///< paper, fig. 10
Figure tip_spectrum_figure(const Study& study);      ///< paper, fig. 11, made directional
Figure contact_force_figure(const Study& study);     ///< paper, figs. 14, 15
Figure force_of_sectors_figure(const Study& study);  ///< paper, fig. 16
Figure force_spectrum_figure(const Study& study);    ///< paper, fig. 17, made directional
Figure harmonic_bars_figure(const Study& study);     ///< paper, fig. 20
Figure casing_figure(const Study& study);            ///< paper, fig. 21

/// All of them, in the order of the page; without sweeps or branches, theirs is left out.
std::vector<Figure> study_figures(const Study& study);

}  // namespace tiprub
