// What the server answers: the shapes of its JSON.

export type Point = [number, number];

export interface Slider {
  name: string;
  low: number;
  high: number;
  step: number;
  unit: string;
  start: number;
}
export interface Kind {
  kind: string;
  sliders: Slider[];
  choices: { name: string; words: string[]; start: string }[];
  medium: string;
}
export interface Kinds {
  kinds: Kind[];
  media: string[];
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
  shares: Shares;
}
export type Table = Record<string, number[]> & { elevation_deg: number[] };
export interface Dispersion {
  beams: { wavelength_nm: number; elevation_deg: number; power: number; side: string }[];
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
  outgoing: { word: string; cells: Point[][]; values: number[]; share: number }[];
}
export interface Cut {
  angle_deg: number[];
  from_deg: number;
  curves: { word: string; values: number[] }[];
}
