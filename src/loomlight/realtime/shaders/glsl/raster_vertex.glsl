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
    uint environment_samples_0;
    uint environment_columns_0;
    uint environment_rows_0;
    uint environment_table_0;
    float environment_total_0;
    float environment_sine_0;
    float environment_cosine_0;
    uint shows_environment_0;
    uint casts_shadows_0;
    uint leaves_0;
    uint leaf_faces_0;
    float ray_offset_0;
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

float square_0(vec3 v_1)
{
    return dot(v_1, v_1);
}

flat layout(location = 0)
out uint entryPointParam_raster_vertex_face_0;

struct RasterOutput_0
{
    vec4 position_0;
    uint face_0;
};

vec3 camera_origin_0(int _S1)
{
    return vec3(frames_0._data[uint(_S1)].origin_x_0, frames_0._data[uint(_S1)].origin_y_0, frames_0._data[uint(_S1)].origin_z_0);
}

vec3 camera_right_0(int _S2)
{
    return vec3(frames_0._data[uint(_S2)].right_x_0, frames_0._data[uint(_S2)].right_y_0, frames_0._data[uint(_S2)].right_z_0);
}

vec3 camera_up_0(int _S3)
{
    return vec3(frames_0._data[uint(_S3)].up_x_0, frames_0._data[uint(_S3)].up_y_0, frames_0._data[uint(_S3)].up_z_0);
}

vec3 camera_forward_0(int _S4)
{
    return vec3(frames_0._data[uint(_S4)].forward_x_0, frames_0._data[uint(_S4)].forward_y_0, frames_0._data[uint(_S4)].forward_z_0);
}

vec4 to_clip_0(int _S5, vec3 _S6)
{
    vec3 _S7 = _S6 - camera_origin_0(_S5);
    vec3 _S8 = camera_right_0(_S5);
    vec3 _S9 = camera_up_0(_S5);
    float _S10 = dot(_S7, camera_forward_0(_S5));
    return vec4(dot(_S7, _S8) / square_0(_S8) - 2.0 * frames_0._data[uint(_S5)].jitter_x_0 / float(frames_0._data[uint(_S5)].width_0) * _S10, dot(_S7, _S9) / square_0(_S9) + 2.0 * frames_0._data[uint(_S5)].jitter_y_0 / float(frames_0._data[uint(_S5)].height_0) * _S10, frames_0._data[uint(_S5)].near_0, _S10);
}

void main()
{
    RasterOutput_0 output_0;
    output_0.position_0 = to_clip_0(0, position_of_0(vertices_0._data[uint(corners_0._data[uint(uint(gl_VertexIndex - gl_BaseVertex))])]));
    output_0.face_0 = uint(gl_VertexIndex - gl_BaseVertex) / 3U;
    RasterOutput_0 _S11 = output_0;
    gl_Position = output_0.position_0;
    entryPointParam_raster_vertex_face_0 = _S11.face_0;
    return;
}

