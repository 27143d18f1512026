# SPDX-License-Identifier: GPL-3.0-or-later
# Meshes of other codes that are wrong, and what is said of them.
set(bricks ${PROJECT_SOURCE_DIR}/tests/fuzz/meshes)
set(importing INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/import.toml=case.toml ${bricks}/brick.inp ${bricks}/brick.bdf ${bricks}/brick.cdb ${bricks}/brick.unv ${bricks}/brick.msh
              ARGUMENTS case.toml -o sector.msh FILE brick.inp)
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-mesh> ${importing})
expect_message(import_works ERRORS "brick.inp: 20 nodes, 1 hex20" "no cuts: one body" "contact: 3 nodes" "wrote sector.msh" WRITES sector.msh)
foreach(format bdf cdb unv)
  expect_message(import_of_${format} ARGUMENTS case.toml --import brick.${format} --check --set "mesh.clamped='plane x 0.04'"
                 --set "mesh.blade_tip='plane x 0.06'" --set "mesh.contact=''" ERRORS "20 nodes, 1 hex20" "no cuts: one body")
endforeach()
expect_message(import_without_a_unit FILE case.toml OLD "length_unit = \"mm\"\n" NEW "" EXIT_CODE 2
               ERRORS "[mesh] has no length_unit, and it has no default; add it")
expect_message(import_of_no_format ARGUMENTS case.toml --import case.toml --check EXIT_CODE 2
               ERRORS "[mesh] mesh_file doesn't end as a format that is known; name it: mesh_format = inp, bdf, cdb, unv or msh")
expect_message(import_of_cad INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/import.toml=case.toml ${bricks}/brick.inp=brick.step FILE case.toml OLD "brick.inp"
               NEW "brick.step" EXIT_CODE 2 ERRORS "[mesh] mesh_file has no mesh yet: gmsh brick.step -3 -order 2 -o brick.msh")
expect_message(import_of_a_wheel FILE case.toml OLD "contact = " NEW "family = \"impeller\"\ncontact = " EXIT_CODE 2 ERRORS "unknown key \"family\" in [mesh]")
expect_message(import_of_no_file FILE case.toml OLD "brick.inp" NEW "nowhere.inp" EXIT_CODE 1 ERRORS "nowhere.inp")
expect_message(import_unknown_set FILE case.toml OLD "clamped = \"clamped\"" NEW "clamped = \"bore\"" EXIT_CODE 2
               ERRORS "brick.inp: [mesh] clamped = \"bore\": there is no set of this name with nodes of solids; there are: ALL, CLAMPED, CONTACT, SOLID")
expect_message(import_selects_nothing FILE case.toml OLD "clamped = \"clamped\"" NEW "clamped = \"cylinder 40\"" EXIT_CODE 2
               ERRORS "clamped = \"cylinder 40\" selects no face of the surface, of a radius up to 0.06" "is length_unit right?")
expect_message(import_lacks_a_number FILE case.toml OLD "clamped = \"clamped\"" NEW "clamped = \"plane x\"" EXIT_CODE 2
               ERRORS "clamped = \"plane x\" lacks a number")
expect_message(import_of_no_plane FILE case.toml OLD "clamped = \"clamped\"" NEW "clamped = \"plane r 1\"" EXIT_CODE 2
               ERRORS "must be plane x, y or z and a place")
expect_message(import_of_no_normal FILE case.toml OLD "clamped = \"clamped\"" NEW "clamped = \"normal 0 0 0\"" EXIT_CODE 2
               ERRORS "brick.inp: [mesh] clamped = \"normal 0 0 0\" has no direction; give a vector that is not zero")
expect_message(import_one_cut FILE case.toml OLD "contact = " NEW "cyclic_low = \"contact\"\ncontact = " EXIT_CODE 2
               ERRORS "cyclic_low needs the other cut beside it")
expect_message(import_no_tip OLD "NSET=contact" NEW "NSET=tip" ARGUMENTS case.toml --set "mesh.contact=''" --check EXIT_CODE 2
               ERRORS "brick.inp: [mesh] needs blade_tip, the faces of the main blade's tip, or contact" "there are the sets: ALL, CLAMPED, SOLID, TIP")
