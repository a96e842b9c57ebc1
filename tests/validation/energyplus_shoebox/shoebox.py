"""A room of one window in EnergyPlus, run in a process of its own: given sunlight, what comes through the window."""

from __future__ import annotations

import csv
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

WIDTH_M, DEPTH_M, HEIGHT_M = 4.0, 6.0, 3.0
WINDOW_M = (0.5, 3.5, 0.8, 2.6)
"""Left, right, sill and head of the window in the south wall."""
WINDOW_AREA_M2 = (WINDOW_M[1] - WINDOW_M[0]) * (WINDOW_M[3] - WINDOW_M[2])
OUTPUTS = {
    "beam": "Surface Outside Face Incident Beam Solar Radiation Rate per Area",
    "sky": "Surface Outside Face Incident Sky Diffuse Solar Radiation Rate per Area",
    "ground": "Surface Outside Face Incident Ground Diffuse Solar Radiation Rate per Area",
    "cosine": "Surface Outside Face Beam Solar Incident Angle Cosine Value",
    "through": "Surface Window Transmitted Solar Radiation Rate",
    "altitude": "Site Solar Altitude Angle",
    "azimuth": "Site Solar Azimuth Angle",
}


def model(window: dict[str, Any], construction: str) -> dict[str, Any]:
    """The input as epJSON: two days of each of three months, one with the sun alone and one with a sky alone."""
    w, d, h = WIDTH_M, DEPTH_M, HEIGHT_M

    def surface(kind: str, corners: list[tuple[float, float, float]]) -> dict[str, Any]:
        vertices = [
            {"vertex_x_coordinate": x, "vertex_y_coordinate": y, "vertex_z_coordinate": z} for x, y, z in corners
        ]
        boundary = "Ground" if kind == "Floor" else "Outdoors"
        return {
            "surface_type": kind, "construction_name": "wall", "zone_name": "room",
            "outside_boundary_condition": boundary,
            "sun_exposure": "NoSun" if kind == "Floor" else "SunExposed",
            "wind_exposure": "NoWind", "number_of_vertices": 4, "vertices": vertices,
        }  # fmt: skip

    days = {}
    for month in (3, 6, 12):
        # the two days of a month differ in date: the table of results has one row for each time of the year
        for day, sky in ((20, "beam"), (21, "diffuse")):
            days[f"{month} {sky}"] = {
                "month": month, "day_of_month": day, "day_type": "Monday",
                "maximum_dry_bulb_temperature": 20.0, "daily_dry_bulb_temperature_range": 0.0,
                "humidity_condition_type": "WetBulb", "wetbulb_or_dewpoint_at_maximum_dry_bulb": 12.0,
                "barometric_pressure": 101325.0, "wind_speed": 1.0, "wind_direction": 0.0,
                "rain_indicator": "No", "snow_indicator": "No", "daylight_saving_time_indicator": "No",
                "solar_model_indicator": "Schedule",
                "beam_solar_day_schedule_name": "full" if sky == "beam" else "none",
                "diffuse_solar_day_schedule_name": "none" if sky == "beam" else "full",
            }  # fmt: skip
    x0, x1, z0, z1 = WINDOW_M
    window_corners = [(x0, 0.0, z1), (x0, 0.0, z0), (x1, 0.0, z0), (x1, 0.0, z1)]
    fenestration: dict[str, Any] = {
        "surface_type": "Window", "construction_name": construction, "building_surface_name": "south",
        "number_of_vertices": 4,
    }  # fmt: skip
    for number, (x, y, z) in enumerate(window_corners, 1):
        fenestration |= {f"vertex_{number}_x_coordinate": x, f"vertex_{number}_y_coordinate": y}
        fenestration[f"vertex_{number}_z_coordinate"] = z
    hours = {f"hour_{hour}": 500.0 if 9 <= hour <= 16 else 0.0 for hour in range(1, 25)}
    objects: dict[str, Any] = {
        "Version": {"version": {"version_identifier": "25.2"}},
        "SimulationControl": {"control": {
            "run_simulation_for_sizing_periods": "Yes", "run_simulation_for_weather_file_run_periods": "No",
        }},
        "Building": {"building": {"solar_distribution": "FullExterior", "terrain": "Country"}},
        "Timestep": {"step": {"number_of_timesteps_per_hour": 4}},
        "GlobalGeometryRules": {"rules": {
            "starting_vertex_position": "UpperLeftCorner", "vertex_entry_direction": "Counterclockwise",
            "coordinate_system": "Relative",
        }},
        "Site:Location": {"site": {"latitude": 40.0, "longitude": 0.0, "time_zone": 0.0, "elevation": 0.0}},
        "Site:GroundReflectance": {"ground": {
            f"{name}_ground_reflectance": 0.0
            for name in ("january", "february", "march", "april", "may", "june", "july", "august", "september",
                         "october", "november", "december")
        }},
        "SizingPeriod:DesignDay": days,
        "ScheduleTypeLimits": {"any": {}},
        "Schedule:Day:Hourly": {
            "full": {"schedule_type_limits_name": "any", **hours},
            "none": {"schedule_type_limits_name": "any", **dict.fromkeys(hours, 0.0)},
        },
        "Material": {"board": {
            "roughness": "Smooth", "thickness": 0.2, "conductivity": 1.7, "density": 2300.0, "specific_heat": 900.0,
        }},
        "Construction": {"wall": {"outside_layer": "board"}},
        "Zone": {"room": {}},
        "BuildingSurface:Detailed": {
            "south": surface("Wall", [(0, 0, h), (0, 0, 0), (w, 0, 0), (w, 0, h)]),
            "east": surface("Wall", [(w, 0, h), (w, 0, 0), (w, d, 0), (w, d, h)]),
            "north": surface("Wall", [(w, d, h), (w, d, 0), (0, d, 0), (0, d, h)]),
            "west": surface("Wall", [(0, d, h), (0, d, 0), (0, 0, 0), (0, 0, h)]),
            "roof": surface("Roof", [(0, d, h), (0, 0, h), (w, 0, h), (w, d, h)]),
            "floor": surface("Floor", [(0, 0, 0), (0, d, 0), (w, d, 0), (w, 0, 0)]),
        },
        "FenestrationSurface:Detailed": {"window": fenestration},
        "ShadowCalculation": {"shadow": {
            "shading_calculation_update_frequency_method": "Timestep", "shading_calculation_update_frequency": 1,
        }},
        "OutputControl:Files": {"files": {"output_csv": "Yes"}},
        "Output:Variable": {
            f"output {number}": {"key_value": "*", "variable_name": name, "reporting_frequency": "Timestep"}
            for number, name in enumerate(OUTPUTS.values())
        },
    }  # fmt: skip
    return {**objects, **window}


