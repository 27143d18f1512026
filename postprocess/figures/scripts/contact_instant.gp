# SPDX-License-Identifier: GPL-3.0-or-later
# Displacement or stress at one instant, from one or two sides. Reads what panels.gp does.
title_font = panel_font
load 'scripts/panels.gp'
