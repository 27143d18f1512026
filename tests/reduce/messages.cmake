# SPDX-License-Identifier: GPL-3.0-or-later
# What the reduction says, case by case, on a small plate, and on sectors that others meshed.
set(message_room reduce)
set(here ${CMAKE_CURRENT_SOURCE_DIR})
set(plate ${here}/annular_plate.toml=case.toml)
set(made ${CMAKE_CURRENT_BINARY_DIR})
add_test(NAME reduce.mesh_for_messages COMMAND tiprub-mesh -q ${here}/annular_plate.toml -o ${made}/sector.msh)
set_tests_properties(reduce.mesh_for_messages PROPERTIES FIXTURES_SETUP reduce_plate_sector)
set(message_fixtures reduce_plate_sector)
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-reduce> ARGUMENTS case.toml sector.msh INPUTS ${plate} ${made}/sector.msh)

# The mass is 7800 kg/m^3 pi (0.2^2 - 0.1^2) 0.02 m^3 / 6.
expect_message(works ERRORS "6 sectors of" "; the lowest frequency is 1616 Hz at rest (nodal diameter 0), and the mass of the sector is 2.45 kg; the mesh makes the first frequency of each nodal diameter up to" WRITES model.h5)
expect_message(help ARGUMENTS --help OUTPUTS "sector.msh")
expect_message(version ARGUMENTS --version OUTPUTS "tiprub-reduce ${PROJECT_VERSION}")
expect_message(check ARGUMENTS case.toml sector.msh --check ERRORS "the case and the sector are sound: 6 sectors" " dofs, 2.45 kg")
expect_message(refined ARGUMENTS case.toml sector.msh --set reduce.refine=1 ERRORS "6 sectors of" WRITES model.h5)
expect_message(refined_too_often ARGUMENTS case.toml sector.msh --check --set reduce.refine=4 EXIT_CODE 2
               ERRORS "[reduce] refine = 4 must be")
expect_message(cubic ARGUMENTS case.toml sector.msh --fields fields.h5 --set reduce.element_order=3
               ERRORS "6 sectors of" WRITES model.h5 fields.h5)
expect_message(cubic_modes ARGUMENTS case.toml sector.msh --modes modes.h5 --set reduce.element_order=3
               OUTPUTS "speed_rpm nodal_diameter mode" ERRORS " dofs" WRITES modes.h5)
expect_message(cubic_decks ARGUMENTS case.toml sector.msh --export-ccx decks --set reduce.element_order=3 EXIT_CODE 2
               ERRORS "[reduce] element_order = 3 makes cubic bricks, which CalculiX doesn't have; leave it at 2" WRITES decks)
expect_message(too_high_an_order ARGUMENTS case.toml sector.msh --check --set reduce.element_order=4 EXIT_CODE 2
               ERRORS "[reduce] element_order = 4 must be")
expect_message(verbose ARGUMENTS case.toml sector.msh --check -v ERRORS "BLAS: OpenBLAS" ", kernels ")
expect_message(generic_kernels PROGRAM ${CMAKE_COMMAND} -E env OPENBLAS_CORETYPE=Prescott $<TARGET_FILE:tiprub-reduce>
               ARGUMENTS case.toml sector.msh --check
               ERRORS "warning: OpenBLAS works with its generic kernels (Prescott), which take twice as long or more: OPENBLAS_CORETYPE")
expect_message(other_output ARGUMENTS case.toml sector.msh -o other.h5 ERRORS "other.h5: 6 sectors" WRITES other.h5)
expect_message(threads ARGUMENTS case.toml sector.msh --threads 2 ERRORS "6 sectors of" WRITES model.h5)
expect_message(too_many_threads ARGUMENTS case.toml sector.msh --threads 1000 EXIT_CODE 2 ERRORS "--threads" "not in range")
expect_message(times_in_place_of_a_folder ARGUMENTS case.toml sector.msh --times /tmp EXIT_CODE 1
               ERRORS "/tmp: can't be replaced: it is no file")
