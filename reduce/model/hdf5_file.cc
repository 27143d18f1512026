// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/hdf5_file.h"

#include <H5Cpp.h>

#include <algorithm>
#include <cmath>
#include <complex>

namespace tiprub {

namespace {

using Shape = std::vector<hsize_t>;

/// h5py's convention for complex numbers.
H5::CompType complex_type() {
  H5::CompType type(2 * sizeof(double));
  type.insertMember("r", 0, H5::PredType::NATIVE_DOUBLE);
  type.insertMember("i", sizeof(double), H5::PredType::NATIVE_DOUBLE);
  return type;
}

H5::CompType single_complex_type() {
  H5::CompType type(2 * sizeof(float));
  type.insertMember("r", 0, H5::PredType::NATIVE_FLOAT);
  type.insertMember("i", sizeof(float), H5::PredType::NATIVE_FLOAT);
  return type;
}

H5::DSetCreatPropList plain_creation() {
  H5::DSetCreatPropList list;
  H5Pset_obj_track_times(list.getId(), false);
  return list;
}

Shape extents(const H5::DataSpace& space) {
  Shape shape(space.getSimpleExtentNdims());
  space.getSimpleExtentDims(shape.data());
  return shape;
}

std::size_t product(const Shape& shape) {
  std::size_t count = 1;
  for (hsize_t extent : shape) count *= extent;
  return count;
}

std::string text(const Shape& shape) {
  std::string words;
  for (hsize_t extent : shape) words += (words.empty() ? "" : " x ") + std::to_string(extent);
  return words.empty() ? "scalar" : words;
}

}  // namespace

struct Hdf5File::Handle {
  H5::H5File file;

  void make_groups(const std::string& name) const {
    for (std::size_t at = name.find('/', 1); at != std::string::npos; at = name.find('/', at + 1))
      if (const std::string group = name.substr(0, at); !file.nameExists(group)) file.createGroup(group);
  }
  H5::DataSet make(const std::string& name, const H5::DataType& type, const Shape& shape,
                   const H5::DSetCreatPropList& creation, const std::string& unit) const {
    make_groups(name);
    const H5::DataSet set =
        file.createDataSet(name, type, H5::DataSpace(static_cast<int>(shape.size()), shape.data()), creation);
    const H5::StrType string_type(H5::PredType::C_S1, std::max<std::size_t>(unit.size(), 1));
    set.createAttribute("unit", string_type, H5::DataSpace(H5S_SCALAR)).write(string_type, unit);
    return set;
  }
  void write(const std::string& name, const H5::DataType& type, const Shape& shape, const void* data,
             const std::string& unit) const {
    const H5::DataSet set = make(name, type, shape, plain_creation(), unit);
    if (product(shape) > 0) set.write(data, type);
  }
  /// Selects one slice of a dataset's space; the space of the slice alone.
  H5::DataSpace select_slice(H5::DataSpace& space, std::size_t index) const {
    Shape count = extents(space);
    Shape start(count.size(), 0);
    start.front() = index;
    count.front() = 1;
    space.selectHyperslab(H5S_SELECT_SET, count.data(), start.data());
    return H5::DataSpace(static_cast<int>(count.size()), count.data());
  }
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
  void set_attribute(const std::string& object, const std::string& name, const H5::DataType& type,
                     const void* value) const {
    if (object != "/") make_groups(object + "/");
    with_attributes(object, [&](const H5::H5Object& at) {
      at.createAttribute(name, type, H5::DataSpace(H5S_SCALAR)).write(type, value);
    });
  }
};

Hdf5File::Hdf5File(std::string path, std::unique_ptr<Handle> handle)
    : path_(std::move(path)), handle_(std::move(handle)) {}
Hdf5File::~Hdf5File() = default;
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;

void Hdf5File::fail(const std::string& object, const std::string& what) const {
  throw RunError(path_ + ": " + object + ": " + what);
}

template <class Body>
auto Hdf5File::attempt(const std::string& object, const std::string& complaint, const Body& body) const {
  try {
    return body();
  } catch (const H5::Exception&) {
    fail(object, complaint);
  }
}

Hdf5File Hdf5File::create(const std::filesystem::path& path) {
  H5::Exception::dontPrint();
  try {
    return {path.string(), std::make_unique<Handle>(Handle{H5::H5File(path.string(), H5F_ACC_TRUNC)})};
  } catch (const H5::Exception&) {
    throw RunError(path.string() + ": can't be written");
  }
}

Hdf5File Hdf5File::open(const std::filesystem::path& path) {
  H5::Exception::dontPrint();
  if (!std::filesystem::exists(path)) throw RunError(path.string() + ": no such file");
  try {
    return {path.string(), std::make_unique<Handle>(Handle{H5::H5File(path.string(), H5F_ACC_RDONLY)})};
  } catch (const H5::Exception&) {
    throw RunError(path.string() + ": is not an HDF5 file, or is damaged");
  }
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& value) {
  attempt(object, "attribute " + name + " can't be written", [&] {
    handle_->set_attribute(object, name, H5::StrType(H5::PredType::C_S1, std::max<std::size_t>(value.size(), 1)),
                           value.c_str());
  });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  attempt(object, "attribute " + name + " can't be written",
          [&] { handle_->set_attribute(object, name, H5::PredType::NATIVE_DOUBLE, &value); });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, int value) {
  attempt(object, "attribute " + name + " can't be written",
          [&] { handle_->set_attribute(object, name, H5::PredType::NATIVE_INT, &value); });
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  std::string value;
  attempt(object, "has no text attribute " + name, [&] {
    handle_->with_attributes(object, [&](const H5::H5Object& at) {
      const H5::Attribute attribute = at.openAttribute(name);
      attribute.read(attribute.getStrType(), value);
    });
  });
  return value.substr(0, value.find('\0'));
}

double Hdf5File::number_attribute(const std::string& object, const std::string& name) const {
  double value = 0.0;
  attempt(object, "has no number attribute " + name, [&] {
    handle_->with_attributes(
        object, [&](const H5::H5Object& at) { at.openAttribute(name).read(H5::PredType::NATIVE_DOUBLE, &value); });
  });
  if (!std::isfinite(value)) fail(object, "attribute " + name + " is not finite");
  return value;
}

int Hdf5File::integer_attribute(const std::string& object, const std::string& name) const {
  const double value = number_attribute(object, name);
  if (value != std::floor(value)) fail(object, "attribute " + name + " is not a whole number");
  return static_cast<int>(value);
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  bool found = false;
  try {
    handle_->with_attributes(object, [&](const H5::H5Object& at) { found = at.attrExists(name); });
  } catch (const H5::Exception&) {
    return false;
  }
  return found;
}

void Hdf5File::write(const std::string& name, const Array<double>& array, const std::string& unit) {
  attempt(name, "can't be written", [&] {
    handle_->write(name, H5::PredType::NATIVE_DOUBLE, Shape(array.shape.begin(), array.shape.end()),
                   array.values.data(), unit);
  });
}

void Hdf5File::write(const std::string& name, const Array<std::int32_t>& array, const std::string& unit) {
  attempt(name, "can't be written", [&] {
    handle_->write(name, H5::PredType::NATIVE_INT32, Shape(array.shape.begin(), array.shape.end()),
                   array.values.data(), unit);
  });
}

void Hdf5File::write(const std::string& name, const Eigen::MatrixXd& matrix, const std::string& unit) {
  const Eigen::MatrixXd transposed = matrix.transpose();  // row-major in the file
  write(name,
        Array<double>{{static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols())},
                      {transposed.data(), transposed.data() + transposed.size()}},
        unit);
}

