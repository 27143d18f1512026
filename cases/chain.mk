# SPDX-License-Identifier: GPL-3.0-or-later
# From a case to its report, by the four programs. A case's folder holds case.toml and a Makefile that includes this file.
#   make             everything that is out of date, and prints the critical speeds
#   make model.h5    one file and what it needs;  make -B model.h5 makes it anyway
#   make clean       forgets what was computed
# Each stage is out of date when its own tables of case.toml change, or a file it reads.
#
# MODEL_OF := ../<case>, set before the include, takes sector.msh and model.h5 from another case: one wheel, many casings.
# SIMULATE_FLAGS, likewise, are further options of tiprub-simulate, such as --set simulate.speed_count=12.
# [postprocess] response_up = "response_up.h5" asks for this case swept up as well; response_down likewise.
HERE := $(dir $(lastword $(MAKEFILE_LIST)))
BIN ?= $(abspath $(HERE)../build/bin)
export PATH := $(BIN):$(PATH)

.PHONY: all clean
.DELETE_ON_ERROR:
all: report/report.html
	@cat report/critical_speeds.txt

ifdef MODEL_OF
# A link is as old as what it points to, so that a model made anew reaches this case too.
sector.msh model.h5 fields.h5: %: $(MODEL_OF)/%
	ln -sf $< $@

.PHONY: look
$(MODEL_OF)/sector.msh $(MODEL_OF)/model.h5 $(MODEL_OF)/fields.h5: look
	@+$(MAKE) --no-print-directory -C $(MODEL_OF) $(@F)
else
sector.msh: .tables/mesh
	tiprub-mesh case.toml -o $@

model.h5 fields.h5 &: .tables/reduce sector.msh
	tiprub-reduce case.toml sector.msh -o model.h5 --fields fields.h5
endif

response.h5: .tables/casing .tables/simulate model.h5
	tiprub-simulate case.toml model.h5 -o $@ $(SIMULATE_FLAGS)

response_%.h5: .tables/casing .tables/simulate model.h5
	tiprub-simulate case.toml model.h5 -o $@ --set 'simulate.sweep="$*"' $(SIMULATE_FLAGS)

SWEEPS := $(shell sed -n 's/^response_\(up\|down\) = "\(.*\)".*/\2/p' case.toml)

report/report.html: .tables/postprocess .tables/material model.h5 fields.h5 response.h5 $(SWEEPS)
	tiprub-postprocess case.toml model.h5 response.h5 --fields fields.h5 -o report > /dev/null

# One table of the case, with its sub-tables; its time changes only when its text does.
.tables/%: case.toml
	@mkdir -p .tables
	@awk '/^\[/ { inside = $$0 ~ /^\[+$*[].]/ } inside' case.toml > $@.new
	@if cmp -s $@.new $@; then rm $@.new; else mv $@.new $@; fi

.PRECIOUS: .tables/%

clean:
	rm -rf .tables report response*.h5 response*.h5.speeds model.h5 fields.h5 sector.msh *.part.*
