// What the Year view shows: a result, and how it is looked at.

export interface YearState {
  /** Of the result in the folder; or, of one that was dropped, the key by which the studio holds it. */
  path: string;
  key: string;
  /** The year file to run. */
  run: string;
  metric: string;
  plane: string;
  /** Labels of variants that are not shown. */
  hidden: string[];
  /** A difference: a variant less another; none while empty. */
  of: string;
  minus: string;
  /** Whose light the carpets show: "mean", "least" or "sensor". */
  series: string;
  sensor: number;
  day: string;
  hour: number;
  onlyUse: boolean;
  explains: boolean;
  /** Columns of a table of cases: across, up, and the one that tells series apart. */
  x: string;
  y: string;
  by: string;
}

export const YEAR_START: YearState = {
  path: "",
  key: "",
  run: "",
  metric: "",
  plane: "",
  hidden: [],
  of: "",
  minus: "",
  series: "mean",
  sensor: -1,
  day: "",
  hour: 12.5,
  onlyUse: false,
  explains: false,
  x: "",
  y: "",
  by: "",
};
