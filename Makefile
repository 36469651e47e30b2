# Few verbs, one command each; demo and test do everything on a bare Debian 12, packages included.
JOBS ?= $(shell nproc)
PRESET ?= release
PREFIX ?= /usr/local
SOURCES = git ls-files '*.cpp' '*.hpp'

.PHONY: demo test build sanitize fuzz coverage same-bytes tsan mutants bench bench-predicates bench-following bench-compare benchmarks
.PHONY: format format-check lint install clean packages configure

demo: configure
	cmake --build build/$(PRESET) -j $(JOBS) --target limpet
	tools/demo.sh build/$(PRESET)/limpet

test: build
	tools/test.sh build/$(PRESET)

build: configure
	cmake --build build/$(PRESET) -j $(JOBS)

# With ASan and UBSan: what reads files, a model without memory, and the commands on all that their tests give them.
# SUITES="io memory" for some of them: folders of tests/.
sanitize: SUITES = audit io memory cases app
sanitize: packages
	tools/install_packages.sh sanitize
	cmake --preset sanitize
	cmake --build build/sanitize -j $(JOBS) --target $(SUITES:%=limpet_%_tests)
	for suite in $(SUITES); do tools/test.sh build/sanitize/tests/$$suite || exit 1; done

# Each kind of input for so many SECONDS; what is found becomes a case in out/fuzz. KINDS="scan mesh" for some of them.
fuzz: build
	tools/install_packages.sh fuzz
	cmake --preset fuzz
	cmake --build --preset fuzz -j $(JOBS) --target limpet_fuzzers
	tools/fuzz.sh $(or $(SECONDS),600) $(KINDS)

# Lines of geometry/ and model/ that tests and fuzzing run.
coverage: packages
	tools/install_packages.sh fuzz
	JOBS=$(JOBS) tools/coverage.sh

# Two compilers, with and without optimisation, and sanitizers: the same bytes from all, on simulated and real scans.
same-bytes: packages
	tools/install_packages.sh fuzz
	JOBS=$(JOBS) tools/same_bytes.sh

# Readers of one model side by side, under ThreadSanitizer.
tsan: packages
	cmake --preset tsan && cmake --build --preset tsan -j $(JOBS)
	ctest --preset tsan

# Breaks conditions in geometry/ and model/ one at a time, and asks the tests which they notice.
mutants: packages
	tools/mutate.py --jobs $(JOBS)

# The report of docs/benchmarks.md, in out/bench: about a quarter of an hour; FULL=1 takes hours and 1 GB of scratch.
bench:
	tools/install_packages.sh bench
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS) --target limpet_bench
	build/bench/benchmarks/limpet_bench report --out out/bench $(if $(FULL),--full) $(if $(PARTS),--parts $(PARTS)) \
	  --commit "$$(git describe --always --dirty)"
	for picture in streams sizes; do [ ! -f out/bench/$$picture.csv ] || \
	  gnuplot -e "folder='out/bench'" benchmarks/plots/$$picture.gp; done
	@echo "out/bench/report.md, with its tables as CSV and its pictures"

# What exactness costs and what the float builds break (docs/predicates.md), in out/predicates: a quarter of an
# hour; FULL=1 takes hours.
bench-predicates:
	tools/install_packages.sh bench
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS) --target bench_predicates
	build/bench/benchmarks/predicates/limpet_predicates report --out out/predicates $(if $(FULL),--full) \
	  $(if $(PARTS),--parts $(PARTS)) --commit "$$(git describe --always --dirty)"
	for picture in runs operations laws unions; do [ ! -f out/predicates/$$picture.csv ] || \
	  gnuplot -e "folder='out/predicates'" benchmarks/plots/predicates_$$picture.gp; done
	@echo "out/predicates/report.md, with its tables as CSV and its pictures"

# How well surfaces are followed (docs/benchmarks.md), in out/following: about half an hour; FULL=1 takes hours.
# SECTIONS="faults memory" for some of them, PARTS="a.off b.off" for mesh files, too.
bench-following:
	tools/install_packages.sh bench
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS) --target limpet_following_bench
	mkdir -p out/following
	for section in $(or $(SECTIONS),worlds table1 sensitivity faults memory $(if $(PARTS),parts)); do \
	  build/bench/benchmarks/following/limpet_following_bench $$section $$([ $$section = parts ] && echo "$(PARTS)") \
	  $(if $(FULL),--starts 20 --oracle 10,--max-seconds 60) --workers $(JOBS) \
	  --json out/following/$$section.json > out/following/$$section.md || exit; done
	@echo "out/following has a table and all figures of each section"

# HEAD against BASE, on the same scans in turn.
bench-compare:
	tools/install_packages.sh bench
	benchmarks/compare_commits.py $(or $(BASE),$(error BASE=<commit> is missing)) $(HEAD) --jobs $(JOBS)

# All benchmarks, and the program with each build of geometry/.
benchmarks:
	tools/install_packages.sh bench
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS)
	@echo "benchmarks, limpet-float and limpet-float-grid are in build/bench"

format: packages
	$(SOURCES) | xargs clang-format -i

format-check: packages
	$(SOURCES) | xargs clang-format --dry-run -Werror

lint: packages
	tools/install_packages.sh lint
	cmake --preset lint
	tools/lint.py build/lint --jobs $(JOBS)

install: build
	cmake --install build/$(PRESET) --prefix $(PREFIX)

clean:
	rm -rf build out

configure: packages
	cmake --preset $(PRESET)

packages:
	tools/install_packages.sh
