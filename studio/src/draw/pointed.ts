// Where a pointer is in a drawing.

/** In the units of the drawing's own view box; nothing before it is on the page. */
export function pointed(drawing: SVGSVGElement | null, event: MouseEvent): DOMPoint | null {
  const matrix = drawing?.getScreenCTM();
  return matrix ? new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse()) : null;
}
