"""Sets up everything Clerestory needs, then does one job: ``python3 tools/bootstrap.py JOB``.

The standard library alone, so that a machine with only Python, Rust and a C linker can begin here. It makes ``.venv``,
installs the locked packages and builds the native module; each step is skipped while what it rests on is unchanged.
The Makefile calls it; where there is no ``make``, call it yourself.
"""

import hashlib
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
VENV = os.path.join(ROOT, ".venv")
SCRIPTS = os.path.join(VENV, "Scripts" if os.name == "nt" else "bin")
PYTHON = os.path.join(SCRIPTS, "python.exe" if os.name == "nt" else "python")
PACKAGE = os.path.join(ROOT, "python", "clerestory")
PYTHON_NEEDED = (3, 11)
RUST_NEEDED = (1, 85)
NODE_NEEDED = 18
#: The studio's page: what it is made from, and where it lies in the package.
STUDIO = os.path.join(ROOT, "studio")
PAGE = os.path.join(PACKAGE, "studio", "page")


def stop(message):
    """Ends with one line that says what to do."""
    sys.stderr.write("clerestory: " + message + "\n")
    sys.exit(1)


def said_by(*command):
    """What a tool prints, or None if it is missing or fails."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    except OSError:
        return None
    return done.stdout.decode("utf-8", "replace") if done.returncode == 0 else None


def do(*command, **variables):
    """Runs a command in the root of the project and ends with its exit code if it fails."""
    environment = dict(os.environ, VIRTUAL_ENV=VENV, **variables)
    environment["PATH"] = SCRIPTS + os.pathsep + environment.get("PATH", "")
    environment.pop("PYTHONHOME", None)
    try:
        code = subprocess.call(command, cwd=ROOT, env=environment)
    except KeyboardInterrupt:
        code = 130
    if code != 0:
        sys.exit(code)


def read(path):
    """The bytes of a file, none if it is not there."""
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError:
        return b""


def once(name, inputs, step, outputs=tuple):
    """Does ``step`` unless it was last finished with these same inputs and its outputs are as it left them."""
    stamp = os.path.join(VENV, "clerestory-" + name + ".stamp")
    wanted = hashlib.sha256(repr(inputs).encode()).hexdigest()
    if read(stamp).decode() == f"{wanted} {outputs()}":
        return
    if os.path.exists(stamp):
        os.remove(stamp)
    step()
    with open(stamp, "w") as file:
        file.write(f"{wanted} {outputs()}")


def check_tools():
    """Stops at the first tool that is missing or too old; returns the Rust compiler's version line."""
    if sys.version_info < PYTHON_NEEDED:
        found = ".".join(map(str, sys.version_info[:3]))
        stop(
            f"Python 3.11 or newer is needed, found {found}: install it, then run this again "
            "(make PYTHON=/path/to/python3 names one)"
        )
    rust = said_by("rustc", "--version") or ""
    version = re.match(r"rustc (\d+)\.(\d+)", rust)
    if version is None or said_by("cargo", "--version") is None:
        missing = "rustc" if version is None else "cargo"
        stop(f"{missing} is needed (Rust 1.85 or newer): install Rust with rustup, see rust-lang.org/tools/install")
    if tuple(map(int, version.groups())) < RUST_NEEDED:
        stop(f"Rust 1.85 or newer is needed, found {rust.split()[1]}: run `rustup update stable`")
    if os.name != "nt" and said_by("cc", "--version") is None:
        stop(
            "a C linker (cc) is needed by Rust: install one (Debian, Ubuntu: apt install gcc libc6-dev; "
            "Fedora: dnf install gcc; macOS: xcode-select --install)"
        )
    return rust


def make_environment():
    """An empty virtual environment with pip in it."""
    print("clerestory: making .venv", flush=True)
    shutil.rmtree(VENV, ignore_errors=True)
    if said_by(sys.executable, "-c", "import venv, ensurepip") is not None:
        do(sys.executable, "-m", "venv", VENV)
    elif said_by(sys.executable, "-c", "import venv, pip") is not None:
        # Debian leaves ensurepip out of python3: the pip outside can still install into an environment without one
        do(sys.executable, "-m", "venv", "--without-pip", VENV)
        do(sys.executable, "-m", "pip", "--python", PYTHON, "install", "--quiet", "pip")
    else:
        stop("Python's venv module is needed: install it (Debian, Ubuntu: apt install python3-venv)")


