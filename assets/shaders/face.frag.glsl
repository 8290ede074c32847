#version 330 core
// Both halves of a face are alike, so only the right one is computed.
in vec2 p;
flat in float px;      // logical pixels per unit
flat in vec2 pupil;
flat in float hovered; // winces
flat in float closed;
uniform float ratio;   // framebuffer pixels per logical one
out vec4 colour;

float soft(float inside) {
    return clamp(inside * px * ratio + 0.5, 0.0, 1.0);
}

/** 1 on a line from a to a + d, w wide. */
float stroke(vec2 q, vec2 a, vec2 d, float w) {
    vec2 from = q - a;
    return soft(w - length(from - clamp(dot(from, d) / dot(d, d), 0.0, 1.0) * d));
}

void main() {
    vec2 half_ = vec2(abs(p.x), p.y);
    vec2 eye = vec2(0.36, 0.14);
    vec2 look = vec2(sign(p.x) * pupil.x, pupil.y);
    float white = soft(0.2 - length(half_ - eye));
    float open = soft(0.1 - length(half_ - eye - look));
    float lid = stroke(half_, eye - vec2(0.16, 0.0), vec2(0.32, 0.0), 0.04);
    float smile = soft(0.04 - abs(length(p - vec2(0.0, -0.12)) - 0.3)) * step(p.y, -0.24);
    float wince = max(stroke(half_, eye - vec2(0.15, 0.0), vec2(0.32, 0.12), 0.045),
                      stroke(half_, eye - vec2(0.15, 0.0), vec2(0.32, -0.12), 0.045));
    float cry = soft(0.13 - length(p - vec2(0.0, -0.36)));
    float calm = max(mix(open, lid, closed), smile);
    float ink = mix(calm, max(wince, cry), hovered);
    white *= (1.0 - closed) * (1.0 - hovered);
    float cover = 1.0 - (1.0 - white) * (1.0 - ink);
    vec3 c = mix(vec3(1.0), vec3(0.16, 0.09, 0.08), ink / max(cover, 1e-3));
    colour = vec4(c, cover);
}
