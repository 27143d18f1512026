// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/program/write_file.h"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "cases/program/errors.h"

namespace tiprub {

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& body) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  if (out) body(out);
  out.close();  // streams hold back: only now is it known
  const int reason = errno;
  if (!out)
    throw RunError(path.string() + ": can't be written" +
                   (reason == 0 ? "" : ": " + std::generic_category().message(reason)));
}

}  // namespace tiprub
