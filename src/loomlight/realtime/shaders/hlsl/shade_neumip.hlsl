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

StructuredBuffer<uint > words_0 : register(t2);

StructuredBuffer<uint4 > packed_numbers_0 : register(t8);

RWStructuredBuffer<float > visibilities_0 : register(u3);

StructuredBuffer<uint > scene_words_0 : register(t9);

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
    float4 sums_0 = (float4)0.0f;
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
        sums_0[int(0)] = sums_0[int(0)] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 4U + column_0);
        sums_0[int(1)] = sums_0[int(1)] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0);
        sums_0[int(2)] = sums_0[int(2)] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_0[int(3)] = sums_0[int(3)] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

float Identity_apply_0(float x_2)
{
    return x_2;
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
    float4 sums_1 = (float4)0.0f;
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
        sums_1[int(0)] = sums_1[int(0)] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        Eight_0 _S26 = FloatWeights_eight_0(weights_2, row_1 + 2U + column_1);
        sums_1[int(1)] = sums_1[int(1)] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        Eight_0 _S27 = FloatWeights_eight_0(weights_2, row_1 + 4U + column_1);
        sums_1[int(2)] = sums_1[int(2)] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        Eight_0 _S28 = FloatWeights_eight_0(weights_2, row_1 + 6U + column_1);
        sums_1[int(3)] = sums_1[int(3)] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
}

