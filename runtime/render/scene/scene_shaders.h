// The shaders of the lit scene. Lighting is computed in light (linear) and stored as
// sRGB.
//
//   light leaving = albedo (key max(n.l, 0) lit + ambient(n.y)) + highlight + rim
//   ambient(n.y) = ground + (sky - ground)(1 + n.y)/2
//   lit = mean of 4 (things) or 9 (floor) comparisons of the shadow map, each over 2 x 2 texels
//   stored = sRGB(light), within 0.004 of it
//
// Source: J. Blinn, Models of Light Reflection for Computer Synthesized Pictures, SIGGRAPH 1977
// (half vector); W. Reeves, D. Salesin, R. Cook, Rendering Antialiased Shadows with Depth Maps,
// SIGGRAPH 1987 (percentage-closer filtering).
#pragma once

namespace fulcrum::runtime::shaders {

inline constexpr const char* kObjectVertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_uv;
uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_model;
uniform mat3 u_normal_from_model;
uniform mat4 u_shadow_from_world;
uniform float u_shadow_offset_m;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
out vec3 v_shadow;
#ifdef LOOKS
uniform vec3 u_stretch;
out vec3 v_place;
#endif
void main() {
#ifdef LOOKS
  v_place = u_stretch * a_position;
#endif
  vec4 world = u_world_from_model * vec4(a_position, 1.0);
  vec3 normal = u_normal_from_model * a_normal;
  v_position = world.xyz;
  v_normal = normal;
  v_uv = a_uv;
  float stretch = length(normal);
  vec3 outwards = stretch > 0.0 ? normal / stretch : vec3(0.0);
  v_shadow = (u_shadow_from_world * vec4(world.xyz + u_shadow_offset_m * outwards, 1.0)).xyz;
  gl_Position = u_clip_from_world * world;
}
)";

/// Shared by everything that is lit.
inline constexpr const char* kLighting = R"(
uniform sampler2DShadow u_shadow_map;
uniform float u_shadow_texel;
uniform vec3 u_to_light;   // for shading
uniform vec3 u_to_lamp;    // for shadows
uniform vec3 u_eye;
const vec3 kKey = vec3(1.0, 0.94, 0.84) * 0.78;
const vec3 kSky = vec3(0.50, 0.53, 0.58);
const vec3 kBounce = vec3(0.33, 0.28, 0.23);
float lit_part(vec3 at) {
#ifdef NO_SHADOWS
  return 1.0;
#else
  float sum = 0.0;
  for (int y = 0; y < TAPS; ++y) {
    for (int x = 0; x < TAPS; ++x) {
      vec2 off = SPREAD * u_shadow_texel * (vec2(x, y) - 0.5 * float(TAPS - 1));
      sum += texture(u_shadow_map, vec3(at.xy + off, at.z));
    }
  }
  return sum / float(TAPS * TAPS);
#endif
}
vec3 to_screen(vec3 light) {
  // A soft shoulder keeps bright colours from being cut off; then sRGB.
  vec3 over = max(light - 0.8, 0.0);
  vec3 kept = min(light, 0.8) + 0.2 * (over / (over + 0.2));
  vec3 root2 = sqrt(kept);
  vec3 root4 = sqrt(root2);
  vec3 root8 = sqrt(root4);
  return 0.581339 * root2 + 0.791891 * root4 - 0.372792 * root8;
}
)";

