#version 450
#extension GL_EXT_samplerless_texture_functions : require
layout(row_major) uniform;
layout(row_major) buffer;
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

layout(std430, binding = 4) readonly buffer StructuredBuffer_Frame_t_0 {
    Frame_0 _data[];
} frames_0;
layout(binding = 11)
uniform utexture2D visible_faces_0;

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

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Woven_0 woven_0;
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
layout(std430, binding = 10) readonly buffer StructuredBuffer_vectorx3Cuintx2C4x3E_t_0 {
    uvec4 _data[];
} packed_numbers_0;
layout(std430, binding = 2) readonly buffer StructuredBuffer_uint_t_2 {
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

vec3 saturate_0(vec3 x_4)
{
    return clamp(x_4, vec3(0.0), vec3(1.0));
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

vec3 camera_right_0(Frame_0 frame_0)
{
    return vec3(frame_0.right_x_0, frame_0.right_y_0, frame_0.right_z_0);
}

vec3 camera_up_0(Frame_0 frame_1)
{
    return vec3(frame_1.up_x_0, frame_1.up_y_0, frame_1.up_z_0);
}

vec3 camera_forward_0(Frame_0 frame_2)
{
    return vec3(frame_2.forward_x_0, frame_2.forward_y_0, frame_2.forward_z_0);
}

vec3 camera_origin_0(Frame_0 frame_3)
{
    return vec3(frame_3.origin_x_0, frame_3.origin_y_0, frame_3.origin_z_0);
}

vec3 normal_of_0(Vertex_0 vertex_1)
{
    return vec3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

struct VisiblePoint_0
{
    vec3 position_0;
    vec3 view_0;
    vec3 axis_x_0;
    vec3 axis_y_0;
    vec3 normal_0;
    vec2 draft_0;
    vec2 draft_dx_0;
    vec2 draft_dy_0;
};

vec3 to_local_0(VisiblePoint_0 point_0, vec3 direction_0)
{
    return vec3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

float square_1(float x_5)
{
    return x_5 * x_5;
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
    float _S161 = square_1(4.0);
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
    return sqrt(sqrt(max((12.0 * (_S169 * _S169 + _S170 * _S170) + _S172) * (12.0 * (_S173 * _S173 + _S174 * _S174) + _S172) - _S175 * _S175, square_1(_S172))));
}

float natural_logarithm_0(float x_6)
{
    uint _S176 = floatBitsToUint(x_6);
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

vec3 to_face_frame_0(vec3 direction_1, bool back_0)
{
    vec2 _S178 = direction_1.xy;
    float _S179;
    if(back_0)
    {
        _S179 = - direction_1.z;
    }
    else
    {
        _S179 = direction_1.z;
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

float binary_logarithm_0(float x_7)
{
    return natural_logarithm_0(x_7) * 1.4426950216293335;
}

bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 this_3)
{
    const vec2 _S181 = vec2(0.0);
    bool _S182;
    if((any(bvec2((notEqual(this_3.first_19,_S181))))))
    {
        _S182 = true;
    }
    else
    {
        _S182 = (any(bvec2((notEqual(this_3.second_0,_S181)))));
    }
    return _S182;
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

vec2 turns_and_remainder_0(uint family_0, float index_2)
{
    float _S186 = floor(fma(index_2, families_0._data[uint(family_0)].inverse_count_0, families_0._data[uint(family_0)].half_inverse_count_0));
    return vec2(_S186, fma(- _S186, families_0._data[uint(family_0)].count_0, index_2));
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
    float _S187 = floor(position_1 * families_0._data[uint(family_1)].inverse_size_0);
    Cell_0 cell_0;
    float _S188 = fma(- _S187, families_0._data[uint(family_1)].size_0, position_1);
    cell_0.below_0 = _S188;
    cell_0.above_0 = families_0._data[uint(family_1)].size_0 - _S188;
    cell_0.across_0 = _S188 - 0.5 * families_0._data[uint(family_1)].size_0;
    cell_0.half_width_1 = families_0._data[uint(family_1)].half_width_0;
    cell_0.thread_0 = uint(clamp(turns_and_remainder_0(family_1, _S187).y, 0.0, families_0._data[uint(family_1)].count_0 - 1.0));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0._data[uint(family_2)].start_0) * families_0._data[uint(family_2)].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S189 = turns_1 * families_0._data[uint(family_2)].period_0;
    uint thread_1 = words_0._data[uint(families_0._data[uint(family_2)].first_thread_table_0 + uint(clamp(turns_1 * families_0._data[uint(family_2)].bins_0, 0.0, families_0._data[uint(family_2)].bins_0 - 1.0)))];
    uint _S190;
    if(_S189 >= (table_number_0(families_0._data[uint(family_2)].place_table_0 + thread_1 * 4U + 1U)))
    {
        _S190 = 1U;
    }
    else
    {
        _S190 = 0U;
    }
    uint _S191 = min(thread_1 + _S190, uint(families_0._data[uint(family_2)].count_0) - 1U);
    uint _S192 = families_0._data[uint(family_2)].place_table_0 + _S191 * 4U;
    Cell_0 cell_1;
    cell_1.thread_0 = _S191;
    cell_1.below_0 = _S189 - table_number_0(_S192);
    cell_1.above_0 = table_number_0(_S192 + 1U) - _S189;
    cell_1.across_0 = _S189 - table_number_0(_S192 + 2U);
    cell_1.half_width_1 = table_number_0(_S192 + 3U);
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
    Cell_0 _S193 = locate_0(family_4, position_4);
    float _S194 = table_number_0(families_0._data[uint(family_4)].before_0 + 2U * _S193.thread_0 + 1U);
    Bound_0 bound_0;
    bound_0.thread_2 = _S193.thread_0;
    bound_0.turns_2 = round((position_4 - families_0._data[uint(family_4)].start_0 - _S194 - _S193.below_0) * families_0._data[uint(family_4)].inverse_period_0);
    bound_0.cell_2 = _S193.below_0;
    float _S195 = 2.0 * _S193.half_width_1;
    bound_0.width_1 = _S195;
    bound_0.visible_0 = clamp((_S193.across_0 + _S193.half_width_1) / _S195, 0.0, 1.0);
    bound_0.gap_0 = min(_S193.below_0, _S193.below_0 - _S193.across_0 - _S193.half_width_1) + max(_S193.across_0 - _S193.half_width_1, 0.0);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S196 = centre_2 - floor((centre_2 - families_0._data[uint(family_5)].start_0) * families_0._data[uint(family_5)].inverse_period_0) * families_0._data[uint(family_5)].period_0;
    float _S197 = 0.5 * max(size_1, families_0._data[uint(family_5)].smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_7 = bound_at_0(family_5, _S196 - _S197);
    stretch_0.high_7 = bound_at_0(family_5, _S196 + _S197);
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
    float _S198 = Stretch_turns_0(stretch_1);
    uint _S199 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.low_7.thread_2;
    uint _S200 = families_0._data[uint(family_6)].before_0 + 2U * stretch_1.high_7.thread_2;
    float _S201 = table_number_0(_S200) - table_number_0(_S199);
    float _S202 = table_number_0(_S200 + 1U) - table_number_0(_S199 + 1U);
    return vec3(_S201 + stretch_1.high_7.visible_0 * stretch_1.high_7.width_1 - stretch_1.low_7.visible_0 * stretch_1.low_7.width_1 + _S198 * families_0._data[uint(family_6)].visible_total_0, _S202 - _S201 + stretch_1.high_7.gap_0 - stretch_1.low_7.gap_0 + _S198 * (families_0._data[uint(family_6)].period_0 - families_0._data[uint(family_6)].visible_total_0), _S202 + stretch_1.high_7.cell_2 - stretch_1.low_7.cell_2 + _S198 * families_0._data[uint(family_6)].period_0);
}

vec2 integrals_along_0(uint family_7, Stretch_0 stretch_2, uint quantity_0)
{
    Family_0 _S203 = families_0._data[uint(family_7)];
    uint _S204 = 3U * _S203.quantities_0;
    uint _S205 = families_0._data[uint(family_7)].colour_threads_0 + _S204 * stretch_2.low_7.thread_2 + quantity_0;
    uint _S206 = families_0._data[uint(family_7)].colour_threads_0 + _S204 * stretch_2.high_7.thread_2 + quantity_0;
    uint _S207 = families_0._data[uint(family_7)].colour_threads_0 + _S204 * uint(families_0._data[uint(family_7)].count_0) + quantity_0;
    float _S208 = table_number_0(_S205);
    float _S209 = table_number_0(_S206);
    float _S210 = Stretch_turns_0(stretch_2);
    uint _S211 = 2U * _S203.quantities_0;
    return vec2(table_number_0(_S206 + _S203.quantities_0) - table_number_0(_S205 + _S203.quantities_0) + _S209 * stretch_2.high_7.visible_0 * stretch_2.high_7.width_1 - _S208 * stretch_2.low_7.visible_0 * stretch_2.low_7.width_1 + _S210 * table_number_0(_S207 + _S203.quantities_0), table_number_0(_S206 + _S211) - table_number_0(_S205 + _S211) + _S209 * stretch_2.high_7.cell_2 - _S208 * stretch_2.low_7.cell_2 + _S210 * table_number_0(_S207 + _S211));
}

bool Stretch_wraps_0(Stretch_0 this_6)
{
    return (this_6.high_7.thread_2) < (this_6.low_7.thread_2);
}

uvec4 Stretch_differences_0(Stretch_0 this_7, uvec4 entries_0, uint whole_0)
{
    uint _S212 = entries_0.z;
    uint _S213 = entries_0.x;
    uint _S214 = _S212 - _S213;
    uint _S215;
    if(Stretch_wraps_0(this_7))
    {
        _S215 = whole_0;
    }
    else
    {
        _S215 = 0U;
    }
    return uvec4(_S214 + _S215, entries_0.w - _S212, entries_0.y - _S213, whole_0);
}

uvec4 row_differences_0(Stretch_0 across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S216 = row_7 + across_1.low_7.thread_2 * quantities_1;
    uint _S217 = row_7 + across_1.high_7.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, uvec4(words_0._data[uint(_S216)], words_0._data[uint(_S216 + quantities_1)], words_0._data[uint(_S217)], words_0._data[uint(_S217 + quantities_1)]), words_0._data[uint(row_7 + count_2 * quantities_1)]);
}

vec4 Stretch_weights_0(Stretch_0 this_8)
{
    float _S218 = - this_8.low_7.visible_0;
    float _S219 = Stretch_turns_0(this_8);
    float _S220;
    if(Stretch_wraps_0(this_8))
    {
        _S220 = 1.0;
    }
    else
    {
        _S220 = 0.0;
    }
    return vec4(1.0, this_8.high_7.visible_0, _S218, _S219 - _S220);
}

float integral_on_top_0(uint family_8, Stretch_0 across_2, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S221 = uint(families_0._data[uint(family_8)].count_0);
    uint _S222 = (_S221 + 1U) * families_0._data[uint(family_8)].quantities_0;
    uint _S223 = families_0._data[uint(family_8)].colour_areas_0 + quantity_1;
    uvec4 _S224 = row_differences_0(across_2, _S223 + along_0.low_7.thread_2 * _S222, _S221, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S225 = row_differences_0(across_2, _S223 + (along_0.low_7.thread_2 + 1U) * _S222, _S221, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S226 = row_differences_0(across_2, _S223 + along_0.high_7.thread_2 * _S222, _S221, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S227 = row_differences_0(across_2, _S223 + (along_0.high_7.thread_2 + 1U) * _S222, _S221, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S228 = row_differences_0(across_2, _S223 + crossing_count_0 * _S222, _S221, families_0._data[uint(family_8)].quantities_0);
    uvec4 _S229 = _S226 - _S224;
    uvec4 _S230;
    if(Stretch_wraps_0(along_0))
    {
        _S230 = _S228;
    }
    else
    {
        _S230 = uvec4(ivec4(0));
    }
    vec4 _S231 = Stretch_weights_0(across_2);
    return dot(vec4(dot(vec4(ivec4(_S229 + _S230)), _S231), dot(vec4(ivec4(_S227 - _S226)), _S231), dot(vec4(ivec4(_S225 - _S224)), _S231), dot(vec4(ivec4(_S228)), _S231)), Stretch_weights_0(along_0)) * families_0._data[uint(family_8)].area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S232 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_0 * _S232.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_0 * _S232.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_0 * _S232.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_0 * _S232.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 own_0, Stretch_0 other_0, bool back_1)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0._data[uint(family_9)].colour_mean_0);
    if((families_0._data[uint(family_9)].quantities_0) == 1U)
    {
        return albedos_2;
    }
    vec3 _S233 = lengths_0(crossing_0, other_0);
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
        vec2 _S234 = integrals_along_0(family_9, own_0, quantity_2);
        float _S235 = integral_on_top_0(family_9, own_0, other_0, uint(families_0._data[uint(crossing_0)].count_0), quantity_2);
        float _S236 = _S234.x;
        float _S237 = _S236 * _S233.x;
        float _S238;
        if(back_1)
        {
            _S238 = _S237 - _S235;
        }
        else
        {
            _S238 = _S235;
        }
        bool _S239 = quantity_2 == 0U;
        if(_S239)
        {
            is_exposed_0 = _S238 > (16.0 * families_0._data[uint(family_9)].area_unit_0 * min(_S237 / families_0._data[uint(family_9)].crossing_area_0, 1.0) + 0.00000999999974738 * _S237);
        }
        float _S240 = _S236 * _S233.y;
        float _S241;
        if(is_exposed_0)
        {
            _S241 = _S238;
        }
        else
        {
            _S241 = 0.0;
        }
        float _S242 = _S240 + _S241 + 0.000244140625 * _S233.z * _S234.y;
        if(_S239)
        {
            weight_1 = 1.0 / max(_S242, 9.99999968265522539e-21);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S242 * weight_1, families_0._data[uint(family_9)].colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate_0(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate_0(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate_0(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate_0(albedos_2.specular_transmit_0);
    return albedos_2;
}

vec3 towards_light_0(Light_0 light_0, vec3 position_5, out vec3 irradiance_1)
{
    irradiance_1 = vec3(light_0.red_0, light_0.green_0, light_0.blue_0);
    vec3 _S243 = vec3(light_0.x_1, light_0.y_1, light_0.z_1);
    if((light_0.is_point_0) == 0U)
    {
        return _S243;
    }
    vec3 _S244 = _S243 - position_5;
    irradiance_1 = irradiance_1 / max(square_0(_S244), 9.999999960041972e-13);
    return normalize(_S244);
}

float exponential_0(float x_8)
{
    float _S245 = clamp(x_8, -87.0, 88.0);
    float _S246 = floor(_S245 * 1.4426950216293335 + 0.5);
    float _S247 = _S245 - _S246 * 0.693359375 + _S246 * 0.00021219444170129;
    float p_0 = ((((0.00019875691214111 * _S247 + 0.00139819993637502) * _S247 + 0.00833345204591751) * _S247 + 0.04166579619050026) * _S247 + 0.1666666567325592) * _S247 + 0.5;
    float _S248 = uintBitsToFloat(uint(int(_S246) + 127) << 23);
    float _S249;
    if(x_8 < -87.0)
    {
        _S249 = 0.0;
    }
    else
    {
        _S249 = (p_0 * _S247 * _S247 + _S247 + 1.0) * _S248;
    }
    return _S249;
}

float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp(output_9, 0.0, 8.0)) - 1.0) * scale_0;
}

uint mirrored_bundle_0(uint bundle_0)
{
    uint _S250 = bundle_0 / 3U;
    uint _S251 = bundle_0 % 3U;
    uint _S252;
    if(bundle_0 == 24U)
    {
        _S252 = bundle_0;
    }
    else
    {
        _S252 = _S250 * 3U + 3U - 1U - _S251;
    }
    return _S252;
}

float light_visibility_of_0(float diffuse_0, vec3 light_1, vec3 view_1, float blend_0)
{
    float _S253 = max(abs(light_1.z), 0.00100000004749745);
    vec2 _S254 = light_1.xy;
    return 3.14159274101257324 * max(diffuse_0, 0.0) / mix(_S253, (0.59700000286102295 * _S253 + 0.16599999368190765) * (0.21600000560283661 * (dot(_S254, view_1.xy) * (inversesqrt((max(dot(_S254, _S254), 9.99999997475242708e-07))))) + 1.0), blend_0);
}

float sheen_scale_0(float x_9, float y_2)
{
    return (((((0.0 * x_9 + (((((-1.1402510404586792 * y_2 + 0.40672621130943298) * y_2 + 1.65398800373077393) * y_2 + -1.29730904102325439) * y_2 + 0.30570998787879944) * y_2 + -0.0220868494361639)) * x_9 + (((((-0.21142719686031342 * y_2 + 1.05947399139404297) * y_2 + -0.41116121411323547) * y_2 + -0.93859231472015381) * y_2 + 0.51606941223144531) * y_2 + 0.05409301072359085)) * x_9 + (((((1.22944498062133789 * y_2 + -0.45962560176849365) * y_2 + -1.63861405849456787) * y_2 + 1.33565104007720947) * y_2 + -0.45725581049919128) * y_2 + 0.08243165910243988)) * x_9 + (((((0.39779931306838989 * y_2 + -1.18879103660583496) * y_2 + 0.28251591324806213) * y_2 + 1.168984055519104) * y_2 + -0.76864629983901978) * y_2 + 0.0091691892594099)) * x_9 + (((((-0.26563560962677002 * y_2 + -0.19379159808158875) * y_2 + 0.2677634060382843) * y_2 + 0.00270519289188087) * y_2 + 0.14349560439586639) * y_2 + 0.10290180146694183)) * x_9 + (((((-0.20701569318771362 * y_2 + 0.24526430666446686) * y_2 + 0.19551840424537659) * y_2 + 0.07586126774549484) * y_2 + 0.38894739747047424) * y_2 + 0.15043120086193085);
}

float sheen_shear_0(float x_10, float y_3)
{
    return ((((0.0 * x_10 + (((((-0.10608240216970444 * y_3 + 1.99214303493499756) * y_3 + -1.42255294322967529) * y_3 + -1.09495604038238525) * y_3 + 0.59180057048797607) * y_3 + 0.06902855634689331)) * x_10 + (((((-0.46220690011978149 * y_3 + -0.29113379120826721) * y_3 + 1.39025199413299561) * y_3 + 0.35589990019798279) * y_3 + -1.17120099067687988) * y_3 + 0.15940259397029877)) * x_10 + (((((2.26068711280822754 * y_3 + -3.64728999137878418) * y_3 + -0.72173482179641724) * y_3 + 3.07659196853637695) * y_3 + -0.6827620267868042) * y_3 + -0.3039557933807373)) * x_10 + (((((0.81201767921447754 * y_3 + 0.36014080047607422) * y_3 + -1.72646903991699219) * y_3 + -0.22630110383033752) * y_3 + 0.89514690637588501) * y_3 + -0.10397960245609283)) * x_10 + (((((-0.37648698687553406 * y_3 + 1.10974001884460449) * y_3 + 0.17824520170688629) * y_3 + -1.04968702793121338) * y_3 + 0.1461234986782074) * y_3 + -0.00475129019469023);
}

float sheen_reflectance_0(float x_11, float y_4)
{
    return ((((0.0 * x_11 + (((((12.95646953582763672 * y_4 + -21.38032913208007812) * y_4 + -7.37853097915649414) * y_4 + 34.55607986450195312) * y_4 + -23.61347007751464844) * y_4 + 5.00126314163208008)) * x_11 + (((((10.91487026214599609 * y_4 + -6.08202791213989258) * y_4 + -38.2036285400390625) * y_4 + 53.3440399169921875) * y_4 + -21.91996002197265625) * y_4 + 2.01606011390686035)) * x_11 + (((((-14.52206039428710938 * y_4 + 36.803619384765625) * y_4 + -22.94047927856445312) * y_4 + -10.07973003387451172) * y_4 + 15.77003955841064453) * y_4 + -4.92722177505493164)) * x_11 + (((((-7.62505722045898438 * y_4 + 1.27310299873352051) * y_4 + 31.19523048400878906) * y_4 + -44.39989852905273438) * y_4 + 26.44947052001953125) * y_4 + -8.73507976531982422)) * x_11 + (((((5.65633487701416016 * y_4 + -17.66820907592773438) * y_4 + 24.65356063842773438) * y_4 + -19.38941001892089844) * y_4 + 11.06159019470214844) * y_4 + -3.06573700904846191);
}

vec3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S255 = clamp(cos_view_0, 0.00999999977648258, 1.0);
    float _S256 = 2.0 * sqrt(_S255) - 1.0;
    float _S257 = 3.0 * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258, 1.0))) - 2.0;
    return vec3(clamp(sheen_scale_0(_S256, _S257), 0.00999999977648258, 1.0), clamp((1.0 - _S255) * sheen_shear_0(_S256, _S257), -0.25, 0.0), 0.80000001192092896 / (1.0 + exponential_0(- clamp(sheen_reflectance_0(_S256, _S257), -60.0, 60.0))));
}

float transformed_cosine_0(vec3 light_2, vec3 view_2, float scale_1, float shear_0)
{
    float _S258 = light_2.z;
    bool _S259;
    if(_S258 <= 0.0)
    {
        _S259 = true;
    }
    else
    {
        _S259 = (view_2.z) <= 0.0;
    }
    if(_S259)
    {
        return 0.0;
    }
    vec2 _S260 = view_2.xy;
    float _S261 = dot(_S260, _S260);
    vec2 _S262;
    if(_S261 > 9.99999968265522539e-21)
    {
        _S262 = _S260 * (inversesqrt((_S261)));
    }
    else
    {
        _S262 = vec2(1.0, 0.0);
    }
    float _S263 = scale_1 * dot(light_2.xy, _S262) + shear_0 * _S258;
    float _S264 = scale_1 * (light_2.y * _S262.x - light_2.x * _S262.y);
    float _S265 = _S263 * _S263 + _S264 * _S264 + _S258 * _S258;
    return 0.31830987334251404 * scale_1 * scale_1 * _S258 / max(_S265 * _S265, 9.99999968265522539e-21);
}

vec2 sheen_with_transmittance_0(vec3 light_3, vec3 view_3, float strength_0, float roughness_2)
{
    vec3 _S266 = sheen_lobe_0(view_3.z, roughness_2);
    float _S267 = strength_0 * _S266.z;
    return vec2(_S267 * transformed_cosine_0(light_3, view_3, _S266.x, _S266.y), 1.0 - _S267);
}

void accumulate_0(Frame_0 frame_4, uvec2 pixel_0, vec4 light_4)
{
    uint _S268 = pixel_0.y * frame_4.width_0 + pixel_0.x;
    float _S269 = light_4.w;
    vec4 _S270 = vec4(light_4.xyz + (1.0 - _S269) * vec3(frame_4.background_red_0, frame_4.background_green_0, frame_4.background_blue_0), _S269);
    vec4 _S271;
    if((frame_4.pass_number_0) == 0U)
    {
        _S271 = _S270;
    }
    else
    {
        _S271 = radiance_0._data[uint(_S268)] + _S270;
    }
    radiance_0._data[uint(_S268)] = _S271;
    return;
}

VisiblePoint_0 visible_point_0(Frame_0 _S272, uint _S273, uint _S274, uvec2 _S275)
{
    uint _S276 = 3U * _S274;
    Vertex_0 _S277 = vertices_0._data[uint(corners_0._data[uint(_S276)])];
    Vertex_0 _S278 = vertices_0._data[uint(corners_0._data[uint(_S276 + 1U)])];
    Vertex_0 _S279 = vertices_0._data[uint(corners_0._data[uint(_S276 + 2U)])];
    vec3 _S280 = position_of_0(_S277);
    vec3 _S281 = position_of_0(_S278) - _S280;
    vec3 _S282 = position_of_0(_S279) - _S280;
    vec3 _S283 = cross(_S281, _S282);
    float _S284 = 1.0 / max(square_0(_S283), 1.00000000317107685e-30);
    float _S285 = float(_S272.width_0);
    vec3 _S286 = camera_right_0(_S272) * (2.0 / _S285);
    float _S287 = float(_S272.height_0);
    vec3 _S288 = camera_up_0(_S272) * (-2.0 / _S287);
    vec3 _S289 = camera_forward_0(_S272) + (float(_S275.x) + 0.5 - 0.5 * _S285) * _S286 + (float(_S275.y) + 0.5 - 0.5 * _S287) * _S288;
    float _S290 = dot(_S289, _S283);
    float _S291;
    if((abs(_S290)) > 1.00000000317107685e-30)
    {
        _S291 = _S290;
    }
    else
    {
        _S291 = 1.00000000317107685e-30;
    }
    float _S292 = 1.0 / _S291;
    vec3 _S293 = _S280 - camera_origin_0(_S272);
    float _S294 = dot(_S293, _S283) * _S292;
    vec3 _S295 = _S289 * _S294 - _S293;
    vec3 _S296 = _S294 * (_S286 - _S289 * (dot(_S286, _S283) * _S292));
    vec3 _S297 = _S294 * (_S288 - _S289 * (dot(_S288, _S283) * _S292));
    vec3 _S298 = cross(_S282, _S283) * _S284;
    vec3 _S299 = cross(_S283, _S281) * _S284;
    float _S300 = dot(_S295, _S298);
    float _S301 = dot(_S295, _S299);
    float _S302 = _S278.u_0 - _S277.u_0;
    float _S303 = _S278.v_0 - _S277.v_0;
    vec2 _S304 = vec2(_S302, _S303);
    float _S305 = _S279.u_0 - _S277.u_0;
    float _S306 = _S279.v_0 - _S277.v_0;
    vec2 _S307 = vec2(_S305, _S306);
    vec2 _S308 = vec2(_S277.u_0, _S277.v_0) + _S300 * _S304 + _S301 * _S307;
    vec2 _S309 = dot(_S296, _S298) * _S304 + dot(_S296, _S299) * _S307;
    vec2 _S310 = dot(_S297, _S298) * _S304 + dot(_S297, _S299) * _S307;
    if((_S302 * _S306 - _S303 * _S305) < 0.0)
    {
        _S291 = -1.0;
    }
    else
    {
        _S291 = 1.0;
    }
    vec3 _S311 = _S291 * (_S306 * _S281 - _S303 * _S282);
    vec3 _S312 = _S291 * (_S302 * _S282 - _S305 * _S281);
    VisiblePoint_0 point_1;
    vec3 _S313 = normalize((1.0 - _S300 - _S301) * normal_of_0(_S277) + _S300 * normal_of_0(_S278) + _S301 * normal_of_0(_S279));
    point_1.normal_0 = _S313;
    vec3 _S314 = normalize(_S311 - _S313 * dot(_S313, _S311));
    point_1.axis_x_0 = _S314;
    point_1.axis_y_0 = cross(_S313, _S314);
    point_1.position_0 = _S280 + _S295;
    point_1.view_0 = - normalize(_S289);
    bool _S315 = (dot(cross(_S311, _S312), _S313)) < 0.0;
    float _S316 = fabrics_0._data[uint(_S273)].uv_width_0;
    if(_S315)
    {
        _S291 = - fabrics_0._data[uint(_S273)].uv_height_0;
    }
    else
    {
        _S291 = fabrics_0._data[uint(_S273)].uv_height_0;
    }
    vec2 _S317 = vec2(_S316, _S291);
    vec2 _S318 = _S308 * _S317;
    if(_S315)
    {
        _S291 = fabrics_0._data[uint(_S273)].uv_height_0;
    }
    else
    {
        _S291 = 0.0;
    }
    point_1.draft_0 = _S318 + vec2(0.0, _S291);
    point_1.draft_dx_0 = _S309 * _S317;
    point_1.draft_dy_0 = _S310 * _S317;
    return point_1;
}

struct WovenView_0
{
    float  sums_6[96];
    float hole_0;
    float correction_weight_0;
    vec3 view_4;
    bool back_2;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S319, Footprint_0 _S320)
{
    vec3 _S321 = row_of_taps_0(_S320);
    vec2 _S322 = _S320.dx_0;
    vec2 _S323 = _S320.dy_0;
    float _S324 = dot(_S322, _S322) + dot(_S323, _S323);
    float _S325 = _S320.dx_0.x * _S320.dy_0.y - _S320.dx_0.y * _S320.dy_0.x;
    float _S326 = 0.5 * (_S324 + sqrt(max(_S324 * _S324 - 4.0 * _S325 * _S325, 0.0)));
    Woven_0 _S327 = fabrics_0._data[uint(_S319)].woven_0;
    bool _S328;
    if(_S326 < (5.5 * (_S324 - _S326)))
    {
        _S328 = _S324 > (8.0 * _S327.pitch_0 * _S327.pitch_0);
    }
    else
    {
        _S328 = false;
    }
    vec2 _S329 = vec2(_S327.ends_per_mm_0, _S327.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    taps_1.centre_1 = _S320.centre_0 * _S329;
    float _S330;
    if(_S328)
    {
        _S330 = sqrt(0.125 * _S324);
    }
    else
    {
        _S330 = _S321.x;
    }
    taps_1.side_0 = _S330 / _S327.pitch_0;
    vec2 _S331;
    if(_S328)
    {
        _S331 = 0.25 * _S320.dx_0;
    }
    else
    {
        _S331 = _S321.yz;
    }
    taps_1.first_19 = _S331 * _S329;
    if(_S328)
    {
        _S331 = 0.25 * _S320.dy_0;
    }
    else
    {
        _S331 = 0.5 * _S321.yz;
    }
    taps_1.second_0 = _S331 * _S329;
    return taps_1;
}

void add_texel_0(uint _S332, uint _S333, float _S334, inout float  _S335[88])
{
    uint _S336 = fabrics_0._data[uint(_S332)].woven_0.latents_0 + _S333 * 8U;
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
        Eight_0 _S337 = eight_halves_0(packed_numbers_0._data[uint(_S336 + part_0)]);
        int _S338 = int(8U * part_0);
        _S335[_S338] = _S335[_S338] + _S334 * _S337.low_0[0];
        _S335[_S338 + 4] = _S335[_S338 + 4] + _S334 * _S337.high_0[0];
        int _S339 = _S338 + 1;
        _S335[_S339] = _S335[_S339] + _S334 * _S337.low_0[1];
        _S335[_S339 + 4] = _S335[_S339 + 4] + _S334 * _S337.high_0[1];
        int _S340 = _S338 + 2;
        _S335[_S340] = _S335[_S340] + _S334 * _S337.low_0[2];
        _S335[_S340 + 4] = _S335[_S340 + 4] + _S334 * _S337.high_0[2];
        int _S341 = _S338 + 3;
        _S335[_S341] = _S335[_S341] + _S334 * _S337.low_0[3];
        _S335[_S341 + 4] = _S335[_S341 + 4] + _S334 * _S337.high_0[3];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S342, uint _S343, bool _S344, vec2 _S345, float _S346, inout float  _S347[88])
{
    Woven_0 _S348 = fabrics_0._data[uint(_S342)].woven_0;
    uint _S349 = fabrics_0._data[uint(_S342)].woven_0.levels_1 + 4U * _S343;
    float _S350 = table_number_0(_S349);
    float _S351 = table_number_0(_S349 + 1U);
    float _S352 = table_number_0(_S349 + 2U);
    bool _S353;
    if(_S343 > 3U)
    {
        _S353 = _S343 < (_S348.top_level_0);
    }
    else
    {
        _S353 = false;
    }
    vec2 _S354 = _S345 * table_number_0(_S349 + 3U);
    float _S355;
    if(_S353)
    {
        _S355 = 1.0;
    }
    else
    {
        _S355 = 0.5;
    }
    vec2 _S356 = _S354 - _S355;
    vec2 _S357 = floor(_S356);
    vec2 _S358 = _S356 - _S357;
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
        float _S359 = float(corner_0 & 1U);
        float _S360 = float(corner_0 >> 1);
        vec2 _S361 = mix(1.0 - _S358, _S358, vec2(_S359, _S360));
        uint _S362 = uint(_S350 + wrapped_0(_S357.y + _S360, _S352) * _S351 + wrapped_0(_S357.x + _S359, _S351));
        uint _S363;
        if(_S344)
        {
            _S363 = _S348.texels_0;
        }
        else
        {
            _S363 = 0U;
        }
        add_texel_0(_S342, _S362 + _S363, _S346 * _S361.x * _S361.y, _S347);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S364, AnisotropicTaps_0 _S365, vec3 _S366, bool _S367, inout float  _S368[88])
{
    float offset_0;
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
        _S368[k_0] = 0.0;
        k_0 = k_0 + 1;
    }
    vec2 _S369 = vec2(fabrics_0._data[uint(_S364)].woven_0.ends_0, fabrics_0._data[uint(_S364)].woven_0.picks_0);
    float _S370 = float(fabrics_0._data[uint(_S364)].woven_0.top_level_0);
    float _S371 = clamp(binary_logarithm_0(max(_S365.side_0, 9.99999997475242708e-07)) + 3.0, 0.0, _S370);
    float _S372 = min(floor(_S371), _S370 - 1.0);
    uint _S373;
    if(AnisotropicTaps_has_steps_0(_S365))
    {
        _S373 = 4U;
    }
    else
    {
        _S373 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S373))
        {
        }
        else
        {
            break;
        }
        vec2 _S374 = AnisotropicTaps_place_0(_S365, number_1 >> 1);
        vec2 _S375 = clamp(_S374 - _S369 * floor(_S374 / _S369), vec2(0.0), _S369);
        bool _S376 = (number_1 & 1U) != 0U;
        if(_S376)
        {
            offset_0 = _S371 - _S372;
        }
        else
        {
            offset_0 = 1.0 - (_S371 - _S372);
        }
        float _S377 = offset_0 / float(_S373);
        uint _S378 = uint(_S372);
        uint _S379;
        if(_S376)
        {
            _S379 = 1U;
        }
        else
        {
            _S379 = 0U;
        }
        add_level_0(_S364, _S378 + _S379, _S367, _S375, _S377, _S368);
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
            float offset_1 = _S366[number_2] - (float(bin_0) + 0.5) / 8.0;
            if(number_2 < 2)
            {
                offset_0 = offset_1 - round(offset_1);
            }
            else
            {
                offset_0 = offset_1;
            }
            _S368[64 + number_2 * 8 + bin_0] = bump_0(offset_0 * 3.20000004768371582);
            bin_0 = bin_0 + 1;
        }
        number_2 = number_2 + 1;
    }
    return;
}

vec3 crown_fibres_0(uint _S380, bool _S381, bool _S382)
{
    float _S383;
    if(_S381)
    {
        if(_S382)
        {
            _S383 = - fabrics_0._data[uint(_S380)].woven_0.warp_x_0;
        }
        else
        {
            _S383 = fabrics_0._data[uint(_S380)].woven_0.warp_x_0;
        }
        return vec3(_S383, fabrics_0._data[uint(_S380)].woven_0.warp_y_0, fabrics_0._data[uint(_S380)].woven_0.warp_roughness_0);
    }
    Woven_0 _S384 = fabrics_0._data[uint(_S380)].woven_0;
    if(_S382)
    {
        _S383 = - _S384.weft_y_0;
    }
    else
    {
        _S383 = _S384.weft_y_0;
    }
    return vec3(_S384.weft_x_0, _S383, _S384.weft_roughness_0);
}

void woven_view_0(uint _S385, Footprint_0 _S386, vec3 _S387, inout WovenView_0 _S388)
{
    bool _S389 = (_S387.z) < 0.0;
    AnisotropicTaps_0 _S390 = anisotropic_taps_0(_S385, _S386);
    vec3 _S391 = footprint_coordinates_0(_S390);
    vec3 _S392 = to_face_frame_0(_S387, _S389);
    HalfWeights_0 weights_23;
    weights_23.first_2 = fabrics_0._data[uint(_S385)].woven_0.network_0;
    float  inputs_23[88];
    code_footprint_0(_S385, _S390, _S391, _S389, inputs_23);
    float  hidden_0[96];
    dense_7(weights_23, 0U, false, inputs_23, hidden_0);
    float  fused_0[100];
    dense_part_8(weights_23, 1068U, false, hidden_0, fused_0);
    fused_0[96] = _S392.x;
    fused_0[97] = _S392.y;
    vec2 _S393 = _S392.xy;
    fused_0[98] = dot(crown_fibres_0(_S385, true, _S389).xy, _S393);
    fused_0[99] = dot(crown_fibres_0(_S385, false, _S389).xy, _S393);
    float  of_hole_0[16];
    dense_6(weights_23, 2232U, false, fused_0, of_hole_0);
    float  hole_1[1];
    dense_5(weights_23, 2444U, false, of_hole_0, hole_1);
    dense_4(weights_23, 2456U, false, fused_0, _S388.sums_6);
    _S388.hole_0 = clamp(hole_1[0], 0.0, 1.0);
    _S388.correction_weight_0 = correction_weight_of_0(_S391.z);
    _S388.view_4 = _S392;
    _S388.back_2 = _S389;
    return;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_1;
    Albedos_0 weft_1;
};

FamilyAlbedos_0 albedos_over_0(uint _S394, Footprint_0 _S395, bool _S396)
{
    vec2 _S397 = _S395.dx_0;
    vec2 _S398 = _S395.dy_0;
    vec2 _S399 = sqrt(_S397 * _S397 + _S398 * _S398);
    Stretch_0 _S400 = stretch_of_0(fabrics_0._data[uint(_S394)].warp_0, _S395.centre_0.x, _S399.x);
    Stretch_0 _S401 = stretch_of_0(fabrics_0._data[uint(_S394)].weft_0, _S395.centre_0.y, _S399.y);
    FamilyAlbedos_0 albedos_3;
    albedos_3.warp_1 = mean_albedos_0(fabrics_0._data[uint(_S394)].warp_0, fabrics_0._data[uint(_S394)].weft_0, _S400, _S401, _S396);
    albedos_3.weft_1 = mean_albedos_0(fabrics_0._data[uint(_S394)].weft_0, fabrics_0._data[uint(_S394)].warp_0, _S401, _S400, _S396);
    return albedos_3;
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

void code_light_0(uint _S402, vec3 _S403, vec3 _S404, bool _S405, inout float  _S406[39])
{
    _S406[0] = _S403.x;
    _S406[1] = _S403.y;
    _S406[2] = _S403.z;
    vec3 _S407 = _S403 + _S404;
    float _S408 = _S407.z;
    float _S409 = _S408 * _S408 + 0.00009999999747379;
    vec2 _S410 = _S407.xy;
    float _S411 = 1.0 / (dot(_S410, _S410) + _S409);
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
        vec3 _S412 = crown_fibres_0(_S402, family_10 == 0, _S405);
        vec2 _S413 = _S412.xy;
        _S406[3 + family_10] = dot(_S413, _S403.xy);
        float _S414 = dot(_S413, _S410);
        float _S415 = _S414 * _S414;
        float _S416 = (0.75 * _S414 / (0.5 * sqrt(_S415 + _S409) + abs(_S414)) + 0.5) * 8.0;
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
            _S406[5 + family_10 * 16 + bin_1] = bump_0(_S416 - (float(bin_1) + 0.5) / 2.0);
            bin_1 = bin_1 + 1;
        }
        float _S417 = _S412.z;
        float _S418 = _S417 * _S417;
        float _S419 = _S415 * _S411 * (1.0 - _S418) + _S418;
        _S406[37 + family_10] = 0.25 * natural_logarithm_0(1.0 + 9.54929637908935547 * _S418 * _S417 / (_S419 * _S419));
        family_10 = family_10 + 1;
    }
    return;
}

float mixed_bundles_0(uint _S420, uint _S421, uint _S422, vec3 _S423, vec3 _S424, bool _S425, inout float  _S426[52])
{
    vec3 _S427 = _S423 + _S424;
    float _S428 = 1.0 / (square_0(_S427) + 0.00009999999747379);
    bool _S429;
    if(_S421 == 0U)
    {
        _S429 = _S425;
    }
    else
    {
        _S429 = false;
    }
    float _S430;
    if(_S429)
    {
        _S430 = - _S427.x;
    }
    else
    {
        _S430 = _S427.x;
    }
    if(_S421 == 1U)
    {
        _S429 = _S425;
    }
    else
    {
        _S429 = false;
    }
    float _S431;
    if(_S429)
    {
        _S431 = - _S427.y;
    }
    else
    {
        _S431 = _S427.y;
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
        uint _S432 = _S421 * 25U;
        uint _S433 = fabrics_0._data[uint(_S420)].woven_0.bundles_0 + 4U * (_S432 + bundle_1);
        float _S434 = dot(vec3(table_number_0(_S433), table_number_0(_S433 + 1U), table_number_0(_S433 + 2U)), vec3(_S430, _S431, _S427.z));
        float _S435 = _S434 * _S434 * _S428 + table_number_0(_S433 + 3U);
        uint _S436 = _S422 + _S432;
        uint _S437;
        if(_S425)
        {
            _S437 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S437 = bundle_1;
        }
        float sum_2 = sum_1 + max(_S426[_S436 + _S437], _S426[_S436 + _S437] * 0.00999999977648258) / (_S435 * _S435);
        bundle_1 = bundle_1 + 1U;
        sum_1 = sum_2;
    }
    return 0.01999999955296516 * sum_1;
}

Components_0 woven_components_0(uint _S438, inout WovenView_0 _S439, vec3 _S440)
{
    float _S441;
    bool _S442 = _S439.back_2;
    vec3 _S443 = to_face_frame_0(_S440, _S439.back_2);
    vec3 _S444 = _S439.view_4;
    HalfWeights_0 weights_24;
    Woven_0 _S445 = fabrics_0._data[uint(_S438)].woven_0;
    weights_24.first_2 = fabrics_0._data[uint(_S438)].woven_0.network_0;
    float  directions_0[39];
    code_light_0(_S438, _S443, _S439.view_4, _S439.back_2, directions_0);
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
        skip_0[k_1] = _S439.sums_6[k_1];
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
                _S441 = skip_0[k_1];
            }
            else
            {
                _S441 = 0.0;
            }
            next_0[k_1] = _S441;
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
    bool _S446;
    if((_S445.is_corrected_0) != 0U)
    {
        _S446 = (_S443.z) > 0.0;
    }
    else
    {
        _S446 = false;
    }
    if(_S446)
    {
        _S446 = (_S439.correction_weight_0) > 0.0;
    }
    else
    {
        _S446 = false;
    }
    if(_S446)
    {
        FloatWeights_0 fitted_0;
        fitted_0.first_0 = _S445.correction_0;
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
            outputs_17[k_1 + 2] = outputs_17[k_1 + 2] + _S439.correction_weight_0 * change_0[k_1];
            k_1 = k_1 + 1;
        }
    }
    if((_S443.z) > 0.0)
    {
        _S441 = 0.00999999977648258;
    }
    else
    {
        _S441 = 0.00100000004749745;
    }
    Components_0 result_0;
    float _S447 = unmapped_0(outputs_17[0], _S441);
    result_0.diffuse_warp_0 = _S447;
    float _S448 = unmapped_0(outputs_17[1], _S441);
    result_0.diffuse_weft_0 = _S448;
    float _S449 = 2979.9580078125 * _S441;
    float _S450 = mixed_bundles_0(_S438, 0U, 2U, _S443, _S444, _S442, outputs_17);
    result_0.specular_warp_0 = clamp(_S450, 0.0, _S449);
    float _S451 = mixed_bundles_0(_S438, 1U, 2U, _S443, _S444, _S442, outputs_17);
    result_0.specular_weft_0 = clamp(_S451, 0.0, _S449);
    result_0.hole_2 = _S439.hole_0;
    result_0.light_visibility_1 = min(light_visibility_of_0(_S447 + _S448, _S443, _S444, fabrics_0._data[uint(_S438)].diffuse_blend_0), 1.0 - _S439.hole_0);
    return result_0;
}

