# SPDX-License-Identifier: GPL-3.0-or-later
"""A sector by its matrices, as tiprub-reduce --matrices reads it; see reduce/format.md."""
import csv
import os

import numpy as np

SETS = ("clamped", "cyclic_low", "cyclic_high", "contact")
SYMMETRIC = 1e-9  # of the largest entry, as tiprub-reduce demands


def matrices(K, M, nodes, sets, folder=".", at=None):
    """Writes K.mtx, M.mtx and nodes.csv, and returns the arguments of tiprub-reduce that name them.

    K [N/m] and M [kg] are symmetric sparse matrices of scipy, or arrays, of an unreduced sector with free cuts, or of a
    single blade, with the rows x, y, z of each node in turn. `nodes` is nodes x 3: x, y, z [m] with the axis of rotation z.
    `sets` maps "clamped", "cyclic_low", "cyclic_high" and "contact" to indices of nodes; a node is in one set. `at` maps one
    or two further speeds [rpm] to K there.

    "contact" runs from leading to trailing edge. nodes.csv holds its nodes in this order: they exchange their places among
    themselves, and the rows and columns of the matrices with them. All other nodes keep their places.

    Raises ValueError, before anything is written, if a matrix is not real, finite and symmetric, or if nodes or sets are
    wrong. The message counts rows and nodes from 0, as the caller does.

    >>> matrices(8e4 * np.eye(6), 0.01 * np.eye(6), [[0.1, 0, 0], [0.2, 0, 0]], {"clamped": [0], "contact": [1]})
    ['--matrices', './K.mtx', './M.mtx', './nodes.csv']
    >>> print(open("nodes.csv").read(), end="")
    x,y,z,set
    0.1,0.0,0.0,clamped
    0.2,0.0,0.0,contact
    """
    nodes = np.asarray(nodes, float)
    of_node, order = _set_of_each(sets, len(nodes)), _order(sets, len(nodes))
    speeds = {f"{speed:.12g}": matrix for speed, matrix in (at or {}).items()}
    given = {"K": K, "M": M, **{f"at[{speed}]": matrix for speed, matrix in speeds.items()}}
    sound = {name: _checked(name, matrix, 3 * len(nodes)) for name, matrix in given.items()}
    paths = [os.path.join(folder, name + ".mtx") for name in ("K", "M", *(f"K_{speed}rpm" for speed in speeds))]
    for path, matrix in zip(paths, sound.values()):
        _write(path, matrix, order)
    listing = os.path.join(folder, "nodes.csv")
    with open(listing, "w", newline="", encoding="ascii") as file:
        csv.writer(file, lineterminator="\n").writerows([["x", "y", "z", "set"], *([*nodes[k].tolist(), of_node[k]] for k in order)])
    further = [word for speed, path in zip(speeds, paths[2:]) for word in ("--matrix-at", speed, path)]
    return ["--matrices", *paths[:2], listing, *further]


def _order(sets, count):
    """The node in each row of nodes.csv: the places that contact nodes have take them in the order of the set."""
    order, given = np.arange(count), sets.get("contact", [])
    if isinstance(given, (set, frozenset)):
        raise ValueError("sets['contact'] has no order; give a list from leading to trailing edge")
    contact = order[np.array(list(given), int)]
    order[np.sort(contact)] = contact
    return order


def _set_of_each(sets, count):
    names = [""] * count
    for name, members in sets.items():
        if name not in SETS:
            raise ValueError(f"unknown set {name!r}; known: {', '.join(SETS)}")
        for node in members:
            if not -count <= node < count:
                raise ValueError(f"sets[{name!r}]: there is no node {node}; the {count} nodes count from 0")
            if names[node]:
                raise ValueError(f"node {node} is in the sets {names[node]!r} and {name!r}")
            names[node] = name
    return names


def _scipy():
    try:
        import scipy.io
        import scipy.sparse
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError("tiprub.matrices needs scipy: install the Debian package python3-scipy", name=error.name) from None
    return scipy


def _checked(name, matrix, size):
    """The matrix as a sparse one of scipy's."""
    sparse = _scipy().sparse
    matrix = sparse.csr_matrix(matrix)
    if matrix.shape != (size, size):
        raise ValueError(f"{name} has the shape {matrix.shape}; the nodes need {size} rows, x, y, z of each")
    if np.iscomplexobj(matrix):
        raise ValueError(f"{name} is complex; the matrices of a sector with free cuts are real")
    entries = matrix.tocoo()
    wrong = np.flatnonzero(~np.isfinite(entries.data))
    if wrong.size:
        raise ValueError(f"{name}[{entries.row[wrong[0]]}, {entries.col[wrong[0]]}] = {entries.data[wrong[0]]} is not finite")
    difference = abs(matrix - matrix.T).tocoo()
    if difference.nnz and difference.data.max() > SYMMETRIC * abs(matrix).max():
        _refuse_unsymmetric(name, matrix, difference)
    return matrix


def _refuse_unsymmetric(name, matrix, difference):
    sparse = _scipy().sparse
    lower, upper = sparse.tril(matrix, -1).count_nonzero(), sparse.triu(matrix, 1).count_nonzero()
    if not lower or not upper:
        half = f"tril({name}, -1)" if lower else f"triu({name}, 1)"
        raise ValueError(f"{name}: only one triangle is filled: pass {name} + scipy.sparse.{half}.T")
    largest = difference.data.argmax()
    row, column = sorted((int(difference.row[largest]), int(difference.col[largest])))
    raise ValueError(f"{name} is not symmetric: {name}[{row}, {column}] = {float(matrix[row, column])}, but {name}[{column}, {row}] = "
                     f"{float(matrix[column, row])}, and no other pair differs more")


def _write(path, matrix, order):
    io = _scipy().io
    rows = (3 * order[:, None] + np.arange(3)).ravel()
    matrix = matrix[rows][:, rows]
    io.mmwrite(path, matrix, precision=17, symmetry="symmetric" if (matrix != matrix.T).nnz == 0 else "general")
