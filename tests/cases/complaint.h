// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/program/errors.h"

namespace tiprub {

/// The message of the Error that a call raises; empty if it raises none.
template <class Error, class Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace tiprub
