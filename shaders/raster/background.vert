// Vertex stage of the background: one triangle that covers the image, as far away as can be (reversed depth: 0).
#version 460
void main() { gl_Position = vec4(vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0), 0.0, 1.0); }
