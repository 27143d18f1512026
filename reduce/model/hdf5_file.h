// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <complex>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cases/program/errors.h"
#include "cases/program/named_values.h"
#include "cases/program/text.h"

namespace tiprub {

/// An array as it lies in a file: row-major values and their shape.
template <class Value>
struct Array {
  std::vector<std::size_t> shape;
  std::vector<Value> values;
};

/// A facade of HDF5 for the files between the stages. Names are absolute paths inside the file ("/contact/position");
/// groups on the way are made as needed. The same content gives the same bytes, because object times are off. All
/// functions raise RunError with "file: dataset: what is wrong".
class Hdf5File {
 public:
  /// How a file's datasets are stored.
  enum class Storage {
    plain,            ///< contiguous; the unit is the attribute `unit`
    netcdf,           ///< as netCDF-4 tools expect: large ones in chunks, shuffled and deflated; the unit is `units`
    netcdf_unpacked,  ///< the same, contiguous, for files that are soon read and removed
  };
  static Hdf5File create(const std::filesystem::path& path, Storage storage = Storage::plain);
  enum class Bytes {
    unknown,     ///< HDF5 may die of them, or never come to an end: another process reads the file first
    as_written,  ///< a digest shows that they are those that this project wrote
  };
  static Hdf5File open(const std::filesystem::path& path, Bytes bytes = Bytes::unknown);
  ~Hdf5File();
  Hdf5File(Hdf5File&&) noexcept;
  Hdf5File& operator=(Hdf5File&&) noexcept;
  /// Writes what HDF5 still holds back. It must be a writer's last step, because destructors can't report a full
  /// disk. Raises RunError.
  void close();

  /// Attributes of a group or dataset; "/" is the file itself.
  void set_attribute(const std::string& object, const std::string& name, const std::string& value);
  void set_attribute(const std::string& object, const std::string& name, double value);
  void set_attribute(const std::string& object, const std::string& name, int value);
  std::string text_attribute(const std::string& object, const std::string& name) const;
  double number_attribute(const std::string& object, const std::string& name) const;
  int integer_attribute(const std::string& object, const std::string& name) const;
  bool has_attribute(const std::string& object, const std::string& name) const;
  /// The value of an enumeration that an attribute names.
  template <class Value, std::size_t count>
  Value named_attribute(const std::string& object, const std::string& name,
                        const NamedValues<Value, count>& names) const {
    return value_named(names, text_attribute(object, name),
                       path_ + (object == "/" ? "" : ": " + object) + ": attribute " + name);
  }

  /// Writes a text of any length as a dataset, because an attribute holds only 64 KB.
  void write_text(const std::string& name, const std::string& text);
  /// A text that write_text() wrote, or, in older files, the attribute of that name of its group.
  std::string read_text(const std::string& name) const;
  bool has_text(const std::string& name) const;

  /// Every dataset carries its unit ("m", "N", "1") as the attribute `unit`, or `units`.
  void write(const std::string& name, const Eigen::MatrixXd& matrix, const std::string& unit);
  void write(const std::string& name, const Eigen::MatrixXcd& matrix, const std::string& unit);
  void write(const std::string& name, const Eigen::VectorXd& vector, const std::string& unit);
  void write(const std::string& name, const Array<double>& array, const std::string& unit);
  void write(const std::string& name, const Array<std::int32_t>& array, const std::string& unit);
  /// Texts along one axis.
  void write(const std::string& name, const std::vector<std::string>& texts);

  /// Makes a dataset of one axis the coordinate of that axis (a dimension scale), under the dataset's name.
  void make_axis(const std::string& name);
  /// Tells what a dataset is, in words, and its axes by the datasets that make_axis() was told, slowest first.
  void describe(const std::string& name, const std::string& long_name, const std::vector<std::string>& axes = {});

  /// Large single-precision datasets go in and out one slice at a time, the first index of `shape`; each slice is a
  /// chunk of its own in the file, with a checksum. Complex ones are {r, i} compounds of float32.
  enum class Number { real, complex };
  void make_slices(const std::string& name, const std::vector<std::size_t>& shape, Number number,
                   const std::string& unit);
  /// For real slices the imaginary parts are ignored.
  void write_slice(const std::string& name, std::size_t index, const std::vector<std::complex<float>>& values);
  enum class Check {
    full,    ///< the checksum, and whether all values are finite
    before,  ///< none: the slice was read with a full check before
  };
  /// As many values as the slice has.
  void read_slice(const std::string& name, std::size_t index, Eigen::Ref<Eigen::VectorXcf> values,
                  Check check = Check::full) const;
  std::vector<std::size_t> shape_of(const std::string& name) const;

  bool exists(const std::string& name) const;
  /// Names of the objects in a group, sorted.
  std::vector<std::string> members(const std::string& group) const;

  /// Readers refuse values that are not finite, and say where the first one is.
  Eigen::MatrixXd read_matrix(const std::string& name) const;
  /// A real dataset or one of {r, i} compounds.
  Eigen::MatrixXcd read_complex_matrix(const std::string& name) const;
  Eigen::VectorXd read_vector(const std::string& name) const;
  Array<double> read_array(const std::string& name) const;
  Array<std::int32_t> read_integers(const std::string& name) const;

  /// Writes or checks the root attributes `schema`, `schema_version` and `generator`.
  void set_schema(const std::string& schema, int version, const std::string& generator);
  void require_schema(const std::string& schema, int version) const;

  const std::string& path() const { return path_; }
  /// Raises FileError: the path, and the parts of a message one after another.
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... message) const {
    throw FileError(text_of(path_, ": ", message...));
  }

 private:
  struct Handle;
  Hdf5File(std::string path, std::unique_ptr<Handle> handle);
  /// Calls `body`; a failure of HDF5 becomes a RunError with this complaint.
  template <class Body>
  auto attempt(const std::string& object, const std::string& complaint, const Body& body) const;
  [[noreturn]] void fail(const std::string& object, const std::string& what) const;

  std::string path_;
  std::unique_ptr<Handle> handle_;
};

}  // namespace tiprub
