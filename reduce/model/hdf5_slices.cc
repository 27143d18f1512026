// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <complex>

#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

Hdf5Id float_complex_type() {
  return hdf5_complex_type<float>(H5T_NATIVE_FLOAT);
}

Hdf5Id space_of(hid_t set) {
  return {H5Dget_space(set), H5Sclose};
}

bool is_compound(hid_t set) {
  return H5Tget_class(Hdf5Id(H5Dget_type(set), H5Tclose)) == H5T_COMPOUND;
}

/// Selects one slice of a dataset's space. Returns the space of that slice.
Hdf5Id select_slice(hid_t space, std::size_t index) {
  Hdf5Shape count = hdf5_extents(space);
  if (count.empty() || index >= count.front()) throw Hdf5Failure();
  Hdf5Shape start(count.size(), 0);
  start.front() = index;
  count.front() = 1;
  hdf5_checked(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
  return {H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose};
}

}  // namespace

void Hdf5File::make_slices(const std::string& name, const std::vector<std::size_t>& shape, Number number,
                           const std::string& unit) {
  attempt(name, "can't be written; is the disk full?", [&] {
    Hdf5Shape chunk(shape.begin(), shape.end());
    chunk.front() = 1;
    const Hdf5Id creation = hdf5_dataset_creation();
    hdf5_checked(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()));
    const Hdf5Id type =
        number == Number::complex ? float_complex_type() : Hdf5Id(H5Tcopy(H5T_NATIVE_FLOAT), H5Tclose);
    handle_->make(name, type, {shape.begin(), shape.end()}, creation, unit).close();
  });
}

void Hdf5File::write_slice(const std::string& name, std::size_t index,
                           const std::vector<std::complex<float>>& values) {
  attempt(name, "slice " + std::to_string(index) + " can't be written; is the disk full?", [&] {
    Hdf5Id set = handle_->dataset(name);
    const Hdf5Id inside = space_of(set);
    const Hdf5Id slice = select_slice(inside, index);
    if (is_compound(set)) {
      hdf5_checked(H5Dwrite(set, float_complex_type(), slice, inside, H5P_DEFAULT, values.data()));
    } else {
      std::vector<float> real(values.size());
      std::transform(values.begin(), values.end(), real.begin(), [](std::complex<float> v) { return v.real(); });
      hdf5_checked(H5Dwrite(set, H5T_NATIVE_FLOAT, slice, inside, H5P_DEFAULT, real.data()));
    }
    set.close();  // writes the chunk
  });
}

std::vector<std::complex<float>> Hdf5File::read_slice(const std::string& name, std::size_t index) const {
  if (!exists(name)) fail(name, "is missing");
  std::vector<std::complex<float>> values;
  attempt(name, "slice " + std::to_string(index) + " can't be read as real or {r, i} numbers", [&] {
    const Hdf5Id set = handle_->dataset(name);
    const Hdf5Id inside = space_of(set);
    const Hdf5Id slice = select_slice(inside, index);
    values.resize(static_cast<std::size_t>(hdf5_checked(H5Sget_simple_extent_npoints(slice))));
    if (is_compound(set)) {
      hdf5_checked(H5Dread(set, float_complex_type(), slice, inside, H5P_DEFAULT, values.data()));
    } else {
      std::vector<float> real(values.size());
      hdf5_checked(H5Dread(set, H5T_NATIVE_FLOAT, slice, inside, H5P_DEFAULT, real.data()));
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
    const Hdf5Id set = handle_->dataset(name);
    hdf5_filled_count(set);
    const Hdf5Shape shape = hdf5_extents(space_of(set));
    return {shape.begin(), shape.end()};
  });
}

}  // namespace tiprub
