#version 450
layout(row_major) uniform;
layout(row_major) buffer;
layout(std430, binding = 1, set = 1) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} query_count_0;
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

layout(std430, binding = 0, set = 1) readonly buffer StructuredBuffer_Query_t_0 {
    Query_0 _data[];
} queries_0;
layout(std430, binding = 2, set = 1) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} answers_0;
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

layout(std430, binding = 0) readonly buffer StructuredBuffer_Fabric_t_0 {
    Fabric_0 _data[];
} fabrics_0;
layout(std430, binding = 10) readonly buffer StructuredBuffer_vectorx3Cuintx2C4x3E_t_0 {
    uvec4 _data[];
} packed_numbers_0;
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_1 {
    uint _data[];
} words_0;
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

layout(std430, binding = 1) readonly buffer StructuredBuffer_Family_t_0 {
    Family_0 _data[];
} families_0;
struct FloatWeights_0
{
    uint first_0;
};

struct Eight_0
{
    vec4 low_0;
    vec4 high_0;
};

Eight_0 FloatWeights_eight_0(FloatWeights_0 this_0, uint element_0)
{
    Eight_0 numbers_0;
    uint _S1 = this_0.first_0 + 2U * element_0;
    numbers_0.low_0 = uintBitsToFloat(packed_numbers_0._data[uint(_S1)]);
    numbers_0.high_0 = uintBitsToFloat(packed_numbers_0._data[uint(_S1 + 1U)]);
    return numbers_0;
}

vec4 tile_product_0(FloatWeights_0 weights_0, uint row_0, inout float  inputs_0[96])
{
    vec4 sums_1 = vec4(0.0);
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
        vec4 low_1;
        vec4 high_1;
        int _S2 = int(8U * column_0);
        low_1[0] = inputs_0[_S2];
        high_1[0] = inputs_0[_S2 + 4];
        int _S3 = _S2 + 1;
        low_1[1] = inputs_0[_S3];
        high_1[1] = inputs_0[_S3 + 4];
        int _S4 = _S2 + 2;
        low_1[2] = inputs_0[_S4];
        high_1[2] = inputs_0[_S4 + 4];
        int _S5 = _S2 + 3;
        low_1[3] = inputs_0[_S5];
        high_1[3] = inputs_0[_S5 + 4];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        sums_1[0] = sums_1[0] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_1[1] = sums_1[1] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        sums_1[2] = sums_1[2] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        sums_1[3] = sums_1[3] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
}

int whole_parts_0(int elements_0)
{
    return (elements_0 + 3) / 4 * 4;
}

float Identity_apply_0(float x_0)
{
    return x_0;
}

void dense_part_0(FloatWeights_0 weights_1, uint first_1, bool adds_0, inout float  inputs_1[96], inout float  outputs_0[50])
{
    uint _S10 = first_1 + uint(whole_parts_0(7));
    int output_0 = 0;
    for(;;)
    {
        bool _S11 = output_0 < 50;
        if(_S11)
        {
        }
        else
        {
            break;
        }
        uint _S12 = uint(output_0);
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U);
        vec4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 12U, inputs_1);
        vec4 _S15;
        if((output_0 & 4) != 0)
        {
            _S15 = _S13.high_0;
        }
        else
        {
            _S15 = _S13.low_0;
        }
        vec4 _S16 = _S14 + _S15;
        float _S17;
        if(_S11)
        {
            if(adds_0)
            {
                _S17 = outputs_0[output_0];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[output_0] = Identity_apply_0(_S16[0] + _S17);
        }
        int _S18 = output_0 + 1;
        if(_S18 < 50)
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S18];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[_S18] = Identity_apply_0(_S16[1] + _S17);
        }
        int _S19 = output_0 + 2;
        if(_S19 < 50)
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S19];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[_S19] = Identity_apply_0(_S16[2] + _S17);
        }
        int _S20 = output_0 + 3;
        if(_S20 < 50)
        {
            if(adds_0)
            {
                _S17 = outputs_0[_S20];
            }
            else
            {
                _S17 = 0.0;
            }
            outputs_0[_S20] = Identity_apply_0(_S16[3] + _S17);
        }
        output_0 = output_0 + 4;
    }
    return;
}

struct HalfWeights_0
{
    uint first_2;
};

Eight_0 eight_halves_0(uvec4 packed_0)
{
    Eight_0 numbers_1;
    numbers_1.low_0 = vec4(unpackHalf2x16(packed_0.x), unpackHalf2x16(packed_0.y));
    numbers_1.high_0 = vec4(unpackHalf2x16(packed_0.z), unpackHalf2x16(packed_0.w));
    return numbers_1;
}

Eight_0 HalfWeights_eight_0(HalfWeights_0 this_1, uint element_1)
{
    return eight_halves_0(packed_numbers_0._data[uint(this_1.first_2 + element_1)]);
}

vec4 tile_product_1(HalfWeights_0 weights_2, uint row_1, inout float  inputs_2[96])
{
    vec4 sums_2 = vec4(0.0);
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
        vec4 low_2;
        vec4 high_2;
        int _S21 = int(8U * column_1);
        low_2[0] = inputs_2[_S21];
        high_2[0] = inputs_2[_S21 + 4];
        int _S22 = _S21 + 1;
        low_2[1] = inputs_2[_S22];
        high_2[1] = inputs_2[_S22 + 4];
        int _S23 = _S21 + 2;
        low_2[2] = inputs_2[_S23];
        high_2[2] = inputs_2[_S23 + 4];
        int _S24 = _S21 + 3;
        low_2[3] = inputs_2[_S24];
        high_2[3] = inputs_2[_S24 + 4];
        Eight_0 _S25 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        sums_2[0] = sums_2[0] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        Eight_0 _S26 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1);
        sums_2[1] = sums_2[1] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        Eight_0 _S27 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1);
        sums_2[2] = sums_2[2] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        Eight_0 _S28 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1);
        sums_2[3] = sums_2[3] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
}

void dense_part_1(HalfWeights_0 weights_3, uint first_3, bool adds_1, inout float  inputs_3[96], inout float  outputs_1[52])
{
    uint _S29 = first_3 + uint(whole_parts_0(7));
    int output_1 = 0;
    for(;;)
    {
        bool _S30 = output_1 < 52;
        if(_S30)
        {
        }
        else
        {
            break;
        }
        uint _S31 = uint(output_1);
        Eight_0 _S32 = HalfWeights_eight_0(weights_3, first_3 + _S31 / 8U);
        vec4 _S33 = tile_product_1(weights_3, _S29 + _S31 * 12U, inputs_3);
        vec4 _S34;
        if((output_1 & 4) != 0)
        {
            _S34 = _S32.high_0;
        }
        else
        {
            _S34 = _S32.low_0;
        }
        vec4 _S35 = _S33 + _S34;
        float _S36;
        if(_S30)
        {
            if(adds_1)
            {
                _S36 = outputs_1[output_1];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[output_1] = Identity_apply_0(_S35[0] + _S36);
        }
        int _S37 = output_1 + 1;
        if(_S37 < 52)
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S37];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[_S37] = Identity_apply_0(_S35[1] + _S36);
        }
        int _S38 = output_1 + 2;
        if(_S38 < 52)
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S38];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[_S38] = Identity_apply_0(_S35[2] + _S36);
        }
        int _S39 = output_1 + 3;
        if(_S39 < 52)
        {
            if(adds_1)
            {
                _S36 = outputs_1[_S39];
            }
            else
            {
                _S36 = 0.0;
            }
            outputs_1[_S39] = Identity_apply_0(_S35[3] + _S36);
        }
        output_1 = output_1 + 4;
    }
    return;
}

