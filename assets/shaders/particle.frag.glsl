#version 330 core
// A splinter covers its square, a puff fades towards its edge, a glow adds its light to what is there.
in vec2 way;
flat in vec4 out_ink;
flat in float out_kind;
out vec4 colour; // its colour times its cover, and how much of what is there it hides

const float SPLINTER = 0.0, GLOW = 2.0;

void main() {
    float round_ = clamp(1.0 - dot(way, way), 0.0, 1.0);
    float cover = out_ink.a * (out_kind == SPLINTER ? 1.0 : round_ * round_);
    colour = vec4(out_ink.rgb * cover, out_kind == GLOW ? 0.0 : cover);
}
