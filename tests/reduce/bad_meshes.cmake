# SPDX-License-Identifier: GPL-3.0-or-later
# Meshes that are damaged, wrong, or no meshes, and what is said of them. gmsh runs what is in its script language;
# nothing of that may happen: "command_ran" would be a new file.
set(disc ${here}/small_bladed_disc.toml=case.toml)
add_test(NAME reduce.mesh_of_small_disc COMMAND tiprub-mesh -q ${here}/small_bladed_disc.toml -o ${made}/small_disc.msh)
set_tests_properties(reduce.mesh_of_small_disc PROPERTIES FIXTURES_SETUP reduce_small_disc)
set(message_fixtures reduce_small_disc)
set(small ${made}/small_disc.msh=sector.msh)
set(sound "the case and the sector are sound: 6 sectors")
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-reduce> ARGUMENTS case.toml sector.msh --check INPUTS ${disc} ${small} FILE sector.msh)

expect_message(script_for_a_mesh INPUTS ${disc} ${here}/command.geo=sector.msh EXIT_CODE 2
               ERRORS "sector.msh: is no mesh in gmsh's format: its first line must be $MeshFormat; write it by gmsh FILE -save")
expect_message(script_before_a_mesh OLD "$MeshFormat" NEW "SystemCall \"touch command_ran\";\n$MeshFormat" EXIT_CODE 2
               ERRORS "sector.msh: is no mesh in gmsh's format")
expect_message(remark_before_a_mesh OLD "$MeshFormat" NEW "// by hand\n$MeshFormat" EXIT_CODE 2 ERRORS "is no mesh in gmsh's format")
expect_message(comments_before_a_mesh OLD "$MeshFormat" NEW "$Comments\nby hand\n$EndComments\n$MeshFormat" ERRORS "${sound}")
expect_message(script_within_a_mesh OLD "$Nodes" NEW "SystemCall \"touch command_ran\";\n$Nodes" ERRORS "${sound}")
expect_message(script_after_a_mesh OLD "$EndElements" NEW "$EndElements\nSystemCall \"touch command_ran\";" ERRORS "${sound}")
expect_message(options_beside_a_mesh PROGRAM env HOME=. $<TARGET_FILE:tiprub-reduce>
               INPUTS ${disc} ${small} ${here}/command.geo=sector.msh.opt ${here}/command.geo=.gmshrc ${here}/command.geo=.gmsh-options
               ERRORS "${sound}" WRITES .fltk)  # what gmsh's windows keep in every home
expect_message(mesh_named_as_a_script ARGUMENTS case.toml sector.geo --check
               INPUTS ${disc} ${made}/small_disc.msh=sector.geo ${here}/command.geo=sector.geo.opt ERRORS "${sound}")
expect_message(a_folder_for_a_mesh ARGUMENTS case.toml . --check EXIT_CODE 1 ERRORS ".: is no file that can be read")

# gmsh 4.8 wrote past its arrays here, and the program died of it.
expect_message(fewer_nodes_than_follow OLD "8 149 1 149" NEW "8 10 1 149" EXIT_CODE 2 ERRORS "sector.msh: gmsh ")
expect_message(more_nodes_than_memory OLD "8 149 1 149" NEW "8 4000000000 1 4000000000" EXIT_CODE 2 ERRORS "sector.msh: gmsh ")
expect_message(unknown_node OLD "37 131 135" NEW "37 131 99999" EXIT_CODE 2
               ERRORS "sector.msh: gmsh can't read it: Unknown node 99999 in element 37")
expect_message(node_nowhere OLD "0.02802112794499461 -0.01071524095343833 -0.01" NEW "nan -0.01071524095343833 -0.01" EXIT_CODE 2
               ERRORS "sector.msh: node " " stands at no finite place")

