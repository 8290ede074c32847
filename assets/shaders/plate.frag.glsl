#version 330 core
in vec2 out_way;
flat in vec3 out_extent;
flat in vec4 out_ink;
uniform float ratio; // framebuffer pixels per logical one
out vec4 colour; // times its cover

void main() {
    vec2 corner = abs(out_way) - out_extent.xy + out_extent.z;
    float outside = length(max(corner, 0.0)) + min(max(corner.x, corner.y), 0.0) - out_extent.z;
    colour = vec4(out_ink.rgb, 1.0) * (out_ink.a * clamp(0.5 - outside * ratio, 0.0, 1.0));
}