def run(window: dict[str, Any], construction: str, folder: Path) -> dict[str, list[float]]:
    """Runs the room and returns its outputs, each by time step through all days.

    Raises
    ------
    RuntimeError
        If EnergyPlus does not finish; the message holds what it says.
    """
    path = folder / "room.epJSON"
    path.write_text(json.dumps(model(window, construction)))
    answer = subprocess.run(
        [sys.executable, __file__, str(path), str(folder)], capture_output=True, text=True, check=False, timeout=600
    )
    if answer.returncode != 0:
        errors = folder / "eplusout.err"
        told = errors.read_text()[-3000:] if errors.exists() else answer.stdout[-2000:] + answer.stderr[-2000:]
        raise RuntimeError(f"EnergyPlus ended with {answer.returncode}:\n{told}")
    with (folder / "eplusout.csv").open(encoding="utf-8") as lines:
        heading, *rows = csv.reader(lines)
    found: dict[str, list[float]] = {}
    for short, name in OUTPUTS.items():
        surface = "WINDOW:" if name.startswith("Surface") else ""
        columns = [k for k, text in enumerate(heading) if name in text and text.startswith(surface)]
        if columns:
            found[short] = [float(row[columns[0]]) for row in rows]
    return found


def main() -> int:
    """Runs EnergyPlus on an input."""
    from pyenergyplus.api import EnergyPlusAPI

    path, folder = sys.argv[1:]
    api = EnergyPlusAPI()
    state = api.state_manager.new_state()
    return int(api.runtime.run_energyplus(state, ["-D", "-d", folder, path]))


if __name__ == "__main__":
    sys.exit(main())
