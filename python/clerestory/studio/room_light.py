"""Illuminance of a plane at one time, from the coefficients that are kept and the sun's own light."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from clerestory.coefficients import PARTS
from clerestory.sky.cie_sky import CieSky
from clerestory.studio.room_numbers import whole
from clerestory.studio.room_pool import Pool, relative
from clerestory.studio.room_shelf import Kept, RoomShelf, Sun
from clerestory.studio.room_sky import Moment, direction_is_up
from clerestory.studio.room_work import sun_pass

#: Rounds of the sun's light without a wait, and the most that may be asked for.
_SUN_ROUNDS, _MOST_SUN_ROUNDS = 2, 64
#: Suns closer than this are one [degrees].
_SUN_DIGITS = 4


def light_of(shelf: RoomShelf, kept: Kept, now: Moment, sun_rounds: Any) -> dict[str, Any]:
    """What each sensor of a plane gets of the sky and of the sun, with its standard error.

    Parameters
    ----------
    shelf : RoomShelf
    kept : Kept
    now : Moment
    sun_rounds : int, optional
        Of the sun's light, if less is known of it.
    """
    rounds = _SUN_ROUNDS if sun_rounds is None else whole("sun_rounds", sun_rounds, 2, _MOST_SUN_ROUNDS)
    count = len(kept.sensors)
    pool = kept.pool
    sky, sky_error = np.zeros(count), np.zeros(count)
    reflectance = kept.asked.room(kept.variant).ground_reflectance
    if now.sky is not None:
        luminance = now.sky.matrix(kept.basis, ground_reflectance=reflectance).values
        _, sky, sky_error = pool.total(luminance)
    sun = np.zeros((len(PARTS), count))
    sun_error = np.zeros(count)
    known = Pool()
    if direction_is_up(now):
        known = sun_pool(shelf, kept, sun_of(now), rounds)
        sun = known.parts()[..., 0] * now.direct_normal_lx
        sun_error = known.judged()[1] * now.direct_normal_lx
    total = sky + sun.sum(axis=0)
    error = np.hypot(sky_error, sun_error)
    worst, average = relative(error, total)
    mean = float(total.mean())
    return {
        "plane": kept.sensors.name,
        "total_lx": total,
        "standard_error_lx": error,
        "parts": {
            "sky": sky,
            "sun_direct": sun[0],
            "sun_redirected": sun[1],
            "sun_interreflected": sun[2],
        },
        "mean_lx": mean,
        "least_lx": float(total.min()),
        "most_lx": float(total.max()),
        "uniformity": float(total.min() / mean) if mean > 0.0 else None,
        "worst_relative_error": worst,
        "mean_relative_error": average,
        "rounds": pool.rounds,
        "sun_rounds": known.rounds,
        "sun": {
            "altitude_deg": now.altitude_deg,
            "azimuth_deg": now.azimuth_deg,
            "is_up": now.altitude_deg > 0.0,
        },
        "outside": {
            "diffuse_horizontal_lx": now.diffuse_horizontal_lx,
            "direct_normal_lx": now.direct_normal_lx,
            "sky": now.about,
        },
        **daylight_factor_of(kept, reflectance),
    }


def daylight_factor_of(kept: Kept, ground_reflectance: float) -> dict[str, Any]:
    """Daylight factor at each sensor under the traditional overcast sky [percent], with its standard error."""
    overcast = CieSky(sky_type=16, zenith_luminance_cd_m2=1.0)
    scale = 100.0 / overcast.diffuse_horizontal_lx
    luminance = overcast.matrix(kept.basis, ground_reflectance=ground_reflectance).values
    _, total, _ = kept.pool.total(luminance)
    return {
        "daylight_factor_percent": total * scale,
        "daylight_factor_standard_error_percent": kept.pool.judged()[1] * scale,
    }


def sun_of(now: Moment) -> Sun:
    """The sun of a moment as its light is kept by."""
    return round(now.altitude_deg, _SUN_DIGITS), round(now.azimuth_deg, _SUN_DIGITS)


def sun_pool(shelf: RoomShelf, kept: Kept, sun: Sun, rounds: int) -> Pool:
    """What is known of one sun's light; computed now if that is nothing yet or less than asked for."""
    known = shelf.sun(kept, sun)
    if known.rounds >= rounds:
        return known
    cpu = time.thread_time()
    batch = sun_pass(kept.asked.room(kept.variant), kept.sensors, sun, known.passes, max(2, rounds - known.rounds))
    added = shelf.add_sun(kept.key, sun, known.passes, (batch, time.thread_time() - cpu))
    return known.with_batch(batch, 0.0) if added is None else added
