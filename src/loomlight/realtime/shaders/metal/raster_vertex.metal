#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
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

float3 position_of_0(const Vertex_0 thread* vertex_0)
{
    return float3(vertex_0->x_0, vertex_0->y_0, vertex_0->z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

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

struct KernelContext_0
{
    Frame_0 device* frames_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
};

float3 camera_origin_0(int _S1, KernelContext_0 thread* kernelContext_0)
{
    Frame_0 device* _S2 = kernelContext_0->frames_0+_S1;
    return float3(_S2->origin_x_0, _S2->origin_y_0, _S2->origin_z_0);
}

float3 camera_right_0(int _S3, KernelContext_0 thread* kernelContext_1)
{
    Frame_0 device* _S4 = kernelContext_1->frames_0+_S3;
    return float3(_S4->right_x_0, _S4->right_y_0, _S4->right_z_0);
}

float3 camera_up_0(int _S5, KernelContext_0 thread* kernelContext_2)
{
    Frame_0 device* _S6 = kernelContext_2->frames_0+_S5;
    return float3(_S6->up_x_0, _S6->up_y_0, _S6->up_z_0);
}

float3 camera_forward_0(int _S7, KernelContext_0 thread* kernelContext_3)
{
    Frame_0 device* _S8 = kernelContext_3->frames_0+_S7;
    return float3(_S8->forward_x_0, _S8->forward_y_0, _S8->forward_z_0);
}

float4 to_clip_0(int _S9, float3 _S10, KernelContext_0 thread* kernelContext_4)
{
    Frame_0 device* _S11 = kernelContext_4->frames_0+_S9;
    float3 _S12 = camera_origin_0(_S9, kernelContext_4);
    float3 _S13 = _S10 - _S12;
    float3 _S14 = camera_right_0(_S9, kernelContext_4);
    float3 _S15 = camera_up_0(_S9, kernelContext_4);
    float3 _S16 = camera_forward_0(_S9, kernelContext_4);
    float _S17 = dot(_S13, _S16);
    return float4(dot(_S13, _S14) / square_0(_S14) - 2.0f * _S11->jitter_x_0 / float(_S11->width_0) * _S17, dot(_S13, _S15) / square_0(_S15) + 2.0f * _S11->jitter_y_0 / float(_S11->height_0) * _S17, _S11->near_0, _S17);
}

struct raster_vertex_Result_0
{
    float4 position_0 [[position]];
    uint face_0 [[user(FACE)]];
};

struct RasterOutput_0
{
    float4 position_1;
    [[flat]] uint face_1;
};

[[vertex]] raster_vertex_Result_0 raster_vertex(uint index_0 [[vertex_id]], Frame_0 device* frames_1 [[buffer(4)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]])
{
    thread KernelContext_0 kernelContext_5;
    (&kernelContext_5)->frames_0 = frames_1;
    (&kernelContext_5)->corners_0 = corners_1;
    (&kernelContext_5)->vertices_0 = vertices_1;
    thread RasterOutput_0 output_0;
    thread Vertex_0 _S18 = vertices_1[corners_1[index_0]];
    float3 _S19 = position_of_0(&_S18);
    float4 _S20 = to_clip_0(int(0), _S19, &kernelContext_5);
    (&output_0)->position_1 = _S20;
    (&output_0)->face_1 = index_0 / 3U;
    thread raster_vertex_Result_0 _S21;
    (&_S21)->position_0 = output_0.position_1;
    (&_S21)->face_0 = output_0.face_1;
    return _S21;
}

