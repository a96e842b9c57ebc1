// What the server answers: the shapes of its JSON.

export type Point = [number, number];

export interface Slider {
  name: string;
  low: number;
  high: number;
  step: number;
  unit: string;
  start: number | null;
  sets: number;
  group: string;
  repeats: boolean;
}
export interface Kind {
  kind: string;
  sliders: Slider[];
  choices: { name: string; words: string[]; start: string; group: string }[];
  texts: { name: string; source: string; start: string }[];
  medium: string;
}
export interface Kinds {
  kinds: Kind[];
  media: string[];
  presets: { name: string; group: string; panel: { kind: string } & Record<string, never> }[];
}
export interface About {
  version: string;
  folder: string;
  files: { path: string; kind: string }[];
}
export interface Strip {
  corners: Point[];
  power: number;
  total_reflections: number;
  leaves: boolean;
}
export interface Section {
  pitch_mm: number;
  front_mm: number;
  back_mm: number;
  low_mm: number;
  high_mm: number;
  is_smooth: boolean;
  solids: Point[][];
  films: Point[][];
  surfaces: Point[][];
  strips: Strip[];
}
export interface Lobe {
  power: number;
  side: string;
  elevation_deg: number;
  azimuth_deg: number;
  total_reflections: number;
}
export type Shares = Record<string, number>;
export interface Lobes {
  lobes: Lobe[];
  count: number;
  shares: Shares;
  standard_errors: Shares | null;
  rays: number | null;
  is_full: boolean;
  is_smooth: boolean;
}
export interface Walked {
  shares: Shares;
  standard_errors: Shares;
  rays: number;
  distribution: { edges_deg: number[]; front: number[]; back: number[] };
}
export interface KlemsTold {
  key?: string;
  stage?: string;
  left_s?: number;
}
export type Table = Record<string, number[]> & { elevation_deg: number[] };
export interface Dispersion {
  beams: { wavelength_nm: number; elevation_deg: number; azimuth_deg: number; power: number; side: string }[];
}
export interface Finding {
  severity: string;
  where: string;
  text: string;
}
export interface BsdfTold {
  key: string;
  name: string;
  manufacturer: string;
  thickness_mm: number | null;
  bands: Record<string, Record<string, { normal: number; mean: number; most: number; incident_basis?: string; tree_rank?: number; log2_resolution?: number }>>;
  assumed: string[];
  findings: Finding[];
}
export interface Discs {
  incident: { word: string; cells: Point[][]; values: number[] };
  picked: number;
  point: Point;
  outgoing: { word: string; cells: Point[][]; values: number[]; share: number; mean: number; standard_error: number | null }[];
}
export interface ShareCurve {
  elevation_deg: number[];
  curves: { word: string; values: number[] }[];
}
export interface Cut {
  angle_deg: number[];
  from_deg: number;
  curves: { word: string; values: number[] }[];
}
