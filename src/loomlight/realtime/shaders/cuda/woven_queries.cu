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
    uint columns_0;
    uint rows_0;
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
    uint clusters_0;
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
    float4  sums_0 = make_float4 (0.0f);
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
        *&((&sums_0)->x) = *&((&sums_0)->x) + (dot_0(_S8.low_0, low_1) + dot_0(_S8.high_0, high_1));
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 12U + column_0);
        *&((&sums_0)->y) = *&((&sums_0)->y) + (dot_0(_S9.low_0, low_1) + dot_0(_S9.high_0, high_1));
        Eight_0 _S10 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        *&((&sums_0)->z) = *&((&sums_0)->z) + (dot_0(_S10.low_0, low_1) + dot_0(_S10.high_0, high_1));
        Eight_0 _S11 = FloatWeights_eight_0(weights_0, row_0 + 36U + column_0);
        *&((&sums_0)->w) = *&((&sums_0)->w) + (dot_0(_S11.low_0, low_1) + dot_0(_S11.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_0;
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
    float4  sums_1 = make_float4 (0.0f);
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
        *&((&sums_1)->x) = *&((&sums_1)->x) + (dot_0(_S32.low_0, low_2) + dot_0(_S32.high_0, high_2));
        Eight_0 _S33 = HalfWeights_eight_0(weights_2, row_1 + 12U + column_1);
        *&((&sums_1)->y) = *&((&sums_1)->y) + (dot_0(_S33.low_0, low_2) + dot_0(_S33.high_0, high_2));
        Eight_0 _S34 = HalfWeights_eight_0(weights_2, row_1 + 24U + column_1);
        *&((&sums_1)->z) = *&((&sums_1)->z) + (dot_0(_S34.low_0, low_2) + dot_0(_S34.high_0, high_2));
        Eight_0 _S35 = HalfWeights_eight_0(weights_2, row_1 + 36U + column_1);
        *&((&sums_1)->w) = *&((&sums_1)->w) + (dot_0(_S35.low_0, low_2) + dot_0(_S35.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_1;
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
    float4  sums_2 = make_float4 (0.0f);
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
        *&((&sums_2)->x) = *&((&sums_2)->x) + (dot_0(_S51.low_0, low_3) + dot_0(_S51.high_0, high_3));
        Eight_0 _S52 = HalfWeights_eight_0(weights_4, row_2 + 5U + column_2);
        *&((&sums_2)->y) = *&((&sums_2)->y) + (dot_0(_S52.low_0, low_3) + dot_0(_S52.high_0, high_3));
        Eight_0 _S53 = HalfWeights_eight_0(weights_4, row_2 + 10U + column_2);
        *&((&sums_2)->z) = *&((&sums_2)->z) + (dot_0(_S53.low_0, low_3) + dot_0(_S53.high_0, high_3));
        Eight_0 _S54 = HalfWeights_eight_0(weights_4, row_2 + 15U + column_2);
        *&((&sums_2)->w) = *&((&sums_2)->w) + (dot_0(_S54.low_0, low_3) + dot_0(_S54.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_2;
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
    float4  sums_3 = make_float4 (0.0f);
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
        *&((&sums_3)->x) = *&((&sums_3)->x) + (dot_0(_S70.low_0, low_4) + dot_0(_S70.high_0, high_4));
        Eight_0 _S71 = HalfWeights_eight_0(weights_6, row_3 + 13U + column_3);
        *&((&sums_3)->y) = *&((&sums_3)->y) + (dot_0(_S71.low_0, low_4) + dot_0(_S71.high_0, high_4));
        Eight_0 _S72 = HalfWeights_eight_0(weights_6, row_3 + 26U + column_3);
        *&((&sums_3)->z) = *&((&sums_3)->z) + (dot_0(_S72.low_0, low_4) + dot_0(_S72.high_0, high_4));
        Eight_0 _S73 = HalfWeights_eight_0(weights_6, row_3 + 39U + column_3);
        *&((&sums_3)->w) = *&((&sums_3)->w) + (dot_0(_S73.low_0, low_4) + dot_0(_S73.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_3;
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
    float4  sums_4 = make_float4 (0.0f);
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
        *&((&sums_4)->x) = *&((&sums_4)->x) + (dot_0(_S89.low_0, low_5) + dot_0(_S89.high_0, high_5));
        Eight_0 _S90 = HalfWeights_eight_0(weights_8, row_4 + 2U + column_4);
        *&((&sums_4)->y) = *&((&sums_4)->y) + (dot_0(_S90.low_0, low_5) + dot_0(_S90.high_0, high_5));
        Eight_0 _S91 = HalfWeights_eight_0(weights_8, row_4 + 4U + column_4);
        *&((&sums_4)->z) = *&((&sums_4)->z) + (dot_0(_S91.low_0, low_5) + dot_0(_S91.high_0, high_5));
        Eight_0 _S92 = HalfWeights_eight_0(weights_8, row_4 + 6U + column_4);
        *&((&sums_4)->w) = *&((&sums_4)->w) + (dot_0(_S92.low_0, low_5) + dot_0(_S92.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_4;
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
    float4  sums_5 = make_float4 (0.0f);
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
        *&((&sums_5)->x) = *&((&sums_5)->x) + (dot_0(_S130.low_0, low_6) + dot_0(_S130.high_0, high_6));
        Eight_0 _S131 = HalfWeights_eight_0(weights_12, row_5 + 11U + column_5);
        *&((&sums_5)->y) = *&((&sums_5)->y) + (dot_0(_S131.low_0, low_6) + dot_0(_S131.high_0, high_6));
        Eight_0 _S132 = HalfWeights_eight_0(weights_12, row_5 + 22U + column_5);
        *&((&sums_5)->z) = *&((&sums_5)->z) + (dot_0(_S132.low_0, low_6) + dot_0(_S132.high_0, high_6));
        Eight_0 _S133 = HalfWeights_eight_0(weights_12, row_5 + 33U + column_5);
        *&((&sums_5)->w) = *&((&sums_5)->w) + (dot_0(_S133.low_0, low_6) + dot_0(_S133.high_0, high_6));
        column_5 = column_5 + 1U;
    }
    return sums_5;
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
    Query_0 _S169 = { _S156, _S157, _S158, _S159, _S160, _S161, _S162, _S163, _S164, _S165, _S166, _S167, _S168 };
    return _S169;
}

__device__ Woven_0 slang_ldg_1(Woven_0 * ptr_1)
{
    uint _S170 = __ldg(&ptr_1->is_encoded_0);
    uint _S171 = __ldg(&ptr_1->network_0);
    uint _S172 = __ldg(&ptr_1->latents_0);
    uint _S173 = __ldg(&ptr_1->texels_0);
    uint _S174 = __ldg(&ptr_1->levels_1);
    uint _S175 = __ldg(&ptr_1->top_level_0);
    float _S176 = __ldg(&ptr_1->ends_0);
    float _S177 = __ldg(&ptr_1->picks_0);
    float _S178 = __ldg(&ptr_1->ends_per_mm_0);
    float _S179 = __ldg(&ptr_1->picks_per_mm_0);
    float _S180 = __ldg(&ptr_1->pitch_0);
    float _S181 = __ldg(&ptr_1->warp_x_0);
    float _S182 = __ldg(&ptr_1->warp_y_0);
    float _S183 = __ldg(&ptr_1->warp_roughness_0);
    float _S184 = __ldg(&ptr_1->weft_x_0);
    float _S185 = __ldg(&ptr_1->weft_y_0);
    float _S186 = __ldg(&ptr_1->weft_roughness_0);
    float _S187 = __ldg(&ptr_1->warp_lobe_roughness_0);
    float _S188 = __ldg(&ptr_1->weft_lobe_roughness_0);
    uint _S189 = __ldg(&ptr_1->bundles_0);
    uint _S190 = __ldg(&ptr_1->is_corrected_0);
    uint _S191 = __ldg(&ptr_1->correction_0);
    Woven_0 _S192 = { _S170, _S171, _S172, _S173, _S174, _S175, _S176, _S177, _S178, _S179, _S180, _S181, _S182, _S183, _S184, _S185, _S186, _S187, _S188, _S189, _S190, _S191 };
    return _S192;
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
    float _S193 = footprint_0->dx_0.x;
    float _S194 = footprint_0->dy_0.x;
    float _S195 = _S193 * _S193 + _S194 * _S194;
    float _S196 = footprint_0->dx_0.y;
    float _S197 = footprint_0->dy_0.y;
    float _S198 = _S196 * _S196 + _S197 * _S197;
    float _S199 = _S193 * _S196 + _S194 * _S197;
    float _S200 = 0.5f * (_S195 - _S198);
    float _S201 = 0.5f * (_S195 + _S198);
    float _S202 = (F32_sqrt((_S200 * _S200 + _S199 * _S199)));
    float _S203 = _S201 + _S202;
    float _S204 = (F32_max((_S203 - 1.5f * (F32_max((_S201 - _S202), (0.0f)))), (0.0f)));
    float _S205 = square_0(4.0f);
    float _S206 = (F32_max((_S201 - 0.5f * _S204), (_S203 / _S205)));
    float _S207 = (F32_sqrt(((F32_max(((F32_min((_S204), (_S203 - _S206)))), (0.0f))) / (_S205 - 1.0f))));
    float _S208 = _S200 / (F32_max((_S202), (1.00000000317107685e-30f)));
    float _S209 = (F32_sqrt(((F32_max((0.5f * (1.0f - _S208)), (0.0f))))));
    float _S210 = (F32_sqrt((_S206)));
    float _S211 = _S207 * (F32_sqrt(((F32_max((0.5f * (1.0f + _S208)), (0.0f))))));
    float _S212;
    if(_S199 < 0.0f)
    {
        _S212 = - _S207 * _S209;
    }
    else
    {
        _S212 = _S207 * _S209;
    }
    return make_float3 (_S210, _S211, _S212);
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
    float _S213 = this_2->first_19.x;
    float _S214 = this_2->second_0.x;
    float _S215 = this_2->side_0 * this_2->side_0;
    float _S216 = this_2->first_19.y;
    float _S217 = this_2->second_0.y;
    float _S218 = 12.0f * (_S213 * _S216 + _S214 * _S217);
    return (F32_sqrt(((F32_sqrt(((F32_max(((12.0f * (_S213 * _S213 + _S214 * _S214) + _S215) * (12.0f * (_S216 * _S216 + _S217 * _S217) + _S215) - _S218 * _S218), (square_0(_S215))))))))));
}

__device__ float natural_logarithm_0(float x_24)
{
    uint _S219 = (F32_asuint((x_24)));
    float exponent_0 = float(int(_S219 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S219 & 8388607U) | 1056964608U)));
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
    float _S220 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S220 - exponent_1 * 0.00021219444170129f - 0.5f * _S220) + exponent_1 * 0.693359375f;
}

__device__ float3  footprint_coordinates_0(AnisotropicTaps_0 * taps_0)
{
    float _S221 = AnisotropicTaps_size_0(taps_0);
    return make_float3 ((taps_0->centre_1 - floor_0(taps_0->centre_1)).x, (taps_0->centre_1 - floor_0(taps_0->centre_1)).y, clamp_1(natural_logarithm_0((F32_max((_S221), (9.99999997475242708e-07f))) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S222 = float2 {direction_0.x, direction_0.y};
    float _S223;
    if(back_2)
    {
        _S223 = - direction_0.z;
    }
    else
    {
        _S223 = direction_0.z;
    }
    return make_float3 (_S222.x, _S222.y, _S223);
}

__device__ float table_number_0(uint index_0)
{
    uint _S224 = __ldg((&(globalParams_0->words_0)[index_0]));
    return (U32_asfloat((_S224)));
}

__device__ float wrapped_0(float index_1, float count_1)
{
    float _S225;
    if(index_1 < 0.0f)
    {
        _S225 = index_1 + count_1;
    }
    else
    {
        if(index_1 >= count_1)
        {
            _S225 = index_1 - count_1;
        }
        else
        {
            _S225 = index_1;
        }
    }
    return _S225;
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
    float _S226;
    if(number_0 >= 2U)
    {
        _S226 = 1.0f;
    }
    else
    {
        _S226 = -1.0f;
    }
    float _S227;
    if((number_0 & 1U) != 0U)
    {
        _S227 = 1.0f;
    }
    else
    {
        _S227 = -1.0f;
    }
    return this_4->centre_1 + make_float2 (_S226) * this_4->first_19 + make_float2 (_S227) * this_4->second_0;
}

__device__ float bump_0(float distance_0)
{
    float _S228 = (F32_max((1.0f - distance_0 * distance_0), (0.0f)));
    return _S228 * _S228;
}

__device__ float correction_weight_of_0(float coded_size_0)
{
    return clamp_1((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

__device__ float exponential_0(float x_26)
{
    float _S229 = clamp_1(x_26, -87.0f, 88.0f);
    float _S230 = (F32_floor((_S229 * 1.4426950216293335f + 0.5f)));
    float _S231 = _S229 - _S230 * 0.693359375f + _S230 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S231 + 0.00139819993637502f) * _S231 + 0.00833345204591751f) * _S231 + 0.04166579619050026f) * _S231 + 0.1666666567325592f) * _S231 + 0.5f;
    float _S232 = (U32_asfloat((uint(int(_S230) + int(127)) << int(23))));
    float _S233;
    if(x_26 < -87.0f)
    {
        _S233 = 0.0f;
    }
    else
    {
        _S233 = (p_0 * _S231 * _S231 + _S231 + 1.0f) * _S232;
    }
    return _S233;
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
    uint _S234 = bundle_0 / 3U;
    uint _S235 = bundle_0 % 3U;
    uint _S236;
    if(bundle_0 == 24U)
    {
        _S236 = bundle_0;
    }
    else
    {
        _S236 = _S234 * 3U + 3U - 1U - _S235;
    }
    return _S236;
}

__device__ float light_visibility_of_0(float diffuse_0, float3  light_0, float3  view_0, float blend_0)
{
    float _S237 = (F32_max(((F32_abs((light_0.z)))), (0.00100000004749745f)));
    float2  _S238 = float2 {light_0.x, light_0.y};
    return 3.14159274101257324f * (F32_max((diffuse_0), (0.0f))) / lerp_1(_S237, (0.59700000286102295f * _S237 + 0.16599999368190765f) * (0.21600000560283661f * (dot_1(_S238, float2 {view_0.x, view_0.y}) * (F32_rsqrt(((F32_max((dot_1(_S238, _S238)), (9.99999997475242708e-07f))))))) + 1.0f), blend_0);
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_2)
{
    float _S239 = __ldg(&(&(globalParams_0->families_0)[family_0])->inverse_count_0);
    float _S240 = __ldg(&(&(globalParams_0->families_0)[family_0])->half_inverse_count_0);
    float _S241 = (F32_floor(((F32_fma((index_2), (_S239), (_S240))))));
    float _S242 = - _S241;
    float _S243 = __ldg(&(&(globalParams_0->families_0)[family_0])->count_0);
    return make_float2 (_S241, (F32_fma((_S242), (_S243), (index_2))));
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
    float _S244 = __ldg(&(&(globalParams_0->families_0)[family_1])->inverse_size_0);
    float _S245 = (F32_floor((position_0 * _S244)));
    Cell_0 cell_0;
    float _S246 = - _S245;
    float _S247 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    float _S248 = (F32_fma((_S246), (_S247), (position_0)));
    (&cell_0)->below_0 = _S248;
    float _S249 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->above_0 = _S249 - _S248;
    float _S250 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->across_0 = _S248 - 0.5f * _S250;
    float _S251 = __ldg(&(&(globalParams_0->families_0)[family_1])->half_width_0);
    (&cell_0)->half_width_1 = _S251;
    float _S252 = turns_and_remainder_0(family_1, _S245).y;
    float _S253 = __ldg(&(&(globalParams_0->families_0)[family_1])->count_0);
    (&cell_0)->thread_0 = uint(clamp_1(_S252, 0.0f, _S253 - 1.0f));
    return cell_0;
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float _S254 = __ldg(&(&(globalParams_0->families_0)[family_2])->start_0);
    float _S255 = position_1 - _S254;
    float _S256 = __ldg(&(&(globalParams_0->families_0)[family_2])->inverse_period_0);
    float turns_0 = _S255 * _S256;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    float _S257 = __ldg(&(&(globalParams_0->families_0)[family_2])->period_0);
    float _S258 = turns_1 * _S257;
    float _S259 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    float _S260 = turns_1 * _S259;
    float _S261 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    uint _S262 = uint(clamp_1(_S260, 0.0f, _S261 - 1.0f));
    uint _S263 = __ldg(&(&(globalParams_0->families_0)[family_2])->first_thread_table_0);
    uint _S264 = __ldg((&(globalParams_0->words_0)[_S263 + _S262]));
    uint _S265 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S266;
    if(_S258 >= (table_number_0(_S265 + _S264 * 4U + 1U)))
    {
        _S266 = 1U;
    }
    else
    {
        _S266 = 0U;
    }
    uint _S267 = _S264 + _S266;
    float _S268 = __ldg(&(&(globalParams_0->families_0)[family_2])->count_0);
    uint _S269 = (U32_min((_S267), (uint(_S268) - 1U)));
    uint _S270 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S271 = _S270 + _S269 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S269;
    (&cell_1)->below_0 = _S258 - table_number_0(_S271);
    (&cell_1)->above_0 = table_number_0(_S271 + 1U) - _S258;
    (&cell_1)->across_0 = _S258 - table_number_0(_S271 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S271 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    uint _S272 = __ldg(&(&(globalParams_0->families_0)[family_3])->is_alike_0);
    if(_S272 != 0U)
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
    Cell_0 _S273 = locate_0(family_4, position_3);
    uint _S274 = __ldg(&(&(globalParams_0->families_0)[family_4])->before_0);
    float _S275 = table_number_0(_S274 + 2U * _S273.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_1 = _S273.thread_0;
    float _S276 = __ldg(&(&(globalParams_0->families_0)[family_4])->start_0);
    float _S277 = position_3 - _S276 - _S275 - _S273.below_0;
    float _S278 = __ldg(&(&(globalParams_0->families_0)[family_4])->inverse_period_0);
    (&bound_0)->turns_2 = (F32_round((_S277 * _S278)));
    (&bound_0)->cell_2 = _S273.below_0;
    float _S279 = 2.0f * _S273.half_width_1;
    (&bound_0)->width_2 = _S279;
    (&bound_0)->visible_0 = clamp_1((_S273.across_0 + _S273.half_width_1) / _S279, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S273.below_0), (_S273.below_0 - _S273.across_0 - _S273.half_width_1))) + (F32_max((_S273.across_0 - _S273.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

__device__ Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    float _S280 = __ldg(&(&(globalParams_0->families_0)[family_5])->start_0);
    float _S281 = centre_2 - _S280;
    float _S282 = __ldg(&(&(globalParams_0->families_0)[family_5])->inverse_period_0);
    float _S283 = (F32_floor((_S281 * _S282)));
    float _S284 = __ldg(&(&(globalParams_0->families_0)[family_5])->period_0);
    float _S285 = centre_2 - _S283 * _S284;
    float _S286 = __ldg(&(&(globalParams_0->families_0)[family_5])->smallest_box_0);
    float _S287 = 0.5f * (F32_max((size_1), (_S286)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_7 = bound_at_0(family_5, _S285 - _S287);
    (&stretch_0)->high_7 = bound_at_0(family_5, _S285 + _S287);
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
    float _S288 = Stretch_turns_0(stretch_1);
    uint _S289 = __ldg(&(&(globalParams_0->families_0)[family_6])->before_0);
    uint _S290 = _S289 + 2U * (&stretch_1->low_7)->thread_1;
    uint _S291 = __ldg(&(&(globalParams_0->families_0)[family_6])->before_0);
    uint _S292 = _S291 + 2U * (&stretch_1->high_7)->thread_1;
    float _S293 = table_number_0(_S292) - table_number_0(_S290);
    float _S294 = table_number_0(_S292 + 1U) - table_number_0(_S290 + 1U);
    float _S295 = _S293 + (&stretch_1->high_7)->visible_0 * (&stretch_1->high_7)->width_2 - (&stretch_1->low_7)->visible_0 * (&stretch_1->low_7)->width_2;
    float _S296 = __ldg(&(&(globalParams_0->families_0)[family_6])->visible_total_0);
    float _S297 = _S295 + _S288 * _S296;
    float _S298 = _S294 - _S293 + (&stretch_1->high_7)->gap_0 - (&stretch_1->low_7)->gap_0;
    float _S299 = __ldg(&(&(globalParams_0->families_0)[family_6])->period_0);
    float _S300 = __ldg(&(&(globalParams_0->families_0)[family_6])->visible_total_0);
    float _S301 = _S298 + _S288 * (_S299 - _S300);
    float _S302 = _S294 + (&stretch_1->high_7)->cell_2 - (&stretch_1->low_7)->cell_2;
    float _S303 = __ldg(&(&(globalParams_0->families_0)[family_6])->period_0);
    return make_float3 (_S297, _S301, _S302 + _S288 * _S303);
}

__device__ float2  integrals_along_0(uint family_7, Stretch_0 * stretch_2, uint quantity_0)
{
    uint _S304 = __ldg(&(&(globalParams_0->families_0)[family_7])->quantities_0);
    uint _S305 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    uint _S306 = 3U * _S304;
    uint _S307 = _S305 + _S306 * (&stretch_2->low_7)->thread_1 + quantity_0;
    uint _S308 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    uint _S309 = _S308 + _S306 * (&stretch_2->high_7)->thread_1 + quantity_0;
    uint _S310 = __ldg(&(&(globalParams_0->families_0)[family_7])->colour_threads_0);
    float _S311 = __ldg(&(&(globalParams_0->families_0)[family_7])->count_0);
    uint _S312 = _S310 + _S306 * uint(_S311) + quantity_0;
    float _S313 = table_number_0(_S307);
    float _S314 = table_number_0(_S309);
    float _S315 = Stretch_turns_0(stretch_2);
    uint _S316 = 2U * _S304;
    return make_float2 (table_number_0(_S309 + _S304) - table_number_0(_S307 + _S304) + _S314 * (&stretch_2->high_7)->visible_0 * (&stretch_2->high_7)->width_2 - _S313 * (&stretch_2->low_7)->visible_0 * (&stretch_2->low_7)->width_2 + _S315 * table_number_0(_S312 + _S304), table_number_0(_S309 + _S316) - table_number_0(_S307 + _S316) + _S314 * (&stretch_2->high_7)->cell_2 - _S313 * (&stretch_2->low_7)->cell_2 + _S315 * table_number_0(_S312 + _S316));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_6)
{
    return ((&this_6->high_7)->thread_1) < ((&this_6->low_7)->thread_1);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_7, uint4  entries_0, uint whole_0)
{
    uint _S317 = entries_0.z;
    uint _S318 = entries_0.x;
    uint _S319 = _S317 - _S318;
    bool _S320 = Stretch_wraps_0(this_7);
    uint _S321;
    if(_S320)
    {
        _S321 = whole_0;
    }
    else
    {
        _S321 = 0U;
    }
    return make_uint4 (_S319 + _S321, entries_0.w - _S317, entries_0.y - _S318, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S322 = row_7 + (&across_1->low_7)->thread_1 * quantities_1;
    uint _S323 = row_7 + (&across_1->high_7)->thread_1 * quantities_1;
    uint _S324 = __ldg((&(globalParams_0->words_0)[_S322]));
    uint _S325 = __ldg((&(globalParams_0->words_0)[_S322 + quantities_1]));
    uint _S326 = __ldg((&(globalParams_0->words_0)[_S323]));
    uint _S327 = __ldg((&(globalParams_0->words_0)[_S323 + quantities_1]));
    uint4  _S328 = make_uint4 (_S324, _S325, _S326, _S327);
    uint _S329 = __ldg((&(globalParams_0->words_0)[row_7 + count_2 * quantities_1]));
    uint4  _S330 = Stretch_differences_0(across_1, _S328, _S329);
    return _S330;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_8)
{
    float _S331 = (&this_8->high_7)->visible_0;
    float _S332 = - (&this_8->low_7)->visible_0;
    float _S333 = Stretch_turns_0(this_8);
    bool _S334 = Stretch_wraps_0(this_8);
    float _S335;
    if(_S334)
    {
        _S335 = 1.0f;
    }
    else
    {
        _S335 = 0.0f;
    }
    return make_float4 (1.0f, _S331, _S332, _S333 - _S335);
}

__device__ float integral_on_top_0(uint family_8, Stretch_0 * across_2, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    float _S336 = __ldg(&(&(globalParams_0->families_0)[family_8])->count_0);
    uint _S337 = uint(_S336);
    uint _S338 = _S337 + 1U;
    uint _S339 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint _S340 = _S338 * _S339;
    uint _S341 = __ldg(&(&(globalParams_0->families_0)[family_8])->colour_areas_0);
    uint _S342 = _S341 + quantity_1;
    uint _S343 = (&along_0->low_7)->thread_1;
    uint _S344 = _S342 + (&along_0->low_7)->thread_1 * _S340;
    uint _S345 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S346 = row_differences_0(across_2, _S344, _S337, _S345);
    uint _S347 = _S342 + (_S343 + 1U) * _S340;
    uint _S348 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S349 = row_differences_0(across_2, _S347, _S337, _S348);
    uint _S350 = (&along_0->high_7)->thread_1;
    uint _S351 = _S342 + (&along_0->high_7)->thread_1 * _S340;
    uint _S352 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S353 = row_differences_0(across_2, _S351, _S337, _S352);
    uint _S354 = _S342 + (_S350 + 1U) * _S340;
    uint _S355 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S356 = row_differences_0(across_2, _S354, _S337, _S355);
    uint _S357 = _S342 + crossing_count_0 * _S340;
    uint _S358 = __ldg(&(&(globalParams_0->families_0)[family_8])->quantities_0);
    uint4  _S359 = row_differences_0(across_2, _S357, _S337, _S358);
    uint4  _S360 = _S353 - _S346;
    bool _S361 = Stretch_wraps_0(along_0);
    uint4  _S362;
    if(_S361)
    {
        _S362 = _S359;
    }
    else
    {
        int4  _S363 = make_int4 (int(0));
        uint4  _S364 = make_uint4 ((uint)_S363.x, (uint)_S363.y, (uint)_S363.z, (uint)_S363.w);
        _S362 = _S364;
    }
    uint4  _S365 = _S360 + _S362;
    float4  _S366 = Stretch_weights_0(across_2);
    float4  _S367 = Stretch_weights_0(along_0);
    int4  _S368 = make_int4 ((int)_S365.x, (int)_S365.y, (int)_S365.z, (int)_S365.w);
    float4  _S369 = make_float4 ((float)_S368.x, (float)_S368.y, (float)_S368.z, (float)_S368.w);
    uint4  _S370 = _S356 - _S353;
    int4  _S371 = make_int4 ((int)_S370.x, (int)_S370.y, (int)_S370.z, (int)_S370.w);
    float4  _S372 = make_float4 ((float)_S371.x, (float)_S371.y, (float)_S371.z, (float)_S371.w);
    uint4  _S373 = _S349 - _S346;
    int4  _S374 = make_int4 ((int)_S373.x, (int)_S373.y, (int)_S373.z, (int)_S373.w);
    float4  _S375 = make_float4 ((float)_S374.x, (float)_S374.y, (float)_S374.z, (float)_S374.w);
    int4  _S376 = make_int4 ((int)_S359.x, (int)_S359.y, (int)_S359.z, (int)_S359.w);
    float4  _S377 = make_float4 ((float)_S376.x, (float)_S376.y, (float)_S376.z, (float)_S376.w);
    float _S378 = dot_0(make_float4 (dot_0(_S369, _S366), dot_0(_S372, _S366), dot_0(_S375, _S366), dot_0(_S377, _S366)), _S367);
    float _S379 = __ldg(&(&(globalParams_0->families_0)[family_8])->area_unit_0);
    return _S378 * _S379;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S380 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_0) * _S380.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_0) * _S380.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_0) * _S380.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_0) * _S380.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 * own_0, Stretch_0 * other_0, bool back_3)
{
    uint _S381 = __ldg(&(&(globalParams_0->families_0)[family_9])->colour_mean_0);
    Albedos_0 albedos_2 = table_albedos_0(_S381);
    uint _S382 = __ldg(&(&(globalParams_0->families_0)[family_9])->quantities_0);
    if(_S382 == 1U)
    {
        return albedos_2;
    }
    float3  _S383 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        uint _S384 = __ldg(&(&(globalParams_0->families_0)[family_9])->quantities_0);
        if(quantity_2 < _S384)
        {
        }
        else
        {
            break;
        }
        float2  _S385 = integrals_along_0(family_9, own_0, quantity_2);
        float _S386 = __ldg(&(&(globalParams_0->families_0)[crossing_0])->count_0);
        float _S387 = integral_on_top_0(family_9, own_0, other_0, uint(_S386), quantity_2);
        float _S388 = _S385.x;
        float _S389 = _S388 * _S383.x;
        float _S390;
        if(back_3)
        {
            _S390 = _S389 - _S387;
        }
        else
        {
            _S390 = _S387;
        }
        bool _S391 = quantity_2 == 0U;
        if(_S391)
        {
            float _S392 = __ldg(&(&(globalParams_0->families_0)[family_9])->area_unit_0);
            float _S393 = 16.0f * _S392;
            float _S394 = __ldg(&(&(globalParams_0->families_0)[family_9])->crossing_area_0);
            is_exposed_0 = _S390 > (_S393 * (F32_min((_S389 / _S394), (1.0f))) + 0.00000999999974738f * _S389);
        }
        float _S395 = _S388 * _S383.y;
        float _S396;
        if(is_exposed_0)
        {
            _S396 = _S390;
        }
        else
        {
            _S396 = 0.0f;
        }
        float _S397 = _S395 + _S396 + 0.000244140625f * _S383.z * _S385.y;
        if(_S391)
        {
            weight_1 = 1.0f / (F32_max((_S397), (9.99999968265522539e-21f)));
        }
        else
        {
            Albedos_0 _S398 = albedos_2;
            float _S399 = _S397 * weight_1;
            uint _S400 = __ldg(&(&(globalParams_0->families_0)[family_9])->colour_axes_0);
            uint _S401 = _S400 + 12U * (quantity_2 - 1U);
            Albedos_0 _S402 = _S398;
            Albedos_0 _S403 = with_added_albedos_0(&_S402, _S399, _S401);
            albedos_2 = _S403;
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
    Blocked_0 _S404 = no_blocked_0();
    (&nothing_1)->warp_1 = _S404;
    (&nothing_1)->weft_1 = _S404;
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
    float3  _S405 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S406 = sends_0->sky_warp_0 + _S405 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S406;
    float3  _S407 = sends_0->sky_weft_0 + _S405 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S407;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S406 + make_float3 (sends_0->blocks_weft_0) * _S407;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

__device__ void view_terms_0(float3  view_1, FixedArray<float, 6>  * terms_0)
{
    float _S408 = 1.0f - view_1.z;
    float _S409 = _S408 * _S408;
    (*terms_0)[int(0)] = 1.0f;
    float _S410 = view_1.x;
    float _S411 = _S410 * _S410;
    float _S412 = view_1.y;
    float _S413 = _S412 * _S412;
    (*terms_0)[int(1)] = (F32_sqrt(((F32_max((_S411 + _S413), (9.999999960041972e-13f))))));
    (*terms_0)[int(2)] = _S409;
    (*terms_0)[int(3)] = _S409 * _S409;
    (*terms_0)[int(4)] = _S411 - _S413;
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
    float3  _S414 = make_float3 (blocked_1->by_warp_0 + blocked_1->by_weft_0) * interior_0->leaked_1;
    float3  _S415 = make_float3 (blocked_1->far_0) * yarn_0->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_0->back_4 * (make_float3 (blocked_1->by_warp_0) * interior_0->warp_3 + make_float3 (blocked_1->by_weft_0) * interior_0->weft_3) + _S415 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S415 * interior_0->far_1 + yarn_0->back_4 * _S414;
    return bounced_0;
}

__device__ Bounced_0 sum_of_0(Bounced_0 * first_20, Bounced_0 * second_1)
{
    Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_20->reflected_0 + second_1->reflected_0;
    (&sum_1)->transmitted_0 = first_20->transmitted_0 + second_1->transmitted_0;
    return sum_1;
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_1, float3  view_2)
{
    float _S416 = light_1.z;
    float3  _S417;
    if((_S416 * view_2.z) < 0.0f)
    {
        _S417 = bounced_1->transmitted_0;
    }
    else
    {
        _S417 = bounced_1->reflected_0;
    }
    return _S417 * make_float3 ((F32_abs((_S416))) * 0.31830987334251404f);
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
    float _S418 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S419 = 2.0f * (F32_sqrt((_S418))) - 1.0f;
    float _S420 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_1, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S419, _S420), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S418) * sheen_shear_0(_S419, _S420), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S419, _S420), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_2, float3  view_3, float scale_1, float shear_0)
{
    float _S421 = light_2.z;
    bool _S422;
    if(_S421 <= 0.0f)
    {
        _S422 = true;
    }
    else
    {
        _S422 = (view_3.z) <= 0.0f;
    }
    if(_S422)
    {
        return 0.0f;
    }
    float2  _S423 = float2 {view_3.x, view_3.y};
    float _S424 = dot_1(_S423, _S423);
    float2  _S425;
    if(_S424 > 9.99999968265522539e-21f)
    {
        _S425 = _S423 * make_float2 ((F32_rsqrt((_S424))));
    }
    else
    {
        _S425 = make_float2 (1.0f, 0.0f);
    }
    float _S426 = scale_1 * dot_1(float2 {light_2.x, light_2.y}, _S425) + shear_0 * _S421;
    float _S427 = scale_1 * (light_2.y * _S425.x - light_2.x * _S425.y);
    float _S428 = _S426 * _S426 + _S427 * _S427 + _S421 * _S421;
    return 0.31830987334251404f * scale_1 * scale_1 * _S421 / (F32_max((_S428 * _S428), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_3, float3  view_4, float strength_0, float roughness_2)
{
    float3  _S429 = sheen_lobe_0(view_4.z, roughness_2);
    float _S430 = strength_0 * _S429.z;
    return make_float2 (_S430 * transformed_cosine_0(light_3, view_4, _S429.x, _S429.y), 1.0f - _S430);
}

struct WovenView_0
{
    FixedArray<float, 96>  sums_6;
    float hole_0;
    float correction_weight_0;
    float3  view_5;
    bool back_5;
};

__device__ AnisotropicTaps_0 anisotropic_taps_0(uint _S431, Footprint_0 * _S432)
{
    Fabric_0 * _S433 = (&(globalParams_0->fabrics_0)[_S431]);
    float3  _S434 = row_of_taps_0(_S432);
    float2  _S435 = _S432->dx_0;
    float2  _S436 = _S432->dy_0;
    float _S437 = dot_1(_S432->dx_0, _S432->dx_0) + dot_1(_S432->dy_0, _S432->dy_0);
    float _S438 = _S432->dx_0.x * _S432->dy_0.y - _S432->dx_0.y * _S432->dy_0.x;
    float _S439 = 0.5f * (_S437 + (F32_sqrt(((F32_max((_S437 * _S437 - 4.0f * _S438 * _S438), (0.0f)))))));
    Woven_0 _S440 = slang_ldg_1(&_S433->woven_0);
    bool _S441;
    if(_S439 < (5.5f * (_S437 - _S439)))
    {
        _S441 = _S437 > (8.0f * _S440.pitch_0 * _S440.pitch_0);
    }
    else
    {
        _S441 = false;
    }
    float2  _S442 = make_float2 (_S440.ends_per_mm_0, _S440.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    (&taps_1)->centre_1 = _S432->centre_0 * _S442;
    float _S443;
    if(_S441)
    {
        _S443 = (F32_sqrt((0.125f * _S437)));
    }
    else
    {
        _S443 = _S434.x;
    }
    (&taps_1)->side_0 = _S443 / _S440.pitch_0;
    float2  _S444;
    if(_S441)
    {
        _S444 = make_float2 (0.25f) * _S435;
    }
    else
    {
        _S444 = float2 {_S434.y, _S434.z};
    }
    (&taps_1)->first_19 = _S444 * _S442;
    if(_S441)
    {
        _S444 = make_float2 (0.25f) * _S436;
    }
    else
    {
        _S444 = make_float2 (0.5f) * float2 {_S434.y, _S434.z};
    }
    (&taps_1)->second_0 = _S444 * _S442;
    return taps_1;
}

__device__ void add_texel_0(uint _S445, uint _S446, float _S447, FixedArray<float, 88>  * _S448)
{
    Woven_0 _S449 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S445])->woven_0);
    uint _S450 = _S449.latents_0 + _S446 * 8U;
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
        uint4  _S451 = __ldg((&(globalParams_0->packed_numbers_0)[_S450 + part_0]));
        Eight_0 _S452 = eight_halves_0(_S451);
        int _S453 = int(8U * part_0);
        (*_S448)[_S453] = (*_S448)[_S453] + _S447 * _S452.low_0.x;
        (*_S448)[_S453 + int(4)] = (*_S448)[_S453 + int(4)] + _S447 * _S452.high_0.x;
        int _S454 = _S453 + int(1);
        (*_S448)[_S454] = (*_S448)[_S454] + _S447 * _S452.low_0.y;
        (*_S448)[_S454 + int(4)] = (*_S448)[_S454 + int(4)] + _S447 * _S452.high_0.y;
        int _S455 = _S453 + int(2);
        (*_S448)[_S455] = (*_S448)[_S455] + _S447 * _S452.low_0.z;
        (*_S448)[_S455 + int(4)] = (*_S448)[_S455 + int(4)] + _S447 * _S452.high_0.z;
        int _S456 = _S453 + int(3);
        (*_S448)[_S456] = (*_S448)[_S456] + _S447 * _S452.low_0.w;
        (*_S448)[_S456 + int(4)] = (*_S448)[_S456 + int(4)] + _S447 * _S452.high_0.w;
        part_0 = part_0 + 1U;
    }
    return;
}

__device__ void add_level_0(uint _S457, uint _S458, bool _S459, float2  _S460, float _S461, FixedArray<float, 88>  * _S462)
{
    Woven_0 _S463 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S457])->woven_0);
    uint _S464 = _S463.levels_1 + 4U * _S458;
    float _S465 = table_number_0(_S464);
    float _S466 = table_number_0(_S464 + 1U);
    float _S467 = table_number_0(_S464 + 2U);
    bool _S468;
    if(_S458 > 3U)
    {
        _S468 = _S458 < (_S463.top_level_0);
    }
    else
    {
        _S468 = false;
    }
    float2  _S469 = _S460 * make_float2 (table_number_0(_S464 + 3U));
    float _S470;
    if(_S468)
    {
        _S470 = 1.0f;
    }
    else
    {
        _S470 = 0.5f;
    }
    float2  _S471 = _S469 - make_float2 (_S470);
    float2  _S472 = floor_0(_S471);
    float2  _S473 = _S471 - _S472;
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
        float _S474 = float(corner_0 & 1U);
        float _S475 = float(corner_0 >> int(1));
        float2  _S476 = lerp_2(make_float2 (1.0f) - _S473, _S473, make_float2 (_S474, _S475));
        uint _S477 = uint(_S465 + wrapped_0(_S472.y + _S475, _S467) * _S466 + wrapped_0(_S472.x + _S474, _S466));
        uint _S478;
        if(_S459)
        {
            _S478 = _S463.texels_0;
        }
        else
        {
            _S478 = 0U;
        }
        add_texel_0(_S457, _S477 + _S478, _S461 * _S476.x * _S476.y, _S462);
        corner_0 = corner_0 + 1U;
    }
    return;
}

__device__ void code_footprint_0(uint _S479, AnisotropicTaps_0 * _S480, float3  _S481, bool _S482, FixedArray<float, 88>  * _S483)
{
    float offset_1;
    Fabric_0 * _S484 = (&(globalParams_0->fabrics_0)[_S479]);
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
        (*_S483)[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    Woven_0 _S485 = slang_ldg_1(&_S484->woven_0);
    float2  _S486 = make_float2 (_S485.ends_0, _S485.picks_0);
    float _S487 = float(_S485.top_level_0);
    float _S488 = clamp_1(binary_logarithm_0((F32_max((_S480->side_0), (9.99999997475242708e-07f)))) + 3.0f, 0.0f, _S487);
    float _S489 = (F32_min(((F32_floor((_S488)))), (_S487 - 1.0f)));
    bool _S490 = AnisotropicTaps_has_steps_0(_S480);
    uint _S491;
    if(_S490)
    {
        _S491 = 4U;
    }
    else
    {
        _S491 = 1U;
    }
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < (2U * _S491))
        {
        }
        else
        {
            break;
        }
        float2  _S492 = AnisotropicTaps_place_0(_S480, number_1 >> int(1));
        float2  _S493 = clamp_2(_S492 - _S486 * floor_0(_S492 / _S486), make_float2 (0.0f), _S486);
        bool _S494 = (number_1 & 1U) != 0U;
        if(_S494)
        {
            offset_1 = _S488 - _S489;
        }
        else
        {
            offset_1 = 1.0f - (_S488 - _S489);
        }
        float _S495 = offset_1 / float(_S491);
        uint _S496 = uint(_S489);
        uint _S497;
        if(_S494)
        {
            _S497 = 1U;
        }
        else
        {
            _S497 = 0U;
        }
        add_level_0(_S479, _S496 + _S497, _S482, _S493, _S495, _S483);
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
            float offset_2 = _slang_vector_get_element(_S481, number_2) - (float(bin_0) + 0.5f) / 8.0f;
            if(number_2 < int(2))
            {
                offset_1 = offset_2 - (F32_round((offset_2)));
            }
            else
            {
                offset_1 = offset_2;
            }
            (*_S483)[int(64) + number_2 * int(8) + bin_0] = bump_0(offset_1 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_2 = number_2 + int(1);
    }
    return;
}

__device__ float3  crown_fibres_0(uint _S498, bool _S499, bool _S500)
{
    Fabric_0 * _S501 = (&(globalParams_0->fabrics_0)[_S498]);
    float _S502;
    if(_S499)
    {
        if(_S500)
        {
            Woven_0 _S503 = slang_ldg_1(&_S501->woven_0);
            _S502 = - _S503.warp_x_0;
        }
        else
        {
            Woven_0 _S504 = slang_ldg_1(&_S501->woven_0);
            _S502 = _S504.warp_x_0;
        }
        Woven_0 _S505 = slang_ldg_1(&_S501->woven_0);
        return make_float3 (_S502, _S505.warp_y_0, _S505.warp_roughness_0);
    }
    Woven_0 _S506 = slang_ldg_1(&_S501->woven_0);
    if(_S500)
    {
        _S502 = - _S506.weft_y_0;
    }
    else
    {
        _S502 = _S506.weft_y_0;
    }
    return make_float3 (_S506.weft_x_0, _S502, _S506.weft_roughness_0);
}

__device__ void woven_view_0(uint _S507, Footprint_0 * _S508, float3  _S509, WovenView_0 * _S510)
{
    Fabric_0 * _S511 = (&(globalParams_0->fabrics_0)[_S507]);
    bool _S512 = (_S509.z) < 0.0f;
    AnisotropicTaps_0 _S513 = anisotropic_taps_0(_S507, _S508);
    AnisotropicTaps_0 _S514 = _S513;
    float3  _S515 = footprint_coordinates_0(&_S514);
    float3  _S516 = to_face_frame_0(_S509, _S512);
    HalfWeights_0 weights_23;
    Woven_0 _S517 = slang_ldg_1(&_S511->woven_0);
    (&weights_23)->first_2 = _S517.network_0;
    AnisotropicTaps_0 _S518 = _S513;
    FixedArray<float, 88>  inputs_23;
    code_footprint_0(_S507, &_S518, _S515, _S512, &inputs_23);
    HalfWeights_0 _S519 = weights_23;
    FixedArray<float, 96>  hidden_1;
    dense_7(&_S519, 0U, false, &inputs_23, &hidden_1);
    HalfWeights_0 _S520 = weights_23;
    FixedArray<float, 100>  fused_0;
    dense_part_8(&_S520, 1068U, false, &hidden_1, &fused_0);
    fused_0[int(96)] = _S516.x;
    fused_0[int(97)] = _S516.y;
    float3  _S521 = crown_fibres_0(_S507, true, _S512);
    float2  _S522 = float2 {_S516.x, _S516.y};
    fused_0[int(98)] = dot_1(float2 {_S521.x, _S521.y}, _S522);
    float3  _S523 = crown_fibres_0(_S507, false, _S512);
    fused_0[int(99)] = dot_1(float2 {_S523.x, _S523.y}, _S522);
    HalfWeights_0 _S524 = weights_23;
    FixedArray<float, 16>  of_hole_0;
    dense_6(&_S524, 2232U, false, &fused_0, &of_hole_0);
    HalfWeights_0 _S525 = weights_23;
    FixedArray<float, 1>  hole_1;
    dense_5(&_S525, 2444U, false, &of_hole_0, &hole_1);
    HalfWeights_0 _S526 = weights_23;
    dense_4(&_S526, 2456U, false, &fused_0, &_S510->sums_6);
    _S510->hole_0 = clamp_1(hole_1[int(0)], 0.0f, 1.0f);
    _S510->correction_weight_0 = correction_weight_of_0(_S515.z);
    _S510->view_5 = _S516;
    _S510->back_5 = _S512;
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

__device__ void code_light_0(uint _S527, float3  _S528, float3  _S529, bool _S530, FixedArray<float, 39>  * _S531)
{
    (*_S531)[int(0)] = _S528.x;
    (*_S531)[int(1)] = _S528.y;
    (*_S531)[int(2)] = _S528.z;
    float3  _S532 = _S528 + _S529;
    float _S533 = _S532.z;
    float _S534 = _S533 * _S533 + 0.00009999999747379f;
    float2  _S535 = float2 {_S532.x, _S532.y};
    float _S536 = 1.0f / (dot_1(_S535, _S535) + _S534);
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
        float3  _S537 = crown_fibres_0(_S527, family_10 == int(0), _S530);
        float2  _S538 = float2 {_S537.x, _S537.y};
        (*_S531)[int(3) + family_10] = dot_1(_S538, float2 {_S528.x, _S528.y});
        float _S539 = dot_1(_S538, _S535);
        float _S540 = _S539 * _S539;
        float _S541 = (0.75f * _S539 / (0.5f * (F32_sqrt((_S540 + _S534))) + (F32_abs((_S539)))) + 0.5f) * 8.0f;
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
            (*_S531)[int(5) + family_10 * int(16) + bin_1] = bump_0(_S541 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S542 = _S537.z;
        float _S543 = _S542 * _S542;
        float _S544 = _S540 * _S536 * (1.0f - _S543) + _S543;
        (*_S531)[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S543 * _S542 / (_S544 * _S544));
        family_10 = family_10 + int(1);
    }
    return;
}

__device__ float mixed_bundles_0(uint _S545, uint _S546, uint _S547, float3  _S548, float3  _S549, bool _S550, FixedArray<float, 52>  * _S551)
{
    Fabric_0 * _S552 = (&(globalParams_0->fabrics_0)[_S545]);
    float3  _S553 = _S548 + _S549;
    float _S554 = 1.0f / (square_1(_S553) + 0.00009999999747379f);
    bool _S555;
    if(_S546 == 0U)
    {
        _S555 = _S550;
    }
    else
    {
        _S555 = false;
    }
    float _S556;
    if(_S555)
    {
        _S556 = - _S553.x;
    }
    else
    {
        _S556 = _S553.x;
    }
    if(_S546 == 1U)
    {
        _S555 = _S550;
    }
    else
    {
        _S555 = false;
    }
    float _S557;
    if(_S555)
    {
        _S557 = - _S553.y;
    }
    else
    {
        _S557 = _S553.y;
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
        Woven_0 _S558 = slang_ldg_1(&_S552->woven_0);
        uint _S559 = _S546 * 25U;
        uint _S560 = _S558.bundles_0 + 4U * (_S559 + bundle_1);
        float _S561 = dot_2(make_float3 (table_number_0(_S560), table_number_0(_S560 + 1U), table_number_0(_S560 + 2U)), make_float3 (_S556, _S557, _S553.z));
        float _S562 = _S561 * _S561 * _S554 + table_number_0(_S560 + 3U);
        uint _S563 = _S547 + _S559;
        uint _S564;
        if(_S550)
        {
            _S564 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S564 = bundle_1;
        }
        float sum_3 = sum_2 + (F32_max(((*_S551)[_S563 + _S564]), ((*_S551)[_S563 + _S564] * 0.00999999977648258f))) / (_S562 * _S562);
        bundle_1 = bundle_1 + 1U;
        sum_2 = sum_3;
    }
    return 0.01999999955296516f * sum_2;
}

__device__ Components_0 woven_components_0(uint _S565, WovenView_0 * _S566, float3  _S567)
{
    float _S568;
    Fabric_0 * _S569 = (&(globalParams_0->fabrics_0)[_S565]);
    bool _S570 = _S566->back_5;
    float3  _S571 = to_face_frame_0(_S567, _S566->back_5);
    float3  _S572 = _S566->view_5;
    HalfWeights_0 weights_24;
    Woven_0 _S573 = slang_ldg_1(&_S569->woven_0);
    (&weights_24)->first_2 = _S573.network_0;
    FixedArray<float, 39>  directions_0;
    code_light_0(_S565, _S571, _S572, _S570, &directions_0);
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
        skip_0[k_1] = _S566->sums_6[k_1];
        k_1 = k_1 + int(1);
    }
    HalfWeights_0 _S574 = weights_24;
    dense_3(&_S574, 3716U, true, &directions_0, &skip_0);
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
                _S568 = skip_0[k_1];
            }
            else
            {
                _S568 = 0.0f;
            }
            next_0[k_1] = _S568;
            k_1 = k_1 + int(1);
        }
        uint _S575 = 4208U + layer_0 * 1164U;
        HalfWeights_0 _S576 = weights_24;
        dense_2(&_S576, _S575, true, &hidden_2, &next_0);
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
    HalfWeights_0 _S577 = weights_24;
    FixedArray<float, 52>  outputs_17;
    dense_1(&_S577, 7700U, false, &hidden_2, &outputs_17);
    bool _S578;
    if((_S573.is_corrected_0) != 0U)
    {
        _S578 = (_S571.z) > 0.0f;
    }
    else
    {
        _S578 = false;
    }
    if(_S578)
    {
        _S578 = (_S566->correction_weight_0) > 0.0f;
    }
    else
    {
        _S578 = false;
    }
    if(_S578)
    {
        FloatWeights_0 fitted_0;
        (&fitted_0)->first_0 = _S573.correction_0;
        FloatWeights_0 _S579 = fitted_0;
        FixedArray<float, 50>  change_0;
        dense_0(&_S579, 0U, false, &hidden_2, &change_0);
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
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S566->correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S571.z) > 0.0f)
    {
        _S568 = 0.00999999977648258f;
    }
    else
    {
        _S568 = 0.00100000004749745f;
    }
    Components_0 result_16;
    float _S580 = unmapped_0(outputs_17[int(0)], _S568);
    (&result_16)->diffuse_warp_0 = _S580;
    float _S581 = unmapped_0(outputs_17[int(1)], _S568);
    (&result_16)->diffuse_weft_0 = _S581;
    float _S582 = 2979.9580078125f * _S568;
    float _S583 = mixed_bundles_0(_S565, 0U, 2U, _S571, _S572, _S570, &outputs_17);
    (&result_16)->specular_warp_0 = clamp_1(_S583, 0.0f, _S582);
    float _S584 = mixed_bundles_0(_S565, 1U, 2U, _S571, _S572, _S570, &outputs_17);
    (&result_16)->specular_weft_0 = clamp_1(_S584, 0.0f, _S582);
    float _S585 = _S566->hole_0;
    (&result_16)->hole_2 = _S566->hole_0;
    float _S586 = _S580 + _S581;
    float _S587 = __ldg(&_S569->diffuse_blend_0);
    (&result_16)->light_visibility_1 = (F32_min((light_visibility_of_0(_S586, _S571, _S572, _S587)), (1.0f - _S585)));
    return result_16;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_4;
    Albedos_0 weft_4;
};

