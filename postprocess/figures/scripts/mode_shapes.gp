# SPDX-License-Identifier: GPL-3.0-or-later
# Mode shapes: a row a family, a column a nodal diameter. Reads what panels.gp does.
title_font = key_font
load 'scripts/panels.gp'
