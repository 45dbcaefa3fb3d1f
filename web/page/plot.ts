/** Plots on the page: a frame with a caption, exports, a data table, keyboard and a cursor that all plots share. */

import uPlot from "uplot";
import { h, save, say, swatch } from "./dom";
import { type Curve, decimalsOf, type Diagram, draw, Frame, labelText, legend, NOISE, pointed, range, type Range, rangeUp, stroke, tickText } from "./drawing";
import { short, unitText } from "./format";
import { CanvasPen, SvgPen } from "./pen";
import { colours, dashes } from "./theme";
import { heedTouch, type Place, type Touched } from "./touch";

/** Listeners to the cursor: the number of the output time it is at, or none. */
type CursorListener = (at: number | null, from: unknown) => void;

const FONT = "12px system-ui, 'Noto Sans', Arial, sans-serif";

function axis(label: string, size: number): uPlot.Axis {
  const { ink, grid } = colours();
  return {
    stroke: ink,
    font: FONT,
    labelFont: FONT,
    label,
    size,
    labelSize: 20,
    grid: { stroke: grid, width: 1 },
    ticks: { stroke: grid, width: 1 },
    values: (_, values) => {
      const step = values.length > 1 ? Math.abs(values[1]! - values[0]!) : 1;
      const decimals = decimalsOf(step);
      return values.map((value) => tickText(value, decimals));
    },
  };
}

/** The cursor that plots share. */
export class Cursor {
  private readonly listeners: CursorListener[] = [];
  at: number | null = null;

  on(listener: CursorListener): void {
    this.listeners.push(listener);
  }

  move(at: number | null, from: unknown): void {
    if (at === this.at) return;
    this.at = at;
    this.listeners.forEach((listener) => listener(at, from));
  }
}

const EXPORT: [number, number] = [800, 480];
const ROWS = 40;

/** Base of all plots. */
export abstract class Plot implements Touched {
  readonly root: HTMLElement;
  protected readonly area: HTMLDivElement;
  private readonly caption = h("span", { class: "title" });
  private readonly keys = h("ul", { class: "legend keys", hidden: true });
  private readonly summary = h("p", { class: "unseen" });
  private readonly table = h("details", { class: "data", ontoggle: () => this.fillTable() }, h("summary", {}, "Table"));
  private isVisible = true;
  private isStale = false;
  protected diagram: Diagram = { title: "", x: { name: "", unit: "1" }, y: { name: "", unit: "1" }, curves: [] };

  constructor(
    readonly kind: string,
    protected readonly cursor: Cursor,
  ) {
    const id = `summary-${kind}`;
    this.summary.id = id;
    this.area = h("div", {
      class: "area",
      tabindex: 0,
      role: "application",
      "aria-roledescription": "plot",
      "aria-describedby": id,
      onkeydown: (event: KeyboardEvent) => this.key(event),
    });
    const file = (text: string, does: () => void) =>
      h("button", { type: "button", class: "small", "aria-label": `${kind} as ${text}`, onclick: does }, text);
    const buttons = h(
      "span",
      { class: "tools" },
      file("SVG", () => save(`${kind}.svg`, this.svg(), "image/svg+xml")),
      file("PNG", () => this.savePng()),
      file("Reset", () => this.reset()),
    );
    this.root = h(
      "figure",
      { class: "plot", "data-kind": kind },
      h("figcaption", {}, this.caption, buttons),
      this.keys,
      this.area,
      this.summary,
      this.table,
    );
    heedTouch(this.area, this);
    cursor.on(() => this.showValues());
    new ResizeObserver(() => this.resize()).observe(this.area);
    new IntersectionObserver(([entry]) => this.seen(entry!.isIntersecting), { rootMargin: "100px" }).observe(this.area);
    // A print also has plots that are scrolled out of view.
    addEventListener("beforeprint", () => this.seen(true));
  }

  /** Draws when the plot comes into view. */
  private seen(isVisible: boolean): void {
    this.isVisible = isVisible;
    if (!isVisible || !this.isStale) return;
    this.isStale = false;
    this.update();
  }

