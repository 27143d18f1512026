# SPDX-License-Identifier: GPL-3.0-or-later
# Large displacements, linear results, exports, closed forms; sectors that others meshed; what is refused.
add_executable(
  reduce_linear_test
  closed_forms_test.cc
  linear_results_test.cc
  matrix_market_test.cc
  memory_need_test.cc
  spin_equilibrium_test.cc)
target_link_libraries(reduce_linear_test PRIVATE reduce_test_rotors)
add_test(NAME reduce.reduce_linear_test COMMAND reduce_linear_test)
set_tests_properties(reduce.reduce_linear_test PROPERTIES ENVIRONMENT OPENBLAS_NUM_THREADS=1)

# Another mesh or another way to run the program than expect_message() has.
function(expect_elsewhere name mesh case exit_code phrase models)
  add_test(
    NAME reduce.message.${name}
    COMMAND
      ${CMAKE_COMMAND} -DMESH=${mesh} "-DPROGRAM=${ARGN};$<TARGET_FILE:tiprub-reduce>" -DCASE=${case}
      "-DARGUMENTS=case.toml;sector.msh" -DEXIT_CODE=${exit_code} -DPHRASE=${phrase} -DMODELS=${models}
      -DFOLDER=${CMAKE_CURRENT_BINARY_DIR}/message/${name} -P ${CMAKE_CURRENT_SOURCE_DIR}/expect_message.cmake)
  set_tests_properties(reduce.message.${name} PROPERTIES FIXTURES_REQUIRED reduce_${name})
endfunction()

# A sector that tiprub-mesh didn't make.
add_executable(gmsh_sector gmsh_sector.cc)
target_link_libraries(gmsh_sector PRIVATE ${GMSH_LIBRARY})
function(expect_gmsh_sector kind exit_code phrase models)
  set(mesh ${CMAKE_CURRENT_BINARY_DIR}/gmsh_${kind}.msh)
  add_test(NAME reduce.gmsh_${kind} COMMAND gmsh_sector ${kind} ${mesh})
  set_tests_properties(reduce.gmsh_${kind} PROPERTIES FIXTURES_SETUP reduce_gmsh_sector_${kind})
  expect_elsewhere(gmsh_sector_${kind} ${mesh} ${plate} ${exit_code} ${phrase} ${models})
endfunction()
expect_gmsh_sector(hex20 0 "8 sectors of 270 dofs" 1)
expect_gmsh_sector(hex27 0 "8 sectors of 450 dofs" 1)
expect_gmsh_sector(hex8 2 "elements of gmsh type 5@ it must hold 20-node bricks" 0)
expect_gmsh_sector(inverted 2 "m is inverted@ re-mesh" 0)

# Of 600 sectors with 500 modes at 301 nodal diameters, under 1.5 GB of data.
set(many ${CMAKE_CURRENT_SOURCE_DIR}/large_disc.toml)
add_test(NAME reduce.mesh_large_disc COMMAND tiprub-mesh -q ${many} -o ${CMAKE_CURRENT_BINARY_DIR}/many.msh)
set_tests_properties(reduce.mesh_large_disc PROPERTIES FIXTURES_SETUP reduce_too_little_memory)
expect_elsewhere(too_little_memory ${CMAKE_CURRENT_BINARY_DIR}/many.msh ${many} 1 "not enough memory: about" 0
                 sh ${CMAKE_CURRENT_SOURCE_DIR}/limited.sh 1500000)

expect_elsewhere(polynomial_misses ${plate_sector} ${CMAKE_CURRENT_SOURCE_DIR}/soft_plate.toml 0
                 "the shape changes too much for eq. 7" 1)
set_tests_properties(reduce.message.polynomial_misses PROPERTIES FIXTURES_REQUIRED reduce_plate_sector)
expect_message(unstable_at_top_speed KEY young_modulus LINE "young_modulus = 1e5\\nprestress = \"stress_only\"" EXIT_CODE 1
               PHRASE "at 5000 rpm: the stiffness is not positive definite: the rotor is unstable")
expect_message(matrix_market ARGUMENTS case.toml sector.msh --export-matrix-market matrices EXIT_CODE 0
               PHRASE "matrices: K0, K1, K2, M of 4 nodal diameters" MODELS 1)
expect_message(modes ARGUMENTS case.toml sector.msh --modes modes.h5 EXIT_CODE 0
               PHRASE "speed_rpm nodal_diameter mode frequency_hz branch mac energy_disc" MODELS 1)
expect_message(nonlinear KEY density LINE "density = 7800.0\\nprestress = \"nonlinear\"" EXIT_CODE 0 PHRASE "eq. 7 through 3 speeds alone within"
               MODELS 1)
