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
# chain.sh, beside this file, looks at what the stages read of the case, and at which files are make's own; see there.
CHAIN_FOLDER := $(patsubst %/,%,$(dir $(lastword $(MAKEFILE_LIST))))
TIPRUB ?= $(CHAIN_FOLDER)/..
BIN ?= $(abspath $(or $(wildcard $(TIPRUB)/build/bin),$(TIPRUB)/../../bin))
export PATH := $(BIN):$(PATH)

.PHONY: all clean look
.DELETE_ON_ERROR:
all: report/report.html
	@cat report/critical_speeds.txt

blank := $() $()
in_shell = '$(subst ','\'',$1)'
as_prerequisite = $(subst $(blank),\ ,$1)
CHAIN := BIN=$(call in_shell,$(BIN)) MODEL_OF=$(call in_shell,$(MODEL_OF)) sh $(call in_shell,$(CHAIN_FOLDER)/chain.sh)
CASE_FILE := $(if $(CASE),$(call in_shell,$(CASE)),case.toml)
MODEL_FILES := sector.msh model.h5 fields.h5
ifneq ($(words $(MODEL_OF)),$(if $(MODEL_OF),1,0))
$(error MODEL_OF = $(MODEL_OF): make takes no blanks in this name; reach it by a link without)
endif
clean:
	@$(CHAIN) clean $(foreach own,MESH MODEL FIELDS,$(call in_shell,$($(own))))

ifneq ($(MAKECMDGOALS),clean)
stamp = $(shell $(CHAIN) name_stamp $1 $(CASE_FILE) $(SETTINGS) $(FLAGS_$1))
FLAGS_simulate = $(SIMULATE_FLAGS)
STAMP_mesh := $(if $(MESH)$(MODEL)$(MODEL_OF),,$(call stamp,mesh))
STAMP_reduce := $(if $(MODEL)$(MODEL_OF),,$(call stamp,reduce))
STAMP_simulate := $(call stamp,simulate)
STAMP_postprocess := $(call stamp,postprocess)
STAMPS := $(STAMP_mesh) $(STAMP_reduce) $(STAMP_simulate) $(STAMP_postprocess)
$(STAMPS): .chain/%:
	@$(CHAIN) write_stamp $@ $(CASE_FILE) $(SETTINGS) $(FLAGS_$(firstword $(subst -, ,$*)))

SWEPT := $(shell $(CHAIN) name_sweeps $(CASE_FILE) $(SETTINGS))
ifneq ($(filter other,$(SWEPT)),)
$(warning [postprocess] response_up or response_down names a file of your own: make neither makes nor watches it)
endif
SWEEPS := $(patsubst %,response_%.h5,$(filter-out other,$(SWEPT)))
OTHERS := $(shell $(CHAIN) name_others $(if $(MODEL),,$(filter-out $(if $(MESH),sector.msh),$(MODEL_FILES))) response.h5 $(SWEEPS))
ifneq ($(OTHERS),)
$(error $(OTHERS): $(shell $(CHAIN) hint))
endif

ifdef MODEL_OF
# The other case is asked now, so that -n and -q know of it. One make makes all its files: two at once would collide.
ITS_SOURCE := BIN=$(call in_shell,$(BIN)) $(if $(filter command,$(origin TIPRUB)),TIPRUB=$(call in_shell,$(TIPRUB)))
LOOK := $(shell MAKEFLAGS= $(MAKE) -q -C $(MODEL_OF) $(ITS_SOURCE) $(MODEL_FILES) > /dev/null 2>&1 || echo look)
$(MODEL_OF)/model.h5: $(LOOK)
	+@$(MAKE) --no-print-directory -C $(MODEL_OF) $(ITS_SOURCE) $(MODEL_FILES)
	@test -e $@
$(MODEL_OF)/sector.msh $(MODEL_OF)/fields.h5: | $(MODEL_OF)/model.h5

# make looks at the age of what a link points to, so that a model made anew reaches this case too.
$(MODEL_FILES): %: $(MODEL_OF)/%
	@$(CHAIN) require_own $@
	ln -sf $< $@
else ifndef MODEL
ifndef MESH
sector.msh: $(STAMP_mesh)
	@$(CHAIN) require_own $@
	tiprub-mesh $(CASE_FILE) -o $@ $(SETTINGS) --times .chain/sector.csv
	@$(CHAIN) note $@
endif
REDUCE = tiprub-reduce $(CASE_FILE) $(if $(MESH),$(call in_shell,$(MESH)),sector.msh) -o model.h5 --fields fields.h5 $(SETTINGS) --times .chain/model.csv
fields.h5: $(STAMP_reduce) $(call as_prerequisite,$(or $(MESH),sector.msh))
	@$(CHAIN) require_own model.h5 $@
	$(REDUCE)
	@$(CHAIN) note model.h5 $@

# The same run has made it, after fields.h5, unless somebody has removed it since. (-n of make 4.3 half forgets a rule for both, &:.)
model.h5: fields.h5
	@test $@ -nt $< || { $(REDUCE) && $(CHAIN) note $@ $<; }
endif

ROTOR := $(if $(MODEL),$(call in_shell,$(MODEL)),model.h5)
ROTOR_FIELDS := $(if $(MODEL),$(FIELDS),fields.h5)
response.h5 response_up.h5 response_down.h5: %.h5: $(STAMP_simulate) $(call as_prerequisite,$(or $(MODEL),model.h5))
	@$(CHAIN) require_own $@ $*_full.h5
	$(LAUNCH) tiprub-simulate $(CASE_FILE) $(ROTOR) -o $@ $(patsubst response_%,--set 'simulate.sweep="%"',$(filter response_%,$*)) $(SETTINGS) $(SIMULATE_FLAGS) --times .chain/$*.csv
	@$(CHAIN) note $@ $*_full.h5

# The report shows how long the stages took that this make, or that of MODEL_OF, has run; their notes are looked for when it is made.
RUNS := $(patsubst %,.chain/%.csv,$(if $(STAMP_mesh),sector) $(if $(STAMP_reduce),model) response $(basename $(SWEEPS))) \
  $(if $(MODEL_OF),$(MODEL_OF)/.chain/sector.csv $(MODEL_OF)/.chain/model.csv)
report/report.html: $(STAMPS) $(call as_prerequisite,$(or $(MODEL),model.h5)) $(call as_prerequisite,$(ROTOR_FIELDS)) response.h5 $(SWEEPS)
	tiprub-postprocess $(CASE_FILE) $(ROTOR) response.h5 $(if $(ROTOR_FIELDS),--fields $(if $(MODEL),$(call in_shell,$(FIELDS)),fields.h5)) \
	  -o report $(SETTINGS) $(addprefix --runs ,$(shell ls $(RUNS) 2> /dev/null)) > /dev/null
endif
