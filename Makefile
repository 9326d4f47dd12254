# CAIR: everything a developer or operator types. `make run` and `make test` are all one needs.
PYTHON ?= python3
HOST ?= 127.0.0.1
PORT ?= $(or $(CAIR_PORT),8000)
WORKERS ?= $(shell $(PYTHON) -c "import os; print(os.cpu_count() or 2)")
BIN := .venv/bin
BENCH := PYTHONPATH=. $(BIN)/python benchmarks
MANAGE := $(BIN)/python manage.py
PURE_PYTEST := PYTHONPATH=. $(BIN)/python -m pytest -p no:django -p no:cacheprovider -c /dev/null --rootdir=. --import-mode=importlib

.PHONY: run setup test test-engine test-server test-browser check format bench transcripts openapi plans content demo clean

run: setup ## Set everything up and serve on http://HOST:PORT/
	@echo "CAIR is at http://$(HOST):$(PORT)/ (Ctrl-C ends it)"
	@exec $(BIN)/gunicorn --config cair_site/gunicorn_conf.py --bind $(HOST):$(PORT) --workers $(WORKERS) cair_site.wsgi

setup: .venv/installed ## Virtual environment, database, content, publication: only what is missing
	@$(MANAGE) prepare

.venv/installed: requirements.txt
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements.txt
	@touch $@

.venv/installed-dev: .venv/installed requirements-dev.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements-dev.txt
	@touch $@

test: .venv/installed test-engine ## All fast tests: engines without Django, then the site
	$(BIN)/python -m pytest -q -n 2 --dist loadfile -m "not browser and not server" --ignore=tests/engine

test-engine: .venv/installed ## The pure engines, with Django impossible to import
	$(PURE_PYTEST) -q tests/engine

test-server: .venv/installed cluster-programs ## Real gunicorn on loopback: clients, hostile bodies, publishing under load, deploy/
	$(BIN)/python -m pytest -q -m server tests/server tests/clients tests/deploy