  /** Shows other curves. */
  show(diagram: Diagram): void {
    this.diagram = diagram;
    this.caption.textContent = diagram.title;
    this.area.setAttribute("aria-label", diagram.title);
    this.summary.textContent = `${diagram.title}. ${diagram.curves.map((curve) => this.extremes(curve)).join("; ")}`;
    this.showKeys();
    this.fillTable();
    this.isStale = !this.isVisible;
    if (this.isVisible) this.update();
  }

  /** The curves with their lines, where the view has no legend for them. */
  private showKeys(): void {
    const { curves, hasLegend, told } = this.diagram;
    this.keys.hidden = !hasLegend;
    if (!hasLegend) return;
    const keys = [...(told ?? []), ...curves].map((curve) => {
      const { name, law, style } = curve;
      return h("li", {}, swatch(law, stroke(curve, dashes()).dash, style), h("span", {}, name), told ? h("span", { class: "value" }) : "");
    });
    this.keys.replaceChildren(...keys, told ? h("li", {}, h("span", { class: "value" })) : "");
    this.showValues();
  }

  /** The values of residuals, and of what they are the difference of, at the cursor. */
  private showValues(): void {
    const { curves, told, x, y } = this.diagram;
    if (!told) return;
    const { at } = this.cursor;
    const text = (value: number | undefined, unit: string) => (value === undefined || Number.isNaN(value) ? "" : `${short(value)} ${unitText(unit)}`);
    const values = [...told, ...curves].map((curve) => text(at === null ? undefined : curve.y[at], y.unit));
    const place = text(at === null ? undefined : curves[0]?.x[at], x.unit);
    const shown = [...values, place && `at ${place}`];
    this.keys.querySelectorAll(".value").forEach((value, number) => (value.textContent = shown[number] ?? ""));
  }

  private extremes({ name, y }: Curve): string {
    const [low, high] = range([y], 0);
    return `${name} from ${short(low)} to ${short(high)} ${unitText(this.diagram.y.unit)}`;
  }

  protected abstract update(): void;
  protected abstract resize(): void;
  abstract reset(): void;
  abstract isPart(): boolean;
  abstract touch(place: Place): void;
  /** Shows a part as large as this, around the cursor, or more than now. */
  protected abstract magnify(factor: number): void;
  /** Ranges that are shown. */
  protected abstract ranges(): { x: Range; y: Range };
  /** Ends of the axes in the area, in pixels. */
  protected abstract ends(): { x: Range; y: Range };
  /** Shows these ranges, clipped to the whole. */
  protected abstract look(x: Range, y: Range): void;
  abstract theme(): void;
  /** Moves the cursor here. */
  protected abstract point(at: number): void;

  bring(from: Place, to: Place, factor: number): void {
    const [shown, ends] = [this.ranges(), this.ends()];
    const along = ([low, high]: Range, [begin, end]: Range, one: number, other: number): Range => {
      const size = (high - low) / factor;
      const value = low + ((one - begin) / (end - begin)) * (high - low);
      const first = value - ((other - begin) / (end - begin)) * size;
      return [first, first + size];
    };
    this.look(along(shown.x, ends.x, from[0], to[0]), along(shown.y, ends.y, from[1], to[1]));
  }

  /** The picture as it is shown, with a legend. */
  svg(): string {
    const [width, height] = EXPORT;
    const pen = new SvgPen(width, height, this.diagram.title);
    this.drawWithLegend(pen, width, height);
    return pen.document();
  }

  private drawWithLegend(pen: CanvasPen | SvgPen, width: number, height: number): void {
    // The height of the legend is known once it is drawn; the paper must lie below it.
    const head = legend(new SvgPen(width, height, ""), this.diagram, colours(), dashes(), width);
    const { x, y } = this.ranges();
    draw(pen, new Frame(width, height, x, y, head), this.diagram, colours(), dashes());
    legend(pen, this.diagram, colours(), dashes(), width);
  }

  private savePng(): void {
    const [width, height] = EXPORT;
    const canvas = h("canvas", { width: 2 * width, height: 2 * height });
    const context = canvas.getContext("2d");
    if (!context) return;
    this.drawWithLegend(new CanvasPen(context, width, height, 2), width, height);
    canvas.toBlob((blob) => blob && save(`${this.kind}.png`, blob));
  }

