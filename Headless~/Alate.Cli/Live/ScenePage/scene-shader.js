import { BAKED, COLOURS, CUT, SHADOWLESS, SKINNED, TRANSLUCENT, TWO_SIDED } from './scene-format.js';

// The light of the package's own shader, Alate/Wing, for WebGL: light from sky, equator and ground, a sun with shadows, lamps, light that
// passes wings, and gleams. Places stay in Unity's axes; only the picture turns Z round.
export const LAMPS = 8;

const VERTEX = `
attribute vec4 colour, joints, rowX, rowY, rowZ, tint, extra, next;
attribute vec2 baked;
uniform sampler2D map;
varying vec3 place, turned;
varying vec2 where;
varying vec4 painted;

#ifdef BAKED
vec3 texel(vec2 first, float row) {
  ivec2 size = textureSize(map, 0);
  return texelFetch(map, clamp(ivec2(floor(first * vec2(size) + vec2(0.0, row))), ivec2(0), size - 1), 0).xyz;
}
vec3 loopAt(vec2 first, vec3 rows) { return mix(texel(first, rows.x), texel(first, rows.y), rows.z); }
vec3 blended(vec2 first) {
  vec3 value = loopAt(first, extra.xyz);
  return extra.w > 0.0 ? mix(value, loopAt(first, next.xyz), extra.w) : value;
}
#endif
#ifdef SKINNED
vec4 part(int index) {
  int width = textureSize(map, 0).x;
  return texelFetch(map, ivec2(index % width, index / width), 0);
}
void add(int joint, float weight, vec4 pivot, inout vec4 real, inout vec4 dual) {
  vec4 turn = part(joint);
  float share = dot(turn, pivot) < 0.0 ? -weight : weight;
  real += share * turn;
  dual += share * part(joint + 1);
}
#endif

void main() {
  vec3 at = position, up = normal;
#ifdef BAKED
  at = blended(baked);
  up = normalize(blended(baked + vec2(0.0, 0.5)));
#endif
#ifdef SKINNED
  if (joints.x >= 0.0) {
    int joint = 2 * int(extra.x) + 2 * int(joints.x), across = 2 * int(joints.y);
    vec4 pivot = part(joint), real = vec4(0.0), dual = vec4(0.0);
    add(joint, (1.0 - joints.z) * (1.0 - joints.w), pivot, real, dual);
    add(joint + 2, (1.0 - joints.z) * joints.w, pivot, real, dual);
    add(joint + across, joints.z * (1.0 - joints.w), pivot, real, dual);
    add(joint + across + 2, joints.z * joints.w, pivot, real, dual);
    vec3 q = real.xyz, e = dual.xyz;
    float scale = 2.0 / dot(real, real);
    at += scale * (cross(q, cross(q, at) + real.w * at + e) + real.w * e - dual.w * q);
    up += scale * cross(q, cross(q, up) + real.w * up);
  }
#endif
  vec4 from = vec4(at, 1.0);
  place = vec3(dot(rowX, from), dot(rowY, from), dot(rowZ, from));
  turned = inverse(mat3(rowX.xyz, rowY.xyz, rowZ.xyz)) * up;
  where = uv;
  painted = tint;
#ifdef COLOURS
  painted *= colour;
#endif
  gl_Position = projectionMatrix * viewMatrix * vec4(place.xy, -place.z, 1.0);
}`;

