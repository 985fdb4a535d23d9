#pragma pack_matrix(column_major)
#ifdef SLANG_HLSL_ENABLE_NVAPI
#include "nvHLSLExtns.h"
#endif

#ifndef __DXC_VERSION_MAJOR
// warning X3557: loop doesn't seem to do anything, forcing loop to unroll
#pragma warning(disable : 3557)
#endif

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

StructuredBuffer<Frame_0 > frames_0 : register(t4);

RWStructuredBuffer<float4 > radiance_0 : register(u0);

RWStructuredBuffer<uint > pixels_0 : register(u1);

float natural_logarithm_0(float x_0)
{
    uint _S1 = asuint(x_0);
    float exponent_0 = float(int(_S1 >> int(23)) - int(126));
    float m_0 = asfloat((_S1 & 8388607U) | 1056964608U);
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042f)
    {
        float exponent_2 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0f;
    float _S2 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S2 - exponent_1 * 0.00021219444170129f - 0.5f * _S2) + exponent_1 * 0.693359375f;
}

float exponential_0(float x_1)
{
    float _S3 = clamp(x_1, -87.0f, 88.0f);
    float _S4 = floor(_S3 * 1.4426950216293335f + 0.5f);
    float _S5 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f;
    float _S6 = asfloat(uint(int(_S4) + int(127)) << int(23));
    float _S7;
    if(x_1 < -87.0f)
    {
        _S7 = 0.0f;
    }
    else
    {
        _S7 = (p_0 * _S5 * _S5 + _S5 + 1.0f) * _S6;
    }
    return _S7;
}

float power_0(float x_2, float exponent_3)
{
    return exponential_0(exponent_3 * natural_logarithm_0(max(x_2, 1.00000000317107685e-30f)));
}

uint encoded_0(float linear_0)
{
    float _S8 = clamp(linear_0, 0.0f, 1.0f);
    float _S9;
    if(_S8 <= 0.00313080009073019f)
    {
        _S9 = 12.92000007629394531f * _S8;
    }
    else
    {
        _S9 = 1.0549999475479126f * power_0(_S8, 0.4166666567325592f) - 0.05499999970197678f;
    }
    return uint(_S9 * 255.0f + 0.5f);
}

[numthreads(64, 1, 1)]
void tone_map(uint3 id_0 : SV_DispatchThreadID)
{
    if((id_0.x) >= (frames_0[int(0)].width_0 * frames_0[int(0)].height_0))
    {
        return;
    }
    float3 _S10 = radiance_0[id_0.x].xyz * frames_0[int(0)].gain_0;
    pixels_0[id_0.x] = (((encoded_0(_S10.x)) | ((encoded_0(_S10.y)) << int(8))) | ((encoded_0(_S10.z)) << int(16))) | 4278190080U;
    return;
}

