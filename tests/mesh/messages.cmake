# SPDX-License-Identifier: GPL-3.0-or-later
# What the mesher says, case by case.
set(message_room mesh)
set(impeller INPUTS ${PROJECT_SOURCE_DIR}/cases/fast_impeller/case.toml)
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-mesh> ARGUMENTS case.toml -o sector.msh ${impeller})

expect_message(works ERRORS "wrote sector.msh" WRITES sector.msh)
expect_message(plate_works INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/annular_plate.toml=case.toml
               ERRORS "wrote sector.msh" WRITES sector.msh)
expect_message(bladed_disc_works INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/bladed_disc.toml=case.toml
               ERRORS "wrote sector.msh" WRITES sector.msh)
expect_message(check_writes_nothing ARGUMENTS case.toml --check ERRORS "worst scaled Jacobian")
expect_message(unknown_key KEY clamped LINE "clampd = \"bore\"" EXIT_CODE 2
               ERRORS "unknown key \"clampd\" in [mesh]")
expect_message(no_table INPUTS ${CMAKE_CURRENT_SOURCE_DIR}/annular_plate.toml=case.toml OLD "[mesh]" NEW "[reduce]" EXIT_CODE 2
               ERRORS "case.toml: has no [mesh] table; add it, or name your own mesh for tiprub-reduce by MESH := wheel.msh, or your own model by MODEL := wheel.h5")
expect_message(negative_radius KEY exit_radius LINE "exit_radius = -0.1" EXIT_CODE 2
               ERRORS "exit_radius = -0.1 must be more than 0 and at most 10 [m]")
expect_message(radius_in_millimetres KEY exit_radius LINE "exit_radius = 122" EXIT_CODE 2
               ERRORS "exit_radius = 122 must be more than 0 and at most 10 [m]")
expect_message(missing_key KEY exit_radius LINE "" EXIT_CODE 2
               ERRORS "[mesh] has no exit_radius, and it has no default; add it")
expect_message(wrong_family KEY family LINE "family = \"fan\"" EXIT_CODE 2 ERRORS "must be one of: impeller, bladed_disc, blade_file")
expect_message(bore_too_large KEY bore_radius LINE "bore_radius = 0.04" EXIT_CODE 2
               ERRORS "must be less than inlet_hub_radius")
expect_message(crossing_thickness KEY thickness_root LINE "thickness_root = [[0.0, 0.02]]" EXIT_CODE 2
               ERRORS "thickness_root makes blades cross: at 0 of the meridional length")
expect_message(filleted_works KEY splitter_start LINE "splitter_start = 0.45\nfillet_radius = 0.001\ngrading_along_chord = 3.0"
               ERRORS "2 of them along the fillet" "wrote sector.msh" WRITES sector.msh)
expect_message(fillet_closes_the_passage KEY splitter_start LINE "splitter_start = 0.45\nfillet_radius = 0.004" EXIT_CODE 2
               ERRORS "fillet_radius makes blades cross: at")
expect_message(reversed_grading KEY splitter_start LINE "splitter_start = 0.45\ngrading_along_span = 0.5" EXIT_CODE 2
               ERRORS "grading_along_span = 0.5 must be at least 1 and at most 100")
expect_message(contact_on_both KEY splitter_start LINE "splitter_start = 0.45\ncontact_blades = \"both\""
               ERRORS "contact nodes and " " on the splitter" "wrote sector.msh" WRITES sector.msh)
expect_message(contact_on_no_splitter KEY splitter_start LINE "splitter = false\ncontact_blades = \"both\"" EXIT_CODE 2
               ERRORS "contact_blades = \"both\" asks for contact on splitters, and this wheel has none; take \"main\"")
expect_message(contact_on_other_blades KEY splitter_start LINE "splitter_start = 0.45\ncontact_blades = \"all\"" EXIT_CODE 2
               ERRORS "contact_blades = \"all\" must be one of: main, both")
expect_message(odd_passage KEY elements_between_blades LINE "elements_between_blades = 3" EXIT_CODE 2 ERRORS "must be even")
expect_message(inverted_element KEY back_profile LINE "back_profile = [[0.028, 0.092], [0.09, 0.04], [0.122, 0.0705]]"
               EXIT_CODE 2 ERRORS "inverted element in the disc, at" "look at [mesh] back_profile")
expect_message(two_runs_on_one_output PROGRAM flock .sector.msh.lock $<TARGET_FILE:tiprub-mesh> EXIT_CODE 1
               ERRORS "sector.msh: another process is writing it; wait for that, or give another -o" WRITES .sector.msh.lock)
expect_message(no_folder ARGUMENTS -q case.toml -o no_such_folder/sector.msh EXIT_CODE 1 ERRORS "can't be written: no folder")
expect_message(another_format ARGUMENTS case.toml -o sector.inp EXIT_CODE 2 ERRORS "-o sector.inp: must end in .msh")
