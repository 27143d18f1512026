// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <complex>

#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

const H5::CompType& complex_type() {
  static const H5::CompType type = hdf5_complex_type<float>(H5::PredType::NATIVE_FLOAT);
  return type;
}

/// Selects one slice of a dataset's space; the space of the slice alone.
H5::DataSpace select_slice(H5::DataSpace& space, std::size_t index) {
  Hdf5Shape count = hdf5_extents(space);
  Hdf5Shape start(count.size(), 0);
  start.front() = index;
  count.front() = 1;
  space.selectHyperslab(H5S_SELECT_SET, count.data(), start.data());
  return H5::DataSpace(static_cast<int>(count.size()), count.data());
}

}  // namespace

void Hdf5File::make_slices(const std::string& name, const std::vector<std::size_t>& shape, Number number,
                           const std::string& unit) {
  attempt(name, "can't be written", [&] {
    Hdf5Shape chunk(shape.begin(), shape.end());
    chunk.front() = 1;
    H5::DSetCreatPropList creation;
    creation.setChunk(static_cast<int>(chunk.size()), chunk.data());
    const H5::DataType type =
        number == Number::complex ? H5::DataType(complex_type()) : H5::DataType(H5::PredType::NATIVE_FLOAT);
    handle_->make(name, type, Hdf5Shape(shape.begin(), shape.end()), creation, unit);
  });
}

void Hdf5File::write_slice(const std::string& name, std::size_t index,
                           const std::vector<std::complex<float>>& values) {
  attempt(name, "slice " + std::to_string(index) + " can't be written", [&] {
    const H5::DataSet set = handle_->file.openDataSet(name);
    H5::DataSpace inside = set.getSpace();
    const H5::DataSpace slice = select_slice(inside, index);
    if (set.getTypeClass() == H5T_COMPOUND) {
      set.write(values.data(), complex_type(), slice, inside);
      return;
    }
    std::vector<float> real(values.size());
    std::transform(values.begin(), values.end(), real.begin(), [](std::complex<float> v) { return v.real(); });
    set.write(real.data(), H5::PredType::NATIVE_FLOAT, slice, inside);
  });
}

std::vector<std::complex<float>> Hdf5File::read_slice(const std::string& name, std::size_t index) const {
  if (!exists(name)) fail(name, "is missing");
  std::vector<std::complex<float>> values;
  attempt(name, "slice " + std::to_string(index) + " can't be read as real or {r, i} numbers", [&] {
    const H5::DataSet set = handle_->file.openDataSet(name);
    H5::DataSpace inside = set.getSpace();
    const H5::DataSpace slice = select_slice(inside, index);
    values.resize(static_cast<std::size_t>(slice.getSimpleExtentNpoints()));
    if (set.getTypeClass() == H5T_COMPOUND) {
      set.read(values.data(), complex_type(), slice, inside);
    } else {
      std::vector<float> real(values.size());
      set.read(real.data(), H5::PredType::NATIVE_FLOAT, slice, inside);
      std::copy(real.begin(), real.end(), values.begin());
    }
  });
  for (const std::complex<float>& value : values)
    if (!std::isfinite(value.real()) || !std::isfinite(value.imag()))
      fail(name, "slice " + std::to_string(index) + " has a value that is not finite");
  return values;
}

std::vector<std::size_t> Hdf5File::shape_of(const std::string& name) const {
  if (!exists(name)) fail(name, "is missing");
  return attempt(name, "is no dataset", [&]() -> std::vector<std::size_t> {
    const Hdf5Shape shape = hdf5_extents(handle_->file.openDataSet(name).getSpace());
    return {shape.begin(), shape.end()};
  });
}

}  // namespace tiprub
