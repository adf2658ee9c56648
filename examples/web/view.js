// SPDX-License-Identifier: AGPL-3.0-or-later
// Draws triangles with a value at each point: raw WebGL 2. Drag turns, the wheel comes nearer.

/** From low to high: the colours of cividis, which people see alike. */
export const COLOURS = [[0, 34, 78], [67, 79, 109], [124, 123, 120], [187, 175, 113], [254, 232, 56]];

const VERTEX = `#version 300 es
uniform mat3 turn; uniform vec2 shape; uniform float near;
in vec3 place; in float value;
out vec3 seen; out float level;
void main() {
  seen = turn * place;
  level = value;
  gl_Position = vec4(seen.xy * near * shape, -seen.z * 0.4, 1);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 colours[${COLOURS.length}];
in vec3 seen; in float level;
out vec4 colour;
void main() {
  float at = clamp(level, 0., 1.) * ${COLOURS.length - 1}.;
  int below = min(int(at), ${COLOURS.length - 2});
  vec3 base = level < 0. ? vec3(.62) : mix(colours[below], colours[below + 1], at - float(below));
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  colour = vec4(base * (.35 + .65 * abs(dot(normal, normalize(vec3(.3, .5, 1))))), 1);
}`;

function compile(gl) {
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  gl.useProgram(program);
  return program;
}

export class View {
  constructor(canvas) {
    this.canvas = canvas;
    this.gl = canvas.getContext("webgl2", { preserveDrawingBuffer: true });
    if (!this.gl) throw new Error("this browser has no WebGL 2");
    this.program = compile(this.gl);
    this.gl.enable(this.gl.DEPTH_TEST);
    this.gl.uniform3fv(this.at("colours"), COLOURS.flat().map((one) => one / 255));
    this.places = this.attribute("place", 3);
    this.values = this.attribute("value", 1);
    this.corners = this.gl.createBuffer();
    this.count = 0;
    [this.yaw, this.pitch, this.near] = [0.6, -0.9, 2.4];
    this.listen();
  }

  at(name) {
    return this.gl.getUniformLocation(this.program, name);
  }

  attribute(name, size) {
    const { gl } = this;
    const buffer = gl.createBuffer();
    const where = gl.getAttribLocation(this.program, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(where);
    gl.vertexAttribPointer(where, size, gl.FLOAT, false, 0, 0);
    return buffer;
  }

  fill(target, buffer, data) {
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, data, this.gl.STATIC_DRAW);
  }

  listen() {
    this.canvas.addEventListener("pointermove", (event) => {
      if (!event.buttons) return;
      this.yaw += event.movementX * 0.01;
      this.pitch += event.movementY * 0.01;
      this.draw();
    });
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.near *= Math.exp(-event.deltaY * 0.001);
      this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /** The mesh as the client has it, in the middle of the view; without values it is grey. */
  show(mesh) {
    const ends = [0, 1, 2].map((axis) => {
      const along = mesh.points.filter((_, i) => i % 3 === axis);
      return [along.reduce((a, b) => Math.min(a, b)), along.reduce((a, b) => Math.max(a, b))];
    });
    const size = Math.hypot(...ends.map(([low, high]) => high - low));
    const places = Float32Array.from(mesh.points, (x, i) => (x - (ends[i % 3][0] + ends[i % 3][1]) / 2) / size);
    this.fill(this.gl.ARRAY_BUFFER, this.places, places);
    this.fill(this.gl.ELEMENT_ARRAY_BUFFER, this.corners, mesh.triangles);
    this.count = mesh.triangles.length;
    this.colour(new Float32Array(places.length / 3).fill(-1), 1);
  }

  /** A value at each point, from 0 to `most`. */
  colour(values, most) {
    this.fill(this.gl.ARRAY_BUFFER, this.values, values.map((value) => value / most));
    this.draw();
  }

  draw() {
    const { gl, canvas } = this;
    [canvas.width, canvas.height] = [canvas.clientWidth, canvas.clientHeight].map((n) => Math.round(n * devicePixelRatio));
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const [c, s, d, t] = [Math.cos(this.yaw), Math.sin(this.yaw), Math.cos(this.pitch), Math.sin(this.pitch)];
    gl.uniformMatrix3fv(this.at("turn"), false, [c, s * d, s * t, -s, c * d, c * t, 0, -t, d]); // By columns.
    gl.uniform2f(this.at("shape"), Math.min(1, canvas.height / canvas.width), Math.min(1, canvas.width / canvas.height));
    gl.uniform1f(this.at("near"), this.near);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
  }
}
