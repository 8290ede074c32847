#version 330 core
// Faces of RigiBos; the position is in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec3 expression; // place on the sheet, and its layer
uniform vec4 window; // its left and upper edge, width and height
out vec3 sheet;

void main() {
    gl_Position = vec4(vec2(2.0, -2.0) * (position - window.xy) / window.zw + vec2(-1.0, 1.0), 0.0, 1.0);
    sheet = expression;
}
