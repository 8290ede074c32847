#version 330 core
// The faces of RigiBos, one expression a layer. Both halves are alike, so only the right one is
// computed; pupils are drawn apart, for they move. A face reaches from -0.7 to 0.7 both ways.
in vec2 place; // 0 to 1
uniform int layer;
out vec4 colour; // times its cover

const int CALM = 0, BLINKING = 1, WINCING = 2, ASLEEP = 3, WORRIED = 4, CHEERING = 5;
const float REACH = 0.7;
const float TEXELS = 128.0;
const vec3 INK = vec3(0.16, 0.09, 0.08);
const vec2 EYE = vec2(0.36, 0.14);

float soft(float inside) {
    return clamp(inside * TEXELS / (2.0 * REACH) + 0.5, 0.0, 1.0);
}

/** 1 on a line from a to a + d, w wide to each side. */
float stroke(vec2 q, vec2 a, vec2 d, float w) {
    vec2 from = q - a;
    return soft(w - length(from - clamp(dot(from, d) / dot(d, d), 0.0, 1.0) * d));
}

/** Part of a circle's line below (side 1) or above (side -1) a height. */
float bow(vec2 p, vec2 centre, float radius, float side, float height, float w) {
    return soft(w - abs(length(p - centre) - radius)) * soft(side * (height - p.y) + 0.02);
}

vec4 over(vec4 below, vec3 ink, float cover) {
    float a = cover + below.a * (1.0 - cover);
    return vec4((ink * cover + below.rgb * below.a * (1.0 - cover)) / max(a, 1e-3), a);
}

void main() {
    vec2 p = (2.0 * place - 1.0) * REACH;
    vec2 q = vec2(abs(p.x), p.y);
    float white = soft(0.21 - length((q - EYE) * vec2(1.06, 1.0)));
    float rim = soft(0.235 - length((q - EYE) * vec2(1.06, 1.0)));
    float lid = bow(q, EYE + vec2(0.0, 0.10), 0.19, 1.0, 0.19, 0.036);
    float glad = bow(q, EYE + vec2(0.0, -0.10), 0.18, -1.0, 0.10, 0.042);
    float pinched = max(stroke(q, EYE + vec2(-0.15, 0.0), vec2(0.30, 0.13), 0.042),
                        stroke(q, EYE + vec2(-0.15, 0.0), vec2(0.30, -0.13), 0.042));
    float smile = bow(p, vec2(0.0, -0.10), 0.30, 1.0, -0.22, 0.040);
    float cry = soft(0.115 - length((p - vec2(0.0, -0.37)) * vec2(1.0, 0.85)));
    float worry = bow(p, vec2(0.0, -0.58), 0.22, -1.0, -0.44, 0.038);
    float brow = stroke(q, vec2(0.20, 0.50), vec2(0.30, -0.10), 0.038);
    float laugh = soft(min(0.26 - length(p - vec2(0.0, -0.22)), -0.22 - p.y));
    float tongue = soft(min(0.13 - length(p - vec2(0.0, -0.47)), 0.25 - length(p - vec2(0.0, -0.22))));
    float blush = 0.45 * (1.0 - smoothstep(0.03, 0.14, length((q - vec2(0.56, -0.15)) * vec2(1.0, 1.5))));

    bool isOpen = layer == CALM || layer == WORRIED;
    float ink = layer == CALM ? smile
        : layer == BLINKING ? max(lid, smile)
        : layer == WINCING ? max(pinched, cry)
        : layer == ASLEEP ? max(lid, 0.8 * smile)
        : layer == WORRIED ? max(worry, brow)
        : max(glad, laugh);
    vec4 c = over(vec4(0.0), vec3(0.95, 0.40, 0.33), layer == ASLEEP ? 0.0 : blush);
    c = over(c, 0.5 * INK + vec3(0.30, 0.17, 0.06), isOpen ? 0.55 * rim : 0.0);
    c = over(c, vec3(1.0, 0.99, 0.96), isOpen ? white : 0.0);
    c = over(c, INK, ink);
    c = over(c, vec3(0.93, 0.42, 0.36), layer == CHEERING ? tongue : 0.0);
    colour = vec4(c.rgb * c.a, c.a);
}
