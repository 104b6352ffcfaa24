// Third link: the vertices' color times a factor, plus what the first link wrote; counts its invocations.
#version 460
#extension GL_EXT_scalar_block_layout : require

layout(set = 0, binding = 0, scalar) readonly buffer Squares { uvec4 squares[]; };
layout(set = 0, binding = 1, scalar) buffer Count { uint fragments; };
layout(push_constant, scalar) uniform Push { float factor; };
layout(location = 0) in vec4 color;
layout(location = 0) out vec4 result;

void main() {
    atomicAdd(fragments, 1u);
    result = color * factor + vec4(squares[0]);
}
