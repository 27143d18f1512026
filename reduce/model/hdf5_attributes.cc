// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

void set(const H5::H5Object& object, const std::string& name, const H5::DataType& type, const void* value) {
  object.createAttribute(name, type, H5::DataSpace(H5S_SCALAR)).write(type, value);
}

/// One value, as a scalar or as an array of one.
H5::Attribute single(const H5::H5Object& object, const std::string& name) {
  H5::Attribute attribute = object.openAttribute(name);
  if (attribute.getSpace().getSimpleExtentNpoints() != 1) throw H5::AttributeIException("single", "not one value");
  return attribute;
}

}  // namespace

void Hdf5File::set_attribute(const std::string& object, const std::string& name, const std::string& value) {
  attempt(object, "attribute " + name + " can't be written", [&] {
    if (object != "/") handle_->make_groups(object + "/");
    const H5::StrType type(H5::PredType::C_S1, std::max<std::size_t>(value.size(), 1));
    handle_->with_attributes(object, [&](const H5::H5Object& at) { set(at, name, type, value.c_str()); });
  });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, double value) {
  attempt(object, "attribute " + name + " can't be written", [&] {
    if (object != "/") handle_->make_groups(object + "/");
    handle_->with_attributes(object,
                             [&](const H5::H5Object& at) { set(at, name, H5::PredType::NATIVE_DOUBLE, &value); });
  });
}

void Hdf5File::set_attribute(const std::string& object, const std::string& name, int value) {
  attempt(object, "attribute " + name + " can't be written", [&] {
    if (object != "/") handle_->make_groups(object + "/");
    handle_->with_attributes(object,
                             [&](const H5::H5Object& at) { set(at, name, H5::PredType::NATIVE_INT, &value); });
  });
}

std::string Hdf5File::text_attribute(const std::string& object, const std::string& name) const {
  std::string value;
  attempt(object, "has no text attribute " + name, [&] {
    handle_->with_attributes(object, [&](const H5::H5Object& at) {
      const H5::Attribute attribute = single(at, name);
      attribute.read(attribute.getStrType(), value);
    });
  });
  return value.substr(0, value.find('\0'));
}

double Hdf5File::number_attribute(const std::string& object, const std::string& name) const {
  double value = 0.0;
  attempt(object, "has no number attribute " + name, [&] {
    handle_->with_attributes(
        object, [&](const H5::H5Object& at) { single(at, name).read(H5::PredType::NATIVE_DOUBLE, &value); });
  });
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
  bool found = false;
  try {
    handle_->with_attributes(object, [&](const H5::H5Object& at) { found = at.attrExists(name); });
  } catch (const H5::Exception&) {
    return false;
  }
  return found;
}

}  // namespace tiprub
