#version 330 core
// The workshop at dusk: cool above, warmer below, with a faint lamp.
in vec2 place;
out vec4 colour;

void main() {
    vec3 top = vec3(0.106, 0.122, 0.200);
    vec3 bottom = vec3(0.290, 0.247, 0.400);
    vec3 c = mix(bottom, top, smoothstep(0.0, 1.0, place.y));
    float lamp = exp(-4.0 * length((place - vec2(0.5, 0.62)) * vec2(1.0, 1.2)));
    c += 0.06 * lamp * vec3(1.0, 0.75, 0.45);
    // A step of 1/255 shows as a band on so dark a ground; this grain hides it.
    c += (fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) - 0.5) / 255.0;
    colour = vec4(c, 1.0);
}
