"""The type stub says what the binary holds: every public name, every parameter."""

import ast
import inspect
from pathlib import Path
from types import ModuleType
from typing import Any

from clerestory import _native

Function = ast.FunctionDef
Parameters = list[tuple[str, str, bool]]

KINDS = {
    inspect.Parameter.POSITIONAL_ONLY: "positional",
    inspect.Parameter.POSITIONAL_OR_KEYWORD: "either",
    inspect.Parameter.KEYWORD_ONLY: "keyword",
    inspect.Parameter.VAR_POSITIONAL: "rest",
    inspect.Parameter.VAR_KEYWORD: "named rest",
}


def public(name: str) -> bool:
    return not name.startswith("_") or name == "__version__"


def built_parameters(of: Any) -> Parameters:
    """Name, kind and whether there is a default, from the binary."""
    found = inspect.signature(of).parameters.values()
    return [(p.name, KINDS[p.kind], p.default is not p.empty) for p in found if p.name not in {"self", "cls"}]


def stub_parameters(function: Function) -> Parameters:
    """The same from the stub."""
    arguments = function.args
    positional = [(a, "positional") for a in arguments.posonlyargs] + [(a, "either") for a in arguments.args]
    without_default = len(positional) - len(arguments.defaults)
    found = [(a.arg, kind, place >= without_default) for place, (a, kind) in enumerate(positional)]
    if arguments.vararg:
        found.append((arguments.vararg.arg, "rest", False))
    found += [
        (a.arg, "keyword", default is not None)
        for a, default in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True)
    ]
    if arguments.kwarg:
        found.append((arguments.kwarg.arg, "named rest", False))
    return [p for p in found if p[0] not in {"self", "cls"}]


def declared(body: list[ast.stmt]) -> dict[str, ast.stmt]:
    """The names that a stub, or a class in it, declares."""
    names: dict[str, ast.stmt] = {}
    for node in body:
        if isinstance(node, Function | ast.ClassDef):
            names[node.name] = node
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            names[node.target.id] = node
        elif isinstance(node, ast.Assign):
            names |= {target.id: node for target in node.targets if isinstance(target, ast.Name)}
    return names


def is_property(node: ast.stmt) -> bool:
    return isinstance(node, Function) and any(
        isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list
    )


def differences(built: Any, body: list[ast.stmt], path: str) -> list[str]:
    """What the binary and the stub say differently, one line each."""
    own = vars(built) if inspect.isclass(built) or isinstance(built, ModuleType) else {}
    stub = {name: node for name, node in declared(body).items() if public(name)}
    in_binary = {name for name in own if public(name)}
    found = [f"{path}.{name} is not in the stub" for name in sorted(in_binary - set(stub))]
    for name, node in stub.items():
        where = f"{path}.{name}"
        if name not in in_binary:
            # a type alias or a type variable is the stub's own
            if not (isinstance(node, ast.Assign) or (isinstance(node, ast.AnnAssign) and node.value is not None)):
                found.append(f"{where} is not in the binary")
            continue
        value = getattr(built, name)
        if isinstance(node, ast.ClassDef):
            found += differences(value, node.body, where)
            made_by = declared(node.body).get("__new__") or declared(node.body).get("__init__")
            if isinstance(made_by, Function) and built_parameters(value) != stub_parameters(made_by):
                found.append(f"{where}: built {built_parameters(value)}, stub {stub_parameters(made_by)}")
        elif isinstance(node, Function) and not is_property(node):
            if not callable(value):
                found.append(f"{where} is a {type(value).__name__}, the stub has a function")
            elif built_parameters(value) != stub_parameters(node):
                found.append(f"{where}: built {built_parameters(value)}, stub {stub_parameters(node)}")
        elif callable(value) and not inspect.isclass(value):
            found.append(f"{where} is callable, the stub has an attribute")
    return found


def test_stub_matches_the_binary(root: Path) -> None:
    stub = ast.parse((root / "python/clerestory/_native.pyi").read_text())
    found = differences(_native, stub.body, "_native")
    assert not found, "\n".join(found)


def test_a_wrong_stub_is_seen() -> None:
    class Built:
        def turned(self, angle: float, *, about: str = "x") -> None: ...

    right = "def turned(self, angle: float, *, about: str = ...) -> None: ..."
    wrong = "def turned(self, angle: float, about: str) -> None: ...\ndef gone(self) -> None: ..."
    assert differences(Built, ast.parse(right).body, "Built") == []
    assert len(differences(Built, ast.parse(wrong).body, "Built")) == 2
    assert len(differences(Built, [], "Built")) == 1
