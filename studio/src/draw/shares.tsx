// An energy bar that always fills: shares of the light, rounded so that they add to 100 %.

import type { Shares } from "../server/answers";
import { HUES } from "./colours";

const PARTS = ["transmittance_deflected", "transmittance_undeflected", "reflectance", "absorptance", "residual"];

/** Tenths of a percent that add to 1000: the largest remainders are rounded up. */
export function tenths(shares: number[]): number[] {
  const whole = shares.reduce((sum, one) => sum + one, 0) || 1;
  const exact = shares.map((one) => (1000 * one) / whole);
  const made = exact.map(Math.floor);
  const order = exact.map((value, k) => [value - made[k], k]).sort((one, other) => other[0] - one[0]);
  const left = 1000 - made.reduce((sum, one) => sum + one, 0);
  for (let n = 0; n < left; n++) made[order[n][1]] += 1;
  return made;
}

interface Props {
  shares: Shares | null;
  errors: Shares | null;
  words: Record<string, string>;
  label: string;
  isStale: boolean;
}

export function DrawShares({ shares, errors, words, label, isStale }: Props) {
  if (!shares) return <div class="energy" role="img" aria-label={label} />;
  const parts = PARTS.filter((name) => name !== "residual" || shares.residual >= 5e-4);
  const shown = tenths(parts.map((name) => shares[name]));
  const start = (k: number) => shown.slice(0, k).reduce((sum, one) => sum + one, 0);
  return (
    <figure class={isStale ? "stale" : ""}>
      <svg class="energy" viewBox="0 0 1000 64" preserveAspectRatio="none" role="img" aria-label={`${label}: ${parts.map((name, k) => `${words[name]} ${(shown[k] / 10).toFixed(1)} %`).join(", ")}`}>
        {parts.map((name, k) => (
          <rect key={name} x={start(k)} y={0} width={shown[k]} height={64} fill={HUES[name]} />
        ))}
      </svg>
      <dl class="shares">
        {parts.map((name, k) => (
          <div key={name}>
            <dt>
              <i style={{ background: HUES[name] }} />
              {words[name]}
            </dt>
            <dd data-share={name} data-value={shares[name]}>
              {(shown[k] / 10).toFixed(1)} %{errors && <small> ± {(100 * errors[name]).toFixed(2)}</small>}
            </dd>
          </div>
        ))}
      </dl>
    </figure>
  );
}
