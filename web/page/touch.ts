/** Fingers on a plot. */

/** A place in the area of a plot, in pixels from its upper left corner. */
export type Place = [number, number];

/** What fingers can do to a plot. */
export interface Touched {
  /** Whether only a part is shown. */
  isPart(): boolean;
  /** Moves the cursor to a place. */
  touch(place: Place): void;
  /** Brings what is at one place to another one; what is shown becomes larger by the factor. */
  bring(from: Place, to: Place, factor: number): void;
  reset(): void;
}

/** Way after which a finger has moved, in pixels, and longest time between two taps, in ms (chosen). */
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
 * One finger moves the cursor, or what is shown if that is a part; two show more or less; two taps show all. A finger
 * that goes up or down first scrolls the page.
 */
export function heedTouch(area: HTMLElement, plot: Touched): void {
  let [begin, last] = [undefined as Fingers | undefined, undefined as Fingers | undefined];
  let isOurs = false;
  let tapped = -Infinity;
  const where = (event: TouchEvent) => fingers(area, event);
  const place = (event: TouchEvent) => {
    begin = last = where(event);
    isOurs = begin?.apart !== undefined;
    if (isOurs) event.preventDefault();
  };
  const move = (event: TouchEvent) => {
    const now = where(event);
    if (!now || !begin || !last) return;
    if (!isOurs) {
      const [right, down] = [Math.abs(now.middle[0] - begin.middle[0]), Math.abs(now.middle[1] - begin.middle[1])];
      if (Math.max(right, down) < MOVED) return;
      if (down > right) {
        begin = undefined;
        return;
      }
      isOurs = true;
    }
    event.preventDefault();
    if (now.apart !== undefined || plot.isPart()) plot.bring(last.middle, now.middle, (now.apart ?? 1) / (last.apart ?? 1));
    else plot.touch(now.middle);
    last = now;
  };
  const lift = (event: TouchEvent) => {
    const wasTap = begin && last && !isOurs && event.touches.length === 0;
    if (wasTap && performance.now() - tapped < TWICE) plot.reset();
    else if (wasTap) plot.touch(last!.middle);
    if (wasTap) tapped = performance.now();
    // One of two fingers may stay.
    begin = last = where(event);
    isOurs = begin !== undefined;
  };
  area.addEventListener("touchstart", place, { passive: false });
  area.addEventListener("touchmove", move, { passive: false });
  area.addEventListener("touchend", lift);
  area.addEventListener("touchcancel", () => (begin = last = undefined));
}
