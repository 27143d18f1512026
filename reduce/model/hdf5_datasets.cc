// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

constexpr const char* unwritable = "can't be written; is the disk full?";

template <class Scalar>
using RowMajor = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// "3 x 4", "scalar".
template <class Shape>
std::string shape_text(const Shape& shape) {
  const std::string words = listed(shape, " x ", [](auto extent) { return std::to_string(extent); });
  return words.empty() ? "scalar" : words;
}

H5T_class_t class_of(hid_t set) {
  return H5Tget_class(Hdf5Id(H5Dget_type(set), H5Tclose));
}

Hdf5Id space_of(hid_t set) {
  return {H5Dget_space(set), H5Sclose};
}

/// The number of values of a dataset. Raises std::bad_alloc if they are more than the machine could hold, because a
/// damaged dataset may have any shape.
std::size_t affordable_count(hid_t set, std::size_t bytes_each) {
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  const double count = hdf5_filled_count(set);
  if (count * static_cast<double>(bytes_each) > memory) throw std::bad_alloc();
  return static_cast<std::size_t>(count);
}

void read_all(hid_t set, hid_t type, void* values) {
  hdf5_checked(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
}

bool has_real_member(hid_t type, unsigned place, const std::string& wanted) {
  char* const name = H5Tget_member_name(type, place);
  const bool named_so = name != nullptr && name == wanted;
  H5free_memory(name);
  return named_so && H5Tget_member_class(type, place) == H5T_FLOAT;
}

/// Must be known before reading: HDF5 fills members of the same names, and leaves the others as they were.
bool is_complex(hid_t set) {
  const Hdf5Id type(H5Dget_type(set), H5Tclose);
  return H5Tget_nmembers(type) == 2 && has_real_member(type, 0, "r") && has_real_member(type, 1, "i");
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

Hdf5Id hdf5_packed_creation(hid_t type, const Hdf5Shape& shape) {
  constexpr hsize_t least = 4096;  // bytes; a smaller dataset would lose more by a chunk's table than it gains
  constexpr hsize_t chunk_size = hsize_t{1} << 20;  // bytes: HDF5's cache holds one
  constexpr unsigned fastest = 1;                   // higher levels gain a fiftieth
  Hdf5Id creation = hdf5_dataset_creation();
  hsize_t row = H5Tget_size(type);
  for (std::size_t i = 1; i < shape.size(); ++i) row *= shape[i];
  const bool text = H5Tget_class(type) == H5T_STRING;  // stands elsewhere in the file; the dataset holds pointers
  if (text || shape.empty() || row * shape.front() < least) return creation;
  const hsize_t chunks = std::min((row * shape.front() + chunk_size - 1) / chunk_size, shape.front());
  Hdf5Shape chunk = shape;
  chunk.front() = (shape.front() + chunks - 1) / chunks;
  hdf5_checked(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()));
  hdf5_checked(H5Pset_shuffle(creation));
  hdf5_checked(H5Pset_deflate(creation, fastest));
  return creation;
}

Hdf5Id Hdf5File::Handle::named(const std::string& name, Hdf5Id type) const {
  if (hdf5_checked(H5Lexists(file, name.c_str(), H5P_DEFAULT)) > 0)
    return {H5Topen2(file, name.c_str(), H5P_DEFAULT), H5Tclose};
  const Hdf5Id creation(H5Pcreate(H5P_DATATYPE_CREATE), H5Pclose);
  hdf5_checked(H5Pset_obj_track_times(creation, false));
  hdf5_checked(H5Tcommit2(file, name.c_str(), type, H5P_DEFAULT, creation, H5P_DEFAULT));
  return type;
}

void Hdf5File::Handle::write_texts(const std::string& name, const Hdf5Shape& shape,
                                   const std::vector<const char*>& texts) const {
  const Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  hdf5_checked(H5Tset_size(type, H5T_VARIABLE));
  write(name, type, shape, texts.data(), "");
}

void Hdf5File::write(const std::string& name, const Array<double>& array, const std::string& unit) {
  attempt(name, unwritable, [&] {
    handle_->write(name, H5T_NATIVE_DOUBLE, {array.shape.begin(), array.shape.end()}, array.values.data(), unit);
  });
}

void Hdf5File::write(const std::string& name, const Array<std::int32_t>& array, const std::string& unit) {
  attempt(name, unwritable, [&] {
    handle_->write(name, H5T_NATIVE_INT32, {array.shape.begin(), array.shape.end()}, array.values.data(), unit);
  });
}

void Hdf5File::write(const std::string& name, const Eigen::MatrixXd& matrix, const std::string& unit) {
  const RowMajor<double> rows = matrix;
  attempt(name, unwritable, [&] {
    handle_->write(name, H5T_NATIVE_DOUBLE, {static_cast<hsize_t>(rows.rows()), static_cast<hsize_t>(rows.cols())},
                   rows.data(), unit);
  });
}

void Hdf5File::write(const std::string& name, const Eigen::VectorXd& vector, const std::string& unit) {
  attempt(name, unwritable, [&] {
    handle_->write(name, H5T_NATIVE_DOUBLE, {static_cast<hsize_t>(vector.size())}, vector.data(), unit);
  });
}

void Hdf5File::write(const std::string& name, const Eigen::MatrixXcd& matrix, const std::string& unit) {
  const RowMajor<std::complex<double>> rows = matrix;
  const Hdf5Shape shape = {static_cast<hsize_t>(matrix.rows()), static_cast<hsize_t>(matrix.cols())};
  attempt(name, unwritable, [&] {
    Hdf5Id type = hdf5_complex_type<double>();
    if (handle_->storage != Storage::plain) type = handle_->named("/complex", std::move(type));
    handle_->write(name, type, shape, rows.data(), unit);
  });
}

void Hdf5File::write(const std::string& name, const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  for (const std::string& text : texts) pointers.push_back(text.c_str());
  attempt(name, unwritable, [&] { handle_->write_texts(name, {texts.size()}, pointers); });
}

void Hdf5File::write_text(const std::string& name, const std::string& text) {
  attempt(name, unwritable, [&] {
    if (handle_->storage == Storage::plain)
      handle_->write(name, hdf5_text_type(text), {}, text.c_str(), "text");
    else
      handle_->write_texts(name, {}, {text.c_str()});
  });
}

bool Hdf5File::has_text(const std::string& name) const {
  const std::filesystem::path path(name);
  return exists(name) || has_attribute(path.parent_path().string(), path.filename().string());
}

std::string Hdf5File::read_text(const std::string& name) const {
  const std::filesystem::path path(name);
  if (!exists(name)) return text_attribute(path.parent_path().string(), path.filename().string());
  return attempt(name, "can't be read as a text", [&] {
    const Hdf5Id set = handle_->dataset(name);
    const Hdf5Id text(H5Dget_type(set), H5Tclose);
    if (affordable_count(set, H5Tget_size(text)) != 1) throw Hdf5Failure();
    return hdf5_read_text(
        text, [&](hid_t type, void* to) { return H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to); });
  });
}

