#version 330 core
// Bodies: positions come in logical pixels, everything else in the body's own frame, in metres.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 local;
layout(location = 2) in vec4 nature; // skin, mood, distance to the outline (m), radius (m, 0: polygon)
layout(location = 3) in vec4 extra;  // gaze direction and half extents, or a particle's colour
uniform vec2 screen;
out vec2 place;
flat out vec2 kind;
out float inside;
flat out float radius;
flat out vec4 more;

void main() {
    gl_Position = vec4(2.0 * position.x / screen.x - 1.0, 1.0 - 2.0 * position.y / screen.y, 0.0, 1.0);
    place = local;
    kind = nature.xy;
    inside = nature.z;
    radius = nature.w;
    more = extra;
}
