#version 330 core
// A skin looked up, a dark rim, a soft light along it. No branches: software OpenGL takes them all.
in vec3 sheet;
in vec2 out_way;
flat in vec2 out_reach;
flat in float mood;
uniform sampler2DArray skins;
uniform float ratio; // framebuffer pixels per logical one
out vec4 colour;

const float HOVERED = 1.0, ASLEEP = 2.0, GHOST = 3.0;

void main() {
    vec2 inside = out_reach - abs(out_way);
    float depth = out_reach.y < 0.0 ? out_reach.x - length(out_way) : min(inside.x, inside.y);
    float cover = clamp(depth * ratio + 0.5, 0.0, 1.0);
    vec3 c = texture(skins, sheet).rgb * (0.55 + 0.45 * clamp(depth / 3.0, 0.0, 1.0));
    c += 0.05 * clamp(1.0 - abs(depth - 7.0) / 6.0, 0.0, 1.0);
    vec3 dim = mix(c, dot(c, vec3(0.3, 0.6, 0.1)) * vec3(0.82, 0.84, 1.0), 0.35);
    c = mood == ASLEEP ? dim : c;
    c = mood == HOVERED ? c * 1.12 + 0.03 : c;
    vec4 ghost = vec4(0.96, 0.95, 0.90, 0.7 * cover * clamp(2.5 - depth, 0.0, 1.0));
    colour = mood == GHOST ? ghost : vec4(c, cover);
}
