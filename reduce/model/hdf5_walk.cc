// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "reduce/model/child_process.h"
#include "reduce/model/hdf5_handle.h"

namespace tiprub {

namespace {

constexpr ChildLimits limits = {1024.0 * 1024 * 1024, 50};

herr_t note_link(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

herr_t touch_attribute(hid_t object, const char* name, const H5A_info_t*, void*) try {
  const Hdf5Id attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Id type(H5Aget_type(attribute), H5Tclose), space(H5Aget_space(attribute), H5Sclose);
  std::vector<char> value(H5Tget_size(type));
  if (H5Sget_simple_extent_npoints(space) == 1) H5Aread(attribute, type, value.data());
  return 0;
} catch (const std::exception&) {
  return 0;
}

/// Whether chunks that are not compressed have the size that is read of them: HDF5 reads beyond smaller ones.
bool has_whole_chunks(hid_t set, hid_t type, hid_t space) {
  const Hdf5Id creation(H5Dget_create_plist(set), H5Pclose);
  if (H5Pget_layout(creation) != H5D_CHUNKED || H5Pget_nfilters(creation) != 0) return true;
  Hdf5Shape chunk(hdf5_extents(space).size());
  hdf5_checked(H5Pget_chunk(creation, static_cast<int>(chunk.size()), chunk.data()));
  hsize_t count = 0;
  hdf5_checked(H5Dget_num_chunks(set, space, &count));
  hsize_t bytes = count * H5Tget_size(type);
  for (const hsize_t extent : chunk) bytes *= extent;
  return H5Dget_storage_size(set) == bytes;
}

/// Its index of chunks, and its text if it is one. False if it can't be read without harm.
bool touch_dataset(hid_t set) {
  const Hdf5Id type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
  if (!has_whole_chunks(set, type, space)) return false;
  if (H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1) return true;
  std::vector<char> value(H5Tget_size(type));
  H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value.data());
  return true;
}

class Walk {
 public:
  void touch(hid_t parent, const std::string& name) try {
    const Hdf5Id object(H5Oopen(parent, name.c_str(), H5P_DEFAULT), H5Oclose);
    H5O_info_t info{};
    if (H5Oget_info2(object, &info, H5O_INFO_BASIC) < 0 || !seen_.insert(info.addr).second) return;
    hsize_t from = 0;
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &from, touch_attribute, nullptr);
    if (info.type == H5O_TYPE_DATASET) {
      if (!touch_dataset(object)) harmful_ = name;
      return;
    }
    std::vector<std::string> names;
    H5Literate(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, note_link, &names);
    for (const std::string& inside : names) touch(object, inside);
  } catch (const std::exception&) {  // the reader will say so, if it is something that it needs
  }

  /// The last dataset that can't be read without harm; empty if all can.
  const std::string& harmful() const { return harmful_; }

 private:
  std::string harmful_;
  std::set<haddr_t> seen_;  // links may lead round
};

}  // namespace

void hdf5_require_harmless(const std::string& path) {
  std::string harmful;
  try {
    harmful = made_by_a_child(
        [&] {
          const Hdf5Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
          Walk walk;
          walk.touch(file, "/");
          return walk.harmful();
        },
        limits);
  } catch (const ChildDied& end) {
    throw RunError(path + ": is not an HDF5 file, or is damaged (HDF5 dies of it: " + end.what() + ")");
  } catch (const RunError&) {  // HDF5 can't open it: so it says again
  }
  if (!harmful.empty()) throw RunError(path + ": " + harmful + ": is damaged: its chunks are not whole");
}

}  // namespace tiprub
