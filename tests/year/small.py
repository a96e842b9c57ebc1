"""A year file that is computed in seconds."""

from pathlib import Path

YEAR = """
title = "Small room"
name = "glass"
[weather]
file = "clear.wea"
[glazings.glass]
kind = "glass"
transmittance = 0.8
[glazings.dark]
kind = "glass"
transmittance = 0.4
[glazings.panel]
kind = "laser-cut"
spacing_mm = 4.0
thickness_mm = 6.0
[shoebox]
width_m = 3
depth_m = 5
height_m = 3
[[shoebox.opening]]
width_m = 2.4
height_m = 1.6
name = "window"
[[shoebox.opening.part]]
glazing = "glass"
height_m = 0.6
[[shoebox.opening.part]]
glazing = "glass"
[[sensors]]
spacing_m = 1.0
[[variant]]
name = "panel above"
glazing = { "window 1" = "panel" }
[[variant]]
name = "dark"
glazing = { "window 1" = "dark", "window 2" = "dark" }
[[blinds]]
windows = ["window 2"]
[schedule]
hours = ["08:00-16:00"]
[lighting]
power_density_w_m2 = 8
[calculation]
suns = "reinhart577"
rounds = 4
nodes = 256
window_samples = 32
sun_rounds = 2
seed = 3
"""


def write_small(folder: Path, text: str = YEAR) -> Path:
    """The year file and its weather: three days of March, hour by hour, two of them clear."""
    rows = []
    for month, day, clear in ((3, 20, True), (3, 21, False), (3, 22, True)):
        for hour in range(24):
            up = 8 <= hour <= 15
            rows.append(f"{month} {day} {hour + 0.5} {700 * (up and clear):d} {(120 if clear else 200) * up:d}")
    heading = (
        "place Testtown\nlatitude 25.8\nlongitude 80.3\ntime_zone 75\nsite_elevation 11\nweather_data_file_units 1\n"
    )
    (folder / "clear.wea").write_text(heading + "\n".join(rows) + "\n")
    path = folder / "year.toml"
    path.write_text(text)
    return path
