"""What a table of weather holds: names of columns, what other programs call them, and what is possible."""

from __future__ import annotations

DIRECT = "direct_normal_irradiance_w_m2"
DIFFUSE = "diffuse_horizontal_irradiance_w_m2"
GLOBAL = "global_horizontal_irradiance_w_m2"
DEW_POINT = "dew_point_c"
DRY_BULB = "dry_bulb_c"

#: Least and most that a value can be: the sun outside the atmosphere gives at most 1415 W/m², edges of clouds add.
LIMITS: dict[str, tuple[float, float]] = {
    DIRECT: (0.0, 1500.0),
    DIFFUSE: (0.0, 1500.0),
    GLOBAL: (0.0, 2000.0),
    DEW_POINT: (-90.0, 60.0),
    DRY_BULB: (-90.0, 70.0),
}

#: Below zero by no more than this, a pyranometer at night is off its zero [W/m²].
ZERO_OFFSET_W_M2 = 20.0

#: Names that pvlib and measured records use.
ALIASES: dict[str, str] = {
    "dni": DIRECT,
    "dhi": DIFFUSE,
    "ghi": GLOBAL,
    "temp_dew": DEW_POINT,
    "dew_point": DEW_POINT,
    "temp_air": DRY_BULB,
}

LONG_NAMES: dict[str, str] = {
    DIRECT: "direct normal irradiance",
    DIFFUSE: "diffuse horizontal irradiance",
    GLOBAL: "global horizontal irradiance",
    DEW_POINT: "dew point temperature",
    DRY_BULB: "dry bulb temperature",
}