# One mid-side node 8 cm off: det J is negative at a corner, and positive at all Gauss points. That was reduced without a word.
expect_message(inverted_at_a_corner OLD "0.04484956306099854 -0.003676505574253225 -0.01" NEW "0.04484956306099854 -0.003676505574253225 -0.09"
               EXIT_CODE 2 ERRORS "sector.msh: cell " " (disc) is inverted or flat near x y z = " " m; re-mesh")
expect_message(cuts_exchanged OLD "2 4 \"cyclic_low\"\n2 5 \"cyclic_high\"" NEW "2 4 \"cyclic_high\"\n2 5 \"cyclic_low\"" EXIT_CODE 2
               ERRORS "sector.msh: cyclic_low and cyclic_high are exchanged: cyclic_high must be cyclic_low turned by +360/6 degrees about z")
expect_message(no_cuts OLD "2 4 \"cyclic_low\"\n2 5 \"cyclic_high\"" NEW "2 4 \"front\"\n2 5 \"back\""
               ERRORS "the case and the sector are sound: one body without cuts")
expect_message(contact_jumps OLD "38 135 139 \n39 139 143" NEW "38 139 143 \n39 135 139" EXIT_CODE 2
               ERRORS "sector.msh: the curve \"contact\" jumps from x y z = ")
expect_message(contact_turns_back OLD "38 135 139 \n39 139 143 \n40 143 147" NEW "38 135 143 \n39 143 139 \n40 139 147" EXIT_CODE 2
               ERRORS "sector.msh: the line \"contact\" turns back at its point 3 of 5, x y z = ")
expect_message(contact_on_the_splitter_alone OLD "\"contact\"" NEW "\"contact_splitter\"" EXIT_CODE 2
               ERRORS "sector.msh: has no curve or points named \"contact\" (the main blade's tip, from leading to trailing edge)")
# Contact by segments takes the faces of the tip; contact at points doesn't ask for them.
set(segments ARGUMENTS case.toml sector.msh --check --set "reduce.contact=\"segments\"")
expect_message(segments ${segments} ERRORS "${sound}")
expect_message(segments_without_a_tip ${segments} OLD "\"blade_tip\"" NEW "\"end\"" EXIT_CODE 2
               ERRORS "sector.msh: has no surface group \"blade_tip\" with the faces of the main blade's tip")
expect_message(segments_of_the_hub ${segments} OLD "2 7 \"hub\"\n2 8 \"blade_tip\"" NEW "2 7 \"blade_tip\"\n2 8 \"hub\"" EXIT_CODE 2
               ERRORS "sector.msh: the node at x y z = " "of the line \"contact\" is not on the surface group \"blade_tip\"; both must be")
expect_message(points_without_a_tip OLD "\"blade_tip\"" NEW "\"end\"" ERRORS "${sound}")
# Symptom: --modes, which has no contact, was refused because of a line with fewer nodes than contact_nodes.
expect_message(modes_with_a_short_line ARGUMENTS case.toml sector.msh --modes modes.h5 --set reduce.contact_nodes=9
               OUTPUTS "speed_rpm nodal_diameter mode" WRITES modes.h5)
expect_message(unknown_contact ARGUMENTS case.toml sector.msh --check --set "reduce.contact=\"lines\"" EXIT_CODE 2
               ERRORS "contact = \"lines\" must be one of: automatic, points, segments")
# In millimetres the wheel would be a thousand times as large, and its tip as fast.
expect_message(millimetres FILE case.toml OLD "speed_max_rpm = 30000.0" NEW "speed_max_rpm = 3e7" EXIT_CODE 2
               ERRORS "sector.msh: a wheel of radius 0.1 m has a tip speed of 314159 m/s at [reduce] speed_max_rpm" "is the mesh in millimetres?")

expect_message(mesh_of_another_case FILE case.toml OLD "blade_count = 6" NEW "blade_count = 8"
               ERRORS "sector.msh was made with mesh.blade_count = 6, and the case has 8; the model is that of the mesh" "${sound}")