vec4 tile_product_2(HalfWeights_0 weights_4, uint row_2, inout float  inputs_4[39])
{
    vec4 sums_3 = vec4(0.0);
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
        vec4 low_3;
        vec4 high_3;
        int _S40 = int(8U * column_2);
        low_3[0] = inputs_4[min(_S40, 38)];
        high_3[0] = inputs_4[min(_S40 + 4, 38)];
        int _S41 = _S40 + 1;
        low_3[1] = inputs_4[min(_S41, 38)];
        high_3[1] = inputs_4[min(_S41 + 4, 38)];
        int _S42 = _S40 + 2;
        low_3[2] = inputs_4[min(_S42, 38)];
        high_3[2] = inputs_4[min(_S42 + 4, 38)];
        int _S43 = _S40 + 3;
        low_3[3] = inputs_4[min(_S43, 38)];
        high_3[3] = inputs_4[min(_S43 + 4, 38)];
        Eight_0 _S44 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        sums_3[0] = sums_3[0] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        Eight_0 _S45 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2);
        sums_3[1] = sums_3[1] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        Eight_0 _S46 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2);
        sums_3[2] = sums_3[2] + (dot(_S46.low_0, low_3) + dot(_S46.high_0, high_3));
        Eight_0 _S47 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2);
        sums_3[3] = sums_3[3] + (dot(_S47.low_0, low_3) + dot(_S47.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
}

void dense_part_2(HalfWeights_0 weights_5, uint first_4, bool adds_2, inout float  inputs_5[39], inout float  outputs_2[96])
{
    uint _S48 = first_4 + uint(whole_parts_0(12));
    int output_2 = 0;
    for(;;)
    {
        bool _S49 = output_2 < 96;
        if(_S49)
        {
        }
        else
        {
            break;
        }
        uint _S50 = uint(output_2);
        Eight_0 _S51 = HalfWeights_eight_0(weights_5, first_4 + _S50 / 8U);
        vec4 _S52 = tile_product_2(weights_5, _S48 + _S50 * 5U, inputs_5);
        vec4 _S53;
        if((output_2 & 4) != 0)
        {
            _S53 = _S51.high_0;
        }
        else
        {
            _S53 = _S51.low_0;
        }
        vec4 _S54 = _S52 + _S53;
        float _S55;
        if(_S49)
        {
            if(adds_2)
            {
                _S55 = outputs_2[output_2];
            }
            else
            {
                _S55 = 0.0;
            }
            outputs_2[output_2] = Identity_apply_0(_S54[0] + _S55);
        }
        int _S56 = output_2 + 1;
        if(_S56 < 96)
        {
            if(adds_2)
            {
                _S55 = outputs_2[_S56];
            }
            else
            {
                _S55 = 0.0;
            }
            outputs_2[_S56] = Identity_apply_0(_S54[1] + _S55);
        }
        int _S57 = output_2 + 2;
        if(_S57 < 96)
        {
            if(adds_2)
            {
                _S55 = outputs_2[_S57];
            }
            else
            {
                _S55 = 0.0;
            }
            outputs_2[_S57] = Identity_apply_0(_S54[2] + _S55);
        }
        int _S58 = output_2 + 3;
        if(_S58 < 96)
        {
            if(adds_2)
            {
                _S55 = outputs_2[_S58];
            }
            else
            {
                _S55 = 0.0;
            }
            outputs_2[_S58] = Identity_apply_0(_S54[3] + _S55);
        }
        output_2 = output_2 + 4;
    }
    return;
}

vec4 tile_product_3(HalfWeights_0 weights_6, uint row_3, inout float  inputs_6[100])
{
    vec4 sums_4 = vec4(0.0);
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
        vec4 low_4;
        vec4 high_4;
        int _S59 = int(8U * column_3);
        low_4[0] = inputs_6[min(_S59, 99)];
        high_4[0] = inputs_6[min(_S59 + 4, 99)];
        int _S60 = _S59 + 1;
        low_4[1] = inputs_6[min(_S60, 99)];
        high_4[1] = inputs_6[min(_S60 + 4, 99)];
        int _S61 = _S59 + 2;
        low_4[2] = inputs_6[min(_S61, 99)];
        high_4[2] = inputs_6[min(_S61 + 4, 99)];
        int _S62 = _S59 + 3;
        low_4[3] = inputs_6[min(_S62, 99)];
        high_4[3] = inputs_6[min(_S62 + 4, 99)];
        Eight_0 _S63 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        sums_4[0] = sums_4[0] + (dot(_S63.low_0, low_4) + dot(_S63.high_0, high_4));
        Eight_0 _S64 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3);
        sums_4[1] = sums_4[1] + (dot(_S64.low_0, low_4) + dot(_S64.high_0, high_4));
        Eight_0 _S65 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3);
        sums_4[2] = sums_4[2] + (dot(_S65.low_0, low_4) + dot(_S65.high_0, high_4));
        Eight_0 _S66 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3);
        sums_4[3] = sums_4[3] + (dot(_S66.low_0, low_4) + dot(_S66.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
}

void dense_part_3(HalfWeights_0 weights_7, uint first_5, bool adds_3, inout float  inputs_7[100], inout float  outputs_3[96])
{
    uint _S67 = first_5 + uint(whole_parts_0(12));
    int output_3 = 0;
    for(;;)
    {
        bool _S68 = output_3 < 96;
        if(_S68)
        {
        }
        else
        {
            break;
        }
        uint _S69 = uint(output_3);
        Eight_0 _S70 = HalfWeights_eight_0(weights_7, first_5 + _S69 / 8U);
        vec4 _S71 = tile_product_3(weights_7, _S67 + _S69 * 13U, inputs_7);
        vec4 _S72;
        if((output_3 & 4) != 0)
        {
            _S72 = _S70.high_0;
        }
        else
        {
            _S72 = _S70.low_0;
        }
        vec4 _S73 = _S71 + _S72;
        float _S74;
        if(_S68)
        {
            if(adds_3)
            {
                _S74 = outputs_3[output_3];
            }
            else
            {
                _S74 = 0.0;
            }
            outputs_3[output_3] = Identity_apply_0(_S73[0] + _S74);
        }
        int _S75 = output_3 + 1;
        if(_S75 < 96)
        {
            if(adds_3)
            {
                _S74 = outputs_3[_S75];
            }
            else
            {
                _S74 = 0.0;
            }
            outputs_3[_S75] = Identity_apply_0(_S73[1] + _S74);
        }
        int _S76 = output_3 + 2;
        if(_S76 < 96)
        {
            if(adds_3)
            {
                _S74 = outputs_3[_S76];
            }
            else
            {
                _S74 = 0.0;
            }
            outputs_3[_S76] = Identity_apply_0(_S73[2] + _S74);
        }
        int _S77 = output_3 + 3;
        if(_S77 < 96)
        {
            if(adds_3)
            {
                _S74 = outputs_3[_S77];
            }
            else
            {
                _S74 = 0.0;
            }
            outputs_3[_S77] = Identity_apply_0(_S73[3] + _S74);
        }
        output_3 = output_3 + 4;
    }
    return;
}

vec4 tile_product_4(HalfWeights_0 weights_8, uint row_4, inout float  inputs_8[16])
{
    vec4 sums_5 = vec4(0.0);
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
        vec4 low_5;
        vec4 high_5;
        int _S78 = int(8U * column_4);
        low_5[0] = inputs_8[_S78];
        high_5[0] = inputs_8[_S78 + 4];
        int _S79 = _S78 + 1;
        low_5[1] = inputs_8[_S79];
        high_5[1] = inputs_8[_S79 + 4];
        int _S80 = _S78 + 2;
        low_5[2] = inputs_8[_S80];
        high_5[2] = inputs_8[_S80 + 4];
        int _S81 = _S78 + 3;
        low_5[3] = inputs_8[_S81];
        high_5[3] = inputs_8[_S81 + 4];
        Eight_0 _S82 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        sums_5[0] = sums_5[0] + (dot(_S82.low_0, low_5) + dot(_S82.high_0, high_5));
        Eight_0 _S83 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4);
        sums_5[1] = sums_5[1] + (dot(_S83.low_0, low_5) + dot(_S83.high_0, high_5));
        Eight_0 _S84 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4);
        sums_5[2] = sums_5[2] + (dot(_S84.low_0, low_5) + dot(_S84.high_0, high_5));
        Eight_0 _S85 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4);
        sums_5[3] = sums_5[3] + (dot(_S85.low_0, low_5) + dot(_S85.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_5;
}

void dense_part_4(HalfWeights_0 weights_9, uint first_6, bool adds_4, inout float  inputs_9[16], inout float  outputs_4[1])
{
    uint _S86 = first_6 + uint(whole_parts_0(1));
    int output_4 = 0;
    for(;;)
    {
        bool _S87 = output_4 < 1;
        if(_S87)
        {
        }
        else
        {
            break;
        }
        uint _S88 = uint(output_4);
        Eight_0 _S89 = HalfWeights_eight_0(weights_9, first_6 + _S88 / 8U);
        vec4 _S90 = tile_product_4(weights_9, _S86 + _S88 * 2U, inputs_9);
        vec4 _S91;
        if((output_4 & 4) != 0)
        {
            _S91 = _S89.high_0;
        }
        else
        {
            _S91 = _S89.low_0;
        }
        vec4 _S92 = _S90 + _S91;
        float _S93;
        if(_S87)
        {
            if(adds_4)
            {
                _S93 = outputs_4[output_4];
            }
            else
            {
                _S93 = 0.0;
            }
            outputs_4[output_4] = Identity_apply_0(_S92[0] + _S93);
        }
        int _S94 = output_4 + 1;
        if(_S94 < 1)
        {
            if(adds_4)
            {
                _S93 = outputs_4[_S94];
            }
            else
            {
                _S93 = 0.0;
            }
            outputs_4[_S94] = Identity_apply_0(_S92[1] + _S93);
        }
        int _S95 = output_4 + 2;
        if(_S95 < 1)
        {
            if(adds_4)
            {
                _S93 = outputs_4[_S95];
            }
            else
            {
                _S93 = 0.0;
            }
            outputs_4[_S95] = Identity_apply_0(_S92[2] + _S93);
        }
        int _S96 = output_4 + 3;
        if(_S96 < 1)
        {
            if(adds_4)
            {
                _S93 = outputs_4[_S96];
            }
            else
            {
                _S93 = 0.0;
            }
            outputs_4[_S96] = Identity_apply_0(_S92[3] + _S93);
        }
        output_4 = output_4 + 4;
    }
    return;
}

float LeakyRelu_apply_0(float x_1)
{
    return max(x_1, x_1 * 0.00999999977648258);
}

void dense_part_5(HalfWeights_0 weights_10, uint first_7, bool adds_5, inout float  inputs_10[96], inout float  outputs_5[96])
{
    uint _S97 = first_7 + uint(whole_parts_0(12));
    int output_5 = 0;
    for(;;)
    {
        bool _S98 = output_5 < 96;
        if(_S98)
        {
        }
        else
        {
            break;
        }
        uint _S99 = uint(output_5);
        Eight_0 _S100 = HalfWeights_eight_0(weights_10, first_7 + _S99 / 8U);
        vec4 _S101 = tile_product_1(weights_10, _S97 + _S99 * 12U, inputs_10);
        vec4 _S102;
        if((output_5 & 4) != 0)
        {
            _S102 = _S100.high_0;
        }
        else
        {
            _S102 = _S100.low_0;
        }
        vec4 _S103 = _S101 + _S102;
        float _S104;
        if(_S98)
        {
            if(adds_5)
            {
                _S104 = outputs_5[output_5];
            }
            else
            {
                _S104 = 0.0;
            }
            outputs_5[output_5] = LeakyRelu_apply_0(_S103[0] + _S104);
        }
        int _S105 = output_5 + 1;
        if(_S105 < 96)
        {
            if(adds_5)
            {
                _S104 = outputs_5[_S105];
            }
            else
            {
                _S104 = 0.0;
            }
            outputs_5[_S105] = LeakyRelu_apply_0(_S103[1] + _S104);
        }
        int _S106 = output_5 + 2;
        if(_S106 < 96)
        {
            if(adds_5)
            {
                _S104 = outputs_5[_S106];
            }
            else
            {
                _S104 = 0.0;
            }
            outputs_5[_S106] = LeakyRelu_apply_0(_S103[2] + _S104);
        }
        int _S107 = output_5 + 3;
        if(_S107 < 96)
        {
            if(adds_5)
            {
                _S104 = outputs_5[_S107];
            }
            else
            {
                _S104 = 0.0;
            }
            outputs_5[_S107] = LeakyRelu_apply_0(_S103[3] + _S104);
        }
        output_5 = output_5 + 4;
    }
    return;
}

void dense_part_6(HalfWeights_0 weights_11, uint first_8, bool adds_6, inout float  inputs_11[100], inout float  outputs_6[16])
{
    uint _S108 = first_8 + uint(whole_parts_0(2));
    int output_6 = 0;
    for(;;)
    {
        bool _S109 = output_6 < 16;
        if(_S109)
        {
        }
        else
        {
            break;
        }
        uint _S110 = uint(output_6);
        Eight_0 _S111 = HalfWeights_eight_0(weights_11, first_8 + _S110 / 8U);
        vec4 _S112 = tile_product_3(weights_11, _S108 + _S110 * 13U, inputs_11);
        vec4 _S113;
        if((output_6 & 4) != 0)
        {
            _S113 = _S111.high_0;
        }
        else
        {
            _S113 = _S111.low_0;
        }
        vec4 _S114 = _S112 + _S113;
        float _S115;
        if(_S109)
        {
            if(adds_6)
            {
                _S115 = outputs_6[output_6];
            }
            else
            {
                _S115 = 0.0;
            }
            outputs_6[output_6] = LeakyRelu_apply_0(_S114[0] + _S115);
        }
        int _S116 = output_6 + 1;
        if(_S116 < 16)
        {
            if(adds_6)
            {
                _S115 = outputs_6[_S116];
            }
            else
            {
                _S115 = 0.0;
            }
            outputs_6[_S116] = LeakyRelu_apply_0(_S114[1] + _S115);
        }
        int _S117 = output_6 + 2;
        if(_S117 < 16)
        {
            if(adds_6)
            {
                _S115 = outputs_6[_S117];
            }
            else
            {
                _S115 = 0.0;
            }
            outputs_6[_S117] = LeakyRelu_apply_0(_S114[2] + _S115);
        }
        int _S118 = output_6 + 3;
        if(_S118 < 16)
        {
            if(adds_6)
            {
                _S115 = outputs_6[_S118];
            }
            else
            {
                _S115 = 0.0;
            }
            outputs_6[_S118] = LeakyRelu_apply_0(_S114[3] + _S115);
        }
        output_6 = output_6 + 4;
    }
    return;
}

vec4 tile_product_5(HalfWeights_0 weights_12, uint row_5, inout float  inputs_12[88])
{
    vec4 sums_6 = vec4(0.0);
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
        vec4 low_6;
        vec4 high_6;
        int _S119 = int(8U * column_5);
        low_6[0] = inputs_12[_S119];
        high_6[0] = inputs_12[_S119 + 4];
        int _S120 = _S119 + 1;
        low_6[1] = inputs_12[_S120];
        high_6[1] = inputs_12[_S120 + 4];
        int _S121 = _S119 + 2;
        low_6[2] = inputs_12[_S121];
        high_6[2] = inputs_12[_S121 + 4];
        int _S122 = _S119 + 3;
        low_6[3] = inputs_12[_S122];
        high_6[3] = inputs_12[_S122 + 4];
        Eight_0 _S123 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        sums_6[0] = sums_6[0] + (dot(_S123.low_0, low_6) + dot(_S123.high_0, high_6));
        Eight_0 _S124 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5);
        sums_6[1] = sums_6[1] + (dot(_S124.low_0, low_6) + dot(_S124.high_0, high_6));
        Eight_0 _S125 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5);
        sums_6[2] = sums_6[2] + (dot(_S125.low_0, low_6) + dot(_S125.high_0, high_6));
        Eight_0 _S126 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5);
        sums_6[3] = sums_6[3] + (dot(_S126.low_0, low_6) + dot(_S126.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_6;
}

void dense_part_7(HalfWeights_0 weights_13, uint first_9, bool adds_7, inout float  inputs_13[88], inout float  outputs_7[96])
{
    uint _S127 = first_9 + uint(whole_parts_0(12));
    int output_7 = 0;
    for(;;)
    {
        bool _S128 = output_7 < 96;
        if(_S128)
        {
        }
        else
        {
            break;
        }
        uint _S129 = uint(output_7);
        Eight_0 _S130 = HalfWeights_eight_0(weights_13, first_9 + _S129 / 8U);
        vec4 _S131 = tile_product_5(weights_13, _S127 + _S129 * 11U, inputs_13);
        vec4 _S132;
        if((output_7 & 4) != 0)
        {
            _S132 = _S130.high_0;
        }
        else
        {
            _S132 = _S130.low_0;
        }
        vec4 _S133 = _S131 + _S132;
        float _S134;
        if(_S128)
        {
            if(adds_7)
            {
                _S134 = outputs_7[output_7];
            }
            else
            {
                _S134 = 0.0;
            }
            outputs_7[output_7] = LeakyRelu_apply_0(_S133[0] + _S134);
        }
        int _S135 = output_7 + 1;
        if(_S135 < 96)
        {
            if(adds_7)
            {
                _S134 = outputs_7[_S135];
            }
            else
            {
                _S134 = 0.0;
            }
            outputs_7[_S135] = LeakyRelu_apply_0(_S133[1] + _S134);
        }
        int _S136 = output_7 + 2;
        if(_S136 < 96)
        {
            if(adds_7)
            {
                _S134 = outputs_7[_S136];
            }
            else
            {
                _S134 = 0.0;
            }
            outputs_7[_S136] = LeakyRelu_apply_0(_S133[2] + _S134);
        }
        int _S137 = output_7 + 3;
        if(_S137 < 96)
        {
            if(adds_7)
            {
                _S134 = outputs_7[_S137];
            }
            else
            {
                _S134 = 0.0;
            }
            outputs_7[_S137] = LeakyRelu_apply_0(_S133[3] + _S134);
        }
        output_7 = output_7 + 4;
    }
    return;
}

float saturate_0(float x_2)
{
    return clamp(x_2, 0.0, 1.0);
}

vec3 saturate_1(vec3 x_3)
{
    return clamp(x_3, vec3(0.0), vec3(1.0));
}

void dense_0(FloatWeights_0 weights_14, uint first_10, bool adds_8, inout float  inputs_14[96], inout float  outputs_8[50])
{
    dense_part_0(weights_14, first_10, adds_8, inputs_14, outputs_8);
    return;
}

void dense_1(HalfWeights_0 weights_15, uint first_11, bool adds_9, inout float  inputs_15[96], inout float  outputs_9[52])
{
    dense_part_1(weights_15, first_11, adds_9, inputs_15, outputs_9);
    return;
}

void dense_2(HalfWeights_0 weights_16, uint first_12, bool adds_10, inout float  inputs_16[96], inout float  outputs_10[96])
{
    dense_part_5(weights_16, first_12, adds_10, inputs_16, outputs_10);
    return;
}

void dense_3(HalfWeights_0 weights_17, uint first_13, bool adds_11, inout float  inputs_17[39], inout float  outputs_11[96])
{
    dense_part_2(weights_17, first_13, adds_11, inputs_17, outputs_11);
    return;
}

void dense_4(HalfWeights_0 weights_18, uint first_14, bool adds_12, inout float  inputs_18[100], inout float  outputs_12[96])
{
    dense_part_3(weights_18, first_14, adds_12, inputs_18, outputs_12);
    return;
}

void dense_5(HalfWeights_0 weights_19, uint first_15, bool adds_13, inout float  inputs_19[16], inout float  outputs_13[1])
{
    dense_part_4(weights_19, first_15, adds_13, inputs_19, outputs_13);
    return;
}

void dense_6(HalfWeights_0 weights_20, uint first_16, bool adds_14, inout float  inputs_20[100], inout float  outputs_14[16])
{
    dense_part_6(weights_20, first_16, adds_14, inputs_20, outputs_14);
    return;
}

void dense_part_8(HalfWeights_0 weights_21, uint first_17, bool adds_15, inout float  inputs_21[96], inout float  outputs_15[100])
{
    uint _S138 = first_17 + uint(whole_parts_0(12));
    int output_8 = 0;
    for(;;)
    {
        bool _S139 = output_8 < 96;
        if(_S139)
        {
        }
        else
        {
            break;
        }
        uint _S140 = uint(output_8);
        Eight_0 _S141 = HalfWeights_eight_0(weights_21, first_17 + _S140 / 8U);
        vec4 _S142 = tile_product_1(weights_21, _S138 + _S140 * 12U, inputs_21);
        vec4 _S143;
        if((output_8 & 4) != 0)
        {
            _S143 = _S141.high_0;
        }
        else
        {
            _S143 = _S141.low_0;
        }
        vec4 _S144 = _S142 + _S143;
        float _S145;
        if(_S139)
        {
            if(adds_15)
            {
                _S145 = outputs_15[output_8];
            }
            else
            {
                _S145 = 0.0;
            }
            outputs_15[output_8] = LeakyRelu_apply_0(_S144[0] + _S145);
        }
        int _S146 = output_8 + 1;
        if(_S146 < 96)
        {
            if(adds_15)
            {
                _S145 = outputs_15[_S146];
            }
            else
            {
                _S145 = 0.0;
            }
            outputs_15[_S146] = LeakyRelu_apply_0(_S144[1] + _S145);
        }
        int _S147 = output_8 + 2;
        if(_S147 < 96)
        {
            if(adds_15)
            {
                _S145 = outputs_15[_S147];
            }
            else
            {
                _S145 = 0.0;
            }
            outputs_15[_S147] = LeakyRelu_apply_0(_S144[2] + _S145);
        }
        int _S148 = output_8 + 3;
        if(_S148 < 96)
        {
            if(adds_15)
            {
                _S145 = outputs_15[_S148];
            }
            else
            {
                _S145 = 0.0;
            }
            outputs_15[_S148] = LeakyRelu_apply_0(_S144[3] + _S145);
        }
        output_8 = output_8 + 4;
    }
    return;
}

void dense_7(HalfWeights_0 weights_22, uint first_18, bool adds_16, inout float  inputs_22[88], inout float  outputs_16[96])
{
    dense_part_7(weights_22, first_18, adds_16, inputs_22, outputs_16);
    return;
}

float square_0(float x_4)
{
    return x_4 * x_4;
}

struct Footprint_0
{
    vec2 centre_0;
    vec2 dx_0;
    vec2 dy_0;
};

vec3 row_of_taps_0(Footprint_0 footprint_0)
{
    float _S149 = footprint_0.dx_0.x;
    float _S150 = footprint_0.dy_0.x;
    float _S151 = _S149 * _S149 + _S150 * _S150;
    float _S152 = footprint_0.dx_0.y;
    float _S153 = footprint_0.dy_0.y;
    float _S154 = _S152 * _S152 + _S153 * _S153;
    float _S155 = _S149 * _S152 + _S150 * _S153;
    float _S156 = 0.5 * (_S151 - _S154);
    float _S157 = 0.5 * (_S151 + _S154);
    float _S158 = sqrt(_S156 * _S156 + _S155 * _S155);
    float _S159 = _S157 + _S158;
    float _S160 = max(_S159 - 1.5 * max(_S157 - _S158, 0.0), 0.0);
    float _S161 = square_0(4.0);
    float _S162 = max(_S157 - 0.5 * _S160, _S159 / _S161);
    float _S163 = sqrt(max(min(_S160, _S159 - _S162), 0.0) / (_S161 - 1.0));
    float _S164 = _S156 / max(_S158, 1.00000000317107685e-30);
    float _S165 = sqrt(max(0.5 * (1.0 - _S164), 0.0));
    float _S166 = sqrt(_S162);
    float _S167 = _S163 * sqrt(max(0.5 * (1.0 + _S164), 0.0));
    float _S168;
    if(_S155 < 0.0)
    {
        _S168 = - _S163 * _S165;
    }
    else
    {
        _S168 = _S163 * _S165;
    }
    return vec3(_S166, _S167, _S168);
}

struct AnisotropicTaps_0
{
    vec2 centre_1;
    float side_0;
    vec2 first_19;
    vec2 second_0;
};

float AnisotropicTaps_size_0(AnisotropicTaps_0 this_2)
{
    float _S169 = this_2.first_19.x;
    float _S170 = this_2.second_0.x;
    float _S171 = this_2.side_0;
    float _S172 = _S171 * _S171;
    float _S173 = this_2.first_19.y;
    float _S174 = this_2.second_0.y;
    float _S175 = 12.0 * (_S169 * _S173 + _S170 * _S174);
    return sqrt(sqrt(max((12.0 * (_S169 * _S169 + _S170 * _S170) + _S172) * (12.0 * (_S173 * _S173 + _S174 * _S174) + _S172) - _S175 * _S175, square_0(_S172))));
}

float natural_logarithm_0(float x_5)
{
    uint _S176 = floatBitsToUint(x_5);
    float exponent_0 = float(int(_S176 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S176 & 8388607U) | 1056964608U);
    float m_1;
    float exponent_1;
    if(m_0 < 0.70710676908493042)
    {
        float exponent_2 = exponent_0 - 1.0;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    float m_2 = m_1 - 1.0;
    float _S177 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S177 - exponent_1 * 0.00021219444170129 - 0.5 * _S177) + exponent_1 * 0.693359375;
}

vec3 footprint_coordinates_0(AnisotropicTaps_0 taps_0)
{
    return vec3(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07) / 0.015625) * 0.11708354949951172, 0.0, 1.0));
}

