# SPDX-License-Identifier: GPL-3.0-or-later
"""The scenes that stand beside the paper: their tables in the paper's unit, in which the first family is at 10 at rest."""
import os
import tomllib

import numpy
import pandas

NAMES = {"paper-like wheel": ("two_lobes", "three_lobes"), "flying wheel": ("flying_two_lobes", "flying_three_lobes")}
FIRST_FAMILY = 10.0  # the paper's f = 10 on its hidden axes; Omega has the same unit, for its engine orders are f = k Omega


class Scene:
    """A case that `make` has made."""

    def __init__(self, wheel, folder, lobes):
        self.wheel, self.folder, self.lobes = wheel, folder, lobes
        at_rest = self.figure("interference").query("`speed [rpm]` == 0")
        self.families = at_rest.filter(like="family").to_numpy()  # [Hz] nodal diameters x families
        self.first = self.families[:, 0].mean()
        speeds = self.report("speeds")
        self.speeds = speeds[speeds["failure"].isna()]

    def figure(self, name):
        return pandas.read_csv(os.path.join(self.folder, "report", "figures", name + ".csv"))

    def report(self, name):
        return pandas.read_csv(os.path.join(self.folder, "report", name + ".csv"))

    def frequency(self, hertz):
        """In the paper's unit."""
        return numpy.asarray(hertz) / self.first * FIRST_FAMILY

    def omega(self, rpm):
        """In the paper's unit."""
        return self.frequency(numpy.asarray(rpm) / 60)

    @property
    def shown(self):
        """[rpm] the speed at which the report draws motion and force."""
        with open(os.path.join(self.folder, "report", "case.toml"), "rb") as file:
            wanted = tomllib.load(file)["postprocess"].get("shown_speed_rpm", 0)
        if wanted:
            return self.speeds["speed [rpm]"].iloc[(self.speeds["speed [rpm]"] - wanted).abs().argmin()]
        periodic = self.speeds[self.speeds["motion"] == "periodic"]
        return periodic.loc[periodic["amplitude [mm]"].idxmax(), "speed [rpm]"]

    @property
    def critical(self):
        return self.report("critical_speeds")

    @property
    def largest(self):
        critical = self.critical
        return critical.loc[critical["amplitude [mm]"].idxmax()]

    def contact_map(self, edge):
        """Speeds [rpm], number of places, contrast, and shares (speeds x areas)."""
        table = self.figure(f"contact_map_{edge}_edge")
        return (table["speed [rpm]"].to_numpy(), table["clusters"].to_numpy(), table["contrast [1]"].to_numpy(),
                table.filter(like="share at").to_numpy())


def all_scenes(here):
    """{wheel: (two lobes, three lobes)}"""
    return {wheel: tuple(Scene(wheel, os.path.join(here, folder), lobes) for folder, lobes in zip(folders, (2, 3)))
            for wheel, folders in NAMES.items()}
