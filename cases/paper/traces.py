#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""One revolution of the leading edge's radial motion for each number of component modes, as the paper's fig. 9, into traces.tsv.

usage: traces.py PROGRAMS_FOLDER

The wheel is that of two_lobes on a coarse mesh, at one speed on the flank of its largest peak.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(HERE, "..", "convergence"))
from convergence import ETAS, MODES_IN_FILE, WHEEL_MODES_PER_ETA, Bench

SPEED_RPM = 14250
COARSE = {"along_chord": 14, "along_bore": 6, "along_span": 6, "through_splitter": 2, "through_disc": 3, "between_blades": 2}


def main(programs):
    bench = Bench(os.path.abspath(programs), os.path.join(HERE, ".."), folder="runs", case="paper/two_lobes")
    sector = bench.mesh("coarse", {f"elements_{name}": count for name, count in COARSE.items()})
    traces = {}
    for eta in ETAS:
        model = bench.model(f"eta{eta}", sector, {"fixed_interface_modes": MODES_IN_FILE, "verification_speeds": [0.0],
                                                  "modes_at_speed": eta * WHEEL_MODES_PER_ETA // 10})
        traces[eta] = bench.motion(f"eta{eta}", model, {"speeds_rpm": [SPEED_RPM], "examine": '"none"'})[0][0]
    with open("traces.tsv", "w", encoding="utf-8") as file:
        file.write("angle [deg]\t" + "\t".join(f"eta = {eta} [mm]" for eta in traces) + "\n")
        for step, values in enumerate(zip(*traces.values())):
            file.write(f"{360 * step / 240:g}\t" + "\t".join(f"{1e3 * value:.6f}" for value in values) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