vec3 to_face_frame_0(vec3 direction_0, bool back_2)
{
    vec2 _S178 = direction_0.xy;
    float _S179;
    if(back_2)
    {
        _S179 = - direction_0.z;
    }
    else
    {
        _S179 = direction_0.z;
    }
    return vec3(_S178, _S179);
}

float table_number_0(uint index_0)
{
    return uintBitsToFloat(words_0._data[uint(index_0)]);
}

float wrapped_0(float index_1, float count_1)
{
    float _S180;
    if(index_1 < 0.0)
    {
        _S180 = index_1 + count_1;
    }
    else
    {
        if(index_1 >= count_1)
        {
            _S180 = index_1 - count_1;
        }
        else
        {
            _S180 = index_1;
        }
    }
    return _S180;
}

float binary_logarithm_0(float x_6)
{
    return natural_logarithm_0(x_6) * 1.4426950216293335;
}

bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 this_3)
{
    vec2 _S181 = this_3.first_19;
    vec2 _S182 = this_3.second_0;
    return (max(dot(_S181, _S181), dot(_S182, _S182))) > 0.0;
}

vec2 AnisotropicTaps_place_0(AnisotropicTaps_0 this_4, uint number_0)
{
    float _S183;
    if(number_0 >= 2U)
    {
        _S183 = 1.0;
    }
    else
    {
        _S183 = -1.0;
    }
    float _S184;
    if((number_0 & 1U) != 0U)
    {
        _S184 = 1.0;
    }
    else
    {
        _S184 = -1.0;
    }
    return this_4.centre_1 + _S183 * this_4.first_19 + _S184 * this_4.second_0;
}