def install(lock):
    """The packages of one lock file, each checked against its hash."""
    print("clerestory: installing the packages of " + lock, flush=True)
    do(
        PYTHON,
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        "--require-hashes",
        "--only-binary",
        ":all:",
        "-r",
        os.path.join(ROOT, *lock.split("/")),
    )


def rust_sources():
    """Every file the native module is built from, and its bytes."""
    paths = [os.path.join(ROOT, name) for name in ("Cargo.toml", "Cargo.lock", "pyproject.toml")]
    for folder, folders, files in os.walk(os.path.join(ROOT, "crates")):
        folders.sort()
        paths += [os.path.join(folder, name) for name in sorted(files)]
    return [(os.path.relpath(path, ROOT), hashlib.sha256(read(path)).hexdigest()) for path in paths]


def cargo_variables():
    """NATIVE=1 builds for the processor of this machine, beside the portable build and not over it."""
    if os.environ.get("NATIVE", "0") in ("", "0"):
        return {}
    flags = (os.environ.get("RUSTFLAGS", "") + " -C target-cpu=native").strip()
    return {"RUSTFLAGS": flags, "CARGO_TARGET_DIR": os.path.join(ROOT, "target", "native")}


def build():
    """The native module, optimised, and the package installed in place."""
    print("clerestory: building the native module" + (" for this processor" if cargo_variables() else ""), flush=True)
    do(
        PYTHON,
        "-m",
        "maturin",
        "develop",
        "--release",
        "--locked",
        "--quiet",
        PIP_NO_INDEX="1",
        PIP_QUIET="1",
        **cargo_variables(),
    )


def native_module():
    """The built module as it lies in the package: name, size, time."""
    found = [name for name in sorted(os.listdir(PACKAGE)) if re.match(r"_native\..*(so|pyd)$", name)]
    return [(name, os.stat(os.path.join(PACKAGE, name)).st_mtime_ns) for name in found]


def page_sources():
    """Every file the studio's page is built from, and its bytes."""
    paths = []
    for folder, folders, files in os.walk(STUDIO):
        folders[:] = sorted(name for name in folders if name != "node_modules")
        paths += [os.path.join(folder, name) for name in sorted(files)]
    return [(os.path.relpath(path, ROOT), hashlib.sha256(read(path)).hexdigest()) for path in paths]


def page_files():
    """The built page as it lies in the package: names and sizes."""
    found = []
    for folder, folders, files in os.walk(PAGE):
        folders.sort()
        paths = [os.path.join(folder, name) for name in sorted(files)]
        found += [(os.path.relpath(path, PAGE), os.path.getsize(path)) for path in paths]
    return found


def build_page():
    """The studio's page, from locked packages whose own scripts do not run."""
    print("clerestory: building the studio's page", flush=True)
    npm = [shutil.which("npm"), "--silent", "--prefix", STUDIO]
    for command in (
        ["ci", "--ignore-scripts", "--no-audit", "--no-fund"],
        ["run", "build", "--", "--logLevel", "warn"],
    ):
        code = subprocess.call(npm + command, cwd=STUDIO, stdin=subprocess.DEVNULL)
        if code != 0:
            raise RuntimeError(f"npm {command[0]} ended with {code}")


def prepare_page():
    """The studio's page if Node.js is there; all else works without."""
    version = re.match(r"v(\d+)\.", said_by("node", "--version") or "")
    if version is None or int(version.group(1)) < NODE_NEEDED or shutil.which("npm") is None:
        if not page_files():
            print("clerestory: no page for `clerestory studio`: Node.js 18 or newer with npm builds it", flush=True)
        return
    try:
        once("page", page_sources(), build_page, page_files)
    except (OSError, RuntimeError) as error:
        print(f"clerestory: no new page for `clerestory studio`: {error}; all else works without", flush=True)


