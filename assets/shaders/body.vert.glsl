#version 330 core
// Bodies; the position is in logical pixels.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec2 way;    // from the centre (px)
layout(location = 3) in vec2 reach;  // of a box to its sides (px); of a round body x, and y negative
layout(location = 4) in vec2 light;  // towards the lamp, in the body's frame
layout(location = 5) in vec3 kind;   // skin, mood, radius of a box's corners (px)
uniform vec4 window; // its left and upper edge, width and height
out vec3 sheet;
out vec2 out_way;
flat out vec2 out_reach;
flat out vec2 out_light;
flat out float corner;
flat out float mood;

void main() {
    gl_Position = vec4(vec2(2.0, -2.0) * (position - window.xy) / window.zw + vec2(-1.0, 1.0), 0.0, 1.0);
    sheet = vec3(texel, kind.x);
    out_way = way;
    out_reach = reach;
    out_light = light;
    mood = kind.y;
    corner = kind.z;
}
