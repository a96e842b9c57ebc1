"""The BSDF of a panel as a job: by rays at once, then as closely as asked, with the time that is left."""

from __future__ import annotations

import contextlib
import threading
import time
from typing import Any

import numpy as np

from clerestory.bsdf import Bsdf
from clerestory.bsdf.klems import klems_basis
from clerestory.bsdf.of_glazing import ACCURACY, MOST_PIECES, TOLERANCE, Averaging
from clerestory.bsdf.wavebands import band_samples
from clerestory.panels import Panel, panel_from_dict
from clerestory.panels.incidence import incident_directions
from clerestory.panels.optics import ARC_CHORDS
from clerestory.studio.bsdf.klems_key import klems_key
from clerestory.studio.panel.work import Tell

#: Random draws for each incident patch of the discs that are shown at once.
_AT_ONCE, _BETTER = 500, 10_000
#: Share of the light within a panel that beams may leave unfollowed: above what counts as exact: then rays are drawn.
_BY_RAYS = 3e-2
#: Pieces of light that such a panel is followed by at most.
_FEW_PIECES = 1000
#: Directions of a patch that are followed at the least, with those beside them; and how many more quarters take.
_PLACES, _QUARTERED = 27, 4.0
#: Seconds between two words about the time.
_TICK = 0.5


def klems(*, panel: dict[str, Any], basis: str, accuracy: str, tell: Tell) -> Bsdf:
    """The panel's BSDF over Klems patches.

    ``accuracy`` "rays": random draws, with standard errors; "fine": as :meth:`Panel.bsdf` makes it. What there is on
    the way is told too.
    """
    asked = panel_from_dict(panel)
    is_smooth = asked.native_profile.is_smooth
    clock = _Clock(tell)
    # a rough panel is drawn by rays anyway
    with clock.stage("rays", 0.1):
        found = _by_rays(asked, basis, _AT_ONCE, ("visible",)) if is_smooth else asked.bsdf(basis, draws=_AT_ONCE)
    clock.show(found)
    by_rays_s = clock.last_s * _BETTER / _AT_ONCE
    if not is_smooth:
        draws = _BETTER if accuracy == "rays" else 4 * _BETTER
        with clock.stage("rays", clock.last_s * draws / _AT_ONCE):
            return asked.bsdf(basis, draws=draws)
    fine_s = _seconds(asked, basis)
    if accuracy == "rays" and fine_s > 2.0 * by_rays_s:
        with clock.stage("rays", 2.0 * by_rays_s):
            return _by_rays(asked, basis, _BETTER, ("visible", "solar"))
    if fine_s > 4.0 * by_rays_s:
        with clock.stage("rays", by_rays_s, fine_s):
            found = _by_rays(asked, basis, _BETTER, ("visible",))
        clock.show(found)
    with clock.stage("fine", fine_s):
        return asked.bsdf(basis)


def _by_rays(panel: Panel, basis: str, draws: int, bands: tuple[str, ...]) -> Bsdf:
    """By random draws even of a panel whose beams could be followed."""
    averaging = Averaging(basis, None, 5, ACCURACY, draws, 0)
    found: dict[str, Any] = {}
    attrs: dict[str, Any] = {}
    for band in bands:
        _, share = band_samples(panel.media, band, 1)
        found[band], accounts = averaging.band(_optics(panel, band, _BY_RAYS, _FEW_PIECES).glazing())
        attrs |= {f"{band}_{name}": value for name, value in accounts.items()} | {f"{band}_share_known": share}
    low, high = panel.native_profile.depth_range_mm
    return Bsdf(name=type(panel).__name__, thickness_mm=high - low, exact=panel, attrs=attrs, **found)


def _optics(panel: Panel, band: str, tolerance: float, most_pieces: int) -> Any:
    from clerestory import _native

    profile = panel.native_profile
    if tolerance < _BY_RAYS and not profile.is_straight:
        profile = profile.flattened(ARC_CHORDS)
    at, _ = band_samples(panel.media, band, 1)
    return _native.PanelOptics(
        profile,
        n=at.n,
        absorption_per_mm=at.absorption_per_mm,
        weights=np.array(at.weights),
        polarisation="resolved",
        tolerance=tolerance,
        most_pieces=most_pieces,
    )


def _seconds(panel: Panel, basis: str) -> float:
    """About how long the fine BSDF takes, by the time that a few directions take."""
    glazing = _optics(panel, "visible", TOLERANCE, MOST_PIECES).glazing()
    rng = np.random.default_rng(0)
    places = rng.uniform(-75.0, 75.0, (16, 2))
    start = time.perf_counter()
    done = 0
    for elevation, azimuth in places:
        glazing.lobes(incident_directions(np.array([elevation]), np.array([azimuth]), "front"))
        done += 1
        if time.perf_counter() - start > 0.5:
            break
    each = (time.perf_counter() - start) / done
    # half of all patches are images of the others; the solar band has more wavelengths
    bands = [len(band_samples(panel.media, band, 1)[0].weights) for band in ("visible", "solar")]
    return each * len(klems_basis(basis)) * _PLACES * (1.0 + _QUARTERED) * sum(bands) / _workers()


def _workers() -> int:
    import os

    return max(1, min(os.cpu_count() or 1, 64))


class _Clock:
    """Tells what is done of a job whose parts cannot say so themselves, by the time that was expected of them."""

    def __init__(self, tell: Tell) -> None:
        self._tell = tell
        self._start = time.monotonic()
        self._shown: dict[str, Any] = {}
        self.last_s = 0.0

    def stage(self, word: str, expected_s: float, then_s: float = 0.0) -> _Stage:
        """A part of the job, of so many seconds; others follow of ``then_s``."""
        return _Stage(self, word, expected_s, then_s)

    def show(self, bsdf: Bsdf) -> None:
        """What there is so far."""
        self._shown = {"key": klems_key(bsdf)}
        self._tell(0, 0, {**self._shown, "bsdf": bsdf})

    def told(self, word: str, passed_s: float, expected_s: float, then_s: float) -> None:
        # what takes longer than expected has some of its time left all the while
        left = (expected_s - passed_s if passed_s < 0.9 * expected_s else 0.1 * expected_s + 0.1 * passed_s) + then_s
        gone = time.monotonic() - self._start
        self._tell(gone, gone + left, {**self._shown, "stage": word, "left_s": left})


class _Stage:
    """While it lasts, a thread tells how far it is."""

    def __init__(self, clock: _Clock, word: str, expected_s: float, then_s: float) -> None:
        self._clock, self._word, self._expected, self._then = clock, word, expected_s, then_s
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)

    def __enter__(self) -> None:
        self._begin = time.monotonic()
        self._thread.start()

    def __exit__(self, *_: object) -> None:
        self._ended.set()
        self._thread.join()
        self._clock.last_s = time.monotonic() - self._begin

    def _run(self) -> None:
        # a job that nobody wants is ended from elsewhere: this thread only tells
        with contextlib.suppress(Exception):
            self._tell_on()

    def _tell_on(self) -> None:
        while True:
            self._clock.told(self._word, time.monotonic() - self._begin, self._expected, self._then)
            if self._ended.wait(_TICK):
                return