void Hdf5File::write(const std::string& name, const Eigen::VectorXd& vector, const std::string& unit) {
  write(name,
        Array<double>{{static_cast<std::size_t>(vector.size())}, {vector.data(), vector.data() + vector.size()}},
        unit);
}

void Hdf5File::write(const std::string& name, const Eigen::MatrixXcd& matrix, const std::string& unit) {
  const Eigen::MatrixXcd transposed = matrix.transpose();
  attempt(name, "can't be written", [&] {
    handle_->write(name, complex_type(), {static_cast<hsize_t>(matrix.rows()), static_cast<hsize_t>(matrix.cols())},
                   transposed.data(), unit);
  });
}

void Hdf5File::make_slices(const std::string& name, const std::vector<std::size_t>& shape, Number number,
                           const std::string& unit) {
  attempt(name, "can't be written", [&] {
    Shape chunk(shape.begin(), shape.end());
    chunk.front() = 1;
    H5::DSetCreatPropList creation = plain_creation();
    creation.setChunk(static_cast<int>(chunk.size()), chunk.data());
    const H5::DataType type =
        number == Number::complex ? H5::DataType(single_complex_type()) : H5::DataType(H5::PredType::NATIVE_FLOAT);
    handle_->make(name, type, Shape(shape.begin(), shape.end()), creation, unit);
  });
}