__device__ FamilyAlbedos_0 albedos_over_0(uint _S588, Footprint_0 * _S589, bool _S590)
{
    Fabric_0 * _S591 = (&(globalParams_0->fabrics_0)[_S588]);
    float2  _S592 = sqrt_0(_S589->dx_0 * _S589->dx_0 + _S589->dy_0 * _S589->dy_0);
    uint _S593 = __ldg(&_S591->warp_0);
    float2  _S594 = _S589->centre_0;
    Stretch_0 _S595 = stretch_of_0(_S593, _S589->centre_0.x, _S592.x);
    uint _S596 = __ldg(&_S591->weft_0);
    Stretch_0 _S597 = stretch_of_0(_S596, _S594.y, _S592.y);
    FamilyAlbedos_0 albedos_4;
    Stretch_0 _S598 = _S595;
    Stretch_0 _S599 = _S597;
    Albedos_0 _S600 = mean_albedos_0(_S593, _S596, &_S598, &_S599, _S590);
    (&albedos_4)->warp_4 = _S600;
    Stretch_0 _S601 = _S597;
    Stretch_0 _S602 = _S595;
    Albedos_0 _S603 = mean_albedos_0(_S596, _S593, &_S601, &_S602, _S590);
    (&albedos_4)->weft_4 = _S603;
    return albedos_4;
}

