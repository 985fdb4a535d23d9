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
struct FloatWeights_0
{
    uint first_0;
};

__device__ int whole_parts_0(int elements_0)
{
    return (elements_0 + int(3)) / int(4) * int(4);
}

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

__device__ float4  tile_product_0(FloatWeights_0 * weights_0, uint row_0, FixedArray<float, 64>  * inputs_0)
{
    float4  sums_1 = make_float4 (0.0f);
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
        Eight_0 _S9 = FloatWeights_eight_0(weights_0, row_0 + 8U + column_0);
        *&((&sums_1)->y) = *&((&sums_1)->y) + (dot_0(_S9.low_0, low_1) + dot_0(_S9.high_0, high_1));
        Eight_0 _S10 = FloatWeights_eight_0(weights_0, row_0 + 16U + column_0);
        *&((&sums_1)->z) = *&((&sums_1)->z) + (dot_0(_S10.low_0, low_1) + dot_0(_S10.high_0, high_1));
        Eight_0 _S11 = FloatWeights_eight_0(weights_0, row_0 + 24U + column_0);
        *&((&sums_1)->w) = *&((&sums_1)->w) + (dot_0(_S11.low_0, low_1) + dot_0(_S11.high_0, high_1));
        column_0 = column_0 + 1U;
    }
    return sums_1;
}

__device__ float Relu_apply_0(float x_5)
{
    return (F32_max((x_5), (0.0f)));
}

__device__ void dense_part_0(FloatWeights_0 * weights_1, uint first_1, bool adds_0, FixedArray<float, 64>  * inputs_1, FixedArray<float, 64>  * outputs_0)
{
    uint _S12 = first_1 + uint(whole_parts_0(int(8)));
    int output_0 = int(0);
    for(;;)
    {
        bool _S13 = output_0 < int(64);
        if(_S13)
        {
        }
        else
        {
            break;
        }
        uint _S14 = uint(output_0);
        Eight_0 _S15 = FloatWeights_eight_0(weights_1, first_1 + _S14 / 8U);
        float4  _S16 = tile_product_0(weights_1, _S12 + _S14 * 8U, inputs_1);
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
            (*outputs_0)[output_0] = Relu_apply_0(_S18.x + _S19);
        }
        int _S20 = output_0 + int(1);
        if(_S20 < int(64))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S20];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S20] = Relu_apply_0(_S18.y + _S19);
        }
        int _S21 = output_0 + int(2);
        if(_S21 < int(64))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S21];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S21] = Relu_apply_0(_S18.z + _S19);
        }
        int _S22 = output_0 + int(3);
        if(_S22 < int(64))
        {
            if(adds_0)
            {
                _S19 = (*outputs_0)[_S22];
            }
            else
            {
                _S19 = 0.0f;
            }
            (*outputs_0)[_S22] = Relu_apply_0(_S18.w + _S19);
        }
        output_0 = output_0 + int(4);
    }
    return;
}

__device__ float Identity_apply_0(float x_6)
{
    return x_6;
}

__device__ void dense_part_1(FloatWeights_0 * weights_2, uint first_2, bool adds_1, FixedArray<float, 64>  * inputs_2, FixedArray<float, 3>  * outputs_1)
{
    uint _S23 = first_2 + uint(whole_parts_0(int(1)));
    int output_1 = int(0);
    for(;;)
    {
        bool _S24 = output_1 < int(3);
        if(_S24)
        {
        }
        else
        {
            break;
        }
        uint _S25 = uint(output_1);
        Eight_0 _S26 = FloatWeights_eight_0(weights_2, first_2 + _S25 / 8U);
        float4  _S27 = tile_product_0(weights_2, _S23 + _S25 * 8U, inputs_2);
        float4  _S28;
        if((output_1 & int(4)) != int(0))
        {
            _S28 = _S26.high_0;
        }
        else
        {
            _S28 = _S26.low_0;
        }
        float4  _S29 = _S27 + _S28;
        float _S30;
        if(_S24)
        {
            if(adds_1)
            {
                _S30 = (*outputs_1)[output_1];
            }
            else
            {
                _S30 = 0.0f;
            }
            (*outputs_1)[output_1] = Identity_apply_0(_S29.x + _S30);
        }
        int _S31 = output_1 + int(1);
        if(_S31 < int(3))
        {
            if(adds_1)
            {
                _S30 = (*outputs_1)[_S31];
            }
            else
            {
                _S30 = 0.0f;
            }
            (*outputs_1)[_S31] = Identity_apply_0(_S29.y + _S30);
        }
        int _S32 = output_1 + int(2);
        if(_S32 < int(3))
        {
            if(adds_1)
            {
                _S30 = (*outputs_1)[_S32];
            }
            else
            {
                _S30 = 0.0f;
            }
            (*outputs_1)[_S32] = Identity_apply_0(_S29.z + _S30);
        }
        int _S33 = output_1 + int(3);
        if(_S33 < int(3))
        {
            if(adds_1)
            {
                _S30 = (*outputs_1)[_S33];
            }
            else
            {
                _S30 = 0.0f;
            }
            (*outputs_1)[_S33] = Identity_apply_0(_S29.w + _S30);
        }
        output_1 = output_1 + int(4);
    }
    return;
}

__device__ float4  tile_product_1(FloatWeights_0 * weights_3, uint row_1, FixedArray<float, 20>  * inputs_3)
{
    float4  sums_2 = make_float4 (0.0f);
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
        float4  low_2;
        float4  high_2;
        int _S34 = int(8U * column_1);
        *&((&low_2)->x) = (*inputs_3)[(I32_min((_S34), (int(19))))];
        *&((&high_2)->x) = (*inputs_3)[(I32_min((_S34 + int(4)), (int(19))))];
        int _S35 = _S34 + int(1);
        *&((&low_2)->y) = (*inputs_3)[(I32_min((_S35), (int(19))))];
        *&((&high_2)->y) = (*inputs_3)[(I32_min((_S35 + int(4)), (int(19))))];
        int _S36 = _S34 + int(2);
        *&((&low_2)->z) = (*inputs_3)[(I32_min((_S36), (int(19))))];
        *&((&high_2)->z) = (*inputs_3)[(I32_min((_S36 + int(4)), (int(19))))];
        int _S37 = _S34 + int(3);
        *&((&low_2)->w) = (*inputs_3)[(I32_min((_S37), (int(19))))];
        *&((&high_2)->w) = (*inputs_3)[(I32_min((_S37 + int(4)), (int(19))))];
        Eight_0 _S38 = FloatWeights_eight_0(weights_3, row_1 + column_1);
        *&((&sums_2)->x) = *&((&sums_2)->x) + (dot_0(_S38.low_0, low_2) + dot_0(_S38.high_0, high_2));
        Eight_0 _S39 = FloatWeights_eight_0(weights_3, row_1 + 3U + column_1);
        *&((&sums_2)->y) = *&((&sums_2)->y) + (dot_0(_S39.low_0, low_2) + dot_0(_S39.high_0, high_2));
        Eight_0 _S40 = FloatWeights_eight_0(weights_3, row_1 + 6U + column_1);
        *&((&sums_2)->z) = *&((&sums_2)->z) + (dot_0(_S40.low_0, low_2) + dot_0(_S40.high_0, high_2));
        Eight_0 _S41 = FloatWeights_eight_0(weights_3, row_1 + 9U + column_1);
        *&((&sums_2)->w) = *&((&sums_2)->w) + (dot_0(_S41.low_0, low_2) + dot_0(_S41.high_0, high_2));
        column_1 = column_1 + 1U;
    }
    return sums_2;
}

