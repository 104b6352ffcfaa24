// Second link: one triangle over the whole picture, its color from what the first link wrote; and the indices of it.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(local_size_x = 1) in;
layout(set = 0, binding = 0, scalar) readonly buffer Squares { uvec4 squares[]; };
layout(set = 0, binding = 1, scalar) writeonly buffer Vertices { vec4 vertices[]; };
layout(set = 0, binding = 2, scalar) writeonly buffer Indices { uint indices[]; };

void main() {
    for (uint i = 0u; i < 3u; ++i) {
        vertices[2u * i] = vec4(float(i & 1u) * 4.0 - 1.0, float(i >> 1u) * 4.0 - 1.0, 0.5, 1.0);
        vertices[2u * i + 1u] = vec4(squares[1]);
        indices[i] = i;
    }
}
