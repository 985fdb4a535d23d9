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

struct GlobalParams_0
{
    StructuredBuffer<Fabric_0> fabrics_0;
    StructuredBuffer<Family_0> families_0;
    StructuredBuffer<uint> words_0;
    StructuredBuffer<Light_0> lights_1;
    StructuredBuffer<Frame_0> frames_0;
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
};

extern "C" __constant__ GlobalParams_0 SLANG_globalParams;
#define globalParams_0 (&SLANG_globalParams)
struct FloatWeights_0
{
    uint first_0;
};

struct Eight_0
{
    float4  low_0;
    float4  high_0;
};

__device__ float4  asfloat_0(uint4  x_3)
{
    float4  result_0;
    int i_0 = int(0);
    for(;;)
    {
        if(i_0 < int(4))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_0, i_0) = (U32_asfloat((_slang_vector_get_element(x_3, i_0))));
        i_0 = i_0 + int(1);
    }
    return result_0;
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

__device__ float dot_0(float4  x_4, float4  y_3)
{
    int i_1 = int(0);
    float result_1 = 0.0f;
    for(;;)
    {
        if(i_1 < int(4))
        {
        }
        else
        {
            break;
        }
        float result_2 = result_1 + _slang_vector_get_element(x_4, i_1) * _slang_vector_get_element(y_3, i_1);
        i_1 = i_1 + int(1);
        result_1 = result_2;
    }
    return result_1;
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

__device__ float Identity_apply_0(float x_5)
{
    return x_5;
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

__device__ float3  min_0(float3  x_6, float3  y_4)
{
    float3  result_3;
    int i_2 = int(0);
    for(;;)
    {
        if(i_2 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_3, i_2) = (F32_min((_slang_vector_get_element(x_6, i_2)), (_slang_vector_get_element(y_4, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_3;
}

__device__ float3  max_0(float3  x_7, float3  y_5)
{
    float3  result_4;
    int i_3 = int(0);
    for(;;)
    {
        if(i_3 < int(3))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_4, i_3) = (F32_max((_slang_vector_get_element(x_7, i_3)), (_slang_vector_get_element(y_5, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_4;
}

__device__ float3  clamp_0(float3  x_8, float3  minBound_0, float3  maxBound_0)
{
    return min_0(max_0(x_8, minBound_0), maxBound_0);
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

__device__ float dot_1(float3  x_12, float3  y_8)
{
    int i_7 = int(0);
    float result_8 = 0.0f;
    for(;;)
    {
        if(i_7 < int(3))
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

__device__ float length_0(float3  x_13)
{
    return (F32_sqrt((dot_1(x_13, x_13))));
}

__device__ float dot_2(float2  x_14, float2  y_9)
{
    int i_8 = int(0);
    float result_10 = 0.0f;
    for(;;)
    {
        if(i_8 < int(2))
        {
        }
        else
        {
            break;
        }
        float result_11 = result_10 + _slang_vector_get_element(x_14, i_8) * _slang_vector_get_element(y_9, i_8);
        i_8 = i_8 + int(1);
        result_10 = result_11;
    }
    return result_10;
}

__device__ float clamp_1(float x_15, float minBound_1, float maxBound_1)
{
    return (F32_min(((F32_max((x_15), (minBound_1)))), (maxBound_1)));
}

__device__ float lerp_0(float x_16, float y_10, float s_0)
{
    return x_16 + (y_10 - x_16) * s_0;
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

__device__ float3  normalize_0(float3  x_17)
{
    return x_17 / make_float3 (length_0(x_17));
}

__device__ float saturate_0(float x_18)
{
    return clamp_1(x_18, 0.0f, 1.0f);
}

__device__ float2  frac_0(float2  x_19)
{
    float2  result_12;
    int i_9 = int(0);
    for(;;)
    {
        if(i_9 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_12, i_9) = (F32_frac((_slang_vector_get_element(x_19, i_9))));
        i_9 = i_9 + int(1);
    }
    return result_12;
}

__device__ float3  saturate_1(float3  x_20)
{
    return clamp_0(x_20, make_float3 (0.0f), make_float3 (1.0f));
}

__device__ float2  sqrt_0(float2  x_21)
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
        *_slang_vector_get_element_ptr(&result_13, i_10) = (F32_sqrt((_slang_vector_get_element(x_21, i_10))));
        i_10 = i_10 + int(1);
    }
    return result_13;
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

__device__ float2  clamp_2(float2  x_22, float2  minBound_2, float2  maxBound_2)
{
    return min_1(max_1(x_22, minBound_2), maxBound_2);
}

__device__ bool any_0(bool2  x_23)
{
    bool result_14 = false;
    int i_11 = int(0);
    for(;;)
    {
        if(i_11 < int(2))
        {
        }
        else
        {
            break;
        }
        if(result_14)
        {
            result_14 = true;
        }
        else
        {
            result_14 = (bool((_slang_vector_get_element(x_23, i_11))));
        }
        i_11 = i_11 + int(1);
    }
    return result_14;
}

__device__ float2  lerp_1(float2  x_24, float2  y_11, float2  s_1)
{
    return x_24 + (y_11 - x_24) * s_1;
}

__device__ float2  floor_0(float2  x_25)
{
    float2  result_15;
    int i_12 = int(0);
    for(;;)
    {
        if(i_12 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_15, i_12) = (F32_floor((_slang_vector_get_element(x_25, i_12))));
        i_12 = i_12 + int(1);
    }
    return result_15;
}

__device__ float3  lerp_2(float3  x_26, float3  y_12, float3  s_2)
{
    return x_26 + (y_12 - x_26) * s_2;
}

__device__ float3  cross_0(float3  left_0, float3  right_0)
{
    float _S156 = left_0.y;
    float _S157 = right_0.z;
    float _S158 = left_0.z;
    float _S159 = right_0.y;
    float _S160 = right_0.x;
    float _S161 = left_0.x;
    return make_float3 (_S156 * _S157 - _S158 * _S159, _S158 * _S160 - _S161 * _S157, _S161 * _S159 - _S156 * _S160);
}

__device__ Woven_0 slang_ldg_0(Woven_0 * ptr_0)
{
    uint _S162 = __ldg(&ptr_0->is_encoded_0);
    uint _S163 = __ldg(&ptr_0->network_0);
    uint _S164 = __ldg(&ptr_0->latents_0);
    uint _S165 = __ldg(&ptr_0->texels_0);
    uint _S166 = __ldg(&ptr_0->levels_1);
    uint _S167 = __ldg(&ptr_0->top_level_0);
    float _S168 = __ldg(&ptr_0->ends_0);
    float _S169 = __ldg(&ptr_0->picks_0);
    float _S170 = __ldg(&ptr_0->ends_per_mm_0);
    float _S171 = __ldg(&ptr_0->picks_per_mm_0);
    float _S172 = __ldg(&ptr_0->pitch_0);
    float _S173 = __ldg(&ptr_0->warp_x_0);
    float _S174 = __ldg(&ptr_0->warp_y_0);
    float _S175 = __ldg(&ptr_0->warp_roughness_0);
    float _S176 = __ldg(&ptr_0->weft_x_0);
    float _S177 = __ldg(&ptr_0->weft_y_0);
    float _S178 = __ldg(&ptr_0->weft_roughness_0);
    float _S179 = __ldg(&ptr_0->warp_lobe_roughness_0);
    float _S180 = __ldg(&ptr_0->weft_lobe_roughness_0);
    uint _S181 = __ldg(&ptr_0->bundles_0);
    uint _S182 = __ldg(&ptr_0->is_corrected_0);
    uint _S183 = __ldg(&ptr_0->correction_0);
    Woven_0 _S184 = { _S162, _S163, _S164, _S165, _S166, _S167, _S168, _S169, _S170, _S171, _S172, _S173, _S174, _S175, _S176, _S177, _S178, _S179, _S180, _S181, _S182, _S183 };
    return _S184;
}

__device__ Vertex_0 slang_ldg_1(Vertex_0 * ptr_1)
{
    float _S185 = __ldg(&ptr_1->x_1);
    float _S186 = __ldg(&ptr_1->y_1);
    float _S187 = __ldg(&ptr_1->z_1);
    float _S188 = __ldg(&ptr_1->normal_x_0);
    float _S189 = __ldg(&ptr_1->normal_y_0);
    float _S190 = __ldg(&ptr_1->normal_z_0);
    float _S191 = __ldg(&ptr_1->u_0);
    float _S192 = __ldg(&ptr_1->v_0);
    Vertex_0 _S193 = { _S185, _S186, _S187, _S188, _S189, _S190, _S191, _S192 };
    return _S193;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_1(v_1, v_1);
}

__device__ float3  normal_of_0(Vertex_0 * vertex_1)
{
    return make_float3 (vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

__device__ float square_1(float x_27)
{
    return x_27 * x_27;
}

__device__ float natural_logarithm_0(float x_28)
{
    uint _S194 = (F32_asuint((x_28)));
    float exponent_0 = float(int(_S194 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S194 & 8388607U) | 1056964608U)));
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
    float _S195 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S195 - exponent_1 * 0.00021219444170129f - 0.5f * _S195) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_29)
{
    return natural_logarithm_0(x_29) * 1.4426950216293335f;
}

__device__ float exponential_0(float x_30)
{
    float _S196 = clamp_1(x_30, -87.0f, 88.0f);
    float _S197 = (F32_floor((_S196 * 1.4426950216293335f + 0.5f)));
    float _S198 = _S196 - _S197 * 0.693359375f + _S197 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S198 + 0.00139819993637502f) * _S198 + 0.00833345204591751f) * _S198 + 0.04166579619050026f) * _S198 + 0.1666666567325592f) * _S198 + 0.5f;
    float _S199 = (U32_asfloat((uint(int(_S197) + int(127)) << int(23))));
    float _S200;
    if(x_30 < -87.0f)
    {
        _S200 = 0.0f;
    }
    else
    {
        _S200 = (p_0 * _S198 * _S198 + _S198 + 1.0f) * _S199;
    }
    return _S200;
}

__device__ float3  map_texel_0(uint index_0)
{
    uint _S201 = __ldg((&(globalParams_0->scene_words_0)[index_0]));
    float3  _S202 = make_float3 (float(_S201 & 1023U), float((_S201 >> int(10)) & 1023U), float(_S201 >> int(20))) / make_float3 (1023.0f);
    return _S202 * _S202;
}

__device__ float3  map_level_0(uint first_19, uint side_0, float2  uv_0)
{
    float _S203 = uv_0.x;
    float _S204 = float(side_0);
    float _S205 = (_S203 - (F32_floor((_S203)))) * _S204 - 0.5f;
    float _S206 = uv_0.y;
    float _S207 = (_S206 - (F32_floor((_S206)))) * _S204 - 0.5f;
    float _S208 = (F32_floor((_S205)));
    int _S209 = int(side_0);
    uint _S210 = side_0 - 1U;
    uint _S211 = uint(int(_S208) + _S209) & _S210;
    float _S212 = (F32_floor((_S207)));
    uint _S213 = uint(int(_S212) + _S209) & _S210;
    uint _S214 = (_S211 + 1U) & _S210;
    uint _S215 = first_19 + _S213 * side_0;
    float3  _S216 = make_float3 (_S205 - _S208);
    uint _S217 = first_19 + ((_S213 + 1U) & _S210) * side_0;
    return lerp_2(lerp_2(map_texel_0(_S215 + _S211), map_texel_0(_S215 + _S214), _S216), lerp_2(map_texel_0(_S217 + _S211), map_texel_0(_S217 + _S214), _S216), make_float3 (_S207 - _S212));
}

struct VisiblePoint_0
{
    float3  position_0;
    float3  view_0;
    float3  axis_x_0;
    float3  axis_y_0;
    float3  normal_0;
    float3  face_normal_0;
    float2  uv_1;
    float2  draft_per_uv_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_0)
{
    return make_float3 (dot_1(direction_0, point_0->axis_x_0), dot_1(direction_0, point_0->axis_y_0), dot_1(direction_0, point_0->normal_0));
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

__device__ float3  row_of_taps_0(Footprint_0 * footprint_0)
{
    float _S218 = footprint_0->dx_0.x;
    float _S219 = footprint_0->dy_0.x;
    float _S220 = _S218 * _S218 + _S219 * _S219;
    float _S221 = footprint_0->dx_0.y;
    float _S222 = footprint_0->dy_0.y;
    float _S223 = _S221 * _S221 + _S222 * _S222;
    float _S224 = _S218 * _S221 + _S219 * _S222;
    float _S225 = 0.5f * (_S220 - _S223);
    float _S226 = 0.5f * (_S220 + _S223);
    float _S227 = (F32_sqrt((_S225 * _S225 + _S224 * _S224)));
    float _S228 = _S226 + _S227;
    float _S229 = (F32_max((_S228 - 1.5f * (F32_max((_S226 - _S227), (0.0f)))), (0.0f)));
    float _S230 = square_1(4.0f);
    float _S231 = (F32_max((_S226 - 0.5f * _S229), (_S228 / _S230)));
    float _S232 = (F32_sqrt(((F32_max(((F32_min((_S229), (_S228 - _S231)))), (0.0f))) / (_S230 - 1.0f))));
    float _S233 = _S225 / (F32_max((_S227), (1.00000000317107685e-30f)));
    float _S234 = (F32_sqrt(((F32_max((0.5f * (1.0f - _S233)), (0.0f))))));
    float _S235 = (F32_sqrt((_S231)));
    float _S236 = _S232 * (F32_sqrt(((F32_max((0.5f * (1.0f + _S233)), (0.0f))))));
    float _S237;
    if(_S224 < 0.0f)
    {
        _S237 = - _S232 * _S234;
    }
    else
    {
        _S237 = _S232 * _S234;
    }
    return make_float3 (_S235, _S236, _S237);
}

struct AnisotropicTaps_0
{
    float2  centre_1;
    float side_1;
    float2  first_20;
    float2  second_0;
};

__device__ float AnisotropicTaps_size_0(AnisotropicTaps_0 * this_2)
{
    float _S238 = this_2->first_20.x;
    float _S239 = this_2->second_0.x;
    float _S240 = this_2->side_1 * this_2->side_1;
    float _S241 = this_2->first_20.y;
    float _S242 = this_2->second_0.y;
    float _S243 = 12.0f * (_S238 * _S241 + _S239 * _S242);
    return (F32_sqrt(((F32_sqrt(((F32_max(((12.0f * (_S238 * _S238 + _S239 * _S239) + _S240) * (12.0f * (_S241 * _S241 + _S242 * _S242) + _S240) - _S243 * _S243), (square_1(_S240))))))))));
}

__device__ float3  footprint_coordinates_0(AnisotropicTaps_0 * taps_0)
{
    float _S244 = AnisotropicTaps_size_0(taps_0);
    return make_float3 ((taps_0->centre_1 - floor_0(taps_0->centre_1)).x, (taps_0->centre_1 - floor_0(taps_0->centre_1)).y, clamp_1(natural_logarithm_0((F32_max((_S244), (9.99999997475242708e-07f))) / 0.015625f) * 0.11708354949951172f, 0.0f, 1.0f));
}

__device__ float3  to_face_frame_0(float3  direction_1, bool back_1)
{
    float2  _S245 = float2 {direction_1.x, direction_1.y};
    float _S246;
    if(back_1)
    {
        _S246 = - direction_1.z;
    }
    else
    {
        _S246 = direction_1.z;
    }
    return make_float3 (_S245.x, _S245.y, _S246);
}

__device__ float table_number_0(uint index_1)
{
    uint _S247 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S247)));
}

__device__ float wrapped_0(float index_2, float count_1)
{
    float _S248;
    if(index_2 < 0.0f)
    {
        _S248 = index_2 + count_1;
    }
    else
    {
        if(index_2 >= count_1)
        {
            _S248 = index_2 - count_1;
        }
        else
        {
            _S248 = index_2;
        }
    }
    return _S248;
}

__device__ bool AnisotropicTaps_has_steps_0(AnisotropicTaps_0 * this_3)
{
    float2  _S249 = make_float2 (0.0f);
    bool _S250;
    if(any_0((this_3->first_20) != _S249))
    {
        _S250 = true;
    }
    else
    {
        _S250 = any_0((this_3->second_0) != _S249);
    }
    return _S250;
}

__device__ float2  AnisotropicTaps_place_0(AnisotropicTaps_0 * this_4, uint number_0)
{
    float _S251;
    if(number_0 >= 2U)
    {
        _S251 = 1.0f;
    }
    else
    {
        _S251 = -1.0f;
    }
    float _S252;
    if((number_0 & 1U) != 0U)
    {
        _S252 = 1.0f;
    }
    else
    {
        _S252 = -1.0f;
    }
    return this_4->centre_1 + make_float2 (_S251) * this_4->first_20 + make_float2 (_S252) * this_4->second_0;
}

__device__ float bump_0(float distance_0)
{
    float _S253 = (F32_max((1.0f - distance_0 * distance_0), (0.0f)));
    return _S253 * _S253;
}

__device__ float correction_weight_of_0(float coded_size_0)
{
    return clamp_1((coded_size_0 - 0.4869367778301239f) * 6.16096401214599609f, 0.0f, 1.0f);
}

__device__ Family_0 slang_ldg_2(Family_0 * ptr_2)
{
    uint _S254 = __ldg(&ptr_2->is_alike_0);
    float _S255 = __ldg(&ptr_2->count_0);
    float _S256 = __ldg(&ptr_2->inverse_count_0);
    float _S257 = __ldg(&ptr_2->half_inverse_count_0);
    float _S258 = __ldg(&ptr_2->size_0);
    float _S259 = __ldg(&ptr_2->inverse_size_0);
    float _S260 = __ldg(&ptr_2->half_width_0);
    float _S261 = __ldg(&ptr_2->start_0);
    float _S262 = __ldg(&ptr_2->period_0);
    float _S263 = __ldg(&ptr_2->inverse_period_0);
    float _S264 = __ldg(&ptr_2->bins_0);
    uint _S265 = __ldg(&ptr_2->first_thread_table_0);
    uint _S266 = __ldg(&ptr_2->place_table_0);
    uint _S267 = __ldg(&ptr_2->bend_table_0);
    float _S268 = __ldg(&ptr_2->height_scale_0);
    float _S269 = __ldg(&ptr_2->twist_sine_0);
    float _S270 = __ldg(&ptr_2->twist_cosine_0);
    float _S271 = __ldg(&ptr_2->level_0);
    float _S272 = __ldg(&ptr_2->roughness_0);
    uint _S273 = __ldg(&ptr_2->albedo_table_0);
    uint _S274 = __ldg(&ptr_2->albedo_stride_0);
    uint _S275 = __ldg(&ptr_2->before_0);
    float _S276 = __ldg(&ptr_2->visible_total_0);
    float _S277 = __ldg(&ptr_2->smallest_box_0);
    uint _S278 = __ldg(&ptr_2->quantities_0);
    uint _S279 = __ldg(&ptr_2->colour_mean_0);
    uint _S280 = __ldg(&ptr_2->colour_axes_0);
    uint _S281 = __ldg(&ptr_2->colour_threads_0);
    uint _S282 = __ldg(&ptr_2->colour_areas_0);
    float _S283 = __ldg(&ptr_2->area_unit_0);
    float _S284 = __ldg(&ptr_2->crossing_area_0);
    Family_0 _S285 = { _S254, _S255, _S256, _S257, _S258, _S259, _S260, _S261, _S262, _S263, _S264, _S265, _S266, _S267, _S268, _S269, _S270, _S271, _S272, _S273, _S274, _S275, _S276, _S277, _S278, _S279, _S280, _S281, _S282, _S283, _S284 };
    return _S285;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_3)
{
    Family_0 _S286 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    Family_0 _S287 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    float _S288 = (F32_floor(((F32_fma((index_3), (_S286.inverse_count_0), (_S287.half_inverse_count_0))))));
    float _S289 = - _S288;
    Family_0 _S290 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S288, (F32_fma((_S289), (_S290.count_0), (index_3))));
}

struct Cell_0
{
    uint thread_0;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_1)
{
    Family_0 _S291 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S292 = (F32_floor((position_1 * _S291.inverse_size_0)));
    Cell_0 cell_0;
    float _S293 = - _S292;
    Family_0 _S294 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S295 = (F32_fma((_S293), (_S294.size_0), (position_1)));
    (&cell_0)->below_0 = _S295;
    Family_0 _S296 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->above_0 = _S296.size_0 - _S295;
    Family_0 _S297 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->across_0 = _S295 - 0.5f * _S297.size_0;
    Family_0 _S298 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->half_width_1 = _S298.half_width_0;
    float _S299 = turns_and_remainder_0(family_1, _S292).y;
    Family_0 _S300 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->thread_0 = uint(clamp_1(_S299, 0.0f, _S300.count_0 - 1.0f));
    return cell_0;
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_2)
{
    Family_0 _S301 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S302 = position_2 - _S301.start_0;
    Family_0 _S303 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S302 * _S303.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S304 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S305 = turns_1 * _S304.period_0;
    Family_0 _S306 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S307 = turns_1 * _S306.bins_0;
    Family_0 _S308 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S309 = uint(clamp_1(_S307, 0.0f, _S308.bins_0 - 1.0f));
    Family_0 _S310 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S311 = __ldg((&(globalParams_0->words_0)[_S310.first_thread_table_0 + _S309]));
    Family_0 _S312 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S313;
    if(_S305 >= (table_number_0(_S312.place_table_0 + _S311 * 4U + 1U)))
    {
        _S313 = 1U;
    }
    else
    {
        _S313 = 0U;
    }
    uint _S314 = _S311 + _S313;
    Family_0 _S315 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S316 = (U32_min((_S314), (uint(_S315.count_0) - 1U)));
    Family_0 _S317 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S318 = _S317.place_table_0 + _S316 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S316;
    (&cell_1)->below_0 = _S305 - table_number_0(_S318);
    (&cell_1)->above_0 = table_number_0(_S318 + 1U) - _S305;
    (&cell_1)->across_0 = _S305 - table_number_0(_S318 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S318 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_3)
{
    Family_0 _S319 = slang_ldg_2((&(globalParams_0->families_0)[family_3]));
    if((_S319.is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Bound_0
{
    uint thread_1;
    float turns_2;
    float cell_2;
    float visible_0;
    float width_1;
    float gap_0;
};

__device__ Bound_0 bound_at_0(uint family_4, float position_4)
{
    Cell_0 _S320 = locate_0(family_4, position_4);
    Family_0 _S321 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    float _S322 = table_number_0(_S321.before_0 + 2U * _S320.thread_0 + 1U);
    Bound_0 bound_0;
    (&bound_0)->thread_1 = _S320.thread_0;
    Family_0 _S323 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    float _S324 = position_4 - _S323.start_0 - _S322 - _S320.below_0;
    Family_0 _S325 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    (&bound_0)->turns_2 = (F32_round((_S324 * _S325.inverse_period_0)));
    (&bound_0)->cell_2 = _S320.below_0;
    float _S326 = 2.0f * _S320.half_width_1;
    (&bound_0)->width_1 = _S326;
    (&bound_0)->visible_0 = clamp_1((_S320.across_0 + _S320.half_width_1) / _S326, 0.0f, 1.0f);
    (&bound_0)->gap_0 = (F32_min((_S320.below_0), (_S320.below_0 - _S320.across_0 - _S320.half_width_1))) + (F32_max((_S320.across_0 - _S320.half_width_1), (0.0f)));
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_7;
    Bound_0 high_7;
};

__device__ Stretch_0 stretch_of_0(uint family_5, float centre_2, float size_1)
{
    Family_0 _S327 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    float _S328 = centre_2 - _S327.start_0;
    Family_0 _S329 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    float _S330 = (F32_floor((_S328 * _S329.inverse_period_0)));
    Family_0 _S331 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    float _S332 = centre_2 - _S330 * _S331.period_0;
    Family_0 _S333 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    float _S334 = 0.5f * (F32_max((size_1), (_S333.smallest_box_0)));
    Stretch_0 stretch_0;
    (&stretch_0)->low_7 = bound_at_0(family_5, _S332 - _S334);
    (&stretch_0)->high_7 = bound_at_0(family_5, _S332 + _S334);
    return stretch_0;
}

__device__ float3  table_colour_0(uint index_4)
{
    return make_float3 (table_number_0(index_4), table_number_0(index_4 + 1U), table_number_0(index_4 + 2U));
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
    float _S335 = Stretch_turns_0(stretch_1);
    Family_0 _S336 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    uint _S337 = _S336.before_0 + 2U * (&stretch_1->low_7)->thread_1;
    Family_0 _S338 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    uint _S339 = _S338.before_0 + 2U * (&stretch_1->high_7)->thread_1;
    float _S340 = table_number_0(_S339) - table_number_0(_S337);
    float _S341 = table_number_0(_S339 + 1U) - table_number_0(_S337 + 1U);
    float _S342 = _S340 + (&stretch_1->high_7)->visible_0 * (&stretch_1->high_7)->width_1 - (&stretch_1->low_7)->visible_0 * (&stretch_1->low_7)->width_1;
    Family_0 _S343 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    float _S344 = _S342 + _S335 * _S343.visible_total_0;
    float _S345 = _S341 - _S340 + (&stretch_1->high_7)->gap_0 - (&stretch_1->low_7)->gap_0;
    Family_0 _S346 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    Family_0 _S347 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    float _S348 = _S345 + _S335 * (_S346.period_0 - _S347.visible_total_0);
    float _S349 = _S341 + (&stretch_1->high_7)->cell_2 - (&stretch_1->low_7)->cell_2;
    Family_0 _S350 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    return make_float3 (_S344, _S348, _S349 + _S335 * _S350.period_0);
}

__device__ float2  integrals_along_0(uint family_7, Stretch_0 * stretch_2, uint quantity_0)
{
    Family_0 _S351 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    Family_0 _S352 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    uint _S353 = 3U * _S351.quantities_0;
    uint _S354 = _S352.colour_threads_0 + _S353 * (&stretch_2->low_7)->thread_1 + quantity_0;
    Family_0 _S355 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    uint _S356 = _S355.colour_threads_0 + _S353 * (&stretch_2->high_7)->thread_1 + quantity_0;
    Family_0 _S357 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    Family_0 _S358 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    uint _S359 = _S357.colour_threads_0 + _S353 * uint(_S358.count_0) + quantity_0;
    float _S360 = table_number_0(_S354);
    float _S361 = table_number_0(_S356);
    float _S362 = Stretch_turns_0(stretch_2);
    uint _S363 = 2U * _S351.quantities_0;
    return make_float2 (table_number_0(_S356 + _S351.quantities_0) - table_number_0(_S354 + _S351.quantities_0) + _S361 * (&stretch_2->high_7)->visible_0 * (&stretch_2->high_7)->width_1 - _S360 * (&stretch_2->low_7)->visible_0 * (&stretch_2->low_7)->width_1 + _S362 * table_number_0(_S359 + _S351.quantities_0), table_number_0(_S356 + _S363) - table_number_0(_S354 + _S363) + _S361 * (&stretch_2->high_7)->cell_2 - _S360 * (&stretch_2->low_7)->cell_2 + _S362 * table_number_0(_S359 + _S363));
}

__device__ bool Stretch_wraps_0(Stretch_0 * this_6)
{
    return ((&this_6->high_7)->thread_1) < ((&this_6->low_7)->thread_1);
}

__device__ uint4  Stretch_differences_0(Stretch_0 * this_7, uint4  entries_0, uint whole_0)
{
    uint _S364 = entries_0.z;
    uint _S365 = entries_0.x;
    uint _S366 = _S364 - _S365;
    bool _S367 = Stretch_wraps_0(this_7);
    uint _S368;
    if(_S367)
    {
        _S368 = whole_0;
    }
    else
    {
        _S368 = 0U;
    }
    return make_uint4 (_S366 + _S368, entries_0.w - _S364, entries_0.y - _S365, whole_0);
}

__device__ uint4  row_differences_0(Stretch_0 * across_1, uint row_7, uint count_2, uint quantities_1)
{
    uint _S369 = row_7 + (&across_1->low_7)->thread_1 * quantities_1;
    uint _S370 = row_7 + (&across_1->high_7)->thread_1 * quantities_1;
    uint _S371 = __ldg((&(globalParams_0->words_0)[_S369]));
    uint _S372 = __ldg((&(globalParams_0->words_0)[_S369 + quantities_1]));
    uint _S373 = __ldg((&(globalParams_0->words_0)[_S370]));
    uint _S374 = __ldg((&(globalParams_0->words_0)[_S370 + quantities_1]));
    uint4  _S375 = make_uint4 (_S371, _S372, _S373, _S374);
    uint _S376 = __ldg((&(globalParams_0->words_0)[row_7 + count_2 * quantities_1]));
    uint4  _S377 = Stretch_differences_0(across_1, _S375, _S376);
    return _S377;
}

__device__ float4  Stretch_weights_0(Stretch_0 * this_8)
{
    float _S378 = (&this_8->high_7)->visible_0;
    float _S379 = - (&this_8->low_7)->visible_0;
    float _S380 = Stretch_turns_0(this_8);
    bool _S381 = Stretch_wraps_0(this_8);
    float _S382;
    if(_S381)
    {
        _S382 = 1.0f;
    }
    else
    {
        _S382 = 0.0f;
    }
    return make_float4 (1.0f, _S378, _S379, _S380 - _S382);
}

__device__ float integral_on_top_0(uint family_8, Stretch_0 * across_2, Stretch_0 * along_0, uint crossing_count_0, uint quantity_1)
{
    Family_0 _S383 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint _S384 = uint(_S383.count_0);
    uint _S385 = _S384 + 1U;
    Family_0 _S386 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint _S387 = _S385 * _S386.quantities_0;
    Family_0 _S388 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint _S389 = _S388.colour_areas_0 + quantity_1;
    uint _S390 = (&along_0->low_7)->thread_1;
    uint _S391 = _S389 + (&along_0->low_7)->thread_1 * _S387;
    Family_0 _S392 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint4  _S393 = row_differences_0(across_2, _S391, _S384, _S392.quantities_0);
    uint _S394 = _S389 + (_S390 + 1U) * _S387;
    Family_0 _S395 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint4  _S396 = row_differences_0(across_2, _S394, _S384, _S395.quantities_0);
    uint _S397 = (&along_0->high_7)->thread_1;
    uint _S398 = _S389 + (&along_0->high_7)->thread_1 * _S387;
    Family_0 _S399 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint4  _S400 = row_differences_0(across_2, _S398, _S384, _S399.quantities_0);
    uint _S401 = _S389 + (_S397 + 1U) * _S387;
    Family_0 _S402 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint4  _S403 = row_differences_0(across_2, _S401, _S384, _S402.quantities_0);
    uint _S404 = _S389 + crossing_count_0 * _S387;
    Family_0 _S405 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    uint4  _S406 = row_differences_0(across_2, _S404, _S384, _S405.quantities_0);
    uint4  _S407 = _S400 - _S393;
    bool _S408 = Stretch_wraps_0(along_0);
    uint4  _S409;
    if(_S408)
    {
        _S409 = _S406;
    }
    else
    {
        int4  _S410 = make_int4 (int(0));
        uint4  _S411 = make_uint4 ((uint)_S410.x, (uint)_S410.y, (uint)_S410.z, (uint)_S410.w);
        _S409 = _S411;
    }
    uint4  _S412 = _S407 + _S409;
    float4  _S413 = Stretch_weights_0(across_2);
    float4  _S414 = Stretch_weights_0(along_0);
    int4  _S415 = make_int4 ((int)_S412.x, (int)_S412.y, (int)_S412.z, (int)_S412.w);
    float4  _S416 = make_float4 ((float)_S415.x, (float)_S415.y, (float)_S415.z, (float)_S415.w);
    uint4  _S417 = _S403 - _S400;
    int4  _S418 = make_int4 ((int)_S417.x, (int)_S417.y, (int)_S417.z, (int)_S417.w);
    float4  _S419 = make_float4 ((float)_S418.x, (float)_S418.y, (float)_S418.z, (float)_S418.w);
    uint4  _S420 = _S396 - _S393;
    int4  _S421 = make_int4 ((int)_S420.x, (int)_S420.y, (int)_S420.z, (int)_S420.w);
    float4  _S422 = make_float4 ((float)_S421.x, (float)_S421.y, (float)_S421.z, (float)_S421.w);
    int4  _S423 = make_int4 ((int)_S406.x, (int)_S406.y, (int)_S406.z, (int)_S406.w);
    float4  _S424 = make_float4 ((float)_S423.x, (float)_S423.y, (float)_S423.z, (float)_S423.w);
    float _S425 = dot_0(make_float4 (dot_0(_S416, _S413), dot_0(_S419, _S413), dot_0(_S422, _S413), dot_0(_S424, _S413)), _S414);
    Family_0 _S426 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    return _S425 * _S426.area_unit_0;
}

__device__ Albedos_0 with_added_albedos_0(Albedos_0 * albedos_1, float weight_0, uint row_8)
{
    Albedos_0 _S427 = table_albedos_0(row_8);
    Albedos_0 sum_0;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + make_float3 (weight_0) * _S427.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + make_float3 (weight_0) * _S427.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + make_float3 (weight_0) * _S427.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + make_float3 (weight_0) * _S427.specular_transmit_0;
    return sum_0;
}

__device__ Albedos_0 mean_albedos_0(uint family_9, uint crossing_0, Stretch_0 * own_0, Stretch_0 * other_0, bool back_2)
{
    Family_0 _S428 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    Albedos_0 albedos_2 = table_albedos_0(_S428.colour_mean_0);
    Family_0 _S429 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
    if((_S429.quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3  _S430 = lengths_0(crossing_0, other_0);
    bool is_exposed_0 = false;
    float weight_1 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        Family_0 _S431 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
        if(quantity_2 < (_S431.quantities_0))
        {
        }
        else
        {
            break;
        }
        float2  _S432 = integrals_along_0(family_9, own_0, quantity_2);
        Family_0 _S433 = slang_ldg_2((&(globalParams_0->families_0)[crossing_0]));
        float _S434 = integral_on_top_0(family_9, own_0, other_0, uint(_S433.count_0), quantity_2);
        float _S435 = _S432.x;
        float _S436 = _S435 * _S430.x;
        float _S437;
        if(back_2)
        {
            _S437 = _S436 - _S434;
        }
        else
        {
            _S437 = _S434;
        }
        bool _S438 = quantity_2 == 0U;
        if(_S438)
        {
            Family_0 _S439 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
            float _S440 = 16.0f * _S439.area_unit_0;
            Family_0 _S441 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
            is_exposed_0 = _S437 > (_S440 * (F32_min((_S436 / _S441.crossing_area_0), (1.0f))) + 0.00000999999974738f * _S436);
        }
        float _S442 = _S435 * _S430.y;
        float _S443;
        if(is_exposed_0)
        {
            _S443 = _S437;
        }
        else
        {
            _S443 = 0.0f;
        }
        float _S444 = _S442 + _S443 + 0.000244140625f * _S430.z * _S432.y;
        if(_S438)
        {
            weight_1 = 1.0f / (F32_max((_S444), (9.99999968265522539e-21f)));
        }
        else
        {
            float _S445 = _S444 * weight_1;
            Family_0 _S446 = slang_ldg_2((&(globalParams_0->families_0)[family_9]));
            uint _S447 = _S446.colour_axes_0 + 12U * (quantity_2 - 1U);
            Albedos_0 _S448 = albedos_2;
            Albedos_0 _S449 = with_added_albedos_0(&_S448, _S445, _S447);
            albedos_2 = _S449;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate_1((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate_1((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate_1((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate_1((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

__device__ Albedos_0 tinted_0(Albedos_0 * albedos_3, float3  tint_0)
{
    Albedos_0 result_16 = *albedos_3;
    (&result_16)->diffuse_reflect_0 = (&result_16)->diffuse_reflect_0 * tint_0;
    (&result_16)->diffuse_transmit_0 = (&result_16)->diffuse_transmit_0 * tint_0;
    return result_16;
}

__device__ uint scramble_0(uint value_1)
{
    uint _S450 = value_1 * 747796405U + 2891336453U;
    uint _S451 = ((_S450 >> ((_S450 >> int(28)) + 4U)) ^ _S450) * 277803737U;
    return (_S451 >> int(22)) ^ _S451;
}

__device__ float uniform_hash_0(uint thread_2, uint cell_3, uint stream_0)
{
    return (float((scramble_0(cell_3 + scramble_0(thread_2 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  pixel_sequence_0(uint2  pixel_0, uint index_5, uint stream_1)
{
    uint _S452 = pixel_0.x;
    uint _S453 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S452, _S453, stream_1), uniform_hash_0(_S452, _S453, stream_1 + 1U)) + make_float2 (float(index_5 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f));
}

__device__ float scene_number_0(uint index_6)
{
    uint _S454 = __ldg((&(globalParams_0->scene_words_0)[index_6]));
    return (U32_asfloat((_S454)));
}

struct Choice_0
{
    uint index_7;
    float remainder_0;
};

__device__ Choice_0 choose_0(uint table_0, uint count_3, float number_1)
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
        uint _S455 = (low_8 + high_8) / 2U;
        if((scene_number_0(table_0 + _S455)) <= number_1)
        {
            low_8 = _S455;
        }
        else
        {
            high_8 = _S455;
        }
    }
    uint _S456 = table_0 + low_8;
    float _S457 = scene_number_0(_S456);
    float _S458 = scene_number_0(_S456 + 1U);
    Choice_0 choice_0;
    (&choice_0)->index_7 = low_8;
    (&choice_0)->remainder_0 = saturate_0((number_1 - _S457) / (F32_max((_S458 - _S457), (9.999999960041972e-13f))));
    return choice_0;
}

__device__ float mean_0(float3  colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

__device__ float2  sine_cosine_0(float x_31)
{
    float _S459 = (F32_floor((x_31 * 0.63661974668502808f + 0.5f)));
    float _S460 = x_31 - _S459 * 1.5703125f - _S459 * 0.00048375129699707f - _S459 * 7.54979012640433211e-08f;
    float _S461 = _S460 * _S460;
    float _S462 = ((-0.00019515295571182f * _S461 + 0.00833216123282909f) * _S461 - 0.16666655242443085f) * _S461 * _S460 + _S460;
    float _S463 = ((0.00002443315679557f * _S461 - 0.00138873164542019f) * _S461 + 0.04166664555668831f) * _S461 * _S461 - 0.5f * _S461 + 1.0f;
    uint _S464 = uint(int(_S459)) & 3U;
    float2  _S465;
    if((_S464 & 1U) != 0U)
    {
        _S465 = make_float2 (_S463, _S462);
    }
    else
    {
        _S465 = make_float2 (_S462, _S463);
    }
    float _S466;
    if((_S464 & 2U) != 0U)
    {
        _S466 = - _S465.x;
    }
    else
    {
        _S466 = _S465.x;
    }
    float _S467;
    if(((_S464 + 1U) & 2U) != 0U)
    {
        _S467 = - _S465.y;
    }
    else
    {
        _S467 = _S465.y;
    }
    return make_float2 (_S466, _S467);
}

__device__ Light_0 slang_ldg_3(Light_0 * ptr_3)
{
    uint _S468 = __ldg(&ptr_3->is_point_0);
    float _S469 = __ldg(&ptr_3->x_0);
    float _S470 = __ldg(&ptr_3->y_0);
    float _S471 = __ldg(&ptr_3->z_0);
    float _S472 = __ldg(&ptr_3->red_0);
    float _S473 = __ldg(&ptr_3->green_0);
    float _S474 = __ldg(&ptr_3->blue_0);
    Light_0 _S475 = { _S468, _S469, _S470, _S471, _S472, _S473, _S474 };
    return _S475;
}

__device__ float unmapped_0(float output_9, float scale_0)
{
    return (exponential_0(clamp_1(output_9, 0.0f, 8.0f)) - 1.0f) * scale_0;
}

__device__ uint mirrored_bundle_0(uint bundle_0)
{
    uint _S476 = bundle_0 / 3U;
    uint _S477 = bundle_0 % 3U;
    uint _S478;
    if(bundle_0 == 24U)
    {
        _S478 = bundle_0;
    }
    else
    {
        _S478 = _S476 * 3U + 3U - 1U - _S477;
    }
    return _S478;
}

__device__ float light_visibility_of_0(float diffuse_0, float3  light_0, float3  view_1, float blend_0)
{
    float _S479 = (F32_max(((F32_abs((light_0.z)))), (0.00100000004749745f)));
    float2  _S480 = float2 {light_0.x, light_0.y};
    return 3.14159274101257324f * (F32_max((diffuse_0), (0.0f))) / lerp_0(_S479, (0.59700000286102295f * _S479 + 0.16599999368190765f) * (0.21600000560283661f * (dot_2(_S480, float2 {view_1.x, view_1.y}) * (F32_rsqrt(((F32_max((dot_2(_S480, _S480)), (9.99999997475242708e-07f))))))) + 1.0f), blend_0);
}

__device__ float sheen_scale_0(float x_32, float y_13)
{
    return (((((0.0f * x_32 + (((((-1.1402510404586792f * y_13 + 0.40672621130943298f) * y_13 + 1.65398800373077393f) * y_13 + -1.29730904102325439f) * y_13 + 0.30570998787879944f) * y_13 + -0.0220868494361639f)) * x_32 + (((((-0.21142719686031342f * y_13 + 1.05947399139404297f) * y_13 + -0.41116121411323547f) * y_13 + -0.93859231472015381f) * y_13 + 0.51606941223144531f) * y_13 + 0.05409301072359085f)) * x_32 + (((((1.22944498062133789f * y_13 + -0.45962560176849365f) * y_13 + -1.63861405849456787f) * y_13 + 1.33565104007720947f) * y_13 + -0.45725581049919128f) * y_13 + 0.08243165910243988f)) * x_32 + (((((0.39779931306838989f * y_13 + -1.18879103660583496f) * y_13 + 0.28251591324806213f) * y_13 + 1.168984055519104f) * y_13 + -0.76864629983901978f) * y_13 + 0.0091691892594099f)) * x_32 + (((((-0.26563560962677002f * y_13 + -0.19379159808158875f) * y_13 + 0.2677634060382843f) * y_13 + 0.00270519289188087f) * y_13 + 0.14349560439586639f) * y_13 + 0.10290180146694183f)) * x_32 + (((((-0.20701569318771362f * y_13 + 0.24526430666446686f) * y_13 + 0.19551840424537659f) * y_13 + 0.07586126774549484f) * y_13 + 0.38894739747047424f) * y_13 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_33, float y_14)
{
    return ((((0.0f * x_33 + (((((-0.10608240216970444f * y_14 + 1.99214303493499756f) * y_14 + -1.42255294322967529f) * y_14 + -1.09495604038238525f) * y_14 + 0.59180057048797607f) * y_14 + 0.06902855634689331f)) * x_33 + (((((-0.46220690011978149f * y_14 + -0.29113379120826721f) * y_14 + 1.39025199413299561f) * y_14 + 0.35589990019798279f) * y_14 + -1.17120099067687988f) * y_14 + 0.15940259397029877f)) * x_33 + (((((2.26068711280822754f * y_14 + -3.64728999137878418f) * y_14 + -0.72173482179641724f) * y_14 + 3.07659196853637695f) * y_14 + -0.6827620267868042f) * y_14 + -0.3039557933807373f)) * x_33 + (((((0.81201767921447754f * y_14 + 0.36014080047607422f) * y_14 + -1.72646903991699219f) * y_14 + -0.22630110383033752f) * y_14 + 0.89514690637588501f) * y_14 + -0.10397960245609283f)) * x_33 + (((((-0.37648698687553406f * y_14 + 1.10974001884460449f) * y_14 + 0.17824520170688629f) * y_14 + -1.04968702793121338f) * y_14 + 0.1461234986782074f) * y_14 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_34, float y_15)
{
    return ((((0.0f * x_34 + (((((12.95646953582763672f * y_15 + -21.38032913208007812f) * y_15 + -7.37853097915649414f) * y_15 + 34.55607986450195312f) * y_15 + -23.61347007751464844f) * y_15 + 5.00126314163208008f)) * x_34 + (((((10.91487026214599609f * y_15 + -6.08202791213989258f) * y_15 + -38.2036285400390625f) * y_15 + 53.3440399169921875f) * y_15 + -21.91996002197265625f) * y_15 + 2.01606011390686035f)) * x_34 + (((((-14.52206039428710938f * y_15 + 36.803619384765625f) * y_15 + -22.94047927856445312f) * y_15 + -10.07973003387451172f) * y_15 + 15.77003955841064453f) * y_15 + -4.92722177505493164f)) * x_34 + (((((-7.62505722045898438f * y_15 + 1.27310299873352051f) * y_15 + 31.19523048400878906f) * y_15 + -44.39989852905273438f) * y_15 + 26.44947052001953125f) * y_15 + -8.73507976531982422f)) * x_34 + (((((5.65633487701416016f * y_15 + -17.66820907592773438f) * y_15 + 24.65356063842773438f) * y_15 + -19.38941001892089844f) * y_15 + 11.06159019470214844f) * y_15 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S481 = clamp_1(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S482 = 2.0f * (F32_sqrt((_S481))) - 1.0f;
    float _S483 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_1(roughness_1, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_1(sheen_scale_0(_S482, _S483), 0.00999999977648258f, 1.0f), clamp_1((1.0f - _S481) * sheen_shear_0(_S482, _S483), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_1(sheen_reflectance_0(_S482, _S483), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_1, float3  view_2, float scale_1, float shear_0)
{
    float _S484 = light_1.z;
    bool _S485;
    if(_S484 <= 0.0f)
    {
        _S485 = true;
    }
    else
    {
        _S485 = (view_2.z) <= 0.0f;
    }
    if(_S485)
    {
        return 0.0f;
    }
    float2  _S486 = float2 {view_2.x, view_2.y};
    float _S487 = dot_2(_S486, _S486);
    float2  _S488;
    if(_S487 > 9.99999968265522539e-21f)
    {
        _S488 = _S486 * make_float2 ((F32_rsqrt((_S487))));
    }
    else
    {
        _S488 = make_float2 (1.0f, 0.0f);
    }
    float _S489 = scale_1 * dot_2(float2 {light_1.x, light_1.y}, _S488) + shear_0 * _S484;
    float _S490 = scale_1 * (light_1.y * _S488.x - light_1.x * _S488.y);
    float _S491 = _S489 * _S489 + _S490 * _S490 + _S484 * _S484;
    return 0.31830987334251404f * scale_1 * scale_1 * _S484 / (F32_max((_S491 * _S491), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_2, float3  view_3, float strength_0, float roughness_2)
{
    float3  _S492 = sheen_lobe_0(view_3.z, roughness_2);
    float _S493 = strength_0 * _S492.z;
    return make_float2 (_S493 * transformed_cosine_0(light_2, view_3, _S492.x, _S492.y), 1.0f - _S493);
}

__device__ void accumulate_0(uint index_8, float4  light_3)
{
    float4  * _S494 = (&(globalParams_0->radiance_0)[index_8]);
    *_S494 = *_S494 + make_float4 ((&(globalParams_0->layers_0)[index_8])->share_0) * light_3;
    (&(globalParams_0->layers_0)[index_8])->share_0 = (&(globalParams_0->layers_0)[index_8])->share_0 * (1.0f - light_3.w);
    return;
}

__device__ float3  camera_right_0(int _S495)
{
    Frame_0 * _S496 = (&(globalParams_0->frames_0)[_S495]);
    float _S497 = __ldg(&_S496->right_x_0);
    float _S498 = __ldg(&_S496->right_y_0);
    float _S499 = __ldg(&_S496->right_z_0);
    return make_float3 (_S497, _S498, _S499);
}

__device__ float3  camera_up_0(int _S500)
{
    Frame_0 * _S501 = (&(globalParams_0->frames_0)[_S500]);
    float _S502 = __ldg(&_S501->up_x_0);
    float _S503 = __ldg(&_S501->up_y_0);
    float _S504 = __ldg(&_S501->up_z_0);
    return make_float3 (_S502, _S503, _S504);
}

__device__ float3  camera_forward_0(int _S505)
{
    Frame_0 * _S506 = (&(globalParams_0->frames_0)[_S505]);
    float _S507 = __ldg(&_S506->forward_x_0);
    float _S508 = __ldg(&_S506->forward_y_0);
    float _S509 = __ldg(&_S506->forward_z_0);
    return make_float3 (_S507, _S508, _S509);
}

__device__ float3  camera_origin_0(int _S510)
{
    Frame_0 * _S511 = (&(globalParams_0->frames_0)[_S510]);
    float _S512 = __ldg(&_S511->origin_x_0);
    float _S513 = __ldg(&_S511->origin_y_0);
    float _S514 = __ldg(&_S511->origin_z_0);
    return make_float3 (_S512, _S513, _S514);
}

__device__ VisiblePoint_0 face_point_0(uint _S515, uint _S516, float _S517, float _S518)
{
    Fabric_0 * _S519 = (&(globalParams_0->fabrics_0)[_S515]);
    uint _S520 = 3U * _S516;
    uint _S521 = __ldg((&(globalParams_0->corners_0)[_S520]));
    Vertex_0 _S522 = slang_ldg_1((&(globalParams_0->vertices_0)[_S521]));
    uint _S523 = __ldg((&(globalParams_0->corners_0)[_S520 + 1U]));
    Vertex_0 _S524 = slang_ldg_1((&(globalParams_0->vertices_0)[_S523]));
    uint _S525 = __ldg((&(globalParams_0->corners_0)[_S520 + 2U]));
    Vertex_0 _S526 = slang_ldg_1((&(globalParams_0->vertices_0)[_S525]));
    Vertex_0 _S527 = _S524;
    float3  _S528 = position_of_0(&_S527);
    Vertex_0 _S529 = _S522;
    float3  _S530 = position_of_0(&_S529);
    float3  _S531 = _S528 - _S530;
    Vertex_0 _S532 = _S526;
    float3  _S533 = position_of_0(&_S532);
    float3  _S534 = _S533 - _S530;
    float _S535 = _S524.u_0 - _S522.u_0;
    float _S536 = _S524.v_0 - _S522.v_0;
    float2  _S537 = make_float2 (_S535, _S536);
    float _S538 = _S526.u_0 - _S522.u_0;
    float _S539 = _S526.v_0 - _S522.v_0;
    float2  _S540 = make_float2 (_S538, _S539);
    float _S541;
    if((_S535 * _S539 - _S536 * _S538) < 0.0f)
    {
        _S541 = -1.0f;
    }
    else
    {
        _S541 = 1.0f;
    }
    float3  _S542 = make_float3 (_S541) * (make_float3 (_S539) * _S531 - make_float3 (_S536) * _S534);
    float3  _S543 = make_float3 (_S541) * (make_float3 (_S535) * _S534 - make_float3 (_S538) * _S531);
    VisiblePoint_0 point_1;
    float _S544 = 1.0f - _S517 - _S518;
    Vertex_0 _S545 = _S522;
    float3  _S546 = normal_of_0(&_S545);
    float3  _S547 = make_float3 (_S544) * _S546;
    Vertex_0 _S548 = _S524;
    float3  _S549 = normal_of_0(&_S548);
    float3  _S550 = _S547 + make_float3 (_S517) * _S549;
    Vertex_0 _S551 = _S526;
    float3  _S552 = normal_of_0(&_S551);
    float3  _S553 = normalize_0(_S550 + make_float3 (_S518) * _S552);
    (&point_1)->normal_0 = _S553;
    float3  _S554 = normalize_0(_S542 - _S553 * make_float3 (dot_1(_S553, _S542)));
    (&point_1)->axis_x_0 = _S554;
    (&point_1)->axis_y_0 = cross_0(_S553, _S554);
    float3  _S555 = normalize_0(cross_0(_S531, _S534));
    float3  _S556;
    if((dot_1(_S555, _S553)) < 0.0f)
    {
        _S556 = - _S555;
    }
    else
    {
        _S556 = _S555;
    }
    (&point_1)->face_normal_0 = _S556;
    (&point_1)->position_0 = _S530 + make_float3 (_S517) * _S531 + make_float3 (_S518) * _S534;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_1 = make_float2 (_S522.u_0, _S522.v_0) + make_float2 (_S517) * _S537 + make_float2 (_S518) * _S540;
    bool _S557 = (dot_1(cross_0(_S542, _S543), (&point_1)->normal_0)) < 0.0f;
    float _S558 = __ldg(&_S519->uv_width_0);
    if(_S557)
    {
        float _S559 = __ldg(&_S519->uv_height_0);
        _S541 = - _S559;
    }
    else
    {
        float _S560 = __ldg(&_S519->uv_height_0);
        _S541 = _S560;
    }
    float2  _S561 = make_float2 (_S558, _S541);
    (&point_1)->draft_per_uv_0 = _S561;
    float2  _S562 = (&point_1)->uv_1 * _S561;
    if(_S557)
    {
        float _S563 = __ldg(&_S519->uv_height_0);
        _S541 = _S563;
    }
    else
    {
        _S541 = 0.0f;
    }
    (&point_1)->draft_0 = _S562 + make_float2 (0.0f, _S541);
    float2  _S564 = make_float2 (0.0f);
    (&point_1)->draft_dx_0 = _S564;
    (&point_1)->draft_dy_0 = _S564;
    return point_1;
}

__device__ VisiblePoint_0 visible_point_0(int _S565, uint _S566, uint _S567, uint2  _S568)
{
    Frame_0 * _S569 = (&(globalParams_0->frames_0)[_S565]);
    uint _S570 = 3U * _S567;
    uint _S571 = __ldg((&(globalParams_0->corners_0)[_S570]));
    Vertex_0 _S572 = slang_ldg_1((&(globalParams_0->vertices_0)[_S571]));
    uint _S573 = __ldg((&(globalParams_0->corners_0)[_S570 + 1U]));
    Vertex_0 _S574 = slang_ldg_1((&(globalParams_0->vertices_0)[_S573]));
    uint _S575 = __ldg((&(globalParams_0->corners_0)[_S570 + 2U]));
    Vertex_0 _S576 = slang_ldg_1((&(globalParams_0->vertices_0)[_S575]));
    Vertex_0 _S577 = _S574;
    float3  _S578 = position_of_0(&_S577);
    Vertex_0 _S579 = _S572;
    float3  _S580 = position_of_0(&_S579);
    float3  _S581 = _S578 - _S580;
    Vertex_0 _S582 = _S576;
    float3  _S583 = position_of_0(&_S582);
    float3  _S584 = _S583 - _S580;
    float3  _S585 = cross_0(_S581, _S584);
    float _S586 = 1.0f / (F32_max((square_0(_S585)), (1.00000000317107685e-30f)));
    float3  _S587 = camera_right_0(_S565);
    uint _S588 = __ldg(&_S569->width_0);
    float _S589 = float(_S588);
    float3  _S590 = _S587 * make_float3 (2.0f / _S589);
    float3  _S591 = camera_up_0(_S565);
    uint _S592 = __ldg(&_S569->height_0);
    float _S593 = float(_S592);
    float3  _S594 = _S591 * make_float3 (-2.0f / _S593);
    float _S595 = float(_S568.x) + 0.5f - 0.5f * _S589;
    float _S596 = float(_S568.y) + 0.5f - 0.5f * _S593;
    float3  _S597 = camera_forward_0(_S565);
    float3  _S598 = _S597 + make_float3 (_S595) * _S590 + make_float3 (_S596) * _S594;
    float _S599 = dot_1(_S598, _S585);
    float _S600;
    if((F32_abs((_S599))) > 1.00000000317107685e-30f)
    {
        _S600 = _S599;
    }
    else
    {
        _S600 = 1.00000000317107685e-30f;
    }
    float _S601 = 1.0f / _S600;
    float3  _S602 = camera_origin_0(_S565);
    float3  _S603 = _S580 - _S602;
    float _S604 = dot_1(_S603, _S585) * _S601;
    float3  _S605 = _S598 * make_float3 (_S604) - _S603;
    float3  _S606 = make_float3 (_S604) * (_S590 - _S598 * make_float3 (dot_1(_S590, _S585) * _S601));
    float3  _S607 = make_float3 (_S604) * (_S594 - _S598 * make_float3 (dot_1(_S594, _S585) * _S601));
    float3  _S608 = cross_0(_S584, _S585) * make_float3 (_S586);
    float3  _S609 = cross_0(_S585, _S581) * make_float3 (_S586);
    float2  _S610 = make_float2 (_S574.u_0 - _S572.u_0, _S574.v_0 - _S572.v_0);
    float2  _S611 = make_float2 (_S576.u_0 - _S572.u_0, _S576.v_0 - _S572.v_0);
    VisiblePoint_0 _S612 = face_point_0(_S566, _S567, dot_1(_S605, _S608), dot_1(_S605, _S609));
    VisiblePoint_0 point_2 = _S612;
    (&point_2)->position_0 = _S580 + _S605;
    (&point_2)->view_0 = - normalize_0(_S598);
    (&point_2)->draft_dx_0 = (make_float2 (dot_1(_S606, _S608)) * _S610 + make_float2 (dot_1(_S606, _S609)) * _S611) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (make_float2 (dot_1(_S607, _S608)) * _S610 + make_float2 (dot_1(_S607, _S609)) * _S611) * (&point_2)->draft_per_uv_0;
    return point_2;
}

__device__ float3  filtered_albedo_0(uint _S613, VisiblePoint_0 * _S614)
{
    Fabric_0 * _S615 = (&(globalParams_0->fabrics_0)[_S613]);
    uint _S616 = __ldg(&_S615->albedo_map_levels_0);
    if(_S616 == 0U)
    {
        return make_float3 (1.0f);
    }
    float _S617 = __ldg(&_S615->uv_width_0);
    float _S618 = __ldg(&_S615->uv_height_0);
    float2  _S619 = make_float2 (_S617, _S618);
    float2  _S620 = _S614->draft_dx_0 / _S619;
    float2  _S621 = _S614->draft_dy_0 / _S619;
    uint _S622 = _S616 - 1U;
    uint _S623 = 1U << _S622;
    float _S624 = clamp_1(0.5f * binary_logarithm_0((F32_max(((F32_abs((_S620.x * _S621.y - _S620.y * _S621.x)))), (9.99999968265522539e-21f))) * (square_1(float(_S623)) / 3.0f)), 0.0f, float(_S616) - 1.0f);
    uint _S625 = (U32_min((uint(_S624)), ((U32_max((_S616), (2U))) - 2U)));
    uint _S626 = (U32_min((_S625 + 1U), (_S622)));
    uint _S627 = 1U << (2U * _S616);
    uint _S628 = __ldg(&_S615->albedo_map_0);
    return lerp_2(map_level_0(_S628 + (_S627 - (_S627 >> (2U * _S625))) / 3U, _S623 >> _S625, _S614->uv_1), map_level_0(_S628 + (_S627 - (_S627 >> (2U * _S626))) / 3U, _S623 >> _S626, _S614->uv_1), make_float3 ((exponential_0(1.38629436492919922f * (_S624 - float(_S625))) - 1.0f) / 3.0f));
}

struct WovenView_0
{
    FixedArray<float, 96>  sums_6;
    float hole_0;
    float correction_weight_0;
    float3  view_4;
    bool back_3;
};

__device__ AnisotropicTaps_0 anisotropic_taps_0(uint _S629, Footprint_0 * _S630)
{
    Fabric_0 * _S631 = (&(globalParams_0->fabrics_0)[_S629]);
    float3  _S632 = row_of_taps_0(_S630);
    float2  _S633 = _S630->dx_0;
    float2  _S634 = _S630->dy_0;
    float _S635 = dot_2(_S630->dx_0, _S630->dx_0) + dot_2(_S630->dy_0, _S630->dy_0);
    float _S636 = _S630->dx_0.x * _S630->dy_0.y - _S630->dx_0.y * _S630->dy_0.x;
    float _S637 = 0.5f * (_S635 + (F32_sqrt(((F32_max((_S635 * _S635 - 4.0f * _S636 * _S636), (0.0f)))))));
    Woven_0 _S638 = slang_ldg_0(&_S631->woven_0);
    bool _S639;
    if(_S637 < (5.5f * (_S635 - _S637)))
    {
        _S639 = _S635 > (8.0f * _S638.pitch_0 * _S638.pitch_0);
    }
    else
    {
        _S639 = false;
    }
    float2  _S640 = make_float2 (_S638.ends_per_mm_0, _S638.picks_per_mm_0);
    AnisotropicTaps_0 taps_1;
    (&taps_1)->centre_1 = _S630->centre_0 * _S640;
    float _S641;
    if(_S639)
    {
        _S641 = (F32_sqrt((0.125f * _S635)));
    }
    else
    {
        _S641 = _S632.x;
    }
    (&taps_1)->side_1 = _S641 / _S638.pitch_0;
    float2  _S642;
    if(_S639)
    {
        _S642 = make_float2 (0.25f) * _S633;
    }
    else
    {
        _S642 = float2 {_S632.y, _S632.z};
    }
    (&taps_1)->first_20 = _S642 * _S640;
    if(_S639)
    {
        _S642 = make_float2 (0.25f) * _S634;
    }
    else
    {
        _S642 = make_float2 (0.5f) * float2 {_S632.y, _S632.z};
    }
    (&taps_1)->second_0 = _S642 * _S640;
    return taps_1;
}

__device__ void add_texel_0(uint _S643, uint _S644, float _S645, FixedArray<float, 88>  * _S646)
{
    Woven_0 _S647 = slang_ldg_0(&(&(globalParams_0->fabrics_0)[_S643])->woven_0);
    uint _S648 = _S647.latents_0 + _S644 * 8U;
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
        uint4  _S649 = __ldg((&(globalParams_0->packed_numbers_0)[_S648 + part_0]));
        Eight_0 _S650 = eight_halves_0(_S649);
        int _S651 = int(8U * part_0);
        (*_S646)[_S651] = (*_S646)[_S651] + _S645 * _S650.low_0.x;
        (*_S646)[_S651 + int(4)] = (*_S646)[_S651 + int(4)] + _S645 * _S650.high_0.x;
        int _S652 = _S651 + int(1);
        (*_S646)[_S652] = (*_S646)[_S652] + _S645 * _S650.low_0.y;
        (*_S646)[_S652 + int(4)] = (*_S646)[_S652 + int(4)] + _S645 * _S650.high_0.y;
        int _S653 = _S651 + int(2);
        (*_S646)[_S653] = (*_S646)[_S653] + _S645 * _S650.low_0.z;
        (*_S646)[_S653 + int(4)] = (*_S646)[_S653 + int(4)] + _S645 * _S650.high_0.z;
        int _S654 = _S651 + int(3);
        (*_S646)[_S654] = (*_S646)[_S654] + _S645 * _S650.low_0.w;
        (*_S646)[_S654 + int(4)] = (*_S646)[_S654 + int(4)] + _S645 * _S650.high_0.w;
        part_0 = part_0 + 1U;
    }
    return;
}

__device__ void add_level_0(uint _S655, uint _S656, bool _S657, float2  _S658, float _S659, FixedArray<float, 88>  * _S660)
{
    Woven_0 _S661 = slang_ldg_0(&(&(globalParams_0->fabrics_0)[_S655])->woven_0);
    uint _S662 = _S661.levels_1 + 4U * _S656;
    float _S663 = table_number_0(_S662);
    float _S664 = table_number_0(_S662 + 1U);
    float _S665 = table_number_0(_S662 + 2U);
    bool _S666;
    if(_S656 > 3U)
    {
        _S666 = _S656 < (_S661.top_level_0);
    }
    else
    {
        _S666 = false;
    }
    float2  _S667 = _S658 * make_float2 (table_number_0(_S662 + 3U));
    float _S668;
    if(_S666)
    {
        _S668 = 1.0f;
    }
    else
    {
        _S668 = 0.5f;
    }
    float2  _S669 = _S667 - make_float2 (_S668);
    float2  _S670 = floor_0(_S669);
    float2  _S671 = _S669 - _S670;
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
        float _S672 = float(corner_0 & 1U);
        float _S673 = float(corner_0 >> int(1));
        float2  _S674 = lerp_1(make_float2 (1.0f) - _S671, _S671, make_float2 (_S672, _S673));
        uint _S675 = uint(_S663 + wrapped_0(_S670.y + _S673, _S665) * _S664 + wrapped_0(_S670.x + _S672, _S664));
        uint _S676;
        if(_S657)
        {
            _S676 = _S661.texels_0;
        }
        else
        {
            _S676 = 0U;
        }
        add_texel_0(_S655, _S675 + _S676, _S659 * _S674.x * _S674.y, _S660);
        corner_0 = corner_0 + 1U;
    }
    return;
}

__device__ void code_footprint_0(uint _S677, AnisotropicTaps_0 * _S678, float3  _S679, bool _S680, FixedArray<float, 88>  * _S681)
{
    float offset_1;
    Fabric_0 * _S682 = (&(globalParams_0->fabrics_0)[_S677]);
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
        (*_S681)[k_0] = 0.0f;
        k_0 = k_0 + int(1);
    }
    Woven_0 _S683 = slang_ldg_0(&_S682->woven_0);
    float2  _S684 = make_float2 (_S683.ends_0, _S683.picks_0);
    float _S685 = float(_S683.top_level_0);
    float _S686 = clamp_1(binary_logarithm_0((F32_max((_S678->side_1), (9.99999997475242708e-07f)))) + 3.0f, 0.0f, _S685);
    float _S687 = (F32_min(((F32_floor((_S686)))), (_S685 - 1.0f)));
    bool _S688 = AnisotropicTaps_has_steps_0(_S678);
    uint _S689;
    if(_S688)
    {
        _S689 = 4U;
    }
    else
    {
        _S689 = 1U;
    }
    uint number_2 = 0U;
    for(;;)
    {
        if(number_2 < (2U * _S689))
        {
        }
        else
        {
            break;
        }
        float2  _S690 = AnisotropicTaps_place_0(_S678, number_2 >> int(1));
        float2  _S691 = clamp_2(_S690 - _S684 * floor_0(_S690 / _S684), make_float2 (0.0f), _S684);
        bool _S692 = (number_2 & 1U) != 0U;
        if(_S692)
        {
            offset_1 = _S686 - _S687;
        }
        else
        {
            offset_1 = 1.0f - (_S686 - _S687);
        }
        float _S693 = offset_1 / float(_S689);
        uint _S694 = uint(_S687);
        uint _S695;
        if(_S692)
        {
            _S695 = 1U;
        }
        else
        {
            _S695 = 0U;
        }
        add_level_0(_S677, _S694 + _S695, _S680, _S691, _S693, _S681);
        number_2 = number_2 + 1U;
    }
    int number_3 = int(0);
    for(;;)
    {
        if(number_3 < int(3))
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
            float offset_2 = _slang_vector_get_element(_S679, number_3) - (float(bin_0) + 0.5f) / 8.0f;
            if(number_3 < int(2))
            {
                offset_1 = offset_2 - (F32_round((offset_2)));
            }
            else
            {
                offset_1 = offset_2;
            }
            (*_S681)[int(64) + number_3 * int(8) + bin_0] = bump_0(offset_1 * 3.20000004768371582f);
            bin_0 = bin_0 + int(1);
        }
        number_3 = number_3 + int(1);
    }
    return;
}

__device__ float3  crown_fibres_0(uint _S696, bool _S697, bool _S698)
{
    Fabric_0 * _S699 = (&(globalParams_0->fabrics_0)[_S696]);
    float _S700;
    if(_S697)
    {
        if(_S698)
        {
            Woven_0 _S701 = slang_ldg_0(&_S699->woven_0);
            _S700 = - _S701.warp_x_0;
        }
        else
        {
            Woven_0 _S702 = slang_ldg_0(&_S699->woven_0);
            _S700 = _S702.warp_x_0;
        }
        Woven_0 _S703 = slang_ldg_0(&_S699->woven_0);
        return make_float3 (_S700, _S703.warp_y_0, _S703.warp_roughness_0);
    }
    Woven_0 _S704 = slang_ldg_0(&_S699->woven_0);
    if(_S698)
    {
        _S700 = - _S704.weft_y_0;
    }
    else
    {
        _S700 = _S704.weft_y_0;
    }
    return make_float3 (_S704.weft_x_0, _S700, _S704.weft_roughness_0);
}

__device__ void woven_view_0(uint _S705, Footprint_0 * _S706, float3  _S707, WovenView_0 * _S708)
{
    Fabric_0 * _S709 = (&(globalParams_0->fabrics_0)[_S705]);
    bool _S710 = (_S707.z) < 0.0f;
    AnisotropicTaps_0 _S711 = anisotropic_taps_0(_S705, _S706);
    AnisotropicTaps_0 _S712 = _S711;
    float3  _S713 = footprint_coordinates_0(&_S712);
    float3  _S714 = to_face_frame_0(_S707, _S710);
    HalfWeights_0 weights_23;
    Woven_0 _S715 = slang_ldg_0(&_S709->woven_0);
    (&weights_23)->first_2 = _S715.network_0;
    AnisotropicTaps_0 _S716 = _S711;
    FixedArray<float, 88>  inputs_23;
    code_footprint_0(_S705, &_S716, _S713, _S710, &inputs_23);
    HalfWeights_0 _S717 = weights_23;
    FixedArray<float, 96>  hidden_0;
    dense_7(&_S717, 0U, false, &inputs_23, &hidden_0);
    HalfWeights_0 _S718 = weights_23;
    FixedArray<float, 100>  fused_0;
    dense_part_8(&_S718, 1068U, false, &hidden_0, &fused_0);
    fused_0[int(96)] = _S714.x;
    fused_0[int(97)] = _S714.y;
    float3  _S719 = crown_fibres_0(_S705, true, _S710);
    float2  _S720 = float2 {_S714.x, _S714.y};
    fused_0[int(98)] = dot_2(float2 {_S719.x, _S719.y}, _S720);
    float3  _S721 = crown_fibres_0(_S705, false, _S710);
    fused_0[int(99)] = dot_2(float2 {_S721.x, _S721.y}, _S720);
    HalfWeights_0 _S722 = weights_23;
    FixedArray<float, 16>  of_hole_0;
    dense_6(&_S722, 2232U, false, &fused_0, &of_hole_0);
    HalfWeights_0 _S723 = weights_23;
    FixedArray<float, 1>  hole_1;
    dense_5(&_S723, 2444U, false, &of_hole_0, &hole_1);
    HalfWeights_0 _S724 = weights_23;
    dense_4(&_S724, 2456U, false, &fused_0, &_S708->sums_6);
    _S708->hole_0 = clamp_1(hole_1[int(0)], 0.0f, 1.0f);
    _S708->correction_weight_0 = correction_weight_of_0(_S713.z);
    _S708->view_4 = _S714;
    _S708->back_3 = _S710;
    return;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_1;
    Albedos_0 weft_1;
};

__device__ FamilyAlbedos_0 albedos_over_0(uint _S725, Footprint_0 * _S726, bool _S727)
{
    Fabric_0 * _S728 = (&(globalParams_0->fabrics_0)[_S725]);
    float2  _S729 = sqrt_0(_S726->dx_0 * _S726->dx_0 + _S726->dy_0 * _S726->dy_0);
    uint _S730 = __ldg(&_S728->warp_0);
    float2  _S731 = _S726->centre_0;
    Stretch_0 _S732 = stretch_of_0(_S730, _S726->centre_0.x, _S729.x);
    uint _S733 = __ldg(&_S728->weft_0);
    Stretch_0 _S734 = stretch_of_0(_S733, _S731.y, _S729.y);
    FamilyAlbedos_0 albedos_4;
    Stretch_0 _S735 = _S732;
    Stretch_0 _S736 = _S734;
    Albedos_0 _S737 = mean_albedos_0(_S730, _S733, &_S735, &_S736, _S727);
    (&albedos_4)->warp_1 = _S737;
    Stretch_0 _S738 = _S734;
    Stretch_0 _S739 = _S732;
    Albedos_0 _S740 = mean_albedos_0(_S733, _S730, &_S738, &_S739, _S727);
    (&albedos_4)->weft_1 = _S740;
    return albedos_4;
}

__device__ uint light_sample_count_0(int _S741)
{
    Frame_0 * _S742 = (&(globalParams_0->frames_0)[_S741]);
    uint _S743 = __ldg(&_S742->lights_0);
    uint _S744 = __ldg(&_S742->environment_samples_0);
    return _S743 + _S744;
}

__device__ float visibility_at_0(int _S745, uint _S746, uint2  _S747)
{
    Frame_0 * _S748 = (&(globalParams_0->frames_0)[_S745]);
    uint _S749 = __ldg(&_S748->casts_shadows_0);
    if(_S749 == 0U)
    {
        return 1.0f;
    }
    uint _S750 = __ldg(&_S748->height_0);
    uint _S751 = _S746 * _S750 + _S747.y;
    uint _S752 = __ldg(&_S748->width_0);
    return *(&(globalParams_0->visibilities_0)[_S751 * _S752 + _S747.x]);
}

struct LightSample_0
{
    float3  towards_0;
    float3  irradiance_1;
    float distance_1;
};

__device__ float3  environment_texel_0(int _S753, uint _S754, uint _S755)
{
    Frame_0 * _S756 = (&(globalParams_0->frames_0)[_S753]);
    uint _S757 = __ldg(&_S756->environment_table_0);
    uint _S758 = __ldg(&_S756->environment_rows_0);
    uint _S759 = _S757 + _S758 + 1U;
    uint _S760 = __ldg(&_S756->environment_columns_0);
    uint _S761 = _S759 + _S758 * (_S760 + 1U) + 3U * (_S754 * _S760 + _S755);
    return make_float3 (scene_number_0(_S761), scene_number_0(_S761 + 1U), scene_number_0(_S761 + 2U));
}

__device__ float3  sample_environment_0(int _S762, float2  _S763, float3  * _S764)
{
    Frame_0 * _S765 = (&(globalParams_0->frames_0)[_S762]);
    uint _S766 = __ldg(&_S765->environment_table_0);
    uint _S767 = __ldg(&_S765->environment_rows_0);
    Choice_0 _S768 = choose_0(_S766, _S767, _S763.y);
    uint _S769 = _S766 + _S767 + 1U;
    uint _S770 = __ldg(&_S765->environment_columns_0);
    Choice_0 _S771 = choose_0(_S769 + _S768.index_7 * (_S770 + 1U), _S770, _S763.x);
    float3  _S772 = environment_texel_0(_S762, _S768.index_7, _S771.index_7);
    float _S773 = __ldg(&_S765->environment_total_0);
    *_S764 = _S772 * make_float3 (_S773 / (F32_max((mean_0(_S772)), (9.99999968265522539e-21f))));
    float _S774 = 3.14159274101257324f / float(_S767);
    float _S775 = lerp_0(sine_cosine_0(float(_S768.index_7) * _S774).y, sine_cosine_0(float(_S768.index_7 + 1U) * _S774).y, _S768.remainder_0);
    float _S776 = (F32_sqrt(((F32_max((1.0f - _S775 * _S775), (0.0f))))));
    float2  _S777 = sine_cosine_0((float(_S771.index_7) + _S771.remainder_0) * (6.28318548202514648f / float(_S770)));
    float _S778 = _S776 * _S777.x;
    float _S779 = - _S776 * _S777.y;
    float _S780 = __ldg(&_S765->environment_cosine_0);
    float _S781 = _S780 * _S778;
    float _S782 = __ldg(&_S765->environment_sine_0);
    return make_float3 (_S781 + _S782 * _S779, _S775, _S780 * _S779 - _S782 * _S778);
}

__device__ LightSample_0 light_sample_0(int _S783, uint _S784, uint2  _S785, float3  _S786)
{
    Frame_0 * _S787 = (&(globalParams_0->frames_0)[_S783]);
    LightSample_0 sample_0;
    (&sample_0)->distance_1 = 1.00000001504746622e+30f;
    uint _S788 = __ldg(&_S787->lights_0);
    if(_S784 >= _S788)
    {
        uint _S789 = __ldg(&_S787->pass_number_0);
        uint _S790 = __ldg(&_S787->environment_samples_0);
        float3  weight_2;
        float3  _S791 = sample_environment_0(_S783, pixel_sequence_0(_S785, _S789 * _S790 + (_S784 - _S788), 3U), &weight_2);
        (&sample_0)->towards_0 = _S791;
        (&sample_0)->irradiance_1 = weight_2 / make_float3 (float(_S790));
        return sample_0;
    }
    Light_0 _S792 = slang_ldg_3((&(globalParams_0->lights_1)[_S784]));
    (&sample_0)->irradiance_1 = make_float3 (_S792.red_0, _S792.green_0, _S792.blue_0);
    (&sample_0)->towards_0 = make_float3 (_S792.x_0, _S792.y_0, _S792.z_0);
    if((_S792.is_point_0) != 0U)
    {
        float3  _S793 = (&sample_0)->towards_0 - _S786;
        float _S794 = (F32_max((square_0(_S793)), (9.999999960041972e-13f)));
        (&sample_0)->distance_1 = (F32_sqrt((_S794)));
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / make_float3 (_S794);
        (&sample_0)->towards_0 = normalize_0(_S793);
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

__device__ void code_light_0(uint _S795, float3  _S796, float3  _S797, bool _S798, FixedArray<float, 39>  * _S799)
{
    (*_S799)[int(0)] = _S796.x;
    (*_S799)[int(1)] = _S796.y;
    (*_S799)[int(2)] = _S796.z;
    float3  _S800 = _S796 + _S797;
    float _S801 = _S800.z;
    float _S802 = _S801 * _S801 + 0.00009999999747379f;
    float2  _S803 = float2 {_S800.x, _S800.y};
    float _S804 = 1.0f / (dot_2(_S803, _S803) + _S802);
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
        float3  _S805 = crown_fibres_0(_S795, family_10 == int(0), _S798);
        float2  _S806 = float2 {_S805.x, _S805.y};
        (*_S799)[int(3) + family_10] = dot_2(_S806, float2 {_S796.x, _S796.y});
        float _S807 = dot_2(_S806, _S803);
        float _S808 = _S807 * _S807;
        float _S809 = (0.75f * _S807 / (0.5f * (F32_sqrt((_S808 + _S802))) + (F32_abs((_S807)))) + 0.5f) * 8.0f;
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
            (*_S799)[int(5) + family_10 * int(16) + bin_1] = bump_0(_S809 - (float(bin_1) + 0.5f) / 2.0f);
            bin_1 = bin_1 + int(1);
        }
        float _S810 = _S805.z;
        float _S811 = _S810 * _S810;
        float _S812 = _S808 * _S804 * (1.0f - _S811) + _S811;
        (*_S799)[int(37) + family_10] = 0.25f * natural_logarithm_0(1.0f + 9.54929637908935547f * _S811 * _S810 / (_S812 * _S812));
        family_10 = family_10 + int(1);
    }
    return;
}

__device__ float mixed_bundles_0(uint _S813, uint _S814, uint _S815, float3  _S816, float3  _S817, bool _S818, FixedArray<float, 52>  * _S819)
{
    Fabric_0 * _S820 = (&(globalParams_0->fabrics_0)[_S813]);
    float3  _S821 = _S816 + _S817;
    float _S822 = 1.0f / (square_0(_S821) + 0.00009999999747379f);
    bool _S823;
    if(_S814 == 0U)
    {
        _S823 = _S818;
    }
    else
    {
        _S823 = false;
    }
    float _S824;
    if(_S823)
    {
        _S824 = - _S821.x;
    }
    else
    {
        _S824 = _S821.x;
    }
    if(_S814 == 1U)
    {
        _S823 = _S818;
    }
    else
    {
        _S823 = false;
    }
    float _S825;
    if(_S823)
    {
        _S825 = - _S821.y;
    }
    else
    {
        _S825 = _S821.y;
    }
    uint bundle_1 = 0U;
    float sum_1 = 0.0f;
    for(;;)
    {
        if(bundle_1 < 25U)
        {
        }
        else
        {
            break;
        }
        Woven_0 _S826 = slang_ldg_0(&_S820->woven_0);
        uint _S827 = _S814 * 25U;
        uint _S828 = _S826.bundles_0 + 4U * (_S827 + bundle_1);
        float _S829 = dot_1(make_float3 (table_number_0(_S828), table_number_0(_S828 + 1U), table_number_0(_S828 + 2U)), make_float3 (_S824, _S825, _S821.z));
        float _S830 = _S829 * _S829 * _S822 + table_number_0(_S828 + 3U);
        uint _S831 = _S815 + _S827;
        uint _S832;
        if(_S818)
        {
            _S832 = mirrored_bundle_0(bundle_1);
        }
        else
        {
            _S832 = bundle_1;
        }
        float sum_2 = sum_1 + (F32_max(((*_S819)[_S831 + _S832]), ((*_S819)[_S831 + _S832] * 0.00999999977648258f))) / (_S830 * _S830);
        bundle_1 = bundle_1 + 1U;
        sum_1 = sum_2;
    }
    return 0.01999999955296516f * sum_1;
}

__device__ Components_0 woven_components_0(uint _S833, WovenView_0 * _S834, float3  _S835)
{
    float _S836;
    Fabric_0 * _S837 = (&(globalParams_0->fabrics_0)[_S833]);
    bool _S838 = _S834->back_3;
    float3  _S839 = to_face_frame_0(_S835, _S834->back_3);
    float3  _S840 = _S834->view_4;
    HalfWeights_0 weights_24;
    Woven_0 _S841 = slang_ldg_0(&_S837->woven_0);
    (&weights_24)->first_2 = _S841.network_0;
    FixedArray<float, 39>  directions_0;
    code_light_0(_S833, _S839, _S840, _S838, &directions_0);
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
        skip_0[k_1] = _S834->sums_6[k_1];
        k_1 = k_1 + int(1);
    }
    HalfWeights_0 _S842 = weights_24;
    dense_3(&_S842, 3716U, true, &directions_0, &skip_0);
    FixedArray<float, 96>  hidden_1;
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
        hidden_1[k_1] = LeakyRelu_apply_0(skip_0[k_1]);
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
                _S836 = skip_0[k_1];
            }
            else
            {
                _S836 = 0.0f;
            }
            next_0[k_1] = _S836;
            k_1 = k_1 + int(1);
        }
        uint _S843 = 4208U + layer_0 * 1164U;
        HalfWeights_0 _S844 = weights_24;
        dense_2(&_S844, _S843, true, &hidden_1, &next_0);
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
            hidden_1[k_2] = next_0[k_2];
            k_2 = k_2 + int(1);
        }
        layer_0 = layer_0 + 1U;
    }
    HalfWeights_0 _S845 = weights_24;
    FixedArray<float, 52>  outputs_17;
    dense_1(&_S845, 7700U, false, &hidden_1, &outputs_17);
    bool _S846;
    if((_S841.is_corrected_0) != 0U)
    {
        _S846 = (_S839.z) > 0.0f;
    }
    else
    {
        _S846 = false;
    }
    if(_S846)
    {
        _S846 = (_S834->correction_weight_0) > 0.0f;
    }
    else
    {
        _S846 = false;
    }
    if(_S846)
    {
        FloatWeights_0 fitted_0;
        (&fitted_0)->first_0 = _S841.correction_0;
        FloatWeights_0 _S847 = fitted_0;
        FixedArray<float, 50>  change_0;
        dense_0(&_S847, 0U, false, &hidden_1, &change_0);
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
            outputs_17[k_1 + int(2)] = outputs_17[k_1 + int(2)] + _S834->correction_weight_0 * change_0[k_1];
            k_1 = k_1 + int(1);
        }
    }
    if((_S839.z) > 0.0f)
    {
        _S836 = 0.00999999977648258f;
    }
    else
    {
        _S836 = 0.00100000004749745f;
    }
    Components_0 result_17;
    float _S848 = unmapped_0(outputs_17[int(0)], _S836);
    (&result_17)->diffuse_warp_0 = _S848;
    float _S849 = unmapped_0(outputs_17[int(1)], _S836);
    (&result_17)->diffuse_weft_0 = _S849;
    float _S850 = 2979.9580078125f * _S836;
    float _S851 = mixed_bundles_0(_S833, 0U, 2U, _S839, _S840, _S838, &outputs_17);
    (&result_17)->specular_warp_0 = clamp_1(_S851, 0.0f, _S850);
    float _S852 = mixed_bundles_0(_S833, 1U, 2U, _S839, _S840, _S838, &outputs_17);
    (&result_17)->specular_weft_0 = clamp_1(_S852, 0.0f, _S850);
    float _S853 = _S834->hole_0;
    (&result_17)->hole_2 = _S834->hole_0;
    float _S854 = _S848 + _S849;
    float _S855 = __ldg(&_S837->diffuse_blend_0);
    (&result_17)->light_visibility_1 = (F32_min((light_visibility_of_0(_S854, _S839, _S840, _S855)), (1.0f - _S853)));
    return result_17;
}

__device__ float3  composed_0(uint _S856, Components_0 * _S857, FamilyAlbedos_0 * _S858, float3  _S859, float3  _S860)
{
    Fabric_0 * _S861 = (&(globalParams_0->fabrics_0)[_S856]);
    float _S862 = _S857->diffuse_warp_0;
    float _S863 = _S857->diffuse_weft_0;
    float _S864 = _S857->specular_warp_0;
    float _S865 = _S857->specular_weft_0;
    float3  _S866 = (&_S858->warp_1)->diffuse_reflect_0 * make_float3 (_S857->diffuse_warp_0) + (&_S858->weft_1)->diffuse_reflect_0 * make_float3 (_S857->diffuse_weft_0) + (&_S858->warp_1)->specular_reflect_0 * make_float3 (_S857->specular_warp_0) + (&_S858->weft_1)->specular_reflect_0 * make_float3 (_S857->specular_weft_0);
    float _S867 = _S860.z;
    float3  body_0;
    if((_S859.z * _S867) < 0.0f)
    {
        body_0 = (&_S858->warp_1)->diffuse_transmit_0 * make_float3 (_S862) + (&_S858->weft_1)->diffuse_transmit_0 * make_float3 (_S863) + (&_S858->warp_1)->specular_transmit_0 * make_float3 (_S864) + (&_S858->weft_1)->specular_transmit_0 * make_float3 (_S865);
    }
    else
    {
        body_0 = _S866;
    }
    float _S868 = __ldg(&_S861->sheen_strength_0);
    if(_S868 <= 0.0f)
    {
        return body_0;
    }
    bool _S869 = _S867 < 0.0f;
    float3  _S870 = to_face_frame_0(_S859, _S869);
    float3  _S871 = to_face_frame_0(_S860, _S869);
    float _S872 = __ldg(&_S861->sheen_roughness_0);
    float2  _S873 = sheen_with_transmittance_0(_S870, _S871, _S868, _S872);
    return make_float3 (_S873.y) * body_0 + make_float3 ((_S857->light_visibility_1 + _S857->hole_2) * _S873.x);
}

__device__ float4  light_of_woven_0(int _S874, uint _S875, VisiblePoint_0 * _S876, uint2  _S877, float3  _S878)
{
    Fabric_0 * _S879 = (&(globalParams_0->fabrics_0)[_S875]);
    Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = _S876->draft_0;
    (&footprint_1)->dx_0 = _S876->draft_dx_0;
    (&footprint_1)->dy_0 = _S876->draft_dy_0;
    float3  _S880 = to_local_0(_S876, _S876->view_0);
    Footprint_0 _S881 = footprint_1;
    WovenView_0 activations_0;
    woven_view_0(_S875, &_S881, _S880, &activations_0);
    float _S882 = _S880.z;
    bool _S883 = _S882 < 0.0f;
    Footprint_0 _S884 = footprint_1;
    FamilyAlbedos_0 _S885 = albedos_over_0(_S875, &_S884, _S883);
    FamilyAlbedos_0 albedos_5;
    Albedos_0 _S886 = _S885.warp_1;
    Albedos_0 _S887 = tinted_0(&_S886, _S878);
    (&albedos_5)->warp_1 = _S887;
    Albedos_0 _S888 = _S885.weft_1;
    Albedos_0 _S889 = tinted_0(&_S888, _S878);
    (&albedos_5)->weft_1 = _S889;
    float3  _S890 = make_float3 (0.0f);
    uint number_4 = 0U;
    float3  radiance_1 = _S890;
    for(;;)
    {
        uint _S891 = light_sample_count_0(_S874);
        if(number_4 < _S891)
        {
        }
        else
        {
            break;
        }
        float _S892 = visibility_at_0(_S874, number_4, _S877);
        if(_S892 <= 0.0f)
        {
            number_4 = number_4 + 1U;
            continue;
        }
        LightSample_0 _S893 = light_sample_0(_S874, number_4, _S877, _S876->position_0);
        float3  _S894 = to_local_0(_S876, _S893.towards_0);
        Components_0 _S895 = woven_components_0(_S875, &activations_0, _S894);
        float3  _S896 = make_float3 (_S892) * _S893.irradiance_1;
        Components_0 _S897 = _S895;
        FamilyAlbedos_0 _S898 = albedos_5;
        float3  _S899 = composed_0(_S875, &_S897, &_S898, _S894, _S880);
        radiance_1 = radiance_1 + _S896 * _S899;
        number_4 = number_4 + 1U;
    }
    float hole_3 = (&activations_0)->hole_0;
    float _S900 = __ldg(&_S879->sheen_strength_0);
    float hole_4;
    if(_S900 > 0.0f)
    {
        float _S901 = (F32_abs((_S882)));
        float _S902 = __ldg(&_S879->sheen_roughness_0);
        hole_4 = hole_3 * (1.0f - _S900 * sheen_lobe_0(_S901, _S902).z);
    }
    else
    {
        hole_4 = hole_3;
    }
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - hole_4);
}

extern "C" __global__ void shade_woven()
{
    uint3  _S903 = blockIdx * blockDim + threadIdx;
    Frame_0 * _S904 = (&(globalParams_0->frames_0)[int(0)]);
    uint _S905 = _S903.x;
    uint _S906 = __ldg(&_S904->width_0);
    bool _S907;
    if(_S905 >= _S906)
    {
        _S907 = true;
    }
    else
    {
        uint _S908 = _S903.y;
        uint _S909 = __ldg(&_S904->height_0);
        _S907 = _S908 >= _S909;
    }
    if(_S907)
    {
        return;
    }
    uint _S910 = _S903.y * _S906 + _S905;
    uint _S911 = (&(globalParams_0->layers_0)[_S910])->face_0;
    if(((&(globalParams_0->layers_0)[_S910])->face_0) == 0U)
    {
        return;
    }
    uint _S912 = _S911 - 1U;
    uint _S913 = __ldg((&(globalParams_0->face_fabrics_0)[_S912]));
    uint2  _S914 = uint2 {_S903.x, _S903.y};
    VisiblePoint_0 _S915 = visible_point_0(int(0), _S913, _S912, _S914);
    VisiblePoint_0 _S916 = _S915;
    float3  _S917 = filtered_albedo_0(_S913, &_S916);
    VisiblePoint_0 _S918 = _S915;
    float4  _S919 = light_of_woven_0(int(0), _S913, &_S918, _S914, _S917);
    accumulate_0(_S910, _S919);
    return;
}

