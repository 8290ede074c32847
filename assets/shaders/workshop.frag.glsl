#version 330 core
// The workshop at dusk: a cool, dim wall of boards, a lamp, tools and shelves out of focus, so that
// nobody takes them for something a ball could lie on. Lengths are logical pixels, y down.
in vec2 place;
uniform vec4 window;  // its left and upper edge, width and height
uniform int detailed; // 0: only the gradient
out vec4 colour;

const float HEIGHT = 800.0;       // of a scene
const vec3 TOP = vec3(0.106, 0.122, 0.200);
const vec3 BOTTOM = vec3(0.290, 0.247, 0.400);
const float FOCUS = 2.5;          // how far an outline is smeared
const float FAR = 12.0;           // farther away than any smear reaches
const vec2 FALL = vec2(5.0, 9.0); // where shadows on the wall fall to
const vec2 BULB = vec2(598.0, 116.0);
const float PITCH = 810.0;        // what hangs on the wall comes again beside a scene: nine boards
const float AHEAD = 45.0;         // where that begins, left of a scene

float hash(vec2 p) {
    return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453);
}

float noise(vec2 p) {
    vec2 i = floor(p);
    vec2 f = p - i;
    vec2 u = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash(i), hash(i + vec2(1, 0)), u.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), u.x), u.y);
}

/** How much of a pixel lies within an outline, out of focus. */
float soft(float outside) {
    return 1.0 - smoothstep(-FOCUS, FOCUS, outside);
}

float box(vec2 p, vec2 centre, vec2 extent, float corner) {
    vec2 q = abs(p - centre) - extent + corner;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - corner;
}

float disc(vec2 p, vec2 centre, float radius) {
    return length(p - centre) - radius;
}

float rod(vec2 p, vec2 a, vec2 b, float radius) {
    vec2 way = b - a;
    vec2 from = p - a;
    return length(from - clamp(dot(from, way) / dot(way, way), 0.0, 1.0) * way) - radius;
}

/** Cuts the second out of the first. */
float without(float outline, float cut) {
    return max(outline, -cut);
}

float hammer(vec2 p) {
    float head = min(box(p, vec2(92, 178), vec2(30, 11), 4.0), box(p, vec2(67, 178), vec2(8, 15), 3.0));
    return min(rod(p, vec2(92, 178), vec2(92, 288), 5.5), head);
}

float wrench(vec2 p) {
    float eye = without(disc(p, vec2(146, 176), 17.0), disc(p, vec2(146, 176), 8.0));
    float jaw = without(disc(p, vec2(146, 292), 19.0), box(p, vec2(146, 308), vec2(7.5, 18), 2.0));
    return min(rod(p, vec2(146, 192), vec2(146, 276), 6.5), min(eye, jaw));
}

float saw(vec2 p) {
    vec2 along = vec2(p.x - 206.0, p.y - 170.0);
    float teeth = 2.5 * abs(fract(along.y / 7.0) - 0.5);
    float blade = max(abs(along.x) - 17.0 + 0.085 * (along.y - 55.0) + teeth, box(p, vec2(206, 258), vec2(40, 62), 2.0));
    float grip = without(box(p, vec2(206, 176), vec2(21, 22), 9.0), box(p, vec2(206, 176), vec2(9, 10), 5.0));
    return min(blade, grip);
}

float tools(vec2 p) {
    float pegs = min(disc(p, vec2(92, 160), 3.0), min(disc(p, vec2(146, 176), 4.0), disc(p, vec2(206, 152), 3.0)));
    return min(min(hammer(p), pegs), min(wrench(p), saw(p)));
}

float jar(vec2 p, vec2 foot, vec2 extent) {
    float body = box(p, foot - vec2(0, extent.y), extent, 6.0);
    return min(body, box(p, foot - vec2(0, 2.0 * extent.y + 5.0), vec2(0.7 * extent.x, 4.0), 2.0));
}