__device__ float openness_number_0(uint _S604, uint _S605)
{
    uint _S606 = __ldg(&(&(globalParams_0->fabrics_0)[_S604])->openness_0);
    return table_number_0(_S606 + _S605);
}

__device__ Scattered_0 scattered_by_0(uint _S607, Albedos_0 * _S608, uint _S609, float3  _S610)
{
    uint _S611 = 159U + 2U * _S609;
    Scattered_0 yarn_1;
    float3  _S612 = _S610 * _S608->diffuse_reflect_0;
    float _S613 = openness_number_0(_S607, _S611);
    (&yarn_1)->back_4 = _S612 + make_float3 (_S613) * _S608->specular_reflect_0;
    float3  _S614 = _S610 * _S608->diffuse_transmit_0;
    float _S615 = openness_number_0(_S607, _S611 + 1U);
    (&yarn_1)->through_0 = _S614 + make_float3 (_S615) * _S608->specular_transmit_0;
    return yarn_1;
}

__device__ void sent_0(uint _S616, uint _S617, float3  _S618, float3  _S619, float3  _S620, float3  _S621, float3  * _S622, float3  * _S623)
{
    uint _S624 = 146U + 4U * _S617;
    float _S625 = openness_number_0(_S616, _S624);
    float _S626 = openness_number_0(_S616, _S624 + 1U);
    float _S627 = openness_number_0(_S616, _S624 + 2U);
    float _S628 = openness_number_0(_S616, _S624 + 3U);
    float3  _S629 = make_float3 (1.0f) - _S620 * make_float3 (_S625);
    float3  _S630 = make_float3 (1.0f) - _S621 * make_float3 (_S628);
    float3  _S631 = make_float3 (1.0f) / (_S629 * _S630 - _S620 * _S621 * make_float3 (_S626 * _S627));
    *_S622 = (_S618 * _S630 + _S620 * make_float3 (_S626) * _S619) * _S631;
    *_S623 = (_S619 * _S629 + _S621 * make_float3 (_S627) * _S618) * _S631;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S632, uint _S633, Scattered_0 * _S634, Scattered_0 * _S635)
{
    uint _S636 = 2U * _S633;
    uint _S637 = 142U + _S636;
    float _S638 = openness_number_0(_S632, _S637);
    float _S639 = openness_number_0(_S632, _S637 + 1U);
    float3  _S640 = make_float3 (1.0f - _S638) * _S634->back_4;
    float3  _S641 = make_float3 (1.0f - _S639) * _S635->back_4;
    FaceSends_0 sends_1;
    uint _S642 = 154U + _S636;
    float _S643 = openness_number_0(_S632, _S642);
    (&sends_1)->blocks_warp_0 = _S643;
    float _S644 = openness_number_0(_S632, _S642 + 1U);
    (&sends_1)->blocks_weft_0 = _S644;
    (&sends_1)->open_0 = _S643 * _S638 + _S644 * _S639;
    sent_0(_S632, _S633, make_float3 (_S638) * _S634->back_4, make_float3 (_S639) * _S635->back_4, _S640, _S641, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S632, _S633, _S634->through_0, _S635->through_0, _S640, _S641, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S645, float3  _S646, bool _S647)
{
    Fabric_0 * _S648 = (&(globalParams_0->fabrics_0)[_S645]);
    uint _S649 = __ldg(&_S648->warp_0);
    uint _S650 = __ldg(&(&(globalParams_0->families_0)[_S649])->colour_mean_0);
    Albedos_0 _S651 = table_albedos_0(_S650);
    Scattered_0 _S652 = scattered_by_0(_S645, &_S651, 0U, _S646);
    uint _S653 = __ldg(&_S648->weft_0);
    uint _S654 = __ldg(&(&(globalParams_0->families_0)[_S653])->colour_mean_0);
    Albedos_0 _S655 = table_albedos_0(_S654);
    Scattered_0 _S656 = scattered_by_0(_S645, &_S655, 1U, _S646);
    uint _S657;
    if(_S647)
    {
        _S657 = 1U;
    }
    else
    {
        _S657 = 0U;
    }
    Scattered_0 _S658 = _S652;
    Scattered_0 _S659 = _S656;
    FaceSends_0 _S660 = face_sends_0(_S645, _S657, &_S658, &_S659);
    if(_S647)
    {
        _S657 = 0U;
    }
    else
    {
        _S657 = 1U;
    }
    Scattered_0 _S661 = _S652;
    Scattered_0 _S662 = _S656;
    FaceSends_0 _S663 = face_sends_0(_S645, _S657, &_S661, &_S662);
    float3  _S664 = make_float3 (_S660.blocks_warp_0) * _S660.crossing_warp_0 + make_float3 (_S660.blocks_weft_0) * _S660.crossing_weft_0;
    float3  _S665 = make_float3 (_S663.blocks_warp_0) * _S663.crossing_warp_0 + make_float3 (_S663.blocks_weft_0) * _S663.crossing_weft_0;
    float _S666 = 1.0f - _S660.open_0;
    float _S667 = 1.0f - _S663.open_0;
    float3  _S668 = make_float3 (1.0f) / (make_float3 (1.0f) - _S664 * _S665 * make_float3 (_S666 * _S667));
    float3  _S669 = _S665 * (make_float3 (_S660.open_0) + make_float3 (_S666) * (make_float3 (_S660.blocks_warp_0) * _S660.sky_warp_0 + make_float3 (_S660.blocks_weft_0) * _S660.sky_weft_0)) * _S668;
    float3  _S670 = _S664 * (make_float3 (_S663.open_0) + make_float3 (_S667) * (make_float3 (_S663.blocks_warp_0) * _S663.sky_warp_0 + make_float3 (_S663.blocks_weft_0) * _S663.sky_weft_0)) * _S668;
    FaceSends_0 _S671 = _S660;
    FaceRadiance_0 _S672 = face_radiance_0(&_S671, _S663.open_0, _S669, _S670);
    FaceSends_0 _S673 = _S663;
    FaceRadiance_0 _S674 = face_radiance_0(&_S673, _S660.open_0, _S670, _S669);
    Interior_0 interior_1;
    (&interior_1)->warp_3 = _S672.warp_2;
    (&interior_1)->weft_3 = _S672.weft_2;
    (&interior_1)->leaked_1 = _S672.leaked_0;
    (&interior_1)->far_1 = _S674.mean_0;
    (&interior_1)->far_leaked_0 = _S674.leaked_0;
    return interior_1;
}

__device__ Blocked_0 blocked_of_terms_0(uint _S675, uint _S676, FixedArray<float, 6>  * _S677, uint _S678)
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
            if(term_0 < _S678)
            {
            }
            else
            {
                break;
            }
            float _S679 = openness_number_0(_S675, _S676 + share_2 * _S678 + term_0);
            shares_0[share_2] = shares_0[share_2] + _S679 * (*_S677)[term_0];
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

__device__ Blocked_0 blocked_from_0(uint _S680, float3  _S681, bool _S682, bool _S683)
{
    FixedArray<float, 6>  terms_1;
    view_terms_0(_S681, &terms_1);
    uint _S684;
    if(_S683)
    {
        _S684 = 2U;
    }
    else
    {
        _S684 = 0U;
    }
    uint _S685;
    if(_S682)
    {
        _S685 = 0U;
    }
    else
    {
        _S685 = 1U;
    }
    uint _S686 = (_S684 + _S685) * 15U;
    FixedArray<float, 6>  _S687 = terms_1;
    Blocked_0 _S688 = blocked_of_terms_0(_S680, _S686, &_S687, 5U);
    return _S688;
}

__device__ float warp_seen_from_0(uint _S689, float3  _S690, bool _S691)
{
    FixedArray<float, 6>  terms_2;
    view_terms_0(_S690, &terms_2);
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
        uint _S692;
        if(_S691)
        {
            _S692 = 5U;
        }
        else
        {
            _S692 = 0U;
        }
        float _S693 = openness_number_0(_S689, 132U + _S692 + term_1);
        float share_4 = share_3 + _S693 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_3 = share_4;
    }
    return saturate_0(share_3);
}

