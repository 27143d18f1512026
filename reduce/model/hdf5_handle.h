// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "reduce/model/hdf5_file.h"

// Shared by the facade's own .cc files only, so that HDF5's headers reach no other code.
namespace tiprub {

using Hdf5Shape = std::vector<hsize_t>;

/// A call of HDF5 that failed. Hdf5File::attempt() adds what was tried.
class Hdf5Failure : public std::exception {
 public:
  const char* what() const noexcept override { return "HDF5 failed"; }
};

/// Passes on what a call of HDF5 returned (an id, a count, a truth value). Raises Hdf5Failure if the call failed.
template <class Result>
Result hdf5_checked(Result result) {
  if (result < 0) throw Hdf5Failure();
  return result;
}

/// An open object of HDF5. Its destructor can't report a full disk, so an object that was written to is closed by
/// close().
class Hdf5Id {
 public:
  using Close = herr_t (*)(hid_t);

  /// Raises Hdf5Failure if there is no such object.
  Hdf5Id(hid_t id, Close how) : id_(hdf5_checked(id)), close_(how) {}
  Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Hdf5Id& operator=(Hdf5Id&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5Id() {
    if (id_ >= 0) close_(id_);
  }

  /// Raises Hdf5Failure if HDF5 still held something back and can't write it; the object is closed in any case.
  void close() { hdf5_checked(close_(std::exchange(id_, H5I_INVALID_HID))); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// h5py's convention for complex numbers, {r, i}.
template <class Real>
Hdf5Id hdf5_complex_type() {
  const hid_t real = std::is_same_v<Real, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT;
  Hdf5Id type(H5Tcreate(H5T_COMPOUND, 2 * sizeof(Real)), H5Tclose);
  hdf5_checked(H5Tinsert(type, "r", 0, real));
  hdf5_checked(H5Tinsert(type, "i", sizeof(Real), real));
  return type;
}

Hdf5Shape hdf5_extents(hid_t space);
/// How many values a dataset has. Raises std::length_error if they are more than the file can hold, because HDF5
/// returns zeros, maybe terabytes of them, for values that were never written.
double hdf5_filled_count(hid_t set);
/// Adds an attribute of one value or one text, which the object must not have yet.
void hdf5_add_attribute(hid_t object, const std::string& name, hid_t type, const void* value);
void hdf5_add_attribute(hid_t object, const std::string& name, const std::string& text);
/// The type of a text of fixed length.
Hdf5Id hdf5_text_type(const std::string& text);
/// A text of that type, of fixed or variable length, as far as the first zero byte; `read(type, buffer)` reads it.
template <class Read>
std::string hdf5_read_text(hid_t type, const Read& read) {
  if (H5Tget_class(type) != H5T_STRING) throw Hdf5Failure();
  if (hdf5_checked(H5Tis_variable_str(type)) > 0) {
    char* text = nullptr;
    hdf5_checked(read(type, static_cast<void*>(&text)));
    const std::string value = text == nullptr ? "" : text;
    H5free_memory(text);
    return value;
  }
  std::string value(H5Tget_size(type), '\0');
  hdf5_checked(read(type, static_cast<void*>(value.data())));
  return value.substr(0, value.find('\0'));
}

struct Hdf5File::Handle {
  Hdf5Id file;
  Storage storage = Storage::plain;

  /// A group or a dataset; "/" is the file itself.
  Hdf5Id object(const std::string& name) const { return {H5Oopen(file, name.c_str(), H5P_DEFAULT), H5Oclose}; }
  Hdf5Id dataset(const std::string& name) const { return {H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose}; }
  void make_groups(const std::string& name) const;
  /// Adds an attribute to an object, which is made a group if it isn't there.
  void add_attribute(const std::string& object, const std::string& name, hid_t type, const void* value) const;
  /// The type that the file has under a name; it is added if it isn't there. netCDF ignores compounds without a name.
  Hdf5Id named(const std::string& name, Hdf5Id type) const;
  /// Makes a new dataset without values, and without an attribute for the unit if that is empty.
  Hdf5Id make(const std::string& name, hid_t type, const Hdf5Shape& shape, hid_t creation,
              const std::string& unit) const;
  /// Makes a dataset, writes all its values and closes it.
  void write(const std::string& name, hid_t type, const Hdf5Shape& shape, const void* values,
             const std::string& unit) const;
  /// Writes texts of variable length; netCDF crashes on texts of fixed length.
  void write_texts(const std::string& name, const Hdf5Shape& shape, const std::vector<const char*>& texts) const;
};

/// Reads, in a process of its own, all that a reader may read: HDF5 follows damaged tables wherever they point, and
/// may crash. Raises RunError if it does. What HDF5 itself refuses is left to the reader.
void hdf5_require_harmless(const std::string& path);

/// The creation properties of a dataset without times, so that the same content gives the same bytes.
Hdf5Id hdf5_dataset_creation();
/// The same, in chunks, shuffled and deflated, if it is large enough to gain by it.
Hdf5Id hdf5_packed_creation(hid_t type, const Hdf5Shape& shape);

template <class Body>
auto Hdf5File::attempt(const std::string& object, const std::string& complaint, const Body& body) const {
  try {
    return body();
  } catch (const Hdf5Failure&) {
    fail(object, complaint);
  } catch (const std::bad_alloc&) {
    fail(object, "takes more memory than there is, or than the file could fill");
  } catch (const std::length_error&) {
    fail(object, "takes more memory than there is, or than the file could fill");
  }
}

}  // namespace tiprub
