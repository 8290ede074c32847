#version 330 core
// The faces of RigiBos, one expression a layer, form after form: mouth under the eyes, between them
// for low boxes, under eyes side by side for narrow ones. Both halves are alike, so only the right one is
// computed; pupils are drawn apart, for they move.
in vec2 place; // 0 to 1
uniform int layer;
out vec4 colour; // times its cover

const int CALM = 0, BLINKING = 1, WINCING = 2, ASLEEP = 3, WORRIED = 4, CHEERING = 5;
const int EXPRESSIONS = 6, LOW = 1, NARROW = 2;
const float TEXELS = 128.0;
const vec3 INK = vec3(0.16, 0.09, 0.08);

/** How far the sheet reaches from a face's middle, in its units. */
float reach() {
    return layer / EXPRESSIONS == LOW ? 1.1 : 0.7;
}

float soft(float inside) {
    return clamp(inside * TEXELS / (2.0 * reach()) + 0.5, 0.0, 1.0);
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
    int form = layer / EXPRESSIONS;
    int expression = layer - form * EXPRESSIONS;
    bool isLow = form == LOW;
    bool isNarrow = form == NARROW;
    vec2 eye = isLow ? vec2(0.62, 0.0) : isNarrow ? vec2(0.245, 0.27) : vec2(0.36, 0.14);
    vec2 cheek = isLow ? vec2(0.94, -0.08) : isNarrow ? vec2(0.36, -0.06) : vec2(0.56, -0.15);
    vec2 brows = eye + vec2(-0.16, isLow ? 0.24 : 0.36);
    vec2 whole = (2.0 * place - 1.0) * reach();
    vec2 q = vec2(abs(whole.x), whole.y);
    // Places of mouths are those under usual eyes.
    vec2 p = whole - vec2(0.0, isLow ? 0.31 : isNarrow ? 0.10 : 0.0);
    float white = soft(0.21 - length((q - eye) * vec2(1.06, 1.0)));
    float rim = soft(0.235 - length((q - eye) * vec2(1.06, 1.0)));
    float lid = bow(q, eye + vec2(0.0, 0.10), 0.19, 1.0, 0.19, 0.036);
    float glad = bow(q, eye + vec2(0.0, -0.10), 0.18, -1.0, 0.10, 0.042);
    float pinched = max(stroke(q, eye + vec2(-0.15, 0.0), vec2(0.30, 0.13), 0.042),
                        stroke(q, eye + vec2(-0.15, 0.0), vec2(0.30, -0.13), 0.042));
    float smile = bow(p, vec2(0.0, -0.10), 0.30, 1.0, -0.22, 0.040);
    float cry = soft(0.115 - length((p - vec2(0.0, -0.37)) * vec2(1.0, 0.85)));
    float worry = bow(p, vec2(0.0, -0.58), 0.22, -1.0, -0.44, 0.038);
    float brow = stroke(q, brows, vec2(0.30, -0.10), 0.038);
    float laugh = soft(min(0.26 - length(p - vec2(0.0, -0.22)), -0.22 - p.y));
    float tongue = soft(min(0.13 - length(p - vec2(0.0, -0.47)), 0.25 - length(p - vec2(0.0, -0.22))));
    float blush = 0.45 * (1.0 - smoothstep(0.03, 0.14, length((q - cheek) * vec2(1.0, 1.5))));

    bool isOpen = expression == CALM || expression == WORRIED;
    float ink = expression == CALM ? smile
        : expression == BLINKING ? max(lid, smile)
        : expression == WINCING ? max(pinched, cry)
        : expression == ASLEEP ? max(lid, 0.8 * smile)
        : expression == WORRIED ? max(worry, brow)
        : max(glad, laugh);
    vec4 c = over(vec4(0.0), vec3(0.95, 0.40, 0.33), expression == ASLEEP ? 0.0 : blush);
    c = over(c, 0.5 * INK + vec3(0.30, 0.17, 0.06), isOpen ? 0.55 * rim : 0.0);
    c = over(c, vec3(1.0, 0.99, 0.96), isOpen ? white : 0.0);
    c = over(c, INK, ink);
    c = over(c, vec3(0.93, 0.42, 0.36), expression == CHEERING ? tongue : 0.0);
    colour = vec4(c.rgb * c.a, c.a);
}
