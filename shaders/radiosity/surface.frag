// Fragment stage of radiosity (Gouraud 1971, "Continuous Shading of Curved Surfaces"): what was interpolated is what is seen.
#version 460

layout(location = 0) in vec3 radiance;
layout(location = 0) out vec4 color;

void main() { color = vec4(radiance, 1.0); }
