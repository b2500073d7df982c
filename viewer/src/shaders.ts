// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
import { errorStops, levelStops, missingColor, plainColor, toRgb } from "./palette";

const vec3 = (hex: string) => `vec3(${toRgb(hex).map((c) => c.toFixed(5)).join(", ")})`;
const array = (stops: string[]) => `vec3[5](${stops.map(vec3).join(", ")})`;

const morphed = /* glsl */ `
  in vec3 goal;
  in vec3 goalNormal;
  uniform float morph;
  vec4 clipPosition() { return projectionMatrix * modelViewMatrix * vec4(mix(position, goal, morph), 1.0); }
`;

const lighting = /* glsl */ `
  vec4 lit(vec3 base, vec3 normal) {
    vec3 n = normalize(normal);
    if (!gl_FrontFacing) n = -n;
    float key = max(dot(n, normalize(vec3(0.35, 0.55, 0.75))), 0.0);
    float rim = 0.5 + 0.5 * n.y;
    float light = 0.38 + 0.16 * rim + 0.52 * key;
    vec3 color = min(base * light + 0.05 * pow(key, 24.0), 1.0);
    return vec4(gl_FrontFacing ? color : 0.7 * color, 1.0);
  }
`;

export const surfaceVertexShader = /* glsl */ `
  ${morphed}
  in vec4 field;
  out vec3 vNormal;
  out vec4 vField;
  void main() {
    vNormal = normalMatrix * mix(normal, goalNormal, morph);
    vField = field;
    gl_Position = clipPosition();
  }
`;

export const surfaceFragmentShader = /* glsl */ `
  precision highp float;
  in vec3 vNormal;
  in vec4 vField;
  out vec4 color;
  uniform int mode; // index into modes.ts
  uniform float top; // value at the end of the scale
  uniform float bandWidth;
  uniform vec3 cells; // of the checker, along each axis

  const vec3 errors[5] = ${array(errorStops)};
  const vec3 levels[5] = ${array(levelStops)};

  vec3 along(vec3 stops[5], float t) {
    float s = clamp(t, 0.0, 1.0) * 4.0;
    int i = min(int(s), 3);
    return mix(stops[i], stops[i + 1], s - float(i));
  }

  ${lighting}

  // 0 or 1 by the parity of the cell, smooth over a pixel.
  float parity(vec3 p) {
    vec3 width = max(fwidth(p), vec3(1e-5));
    vec3 wave = abs(fract(p * 0.5) * 2.0 - 1.0) - 0.5;
    vec3 side = clamp(wave / width, -0.5, 0.5);
    return 0.5 - 4.0 * side.x * side.y * side.z;
  }

  void main() {
    vec3 base = ${vec3(plainColor)};
    vec3 value = vField.xyz;
    if (mode < 5) {
      bool known = vField.w > 0.999;
      if (!known) base = ${vec3(missingColor)};
      else if (mode == 0) base = vec3(0.12) + 0.83 * value;
      else if (mode == 1) base = mix(0.25, 1.0, parity(value * cells)) * (vec3(0.3) + 0.7 * value);
      else if (mode == 2) base = along(errors, value.x / top);
      else if (mode == 3) base = along(levels, value.x);
      else {
        float band = value.x / bandWidth;
        float edge = abs(fract(band + 0.5) - 0.5) / max(fwidth(band), 1e-5);
        base = along(levels, value.x / top) * (mod(floor(band), 2.0) < 0.5 ? 1.0 : 0.78);
        base = mix(base * 0.35, base, clamp(edge, 0.0, 1.0));
      }
    }
    color = lit(base, vNormal);
  }
`;

export const appearanceVertexShader = /* glsl */ `
  ${morphed}
  in vec3 tint;
  out vec3 vNormal;
  out vec2 vUv;
  out vec3 vTint;
  void main() {
    vNormal = normalMatrix * mix(normal, goalNormal, morph);
    vUv = uv;
    vTint = tint;
    gl_Position = clipPosition();
  }
`;

export const appearanceFragmentShader = /* glsl */ `
  precision highp float;
  in vec3 vNormal;
  in vec2 vUv;
  in vec3 vTint;
  out vec4 color;
  uniform sampler2D image;

  ${lighting}

  void main() {
    vec3 base = ${vec3(plainColor)};
    #ifdef TINTED
      base = vTint;
    #endif
    #ifdef TEXTURED
      vec3 texel = texture(image, vUv).rgb;
      #ifdef TINTED
        texel *= vTint;
      #endif
      base = texel;
    #endif
    color = lit(base, vNormal);
  }
`;

// The number of a corner of the triangle under each pixel, plus one, in four bytes.
export const pickVertexShader = /* glsl */ `
  ${morphed}
  flat out uint id;
  void main() {
    id = uint(gl_VertexID) + 1u;
    gl_Position = clipPosition();
  }
`;

export const pickFragmentShader = /* glsl */ `
  precision highp float;
  flat in uint id;
  out vec4 color;
  void main() {
    color = vec4(id & 255u, (id >> 8) & 255u, (id >> 16) & 255u, id >> 24) / 255.0;
  }
`;
