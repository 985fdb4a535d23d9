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

Texture2D<uint > visible_faces_0 : register(t13);

RWStructuredBuffer<float4 > radiance_0 : register(u0);

[numthreads(8, 8, 1)]
void first_layer(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S1 = frames_0[int(0)].width_0;
    bool _S2;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S2 = true;
    }
    else
    {
        _S2 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S2)
    {
        return;
    }
    uint _S3 = id_0.y * _S1 + id_0.x;
    layers_0[_S3].face_0 = visible_faces_0.Load(int3(int2(id_0.xy), int(0)));
    layers_0[_S3].share_0 = 1.0f;
    if((frames_0[int(0)].pass_number_0) == 0U)
    {
        radiance_0[_S3] = (float4)0.0f;
    }
    return;
}

