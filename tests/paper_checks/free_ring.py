# SPDX-License-Identifier: GPL-3.0-or-later
"""A case marched again with all nodal diameters at its critical speeds, so that those that its casing does not drive may move."""
import os

import h5py
import numpy

from registry import CannotBeMade, percent
from scene import Speed

NEAR = 1e-6  # of a speed: none may lie above the model's
RANGE_KEYS = ("speed_min_rpm", "speed_max_rpm", "speed_count", "speeds ", "speeds=", "speeds_rpm")


class FreeRing:
    def __init__(self, context, case):
        self.name = case.name
        rpm = sorted(float(row["speed [rpm]"]) for row in case.critical)
        if not rpm:
            raise CannotBeMade(f"{case.name} has no critical speed")
        path = os.path.join(context.work, case.name + "_free_ring.toml")
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(line for line in case.written.splitlines(keepends=True) if not line.startswith(RANGE_KEYS))
        settings = [setting for setting in case.settings if not setting.removeprefix("simulate.").startswith(RANGE_KEYS)]
        response = os.path.join(context.work, case.name + "_free_ring.h5")
        settings += ['simulate.nodal_diameters="all"', 'simulate.speeds="given"', 'simulate.examine="none"',
                     f"simulate.speeds_rpm={[x * (1 - NEAR) for x in rpm]}"]
        context.run_program("tiprub-simulate", path, case.path("model.h5"), "-o", response,
                            *(word for setting in settings for word in ("--set", setting)))
        with h5py.File(response) as file:
            assert int(file.attrs["independent_sectors"]) == case.sectors
            self.speeds = [Speed(group, case.model.normal, case.sectors) for group in file["speed"].values() if not group.attrs["failure"]]

    def verdict(self, share):
        """Whether the odd nodal diameters' share is below 1 % at the median critical speed, and what was measured."""
        shares = numpy.array([share(at) for at in self.speeds])
        above = ", ".join(f"{at.rpm:.0f} rpm {percent(value)}" for at, value in zip(self.speeds, shares) if value >= 0.01)
        return numpy.median(shares) < 0.01, (f"of {self.name} with all nodal diameters at its {len(shares)} critical speeds: median "
                                             f"{percent(numpy.median(shares))}; above 1 % at {(shares >= 0.01).sum()}{': ' if above else ''}{above}")


def odd_share(at):
    """Of the power of the leading edge's motion, without its mean."""
    power = at.waves[0][1:] ** 2
    return power[:, 1::2].sum() / power.sum()


def odd_force_share(at):
    power = at.force_waves[0] ** 2
    return power[:, 1::2].sum() / max(power.sum(), 1e-300)


def odd_to_even(at):
    parts = at.waves[0][1:].max(axis=0)
    return parts[1::2].max() / parts[0::2].max()
