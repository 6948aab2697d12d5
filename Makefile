# With Python 3.11, 3.12 or 3.13 and make alone: `make run` computes the main case, `make test` runs the fast tests,
# `make test-python` those with another Python, `make test-slow` the slow ones, `make test-long` the longest,
# `make test-slurm` those with a queue, `make test-ross` those with a rotor, `make test-browser` those of reports in a browser.
PYTHON ?= python3
PYTHON_OTHER ?= python3.13
VENV := .venv
BIN := $(VENV)/bin
OTHER := $(VENV)-$(notdir $(PYTHON_OTHER))
FAST := env -u PYTHONDONTWRITEBYTECODE OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
READY := $(VENV)/.installed

export OMP_NUM_THREADS ?= 2
export OPENBLAS_NUM_THREADS ?= 2

.PHONY: run test test-python test-slow test-long test-slurm test-ross test-calculix test-browser test-docs lint benchmark docs lock clean

run: $(READY)
	$(BIN)/flexbearing run configs/mao2016.toml -o results/mao2016.h5
	$(BIN)/flexbearing plot results/mao2016.h5 -o results

# One thread for each of the workers: threads of several would fight over the cores. Compiled modules are kept, as
# the tests start many processes; an environment may forbid it.
test: $(READY)
	$(FAST) $(BIN)/python -m pytest -n auto --maxprocesses 4 --dist loadscope

# With the newest versions that this Python takes, in an environment of its own; requirements.lock is of Python 3.11.
test-python:
	$(PYTHON_OTHER) -m venv $(OTHER)
	$(OTHER)/bin/python -m pip install --quiet --upgrade pip
	$(OTHER)/bin/python -m pip install --quiet --upgrade --upgrade-strategy eager --group dev --editable '.[studies]'
	$(FAST) $(OTHER)/bin/python -m pytest -n auto --maxprocesses 4 --dist loadscope

test-slow: $(READY)
	$(FAST) $(BIN)/python -m pytest -m slow -n auto --maxprocesses 2 --dist loadscope

# Whole solids and a shipped optimum computed again, which takes minutes; not in continuous integration.
test-long: $(READY)
	$(FAST) $(BIN)/python -m pytest -m long -n auto --maxprocesses 2 --dist load

# For root, with the Debian packages slurm-wlm and munge: a queue with two nodes on this machine.
test-slurm: $(READY)
	$(BIN)/python -m pytest -m slurm

# With an installed Chromium (Debian: apt install chromium).
test-browser: $(READY)
	$(BIN)/python -m pytest -m browser

# Links and figures of the documentation; its pages in a browser where Chromium is installed.
test-docs: docs
	$(BIN)/python -m pytest -m docs tests/site

# ROSS 2.3 is the last version for Python 3.11, and wants an older plotly.
test-ross: $(READY)
	$(PYTHON) -m venv $(VENV)-ross
	$(VENV)-ross/bin/python -m pip install --quiet 'ross-rotordynamics==2.3.0' 'plotly<7'
	FLEXBEARING_ROSS=$(abspath $(VENV)-ross)/bin/python $(BIN)/python -m pytest -m ross

# With the Debian package calculix-ccx.
test-calculix: $(READY)
	$(BIN)/python -m pytest -m calculix

lint: $(READY)
	$(BIN)/codespell
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/lint-imports
	$(BIN)/pyright --pythonpath $(BIN)/python
	$(BIN)/python -m pytest -q tests/architecture/test_idioms.py

benchmark: $(READY)
	$(BIN)/python -m benchmarks.main_job

# Computes all cases of docs/evidence again; `make test` and `make test-slow` fail where their numbers moved.
evidence: $(READY)
	$(BIN)/python -m evidence

docs: $(READY)
	$(BIN)/python -m flexbearing.example_drawings configs docs/images/drawings
	$(BIN)/python -m flexbearing.reference docs/reference
	$(BIN)/python -m sphinx -W --keep-going -q -j 2 docs docs/_build/html

$(READY): pyproject.toml requirements.lock
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --upgrade pip
	$(BIN)/python -m pip install --quiet --requirement requirements.lock
	$(BIN)/python -m pip install --quiet --no-deps --editable .
	touch $(READY)

# Versions that were tested together with Python 3.11, which PYTHON must be; renewed on purpose only.
lock:
	$(PYTHON) -m venv $(VENV)-lock
	$(VENV)-lock/bin/python -m pip install --quiet --upgrade pip
	$(VENV)-lock/bin/python -m pip install --quiet --group dev '.[studies]'
	$(VENV)-lock/bin/python -m pip freeze --exclude flexbearing > requirements.lock
	rm -rf $(VENV)-lock

clean:
	rm -rf $(VENV) $(VENV)-ross $(VENV)-python* build docs/_build *.egg-info .pytest_cache .ruff_cache .import_linter_cache
