# SPDX-License-Identifier: GPL-3.0-or-later
# Large displacements, linear results, exports, closed forms.
add_executable(
  reduce_linear_test
  closed_forms_test.cc
  linear_results_test.cc
  model/matrix_market_test.cc
  operators/memory_need_test.cc
  operators/spin_equilibrium_test.cc
  operators/spin_shape_test.cc)
target_link_libraries(reduce_linear_test PRIVATE reduce_test_rotors)
add_test(NAME reduce.reduce_linear_test COMMAND reduce_linear_test)
set_tests_properties(reduce.reduce_linear_test PROPERTIES ENVIRONMENT OPENBLAS_NUM_THREADS=1)
