#version 450
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
layout(std430, binding = 11) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} scene_words_0;
layout(std430, binding = 8) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} radiance_0;
float arc_tangent_quotient_0(float x_0, float y_0)
{
    return ((((((0.0 * x_0 + 0.00809729471802711) * x_0 + -0.0377517081797123) * x_0 + 0.08475969731807709) * x_0 + -0.13537675142288208) * x_0 + 0.19895026087760925) * x_0 + -0.33327975869178772) * x_0 + 0.99999970197677612;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0);
}

float arc_tangent_0(float y_1, float x_1)
{
    float _S1 = abs(x_1);
    float _S2 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S1, _S2) / max(max(_S1, _S2), 1.00000000317107685e-30));
    float angle_1;
    if(_S2 > _S1)
    {
        angle_1 = 1.57079637050628662 - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_1 < 0.0)
    {
        angle_1 = 3.14159274101257324 - angle_1;
    }
    else
    {
    }
    if(y_1 < 0.0)
    {
        angle_1 = - angle_1;
    }
    else
    {
    }
    return angle_1;
}

float arc_sine_0(float x_2)
{
    float _S3 = abs(x_2);
    bool _S4 = _S3 > 0.5;
    float _S5;
    if(_S4)
    {
        _S5 = 0.5 * (1.0 - _S3);
    }
    else
    {
        _S5 = _S3 * _S3;
    }
    float _S6;
    if(_S4)
    {
        _S6 = sqrt(max(_S5, 0.0));
    }
    else
    {
        _S6 = _S3;
    }
    float _S7 = ((((0.04216320067644119 * _S5 + 0.02418131195008755) * _S5 + 0.04547002539038658) * _S5 + 0.07495300471782684) * _S5 + 0.16666752099990845) * _S5 * _S6 + _S6;
    if(_S4)
    {
        _S5 = 1.57079637050628662 - 2.0 * _S7;
    }
    else
    {
        _S5 = _S7;
    }
    if(x_2 < 0.0)
    {
        _S5 = - _S5;
    }
    else
    {
    }
    return _S5;
}

float scene_number_0(uint index_0)
{
    return uintBitsToFloat(scene_words_0._data[uint(index_0)]);
}

vec3 camera_forward_0(int _S8)
{
    return vec3(frames_0._data[uint(_S8)].forward_x_0, frames_0._data[uint(_S8)].forward_y_0, frames_0._data[uint(_S8)].forward_z_0);
}

vec3 camera_right_0(int _S9)
{
    return vec3(frames_0._data[uint(_S9)].right_x_0, frames_0._data[uint(_S9)].right_y_0, frames_0._data[uint(_S9)].right_z_0);
}

vec3 camera_up_0(int _S10)
{
    return vec3(frames_0._data[uint(_S10)].up_x_0, frames_0._data[uint(_S10)].up_y_0, frames_0._data[uint(_S10)].up_z_0);
}

vec3 pixel_direction_0(int _S11, uvec2 _S12, vec2 _S13)
{
    return camera_forward_0(_S11) + ((float(_S12.x) + 0.5 + _S13.x) * 2.0 / float(frames_0._data[uint(_S11)].width_0) - 1.0) * camera_right_0(_S11) + (1.0 - (float(_S12.y) + 0.5 + _S13.y) * 2.0 / float(frames_0._data[uint(_S11)].height_0)) * camera_up_0(_S11);
}

vec3 environment_texel_0(int _S14, uint _S15, uint _S16)
{
    uint _S17 = frames_0._data[uint(_S14)].environment_table_0 + frames_0._data[uint(_S14)].environment_rows_0 + 1U + frames_0._data[uint(_S14)].environment_rows_0 * (frames_0._data[uint(_S14)].environment_columns_0 + 1U) + 3U * (_S15 * frames_0._data[uint(_S14)].environment_columns_0 + _S16);
    return vec3(scene_number_0(_S17), scene_number_0(_S17 + 1U), scene_number_0(_S17 + 2U));
}

vec3 environment_radiance_0(int _S18, vec3 _S19)
{
    float _S20 = _S19.x;
    float _S21 = _S19.z;
    float _S22 = arc_tangent_0(frames_0._data[uint(_S18)].environment_cosine_0 * _S20 - frames_0._data[uint(_S18)].environment_sine_0 * _S21, - (frames_0._data[uint(_S18)].environment_sine_0 * _S20 + frames_0._data[uint(_S18)].environment_cosine_0 * _S21)) / 6.28318548202514648;
    uint _S23 = frames_0._data[uint(_S18)].environment_columns_0;
    float _S24 = (_S22 - floor(_S22)) * float(frames_0._data[uint(_S18)].environment_columns_0) - 0.5;
    uint _S25 = frames_0._data[uint(_S18)].environment_rows_0 - 1U;
    float _S26 = clamp((0.5 - arc_sine_0(clamp(_S19.y, -1.0, 1.0)) / 3.14159274101257324) * float(frames_0._data[uint(_S18)].environment_rows_0) - 0.5, 0.0, float(_S25));
    float _S27 = floor(_S24);
    uint _S28 = uint(int(_S27) + int(frames_0._data[uint(_S18)].environment_columns_0)) % frames_0._data[uint(_S18)].environment_columns_0;
    uint _S29 = (_S28 + 1U) % _S23;
    uint _S30 = uint(_S26);
    uint _S31 = min(_S30 + 1U, _S25);
    vec3 _S32 = vec3(_S24 - _S27);
    return mix(mix(environment_texel_0(_S18, _S30, _S28), environment_texel_0(_S18, _S30, _S29), _S32), mix(environment_texel_0(_S18, _S31, _S28), environment_texel_0(_S18, _S31, _S29), _S32), vec3(_S26 - float(_S30)));
}

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
void main()
{
    uint _S33 = frames_0._data[uint(0)].width_0;
    bool _S34;
    if((gl_GlobalInvocationID.x) >= (frames_0._data[uint(0)].width_0))
    {
        _S34 = true;
    }
    else
    {
        _S34 = (gl_GlobalInvocationID.y) >= (frames_0._data[uint(0)].height_0);
    }
    if(_S34)
    {
        return;
    }
    uint _S35 = gl_GlobalInvocationID.y * _S33 + gl_GlobalInvocationID.x;
    float _S36 = layers_0._data[uint(_S35)].share_0;
    if((layers_0._data[uint(_S35)].share_0) <= 0.0)
    {
        return;
    }
    vec3 _S37 = vec3(frames_0._data[uint(0)].background_red_0, frames_0._data[uint(0)].background_green_0, frames_0._data[uint(0)].background_blue_0);
    vec3 background_0;
    if((frames_0._data[uint(0)].shows_environment_0) != 0U)
    {
        vec3 _S38 = environment_radiance_0(0, normalize(pixel_direction_0(0, gl_GlobalInvocationID.xy, vec2(frames_0._data[uint(0)].jitter_x_0, frames_0._data[uint(0)].jitter_y_0))));
        background_0 = _S38;
    }
    else
    {
        background_0 = _S37;
    }
    radiance_0._data[uint(_S35)] = radiance_0._data[uint(_S35)] + vec4(_S36 * background_0, 0.0);
    return;
}