inline constexpr const char* kObjectFragment = R"(
uniform vec4 u_base_colour;
uniform sampler2D u_picture;
uniform float u_roughness;
uniform vec3 u_centre;
uniform vec3 u_horizon;
uniform float u_fade_m;
#ifdef NO_SHADOWS
uniform vec3 u_meadow;  // as stored
uniform float u_foot_m;
#endif
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
in vec3 v_shadow;
out vec4 o_colour;
void main() {
  vec3 to_eye = normalize(u_eye - v_position);
  vec3 n = normalize(v_normal);
  n = dot(n, to_eye) < 0.0 && !gl_FrontFacing ? -n : n;
#ifdef LOOKS
  vec4 look = look_of(v_place);
  vec3 albedo = u_base_colour.rgb * look.rgb;
  float roughness = look.a;
#else
  vec3 albedo = u_base_colour.rgb * texture(u_picture, v_uv).rgb;
  float roughness = u_roughness;
#endif
  float facing = dot(n, u_to_light);
  float lit = lit_part(v_shadow);
  float wrapped = max((facing + 0.25) / 1.25, 0.0);
  // Where a surface turns away from the lamp, its own shading is its shadow.
  float sun = wrapped * mix(1.0, lit, smoothstep(0.0, 0.35, dot(n, u_to_lamp)));
  vec3 light = albedo * (kKey * sun + mix(kBounce, kSky, 0.5 + 0.5 * n.y));
  vec3 half_way = normalize(to_eye + u_to_light);
  float a = max(roughness * roughness, 0.02);
  float power = 2.0 / (a * a) - 2.0 + 4.0;
  float gloss = 0.04 * (power + 8.0) / 8.0 * pow(max(dot(n, half_way), 0.0), power);
  float edge = 1.0 - max(dot(n, to_eye), 0.0);
  edge *= edge;
  edge *= edge;
  light += kKey * min(gloss, 1.2) * max(facing, 0.0);
  light += (0.22 - 0.12 * roughness) * edge * (0.6 + 0.4 * n.y) * vec3(0.85, 0.95, 1.0);
  vec3 colour = to_screen(light);
#ifdef NO_SHADOWS
  // What is sunk in the floor grows out of it without an edge.
  if (u_foot_m > 0.0)
    colour = mix(u_meadow, colour, smoothstep(0.0, u_foot_m, v_position.y - u_centre.y));
#endif
  // Far things fade like the floor that they stand on.
  float away = length(v_position.xz - u_centre.xz);
  float haze = smoothstep(0.10 * u_fade_m, u_fade_m, away);
  o_colour = vec4(mix(colour, u_horizon, haze), 1.0);
}
)";

/// The floor, without shadows: they are laid over it.
inline constexpr const char* kGroundVertex = R"(
layout(location = 0) in vec2 a_position;
uniform mat4 u_clip_from_world;
uniform vec3 u_centre;
uniform float u_reach_m;
out vec2 v_from_centre;
void main() {
  v_from_centre = u_reach_m * a_position;
  vec3 world = u_centre + vec3(v_from_centre.x, 0.0, v_from_centre.y);
  gl_Position = u_clip_from_world * vec4(world, 1.0);
}
)";

inline constexpr const char* kGroundFragment = R"(
uniform vec3 u_floor;  // as stored, like the next three
uniform vec3 u_rug;
uniform vec3 u_rug_ring;
uniform vec3 u_horizon;
uniform float u_rug_m;
uniform vec2 u_sun;  // where its light comes from, along the floor
uniform float u_fade_m;
in vec2 v_from_centre;
out vec4 o_colour;
void main() {
  float r = length(v_from_centre);
  // A meadow has patches, and is lighter on the side of the sun.
  vec2 place = v_from_centre / u_rug_m;
  float patches = sin(2.1 * place.x + 1.3 * place.y) * sin(1.7 * place.y - 0.8 * place.x + 1.0);
  float sunny = clamp(dot(place, u_sun), -1.0, 1.0);
  vec3 floor_here = u_floor + vec3(0.020, 0.016, 0.008) * patches + vec3(0.030, 0.018, 0.0) * sunny;
#ifdef NEAR
  float soft = fwidth(r);
  float on_rug = 1.0 - smoothstep(u_rug_m - soft, u_rug_m + soft, r);
  float from_ring = abs(r - 0.91 * u_rug_m) - 0.03 * u_rug_m;
  float on_ring = 1.0 - smoothstep(-soft, soft, from_ring);
  vec3 colour = mix(mix(floor_here, u_rug, on_rug), u_rug_ring, on_ring);
#else
  vec3 colour = floor_here;
#endif
  o_colour = vec4(mix(colour, u_horizon, smoothstep(0.10 * u_fade_m, u_fade_m, r)), 1.0);
}
)";

/// Shadows on the floor: what is there is multiplied.
inline constexpr const char* kFloorShadowVertex = R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_clip_from_world;
uniform mat4 u_shadow_from_world;
out vec3 v_shadow;
void main() {
  v_shadow = (u_shadow_from_world * vec4(a_position, 1.0)).xyz;
  gl_Position = u_clip_from_world * vec4(a_position, 1.0);
}
)";
inline constexpr const char* kFloorShadowFragment = R"(
uniform vec3 u_in_shadow;
in vec3 v_shadow;
out vec4 o_colour;
void main() { o_colour = vec4(mix(u_in_shadow, vec3(1.0), lit_part(v_shadow)), 1.0); }
)";

