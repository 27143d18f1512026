// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "reduce/model/hdf5_file.h"

namespace tiprub {

// Axes that several kinds of datasets of response.h5 share.
inline const std::string samples_axis = "samples", sectors_axis = "sectors", nodes_axis = "contact nodes",
                         components_axis = "components";

/// The lengths of the axes of a file by name: an axis has the same length in all datasets. A length is either set
/// beforehand, or taken from the first dataset with that axis.
class NamedAxes {
 public:
  explicit NamedAxes(const Hdf5File& file) : file_(file) {}

  void set(const std::string& axis, std::size_t length, const std::string& because);
  /// Checks the shape of a dataset before it is read. Raises RunError unless it has these axes, the last one fastest,
  /// and none is empty.
  void require(const std::string& dataset, const std::vector<std::string>& axes);
  /// The same, and then reads it.
  Eigen::VectorXd read_vector(const std::string& dataset, const std::string& axis) {
    require(dataset, {axis});
    return file_.read_vector(dataset);
  }
  Eigen::MatrixXd read_matrix(const std::string& dataset, const std::vector<std::string>& axes) {
    require(dataset, axes);
    return file_.read_matrix(dataset);
  }

 private:
  struct Length {
    std::size_t value;
    std::string because;
  };

  std::string describe(const std::vector<std::string>& axes) const;

  const Hdf5File& file_;
  std::map<std::string, Length> lengths_;
};

/// Writes a dataset and makes it a netCDF coordinate axis.
void write_axis(Hdf5File& file, const std::string& name, const Eigen::VectorXd& values, const std::string& unit,
                const std::string& long_name);

/// The same for an axis that counts 0, 1, ...
void write_counting_axis(Hdf5File& file, const std::string& name, Eigen::Index count, const std::string& long_name);

/// Writes a dataset along such axes, slowest first.
template <class Values>
void write_along(Hdf5File& file, const std::vector<std::string>& axes, const std::string& name, const Values& values,
                 const std::string& unit, const std::string& long_name) {
  file.write(name, values, unit);
  file.describe(name, long_name, axes);
}

}  // namespace tiprub
