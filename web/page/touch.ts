/** Fingers on a plot. */

/** A position in the area of a plot, in pixels from its upper left corner. */
export type Place = [number, number];

/** Actions of fingers on a plot. */
export interface Touched {
  /** Whether only a part is shown. */
  isPart(): boolean;
  /** Moves the cursor there. */
  touch(place: Place): void;
  /** Pans from one position to another and zooms by a factor. */
  bring(from: Place, to: Place, factor: number): void;
  reset(): void;
}

/** Distance after which a finger has moved, in pixels, and longest time between two taps, in ms (chosen). */
const MOVED = 8;
const TWICE = 350;

interface Fingers {
  middle: Place;
  /** Distance of two fingers; none for one. */
  apart: number | undefined;
}

/** Where one or two fingers are. */
function fingers(area: HTMLElement, { touches }: TouchEvent): Fingers | undefined {
  const { left, top } = area.getBoundingClientRect();
  const places = [...touches].slice(0, 2).map(({ clientX, clientY }): Place => [clientX - left, clientY - top]);
  const [one, other = one] = places;
  if (!one || !other) return undefined;
  const apart = places.length > 1 ? Math.max(Math.hypot(one[0] - other[0], one[1] - other[1]), 1) : undefined;
  return { middle: [0.5 * (one[0] + other[0]), 0.5 * (one[1] + other[1])], apart };
}

/**
 * One finger moves the cursor, or the plot where only a part is shown; two zoom; a double tap shows all. A finger that
 * goes up or down first scrolls the page.
 */
export function heedTouch(area: HTMLElement, plot: Touched): void {
  const gesture = new Gesture(area, plot);
  area.addEventListener("touchstart", (event) => gesture.start(event), { passive: false });
  area.addEventListener("touchmove", (event) => gesture.move(event), { passive: false });
  area.addEventListener("touchend", (event) => gesture.lift(event));
  area.addEventListener("touchcancel", () => gesture.cancel());
}

class Gesture {
  private begin: Fingers | undefined;
  private last: Fingers | undefined;
  private isOurs = false;
  private tapped = -Infinity;

  constructor(
    private readonly area: HTMLElement,
    private readonly plot: Touched,
  ) {}

  start(event: TouchEvent): void {
    this.begin = this.last = fingers(this.area, event);
    this.isOurs = this.begin?.apart !== undefined;
    if (this.isOurs) event.preventDefault();
  }

  move(event: TouchEvent): void {
    const now = fingers(this.area, event);
    const { begin, last, plot } = this;
    if (!now || !begin || !last) return;
    if (!this.isOurs) {
      const [right, down] = [Math.abs(now.middle[0] - begin.middle[0]), Math.abs(now.middle[1] - begin.middle[1])];
      if (Math.max(right, down) < MOVED) return;
      if (down > right) {
        this.begin = undefined;
        return;
      }
      this.isOurs = true;
    }
    event.preventDefault();
    if (now.apart !== undefined || plot.isPart()) plot.bring(last.middle, now.middle, (now.apart ?? 1) / (last.apart ?? 1));
    else plot.touch(now.middle);
    this.last = now;
  }

  lift(event: TouchEvent): void {
    const { begin, last, plot } = this;
    if (begin && last && !this.isOurs && event.touches.length === 0) {
      if (performance.now() - this.tapped < TWICE) plot.reset();
      else plot.touch(last.middle);
      this.tapped = performance.now();
    }
    // One of two fingers may stay.
    this.begin = this.last = fingers(this.area, event);
    this.isOurs = this.begin !== undefined;
  }

  cancel(): void {
    this.begin = this.last = undefined;
  }
}