__device__ Bounced_0 bounced_of_families_0(uint _S694, FamilyAlbedos_0 * _S695, float3  _S696, Interior_0 * _S697, Blocked_0 * _S698, Blocked_0 * _S699)
{
    Scattered_0 _S700 = scattered_by_0(_S694, &_S695->warp_4, 0U, _S696);
    Scattered_0 _S701 = _S700;
    Bounced_0 _S702 = bounced_by_0(_S698, &_S701, _S697);
    Scattered_0 _S703 = scattered_by_0(_S694, &_S695->weft_4, 1U, _S696);
    Scattered_0 _S704 = _S703;
    Bounced_0 _S705 = bounced_by_0(_S699, &_S704, _S697);
    Bounced_0 _S706 = _S702;
    Bounced_0 _S707 = _S705;
    Bounced_0 _S708 = sum_of_0(&_S706, &_S707);
    return _S708;
}

__device__ Bounced_0 bounced_far_0(uint _S709, FamilyAlbedos_0 * _S710, float3  _S711, Interior_0 * _S712, float3  _S713, bool _S714, float _S715, float _S716, float _S717)
{
    Blocked_0 _S718 = blocked_from_0(_S709, _S713, true, _S714);
    Blocked_0 _S719 = blocked_from_0(_S709, _S713, false, _S714);
    float _S720 = _S715 / (F32_max((1.0f - _S718.by_warp_0 - _S718.by_weft_0), (0.10000000149011612f)));
    float _S721 = _S716 / (F32_max((1.0f - _S719.by_warp_0 - _S719.by_weft_0), (0.10000000149011612f)));
    float _S722 = warp_seen_from_0(_S709, _S713, _S714);
    float _S723 = (0.0020000000949949f * _S722 + _S720) / (_S720 + _S721 + 0.0020000000949949f);
    float _S724 = 1.0f - _S717;
    float _S725 = _S723 * _S724;
    Blocked_0 _S726 = _S718;
    Blocked_0 _S727 = scaled_0(&_S726, _S725);
    float _S728 = (1.0f - _S723) * _S724;
    Blocked_0 _S729 = _S719;
    Blocked_0 _S730 = scaled_0(&_S729, _S728);
    Blocked_0 _S731 = _S727;
    Blocked_0 _S732 = _S730;
    Bounced_0 _S733 = bounced_of_families_0(_S709, _S710, _S711, _S712, &_S731, &_S732);
    return _S733;
}