vec3 composed_0(uint _S452, Components_0 _S453, FamilyAlbedos_0 _S454, vec3 _S455, vec3 _S456)
{
    vec3 _S457 = _S454.warp_1.diffuse_reflect_0 * _S453.diffuse_warp_0 + _S454.weft_1.diffuse_reflect_0 * _S453.diffuse_weft_0 + _S454.warp_1.specular_reflect_0 * _S453.specular_warp_0 + _S454.weft_1.specular_reflect_0 * _S453.specular_weft_0;
    float _S458 = _S456.z;
    vec3 body_0;
    if((_S455.z * _S458) < 0.0)
    {
        body_0 = _S454.warp_1.diffuse_transmit_0 * _S453.diffuse_warp_0 + _S454.weft_1.diffuse_transmit_0 * _S453.diffuse_weft_0 + _S454.warp_1.specular_transmit_0 * _S453.specular_warp_0 + _S454.weft_1.specular_transmit_0 * _S453.specular_weft_0;
    }
    else
    {
        body_0 = _S457;
    }
    float _S459 = fabrics_0._data[uint(_S452)].sheen_strength_0;
    if((fabrics_0._data[uint(_S452)].sheen_strength_0) <= 0.0)
    {
        return body_0;
    }
    bool _S460 = _S458 < 0.0;
    vec2 _S461 = sheen_with_transmittance_0(to_face_frame_0(_S455, _S460), to_face_frame_0(_S456, _S460), _S459, fabrics_0._data[uint(_S452)].sheen_roughness_0);
    return _S461.y * body_0 + (_S453.light_visibility_1 + _S453.hole_2) * _S461.x;
}

