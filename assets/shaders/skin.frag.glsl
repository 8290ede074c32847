#version 330 core
// The sheets that bodies are cut from: 4 m by 4 m that fit to themselves on all sides. What looks
// like chance repeats after a whole number of its own cells.
in vec2 place; // 0 to 1
uniform int layer;
out vec4 colour;

const int RIGIBO = 0, STONE = 1, IRON = 2, ICE = 3, RUBBER = 4, WOOD = 5;

float hash(vec2 p) {
    return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453);
}

/** Smooth chance of so many cells along the sheet's sides. */
float noise(vec2 cells) {
    vec2 p = place * cells;
    vec2 i = floor(p);
    vec2 f = p - i;
    vec2 u = f * f * (3.0 - 2.0 * f);
    vec2 j = mod(i + 1.0, cells);
    return mix(mix(hash(i), hash(vec2(j.x, i.y)), u.x), mix(hash(vec2(i.x, j.y)), hash(j), u.x), u.y);
}

vec3 ball() {
    vec2 p = 2.0 * place - 1.0;
    float stripe = clamp((abs(p.y) - 0.22) * 128.0 + 0.5, 0.0, 1.0);
    vec3 band = p.x * p.y > 0.0 ? vec3(0.95, 0.41, 0.37) : vec3(0.25, 0.76, 0.66);
    float sector = clamp((abs(p.x) + 0.4 * abs(p.y) - 0.62) * 128.0 + 0.5, 0.0, 1.0);
    return mix(vec3(0.20, 0.24, 0.38), mix(vec3(0.957, 0.945, 0.902), band, sector), stripe);
}

vec3 skin() {
    if (layer == RIGIBO) {
        return vec3(0.910, 0.627, 0.298) * (0.96 + 0.08 * noise(vec2(24.0, 88.0)));
    }
    if (layer == STONE) {
        float grain = 0.6 * noise(vec2(28.0)) + 0.4 * noise(vec2(92.0));
        return vec3(0.424, 0.455, 0.525) * (0.82 + 0.34 * grain);
    }
    if (layer == IRON) {
        return vec3(0.29, 0.33, 0.41) * (0.92 + 0.14 * noise(vec2(12.0, 160.0)));
    }
    if (layer == ICE) {
        float crack = abs(noise(vec2(9.0)) - 0.5);
        vec3 base = mix(vec3(0.663, 0.867, 0.941), vec3(0.86, 0.96, 1.0), noise(vec2(7.0)));
        return mix(vec3(0.98), base, smoothstep(0.0, 0.025, crack));
    }
    if (layer == RUBBER) {
        vec2 cell = fract(place * 20.0) - 0.5;
        float dot = clamp((0.24 - length(cell)) * 25.6 + 0.5, 0.0, 1.0);
        return mix(vec3(0.769, 0.322, 0.478), vec3(0.60, 0.22, 0.36), dot);
    }
    if (layer == WOOD) {
        float ring = sin(2.0 * 3.14159265 * 17.0 * place.y + 5.0 * noise(vec2(6.0, 20.0)));
        return mix(vec3(0.725, 0.471, 0.247), vec3(0.60, 0.37, 0.18), 0.5 + 0.5 * ring);
    }
    return ball();
}

void main() {
    colour = vec4(skin(), 1.0);
}