def prepare():
    """Environment, packages, native module and the studio's page, as far as they are not there yet."""
    rust = check_tools()
    if said_by(PYTHON, "-c", "import pip, sys; sys.exit(sys.version_info < (3, 11))") is None:
        make_environment()
    once("packages", read(os.path.join(ROOT, "requirements", "lock.txt")), lambda: install("requirements/lock.txt"))
    once("native", (ROOT, rust, os.environ.get("RUSTFLAGS"), cargo_variables(), rust_sources()), build, native_module)
    prepare_page()


def run():
    """The main job: a classroom through a year with three glazings, and a laser-cut panel; results in out/."""
    do(PYTHON, os.path.join("examples", "classroom", "classroom.py"), "--out", os.path.join("out", "classroom"))
    do(PYTHON, os.path.join("examples", "laser_cut_panel.py"), "--out", "out")


def test():
    """All tests, Rust and Python."""
    do("cargo", "test", "--workspace", "--locked", "--quiet")
    do(PYTHON, "-m", "pytest", "-n", "auto", "-q")


def check():
    """Format, lints, types and the rules of the house."""
    if said_by("cargo", "fmt", "--version") is None or said_by("cargo", "clippy", "--version") is None:
        stop("rustfmt and clippy are needed for this check: run `rustup component add rustfmt clippy`")
    do("cargo", "fmt", "--all", "--check")
    do("cargo", "clippy", "--workspace", "--all-targets", "--locked", "--quiet", "--", "-D", "warnings")
    do(PYTHON, "-m", "ruff", "check", "--quiet")
    do(PYTHON, "-m", "ruff", "format", "--check", "--quiet")
    do(PYTHON, "-m", "mypy")
    do(PYTHON, "-m", "pytest", "-q", "tests/house")


def validate():
    """Every claim of docs/validation.md computed again, with its figures; the studio's calls asked at length."""
    do(PYTHON, os.path.join("tests", "validation", "report.py"))
    do(PYTHON, "-m", "pytest", "-q", "tests/studio/test_openapi.py", CLERESTORY_FUZZ="400")


def bench():
    """Speed: the benches of the crates, then the race against other programs."""
    once(
        "bench-packages",
        read(os.path.join(ROOT, "requirements", "bench.txt")),
        lambda: install("requirements/bench.txt"),
    )
    do("cargo", "bench", "--workspace", "--locked", **cargo_variables())
    do(PYTHON, os.path.join("benches", "peers", "race.py"))
    do(PYTHON, os.path.join("benches", "peers", "room_race.py"))
    do(PYTHON, os.path.join("benches", "peers", "bsdf_race.py"))
    do(PYTHON, os.path.join("benches", "peers", "year_race.py"))
    do(PYTHON, os.path.join("benches", "sweep", "scaling.py"))
    do(PYTHON, os.path.join("benches", "studio", "dragging.py"))
    do(PYTHON, os.path.join("benches", "studio", "drag_to_picture.py"))


def wheel():
    """A wheel for this platform in dist/."""
    do(PYTHON, "-m", "maturin", "build", "--release", "--locked", "--quiet", "--out", "dist", **cargo_variables())


def clean():
    """Removes what was made here: .venv, target, out, dist and caches."""
    for name in (".venv", "target", "out", "dist", ".pytest_cache", ".ruff_cache", ".mypy_cache", ".hypothesis"):
        shutil.rmtree(os.path.join(ROOT, name), ignore_errors=True)
    for folder in (PAGE, os.path.join(STUDIO, "node_modules")):
        shutil.rmtree(folder, ignore_errors=True)
    for name, _ in native_module():
        os.remove(os.path.join(PACKAGE, name))


JOBS = {job.__name__: job for job in (prepare, run, test, check, validate, bench, wheel, clean)}


def main(arguments):
    if len(arguments) != 1 or arguments[0] not in JOBS:
        print("python3 tools/bootstrap.py JOB, where JOB is\n")
        for name, job in JOBS.items():
            print(f"  {name:9} {job.__doc__}")
        return 0 if arguments == ["help"] else 2
    if arguments[0] not in ("prepare", "clean"):
        prepare()
    JOBS[arguments[0]]()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