expect_message(no_arguments ARGUMENTS -q EXIT_CODE 2 ERRORS "case.toml is required")
expect_message(unknown_option ARGUMENTS case.toml sector.msh --fast EXIT_CODE 2 ERRORS "--fast")
expect_message(unknown_key KEY density LINE "densty = 7800.0" EXIT_CODE 2 ERRORS "[reduce] has no density")
expect_message(misspelt_key KEY contact_nodes LINE "contact_node = 2" EXIT_CODE 2
               ERRORS "case.toml:21:1: unknown key \"contact_node\" in [reduce] (did you mean contact_nodes?); known: accuracy, young_modulus")
expect_message(negative_modulus KEY young_modulus LINE "young_modulus = -1.0" EXIT_CODE 2
               ERRORS "[reduce] young_modulus = -1 must be at least 1 and at most 1e+15 [Pa]")
expect_message(wrong_prestress KEY density LINE "density = 7800.0\nprestress = \"none\"" EXIT_CODE 2
               ERRORS "prestress = \"none\" must be one of: linear, stress_only")
expect_message(too_many_contact_nodes KEY contact_nodes LINE "contact_nodes = 50" EXIT_CODE 2
               ERRORS "contact_nodes = 50 asks for more; ask for fewer, or refine the mesh along the blade")
expect_message(too_many_modes KEY fixed_interface_modes LINE "fixed_interface_modes = 500" EXIT_CODE 1
               ERRORS "modes, 500 are asked for; lower fixed_interface_modes or verification_modes, raise accuracy, or refine the mesh")
expect_message(no_case ARGUMENTS none.toml sector.msh EXIT_CODE 1 ERRORS "none.toml: can't be read")
expect_message(no_mesh ARGUMENTS case.toml none.msh EXIT_CODE 1 ERRORS "none.msh: no such file")
expect_message(no_folder ARGUMENTS case.toml sector.msh -o nowhere/model.h5 EXIT_CODE 1
               ERRORS "nowhere/model.h5: can't be written: no folder nowhere")
expect_message(no_gmsh_file FILE sector.msh OLD "MeshFormat" NEW "Recipe" EXIT_CODE 2 ERRORS "sector.msh: is no mesh in gmsh's format")
expect_message(no_gmsh_file_at_all ARGUMENTS case.toml case.toml EXIT_CODE 2 ERRORS "case.toml: is no mesh in gmsh's format")
expect_message(no_cyclic_high FILE sector.msh OLD "\"cyclic_high\"" NEW "\"cut\"" EXIT_CODE 2
               ERRORS "sector.msh: has no surface group \"cyclic_high\"; name it in the mesher")
expect_message(faces_of_different_size FILE sector.msh OLD "\"hub\"" NEW "\"cyclic_high\"" EXIT_CODE 2
               ERRORS "nodes on cyclic_low have no partner among the 37 on cyclic_high")
expect_message(a_node_astray FILE sector.msh OLD "0.1732050807568877 0.1 0.005" NEW "0.1732050807568877 0.1 0.0051" EXIT_CODE 2
               ERRORS "sector.msh: 1 of 21 nodes on cyclic_low have no partner among the 21 on cyclic_high, turned by \
360/6 degrees, within tolerance; the farthest is 0.0001 m from the nearest; mesh both cuts alike (gmsh: Periodic Surface)")
expect_message(a_node_astray_within_tolerance KEY contact_nodes LINE "contact_nodes = 2\ncyclic_tolerance = 1e-3"
               FILE sector.msh OLD "0.1732050807568877 0.1 0.005" NEW "0.1732050807568877 0.1 0.0051" ERRORS "6 sectors" WRITES model.h5)
expect_message(no_clamp FILE sector.msh OLD "\"clamped\"" NEW "\"bore\"" EXIT_CODE 2 ERRORS "has no surface group \"clamped\"")
expect_message(no_contact FILE sector.msh OLD "\"contact\"" NEW "\"tip\"" EXIT_CODE 2 ERRORS "has no curve or points named \"contact\"")
expect_message(no_sector FILE sector.msh OLD "\"sector\"" NEW "\"wheel\"" EXIT_CODE 2 ERRORS "has no volume group \"sector\" with cells; name it in the mesher, or import the mesh first: tiprub-mesh with [mesh] mesh_file")
expect_message(unstable_at_top_speed KEY young_modulus LINE "young_modulus = 1e5\nunusual = true\nprestress = \"stress_only\"" EXIT_CODE 1
               ERRORS "at 5000 rpm: the stiffness is not positive definite: the rotor is unstable")
