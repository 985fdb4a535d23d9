#version 450
layout(row_major) uniform;
layout(row_major) buffer;
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

layout(std430, binding = 4) readonly buffer StructuredBuffer_Frame_t_0 {
    Frame_0 _data[];
} frames_0;
struct Layer_0
{
    uint face_0;
    float share_0;
};

layout(std430, binding = 12) buffer StructuredBuffer_Layer_t_0 {
    Layer_0 _data[];
} layers_0;
layout(std430, binding = 7) readonly buffer StructuredBuffer_uint_t_0 {
    uint _data[];
} face_fabrics_0;
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

layout(std430, binding = 0) readonly buffer StructuredBuffer_Fabric_t_0 {
    Fabric_0 _data[];
} fabrics_0;
layout(std430, binding = 6) readonly buffer StructuredBuffer_uint_t_1 {
    uint _data[];
} corners_0;
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

layout(std430, binding = 5) readonly buffer StructuredBuffer_Vertex_t_0 {
    Vertex_0 _data[];
} vertices_0;
layout(std430, binding = 11) readonly buffer StructuredBuffer_uint_t_2 {
    uint _data[];
} scene_words_0;
layout(std430, binding = 10) readonly buffer StructuredBuffer_vectorx3Cuintx2C4x3E_t_0 {
    uvec4 _data[];
} packed_numbers_0;
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_3 {
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
};

layout(std430, binding = 1) readonly buffer StructuredBuffer_Family_t_0 {
    Family_0 _data[];
} families_0;
layout(std430, binding = 13) buffer StructuredBuffer_float_t_0 {
    float _data[];
} visibilities_0;
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

layout(std430, binding = 3) readonly buffer StructuredBuffer_Light_t_0 {
    Light_0 _data[];
} lights_1;
layout(std430, binding = 8) buffer StructuredBuffer_vectorx3Cfloatx2C4x3E_t_0 {
    vec4 _data[];
} radiance_0;
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
    vec4 sums_0 = vec4(0.0);
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
        sums_0[0] = sums_0[0] + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        sums_0[1] = sums_0[1] + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        sums_0[2] = sums_0[2] + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        sums_0[3] = sums_0[3] + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
}

int whole_parts_0(int elements_0)
{
    return (elements_0 + 3) / 4 * 4;
}

float Identity_apply_0(float x_2)
{
    return x_2;
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
    vec4 sums_1 = vec4(0.0);
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
        sums_1[0] = sums_1[0] + (dot(_S25.low_0, low_2) + dot(_S25.high_0, high_2));
        Eight_0 _S26 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1);
        sums_1[1] = sums_1[1] + (dot(_S26.low_0, low_2) + dot(_S26.high_0, high_2));
        Eight_0 _S27 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1);
        sums_1[2] = sums_1[2] + (dot(_S27.low_0, low_2) + dot(_S27.high_0, high_2));
        Eight_0 _S28 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1);
        sums_1[3] = sums_1[3] + (dot(_S28.low_0, low_2) + dot(_S28.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
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
    vec4 sums_2 = vec4(0.0);
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
        sums_2[0] = sums_2[0] + (dot(_S44.low_0, low_3) + dot(_S44.high_0, high_3));
        Eight_0 _S45 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2);
        sums_2[1] = sums_2[1] + (dot(_S45.low_0, low_3) + dot(_S45.high_0, high_3));
        Eight_0 _S46 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2);
        sums_2[2] = sums_2[2] + (dot(_S46.low_0, low_3) + dot(_S46.high_0, high_3));
        Eight_0 _S47 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2);
        sums_2[3] = sums_2[3] + (dot(_S47.low_0, low_3) + dot(_S47.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
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
    vec4 sums_3 = vec4(0.0);
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
        sums_3[0] = sums_3[0] + (dot(_S63.low_0, low_4) + dot(_S63.high_0, high_4));
        Eight_0 _S64 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3);
        sums_3[1] = sums_3[1] + (dot(_S64.low_0, low_4) + dot(_S64.high_0, high_4));
        Eight_0 _S65 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3);
        sums_3[2] = sums_3[2] + (dot(_S65.low_0, low_4) + dot(_S65.high_0, high_4));
        Eight_0 _S66 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3);
        sums_3[3] = sums_3[3] + (dot(_S66.low_0, low_4) + dot(_S66.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_3;
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
    vec4 sums_4 = vec4(0.0);
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
        sums_4[0] = sums_4[0] + (dot(_S82.low_0, low_5) + dot(_S82.high_0, high_5));
        Eight_0 _S83 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4);
        sums_4[1] = sums_4[1] + (dot(_S83.low_0, low_5) + dot(_S83.high_0, high_5));
        Eight_0 _S84 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4);
        sums_4[2] = sums_4[2] + (dot(_S84.low_0, low_5) + dot(_S84.high_0, high_5));
        Eight_0 _S85 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4);
        sums_4[3] = sums_4[3] + (dot(_S85.low_0, low_5) + dot(_S85.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_4;
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

float LeakyRelu_apply_0(float x_3)
{
    return max(x_3, x_3 * 0.00999999977648258);
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
    vec4 sums_5 = vec4(0.0);
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
        sums_5[0] = sums_5[0] + (dot(_S123.low_0, low_6) + dot(_S123.high_0, high_6));
        Eight_0 _S124 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5);
        sums_5[1] = sums_5[1] + (dot(_S124.low_0, low_6) + dot(_S124.high_0, high_6));
        Eight_0 _S125 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5);
        sums_5[2] = sums_5[2] + (dot(_S125.low_0, low_6) + dot(_S125.high_0, high_6));
        Eight_0 _S126 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5);
        sums_5[3] = sums_5[3] + (dot(_S126.low_0, low_6) + dot(_S126.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_5;
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

float saturate_0(float x_4)
{
    return clamp(x_4, 0.0, 1.0);
}

vec3 saturate_1(vec3 x_5)
{
    return clamp(x_5, vec3(0.0), vec3(1.0));
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

vec3 position_of_0(Vertex_0 vertex_0)
{
    return vec3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(vec3 v_1)
{
    return dot(v_1, v_1);
}

vec3 normal_of_0(Vertex_0 vertex_1)
{
    return vec3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

float square_1(float x_6)
{
    return x_6 * x_6;
}

float natural_logarithm_0(float x_7)
{
    uint _S149 = floatBitsToUint(x_7);
    float exponent_0 = float(int(_S149 >> 23) - 126);
    float m_0 = uintBitsToFloat((_S149 & 8388607U) | 1056964608U);
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
    float _S150 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444 * m_2 - 0.11514610052108765) * m_2 + 0.11676998436450958) * m_2 - 0.12420140951871872) * m_2 + 0.14249323308467865) * m_2 - 0.16668057441711426) * m_2 + 0.20000714063644409) * m_2 - 0.24999994039535522) * m_2 + 0.33333331346511841) * m_2 * _S150 - exponent_1 * 0.00021219444170129 - 0.5 * _S150) + exponent_1 * 0.693359375;
}

float binary_logarithm_0(float x_8)
{
    return natural_logarithm_0(x_8) * 1.4426950216293335;
}

float exponential_0(float x_9)
{
    float _S151 = clamp(x_9, -87.0, 88.0);
    float _S152 = floor(_S151 * 1.4426950216293335 + 0.5);
    float _S153 = _S151 - _S152 * 0.693359375 + _S152 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S153 + 0.00139819993637502) * _S153 + 0.00833345204591751) * _S153 + 0.04166579619050026) * _S153 + 0.1666666567325592) * _S153 + 0.5;
    float _S154 = uintBitsToFloat(uint(int(_S152) + 127) << 23);
    float _S155;
    if(x_9 < -87.0)
    {
        _S155 = 0.0;
    }
    else
    {
        _S155 = (p_0 * _S153 * _S153 + _S153 + 1.0) * _S154;
    }
    return _S155;
}

vec3 map_texel_0(uint index_0)
{
    uint _S156 = scene_words_0._data[uint(index_0)];
    vec3 _S157 = vec3(float(_S156 & 1023U), float((_S156 >> 10) & 1023U), float(_S156 >> 20)) / 1023.0;
    return _S157 * _S157;
}

