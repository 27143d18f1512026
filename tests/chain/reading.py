#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The reader in cases/reading finds in the files of a small disc what the programs say is in them.

usage: reading.py CASES_FOLDER FOLDER_WITH_FILES
"""
import os
import subprocess
import sys

import h5py
import numpy as np


def condensed(model, n, speed):
    """As reduce/format.md has it: K(Omega) and M on the contact dofs, and on the lowest modes with these held."""
    group, contact = model[f"nodal_diameter/{n}"], 3 * len(model["contact/arc_length"])
    K, M = group["K0"][:] + speed**2 * group["K1"][:] + speed**4 * group["K2"][:], group["M"][:]
    L = np.linalg.cholesky(M[contact:, contact:])
    _, vectors = np.linalg.eigh(np.linalg.solve(L, np.linalg.solve(L, K[contact:, contact:]).conj().T))
    modes = np.linalg.solve(L.conj().T, vectors)[:, :model.attrs["modes_at_speed"]]
    T = np.zeros((len(K), contact + modes.shape[1]), complex)
    T[:contact, :contact] = np.eye(contact)
    T[contact:] = np.hstack([-np.linalg.solve(K[contact:, contact:], K[contact:, :contact]), modes])
    return {"K0": T.conj().T @ K @ T, "M": T.conj().T @ M @ T}


def frequencies(reading, model, response):
    for row, speed in enumerate(response["frequencies/speed"][:]):
        for n, marched in response["frequencies/nodal_diameter"].items():
            own = reading.natural_frequencies({f"nodal_diameter/{n}": condensed(model, n, speed)}, n, 0.0)
            assert np.allclose(own, marched[row], rtol=1e-6), (n, speed, own, marched[row])


def motion(reading, model, response, fields):
    N, held = response.attrs["sector_count"], response.attrs["independent_sectors"]
    for speed in response["speed"].values():
        normal = reading.normal_motion(model, speed)
        amplitude = (normal.max(axis=0) - normal.min(axis=0)).max() / 2
        assert np.isclose(amplitude, speed.attrs["amplitude"], rtol=1e-12), speed.name
        sample = speed["snapshot"].attrs["sample"]
        force = reading.whole_wheel(response, speed["contact_force"])
        assert force.shape[1] == N and np.isclose(force[sample].sum(), speed["snapshot"].attrs["contact_force"])
        tips = fields["node_set/contact"][:]
        for sector in range(N):
            there = reading.contact_nodes_at(response, speed, sector)
            assert np.allclose(there, speed["displacement"][sample, sector % held], rtol=1e-9, atol=1e-15)
            everywhere = reading.all_nodes_at(fields, response, speed, sector)
            assert np.allclose(everywhere[tips], there, rtol=1e-5, atol=1e-12)


def main(cases, folder):
    sys.path.insert(0, os.path.join(cases, "reading"))
    import reading  # pylint: disable=import-outside-toplevel,import-self
    paths = [os.path.join(folder, name) for name in ("model.h5", "response.h5", "fields.h5")]
    model, response, fields = map(h5py.File, paths)
    frequencies(reading, model, response)
    motion(reading, model, response, fields)
    script = os.path.join(cases, "reading", "reading.py")
    printed = subprocess.run([sys.executable, "-B", script, *paths], text=True, stdout=subprocess.PIPE, check=True).stdout.splitlines()
    assert len(printed) == 1 + len(response["speed"]) and "mm on sector 0" in printed[1], printed
    with open(script, encoding="utf-8") as file:
        assert len(file.readlines()) <= 60, "it is meant to be read"


if __name__ == "__main__":
    sys.path.pop(0)  # its own folder holds a reading.py, too: this one
    main(*map(os.path.abspath, sys.argv[1:]))