.PHONY: cluster test-cluster test-faults cluster-programs
cluster-programs:
	@missing=""; \
	for program in haproxy pgbouncer; do PATH="$$PATH:/usr/sbin" command -v $$program >/dev/null || missing="$$missing $$program"; done; \
	ls /usr/lib/postgresql/*/bin/postgres >/dev/null 2>&1 || missing="$$missing postgresql"; \
	if [ -n "$$missing" ] && [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
		apt-get update -qq; apt-get install -y -qq $$missing >/dev/null; \
	fi || echo "Not installed:$$missing. What needs them is skipped."

cluster: .venv/installed-bench cluster-programs ## PostgreSQL, three nodes and HAProxy on this machine; Ctrl-C ends all
	$(BIN)/python -m cluster $(ARGS)

test-cluster: .venv/installed-bench cluster-programs ## Break a cluster in every way under load: docs/operations/cluster-trial.md
	$(BIN)/python -m cluster.trial $(ARGS)

test-faults: .venv/installed cluster-programs ## The same as tests: no turn fails, no state is lost; writes nothing
	$(BIN)/python -m pytest -q -m cluster tests/cluster

EXAMPLES ?= 10
SECONDS_EACH ?= 120

.venv/installed-fuzz: .venv/installed requirements-fuzz.txt
	$(PYTHON) -m venv .venv/fuzz
	.venv/fuzz/bin/python -m pip install --quiet --disable-pip-version-check -r requirements-fuzz.txt
	@touch $@

.PHONY: fuzz fuzz-api fuzz-readers
fuzz-api: .venv/installed-fuzz ## The API held to its own schema, on a gunicorn of its own; EXAMPLES=10 a call
	$(BIN)/python -m tests.fuzz.live --examples $(EXAMPLES) $(ARGS)

fuzz-readers: .venv/installed-fuzz ## Atheris on what strangers send; SECONDS_EACH=120, findings in var/fuzz
	@for target in state codec trigger library body owl; do \
	  .venv/fuzz/bin/python -m tests.fuzz.coverage_guided $$target -max_total_time=$(SECONDS_EACH) || exit 1; done

fuzz: fuzz-readers ## All fuzzing, longer: readers, sentences, talks, the API
	FUZZ_EXAMPLES=3000 $(BIN)/python -m pytest -q tests/fuzz/test_readers.py tests/fuzz/test_sentences.py
	FUZZ_EXAMPLES=500 $(BIN)/python -m pytest -q tests/fuzz/test_talks.py
	$(MAKE) fuzz-api EXAMPLES=300

ROS_PACKAGES = catkin g++ ros-message-generation ros-std-msgs ros-std-srvs python3-rospy python3-roslaunch \
	python3-rosservice python3-rostopic python3-std-msgs python3-std-srvs

.PHONY: test-ros
test-ros: .venv/installed ## The ROS clients: a real roscore where Debian's ROS is, a stub of rclpy
	@if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null && ! dpkg -s $(ROS_PACKAGES) >/dev/null 2>&1; then \
		apt-get update -qq; \
		DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $(ROS_PACKAGES) >/dev/null; \
	fi || echo "ROS could not be installed: its tests are skipped"
	$(BIN)/python -m pytest -q -rs tests/clients/ros

.PHONY: test-postgres
test-postgres: .venv/installed ## The site's tests on a private PostgreSQL (Debian's package postgresql)
	$(BIN)/python -m tests.postgres $(BIN)/python -m pytest -q -n 2 --dist loadfile -m "not browser and not server" --ignore=tests/engine

test-browser: .venv/installed ## The web chat and the admin in headless Chromium
	$(BIN)/python -m pytest -q -m browser tests/browser

.PHONY: pictures
pictures: .venv/installed ## The pictures of docs/authors-guide.md, from a server of their own
	PYTHONPATH=. $(BIN)/python -m tests.browser.admin.make_pictures

check: .venv/installed-dev ## Formatting, linters, types, arrows, migrations, content
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/lint-imports
	$(BIN)/mypy
	$(BIN)/djlint --lint --quiet templates
	$(BIN)/codespell
	$(MANAGE) makemigrations --check --dry-run
	$(MANAGE) check_content
	$(MANAGE) check_intents
	$(BIN)/python deploy/audit.py

.PHONY: audit
audit: .venv/installed-dev ## Known weaknesses of the packages we stand on, where they can be looked up
	$(BIN)/python deploy/audit.py

format: .venv/installed-dev ## Format the code
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

bench: .venv/installed-bench ## What each part costs now, beside the recorded figures; those of docs/figures.md
	$(BIN)/python -m benchmarks.micro $(ARGS)
	$(BENCH)/state_size.py
	$(BENCH)/keywords.py
	$(BENCH)/tree.py
	$(BENCH)/tree.py --frames-per-class 0
	$(BENCH)/turn.py

.PHONY: bench-growth bench-servers
bench-growth: .venv/installed-bench ## docs/performance/growth.svg: cost against topics, sentences, intents, turns
	$(BIN)/python -m benchmarks.growth $(ARGS)

bench-servers: .venv/installed-bench ## The same application on different servers, with and without stalled clients
	$(BIN)/python -m benchmarks.servers $(ARGS)

.PHONY: bench-matching
bench-matching: .venv/installed-bench ## Figures of docs/matching.md, beside hassil; ARGS=--quick for a short run
	$(BIN)/python -m benchmarks.matching $(ARGS)

.PHONY: bench-paper paper-programs
paper-programs:
	@[ -f /usr/share/jmeter/lib/ext/ApacheJMeter_http.jar ] || [ "$$(id -u)" != 0 ] || \
		{ apt-get update -qq && apt-get install -y -qq jmeter jmeter-http; } >/dev/null 2>&1 || true

bench-paper: .venv/installed-bench paper-programs ## The paper's experiments, beside its design re-created; ARGS=--quick
	$(BIN)/python -m benchmarks.paper $(ARGS)

.venv/installed-bench: .venv/installed requirements-bench.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements-bench.txt
	@touch $@

content: setup ## Load content/ into the draft and write it back: canonical form, numbers for what is new
	$(MANAGE) load_content
	$(MANAGE) publish
	$(MANAGE) dump_content

transcripts: setup ## Write docs/transcripts/ again (same seeds, same talks)
	$(MANAGE) talk --transcripts docs/transcripts

plans: setup ## Write docs/plans.md
	$(MANAGE) plan_guide

openapi: setup ## Write docs/openapi.yaml
	$(MANAGE) spectacular --file docs/openapi.yaml

demo: setup ## One user a role to look around in /admin/, passwords shown once; never where people are served
	@$(MANAGE) demo

clean: ## Remove what make made; the database in var/ stays
	rm -rf .venv staticfiles .mypy_cache .ruff_cache .pytest_cache
