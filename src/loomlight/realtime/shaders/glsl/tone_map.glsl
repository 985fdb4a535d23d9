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
layout(std430, binding = 8) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} radiance_0;
layout(std430, binding = 9) buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} pixels_0;
float natural_logarithm_0(float x_0)
{
    uint _S1 = floatBitsToUint(x_0);
    float exponent_0 = float(int(_S1 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S1 & 8388607U) | 1056964608U);
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042)
    {
        float exponent_2 = exponent_0 - 1.0;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0;
    float _S2 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S2 - exponent_1 * 0.00021219444170129 - 0.5 * _S2) + exponent_1 * 0.693359375;
}

float exponential_0(float x_1)
{
    float _S3 = clamp(x_1, -87.0, 88.0);
    float _S4 = floor(_S3 * 1.4426950216293335 + 0.5);
    float _S5 = _S3 - _S4 * 0.693359375 + _S4 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S5 + 0.00139819993637502) * _S5 + 0.00833345204591751) * _S5 + 0.04166579619050026) * _S5 + 0.1666666567325592) * _S5 + 0.5;
    float _S6 = uintBitsToFloat(uint(int(_S4) + 127) << 23);
    float _S7;
    if(x_1 < -87.0)
    {
        _S7 = 0.0;
    }
    else
    {
        _S7 = (p_0 * _S5 * _S5 + _S5 + 1.0) * _S6;
    }
    return _S7;
}

float power_0(float x_2, float exponent_3)
{
    return exponential_0(exponent_3 * natural_logarithm_0(max(x_2, 1.00000000317107685e-30)));
}

uint encoded_0(float linear_0)
{
    float _S8 = clamp(linear_0, 0.0, 1.0);
    float _S9;
    if(_S8 <= 0.00313080009073019)
    {
        _S9 = 12.92000007629394531 * _S8;
    }
    else
    {
        _S9 = 1.0549999475479126 * power_0(_S8, 0.4166666567325592) - 0.05499999970197678;
    }
    return uint(_S9 * 255.0 + 0.5);
}

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
void main()
{
    if((gl_GlobalInvocationID.x) >= (frames_0._data[uint(0)].width_0 * frames_0._data[uint(0)].height_0))
    {
        return;
    }
    vec3 _S10 = radiance_0._data[uint(gl_GlobalInvocationID.x)].xyz * frames_0._data[uint(0)].gain_0;
    pixels_0._data[uint(gl_GlobalInvocationID.x)] = (((encoded_0(_S10.x)) | ((encoded_0(_S10.y)) << 8)) | ((encoded_0(_S10.z)) << 16)) | 4278190080U;
    return;
}