float Relu_apply_0(float x_3)
{
    return max(x_3, 0.0f);
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

void dense_part_2(FloatWeights_0 weights_6, uint first_5, bool adds_4, inout float  inputs_6[int(25)], inout float  outputs_4[int(25)])
{
    uint _S40 = first_5 + uint(whole_parts_0(int(4)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S41 = output_2 < int(25);
        if(_S41)
        {
        }
        else
        {
            break;
        }
        uint _S42 = uint(output_2);
        Eight_0 _S43 = FloatWeights_eight_0(weights_6, first_5 + _S42 / 8U);
        float4 _S44 = tile_product_0(weights_6, _S40 + _S42 * 4U, inputs_6);
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
            if(adds_4)
            {
                _S47 = outputs_4[output_2];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_4[output_2] = Relu_apply_0(_S46[int(0)] + _S47);
        }
        int _S48 = output_2 + int(1);
        if(_S48 < int(25))
        {
            if(adds_4)
            {
                _S47 = outputs_4[_S48];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_4[_S48] = Relu_apply_0(_S46[int(1)] + _S47);
        }
        int _S49 = output_2 + int(2);
        if(_S49 < int(25))
        {
            if(adds_4)
            {
                _S47 = outputs_4[_S49];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_4[_S49] = Relu_apply_0(_S46[int(2)] + _S47);
        }
        int _S50 = output_2 + int(3);
        if(_S50 < int(25))
        {
            if(adds_4)
            {
                _S47 = outputs_4[_S50];
            }
            else
            {
                _S47 = 0.0f;
            }
            outputs_4[_S50] = Relu_apply_0(_S46[int(3)] + _S47);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

void dense_part_3(FloatWeights_0 weights_7, uint first_6, bool adds_5, inout float  inputs_7[int(25)], inout float  outputs_5[int(1)])
{
    uint _S51 = first_6 + uint(whole_parts_0(int(1)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S52 = output_3 < int(1);
        if(_S52)
        {
        }
        else
        {
            break;
        }
        uint _S53 = uint(output_3);
        Eight_0 _S54 = FloatWeights_eight_0(weights_7, first_6 + _S53 / 8U);
        float4 _S55 = tile_product_0(weights_7, _S51 + _S53 * 4U, inputs_7);
        float4 _S56;
        if((output_3 & int(4)) != int(0))
        {
            _S56 = _S54.high_0;
        }
        else
        {
            _S56 = _S54.low_0;
        }
        float4 _S57 = _S55 + _S56;
        float _S58;
        if(_S52)
        {
            if(adds_5)
            {
                _S58 = outputs_5[output_3];
            }
            else
            {
                _S58 = 0.0f;
            }
            outputs_5[output_3] = Identity_apply_0(_S57[int(0)] + _S58);
        }
        int _S59 = output_3 + int(1);
        if(_S59 < int(1))
        {
            if(adds_5)
            {
                _S58 = outputs_5[_S59];
            }
            else
            {
                _S58 = 0.0f;
            }
            outputs_5[_S59] = Identity_apply_0(_S57[int(1)] + _S58);
        }
        int _S60 = output_3 + int(2);
        if(_S60 < int(1))
        {
            if(adds_5)
            {
                _S58 = outputs_5[_S60];
            }
            else
            {
                _S58 = 0.0f;
            }
            outputs_5[_S60] = Identity_apply_0(_S57[int(2)] + _S58);
        }
        int _S61 = output_3 + int(3);
        if(_S61 < int(1))
        {
            if(adds_5)
            {
                _S58 = outputs_5[_S61];
            }
            else
            {
                _S58 = 0.0f;
            }
            outputs_5[_S61] = Identity_apply_0(_S57[int(3)] + _S58);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

float4 tile_product_2(FloatWeights_0 weights_8, uint row_2, inout float  inputs_8[int(9)])
{
    float4 sums_2 = (float4)0.0f;
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
        int _S62 = int(8U * column_2);
        low_3[int(0)] = inputs_8[min(_S62, int(8))];
        high_3[int(0)] = inputs_8[min(_S62 + int(4), int(8))];
        int _S63 = _S62 + int(1);
        low_3[int(1)] = inputs_8[min(_S63, int(8))];
        high_3[int(1)] = inputs_8[min(_S63 + int(4), int(8))];
        int _S64 = _S62 + int(2);
        low_3[int(2)] = inputs_8[min(_S64, int(8))];
        high_3[int(2)] = inputs_8[min(_S64 + int(4), int(8))];
        int _S65 = _S62 + int(3);
        low_3[int(3)] = inputs_8[min(_S65, int(8))];
        high_3[int(3)] = inputs_8[min(_S65 + int(4), int(8))];
        Eight_0 _S66 = FloatWeights_eight_0(weights_8, row_2 + column_2);
        sums_2[int(0)] = sums_2[int(0)] + (dot(_S66.low_0, low_3) + dot(_S66.high_0, high_3));
        Eight_0 _S67 = FloatWeights_eight_0(weights_8, row_2 + 2U + column_2);
        sums_2[int(1)] = sums_2[int(1)] + (dot(_S67.low_0, low_3) + dot(_S67.high_0, high_3));
        Eight_0 _S68 = FloatWeights_eight_0(weights_8, row_2 + 4U + column_2);
        sums_2[int(2)] = sums_2[int(2)] + (dot(_S68.low_0, low_3) + dot(_S68.high_0, high_3));
        Eight_0 _S69 = FloatWeights_eight_0(weights_8, row_2 + 6U + column_2);
        sums_2[int(3)] = sums_2[int(3)] + (dot(_S69.low_0, low_3) + dot(_S69.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
}

void dense_part_4(FloatWeights_0 weights_9, uint first_7, bool adds_6, inout float  inputs_9[int(9)], inout float  outputs_6[int(25)])
{
    uint _S70 = first_7 + uint(whole_parts_0(int(4)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S71 = output_4 < int(25);
        if(_S71)
        {
        }
        else
        {
            break;
        }
        uint _S72 = uint(output_4);
        Eight_0 _S73 = FloatWeights_eight_0(weights_9, first_7 + _S72 / 8U);
        float4 _S74 = tile_product_2(weights_9, _S70 + _S72 * 2U, inputs_9);
        float4 _S75;
        if((output_4 & int(4)) != int(0))
        {
            _S75 = _S73.high_0;
        }
        else
        {
            _S75 = _S73.low_0;
        }
        float4 _S76 = _S74 + _S75;
        float _S77;
        if(_S71)
        {
            if(adds_6)
            {
                _S77 = outputs_6[output_4];
            }
            else
            {
                _S77 = 0.0f;
            }
            outputs_6[output_4] = Relu_apply_0(_S76[int(0)] + _S77);
        }
        int _S78 = output_4 + int(1);
        if(_S78 < int(25))
        {
            if(adds_6)
            {
                _S77 = outputs_6[_S78];
            }
            else
            {
                _S77 = 0.0f;
            }
            outputs_6[_S78] = Relu_apply_0(_S76[int(1)] + _S77);
        }
        int _S79 = output_4 + int(2);
        if(_S79 < int(25))
        {
            if(adds_6)
            {
                _S77 = outputs_6[_S79];
            }
            else
            {
                _S77 = 0.0f;
            }
            outputs_6[_S79] = Relu_apply_0(_S76[int(2)] + _S77);
        }
        int _S80 = output_4 + int(3);
        if(_S80 < int(25))
        {
            if(adds_6)
            {
                _S77 = outputs_6[_S80];
            }
            else
            {
                _S77 = 0.0f;
            }
            outputs_6[_S80] = Relu_apply_0(_S76[int(3)] + _S77);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

void dense_2(FloatWeights_0 weights_10, uint first_8, bool adds_7, inout float  inputs_10[int(25)], inout float  outputs_7[int(25)])
{
    dense_part_2(weights_10, first_8, adds_7, inputs_10, outputs_7);
    return;
}

void dense_3(FloatWeights_0 weights_11, uint first_9, bool adds_8, inout float  inputs_11[int(25)], inout float  outputs_8[int(1)])
{
    dense_part_3(weights_11, first_9, adds_8, inputs_11, outputs_8);
    return;
}

void dense_4(FloatWeights_0 weights_12, uint first_10, bool adds_9, inout float  inputs_12[int(9)], inout float  outputs_9[int(25)])
{
    dense_part_4(weights_12, first_10, adds_9, inputs_12, outputs_9);
    return;
}

struct MLP_0
{
    FloatWeights_0 weights_13;
};

int layer_size_0(int inputs_13, int outputs_10)
{
    return whole_parts_0((outputs_10 + int(7)) / int(8)) + whole_parts_0((inputs_13 + int(7)) / int(8) * ((outputs_10 + int(4) - int(1)) / int(4) * int(4)));
}

void MLP_evaluate_0(MLP_0 this_1, inout float  inputs_14[int(11)], inout float  outputs_11[int(3)])
{
    float  odd_0[int(25)];
    float  even_0[int(25)];
    dense_1(this_1.weights_13, 0U, false, inputs_14, even_0);
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
        int _S81 = layer_size_0(int(25), int(25));
        uint _S82 = uint(layer_size_0(int(11), int(25)) + (layer_0 - int(1)) * _S81);
        dense_2(this_1.weights_13, _S82, false, even_0, odd_0);
        if((layer_0 + int(1)) < int(3))
        {
            dense_2(this_1.weights_13, _S82 + uint(_S81), false, odd_0, even_0);
        }
        layer_0 = layer_0 + int(2);
    }
    uint _S83 = uint(layer_size_0(int(11), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_0(this_1.weights_13, _S83, false, even_0, outputs_11);
    return;
}

void MLP_evaluate_1(MLP_0 this_2, inout float  inputs_15[int(9)], inout float  outputs_12[int(1)])
{
    float  odd_1[int(25)];
    float  even_1[int(25)];
    dense_4(this_2.weights_13, 0U, false, inputs_15, even_1);
    int layer_1 = int(1);
    for(;;)
    {
        if(layer_1 < int(3))
        {
        }
        else
        {
            break;
        }
        int _S84 = layer_size_0(int(25), int(25));
        uint _S85 = uint(layer_size_0(int(9), int(25)) + (layer_1 - int(1)) * _S84);
        dense_2(this_2.weights_13, _S85, false, even_1, odd_1);
        if((layer_1 + int(1)) < int(3))
        {
            dense_2(this_2.weights_13, _S85 + uint(_S84), false, odd_1, even_1);
        }
        layer_1 = layer_1 + int(2);
    }
    uint _S86 = uint(layer_size_0(int(9), int(25)) + int(2) * layer_size_0(int(25), int(25)));
    dense_3(this_2.weights_13, _S86, false, even_1, outputs_12);
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

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_0;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(VisiblePoint_0 point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S87 = direction_1.xy;
    float _S88;
    if(back_1)
    {
        _S88 = - direction_1.z;
    }
    else
    {
        _S88 = direction_1.z;
    }
    return float3(_S87, _S88);
}

Eight_0 no_numbers_0()
{
    Eight_0 numbers_1;
    float4 _S89 = (float4)0.0f;
    numbers_1.low_0 = _S89;
    numbers_1.high_0 = _S89;
    return numbers_1;
}

Eight_0 eight_halves_0(uint4 packed_0)
{
    Eight_0 numbers_2;
    uint _S90 = packed_0.x;
    uint _S91 = packed_0.y;
    numbers_2.low_0 = float4(f16tof32(uint2(_S90 & 65535U, _S90 >> 16U)), f16tof32(uint2(_S91 & 65535U, _S91 >> 16U)));
    uint _S92 = packed_0.z;
    uint _S93 = packed_0.w;
    numbers_2.high_0 = float4(f16tof32(uint2(_S92 & 65535U, _S92 >> 16U)), f16tof32(uint2(_S93 & 65535U, _S93 >> 16U)));
    return numbers_2;
}

Eight_0 texel_numbers_0(uint first_11, uint elements_1, uint texel_0)
{
    uint _S94 = first_11 + texel_0 * elements_1;
    uint4 _S95 = packed_numbers_0.Load(_S94);
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S95);
    }
    Eight_0 numbers_3;
    numbers_3.low_0 = asfloat(_S95);
    numbers_3.high_0 = asfloat(packed_numbers_0.Load(_S94 + 1U));
    return numbers_3;
}

void add_bilinear_0(uint first_12, uint elements_2, uint start_0, uint columns_0, uint rows_0, float2 uv_1, float weight_0, inout Eight_0 sums_3)
{
    float2 _S96 = uv_1 * float2(float(columns_0), float(rows_0)) - 0.5f;
    float2 _S97 = floor(_S96);
    float2 _S98 = _S96 - _S97;
    int _S99 = int(_S97.x);
    int _S100 = int(_S97.y);
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
        uint _S101 = tap_0 & 1U;
        uint _S102 = tap_0 >> int(1);
        Eight_0 _S103 = texel_numbers_0(first_12, elements_2, start_0 + (uint(_S100 + int(_S102)) & (rows_0 - 1U)) * columns_0 + (uint(_S99 + int(_S101)) & (columns_0 - 1U)));
        float _S104;
        if(_S102 != 0U)
        {
            _S104 = _S98.y;
        }
        else
        {
            _S104 = 1.0f - _S98.y;
        }
        float _S105;
        if(_S101 != 0U)
        {
            _S105 = _S98.x;
        }
        else
        {
            _S105 = 1.0f - _S98.x;
        }
        float _S106 = _S104 * _S105 * weight_0;
        sums_3.low_0 = sums_3.low_0 + _S106 * _S103.low_0;
        sums_3.high_0 = sums_3.high_0 + _S106 * _S103.high_0;
        tap_0 = tap_0 + 1U;
    }
    return;
}

float channel_0(Eight_0 numbers_4, int k_0)
{
    float _S107;
    if(k_0 < int(4))
    {
        _S107 = numbers_4.low_0[k_0];
    }
    else
    {
        _S107 = numbers_4.high_0[k_0 - int(4)];
    }
    return _S107;
}

float neumip_depth_0(Neumip_0 model_0, float2 uv_2, float2 view_1, uint face_1)
{
    uint _S108 = words_0.Load(model_0.levels_2 + 1U);
    uint _S109 = words_0.Load(model_0.levels_2 + 2U);
    Eight_0 texel_1 = no_numbers_0();
    add_bilinear_0(model_0.offset_texels_0, model_0.texel_elements_0, face_1 * _S108 * _S109, _S108, _S109, frac(uv_2), 1.0f, texel_1);
    float  inputs_16[int(9)];
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
        inputs_16[k_1] = channel_0(texel_1, k_1);
        k_1 = k_1 + int(1);
    }
    inputs_16[int(7)] = view_1.x;
    inputs_16[int(8)] = view_1.y;
    MLP_0 network_1;
    network_1.weights_13.first_0 = model_0.offset_0;
    float  depth_0[int(1)];
    MLP_evaluate_1(network_1, inputs_16, depth_0);
    return depth_0[int(0)];
}

float natural_logarithm_0(float x_4)
{
    uint _S110 = asuint(x_4);
    float exponent_0 = float(int(_S110 >> int(23)) - int(126));
    float m_0 = asfloat((_S110 & 8388607U) | 1056964608U);
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
    float _S111 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S111 - exponent_1 * 0.00021219444170129f - 0.5f * _S111) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_5)
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
}

Eight_0 neumip_texel_0(Neumip_0 model_1, float2 uv_3, float level_0, uint face_2)
{
    float _S112 = clamp(level_0, 0.0f, model_1.last_level_1);
    float _S113 = clamp(floor(_S112), 0.0f, max(model_1.last_level_1 - 1.0f, 0.0f));
    float _S114 = _S112 - _S113;
    float2 _S115 = clamp(frac(uv_3), (float2)0.0f, (float2)1.0f);
    Eight_0 texel_2 = no_numbers_0();
    uint offset_1 = 0U;
    for(;;)
    {
        if(offset_1 < 2U)
        {
        }
        else
        {
            break;
        }
        float _S116;
        if(offset_1 == 0U)
        {
            _S116 = 1.0f - _S114;
        }
        else
        {
            _S116 = _S114;
        }
        if(_S116 <= 0.0f)
        {
            offset_1 = offset_1 + 1U;
            continue;
        }
        uint _S117 = model_1.levels_2 + 3U * (uint(_S113) + offset_1);
        add_bilinear_0(model_1.features_0, model_1.texel_elements_0, face_2 * model_1.face_texels_0 + words_0.Load(_S117), words_0.Load(_S117 + 1U), words_0.Load(_S117 + 2U), _S115, _S116, texel_2);
        offset_1 = offset_1 + 1U;
    }
    return texel_2;
}

uint scramble_0(uint value_0)
{
    uint _S118 = value_0 * 747796405U + 2891336453U;
    uint _S119 = ((_S118 >> ((_S118 >> int(28)) + 4U)) ^ _S118) * 277803737U;
    return (_S119 >> int(22)) ^ _S119;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_0, uint stream_1)
{
    uint _S120 = pixel_0.x;
    uint _S121 = pixel_0.y;
    return frac(float2(uniform_hash_0(_S120, _S121, stream_1), uniform_hash_0(_S120, _S121, stream_1 + 1U)) + float(index_0 & 65535U) * float2(0.75487768650054932f, 0.56984031200408936f));
}

float scene_number_0(uint index_1)
{
    return asfloat(scene_words_0.Load(index_1));
}

struct Choice_0
{
    uint index_2;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_0, float number_0)
{
    uint high_4 = count_0;
    uint low_4 = 0U;
    for(;;)
    {
        if((high_4 - low_4) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S122 = (low_4 + high_4) / 2U;
        if((scene_number_0(table_0 + _S122)) <= number_0)
        {
            low_4 = _S122;
        }
        else
        {
            high_4 = _S122;
        }
    }
    uint _S123 = table_0 + low_4;
    float _S124 = scene_number_0(_S123);
    float _S125 = scene_number_0(_S123 + 1U);
    Choice_0 choice_0;
    choice_0.index_2 = low_4;
    choice_0.remainder_0 = saturate((number_0 - _S124) / max(_S125 - _S124, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_6)
{
    float _S126 = floor(x_6 * 0.63661974668502808f + 0.5f);
    float _S127 = x_6 - _S126 * 1.5703125f - _S126 * 0.00048375129699707f - _S126 * 7.54979012640433211e-08f;
    float _S128 = _S127 * _S127;
    float _S129 = ((-0.00019515295571182f * _S128 + 0.00833216123282909f) * _S128 - 0.16666655242443085f) * _S128 * _S127 + _S127;
    float _S130 = ((0.00002443315679557f * _S128 - 0.00138873164542019f) * _S128 + 0.04166664555668831f) * _S128 * _S128 - 0.5f * _S128 + 1.0f;
    uint _S131 = uint(int(_S126)) & 3U;
    float2 _S132;
    if((_S131 & 1U) != 0U)
    {
        _S132 = float2(_S130, _S129);
    }
    else
    {
        _S132 = float2(_S129, _S130);
    }
    float _S133;
    if((_S131 & 2U) != 0U)
    {
        _S133 = - _S132.x;
    }
    else
    {
        _S133 = _S132.x;
    }
    float _S134;
    if(((_S131 + 1U) & 2U) != 0U)
    {
        _S134 = - _S132.y;
    }
    else
    {
        _S134 = _S132.y;
    }
    return float2(_S133, _S134);
}

void accumulate_0(uint index_3, float4 light_0)
{
    float _S135 = layers_0[index_3].share_0;
    radiance_0[index_3] = radiance_0[index_3] + layers_0[index_3].share_0 * light_0;
    layers_0[index_3].share_0 = _S135 * (1.0f - light_0.w);
    return;
}

float3 camera_right_0(int _S136)
{
    return float3(frames_0[_S136].right_x_0, frames_0[_S136].right_y_0, frames_0[_S136].right_z_0);
}

float3 camera_up_0(int _S137)
{
    return float3(frames_0[_S137].up_x_0, frames_0[_S137].up_y_0, frames_0[_S137].up_z_0);
}

float3 camera_forward_0(int _S138)
{
    return float3(frames_0[_S138].forward_x_0, frames_0[_S138].forward_y_0, frames_0[_S138].forward_z_0);
}

float3 camera_origin_0(int _S139)
{
    return float3(frames_0[_S139].origin_x_0, frames_0[_S139].origin_y_0, frames_0[_S139].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S140, uint _S141, float _S142, float _S143)
{
    uint _S144 = 3U * _S141;
    Vertex_0 _S145 = vertices_0.Load(corners_0.Load(_S144));
    Vertex_0 _S146 = vertices_0.Load(corners_0.Load(_S144 + 1U));
    Vertex_0 _S147 = vertices_0.Load(corners_0.Load(_S144 + 2U));
    float3 _S148 = position_of_0(_S145);
    float3 _S149 = position_of_0(_S146) - _S148;
    float3 _S150 = position_of_0(_S147) - _S148;
    float _S151 = _S146.u_0 - _S145.u_0;
    float _S152 = _S146.v_0 - _S145.v_0;
    float2 _S153 = float2(_S151, _S152);
    float _S154 = _S147.u_0 - _S145.u_0;
    float _S155 = _S147.v_0 - _S145.v_0;
    float2 _S156 = float2(_S154, _S155);
    float _S157;
    if((_S151 * _S155 - _S152 * _S154) < 0.0f)
    {
        _S157 = -1.0f;
    }
    else
    {
        _S157 = 1.0f;
    }
    float3 _S158 = _S157 * (_S155 * _S149 - _S152 * _S150);
    float3 _S159 = _S157 * (_S151 * _S150 - _S154 * _S149);
    VisiblePoint_0 point_1;
    float3 _S160 = normalize((1.0f - _S142 - _S143) * normal_of_0(_S145) + _S142 * normal_of_0(_S146) + _S143 * normal_of_0(_S147));
    point_1.normal_0 = _S160;
    float3 _S161 = normalize(_S158 - _S160 * dot(_S160, _S158));
    point_1.axis_x_0 = _S161;
    point_1.axis_y_0 = cross(_S160, _S161);
    float3 _S162 = normalize(cross(_S149, _S150));
    float3 _S163;
    if((dot(_S162, _S160)) < 0.0f)
    {
        _S163 = - _S162;
    }
    else
    {
        _S163 = _S162;
    }
    point_1.face_normal_0 = _S163;
    point_1.position_0 = _S148 + _S142 * _S149 + _S143 * _S150;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_0 = float2(_S145.u_0, _S145.v_0) + _S142 * _S153 + _S143 * _S156;
    bool _S164 = (dot(cross(_S158, _S159), point_1.normal_0)) < 0.0f;
    float _S165 = fabrics_0[_S140].uv_width_0;
    if(_S164)
    {
        _S157 = - fabrics_0[_S140].uv_height_0;
    }
    else
    {
        _S157 = fabrics_0[_S140].uv_height_0;
    }
    float2 _S166 = float2(_S165, _S157);
    point_1.draft_per_uv_0 = _S166;
    float2 _S167 = point_1.uv_0 * _S166;
    if(_S164)
    {
        _S157 = fabrics_0[_S140].uv_height_0;
    }
    else
    {
        _S157 = 0.0f;
    }
    point_1.draft_0 = _S167 + float2(0.0f, _S157);
    float2 _S168 = (float2)0.0f;
    point_1.draft_dx_0 = _S168;
    point_1.draft_dy_0 = _S168;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S169, uint _S170, uint _S171, uint2 _S172)
{
    uint _S173 = 3U * _S171;
    Vertex_0 _S174 = vertices_0.Load(corners_0.Load(_S173));
    Vertex_0 _S175 = vertices_0.Load(corners_0.Load(_S173 + 1U));
    Vertex_0 _S176 = vertices_0.Load(corners_0.Load(_S173 + 2U));
    float3 _S177 = position_of_0(_S174);
    float3 _S178 = position_of_0(_S175) - _S177;
    float3 _S179 = position_of_0(_S176) - _S177;
    float3 _S180 = cross(_S178, _S179);
    float _S181 = 1.0f / max(square_0(_S180), 1.00000000317107685e-30f);
    float _S182 = float(frames_0[_S169].width_0);
    float3 _S183 = camera_right_0(_S169) * (2.0f / _S182);
    float _S184 = float(frames_0[_S169].height_0);
    float3 _S185 = camera_up_0(_S169) * (-2.0f / _S184);
    float3 _S186 = camera_forward_0(_S169) + (float(_S172.x) + 0.5f - 0.5f * _S182) * _S183 + (float(_S172.y) + 0.5f - 0.5f * _S184) * _S185;
    float _S187 = dot(_S186, _S180);
    float _S188;
    if((abs(_S187)) > 1.00000000317107685e-30f)
    {
        _S188 = _S187;
    }
    else
    {
        _S188 = 1.00000000317107685e-30f;
    }
    float _S189 = 1.0f / _S188;
    float3 _S190 = _S177 - camera_origin_0(_S169);
    float _S191 = dot(_S190, _S180) * _S189;
    float3 _S192 = _S186 * _S191 - _S190;
    float3 _S193 = _S191 * (_S183 - _S186 * (dot(_S183, _S180) * _S189));
    float3 _S194 = _S191 * (_S185 - _S186 * (dot(_S185, _S180) * _S189));
    float3 _S195 = cross(_S179, _S180) * _S181;
    float3 _S196 = cross(_S180, _S178) * _S181;
    float2 _S197 = float2(_S175.u_0 - _S174.u_0, _S175.v_0 - _S174.v_0);
    float2 _S198 = float2(_S176.u_0 - _S174.u_0, _S176.v_0 - _S174.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S170, _S171, dot(_S192, _S195), dot(_S192, _S196));
    point_2.position_0 = _S177 + _S192;
    point_2.view_0 = - normalize(_S186);
    point_2.draft_dx_0 = (dot(_S193, _S195) * _S197 + dot(_S193, _S196) * _S198) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S194, _S195) * _S197 + dot(_S194, _S196) * _S198) * point_2.draft_per_uv_0;
    return point_2;
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

struct NeumipView_0
{
    float  latent_0[int(7)];
    float2 view_2;
    bool back_2;
};

void neumip_view_0(uint _S199, Footprint_0 _S200, float3 _S201, inout NeumipView_0 _S202)
{
    Neumip_0 _S203 = fabrics_0[_S199].neumip_0;
    bool _S204 = (_S201.z) < 0.0f;
    uint _S205;
    if(_S204)
    {
        _S205 = _S203.back_0;
    }
    else
    {
        _S205 = 0U;
    }
    float3 _S206 = to_face_frame_0(_S201, _S204);
    float2 uv_4 = _S200.centre_0 * float2(_S203.repeats_per_x_0, _S203.repeats_per_y_0);
    float2 uv_5;
    if((_S203.has_offset_0) != 0U)
    {
        float2 _S207 = _S206.xy;
        uv_5 = uv_4 + neumip_depth_0(_S203, uv_4, _S207, _S205) / max(_S206.z, 0.60000002384185791f) * _S207 * float2(_S203.unit_x_0, _S203.unit_y_0);
    }
    else
    {
        uv_5 = uv_4;
    }
    Eight_0 _S208 = neumip_texel_0(_S203, uv_5, binary_logarithm_0(max(sqrt(abs(_S200.dx_0.x * _S200.dy_0.y - _S200.dx_0.y * _S200.dy_0.x)) * _S203.texels_per_mm_0, 9.99999971718068537e-10f)), _S205);
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
        _S202.latent_0[k_2] = channel_0(_S208, k_2);
        k_2 = k_2 + int(1);
    }
    _S202.view_2 = _S206.xy;
    _S202.back_2 = _S204;
    return;
}

uint light_sample_count_0(int _S209)
{
    return frames_0[_S209].lights_0 + frames_0[_S209].environment_samples_0;
}

float visibility_at_0(int _S210, uint _S211, uint2 _S212)
{
    if((frames_0[_S210].casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return visibilities_0[(_S211 * frames_0[_S210].height_0 + _S212.y) * frames_0[_S210].width_0 + _S212.x];
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_0;
};

float3 environment_texel_0(int _S213, uint _S214, uint _S215)
{
    uint _S216 = frames_0[_S213].environment_table_0 + frames_0[_S213].environment_rows_0 + 1U + frames_0[_S213].environment_rows_0 * (frames_0[_S213].environment_columns_0 + 1U) + 3U * (_S214 * frames_0[_S213].environment_columns_0 + _S215);
    return float3(scene_number_0(_S216), scene_number_0(_S216 + 1U), scene_number_0(_S216 + 2U));
}

float3 sample_environment_0(int _S217, float2 _S218, out float3 _S219)
{
    uint _S220 = frames_0[_S217].environment_rows_0;
    Choice_0 _S221 = choose_0(frames_0[_S217].environment_table_0, frames_0[_S217].environment_rows_0, _S218.y);
    uint _S222 = frames_0[_S217].environment_columns_0;
    Choice_0 _S223 = choose_0(frames_0[_S217].environment_table_0 + frames_0[_S217].environment_rows_0 + 1U + _S221.index_2 * (frames_0[_S217].environment_columns_0 + 1U), frames_0[_S217].environment_columns_0, _S218.x);
    float3 _S224 = environment_texel_0(_S217, _S221.index_2, _S223.index_2);
    _S219 = _S224 * (frames_0[_S217].environment_total_0 / max(mean_0(_S224), 9.99999968265522539e-21f));
    float _S225 = 3.14159274101257324f / float(_S220);
    float _S226 = lerp(sine_cosine_0(float(_S221.index_2) * _S225).y, sine_cosine_0(float(_S221.index_2 + 1U) * _S225).y, _S221.remainder_0);
    float _S227 = sqrt(max(1.0f - _S226 * _S226, 0.0f));
    float2 _S228 = sine_cosine_0((float(_S223.index_2) + _S223.remainder_0) * (6.28318548202514648f / float(_S222)));
    float _S229 = _S227 * _S228.x;
    float _S230 = - _S227 * _S228.y;
    return float3(frames_0[_S217].environment_cosine_0 * _S229 + frames_0[_S217].environment_sine_0 * _S230, _S226, frames_0[_S217].environment_cosine_0 * _S230 - frames_0[_S217].environment_sine_0 * _S229);
}

LightSample_0 light_sample_0(int _S231, uint _S232, uint2 _S233, float3 _S234)
{
    LightSample_0 sample_0;
    sample_0.distance_0 = 1.00000001504746622e+30f;
    uint _S235 = frames_0[_S231].lights_0;
    if(_S232 >= (frames_0[_S231].lights_0))
    {
        float3 weight_1;
        float3 _S236 = sample_environment_0(_S231, pixel_sequence_0(_S233, frames_0[_S231].pass_number_0 * frames_0[_S231].environment_samples_0 + (_S232 - _S235), 3U), weight_1);
        sample_0.towards_0 = _S236;
        sample_0.irradiance_1 = weight_1 / float(frames_0[_S231].environment_samples_0);
        return sample_0;
    }
    Light_0 _S237 = lights_1.Load(_S232);
    sample_0.irradiance_1 = float3(_S237.red_0, _S237.green_0, _S237.blue_0);
    sample_0.towards_0 = float3(_S237.x_1, _S237.y_1, _S237.z_1);
    if((_S237.is_point_0) != 0U)
    {
        float3 _S238 = sample_0.towards_0 - _S234;
        float _S239 = max(square_0(_S238), 9.999999960041972e-13f);
        sample_0.distance_0 = sqrt(_S239);
        sample_0.irradiance_1 = sample_0.irradiance_1 / _S239;
        sample_0.towards_0 = normalize(_S238);
    }
    return sample_0;
}

float3 neumip_value_0(uint _S240, inout NeumipView_0 _S241, float3 _S242)
{
    float3 _S243 = to_face_frame_0(_S242, _S241.back_2);
    if((_S243.z) <= 0.0f)
    {
        return (float3)0.0f;
    }
    float  inputs_17[int(11)];
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
        inputs_17[k_3] = _S241.latent_0[k_3];
        k_3 = k_3 + int(1);
    }
    inputs_17[int(7)] = _S243.x;
    inputs_17[int(8)] = _S243.y;
    inputs_17[int(9)] = _S241.view_2.x;
    inputs_17[int(10)] = _S241.view_2.y;
    MLP_0 network_2;
    network_2.weights_13.first_0 = fabrics_0[_S240].neumip_0.decoder_0;
    float  outputs_13[int(3)];
    MLP_evaluate_0(network_2, inputs_17, outputs_13);
    return max(float3(outputs_13[int(0)], outputs_13[int(1)], outputs_13[int(2)]), (float3)0.0f) * 0.31830987334251404f;
}

float4 light_of_neumip_0(int _S244, uint _S245, VisiblePoint_0 _S246, uint2 _S247)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = _S246.draft_0;
    footprint_0.dx_0 = _S246.draft_dx_0;
    footprint_0.dy_0 = _S246.draft_dy_0;
    NeumipView_0 seen_0;
    neumip_view_0(_S245, footprint_0, to_local_0(_S246, _S246.view_0), seen_0);
    float3 _S248 = (float3)0.0f;
    uint number_1 = 0U;
    float3 radiance_1 = _S248;
    for(;;)
    {
        if(number_1 < (light_sample_count_0(_S244)))
        {
        }
        else
        {
            break;
        }
        float _S249 = visibility_at_0(_S244, number_1, _S247);
        if(_S249 <= 0.0f)
        {
            number_1 = number_1 + 1U;
            continue;
        }
        LightSample_0 _S250 = light_sample_0(_S244, number_1, _S247, _S246.position_0);
        float3 _S251 = _S249 * _S250.irradiance_1;
        float3 _S252 = neumip_value_0(_S245, seen_0, to_local_0(_S246, _S250.towards_0));
        radiance_1 = radiance_1 + _S251 * _S252;
        number_1 = number_1 + 1U;
    }
    return float4(radiance_1, 1.0f);
}

[numthreads(8, 8, 1)]
void shade_neumip(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S253 = frames_0[int(0)].width_0;
    bool _S254;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S254 = true;
    }
    else
    {
        _S254 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S254)
    {
        return;
    }
    uint _S255 = id_0.y * _S253 + id_0.x;
    uint _S256 = layers_0[_S255].face_0;
    if((layers_0[_S255].face_0) == 0U)
    {
        return;
    }
    uint _S257 = _S256 - 1U;
    uint _S258 = face_fabrics_0.Load(_S257);
    accumulate_0(_S255, light_of_neumip_0(int(0), _S258, visible_point_0(int(0), _S258, _S257, id_0.xy), id_0.xy));
    return;
}