expect_message(import_no_such_sectors FILE case.toml OLD "contact = " NEW "sector_count = 6\ncontact = " EXIT_CODE 2
               ERRORS "brick.inp: no face, turned by 360/6 degrees about the axis, is another one; is axis right")
set(named FILE case.toml OLD "contact = " EXIT_CODE 2)
expect_message(import_cuts_of_no_pitch ${named} NEW "cyclic_low = \"plane y -0.01\"\ncyclic_high = \"plane y 0.01\"\ncontact = "
               ERRORS "brick.inp: none of the 1 faces of \"plane y -0.01\", turned by 360/16 degrees, is among the 1 faces of \"plane y 0.01\"; the cuts are 22.6199 degrees apart, which is 360/15.9152; a sector needs 360/N")
expect_message(import_cuts_that_are_none ${named} NEW "cyclic_low = \"plane y -0.01\"\ncyclic_high = \"plane x 0.06\"\nsector_count = 12\ncontact = "
               ERRORS "turned by 360/12 degrees, is among the 1 faces of \"plane x 0.06\"; their centres differ in r or z; is each name that of a whole cut, and is axis right?")
expect_message(import_cuts_at_one_angle ${named} NEW "cyclic_low = \"plane x 0.04\"\ncyclic_high = \"plane x 0.04\"\ncontact = "
               ERRORS "brick.inp: [mesh] cyclic_low = \"plane x 0.04\" and cyclic_high = \"plane x 0.04\" select the same 1 face; name one cut of the sector by each")
# Symptom: the message spoke of a turn by 360/1000 degrees, which nobody had asked for.
expect_message(import_cuts_behind_each_other ${named} NEW "cyclic_low = \"plane x 0.04\"\ncyclic_high = \"plane x 0.06\"\ncontact = "
               ERRORS "brick.inp: none of the 1 faces of \"plane x 0.04\", turned about the axis, is among the 1 faces of \"plane x 0.06\"; their centres differ in r or z")
set(alone "warning: no face, turned about the axis, is another one, so that this is one body without neighbours; if it is a sector, mesh both cuts alike")
expect_message(import_of_one_body ERRORS "no cuts: one body" ${alone} "else set [mesh] sector_count = 1" WRITES sector.msh)
expect_message(import_of_a_disc_without_cuts FILE case.toml OLD "contact = " NEW "disc = \"solid\"\ncontact = " EXIT_CODE 2
               ERRORS "brick.inp: no face, turned about the axis, is another one, so that this is one body without neighbours")
expect_message(import_of_a_disc_that_is_whole FILE case.toml OLD "contact = " NEW "disc = \"solid\"\nsector_count = 1\ncontact = " ERRORS "no cuts: one body" WRITES sector.msh)
expect_message(import_says_what_is_selected ARGUMENTS case.toml --set "mesh.contact=" --set "mesh.blade_tip='plane x 0.06'" --check
               ERRORS "blade_tip: 1 face, r 0.06 to 0.0608276 m" "clamped: 1 face, r 0.04 to 0.0412311 m")
expect_message(import_tip_of_solids ARGUMENTS case.toml --import brick.bdf --set "mesh.clamped='SPC 1'" --set "mesh.contact=" --set "mesh.blade_tip='PID 3'"
               EXIT_CODE 2 ERRORS "brick.bdf: [mesh] blade_tip = \"PID 3\" is a set of solids, not of faces; name the set of the faces or of their nodes, or select them by cylinder, plane or normal")
expect_message(import_clamp_of_solids FILE case.toml OLD "clamped = \"clamped\"" NEW "clamped = \"solid\"" EXIT_CODE 2
               ERRORS "brick.inp: [mesh] clamped = \"SOLID\" is a set of solids, not of faces")
expect_message(import_tip_with_a_sharp_edge OLD "NSET=contact" NEW "NSET=tip" ARGUMENTS case.toml --set "mesh.contact=" --set "mesh.blade_tip='all'"
               EXIT_CODE 2 ERRORS "brick.inp: [mesh] blade_tip selects faces on both sides of a sharp edge, at x y z = 0.04 -0.01 -0.005 m; select the tip alone, without the flanks of the blade")
