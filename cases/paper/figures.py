#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the paper's figures with our results into expected/.   figures.py"""
import os

import map_figures
import model_figures
import motion_figures
import wheel_figures
from scenes import all_scenes

scenes = all_scenes(os.path.dirname(os.path.abspath(__file__)))
for module in (model_figures, wheel_figures, motion_figures, map_figures):
    module.draw(scenes)
