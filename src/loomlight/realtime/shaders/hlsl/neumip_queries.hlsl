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

float4 tile_product_0(FloatWeights_0 weights_0, uint row_0, inout float  inputs_0[int(25)])
{
    float4 sums_1 = (float4)0.0f;
    uint column_0 = 0U;
    for(;;)
    {
        if(column_0 < 4U)
        {
        }
        else
        {
            break;
        }
        float4 low_1;
        float4 high_1;
        int _S2 = int(8U * column_0);
        low_1[int(0)] = inputs_0[min(_S2, int(24))];
        high_1[int(0)] = inputs_0[min(_S2 + int(4), int(24))];
        int _S3 = _S2 + int(1);
        low_1[int(1)] = inputs_0[min(_S3, int(24))];
        high_1[int(1)] = inputs_0[min(_S3 + int(4), int(24))];
        int _S4 = _S2 + int(2);
        low_1[int(2)] = inputs_0[min(_S4, int(24))];
        high_1[int(2)] = inputs_0[min(_S4 + int(4), int(24))];
        int _S5 = _S2 + int(3);
        low_1[int(3)] = inputs_0[min(_S5, int(24))];
        high_1[int(3)] = inputs_0[min(_S5 + int(4), int(24))];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_1[int(0)] = sums_1[int(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 4U + column_0);
        sums_1[int(1)] = sums_1[int(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0);
        sums_1[int(2)] = sums_1[int(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_1[int(3)] = sums_1[int(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
}

float Identity_apply_0(float x_0)
{
    return x_0;
}

void dense_part_0(FloatWeights_0 weights_1, uint first_1, bool adds_0, inout float  inputs_1[int(25)], inout float  outputs_0[int(3)])
{
    uint _S10 = first_1 + uint(whole_parts_0(int(1)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S11 = output_0 < int(3);
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U);
        float4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 4U, inputs_1);
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
        if(_S18 < int(3))
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
        if(_S19 < int(3))
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
        if(_S20 < int(3))
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

float4 tile_product_1(FloatWeights_0 weights_2, uint row_1, inout float  inputs_2[int(11)])
{
    float4 sums_2 = (float4)0.0f;
    uint column_1 = 0U;
    for(;;)
    {
        if(column_1 < 2U)
        {
        }
        else
        {
            break;
        }
        float4 low_2;
        float4 high_2;
        int _S21 = int(8U * column_1);
        low_2[int(0)] = inputs_2[min(_S21, int(10))];
        high_2[int(0)] = inputs_2[min(_S21 + int(4), int(10))];
        int _S22 = _S21 + int(1);
        low_2[int(1)] = inputs_2[min(_S22, int(10))];
        high_2[int(1)] = inputs_2[min(_S22 + int(4), int(10))];
        int _S23 = _S21 + int(2);
        low_2[int(2)] = inputs_2[min(_S23, int(10))];
        high_2[int(2)] = inputs_2[min(_S23 + int(4), int(10))];
        int _S24 = _S21 + int(3);
        low_2[int(3)] = inputs_2[min(_S24, int(10))];
        high_2[int(3)] = inputs_2[min(_S24 + int(4), int(10))];
        Eight_0 _S25 = FloatWeights_eight_0(weights_2, row_1 + column_1);
        sums_2[int(0)] = sums_2[int(0)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        Eight_0 _S26 = FloatWeights_eight_0(weights_2, row_1 + 2U + column_1);
        sums_2[int(1)] = sums_2[int(1)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        Eight_0 _S27 = FloatWeights_eight_0(weights_2, row_1 + 4U + column_1);
        sums_2[int(2)] = sums_2[int(2)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        Eight_0 _S28 = FloatWeights_eight_0(weights_2, row_1 + 6U + column_1);
        sums_2[int(3)] = sums_2[int(3)] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
}

float Relu_apply_0(float x_1)
{
    return max(x_1, 0.0f);
}

void dense_part_1(FloatWeights_0 weights_3, uint first_2, bool adds_1, inout float  inputs_3[int(11)], inout float  outputs_1[int(25)])
{
    uint _S29 = first_2 + uint(whole_parts_0(int(4)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S30 = output_1 < int(25);
        if(_S30)
        {
        }
        else
        {
            break;
        }
        uint _S31 = uint(output_1);
        Eight_0 _S32 = FloatWeights_eight_0(weights_3, first_2 + _S31 / 8U);
        float4 _S33 = tile_product_1(weights_3, _S29 + _S31 * 2U, inputs_3);
        float4 _S34;
        if((output_1 & int(4)) != int(0))
        {
            _S34 = _S32.high_0;
        }
        else
        {
            _S34 = _S32.low_0;
        }
        float4 _S35 = _S33 + _S34;
        float _S36;
        if(_S30)
        {
            if(adds_1)
            {
                _S36 = outputs_1[output_1];
            }
            else
            {
                _S36 = 0.0f;
            }
            outputs_1[output_1] = Relu_apply_0(_S35[int(0)] + _S36);
        }
        int _S37 = output_1 + int(1);
        if(_S37 < int(25))
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S37];
            }
            else
            {
                _S36 = 0.0f;
            }
            outputs_1[_S37] = Relu_apply_0(_S35[int(1)] + _S36);
        }
        int _S38 = output_1 + int(2);
        if(_S38 < int(25))
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S38];
            }
            else
            {
                _S36 = 0.0f;
            }
            outputs_1[_S38] = Relu_apply_0(_S35[int(2)] + _S36);
        }
        int _S39 = output_1 + int(3);
        if(_S39 < int(25))
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S39];
            }
            else
            {
                _S36 = 0.0f;
            }
            outputs_1[_S39] = Relu_apply_0(_S35[int(3)] + _S36);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

void dense_0(FloatWeights_0 weights_4, uint first_3, bool adds_2, inout float  inputs_4[int(25)], inout float  outputs_2[int(3)])
{
    dense_part_0(weights_4, first_3, adds_2, inputs_4, outputs_2);
    return;
}

void dense_1(FloatWeights_0 weights_5, uint first_4, bool adds_3, inout float  inputs_5[int(11)], inout float  outputs_3[int(25)])
{
    dense_part_1(weights_5, first_4, adds_3, inputs_5, outputs_3);
    return;
}

float4 tile_product_2(FloatWeights_0 weights_6, uint row_2, inout float  inputs_6[int(16)])
{
    float4 sums_3 = (float4)0.0f;
    uint column_2 = 0U;
    for(;;)
    {
        if(column_2 < 2U)
        {
        }
        else
        {
            break;
        }
        float4 low_3;
        float4 high_3;
        int _S40 = int(8U * column_2);
        low_3[int(0)] = inputs_6[_S40];
        high_3[int(0)] = inputs_6[_S40 + int(4)];
        int _S41 = _S40 + int(1);
        low_3[int(1)] = inputs_6[_S41];
        high_3[int(1)] = inputs_6[_S41 + int(4)];
        int _S42 = _S40 + int(2);
        low_3[int(2)] = inputs_6[_S42];
        high_3[int(2)] = inputs_6[_S42 + int(4)];
        int _S43 = _S40 + int(3);
        low_3[int(3)] = inputs_6[_S43];
        high_3[int(3)] = inputs_6[_S43 + int(4)];
        Eight_0 _S44 = FloatWeights_eight_0(weights_6, row_2 + column_2);
        sums_3[int(0)] = sums_3[int(0)] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        Eight_0 _S45 = FloatWeights_eight_0(weights_6, row_2 + 2U + column_2);
        sums_3[int(1)] = sums_3[int(1)] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        Eight_0 _S46 = FloatWeights_eight_0(weights_6, row_2 + 4U + column_2);
        sums_3[int(2)] = sums_3[int(2)] + (dot(_S46.low_0, low_3) + dot(_S46.high_0, high_3));
        Eight_0 _S47 = FloatWeights_eight_0(weights_6, row_2 + 6U + column_2);
        sums_3[int(3)] = sums_3[int(3)] + (dot(_S47.low_0, low_3) + dot(_S47.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
}

void dense_part_2(FloatWeights_0 weights_7, uint first_5, bool adds_4, inout float  inputs_7[int(16)], inout float  outputs_4[int(16)])
{
    uint _S48 = first_5 + uint(whole_parts_0(int(2)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S49 = output_2 < int(16);
        if(_S49)
        {
        }
        else
        {
            break;
        }
        uint _S50 = uint(output_2);
        Eight_0 _S51 = FloatWeights_eight_0(weights_7, first_5 + _S50 / 8U);
        float4 _S52 = tile_product_2(weights_7, _S48 + _S50 * 2U, inputs_7);
        float4 _S53;
        if((output_2 & int(4)) != int(0))
        {
            _S53 = _S51.high_0;
        }
        else
        {
            _S53 = _S51.low_0;
        }
        float4 _S54 = _S52 + _S53;
        float _S55;
        if(_S49)
        {
            if(adds_4)
            {
                _S55 = outputs_4[output_2];
            }
            else
            {
                _S55 = 0.0f;
            }
            outputs_4[output_2] = Relu_apply_0(_S54[int(0)] + _S55);
        }
        int _S56 = output_2 + int(1);
        if(_S56 < int(16))
        {
            if(adds_4)
            {
                _S55 = outputs_4[_S56];
            }
            else
            {
                _S55 = 0.0f;
            }
            outputs_4[_S56] = Relu_apply_0(_S54[int(1)] + _S55);
        }
        int _S57 = output_2 + int(2);
        if(_S57 < int(16))
        {
            if(adds_4)
            {
                _S55 = outputs_4[_S57];
            }
            else
            {
                _S55 = 0.0f;
            }
            outputs_4[_S57] = Relu_apply_0(_S54[int(2)] + _S55);
        }
        int _S58 = output_2 + int(3);
        if(_S58 < int(16))
        {
            if(adds_4)
            {
                _S55 = outputs_4[_S58];
            }
            else
            {
                _S55 = 0.0f;
            }
            outputs_4[_S58] = Relu_apply_0(_S54[int(3)] + _S55);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

void dense_part_3(FloatWeights_0 weights_8, uint first_6, bool adds_5, inout float  inputs_8[int(16)], inout float  outputs_5[int(1)])
{
    uint _S59 = first_6 + uint(whole_parts_0(int(1)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S60 = output_3 < int(1);
        if(_S60)
        {
        }
        else
        {
            break;
        }
        uint _S61 = uint(output_3);
        Eight_0 _S62 = FloatWeights_eight_0(weights_8, first_6 + _S61 / 8U);
        float4 _S63 = tile_product_2(weights_8, _S59 + _S61 * 2U, inputs_8);
        float4 _S64;
        if((output_3 & int(4)) != int(0))
        {
            _S64 = _S62.high_0;
        }
        else
        {
            _S64 = _S62.low_0;
        }
        float4 _S65 = _S63 + _S64;
        float _S66;
        if(_S60)
        {
            if(adds_5)
            {
                _S66 = outputs_5[output_3];
            }
            else
            {
                _S66 = 0.0f;
            }
            outputs_5[output_3] = Identity_apply_0(_S65[int(0)] + _S66);
        }
        int _S67 = output_3 + int(1);
        if(_S67 < int(1))
        {
            if(adds_5)
            {
                _S66 = outputs_5[_S67];
            }
            else
            {
                _S66 = 0.0f;
            }
            outputs_5[_S67] = Identity_apply_0(_S65[int(1)] + _S66);
        }
        int _S68 = output_3 + int(2);
        if(_S68 < int(1))
        {
            if(adds_5)
            {
                _S66 = outputs_5[_S68];
            }
            else
            {
                _S66 = 0.0f;
            }
            outputs_5[_S68] = Identity_apply_0(_S65[int(2)] + _S66);
        }
        int _S69 = output_3 + int(3);
        if(_S69 < int(1))
        {
            if(adds_5)
            {
                _S66 = outputs_5[_S69];
            }
            else
            {
                _S66 = 0.0f;
            }
            outputs_5[_S69] = Identity_apply_0(_S65[int(3)] + _S66);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

float4 tile_product_3(FloatWeights_0 weights_9, uint row_3, inout float  inputs_9[int(9)])
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
        int _S70 = int(8U * column_3);
        low_4[int(0)] = inputs_9[min(_S70, int(8))];
        high_4[int(0)] = inputs_9[min(_S70 + int(4), int(8))];
        int _S71 = _S70 + int(1);
        low_4[int(1)] = inputs_9[min(_S71, int(8))];
        high_4[int(1)] = inputs_9[min(_S71 + int(4), int(8))];
        int _S72 = _S70 + int(2);
        low_4[int(2)] = inputs_9[min(_S72, int(8))];
        high_4[int(2)] = inputs_9[min(_S72 + int(4), int(8))];
        int _S73 = _S70 + int(3);
        low_4[int(3)] = inputs_9[min(_S73, int(8))];
        high_4[int(3)] = inputs_9[min(_S73 + int(4), int(8))];
        Eight_0 _S74 = FloatWeights_eight_0(weights_9, row_3 + column_3);
        sums_4[int(0)] = sums_4[int(0)] + (dot(_S74.low_0, low_4) + dot(_S74.high_0, high_4));
        Eight_0 _S75 = FloatWeights_eight_0(weights_9, row_3 + 2U + column_3);
        sums_4[int(1)] = sums_4[int(1)] + (dot(_S75.low_0, low_4) + dot(_S75.high_0, high_4));
        Eight_0 _S76 = FloatWeights_eight_0(weights_9, row_3 + 4U + column_3);
        sums_4[int(2)] = sums_4[int(2)] + (dot(_S76.low_0, low_4) + dot(_S76.high_0, high_4));
        Eight_0 _S77 = FloatWeights_eight_0(weights_9, row_3 + 6U + column_3);
        sums_4[int(3)] = sums_4[int(3)] + (dot(_S77.low_0, low_4) + dot(_S77.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
}

void dense_part_4(FloatWeights_0 weights_10, uint first_7, bool adds_6, inout float  inputs_10[int(9)], inout float  outputs_6[int(16)])
{
    uint _S78 = first_7 + uint(whole_parts_0(int(2)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S79 = output_4 < int(16);
        if(_S79)
        {
        }
        else
        {
            break;
        }
        uint _S80 = uint(output_4);
        Eight_0 _S81 = FloatWeights_eight_0(weights_10, first_7 + _S80 / 8U);
        float4 _S82 = tile_product_3(weights_10, _S78 + _S80 * 2U, inputs_10);
        float4 _S83;
        if((output_4 & int(4)) != int(0))
        {
            _S83 = _S81.high_0;
        }
        else
        {
            _S83 = _S81.low_0;
        }
        float4 _S84 = _S82 + _S83;
        float _S85;
        if(_S79)
        {
            if(adds_6)
            {
                _S85 = outputs_6[output_4];
            }
            else
            {
                _S85 = 0.0f;
            }
            outputs_6[output_4] = Relu_apply_0(_S84[int(0)] + _S85);
        }
        int _S86 = output_4 + int(1);
        if(_S86 < int(16))
        {
            if(adds_6)
            {
                _S85 = outputs_6[_S86];
            }
            else
            {
                _S85 = 0.0f;
            }
            outputs_6[_S86] = Relu_apply_0(_S84[int(1)] + _S85);
        }
        int _S87 = output_4 + int(2);
        if(_S87 < int(16))
        {
            if(adds_6)
            {
                _S85 = outputs_6[_S87];
            }
            else
            {
                _S85 = 0.0f;
            }
            outputs_6[_S87] = Relu_apply_0(_S84[int(2)] + _S85);
        }
        int _S88 = output_4 + int(3);
        if(_S88 < int(16))
        {
            if(adds_6)
            {
                _S85 = outputs_6[_S88];
            }
            else
            {
                _S85 = 0.0f;
            }
            outputs_6[_S88] = Relu_apply_0(_S84[int(3)] + _S85);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

void dense_2(FloatWeights_0 weights_11, uint first_8, bool adds_7, inout float  inputs_11[int(16)], inout float  outputs_7[int(16)])
{
    dense_part_2(weights_11, first_8, adds_7, inputs_11, outputs_7);
    return;
}

void dense_3(FloatWeights_0 weights_12, uint first_9, bool adds_8, inout float  inputs_12[int(16)], inout float  outputs_8[int(1)])
{
    dense_part_3(weights_12, first_9, adds_8, inputs_12, outputs_8);
    return;
}

void dense_4(FloatWeights_0 weights_13, uint first_10, bool adds_9, inout float  inputs_13[int(9)], inout float  outputs_9[int(16)])
{
    dense_part_4(weights_13, first_10, adds_9, inputs_13, outputs_9);
    return;
}

void dense_part_5(FloatWeights_0 weights_14, uint first_11, bool adds_10, inout float  inputs_14[int(25)], inout float  outputs_10[int(25)])
{
    uint _S89 = first_11 + uint(whole_parts_0(int(4)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S90 = output_5 < int(25);
        if(_S90)
        {
        }
        else
        {
            break;
        }
        uint _S91 = uint(output_5);
        Eight_0 _S92 = FloatWeights_eight_0(weights_14, first_11 + _S91 / 8U);
        float4 _S93 = tile_product_0(weights_14, _S89 + _S91 * 4U, inputs_14);
        float4 _S94;
        if((output_5 & int(4)) != int(0))
        {
            _S94 = _S92.high_0;
        }
        else
        {
            _S94 = _S92.low_0;
        }
        float4 _S95 = _S93 + _S94;
        float _S96;
        if(_S90)
        {
            if(adds_10)
            {
                _S96 = outputs_10[output_5];
            }
            else
            {
                _S96 = 0.0f;
            }
            outputs_10[output_5] = Relu_apply_0(_S95[int(0)] + _S96);
        }
        int _S97 = output_5 + int(1);
        if(_S97 < int(25))
        {
            if(adds_10)
            {
                _S96 = outputs_10[_S97];
            }
            else
            {
                _S96 = 0.0f;
            }
            outputs_10[_S97] = Relu_apply_0(_S95[int(1)] + _S96);
        }
        int _S98 = output_5 + int(2);
        if(_S98 < int(25))
        {
            if(adds_10)
            {
                _S96 = outputs_10[_S98];
            }
            else
            {
                _S96 = 0.0f;
            }
            outputs_10[_S98] = Relu_apply_0(_S95[int(2)] + _S96);
        }
        int _S99 = output_5 + int(3);
        if(_S99 < int(25))
        {
            if(adds_10)
            {
                _S96 = outputs_10[_S99];
            }
            else
            {
                _S96 = 0.0f;
            }
            outputs_10[_S99] = Relu_apply_0(_S95[int(3)] + _S96);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

void dense_part_6(FloatWeights_0 weights_15, uint first_12, bool adds_11, inout float  inputs_15[int(25)], inout float  outputs_11[int(1)])
{
    uint _S100 = first_12 + uint(whole_parts_0(int(1)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S101 = output_6 < int(1);
        if(_S101)
        {
        }
        else
        {
            break;
        }
        uint _S102 = uint(output_6);
        Eight_0 _S103 = FloatWeights_eight_0(weights_15, first_12 + _S102 / 8U);
        float4 _S104 = tile_product_0(weights_15, _S100 + _S102 * 4U, inputs_15);
        float4 _S105;
        if((output_6 & int(4)) != int(0))
        {
            _S105 = _S103.high_0;
        }
        else
        {
            _S105 = _S103.low_0;
        }
        float4 _S106 = _S104 + _S105;
        float _S107;
        if(_S101)
        {
            if(adds_11)
            {
                _S107 = outputs_11[output_6];
            }
            else
            {
                _S107 = 0.0f;
            }
            outputs_11[output_6] = Identity_apply_0(_S106[int(0)] + _S107);
        }
        int _S108 = output_6 + int(1);
        if(_S108 < int(1))
        {
            if(adds_11)
            {
                _S107 = outputs_11[_S108];
            }
            else
            {
                _S107 = 0.0f;
            }
            outputs_11[_S108] = Identity_apply_0(_S106[int(1)] + _S107);
        }
        int _S109 = output_6 + int(2);
        if(_S109 < int(1))
        {
            if(adds_11)
            {
                _S107 = outputs_11[_S109];
            }
            else
            {
                _S107 = 0.0f;
            }
            outputs_11[_S109] = Identity_apply_0(_S106[int(2)] + _S107);
        }
        int _S110 = output_6 + int(3);
        if(_S110 < int(1))
        {
            if(adds_11)
            {
                _S107 = outputs_11[_S110];
            }
            else
            {
                _S107 = 0.0f;
            }
            outputs_11[_S110] = Identity_apply_0(_S106[int(3)] + _S107);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

void dense_part_7(FloatWeights_0 weights_16, uint first_13, bool adds_12, inout float  inputs_16[int(9)], inout float  outputs_12[int(25)])
{
    uint _S111 = first_13 + uint(whole_parts_0(int(4)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S112 = output_7 < int(25);
        if(_S112)
        {
        }
        else
        {
            break;
        }
        uint _S113 = uint(output_7);
        Eight_0 _S114 = FloatWeights_eight_0(weights_16, first_13 + _S113 / 8U);
        float4 _S115 = tile_product_3(weights_16, _S111 + _S113 * 2U, inputs_16);
        float4 _S116;
        if((output_7 & int(4)) != int(0))
        {
            _S116 = _S114.high_0;
        }
        else
        {
            _S116 = _S114.low_0;
        }
        float4 _S117 = _S115 + _S116;
        float _S118;
        if(_S112)
        {
            if(adds_12)
            {
                _S118 = outputs_12[output_7];
            }
            else
            {
                _S118 = 0.0f;
            }
            outputs_12[output_7] = Relu_apply_0(_S117[int(0)] + _S118);
        }
        int _S119 = output_7 + int(1);
        if(_S119 < int(25))
        {
            if(adds_12)
            {
                _S118 = outputs_12[_S119];
            }
            else
            {
                _S118 = 0.0f;
            }
            outputs_12[_S119] = Relu_apply_0(_S117[int(1)] + _S118);
        }
        int _S120 = output_7 + int(2);
        if(_S120 < int(25))
        {
            if(adds_12)
            {
                _S118 = outputs_12[_S120];
            }
            else
            {
                _S118 = 0.0f;
            }
            outputs_12[_S120] = Relu_apply_0(_S117[int(2)] + _S118);
        }
        int _S121 = output_7 + int(3);
        if(_S121 < int(25))
        {
            if(adds_12)
            {
                _S118 = outputs_12[_S121];
            }
            else
            {
                _S118 = 0.0f;
            }
            outputs_12[_S121] = Relu_apply_0(_S117[int(3)] + _S118);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

void dense_5(FloatWeights_0 weights_17, uint first_14, bool adds_13, inout float  inputs_17[int(25)], inout float  outputs_13[int(25)])
{
    dense_part_5(weights_17, first_14, adds_13, inputs_17, outputs_13);
    return;
}

void dense_6(FloatWeights_0 weights_18, uint first_15, bool adds_14, inout float  inputs_18[int(25)], inout float  outputs_14[int(1)])
{
    dense_part_6(weights_18, first_15, adds_14, inputs_18, outputs_14);
    return;
}

void dense_7(FloatWeights_0 weights_19, uint first_16, bool adds_15, inout float  inputs_19[int(9)], inout float  outputs_15[int(25)])
{
    dense_part_7(weights_19, first_16, adds_15, inputs_19, outputs_15);
    return;
}

struct MLP_0
{
    FloatWeights_0 weights_20;
};

int layer_size_0(int inputs_20, int outputs_16)
{
    return whole_parts_0((outputs_16 + int(7)) / int(8)) + whole_parts_0((inputs_20 + int(7)) / int(8) * ((outputs_16 + int(4) - int(1)) / int(4) * int(4)));
}

void MLP_evaluate_0(MLP_0 this_1, inout float  inputs_21[int(11)], inout float  outputs_17[int(3)])
{
    float  odd_0[int(25)];
    float  even_0[int(25)];
    dense_1(this_1.weights_20, 0U, false, inputs_21, even_0);
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
        int _S122 = layer_size_0(int(25), int(25));
        uint _S123 = uint(layer_size_0(int(11), int(25)) + (layer_0 - int(1)) * _S122);
        dense_5(this_1.weights_20, _S123, false, even_0, odd_0);
        if((layer_0 + int(1)) < int(3))
        {
            dense_5(this_1.weights_20, _S123 + uint(_S122), false, odd_0, even_0);
        }
        layer_0 = layer_0 + int(2);
    }
    uint _S124 = uint(layer_size_0(int(11), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_0(this_1.weights_20, _S124, false, even_0, outputs_17);
    return;
}

void MLP_evaluate_1(MLP_0 this_2, inout float  inputs_22[int(9)], inout float  outputs_18[int(1)])
{
    float  odd_1[int(16)];
    float  even_1[int(16)];
    dense_4(this_2.weights_20, 0U, false, inputs_22, even_1);
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
        int _S125 = layer_size_0(int(16), int(16));
        uint _S126 = uint(layer_size_0(int(9), int(16)) + (layer_1 - int(1)) * _S125);
        dense_2(this_2.weights_20, _S126, false, even_1, odd_1);
        if((layer_1 + int(1)) < int(2))
        {
            dense_2(this_2.weights_20, _S126 + uint(_S125), false, odd_1, even_1);
        }
        layer_1 = layer_1 + int(2);
    }
    uint _S127 = uint(layer_size_0(int(9), int(16)) + layer_size_0(int(16), int(16)));
    dense_3(this_2.weights_20, _S127, false, odd_1, outputs_18);
    return;
}

void MLP_evaluate_2(MLP_0 this_3, inout float  inputs_23[int(9)], inout float  outputs_19[int(1)])
{
    float  odd_2[int(25)];
    float  even_2[int(25)];
    dense_7(this_3.weights_20, 0U, false, inputs_23, even_2);
    int layer_2 = int(1);
    for(;;)
    {
        if(layer_2 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S128 = layer_size_0(int(25), int(25));
        uint _S129 = uint(layer_size_0(int(9), int(25)) + (layer_2 - int(1)) * _S128);
        dense_5(this_3.weights_20, _S129, false, even_2, odd_2);
        if((layer_2 + int(1)) < int(3))
        {
            dense_5(this_3.weights_20, _S129 + uint(_S128), false, odd_2, even_2);
        }
        layer_2 = layer_2 + int(2);
    }
    uint _S130 = uint(layer_size_0(int(9), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_6(this_3.weights_20, _S130, false, even_2, outputs_19);
    return;
}

float3 to_face_frame_0(float3 direction_0, bool back_2)
{
    float2 _S131 = direction_0.xy;
    float _S132;
    if(back_2)
    {
        _S132 = - direction_0.z;
    }
    else
    {
        _S132 = direction_0.z;
    }
    return float3(_S131, _S132);
}

Eight_0 no_numbers_0()
{
    Eight_0 numbers_1;
    float4 _S133 = (float4)0.0f;
    numbers_1.low_0 = _S133;
    numbers_1.high_0 = _S133;
    return numbers_1;
}

Eight_0 eight_halves_0(uint4 packed_0)
{
    Eight_0 numbers_2;
    uint _S134 = packed_0.x;
    uint _S135 = packed_0.y;
    numbers_2.low_0 = float4(f16tof32(uint2(_S134 & 65535U, _S134 >> 16U)), f16tof32(uint2(_S135 & 65535U, _S135 >> 16U)));
    uint _S136 = packed_0.z;
    uint _S137 = packed_0.w;
    numbers_2.high_0 = float4(f16tof32(uint2(_S136 & 65535U, _S136 >> 16U)), f16tof32(uint2(_S137 & 65535U, _S137 >> 16U)));
    return numbers_2;
}

Eight_0 texel_numbers_0(uint first_17, uint elements_1, uint texel_0)
{
    uint _S138 = first_17 + texel_0 * elements_1;
    uint4 _S139 = packed_numbers_0.Load(_S138);
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S139);
    }
    Eight_0 numbers_3;
    numbers_3.low_0 = asfloat(_S139);
    numbers_3.high_0 = asfloat(packed_numbers_0.Load(_S138 + 1U));
    return numbers_3;
}

void add_bilinear_0(uint first_18, uint elements_2, uint start_0, uint columns_1, uint rows_1, float2 uv_0, float weight_0, inout Eight_0 sums_5)
{
    float2 _S140 = uv_0 * float2(float(columns_1), float(rows_1)) - 0.5f;
    float2 _S141 = floor(_S140);
    float2 _S142 = _S140 - _S141;
    int _S143 = int(_S141.x);
    int _S144 = int(_S141.y);
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
        uint _S145 = tap_0 & 1U;
        uint _S146 = tap_0 >> int(1);
        Eight_0 _S147 = texel_numbers_0(first_18, elements_2, start_0 + (uint(_S144 + int(_S146)) & (rows_1 - 1U)) * columns_1 + (uint(_S143 + int(_S145)) & (columns_1 - 1U)));
        float _S148;
        if(_S146 != 0U)
        {
            _S148 = _S142.y;
        }
        else
        {
            _S148 = 1.0f - _S142.y;
        }
        float _S149;
        if(_S145 != 0U)
        {
            _S149 = _S142.x;
        }
        else
        {
            _S149 = 1.0f - _S142.x;
        }
        float _S150 = _S148 * _S149 * weight_0;
        sums_5.low_0 = sums_5.low_0 + _S150 * _S147.low_0;
        sums_5.high_0 = sums_5.high_0 + _S150 * _S147.high_0;
        tap_0 = tap_0 + 1U;
    }
    return;
}

float channel_0(Eight_0 numbers_4, int k_0)
{
    float _S151;
    if(k_0 < int(4))
    {
        _S151 = numbers_4.low_0[k_0];
    }
    else
    {
        _S151 = numbers_4.high_0[k_0 - int(4)];
    }
    return _S151;
}

float neumip_depth_0(Neumip_0 model_0, float2 uv_1, float2 view_1, uint face_0)
{
    uint _S152 = words_0.Load(model_0.levels_2 + 1U);
    uint _S153 = words_0.Load(model_0.levels_2 + 2U);
    Eight_0 texel_1 = no_numbers_0();
    add_bilinear_0(model_0.offset_texels_0, model_0.texel_elements_0, face_0 * _S152 * _S153, _S152, _S153, frac(uv_1), 1.0f, texel_1);
    float  inputs_24[int(9)];
    int k_1 = int(0);
    for(;;)
    {
        if(k_1 < int(7))
        {
        }
        else
        {
            break;
        }
        inputs_24[k_1] = channel_0(texel_1, k_1);
        k_1 = k_1 + int(1);
    }
    inputs_24[int(7)] = view_1.x;
    inputs_24[int(8)] = view_1.y;
    MLP_0 network_1;
    network_1.weights_20.first_0 = model_0.offset_0;
    float  depth_0[int(1)];
    MLP_evaluate_2(network_1, inputs_24, depth_0);
    return depth_0[int(0)];
}

float natural_logarithm_0(float x_2)
{
    uint _S154 = asuint(x_2);
    float exponent_0 = float(int(_S154 >> int(23)) - int(126));
    float m_0 = asfloat((_S154 & 8388607U) | 1056964608U);
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
    float _S155 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S155 - exponent_1 * 0.00021219444170129f - 0.5f * _S155) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_3)
{
    return natural_logarithm_0(x_3) * 1.4426950216293335f;
}

float2 within_repeat_0(float2 uv_2)
{
    return clamp(frac(uv_2), (float2)0.0f, (float2)1.0f);
}

struct TexelPyramid_0
{
    uint first_19;
    uint elements_3;
    uint levels_4;
    float last_level_3;
    uint face_texels_2;
};

void TexelPyramid_add_level_0(TexelPyramid_0 this_4, float2 place_0, uint level_0, uint face_1, float weight_1, inout Eight_0 sums_6)
{
    uint _S156 = this_4.levels_4 + 3U * level_0;
    add_bilinear_0(this_4.first_19, this_4.elements_3, face_1 * this_4.face_texels_2 + words_0.Load(_S156), words_0.Load(_S156 + 1U), words_0.Load(_S156 + 2U), place_0, weight_1, sums_6);
    return;
}

Eight_0 TexelPyramid_between_levels_0(TexelPyramid_0 this_5, float2 uv_3, float level_1, uint face_2)
{
    float _S157 = clamp(level_1, 0.0f, this_5.last_level_3);
    float _S158 = clamp(floor(_S157), 0.0f, max(this_5.last_level_3 - 1.0f, 0.0f));
    float _S159 = _S157 - _S158;
    float2 _S160 = within_repeat_0(uv_3);
    Eight_0 texel_2 = no_numbers_0();
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
        float _S161;
        if(offset_2 == 0U)
        {
            _S161 = 1.0f - _S159;
        }
        else
        {
            _S161 = _S159;
        }
        if(_S161 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S160, uint(_S158) + offset_2, face_2, _S161, texel_2);
        }
        offset_2 = offset_2 + 1U;
    }
    return texel_2;
}

float exponential_0(float x_4)
{
    float _S162 = clamp(x_4, -87.0f, 88.0f);
    float _S163 = floor(_S162 * 1.4426950216293335f + 0.5f);
    float _S164 = _S162 - _S163 * 0.693359375f + _S163 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S164 + 0.00139819993637502f) * _S164 + 0.00833345204591751f) * _S164 + 0.04166579619050026f) * _S164 + 0.1666666567325592f) * _S164 + 0.5f;
    float _S165 = asfloat(uint(int(_S163) + int(127)) << int(23));
    float _S166;
    if(x_4 < -87.0f)
    {
        _S166 = 0.0f;
    }
    else
    {
        _S166 = (p_0 * _S164 * _S164 + _S164 + 1.0f) * _S165;
    }
    return _S166;
}

float neumip_hole_0(Neumip_0 model_1, Eight_0 texel_3, float2 view_2)
{
    float  inputs_25[int(9)];
    int k_2 = int(0);
    for(;;)
    {
        if(k_2 < int(7))
        {
        }
        else
        {
            break;
        }
        inputs_25[k_2] = channel_0(texel_3, k_2);
        k_2 = k_2 + int(1);
    }
    inputs_25[int(7)] = view_2.x;
    inputs_25[int(8)] = view_2.y;
    MLP_0 network_2;
    network_2.weights_20.first_0 = model_1.opacity_0;
    float  opening_0[int(1)];
    MLP_evaluate_1(network_2, inputs_25, opening_0);
    return 1.0f / (1.0f + exponential_0(- clamp(opening_0[int(0)], -30.0f, 30.0f)));
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

struct NeumipView_0
{
    float  latent_1[int(7)];
    float2 view_3;
    bool back_3;
    float hole_0;
};

void neumip_view_0(uint _S167, Footprint_0 _S168, float3 _S169, inout NeumipView_0 _S170)
{
    Neumip_0 _S171 = fabrics_0[_S167].neumip_0;
    bool _S172 = (_S169.z) < 0.0f;
    uint _S173;
    if(_S172)
    {
        _S173 = _S171.back_0;
    }
    else
    {
        _S173 = 0U;
    }
    float3 _S174 = to_face_frame_0(_S169, _S172);
    float2 uv_4 = _S168.centre_0 * float2(_S171.repeats_per_x_0, _S171.repeats_per_y_0);
    float2 uv_5;
    if((_S171.has_offset_0) != 0U)
    {
        float2 _S175 = _S174.xy;
        uv_5 = uv_4 + neumip_depth_0(_S171, uv_4, _S175, _S173) / max(_S174.z, 0.60000002384185791f) * _S175 * float2(_S171.unit_x_0, _S171.unit_y_0);
    }
    else
    {
        uv_5 = uv_4;
    }
    float _S176 = sqrt(abs(_S168.dx_0.x * _S168.dy_0.y - _S168.dx_0.y * _S168.dy_0.x)) * _S171.texels_per_mm_0;
    TexelPyramid_0 pyramid_0;
    pyramid_0.first_19 = _S171.features_0;
    pyramid_0.elements_3 = _S171.texel_elements_0;
    pyramid_0.levels_4 = _S171.levels_2;
    pyramid_0.last_level_3 = _S171.last_level_1;
    pyramid_0.face_texels_2 = _S171.face_texels_0;
    Eight_0 _S177 = TexelPyramid_between_levels_0(pyramid_0, uv_5, binary_logarithm_0(max(_S176, 9.99999971718068537e-10f)), _S173);
    int k_3 = int(0);
    for(;;)
    {
        if(k_3 < int(7))
        {
        }
        else
        {
            break;
        }
        _S170.latent_1[k_3] = channel_0(_S177, k_3);
        k_3 = k_3 + int(1);
    }
    float2 _S178 = _S174.xy;
    _S170.view_3 = _S178;
    _S170.back_3 = _S172;
    float _S179;
    if((_S171.has_holes_0) != 0U)
    {
        _S179 = neumip_hole_0(_S171, _S177, _S178);
    }
    else
    {
        _S179 = 0.0f;
    }
    _S170.hole_0 = _S179;
    return;
}

float3 neumip_value_0(uint _S180, inout NeumipView_0 _S181, float3 _S182)
{
    float3 _S183 = to_face_frame_0(_S182, _S181.back_3);
    float _S184 = _S183.z;
    bool _S185;
    if(_S184 < 0.0f)
    {
        _S185 = (fabrics_0[_S180].neumip_0.transmits_0) != 0U;
    }
    else
    {
        _S185 = false;
    }
    bool _S186;
    if(_S184 <= 0.0f)
    {
        _S186 = !_S185;
    }
    else
    {
        _S186 = false;
    }
    if(_S186)
    {
        return (float3)0.0f;
    }
    float  inputs_26[int(11)];
    int k_4 = int(0);
    for(;;)
    {
        if(k_4 < int(7))
        {
        }
        else
        {
            break;
        }
        inputs_26[k_4] = _S181.latent_1[k_4];
        k_4 = k_4 + int(1);
    }
    inputs_26[int(7)] = _S183.x;
    inputs_26[int(8)] = _S183.y;
    inputs_26[int(9)] = _S181.view_3.x;
    inputs_26[int(10)] = _S181.view_3.y;
    float  outputs_20[int(3)];
    MLP_0 network_3;
    uint _S187;
    if(_S185)
    {
        _S187 = fabrics_0[_S180].neumip_0.transmission_0;
    }
    else
    {
        _S187 = fabrics_0[_S180].neumip_0.decoder_0;
    }
    network_3.weights_20.first_0 = _S187;
    MLP_evaluate_0(network_3, inputs_26, outputs_20);
    return max(float3(outputs_20[int(0)], outputs_20[int(1)], outputs_20[int(2)]), (float3)0.0f) * 0.31830987334251404f;
}

float4 cloth_value_0(uint fabric_1, float2 centre_1, float2 dx_1, float2 dy_1, float3 light_1, float3 view_4)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = centre_1;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    NeumipView_0 seen_0;
    neumip_view_0(fabric_1, footprint_0, view_4, seen_0);
    float3 _S188 = neumip_value_0(fabric_1, seen_0, light_1);
    return float4(_S188, seen_0.hole_0);
}

[numthreads(64, 1, 1)]
void neumip_queries(uint3 id_0 : SV_DispatchThreadID)
{
    if((id_0.x) >= query_count_0.Load(int(0)))
    {
        return;
    }
    Query_0 _S189 = queries_0.Load(id_0.x);
    answers_0[id_0.x] = cloth_value_0(_S189.fabric_0, float2(_S189.centre_x_0, _S189.centre_y_0), float2(_S189.dx_x_0, _S189.dx_y_0), float2(_S189.dy_x_0, _S189.dy_y_0), float3(_S189.light_x_0, _S189.light_y_0, _S189.light_z_0), float3(_S189.view_x_0, _S189.view_y_0, _S189.view_z_0));
    return;
}

