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

StructuredBuffer<uint > face_fabrics_0 : register(t7);

struct Lobes_0
{
    uint is_baked_0;
    float inverse_base_size_0;
    float last_level_0;
    uint levels_0;
    uint face_nodes_0;
    uint packs_0;
    uint front_warp_packs_0;
    uint back_warp_packs_0;
    uint coverage_0;
    uint coverage_holes_0;
    uint projected_area_0;
    uint light_visibility_0;
    uint irradiance_0;
    uint moments_0;
    float front_hole_weight_0;
    float back_hole_weight_0;
    float threads_per_mm_0;
    float unit_level_0;
};

struct Woven_0
{
    uint is_encoded_0;
    uint network_0;
    uint latents_0;
    uint texels_0;
    uint levels_1;
    uint top_level_0;
    float ends_0;
    float picks_0;
    float ends_per_mm_0;
    float picks_per_mm_0;
    float pitch_0;
    float warp_x_0;
    float warp_y_0;
    float warp_roughness_0;
    float weft_x_0;
    float weft_y_0;
    float weft_roughness_0;
    float warp_lobe_roughness_0;
    float weft_lobe_roughness_0;
    uint bundles_0;
    uint is_corrected_0;
    uint correction_0;
};

struct Neumip_0
{
    uint is_trained_0;
    uint decoder_0;
    uint has_offset_0;
    uint offset_0;
    uint offset_texels_0;
    uint features_0;
    uint texel_elements_0;
    uint levels_2;
    float last_level_1;
    uint face_texels_0;
    uint back_0;
    float repeats_per_x_0;
    float repeats_per_y_0;
    float texels_per_mm_0;
    float unit_x_0;
    float unit_y_0;
};

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Woven_0 woven_0;
    Neumip_0 neumip_0;
    uint run_words_0;
    uint ends_1;
    uint max_heights_0;
    uint max_height_columns_0;
    float height_low_0;
    float height_high_0;
    float lift_0;
    float threads_per_x_0;
    float threads_per_y_0;
    float per_relief_0;
    float diffuse_blend_0;
    float optical_depth_0;
    float sheen_strength_0;
    float sheen_roughness_0;
    float fibre_noise_0;
    float colour_noise_0;
    uint seed_0;
    float layer_bound_0;
    float fibre_size_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
};

StructuredBuffer<Fabric_0 > fabrics_0 : register(t0);

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

StructuredBuffer<uint > scene_words_0 : register(t9);

StructuredBuffer<uint4 > packed_numbers_0 : register(t8);

StructuredBuffer<uint > words_0 : register(t2);

struct Family_0
{
    uint is_alike_0;
    float count_0;
    float inverse_count_0;
    float half_inverse_count_0;
    float size_0;
    float inverse_size_0;
    float half_width_0;
    float start_0;
    float period_0;
    float inverse_period_0;
    float bins_0;
    uint first_thread_table_0;
    uint place_table_0;
    uint bend_table_0;
    float height_scale_0;
    float twist_sine_0;
    float twist_cosine_0;
    float level_0;
    float roughness_0;
    uint albedo_table_0;
    uint albedo_stride_0;
    uint before_0;
    float visible_total_0;
    float smallest_box_0;
    uint quantities_0;
    uint colour_mean_0;
    uint colour_axes_0;
    uint colour_threads_0;
    uint colour_areas_0;
    float area_unit_0;
    float crossing_area_0;
};

StructuredBuffer<Family_0 > families_0 : register(t1);

RWStructuredBuffer<float > visibilities_0 : register(u3);

struct Light_0
{
    uint is_point_0;
    float x_1;
    float y_1;
    float z_1;
    float red_0;
    float green_0;
    float blue_0;
};

StructuredBuffer<Light_0 > lights_1 : register(t3);

RWStructuredBuffer<float4 > radiance_0 : register(u0);

struct FloatWeights_0
{
    uint first_0;
};

struct Eight_0
{
    float4 low_0;
    float4 high_0;
};

Eight_0 FloatWeights_eight_0(FloatWeights_0 this_0, uint element_0)
{
    Eight_0 numbers_0;
    uint _S1 = this_0.first_0 + 2U * element_0;
    numbers_0.low_0 = asfloat(packed_numbers_0.Load(_S1));
    numbers_0.high_0 = asfloat(packed_numbers_0.Load(_S1 + 1U));
    return numbers_0;
}