vec3 map_level_0(uint first_19, uint side_0, vec2 uv_0)
{
    float _S158 = uv_0.x;
    float _S159 = float(side_0);
    float _S160 = (_S158 - floor(_S158)) * _S159 - 0.5;
    float _S161 = uv_0.y;
    float _S162 = (_S161 - floor(_S161)) * _S159 - 0.5;
    float _S163 = floor(_S160);
    int _S164 = int(side_0);
    uint _S165 = side_0 - 1U;
    uint _S166 = uint(int(_S163) + _S164) & _S165;
    float _S167 = floor(_S162);
    uint _S168 = uint(int(_S167) + _S164) & _S165;
    uint _S169 = (_S166 + 1U) & _S165;
    uint _S170 = first_19 + _S168 * side_0;
    vec3 _S171 = vec3(_S160 - _S163);
    uint _S172 = first_19 + ((_S168 + 1U) & _S165) * side_0;
    return mix(mix(map_texel_0(_S170 + _S166), map_texel_0(_S170 + _S169), _S171), mix(map_texel_0(_S172 + _S166), map_texel_0(_S172 + _S169), _S171), vec3(_S162 - _S167));
}

struct VisiblePoint_0
{
    vec3 position_0;
    vec3 view_0;
    vec3 axis_x_0;
    vec3 axis_y_0;
    vec3 normal_0;
    vec3 face_normal_0;
    vec2 uv_1;
    vec2 draft_per_uv_0;
    vec2 draft_0;
    vec2 draft_dx_0;
    vec2 draft_dy_0;
};

vec3 to_local_0(VisiblePoint_0 point_0, vec3 direction_0)
{
    return vec3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

struct Footprint_0
{
    vec2 centre_0;
    vec2 dx_0;
    vec2 dy_0;
};

vec3 row_of_taps_0(Footprint_0 footprint_0)
{
    float _S173 = footprint_0.dx_0.x;
    float _S174 = footprint_0.dy_0.x;
    float _S175 = _S173 * _S173 + _S174 * _S174;
    float _S176 = footprint_0.dx_0.y;
    float _S177 = footprint_0.dy_0.y;
    float _S178 = _S176 * _S176 + _S177 * _S177;
    float _S179 = _S173 * _S176 + _S174 * _S177;
    float _S180 = 0.5 * (_S175 - _S178);
    float _S181 = 0.5 * (_S175 + _S178);
    float _S182 = sqrt(_S180 * _S180 + _S179 * _S179);
    float _S183 = _S181 + _S182;
    float _S184 = max(_S183 - 1.5 * max(_S181 - _S182, 0.0), 0.0);
    float _S185 = square_1(4.0);
    float _S186 = max(_S181 - 0.5 * _S184, _S183 / _S185);
    float _S187 = sqrt(max(min(_S184, _S183 - _S186), 0.0) / (_S185 - 1.0));
    float _S188 = _S180 / max(_S182, 1.00000000317107685e-30);
    float _S189 = sqrt(max(0.5 * (1.0 - _S188), 0.0));
    float _S190 = sqrt(_S186);
    float _S191 = _S187 * sqrt(max(0.5 * (1.0 + _S188), 0.0));
    float _S192;
    if(_S179 < 0.0)
    {
        _S192 = - _S187 * _S189;
    }
    else
    {
        _S192 = _S187 * _S189;
    }
    return vec3(_S190, _S191, _S192);
}

struct AnisotropicTaps_0
{
    vec2 centre_1;
    float side_1;
    vec2 first_20;
    vec2 second_0;
};

float AnisotropicTaps_size_0(AnisotropicTaps_0 this_2)
{
    float _S193 = this_2.first_20.x;
    float _S194 = this_2.second_0.x;
    float _S195 = this_2.side_1;
    float _S196 = _S195 * _S195;
    float _S197 = this_2.first_20.y;
    float _S198 = this_2.second_0.y;
    float _S199 = 12.0 * (_S193 * _S197 + _S194 * _S198);
    return sqrt(sqrt(max((12.0 * (_S193 * _S193 + _S194 * _S194) + _S196) * (12.0 * (_S197 * _S197 + _S198 * _S198) + _S196) - _S199 * _S199, square_1(_S196))));
}

vec3 footprint_coordinates_0(AnisotropicTaps_0 taps_0)
{
    return vec3(taps_0.centre_1 - floor(taps_0.centre_1), clamp(natural_logarithm_0(max(AnisotropicTaps_size_0(taps_0), 9.99999997475242708e-07) / 0.015625) * 0.11708354949951172, 0.0, 1.0));
}

vec3 to_face_frame_0(vec3 direction_1, bool back_1)
{
    vec2 _S200 = direction_1.xy;
    float _S201;
    if(back_1)
    {
        _S201 = - direction_1.z;
    }
    else
    {
        _S201 = direction_1.z;
    }
    return vec3(_S200, _S201);
}

float table_number_0(uint index_1)
{
    return uintBitsToFloat(words_0._data[uint(index_1)]);
}

float wrapped_0(float index_2, float count_1)
{
    float _S202;
    if(index_2 < 0.0)
    {
        _S202 = index_2 + count_1;
    }
    else
    {
        if(index_2 >= count_1)
        {
            _S202 = index_2 - count_1;
        }
        else
        {
            _S202 = index_2;
        }
    }
    return _S202;
}

bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 this_3)
{
    const vec2 _S203 = vec2(0.0);
    bool _S204;
    if((any(bvec2((notEqual(this_3.first_20,_S203))))))
    {
        _S204 = true;
    }
    else
    {
        _S204 = (any(bvec2((notEqual(this_3.second_0,_S203)))));
    }
    return _S204;
}

vec2 AnisotropicTaps_place_0(AnisotropicTaps_0 this_4, uint number_0)
{
    float _S205;
    if(number_0 >= 2U)
    {
        _S205 = 1.0;
    }
    else
    {
        _S205 = -1.0;
    }
    float _S206;
    if((number_0 & 1U) != 0U)
    {
        _S206 = 1.0;
    }
    else
    {
        _S206 = -1.0;
    }
    return this_4.centre_1 + _S205 * this_4.first_20 + _S206 * this_4.second_0;
}

float bump_0(float distance_0)
{
    float _S207 = max(1.0 - distance_0 * distance_0, 0.0);
    return _S207 * _S207;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239) * 6.16096401214599609, 0.0, 1.0);
}

