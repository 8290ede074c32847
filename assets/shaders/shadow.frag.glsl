#version 330 core
// The further inside, the darker: no blur.
in vec2 out_way;
flat in vec2 out_reach;
flat in vec2 out_kind;
out vec4 colour; // times its cover

void main() {
    float smear = out_kind.x;
    vec2 q = abs(out_way) - out_reach + smear;
    vec2 beyond = max(q, 0.0);
    float box = smear - length(beyond) - min(max(q.x, q.y), 0.0);
    float depth = out_reach.y < 0.0 ? out_reach.x - length(out_way) : box;
    float inside = clamp(0.5 + 0.5 * depth / smear, 0.0, 1.0);
    colour = vec4(0.03, 0.03, 0.09, 1.0) * (out_kind.y * inside * inside * (3.0 - 2.0 * inside));
}
