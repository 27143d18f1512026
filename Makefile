# SPDX-License-Identifier: GPL-3.0-or-later
#   make demo       installs missing packages, builds, and runs the quick impeller from its case to its report
#   make install PREFIX=/opt/tiprub   installs programs, manual, completion, cases and the libraries of the files
#   make deb        makes Debian packages of the same
#   make test       installs missing packages, builds, and runs the tests;  make test-all also runs the slow ones
#   make test-sanitized   runs the unit tests in a Debug build with address and undefined-behaviour sanitizers
#   make fuzz       gives the reader of each kind of file 300 damaged inputs of a new seed;  FUZZ_INPUTS, FUZZ_SEED; BUILD=build-sanitized
#   make paper-checks   makes the two wheels of cases/paper, and tells which of the 81 checks hold on each, in its pages
#   make bench      measures the speed of the costly parts, also against CalculiX, into build/bench/price.tsv (an hour, 6 GiB)
#   make format     formats the code;  make check-format and make lint check it
BUILD ?= build
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
DEMO := cases/impeller_quick
PAPER_CHECKS = /usr/bin/python3 -B tests/paper_checks/paper_checks.py $(BUILD) cases
FUZZ_INPUTS ?= 300

.PHONY: all packages configure programs manual tests demo install deb test test-all tests-sanitized test-sanitized fuzz paper-checks bench format check-format lint clean
all: programs

packages:
	@.ci/install-packages

# A new build folder is for the programs alone, until `make tests` adds the tests, which need more packages.
CONFIGURE = @cmake -G Ninja -S . -B $(BUILD) $1 > $(BUILD).configure.log 2>&1 || { cat $(BUILD).configure.log; exit 1; }; rm -f $(BUILD).configure.log

configure: packages
	$(call CONFIGURE,$(if $(wildcard $(BUILD)/CMakeCache.txt),,-DBUILD_TESTING=OFF))

programs: configure
	ninja -C $(BUILD) -j $(JOBS) programs

manual: packages
	@.ci/install-packages packages-install.txt
	+@$(MAKE) --no-print-directory programs
	ninja -C $(BUILD) -j $(JOBS) manual

install: manual
	cmake --install $(BUILD) --prefix $(PREFIX)

deb: manual
	cd $(BUILD) && cpack
	@echo "As root: apt-get install $(abspath $(BUILD))/tiprub_*.deb $(abspath $(BUILD))/tiprub-reduce_*.deb"

tests: packages
	@.ci/install-packages packages-install.txt packages-test.txt
	$(call CONFIGURE,-DBUILD_TESTING=ON)
	ninja -C $(BUILD) -j $(JOBS)

demo: programs
	+$(MAKE) -C $(DEMO) BIN=$(abspath $(BUILD))/bin
	@echo "The report: $(abspath $(DEMO))/report/report.html"

test: tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -LE slow

test-all: tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

# detect_container_overflow is off, because vectors pass between our code and libraries that are built without it, and it reports them.
# OPENBLAS_CORETYPE: with sanitizers, zgemv of OpenBLAS 0.3.21 crashes on a read in its kernels for Sandy Bridge, Haswell and Skylake,
# apparently past the end of its operands. The older kernels don't.
SANITIZERS := LSAN_OPTIONS=suppressions=$(CURDIR)/.ci/leaks.supp:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1 \
  ASAN_OPTIONS=detect_container_overflow=0 OPENBLAS_CORETYPE=Nehalem
# These are the unit tests of all rooms, the fuzzed readers, and planted faults that the sanitizers must find. Left out are long
# computations (slow; stability, chain, peers; orders of branches; those of reduce_test on large sectors), tests that depend on the
# time or the memory of a program, and the comparison with Trilinos' eigensolver. None of these reaches code that the others don't.
SANITIZED := programs write-synthetic-scene gmsh_sector cases_test mesh_test model_file_test reduce_test reduce_linear_test \
  split_sector simulate_test postprocess-test postprocess-program-test planted_fault convert_sector tiprub_fuzz

tests-sanitized:
	@.ci/install-packages packages-install.txt packages-test.txt packages-gate.txt
	cmake -G Ninja -S . -B $(BUILD)-sanitized -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug -DTIPRUB_SANITIZE=ON > $(BUILD)-sanitized.configure.log
	ninja -C $(BUILD)-sanitized -j $(JOBS) $(SANITIZED)

test-sanitized: tests-sanitized
	$(SANITIZERS) GTEST_FILTER='-*AgainstFinerMeshes*:Segments.AreAsSoft*:Reduction.BlamesAShape*' \
	  ctest --test-dir $(BUILD)-sanitized --output-on-failure -j $(JOBS) -R '^(cases|mesh|reduce|simulate|postprocess|fuzz|structure)\.' \
	    -LE slow -E 'GmshsOrder|interrupted|too_little_memory|no_room|in_browser|anasazi|Branch.*(ConvergeTo|ReferencesThat)'

fuzz: packages
	@.ci/install-packages packages-install.txt packages-test.txt
	$(call CONFIGURE,-DBUILD_TESTING=ON)
	ninja -C $(BUILD) -j $(JOBS) tiprub_fuzz convert_sector
	FUZZ_SEED=$(or $(FUZZ_SEED),$(shell date +%s)) FUZZ_INPUTS=$(FUZZ_INPUTS) $(SANITIZERS) \
	  ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -R '^fuzz\.'; code=$$?; \
	grep -A 1 '^reader' $(BUILD)/Testing/Temporary/LastTest.log; exit $$code

paper-checks: tests
	+$(MAKE) -C cases/paper BIN=$(abspath $(BUILD))/bin
	-$(PAPER_CHECKS) cases/paper/two_lobes cases/paper/three_lobes --table=cases/paper/expected/checks_paper_like.tsv
	-$(PAPER_CHECKS) cases/paper/flying_two_lobes cases/paper/flying_three_lobes --table=cases/paper/expected/checks_flying.tsv
	/usr/bin/python3 -B cases/paper/tell_checks.py
	/usr/bin/python3 -B cases/fill_pages.py

bench: tests
	/usr/bin/python3 -B tests/benchmark/price.py $(BUILD)/bin $(BUILD)/bench
	gnuplot -e 'folder="$(BUILD)/bench"' tests/benchmark/scaling.gnuplot

format:
	git ls-files '*.h' '*.cc' | xargs clang-format -i

check-format:
	git ls-files '*.h' '*.cc' | xargs clang-format --dry-run -Werror

lint: packages
	.ci/tidy-changed --all

clean:
	rm -rf $(BUILD) $(BUILD)-sanitized
