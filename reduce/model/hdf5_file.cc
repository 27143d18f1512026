// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/hdf5_file.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>
#include <system_error>

#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

/// Makes HDF5 silent, and leaves out its own clean-up at exit, which tries to write again after a full disk, and
/// crashes.
void prepare_library() {
  static const herr_t left_to_us = H5dont_atexit();  // counts only before the library's first use
  static_cast<void>(left_to_us);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Opens an attribute, which must hold a single value, as a scalar or as an array of one.
Hdf5Id single(hid_t object, const std::string& name) {
  Hdf5Id attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Id space(H5Aget_space(attribute), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1) throw Hdf5Failure();
  return attribute;
}

}  // namespace

Hdf5Shape hdf5_extents(hid_t space) {
  if (H5Sget_simple_extent_type(space) == H5S_NULL) return {0};
  Hdf5Shape shape(static_cast<std::size_t>(hdf5_checked(H5Sget_simple_extent_ndims(space))));
  hdf5_checked(H5Sget_simple_extent_dims(space, shape.data(), nullptr));
  return shape;
}

double hdf5_filled_count(hid_t set) {
  constexpr double most_compression = 1100;   // of deflate: bytes of values for one byte in the file
  constexpr double always_allowed = 1 << 20;  // values
  const double size = static_cast<double>(H5Tget_size(Hdf5Id(H5Dget_type(set), H5Tclose)));
  const double filled = most_compression * static_cast<double>(H5Dget_storage_size(set)) / size;
  double count = 1;
  for (hsize_t extent : hdf5_extents(Hdf5Id(H5Dget_space(set), H5Sclose))) count *= static_cast<double>(extent);
  if (count > std::max(filled, always_allowed)) throw std::length_error("hollow");
  return count;
}

Hdf5Id hdf5_dataset_creation() {
  Hdf5Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  hdf5_checked(H5Pset_obj_track_times(creation, false));
  return creation;
}

