# SPDX-License-Identifier: GPL-3.0-or-later
# What the simulation says, case by case, on a small wheel.
set(message_room simulate)
set(made ${CMAKE_CURRENT_BINARY_DIR}/message_inputs)
add_test(NAME simulate.inputs_of_messages
         COMMAND ${TIPRUB_PYTHON} -B ${CMAKE_CURRENT_SOURCE_DIR}/inputs_of_messages.py ${made})
set_tests_properties(simulate.inputs_of_messages PROPERTIES FIXTURES_SETUP simulate_message_inputs)
set(message_fixtures simulate_message_inputs)
set(message_defaults PROGRAM $<TARGET_FILE:tiprub-simulate> ARGUMENTS case.toml model.h5 -o response.h5
                     INPUTS ${made}/case.toml ${made}/model.h5)

expect_message(no_case ARGUMENTS absent.toml model.h5 -o response.h5 EXIT_CODE 1 ERRORS "absent.toml: can't be read")
expect_message(no_model ARGUMENTS case.toml absent.h5 -o response.h5 EXIT_CODE 1 ERRORS "absent.h5: no such file")
expect_message(no_folder ARGUMENTS case.toml model.h5 -o absent/response.h5 EXIT_CODE 1
               ERRORS "can't be written: no folder")

expect_message(unknown_key OLD "lobes = 2" NEW "lobs = 2" EXIT_CODE 2
               ERRORS "case.toml:4:1: unknown key \"lobs\" in [casing] (did you mean lobes?); known: shape, lobes")
expect_message(unknown_key_of_its_own OLD "damping_ratio" NEW "damping" EXIT_CODE 2
               ERRORS "unknown key \"damping\" in [simulate]; known: ")
expect_message(negative_clearance OLD "1.2e-4" NEW "-1.2e-4" EXIT_CODE 2
               ERRORS "case.toml:6:35: [casing] clearance = -0.00012 must be at least 0 [fraction of the chord, m]")
expect_message(clearance_outside_the_chord OLD "[1.0, 1.2" NEW "[1.1, 1.2" EXIT_CODE 2
               ERRORS "must have its fractions of the arc length in 0 .. 1")
expect_message(negative_friction OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = -0.1" EXIT_CODE 2
               ERRORS "case.toml:5:24: [casing] friction_coefficient = -0.1 must be at least 0")
expect_message(friction_that_is_no_number OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = nan" EXIT_CODE 2
               ERRORS "case.toml:5:24: [casing] friction_coefficient")
expect_message(friction_that_jams OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = 1e9\nunusual = true" EXIT_CODE 2
               ERRORS "case.toml:5:24: [casing] friction_coefficient = 1e+09 is too large: from a friction coefficient of "
                      "on, contact node " "friction pushes it into the casing; lower it")
expect_message(friction_beyond_the_chord OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = [[0.0, 0.1], [1.2, 0.1]]" EXIT_CODE 2
               ERRORS "case.toml:5:43: [casing] friction_coefficient must have its fractions of the arc length in 0 .. 1")
expect_message(negative_friction_over_the_chord OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = [[0.0, 0.1], [1.0, -0.1]]"
               EXIT_CODE 2
               ERRORS "case.toml:5:43: [casing] friction_coefficient = -0.1 must be at least 0 [fraction of the chord, of the contact force]")
expect_message(friction_over_the_chord_that_is_no_number OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = [[0.0, nan]]" EXIT_CODE 2
               ERRORS "case.toml:5:31: [casing] friction_coefficient = nan must be a finite number")
expect_message(friction_that_jams_at_a_node OLD "lobes = 2"
               NEW "lobes = 2\nfriction_coefficient = [[0.0, 0.0], [1.0, 1e9]]\nunusual = true" EXIT_CODE 2
               ERRORS "case.toml:5:24: [casing] friction_coefficient = " "is too large: from a friction coefficient of ")
expect_message(friction_in_percent OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = 15" EXIT_CODE 2
               ERRORS "friction_coefficient = 15 is unusual: expected at least 0 and at most 1 [of the contact force]")
