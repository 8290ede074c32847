#version 330 core
in vec2 out_way;
flat in float out_radius;
flat in vec4 out_ink;
uniform float ratio; // framebuffer pixels per logical one
out vec4 colour;

void main() {
    float cover = clamp((out_radius - length(out_way)) * ratio + 0.5, 0.0, 1.0);
    colour = vec4(out_ink.rgb, out_ink.a * cover);
}
