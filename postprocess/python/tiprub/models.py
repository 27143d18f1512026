# SPDX-License-Identifier: GPL-3.0-or-later
"""model.h5, read or made. The format is described in reduce/format.md."""
import dataclasses

import h5py
import numpy as np

from .units import rad_per_s

HERMITIAN = 1e-9  # of the largest entry, as the programs demand


def text_of(value):
    return value.decode() if isinstance(value, bytes) else value


class ModelError(ValueError):
    """What a model lacks, so that the programs would refuse it."""


@dataclasses.dataclass
class Model:
    """A reduced rotor. Nodal diameter n moves sector j, at the angle j alpha, by Re(u e^{i n j alpha}).

    This is a ring of three blades, each a mass of 20 g on a spring:

    >>> spring = {"K0": 8e4 * np.eye(3), "M": 0.02 * np.eye(3)}
    >>> ring = Model(3, 2000.0, position=[[0.1, 0.0, 0.0]], normal=[[1.0, 0.0, 0.0]], arc_length=[0.0],
    ...              matrices={0: spring, 1: spring})
    >>> ring.frequencies(1, rpm=3000).round(3)
    array([318.31, 318.31, 318.31])
    >>> ring.write("ring.h5")
    >>> Model.read("ring.h5").sector_count
    3
    """

    sector_count: int     #: N
    speed_max: float      #: rad/s
    position: np.ndarray  #: contact nodes x 3: r [m], theta [rad], z [m]
    normal: np.ndarray    #: contact nodes x 3 (r, theta, z): unit vectors from blade to casing
    arc_length: np.ndarray  #: contact nodes [m], from the leading edge
    #: nodal diameter 0 .. N/2 -> {"K0": [N/m], "K1": [N/m s^2], ..., "M": [kg]}, each dofs x dofs; the first dofs are
    #: r, theta, z of each contact node: K(Omega) = K0 + Omega^2 K1 + Omega^4 K2 + ...
    matrices: dict
    modes_at_speed: int = 0  #: generalised dofs that are kept at one speed; 0 keeps all
    extra: dict = dataclasses.field(default_factory=dict)  #: further attributes of the root, for example contact="segments"

    def __post_init__(self):
        for name in ("position", "normal", "arc_length"):
            setattr(self, name, np.asarray(getattr(self, name), float))

    @classmethod
    def read(cls, path):
        """The model in a file. Static shift, verification and the second order of the gap stay in the file.

        >>> model = Model.read("model.h5")
        >>> model.normal.shape, sorted(model.matrices)
        ((2, 3), [0, 1, 2, 3])
        """
        with h5py.File(path) as file:
            if text_of(file.attrs.get("schema", "none")) != "tiprub-model":
                raise ModelError(f"{path}: is no model.h5; its attribute schema must be 'tiprub-model'")
            matrices = {int(n): {name: item[:] for name, item in group.items()} for n, group in file["nodal_diameter"].items()}
            contact = {name: file["contact"][name][:] for name in ("position", "normal", "arc_length")}
            own = ("prestress", "spin_softening", "contact")
            extra = {name: text_of(file.attrs[name]) for name in own if name in file.attrs}
            return cls(int(file.attrs["sector_count"]), float(file.attrs["speed_max"]), **contact, matrices=matrices,
                       modes_at_speed=int(file.attrs.get("modes_at_speed", 0)), extra=extra)

    def stiffness(self, n, rpm=0.0):
        """[N/m] K of nodal diameter n at a speed, dofs x dofs."""
        square, group = rad_per_s(rpm) ** 2, self.matrices[n]
        return sum(square ** int(name[1:]) * np.asarray(group[name]) for name in group if name.startswith("K"))

    def frequencies(self, n, rpm=0.0, count=None):
        """[Hz] the lowest `count`, or all, natural frequencies of nodal diameter n at a speed, ascending.

        They are those of the programs, with `modes_at_speed` dofs. A negative one is that of an unstable mode.

        >>> Model.read("model.h5").frequencies(2, rpm=20000, count=2).round(0)
        array([1362., 3570.])
        """
        K, M = self.stiffness(n, rpm), np.asarray(self.matrices[n]["M"])
        contact = 3 * len(self.arc_length)
        if 0 < self.modes_at_speed < len(M) - contact:
            T = self._basis(K, M, contact)
            K, M = T.conj().T @ K @ T, T.conj().T @ M @ T
        squares = _pencil(K, M)[0]
        return (np.sign(squares) * np.sqrt(np.abs(squares)) / (2 * np.pi))[:count]

    def _basis(self, K, M, contact):
        """Craig and Bampton (1968): contact dofs with their static shapes, and the lowest modes with these dofs held."""
        modes = _pencil(K[contact:, contact:], M[contact:, contact:])[1][:, :self.modes_at_speed]
        static = -np.linalg.solve(K[contact:, contact:], K[contact:, :contact])
        return np.block([[np.eye(contact), np.zeros((contact, modes.shape[1]))], [static, modes]])

    def check(self):
        """Raises ModelError with the first fault in shapes, normals, order of the nodes or matrices.

        The programs refuse what this refuses, and also places of nodes that contradict each other; see reduce/format.md.
        """
        nodes = len(self.arc_length)
        for fault, wrong in (
                ("sector_count must be at least 1", self.sector_count < 1),
                ("speed_max must be above 0", not self.speed_max > 0),
                ("position and normal must have the shape contact nodes x 3",
                 not self.position.shape == self.normal.shape == (nodes, 3)),
                ("the normals must have unit length", not np.allclose(np.linalg.norm(self.normal, axis=-1), 1, atol=1e-6)),
                ("the normals must point from the blade to the casing", np.mean(self.normal[..., 0]) <= -0.1),
                ("arc_length must increase", np.any(np.diff(self.arc_length) <= 0)),
                (f"matrices must hold the nodal diameters 0 .. {self.sector_count // 2}",
                 sorted(self.matrices) != list(range(self.sector_count // 2 + 1)))):
            if wrong:
                raise ModelError(fault)
        for n in self.matrices:
            self._check_matrices(n)

    def _check_matrices(self, n):
        group = {name: np.asarray(matrix) for name, matrix in self.matrices[n].items()}
        highest = max([2, *(int(name[1:]) for name in group if name[1:].isdigit())])
        if not {"M", "K0", *(f"K{k}" for k in range(3, highest + 1))} <= set(group) <= {"M", *(f"K{k}" for k in range(highest + 1))}:
            raise ModelError(f"nodal diameter {n}: needs M and K0, may have K1, K2, and K3, K4, ... without a gap, not {', '.join(sorted(group))}")
        size = group["M"].shape[:1]
        for name, matrix in group.items():
            place = f"nodal diameter {n}: {name}"
            if matrix.shape != 2 * size or len(matrix) < 3 * len(self.arc_length):
                raise ModelError(f"{place} has the shape {matrix.shape}; needed are equal squares with 3 dofs for each contact node")
            if not np.all(np.isfinite(matrix)):
                raise ModelError(f"{place} is not finite")
            if np.max(np.abs(matrix - matrix.conj().T)) > HERMITIAN * np.max(np.abs(matrix)):
                raise ModelError(f"{place} is not Hermitian")
            if 2 * n % self.sector_count == 0 and np.any(np.imag(matrix)):
                raise ModelError(f"{place} must be real on this nodal diameter")
        if np.linalg.eigvalsh(group["M"])[0] <= 0:
            raise ModelError(f"nodal diameter {n}: M is not positive definite")

    def write(self, path):
        """Writes a checked model.h5."""
        self.check()
        with h5py.File(path, "w") as file:
            file.attrs.update(schema="tiprub-model", schema_version=1, sector_count=self.sector_count, speed_max=float(self.speed_max),
                              modes_at_speed=self.modes_at_speed, **self.extra)
            for name in ("position", "normal", "arc_length"):
                file[f"contact/{name}"] = getattr(self, name)
            for n, group in self.matrices.items():
                for name, matrix in group.items():
                    file[f"nodal_diameter/{n}/{name}"] = matrix


def _pencil(K, M):
    """Eigenvalues, ascending, and vectors of K x = lambda M x with an M that is positive definite."""
    L = np.linalg.cholesky(M)
    values, vectors = np.linalg.eigh(np.linalg.solve(L, np.linalg.solve(L, K).conj().T))
    return values, np.linalg.solve(L.conj().T, vectors)