vec2 turns_and_remainder_0(uint family_0, float index_3)
{
    float _S208 = floor(fma(index_3, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S208, fma(- _S208, families_0._data[uint(family_0)].count_0, index_3));
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
    float _S209 = floor(position_1 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S210 = fma(- _S209, families_0._data[uint(family_1)].size_0, position_1);
    cell_0.below_0 = _S210;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S210;
    cell_0.across_0 = _S210 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S209).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S211 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S212;
    if(_S211 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S212 = 1U;
    }
    else
    {
        _S212 = 0U;
    }
    uint _S213 = min(thread_1 + _S212, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S214 = families_0._data[uint(family_2)].place_table_0 + _S213 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S213;
    cell_1.below_0 = _S211 - table_number_0(_S214);
    cell_1.above_0 = table_number_0(_S214 + 1U) - _S211;
    cell_1.across_0 = _S211 - table_number_0(_S214 + 2U);
    cell_1.half_width_1 = table_number_0(_S214 + 3U);
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_3)
{
    if((families_0._data[uint(family_3)].is_alike_0) != 0U)
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
    Cell_0 _S215 = locate_0(family_4, position_4);
    float _S216 = table_number_0(families_0._data[uint(family_4)].before_0 + 2U * _S215.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_2 = _S215.thread_0;
    bound_0.turns_2 = round((position_4 - families_0._data[uint(family_4)].start_0 - _S216 - _S215.below_0) * families_0._data[uint(family_4)].inverse_period_0);
    bound_0.cell_2 = _S215.below_0;
    float _S217 = 2.0 * _S215.half_width_1;
    bound_0.width_1 = _S217;
    bound_0.visible_0 = clamp((_S215.across_0 + _S215.half_width_1) / _S217, 0.0, 1.0);
    bound_0.gap_0 = min(_S215.below_0, _S215.below_0 - _S215.across_0 - _S215.half_width_1) + max(_S215.across_0 - _S215.half_width_1, 0.0);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S218 = centre_2 - floor((centre_2 - families_0._data[uint(family_5)].start_0) * families_0._data[uint(family_5)].inverse_period_0) * families_0._data[uint(family_5)].period_0;
    float _S219 = 0.5 * max(size_1, families_0._data[uint(family_5)].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S218 - _S219);
    stretch_0.high_7 = bound_at_0(family_5, _S218 + _S219);
    return stretch_0;
}

vec3 table_colour_0(uint index_4)
{
    return vec3(table_number_0(index_4), table_number_0(index_4 + 1U), table_number_0(index_4 + 2U));
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
    float _S220 = Stretch_turns_0(stretch_1);
    uint _S221 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.low_7.thread_2;
    uint _S222 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.high_7.thread_2;
    float _S223 = table_number_0(_S222) - table_number_0(_S221);
    float _S224 = table_number_0(_S222 + 1U) - table_number_0(_S221 + 1U);
    return vec3(_S223 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_1 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_1 + _S220 * families_0._data[uint(family_6)].visible_total_0, _S224 - _S223 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S220 * (families_0._data[uint(family_6)].period_0 - families_0._data[uint(family_6)].visible_total_0), _S224 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S220 * families_0._data[uint(family_6)].period_0);
}

vec2 integrals_along_0(uint family_7, Stretch_0 stretch_2, uint quantity_0)
{
    Family_0 _S225 = families_0._data[uint(family_7)];
    uint _S226 = 3U * _S225.quantities_0;
    uint _S227 = families_0._data[uint(family_7)].colour_threads_0 + _S226 * stretch_2.low_7.thread_2 + quantity_0;
    uint _S228 = families_0._data[uint(family_7)].colour_threads_0 + _S226 * stretch_2.high_7.thread_2 + quantity_0;
    uint _S229 = families_0._data[uint(family_7)].colour_threads_0 + _S226 * uint(families_0._data[uint(family_7)].count_0) + quantity_0;
    float _S230 = table_number_0(_S227);
    float _S231 = table_number_0(_S228);
    float _S232 = Stretch_turns_0(stretch_2);
    uint _S233 = 2U * _S225.quantities_0;
    return vec2(table_number_0(_S228 + _S225.quantities_0) - table_number_0(_S227 + _S225.quantities_0) + _S231 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_1 - _S230 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_1 + _S232 * table_number_0(_S229 + _S225.quantities_0), table_number_0(_S228 + _S233) - table_number_0(_S227 + _S233) + _S231 * stretch_2.high_7.cell_2 - _S230 * stretch_2.low_7.cell_2 + _S232 * table_number_0(_S229 + _S233));
}

bool Stretch_wraps_0(Stretch_0 this_6)
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

uvec4 Stretch_differences_0(Stretch_0 this_7, uvec4 entries_0, uint whole_0)
{
    uint _S234 = entries_0.z;
    uint _S235 = entries_0.x;
    uint _S236 = _S234 - _S235;
    uint _S237;
    if(Stretch_wraps_0(this_7))
    {
        _S237 = whole_0;
    }
    else
    {
        _S237 = 0U;
    }
    return uvec4(_S236 + _S237, entries_0.w - _S234, entries_0.y - _S235, whole_0);
}

uvec4 row_differences_0(Stretch_0 across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S238 = row_7 + across_1.low_7.thread_2 * quantities_1;
    uint _S239 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, uvec4(words_0._data[uint(_S238)], words_0._data[uint(_S238 + quantities_1)], words_0._data[uint(_S239)], words_0._data[uint(_S239 + quantities_1)]), words_0._data[uint(row_7 + count_2 * quantities_1)]);
}

vec4 Stretch_weights_0(Stretch_0 this_8)
{
    float _S240 = - this_8.low_7.visible_0;
    float _S241 = Stretch_turns_0(this_8);
    float _S242;
    if(Stretch_wraps_0(this_8))
    {
        _S242 = 1.0;
    }
    else
    {
        _S242 = 0.0;
    }
    return vec4(1.0, this_8.high_7.visible_0, _S240, _S241 - _S242);
}

float integral_on_top_0(uint family_8, Stretch_0 across_2, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S243 = uint(families_0._data[uint(family_8)].count_0);
    uint _S244 = (_S243 + 1U) * families_0._data[uint(family_8)].quantities_0;
    uint _S245 = families_0._data[uint(family_8)].colour_areas_0 + quantity_1;
    uvec4 _S246 = row_differences_0(across_2, _S245 + along_0.low_7.thread_2 * _S244, _S243, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S247 = row_differences_0(across_2, _S245 + (along_0.low_7.thread_2 + 1U) * _S244, _S243, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S248 = row_differences_0(across_2, _S245 + along_0.high_7.thread_2 * _S244, _S243, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S249 = row_differences_0(across_2, _S245 + (along_0.high_7.thread_2 + 1U) * _S244, _S243, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S250 = row_differences_0(across_2, _S245 + crossing_count_0 * _S244, _S243, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S251 = _S248 - _S246;
    uvec4 _S252;
    if(Stretch_wraps_0(along_0))
    {
        _S252 = _S250;
    }
    else
    {
        _S252 = uvec4(ivec4(0));
    }
    vec4 _S253 = Stretch_weights_0(across_2);
    return dot(vec4(dot(vec4(ivec4(_S251 + _S252)), _S253), dot(vec4(ivec4(_S249 - _S248)), _S253), dot(vec4(ivec4(_S247 - _S246)), _S253), dot(vec4(ivec4(_S250)), _S253)), Stretch_weights_0(along_0)) * families_0._data[uint(family_8)].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S254 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_0 * _S254.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_0 * _S254.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_0 * _S254.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_0 * _S254.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 own_0, Stretch_0 other_0, bool back_2)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0._data[uint(family_9)].colour_mean_0);
    if((families_0._data[uint(family_9)].quantities_0) == 1U)
    {
        return albedos_2;
    }
    vec3 _S255 = lengths_0(crossing_0, other_0);
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
        vec2 _S256 = integrals_along_0(family_9, own_0, quantity_2);
        float _S257 = integral_on_top_0(family_9, own_0, other_0, uint(families_0._data[uint(crossing_0)].count_0), quantity_2);
        float _S258 = _S256.x;
        float _S259 = _S258 * _S255.x;
        float _S260;
        if(back_2)
        {
            _S260 = _S259 - _S257;
        }
        else
        {
            _S260 = _S257;
        }
        bool _S261 = quantity_2 == 0U;
        if(_S261)
        {
            is_exposed_0 = _S260 > (16.0 * families_0._data[uint(family_9)].area_unit_0 * min(_S259 / families_0._data[uint(family_9)].crossing_area_0, 1.0) + 0.00000999999974738 * _S259);
        }
        float _S262 = _S258 * _S255.y;
        float _S263;
        if(is_exposed_0)
        {
            _S263 = _S260;
        }
        else
        {
            _S263 = 0.0;
        }
        float _S264 = _S262 + _S263 + 0.000244140625 * _S255.z * _S256.y;
        if(_S261)
        {
            weight_1 = 1.0 / max(_S264, 9.99999968265522539e-21);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S264 * weight_1, families_0._data[uint(family_9)].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate_1(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate_1(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate_1(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate_1(albedos_2.specular_transmit_0);
    return albedos_2;
}

Albedos_0 tinted_0(Albedos_0 albedos_3, vec3 tint_0)
{
    Albedos_0 result_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

uint scramble_0(uint value_0)
{
    uint _S265 = value_0 * 747796405U + 2891336453U;
    uint _S266 = ((_S265 >> ((_S265 >> 28) + 4U)) ^ _S265) * 277803737U;
    return (_S266 >> 22) ^ _S266;
}

float uniform_hash_0(uint thread_3, uint cell_3, uint stream_0)
{
    return (float((scramble_0(cell_3 + scramble_0(thread_3 + scramble_0(stream_0)))) >> 9) + 0.5) * 1.1920928955078125e-07;
}

vec2 pixel_sequence_0(uvec2 pixel_0, uint index_5, uint stream_1)
{
    uint _S267 = pixel_0.x;
    uint _S268 = pixel_0.y;
    return fract(vec2(uniform_hash_0(_S267, _S268, stream_1), uniform_hash_0(_S267, _S268, stream_1 + 1U)) + float(index_5 & 65535U) * vec2(0.75487768650054932, 0.56984031200408936));
}

float scene_number_0(uint index_6)
{
    return uintBitsToFloat(scene_words_0._data[uint(index_6)]);
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
        uint _S269 = (low_8 + high_8) / 2U;
        if((scene_number_0(table_0 + _S269)) <= number_1)
        {
            low_8 = _S269;
        }
        else
        {
            high_8 = _S269;
        }
    }
    uint _S270 = table_0 + low_8;
    float _S271 = scene_number_0(_S270);
    float _S272 = scene_number_0(_S270 + 1U);
    Choice_0 choice_0;
    choice_0.index_7 = low_8;
    choice_0.remainder_0 = saturate_0((number_1 - _S271) / max(_S272 - _S271, 9.999999960041972e-13));
    return choice_0;
}

float mean_0(vec3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0;
}

vec2 sine_cosine_0(float x_10)
{
    float _S273 = floor(x_10 * 0.63661974668502808 + 0.5);
    float _S274 = x_10 - _S273 * 1.5703125 - _S273 * 0.00048375129699707 - _S273 * 7.54979012640433211e-08;
    float _S275 = _S274 * _S274;
    float _S276 = ((-0.00019515295571182 * _S275 + 0.00833216123282909) * _S275 - 0.16666655242443085) * _S275 * _S274 + _S274;
    float _S277 = ((0.00002443315679557 * _S275 - 0.00138873164542019) * _S275 + 0.04166664555668831) * _S275 * _S275 - 0.5 * _S275 + 1.0;
    uint _S278 = uint(int(_S273)) & 3U;
    vec2 _S279;
    if((_S278 & 1U) != 0U)
    {
        _S279 = vec2(_S277, _S276);
    }
    else
    {
        _S279 = vec2(_S276, _S277);
    }
    float _S280;
    if((_S278 & 2U) != 0U)
    {
        _S280 = - _S279.x;
    }
    else
    {
        _S280 = _S279.x;
    }
    float _S281;
    if(((_S278 + 1U) & 2U) != 0U)
    {
        _S281 = - _S279.y;
    }
    else
    {
        _S281 = _S279.y;
    }
    return vec2(_S280, _S281);
}

float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp(output_9, 0.0, 8.0)) - 1.0) * scale_0;
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S282 = bundle_0 / 3U;
    uint _S283 = bundle_0 % 3U;
    uint _S284;
    if(bundle_0 == 24U)
    {
        _S284 = bundle_0;
    }
    else
    {
        _S284 = _S282 * 3U + 3U - 1U - _S283;
    }
    return _S284;
}

float light_visibility_of_0(float diffuse_0, vec3 light_0, vec3 view_1, float blend_0)
{
    float _S285 = max(abs(light_0.z), 0.00100000004749745);
    vec2 _S286 = light_0.xy;
    return 3.14159274101257324 * max(diffuse_0, 0.0) / mix(_S285, (0.59700000286102295 * _S285 + 0.16599999368190765) * (0.21600000560283661 * (dot(_S286, view_1.xy) * (inversesqrt((max(dot(_S286, _S286), 9.99999997475242708e-07))))) + 1.0), blend_0);
}

float sheen_scale_0(float x_11, float y_2)
{
    return (((((0.0 * x_11 + (((((-1.1402510404586792 * y_2 + 0.40672621130943298) * y_2 + 1.65398800373077393) * y_2 + -1.29730904102325439) * y_2 + 0.30570998787879944) * y_2 + -0.0220868494361639)) * x_11 + (((((-0.21142719686031342 * y_2 + 1.05947399139404297) * y_2 + -0.41116121411323547) * y_2 + -0.93859231472015381) * y_2 + 0.51606941223144531) * y_2 + 0.05409301072359085)) * x_11 + (((((1.22944498062133789 * y_2 + -0.45962560176849365) * y_2 + -1.63861405849456787) * y_2 + 1.33565104007720947) * y_2 + -0.45725581049919128) * y_2 + 0.08243165910243988)) * x_11 + (((((0.39779931306838989 * y_2 + -1.18879103660583496) * y_2 + 0.28251591324806213) * y_2 + 1.168984055519104) * y_2 + -0.76864629983901978) * y_2 + 0.0091691892594099)) * x_11 + (((((-0.26563560962677002 * y_2 + -0.19379159808158875) * y_2 + 0.2677634060382843) * y_2 + 0.00270519289188087) * y_2 + 0.14349560439586639) * y_2 + 0.10290180146694183)) * x_11 + (((((-0.20701569318771362 * y_2 + 0.24526430666446686) * y_2 + 0.19551840424537659) * y_2 + 0.07586126774549484) * y_2 + 0.38894739747047424) * y_2 + 0.15043120086193085);
}

float sheen_shear_0(float x_12, float y_3)
{
    return ((((0.0 * x_12 + (((((-0.10608240216970444 * y_3 + 1.99214303493499756) * y_3 + -1.42255294322967529) * y_3 + -1.09495604038238525) * y_3 + 0.59180057048797607) * y_3 + 0.06902855634689331)) * x_12 + (((((-0.46220690011978149 * y_3 + -0.29113379120826721) * y_3 + 1.39025199413299561) * y_3 + 0.35589990019798279) * y_3 + -1.17120099067687988) * y_3 + 0.15940259397029877)) * x_12 + (((((2.26068711280822754 * y_3 + -3.64728999137878418) * y_3 + -0.72173482179641724) * y_3 + 3.07659196853637695) * y_3 + -0.6827620267868042) * y_3 + -0.3039557933807373)) * x_12 + (((((0.81201767921447754 * y_3 + 0.36014080047607422) * y_3 + -1.72646903991699219) * y_3 + -0.22630110383033752) * y_3 + 0.89514690637588501) * y_3 + -0.10397960245609283)) * x_12 + (((((-0.37648698687553406 * y_3 + 1.10974001884460449) * y_3 + 0.17824520170688629) * y_3 + -1.04968702793121338) * y_3 + 0.1461234986782074) * y_3 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_13, float y_4)
{
    return ((((0.0 * x_13 + (((((12.95646953582763672 * y_4 + -21.38032913208007812) * y_4 + -7.37853097915649414) * y_4 + 34.55607986450195312) * y_4 + -23.61347007751464844) * y_4 + 5.00126314163208008)) * x_13 + (((((10.91487026214599609 * y_4 + -6.08202791213989258) * y_4 + -38.2036285400390625) * y_4 + 53.3440399169921875) * y_4 + -21.91996002197265625) * y_4 + 2.01606011390686035)) * x_13 + (((((-14.52206039428710938 * y_4 + 36.803619384765625) * y_4 + -22.94047927856445312) * y_4 + -10.07973003387451172) * y_4 + 15.77003955841064453) * y_4 + -4.92722177505493164)) * x_13 + (((((-7.62505722045898438 * y_4 + 1.27310299873352051) * y_4 + 31.19523048400878906) * y_4 + -44.39989852905273438) * y_4 + 26.44947052001953125) * y_4 + -8.73507976531982422)) * x_13 + (((((5.65633487701416016 * y_4 + -17.66820907592773438) * y_4 + 24.65356063842773438) * y_4 + -19.38941001892089844) * y_4 + 11.06159019470214844) * y_4 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S287 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S288 = 2.0 * sqrt(_S287) - 1.0;
    float _S289 = 3.0 * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S288, _S289), 0.00999999977648258, 1.0), clamp((1.0 - _S287) * sheen_shear_0(_S288, _S289), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S288, _S289), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_1, vec3 view_2, float scale_1, float shear_0)
{
    float _S290 = light_1.z;
    bool _S291;
    if(_S290 <= 0.0)
    {
        _S291 = true;
    }
    else
    {
        _S291 = (view_2.z) <= 0.0;
    }
    if(_S291)
    {
        return 0.0;
    }
    vec2 _S292 = view_2.xy;
    float _S293 = dot(_S292, _S292);
    vec2 _S294;
    if(_S293 > 9.99999968265522539e-21)
    {
        _S294 = _S292 * (inversesqrt((_S293)));
    }
    else
    {
        _S294 = vec2(1.0, 0.0);
    }
    float _S295 = scale_1 * dot(light_1.xy, _S294) + shear_0 * _S290;
    float _S296 = scale_1 * (light_1.y * _S294.x - light_1.x * _S294.y);
    float _S297 = _S295 * _S295 + _S296 * _S296 + _S290 * _S290;
    return 0.31830987334251404 * scale_1 * scale_1 * _S290 / max(_S297 * _S297, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_2, vec3 view_3, float strength_0, float roughness_2)
{
    vec3 _S298 = sheen_lobe_0(view_3.z, roughness_2);
    float _S299 = strength_0 * _S298.z;
    return vec2(_S299 * transformed_cosine_0(light_2, view_3, _S298.x, _S298.y), 1.0 - _S299);
}

void accumulate_0(uint index_8, vec4 light_3)
{
    float _S300 = layers_0._data[uint(index_8)].share_0;
    radiance_0._data[uint(index_8)] = radiance_0._data[uint(index_8)] + layers_0._data[uint(index_8)].share_0 * light_3;
    layers_0._data[uint(index_8)].share_0 = _S300 * (1.0 - light_3.w);
    return;
}

vec3 camera_right_0(int _S301)
{
    return vec3(frames_0._data[uint(_S301)].right_x_0, frames_0._data[uint(_S301)].right_y_0, frames_0._data[uint(_S301)].right_z_0);
}

vec3 camera_up_0(int _S302)
{
    return vec3(frames_0._data[uint(_S302)].up_x_0, frames_0._data[uint(_S302)].up_y_0, frames_0._data[uint(_S302)].up_z_0);
}

vec3 camera_forward_0(int _S303)
{
    return vec3(frames_0._data[uint(_S303)].forward_x_0, frames_0._data[uint(_S303)].forward_y_0, frames_0._data[uint(_S303)].forward_z_0);
}

vec3 camera_origin_0(int _S304)
{
    return vec3(frames_0._data[uint(_S304)].origin_x_0, frames_0._data[uint(_S304)].origin_y_0, frames_0._data[uint(_S304)].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S305, uint _S306, float _S307, float _S308)
{
    uint _S309 = 3U * _S306;
    Vertex_0 _S310 = vertices_0._data[uint(corners_0._data[uint(_S309)])];
    Vertex_0 _S311 = vertices_0._data[uint(corners_0._data[uint(_S309 + 1U)])];
    Vertex_0 _S312 = vertices_0._data[uint(corners_0._data[uint(_S309 + 2U)])];
    vec3 _S313 = position_of_0(_S310);
    vec3 _S314 = position_of_0(_S311) - _S313;
    vec3 _S315 = position_of_0(_S312) - _S313;
    float _S316 = _S311.u_0 - _S310.u_0;
    float _S317 = _S311.v_0 - _S310.v_0;
    vec2 _S318 = vec2(_S316, _S317);
    float _S319 = _S312.u_0 - _S310.u_0;
    float _S320 = _S312.v_0 - _S310.v_0;
    vec2 _S321 = vec2(_S319, _S320);
    float _S322;
    if((_S316 * _S320 - _S317 * _S319) < 0.0)
    {
        _S322 = -1.0;
    }
    else
    {
        _S322 = 1.0;
    }
    vec3 _S323 = _S322 * (_S320 * _S314 - _S317 * _S315);
    vec3 _S324 = _S322 * (_S316 * _S315 - _S319 * _S314);
    VisiblePoint_0 point_1;
    vec3 _S325 = normalize((1.0 - _S307 - _S308) * normal_of_0(_S310) + _S307 * normal_of_0(_S311) + _S308 * normal_of_0(_S312));
    point_1.normal_0 = _S325;
    vec3 _S326 = normalize(_S323 - _S325 * dot(_S325, _S323));
    point_1.axis_x_0 = _S326;
    point_1.axis_y_0 = cross(_S325, _S326);
    vec3 _S327 = normalize(cross(_S314, _S315));
    vec3 _S328;
    if((dot(_S327, _S325)) < 0.0)
    {
        _S328 = - _S327;
    }
    else
    {
        _S328 = _S327;
    }
    point_1.face_normal_0 = _S328;
    point_1.position_0 = _S313 + _S307 * _S314 + _S308 * _S315;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_1 = vec2(_S310.u_0, _S310.v_0) + _S307 * _S318 + _S308 * _S321;
    bool _S329 = (dot(cross(_S323, _S324), point_1.normal_0)) < 0.0;
    float _S330 = fabrics_0._data[uint(_S305)].uv_width_0;
    if(_S329)
    {
        _S322 = - fabrics_0._data[uint(_S305)].uv_height_0;
    }
    else
    {
        _S322 = fabrics_0._data[uint(_S305)].uv_height_0;
    }
    vec2 _S331 = vec2(_S330, _S322);
    point_1.draft_per_uv_0 = _S331;
    vec2 _S332 = point_1.uv_1 * _S331;
    if(_S329)
    {
        _S322 = fabrics_0._data[uint(_S305)].uv_height_0;
    }
    else
    {
        _S322 = 0.0;
    }
    point_1.draft_0 = _S332 + vec2(0.0, _S322);
    const vec2 _S333 = vec2(0.0);
    point_1.draft_dx_0 = _S333;
    point_1.draft_dy_0 = _S333;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S334, uint _S335, uint _S336, uvec2 _S337)
{
    uint _S338 = 3U * _S336;
    Vertex_0 _S339 = vertices_0._data[uint(corners_0._data[uint(_S338)])];
    Vertex_0 _S340 = vertices_0._data[uint(corners_0._data[uint(_S338 + 1U)])];
    Vertex_0 _S341 = vertices_0._data[uint(corners_0._data[uint(_S338 + 2U)])];
    vec3 _S342 = position_of_0(_S339);
    vec3 _S343 = position_of_0(_S340) - _S342;
    vec3 _S344 = position_of_0(_S341) - _S342;
    vec3 _S345 = cross(_S343, _S344);
    float _S346 = 1.0 / max(square_0(_S345), 1.00000000317107685e-30);
    float _S347 = float(frames_0._data[uint(_S334)].width_0);
    vec3 _S348 = camera_right_0(_S334) * (2.0 / _S347);
    float _S349 = float(frames_0._data[uint(_S334)].height_0);
    vec3 _S350 = camera_up_0(_S334) * (-2.0 / _S349);
    vec3 _S351 = camera_forward_0(_S334) + (float(_S337.x) + 0.5 - 0.5 * _S347) * _S348 + (float(_S337.y) + 0.5 - 0.5 * _S349) * _S350;
    float _S352 = dot(_S351, _S345);
    float _S353;
    if((abs(_S352)) > 1.00000000317107685e-30)
    {
        _S353 = _S352;
    }
    else
    {
        _S353 = 1.00000000317107685e-30;
    }
    float _S354 = 1.0 / _S353;
    vec3 _S355 = _S342 - camera_origin_0(_S334);
    float _S356 = dot(_S355, _S345) * _S354;
    vec3 _S357 = _S351 * _S356 - _S355;
    vec3 _S358 = _S356 * (_S348 - _S351 * (dot(_S348, _S345) * _S354));
    vec3 _S359 = _S356 * (_S350 - _S351 * (dot(_S350, _S345) * _S354));
    vec3 _S360 = cross(_S344, _S345) * _S346;
    vec3 _S361 = cross(_S345, _S343) * _S346;
    vec2 _S362 = vec2(_S340.u_0 - _S339.u_0, _S340.v_0 - _S339.v_0);
    vec2 _S363 = vec2(_S341.u_0 - _S339.u_0, _S341.v_0 - _S339.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S335, _S336, dot(_S357, _S360), dot(_S357, _S361));
    point_2.position_0 = _S342 + _S357;
    point_2.view_0 = - normalize(_S351);
    point_2.draft_dx_0 = (dot(_S358, _S360) * _S362 + dot(_S358, _S361) * _S363) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S359, _S360) * _S362 + dot(_S359, _S361) * _S363) * point_2.draft_per_uv_0;
    return point_2;
}

vec3 filtered_albedo_0(uint _S364, VisiblePoint_0 _S365)
{
    uint _S366 = fabrics_0._data[uint(_S364)].albedo_map_levels_0;
    if((fabrics_0._data[uint(_S364)].albedo_map_levels_0) == 0U)
    {
        return vec3(1.0);
    }
    vec2 _S367 = vec2(fabrics_0._data[uint(_S364)].uv_width_0, fabrics_0._data[uint(_S364)].uv_height_0);
    vec2 _S368 = _S365.draft_dx_0 / _S367;
    vec2 _S369 = _S365.draft_dy_0 / _S367;
    uint _S370 = _S366 - 1U;
    uint _S371 = 1U << _S370;
    float _S372 = clamp(0.5 * binary_logarithm_0(max(abs(_S368.x * _S369.y - _S368.y * _S369.x), 9.99999968265522539e-21) * (square_1(float(_S371)) / 3.0)), 0.0, float(_S366) - 1.0);
    uint _S373 = min(uint(_S372), max(_S366, 2U) - 2U);
    uint _S374 = min(_S373 + 1U, _S370);
    uint _S375 = 1U << (2U * _S366);
    return mix(map_level_0(fabrics_0._data[uint(_S364)].albedo_map_0 + (_S375 - (_S375 >> (2U * _S373))) / 3U, _S371 >> _S373, _S365.uv_1), map_level_0(fabrics_0._data[uint(_S364)].albedo_map_0 + (_S375 - (_S375 >> (2U * _S374))) / 3U, _S371 >> _S374, _S365.uv_1), vec3((exponential_0(1.38629436492919922 * (_S372 - float(_S373))) - 1.0) / 3.0));
}

struct WovenView_0
{
    float  sums_6[96];
    float hole_0;
    float correction_weight_0;
    vec3 view_4;
    bool back_3;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S376, Footprint_0 _S377)
{
    vec3 _S378 = row_of_taps_0(_S377);
    vec2 _S379 = _S377.dx_0;
    vec2 _S380 = _S377.dy_0;
    float _S381 = dot(_S379, _S379) + dot(_S380, _S380);
    float _S382 = _S377.dx_0.x * _S377.dy_0.y - _S377.dx_0.y * _S377.dy_0.x;
    float _S383 = 0.5 * (_S381 + sqrt(max(_S381 * _S381 - 4.0 * _S382 * _S382, 0.0)));
    Woven_0 _S384 = fabrics_0._data[uint(_S376)].woven_0;
    bool _S385;
    if(_S383 < (5.5 * (_S381 - _S383)))
    {
        _S385 = _S381 > (8.0 * _S384.pitch_0 * _S384.pitch_0);
    }
    else
    {
        _S385 = false;
    }
    vec2 _S386 = vec2(_S384.ends_per_mm_0, _S384.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    taps_1.centre_1 = _S377.centre_0 * _S386;
    float _S387;
    if(_S385)
    {
        _S387 = sqrt(0.125 * _S381);
    }
    else
    {
        _S387 = _S378.x;
    }
    taps_1.side_1 = _S387 / _S384.pitch_0;
    vec2 _S388;
    if(_S385)
    {
        _S388 = 0.25 * _S377.dx_0;
    }
    else
    {
        _S388 = _S378.yz;
    }
    taps_1.first_20 = _S388 * _S386;
    if(_S385)
    {
        _S388 = 0.25 * _S377.dy_0;
    }
    else
    {
        _S388 = 0.5 * _S378.yz;
    }
    taps_1.second_0 = _S388 * _S386;
    return taps_1;
}

void add_texel_0(uint _S389, uint _S390, float _S391, inout float  _S392[88])
{
    uint _S393 = fabrics_0._data[uint(_S389)].woven_0.latents_0 + _S390 * 8U;
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
        Eight_0 _S394 = eight_halves_0(packed_numbers_0._data[uint(_S393 + part_0)]);
        int _S395 = int(8U * part_0);
        _S392[_S395] = _S392[_S395] + _S391 * _S394.low_0[0];
        _S392[_S395 + 4] = _S392[_S395 + 4] + _S391 * _S394.high_0[0];
        int _S396 = _S395 + 1;
        _S392[_S396] = _S392[_S396] + _S391 * _S394.low_0[1];
        _S392[_S396 + 4] = _S392[_S396 + 4] + _S391 * _S394.high_0[1];
        int _S397 = _S395 + 2;
        _S392[_S397] = _S392[_S397] + _S391 * _S394.low_0[2];
        _S392[_S397 + 4] = _S392[_S397 + 4] + _S391 * _S394.high_0[2];
        int _S398 = _S395 + 3;
        _S392[_S398] = _S392[_S398] + _S391 * _S394.low_0[3];
        _S392[_S398 + 4] = _S392[_S398 + 4] + _S391 * _S394.high_0[3];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S399, uint _S400, bool _S401, vec2 _S402, float _S403, inout float  _S404[88])
{
    Woven_0 _S405 = fabrics_0._data[uint(_S399)].woven_0;
    uint _S406 = fabrics_0._data[uint(_S399)].woven_0.levels_1 + 4U * _S400;
    float _S407 = table_number_0(_S406);
    float _S408 = table_number_0(_S406 + 1U);
    float _S409 = table_number_0(_S406 + 2U);
    bool _S410;
    if(_S400 > 3U)
    {
        _S410 = _S400 < (_S405.top_level_0);
    }
    else
    {
        _S410 = false;
    }
    vec2 _S411 = _S402 * table_number_0(_S406 + 3U);
    float _S412;
    if(_S410)
    {
        _S412 = 1.0;
    }
    else
    {
        _S412 = 0.5;
    }
    vec2 _S413 = _S411 - _S412;
    vec2 _S414 = floor(_S413);
    vec2 _S415 = _S413 - _S414;
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
        float _S416 = float(corner_0 & 1U);
        float _S417 = float(corner_0 >> 1);
        vec2 _S418 = mix(1.0 - _S415, _S415, vec2(_S416, _S417));
        uint _S419 = uint(_S407 + wrapped_0(_S414.y + _S417, _S409) * _S408 + wrapped_0(_S414.x + _S416, _S408));
        uint _S420;
        if(_S401)
        {
            _S420 = _S405.texels_0;
        }
        else
        {
            _S420 = 0U;
        }
        add_texel_0(_S399, _S419 + _S420, _S403 * _S418.x * _S418.y, _S404);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S421, AnisotropicTaps_0 _S422, vec3 _S423, bool _S424, inout float  _S425[88])
{
    float offset_1;
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
        _S425[k_0] = 0.0;
        k_0 = k_0 + 1;
    }
    vec2 _S426 = vec2(fabrics_0._data[uint(_S421)].woven_0.ends_0, fabrics_0._data[uint(_S421)].woven_0.picks_0);
    float _S427 = float(fabrics_0._data[uint(_S421)].woven_0.top_level_0);
    float _S428 = clamp(binary_logarithm_0(max(_S422.side_1, 9.99999997475242708e-07)) + 3.0, 0.0, _S427);
    float _S429 = min(floor(_S428), _S427 - 1.0);
    uint _S430;
    if(AnisotropicTaps_has_steps_0(_S422))
    {
        _S430 = 4U;
    }
    else
    {
        _S430 = 1U;
    }
    uint number_2 = 0U;
    for(;;)
    {
        if(number_2 < (2U * _S430))
        {
        }
        else
        {
            break;
        }
        vec2 _S431 = AnisotropicTaps_place_0(_S422, number_2 >> 1);
        vec2 _S432 = clamp(_S431 - _S426 * floor(_S431 / _S426), vec2(0.0), _S426);
        bool _S433 = (number_2 & 1U) != 0U;
        if(_S433)
        {
            offset_1 = _S428 - _S429;
        }
        else
        {
            offset_1 = 1.0 - (_S428 - _S429);
        }
        float _S434 = offset_1 / float(_S430);
        uint _S435 = uint(_S429);
        uint _S436;
        if(_S433)
        {
            _S436 = 1U;
        }
        else
        {
            _S436 = 0U;
        }
        add_level_0(_S421, _S435 + _S436, _S424, _S432, _S434, _S425);
        number_2 = number_2 + 1U;
    }
    int number_3 = 0;
    for(;;)
    {
        if(number_3 < 3)
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
            float offset_2 = _S423[number_3] - (float(bin_0) + 0.5) / 8.0;
            if(number_3 < 2)
            {
                offset_1 = offset_2 - round(offset_2);
            }
            else
            {
                offset_1 = offset_2;
            }
            _S425[64 + number_3 * 8 + bin_0] = bump_0(offset_1 * 3.20000004768371582);
            bin_0 = bin_0 + 1;
        }
        number_3 = number_3 + 1;
    }
    return;
}

vec3 crown_fibres_0(uint _S437, bool _S438, bool _S439)
{
    float _S440;
    if(_S438)
    {
        if(_S439)
        {
            _S440 = - fabrics_0._data[uint(_S437)].woven_0.warp_x_0;
        }
        else
        {
            _S440 = fabrics_0._data[uint(_S437)].woven_0.warp_x_0;
        }
        return vec3(_S440, fabrics_0._data[uint(_S437)].woven_0.warp_y_0, fabrics_0._data[uint(_S437)].woven_0.warp_roughness_0);
    }
    Woven_0 _S441 = fabrics_0._data[uint(_S437)].woven_0;
    if(_S439)
    {
        _S440 = - _S441.weft_y_0;
    }
    else
    {
        _S440 = _S441.weft_y_0;
    }
    return vec3(_S441.weft_x_0, _S440, _S441.weft_roughness_0);
}

void woven_view_0(uint _S442, Footprint_0 _S443, vec3 _S444, inout WovenView_0 _S445)
{
    bool _S446 = (_S444.z) < 0.0;
    AnisotropicTaps_0 _S447 = anisotropic_taps_0(_S442, _S443);
    vec3 _S448 = footprint_coordinates_0(_S447);
    vec3 _S449 = to_face_frame_0(_S444, _S446);
    HalfWeights_0 weights_23;
    weights_23.first_2 = fabrics_0._data[uint(_S442)].woven_0.network_0;
    float  inputs_23[88];
    code_footprint_0(_S442, _S447, _S448, _S446, inputs_23);
    float  hidden_0[96];
    dense_7(weights_23, 0U, false, inputs_23, hidden_0);
    float  fused_0[100];
    dense_part_8(weights_23, 1068U, false, hidden_0, fused_0);
    fused_0[96] = _S449.x;
    fused_0[97] = _S449.y;
    vec2 _S450 = _S449.xy;
    fused_0[98] = dot(crown_fibres_0(_S442, true, _S446).xy, _S450);
    fused_0[99] = dot(crown_fibres_0(_S442, false, _S446).xy, _S450);
    float  of_hole_0[16];
    dense_6(weights_23, 2232U, false, fused_0, of_hole_0);
    float  hole_1[1];
    dense_5(weights_23, 2444U, false, of_hole_0, hole_1);
    dense_4(weights_23, 2456U, false, fused_0, _S445.sums_6);
    _S445.hole_0 = clamp(hole_1[0], 0.0, 1.0);
    _S445.correction_weight_0 = correction_weight_of_0(_S448.z);
    _S445.view_4 = _S449;
    _S445.back_3 = _S446;
    return;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_1;
    Albedos_0 weft_1;
};

FamilyAlbedos_0 albedos_over_0(uint _S451, Footprint_0 _S452, bool _S453)
{
    vec2 _S454 = _S452.dx_0;
    vec2 _S455 = _S452.dy_0;
    vec2 _S456 = sqrt(_S454 * _S454 + _S455 * _S455);
    Stretch_0 _S457 = stretch_of_0(fabrics_0._data[uint(_S451)].warp_0, _S452.centre_0.x, _S456.x);
    Stretch_0 _S458 = stretch_of_0(fabrics_0._data[uint(_S451)].weft_0, _S452.centre_0.y, _S456.y);
    FamilyAlbedos_0 albedos_4;
    albedos_4.warp_1 = mean_albedos_0(fabrics_0._data[uint(_S451)].warp_0, fabrics_0._data[uint(_S451)].weft_0, _S457, _S458, _S453);
    albedos_4.weft_1 = mean_albedos_0(fabrics_0._data[uint(_S451)].weft_0, fabrics_0._data[uint(_S451)].warp_0, _S458, _S457, _S453);
    return albedos_4;
}

uint light_sample_count_0(int _S459)
{
    return frames_0._data[uint(_S459)].lights_0 + frames_0._data[uint(_S459)].environment_samples_0;
}

float visibility_at_0(int _S460, uint _S461, uvec2 _S462)
{
    if((frames_0._data[uint(_S460)].casts_shadows_0) == 0U)
    {
        return 1.0;
    }
    return visibilities_0._data[uint((_S461 * frames_0._data[uint(_S460)].height_0 + _S462.y) * frames_0._data[uint(_S460)].width_0 + _S462.x)];
}

struct LightSample_0
{
    vec3 towards_0;
    vec3 irradiance_1;
    float distance_1;
};

vec3 environment_texel_0(int _S463, uint _S464, uint _S465)
{
    uint _S466 = frames_0._data[uint(_S463)].environment_table_0 + frames_0._data[uint(_S463)].environment_rows_0 + 1U + frames_0._data[uint(_S463)].environment_rows_0 * (frames_0._data[uint(_S463)].environment_columns_0 + 1U) + 3U * (_S464 * frames_0._data[uint(_S463)].environment_columns_0 + _S465);
    return vec3(scene_number_0(_S466), scene_number_0(_S466 + 1U), scene_number_0(_S466 + 2U));
}

vec3 sample_environment_0(int _S467, vec2 _S468, out vec3 _S469)
{
    uint _S470 = frames_0._data[uint(_S467)].environment_rows_0;
    Choice_0 _S471 = choose_0(frames_0._data[uint(_S467)].environment_table_0, frames_0._data[uint(_S467)].environment_rows_0, _S468.y);
    uint _S472 = frames_0._data[uint(_S467)].environment_columns_0;
    Choice_0 _S473 = choose_0(frames_0._data[uint(_S467)].environment_table_0 + frames_0._data[uint(_S467)].environment_rows_0 + 1U + _S471.index_7 * (frames_0._data[uint(_S467)].environment_columns_0 + 1U), frames_0._data[uint(_S467)].environment_columns_0, _S468.x);
    vec3 _S474 = environment_texel_0(_S467, _S471.index_7, _S473.index_7);
    _S469 = _S474 * (frames_0._data[uint(_S467)].environment_total_0 / max(mean_0(_S474), 9.99999968265522539e-21));
    float _S475 = 3.14159274101257324 / float(_S470);
    float _S476 = mix(sine_cosine_0(float(_S471.index_7) * _S475).y, sine_cosine_0(float(_S471.index_7 + 1U) * _S475).y, _S471.remainder_0);
    float _S477 = sqrt(max(1.0 - _S476 * _S476, 0.0));
    vec2 _S478 = sine_cosine_0((float(_S473.index_7) + _S473.remainder_0) * (6.28318548202514648 / float(_S472)));
    float _S479 = _S477 * _S478.x;
    float _S480 = - _S477 * _S478.y;
    return vec3(frames_0._data[uint(_S467)].environment_cosine_0 * _S479 + frames_0._data[uint(_S467)].environment_sine_0 * _S480, _S476, frames_0._data[uint(_S467)].environment_cosine_0 * _S480 - frames_0._data[uint(_S467)].environment_sine_0 * _S479);
}

LightSample_0 light_sample_0(int _S481, uint _S482, uvec2 _S483, vec3 _S484)
{
    LightSample_0 sample_0;
    sample_0.distance_1 = 1.00000001504746622e+30;
    uint _S485 = frames_0._data[uint(_S481)].lights_0;
    if(_S482 >= (frames_0._data[uint(_S481)].lights_0))
    {
        vec3 weight_2;
        vec3 _S486 = sample_environment_0(_S481, pixel_sequence_0(_S483, frames_0._data[uint(_S481)].pass_number_0 * frames_0._data[uint(_S481)].environment_samples_0 + (_S482 - _S485), 3U), weight_2);
        sample_0.towards_0 = _S486;
        sample_0.irradiance_1 = weight_2 / float(frames_0._data[uint(_S481)].environment_samples_0);
        return sample_0;
    }
    Light_0 _S487 = lights_1._data[uint(_S482)];
    sample_0.irradiance_1 = vec3(_S487.red_0, _S487.green_0, _S487.blue_0);
    sample_0.towards_0 = vec3(_S487.x_1, _S487.y_1, _S487.z_1);
    if((_S487.is_point_0) != 0U)
    {
        vec3 _S488 = sample_0.towards_0 - _S484;
        float _S489 = max(square_0(_S488), 9.999999960041972e-13);
        sample_0.distance_1 = sqrt(_S489);
        sample_0.irradiance_1 = sample_0.irradiance_1 / _S489;
        sample_0.towards_0 = normalize(_S488);
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

void code_light_0(uint _S490, vec3 _S491, vec3 _S492, bool _S493, inout float  _S494[39])
{
    _S494[0] = _S491.x;
    _S494[1] = _S491.y;
    _S494[2] = _S491.z;
    vec3 _S495 = _S491 + _S492;
    float _S496 = _S495.z;
    float _S497 = _S496 * _S496 + 0.00009999999747379;
    vec2 _S498 = _S495.xy;
    float _S499 = 1.0 / (dot(_S498, _S498) + _S497);
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
        vec3 _S500 = crown_fibres_0(_S490, family_10 == 0, _S493);
        vec2 _S501 = _S500.xy;
        _S494[3 + family_10] = dot(_S501, _S491.xy);
        float _S502 = dot(_S501, _S498);
        float _S503 = _S502 * _S502;
        float _S504 = (0.75 * _S502 / (0.5 * sqrt(_S503 + _S497) + abs(_S502)) + 0.5) * 8.0;
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
            _S494[5 + family_10 * 16 + bin_1] = bump_0(_S504 - (float(bin_1) + 0.5) / 2.0);
            bin_1 = bin_1 + 1;
        }
        float _S505 = _S500.z;
        float _S506 = _S505 * _S505;
        float _S507 = _S503 * _S499 * (1.0 - _S506) + _S506;
        _S494[37 + family_10] = 0.25 * natural_logarithm_0(1.0 + 9.54929637908935547 * _S506 * _S505 / (_S507 * _S507));
        family_10 = family_10 + 1;
    }
    return;
}

float mixed_bundles_0(uint _S508, uint _S509, uint _S510, vec3 _S511, vec3 _S512, bool _S513, inout float  _S514[52])
{
    vec3 _S515 = _S511 + _S512;
    float _S516 = 1.0 / (square_0(_S515) + 0.00009999999747379);
    bool _S517;
    if(_S509 == 0U)
    {
        _S517 = _S513;
    }
    else
    {
        _S517 = false;
    }
    float _S518;
    if(_S517)
    {
        _S518 = - _S515.x;
    }
    else
    {
        _S518 = _S515.x;
    }
    if(_S509 == 1U)
    {
        _S517 = _S513;
    }
    else
    {
        _S517 = false;
    }
    float _S519;
    if(_S517)
    {
        _S519 = - _S515.y;
    }
    else
    {
        _S519 = _S515.y;
    }
    uint bundle_1 = 0U;
    float sum_1 = 0.0;
    for(;;)
    {
        if(bundle_1 < 25U)
        {
        }
        else
        {
            break;
        }
        uint _S520 = _S509 * 25U;
        uint _S521 = fabrics_0._data[uint(_S508)].woven_0.bundles_0 + 4U * (_S520 + bundle_1);
        float _S522 = dot(vec3(table_number_0(_S521), table_number_0(_S521 + 1U), table_number_0(_S521 + 2U)), vec3(_S518, _S519, _S515.z));
        float _S523 = _S522 * _S522 * _S516 + table_number_0(_S521 + 3U);
        uint _S524 = _S510 + _S520;
        uint _S525;
        if(_S513)
        {
            _S525 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S525 = bundle_1;
        }
        float sum_2 = sum_1 + max(_S514[_S524 + _S525], _S514[_S524 + _S525] * 0.00999999977648258) / (_S523 * _S523);
        bundle_1 = bundle_1 + 1U;
        sum_1 = sum_2;
    }
    return 0.01999999955296516 * sum_1;
}

Components_0 woven_components_0(uint _S526, inout WovenView_0 _S527, vec3 _S528)
{
    float _S529;
    bool _S530 = _S527.back_3;
    vec3 _S531 = to_face_frame_0(_S528, _S527.back_3);
    vec3 _S532 = _S527.view_4;
    HalfWeights_0 weights_24;
    Woven_0 _S533 = fabrics_0._data[uint(_S526)].woven_0;
    weights_24.first_2 = fabrics_0._data[uint(_S526)].woven_0.network_0;
    float  directions_0[39];
    code_light_0(_S526, _S531, _S527.view_4, _S527.back_3, directions_0);
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
        skip_0[k_1] = _S527.sums_6[k_1];
        k_1 = k_1 + 1;
    }
    dense_3(weights_24, 3716U, true, directions_0, skip_0);
    float  hidden_1[96];
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
        hidden_1[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
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
                _S529 = skip_0[k_1];
            }
            else
            {
                _S529 = 0.0;
            }
            next_0[k_1] = _S529;
            k_1 = k_1 + 1;
        }
        dense_2(weights_24, 4208U + layer_0 * 1164U, true, hidden_1, next_0);
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
            hidden_1[k_2] = next_0[k_2];
            k_2 = k_2 + 1;
        }
        layer_0 = layer_0 + 1U;
    }
    float  outputs_17[52];
    dense_1(weights_24, 7700U, false, hidden_1, outputs_17);
    bool _S534;
    if((_S533.is_corrected_0) != 0U)
    {
        _S534 = (_S531.z) > 0.0;
    }
    else
    {
        _S534 = false;
    }
    if(_S534)
    {
        _S534 = (_S527.correction_weight_0) > 0.0;
    }
    else
    {
        _S534 = false;
    }
    if(_S534)
    {
        FloatWeights_0 fitted_0;
        fitted_0.first_0 = _S533.correction_0;
        float  change_0[50];
        dense_0(fitted_0, 0U, false, hidden_1, change_0);
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
            outputs_17[k_1 + 2] = outputs_17[k_1 + 2] + _S527.correction_weight_0 * change_0[k_1];
            k_1 = k_1 + 1;
        }
    }
    if((_S531.z) > 0.0)
    {
        _S529 = 0.00999999977648258;
    }
    else
    {
        _S529 = 0.00100000004749745;
    }
    Components_0 result_1;
    float _S535 = unmapped_0(outputs_17[0], _S529);
    result_1.diffuse_warp_0 = _S535;
    float _S536 = unmapped_0(outputs_17[1], _S529);
    result_1.diffuse_weft_0 = _S536;
    float _S537 = 2979.9580078125 * _S529;
    float _S538 = mixed_bundles_0(_S526, 0U, 2U, _S531, _S532, _S530, outputs_17);
    result_1.specular_warp_0 = clamp(_S538, 0.0, _S537);
    float _S539 = mixed_bundles_0(_S526, 1U, 2U, _S531, _S532, _S530, outputs_17);
    result_1.specular_weft_0 = clamp(_S539, 0.0, _S537);
    result_1.hole_2 = _S527.hole_0;
    result_1.light_visibility_1 = min(light_visibility_of_0(_S535 + _S536, _S531, _S532, fabrics_0._data[uint(_S526)].diffuse_blend_0), 1.0 - _S527.hole_0);
    return result_1;
}

