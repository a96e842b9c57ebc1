// The panel view's part of the state.

import type { Panel } from "../state/state";

export interface PanelState {
  a: Panel;
  b: Panel;
  compares: boolean;
  elevation: number;
  azimuth: number;
  side: string;
  radial: string;
  basis: string;
  accuracy: string;
  band: string;
}

export const PANEL_START: PanelState = {
  a: { kind: "laser-cut", spacing_mm: 6, thickness_mm: 6, medium: "pmma" },
  b: { kind: "prismatic", pitch_mm: 4, lower_deg: 45, upper_deg: 80, base_mm: 3, ridges: "front", medium: "pmma" },
  compares: false,
  elevation: 45,
  azimuth: 0,
  side: "front",
  radial: "from",
  basis: "klems_full",
  accuracy: "fine",
  band: "visible",
};
