# SPDX-License-Identifier: GPL-3.0-or-later
"""K, M, nodes and rows of a sector; more of it, of a whole wheel, is in tests/peers/matrices.py."""
from corpus import Entry
from corpus_case import edit

K, M, NODES, ROWS, LINES = "stiffness.mtx", "mass.mtx", "nodes.csv", "rows.dof", "stiffness.sti"


def entry(name, file, old, new, phrase):
    """`old` must stand in the file."""
    def change(text):
        assert old in text, (file, old)
        added = new.count("\n") - old.count("\n")  # entries of K, whose head counts them
        return text.replace(old, new, 1).replace("\n12 12 57\n", f"\n12 12 {57 + added}\n")
    stiffness = LINES if file == LINES else K
    return Entry(name, "reduce", file, edit(change), 2, phrase, ("--matrices", stiffness, M, NODES, "--matrix-dofs", ROWS))


def of_matrices():
    yield entry("K.complex", K, "real", "complex", f"{K}:1: must be a real matrix")
    yield entry("K.no_matrix", K, "matrix", "vector", f"{K}:1: must be a real matrix")
    yield entry("K.banner", K, "%%MatrixMarket", "MatrixMarket", f"{K}:1: must be row, column and value, or %%MatrixMarket")
    yield entry("K.not_square", K, "12 12", "12 11", f"{K}:3: must have as many columns as rows")
    yield entry("K.no_rows", K, "12 12", "0 0", f"{K}:3: a row or column must be a whole number from 1")
    yield entry("K.fewer_rows", K, "12 12", "9 9", "an entry lies outside the 9 rows")
    yield entry("K.cut_off", K, "12 12 57", "12 12 58", f"{K}:60: has 57 entries, and its head lists 58; is the file cut off?")
    yield entry("K.more_rows", K, "12 12", "15 15", f"{ROWS}: lists 12 dofs; {K} has 15 rows")
    yield entry("K.half_a_row", K, "\n1 1 ", "\n1.5 1 ", f"{K}:4: a row or column must be a whole number from 1")
    yield entry("K.text", K, "\n1 1 ", "\n1 one ", f"{K}:4: must be row, column and a finite value")
    yield entry("K.infinite", K, "\n1 1 ", "\n1 1 inf", f"{K}:4: must be row, column and a finite value")
    yield entry("K.beyond_all_measure", K, "\n1 1 ", "\n1 1 1e308\n1 1 1e308\n1 1 ", f"{K}: entries of one place add up beyond all measure")
    yield entry("K.general", K, "symmetric", "general", f"{K}: is not symmetric")
    yield entry("sti.text", LINES, "1 1 ", "one 1 ", f"{LINES}:1: must be row, column and value, or %%MatrixMarket")
    yield entry("sti.half_a_row", LINES, "1 1 ", "1.5 1 ", f"{LINES}:1: a row or column must be a whole number from 1")
    yield entry("M.cut_off", M, "12 12", "13 13", "the matrix lacks entries; is the file cut off?")
    yield entry("M.negative", M, "\n0.25", "\n-0.25", f"{M}: gives 0.5, 1, 1 kg along x, y, z")


def by_direction(_):
    """M of four nodes, x of all nodes first, with a mass between the first two."""
    entries = [f"{row} {row} 0.25" for row in range(1, 13)] + [f"{row + 1} {row} 0.1" for row in (1, 5, 9)]
    return "\n".join(["%%MatrixMarket matrix coordinate real symmetric", f"12 12 {len(entries)}", *entries]) + "\n"


def of_the_case():
    """Symptom: keys without effect on matrices were taken silently."""
    for key, value, because in (("density", "7800.0", "K and M hold the material"),
                                ("prestress", '"nonlinear"', "K holds the effects of spin"),
                                ("refine", "1", "the matrices come without cells")):
        yield entry(f"case.{key}", "case.toml", "contact_nodes", f"{key} = {value}\ncontact_nodes",
                    f"case.toml:4:{len(key) + 4}: [reduce] {key} has no effect with --matrices, because {because}")
    yield entry("case.contact", "case.toml", "contact_nodes", 'contact = "segments"\ncontact_nodes',
                '[reduce] contact = "segments" needs the faces of the tip, which --matrices doesn\'t give; take "points"')


def of_wrong_matrices():
    yield entry("K.holds_a_node", K, "\n7 7 ", "\n7 7 1e4\n7 7 ", f"{K}: holds 1 of the 4 nodes against translations, the first at x y z = 0.1 0.02 0 m")
    yield Entry("M.by_direction", "reduce", M, edit(by_direction), 2, f"{M}: its rows are x of all nodes, then y, then z; expected are x, y, z of the first node",
                ("--matrices", K, M, NODES))


def of_nodes():
    yield entry("nodes.no_head", NODES, "node,x,y,z,set\n", "", f"{NODES}:1: must name the columns: x, y, z")
    yield entry("nodes.text", NODES, "11,0.1", "11,here", f"{NODES}:2: must be a finite x")
    yield entry("nodes.number", NODES, "11,0.1", "-11,0.1", f"{NODES}:2: a row or column must be a whole number")
    yield entry("nodes.twice", NODES, "12,0.12", "11,0.12", f"{NODES}: has two nodes of number 11")
    yield entry("nodes.free", NODES, "clamped\n12,0.12,0,0,clamped", "\n12,0.12,0,0,",
                f"{NODES}: has no node whose set is clamped, so that nothing holds the wheel; name the nodes that are held")
    yield entry("nodes.set", NODES, "clamped", "held", f"{NODES}:2: set \"held\" must be clamped")
    yield entry("nodes.one_cut", NODES, "clamped", "cyclic_low", f"{NODES}: has nodes on one cut, and none on the other")
    yield entry("nodes.elsewhere", NODES, "13,0.1,", "13,0.3,", f"are its rows those that {NODES} and {ROWS} tell")


def of_rows():
    yield entry("rows.fewer", ROWS, "14.3\n", "", f"{ROWS}: lists 11 dofs; {K} has 12 rows")
    yield entry("rows.twice", ROWS, "11.2", "11.1", f"{ROWS}: names 11.1 twice")
    yield entry("rows.unknown", ROWS, "11.2", "21.2", f"{ROWS}: names node 21, which {NODES} doesn't have")
    yield entry("rows.fourth", ROWS, "11.2", "11.4", f"{ROWS}:2: must be a node and a direction, as 12.3")


ENTRIES = [*of_the_case(), *of_matrices(), *of_wrong_matrices(), *of_nodes(), *of_rows()]
