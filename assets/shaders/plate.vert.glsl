#version 330 core
// Filled rectangles with round corners, turned or not, in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 way;    // from the centre
layout(location = 2) in vec3 extent; // half width, half height, radius of the corners
layout(location = 3) in vec4 ink;
uniform vec4 window; // its left and upper edge, width and height
out vec2 out_way;
flat out vec3 out_extent;
flat out vec4 out_ink;

void main() {
    gl_Position = vec4(vec2(2.0, -2.0) * (position - window.xy) / window.zw + vec2(-1.0, 1.0), 0.0, 1.0);
    out_way = way;
    out_extent = extent;
    out_ink = ink;
}
