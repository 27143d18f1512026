# SPDX-License-Identifier: GPL-3.0-or-later
# From a case to its report, by the four programs. A case's folder holds case.toml and a Makefile that includes this file.
#   make             everything that is out of date, and prints the critical speeds
#   make model.h5    one file and what it needs;  make -B model.h5 makes it anyway
#   make clean       removes what make made, and nothing else
# A stage is out of date when the values that it reads of case.toml change, or a file that it reads; comments and spelling don't
# count. What all stages read of the case is looked at before the first one works.
#
# A Makefile may set, before the include:
#   MESH := wheel.msh       a mesh of your own;  make neither writes nor cleans it
#   MODEL := wheel.h5       a model of your own, likewise;  FIELDS := wheel_fields.h5, if there are any
#   MODEL_OF := ../<case>   another case's sector.msh, model.h5 and fields.h5: one wheel, many casings
#   CASE := ../case.toml    another folder's case
#   SETTINGS := ...         options of all programs: --set casing.lobes=3
#   SIMULATE_FLAGS := ...   further options of tiprub-simulate, such as --set simulate.speed_count=12
#   LAUNCH := mpirun -n 4   what starts tiprub-simulate
#   BIN := ...              the folder of the programs; without it, build/bin of the source that this file is in, or bin of where it is installed
# [postprocess] response_up = "response_up.h5" asks for this case swept up as well, response_down = "response_down.h5" down; any
# other name is a file of your own, which make neither makes nor watches.
#
# No text of a case reaches a shell or make: stages are asked what they read, and only digests and fixed names come back.
TIPRUB ?= $(patsubst %/,%,$(dir $(lastword $(MAKEFILE_LIST))))/..
BIN ?= $(abspath $(or $(wildcard $(TIPRUB)/build/bin),$(TIPRUB)/../../bin))
export PATH := $(BIN):$(PATH)

.PHONY: all clean look
.DELETE_ON_ERROR:
all: report/report.html
	@cat report/critical_speeds.txt

blank := $() $()
in_shell = '$(subst ','\'',$1)'
as_prerequisite = $(subst $(blank),\ ,$1)
ifneq ($(words $(MODEL_OF)),$(if $(MODEL_OF),1,0))
$(error MODEL_OF = $(MODEL_OF): make takes no blanks in this name; reach it by a link without)
endif

# What make made is noted in .chain/<file>.sha256: it is nobody else's as long as it has these bytes, or is the link to MODEL_OF.
MADE_FOR_MODEL := sector.msh model.h5 fields.h5
MADE := $(MADE_FOR_MODEL) $(foreach sweep,response response_up response_down,$(sweep).h5 $(sweep)_full.h5)
is_made = { test "$$(readlink $$file)" = $(call in_shell,$(MODEL_OF))/$$file || sha256sum --status -c .chain/$$file.sha256; } 2> /dev/null
hint := make did not make it, and does not overwrite it; move it away, or name your own files as MESH and MODEL in the Makefile
leave_others = for file in $1; do test ! -e $$file || $(is_made) || { echo "$$file: $(hint)" >&2; exit 1; }; done
# How long a stage took, for the page; it is no file that anything hangs on.
times = --times .chain/$(basename $1).csv
note = for file in $1; do test ! -e $$file || sha256sum $$file > .chain/$$file.sha256; done

ifneq ($(MAKECMDGOALS),clean)

# A stage's stamp is named by the digest of what the stage reads of the case: where that changed, there is no such stamp.
FLAGS_simulate = $(SIMULATE_FLAGS)
CASE_FILE := $(if $(CASE),$(call in_shell,$(CASE)),case.toml)
tables = tiprub-$1 $(CASE_FILE) --tables $(SETTINGS) $(FLAGS_$1)
ask = PATH=$(call in_shell,$(BIN)):"$$PATH" $(tables) 2> /dev/null
stamp = .chain/$1-$(firstword $(shell $(ask) | sha256sum))
STAMP_mesh := $(if $(MESH)$(MODEL)$(MODEL_OF),,$(call stamp,mesh))
STAMP_reduce := $(if $(MODEL)$(MODEL_OF),,$(call stamp,reduce))
STAMP_simulate := $(call stamp,simulate)
STAMP_postprocess := $(call stamp,postprocess)
STAMPS := $(STAMP_mesh) $(STAMP_reduce) $(STAMP_simulate) $(STAMP_postprocess)

# "up", "down": this case's own name for its sweep; "other": a file of the user's.
SWEPT := $(shell $(call ask,postprocess) | sed -n 's/^response_\(up\|down\) = "response_\1\.h5"$$/\1/p; t; s/^response_\(up\|down\) = "[^"].*/other/p')
ifneq ($(filter other,$(SWEPT)),)
$(warning [postprocess] response_up or response_down names a file of your own: make neither makes nor watches it)
endif
SWEEPS := $(patsubst %,response_%.h5,$(filter-out other,$(SWEPT)))