expect_message(friction_that_pulls OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = 0.01" EXIT_CODE 2
               ARGUMENTS case.toml model.h5 -o response.h5 --set "simulate.contact=\"paper\""
                         --set "simulate.scheme=\"central_differences\""
               ERRORS "needs forces that only push; set [simulate] contact = \"complementarity\"")
expect_message(gap_that_the_model_lacks OLD "damping_ratio" NEW "gap = \"second_order\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] gap = \"second_order\" needs /contact/second_order in the model" "reduce the sector again")
expect_message(gap_of_third_order OLD "damping_ratio" NEW "gap = \"third_order\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "case.toml:11:7: [simulate] gap = \"third_order\" must be one of: automatic, linear, second_order")
expect_message(physics_without_budget OLD "damping_ratio" NEW "physics = \"as_needed\"\nbudget = \"none\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "case.toml:11:11: [simulate] physics = \"as_needed\" decides by error budgets; set budget = \"critical_speeds\" or \"largest\"")
expect_message(physics_without_examination OLD "damping_ratio" NEW "physics = \"as_needed\"\nexamine = \"none\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] physics = \"as_needed\" decides by critical speeds; set examine = \"critical_speeds\", or leave physics out")
expect_message(physics_of_a_sweep_upwards OLD "damping_ratio" NEW "physics = \"as_needed\"\nsweep = \"up\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "only a sweep from rest examines; set sweep = \"rest\"")
expect_message(physics_that_pulls OLD "damping_ratio" EXIT_CODE 2
               NEW "physics = \"as_needed\"\ncontact = \"paper\"\nscheme = \"central_differences\"\ndamping_ratio"
               ERRORS "[simulate] physics = \"as_needed\" needs forces that only push; set contact = \"complementarity\"")
expect_message(physics_with_nothing_to_decide OLD "lobes = 2" NEW "lobes = 2\nfriction_coefficient = 0" EXIT_CODE 2
               ARGUMENTS case.toml model.h5 -o response.h5 --set "simulate.physics=\"as_needed\""
               ERRORS "[simulate] physics = \"as_needed\" finds nothing to decide: the case gives friction_coefficient, and gap or a model"
                      "leave one of these keys out, or physics")
expect_message(physics_by_chance OLD "damping_ratio" NEW "physics = \"as_liked\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] physics = \"as_liked\" must be one of: as_given, as_needed")
expect_message(other_model_that_is_absent OLD "damping_ratio" EXIT_CODE 1
               NEW "budget = \"largest\"\nbudget_model = \"absent.h5\"\ndamping_ratio" ERRORS "absent.h5: no such file")
expect_message(other_model_of_another_wheel OLD "damping_ratio" EXIT_CODE 2
               NEW "budget = \"largest\"\nbudget_model = \"seven.h5\"\ndamping_ratio"
               INPUTS ${made}/case.toml ${made}/model.h5 ${made}/seven.h5
               ERRORS "case.toml:12:16: [simulate] budget_model is of 7 sectors, and the model of 6; name another model of the same wheel")
expect_message(other_model_of_lower_speeds OLD "damping_ratio" EXIT_CODE 2
               NEW "budget = \"largest\"\nbudget_model = \"slow.h5\"\ndamping_ratio"
               INPUTS ${made}/case.toml ${made}/model.h5 ${made}/slow.h5
               ERRORS "[simulate] budget_model holds up to 9549.3 rev/min, and the speeds go to 12000; reduce it with a higher speed_max_rpm")
expect_message(other_model_without_a_budget OLD "damping_ratio" NEW "budget_model = \"model.h5\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] budget_model belongs to budget = \"critical_speeds\" or \"largest\"")
expect_message(amplitude_in_millimetres OLD "amplitude = 2.0e-4" NEW "amplitude = 0.2" EXIT_CODE 2
               ERRORS "case.toml:5:13: [casing] amplitude has 0.2 m, more than a fiftieth of the tip's radius of "
                      "it is in metres, not in millimetres")
