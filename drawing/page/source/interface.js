// Copyright the limpet authors. GPL-3.0-or-later.
// window.limpet: what tests and scripts may ask of the page.
import { derived, edgeEnds } from "./geometry.js";
import { selectionOf } from "./pointer.js";

export function testInterface(started, failed) {
  const page = {};
  page.ready = started.then(({ app, ui }) => {
    const { viewer, frame } = app;
    Object.assign(page, {
      head: app.head,
      timeline: app.timeline,
      state: () => app.state,
      seek: (step) => app.seek(step),
      select: (selection) => app.select(selection, { focus: true }),
      selection: () => app.selection,
      play: () => ui.player.play(),
      pause: () => ui.player.pause(),
      isPlaying: () => ui.player.playing,
      /// What a click at these pixels of the window would select.
      pick: (x, y) => {
        const { left, top } = viewer.canvas.getBoundingClientRect();
        return selectionOf(app.picker.pick(x - left, y - top));
      },
      /// Pixels of the window where a place of the world is drawn.
      project: (world) => {
        viewer.prepare();
        const [x, y] = viewer.project(frame.ofWorld(world));
        const { left, top } = viewer.canvas.getBoundingClientRect();
        return [left + x, top + y];
      },
      /// A place in the world: well inside a polygon, or the middle of an edge.
      placeOf: ({ polygon, edge }) => {
        if (polygon !== undefined)
          return frame.toWorld(derived(app.state.polygons.get(polygon), frame).inner);
        const [a, b] = edgeEnds(app.state, edge, frame);
        return frame.toWorld(a.map((x, i) => (x + b[i]) / 2));
      },
      setView: (name) => viewer.setView(name),
      stats: () => ({
        step: app.step,
        frames: viewer.frames,
        triangles: app.model.faces.count,
        edges: app.model.edgeCount,
        corners: app.model.corners.count,
        points: app.model.points.count,
        polygons: app.state.polygons.size,
        view: viewer.view,
        theme: app.theme,
        orthographic: viewer.isOrthographic,
        calls: viewer.renderer.info.render.calls,
        software: viewer.quality.software,
        level: viewer.quality.level,
        cost: viewer.quality.cost,
        snapshots: app.timeline.snapshots.length,
      }),
      render: (how) => viewer.render(how),
      camera: () => frame.toWorld(viewer.camera.position.toArray()),
    });
    return page;
  });
  page.ready.catch(failed);
  return page;
}
