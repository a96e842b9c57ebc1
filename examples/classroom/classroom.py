"""A classroom with a laser-cut panel above its window, compared with glass alone:

    python examples/classroom/classroom.py --out out/classroom

Room, glazings and skies stand in classroom.toml; `clerestory room` with that file does the same.
"""

import argparse
from pathlib import Path

from clerestory.study import read_study, run_study, summary
from clerestory.study_report import write_report

ROOM = Path(__file__).with_name("classroom.toml")


def main(out: Path) -> None:
    study = read_study(ROOM)
    findings = run_study(study)
    written = write_report(study, findings, out)

    print("Classroom in Maceió, 4 × 8 × 3 m, window to the north\n")
    print("  glazing                      daylight factor [%]: mean   least   min/mean   error   CPU")
    for label, row in summary(findings).items():
        factor = row["daylight_factor_percent"]
        print(
            f"  {label:46}  {factor['mean']:5.2f}   {factor['least']:5.2f}   {factor['uniformity']:8.2f}"
            f"   ≤ {factor['worst_relative_standard_error']:.0%}   {row['cpu_seconds']:.1f} s"
        )
    for sky in study.skies:
        print(f"\n  {sky} [lx]: mean, least")
        for label, row in summary(findings).items():
            lit = row["illuminance_lx"][sky]
            print(f"  {label:46}  {lit['mean']:5.0f}   {lit['least']:5.0f}")
    print("\nResults:")
    for path in written:
        print(f"  {path}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=Path("out/classroom"), help="folder for the results")
    main(parser.parse_args().out)
