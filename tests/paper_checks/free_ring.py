# SPDX-License-Identifier: GPL-3.0-or-later
"""A speed of a case marched again with all nodal diameters, so that those that its casing does not drive may move."""
import os

import h5py

from scene import Speed

NEAR = 1e-6  # of a speed: a sweep has two at least, and none above the model's


class FreeRing:
    def __init__(self, context, case):
        """At the periodic speed with the largest amplitude."""
        self.name, self.rpm = case.name, float(case.rpm[case.example])
        response = os.path.join(context.work, case.name + "_free_ring.h5")
        settings = ['nodal_diameters="all"', 'speeds="given"', f"speed_min_rpm={self.rpm * (1 - 2 * NEAR)!r}",
                    f"speed_max_rpm={self.rpm * (1 - NEAR)!r}", "speed_count=2"]
        context.run_program("tiprub-simulate", case.path("case.toml"), case.path("model.h5"), "-o", response,
                            *(word for setting in settings for word in ("--set", "simulate." + setting)))
        with h5py.File(response) as file:
            assert int(file.attrs["independent_sectors"]) == case.sectors
            group = list(file["speed"].values())[-1]
            self.speed = Speed(group, case.model.normal, case.sectors)

    def __str__(self):
        return f"the march of {self.name} with all nodal diameters at {self.rpm:.0f} rpm"

    def odd_share(self):
        """Of the power of the leading edge's motion, without its mean."""
        power = self.speed.waves[0][1:] ** 2
        return power[:, 1::2].sum() / power.sum()

    def odd_force_share(self):
        power = self.speed.force_waves[0] ** 2
        return power[:, 1::2].sum() / power.sum()

    def odd_to_even(self):
        parts = self.speed.waves[0][1:].max(axis=0)
        return parts[1::2].max() / parts[0::2].max()