const FRAGMENT = `
#include <common>
uniform sampler2D picture, shadow;
uniform vec3 eye, sky, equator, ground, sunFrom, sun, lampLights[${LAMPS}];
uniform vec4 lamps[${LAMPS}];
uniform mat4 toShadow;
uniform vec4 underside;
uniform float through, gloss, shine, shadowCell;
varying vec3 place, turned;
varying vec2 where;
varying vec4 painted;

vec3 ambient(vec3 normal) { return normal.y > 0.0 ? mix(equator, sky, normal.y) : mix(equator, ground, -normal.y); }

vec3 answer(vec3 colour, vec3 normal, vec3 toEye, vec3 toLight) {
  float facing = dot(normal, toLight), between = saturate(dot(normal, normalize(toLight + toEye)));
  return colour * saturate(facing) + colour * (0.35 + 0.65 * colour) * (through * saturate(-facing)) + gloss * pow(between, shine) * saturate(8.0 * facing);
}

float sunShare() {
  if (shadowCell <= 0.0)
    return 1.0;
  vec3 at = (toShadow * vec4(place, 1.0)).xyz * 0.5 + 0.5;
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0))))
    return 1.0;
  float lit = 0.0, cell = 1.0 / float(textureSize(shadow, 0).x);
  for (int y = -1; y <= 1; y++)
    for (int x = -1; x <= 1; x++)
      lit += texture2D(shadow, at.xy + cell * vec2(x, y)).r + shadowCell >= at.z ? 1.0 : 0.0;
  return lit / 9.0;
}

void main() {
  vec4 colour = painted;
#ifdef PICTURE
  colour *= texture2D(picture, where);
#endif
#ifdef CUT
  colour.a = saturate((colour.a - 0.5) / max(fwidth(colour.a), 1e-4) + 0.5);
  if (colour.a < 0.02)
    discard;
#endif
  vec3 normal = normalize(turned), toEye = normalize(eye - place);
#ifdef TWO_SIDED
  if (dot(normal, toEye) < 0.0) {
    normal = -normal;
    colour.rgb = mix(colour.rgb, underside.rgb, underside.a * saturate(max(colour.r, max(colour.g, colour.b))));
  }
#endif
  vec3 sum = colour.rgb * mix(ambient(normal), ambient(-normal), 0.5 * through);
  sum += sunShare() * sun * answer(colour.rgb, normal, toEye, sunFrom);
  for (int k = 0; k < ${LAMPS}; k++) {
    vec3 way = lamps[k].xyz - place;
    float square = max(dot(way, way), 1e-3), share = square / max(lamps[k].w * lamps[k].w, 1e-6);
    if (share < 1.0)
      sum += (1.0 - share * share) * (1.0 - share * share) / square * lampLights[k] * answer(colour.rgb, normal, toEye, normalize(way));
  }
  gl_FragColor = vec4(sum, colour.a);
#if !defined(TRANSLUCENT) && !defined(CUT)
  gl_FragColor.a = 1.0;
#endif
  #include <colorspace_fragment>
}`;

const SHADE = `
uniform sampler2D picture;
varying vec2 where;
void main() {
#if defined(CUT) && defined(PICTURE)
  if (texture2D(picture, where).a < 0.5)
    discard;
#endif
  gl_FragColor = vec4(1.0);
}`;

// The material of what is drawn, and the one for its shadow. Corners of what faces the eye run clockwise, as in Unity.
export function materials(THREE, draw, picture, map, shared) {
  const defines = {}, own = { map: { value: map }, picture: { value: picture }, through: { value: draw.through }, gloss: { value: draw.gloss }, shine: { value: draw.shine }, underside: { value: draw.underside } };
  for (const [name, flag] of Object.entries({ SKINNED, BAKED, COLOURS, TWO_SIDED, TRANSLUCENT, CUT })) {
    if (draw.flags & flag)
      defines[name] = '';
  }
  if (picture)
    defines.PICTURE = '';
  const isClear = (draw.flags & TRANSLUCENT) > 0;
  return {
    shown: new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader: FRAGMENT, defines, uniforms: { ...shared, ...own }, side: draw.flags & TWO_SIDED ? THREE.DoubleSide : THREE.BackSide, transparent: isClear, depthWrite: !isClear, alphaToCoverage: (draw.flags & CUT) > 0 }),
    shadow: new THREE.ShaderMaterial({ vertexShader: VERTEX, fragmentShader: SHADE, defines, uniforms: own, side: THREE.DoubleSide, visible: !(draw.flags & SHADOWLESS) }),
  };
}
