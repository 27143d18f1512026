# SPDX-License-Identifier: GPL-3.0-or-later
#   make demo       installs what is missing, builds, and runs the quick impeller from its case to its report
#   make install PREFIX=/opt/tiprub   programs, manual, completion, cases, and the files' libraries;  make deb  makes Debian packages of them
#   make test       installs what is missing, builds, and tests;  make test-all takes the slow tests in
#   make test-sanitized   the unit tests in a Debug build with address and undefined-behaviour sanitizers
#   make fuzz       5,000 damaged inputs of a new seed for the readers of all files;  FUZZ_INPUTS, FUZZ_SEED; BUILD=build-sanitized
#   make paper-checks   makes the paper's cases (under an hour on two cores), and says which of the 81 checks hold
#   make paper-checks PAPER_CASES=cases/impeller_quick   the same for other cases
#   make bench      speed of the parts that cost, and beside CalculiX (half an hour, most of it CalculiX's)
#   make format     formats the code;  make check-format and make lint check it
BUILD ?= build
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local
DEMO := cases/impeller_quick
PAPER_CASES ?= cases/impeller cases/impeller_three_lobes
FUZZ_INPUTS ?= 5000

.PHONY: all packages configure programs manual tests demo install deb test test-all tests-sanitized test-sanitized fuzz paper-checks bench format check-format lint clean
all: programs

packages:
	@.ci/install-packages

configure: packages
	@cmake -G Ninja -S . -B $(BUILD) > $(BUILD).configure.log 2>&1 || { cat $(BUILD).configure.log; exit 1; }
	@rm -f $(BUILD).configure.log

programs: configure
	ninja -C $(BUILD) -j $(JOBS) programs

manual: programs
	ninja -C $(BUILD) -j $(JOBS) manual

install: manual
	cmake --install $(BUILD) --prefix $(PREFIX)

deb: manual
	cd $(BUILD) && cpack
	@echo "As root: apt-get install $(abspath $(BUILD))/tiprub_*.deb"

tests: configure
	ninja -C $(BUILD) -j $(JOBS)

demo: programs
	+$(MAKE) -C $(DEMO) BIN=$(abspath $(BUILD))/bin
	@echo "The report: $(abspath $(DEMO))/report/report.html"

test: tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS) -LE slow

test-all: tests
	ctest --test-dir $(BUILD) --output-on-failure -j $(JOBS)

# detect_container_overflow: vectors pass between our code and libraries that are built without it, which it takes for wrong.
# OPENBLAS_CORETYPE: zgemv of OpenBLAS 0.3.21 for Sandy Bridge, Haswell and Skylake crashes on a read there, as if it read past its
# operands' end into what the sanitizers leave unmapped; the older kernels don't.
SANITIZERS := LSAN_OPTIONS=suppressions=$(CURDIR)/.ci/leaks.supp:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1 \
  ASAN_OPTIONS=detect_container_overflow=0 OPENBLAS_CORETYPE=Nehalem
# The unit tests of all rooms, the fuzzed readers, and the faults that the sanitizers must find. Left out are long numerics
# (slow; stability, chain, peers; orders of branches), what counts on the time or the memory that a program takes, and the
# comparison with Trilinos' eigensolver: they touch no memory that the others don't.
SANITIZED := programs write-synthetic-scene gmsh_sector cases_test mesh_test model_file_test reduce_test reduce_linear_test \
  split_sector simulate_test postprocess-test postprocess-program-test planted_fault convert_sector tiprub_fuzz

tests-sanitized: packages
	cmake -G Ninja -S . -B $(BUILD)-sanitized -DCMAKE_BUILD_TYPE=Debug -DTIPRUB_SANITIZE=ON > $(BUILD)-sanitized.configure.log
	ninja -C $(BUILD)-sanitized -j $(JOBS) $(SANITIZED)

test-sanitized: tests-sanitized
	$(SANITIZERS) ctest --test-dir $(BUILD)-sanitized --output-on-failure -j $(JOBS) -R '^(cases|mesh|reduce|simulate|postprocess|fuzz|structure)\.' \
	    -LE slow -E 'interrupted|too_little_memory|no_room|in_browser|anasazi|Branch.*(ConvergeTo|ReferencesThat)'

fuzz: programs
	ninja -C $(BUILD) -j $(JOBS) tiprub_fuzz convert_sector
	$(SANITIZERS) /usr/bin/python3 -B tests/fuzz/fuzz.py $(abspath $(BUILD))/bin tests/chain/small_disc.toml $(BUILD)/fuzz $(FUZZ_INPUTS) $(FUZZ_SEED)

paper-checks: tests
	+for case in $(PAPER_CASES); do $(MAKE) -C $$case BIN=$(abspath $(BUILD))/bin || exit 1; done
	/usr/bin/python3 -B tests/paper_checks/paper_checks.py $(BUILD) cases $(PAPER_CASES)

bench: tests
	$(BUILD)/bin/tiprub-benchmark
	/usr/bin/python3 -B tests/peers/side_by_side.py $(BUILD)/bin/tiprub-mesh $(BUILD)/bin/tiprub-reduce cases/fast_impeller_fine/case.toml $(BUILD)/side_by_side

format:
	git ls-files '*.h' '*.cc' | xargs clang-format -i

check-format:
	git ls-files '*.h' '*.cc' | xargs clang-format --dry-run -Werror

lint: packages
	.ci/tidy-changed --all

clean:
	rm -rf $(BUILD) $(BUILD)-sanitized