float bump_0(float distance_0)
{
    float _S185 = max(1.0 - distance_0 * distance_0, 0.0);
    return _S185 * _S185;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239) * 6.16096401214599609, 0.0, 1.0);
}

float exponential_0(float x_7)
{
    float _S186 = clamp(x_7, -87.0, 88.0);
    float _S187 = floor(_S186 * 1.4426950216293335 + 0.5);
    float _S188 = _S186 - _S187 * 0.693359375 + _S187 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S188 + 0.00139819993637502) * _S188 + 0.00833345204591751) * _S188 + 0.04166579619050026) * _S188 + 0.1666666567325592) * _S188 + 0.5;
    float _S189 = uintBitsToFloat(uint(int(_S187) + 127) << 23);
    float _S190;
    if(x_7 < -87.0)
    {
        _S190 = 0.0;
    }
    else
    {
        _S190 = (p_0 * _S188 * _S188 + _S188 + 1.0) * _S189;
    }
    return _S190;
}

float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp(output_9, 0.0, 8.0)) - 1.0) * scale_0;
}

float square_1(vec3 v_0)
{
    return dot(v_0, v_0);
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S191 = bundle_0 / 3U;
    uint _S192 = bundle_0 % 3U;
    uint _S193;
    if(bundle_0 == 24U)
    {
        _S193 = bundle_0;
    }
    else
    {
        _S193 = _S191 * 3U + 3U - 1U - _S192;
    }
    return _S193;
}

float light_visibility_of_0(float diffuse_0, vec3 light_1, vec3 view_1, float blend_0)
{
    float _S194 = max(abs(light_1.z), 0.00100000004749745);
    vec2 _S195 = light_1.xy;
    return 3.14159274101257324 * max(diffuse_0, 0.0) / mix(_S194, (0.59700000286102295 * _S194 + 0.16599999368190765) * (0.21600000560283661 * (dot(_S195, view_1.xy) * (inversesqrt((max(dot(_S195, _S195), 9.99999997475242708e-07))))) + 1.0), blend_0);
}

