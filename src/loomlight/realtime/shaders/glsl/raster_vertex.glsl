#version 460
#extension GL_ARB_shader_draw_parameters : require
layout(row_major) uniform;
layout(row_major) buffer;
struct Frame_0
{
    uint width_0;
    uint height_0;
    uint lights_0;
    uint samples_0;
    uint pass_number_0;
    float jitter_x_0;
    float jitter_y_0;
    float gain_0;
    float origin_x_0;
    float origin_y_0;
    float origin_z_0;
    float right_x_0;
    float right_y_0;
    float right_z_0;
    float up_x_0;
    float up_y_0;
    float up_z_0;
    float forward_x_0;
    float forward_y_0;
    float forward_z_0;
    float near_0;
    float background_red_0;
    float background_green_0;
    float background_blue_0;
};

layout(std430, binding = 4) readonly buffer StructuredBuffer_Frame_t_0 {
    Frame_0 _data[];
} frames_0;
layout(std430, binding = 6) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} corners_0;
struct Vertex_0
{
    float x_0;
    float y_0;
    float z_0;
    float normal_x_0;
    float normal_y_0;
    float normal_z_0;
    float u_0;
    float v_0;
};

layout(std430, binding = 5) readonly buffer StructuredBuffer_Vertex_t_0 {
    Vertex_0 _data[];
} vertices_0;
vec3 position_of_0(Vertex_0 vertex_0)
{
    return vec3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

vec3 camera_origin_0(Frame_0 frame_0)
{
    return vec3(frame_0.origin_x_0, frame_0.origin_y_0, frame_0.origin_z_0);
}

vec3 camera_right_0(Frame_0 frame_1)
{
    return vec3(frame_1.right_x_0, frame_1.right_y_0, frame_1.right_z_0);
}

vec3 camera_up_0(Frame_0 frame_2)
{
    return vec3(frame_2.up_x_0, frame_2.up_y_0, frame_2.up_z_0);
}

vec3 camera_forward_0(Frame_0 frame_3)
{
    return vec3(frame_3.forward_x_0, frame_3.forward_y_0, frame_3.forward_z_0);
}

float square_0(vec3 v_1)
{
    return dot(v_1, v_1);
}

vec4 to_clip_0(Frame_0 frame_4, vec3 position_0)
{
    vec3 _S1 = position_0 - camera_origin_0(frame_4);
    vec3 _S2 = camera_right_0(frame_4);
    vec3 _S3 = camera_up_0(frame_4);
    float _S4 = dot(_S1, camera_forward_0(frame_4));
    return vec4(dot(_S1, _S2) / square_0(_S2) - 2.0 * frame_4.jitter_x_0 / float(frame_4.width_0) * _S4, dot(_S1, _S3) / square_0(_S3) + 2.0 * frame_4.jitter_y_0 / float(frame_4.height_0) * _S4, frame_4.near_0, _S4);
}

flat layout(location = 0)
out uint entryPointParam_raster_vertex_face_0;

struct RasterOutput_0
{
    vec4 position_1;
    uint face_0;
};

void main()
{
    RasterOutput_0 output_0;
    output_0.position_1 = to_clip_0(frames_0._data[uint(0)], position_of_0(vertices_0._data[uint(corners_0._data[uint(uint(gl_VertexIndex - gl_BaseVertex))])]));
    output_0.face_0 = uint(gl_VertexIndex - gl_BaseVertex) / 3U;
    RasterOutput_0 _S5 = output_0;
    gl_Position = output_0.position_1;
    entryPointParam_raster_vertex_face_0 = _S5.face_0;
    return;
}

