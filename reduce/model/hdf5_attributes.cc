// SPDX-License-Identifier: GPL-3.0-or-later
#include <hdf5_hl.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

/// Opens an attribute, which must hold a single value, as a scalar or as an array of one.
Hdf5Id single(hid_t object, const std::string& name) {
  Hdf5Id attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Hdf5Id space(H5Aget_space(attribute), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1) throw Hdf5Failure();
  return attribute;
}

}  // namespace

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

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& value) {
  attempt(object, "attribute " + name + " can't be written",
          [&] { handle_->add_to(object, [&](hid_t at) { hdf5_add_attribute(at, name, value); }); });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  attempt(object, "attribute " + name + " can't be written", [&] {
    handle_->add_to(object, [&](hid_t at) { hdf5_add_attribute(at, name, H5T_NATIVE_DOUBLE, &value); });
  });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, int value) {
  attempt(object, "attribute " + name + " can't be written",
          [&] { handle_->add_to(object, [&](hid_t at) { hdf5_add_attribute(at, name, H5T_NATIVE_INT, &value); }); });
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