expect_message(clearance_in_millimetres OLD "1.2e-4" NEW "0.12" EXIT_CODE 2
               ERRORS "[casing] clearance has 0.12 m, more than a fiftieth of the tip's radius")
expect_message(one_sample_a_revolution OLD "damping_ratio" NEW "samples_per_revolution = 1\ndamping_ratio" EXIT_CODE 2
               ERRORS "samples_per_revolution = 1 must be at least 2 and at most")
expect_message(no_amplitude OLD "amplitude = 2.0e-4\n" NEW "" EXIT_CODE 2
               ERRORS "case.toml:2:1: [casing] has no amplitude, and it has no default")
expect_message(wide_bumps OLD "shape = \"cosine\"" NEW "shape = \"bumps\"\nbump_width_deg = 200" EXIT_CODE 2
               ERRORS "bump_width_deg = 200 must be more than 0 and at most 180 [deg]")
expect_message(table_beyond_a_lobe OLD "shape = \"cosine\"\nlobes = 2\namplitude = 2.0e-4"
               NEW "shape = \"table\"\nlobes = 2\ndistortion_table = [[0, 0], [200, 1e-4]]" EXIT_CODE 2
               ERRORS "must have its angles in 0 .. 360/lobes")
expect_message(amplitude_of_a_table OLD "shape = \"cosine\""
               NEW "shape = \"table\"\ndistortion_table = [[0, 0], [90, 1e-4]]" EXIT_CODE 2
               ERRORS "unknown key \"amplitude\" in [casing]")
foreach(file profile long damping overdamped modes modes_twice speeds clearance distortion edges)
  set(with_${file} INPUTS ${made}/case.toml ${made}/model.h5 ${made}/${file}.csv)
endforeach()
expect_message(word_in_a_profile ${with_profile} OLD "shape = \"cosine\"" NEW "shape = \"profile\"\nprofile = \"profile.csv\""
               EXIT_CODE 2 ERRORS "profile.csv:3: \"wide\" stands for how far inward [m], which must be a finite number")
expect_message(profile_in_millimetres ${with_long} OLD "shape = \"cosine\"\nlobes = 2\namplitude = 2.0e-4"
               NEW "shape = \"profile\"\nlobes = 2\nprofile = \"long.csv\"" EXIT_CODE 2
               ERRORS "long.csv: [casing] profile has 0.2 m, more than a fiftieth of the tip's radius")
# Symptom: the crest at one edge was held against the clearance at the other.
expect_message(crests_at_one_edge ${with_edges} OLD "shape = \"cosine\"\nlobes = 2\namplitude = 2.0e-4\nclearance = [[0.0, 1.5e-4], [1.0, 1.2e-4]]"
               NEW "shape = \"profile\"\nlobes = 2\nprofile = \"edges.csv\"\nclearance = [[0.0, 1e-4], [1.0, 3e-4]]" ARGUMENTS case.toml model.h5 --check
               ERRORS "crests of up to 0.2 mm and clearances of 0.1 .. 0.3 mm at these speeds: no tip touches unless it vibrates by more than 0.1 mm")
expect_message(distortion_in_millimetres_in_a_file ${with_distortion} OLD "shape = \"cosine\"\nlobes = 2\namplitude = 2.0e-4"
               NEW "shape = \"table\"\nlobes = 2\ndistortion_table = \"distortion.csv\"" EXIT_CODE 2
               ERRORS "distortion.csv:3: [casing] distortion_table has 0.2 m, more than a fiftieth of the tip's radius")
expect_message(no_profile OLD "shape = \"cosine\"" NEW "shape = \"profile\"\nprofile = \"absent.csv\"" EXIT_CODE 1
               ERRORS "absent.csv: can't be read")
expect_message(lists_from_files ${with_damping} OLD "damping_ratio = 0.005" NEW "damping_table = \"damping.csv\""
               ARGUMENTS case.toml --tables OUTPUTS "damping_table = [[100, 0.001], [2000, 0.002]]")
