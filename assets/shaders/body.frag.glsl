#version 330 core
// A skin looked up, a bevel that the lamp lights, a dark rim; discs are domes. No branches: software
// OpenGL takes them all.
in vec3 sheet;
in vec2 out_way;
flat in vec2 out_reach;
flat in vec2 out_light;
flat in float corner;
flat in float mood;
uniform sampler2DArray skins;
uniform float ratio; // framebuffer pixels per logical one
uniform float veil;  // 0 to 1: how far all colour is gone
out vec4 colour;     // times its cover

const float HOVERED = 1.0, ASLEEP = 2.0, GHOST = 3.0;
const float FLAT = -1.0; // and below it a dome
const vec3 LUMINANCE = vec3(0.3, 0.6, 0.1);

void main() {
    float away = length(out_way);
    vec2 q = abs(out_way) - out_reach + corner;
    vec2 beyond = max(q, 0.0);
    bool is_round = out_reach.y < 0.0;
    float depth = is_round ? out_reach.x - away : corner - length(beyond) - min(max(q.x, q.y), 0.0);
    float cover = clamp(depth * ratio + 0.5, 0.0, 1.0);
    vec2 side = q.x > q.y ? vec2(sign(out_way.x), 0.0) : vec2(0.0, sign(out_way.y));
    vec2 normal = is_round ? out_way / max(away, 1e-3) : side;

    vec3 c = texture(skins, sheet).rgb;
    float bevel = clamp(1.0 - depth / 5.0, 0.0, 1.0);
    float lit = dot(normal, out_light);
    c *= 1.0 + 0.34 * lit * bevel;
    c *= 0.55 + 0.45 * clamp(depth / 1.8, 0.0, 1.0);
    // A dome: shade away from the lamp, and a glint towards it.
    float dome = out_reach.y < FLAT ? 1.0 : 0.0;
    vec2 on = out_way / out_reach.x;
    float out_ = dot(on, on);
    vec2 glint = on - 0.48 * out_light;
    float gleam = clamp(1.0 - 9.0 * dot(glint, glint), 0.0, 1.0);
    c *= 1.0 + dome * (0.28 * dot(on, out_light) - 0.26 * out_ * out_);
    c += dome * 0.30 * gleam * gleam;

    float grey = dot(c, LUMINANCE);
    vec3 dim = mix(c, grey * vec3(0.82, 0.84, 1.0), 0.35);
    c = mood == ASLEEP ? dim : c;
    c = mood == HOVERED ? c * 1.10 + 0.04 : c;
    c = mix(c, grey * vec3(0.60, 0.62, 0.72), 0.85 * veil);
    float line = 0.7 * cover * clamp(2.5 - depth, 0.0, 1.0);
    colour = mood == GHOST ? vec4(0.96, 0.95, 0.90, 1.0) * line : vec4(c, 1.0) * cover;
}
