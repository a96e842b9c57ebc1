// What the server answers about rooms: the shapes of its JSON.

import type { Slider } from "../server/answers";

export type Vec = [number, number, number];
/** Tables of a room's file. */
export type Tables = { [name: string]: unknown };

export interface RoomSlider extends Slider {
  group: string;
  /** Where the value stands in the tables. */
  path: (string | number)[];
}
export interface RoomKinds {
  sliders: RoomSlider[];
  glazings: { name: string; label: string; table: Tables }[];
  skies: { name: string; label: string; sky: Tables }[];
  surfaces: string[];
  start: Tables;
}
export interface RoomSurface {
  name: string;
  kind: string;
  diffuse: number | null;
  specular: number | null;
  /** Nine numbers each. */
  triangles: number[][];
  outlines: Vec[][];
}
export interface RoomWindow {
  name: string;
  outline_m: Vec[];
  /** Into the room. */
  normal: Vec;
  glazing: string;
  kind: string;
}
export interface Plane {
  name: string;
  points_m: Vec[];
  normals: Vec[];
  cells: Vec[][] | null;
  /** Place of each sensor in the grid. */
  row: number[] | null;
  column: number[] | null;
  rows: number | null;
  columns: number | null;
  spacing_m: number | null;
}
export interface SiteTold {
  latitude_deg: number;
  longitude_deg: number;
  elevation_m?: number;
  timezone?: string;
}
export interface RoomScene {
  name: string;
  variants: string[];
  bounds_m: [Vec, Vec];
  inside_m: [Vec, Vec];
  surfaces: RoomSurface[];
  windows: RoomWindow[];
  planes: Plane[];
  plane_names: string[];
  site: SiteTold | null;
  tables: Tables;
}
export interface SunPlace {
  altitude_deg: number;
  azimuth_deg: number;
  /** Towards the sun. */
  direction: Vec;
}
export interface SunHour extends SunPlace {
  hour: number;
}
export interface SunTold extends SunPlace {
  time: string;
  is_up: boolean;
  sunrise_h: number | null;
  sunset_h: number | null;
  day: SunHour[];
}
/** The sun's ways through the year at a site. */
export interface SunYear {
  seasons: { label: string; points: SunHour[] }[];
  analemmas: { hour: number; points: SunPlace[] }[];
}
export type PathKind = "direct" | "redirected" | "reflected";
export interface LightPath {
  window: string;
  power: number;
  kind: PathKind;
  points: Vec[];
  stages: string[];
  segment_power: number[];
}
export interface LightBeam {
  window: string;
  power: number;
  direction: Vec;
  total_reflections: number;
}
export interface Patch {
  surface: string;
  polygon: Vec[];
  /** The same corners where the beam leaves its window. */
  source: Vec[];
  beam: number;
  illuminance_per_normal: number;
}
export interface LightPaths {
  paths: LightPath[];
  beams: LightBeam[];
  patches: Patch[];
  warnings?: string[];
}
export interface RoomWork {
  key: string;
  rounds: number;
  worst_relative_error: number;
  mean_relative_error: number;
  cpu_seconds: number;
  converged: boolean;
}
export interface RoomLight {
  plane: string;
  total_lx: number[];
  standard_error_lx: number[];
  parts: { sky: number[]; sun_direct: number[]; sun_redirected: number[]; sun_interreflected: number[] };
  mean_lx: number;
  least_lx: number;
  most_lx: number;
  uniformity: number | null;
  mean_standard_error_lx?: number | null;
  uniformity_standard_error?: number | null;
  sky_standard_error_lx?: number[];
  sun_standard_error_lx?: number[];
  worst_relative_error: number;
  outside: { diffuse_horizontal_lx: number; direct_normal_lx: number; sky: string };
  sun_rounds: number;
  /** What was left out, in words. */
  notes?: string[];
  daylight_factor_percent: number[] | null;
  daylight_factor_standard_error_percent?: number[];
}