__device__ Bounced_0 bounced_over_0(uint _S734, Components_0 * _S735, CloseUp_0 * _S736, FamilyAlbedos_0 * _S737, float3  _S738, float3  _S739)
{
    bool _S740 = (_S739.z) < 0.0f;
    Interior_0 _S741 = interior_of_0(_S734, _S738, _S740);
    float3  _S742 = to_face_frame_0(_S739, _S740);
    Interior_0 _S743 = _S741;
    Bounced_0 _S744 = bounced_far_0(_S734, _S737, _S738, &_S743, _S742, _S740, _S735->diffuse_warp_0, _S735->diffuse_weft_0, _S735->hole_2);
    Bounced_0 bounced_2 = _S744;
    float _S745 = _S736->weight_2;
    if((_S736->weight_2) > 0.0f)
    {
        Interior_0 _S746 = _S741;
        Bounced_0 _S747 = bounced_of_families_0(_S734, _S737, _S738, &_S746, &_S736->warp_1, &_S736->weft_1);
        float3  _S748 = make_float3 (_S745);
        (&bounced_2)->reflected_0 = lerp_0((&bounced_2)->reflected_0, _S747.reflected_0, _S748);
        (&bounced_2)->transmitted_0 = lerp_0((&bounced_2)->transmitted_0, _S747.transmitted_0, _S748);
    }
    return bounced_2;
}

