// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/shared_diameters.h"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <utility>

#include "reduce/sector/parallel_for.h"

namespace tiprub::reduce {

namespace {

class Packer {
 public:
  void operator()(int count) { numbers_.push_back(count); }
  /// Its size, and its entries as real numbers.
  template <class Matrix>
  void operator()(const Matrix& matrix) {
    (*this)(static_cast<int>(matrix.rows()));
    (*this)(static_cast<int>(matrix.cols()));
    const auto* entries = reinterpret_cast<const double*>(matrix.data());
    numbers_.insert(numbers_.end(), entries, entries + matrix.size() * sizeof(*matrix.data()) / sizeof(double));
  }
  void operator()(const std::vector<Eigen::MatrixXcd>& matrices) {
    (*this)(static_cast<int>(matrices.size()));
    for (const Eigen::MatrixXcd& matrix : matrices) (*this)(matrix);
  }
  std::vector<double> take() { return std::move(numbers_); }

 private:
  std::vector<double> numbers_;
};

class Unpacker {
 public:
  explicit Unpacker(const std::vector<double>& numbers) : next_(numbers.data()) {}

  void operator()(int& count) { count = static_cast<int>(*next_++); }
  template <class Matrix>
  void operator()(Matrix& matrix) {
    int rows = 0, columns = 0;
    (*this)(rows);
    (*this)(columns);
    matrix.resize(rows, columns);
    const std::size_t count = matrix.size() * sizeof(*matrix.data()) / sizeof(double);
    std::copy_n(next_, count, reinterpret_cast<double*>(matrix.data()));
    next_ += count;
  }
  void operator()(std::vector<Eigen::MatrixXcd>& matrices) {
    int count = 0;
    (*this)(count);
    matrices.resize(static_cast<std::size_t>(count));
    for (Eigen::MatrixXcd& matrix : matrices) (*this)(matrix);
  }

 private:
  const double* next_;
};

template <class Result, class Visitor>
void visit(Result& result, Visitor& visitor) {
  visitor(result.generalized_dofs);
  visitor(result.dropped);
  visitor(result.corrections);
  visitor(result.stiffness);
  visitor(result.mass);
  visitor(result.unreduced);
  visitor(result.frequency_errors);
  visitor(result.compliance_errors);
  visitor(result.frequency_cells);
  visitor(result.compliance_cells);
}

/// All but the shapes.
std::vector<double> packed(const DiameterResult& result) {
  Packer packer;
  visit(result, packer);
  return packer.take();
}

DiameterResult unpacked(const std::vector<double>& numbers) {
  DiameterResult result;
  Unpacker unpacker(numbers);
  visit(result, unpacker);
  return result;
}

/// Brings a matrix to the leader, column by column; returns the way to ask for them there.
ShapeOfBasis pass_columns(ProcessGroup& group, int from, const Eigen::MatrixXcd& columns) {
  const auto next = [&group, from](const Eigen::VectorXcd& column) {
    const auto* entries = reinterpret_cast<const double*>(column.data());
    std::vector<double> numbers(entries, entries + 2 * column.size());
    group.pass_to_leader(from, numbers);
    const auto* passed = reinterpret_cast<const std::complex<double>*>(numbers.data());
    return Eigen::VectorXcd(
        Eigen::Map<const Eigen::VectorXcd>(passed, static_cast<Eigen::Index>(numbers.size() / 2)));
  };
  if (!group.leads())
    for (const auto& column : columns.colwise()) next(column);
  return [next](Eigen::Index) { return next({}); };
}

}  // namespace

void share_diameters(ProcessGroup& group, int diameters, int threads,
                     const std::function<DiameterResult(int n)>& reduce,
                     const std::function<void(int n, DiameterResult, const ShapeOfBasis&)>& keep) {
  const int processes = group.size(), at_once = processes * threads;
  for (int first = 0; first < diameters; first += at_once) {
    const int round = std::min(at_once, diameters - first);
    std::vector<DiameterResult> results(static_cast<std::size_t>(round));
    group.together([&] {
      const int own = (round - group.rank() + processes - 1) / processes;
      parallel_for(own, threads, [&](int k) {
        const int place = group.rank() + k * processes;
        results[place] = reduce(first + place);
      });
    });
    for (int place = 0; place < round; ++place) {
      const int from = place % processes;
      if (group.leads() && from == 0) {
        const Eigen::MatrixXcd shapes = std::move(results[place].shapes);
        keep(first + place, std::move(results[place]), [&](Eigen::Index k) { return shapes.col(k); });
      }
      if (from == 0 || (from != group.rank() && !group.leads())) continue;
      std::vector<double> numbers = packed(results[place]);
      group.pass_to_leader(from, numbers);
      const ShapeOfBasis shapes = pass_columns(group, from, results[place].shapes);
      if (group.leads()) keep(first + place, unpacked(numbers), shapes);
    }
  }
}

}  // namespace tiprub::reduce