expect_message(import_of_corners_only OLD "type=C3D20R" NEW "type=C3D8" EXIT_CODE 2
               ERRORS "brick.inp:25: C3D8: elements that have corners only bend too stiffly; mesh again with quadratic ones")
expect_message(import_of_27_nodes OLD "type=C3D20R" NEW "type=C3D27" EXIT_CODE 2 ERRORS "brick.inp:25: elements of type C3D27 are not known; C3D10")
expect_message(import_without_a_node OLD "20, 40.0, 10.0, 0.0\n" NEW "" EXIT_CODE 2 ERRORS "brick.inp: element 7 names node 20, which isn't there")
expect_message(import_of_a_node_twice OLD "20, 40.0, 10.0, 0.0\n" NEW "20, 40.0, 10.0, 0.0\n20, 0, 0, 0\n" EXIT_CODE 2
               ERRORS "brick.inp:25: node 20 is there twice; does the file hold several parts? Write one")
expect_message(import_of_no_number OLD "20, 40.0, 10.0, 0.0\n" NEW "20, 40.0, inf, 0.0\n" EXIT_CODE 2
               ERRORS "brick.inp:24: \"inf\" stands for a coordinate, which must be a finite number")
expect_message(import_of_an_include OLD "*NSET, NSET=clamped" NEW "*INCLUDE, INPUT=other.inp\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:28: *INCLUDE leads to another file; give the file that holds the mesh")
expect_message(import_cut_off_inp OLD ",\n12, 13, 14, 15, 16, 17, 18, 19, 20" NEW ", 12" EXIT_CODE 2
               ERRORS "the last element of type C3D20R lacks nodes; is the file cut off?")
expect_message(import_in_another_unit FILE case.toml OLD "\"mm\"" NEW "\"m\"" EXIT_CODE 2
               ERRORS "[mesh] length_unit makes this a wheel of 60.8276 m radius, which is unusual: expected at most 5 [m]; is the file in another unit?" "add unusual = true to this table")
expect_message(import_in_metres FILE case.toml OLD "\"mm\"" NEW "\"m\"\nunusual = true" ERRORS "radius up to 60" WRITES sector.msh)
expect_message(import_of_a_node_far_away OLD "20, 40.0, 10.0, 0.0" NEW "20, 4e7, 10.0, 0.0" EXIT_CODE 2
               ERRORS "brick.inp: node 20 stands more than 1000 m from the origin; is length_unit right?")
expect_message(import_of_nothing OLD "*ELEMENT" NEW "*OTHER" EXIT_CODE 2 ERRORS "brick.inp: holds no quadratic solid elements; is it the file of the mesh?")
set(other --set "mesh.contact=''" --set "mesh.blade_tip='plane x 0.06'" --set "mesh.clamped='plane x 0.04'" --check)
set(bdf ARGUMENTS case.toml --import brick.bdf ${other} FILE brick.bdf EXIT_CODE 2)
expect_message(import_bdf_of_another_system ${bdf} OLD "GRID*                  1               0" NEW "GRID*                  1               2"
               ERRORS "brick.bdf:6: GRID gives places in coordinate system 2; write the file in the basic system, 0")