__device__ float3  composed_0(uint _S749, Components_0 * _S750, CloseUp_0 * _S751, FamilyAlbedos_0 * _S752, float3  _S753, float3  _S754, float3  _S755)
{
    Fabric_0 * _S756 = (&(globalParams_0->fabrics_0)[_S749]);
    Albedos_0 _S757 = tinted_0(&_S752->warp_4, _S753);
    Albedos_0 _S758 = tinted_0(&_S752->weft_4, _S753);
    float _S759 = _S750->diffuse_warp_0;
    float _S760 = _S750->diffuse_weft_0;
    float _S761 = _S750->specular_warp_0;
    float _S762 = _S750->specular_weft_0;
    float3  _S763 = _S757.diffuse_reflect_0 * make_float3 (_S750->diffuse_warp_0) + _S758.diffuse_reflect_0 * make_float3 (_S750->diffuse_weft_0) + _S757.specular_reflect_0 * make_float3 (_S750->specular_warp_0) + _S758.specular_reflect_0 * make_float3 (_S750->specular_weft_0);
    float _S764 = _S755.z;
    float3  body_0;
    if((_S754.z * _S764) < 0.0f)
    {
        body_0 = _S757.diffuse_transmit_0 * make_float3 (_S759) + _S758.diffuse_transmit_0 * make_float3 (_S760) + _S757.specular_transmit_0 * make_float3 (_S761) + _S758.specular_transmit_0 * make_float3 (_S762);
    }
    else
    {
        body_0 = _S763;
    }
    uint _S765 = __ldg(&_S756->openness_0);
    if(_S765 != 4294967295U)
    {
        Bounced_0 _S766 = bounced_over_0(_S749, _S750, _S751, _S752, _S753, _S755);
        Bounced_0 _S767 = _S766;
        float3  _S768 = bounced_value_0(&_S767, _S754, _S755);
        body_0 = body_0 + _S768;
    }
    float _S769 = __ldg(&_S756->sheen_strength_0);
    if(_S769 <= 0.0f)
    {
        return body_0;
    }
    bool _S770 = _S764 < 0.0f;
    float3  _S771 = to_face_frame_0(_S754, _S770);
    float3  _S772 = to_face_frame_0(_S755, _S770);
    float _S773 = __ldg(&_S756->sheen_roughness_0);
    float2  _S774 = sheen_with_transmittance_0(_S771, _S772, _S769, _S773);
    return make_float3 (_S774.y) * body_0 + make_float3 ((_S750->light_visibility_1 + _S750->hole_2) * _S774.x);
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_3, float2  dx_1, float2  dy_1, float3  light_4, float3  view_6)
{
    Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = centre_3;
    (&footprint_1)->dx_0 = dx_1;
    (&footprint_1)->dy_0 = dy_1;
    Footprint_0 _S775 = footprint_1;
    WovenView_0 activations_0;
    woven_view_0(fabric_2, &_S775, view_6, &activations_0);
    Components_0 _S776 = woven_components_0(fabric_2, &activations_0, light_4);
    float _S777 = view_6.z;
    bool _S778 = _S777 < 0.0f;
    Footprint_0 _S779 = footprint_1;
    FamilyAlbedos_0 _S780 = albedos_over_0(fabric_2, &_S779, _S778);
    CloseUp_0 _S781 = no_close_up_0();
    float3  _S782 = make_float3 (1.0f);
    Components_0 _S783 = _S776;
    CloseUp_0 _S784 = _S781;
    FamilyAlbedos_0 _S785 = _S780;
    float3  _S786 = composed_0(fabric_2, &_S783, &_S784, &_S785, _S782, light_4, view_6);
    float through_1 = (&activations_0)->hole_0;
    float _S787 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
    float through_2;
    if(_S787 > 0.0f)
    {
        float _S788 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_strength_0);
        float _S789 = (F32_abs((_S777)));
        float _S790 = __ldg(&(&(globalParams_0->fabrics_0)[fabric_2])->sheen_roughness_0);
        through_2 = through_1 * (1.0f - _S788 * sheen_lobe_0(_S789, _S790).z);
    }
    else
    {
        through_2 = through_1;
    }
    return make_float4 (_S786.x, _S786.y, _S786.z, through_2);
}

extern "C" __global__ void woven_queries()
{
    uint _S791 = (blockIdx * blockDim + threadIdx).x;
    uint _S792 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S791 >= _S792)
    {
        return;
    }
    Query_0 _S793 = slang_ldg_0((&(globalParams_0->queries_0)[_S791]));
    *(&(globalParams_0->answers_0)[_S791]) = cloth_value_0(_S793.fabric_1, make_float2 (_S793.centre_x_0, _S793.centre_y_0), make_float2 (_S793.dx_x_0, _S793.dx_y_0), make_float2 (_S793.dy_x_0, _S793.dy_y_0), make_float3 (_S793.light_x_0, _S793.light_y_0, _S793.light_z_0), make_float3 (_S793.view_x_0, _S793.view_y_0, _S793.view_z_0));
    return;
}