__device__ void dense_part_2(FloatWeights_0 * weights_4, uint first_3, bool adds_2, FixedArray<float, 20>  * inputs_4, FixedArray<float, 64>  * outputs_2)
{
    uint _S42 = first_3 + uint(whole_parts_0(int(8)));
    int output_2 = int(0);
    for(;;)
    {
        bool _S43 = output_2 < int(64);
        if(_S43)
        {
        }
        else
        {
            break;
        }
        uint _S44 = uint(output_2);
        Eight_0 _S45 = FloatWeights_eight_0(weights_4, first_3 + _S44 / 8U);
        float4  _S46 = tile_product_1(weights_4, _S42 + _S44 * 3U, inputs_4);
        float4  _S47;
        if((output_2 & int(4)) != int(0))
        {
            _S47 = _S45.high_0;
        }
        else
        {
            _S47 = _S45.low_0;
        }
        float4  _S48 = _S46 + _S47;
        float _S49;
        if(_S43)
        {
            if(adds_2)
            {
                _S49 = (*outputs_2)[output_2];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_2)[output_2] = Relu_apply_0(_S48.x + _S49);
        }
        int _S50 = output_2 + int(1);
        if(_S50 < int(64))
        {
            if(adds_2)
            {
                _S49 = (*outputs_2)[_S50];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_2)[_S50] = Relu_apply_0(_S48.y + _S49);
        }
        int _S51 = output_2 + int(2);
        if(_S51 < int(64))
        {
            if(adds_2)
            {
                _S49 = (*outputs_2)[_S51];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_2)[_S51] = Relu_apply_0(_S48.z + _S49);
        }
        int _S52 = output_2 + int(3);
        if(_S52 < int(64))
        {
            if(adds_2)
            {
                _S49 = (*outputs_2)[_S52];
            }
            else
            {
                _S49 = 0.0f;
            }
            (*outputs_2)[_S52] = Relu_apply_0(_S48.w + _S49);
        }
        output_2 = output_2 + int(4);
    }
    return;
}

__device__ void dense_0(FloatWeights_0 * weights_5, uint first_4, bool adds_3, FixedArray<float, 64>  * inputs_5, FixedArray<float, 64>  * outputs_3)
{
    dense_part_0(weights_5, first_4, adds_3, inputs_5, outputs_3);
    return;
}

__device__ void dense_1(FloatWeights_0 * weights_6, uint first_5, bool adds_4, FixedArray<float, 64>  * inputs_6, FixedArray<float, 3>  * outputs_4)
{
    dense_part_1(weights_6, first_5, adds_4, inputs_6, outputs_4);
    return;
}

__device__ void dense_2(FloatWeights_0 * weights_7, uint first_6, bool adds_5, FixedArray<float, 20>  * inputs_7, FixedArray<float, 64>  * outputs_5)
{
    dense_part_2(weights_7, first_6, adds_5, inputs_7, outputs_5);
    return;
}

struct MLP_0
{
    FloatWeights_0 weights_8;
};

__device__ int layer_size_0(int inputs_8, int outputs_6)
{
    return whole_parts_0((outputs_6 + int(7)) / int(8)) + whole_parts_0((inputs_8 + int(7)) / int(8) * ((outputs_6 + int(4) - int(1)) / int(4) * int(4)));
}

__device__ void MLP_evaluate_0(MLP_0 * this_1, FixedArray<float, 20>  * inputs_9, FixedArray<float, 3>  * outputs_7)
{
    FixedArray<float, 64>  odd_0;
    FixedArray<float, 64>  even_0;
    dense_2(&this_1->weights_8, 0U, false, inputs_9, &even_0);
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
        int _S53 = layer_size_0(int(64), int(64));
        uint _S54 = uint(layer_size_0(int(20), int(64)) + (layer_0 - int(1)) * _S53);
        dense_0(&this_1->weights_8, _S54, false, &even_0, &odd_0);
        if((layer_0 + int(1)) < int(3))
        {
            dense_0(&this_1->weights_8, _S54 + uint(_S53), false, &odd_0, &even_0);
        }
        layer_0 = layer_0 + int(2);
    }
    uint _S55 = uint(layer_size_0(int(20), int(64)) + int(2) * layer_size_0(int(64), int(64)));
    dense_1(&this_1->weights_8, _S55, false, &even_0, outputs_7);
    return;
}

__device__ float4  tile_product_2(FloatWeights_0 * weights_9, uint row_2, FixedArray<float, 32>  * inputs_10)
{
    float4  sums_3 = make_float4 (0.0f);
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
        float4  low_3;
        float4  high_3;
        int _S56 = int(8U * column_2);
        *&((&low_3)->x) = (*inputs_10)[_S56];
        *&((&high_3)->x) = (*inputs_10)[_S56 + int(4)];
        int _S57 = _S56 + int(1);
        *&((&low_3)->y) = (*inputs_10)[_S57];
        *&((&high_3)->y) = (*inputs_10)[_S57 + int(4)];
        int _S58 = _S56 + int(2);
        *&((&low_3)->z) = (*inputs_10)[_S58];
        *&((&high_3)->z) = (*inputs_10)[_S58 + int(4)];
        int _S59 = _S56 + int(3);
        *&((&low_3)->w) = (*inputs_10)[_S59];
        *&((&high_3)->w) = (*inputs_10)[_S59 + int(4)];
        Eight_0 _S60 = FloatWeights_eight_0(weights_9, row_2 + column_2);
        *&((&sums_3)->x) = *&((&sums_3)->x) + (dot_0(_S60.low_0, low_3) + dot_0(_S60.high_0, high_3));
        Eight_0 _S61 = FloatWeights_eight_0(weights_9, row_2 + 4U + column_2);
        *&((&sums_3)->y) = *&((&sums_3)->y) + (dot_0(_S61.low_0, low_3) + dot_0(_S61.high_0, high_3));
        Eight_0 _S62 = FloatWeights_eight_0(weights_9, row_2 + 8U + column_2);
        *&((&sums_3)->z) = *&((&sums_3)->z) + (dot_0(_S62.low_0, low_3) + dot_0(_S62.high_0, high_3));
        Eight_0 _S63 = FloatWeights_eight_0(weights_9, row_2 + 12U + column_2);
        *&((&sums_3)->w) = *&((&sums_3)->w) + (dot_0(_S63.low_0, low_3) + dot_0(_S63.high_0, high_3));
        column_2 = column_2 + 1U;
    }
    return sums_3;
}

__device__ void dense_part_3(FloatWeights_0 * weights_10, uint first_7, bool adds_6, FixedArray<float, 32>  * inputs_11, FixedArray<float, 32>  * outputs_8)
{
    uint _S64 = first_7 + uint(whole_parts_0(int(4)));
    int output_3 = int(0);
    for(;;)
    {
        bool _S65 = output_3 < int(32);
        if(_S65)
        {
        }
        else
        {
            break;
        }
        uint _S66 = uint(output_3);
        Eight_0 _S67 = FloatWeights_eight_0(weights_10, first_7 + _S66 / 8U);
        float4  _S68 = tile_product_2(weights_10, _S64 + _S66 * 4U, inputs_11);
        float4  _S69;
        if((output_3 & int(4)) != int(0))
        {
            _S69 = _S67.high_0;
        }
        else
        {
            _S69 = _S67.low_0;
        }
        float4  _S70 = _S68 + _S69;
        float _S71;
        if(_S65)
        {
            if(adds_6)
            {
                _S71 = (*outputs_8)[output_3];
            }
            else
            {
                _S71 = 0.0f;
            }
            (*outputs_8)[output_3] = Relu_apply_0(_S70.x + _S71);
        }
        int _S72 = output_3 + int(1);
        if(_S72 < int(32))
        {
            if(adds_6)
            {
                _S71 = (*outputs_8)[_S72];
            }
            else
            {
                _S71 = 0.0f;
            }
            (*outputs_8)[_S72] = Relu_apply_0(_S70.y + _S71);
        }
        int _S73 = output_3 + int(2);
        if(_S73 < int(32))
        {
            if(adds_6)
            {
                _S71 = (*outputs_8)[_S73];
            }
            else
            {
                _S71 = 0.0f;
            }
            (*outputs_8)[_S73] = Relu_apply_0(_S70.z + _S71);
        }
        int _S74 = output_3 + int(3);
        if(_S74 < int(32))
        {
            if(adds_6)
            {
                _S71 = (*outputs_8)[_S74];
            }
            else
            {
                _S71 = 0.0f;
            }
            (*outputs_8)[_S74] = Relu_apply_0(_S70.w + _S71);
        }
        output_3 = output_3 + int(4);
    }
    return;
}

