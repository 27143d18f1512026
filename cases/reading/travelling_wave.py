#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The motion of all tips at the largest peak as a travelling wave, with their contact.   travelling_wave.py CASE_FOLDER"""
import sys

import numpy as np
from matplotlib import pyplot

import tiprub

response = tiprub.open_response(sys.argv[1] + "/response.h5")
peaks = response.critical_speeds
worst = peaks.loc[peaks["amplitude [mm]"].idxmax()]
speed, node = worst["speed [rpm]"], int(worst["contact node"])
motion = tiprub.mm(response.whole_wheel(response.normal_motion(speed))).isel(contact_node=node)
force = response.whole_wheel(response.at(speed).contact_force).isel(contact_node=node)

figure, axes = pyplot.subplots(figsize=(8, 5), layout="constrained")
drawn = axes.pcolormesh(np.degrees(motion.angle), motion.sector, motion.T, cmap="RdBu_r", vmin=-abs(motion).max(), vmax=abs(motion).max())
figure.colorbar(drawn, label="displacement towards the casing [mm]")
samples, sectors = np.nonzero(force.values)
axes.scatter(np.degrees(force.angle[samples]), sectors, 30 * (force / force.max()).values[samples, sectors], color="black", label="contact force")
axes.set(xlabel="angle of the rotor [deg]", ylabel="sector", yticks=motion.sector, xlim=(0, 360))
axes.set_title(f"contact node {node} at {speed:.0f} rpm: EO {worst['engine order']:.0f}, ND {worst['signed nodal diameter']:+d}", loc="left")
axes.legend(loc="lower right", bbox_to_anchor=(1, 1))
figure.savefig("travelling_wave.png", dpi=120)
