# SPDX-License-Identifier: GPL-3.0-or-later
# A study: many points of one case, one table, one page. A folder holds study.toml and a Makefile that includes this file.
#   make -j 4            what is out of date of every point, then report/study.html;  -k goes on beside points that fail
#   make runs            only the points' folders: then `make -C runs -j 4`, or `make -C runs point INDEX=1`, here or on a cluster
#   make table           the table and the page of the points that are there
#   make clean
# May be set: STUDY, RUNS, BIN as in chain.mk, THREADS of one point, LAUNCH := mpirun -n 4 for each point's sweep.
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
