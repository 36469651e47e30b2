// Copyright the limpet authors. GPL-3.0-or-later.
// Numbers for people.

/// Four digits that count, without trailing zeros: 0.05123, 12.3, 4567.
export function number(x, digits = 4) {
  if (!Number.isFinite(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  if (size >= 1e7 || size < 1e-5)
    return x
      .toExponential(digits - 1)
      .replace("-", "−")
      .replace("e−", "e-");
  const text = size >= 10 ** digits ? Math.round(x).toString() : Number(x.toPrecision(digits)).toString();
  return text.replace("-", "−");
}

export const count = (n) => n.toString().replace(/\B(?=(\d{3})+(?!\d))/g, "\u202f");

/// A length, in the scan's unit and in λ.
export const length = (x, resolution) =>
  Number.isFinite(x) ? `${number(x)} (${number(x / resolution, 3)} λ)` : "–";
export const area = (x, resolution) => `${number(x)} (${number(x / resolution ** 2, 3)} λ²)`;
export const place = (at) => at.map((x) => number(x, 5)).join(", ");
export const direction = (n) => n.map((x) => x.toFixed(4).replace("-", "−")).join(", ");

export function duration(us) {
  if (!Number.isFinite(us)) return "–";
  return us >= 1e6
    ? `${number(us / 1e6, 3)} s`
    : us >= 1000
      ? `${number(us / 1000, 3)} ms`
      : `${number(us, 3)} µs`;
}

export const plural = (n, word, words = `${word}s`) => `${count(n)} ${n === 1 ? word : words}`;