/// The wall, clouds and hills: colours are given at the corners, with how much they cover, which without it is all.
inline constexpr const char* kSkyVertex = R"(
layout(location = 0) in vec2 a_position;
layout(location = 1) in vec4 a_colour;
out vec4 v_colour;
void main() {
  v_colour = a_colour;
  gl_Position = vec4(a_position, 1.0, 1.0);
}
)";
/// Grass and flowers fade like the floor that they stand on.
inline constexpr const char* kMeadowVertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_colour;
uniform mat4 u_clip_from_world;
uniform vec3 u_centre;
uniform vec3 u_horizon;
uniform float u_reach_m;
uniform float u_fade_m;
out vec4 v_colour;
void main() {
  vec3 from_centre = u_reach_m * a_position;
  float haze = smoothstep(0.10 * u_fade_m, u_fade_m, length(from_centre.xz));
  v_colour = vec4(mix(a_colour, u_horizon, haze), 1.0);
  gl_Position = u_clip_from_world * vec4(u_centre + from_centre, 1.0);
}
)";
inline constexpr const char* kSkyFragment = R"(
in vec4 v_colour;
out vec4 o_colour;
void main() { o_colour = v_colour; }
)";

/// Marks on the floor under things: a soft dark disc and a ring.
inline constexpr const char* kMarkVertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec2 a_place;
layout(location = 2) in vec3 a_look;
uniform mat4 u_clip_from_world;
out vec2 v_place;
out vec3 v_look;
void main() {
  v_place = a_place;
  v_look = a_look;
  gl_Position = u_clip_from_world * vec4(a_position, 1.0);
}
)";
inline constexpr const char* kMarkFragment = R"(
in vec2 v_place;
in vec3 v_look;  // disc strength, disc softness, ring strength
out vec4 o_colour;
void main() {
  float r = length(v_place);
  float w = fwidth(r);
  float disc = v_look.x * (1.0 - smoothstep(1.0 - v_look.y, 1.0 + 0.3 * v_look.y, r));
  float line = 1.0 - smoothstep(0.045, 0.045 + w, abs(r - 1.0));
  float ring = v_look.z * line;
#ifdef DASHES
  ring *= step(0.5, fract(DASHES * atan(v_place.y, v_place.x) / 6.2831853));
#endif
  o_colour = vec4(0.16, 0.20, 0.26, max(disc, ring));
}
)";

/// A shape grown along its normals by u_width pixels, in one colour: outlines.
inline constexpr const char* kOutlineVertex = R"(
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_model;
uniform mat3 u_normal_from_model;
uniform vec2 u_pixel;
uniform float u_width_px;
void main() {
  vec4 clip = u_clip_from_world * (u_world_from_model * vec4(a_position, 1.0));
  vec4 ahead = u_clip_from_world * vec4(u_normal_from_model * a_normal, 0.0);
  vec2 way = (ahead.xy * clip.w - clip.xy * ahead.w) / u_pixel;
  float size = length(way);
  clip.xy += size > 0.0 ? way / size * u_pixel * u_width_px * clip.w : vec2(0.0);
  gl_Position = clip;
}
)";
inline constexpr const char* kFlatFragment = R"(
uniform vec4 u_flat;
out vec4 o_colour;
void main() { o_colour = u_flat; }
)";

/// The ghost: bright at its rim, nearly clear in its middle.
inline constexpr const char* kGhostFragment = R"(
uniform vec4 u_flat;
uniform vec3 u_eye;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
in vec3 v_shadow;
out vec4 o_colour;
void main() {
  vec3 to_eye = normalize(u_eye - v_position);
  float facing = abs(dot(normalize(v_normal), to_eye));
  float alpha = u_flat.a * mix(0.9, 0.30, facing);
  o_colour = vec4(u_flat.rgb, alpha);
}
)";

/// Depth as the light sees it.
inline constexpr const char* kShadowVertex = R"(
layout(location = 0) in vec3 a_position;
uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_model;
void main() { gl_Position = u_clip_from_world * (u_world_from_model * vec4(a_position, 1.0)); }
)";
inline constexpr const char* kShadowFragment = R"(
void main() {}
)";

}  // namespace fulcrum::runtime::shaders
