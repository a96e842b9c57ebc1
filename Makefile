# Every job sets up what it needs first; nothing is done twice. `make help` lists the jobs.
# NATIVE=1 builds for the processor of this machine; PYTHON names the interpreter that .venv is made from.
PYTHON ?= python3
JOBS := prepare run test check validate bench wheel clean

.PHONY: help $(JOBS)
.DEFAULT_GOAL := help
export NATIVE

help $(JOBS):
	@command -v $(PYTHON) >/dev/null 2>&1 || { echo "clerestory: Python 3.11 or newer is needed: install python3 (python.org/downloads, or apt install python3 python3-venv)" >&2; exit 1; }
	@$(PYTHON) tools/bootstrap.py $@
