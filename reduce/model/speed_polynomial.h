// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tiprub {

/// eq. 7: what depends on the speed Omega as C_k Omega^2k, summed over k = lowest, lowest + 1, ...
template <class Matrix, int lowest>
struct SpeedPolynomial {
  std::vector<Matrix> terms;  ///< C_lowest, C_lowest+1, ...; at least one

  Matrix& operator[](int k) { return terms[static_cast<std::size_t>(k - lowest)]; }
  const Matrix& operator[](int k) const { return terms[static_cast<std::size_t>(k - lowest)]; }
  /// Its value at a speed in rad/s.
  Matrix operator()(double speed) const {
    const double square = speed * speed;
    double power = lowest == 0 ? 1 : square;
    Matrix sum = power * terms.front();
    for (std::size_t k = 1; k < terms.size(); ++k) sum += (power *= square) * terms[k];
    return sum;
  }

  /// Files hold C_k up to this k: the paper's Omega^4, or more where there are more terms.
  int highest() const { return std::max(2, lowest + static_cast<int>(terms.size()) - 1); }
  /// C_k, which is zero beyond the last term.
  Matrix coefficient(int k) const {
    if (k - lowest < static_cast<int>(terms.size())) return (*this)[k];
    return Matrix::Zero(terms.front().rows(), terms.front().cols());
  }

  static_assert(lowest == 0 || lowest == 1);
};

}  // namespace tiprub