float shelves(vec2 p) {
    float upper = box(p, vec2(596, 268), vec2(98, 4), 1.0);
    float lower = box(p, vec2(596, 392), vec2(98, 4), 1.0);
    float stays = min(box(p, vec2(520, 336), vec2(3, 66), 1.0), box(p, vec2(672, 336), vec2(3, 66), 1.0));
    float above = min(jar(p, vec2(530, 264), vec2(17, 26)), jar(p, vec2(572, 264), vec2(13, 19)));
    above = min(above, min(box(p, vec2(630, 238), vec2(32, 26), 3.0), box(p, vec2(626, 202), vec2(22, 10), 3.0)));
    float wheel = without(disc(p, vec2(556, 360), 28.0), disc(p, vec2(556, 360), 19.0));
    float spokes = max(disc(p, vec2(556, 360), 22.0), min(abs(p.x - 556.0), abs(p.y - 360.0)) - 2.0);
    float below = min(min(wheel, spokes), jar(p, vec2(614, 388), vec2(15, 22)));
    below = min(below, min(box(p, vec2(652, 376), vec2(9, 12), 2.0), disc(p, vec2(652, 354), 9.0)));
    return min(min(upper, lower), min(stays, min(above, below)));
}

/**
 * What hangs on the wall: tools under the lamp, shelves on the other side. Most of the wall is far
 * from either: software OpenGL takes both sides of a branch, but no turns of an empty loop.
 */
float things(vec2 at) {
    vec2 p = vec2(mod(at.x + AHEAD, PITCH) - AHEAD, at.y);
    float nearest = FAR;
    int turns = box(p, vec2(124, 292), vec2(104, 112), 0.0) < FAR ? 1 : 0;
    for (int i = 0; i < turns; i++) {
        nearest = min(nearest, shelves(p + vec2(470, 0)));
    }
    turns = box(p, vec2(600, 312), vec2(90, 88), 0.0) < FAR ? 1 : 0;
    for (int i = 0; i < turns; i++) {
        nearest = min(nearest, tools(p - vec2(452, 78)));
    }
    return nearest;
}

/** The wall's boards: each a little lighter or darker, with a gap between. */
float boards(vec2 p) {
    float board = floor(p.x / 90.0);
    float gap = abs(p.x - 90.0 * floor(p.x / 90.0 + 0.5));
    float grain = noise(vec2(p.x / 5.0 + 17.0 * board, p.y / 110.0)) + 0.5 * noise(vec2(p.x / 2.0, p.y / 40.0));
    return 0.965 + 0.05 * hash(vec2(board, 3.0)) + 0.035 * (grain - 0.75) - 0.11 * (1.0 - smoothstep(0.5, 2.5, gap));
}

vec3 workshop(vec2 p, vec3 wall) {
    vec3 c = wall * boards(p);
    float thing = things(p);
    float shade = things(p - FALL);
    c *= 1.0 - 0.16 * (1.0 - smoothstep(-5.0, 7.0, shade));
    c = mix(c, wall * 0.62, 0.8 * soft(thing));
    // The lamp: a cone that widens and dies away.
    vec2 q = p - BULB;
    float across = abs(q.x) / (34.0 + 0.62 * max(q.y, 0.0));
    float cone = (1.0 - smoothstep(0.25, 1.0, across)) * smoothstep(-4.0, 14.0, q.y) * exp(-q.y / 300.0);
    float halo = exp(-length(q) / 70.0);
    c += (0.085 * cone + 0.10 * halo) * vec3(1.0, 0.74, 0.42);
    float cord = rod(q, vec2(0.0, -120.0), vec2(0.0, -32.0), 1.5);
    float hood = max(box(q, vec2(0.0, -18.0), vec2(44.0, 15.0), 3.0), abs(q.x) - 12.0 - 1.05 * (q.y + 34.0));
    c = mix(c, vec3(0.055, 0.06, 0.10), 0.9 * soft(min(cord, hood) + 1.0));
    return mix(c, vec3(0.62, 0.47, 0.29), 0.8 * soft(max(disc(q, vec2(0.0, -4.0), 13.0), -4.0 - q.y)));
}

void main() {
    vec2 p = window.xy + vec2(place.x, 1.0 - place.y) * window.zw;
    vec3 c = mix(TOP, BOTTOM, smoothstep(0.0, HEIGHT, p.y));
    if (detailed == 1) {
        c = workshop(p, c);
        vec2 aside = place - 0.5;
        c *= 1.0 - 0.55 * dot(aside, aside);
    }
    // A step of 1/255 shows as a band on so dark a ground; this grain hides it.
    c += (hash(gl_FragCoord.xy) - 0.5) / 255.0;
    colour = vec4(c, 1.0);
}
