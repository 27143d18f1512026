// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels by what the processor can do. This program is started with OPENBLAS_CORETYPE=Prescott, as if OpenBLAS had
// not known the processor.
#include "cases/machine/blas_kernels.h"

#include <cblas.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace tiprub {

namespace {

TEST(BlasKernels, AreThoseOfTheWidestVectors) {
  EXPECT_EQ(better_kernels("Prescott", Vectors::avx512), "SkylakeX");
  EXPECT_EQ(better_kernels("Prescott", Vectors::avx2), "Haswell");
  EXPECT_EQ(better_kernels("Nehalem", Vectors::avx), "Sandybridge");
  EXPECT_EQ(better_kernels("Haswell", Vectors::avx512), "SkylakeX");
}

TEST(BlasKernels, AreLeftWhereNoneAreBetter) {
  EXPECT_EQ(better_kernels("Prescott", Vectors::none), "");
  EXPECT_EQ(better_kernels("SkylakeX", Vectors::avx512), "");
  EXPECT_EQ(better_kernels("Cooperlake", Vectors::avx512), "");
  EXPECT_EQ(better_kernels("Zen", Vectors::avx2), "");
  EXPECT_EQ(better_kernels("Zen", Vectors::avx), "");
  EXPECT_EQ(better_kernels("ANextGeneration", Vectors::avx512), "");
}

/// The largest error of a product that the kernels make, of numbers that are exact.
double error_of_product() {
  constexpr int size = 70;
  std::vector<double> left(size * size), right(size * size), product(size * size);
  for (int i = 0; i < size * size; ++i) left[i] = i % 7, right[i] = i % 5;
  cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, size, size, size, 1.0, left.data(), size, right.data(), size,
              0.0, product.data(), size);
  double error = 0;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) {
      double sum = 0;
      for (int k = 0; k < size; ++k) sum += left[i * size + k] * right[k * size + j];
      error = std::max(error, std::abs(sum - product[i * size + j]));
    }
  return error;
}

// An Intel processor of family 6, model 207 got the kernels of 2004, and half of its speed was thrown away.
TEST(BlasKernels, OfAProcessorThatOpenBlasDoesNotKnowAreChosenByWhatItCanDo) {
  ASSERT_STREQ(std::getenv("OPENBLAS_CORETYPE"), "Prescott");
  const BlasKernels given = choose_blas_kernels();
  EXPECT_NE(given.description.find("kernels Prescott, by OPENBLAS_CORETYPE"), std::string::npos) << given.description;
  EXPECT_NE(given.warning.find("generic kernels (Prescott)"), std::string::npos) << given.warning;
  EXPECT_EQ(error_of_product(), 0);

  unsetenv("OPENBLAS_CORETYPE");
  const std::string best = better_kernels("Prescott", vectors_of_processor());
  const std::clock_t start = std::clock();
  const BlasKernels chosen = choose_blas_kernels();
  const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_EQ(openblas_get_corename(), best.empty() ? std::string("Prescott") : best);
  EXPECT_EQ(chosen.warning.empty(), !best.empty());
  EXPECT_EQ(chosen.description.find("in place of Prescott") != std::string::npos, !best.empty());
  EXPECT_EQ(std::getenv("OPENBLAS_CORETYPE"), nullptr);
  EXPECT_LT(spent, 0.01);  // of a start
  EXPECT_EQ(error_of_product(), 0);
}

}  // namespace

}  // namespace tiprub
