#version 330 core
// Particles, one instance each; places and sizes are logical pixels.
layout(location = 0) in vec4 position; // its middle, and half its width and height
layout(location = 1) in vec2 turn;     // cosine and sine
layout(location = 2) in vec4 ink;
layout(location = 3) in float kind;
uniform vec4 window; // its left and upper edge, width and height
out vec2 way; // 1 at the edges
flat out vec4 out_ink;
flat out float out_kind;

void main() {
    way = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec2 arm = way * position.zw;
    vec2 p = position.xy + vec2(turn.x * arm.x + turn.y * arm.y, turn.x * arm.y - turn.y * arm.x);
    gl_Position = vec4(vec2(2.0, -2.0) * (p - window.xy) / window.zw + vec2(-1.0, 1.0), 0.0, 1.0);
    out_ink = ink;
    out_kind = kind;
}
