#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Aliasing on ten sectors (paper, sec. 5.1.2 and 5.1.3, appendix A): by closed forms, and by marching.

Writes clustering.tsv (fig. 11), waves.tsv (fig. 12), zigzag.tsv (fig. 13), equation_17.tsv and table_1.tsv in this folder.
"""
import csv

import numpy

SECTORS = 10
ALPHA = 2 * numpy.pi / SECTORS
# Appendix A's oscillators, uncoupled. The stiffness puts their own frequency halfway between two multiples of omega, where
# a transform over two revolutions holds it apart from every forced line: no damping is needed to tell them.
MASS, OMEGA, FORCE = 1.0, 1.0, 1.0
STIFFNESS = MASS * (7.5 * OMEGA) ** 2
REVOLUTIONS = 2
STEPS = 40000  # a revolution


def signed_nodal_diameter(order):
    """k mod N in (-N/2, N/2]: above 0 the wave runs backward, below forward, seen from the rotor."""
    n = order % SECTORS
    return n - SECTORS if 2 * n > SECTORS else n


def smallest_multiple(nodal_diameter, lobes):
    """The smallest k of eq. 17, alpha N +- n_d = k N_l; none if no casing harmonic reaches n_d."""
    for k in range(1, SECTORS + 1):  # k repeats with period N
        if abs(signed_nodal_diameter(k * lobes)) == nodal_diameter:
            return k
    return None


def marched(order):
    """Ten oscillators (eq. 18) from rest under F cos(p(omega t + i alpha)) (eq. 21), by central differences; two-way transform of
    the motion.

    Returns the complex amplitudes of the line `order` over the sectors' signed wave numbers. The steady amplitude of the
    scheme is F/(k - (4 m/h^2) sin^2(p omega h/2)), which tends to the table's with h^2."""
    h = 2 * numpy.pi / OMEGA / STEPS
    phase = order * ALPHA * numpy.arange(SECTORS)
    force = FORCE * numpy.cos(order * OMEGA * h * numpy.arange(REVOLUTIONS * STEPS)[:, None] + phase)
    motion = numpy.zeros((REVOLUTIONS * STEPS, SECTORS))
    motion[1] = 0.5 * h * h / MASS * force[0]
    for q in range(1, len(motion) - 1):
        motion[q + 1] = 2 * motion[q] - motion[q - 1] + h * h / MASS * (force[q] - STIFFNESS * motion[q])
    # The free motion of the scheme, at its own frequency, is fitted with the forced line and taken out: exact, no leakage.
    own = 2 / h * numpy.arcsin(0.5 * h * numpy.sqrt(STIFFNESS / MASS))
    t = h * numpy.arange(len(motion))
    basis = numpy.stack([f(w * t) for w in (order * OMEGA, own) for f in (numpy.cos, numpy.sin)], axis=1)
    cosine, sine = numpy.linalg.lstsq(basis, motion, rcond=None)[0][:2]
    return numpy.fft.fft(cosine - 1j * sine) / SECTORS


def clustering():
    """Two waves, close in frequency, on nodal diameters 0 and 2 (the fictitious peaks of fig. 11): one peak over time, two apart.

    Rows: engine order, amplitude at one sector over time alone, amplitudes by nodal diameter 0 .. 5."""
    revolutions, samples = 4, 240
    t = 2 * numpy.pi * numpy.arange(revolutions * samples) / samples
    sector = ALPHA * numpy.arange(SECTORS)
    motion = numpy.cos(10 * t)[:, None] + 0.6 * numpy.cos(10.05 * t[:, None] + 2 * sector)  # closer than one line, 1/4
    line = numpy.abs(numpy.fft.rfft(motion[:, 0])) * 2 / len(t)
    waves = numpy.abs(numpy.fft.fft(numpy.fft.rfft(motion, axis=0), axis=1)) * 2 / len(t) / SECTORS
    both = [waves[:, 0]] + [waves[:, n] + (waves[:, SECTORS - n] if 2 * n < SECTORS else 0) for n in range(1, SECTORS // 2 + 1)]
    return [(m / revolutions, f"{line[m]:.6f}", *(f"{part[m]:.6f}" for part in both)) for m in range(15 * revolutions + 1)]


def write(name, header, rows):
    with open(name, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, delimiter="\t", lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def table_1():
    """One row for each p: closed form, marched, and the largest of the coefficients that should be zero."""
    rows = []
    for p in (3, 6, 9, 12):
        n = signed_nodal_diameter(p)
        closed = FORCE / (STIFFNESS - p * p * MASS * OMEGA ** 2)
        h = 2 * numpy.pi / OMEGA / STEPS
        scheme = FORCE / (STIFFNESS - 4 * MASS / h ** 2 * numpy.sin(0.5 * p * OMEGA * h) ** 2)
        amplitudes = marched(p)
        others = numpy.delete(amplitudes, n % SECTORS)
        rows.append((p, abs(n), n, p * p, f"{closed:.12e}", f"{scheme:.12e}", f"{amplitudes[n % SECTORS].real:.12e}",
                     f"{abs(others).max():.1e}"))
    return rows


def main():
    theta = numpy.linspace(0, 2 * numpy.pi, 721)
    write("waves.tsv", ("theta [rad]", "cos 6 theta", "cos 4 theta", "cos 8 theta", "cos 2 theta"),
          [[f"{value:.9f}" for value in (t, *numpy.cos([6 * t, 4 * t, 8 * t, 2 * t]))] for t in theta])
    write("clustering.tsv", ("engine order", "one sector", *(f"nodal diameter {n}" for n in range(SECTORS // 2 + 1))), clustering())
    write("zigzag.tsv", ("engine order", "nodal diameter", "signed nodal diameter", "two lobes", "three lobes"),
          [(k, abs(signed_nodal_diameter(k)), signed_nodal_diameter(k), int(k > 0 and k % 2 == 0), int(k > 0 and k % 3 == 0))
           for k in range(31)])
    write("equation_17.tsv", ("nodal diameter", "lobes", "smallest k", "engine order"),
          [(n, lobes, "none" if k is None else k, "none" if k is None else k * lobes)
           for lobes in (2, 3) for n in range(SECTORS // 2 + 1) for k in [smallest_multiple(n, lobes)]])
    write("table_1.tsv", ("p", "nodal diameter", "signed nodal diameter", "p^2", "F/(k - p^2 m omega^2)",
                          "the same of the scheme", "marched", "largest other"), table_1())


if __name__ == "__main__":
    main()
