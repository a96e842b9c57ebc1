// Time of day and day of year, with the sun's rise and set, and a button that lets the day pass.

import { useEffect, useRef, useState } from "preact/hooks";
import { change } from "../state/state";
import { room as said } from "../words/room";
import type { SunTold } from "./answers";

/** Days of the year on which months begin. */
const FIRSTS = [1, 32, 60, 91, 121, 152, 182, 213, 244, 274, 305, 335];
const STEP_MINUTES = 5;
/** Minutes of the day that pass in a step, and milliseconds that a step takes. */
const PLAYED = [10, 110];

export function RoomTime({ day, minute, sun }: { day: number; minute: number; sun: SunTold | null }) {
  const [isPlaying, setIsPlaying] = useState(false);
  const now = useRef(minute);
  now.current = minute;
  const rise = sun?.sunrise_h ?? null;
  const set = sun?.sunset_h ?? null;
  const prefersStill = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const go = (step: number) => {
    const [from, to] = [60 * (rise ?? 0), 60 * (set ?? 24)];
    const next = now.current + step;
    change("room", { minute: next > to || next < from ? Math.ceil(from / STEP_MINUTES) * STEP_MINUTES : next });
  };
  useEffect(() => {
    if (!isPlaying) return;
    const timer = setInterval(() => go(PLAYED[0]), PLAYED[1]);
    return () => clearInterval(timer);
  }, [isPlaying, rise, set]);
  const place = (share: number) => ({ left: `calc(${(100 * share).toFixed(2)}% + ${(8 - 16 * share).toFixed(1)}px)` });
  const night = rise !== null && set !== null ? `linear-gradient(to right, var(--night) ${(100 * rise) / 24}%, var(--daylight) ${(100 * rise) / 24}% ${(100 * set) / 24}%, var(--night) ${(100 * set) / 24}%)` : undefined;
  return (
    <div class="time" role="group" aria-label={said.time}>
      {prefersStill ? (
        <button class="play" aria-label={said.nextHour} title={said.nextHour} onClick={() => go(30)}>
          ▸|
        </button>
      ) : (
        <button class="play" aria-pressed={isPlaying} aria-label={isPlaying ? said.pause : said.play} title={isPlaying ? said.pause : said.play} onClick={() => setIsPlaying(!isPlaying)}>
          {isPlaying ? "❚❚" : "▶"}
        </button>
      )}
      <label class="ruled">
        <span>
          {said.hour} <b>{said.clock(minute)}</b>
        </span>
        <input id="room-minute" type="range" min={0} max={1435} step={STEP_MINUTES} value={minute} aria-valuetext={said.clock(minute)} onInput={(event) => change("room", { minute: event.currentTarget.valueAsNumber })} />
        <span class="rule" aria-hidden="true">
          <span class="band" style={night && { background: night }} />
          {[0, 3, 6, 9, 12, 15, 18, 21, 24].map((hour) => (
            <span key={hour} class="tick" style={place(hour / 24)}>
              {hour}
            </span>
          ))}
          {rise !== null && <span class="mark" style={place(rise / 24)} title={said.sunrise} />}
          {set !== null && <span class="mark" style={place(set / 24)} title={said.sunset} />}
        </span>
      </label>
      <label class="ruled">
        <span>
          {said.day} <b>{said.date(day)}</b>
        </span>
        <input id="room-day" type="range" min={1} max={365} step={1} value={day} aria-valuetext={said.date(day)} onInput={(event) => change("room", { day: event.currentTarget.valueAsNumber })} />
        <span class="rule" aria-hidden="true">
          <span class="band" />
          {FIRSTS.map((first, k) => (
            <span key={first} class="tick month" style={place((first + 14) / 365)}>
              {said.monthLetters[k]}
            </span>
          ))}
        </span>
      </label>
      <p class="suntold hint">
        {sun ? (sun.is_up ? said.sunUp(sun.altitude_deg, sun.azimuth_deg) : said.sunDown) : ""}
        {rise !== null && set !== null && (
          <span>
            {" "}
            · ↑ {said.clock(Math.round(60 * rise))} ↓ {said.clock(Math.round(60 * set))}
          </span>
        )}
      </p>
    </div>
  );
}
