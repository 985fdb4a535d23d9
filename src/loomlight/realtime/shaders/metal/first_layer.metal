#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
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

struct Layer_0
{
    uint face_0;
    float share_0;
};

struct KernelContext_0
{
    Frame_0 device* frames_0;
    Layer_0 device* layers_0;
    texture2d<uint, access::sample> visible_faces_0;
    packed_float4 device* radiance_0;
};

[[kernel]] void first_layer(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], texture2d<uint, access::sample> visible_faces_1 [[texture(0)]], packed_float4 device* radiance_1 [[buffer(8)]])
{
    thread KernelContext_0 kernelContext_0;
    (&kernelContext_0)->frames_0 = frames_1;
    (&kernelContext_0)->layers_0 = layers_1;
    (&kernelContext_0)->visible_faces_0 = visible_faces_1;
    (&kernelContext_0)->radiance_0 = radiance_1;
    Frame_0 device* _S1 = frames_1+int(0);
    uint _S2 = id_0.x;
    uint _S3 = _S1->width_0;
    bool _S4;
    if(_S2 >= (_S1->width_0))
    {
        _S4 = true;
    }
    else
    {
        _S4 = (id_0.y) >= (_S1->height_0);
    }
    if(_S4)
    {
        return;
    }
    uint _S5 = id_0.y * _S3 + _S2;
    int3 _S6 = int3(int2(id_0.xy), int(0));
    ((&kernelContext_0)->layers_0+_S5)->face_0 = (((&kernelContext_0)->visible_faces_0).read(vec<uint,2>(((_S6)).xy), uint(((_S6)).z)).x);
    ((&kernelContext_0)->layers_0+_S5)->share_0 = 1.0f;
    if((_S1->pass_number_0) == 0U)
    {
        *((&kernelContext_0)->radiance_0+_S5) = packed_float4(float4(0.0f) ) ;
    }
    return;
}

