// SPDX-License-Identifier: GPL-3.0-or-later
#include "reduce/model/hdf5_file.h"

#include <algorithm>

#include "reduce/model/hdf5_handle.h"

namespace tiprub {

Hdf5Shape hdf5_extents(const H5::DataSpace& space) {
  if (space.getSimpleExtentType() == H5S_NULL) return {0};
  Hdf5Shape shape(static_cast<std::size_t>(space.getSimpleExtentNdims()));
  space.getSimpleExtentDims(shape.data());
  return shape;
}

std::string hdf5_shape_text(const Hdf5Shape& shape) {
  std::string words;
  for (hsize_t extent : shape) words += (words.empty() ? "" : " x ") + std::to_string(extent);
  return words.empty() ? "scalar" : words;
}

void Hdf5File::Handle::make_groups(const std::string& name) const {
  for (std::size_t at = name.find('/', 1); at != std::string::npos; at = name.find('/', at + 1))
    if (const std::string group = name.substr(0, at); !file.nameExists(group)) file.createGroup(group);
}

H5::DataSet Hdf5File::Handle::make(const std::string& name, const H5::DataType& type, const Hdf5Shape& shape,
                                   const H5::DSetCreatPropList& creation, const std::string& unit) const {
  make_groups(name);
  H5Pset_obj_track_times(creation.getId(), false);
  const H5::DataSet set =
      file.createDataSet(name, type, H5::DataSpace(static_cast<int>(shape.size()), shape.data()), creation);
  const H5::StrType string_type(H5::PredType::C_S1, std::max<std::size_t>(unit.size(), 1));
  set.createAttribute("unit", string_type, H5::DataSpace(H5S_SCALAR)).write(string_type, unit);
  return set;
}

Hdf5File::Hdf5File(std::string path, std::unique_ptr<Handle> handle)
    : path_(std::move(path)), handle_(std::move(handle)) {}
Hdf5File::~Hdf5File() = default;
Hdf5File::Hdf5File(Hdf5File&&) noexcept = default;
Hdf5File& Hdf5File::operator=(Hdf5File&&) noexcept = default;

void Hdf5File::fail(const std::string& object, const std::string& what) const {
  throw RunError(path_ + ": " + object + ": " + what);
}

Hdf5File Hdf5File::create(const std::filesystem::path& path) {
  H5::Exception::dontPrint();
  H5dont_atexit();  // after a failed close HDF5's own clean-up at exit tries again, and crashes
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

void Hdf5File::close() {
  try {
    handle_->file.flush(H5F_SCOPE_GLOBAL);
    handle_->file.close();
  } catch (const H5::Exception&) {
    static_cast<void>(handle_.release());  // its destructor would only try again
    throw RunError(path_ + ": can't be written to its end; is the disk full?");
  }
}

bool Hdf5File::exists(const std::string& name) const {
  return attempt(name, "can't be looked up; the file is damaged", [&] {
    for (std::size_t at = name.find('/', 1);; at = name.find('/', at + 1)) {
      if (!handle_->file.nameExists(name.substr(0, at))) return false;
      if (at == std::string::npos) return true;
    }
  });
}

std::vector<std::string> Hdf5File::members(const std::string& group) const {
  if (!exists(group)) fail(group, "is missing");
  return attempt(group, "can't be read as a group", [&] {
    std::vector<std::string> names;
    const H5::Group opened = handle_->file.openGroup(group);
    for (hsize_t i = 0; i < opened.getNumObjs(); ++i) names.push_back(opened.getObjnameByIdx(i));
    std::sort(names.begin(), names.end());
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
    throw RunError(path_ + ": has no schema; expected " + schema + " version " + std::to_string(version));
  const std::string found = text_attribute("/", "schema");
  const int found_version = has_attribute("/", "schema_version") ? integer_attribute("/", "schema_version") : 0;
  if (found != schema || found_version != version)
    throw RunError(path_ + ": is " + found + " version " + std::to_string(found_version) + ", expected " + schema +
                   " version " + std::to_string(version));
}

}  // namespace tiprub