vec3 composed_0(uint _S540, Components_0 _S541, FamilyAlbedos_0 _S542, vec3 _S543, vec3 _S544)
{
    vec3 _S545 = _S542.warp_1.diffuse_reflect_0 * _S541.diffuse_warp_0 + _S542.weft_1.diffuse_reflect_0 * _S541.diffuse_weft_0 + _S542.warp_1.specular_reflect_0 * _S541.specular_warp_0 + _S542.weft_1.specular_reflect_0 * _S541.specular_weft_0;
    float _S546 = _S544.z;
    vec3 body_0;
    if((_S543.z * _S546) < 0.0)
    {
        body_0 = _S542.warp_1.diffuse_transmit_0 * _S541.diffuse_warp_0 + _S542.weft_1.diffuse_transmit_0 * _S541.diffuse_weft_0 + _S542.warp_1.specular_transmit_0 * _S541.specular_warp_0 + _S542.weft_1.specular_transmit_0 * _S541.specular_weft_0;
    }
    else
    {
        body_0 = _S545;
    }
    float _S547 = fabrics_0._data[uint(_S540)].sheen_strength_0;
    if((fabrics_0._data[uint(_S540)].sheen_strength_0) <= 0.0)
    {
        return body_0;
    }
    bool _S548 = _S546 < 0.0;
    vec2 _S549 = sheen_with_transmittance_0(to_face_frame_0(_S543, _S548), to_face_frame_0(_S544, _S548), _S547, fabrics_0._data[uint(_S540)].sheen_roughness_0);
    return _S549.y * body_0 + (_S541.light_visibility_1 + _S541.hole_2) * _S549.x;
}

