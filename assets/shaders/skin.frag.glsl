#version 330 core
// The sheets that bodies are cut from: 4 m by 4 m that fit to themselves on all sides. What looks
// like chance repeats after a whole number of its own cells.
in vec2 place; // 0 to 1
uniform int layer;
uniform int detailed; // 0: without grain; what tells one skin from another stays
out vec4 colour;

const int RIGIBO = 0, STONE = 1, IRON = 2, ICE = 3, RUBBER = 4, WOOD = 5, GOAL = 7, EMBER = 8;
const float TEXELS = 512.0;

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

/** The smooth chance about nought, or nought where there is to be no grain. */
float grain(vec2 cells) {
    return detailed == 1 ? noise(cells) - 0.5 : 0.0;
}

/**
 * Distance to the nearest of points thrown at random, and to the next, in cells. Only stone, ice
 * and embers ask for it: software OpenGL takes both sides of a branch, but no turns of an empty loop.
 */
vec2 scattered(float cells) {
    vec2 p = place * cells;
    vec2 i = floor(p);
    vec2 nearest = vec2(9.0);
    int last = layer == STONE || layer == ICE || layer == EMBER ? 1 : -2;
    for (int y = -1; y <= last; y++) {
        for (int x = -1; x <= 1; x++) {
            vec2 at = i + vec2(x, y);
            vec2 own = mod(at, cells);
            float d = length(at + 0.5 + 0.8 * (vec2(hash(own), hash(own + 31.7)) - 0.5) - p);
            nearest = d < nearest.x ? vec2(d, nearest.x) : vec2(nearest.x, min(nearest.y, d));
        }
    }
    return nearest;
}

vec3 ball() {
    vec2 p = 2.0 * place - 1.0;
    float stripe = clamp((abs(p.y) - 0.22) * 128.0 + 0.5, 0.0, 1.0);
    vec3 band = p.x * p.y > 0.0 ? vec3(0.95, 0.41, 0.37) : vec3(0.25, 0.76, 0.66);
    float sector = clamp((abs(p.x) + 0.4 * abs(p.y) - 0.62) * 128.0 + 0.5, 0.0, 1.0);
    return mix(vec3(0.20, 0.24, 0.38), mix(vec3(0.957, 0.945, 0.902), band, sector), stripe);
}

/** Painted beech: fine, straight grain. */
vec3 rigibo() {
    float fibre = 0.7 * grain(vec2(10.0, 120.0)) + 0.5 * grain(vec2(20.0, 240.0));
    return vec3(0.910, 0.627, 0.298) * (1.0 + 0.10 * fibre + 0.06 * grain(vec2(8.0)));
}

/** Granite: speckles, light and dark. */
vec3 stone(float speck) {
    float kind = hash(floor(place * 60.0) + 7.0);
    vec3 c = vec3(0.424, 0.455, 0.525) * (1.0 + 0.22 * grain(vec2(14.0)) + 0.16 * grain(vec2(50.0)));
    float size = 0.10 + 0.14 * kind;
    float spot = 1.0 - smoothstep(size - 0.09, size + 0.09, speck);
    return c * (1.0 + spot * (kind > 0.5 ? 0.28 : -0.30));
}

vec3 iron() {
    return vec3(0.285, 0.325, 0.400) * (1.0 + 0.16 * grain(vec2(6.0, 200.0)) + 0.14 * grain(vec2(10.0)));
}

/** Cracks run where two of the scattered points are equally far. */
vec3 ice(float crack) {
    float light = 0.5 + grain(vec2(8.0));
    vec3 c = mix(vec3(0.600, 0.820, 0.915), vec3(0.760, 0.915, 0.975), light);
    c *= 1.0 - 0.10 * (1.0 - smoothstep(0.02, 0.16, crack));
    return mix(vec3(0.97, 0.995, 1.0), c, smoothstep(0.012, 0.045, crack));
}

/** Plates of a dark crust; what glows between them is brightest where they are far apart. */
vec3 ember(float seam) {
    vec3 crust = vec3(0.245, 0.085, 0.075) * (1.0 + 0.5 * grain(vec2(40.0)) + 0.4 * grain(vec2(120.0)));
    float heat = 1.0 - smoothstep(0.03, 0.30, seam + 0.10 * grain(vec2(30.0)));
    vec3 glow = mix(vec3(0.80, 0.13, 0.05), vec3(1.0, 0.72, 0.25), heat * heat);
    return mix(crust, glow, heat);
}

vec3 rubber() {
    vec2 cell = fract(place * 20.0) - 0.5;
    float dot_ = clamp((0.24 - length(cell)) * TEXELS / 20.0 + 0.5, 0.0, 1.0);
    vec3 c = mix(vec3(0.769, 0.322, 0.478), vec3(0.60, 0.22, 0.36), dot_);
    return c * (1.0 + 0.10 * grain(vec2(160.0)));
}

vec3 wood() {
    float wave = noise(vec2(4.0, 12.0));
    float ring = 0.5 + 0.5 * sin(2.0 * 3.14159265 * 15.0 * place.y + 7.0 * wave);
    float fibre = grain(vec2(16.0, 220.0));
    vec3 c = mix(vec3(0.765, 0.505, 0.275), vec3(0.585, 0.355, 0.175), ring * ring);
    return c * (1.0 + 0.16 * fibre + 0.10 * grain(vec2(5.0, 9.0)));
}

/** Chequered, woven cloth; two rows of squares cover a goal of 0.3 m. */
vec3 goal() {
    vec2 turn = sin(3.14159265 * 26.0 * place);
    float light = clamp(turn.x * turn.y * 9.0 + 0.5, 0.0, 1.0);
    vec3 c = mix(vec3(0.090, 0.430, 0.360), vec3(0.830, 0.930, 0.860), light);
    return c * (1.0 + 0.14 * grain(vec2(220.0, 60.0)) + 0.10 * grain(vec2(60.0, 220.0)));
}

vec3 skin() {
    vec2 far = scattered(layer == STONE ? 60.0 : layer == EMBER ? 22.0 : 9.0);
    if (layer == RIGIBO) {
        return rigibo();
    }
    if (layer == STONE) {
        return stone(far.x);
    }
    if (layer == IRON) {
        return iron();
    }
    if (layer == ICE) {
        return ice(far.y - far.x);
    }
    if (layer == EMBER) {
        return ember(far.y - far.x);
    }
    if (layer == RUBBER) {
        return rubber();
    }
    if (layer == GOAL) {
        return goal();
    }
    return layer == WOOD ? wood() : ball();
}

void main() {
    colour = vec4(skin(), 1.0);
}
