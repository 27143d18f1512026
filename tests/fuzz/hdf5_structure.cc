// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/hdf5_structure.h"

#include <hdf5.h>

#include <string>
#include <vector>

#include "tests/fuzz/inputs.h"

namespace tiprub::fuzz {

namespace {

using Extents = std::vector<hsize_t>;

constexpr hsize_t most_values = 1000000;  // of what is written; a shape may be larger
constexpr hsize_t huge_extent = 1ULL << 40;
constexpr const char* odd_names[] = {"x",    "K0",       "M",          "00000", "-1",  "99999999999999999999",
                                     "a\nb", "\x1b[31m", "\xc3\xa4 b", "..",    "unit"};
constexpr const char* odd_texts[] = {"",         " ",        "0", "tiprub-model", "a\nb",
                                     "\x1b[31m", "\xff\xfe", "m", "mm",           "periodic"};

herr_t note_link(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

herr_t note_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

std::vector<std::string> links_of(hid_t file) {
  std::vector<std::string> names;
  H5Lvisit(file, H5_INDEX_NAME, H5_ITER_INC, note_link, &names);
  return names;
}

std::vector<std::string> attributes_of(hid_t object) {
  std::vector<std::string> names;
  hsize_t at = 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &at, note_attribute, &names);
  return names;
}

hid_t text_type(bool variable, std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, variable ? H5T_VARIABLE : std::max<std::size_t>(size, 1));
  return type;
}

hid_t compound_type(const char* first, const char* second, hid_t member) {
  const std::size_t size = H5Tget_size(member);
  const hid_t type = H5Tcreate(H5T_COMPOUND, 2 * size);
  H5Tinsert(type, first, 0, member);
  H5Tinsert(type, second, size, member);
  return type;
}

hid_t another_type(Random& random) {
  const hsize_t three = 3;
  static const hid_t types[] = {H5T_STD_I8LE,
                                H5T_STD_U64BE,
                                H5T_IEEE_F32BE,
                                H5T_NATIVE_LDOUBLE,
                                text_type(false, 8),
                                text_type(true, 0),
                                compound_type("r", "i", H5T_IEEE_F64LE),
                                compound_type("i", "r", H5T_IEEE_F64LE),
                                compound_type("x", "y", H5T_IEEE_F64LE),
                                compound_type("r", "i", H5T_STD_I16LE),
                                H5Tarray_create2(H5T_IEEE_F64LE, 1, &three),
                                H5T_STD_REF_OBJ,
                                H5Tcreate(H5T_OPAQUE, 5)};
  return H5Tcopy(random.of(types));
}

Extents extents_of(hid_t space) {
  Extents extents(static_cast<std::size_t>(std::max(H5Sget_simple_extent_ndims(space), 0)));
  if (!extents.empty()) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

hsize_t count_of(const Extents& extents) {
  hsize_t count = 1;
  for (const hsize_t extent : extents) count = extent > most_values ? most_values + 1 : count * extent;
  return count;
}

void change_shape(Extents& extents, Random& random) {
  if (extents.empty()) extents.push_back(1);
  hsize_t& extent = extents[random.below(extents.size())];
  switch (random.below(9)) {
    case 0:
      extent = 0;
      break;
    case 1:
      extent += 1;
      break;
    case 2:
      extent -= extent > 0 ? 1 : 0;
      break;
    case 3:
      extent *= 2;
      break;
    case 4:
      extents.push_back(1 + random.below(3));
      break;
    case 5:
      extents.pop_back();
      break;
    case 6:
      extents = {extents.rbegin(), extents.rend()};
      break;
    case 7:
      extent = random.below(20);
      break;
    default:
      extent = huge_extent >> random.below(30);
      break;
  }
}

hid_t space_of(const Extents& extents, Random& random) {
  if (random.once_in(20)) return H5Screate(H5S_NULL);
  if (extents.empty()) return H5Screate(H5S_SCALAR);
  return H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
}

/// Chunks, one a value of the first axes, where the shape is too large to be written: they cost nothing.
hid_t layout_of(const Extents& extents) {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(creation, false);
  if (count_of(extents) <= most_values) return creation;
  Extents chunk(extents.size(), 1);
  H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data());
  return creation;
}

/// The old values, as far as they reach and can be converted, in a new dataset of the same name and attributes lost.
void make_again(hid_t file, const std::string& name, bool other_shape, Random& random) {
  const hid_t old = H5Dopen2(file, name.c_str(), H5P_DEFAULT), old_space = H5Dget_space(old);
  Extents extents = extents_of(old_space);
  std::vector<double> values(2 * std::min<hsize_t>(count_of(extents), most_values) + 2, 1.0);
  if (count_of(extents) <= most_values) H5Dread(old, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  const hid_t type = other_shape ? H5Dget_type(old) : another_type(random);
  if (other_shape) change_shape(extents, random);
  const hid_t space = space_of(extents, random), layout = layout_of(extents);
  H5Dclose(old);
  H5Ldelete(file, name.c_str(), H5P_DEFAULT);
  const hid_t made = H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT);
  values.resize(2 * std::min<hsize_t>(count_of(extents), most_values) + 2, 1.0);
  if (count_of(extents) <= most_values)
    H5Dwrite(made, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  for (const hid_t space_or_layout : {old_space, space}) H5Sclose(space_or_layout);
  H5Pclose(layout);
  H5Tclose(type);
  H5Dclose(made);
}

/// One value, or in one of four cases all.
void change_values(hid_t file, const std::string& name, Random& random) {
  const hid_t set = H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  const hid_t type = H5Dget_type(set), space = H5Dget_space(set);
  const hsize_t count = count_of(extents_of(space));
  const std::size_t size = H5Tget_size(type);
  if (count > 0 && count <= most_values && H5Tis_variable_str(type) <= 0) {
    std::string values(count * size, '\0');
    H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    if (random.once_in(4)) {
      std::string one = values.substr(0, size);
      put_extreme_number(one, 0, random);
      for (hsize_t i = 0; i < count; ++i) values.replace(i * size, size, one);
    } else {
      put_extreme_number(values, random.below(count) * size, random);
    }
    values.resize(count * size);
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  }
  H5Tclose(type);
  H5Sclose(space);
  H5Dclose(set);
}

void change_attribute(hid_t file, const std::string& object_name, Random& random) {
  const hid_t object = H5Oopen(file, object_name.c_str(), H5P_DEFAULT);
  const std::vector<std::string> names = attributes_of(object);
  if (!names.empty()) {
    const std::string& name = random.of(names);
    if (random.once_in(8)) {
      H5Arename(object, name.c_str(), random.of(odd_names));
    } else {
      H5Adelete(object, name.c_str());
      const hsize_t few = random.below(5);
      const hid_t space = random.once_in(3) ? H5Screate_simple(1, &few, nullptr) : H5Screate(H5S_SCALAR);
      const bool text = random.once_in(3), number = !text && !random.once_in(4);
      const std::string word = random.of(odd_texts);
      const hid_t type = text     ? text_type(false, word.size())
                         : number ? H5Tcopy(H5T_NATIVE_DOUBLE)
                                  : another_type(random);
      const hid_t made = random.once_in(4) ? H5I_INVALID_HID
                                           : H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT);
      const std::vector<double> values(8, extreme_number(random));
      const std::string words = word + std::string(64, '\0');
      if (made >= 0 && (text ? few == 1 : number))
        H5Awrite(made, type, text ? static_cast<const void*>(words.data()) : values.data());
      if (made >= 0) H5Aclose(made);
      H5Tclose(type);
      H5Sclose(space);
    }
  }
  H5Oclose(object);
}

void change_link(hid_t file, const std::string& name, const std::string& other, Random& random) {
  const std::string beside = name.substr(0, name.rfind('/') + 1) + random.of(odd_names);
  switch (random.below(6)) {
    case 0:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      break;
    case 1:
      H5Lmove(file, name.c_str(), file, beside.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 2:
      H5Lcreate_hard(file, other.c_str(), file, beside.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 3:
      H5Lmove(file, name.c_str(), file, "moved", H5P_DEFAULT, H5P_DEFAULT);
      H5Lcreate_hard(file, other.c_str(), file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 4:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      H5Lcreate_soft(("/" + (random.once_in(2) ? name : other)).c_str(), file, name.c_str(), H5P_DEFAULT,
                     H5P_DEFAULT);
      break;
    default:
      H5Ldelete(file, name.c_str(), H5P_DEFAULT);
      H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }
}

bool is_dataset(hid_t file, const std::string& name) {
  const hid_t object = H5Oopen(file, name.c_str(), H5P_DEFAULT);
  const bool found = object >= 0 && H5Iget_type(object) == H5I_DATASET;
  if (object >= 0) H5Oclose(object);
  return found;
}

void change(hid_t file, Random& random) {
  const std::vector<std::string> names = links_of(file);
  if (names.empty()) return;
  const std::string &name = random.of(names), &other = random.of(names);
  const std::size_t what = random.below(10);
  if (what < 2)
    change_link(file, name, other, random);
  else if (what < 4)
    change_attribute(file, random.once_in(3) ? name : "/", random);
  else if (is_dataset(file, name) && what < 7)
    change_values(file, name, random);
  else if (is_dataset(file, name))
    make_again(file, name, what < 9, random);
}

}  // namespace

void change_structure(const std::filesystem::path& path, Random& random) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  if (file < 0) return;  // damaged already
  change(file, random);
  H5Fclose(file);
}

}  // namespace tiprub::fuzz