expect_message(matrix_market ARGUMENTS case.toml sector.msh --export-matrix-market matrices
               ERRORS "matrices: K0 to K2 and M of 4 nodal diameters" WRITES matrices model.h5)
# Symptom: the fields and the matrices were silently not written.
expect_message(modes_and_fields ARGUMENTS case.toml sector.msh --modes modes.h5 --fields fields.h5 EXIT_CODE 2
               ERRORS "--fields and --export-matrix-market belong to a reduction, which --export-ccx and --modes leave out")
expect_message(modes_and_decks ARGUMENTS case.toml sector.msh --modes modes.h5 --export-ccx decks EXIT_CODE 2
               ERRORS "--export-ccx and --modes exclude each other; run tiprub-reduce once for each")
expect_message(modes ARGUMENTS case.toml sector.msh --modes modes.h5
               OUTPUTS "speed_rpm nodal_diameter mode frequency_hz branch mac energy_disc" WRITES modes.h5)
expect_message(modes_of_a_soft_wheel KEY young_modulus LINE "young_modulus = 1e8\nunusual = true" ARGUMENTS case.toml sector.msh --modes modes.h5
               OUTPUTS "speed_rpm tip_arc_length_m clearance_loss_m" ERRORS "modes.h5: warning: spin moves the tip by " WRITES modes.h5)
expect_message(nonlinear KEY density LINE "density = 7800.0\nprestress = \"nonlinear\"" ERRORS "terms alone within"
               WRITES model.h5)
# Symptom: a modulus in MPa passed all stages; the blade moved by 74 m on a wheel of 0.1 m.
expect_message(modulus_in_mpa KEY young_modulus LINE "young_modulus = 200e3" EXIT_CODE 2
               ERRORS "[reduce] young_modulus = 200000 is unusual: expected at least 1e+08 and at most 2e+12 [Pa]; is it in another unit"
               "add unusual = true to this table")
expect_message(density_in_g_per_cm3 KEY density LINE "density = 7.8" EXIT_CODE 2 ERRORS "density = 7.8 is unusual: expected at least 100")
expect_message(speed_in_hz KEY speed_max_rpm LINE "speed_max_rpm = 3" EXIT_CODE 2 ERRORS "has a tip speed of 0.06" "expected are 1 to 5000")
expect_message(softness_that_is_meant KEY young_modulus LINE "young_modulus = 1e8\nunusual = true"
               ERRORS "model.h5: warning: spin moves the tip by " " of its radius: are young_modulus [Pa]" WRITES model.h5)
expect_message(polynomial_misses INPUTS ${here}/soft_plate.toml=case.toml ${made}/sector.msh
               ERRORS "model.h5: warning: spin moves the tip by " "warning: the shape changes too much for eq. 7"
               "warning: the shape under spin leaves " "more than polynomial_tolerance (0.01 %)" WRITES model.h5)

# Symptom: K at a further speed and the list of rows were written over, and a speed without its file was left out.
set(matrices ${PROJECT_SOURCE_DIR}/tests/fuzz/matrices)
set(rows --matrices stiffness.mtx mass.mtx nodes.csv --matrix-dofs rows.dof)
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-reduce> EXIT_CODE 2
    INPUTS ${matrices}/case.toml ${matrices}/stiffness.mtx ${matrices}/stiffness.mtx=faster.mtx ${matrices}/mass.mtx ${matrices}/nodes.csv ${matrices}/rows.dof)
expect_message(model_over_the_rows ARGUMENTS case.toml ${rows} -o rows.dof ERRORS "rows.dof: would be written over rows.dof")
expect_message(model_over_a_further_matrix ARGUMENTS case.toml ${rows} --matrix-at 5000 faster.mtx -o faster.mtx ERRORS "faster.mtx: would be written over faster.mtx")
expect_message(further_speed_without_a_matrix ARGUMENTS case.toml ${rows} --matrix-at 5000 faster.mtx 8000 -o model.h5
               ERRORS "--matrix-at 8000: must be followed by the file of K at this speed")
