// The BSDF view's part of the state.

export interface BsdfState {
  path: string;
  key: string;
  otherPath: string;
  otherKey: string;
  compares: boolean;
  elevation: number;
  azimuth: number;
  side: string;
  band: string;
  plane: number;
  scale: string;
}

export const BSDF_START: BsdfState = {
  path: "",
  key: "",
  otherPath: "",
  otherKey: "",
  compares: false,
  elevation: 40,
  azimuth: 0,
  side: "front",
  band: "visible",
  plane: 0,
  scale: "log",
};