void Hdf5File::write_slice(const std::string& name, std::size_t index,
                           const std::vector<std::complex<float>>& values) {
  attempt(name, "slice " + std::to_string(index) + " can't be written", [&] {
    const H5::DataSet set = handle_->file.openDataSet(name);
    H5::DataSpace inside = set.getSpace();
    const H5::DataSpace slice = handle_->select_slice(inside, index);
    if (set.getTypeClass() == H5T_COMPOUND) {
      set.write(values.data(), single_complex_type(), slice, inside);
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
    const H5::DataSpace slice = handle_->select_slice(inside, index);
    values.resize(static_cast<std::size_t>(slice.getSimpleExtentNpoints()));
    if (set.getTypeClass() == H5T_COMPOUND) {
      set.read(values.data(), single_complex_type(), slice, inside);
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
    const Shape shape = extents(handle_->file.openDataSet(name).getSpace());
    return {shape.begin(), shape.end()};
  });
}

bool Hdf5File::exists(const std::string& name) const {
  for (std::size_t at = name.find('/', 1);; at = name.find('/', at + 1)) {
    if (!handle_->file.nameExists(name.substr(0, at))) return false;
    if (at == std::string::npos) return true;
  }
}

std::vector<std::string> Hdf5File::members(const std::string& group) const {
  if (!exists(group)) fail(group, "is missing");
  std::vector<std::string> names;
  const H5::Group at = handle_->file.openGroup(group);
  for (hsize_t i = 0; i < at.getNumObjs(); ++i) names.push_back(at.getObjnameByIdx(i));
  std::sort(names.begin(), names.end());
  return names;
}

Array<double> Hdf5File::read_array(const std::string& name) const {
  if (!exists(name)) fail(name, "is missing");
  Array<double> array;
  attempt(name, "can't be read as an array of numbers", [&] {
    const H5::DataSet set = handle_->file.openDataSet(name);
    const Shape shape = extents(set.getSpace());
    array.shape.assign(shape.begin(), shape.end());
    array.values.resize(product(shape));
    if (set.getTypeClass() != H5T_FLOAT && set.getTypeClass() != H5T_INTEGER) fail(name, "is not real numbers");
    if (!array.values.empty()) set.read(array.values.data(), H5::PredType::NATIVE_DOUBLE);
  });
  const auto bad = std::find_if(array.values.begin(), array.values.end(), [](double v) { return !std::isfinite(v); });
  if (bad != array.values.end())
    fail(name, "value " + std::to_string(bad - array.values.begin()) + " (row-major, from 0) is not finite");
  return array;
}

Array<std::int32_t> Hdf5File::read_integers(const std::string& name) const {
  const Array<double> array = read_array(name);
  return {array.shape, {array.values.begin(), array.values.end()}};
}

Eigen::MatrixXd Hdf5File::read_matrix(const std::string& name) const {
  const Array<double> array = read_array(name);
  if (array.shape.size() != 2)
    fail(name, "has shape " + text({array.shape.begin(), array.shape.end()}) + ", must have two axes");
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const RowMajor>(array.values.data(), array.shape[0], array.shape[1]);
}

Eigen::VectorXd Hdf5File::read_vector(const std::string& name) const {
  const Array<double> array = read_array(name);
  if (array.shape.size() != 1)
    fail(name, "has shape " + text({array.shape.begin(), array.shape.end()}) + ", must have one axis");
  return Eigen::Map<const Eigen::VectorXd>(array.values.data(), array.values.size());
}

Eigen::MatrixXcd Hdf5File::read_complex_matrix(const std::string& name) const {
  if (!exists(name)) fail(name, "is missing");
  using RowMajor = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  RowMajor matrix;
  attempt(name, "can't be read as a complex matrix; members must be r and i", [&] {
    const H5::DataSet set = handle_->file.openDataSet(name);
    if (set.getTypeClass() != H5T_COMPOUND) {
      matrix = read_matrix(name).cast<std::complex<double>>();
      return;
    }
    const Shape shape = extents(set.getSpace());
    if (shape.size() != 2) fail(name, "has shape " + text(shape) + ", must have two axes");
    matrix.resize(static_cast<Eigen::Index>(shape[0]), static_cast<Eigen::Index>(shape[1]));
    if (matrix.size() > 0) set.read(matrix.data(), complex_type());
  });
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
      if (!std::isfinite(matrix(row, column).real()) || !std::isfinite(matrix(row, column).imag()))
        fail(name, "row " + std::to_string(row) + ", column " + std::to_string(column) + " is not finite");
  return matrix;
}

void Hdf5File::set_schema(const std::string& schema, int version, const std::string& generator) {
  set_attribute("/", "schema", schema);
  set_attribute("/", "schema_version", version);
  set_attribute("/", "generator", generator);
}

void Hdf5File::require_schema(const std::string& schema, int version) const {
  if (!has_attribute("/", "schema"))
    throw RunError(path_ + ": has no schema; expected " + schema + " version " + std::to_string(version));
  const std::string found = text_attribute("/", "schema");
  const int found_version = has_attribute("/", "schema_version") ? integer_attribute("/", "schema_version") : 0;
  if (found != schema || found_version != version)
    throw RunError(path_ + ": is " + found + " version " + std::to_string(found_version) + ", expected " + schema +
                   " version " + std::to_string(version));
}

}  // namespace tiprub