__device__ void dense_part_4(FloatWeights_0 * weights_11, uint first_8, bool adds_7, FixedArray<float, 32>  * inputs_12, FixedArray<float, 3>  * outputs_9)
{
    uint _S75 = first_8 + uint(whole_parts_0(int(1)));
    int output_4 = int(0);
    for(;;)
    {
        bool _S76 = output_4 < int(3);
        if(_S76)
        {
        }
        else
        {
            break;
        }
        uint _S77 = uint(output_4);
        Eight_0 _S78 = FloatWeights_eight_0(weights_11, first_8 + _S77 / 8U);
        float4  _S79 = tile_product_2(weights_11, _S75 + _S77 * 4U, inputs_12);
        float4  _S80;
        if((output_4 & int(4)) != int(0))
        {
            _S80 = _S78.high_0;
        }
        else
        {
            _S80 = _S78.low_0;
        }
        float4  _S81 = _S79 + _S80;
        float _S82;
        if(_S76)
        {
            if(adds_7)
            {
                _S82 = (*outputs_9)[output_4];
            }
            else
            {
                _S82 = 0.0f;
            }
            (*outputs_9)[output_4] = Identity_apply_0(_S81.x + _S82);
        }
        int _S83 = output_4 + int(1);
        if(_S83 < int(3))
        {
            if(adds_7)
            {
                _S82 = (*outputs_9)[_S83];
            }
            else
            {
                _S82 = 0.0f;
            }
            (*outputs_9)[_S83] = Identity_apply_0(_S81.y + _S82);
        }
        int _S84 = output_4 + int(2);
        if(_S84 < int(3))
        {
            if(adds_7)
            {
                _S82 = (*outputs_9)[_S84];
            }
            else
            {
                _S82 = 0.0f;
            }
            (*outputs_9)[_S84] = Identity_apply_0(_S81.z + _S82);
        }
        int _S85 = output_4 + int(3);
        if(_S85 < int(3))
        {
            if(adds_7)
            {
                _S82 = (*outputs_9)[_S85];
            }
            else
            {
                _S82 = 0.0f;
            }
            (*outputs_9)[_S85] = Identity_apply_0(_S81.w + _S82);
        }
        output_4 = output_4 + int(4);
    }
    return;
}

__device__ void dense_part_5(FloatWeights_0 * weights_12, uint first_9, bool adds_8, FixedArray<float, 20>  * inputs_13, FixedArray<float, 32>  * outputs_10)
{
    uint _S86 = first_9 + uint(whole_parts_0(int(4)));
    int output_5 = int(0);
    for(;;)
    {
        bool _S87 = output_5 < int(32);
        if(_S87)
        {
        }
        else
        {
            break;
        }
        uint _S88 = uint(output_5);
        Eight_0 _S89 = FloatWeights_eight_0(weights_12, first_9 + _S88 / 8U);
        float4  _S90 = tile_product_1(weights_12, _S86 + _S88 * 3U, inputs_13);
        float4  _S91;
        if((output_5 & int(4)) != int(0))
        {
            _S91 = _S89.high_0;
        }
        else
        {
            _S91 = _S89.low_0;
        }
        float4  _S92 = _S90 + _S91;
        float _S93;
        if(_S87)
        {
            if(adds_8)
            {
                _S93 = (*outputs_10)[output_5];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_10)[output_5] = Relu_apply_0(_S92.x + _S93);
        }
        int _S94 = output_5 + int(1);
        if(_S94 < int(32))
        {
            if(adds_8)
            {
                _S93 = (*outputs_10)[_S94];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_10)[_S94] = Relu_apply_0(_S92.y + _S93);
        }
        int _S95 = output_5 + int(2);
        if(_S95 < int(32))
        {
            if(adds_8)
            {
                _S93 = (*outputs_10)[_S95];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_10)[_S95] = Relu_apply_0(_S92.z + _S93);
        }
        int _S96 = output_5 + int(3);
        if(_S96 < int(32))
        {
            if(adds_8)
            {
                _S93 = (*outputs_10)[_S96];
            }
            else
            {
                _S93 = 0.0f;
            }
            (*outputs_10)[_S96] = Relu_apply_0(_S92.w + _S93);
        }
        output_5 = output_5 + int(4);
    }
    return;
}

__device__ void dense_3(FloatWeights_0 * weights_13, uint first_10, bool adds_9, FixedArray<float, 32>  * inputs_14, FixedArray<float, 32>  * outputs_11)
{
    dense_part_3(weights_13, first_10, adds_9, inputs_14, outputs_11);
    return;
}

__device__ void dense_4(FloatWeights_0 * weights_14, uint first_11, bool adds_10, FixedArray<float, 32>  * inputs_15, FixedArray<float, 3>  * outputs_12)
{
    dense_part_4(weights_14, first_11, adds_10, inputs_15, outputs_12);
    return;
}

__device__ void dense_5(FloatWeights_0 * weights_15, uint first_12, bool adds_11, FixedArray<float, 20>  * inputs_16, FixedArray<float, 32>  * outputs_13)
{
    dense_part_5(weights_15, first_12, adds_11, inputs_16, outputs_13);
    return;
}

__device__ void MLP_evaluate_1(MLP_0 * this_2, FixedArray<float, 20>  * inputs_17, FixedArray<float, 3>  * outputs_14)
{
    FixedArray<float, 32>  odd_1;
    FixedArray<float, 32>  even_1;
    dense_5(&this_2->weights_8, 0U, false, inputs_17, &even_1);
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
        int _S97 = layer_size_0(int(32), int(32));
        uint _S98 = uint(layer_size_0(int(20), int(32)) + (layer_1 - int(1)) * _S97);
        dense_3(&this_2->weights_8, _S98, false, &even_1, &odd_1);
        if((layer_1 + int(1)) < int(2))
        {
            dense_3(&this_2->weights_8, _S98 + uint(_S97), false, &odd_1, &even_1);
        }
        layer_1 = layer_1 + int(2);
    }
    uint _S99 = uint(layer_size_0(int(20), int(32)) + layer_size_0(int(32), int(32)));
    dense_4(&this_2->weights_8, _S99, false, &odd_1, outputs_14);
    return;
}

