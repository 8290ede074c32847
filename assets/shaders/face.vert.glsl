#version 330 core
// Faces of RigiBos; the position is in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 expression; // place on the sheet, and its layer
uniform vec2 screen;
out vec3 sheet;

void main() {
    gl_Position = vec4(2.0 * position.x / screen.x - 1.0, 1.0 - 2.0 * position.y / screen.y, 0.0, 1.0);
    sheet = expression;
}
