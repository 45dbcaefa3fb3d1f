/** Numbers, units and names as they are shown. */

/** A number with four digits, for reading. */
export function short(value: number): string {
  if (!Number.isFinite(value)) return String(value);
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-3 ? value.toExponential(3) : value.toPrecision(4);
  const [digits = "", power] = text.split("e");
  const trimmed = digits.includes(".") ? digits.replace(/\.?0+$/, "") : digits;
  return (power ? `${trimmed}e${Number(power)}` : trimmed).replace("-", "\u2212");
}

/** The number that a user has typed; undefined if it is none. */
export function parsed(text: string): number | undefined {
  const plain = text.trim().replace("\u2212", "-").replace(",", ".");
  const value = Number(plain);
  // JavaScript has other spellings too, such as 0x10.
  return /^[-+]?[\d.]+(e[-+]?\d+)?$/i.test(plain) && Number.isFinite(value) ? value : undefined;
}

/** A unit as it is printed: N.s2/m2 is N·s²/m². */
export function unitText(unit: string): string {
  if (unit === "1") return "";
  return unit.replace("um", "\u00b5m").replace(/\./g, "\u00b7").replace(/2/g, "\u00b2").replace(/3/g, "\u00b3");
}

/** The name of a part in words. */
export function words(name: string): string {
  const text = name.replace(/_/g, " ");
  return text.charAt(0).toUpperCase() + text.slice(1);
}
