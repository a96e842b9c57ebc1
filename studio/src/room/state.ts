// What the room view shows, as it stands in the address.

import type { Tables } from "./answers";

export interface RoomState {
  /** "start", a path in the folder, or nothing: then `tables` are the whole room. */
  file: string;
  /** Tables that stand in place of the file's. */
  tables: Tables;
  variant: string;
  day: number;
  minute: number;
  sky: string;
  turbidity: number;
  plane: string;
  quantity: string;
  isLog: boolean;
  low: number;
  high: number;
  error: number;
  picked: number;
  straight: boolean;
  redirected: boolean;
  reflected: boolean;
  beams: boolean;
  patches: boolean;
  sunPath: boolean;
  field: boolean;
  /** "lines" or "values" in the plan. */
  plan: string;
  /** A name of `EYES`, or nothing: then turn, tilt, far, at (3) and whether it is flat. */
  view: string;
  eye: number[];
}

export const ROOM_START: RoomState = {
  file: "start",
  tables: {},
  variant: "",
  day: 172,
  minute: 660,
  sky: "cie-12",
  turbidity: 4,
  plane: "",
  quantity: "total",
  isLog: true,
  low: 0,
  high: 0,
  error: 0.02,
  picked: -1,
  straight: true,
  redirected: true,
  reflected: true,
  beams: true,
  patches: true,
  sunPath: true,
  field: true,
  plan: "lines",
  view: "overview",
  eye: [],
};