expect_message(further_speed_twice ARGUMENTS case.toml ${rows} --matrix-at 5000 faster.mtx --matrix-at 5000.0 faster.mtx -o model.h5
               ERRORS "--matrix-at 5000.0: is given twice")
set(message_fixtures reduce_plate_sector)
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-reduce> EXIT_CODE 2 INPUTS ${plate} ${made}/sector.msh)
expect_message(decks_of_stress_only ARGUMENTS case.toml sector.msh --export-ccx decks --set reduce.prestress='stress_only' WRITES decks
               ERRORS "[reduce] prestress = \"stress_only\" takes the shape at rest, which CalculiX doesn't do; take")
expect_message(decks_without_softening ARGUMENTS case.toml sector.msh --export-ccx decks --set reduce.spin_softening=false WRITES decks
               ERRORS "[reduce] spin_softening = false leaves out what CalculiX always has; take true")
expect_message(decks_at_rest ARGUMENTS case.toml sector.msh --export-ccx decks --set reduce.spin_softening=false --set reduce.verification_speeds=[0.0]
               EXIT_CODE 0 ERRORS "decks: CalculiX decks for 1 speeds" WRITES decks)

set(message_defaults PROGRAM $<TARGET_FILE:tiprub-reduce> ARGUMENTS case.toml sector.msh INPUTS ${plate} ${made}/sector.msh)
# A sector that tiprub-mesh didn't make.
add_executable(gmsh_sector gmsh_sector.cc)
target_link_libraries(gmsh_sector PRIVATE ${GMSH_LIBRARY})
foreach(kind hex20 hex27 hex8 inverted held_cut)
  add_test(NAME reduce.gmsh_${kind} COMMAND gmsh_sector ${kind} ${made}/gmsh_${kind}.msh)
  set_tests_properties(reduce.gmsh_${kind} PROPERTIES FIXTURES_SETUP reduce_gmsh_sectors)
endforeach()
set(message_fixtures reduce_gmsh_sectors)
expect_message(gmsh_sector_hex20 INPUTS ${plate} ${made}/gmsh_hex20.msh=sector.msh ERRORS "8 sectors of 270 dofs" WRITES model.h5)
expect_message(gmsh_sector_hex27 INPUTS ${plate} ${made}/gmsh_hex27.msh=sector.msh ERRORS "8 sectors of 450 dofs" WRITES model.h5)
expect_message(gmsh_sector_hex8 INPUTS ${plate} ${made}/gmsh_hex8.msh=sector.msh EXIT_CODE 2
               ERRORS "elements of gmsh type 5; it must hold tet10" "corners only: make them quadratic")
expect_message(gmsh_sector_inverted INPUTS ${plate} ${made}/gmsh_inverted.msh=sector.msh EXIT_CODE 2
               ERRORS "is inverted or flat near x y z = ")
expect_message(gmsh_sector_held_cut INPUTS ${plate} ${made}/gmsh_held_cut.msh=sector.msh EXIT_CODE 2
               ERRORS "sector.msh: the face at x y z = " " of the surface group \"clamped\" lies on a cut, inside the wheel")

# Of 600 sectors with 500 modes at 301 nodal diameters, under 1.5 GB of data.
add_test(NAME reduce.mesh_large_disc COMMAND tiprub-mesh -q ${here}/large_disc.toml -o ${made}/large_disc.msh)
set_tests_properties(reduce.mesh_large_disc PROPERTIES FIXTURES_SETUP reduce_large_disc)
set(message_fixtures reduce_large_disc)
expect_message(too_little_memory PROGRAM sh ${here}/limited.sh -d 1500000 $<TARGET_FILE:tiprub-reduce>
               INPUTS ${here}/large_disc.toml=case.toml ${made}/large_disc.msh=sector.msh EXIT_CODE 1
               ERRORS "not enough memory: about")

include(bad_meshes.cmake)
