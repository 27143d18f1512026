# SPDX-License-Identifier: GPL-3.0-or-later
# Takes a case to its report by the four programs. The folder of a case holds case.toml and a Makefile that includes this file.
#   make             makes everything that is out of date, and prints the critical speeds
#   make model.h5    makes one file and what it needs;  make -B model.h5 makes it in any case
#   make look        checks everything that the stages read of the case, and computes nothing
#   make clean       removes what make has made, and nothing else
# A stage is out of date if the values that it reads of case.toml have changed, or a file that it reads; comments and spelling do not
# count. Everything that the stages read of the case is checked before the first of them starts.
#
# A Makefile may set these variables before the include:
#   MESH := wheel.msh       a mesh of your own, which make neither writes nor removes
#   MADE := wheel.msh       files that rules of the Makefile make, by $(call make_own,COMMAND), before the stages read the case
#   MODEL := wheel.h5       a model of your own, likewise;  FIELDS := wheel_fields.h5 if it has full fields
#   MODEL_OF := ../<case>   takes sector.msh, model.h5 and fields.h5 of another case, for one wheel in many casings
#   CASE := ../case.toml    takes the case file of another folder
#   SETTINGS := ...         options of all programs, such as --set casing.lobes=3
#   SIMULATE_FLAGS := ...   further options of tiprub-simulate, such as --set simulate.speed_count=12
#   LAUNCH := mpirun -n 4   the command that starts tiprub-simulate
#   BIN := ...              the folder of the programs; by default build/bin of the source that holds this file, or bin of its installation
# If [postprocess] sets response_up = "response_up.h5", make also sweeps this case up, and down for response_down = "response_down.h5".
# Any other name there is a file of your own, which make neither makes nor watches.
#
# chain.sh, beside this file, finds out what has changed and which files are make's own.
CHAIN_FOLDER := $(patsubst %/,%,$(dir $(lastword $(MAKEFILE_LIST))))
TIPRUB ?= $(CHAIN_FOLDER)/..
BIN ?= $(abspath $(or $(wildcard $(TIPRUB)/build/bin),$(TIPRUB)/../../bin))
export PATH := $(BIN):$(PATH)

.PHONY: all clean look $(addprefix look_,mesh reduce simulate postprocess)
.DELETE_ON_ERROR:
# The programs leave no half files, and a whole one may be the work of hours.
.PRECIOUS: sector.msh model.h5 fields.h5 response.h5 response_up.h5 response_down.h5
all: report/report.html
	@cat report/critical_speeds.txt

blank := $() $()
in_shell = '$(subst ','\'',$1)'
as_prerequisite = $(subst $(blank),\ ,$1)
CHAIN := env BIN=$(call in_shell,$(BIN)) MODEL_OF=$(call in_shell,$(MODEL_OF)) MADE=$(call in_shell,$(MADE)) sh $(call in_shell,$(CHAIN_FOLDER)/chain.sh)
CASE_FILE := $(if $(CASE),$(call in_shell,$(CASE)),case.toml)
MODEL_FILES := sector.msh model.h5 fields.h5
ifneq ($(words $(MODEL_OF)),$(if $(MODEL_OF),1,0))
$(error MODEL_OF = $(MODEL_OF): make takes no blanks in this name; reach it by a link without)
endif
clean:
	@$(CHAIN) clean $(foreach own,MESH MODEL FIELDS,$(call in_shell,$($(own))))

ifneq ($(MAKECMDGOALS),clean)
make_own = @$(CHAIN) require_made $@ $< && echo '$1' && $1 && $(CHAIN) note $@ ''
ifdef MADE
# The stages read these files with the case, before any rule runs. make makes the files that a Makefile includes first, and starts again.
include .chain/made.mk
.chain/made.mk: $(MADE)
	@mkdir -p .chain && touch $@
endif

