#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What moves the largest peak, and what makes it larger.   budget.py CASE_FOLDER"""
import sys

from matplotlib import pyplot

import tiprub

response = tiprub.open_response(sys.argv[1] + "/response.h5")
figure, (left, right) = pyplot.subplots(1, 2, sharey=True, figsize=(10, 4), layout="constrained")
tiprub.plots.budget(response, "speed", left)
tiprub.plots.budget(response, "amplitude", right)
right.set_title("")
figure.savefig("budget.png", dpi=120)
