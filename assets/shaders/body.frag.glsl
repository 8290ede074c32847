#version 330 core
// Every texture is computed here from the place on the body (m), so it is sharp at any zoom.
in vec2 place;
flat in vec2 kind;
in float inside;
flat in float radius;
flat in vec4 more;
uniform float scale; // pixels per metre
uniform float time;  // s, for blinking
out vec4 colour;

const int RIGIBO = 0, STONE = 1, IRON = 2, ICE = 3, RUBBER = 4, WOOD = 5, BALL = 6, PARTICLE = 7;
const int PLAIN = 0, HOVERED = 1, ASLEEP = 2, GHOST = 3;

float hash(vec2 p) {
    return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453);
}

float noise(vec2 p) {
    vec2 i = floor(p);
    vec2 f = fract(p);
    vec2 u = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1, 0)), u.x),
               mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), u.x), u.y);
}

/** 1 inside a soft-edged disc of radius r (m) about c. */
float spot(vec2 p, vec2 c, float r) {
    return clamp((r - length(p - c)) * scale + 0.5, 0.0, 1.0);
}

/** 1 on a line between two points, w wide (m). */
float stroke(vec2 p, vec2 a, vec2 b, float w) {
    vec2 ab = b - a;
    float t = clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
    return clamp((w - length(p - a - t * ab)) * scale + 0.5, 0.0, 1.0);
}

vec3 face(vec3 base, int mood) {
    float s = min(min(more.z, more.w), 0.5);
    vec2 p = place / s;
    vec3 ink = vec3(0.16, 0.09, 0.08);
    float unit = 1.0 / s;
    float blink = fract(time * 0.23 + hash(more.zw)) < 0.03 ? 1.0 : 0.0;
    vec2 l = vec2(-0.36, 0.14);
    vec2 r = vec2(0.36, 0.14);
    vec3 c = base;
    if (mood == HOVERED) {
        float squint = max(max(stroke(place, s * (l + vec2(-0.17, 0.12)), s * (l + vec2(0.15, 0.0)), 0.045 * s),
                               stroke(place, s * (l + vec2(-0.17, -0.12)), s * (l + vec2(0.15, 0.0)), 0.045 * s)),
                           max(stroke(place, s * (r + vec2(0.17, 0.12)), s * (r + vec2(-0.15, 0.0)), 0.045 * s),
                               stroke(place, s * (r + vec2(0.17, -0.12)), s * (r + vec2(-0.15, 0.0)), 0.045 * s)));
        c = mix(c, ink, squint);
        return mix(c, ink, spot(place, s * vec2(0.0, -0.36), 0.13 * s));
    }
    if (mood == ASLEEP || blink > 0.5) {
        c = mix(c, ink, max(stroke(place, s * (l - vec2(0.16, 0)), s * (l + vec2(0.16, 0)), 0.04 * s),
                            stroke(place, s * (r - vec2(0.16, 0)), s * (r + vec2(0.16, 0)), 0.04 * s)));
    } else {
        vec2 look = 0.08 * more.xy;
        c = mix(c, vec3(1.0), max(spot(place, s * l, 0.2 * s), spot(place, s * r, 0.2 * s)));
        c = mix(c, ink, max(spot(place, s * (l + look), 0.1 * s), spot(place, s * (r + look), 0.1 * s)));
    }
    float smile = abs(length(p - vec2(0.0, -0.12)) - 0.3) * s;
    float lower = step(p.y, -0.24);
    return mix(c, ink, lower * clamp((0.04 * s - smile) * scale + 0.5, 0.0, 1.0));
}

vec3 skin(int id, int mood) {
    if (id == RIGIBO) {
        vec3 base = vec3(0.910, 0.627, 0.298) * (0.96 + 0.08 * noise(place * vec2(6.0, 22.0)));
        return face(base, mood);
    }
    if (id == STONE) {
        float grain = 0.6 * noise(place * 7.0) + 0.4 * noise(place * 23.0);
        return vec3(0.424, 0.455, 0.525) * (0.82 + 0.34 * grain);
    }
    if (id == IRON) {
        vec3 base = vec3(0.29, 0.33, 0.41) * (0.92 + 0.14 * noise(vec2(place.x * 3.0, place.y * 40.0)));
        vec2 corner = abs(place) - (more.zw - vec2(0.11));
        float rivet = radius > 0.0 ? spot(place, vec2(0.0), 0.25 * radius)
                                   : clamp((0.05 - length(corner)) * scale + 0.5, 0.0, 1.0);
        return mix(base, vec3(0.62, 0.66, 0.72), rivet);
    }
    if (id == ICE) {
        float crack = abs(noise(place * 2.3 + 3.0) - 0.5);
        vec3 base = mix(vec3(0.663, 0.867, 0.941), vec3(0.86, 0.96, 1.0), noise(place * 1.7));
        return mix(vec3(0.98), base, smoothstep(0.0, 0.025, crack));
    }
    if (id == RUBBER) {
        vec2 cell = fract(place * 5.0) - 0.5;
        float dot = clamp((0.24 - length(cell)) * scale / 5.0 + 0.5, 0.0, 1.0);
        return mix(vec3(0.769, 0.322, 0.478), vec3(0.60, 0.22, 0.36), dot);
    }
    if (id == WOOD) {
        vec2 along = more.z >= more.w ? place : place.yx;
        float ring = sin(26.0 * along.y + 5.0 * noise(vec2(along.x * 1.4, along.y * 5.0)));
        return mix(vec3(0.725, 0.471, 0.247), vec3(0.60, 0.37, 0.18), 0.5 + 0.5 * ring);
    }
    float stripe = clamp((abs(place.y) - 0.22 * radius) * scale + 0.5, 0.0, 1.0);
    vec3 band = place.x * place.y > 0.0 ? vec3(0.95, 0.41, 0.37) : vec3(0.25, 0.76, 0.66);
    float sector = step(0.62 * radius, abs(place.x) + 0.4 * abs(place.y));
    return mix(vec3(0.20, 0.24, 0.38), mix(vec3(0.957, 0.945, 0.902), band, sector), stripe);
}

void main() {
    int id = int(kind.x + 0.5);
    int mood = int(kind.y + 0.5);
    if (id == PARTICLE) {
        colour = more;
        return;
    }
    float depth = (radius > 0.0 ? radius - length(place) : inside) * scale;
    float cover = clamp(depth + 0.5, 0.0, 1.0);
    if (mood == GHOST) {
        colour = vec4(0.96, 0.95, 0.90, 0.7 * cover * clamp(2.5 - depth, 0.0, 1.0));
        return;
    }
    vec3 c = skin(id, mood);
    float rim = clamp(depth / 3.0, 0.0, 1.0);
    c *= 0.55 + 0.45 * rim;
    float light = smoothstep(2.0, 7.0, depth) * (1.0 - smoothstep(7.0, 14.0, depth));
    c += 0.05 * light;
    if (mood == ASLEEP) {
        c = mix(c, vec3(dot(c, vec3(0.3, 0.6, 0.1))) * vec3(0.82, 0.84, 1.0), 0.35);
    }
    if (mood == HOVERED) {
        c = c * 1.12 + 0.03;
    }
    colour = vec4(c, cover);
}