# What each stage reads of the case, as a digest; none for a stage that this case leaves out.
values = $(shell $(CHAIN) name_values $1 $(CASE_FILE) $(SETTINGS) $(FLAGS_$1))
FLAGS_simulate = $(SIMULATE_FLAGS)
VALUES_mesh := $(if $(MESH)$(MODEL)$(MODEL_OF),,$(call values,mesh))
VALUES_reduce := $(if $(MODEL)$(MODEL_OF),,$(call values,reduce))
VALUES_simulate := $(call values,simulate)
VALUES_postprocess := $(call values,postprocess)
LOOKS := $(patsubst %,look_%,$(if $(VALUES_mesh),mesh) $(if $(VALUES_reduce),reduce) simulate postprocess)
look_mesh look_reduce look_simulate look_postprocess: look_%:
	@$(CHAIN) look $* $(CASE_FILE) $(SETTINGS) $(FLAGS_$*)
look: $(LOOKS)

# look_STAGE if a file was made of other values or other files than there are now. Their dates do not suffice: clocks may be set back.
own_file = $(if $1,own:$(call in_shell,$1))
stale = $(if $(VALUES_$1),$(if $(shell $(CHAIN) is_made_of $2 $(VALUES_$1) $3),,look_$1))
SWEPT := $(shell $(CHAIN) name_sweeps $(CASE_FILE) $(SETTINGS))
ifneq ($(filter other,$(SWEPT)),)
$(warning [postprocess] response_up or response_down names a file of your own: make neither makes nor watches it)
endif
RESPONSES := response.h5 $(patsubst %,response_%.h5,$(filter-out other,$(SWEPT)))
OTHERS := $(shell $(CHAIN) name_others $(if $(MODEL),,$(filter-out $(if $(MESH),sector.msh),$(MODEL_FILES))) $(RESPONSES))
ifneq ($(OTHERS),)
$(error $(OTHERS): $(shell $(CHAIN) hint))
endif

ifdef MODEL_OF
# The other case is looked at now, so that -n and -q know of it. One make makes all its files, because two at once would collide.
ITS_SOURCE := BIN=$(call in_shell,$(BIN)) $(if $(filter command,$(origin TIPRUB)),TIPRUB=$(call in_shell,$(TIPRUB)))
LOOK := $(shell MAKEFLAGS= $(MAKE) -q -C $(MODEL_OF) $(ITS_SOURCE) $(MODEL_FILES) > /dev/null 2>&1 || echo look)
$(MODEL_OF)/model.h5: $(LOOK)
	+@$(MAKE) --no-print-directory -C $(MODEL_OF) $(ITS_SOURCE) $(MODEL_FILES)
	@test -e $@
$(MODEL_OF)/sector.msh $(MODEL_OF)/fields.h5: | $(MODEL_OF)/model.h5

# make looks at the age of the file that a link points to, so that a new model reaches this case too.
$(MODEL_FILES): %: $(MODEL_OF)/%
	@$(CHAIN) require_own $@
	ln -sf $< $@
else ifndef MODEL
STALE_mesh := $(call stale,mesh,sector.msh)
# exec: a SIGTERM that make sends to its child reaches chain.sh, which passes it on.
READ_reduce := $(if $(MESH),$(call own_file,$(MESH)),sector.msh)
STALE_reduce := $(STALE_mesh) $(call stale,reduce,fields.h5,$(READ_reduce))
ifndef MESH
sector.msh: $(STALE_mesh)
	@exec $(CHAIN) run $@ $(VALUES_mesh) -- \
	  tiprub-mesh $(CASE_FILE) -o $@ $(SETTINGS) --times .chain/sector.csv
endif
REDUCE = exec $(CHAIN) run 'fields.h5 model.h5' $(VALUES_reduce) $(READ_reduce) -- \
  tiprub-reduce $(CASE_FILE) $(if $(MESH),$(call in_shell,$(MESH)),sector.msh) -o model.h5 --fields fields.h5 $(SETTINGS) --times .chain/model.csv