expect_message(import_bdf_of_corners_only ${bdf} OLD "+              7       8       9      10" NEW "+              7       8                " ERRORS "CHEXA without mid-side nodes: elements that have corners only")
set(cdb ARGUMENTS case.toml --import brick.cdb ${other} FILE brick.cdb EXIT_CODE 2)
expect_message(import_cdb_without_columns ${cdb} OLD "(19i9)" NEW "(free)" ERRORS "must be the columns of the block, as (3i9,6e21.13e3) or (19i10)")
expect_message(import_cdb_of_corners_only ${cdb} OLD "ET,1,186" NEW "ET,1,185" ERRORS "SOLID185: elements that have corners only")
expect_message(import_cdb_cut_off ${cdb} OLD "N,R5.3" NEW "" ERRORS "brick.cdb:")
set(unv ARGUMENTS case.toml --import brick.unv ${other} FILE brick.unv EXIT_CODE 2)
expect_message(import_unv_of_corners_only ${unv} OLD "         7       116" NEW "         7       115" ERRORS "descriptor 115: elements that have corners only")
expect_message(import_unv_of_few_nodes ${unv} OLD "         7       116" NEW "         7       118" ERRORS "an element of descriptor 118 has 20 nodes")
# Of gmsh's own format: each brick stands there twice, once for each of its groups, and the groups have the names of the keys.
set(msh ARGUMENTS case.toml --import brick.msh --set "mesh.clamped=" --set "mesh.contact=" --check FILE brick.msh)
expect_message(import_of_msh ${msh} ERRORS "20 nodes, 1 hex20" "no cuts: one body" "contact: 4 nodes")
# Symptom: the nodes of the whole tip became a line across it.
expect_message(import_tip_as_contact ARGUMENTS case.toml --import brick.msh --set "mesh.clamped=" --set "mesh.contact='blade_tip'" --check EXIT_CODE 2
               ERRORS "brick.msh: [mesh] contact has nodes side by side across the tip, at x y z = 0.06 " "; name nodes along one line of the tip, as its middle")
expect_message(import_msh_of_corners_only ${msh} OLD "1 17 2 1 1 1 2 3 4 5 6 7 8 9 12 17 10 18 11 19 20 13 16 14 15" NEW "1 5 2 1 1 1 2 3 4 5 6 7 8" EXIT_CODE 2
               ERRORS "brick.msh: volume group \"sector\": bricks that have corners only bend too stiffly; mesh again with Mesh.ElementOrder = 2")
expect_message(import_msh_of_faces_only ${msh} OLD "4\n1 17 2 1 1 1 2 3 4 5 6 7 8 9 12 17 10 18 11 19 20 13 16 14 15\n2 17 2 2 1 1 2 3 4 5 6 7 8 9 12 17 10 18 11 19 20 13 16 14 15\n" NEW "2\n" EXIT_CODE 2
               ERRORS "brick.msh: holds no cells; mesh in three dimensions (gmsh -3), and name the volume too")
expect_message(picture_of_a_mesh ARGUMENTS case.toml --check --picture mesh.svg ERRORS "drew mesh.svg" WRITES mesh.svg)
expect_message(picture_of_no_drawing ARGUMENTS case.toml --check --picture mesh.png EXIT_CODE 2 ERRORS "--picture mesh.png: must end in .svg")
# Symptom: the mesh that was imported was overwritten.
set(own INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/import.toml=case.toml ${bricks}/brick.msh EXIT_CODE 2)
set(own_sets --set "mesh.clamped=" --set "mesh.contact=")
expect_message(import_over_itself ${own} FILE case.toml OLD "brick.inp" NEW "brick.msh" ARGUMENTS case.toml -o ./brick.msh ${own_sets}
               ERRORS "./brick.msh: would be written over brick.msh, which this run reads or writes too; give it another name")
expect_message(import_over_the_option ${own} ARGUMENTS case.toml --import brick.msh -o brick.msh ${own_sets} ERRORS "brick.msh: would be written over ")
expect_message(import_under_its_picture ${own} INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/import.toml=case.toml ${bricks}/brick.msh=brick.svg
               ARGUMENTS case.toml --import brick.svg --picture brick.svg --set "mesh.mesh_format='msh'" ${own_sets} ERRORS "brick.svg: would be written over ")