LINKED := $(if $(MODEL_OF),$(shell for file in $(MADE_FOR_MODEL); do test "$$(readlink $$file)" = $(MODEL_OF)/$$file && echo $$file; done))
NOTED := $(patsubst .chain/%.sha256,%,$(wildcard .chain/*.sha256)) $(LINKED)
NEEDED := $(if $(MODEL),,$(filter-out $(if $(MESH),sector.msh),$(MADE_FOR_MODEL))) response.h5 $(SWEEPS)
OTHERS := $(filter-out $(NOTED),$(wildcard $(NEEDED)))
ifneq ($(OTHERS),)
$(error $(OTHERS): $(hint))
endif

$(STAMPS): .chain/%:
	@mkdir -p .chain && rm -f .chain/$(firstword $(subst -, ,$*))-*
	@$(call tables,$(firstword $(subst -, ,$*))) > $@

ifdef MODEL_OF
# Asked now, so that -n and -q know what hangs on it. One make for all its files: two at once would be in each other's way.
ITS_SOURCE := BIN=$(call in_shell,$(BIN)) $(if $(filter command,$(origin TIPRUB)),TIPRUB=$(call in_shell,$(TIPRUB)))
LOOK := $(shell MAKEFLAGS= $(MAKE) -q -C $(MODEL_OF) $(ITS_SOURCE) $(MADE_FOR_MODEL) > /dev/null 2>&1 || echo look)
$(MODEL_OF)/model.h5: $(LOOK)
	+@$(MAKE) --no-print-directory -C $(MODEL_OF) $(ITS_SOURCE) $(MADE_FOR_MODEL)
	@test -e $@
$(MODEL_OF)/sector.msh $(MODEL_OF)/fields.h5: | $(MODEL_OF)/model.h5

# A link is as old as what it points to, so that a model made anew reaches this case too.
$(MADE_FOR_MODEL): %: $(MODEL_OF)/%
	@$(call leave_others,$@)
	ln -sf $< $@
else ifndef MODEL
ifndef MESH
sector.msh: $(STAMP_mesh)
	@$(call leave_others,$@)
	tiprub-mesh $(CASE_FILE) -o $@ $(SETTINGS) $(call times,$@)
	@$(call note,$@)
endif
REDUCE = tiprub-reduce $(CASE_FILE) $(if $(MESH),$(call in_shell,$(MESH)),sector.msh) -o model.h5 --fields fields.h5 $(SETTINGS) $(call times,model.h5)
fields.h5: $(STAMP_reduce) $(call as_prerequisite,$(or $(MESH),sector.msh))
	@$(call leave_others,model.h5 fields.h5)
	$(REDUCE)
	@$(call note,model.h5 fields.h5)

# By the same run, after fields.h5; unless somebody removed it. (A rule for both at once, &:, is half forgotten by -n in make 4.3.)
model.h5: fields.h5
	@test $@ -nt $< || { $(REDUCE) && $(call note,model.h5 fields.h5); }
endif

ROTOR := $(if $(MODEL),$(call in_shell,$(MODEL)),model.h5)
ROTOR_FIELDS := $(if $(MODEL),$(if $(FIELDS),--fields $(call in_shell,$(FIELDS))),--fields fields.h5)
ROTOR_FILE := $(call as_prerequisite,$(or $(MODEL),model.h5))
FIELDS_FILE := $(call as_prerequisite,$(if $(MODEL),$(FIELDS),fields.h5))
SIMULATE = $(LAUNCH) tiprub-simulate $(CASE_FILE) $(ROTOR)
response.h5 response_up.h5 response_down.h5: $(STAMP_simulate) $(ROTOR_FILE)

response.h5:
	@$(call leave_others,$@ response_full.h5)
	$(SIMULATE) -o $@ $(SETTINGS) $(SIMULATE_FLAGS) $(call times,$@)
	@$(call note,$@ response_full.h5)

response_up.h5 response_down.h5: response_%.h5:
	@$(call leave_others,$@ response_$*_full.h5)
	$(SIMULATE) -o $@ --set 'simulate.sweep="$*"' $(SETTINGS) $(SIMULATE_FLAGS) $(call times,$@)
	@$(call note,$@ response_$*_full.h5)

# Of the stages that this make, or MODEL_OF's, has made; asked when the recipe runs.
MADE_HERE := $(if $(STAMP_mesh),sector) $(if $(STAMP_reduce),model) response $(basename $(SWEEPS))
RUNS := $(MADE_HERE:%=.chain/%.csv) $(if $(MODEL_OF),$(MODEL_OF)/.chain/sector.csv $(MODEL_OF)/.chain/model.csv)
runs = $(addprefix --runs ,$(shell ls $(RUNS) 2> /dev/null))
report/report.html: $(STAMPS) $(ROTOR_FILE) $(FIELDS_FILE) response.h5 $(SWEEPS)
	tiprub-postprocess $(CASE_FILE) $(ROTOR) response.h5 $(ROTOR_FIELDS) -o report $(SETTINGS) $(runs) > /dev/null

endif

# A report's own list says which of its files are the program's.
clean:
	@for file in $(filter-out $(MESH) $(MODEL) $(FIELDS),$(MADE)); do \
	  if $(is_made); then rm -f $$file; elif test -e $$file; then echo "$$file: kept; make did not make it"; fi; \
	done
	@test ! -f report/.tiprub-files || { cd report && find . ! -type d -printf '%P\0' | grep -zFxf .tiprub-files | \
	  xargs -0r rm -f -- && rm .tiprub-files && cd .. && find report -depth -type d -empty -delete; }
	@rm -rf .chain $(addsuffix .speeds,$(filter response%,$(MADE))) report.tiprub.part *.tiprub.part.*
