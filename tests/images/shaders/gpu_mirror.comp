// Fourth link: reads the picture as a sampled image, writes another, mirrored, as a storage image.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require

layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform texture2D picture;
layout(set = 0, binding = 1, rgba32f) writeonly uniform image2D mirrored;

void main() {
    ivec2 size = imageSize(mirrored), at = ivec2(gl_GlobalInvocationID.xy);
    if (all(lessThan(at, size))) imageStore(mirrored, ivec2(size.x - 1 - at.x, at.y), texelFetch(picture, at, 0));
}