  private fillTable(): void {
    this.table.querySelector(".scroll")?.remove();
    if (!this.table.open) return;
    const { x, y, curves } = this.diagram;
    const head = curves.flatMap(({ name }) => [`${labelText(x)}`, `${name}: ${labelText(y)}`]);
    const longest = Math.max(0, ...curves.map((curve) => curve.x.length));
    const every = Math.max(1, Math.ceil((longest - 1) / ROWS));
    const rows = Array.from({ length: Math.ceil(longest / every) }, (_, row) => row * every);
    const cell = (value: number | undefined) => h("td", {}, value === undefined ? "" : short(value));
    const body = rows.map((at) => h("tr", {}, ...curves.flatMap((curve) => [cell(curve.x[at]), cell(curve.y[at])])));
    const table = h(
      "table",
      {},
      h("caption", {}, `${this.diagram.title}, ${every === 1 ? "every value" : `one value of ${every}`}`),
      h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
      h("tbody", {}, ...body),
    );
    const label = `Table: ${this.diagram.title}`;
    this.table.append(h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": label }, table));
  }

  private key(event: KeyboardEvent): void {
    const curves = pointed(this.diagram);
    const count = Math.max(0, ...curves.map((curve) => curve.x.length));
    if (count === 0) return;
    const far = event.shiftKey ? 1 : Math.max(1, Math.round(count / 100));
    const now = this.cursor.at ?? 0;
    const places: Record<string, number> = { ArrowLeft: now - far, ArrowRight: now + far, Home: 0, End: count - 1 };
    const to = places[event.key];
    if (to === undefined) {
      if (event.key === "Escape") this.reset();
      else if (event.key === "+") this.magnify(0.5);
      else if (event.key === "-") this.magnify(2);
      return;
    }
    event.preventDefault();
    const at = Math.min(count - 1, Math.max(0, to));
    this.cursor.move(at, this);
    this.point(at);
    const { x, y } = this.diagram;
    const told = [...(this.diagram.told ?? []), ...curves].map((curve) => `${curve.name}: ${short(curve.y[at] ?? NaN)} ${unitText(y.unit)}`);
    say(`${x.name} ${short(curves[0]?.x[at] ?? NaN)} ${unitText(x.unit)}. ${told.join(", ")}`);
  }
}

/** Number of times before a time, or up to it. */
function below(times: ArrayLike<number>, time: number, includes = false): number {
  let [low, high] = [0, times.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! < time || (includes && times[middle] === time)) low = middle + 1;
    else high = middle;
  }
  return low;
}

function part(values: ArrayLike<number>, from: number, to: number): ArrayLike<number> {
  return values instanceof Float64Array ? values.subarray(from, to) : Array.prototype.slice.call(values, from, to);
}

/** Whether some values are not numbers. */
function hasGap(values: ArrayLike<number>): boolean {
  for (let at = 0; at < values.length; at++) if (Number.isNaN(values[at])) return true;
  return false;
}

/** The smallest part of a range that can be shown (chosen). */
const SMALLEST = 1e-6;

/** A part of a range around a value, inside of the whole. */
function within([low, high]: Range, whole: Range, around?: number, factor = 1): Range {
  const all = whole[1] - whole[0];
  const size = Math.min(Math.max(factor * (high - low), SMALLEST * all), all);
  const middle = around ?? 0.5 * (low + high);
  const begin = Math.min(Math.max(middle - 0.5 * size, whole[0]), whole[1] - size);
  return [begin, begin + size];
}

/** A plot over time: uPlot. */
export class TimePlot extends Plot {
  private chart: uPlot | undefined;
  private zoomed: Range | undefined;
  private shown = "";

  constructor(
    kind: string,
    cursor: Cursor,
    /** Called when this plot is zoomed; none is the whole run. */
    private readonly onZoom: (range: Range | undefined) => void,
  ) {
    super(kind, cursor);
    cursor.on((at, from) => from !== this && this.moveTo(at));
  }