void Hdf5File::Handle::make_groups(const std::string& name) const {
  for (std::size_t at = name.find('/', 1); at != std::string::npos; at = name.find('/', at + 1)) {
    const std::string group = name.substr(0, at);
    if (hdf5_checked(H5Lexists(file, group.c_str(), H5P_DEFAULT)) > 0) continue;
    Hdf5Id(H5Gcreate2(file, group.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose).close();
  }
}

Hdf5Id Hdf5File::Handle::make(const std::string& name, hid_t type, const Hdf5Shape& shape, hid_t creation,
                              const std::string& unit) const {
  make_groups(name);
  const Hdf5Id space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
  Hdf5Id set(H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose);
  if (!unit.empty()) hdf5_add_attribute(set, storage == Storage::plain ? "unit" : "units", unit);
  return set;
}

void Hdf5File::Handle::write(const std::string& name, hid_t type, const Hdf5Shape& shape, const void* values,
                             const std::string& unit) const {
  Hdf5Id set = make(name, type, shape,
                    storage == Storage::netcdf ? hdf5_packed_creation(type, shape) : hdf5_dataset_creation(), unit);
  const bool empty = std::ranges::find(shape, 0U) != shape.end();
  if (!empty) hdf5_checked(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  set.close();
}

Hdf5File::Hdf5File(std::string path, std::unique_ptr<Handle> handle)
    : path_(std::move(path)), handle_(std::move(handle)) {}
Hdf5File::~Hdf5File() = default;
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;

void Hdf5File::fail(const std::string& object, const std::string& what) const {
  const std::string message = path_ + ": " + object + ": " + what;
  unsigned intent = H5F_ACC_RDWR;
  if (H5Fget_intent(handle_->file, &intent) >= 0 && intent == H5F_ACC_RDONLY) throw FileError(message);
  throw RunError(message);
}

Hdf5File Hdf5File::create(const std::filesystem::path& path, Storage storage) {
  prepare_library();
  errno = 0;
  try {
    Hdf5Id file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
    return {path.string(), std::make_unique<Handle>(Handle{std::move(file), storage})};
  } catch (const Hdf5Failure&) {
    const std::string reason = errno != 0 ? std::generic_category().message(errno) : "is the disk full?";
    throw RunError(path.string() + ": can't be written: " + reason);
  }
}

Hdf5File Hdf5File::open(const std::filesystem::path& path, Bytes bytes) {
  prepare_library();
  if (!std::filesystem::exists(path)) throw RunError(path.string() + ": no such file");
  if (bytes == Bytes::unknown) hdf5_require_harmless(path.string());
  try {
    Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    return {path.string(), std::make_unique<Handle>(Handle{std::move(file)})};
  } catch (const Hdf5Failure&) {
    throw FileError(path.string() + ": is not an HDF5 file, or is damaged");
  }
}

void Hdf5File::close() {
  try {
    hdf5_checked(H5Fflush(handle_->file, H5F_SCOPE_GLOBAL));
    handle_->file.close();
  } catch (const Hdf5Failure&) {
    throw RunError(path_ + ": can't be written to its end; is the disk full?");
  }
}

bool Hdf5File::exists(const std::string& name) const {
  return attempt(name, "can't be looked up; the file is damaged", [&] {
    for (std::size_t at = name.find('/', 1);; at = name.find('/', at + 1)) {
      if (hdf5_checked(H5Lexists(handle_->file, name.substr(0, at).c_str(), H5P_DEFAULT)) == 0) return false;
      if (at == std::string::npos) return true;
    }
  });
}

std::vector<std::string> Hdf5File::members(const std::string& group) const {
  if (!exists(group)) fail(group, "is missing");
  return attempt(group, "can't be read as a group", [&] {
    const Hdf5Id opened(H5Gopen2(handle_->file, group.c_str(), H5P_DEFAULT), H5Gclose);
    H5G_info_t info{};
    hdf5_checked(H5Gget_info(opened, &info));
    std::vector<std::string> names;
    for (hsize_t i = 0; i < info.nlinks; ++i) {
      const auto name = [&](char* text, std::size_t size) {
        return hdf5_checked(H5Lget_name_by_idx(opened, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, size, H5P_DEFAULT));
      };
      names.emplace_back(static_cast<std::size_t>(name(nullptr, 0)), '\0');
      name(names.back().data(), names.back().size() + 1);
    }
    std::ranges::sort(names);
    return names;
  });
}

void Hdf5File::set_schema(const std::string& schema, int version, const std::string& generator) {
  set_attribute("/", "schema", schema);
  set_attribute("/", "schema_version", version);
  set_attribute("/", "generator", generator);
}

void Hdf5File::require_schema(const std::string& schema, int version) const {
  if (!has_attribute("/", "schema"))
    throw FileError(path_ + ": has no schema; expected " + schema + " version " + std::to_string(version));
  const std::string found = text_attribute("/", "schema");
  const int found_version = has_attribute("/", "schema_version") ? integer_attribute("/", "schema_version") : 0;
  if (found != schema || found_version != version)
    throw FileError(path_ + ": is " + found + " version " + std::to_string(found_version) + ", expected " + schema +
                    " version " + std::to_string(version));
}

void hdf5_add_attribute(hid_t object, const std::string& name, hid_t type, const void* value) {
  const Hdf5Id scalar(H5Screate(H5S_SCALAR), H5Sclose);
  Hdf5Id attribute(H5Acreate2(object, name.c_str(), type, scalar, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  hdf5_checked(H5Awrite(attribute, type, value));
  attribute.close();
}

void hdf5_add_attribute(hid_t object, const std::string& name, const std::string& text) {
  hdf5_add_attribute(object, name, hdf5_text_type(text), text.c_str());
}

Hdf5Id hdf5_text_type(const std::string& text) {
  Hdf5Id type(H5Tcopy(H5T_C_S1), H5Tclose);
  hdf5_checked(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)));
  return type;
}

void Hdf5File::Handle::add_attribute(const std::string& object, const std::string& name, hid_t type,
                                     const void* value) const {
  if (object != "/") make_groups(object + "/");
  Hdf5Id at = this->object(object);
  hdf5_add_attribute(at, name, type, value);
  at.close();
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& value) {
  attempt(object, "attribute " + name + " can't be written",
          [&] { handle_->add_attribute(object, name, hdf5_text_type(value), value.c_str()); });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  attempt(object, "attribute " + name + " can't be written",
          [&] { handle_->add_attribute(object, name, H5T_NATIVE_DOUBLE, &value); });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, int value) {
  attempt(object, "attribute " + name + " can't be written",
          [&] { handle_->add_attribute(object, name, H5T_NATIVE_INT, &value); });
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  return attempt(object, "has no text attribute " + name, [&] {
    const Hdf5Id attribute = single(handle_->object(object), name);
    return hdf5_read_text(Hdf5Id(H5Aget_type(attribute), H5Tclose),
                          [&](hid_t type, void* to) { return H5Aread(attribute, type, to); });
  });
}

double Hdf5File::number_attribute(const std::string& object, const std::string& name) const {
  double value = 0.0;
  attempt(object, "has no number attribute " + name,
          [&] { hdf5_checked(H5Aread(single(handle_->object(object), name), H5T_NATIVE_DOUBLE, &value)); });
  if (!std::isfinite(value)) fail(object, "attribute " + name + " is not finite");
  return value;
}

int Hdf5File::integer_attribute(const std::string& object, const std::string& name) const {
  const double value = number_attribute(object, name);
  if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
    fail(object, "attribute " + name + " is not a whole number within +-2^31");
  return static_cast<int>(value);
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  try {
    return hdf5_checked(H5Aexists(handle_->object(object), name.c_str())) > 0;
  } catch (const Hdf5Failure&) {
    return false;
  }
}

void Hdf5File::make_axis(const std::string& name) {
  attempt(name, "can't be made an axis; is the disk full?", [&] {
    Hdf5Id set = handle_->dataset(name);
    hdf5_checked(H5DSset_scale(set, std::filesystem::path(name).filename().c_str()));
    set.close();
  });
}

void Hdf5File::describe(const std::string& name, const std::string& long_name, const std::vector<std::string>& axes) {
  attempt(name, "can't be described; is the disk full?", [&] {
    Hdf5Id set = handle_->dataset(name);
    hdf5_add_attribute(set, "long_name", long_name);
    for (std::size_t i = 0; i < axes.size(); ++i) {
      Hdf5Id axis = handle_->dataset(axes[i]);
      hdf5_checked(H5DSattach_scale(set, axis, static_cast<unsigned>(i)));
      axis.close();
    }
    set.close();
  });
}

}  // namespace tiprub
