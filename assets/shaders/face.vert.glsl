#version 330 core
// Faces of RigiBos; the position is in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 place; // on the face: 1 is half the body
layout(location = 2) in float unit; // px
layout(location = 3) in vec2 look;  // a direction
layout(location = 4) in vec2 kind;  // mood, and a number that tells one face from another
uniform vec2 screen;
uniform float time; // s, for blinking
out vec2 p;
flat out float px;
flat out vec2 pupil;
flat out float hovered;
flat out float closed;

void main() {
    gl_Position = vec4(2.0 * position.x / screen.x - 1.0, 1.0 - 2.0 * position.y / screen.y, 0.0, 1.0);
    p = place;
    px = unit;
    pupil = 0.08 * look;
    hovered = kind.x == 1.0 ? 1.0 : 0.0;
    bool blinks = fract(time * 0.23 + 7.31 * kind.y) < 0.03;
    closed = kind.x == 2.0 || blinks ? 1.0 : 0.0;
}
