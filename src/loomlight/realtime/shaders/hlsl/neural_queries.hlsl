#pragma pack_matrix(column_major)
#ifdef SLANG_HLSL_ENABLE_NVAPI
#include "nvHLSLExtns.h"
#endif

#ifndef __DXC_VERSION_MAJOR
// warning X3557: loop doesn't seem to do anything, forcing loop to unroll
#pragma warning(disable : 3557)
#endif

StructuredBuffer<uint > query_count_0 : register(t15);

struct Query_0
{
    uint fabric_0;
    float centre_x_0;
    float centre_y_0;
    float dx_x_0;
    float dx_y_0;
    float dy_x_0;
    float dy_y_0;
    float light_x_0;
    float light_y_0;
    float light_z_0;
    float view_x_0;
    float view_y_0;
    float view_z_0;
    uint seed_0;
};

StructuredBuffer<Query_0 > queries_0 : register(t14);

RWStructuredBuffer<float4 > answers_0 : register(u10);

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

struct Neural_0
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
    uint transmits_0;
    uint transmission_0;
    uint has_holes_0;
    uint opacity_0;
};

struct Latent_0
{
    uint is_trained_1;
    uint decoder_1;
    uint hidden_0;
    uint frames_0;
    uint sampler_0;
    uint albedo_0;
    uint texels_1;
    uint texel_elements_1;
    uint levels_3;
    float last_level_2;
    uint face_texels_1;
    uint back_1;
    float repeats_per_x_1;
    float repeats_per_y_1;
    float texels_per_mm_1;
    float width_0;
    float height_0;
    uint is_trilinear_0;
};

struct Clustered_0
{
    uint is_baked_1;
    uint clusters_0;
    uint rank_0;
    uint channels_0;
    uint columns_0;
    uint rows_0;
    float texel_width_0;
    float texel_height_0;
    uint samples_0;
    uint sums_0;
    uint labels_0;
    uint coefficients_0;
    uint basis_0;
    uint moments_1;
    uint light_0;
    uint view_0;
    uint offset_1;
    uint trust_0;
};

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Neural_0 neural_0;
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
    uint seed_1;
    float layer_bound_0;
    float fibre_size_0;
    uint has_detail_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint openness_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
    uint has_yarns_0;
    float mean_hole_0;
    Latent_0 latent_0;
    Clustered_0 clustered_0;
};

StructuredBuffer<Fabric_0 > fabrics_0 : register(t0);

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
    float has_plies_0;
    float plies_per_mm_0;
    float ply_sine_0;
    float ply_cosine_0;
    float fibre_tilt_0;
    float fibre_tone_0;
    float slub_0;
    float slubs_per_mm_0;
    float per_half_width_0;
    float hairiness_0;
};

