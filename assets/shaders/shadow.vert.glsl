#version 330 core
// Shadows of bodies on the wall behind them; the position is in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 way;   // from the centre (px)
layout(location = 2) in vec2 reach; // of a box to its sides (px); of a round body x, and y negative
layout(location = 3) in vec2 kind;  // how far the edge is smeared (px), and how dark it is
uniform vec4 window; // its left and upper edge, width and height
out vec2 out_way;
flat out vec2 out_reach;
flat out vec2 out_kind;

void main() {
    gl_Position = vec4(vec2(2.0, -2.0) * (position - window.xy) / window.zw + vec2(-1.0, 1.0), 0.0, 1.0);
    out_way = way;
    out_reach = reach;
    out_kind = kind;
}
