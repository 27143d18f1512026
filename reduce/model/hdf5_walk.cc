// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "cases/program/sandbox.h"
#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

constexpr double most_memory = 1024.0 * 1024 * 1024;  // [bytes]
constexpr double least_seconds = 5, bytes_a_second = 1e7;
constexpr double most_read = 1 << 25;  // values of one dataset; more is not tried
constexpr const char* beyond_end = "is damaged: its numbers lie beyond its end";
constexpr const char* elsewhere =
    "has its numbers in other datasets or files (virtual or external storage); write them into the dataset itself";

/// Whether the bit fields of a number, or of a compound's numbers, lie within its bytes. HDF5 would also convert bits
/// that lie beyond.
bool is_sound(hid_t type) {
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_COMPOUND) {
    for (int i = 0; i < H5Tget_nmembers(type); ++i) {
      const Hdf5Id member(H5Tget_member_type(type, static_cast<unsigned>(i)), H5Tclose);
      const std::size_t end = H5Tget_member_offset(type, static_cast<unsigned>(i)) + H5Tget_size(member);
      if (end > H5Tget_size(type) || !is_sound(member)) return false;
    }
    return true;
  }
  if (kind != H5T_INTEGER && kind != H5T_FLOAT) return true;
  const std::size_t bits = 8 * H5Tget_size(type), precision = H5Tget_precision(type);
  const auto offset = static_cast<std::size_t>(hdf5_checked(H5Tget_offset(type)));
  if (precision == 0 || precision > bits || offset > bits - precision) return false;
  if (kind == H5T_INTEGER) return true;
  std::size_t sign = 0, exponent = 0, exponent_bits = 0, mantissa = 0, mantissa_bits = 0;
  hdf5_checked(H5Tget_fields(type, &sign, &exponent, &exponent_bits, &mantissa, &mantissa_bits));
  return sign < bits && exponent_bits <= bits && exponent <= bits - exponent_bits && mantissa_bits <= bits &&
         mantissa <= bits - mantissa_bits;
}

/// The type that a reader asks for.
Hdf5Id type_in_memory(hid_t type) {
  const bool number = H5Tget_class(type) == H5T_INTEGER || H5Tget_class(type) == H5T_FLOAT;
  return {H5Tcopy(number ? H5T_NATIVE_DOUBLE : type), H5Tclose};
}

/// [bytes] that a dataset's filters add to each chunk; none where they change its size in another way.
std::optional<hsize_t> added_by_filters(hid_t creation) {
  constexpr hsize_t checksum = 4;
  const int count = hdf5_checked(H5Pget_nfilters(creation));
  if (count == 0) return 0;
  unsigned flags = 0, configuration = 0;
  std::size_t values = 0;
  const H5Z_filter_t filter =
      hdf5_checked(H5Pget_filter2(creation, 0, &flags, &values, nullptr, 0, nullptr, &configuration));
  return count == 1 && filter == H5Z_FILTER_FLETCHER32 ? std::optional(checksum) : std::nullopt;
}

/// Whether a dataset has as many bytes in the file as its shape takes. HDF5 would read beyond them.
bool is_whole(hid_t set, hid_t type, hid_t space) {
  const Hdf5Id creation(H5Dget_create_plist(set), H5Pclose);
  const auto size = static_cast<hsize_t>(H5Tget_size(type));
  const hsize_t stored = H5Dget_storage_size(set);
  if (H5Pget_layout(creation) == H5D_CONTIGUOUS)
    return stored == 0 || stored >= size * static_cast<hsize_t>(hdf5_checked(H5Sget_simple_extent_npoints(space)));
  const std::optional<hsize_t> added = added_by_filters(creation);
  if (H5Pget_layout(creation) != H5D_CHUNKED || !added) return true;
  Hdf5Shape chunk(hdf5_extents(space).size());
  hdf5_checked(H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()));
  hsize_t count = 0;
  hdf5_checked(H5Dget_num_chunks(set, space, &count));
  hsize_t bytes = size;
  for (const hsize_t extent : chunk) bytes *= extent;
  return stored == count * (bytes + *added);
}