vec4 light_of_woven_0(Frame_0 _S462, uint _S463, VisiblePoint_0 _S464)
{
    Footprint_0 footprint_1;
    footprint_1.centre_0 = _S464.draft_0;
    footprint_1.dx_0 = _S464.draft_dx_0;
    footprint_1.dy_0 = _S464.draft_dy_0;
    vec3 _S465 = to_local_0(_S464, _S464.view_0);
    WovenView_0 activations_0;
    woven_view_0(_S463, footprint_1, _S465, activations_0);
    float _S466 = _S465.z;
    FamilyAlbedos_0 _S467 = albedos_over_0(_S463, footprint_1, _S466 < 0.0);
    const vec3 _S468 = vec3(0.0);
    uint number_3 = 0U;
    vec3 radiance_1 = _S468;
    for(;;)
    {
        if(number_3 < (_S462.lights_0))
        {
        }
        else
        {
            break;
        }
        vec3 irradiance_2;
        vec3 _S469 = towards_light_0(lights_1._data[uint(number_3)], _S464.position_0, irradiance_2);
        vec3 _S470 = to_local_0(_S464, _S469);
        Components_0 _S471 = woven_components_0(_S463, activations_0, _S470);
        vec3 radiance_2 = radiance_1 + irradiance_2 * composed_0(_S463, _S471, _S467, _S470, _S465);
        number_3 = number_3 + 1U;
        radiance_1 = radiance_2;
    }
    float hole_3 = activations_0.hole_0;
    float _S472 = fabrics_0._data[uint(_S463)].sheen_strength_0;
    float hole_4;
    if((fabrics_0._data[uint(_S463)].sheen_strength_0) > 0.0)
    {
        hole_4 = hole_3 * (1.0 - _S472 * sheen_lobe_0(abs(_S466), fabrics_0._data[uint(_S463)].sheen_roughness_0).z);
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
    Frame_0 _S473 = frames_0._data[uint(0)];
    bool _S474;
    if((gl_GlobalInvocationID.x) >= (_S473.width_0))
    {
        _S474 = true;
    }
    else
    {
        _S474 = (gl_GlobalInvocationID.y) >= (_S473.height_0);
    }
    if(_S474)
    {
        return;
    }
    uvec2 _S475 = gl_GlobalInvocationID.xy;
    ivec3 _S476 = ivec3(ivec2(_S475), 0);
    uint _S477 = (texelFetch((visible_faces_0), ((_S476)).xy, ((_S476)).z).x);
    const vec4 _S478 = vec4(0.0);
    vec4 sum_3;
    if(_S477 > 0U)
    {
        uint _S479 = _S477 - 1U;
        uint _S480 = face_fabrics_0._data[uint(_S479)];
        sum_3 = light_of_woven_0(_S473, _S480, visible_point_0(_S473, _S480, _S479, _S475));
    }
    else
    {
        sum_3 = _S478;
    }
    accumulate_0(_S473, _S475, sum_3);
    return;
}