expect_message(overdamped_in_a_file ${with_overdamped} OLD "damping_ratio = 0.005" NEW "damping_table = \"overdamped.csv\"" EXIT_CODE 2
               ERRORS "overdamped.csv:2: [simulate] damping_table = 2 must be at least 0 and at most 0.9 [Hz, of critical]")
expect_message(two_dampings ${with_damping} OLD "damping_ratio = 0.005" NEW "damping_ratio = 0.005\ndamping_table = \"damping.csv\"" EXIT_CODE 2
               ERRORS "[simulate] damping_table and damping_ratio exclude each other; drop one (--set simulate.damping_ratio= drops it)")
expect_message(damping_of_modes ${with_modes} OLD "damping_ratio = 0.005" NEW "damping_ratio = 0.005\ndamping_by_mode = \"modes.csv\""
               ARGUMENTS case.toml --tables OUTPUTS "damping_by_mode = [[0, 1, 0.001], [2, 1, 0.003]]" "damping_ratio = 0.005")
expect_message(damping_of_a_mode_twice ${with_modes_twice} OLD "damping_ratio = 0.005" NEW "damping_by_mode = \"modes_twice.csv\"" EXIT_CODE 2
               ERRORS "modes_twice.csv:2: [simulate] damping_by_mode has this mode twice; drop one")
expect_message(damping_of_a_mode_of_another_wheel OLD "damping_ratio = 0.005" NEW "damping_by_mode = [[4, 1, 0.001]]" EXIT_CODE 2
               ERRORS "damping_by_mode has nodal diameter 4, and a wheel of 6 sectors has 0 to 3")
expect_message(damping_of_a_family_that_is_not_there OLD "damping_ratio = 0.005" NEW "damping_by_mode = [[0, 1000, 0.001]]" EXIT_CODE 2
               ERRORS "damping_by_mode has family 1000, and the model has")
# Symptom: the ratio of a mode above the resolved frequency was overruled without a word.
expect_message(damping_of_an_unresolved_mode OLD "damping_ratio = 0.005" NEW "resolved_frequency_hz = 2000\ndamping_by_mode = [[0, 1, 0.001], [0, 18, 0.001]]" EXIT_CODE 2
               ERRORS "damping_by_mode has family 18 of nodal diameter 0, of at least " " Hz, above the resolved frequency, 2000 Hz, where damping_ratio_beyond holds; drop the row")
expect_message(damping_of_half_a_mode OLD "damping_ratio = 0.005" NEW "damping_by_mode = [[1.5, 1, 0.001]]" EXIT_CODE 2
               ERRORS "damping_by_mode must begin with a nodal diameter, a whole number from 0 on")
expect_message(damping_of_family_zero OLD "damping_ratio = 0.005" NEW "damping_by_mode = [[1, 0, 0.001]]" EXIT_CODE 2
               ERRORS "damping_by_mode must have a family second, a whole number from 1 on")
expect_message(damping_of_a_mode_in_pairs OLD "damping_ratio = 0.005" NEW "damping_by_mode = [[1, 0.001]]" EXIT_CODE 2
               ERRORS "damping_by_mode must be a list of lists of 3 numbers")
expect_message(damping_of_a_mode_in_percent OLD "damping_ratio = 0.005" NEW "damping_by_mode = [[1, 1, 0.2]]" EXIT_CODE 2
               ERRORS "damping_by_mode = 0.2 is unusual: expected at least 0 and at most 0.05")
expect_message(speeds_from_a_file ${with_speeds} OLD "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40"
               NEW "speeds_rpm = \"speeds.csv\"" ARGUMENTS case.toml --tables OUTPUTS "speeds_rpm = [9000, 10000, 9500]")
expect_message(clearance_in_millimetres_in_a_file ${with_clearance}
               OLD "clearance = [[0.0, 1.5e-4], [1.0, 1.2e-4]]" NEW "clearance = \"clearance.csv\"" EXIT_CODE 2
               ERRORS "clearance.csv:3: [casing] clearance has 0.12 m, more than a fiftieth of the tip's radius")
