#version 330 core
// Filled rectangles with round corners, turned or not, in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 way;    // from the centre
layout(location = 2) in vec3 extent; // half width, half height, radius of the corners
layout(location = 3) in vec4 ink;
uniform vec2 screen;
out vec2 out_way;
flat out vec3 out_extent;
flat out vec4 out_ink;

void main() {
    gl_Position = vec4(2.0 * position.x / screen.x - 1.0, 1.0 - 2.0 * position.y / screen.y, 0.0, 1.0);
    out_way = way;
    out_extent = extent;
    out_ink = ink;
}