  protected update(): void {
    const shown = this.diagram.curves.map(({ name, law, style }) => `${name} ${law} ${style}`).join();
    if (!this.chart || shown !== this.shown) {
      this.shown = shown;
      this.build();
    } else this.chart.setData(this.data(), false);
    this.scale();
  }

  private data(): uPlot.AlignedData {
    const { curves } = this.diagram;
    const longest = curves.reduce<ArrayLike<number>>((a, { x }) => (x.length > a.length ? x : a), []);
    const whole = ({ y }: Curve): ArrayLike<number | null> => {
      if (y.length === longest.length && !hasGap(y)) return y;
      return Array.from({ length: longest.length }, (_, at) => (Number.isNaN(y[at]) ? null : (y[at] ?? null)));
    };
    return [longest, ...curves.map(whole)] as unknown as uPlot.AlignedData;
  }

  private build(): void {
    this.chart?.destroy();
    const { laws } = colours();
    const { x, y, curves } = this.diagram;
    const series = curves.map((curve) => {
      const { width, alpha, dash } = stroke(curve, dashes());
      const half = 0.5 * width * devicePixelRatio;
      // The line goes on across a gap, unseen but for half its width at both ends.
      const gaps: uPlot.Series.GapsRefiner = (...[, , , , found]) => found.map(([from, to]) => [from - half, to + half]);
      const look = { stroke: laws[curve.law]!, width, alpha, dash: dash ? dash.split(" ").map(Number) : [] };
      return { label: curve.name, ...look, gaps, points: { show: false } };
    });
    this.chart = new uPlot(
      {
        ...this.size(),
        legend: { show: false },
        cursor: { y: false, points: { size: 8, fill: (_, at) => laws[curves[at - 1]!.law]! }, drag: { x: true, y: false, dist: 5 }, bind: { dblclick: () => null } },
        scales: { x: { time: false }, y: { range: (_, low, high) => rangeUp(this.diagram, [[low ?? 0, high ?? 0]]) } },
        axes: [axis(labelText(x), 34), axis(labelText(y), 60)],
        series: [{}, ...series],
        hooks: {
          drawAxes: [(chart) => this.drawZero(chart)],
          setCursor: [(chart) => this.cursor.move(chart.cursor.idx ?? null, this)],
          setSelect: [(chart) => this.select(chart)],
        },
      },
      this.data(),
      this.area,
    );
    this.chart.over.addEventListener("dblclick", () => this.onZoom(undefined));
  }

  /** The line at zero of residuals, and the band of the noise around it. */
  private drawZero({ ctx, bbox: { left, top, width, height }, valToPos }: uPlot): void {
    const { noise } = this.diagram;
    if (noise === undefined) return;
    const [zero, most] = [0, noise].map((value) => valToPos(value, "y", true)) as [number, number];
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.fillStyle = colours().axis;
    ctx.fillRect(left, zero - 0.5 * devicePixelRatio, width, devicePixelRatio);
    ctx.globalAlpha = NOISE;
    ctx.fillRect(left, most, width, 2 * (zero - most));
    ctx.restore();
  }

  private select(chart: uPlot): void {
    if (chart.select.width < 5) return;
    const [left, right] = [chart.select.left, chart.select.left + chart.select.width];
    this.onZoom([chart.posToVal(left, "x"), chart.posToVal(right, "x")]);
    chart.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }

  /** Shows a part of the run, or the whole. */
  zoom(range: Range | undefined): void {
    this.zoomed = range;
    this.scale();
  }

  private scale(): void {
    const x = this.zoomed ?? range(this.diagram.curves.map((curve) => curve.x), 0);
    this.chart?.setScale("x", { min: x[0], max: x[1] });
  }

  protected ranges(): { x: Range; y: Range } {
    const { curves } = this.diagram;
    const x = this.zoomed ?? range(curves.map((curve) => curve.x), 0);
    // Times ascend: the range lies between two samples.
    const inside = curves.map((curve) => part(curve.y, below(curve.x, x[0]), below(curve.x, x[1], true)));
    return { x, y: rangeUp(this.diagram, inside) };
  }

  private size(): { width: number; height: number } {
    return { width: Math.max(this.area.clientWidth, 200), height: Math.max(this.area.clientHeight, 100) };
  }

