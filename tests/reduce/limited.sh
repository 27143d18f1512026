#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: limited.sh -d|-v KIB COMMAND...: a command that may have no more data, or map no more, than that.
ulimit "$1" "$2" || exit 77
shift 2
exec "$@"