expect_message(speeds_beside_a_range ARGUMENTS case.toml model.h5 -o response.h5 --set simulate.speeds_rpm=[9500] EXIT_CODE 2
               ERRORS "[simulate] speed_min_rpm belongs to a range of speeds" "--set simulate.speed_min_rpm= removes this key")
expect_message(speeds_in_place_of_a_range OUTPUTS "speeds_rpm = [9500]"
               ARGUMENTS case.toml --tables --set simulate.speeds_rpm=[9500] --set simulate.speed_min_rpm= --set simulate.speed_max_rpm=
                         --set simulate.speed_count=)
set(blades "blade_clearance = [0, 1e-5, 2e-5, 0, 0, 0]")
expect_message(blades_that_differ OLD "lobes = 2" NEW "lobes = 2\n${blades}" EXIT_CODE 2
               ERRORS "[casing] blade_clearance makes the sectors differ; set [simulate] nodal_diameters = \"all\"")
expect_message(blades_of_another_wheel OLD "lobes = 2" NEW "lobes = 2\nblade_clearance = [0, 1e-5]" EXIT_CODE 2
               ERRORS "[casing] blade_clearance has 2 numbers, and the wheel has 6 blades; give one for each")
expect_message(blades_longer_than_the_clearance OLD "lobes = 2" NEW "lobes = 2\nblade_clearance = [0, -1e-3, 0, 0, 0, 0]" EXIT_CODE 2
               ERRORS "[casing] blade_clearance takes more from `clearance` than there is")
expect_message(orbit_of_blades_that_differ OLD "damping_ratio" NEW "steady_state = \"orbit\"\nnodal_diameters = \"all\"\ndamping_ratio"
               ARGUMENTS case.toml model.h5 -o response.h5 --set "casing.${blades}" EXIT_CODE 2
               ERRORS "[casing] blade_clearance leaves no motion that is the same in all sectors; set [simulate] steady_state = \"march\"")

expect_message(cold_clearance_closed_by_spin OLD "clearance =" NEW "clearance_state = \"cold\"\nclearance =" EXIT_CODE 1
               ERRORS "spin closes the clearance: contact node 0")

expect_message(overdamped OLD "damping_ratio = 0.005" NEW "damping_ratio = 1000" EXIT_CODE 2
               ERRORS "damping_ratio = 1000 must be at least 0 and at most 0.9")
# Symptom: numbers in another unit passed, and nothing warned.
expect_message(damping_in_percent OLD "damping_ratio = 0.005" NEW "damping_ratio = 0.5" EXIT_CODE 2
               ERRORS "damping_ratio = 0.5 is unusual: expected at least 0 and at most 0.05 [of critical]" "add unusual = true to this table")
expect_message(damping_by_family_in_percent OLD "damping_ratio = 0.005" NEW "damping_ratio_by_family = [0.005, 0.2]" EXIT_CODE 2
               ERRORS "damping_ratio_by_family = 0.2 is unusual: expected at least 0 and at most 0.05")
expect_message(damping_that_is_meant OLD "damping_ratio = 0.005" NEW "damping_ratio = 0.5\nunusual = true"
               ARGUMENTS case.toml model.h5 --check)
expect_message(speeds_in_hertz OLD "speed_min_rpm = 9000\nspeed_max_rpm = 12000" NEW "speed_min_rpm = 150\nspeed_max_rpm = 200" EXIT_CODE 2
               ERRORS "speed_max_rpm = 200 is unusual: expected at least 2122.0659")
expect_message(speeds_in_radians OLD "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40" NEW "speeds_rpm = [1500, 2000]" EXIT_CODE 2
               ERRORS "speeds_rpm = 2000 is unusual: expected at least 2122.0659")
expect_message(resolved_frequency_in_kilohertz OLD "damping_ratio" NEW "resolved_frequency_hz = 20\ndamping_ratio" EXIT_CODE 2
               ERRORS "case.toml:11:25: [simulate] resolved_frequency_hz = 20 is unusual: expected at least " " [Hz]" "add unusual = true to this table")
expect_message(bumps_in_radians OLD "shape = \"cosine\"" NEW "shape = \"bumps\"\nbump_width_deg = 0.35" EXIT_CODE 2
               ERRORS "bump_width_deg = 0.35 is unusual: expected at least 1 [deg]")
