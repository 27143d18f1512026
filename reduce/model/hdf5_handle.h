// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <H5Cpp.h>

#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "reduce/model/hdf5_file.h"

// What the facade's own files share: HDF5's headers reach nobody else, and never a file that includes deal.II.
namespace tiprub {

using Hdf5Shape = std::vector<hsize_t>;

/// h5py's convention for complex numbers.
template <class Real>
H5::CompType hdf5_complex_type(const H5::PredType& real) {
  H5::CompType type(2 * sizeof(Real));
  type.insertMember("r", 0, real);
  type.insertMember("i", sizeof(Real), real);
  return type;
}

Hdf5Shape hdf5_extents(const H5::DataSpace& space);
/// "3 x 4", "scalar".
std::string hdf5_shape_text(const Hdf5Shape& shape);

struct Hdf5File::Handle {
  H5::H5File file;

  void make_groups(const std::string& name) const;
  H5::DataSet make(const std::string& name, const H5::DataType& type, const Hdf5Shape& shape,
                   const H5::DSetCreatPropList& creation, const std::string& unit) const;
  template <class Body>
  void with_attributes(const std::string& object, Body body) const {
    if (object == "/") {
      body(file.openGroup("/"));
    } else if (file.childObjType(object) == H5O_TYPE_GROUP) {
      body(file.openGroup(object));
    } else {
      body(file.openDataSet(object));
    }
  }
};

template <class Body>
auto Hdf5File::attempt(const std::string& object, const std::string& complaint, const Body& body) const {
  try {
    return body();
  } catch (const H5::Exception&) {
    fail(object, complaint);
  } catch (const std::bad_alloc&) {
    fail(object, "takes more memory than there is");
  } catch (const std::length_error&) {
    fail(object, "takes more memory than there is");
  }
}

}  // namespace tiprub
