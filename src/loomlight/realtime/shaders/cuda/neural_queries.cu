#include <slang-cuda-prelude.h>
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
    uint seed_0;
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

struct Light_0
{
    uint is_point_0;
    float x_0;
    float y_0;
    float z_0;
    float red_0;
    float green_0;
    float blue_0;
};

struct Frame_0
{
    uint width_1;
    uint height_1;
    uint lights_0;
    uint samples_1;
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

struct Vertex_0
{
    float x_1;
    float y_1;
    float z_1;
    float normal_x_0;
    float normal_y_0;
    float normal_z_0;
    float u_0;
    float v_0;
};

struct Layer_0
{
    uint face_0;
    float share_0;
};

struct Bake_0
{
    uint fabric_0;
    uint per_family_0;
    uint packs_1;
    uint max_clusters_0;
    uint rays_0;
    float ends_2;
    float picks_1;
    float spacing_x_0;
    float spacing_y_0;
    uint columns_1;
    uint rows_1;
    uint face_nodes_1;
    uint texels_across_0;
    uint texels_along_0;
    float texel_x_0;
    float texel_y_0;
    float far_weight_0;
    uint moments_table_0;
    uint record_warp_packs_0;
    uint record_hole_weights_0;
    uint facts_0;
    uint gaps_0;
    uint gap_nulls_0;
    uint lit_0;
    uint lists_0;
    uint points_0;
    uint clusters_1;
    uint cluster_means_0;
    uint cluster_errors_0;
    uint centroids_0;
    uint view_sums_0;
    uint light_sums_0;
    uint group_moments_0;
    uint areas_0;
    uint area_scales_0;
    uint row_totals_0;
    uint row_largest_0;
    uint coverage_means_0;
    uint coverage_scales_0;
    uint hole_bytes_0;
};

struct SurfaceHit_0
{
    float x_2;
    float y_2;
    uint flags_0;
    float normal_x_1;
    float normal_y_1;
    float normal_z_1;
    float tangent_x_0;
    float tangent_y_0;
    float tangent_z_0;
};

struct Query_0
{
    uint fabric_1;
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
    uint seed_1;
};

struct GlobalParams_0
{
    StructuredBuffer<Fabric_0> fabrics_0;
    StructuredBuffer<Family_0> families_0;
    StructuredBuffer<uint> words_0;
    StructuredBuffer<Light_0> lights_1;
    StructuredBuffer<Frame_0> frames_1;
    StructuredBuffer<Vertex_0> vertices_0;
    StructuredBuffer<uint> corners_0;
    StructuredBuffer<uint> face_fabrics_0;
    RWStructuredBuffer<float4 > radiance_0;
    RWStructuredBuffer<uint> pixels_0;
    StructuredBuffer<uint4 > packed_numbers_0;
    StructuredBuffer<uint> scene_words_0;
    RWStructuredBuffer<Layer_0> layers_0;
    RWStructuredBuffer<float> visibilities_0;
    StructuredBuffer<Bake_0> bakes_0;
    StructuredBuffer<uint> steps_0;
    RWStructuredBuffer<SurfaceHit_0> hits_0;
    RWStructuredBuffer<uint> scratch_0;
    RWStructuredBuffer<uint> texel_counters_0;
    StructuredBuffer<uint> texel_counts_0;
    RWStructuredBuffer<float4 > coverage_pyramid_0;
    RWStructuredBuffer<uint> tables_0;
    RWStructuredBuffer<uint> record_words_0;
    CUtexObject visible_faces_0;
    StructuredBuffer<Query_0> queries_0;
    StructuredBuffer<uint> query_count_0;
    RWStructuredBuffer<float4 > answers_0;
};

extern "C" __constant__ GlobalParams_0 SLANG_globalParams;
#define globalParams_0 (&SLANG_globalParams)
__device__ float3  min_0(float3  x_3, float3  y_3)
{
    float3  result_0;
    int i_0 = int(0);
    for(;;)
    {
        if(i_0 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_0, i_0) = (F32_min((_slang_vector_get_element(x_3, i_0)), (_slang_vector_get_element(y_3, i_0))));
        i_0 = i_0 + int(1);
    }
    return result_0;
}

__device__ float3  max_0(float3  x_4, float3  y_4)
{
    float3  result_1;
    int i_1 = int(0);
    for(;;)
    {
        if(i_1 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_1, i_1) = (F32_max((_slang_vector_get_element(x_4, i_1)), (_slang_vector_get_element(y_4, i_1))));
        i_1 = i_1 + int(1);
    }
    return result_1;
}

__device__ float3  clamp_0(float3  x_5, float3  minBound_0, float3  maxBound_0)
{
    return min_0(max_0(x_5, minBound_0), maxBound_0);
}

struct FloatWeights_0
{
    uint first_0;
};

struct Eight_0
{
    float4  low_0;
    float4  high_0;
};

__device__ float4  asfloat_0(uint4  x_6)
{
    float4  result_2;
    int i_2 = int(0);
    for(;;)
    {
        if(i_2 < int(4))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_2, i_2) = (U32_asfloat((_slang_vector_get_element(x_6, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_2;
}

__device__ Eight_0 FloatWeights_eight_0(FloatWeights_0 * this_0, uint element_0)
{
    Eight_0 numbers_0;
    uint _S1 = this_0->first_0 + 2U * element_0;
    uint4  _S2 = __ldg((&(globalParams_0->packed_numbers_0)[_S1]));
    (&numbers_0)->low_0 = asfloat_0(_S2);
    uint4  _S3 = __ldg((&(globalParams_0->packed_numbers_0)[_S1 + 1U]));
    (&numbers_0)->high_0 = asfloat_0(_S3);
    return numbers_0;
}

__device__ float dot_0(float4  x_7, float4  y_5)
{
    int i_3 = int(0);
    float result_3 = 0.0f;
    for(;;)
    {
        if(i_3 < int(4))
        {
        }
        else
        {
            break;
        }
        float result_4 = result_3 + _slang_vector_get_element(x_7, i_3) * _slang_vector_get_element(y_5, i_3);
        i_3 = i_3 + int(1);
        result_3 = result_4;
    }
    return result_3;
}

__device__ float4  tile_product_0(FloatWeights_0 * weights_0, uint row_0, FixedArray<float, 96>  * inputs_0)
{
    float4  sums_1 = make_float4 (0.0f);
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
        float4  low_1;
        float4  high_1;
        int _S4 = int(8U * column_0);
        *&((&low_1)->x) = (*inputs_0)[_S4];
        *&((&high_1)->x) = (*inputs_0)[_S4 + int(4)];
        int _S5 = _S4 + int(1);
        *&((&low_1)->y) = (*inputs_0)[_S5];
        *&((&high_1)->y) = (*inputs_0)[_S5 + int(4)];
        int _S6 = _S4 + int(2);
        *&((&low_1)->z) = (*inputs_0)[_S6];
        *&((&high_1)->z) = (*inputs_0)[_S6 + int(4)];
        int _S7 = _S4 + int(3);
        *&((&low_1)->w) = (*inputs_0)[_S7];
        *&((&high_1)->w) = (*inputs_0)[_S7 + int(4)];
        Eight_0 _S8 = FloatWeights_eight_0(weights_0, row_0 + column_0);
        *&((&sums_1)->x) = *&((&sums_1)->x) + (dot_0(_S8.low_0, low_1) + dot_0(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        *&((&sums_1)->y) = *&((&sums_1)->y) + (dot_0(_S9.low_0, low_1) + dot_0(_S9.high_0, high_1));
        Eight_0 _S10 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        *&((&sums_1)->z) = *&((&sums_1)->z) + (dot_0(_S10.low_0, low_1) + dot_0(_S10.high_0, high_1));
        Eight_0 _S11 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        *&((&sums_1)->w) = *&((&sums_1)->w) + (dot_0(_S11.low_0, low_1) + dot_0(_S11.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
}

__device__ int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

__device__ float Identity_apply_0(float x_8)
{
    return x_8;
}

__device__ void dense_part_0(FloatWeights_0 * weights_1, uint first_1, bool adds_0, FixedArray<float, 96>  * inputs_1, FixedArray<float, 50>  * outputs_0)
{
    uint _S12 = first_1 + uint(whole_parts_0(int(7)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S13 = output_0 < int(50);
        if(_S13)
        {
        }
        else
        {
            break;
        }
        uint _S14 = uint(output_0);
        Eight_0 _S15 = FloatWeights_eight_0(weights_1, first_1 + _S14 / 8U);
        float4  _S16 = tile_product_0(weights_1, _S12 + _S14 * 12U, inputs_1);
        float4  _S17;
        if((output_0 & int(4)) != int(0))
        {
            _S17 = _S15.high_0;
        }
        else
        {
            _S17 = _S15.low_0;
        }
        float4  _S18 = _S16 + _S17;
        float _S19;
        if(_S13)
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[output_0];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[output_0] = Identity_apply_0(_S18.x + _S19);
        }
        int _S20 = output_0 + int(1);
        if(_S20 < int(50))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S20];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S20] = Identity_apply_0(_S18.y + _S19);
        }
        int _S21 = output_0 + int(2);
        if(_S21 < int(50))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S21];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S21] = Identity_apply_0(_S18.z + _S19);
        }
        int _S22 = output_0 + int(3);
        if(_S22 < int(50))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S22];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S22] = Identity_apply_0(_S18.w + _S19);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

struct HalfWeights_0
{
    uint first_2;
};

__device__ float2  f16tof32_0(uint2  value_0)
{
    float2  result_5;
    int i_4 = int(0);
    for(;;)
    {
        if(i_4 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_5, i_4) = (__half2float(__ushort_as_half((_slang_vector_get_element(value_0, i_4)))));
        i_4 = i_4 + int(1);
    }
    return result_5;
}

__device__ Eight_0 eight_halves_0(uint4  packed_0)
{
    Eight_0 numbers_1;
    uint _S23 = packed_0.x;
    uint _S24 = packed_0.y;
    (&numbers_1)->low_0 = make_float4 (f16tof32_0(make_uint2 (_S23 & 65535U, _S23 >> 16U)).x, f16tof32_0(make_uint2 (_S23 & 65535U, _S23 >> 16U)).y, f16tof32_0(make_uint2 (_S24 & 65535U, _S24 >> 16U)).x, f16tof32_0(make_uint2 (_S24 & 65535U, _S24 >> 16U)).y);
    uint _S25 = packed_0.z;
    uint _S26 = packed_0.w;
    (&numbers_1)->high_0 = make_float4 (f16tof32_0(make_uint2 (_S25 & 65535U, _S25 >> 16U)).x, f16tof32_0(make_uint2 (_S25 & 65535U, _S25 >> 16U)).y, f16tof32_0(make_uint2 (_S26 & 65535U, _S26 >> 16U)).x, f16tof32_0(make_uint2 (_S26 & 65535U, _S26 >> 16U)).y);
    return numbers_1;
}

__device__ Eight_0 HalfWeights_eight_0(HalfWeights_0 * this_1, uint element_1)
{
    uint4  _S27 = __ldg((&(globalParams_0->packed_numbers_0)[this_1->first_2 + element_1]));
    return eight_halves_0(_S27);
}

__device__ float4  tile_product_1(HalfWeights_0 * weights_2, uint row_1, FixedArray<float, 96>  * inputs_2)
{
    float4  sums_2 = make_float4 (0.0f);
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
        float4  low_2;
        float4  high_2;
        int _S28 = int(8U * column_1);
        *&((&low_2)->x) = (*inputs_2)[_S28];
        *&((&high_2)->x) = (*inputs_2)[_S28 + int(4)];
        int _S29 = _S28 + int(1);
        *&((&low_2)->y) = (*inputs_2)[_S29];
        *&((&high_2)->y) = (*inputs_2)[_S29 + int(4)];
        int _S30 = _S28 + int(2);
        *&((&low_2)->z) = (*inputs_2)[_S30];
        *&((&high_2)->z) = (*inputs_2)[_S30 + int(4)];
        int _S31 = _S28 + int(3);
        *&((&low_2)->w) = (*inputs_2)[_S31];
        *&((&high_2)->w) = (*inputs_2)[_S31 + int(4)];
        Eight_0 _S32 = HalfWeights_eight_0(weights_2, row_1 + column_1);
        *&((&sums_2)->x) = *&((&sums_2)->x) + (dot_0(_S32.low_0, low_2) + dot_0(_S32.high_0, high_2));
        Eight_0 _S33 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1);
        *&((&sums_2)->y) = *&((&sums_2)->y) + (dot_0(_S33.low_0, low_2) + dot_0(_S33.high_0, high_2));
        Eight_0 _S34 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1);
        *&((&sums_2)->z) = *&((&sums_2)->z) + (dot_0(_S34.low_0, low_2) + dot_0(_S34.high_0, high_2));
        Eight_0 _S35 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1);
        *&((&sums_2)->w) = *&((&sums_2)->w) + (dot_0(_S35.low_0, low_2) + dot_0(_S35.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
}

__device__ void dense_part_1(HalfWeights_0 * weights_3, uint first_3, bool adds_1, FixedArray<float, 96>  * inputs_3, FixedArray<float, 52>  * outputs_1)
{
    uint _S36 = first_3 + uint(whole_parts_0(int(7)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S37 = output_1 < int(52);
        if(_S37)
        {
        }
        else
        {
            break;
        }
        uint _S38 = uint(output_1);
        Eight_0 _S39 = HalfWeights_eight_0(weights_3, first_3 + _S38 / 8U);
        float4  _S40 = tile_product_1(weights_3, _S36 + _S38 * 12U, inputs_3);
        float4  _S41;
        if((output_1 & int(4)) != int(0))
        {
            _S41 = _S39.high_0;
        }
        else
        {
            _S41 = _S39.low_0;
        }
        float4  _S42 = _S40 + _S41;
        float _S43;
        if(_S37)
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[output_1];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S42.x + _S43);
        }
        int _S44 = output_1 + int(1);
        if(_S44 < int(52))
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[_S44];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[_S44] = Identity_apply_0(_S42.y + _S43);
        }
        int _S45 = output_1 + int(2);
        if(_S45 < int(52))
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[_S45];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[_S45] = Identity_apply_0(_S42.z + _S43);
        }
        int _S46 = output_1 + int(3);
        if(_S46 < int(52))
        {
            if(adds_1)
            {
                _S43 = (*outputs_1)[_S46];
            }
            else
            {
                _S43 = 0.0f;
            }
            (*outputs_1)[_S46] = Identity_apply_0(_S42.w + _S43);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

__device__ float4  tile_product_2(HalfWeights_0 * weights_4, uint row_2, FixedArray<float, 39>  * inputs_4)
{
    float4  sums_3 = make_float4 (0.0f);
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
        float4  low_3;
        float4  high_3;
        int _S47 = int(8U * column_2);
        *&((&low_3)->x) = (*inputs_4)[(I32_min((_S47), (int(38))))];
        *&((&high_3)->x) = (*inputs_4)[(I32_min((_S47 + int(4)), (int(38))))];
        int _S48 = _S47 + int(1);
        *&((&low_3)->y) = (*inputs_4)[(I32_min((_S48), (int(38))))];
        *&((&high_3)->y) = (*inputs_4)[(I32_min((_S48 + int(4)), (int(38))))];
        int _S49 = _S47 + int(2);
        *&((&low_3)->z) = (*inputs_4)[(I32_min((_S49), (int(38))))];
        *&((&high_3)->z) = (*inputs_4)[(I32_min((_S49 + int(4)), (int(38))))];
        int _S50 = _S47 + int(3);
        *&((&low_3)->w) = (*inputs_4)[(I32_min((_S50), (int(38))))];
        *&((&high_3)->w) = (*inputs_4)[(I32_min((_S50 + int(4)), (int(38))))];
        Eight_0 _S51 = HalfWeights_eight_0(weights_4, row_2 + column_2);
        *&((&sums_3)->x) = *&((&sums_3)->x) + (dot_0(_S51.low_0, low_3) + dot_0(_S51.high_0, high_3));
        Eight_0 _S52 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2);
        *&((&sums_3)->y) = *&((&sums_3)->y) + (dot_0(_S52.low_0, low_3) + dot_0(_S52.high_0, high_3));
        Eight_0 _S53 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2);
        *&((&sums_3)->z) = *&((&sums_3)->z) + (dot_0(_S53.low_0, low_3) + dot_0(_S53.high_0, high_3));
        Eight_0 _S54 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2);
        *&((&sums_3)->w) = *&((&sums_3)->w) + (dot_0(_S54.low_0, low_3) + dot_0(_S54.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
}

__device__ void dense_part_2(HalfWeights_0 * weights_5, uint first_4, bool adds_2, FixedArray<float, 39>  * inputs_5, FixedArray<float, 96>  * outputs_2)
{
    uint _S55 = first_4 + uint(whole_parts_0(int(12)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S56 = output_2 < int(96);
        if(_S56)
        {
        }
        else
        {
            break;
        }
        uint _S57 = uint(output_2);
        Eight_0 _S58 = HalfWeights_eight_0(weights_5, first_4 + _S57 / 8U);
        float4  _S59 = tile_product_2(weights_5, _S55 + _S57 * 5U, inputs_5);
        float4  _S60;
        if((output_2 & int(4)) != int(0))
        {
            _S60 = _S58.high_0;
        }
        else
        {
            _S60 = _S58.low_0;
        }
        float4  _S61 = _S59 + _S60;
        float _S62;
        if(_S56)
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[output_2];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[output_2] = Identity_apply_0(_S61.x + _S62);
        }
        int _S63 = output_2 + int(1);
        if(_S63 < int(96))
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[_S63];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[_S63] = Identity_apply_0(_S61.y + _S62);
        }
        int _S64 = output_2 + int(2);
        if(_S64 < int(96))
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[_S64];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[_S64] = Identity_apply_0(_S61.z + _S62);
        }
        int _S65 = output_2 + int(3);
        if(_S65 < int(96))
        {
            if(adds_2)
            {
                _S62 = (*outputs_2)[_S65];
            }
            else
            {
                _S62 = 0.0f;
            }
            (*outputs_2)[_S65] = Identity_apply_0(_S61.w + _S62);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

__device__ float4  tile_product_3(HalfWeights_0 * weights_6, uint row_3, FixedArray<float, 100>  * inputs_6)
{
    float4  sums_4 = make_float4 (0.0f);
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
        float4  low_4;
        float4  high_4;
        int _S66 = int(8U * column_3);
        *&((&low_4)->x) = (*inputs_6)[(I32_min((_S66), (int(99))))];
        *&((&high_4)->x) = (*inputs_6)[(I32_min((_S66 + int(4)), (int(99))))];
        int _S67 = _S66 + int(1);
        *&((&low_4)->y) = (*inputs_6)[(I32_min((_S67), (int(99))))];
        *&((&high_4)->y) = (*inputs_6)[(I32_min((_S67 + int(4)), (int(99))))];
        int _S68 = _S66 + int(2);
        *&((&low_4)->z) = (*inputs_6)[(I32_min((_S68), (int(99))))];
        *&((&high_4)->z) = (*inputs_6)[(I32_min((_S68 + int(4)), (int(99))))];
        int _S69 = _S66 + int(3);
        *&((&low_4)->w) = (*inputs_6)[(I32_min((_S69), (int(99))))];
        *&((&high_4)->w) = (*inputs_6)[(I32_min((_S69 + int(4)), (int(99))))];
        Eight_0 _S70 = HalfWeights_eight_0(weights_6, row_3 + column_3);
        *&((&sums_4)->x) = *&((&sums_4)->x) + (dot_0(_S70.low_0, low_4) + dot_0(_S70.high_0, high_4));
        Eight_0 _S71 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3);
        *&((&sums_4)->y) = *&((&sums_4)->y) + (dot_0(_S71.low_0, low_4) + dot_0(_S71.high_0, high_4));
        Eight_0 _S72 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3);
        *&((&sums_4)->z) = *&((&sums_4)->z) + (dot_0(_S72.low_0, low_4) + dot_0(_S72.high_0, high_4));
        Eight_0 _S73 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3);
        *&((&sums_4)->w) = *&((&sums_4)->w) + (dot_0(_S73.low_0, low_4) + dot_0(_S73.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
}

__device__ void dense_part_3(HalfWeights_0 * weights_7, uint first_5, bool adds_3, FixedArray<float, 100>  * inputs_7, FixedArray<float, 96>  * outputs_3)
{
    uint _S74 = first_5 + uint(whole_parts_0(int(12)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S75 = output_3 < int(96);
        if(_S75)
        {
        }
        else
        {
            break;
        }
        uint _S76 = uint(output_3);
        Eight_0 _S77 = HalfWeights_eight_0(weights_7, first_5 + _S76 / 8U);
        float4  _S78 = tile_product_3(weights_7, _S74 + _S76 * 13U, inputs_7);
        float4  _S79;
        if((output_3 & int(4)) != int(0))
        {
            _S79 = _S77.high_0;
        }
        else
        {
            _S79 = _S77.low_0;
        }
        float4  _S80 = _S78 + _S79;
        float _S81;
        if(_S75)
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[output_3];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[output_3] = Identity_apply_0(_S80.x + _S81);
        }
        int _S82 = output_3 + int(1);
        if(_S82 < int(96))
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[_S82];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[_S82] = Identity_apply_0(_S80.y + _S81);
        }
        int _S83 = output_3 + int(2);
        if(_S83 < int(96))
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[_S83];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[_S83] = Identity_apply_0(_S80.z + _S81);
        }
        int _S84 = output_3 + int(3);
        if(_S84 < int(96))
        {
            if(adds_3)
            {
                _S81 = (*outputs_3)[_S84];
            }
            else
            {
                _S81 = 0.0f;
            }
            (*outputs_3)[_S84] = Identity_apply_0(_S80.w + _S81);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

__device__ float4  tile_product_4(HalfWeights_0 * weights_8, uint row_4, FixedArray<float, 16>  * inputs_8)
{
    float4  sums_5 = make_float4 (0.0f);
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
        float4  low_5;
        float4  high_5;
        int _S85 = int(8U * column_4);
        *&((&low_5)->x) = (*inputs_8)[_S85];
        *&((&high_5)->x) = (*inputs_8)[_S85 + int(4)];
        int _S86 = _S85 + int(1);
        *&((&low_5)->y) = (*inputs_8)[_S86];
        *&((&high_5)->y) = (*inputs_8)[_S86 + int(4)];
        int _S87 = _S85 + int(2);
        *&((&low_5)->z) = (*inputs_8)[_S87];
        *&((&high_5)->z) = (*inputs_8)[_S87 + int(4)];
        int _S88 = _S85 + int(3);
        *&((&low_5)->w) = (*inputs_8)[_S88];
        *&((&high_5)->w) = (*inputs_8)[_S88 + int(4)];
        Eight_0 _S89 = HalfWeights_eight_0(weights_8, row_4 + column_4);
        *&((&sums_5)->x) = *&((&sums_5)->x) + (dot_0(_S89.low_0, low_5) + dot_0(_S89.high_0, high_5));
        Eight_0 _S90 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4);
        *&((&sums_5)->y) = *&((&sums_5)->y) + (dot_0(_S90.low_0, low_5) + dot_0(_S90.high_0, high_5));
        Eight_0 _S91 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4);
        *&((&sums_5)->z) = *&((&sums_5)->z) + (dot_0(_S91.low_0, low_5) + dot_0(_S91.high_0, high_5));
        Eight_0 _S92 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4);
        *&((&sums_5)->w) = *&((&sums_5)->w) + (dot_0(_S92.low_0, low_5) + dot_0(_S92.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_5;
}

__device__ void dense_part_4(HalfWeights_0 * weights_9, uint first_6, bool adds_4, FixedArray<float, 16>  * inputs_9, FixedArray<float, 1>  * outputs_4)
{
    uint _S93 = first_6 + uint(whole_parts_0(int(1)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S94 = output_4 < int(1);
        if(_S94)
        {
        }
        else
        {
            break;
        }
        uint _S95 = uint(output_4);
        Eight_0 _S96 = HalfWeights_eight_0(weights_9, first_6 + _S95 / 8U);
        float4  _S97 = tile_product_4(weights_9, _S93 + _S95 * 2U, inputs_9);
        float4  _S98;
        if((output_4 & int(4)) != int(0))
        {
            _S98 = _S96.high_0;
        }
        else
        {
            _S98 = _S96.low_0;
        }
        float4  _S99 = _S97 + _S98;
        float _S100;
        if(_S94)
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[output_4];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[output_4] = Identity_apply_0(_S99.x + _S100);
        }
        int _S101 = output_4 + int(1);
        if(_S101 < int(1))
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[_S101];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[_S101] = Identity_apply_0(_S99.y + _S100);
        }
        int _S102 = output_4 + int(2);
        if(_S102 < int(1))
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[_S102];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[_S102] = Identity_apply_0(_S99.z + _S100);
        }
        int _S103 = output_4 + int(3);
        if(_S103 < int(1))
        {
            if(adds_4)
            {
                _S100 = (*outputs_4)[_S103];
            }
            else
            {
                _S100 = 0.0f;
            }
            (*outputs_4)[_S103] = Identity_apply_0(_S99.w + _S100);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

__device__ float LeakyRelu_apply_0(float x_9)
{
    return (F32_max((x_9), (x_9 * 0.00999999977648258f)));
}

__device__ void dense_part_5(HalfWeights_0 * weights_10, uint first_7, bool adds_5, FixedArray<float, 96>  * inputs_10, FixedArray<float, 96>  * outputs_5)
{
    uint _S104 = first_7 + uint(whole_parts_0(int(12)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S105 = output_5 < int(96);
        if(_S105)
        {
        }
        else
        {
            break;
        }
        uint _S106 = uint(output_5);
        Eight_0 _S107 = HalfWeights_eight_0(weights_10, first_7 + _S106 / 8U);
        float4  _S108 = tile_product_1(weights_10, _S104 + _S106 * 12U, inputs_10);
        float4  _S109;
        if((output_5 & int(4)) != int(0))
        {
            _S109 = _S107.high_0;
        }
        else
        {
            _S109 = _S107.low_0;
        }
        float4  _S110 = _S108 + _S109;
        float _S111;
        if(_S105)
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[output_5];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[output_5] = LeakyRelu_apply_0(_S110.x + _S111);
        }
        int _S112 = output_5 + int(1);
        if(_S112 < int(96))
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[_S112];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[_S112] = LeakyRelu_apply_0(_S110.y + _S111);
        }
        int _S113 = output_5 + int(2);
        if(_S113 < int(96))
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[_S113];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[_S113] = LeakyRelu_apply_0(_S110.z + _S111);
        }
        int _S114 = output_5 + int(3);
        if(_S114 < int(96))
        {
            if(adds_5)
            {
                _S111 = (*outputs_5)[_S114];
            }
            else
            {
                _S111 = 0.0f;
            }
            (*outputs_5)[_S114] = LeakyRelu_apply_0(_S110.w + _S111);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

__device__ void dense_part_6(HalfWeights_0 * weights_11, uint first_8, bool adds_6, FixedArray<float, 100>  * inputs_11, FixedArray<float, 16>  * outputs_6)
{
    uint _S115 = first_8 + uint(whole_parts_0(int(2)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S116 = output_6 < int(16);
        if(_S116)
        {
        }
        else
        {
            break;
        }
        uint _S117 = uint(output_6);
        Eight_0 _S118 = HalfWeights_eight_0(weights_11, first_8 + _S117 / 8U);
        float4  _S119 = tile_product_3(weights_11, _S115 + _S117 * 13U, inputs_11);
        float4  _S120;
        if((output_6 & int(4)) != int(0))
        {
            _S120 = _S118.high_0;
        }
        else
        {
            _S120 = _S118.low_0;
        }
        float4  _S121 = _S119 + _S120;
        float _S122;
        if(_S116)
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[output_6];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[output_6] = LeakyRelu_apply_0(_S121.x + _S122);
        }
        int _S123 = output_6 + int(1);
        if(_S123 < int(16))
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[_S123];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[_S123] = LeakyRelu_apply_0(_S121.y + _S122);
        }
        int _S124 = output_6 + int(2);
        if(_S124 < int(16))
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[_S124];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[_S124] = LeakyRelu_apply_0(_S121.z + _S122);
        }
        int _S125 = output_6 + int(3);
        if(_S125 < int(16))
        {
            if(adds_6)
            {
                _S122 = (*outputs_6)[_S125];
            }
            else
            {
                _S122 = 0.0f;
            }
            (*outputs_6)[_S125] = LeakyRelu_apply_0(_S121.w + _S122);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

__device__ float4  tile_product_5(HalfWeights_0 * weights_12, uint row_5, FixedArray<float, 88>  * inputs_12)
{
    float4  sums_6 = make_float4 (0.0f);
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
        float4  low_6;
        float4  high_6;
        int _S126 = int(8U * column_5);
        *&((&low_6)->x) = (*inputs_12)[_S126];
        *&((&high_6)->x) = (*inputs_12)[_S126 + int(4)];
        int _S127 = _S126 + int(1);
        *&((&low_6)->y) = (*inputs_12)[_S127];
        *&((&high_6)->y) = (*inputs_12)[_S127 + int(4)];
        int _S128 = _S126 + int(2);
        *&((&low_6)->z) = (*inputs_12)[_S128];
        *&((&high_6)->z) = (*inputs_12)[_S128 + int(4)];
        int _S129 = _S126 + int(3);
        *&((&low_6)->w) = (*inputs_12)[_S129];
        *&((&high_6)->w) = (*inputs_12)[_S129 + int(4)];
        Eight_0 _S130 = HalfWeights_eight_0(weights_12, row_5 + column_5);
        *&((&sums_6)->x) = *&((&sums_6)->x) + (dot_0(_S130.low_0, low_6) + dot_0(_S130.high_0, high_6));
        Eight_0 _S131 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5);
        *&((&sums_6)->y) = *&((&sums_6)->y) + (dot_0(_S131.low_0, low_6) + dot_0(_S131.high_0, high_6));
        Eight_0 _S132 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5);
        *&((&sums_6)->z) = *&((&sums_6)->z) + (dot_0(_S132.low_0, low_6) + dot_0(_S132.high_0, high_6));
        Eight_0 _S133 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5);
        *&((&sums_6)->w) = *&((&sums_6)->w) + (dot_0(_S133.low_0, low_6) + dot_0(_S133.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_6;
}

__device__ void dense_part_7(HalfWeights_0 * weights_13, uint first_9, bool adds_7, FixedArray<float, 88>  * inputs_13, FixedArray<float, 96>  * outputs_7)
{
    uint _S134 = first_9 + uint(whole_parts_0(int(12)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S135 = output_7 < int(96);
        if(_S135)
        {
        }
        else
        {
            break;
        }
        uint _S136 = uint(output_7);
        Eight_0 _S137 = HalfWeights_eight_0(weights_13, first_9 + _S136 / 8U);
        float4  _S138 = tile_product_5(weights_13, _S134 + _S136 * 11U, inputs_13);
        float4  _S139;
        if((output_7 & int(4)) != int(0))
        {
            _S139 = _S137.high_0;
        }
        else
        {
            _S139 = _S137.low_0;
        }
        float4  _S140 = _S138 + _S139;
        float _S141;
        if(_S135)
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[output_7];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[output_7] = LeakyRelu_apply_0(_S140.x + _S141);
        }
        int _S142 = output_7 + int(1);
        if(_S142 < int(96))
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[_S142];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[_S142] = LeakyRelu_apply_0(_S140.y + _S141);
        }
        int _S143 = output_7 + int(2);
        if(_S143 < int(96))
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[_S143];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[_S143] = LeakyRelu_apply_0(_S140.z + _S141);
        }
        int _S144 = output_7 + int(3);
        if(_S144 < int(96))
        {
            if(adds_7)
            {
                _S141 = (*outputs_7)[_S144];
            }
            else
            {
                _S141 = 0.0f;
            }
            (*outputs_7)[_S144] = LeakyRelu_apply_0(_S140.w + _S141);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

__device__ float2  min_1(float2  x_10, float2  y_6)
{
    float2  result_6;
    int i_5 = int(0);
    for(;;)
    {
        if(i_5 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_6, i_5) = (F32_min((_slang_vector_get_element(x_10, i_5)), (_slang_vector_get_element(y_6, i_5))));
        i_5 = i_5 + int(1);
    }
    return result_6;
}

__device__ float2  max_1(float2  x_11, float2  y_7)
{
    float2  result_7;
    int i_6 = int(0);
    for(;;)
    {
        if(i_6 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_7, i_6) = (F32_max((_slang_vector_get_element(x_11, i_6)), (_slang_vector_get_element(y_7, i_6))));
        i_6 = i_6 + int(1);
    }
    return result_7;
}

__device__ float dot_1(float2  x_12, float2  y_8)
{
    int i_7 = int(0);
    float result_8 = 0.0f;
    for(;;)
    {
        if(i_7 < int(2))
        {
        }
        else
        {
            break;
        }
        float result_9 = result_8 + _slang_vector_get_element(x_12, i_7) * _slang_vector_get_element(y_8, i_7);
        i_7 = i_7 + int(1);
        result_8 = result_9;
    }
    return result_8;
}

__device__ float clamp_1(float x_13, float minBound_1, float maxBound_1)
{
    return (F32_min(((F32_max((x_13), (minBound_1)))), (maxBound_1)));
}

__device__ float3  lerp_0(float3  x_14, float3  y_9, float3  s_0)
{
    return x_14 + (y_9 - x_14) * s_0;
}

__device__ float saturate_0(float x_15)
{
    return clamp_1(x_15, 0.0f, 1.0f);
}

__device__ float3  saturate_1(float3  x_16)
{
    return clamp_0(x_16, make_float3 (0.0f), make_float3 (1.0f));
}

__device__ float2  sqrt_0(float2  x_17)
{
    float2  result_10;
    int i_8 = int(0);
    for(;;)
    {
        if(i_8 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_10, i_8) = (F32_sqrt((_slang_vector_get_element(x_17, i_8))));
        i_8 = i_8 + int(1);
    }
    return result_10;
}

__device__ float lerp_1(float x_18, float y_10, float s_1)
{
    return x_18 + (y_10 - x_18) * s_1;
}

__device__ float dot_2(float3  x_19, float3  y_11)
{
    int i_9 = int(0);
    float result_11 = 0.0f;
    for(;;)
    {
        if(i_9 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_12 = result_11 + _slang_vector_get_element(x_19, i_9) * _slang_vector_get_element(y_11, i_9);
        i_9 = i_9 + int(1);
        result_11 = result_12;
    }
    return result_11;
}

__device__ void dense_0(FloatWeights_0 * weights_14, uint first_10, bool adds_8, FixedArray<float, 96>  * inputs_14, FixedArray<float, 50>  * outputs_8)
{
    dense_part_0(weights_14, first_10, adds_8, inputs_14, outputs_8);
    return;
}

__device__ void dense_1(HalfWeights_0 * weights_15, uint first_11, bool adds_9, FixedArray<float, 96>  * inputs_15, FixedArray<float, 52>  * outputs_9)
{
    dense_part_1(weights_15, first_11, adds_9, inputs_15, outputs_9);
    return;
}

__device__ void dense_2(HalfWeights_0 * weights_16, uint first_12, bool adds_10, FixedArray<float, 96>  * inputs_16, FixedArray<float, 96>  * outputs_10)
{
    dense_part_5(weights_16, first_12, adds_10, inputs_16, outputs_10);
    return;
}

__device__ void dense_3(HalfWeights_0 * weights_17, uint first_13, bool adds_11, FixedArray<float, 39>  * inputs_17, FixedArray<float, 96>  * outputs_11)
{
    dense_part_2(weights_17, first_13, adds_11, inputs_17, outputs_11);
    return;
}

__device__ void dense_4(HalfWeights_0 * weights_18, uint first_14, bool adds_12, FixedArray<float, 100>  * inputs_18, FixedArray<float, 96>  * outputs_12)
{
    dense_part_3(weights_18, first_14, adds_12, inputs_18, outputs_12);
    return;
}

__device__ void dense_5(HalfWeights_0 * weights_19, uint first_15, bool adds_13, FixedArray<float, 16>  * inputs_19, FixedArray<float, 1>  * outputs_13)
{
    dense_part_4(weights_19, first_15, adds_13, inputs_19, outputs_13);
    return;
}

__device__ void dense_6(HalfWeights_0 * weights_20, uint first_16, bool adds_14, FixedArray<float, 100>  * inputs_20, FixedArray<float, 16>  * outputs_14)
{
    dense_part_6(weights_20, first_16, adds_14, inputs_20, outputs_14);
    return;
}

__device__ void dense_part_8(HalfWeights_0 * weights_21, uint first_17, bool adds_15, FixedArray<float, 96>  * inputs_21, FixedArray<float, 100>  * outputs_15)
{
    uint _S145 = first_17 + uint(whole_parts_0(int(12)));
    int output_8 = int(0);
    for(;;)
    {
        bool _S146 = output_8 < int(96);
        if(_S146)
        {
        }
        else
        {
            break;
        }
        uint _S147 = uint(output_8);
        Eight_0 _S148 = HalfWeights_eight_0(weights_21, first_17 + _S147 / 8U);
        float4  _S149 = tile_product_1(weights_21, _S145 + _S147 * 12U, inputs_21);
        float4  _S150;
        if((output_8 & int(4)) != int(0))
        {
            _S150 = _S148.high_0;
        }
        else
        {
            _S150 = _S148.low_0;
        }
        float4  _S151 = _S149 + _S150;
        float _S152;
        if(_S146)
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[output_8];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[output_8] = LeakyRelu_apply_0(_S151.x + _S152);
        }
        int _S153 = output_8 + int(1);
        if(_S153 < int(96))
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[_S153];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[_S153] = LeakyRelu_apply_0(_S151.y + _S152);
        }
        int _S154 = output_8 + int(2);
        if(_S154 < int(96))
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[_S154];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[_S154] = LeakyRelu_apply_0(_S151.z + _S152);
        }
        int _S155 = output_8 + int(3);
        if(_S155 < int(96))
        {
            if(adds_15)
            {
                _S152 = (*outputs_15)[_S155];
            }
            else
            {
                _S152 = 0.0f;
            }
            (*outputs_15)[_S155] = LeakyRelu_apply_0(_S151.w + _S152);
        }
        output_8 = output_8 + int(4);
    }
    return;
}

__device__ void dense_7(HalfWeights_0 * weights_22, uint first_18, bool adds_16, FixedArray<float, 88>  * inputs_22, FixedArray<float, 96>  * outputs_16)
{
    dense_part_7(weights_22, first_18, adds_16, inputs_22, outputs_16);
    return;
}

__device__ float2  clamp_2(float2  x_20, float2  minBound_2, float2  maxBound_2)
{
    return min_1(max_1(x_20, minBound_2), maxBound_2);
}

__device__ float2  lerp_2(float2  x_21, float2  y_12, float2  s_2)
{
    return x_21 + (y_12 - x_21) * s_2;
}

__device__ float2  floor_0(float2  x_22)
{
    float2  result_13;
    int i_10 = int(0);
    for(;;)
    {
        if(i_10 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_13, i_10) = (F32_floor((_slang_vector_get_element(x_22, i_10))));
        i_10 = i_10 + int(1);
    }
    return result_13;
}

__device__ Query_0 slang_ldg_0(Query_0 * ptr_0)
{
    uint _S156 = __ldg(&ptr_0->fabric_1);
    float _S157 = __ldg(&ptr_0->centre_x_0);
    float _S158 = __ldg(&ptr_0->centre_y_0);
    float _S159 = __ldg(&ptr_0->dx_x_0);
    float _S160 = __ldg(&ptr_0->dx_y_0);
    float _S161 = __ldg(&ptr_0->dy_x_0);
    float _S162 = __ldg(&ptr_0->dy_y_0);
    float _S163 = __ldg(&ptr_0->light_x_0);
    float _S164 = __ldg(&ptr_0->light_y_0);
    float _S165 = __ldg(&ptr_0->light_z_0);
    float _S166 = __ldg(&ptr_0->view_x_0);
    float _S167 = __ldg(&ptr_0->view_y_0);
    float _S168 = __ldg(&ptr_0->view_z_0);
    uint _S169 = __ldg(&ptr_0->seed_1);
    Query_0 _S170 = { _S156, _S157, _S158, _S159, _S160, _S161, _S162, _S163, _S164, _S165, _S166, _S167, _S168, _S169 };
    return _S170;
}

__device__ Neural_0 slang_ldg_1(Neural_0 * ptr_1)
{
    uint _S171 = __ldg(&ptr_1->is_encoded_0);
    uint _S172 = __ldg(&ptr_1->network_0);
    uint _S173 = __ldg(&ptr_1->latents_0);
    uint _S174 = __ldg(&ptr_1->texels_0);
    uint _S175 = __ldg(&ptr_1->levels_1);
    uint _S176 = __ldg(&ptr_1->top_level_0);
    float _S177 = __ldg(&ptr_1->ends_0);
    float _S178 = __ldg(&ptr_1->picks_0);
    float _S179 = __ldg(&ptr_1->ends_per_mm_0);
    float _S180 = __ldg(&ptr_1->picks_per_mm_0);
    float _S181 = __ldg(&ptr_1->pitch_0);
    float _S182 = __ldg(&ptr_1->warp_x_0);
    float _S183 = __ldg(&ptr_1->warp_y_0);
    float _S184 = __ldg(&ptr_1->warp_roughness_0);
    float _S185 = __ldg(&ptr_1->weft_x_0);
    float _S186 = __ldg(&ptr_1->weft_y_0);
    float _S187 = __ldg(&ptr_1->weft_roughness_0);
    float _S188 = __ldg(&ptr_1->warp_lobe_roughness_0);
    float _S189 = __ldg(&ptr_1->weft_lobe_roughness_0);
    uint _S190 = __ldg(&ptr_1->bundles_0);
    uint _S191 = __ldg(&ptr_1->is_corrected_0);
    uint _S192 = __ldg(&ptr_1->correction_0);
    Neural_0 _S193 = { _S171, _S172, _S173, _S174, _S175, _S176, _S177, _S178, _S179, _S180, _S181, _S182, _S183, _S184, _S185, _S186, _S187, _S188, _S189, _S190, _S191, _S192 };
    return _S193;
}

__device__ float square_0(float x_23)
{
    return x_23 * x_23;
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

__device__ float3  row_of_taps_0(Footprint_0 * footprint_0)
{
    float _S194 = footprint_0->dx_0.x;
    float _S195 = footprint_0->dy_0.x;
    float _S196 = _S194 * _S194 + _S195 * _S195;
    float _S197 = footprint_0->dx_0.y;
    float _S198 = footprint_0->dy_0.y;
    float _S199 = _S197 * _S197 + _S198 * _S198;
    float _S200 = _S194 * _S197 + _S195 * _S198;
    float _S201 = 0.5f * (_S196 - _S199);
    float _S202 = 0.5f * (_S196 + _S199);
    float _S203 = (F32_sqrt((_S201 * _S201 + _S200 * _S200)));
    float _S204 = _S202 + _S203;
    float _S205 = (F32_max((_S204 - 1.5f * (F32_max((_S202 - _S203), (0.0f)))), (0.0f)));
    float _S206 = square_0(4.0f);
    float _S207 = (F32_max((_S202 - 0.5f * _S205), (_S204 / _S206)));
    float _S208 = (F32_sqrt(((F32_max(((F32_min((_S205), (_S204 - _S207)))), (0.0f))) / (_S206 - 1.0f))));
    float _S209 = _S201 / (F32_max((_S203), (1.00000000317107685e-30f)));
    float _S210 = (F32_sqrt(((F32_max((0.5f * (1.0f - _S209)), (0.0f))))));
    float _S211 = (F32_sqrt((_S207)));
    float _S212 = _S208 * (F32_sqrt(((F32_max((0.5f * (1.0f + _S209)), (0.0f))))));
    float _S213;
    if(_S200 < 0.0f)
    {
        _S213 = - _S208 * _S210;
    }
    else
    {
        _S213 = _S208 * _S210;
    }
    return make_float3 (_S211, _S212, _S213);
}

struct AnisotropicTaps_0
{
    float2  centre_1;
    float side_0;
    float2  first_19;
    float2  second_0;
};

__device__ float AnisotropicTaps_size_0(AnisotropicTaps_0 * this_2)
{
    float _S214 = this_2->first_19.x;
    float _S215 = this_2->second_0.x;
    float _S216 = this_2->side_0 * this_2->side_0;
    float _S217 = this_2->first_19.y;
    float _S218 = this_2->second_0.y;
    float _S219 = 12.0f * (_S214 * _S217 + _S215 * _S218);
    return (F32_sqrt(((F32_sqrt(((F32_max(((12.0f * (_S214 * _S214 + _S215 * _S215) + _S216) * (12.0f * (_S217 * _S217 + _S218 * _S218) + _S216) - _S219 * _S219), (square_0(_S216))))))))));
}

__device__ float natural_logarithm_0(float x_24)
{
    uint _S220 = (F32_asuint((x_24)));
    float exponent_0 = float(int(_S220 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S220 & 8388607U) | 1056964608U)));
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
    float _S221 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S221 - exponent_1 * 0.00021219444170129f - 0.5f * _S221) + exponent_1 * 0.693359375f;
}

