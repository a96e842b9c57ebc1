"""A classroom in Miami through a year: glass alone, a laser-cut panel above, a prismatic sheet above:

    python examples/classroom/classroom.py --out out/classroom

Weather, room, glazings and schedule stand in year.toml; `clerestory year` with that file does the same.
"""

import argparse
import sys
from pathlib import Path

from clerestory.year import State, read_year, run_year, write_year
from clerestory.year.figures import asked_for, text_of

STUDY = Path(__file__).with_name("year.toml")


def follow(state: State) -> None:
    """One line on a terminal, nothing in a file."""
    if sys.stderr.isatty():
        left = "" if state.seconds_left != state.seconds_left else f", {state.seconds_left:.0f} s to go"
        print(f"\r\033[K  {100 * state.done:3.0f} %  {state.variant}: {state.what}{left}", end="", file=sys.stderr)


def main(out: Path) -> None:
    study = read_year(STUDY)
    try:
        results = run_year(study, out, follow)
    except KeyboardInterrupt:
        sys.exit(f"\nstopped: what is finished is kept in {out}, the same command goes on from there")
    written = write_year(study, results, out)
    print("\r\033[K" if sys.stderr.isatty() else "", end="", file=sys.stderr)

    print(f"{study.name}: a year of daylight\n")
    print(f"  {'':36}" + "".join(f"{label:>24}" for label in results))
    for figure in asked_for(results):
        name = f"{figure.label} [{figure.unit}]" if figure.unit else figure.label
        print(f"  {name:36}" + "".join(f"{text_of(found, figure):>24}" for found in results.values()))
    print("\nResults:")
    for path in written:
        print(f"  {path}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path("out/classroom"), help="folder for the results")
    main(parser.parse_args().out)
