// What a reader of screens is told of a result: once it has settled, not at each step of a drag.

import { useEffect, useState } from "preact/hooks";

/** Milliseconds without a change after which a text is read out. */
const QUIET_MS = 700;

export function Told({ text }: { text: string }) {
  const [told, setTold] = useState("");
  useEffect(() => {
    const later = setTimeout(() => setTold(text), QUIET_MS);
    return () => clearTimeout(later);
  }, [text]);
  return (
    <p class="unseen" role="status">
      {told}
    </p>
  );
}