__device__ float3  footprint_coordinates_0(AnisotropicTaps_0 * taps_0)
{
    float _S222 = AnisotropicTaps_size_0(taps_0);
    return make_float3 ((taps_0->centre_1 - floor_0(taps_0->centre_1)).x, (taps_0->centre_1 - floor_0(taps_0->centre_1)).y, clamp_1(natural_logarithm_0((F32_max((_S222), (9.99999997475242708e-07f))) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S223 = float2 {direction_0.x, direction_0.y};
    float _S224;
    if(back_2)
    {
        _S224 = - direction_0.z;
    }
    else
    {
        _S224 = direction_0.z;
    }
    return make_float3 (_S223.x, _S223.y, _S224);
}

__device__ float table_number_0(uint index_0)
{
    uint _S225 = __ldg((&(globalParams_0->words_0)[index_0]));
    return (U32_asfloat((_S225)));
}

__device__ float wrapped_0(float index_1, float count_1)
{
    float _S226;
    if(index_1 < 0.0f)
    {
        _S226 = index_1 + count_1;
    }
    else
    {
        if(index_1 >= count_1)
        {
            _S226 = index_1 - count_1;
        }
        else
        {
            _S226 = index_1;
        }
    }
    return _S226;
}

__device__ float binary_logarithm_0(float x_25)
{
    return natural_logarithm_0(x_25) * 1.4426950216293335f;
}

__device__ bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 * this_3)
{
    return (F32_max((dot_1(this_3->first_19, this_3->first_19)), (dot_1(this_3->second_0, this_3->second_0)))) > 0.0f;
}

__device__ float2  AnisotropicTaps_place_0(AnisotropicTaps_0 * this_4, uint number_0)
{
    float _S227;
    if(number_0 >= 2U)
    {
        _S227 = 1.0f;
    }
    else
    {
        _S227 = -1.0f;
    }
    float _S228;
    if((number_0 & 1U) != 0U)
    {
        _S228 = 1.0f;
    }
    else
    {
        _S228 = -1.0f;
    }
    return this_4->centre_1 + make_float2 (_S227) * this_4->first_19 + make_float2 (_S228) * this_4->second_0;
}

__device__ float bump_0(float distance_0)
{
    float _S229 = (F32_max((1.0f - distance_0 * distance_0), (0.0f)));
    return _S229 * _S229;
}

__device__ float correction_weight_of_0(float coded_size_0)
{
    return clamp_1((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

__device__ float exponential_0(float x_26)
{
    float _S230 = clamp_1(x_26, -87.0f, 88.0f);
    float _S231 = (F32_floor((_S230 * 1.4426950216293335f + 0.5f)));
    float _S232 = _S230 - _S231 * 0.693359375f + _S231 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S232 + 0.00139819993637502f) * _S232 + 0.00833345204591751f) * _S232 + 0.04166579619050026f) * _S232 + 0.1666666567325592f) * _S232 + 0.5f;
    float _S233 = (U32_asfloat((uint(int(_S231) + int(127)) << int(23))));
    float _S234;
    if(x_26 < -87.0f)
    {
        _S234 = 0.0f;
    }
    else
    {
        _S234 = (p_0 * _S232 * _S232 + _S232 + 1.0f) * _S233;
    }
    return _S234;
}

__device__ float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp_1(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

__device__ float square_1(float3  v_1)
{
    return dot_2(v_1, v_1);
}

__device__ uint mirrored_bundle_0(uint bundle_0)
{
    uint _S235 = bundle_0 / 3U;
    uint _S236 = bundle_0 % 3U;
    uint _S237;
    if(bundle_0 == 24U)
    {
        _S237 = bundle_0;
    }
    else
    {
        _S237 = _S235 * 3U + 3U - 1U - _S236;
    }
    return _S237;
}

__device__ float light_visibility_of_0(float diffuse_0, float3  light_1, float3  view_1, float blend_0)
{
    float _S238 = (F32_max(((F32_abs((light_1.z)))), (0.00100000004749745f)));
    float2  _S239 = float2 {light_1.x, light_1.y};
    return 3.14159274101257324f * (F32_max((diffuse_0), (0.0f))) / lerp_1(_S238, (0.59700000286102295f * _S238 + 0.16599999368190765f) * (0.21600000560283661f * (dot_1(_S239, float2 {view_1.x, view_1.y}) * (F32_rsqrt(((F32_max((dot_1(_S239, _S239)), (9.99999997475242708e-07f))))))) + 1.0f), blend_0);
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_2)
{
    float _S240 = __ldg(&(&(globalParams_0->families_0)[family_0])->inverse_count_0);
    float _S241 = __ldg(&(&(globalParams_0->families_0)[family_0])->half_inverse_count_0);
    float _S242 = (F32_floor(((F32_fma((index_2), (_S240), (_S241))))));
    float _S243 = - _S242;
    float _S244 = __ldg(&(&(globalParams_0->families_0)[family_0])->count_0);
    return make_float2 (_S242, (F32_fma((_S243), (_S244), (index_2))));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_0)
{
    float _S245 = __ldg(&(&(globalParams_0->families_0)[family_1])->inverse_size_0);
    float _S246 = (F32_floor((position_0 * _S245)));
    Cell_0 cell_0;
    float _S247 = - _S246;
    float _S248 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    float _S249 = (F32_fma((_S247), (_S248), (position_0)));
    (&cell_0)->below_0 = _S249;
    float _S250 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->above_0 = _S250 - _S249;
    float _S251 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->across_0 = _S249 - 0.5f * _S251;
    float _S252 = __ldg(&(&(globalParams_0->families_0)[family_1])->half_width_0);
    (&cell_0)->half_width_1 = _S252;
    float _S253 = turns_and_remainder_0(family_1, _S246).y;
    float _S254 = __ldg(&(&(globalParams_0->families_0)[family_1])->count_0);
    (&cell_0)->thread_0 = uint(clamp_1(_S253, 0.0f, _S254 - 1.0f));
    return cell_0;
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float _S255 = __ldg(&(&(globalParams_0->families_0)[family_2])->start_0);
    float _S256 = position_1 - _S255;
    float _S257 = __ldg(&(&(globalParams_0->families_0)[family_2])->inverse_period_0);
    float turns_0 = _S256 * _S257;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    float _S258 = __ldg(&(&(globalParams_0->families_0)[family_2])->period_0);
    float _S259 = turns_1 * _S258;
    float _S260 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    float _S261 = turns_1 * _S260;
    float _S262 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    uint _S263 = uint(clamp_1(_S261, 0.0f, _S262 - 1.0f));
    uint _S264 = __ldg(&(&(globalParams_0->families_0)[family_2])->first_thread_table_0);
    uint _S265 = __ldg((&(globalParams_0->words_0)[_S264 + _S263]));
    uint _S266 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S267;
    if(_S259 >= (table_number_0(_S266 + _S265 * 4U + 1U)))
    {
        _S267 = 1U;
    }
    else
    {
        _S267 = 0U;
    }
    uint _S268 = _S265 + _S267;
    float _S269 = __ldg(&(&(globalParams_0->families_0)[family_2])->count_0);
    uint _S270 = (U32_min((_S268), (uint(_S269) - 1U)));
    uint _S271 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S272 = _S271 + _S270 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S270;
    (&cell_1)->below_0 = _S259 - table_number_0(_S272);
    (&cell_1)->above_0 = table_number_0(_S272 + 1U) - _S259;
    (&cell_1)->across_0 = _S259 - table_number_0(_S272 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S272 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    uint _S273 = __ldg(&(&(globalParams_0->families_0)[family_3])->is_alike_0);
    if(_S273 != 0U)
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Bound_0
{
    uint thread_1;
    float turns_2;
    float cell_2;
    float visible_0;
    float width_2;
    float gap_0;
};

__device__ Bound_0 bound_at_0(uint family_4, float position_3)
{
    Cell_0 _S274 = locate_0(family_4, position_3);
    uint _S275 = __ldg(&(&(globalParams_0->families_0)[family_4])->before_0);
    float _S276 = table_number_0(_S275 + 2U * _S274.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_1 = _S274.thread_0;
    float _S277 = __ldg(&(&(globalParams_0->families_0)[family_4])->start_0);
    float _S278 = position_3 - _S277 - _S276 - _S274.below_0;
    float _S279 = __ldg(&(&(globalParams_0->families_0)[family_4])->inverse_period_0);
    (&bound_0)->turns_2 = (F32_round((_S278 * _S279)));
    (&bound_0)->cell_2 = _S274.below_0;
    float _S280 = 2.0f * _S274.half_width_1;
    (&bound_0)->width_2 = _S280;
    (&bound_0)->visible_0 = clamp_1((_S274.across_0 + _S274.half_width_1) / _S280, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S274.below_0), (_S274.below_0 - _S274.across_0 - _S274.half_width_1))) + (F32_max((_S274.across_0 - _S274.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

__device__ Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S281 = __ldg(&(&(globalParams_0->families_0)[family_5])->start_0);
    float _S282 = centre_2 - _S281;
    float _S283 = __ldg(&(&(globalParams_0->families_0)[family_5])->inverse_period_0);
    float _S284 = (F32_floor((_S282 * _S283)));
    float _S285 = __ldg(&(&(globalParams_0->families_0)[family_5])->period_0);
    float _S286 = centre_2 - _S284 * _S285;
    float _S287 = __ldg(&(&(globalParams_0->families_0)[family_5])->smallest_box_0);
    float _S288 = 0.5f * (F32_max((size_1), (_S287)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_7 = bound_at_0(family_5, _S286 - _S288);
    (&stretch_0)->high_7 = bound_at_0(family_5, _S286 + _S288);
    return stretch_0;
}

__device__ float3  table_colour_0(uint index_3)
{
    return make_float3 (table_number_0(index_3), table_number_0(index_3 + 1U), table_number_0(index_3 + 2U));
}

struct Albedos_0
{
    float3  diffuse_reflect_0;
    float3  diffuse_transmit_0;
    float3  specular_reflect_0;
    float3  specular_transmit_0;
};

__device__ Albedos_0 table_albedos_0(uint row_6)
{
    Albedos_0 albedos_0;
    (&albedos_0)->diffuse_reflect_0 = table_colour_0(row_6);
    (&albedos_0)->diffuse_transmit_0 = table_colour_0(row_6 + 3U);
    (&albedos_0)->specular_reflect_0 = table_colour_0(row_6 + 6U);
    (&albedos_0)->specular_transmit_0 = table_colour_0(row_6 + 9U);
    return albedos_0;
}

__device__ float Stretch_turns_0(Stretch_0 * this_5)
{
    return (&this_5->high_7)->turns_2 - (&this_5->low_7)->turns_2;
}

__device__ float3  lengths_0(uint family_6, Stretch_0 * stretch_1)
{
    float _S289 = Stretch_turns_0(stretch_1);
    uint _S290 = __ldg(&(&(globalParams_0->families_0)[family_6])->before_0);
    uint _S291 = _S290 + 2U * (&stretch_1->low_7)->thread_1;
    uint _S292 = __ldg(&(&(globalParams_0->families_0)[family_6])->before_0);
    uint _S293 = _S292 + 2U * (&stretch_1->high_7)->thread_1;
    float _S294 = table_number_0(_S293) - table_number_0(_S291);
    float _S295 = table_number_0(_S293 + 1U) - table_number_0(_S291 + 1U);
    float _S296 = _S294 + (&stretch_1->high_7)->visible_0 * (&stretch_1->high_7)->width_2 - (&stretch_1->low_7)->visible_0 * (&stretch_1->low_7)->width_2;
    float _S297 = __ldg(&(&(globalParams_0->families_0)[family_6])->visible_total_0);
    float _S298 = _S296 + _S289 * _S297;
    float _S299 = _S295 - _S294 + (&stretch_1->high_7)->gap_0 - (&stretch_1->low_7)->gap_0;
    float _S300 = __ldg(&(&(globalParams_0->families_0)[family_6])->period_0);
    float _S301 = __ldg(&(&(globalParams_0->families_0)[family_6])->visible_total_0);
    float _S302 = _S299 + _S289 * (_S300 - _S301);
    float _S303 = _S295 + (&stretch_1->high_7)->cell_2 - (&stretch_1->low_7)->cell_2;
    float _S304 = __ldg(&(&(globalParams_0->families_0)[family_6])->period_0);
    return make_float3 (_S298, _S302, _S303 + _S289 * _S304);
}

__device__ float2  integrals_along_0(uint family_7, Stretch_0 * stretch_2, uint quantity_0)
{
    uint _S305 = __ldg(&(&(globalParams_0->families_0)[family_7])->quantities_0);
    uint _S306 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    uint _S307 = 3U * _S305;
    uint _S308 = _S306 + _S307 * (&stretch_2->low_7)->thread_1 + quantity_0;
    uint _S309 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    uint _S310 = _S309 + _S307 * (&stretch_2->high_7)->thread_1 + quantity_0;
    uint _S311 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    float _S312 = __ldg(&(&(globalParams_0->families_0)[family_7])->count_0);
    uint _S313 = _S311 + _S307 * uint(_S312) + quantity_0;
    float _S314 = table_number_0(_S308);
    float _S315 = table_number_0(_S310);
    float _S316 = Stretch_turns_0(stretch_2);
    uint _S317 = 2U * _S305;
    return make_float2 (table_number_0(_S310 + _S305) - table_number_0(_S308 + _S305) + _S315 * (&stretch_2->high_7)->visible_0 * (&stretch_2->high_7)->width_2 - _S314 * (&stretch_2->low_7)->visible_0 * (&stretch_2->low_7)->width_2 + _S316 * table_number_0(_S313 + _S305), table_number_0(_S310 + _S317) - table_number_0(_S308 + _S317) + _S315 * (&stretch_2->high_7)->cell_2 - _S314 * (&stretch_2->low_7)->cell_2 + _S316 * table_number_0(_S313 + _S317));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_6)
{
    return ((&this_6->high_7)->thread_1) < ((&this_6->low_7)->thread_1);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_7, uint4  entries_0, uint whole_0)
{
    uint _S318 = entries_0.z;
    uint _S319 = entries_0.x;
    uint _S320 = _S318 - _S319;
    bool _S321 = Stretch_wraps_0(this_7);
    uint _S322;
    if(_S321)
    {
        _S322 = whole_0;
    }
    else
    {
        _S322 = 0U;
    }
    return make_uint4 (_S320 + _S322, entries_0.w - _S318, entries_0.y - _S319, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S323 = row_7 + (&across_1->low_7)->thread_1 * quantities_1;
    uint _S324 = row_7 + (&across_1->high_7)->thread_1 * quantities_1;
    uint _S325 = __ldg((&(globalParams_0->words_0)[_S323]));
    uint _S326 = __ldg((&(globalParams_0->words_0)[_S323 + quantities_1]));
    uint _S327 = __ldg((&(globalParams_0->words_0)[_S324]));
    uint _S328 = __ldg((&(globalParams_0->words_0)[_S324 + quantities_1]));
    uint4  _S329 = make_uint4 (_S325, _S326, _S327, _S328);
    uint _S330 = __ldg((&(globalParams_0->words_0)[row_7 + count_2 * quantities_1]));
    uint4  _S331 = Stretch_differences_0(across_1, _S329, _S330);
    return _S331;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_8)
{
    float _S332 = (&this_8->high_7)->visible_0;
    float _S333 = - (&this_8->low_7)->visible_0;
    float _S334 = Stretch_turns_0(this_8);
    bool _S335 = Stretch_wraps_0(this_8);
    float _S336;
    if(_S335)
    {
        _S336 = 1.0f;
    }
    else
    {
        _S336 = 0.0f;
    }
    return make_float4 (1.0f, _S332, _S333, _S334 - _S336);
}

__device__ float integral_on_top_0(uint family_8, Stretch_0 * across_2, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    float _S337 = __ldg(&(&(globalParams_0->families_0)[family_8])->count_0);
    uint _S338 = uint(_S337);
    uint _S339 = _S338 + 1U;
    uint _S340 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint _S341 = _S339 * _S340;
    uint _S342 = __ldg(&(&(globalParams_0->families_0)[family_8])->colour_areas_0);
    uint _S343 = _S342 + quantity_1;
    uint _S344 = (&along_0->low_7)->thread_1;
    uint _S345 = _S343 + (&along_0->low_7)->thread_1 * _S341;
    uint _S346 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S347 = row_differences_0(across_2, _S345, _S338, _S346);
    uint _S348 = _S343 + (_S344 + 1U) * _S341;
    uint _S349 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S350 = row_differences_0(across_2, _S348, _S338, _S349);
    uint _S351 = (&along_0->high_7)->thread_1;
    uint _S352 = _S343 + (&along_0->high_7)->thread_1 * _S341;
    uint _S353 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S354 = row_differences_0(across_2, _S352, _S338, _S353);
    uint _S355 = _S343 + (_S351 + 1U) * _S341;
    uint _S356 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S357 = row_differences_0(across_2, _S355, _S338, _S356);
    uint _S358 = _S343 + crossing_count_0 * _S341;
    uint _S359 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S360 = row_differences_0(across_2, _S358, _S338, _S359);
    uint4  _S361 = _S354 - _S347;
    bool _S362 = Stretch_wraps_0(along_0);
    uint4  _S363;
    if(_S362)
    {
        _S363 = _S360;
    }
    else
    {
        int4  _S364 = make_int4 (int(0));
        uint4  _S365 = make_uint4 ((uint)_S364.x, (uint)_S364.y, (uint)_S364.z, (uint)_S364.w);
        _S363 = _S365;
    }
    uint4  _S366 = _S361 + _S363;
    float4  _S367 = Stretch_weights_0(across_2);
    float4  _S368 = Stretch_weights_0(along_0);
    int4  _S369 = make_int4 ((int)_S366.x, (int)_S366.y, (int)_S366.z, (int)_S366.w);
    float4  _S370 = make_float4 ((float)_S369.x, (float)_S369.y, (float)_S369.z, (float)_S369.w);
    uint4  _S371 = _S357 - _S354;
    int4  _S372 = make_int4 ((int)_S371.x, (int)_S371.y, (int)_S371.z, (int)_S371.w);
    float4  _S373 = make_float4 ((float)_S372.x, (float)_S372.y, (float)_S372.z, (float)_S372.w);
    uint4  _S374 = _S350 - _S347;
    int4  _S375 = make_int4 ((int)_S374.x, (int)_S374.y, (int)_S374.z, (int)_S374.w);
    float4  _S376 = make_float4 ((float)_S375.x, (float)_S375.y, (float)_S375.z, (float)_S375.w);
    int4  _S377 = make_int4 ((int)_S360.x, (int)_S360.y, (int)_S360.z, (int)_S360.w);
    float4  _S378 = make_float4 ((float)_S377.x, (float)_S377.y, (float)_S377.z, (float)_S377.w);
    float _S379 = dot_0(make_float4 (dot_0(_S370, _S367), dot_0(_S373, _S367), dot_0(_S376, _S367), dot_0(_S378, _S367)), _S368);
    float _S380 = __ldg(&(&(globalParams_0->families_0)[family_8])->area_unit_0);
    return _S379 * _S380;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S381 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_0) * _S381.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_0) * _S381.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_0) * _S381.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_0) * _S381.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 * own_0, Stretch_0 * other_0, bool back_3)
{
    uint _S382 = __ldg(&(&(globalParams_0->families_0)[family_9])->colour_mean_0);
    Albedos_0 albedos_2 = table_albedos_0(_S382);
    uint _S383 = __ldg(&(&(globalParams_0->families_0)[family_9])->quantities_0);
    if(_S383 == 1U)
    {
        return albedos_2;
    }
    float3  _S384 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        uint _S385 = __ldg(&(&(globalParams_0->families_0)[family_9])->quantities_0);
        if(quantity_2 < _S385)
        {
        }
        else
        {
            break;
        }
        float2  _S386 = integrals_along_0(family_9, own_0, quantity_2);
        float _S387 = __ldg(&(&(globalParams_0->families_0)[crossing_0])->count_0);
        float _S388 = integral_on_top_0(family_9, own_0, other_0, uint(_S387), quantity_2);
        float _S389 = _S386.x;
        float _S390 = _S389 * _S384.x;
        float _S391;
        if(back_3)
        {
            _S391 = _S390 - _S388;
        }
        else
        {
            _S391 = _S388;
        }
        bool _S392 = quantity_2 == 0U;
        if(_S392)
        {
            float _S393 = __ldg(&(&(globalParams_0->families_0)[family_9])->area_unit_0);
            float _S394 = 16.0f * _S393;
            float _S395 = __ldg(&(&(globalParams_0->families_0)[family_9])->crossing_area_0);
            is_exposed_0 = _S391 > (_S394 * (F32_min((_S390 / _S395), (1.0f))) + 0.00000999999974738f * _S390);
        }
        float _S396 = _S389 * _S384.y;
        float _S397;
        if(is_exposed_0)
        {
            _S397 = _S391;
        }
        else
        {
            _S397 = 0.0f;
        }
        float _S398 = _S396 + _S397 + 0.000244140625f * _S384.z * _S386.y;
        if(_S392)
        {
            weight_1 = 1.0f / (F32_max((_S398), (9.99999968265522539e-21f)));
        }
        else
        {
            Albedos_0 _S399 = albedos_2;
            float _S400 = _S398 * weight_1;
            uint _S401 = __ldg(&(&(globalParams_0->families_0)[family_9])->colour_axes_0);
            uint _S402 = _S401 + 12U * (quantity_2 - 1U);
            Albedos_0 _S403 = _S399;
            Albedos_0 _S404 = with_added_albedos_0(&_S403, _S400, _S402);
            albedos_2 = _S404;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate_1((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate_1((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate_1((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate_1((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

__device__ Blocked_0 no_blocked_0()
{
    Blocked_0 nothing_0;
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

__device__ CloseUp_0 no_close_up_0()
{
    CloseUp_0 nothing_1;
    (&nothing_1)->weight_2 = 0.0f;
    Blocked_0 _S405 = no_blocked_0();
    (&nothing_1)->warp_1 = _S405;
    (&nothing_1)->weft_1 = _S405;
    return nothing_1;
}

__device__ Albedos_0 tinted_0(Albedos_0 * albedos_3, float3  tint_0)
{
    Albedos_0 result_14 = *albedos_3;
    (&result_14)->diffuse_reflect_0 = (&result_14)->diffuse_reflect_0 * tint_0;
    (&result_14)->diffuse_transmit_0 = (&result_14)->diffuse_transmit_0 * tint_0;
    return result_14;
}

struct FaceRadiance_0
{
    float3  warp_2;
    float3  weft_2;
    float3  mean_0;
    float3  leaked_0;
};

struct FaceSends_0
{
    float3  sky_warp_0;
    float3  sky_weft_0;
    float3  crossing_warp_0;
    float3  crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

__device__ FaceRadiance_0 face_radiance_0(FaceSends_0 * sends_0, float open_of_other_0, float3  passed_0, float3  from_other_0)
{
    float3  _S406 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S407 = sends_0->sky_warp_0 + _S406 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S407;
    float3  _S408 = sends_0->sky_weft_0 + _S406 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S408;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S407 + make_float3 (sends_0->blocks_weft_0) * _S408;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

__device__ void view_terms_0(float3  view_2, FixedArray<float, 6>  * terms_0)
{
    float _S409 = 1.0f - view_2.z;
    float _S410 = _S409 * _S409;
    (*terms_0)[int(0)] = 1.0f;
    float _S411 = view_2.x;
    float _S412 = _S411 * _S411;
    float _S413 = view_2.y;
    float _S414 = _S413 * _S413;
    (*terms_0)[int(1)] = (F32_sqrt(((F32_max((_S412 + _S414), (9.999999960041972e-13f))))));
    (*terms_0)[int(2)] = _S410;
    (*terms_0)[int(3)] = _S410 * _S410;
    (*terms_0)[int(4)] = _S412 - _S414;
    (*terms_0)[int(5)] = 0.0f;
    return;
}

__device__ Blocked_0 scaled_0(Blocked_0 * blocked_0, float share_1)
{
    Blocked_0 result_15;
    (&result_15)->by_warp_0 = share_1 * blocked_0->by_warp_0;
    (&result_15)->by_weft_0 = share_1 * blocked_0->by_weft_0;
    (&result_15)->far_0 = share_1 * blocked_0->far_0;
    return result_15;
}

struct Bounced_0
{
    float3  reflected_0;
    float3  transmitted_0;
};

struct Scattered_0
{
    float3  back_4;
    float3  through_0;
};

struct Interior_0
{
    float3  warp_3;
    float3  weft_3;
    float3  leaked_1;
    float3  far_1;
    float3  far_leaked_0;
};

__device__ Bounced_0 bounced_by_0(Blocked_0 * blocked_1, Scattered_0 * yarn_0, Interior_0 * interior_0)
{
    float3  _S415 = make_float3 (blocked_1->by_warp_0 + blocked_1->by_weft_0) * interior_0->leaked_1;
    float3  _S416 = make_float3 (blocked_1->far_0) * yarn_0->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_0->back_4 * (make_float3 (blocked_1->by_warp_0) * interior_0->warp_3 + make_float3 (blocked_1->by_weft_0) * interior_0->weft_3) + _S416 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S416 * interior_0->far_1 + yarn_0->back_4 * _S415;
    return bounced_0;
}

__device__ Bounced_0 sum_of_0(Bounced_0 * first_20, Bounced_0 * second_1)
{
    Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_20->reflected_0 + second_1->reflected_0;
    (&sum_1)->transmitted_0 = first_20->transmitted_0 + second_1->transmitted_0;
    return sum_1;
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_2, float3  view_3)
{
    float _S417 = light_2.z;
    float3  _S418;
    if((_S417 * view_3.z) < 0.0f)
    {
        _S418 = bounced_1->transmitted_0;
    }
    else
    {
        _S418 = bounced_1->reflected_0;
    }
    return _S418 * make_float3 ((F32_abs((_S417))) * 0.31830987334251404f);
}

__device__ float sheen_scale_0(float x_27, float y_13)
{
    return (((((0.0f * x_27 + (((((-1.1402510404586792f * y_13 + 0.40672621130943298f) * y_13 + 1.65398800373077393f) * y_13 + -1.29730904102325439f) * y_13 + 0.30570998787879944f) * y_13 + -0.0220868494361639f)) * x_27 + (((((-0.21142719686031342f * y_13 + 1.05947399139404297f) * y_13 + -0.41116121411323547f) * y_13 + -0.93859231472015381f) * y_13 + 0.51606941223144531f) * y_13 + 0.05409301072359085f)) * x_27 + (((((1.22944498062133789f * y_13 + -0.45962560176849365f) * y_13 + -1.63861405849456787f) * y_13 + 1.33565104007720947f) * y_13 + -0.45725581049919128f) * y_13 + 0.08243165910243988f)) * x_27 + (((((0.39779931306838989f * y_13 + -1.18879103660583496f) * y_13 + 0.28251591324806213f) * y_13 + 1.168984055519104f) * y_13 + -0.76864629983901978f) * y_13 + 0.0091691892594099f)) * x_27 + (((((-0.26563560962677002f * y_13 + -0.19379159808158875f) * y_13 + 0.2677634060382843f) * y_13 + 0.00270519289188087f) * y_13 + 0.14349560439586639f) * y_13 + 0.10290180146694183f)) * x_27 + (((((-0.20701569318771362f * y_13 + 0.24526430666446686f) * y_13 + 0.19551840424537659f) * y_13 + 0.07586126774549484f) * y_13 + 0.38894739747047424f) * y_13 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_28, float y_14)
{
    return ((((0.0f * x_28 + (((((-0.10608240216970444f * y_14 + 1.99214303493499756f) * y_14 + -1.42255294322967529f) * y_14 + -1.09495604038238525f) * y_14 + 0.59180057048797607f) * y_14 + 0.06902855634689331f)) * x_28 + (((((-0.46220690011978149f * y_14 + -0.29113379120826721f) * y_14 + 1.39025199413299561f) * y_14 + 0.35589990019798279f) * y_14 + -1.17120099067687988f) * y_14 + 0.15940259397029877f)) * x_28 + (((((2.26068711280822754f * y_14 + -3.64728999137878418f) * y_14 + -0.72173482179641724f) * y_14 + 3.07659196853637695f) * y_14 + -0.6827620267868042f) * y_14 + -0.3039557933807373f)) * x_28 + (((((0.81201767921447754f * y_14 + 0.36014080047607422f) * y_14 + -1.72646903991699219f) * y_14 + -0.22630110383033752f) * y_14 + 0.89514690637588501f) * y_14 + -0.10397960245609283f)) * x_28 + (((((-0.37648698687553406f * y_14 + 1.10974001884460449f) * y_14 + 0.17824520170688629f) * y_14 + -1.04968702793121338f) * y_14 + 0.1461234986782074f) * y_14 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_29, float y_15)
{
    return ((((0.0f * x_29 + (((((12.95646953582763672f * y_15 + -21.38032913208007812f) * y_15 + -7.37853097915649414f) * y_15 + 34.55607986450195312f) * y_15 + -23.61347007751464844f) * y_15 + 5.00126314163208008f)) * x_29 + (((((10.91487026214599609f * y_15 + -6.08202791213989258f) * y_15 + -38.2036285400390625f) * y_15 + 53.3440399169921875f) * y_15 + -21.91996002197265625f) * y_15 + 2.01606011390686035f)) * x_29 + (((((-14.52206039428710938f * y_15 + 36.803619384765625f) * y_15 + -22.94047927856445312f) * y_15 + -10.07973003387451172f) * y_15 + 15.77003955841064453f) * y_15 + -4.92722177505493164f)) * x_29 + (((((-7.62505722045898438f * y_15 + 1.27310299873352051f) * y_15 + 31.19523048400878906f) * y_15 + -44.39989852905273438f) * y_15 + 26.44947052001953125f) * y_15 + -8.73507976531982422f)) * x_29 + (((((5.65633487701416016f * y_15 + -17.66820907592773438f) * y_15 + 24.65356063842773438f) * y_15 + -19.38941001892089844f) * y_15 + 11.06159019470214844f) * y_15 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S419 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S420 = 2.0f * (F32_sqrt((_S419))) - 1.0f;
    float _S421 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_1, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S420, _S421), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S419) * sheen_shear_0(_S420, _S421), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S420, _S421), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_3, float3  view_4, float scale_1, float shear_0)
{
    float _S422 = light_3.z;
    bool _S423;
    if(_S422 <= 0.0f)
    {
        _S423 = true;
    }
    else
    {
        _S423 = (view_4.z) <= 0.0f;
    }
    if(_S423)
    {
        return 0.0f;
    }
    float2  _S424 = float2 {view_4.x, view_4.y};
    float _S425 = dot_1(_S424, _S424);
    float2  _S426;
    if(_S425 > 9.99999968265522539e-21f)
    {
        _S426 = _S424 * make_float2 ((F32_rsqrt((_S425))));
    }
    else
    {
        _S426 = make_float2 (1.0f, 0.0f);
    }
    float _S427 = scale_1 * dot_1(float2 {light_3.x, light_3.y}, _S426) + shear_0 * _S422;
    float _S428 = scale_1 * (light_3.y * _S426.x - light_3.x * _S426.y);
    float _S429 = _S427 * _S427 + _S428 * _S428 + _S422 * _S422;
    return 0.31830987334251404f * scale_1 * scale_1 * _S422 / (F32_max((_S429 * _S429), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_4, float3  view_5, float strength_0, float roughness_2)
{
    float3  _S430 = sheen_lobe_0(view_5.z, roughness_2);
    float _S431 = strength_0 * _S430.z;
    return make_float2 (_S431 * transformed_cosine_0(light_4, view_5, _S430.x, _S430.y), 1.0f - _S431);
}

struct NeuralView_0
{
    FixedArray<float, 96>  sums_7;
    float hole_0;
    float correction_weight_0;
    float3  view_6;
    bool back_5;
};

__device__ AnisotropicTaps_0 anisotropic_taps_0(uint _S432, Footprint_0 * _S433)
{
    Fabric_0 * _S434 = (&(globalParams_0->fabrics_0)[_S432]);
    float3  _S435 = row_of_taps_0(_S433);
    float2  _S436 = _S433->dx_0;
    float2  _S437 = _S433->dy_0;
    float _S438 = dot_1(_S433->dx_0, _S433->dx_0) + dot_1(_S433->dy_0, _S433->dy_0);
    float _S439 = _S433->dx_0.x * _S433->dy_0.y - _S433->dx_0.y * _S433->dy_0.x;
    float _S440 = 0.5f * (_S438 + (F32_sqrt(((F32_max((_S438 * _S438 - 4.0f * _S439 * _S439), (0.0f)))))));
    Neural_0 _S441 = slang_ldg_1(&_S434->neural_0);
    bool _S442;
    if(_S440 < (5.5f * (_S438 - _S440)))
    {
        _S442 = _S438 > (8.0f * _S441.pitch_0 * _S441.pitch_0);
    }
    else
    {
        _S442 = false;
    }
    float2  _S443 = make_float2 (_S441.ends_per_mm_0, _S441.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    (&taps_1)->centre_1 = _S433->centre_0 * _S443;
    float _S444;
    if(_S442)
    {
        _S444 = (F32_sqrt((0.125f * _S438)));
    }
    else
    {
        _S444 = _S435.x;
    }
    (&taps_1)->side_0 = _S444 / _S441.pitch_0;
    float2  _S445;
    if(_S442)
    {
        _S445 = make_float2 (0.25f) * _S436;
    }
    else
    {
        _S445 = float2 {_S435.y, _S435.z};
    }
    (&taps_1)->first_19 = _S445 * _S443;
    if(_S442)
    {
        _S445 = make_float2 (0.25f) * _S437;
    }
    else
    {
        _S445 = make_float2 (0.5f) * float2 {_S435.y, _S435.z};
    }
    (&taps_1)->second_0 = _S445 * _S443;
    return taps_1;
}

__device__ void add_texel_0(uint _S446, uint _S447, float _S448, FixedArray<float, 88>  * _S449)
{
    Neural_0 _S450 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S446])->neural_0);
    uint _S451 = _S450.latents_0 + _S447 * 8U;
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
        uint4  _S452 = __ldg((&(globalParams_0->packed_numbers_0)[_S451 + part_0]));
        Eight_0 _S453 = eight_halves_0(_S452);
        int _S454 = int(8U * part_0);
        (*_S449)[_S454] = (*_S449)[_S454] + _S448 * _S453.low_0.x;
        (*_S449)[_S454 + int(4)] = (*_S449)[_S454 + int(4)] + _S448 * _S453.high_0.x;
        int _S455 = _S454 + int(1);
        (*_S449)[_S455] = (*_S449)[_S455] + _S448 * _S453.low_0.y;
        (*_S449)[_S455 + int(4)] = (*_S449)[_S455 + int(4)] + _S448 * _S453.high_0.y;
        int _S456 = _S454 + int(2);
        (*_S449)[_S456] = (*_S449)[_S456] + _S448 * _S453.low_0.z;
        (*_S449)[_S456 + int(4)] = (*_S449)[_S456 + int(4)] + _S448 * _S453.high_0.z;
        int _S457 = _S454 + int(3);
        (*_S449)[_S457] = (*_S449)[_S457] + _S448 * _S453.low_0.w;
        (*_S449)[_S457 + int(4)] = (*_S449)[_S457 + int(4)] + _S448 * _S453.high_0.w;
        part_0 = part_0 + 1U;
    }
    return;
}

__device__ void add_level_0(uint _S458, uint _S459, bool _S460, float2  _S461, float _S462, FixedArray<float, 88>  * _S463)
{
    Neural_0 _S464 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S458])->neural_0);
    uint _S465 = _S464.levels_1 + 4U * _S459;
    float _S466 = table_number_0(_S465);
    float _S467 = table_number_0(_S465 + 1U);
    float _S468 = table_number_0(_S465 + 2U);
    bool _S469;
    if(_S459 > 3U)
    {
        _S469 = _S459 < (_S464.top_level_0);
    }
    else
    {
        _S469 = false;
    }
    float2  _S470 = _S461 * make_float2 (table_number_0(_S465 + 3U));
    float _S471;
    if(_S469)
    {
        _S471 = 1.0f;
    }
    else
    {
        _S471 = 0.5f;
    }
    float2  _S472 = _S470 - make_float2 (_S471);
    float2  _S473 = floor_0(_S472);
    float2  _S474 = _S472 - _S473;
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
        float _S475 = float(corner_0 & 1U);
        float _S476 = float(corner_0 >> int(1));
        float2  _S477 = lerp_2(make_float2 (1.0f) - _S474, _S474, make_float2 (_S475, _S476));
        uint _S478 = uint(_S466 + wrapped_0(_S473.y + _S476, _S468) * _S467 + wrapped_0(_S473.x + _S475, _S467));
        uint _S479;
        if(_S460)
        {
            _S479 = _S464.texels_0;
        }
        else
        {
            _S479 = 0U;
        }
        add_texel_0(_S458, _S478 + _S479, _S462 * _S477.x * _S477.y, _S463);
        corner_0 = corner_0 + 1U;
    }
    return;
}

__device__ void code_footprint_0(uint _S480, AnisotropicTaps_0 * _S481, float3  _S482, bool _S483, FixedArray<float, 88>  * _S484)
{
    float offset_2;
    Fabric_0 * _S485 = (&(globalParams_0->fabrics_0)[_S480]);
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
        (*_S484)[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    Neural_0 _S486 = slang_ldg_1(&_S485->neural_0);
    float2  _S487 = make_float2 (_S486.ends_0, _S486.picks_0);
    float _S488 = float(_S486.top_level_0);
    float _S489 = clamp_1(binary_logarithm_0((F32_max((_S481->side_0), (9.99999997475242708e-07f)))) + 3.0f, 0.0f, _S488);
    float _S490 = (F32_min(((F32_floor((_S489)))), (_S488 - 1.0f)));
    bool _S491 = AnisotropicTaps_has_steps_0(_S481);
    uint _S492;
    if(_S491)
    {
        _S492 = 4U;
    }
    else
    {
        _S492 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S492))
        {
        }
        else
        {
            break;
        }
        float2  _S493 = AnisotropicTaps_place_0(_S481, number_1 >> int(1));
        float2  _S494 = clamp_2(_S493 - _S487 * floor_0(_S493 / _S487), make_float2 (0.0f), _S487);
        bool _S495 = (number_1 & 1U) != 0U;
        if(_S495)
        {
            offset_2 = _S489 - _S490;
        }
        else
        {
            offset_2 = 1.0f - (_S489 - _S490);
        }
        float _S496 = offset_2 / float(_S492);
        uint _S497 = uint(_S490);
        uint _S498;
        if(_S495)
        {
            _S498 = 1U;
        }
        else
        {
            _S498 = 0U;
        }
        add_level_0(_S480, _S497 + _S498, _S483, _S494, _S496, _S484);
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
            float offset_3 = _slang_vector_get_element(_S482, number_2) - (float(bin_0) + 0.5f) / 8.0f;
            if(number_2 < int(2))
            {
                offset_2 = offset_3 - (F32_round((offset_3)));
            }
            else
            {
                offset_2 = offset_3;
            }
            (*_S484)[int(64) + number_2 * int(8) + bin_0] = bump_0(offset_2 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_2 = number_2 + int(1);
    }
    return;
}

__device__ float3  crown_fibres_0(uint _S499, bool _S500, bool _S501)
{
    Fabric_0 * _S502 = (&(globalParams_0->fabrics_0)[_S499]);
    float _S503;
    if(_S500)
    {
        if(_S501)
        {
            Neural_0 _S504 = slang_ldg_1(&_S502->neural_0);
            _S503 = - _S504.warp_x_0;
        }
        else
        {
            Neural_0 _S505 = slang_ldg_1(&_S502->neural_0);
            _S503 = _S505.warp_x_0;
        }
        Neural_0 _S506 = slang_ldg_1(&_S502->neural_0);
        return make_float3 (_S503, _S506.warp_y_0, _S506.warp_roughness_0);
    }
    Neural_0 _S507 = slang_ldg_1(&_S502->neural_0);
    if(_S501)
    {
        _S503 = - _S507.weft_y_0;
    }
    else
    {
        _S503 = _S507.weft_y_0;
    }
    return make_float3 (_S507.weft_x_0, _S503, _S507.weft_roughness_0);
}

__device__ void neural_view_0(uint _S508, Footprint_0 * _S509, float3  _S510, NeuralView_0 * _S511)
{
    Fabric_0 * _S512 = (&(globalParams_0->fabrics_0)[_S508]);
    bool _S513 = (_S510.z) < 0.0f;
    AnisotropicTaps_0 _S514 = anisotropic_taps_0(_S508, _S509);
    AnisotropicTaps_0 _S515 = _S514;
    float3  _S516 = footprint_coordinates_0(&_S515);
    float3  _S517 = to_face_frame_0(_S510, _S513);
    HalfWeights_0 weights_23;
    Neural_0 _S518 = slang_ldg_1(&_S512->neural_0);
    (&weights_23)->first_2 = _S518.network_0;
    AnisotropicTaps_0 _S519 = _S514;
    FixedArray<float, 88>  inputs_23;
    code_footprint_0(_S508, &_S519, _S516, _S513, &inputs_23);
    HalfWeights_0 _S520 = weights_23;
    FixedArray<float, 96>  hidden_1;
    dense_7(&_S520, 0U, false, &inputs_23, &hidden_1);
    HalfWeights_0 _S521 = weights_23;
    FixedArray<float, 100>  fused_0;
    dense_part_8(&_S521, 1068U, false, &hidden_1, &fused_0);
    fused_0[int(96)] = _S517.x;
    fused_0[int(97)] = _S517.y;
    float3  _S522 = crown_fibres_0(_S508, true, _S513);
    float2  _S523 = float2 {_S517.x, _S517.y};
    fused_0[int(98)] = dot_1(float2 {_S522.x, _S522.y}, _S523);
    float3  _S524 = crown_fibres_0(_S508, false, _S513);
    fused_0[int(99)] = dot_1(float2 {_S524.x, _S524.y}, _S523);
    HalfWeights_0 _S525 = weights_23;
    FixedArray<float, 16>  of_hole_0;
    dense_6(&_S525, 2232U, false, &fused_0, &of_hole_0);
    HalfWeights_0 _S526 = weights_23;
    FixedArray<float, 1>  hole_1;
    dense_5(&_S526, 2444U, false, &of_hole_0, &hole_1);
    HalfWeights_0 _S527 = weights_23;
    dense_4(&_S527, 2456U, false, &fused_0, &_S511->sums_7);
    _S511->hole_0 = clamp_1(hole_1[int(0)], 0.0f, 1.0f);
    _S511->correction_weight_0 = correction_weight_of_0(_S516.z);
    _S511->view_6 = _S517;
    _S511->back_5 = _S513;
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

__device__ void code_light_0(uint _S528, float3  _S529, float3  _S530, bool _S531, FixedArray<float, 39>  * _S532)
{
    (*_S532)[int(0)] = _S529.x;
    (*_S532)[int(1)] = _S529.y;
    (*_S532)[int(2)] = _S529.z;
    float3  _S533 = _S529 + _S530;
    float _S534 = _S533.z;
    float _S535 = _S534 * _S534 + 0.00009999999747379f;
    float2  _S536 = float2 {_S533.x, _S533.y};
    float _S537 = 1.0f / (dot_1(_S536, _S536) + _S535);
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
        float3  _S538 = crown_fibres_0(_S528, family_10 == int(0), _S531);
        float2  _S539 = float2 {_S538.x, _S538.y};
        (*_S532)[int(3) + family_10] = dot_1(_S539, float2 {_S529.x, _S529.y});
        float _S540 = dot_1(_S539, _S536);
        float _S541 = _S540 * _S540;
        float _S542 = (0.75f * _S540 / (0.5f * (F32_sqrt((_S541 + _S535))) + (F32_abs((_S540)))) + 0.5f) * 8.0f;
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
            (*_S532)[int(5) + family_10 * int(16) + bin_1] = bump_0(_S542 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S543 = _S538.z;
        float _S544 = _S543 * _S543;
        float _S545 = _S541 * _S537 * (1.0f - _S544) + _S544;
        (*_S532)[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S544 * _S543 / (_S545 * _S545));
        family_10 = family_10 + int(1);
    }
    return;
}

__device__ float mixed_bundles_0(uint _S546, uint _S547, uint _S548, float3  _S549, float3  _S550, bool _S551, FixedArray<float, 52>  * _S552)
{
    Fabric_0 * _S553 = (&(globalParams_0->fabrics_0)[_S546]);
    float3  _S554 = _S549 + _S550;
    float _S555 = 1.0f / (square_1(_S554) + 0.00009999999747379f);
    bool _S556;
    if(_S547 == 0U)
    {
        _S556 = _S551;
    }
    else
    {
        _S556 = false;
    }
    float _S557;
    if(_S556)
    {
        _S557 = - _S554.x;
    }
    else
    {
        _S557 = _S554.x;
    }
    if(_S547 == 1U)
    {
        _S556 = _S551;
    }
    else
    {
        _S556 = false;
    }
    float _S558;
    if(_S556)
    {
        _S558 = - _S554.y;
    }
    else
    {
        _S558 = _S554.y;
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
        Neural_0 _S559 = slang_ldg_1(&_S553->neural_0);
        uint _S560 = _S547 * 25U;
        uint _S561 = _S559.bundles_0 + 4U * (_S560 + bundle_1);
        float _S562 = dot_2(make_float3 (table_number_0(_S561), table_number_0(_S561 + 1U), table_number_0(_S561 + 2U)), make_float3 (_S557, _S558, _S554.z));
        float _S563 = _S562 * _S562 * _S555 + table_number_0(_S561 + 3U);
        uint _S564 = _S548 + _S560;
        uint _S565;
        if(_S551)
        {
            _S565 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S565 = bundle_1;
        }
        float sum_3 = sum_2 + (F32_max(((*_S552)[_S564 + _S565]), ((*_S552)[_S564 + _S565] * 0.00999999977648258f))) / (_S563 * _S563);
        bundle_1 = bundle_1 + 1U;
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

__device__ Components_0 neural_components_0(uint _S566, NeuralView_0 * _S567, float3  _S568)
{
    float _S569;
    Fabric_0 * _S570 = (&(globalParams_0->fabrics_0)[_S566]);
    bool _S571 = _S567->back_5;
    float3  _S572 = to_face_frame_0(_S568, _S567->back_5);
    float3  _S573 = _S567->view_6;
    HalfWeights_0 weights_24;
    Neural_0 _S574 = slang_ldg_1(&_S570->neural_0);
    (&weights_24)->first_2 = _S574.network_0;
    FixedArray<float, 39>  directions_0;
    code_light_0(_S566, _S572, _S573, _S571, &directions_0);
    FixedArray<float, 96>  skip_0;
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
        skip_0[k_1] = _S567->sums_7[k_1];
        k_1 = k_1 + int(1);
    }
    HalfWeights_0 _S575 = weights_24;
    dense_3(&_S575, 3716U, true, &directions_0, &skip_0);
    FixedArray<float, 96>  hidden_2;
    FixedArray<float, 96>  next_0;
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
                _S569 = skip_0[k_1];
            }
            else
            {
                _S569 = 0.0f;
            }
            next_0[k_1] = _S569;
            k_1 = k_1 + int(1);
        }
        uint _S576 = 4208U + layer_0 * 1164U;
        HalfWeights_0 _S577 = weights_24;
        dense_2(&_S577, _S576, true, &hidden_2, &next_0);
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
    HalfWeights_0 _S578 = weights_24;
    FixedArray<float, 52>  outputs_17;
    dense_1(&_S578, 7700U, false, &hidden_2, &outputs_17);
    bool _S579;
    if((_S574.is_corrected_0) != 0U)
    {
        _S579 = (_S572.z) > 0.0f;
    }
    else
    {
        _S579 = false;
    }
    if(_S579)
    {
        _S579 = (_S567->correction_weight_0) > 0.0f;
    }
    else
    {
        _S579 = false;
    }
    if(_S579)
    {
        FloatWeights_0 fitted_0;
        (&fitted_0)->first_0 = _S574.correction_0;
        FloatWeights_0 _S580 = fitted_0;
        FixedArray<float, 50>  change_0;
        dense_0(&_S580, 0U, false, &hidden_2, &change_0);
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
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S567->correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S572.z) > 0.0f)
    {
        _S569 = 0.00999999977648258f;
    }
    else
    {
        _S569 = 0.00100000004749745f;
    }
    Components_0 result_16;
    float _S581 = unmapped_0(outputs_17[int(0)], _S569);
    (&result_16)->diffuse_warp_0 = _S581;
    float _S582 = unmapped_0(outputs_17[int(1)], _S569);
    (&result_16)->diffuse_weft_0 = _S582;
    float _S583 = 2979.9580078125f * _S569;
    float _S584 = mixed_bundles_0(_S566, 0U, 2U, _S572, _S573, _S571, &outputs_17);
    (&result_16)->specular_warp_0 = clamp_1(_S584, 0.0f, _S583);
    float _S585 = mixed_bundles_0(_S566, 1U, 2U, _S572, _S573, _S571, &outputs_17);
    (&result_16)->specular_weft_0 = clamp_1(_S585, 0.0f, _S583);
    float _S586 = _S567->hole_0;
    (&result_16)->hole_2 = _S567->hole_0;
    float _S587 = _S581 + _S582;
    float _S588 = __ldg(&_S570->diffuse_blend_0);
    (&result_16)->light_visibility_1 = (F32_min((light_visibility_of_0(_S587, _S572, _S573, _S588)), (1.0f - _S586)));
    return result_16;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_4;
    Albedos_0 weft_4;
};

__device__ FamilyAlbedos_0 albedos_over_0(uint _S589, Footprint_0 * _S590, bool _S591)
{
    Fabric_0 * _S592 = (&(globalParams_0->fabrics_0)[_S589]);
    float2  _S593 = sqrt_0(_S590->dx_0 * _S590->dx_0 + _S590->dy_0 * _S590->dy_0);
    uint _S594 = __ldg(&_S592->warp_0);
    float2  _S595 = _S590->centre_0;
    Stretch_0 _S596 = stretch_of_0(_S594, _S590->centre_0.x, _S593.x);
    uint _S597 = __ldg(&_S592->weft_0);
    Stretch_0 _S598 = stretch_of_0(_S597, _S595.y, _S593.y);
    FamilyAlbedos_0 albedos_4;
    Stretch_0 _S599 = _S596;
    Stretch_0 _S600 = _S598;
    Albedos_0 _S601 = mean_albedos_0(_S594, _S597, &_S599, &_S600, _S591);
    (&albedos_4)->warp_4 = _S601;
    Stretch_0 _S602 = _S598;
    Stretch_0 _S603 = _S596;
    Albedos_0 _S604 = mean_albedos_0(_S597, _S594, &_S602, &_S603, _S591);
    (&albedos_4)->weft_4 = _S604;
    return albedos_4;
}

__device__ float openness_number_0(uint _S605, uint _S606)
{
    uint _S607 = __ldg(&(&(globalParams_0->fabrics_0)[_S605])->openness_0);
    return table_number_0(_S607 + _S606);
}

__device__ Scattered_0 scattered_by_0(uint _S608, Albedos_0 * _S609, uint _S610, float3  _S611)
{
    uint _S612 = 159U + 2U * _S610;
    Scattered_0 yarn_1;
    float3  _S613 = _S611 * _S609->diffuse_reflect_0;
    float _S614 = openness_number_0(_S608, _S612);
    (&yarn_1)->back_4 = _S613 + make_float3 (_S614) * _S609->specular_reflect_0;
    float3  _S615 = _S611 * _S609->diffuse_transmit_0;
    float _S616 = openness_number_0(_S608, _S612 + 1U);
    (&yarn_1)->through_0 = _S615 + make_float3 (_S616) * _S609->specular_transmit_0;
    return yarn_1;
}

__device__ void sent_0(uint _S617, uint _S618, float3  _S619, float3  _S620, float3  _S621, float3  _S622, float3  * _S623, float3  * _S624)
{
    uint _S625 = 146U + 4U * _S618;
    float _S626 = openness_number_0(_S617, _S625);
    float _S627 = openness_number_0(_S617, _S625 + 1U);
    float _S628 = openness_number_0(_S617, _S625 + 2U);
    float _S629 = openness_number_0(_S617, _S625 + 3U);
    float3  _S630 = make_float3 (1.0f) - _S621 * make_float3 (_S626);
    float3  _S631 = make_float3 (1.0f) - _S622 * make_float3 (_S629);
    float3  _S632 = make_float3 (1.0f) / (_S630 * _S631 - _S621 * _S622 * make_float3 (_S627 * _S628));
    *_S623 = (_S619 * _S631 + _S621 * make_float3 (_S627) * _S620) * _S632;
    *_S624 = (_S620 * _S630 + _S622 * make_float3 (_S628) * _S619) * _S632;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S633, uint _S634, Scattered_0 * _S635, Scattered_0 * _S636)
{
    uint _S637 = 2U * _S634;
    uint _S638 = 142U + _S637;
    float _S639 = openness_number_0(_S633, _S638);
    float _S640 = openness_number_0(_S633, _S638 + 1U);
    float3  _S641 = make_float3 (1.0f - _S639) * _S635->back_4;
    float3  _S642 = make_float3 (1.0f - _S640) * _S636->back_4;
    FaceSends_0 sends_1;
    uint _S643 = 154U + _S637;
    float _S644 = openness_number_0(_S633, _S643);
    (&sends_1)->blocks_warp_0 = _S644;
    float _S645 = openness_number_0(_S633, _S643 + 1U);
    (&sends_1)->blocks_weft_0 = _S645;
    (&sends_1)->open_0 = _S644 * _S639 + _S645 * _S640;
    sent_0(_S633, _S634, make_float3 (_S639) * _S635->back_4, make_float3 (_S640) * _S636->back_4, _S641, _S642, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S633, _S634, _S635->through_0, _S636->through_0, _S641, _S642, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S646, float3  _S647, bool _S648)
{
    Fabric_0 * _S649 = (&(globalParams_0->fabrics_0)[_S646]);
    uint _S650 = __ldg(&_S649->warp_0);
    uint _S651 = __ldg(&(&(globalParams_0->families_0)[_S650])->colour_mean_0);
    Albedos_0 _S652 = table_albedos_0(_S651);
    Scattered_0 _S653 = scattered_by_0(_S646, &_S652, 0U, _S647);
    uint _S654 = __ldg(&_S649->weft_0);
    uint _S655 = __ldg(&(&(globalParams_0->families_0)[_S654])->colour_mean_0);
    Albedos_0 _S656 = table_albedos_0(_S655);
    Scattered_0 _S657 = scattered_by_0(_S646, &_S656, 1U, _S647);
    uint _S658;
    if(_S648)
    {
        _S658 = 1U;
    }
    else
    {
        _S658 = 0U;
    }
    Scattered_0 _S659 = _S653;
    Scattered_0 _S660 = _S657;
    FaceSends_0 _S661 = face_sends_0(_S646, _S658, &_S659, &_S660);
    if(_S648)
    {
        _S658 = 0U;
    }
    else
    {
        _S658 = 1U;
    }
    Scattered_0 _S662 = _S653;
    Scattered_0 _S663 = _S657;
    FaceSends_0 _S664 = face_sends_0(_S646, _S658, &_S662, &_S663);
    float3  _S665 = make_float3 (_S661.blocks_warp_0) * _S661.crossing_warp_0 + make_float3 (_S661.blocks_weft_0) * _S661.crossing_weft_0;
    float3  _S666 = make_float3 (_S664.blocks_warp_0) * _S664.crossing_warp_0 + make_float3 (_S664.blocks_weft_0) * _S664.crossing_weft_0;
    float _S667 = 1.0f - _S661.open_0;
    float _S668 = 1.0f - _S664.open_0;
    float3  _S669 = make_float3 (1.0f) / (make_float3 (1.0f) - _S665 * _S666 * make_float3 (_S667 * _S668));
    float3  _S670 = _S666 * (make_float3 (_S661.open_0) + make_float3 (_S667) * (make_float3 (_S661.blocks_warp_0) * _S661.sky_warp_0 + make_float3 (_S661.blocks_weft_0) * _S661.sky_weft_0)) * _S669;
    float3  _S671 = _S665 * (make_float3 (_S664.open_0) + make_float3 (_S668) * (make_float3 (_S664.blocks_warp_0) * _S664.sky_warp_0 + make_float3 (_S664.blocks_weft_0) * _S664.sky_weft_0)) * _S669;
    FaceSends_0 _S672 = _S661;
    FaceRadiance_0 _S673 = face_radiance_0(&_S672, _S664.open_0, _S670, _S671);
    FaceSends_0 _S674 = _S664;
    FaceRadiance_0 _S675 = face_radiance_0(&_S674, _S661.open_0, _S671, _S670);
    Interior_0 interior_1;
    (&interior_1)->warp_3 = _S673.warp_2;
    (&interior_1)->weft_3 = _S673.weft_2;
    (&interior_1)->leaked_1 = _S673.leaked_0;
    (&interior_1)->far_1 = _S675.mean_0;
    (&interior_1)->far_leaked_0 = _S675.leaked_0;
    return interior_1;
}

__device__ Blocked_0 blocked_of_terms_0(uint _S676, uint _S677, FixedArray<float, 6>  * _S678, uint _S679)
{
    FixedArray<float, 3>  shares_0;
    uint share_2 = 0U;
    for(;;)
    {
        if(share_2 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_2] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S679)
            {
            }
            else
            {
                break;
            }
            float _S680 = openness_number_0(_S676, _S677 + share_2 * _S679 + term_0);
            shares_0[share_2] = shares_0[share_2] + _S680 * (*_S678)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_2] = saturate_0(shares_0[share_2]);
        share_2 = share_2 + 1U;
    }
    Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

__device__ Blocked_0 blocked_from_0(uint _S681, float3  _S682, bool _S683, bool _S684)
{
    FixedArray<float, 6>  terms_1;
    view_terms_0(_S682, &terms_1);
    uint _S685;
    if(_S684)
    {
        _S685 = 2U;
    }
    else
    {
        _S685 = 0U;
    }
    uint _S686;
    if(_S683)
    {
        _S686 = 0U;
    }
    else
    {
        _S686 = 1U;
    }
    uint _S687 = (_S685 + _S686) * 15U;
    FixedArray<float, 6>  _S688 = terms_1;
    Blocked_0 _S689 = blocked_of_terms_0(_S681, _S687, &_S688, 5U);
    return _S689;
}

__device__ float warp_seen_from_0(uint _S690, float3  _S691, bool _S692)
{
    FixedArray<float, 6>  terms_2;
    view_terms_0(_S691, &terms_2);
    uint term_1 = 0U;
    float share_3 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S693;
        if(_S692)
        {
            _S693 = 5U;
        }
        else
        {
            _S693 = 0U;
        }
        float _S694 = openness_number_0(_S690, 132U + _S693 + term_1);
        float share_4 = share_3 + _S694 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_3 = share_4;
    }
    return saturate_0(share_3);
}

__device__ Bounced_0 bounced_of_families_0(uint _S695, FamilyAlbedos_0 * _S696, float3  _S697, Interior_0 * _S698, Blocked_0 * _S699, Blocked_0 * _S700)
{
    Scattered_0 _S701 = scattered_by_0(_S695, &_S696->warp_4, 0U, _S697);
    Scattered_0 _S702 = _S701;
    Bounced_0 _S703 = bounced_by_0(_S699, &_S702, _S698);
    Scattered_0 _S704 = scattered_by_0(_S695, &_S696->weft_4, 1U, _S697);
    Scattered_0 _S705 = _S704;
    Bounced_0 _S706 = bounced_by_0(_S700, &_S705, _S698);
    Bounced_0 _S707 = _S703;
    Bounced_0 _S708 = _S706;
    Bounced_0 _S709 = sum_of_0(&_S707, &_S708);
    return _S709;
}

__device__ Bounced_0 bounced_far_0(uint _S710, FamilyAlbedos_0 * _S711, float3  _S712, Interior_0 * _S713, float3  _S714, bool _S715, float _S716, float _S717, float _S718)
{
    Blocked_0 _S719 = blocked_from_0(_S710, _S714, true, _S715);
    Blocked_0 _S720 = blocked_from_0(_S710, _S714, false, _S715);
    float _S721 = _S716 / (F32_max((1.0f - _S719.by_warp_0 - _S719.by_weft_0), (0.10000000149011612f)));
    float _S722 = _S717 / (F32_max((1.0f - _S720.by_warp_0 - _S720.by_weft_0), (0.10000000149011612f)));
    float _S723 = warp_seen_from_0(_S710, _S714, _S715);
    float _S724 = (0.0020000000949949f * _S723 + _S721) / (_S721 + _S722 + 0.0020000000949949f);
    float _S725 = 1.0f - _S718;
    float _S726 = _S724 * _S725;
    Blocked_0 _S727 = _S719;
    Blocked_0 _S728 = scaled_0(&_S727, _S726);
    float _S729 = (1.0f - _S724) * _S725;
    Blocked_0 _S730 = _S720;
    Blocked_0 _S731 = scaled_0(&_S730, _S729);
    Blocked_0 _S732 = _S728;
    Blocked_0 _S733 = _S731;
    Bounced_0 _S734 = bounced_of_families_0(_S710, _S711, _S712, _S713, &_S732, &_S733);
    return _S734;
}

__device__ Bounced_0 bounced_over_0(uint _S735, Components_0 * _S736, CloseUp_0 * _S737, FamilyAlbedos_0 * _S738, float3  _S739, float3  _S740)
{
    bool _S741 = (_S740.z) < 0.0f;
    Interior_0 _S742 = interior_of_0(_S735, _S739, _S741);
    float3  _S743 = to_face_frame_0(_S740, _S741);
    Interior_0 _S744 = _S742;
    Bounced_0 _S745 = bounced_far_0(_S735, _S738, _S739, &_S744, _S743, _S741, _S736->diffuse_warp_0, _S736->diffuse_weft_0, _S736->hole_2);
    Bounced_0 bounced_2 = _S745;
    float _S746 = _S737->weight_2;
    if((_S737->weight_2) > 0.0f)
    {
        Interior_0 _S747 = _S742;
        Bounced_0 _S748 = bounced_of_families_0(_S735, _S738, _S739, &_S747, &_S737->warp_1, &_S737->weft_1);
        float3  _S749 = make_float3 (_S746);
        (&bounced_2)->reflected_0 = lerp_0((&bounced_2)->reflected_0, _S748.reflected_0, _S749);
        (&bounced_2)->transmitted_0 = lerp_0((&bounced_2)->transmitted_0, _S748.transmitted_0, _S749);
    }
    return bounced_2;
}

__device__ float3  composed_0(uint _S750, Components_0 * _S751, CloseUp_0 * _S752, FamilyAlbedos_0 * _S753, float3  _S754, float3  _S755, float3  _S756)
{
    Fabric_0 * _S757 = (&(globalParams_0->fabrics_0)[_S750]);
    Albedos_0 _S758 = tinted_0(&_S753->warp_4, _S754);
    Albedos_0 _S759 = tinted_0(&_S753->weft_4, _S754);
    float _S760 = _S751->diffuse_warp_0;
    float _S761 = _S751->diffuse_weft_0;
    float _S762 = _S751->specular_warp_0;
    float _S763 = _S751->specular_weft_0;
    float3  _S764 = _S758.diffuse_reflect_0 * make_float3 (_S751->diffuse_warp_0) + _S759.diffuse_reflect_0 * make_float3 (_S751->diffuse_weft_0) + _S758.specular_reflect_0 * make_float3 (_S751->specular_warp_0) + _S759.specular_reflect_0 * make_float3 (_S751->specular_weft_0);
    float _S765 = _S756.z;
    float3  body_0;
    if((_S755.z * _S765) < 0.0f)
    {
        body_0 = _S758.diffuse_transmit_0 * make_float3 (_S760) + _S759.diffuse_transmit_0 * make_float3 (_S761) + _S758.specular_transmit_0 * make_float3 (_S762) + _S759.specular_transmit_0 * make_float3 (_S763);
    }
    else
    {
        body_0 = _S764;
    }
    uint _S766 = __ldg(&_S757->openness_0);
    if(_S766 != 4294967295U)
    {
        Bounced_0 _S767 = bounced_over_0(_S750, _S751, _S752, _S753, _S754, _S756);
        Bounced_0 _S768 = _S767;
        float3  _S769 = bounced_value_0(&_S768, _S755, _S756);
        body_0 = body_0 + _S769;
    }
    float _S770 = __ldg(&_S757->sheen_strength_0);
    if(_S770 <= 0.0f)
    {
        return body_0;
    }
    bool _S771 = _S765 < 0.0f;
    float3  _S772 = to_face_frame_0(_S755, _S771);
    float3  _S773 = to_face_frame_0(_S756, _S771);
    float _S774 = __ldg(&_S757->sheen_roughness_0);
    float2  _S775 = sheen_with_transmittance_0(_S772, _S773, _S770, _S774);
    return make_float3 (_S775.y) * body_0 + make_float3 ((_S751->light_visibility_1 + _S751->hole_2) * _S775.x);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_3, float2  dx_1, float2  dy_1, float3  light_5, float3  view_7)
{
    Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = centre_3;
    (&footprint_1)->dx_0 = dx_1;
    (&footprint_1)->dy_0 = dy_1;
    Footprint_0 _S776 = footprint_1;
    NeuralView_0 activations_0;
    neural_view_0(fabric_2, &_S776, view_7, &activations_0);
    Components_0 _S777 = neural_components_0(fabric_2, &activations_0, light_5);
    float _S778 = view_7.z;
    bool _S779 = _S778 < 0.0f;
    Footprint_0 _S780 = footprint_1;
    FamilyAlbedos_0 _S781 = albedos_over_0(fabric_2, &_S780, _S779);
    CloseUp_0 _S782 = no_close_up_0();
    float3  _S783 = make_float3 (1.0f);
    Components_0 _S784 = _S777;
    CloseUp_0 _S785 = _S782;
    FamilyAlbedos_0 _S786 = _S781;
    float3  _S787 = composed_0(fabric_2, &_S784, &_S785, &_S786, _S783, light_5, view_7);
    float through_1 = (&activations_0)->hole_0;
    float _S788 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
    float through_2;
    if(_S788 > 0.0f)
    {
        float _S789 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
        float _S790 = (F32_abs((_S778)));
        float _S791 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_roughness_0);
        through_2 = through_1 * (1.0f - _S789 * sheen_lobe_0(_S790, _S791).z);
    }
    else
    {
        through_2 = through_1;
    }
    return make_float4 (_S787.x, _S787.y, _S787.z, through_2);
}

extern "C" __global__ void neural_queries()
{
    uint _S792 = (blockIdx * blockDim + threadIdx).x;
    uint _S793 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S792 >= _S793)
    {
        return;
    }
    Query_0 _S794 = slang_ldg_0((&(globalParams_0->queries_0)[_S792]));
    *(&(globalParams_0->answers_0)[_S792]) = cloth_value_0(_S794.fabric_1, make_float2 (_S794.centre_x_0, _S794.centre_y_0), make_float2 (_S794.dx_x_0, _S794.dx_y_0), make_float2 (_S794.dy_x_0, _S794.dy_y_0), make_float3 (_S794.light_x_0, _S794.light_y_0, _S794.light_z_0), make_float3 (_S794.view_x_0, _S794.view_y_0, _S794.view_z_0));
    return;
}

