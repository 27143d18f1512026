#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: limited.sh KIB COMMAND...: a command that may have no more data than that.
ulimit -d "$1" || exit 77
shift
exec "$@"
