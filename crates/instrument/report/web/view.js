// The view of a drawing that turns and zooms: predicamentView(drawing) is an element. The data are those of `Drawing::json`.
const predicamentView = (() => {
  "use strict";
  const STEPS = 1e6;
  const COLOURS = { given: [46, 134, 204], second: [213, 94, 0], found: [0, 158, 115], mark: [204, 121, 167], faint: [140, 140, 140] };
  const make = (tag, properties = {}, children = []) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };

  // Paths of a layer as lists of the numbers of their points.
  const paths = ({ lengths, at }) => {
    const list = [];
    for (let from = 0, path = 0; from < at.length; path += 1) {
      const length = lengths.length === 1 ? lengths[0] : lengths[path];
      list.push(at.slice(from, from + length));
      from += length;
    }
    return list;
  };
  const point = (layer, at) => [0, 1, 2].map((axis) => layer.points[3 * at + axis] / STEPS);

  const VERTEX = `
    attribute vec3 position; attribute vec3 normal;
    uniform mat4 modelViewMatrix; uniform mat4 projectionMatrix; uniform mat3 normalMatrix; uniform float size; uniform float nearer;
    varying vec3 facing;
    void main() {
      facing = normalMatrix * normal;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      gl_Position.z -= nearer * gl_Position.w;
      gl_PointSize = size;
    }`;
  // What faces the eye edge on is darker; points are round.
  const FRAGMENT = `
    precision highp float;
    uniform vec3 colour; uniform float opacity; uniform float lit; uniform float round;
    varying vec3 facing;
    void main() {
      vec2 from = gl_PointCoord - 0.5;
      if (round > 0.5 && dot(from, from) > 0.25) discard;
      float shade = lit > 0.5 ? 0.45 + 0.55 * abs(normalize(facing).z) : 1.0;
      gl_FragColor = vec4(colour * shade * opacity, opacity);
    }`;

  const corners = (layer, space) => {
    const position = []; const normal = [];
    if (layer.shape === "points") {
      for (const at of layer.at) position.push(...point(layer, at));
      return { position, normal: position.map(() => 0) };
    }
    for (const path of paths(layer)) {
      const at = path.map((corner) => point(layer, corner));
      if (layer.shape === "areas" && space) {
        // A ring of a drawing in space is flat and convex.
        for (let i = 2; i < at.length; i += 1) {
          const [a, b, c] = [at[0], at[i - 1], at[i]];
          const [u, v] = [b, c].map((p) => p.map((x, axis) => x - a[axis]));
          const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
          const length = Math.hypot(...n) || 1;
          for (const p of [a, b, c]) { position.push(...p); normal.push(...n.map((x) => x / length)); }
        }
      } else {
        const closed = layer.shape === "areas" ? [...at, at[0]] : at;
        for (let i = 1; i < closed.length; i += 1) position.push(...closed[i - 1], ...closed[i]);
      }
    }
    return { position, normal: normal.length > 0 ? normal : position.map(() => 0) };
  };
  // The edges of areas in space, as lines.
  const edges = (layer) => corners({ ...layer, shape: "areas" }, false);

  return (drawing) => {
    const { Renderer, Camera, Transform, Program, Geometry, Mesh, Orbit, Vec3 } = OGL;
    const stage = make("div", { className: "view-stage" });
    const names = make("div", { className: "view-layers" });
    const root = make("div", { className: "view" }, [stage, names]);
    let renderer;
    try {
      renderer = new Renderer({ alpha: true, antialias: true, dpr: Math.min(2, devicePixelRatio || 1), preserveDrawingBuffer: true });
      if (!renderer.gl) throw new Error("no WebGL");
    } catch {
      stage.textContent = "This browser has no WebGL: the view in space is not there.";
      stage.classList.add("view-none");
      return root;
    }
    const gl = renderer.gl;
    const canvas = gl.canvas;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    const told = drawing.layers.filter(({ parts }) => parts > 0).map(({ name, parts }) => `${name} (${parts.toLocaleString("en")})`);
    canvas.setAttribute("aria-label", `${told.join(", ")}; arrow keys turn it, plus and minus zoom`);
    stage.append(canvas);
    const camera = new Camera(gl, { fov: 35, near: 0.001, far: 100 });
    const home = drawing.space ? [1.9, -3.3, 1.75] : [0, 0, 3.6];
    camera.up.set(0, drawing.space ? 0 : 1, drawing.space ? 1 : 0);
    const controls = new Orbit(camera, { element: canvas, enableRotate: drawing.space, inertia: 0, minDistance: 0.002, maxDistance: 50, ease: 1 });
    // The orbit turns around y, and what is up is z here: the scene is turned instead.
    const world = new Transform();
    if (drawing.space) world.rotation.x = -Math.PI / 2;
    let width = 0; let height = 0;
    const reset = () => {
      // All of it is in the picture, also in one that is higher than wide.
      const far = 1.15 / Math.min(1, width / Math.max(1, height));
      const [x, y, z] = home.map((along) => along * far);
      camera.up.set(0, 1, 0);
      controls.target.set(0, 0, 0);
      camera.position.set(...(drawing.space ? [x, z, -y] : [x, y, z]));
      camera.lookAt(new Vec3());
      controls.forcePosition();
    };

    const program = (role, shape, few, isEdge) => new Program(gl, {
      vertex: VERTEX,
      fragment: FRAGMENT,
      transparent: true,
      cullFace: false,
      uniforms: {
        colour: { value: COLOURS[role].map((x) => x / 255 * (isEdge ? 0.6 : 1)) },
        opacity: { value: shape === "areas" && role === "faint" ? 0.18 : 1 },
        lit: { value: shape === "areas" ? 1 : 0 },
        round: { value: shape === "points" ? 1 : 0 },
        size: { value: (few ? 8 : 3) * renderer.dpr },
        nearer: { value: shape === "areas" ? 0 : shape === "lines" ? 0.0004 : 0.0008 },
      },
      // What can be seen through hides nothing.
      depthWrite: role !== "faint",
    });
    const labels = [];
    for (const layer of drawing.layers) {
      const meshes = [];
      const add = (shape, { position, normal }, mode, isEdge = false) => {
        if (position.length === 0) return;
        const geometry = new Geometry(gl, {
          position: { size: 3, data: new Float32Array(position) },
          normal: { size: 3, data: new Float32Array(normal) },
        });
        const mesh = new Mesh(gl, { mode, geometry, program: program(layer.role, shape, layer.parts <= 500, isEdge), frustumCulled: false });
        mesh.setParent(world);
        meshes.push(mesh);
      };
      if (layer.shape === "areas" && drawing.space) {
        add("areas", corners(layer, true), gl.TRIANGLES);
        add("lines", edges(layer), gl.LINES, true);
      } else {
        add(layer.shape === "points" ? "points" : "lines", corners(layer, drawing.space), layer.shape === "points" ? gl.POINTS : gl.LINES);
      }
      const box = make("input", { type: "checkbox", checked: layer.shown });
      const own = layer.labels.map((text, part) => {
        const element = make("span", { className: "view-label", textContent: text });
        stage.append(element);
        const [first] = paths(layer)[part] ?? [];
        return { element, at: first === undefined ? [0, 0, 0] : point(layer, first), box };
      });
      labels.push(...own);
      box.onchange = () => { for (const mesh of meshes) mesh.visible = box.checked; };
      box.onchange();
      if (layer.parts === 0) continue;
      const sample = make("i", { className: "view-sample" });
      sample.style.background = `rgb(${COLOURS[layer.role].join(",")})`;
      names.append(make("label", {}, [box, sample, `${layer.name} (${layer.parts.toLocaleString("en")})`]));
    }
    const whole = make("button", { type: "button", textContent: "whole" });
    whole.onclick = reset;
    names.append(whole);

    // The wheel scrolls the page until somebody has chosen the view.
    stage.addEventListener("wheel", (event) => { if (document.activeElement !== canvas) event.stopPropagation(); }, { capture: true });
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    canvas.addEventListener("keydown", (event) => {
      const turn = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, 0.12], ArrowDown: [0, -0.12] }[event.key];
      const zoom = { "+": 0.85, "=": 0.85, "-": 1.18 }[event.key];
      if (!turn && !zoom) return;
      event.preventDefault();
      const from = controls.target;
      const offset = [0, 1, 2].map((axis) => camera.position[axis] - from[axis]);
      const length = Math.hypot(...offset) * (zoom ?? 1);
      const [dx, dy] = turn ?? [0, 0];
      const around = Math.atan2(offset[0], offset[2]) + (drawing.space ? dx : 0);
      const up = Math.max(-1.5, Math.min(1.5, Math.asin(offset[1] / (length / (zoom ?? 1))) + (drawing.space ? dy : 0)));
      camera.position.set(from[0] + length * Math.cos(up) * Math.sin(around), from[1] + length * Math.sin(up), from[2] + length * Math.cos(up) * Math.cos(around));
      camera.lookAt(from);
      controls.forcePosition();
    });

    const fit = () => {
      if (stage.clientWidth === width && stage.clientHeight === height) return;
      [width, height] = [stage.clientWidth, stage.clientHeight];
      renderer.setSize(width, height);
    };
    const at = new Vec3();
    const draw = () => {
      // A view that is not on the page any more ends, and gives back what it has of the graphics card.
      if (root.isConnected) {
        fit();
        if (!root.seen) reset();
        controls.update();
        // Depths are as fine as they can be where the eye is.
        const distance = camera.position.distance(controls.target);
        camera.perspective({ aspect: width / Math.max(1, height), near: distance / 10, far: distance + 5 });
        renderer.render({ scene: world, camera });
        for (const { element, at: place, box } of labels) {
          at.set(...place);
          at.applyMatrix4(world.worldMatrix);
          camera.project(at);
          element.hidden = !box.checked || at[2] > 1;
          element.style.transform = `translate(${((at[0] + 1) / 2 * width + 6).toFixed(1)}px, ${((1 - at[1]) / 2 * height - 18).toFixed(1)}px)`;
        }
        canvas.dataset.turned = camera.position.map((x) => x.toFixed(3)).join(" ");
        root.seen = true;
      } else if (root.seen) {
        controls.remove();
        gl.getExtension("WEBGL_lose_context")?.loseContext();
        return;
      }
      requestAnimationFrame(draw);
    };
    requestAnimationFrame(draw);
    return root;
  };
})();
