// Lays the aim arrow under the pointer. viser reports no hovering, and a round trip to the server
// for every movement would lag behind the hand, so the arrow's pose is set here, where viser keeps
// it; the next pose that the server sends replaces it.
(() => {
  const NODE = "$node", REACH = $reach, HEIGHT = $height;
  window.__singulateHover?.abort();
  window.__singulateHover = new AbortController();

  const pointOnTable = (event, viewer, node) => {
    const box = viewer.canvas.getBoundingClientRect();
    const camera = viewer.camera;
    const toWorld = node.parent.matrixWorld.clone().invert();
    const eye = camera.position.clone().applyMatrix4(toWorld);
    const seen = camera.position.clone().set(
      2 * (event.clientX - box.left) / box.width - 1,
      1 - 2 * (event.clientY - box.top) / box.height,
      0.5,
    ).unproject(camera).applyMatrix4(toWorld);
    const ray = seen.sub(eye);
    const distance = -eye.z / ray.z;
    return distance > 0 ? eye.addScaledVector(ray, distance) : null;
  };

  const follow = (event) => {
    const viewer = window.__viserMutable;
    const node = viewer?.nodeRefFromName?.[NODE];
    const pose = viewer?.nodePoseData?.[NODE];
    if (!node || !pose || event.buttons !== 0 || !viewer.canvas.contains(event.target)) return;
    const point = pointOnTable(event, viewer, node);
    if (point === null || Math.max(Math.abs(point.x), Math.abs(point.y)) > REACH) return;
    pose.position = [point.x, point.y, HEIGHT];
    pose.poseUpdateState = "needsUpdate";
    viewer.requestRender();
  };
  // Nothing is followed while a button is pressed; once it is released, the pointer may rest.
  for (const kind of ["pointermove", "pointerup"]) {
    window.addEventListener(kind, follow, { passive: true, signal: window.__singulateHover.signal });
  }
})();
