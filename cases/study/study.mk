# SPDX-License-Identifier: GPL-3.0-or-later
# A study computes many points of one case, and makes one table and one page. Its folder holds study.toml and a Makefile that
# includes this file.
#   make -j 4            makes all points as far as they are out of date, then report/study.html;  -k goes on if a point fails
#   make runs            makes only the folders of the points, for `make -C runs -j 4`, or `make -C runs point INDEX=1` on a cluster
#   make table           makes the table and the page from the points that are finished
#   make clean
# These variables may be set: STUDY, RUNS, BIN as in chain.mk, THREADS for one point, LAUNCH := mpirun -n 4 for each sweep.
STUDY ?= study.toml
RUNS ?= runs
HERE := $(patsubst %/,%,$(dir $(lastword $(MAKEFILE_LIST))))
BIN ?= $(abspath $(or $(wildcard $(HERE)/../../build/bin),$(HERE)/../../../../bin))
in_shell = '$(subst ','\'',$1)'

.PHONY: all runs points table clean
all: table
	@cat report/study.txt

runs:
	@/usr/bin/python3 -B $(HERE)/study.py $(STUDY) $(call in_shell,$(BIN)) $(HERE)/../chain.mk $(RUNS)

points: runs
	+@$(MAKE) --no-print-directory -C $(RUNS) BIN=$(call in_shell,$(BIN))

table: $(if $(filter table,$(MAKECMDGOALS)),,points)
	@/usr/bin/python3 -B $(HERE)/comparison.py $(STUDY) $(RUNS) report

clean:
	rm -rf $(RUNS) report