vec4 light_of_woven_0(int _S550, uint _S551, VisiblePoint_0 _S552, uvec2 _S553, vec3 _S554)
{
    Footprint_0 footprint_1;
    footprint_1.centre_0 = _S552.draft_0;
    footprint_1.dx_0 = _S552.draft_dx_0;
    footprint_1.dy_0 = _S552.draft_dy_0;
    vec3 _S555 = to_local_0(_S552, _S552.view_0);
    WovenView_0 activations_0;
    woven_view_0(_S551, footprint_1, _S555, activations_0);
    float _S556 = _S555.z;
    FamilyAlbedos_0 _S557 = albedos_over_0(_S551, footprint_1, _S556 < 0.0);
    FamilyAlbedos_0 albedos_5;
    albedos_5.warp_1 = tinted_0(_S557.warp_1, _S554);
    albedos_5.weft_1 = tinted_0(_S557.weft_1, _S554);
    const vec3 _S558 = vec3(0.0);
    uint number_4 = 0U;
    vec3 radiance_1 = _S558;
    for(;;)
    {
        if(number_4 < (light_sample_count_0(_S550)))
        {
        }
        else
        {
            break;
        }
        float _S559 = visibility_at_0(_S550, number_4, _S553);
        if(_S559 <= 0.0)
        {
            number_4 = number_4 + 1U;
            continue;
        }
        LightSample_0 _S560 = light_sample_0(_S550, number_4, _S553, _S552.position_0);
        vec3 _S561 = to_local_0(_S552, _S560.towards_0);
        Components_0 _S562 = woven_components_0(_S551, activations_0, _S561);
        radiance_1 = radiance_1 + _S559 * _S560.irradiance_1 * composed_0(_S551, _S562, albedos_5, _S561, _S555);
        number_4 = number_4 + 1U;
    }
    float hole_3 = activations_0.hole_0;
    float _S563 = fabrics_0._data[uint(_S551)].sheen_strength_0;
    float hole_4;
    if((fabrics_0._data[uint(_S551)].sheen_strength_0) > 0.0)
    {
        hole_4 = hole_3 * (1.0 - _S563 * sheen_lobe_0(abs(_S556), fabrics_0._data[uint(_S551)].sheen_roughness_0).z);
    }
    else
    {
        hole_4 = hole_3;
    }
    return vec4(radiance_1, 1.0 - hole_4);
}

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;
void main()
{
    uint _S564 = frames_0._data[uint(0)].width_0;
    bool _S565;
    if((gl_GlobalInvocationID.x) >= (frames_0._data[uint(0)].width_0))
    {
        _S565 = true;
    }
    else
    {
        _S565 = (gl_GlobalInvocationID.y) >= (frames_0._data[uint(0)].height_0);
    }
    if(_S565)
    {
        return;
    }
    uint _S566 = gl_GlobalInvocationID.y * _S564 + gl_GlobalInvocationID.x;
    uint _S567 = layers_0._data[uint(_S566)].face_0;
    if((layers_0._data[uint(_S566)].face_0) == 0U)
    {
        return;
    }
    uint _S568 = _S567 - 1U;
    uint _S569 = face_fabrics_0._data[uint(_S568)];
    VisiblePoint_0 _S570 = visible_point_0(0, _S569, _S568, gl_GlobalInvocationID.xy);
    accumulate_0(_S566, light_of_woven_0(0, _S569, _S570, gl_GlobalInvocationID.xy, filtered_albedo_0(_S569, _S570)));
    return;
}

