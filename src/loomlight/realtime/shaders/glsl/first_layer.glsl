#version 450
#extension GL_EXT_samplerless_texture_functions : require
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
struct Layer_0
{
    uint face_0;
    float share_0;
};

layout(std430, binding = 12) buffer StructuredBuffer_Layer_t_0 {
    Layer_0 _data[];
} layers_0;
layout(binding = 14)
uniform utexture2D visible_faces_0;

layout(std430, binding = 8) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} radiance_0;
layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
void main()
{
    uint _S1 = frames_0._data[uint(0)].width_0;
    bool _S2;
    if((gl_GlobalInvocationID.x) >= (frames_0._data[uint(0)].width_0))
    {
        _S2 = true;
    }
    else
    {
        _S2 = (gl_GlobalInvocationID.y) >= (frames_0._data[uint(0)].height_0);
    }
    if(_S2)
    {
        return;
    }
    uint _S3 = gl_GlobalInvocationID.y * _S1 + gl_GlobalInvocationID.x;
    ivec3 _S4 = ivec3(ivec2(gl_GlobalInvocationID.xy), 0);
    layers_0._data[uint(_S3)].face_0 = (texelFetch((visible_faces_0), ((_S4)).xy, ((_S4)).z).x);
    layers_0._data[uint(_S3)].share_0 = 1.0;
    if((frames_0._data[uint(0)].pass_number_0) == 0U)
    {
        radiance_0._data[uint(_S3)] = vec4(0.0);
    }
    return;
}

