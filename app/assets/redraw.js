// Draws what has changed, and nothing else. viser draws the whole picture again and again for a
// quarter of a second after every message and every press of the mouse, and once a second on a calm
// page. Where no GPU helps, each picture holds up the page: what the mouse does, and what arrives,
// waits until it is drawn.
(() => {
  const viewer = window.__viserMutable;
  const gl = viewer.scene?.__r3f?.root?.getState?.().gl;
  if (!gl || gl.drawWhole) return;

  const FIELD = "$field";
  const LONGEST_MS = 10000;  // then the whole picture, in case something has been overlooked
  const MARGIN = 16;  // pixels that outlines may reach beyond what they are around
  const EVERYWHERE = { left: -1, right: 1, bottom: -1, top: 1 };

  const tell = (value, told) => {
    if (value?.isTexture) told.push(value, value.version, value.source.version);
    else if (value?.toArray) told.push(...value.toArray());
    else if (value === null || typeof value !== "object") told.push(value);
  };

  const tellMaterial = (material, told) => {
    // three.js counts the version of a transparent surface up each time that it draws it.
    for (const name in material) if (name !== "version") tell(material[name], told);
    for (const name in material.uniforms) tell(material.uniforms[name].value, told);
  };

  const tellGeometry = (geometry, told) => {
    const { attributes, index, drawRange, instanceCount } = geometry;
    told.push(geometry, index, index?.version, drawRange.start, drawRange.count, instanceCount);
    for (const name in attributes) told.push(attributes[name], attributes[name].version);
  };

  // All that the picture of a part depends on.
  const describe = (part) => {
    const { matrixWorld, material, geometry } = part;
    const told = [part.renderOrder, part.layers.mask, part.castShadow, part.receiveShadow];
    tell(matrixWorld, told);
    if (part.isLight) for (const name in part) tell(part[name], told);
    for (const each of [material ?? []].flat()) tellMaterial(each, told);
    if (geometry) tellGeometry(geometry, told);
    return told;
  };

  const isPart = ({ isLight, geometry, material }) => isLight
    || (geometry && geometry.instanceCount !== 0 && material?.visible !== false);

  const collect = (object, parts) => {
    if (!object.visible) return parts;
    if (isPart(object)) parts.set(object, { told: describe(object), box: EVERYWHERE });
    for (const child of object.children) collect(child, parts);
    return parts;
  };

  // Where in the picture a part is, from -1 to 1 across and up.
  const boxAround = (part, camera) => {
    const { geometry, matrixWorld } = part;
    const isBounded = geometry && !geometry.isInstancedBufferGeometry && !part.castShadow
      && !part.isSkinnedMesh && !part.isInstancedMesh;
    if (!isBounded) return EVERYWHERE;
    geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox;
    const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
    const corner = min.clone();
    for (let i = 0; i < 8; i++) {
      corner.set(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z);
      corner.applyMatrix4(matrixWorld).applyMatrix4(camera.matrixWorldInverse);
      if (!(corner.z <= -camera.near)) return EVERYWHERE;  // NaN, too
      corner.applyMatrix4(camera.projectionMatrix);
      box.left = Math.min(box.left, corner.x);
      box.right = Math.max(box.right, corner.x);
      box.bottom = Math.min(box.bottom, corner.y);
      box.top = Math.max(box.top, corner.y);
    }
    return box;
  };

  const isSame = (one, other) => one.length === other.length
    && one.every((value, i) => Object.is(value, other[i]));

  const picture = (scene, camera) => {
    const view = [scene.background, scene.environment, scene.fog, scene.overrideMaterial];
    tell(camera.matrixWorld, view);
    tell(camera.projectionMatrix, view);
    return { view, parts: collect(scene, new Map()) };
  };

  // Boxes around all in which a picture differs from the one before.
  const differences = (before, now, camera) => {
    const isSameView = before !== null && isSame(before.view, now.view);
    const boxes = isSameView ? [] : [EVERYWHERE];
    for (const [part, each] of now.parts) {
      const earlier = isSameView ? before.parts.get(part) : undefined;
      if (earlier && isSame(earlier.told, each.told)) {
        each.box = earlier.box;
        continue;
      }
      each.box = boxAround(part, camera);
      boxes.push(each.box, earlier?.box ?? each.box);
    }
    if (!isSameView) return boxes;
    for (const [part, { box }] of before.parts) if (!now.parts.has(part)) boxes.push(box);
    return boxes;
  };

  const keepTo = (boxes) => {
    const { width, height } = gl.domElement;
    const ratio = gl.getPixelRatio();
    const pixel = (at, length) => Math.round((at + 1) / 2 * length / ratio);
    const left = pixel(Math.min(...boxes.map((box) => box.left)), width) - MARGIN;
    const right = pixel(Math.max(...boxes.map((box) => box.right)), width) + MARGIN;
    const bottom = pixel(Math.min(...boxes.map((box) => box.bottom)), height) - MARGIN;
    const top = pixel(Math.max(...boxes.map((box) => box.top)), height) + MARGIN;
    gl.setScissor(left, bottom, right - left, top - bottom);
    gl.setScissorTest(true);
  };

  // viser covers the whole picture with a background where there is none, and makes smaller copies
  // of each picture on the table, at a third of the price of drawing it; it is never seen so small.
  const spare = () => {
    const background = viewer.backgroundMaterial;
    if (background) background.visible = background.uniforms.enabled.value;
    viewer.nodeRefFromName[FIELD]?.traverse(({ material }) => {
      const map = material?.map;
      if (map) Object.assign(map, { minFilter: map.magFilter, generateMipmaps: false });
    });
  };

  const { render, setSize } = gl;
  let shown = null;  // the picture that is there; null where there is none to add to
  let wholeAt = -Infinity;

  gl.drawWhole = () => { shown = null; };
  gl.domElement.addEventListener("webglcontextrestored", gl.drawWhole);
  gl.setSize = (...size) => {
    gl.drawWhole();
    return setSize.apply(gl, size);
  };

  gl.render = (scene, camera) => {
    if (scene !== viewer.scene || gl.getRenderTarget() !== null) {
      render.call(gl, scene, camera);
      return;
    }
    scene.updateMatrixWorld();
    camera.updateMatrixWorld();
    if (performance.now() - wholeAt > LONGEST_MS) gl.drawWhole();
    spare();
    const now = picture(scene, camera);
    const boxes = differences(shown, now, camera);
    if (boxes.length === 0) return;
    gl.drawWhole();
    if (boxes.includes(EVERYWHERE)) wholeAt = performance.now();
    else keepTo(boxes);
    try {
      render.call(gl, scene, camera);
    } finally {
      gl.setScissorTest(false);
    }
    shown = now;
  };
})();