__device__ float4  tile_product_3(FloatWeights_0 * weights_16, uint row_3, FixedArray<float, 16>  * inputs_18)
{
    float4  sums_4 = make_float4 (0.0f);
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
        float4  low_4;
        float4  high_4;
        int _S100 = int(8U * column_3);
        *&((&low_4)->x) = (*inputs_18)[_S100];
        *&((&high_4)->x) = (*inputs_18)[_S100 + int(4)];
        int _S101 = _S100 + int(1);
        *&((&low_4)->y) = (*inputs_18)[_S101];
        *&((&high_4)->y) = (*inputs_18)[_S101 + int(4)];
        int _S102 = _S100 + int(2);
        *&((&low_4)->z) = (*inputs_18)[_S102];
        *&((&high_4)->z) = (*inputs_18)[_S102 + int(4)];
        int _S103 = _S100 + int(3);
        *&((&low_4)->w) = (*inputs_18)[_S103];
        *&((&high_4)->w) = (*inputs_18)[_S103 + int(4)];
        Eight_0 _S104 = FloatWeights_eight_0(weights_16, row_3 + column_3);
        *&((&sums_4)->x) = *&((&sums_4)->x) + (dot_0(_S104.low_0, low_4) + dot_0(_S104.high_0, high_4));
        Eight_0 _S105 = FloatWeights_eight_0(weights_16, row_3 + 2U + column_3);
        *&((&sums_4)->y) = *&((&sums_4)->y) + (dot_0(_S105.low_0, low_4) + dot_0(_S105.high_0, high_4));
        Eight_0 _S106 = FloatWeights_eight_0(weights_16, row_3 + 4U + column_3);
        *&((&sums_4)->z) = *&((&sums_4)->z) + (dot_0(_S106.low_0, low_4) + dot_0(_S106.high_0, high_4));
        Eight_0 _S107 = FloatWeights_eight_0(weights_16, row_3 + 6U + column_3);
        *&((&sums_4)->w) = *&((&sums_4)->w) + (dot_0(_S107.low_0, low_4) + dot_0(_S107.high_0, high_4));
        column_3 = column_3 + 1U;
    }
    return sums_4;
}

__device__ void dense_part_6(FloatWeights_0 * weights_17, uint first_13, bool adds_12, FixedArray<float, 16>  * inputs_19, FixedArray<float, 16>  * outputs_15)
{
    uint _S108 = first_13 + uint(whole_parts_0(int(2)));
    int output_6 = int(0);
    for(;;)
    {
        bool _S109 = output_6 < int(16);
        if(_S109)
        {
        }
        else
        {
            break;
        }
        uint _S110 = uint(output_6);
        Eight_0 _S111 = FloatWeights_eight_0(weights_17, first_13 + _S110 / 8U);
        float4  _S112 = tile_product_3(weights_17, _S108 + _S110 * 2U, inputs_19);
        float4  _S113;
        if((output_6 & int(4)) != int(0))
        {
            _S113 = _S111.high_0;
        }
        else
        {
            _S113 = _S111.low_0;
        }
        float4  _S114 = _S112 + _S113;
        float _S115;
        if(_S109)
        {
            if(adds_12)
            {
                _S115 = (*outputs_15)[output_6];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_15)[output_6] = Relu_apply_0(_S114.x + _S115);
        }
        int _S116 = output_6 + int(1);
        if(_S116 < int(16))
        {
            if(adds_12)
            {
                _S115 = (*outputs_15)[_S116];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_15)[_S116] = Relu_apply_0(_S114.y + _S115);
        }
        int _S117 = output_6 + int(2);
        if(_S117 < int(16))
        {
            if(adds_12)
            {
                _S115 = (*outputs_15)[_S117];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_15)[_S117] = Relu_apply_0(_S114.z + _S115);
        }
        int _S118 = output_6 + int(3);
        if(_S118 < int(16))
        {
            if(adds_12)
            {
                _S115 = (*outputs_15)[_S118];
            }
            else
            {
                _S115 = 0.0f;
            }
            (*outputs_15)[_S118] = Relu_apply_0(_S114.w + _S115);
        }
        output_6 = output_6 + int(4);
    }
    return;
}

__device__ void dense_part_7(FloatWeights_0 * weights_18, uint first_14, bool adds_13, FixedArray<float, 16>  * inputs_20, FixedArray<float, 3>  * outputs_16)
{
    uint _S119 = first_14 + uint(whole_parts_0(int(1)));
    int output_7 = int(0);
    for(;;)
    {
        bool _S120 = output_7 < int(3);
        if(_S120)
        {
        }
        else
        {
            break;
        }
        uint _S121 = uint(output_7);
        Eight_0 _S122 = FloatWeights_eight_0(weights_18, first_14 + _S121 / 8U);
        float4  _S123 = tile_product_3(weights_18, _S119 + _S121 * 2U, inputs_20);
        float4  _S124;
        if((output_7 & int(4)) != int(0))
        {
            _S124 = _S122.high_0;
        }
        else
        {
            _S124 = _S122.low_0;
        }
        float4  _S125 = _S123 + _S124;
        float _S126;
        if(_S120)
        {
            if(adds_13)
            {
                _S126 = (*outputs_16)[output_7];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_16)[output_7] = Identity_apply_0(_S125.x + _S126);
        }
        int _S127 = output_7 + int(1);
        if(_S127 < int(3))
        {
            if(adds_13)
            {
                _S126 = (*outputs_16)[_S127];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_16)[_S127] = Identity_apply_0(_S125.y + _S126);
        }
        int _S128 = output_7 + int(2);
        if(_S128 < int(3))
        {
            if(adds_13)
            {
                _S126 = (*outputs_16)[_S128];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_16)[_S128] = Identity_apply_0(_S125.z + _S126);
        }
        int _S129 = output_7 + int(3);
        if(_S129 < int(3))
        {
            if(adds_13)
            {
                _S126 = (*outputs_16)[_S129];
            }
            else
            {
                _S126 = 0.0f;
            }
            (*outputs_16)[_S129] = Identity_apply_0(_S125.w + _S126);
        }
        output_7 = output_7 + int(4);
    }
    return;
}

__device__ void dense_part_8(FloatWeights_0 * weights_19, uint first_15, bool adds_14, FixedArray<float, 20>  * inputs_21, FixedArray<float, 16>  * outputs_17)
{
    uint _S130 = first_15 + uint(whole_parts_0(int(2)));
    int output_8 = int(0);
    for(;;)
    {
        bool _S131 = output_8 < int(16);
        if(_S131)
        {
        }
        else
        {
            break;
        }
        uint _S132 = uint(output_8);
        Eight_0 _S133 = FloatWeights_eight_0(weights_19, first_15 + _S132 / 8U);
        float4  _S134 = tile_product_1(weights_19, _S130 + _S132 * 3U, inputs_21);
        float4  _S135;
        if((output_8 & int(4)) != int(0))
        {
            _S135 = _S133.high_0;
        }
        else
        {
            _S135 = _S133.low_0;
        }
        float4  _S136 = _S134 + _S135;
        float _S137;
        if(_S131)
        {
            if(adds_14)
            {
                _S137 = (*outputs_17)[output_8];
            }
            else
            {
                _S137 = 0.0f;
            }
            (*outputs_17)[output_8] = Relu_apply_0(_S136.x + _S137);
        }
        int _S138 = output_8 + int(1);
        if(_S138 < int(16))
        {
            if(adds_14)
            {
                _S137 = (*outputs_17)[_S138];
            }
            else
            {
                _S137 = 0.0f;
            }
            (*outputs_17)[_S138] = Relu_apply_0(_S136.y + _S137);
        }
        int _S139 = output_8 + int(2);
        if(_S139 < int(16))
        {
            if(adds_14)
            {
                _S137 = (*outputs_17)[_S139];
            }
            else
            {
                _S137 = 0.0f;
            }
            (*outputs_17)[_S139] = Relu_apply_0(_S136.z + _S137);
        }
        int _S140 = output_8 + int(3);
        if(_S140 < int(16))
        {
            if(adds_14)
            {
                _S137 = (*outputs_17)[_S140];
            }
            else
            {
                _S137 = 0.0f;
            }
            (*outputs_17)[_S140] = Relu_apply_0(_S136.w + _S137);
        }
        output_8 = output_8 + int(4);
    }
    return;
}

__device__ void dense_6(FloatWeights_0 * weights_20, uint first_16, bool adds_15, FixedArray<float, 16>  * inputs_22, FixedArray<float, 16>  * outputs_18)
{
    dense_part_6(weights_20, first_16, adds_15, inputs_22, outputs_18);
    return;
}

