"""The house as planned: file names and lengths, which crate may see which, one version, nothing of one machine."""

import re
import tomllib
from pathlib import Path

SOURCES = {".rs", ".py", ".ts", ".tsx"}
LONGEST = 450
EMPTY_NAMES = {"utils", "util", "common", "helpers", "helper", "core", "base", "types", "manager", "misc"}
# A crate may rest on these and no others: house plan, ARCHITECTURE.md.
RESTS_ON = {
    "hemisphere": set(),
    "optics": {"hemisphere"},
    "panel": {"hemisphere", "optics"},
    "room": {"hemisphere", "optics"},
}
# Folders of one person's machine, and hosts that packages come from: an installer's settings, not the project's.
PLACES = re.compile(
    r"(?<![\w.:/-])/(?:home|root|work|Users|farm)/\w|[A-Z]:\\Users\\"
    r"|\bpypi\.org|pythonhosted\.org|(?:index|static)\.crates\.io|registry\.npmjs\.org|\bdeb\.debian\.org"
)


def test_files_are_named_after_an_idea(root: Path, files: list[Path]) -> None:
    named = [str(path.relative_to(root)) for path in files if path.suffix in SOURCES and path.stem in EMPTY_NAMES]
    assert not named, f"these names say nothing of what is inside: {named}"


def test_one_idea_a_file_is_short(root: Path, texts: dict[Path, str]) -> None:
    lengths = {
        path.relative_to(root): text.count("\n") for path, text in texts.items() if path.suffix in {".rs", ".py"}
    }
    long = [f"{path}: {length} lines" for path, length in lengths.items() if length > LONGEST]
    assert lengths
    assert not long, f"more than {LONGEST} lines, more than one idea:\n" + "\n".join(long)


def test_crates_rest_on_what_the_plan_says(root: Path) -> None:
    manifests = {path.parent.name: tomllib.loads(path.read_text()) for path in (root / "crates").glob("*/Cargo.toml")}
    assert {"hemisphere", "optics", "panel", "python"} <= set(manifests)
    for name, manifest in manifests.items():
        if name != "python":
            used = set(manifest.get("dependencies", {})) & set(manifests)
            assert used <= RESTS_ON[name], f"{name} must not rest on {sorted(used - RESTS_ON[name])}"


def test_libraries_do_not_panic_on_what_is_missing(root: Path) -> None:
    libraries = list((root / "crates").glob("*/src/lib.rs"))
    warning = "#![warn(clippy::unwrap_used, clippy::expect_used)]"
    assert not [path for path in libraries if warning not in path.read_text()], f"put {warning} into these"


def test_nothing_of_one_machine_is_written_down(root: Path, texts: dict[Path, str]) -> None:
    found = [
        f"{path.relative_to(root)}:{number}: {line.strip()[:100]}"
        for path, text in texts.items()
        # Cargo names its registry in its lock by an identifier of its own
        if path.name != "Cargo.lock"
        for number, line in enumerate(text.splitlines(), 1)
        if PLACES.search(line)
    ]
    assert not found, "\n".join(found)


def test_one_version_everywhere(root: Path) -> None:
    import clerestory

    version = tomllib.loads((root / "Cargo.toml").read_text())["workspace"]["package"]["version"]
    assert clerestory.__version__ == version
    assert f"\nversion: {version}\n" in (root / "CITATION.cff").read_text()
    assert f"\n## {version}" in (root / "CHANGELOG.md").read_text()


def test_locks_hold_every_package_by_hash(root: Path) -> None:
    for lock in (root / "requirements").glob("*.txt"):
        packages = re.split(r"\n(?=\S)", lock.read_text().strip())
        unlocked = [
            package.splitlines()[0] for package in packages if not re.search(r"==.*--hash=sha256:", package, re.S)
        ]
        assert packages
        assert not unlocked, f"{lock.name}: {unlocked}"


def test_locks_hold_every_declared_package(root: Path) -> None:
    project = tomllib.loads((root / "pyproject.toml").read_text())["project"]
    extras = project["optional-dependencies"]
    apart = {"bench": "bench.txt"}
    declared = {"lock.txt": list(project["dependencies"]), "bench.txt": []}
    for extra, requirements in extras.items():
        # an extra that names other extras of the project declares nothing itself by it
        declared[apart.get(extra, "lock.txt")] += [one for one in requirements if not one.startswith("clerestory[")]
    for lock, requirements in declared.items():
        locked = set(re.findall(r"^([\w.-]+)==", (root / "requirements" / lock).read_text(), re.MULTILINE))
        names = {re.match(r"[\w.-]+", requirement)[0].lower().replace("_", "-") for requirement in requirements}
        assert names <= locked, f"make {lock} again, as CONTRIBUTING.md says: {sorted(names - locked)}"


def test_public_names_are_documented() -> None:
    import clerestory

    bare = [name for name in clerestory.__all__ if name != "__version__" and not getattr(clerestory, name).__doc__]
    assert not bare, f"no docstring: {bare}"
