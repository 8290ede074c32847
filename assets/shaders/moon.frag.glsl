#version 330 core
// The Moon by night: stars and the Earth over ridges and a plain of craters, all of them dim, so
// that nobody takes them for something a ball could lie on. Lengths are logical pixels, y down.
in vec2 place;
uniform vec4 window;  // its left and upper edge, width and height
uniform int detailed; // 0: only stars, and ground of one colour
out vec4 colour;

const vec3 SKY = vec3(0.030, 0.034, 0.060);
const vec3 HAZE = vec3(0.072, 0.078, 0.122); // of the sky over the ridges
const vec3 DUST = vec3(0.205, 0.212, 0.240);
const vec2 EARTH = vec2(598.0, 150.0);       // where the lamp hangs in the workshop
const vec2 SUN = vec2(-0.86, -0.51);         // direction to it
const float EDGE = 640.0;                    // of the plain
const float EYE = 90.0;                      // height of the true horizon above that edge
const float FOCUS = 2.0;                     // how far an outline is smeared
const float CELL = 44.0;                     // of the sky, which has one star at most

float hash(vec2 p) {
    return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453);
}

float noise(vec2 p) {
    vec2 i = floor(p);
    vec2 f = p - i;
    vec2 u = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1, 0)), u.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), u.x), u.y);
}

/** Upper edge of a ridge, px: large hills with small ones on them. */
float ridge(float x, float foot, float height, float pitch) {
    float hills = 0.68 * noise(vec2(x / pitch, foot)) + 0.24 * noise(vec2(3.1 * x / pitch, foot));
    return foot - height * (hills + 0.08 * noise(vec2(9.7 * x / pitch, foot)));
}

float below(float edge, float y) {
    return smoothstep(edge - FOCUS, edge + FOCUS, y);
}

vec3 stars(vec2 p) {
    vec2 cell = floor(p / CELL);
    float light = hash(cell + 3.0);
    vec2 at = CELL * (cell + 0.15 + 0.7 * vec2(hash(cell + 11.0), hash(cell + 23.0)));
    float size = 0.6 + 1.1 * light * light;
    float glow = (1.0 - smoothstep(0.4 * size, size + 0.7, length(p - at))) * light * light * light;
    return 0.75 * glow * mix(vec3(1.0, 0.86, 0.70), vec3(0.74, 0.85, 1.0), hash(cell + 5.0));
}

/** The Earth, lit from the left: seas, land and clouds out of focus, and a thin blue rim. */
vec3 earth(vec2 p, vec3 sky) {
    const float RADIUS = 44.0;
    vec2 q = (p - EARTH) / RADIUS;
    float far = length(q);
    vec3 normal = vec3(q, sqrt(max(0.0, 1.0 - far * far)));
    float day = smoothstep(-0.15, 0.75, dot(normal, normalize(vec3(SUN, 0.45))));
    vec2 bent = q + 0.35 * vec2(noise(3.7 * q + 3.0), noise(4.1 * q + 19.0));
    float land = smoothstep(0.46, 0.56, 0.6 * noise(2.6 * bent + 5.0) + 0.4 * noise(6.3 * bent));
    float cloud = smoothstep(0.48, 0.80, 0.6 * noise(vec2(2.3, 5.6) * bent + 31.0) + 0.4 * noise(vec2(6.0, 13.0) * bent));
    vec3 ground = mix(vec3(0.09, 0.25, 0.48), vec3(0.27, 0.33, 0.21), land);
    vec3 c = mix(ground, vec3(0.66, 0.71, 0.76), 0.8 * cloud);
    c = mix(sky, c * (0.05 + 0.78 * day), 1.0 - smoothstep(1.0 - 1.5 / RADIUS, 1.0 + 1.5 / RADIUS, far));
    float rim = far > 1.0 ? exp(-(far - 1.0) * 7.0) : 0.0;
    return c + 0.10 * rim * smoothstep(-0.5, 1.0, dot(q, SUN)) * vec3(0.35, 0.60, 1.0);
}

/** How much lighter the dust of the plain is: craters of one size, each in a cell of its own. */
float craters(vec2 p) {
    vec2 cell = floor(p);
    float size = 0.12 + 0.26 * hash(cell + 41.0);
    vec2 middle = cell + size + 0.06 + (0.88 - 2.0 * size) * vec2(hash(cell), hash(cell + 17.0));
    vec2 q = (p - middle) / size;
    float far = length(q);
    // The wall towards the Sun lies in shadow, the other one is lit; outside the rim it is reversed.
    float side = dot(q / max(far, 0.01), SUN);
    float bowl = 1.0 - smoothstep(0.82, 0.96, far);
    float rim = smoothstep(0.80, 0.96, far) * (1.0 - smoothstep(0.96, 1.3, far));
    return step(0.35, hash(cell + 29.0)) * (-0.42 * side * far * bowl - 0.10 * bowl + 0.26 * side * rim);
}

/** The plain as the eye sees it: what is far is small and flat. */
vec3 plain(vec2 p) {
    float depth = 230.0 / (p.y - EDGE + EYE);
    vec2 at = vec2((p.x - 360.0) / 110.0, 5.2) * depth;
    float clear = 1.0 - smoothstep(1.5, 2.6, depth);
    float light = clear * (craters(at) + 0.5 * craters(2.7 * at + 5.0) * clear);
    float dust = 0.16 * (noise(1.3 * at) - 0.5) + 0.10 * (noise(vec2(p.x, 2.4 * p.y) / 3.0) - 0.5);
    return DUST * (1.0 + light + dust) * (1.0 - 0.25 * smoothstep(0.0, 200.0, p.y - EDGE));
}

void main() {
    vec2 p = window.xy + vec2(place.x, 1.0 - place.y) * window.zw;
    float back = ridge(p.x, 600.0, 120.0, 310.0);
    float front = ridge(p.x, EDGE + 14.0, 54.0, 210.0);
    vec3 c = mix(SKY, HAZE, smoothstep(120.0, 600.0, p.y)) + stars(p);
    vec3 near = DUST;
    if (detailed == 1) {
        c = earth(p, c);
        near = p.y > EDGE - 40.0 ? plain(p) : DUST;
    }
    c = mix(c, 0.52 * DUST, below(back, p.y));
    c = mix(c, 0.72 * DUST, below(front, p.y));
    c = mix(c, near, below(EDGE + 6.0 * noise(vec2(p.x / 90.0, 8.0)), p.y));
    if (detailed == 1) {
        vec2 aside = place - 0.5;
        c *= 1.0 - 0.5 * dot(aside, aside);
    }
    // A step of 1/255 shows as a band on so dark a ground; this grain hides it.
    c += (hash(gl_FragCoord.xy) - 0.5) / 255.0;
    colour = vec4(c, 1.0);
}