  protected resize(): void {
    this.chart?.setSize(this.size());
  }

  reset(): void {
    this.onZoom(undefined);
  }

  isPart(): boolean {
    return this.zoomed !== undefined;
  }

  touch([right]: Place): void {
    const { chart } = this;
    if (!chart) return;
    const at = chart.posToIdx(right - chart.over.offsetLeft);
    this.cursor.move(at, this);
    this.moveTo(at);
  }

  protected ends(): { x: Range; y: Range } {
    const { offsetLeft, offsetTop, clientWidth, clientHeight } = this.chart!.over;
    return { x: [offsetLeft, offsetLeft + clientWidth], y: [offsetTop + clientHeight, offsetTop] };
  }

  protected look(x: Range): void {
    const whole = range(this.diagram.curves.map((curve) => curve.x), 0);
    const part = within(x, whole);
    this.onZoom(part[0] <= whole[0] && part[1] >= whole[1] ? undefined : part);
  }

  protected magnify(factor: number): void {
    const { curves } = this.diagram;
    const whole = range(curves.map((curve) => curve.x), 0);
    const { x } = this.ranges();
    const at = this.cursor.at === null ? undefined : curves[0]?.x[this.cursor.at];
    this.look(within(x, whole, at, factor));
  }

  theme(): void {
    if (!this.chart) return;
    this.build();
    this.scale();
  }

  protected point(at: number): void {
    this.moveTo(at);
  }

  private moveTo(at: number | null): void {
    const chart = this.chart;
    if (!chart) return;
    const time = at === null ? undefined : chart.data[0]?.[at];
    const left = time === undefined ? -10 : chart.valToPos(time, "x");
    chart.setCursor({ left, top: left < 0 ? -10 : chart.over.clientHeight / 2 }, false);
  }
}

/** A plot of one result over another, or of a curve: our own canvas. */
export class LoopPlot extends Plot {
  private readonly canvas = h("canvas", { "aria-hidden": "true" });
  private readonly box = h("div", { class: "box", hidden: true });
  /** The part that is shown; upwards all that lies in it, unless that is chosen too. */
  private zoomed: { x: Range; y?: Range } | undefined;
  private from: [number, number] | undefined;
  private waits = false;

