"""Any other panel: a drawn cross-section and its media."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

from clerestory import _native
from clerestory.errors import ClerestoryError
from clerestory.medium import PMMA, Medium
from clerestory.panels.arguments import medium
from clerestory.panels.panel import Panel
from clerestory.profile import Profile


@dataclass(frozen=True, slots=True, kw_only=True)
class ExtrudedPanel(Panel):
    """A panel of any cross-section that repeats upwards.

    Parameters
    ----------
    profile : Profile
        Its cross-section.
    media : sequence of Medium or of names, default PMMA alone
        In the numbering of the profile from 1; 0 is the air. As many as it names, or more.

    Raises
    ------
    ClerestoryError
        If the profile names a medium that is not there.
    """

    kind: ClassVar[str] = "extruded"

    profile: Profile
    media: tuple[Medium, ...] = (PMMA,)

    def _checked(self) -> dict[str, Any]:
        profile: Any = self.profile
        media: Any = self.media
        if isinstance(profile, Mapping):
            profile = Profile.from_dict(profile)
        if not isinstance(profile, Profile):
            raise ClerestoryError(f"profile must be a Profile, got {profile!r}; try Profile.from_outlines")
        if isinstance(media, (Medium, str)):
            media = (media,)
        if not isinstance(media, Sequence):
            raise ClerestoryError(f"media must be a list of media, got {media!r}")
        if len(media) < profile.media_count:
            raise ClerestoryError(
                f"media must hold the {profile.media_count} media that profile names, got {len(media)}; add the rest"
            )
        return {
            "profile": profile,
            "media": tuple(medium(f"media[{place}]", value) for place, value in enumerate(media)),
        }

    def _drawn(self) -> _native.Profile:
        return self.profile.native