# What physics leaves no room for, and what overflowed: E = 1e200 and 1e-300 ended in a segmentation fault.
set(message_defaults ${message_defaults} FILE case.toml)
expect_message(too_stiff KEY young_modulus LINE "young_modulus = 1e200" EXIT_CODE 2 ERRORS "young_modulus = 1e+200 must be")
expect_message(too_soft KEY young_modulus LINE "young_modulus = 1e-300" EXIT_CODE 2 ERRORS "young_modulus = 1e-300 must be")
expect_message(too_light KEY density LINE "density = 1e-300" EXIT_CODE 2 ERRORS "density = 1e-300 must be")
expect_message(too_fast KEY speed_max_rpm LINE "speed_max_rpm = 1e300" EXIT_CODE 2 ERRORS "speed_max_rpm = 1e+300 must be")
expect_message(too_tolerant KEY contact_nodes LINE "contact_nodes = 2\ncyclic_tolerance = 1e3" EXIT_CODE 2 ERRORS "cyclic_tolerance = 1000 must be")

# Where little memory may be mapped, OpenBLAS tried for ever to map its buffers.
foreach(limit 600000 700000 2000000)
  expect_message(no_room_to_map_${limit} PROGRAM sh ${here}/limited.sh -v ${limit} timeout 60 $<TARGET_FILE:tiprub-reduce>
                 ARGUMENTS case.toml sector.msh --set reduce.threads=32 EXIT_CODE 1 ERRORS "not enough memory: about" "are available")
endforeach()

# Each output is tried before the work.
expect_message(no_folder_for_fields ARGUMENTS case.toml sector.msh --fields nowhere/fields.h5 EXIT_CODE 1
               ERRORS "nowhere/fields.h5: can't be written: no folder nowhere")
expect_message(no_folder_for_modes ARGUMENTS case.toml sector.msh --modes nowhere/modes.h5 EXIT_CODE 1
               ERRORS "nowhere/modes.h5: can't be written: no folder nowhere")
expect_message(file_for_a_folder ARGUMENTS case.toml sector.msh --export-matrix-market case.toml EXIT_CODE 1
               ERRORS "case.toml: can't be made a folder")

expect_message(folder_not_writable ARGUMENTS case.toml sector.msh -o /proc/model.h5 KEY fixed_interface_modes LINE "fixed_interface_modes = 500"
               EXIT_CODE 1 ERRORS "/proc/model.h5: can't be written: ")
expect_message(fields_over_the_model ARGUMENTS case.toml sector.msh -o x.h5 --fields ./x.h5 EXIT_CODE 2
               ERRORS "./x.h5: would be written over x.h5, which this run reads or writes too; give it another name")
expect_message(modes_over_the_case ARGUMENTS case.toml sector.msh --modes case.toml EXIT_CODE 2 ERRORS "case.toml: would be written over case.toml")
expect_message(tables_onto_a_full_disk PROGRAM sh -c "exec \"$0\" \"$@\" >/dev/full" $<TARGET_FILE:tiprub-reduce>
               ARGUMENTS case.toml sector.msh --modes modes.h5 EXIT_CODE 1 ERRORS "stdout: can't be written to its end" WRITES modes.h5)
expect_message(two_runs_on_one_output PROGRAM flock .model.h5.lock $<TARGET_FILE:tiprub-reduce> ARGUMENTS case.toml sector.msh EXIT_CODE 1
               ERRORS "model.h5: another process is writing it; wait for that, or give another -o" WRITES .model.h5.lock)

add_executable(convert_sector convert_sector.cc)
target_link_libraries(convert_sector PRIVATE ${GMSH_LIBRARY})
add_test(NAME reduce.all_formats_give_the_same_bytes
         COMMAND sh ${here}/formats.sh $<TARGET_FILE:tiprub-mesh> $<TARGET_FILE:convert_sector> $<TARGET_FILE:tiprub-reduce>
                 ${here}/small_bladed_disc.toml ${made}/formats)
