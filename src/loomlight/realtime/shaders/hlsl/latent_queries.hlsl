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

StructuredBuffer<uint > words_0 : register(t2);

StructuredBuffer<uint4 > packed_numbers_0 : register(t8);

struct FloatWeights_0
{
    uint first_0;
};

int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

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

float4 tile_product_0(FloatWeights_0 weights_0, uint row_0, inout float  inputs_0[int(64)])
{
    float4 sums_1 = (float4)0.0f;
    uint column_0 = 0U;
    for(;;)
    {
        if(column_0 < 8U)
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
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0);
        sums_1[int(1)] = sums_1[int(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 16U + column_0);
        sums_1[int(2)] = sums_1[int(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        sums_1[int(3)] = sums_1[int(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
}

float Relu_apply_0(float x_0)
{
    return max(x_0, 0.0f);
}

void dense_part_0(FloatWeights_0 weights_1, uint first_1, bool adds_0, inout float  inputs_1[int(64)], inout float  outputs_0[int(64)])
{
    uint _S10 = first_1 + uint(whole_parts_0(int(8)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S11 = output_0 < int(64);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U);
        float4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 8U, inputs_1);
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
            outputs_0[output_0] = Relu_apply_0(_S16[int(0)] + _S17);
        }
        int _S18 = output_0 + int(1);
        if(_S18 < int(64))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S18] = Relu_apply_0(_S16[int(1)] + _S17);
        }
        int _S19 = output_0 + int(2);
        if(_S19 < int(64))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S19] = Relu_apply_0(_S16[int(2)] + _S17);
        }
        int _S20 = output_0 + int(3);
        if(_S20 < int(64))
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            outputs_0[_S20] = Relu_apply_0(_S16[int(3)] + _S17);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

float Identity_apply_0(float x_1)
{
    return x_1;
}

void dense_part_1(FloatWeights_0 weights_2, uint first_2, bool adds_1, inout float  inputs_2[int(64)], inout float  outputs_1[int(3)])
{
    uint _S21 = first_2 + uint(whole_parts_0(int(1)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S22 = output_1 < int(3);
        if(_S22)
        {
        }
        else
        {
            break;
        }
        uint _S23 = uint(output_1);
        Eight_0 _S24 = FloatWeights_eight_0(weights_2, first_2 + _S23 / 8U);
        float4 _S25 = tile_product_0(weights_2, _S21 + _S23 * 8U, inputs_2);
        float4 _S26;
        if((output_1 & int(4)) != int(0))
        {
            _S26 = _S24.high_0;
        }
        else
        {
            _S26 = _S24.low_0;
        }
        float4 _S27 = _S25 + _S26;
        float _S28;
        if(_S22)
        {
            if(adds_1)
            {
                _S28 = outputs_1[output_1];
            }
            else
            {
                _S28 = 0.0f;
            }
            outputs_1[output_1] = Identity_apply_0(_S27[int(0)] + _S28);
        }
        int _S29 = output_1 + int(1);
        if(_S29 < int(3))
        {
            if(adds_1)
            {
                _S28 = outputs_1[_S29];
            }
            else
            {
                _S28 = 0.0f;
            }
            outputs_1[_S29] = Identity_apply_0(_S27[int(1)] + _S28);
        }
        int _S30 = output_1 + int(2);
        if(_S30 < int(3))
        {
            if(adds_1)
            {
                _S28 = outputs_1[_S30];
            }
            else
            {
                _S28 = 0.0f;
            }
            outputs_1[_S30] = Identity_apply_0(_S27[int(2)] + _S28);
        }
        int _S31 = output_1 + int(3);
        if(_S31 < int(3))
        {
            if(adds_1)
            {
                _S28 = outputs_1[_S31];
            }
            else
            {
                _S28 = 0.0f;
            }
            outputs_1[_S31] = Identity_apply_0(_S27[int(3)] + _S28);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

float4 tile_product_1(FloatWeights_0 weights_3, uint row_1, inout float  inputs_3[int(20)])
{
    float4 sums_2 = (float4)0.0f;
    uint column_1 = 0U;
    for(;;)
    {
        if(column_1 < 3U)
        {
        }
        else
        {
            break;
        }
        float4 low_2;
        float4 high_2;
        int _S32 = int(8U * column_1);
        low_2[int(0)] = inputs_3[min(_S32, int(19))];
        high_2[int(0)] = inputs_3[min(_S32 + int(4), int(19))];
        int _S33 = _S32 + int(1);
        low_2[int(1)] = inputs_3[min(_S33, int(19))];
        high_2[int(1)] = inputs_3[min(_S33 + int(4), int(19))];
        int _S34 = _S32 + int(2);
        low_2[int(2)] = inputs_3[min(_S34, int(19))];
        high_2[int(2)] = inputs_3[min(_S34 + int(4), int(19))];
        int _S35 = _S32 + int(3);
        low_2[int(3)] = inputs_3[min(_S35, int(19))];
        high_2[int(3)] = inputs_3[min(_S35 + int(4), int(19))];
        Eight_0 _S36 = FloatWeights_eight_0(weights_3, row_1 + column_1);
        sums_2[int(0)] = sums_2[int(0)] + (dot(_S36.low_0, low_2) + dot(_S36.high_0, high_2));
        Eight_0 _S37 = FloatWeights_eight_0(weights_3, row_1 + 3U + column_1);
        sums_2[int(1)] = sums_2[int(1)] + (dot(_S37.low_0, low_2) + dot(_S37.high_0, high_2));
        Eight_0 _S38 = FloatWeights_eight_0(weights_3, row_1 + 6U + column_1);
        sums_2[int(2)] = sums_2[int(2)] + (dot(_S38.low_0, low_2) + dot(_S38.high_0, high_2));
        Eight_0 _S39 = FloatWeights_eight_0(weights_3, row_1 + 9U + column_1);
        sums_2[int(3)] = sums_2[int(3)] + (dot(_S39.low_0, low_2) + dot(_S39.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
}

void dense_part_2(FloatWeights_0 weights_4, uint first_3, bool adds_2, inout float  inputs_4[int(20)], inout float  outputs_2[int(64)])
{
    uint _S40 = first_3 + uint(whole_parts_0(int(8)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S41 = output_2 < int(64);
        if(_S41)
        {
        }
        else
        {
            break;
        }
        uint _S42 = uint(output_2);
        Eight_0 _S43 = FloatWeights_eight_0(weights_4, first_3 + _S42 / 8U);
        float4 _S44 = tile_product_1(weights_4, _S40 + _S42 * 3U, inputs_4);
        float4 _S45;
        if((output_2 & int(4)) != int(0))
        {
            _S45 = _S43.high_0;
        }
        else
        {
            _S45 = _S43.low_0;
        }
        float4 _S46 = _S44 + _S45;
        float _S47;
        if(_S41)
        {
            if(adds_2)
            {
                _S47 = outputs_2[output_2];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_2[output_2] = Relu_apply_0(_S46[int(0)] + _S47);
        }
        int _S48 = output_2 + int(1);
        if(_S48 < int(64))
        {
            if(adds_2)
            {
                _S47 = outputs_2[_S48];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_2[_S48] = Relu_apply_0(_S46[int(1)] + _S47);
        }
        int _S49 = output_2 + int(2);
        if(_S49 < int(64))
        {
            if(adds_2)
            {
                _S47 = outputs_2[_S49];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_2[_S49] = Relu_apply_0(_S46[int(2)] + _S47);
        }
        int _S50 = output_2 + int(3);
        if(_S50 < int(64))
        {
            if(adds_2)
            {
                _S47 = outputs_2[_S50];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_2[_S50] = Relu_apply_0(_S46[int(3)] + _S47);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

void dense_0(FloatWeights_0 weights_5, uint first_4, bool adds_3, inout float  inputs_5[int(64)], inout float  outputs_3[int(64)])
{
    dense_part_0(weights_5, first_4, adds_3, inputs_5, outputs_3);
    return;
}

void dense_1(FloatWeights_0 weights_6, uint first_5, bool adds_4, inout float  inputs_6[int(64)], inout float  outputs_4[int(3)])
{
    dense_part_1(weights_6, first_5, adds_4, inputs_6, outputs_4);
    return;
}

void dense_2(FloatWeights_0 weights_7, uint first_6, bool adds_5, inout float  inputs_7[int(20)], inout float  outputs_5[int(64)])
{
    dense_part_2(weights_7, first_6, adds_5, inputs_7, outputs_5);
    return;
}

struct MLP_0
{
    FloatWeights_0 weights_8;
};

int layer_size_0(int inputs_8, int outputs_6)
{
    return whole_parts_0((outputs_6 + int(7)) / int(8)) + whole_parts_0((inputs_8 + int(7)) / int(8) * ((outputs_6 + int(4) - int(1)) / int(4) * int(4)));
}

void MLP_evaluate_0(MLP_0 this_1, inout float  inputs_9[int(20)], inout float  outputs_7[int(3)])
{
    float  odd_0[int(64)];
    float  even_0[int(64)];
    dense_2(this_1.weights_8, 0U, false, inputs_9, even_0);
    int layer_0 = int(1);
    for(;;)
    {
        if(layer_0 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S51 = layer_size_0(int(64), int(64));
        uint _S52 = uint(layer_size_0(int(20), int(64)) + (layer_0 - int(1)) * _S51);
        dense_0(this_1.weights_8, _S52, false, even_0, odd_0);
        if((layer_0 + int(1)) < int(3))
        {
            dense_0(this_1.weights_8, _S52 + uint(_S51), false, odd_0, even_0);
        }
        layer_0 = layer_0 + int(2);
    }
    uint _S53 = uint(layer_size_0(int(20), int(64)) + int(2) * layer_size_0(int(64), int(64)));
    dense_1(this_1.weights_8, _S53, false, even_0, outputs_7);
    return;
}

float4 tile_product_2(FloatWeights_0 weights_9, uint row_2, inout float  inputs_10[int(32)])
{
    float4 sums_3 = (float4)0.0f;
    uint column_2 = 0U;
    for(;;)
    {
        if(column_2 < 4U)
        {
        }
        else
        {
            break;
        }
        float4 low_3;
        float4 high_3;
        int _S54 = int(8U * column_2);
        low_3[int(0)] = inputs_10[_S54];
        high_3[int(0)] = inputs_10[_S54 + int(4)];
        int _S55 = _S54 + int(1);
        low_3[int(1)] = inputs_10[_S55];
        high_3[int(1)] = inputs_10[_S55 + int(4)];
        int _S56 = _S54 + int(2);
        low_3[int(2)] = inputs_10[_S56];
        high_3[int(2)] = inputs_10[_S56 + int(4)];
        int _S57 = _S54 + int(3);
        low_3[int(3)] = inputs_10[_S57];
        high_3[int(3)] = inputs_10[_S57 + int(4)];
        Eight_0 _S58 = FloatWeights_eight_0(weights_9, row_2 + column_2);
        sums_3[int(0)] = sums_3[int(0)] + (dot(_S58.low_0, low_3) + dot(_S58.high_0, high_3));
        Eight_0 _S59 = FloatWeights_eight_0(weights_9, row_2 + 4U + column_2);
        sums_3[int(1)] = sums_3[int(1)] + (dot(_S59.low_0, low_3) + dot(_S59.high_0, high_3));
        Eight_0 _S60 = FloatWeights_eight_0(weights_9, row_2 + 8U + column_2);
        sums_3[int(2)] = sums_3[int(2)] + (dot(_S60.low_0, low_3) + dot(_S60.high_0, high_3));
        Eight_0 _S61 = FloatWeights_eight_0(weights_9, row_2 + 12U + column_2);
        sums_3[int(3)] = sums_3[int(3)] + (dot(_S61.low_0, low_3) + dot(_S61.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
}

void dense_part_3(FloatWeights_0 weights_10, uint first_7, bool adds_6, inout float  inputs_11[int(32)], inout float  outputs_8[int(32)])
{
    uint _S62 = first_7 + uint(whole_parts_0(int(4)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S63 = output_3 < int(32);
        if(_S63)
        {
        }
        else
        {
            break;
        }
        uint _S64 = uint(output_3);
        Eight_0 _S65 = FloatWeights_eight_0(weights_10, first_7 + _S64 / 8U);
        float4 _S66 = tile_product_2(weights_10, _S62 + _S64 * 4U, inputs_11);
        float4 _S67;
        if((output_3 & int(4)) != int(0))
        {
            _S67 = _S65.high_0;
        }
        else
        {
            _S67 = _S65.low_0;
        }
        float4 _S68 = _S66 + _S67;
        float _S69;
        if(_S63)
        {
            if(adds_6)
            {
                _S69 = outputs_8[output_3];
            }
            else
            {
                _S69 = 0.0f;
            }
            outputs_8[output_3] = Relu_apply_0(_S68[int(0)] + _S69);
        }
        int _S70 = output_3 + int(1);
        if(_S70 < int(32))
        {
            if(adds_6)
            {
                _S69 = outputs_8[_S70];
            }
            else
            {
                _S69 = 0.0f;
            }
            outputs_8[_S70] = Relu_apply_0(_S68[int(1)] + _S69);
        }
        int _S71 = output_3 + int(2);
        if(_S71 < int(32))
        {
            if(adds_6)
            {
                _S69 = outputs_8[_S71];
            }
            else
            {
                _S69 = 0.0f;
            }
            outputs_8[_S71] = Relu_apply_0(_S68[int(2)] + _S69);
        }
        int _S72 = output_3 + int(3);
        if(_S72 < int(32))
        {
            if(adds_6)
            {
                _S69 = outputs_8[_S72];
            }
            else
            {
                _S69 = 0.0f;
            }
            outputs_8[_S72] = Relu_apply_0(_S68[int(3)] + _S69);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

void dense_part_4(FloatWeights_0 weights_11, uint first_8, bool adds_7, inout float  inputs_12[int(32)], inout float  outputs_9[int(3)])
{
    uint _S73 = first_8 + uint(whole_parts_0(int(1)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S74 = output_4 < int(3);
        if(_S74)
        {
        }
        else
        {
            break;
        }
        uint _S75 = uint(output_4);
        Eight_0 _S76 = FloatWeights_eight_0(weights_11, first_8 + _S75 / 8U);
        float4 _S77 = tile_product_2(weights_11, _S73 + _S75 * 4U, inputs_12);
        float4 _S78;
        if((output_4 & int(4)) != int(0))
        {
            _S78 = _S76.high_0;
        }
        else
        {
            _S78 = _S76.low_0;
        }
        float4 _S79 = _S77 + _S78;
        float _S80;
        if(_S74)
        {
            if(adds_7)
            {
                _S80 = outputs_9[output_4];
            }
            else
            {
                _S80 = 0.0f;
            }
            outputs_9[output_4] = Identity_apply_0(_S79[int(0)] + _S80);
        }
        int _S81 = output_4 + int(1);
        if(_S81 < int(3))
        {
            if(adds_7)
            {
                _S80 = outputs_9[_S81];
            }
            else
            {
                _S80 = 0.0f;
            }
            outputs_9[_S81] = Identity_apply_0(_S79[int(1)] + _S80);
        }
        int _S82 = output_4 + int(2);
        if(_S82 < int(3))
        {
            if(adds_7)
            {
                _S80 = outputs_9[_S82];
            }
            else
            {
                _S80 = 0.0f;
            }
            outputs_9[_S82] = Identity_apply_0(_S79[int(2)] + _S80);
        }
        int _S83 = output_4 + int(3);
        if(_S83 < int(3))
        {
            if(adds_7)
            {
                _S80 = outputs_9[_S83];
            }
            else
            {
                _S80 = 0.0f;
            }
            outputs_9[_S83] = Identity_apply_0(_S79[int(3)] + _S80);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

void dense_part_5(FloatWeights_0 weights_12, uint first_9, bool adds_8, inout float  inputs_13[int(20)], inout float  outputs_10[int(32)])
{
    uint _S84 = first_9 + uint(whole_parts_0(int(4)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S85 = output_5 < int(32);
        if(_S85)
        {
        }
        else
        {
            break;
        }
        uint _S86 = uint(output_5);
        Eight_0 _S87 = FloatWeights_eight_0(weights_12, first_9 + _S86 / 8U);
        float4 _S88 = tile_product_1(weights_12, _S84 + _S86 * 3U, inputs_13);
        float4 _S89;
        if((output_5 & int(4)) != int(0))
        {
            _S89 = _S87.high_0;
        }
        else
        {
            _S89 = _S87.low_0;
        }
        float4 _S90 = _S88 + _S89;
        float _S91;
        if(_S85)
        {
            if(adds_8)
            {
                _S91 = outputs_10[output_5];
            }
            else
            {
                _S91 = 0.0f;
            }
            outputs_10[output_5] = Relu_apply_0(_S90[int(0)] + _S91);
        }
        int _S92 = output_5 + int(1);
        if(_S92 < int(32))
        {
            if(adds_8)
            {
                _S91 = outputs_10[_S92];
            }
            else
            {
                _S91 = 0.0f;
            }
            outputs_10[_S92] = Relu_apply_0(_S90[int(1)] + _S91);
        }
        int _S93 = output_5 + int(2);
        if(_S93 < int(32))
        {
            if(adds_8)
            {
                _S91 = outputs_10[_S93];
            }
            else
            {
                _S91 = 0.0f;
            }
            outputs_10[_S93] = Relu_apply_0(_S90[int(2)] + _S91);
        }
        int _S94 = output_5 + int(3);
        if(_S94 < int(32))
        {
            if(adds_8)
            {
                _S91 = outputs_10[_S94];
            }
            else
            {
                _S91 = 0.0f;
            }
            outputs_10[_S94] = Relu_apply_0(_S90[int(3)] + _S91);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

void dense_3(FloatWeights_0 weights_13, uint first_10, bool adds_9, inout float  inputs_14[int(32)], inout float  outputs_11[int(32)])
{
    dense_part_3(weights_13, first_10, adds_9, inputs_14, outputs_11);
    return;
}

void dense_4(FloatWeights_0 weights_14, uint first_11, bool adds_10, inout float  inputs_15[int(32)], inout float  outputs_12[int(3)])
{
    dense_part_4(weights_14, first_11, adds_10, inputs_15, outputs_12);
    return;
}

void dense_5(FloatWeights_0 weights_15, uint first_12, bool adds_11, inout float  inputs_16[int(20)], inout float  outputs_13[int(32)])
{
    dense_part_5(weights_15, first_12, adds_11, inputs_16, outputs_13);
    return;
}

void MLP_evaluate_1(MLP_0 this_2, inout float  inputs_17[int(20)], inout float  outputs_14[int(3)])
{
    float  odd_1[int(32)];
    float  even_1[int(32)];
    dense_5(this_2.weights_8, 0U, false, inputs_17, even_1);
    int layer_1 = int(1);
    for(;;)
    {
        if(layer_1 < int(2))
        {
        }
        else
        {
            break;
        }
        int _S95 = layer_size_0(int(32), int(32));
        uint _S96 = uint(layer_size_0(int(20), int(32)) + (layer_1 - int(1)) * _S95);
        dense_3(this_2.weights_8, _S96, false, even_1, odd_1);
        if((layer_1 + int(1)) < int(2))
        {
            dense_3(this_2.weights_8, _S96 + uint(_S95), false, odd_1, even_1);
        }
        layer_1 = layer_1 + int(2);
    }
    uint _S97 = uint(layer_size_0(int(20), int(32)) + layer_size_0(int(32), int(32)));
    dense_4(this_2.weights_8, _S97, false, odd_1, outputs_14);
    return;
}

float4 tile_product_3(FloatWeights_0 weights_16, uint row_3, inout float  inputs_18[int(16)])
{
    float4 sums_4 = (float4)0.0f;
    uint column_3 = 0U;
    for(;;)
    {
        if(column_3 < 2U)
        {
        }
        else
        {
            break;
        }
        float4 low_4;
        float4 high_4;
        int _S98 = int(8U * column_3);
        low_4[int(0)] = inputs_18[_S98];
        high_4[int(0)] = inputs_18[_S98 + int(4)];
        int _S99 = _S98 + int(1);
        low_4[int(1)] = inputs_18[_S99];
        high_4[int(1)] = inputs_18[_S99 + int(4)];
        int _S100 = _S98 + int(2);
        low_4[int(2)] = inputs_18[_S100];
        high_4[int(2)] = inputs_18[_S100 + int(4)];
        int _S101 = _S98 + int(3);
        low_4[int(3)] = inputs_18[_S101];
        high_4[int(3)] = inputs_18[_S101 + int(4)];
        Eight_0 _S102 = FloatWeights_eight_0(weights_16, row_3 + column_3);
        sums_4[int(0)] = sums_4[int(0)] + (dot(_S102.low_0, low_4) + dot(_S102.high_0, high_4));
        Eight_0 _S103 = FloatWeights_eight_0(weights_16, row_3 + 2U + column_3);
        sums_4[int(1)] = sums_4[int(1)] + (dot(_S103.low_0, low_4) + dot(_S103.high_0, high_4));
        Eight_0 _S104 = FloatWeights_eight_0(weights_16, row_3 + 4U + column_3);
        sums_4[int(2)] = sums_4[int(2)] + (dot(_S104.low_0, low_4) + dot(_S104.high_0, high_4));
        Eight_0 _S105 = FloatWeights_eight_0(weights_16, row_3 + 6U + column_3);
        sums_4[int(3)] = sums_4[int(3)] + (dot(_S105.low_0, low_4) + dot(_S105.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
}

void dense_part_6(FloatWeights_0 weights_17, uint first_13, bool adds_12, inout float  inputs_19[int(16)], inout float  outputs_15[int(16)])
{
    uint _S106 = first_13 + uint(whole_parts_0(int(2)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S107 = output_6 < int(16);
        if(_S107)
        {
        }
        else
        {
            break;
        }
        uint _S108 = uint(output_6);
        Eight_0 _S109 = FloatWeights_eight_0(weights_17, first_13 + _S108 / 8U);
        float4 _S110 = tile_product_3(weights_17, _S106 + _S108 * 2U, inputs_19);
        float4 _S111;
        if((output_6 & int(4)) != int(0))
        {
            _S111 = _S109.high_0;
        }
        else
        {
            _S111 = _S109.low_0;
        }
        float4 _S112 = _S110 + _S111;
        float _S113;
        if(_S107)
        {
            if(adds_12)
            {
                _S113 = outputs_15[output_6];
            }
            else
            {
                _S113 = 0.0f;
            }
            outputs_15[output_6] = Relu_apply_0(_S112[int(0)] + _S113);
        }
        int _S114 = output_6 + int(1);
        if(_S114 < int(16))
        {
            if(adds_12)
            {
                _S113 = outputs_15[_S114];
            }
            else
            {
                _S113 = 0.0f;
            }
            outputs_15[_S114] = Relu_apply_0(_S112[int(1)] + _S113);
        }
        int _S115 = output_6 + int(2);
        if(_S115 < int(16))
        {
            if(adds_12)
            {
                _S113 = outputs_15[_S115];
            }
            else
            {
                _S113 = 0.0f;
            }
            outputs_15[_S115] = Relu_apply_0(_S112[int(2)] + _S113);
        }
        int _S116 = output_6 + int(3);
        if(_S116 < int(16))
        {
            if(adds_12)
            {
                _S113 = outputs_15[_S116];
            }
            else
            {
                _S113 = 0.0f;
            }
            outputs_15[_S116] = Relu_apply_0(_S112[int(3)] + _S113);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

void dense_part_7(FloatWeights_0 weights_18, uint first_14, bool adds_13, inout float  inputs_20[int(16)], inout float  outputs_16[int(3)])
{
    uint _S117 = first_14 + uint(whole_parts_0(int(1)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S118 = output_7 < int(3);
        if(_S118)
        {
        }
        else
        {
            break;
        }
        uint _S119 = uint(output_7);
        Eight_0 _S120 = FloatWeights_eight_0(weights_18, first_14 + _S119 / 8U);
        float4 _S121 = tile_product_3(weights_18, _S117 + _S119 * 2U, inputs_20);
        float4 _S122;
        if((output_7 & int(4)) != int(0))
        {
            _S122 = _S120.high_0;
        }
        else
        {
            _S122 = _S120.low_0;
        }
        float4 _S123 = _S121 + _S122;
        float _S124;
        if(_S118)
        {
            if(adds_13)
            {
                _S124 = outputs_16[output_7];
            }
            else
            {
                _S124 = 0.0f;
            }
            outputs_16[output_7] = Identity_apply_0(_S123[int(0)] + _S124);
        }
        int _S125 = output_7 + int(1);
        if(_S125 < int(3))
        {
            if(adds_13)
            {
                _S124 = outputs_16[_S125];
            }
            else
            {
                _S124 = 0.0f;
            }
            outputs_16[_S125] = Identity_apply_0(_S123[int(1)] + _S124);
        }
        int _S126 = output_7 + int(2);
        if(_S126 < int(3))
        {
            if(adds_13)
            {
                _S124 = outputs_16[_S126];
            }
            else
            {
                _S124 = 0.0f;
            }
            outputs_16[_S126] = Identity_apply_0(_S123[int(2)] + _S124);
        }
        int _S127 = output_7 + int(3);
        if(_S127 < int(3))
        {
            if(adds_13)
            {
                _S124 = outputs_16[_S127];
            }
            else
            {
                _S124 = 0.0f;
            }
            outputs_16[_S127] = Identity_apply_0(_S123[int(3)] + _S124);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

void dense_part_8(FloatWeights_0 weights_19, uint first_15, bool adds_14, inout float  inputs_21[int(20)], inout float  outputs_17[int(16)])
{
    uint _S128 = first_15 + uint(whole_parts_0(int(2)));
    int output_8 = int(0);
    for(;;)
    {
        bool _S129 = output_8 < int(16);
        if(_S129)
        {
        }
        else
        {
            break;
        }
        uint _S130 = uint(output_8);
        Eight_0 _S131 = FloatWeights_eight_0(weights_19, first_15 + _S130 / 8U);
        float4 _S132 = tile_product_1(weights_19, _S128 + _S130 * 3U, inputs_21);
        float4 _S133;
        if((output_8 & int(4)) != int(0))
        {
            _S133 = _S131.high_0;
        }
        else
        {
            _S133 = _S131.low_0;
        }
        float4 _S134 = _S132 + _S133;
        float _S135;
        if(_S129)
        {
            if(adds_14)
            {
                _S135 = outputs_17[output_8];
            }
            else
            {
                _S135 = 0.0f;
            }
            outputs_17[output_8] = Relu_apply_0(_S134[int(0)] + _S135);
        }
        int _S136 = output_8 + int(1);
        if(_S136 < int(16))
        {
            if(adds_14)
            {
                _S135 = outputs_17[_S136];
            }
            else
            {
                _S135 = 0.0f;
            }
            outputs_17[_S136] = Relu_apply_0(_S134[int(1)] + _S135);
        }
        int _S137 = output_8 + int(2);
        if(_S137 < int(16))
        {
            if(adds_14)
            {
                _S135 = outputs_17[_S137];
            }
            else
            {
                _S135 = 0.0f;
            }
            outputs_17[_S137] = Relu_apply_0(_S134[int(2)] + _S135);
        }
        int _S138 = output_8 + int(3);
        if(_S138 < int(16))
        {
            if(adds_14)
            {
                _S135 = outputs_17[_S138];
            }
            else
            {
                _S135 = 0.0f;
            }
            outputs_17[_S138] = Relu_apply_0(_S134[int(3)] + _S135);
        }
        output_8 = output_8 + int(4);
    }
    return;
}

void dense_6(FloatWeights_0 weights_20, uint first_16, bool adds_15, inout float  inputs_22[int(16)], inout float  outputs_18[int(16)])
{
    dense_part_6(weights_20, first_16, adds_15, inputs_22, outputs_18);
    return;
}

void dense_7(FloatWeights_0 weights_21, uint first_17, bool adds_16, inout float  inputs_23[int(16)], inout float  outputs_19[int(3)])
{
    dense_part_7(weights_21, first_17, adds_16, inputs_23, outputs_19);
    return;
}

void dense_8(FloatWeights_0 weights_22, uint first_18, bool adds_17, inout float  inputs_24[int(20)], inout float  outputs_20[int(16)])
{
    dense_part_8(weights_22, first_18, adds_17, inputs_24, outputs_20);
    return;
}

void MLP_evaluate_2(MLP_0 this_3, inout float  inputs_25[int(20)], inout float  outputs_21[int(3)])
{
    float  odd_2[int(16)];
    float  even_2[int(16)];
    dense_8(this_3.weights_8, 0U, false, inputs_25, even_2);
    int layer_2 = int(1);
    for(;;)
    {
        if(layer_2 < int(2))
        {
        }
        else
        {
            break;
        }
        int _S139 = layer_size_0(int(16), int(16));
        uint _S140 = uint(layer_size_0(int(20), int(16)) + (layer_2 - int(1)) * _S139);
        dense_6(this_3.weights_8, _S140, false, even_2, odd_2);
        if((layer_2 + int(1)) < int(2))
        {
            dense_6(this_3.weights_8, _S140 + uint(_S139), false, odd_2, even_2);
        }
        layer_2 = layer_2 + int(2);
    }
    uint _S141 = uint(layer_size_0(int(20), int(16)) + layer_size_0(int(16), int(16)));
    dense_7(this_3.weights_8, _S141, false, odd_2, outputs_21);
    return;
}

float4 tile_product_4(FloatWeights_0 weights_23, uint row_4, inout float  inputs_26[int(8)])
{
    float4 sums_5 = (float4)0.0f;
    uint column_4 = 0U;
    for(;;)
    {
        if(column_4 < 1U)
        {
        }
        else
        {
            break;
        }
        float4 low_5;
        float4 high_5;
        int _S142 = int(8U * column_4);
        low_5[int(0)] = inputs_26[_S142];
        high_5[int(0)] = inputs_26[_S142 + int(4)];
        int _S143 = _S142 + int(1);
        low_5[int(1)] = inputs_26[_S143];
        high_5[int(1)] = inputs_26[_S143 + int(4)];
        int _S144 = _S142 + int(2);
        low_5[int(2)] = inputs_26[_S144];
        high_5[int(2)] = inputs_26[_S144 + int(4)];
        int _S145 = _S142 + int(3);
        low_5[int(3)] = inputs_26[_S145];
        high_5[int(3)] = inputs_26[_S145 + int(4)];
        Eight_0 _S146 = FloatWeights_eight_0(weights_23, row_4 + column_4);
        sums_5[int(0)] = sums_5[int(0)] + (dot(_S146.low_0, low_5) + dot(_S146.high_0, high_5));
        Eight_0 _S147 = FloatWeights_eight_0(weights_23, row_4 + 1U + column_4);
        sums_5[int(1)] = sums_5[int(1)] + (dot(_S147.low_0, low_5) + dot(_S147.high_0, high_5));
        Eight_0 _S148 = FloatWeights_eight_0(weights_23, row_4 + 2U + column_4);
        sums_5[int(2)] = sums_5[int(2)] + (dot(_S148.low_0, low_5) + dot(_S148.high_0, high_5));
        Eight_0 _S149 = FloatWeights_eight_0(weights_23, row_4 + 3U + column_4);
        sums_5[int(3)] = sums_5[int(3)] + (dot(_S149.low_0, low_5) + dot(_S149.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_5;
}

void dense_part_9(FloatWeights_0 weights_24, uint first_19, bool adds_18, inout float  inputs_27[int(8)], inout float  outputs_22[int(12)])
{
    uint _S150 = first_19 + uint(whole_parts_0(int(2)));
    int output_9 = int(0);
    for(;;)
    {
        bool _S151 = output_9 < int(12);
        if(_S151)
        {
        }
        else
        {
            break;
        }
        uint _S152 = uint(output_9);
        Eight_0 _S153 = FloatWeights_eight_0(weights_24, first_19 + _S152 / 8U);
        float4 _S154 = tile_product_4(weights_24, _S150 + _S152, inputs_27);
        float4 _S155;
        if((output_9 & int(4)) != int(0))
        {
            _S155 = _S153.high_0;
        }
        else
        {
            _S155 = _S153.low_0;
        }
        float4 _S156 = _S154 + _S155;
        float _S157;
        if(_S151)
        {
            if(adds_18)
            {
                _S157 = outputs_22[output_9];
            }
            else
            {
                _S157 = 0.0f;
            }
            outputs_22[output_9] = Identity_apply_0(_S156[int(0)] + _S157);
        }
        int _S158 = output_9 + int(1);
        if(_S158 < int(12))
        {
            if(adds_18)
            {
                _S157 = outputs_22[_S158];
            }
            else
            {
                _S157 = 0.0f;
            }
            outputs_22[_S158] = Identity_apply_0(_S156[int(1)] + _S157);
        }
        int _S159 = output_9 + int(2);
        if(_S159 < int(12))
        {
            if(adds_18)
            {
                _S157 = outputs_22[_S159];
            }
            else
            {
                _S157 = 0.0f;
            }
            outputs_22[_S159] = Identity_apply_0(_S156[int(2)] + _S157);
        }
        int _S160 = output_9 + int(3);
        if(_S160 < int(12))
        {
            if(adds_18)
            {
                _S157 = outputs_22[_S160];
            }
            else
            {
                _S157 = 0.0f;
            }
            outputs_22[_S160] = Identity_apply_0(_S156[int(3)] + _S157);
        }
        output_9 = output_9 + int(4);
    }
    return;
}

void decode_0(uint first_20, inout float  inputs_28[int(20)], inout float  outputs_23[int(3)])
{
    MLP_0 network_1;
    network_1.weights_8.first_0 = first_20;
    MLP_evaluate_0(network_1, inputs_28, outputs_23);
    return;
}

void decode_1(uint first_21, inout float  inputs_29[int(20)], inout float  outputs_24[int(3)])
{
    MLP_0 network_2;
    network_2.weights_8.first_0 = first_21;
    MLP_evaluate_1(network_2, inputs_29, outputs_24);
    return;
}

void decode_2(uint first_22, inout float  inputs_30[int(20)], inout float  outputs_25[int(3)])
{
    MLP_0 network_3;
    network_3.weights_8.first_0 = first_22;
    MLP_evaluate_2(network_3, inputs_30, outputs_25);
    return;
}

void dense_9(FloatWeights_0 weights_25, uint first_23, bool adds_19, inout float  inputs_31[int(8)], inout float  outputs_26[int(12)])
{
    dense_part_9(weights_25, first_23, adds_19, inputs_31, outputs_26);
    return;
}

uint mixed_0(uint number_0)
{
    uint bits_0 = (number_0 ^ (number_0 >> int(16))) * 2246822507U;
    uint bits_1 = (bits_0 ^ (bits_0 >> int(13))) * 3266489909U;
    return bits_1 ^ (bits_1 >> int(16));
}

uint with_number_0(uint hash_0, float number_1)
{
    uint _S161;
    if(number_1 == 0.0f)
    {
        _S161 = 0U;
    }
    else
    {
        _S161 = asuint(number_1);
    }
    return mixed_0(hash_0 ^ _S161);
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

uint hashed_0(Footprint_0 footprint_0, float3 view_1, float2 size_0)
{
    uint hash_1 = 2654435769U;
    uint axis_0 = 0U;
    for(;;)
    {
        if(axis_0 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S162 = footprint_0.centre_0[axis_0] / size_0[axis_0];
        uint _S163 = mixed_0(hash_1 ^ uint((_S162 - floor(_S162)) * 4096.0f));
        uint _S164 = axis_0 + 1U;
        hash_1 = _S163;
        axis_0 = _S164;
    }
    axis_0 = 0U;
    for(;;)
    {
        if(axis_0 < 3U)
        {
        }
        else
        {
            break;
        }
        uint _S165 = with_number_0(hash_1, view_1[axis_0]);
        uint _S166 = axis_0 + 1U;
        hash_1 = _S165;
        axis_0 = _S166;
    }
    return with_number_0(with_number_0(with_number_0(with_number_0(hash_1, footprint_0.dx_0.x), footprint_0.dx_0.y), footprint_0.dy_0.x), footprint_0.dy_0.y);
}

float uniform_of_0(uint seed_2, uint dimension_0)
{
    return float((mixed_0(seed_2 + (dimension_0 + 1U) * 2654435769U)) >> int(8)) * 5.9604644775390625e-08f;
}

float3 to_face_frame_0(float3 direction_0, bool back_2)
{
    float2 _S167 = direction_0.xy;
    float _S168;
    if(back_2)
    {
        _S168 = - direction_0.z;
    }
    else
    {
        _S168 = direction_0.z;
    }
    return float3(_S167, _S168);
}

float natural_logarithm_0(float x_2)
{
    uint _S169 = asuint(x_2);
    float exponent_0 = float(int(_S169 >> int(23)) - int(126));
    float m_0 = asfloat((_S169 & 8388607U) | 1056964608U);
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
    float _S170 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S170 - exponent_1 * 0.00021219444170129f - 0.5f * _S170) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_3)
{
    return natural_logarithm_0(x_3) * 1.4426950216293335f;
}

Eight_0 no_numbers_0()
{
    Eight_0 numbers_1;
    float4 _S171 = (float4)0.0f;
    numbers_1.low_0 = _S171;
    numbers_1.high_0 = _S171;
    return numbers_1;
}

float2 within_repeat_0(float2 uv_0)
{
    return clamp(frac(uv_0), (float2)0.0f, (float2)1.0f);
}

Eight_0 eight_halves_0(uint4 packed_0)
{
    Eight_0 numbers_2;
    uint _S172 = packed_0.x;
    uint _S173 = packed_0.y;
    numbers_2.low_0 = float4(f16tof32(uint2(_S172 & 65535U, _S172 >> 16U)), f16tof32(uint2(_S173 & 65535U, _S173 >> 16U)));
    uint _S174 = packed_0.z;
    uint _S175 = packed_0.w;
    numbers_2.high_0 = float4(f16tof32(uint2(_S174 & 65535U, _S174 >> 16U)), f16tof32(uint2(_S175 & 65535U, _S175 >> 16U)));
    return numbers_2;
}

Eight_0 texel_numbers_0(uint first_24, uint elements_1, uint texel_0)
{
    uint _S176 = first_24 + texel_0 * elements_1;
    uint4 _S177 = packed_numbers_0.Load(_S176);
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S177);
    }
    Eight_0 numbers_3;
    numbers_3.low_0 = asfloat(_S177);
    numbers_3.high_0 = asfloat(packed_numbers_0.Load(_S176 + 1U));
    return numbers_3;
}

void add_bilinear_0(uint first_25, uint elements_2, uint start_0, uint columns_1, uint rows_1, float2 uv_1, float weight_0, inout Eight_0 sums_6)
{
    float2 _S178 = uv_1 * float2(float(columns_1), float(rows_1)) - 0.5f;
    float2 _S179 = floor(_S178);
    float2 _S180 = _S178 - _S179;
    int _S181 = int(_S179.x);
    int _S182 = int(_S179.y);
    uint tap_0 = 0U;
    for(;;)
    {
        if(tap_0 < 4U)
        {
        }
        else
        {
            break;
        }
        uint _S183 = tap_0 & 1U;
        uint _S184 = tap_0 >> int(1);
        Eight_0 _S185 = texel_numbers_0(first_25, elements_2, start_0 + (uint(_S182 + int(_S184)) & (rows_1 - 1U)) * columns_1 + (uint(_S181 + int(_S183)) & (columns_1 - 1U)));
        float _S186;
        if(_S184 != 0U)
        {
            _S186 = _S180.y;
        }
        else
        {
            _S186 = 1.0f - _S180.y;
        }
        float _S187;
        if(_S183 != 0U)
        {
            _S187 = _S180.x;
        }
        else
        {
            _S187 = 1.0f - _S180.x;
        }
        float _S188 = _S186 * _S187 * weight_0;
        sums_6.low_0 = sums_6.low_0 + _S188 * _S185.low_0;
        sums_6.high_0 = sums_6.high_0 + _S188 * _S185.high_0;
        tap_0 = tap_0 + 1U;
    }
    return;
}

struct TexelPyramid_0
{
    uint first_26;
    uint elements_3;
    uint levels_4;
    float last_level_3;
    uint face_texels_2;
};

void TexelPyramid_add_level_0(TexelPyramid_0 this_4, float2 place_0, uint level_0, uint face_0, float weight_1, inout Eight_0 sums_7)
{
    uint _S189 = this_4.levels_4 + 3U * level_0;
    add_bilinear_0(this_4.first_26, this_4.elements_3, face_0 * this_4.face_texels_2 + words_0.Load(_S189), words_0.Load(_S189 + 1U), words_0.Load(_S189 + 2U), place_0, weight_1, sums_7);
    return;
}

Eight_0 TexelPyramid_between_levels_0(TexelPyramid_0 this_5, float2 uv_2, float level_1, uint face_1)
{
    float _S190 = clamp(level_1, 0.0f, this_5.last_level_3);
    float _S191 = clamp(floor(_S190), 0.0f, max(this_5.last_level_3 - 1.0f, 0.0f));
    float _S192 = _S190 - _S191;
    float2 _S193 = within_repeat_0(uv_2);
    Eight_0 texel_1 = no_numbers_0();
    uint offset_2 = 0U;
    for(;;)
    {
        if(offset_2 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S194;
        if(offset_2 == 0U)
        {
            _S194 = 1.0f - _S192;
        }
        else
        {
            _S194 = _S192;
        }
        if(_S194 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S193, uint(_S191) + offset_2, face_1, _S194, texel_1);
        }
        offset_2 = offset_2 + 1U;
    }
    return texel_1;
}

Eight_0 TexelPyramid_of_level_0(TexelPyramid_0 this_6, float2 uv_3, uint level_2, uint face_2)
{
    Eight_0 texel_2 = no_numbers_0();
    TexelPyramid_add_level_0(this_6, within_repeat_0(uv_3), level_2, face_2, 1.0f, texel_2);
    return texel_2;
}

float channel_0(Eight_0 numbers_4, int k_0)
{
    float _S195;
    if(k_0 < int(4))
    {
        _S195 = numbers_4.low_0[k_0];
    }
    else
    {
        _S195 = numbers_4.high_0[k_0 - int(4)];
    }
    return _S195;
}

struct LatentFrame_0
{
    float3 tangent_0;
    float3 bitangent_0;
    float3 normal_0;
};

LatentFrame_0 frame_of_0(float3 normal_1, float3 tangent_1)
{
    LatentFrame_0 result_0;
    float3 _S196 = normalize(normal_1 + float3(0.0f, 0.0f, 1.0f));
    result_0.normal_0 = _S196;
    float3 _S197 = normalize(tangent_1 + float3(1.0f, 0.0f, 0.0f));
    result_0.tangent_0 = _S197;
    result_0.bitangent_0 = cross(_S196, _S197);
    return result_0;
}

float3 LatentFrame_coordinates_0(LatentFrame_0 this_7, float3 direction_1)
{
    return float3(dot(direction_1, this_7.tangent_0), dot(direction_1, this_7.bitangent_0), dot(direction_1, this_7.normal_0));
}

float exponential_0(float x_4)
{
    float _S198 = clamp(x_4, -87.0f, 88.0f);
    float _S199 = floor(_S198 * 1.4426950216293335f + 0.5f);
    float _S200 = _S198 - _S199 * 0.693359375f + _S199 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S200 + 0.00139819993637502f) * _S200 + 0.00833345204591751f) * _S200 + 0.04166579619050026f) * _S200 + 0.1666666567325592f) * _S200 + 0.5f;
    float _S201 = asfloat(uint(int(_S199) + int(127)) << int(23));
    float _S202;
    if(x_4 < -87.0f)
    {
        _S202 = 0.0f;
    }
    else
    {
        _S202 = (p_0 * _S200 * _S200 + _S200 + 1.0f) * _S201;
    }
    return _S202;
}

float bounded_exponential_0(float exponent_3)
{
    return exponential_0(min(exponent_3, 12.0f));
}

struct LatentView_0
{
    float  latent_1[int(8)];
    LatentFrame_0 first_27;
    LatentFrame_0 second_0;
    float3 view_2;
    bool back_3;
};

void latent_view_0(uint _S203, Footprint_0 _S204, float3 _S205, float _S206, inout LatentView_0 _S207)
{
    Latent_0 _S208 = fabrics_0[_S203].latent_0;
    bool _S209 = (_S205.z) < 0.0f;
    _S207.back_3 = _S209;
    _S207.view_2 = to_face_frame_0(_S205, _S209);
    uint _S210;
    if(_S209)
    {
        _S210 = _S208.back_1;
    }
    else
    {
        _S210 = 0U;
    }
    float2 _S211 = _S204.centre_0 * float2(_S208.repeats_per_x_1, _S208.repeats_per_y_1);
    float _S212 = clamp(binary_logarithm_0(max(sqrt(abs(_S204.dx_0.x * _S204.dy_0.y - _S204.dx_0.y * _S204.dy_0.x)) * _S208.texels_per_mm_1, 9.99999971718068537e-10f)), 0.0f, _S208.last_level_2);
    TexelPyramid_0 pyramid_0;
    pyramid_0.first_26 = _S208.texels_1;
    pyramid_0.elements_3 = _S208.texel_elements_1;
    pyramid_0.levels_4 = _S208.levels_3;
    pyramid_0.last_level_3 = _S208.last_level_2;
    pyramid_0.face_texels_2 = _S208.face_texels_1;
    Eight_0 texel_3;
    if((_S208.is_trilinear_0) != 0U)
    {
        texel_3 = TexelPyramid_between_levels_0(pyramid_0, _S211, _S212, _S210);
    }
    else
    {
        TexelPyramid_0 _S213 = pyramid_0;
        uint _S214 = uint(_S212);
        uint _S215;
        if(_S206 < (_S212 - floor(_S212)))
        {
            _S215 = 1U;
        }
        else
        {
            _S215 = 0U;
        }
        texel_3 = TexelPyramid_of_level_0(_S213, _S211, _S214 + _S215, _S210);
    }
    int k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(8))
        {
        }
        else
        {
            break;
        }
        _S207.latent_1[k_1] = channel_0(texel_3, k_1);
        k_1 = k_1 + int(1);
    }
    FloatWeights_0 weights_26;
    weights_26.first_0 = _S208.frames_0;
    float  sums_8[int(12)];
    dense_9(weights_26, 0U, false, _S207.latent_1, sums_8);
    _S207.first_27 = frame_of_0(float3(sums_8[int(0)], sums_8[int(1)], sums_8[int(2)]), float3(sums_8[int(3)], sums_8[int(4)], sums_8[int(5)]));
    _S207.second_0 = frame_of_0(float3(sums_8[int(6)], sums_8[int(7)], sums_8[int(8)]), float3(sums_8[int(9)], sums_8[int(10)], sums_8[int(11)]));
    return;
}

float3 latent_value_0(uint _S216, inout LatentView_0 _S217, float3 _S218)
{
    float3 _S219 = to_face_frame_0(_S218, _S217.back_3);
    if((_S219.z) <= 0.0f)
    {
        return (float3)0.0f;
    }
    float  inputs_32[int(20)];
    float3 _S220 = LatentFrame_coordinates_0(_S217.first_27, _S217.view_2);
    float3 _S221 = LatentFrame_coordinates_0(_S217.first_27, _S219);
    float3 _S222 = LatentFrame_coordinates_0(_S217.second_0, _S217.view_2);
    float3 _S223 = LatentFrame_coordinates_0(_S217.second_0, _S219);
    int axis_1 = int(0);
    for(;;)
    {
        if(axis_1 < int(3))
        {
        }
        else
        {
            break;
        }
        inputs_32[axis_1] = _S220[axis_1];
        inputs_32[int(3) + axis_1] = _S221[axis_1];
        inputs_32[int(6) + axis_1] = _S222[axis_1];
        inputs_32[int(9) + axis_1] = _S223[axis_1];
        axis_1 = axis_1 + int(1);
    }
    int k_2 = int(0);
    for(;;)
    {
        if(k_2 < int(8))
        {
        }
        else
        {
            break;
        }
        inputs_32[int(12) + k_2] = _S217.latent_1[k_2];
        k_2 = k_2 + int(1);
    }
    float  outputs_27[int(3)];
    Latent_0 _S224 = fabrics_0[_S216].latent_0;
    if((fabrics_0[_S216].latent_0.hidden_0) == 16U)
    {
        decode_2(_S224.decoder_1, inputs_32, outputs_27);
    }
    else
    {
        if((_S224.hidden_0) == 32U)
        {
            decode_1(_S224.decoder_1, inputs_32, outputs_27);
        }
        else
        {
            decode_0(_S224.decoder_1, inputs_32, outputs_27);
        }
    }
    return float3(bounded_exponential_0(outputs_27[int(0)] - 3.0f), bounded_exponential_0(outputs_27[int(1)] - 3.0f), bounded_exponential_0(outputs_27[int(2)] - 3.0f));
}

float4 cloth_value_0(uint fabric_1, float2 centre_1, float2 dx_1, float2 dy_1, float3 light_1, float3 view_3)
{
    Footprint_0 footprint_1;
    footprint_1.centre_0 = centre_1;
    footprint_1.dx_0 = dx_1;
    footprint_1.dy_0 = dy_1;
    LatentView_0 seen_0;
    latent_view_0(fabric_1, footprint_1, view_3, uniform_of_0(hashed_0(footprint_1, view_3, float2(fabrics_0[fabric_1].latent_0.width_0, fabrics_0[fabric_1].latent_0.height_0)), 0U), seen_0);
    float3 _S225 = latent_value_0(fabric_1, seen_0, light_1);
    return float4(_S225, 0.0f);
}

[numthreads(64, 1, 1)]
void latent_queries(uint3 id_0 : SV_DispatchThreadID)
{
    if((id_0.x) >= query_count_0.Load(int(0)))
    {
        return;
    }
    Query_0 _S226 = queries_0.Load(id_0.x);
    answers_0[id_0.x] = cloth_value_0(_S226.fabric_0, float2(_S226.centre_x_0, _S226.centre_y_0), float2(_S226.dx_x_0, _S226.dx_y_0), float2(_S226.dy_x_0, _S226.dy_y_0), float3(_S226.light_x_0, _S226.light_y_0, _S226.light_z_0), float3(_S226.view_x_0, _S226.view_y_0, _S226.view_z_0));
    return;
}