Array<double> Hdf5File::read_array(const std::string& name) const {
  if (!exists(name)) fail(name, "is missing");
  Array<double> array;
  attempt(name, "can't be read as an array of numbers", [&] {
    const Hdf5Id set = handle_->dataset(name);
    if (class_of(set) != H5T_FLOAT && class_of(set) != H5T_INTEGER) fail(name, "is not real numbers");
    const Hdf5Shape shape = hdf5_extents(space_of(set));
    array.shape.assign(shape.begin(), shape.end());
    array.values.resize(affordable_count(set, sizeof(double)));
    if (!array.values.empty()) read_all(set, H5T_NATIVE_DOUBLE, array.values.data());
  });
  const auto bad = std::ranges::find_if(array.values, [](double v) { return !std::isfinite(v); });
  if (bad != array.values.end())
    fail(name, "value " + std::to_string(bad - array.values.begin()) + " (row-major, from 0) is not finite");
  return array;
}

Array<std::int32_t> Hdf5File::read_integers(const std::string& name) const {
  const Array<double> array = read_array(name);
  for (const double value : array.values)
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<std::int32_t>::max())
      fail(name, "has a value that is not a whole number within +-2^31");
  return {array.shape, {array.values.begin(), array.values.end()}};
}

Eigen::MatrixXd Hdf5File::read_matrix(const std::string& name) const {
  const Array<double> array = read_array(name);
  if (array.shape.size() != 2) fail(name, "has shape " + shape_text(array.shape) + ", must have two axes");
  return Eigen::Map<const RowMajor<double>>(array.values.data(), static_cast<Eigen::Index>(array.shape[0]),
                                            static_cast<Eigen::Index>(array.shape[1]));
}

