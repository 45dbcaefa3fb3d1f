/** Surfaces to draw on: a canvas or an SVG. */

export type Points = { x: ArrayLike<number>; y: ArrayLike<number> };
export type Anchor = "start" | "middle" | "end";

export interface Pen {
  line(from: [number, number], to: [number, number], colour: string, width?: number): void;
  /** A curve inside a rectangle; points that are not numbers interrupt it. */
  curve(points: Points, clip: [number, number, number, number], colour: string, dash: string, width: number, alpha?: number): void;
  disc(at: [number, number], radius: number, colour: string): void;
  text(at: [number, number], text: string, colour: string, anchor: Anchor, upright?: boolean, size?: number): void;
  fill(colour: string): void;
}

export const FONT = 12;
const FAMILY = "system-ui, 'Noto Sans', Arial, sans-serif";

export class CanvasPen implements Pen {
  constructor(
    private readonly context: CanvasRenderingContext2D,
    private readonly width: number,
    private readonly height: number,
    scale: number,
  ) {
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.lineJoin = "round";
  }

  fill(colour: string): void {
    this.context.fillStyle = colour;
    this.context.fillRect(0, 0, this.width, this.height);
  }

  line(from: [number, number], to: [number, number], colour: string, width = 1): void {
    const { context } = this;
    context.setLineDash([]);
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(...from);
    context.lineTo(...to);
    context.stroke();
  }

  curve({ x, y }: Points, clip: [number, number, number, number], colour: string, dash: string, width: number, alpha = 1): void {
    const { context } = this;
    context.save();
    context.beginPath();
    context.rect(...clip);
    context.clip();
    context.globalAlpha = alpha;
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.setLineDash(dash ? dash.split(" ").map(Number) : []);
    context.beginPath();
    let isOpen = false;
    for (let at = 0; at < x.length; at++) {
      const right = x[at]!;
      const down = y[at]!;
      if (!Number.isFinite(right + down)) isOpen = false;
      else if (isOpen) context.lineTo(right, down);
      else {
        context.moveTo(right, down);
        isOpen = true;
      }
    }
    context.stroke();
    context.restore();
  }

  disc(at: [number, number], radius: number, colour: string): void {
    this.context.fillStyle = colour;
    this.context.beginPath();
    this.context.arc(at[0], at[1], radius, 0, 2 * Math.PI);
    this.context.fill();
  }

  text(at: [number, number], text: string, colour: string, anchor: Anchor, upright = false, size = FONT): void {
    const { context } = this;
    context.save();
    context.font = `${size}px ${FAMILY}`;
    context.fillStyle = colour;
    context.textAlign = anchor === "middle" ? "center" : anchor;
    context.translate(...at);
    if (upright) context.rotate(-Math.PI / 2);
    context.fillText(text, 0, 0);
    context.restore();
  }
}

const escaped = (text: string) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/"/g, "&quot;");
const place = (value: number) => String(Math.round(100 * value) / 100);

export class SvgPen implements Pen {
  private readonly parts: string[] = [];
  private clips = 0;

  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly title: string,
  ) {}

  fill(colour: string): void {
    this.parts.push(`<rect width="${this.width}" height="${this.height}" fill="${colour}"/>`);
  }

  line(from: [number, number], to: [number, number], colour: string, width = 1): void {
    const [[x1, y1], [x2, y2]] = [from.map(place), to.map(place)] as [string[], string[]];
    this.parts.push(`<path d="M${x1} ${y1}L${x2} ${y2}" stroke="${colour}" stroke-width="${width}"/>`);
  }

  curve({ x, y }: Points, clip: [number, number, number, number], colour: string, dash: string, width: number, alpha = 1): void {
    const id = `clip-${++this.clips}`;
    const [left, top, wide, high] = clip.map(place);
    let path = "";
    let before = "";
    for (let at = 0; at < x.length; at++) {
      if (!Number.isFinite(x[at]! + y[at]!)) {
        before = "";
        continue;
      }
      const point = `${place(x[at]!)} ${place(y[at]!)}`;
      if (point === before) continue;
      path += `${before === "" ? "M" : "L"}${point}`;
      before = point;
    }
    this.parts.push(
      `<clipPath id="${id}"><rect x="${left}" y="${top}" width="${wide}" height="${high}"/></clipPath>`,
      `<path d="${path}" clip-path="url(#${id})" fill="none" stroke="${colour}" stroke-width="${width}"` +
        ` stroke-linejoin="round"${dash ? ` stroke-dasharray="${dash}"` : ""}${alpha < 1 ? ` stroke-opacity="${alpha}"` : ""}/>`,
    );
  }

  disc(at: [number, number], radius: number, colour: string): void {
    this.parts.push(`<circle cx="${place(at[0])}" cy="${place(at[1])}" r="${radius}" fill="${colour}"/>`);
  }

  text(at: [number, number], text: string, colour: string, anchor: Anchor, upright = false, size = FONT): void {
    const [x, y] = at.map(place);
    const turned = upright ? ` transform="rotate(-90 ${x} ${y})"` : "";
    const sized = size === FONT ? "" : ` font-size="${size}"`;
    this.parts.push(`<text x="${x}" y="${y}" fill="${colour}" text-anchor="${anchor}"${turned}${sized}>${escaped(text)}</text>`);
  }

  /** The picture as a file. */
  document(): string {
    const { width, height } = this;
    return (
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}"` +
      ` font-family="${FAMILY}" font-size="${FONT}" role="img"><title>${escaped(this.title)}</title>\n` +
      `${this.parts.join("\n")}\n</svg>\n`
    );
  }
}