/// A virtual dataset of itself takes all memory, and what stands in other files is none of ours.
bool is_elsewhere(hid_t set) {
  const Hdf5Id creation(H5Dget_create_plist(set), H5Pclose);
  return H5Pget_layout(creation) == H5D_VIRTUAL || H5Pget_external_count(creation) > 0;
}

/// Reads a dataset. Returns what is wrong with it that HDF5 wouldn't notice, if anything.
const char* touch_dataset(hid_t set) {
  if (is_elsewhere(set)) return elsewhere;
  const Hdf5Id type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
  if (!is_sound(type) || !is_whole(set, type, space)) return beyond_end;
  const double count = hdf5_filled_count(set);
  if (count > most_read) return nullptr;
  const Hdf5Id read_type = type_in_memory(type);
  std::vector<char> values(static_cast<std::size_t>(count) * H5Tget_size(read_type));
  if (!values.empty()) H5Dread(set, read_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  return nullptr;
}

const char* touch_attribute(hid_t object, const char* name) {
  const Hdf5Id attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Id type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  if (!is_sound(type)) return beyond_end;
  if (H5Tget_class(type) == H5T_VLEN) return nullptr;  // an axis's references, which no reader follows
  const Hdf5Id read_type = type_in_memory(type);
  std::vector<char> value(std::max(H5Tget_size(type), H5Tget_size(read_type)));
  if (H5Sget_simple_extent_npoints(space) == 1) H5Aread(attribute, read_type, value.data());
  return nullptr;
}

/// Notes the name of a link or of an attribute.
template <class Info>
herr_t note(hid_t, const char* name, const Info*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

class Walk {
 public:
  void touch(hid_t parent, const std::string& name) try {
    const Hdf5Id object(H5Oopen(parent, name.c_str(), H5P_DEFAULT), H5Oclose);
    H5O_info_t info{};
    if (H5Oget_info2(object, &info, H5O_INFO_BASIC) < 0 || !seen_.insert(info.addr).second) return;
    hsize_t from = 0;
    std::vector<std::string> attributes, names;
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &from, note<H5A_info_t>, &attributes);
    for (const std::string& attribute : attributes)
      attempt(name, [&] { return touch_attribute(object, attribute.c_str()); });
    if (info.type == H5O_TYPE_DATASET) attempt(name, [&] { return touch_dataset(object); });
    if (info.type == H5O_TYPE_GROUP)
      H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, note<H5L_info_t>, &names);
    for (const std::string& inside : names) touch(object, inside);
  } catch (const std::exception&) {  // the reader will say so, if it is something that it needs
  }

  /// The last object that can't be read without harm, and why; empty if all can.
  const std::string& harmful() const { return harmful_; }

 private:
  template <class Touch>
  void attempt(const std::string& name, const Touch& touch_it) try {
    if (const char* wrong = touch_it(); wrong != nullptr) harmful_ = name + ": " + wrong;
  } catch (const std::exception&) {  // as above
  }

  std::string harmful_;
  std::set<haddr_t> seen_;  // links may lead round
};

/// A whole file takes a tenth of this time; of a damaged one HDF5 may never come to an end.
SandboxLimits limits_for(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return {most_memory, least_seconds + (error ? 0.0 : static_cast<double>(size)) / bytes_a_second};
}

}  // namespace

void hdf5_require_harmless(const std::string& path) {
  std::string harmful;
  try {
    harmful = made_in_sandbox(
        [&] {
          const Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
          Walk walk;
          walk.touch(file, "/");
          return walk.harmful();
        },
        limits_for(path));
  } catch (const SandboxFailure& end) {
    throw FileError(path + ": is not an HDF5 file, or is damaged (HDF5 dies of it: " + end.what() + ")");
  } catch (const RunError&) {  // HDF5 can't open it: so it says again
  }
  if (!harmful.empty()) throw FileError(path + ": " + harmful);
}

}  // namespace tiprub
