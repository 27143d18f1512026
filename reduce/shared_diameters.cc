// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/shared_diameters.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "reduce/sector/parallel_for.h"

namespace tiprub::reduce {

namespace {

/// Numbers on their way to the leader: it puts what it visits there, or takes it from there.
class Passage {
 public:
  enum class End { departure, arrival };
  explicit Passage(End end) : end_(end) {}

  std::vector<double> numbers;

  void operator()(int& count) {
    double value = count;
    pass(&value, 1);
    count = static_cast<int>(value);
  }
  /// Its size, and its entries as real numbers.
  template <class Matrix>
  void operator()(Matrix& matrix) {
    int rows = static_cast<int>(matrix.rows()), columns = static_cast<int>(matrix.cols());
    (*this)(rows);
    (*this)(columns);
    matrix.resize(rows, columns);
    pass(reinterpret_cast<double*>(matrix.data()), matrix.size() * sizeof(*matrix.data()) / sizeof(double));
  }
  void operator()(std::vector<Eigen::MatrixXcd>& matrices) {
    int count = static_cast<int>(matrices.size());
    (*this)(count);
    matrices.resize(static_cast<std::size_t>(count));
    for (Eigen::MatrixXcd& matrix : matrices) (*this)(matrix);
  }

 private:
  void pass(double* first, std::size_t count) {
    if (end_ == End::departure)
      numbers.insert(numbers.end(), first, first + count);
    else
      std::copy_n(numbers.data() + passed_, count, first);
    passed_ += count;
  }

  End end_;
  std::size_t passed_ = 0;
};

/// Brings what `visit` shows to the leader.
template <class Visit>
void pass_to_leader(ProcessGroup& group, int from, const Visit& visit) {
  Passage passage(group.leads() ? Passage::End::arrival : Passage::End::departure);
  if (!group.leads()) visit(passage);
  group.pass_to_leader(from, passage.numbers);
  if (group.leads()) visit(passage);
}

/// All but the shapes.
void pass_result(ProcessGroup& group, int from, DiameterResult& result) {
  pass_to_leader(group, from, [&](Passage& passage) {
    for (int* count : {&result.generalized_dofs, &result.dropped, &result.corrections}) passage(*count);
    passage(result.stiffness);
    passage(result.mass);
    passage(result.unreduced);
    for (Eigen::VectorXd* values :
         {&result.frequency_errors, &result.compliance_errors, &result.frequency_cells, &result.compliance_cells})
      passage(*values);
  });
}

/// Brings a matrix to the leader, column by column; returns the way to ask for them there.
ShapeOfBasis pass_columns(ProcessGroup& group, int from, const Eigen::MatrixXcd& columns) {
  const auto next = [&group, from](Eigen::VectorXcd column) {
    pass_to_leader(group, from, [&](Passage& passage) { passage(column); });
    return column;
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
      pass_result(group, from, results[place]);
      const ShapeOfBasis shapes = pass_columns(group, from, results[place].shapes);
      if (group.leads()) keep(first + place, std::move(results[place]), shapes);
    }
  }
}

}  // namespace tiprub::reduce
