# SPDX-License-Identifier: GPL-3.0-or-later
# The paper's model of contact on the wheels of the other cases, whatever these say: at nodes, with a linear gap. As when what is published
# with it was made, the roots have no fillets, and speeds end at 22,000 rpm.
AS_IN_THE_PAPER_SIMULATE := --set 'simulate.gap="linear"' --set simulate.speed_max_rpm=22000
AS_IN_THE_PAPER_MODEL := --set mesh.fillet_radius=0 --set 'reduce.contact="points"' --set reduce.contact_nodes=10 --set reduce.speed_max_rpm=22000
AS_IN_THE_PAPER := $(AS_IN_THE_PAPER_MODEL) $(AS_IN_THE_PAPER_SIMULATE)
