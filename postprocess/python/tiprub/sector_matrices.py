# SPDX-License-Identifier: GPL-3.0-or-later
"""A sector by its matrices, as tiprub-reduce --matrices reads it; see reduce/format.md."""
import csv
import os

import numpy as np

SETS = ("clamped", "cyclic_low", "cyclic_high", "contact")


def matrices(K, M, nodes, sets, folder=".", at=None):
    """Writes K.mtx, M.mtx and nodes.csv, and returns the arguments of tiprub-reduce that name them.

    K [N/m] and M [kg] are symmetric sparse matrices of scipy, or arrays, of an unreduced sector with free cuts, or of a
    single blade, with the rows x, y, z of each node in turn. `nodes` is nodes x 3: x, y, z [m] with the axis of rotation z.
    `sets` maps "clamped", "cyclic_low", "cyclic_high" and "contact" to indices of nodes; a node is in one set. `at` maps one
    or two further speeds [rpm] to K there.

    "contact" runs from leading to trailing edge. nodes.csv holds its nodes in this order: they exchange their places among
    themselves, and the rows and columns of the matrices with them. All other nodes keep their places.

    >>> matrices(8e4 * np.eye(6), 0.01 * np.eye(6), [[0.1, 0, 0], [0.2, 0, 0]], {"clamped": [0], "contact": [1]})
    ['--matrices', './K.mtx', './M.mtx', './nodes.csv']
    >>> print(open("nodes.csv").read(), end="")
    x,y,z,set
    0.1,0.0,0.0,clamped
    0.2,0.0,0.0,contact
    """
    nodes = np.asarray(nodes, float)
    of_node, order = _set_of_each(sets, len(nodes)), _order(sets, len(nodes))
    speeds = {f"K_{speed:g}rpm": (speed, matrix) for speed, matrix in (at or {}).items()}
    paths = {name: os.path.join(folder, name + ".mtx") for name in ("K", "M", *speeds)}
    for name, matrix in (("K", K), ("M", M), *((name, matrix) for name, (_, matrix) in speeds.items())):
        _write(paths[name], matrix, order)
    listing = os.path.join(folder, "nodes.csv")
    with open(listing, "w", newline="", encoding="ascii") as file:
        csv.writer(file, lineterminator="\n").writerows([["x", "y", "z", "set"], *([*nodes[k].tolist(), of_node[k]] for k in order)])
    further = [word for name, (speed, _) in speeds.items() for word in ("--matrix-at", f"{speed:g}", paths[name])]
    return ["--matrices", paths["K"], paths["M"], listing, *further]


def _order(sets, count):
    """The node in each row of nodes.csv: the places that contact nodes have take them in the order of the set."""
    order = np.arange(count)
    contact = order[np.asarray(sets.get("contact", []), int)]
    order[np.sort(contact)] = contact
    return order


def _set_of_each(sets, count):
    names = [""] * count
    for name, members in sets.items():
        if name not in SETS:
            raise ValueError(f"unknown set {name!r}; known: {', '.join(SETS)}")
        for node in members:
            if names[node]:
                raise ValueError(f"node {node} is in the sets {names[node]!r} and {name!r}")
            names[node] = name
    return names


def _write(path, matrix, order):
    from scipy import io, sparse
    matrix, size = sparse.csr_matrix(matrix), 3 * len(order)
    if matrix.shape != (size, size):
        raise ValueError(f"{os.path.basename(path)}: the matrix has the shape {matrix.shape}; the nodes need {size} rows, x, y, z of each")
    rows = (3 * order[:, None] + np.arange(3)).ravel()
    matrix = matrix[rows][:, rows]
    io.mmwrite(path, matrix, precision=17, symmetry="symmetric" if (matrix != matrix.T).nnz == 0 else "general")
