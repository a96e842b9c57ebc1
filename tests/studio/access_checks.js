// What test_access.py asks of a page: each check answers the elements that break it, as short texts.
(() => {
  const shown = (element) => element.checkVisibility({ opacityProperty: false, visibilityProperty: true }) && element.getClientRects().length > 0;
  const told = (element) => `${element.tagName.toLowerCase()}${element.id ? `#${element.id}` : ""}.${element.getAttribute("class") ?? ""} "${(element.getAttribute("aria-label") ?? element.textContent ?? "").trim().slice(0, 40)}"`;
  const CONTROLS = 'button, a[href], input, select, textarea, summary, [role="slider"], [role="button"], [role="tab"], [tabindex="0"]';
  const controls = () => [...document.querySelectorAll(CONTROLS)].filter((one) => shown(one) && !one.disabled && !one.closest('[aria-hidden="true"]'));
  const rgba = (text) => {
    const [r, g, b, a = 1] = (text.match(/[\d.]+/g) ?? ["0", "0", "0", "0"]).map(Number);
    return text.startsWith("color(") ? [255 * r, 255 * g, 255 * b, a] : [r, g, b, a];
  };
  const luminance = ([r, g, b]) => {
    const [x, y, z] = [r, g, b].map((one) => (one / 255 <= 0.04045 ? one / 255 / 12.92 : ((one / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * x + 0.7152 * y + 0.0722 * z;
  };
  const contrast = (one, two) => {
    const [high, low] = [luminance(one), luminance(two)].sort((a, b) => b - a);
    return (high + 0.05) / (low + 0.05);
  };
  const ground = (element) => {
    for (let place = element; place; place = place.parentElement) {
      const colour = rgba(getComputedStyle(place).backgroundColor);
      if (colour[3] > 0.6) return colour;
    }
    return [255, 255, 255, 1];
  };
  window.access = {
    /** Figures without a text in their place. */
    textless: () =>
      [...document.querySelectorAll("svg, canvas, img")]
        .filter((one) => shown(one) && !one.closest('[aria-hidden="true"]') && !one.parentElement.closest("svg"))
        .filter((one) => !(one.getAttribute("aria-label") || one.getAttribute("alt") || one.getAttribute("aria-labelledby") || one.closest('[role="img"][aria-label]')))
        .map(told),
    /** Controls smaller than 24 px with another one nearer than 24 px (WCAG 2.2, 2.5.8). */
    small: () => {
      const boxes = controls().map((one) => {
        const label = one.matches("input") ? one.closest("label") : null;
        return [one, (label ?? one).getBoundingClientRect()];
      });
      const middle = (box) => [box.x + box.width / 2, box.y + box.height / 2];
      const isSmall = (box) => box.width < 23.5 || box.height < 23.5;
      return boxes
        .filter(([one, box]) => isSmall(box) && box.width > 1 && boxes.some(([other, near]) => {
          if (other === one || other.contains(one) || one.contains(other)) return false;
          const [x, y] = middle(box);
          const [dx, dy] = [Math.max(near.left - x, 0, x - near.right), Math.max(near.top - y, 0, y - near.bottom)];
          return Math.hypot(dx, dy) < 12 || (isSmall(near) && Math.hypot(middle(near)[0] - x, middle(near)[1] - y) < 24);
        }))
        .map(([one, box]) => `${told(one)} ${box.width.toFixed(0)}×${box.height.toFixed(0)}`);
    },
    /** What reaches beyond the screen. */
    wide: () =>
      document.documentElement.scrollWidth <= innerWidth
        ? []
        : [...document.querySelectorAll("body *")].filter((one) => shown(one) && one.getBoundingClientRect().right > innerWidth + 1 && ![...one.children].some((child) => child.getBoundingClientRect().right > innerWidth + 1)).map(told),
    /** Words of drawings that are too faint on the sheet that they are drawn on. */
    faint: () =>
      [...document.querySelectorAll("svg text")]
        .filter((one) => shown(one) && !one.closest('[aria-hidden="true"], .stale'))
        .flatMap((one) => {
          const style = getComputedStyle(one);
          const halo = style.stroke !== "none" && parseFloat(style.strokeWidth) >= 3;
          const ratio = contrast(rgba(style.fill), halo ? rgba(style.stroke) : ground(one.ownerSVGElement.parentElement));
          return ratio < 4.5 ? [`${told(one)} ${ratio.toFixed(2)}`] : [];
        }),
    /** Edges of inputs that are too faint (WCAG 1.4.11). */
    edgeless: () =>
      [...document.querySelectorAll('select, input[type="number"], input[type="text"]')].filter(shown).flatMap((one) => {
        const ratio = contrast(rgba(getComputedStyle(one).borderTopColor), ground(one.parentElement));
        return ratio < 3 ? [`${told(one)} ${ratio.toFixed(2)}`] : [];
      }),
    /** What moves by itself. */
    moving: () => [
      ...document.getAnimations().map((one) => `${one.animationName ?? one.transitionProperty} of ${told(one.effect.target)}`),
      ...[...document.querySelectorAll("body *")].filter((one) => parseFloat(getComputedStyle(one).transitionDuration) > 0.01 || parseFloat(getComputedStyle(one).animationDuration) > 0.01).map(told),
    ],
    /** The controls that Tab is to reach, by number. */
    marked: () => {
      const reached = controls().filter((one) => one.tabIndex >= 0 && !(one.type === "radio" && !one.checked));
      reached.forEach((one, k) => one.setAttribute("data-tab", k));
      return reached.map(told);
    },
    /** Where the keyboard is: the number of the control, and whether one sees it. */
    focused: () => {
      const one = document.activeElement;
      if (!one || one === document.body) return null;
      const seen = [one, one.closest("label"), one.closest(".dropPlace, .button")].some((place) => place && getComputedStyle(place).outlineStyle !== "none" && parseFloat(getComputedStyle(place).outlineWidth) >= 2);
      const box = one.getBoundingClientRect();
      return { number: Number(one.getAttribute("data-tab") ?? -1), told: told(one), seen: seen && box.bottom > 0 && box.top < innerHeight };
    },
  };
})();
