#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads model.h5, fields.h5 and response.h5 with h5py and numpy alone: a beginning for a post-processing of your own.

usage: reading.py MODEL.h5 RESPONSE.h5 [FIELDS.h5]       prints each speed, and what each file says of it
"""
import sys

import h5py
import numpy as np

RPM = 30 / np.pi

def natural_frequencies(model, n, speed):
    """[Hz] of nodal diameter n at a speed [rad/s], all dofs: K(Omega) = K0 + Omega^2 K1 + Omega^4 K2 + ..."""
    group = model[f"nodal_diameter/{n}"]
    K = sum(speed ** (2 * int(name[1:])) * group[name][:] for name in group if name.startswith("K"))
    L = np.linalg.cholesky(group["M"][:])
    squares = np.linalg.eigvalsh(np.linalg.solve(L, np.linalg.solve(L, K).conj().T))
    return np.sign(squares) * np.sqrt(np.abs(squares)) / (2 * np.pi)


def normal_motion(model, speed):
    """[m] samples x sectors held x contact nodes, towards the casing."""
    return np.einsum("sjkc,kc->sjk", speed["displacement"][:], model["contact/normal"][:])


def whole_wheel(response, dataset):
    """All N sectors from those held: sector j moves as sector j mod N_s."""
    return dataset[:][:, np.arange(response.attrs["sector_count"]) % response.attrs["independent_sectors"]]


def contact_nodes_at(response, speed, sector):
    """[m] contact nodes x 3 (r, theta, z) of a sector, from the snapshot's waves: u_j = Re(sum x_n e^{i n j alpha})."""
    turn = 2j * np.pi * sector / response.attrs["sector_count"]
    count = 3 * speed["displacement"].shape[2]
    return sum(np.real(x[:count, 0] * np.exp(int(n) * turn)) for n, x in speed["snapshot"].items()).reshape(-1, 3)


def all_nodes_at(fields, response, speed, sector):
    """[m] all nodes of a sector x 3 (r, theta, z of each node's own place), without the shape under spin."""
    turn = 2j * np.pi * sector / response.attrs["sector_count"]
    shapes = {n: np.tensordot(x[:, 0], fields[f"nodal_diameter/{n}/basis"][:], 1) for n, x in speed["snapshot"].items()}
    return sum(np.real(shape * np.exp(int(n) * turn)) for n, shape in shapes.items())


def main(model, response, fields=None):
    print(f"{response.attrs['sector_count']} sectors, {response.attrs['independent_sectors']} held; "
          f"first family at rest {natural_frequencies(model, 0, 0.0)[0]:.1f} Hz on nodal diameter 0")
    for speed in response["speed"].values():
        if speed.attrs["failure"]:
            print(f"{speed.attrs['speed'] * RPM:8.0f} rpm  {speed.attrs['failure'].decode()}")
            continue
        force = whole_wheel(response, speed["contact_force"]).sum(axis=(1, 2)).max()
        print(f"{speed.attrs['speed'] * RPM:8.0f} rpm  {1e3 * speed.attrs['amplitude']:.4f} mm  {force:8.1f} N at most", end="")
        print(f"  {1e3 * np.abs(all_nodes_at(fields, response, speed, 0)).max():.4f} mm on sector 0 then" if fields else "")


if __name__ == "__main__":
    main(*(h5py.File(path) for path in sys.argv[1:]))
