# SPDX-License-Identifier: GPL-3.0-or-later
# What the post-processor says, case by case, on a made scene.
set(message_room postprocess)
set(made ${CMAKE_CURRENT_BINARY_DIR}/message_inputs)
add_test(NAME postprocess.inputs_of_messages COMMAND write-synthetic-scene ${made})
set_tests_properties(postprocess.inputs_of_messages PROPERTIES FIXTURES_SETUP postprocess_message_inputs)
set(message_fixtures postprocess_message_inputs)
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-postprocess> ARGUMENTS case.toml model.h5 response.h5 -o report
                     INPUTS ${made}/case.toml ${made}/model.h5 ${made}/response.h5)

expect_message(unknown_key KEY families LINE "colour = 3" EXIT_CODE 2 ERRORS "case.toml:4:1: unknown key \"colour\"")
expect_message(value_out_of_range KEY families LINE "families = 0" EXIT_CODE 2 ERRORS "families = 0 must be")
expect_message(map_without_colours KEY families LINE "amplitude_max_mm = 1e-300" EXIT_CODE 2
               ERRORS "[postprocess] amplitude_max_mm = 1e-300 must be at least 1e-06 mm, or 0")
expect_message(operating_range_upside_down KEY families LINE "operating_min_rpm = 9000" EXIT_CODE 2
               ERRORS "operating_max_rpm must be at least operating_min_rpm")
expect_message(no_table OLD "[postprocess]\nfamilies = 2" NEW "" EXIT_CODE 2
               ERRORS "case.toml: has no [postprocess] table; add it"
               ARGUMENTS case.toml absent.h5 absent.h5 -o report --check)
expect_message(no_case ARGUMENTS nowhere.toml model.h5 response.h5 -o report EXIT_CODE 1
               ERRORS "nowhere.toml: can't be read")
expect_message(no_response ARGUMENTS case.toml model.h5 nowhere.h5 -o report EXIT_CODE 1 ERRORS "nowhere.h5")
expect_message(no_fields ARGUMENTS case.toml model.h5 response.h5 --fields none.h5 -o report EXIT_CODE 1
               ERRORS "none.h5: no such file")
expect_message(budget_fields_without_a_budget INPUTS ${made}/case.toml ${made}/model.h5 ${made}/response.h5 ${made}/fields.h5
               ARGUMENTS case.toml model.h5 response.h5 --fields fields.h5 --budget-fields fields.h5 --check -o report
               OUTPUTS "wear of the casing")
expect_message(budget_fields_alone ARGUMENTS case.toml model.h5 response.h5 --budget-fields fields.h5 -o report EXIT_CODE 2
               ERRORS "--budget-fields requires --fields")
expect_message(no_times ARGUMENTS case.toml model.h5 response.h5 --runs none.csv -o report EXIT_CODE 1
               ERRORS "none.csv: can't be read")
expect_message(times_of_something_else ARGUMENTS case.toml model.h5 response.h5 --runs case.toml -o report EXIT_CODE 2
               ERRORS "case.toml: ")
expect_message(files_exchanged ARGUMENTS case.toml response.h5 model.h5 -o report EXIT_CODE 2 ERRORS "response.h5")
expect_message(model_for_fields ARGUMENTS case.toml model.h5 response.h5 --fields model.h5 -o report EXIT_CODE 2
               ERRORS "expected tiprub-fields version 2")
expect_message(model_of_another_rotor INPUTS ${made}/case.toml ${made}/nine_sectors_model.h5=model.h5 ${made}/response.h5
               EXIT_CODE 2 ERRORS "has 10 sectors, the model has 9")
expect_message(not_finite INPUTS ${made}/case.toml ${made}/model.h5 ${made}/nan_response.h5=response.h5 EXIT_CODE 2
               ERRORS "response.h5")
expect_message(motion_beyond_all_measure EXIT_CODE 1
               INPUTS ${made}/case.toml ${made}/model.h5 ${made}/huge_response.h5=response.h5
               ERRORS "response.h5: at 14324 rpm the displacement reaches 1e+300, beyond all measure")
expect_message(states_of_another_model EXIT_CODE 2
               INPUTS ${made}/case.toml ${made}/model.h5 ${made}/other_dofs_response.h5=response.h5
               ERRORS "response.h5: at 14324 rpm the states of nodal diameter 2 have 5 dofs, the model has 16; give the model")
