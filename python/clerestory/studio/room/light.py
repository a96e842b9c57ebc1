"""Illuminance of a plane at one time, from the coefficients that are kept and the sun's own light."""

from __future__ import annotations

import time
from typing import Any

import numpy as np

from clerestory.coefficients import PARTS
from clerestory.errors import ClerestoryError
from clerestory.sky.cie_sky import CieSky
from clerestory.studio.room.numbers import whole
from clerestory.studio.room.pool import Array, Pool, relative, scatter
from clerestory.studio.room.shelf import Kept, RoomShelf, Sun
from clerestory.studio.room.sky import Moment, direction_is_up
from clerestory.studio.room.suns import PASSES, ROUNDS, pass_of
from clerestory.studio.room.work import sun_pass

#: Rounds of the sun's light without a wait, those of one pass beyond them, and the most that may be asked for.
_SUN_ROUNDS, _PASS_ROUNDS, _MOST_SUN_ROUNDS = PASSES * ROUNDS, 2, 64
#: A pass that takes longer is the last that is waited for [s].
_SLOW_S = 0.25
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
    rounds = _SUN_ROUNDS if sun_rounds is None else whole("sun_rounds", sun_rounds, 4, _MOST_SUN_ROUNDS)
    pool = kept.pool
    dark = np.zeros(len(kept.sensors))
    sky, sky_error, sky_each = dark, dark, dark[None]
    reflectance = kept.asked.room(kept.variant).ground_reflectance
    if now.sky is not None:
        luminance = now.sky.luminances_cd_m2(kept.basis, ground_reflectance=reflectance)
        sky_each = pool.each(luminance).sum(axis=1)
        sky, sky_error = np.tensordot(pool.shares, sky_each, axes=1), scatter(sky_each, pool.shares)
    sun, sun_error, sun_each, known = np.zeros((len(PARTS), len(dark))), dark, dark[None], Pool()
    notes = list(kept.warned)
    if direction_is_up(now):
        try:
            known = sun_pool(shelf, kept, sun_of(now), rounds)
        except ClerestoryError as unknown:
            # a window of which the sun's beams are not known; the sky's light is
            notes.append(f"the sun's own light is left out: {unknown}")
    if known.batches:
        sun = known.parts()[..., 0] * now.direct_normal_lx
        sun_error = known.judged()[1] * now.direct_normal_lx
        sun_each = np.stack([one.judged for one in known.batches]) * now.direct_normal_lx
    total = sky + sun.sum(axis=0)
    error = np.hypot(sky_error, sun_error)
    worst, average = relative(error, total)
    mean, darkest = float(total.mean()), int(total.argmin())
    ratio = float(total[darkest] / mean) if mean > 0.0 else None

    def error_of(weights: Array) -> float:
        """Standard error of a weighted sum over sensors, whose errors go together."""
        return float(
            np.hypot(
                scatter(sky_each @ weights, pool.shares) if now.sky is not None else 0.0,
                scatter(sun_each @ weights, known.shares) if known.batches else 0.0,
            )
        )

    even = np.full(len(dark), 1.0 / len(dark))
    change = -even * total[darkest] / mean**2 if mean > 0.0 else even
    change[darkest] += 1.0 / mean if mean > 0.0 else 0.0
    return {
        "plane": kept.sensors.name,
        "total_lx": total,
        "standard_error_lx": error,
        "sky_standard_error_lx": sky_error,
        "sun_standard_error_lx": sun_error,
        "parts": {"sky": sky, **{f"sun_{part}": sun[k] for k, part in enumerate(PARTS)}},
        "mean_lx": mean,
        "mean_standard_error_lx": error_of(even),
        "least_lx": float(total.min()),
        "most_lx": float(total.max()),
        "uniformity": ratio,
        "uniformity_standard_error": None if ratio is None else error_of(change),
        "worst_relative_error": worst,
        "mean_relative_error": average,
        "rounds": pool.rounds,
        "sun_rounds": known.rounds,
        "sun": {"altitude_deg": now.altitude_deg, "azimuth_deg": now.azimuth_deg, "is_up": now.altitude_deg > 0.0},
        "outside": {
            "diffuse_horizontal_lx": now.diffuse_horizontal_lx,
            "direct_normal_lx": now.direct_normal_lx,
            "sky": now.about,
        },
        "notes": notes,
        **daylight_factor_of(pool),
    }


def daylight_factor_of(pool: Pool) -> dict[str, Any]:
    """Daylight factor at each sensor under the traditional overcast sky [percent], with its standard error."""
    overcast = CieSky(sky_type=16, zenith_luminance_cd_m2=1.0)
    scale = 100.0 / overcast.diffuse_horizontal_lx
    mean, error = pool.judged()
    return {"daylight_factor_percent": mean * scale, "daylight_factor_standard_error_percent": error * scale}


def sun_of(now: Moment) -> Sun:
    """The sun of a moment as its light is kept by."""
    return round(now.altitude_deg, _SUN_DIGITS), round(now.azimuth_deg, _SUN_DIGITS)


def sun_pool(shelf: RoomShelf, kept: Kept, sun: Sun, rounds: int) -> Pool:
    """What is known of one sun's light; computed now as far as it is less than asked for."""
    known = shelf.sun(kept, sun)
    is_slow = False
    # a window of thousands of beams is not waited for twice
    while known.rounds < rounds and not (is_slow and known.passes):
        paths = shelf.paths(kept) if known.passes < PASSES else None
        began, cpu = time.perf_counter(), time.thread_time()
        if paths is not None:
            batch = pass_of(paths, sun, known.passes)
            # on one thread, so that waiting for others' questions does not count
            is_slow = time.thread_time() - cpu > _SLOW_S
        else:
            batch = sun_pass(kept.asked.room(kept.variant), kept.sensors, sun, known.passes, _PASS_ROUNDS)
            is_slow = time.perf_counter() - began > _SLOW_S
        pooled = (batch, time.thread_time() - cpu)
        known = shelf.add_sun(kept.key, sun, known.passes, pooled) or known.with_batch(*pooled)
    return known
