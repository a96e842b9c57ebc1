// What the server answers about results: the shapes of its JSON.

import type { Point } from "../server/answers";

export type Numbers = (number | null)[];

export interface Listed {
  path: string;
  kind: string;
  what: string;
  title: string;
  detail: string;
  date: string;
}
export interface Results {
  results: Listed[];
  years: Listed[];
}
export interface FigureRow {
  name: string;
  label: string;
  unit: string;
  about: string;
  sense: number;
  is_share: boolean;
  cells: { value: number | null; error: number | null; text: string }[];
  best: number[];
}
export interface ResultTold {
  key: string;
  kind: "year" | "room" | "sweep" | "design" | "panel";
  what: string;
  name: string;
  path: string;
  title: string;
  variants: string[];
  glazings: string[][];
  metrics: { key: string; label: string; unit: string; about: string }[];
  planes: { name: string; count: number; is_grid: boolean }[];
  figures: FigureRow[];
  has_hours: boolean;
  rows: number;
  measures: Record<string, unknown>;
  provenance: { label: string; text: string }[];
  source: string | null;
}
export interface PlanVariant {
  label: string;
  values: Numbers;
  errors: Numbers | null;
  mean: number | null;
  least: number | null;
  most: number | null;
}
export interface Plan {
  label: string;
  unit: string;
  about: string;
  level: number | null;
  plane: string;
  low: number;
  high: number;
  is_logarithmic: boolean;
  x: number[];
  y: number[];
  outline: Point[];
  windows: { name: string; points: Point[] }[];
  sensors: Numbers;
  variants: PlanVariant[];
}
export interface HourPlan extends Plan {
  time: string;
  sun: { altitude_deg: number; azimuth_deg: number } | null;
  blinds_closed: Record<string, string[]>;
  in_use: boolean;
}
export interface SectionCurves {
  label: string;
  unit: string;
  level: number | null;
  is_logarithmic: boolean;
  distance_m: number[];
  variants: { label: string; mean: Numbers; least: Numbers; most: Numbers; error: Numbers | null }[];
}
export interface Carpet {
  series: string;
  unit: string;
  low: number;
  high: number;
  ticks: number[];
  days: string[];
  step_h: number;
  rows: number;
  in_use: Numbers;
  variants: { label: string; values: Numbers; blinds: Numbers | null }[];
  sunrise: Numbers | null;
  sunset: Numbers | null;
}
export interface Months {
  months: string[];
  unit: string;
  variants: { label: string; daylit: Numbers; in_use: Numbers }[];
}
export interface Column {
  name: string;
  label: string;
  unit: string;
  role: "parameter" | "figure" | "note";
  is_number: boolean;
  values: (number | string | null)[];
  errors?: Numbers;
}
export interface Cases {
  columns: Column[];
  rows: number;
  rows_in_all: number;
  start: { x: string; y: string[]; by: string };
  front?: number[];
  best?: number | null;
  objectives?: { figure: string; aim: string }[];
  unbeaten?: string[];
}
export interface YearRun {
  variant: string;
  what: string;
  seconds_left: number | null;
  path: string | null;
}
