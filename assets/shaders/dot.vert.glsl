#version 330 core
// Rivets and particles; the position is in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 way; // from the centre (px)
layout(location = 2) in float radius;
layout(location = 3) in vec4 ink;
uniform vec2 screen;
out vec2 out_way;
flat out float out_radius;
flat out vec4 out_ink;

void main() {
    gl_Position = vec4(2.0 * position.x / screen.x - 1.0, 1.0 - 2.0 * position.y / screen.y, 0.0, 1.0);
    out_way = way;
    out_radius = radius;
    out_ink = ink;
}
