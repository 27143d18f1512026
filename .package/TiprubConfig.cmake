# SPDX-License-Identifier: GPL-3.0-or-later
# The dependencies of the libraries that read and write Tiprub's files.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(Threads)
# FindHDF5 compiles a C program to look at the library.
enable_language(C)
find_dependency(BLAS)
find_dependency(LAPACK)
set(HDF5_PREFER_PARALLEL OFF)
find_dependency(HDF5 1.10 COMPONENTS C HL)
include(${CMAKE_CURRENT_LIST_DIR}/TiprubTargets.cmake)
