// Third link: hands on the position and the color; `unread` is for nobody.
#version 460
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
layout(location = 2) in vec4 extra;
layout(location = 0) out vec4 out_color;
layout(location = 1) out vec4 unread;

void main() {
    gl_Position = position;
    out_color = color;
    unread = extra;
}
