// Lets a press of the mouse draw nothing. viser takes the camera's hold on the mouse away for a
// drag and gives it back, and draws frames for a quarter of a second each time, though neither
// changes the picture; where no GPU helps, the answer to a click waited behind them.
(() => {
  const viewer = window.__viserMutable;
  if (Object.getOwnPropertyDescriptor(viewer, "cameraControl").get) return;

  const withoutDrawing = (change) => {
    const draw = viewer.requestRender;
    viewer.requestRender = () => {};
    try { change(); } finally { viewer.requestRender = draw; }
  };
  const quiet = (controls) => controls && new Proxy(controls, {
    get: (target, name) => Reflect.get(target, name),
    set: (target, name, value) => {
      if (name === "enabled") withoutDrawing(() => { target.enabled = value; });
      else target[name] = value;
      return true;
    },
  });

  let controls = quiet(viewer.cameraControl);
  Object.defineProperty(viewer, "cameraControl", {
    configurable: true,
    enumerable: true,
    get: () => controls,
    set: (value) => { controls = quiet(value); },
  });
})();
