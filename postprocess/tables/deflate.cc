// SPDX-License-Identifier: GPL-3.0-or-later
#include "postprocess/tables/deflate.h"

#include <zlib.h>

#include "cases/program/errors.h"

namespace tiprub {

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  if (result != Z_OK) throw RunError("report.html: its data can't be packed: not enough memory");
  packed.resize(size);
  return packed;
}

}  // namespace tiprub
