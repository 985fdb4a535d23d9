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

float3 camera_origin_0(const Frame_0 thread* frame_0)
{
    return float3(frame_0->origin_x_0, frame_0->origin_y_0, frame_0->origin_z_0);
}

float3 camera_right_0(const Frame_0 thread* frame_1)
{
    return float3(frame_1->right_x_0, frame_1->right_y_0, frame_1->right_z_0);
}

float3 camera_up_0(const Frame_0 thread* frame_2)
{
    return float3(frame_2->up_x_0, frame_2->up_y_0, frame_2->up_z_0);
}

float3 camera_forward_0(const Frame_0 thread* frame_3)
{
    return float3(frame_3->forward_x_0, frame_3->forward_y_0, frame_3->forward_z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

float4 to_clip_0(const Frame_0 thread* frame_4, float3 position_0)
{
    float3 _S1 = camera_origin_0(frame_4);
    float3 _S2 = position_0 - _S1;
    float3 _S3 = camera_right_0(frame_4);
    float3 _S4 = camera_up_0(frame_4);
    float3 _S5 = camera_forward_0(frame_4);
    float _S6 = dot(_S2, _S5);
    return float4(dot(_S2, _S3) / square_0(_S3) - 2.0f * frame_4->jitter_x_0 / float(frame_4->width_0) * _S6, dot(_S2, _S4) / square_0(_S4) + 2.0f * frame_4->jitter_y_0 / float(frame_4->height_0) * _S6, frame_4->near_0, _S6);
}

struct raster_vertex_Result_0
{
    float4 position_1 [[position]];
    uint face_0 [[user(FACE)]];
};

struct KernelContext_0
{
    Frame_0 device* frames_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
};

struct RasterOutput_0
{
    float4 position_2;
    [[flat]] uint face_1;
};

[[vertex]] raster_vertex_Result_0 raster_vertex(uint index_0 [[vertex_id]], Frame_0 device* frames_1 [[buffer(4)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]])
{
    thread KernelContext_0 kernelContext_0;
    (&kernelContext_0)->frames_0 = frames_1;
    (&kernelContext_0)->corners_0 = corners_1;
    (&kernelContext_0)->vertices_0 = vertices_1;
    thread RasterOutput_0 output_0;
    Frame_0 _S7 = frames_1[int(0)];
    thread Vertex_0 _S8 = vertices_1[corners_1[index_0]];
    float3 _S9 = position_of_0(&_S8);
    thread Frame_0 _S10 = _S7;
    float4 _S11 = to_clip_0(&_S10, _S9);
    (&output_0)->position_2 = _S11;
    (&output_0)->face_1 = index_0 / 3U;
    thread raster_vertex_Result_0 _S12;
    (&_S12)->position_1 = output_0.position_2;
    (&_S12)->face_0 = output_0.face_1;
    return _S12;
}

