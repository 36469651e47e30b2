# Few verbs, one command each; demo and test do everything on a bare Debian 12, packages included.
JOBS ?= $(shell nproc)
PRESET ?= release
PREFIX ?= /usr/local
SOURCES = git ls-files '*.cpp' '*.hpp'

.PHONY: demo test build bench format format-check lint install clean packages configure

demo: configure
	cmake --build build/$(PRESET) -j $(JOBS) --target limpet
	tools/demo.sh build/$(PRESET)/limpet

test: build
	ctest --test-dir build/$(PRESET) -j2 --output-on-failure

build: configure
	cmake --build build/$(PRESET) -j $(JOBS)

bench:
	tools/install_packages.sh bench
	cmake --preset bench
	cmake --build --preset bench -j $(JOBS)
	@echo "benchmarks, limpet-float and limpet-float-grid are in build/bench"

format: packages
	$(SOURCES) | xargs clang-format -i

format-check: packages
	$(SOURCES) | xargs clang-format --dry-run -Werror

lint: configure
	tools/install_packages.sh lint
	git ls-files '*.cpp' | xargs -P $(JOBS) -n 4 clang-tidy --quiet -p build/$(PRESET)

install: build
	cmake --install build/$(PRESET) --prefix $(PREFIX)

clean:
	rm -rf build out

configure: packages
	cmake --preset $(PRESET)

packages:
	tools/install_packages.sh