float4 tile_product_0(FloatWeights_0 weights_0, uint row_0, inout float  inputs_0[int(96)])
{
    float4 sums_0 = (float4)0.0f;
    uint column_0 = 0U;
    for(;;)
    {
        if(column_0 < 12U)
        {
        }
        else
        {
            break;
        }
        float4 low_1;
        float4 high_1;
        int _S2 = int(8U * column_0);
        low_1[int(0)] = inputs_0[_S2];
        high_1[int(0)] = inputs_0[_S2 + int(4)];
        int _S3 = _S2 + int(1);
        low_1[int(1)] = inputs_0[_S3];
        high_1[int(1)] = inputs_0[_S3 + int(4)];
        int _S4 = _S2 + int(2);
        low_1[int(2)] = inputs_0[_S4];
        high_1[int(2)] = inputs_0[_S4 + int(4)];
        int _S5 = _S2 + int(3);
        low_1[int(3)] = inputs_0[_S5];
        high_1[int(3)] = inputs_0[_S5 + int(4)];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_0[int(0)] = sums_0[int(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_0[int(1)] = sums_0[int(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        sums_0[int(2)] = sums_0[int(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        sums_0[int(3)] = sums_0[int(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

float Identity_apply_0(float x_2)
{
    return x_2;
}

void dense_part_0(FloatWeights_0 weights_1, uint first_1, bool adds_0, inout float  inputs_1[int(96)], inout float  outputs_0[int(50)])
{
    uint _S10 = first_1 + uint(whole_parts_0(int(7)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S11 = output_0 < int(50);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U);
        float4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 12U, inputs_1);
        float4 _S15;
        if((output_0 & int(4)) != int(0))
        {
            _S15 = _S13.high_0;
        }
        else
        {
            _S15 = _S13.low_0;
        }
        float4 _S16 = _S14 + _S15;
        float _S17;
        if(_S11)
        {
            if(adds_0)
            {
                _S17 = outputs_0[output_0];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[output_0] = Identity_apply_0(_S16[int(0)] + _S17);
        }
        int _S18 = output_0 + int(1);
        if(_S18 < int(50))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S18] = Identity_apply_0(_S16[int(1)] + _S17);
        }
        int _S19 = output_0 + int(2);
        if(_S19 < int(50))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S19] = Identity_apply_0(_S16[int(2)] + _S17);
        }
        int _S20 = output_0 + int(3);
        if(_S20 < int(50))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S20] = Identity_apply_0(_S16[int(3)] + _S17);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

struct HalfWeights_0
{
    uint first_2;
};

Eight_0 eight_halves_0(uint4 packed_0)
{
    Eight_0 numbers_1;
    uint _S21 = packed_0.x;
    uint _S22 = packed_0.y;
    numbers_1.low_0 = float4(f16tof32(uint2(_S21 & 65535U, _S21 >> 16U)), f16tof32(uint2(_S22 & 65535U, _S22 >> 16U)));
    uint _S23 = packed_0.z;
    uint _S24 = packed_0.w;
    numbers_1.high_0 = float4(f16tof32(uint2(_S23 & 65535U, _S23 >> 16U)), f16tof32(uint2(_S24 & 65535U, _S24 >> 16U)));
    return numbers_1;
}

Eight_0 HalfWeights_eight_0(HalfWeights_0 this_1, uint element_1)
{
    return eight_halves_0(packed_numbers_0.Load(this_1.first_2 + element_1));
}

float4 tile_product_1(HalfWeights_0 weights_2, uint row_1, inout float  inputs_2[int(96)])
{
    float4 sums_1 = (float4)0.0f;
    uint column_1 = 0U;
    for(;;)
    {
        if(column_1 < 12U)
        {
        }
        else
        {
            break;
        }
        float4 low_2;
        float4 high_2;
        int _S25 = int(8U * column_1);
        low_2[int(0)] = inputs_2[_S25];
        high_2[int(0)] = inputs_2[_S25 + int(4)];
        int _S26 = _S25 + int(1);
        low_2[int(1)] = inputs_2[_S26];
        high_2[int(1)] = inputs_2[_S26 + int(4)];
        int _S27 = _S25 + int(2);
        low_2[int(2)] = inputs_2[_S27];
        high_2[int(2)] = inputs_2[_S27 + int(4)];
        int _S28 = _S25 + int(3);
        low_2[int(3)] = inputs_2[_S28];
        high_2[int(3)] = inputs_2[_S28 + int(4)];
        Eight_0 _S29 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        sums_1[int(0)] = sums_1[int(0)] + (dot(_S29.low_0, low_2) + dot(_S29.high_0, high_2));
        Eight_0 _S30 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1);
        sums_1[int(1)] = sums_1[int(1)] + (dot(_S30.low_0, low_2) + dot(_S30.high_0, high_2));
        Eight_0 _S31 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1);
        sums_1[int(2)] = sums_1[int(2)] + (dot(_S31.low_0, low_2) + dot(_S31.high_0, high_2));
        Eight_0 _S32 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1);
        sums_1[int(3)] = sums_1[int(3)] + (dot(_S32.low_0, low_2) + dot(_S32.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
}

void dense_part_1(HalfWeights_0 weights_3, uint first_3, bool adds_1, inout float  inputs_3[int(96)], inout float  outputs_1[int(52)])
{
    uint _S33 = first_3 + uint(whole_parts_0(int(7)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S34 = output_1 < int(52);
        if(_S34)
        {
        }
        else
        {
            break;
        }
        uint _S35 = uint(output_1);
        Eight_0 _S36 = HalfWeights_eight_0(weights_3, first_3 + _S35 / 8U);
        float4 _S37 = tile_product_1(weights_3, _S33 + _S35 * 12U, inputs_3);
        float4 _S38;
        if((output_1 & int(4)) != int(0))
        {
            _S38 = _S36.high_0;
        }
        else
        {
            _S38 = _S36.low_0;
        }
        float4 _S39 = _S37 + _S38;
        float _S40;
        if(_S34)
        {
            if(adds_1)
            {
                _S40 = outputs_1[output_1];
            }
            else
            {
                _S40 = 0.0f;
            }
            outputs_1[output_1] = Identity_apply_0(_S39[int(0)] + _S40);
        }
        int _S41 = output_1 + int(1);
        if(_S41 < int(52))
        {
            if(adds_1)
            {
                _S40 = outputs_1[_S41];
            }
            else
            {
                _S40 = 0.0f;
            }
            outputs_1[_S41] = Identity_apply_0(_S39[int(1)] + _S40);
        }
        int _S42 = output_1 + int(2);
        if(_S42 < int(52))
        {
            if(adds_1)
            {
                _S40 = outputs_1[_S42];
            }
            else
            {
                _S40 = 0.0f;
            }
            outputs_1[_S42] = Identity_apply_0(_S39[int(2)] + _S40);
        }
        int _S43 = output_1 + int(3);
        if(_S43 < int(52))
        {
            if(adds_1)
            {
                _S40 = outputs_1[_S43];
            }
            else
            {
                _S40 = 0.0f;
            }
            outputs_1[_S43] = Identity_apply_0(_S39[int(3)] + _S40);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

float4 tile_product_2(HalfWeights_0 weights_4, uint row_2, inout float  inputs_4[int(39)])
{
    float4 sums_2 = (float4)0.0f;
    uint column_2 = 0U;
    for(;;)
    {
        if(column_2 < 5U)
        {
        }
        else
        {
            break;
        }
        float4 low_3;
        float4 high_3;
        int _S44 = int(8U * column_2);
        low_3[int(0)] = inputs_4[min(_S44, int(38))];
        high_3[int(0)] = inputs_4[min(_S44 + int(4), int(38))];
        int _S45 = _S44 + int(1);
        low_3[int(1)] = inputs_4[min(_S45, int(38))];
        high_3[int(1)] = inputs_4[min(_S45 + int(4), int(38))];
        int _S46 = _S44 + int(2);
        low_3[int(2)] = inputs_4[min(_S46, int(38))];
        high_3[int(2)] = inputs_4[min(_S46 + int(4), int(38))];
        int _S47 = _S44 + int(3);
        low_3[int(3)] = inputs_4[min(_S47, int(38))];
        high_3[int(3)] = inputs_4[min(_S47 + int(4), int(38))];
        Eight_0 _S48 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        sums_2[int(0)] = sums_2[int(0)] + (dot(_S48.low_0, low_3) + dot(_S48.high_0, high_3));
        Eight_0 _S49 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2);
        sums_2[int(1)] = sums_2[int(1)] + (dot(_S49.low_0, low_3) + dot(_S49.high_0, high_3));
        Eight_0 _S50 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2);
        sums_2[int(2)] = sums_2[int(2)] + (dot(_S50.low_0, low_3) + dot(_S50.high_0, high_3));
        Eight_0 _S51 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2);
        sums_2[int(3)] = sums_2[int(3)] + (dot(_S51.low_0, low_3) + dot(_S51.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
}

void dense_part_2(HalfWeights_0 weights_5, uint first_4, bool adds_2, inout float  inputs_5[int(39)], inout float  outputs_2[int(96)])
{
    uint _S52 = first_4 + uint(whole_parts_0(int(12)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S53 = output_2 < int(96);
        if(_S53)
        {
        }
        else
        {
            break;
        }
        uint _S54 = uint(output_2);
        Eight_0 _S55 = HalfWeights_eight_0(weights_5, first_4 + _S54 / 8U);
        float4 _S56 = tile_product_2(weights_5, _S52 + _S54 * 5U, inputs_5);
        float4 _S57;
        if((output_2 & int(4)) != int(0))
        {
            _S57 = _S55.high_0;
        }
        else
        {
            _S57 = _S55.low_0;
        }
        float4 _S58 = _S56 + _S57;
        float _S59;
        if(_S53)
        {
            if(adds_2)
            {
                _S59 = outputs_2[output_2];
            }
            else
            {
                _S59 = 0.0f;
            }
            outputs_2[output_2] = Identity_apply_0(_S58[int(0)] + _S59);
        }
        int _S60 = output_2 + int(1);
        if(_S60 < int(96))
        {
            if(adds_2)
            {
                _S59 = outputs_2[_S60];
            }
            else
            {
                _S59 = 0.0f;
            }
            outputs_2[_S60] = Identity_apply_0(_S58[int(1)] + _S59);
        }
        int _S61 = output_2 + int(2);
        if(_S61 < int(96))
        {
            if(adds_2)
            {
                _S59 = outputs_2[_S61];
            }
            else
            {
                _S59 = 0.0f;
            }
            outputs_2[_S61] = Identity_apply_0(_S58[int(2)] + _S59);
        }
        int _S62 = output_2 + int(3);
        if(_S62 < int(96))
        {
            if(adds_2)
            {
                _S59 = outputs_2[_S62];
            }
            else
            {
                _S59 = 0.0f;
            }
            outputs_2[_S62] = Identity_apply_0(_S58[int(3)] + _S59);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

float4 tile_product_3(HalfWeights_0 weights_6, uint row_3, inout float  inputs_6[int(100)])
{
    float4 sums_3 = (float4)0.0f;
    uint column_3 = 0U;
    for(;;)
    {
        if(column_3 < 13U)
        {
        }
        else
        {
            break;
        }
        float4 low_4;
        float4 high_4;
        int _S63 = int(8U * column_3);
        low_4[int(0)] = inputs_6[min(_S63, int(99))];
        high_4[int(0)] = inputs_6[min(_S63 + int(4), int(99))];
        int _S64 = _S63 + int(1);
        low_4[int(1)] = inputs_6[min(_S64, int(99))];
        high_4[int(1)] = inputs_6[min(_S64 + int(4), int(99))];
        int _S65 = _S63 + int(2);
        low_4[int(2)] = inputs_6[min(_S65, int(99))];
        high_4[int(2)] = inputs_6[min(_S65 + int(4), int(99))];
        int _S66 = _S63 + int(3);
        low_4[int(3)] = inputs_6[min(_S66, int(99))];
        high_4[int(3)] = inputs_6[min(_S66 + int(4), int(99))];
        Eight_0 _S67 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        sums_3[int(0)] = sums_3[int(0)] + (dot(_S67.low_0, low_4) + dot(_S67.high_0, high_4));
        Eight_0 _S68 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3);
        sums_3[int(1)] = sums_3[int(1)] + (dot(_S68.low_0, low_4) + dot(_S68.high_0, high_4));
        Eight_0 _S69 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3);
        sums_3[int(2)] = sums_3[int(2)] + (dot(_S69.low_0, low_4) + dot(_S69.high_0, high_4));
        Eight_0 _S70 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3);
        sums_3[int(3)] = sums_3[int(3)] + (dot(_S70.low_0, low_4) + dot(_S70.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_3;
}

void dense_part_3(HalfWeights_0 weights_7, uint first_5, bool adds_3, inout float  inputs_7[int(100)], inout float  outputs_3[int(96)])
{
    uint _S71 = first_5 + uint(whole_parts_0(int(12)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S72 = output_3 < int(96);
        if(_S72)
        {
        }
        else
        {
            break;
        }
        uint _S73 = uint(output_3);
        Eight_0 _S74 = HalfWeights_eight_0(weights_7, first_5 + _S73 / 8U);
        float4 _S75 = tile_product_3(weights_7, _S71 + _S73 * 13U, inputs_7);
        float4 _S76;
        if((output_3 & int(4)) != int(0))
        {
            _S76 = _S74.high_0;
        }
        else
        {
            _S76 = _S74.low_0;
        }
        float4 _S77 = _S75 + _S76;
        float _S78;
        if(_S72)
        {
            if(adds_3)
            {
                _S78 = outputs_3[output_3];
            }
            else
            {
                _S78 = 0.0f;
            }
            outputs_3[output_3] = Identity_apply_0(_S77[int(0)] + _S78);
        }
        int _S79 = output_3 + int(1);
        if(_S79 < int(96))
        {
            if(adds_3)
            {
                _S78 = outputs_3[_S79];
            }
            else
            {
                _S78 = 0.0f;
            }
            outputs_3[_S79] = Identity_apply_0(_S77[int(1)] + _S78);
        }
        int _S80 = output_3 + int(2);
        if(_S80 < int(96))
        {
            if(adds_3)
            {
                _S78 = outputs_3[_S80];
            }
            else
            {
                _S78 = 0.0f;
            }
            outputs_3[_S80] = Identity_apply_0(_S77[int(2)] + _S78);
        }
        int _S81 = output_3 + int(3);
        if(_S81 < int(96))
        {
            if(adds_3)
            {
                _S78 = outputs_3[_S81];
            }
            else
            {
                _S78 = 0.0f;
            }
            outputs_3[_S81] = Identity_apply_0(_S77[int(3)] + _S78);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

float4 tile_product_4(HalfWeights_0 weights_8, uint row_4, inout float  inputs_8[int(16)])
{
    float4 sums_4 = (float4)0.0f;
    uint column_4 = 0U;
    for(;;)
    {
        if(column_4 < 2U)
        {
        }
        else
        {
            break;
        }
        float4 low_5;
        float4 high_5;
        int _S82 = int(8U * column_4);
        low_5[int(0)] = inputs_8[_S82];
        high_5[int(0)] = inputs_8[_S82 + int(4)];
        int _S83 = _S82 + int(1);
        low_5[int(1)] = inputs_8[_S83];
        high_5[int(1)] = inputs_8[_S83 + int(4)];
        int _S84 = _S82 + int(2);
        low_5[int(2)] = inputs_8[_S84];
        high_5[int(2)] = inputs_8[_S84 + int(4)];
        int _S85 = _S82 + int(3);
        low_5[int(3)] = inputs_8[_S85];
        high_5[int(3)] = inputs_8[_S85 + int(4)];
        Eight_0 _S86 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        sums_4[int(0)] = sums_4[int(0)] + (dot(_S86.low_0, low_5) + dot(_S86.high_0, high_5));
        Eight_0 _S87 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4);
        sums_4[int(1)] = sums_4[int(1)] + (dot(_S87.low_0, low_5) + dot(_S87.high_0, high_5));
        Eight_0 _S88 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4);
        sums_4[int(2)] = sums_4[int(2)] + (dot(_S88.low_0, low_5) + dot(_S88.high_0, high_5));
        Eight_0 _S89 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4);
        sums_4[int(3)] = sums_4[int(3)] + (dot(_S89.low_0, low_5) + dot(_S89.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_4;
}

void dense_part_4(HalfWeights_0 weights_9, uint first_6, bool adds_4, inout float  inputs_9[int(16)], inout float  outputs_4[int(1)])
{
    uint _S90 = first_6 + uint(whole_parts_0(int(1)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S91 = output_4 < int(1);
        if(_S91)
        {
        }
        else
        {
            break;
        }
        uint _S92 = uint(output_4);
        Eight_0 _S93 = HalfWeights_eight_0(weights_9, first_6 + _S92 / 8U);
        float4 _S94 = tile_product_4(weights_9, _S90 + _S92 * 2U, inputs_9);
        float4 _S95;
        if((output_4 & int(4)) != int(0))
        {
            _S95 = _S93.high_0;
        }
        else
        {
            _S95 = _S93.low_0;
        }
        float4 _S96 = _S94 + _S95;
        float _S97;
        if(_S91)
        {
            if(adds_4)
            {
                _S97 = outputs_4[output_4];
            }
            else
            {
                _S97 = 0.0f;
            }
            outputs_4[output_4] = Identity_apply_0(_S96[int(0)] + _S97);
        }
        int _S98 = output_4 + int(1);
        if(_S98 < int(1))
        {
            if(adds_4)
            {
                _S97 = outputs_4[_S98];
            }
            else
            {
                _S97 = 0.0f;
            }
            outputs_4[_S98] = Identity_apply_0(_S96[int(1)] + _S97);
        }
        int _S99 = output_4 + int(2);
        if(_S99 < int(1))
        {
            if(adds_4)
            {
                _S97 = outputs_4[_S99];
            }
            else
            {
                _S97 = 0.0f;
            }
            outputs_4[_S99] = Identity_apply_0(_S96[int(2)] + _S97);
        }
        int _S100 = output_4 + int(3);
        if(_S100 < int(1))
        {
            if(adds_4)
            {
                _S97 = outputs_4[_S100];
            }
            else
            {
                _S97 = 0.0f;
            }
            outputs_4[_S100] = Identity_apply_0(_S96[int(3)] + _S97);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

float LeakyRelu_apply_0(float x_3)
{
    return max(x_3, x_3 * 0.00999999977648258f);
}

void dense_part_5(HalfWeights_0 weights_10, uint first_7, bool adds_5, inout float  inputs_10[int(96)], inout float  outputs_5[int(96)])
{
    uint _S101 = first_7 + uint(whole_parts_0(int(12)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S102 = output_5 < int(96);
        if(_S102)
        {
        }
        else
        {
            break;
        }
        uint _S103 = uint(output_5);
        Eight_0 _S104 = HalfWeights_eight_0(weights_10, first_7 + _S103 / 8U);
        float4 _S105 = tile_product_1(weights_10, _S101 + _S103 * 12U, inputs_10);
        float4 _S106;
        if((output_5 & int(4)) != int(0))
        {
            _S106 = _S104.high_0;
        }
        else
        {
            _S106 = _S104.low_0;
        }
        float4 _S107 = _S105 + _S106;
        float _S108;
        if(_S102)
        {
            if(adds_5)
            {
                _S108 = outputs_5[output_5];
            }
            else
            {
                _S108 = 0.0f;
            }
            outputs_5[output_5] = LeakyRelu_apply_0(_S107[int(0)] + _S108);
        }
        int _S109 = output_5 + int(1);
        if(_S109 < int(96))
        {
            if(adds_5)
            {
                _S108 = outputs_5[_S109];
            }
            else
            {
                _S108 = 0.0f;
            }
            outputs_5[_S109] = LeakyRelu_apply_0(_S107[int(1)] + _S108);
        }
        int _S110 = output_5 + int(2);
        if(_S110 < int(96))
        {
            if(adds_5)
            {
                _S108 = outputs_5[_S110];
            }
            else
            {
                _S108 = 0.0f;
            }
            outputs_5[_S110] = LeakyRelu_apply_0(_S107[int(2)] + _S108);
        }
        int _S111 = output_5 + int(3);
        if(_S111 < int(96))
        {
            if(adds_5)
            {
                _S108 = outputs_5[_S111];
            }
            else
            {
                _S108 = 0.0f;
            }
            outputs_5[_S111] = LeakyRelu_apply_0(_S107[int(3)] + _S108);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

void dense_part_6(HalfWeights_0 weights_11, uint first_8, bool adds_6, inout float  inputs_11[int(100)], inout float  outputs_6[int(16)])
{
    uint _S112 = first_8 + uint(whole_parts_0(int(2)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S113 = output_6 < int(16);
        if(_S113)
        {
        }
        else
        {
            break;
        }
        uint _S114 = uint(output_6);
        Eight_0 _S115 = HalfWeights_eight_0(weights_11, first_8 + _S114 / 8U);
        float4 _S116 = tile_product_3(weights_11, _S112 + _S114 * 13U, inputs_11);
        float4 _S117;
        if((output_6 & int(4)) != int(0))
        {
            _S117 = _S115.high_0;
        }
        else
        {
            _S117 = _S115.low_0;
        }
        float4 _S118 = _S116 + _S117;
        float _S119;
        if(_S113)
        {
            if(adds_6)
            {
                _S119 = outputs_6[output_6];
            }
            else
            {
                _S119 = 0.0f;
            }
            outputs_6[output_6] = LeakyRelu_apply_0(_S118[int(0)] + _S119);
        }
        int _S120 = output_6 + int(1);
        if(_S120 < int(16))
        {
            if(adds_6)
            {
                _S119 = outputs_6[_S120];
            }
            else
            {
                _S119 = 0.0f;
            }
            outputs_6[_S120] = LeakyRelu_apply_0(_S118[int(1)] + _S119);
        }
        int _S121 = output_6 + int(2);
        if(_S121 < int(16))
        {
            if(adds_6)
            {
                _S119 = outputs_6[_S121];
            }
            else
            {
                _S119 = 0.0f;
            }
            outputs_6[_S121] = LeakyRelu_apply_0(_S118[int(2)] + _S119);
        }
        int _S122 = output_6 + int(3);
        if(_S122 < int(16))
        {
            if(adds_6)
            {
                _S119 = outputs_6[_S122];
            }
            else
            {
                _S119 = 0.0f;
            }
            outputs_6[_S122] = LeakyRelu_apply_0(_S118[int(3)] + _S119);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

float4 tile_product_5(HalfWeights_0 weights_12, uint row_5, inout float  inputs_12[int(88)])
{
    float4 sums_5 = (float4)0.0f;
    uint column_5 = 0U;
    for(;;)
    {
        if(column_5 < 11U)
        {
        }
        else
        {
            break;
        }
        float4 low_6;
        float4 high_6;
        int _S123 = int(8U * column_5);
        low_6[int(0)] = inputs_12[_S123];
        high_6[int(0)] = inputs_12[_S123 + int(4)];
        int _S124 = _S123 + int(1);
        low_6[int(1)] = inputs_12[_S124];
        high_6[int(1)] = inputs_12[_S124 + int(4)];
        int _S125 = _S123 + int(2);
        low_6[int(2)] = inputs_12[_S125];
        high_6[int(2)] = inputs_12[_S125 + int(4)];
        int _S126 = _S123 + int(3);
        low_6[int(3)] = inputs_12[_S126];
        high_6[int(3)] = inputs_12[_S126 + int(4)];
        Eight_0 _S127 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        sums_5[int(0)] = sums_5[int(0)] + (dot(_S127.low_0, low_6) + dot(_S127.high_0, high_6));
        Eight_0 _S128 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5);
        sums_5[int(1)] = sums_5[int(1)] + (dot(_S128.low_0, low_6) + dot(_S128.high_0, high_6));
        Eight_0 _S129 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5);
        sums_5[int(2)] = sums_5[int(2)] + (dot(_S129.low_0, low_6) + dot(_S129.high_0, high_6));
        Eight_0 _S130 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5);
        sums_5[int(3)] = sums_5[int(3)] + (dot(_S130.low_0, low_6) + dot(_S130.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_5;
}

void dense_part_7(HalfWeights_0 weights_13, uint first_9, bool adds_7, inout float  inputs_13[int(88)], inout float  outputs_7[int(96)])
{
    uint _S131 = first_9 + uint(whole_parts_0(int(12)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S132 = output_7 < int(96);
        if(_S132)
        {
        }
        else
        {
            break;
        }
        uint _S133 = uint(output_7);
        Eight_0 _S134 = HalfWeights_eight_0(weights_13, first_9 + _S133 / 8U);
        float4 _S135 = tile_product_5(weights_13, _S131 + _S133 * 11U, inputs_13);
        float4 _S136;
        if((output_7 & int(4)) != int(0))
        {
            _S136 = _S134.high_0;
        }
        else
        {
            _S136 = _S134.low_0;
        }
        float4 _S137 = _S135 + _S136;
        float _S138;
        if(_S132)
        {
            if(adds_7)
            {
                _S138 = outputs_7[output_7];
            }
            else
            {
                _S138 = 0.0f;
            }
            outputs_7[output_7] = LeakyRelu_apply_0(_S137[int(0)] + _S138);
        }
        int _S139 = output_7 + int(1);
        if(_S139 < int(96))
        {
            if(adds_7)
            {
                _S138 = outputs_7[_S139];
            }
            else
            {
                _S138 = 0.0f;
            }
            outputs_7[_S139] = LeakyRelu_apply_0(_S137[int(1)] + _S138);
        }
        int _S140 = output_7 + int(2);
        if(_S140 < int(96))
        {
            if(adds_7)
            {
                _S138 = outputs_7[_S140];
            }
            else
            {
                _S138 = 0.0f;
            }
            outputs_7[_S140] = LeakyRelu_apply_0(_S137[int(2)] + _S138);
        }
        int _S141 = output_7 + int(3);
        if(_S141 < int(96))
        {
            if(adds_7)
            {
                _S138 = outputs_7[_S141];
            }
            else
            {
                _S138 = 0.0f;
            }
            outputs_7[_S141] = LeakyRelu_apply_0(_S137[int(3)] + _S138);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

void dense_0(FloatWeights_0 weights_14, uint first_10, bool adds_8, inout float  inputs_14[int(96)], inout float  outputs_8[int(50)])
{
    dense_part_0(weights_14, first_10, adds_8, inputs_14, outputs_8);
    return;
}

void dense_1(HalfWeights_0 weights_15, uint first_11, bool adds_9, inout float  inputs_15[int(96)], inout float  outputs_9[int(52)])
{
    dense_part_1(weights_15, first_11, adds_9, inputs_15, outputs_9);
    return;
}

void dense_2(HalfWeights_0 weights_16, uint first_12, bool adds_10, inout float  inputs_16[int(96)], inout float  outputs_10[int(96)])
{
    dense_part_5(weights_16, first_12, adds_10, inputs_16, outputs_10);
    return;
}

void dense_3(HalfWeights_0 weights_17, uint first_13, bool adds_11, inout float  inputs_17[int(39)], inout float  outputs_11[int(96)])
{
    dense_part_2(weights_17, first_13, adds_11, inputs_17, outputs_11);
    return;
}

void dense_4(HalfWeights_0 weights_18, uint first_14, bool adds_12, inout float  inputs_18[int(100)], inout float  outputs_12[int(96)])
{
    dense_part_3(weights_18, first_14, adds_12, inputs_18, outputs_12);
    return;
}

void dense_5(HalfWeights_0 weights_19, uint first_15, bool adds_13, inout float  inputs_19[int(16)], inout float  outputs_13[int(1)])
{
    dense_part_4(weights_19, first_15, adds_13, inputs_19, outputs_13);
    return;
}

void dense_6(HalfWeights_0 weights_20, uint first_16, bool adds_14, inout float  inputs_20[int(100)], inout float  outputs_14[int(16)])
{
    dense_part_6(weights_20, first_16, adds_14, inputs_20, outputs_14);
    return;
}

void dense_part_8(HalfWeights_0 weights_21, uint first_17, bool adds_15, inout float  inputs_21[int(96)], inout float  outputs_15[int(100)])
{
    uint _S142 = first_17 + uint(whole_parts_0(int(12)));
    int output_8 = int(0);
    for(;;)
    {
        bool _S143 = output_8 < int(96);
        if(_S143)
        {
        }
        else
        {
            break;
        }
        uint _S144 = uint(output_8);
        Eight_0 _S145 = HalfWeights_eight_0(weights_21, first_17 + _S144 / 8U);
        float4 _S146 = tile_product_1(weights_21, _S142 + _S144 * 12U, inputs_21);
        float4 _S147;
        if((output_8 & int(4)) != int(0))
        {
            _S147 = _S145.high_0;
        }
        else
        {
            _S147 = _S145.low_0;
        }
        float4 _S148 = _S146 + _S147;
        float _S149;
        if(_S143)
        {
            if(adds_15)
            {
                _S149 = outputs_15[output_8];
            }
            else
            {
                _S149 = 0.0f;
            }
            outputs_15[output_8] = LeakyRelu_apply_0(_S148[int(0)] + _S149);
        }
        int _S150 = output_8 + int(1);
        if(_S150 < int(96))
        {
            if(adds_15)
            {
                _S149 = outputs_15[_S150];
            }
            else
            {
                _S149 = 0.0f;
            }
            outputs_15[_S150] = LeakyRelu_apply_0(_S148[int(1)] + _S149);
        }
        int _S151 = output_8 + int(2);
        if(_S151 < int(96))
        {
            if(adds_15)
            {
                _S149 = outputs_15[_S151];
            }
            else
            {
                _S149 = 0.0f;
            }
            outputs_15[_S151] = LeakyRelu_apply_0(_S148[int(2)] + _S149);
        }
        int _S152 = output_8 + int(3);
        if(_S152 < int(96))
        {
            if(adds_15)
            {
                _S149 = outputs_15[_S152];
            }
            else
            {
                _S149 = 0.0f;
            }
            outputs_15[_S152] = LeakyRelu_apply_0(_S148[int(3)] + _S149);
        }
        output_8 = output_8 + int(4);
    }
    return;
}

void dense_7(HalfWeights_0 weights_22, uint first_18, bool adds_16, inout float  inputs_22[int(88)], inout float  outputs_16[int(96)])
{
    dense_part_7(weights_22, first_18, adds_16, inputs_22, outputs_16);
    return;
}

float3 position_of_0(Vertex_0 vertex_0)
{
    return float3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

float3 normal_of_0(Vertex_0 vertex_1)
{
    return float3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

float square_1(float x_4)
{
    return x_4 * x_4;
}

float natural_logarithm_0(float x_5)
{
    uint _S153 = asuint(x_5);
    float exponent_0 = float(int(_S153 >> int(23)) - int(126));
    float m_0 = asfloat((_S153 & 8388607U) | 1056964608U);
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
    float _S154 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S154 - exponent_1 * 0.00021219444170129f - 0.5f * _S154) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_6)
{
    return natural_logarithm_0(x_6) * 1.4426950216293335f;
}

float exponential_0(float x_7)
{
    float _S155 = clamp(x_7, -87.0f, 88.0f);
    float _S156 = floor(_S155 * 1.4426950216293335f + 0.5f);
    float _S157 = _S155 - _S156 * 0.693359375f + _S156 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S157 + 0.00139819993637502f) * _S157 + 0.00833345204591751f) * _S157 + 0.04166579619050026f) * _S157 + 0.1666666567325592f) * _S157 + 0.5f;
    float _S158 = asfloat(uint(int(_S156) + int(127)) << int(23));
    float _S159;
    if(x_7 < -87.0f)
    {
        _S159 = 0.0f;
    }
    else
    {
        _S159 = (p_0 * _S157 * _S157 + _S157 + 1.0f) * _S158;
    }
    return _S159;
}

float3 map_texel_0(uint index_0)
{
    uint _S160 = scene_words_0.Load(index_0);
    float3 _S161 = float3(float(_S160 & 1023U), float((_S160 >> int(10)) & 1023U), float(_S160 >> int(20))) / 1023.0f;
    return _S161 * _S161;
}

float3 map_level_0(uint first_19, uint side_0, float2 uv_0)
{
    float _S162 = uv_0.x;
    float _S163 = float(side_0);
    float _S164 = (_S162 - floor(_S162)) * _S163 - 0.5f;
    float _S165 = uv_0.y;
    float _S166 = (_S165 - floor(_S165)) * _S163 - 0.5f;
    float _S167 = floor(_S164);
    int _S168 = int(side_0);
    uint _S169 = side_0 - 1U;
    uint _S170 = uint(int(_S167) + _S168) & _S169;
    float _S171 = floor(_S166);
    uint _S172 = uint(int(_S171) + _S168) & _S169;
    uint _S173 = (_S170 + 1U) & _S169;
    uint _S174 = first_19 + _S172 * side_0;
    float3 _S175 = (float3)(_S164 - _S167);
    uint _S176 = first_19 + ((_S172 + 1U) & _S169) * side_0;
    return lerp(lerp(map_texel_0(_S174 + _S170), map_texel_0(_S174 + _S173), _S175), lerp(map_texel_0(_S176 + _S170), map_texel_0(_S176 + _S173), _S175), (float3)(_S166 - _S171));
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_1;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(VisiblePoint_0 point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float3 row_of_taps_0(Footprint_0 footprint_0)
{
    float _S177 = footprint_0.dx_0.x;
    float _S178 = footprint_0.dy_0.x;
    float _S179 = _S177 * _S177 + _S178 * _S178;
    float _S180 = footprint_0.dx_0.y;
    float _S181 = footprint_0.dy_0.y;
    float _S182 = _S180 * _S180 + _S181 * _S181;
    float _S183 = _S177 * _S180 + _S178 * _S181;
    float _S184 = 0.5f * (_S179 - _S182);
    float _S185 = 0.5f * (_S179 + _S182);
    float _S186 = sqrt(_S184 * _S184 + _S183 * _S183);
    float _S187 = _S185 + _S186;
    float _S188 = max(_S187 - 1.5f * max(_S185 - _S186, 0.0f), 0.0f);
    float _S189 = square_1(4.0f);
    float _S190 = max(_S185 - 0.5f * _S188, _S187 / _S189);
    float _S191 = sqrt(max(min(_S188, _S187 - _S190), 0.0f) / (_S189 - 1.0f));
    float _S192 = _S184 / max(_S186, 1.00000000317107685e-30f);
    float _S193 = sqrt(max(0.5f * (1.0f - _S192), 0.0f));
    float _S194 = sqrt(_S190);
    float _S195 = _S191 * sqrt(max(0.5f * (1.0f + _S192), 0.0f));
    float _S196;
    if(_S183 < 0.0f)
    {
        _S196 = - _S191 * _S193;
    }
    else
    {
        _S196 = _S191 * _S193;
    }
    return float3(_S194, _S195, _S196);
}

struct AnisotropicTaps_0
{
    float2 centre_1;
    float side_1;
    float2 first_20;
    float2 second_0;
};

float AnisotropicTaps_size_0(AnisotropicTaps_0 this_2)
{
    float _S197 = this_2.first_20.x;
    float _S198 = this_2.second_0.x;
    float _S199 = this_2.side_1;
    float _S200 = _S199 * _S199;
    float _S201 = this_2.first_20.y;
    float _S202 = this_2.second_0.y;
    float _S203 = 12.0f * (_S197 * _S201 + _S198 * _S202);
    return sqrt(sqrt(max((12.0f * (_S197 * _S197 + _S198 * _S198) + _S200) * (12.0f * (_S201 * _S201 + _S202 * _S202) + _S200) - _S203 * _S203, square_1(_S200))));
}

float3 footprint_coordinates_0(AnisotropicTaps_0 taps_0)
{
    return float3(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S204 = direction_1.xy;
    float _S205;
    if(back_1)
    {
        _S205 = - direction_1.z;
    }
    else
    {
        _S205 = direction_1.z;
    }
    return float3(_S204, _S205);
}

float table_number_0(uint index_1)
{
    return asfloat(words_0.Load(index_1));
}

float wrapped_0(float index_2, float count_1)
{
    float _S206;
    if(index_2 < 0.0f)
    {
        _S206 = index_2 + count_1;
    }
    else
    {
        if(index_2 >= count_1)
        {
            _S206 = index_2 - count_1;
        }
        else
        {
            _S206 = index_2;
        }
    }
    return _S206;
}

bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 this_3)
{
    float2 _S207 = (float2)0.0f;
    bool _S208;
    if(any((this_3.first_20) != _S207))
    {
        _S208 = true;
    }
    else
    {
        _S208 = any((this_3.second_0) != _S207);
    }
    return _S208;
}

float2 AnisotropicTaps_place_0(AnisotropicTaps_0 this_4, uint number_0)
{
    float _S209;
    if(number_0 >= 2U)
    {
        _S209 = 1.0f;
    }
    else
    {
        _S209 = -1.0f;
    }
    float _S210;
    if((number_0 & 1U) != 0U)
    {
        _S210 = 1.0f;
    }
    else
    {
        _S210 = -1.0f;
    }
    return this_4.centre_1 + _S209 * this_4.first_20 + _S210 * this_4.second_0;
}

float bump_0(float distance_0)
{
    float _S211 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S211 * _S211;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

float2 turns_and_remainder_0(uint family_0, float index_3)
{
    float _S212 = floor(mad(index_3, families_0.Load(family_0).inverse_count_0, families_0.Load(family_0).half_inverse_count_0));
    return float2(_S212, mad(- _S212, families_0.Load(family_0).count_0, index_3));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1)
{
    float _S213 = floor(position_1 * families_0.Load(family_1).inverse_size_0);
    Cell_0 cell_0;
    float _S214 = mad(- _S213, families_0.Load(family_1).size_0, position_1);
    cell_0.below_0 = _S214;
    cell_0.above_0 = families_0.Load(family_1).size_0 - _S214;
    cell_0.across_0 = _S214 - 0.5f * families_0.Load(family_1).size_0;
    cell_0.half_width_1 = families_0.Load(family_1).half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S213).y, 0.0f, families_0.Load(family_1).count_0 - 1.0f));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0.Load(family_2).start_0) * families_0.Load(family_2).inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S215 = turns_1 * families_0.Load(family_2).period_0;
    uint thread_1 = words_0.Load(families_0.Load(family_2).first_thread_table_0 + uint(clamp(turns_1 * families_0.Load(family_2).bins_0, 0.0f, families_0.Load(family_2).bins_0 - 1.0f)));
    uint _S216;
    if(_S215 >= (table_number_0(families_0.Load(family_2).place_table_0 + thread_1 * 4U + 1U)))
    {
        _S216 = 1U;
    }
    else
    {
        _S216 = 0U;
    }
    uint _S217 = min(thread_1 + _S216, uint(families_0.Load(family_2).count_0) - 1U);
    uint _S218 = families_0.Load(family_2).place_table_0 + _S217 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S217;
    cell_1.below_0 = _S215 - table_number_0(_S218);
    cell_1.above_0 = table_number_0(_S218 + 1U) - _S215;
    cell_1.across_0 = _S215 - table_number_0(_S218 + 2U);
    cell_1.half_width_1 = table_number_0(_S218 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_3)
{
    if((families_0.Load(family_3).is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Bound_0
{
    uint thread_2;
    float turns_2;
    float cell_2;
    float visible_0;
    float width_1;
    float gap_0;
};

Bound_0 bound_at_0(uint family_4, float position_4)
{
    Cell_0 _S219 = locate_0(family_4, position_4);
    float _S220 = table_number_0(families_0.Load(family_4).before_0 + 2U * _S219.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_2 = _S219.thread_0;
    bound_0.turns_2 = round((position_4 - families_0.Load(family_4).start_0 - _S220 - _S219.below_0) * families_0.Load(family_4).inverse_period_0);
    bound_0.cell_2 = _S219.below_0;
    float _S221 = 2.0f * _S219.half_width_1;
    bound_0.width_1 = _S221;
    bound_0.visible_0 = clamp((_S219.across_0 + _S219.half_width_1) / _S221, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S219.below_0, _S219.below_0 - _S219.across_0 - _S219.half_width_1) + max(_S219.across_0 - _S219.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S222 = centre_2 - floor((centre_2 - families_0.Load(family_5).start_0) * families_0.Load(family_5).inverse_period_0) * families_0.Load(family_5).period_0;
    float _S223 = 0.5f * max(size_1, families_0.Load(family_5).smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S222 - _S223);
    stretch_0.high_7 = bound_at_0(family_5, _S222 + _S223);
    return stretch_0;
}

float3 table_colour_0(uint index_4)
{
    return float3(table_number_0(index_4), table_number_0(index_4 + 1U), table_number_0(index_4 + 2U));
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_6)
{
    Albedos_0 albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_6);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_6 + 3U);
    albedos_0.specular_reflect_0 = table_colour_0(row_6 + 6U);
    albedos_0.specular_transmit_0 = table_colour_0(row_6 + 9U);
    return albedos_0;
}

float Stretch_turns_0(Stretch_0 this_5)
{
    return this_5.high_7.turns_2 - this_5.low_7.turns_2;
}

float3 lengths_0(uint family_6, Stretch_0 stretch_1)
{
    float _S224 = Stretch_turns_0(stretch_1);
    uint _S225 = families_0.Load(family_6).before_0 + 2U * stretch_1.low_7.thread_2;
    uint _S226 = families_0.Load(family_6).before_0 + 2U * stretch_1.high_7.thread_2;
    float _S227 = table_number_0(_S226) - table_number_0(_S225);
    float _S228 = table_number_0(_S226 + 1U) - table_number_0(_S225 + 1U);
    return float3(_S227 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_1 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_1 + _S224 * families_0.Load(family_6).visible_total_0, _S228 - _S227 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S224 * (families_0.Load(family_6).period_0 - families_0.Load(family_6).visible_total_0), _S228 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S224 * families_0.Load(family_6).period_0);
}

float2 integrals_along_0(uint family_7, Stretch_0 stretch_2, uint quantity_0)
{
    Family_0 _S229 = families_0.Load(family_7);
    uint _S230 = 3U * _S229.quantities_0;
    uint _S231 = families_0.Load(family_7).colour_threads_0 + _S230 * stretch_2.low_7.thread_2 + quantity_0;
    uint _S232 = families_0.Load(family_7).colour_threads_0 + _S230 * stretch_2.high_7.thread_2 + quantity_0;
    uint _S233 = families_0.Load(family_7).colour_threads_0 + _S230 * uint(families_0.Load(family_7).count_0) + quantity_0;
    float _S234 = table_number_0(_S231);
    float _S235 = table_number_0(_S232);
    float _S236 = Stretch_turns_0(stretch_2);
    uint _S237 = 2U * _S229.quantities_0;
    return float2(table_number_0(_S232 + _S229.quantities_0) - table_number_0(_S231 + _S229.quantities_0) + _S235 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_1 - _S234 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_1 + _S236 * table_number_0(_S233 + _S229.quantities_0), table_number_0(_S232 + _S237) - table_number_0(_S231 + _S237) + _S235 * stretch_2.high_7.cell_2 - _S234 * stretch_2.low_7.cell_2 + _S236 * table_number_0(_S233 + _S237));
}

bool Stretch_wraps_0(Stretch_0 this_6)
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

uint4 Stretch_differences_0(Stretch_0 this_7, uint4 entries_0, uint whole_0)
{
    uint _S238 = entries_0.z;
    uint _S239 = entries_0.x;
    uint _S240 = _S238 - _S239;
    uint _S241;
    if(Stretch_wraps_0(this_7))
    {
        _S241 = whole_0;
    }
    else
    {
        _S241 = 0U;
    }
    return uint4(_S240 + _S241, entries_0.w - _S238, entries_0.y - _S239, whole_0);
}

uint4 row_differences_0(Stretch_0 across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S242 = row_7 + across_1.low_7.thread_2 * quantities_1;
    uint _S243 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, uint4(words_0.Load(_S242), words_0.Load(_S242 + quantities_1), words_0.Load(_S243), words_0.Load(_S243 + quantities_1)), words_0.Load(row_7 + count_2 * quantities_1));
}

float4 Stretch_weights_0(Stretch_0 this_8)
{
    float _S244 = - this_8.low_7.visible_0;
    float _S245 = Stretch_turns_0(this_8);
    float _S246;
    if(Stretch_wraps_0(this_8))
    {
        _S246 = 1.0f;
    }
    else
    {
        _S246 = 0.0f;
    }
    return float4(1.0f, this_8.high_7.visible_0, _S244, _S245 - _S246);
}

float integral_on_top_0(uint family_8, Stretch_0 across_2, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S247 = uint(families_0.Load(family_8).count_0);
    uint _S248 = (_S247 + 1U) * families_0.Load(family_8).quantities_0;
    uint _S249 = families_0.Load(family_8).colour_areas_0 + quantity_1;
    uint4 _S250 = row_differences_0(across_2, _S249 + along_0.low_7.thread_2 * _S248, _S247, families_0.Load(family_8).quantities_0);
    uint4 _S251 = row_differences_0(across_2, _S249 + (along_0.low_7.thread_2 + 1U) * _S248, _S247, families_0.Load(family_8).quantities_0);
    uint4 _S252 = row_differences_0(across_2, _S249 + along_0.high_7.thread_2 * _S248, _S247, families_0.Load(family_8).quantities_0);
    uint4 _S253 = row_differences_0(across_2, _S249 + (along_0.high_7.thread_2 + 1U) * _S248, _S247, families_0.Load(family_8).quantities_0);
    uint4 _S254 = row_differences_0(across_2, _S249 + crossing_count_0 * _S248, _S247, families_0.Load(family_8).quantities_0);
    uint4 _S255 = _S252 - _S250;
    uint4 _S256;
    if(Stretch_wraps_0(along_0))
    {
        _S256 = _S254;
    }
    else
    {
        _S256 = uint4((int4)int(0));
    }
    float4 _S257 = Stretch_weights_0(across_2);
    return dot(float4(dot(float4(int4(_S255 + _S256)), _S257), dot(float4(int4(_S253 - _S252)), _S257), dot(float4(int4(_S251 - _S250)), _S257), dot(float4(int4(_S254)), _S257)), Stretch_weights_0(along_0)) * families_0.Load(family_8).area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S258 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_0 * _S258.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_0 * _S258.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_0 * _S258.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_0 * _S258.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 own_0, Stretch_0 other_0, bool back_2)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0.Load(family_9).colour_mean_0);
    if((families_0.Load(family_9).quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S259 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0.Load(family_9).quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S260 = integrals_along_0(family_9, own_0, quantity_2);
        float _S261 = integral_on_top_0(family_9, own_0, other_0, uint(families_0.Load(crossing_0).count_0), quantity_2);
        float _S262 = _S260.x;
        float _S263 = _S262 * _S259.x;
        float _S264;
        if(back_2)
        {
            _S264 = _S263 - _S261;
        }
        else
        {
            _S264 = _S261;
        }
        bool _S265 = quantity_2 == 0U;
        if(_S265)
        {
            is_exposed_0 = _S264 > (16.0f * families_0.Load(family_9).area_unit_0 * min(_S263 / families_0.Load(family_9).crossing_area_0, 1.0f) + 0.00000999999974738f * _S263);
        }
        float _S266 = _S262 * _S259.y;
        float _S267;
        if(is_exposed_0)
        {
            _S267 = _S264;
        }
        else
        {
            _S267 = 0.0f;
        }
        float _S268 = _S266 + _S267 + 0.000244140625f * _S259.z * _S260.y;
        if(_S265)
        {
            weight_1 = 1.0f / max(_S268, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S268 * weight_1, families_0.Load(family_9).colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

Albedos_0 tinted_0(Albedos_0 albedos_3, float3 tint_0)
{
    Albedos_0 result_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

uint scramble_0(uint value_0)
{
    uint _S269 = value_0 * 747796405U + 2891336453U;
    uint _S270 = ((_S269 >> ((_S269 >> int(28)) + 4U)) ^ _S269) * 277803737U;
    return (_S270 >> int(22)) ^ _S270;
}

float uniform_hash_0(uint thread_3, uint cell_3, uint stream_0)
{
    return (float((scramble_0(cell_3 + scramble_0(thread_3 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_5, uint stream_1)
{
    uint _S271 = pixel_0.x;
    uint _S272 = pixel_0.y;
    return frac(float2(uniform_hash_0(_S271, _S272, stream_1), uniform_hash_0(_S271, _S272, stream_1 + 1U)) + float(index_5 & 65535U) * float2(0.75487768650054932f, 0.56984031200408936f));
}

float scene_number_0(uint index_6)
{
    return asfloat(scene_words_0.Load(index_6));
}

struct Choice_0
{
    uint index_7;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_3, float number_1)
{
    uint high_8 = count_3;
    uint low_8 = 0U;
    for(;;)
    {
        if((high_8 - low_8) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S273 = (low_8 + high_8) / 2U;
        if((scene_number_0(table_0 + _S273)) <= number_1)
        {
            low_8 = _S273;
        }
        else
        {
            high_8 = _S273;
        }
    }
    uint _S274 = table_0 + low_8;
    float _S275 = scene_number_0(_S274);
    float _S276 = scene_number_0(_S274 + 1U);
    Choice_0 choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate((number_1 - _S275) / max(_S276 - _S275, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_8)
{
    float _S277 = floor(x_8 * 0.63661974668502808f + 0.5f);
    float _S278 = x_8 - _S277 * 1.5703125f - _S277 * 0.00048375129699707f - _S277 * 7.54979012640433211e-08f;
    float _S279 = _S278 * _S278;
    float _S280 = ((-0.00019515295571182f * _S279 + 0.00833216123282909f) * _S279 - 0.16666655242443085f) * _S279 * _S278 + _S278;
    float _S281 = ((0.00002443315679557f * _S279 - 0.00138873164542019f) * _S279 + 0.04166664555668831f) * _S279 * _S279 - 0.5f * _S279 + 1.0f;
    uint _S282 = uint(int(_S277)) & 3U;
    float2 _S283;
    if((_S282 & 1U) != 0U)
    {
        _S283 = float2(_S281, _S280);
    }
    else
    {
        _S283 = float2(_S280, _S281);
    }
    float _S284;
    if((_S282 & 2U) != 0U)
    {
        _S284 = - _S283.x;
    }
    else
    {
        _S284 = _S283.x;
    }
    float _S285;
    if(((_S282 + 1U) & 2U) != 0U)
    {
        _S285 = - _S283.y;
    }
    else
    {
        _S285 = _S283.y;
    }
    return float2(_S284, _S285);
}

float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S286 = bundle_0 / 3U;
    uint _S287 = bundle_0 % 3U;
    uint _S288;
    if(bundle_0 == 24U)
    {
        _S288 = bundle_0;
    }
    else
    {
        _S288 = _S286 * 3U + 3U - 1U - _S287;
    }
    return _S288;
}

float light_visibility_of_0(float diffuse_0, float3 light_0, float3 view_1, float blend_0)
{
    float _S289 = max(abs(light_0.z), 0.00100000004749745f);
    float2 _S290 = light_0.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / lerp(_S289, (0.59700000286102295f * _S289 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S290, view_1.xy) * rsqrt(max(dot(_S290, _S290), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

float sheen_scale_0(float x_9, float y_2)
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_10, float y_3)
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_11, float y_4)
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S291 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S292 = 2.0f * sqrt(_S291) - 1.0f;
    float _S293 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S292, _S293), 0.00999999977648258f, 1.0f), clamp((1.0f - _S291) * sheen_shear_0(_S292, _S293), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S292, _S293), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_1, float3 view_2, float scale_1, float shear_0)
{
    float _S294 = light_1.z;
    bool _S295;
    if(_S294 <= 0.0f)
    {
        _S295 = true;
    }
    else
    {
        _S295 = (view_2.z) <= 0.0f;
    }
    if(_S295)
    {
        return 0.0f;
    }
    float2 _S296 = view_2.xy;
    float _S297 = dot(_S296, _S296);
    float2 _S298;
    if(_S297 > 9.99999968265522539e-21f)
    {
        _S298 = _S296 * rsqrt(_S297);
    }
    else
    {
        _S298 = float2(1.0f, 0.0f);
    }
    float _S299 = scale_1 * dot(light_1.xy, _S298) + shear_0 * _S294;
    float _S300 = scale_1 * (light_1.y * _S298.x - light_1.x * _S298.y);
    float _S301 = _S299 * _S299 + _S300 * _S300 + _S294 * _S294;
    return 0.31830987334251404f * scale_1 * scale_1 * _S294 / max(_S301 * _S301, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_2, float3 view_3, float strength_0, float roughness_2)
{
    float3 _S302 = sheen_lobe_0(view_3.z, roughness_2);
    float _S303 = strength_0 * _S302.z;
    return float2(_S303 * transformed_cosine_0(light_2, view_3, _S302.x, _S302.y), 1.0f - _S303);
}

void accumulate_0(uint index_8, float4 light_3)
{
    float _S304 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + layers_0[index_8].share_0 * light_3;
    layers_0[index_8].share_0 = _S304 * (1.0f - light_3.w);
    return;
}

float3 camera_right_0(int _S305)
{
    return float3(frames_0[_S305].right_x_0, frames_0[_S305].right_y_0, frames_0[_S305].right_z_0);
}

float3 camera_up_0(int _S306)
{
    return float3(frames_0[_S306].up_x_0, frames_0[_S306].up_y_0, frames_0[_S306].up_z_0);
}

float3 camera_forward_0(int _S307)
{
    return float3(frames_0[_S307].forward_x_0, frames_0[_S307].forward_y_0, frames_0[_S307].forward_z_0);
}

float3 camera_origin_0(int _S308)
{
    return float3(frames_0[_S308].origin_x_0, frames_0[_S308].origin_y_0, frames_0[_S308].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S309, uint _S310, float _S311, float _S312)
{
    uint _S313 = 3U * _S310;
    Vertex_0 _S314 = vertices_0.Load(corners_0.Load(_S313));
    Vertex_0 _S315 = vertices_0.Load(corners_0.Load(_S313 + 1U));
    Vertex_0 _S316 = vertices_0.Load(corners_0.Load(_S313 + 2U));
    float3 _S317 = position_of_0(_S314);
    float3 _S318 = position_of_0(_S315) - _S317;
    float3 _S319 = position_of_0(_S316) - _S317;
    float _S320 = _S315.u_0 - _S314.u_0;
    float _S321 = _S315.v_0 - _S314.v_0;
    float2 _S322 = float2(_S320, _S321);
    float _S323 = _S316.u_0 - _S314.u_0;
    float _S324 = _S316.v_0 - _S314.v_0;
    float2 _S325 = float2(_S323, _S324);
    float _S326;
    if((_S320 * _S324 - _S321 * _S323) < 0.0f)
    {
        _S326 = -1.0f;
    }
    else
    {
        _S326 = 1.0f;
    }
    float3 _S327 = _S326 * (_S324 * _S318 - _S321 * _S319);
    float3 _S328 = _S326 * (_S320 * _S319 - _S323 * _S318);
    VisiblePoint_0 point_1;
    float3 _S329 = normalize((1.0f - _S311 - _S312) * normal_of_0(_S314) + _S311 * normal_of_0(_S315) + _S312 * normal_of_0(_S316));
    point_1.normal_0 = _S329;
    float3 _S330 = normalize(_S327 - _S329 * dot(_S329, _S327));
    point_1.axis_x_0 = _S330;
    point_1.axis_y_0 = cross(_S329, _S330);
    float3 _S331 = normalize(cross(_S318, _S319));
    float3 _S332;
    if((dot(_S331, _S329)) < 0.0f)
    {
        _S332 = - _S331;
    }
    else
    {
        _S332 = _S331;
    }
    point_1.face_normal_0 = _S332;
    point_1.position_0 = _S317 + _S311 * _S318 + _S312 * _S319;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_1 = float2(_S314.u_0, _S314.v_0) + _S311 * _S322 + _S312 * _S325;
    bool _S333 = (dot(cross(_S327, _S328), point_1.normal_0)) < 0.0f;
    float _S334 = fabrics_0[_S309].uv_width_0;
    if(_S333)
    {
        _S326 = - fabrics_0[_S309].uv_height_0;
    }
    else
    {
        _S326 = fabrics_0[_S309].uv_height_0;
    }
    float2 _S335 = float2(_S334, _S326);
    point_1.draft_per_uv_0 = _S335;
    float2 _S336 = point_1.uv_1 * _S335;
    if(_S333)
    {
        _S326 = fabrics_0[_S309].uv_height_0;
    }
    else
    {
        _S326 = 0.0f;
    }
    point_1.draft_0 = _S336 + float2(0.0f, _S326);
    float2 _S337 = (float2)0.0f;
    point_1.draft_dx_0 = _S337;
    point_1.draft_dy_0 = _S337;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S338, uint _S339, uint _S340, uint2 _S341)
{
    uint _S342 = 3U * _S340;
    Vertex_0 _S343 = vertices_0.Load(corners_0.Load(_S342));
    Vertex_0 _S344 = vertices_0.Load(corners_0.Load(_S342 + 1U));
    Vertex_0 _S345 = vertices_0.Load(corners_0.Load(_S342 + 2U));
    float3 _S346 = position_of_0(_S343);
    float3 _S347 = position_of_0(_S344) - _S346;
    float3 _S348 = position_of_0(_S345) - _S346;
    float3 _S349 = cross(_S347, _S348);
    float _S350 = 1.0f / max(square_0(_S349), 1.00000000317107685e-30f);
    float _S351 = float(frames_0[_S338].width_0);
    float3 _S352 = camera_right_0(_S338) * (2.0f / _S351);
    float _S353 = float(frames_0[_S338].height_0);
    float3 _S354 = camera_up_0(_S338) * (-2.0f / _S353);
    float3 _S355 = camera_forward_0(_S338) + (float(_S341.x) + 0.5f - 0.5f * _S351) * _S352 + (float(_S341.y) + 0.5f - 0.5f * _S353) * _S354;
    float _S356 = dot(_S355, _S349);
    float _S357;
    if((abs(_S356)) > 1.00000000317107685e-30f)
    {
        _S357 = _S356;
    }
    else
    {
        _S357 = 1.00000000317107685e-30f;
    }
    float _S358 = 1.0f / _S357;
    float3 _S359 = _S346 - camera_origin_0(_S338);
    float _S360 = dot(_S359, _S349) * _S358;
    float3 _S361 = _S355 * _S360 - _S359;
    float3 _S362 = _S360 * (_S352 - _S355 * (dot(_S352, _S349) * _S358));
    float3 _S363 = _S360 * (_S354 - _S355 * (dot(_S354, _S349) * _S358));
    float3 _S364 = cross(_S348, _S349) * _S350;
    float3 _S365 = cross(_S349, _S347) * _S350;
    float2 _S366 = float2(_S344.u_0 - _S343.u_0, _S344.v_0 - _S343.v_0);
    float2 _S367 = float2(_S345.u_0 - _S343.u_0, _S345.v_0 - _S343.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S339, _S340, dot(_S361, _S364), dot(_S361, _S365));
    point_2.position_0 = _S346 + _S361;
    point_2.view_0 = - normalize(_S355);
    point_2.draft_dx_0 = (dot(_S362, _S364) * _S366 + dot(_S362, _S365) * _S367) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S363, _S364) * _S366 + dot(_S363, _S365) * _S367) * point_2.draft_per_uv_0;
    return point_2;
}

float3 filtered_albedo_0(uint _S368, VisiblePoint_0 _S369)
{
    uint _S370 = fabrics_0[_S368].albedo_map_levels_0;
    if((fabrics_0[_S368].albedo_map_levels_0) == 0U)
    {
        return (float3)1.0f;
    }
    float2 _S371 = float2(fabrics_0[_S368].uv_width_0, fabrics_0[_S368].uv_height_0);
    float2 _S372 = _S369.draft_dx_0 / _S371;
    float2 _S373 = _S369.draft_dy_0 / _S371;
    uint _S374 = _S370 - 1U;
    uint _S375 = 1U << _S374;
    float _S376 = clamp(0.5f * binary_logarithm_0(max(abs(_S372.x * _S373.y - _S372.y * _S373.x), 9.99999968265522539e-21f) * (square_1(float(_S375)) / 3.0f)), 0.0f, float(_S370) - 1.0f);
    uint _S377 = min(uint(_S376), max(_S370, 2U) - 2U);
    uint _S378 = min(_S377 + 1U, _S374);
    uint _S379 = 1U << (2U * _S370);
    return lerp(map_level_0(fabrics_0[_S368].albedo_map_0 + (_S379 - (_S379 >> (2U * _S377))) / 3U, _S375 >> _S377, _S369.uv_1), map_level_0(fabrics_0[_S368].albedo_map_0 + (_S379 - (_S379 >> (2U * _S378))) / 3U, _S375 >> _S378, _S369.uv_1), (float3)((exponential_0(1.38629436492919922f * (_S376 - float(_S377))) - 1.0f) / 3.0f));
}

struct WovenView_0
{
    float  sums_6[int(96)];
    float hole_0;
    float correction_weight_0;
    float3 view_4;
    bool back_3;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S380, Footprint_0 _S381)
{
    float3 _S382 = row_of_taps_0(_S381);
    float2 _S383 = _S381.dx_0;
    float2 _S384 = _S381.dy_0;
    float _S385 = dot(_S383, _S383) + dot(_S384, _S384);
    float _S386 = _S381.dx_0.x * _S381.dy_0.y - _S381.dx_0.y * _S381.dy_0.x;
    float _S387 = 0.5f * (_S385 + sqrt(max(_S385 * _S385 - 4.0f * _S386 * _S386, 0.0f)));
    Woven_0 _S388 = fabrics_0[_S380].woven_0;
    bool _S389;
    if(_S387 < (5.5f * (_S385 - _S387)))
    {
        _S389 = _S385 > (8.0f * _S388.pitch_0 * _S388.pitch_0);
    }
    else
    {
        _S389 = false;
    }
    float2 _S390 = float2(_S388.ends_per_mm_0, _S388.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    taps_1.centre_1 = _S381.centre_0 * _S390;
    float _S391;
    if(_S389)
    {
        _S391 = sqrt(0.125f * _S385);
    }
    else
    {
        _S391 = _S382.x;
    }
    taps_1.side_1 = _S391 / _S388.pitch_0;
    float2 _S392;
    if(_S389)
    {
        _S392 = 0.25f * _S381.dx_0;
    }
    else
    {
        _S392 = _S382.yz;
    }
    taps_1.first_20 = _S392 * _S390;
    if(_S389)
    {
        _S392 = 0.25f * _S381.dy_0;
    }
    else
    {
        _S392 = 0.5f * _S382.yz;
    }
    taps_1.second_0 = _S392 * _S390;
    return taps_1;
}

void add_texel_0(uint _S393, uint _S394, float _S395, inout float  _S396[int(88)])
{
    uint _S397 = fabrics_0[_S393].woven_0.latents_0 + _S394 * 8U;
    uint part_0 = 0U;
    for(;;)
    {
        if(part_0 < 8U)
        {
        }
        else
        {
            break;
        }
        Eight_0 _S398 = eight_halves_0(packed_numbers_0.Load(_S397 + part_0));
        int _S399 = int(8U * part_0);
        _S396[_S399] = _S396[_S399] + _S395 * _S398.low_0[int(0)];
        _S396[_S399 + int(4)] = _S396[_S399 + int(4)] + _S395 * _S398.high_0[int(0)];
        int _S400 = _S399 + int(1);
        _S396[_S400] = _S396[_S400] + _S395 * _S398.low_0[int(1)];
        _S396[_S400 + int(4)] = _S396[_S400 + int(4)] + _S395 * _S398.high_0[int(1)];
        int _S401 = _S399 + int(2);
        _S396[_S401] = _S396[_S401] + _S395 * _S398.low_0[int(2)];
        _S396[_S401 + int(4)] = _S396[_S401 + int(4)] + _S395 * _S398.high_0[int(2)];
        int _S402 = _S399 + int(3);
        _S396[_S402] = _S396[_S402] + _S395 * _S398.low_0[int(3)];
        _S396[_S402 + int(4)] = _S396[_S402 + int(4)] + _S395 * _S398.high_0[int(3)];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S403, uint _S404, bool _S405, float2 _S406, float _S407, inout float  _S408[int(88)])
{
    Woven_0 _S409 = fabrics_0[_S403].woven_0;
    uint _S410 = fabrics_0[_S403].woven_0.levels_1 + 4U * _S404;
    float _S411 = table_number_0(_S410);
    float _S412 = table_number_0(_S410 + 1U);
    float _S413 = table_number_0(_S410 + 2U);
    bool _S414;
    if(_S404 > 3U)
    {
        _S414 = _S404 < (_S409.top_level_0);
    }
    else
    {
        _S414 = false;
    }
    float2 _S415 = _S406 * table_number_0(_S410 + 3U);
    float _S416;
    if(_S414)
    {
        _S416 = 1.0f;
    }
    else
    {
        _S416 = 0.5f;
    }
    float2 _S417 = _S415 - _S416;
    float2 _S418 = floor(_S417);
    float2 _S419 = _S417 - _S418;
    uint corner_0 = 0U;
    for(;;)
    {
        if(corner_0 < 4U)
        {
        }
        else
        {
            break;
        }
        float _S420 = float(corner_0 & 1U);
        float _S421 = float(corner_0 >> int(1));
        float2 _S422 = lerp(1.0f - _S419, _S419, float2(_S420, _S421));
        uint _S423 = uint(_S411 + wrapped_0(_S418.y + _S421, _S413) * _S412 + wrapped_0(_S418.x + _S420, _S412));
        uint _S424;
        if(_S405)
        {
            _S424 = _S409.texels_0;
        }
        else
        {
            _S424 = 0U;
        }
        add_texel_0(_S403, _S423 + _S424, _S407 * _S422.x * _S422.y, _S408);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S425, AnisotropicTaps_0 _S426, float3 _S427, bool _S428, inout float  _S429[int(88)])
{
    float offset_1;
    int k_0 = int(0);
    for(;;)
    {
        if(k_0 < int(64))
        {
        }
        else
        {
            break;
        }
        _S429[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    float2 _S430 = float2(fabrics_0[_S425].woven_0.ends_0, fabrics_0[_S425].woven_0.picks_0);
    float _S431 = float(fabrics_0[_S425].woven_0.top_level_0);
    float _S432 = clamp(binary_logarithm_0(max(_S426.side_1, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S431);
    float _S433 = min(floor(_S432), _S431 - 1.0f);
    uint _S434;
    if(AnisotropicTaps_has_steps_0(_S426))
    {
        _S434 = 4U;
    }
    else
    {
        _S434 = 1U;
    }
    uint number_2 = 0U;
    for(;;)
    {
        if(number_2 < (2U * _S434))
        {
        }
        else
        {
            break;
        }
        float2 _S435 = AnisotropicTaps_place_0(_S426, number_2 >> int(1));
        float2 _S436 = clamp(_S435 - _S430 * floor(_S435 / _S430), (float2)0.0f, _S430);
        bool _S437 = (number_2 & 1U) != 0U;
        if(_S437)
        {
            offset_1 = _S432 - _S433;
        }
        else
        {
            offset_1 = 1.0f - (_S432 - _S433);
        }
        float _S438 = offset_1 / float(_S434);
        uint _S439 = uint(_S433);
        uint _S440;
        if(_S437)
        {
            _S440 = 1U;
        }
        else
        {
            _S440 = 0U;
        }
        add_level_0(_S425, _S439 + _S440, _S428, _S436, _S438, _S429);
        number_2 = number_2 + 1U;
    }
    int number_3 = int(0);
    for(;;)
    {
        if(number_3 < int(3))
        {
        }
        else
        {
            break;
        }
        int bin_0 = int(0);
        for(;;)
        {
            if(bin_0 < int(8))
            {
            }
            else
            {
                break;
            }
            float offset_2 = _S427[number_3] - (float(bin_0) + 0.5f) / 8.0f;
            if(number_3 < int(2))
            {
                offset_1 = offset_2 - round(offset_2);
            }
            else
            {
                offset_1 = offset_2;
            }
            _S429[int(64) + number_3 * int(8) + bin_0] = bump_0(offset_1 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_3 = number_3 + int(1);
    }
    return;
}

float3 crown_fibres_0(uint _S441, bool _S442, bool _S443)
{
    float _S444;
    if(_S442)
    {
        if(_S443)
        {
            _S444 = - fabrics_0[_S441].woven_0.warp_x_0;
        }
        else
        {
            _S444 = fabrics_0[_S441].woven_0.warp_x_0;
        }
        return float3(_S444, fabrics_0[_S441].woven_0.warp_y_0, fabrics_0[_S441].woven_0.warp_roughness_0);
    }
    Woven_0 _S445 = fabrics_0[_S441].woven_0;
    if(_S443)
    {
        _S444 = - _S445.weft_y_0;
    }
    else
    {
        _S444 = _S445.weft_y_0;
    }
    return float3(_S445.weft_x_0, _S444, _S445.weft_roughness_0);
}

void woven_view_0(uint _S446, Footprint_0 _S447, float3 _S448, inout WovenView_0 _S449)
{
    bool _S450 = (_S448.z) < 0.0f;
    AnisotropicTaps_0 _S451 = anisotropic_taps_0(_S446, _S447);
    float3 _S452 = footprint_coordinates_0(_S451);
    float3 _S453 = to_face_frame_0(_S448, _S450);
    HalfWeights_0 weights_23;
    weights_23.first_2 = fabrics_0[_S446].woven_0.network_0;
    float  inputs_23[int(88)];
    code_footprint_0(_S446, _S451, _S452, _S450, inputs_23);
    float  hidden_0[int(96)];
    dense_7(weights_23, 0U, false, inputs_23, hidden_0);
    float  fused_0[int(100)];
    dense_part_8(weights_23, 1068U, false, hidden_0, fused_0);
    fused_0[int(96)] = _S453.x;
    fused_0[int(97)] = _S453.y;
    float2 _S454 = _S453.xy;
    fused_0[int(98)] = dot(crown_fibres_0(_S446, true, _S450).xy, _S454);
    fused_0[int(99)] = dot(crown_fibres_0(_S446, false, _S450).xy, _S454);
    float  of_hole_0[int(16)];
    dense_6(weights_23, 2232U, false, fused_0, of_hole_0);
    float  hole_1[int(1)];
    dense_5(weights_23, 2444U, false, of_hole_0, hole_1);
    dense_4(weights_23, 2456U, false, fused_0, _S449.sums_6);
    _S449.hole_0 = clamp(hole_1[int(0)], 0.0f, 1.0f);
    _S449.correction_weight_0 = correction_weight_of_0(_S452.z);
    _S449.view_4 = _S453;
    _S449.back_3 = _S450;
    return;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_1;
    Albedos_0 weft_1;
};

FamilyAlbedos_0 albedos_over_0(uint _S455, Footprint_0 _S456, bool _S457)
{
    float2 _S458 = _S456.dx_0;
    float2 _S459 = _S456.dy_0;
    float2 _S460 = sqrt(_S458 * _S458 + _S459 * _S459);
    Stretch_0 _S461 = stretch_of_0(fabrics_0[_S455].warp_0, _S456.centre_0.x, _S460.x);
    Stretch_0 _S462 = stretch_of_0(fabrics_0[_S455].weft_0, _S456.centre_0.y, _S460.y);
    FamilyAlbedos_0 albedos_4;
    albedos_4.warp_1 = mean_albedos_0(fabrics_0[_S455].warp_0, fabrics_0[_S455].weft_0, _S461, _S462, _S457);
    albedos_4.weft_1 = mean_albedos_0(fabrics_0[_S455].weft_0, fabrics_0[_S455].warp_0, _S462, _S461, _S457);
    return albedos_4;
}

uint light_sample_count_0(int _S463)
{
    return frames_0[_S463].lights_0 + frames_0[_S463].environment_samples_0;
}

float visibility_at_0(int _S464, uint _S465, uint2 _S466)
{
    if((frames_0[_S464].casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return visibilities_0[(_S465 * frames_0[_S464].height_0 + _S466.y) * frames_0[_S464].width_0 + _S466.x];
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_1;
};

float3 environment_texel_0(int _S467, uint _S468, uint _S469)
{
    uint _S470 = frames_0[_S467].environment_table_0 + frames_0[_S467].environment_rows_0 + 1U + frames_0[_S467].environment_rows_0 * (frames_0[_S467].environment_columns_0 + 1U) + 3U * (_S468 * frames_0[_S467].environment_columns_0 + _S469);
    return float3(scene_number_0(_S470), scene_number_0(_S470 + 1U), scene_number_0(_S470 + 2U));
}

float3 sample_environment_0(int _S471, float2 _S472, out float3 _S473)
{
    uint _S474 = frames_0[_S471].environment_rows_0;
    Choice_0 _S475 = choose_0(frames_0[_S471].environment_table_0, frames_0[_S471].environment_rows_0, _S472.y);
    uint _S476 = frames_0[_S471].environment_columns_0;
    Choice_0 _S477 = choose_0(frames_0[_S471].environment_table_0 + frames_0[_S471].environment_rows_0 + 1U + _S475.index_7 * (frames_0[_S471].environment_columns_0 + 1U), frames_0[_S471].environment_columns_0, _S472.x);
    float3 _S478 = environment_texel_0(_S471, _S475.index_7, _S477.index_7);
    _S473 = _S478 * (frames_0[_S471].environment_total_0 / max(mean_0(_S478), 9.99999968265522539e-21f));
    float _S479 = 3.14159274101257324f / float(_S474);
    float _S480 = lerp(sine_cosine_0(float(_S475.index_7) * _S479).y, sine_cosine_0(float(_S475.index_7 + 1U) * _S479).y, _S475.remainder_0);
    float _S481 = sqrt(max(1.0f - _S480 * _S480, 0.0f));
    float2 _S482 = sine_cosine_0((float(_S477.index_7) + _S477.remainder_0) * (6.28318548202514648f / float(_S476)));
    float _S483 = _S481 * _S482.x;
    float _S484 = - _S481 * _S482.y;
    return float3(frames_0[_S471].environment_cosine_0 * _S483 + frames_0[_S471].environment_sine_0 * _S484, _S480, frames_0[_S471].environment_cosine_0 * _S484 - frames_0[_S471].environment_sine_0 * _S483);
}

LightSample_0 light_sample_0(int _S485, uint _S486, uint2 _S487, float3 _S488)
{
    LightSample_0 sample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    uint _S489 = frames_0[_S485].lights_0;
    if(_S486 >= (frames_0[_S485].lights_0))
    {
        float3 weight_2;
        float3 _S490 = sample_environment_0(_S485, pixel_sequence_0(_S487, frames_0[_S485].pass_number_0 * frames_0[_S485].environment_samples_0 + (_S486 - _S489), 3U), weight_2);
        sample_0.towards_0 = _S490;
        sample_0.irradiance_1 = weight_2 / float(frames_0[_S485].environment_samples_0);
        return sample_0;
    }
    Light_0 _S491 = lights_1.Load(_S486);
    sample_0.irradiance_1 = float3(_S491.red_0, _S491.green_0, _S491.blue_0);
    sample_0.towards_0 = float3(_S491.x_1, _S491.y_1, _S491.z_1);
    if((_S491.is_point_0) != 0U)
    {
        float3 _S492 = sample_0.towards_0 - _S488;
        float _S493 = max(square_0(_S492), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S493);
        sample_0.irradiance_1 = sample_0.irradiance_1 / _S493;
        sample_0.towards_0 = normalize(_S492);
    }
    return sample_0;
}

struct Components_0
{
    float diffuse_warp_0;
    float diffuse_weft_0;
    float specular_warp_0;
    float specular_weft_0;
    float light_visibility_1;
    float hole_2;
};

void code_light_0(uint _S494, float3 _S495, float3 _S496, bool _S497, inout float  _S498[int(39)])
{
    _S498[int(0)] = _S495.x;
    _S498[int(1)] = _S495.y;
    _S498[int(2)] = _S495.z;
    float3 _S499 = _S495 + _S496;
    float _S500 = _S499.z;
    float _S501 = _S500 * _S500 + 0.00009999999747379f;
    float2 _S502 = _S499.xy;
    float _S503 = 1.0f / (dot(_S502, _S502) + _S501);
    int family_10 = int(0);
    for(;;)
    {
        if(family_10 < int(2))
        {
        }
        else
        {
            break;
        }
        float3 _S504 = crown_fibres_0(_S494, family_10 == int(0), _S497);
        float2 _S505 = _S504.xy;
        _S498[int(3) + family_10] = dot(_S505, _S495.xy);
        float _S506 = dot(_S505, _S502);
        float _S507 = _S506 * _S506;
        float _S508 = (0.75f * _S506 / (0.5f * sqrt(_S507 + _S501) + abs(_S506)) + 0.5f) * 8.0f;
        int bin_1 = int(0);
        for(;;)
        {
            if(bin_1 < int(16))
            {
            }
            else
            {
                break;
            }
            _S498[int(5) + family_10 * int(16) + bin_1] = bump_0(_S508 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S509 = _S504.z;
        float _S510 = _S509 * _S509;
        float _S511 = _S507 * _S503 * (1.0f - _S510) + _S510;
        _S498[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S510 * _S509 / (_S511 * _S511));
        family_10 = family_10 + int(1);
    }
    return;
}

float mixed_bundles_0(uint _S512, uint _S513, uint _S514, float3 _S515, float3 _S516, bool _S517, inout float  _S518[int(52)])
{
    float3 _S519 = _S515 + _S516;
    float _S520 = 1.0f / (square_0(_S519) + 0.00009999999747379f);
    bool _S521;
    if(_S513 == 0U)
    {
        _S521 = _S517;
    }
    else
    {
        _S521 = false;
    }
    float _S522;
    if(_S521)
    {
        _S522 = - _S519.x;
    }
    else
    {
        _S522 = _S519.x;
    }
    if(_S513 == 1U)
    {
        _S521 = _S517;
    }
    else
    {
        _S521 = false;
    }
    float _S523;
    if(_S521)
    {
        _S523 = - _S519.y;
    }
    else
    {
        _S523 = _S519.y;
    }
    uint bundle_1 = 0U;
    float sum_1 = 0.0f;
    for(;;)
    {
        if(bundle_1 < 25U)
        {
        }
        else
        {
            break;
        }
        uint _S524 = _S513 * 25U;
        uint _S525 = fabrics_0[_S512].woven_0.bundles_0 + 4U * (_S524 + bundle_1);
        float _S526 = dot(float3(table_number_0(_S525), table_number_0(_S525 + 1U), table_number_0(_S525 + 2U)), float3(_S522, _S523, _S519.z));
        float _S527 = _S526 * _S526 * _S520 + table_number_0(_S525 + 3U);
        uint _S528 = _S514 + _S524;
        uint _S529;
        if(_S517)
        {
            _S529 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S529 = bundle_1;
        }
        float sum_2 = sum_1 + max(_S518[_S528 + _S529], _S518[_S528 + _S529] * 0.00999999977648258f) / (_S527 * _S527);
        bundle_1 = bundle_1 + 1U;
        sum_1 = sum_2;
    }
    return 0.01999999955296516f * sum_1;
}

Components_0 woven_components_0(uint _S530, inout WovenView_0 _S531, float3 _S532)
{
    float _S533;
    bool _S534 = _S531.back_3;
    float3 _S535 = to_face_frame_0(_S532, _S531.back_3);
    float3 _S536 = _S531.view_4;
    HalfWeights_0 weights_24;
    Woven_0 _S537 = fabrics_0[_S530].woven_0;
    weights_24.first_2 = fabrics_0[_S530].woven_0.network_0;
    float  directions_0[int(39)];
    code_light_0(_S530, _S535, _S531.view_4, _S531.back_3, directions_0);
    float  skip_0[int(96)];
    int k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(96))
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = _S531.sums_6[k_1];
        k_1 = k_1 + int(1);
    }
    dense_3(weights_24, 3716U, true, directions_0, skip_0);
    float  hidden_1[int(96)];
    float  next_0[int(96)];
    k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(96))
        {
        }
        else
        {
            break;
        }
        hidden_1[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
        k_1 = k_1 + int(1);
    }
    uint layer_0 = 0U;
    for(;;)
    {
        if(layer_0 < 3U)
        {
        }
        else
        {
            break;
        }
        k_1 = int(0);
        for(;;)
        {
            if(k_1 < int(96))
            {
            }
            else
            {
                break;
            }
            if(layer_0 == 1U)
            {
                _S533 = skip_0[k_1];
            }
            else
            {
                _S533 = 0.0f;
            }
            next_0[k_1] = _S533;
            k_1 = k_1 + int(1);
        }
        dense_2(weights_24, 4208U + layer_0 * 1164U, true, hidden_1, next_0);
        int k_2 = int(0);
        for(;;)
        {
            if(k_2 < int(96))
            {
            }
            else
            {
                break;
            }
            hidden_1[k_2] = next_0[k_2];
            k_2 = k_2 + int(1);
        }
        layer_0 = layer_0 + 1U;
    }
    float  outputs_17[int(52)];
    dense_1(weights_24, 7700U, false, hidden_1, outputs_17);
    bool _S538;
    if((_S537.is_corrected_0) != 0U)
    {
        _S538 = (_S535.z) > 0.0f;
    }
    else
    {
        _S538 = false;
    }
    if(_S538)
    {
        _S538 = (_S531.correction_weight_0) > 0.0f;
    }
    else
    {
        _S538 = false;
    }
    if(_S538)
    {
        FloatWeights_0 fitted_0;
        fitted_0.first_0 = _S537.correction_0;
        float  change_0[int(50)];
        dense_0(fitted_0, 0U, false, hidden_1, change_0);
        k_1 = int(0);
        for(;;)
        {
            if(k_1 < int(50))
            {
            }
            else
            {
                break;
            }
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S531.correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S535.z) > 0.0f)
    {
        _S533 = 0.00999999977648258f;
    }
    else
    {
        _S533 = 0.00100000004749745f;
    }
    Components_0 result_1;
    float _S539 = unmapped_0(outputs_17[int(0)], _S533);
    result_1.diffuse_warp_0 = _S539;
    float _S540 = unmapped_0(outputs_17[int(1)], _S533);
    result_1.diffuse_weft_0 = _S540;
    float _S541 = 2979.9580078125f * _S533;
    float _S542 = mixed_bundles_0(_S530, 0U, 2U, _S535, _S536, _S534, outputs_17);
    result_1.specular_warp_0 = clamp(_S542, 0.0f, _S541);
    float _S543 = mixed_bundles_0(_S530, 1U, 2U, _S535, _S536, _S534, outputs_17);
    result_1.specular_weft_0 = clamp(_S543, 0.0f, _S541);
    result_1.hole_2 = _S531.hole_0;
    result_1.light_visibility_1 = min(light_visibility_of_0(_S539 + _S540, _S535, _S536, fabrics_0[_S530].diffuse_blend_0), 1.0f - _S531.hole_0);
    return result_1;
}

float3 composed_0(uint _S544, Components_0 _S545, FamilyAlbedos_0 _S546, float3 _S547, float3 _S548)
{
    float3 _S549 = _S546.warp_1.diffuse_reflect_0 * _S545.diffuse_warp_0 + _S546.weft_1.diffuse_reflect_0 * _S545.diffuse_weft_0 + _S546.warp_1.specular_reflect_0 * _S545.specular_warp_0 + _S546.weft_1.specular_reflect_0 * _S545.specular_weft_0;
    float _S550 = _S548.z;
    float3 body_0;
    if((_S547.z * _S550) < 0.0f)
    {
        body_0 = _S546.warp_1.diffuse_transmit_0 * _S545.diffuse_warp_0 + _S546.weft_1.diffuse_transmit_0 * _S545.diffuse_weft_0 + _S546.warp_1.specular_transmit_0 * _S545.specular_warp_0 + _S546.weft_1.specular_transmit_0 * _S545.specular_weft_0;
    }
    else
    {
        body_0 = _S549;
    }
    float _S551 = fabrics_0[_S544].sheen_strength_0;
    if((fabrics_0[_S544].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S552 = _S550 < 0.0f;
    float2 _S553 = sheen_with_transmittance_0(to_face_frame_0(_S547, _S552), to_face_frame_0(_S548, _S552), _S551, fabrics_0[_S544].sheen_roughness_0);
    return _S553.y * body_0 + (_S545.light_visibility_1 + _S545.hole_2) * _S553.x;
}

float4 light_of_woven_0(int _S554, uint _S555, VisiblePoint_0 _S556, uint2 _S557, float3 _S558)
{
    Footprint_0 footprint_1;
    footprint_1.centre_0 = _S556.draft_0;
    footprint_1.dx_0 = _S556.draft_dx_0;
    footprint_1.dy_0 = _S556.draft_dy_0;
    float3 _S559 = to_local_0(_S556, _S556.view_0);
    WovenView_0 activations_0;
    woven_view_0(_S555, footprint_1, _S559, activations_0);
    float _S560 = _S559.z;
    FamilyAlbedos_0 _S561 = albedos_over_0(_S555, footprint_1, _S560 < 0.0f);
    FamilyAlbedos_0 albedos_5;
    albedos_5.warp_1 = tinted_0(_S561.warp_1, _S558);
    albedos_5.weft_1 = tinted_0(_S561.weft_1, _S558);
    float3 _S562 = (float3)0.0f;
    uint number_4 = 0U;
    float3 radiance_1 = _S562;
    for(;;)
    {
        if(number_4 < (light_sample_count_0(_S554)))
        {
        }
        else
        {
            break;
        }
        float _S563 = visibility_at_0(_S554, number_4, _S557);
        if(_S563 <= 0.0f)
        {
            number_4 = number_4 + 1U;
            continue;
        }
        LightSample_0 _S564 = light_sample_0(_S554, number_4, _S557, _S556.position_0);
        float3 _S565 = to_local_0(_S556, _S564.towards_0);
        Components_0 _S566 = woven_components_0(_S555, activations_0, _S565);
        radiance_1 = radiance_1 + _S563 * _S564.irradiance_1 * composed_0(_S555, _S566, albedos_5, _S565, _S559);
        number_4 = number_4 + 1U;
    }
    float hole_3 = activations_0.hole_0;
    float _S567 = fabrics_0[_S555].sheen_strength_0;
    float hole_4;
    if((fabrics_0[_S555].sheen_strength_0) > 0.0f)
    {
        hole_4 = hole_3 * (1.0f - _S567 * sheen_lobe_0(abs(_S560), fabrics_0[_S555].sheen_roughness_0).z);
    }
    else
    {
        hole_4 = hole_3;
    }
    return float4(radiance_1, 1.0f - hole_4);
}

[numthreads(8, 8, 1)]
void shade_woven(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S568 = frames_0[int(0)].width_0;
    bool _S569;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S569 = true;
    }
    else
    {
        _S569 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S569)
    {
        return;
    }
    uint _S570 = id_0.y * _S568 + id_0.x;
    uint _S571 = layers_0[_S570].face_0;
    if((layers_0[_S570].face_0) == 0U)
    {
        return;
    }
    uint _S572 = _S571 - 1U;
    uint _S573 = face_fabrics_0.Load(_S572);
    VisiblePoint_0 _S574 = visible_point_0(int(0), _S573, _S572, id_0.xy);
    accumulate_0(_S570, light_of_woven_0(int(0), _S573, _S574, id_0.xy, filtered_albedo_0(_S573, _S574)));
    return;
}

