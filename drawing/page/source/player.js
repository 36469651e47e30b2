// Copyright the limpet authors. GPL-3.0-or-later.
// Plays the timeline: steps a second, as many of them as frames allow.

export const kSpeeds = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 5000];

export class Player {
  constructor(app) {
    this.app = app;
    this.playing = false;
    // A run takes about half a minute, unless that is asked to be otherwise.
    const wanted = app.head.steps / 30;
    this.speed = kSpeeds.find((speed) => speed >= wanted) ?? kSpeeds.at(-1);
    this.listeners = [];
  }

  setSpeed(speed) {
    this.speed = speed;
    this.#tell();
  }
  faster(by) {
    const at = kSpeeds.indexOf(this.speed);
    this.setSpeed(kSpeeds[Math.min(kSpeeds.length - 1, Math.max(0, at + by))]);
  }

  play() {
    if (this.playing || !this.app.isRun) return;
    if (this.app.step >= this.app.head.steps) this.app.seek(1);
    this.playing = this.app.playing = true;
    this.last = performance.now();
    this.owed = 0;
    this.#tell();
    requestAnimationFrame(() => this.#frame());
  }
  pause() {
    if (!this.playing) return;
    this.playing = this.app.playing = false;
    this.app.emit("step"); // for what had not kept up
    this.#tell();
  }
  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  #frame() {
    if (!this.playing) return;
    const now = performance.now();
    this.owed += (Math.min(now - this.last, 500) / 1000) * this.speed;
    this.last = now;
    const steps = Math.floor(this.owed);
    if (steps > 0) {
      this.owed -= steps;
      this.app.seek(this.app.step + steps);
    }
    if (this.app.step >= this.app.head.steps) this.pause();
    else requestAnimationFrame(() => this.#frame());
  }

  #tell() {
    for (const call of this.listeners) call();
  }
}
