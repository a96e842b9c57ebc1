// A part of the page that takes what is dropped.

import { useState } from "preact/hooks";

/** Whether something is held over the part, and what the part listens to. */
export function useDrop(take: (held: DataTransfer | null) => void) {
  const [isOver, setIsOver] = useState(false);
  const hands = {
    onDragOver: (event: DragEvent) => {
      event.preventDefault();
      setIsOver(true);
    },
    onDragLeave: () => setIsOver(false),
    onDrop: (event: DragEvent) => {
      event.preventDefault();
      setIsOver(false);
      take(event.dataTransfer);
    },
  };
  return { isOver, hands };
}
