// Copyright the limpet authors. GPL-3.0-or-later.
// How finely to draw. Graphics hardware draws all at once; where a processor does its work, less is drawn
// while something moves, and all of it, smoothly, once it rests.

const kFluent = 45,
  kQuick = 14; // milliseconds of a frame: above, less is drawn; below, more
const kMostLevel = 3;
const kFirst = 3; // frames until one tells what frames cost
const kMostFine = 450; // milliseconds that a fine frame may take
const kRest = 220; // milliseconds after which a scene counts as resting

/// Levels: 0 all; 1 at fewer pixels; 2 without points; 3 without the lines of large models.
export class Quality {
  constructor() {
    this.software = isSoftware();
    this.level = 0;
    this.frames = 0;
    this.cost = 0; // of a frame of level 0, in milliseconds
    this.last = -Infinity;
  }

  get antialias() {
    return !this.software;
  }

  /// For the frame that is due now: {level, scale}.
  forFrame(now) {
    const moving = now - this.last < kRest;
    this.last = now;
    if (!this.software || !moving) return { level: 0, scale: 1 };
    return { level: this.level, scale: this.level > 0 ? 0.6 : 1 };
  }

  /// What a frame took.
  took(milliseconds, { level, scale }) {
    if (++this.frames < kFirst || scale > 1) return; // the first ones compile shaders
    if (level === 0 && scale === 1) this.cost = milliseconds;
    if (level !== this.level && level !== 0) return;
    if (milliseconds > kFluent) this.level = Math.min(kMostLevel, this.level + 1);
    else if (milliseconds < kQuick && level === this.level) this.level = Math.max(0, this.level - 1);
  }

  /// Once all rests: the frame to draw then, or null if the last one will do.
  whenResting(ratio, last) {
    if (!this.software) return null;
    if (this.frames < kFirst) return { level: 0, scale: 1 };
    if (last.scale > 1) return null;
    if (ratio < 2 && 4 * this.cost < kMostFine) return { level: 0, scale: 2 / ratio };
    return last.level > 0 ? { level: 0, scale: 1 } : null;
  }
  get rest() {
    return kRest;
  }
}

function isSoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return false;
  let name = String(gl.getParameter(gl.RENDERER));
  if (/^WebKit/.test(name)) {
    const more = gl.getExtension("WEBGL_debug_renderer_info");
    if (more) name = String(gl.getParameter(more.UNMASKED_RENDERER_WEBGL));
  }
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