# Symptom: gmsh takes its format from the ending, and the message asked whether the disk was full.
expect_message(import_into_another_format ARGUMENTS case.toml -o sector.unv EXIT_CODE 2 ERRORS "-o sector.unv: must end in .msh")
expect_message(import_of_an_apostrophe INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/import.toml=case.toml ${bricks}/brick.msh=f'x.msh
               ARGUMENTS case.toml --import f'x.msh ${own_sets} --check ERRORS "f'x.msh: 20 nodes, 1 hex20")
# Symptom: each of these was passed over without a word, and the mesh was another one than the file's.
expect_message(import_bdf_of_large_free_fields ARGUMENTS case.toml --import brick.bdf ${other} FILE brick.bdf
               OLD "GRID*                  5               0 4.000000000E+01-1.000000000E+01\n*        5.000000000E+00" NEW "GRID*,5,,40.0,-10.0,*A\n*A,20.0"
               ERRORS "z from -0.005 to 0.02 m")
set(instance OLD "*NSET, NSET=clamped")
expect_message(import_of_an_instance_in_place ${instance} NEW "*INSTANCE, NAME=a, PART=p\n0., 0., 0.\n0., 0., 0., 0., 0., 1., 0.\n*NSET, NSET=clamped" WRITES sector.msh)
expect_message(import_of_an_instance_shifted ${instance} NEW "*INSTANCE, NAME=a, PART=p\n0., 0., 0.5\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:29: *INSTANCE shifts or turns its part, which is read where *NODE has it; write the part in its place in the wheel")
expect_message(import_of_an_instance_turned ${instance} NEW "*INSTANCE, NAME=a, PART=p\n0., 0., 0.\n0., 0., 0., 0., 0., 1., 30.\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:30: *INSTANCE shifts or turns its part")
expect_message(import_of_cylindrical_nodes OLD "*Node, nset=all" NEW "*Node, nset=all, system=c" EXIT_CODE 2
               ERRORS "brick.inp:4: *NODE, SYSTEM=C gives coordinates in another system; write them as global x, y, z")
expect_message(import_of_a_system OLD "*Node, nset=all" NEW "*SYSTEM\n0., 0., 1.\n*Node, nset=all" EXIT_CODE 2
               ERRORS "brick.inp:5: *SYSTEM gives coordinates in another system")
expect_message(import_nodes_of_elements ${instance} NEW "*NSET, NSET=whole, ELSET=solid\n*NSET, NSET=clamped" ARGUMENTS case.toml --set "mesh.clamped='whole'" --check
               ERRORS "clamped: 6 faces")
expect_message(import_nodes_of_no_elements ${instance} NEW "*NSET, NSET=whole, ELSET=none\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:28: \"NONE\" must be a set of elements that stands before")
expect_message(import_cdb_with_a_block_of_types ARGUMENTS case.toml --import brick.cdb ${other} FILE brick.cdb OLD "ET,1,186\nET,2,SOLID187"
               NEW "ETBLOCK,        2,        2\n(2i9,19a9)\n        1      186        0\n        2      187\n       -1" ERRORS "20 nodes, 1 hex20")
expect_message(import_cdb_with_half_a_type ${cdb} OLD "ET,1,186" NEW "ETBLOCK,1,1\n(2i9,19a9)\n        1" ERRORS "an element type has a number and Ansys' number")
# Symptom: the mesh lacked what these statements bring, without a word.
foreach(rule NGEN NFILL NCOPY NMAP ELGEN ELCOPY)
  expect_message(import_of_a_${rule} ${instance} NEW "*${rule}\n7, 2, 1, 1\n*NSET, NSET=clamped" EXIT_CODE 2
                 ERRORS "brick.inp:28: *${rule} makes, moves or removes nodes or elements by a rule that isn't followed here; write all nodes and elements out")
endforeach()
expect_message(import_of_an_element_file ${instance} NEW "*ELEMENT, TYPE=C3D20, INPUT=more.inp\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:28: *ELEMENT leads to another file; give the file that holds the mesh, or put both into one")
expect_message(import_bdf_of_an_include ${bdf} OLD "$ made by a test" NEW "include 'blade.bdf'" ERRORS "brick.bdf:5: INCLUDE leads to another file")
expect_message(import_bdf_of_a_default_system ${bdf} OLD "$ made by a test" NEW "GRDSET,,16" ERRORS "brick.bdf:5: GRDSET gives places in coordinate system 16; write the file in the basic system, 0")
expect_message(import_bdf_of_a_superelement ${bdf} OLD "SPC1,1,123,16" NEW "BEGIN SUPER=2\nSPC1,1,123,16" ERRORS "BEGIN SUPER=2 begins a part of its own; write the model as one part, after BEGIN BULK")
expect_message(import_bdf_of_repeated_entries ${bdf} OLD "SPC1,1,123,16" NEW "=,*1,==\nSPC1,1,123,16" ERRORS "= makes, moves or removes nodes or elements by a rule")
expect_message(import_cdb_of_copied_elements ${cdb} OLD "FINISH" NEW "EGEN,2,100,ALL\nFINISH" ERRORS "EGEN makes, moves or removes nodes or elements by a rule")
expect_message(import_cdb_of_another_file ${cdb} OLD "FINISH" NEW "/INPUT,blade,cdb\nFINISH" ERRORS "/INPUT leads to another file")
expect_message(import_cdb_of_another_system ${cdb} OLD "ET,2,SOLID187" NEW "CSYS,1" ERRORS "brick.cdb:4: NBLOCK gives places in coordinate system 1; write them in the global one (CSYS,0)")
expect_message(import_cdb_of_a_listed_system ARGUMENTS case.toml --import brick.cdb ${other} FILE brick.cdb OLD "ET,2,SOLID187"
               NEW "LOCAL,R5.0,LOC, 11, 1, 0.0, 0.0, 0.0\nCSYS,1\nCSYS,0" ERRORS "20 nodes, 1 hex20")
# Symptom: names in other letters were other sets, so that a clamped surface lost half of its nodes.
set(clamped_nodes OLD "NSET=clamped\n1, 4, 8, 5, 12, 20, 16, 17,")
expect_message(import_of_names_in_any_case ${clamped_nodes} NEW "NSET=Bore\n1, 4,\n  *Nset, Nset=BORE\n8, 5,\n*NSET, NSET=Held\nbore,"
               ARGUMENTS case.toml --set "mesh.clamped='held'" --check ERRORS "clamped: 1 face, r 0.04")
expect_message(import_of_quoted_names ${clamped_nodes} NEW "NSET=\"Bore\"\n1, 4, 8, 5,\n*NSET, NSET=BORE\n2, 3"
               ARGUMENTS case.toml --set "mesh.clamped='Bore'" --check ERRORS "clamped: 1 face, r 0.04")
# Symptom: the nodes of a surface were added to the set of nodes of its name.
expect_message(import_of_a_surface_and_a_set ${instance} NEW "*SURFACE, NAME=ALL\nSOLID, S6\n*NSET, NSET=clamped"
               ARGUMENTS case.toml --set "mesh.clamped='all'" --check ERRORS "clamped: 1 face, r 0.04")
# Symptom: of two parts with the same elements only the second was written.
expect_message(import_of_parts_that_overlap FILE case.toml OLD "contact = " NEW "disc = \"solid\"\nmain_blade = \"Solid\"\nsector_count = 1\ncontact = " EXIT_CODE 2
               ERRORS "brick.inp: [mesh] disc = \"SOLID\" and main_blade = \"SOLID\" have 1 element in common; each belongs to one part")
# Symptom: elements that fill a volume were passed over, and the wheel lacked it.
foreach(type SC8R CSS8 COH3D8 DC3D8 AC3D8 F3D8 Q3D8 U1)
  expect_message(import_of_${type} ${instance} NEW "*ELEMENT, TYPE=${type}\n8, 1, 2, 3, 4, 5, 6, 7, 8\n*NSET, NSET=clamped" EXIT_CODE 2
                 ERRORS "brick.inp:28: elements of type ${type} are not known; C3D10, C3D15 and C3D20 (also C3D10M, C3D20R) are, and shells and beams are left out; mesh every volume with these solids, or delete the elements")
endforeach()
expect_message(import_without_a_type OLD "type=C3D20R, " NEW "" EXIT_CODE 2 ERRORS "brick.inp:25: elements without a TYPE are not known")
foreach(type S8R STRI65 DS8 M3D8 SFM3D8 CPS8 CPE8 CAX8 B32 T3D3 R3D4)
  expect_message(import_with_a_skin_of_${type} ${instance} NEW "*ELEMENT, TYPE=${type}, ELSET=skin\n8, 1, 4, 8, 5, 12, 20, 16, 17\n*NSET, NSET=clamped"
                 ARGUMENTS case.toml --set "mesh.clamped='skin'" --check ERRORS "clamped: 1 face")
endforeach()
expect_message(import_of_removed_elements ${instance} NEW "*MODEL CHANGE, TYPE=ELEMENT, REMOVE\n7\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:28: *MODEL CHANGE makes, moves or removes nodes or elements by a rule that isn't followed here")
expect_message(import_of_imperfections ${instance} NEW "*IMPERFECTION, FILE=modes, STEP=1\n1, 0.001\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:28: *IMPERFECTION makes, moves or removes nodes or elements by a rule")
foreach(card CHEX20 CHEXA1 CPYRA CIHEX2 CWEDGE)
  expect_message(import_bdf_of_${card} ARGUMENTS case.toml --import brick.bdf ${other} FILE brick.bdf OLD "SPC1,1,123,16" EXIT_CODE 2
                 NEW "${card},9,3,1,2,3,4,5,6,+\n+,7,8\nSPC1,1,123,16" ERRORS ": ${card} is not known; CTETRA, CPYRAM, CPENTA and CHEXA are; mesh every volume with these solids, or delete the element")
endforeach()
foreach(type 90 190 226)
  expect_message(import_cdb_of_type_${type} ARGUMENTS case.toml --import brick.cdb ${other} FILE brick.cdb OLD "       -1\nCMBLOCK,CLAMPED" EXIT_CODE 2
                 NEW "        1      ${type}        1        1        0        0        0        0        4        0        8        2        3        4        5\n       -1\nCMBLOCK,CLAMPED"
                 ERRORS ": an element of Ansys' type ${type} with 4 nodes is not known; SOLID186 (or 95) with 20 nodes and SOLID187 (or 92) with 10 are; mesh every volume")
endforeach()
foreach(type 101 105 114 117)
  expect_message(import_unv_of_descriptor_${type} ARGUMENTS case.toml --import brick.unv ${other} FILE brick.unv OLD "    -1\n    -1\n  2467" EXIT_CODE 2
                 NEW "         8       ${type}         1         1         7         4\n         5         6         7         8\n    -1\n    -1\n  2467" ERRORS ": an element of descriptor ${type} is not known; 118, 113 and 116 are; mesh every volume")
endforeach()
expect_message(import_of_a_removed_contact ${instance} NEW "*MODEL CHANGE, TYPE=CONTACT PAIR, REMOVE\na, b\n*NSET, NSET=clamped" WRITES sector.msh)
expect_message(import_of_a_part_twice ${instance} NEW "*INSTANCE, NAME=a, PART=p\n*END INSTANCE\n*INSTANCE, NAME=b, PART=P\n*NSET, NSET=clamped" EXIT_CODE 2
               ERRORS "brick.inp:30: *INSTANCE places the part P again, which is read once; write the wheel as one part")
foreach(reader NREAD EREAD UPGEOM)
  expect_message(import_cdb_of_${reader} ${cdb} OLD "FINISH" NEW "${reader},1,1,1,blade,rst\nFINISH" ERRORS "${reader} leads to another file")
endforeach()
# Symptom: masses and constraints were passed over without a word.
set(lacks "; the sector lacks them")
expect_message(import_with_masses ${instance} NEW "*ELEMENT, TYPE=MASS, ELSET=masses\n8, 2\n9, 3\n*MASS, ELSET=masses\n0.5\n*EQUATION\n2\n1, 1, 1., 2, 1, -1.\n*TIE, NAME=t\na, b\n*TIE, CYCLIC SYMMETRY, NAME=c\na, b\n*NSET, NSET=clamped"
               ERRORS "warning: not read: 1 *EQUATION, 1 *TIE, 2 MASS${lacks}" WRITES sector.msh)
expect_message(import_bdf_with_masses ARGUMENTS case.toml --import brick.bdf ${other} FILE brick.bdf OLD "SPC1,1,123,16" NEW "CONM2,9,2,0,0.5\nRBE2,10,2,123,3,6\nRBE2*,11,3,123,+\n*,7\nSPC1,1,123,16"
               ERRORS "warning: not read: 1 CONM2, 2 RBE2${lacks}")
expect_message(import_cdb_with_constraints ARGUMENTS case.toml --import brick.cdb ${other} FILE brick.cdb OLD "FINISH"
               NEW "CP,1,UX,3,4\nCE,R5.0,DEFI,       2,       1,  0.0\nCE,R5.0,NODE,       3,UX  ,  1.0\nCE,7,0,3,UX,1,5,UX,-1\nCE,7,0,6,UX,1\nFINISH"
               ERRORS "warning: not read: 2 CE, 1 CP${lacks}")
expect_message(import_cdb_with_a_mass ARGUMENTS case.toml --import brick.cdb ${other} FILE brick.cdb OLD "       -1\nCMBLOCK,CLAMPED"
               NEW "        1       21        1        1        0        0        0        0        1        0        8        2\n       -1\nCMBLOCK,CLAMPED" ERRORS "warning: not read: 1 MASS21${lacks}")
expect_message(import_unv_with_a_mass ARGUMENTS case.toml --import brick.unv ${other} FILE brick.unv OLD "    -1\n    -1\n  2467"
               NEW "         8       161         1         1         7         1\n         5\n    -1\n    -1\n  2467" ERRORS "warning: not read: 1 of descriptor 161${lacks}")
set(materials "warning: 2 materials; tiprub-reduce takes the material of the case")
expect_message(import_of_two_materials OLD "*MATERIAL, NAME=metal" NEW "*SOLID SECTION, ELSET=solid, MATERIAL=metal\n*SOLID SECTION, ELSET=other, MATERIAL=foam\n*MATERIAL, NAME=metal"
               ERRORS ${materials} WRITES sector.msh)
expect_message(import_bdf_of_two_materials ARGUMENTS case.toml --import brick.bdf ${other} FILE brick.bdf OLD "SPC1,1,123,16" NEW "PSOLID,3,1\nPSOLID,4,2\nPSOLID,5,2\nSPC1,1,123,16" ERRORS ${materials})
# Symptom: a keyword that goes on in the next line lost its name.
expect_message(import_of_a_long_keyword OLD "*NSET, NSET=clamped" NEW "*NSET,\n  NSET=clamped" WRITES sector.msh)
expect_message(import_of_a_keyword_with_a_comma OLD "NSET=clamped" NEW "NSET=clamped," WRITES sector.msh)
# Symptom: sets of the case control that are of no use here made the file unreadable.
set(set_7 ARGUMENTS case.toml --import brick.bdf --set "mesh.clamped='SPC 1'" --set "mesh.contact='SET 7'" --check FILE brick.bdf OLD "SET 7 = 2, 6, 18")
expect_message(import_bdf_of_a_set_with_exceptions ${set_7} NEW "SET 7 = 2 THRU 6 EXCEPT 3, 4,\n5, 18" ERRORS "contact: 3 nodes")
expect_message(import_bdf_of_an_exception_alone ${set_7} NEW "SET 7 = 2 EXCEPT 3" EXIT_CODE 2 ERRORS "brick.bdf:3: EXCEPT stands after a range, first THRU last")
foreach(words "ALL EXCEPT 5" "0.1, 0.2" "ACCE, DISP/1")
  string(MAKE_C_IDENTIFIER "${words}" name)
  expect_message(import_bdf_of_a_set_of_${name} ARGUMENTS case.toml --import brick.bdf ${other} FILE brick.bdf OLD "SET 7 = 2, 6, 18" NEW "SET 7 = ${words}" ERRORS "20 nodes, 1 hex20")
  expect_message(import_bdf_by_a_set_of_${name} ${set_7} NEW "SET 7 = ${words}" EXIT_CODE 2
                 ERRORS "brick.bdf: [mesh] contact = \"SET 7\": there is no set of this name with nodes of solids; there are: PID 3, SPC 1")
endforeach()