expect_message(table_in_radians OLD "shape = \"cosine\"\nlobes = 2\namplitude = 2.0e-4"
               NEW "shape = \"table\"\nlobes = 2\ndistortion_table = [[0.0, 2e-4], [1.57, -2e-4]]" EXIT_CODE 2
               ERRORS "distortion_table has its angles from 0 to 1.57 deg, less than a fiftieth of the 180 deg of a lobe; are they in radians?")
expect_message(amplitude_that_is_meant OLD "amplitude = 2.0e-4" NEW "amplitude = 5e-3\nunusual = true" ARGUMENTS case.toml model.h5 --check)
expect_message(ramp_beyond_the_march OLD "lobes = 2" NEW "lobes = 2\nramp_revolutions = 300" EXIT_CODE 2
               ERRORS "ramp_revolutions = 300 is more than the " "max_revolutions leaves before the recording")
expect_message(endless_ramp OLD "lobes = 2" NEW "lobes = 2\nramp_revolutions = 1e308" EXIT_CODE 2
               ERRORS "ramp_revolutions = 1e+308 must be more than 0 and at most 1e+06")
expect_message(one_revolution_a_minute OLD "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40" NEW "speeds_rpm = [1]\nunusual = true"
               EXIT_CODE 1 ERRORS "more than ten minutes of marching for one speed")
expect_message(too_little_memory OLD "max_revolutions = 70"
               NEW "max_revolutions = 2000\nsamples_per_revolution = 1000000\nrecorded_revolutions = 1000"
               EXIT_CODE 1 ERRORS "GiB" "lower [simulate] samples_per_revolution")

expect_message(papers_rule_with_the_wrong_scheme OLD "damping_ratio" NEW "contact = \"paper\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "case.toml:11:11: [simulate] contact = \"paper\" holds only with scheme = \"central_differences\"")
expect_message(orbit_with_a_law_that_remembers OLD "damping_ratio"
               NEW "steady_state = \"orbit\"\nscheme = \"penalty\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] steady_state = \"orbit\" holds only with contact = \"complementarity\" and neither")
expect_message(branches_with_a_law_that_remembers OLD "damping_ratio"
               NEW "branches = \"critical_speeds\"\nscheme = \"moreau_jean\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] branches = \"critical_speeds\" holds only with contact = \"complementarity\" and neither")
expect_message(unknown_scheme OLD "damping_ratio" NEW "scheme = \"newmark\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "scheme = \"newmark\" must be one of: trigonometric, central_differences, residual_flexibility, \
moreau_jean, penalty")
expect_message(residual_flexibility_without_modes OLD "damping_ratio"
               NEW "scheme = \"residual_flexibility\"\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] has no modes, and it has no default")
expect_message(key_of_another_scheme OLD "damping_ratio" NEW "moreau_jean_theta = 0.6\ndamping_ratio" EXIT_CODE 2
               ERRORS "[simulate] moreau_jean_theta belongs to scheme = \"moreau_jean\"")
expect_message(theta_that_blows_up OLD "damping_ratio"
               NEW "scheme = \"moreau_jean\"\nmoreau_jean_theta = 0.4\ndamping_ratio" EXIT_CODE 2
               ERRORS "moreau_jean_theta = 0.4 must be")
expect_message(penalty_too_stiff_for_the_step OLD "damping_ratio"
               NEW "scheme = \"penalty\"\npenalty_stiffness = 1e9\ndamping_ratio" EXIT_CODE 1
               ERRORS "no speed could be computed" "the springs of the penalty need h omega_max / 2 <= 1" "a lower penalty_stiffness")
expect_message(fewer_modes_than_contact_nodes OLD "damping_ratio" NEW "modes = 2\ndamping_ratio" EXIT_CODE 1
               ERRORS "no speed could be computed" "2 modes a nodal diameter can't move 3 contact nodes independently")