expect_message(only_failures INPUTS ${made}/case.toml ${made}/model.h5 ${made}/failed_response.h5=response.h5 EXIT_CODE 1
               ERRORS "it blew up")
expect_message(no_frequencies INPUTS ${made}/case.toml ${made}/model.h5 ${made}/bare_response.h5=response.h5 EXIT_CODE 2
               ERRORS "response.h5: /frequencies/speed must hold at least 4 speeds")
expect_message(no_gnuplot PROGRAM /usr/bin/env PATH=/nowhere $<TARGET_FILE:tiprub-postprocess> EXIT_CODE 1
               ERRORS "install it (Debian: gnuplot-nox)")

expect_message(full_stdout EXIT_CODE 1 ERRORS "stdout: can't be written to its end"
               PROGRAM sh -c "exec $<TARGET_FILE:tiprub-postprocess> \"$@\" > /dev/full" sh
               ARGUMENTS case.toml model.h5 response.h5 -o report --check)

set(other_fields INPUTS ${made}/case.toml ${made}/model.h5 ${made}/response.h5 ${made}/one_sector_fields.h5=fields.h5)
expect_message(fields_of_another_rotor ${other_fields} EXIT_CODE 2 ERRORS "fields.h5: has 1 sectors, the model has 10"
               ARGUMENTS case.toml model.h5 response.h5 --fields fields.h5 -o report)
expect_message(check_of_fields_of_another_rotor ${other_fields} EXIT_CODE 2
               ERRORS "give the fields that were written with the model"
               ARGUMENTS case.toml model.h5 response.h5 --fields fields.h5 --check -o report)
foreach(wrong incompressible flat huge)
  set(${wrong}_fields INPUTS ${made}/case.toml ${made}/model.h5 ${made}/response.h5 ${made}/${wrong}_fields.h5=fields.h5
                      ARGUMENTS case.toml model.h5 response.h5 --fields fields.h5 -o report)
endforeach()
expect_message(incompressible_material ${incompressible_fields} --check EXIT_CODE 2
               ERRORS "fields.h5: / poisson_ratio must be above -1 and below 0.5")
expect_message(cell_without_volume ${flat_fields} EXIT_CODE 2
               ERRORS "fields.h5: /cells: cell 1 is flat or turned inside out; it has no stress")
expect_message(check_of_a_cell_without_volume ${flat_fields} --check EXIT_CODE 2 ERRORS "fields.h5: /cells: cell 1 is flat")
expect_message(stress_beyond_all_measure ${huge_fields} EXIT_CODE 1
               ERRORS "fields.h5: the stress of nodal diameter 0 is beyond 1e+100 Pa or no number")
expect_message(check_tells_what_the_scene_needs OUTPUTS "gap: a round casing is nearer" "not estimated"
               ARGUMENTS case.toml model.h5 response.h5 -o report --check)

expect_message(strengths_exchanged EXIT_CODE 2 ERRORS "[material] endurance_limit must be below ultimate_strength"
               ARGUMENTS case.toml model.h5 response.h5 -o report --set material.ultimate_strength=5e8
                         --set material.endurance_limit=9e8)
expect_message(yield_above_ultimate EXIT_CODE 2 ERRORS "[material] yield_strength must not exceed ultimate_strength"
               ARGUMENTS case.toml model.h5 response.h5 -o report --set material.ultimate_strength=9e8
                         --set material.endurance_limit=5e8 --set material.yield_strength=20e8)
expect_message(material_without_a_limit EXIT_CODE 2 ERRORS "[material] has no endurance_limit"
               ARGUMENTS case.toml model.h5 response.h5 -o report --set material.ultimate_strength=9e8)
expect_message(unknown_strength EXIT_CODE 2 ERRORS "known: ultimate_strength, endurance_limit, yield_strength"
               ARGUMENTS case.toml model.h5 response.h5 -o report --set material.ultimate_strength=9e8
                         --set material.endurance_limit=5e8 --set material.hardness=3)
expect_message(tip_patch_as_large_as_the_wheel EXIT_CODE 2 ERRORS "lower [postprocess] tip_patch_mm"
               INPUTS ${made}/case.toml ${made}/model.h5 ${made}/response.h5 ${made}/fields.h5
               ARGUMENTS case.toml model.h5 response.h5 --fields fields.h5 -o report --set postprocess.tip_patch_mm=1000)
