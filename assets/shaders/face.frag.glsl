#version 330 core
in vec3 sheet;
uniform sampler2DArray skins;
uniform float veil; // 0 to 1: how far all colour is gone
out vec4 colour;    // times its cover, as it was looked up

void main() {
    vec4 c = texture(skins, sheet);
    vec3 grey = dot(c.rgb, vec3(0.3, 0.6, 0.1)) * vec3(0.60, 0.62, 0.72);
    colour = vec4(mix(c.rgb, grey, 0.85 * veil), c.a);
}