Eigen::VectorXd Hdf5File::read_vector(const std::string& name) const {
  const Array<double> array = read_array(name);
  if (array.shape.size() != 1) fail(name, "has shape " + shape_text(array.shape) + ", must have one axis");
  return Eigen::Map<const Eigen::VectorXd>(array.values.data(), static_cast<Eigen::Index>(array.values.size()));
}

Eigen::MatrixXcd Hdf5File::read_complex_matrix(const std::string& name) const {
  if (!exists(name)) fail(name, "is missing");
  RowMajor<std::complex<double>> matrix;
  attempt(name, "can't be read as a complex matrix", [&] {
    const Hdf5Id set = handle_->dataset(name);
    if (class_of(set) != H5T_COMPOUND) {
      matrix = read_matrix(name).cast<std::complex<double>>();
      return;
    }
    if (!is_complex(set)) fail(name, "has compound members that are not r and i, floating-point numbers both");
    const Hdf5Shape shape = hdf5_extents(space_of(set));
    if (shape.size() != 2) fail(name, "has shape " + shape_text(shape) + ", must have two axes");
    affordable_count(set, sizeof(std::complex<double>));
    matrix.resize(static_cast<Eigen::Index>(shape[0]), static_cast<Eigen::Index>(shape[1]));
    if (matrix.size() > 0) read_all(set, hdf5_complex_type<double>(), matrix.data());
  });
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      if (!std::isfinite(matrix(row, column).real()) || !std::isfinite(matrix(row, column).imag()))
        fail(name, "row " + std::to_string(row) + ", column " + std::to_string(column) + " is not finite");
  return matrix;
}

void Hdf5File::make_slices(const std::string& name, const std::vector<std::size_t>& shape, Number number,
                           const std::string& unit) {
  attempt(name, unwritable, [&] {
    Hdf5Shape chunk(shape.begin(), shape.end());
    chunk.front() = 1;
    const Hdf5Id creation = hdf5_dataset_creation();
    hdf5_checked(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()));
    hdf5_checked(H5Pset_fletcher32(creation));
    const Hdf5Id type =
        number == Number::complex ? hdf5_complex_type<float>() : Hdf5Id(H5Tcopy(H5T_NATIVE_FLOAT), H5Tclose);
    handle_->make(name, type, {shape.begin(), shape.end()}, creation, unit).close();
  });
}

void Hdf5File::write_slice(const std::string& name, std::size_t index,
                           const std::vector<std::complex<float>>& values) {
  attempt(name, "slice " + std::to_string(index) + " can't be written; is the disk full?", [&] {
    Hdf5Id set = handle_->dataset(name);
    const Hdf5Id inside = space_of(set);
    const Hdf5Id slice = select_slice(inside, index);
    if (class_of(set) == H5T_COMPOUND) {
      hdf5_checked(H5Dwrite(set, hdf5_complex_type<float>(), slice, inside, H5P_DEFAULT, values.data()));
    } else {
      std::vector<float> real(values.size());
      std::transform(values.begin(), values.end(), real.begin(), [](std::complex<float> v) { return v.real(); });
      hdf5_checked(H5Dwrite(set, H5T_NATIVE_FLOAT, slice, inside, H5P_DEFAULT, real.data()));
    }
    set.close();  // writes the chunk
  });
}

void Hdf5File::read_slice(const std::string& name, std::size_t index, Eigen::Ref<Eigen::VectorXcf> values,
                          Check check) const {
  if (!exists(name)) fail(name, "is missing");
  attempt(name, "slice " + std::to_string(index) + " is damaged, or holds neither real nor {r, i} numbers", [&] {
    const Hdf5Id set = handle_->dataset(name);
    const Hdf5Id inside = space_of(set);
    const Hdf5Id slice = select_slice(inside, index);
    if (hdf5_checked(H5Sget_simple_extent_npoints(slice)) != values.size()) throw Hdf5Failure();
    const Hdf5Id transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
    if (check == Check::before) hdf5_checked(H5Pset_edc_check(transfer, H5Z_DISABLE_EDC));
    if (class_of(set) == H5T_COMPOUND) {
      hdf5_checked(H5Dread(set, hdf5_complex_type<float>(), slice, inside, transfer, values.data()));
    } else {
      Eigen::VectorXf real(values.size());
      hdf5_checked(H5Dread(set, H5T_NATIVE_FLOAT, slice, inside, transfer, real.data()));
      values = real.cast<std::complex<float>>();
    }
  });
  if (check == Check::full && !values.allFinite())
    fail(name, "slice " + std::to_string(index) + " has a value that is not finite");
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