  constructor(
    kind: string,
    cursor: Cursor,
    /** Called when this plot is zoomed, with what it shows across; none is the whole. */
    private readonly onZoom?: (across: Range | undefined) => void,
  ) {
    super(kind, cursor);
    this.area.append(this.canvas, this.box);
    this.area.classList.add("loop");
    cursor.on(() => this.redraw());
    // Fingers are heeded otherwise.
    const mouse = (type: "pointermove" | "pointerleave" | "pointerdown" | "pointerup", does: (event: PointerEvent) => void) =>
      this.canvas.addEventListener(type, (event) => event.pointerType !== "touch" && does(event));
    mouse("pointermove", (event) => this.hover(event));
    mouse("pointerleave", () => this.cursor.move(null, this));
    mouse("pointerdown", (event) => {
      this.from = [event.offsetX, event.offsetY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    mouse("pointerup", (event) => this.release(event));
    this.canvas.addEventListener("dblclick", () => this.reset());
  }

  protected update(): void {
    this.redraw();
  }

  protected ranges(): { x: Range; y: Range } {
    if (!this.zoomed) return this.whole();
    const { x, y } = this.zoomed;
    const inside = (curve: Curve) => Array.from(curve.y).filter((_, at) => curve.x[at]! >= x[0] && curve.x[at]! <= x[1]);
    return { x, y: y ?? rangeUp(this.diagram, this.diagram.curves.map(inside)) };
  }

  private frame(): Frame {
    const { x, y } = this.ranges();
    return new Frame(this.area.clientWidth, this.area.clientHeight, x, y, 12);
  }

  /** Draws before the next picture of the screen. */
  private redraw(): void {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(() => {
      this.waits = false;
      this.paint();
    });
  }

  private paint(): void {
    const [width, height] = [this.area.clientWidth, this.area.clientHeight];
    const context = this.canvas.getContext("2d");
    if (!context || width === 0) return;
    const scale = devicePixelRatio || 1;
    this.canvas.width = Math.round(width * scale);
    this.canvas.height = Math.round(height * scale);
    const pen = new CanvasPen(context, width, height, scale);
    const frame = this.frame();
    draw(pen, frame, this.diagram, colours(), dashes());
    const { at } = this.cursor;
    if (at === null) return;
    for (const { x, y, law } of pointed(this.diagram)) {
      if (at < x.length) pen.disc([frame.across(x[at]!), frame.up(y[at]!)], 4.5, colours().laws[law]!);
    }
  }

  /** The point that is nearest to the pointer. */
  private hover(event: PointerEvent): void {
    if (this.from) {
      this.stretch(event);
      return;
    }
    this.touch([event.offsetX, event.offsetY]);
  }

  touch(place: Place): void {
    const frame = this.frame();
    let [nearest, best] = [null as number | null, 30 * 30];
    for (const { x, y } of pointed(this.diagram)) {
      for (let at = 0; at < x.length; at++) {
        const [right, down] = [frame.across(x[at]!) - place[0], frame.up(y[at]!) - place[1]];
        const far = right * right + down * down;
        if (far < best) [nearest, best] = [at, far];
      }
    }
    this.cursor.move(nearest, this);
  }

  private stretch(event: PointerEvent): void {
    const [x, y] = this.from!;
    const style = this.box.style;
    this.box.hidden = Math.abs(event.offsetX - x) < 5;
    style.left = `${Math.min(x, event.offsetX)}px`;
    style.top = `${Math.min(y, event.offsetY)}px`;
    style.width = `${Math.abs(event.offsetX - x)}px`;
    style.height = `${Math.abs(event.offsetY - y)}px`;
  }

  private release(event: PointerEvent): void {
    const from = this.from;
    this.from = undefined;
    this.box.hidden = true;
    if (!from || Math.abs(event.offsetX - from[0]) < 5 || Math.abs(event.offsetY - from[1]) < 5) return;
    const frame = this.frame();
    const [a, b] = [frame.at(...from), frame.at(event.offsetX, event.offsetY)];
    const sorted = (one: number, other: number): Range => [Math.min(one, other), Math.max(one, other)];
    this.magnified({ x: sorted(a[0], b[0]), y: sorted(a[1], b[1]) });
  }

  private magnified(part: { x: Range; y: Range } | undefined): void {
    this.zoomed = part;
    this.redraw();
    this.onZoom?.(part?.x);
  }

  /** Shows what lies in a range across, or the whole. */
  zoom(x: Range | undefined): void {
    this.zoomed = x && { x };
    this.redraw();
  }

  protected resize(): void {
    this.redraw();
  }

  reset(): void {
    this.magnified(undefined);
  }

  isPart(): boolean {
    return this.zoomed !== undefined;
  }

  protected ends(): { x: Range; y: Range } {
    const { left, right, top, bottom } = this.frame();
    return { x: [left, right], y: [bottom, top] };
  }

  private whole(): { x: Range; y: Range } {
    const { curves } = this.diagram;
    return { x: range(curves.map((curve) => curve.x)), y: rangeUp(this.diagram, curves.map((curve) => curve.y)) };
  }

  protected look(x: Range, y: Range): void {
    const whole = this.whole();
    const part = { x: within(x, whole.x), y: within(y, whole.y) };
    const isAll = (one: Range, all: Range) => one[0] <= all[0] && one[1] >= all[1];
    this.magnified(isAll(part.x, whole.x) && isAll(part.y, whole.y) ? undefined : part);
  }

  protected magnify(factor: number): void {
    const { curves } = this.diagram;
    const [curve] = curves;
    const { x, y } = this.ranges();
    const at = this.cursor.at;
    const [nearX, nearY] = at === null ? [undefined, undefined] : [curve?.x[at], curve?.y[at]];
    const whole = this.whole();
    this.look(within(x, whole.x, nearX, factor), within(y, whole.y, nearY, factor));
  }

  theme(): void {
    this.redraw();
  }

  protected point(): void {
    this.redraw();
  }
}

