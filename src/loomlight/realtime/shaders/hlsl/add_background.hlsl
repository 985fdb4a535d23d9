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

struct Layer_0
{
    uint face_0;
    float share_0;
};

RWStructuredBuffer<Layer_0 > layers_0 : register(u2);

StructuredBuffer<uint > scene_words_0 : register(t9);

RWStructuredBuffer<float4 > radiance_0 : register(u0);

float arc_tangent_quotient_0(float x_0, float y_0)
{
    return ((((((0.0f * x_0 + 0.00809729471802711f) * x_0 + -0.0377517081797123f) * x_0 + 0.08475969731807709f) * x_0 + -0.13537675142288208f) * x_0 + 0.19895026087760925f) * x_0 + -0.33327975869178772f) * x_0 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_1, float x_1)
{
    float _S1 = abs(x_1);
    float _S2 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S1, _S2) / max(max(_S1, _S2), 1.00000000317107685e-30f));
    float angle_1;
    if(_S2 > _S1)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_1 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    else
    {
    }
    if(y_1 < 0.0f)
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
    bool _S4 = _S3 > 0.5f;
    float _S5;
    if(_S4)
    {
        _S5 = 0.5f * (1.0f - _S3);
    }
    else
    {
        _S5 = _S3 * _S3;
    }
    float _S6;
    if(_S4)
    {
        _S6 = sqrt(max(_S5, 0.0f));
    }
    else
    {
        _S6 = _S3;
    }
    float _S7 = ((((0.04216320067644119f * _S5 + 0.02418131195008755f) * _S5 + 0.04547002539038658f) * _S5 + 0.07495300471782684f) * _S5 + 0.16666752099990845f) * _S5 * _S6 + _S6;
    if(_S4)
    {
        _S5 = 1.57079637050628662f - 2.0f * _S7;
    }
    else
    {
        _S5 = _S7;
    }
    if(x_2 < 0.0f)
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
    return asfloat(scene_words_0.Load(index_0));
}

float3 camera_forward_0(int _S8)
{
    return float3(frames_0[_S8].forward_x_0, frames_0[_S8].forward_y_0, frames_0[_S8].forward_z_0);
}

float3 camera_right_0(int _S9)
{
    return float3(frames_0[_S9].right_x_0, frames_0[_S9].right_y_0, frames_0[_S9].right_z_0);
}

float3 camera_up_0(int _S10)
{
    return float3(frames_0[_S10].up_x_0, frames_0[_S10].up_y_0, frames_0[_S10].up_z_0);
}

float3 pixel_direction_0(int _S11, uint2 _S12, float2 _S13)
{
    return camera_forward_0(_S11) + ((float(_S12.x) + 0.5f + _S13.x) * 2.0f / float(frames_0[_S11].width_0) - 1.0f) * camera_right_0(_S11) + (1.0f - (float(_S12.y) + 0.5f + _S13.y) * 2.0f / float(frames_0[_S11].height_0)) * camera_up_0(_S11);
}

float3 environment_texel_0(int _S14, uint _S15, uint _S16)
{
    uint _S17 = frames_0[_S14].environment_table_0 + frames_0[_S14].environment_rows_0 + 1U + frames_0[_S14].environment_rows_0 * (frames_0[_S14].environment_columns_0 + 1U) + 3U * (_S15 * frames_0[_S14].environment_columns_0 + _S16);
    return float3(scene_number_0(_S17), scene_number_0(_S17 + 1U), scene_number_0(_S17 + 2U));
}

float3 environment_radiance_0(int _S18, float3 _S19)
{
    float _S20 = _S19.x;
    float _S21 = _S19.z;
    float _S22 = arc_tangent_0(frames_0[_S18].environment_cosine_0 * _S20 - frames_0[_S18].environment_sine_0 * _S21, - (frames_0[_S18].environment_sine_0 * _S20 + frames_0[_S18].environment_cosine_0 * _S21)) / 6.28318548202514648f;
    uint _S23 = frames_0[_S18].environment_columns_0;
    float _S24 = (_S22 - floor(_S22)) * float(frames_0[_S18].environment_columns_0) - 0.5f;
    uint _S25 = frames_0[_S18].environment_rows_0 - 1U;
    float _S26 = clamp((0.5f - arc_sine_0(clamp(_S19.y, -1.0f, 1.0f)) / 3.14159274101257324f) * float(frames_0[_S18].environment_rows_0) - 0.5f, 0.0f, float(_S25));
    float _S27 = floor(_S24);
    uint _S28 = uint(int(_S27) + int(frames_0[_S18].environment_columns_0)) % frames_0[_S18].environment_columns_0;
    uint _S29 = (_S28 + 1U) % _S23;
    uint _S30 = uint(_S26);
    uint _S31 = min(_S30 + 1U, _S25);
    float3 _S32 = (float3)(_S24 - _S27);
    return lerp(lerp(environment_texel_0(_S18, _S30, _S28), environment_texel_0(_S18, _S30, _S29), _S32), lerp(environment_texel_0(_S18, _S31, _S28), environment_texel_0(_S18, _S31, _S29), _S32), (float3)(_S26 - float(_S30)));
}

[numthreads(8, 8, 1)]
void add_background(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S33 = frames_0[int(0)].width_0;
    bool _S34;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S34 = true;
    }
    else
    {
        _S34 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S34)
    {
        return;
    }
    uint _S35 = id_0.y * _S33 + id_0.x;
    float _S36 = layers_0[_S35].share_0;
    if((layers_0[_S35].share_0) <= 0.0f)
    {
        return;
    }
    float3 _S37 = float3(frames_0[int(0)].background_red_0, frames_0[int(0)].background_green_0, frames_0[int(0)].background_blue_0);
    float3 background_0;
    if((frames_0[int(0)].shows_environment_0) != 0U)
    {
        float3 _S38 = environment_radiance_0(int(0), normalize(pixel_direction_0(int(0), id_0.xy, float2(frames_0[int(0)].jitter_x_0, frames_0[int(0)].jitter_y_0))));
        background_0 = _S38;
    }
    else
    {
        background_0 = _S37;
    }
    radiance_0[_S35] = radiance_0[_S35] + float4(_S36 * background_0, 0.0f);
    return;
}

