#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
struct FloatWeights_0
{
    uint first_0;
};

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

struct KernelContext_0
{
    uint device* query_count_0;
    Query_0 device* queries_0;
    packed_float4 device* answers_0;
    Fabric_0 device* fabrics_0;
    packed_uint4 device* packed_numbers_0;
    uint device* words_0;
    Family_0 device* families_0;
};

struct Eight_0
{
    float4 low_0;
    float4 high_0;
};

Eight_0 FloatWeights_eight_0(const FloatWeights_0 thread* this_0, uint element_0, KernelContext_0 thread* kernelContext_0)
{
    thread Eight_0 numbers_0;
    uint _S1 = this_0->first_0 + 2U * element_0;
    (&numbers_0)->low_0 = (as_type<float4>((uint4(*(kernelContext_0->packed_numbers_0+_S1)) )));
    (&numbers_0)->high_0 = (as_type<float4>((uint4(*(kernelContext_0->packed_numbers_0+(_S1 + 1U))) )));
    return numbers_0;
}

float4 tile_product_0(const FloatWeights_0 thread* weights_0, uint row_0, array<float, int(96)> thread* inputs_0, KernelContext_0 thread* kernelContext_1)
{
    thread float4 sums_1 = float4(0.0f) ;
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
        thread float4 low_1;
        thread float4 high_1;
        int _S2 = int(8U * column_0);
        low_1.x = (*inputs_0)[_S2];
        high_1.x = (*inputs_0)[_S2 + int(4)];
        int _S3 = _S2 + int(1);
        low_1.y = (*inputs_0)[_S3];
        high_1.y = (*inputs_0)[_S3 + int(4)];
        int _S4 = _S2 + int(2);
        low_1.z = (*inputs_0)[_S4];
        high_1.z = (*inputs_0)[_S4 + int(4)];
        int _S5 = _S2 + int(3);
        low_1.w = (*inputs_0)[_S5];
        high_1.w = (*inputs_0)[_S5 + int(4)];
        Eight_0 _S6 = FloatWeights_eight_0(weights_0, row_0 + column_0, kernelContext_1);
        sums_1.x = sums_1.x + (dot(_S6.low_0, low_1) + dot(_S6.high_0, high_1));
        Eight_0 _S7 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0, kernelContext_1);
        sums_1.y = sums_1.y + (dot(_S7.low_0, low_1) + dot(_S7.high_0, high_1));
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0, kernelContext_1);
        sums_1.z = sums_1.z + (dot(_S8.low_0, low_1) + dot(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0, kernelContext_1);
        sums_1.w = sums_1.w + (dot(_S9.low_0, low_1) + dot(_S9.high_0, high_1));
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

void dense_part_0(const FloatWeights_0 thread* weights_1, uint first_1, bool adds_0, array<float, int(96)> thread* inputs_1, array<float, int(50)> thread* outputs_0, KernelContext_0 thread* kernelContext_2)
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
        Eight_0 _S13 = FloatWeights_eight_0(weights_1, first_1 + _S12 / 8U, kernelContext_2);
        float4 _S14 = tile_product_0(weights_1, _S10 + _S12 * 12U, inputs_1, kernelContext_2);
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
                _S17 = (*outputs_0)[output_0];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S16[int(0)] + _S17);
        }
        int _S18 = output_0 + int(1);
        if(_S18 < int(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S18];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S18] = Identity_apply_0(_S16[int(1)] + _S17);
        }
        int _S19 = output_0 + int(2);
        if(_S19 < int(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S19];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S19] = Identity_apply_0(_S16[int(2)] + _S17);
        }
        int _S20 = output_0 + int(3);
        if(_S20 < int(50))
        {
            if(adds_0)
            {
                _S17 = (*outputs_0)[_S20];
            }
            else
            {
                _S17 = 0.0f;
            }
            (*outputs_0)[_S20] = Identity_apply_0(_S16[int(3)] + _S17);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

struct HalfWeights_0
{
    uint first_2;
};

float2 f16tof32_0(uint2 value_0)
{
    thread float2 result_0;
    int i_0 = int(0);
    for(;;)
    {
        if(i_0 < int(2))
        {
        }
        else
        {
            break;
        }
        result_0[i_0] = (as_type<half>((ushort)((value_0[i_0]))));
        i_0 = i_0 + int(1);
    }
    return result_0;
}

Eight_0 eight_halves_0(uint4 packed_0)
{
    thread Eight_0 numbers_1;
    uint _S21 = packed_0.x;
    uint _S22 = packed_0.y;
    (&numbers_1)->low_0 = float4(f16tof32_0(uint2(_S21 & 65535U, _S21 >> 16U)), f16tof32_0(uint2(_S22 & 65535U, _S22 >> 16U)));
    uint _S23 = packed_0.z;
    uint _S24 = packed_0.w;
    (&numbers_1)->high_0 = float4(f16tof32_0(uint2(_S23 & 65535U, _S23 >> 16U)), f16tof32_0(uint2(_S24 & 65535U, _S24 >> 16U)));
    return numbers_1;
}

Eight_0 HalfWeights_eight_0(const HalfWeights_0 thread* this_1, uint element_1, KernelContext_0 thread* kernelContext_3)
{
    return eight_halves_0(uint4(*(kernelContext_3->packed_numbers_0+(this_1->first_2 + element_1))) );
}

float4 tile_product_1(const HalfWeights_0 thread* weights_2, uint row_1, array<float, int(96)> thread* inputs_2, KernelContext_0 thread* kernelContext_4)
{
    thread float4 sums_2 = float4(0.0f) ;
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
        thread float4 low_2;
        thread float4 high_2;
        int _S25 = int(8U * column_1);
        low_2.x = (*inputs_2)[_S25];
        high_2.x = (*inputs_2)[_S25 + int(4)];
        int _S26 = _S25 + int(1);
        low_2.y = (*inputs_2)[_S26];
        high_2.y = (*inputs_2)[_S26 + int(4)];
        int _S27 = _S25 + int(2);
        low_2.z = (*inputs_2)[_S27];
        high_2.z = (*inputs_2)[_S27 + int(4)];
        int _S28 = _S25 + int(3);
        low_2.w = (*inputs_2)[_S28];
        high_2.w = (*inputs_2)[_S28 + int(4)];
        Eight_0 _S29 = HalfWeights_eight_0(weights_2, row_1 + column_1, kernelContext_4);
        sums_2.x = sums_2.x + (dot(_S29.low_0, low_2) + dot(_S29.high_0, high_2));
        Eight_0 _S30 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1, kernelContext_4);
        sums_2.y = sums_2.y + (dot(_S30.low_0, low_2) + dot(_S30.high_0, high_2));
        Eight_0 _S31 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1, kernelContext_4);
        sums_2.z = sums_2.z + (dot(_S31.low_0, low_2) + dot(_S31.high_0, high_2));
        Eight_0 _S32 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1, kernelContext_4);
        sums_2.w = sums_2.w + (dot(_S32.low_0, low_2) + dot(_S32.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
}

void dense_part_1(const HalfWeights_0 thread* weights_3, uint first_3, bool adds_1, array<float, int(96)> thread* inputs_3, array<float, int(52)> thread* outputs_1, KernelContext_0 thread* kernelContext_5)
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
        Eight_0 _S36 = HalfWeights_eight_0(weights_3, first_3 + _S35 / 8U, kernelContext_5);
        float4 _S37 = tile_product_1(weights_3, _S33 + _S35 * 12U, inputs_3, kernelContext_5);
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
                _S40 = (*outputs_1)[output_1];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S39[int(0)] + _S40);
        }
        int _S41 = output_1 + int(1);
        if(_S41 < int(52))
        {
            if(adds_1)
            {
                _S40 = (*outputs_1)[_S41];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[_S41] = Identity_apply_0(_S39[int(1)] + _S40);
        }
        int _S42 = output_1 + int(2);
        if(_S42 < int(52))
        {
            if(adds_1)
            {
                _S40 = (*outputs_1)[_S42];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[_S42] = Identity_apply_0(_S39[int(2)] + _S40);
        }
        int _S43 = output_1 + int(3);
        if(_S43 < int(52))
        {
            if(adds_1)
            {
                _S40 = (*outputs_1)[_S43];
            }
            else
            {
                _S40 = 0.0f;
            }
            (*outputs_1)[_S43] = Identity_apply_0(_S39[int(3)] + _S40);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

float4 tile_product_2(const HalfWeights_0 thread* weights_4, uint row_2, array<float, int(39)> thread* inputs_4, KernelContext_0 thread* kernelContext_6)
{
    thread float4 sums_3 = float4(0.0f) ;
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
        thread float4 low_3;
        thread float4 high_3;
        int _S44 = int(8U * column_2);
        low_3.x = (*inputs_4)[min(_S44, int(38))];
        high_3.x = (*inputs_4)[min(_S44 + int(4), int(38))];
        int _S45 = _S44 + int(1);
        low_3.y = (*inputs_4)[min(_S45, int(38))];
        high_3.y = (*inputs_4)[min(_S45 + int(4), int(38))];
        int _S46 = _S44 + int(2);
        low_3.z = (*inputs_4)[min(_S46, int(38))];
        high_3.z = (*inputs_4)[min(_S46 + int(4), int(38))];
        int _S47 = _S44 + int(3);
        low_3.w = (*inputs_4)[min(_S47, int(38))];
        high_3.w = (*inputs_4)[min(_S47 + int(4), int(38))];
        Eight_0 _S48 = HalfWeights_eight_0(weights_4, row_2 + column_2, kernelContext_6);
        sums_3.x = sums_3.x + (dot(_S48.low_0, low_3) + dot(_S48.high_0, high_3));
        Eight_0 _S49 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2, kernelContext_6);
        sums_3.y = sums_3.y + (dot(_S49.low_0, low_3) + dot(_S49.high_0, high_3));
        Eight_0 _S50 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2, kernelContext_6);
        sums_3.z = sums_3.z + (dot(_S50.low_0, low_3) + dot(_S50.high_0, high_3));
        Eight_0 _S51 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2, kernelContext_6);
        sums_3.w = sums_3.w + (dot(_S51.low_0, low_3) + dot(_S51.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
}

void dense_part_2(const HalfWeights_0 thread* weights_5, uint first_4, bool adds_2, array<float, int(39)> thread* inputs_5, array<float, int(96)> thread* outputs_2, KernelContext_0 thread* kernelContext_7)
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
        Eight_0 _S55 = HalfWeights_eight_0(weights_5, first_4 + _S54 / 8U, kernelContext_7);
        float4 _S56 = tile_product_2(weights_5, _S52 + _S54 * 5U, inputs_5, kernelContext_7);
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
                _S59 = (*outputs_2)[output_2];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S58[int(0)] + _S59);
        }
        int _S60 = output_2 + int(1);
        if(_S60 < int(96))
        {
            if(adds_2)
            {
                _S59 = (*outputs_2)[_S60];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[_S60] = Identity_apply_0(_S58[int(1)] + _S59);
        }
        int _S61 = output_2 + int(2);
        if(_S61 < int(96))
        {
            if(adds_2)
            {
                _S59 = (*outputs_2)[_S61];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[_S61] = Identity_apply_0(_S58[int(2)] + _S59);
        }
        int _S62 = output_2 + int(3);
        if(_S62 < int(96))
        {
            if(adds_2)
            {
                _S59 = (*outputs_2)[_S62];
            }
            else
            {
                _S59 = 0.0f;
            }
            (*outputs_2)[_S62] = Identity_apply_0(_S58[int(3)] + _S59);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

float4 tile_product_3(const HalfWeights_0 thread* weights_6, uint row_3, array<float, int(100)> thread* inputs_6, KernelContext_0 thread* kernelContext_8)
{
    thread float4 sums_4 = float4(0.0f) ;
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
        thread float4 low_4;
        thread float4 high_4;
        int _S63 = int(8U * column_3);
        low_4.x = (*inputs_6)[min(_S63, int(99))];
        high_4.x = (*inputs_6)[min(_S63 + int(4), int(99))];
        int _S64 = _S63 + int(1);
        low_4.y = (*inputs_6)[min(_S64, int(99))];
        high_4.y = (*inputs_6)[min(_S64 + int(4), int(99))];
        int _S65 = _S63 + int(2);
        low_4.z = (*inputs_6)[min(_S65, int(99))];
        high_4.z = (*inputs_6)[min(_S65 + int(4), int(99))];
        int _S66 = _S63 + int(3);
        low_4.w = (*inputs_6)[min(_S66, int(99))];
        high_4.w = (*inputs_6)[min(_S66 + int(4), int(99))];
        Eight_0 _S67 = HalfWeights_eight_0(weights_6, row_3 + column_3, kernelContext_8);
        sums_4.x = sums_4.x + (dot(_S67.low_0, low_4) + dot(_S67.high_0, high_4));
        Eight_0 _S68 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3, kernelContext_8);
        sums_4.y = sums_4.y + (dot(_S68.low_0, low_4) + dot(_S68.high_0, high_4));
        Eight_0 _S69 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3, kernelContext_8);
        sums_4.z = sums_4.z + (dot(_S69.low_0, low_4) + dot(_S69.high_0, high_4));
        Eight_0 _S70 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3, kernelContext_8);
        sums_4.w = sums_4.w + (dot(_S70.low_0, low_4) + dot(_S70.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
}

void dense_part_3(const HalfWeights_0 thread* weights_7, uint first_5, bool adds_3, array<float, int(100)> thread* inputs_7, array<float, int(96)> thread* outputs_3, KernelContext_0 thread* kernelContext_9)
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
        Eight_0 _S74 = HalfWeights_eight_0(weights_7, first_5 + _S73 / 8U, kernelContext_9);
        float4 _S75 = tile_product_3(weights_7, _S71 + _S73 * 13U, inputs_7, kernelContext_9);
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
                _S78 = (*outputs_3)[output_3];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S77[int(0)] + _S78);
        }
        int _S79 = output_3 + int(1);
        if(_S79 < int(96))
        {
            if(adds_3)
            {
                _S78 = (*outputs_3)[_S79];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[_S79] = Identity_apply_0(_S77[int(1)] + _S78);
        }
        int _S80 = output_3 + int(2);
        if(_S80 < int(96))
        {
            if(adds_3)
            {
                _S78 = (*outputs_3)[_S80];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[_S80] = Identity_apply_0(_S77[int(2)] + _S78);
        }
        int _S81 = output_3 + int(3);
        if(_S81 < int(96))
        {
            if(adds_3)
            {
                _S78 = (*outputs_3)[_S81];
            }
            else
            {
                _S78 = 0.0f;
            }
            (*outputs_3)[_S81] = Identity_apply_0(_S77[int(3)] + _S78);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

float4 tile_product_4(const HalfWeights_0 thread* weights_8, uint row_4, array<float, int(16)> thread* inputs_8, KernelContext_0 thread* kernelContext_10)
{
    thread float4 sums_5 = float4(0.0f) ;
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
        thread float4 low_5;
        thread float4 high_5;
        int _S82 = int(8U * column_4);
        low_5.x = (*inputs_8)[_S82];
        high_5.x = (*inputs_8)[_S82 + int(4)];
        int _S83 = _S82 + int(1);
        low_5.y = (*inputs_8)[_S83];
        high_5.y = (*inputs_8)[_S83 + int(4)];
        int _S84 = _S82 + int(2);
        low_5.z = (*inputs_8)[_S84];
        high_5.z = (*inputs_8)[_S84 + int(4)];
        int _S85 = _S82 + int(3);
        low_5.w = (*inputs_8)[_S85];
        high_5.w = (*inputs_8)[_S85 + int(4)];
        Eight_0 _S86 = HalfWeights_eight_0(weights_8, row_4 + column_4, kernelContext_10);
        sums_5.x = sums_5.x + (dot(_S86.low_0, low_5) + dot(_S86.high_0, high_5));
        Eight_0 _S87 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4, kernelContext_10);
        sums_5.y = sums_5.y + (dot(_S87.low_0, low_5) + dot(_S87.high_0, high_5));
        Eight_0 _S88 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4, kernelContext_10);
        sums_5.z = sums_5.z + (dot(_S88.low_0, low_5) + dot(_S88.high_0, high_5));
        Eight_0 _S89 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4, kernelContext_10);
        sums_5.w = sums_5.w + (dot(_S89.low_0, low_5) + dot(_S89.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_5;
}

void dense_part_4(const HalfWeights_0 thread* weights_9, uint first_6, bool adds_4, array<float, int(16)> thread* inputs_9, array<float, int(1)> thread* outputs_4, KernelContext_0 thread* kernelContext_11)
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
        Eight_0 _S93 = HalfWeights_eight_0(weights_9, first_6 + _S92 / 8U, kernelContext_11);
        float4 _S94 = tile_product_4(weights_9, _S90 + _S92 * 2U, inputs_9, kernelContext_11);
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
                _S97 = (*outputs_4)[output_4];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S96[int(0)] + _S97);
        }
        int _S98 = output_4 + int(1);
        if(_S98 < int(1))
        {
            if(adds_4)
            {
                _S97 = (*outputs_4)[_S98];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[_S98] = Identity_apply_0(_S96[int(1)] + _S97);
        }
        int _S99 = output_4 + int(2);
        if(_S99 < int(1))
        {
            if(adds_4)
            {
                _S97 = (*outputs_4)[_S99];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[_S99] = Identity_apply_0(_S96[int(2)] + _S97);
        }
        int _S100 = output_4 + int(3);
        if(_S100 < int(1))
        {
            if(adds_4)
            {
                _S97 = (*outputs_4)[_S100];
            }
            else
            {
                _S97 = 0.0f;
            }
            (*outputs_4)[_S100] = Identity_apply_0(_S96[int(3)] + _S97);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

float LeakyRelu_apply_0(float x_1)
{
    return max(x_1, x_1 * 0.00999999977648258f);
}

void dense_part_5(const HalfWeights_0 thread* weights_10, uint first_7, bool adds_5, array<float, int(96)> thread* inputs_10, array<float, int(96)> thread* outputs_5, KernelContext_0 thread* kernelContext_12)
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
        Eight_0 _S104 = HalfWeights_eight_0(weights_10, first_7 + _S103 / 8U, kernelContext_12);
        float4 _S105 = tile_product_1(weights_10, _S101 + _S103 * 12U, inputs_10, kernelContext_12);
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
                _S108 = (*outputs_5)[output_5];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S107[int(0)] + _S108);
        }
        int _S109 = output_5 + int(1);
        if(_S109 < int(96))
        {
            if(adds_5)
            {
                _S108 = (*outputs_5)[_S109];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[_S109] = LeakyRelu_apply_0(_S107[int(1)] + _S108);
        }
        int _S110 = output_5 + int(2);
        if(_S110 < int(96))
        {
            if(adds_5)
            {
                _S108 = (*outputs_5)[_S110];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[_S110] = LeakyRelu_apply_0(_S107[int(2)] + _S108);
        }
        int _S111 = output_5 + int(3);
        if(_S111 < int(96))
        {
            if(adds_5)
            {
                _S108 = (*outputs_5)[_S111];
            }
            else
            {
                _S108 = 0.0f;
            }
            (*outputs_5)[_S111] = LeakyRelu_apply_0(_S107[int(3)] + _S108);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

void dense_part_6(const HalfWeights_0 thread* weights_11, uint first_8, bool adds_6, array<float, int(100)> thread* inputs_11, array<float, int(16)> thread* outputs_6, KernelContext_0 thread* kernelContext_13)
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
        Eight_0 _S115 = HalfWeights_eight_0(weights_11, first_8 + _S114 / 8U, kernelContext_13);
        float4 _S116 = tile_product_3(weights_11, _S112 + _S114 * 13U, inputs_11, kernelContext_13);
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
                _S119 = (*outputs_6)[output_6];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S118[int(0)] + _S119);
        }
        int _S120 = output_6 + int(1);
        if(_S120 < int(16))
        {
            if(adds_6)
            {
                _S119 = (*outputs_6)[_S120];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[_S120] = LeakyRelu_apply_0(_S118[int(1)] + _S119);
        }
        int _S121 = output_6 + int(2);
        if(_S121 < int(16))
        {
            if(adds_6)
            {
                _S119 = (*outputs_6)[_S121];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[_S121] = LeakyRelu_apply_0(_S118[int(2)] + _S119);
        }
        int _S122 = output_6 + int(3);
        if(_S122 < int(16))
        {
            if(adds_6)
            {
                _S119 = (*outputs_6)[_S122];
            }
            else
            {
                _S119 = 0.0f;
            }
            (*outputs_6)[_S122] = LeakyRelu_apply_0(_S118[int(3)] + _S119);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

float4 tile_product_5(const HalfWeights_0 thread* weights_12, uint row_5, array<float, int(88)> thread* inputs_12, KernelContext_0 thread* kernelContext_14)
{
    thread float4 sums_6 = float4(0.0f) ;
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
        thread float4 low_6;
        thread float4 high_6;
        int _S123 = int(8U * column_5);
        low_6.x = (*inputs_12)[_S123];
        high_6.x = (*inputs_12)[_S123 + int(4)];
        int _S124 = _S123 + int(1);
        low_6.y = (*inputs_12)[_S124];
        high_6.y = (*inputs_12)[_S124 + int(4)];
        int _S125 = _S123 + int(2);
        low_6.z = (*inputs_12)[_S125];
        high_6.z = (*inputs_12)[_S125 + int(4)];
        int _S126 = _S123 + int(3);
        low_6.w = (*inputs_12)[_S126];
        high_6.w = (*inputs_12)[_S126 + int(4)];
        Eight_0 _S127 = HalfWeights_eight_0(weights_12, row_5 + column_5, kernelContext_14);
        sums_6.x = sums_6.x + (dot(_S127.low_0, low_6) + dot(_S127.high_0, high_6));
        Eight_0 _S128 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5, kernelContext_14);
        sums_6.y = sums_6.y + (dot(_S128.low_0, low_6) + dot(_S128.high_0, high_6));
        Eight_0 _S129 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5, kernelContext_14);
        sums_6.z = sums_6.z + (dot(_S129.low_0, low_6) + dot(_S129.high_0, high_6));
        Eight_0 _S130 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5, kernelContext_14);
        sums_6.w = sums_6.w + (dot(_S130.low_0, low_6) + dot(_S130.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_6;
}

void dense_part_7(const HalfWeights_0 thread* weights_13, uint first_9, bool adds_7, array<float, int(88)> thread* inputs_13, array<float, int(96)> thread* outputs_7, KernelContext_0 thread* kernelContext_15)
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
        Eight_0 _S134 = HalfWeights_eight_0(weights_13, first_9 + _S133 / 8U, kernelContext_15);
        float4 _S135 = tile_product_5(weights_13, _S131 + _S133 * 11U, inputs_13, kernelContext_15);
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
                _S138 = (*outputs_7)[output_7];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S137[int(0)] + _S138);
        }
        int _S139 = output_7 + int(1);
        if(_S139 < int(96))
        {
            if(adds_7)
            {
                _S138 = (*outputs_7)[_S139];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[_S139] = LeakyRelu_apply_0(_S137[int(1)] + _S138);
        }
        int _S140 = output_7 + int(2);
        if(_S140 < int(96))
        {
            if(adds_7)
            {
                _S138 = (*outputs_7)[_S140];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[_S140] = LeakyRelu_apply_0(_S137[int(2)] + _S138);
        }
        int _S141 = output_7 + int(3);
        if(_S141 < int(96))
        {
            if(adds_7)
            {
                _S138 = (*outputs_7)[_S141];
            }
            else
            {
                _S138 = 0.0f;
            }
            (*outputs_7)[_S141] = LeakyRelu_apply_0(_S137[int(3)] + _S138);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

void dense_0(const FloatWeights_0 thread* weights_14, uint first_10, bool adds_8, array<float, int(96)> thread* inputs_14, array<float, int(50)> thread* outputs_8, KernelContext_0 thread* kernelContext_16)
{
    dense_part_0(weights_14, first_10, adds_8, inputs_14, outputs_8, kernelContext_16);
    return;
}

void dense_1(const HalfWeights_0 thread* weights_15, uint first_11, bool adds_9, array<float, int(96)> thread* inputs_15, array<float, int(52)> thread* outputs_9, KernelContext_0 thread* kernelContext_17)
{
    dense_part_1(weights_15, first_11, adds_9, inputs_15, outputs_9, kernelContext_17);
    return;
}

void dense_2(const HalfWeights_0 thread* weights_16, uint first_12, bool adds_10, array<float, int(96)> thread* inputs_16, array<float, int(96)> thread* outputs_10, KernelContext_0 thread* kernelContext_18)
{
    dense_part_5(weights_16, first_12, adds_10, inputs_16, outputs_10, kernelContext_18);
    return;
}

void dense_3(const HalfWeights_0 thread* weights_17, uint first_13, bool adds_11, array<float, int(39)> thread* inputs_17, array<float, int(96)> thread* outputs_11, KernelContext_0 thread* kernelContext_19)
{
    dense_part_2(weights_17, first_13, adds_11, inputs_17, outputs_11, kernelContext_19);
    return;
}

void dense_4(const HalfWeights_0 thread* weights_18, uint first_14, bool adds_12, array<float, int(100)> thread* inputs_18, array<float, int(96)> thread* outputs_12, KernelContext_0 thread* kernelContext_20)
{
    dense_part_3(weights_18, first_14, adds_12, inputs_18, outputs_12, kernelContext_20);
    return;
}

void dense_5(const HalfWeights_0 thread* weights_19, uint first_15, bool adds_13, array<float, int(16)> thread* inputs_19, array<float, int(1)> thread* outputs_13, KernelContext_0 thread* kernelContext_21)
{
    dense_part_4(weights_19, first_15, adds_13, inputs_19, outputs_13, kernelContext_21);
    return;
}

void dense_6(const HalfWeights_0 thread* weights_20, uint first_16, bool adds_14, array<float, int(100)> thread* inputs_20, array<float, int(16)> thread* outputs_14, KernelContext_0 thread* kernelContext_22)
{
    dense_part_6(weights_20, first_16, adds_14, inputs_20, outputs_14, kernelContext_22);
    return;
}

void dense_part_8(const HalfWeights_0 thread* weights_21, uint first_17, bool adds_15, array<float, int(96)> thread* inputs_21, array<float, int(100)> thread* outputs_15, KernelContext_0 thread* kernelContext_23)
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
        Eight_0 _S145 = HalfWeights_eight_0(weights_21, first_17 + _S144 / 8U, kernelContext_23);
        float4 _S146 = tile_product_1(weights_21, _S142 + _S144 * 12U, inputs_21, kernelContext_23);
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
                _S149 = (*outputs_15)[output_8];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S148[int(0)] + _S149);
        }
        int _S150 = output_8 + int(1);
        if(_S150 < int(96))
        {
            if(adds_15)
            {
                _S149 = (*outputs_15)[_S150];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[_S150] = LeakyRelu_apply_0(_S148[int(1)] + _S149);
        }
        int _S151 = output_8 + int(2);
        if(_S151 < int(96))
        {
            if(adds_15)
            {
                _S149 = (*outputs_15)[_S151];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[_S151] = LeakyRelu_apply_0(_S148[int(2)] + _S149);
        }
        int _S152 = output_8 + int(3);
        if(_S152 < int(96))
        {
            if(adds_15)
            {
                _S149 = (*outputs_15)[_S152];
            }
            else
            {
                _S149 = 0.0f;
            }
            (*outputs_15)[_S152] = LeakyRelu_apply_0(_S148[int(3)] + _S149);
        }
        output_8 = output_8 + int(4);
    }
    return;
}

void dense_7(const HalfWeights_0 thread* weights_22, uint first_18, bool adds_16, array<float, int(88)> thread* inputs_22, array<float, int(96)> thread* outputs_16, KernelContext_0 thread* kernelContext_24)
{
    dense_part_7(weights_22, first_18, adds_16, inputs_22, outputs_16, kernelContext_24);
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

float3 row_of_taps_0(const Footprint_0 thread* footprint_0)
{
    float _S153 = footprint_0->dx_0.x;
    float _S154 = footprint_0->dy_0.x;
    float _S155 = _S153 * _S153 + _S154 * _S154;
    float _S156 = footprint_0->dx_0.y;
    float _S157 = footprint_0->dy_0.y;
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

float AnisotropicTaps_size_0(const AnisotropicTaps_0 thread* this_2)
{
    float _S173 = this_2->first_19.x;
    float _S174 = this_2->second_0.x;
    float _S175 = this_2->side_0 * this_2->side_0;
    float _S176 = this_2->first_19.y;
    float _S177 = this_2->second_0.y;
    float _S178 = 12.0f * (_S173 * _S176 + _S174 * _S177);
    return sqrt(sqrt(max((12.0f * (_S173 * _S173 + _S174 * _S174) + _S175) * (12.0f * (_S176 * _S176 + _S177 * _S177) + _S175) - _S178 * _S178, square_0(_S175))));
}

float natural_logarithm_0(float x_3)
{
    uint _S179 = (as_type<uint>((x_3)));
    float exponent_0 = float(int(_S179 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S179 & 8388607U) | 1056964608U)));
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
    float _S180 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S180 - exponent_1 * 0.00021219444170129f - 0.5f * _S180) + exponent_1 * 0.693359375f;
}

float3 footprint_coordinates_0(const AnisotropicTaps_0 thread* taps_0)
{
    float _S181 = AnisotropicTaps_size_0(taps_0);
    return float3(taps_0->centre_1 - floor(taps_0->centre_1), clamp(natural_logarithm_0(max(_S181, 9.99999997475242708e-07f) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
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

float table_number_0(uint index_0, KernelContext_0 thread* kernelContext_25)
{
    return (as_type<float>((kernelContext_25->words_0[index_0])));
}

float table_number_1(uint index_1, KernelContext_0 thread* kernelContext_26)
{
    return (as_type<float>((kernelContext_26->words_0[index_1])));
}

float wrapped_0(float index_2, float count_1)
{
    float _S184;
    if(index_2 < 0.0f)
    {
        _S184 = index_2 + count_1;
    }
    else
    {
        if(index_2 >= count_1)
        {
            _S184 = index_2 - count_1;
        }
        else
        {
            _S184 = index_2;
        }
    }
    return _S184;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

bool AnisotropicTaps_has_steps_0(const AnisotropicTaps_0 thread* this_3)
{
    return (max(dot(this_3->first_19, this_3->first_19), dot(this_3->second_0, this_3->second_0))) > 0.0f;
}

float2 AnisotropicTaps_place_0(const AnisotropicTaps_0 thread* this_4, uint number_0)
{
    float _S185;
    if(number_0 >= 2U)
    {
        _S185 = 1.0f;
    }
    else
    {
        _S185 = -1.0f;
    }
    float _S186;
    if((number_0 & 1U) != 0U)
    {
        _S186 = 1.0f;
    }
    else
    {
        _S186 = -1.0f;
    }
    return this_4->centre_1 + float2(_S185)  * this_4->first_19 + float2(_S186)  * this_4->second_0;
}

float bump_0(float distance_0)
{
    float _S187 = max(1.0f - distance_0 * distance_0, 0.0f);
    return _S187 * _S187;
}

float correction_weight_of_0(float coded_size_0)
{
    return clamp((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

float exponential_0(float x_5)
{
    float _S188 = clamp(x_5, -87.0f, 88.0f);
    float _S189 = floor(_S188 * 1.4426950216293335f + 0.5f);
    float _S190 = _S188 - _S189 * 0.693359375f + _S189 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S190 + 0.00139819993637502f) * _S190 + 0.00833345204591751f) * _S190 + 0.04166579619050026f) * _S190 + 0.1666666567325592f) * _S190 + 0.5f;
    float _S191 = (as_type<float>((uint(int(_S189) + int(127)) << 23U)));
    float _S192;
    if(x_5 < -87.0f)
    {
        _S192 = 0.0f;
    }
    else
    {
        _S192 = (p_0 * _S190 * _S190 + _S190 + 1.0f) * _S191;
    }
    return _S192;
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
    uint _S193 = bundle_0 / 3U;
    uint _S194 = bundle_0 % 3U;
    uint _S195;
    if(bundle_0 == 24U)
    {
        _S195 = bundle_0;
    }
    else
    {
        _S195 = _S193 * 3U + 3U - 1U - _S194;
    }
    return _S195;
}

float light_visibility_of_0(float diffuse_0, float3 light_1, float3 view_1, float blend_0)
{
    float _S196 = max(abs(light_1.z), 0.00100000004749745f);
    float2 _S197 = light_1.xy;
    return 3.14159274101257324f * max(diffuse_0, 0.0f) / mix(_S196, (0.59700000286102295f * _S196 + 0.16599999368190765f) * (0.21600000560283661f * (dot(_S197, view_1.xy) * rsqrt(max(dot(_S197, _S197), 9.99999997475242708e-07f))) + 1.0f), blend_0);
}

float2 turns_and_remainder_0(uint family_0, float index_3, KernelContext_0 thread* kernelContext_27)
{
    float _S198 = floor(fma(index_3, (kernelContext_27->families_0+family_0)->inverse_count_0, (kernelContext_27->families_0+family_0)->half_inverse_count_0));
    return float2(_S198, fma(- _S198, (kernelContext_27->families_0+family_0)->count_0, index_3));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0, KernelContext_0 thread* kernelContext_28)
{
    float _S199 = floor(position_0 * (kernelContext_28->families_0+family_1)->inverse_size_0);
    thread Cell_0 cell_0;
    float _S200 = fma(- _S199, (kernelContext_28->families_0+family_1)->size_0, position_0);
    (&cell_0)->below_0 = _S200;
    (&cell_0)->above_0 = (kernelContext_28->families_0+family_1)->size_0 - _S200;
    (&cell_0)->across_0 = _S200 - 0.5f * (kernelContext_28->families_0+family_1)->size_0;
    (&cell_0)->half_width_1 = (kernelContext_28->families_0+family_1)->half_width_0;
    float2 _S201 = turns_and_remainder_0(family_1, _S199, kernelContext_28);
    (&cell_0)->thread_0 = uint(clamp(_S201.y, 0.0f, (kernelContext_28->families_0+family_1)->count_0 - 1.0f));
    return cell_0;
}

Cell_0 locate_varied_0(uint family_2, float position_1, KernelContext_0 thread* kernelContext_29)
{
    float turns_0 = (position_1 - (kernelContext_29->families_0+family_2)->start_0) * (kernelContext_29->families_0+family_2)->inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S202 = turns_1 * (kernelContext_29->families_0+family_2)->period_0;
    uint thread_1 = kernelContext_29->words_0[(kernelContext_29->families_0+family_2)->first_thread_table_0 + uint(clamp(turns_1 * (kernelContext_29->families_0+family_2)->bins_0, 0.0f, (kernelContext_29->families_0+family_2)->bins_0 - 1.0f))];
    float _S203 = table_number_0((kernelContext_29->families_0+family_2)->place_table_0 + thread_1 * 4U + 1U, kernelContext_29);
    uint _S204;
    if(_S202 >= _S203)
    {
        _S204 = 1U;
    }
    else
    {
        _S204 = 0U;
    }
    uint _S205 = min(thread_1 + _S204, uint((kernelContext_29->families_0+family_2)->count_0) - 1U);
    uint _S206 = (kernelContext_29->families_0+family_2)->place_table_0 + _S205 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S205;
    float _S207 = table_number_0(_S206, kernelContext_29);
    (&cell_1)->below_0 = _S202 - _S207;
    float _S208 = table_number_0(_S206 + 1U, kernelContext_29);
    (&cell_1)->above_0 = _S208 - _S202;
    float _S209 = table_number_0(_S206 + 2U, kernelContext_29);
    (&cell_1)->across_0 = _S202 - _S209;
    float _S210 = table_number_0(_S206 + 3U, kernelContext_29);
    (&cell_1)->half_width_1 = _S210;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2, KernelContext_0 thread* kernelContext_30)
{
    if(((kernelContext_30->families_0+family_3)->is_alike_0) != 0U)
    {
        Cell_0 _S211 = locate_alike_0(family_3, position_2, kernelContext_30);
        return _S211;
    }
    Cell_0 _S212 = locate_varied_0(family_3, position_2, kernelContext_30);
    return _S212;
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

Bound_0 bound_at_0(uint family_4, float position_3, KernelContext_0 thread* kernelContext_31)
{
    Cell_0 _S213 = locate_0(family_4, position_3, kernelContext_31);
    float _S214 = table_number_0((kernelContext_31->families_0+family_4)->before_0 + 2U * _S213.thread_0 + 1U, kernelContext_31);
    thread Bound_0 bound_0;
    (&bound_0)->thread_2 = _S213.thread_0;
    (&bound_0)->turns_2 = round((position_3 - (kernelContext_31->families_0+family_4)->start_0 - _S214 - _S213.below_0) * (kernelContext_31->families_0+family_4)->inverse_period_0);
    (&bound_0)->cell_2 = _S213.below_0;
    float _S215 = 2.0f * _S213.half_width_1;
    (&bound_0)->width_1 = _S215;
    (&bound_0)->visible_0 = clamp((_S213.across_0 + _S213.half_width_1) / _S215, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S213.below_0, _S213.below_0 - _S213.across_0 - _S213.half_width_1) + max(_S213.across_0 - _S213.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1, KernelContext_0 thread* kernelContext_32)
{
    float _S216 = centre_2 - floor((centre_2 - (kernelContext_32->families_0+family_5)->start_0) * (kernelContext_32->families_0+family_5)->inverse_period_0) * (kernelContext_32->families_0+family_5)->period_0;
    float _S217 = 0.5f * max(size_1, (kernelContext_32->families_0+family_5)->smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S218 = bound_at_0(family_5, _S216 - _S217, kernelContext_32);
    (&stretch_0)->low_7 = _S218;
    Bound_0 _S219 = bound_at_0(family_5, _S216 + _S217, kernelContext_32);
    (&stretch_0)->high_7 = _S219;
    return stretch_0;
}

float3 table_colour_0(uint index_4, KernelContext_0 thread* kernelContext_33)
{
    float _S220 = table_number_1(index_4, kernelContext_33);
    float _S221 = table_number_1(index_4 + 1U, kernelContext_33);
    float _S222 = table_number_1(index_4 + 2U, kernelContext_33);
    return float3(_S220, _S221, _S222);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_6, KernelContext_0 thread* kernelContext_34)
{
    thread Albedos_0 albedos_0;
    float3 _S223 = table_colour_0(row_6, kernelContext_34);
    (&albedos_0)->diffuse_reflect_0 = _S223;
    float3 _S224 = table_colour_0(row_6 + 3U, kernelContext_34);
    (&albedos_0)->diffuse_transmit_0 = _S224;
    float3 _S225 = table_colour_0(row_6 + 6U, kernelContext_34);
    (&albedos_0)->specular_reflect_0 = _S225;
    float3 _S226 = table_colour_0(row_6 + 9U, kernelContext_34);
    (&albedos_0)->specular_transmit_0 = _S226;
    return albedos_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_5)
{
    return (&this_5->high_7)->turns_2 - (&this_5->low_7)->turns_2;
}

float3 lengths_0(uint family_6, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_35)
{
    float _S227 = Stretch_turns_0(stretch_1);
    uint _S228 = (kernelContext_35->families_0+family_6)->before_0 + 2U * (&stretch_1->low_7)->thread_2;
    uint _S229 = (kernelContext_35->families_0+family_6)->before_0 + 2U * (&stretch_1->high_7)->thread_2;
    float _S230 = table_number_0(_S229, kernelContext_35);
    float _S231 = table_number_0(_S228, kernelContext_35);
    float _S232 = _S230 - _S231;
    float _S233 = table_number_0(_S229 + 1U, kernelContext_35);
    float _S234 = table_number_0(_S228 + 1U, kernelContext_35);
    float _S235 = _S233 - _S234;
    return float3(_S232 + (&stretch_1->high_7)->visible_0 * (&stretch_1->high_7)->width_1 - (&stretch_1->low_7)->visible_0 * (&stretch_1->low_7)->width_1 + _S227 * (kernelContext_35->families_0+family_6)->visible_total_0, _S235 - _S232 + (&stretch_1->high_7)->gap_0 - (&stretch_1->low_7)->gap_0 + _S227 * ((kernelContext_35->families_0+family_6)->period_0 - (kernelContext_35->families_0+family_6)->visible_total_0), _S235 + (&stretch_1->high_7)->cell_2 - (&stretch_1->low_7)->cell_2 + _S227 * (kernelContext_35->families_0+family_6)->period_0);
}

float2 integrals_along_0(uint family_7, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_36)
{
    uint _S236 = (kernelContext_36->families_0+family_7)->quantities_0;
    uint _S237 = 3U * (kernelContext_36->families_0+family_7)->quantities_0;
    uint _S238 = (kernelContext_36->families_0+family_7)->colour_threads_0 + _S237 * (&stretch_2->low_7)->thread_2 + quantity_0;
    uint _S239 = (kernelContext_36->families_0+family_7)->colour_threads_0 + _S237 * (&stretch_2->high_7)->thread_2 + quantity_0;
    uint _S240 = (kernelContext_36->families_0+family_7)->colour_threads_0 + _S237 * uint((kernelContext_36->families_0+family_7)->count_0) + quantity_0;
    float _S241 = table_number_0(_S238, kernelContext_36);
    float _S242 = table_number_0(_S239, kernelContext_36);
    float _S243 = Stretch_turns_0(stretch_2);
    float _S244 = table_number_0(_S239 + _S236, kernelContext_36);
    float _S245 = table_number_0(_S238 + _S236, kernelContext_36);
    float _S246 = _S244 - _S245 + _S242 * (&stretch_2->high_7)->visible_0 * (&stretch_2->high_7)->width_1 - _S241 * (&stretch_2->low_7)->visible_0 * (&stretch_2->low_7)->width_1;
    float _S247 = table_number_0(_S240 + _S236, kernelContext_36);
    float _S248 = _S246 + _S243 * _S247;
    uint _S249 = 2U * _S236;
    float _S250 = table_number_0(_S239 + _S249, kernelContext_36);
    float _S251 = table_number_0(_S238 + _S249, kernelContext_36);
    float _S252 = _S250 - _S251 + _S242 * (&stretch_2->high_7)->cell_2 - _S241 * (&stretch_2->low_7)->cell_2;
    float _S253 = table_number_0(_S240 + _S249, kernelContext_36);
    return float2(_S248, _S252 + _S243 * _S253);
}

bool Stretch_wraps_0(const Stretch_0 thread* this_6)
{
    return ((&this_6->high_7)->thread_2) < ((&this_6->low_7)->thread_2);
}

bool Stretch_wraps_1(const Stretch_0 thread* this_7)
{
    return ((&this_7->high_7)->thread_2) < ((&this_7->low_7)->thread_2);
}

uint4 Stretch_differences_0(const Stretch_0 thread* this_8, uint4 entries_0, uint whole_0)
{
    uint _S254 = entries_0.z;
    uint _S255 = entries_0.x;
    uint _S256 = _S254 - _S255;
    bool _S257 = Stretch_wraps_1(this_8);
    uint _S258;
    if(_S257)
    {
        _S258 = whole_0;
    }
    else
    {
        _S258 = 0U;
    }
    return uint4(_S256 + _S258, entries_0.w - _S254, entries_0.y - _S255, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_1, uint row_7, uint count_2, uint quantities_1, KernelContext_0 thread* kernelContext_37)
{
    uint _S259 = row_7 + (&across_1->low_7)->thread_2 * quantities_1;
    uint _S260 = row_7 + (&across_1->high_7)->thread_2 * quantities_1;
    uint4 _S261 = Stretch_differences_0(across_1, uint4(kernelContext_37->words_0[_S259], kernelContext_37->words_0[_S259 + quantities_1], kernelContext_37->words_0[_S260], kernelContext_37->words_0[_S260 + quantities_1]), kernelContext_37->words_0[row_7 + count_2 * quantities_1]);
    return _S261;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_9)
{
    float _S262 = (&this_9->high_7)->visible_0;
    float _S263 = - (&this_9->low_7)->visible_0;
    float _S264 = Stretch_turns_0(this_9);
    bool _S265 = Stretch_wraps_0(this_9);
    float _S266;
    if(_S265)
    {
        _S266 = 1.0f;
    }
    else
    {
        _S266 = 0.0f;
    }
    return float4(1.0f, _S262, _S263, _S264 - _S266);
}

float integral_on_top_0(uint family_8, const Stretch_0 thread* across_2, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_38)
{
    uint _S267 = uint((kernelContext_38->families_0+family_8)->count_0);
    uint _S268 = (_S267 + 1U) * (kernelContext_38->families_0+family_8)->quantities_0;
    uint _S269 = (kernelContext_38->families_0+family_8)->colour_areas_0 + quantity_1;
    uint _S270 = (&along_0->low_7)->thread_2;
    uint4 _S271 = row_differences_0(across_2, _S269 + (&along_0->low_7)->thread_2 * _S268, _S267, (kernelContext_38->families_0+family_8)->quantities_0, kernelContext_38);
    uint4 _S272 = row_differences_0(across_2, _S269 + (_S270 + 1U) * _S268, _S267, (kernelContext_38->families_0+family_8)->quantities_0, kernelContext_38);
    uint _S273 = (&along_0->high_7)->thread_2;
    uint4 _S274 = row_differences_0(across_2, _S269 + (&along_0->high_7)->thread_2 * _S268, _S267, (kernelContext_38->families_0+family_8)->quantities_0, kernelContext_38);
    uint4 _S275 = row_differences_0(across_2, _S269 + (_S273 + 1U) * _S268, _S267, (kernelContext_38->families_0+family_8)->quantities_0, kernelContext_38);
    uint4 _S276 = row_differences_0(across_2, _S269 + crossing_count_0 * _S268, _S267, (kernelContext_38->families_0+family_8)->quantities_0, kernelContext_38);
    uint4 _S277 = _S274 - _S271;
    bool _S278 = Stretch_wraps_0(along_0);
    uint4 _S279;
    if(_S278)
    {
        _S279 = _S276;
    }
    else
    {
        _S279 = uint4(int4(int(0)) );
    }
    uint4 _S280 = _S277 + _S279;
    float4 _S281 = Stretch_weights_0(across_2);
    float4 _S282 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S280)), _S281), dot(float4(int4(_S275 - _S274)), _S281), dot(float4(int4(_S272 - _S271)), _S281), dot(float4(int4(_S276)), _S281)), _S282) * (kernelContext_38->families_0+family_8)->area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_0, uint row_8, KernelContext_0 thread* kernelContext_39)
{
    Albedos_0 _S283 = table_albedos_0(row_8, kernelContext_39);
    thread Albedos_0 sum_0;
    float3 _S284 = float3(weight_0) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S284 * _S283.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S284 * _S283.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S284 * _S283.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S284 * _S283.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, const Stretch_0 thread* own_0, const Stretch_0 thread* other_0, bool back_3, KernelContext_0 thread* kernelContext_40)
{
    Albedos_0 _S285 = table_albedos_0((kernelContext_40->families_0+family_9)->colour_mean_0, kernelContext_40);
    thread Albedos_0 albedos_2 = _S285;
    if(((kernelContext_40->families_0+family_9)->quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S286 = lengths_0(crossing_0, other_0, kernelContext_40);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < ((kernelContext_40->families_0+family_9)->quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S287 = integrals_along_0(family_9, own_0, quantity_2, kernelContext_40);
        float _S288 = integral_on_top_0(family_9, own_0, other_0, uint((kernelContext_40->families_0+crossing_0)->count_0), quantity_2, kernelContext_40);
        float _S289 = _S287.x;
        float _S290 = _S289 * _S286.x;
        float _S291;
        if(back_3)
        {
            _S291 = _S290 - _S288;
        }
        else
        {
            _S291 = _S288;
        }
        bool _S292 = quantity_2 == 0U;
        if(_S292)
        {
            is_exposed_0 = _S291 > (16.0f * (kernelContext_40->families_0+family_9)->area_unit_0 * min(_S290 / (kernelContext_40->families_0+family_9)->crossing_area_0, 1.0f) + 0.00000999999974738f * _S290);
        }
        float _S293 = _S289 * _S286.y;
        float _S294;
        if(is_exposed_0)
        {
            _S294 = _S291;
        }
        else
        {
            _S294 = 0.0f;
        }
        float _S295 = _S293 + _S294 + 0.000244140625f * _S286.z * _S287.y;
        if(_S292)
        {
            weight_1 = 1.0f / max(_S295, 9.99999968265522539e-21f);
        }
        else
        {
            float _S296 = _S295 * weight_1;
            uint _S297 = (kernelContext_40->families_0+family_9)->colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S298 = albedos_2;
            Albedos_0 _S299 = with_added_albedos_0(&_S298, _S296, _S297, kernelContext_40);
            albedos_2 = _S299;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate((&albedos_2)->specular_transmit_0);
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
    thread Blocked_0 nothing_0;
    (&nothing_0)->by_warp_0 = 0.0f;
    (&nothing_0)->by_weft_0 = 0.0f;
    (&nothing_0)->far_0 = 0.0f;
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
    thread CloseUp_0 nothing_1;
    (&nothing_1)->weight_2 = 0.0f;
    Blocked_0 _S300 = no_blocked_0();
    (&nothing_1)->warp_1 = _S300;
    (&nothing_1)->weft_1 = _S300;
    return nothing_1;
}

Albedos_0 tinted_0(const Albedos_0 thread* albedos_3, float3 tint_0)
{
    thread Albedos_0 result_1 = *albedos_3;
    (&result_1)->diffuse_reflect_0 = (&result_1)->diffuse_reflect_0 * tint_0;
    (&result_1)->diffuse_transmit_0 = (&result_1)->diffuse_transmit_0 * tint_0;
    return result_1;
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

FaceRadiance_0 face_radiance_0(const FaceSends_0 thread* sends_0, float open_of_other_0, float3 passed_0, float3 from_other_0)
{
    float3 _S301 = float3((1.0f - open_of_other_0))  * passed_0;
    thread FaceRadiance_0 found_0;
    float3 _S302 = sends_0->sky_warp_0 + _S301 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S302;
    float3 _S303 = sends_0->sky_weft_0 + _S301 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S303;
    (&found_0)->mean_0 = float3(sends_0->blocks_warp_0)  * _S302 + float3(sends_0->blocks_weft_0)  * _S303;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(float3 view_2, array<float, int(6)> thread* terms_0)
{
    float _S304 = 1.0f - view_2.z;
    float _S305 = _S304 * _S304;
    (*terms_0)[int(0)] = 1.0f;
    float _S306 = view_2.x;
    float _S307 = _S306 * _S306;
    float _S308 = view_2.y;
    float _S309 = _S308 * _S308;
    (*terms_0)[int(1)] = sqrt(max(_S307 + _S309, 9.999999960041972e-13f));
    (*terms_0)[int(2)] = _S305;
    (*terms_0)[int(3)] = _S305 * _S305;
    (*terms_0)[int(4)] = _S307 - _S309;
    (*terms_0)[int(5)] = 0.0f;
    return;
}

Blocked_0 scaled_0(const Blocked_0 thread* blocked_0, float share_0)
{
    thread Blocked_0 result_2;
    (&result_2)->by_warp_0 = share_0 * blocked_0->by_warp_0;
    (&result_2)->by_weft_0 = share_0 * blocked_0->by_weft_0;
    (&result_2)->far_0 = share_0 * blocked_0->far_0;
    return result_2;
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

Bounced_0 bounced_by_0(const Blocked_0 thread* blocked_1, const Scattered_0 thread* yarn_0, const Interior_0 thread* interior_0)
{
    float3 _S310 = float3((blocked_1->by_warp_0 + blocked_1->by_weft_0))  * interior_0->leaked_1;
    float3 _S311 = float3(blocked_1->far_0)  * yarn_0->through_0;
    thread Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_0->back_4 * (float3(blocked_1->by_warp_0)  * interior_0->warp_3 + float3(blocked_1->by_weft_0)  * interior_0->weft_3) + _S311 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S311 * interior_0->far_1 + yarn_0->back_4 * _S310;
    return bounced_0;
}

Bounced_0 sum_of_0(const Bounced_0 thread* first_20, const Bounced_0 thread* second_1)
{
    thread Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_20->reflected_0 + second_1->reflected_0;
    (&sum_1)->transmitted_0 = first_20->transmitted_0 + second_1->transmitted_0;
    return sum_1;
}

float3 bounced_value_0(const Bounced_0 thread* bounced_1, float3 light_2, float3 view_3)
{
    float _S312 = light_2.z;
    float3 _S313;
    if((_S312 * view_3.z) < 0.0f)
    {
        _S313 = bounced_1->transmitted_0;
    }
    else
    {
        _S313 = bounced_1->reflected_0;
    }
    return _S313 * float3((abs(_S312) * 0.31830987334251404f)) ;
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
    float _S314 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S315 = 2.0f * sqrt(_S314) - 1.0f;
    float _S316 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S315, _S316), 0.00999999977648258f, 1.0f), clamp((1.0f - _S314) * sheen_shear_0(_S315, _S316), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S315, _S316), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_3, float3 view_4, float scale_1, float shear_0)
{
    float _S317 = light_3.z;
    bool _S318;
    if(_S317 <= 0.0f)
    {
        _S318 = true;
    }
    else
    {
        _S318 = (view_4.z) <= 0.0f;
    }
    if(_S318)
    {
        return 0.0f;
    }
    float2 _S319 = view_4.xy;
    float _S320 = dot(_S319, _S319);
    float2 _S321;
    if(_S320 > 9.99999968265522539e-21f)
    {
        _S321 = _S319 * float2(rsqrt(_S320)) ;
    }
    else
    {
        _S321 = float2(1.0f, 0.0f);
    }
    float _S322 = scale_1 * dot(light_3.xy, _S321) + shear_0 * _S317;
    float _S323 = scale_1 * (light_3.y * _S321.x - light_3.x * _S321.y);
    float _S324 = _S322 * _S322 + _S323 * _S323 + _S317 * _S317;
    return 0.31830987334251404f * scale_1 * scale_1 * _S317 / max(_S324 * _S324, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_4, float3 view_5, float strength_0, float roughness_2)
{
    float3 _S325 = sheen_lobe_0(view_5.z, roughness_2);
    float _S326 = strength_0 * _S325.z;
    return float2(_S326 * transformed_cosine_0(light_4, view_5, _S325.x, _S325.y), 1.0f - _S326);
}

struct NeuralView_0
{
    array<float, int(96)> sums_7;
    float hole_0;
    float correction_weight_0;
    float3 view_6;
    bool back_5;
};

AnisotropicTaps_0 anisotropic_taps_0(uint _S327, const Footprint_0 thread* _S328, KernelContext_0 thread* kernelContext_41)
{
    Fabric_0 device* _S329 = kernelContext_41->fabrics_0+_S327;
    float3 _S330 = row_of_taps_0(_S328);
    float2 _S331 = _S328->dx_0;
    float2 _S332 = _S328->dy_0;
    float _S333 = dot(_S328->dx_0, _S328->dx_0) + dot(_S328->dy_0, _S328->dy_0);
    float _S334 = _S328->dx_0.x * _S328->dy_0.y - _S328->dx_0.y * _S328->dy_0.x;
    float _S335 = 0.5f * (_S333 + sqrt(max(_S333 * _S333 - 4.0f * _S334 * _S334, 0.0f)));
    Neural_0 _S336 = _S329->neural_0;
    bool _S337;
    if(_S335 < (5.5f * (_S333 - _S335)))
    {
        _S337 = _S333 > (8.0f * _S336.pitch_0 * _S336.pitch_0);
    }
    else
    {
        _S337 = false;
    }
    float2 _S338 = float2(_S336.ends_per_mm_0, _S336.picks_per_mm_0);
    thread AnisotropicTaps_0 taps_1;
    (&taps_1)->centre_1 = _S328->centre_0 * _S338;
    float _S339;
    if(_S337)
    {
        _S339 = sqrt(0.125f * _S333);
    }
    else
    {
        _S339 = _S330.x;
    }
    (&taps_1)->side_0 = _S339 / _S336.pitch_0;
    float2 _S340;
    if(_S337)
    {
        _S340 = float2(0.25f)  * _S331;
    }
    else
    {
        _S340 = _S330.yz;
    }
    (&taps_1)->first_19 = _S340 * _S338;
    if(_S337)
    {
        _S340 = float2(0.25f)  * _S332;
    }
    else
    {
        _S340 = float2(0.5f)  * _S330.yz;
    }
    (&taps_1)->second_0 = _S340 * _S338;
    return taps_1;
}

void add_texel_0(uint _S341, uint _S342, float _S343, array<float, int(88)> thread* _S344, KernelContext_0 thread* kernelContext_42)
{
    uint _S345 = (kernelContext_42->fabrics_0+_S341)->neural_0.latents_0 + _S342 * 8U;
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
        Eight_0 _S346 = eight_halves_0(uint4(*(kernelContext_42->packed_numbers_0+(_S345 + part_0))) );
        int _S347 = int(8U * part_0);
        (*_S344)[_S347] = (*_S344)[_S347] + _S343 * _S346.low_0[int(0)];
        (*_S344)[_S347 + int(4)] = (*_S344)[_S347 + int(4)] + _S343 * _S346.high_0[int(0)];
        int _S348 = _S347 + int(1);
        (*_S344)[_S348] = (*_S344)[_S348] + _S343 * _S346.low_0[int(1)];
        (*_S344)[_S348 + int(4)] = (*_S344)[_S348 + int(4)] + _S343 * _S346.high_0[int(1)];
        int _S349 = _S347 + int(2);
        (*_S344)[_S349] = (*_S344)[_S349] + _S343 * _S346.low_0[int(2)];
        (*_S344)[_S349 + int(4)] = (*_S344)[_S349 + int(4)] + _S343 * _S346.high_0[int(2)];
        int _S350 = _S347 + int(3);
        (*_S344)[_S350] = (*_S344)[_S350] + _S343 * _S346.low_0[int(3)];
        (*_S344)[_S350 + int(4)] = (*_S344)[_S350 + int(4)] + _S343 * _S346.high_0[int(3)];
        part_0 = part_0 + 1U;
    }
    return;
}

void add_level_0(uint _S351, uint _S352, bool _S353, float2 _S354, float _S355, array<float, int(88)> thread* _S356, KernelContext_0 thread* kernelContext_43)
{
    Neural_0 _S357 = (kernelContext_43->fabrics_0+_S351)->neural_0;
    uint _S358 = (kernelContext_43->fabrics_0+_S351)->neural_0.levels_1 + 4U * _S352;
    float _S359 = table_number_0(_S358, kernelContext_43);
    float _S360 = table_number_0(_S358 + 1U, kernelContext_43);
    float _S361 = table_number_0(_S358 + 2U, kernelContext_43);
    bool _S362;
    if(_S352 > 3U)
    {
        _S362 = _S352 < (_S357.top_level_0);
    }
    else
    {
        _S362 = false;
    }
    float _S363 = table_number_0(_S358 + 3U, kernelContext_43);
    float2 _S364 = _S354 * float2(_S363) ;
    float _S365;
    if(_S362)
    {
        _S365 = 1.0f;
    }
    else
    {
        _S365 = 0.5f;
    }
    float2 _S366 = _S364 - float2(_S365) ;
    float2 _S367 = floor(_S366);
    float2 _S368 = _S366 - _S367;
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
        float _S369 = float(corner_0 & 1U);
        float _S370 = float(corner_0 >> 1U);
        float2 _S371 = mix(float2(1.0f)  - _S368, _S368, float2(_S369, _S370));
        uint _S372 = uint(_S359 + wrapped_0(_S367.y + _S370, _S361) * _S360 + wrapped_0(_S367.x + _S369, _S360));
        uint _S373;
        if(_S353)
        {
            _S373 = _S357.texels_0;
        }
        else
        {
            _S373 = 0U;
        }
        add_texel_0(_S351, _S372 + _S373, _S355 * _S371.x * _S371.y, _S356, kernelContext_43);
        corner_0 = corner_0 + 1U;
    }
    return;
}

void code_footprint_0(uint _S374, const AnisotropicTaps_0 thread* _S375, float3 _S376, bool _S377, array<float, int(88)> thread* _S378, KernelContext_0 thread* kernelContext_44)
{
    float offset_2;
    Fabric_0 device* _S379 = kernelContext_44->fabrics_0+_S374;
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
        (*_S378)[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    float2 _S380 = float2(_S379->neural_0.ends_0, _S379->neural_0.picks_0);
    float _S381 = float(_S379->neural_0.top_level_0);
    float _S382 = clamp(binary_logarithm_0(max(_S375->side_0, 9.99999997475242708e-07f)) + 3.0f, 0.0f, _S381);
    float _S383 = min(floor(_S382), _S381 - 1.0f);
    bool _S384 = AnisotropicTaps_has_steps_0(_S375);
    uint _S385;
    if(_S384)
    {
        _S385 = 4U;
    }
    else
    {
        _S385 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S385))
        {
        }
        else
        {
            break;
        }
        float2 _S386 = AnisotropicTaps_place_0(_S375, number_1 >> 1U);
        float2 _S387 = clamp(_S386 - _S380 * floor(_S386 / _S380), float2(0.0f) , _S380);
        bool _S388 = (number_1 & 1U) != 0U;
        if(_S388)
        {
            offset_2 = _S382 - _S383;
        }
        else
        {
            offset_2 = 1.0f - (_S382 - _S383);
        }
        float _S389 = offset_2 / float(_S385);
        uint _S390 = uint(_S383);
        uint _S391;
        if(_S388)
        {
            _S391 = 1U;
        }
        else
        {
            _S391 = 0U;
        }
        add_level_0(_S374, _S390 + _S391, _S377, _S387, _S389, _S378, kernelContext_44);
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
            float offset_3 = _S376[number_2] - (float(bin_0) + 0.5f) / 8.0f;
            if(number_2 < int(2))
            {
                offset_2 = offset_3 - round(offset_3);
            }
            else
            {
                offset_2 = offset_3;
            }
            (*_S378)[int(64) + number_2 * int(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_2 = number_2 + int(1);
    }
    return;
}

float3 crown_fibres_0(uint _S392, bool _S393, bool _S394, KernelContext_0 thread* kernelContext_45)
{
    Fabric_0 device* _S395 = kernelContext_45->fabrics_0+_S392;
    float _S396;
    if(_S393)
    {
        if(_S394)
        {
            _S396 = - _S395->neural_0.warp_x_0;
        }
        else
        {
            _S396 = _S395->neural_0.warp_x_0;
        }
        return float3(_S396, _S395->neural_0.warp_y_0, _S395->neural_0.warp_roughness_0);
    }
    Neural_0 _S397 = _S395->neural_0;
    if(_S394)
    {
        _S396 = - _S397.weft_y_0;
    }
    else
    {
        _S396 = _S397.weft_y_0;
    }
    return float3(_S397.weft_x_0, _S396, _S397.weft_roughness_0);
}

void neural_view_0(uint _S398, const Footprint_0 thread* _S399, float3 _S400, NeuralView_0 thread* _S401, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S402 = kernelContext_46->fabrics_0+_S398;
    bool _S403 = (_S400.z) < 0.0f;
    AnisotropicTaps_0 _S404 = anisotropic_taps_0(_S398, _S399, kernelContext_46);
    thread AnisotropicTaps_0 _S405 = _S404;
    float3 _S406 = footprint_coordinates_0(&_S405);
    float3 _S407 = to_face_frame_0(_S400, _S403);
    thread HalfWeights_0 weights_23;
    (&weights_23)->first_2 = _S402->neural_0.network_0;
    thread AnisotropicTaps_0 _S408 = _S404;
    thread array<float, int(88)> inputs_23;
    code_footprint_0(_S398, &_S408, _S406, _S403, &inputs_23, kernelContext_46);
    thread HalfWeights_0 _S409 = weights_23;
    thread array<float, int(96)> hidden_1;
    dense_7(&_S409, 0U, false, &inputs_23, &hidden_1, kernelContext_46);
    thread HalfWeights_0 _S410 = weights_23;
    thread array<float, int(100)> fused_0;
    dense_part_8(&_S410, 1068U, false, &hidden_1, &fused_0, kernelContext_46);
    fused_0[int(96)] = _S407.x;
    fused_0[int(97)] = _S407.y;
    float3 _S411 = crown_fibres_0(_S398, true, _S403, kernelContext_46);
    float2 _S412 = _S407.xy;
    fused_0[int(98)] = dot(_S411.xy, _S412);
    float3 _S413 = crown_fibres_0(_S398, false, _S403, kernelContext_46);
    fused_0[int(99)] = dot(_S413.xy, _S412);
    thread HalfWeights_0 _S414 = weights_23;
    thread array<float, int(16)> of_hole_0;
    dense_6(&_S414, 2232U, false, &fused_0, &of_hole_0, kernelContext_46);
    thread HalfWeights_0 _S415 = weights_23;
    thread array<float, int(1)> hole_1;
    dense_5(&_S415, 2444U, false, &of_hole_0, &hole_1, kernelContext_46);
    thread HalfWeights_0 _S416 = weights_23;
    dense_4(&_S416, 2456U, false, &fused_0, &_S401->sums_7, kernelContext_46);
    _S401->hole_0 = clamp(hole_1[int(0)], 0.0f, 1.0f);
    _S401->correction_weight_0 = correction_weight_of_0(_S406.z);
    _S401->view_6 = _S407;
    _S401->back_5 = _S403;
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

void code_light_0(uint _S417, float3 _S418, float3 _S419, bool _S420, array<float, int(39)> thread* _S421, KernelContext_0 thread* kernelContext_47)
{
    (*_S421)[int(0)] = _S418.x;
    (*_S421)[int(1)] = _S418.y;
    (*_S421)[int(2)] = _S418.z;
    float3 _S422 = _S418 + _S419;
    float _S423 = _S422.z;
    float _S424 = _S423 * _S423 + 0.00009999999747379f;
    float2 _S425 = _S422.xy;
    float _S426 = 1.0f / (dot(_S425, _S425) + _S424);
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
        float3 _S427 = crown_fibres_0(_S417, family_10 == int(0), _S420, kernelContext_47);
        float2 _S428 = _S427.xy;
        (*_S421)[int(3) + family_10] = dot(_S428, _S418.xy);
        float _S429 = dot(_S428, _S425);
        float _S430 = _S429 * _S429;
        float _S431 = (0.75f * _S429 / (0.5f * sqrt(_S430 + _S424) + abs(_S429)) + 0.5f) * 8.0f;
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
            (*_S421)[int(5) + family_10 * int(16) + bin_1] = bump_0(_S431 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S432 = _S427.z;
        float _S433 = _S432 * _S432;
        float _S434 = _S430 * _S426 * (1.0f - _S433) + _S433;
        (*_S421)[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S433 * _S432 / (_S434 * _S434));
        family_10 = family_10 + int(1);
    }
    return;
}

float mixed_bundles_0(uint _S435, uint _S436, uint _S437, float3 _S438, float3 _S439, bool _S440, array<float, int(52)> thread* _S441, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S442 = kernelContext_48->fabrics_0+_S435;
    float3 _S443 = _S438 + _S439;
    float _S444 = 1.0f / (square_1(_S443) + 0.00009999999747379f);
    bool _S445;
    if(_S436 == 0U)
    {
        _S445 = _S440;
    }
    else
    {
        _S445 = false;
    }
    float _S446;
    if(_S445)
    {
        _S446 = - _S443.x;
    }
    else
    {
        _S446 = _S443.x;
    }
    if(_S436 == 1U)
    {
        _S445 = _S440;
    }
    else
    {
        _S445 = false;
    }
    float _S447;
    if(_S445)
    {
        _S447 = - _S443.y;
    }
    else
    {
        _S447 = _S443.y;
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
        uint _S448 = _S436 * 25U;
        uint _S449 = _S442->neural_0.bundles_0 + 4U * (_S448 + bundle_1);
        float _S450 = table_number_0(_S449, kernelContext_48);
        float _S451 = table_number_0(_S449 + 1U, kernelContext_48);
        float _S452 = table_number_0(_S449 + 2U, kernelContext_48);
        float _S453 = dot(float3(_S450, _S451, _S452), float3(_S446, _S447, _S443.z));
        float _S454 = _S453 * _S453 * _S444;
        float _S455 = table_number_0(_S449 + 3U, kernelContext_48);
        float _S456 = _S454 + _S455;
        uint _S457 = _S437 + _S448;
        uint _S458;
        if(_S440)
        {
            _S458 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S458 = bundle_1;
        }
        float sum_3 = sum_2 + max((*_S441)[_S457 + _S458], (*_S441)[_S457 + _S458] * 0.00999999977648258f) / (_S456 * _S456);
        bundle_1 = bundle_1 + 1U;
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

Components_0 neural_components_0(uint _S459, NeuralView_0 thread* _S460, float3 _S461, KernelContext_0 thread* kernelContext_49)
{
    float _S462;
    Fabric_0 device* _S463 = kernelContext_49->fabrics_0+_S459;
    bool _S464 = _S460->back_5;
    float3 _S465 = to_face_frame_0(_S461, _S460->back_5);
    float3 _S466 = _S460->view_6;
    thread HalfWeights_0 weights_24;
    Neural_0 _S467 = _S463->neural_0;
    (&weights_24)->first_2 = _S463->neural_0.network_0;
    thread array<float, int(39)> directions_0;
    code_light_0(_S459, _S465, _S460->view_6, _S460->back_5, &directions_0, kernelContext_49);
    thread array<float, int(96)> skip_0;
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
        skip_0[k_1] = _S460->sums_7[k_1];
        k_1 = k_1 + int(1);
    }
    thread HalfWeights_0 _S468 = weights_24;
    dense_3(&_S468, 3716U, true, &directions_0, &skip_0, kernelContext_49);
    thread array<float, int(96)> hidden_2;
    thread array<float, int(96)> next_0;
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
                _S462 = skip_0[k_1];
            }
            else
            {
                _S462 = 0.0f;
            }
            next_0[k_1] = _S462;
            k_1 = k_1 + int(1);
        }
        uint _S469 = 4208U + layer_0 * 1164U;
        thread HalfWeights_0 _S470 = weights_24;
        dense_2(&_S470, _S469, true, &hidden_2, &next_0, kernelContext_49);
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
    thread HalfWeights_0 _S471 = weights_24;
    thread array<float, int(52)> outputs_17;
    dense_1(&_S471, 7700U, false, &hidden_2, &outputs_17, kernelContext_49);
    bool _S472;
    if((_S467.is_corrected_0) != 0U)
    {
        _S472 = (_S465.z) > 0.0f;
    }
    else
    {
        _S472 = false;
    }
    if(_S472)
    {
        _S472 = (_S460->correction_weight_0) > 0.0f;
    }
    else
    {
        _S472 = false;
    }
    if(_S472)
    {
        thread FloatWeights_0 fitted_0;
        (&fitted_0)->first_0 = _S467.correction_0;
        thread FloatWeights_0 _S473 = fitted_0;
        thread array<float, int(50)> change_0;
        dense_0(&_S473, 0U, false, &hidden_2, &change_0, kernelContext_49);
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
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S460->correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S465.z) > 0.0f)
    {
        _S462 = 0.00999999977648258f;
    }
    else
    {
        _S462 = 0.00100000004749745f;
    }
    thread Components_0 result_3;
    float _S474 = unmapped_0(outputs_17[int(0)], _S462);
    (&result_3)->diffuse_warp_0 = _S474;
    float _S475 = unmapped_0(outputs_17[int(1)], _S462);
    (&result_3)->diffuse_weft_0 = _S475;
    float _S476 = 2979.9580078125f * _S462;
    float _S477 = mixed_bundles_0(_S459, 0U, 2U, _S465, _S466, _S464, &outputs_17, kernelContext_49);
    (&result_3)->specular_warp_0 = clamp(_S477, 0.0f, _S476);
    float _S478 = mixed_bundles_0(_S459, 1U, 2U, _S465, _S466, _S464, &outputs_17, kernelContext_49);
    (&result_3)->specular_weft_0 = clamp(_S478, 0.0f, _S476);
    (&result_3)->hole_2 = _S460->hole_0;
    (&result_3)->light_visibility_1 = min(light_visibility_of_0(_S474 + _S475, _S465, _S466, _S463->diffuse_blend_0), 1.0f - _S460->hole_0);
    return result_3;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_4;
    Albedos_0 weft_4;
};

FamilyAlbedos_0 albedos_over_0(uint _S479, const Footprint_0 thread* _S480, bool _S481, KernelContext_0 thread* kernelContext_50)
{
    Fabric_0 device* _S482 = kernelContext_50->fabrics_0+_S479;
    float2 _S483 = sqrt(_S480->dx_0 * _S480->dx_0 + _S480->dy_0 * _S480->dy_0);
    uint _S484 = _S482->warp_0;
    float2 _S485 = _S480->centre_0;
    Stretch_0 _S486 = stretch_of_0(_S482->warp_0, _S480->centre_0.x, _S483.x, kernelContext_50);
    uint _S487 = _S482->weft_0;
    Stretch_0 _S488 = stretch_of_0(_S482->weft_0, _S485.y, _S483.y, kernelContext_50);
    thread FamilyAlbedos_0 albedos_4;
    thread Stretch_0 _S489 = _S486;
    thread Stretch_0 _S490 = _S488;
    Albedos_0 _S491 = mean_albedos_0(_S484, _S487, &_S489, &_S490, _S481, kernelContext_50);
    (&albedos_4)->warp_4 = _S491;
    thread Stretch_0 _S492 = _S488;
    thread Stretch_0 _S493 = _S486;
    Albedos_0 _S494 = mean_albedos_0(_S487, _S484, &_S492, &_S493, _S481, kernelContext_50);
    (&albedos_4)->weft_4 = _S494;
    return albedos_4;
}

float openness_number_0(uint _S495, uint _S496, KernelContext_0 thread* kernelContext_51)
{
    float _S497 = table_number_0((kernelContext_51->fabrics_0+_S495)->openness_0 + _S496, kernelContext_51);
    return _S497;
}

Scattered_0 scattered_by_0(uint _S498, const Albedos_0 thread* _S499, uint _S500, float3 _S501, KernelContext_0 thread* kernelContext_52)
{
    uint _S502 = 159U + 2U * _S500;
    thread Scattered_0 yarn_1;
    float3 _S503 = _S501 * _S499->diffuse_reflect_0;
    float _S504 = openness_number_0(_S498, _S502, kernelContext_52);
    (&yarn_1)->back_4 = _S503 + float3(_S504)  * _S499->specular_reflect_0;
    float3 _S505 = _S501 * _S499->diffuse_transmit_0;
    float _S506 = openness_number_0(_S498, _S502 + 1U, kernelContext_52);
    (&yarn_1)->through_0 = _S505 + float3(_S506)  * _S499->specular_transmit_0;
    return yarn_1;
}

float openness_number_1(uint _S507, uint _S508, KernelContext_0 thread* kernelContext_53)
{
    float _S509 = table_number_0((kernelContext_53->fabrics_0+_S507)->openness_0 + _S508, kernelContext_53);
    return _S509;
}

void sent_0(uint _S510, uint _S511, float3 _S512, float3 _S513, float3 _S514, float3 _S515, float3 thread* _S516, float3 thread* _S517, KernelContext_0 thread* kernelContext_54)
{
    uint _S518 = 146U + 4U * _S511;
    float _S519 = openness_number_1(_S510, _S518, kernelContext_54);
    float _S520 = openness_number_1(_S510, _S518 + 1U, kernelContext_54);
    float _S521 = openness_number_1(_S510, _S518 + 2U, kernelContext_54);
    float _S522 = openness_number_1(_S510, _S518 + 3U, kernelContext_54);
    float3 _S523 = float3(1.0f) ;
    float3 _S524 = _S523 - _S514 * float3(_S519) ;
    float3 _S525 = _S523 - _S515 * float3(_S522) ;
    float3 _S526 = _S523 / (_S524 * _S525 - _S514 * _S515 * float3((_S520 * _S521)) );
    *_S516 = (_S512 * _S525 + _S514 * float3(_S520)  * _S513) * _S526;
    *_S517 = (_S513 * _S524 + _S515 * float3(_S521)  * _S512) * _S526;
    return;
}

FaceSends_0 face_sends_0(uint _S527, uint _S528, const Scattered_0 thread* _S529, const Scattered_0 thread* _S530, KernelContext_0 thread* kernelContext_55)
{
    uint _S531 = 2U * _S528;
    uint _S532 = 142U + _S531;
    float _S533 = openness_number_0(_S527, _S532, kernelContext_55);
    float _S534 = openness_number_0(_S527, _S532 + 1U, kernelContext_55);
    float3 _S535 = _S529->back_4;
    float3 _S536 = float3((1.0f - _S533))  * _S529->back_4;
    float3 _S537 = _S530->back_4;
    float3 _S538 = float3((1.0f - _S534))  * _S530->back_4;
    thread FaceSends_0 sends_1;
    uint _S539 = 154U + _S531;
    float _S540 = openness_number_0(_S527, _S539, kernelContext_55);
    (&sends_1)->blocks_warp_0 = _S540;
    float _S541 = openness_number_0(_S527, _S539 + 1U, kernelContext_55);
    (&sends_1)->blocks_weft_0 = _S541;
    (&sends_1)->open_0 = _S540 * _S533 + _S541 * _S534;
    sent_0(_S527, _S528, float3(_S533)  * _S535, float3(_S534)  * _S537, _S536, _S538, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0, kernelContext_55);
    sent_0(_S527, _S528, _S529->through_0, _S530->through_0, _S536, _S538, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0, kernelContext_55);
    return sends_1;
}

Interior_0 interior_of_0(uint _S542, float3 _S543, bool _S544, KernelContext_0 thread* kernelContext_56)
{
    Fabric_0 device* _S545 = kernelContext_56->fabrics_0+_S542;
    Albedos_0 _S546 = table_albedos_0((kernelContext_56->families_0+_S545->warp_0)->colour_mean_0, kernelContext_56);
    thread Albedos_0 _S547 = _S546;
    Scattered_0 _S548 = scattered_by_0(_S542, &_S547, 0U, _S543, kernelContext_56);
    Albedos_0 _S549 = table_albedos_0((kernelContext_56->families_0+_S545->weft_0)->colour_mean_0, kernelContext_56);
    thread Albedos_0 _S550 = _S549;
    Scattered_0 _S551 = scattered_by_0(_S542, &_S550, 1U, _S543, kernelContext_56);
    uint _S552;
    if(_S544)
    {
        _S552 = 1U;
    }
    else
    {
        _S552 = 0U;
    }
    thread Scattered_0 _S553 = _S548;
    thread Scattered_0 _S554 = _S551;
    FaceSends_0 _S555 = face_sends_0(_S542, _S552, &_S553, &_S554, kernelContext_56);
    if(_S544)
    {
        _S552 = 0U;
    }
    else
    {
        _S552 = 1U;
    }
    thread Scattered_0 _S556 = _S548;
    thread Scattered_0 _S557 = _S551;
    FaceSends_0 _S558 = face_sends_0(_S542, _S552, &_S556, &_S557, kernelContext_56);
    float3 _S559 = float3(_S555.blocks_warp_0) ;
    float3 _S560 = float3(_S555.blocks_weft_0) ;
    float3 _S561 = _S559 * _S555.crossing_warp_0 + _S560 * _S555.crossing_weft_0;
    float3 _S562 = float3(_S558.blocks_warp_0) ;
    float3 _S563 = float3(_S558.blocks_weft_0) ;
    float3 _S564 = _S562 * _S558.crossing_warp_0 + _S563 * _S558.crossing_weft_0;
    float _S565 = 1.0f - _S555.open_0;
    float _S566 = 1.0f - _S558.open_0;
    float3 _S567 = float3(1.0f) ;
    float3 _S568 = _S567 / (_S567 - _S561 * _S564 * float3((_S565 * _S566)) );
    float3 _S569 = _S564 * (float3(_S555.open_0)  + float3(_S565)  * (_S559 * _S555.sky_warp_0 + _S560 * _S555.sky_weft_0)) * _S568;
    float3 _S570 = _S561 * (float3(_S558.open_0)  + float3(_S566)  * (_S562 * _S558.sky_warp_0 + _S563 * _S558.sky_weft_0)) * _S568;
    thread FaceSends_0 _S571 = _S555;
    FaceRadiance_0 _S572 = face_radiance_0(&_S571, _S558.open_0, _S569, _S570);
    thread FaceSends_0 _S573 = _S558;
    FaceRadiance_0 _S574 = face_radiance_0(&_S573, _S555.open_0, _S570, _S569);
    thread Interior_0 interior_1;
    (&interior_1)->warp_3 = _S572.warp_2;
    (&interior_1)->weft_3 = _S572.weft_2;
    (&interior_1)->leaked_1 = _S572.leaked_0;
    (&interior_1)->far_1 = _S574.mean_0;
    (&interior_1)->far_leaked_0 = _S574.leaked_0;
    return interior_1;
}

Blocked_0 blocked_of_terms_0(uint _S575, uint _S576, const array<float, int(6)> thread* _S577, uint _S578, KernelContext_0 thread* kernelContext_57)
{
    thread array<float, int(3)> shares_0;
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
            if(term_0 < _S578)
            {
            }
            else
            {
                break;
            }
            float _S579 = openness_number_0(_S575, _S576 + share_1 * _S578 + term_0, kernelContext_57);
            shares_0[share_1] = shares_0[share_1] + _S579 * (*_S577)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_1] = saturate(shares_0[share_1]);
        share_1 = share_1 + 1U;
    }
    thread Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

Blocked_0 blocked_from_0(uint _S580, float3 _S581, bool _S582, bool _S583, KernelContext_0 thread* kernelContext_58)
{
    thread array<float, int(6)> terms_1;
    view_terms_0(_S581, &terms_1);
    uint _S584;
    if(_S583)
    {
        _S584 = 2U;
    }
    else
    {
        _S584 = 0U;
    }
    uint _S585;
    if(_S582)
    {
        _S585 = 0U;
    }
    else
    {
        _S585 = 1U;
    }
    uint _S586 = (_S584 + _S585) * 15U;
    thread array<float, int(6)> _S587 = terms_1;
    Blocked_0 _S588 = blocked_of_terms_0(_S580, _S586, &_S587, 5U, kernelContext_58);
    return _S588;
}

float warp_seen_from_0(uint _S589, float3 _S590, bool _S591, KernelContext_0 thread* kernelContext_59)
{
    thread array<float, int(6)> terms_2;
    view_terms_0(_S590, &terms_2);
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
        uint _S592;
        if(_S591)
        {
            _S592 = 5U;
        }
        else
        {
            _S592 = 0U;
        }
        float _S593 = openness_number_0(_S589, 132U + _S592 + term_1, kernelContext_59);
        float share_3 = share_2 + _S593 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_2 = share_3;
    }
    return saturate(share_2);
}

Bounced_0 bounced_of_families_0(uint _S594, const FamilyAlbedos_0 thread* _S595, float3 _S596, const Interior_0 thread* _S597, const Blocked_0 thread* _S598, const Blocked_0 thread* _S599, KernelContext_0 thread* kernelContext_60)
{
    Scattered_0 _S600 = scattered_by_0(_S594, &_S595->warp_4, 0U, _S596, kernelContext_60);
    thread Scattered_0 _S601 = _S600;
    Bounced_0 _S602 = bounced_by_0(_S598, &_S601, _S597);
    Scattered_0 _S603 = scattered_by_0(_S594, &_S595->weft_4, 1U, _S596, kernelContext_60);
    thread Scattered_0 _S604 = _S603;
    Bounced_0 _S605 = bounced_by_0(_S599, &_S604, _S597);
    thread Bounced_0 _S606 = _S602;
    thread Bounced_0 _S607 = _S605;
    Bounced_0 _S608 = sum_of_0(&_S606, &_S607);
    return _S608;
}

Bounced_0 bounced_far_0(uint _S609, const FamilyAlbedos_0 thread* _S610, float3 _S611, const Interior_0 thread* _S612, float3 _S613, bool _S614, float _S615, float _S616, float _S617, KernelContext_0 thread* kernelContext_61)
{
    Blocked_0 _S618 = blocked_from_0(_S609, _S613, true, _S614, kernelContext_61);
    Blocked_0 _S619 = blocked_from_0(_S609, _S613, false, _S614, kernelContext_61);
    float _S620 = _S615 / max(1.0f - _S618.by_warp_0 - _S618.by_weft_0, 0.10000000149011612f);
    float _S621 = _S616 / max(1.0f - _S619.by_warp_0 - _S619.by_weft_0, 0.10000000149011612f);
    float _S622 = warp_seen_from_0(_S609, _S613, _S614, kernelContext_61);
    float _S623 = (0.0020000000949949f * _S622 + _S620) / (_S620 + _S621 + 0.0020000000949949f);
    float _S624 = 1.0f - _S617;
    float _S625 = _S623 * _S624;
    thread Blocked_0 _S626 = _S618;
    Blocked_0 _S627 = scaled_0(&_S626, _S625);
    float _S628 = (1.0f - _S623) * _S624;
    thread Blocked_0 _S629 = _S619;
    Blocked_0 _S630 = scaled_0(&_S629, _S628);
    thread Blocked_0 _S631 = _S627;
    thread Blocked_0 _S632 = _S630;
    Bounced_0 _S633 = bounced_of_families_0(_S609, _S610, _S611, _S612, &_S631, &_S632, kernelContext_61);
    return _S633;
}

Bounced_0 bounced_over_0(uint _S634, const Components_0 thread* _S635, const CloseUp_0 thread* _S636, const FamilyAlbedos_0 thread* _S637, float3 _S638, float3 _S639, KernelContext_0 thread* kernelContext_62)
{
    bool _S640 = (_S639.z) < 0.0f;
    Interior_0 _S641 = interior_of_0(_S634, _S638, _S640, kernelContext_62);
    float3 _S642 = to_face_frame_0(_S639, _S640);
    thread Interior_0 _S643 = _S641;
    Bounced_0 _S644 = bounced_far_0(_S634, _S637, _S638, &_S643, _S642, _S640, _S635->diffuse_warp_0, _S635->diffuse_weft_0, _S635->hole_2, kernelContext_62);
    thread Bounced_0 bounced_2 = _S644;
    float _S645 = _S636->weight_2;
    if((_S636->weight_2) > 0.0f)
    {
        thread Interior_0 _S646 = _S641;
        Bounced_0 _S647 = bounced_of_families_0(_S634, _S637, _S638, &_S646, &_S636->warp_1, &_S636->weft_1, kernelContext_62);
        float3 _S648 = float3(_S645) ;
        (&bounced_2)->reflected_0 = mix((&bounced_2)->reflected_0, _S647.reflected_0, _S648);
        (&bounced_2)->transmitted_0 = mix((&bounced_2)->transmitted_0, _S647.transmitted_0, _S648);
    }
    return bounced_2;
}

float3 composed_0(uint _S649, const Components_0 thread* _S650, const CloseUp_0 thread* _S651, const FamilyAlbedos_0 thread* _S652, float3 _S653, float3 _S654, float3 _S655, KernelContext_0 thread* kernelContext_63)
{
    Fabric_0 device* _S656 = kernelContext_63->fabrics_0+_S649;
    Albedos_0 _S657 = tinted_0(&_S652->warp_4, _S653);
    Albedos_0 _S658 = tinted_0(&_S652->weft_4, _S653);
    float3 _S659 = float3(_S650->diffuse_warp_0) ;
    float3 _S660 = float3(_S650->diffuse_weft_0) ;
    float3 _S661 = float3(_S650->specular_warp_0) ;
    float3 _S662 = float3(_S650->specular_weft_0) ;
    float3 _S663 = _S657.diffuse_reflect_0 * _S659 + _S658.diffuse_reflect_0 * _S660 + _S657.specular_reflect_0 * _S661 + _S658.specular_reflect_0 * _S662;
    float _S664 = _S655.z;
    float3 body_0;
    if((_S654.z * _S664) < 0.0f)
    {
        body_0 = _S657.diffuse_transmit_0 * _S659 + _S658.diffuse_transmit_0 * _S660 + _S657.specular_transmit_0 * _S661 + _S658.specular_transmit_0 * _S662;
    }
    else
    {
        body_0 = _S663;
    }
    if((_S656->openness_0) != 4294967295U)
    {
        Bounced_0 _S665 = bounced_over_0(_S649, _S650, _S651, _S652, _S653, _S655, kernelContext_63);
        thread Bounced_0 _S666 = _S665;
        float3 _S667 = bounced_value_0(&_S666, _S654, _S655);
        body_0 = body_0 + _S667;
    }
    float _S668 = _S656->sheen_strength_0;
    if((_S656->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S669 = _S664 < 0.0f;
    float2 _S670 = sheen_with_transmittance_0(to_face_frame_0(_S654, _S669), to_face_frame_0(_S655, _S669), _S668, _S656->sheen_roughness_0);
    return float3(_S670.y)  * body_0 + float3(((_S650->light_visibility_1 + _S650->hole_2) * _S670.x)) ;
}

float4 cloth_value_0(uint fabric_1, float2 centre_3, float2 dx_1, float2 dy_1, float3 light_5, float3 view_7, KernelContext_0 thread* kernelContext_64)
{
    thread Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = centre_3;
    (&footprint_1)->dx_0 = dx_1;
    (&footprint_1)->dy_0 = dy_1;
    thread Footprint_0 _S671 = footprint_1;
    thread NeuralView_0 activations_0;
    neural_view_0(fabric_1, &_S671, view_7, &activations_0, kernelContext_64);
    Components_0 _S672 = neural_components_0(fabric_1, &activations_0, light_5, kernelContext_64);
    float _S673 = view_7.z;
    bool _S674 = _S673 < 0.0f;
    thread Footprint_0 _S675 = footprint_1;
    FamilyAlbedos_0 _S676 = albedos_over_0(fabric_1, &_S675, _S674, kernelContext_64);
    CloseUp_0 _S677 = no_close_up_0();
    float3 _S678 = float3(1.0f) ;
    thread Components_0 _S679 = _S672;
    thread CloseUp_0 _S680 = _S677;
    thread FamilyAlbedos_0 _S681 = _S676;
    float3 _S682 = composed_0(fabric_1, &_S679, &_S680, &_S681, _S678, light_5, view_7, kernelContext_64);
    float through_1 = (&activations_0)->hole_0;
    float through_2;
    if(((kernelContext_64->fabrics_0+fabric_1)->sheen_strength_0) > 0.0f)
    {
        through_2 = through_1 * (1.0f - (kernelContext_64->fabrics_0+fabric_1)->sheen_strength_0 * sheen_lobe_0(abs(_S673), (kernelContext_64->fabrics_0+fabric_1)->sheen_roughness_0).z);
    }
    else
    {
        through_2 = through_1;
    }
    return float4(_S682, through_2);
}

[[kernel]] void neural_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], packed_uint4 device* packed_numbers_1 [[buffer(10)]], uint device* words_1 [[buffer(2)]], Family_0 device* families_1 [[buffer(1)]])
{
    thread KernelContext_0 kernelContext_65;
    (&kernelContext_65)->query_count_0 = query_count_1;
    (&kernelContext_65)->queries_0 = queries_1;
    (&kernelContext_65)->answers_0 = answers_1;
    (&kernelContext_65)->fabrics_0 = fabrics_1;
    (&kernelContext_65)->packed_numbers_0 = packed_numbers_1;
    (&kernelContext_65)->words_0 = words_1;
    (&kernelContext_65)->families_0 = families_1;
    uint _S683 = id_0.x;
    if(_S683 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S684 = (&kernelContext_65)->queries_0[_S683];
    packed_float4 device* _S685 = (&kernelContext_65)->answers_0+_S683;
    float4 _S686 = cloth_value_0(_S684.fabric_0, float2(_S684.centre_x_0, _S684.centre_y_0), float2(_S684.dx_x_0, _S684.dx_y_0), float2(_S684.dy_x_0, _S684.dy_y_0), float3(_S684.light_x_0, _S684.light_y_0, _S684.light_z_0), float3(_S684.view_x_0, _S684.view_y_0, _S684.view_z_0), &kernelContext_65);
    *_S685 = packed_float4(_S686) ;
    return;
}

