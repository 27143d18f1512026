// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulate/march/wave_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <ctime>
#include <random>
#include <vector>

namespace tiprub::simulate::kernels {
namespace {

using Complex = std::complex<double>;

/// A travelling wave of 96 modes and ten contact nodes, in the order of the kernels and plainly.
struct Wave {
  static constexpr std::size_t modes = 6 * mode_block, nodes = 10, padded_nodes = 12;

  std::vector<Complex> Y = std::vector<Complex>(nodes * modes), q = std::vector<Complex>(modes);
  std::vector<double> shapes = std::vector<double>(2 * nodes * modes), q_re, q_im;
  std::vector<double> p_re = std::vector<double>(padded_nodes), p_im = p_re;

  Wave() {
    std::mt19937 source(3);
    const auto random = [&] { return 2.0 * source() / std::mt19937::max() - 1.0; };
    for (Complex& value : Y) value = {random(), random()};
    for (Complex& value : q) value = {random(), random()};
    for (std::size_t m = 0; m < modes; ++m) {
      q_re.push_back(q[m].real());
      q_im.push_back(q[m].imag());
      for (std::size_t k = 0; k < nodes; ++k) {
        const std::size_t place = 2 * (m / mode_block * nodes + k) * mode_block + m % mode_block;
        shapes[place] = Y[m * nodes + k].real();
        shapes[place + mode_block] = Y[m * nodes + k].imag();
      }
    }
  }
  void map() { to_nodes_travelling(shapes.data(), q_re.data(), q_im.data(), modes, nodes, p_re.data(), p_im.data()); }
  void map_plainly(std::vector<Complex>& p) const {
    std::fill(p.begin(), p.end(), Complex());
    for (std::size_t m = 0; m < modes; ++m)
      for (std::size_t k = 0; k < nodes; ++k) {
        const Complex y = Y[m * nodes + k];
        p[k] +=
            Complex(y.real() * q[m].real() - y.imag() * q[m].imag(), y.real() * q[m].imag() + y.imag() * q[m].real());
      }
  }
};

TEST(WaveKernels, MapModesToNodesAndForcesBack) {
  Wave wave;
  std::vector<Complex> p(Wave::nodes);
  wave.map();
  wave.map_plainly(p);
  for (std::size_t k = 0; k < Wave::nodes; ++k)
    EXPECT_LT(std::abs(Complex(wave.p_re[k], wave.p_im[k]) - p[k]), 1e-13);

  const std::vector<int> forced = {1, 4, 9};
  std::vector<double> c(Wave::modes), d_re(Wave::modes), d_im(Wave::modes), q_re = wave.q_re, q_im = wave.q_im;
  for (std::size_t m = 0; m < Wave::modes; ++m) c[m] = 1.0 / static_cast<double>(m + 1);
  add_force_travelling(wave.shapes.data(), c.data(), wave.p_re.data(), wave.p_im.data(),
                       {forced.data(), forced.size(), Wave::nodes}, Wave::modes, {q_re.data(), d_re.data()},
                       {q_im.data(), d_im.data()});
  for (std::size_t m = 0; m < Wave::modes; ++m) {
    Complex force;
    for (const int k : forced) force += std::conj(wave.Y[m * Wave::nodes + static_cast<std::size_t>(k)]) * p[k];
    EXPECT_LT(std::abs(Complex(d_re[m], d_im[m]) + c[m] * force), 1e-12);
    EXPECT_LT(std::abs(Complex(q_re[m], q_im[m]) - wave.q[m] + c[m] * force), 1e-12);
  }
}

/// Vectors of eight doubles went through memory on processors without AVX-512, and a step took ten times as long:
/// three times that of plain loops. In registers it takes a quarter of theirs.
TEST(WaveKernels, AreFasterThanPlainLoops) {
#ifndef NDEBUG
  GTEST_SKIP() << "not an optimized build";
#endif
  Wave wave;
  std::vector<Complex> p(Wave::nodes);
  const auto seconds = [](const auto& run) {
    double least = 1e300;
    for (int trial = 0; trial < 20; ++trial) {
      timespec start{}, end{};
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &start);
      for (int i = 0; i < 200; ++i) run();
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
      least = std::min(least, static_cast<double>(end.tv_sec - start.tv_sec) +
                                  1e-9 * static_cast<double>(end.tv_nsec - start.tv_nsec));
    }
    return least;
  };
  const double in_registers = seconds([&] { wave.map(); }), plainly = seconds([&] { wave.map_plainly(p); });
  EXPECT_LT(in_registers, plainly);
}

}  // namespace
}  // namespace tiprub::simulate::kernels
