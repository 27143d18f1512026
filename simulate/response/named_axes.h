// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "reduce/model/hdf5_file.h"

namespace tiprub {

// Axes that more than one kind of dataset of response.h5 has.
inline const std::string samples_axis = "samples", sectors_axis = "sectors", nodes_axis = "contact nodes",
                         components_axis = "components";

/// The axes of a file's datasets by what they count: an axis has one length in whichever dataset it stands. What can
/// be told beforehand is set; of another axis the first dataset that has it sets the length for all that follow.
class NamedAxes {
 public:
  explicit NamedAxes(const Hdf5File& file) : file_(file) {}

  void set(const std::string& axis, std::size_t length, const std::string& because);
  /// Looks at the dataset's shape before anything of it is read. Raises RunError if it has not these axes, the last
  /// one fastest, or one of them is empty.
  void require(const std::string& dataset, const std::vector<std::string>& axes);

 private:
  struct Length {
    std::size_t value;
    std::string because;
  };

  std::string describe(const std::vector<std::string>& axes) const;

  const Hdf5File& file_;
  std::map<std::string, Length> lengths_;
};

}  // namespace tiprub