__device__ void dense_7(FloatWeights_0 * weights_21, uint first_17, bool adds_16, FixedArray<float, 16>  * inputs_23, FixedArray<float, 3>  * outputs_19)
{
    dense_part_7(weights_21, first_17, adds_16, inputs_23, outputs_19);
    return;
}

__device__ void dense_8(FloatWeights_0 * weights_22, uint first_18, bool adds_17, FixedArray<float, 20>  * inputs_24, FixedArray<float, 16>  * outputs_20)
{
    dense_part_8(weights_22, first_18, adds_17, inputs_24, outputs_20);
    return;
}

__device__ void MLP_evaluate_2(MLP_0 * this_3, FixedArray<float, 20>  * inputs_25, FixedArray<float, 3>  * outputs_21)
{
    FixedArray<float, 16>  odd_2;
    FixedArray<float, 16>  even_2;
    dense_8(&this_3->weights_8, 0U, false, inputs_25, &even_2);
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
        int _S141 = layer_size_0(int(16), int(16));
        uint _S142 = uint(layer_size_0(int(20), int(16)) + (layer_2 - int(1)) * _S141);
        dense_6(&this_3->weights_8, _S142, false, &even_2, &odd_2);
        if((layer_2 + int(1)) < int(2))
        {
            dense_6(&this_3->weights_8, _S142 + uint(_S141), false, &odd_2, &even_2);
        }
        layer_2 = layer_2 + int(2);
    }
    uint _S143 = uint(layer_size_0(int(20), int(16)) + layer_size_0(int(16), int(16)));
    dense_7(&this_3->weights_8, _S143, false, &odd_2, outputs_21);
    return;
}

__device__ float dot_1(float3  x_7, float3  y_4)
{
    int i_2 = int(0);
    float result_3 = 0.0f;
    for(;;)
    {
        if(i_2 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_4 = result_3 + _slang_vector_get_element(x_7, i_2) * _slang_vector_get_element(y_4, i_2);
        i_2 = i_2 + int(1);
        result_3 = result_4;
    }
    return result_3;
}

__device__ float length_0(float3  x_8)
{
    return (F32_sqrt((dot_1(x_8, x_8))));
}

__device__ float4  tile_product_4(FloatWeights_0 * weights_23, uint row_4, FixedArray<float, 8>  * inputs_26)
{
    float4  sums_5 = make_float4 (0.0f);
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
        float4  low_5;
        float4  high_5;
        int _S144 = int(8U * column_4);
        *&((&low_5)->x) = (*inputs_26)[_S144];
        *&((&high_5)->x) = (*inputs_26)[_S144 + int(4)];
        int _S145 = _S144 + int(1);
        *&((&low_5)->y) = (*inputs_26)[_S145];
        *&((&high_5)->y) = (*inputs_26)[_S145 + int(4)];
        int _S146 = _S144 + int(2);
        *&((&low_5)->z) = (*inputs_26)[_S146];
        *&((&high_5)->z) = (*inputs_26)[_S146 + int(4)];
        int _S147 = _S144 + int(3);
        *&((&low_5)->w) = (*inputs_26)[_S147];
        *&((&high_5)->w) = (*inputs_26)[_S147 + int(4)];
        Eight_0 _S148 = FloatWeights_eight_0(weights_23, row_4 + column_4);
        *&((&sums_5)->x) = *&((&sums_5)->x) + (dot_0(_S148.low_0, low_5) + dot_0(_S148.high_0, high_5));
        Eight_0 _S149 = FloatWeights_eight_0(weights_23, row_4 + 1U + column_4);
        *&((&sums_5)->y) = *&((&sums_5)->y) + (dot_0(_S149.low_0, low_5) + dot_0(_S149.high_0, high_5));
        Eight_0 _S150 = FloatWeights_eight_0(weights_23, row_4 + 2U + column_4);
        *&((&sums_5)->z) = *&((&sums_5)->z) + (dot_0(_S150.low_0, low_5) + dot_0(_S150.high_0, high_5));
        Eight_0 _S151 = FloatWeights_eight_0(weights_23, row_4 + 3U + column_4);
        *&((&sums_5)->w) = *&((&sums_5)->w) + (dot_0(_S151.low_0, low_5) + dot_0(_S151.high_0, high_5));
        column_4 = column_4 + 1U;
    }
    return sums_5;
}

__device__ void dense_part_9(FloatWeights_0 * weights_24, uint first_19, bool adds_18, FixedArray<float, 8>  * inputs_27, FixedArray<float, 12>  * outputs_22)
{
    uint _S152 = first_19 + uint(whole_parts_0(int(2)));
    int output_9 = int(0);
    for(;;)
    {
        bool _S153 = output_9 < int(12);
        if(_S153)
        {
        }
        else
        {
            break;
        }
        uint _S154 = uint(output_9);
        Eight_0 _S155 = FloatWeights_eight_0(weights_24, first_19 + _S154 / 8U);
        float4  _S156 = tile_product_4(weights_24, _S152 + _S154, inputs_27);
        float4  _S157;
        if((output_9 & int(4)) != int(0))
        {
            _S157 = _S155.high_0;
        }
        else
        {
            _S157 = _S155.low_0;
        }
        float4  _S158 = _S156 + _S157;
        float _S159;
        if(_S153)
        {
            if(adds_18)
            {
                _S159 = (*outputs_22)[output_9];
            }
            else
            {
                _S159 = 0.0f;
            }
            (*outputs_22)[output_9] = Identity_apply_0(_S158.x + _S159);
        }
        int _S160 = output_9 + int(1);
        if(_S160 < int(12))
        {
            if(adds_18)
            {
                _S159 = (*outputs_22)[_S160];
            }
            else
            {
                _S159 = 0.0f;
            }
            (*outputs_22)[_S160] = Identity_apply_0(_S158.y + _S159);
        }
        int _S161 = output_9 + int(2);
        if(_S161 < int(12))
        {
            if(adds_18)
            {
                _S159 = (*outputs_22)[_S161];
            }
            else
            {
                _S159 = 0.0f;
            }
            (*outputs_22)[_S161] = Identity_apply_0(_S158.z + _S159);
        }
        int _S162 = output_9 + int(3);
        if(_S162 < int(12))
        {
            if(adds_18)
            {
                _S159 = (*outputs_22)[_S162];
            }
            else
            {
                _S159 = 0.0f;
            }
            (*outputs_22)[_S162] = Identity_apply_0(_S158.w + _S159);
        }
        output_9 = output_9 + int(4);
    }
    return;
}

__device__ float2  min_0(float2  x_9, float2  y_5)
{
    float2  result_5;
    int i_3 = int(0);
    for(;;)
    {
        if(i_3 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_5, i_3) = (F32_min((_slang_vector_get_element(x_9, i_3)), (_slang_vector_get_element(y_5, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_5;
}

__device__ float2  max_0(float2  x_10, float2  y_6)
{
    float2  result_6;
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
        *_slang_vector_get_element_ptr(&result_6, i_4) = (F32_max((_slang_vector_get_element(x_10, i_4)), (_slang_vector_get_element(y_6, i_4))));
        i_4 = i_4 + int(1);
    }
    return result_6;
}

__device__ float clamp_0(float x_11, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_11), (minBound_0)))), (maxBound_0)));
}

__device__ void decode_0(uint first_20, FixedArray<float, 20>  * inputs_28, FixedArray<float, 3>  * outputs_23)
{
    MLP_0 network_1;
    (&(&network_1)->weights_8)->first_0 = first_20;
    MLP_0 _S163 = network_1;
    MLP_evaluate_0(&_S163, inputs_28, outputs_23);
    return;
}

__device__ void decode_1(uint first_21, FixedArray<float, 20>  * inputs_29, FixedArray<float, 3>  * outputs_24)
{
    MLP_0 network_2;
    (&(&network_2)->weights_8)->first_0 = first_21;
    MLP_0 _S164 = network_2;
    MLP_evaluate_1(&_S164, inputs_29, outputs_24);
    return;
}