vec2 turns_and_remainder_0(uint family_0, float index_2)
{
    float _S196 = floor(fma(index_2, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S196, fma(- _S196, families_0._data[uint(family_0)].count_0, index_2));
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
    float _S197 = floor(position_0 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S198 = fma(- _S197, families_0._data[uint(family_1)].size_0, position_0);
    cell_0.below_0 = _S198;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S198;
    cell_0.across_0 = _S198 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S197).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float turns_0 = (position_1 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S199 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S200;
    if(_S199 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S200 = 1U;
    }
    else
    {
        _S200 = 0U;
    }
    uint _S201 = min(thread_1 + _S200, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S202 = families_0._data[uint(family_2)].place_table_0 + _S201 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S201;
    cell_1.below_0 = _S199 - table_number_0(_S202);
    cell_1.above_0 = table_number_0(_S202 + 1U) - _S199;
    cell_1.across_0 = _S199 - table_number_0(_S202 + 2U);
    cell_1.half_width_1 = table_number_0(_S202 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2)
{
    if((families_0._data[uint(family_3)].is_alike_0) != 0U)
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
    Cell_0 _S203 = locate_0(family_4, position_3);
    float _S204 = table_number_0(families_0._data[uint(family_4)].before_0 + 2U * _S203.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_2 = _S203.thread_0;
    bound_0.turns_2 = round((position_3 - families_0._data[uint(family_4)].start_0 - _S204 - _S203.below_0) * families_0._data[uint(family_4)].inverse_period_0);
    bound_0.cell_2 = _S203.below_0;
    float _S205 = 2.0 * _S203.half_width_1;
    bound_0.width_1 = _S205;
    bound_0.visible_0 = clamp((_S203.across_0 + _S203.half_width_1) / _S205, 0.0, 1.0);
    bound_0.gap_0 = min(_S203.below_0, _S203.below_0 - _S203.across_0 - _S203.half_width_1) + max(_S203.across_0 - _S203.half_width_1, 0.0);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S206 = centre_2 - floor((centre_2 - families_0._data[uint(family_5)].start_0) * families_0._data[uint(family_5)].inverse_period_0) * families_0._data[uint(family_5)].period_0;
    float _S207 = 0.5 * max(size_1, families_0._data[uint(family_5)].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S206 - _S207);
    stretch_0.high_7 = bound_at_0(family_5, _S206 + _S207);
    return stretch_0;
}

vec3 table_colour_0(uint index_3)
{
    return vec3(table_number_0(index_3), table_number_0(index_3 + 1U), table_number_0(index_3 + 2U));
}

struct Albedos_0
{
    vec3 diffuse_reflect_0;
    vec3 diffuse_transmit_0;
    vec3 specular_reflect_0;
    vec3 specular_transmit_0;
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

vec3 lengths_0(uint family_6, Stretch_0 stretch_1)
{
    float _S208 = Stretch_turns_0(stretch_1);
    uint _S209 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.low_7.thread_2;
    uint _S210 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.high_7.thread_2;
    float _S211 = table_number_0(_S210) - table_number_0(_S209);
    float _S212 = table_number_0(_S210 + 1U) - table_number_0(_S209 + 1U);
    return vec3(_S211 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_1 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_1 + _S208 * families_0._data[uint(family_6)].visible_total_0, _S212 - _S211 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S208 * (families_0._data[uint(family_6)].period_0 - families_0._data[uint(family_6)].visible_total_0), _S212 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S208 * families_0._data[uint(family_6)].period_0);
}

vec2 integrals_along_0(uint family_7, Stretch_0 stretch_2, uint quantity_0)
{
    uint _S213 = 3U * families_0._data[uint(family_7)].quantities_0;
    uint _S214 = families_0._data[uint(family_7)].colour_threads_0 + _S213 * stretch_2.low_7.thread_2 + quantity_0;
    uint _S215 = families_0._data[uint(family_7)].colour_threads_0 + _S213 * stretch_2.high_7.thread_2 + quantity_0;
    uint _S216 = families_0._data[uint(family_7)].colour_threads_0 + _S213 * uint(families_0._data[uint(family_7)].count_0) + quantity_0;
    float _S217 = table_number_0(_S214);
    float _S218 = table_number_0(_S215);
    float _S219 = Stretch_turns_0(stretch_2);
    uint _S220 = 2U * families_0._data[uint(family_7)].quantities_0;
    return vec2(table_number_0(_S215 + families_0._data[uint(family_7)].quantities_0) - table_number_0(_S214 + families_0._data[uint(family_7)].quantities_0) + _S218 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_1 - _S217 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_1 + _S219 * table_number_0(_S216 + families_0._data[uint(family_7)].quantities_0), table_number_0(_S215 + _S220) - table_number_0(_S214 + _S220) + _S218 * stretch_2.high_7.cell_2 - _S217 * stretch_2.low_7.cell_2 + _S219 * table_number_0(_S216 + _S220));
}

bool Stretch_wraps_0(Stretch_0 this_6)
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

uvec4 Stretch_differences_0(Stretch_0 this_7, uvec4 entries_0, uint whole_0)
{
    uint _S221 = entries_0.z;
    uint _S222 = entries_0.x;
    uint _S223 = _S221 - _S222;
    uint _S224;
    if(Stretch_wraps_0(this_7))
    {
        _S224 = whole_0;
    }
    else
    {
        _S224 = 0U;
    }
    return uvec4(_S223 + _S224, entries_0.w - _S221, entries_0.y - _S222, whole_0);
}

uvec4 row_differences_0(Stretch_0 across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S225 = row_7 + across_1.low_7.thread_2 * quantities_1;
    uint _S226 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, uvec4(words_0._data[uint(_S225)], words_0._data[uint(_S225 + quantities_1)], words_0._data[uint(_S226)], words_0._data[uint(_S226 + quantities_1)]), words_0._data[uint(row_7 + count_2 * quantities_1)]);
}

vec4 Stretch_weights_0(Stretch_0 this_8)
{
    float _S227 = - this_8.low_7.visible_0;
    float _S228 = Stretch_turns_0(this_8);
    float _S229;
    if(Stretch_wraps_0(this_8))
    {
        _S229 = 1.0;
    }
    else
    {
        _S229 = 0.0;
    }
    return vec4(1.0, this_8.high_7.visible_0, _S227, _S228 - _S229);
}

float integral_on_top_0(uint family_8, Stretch_0 across_2, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S230 = uint(families_0._data[uint(family_8)].count_0);
    uint _S231 = (_S230 + 1U) * families_0._data[uint(family_8)].quantities_0;
    uint _S232 = families_0._data[uint(family_8)].colour_areas_0 + quantity_1;
    uvec4 _S233 = row_differences_0(across_2, _S232 + along_0.low_7.thread_2 * _S231, _S230, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S234 = row_differences_0(across_2, _S232 + (along_0.low_7.thread_2 + 1U) * _S231, _S230, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S235 = row_differences_0(across_2, _S232 + along_0.high_7.thread_2 * _S231, _S230, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S236 = row_differences_0(across_2, _S232 + (along_0.high_7.thread_2 + 1U) * _S231, _S230, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S237 = row_differences_0(across_2, _S232 + crossing_count_0 * _S231, _S230, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S238 = _S235 - _S233;
    uvec4 _S239;
    if(Stretch_wraps_0(along_0))
    {
        _S239 = _S237;
    }
    else
    {
        _S239 = uvec4(ivec4(0));
    }
    vec4 _S240 = Stretch_weights_0(across_2);
    return dot(vec4(dot(vec4(ivec4(_S238 + _S239)), _S240), dot(vec4(ivec4(_S236 - _S235)), _S240), dot(vec4(ivec4(_S234 - _S233)), _S240), dot(vec4(ivec4(_S237)), _S240)), Stretch_weights_0(along_0)) * families_0._data[uint(family_8)].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S241 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_0 * _S241.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_0 * _S241.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_0 * _S241.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_0 * _S241.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 own_0, Stretch_0 other_0, bool back_3)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0._data[uint(family_9)].colour_mean_0);
    if((families_0._data[uint(family_9)].quantities_0) == 1U)
    {
        return albedos_2;
    }
    vec3 _S242 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0._data[uint(family_9)].quantities_0))
        {
        }
        else
        {
            break;
        }
        vec2 _S243 = integrals_along_0(family_9, own_0, quantity_2);
        float _S244 = integral_on_top_0(family_9, own_0, other_0, uint(families_0._data[uint(crossing_0)].count_0), quantity_2);
        float _S245 = _S243.x;
        float _S246 = _S245 * _S242.x;
        float _S247;
        if(back_3)
        {
            _S247 = _S246 - _S244;
        }
        else
        {
            _S247 = _S244;
        }
        bool _S248 = quantity_2 == 0U;
        if(_S248)
        {
            is_exposed_0 = _S247 > (16.0 * families_0._data[uint(family_9)].area_unit_0 * min(_S246 / families_0._data[uint(family_9)].crossing_area_0, 1.0) + 0.00000999999974738 * _S246);
        }
        float _S249 = _S245 * _S242.y;
        float _S250;
        if(is_exposed_0)
        {
            _S250 = _S247;
        }
        else
        {
            _S250 = 0.0;
        }
        float _S251 = _S249 + _S250 + 0.000244140625 * _S242.z * _S243.y;
        if(_S248)
        {
            weight_1 = 1.0 / max(_S251, 9.99999968265522539e-21);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S251 * weight_1, families_0._data[uint(family_9)].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate_1(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate_1(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate_1(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate_1(albedos_2.specular_transmit_0);
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
    nothing_0.by_warp_0 = 0.0;
    nothing_0.by_weft_0 = 0.0;
    nothing_0.far_0 = 0.0;
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
    nothing_1.weight_2 = 0.0;
    Blocked_0 _S252 = no_blocked_0();
    nothing_1.warp_1 = _S252;
    nothing_1.weft_1 = _S252;
    return nothing_1;
}

Albedos_0 tinted_0(Albedos_0 albedos_3, vec3 tint_0)
{
    Albedos_0 result_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
    vec3 warp_2;
    vec3 weft_2;
    vec3 mean_0;
    vec3 leaked_0;
};

struct FaceSends_0
{
    vec3 sky_warp_0;
    vec3 sky_weft_0;
    vec3 crossing_warp_0;
    vec3 crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

FaceRadiance_0 face_radiance_0(FaceSends_0 sends_0, float open_of_other_0, vec3 passed_0, vec3 from_other_0)
{
    vec3 _S253 = (1.0 - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    vec3 _S254 = sends_0.sky_warp_0 + _S253 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S254;
    vec3 _S255 = sends_0.sky_weft_0 + _S253 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S255;
    found_0.mean_0 = sends_0.blocks_warp_0 * _S254 + sends_0.blocks_weft_0 * _S255;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(vec3 view_2, out float  terms_0[6])
{
    float _S256 = 1.0 - view_2.z;
    float _S257 = _S256 * _S256;
    terms_0[0] = 1.0;
    float _S258 = view_2.x;
    float _S259 = _S258 * _S258;
    float _S260 = view_2.y;
    float _S261 = _S260 * _S260;
    terms_0[1] = sqrt(max(_S259 + _S261, 9.999999960041972e-13));
    terms_0[2] = _S257;
    terms_0[3] = _S257 * _S257;
    terms_0[4] = _S259 - _S261;
    terms_0[5] = 0.0;
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
    vec3 reflected_0;
    vec3 transmitted_0;
};

struct Scattered_0
{
    vec3 back_4;
    vec3 through_0;
};

struct Interior_0
{
    vec3 warp_3;
    vec3 weft_3;
    vec3 leaked_1;
    vec3 far_1;
    vec3 far_leaked_0;
};

Bounced_0 bounced_by_0(Blocked_0 blocked_1, Scattered_0 yarn_0, Interior_0 interior_0)
{
    vec3 _S262 = (blocked_1.by_warp_0 + blocked_1.by_weft_0) * interior_0.leaked_1;
    vec3 _S263 = blocked_1.far_0 * yarn_0.through_0;
    Bounced_0 bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (blocked_1.by_warp_0 * interior_0.warp_3 + blocked_1.by_weft_0 * interior_0.weft_3) + _S263 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S263 * interior_0.far_1 + yarn_0.back_4 * _S262;
    return bounced_0;
}

Bounced_0 sum_of_0(Bounced_0 first_20, Bounced_0 second_1)
{
    Bounced_0 sum_1;
    sum_1.reflected_0 = first_20.reflected_0 + second_1.reflected_0;
    sum_1.transmitted_0 = first_20.transmitted_0 + second_1.transmitted_0;
    return sum_1;
}

vec3 bounced_value_0(Bounced_0 bounced_1, vec3 light_2, vec3 view_3)
{
    float _S264 = light_2.z;
    vec3 _S265;
    if((_S264 * view_3.z) < 0.0)
    {
        _S265 = bounced_1.transmitted_0;
    }
    else
    {
        _S265 = bounced_1.reflected_0;
    }
    return _S265 * (abs(_S264) * 0.31830987334251404);
}

float sheen_scale_0(float x_8, float y_0)
{
    return (((((0.0 * x_8 + (((((-1.1402510404586792 * y_0 + 0.40672621130943298) * y_0 + 1.65398800373077393) * y_0 + -1.29730904102325439) * y_0 + 0.30570998787879944) * y_0 + -0.0220868494361639)) * x_8 + (((((-0.21142719686031342 * y_0 + 1.05947399139404297) * y_0 + -0.41116121411323547) * y_0 + -0.93859231472015381) * y_0 + 0.51606941223144531) * y_0 + 0.05409301072359085)) * x_8 + (((((1.22944498062133789 * y_0 + -0.45962560176849365) * y_0 + -1.63861405849456787) * y_0 + 1.33565104007720947) * y_0 + -0.45725581049919128) * y_0 + 0.08243165910243988)) * x_8 + (((((0.39779931306838989 * y_0 + -1.18879103660583496) * y_0 + 0.28251591324806213) * y_0 + 1.168984055519104) * y_0 + -0.76864629983901978) * y_0 + 0.0091691892594099)) * x_8 + (((((-0.26563560962677002 * y_0 + -0.19379159808158875) * y_0 + 0.2677634060382843) * y_0 + 0.00270519289188087) * y_0 + 0.14349560439586639) * y_0 + 0.10290180146694183)) * x_8 + (((((-0.20701569318771362 * y_0 + 0.24526430666446686) * y_0 + 0.19551840424537659) * y_0 + 0.07586126774549484) * y_0 + 0.38894739747047424) * y_0 + 0.15043120086193085);
}

float sheen_shear_0(float x_9, float y_1)
{
    return ((((0.0 * x_9 + (((((-0.10608240216970444 * y_1 + 1.99214303493499756) * y_1 + -1.42255294322967529) * y_1 + -1.09495604038238525) * y_1 + 0.59180057048797607) * y_1 + 0.06902855634689331)) * x_9 + (((((-0.46220690011978149 * y_1 + -0.29113379120826721) * y_1 + 1.39025199413299561) * y_1 + 0.35589990019798279) * y_1 + -1.17120099067687988) * y_1 + 0.15940259397029877)) * x_9 + (((((2.26068711280822754 * y_1 + -3.64728999137878418) * y_1 + -0.72173482179641724) * y_1 + 3.07659196853637695) * y_1 + -0.6827620267868042) * y_1 + -0.3039557933807373)) * x_9 + (((((0.81201767921447754 * y_1 + 0.36014080047607422) * y_1 + -1.72646903991699219) * y_1 + -0.22630110383033752) * y_1 + 0.89514690637588501) * y_1 + -0.10397960245609283)) * x_9 + (((((-0.37648698687553406 * y_1 + 1.10974001884460449) * y_1 + 0.17824520170688629) * y_1 + -1.04968702793121338) * y_1 + 0.1461234986782074) * y_1 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_10, float y_2)
{
    return ((((0.0 * x_10 + (((((12.95646953582763672 * y_2 + -21.38032913208007812) * y_2 + -7.37853097915649414) * y_2 + 34.55607986450195312) * y_2 + -23.61347007751464844) * y_2 + 5.00126314163208008)) * x_10 + (((((10.91487026214599609 * y_2 + -6.08202791213989258) * y_2 + -38.2036285400390625) * y_2 + 53.3440399169921875) * y_2 + -21.91996002197265625) * y_2 + 2.01606011390686035)) * x_10 + (((((-14.52206039428710938 * y_2 + 36.803619384765625) * y_2 + -22.94047927856445312) * y_2 + -10.07973003387451172) * y_2 + 15.77003955841064453) * y_2 + -4.92722177505493164)) * x_10 + (((((-7.62505722045898438 * y_2 + 1.27310299873352051) * y_2 + 31.19523048400878906) * y_2 + -44.39989852905273438) * y_2 + 26.44947052001953125) * y_2 + -8.73507976531982422)) * x_10 + (((((5.65633487701416016 * y_2 + -17.66820907592773438) * y_2 + 24.65356063842773438) * y_2 + -19.38941001892089844) * y_2 + 11.06159019470214844) * y_2 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S266 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S267 = 2.0 * sqrt(_S266) - 1.0;
    float _S268 = 3.0 * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S267, _S268), 0.00999999977648258, 1.0), clamp((1.0 - _S266) * sheen_shear_0(_S267, _S268), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S267, _S268), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_3, vec3 view_4, float scale_1, float shear_0)
{
    float _S269 = light_3.z;
    bool _S270;
    if(_S269 <= 0.0)
    {
        _S270 = true;
    }
    else
    {
        _S270 = (view_4.z) <= 0.0;
    }
    if(_S270)
    {
        return 0.0;
    }
    vec2 _S271 = view_4.xy;
    float _S272 = dot(_S271, _S271);
    vec2 _S273;
    if(_S272 > 9.99999968265522539e-21)
    {
        _S273 = _S271 * (inversesqrt((_S272)));
    }
    else
    {
        _S273 = vec2(1.0, 0.0);
    }
    float _S274 = scale_1 * dot(light_3.xy, _S273) + shear_0 * _S269;
    float _S275 = scale_1 * (light_3.y * _S273.x - light_3.x * _S273.y);
    float _S276 = _S274 * _S274 + _S275 * _S275 + _S269 * _S269;
    return 0.31830987334251404 * scale_1 * scale_1 * _S269 / max(_S276 * _S276, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_4, vec3 view_5, float strength_0, float roughness_2)
{
    vec3 _S277 = sheen_lobe_0(view_5.z, roughness_2);
    float _S278 = strength_0 * _S277.z;
    return vec2(_S278 * transformed_cosine_0(light_4, view_5, _S277.x, _S277.y), 1.0 - _S278);
}

struct NeuralView_0
{
    float  sums_7[96];
    float hole_0;
    float correction_weight_0;
    vec3 view_6;
    bool back_5;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S279, Footprint_0 _S280)
{
    vec3 _S281 = row_of_taps_0(_S280);
    vec2 _S282 = _S280.dx_0;
    vec2 _S283 = _S280.dy_0;
    float _S284 = dot(_S282, _S282) + dot(_S283, _S283);
    float _S285 = _S280.dx_0.x * _S280.dy_0.y - _S280.dx_0.y * _S280.dy_0.x;
    float _S286 = 0.5 * (_S284 + sqrt(max(_S284 * _S284 - 4.0 * _S285 * _S285, 0.0)));
    Neural_0 _S287 = fabrics_0._data[uint(_S279)].neural_0;
    bool _S288;
    if(_S286 < (5.5 * (_S284 - _S286)))
    {
        _S288 = _S284 > (8.0 * _S287.pitch_0 * _S287.pitch_0);
    }
    else
    {
        _S288 = false;
    }
    vec2 _S289 = vec2(_S287.ends_per_mm_0, _S287.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    taps_1.centre_1 = _S280.centre_0 * _S289;
    float _S290;
    if(_S288)
    {
        _S290 = sqrt(0.125 * _S284);
    }
    else
    {
        _S290 = _S281.x;
    }
    taps_1.side_0 = _S290 / _S287.pitch_0;
    vec2 _S291;
    if(_S288)
    {
        _S291 = 0.25 * _S280.dx_0;
    }
    else
    {
        _S291 = _S281.yz;
    }
    taps_1.first_19 = _S291 * _S289;
    if(_S288)
    {
        _S291 = 0.25 * _S280.dy_0;
    }
    else
    {
        _S291 = 0.5 * _S281.yz;
    }
    taps_1.second_0 = _S291 * _S289;
    return taps_1;
}

void add_texel_0(uint _S292, uint _S293, float _S294, inout float  _S295[88])
{
    uint _S296 = fabrics_0._data[uint(_S292)].neural_0.latents_0 + _S293 * 8U;
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
        Eight_0 _S297 = eight_halves_0(packed_numbers_0._data[uint(_S296 + part_0)]);
        int _S298 = int(8U * part_0);
        _S295[_S298] = _S295[_S298] + _S294 * _S297.low_0[0];
        _S295[_S298 + 4] = _S295[_S298 + 4] + _S294 * _S297.high_0[0];
        int _S299 = _S298 + 1;
        _S295[_S299] = _S295[_S299] + _S294 * _S297.low_0[1];
        _S295[_S299 + 4] = _S295[_S299 + 4] + _S294 * _S297.high_0[1];
        int _S300 = _S298 + 2;
        _S295[_S300] = _S295[_S300] + _S294 * _S297.low_0[2];
        _S295[_S300 + 4] = _S295[_S300 + 4] + _S294 * _S297.high_0[2];
        int _S301 = _S298 + 3;
        _S295[_S301] = _S295[_S301] + _S294 * _S297.low_0[3];
        _S295[_S301 + 4] = _S295[_S301 + 4] + _S294 * _S297.high_0[3];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S302, uint _S303, bool _S304, vec2 _S305, float _S306, inout float  _S307[88])
{
    Neural_0 _S308 = fabrics_0._data[uint(_S302)].neural_0;
    uint _S309 = fabrics_0._data[uint(_S302)].neural_0.levels_1 + 4U * _S303;
    float _S310 = table_number_0(_S309);
    float _S311 = table_number_0(_S309 + 1U);
    float _S312 = table_number_0(_S309 + 2U);
    bool _S313;
    if(_S303 > 3U)
    {
        _S313 = _S303 < (_S308.top_level_0);
    }
    else
    {
        _S313 = false;
    }
    vec2 _S314 = _S305 * table_number_0(_S309 + 3U);
    float _S315;
    if(_S313)
    {
        _S315 = 1.0;
    }
    else
    {
        _S315 = 0.5;
    }
    vec2 _S316 = _S314 - _S315;
    vec2 _S317 = floor(_S316);
    vec2 _S318 = _S316 - _S317;
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
        float _S319 = float(corner_0 & 1U);
        float _S320 = float(corner_0 >> 1);
        vec2 _S321 = mix(1.0 - _S318, _S318, vec2(_S319, _S320));
        uint _S322 = uint(_S310 + wrapped_0(_S317.y + _S320, _S312) * _S311 + wrapped_0(_S317.x + _S319, _S311));
        uint _S323;
        if(_S304)
        {
            _S323 = _S308.texels_0;
        }
        else
        {
            _S323 = 0U;
        }
        add_texel_0(_S302, _S322 + _S323, _S306 * _S321.x * _S321.y, _S307);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S324, AnisotropicTaps_0 _S325, vec3 _S326, bool _S327, inout float  _S328[88])
{
    float offset_2;
    int k_0 = 0;
    for(;;)
    {
        if(k_0 < 64)
        {
        }
        else
        {
            break;
        }
        _S328[k_0] = 0.0;
        k_0 = k_0 + 1;
    }
    vec2 _S329 = vec2(fabrics_0._data[uint(_S324)].neural_0.ends_0, fabrics_0._data[uint(_S324)].neural_0.picks_0);
    float _S330 = float(fabrics_0._data[uint(_S324)].neural_0.top_level_0);
    float _S331 = clamp(binary_logarithm_0(max(_S325.side_0, 9.99999997475242708e-07)) + 3.0, 0.0, _S330);
    float _S332 = min(floor(_S331), _S330 - 1.0);
    uint _S333;
    if(AnisotropicTaps_has_steps_0(_S325))
    {
        _S333 = 4U;
    }
    else
    {
        _S333 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S333))
        {
        }
        else
        {
            break;
        }
        vec2 _S334 = AnisotropicTaps_place_0(_S325, number_1 >> 1);
        vec2 _S335 = clamp(_S334 - _S329 * floor(_S334 / _S329), vec2(0.0), _S329);
        bool _S336 = (number_1 & 1U) != 0U;
        if(_S336)
        {
            offset_2 = _S331 - _S332;
        }
        else
        {
            offset_2 = 1.0 - (_S331 - _S332);
        }
        float _S337 = offset_2 / float(_S333);
        uint _S338 = uint(_S332);
        uint _S339;
        if(_S336)
        {
            _S339 = 1U;
        }
        else
        {
            _S339 = 0U;
        }
        add_level_0(_S324, _S338 + _S339, _S327, _S335, _S337, _S328);
        number_1 = number_1 + 1U;
    }
    int number_2 = 0;
    for(;;)
    {
        if(number_2 < 3)
        {
        }
        else
        {
            break;
        }
        int bin_0 = 0;
        for(;;)
        {
            if(bin_0 < 8)
            {
            }
            else
            {
                break;
            }
            float offset_3 = _S326[number_2] - (float(bin_0) + 0.5) / 8.0;
            if(number_2 < 2)
            {
                offset_2 = offset_3 - round(offset_3);
            }
            else
            {
                offset_2 = offset_3;
            }
            _S328[64 + number_2 * 8 + bin_0] = bump_0(offset_2 * 3.20000004768371582);
            bin_0 = bin_0 + 1;
        }
        number_2 = number_2 + 1;
    }
    return;
}

vec3 crown_fibres_0(uint _S340, bool _S341, bool _S342)
{
    float _S343;
    if(_S341)
    {
        if(_S342)
        {
            _S343 = - fabrics_0._data[uint(_S340)].neural_0.warp_x_0;
        }
        else
        {
            _S343 = fabrics_0._data[uint(_S340)].neural_0.warp_x_0;
        }
        return vec3(_S343, fabrics_0._data[uint(_S340)].neural_0.warp_y_0, fabrics_0._data[uint(_S340)].neural_0.warp_roughness_0);
    }
    Neural_0 _S344 = fabrics_0._data[uint(_S340)].neural_0;
    if(_S342)
    {
        _S343 = - _S344.weft_y_0;
    }
    else
    {
        _S343 = _S344.weft_y_0;
    }
    return vec3(_S344.weft_x_0, _S343, _S344.weft_roughness_0);
}

void neural_view_0(uint _S345, Footprint_0 _S346, vec3 _S347, inout NeuralView_0 _S348)
{
    bool _S349 = (_S347.z) < 0.0;
    AnisotropicTaps_0 _S350 = anisotropic_taps_0(_S345, _S346);
    vec3 _S351 = footprint_coordinates_0(_S350);
    vec3 _S352 = to_face_frame_0(_S347, _S349);
    HalfWeights_0 weights_23;
    weights_23.first_2 = fabrics_0._data[uint(_S345)].neural_0.network_0;
    float  inputs_23[88];
    code_footprint_0(_S345, _S350, _S351, _S349, inputs_23);
    float  hidden_1[96];
    dense_7(weights_23, 0U, false, inputs_23, hidden_1);
    float  fused_0[100];
    dense_part_8(weights_23, 1068U, false, hidden_1, fused_0);
    fused_0[96] = _S352.x;
    fused_0[97] = _S352.y;
    vec2 _S353 = _S352.xy;
    fused_0[98] = dot(crown_fibres_0(_S345, true, _S349).xy, _S353);
    fused_0[99] = dot(crown_fibres_0(_S345, false, _S349).xy, _S353);
    float  of_hole_0[16];
    dense_6(weights_23, 2232U, false, fused_0, of_hole_0);
    float  hole_1[1];
    dense_5(weights_23, 2444U, false, of_hole_0, hole_1);
    dense_4(weights_23, 2456U, false, fused_0, _S348.sums_7);
    _S348.hole_0 = clamp(hole_1[0], 0.0, 1.0);
    _S348.correction_weight_0 = correction_weight_of_0(_S351.z);
    _S348.view_6 = _S352;
    _S348.back_5 = _S349;
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

void code_light_0(uint _S354, vec3 _S355, vec3 _S356, bool _S357, inout float  _S358[39])
{
    _S358[0] = _S355.x;
    _S358[1] = _S355.y;
    _S358[2] = _S355.z;
    vec3 _S359 = _S355 + _S356;
    float _S360 = _S359.z;
    float _S361 = _S360 * _S360 + 0.00009999999747379;
    vec2 _S362 = _S359.xy;
    float _S363 = 1.0 / (dot(_S362, _S362) + _S361);
    int family_10 = 0;
    for(;;)
    {
        if(family_10 < 2)
        {
        }
        else
        {
            break;
        }
        vec3 _S364 = crown_fibres_0(_S354, family_10 == 0, _S357);
        vec2 _S365 = _S364.xy;
        _S358[3 + family_10] = dot(_S365, _S355.xy);
        float _S366 = dot(_S365, _S362);
        float _S367 = _S366 * _S366;
        float _S368 = (0.75 * _S366 / (0.5 * sqrt(_S367 + _S361) + abs(_S366)) + 0.5) * 8.0;
        int bin_1 = 0;
        for(;;)
        {
            if(bin_1 < 16)
            {
            }
            else
            {
                break;
            }
            _S358[5 + family_10 * 16 + bin_1] = bump_0(_S368 - (float(bin_1) + 0.5) / 2.0);
            bin_1 = bin_1 + 1;
        }
        float _S369 = _S364.z;
        float _S370 = _S369 * _S369;
        float _S371 = _S367 * _S363 * (1.0 - _S370) + _S370;
        _S358[37 + family_10] = 0.25 * natural_logarithm_0(1.0 + 9.54929637908935547 * _S370 * _S369 / (_S371 * _S371));
        family_10 = family_10 + 1;
    }
    return;
}

float mixed_bundles_0(uint _S372, uint _S373, uint _S374, vec3 _S375, vec3 _S376, bool _S377, inout float  _S378[52])
{
    vec3 _S379 = _S375 + _S376;
    float _S380 = 1.0 / (square_1(_S379) + 0.00009999999747379);
    bool _S381;
    if(_S373 == 0U)
    {
        _S381 = _S377;
    }
    else
    {
        _S381 = false;
    }
    float _S382;
    if(_S381)
    {
        _S382 = - _S379.x;
    }
    else
    {
        _S382 = _S379.x;
    }
    if(_S373 == 1U)
    {
        _S381 = _S377;
    }
    else
    {
        _S381 = false;
    }
    float _S383;
    if(_S381)
    {
        _S383 = - _S379.y;
    }
    else
    {
        _S383 = _S379.y;
    }
    uint bundle_1 = 0U;
    float sum_2 = 0.0;
    for(;;)
    {
        if(bundle_1 < 25U)
        {
        }
        else
        {
            break;
        }
        uint _S384 = _S373 * 25U;
        uint _S385 = fabrics_0._data[uint(_S372)].neural_0.bundles_0 + 4U * (_S384 + bundle_1);
        float _S386 = dot(vec3(table_number_0(_S385), table_number_0(_S385 + 1U), table_number_0(_S385 + 2U)), vec3(_S382, _S383, _S379.z));
        float _S387 = _S386 * _S386 * _S380 + table_number_0(_S385 + 3U);
        uint _S388 = _S374 + _S384;
        uint _S389;
        if(_S377)
        {
            _S389 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S389 = bundle_1;
        }
        float sum_3 = sum_2 + max(_S378[_S388 + _S389], _S378[_S388 + _S389] * 0.00999999977648258) / (_S387 * _S387);
        bundle_1 = bundle_1 + 1U;
        sum_2 = sum_3;
    }
    return 0.01999999955296516 * sum_2;
}

Components_0 neural_components_0(uint _S390, inout NeuralView_0 _S391, vec3 _S392)
{
    float _S393;
    bool _S394 = _S391.back_5;
    vec3 _S395 = to_face_frame_0(_S392, _S391.back_5);
    vec3 _S396 = _S391.view_6;
    HalfWeights_0 weights_24;
    Neural_0 _S397 = fabrics_0._data[uint(_S390)].neural_0;
    weights_24.first_2 = fabrics_0._data[uint(_S390)].neural_0.network_0;
    float  directions_0[39];
    code_light_0(_S390, _S395, _S391.view_6, _S391.back_5, directions_0);
    float  skip_0[96];
    int k_1 = 0;
    for(;;)
    {
        if(k_1 < 96)
        {
        }
        else
        {
            break;
        }
        skip_0[k_1] = _S391.sums_7[k_1];
        k_1 = k_1 + 1;
    }
    dense_3(weights_24, 3716U, true, directions_0, skip_0);
    float  hidden_2[96];
    float  next_0[96];
    k_1 = 0;
    for(;;)
    {
        if(k_1 < 96)
        {
        }
        else
        {
            break;
        }
        hidden_2[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
        k_1 = k_1 + 1;
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
        k_1 = 0;
        for(;;)
        {
            if(k_1 < 96)
            {
            }
            else
            {
                break;
            }
            if(layer_0 == 1U)
            {
                _S393 = skip_0[k_1];
            }
            else
            {
                _S393 = 0.0;
            }
            next_0[k_1] = _S393;
            k_1 = k_1 + 1;
        }
        dense_2(weights_24, 4208U + layer_0 * 1164U, true, hidden_2, next_0);
        int k_2 = 0;
        for(;;)
        {
            if(k_2 < 96)
            {
            }
            else
            {
                break;
            }
            hidden_2[k_2] = next_0[k_2];
            k_2 = k_2 + 1;
        }
        layer_0 = layer_0 + 1U;
    }
    float  outputs_17[52];
    dense_1(weights_24, 7700U, false, hidden_2, outputs_17);
    bool _S398;
    if((_S397.is_corrected_0) != 0U)
    {
        _S398 = (_S395.z) > 0.0;
    }
    else
    {
        _S398 = false;
    }
    if(_S398)
    {
        _S398 = (_S391.correction_weight_0) > 0.0;
    }
    else
    {
        _S398 = false;
    }
    if(_S398)
    {
        FloatWeights_0 fitted_0;
        fitted_0.first_0 = _S397.correction_0;
        float  change_0[50];
        dense_0(fitted_0, 0U, false, hidden_2, change_0);
        k_1 = 0;
        for(;;)
        {
            if(k_1 < 50)
            {
            }
            else
            {
                break;
            }
            outputs_17[k_1 + 2] = outputs_17[k_1 + 2] + _S391.correction_weight_0 * change_0[k_1];
            k_1 = k_1 + 1;
        }
    }
    if((_S395.z) > 0.0)
    {
        _S393 = 0.00999999977648258;
    }
    else
    {
        _S393 = 0.00100000004749745;
    }
    Components_0 result_2;
    float _S399 = unmapped_0(outputs_17[0], _S393);
    result_2.diffuse_warp_0 = _S399;
    float _S400 = unmapped_0(outputs_17[1], _S393);
    result_2.diffuse_weft_0 = _S400;
    float _S401 = 2979.9580078125 * _S393;
    float _S402 = mixed_bundles_0(_S390, 0U, 2U, _S395, _S396, _S394, outputs_17);
    result_2.specular_warp_0 = clamp(_S402, 0.0, _S401);
    float _S403 = mixed_bundles_0(_S390, 1U, 2U, _S395, _S396, _S394, outputs_17);
    result_2.specular_weft_0 = clamp(_S403, 0.0, _S401);
    result_2.hole_2 = _S391.hole_0;
    result_2.light_visibility_1 = min(light_visibility_of_0(_S399 + _S400, _S395, _S396, fabrics_0._data[uint(_S390)].diffuse_blend_0), 1.0 - _S391.hole_0);
    return result_2;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_4;
    Albedos_0 weft_4;
};

FamilyAlbedos_0 albedos_over_0(uint _S404, Footprint_0 _S405, bool _S406)
{
    vec2 _S407 = _S405.dx_0;
    vec2 _S408 = _S405.dy_0;
    vec2 _S409 = sqrt(_S407 * _S407 + _S408 * _S408);
    Stretch_0 _S410 = stretch_of_0(fabrics_0._data[uint(_S404)].warp_0, _S405.centre_0.x, _S409.x);
    Stretch_0 _S411 = stretch_of_0(fabrics_0._data[uint(_S404)].weft_0, _S405.centre_0.y, _S409.y);
    FamilyAlbedos_0 albedos_4;
    albedos_4.warp_4 = mean_albedos_0(fabrics_0._data[uint(_S404)].warp_0, fabrics_0._data[uint(_S404)].weft_0, _S410, _S411, _S406);
    albedos_4.weft_4 = mean_albedos_0(fabrics_0._data[uint(_S404)].weft_0, fabrics_0._data[uint(_S404)].warp_0, _S411, _S410, _S406);
    return albedos_4;
}

float openness_number_0(uint _S412, uint _S413)
{
    return table_number_0(fabrics_0._data[uint(_S412)].openness_0 + _S413);
}

Scattered_0 scattered_by_0(uint _S414, Albedos_0 _S415, uint _S416, vec3 _S417)
{
    uint _S418 = 159U + 2U * _S416;
    Scattered_0 yarn_1;
    yarn_1.back_4 = _S417 * _S415.diffuse_reflect_0 + openness_number_0(_S414, _S418) * _S415.specular_reflect_0;
    yarn_1.through_0 = _S417 * _S415.diffuse_transmit_0 + openness_number_0(_S414, _S418 + 1U) * _S415.specular_transmit_0;
    return yarn_1;
}

void sent_0(uint _S419, uint _S420, vec3 _S421, vec3 _S422, vec3 _S423, vec3 _S424, out vec3 _S425, out vec3 _S426)
{
    uint _S427 = 146U + 4U * _S420;
    float _S428 = openness_number_0(_S419, _S427 + 1U);
    float _S429 = openness_number_0(_S419, _S427 + 2U);
    vec3 _S430 = 1.0 - _S423 * openness_number_0(_S419, _S427);
    vec3 _S431 = 1.0 - _S424 * openness_number_0(_S419, _S427 + 3U);
    vec3 _S432 = 1.0 / (_S430 * _S431 - _S423 * _S424 * (_S428 * _S429));
    _S425 = (_S421 * _S431 + _S423 * _S428 * _S422) * _S432;
    _S426 = (_S422 * _S430 + _S424 * _S429 * _S421) * _S432;
    return;
}

FaceSends_0 face_sends_0(uint _S433, uint _S434, Scattered_0 _S435, Scattered_0 _S436)
{
    uint _S437 = 2U * _S434;
    uint _S438 = 142U + _S437;
    float _S439 = openness_number_0(_S433, _S438);
    float _S440 = openness_number_0(_S433, _S438 + 1U);
    vec3 _S441 = (1.0 - _S439) * _S435.back_4;
    vec3 _S442 = (1.0 - _S440) * _S436.back_4;
    FaceSends_0 sends_1;
    uint _S443 = 154U + _S437;
    float _S444 = openness_number_0(_S433, _S443);
    sends_1.blocks_warp_0 = _S444;
    float _S445 = openness_number_0(_S433, _S443 + 1U);
    sends_1.blocks_weft_0 = _S445;
    sends_1.open_0 = _S444 * _S439 + _S445 * _S440;
    sent_0(_S433, _S434, _S439 * _S435.back_4, _S440 * _S436.back_4, _S441, _S442, sends_1.sky_warp_0, sends_1.sky_weft_0);
    sent_0(_S433, _S434, _S435.through_0, _S436.through_0, _S441, _S442, sends_1.crossing_warp_0, sends_1.crossing_weft_0);
    return sends_1;
}

Interior_0 interior_of_0(uint _S446, vec3 _S447, bool _S448)
{
    Scattered_0 _S449 = scattered_by_0(_S446, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S446)].warp_0)].colour_mean_0), 0U, _S447);
    Scattered_0 _S450 = scattered_by_0(_S446, table_albedos_0(families_0._data[uint(fabrics_0._data[uint(_S446)].weft_0)].colour_mean_0), 1U, _S447);
    uint _S451;
    if(_S448)
    {
        _S451 = 1U;
    }
    else
    {
        _S451 = 0U;
    }
    FaceSends_0 _S452 = face_sends_0(_S446, _S451, _S449, _S450);
    if(_S448)
    {
        _S451 = 0U;
    }
    else
    {
        _S451 = 1U;
    }
    FaceSends_0 _S453 = face_sends_0(_S446, _S451, _S449, _S450);
    vec3 _S454 = _S452.blocks_warp_0 * _S452.crossing_warp_0 + _S452.blocks_weft_0 * _S452.crossing_weft_0;
    vec3 _S455 = _S453.blocks_warp_0 * _S453.crossing_warp_0 + _S453.blocks_weft_0 * _S453.crossing_weft_0;
    float _S456 = 1.0 - _S452.open_0;
    float _S457 = 1.0 - _S453.open_0;
    vec3 _S458 = 1.0 / (1.0 - _S454 * _S455 * (_S456 * _S457));
    vec3 _S459 = _S455 * (_S452.open_0 + _S456 * (_S452.blocks_warp_0 * _S452.sky_warp_0 + _S452.blocks_weft_0 * _S452.sky_weft_0)) * _S458;
    vec3 _S460 = _S454 * (_S453.open_0 + _S457 * (_S453.blocks_warp_0 * _S453.sky_warp_0 + _S453.blocks_weft_0 * _S453.sky_weft_0)) * _S458;
    FaceRadiance_0 _S461 = face_radiance_0(_S452, _S453.open_0, _S459, _S460);
    FaceRadiance_0 _S462 = face_radiance_0(_S453, _S452.open_0, _S460, _S459);
    Interior_0 interior_1;
    interior_1.warp_3 = _S461.warp_2;
    interior_1.weft_3 = _S461.weft_2;
    interior_1.leaked_1 = _S461.leaked_0;
    interior_1.far_1 = _S462.mean_0;
    interior_1.far_leaked_0 = _S462.leaked_0;
    return interior_1;
}

Blocked_0 blocked_of_terms_0(uint _S463, uint _S464, float  _S465[6], uint _S466)
{
    float  shares_0[3];
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
        shares_0[share_1] = 0.0;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S466)
            {
            }
            else
            {
                break;
            }
            shares_0[share_1] = shares_0[share_1] + openness_number_0(_S463, _S464 + share_1 * _S466 + term_0) * _S465[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_1] = saturate_0(shares_0[share_1]);
        share_1 = share_1 + 1U;
    }
    Blocked_0 blocked_2;
    blocked_2.by_warp_0 = shares_0[0] * shares_0[2];
    blocked_2.by_weft_0 = shares_0[0] * (1.0 - shares_0[2]);
    blocked_2.far_0 = shares_0[1];
    return blocked_2;
}

Blocked_0 blocked_from_0(uint _S467, vec3 _S468, bool _S469, bool _S470)
{
    float  terms_1[6];
    view_terms_0(_S468, terms_1);
    uint _S471;
    if(_S470)
    {
        _S471 = 2U;
    }
    else
    {
        _S471 = 0U;
    }
    uint _S472;
    if(_S469)
    {
        _S472 = 0U;
    }
    else
    {
        _S472 = 1U;
    }
    return blocked_of_terms_0(_S467, (_S471 + _S472) * 15U, terms_1, 5U);
}

float warp_seen_from_0(uint _S473, vec3 _S474, bool _S475)
{
    float  terms_2[6];
    view_terms_0(_S474, terms_2);
    uint term_1 = 0U;
    float share_2 = 0.0;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S476;
        if(_S475)
        {
            _S476 = 5U;
        }
        else
        {
            _S476 = 0U;
        }
        float share_3 = share_2 + openness_number_0(_S473, 132U + _S476 + term_1) * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_2 = share_3;
    }
    return saturate_0(share_2);
}

Bounced_0 bounced_of_families_0(uint _S477, FamilyAlbedos_0 _S478, vec3 _S479, Interior_0 _S480, Blocked_0 _S481, Blocked_0 _S482)
{
    return sum_of_0(bounced_by_0(_S481, scattered_by_0(_S477, _S478.warp_4, 0U, _S479), _S480), bounced_by_0(_S482, scattered_by_0(_S477, _S478.weft_4, 1U, _S479), _S480));
}

Bounced_0 bounced_far_0(uint _S483, FamilyAlbedos_0 _S484, vec3 _S485, Interior_0 _S486, vec3 _S487, bool _S488, float _S489, float _S490, float _S491)
{
    Blocked_0 _S492 = blocked_from_0(_S483, _S487, true, _S488);
    Blocked_0 _S493 = blocked_from_0(_S483, _S487, false, _S488);
    float _S494 = _S489 / max(1.0 - _S492.by_warp_0 - _S492.by_weft_0, 0.10000000149011612);
    float _S495 = (0.0020000000949949 * warp_seen_from_0(_S483, _S487, _S488) + _S494) / (_S494 + _S490 / max(1.0 - _S493.by_warp_0 - _S493.by_weft_0, 0.10000000149011612) + 0.0020000000949949);
    float _S496 = 1.0 - _S491;
    return bounced_of_families_0(_S483, _S484, _S485, _S486, scaled_0(_S492, _S495 * _S496), scaled_0(_S493, (1.0 - _S495) * _S496));
}

Bounced_0 bounced_over_0(uint _S497, Components_0 _S498, CloseUp_0 _S499, FamilyAlbedos_0 _S500, vec3 _S501, vec3 _S502)
{
    bool _S503 = (_S502.z) < 0.0;
    Interior_0 _S504 = interior_of_0(_S497, _S501, _S503);
    Bounced_0 bounced_2 = bounced_far_0(_S497, _S500, _S501, _S504, to_face_frame_0(_S502, _S503), _S503, _S498.diffuse_warp_0, _S498.diffuse_weft_0, _S498.hole_2);
    if((_S499.weight_2) > 0.0)
    {
        Bounced_0 _S505 = bounced_of_families_0(_S497, _S500, _S501, _S504, _S499.warp_1, _S499.weft_1);
        vec3 _S506 = vec3(_S499.weight_2);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S505.reflected_0, _S506);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S505.transmitted_0, _S506);
    }
    return bounced_2;
}

vec3 composed_0(uint _S507, Components_0 _S508, CloseUp_0 _S509, FamilyAlbedos_0 _S510, vec3 _S511, vec3 _S512, vec3 _S513)
{
    Albedos_0 _S514 = tinted_0(_S510.warp_4, _S511);
    Albedos_0 _S515 = tinted_0(_S510.weft_4, _S511);
    vec3 _S516 = _S514.diffuse_reflect_0 * _S508.diffuse_warp_0 + _S515.diffuse_reflect_0 * _S508.diffuse_weft_0 + _S514.specular_reflect_0 * _S508.specular_warp_0 + _S515.specular_reflect_0 * _S508.specular_weft_0;
    float _S517 = _S513.z;
    vec3 body_0;
    if((_S512.z * _S517) < 0.0)
    {
        body_0 = _S514.diffuse_transmit_0 * _S508.diffuse_warp_0 + _S515.diffuse_transmit_0 * _S508.diffuse_weft_0 + _S514.specular_transmit_0 * _S508.specular_warp_0 + _S515.specular_transmit_0 * _S508.specular_weft_0;
    }
    else
    {
        body_0 = _S516;
    }
    if((fabrics_0._data[uint(_S507)].openness_0) != 4294967295U)
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S507, _S508, _S509, _S510, _S511, _S513), _S512, _S513);
    }
    float _S518 = fabrics_0._data[uint(_S507)].sheen_strength_0;
    if((fabrics_0._data[uint(_S507)].sheen_strength_0) <= 0.0)
    {
        return body_0;
    }
    bool _S519 = _S517 < 0.0;
    vec2 _S520 = sheen_with_transmittance_0(to_face_frame_0(_S512, _S519), to_face_frame_0(_S513, _S519), _S518, fabrics_0._data[uint(_S507)].sheen_roughness_0);
    return _S520.y * body_0 + (_S508.light_visibility_1 + _S508.hole_2) * _S520.x;
}

vec4 cloth_value_0(uint fabric_1, vec2 centre_3, vec2 dx_1, vec2 dy_1, vec3 light_5, vec3 view_7)
{
    Footprint_0 footprint_1;
    footprint_1.centre_0 = centre_3;
    footprint_1.dx_0 = dx_1;
    footprint_1.dy_0 = dy_1;
    NeuralView_0 activations_0;
    neural_view_0(fabric_1, footprint_1, view_7, activations_0);
    Components_0 _S521 = neural_components_0(fabric_1, activations_0, light_5);
    float _S522 = view_7.z;
    vec3 _S523 = composed_0(fabric_1, _S521, no_close_up_0(), albedos_over_0(fabric_1, footprint_1, _S522 < 0.0), vec3(1.0), light_5, view_7);
    float through_1 = activations_0.hole_0;
    float through_2;
    if((fabrics_0._data[uint(fabric_1)].sheen_strength_0) > 0.0)
    {
        through_2 = through_1 * (1.0 - fabrics_0._data[uint(fabric_1)].sheen_strength_0 * sheen_lobe_0(abs(_S522), fabrics_0._data[uint(fabric_1)].sheen_roughness_0).z);
    }
    else
    {
        through_2 = through_1;
    }
    return vec4(_S523, through_2);
}

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;
void main()
{
    if((gl_GlobalInvocationID.x) >= (query_count_0._data[uint(0)]))
    {
        return;
    }
    Query_0 _S524 = queries_0._data[uint(gl_GlobalInvocationID.x)];
    answers_0._data[uint(gl_GlobalInvocationID.x)] = cloth_value_0(_S524.fabric_0, vec2(_S524.centre_x_0, _S524.centre_y_0), vec2(_S524.dx_x_0, _S524.dx_y_0), vec2(_S524.dy_x_0, _S524.dy_y_0), vec3(_S524.light_x_0, _S524.light_y_0, _S524.light_z_0), vec3(_S524.view_x_0, _S524.view_y_0, _S524.view_z_0));
    return;
}

