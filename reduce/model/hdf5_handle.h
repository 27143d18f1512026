// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "reduce/model/hdf5_file.h"

// What the facade's own files share: HDF5's headers reach nobody else.
namespace tiprub {

using Hdf5Shape = std::vector<hsize_t>;

/// Something that HDF5 refused; Hdf5File::attempt() tells what was tried.
class Hdf5Failure : public std::exception {
 public:
  const char* what() const noexcept override { return "HDF5 failed"; }
};

/// What a call of HDF5 gave back: an id, a count, a truth. Raises Hdf5Failure if the call failed.
template <class Result>
Result hdf5_checked(Result result) {
  if (result < 0) throw Hdf5Failure();
  return result;
}

/// An open object of HDF5. Its destructor can't report what the disk did not take: what was written to is closed by
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

  /// Raises Hdf5Failure if HDF5 still held something back and can't write it; the object is gone all the same.
  void close() { hdf5_checked(close_(std::exchange(id_, H5I_INVALID_HID))); }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// h5py's convention for complex numbers, {r, i}.
template <class Real>
Hdf5Id hdf5_complex_type(hid_t real) {
  Hdf5Id type(H5Tcreate(H5T_COMPOUND, 2 * sizeof(Real)), H5Tclose);
  hdf5_checked(H5Tinsert(type, "r", 0, real));
  hdf5_checked(H5Tinsert(type, "i", sizeof(Real), real));
  return type;
}

Hdf5Shape hdf5_extents(hid_t space);
/// "3 x 4", "scalar".
std::string hdf5_shape_text(const Hdf5Shape& shape);
/// How many values a dataset has. Raises std::length_error if they are more than the file can hold: of what was never
/// written HDF5 gives zeros, terabytes of them.
double hdf5_filled_count(hid_t set);
/// Of an object that hasn't it yet: one value, or one text.
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
  /// Lets `body` add to an object, which is made a group if it isn't there.
  template <class Body>
  void add_to(const std::string& name, const Body& body) const {
    if (name != "/") make_groups(name + "/");
    Hdf5Id at = object(name);
    body(at);
    at.close();
  }
  /// A type as the file has it by name, given to it if it hasn't: netCDF passes over compounds without one.
  Hdf5Id named(const std::string& name, Hdf5Id type) const;
  /// A new dataset, with nothing in it; with an empty unit none.
  Hdf5Id make(const std::string& name, hid_t type, const Hdf5Shape& shape, hid_t creation,
              const std::string& unit) const;
  /// The same, with all its values, closed.
  void write(const std::string& name, hid_t type, const Hdf5Shape& shape, const void* values,
             const std::string& unit) const;
  /// Texts of any length, which netCDF reads; of those of fixed length it dies.
  void write_texts(const std::string& name, const Hdf5Shape& shape, const std::vector<const char*>& texts) const;
};

/// Touches what a reader may touch, in a process of its own: HDF5 follows damaged tables to wherever they point, and
/// may die of it. Raises RunError then; what HDF5 itself refuses is left to the reader.
void hdf5_require_harmless(const std::string& path);

/// Of a dataset whose times are not kept: same content, same bytes.
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
