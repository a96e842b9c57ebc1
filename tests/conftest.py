"""Chance is the same in every run, and no test is judged by the clock.

A run of the tests says whether a change broke something, so it tries the same examples each time, whichever tests run
with them and wherever. ``pytest --hypothesis-profile=search`` looks for others.
"""

import contextlib
import importlib
import pkgutil

import pytest
from hypothesis import HealthCheck, settings

import clerestory

#: How long an example takes to draw depends on the machine; fixtures that live as long as a test hold no state here.
UNTOLD = [HealthCheck.too_slow, HealthCheck.function_scoped_fixture]

settings.register_profile("search", deadline=None, suppress_health_check=UNTOLD, print_blob=True)
settings.register_profile("same", settings.get_profile("search"), derandomize=True, database=None)
settings.load_profile("same")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Loads the whole package before the first example: Hypothesis tries the constants of modules that are loaded."""
    if any(getattr(getattr(item, "obj", None), "is_hypothesis_test", False) for item in items):
        for module in pkgutil.walk_packages(clerestory.__path__, "clerestory."):
            # an extra may not be installed
            with contextlib.suppress(ImportError):
                importlib.import_module(module.name)
