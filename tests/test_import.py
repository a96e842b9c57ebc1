"""Importing the package is quick, and every public name is where it says."""

import subprocess
import sys

import clerestory

HEAVY = ("xarray", "pandas", "matplotlib", "netCDF4", "pvlib", "ezdxf", "trimesh")


def test_every_public_name_has_its_place():
    assert set(clerestory.__all__) == {*clerestory._PLACES, "__version__"}
    for name in clerestory.__all__:
        assert getattr(clerestory, name) is not None
        assert name in dir(clerestory)


def test_the_static_and_the_lazy_imports_agree():
    import ast
    import inspect

    tree = ast.parse(inspect.getsource(clerestory))
    (block,) = [node for node in tree.body if isinstance(node, ast.If)]
    static = {alias.name: node.module for node in block.body for alias in node.names}
    assert static == clerestory._PLACES


def test_importing_the_package_imports_nothing_heavy():
    code = f"import sys, clerestory; print([name for name in {HEAVY} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=600)
    assert done.stdout.strip() == "[]"


def test_making_a_panel_imports_nothing_heavy():
    code = (
        "import sys; from clerestory import LaserCutPanel; LaserCutPanel(spacing_mm=3, thickness_mm=6); "
        f"print([name for name in {HEAVY} if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=600)
    assert done.stdout.strip() == "[]"


def test_a_module_does_not_hide_the_function_of_its_name():
    code = (
        "import clerestory.compare, clerestory.illuminance, clerestory.measured_glass; "
        "from clerestory import compare, illuminance, measured_glass; "
        "print(all(type(f).__name__ == 'function' for f in (compare, illuminance, measured_glass)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=600)
    assert done.stdout.strip() == "True"


def test_an_unknown_name_is_an_attribute_error():
    assert not hasattr(clerestory, "LaserCutPane")


def test_examples_in_docstrings_hold():
    import doctest

    from clerestory import drawing, medium, panels, profile

    modules = [medium, profile, drawing, panels.laser_cut, panels.prismatic, panels.pane]
    results = [doctest.testmod(module) for module in modules]
    assert sum(result.attempted for result in results) >= 6
    assert not any(result.failed for result in results)
