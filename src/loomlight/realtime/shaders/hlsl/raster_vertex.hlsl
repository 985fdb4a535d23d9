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

StructuredBuffer<uint > corners_0 : register(t6);

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

StructuredBuffer<Vertex_0 > vertices_0 : register(t5);

float3 position_of_0(Vertex_0 vertex_0)
{
    return float3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

struct RasterOutput_0
{
    float4 position_0 : SV_Position;
    nointerpolation uint face_0 : FACE;
};

float3 camera_origin_0(int _S1)
{
    return float3(frames_0[_S1].origin_x_0, frames_0[_S1].origin_y_0, frames_0[_S1].origin_z_0);
}

float3 camera_right_0(int _S2)
{
    return float3(frames_0[_S2].right_x_0, frames_0[_S2].right_y_0, frames_0[_S2].right_z_0);
}

float3 camera_up_0(int _S3)
{
    return float3(frames_0[_S3].up_x_0, frames_0[_S3].up_y_0, frames_0[_S3].up_z_0);
}

float3 camera_forward_0(int _S4)
{
    return float3(frames_0[_S4].forward_x_0, frames_0[_S4].forward_y_0, frames_0[_S4].forward_z_0);
}

float4 to_clip_0(int _S5, float3 _S6)
{
    float3 _S7 = _S6 - camera_origin_0(_S5);
    float3 _S8 = camera_right_0(_S5);
    float3 _S9 = camera_up_0(_S5);
    float _S10 = dot(_S7, camera_forward_0(_S5));
    return float4(dot(_S7, _S8) / square_0(_S8) - 2.0f * frames_0[_S5].jitter_x_0 / float(frames_0[_S5].width_0) * _S10, dot(_S7, _S9) / square_0(_S9) + 2.0f * frames_0[_S5].jitter_y_0 / float(frames_0[_S5].height_0) * _S10, frames_0[_S5].near_0, _S10);
}

RasterOutput_0 raster_vertex(uint index_0 : SV_VertexID)
{
    RasterOutput_0 output_0;
    output_0.position_0 = to_clip_0(int(0), position_of_0(vertices_0.Load(corners_0.Load(index_0))));
    output_0.face_0 = index_0 / 3U;
    return output_0;
}