__device__ void decode_2(uint first_22, FixedArray<float, 20>  * inputs_30, FixedArray<float, 3>  * outputs_25)
{
    MLP_0 network_3;
    (&(&network_3)->weights_8)->first_0 = first_22;
    MLP_0 _S165 = network_3;
    MLP_evaluate_2(&_S165, inputs_30, outputs_25);
    return;
}

__device__ float3  cross_0(float3  left_0, float3  right_0)
{
    float _S166 = left_0.y;
    float _S167 = right_0.z;
    float _S168 = left_0.z;
    float _S169 = right_0.y;
    float _S170 = right_0.x;
    float _S171 = left_0.x;
    return make_float3 (_S166 * _S167 - _S168 * _S169, _S168 * _S170 - _S171 * _S167, _S171 * _S169 - _S166 * _S170);
}

__device__ float3  normalize_0(float3  x_12)
{
    return x_12 / make_float3 (length_0(x_12));
}

__device__ void dense_9(FloatWeights_0 * weights_25, uint first_23, bool adds_19, FixedArray<float, 8>  * inputs_31, FixedArray<float, 12>  * outputs_26)
{
    dense_part_9(weights_25, first_23, adds_19, inputs_31, outputs_26);
    return;
}

__device__ float2  f16tof32_0(uint2  value_0)
{
    float2  result_7;
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
        *_slang_vector_get_element_ptr(&result_7, i_5) = (__half2float(__ushort_as_half((_slang_vector_get_element(value_0, i_5)))));
        i_5 = i_5 + int(1);
    }
    return result_7;
}

__device__ float2  floor_0(float2  x_13)
{
    float2  result_8;
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
        *_slang_vector_get_element_ptr(&result_8, i_6) = (F32_floor((_slang_vector_get_element(x_13, i_6))));
        i_6 = i_6 + int(1);
    }
    return result_8;
}

__device__ float2  clamp_1(float2  x_14, float2  minBound_1, float2  maxBound_1)
{
    return min_0(max_0(x_14, minBound_1), maxBound_1);
}

__device__ float2  frac_0(float2  x_15)
{
    float2  result_9;
    int i_7 = int(0);
    for(;;)
    {
        if(i_7 < int(2))
        {
        }
        else
        {
            break;
        }
        *_slang_vector_get_element_ptr(&result_9, i_7) = (F32_frac((_slang_vector_get_element(x_15, i_7))));
        i_7 = i_7 + int(1);
    }
    return result_9;
}

__device__ Query_0 slang_ldg_0(Query_0 * ptr_0)
{
    uint _S172 = __ldg(&ptr_0->fabric_1);
    float _S173 = __ldg(&ptr_0->centre_x_0);
    float _S174 = __ldg(&ptr_0->centre_y_0);
    float _S175 = __ldg(&ptr_0->dx_x_0);
    float _S176 = __ldg(&ptr_0->dx_y_0);
    float _S177 = __ldg(&ptr_0->dy_x_0);
    float _S178 = __ldg(&ptr_0->dy_y_0);
    float _S179 = __ldg(&ptr_0->light_x_0);
    float _S180 = __ldg(&ptr_0->light_y_0);
    float _S181 = __ldg(&ptr_0->light_z_0);
    float _S182 = __ldg(&ptr_0->view_x_0);
    float _S183 = __ldg(&ptr_0->view_y_0);
    float _S184 = __ldg(&ptr_0->view_z_0);
    uint _S185 = __ldg(&ptr_0->seed_1);
    Query_0 _S186 = { _S172, _S173, _S174, _S175, _S176, _S177, _S178, _S179, _S180, _S181, _S182, _S183, _S184, _S185 };
    return _S186;
}

__device__ Latent_0 slang_ldg_1(Latent_0 * ptr_1)
{
    uint _S187 = __ldg(&ptr_1->is_trained_1);
    uint _S188 = __ldg(&ptr_1->decoder_1);
    uint _S189 = __ldg(&ptr_1->hidden_0);
    uint _S190 = __ldg(&ptr_1->frames_0);
    uint _S191 = __ldg(&ptr_1->sampler_0);
    uint _S192 = __ldg(&ptr_1->albedo_0);
    uint _S193 = __ldg(&ptr_1->texels_1);
    uint _S194 = __ldg(&ptr_1->texel_elements_1);
    uint _S195 = __ldg(&ptr_1->levels_3);
    float _S196 = __ldg(&ptr_1->last_level_2);
    uint _S197 = __ldg(&ptr_1->face_texels_1);
    uint _S198 = __ldg(&ptr_1->back_1);
    float _S199 = __ldg(&ptr_1->repeats_per_x_1);
    float _S200 = __ldg(&ptr_1->repeats_per_y_1);
    float _S201 = __ldg(&ptr_1->texels_per_mm_1);
    float _S202 = __ldg(&ptr_1->width_0);
    float _S203 = __ldg(&ptr_1->height_0);
    uint _S204 = __ldg(&ptr_1->is_trilinear_0);
    Latent_0 _S205 = { _S187, _S188, _S189, _S190, _S191, _S192, _S193, _S194, _S195, _S196, _S197, _S198, _S199, _S200, _S201, _S202, _S203, _S204 };
    return _S205;
}

__device__ uint mixed_0(uint number_0)
{
    uint bits_0 = (number_0 ^ (number_0 >> int(16))) * 2246822507U;
    uint bits_1 = (bits_0 ^ (bits_0 >> int(13))) * 3266489909U;
    return bits_1 ^ (bits_1 >> int(16));
}

__device__ uint with_number_0(uint hash_0, float number_1)
{
    uint _S206;
    if(number_1 == 0.0f)
    {
        _S206 = 0U;
    }
    else
    {
        _S206 = (F32_asuint((number_1)));
    }
    return mixed_0(hash_0 ^ _S206);
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

__device__ uint hashed_0(Footprint_0 * footprint_0, float3  view_1, float2  size_1)
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
        float _S207 = *_slang_vector_get_element_ptr(&footprint_0->centre_0, axis_0) / _slang_vector_get_element(size_1, axis_0);
        uint _S208 = mixed_0(hash_1 ^ uint((_S207 - (F32_floor((_S207)))) * 4096.0f));
        uint _S209 = axis_0 + 1U;
        hash_1 = _S208;
        axis_0 = _S209;
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
        uint _S210 = with_number_0(hash_1, _slang_vector_get_element(view_1, axis_0));
        uint _S211 = axis_0 + 1U;
        hash_1 = _S210;
        axis_0 = _S211;
    }
    return with_number_0(with_number_0(with_number_0(with_number_0(hash_1, footprint_0->dx_0.x), footprint_0->dx_0.y), footprint_0->dy_0.x), footprint_0->dy_0.y);
}

__device__ float uniform_of_0(uint seed_2, uint dimension_0)
{
    return float((mixed_0(seed_2 + (dimension_0 + 1U) * 2654435769U)) >> int(8)) * 5.9604644775390625e-08f;
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S212 = float2 {direction_0.x, direction_0.y};
    float _S213;
    if(back_2)
    {
        _S213 = - direction_0.z;
    }
    else
    {
        _S213 = direction_0.z;
    }
    return make_float3 (_S212.x, _S212.y, _S213);
}

__device__ float natural_logarithm_0(float x_16)
{
    uint _S214 = (F32_asuint((x_16)));
    float exponent_0 = float(int(_S214 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S214 & 8388607U) | 1056964608U)));
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
    float _S215 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S215 - exponent_1 * 0.00021219444170129f - 0.5f * _S215) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_17)
{
    return natural_logarithm_0(x_17) * 1.4426950216293335f;
}

