"""What takes long the first time, done before anybody waits for it."""

from __future__ import annotations

import threading

_done = threading.Event()


def warm() -> None:
    """Loads what arrays with names and skies need; once for each process."""
    if _done.is_set():
        return
    _done.set()
    from clerestory.sky.cie_sky import CieSky

    CieSky(sky_type=16, zenith_luminance_cd_m2=1.0).matrix()


def warm_beside() -> None:
    """The same, and where the sun stands, while the caller goes on."""
    if not _done.is_set():
        threading.Thread(target=_all, name="studio-warming", daemon=True).start()


def _all() -> None:
    warm()
    from clerestory.site import Site
    from clerestory.sun import sun_position

    sun_position(Site(latitude_deg=0.0, longitude_deg=0.0), "2026-01-01 12:00")
