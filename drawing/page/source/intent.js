// Copyright the limpet authors. GPL-3.0-or-later.
// What the robot is up to, for one step: integer coordinates like the model's.

const kTargets = 1,
  kAim = 2,
  kWay = 4,
  kEdge = 8,
  kSegment = 16,
  kSlice = 32;

export function readIntent(reader) {
  const flags = reader.unsigned();
  if (flags === 0) return null;
  const intent = {};
  if (flags & kTargets) intent.targets = readPlaces(reader, reader.unsigned());
  if (flags & kAim) {
    intent.aim = {
      target: [reader.signed(), reader.signed(), reader.signed()],
      place: [reader.signed(), reader.signed(), reader.signed()],
    };
  }
  if (flags & kWay) intent.way = readPlaces(reader, reader.unsigned());
  if (flags & kEdge) intent.edge = reader.unsigned();
  if (flags & kSegment) intent.segment = reader.unsigned();
  if (flags & kSlice) intent.slice = readPlaces(reader, reader.unsigned());
  return intent;
}

function readPlaces(reader, count) {
  const places = new Float64Array(3 * count);
  for (let i = 0; i < places.length; ++i) places[i] = (i >= 3 ? places[i - 3] : 0) + reader.signed();
  return places;
}