__device__ Eight_0 no_numbers_0()
{
    Eight_0 numbers_1;
    float4  _S216 = make_float4 (0.0f);
    (&numbers_1)->low_0 = _S216;
    (&numbers_1)->high_0 = _S216;
    return numbers_1;
}

__device__ float2  within_repeat_0(float2  uv_0)
{
    return clamp_1(frac_0(uv_0), make_float2 (0.0f), make_float2 (1.0f));
}

__device__ Eight_0 eight_halves_0(uint4  packed_0)
{
    Eight_0 numbers_2;
    uint _S217 = packed_0.x;
    uint _S218 = packed_0.y;
    (&numbers_2)->low_0 = make_float4 (f16tof32_0(make_uint2 (_S217 & 65535U, _S217 >> 16U)).x, f16tof32_0(make_uint2 (_S217 & 65535U, _S217 >> 16U)).y, f16tof32_0(make_uint2 (_S218 & 65535U, _S218 >> 16U)).x, f16tof32_0(make_uint2 (_S218 & 65535U, _S218 >> 16U)).y);
    uint _S219 = packed_0.z;
    uint _S220 = packed_0.w;
    (&numbers_2)->high_0 = make_float4 (f16tof32_0(make_uint2 (_S219 & 65535U, _S219 >> 16U)).x, f16tof32_0(make_uint2 (_S219 & 65535U, _S219 >> 16U)).y, f16tof32_0(make_uint2 (_S220 & 65535U, _S220 >> 16U)).x, f16tof32_0(make_uint2 (_S220 & 65535U, _S220 >> 16U)).y);
    return numbers_2;
}

__device__ Eight_0 texel_numbers_0(uint first_24, uint elements_1, uint texel_0)
{
    uint _S221 = first_24 + texel_0 * elements_1;
    uint4  _S222 = __ldg((&(globalParams_0->packed_numbers_0)[_S221]));
    if(elements_1 == 1U)
    {
        return eight_halves_0(_S222);
    }
    Eight_0 numbers_3;
    (&numbers_3)->low_0 = asfloat_0(_S222);
    uint4  _S223 = __ldg((&(globalParams_0->packed_numbers_0)[_S221 + 1U]));
    (&numbers_3)->high_0 = asfloat_0(_S223);
    return numbers_3;
}

__device__ void add_bilinear_0(uint first_25, uint elements_2, uint start_1, uint columns_2, uint rows_2, float2  uv_1, float weight_0, Eight_0 * sums_6)
{
    float2  _S224 = uv_1 * make_float2 (float(columns_2), float(rows_2)) - make_float2 (0.5f);
    float2  _S225 = floor_0(_S224);
    float2  _S226 = _S224 - _S225;
    int _S227 = int(_S225.x);
    int _S228 = int(_S225.y);
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
        uint _S229 = tap_0 & 1U;
        uint _S230 = tap_0 >> int(1);
        Eight_0 _S231 = texel_numbers_0(first_25, elements_2, start_1 + (uint(_S228 + int(_S230)) & (rows_2 - 1U)) * columns_2 + (uint(_S227 + int(_S229)) & (columns_2 - 1U)));
        float _S232;
        if(_S230 != 0U)
        {
            _S232 = _S226.y;
        }
        else
        {
            _S232 = 1.0f - _S226.y;
        }
        float _S233;
        if(_S229 != 0U)
        {
            _S233 = _S226.x;
        }
        else
        {
            _S233 = 1.0f - _S226.x;
        }
        float _S234 = _S232 * _S233 * weight_0;
        sums_6->low_0 = sums_6->low_0 + make_float4 (_S234) * _S231.low_0;
        sums_6->high_0 = sums_6->high_0 + make_float4 (_S234) * _S231.high_0;
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

__device__ void TexelPyramid_add_level_0(TexelPyramid_0 * this_4, float2  place_0, uint level_1, uint face_1, float weight_1, Eight_0 * sums_7)
{
    uint _S235 = this_4->levels_4 + 3U * level_1;
    uint _S236 = this_4->first_26;
    uint _S237 = this_4->elements_3;
    uint _S238 = face_1 * this_4->face_texels_2;
    uint _S239 = __ldg((&(globalParams_0->words_0)[_S235]));
    uint _S240 = _S238 + _S239;
    uint _S241 = __ldg((&(globalParams_0->words_0)[_S235 + 1U]));
    uint _S242 = __ldg((&(globalParams_0->words_0)[_S235 + 2U]));
    add_bilinear_0(_S236, _S237, _S240, _S241, _S242, place_0, weight_1, sums_7);
    return;
}

__device__ Eight_0 TexelPyramid_between_levels_0(TexelPyramid_0 * this_5, float2  uv_2, float level_2, uint face_2)
{
    float _S243 = clamp_0(level_2, 0.0f, this_5->last_level_3);
    float _S244 = clamp_0((F32_floor((_S243))), 0.0f, (F32_max((this_5->last_level_3 - 1.0f), (0.0f))));
    float _S245 = _S243 - _S244;
    float2  _S246 = within_repeat_0(uv_2);
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
        float _S247;
        if(offset_2 == 0U)
        {
            _S247 = 1.0f - _S245;
        }
        else
        {
            _S247 = _S245;
        }
        if(_S247 > 0.0f)
        {
            TexelPyramid_add_level_0(this_5, _S246, uint(_S244) + offset_2, face_2, _S247, &texel_1);
        }
        offset_2 = offset_2 + 1U;
    }
    return texel_1;
}

__device__ Eight_0 TexelPyramid_of_level_0(TexelPyramid_0 * this_6, float2  uv_3, uint level_3, uint face_3)
{
    Eight_0 texel_2 = no_numbers_0();
    TexelPyramid_add_level_0(this_6, within_repeat_0(uv_3), level_3, face_3, 1.0f, &texel_2);
    return texel_2;
}

__device__ float channel_0(Eight_0 * numbers_4, int k_0)
{
    float _S248;
    if(k_0 < int(4))
    {
        _S248 = *_slang_vector_get_element_ptr(&numbers_4->low_0, k_0);
    }
    else
    {
        _S248 = *_slang_vector_get_element_ptr(&numbers_4->high_0, k_0 - int(4));
    }
    return _S248;
}

struct LatentFrame_0
{
    float3  tangent_0;
    float3  bitangent_0;
    float3  normal_0;
};

__device__ LatentFrame_0 frame_of_0(float3  normal_1, float3  tangent_1)
{
    LatentFrame_0 result_10;
    float3  _S249 = normalize_0(normal_1 + make_float3 (0.0f, 0.0f, 1.0f));
    (&result_10)->normal_0 = _S249;
    float3  _S250 = normalize_0(tangent_1 + make_float3 (1.0f, 0.0f, 0.0f));
    (&result_10)->tangent_0 = _S250;
    (&result_10)->bitangent_0 = cross_0(_S249, _S250);
    return result_10;
}

__device__ float3  LatentFrame_coordinates_0(LatentFrame_0 * this_7, float3  direction_1)
{
    return make_float3 (dot_1(direction_1, this_7->tangent_0), dot_1(direction_1, this_7->bitangent_0), dot_1(direction_1, this_7->normal_0));
}

__device__ float exponential_0(float x_18)
{
    float _S251 = clamp_0(x_18, -87.0f, 88.0f);
    float _S252 = (F32_floor((_S251 * 1.4426950216293335f + 0.5f)));
    float _S253 = _S251 - _S252 * 0.693359375f + _S252 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S253 + 0.00139819993637502f) * _S253 + 0.00833345204591751f) * _S253 + 0.04166579619050026f) * _S253 + 0.1666666567325592f) * _S253 + 0.5f;
    float _S254 = (U32_asfloat((uint(int(_S252) + int(127)) << int(23))));
    float _S255;
    if(x_18 < -87.0f)
    {
        _S255 = 0.0f;
    }
    else
    {
        _S255 = (p_0 * _S253 * _S253 + _S253 + 1.0f) * _S254;
    }
    return _S255;
}