fields.h5: $(STALE_reduce) $(call as_prerequisite,$(or $(MESH),sector.msh))
	@$(REDUCE)

# The run that made fields.h5 has made model.h5 after it, unless somebody has removed that since. (make -n of 4.3 forgets half of a
# rule for both files, &:.)
model.h5: fields.h5
	@test -e $@ -a ! $< -nt $@ || $(REDUCE)
endif

ROTOR := $(if $(MODEL),$(call in_shell,$(MODEL)),model.h5)
ROTOR_FIELDS := $(if $(MODEL),$(FIELDS),fields.h5)
BUDGET_MODEL := $(shell $(CHAIN) name_budget_model $(CASE_FILE) $(SETTINGS) $(FLAGS_simulate))
BUDGET_FIELDS := $(if $(ROTOR_FIELDS),$(shell $(CHAIN) name_budget_fields $(CASE_FILE) $(SETTINGS) $(FLAGS_simulate)))
READ_simulate := $(if $(MODEL),$(call own_file,$(MODEL)),model.h5) $(call own_file,$(BUDGET_MODEL))
READ_postprocess := $(if $(MODEL),$(call own_file,$(FIELDS)),fields.h5) $(call own_file,$(BUDGET_FIELDS)) $(RESPONSES)
STALE_rotor := $(STALE_reduce) $(LOOK)
STALE_response = $(STALE_rotor) $(call stale,simulate,$1,$(READ_simulate))
response.h5: $(call STALE_response,response.h5)
response_up.h5: $(if $(filter response_up.h5,$(RESPONSES)),$(call STALE_response,response_up.h5))
response_down.h5: $(if $(filter response_down.h5,$(RESPONSES)),$(call STALE_response,response_down.h5))
response.h5 response_up.h5 response_down.h5: $(call as_prerequisite,$(BUDGET_MODEL))
response.h5 response_up.h5 response_down.h5: %.h5: $(call as_prerequisite,$(or $(MODEL),model.h5))
	@exec $(CHAIN) run '$@ $*_full.h5 $*_plain.h5 $*_one_term.h5' $(VALUES_simulate) $(READ_simulate) -- $(LAUNCH) \
	  tiprub-simulate $(CASE_FILE) $(ROTOR) -o $@ $(patsubst response_%,--set 'simulate.sweep="%"',$(filter response_%,$*)) $(SETTINGS) $(SIMULATE_FLAGS) --times .chain/$*.csv

# The report shows how long those stages took that this make, or that of MODEL_OF, has run. Their notes are looked for when it is made.
RUNS := $(patsubst %,.chain/%.csv,$(if $(VALUES_mesh),sector) $(if $(VALUES_reduce),model) $(basename $(RESPONSES))) \
  $(if $(MODEL_OF),$(MODEL_OF)/.chain/sector.csv $(MODEL_OF)/.chain/model.csv)
STALE_report := $(foreach file,$(RESPONSES),$(call STALE_response,$(file))) $(call stale,postprocess,report/report.html,$(READ_simulate) $(READ_postprocess))
report/report.html: $(if $(strip $(STALE_report)),$(LOOKS)) $(call as_prerequisite,$(or $(MODEL),model.h5)) $(call as_prerequisite,$(ROTOR_FIELDS)) $(call as_prerequisite,$(BUDGET_FIELDS)) $(RESPONSES)
	tiprub-postprocess $(CASE_FILE) $(ROTOR) response.h5 $(if $(ROTOR_FIELDS),--fields $(if $(MODEL),$(call in_shell,$(FIELDS)),fields.h5)) \
	  $(if $(BUDGET_FIELDS),--budget-fields $(call in_shell,$(BUDGET_FIELDS))) -o report $(SETTINGS) $(addprefix --runs ,$(shell ls $(RUNS) 2> /dev/null)) > /dev/null
	@$(CHAIN) note report/report.html $(VALUES_postprocess) $(READ_simulate) $(READ_postprocess)
endif