StructuredBuffer<Family_0 > families_0 : register(t1);

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
    float4 sums_1 = (float4)0.0f;
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
        sums_1[int(0)] = sums_1[int(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_1[int(1)] = sums_1[int(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        sums_1[int(2)] = sums_1[int(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        sums_1[int(3)] = sums_1[int(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
}

int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

float Identity_apply_0(float x_0)
{
    return x_0;
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
    float4 sums_2 = (float4)0.0f;
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
        sums_2[int(0)] = sums_2[int(0)] + (dot(_S29.low_0, low_2) + dot(_S29.high_0, high_2));
        Eight_0 _S30 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1);
        sums_2[int(1)] = sums_2[int(1)] + (dot(_S30.low_0, low_2) + dot(_S30.high_0, high_2));
        Eight_0 _S31 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1);
        sums_2[int(2)] = sums_2[int(2)] + (dot(_S31.low_0, low_2) + dot(_S31.high_0, high_2));
        Eight_0 _S32 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1);
        sums_2[int(3)] = sums_2[int(3)] + (dot(_S32.low_0, low_2) + dot(_S32.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
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
    float4 sums_3 = (float4)0.0f;
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
        sums_3[int(0)] = sums_3[int(0)] + (dot(_S48.low_0, low_3) + dot(_S48.high_0, high_3));
        Eight_0 _S49 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2);
        sums_3[int(1)] = sums_3[int(1)] + (dot(_S49.low_0, low_3) + dot(_S49.high_0, high_3));
        Eight_0 _S50 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2);
        sums_3[int(2)] = sums_3[int(2)] + (dot(_S50.low_0, low_3) + dot(_S50.high_0, high_3));
        Eight_0 _S51 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2);
        sums_3[int(3)] = sums_3[int(3)] + (dot(_S51.low_0, low_3) + dot(_S51.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
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
    float4 sums_4 = (float4)0.0f;
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
        sums_4[int(0)] = sums_4[int(0)] + (dot(_S67.low_0, low_4) + dot(_S67.high_0, high_4));
        Eight_0 _S68 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3);
        sums_4[int(1)] = sums_4[int(1)] + (dot(_S68.low_0, low_4) + dot(_S68.high_0, high_4));
        Eight_0 _S69 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3);
        sums_4[int(2)] = sums_4[int(2)] + (dot(_S69.low_0, low_4) + dot(_S69.high_0, high_4));
        Eight_0 _S70 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3);
        sums_4[int(3)] = sums_4[int(3)] + (dot(_S70.low_0, low_4) + dot(_S70.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
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
    float4 sums_5 = (float4)0.0f;
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
        sums_5[int(0)] = sums_5[int(0)] + (dot(_S86.low_0, low_5) + dot(_S86.high_0, high_5));
        Eight_0 _S87 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4);
        sums_5[int(1)] = sums_5[int(1)] + (dot(_S87.low_0, low_5) + dot(_S87.high_0, high_5));
        Eight_0 _S88 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4);
        sums_5[int(2)] = sums_5[int(2)] + (dot(_S88.low_0, low_5) + dot(_S88.high_0, high_5));
        Eight_0 _S89 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4);
        sums_5[int(3)] = sums_5[int(3)] + (dot(_S89.low_0, low_5) + dot(_S89.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_5;
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

float LeakyRelu_apply_0(float x_1)
{
    return max(x_1, x_1 * 0.00999999977648258f);
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
    float4 sums_6 = (float4)0.0f;
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
        sums_6[int(0)] = sums_6[int(0)] + (dot(_S127.low_0, low_6) + dot(_S127.high_0, high_6));
        Eight_0 _S128 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5);
        sums_6[int(1)] = sums_6[int(1)] + (dot(_S128.low_0, low_6) + dot(_S128.high_0, high_6));
        Eight_0 _S129 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5);
        sums_6[int(2)] = sums_6[int(2)] + (dot(_S129.low_0, low_6) + dot(_S129.high_0, high_6));
        Eight_0 _S130 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5);
        sums_6[int(3)] = sums_6[int(3)] + (dot(_S130.low_0, low_6) + dot(_S130.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_6;
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

float square_0(float x_2)
{
    return x_2 * x_2;
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float3 row_of_taps_0(Footprint_0 footprint_0)
{
    float _S153 = footprint_0.dx_0.x;
    float _S154 = footprint_0.dy_0.x;
    float _S155 = _S153 * _S153 + _S154 * _S154;
    float _S156 = footprint_0.dx_0.y;
    float _S157 = footprint_0.dy_0.y;
    float _S158 = _S156 * _S156 + _S157 * _S157;
    float _S159 = _S153 * _S156 + _S154 * _S157;
    float _S160 = 0.5f * (_S155 - _S158);
    float _S161 = 0.5f * (_S155 + _S158);
    float _S162 = sqrt(_S160 * _S160 + _S159 * _S159);
    float _S163 = _S161 + _S162;
    float _S164 = max(_S163 - 1.5f * max(_S161 - _S162, 0.0f), 0.0f);
    float _S165 = square_0(4.0f);
    float _S166 = max(_S161 - 0.5f * _S164, _S163 / _S165);
    float _S167 = sqrt(max(min(_S164, _S163 - _S166), 0.0f) / (_S165 - 1.0f));
    float _S168 = _S160 / max(_S162, 1.00000000317107685e-30f);
    float _S169 = sqrt(max(0.5f * (1.0f - _S168), 0.0f));
    float _S170 = sqrt(_S166);
    float _S171 = _S167 * sqrt(max(0.5f * (1.0f + _S168), 0.0f));
    float _S172;
    if(_S159 < 0.0f)
    {
        _S172 = - _S167 * _S169;
    }
    else
    {
        _S172 = _S167 * _S169;
    }
    return float3(_S170, _S171, _S172);
}

struct AnisotropicTaps_0
{
    float2 centre_1;
    float side_0;
    float2 first_19;
    float2 second_0;
};

float AnisotropicTaps_size_0(AnisotropicTaps_0 this_2)
{
    float _S173 = this_2.first_19.x;
    float _S174 = this_2.second_0.x;
    float _S175 = this_2.side_0;
    float _S176 = _S175 * _S175;
    float _S177 = this_2.first_19.y;
    float _S178 = this_2.second_0.y;
    float _S179 = 12.0f * (_S173 * _S177 + _S174 * _S178);
    return sqrt(sqrt(max((12.0f * (_S173 * _S173 + _S174 * _S174) + _S176) * (12.0f * (_S177 * _S177 + _S178 * _S178) + _S176) - _S179 * _S179, square_0(_S176))));
}

float natural_logarithm_0(float x_3)
{
    uint _S180 = asuint(x_3);
    float exponent_0 = float(int(_S180 >> int(23)) - int(126));
    float m_0 = asfloat((_S180 & 8388607U) | 1056964608U);
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
    float _S181 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S181 - exponent_1 * 0.00021219444170129f - 0.5f * _S181) + exponent_1 * 0.693359375f;
}

float3 footprint_coordinates_0(AnisotropicTaps_0 taps_0)
{
    return float3(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

float3 to_face_frame_0(float3 direction_0, bool back_2)
{
    float2 _S182 = direction_0.xy;
    float _S183;
    if(back_2)
    {
        _S183 = - direction_0.z;
    }
    else
    {
        _S183 = direction_0.z;
    }
    return float3(_S182, _S183);
}

float table_number_0(uint index_0)
{
    return asfloat(words_0.Load(index_0));
}

float wrapped_0(float index_1, float count_1)
{
    float _S184;
    if(index_1 < 0.0f)
    {
        _S184 = index_1 + count_1;
    }
    else
    {
        if(index_1 >= count_1)
        {
            _S184 = index_1 - count_1;
        }
        else
        {
            _S184 = index_1;
        }
    }
    return _S184;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 this_3)
{
    float2 _S185 = this_3.first_19;
    float2 _S186 = this_3.second_0;
    return (max(dot(_S185, _S185), dot(_S186, _S186))) > 0.0f;
}

float2 AnisotropicTaps_place_0(AnisotropicTaps_0 this_4, uint number_0)
{
    float _S187;
    if(number_0 >= 2U)
    {
        _S187 = 1.0f;
    }
    else
    {
        _S187 = -1.0f;
    }
    float _S188;
    if((number_0 & 1U) != 0U)
    {
        _S188 = 1.0f;
    }
    else
    {
        _S188 = -1.0f;
    }
    return this_4.centre_1 + _S187 * this_4.first_19 + _S188 * this_4.second_0;
}

float bump_0(float distance_0)
{
    float _S189 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S189 * _S189;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

float exponential_0(float x_5)
{
    float _S190 = clamp(x_5, -87.0f, 88.0f);
    float _S191 = floor(_S190 * 1.4426950216293335f + 0.5f);
    float _S192 = _S190 - _S191 * 0.693359375f + _S191 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S192 + 0.00139819993637502f) * _S192 + 0.00833345204591751f) * _S192 + 0.04166579619050026f) * _S192 + 0.1666666567325592f) * _S192 + 0.5f;
    float _S193 = asfloat(uint(int(_S191) + int(127)) << int(23));
    float _S194;
    if(x_5 < -87.0f)
    {
        _S194 = 0.0f;
    }
    else
    {
        _S194 = (p_0 * _S192 * _S192 + _S192 + 1.0f) * _S193;
    }
    return _S194;
}

float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

float square_1(float3 v_0)
{
    return dot(v_0, v_0);
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S195 = bundle_0 / 3U;
    uint _S196 = bundle_0 % 3U;
    uint _S197;
    if(bundle_0 == 24U)
    {
        _S197 = bundle_0;
    }
    else
    {
        _S197 = _S195 * 3U + 3U - 1U - _S196;
    }
    return _S197;
}

float light_visibility_of_0(float diffuse_0, float3 light_1, float3 view_1, float blend_0)
{
    float _S198 = max(abs(light_1.z), 0.00100000004749745f);
    float2 _S199 = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / lerp(_S198, (0.59700000286102295f * _S198 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S199, view_1.xy) * rsqrt(max(dot(_S199, _S199), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

float2 turns_and_remainder_0(uint family_0, float index_2)
{
    float _S200 = floor(mad(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return float2(_S200, mad(- _S200, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S201 = floor(position_0 * families_0[family_1].inverse_size_0);
    Cell_0 cell_0;
    float _S202 = mad(- _S201, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S202;
    cell_0.above_0 = families_0[family_1].size_0 - _S202;
    cell_0.across_0 = _S202 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S201).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float turns_0 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S203 = turns_1 * families_0[family_2].period_0;
    uint thread_1 = words_0.Load(families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f)));
    uint _S204;
    if(_S203 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S204 = 1U;
    }
    else
    {
        _S204 = 0U;
    }
    uint _S205 = min(thread_1 + _S204, uint(families_0[family_2].count_0) - 1U);
    uint _S206 = families_0[family_2].place_table_0 + _S205 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S205;
    cell_1.below_0 = _S203 - table_number_0(_S206);
    cell_1.above_0 = table_number_0(_S206 + 1U) - _S203;
    cell_1.across_0 = _S203 - table_number_0(_S206 + 2U);
    cell_1.half_width_1 = table_number_0(_S206 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2)
{
    if((families_0[family_3].is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
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

Bound_0 bound_at_0(uint family_4, float position_3)
{
    Cell_0 _S207 = locate_0(family_4, position_3);
    float _S208 = table_number_0(families_0[family_4].before_0 + 2U * _S207.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_2 = _S207.thread_0;
    bound_0.turns_2 = round((position_3 - families_0[family_4].start_0 - _S208 - _S207.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S207.below_0;
    float _S209 = 2.0f * _S207.half_width_1;
    bound_0.width_1 = _S209;
    bound_0.visible_0 = clamp((_S207.across_0 + _S207.half_width_1) / _S209, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S207.below_0, _S207.below_0 - _S207.across_0 - _S207.half_width_1) + max(_S207.across_0 - _S207.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S210 = centre_2 - floor((centre_2 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    float _S211 = 0.5f * max(size_1, families_0[family_5].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S210 - _S211);
    stretch_0.high_7 = bound_at_0(family_5, _S210 + _S211);
    return stretch_0;
}

float3 table_colour_0(uint index_3)
{
    return float3(table_number_0(index_3), table_number_0(index_3 + 1U), table_number_0(index_3 + 2U));
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
    float _S212 = Stretch_turns_0(stretch_1);
    uint _S213 = families_0[family_6].before_0 + 2U * stretch_1.low_7.thread_2;
    uint _S214 = families_0[family_6].before_0 + 2U * stretch_1.high_7.thread_2;
    float _S215 = table_number_0(_S214) - table_number_0(_S213);
    float _S216 = table_number_0(_S214 + 1U) - table_number_0(_S213 + 1U);
    return float3(_S215 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_1 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_1 + _S212 * families_0[family_6].visible_total_0, _S216 - _S215 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S212 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S216 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S212 * families_0[family_6].period_0);
}

float2 integrals_along_0(uint family_7, Stretch_0 stretch_2, uint quantity_0)
{
    uint _S217 = 3U * families_0[family_7].quantities_0;
    uint _S218 = families_0[family_7].colour_threads_0 + _S217 * stretch_2.low_7.thread_2 + quantity_0;
    uint _S219 = families_0[family_7].colour_threads_0 + _S217 * stretch_2.high_7.thread_2 + quantity_0;
    uint _S220 = families_0[family_7].colour_threads_0 + _S217 * uint(families_0[family_7].count_0) + quantity_0;
    float _S221 = table_number_0(_S218);
    float _S222 = table_number_0(_S219);
    float _S223 = Stretch_turns_0(stretch_2);
    uint _S224 = 2U * families_0[family_7].quantities_0;
    return float2(table_number_0(_S219 + families_0[family_7].quantities_0) - table_number_0(_S218 + families_0[family_7].quantities_0) + _S222 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_1 - _S221 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_1 + _S223 * table_number_0(_S220 + families_0[family_7].quantities_0), table_number_0(_S219 + _S224) - table_number_0(_S218 + _S224) + _S222 * stretch_2.high_7.cell_2 - _S221 * stretch_2.low_7.cell_2 + _S223 * table_number_0(_S220 + _S224));
}

bool Stretch_wraps_0(Stretch_0 this_6)
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

uint4 Stretch_differences_0(Stretch_0 this_7, uint4 entries_0, uint whole_0)
{
    uint _S225 = entries_0.z;
    uint _S226 = entries_0.x;
    uint _S227 = _S225 - _S226;
    uint _S228;
    if(Stretch_wraps_0(this_7))
    {
        _S228 = whole_0;
    }
    else
    {
        _S228 = 0U;
    }
    return uint4(_S227 + _S228, entries_0.w - _S225, entries_0.y - _S226, whole_0);
}

uint4 row_differences_0(Stretch_0 across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S229 = row_7 + across_1.low_7.thread_2 * quantities_1;
    uint _S230 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, uint4(words_0.Load(_S229), words_0.Load(_S229 + quantities_1), words_0.Load(_S230), words_0.Load(_S230 + quantities_1)), words_0.Load(row_7 + count_2 * quantities_1));
}

float4 Stretch_weights_0(Stretch_0 this_8)
{
    float _S231 = - this_8.low_7.visible_0;
    float _S232 = Stretch_turns_0(this_8);
    float _S233;
    if(Stretch_wraps_0(this_8))
    {
        _S233 = 1.0f;
    }
    else
    {
        _S233 = 0.0f;
    }
    return float4(1.0f, this_8.high_7.visible_0, _S231, _S232 - _S233);
}

float integral_on_top_0(uint family_8, Stretch_0 across_2, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S234 = uint(families_0[family_8].count_0);
    uint _S235 = (_S234 + 1U) * families_0[family_8].quantities_0;
    uint _S236 = families_0[family_8].colour_areas_0 + quantity_1;
    uint4 _S237 = row_differences_0(across_2, _S236 + along_0.low_7.thread_2 * _S235, _S234, families_0[family_8].quantities_0);
    uint4 _S238 = row_differences_0(across_2, _S236 + (along_0.low_7.thread_2 + 1U) * _S235, _S234, families_0[family_8].quantities_0);
    uint4 _S239 = row_differences_0(across_2, _S236 + along_0.high_7.thread_2 * _S235, _S234, families_0[family_8].quantities_0);
    uint4 _S240 = row_differences_0(across_2, _S236 + (along_0.high_7.thread_2 + 1U) * _S235, _S234, families_0[family_8].quantities_0);
    uint4 _S241 = row_differences_0(across_2, _S236 + crossing_count_0 * _S235, _S234, families_0[family_8].quantities_0);
    uint4 _S242 = _S239 - _S237;
    uint4 _S243;
    if(Stretch_wraps_0(along_0))
    {
        _S243 = _S241;
    }
    else
    {
        _S243 = uint4((int4)int(0));
    }
    float4 _S244 = Stretch_weights_0(across_2);
    return dot(float4(dot(float4(int4(_S242 + _S243)), _S244), dot(float4(int4(_S240 - _S239)), _S244), dot(float4(int4(_S238 - _S237)), _S244), dot(float4(int4(_S241)), _S244)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S245 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_0 * _S245.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_0 * _S245.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_0 * _S245.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_0 * _S245.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 own_0, Stretch_0 other_0, bool back_3)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S246 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S247 = integrals_along_0(family_9, own_0, quantity_2);
        float _S248 = integral_on_top_0(family_9, own_0, other_0, uint(families_0[crossing_0].count_0), quantity_2);
        float _S249 = _S247.x;
        float _S250 = _S249 * _S246.x;
        float _S251;
        if(back_3)
        {
            _S251 = _S250 - _S248;
        }
        else
        {
            _S251 = _S248;
        }
        bool _S252 = quantity_2 == 0U;
        if(_S252)
        {
            is_exposed_0 = _S251 > (16.0f * families_0[family_9].area_unit_0 * min(_S250 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S250);
        }
        float _S253 = _S249 * _S246.y;
        float _S254;
        if(is_exposed_0)
        {
            _S254 = _S251;
        }
        else
        {
            _S254 = 0.0f;
        }
        float _S255 = _S253 + _S254 + 0.000244140625f * _S246.z * _S247.y;
        if(_S252)
        {
            weight_1 = 1.0f / max(_S255, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S255 * weight_1, families_0[family_9].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

Blocked_0 no_blocked_0()
{
    Blocked_0 nothing_0;
    nothing_0.by_warp_0 = 0.0f;
    nothing_0.by_weft_0 = 0.0f;
    nothing_0.far_0 = 0.0f;
    return nothing_0;
}

struct CloseUp_0
{
    float weight_2;
    Blocked_0 warp_1;
    Blocked_0 weft_1;
};

CloseUp_0 no_close_up_0()
{
    CloseUp_0 nothing_1;
    nothing_1.weight_2 = 0.0f;
    Blocked_0 _S256 = no_blocked_0();
    nothing_1.warp_1 = _S256;
    nothing_1.weft_1 = _S256;
    return nothing_1;
}

Albedos_0 tinted_0(Albedos_0 albedos_3, float3 tint_0)
{
    Albedos_0 result_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
    float3 warp_2;
    float3 weft_2;
    float3 mean_0;
    float3 leaked_0;
};

struct FaceSends_0
{
    float3 sky_warp_0;
    float3 sky_weft_0;
    float3 crossing_warp_0;
    float3 crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

FaceRadiance_0 face_radiance_0(FaceSends_0 sends_0, float open_of_other_0, float3 passed_0, float3 from_other_0)
{
    float3 _S257 = (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3 _S258 = sends_0.sky_warp_0 + _S257 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S258;
    float3 _S259 = sends_0.sky_weft_0 + _S257 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S259;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S258 + sends_0.blocks_weft_0 * _S259;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(float3 view_2, out float  terms_0[int(6)])
{
    float _S260 = 1.0f - view_2.z;
    float _S261 = _S260 * _S260;
    terms_0[int(0)] = 1.0f;
    float _S262 = view_2.x;
    float _S263 = _S262 * _S262;
    float _S264 = view_2.y;
    float _S265 = _S264 * _S264;
    terms_0[int(1)] = sqrt(max(_S263 + _S265, 9.999999960041972e-13f));
    terms_0[int(2)] = _S261;
    terms_0[int(3)] = _S261 * _S261;
    terms_0[int(4)] = _S263 - _S265;
    terms_0[int(5)] = 0.0f;
    return;
}

Blocked_0 scaled_0(Blocked_0 blocked_0, float share_0)
{
    Blocked_0 result_1;
    result_1.by_warp_0 = share_0 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_0 * blocked_0.by_weft_0;
    result_1.far_0 = share_0 * blocked_0.far_0;
    return result_1;
}

struct Bounced_0
{
    float3 reflected_0;
    float3 transmitted_0;
};

struct Scattered_0
{
    float3 back_4;
    float3 through_0;
};

struct Interior_0
{
    float3 warp_3;
    float3 weft_3;
    float3 leaked_1;
    float3 far_1;
    float3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_1, Scattered_0 yarn_0, Interior_0 interior_0)
{
    float3 _S266 = (blocked_1.by_warp_0 + blocked_1.by_weft_0) * interior_0.leaked_1;
    float3 _S267 = blocked_1.far_0 * yarn_0.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (blocked_1.by_warp_0 * interior_0.warp_3 + blocked_1.by_weft_0 * interior_0.weft_3) + _S267 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S267 * interior_0.far_1 + yarn_0.back_4 * _S266;
    return bounced_0;
}

Bounced_0 sum_of_0(Bounced_0 first_20, Bounced_0 second_1)
{
    Bounced_0 sum_1;
    sum_1.reflected_0 = first_20.reflected_0 + second_1.reflected_0;
    sum_1.transmitted_0 = first_20.transmitted_0 + second_1.transmitted_0;
    return sum_1;
}

float3 bounced_value_0(Bounced_0 bounced_1, float3 light_2, float3 view_3)
{
    float _S268 = light_2.z;
    float3 _S269;
    if((_S268 * view_3.z) < 0.0f)
    {
        _S269 = bounced_1.transmitted_0;
    }
    else
    {
        _S269 = bounced_1.reflected_0;
    }
    return _S269 * (abs(_S268) * 0.31830987334251404f);
}

float sheen_scale_0(float x_6, float y_0)
{
    return (((((0.0f * x_6 + (((((-1.1402510404586792f * y_0 + 0.40672621130943298f) * y_0 + 1.65398800373077393f) * y_0 + -1.29730904102325439f) * y_0 + 0.30570998787879944f) * y_0 + -0.0220868494361639f)) * x_6 + (((((-0.21142719686031342f * y_0 + 1.05947399139404297f) * y_0 + -0.41116121411323547f) * y_0 + -0.93859231472015381f) * y_0 + 0.51606941223144531f) * y_0 + 0.05409301072359085f)) * x_6 + (((((1.22944498062133789f * y_0 + -0.45962560176849365f) * y_0 + -1.63861405849456787f) * y_0 + 1.33565104007720947f) * y_0 + -0.45725581049919128f) * y_0 + 0.08243165910243988f)) * x_6 + (((((0.39779931306838989f * y_0 + -1.18879103660583496f) * y_0 + 0.28251591324806213f) * y_0 + 1.168984055519104f) * y_0 + -0.76864629983901978f) * y_0 + 0.0091691892594099f)) * x_6 + (((((-0.26563560962677002f * y_0 + -0.19379159808158875f) * y_0 + 0.2677634060382843f) * y_0 + 0.00270519289188087f) * y_0 + 0.14349560439586639f) * y_0 + 0.10290180146694183f)) * x_6 + (((((-0.20701569318771362f * y_0 + 0.24526430666446686f) * y_0 + 0.19551840424537659f) * y_0 + 0.07586126774549484f) * y_0 + 0.38894739747047424f) * y_0 + 0.15043120086193085f);
}

float sheen_shear_0(float x_7, float y_1)
{
    return ((((0.0f * x_7 + (((((-0.10608240216970444f * y_1 + 1.99214303493499756f) * y_1 + -1.42255294322967529f) * y_1 + -1.09495604038238525f) * y_1 + 0.59180057048797607f) * y_1 + 0.06902855634689331f)) * x_7 + (((((-0.46220690011978149f * y_1 + -0.29113379120826721f) * y_1 + 1.39025199413299561f) * y_1 + 0.35589990019798279f) * y_1 + -1.17120099067687988f) * y_1 + 0.15940259397029877f)) * x_7 + (((((2.26068711280822754f * y_1 + -3.64728999137878418f) * y_1 + -0.72173482179641724f) * y_1 + 3.07659196853637695f) * y_1 + -0.6827620267868042f) * y_1 + -0.3039557933807373f)) * x_7 + (((((0.81201767921447754f * y_1 + 0.36014080047607422f) * y_1 + -1.72646903991699219f) * y_1 + -0.22630110383033752f) * y_1 + 0.89514690637588501f) * y_1 + -0.10397960245609283f)) * x_7 + (((((-0.37648698687553406f * y_1 + 1.10974001884460449f) * y_1 + 0.17824520170688629f) * y_1 + -1.04968702793121338f) * y_1 + 0.1461234986782074f) * y_1 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_8, float y_2)
{
    return ((((0.0f * x_8 + (((((12.95646953582763672f * y_2 + -21.38032913208007812f) * y_2 + -7.37853097915649414f) * y_2 + 34.55607986450195312f) * y_2 + -23.61347007751464844f) * y_2 + 5.00126314163208008f)) * x_8 + (((((10.91487026214599609f * y_2 + -6.08202791213989258f) * y_2 + -38.2036285400390625f) * y_2 + 53.3440399169921875f) * y_2 + -21.91996002197265625f) * y_2 + 2.01606011390686035f)) * x_8 + (((((-14.52206039428710938f * y_2 + 36.803619384765625f) * y_2 + -22.94047927856445312f) * y_2 + -10.07973003387451172f) * y_2 + 15.77003955841064453f) * y_2 + -4.92722177505493164f)) * x_8 + (((((-7.62505722045898438f * y_2 + 1.27310299873352051f) * y_2 + 31.19523048400878906f) * y_2 + -44.39989852905273438f) * y_2 + 26.44947052001953125f) * y_2 + -8.73507976531982422f)) * x_8 + (((((5.65633487701416016f * y_2 + -17.66820907592773438f) * y_2 + 24.65356063842773438f) * y_2 + -19.38941001892089844f) * y_2 + 11.06159019470214844f) * y_2 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S270 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S271 = 2.0f * sqrt(_S270) - 1.0f;
    float _S272 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S271, _S272), 0.00999999977648258f, 1.0f), clamp((1.0f - _S270) * sheen_shear_0(_S271, _S272), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S271, _S272), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_3, float3 view_4, float scale_1, float shear_0)
{
    float _S273 = light_3.z;
    bool _S274;
    if(_S273 <= 0.0f)
    {
        _S274 = true;
    }
    else
    {
        _S274 = (view_4.z) <= 0.0f;
    }
    if(_S274)
    {
        return 0.0f;
    }
    float2 _S275 = view_4.xy;
    float _S276 = dot(_S275, _S275);
    float2 _S277;
    if(_S276 > 9.99999968265522539e-21f)
    {
        _S277 = _S275 * rsqrt(_S276);
    }
    else
    {
        _S277 = float2(1.0f, 0.0f);
    }
    float _S278 = scale_1 * dot(light_3.xy, _S277) + shear_0 * _S273;
    float _S279 = scale_1 * (light_3.y * _S277.x - light_3.x * _S277.y);
    float _S280 = _S278 * _S278 + _S279 * _S279 + _S273 * _S273;
    return 0.31830987334251404f * scale_1 * scale_1 * _S273 / max(_S280 * _S280, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_4, float3 view_5, float strength_0, float roughness_2)
{
    float3 _S281 = sheen_lobe_0(view_5.z, roughness_2);
    float _S282 = strength_0 * _S281.z;
    return float2(_S282 * transformed_cosine_0(light_4, view_5, _S281.x, _S281.y), 1.0f - _S282);
}

struct NeuralView_0
{
    float  sums_7[int(96)];
    float hole_0;
    float correction_weight_0;
    float3 view_6;
    bool back_5;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S283, Footprint_0 _S284)
{
    float3 _S285 = row_of_taps_0(_S284);
    float2 _S286 = _S284.dx_0;
    float2 _S287 = _S284.dy_0;
    float _S288 = dot(_S286, _S286) + dot(_S287, _S287);
    float _S289 = _S284.dx_0.x * _S284.dy_0.y - _S284.dx_0.y * _S284.dy_0.x;
    float _S290 = 0.5f * (_S288 + sqrt(max(_S288 * _S288 - 4.0f * _S289 * _S289, 0.0f)));
    Neural_0 _S291 = fabrics_0[_S283].neural_0;
    bool _S292;
    if(_S290 < (5.5f * (_S288 - _S290)))
    {
        _S292 = _S288 > (8.0f * _S291.pitch_0 * _S291.pitch_0);
    }
    else
    {
        _S292 = false;
    }
    float2 _S293 = float2(_S291.ends_per_mm_0, _S291.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    taps_1.centre_1 = _S284.centre_0 * _S293;
    float _S294;
    if(_S292)
    {
        _S294 = sqrt(0.125f * _S288);
    }
    else
    {
        _S294 = _S285.x;
    }
    taps_1.side_0 = _S294 / _S291.pitch_0;
    float2 _S295;
    if(_S292)
    {
        _S295 = 0.25f * _S284.dx_0;
    }
    else
    {
        _S295 = _S285.yz;
    }
    taps_1.first_19 = _S295 * _S293;
    if(_S292)
    {
        _S295 = 0.25f * _S284.dy_0;
    }
    else
    {
        _S295 = 0.5f * _S285.yz;
    }
    taps_1.second_0 = _S295 * _S293;
    return taps_1;
}

void add_texel_0(uint _S296, uint _S297, float _S298, inout float  _S299[int(88)])
{
    uint _S300 = fabrics_0[_S296].neural_0.latents_0 + _S297 * 8U;
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
        Eight_0 _S301 = eight_halves_0(packed_numbers_0.Load(_S300 + part_0));
        int _S302 = int(8U * part_0);
        _S299[_S302] = _S299[_S302] + _S298 * _S301.low_0[int(0)];
        _S299[_S302 + int(4)] = _S299[_S302 + int(4)] + _S298 * _S301.high_0[int(0)];
        int _S303 = _S302 + int(1);
        _S299[_S303] = _S299[_S303] + _S298 * _S301.low_0[int(1)];
        _S299[_S303 + int(4)] = _S299[_S303 + int(4)] + _S298 * _S301.high_0[int(1)];
        int _S304 = _S302 + int(2);
        _S299[_S304] = _S299[_S304] + _S298 * _S301.low_0[int(2)];
        _S299[_S304 + int(4)] = _S299[_S304 + int(4)] + _S298 * _S301.high_0[int(2)];
        int _S305 = _S302 + int(3);
        _S299[_S305] = _S299[_S305] + _S298 * _S301.low_0[int(3)];
        _S299[_S305 + int(4)] = _S299[_S305 + int(4)] + _S298 * _S301.high_0[int(3)];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S306, uint _S307, bool _S308, float2 _S309, float _S310, inout float  _S311[int(88)])
{
    Neural_0 _S312 = fabrics_0[_S306].neural_0;
    uint _S313 = fabrics_0[_S306].neural_0.levels_1 + 4U * _S307;
    float _S314 = table_number_0(_S313);
    float _S315 = table_number_0(_S313 + 1U);
    float _S316 = table_number_0(_S313 + 2U);
    bool _S317;
    if(_S307 > 3U)
    {
        _S317 = _S307 < (_S312.top_level_0);
    }
    else
    {
        _S317 = false;
    }
    float2 _S318 = _S309 * table_number_0(_S313 + 3U);
    float _S319;
    if(_S317)
    {
        _S319 = 1.0f;
    }
    else
    {
        _S319 = 0.5f;
    }
    float2 _S320 = _S318 - _S319;
    float2 _S321 = floor(_S320);
    float2 _S322 = _S320 - _S321;
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
        float _S323 = float(corner_0 & 1U);
        float _S324 = float(corner_0 >> int(1));
        float2 _S325 = lerp(1.0f - _S322, _S322, float2(_S323, _S324));
        uint _S326 = uint(_S314 + wrapped_0(_S321.y + _S324, _S316) * _S315 + wrapped_0(_S321.x + _S323, _S315));
        uint _S327;
        if(_S308)
        {
            _S327 = _S312.texels_0;
        }
        else
        {
            _S327 = 0U;
        }
        add_texel_0(_S306, _S326 + _S327, _S310 * _S325.x * _S325.y, _S311);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S328, AnisotropicTaps_0 _S329, float3 _S330, bool _S331, inout float  _S332[int(88)])
{
    float offset_2;
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
        _S332[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    float2 _S333 = float2(fabrics_0[_S328].neural_0.ends_0, fabrics_0[_S328].neural_0.picks_0);
    float _S334 = float(fabrics_0[_S328].neural_0.top_level_0);
    float _S335 = clamp(binary_logarithm_0(max(_S329.side_0, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S334);
    float _S336 = min(floor(_S335), _S334 - 1.0f);
    uint _S337;
    if(AnisotropicTaps_has_steps_0(_S329))
    {
        _S337 = 4U;
    }
    else
    {
        _S337 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S337))
        {
        }
        else
        {
            break;
        }
        float2 _S338 = AnisotropicTaps_place_0(_S329, number_1 >> int(1));
        float2 _S339 = clamp(_S338 - _S333 * floor(_S338 / _S333), (float2)0.0f, _S333);
        bool _S340 = (number_1 & 1U) != 0U;
        if(_S340)
        {
            offset_2 = _S335 - _S336;
        }
        else
        {
            offset_2 = 1.0f - (_S335 - _S336);
        }
        float _S341 = offset_2 / float(_S337);
        uint _S342 = uint(_S336);
        uint _S343;
        if(_S340)
        {
            _S343 = 1U;
        }
        else
        {
            _S343 = 0U;
        }
        add_level_0(_S328, _S342 + _S343, _S331, _S339, _S341, _S332);
        number_1 = number_1 + 1U;
    }
    int number_2 = int(0);
    for(;;)
    {
        if(number_2 < int(3))
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
            float offset_3 = _S330[number_2] - (float(bin_0) + 0.5f) / 8.0f;
            if(number_2 < int(2))
            {
                offset_2 = offset_3 - round(offset_3);
            }
            else
            {
                offset_2 = offset_3;
            }
            _S332[int(64) + number_2 * int(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_2 = number_2 + int(1);
    }
    return;
}

float3 crown_fibres_0(uint _S344, bool _S345, bool _S346)
{
    float _S347;
    if(_S345)
    {
        if(_S346)
        {
            _S347 = - fabrics_0[_S344].neural_0.warp_x_0;
        }
        else
        {
            _S347 = fabrics_0[_S344].neural_0.warp_x_0;
        }
        return float3(_S347, fabrics_0[_S344].neural_0.warp_y_0, fabrics_0[_S344].neural_0.warp_roughness_0);
    }
    Neural_0 _S348 = fabrics_0[_S344].neural_0;
    if(_S346)
    {
        _S347 = - _S348.weft_y_0;
    }
    else
    {
        _S347 = _S348.weft_y_0;
    }
    return float3(_S348.weft_x_0, _S347, _S348.weft_roughness_0);
}

void neural_view_0(uint _S349, Footprint_0 _S350, float3 _S351, inout NeuralView_0 _S352)
{
    bool _S353 = (_S351.z) < 0.0f;
    AnisotropicTaps_0 _S354 = anisotropic_taps_0(_S349, _S350);
    float3 _S355 = footprint_coordinates_0(_S354);
    float3 _S356 = to_face_frame_0(_S351, _S353);
    HalfWeights_0 weights_23;
    weights_23.first_2 = fabrics_0[_S349].neural_0.network_0;
    float  inputs_23[int(88)];
    code_footprint_0(_S349, _S354, _S355, _S353, inputs_23);
    float  hidden_1[int(96)];
    dense_7(weights_23, 0U, false, inputs_23, hidden_1);
    float  fused_0[int(100)];
    dense_part_8(weights_23, 1068U, false, hidden_1, fused_0);
    fused_0[int(96)] = _S356.x;
    fused_0[int(97)] = _S356.y;
    float2 _S357 = _S356.xy;
    fused_0[int(98)] = dot(crown_fibres_0(_S349, true, _S353).xy, _S357);
    fused_0[int(99)] = dot(crown_fibres_0(_S349, false, _S353).xy, _S357);
    float  of_hole_0[int(16)];
    dense_6(weights_23, 2232U, false, fused_0, of_hole_0);
    float  hole_1[int(1)];
    dense_5(weights_23, 2444U, false, of_hole_0, hole_1);
    dense_4(weights_23, 2456U, false, fused_0, _S352.sums_7);
    _S352.hole_0 = clamp(hole_1[int(0)], 0.0f, 1.0f);
    _S352.correction_weight_0 = correction_weight_of_0(_S355.z);
    _S352.view_6 = _S356;
    _S352.back_5 = _S353;
    return;
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

void code_light_0(uint _S358, float3 _S359, float3 _S360, bool _S361, inout float  _S362[int(39)])
{
    _S362[int(0)] = _S359.x;
    _S362[int(1)] = _S359.y;
    _S362[int(2)] = _S359.z;
    float3 _S363 = _S359 + _S360;
    float _S364 = _S363.z;
    float _S365 = _S364 * _S364 + 0.00009999999747379f;
    float2 _S366 = _S363.xy;
    float _S367 = 1.0f / (dot(_S366, _S366) + _S365);
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
        float3 _S368 = crown_fibres_0(_S358, family_10 == int(0), _S361);
        float2 _S369 = _S368.xy;
        _S362[int(3) + family_10] = dot(_S369, _S359.xy);
        float _S370 = dot(_S369, _S366);
        float _S371 = _S370 * _S370;
        float _S372 = (0.75f * _S370 / (0.5f * sqrt(_S371 + _S365) + abs(_S370)) + 0.5f) * 8.0f;
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
            _S362[int(5) + family_10 * int(16) + bin_1] = bump_0(_S372 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S373 = _S368.z;
        float _S374 = _S373 * _S373;
        float _S375 = _S371 * _S367 * (1.0f - _S374) + _S374;
        _S362[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S374 * _S373 / (_S375 * _S375));
        family_10 = family_10 + int(1);
    }
    return;
}

float mixed_bundles_0(uint _S376, uint _S377, uint _S378, float3 _S379, float3 _S380, bool _S381, inout float  _S382[int(52)])
{
    float3 _S383 = _S379 + _S380;
    float _S384 = 1.0f / (square_1(_S383) + 0.00009999999747379f);
    bool _S385;
    if(_S377 == 0U)
    {
        _S385 = _S381;
    }
    else
    {
        _S385 = false;
    }
    float _S386;
    if(_S385)
    {
        _S386 = - _S383.x;
    }
    else
    {
        _S386 = _S383.x;
    }
    if(_S377 == 1U)
    {
        _S385 = _S381;
    }
    else
    {
        _S385 = false;
    }
    float _S387;
    if(_S385)
    {
        _S387 = - _S383.y;
    }
    else
    {
        _S387 = _S383.y;
    }
    uint bundle_1 = 0U;
    float sum_2 = 0.0f;
    for(;;)
    {
        if(bundle_1 < 25U)
        {
        }
        else
        {
            break;
        }
        uint _S388 = _S377 * 25U;
        uint _S389 = fabrics_0[_S376].neural_0.bundles_0 + 4U * (_S388 + bundle_1);
        float _S390 = dot(float3(table_number_0(_S389), table_number_0(_S389 + 1U), table_number_0(_S389 + 2U)), float3(_S386, _S387, _S383.z));
        float _S391 = _S390 * _S390 * _S384 + table_number_0(_S389 + 3U);
        uint _S392 = _S378 + _S388;
        uint _S393;
        if(_S381)
        {
            _S393 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S393 = bundle_1;
        }
        float sum_3 = sum_2 + max(_S382[_S392 + _S393], _S382[_S392 + _S393] * 0.00999999977648258f) / (_S391 * _S391);
        bundle_1 = bundle_1 + 1U;
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

Components_0 neural_components_0(uint _S394, inout NeuralView_0 _S395, float3 _S396)
{
    float _S397;
    bool _S398 = _S395.back_5;
    float3 _S399 = to_face_frame_0(_S396, _S395.back_5);
    float3 _S400 = _S395.view_6;
    HalfWeights_0 weights_24;
    Neural_0 _S401 = fabrics_0[_S394].neural_0;
    weights_24.first_2 = fabrics_0[_S394].neural_0.network_0;
    float  directions_0[int(39)];
    code_light_0(_S394, _S399, _S395.view_6, _S395.back_5, directions_0);
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
        skip_0[k_1] = _S395.sums_7[k_1];
        k_1 = k_1 + int(1);
    }
    dense_3(weights_24, 3716U, true, directions_0, skip_0);
    float  hidden_2[int(96)];
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
        hidden_2[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
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
                _S397 = skip_0[k_1];
            }
            else
            {
                _S397 = 0.0f;
            }
            next_0[k_1] = _S397;
            k_1 = k_1 + int(1);
        }
        dense_2(weights_24, 4208U + layer_0 * 1164U, true, hidden_2, next_0);
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
            hidden_2[k_2] = next_0[k_2];
            k_2 = k_2 + int(1);
        }
        layer_0 = layer_0 + 1U;
    }
    float  outputs_17[int(52)];
    dense_1(weights_24, 7700U, false, hidden_2, outputs_17);
    bool _S402;
    if((_S401.is_corrected_0) != 0U)
    {
        _S402 = (_S399.z) > 0.0f;
    }
    else
    {
        _S402 = false;
    }
    if(_S402)
    {
        _S402 = (_S395.correction_weight_0) > 0.0f;
    }
    else
    {
        _S402 = false;
    }
    if(_S402)
    {
        FloatWeights_0 fitted_0;
        fitted_0.first_0 = _S401.correction_0;
        float  change_0[int(50)];
        dense_0(fitted_0, 0U, false, hidden_2, change_0);
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
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S395.correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S399.z) > 0.0f)
    {
        _S397 = 0.00999999977648258f;
    }
    else
    {
        _S397 = 0.00100000004749745f;
    }
    Components_0 result_2;
    float _S403 = unmapped_0(outputs_17[int(0)], _S397);
    result_2.diffuse_warp_0 = _S403;
    float _S404 = unmapped_0(outputs_17[int(1)], _S397);
    result_2.diffuse_weft_0 = _S404;
    float _S405 = 2979.9580078125f * _S397;
    float _S406 = mixed_bundles_0(_S394, 0U, 2U, _S399, _S400, _S398, outputs_17);
    result_2.specular_warp_0 = clamp(_S406, 0.0f, _S405);
    float _S407 = mixed_bundles_0(_S394, 1U, 2U, _S399, _S400, _S398, outputs_17);
    result_2.specular_weft_0 = clamp(_S407, 0.0f, _S405);
    result_2.hole_2 = _S395.hole_0;
    result_2.light_visibility_1 = min(light_visibility_of_0(_S403 + _S404, _S399, _S400, fabrics_0[_S394].diffuse_blend_0), 1.0f - _S395.hole_0);
    return result_2;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_4;
    Albedos_0 weft_4;
};

FamilyAlbedos_0 albedos_over_0(uint _S408, Footprint_0 _S409, bool _S410)
{
    float2 _S411 = _S409.dx_0;
    float2 _S412 = _S409.dy_0;
    float2 _S413 = sqrt(_S411 * _S411 + _S412 * _S412);
    Stretch_0 _S414 = stretch_of_0(fabrics_0[_S408].warp_0, _S409.centre_0.x, _S413.x);
    Stretch_0 _S415 = stretch_of_0(fabrics_0[_S408].weft_0, _S409.centre_0.y, _S413.y);
    FamilyAlbedos_0 albedos_4;
    albedos_4.warp_4 = mean_albedos_0(fabrics_0[_S408].warp_0, fabrics_0[_S408].weft_0, _S414, _S415, _S410);
    albedos_4.weft_4 = mean_albedos_0(fabrics_0[_S408].weft_0, fabrics_0[_S408].warp_0, _S415, _S414, _S410);
    return albedos_4;
}

float openness_number_0(uint _S416, uint _S417)
{
    return table_number_0(fabrics_0[_S416].openness_0 + _S417);
}

Scattered_0 scattered_by_0(uint _S418, Albedos_0 _S419, uint _S420, float3 _S421)
{
    uint _S422 = 159U + 2U * _S420;
    Scattered_0 yarn_1;
    yarn_1.back_4 = _S421 * _S419.diffuse_reflect_0 + openness_number_0(_S418, _S422) * _S419.specular_reflect_0;
    yarn_1.through_0 = _S421 * _S419.diffuse_transmit_0 + openness_number_0(_S418, _S422 + 1U) * _S419.specular_transmit_0;
    return yarn_1;
}

void sent_0(uint _S423, uint _S424, float3 _S425, float3 _S426, float3 _S427, float3 _S428, out float3 _S429, out float3 _S430)
{
    uint _S431 = 146U + 4U * _S424;
    float _S432 = openness_number_0(_S423, _S431 + 1U);
    float _S433 = openness_number_0(_S423, _S431 + 2U);
    float3 _S434 = 1.0f - _S427 * openness_number_0(_S423, _S431);
    float3 _S435 = 1.0f - _S428 * openness_number_0(_S423, _S431 + 3U);
    float3 _S436 = 1.0f / (_S434 * _S435 - _S427 * _S428 * (_S432 * _S433));
    _S429 = (_S425 * _S435 + _S427 * _S432 * _S426) * _S436;
    _S430 = (_S426 * _S434 + _S428 * _S433 * _S425) * _S436;
    return;
}

FaceSends_0 face_sends_0(uint _S437, uint _S438, Scattered_0 _S439, Scattered_0 _S440)
{
    uint _S441 = 2U * _S438;
    uint _S442 = 142U + _S441;
    float _S443 = openness_number_0(_S437, _S442);
    float _S444 = openness_number_0(_S437, _S442 + 1U);
    float3 _S445 = (1.0f - _S443) * _S439.back_4;
    float3 _S446 = (1.0f - _S444) * _S440.back_4;
    FaceSends_0 sends_1;
    uint _S447 = 154U + _S441;
    float _S448 = openness_number_0(_S437, _S447);
    sends_1.blocks_warp_0 = _S448;
    float _S449 = openness_number_0(_S437, _S447 + 1U);
    sends_1.blocks_weft_0 = _S449;
    sends_1.open_0 = _S448 * _S443 + _S449 * _S444;
    sent_0(_S437, _S438, _S443 * _S439.back_4, _S444 * _S440.back_4, _S445, _S446, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S437, _S438, _S439.through_0, _S440.through_0, _S445, _S446, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S450, float3 _S451, bool _S452)
{
    Scattered_0 _S453 = scattered_by_0(_S450, table_albedos_0(families_0[fabrics_0[_S450].warp_0].colour_mean_0), 0U, _S451);
    Scattered_0 _S454 = scattered_by_0(_S450, table_albedos_0(families_0[fabrics_0[_S450].weft_0].colour_mean_0), 1U, _S451);
    uint _S455;
    if(_S452)
    {
        _S455 = 1U;
    }
    else
    {
        _S455 = 0U;
    }
    FaceSends_0 _S456 = face_sends_0(_S450, _S455, _S453, _S454);
    if(_S452)
    {
        _S455 = 0U;
    }
    else
    {
        _S455 = 1U;
    }
    FaceSends_0 _S457 = face_sends_0(_S450, _S455, _S453, _S454);
    float3 _S458 = _S456.blocks_warp_0 * _S456.crossing_warp_0 + _S456.blocks_weft_0 * _S456.crossing_weft_0;
    float3 _S459 = _S457.blocks_warp_0 * _S457.crossing_warp_0 + _S457.blocks_weft_0 * _S457.crossing_weft_0;
    float _S460 = 1.0f - _S456.open_0;
    float _S461 = 1.0f - _S457.open_0;
    float3 _S462 = 1.0f / (1.0f - _S458 * _S459 * (_S460 * _S461));
    float3 _S463 = _S459 * (_S456.open_0 + _S460 * (_S456.blocks_warp_0 * _S456.sky_warp_0 + _S456.blocks_weft_0 * _S456.sky_weft_0)) * _S462;
    float3 _S464 = _S458 * (_S457.open_0 + _S461 * (_S457.blocks_warp_0 * _S457.sky_warp_0 + _S457.blocks_weft_0 * _S457.sky_weft_0)) * _S462;
    FaceRadiance_0 _S465 = face_radiance_0(_S456, _S457.open_0, _S463, _S464);
    FaceRadiance_0 _S466 = face_radiance_0(_S457, _S456.open_0, _S464, _S463);
    Interior_0 interior_1;
    interior_1.warp_3 = _S465.warp_2;
    interior_1.weft_3 = _S465.weft_2;
    interior_1.leaked_1 = _S465.leaked_0;
    interior_1.far_1 = _S466.mean_0;
    interior_1.far_leaked_0 = _S466.leaked_0;
    return interior_1;
}

Blocked_0 blocked_of_terms_0(uint _S467, uint _S468, float  _S469[int(6)], uint _S470)
{
    float  shares_0[int(3)];
    uint share_1 = 0U;
    for(;;)
    {
        if(share_1 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_1] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S470)
            {
            }
            else
            {
                break;
            }
            shares_0[share_1] = shares_0[share_1] + openness_number_0(_S467, _S468 + share_1 * _S470 + term_0) * _S469[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_1] = saturate(shares_0[share_1]);
        share_1 = share_1 + 1U;
    }
    Blocked_0 blocked_2;
    blocked_2.by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    blocked_2.by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    blocked_2.far_0 = shares_0[int(1)];
    return blocked_2;
}

Blocked_0 blocked_from_0(uint _S471, float3 _S472, bool _S473, bool _S474)
{
    float  terms_1[int(6)];
    view_terms_0(_S472, terms_1);
    uint _S475;
    if(_S474)
    {
        _S475 = 2U;
    }
    else
    {
        _S475 = 0U;
    }
    uint _S476;
    if(_S473)
    {
        _S476 = 0U;
    }
    else
    {
        _S476 = 1U;
    }
    return blocked_of_terms_0(_S471, (_S475 + _S476) * 15U, terms_1, 5U);
}

float warp_seen_from_0(uint _S477, float3 _S478, bool _S479)
{
    float  terms_2[int(6)];
    view_terms_0(_S478, terms_2);
    uint term_1 = 0U;
    float share_2 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S480;
        if(_S479)
        {
            _S480 = 5U;
        }
        else
        {
            _S480 = 0U;
        }
        float share_3 = share_2 + openness_number_0(_S477, 132U + _S480 + term_1) * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_2 = share_3;
    }
    return saturate(share_2);
}

Bounced_0 bounced_of_families_0(uint _S481, FamilyAlbedos_0 _S482, float3 _S483, Interior_0 _S484, Blocked_0 _S485, Blocked_0 _S486)
{
    return sum_of_0(bounced_by_0(_S485, scattered_by_0(_S481, _S482.warp_4, 0U, _S483), _S484), bounced_by_0(_S486, scattered_by_0(_S481, _S482.weft_4, 1U, _S483), _S484));
}

Bounced_0 bounced_far_0(uint _S487, FamilyAlbedos_0 _S488, float3 _S489, Interior_0 _S490, float3 _S491, bool _S492, float _S493, float _S494, float _S495)
{
    Blocked_0 _S496 = blocked_from_0(_S487, _S491, true, _S492);
    Blocked_0 _S497 = blocked_from_0(_S487, _S491, false, _S492);
    float _S498 = _S493 / max(1.0f - _S496.by_warp_0 - _S496.by_weft_0, 0.10000000149011612f);
    float _S499 = (0.0020000000949949f * warp_seen_from_0(_S487, _S491, _S492) + _S498) / (_S498 + _S494 / max(1.0f - _S497.by_warp_0 - _S497.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    float _S500 = 1.0f - _S495;
    return bounced_of_families_0(_S487, _S488, _S489, _S490, scaled_0(_S496, _S499 * _S500), scaled_0(_S497, (1.0f - _S499) * _S500));
}

Bounced_0 bounced_over_0(uint _S501, Components_0 _S502, CloseUp_0 _S503, FamilyAlbedos_0 _S504, float3 _S505, float3 _S506)
{
    bool _S507 = (_S506.z) < 0.0f;
    Interior_0 _S508 = interior_of_0(_S501, _S505, _S507);
    Bounced_0 bounced_2 = bounced_far_0(_S501, _S504, _S505, _S508, to_face_frame_0(_S506, _S507), _S507, _S502.diffuse_warp_0, _S502.diffuse_weft_0, _S502.hole_2);
    if((_S503.weight_2) > 0.0f)
    {
        Bounced_0 _S509 = bounced_of_families_0(_S501, _S504, _S505, _S508, _S503.warp_1, _S503.weft_1);
        float3 _S510 = (float3)_S503.weight_2;
        bounced_2.reflected_0 = lerp(bounced_2.reflected_0, _S509.reflected_0, _S510);
        bounced_2.transmitted_0 = lerp(bounced_2.transmitted_0, _S509.transmitted_0, _S510);
    }
    return bounced_2;
}

float3 composed_0(uint _S511, Components_0 _S512, CloseUp_0 _S513, FamilyAlbedos_0 _S514, float3 _S515, float3 _S516, float3 _S517)
{
    Albedos_0 _S518 = tinted_0(_S514.warp_4, _S515);
    Albedos_0 _S519 = tinted_0(_S514.weft_4, _S515);
    float3 _S520 = _S518.diffuse_reflect_0 * _S512.diffuse_warp_0 + _S519.diffuse_reflect_0 * _S512.diffuse_weft_0 + _S518.specular_reflect_0 * _S512.specular_warp_0 + _S519.specular_reflect_0 * _S512.specular_weft_0;
    float _S521 = _S517.z;
    float3 body_0;
    if((_S516.z * _S521) < 0.0f)
    {
        body_0 = _S518.diffuse_transmit_0 * _S512.diffuse_warp_0 + _S519.diffuse_transmit_0 * _S512.diffuse_weft_0 + _S518.specular_transmit_0 * _S512.specular_warp_0 + _S519.specular_transmit_0 * _S512.specular_weft_0;
    }
    else
    {
        body_0 = _S520;
    }
    if((fabrics_0[_S511].openness_0) != 4294967295U)
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S511, _S512, _S513, _S514, _S515, _S517), _S516, _S517);
    }
    float _S522 = fabrics_0[_S511].sheen_strength_0;
    if((fabrics_0[_S511].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S523 = _S521 < 0.0f;
    float2 _S524 = sheen_with_transmittance_0(to_face_frame_0(_S516, _S523), to_face_frame_0(_S517, _S523), _S522, fabrics_0[_S511].sheen_roughness_0);
    return _S524.y * body_0 + (_S512.light_visibility_1 + _S512.hole_2) * _S524.x;
}

float4 cloth_value_0(uint fabric_1, float2 centre_3, float2 dx_1, float2 dy_1, float3 light_5, float3 view_7)
{
    Footprint_0 footprint_1;
    footprint_1.centre_0 = centre_3;
    footprint_1.dx_0 = dx_1;
    footprint_1.dy_0 = dy_1;
    NeuralView_0 activations_0;
    neural_view_0(fabric_1, footprint_1, view_7, activations_0);
    Components_0 _S525 = neural_components_0(fabric_1, activations_0, light_5);
    float _S526 = view_7.z;
    float3 _S527 = composed_0(fabric_1, _S525, no_close_up_0(), albedos_over_0(fabric_1, footprint_1, _S526 < 0.0f), (float3)1.0f, light_5, view_7);
    float through_1 = activations_0.hole_0;
    float through_2;
    if((fabrics_0[fabric_1].sheen_strength_0) > 0.0f)
    {
        through_2 = through_1 * (1.0f - fabrics_0[fabric_1].sheen_strength_0 * sheen_lobe_0(abs(_S526), fabrics_0[fabric_1].sheen_roughness_0).z);
    }
    else
    {
        through_2 = through_1;
    }
    return float4(_S527, through_2);
}

[numthreads(64, 1, 1)]
void neural_queries(uint3 id_0 : SV_DispatchThreadID)
{
    if((id_0.x) >= query_count_0.Load(int(0)))
    {
        return;
    }
    Query_0 _S528 = queries_0.Load(id_0.x);
    answers_0[id_0.x] = cloth_value_0(_S528.fabric_0, float2(_S528.centre_x_0, _S528.centre_y_0), float2(_S528.dx_x_0, _S528.dx_y_0), float2(_S528.dy_x_0, _S528.dy_y_0), float3(_S528.light_x_0, _S528.light_y_0, _S528.light_z_0), float3(_S528.view_x_0, _S528.view_y_0, _S528.view_z_0));
    return;
}