__device__ float bounded_exponential_0(float exponent_3)
{
    return exponential_0((F32_min((exponent_3), (12.0f))));
}

struct LatentView_0
{
    FixedArray<float, 8>  latent_1;
    LatentFrame_0 first_27;
    LatentFrame_0 second_0;
    float3  view_2;
    bool back_3;
};

__device__ void latent_view_0(uint _S256, Footprint_0 * _S257, float3  _S258, float _S259, LatentView_0 * _S260)
{
    Latent_0 _S261 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[_S256])->latent_0);
    bool _S262 = (_S258.z) < 0.0f;
    _S260->back_3 = _S262;
    _S260->view_2 = to_face_frame_0(_S258, _S262);
    uint _S263;
    if(_S262)
    {
        _S263 = _S261.back_1;
    }
    else
    {
        _S263 = 0U;
    }
    float2  _S264 = _S257->centre_0 * make_float2 (_S261.repeats_per_x_1, _S261.repeats_per_y_1);
    float _S265 = clamp_0(binary_logarithm_0((F32_max(((F32_sqrt(((F32_abs((_S257->dx_0.x * _S257->dy_0.y - _S257->dx_0.y * _S257->dy_0.x)))))) * _S261.texels_per_mm_1), (9.99999971718068537e-10f)))), 0.0f, _S261.last_level_2);
    TexelPyramid_0 pyramid_0;
    (&pyramid_0)->first_26 = _S261.texels_1;
    (&pyramid_0)->elements_3 = _S261.texel_elements_1;
    (&pyramid_0)->levels_4 = _S261.levels_3;
    (&pyramid_0)->last_level_3 = _S261.last_level_2;
    (&pyramid_0)->face_texels_2 = _S261.face_texels_1;
    Eight_0 texel_3;
    if((_S261.is_trilinear_0) != 0U)
    {
        TexelPyramid_0 _S266 = pyramid_0;
        Eight_0 _S267 = TexelPyramid_between_levels_0(&_S266, _S264, _S265, _S263);
        texel_3 = _S267;
    }
    else
    {
        TexelPyramid_0 _S268 = pyramid_0;
        uint _S269 = uint(_S265);
        uint _S270;
        if(_S259 < (_S265 - (F32_floor((_S265)))))
        {
            _S270 = 1U;
        }
        else
        {
            _S270 = 0U;
        }
        uint _S271 = _S269 + _S270;
        TexelPyramid_0 _S272 = _S268;
        Eight_0 _S273 = TexelPyramid_of_level_0(&_S272, _S264, _S271, _S263);
        texel_3 = _S273;
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
        Eight_0 _S274 = texel_3;
        float _S275 = channel_0(&_S274, k_1);
        _S260->latent_1[k_1] = _S275;
        k_1 = k_1 + int(1);
    }
    FloatWeights_0 weights_26;
    (&weights_26)->first_0 = _S261.frames_0;
    FloatWeights_0 _S276 = weights_26;
    FixedArray<float, 12>  sums_8;
    dense_9(&_S276, 0U, false, &_S260->latent_1, &sums_8);
    _S260->first_27 = frame_of_0(make_float3 (sums_8[int(0)], sums_8[int(1)], sums_8[int(2)]), make_float3 (sums_8[int(3)], sums_8[int(4)], sums_8[int(5)]));
    _S260->second_0 = frame_of_0(make_float3 (sums_8[int(6)], sums_8[int(7)], sums_8[int(8)]), make_float3 (sums_8[int(9)], sums_8[int(10)], sums_8[int(11)]));
    return;
}

__device__ float3  latent_value_0(uint _S277, LatentView_0 * _S278, float3  _S279)
{
    Fabric_0 * _S280 = (&(globalParams_0->fabrics_0)[_S277]);
    float3  _S281 = to_face_frame_0(_S279, _S278->back_3);
    if((_S281.z) <= 0.0f)
    {
        return make_float3 (0.0f);
    }
    FixedArray<float, 20>  inputs_32;
    LatentFrame_0 _S282 = _S278->first_27;
    float3  _S283 = LatentFrame_coordinates_0(&_S282, _S278->view_2);
    LatentFrame_0 _S284 = _S278->first_27;
    float3  _S285 = LatentFrame_coordinates_0(&_S284, _S281);
    LatentFrame_0 _S286 = _S278->second_0;
    float3  _S287 = LatentFrame_coordinates_0(&_S286, _S278->view_2);
    LatentFrame_0 _S288 = _S278->second_0;
    float3  _S289 = LatentFrame_coordinates_0(&_S288, _S281);
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
        inputs_32[axis_1] = _slang_vector_get_element(_S283, axis_1);
        inputs_32[int(3) + axis_1] = _slang_vector_get_element(_S285, axis_1);
        inputs_32[int(6) + axis_1] = _slang_vector_get_element(_S287, axis_1);
        inputs_32[int(9) + axis_1] = _slang_vector_get_element(_S289, axis_1);
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
        inputs_32[int(12) + k_2] = _S278->latent_1[k_2];
        k_2 = k_2 + int(1);
    }
    FixedArray<float, 3>  outputs_27;
    Latent_0 _S290 = slang_ldg_1(&_S280->latent_0);
    if((_S290.hidden_0) == 16U)
    {
        decode_2(_S290.decoder_1, &inputs_32, &outputs_27);
    }
    else
    {
        if((_S290.hidden_0) == 32U)
        {
            decode_1(_S290.decoder_1, &inputs_32, &outputs_27);
        }
        else
        {
            decode_0(_S290.decoder_1, &inputs_32, &outputs_27);
        }
    }
    return make_float3 (bounded_exponential_0(outputs_27[int(0)] - 3.0f), bounded_exponential_0(outputs_27[int(1)] - 3.0f), bounded_exponential_0(outputs_27[int(2)] - 3.0f));
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_1, float2  dx_1, float2  dy_1, float3  light_1, float3  view_3)
{
    Footprint_0 footprint_1;
    (&footprint_1)->centre_0 = centre_1;
    (&footprint_1)->dx_0 = dx_1;
    (&footprint_1)->dy_0 = dy_1;
    Latent_0 _S291 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[fabric_2])->latent_0);
    Latent_0 _S292 = slang_ldg_1(&(&(globalParams_0->fabrics_0)[fabric_2])->latent_0);
    float2  _S293 = make_float2 (_S291.width_0, _S292.height_0);
    Footprint_0 _S294 = footprint_1;
    uint _S295 = hashed_0(&_S294, view_3, _S293);
    float _S296 = uniform_of_0(_S295, 0U);
    Footprint_0 _S297 = footprint_1;
    LatentView_0 seen_0;
    latent_view_0(fabric_2, &_S297, view_3, _S296, &seen_0);
    float3  _S298 = latent_value_0(fabric_2, &seen_0, light_1);
    return make_float4 (_S298.x, _S298.y, _S298.z, 0.0f);
}

extern "C" __global__ void latent_queries()
{
    uint _S299 = (blockIdx * blockDim + threadIdx).x;
    uint _S300 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S299 >= _S300)
    {
        return;
    }
    Query_0 _S301 = slang_ldg_0((&(globalParams_0->queries_0)[_S299]));
    *(&(globalParams_0->answers_0)[_S299]) = cloth_value_0(_S301.fabric_1, make_float2 (_S301.centre_x_0, _S301.centre_y_0), make_float2 (_S301.dx_x_0, _S301.dx_y_0), make_float2 (_S301.dy_x_0, _S301.dy_y_0), make_float3 (_S301.light_x_0, _S301.light_y_0, _S301.light_z_0), make_float3 (_S301.view_x_0, _S301.view_y_0, _S301.view_z_0));
    return;
}

