#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
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
    if(y_1 < 0.0f)
    {
        angle_1 = - angle_1;
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
    return _S5;
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

struct Layer_0
{
    uint face_0;
    float share_0;
};

struct KernelContext_0
{
    Frame_0 device* frames_0;
    Layer_0 device* layers_0;
    uint device* scene_words_0;
    packed_float4 device* radiance_0;
};

float scene_number_0(uint index_0, KernelContext_0 thread* kernelContext_0)
{
    return (as_type<float>((kernelContext_0->scene_words_0[index_0])));
}

float3 camera_forward_0(int _S8, KernelContext_0 thread* kernelContext_1)
{
    Frame_0 device* _S9 = kernelContext_1->frames_0+_S8;
    return float3(_S9->forward_x_0, _S9->forward_y_0, _S9->forward_z_0);
}

float3 camera_right_0(int _S10, KernelContext_0 thread* kernelContext_2)
{
    Frame_0 device* _S11 = kernelContext_2->frames_0+_S10;
    return float3(_S11->right_x_0, _S11->right_y_0, _S11->right_z_0);
}

float3 camera_up_0(int _S12, KernelContext_0 thread* kernelContext_3)
{
    Frame_0 device* _S13 = kernelContext_3->frames_0+_S12;
    return float3(_S13->up_x_0, _S13->up_y_0, _S13->up_z_0);
}

float3 pixel_direction_0(int _S14, uint2 _S15, float2 _S16, KernelContext_0 thread* kernelContext_4)
{
    Frame_0 device* _S17 = kernelContext_4->frames_0+_S14;
    float _S18 = (float(_S15.x) + 0.5f + _S16.x) * 2.0f / float(_S17->width_0) - 1.0f;
    float _S19 = 1.0f - (float(_S15.y) + 0.5f + _S16.y) * 2.0f / float(_S17->height_0);
    float3 _S20 = camera_forward_0(_S14, kernelContext_4);
    float3 _S21 = camera_right_0(_S14, kernelContext_4);
    float3 _S22 = _S20 + float3(_S18)  * _S21;
    float3 _S23 = camera_up_0(_S14, kernelContext_4);
    return _S22 + float3(_S19)  * _S23;
}

float3 environment_texel_0(int _S24, uint _S25, uint _S26, KernelContext_0 thread* kernelContext_5)
{
    Frame_0 device* _S27 = kernelContext_5->frames_0+_S24;
    uint _S28 = _S27->environment_table_0 + _S27->environment_rows_0 + 1U + _S27->environment_rows_0 * (_S27->environment_columns_0 + 1U) + 3U * (_S25 * _S27->environment_columns_0 + _S26);
    float _S29 = scene_number_0(_S28, kernelContext_5);
    float _S30 = scene_number_0(_S28 + 1U, kernelContext_5);
    float _S31 = scene_number_0(_S28 + 2U, kernelContext_5);
    return float3(_S29, _S30, _S31);
}

float3 environment_radiance_0(int _S32, float3 _S33, KernelContext_0 thread* kernelContext_6)
{
    Frame_0 device* _S34 = kernelContext_6->frames_0+_S32;
    float _S35 = _S33.x;
    float _S36 = _S33.z;
    float _S37 = arc_tangent_0(_S34->environment_cosine_0 * _S35 - _S34->environment_sine_0 * _S36, - (_S34->environment_sine_0 * _S35 + _S34->environment_cosine_0 * _S36)) / 6.28318548202514648f;
    uint _S38 = _S34->environment_columns_0;
    float _S39 = (_S37 - floor(_S37)) * float(_S34->environment_columns_0) - 0.5f;
    uint _S40 = _S34->environment_rows_0 - 1U;
    float _S41 = clamp((0.5f - arc_sine_0(clamp(_S33.y, -1.0f, 1.0f)) / 3.14159274101257324f) * float(_S34->environment_rows_0) - 0.5f, 0.0f, float(_S40));
    float _S42 = floor(_S39);
    uint _S43 = uint(int(_S42) + int(_S34->environment_columns_0)) % _S34->environment_columns_0;
    uint _S44 = (_S43 + 1U) % _S38;
    uint _S45 = uint(_S41);
    uint _S46 = min(_S45 + 1U, _S40);
    float _S47 = _S39 - _S42;
    float3 _S48 = environment_texel_0(_S32, _S45, _S43, kernelContext_6);
    float3 _S49 = environment_texel_0(_S32, _S45, _S44, kernelContext_6);
    float3 _S50 = float3(_S47) ;
    float3 _S51 = mix(_S48, _S49, _S50);
    float3 _S52 = environment_texel_0(_S32, _S46, _S43, kernelContext_6);
    float3 _S53 = environment_texel_0(_S32, _S46, _S44, kernelContext_6);
    return mix(_S51, mix(_S52, _S53, _S50), float3((_S41 - float(_S45))) );
}

[[kernel]] void add_background(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], uint device* scene_words_1 [[buffer(11)]], packed_float4 device* radiance_1 [[buffer(8)]])
{
    thread KernelContext_0 kernelContext_7;
    (&kernelContext_7)->frames_0 = frames_1;
    (&kernelContext_7)->layers_0 = layers_1;
    (&kernelContext_7)->scene_words_0 = scene_words_1;
    (&kernelContext_7)->radiance_0 = radiance_1;
    Frame_0 device* _S54 = frames_1+int(0);
    uint _S55 = id_0.x;
    uint _S56 = _S54->width_0;
    bool _S57;
    if(_S55 >= (_S54->width_0))
    {
        _S57 = true;
    }
    else
    {
        _S57 = (id_0.y) >= (_S54->height_0);
    }
    if(_S57)
    {
        return;
    }
    uint _S58 = id_0.y * _S56 + _S55;
    float _S59 = ((&kernelContext_7)->layers_0+_S58)->share_0;
    if((((&kernelContext_7)->layers_0+_S58)->share_0) <= 0.0f)
    {
        return;
    }
    float3 _S60 = float3(_S54->background_red_0, _S54->background_green_0, _S54->background_blue_0);
    float3 background_0;
    if((_S54->shows_environment_0) != 0U)
    {
        float3 _S61 = pixel_direction_0(int(0), id_0.xy, float2(_S54->jitter_x_0, _S54->jitter_y_0), &kernelContext_7);
        float3 _S62 = environment_radiance_0(int(0), normalize(_S61), &kernelContext_7);
        background_0 = _S62;
    }
    else
    {
        background_0 = _S60;
    }
    packed_float4 device* _S63 = (&kernelContext_7)->radiance_0+_S58;
    *_S63 = packed_float4((float4(*_S63)  + float4(float3(_S59)  * background_0, 0.0f))) ;
    return;
}