expect_message(step_beyond_the_limit_at_every_speed OLD "damping_ratio"
               NEW "scheme = \"central_differences\"\nsteps_per_period = 4\nsamples_per_revolution = 12\ndamping_ratio"
               EXIT_CODE 1
               ERRORS "no speed could be computed" "central differences need h omega_max / 2 <= 1, and have"
                      "set [simulate] steps_per_revolution to at least")

expect_message(speeds_the_wrong_way OLD "speed_max_rpm = 12000" NEW "speed_max_rpm = 8000" EXIT_CODE 2
               ERRORS "[simulate] speed_max_rpm = 8000 must be above speed_min_rpm = ")
expect_message(speed_beyond_the_model OLD "speed_max_rpm = 12000" NEW "speed_max_rpm = 20000" EXIT_CODE 2
               ERRORS "speed_max_rpm goes to 20000 rev/min" "holds up to 19098.6")
expect_message(a_speed_twice OLD "speed_min_rpm = 9000\nspeed_max_rpm = 12000\nspeed_count = 40"
               NEW "speeds_rpm = [9000, 9000]" EXIT_CODE 2 ERRORS "speeds_rpm names a speed twice")
expect_message(too_few_revolutions OLD "max_revolutions = 70" NEW "max_revolutions = 10" EXIT_CODE 2
               ERRORS "[simulate] max_revolutions = 10 must be at least min_revolutions = ")

# Models with one thing wrong.
function(expect_wrong_model model code)
  expect_message(model_${model} INPUTS ${made}/case.toml ${made}/${model}.h5 ARGUMENTS case.toml ${model}.h5 -o response.h5
                 EXIT_CODE ${code} ERRORS ${ARGN})
endfunction()
expect_wrong_model(text 2 "text.h5: is not an HDF5 file, or is damaged")
expect_wrong_model(not_finite 2 "not_finite.h5: /nodal_diameter/0/K0: value 1 (row-major, from 0) is not finite")
expect_wrong_model(other_schema 2 "is tiprub-response version 1, expected tiprub-model version 1")
expect_wrong_model(not_hermitian 2 "/M is not Hermitian")
expect_wrong_model(unstable 1 "no speed could be computed" "nodal diameter 1 has omega^2 = -" "statically unstable")

# Symptom: a shape under spin that left 65 % of the load out of balance was named by reduce alone.
expect_message(model_doubtful INPUTS ${made}/case.toml ${made}/doubtful.h5 ERRORS "response.h5: warning: the shape under spin leaves 65 % of the load"
               ARGUMENTS case.toml doubtful.h5 -o response.h5 --set simulate.speed_count=2 WRITES response.h5)

expect_message(nothing_touches OLD "[[0.0, 1.5e-4], [1.0, 1.2e-4]]" NEW "[[0.0, 5e-4], [1.0, 3.5e-4]]"
               ARGUMENTS case.toml model.h5 -o response.h5 --set simulate.speed_count=2 WRITES response.h5
               ERRORS "no tip touches the casing at any speed: the gap closes to 0.00015 m at the least, at " " rev/min at the trailing edge; for contact, give [casing] less clearance")

set(check ARGUMENTS case.toml model.h5 --check)
expect_message(check ${check} ERRORS "at least 200 a period of the lowest frequency, halved until that changes the motion by less than 0.005"
                                     "nodal diameters 0, 2: multiples of gcd(6 sectors, 2 lobes) = 2")
# Four times the tolerance: half the steps.
expect_message(check_of_coarser_steps ${check} OLD "damping_ratio" NEW "step_tolerance = 2e-2\ndamping_ratio"
               ERRORS "at least 100 a period")
expect_message(check_of_a_sweep ${check} OLD "damping_ratio" NEW "sweep = \"up\"\nbudget = \"largest\"\ndamping_ratio"
               ERRORS "error budgets: none, because a sweep up or down examines no speeds")
expect_message(check_of_an_orbit ${check} OLD "damping_ratio" NEW "steady_state = \"orbit\"\ndamping_ratio"
               ERRORS "settled motions: by Newton's method for a fixed point of 1/6 of a revolution and a shift of 1 sectors")
