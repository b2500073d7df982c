// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The mean with its modes, in WebGL; the page works without it.
(() => {
  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer;
  const mean = new Float32Array(bytes(data.mean)), modes = new Float32Array(bytes(data.displacements));
  const triangles = new Uint32Array(bytes(data.triangles)), colors = new Uint8Array(bytes(data.colors));
  const canvas = document.getElementById("view"), gl = canvas.getContext("webgl2");
  if (!gl) return canvas.replaceWith("This browser has no WebGL 2.");
  const shader = (kind, text) => {
    const made = gl.createShader(kind);
    gl.shaderSource(made, text);
    gl.compileShader(made);
    return made;
  };
  const program = gl.createProgram();
  gl.attachShader(program, shader(gl.VERTEX_SHADER, `#version 300 es
    in vec3 position, normal, color; uniform mat3 turn; uniform vec2 scale; out vec3 n, c;
    void main() { n = turn * normal; c = color; vec3 p = turn * position;
      gl_Position = vec4(p.xy * scale, -p.z * .4, 1); }`));
  gl.attachShader(program, shader(gl.FRAGMENT_SHADER, `#version 300 es
    precision highp float; in vec3 n, c; out vec4 o;
    void main() { float light = .35 + .65 * abs(normalize(n).z); o = vec4(c * light, 1); }`));
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.enable(gl.DEPTH_TEST);
  const attribute = (name, kind, normalized) => {
    const buffer = gl.createBuffer(), place = gl.getAttribLocation(program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, 3, kind, normalized, 0, 0);
    return buffer;
  };
  const fill = (buffer, values) => {
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  };
  const positionBuffer = attribute("position", gl.FLOAT, false), normalBuffer = attribute("normal", gl.FLOAT, false);
  fill(attribute("color", gl.UNSIGNED_BYTE, true), colors);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);

  const sliders = [...document.querySelectorAll("input[data-mode]")];
  const position = new Float32Array(mean.length), normal = new Float32Array(mean.length);
  const shape = () => {
    position.set(mean);
    sliders.forEach((slider, k) => {
      const s = +slider.value, start = k * mean.length;
      slider.nextElementSibling.value = s.toFixed(1);
      if (s) for (let i = 0; i < mean.length; i++) position[i] += s * modes[start + i];
    });
    normal.fill(0);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
      const u = [0, 1, 2].map((d) => position[b + d] - position[a + d]);
      const v = [0, 1, 2].map((d) => position[c + d] - position[a + d]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      for (const corner of [a, b, c]) for (let d = 0; d < 3; d++) normal[corner + d] += n[d];
    }
    fill(positionBuffer, position);
    fill(normalBuffer, normal);
    draw();
  };
  let yaw = 0.4, pitch = 0.25, zoom = 0.9;
  const draw = () => {
    const [w, h] = [canvas.clientWidth * devicePixelRatio, canvas.clientHeight * devicePixelRatio];
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
    gl.uniformMatrix3fv(gl.getUniformLocation(program, "turn"), false, [cy, sp * sy, -cp * sy, 0, cp, sp, sy, -sp * cy, cp * cy]);
    const least = Math.min(w, 1.6 * h) * zoom;
    gl.uniform2f(gl.getUniformLocation(program, "scale"), least / w, least / h);
    gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_INT, 0);
    canvas.dataset.drawn = "yes";
  };
  canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener("pointermove", (event) => {
    if (!event.buttons) return;
    yaw += event.movementX / 150;
    pitch = Math.max(-1.6, Math.min(1.6, pitch + event.movementY / 150));
    draw();
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom *= Math.exp(-event.deltaY / 800);
    draw();
  }, {passive: false});
  sliders.forEach((slider) => slider.addEventListener("input", shape));
  document.querySelector(".model form").addEventListener("reset", () => setTimeout(shape));
  addEventListener("resize", draw);
  shape();
})();
