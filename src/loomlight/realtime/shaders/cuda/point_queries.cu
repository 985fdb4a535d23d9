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
__device__ float dot_0(float3  x_3, float3  y_3)
{
    int i_0 = int(0);
    float result_0 = 0.0f;
    for(;;)
    {
        if(i_0 < int(3))
        {
        }
        else
        {
            break;
        }
        float result_1 = result_0 + _slang_vector_get_element(x_3, i_0) * _slang_vector_get_element(y_3, i_0);
        i_0 = i_0 + int(1);
        result_0 = result_1;
    }
    return result_0;
}

__device__ float length_0(float3  x_4)
{
    return (F32_sqrt((dot_0(x_4, x_4))));
}

__device__ float dot_1(float2  x_5, float2  y_4)
{
    int i_1 = int(0);
    float result_2 = 0.0f;
    for(;;)
    {
        if(i_1 < int(2))
        {
        }
        else
        {
            break;
        }
        float result_3 = result_2 + _slang_vector_get_element(x_5, i_1) * _slang_vector_get_element(y_4, i_1);
        i_1 = i_1 + int(1);
        result_2 = result_3;
    }
    return result_2;
}

__device__ float clamp_0(float x_6, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_6), (minBound_0)))), (maxBound_0)));
}

__device__ float lerp_0(float x_7, float y_5, float s_0)
{
    return x_7 + (y_5 - x_7) * s_0;
}

__device__ float saturate_0(float x_8)
{
    return clamp_0(x_8, 0.0f, 1.0f);
}

__device__ float3  normalize_0(float3  x_9)
{
    return x_9 / make_float3 (length_0(x_9));
}

__device__ float3  lerp_1(float3  x_10, float3  y_6, float3  s_1)
{
    return x_10 + (y_6 - x_10) * s_1;
}

__device__ float3  cross_0(float3  left_0, float3  right_0)
{
    float _S1 = left_0.y;
    float _S2 = right_0.z;
    float _S3 = left_0.z;
    float _S4 = right_0.y;
    float _S5 = right_0.x;
    float _S6 = left_0.x;
    return make_float3 (_S1 * _S2 - _S3 * _S4, _S3 * _S5 - _S6 * _S2, _S6 * _S4 - _S1 * _S5);
}

__device__ float3  min_0(float3  x_11, float3  y_7)
{
    float3  result_4;
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
        *_slang_vector_get_element_ptr(&result_4, i_2) = (F32_min((_slang_vector_get_element(x_11, i_2)), (_slang_vector_get_element(y_7, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_4;
}

__device__ float3  max_0(float3  x_12, float3  y_8)
{
    float3  result_5;
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
        *_slang_vector_get_element_ptr(&result_5, i_3) = (F32_max((_slang_vector_get_element(x_12, i_3)), (_slang_vector_get_element(y_8, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_5;
}

__device__ float2  lerp_2(float2  x_13, float2  y_9, float2  s_2)
{
    return x_13 + (y_9 - x_13) * s_2;
}

__device__ float2  floor_0(float2  x_14)
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
        *_slang_vector_get_element_ptr(&result_6, i_4) = (F32_floor((_slang_vector_get_element(x_14, i_4))));
        i_4 = i_4 + int(1);
    }
    return result_6;
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ Query_0 slang_ldg_0(Query_0 * ptr_0)
{
    uint _S7 = __ldg(&ptr_0->fabric_1);
    float _S8 = __ldg(&ptr_0->centre_x_0);
    float _S9 = __ldg(&ptr_0->centre_y_0);
    float _S10 = __ldg(&ptr_0->dx_x_0);
    float _S11 = __ldg(&ptr_0->dx_y_0);
    float _S12 = __ldg(&ptr_0->dy_x_0);
    float _S13 = __ldg(&ptr_0->dy_y_0);
    float _S14 = __ldg(&ptr_0->light_x_0);
    float _S15 = __ldg(&ptr_0->light_y_0);
    float _S16 = __ldg(&ptr_0->light_z_0);
    float _S17 = __ldg(&ptr_0->view_x_0);
    float _S18 = __ldg(&ptr_0->view_y_0);
    float _S19 = __ldg(&ptr_0->view_z_0);
    uint _S20 = __ldg(&ptr_0->seed_1);
    Query_0 _S21 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20 };
    return _S21;
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

__device__ SearchQuality_0 default_quality_0()
{
    SearchQuality_0 quality_0;
    (&quality_0)->steps_per_thread_0 = 5.0f;
    (&quality_0)->steps_per_relief_0 = 8.0f;
    (&quality_0)->shadow_share_0 = 1.0f;
    (&quality_0)->refinements_0 = 2U;
    return quality_0;
}

struct Footprint_0
{
    float2  centre_0;
    float2  dx_0;
    float2  dy_0;
};

__device__ float Footprint_spread_side_0(Footprint_0 * this_0)
{
    return (F32_sqrt((0.5f * (dot_1(this_0->dx_0, this_0->dx_0) + dot_1(this_0->dy_0, this_0->dy_0)))));
}

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S22 = float2 {direction_0.x, direction_0.y};
    float _S23;
    if(back_2)
    {
        _S23 = - direction_0.z;
    }
    else
    {
        _S23 = direction_0.z;
    }
    return make_float3 (_S22.x, _S22.y, _S23);
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    float _S24 = __ldg(&(&(globalParams_0->families_0)[family_0])->inverse_count_0);
    float _S25 = __ldg(&(&(globalParams_0->families_0)[family_0])->half_inverse_count_0);
    float _S26 = (F32_floor(((F32_fma((index_0), (_S24), (_S25))))));
    float _S27 = - _S26;
    float _S28 = __ldg(&(&(globalParams_0->families_0)[family_0])->count_0);
    return make_float2 (_S26, (F32_fma((_S27), (_S28), (index_0))));
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
    float _S29 = __ldg(&(&(globalParams_0->families_0)[family_1])->inverse_size_0);
    float _S30 = (F32_floor((position_0 * _S29)));
    Cell_0 cell_0;
    float _S31 = - _S30;
    float _S32 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    float _S33 = (F32_fma((_S31), (_S32), (position_0)));
    (&cell_0)->below_0 = _S33;
    float _S34 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->above_0 = _S34 - _S33;
    float _S35 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->across_0 = _S33 - 0.5f * _S35;
    float _S36 = __ldg(&(&(globalParams_0->families_0)[family_1])->half_width_0);
    (&cell_0)->half_width_1 = _S36;
    float _S37 = turns_and_remainder_0(family_1, _S30).y;
    float _S38 = __ldg(&(&(globalParams_0->families_0)[family_1])->count_0);
    (&cell_0)->thread_0 = uint(clamp_0(_S37, 0.0f, _S38 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S39 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S39)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float _S40 = __ldg(&(&(globalParams_0->families_0)[family_2])->start_0);
    float _S41 = position_1 - _S40;
    float _S42 = __ldg(&(&(globalParams_0->families_0)[family_2])->inverse_period_0);
    float turns_0 = _S41 * _S42;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    float _S43 = __ldg(&(&(globalParams_0->families_0)[family_2])->period_0);
    float _S44 = turns_1 * _S43;
    float _S45 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    float _S46 = turns_1 * _S45;
    float _S47 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    uint _S48 = uint(clamp_0(_S46, 0.0f, _S47 - 1.0f));
    uint _S49 = __ldg(&(&(globalParams_0->families_0)[family_2])->first_thread_table_0);
    uint _S50 = __ldg((&(globalParams_0->words_0)[_S49 + _S48]));
    uint _S51 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S52;
    if(_S44 >= (table_number_0(_S51 + _S50 * 4U + 1U)))
    {
        _S52 = 1U;
    }
    else
    {
        _S52 = 0U;
    }
    uint _S53 = _S50 + _S52;
    float _S54 = __ldg(&(&(globalParams_0->families_0)[family_2])->count_0);
    uint _S55 = (U32_min((_S53), (uint(_S54) - 1U)));
    uint _S56 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S57 = _S56 + _S55 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S55;
    (&cell_1)->below_0 = _S44 - table_number_0(_S57);
    (&cell_1)->above_0 = table_number_0(_S57 + 1U) - _S44;
    (&cell_1)->across_0 = _S44 - table_number_0(_S57 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S57 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    uint _S58 = __ldg(&(&(globalParams_0->families_0)[family_3])->is_alike_0);
    if(_S58 != 0U)
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Shown_0
{
    bool is_warp_0;
    bool hole_0;
    bool on_top_0;
    uint word_0;
};

struct Crossing_0
{
    Cell_0 warp_1;
    Cell_0 weft_1;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_3)
{
    bool _S59 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S60 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S61;
    if(_S59)
    {
        if(!_S60)
        {
            _S61 = true;
        }
        else
        {
            _S61 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S61 = false;
    }
    (&shown_0)->is_warp_0 = _S61;
    if(!_S59)
    {
        _S61 = !_S60;
    }
    else
    {
        _S61 = false;
    }
    (&shown_0)->hole_0 = _S61;
    uint _S62;
    if((&shown_0)->is_warp_0)
    {
        _S62 = crossing_0->warp_word_0;
    }
    else
    {
        _S62 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S62;
    (&shown_0)->on_top_0 = ((_S62 & 1U) == 1U) != back_3;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S63;
    if(is_first_0)
    {
        _S63 = first_0->thread_0;
    }
    else
    {
        _S63 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S63;
    float _S64;
    if(is_first_0)
    {
        _S64 = first_0->across_0;
    }
    else
    {
        _S64 = second_0->across_0;
    }
    (&cell_2)->across_0 = _S64;
    if(is_first_0)
    {
        _S64 = first_0->half_width_1;
    }
    else
    {
        _S64 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S64;
    if(is_first_0)
    {
        _S64 = first_0->below_0;
    }
    else
    {
        _S64 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S64;
    if(is_first_0)
    {
        _S64 = first_0->above_0;
    }
    else
    {
        _S64 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S64;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S65 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S66 = _S65.x;
    float _S67 = __ldg(&(&(globalParams_0->families_0)[family_4])->period_0);
    uint _S68 = __ldg(&(&(globalParams_0->families_0)[family_4])->place_table_0);
    return (F32_fma((_S66), (_S67), (table_number_0(_S68 + uint(_S65.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    uint _S69 = __ldg(&(&(globalParams_0->families_0)[family_5])->is_alike_0);
    if(_S69 != 0U)
    {
        float _S70 = float(last_0 - first_1);
        float _S71 = __ldg(&(&(globalParams_0->families_0)[family_5])->size_0);
        return _S70 * _S71;
    }
    return boundary_0(family_5, thread_2, last_0) - boundary_0(family_5, thread_2, first_1);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(uint family_6, uint thread_3)
{
    uint _S72 = __ldg(&(&(globalParams_0->families_0)[family_6])->bend_table_0);
    uint _S73 = __ldg(&(&(globalParams_0->families_0)[family_6])->is_alike_0);
    uint _S74;
    if(_S73 != 0U)
    {
        _S74 = 0U;
    }
    else
    {
        _S74 = thread_3 * 4U;
    }
    uint _S75 = _S72 + _S74;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S75);
    (&bend_0)->half_tangent_0 = table_number_0(_S75 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S75 + 2U);
    return bend_0;
}

struct Run_0
{
    float distance_0;
    bool near_start_0;
    float from_start_0;
    float to_end_0;
    float reach_0;
    float other_reach_0;
    Bend_0 bend_1;
    bool straight_0;
    bool first_crossing_0;
    bool last_crossing_0;
};

__device__ Run_0 unpack_0(uint own_0, uint other_0, uint thread_4, Cell_0 * crossed_0, uint word_1)
{
    int _S76 = int((word_1 >> int(1)) & 127U);
    int _S77 = int((word_1 >> int(8)) & 127U);
    int _S78 = int((word_1 >> int(15)) & 63U);
    int _S79 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S80 = crossed_0->thread_0;
    int _S81 = - _S76;
    float _S82 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S81, int(0));
    (&run_0)->from_start_0 = _S82;
    int _S83 = _S77 + int(1);
    float _S84 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S83);
    (&run_0)->to_end_0 = _S84;
    bool _S85 = _S82 < _S84;
    (&run_0)->near_start_0 = _S85;
    int _S86;
    if(_S85)
    {
        _S86 = _S81 - _S78;
    }
    else
    {
        _S86 = _S83;
    }
    int _S87;
    if((&run_0)->near_start_0)
    {
        _S87 = _S81;
    }
    else
    {
        _S87 = _S83 + _S79;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S88;
    if((&run_0)->straight_0)
    {
        _S88 = 1.0e+06f;
    }
    else
    {
        _S88 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S88;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S80, _S86, _S87)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S76 == int(0);
    (&run_0)->last_crossing_0 = _S77 == int(0);
    return run_0;
}

__device__ float square_0(float x_15)
{
    return x_15 * x_15;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_3)
{
    float _S89 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S90 = clamp_0(cell_3->across_0, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_1 = _S90;
    float _S91 = _S89 * _S89 - square_0(_S90);
    float _S92 = (F32_rsqrt((_S91)));
    (&section_0)->drop_0 = _S89 - _S91 * _S92;
    (&section_0)->slope_0 = - _S90 * _S92;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    uint _S93 = __ldg(&(&(globalParams_0->families_0)[family_7])->is_alike_0);
    if(_S93 != 0U)
    {
        uint _S94 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
        return table_number_0(_S94 + 3U);
    }
    uint _S95 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
    return table_number_0(_S95 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S96 = crossed_1->below_0;
    float _S97 = crossed_1->above_0;
    bool _S98 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S99 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S100;
    if(_S98)
    {
        _S100 = _S96 - crossed_1->across_0;
    }
    else
    {
        _S100 = _S97 + crossed_1->across_0;
    }
    float _S101 = _S100 - crossed_1->half_width_1;
    bool _S102;
    if(_S98)
    {
        _S102 = run_1->first_crossing_0;
    }
    else
    {
        _S102 = run_1->last_crossing_0;
    }
    bool _S103 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S100 = 0.0f;
    }
    else
    {
        float _S104 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        _S100 = _S104 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S105;
    if(_S103 != _S102)
    {
        _S105 = 0.0f;
    }
    else
    {
        float _S106 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        uint _S107 = crossed_1->thread_0;
        int _S108;
        if(_S98)
        {
            _S108 = int(-1);
        }
        else
        {
            _S108 = int(1);
        }
        _S105 = _S106 * edge_drop_0(other_1, _S107, _S108);
    }
    float _S109 = 1.0f / (F32_max((2.0f * _S101), (9.999999960041972e-13f)));
    float _S110 = clamp_0((_S101 - _S99) * _S109, 0.0f, 1.0f);
    float _S111 = _S100 + (_S105 - _S100) * (_S110 * _S110 * (3.0f - 2.0f * _S110));
    float _S112 = (_S100 - _S105) * (6.0f * _S110 * (1.0f - _S110) * _S109);
    if(_S98)
    {
        _S100 = 1.0f;
    }
    else
    {
        _S100 = -1.0f;
    }
    return make_float2 (_S111, _S112 * _S100);
}

struct StepControl_0
{
    float step_2;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_1;
    bool up_0;
};

__device__ StepControl_0 step_control_0(float2  direction_1, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S113 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S113)))), (9.99999971718068537e-10f)));
    float _S114 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S114)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S113 > 0.0f;
    (&control_0)->up_0 = _S114 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_0;
    bool known_0;
};

__device__ PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    (&previous_0)->clearance_0 = 0.0f;
    (&previous_0)->rate_0 = 0.0f;
    (&previous_0)->yarn_0 = 0U;
    (&previous_0)->known_0 = false;
    return previous_0;
}

__device__ float outline_distance_0(Cell_0 * cell_4, Shown_0 * shown_2, Run_0 * run_2, bool lengthwise_0, bool forwards_0)
{
    float _S115;
    if(forwards_0)
    {
        _S115 = cell_4->across_0;
    }
    else
    {
        _S115 = - cell_4->across_0;
    }
    float _S116;
    if(forwards_0)
    {
        _S116 = cell_4->above_0;
    }
    else
    {
        _S116 = cell_4->below_0;
    }
    bool _S117;
    if(forwards_0)
    {
        _S117 = run_2->last_crossing_0;
    }
    else
    {
        _S117 = run_2->first_crossing_0;
    }
    bool _S118;
    if(forwards_0)
    {
        _S118 = run_2->first_crossing_0;
    }
    else
    {
        _S118 = run_2->last_crossing_0;
    }
    float _S119 = cell_4->half_width_1;
    float _S120 = - cell_4->half_width_1;
    bool _S121 = _S115 < _S120;
    bool _S122 = _S115 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S117 = !_S117;
    }
    else
    {
        _S117 = false;
    }
    if(_S117)
    {
        _S117 = !shown_2->hole_0;
    }
    else
    {
        _S117 = false;
    }
    bool _S123;
    if(_S117)
    {
        _S123 = shown_2->on_top_0;
    }
    else
    {
        _S123 = false;
    }
    if(_S123)
    {
        if(_S118)
        {
            _S118 = _S121;
        }
        else
        {
            _S118 = false;
        }
        _S118 = !_S118;
    }
    else
    {
        _S118 = false;
    }
    if(shown_2->hole_0)
    {
        _S117 = true;
    }
    else
    {
        if(_S117)
        {
            _S117 = !shown_2->on_top_0;
        }
        else
        {
            _S117 = false;
        }
    }
    float _S124;
    if(_S121)
    {
        _S124 = _S120;
    }
    else
    {
        _S124 = _S119;
    }
    float _S125 = _S124 - _S115;
    if(_S117)
    {
        _S115 = 2.0f * _S116 + _S115 - _S119;
    }
    else
    {
        _S115 = _S116;
    }
    if(_S118)
    {
        if(forwards_0)
        {
            _S115 = run_2->to_end_0;
        }
        else
        {
            _S115 = run_2->from_start_0;
        }
        return _S115;
    }
    if(_S122)
    {
    }
    else
    {
        _S115 = _S125;
    }
    return _S115;
}

struct Probe_0
{
    float height_2;
    bool hole_1;
    float slope_x_0;
    float slope_y_0;
    uint yarn_1;
    float cell_max_0;
    float side_x_0;
    float side_y_0;
    float edge_x_0;
    float edge_y_0;
};

__device__ float way_back_to_dip_0(PreviousSample_0 * previous_1, float clearance_1, float rate_1, float step_4, Probe_0 * here_0)
{
    float _S126 = previous_1->rate_0;
    float _S127 = previous_1->rate_0 * step_4;
    float _S128 = rate_1 * step_4;
    bool _S129;
    if(!previous_1->known_0)
    {
        _S129 = true;
    }
    else
    {
        _S129 = here_0->hole_1;
    }
    if(_S129)
    {
        _S129 = true;
    }
    else
    {
        _S129 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S129)
    {
        _S129 = true;
    }
    else
    {
        _S129 = _S126 >= 0.0f;
    }
    if(_S129)
    {
        _S129 = true;
    }
    else
    {
        _S129 = rate_1 <= 0.0f;
    }
    if(_S129)
    {
        return -1.0f;
    }
    float _S130 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S127) >= 0.0f)
    {
        _S129 = (3.0f * clearance_1 - _S128) >= 0.0f;
    }
    else
    {
        _S129 = false;
    }
    if(_S129)
    {
        return -1.0f;
    }
    float _S131 = clearance_1 - _S130;
    float _S132 = 6.0f * _S131 - 4.0f * _S127 - 2.0f * _S128;
    float _S133 = -2.0f * _S127 / (F32_max((_S132 + (F32_sqrt(((F32_max((_S132 * _S132 - 4.0f * (3.0f * (_S127 + _S128 - 2.0f * _S131)) * _S127), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S134 = 1.0f - _S133;
    float _S135 = (_S130 * (2.0f * _S133 + 1.0f) + _S127 * _S133) * _S134 * _S134;
    float _S136 = (clearance_1 * (2.0f * _S134 + 1.0f) - _S128 * _S134) * _S133 * _S133;
    if(_S133 > 0.01999999955296516f)
    {
        _S129 = _S134 > 0.01999999955296516f;
    }
    else
    {
        _S129 = false;
    }
    if(_S129)
    {
        _S129 = (_S135 + _S136) < 0.0f;
    }
    else
    {
        _S129 = false;
    }
    float _S137;
    if(_S129)
    {
        _S137 = _S134 * step_4;
    }
    else
    {
        _S137 = -1.0f;
    }
    return _S137;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S138 = here_1->hole_1;
    float _S139;
    if(here_1->hole_1)
    {
        _S139 = 1.0e+09f;
    }
    else
    {
        _S139 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S139;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S140;
    if(!_S138)
    {
        _S140 = !is_cell_exit_0;
    }
    else
    {
        _S140 = false;
    }
    (&previous_2)->known_0 = _S140;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S141 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S142;
    if(!here_2->hole_1)
    {
        _S142 = (rate_3 * _S141 + clearance_3) < 0.0f;
    }
    else
    {
        _S142 = false;
    }
    if(_S142)
    {
        _S142 = _S141 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S142 = false;
    }
    float _S143 = this_2->step_2;
    float _S144;
    if(_S142)
    {
        _S144 = _S141 - this_2->epsilon_0;
    }
    else
    {
        _S144 = (F32_max((_S141), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S143), (_S144)));
}

struct ViewRay_0
{
    float2  origin_0;
    float2  slope_1;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_3, float height_3)
{
    return this_3->origin_0 + this_3->slope_1 * make_float2 (height_3);
}

__device__ float ViewRay_rate_0(ViewRay_0 * this_4, Probe_0 * here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S145 = end_0 - start_1;
    float _S146 = start_rate_0 + end_rate_0 - 2.0f * _S145;
    float _S147 = 3.0f * _S145 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S145), (9.99999968265522539e-21f)));
    int i_5 = int(0);
    for(;;)
    {
        if(uint(i_5) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S148 = clamp_0(share_1 - (((_S146 * share_1 + _S147) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S146 * share_1 + 2.0f * _S147) * share_1 + start_rate_0), (0.10000000149011612f * _S145 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S149 = i_5 + int(1);
        share_1 = _S148;
        i_5 = _S149;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S150 = along_slope_0 * along_slope_0 + 1.0f;
    float _S151 = (F32_rsqrt((_S150)));
    float _S152 = sine_1 * _S151 * (F32_rsqrt((_S150 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S152 * _S150, _S152 * across_slope_0 * along_slope_0 + cosine_0 * _S151);
}

__device__ float arc_sine_0(float x_16)
{
    float _S153 = (F32_abs((x_16)));
    bool _S154 = _S153 > 0.5f;
    float _S155;
    if(_S154)
    {
        _S155 = 0.5f * (1.0f - _S153);
    }
    else
    {
        _S155 = _S153 * _S153;
    }
    float _S156;
    if(_S154)
    {
        _S156 = (F32_sqrt(((F32_max((_S155), (0.0f))))));
    }
    else
    {
        _S156 = _S153;
    }
    float _S157 = ((((0.04216320067644119f * _S155 + 0.02418131195008755f) * _S155 + 0.04547002539038658f) * _S155 + 0.07495300471782684f) * _S155 + 0.16666752099990845f) * _S155 * _S156 + _S156;
    if(_S154)
    {
        _S155 = 1.57079637050628662f - 2.0f * _S157;
    }
    else
    {
        _S155 = _S157;
    }
    if(x_16 < 0.0f)
    {
        _S155 = - _S155;
    }
    return _S155;
}

struct Hair_0
{
    float cover_0;
    float3  normal_0;
    float3  tangent_0;
};

__device__ Hair_0 Hair_x24init_0(float cover_1, float3  normal_1, float3  tangent_1)
{
    Hair_0 _S158;
    (&_S158)->cover_0 = cover_1;
    (&_S158)->normal_0 = normal_1;
    (&_S158)->tangent_0 = tangent_1;
    return _S158;
}

__device__ float fade_0(float size_1, float period_1)
{
    return clamp_0((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S159 = value_0 * 747796405U + 2891336453U;
    uint _S160 = ((_S159 >> ((_S159 >> int(28)) + 4U)) ^ _S159) * 277803737U;
    return (_S160 >> int(22)) ^ _S160;
}

__device__ uint hash_key_0(uint thread_6, uint stream_0)
{
    return scramble_0(thread_6 + scramble_0(stream_0));
}

__device__ uint hash_bits_0(uint key_0, uint cell_5)
{
    return scramble_0(cell_5 + key_0);
}

__device__ float share_of_0(uint bits_0)
{
    return (float(bits_0 & 1023U) + 0.5f) * 0.0009765625f;
}

__device__ float2  sine_cosine_0(float x_17)
{
    float _S161 = (F32_floor((x_17 * 0.63661974668502808f + 0.5f)));
    float _S162 = x_17 - _S161 * 1.5703125f - _S161 * 0.00048375129699707f - _S161 * 7.54979012640433211e-08f;
    float _S163 = _S162 * _S162;
    float _S164 = ((-0.00019515295571182f * _S163 + 0.00833216123282909f) * _S163 - 0.16666655242443085f) * _S163 * _S162 + _S162;
    float _S165 = ((0.00002443315679557f * _S163 - 0.00138873164542019f) * _S163 + 0.04166664555668831f) * _S163 * _S163 - 0.5f * _S163 + 1.0f;
    uint _S166 = uint(int(_S161)) & 3U;
    float2  _S167;
    if((_S166 & 1U) != 0U)
    {
        _S167 = make_float2 (_S165, _S164);
    }
    else
    {
        _S167 = make_float2 (_S164, _S165);
    }
    float _S168;
    if((_S166 & 2U) != 0U)
    {
        _S168 = - _S167.x;
    }
    else
    {
        _S168 = _S167.x;
    }
    float _S169;
    if(((_S166 + 1U) & 2U) != 0U)
    {
        _S169 = - _S167.y;
    }
    else
    {
        _S169 = _S167.y;
    }
    return make_float2 (_S168, _S169);
}

__device__ float3  table_colour_0(uint index_2)
{
    return make_float3 (table_number_0(index_2), table_number_0(index_2 + 1U), table_number_0(index_2 + 2U));
}

struct Albedos_0
{
    float3  diffuse_reflect_0;
    float3  diffuse_transmit_0;
    float3  specular_reflect_0;
    float3  specular_transmit_0;
};

__device__ Albedos_0 table_albedos_0(uint row_0)
{
    Albedos_0 albedos_0;
    (&albedos_0)->diffuse_reflect_0 = table_colour_0(row_0);
    (&albedos_0)->diffuse_transmit_0 = table_colour_0(row_0 + 3U);
    (&albedos_0)->specular_reflect_0 = table_colour_0(row_0 + 6U);
    (&albedos_0)->specular_transmit_0 = table_colour_0(row_0 + 9U);
    return albedos_0;
}

__device__ Albedos_0 albedos_of_0(uint family_8, uint thread_7)
{
    uint _S170 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_table_0);
    uint _S171 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_stride_0);
    return table_albedos_0(_S170 + _S171 * thread_7);
}

__device__ float3  fibre_cell_0(float across_2, float along_0, float width_2)
{
    float _S172 = (F32_floor((across_2 / width_2)));
    return make_float3 (_S172, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S172, 2.0f * (across_2 / width_2 - _S172) - 1.0f);
}

struct SurfacePoint_0
{
    bool hole_2;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_4;
    float3  normal_2;
    float3  tangent_2;
    float across_3;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ float ply_offset_0(uint family_9, SurfacePoint_0 * point_0, bool back_4)
{
    float _S173;
    if(back_4)
    {
        float _S174 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S173 = - _S174;
    }
    else
    {
        float _S175 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S173 = _S175;
    }
    float _S176 = point_0->fibre_across_0;
    float _S177 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_cosine_0);
    float _S178 = _S176 * _S177 + point_0->fibre_along_0 * _S173;
    float _S179 = __ldg(&(&(globalParams_0->families_0)[family_9])->plies_per_mm_0);
    float _S180 = _S178 * _S179;
    return 2.0f * (_S180 - (F32_floor((_S180)))) - 1.0f;
}

__device__ float signed_noise_0(uint bits_1)
{
    return (float(bits_1 & 65535U) + 0.5f) * 0.000030517578125f - 1.0f;
}

__device__ float smooth_share_0(float share_2)
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

__device__ float2  wave_noise_0(uint key_1, float position_3)
{
    float _S181 = (F32_floor((position_3)));
    float _S182 = position_3 - _S181;
    uint _S183 = uint(int(_S181));
    float _S184 = signed_noise_0(hash_bits_0(key_1, _S183));
    float _S185 = signed_noise_0(hash_bits_0(key_1, _S183 + 1U));
    return make_float2 (lerp_0(_S184, _S185, smooth_share_0(_S182)), 6.0f * _S182 * (1.0f - _S182) * (_S185 - _S184));
}

__device__ float2  cell_noise_0(uint key_2, float3  cell_6)
{
    float _S186 = cell_6.y;
    float _S187 = (F32_floor((_S186)));
    uint _S188 = uint(int(cell_6.x)) * 65536U + uint(int(_S187));
    uint _S189 = hash_bits_0(key_2, _S188);
    uint _S190 = hash_bits_0(key_2, _S188 + 1U);
    return lerp_2(make_float2 (signed_noise_0(_S189), signed_noise_0(_S189 >> int(16))), make_float2 (signed_noise_0(_S190), signed_noise_0(_S190 >> int(16))), make_float2 (smooth_share_0(_S186 - _S187)));
}

__device__ float uniform_hash_0(uint thread_8, uint cell_7, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_8, stream_1), cell_7)) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_9, float amount_0, uint seed_2)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_2 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_1, float3  room_0)
{
    float3  _S191 = room_0 / max_0(albedo_1, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S191.x), (_S191.y)))), (_S191.z)))), (0.0f))))));
}

__device__ float flattened_0(float largest_0, float3  albedo_2, float3  room_1)
{
    float3  _S192 = room_1 / max_0(albedo_2, make_float3 (9.99999997475242708e-07f)) - make_float3 (1.0f);
    return (F32_min(((F32_max(((F32_min(((F32_min((_S192.x), (_S192.y)))), (_S192.z)))), (0.0f))) / (F32_max((largest_0), (9.99999997475242708e-07f)))), (1.0f)));
}

__device__ float natural_logarithm_0(float x_18)
{
    uint _S193 = (F32_asuint((x_18)));
    float exponent_0 = float(int(_S193 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S193 & 8388607U) | 1056964608U)));
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
    float _S194 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S194 - exponent_1 * 0.00021219444170129f - 0.5f * _S194) + exponent_1 * 0.693359375f;
}

__device__ float fibre_gain_0(uint thread_10, uint cell_8, float amount_1, uint seed_3)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_10, cell_8, seed_3 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3  normal_3;
    float3  tangent_3;
    float loss_0;
};

__device__ YarnFrame_0 under_hair_0(YarnFrame_0 * frame_0, Hair_0 * hair_0)
{
    float3  _S195 = frame_0->tangent_3;
    float3  _S196 = hair_0->tangent_0;
    float3  _S197;
    if((dot_0(frame_0->tangent_3, hair_0->tangent_0)) < 0.0f)
    {
        _S197 = - _S196;
    }
    else
    {
        _S197 = _S196;
    }
    YarnFrame_0 blended_0;
    float3  _S198 = make_float3 (hair_0->cover_0);
    float3  _S199 = normalize_0(lerp_1(frame_0->normal_3, hair_0->normal_0, _S198));
    (&blended_0)->normal_3 = _S199;
    float3  _S200 = lerp_1(_S195, _S197, _S198);
    float3  _S201 = _S200 - make_float3 (dot_0(_S200, _S199)) * _S199;
    (&blended_0)->tangent_3 = _S201 * make_float3 ((F32_rsqrt(((F32_max((dot_0(_S201, _S201)), (9.999999960041972e-13f)))))));
    (&blended_0)->loss_0 = frame_0->loss_0 * (1.0f - hair_0->cover_0);
    return blended_0;
}

__device__ float diffuse_gain_0(YarnFrame_0 * frame_1, float blend_0)
{
    return (F32_min((0.85000002384185791f * blend_0 * frame_1->loss_0 + 1.0f), (1.0f / (0.5f * blend_0 * (frame_1->normal_3.z - 1.0f) + 1.0f))));
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
    float3  _S202 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S203 = sends_0->sky_warp_0 + _S202 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S203;
    float3  _S204 = sends_0->sky_weft_0 + _S202 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S204;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S203 + make_float3 (sends_0->blocks_weft_0) * _S204;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

struct Bounced_0
{
    float3  reflected_0;
    float3  transmitted_0;
};

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

struct Scattered_0
{
    float3  back_5;
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

__device__ Bounced_0 bounced_by_0(Blocked_0 * blocked_0, Scattered_0 * yarn_2, Interior_0 * interior_0)
{
    float3  _S205 = make_float3 (blocked_0->by_warp_0 + blocked_0->by_weft_0) * interior_0->leaked_1;
    float3  _S206 = make_float3 (blocked_0->far_0) * yarn_2->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_5 * (make_float3 (blocked_0->by_warp_0) * interior_0->warp_3 + make_float3 (blocked_0->by_weft_0) * interior_0->weft_3) + _S206 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S206 * interior_0->far_1 + yarn_2->back_5 * _S205;
    return bounced_0;
}

__device__ float diffuse_reflection_0(float3  light_1, float3  normal_4, float blend_1)
{
    float _S207 = light_1.z;
    if(_S207 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S207), (0.0f))), (F32_max((dot_0(light_1, normal_4)), (0.0f))), blend_1);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_4, float roughness_1)
{
    float _S208 = dot_0(direction_2, tangent_4);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S208 * _S208 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_19)
{
    float _S209 = clamp_0(x_19, -87.0f, 88.0f);
    float _S210 = (F32_floor((_S209 * 1.4426950216293335f + 0.5f)));
    float _S211 = _S209 - _S210 * 0.693359375f + _S210 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S211 + 0.00139819993637502f) * _S211 + 0.00833345204591751f) * _S211 + 0.04166579619050026f) * _S211 + 0.1666666567325592f) * _S211 + 0.5f;
    float _S212 = (U32_asfloat((uint(int(_S210) + int(127)) << int(23))));
    float _S213;
    if(x_19 < -87.0f)
    {
        _S213 = 0.0f;
    }
    else
    {
        _S213 = (p_0 * _S211 * _S211 + _S211 + 1.0f) * _S212;
    }
    return _S213;
}

__device__ float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

__device__ float square_1(float3  v_1)
{
    return dot_0(v_1, v_1);
}

__device__ float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S214 = roughness_2 * roughness_2;
    float _S215 = squared_along_0 * (1.0f - _S214) + _S214;
    return 0.31830987334251404f * _S214 * roughness_2 / (_S215 * _S215);
}

__device__ float density_between_0(float3  light_2, float3  view_1, float3  tangent_5, float roughness_3)
{
    float3  _S216 = light_2 + view_1;
    float _S217 = dot_0(_S216, tangent_5);
    return flake_density_0((F32_min((_S217 * _S217 / (F32_max((square_1(_S216)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_3, float3  view_2, float3  normal_5, float3  tangent_6, float roughness_4, float optical_depth_1)
{
    float _S218 = dot_0(light_3, normal_5);
    bool _S219;
    if(_S218 <= 0.0f)
    {
        _S219 = true;
    }
    else
    {
        _S219 = (dot_0(view_2, normal_5)) <= 0.0f;
    }
    if(_S219)
    {
        return 0.0f;
    }
    float _S220 = (F32_max((_S218), (9.99999997475242708e-07f)));
    float _S221 = (F32_max((dot_0(view_2, normal_5)), (9.99999997475242708e-07f)));
    float _S222 = projected_area_1(light_3, tangent_6, roughness_4) * _S221 + projected_area_1(view_2, tangent_6, roughness_4) * _S220;
    float _S223 = optical_depth_1 * _S222 / (_S220 * _S221);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S223 * mean_attenuation_0(_S223)) * _S220 / _S222;
}

__device__ float transmission_1(float3  light_4, float3  view_3, float3  normal_6, float3  tangent_7, float roughness_5, float optical_depth_2)
{
    float _S224 = - dot_0(light_4, normal_6);
    float _S225 = dot_0(view_3, normal_6);
    bool _S226;
    if(_S224 <= 0.0f)
    {
        _S226 = true;
    }
    else
    {
        _S226 = _S225 <= 0.0f;
    }
    if(_S226)
    {
        return 0.0f;
    }
    float _S227 = 1.0f / (F32_max((_S225), (9.99999997475242708e-07f)));
    float _S228 = projected_area_1(light_4, tangent_7, roughness_5) / (F32_max((_S224), (9.99999997475242708e-07f)));
    float _S229 = projected_area_1(view_3, tangent_7, roughness_5) * _S227;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S228), (_S229)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S228 - _S229)))) * _S227;
}

__device__ float sheen_scale_0(float x_20, float y_10)
{
    return (((((0.0f * x_20 + (((((-1.1402510404586792f * y_10 + 0.40672621130943298f) * y_10 + 1.65398800373077393f) * y_10 + -1.29730904102325439f) * y_10 + 0.30570998787879944f) * y_10 + -0.0220868494361639f)) * x_20 + (((((-0.21142719686031342f * y_10 + 1.05947399139404297f) * y_10 + -0.41116121411323547f) * y_10 + -0.93859231472015381f) * y_10 + 0.51606941223144531f) * y_10 + 0.05409301072359085f)) * x_20 + (((((1.22944498062133789f * y_10 + -0.45962560176849365f) * y_10 + -1.63861405849456787f) * y_10 + 1.33565104007720947f) * y_10 + -0.45725581049919128f) * y_10 + 0.08243165910243988f)) * x_20 + (((((0.39779931306838989f * y_10 + -1.18879103660583496f) * y_10 + 0.28251591324806213f) * y_10 + 1.168984055519104f) * y_10 + -0.76864629983901978f) * y_10 + 0.0091691892594099f)) * x_20 + (((((-0.26563560962677002f * y_10 + -0.19379159808158875f) * y_10 + 0.2677634060382843f) * y_10 + 0.00270519289188087f) * y_10 + 0.14349560439586639f) * y_10 + 0.10290180146694183f)) * x_20 + (((((-0.20701569318771362f * y_10 + 0.24526430666446686f) * y_10 + 0.19551840424537659f) * y_10 + 0.07586126774549484f) * y_10 + 0.38894739747047424f) * y_10 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_21, float y_11)
{
    return ((((0.0f * x_21 + (((((-0.10608240216970444f * y_11 + 1.99214303493499756f) * y_11 + -1.42255294322967529f) * y_11 + -1.09495604038238525f) * y_11 + 0.59180057048797607f) * y_11 + 0.06902855634689331f)) * x_21 + (((((-0.46220690011978149f * y_11 + -0.29113379120826721f) * y_11 + 1.39025199413299561f) * y_11 + 0.35589990019798279f) * y_11 + -1.17120099067687988f) * y_11 + 0.15940259397029877f)) * x_21 + (((((2.26068711280822754f * y_11 + -3.64728999137878418f) * y_11 + -0.72173482179641724f) * y_11 + 3.07659196853637695f) * y_11 + -0.6827620267868042f) * y_11 + -0.3039557933807373f)) * x_21 + (((((0.81201767921447754f * y_11 + 0.36014080047607422f) * y_11 + -1.72646903991699219f) * y_11 + -0.22630110383033752f) * y_11 + 0.89514690637588501f) * y_11 + -0.10397960245609283f)) * x_21 + (((((-0.37648698687553406f * y_11 + 1.10974001884460449f) * y_11 + 0.17824520170688629f) * y_11 + -1.04968702793121338f) * y_11 + 0.1461234986782074f) * y_11 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_22, float y_12)
{
    return ((((0.0f * x_22 + (((((12.95646953582763672f * y_12 + -21.38032913208007812f) * y_12 + -7.37853097915649414f) * y_12 + 34.55607986450195312f) * y_12 + -23.61347007751464844f) * y_12 + 5.00126314163208008f)) * x_22 + (((((10.91487026214599609f * y_12 + -6.08202791213989258f) * y_12 + -38.2036285400390625f) * y_12 + 53.3440399169921875f) * y_12 + -21.91996002197265625f) * y_12 + 2.01606011390686035f)) * x_22 + (((((-14.52206039428710938f * y_12 + 36.803619384765625f) * y_12 + -22.94047927856445312f) * y_12 + -10.07973003387451172f) * y_12 + 15.77003955841064453f) * y_12 + -4.92722177505493164f)) * x_22 + (((((-7.62505722045898438f * y_12 + 1.27310299873352051f) * y_12 + 31.19523048400878906f) * y_12 + -44.39989852905273438f) * y_12 + 26.44947052001953125f) * y_12 + -8.73507976531982422f)) * x_22 + (((((5.65633487701416016f * y_12 + -17.66820907592773438f) * y_12 + 24.65356063842773438f) * y_12 + -19.38941001892089844f) * y_12 + 11.06159019470214844f) * y_12 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S230 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S231 = 2.0f * (F32_sqrt((_S230))) - 1.0f;
    float _S232 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S231, _S232), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S230) * sheen_shear_0(_S231, _S232), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S231, _S232), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_5, float3  view_4, float scale_0, float shear_0)
{
    float _S233 = light_5.z;
    bool _S234;
    if(_S233 <= 0.0f)
    {
        _S234 = true;
    }
    else
    {
        _S234 = (view_4.z) <= 0.0f;
    }
    if(_S234)
    {
        return 0.0f;
    }
    float2  _S235 = float2 {view_4.x, view_4.y};
    float _S236 = dot_1(_S235, _S235);
    float2  _S237;
    if(_S236 > 9.99999968265522539e-21f)
    {
        _S237 = _S235 * make_float2 ((F32_rsqrt((_S236))));
    }
    else
    {
        _S237 = make_float2 (1.0f, 0.0f);
    }
    float _S238 = scale_0 * dot_1(float2 {light_5.x, light_5.y}, _S237) + shear_0 * _S233;
    float _S239 = scale_0 * (light_5.y * _S237.x - light_5.x * _S237.y);
    float _S240 = _S238 * _S238 + _S239 * _S239 + _S233 * _S233;
    return 0.31830987334251404f * scale_0 * scale_0 * _S233 / (F32_max((_S240 * _S240), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_6, float3  view_5, float strength_0, float roughness_7)
{
    float3  _S241 = sheen_lobe_0(view_5.z, roughness_7);
    float _S242 = strength_0 * _S241.z;
    return make_float2 (_S242 * transformed_cosine_0(light_6, view_5, _S241.x, _S241.y), 1.0f - _S242);
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_7, float3  view_6)
{
    float _S243 = light_7.z;
    float3  _S244;
    if((_S243 * view_6.z) < 0.0f)
    {
        _S244 = bounced_1->transmitted_0;
    }
    else
    {
        _S244 = bounced_1->reflected_0;
    }
    return _S244 * make_float3 ((F32_abs((_S243))) * 0.31830987334251404f);
}

struct YarnPoint_0
{
    bool back_6;
    bool hole_3;
    bool is_warp_2;
    float x_23;
    float y_13;
    float height_5;
    float3  normal_7;
    float3  tangent_8;
    float3  surface_normal_0;
    float diffuse_gain_1;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_24;
    float y_14;
    bool hole_4;
    float height_6;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_7;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

__device__ Crossing_0 crossing_at_0(uint _S245, float _S246, float _S247, bool _S248)
{
    Fabric_0 * _S249 = (&(globalParams_0->fabrics_0)[_S245]);
    Crossing_0 crossing_2;
    uint _S250 = __ldg(&_S249->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S250, _S246);
    uint _S251 = __ldg(&_S249->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S251, _S247);
    uint _S252 = __ldg(&_S249->run_words_0);
    uint _S253 = (&(&crossing_2)->weft_1)->thread_0;
    uint _S254 = __ldg(&_S249->ends_1);
    uint _S255 = _S252 + 2U * (_S253 * _S254 + (&(&crossing_2)->warp_1)->thread_0);
    uint _S256 = __ldg((&(globalParams_0->words_0)[_S255]));
    (&crossing_2)->warp_word_0 = _S256;
    uint _S257 = __ldg((&(globalParams_0->words_0)[_S255 + 1U]));
    (&crossing_2)->weft_word_0 = _S257;
    (&crossing_2)->warp_above_0 = ((_S256 & 1U) == 1U) != _S248;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S258, float _S259, float _S260, bool _S261)
{
    Fabric_0 * _S262 = (&(globalParams_0->fabrics_0)[_S258]);
    Sample_0 sample_0;
    Crossing_0 _S263 = crossing_at_0(_S258, _S259, _S260, _S261);
    (&sample_0)->crossing_1 = _S263;
    Crossing_0 _S264 = _S263;
    Shown_0 _S265 = shown_at_0(&_S264, _S261);
    (&sample_0)->shown_3 = _S265;
    uint _S266;
    if(_S265.is_warp_0)
    {
        uint _S267 = __ldg(&_S262->warp_0);
        _S266 = _S267;
    }
    else
    {
        uint _S268 = __ldg(&_S262->weft_0);
        _S266 = _S268;
    }
    uint _S269;
    if(_S265.is_warp_0)
    {
        uint _S270 = __ldg(&_S262->weft_0);
        _S269 = _S270;
    }
    else
    {
        uint _S271 = __ldg(&_S262->warp_0);
        _S269 = _S271;
    }
    Cell_0 _S272 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S273 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S274 = select_cell_0(_S265.is_warp_0, &_S272, &_S273);
    Cell_0 _S275 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S276 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S277 = select_cell_0(_S265.is_warp_0, &_S275, &_S276);
    Cell_0 _S278 = _S277;
    Run_0 _S279 = unpack_0(_S266, _S269, _S274.thread_0, &_S278, _S265.word_0);
    Cell_0 _S280 = _S274;
    Section_0 _S281 = section_at_0(&_S280);
    bool _S282;
    if(_S265.on_top_0)
    {
        _S282 = (_S279.distance_0) < (_S281.drop_0 * _S279.bend_1.sine_0);
    }
    else
    {
        _S282 = false;
    }
    bool _S283;
    if(_S265.on_top_0)
    {
        _S283 = !_S282;
    }
    else
    {
        _S283 = false;
    }
    float _S284;
    if(_S283)
    {
        _S284 = 1.0f;
    }
    else
    {
        _S284 = -1.0f;
    }
    float _S285;
    if(_S282)
    {
        _S285 = _S279.other_reach_0;
    }
    else
    {
        _S285 = _S279.reach_0;
    }
    float _S286;
    if(_S282)
    {
        _S286 = _S285 + _S279.distance_0;
    }
    else
    {
        _S286 = (F32_max((_S285 - _S279.distance_0), (0.0f)));
    }
    float _S287 = _S285 / _S279.bend_1.sine_0 - _S284 * _S281.drop_0;
    float _S288 = _S286 * _S286;
    float _S289 = (F32_max((_S287 * _S287 - _S288), (9.99999968265522539e-21f)));
    float _S290 = (F32_rsqrt((_S289)));
    float _S291 = _S288 / (_S289 * _S290 + _S287);
    bool _S292 = _S286 > 0.0f;
    float _S293;
    if(_S265.on_top_0)
    {
        _S293 = 1.0f;
    }
    else
    {
        _S293 = -1.0f;
    }
    float _S294;
    if(_S279.near_start_0)
    {
        _S294 = 1.0f;
    }
    else
    {
        _S294 = -1.0f;
    }
    float _S295 = _S293 * _S294;
    if(_S292)
    {
        _S293 = _S287 * _S290;
    }
    else
    {
        _S293 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S281.slope_0 * _S293;
    if(_S292)
    {
        _S286 = _S295 * _S286 * _S290;
    }
    else
    {
        _S286 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S286;
    float _S296 = __ldg(&(&(globalParams_0->families_0)[_S266])->height_scale_0);
    Shown_0 _S297 = _S265;
    Run_0 _S298 = _S279;
    Cell_0 _S299 = _S277;
    float2  _S300 = dive_0(_S269, &_S297, &_S298, &_S299);
    if(_S279.straight_0)
    {
        _S284 = 0.0f;
    }
    else
    {
        _S284 = _S296 * _S284;
    }
    (&sample_0)->height_7 = _S284 * (_S285 * _S279.bend_1.half_tangent_0 - _S291) - _S296 * _S281.drop_0 - _S300.x;
    float _S301 = _S296 * (&sample_0)->slope_across_0;
    float _S302 = _S296 * (&sample_0)->slope_along_0 - _S300.y;
    if(_S265.is_warp_0)
    {
        _S284 = _S301;
    }
    else
    {
        _S284 = _S302;
    }
    (&sample_0)->slope_x_1 = _S284;
    if(_S265.is_warp_0)
    {
        _S284 = _S302;
    }
    else
    {
        _S284 = _S301;
    }
    (&sample_0)->slope_y_1 = _S284;
    (&sample_0)->run_3 = _S279;
    (&sample_0)->section_1 = _S281;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S303, SearchQuality_0 * _S304, float3  _S305)
{
    Fabric_0 * _S306 = (&(globalParams_0->fabrics_0)[_S303]);
    float _S307 = (F32_abs((_S305.x)));
    float _S308 = __ldg(&_S306->threads_per_x_0);
    float _S309 = _S307 * _S308;
    float _S310 = (F32_abs((_S305.y)));
    float _S311 = __ldg(&_S306->threads_per_y_0);
    float _S312 = (F32_max((_S309), (_S310 * _S311))) * _S304->steps_per_thread_0;
    float _S313 = (F32_abs((_S305.z)));
    float _S314 = __ldg(&_S306->per_relief_0);
    return (F32_max((_S312), (_S313 * _S314 * _S304->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S315, Crossing_0 * _S316)
{
    Fabric_0 * _S317 = (&(globalParams_0->fabrics_0)[_S315]);
    bool _S318 = _S316->warp_above_0;
    uint _S319;
    if(_S316->warp_above_0)
    {
        uint _S320 = __ldg(&_S317->warp_0);
        _S319 = _S320;
    }
    else
    {
        uint _S321 = __ldg(&_S317->weft_0);
        _S319 = _S321;
    }
    uint _S322;
    if(_S318)
    {
        _S322 = _S316->warp_word_0;
    }
    else
    {
        _S322 = _S316->weft_word_0;
    }
    float _S323 = float(_S322 >> int(28));
    float _S324 = __ldg(&(&(globalParams_0->families_0)[_S319])->height_scale_0);
    float _S325 = _S323 * _S324;
    float _S326 = __ldg(&(&(globalParams_0->families_0)[_S319])->level_0);
    return _S325 * _S326;
}

__device__ Probe_0 probe_0(uint _S327, float _S328, float _S329, bool _S330, bool _S331, bool _S332)
{
    Sample_0 _S333 = sample_at_0(_S327, _S328, _S329, _S330);
    Probe_0 probe_1;
    (&probe_1)->height_2 = _S333.height_7;
    (&probe_1)->hole_1 = _S333.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S333.slope_x_1;
    (&probe_1)->slope_y_0 = _S333.slope_y_1;
    uint _S334;
    if(_S333.shown_3.is_warp_0)
    {
        _S334 = _S333.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S334 = _S333.crossing_1.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S334;
    Crossing_0 _S335 = _S333.crossing_1;
    float _S336 = cell_maximum_0(_S327, &_S335);
    (&probe_1)->cell_max_0 = _S336;
    float _S337;
    if(_S331)
    {
        _S337 = _S333.crossing_1.warp_1.above_0;
    }
    else
    {
        _S337 = _S333.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S337;
    if(_S332)
    {
        _S337 = _S333.crossing_1.weft_1.above_0;
    }
    else
    {
        _S337 = _S333.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S337;
    bool _S338 = !_S333.shown_3.is_warp_0;
    Cell_0 _S339 = _S333.crossing_1.warp_1;
    Shown_0 _S340 = _S333.shown_3;
    Run_0 _S341 = _S333.run_3;
    float _S342 = outline_distance_0(&_S339, &_S340, &_S341, _S338, _S331);
    (&probe_1)->edge_x_0 = _S342;
    Cell_0 _S343 = _S333.crossing_1.weft_1;
    Shown_0 _S344 = _S333.shown_3;
    Run_0 _S345 = _S333.run_3;
    float _S346 = outline_distance_0(&_S343, &_S344, &_S345, _S333.shown_3.is_warp_0, _S332);
    (&probe_1)->edge_y_0 = _S346;
    return probe_1;
}

__device__ bool is_free_0(uint _S347, SearchQuality_0 * _S348, float3  _S349, float3  _S350, bool _S351, float _S352)
{
    float _S353 = _S350.z;
    if(_S353 <= 0.0f)
    {
        return false;
    }
    float _S354 = _S348->shadow_share_0;
    float _S355 = steps_per_length_0(_S347, _S348, _S350);
    float _S356 = 1.0f / (F32_max((_S354 * _S355), (9.99999971718068537e-10f)));
    StepControl_0 _S357 = step_control_0(float2 {_S350.x, _S350.y}, _S356);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S358;
        if(count_1 < 1024U)
        {
            _S358 = (_S349.z + _S353 * distance_1) < _S352;
        }
        else
        {
            _S358 = false;
        }
        if(_S358)
        {
        }
        else
        {
            break;
        }
        float3  _S359 = _S349 + _S350 * make_float3 (distance_1);
        Probe_0 _S360 = probe_0(_S347, _S359.x, _S359.y, _S351, _S357.right_1, _S357.up_0);
        float _S361 = _S359.z;
        float _S362 = _S361 - _S360.height_2;
        float _S363 = _S353 - _S360.slope_x_0 * _S350.x - _S360.slope_y_0 * _S350.y;
        bool _S364;
        if(!_S360.hole_1)
        {
            _S364 = _S362 < 0.0f;
        }
        else
        {
            _S364 = false;
        }
        if(_S364)
        {
            return false;
        }
        PreviousSample_0 _S365 = previous_3;
        Probe_0 _S366 = _S360;
        float _S367 = way_back_to_dip_0(&_S365, _S362, _S363, last_step_0, &_S366);
        if(_S367 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S367;
            distance_1 = distance_1 - _S367;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S368 = _S361 > (_S360.cell_max_0);
        Probe_0 _S369 = _S360;
        PreviousSample_0 _S370 = after_sample_0(_S362, _S363, &_S369, _S368);
        float last_step_2;
        if(_S368)
        {
            StepControl_0 _S371 = _S357;
            float _S372 = StepControl_to_cell_exit_0(&_S371, _S360.side_x_0, _S360.side_y_0);
            last_step_2 = (F32_max((_S372), (_S356)));
        }
        else
        {
            StepControl_0 _S373 = _S357;
            Probe_0 _S374 = _S360;
            float _S375 = StepControl_to_next_sample_0(&_S373, &_S374, _S362, _S363);
            last_step_2 = _S375;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S370;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S376, SearchQuality_0 * _S377, float _S378, float _S379, float3  _S380, bool _S381)
{
    Fabric_0 * _S382 = (&(globalParams_0->fabrics_0)[_S376]);
    Sample_0 _S383 = sample_at_0(_S376, _S378, _S379, _S381);
    if(!_S383.shown_3.hole_0)
    {
        return false;
    }
    float3  _S384 = make_float3 (_S378, _S379, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S385;
        if(side_0 < 2U)
        {
            _S385 = passes_0;
        }
        else
        {
            _S385 = false;
        }
        if(_S385)
        {
        }
        else
        {
            break;
        }
        float3  _S386;
        if(side_0 == 0U)
        {
            _S386 = _S380;
        }
        else
        {
            _S386 = make_float3 (- _S380.x, - _S380.y, _S380.z);
        }
        bool _S387 = _S381 != (side_0 == 1U);
        float _S388 = __ldg(&_S382->height_high_0);
        bool _S389 = is_free_0(_S376, _S377, _S384, _S386, _S387, _S388);
        uint _S390 = side_0 + 1U;
        passes_0 = _S389;
        side_0 = _S390;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_8;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

__device__ float max_height_along_0(uint _S391, float _S392, float _S393, float _S394, float3  _S395, bool _S396)
{
    Fabric_0 * _S397 = (&(globalParams_0->fabrics_0)[_S391]);
    uint _S398 = __ldg(&_S397->warp_0);
    uint _S399 = locate_0(_S398, _S392).thread_0 / 2U;
    uint _S400 = __ldg(&_S397->weft_0);
    uint _S401 = locate_0(_S400, _S393).thread_0 / 2U;
    float _S402 = _S395.x;
    uint _S403;
    if(_S402 > 0.0f)
    {
        _S403 = 1U;
    }
    else
    {
        _S403 = 0U;
    }
    float _S404 = _S395.y;
    uint _S405;
    if(_S404 > 0.0f)
    {
        _S405 = 2U;
    }
    else
    {
        _S405 = 0U;
    }
    uint _S406 = _S403 + _S405;
    uint _S407 = __ldg(&_S397->max_heights_0);
    uint _S408 = __ldg(&_S397->max_height_columns_0);
    uint _S409 = __ldg((&(globalParams_0->words_0)[_S407 + 4U * (_S401 * _S408 + _S399) + _S406]));
    int number_0;
    if(_S396)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S410 = _S409 >> number_0;
    float _S411 = (F32_abs((_S402)));
    float _S412 = __ldg(&_S397->threads_per_x_0);
    float _S413 = _S411 * _S412;
    float _S414 = (F32_abs((_S404)));
    float _S415 = __ldg(&_S397->threads_per_y_0);
    float _S416 = (F32_max((_S413), (_S414 * _S415))) / _S395.z;
    float _S417 = __ldg(&_S397->height_high_0);
    float max_height_0 = _S417;
    number_0 = int(3);
    for(;;)
    {
        if(number_0 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S394) * _S416) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S410 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S417)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S418, float _S419, float _S420, bool _S421, bool _S422, bool _S423)
{
    Crossing_0 _S424 = crossing_at_0(_S418, _S419, _S420, _S421);
    Crossing_0 _S425 = _S424;
    float _S426 = cell_maximum_0(_S418, &_S425);
    float _S427;
    if(_S422)
    {
        _S427 = _S424.warp_1.above_0;
    }
    else
    {
        _S427 = _S424.warp_1.below_0;
    }
    float _S428;
    if(_S423)
    {
        _S428 = _S424.weft_1.above_0;
    }
    else
    {
        _S428 = _S424.weft_1.below_0;
    }
    return make_float3 (_S426, _S427, _S428);
}

__device__ float first_sample_height_0(uint _S429, ViewRay_0 * _S430, StepControl_0 * _S431, bool _S432)
{
    float _S433 = max_height_along_0(_S429, _S430->origin_0.x, _S430->origin_0.y, 0.0f, make_float3 (_S430->slope_1.x, _S430->slope_1.y, 1.0f), _S432);
    uint count_2 = 0U;
    float height_9 = _S433;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S434 = ViewRay_at_0(_S430, height_9);
        float3  _S435 = cell_bounds_0(_S429, _S434.x, _S434.y, _S432, _S431->right_1, _S431->up_0);
        float _S436 = height_9 - _S435.x;
        float _S437 = StepControl_to_cell_exit_0(_S431, _S435.y, _S435.z);
        float height_10 = height_9 - clamp_0(_S436, 0.0f, _S437);
        if(_S436 <= _S437)
        {
            height_9 = height_10;
            break;
        }
        count_2 = count_2 + 1U;
        height_9 = height_10;
    }
    return height_9;
}

__device__ ViewRayEnd_0 search_down_0(uint _S438, ViewRay_0 * _S439, StepControl_0 * _S440, bool _S441)
{
    Fabric_0 * _S442 = (&(globalParams_0->fabrics_0)[_S438]);
    float _S443 = __ldg(&_S442->height_low_0);
    float _S444 = __ldg(&_S442->height_high_0);
    float _S445 = _S443 - (_S444 - _S443);
    ViewRayEnd_0 end_1;
    float _S446 = first_sample_height_0(_S438, _S439, _S440, _S441);
    (&end_1)->height_8 = _S446;
    (&end_1)->last_step_3 = _S440->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
    uint count_3 = 0U;
    for(;;)
    {
        if(count_3 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S447 = ViewRay_at_0(_S439, (&end_1)->height_8);
        Probe_0 _S448 = probe_0(_S438, _S447.x, _S447.y, _S441, _S440->right_1, _S440->up_0);
        float _S449 = (&end_1)->height_8 - _S448.height_2;
        Probe_0 _S450 = _S448;
        float _S451 = ViewRay_rate_0(_S439, &_S450);
        (&end_1)->depth_1 = - _S449;
        (&end_1)->rate_4 = _S451;
        bool _S452;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S452 = !_S448.hole_1;
        }
        else
        {
            _S452 = false;
        }
        bool _S453;
        if(_S452)
        {
            _S453 = ((&(&end_1)->previous_4)->yarn_0) == (_S448.yarn_1);
        }
        else
        {
            _S453 = false;
        }
        (&end_1)->smooth_0 = _S453;
        bool _S454;
        if(!_S448.hole_1)
        {
            _S454 = _S449 <= 0.0f;
        }
        else
        {
            _S454 = false;
        }
        bool _S455;
        if(_S454)
        {
            _S455 = true;
        }
        else
        {
            _S455 = ((&end_1)->height_8) <= _S445;
        }
        if(_S455)
        {
            break;
        }
        PreviousSample_0 _S456 = (&end_1)->previous_4;
        Probe_0 _S457 = _S448;
        float _S458 = way_back_to_dip_0(&_S456, _S449, _S451, (&end_1)->last_step_3, &_S457);
        if(_S458 >= 0.0f)
        {
            (&end_1)->height_8 = (&end_1)->height_8 + _S458;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S458;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S459 = StepControl_to_cell_exit_0(_S440, _S448.side_x_0, _S448.side_y_0);
        float _S460 = (F32_min((_S459), ((&end_1)->height_8 - _S448.cell_max_0)));
        Probe_0 _S461 = _S448;
        float _S462 = StepControl_to_next_sample_0(_S440, &_S461, _S449, _S451);
        bool _S463 = _S460 > _S462;
        Probe_0 _S464 = _S448;
        PreviousSample_0 _S465 = after_sample_0(_S449, _S451, &_S464, _S463);
        (&end_1)->previous_4 = _S465;
        float _S466 = (F32_max((_S460), (_S462)));
        (&end_1)->last_step_3 = _S466;
        (&end_1)->height_8 = (&end_1)->height_8 - _S466;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S467, ViewRay_0 * _S468, StepControl_0 * _S469, bool _S470, ViewRayEnd_0 * _S471, uint _S472)
{
    Fabric_0 * _S473 = (&(globalParams_0->fabrics_0)[_S467]);
    float _S474 = __ldg(&_S473->height_high_0);
    float _S475 = __ldg(&_S473->height_low_0);
    float _S476 = _S474 - _S475;
    float _S477 = _S471->height_8;
    float _S478 = _S471->last_step_3;
    float above_2 = _S471->height_8 + _S471->last_step_3;
    float above_gap_1 = clamp_0((&_S471->previous_4)->clearance_0, 0.0f, _S476);
    float under_gap_1 = clamp_0(_S471->depth_1, 0.0f, _S476);
    float _S479 = cubic_root_0(above_gap_1, - under_gap_1, (&_S471->previous_4)->rate_0 * _S471->last_step_3, _S471->rate_4 * _S471->last_step_3);
    bool _S480 = _S471->smooth_0;
    float middle_0;
    if(_S471->smooth_0)
    {
        middle_0 = above_2 - _S479 * _S478;
    }
    else
    {
        middle_0 = between_0(above_2, _S477, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S477;
    float above_3 = above_2;
    uint i_6 = 0U;
    for(;;)
    {
        if(i_6 < _S472)
        {
        }
        else
        {
            break;
        }
        float2  _S481 = ViewRay_at_0(_S468, middle_0);
        Probe_0 _S482 = probe_0(_S467, _S481.x, _S481.y, _S470, _S469->right_1, _S469->up_0);
        float _S483;
        if(_S482.hole_1)
        {
            _S483 = -1.0e+09f;
        }
        else
        {
            _S483 = _S482.height_2;
        }
        float _S484 = clamp_0(middle_0 - _S483, - _S476, _S476);
        float _S485;
        if(_S484 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S485 = 0.5f * above_gap_2;
            }
            else
            {
                _S485 = above_gap_2;
            }
            float _S486 = - _S484;
            under_1 = middle_0;
            above_gap_2 = _S485;
            under_gap_2 = _S486;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S485 = 0.5f * under_gap_2;
            }
            else
            {
                _S485 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S484;
            under_gap_2 = _S485;
            side_1 = -1.0f;
        }
        if(_S480)
        {
            Probe_0 _S487 = _S482;
            float _S488 = ViewRay_rate_0(_S468, &_S487);
            middle_0 = clamp_0(middle_0 + _S484 / (F32_min((_S488), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_6 = i_6 + 1U;
    }
    if(_S480)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S489, SearchQuality_0 * _S490, float _S491, float _S492, float3  _S493, bool _S494)
{
    float _S495 = (F32_max((_S493.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S491, _S492);
    float2  _S496 = float2 {_S493.x, _S493.y} / make_float2 (_S495);
    (&ray_0)->slope_1 = _S496;
    float2  _S497 = - _S496;
    float _S498 = steps_per_length_0(_S489, _S490, _S493);
    StepControl_0 _S499 = step_control_0(_S497, 1.0f / (F32_max((_S498 / _S495), (9.99999971718068537e-10f))));
    ViewRay_0 _S500 = ray_0;
    StepControl_0 _S501 = _S499;
    ViewRayEnd_0 _S502 = search_down_0(_S489, &_S500, &_S501, _S494);
    Hit_0 hit_0;
    (&hit_0)->hole_4 = false;
    ViewRay_0 _S503 = ray_0;
    StepControl_0 _S504 = _S499;
    ViewRayEnd_0 _S505 = _S502;
    float _S506 = refined_height_0(_S489, &_S503, &_S504, _S494, &_S505, _S490->refinements_0);
    (&hit_0)->height_6 = _S506;
    ViewRay_0 _S507 = ray_0;
    float2  _S508 = ViewRay_at_0(&_S507, _S506);
    (&hit_0)->x_24 = _S508.x;
    (&hit_0)->y_14 = _S508.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S509, SearchQuality_0 * _S510, float _S511, float _S512, float3  _S513, bool _S514)
{
    bool _S515 = passes_through_0(_S509, _S510, _S511, _S512, _S513, _S514);
    if(!_S515)
    {
        Hit_0 _S516 = first_hit_of_yarn_0(_S509, _S510, _S511, _S512, _S513, _S514);
        return _S516;
    }
    Hit_0 hit_1;
    (&hit_1)->x_24 = _S511;
    (&hit_1)->y_14 = _S512;
    (&hit_1)->height_6 = 0.0f;
    (&hit_1)->hole_4 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S517, float _S518, float _S519, bool _S520)
{
    Fabric_0 * _S521 = (&(globalParams_0->fabrics_0)[_S517]);
    Sample_0 _S522 = sample_at_0(_S517, _S518, _S519, _S520);
    float _S523;
    if(_S522.shown_3.is_warp_0)
    {
        _S523 = _S522.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S523 = _S522.crossing_1.weft_1.half_width_1;
    }
    uint _S524;
    if(_S522.shown_3.is_warp_0)
    {
        uint _S525 = __ldg(&_S521->warp_0);
        _S524 = _S525;
    }
    else
    {
        uint _S526 = __ldg(&_S521->weft_0);
        _S524 = _S526;
    }
    float _S527 = __ldg(&(&(globalParams_0->families_0)[_S524])->twist_sine_0);
    float _S528;
    if(_S520)
    {
        _S528 = -1.0f;
    }
    else
    {
        _S528 = 1.0f;
    }
    float _S529 = _S527 * _S528;
    float _S530 = __ldg(&(&(globalParams_0->families_0)[_S524])->twist_cosine_0);
    if(_S522.shown_3.is_warp_0)
    {
        _S528 = 1.0f;
    }
    else
    {
        _S528 = -1.0f;
    }
    float2  _S531 = fibre_direction_0(_S522.slope_across_0, _S528 * _S522.slope_along_0, _S529, _S530);
    float _S532;
    if(_S522.shown_3.is_warp_0)
    {
        _S532 = _S522.slope_x_1;
    }
    else
    {
        _S532 = _S522.slope_y_1;
    }
    float _S533;
    if(_S522.shown_3.is_warp_0)
    {
        _S533 = _S522.slope_y_1;
    }
    else
    {
        _S533 = _S522.slope_x_1;
    }
    float _S534 = _S531.x;
    float _S535 = _S531.y;
    float _S536 = _S532 * _S534 + _S528 * _S533 * _S535;
    float _S537 = _S523 * 1.0154266357421875f;
    float _S538 = _S537 * arc_sine_0(clamp_0(_S522.section_1.across_1 / _S537, -1.0f, 1.0f));
    if(_S522.shown_3.is_warp_0)
    {
        _S523 = _S519;
    }
    else
    {
        _S523 = - _S518;
    }
    SurfacePoint_0 point_1;
    (&point_1)->hole_2 = _S522.shown_3.hole_0;
    (&point_1)->is_warp_1 = _S522.shown_3.is_warp_0;
    (&point_1)->warp_thread_0 = _S522.crossing_1.warp_1.thread_0;
    (&point_1)->weft_thread_0 = _S522.crossing_1.weft_1.thread_0;
    (&point_1)->height_4 = _S522.height_7;
    (&point_1)->normal_2 = normalize_0(make_float3 (- _S522.slope_x_1, - _S522.slope_y_1, 1.0f));
    float3  _S539;
    if(_S522.shown_3.is_warp_0)
    {
        _S539 = make_float3 (_S534, _S535, _S536);
    }
    else
    {
        _S539 = make_float3 (- _S535, _S534, _S536);
    }
    (&point_1)->tangent_2 = normalize_0(_S539);
    (&point_1)->across_3 = _S522.section_1.across_1;
    (&point_1)->fibre_across_0 = _S538 * _S530 + _S523 * _S529;
    (&point_1)->fibre_along_0 = _S523 * _S530 - _S538 * _S529;
    return point_1;
}

__device__ bool has_hairs_0(uint _S540)
{
    Fabric_0 * _S541 = (&(globalParams_0->fabrics_0)[_S540]);
    uint _S542 = __ldg(&_S541->warp_0);
    float _S543 = __ldg(&(&(globalParams_0->families_0)[_S542])->hairiness_0);
    bool _S544;
    if(_S543 > 0.0f)
    {
        _S544 = true;
    }
    else
    {
        uint _S545 = __ldg(&_S541->weft_0);
        float _S546 = __ldg(&(&(globalParams_0->families_0)[_S545])->hairiness_0);
        _S544 = _S546 > 0.0f;
    }
    return _S544;
}

__device__ Hair_0 hair_at_0(uint _S547, float2  _S548, bool _S549, float _S550)
{
    Fabric_0 * _S551 = (&(globalParams_0->fabrics_0)[_S547]);
    float _S552 = __ldg(&_S551->fibre_size_0);
    float _S553 = 17.0f * _S552;
    float _S554 = fade_0(_S550, _S553);
    float2  _S555 = _S548 / make_float2 (_S553);
    uint number_1;
    if(_S549)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S556 = __ldg(&_S551->seed_0);
    uint _S557 = hash_key_0(number_1, _S556 ^ 1013904242U);
    float _S558 = 1.0f / (F32_max((_S550), (0.07999999821186066f * _S552)));
    float _S559 = (F32_min((0.63999998569488525f * _S552 * _S558), (1.0f)));
    float2  _S560 = make_float2 (0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2  hair_across_0 = _S560;
    number_1 = 0U;
    for(;;)
    {
        bool _S561;
        if(_S554 > 0.0f)
        {
            _S561 = number_1 < 18U;
        }
        else
        {
            _S561 = false;
        }
        if(_S561)
        {
        }
        else
        {
            break;
        }
        uint _S562 = number_1 / 9U;
        uint _S563 = number_1 / 3U - 3U * _S562;
        float2  _S564 = floor_0(_S555) + make_float2 (float(number_1 - 3U * _S563 - 9U * _S562), float(_S563)) - make_float2 (1.0f);
        uint _S565 = hash_bits_0(_S557 + _S562, uint(int(_S564.x)) * 65536U + uint(int(_S564.y)));
        uint _S566 = hash_bits_0(_S557, _S565);
        float2  _S567 = _S555 - _S564 - make_float2 (share_of_0(_S565), share_of_0(_S565 >> int(10)));
        float2  _S568 = sine_cosine_0(3.14159274101257324f * share_of_0(_S565 >> int(20)));
        float _S569 = lerp_0(5.0f, 16.0f, share_of_0(_S566 >> int(10))) / 17.0f;
        float _S570 = _S567.x;
        float _S571 = _S568.y;
        float _S572 = _S567.y;
        float _S573 = _S568.x;
        float _S574 = (_S570 * _S571 + _S572 * _S573) / _S569;
        float _S575 = 0.69999998807907104f * (2.0f * share_of_0(_S566 >> int(20)) - 1.0f);
        float _S576 = 2.0f * _S575 * _S574;
        float _S577 = (F32_rsqrt((_S576 * _S576 + 1.0f)));
        float _S578 = (_S572 * _S571 - _S570 * _S573 - _S575 * _S569 * _S574 * _S574) * _S577 * 17.0f;
        float _S579 = clamp_0((0.31999999284744263f - (F32_abs((_S578)))) * _S552 * _S558 + 0.5f, 0.0f, _S559);
        uint _S580;
        if(((_S566 >> int(30)) & 1U) == 1U)
        {
            uint _S581 = __ldg(&_S551->warp_0);
            _S580 = _S581;
        }
        else
        {
            uint _S582 = __ldg(&_S551->weft_0);
            _S580 = _S582;
        }
        float _S583 = share_of_0(_S566);
        float _S584 = __ldg(&(&(globalParams_0->families_0)[_S580])->hairiness_0);
        bool _S585;
        if(_S583 < _S584)
        {
            _S585 = (F32_abs((_S574))) < 1.0f;
        }
        else
        {
            _S585 = false;
        }
        bool _S586;
        if(_S585)
        {
            _S586 = _S579 > cover_2;
        }
        else
        {
            _S586 = false;
        }
        if(_S586)
        {
            float2  _S587 = make_float2 (- _S573 - _S576 * _S571, _S571 - _S576 * _S573) * make_float2 (_S577);
            cover_2 = _S579;
            hair_away_0 = _S578;
            hair_across_0 = _S587;
        }
        number_1 = number_1 + 1U;
    }
    float _S588 = clamp_0(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    Hair_0 hair_1;
    (&hair_1)->cover_0 = _S554 * cover_2;
    (&hair_1)->normal_0 = make_float3 ((make_float2 (_S588) * hair_across_0).x, (make_float2 (_S588) * hair_across_0).y, (F32_sqrt((1.0f - _S588 * _S588))));
    (&hair_1)->tangent_0 = make_float3 (hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

__device__ bool varies_at_0(uint _S589, float _S590)
{
    Fabric_0 * _S591 = (&(globalParams_0->fabrics_0)[_S589]);
    float _S592 = __ldg(&_S591->fibre_noise_0);
    bool _S593;
    if(_S592 > 0.0f)
    {
        _S593 = true;
    }
    else
    {
        float _S594 = __ldg(&_S591->colour_noise_0);
        _S593 = _S594 > 0.0f;
    }
    if(_S593)
    {
        _S593 = true;
    }
    else
    {
        uint _S595 = __ldg(&_S591->has_detail_0);
        if(_S595 != 0U)
        {
            _S593 = _S590 >= 0.0f;
        }
        else
        {
            _S593 = false;
        }
    }
    return _S593;
}

__device__ uint thread_number_0(uint _S596, SurfacePoint_0 * _S597, float _S598, float _S599)
{
    Fabric_0 * _S600 = (&(globalParams_0->fabrics_0)[_S596]);
    bool _S601 = _S597->is_warp_1;
    float _S602;
    if(_S597->is_warp_1)
    {
        _S602 = _S598;
    }
    else
    {
        _S602 = _S599;
    }
    float _S603 = _S602 - _S597->across_3;
    uint _S604;
    if(_S601)
    {
        uint _S605 = __ldg(&_S600->warp_0);
        _S604 = _S605;
    }
    else
    {
        uint _S606 = __ldg(&_S600->weft_0);
        _S604 = _S606;
    }
    float _S607 = __ldg(&(&(globalParams_0->families_0)[_S604])->period_0);
    float _S608 = __ldg(&(&(globalParams_0->families_0)[_S604])->count_0);
    int _S609 = int(_S608);
    if(_S601)
    {
        _S604 = _S597->warp_thread_0;
    }
    else
    {
        _S604 = _S597->weft_thread_0;
    }
    uint _S610 = uint(int((F32_floor((_S603 / _S607)))) * _S609 + int(_S604)) * 2U;
    if(_S601)
    {
        _S604 = 1U;
    }
    else
    {
        _S604 = 0U;
    }
    return _S610 + _S604;
}

struct FibreNoise_0
{
    float2  bundle_0;
    float bundle_weight_0;
    float2  fibre_0;
    float fibre_weight_0;
    float offset_2;
    float slope_2;
};

__device__ FibreNoise_0 fibre_noise_at_0(uint _S611, uint _S612, SurfacePoint_0 * _S613, uint _S614, float _S615)
{
    Fabric_0 * _S616 = (&(globalParams_0->fabrics_0)[_S611]);
    float _S617 = __ldg(&_S616->fibre_size_0);
    float _S618 = 5.0f * _S617;
    uint _S619 = __ldg(&_S616->seed_0);
    float _S620 = _S613->fibre_along_0;
    float2  _S621 = wave_noise_0(hash_key_0(_S614, _S619 ^ 458671337U), _S613->fibre_along_0 / (25.0f * _S617));
    float _S622 = _S613->fibre_across_0;
    float _S623 = __ldg(&(&(globalParams_0->families_0)[_S612])->fibre_tilt_0);
    float _S624 = _S622 + _S623 * 0.5f * 25.0f * _S617 * _S621.x;
    float3  _S625 = fibre_cell_0(_S624, _S620, _S617);
    FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S614, _S619 ^ 1757159915U), fibre_cell_0(_S624, _S620, _S618));
    (&noise_0)->bundle_weight_0 = fade_0(_S615, _S618);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S614, _S619 ^ 48610963U), _S625);
    (&noise_0)->fibre_weight_0 = fade_0(_S615, _S617);
    (&noise_0)->offset_2 = _S625.z;
    (&noise_0)->slope_2 = 0.5f * _S621.y;
    return noise_0;
}

__device__ float2  detail_gain_0(uint _S626, uint _S627, SurfacePoint_0 * _S628, float2  _S629, bool _S630, uint _S631, float _S632)
{
    Fabric_0 * _S633 = (&(globalParams_0->fabrics_0)[_S626]);
    float2  _S634 = make_float2 (0.0f);
    float _S635 = __ldg(&(&(globalParams_0->families_0)[_S627])->has_plies_0);
    float2  gain_2;
    if(_S635 > 0.0f)
    {
        float _S636 = __ldg(&(&(globalParams_0->families_0)[_S627])->plies_per_mm_0);
        float _S637 = 0.60000002384185791f * fade_0(_S632, 1.0f / _S636);
        float _S638 = ply_offset_0(_S627, _S628, _S630);
        gain_2 = make_float2 (_S637) * make_float2 (0.20000000298023224f - square_0(square_0(_S638)), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S634;
    }
    float _S639 = __ldg(&(&(globalParams_0->families_0)[_S627])->fibre_tone_0);
    if(_S639 > 0.0f)
    {
        FibreNoise_0 _S640 = fibre_noise_at_0(_S626, _S627, _S628, _S631, _S632);
        float _S641 = __ldg(&(&(globalParams_0->families_0)[_S627])->fibre_tone_0);
        gain_2 = gain_2 + make_float2 (_S641) * make_float2 (_S640.bundle_weight_0 * _S640.bundle_0.y + _S640.fibre_weight_0 * _S640.fibre_0.y, _S640.bundle_weight_0 + _S640.fibre_weight_0);
    }
    float _S642 = __ldg(&(&(globalParams_0->families_0)[_S627])->slub_0);
    if(_S642 > 0.0f)
    {
        float _S643 = __ldg(&(&(globalParams_0->families_0)[_S627])->slub_0);
        float _S644 = 0.25f * _S643;
        float _S645 = __ldg(&(&(globalParams_0->families_0)[_S627])->slubs_per_mm_0);
        float _S646 = _S644 * fade_0(_S632, 1.0f / _S645);
        float _S647;
        if(_S628->is_warp_1)
        {
            _S647 = _S629.y;
        }
        else
        {
            _S647 = - _S629.x;
        }
        uint _S648 = __ldg(&_S633->seed_0);
        uint _S649 = hash_key_0(_S631, _S648 ^ 1373058189U);
        float _S650 = __ldg(&(&(globalParams_0->families_0)[_S627])->slubs_per_mm_0);
        float2  _S651 = wave_noise_0(_S649, _S647 * _S650);
        float _S652 = _S628->across_3;
        float _S653 = __ldg(&(&(globalParams_0->families_0)[_S627])->per_half_width_0);
        gain_2 = gain_2 + make_float2 (_S646) * make_float2 (_S651.x * lerp_0(0.40000000596046448f, 1.0f, (F32_min((square_0(_S652 * _S653)), (1.0f)))), 1.0f);
    }
    return gain_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S654, Albedos_0 * _S655, uint _S656, uint _S657, float2  _S658)
{
    Fabric_0 * _S659 = (&(globalParams_0->fabrics_0)[_S654]);
    float3  _S660 = _S655->specular_reflect_0;
    float3  _S661 = _S655->specular_transmit_0;
    float3  _S662 = max_0(_S655->specular_reflect_0, _S655->specular_transmit_0);
    float3  _S663 = _S655->diffuse_reflect_0;
    float3  _S664 = _S655->diffuse_transmit_0;
    float3  _S665 = _S655->diffuse_reflect_0 + _S655->diffuse_transmit_0;
    float _S666 = __ldg(&_S659->layer_bound_0);
    float3  _S667 = make_float3 (1.0f) - make_float3 (_S666) * _S662;
    float _S668 = __ldg(&_S659->colour_noise_0);
    uint _S669 = __ldg(&_S659->seed_0);
    float colour_0 = bounded_gain_0(thread_gain_0(_S656, _S668, _S669), _S665, _S667);
    float colour_1 = colour_0 * (1.0f + flattened_0(_S658.y, make_float3 (colour_0) * _S665, _S667) * _S658.x);
    float3  _S670 = min_0((make_float3 (1.0f) - make_float3 (colour_1) * _S665) / make_float3 (_S666), make_float3 (1.0f));
    float _S671 = __ldg(&_S659->fibre_noise_0);
    float _S672 = bounded_gain_0(fibre_gain_0(_S656, _S657, _S671, _S669), _S662, _S670);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (colour_1) * _S663;
    (&varied_0)->diffuse_transmit_0 = make_float3 (colour_1) * _S664;
    (&varied_0)->specular_reflect_0 = make_float3 (_S672) * _S660;
    (&varied_0)->specular_transmit_0 = make_float3 (_S672) * _S661;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S673, SurfacePoint_0 * _S674, Albedos_0 * _S675, float _S676, float _S677, bool _S678, float _S679, float _S680)
{
    Fabric_0 * _S681 = (&(globalParams_0->fabrics_0)[_S673]);
    uint _S682 = thread_number_0(_S673, _S674, _S676, _S677);
    float _S683 = _S674->fibre_across_0;
    float _S684 = _S674->fibre_along_0;
    float _S685 = __ldg(&_S681->fibre_size_0);
    float3  _S686 = fibre_cell_0(_S683, _S684, _S685);
    float2  _S687 = make_float2 (0.0f);
    uint _S688 = __ldg(&_S681->has_detail_0);
    bool _S689;
    if(_S688 != 0U)
    {
        _S689 = _S679 >= 0.0f;
    }
    else
    {
        _S689 = false;
    }
    float2  gain_3;
    if(_S689)
    {
        uint _S690;
        if(_S674->is_warp_1)
        {
            uint _S691 = __ldg(&_S681->warp_0);
            _S690 = _S691;
        }
        else
        {
            uint _S692 = __ldg(&_S681->weft_0);
            _S690 = _S692;
        }
        float2  _S693 = detail_gain_0(_S673, _S690, _S674, make_float2 (_S676, _S677), _S678, _S682, _S679);
        gain_3 = _S693 * make_float2 (1.0f - _S680, 1.0f);
    }
    else
    {
        gain_3 = _S687;
    }
    Albedos_0 _S694 = vary_albedos_0(_S673, _S675, _S682, uint(int(_S686.x)) * 65536U + uint(int((F32_floor((_S686.y))))), gain_3);
    return _S694;
}

__device__ YarnFrame_0 turned_frame_0(uint _S695, uint _S696, SurfacePoint_0 * _S697, bool _S698, uint _S699, float _S700)
{
    YarnFrame_0 frame_2;
    (&frame_2)->normal_3 = _S697->normal_2;
    (&frame_2)->tangent_3 = _S697->tangent_2;
    (&frame_2)->loss_0 = 0.0f;
    float _S701 = __ldg(&(&(globalParams_0->families_0)[_S696])->has_plies_0);
    if(_S701 > 0.0f)
    {
        float _S702 = __ldg(&(&(globalParams_0->families_0)[_S696])->plies_per_mm_0);
        float _S703 = fade_0(_S700, 1.0f / _S702);
        float _S704 = _S703 * 0.41999998688697815f;
        float _S705 = ply_offset_0(_S696, _S697, _S698);
        float _S706 = _S704 * _S705;
        float _S707 = (F32_sqrt((1.0f - _S706 * _S706)));
        float _S708;
        if(_S698)
        {
            float _S709 = __ldg(&(&(globalParams_0->families_0)[_S696])->ply_sine_0);
            _S708 = - _S709;
        }
        else
        {
            float _S710 = __ldg(&(&(globalParams_0->families_0)[_S696])->ply_sine_0);
            _S708 = _S710;
        }
        float _S711 = __ldg(&(&(globalParams_0->families_0)[_S696])->ply_cosine_0);
        float3  _S712 = cross_0((&frame_2)->tangent_3, (&frame_2)->normal_3);
        float3  _S713 = make_float3 (_S711) * _S712 + make_float3 (_S708) * (&frame_2)->tangent_3;
        (&frame_2)->tangent_3 = make_float3 (_S711) * (make_float3 (_S711) * (&frame_2)->tangent_3 - make_float3 (_S708) * _S712) + make_float3 (_S708) * (make_float3 (_S707) * _S713 - make_float3 (_S706) * (&frame_2)->normal_3);
        (&frame_2)->normal_3 = make_float3 (_S707) * (&frame_2)->normal_3 + make_float3 (_S706) * _S713;
        (&frame_2)->loss_0 = _S703 * _S703 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S714 = __ldg(&(&(globalParams_0->families_0)[_S696])->fibre_tilt_0);
    if(_S714 > 0.0f)
    {
        FibreNoise_0 _S715 = fibre_noise_at_0(_S695, _S696, _S697, _S699, _S700);
        float _S716 = 1.09858846664428711f * _S714 * (_S715.bundle_weight_0 * _S715.bundle_0.x + _S715.fibre_weight_0 * (_S715.fibre_0.x + _S715.offset_2));
        float _S717 = _S714 * (1.42099642753601074f * (_S715.bundle_weight_0 * _S715.bundle_0.y + _S715.fibre_weight_0 * _S715.fibre_0.y) - _S715.bundle_weight_0 * _S715.slope_2);
        float _S718 = square_0(_S715.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S714 * _S714 * ((0.24761904776096344f * (square_0(_S715.bundle_weight_0) + _S718) + _S718 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3  _S719 = cross_0((&frame_2)->tangent_3, (&frame_2)->normal_3);
        float2  _S720 = sine_cosine_0(_S716);
        float2  _S721 = sine_cosine_0(_S717);
        float _S722 = _S720.y;
        float _S723 = _S720.x;
        float3  _S724 = make_float3 (_S722) * _S719 - make_float3 (_S723) * (&frame_2)->normal_3;
        (&frame_2)->normal_3 = make_float3 (_S722) * (&frame_2)->normal_3 + make_float3 (_S723) * _S719;
        (&frame_2)->tangent_3 = make_float3 (_S721.y) * (&frame_2)->tangent_3 + make_float3 (_S721.x) * _S724;
    }
    return frame_2;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S725, SurfacePoint_0 * _S726, float _S727, float _S728, bool _S729, bool _S730, float _S731)
{
    Fabric_0 * _S732 = (&(globalParams_0->fabrics_0)[_S725]);
    bool _S733 = _S726->is_warp_1;
    uint _S734;
    if(_S726->is_warp_1)
    {
        uint _S735 = __ldg(&_S732->warp_0);
        _S734 = _S735;
    }
    else
    {
        uint _S736 = __ldg(&_S732->weft_0);
        _S734 = _S736;
    }
    uint _S737 = __ldg(&_S732->has_detail_0);
    bool _S738;
    if(_S737 != 0U)
    {
        _S738 = _S731 >= 0.0f;
    }
    else
    {
        _S738 = false;
    }
    float3  _S739 = make_float3 (0.0f);
    Hair_0 _S740 = Hair_x24init_0(0.0f, _S739, _S739);
    bool _S741;
    if(_S738)
    {
        bool _S742 = has_hairs_0(_S725);
        _S741 = _S742;
    }
    else
    {
        _S741 = false;
    }
    Hair_0 hair_2;
    if(_S741)
    {
        Hair_0 _S743 = hair_at_0(_S725, make_float2 (_S727, _S728), _S729, _S731);
        hair_2 = _S743;
    }
    else
    {
        hair_2 = _S740;
    }
    uint _S744;
    if(_S733)
    {
        _S744 = _S726->warp_thread_0;
    }
    else
    {
        _S744 = _S726->weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S734, _S744);
    bool _S745 = varies_at_0(_S725, _S731);
    Albedos_0 albedos_3;
    if(_S745)
    {
        Albedos_0 _S746 = albedos_2;
        Albedos_0 _S747 = varied_at_0(_S725, _S726, &_S746, _S727, _S728, _S729, _S731, hair_2.cover_0);
        albedos_3 = _S747;
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_2;
    (&point_2)->back_6 = _S729;
    (&point_2)->hole_3 = _S730;
    (&point_2)->is_warp_2 = _S733;
    (&point_2)->x_23 = _S727;
    (&point_2)->y_13 = _S728;
    (&point_2)->height_5 = _S726->height_4;
    (&point_2)->normal_7 = _S726->normal_2;
    (&point_2)->tangent_8 = _S726->tangent_2;
    (&point_2)->surface_normal_0 = _S726->normal_2;
    (&point_2)->diffuse_gain_1 = 1.0f;
    if(_S738)
    {
        uint _S748 = thread_number_0(_S725, _S726, _S727, _S728);
        YarnFrame_0 _S749 = turned_frame_0(_S725, _S734, _S726, _S729, _S748, _S731);
        bool _S750 = has_hairs_0(_S725);
        YarnFrame_0 frame_3;
        if(_S750)
        {
            YarnFrame_0 _S751 = _S749;
            Hair_0 _S752 = hair_2;
            YarnFrame_0 _S753 = under_hair_0(&_S751, &_S752);
            frame_3 = _S753;
        }
        else
        {
            frame_3 = _S749;
        }
        (&point_2)->normal_7 = frame_3.normal_3;
        (&point_2)->tangent_8 = frame_3.tangent_3;
        float _S754 = __ldg(&_S732->diffuse_blend_0);
        YarnFrame_0 _S755 = frame_3;
        float _S756 = diffuse_gain_0(&_S755, _S754);
        (&point_2)->diffuse_gain_1 = _S756;
    }
    float _S757 = __ldg(&(&(globalParams_0->families_0)[_S734])->roughness_0);
    (&point_2)->roughness_8 = _S757;
    (&point_2)->albedos_1 = albedos_3;
    return point_2;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S758, SearchQuality_0 * _S759, float _S760, float _S761, float3  _S762, float _S763)
{
    bool _S764 = (_S762.z) < 0.0f;
    Hit_0 _S765 = first_hit_0(_S758, _S759, _S760, _S761, to_face_frame_0(_S762, _S764), _S764);
    SurfacePoint_0 _S766 = surface_at_0(_S758, _S765.x_24, _S765.y_14, _S764);
    SurfacePoint_0 _S767 = _S766;
    YarnPoint_0 _S768 = yarn_point_of_0(_S758, &_S767, _S765.x_24, _S765.y_14, _S764, _S765.hole_4, _S763);
    return _S768;
}

__device__ float openness_number_0(uint _S769, uint _S770)
{
    uint _S771 = __ldg(&(&(globalParams_0->fabrics_0)[_S769])->openness_0);
    return table_number_0(_S771 + _S770);
}

__device__ Blocked_0 blocked_of_terms_0(uint _S772, uint _S773, FixedArray<float, 6>  * _S774, uint _S775)
{
    FixedArray<float, 3>  shares_0;
    uint share_3 = 0U;
    for(;;)
    {
        if(share_3 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_3] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S775)
            {
            }
            else
            {
                break;
            }
            float _S776 = openness_number_0(_S772, _S773 + share_3 * _S775 + term_0);
            shares_0[share_3] = shares_0[share_3] + _S776 * (*_S774)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_3] = saturate_0(shares_0[share_3]);
        share_3 = share_3 + 1U;
    }
    Blocked_0 blocked_1;
    (&blocked_1)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_1)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_1)->far_0 = shares_0[int(1)];
    return blocked_1;
}

__device__ Blocked_0 blocked_at_0(uint _S777, bool _S778, bool _S779, float _S780, float _S781)
{
    float _S782 = openness_number_0(_S777, 158U);
    float _S783 = _S781 * _S782;
    float _S784 = _S780 * _S780;
    float _S785 = _S780 * _S783;
    float _S786 = _S783 * _S783;
    uint _S787;
    if(_S779)
    {
        _S787 = 2U;
    }
    else
    {
        _S787 = 0U;
    }
    uint _S788;
    if(_S778)
    {
        _S788 = 0U;
    }
    else
    {
        _S788 = 1U;
    }
    uint _S789 = 60U + (_S787 + _S788) * 18U;
    FixedArray<float, 6>  _S790;
    _S790[int(0)] = 1.0f;
    _S790[int(1)] = _S780;
    _S790[int(2)] = _S783;
    _S790[int(3)] = _S784;
    _S790[int(4)] = _S785;
    _S790[int(5)] = _S786;
    Blocked_0 _S791 = blocked_of_terms_0(_S777, _S789, &_S790, 6U);
    return _S791;
}

__device__ Scattered_0 scattered_by_0(uint _S792, Albedos_0 * _S793, uint _S794, float3  _S795)
{
    uint _S796 = 159U + 2U * _S794;
    Scattered_0 yarn_3;
    float3  _S797 = _S795 * _S793->diffuse_reflect_0;
    float _S798 = openness_number_0(_S792, _S796);
    (&yarn_3)->back_5 = _S797 + make_float3 (_S798) * _S793->specular_reflect_0;
    float3  _S799 = _S795 * _S793->diffuse_transmit_0;
    float _S800 = openness_number_0(_S792, _S796 + 1U);
    (&yarn_3)->through_0 = _S799 + make_float3 (_S800) * _S793->specular_transmit_0;
    return yarn_3;
}

__device__ void sent_0(uint _S801, uint _S802, float3  _S803, float3  _S804, float3  _S805, float3  _S806, float3  * _S807, float3  * _S808)
{
    uint _S809 = 146U + 4U * _S802;
    float _S810 = openness_number_0(_S801, _S809);
    float _S811 = openness_number_0(_S801, _S809 + 1U);
    float _S812 = openness_number_0(_S801, _S809 + 2U);
    float _S813 = openness_number_0(_S801, _S809 + 3U);
    float3  _S814 = make_float3 (1.0f) - _S805 * make_float3 (_S810);
    float3  _S815 = make_float3 (1.0f) - _S806 * make_float3 (_S813);
    float3  _S816 = make_float3 (1.0f) / (_S814 * _S815 - _S805 * _S806 * make_float3 (_S811 * _S812));
    *_S807 = (_S803 * _S815 + _S805 * make_float3 (_S811) * _S804) * _S816;
    *_S808 = (_S804 * _S814 + _S806 * make_float3 (_S812) * _S803) * _S816;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S817, uint _S818, Scattered_0 * _S819, Scattered_0 * _S820)
{
    uint _S821 = 2U * _S818;
    uint _S822 = 142U + _S821;
    float _S823 = openness_number_0(_S817, _S822);
    float _S824 = openness_number_0(_S817, _S822 + 1U);
    float3  _S825 = make_float3 (1.0f - _S823) * _S819->back_5;
    float3  _S826 = make_float3 (1.0f - _S824) * _S820->back_5;
    FaceSends_0 sends_1;
    uint _S827 = 154U + _S821;
    float _S828 = openness_number_0(_S817, _S827);
    (&sends_1)->blocks_warp_0 = _S828;
    float _S829 = openness_number_0(_S817, _S827 + 1U);
    (&sends_1)->blocks_weft_0 = _S829;
    (&sends_1)->open_0 = _S828 * _S823 + _S829 * _S824;
    sent_0(_S817, _S818, make_float3 (_S823) * _S819->back_5, make_float3 (_S824) * _S820->back_5, _S825, _S826, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S817, _S818, _S819->through_0, _S820->through_0, _S825, _S826, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S830, float3  _S831, bool _S832)
{
    Fabric_0 * _S833 = (&(globalParams_0->fabrics_0)[_S830]);
    uint _S834 = __ldg(&_S833->warp_0);
    uint _S835 = __ldg(&(&(globalParams_0->families_0)[_S834])->colour_mean_0);
    Albedos_0 _S836 = table_albedos_0(_S835);
    Scattered_0 _S837 = scattered_by_0(_S830, &_S836, 0U, _S831);
    uint _S838 = __ldg(&_S833->weft_0);
    uint _S839 = __ldg(&(&(globalParams_0->families_0)[_S838])->colour_mean_0);
    Albedos_0 _S840 = table_albedos_0(_S839);
    Scattered_0 _S841 = scattered_by_0(_S830, &_S840, 1U, _S831);
    uint _S842;
    if(_S832)
    {
        _S842 = 1U;
    }
    else
    {
        _S842 = 0U;
    }
    Scattered_0 _S843 = _S837;
    Scattered_0 _S844 = _S841;
    FaceSends_0 _S845 = face_sends_0(_S830, _S842, &_S843, &_S844);
    if(_S832)
    {
        _S842 = 0U;
    }
    else
    {
        _S842 = 1U;
    }
    Scattered_0 _S846 = _S837;
    Scattered_0 _S847 = _S841;
    FaceSends_0 _S848 = face_sends_0(_S830, _S842, &_S846, &_S847);
    float3  _S849 = make_float3 (_S845.blocks_warp_0) * _S845.crossing_warp_0 + make_float3 (_S845.blocks_weft_0) * _S845.crossing_weft_0;
    float3  _S850 = make_float3 (_S848.blocks_warp_0) * _S848.crossing_warp_0 + make_float3 (_S848.blocks_weft_0) * _S848.crossing_weft_0;
    float _S851 = 1.0f - _S845.open_0;
    float _S852 = 1.0f - _S848.open_0;
    float3  _S853 = make_float3 (1.0f) / (make_float3 (1.0f) - _S849 * _S850 * make_float3 (_S851 * _S852));
    float3  _S854 = _S850 * (make_float3 (_S845.open_0) + make_float3 (_S851) * (make_float3 (_S845.blocks_warp_0) * _S845.sky_warp_0 + make_float3 (_S845.blocks_weft_0) * _S845.sky_weft_0)) * _S853;
    float3  _S855 = _S849 * (make_float3 (_S848.open_0) + make_float3 (_S852) * (make_float3 (_S848.blocks_warp_0) * _S848.sky_warp_0 + make_float3 (_S848.blocks_weft_0) * _S848.sky_weft_0)) * _S853;
    FaceSends_0 _S856 = _S845;
    FaceRadiance_0 _S857 = face_radiance_0(&_S856, _S848.open_0, _S854, _S855);
    FaceSends_0 _S858 = _S848;
    FaceRadiance_0 _S859 = face_radiance_0(&_S858, _S845.open_0, _S855, _S854);
    Interior_0 interior_1;
    (&interior_1)->warp_3 = _S857.warp_2;
    (&interior_1)->weft_3 = _S857.weft_2;
    (&interior_1)->leaked_1 = _S857.leaked_0;
    (&interior_1)->far_1 = _S859.mean_0;
    (&interior_1)->far_leaked_0 = _S859.leaked_0;
    return interior_1;
}

__device__ Bounced_0 bounced_at_0(uint _S860, YarnPoint_0 * _S861, float3  _S862)
{
    Fabric_0 * _S863 = (&(globalParams_0->fabrics_0)[_S860]);
    Bounced_0 nothing_0;
    float3  _S864 = make_float3 (0.0f);
    (&nothing_0)->reflected_0 = _S864;
    (&nothing_0)->transmitted_0 = _S864;
    uint _S865 = __ldg(&_S863->openness_0);
    bool _S866;
    if(_S865 == 4294967295U)
    {
        _S866 = true;
    }
    else
    {
        _S866 = _S861->hole_3;
    }
    if(_S866)
    {
        return nothing_0;
    }
    bool _S867 = _S861->back_6;
    Blocked_0 _S868 = blocked_at_0(_S860, _S861->is_warp_2, _S861->back_6, _S861->surface_normal_0.z, _S861->height_5);
    uint _S869;
    if(_S861->is_warp_2)
    {
        _S869 = 0U;
    }
    else
    {
        _S869 = 1U;
    }
    Scattered_0 _S870 = scattered_by_0(_S860, &_S861->albedos_1, _S869, _S862);
    Interior_0 _S871 = interior_of_0(_S860, _S862, _S867);
    Blocked_0 _S872 = _S868;
    Scattered_0 _S873 = _S870;
    Interior_0 _S874 = _S871;
    Bounced_0 _S875 = bounced_by_0(&_S872, &_S873, &_S874);
    return _S875;
}

__device__ float3  scattered_0(uint _S876, YarnPoint_0 * _S877, float3  _S878, float3  _S879)
{
    Fabric_0 * _S880 = (&(globalParams_0->fabrics_0)[_S876]);
    float3  _S881 = make_float3 (0.0f);
    bool _S882 = !_S877->hole_3;
    bool _S883;
    if(_S882)
    {
        _S883 = (_S878.z) > 0.0f;
    }
    else
    {
        _S883 = false;
    }
    float3  value_1;
    if(_S883)
    {
        float3  _S884 = (&_S877->albedos_1)->diffuse_reflect_0 * make_float3 (_S877->diffuse_gain_1);
        float3  _S885 = _S877->normal_7;
        float _S886 = __ldg(&_S880->diffuse_blend_0);
        float3  _S887 = _S884 * make_float3 (diffuse_reflection_0(_S878, _S885, _S886));
        float3  _S888 = (&_S877->albedos_1)->specular_reflect_0;
        float3  _S889 = _S877->tangent_8;
        float _S890 = _S877->roughness_8;
        float _S891 = __ldg(&_S880->optical_depth_0);
        value_1 = _S887 + _S888 * make_float3 (reflection_0(_S878, _S879, _S885, _S889, _S890, _S891));
    }
    else
    {
        if(_S882)
        {
            _S883 = (_S878.z) < 0.0f;
        }
        else
        {
            _S883 = false;
        }
        if(_S883)
        {
            float3  _S892 = (&_S877->albedos_1)->diffuse_transmit_0 * make_float3 (_S877->diffuse_gain_1);
            float3  _S893 = - _S878;
            float3  _S894 = _S877->normal_7;
            float _S895 = __ldg(&_S880->diffuse_blend_0);
            float3  _S896 = _S892 * make_float3 (diffuse_reflection_0(_S893, _S894, _S895));
            float3  _S897 = (&_S877->albedos_1)->specular_transmit_0;
            float3  _S898 = _S877->tangent_8;
            float _S899 = _S877->roughness_8;
            float _S900 = __ldg(&_S880->optical_depth_0);
            value_1 = _S896 + _S897 * make_float3 (transmission_1(_S878, _S879, _S894, _S898, _S899, _S900));
        }
        else
        {
            value_1 = _S881;
        }
    }
    float _S901 = __ldg(&_S880->sheen_strength_0);
    if(_S901 <= 0.0f)
    {
        return value_1;
    }
    float _S902 = __ldg(&_S880->sheen_roughness_0);
    float2  _S903 = sheen_with_transmittance_0(_S878, _S879, _S901, _S902);
    return make_float3 (_S903.y) * value_1 + make_float3 (_S903.x);
}

__device__ bool unoccluded_0(uint _S904, SearchQuality_0 * _S905, float _S906, float _S907, float _S908, float3  _S909, bool _S910)
{
    Fabric_0 * _S911 = (&(globalParams_0->fabrics_0)[_S904]);
    if((_S909.z) <= 0.0f)
    {
        return false;
    }
    float _S912 = max_height_along_0(_S904, _S906, _S907, _S908, _S909, _S910);
    float _S913 = __ldg(&_S911->lift_0);
    bool _S914 = is_free_0(_S904, _S905, make_float3 (_S906, _S907, _S908 + _S913), _S909, _S910, _S912);
    return _S914;
}

__device__ bool is_lit_0(uint _S915, SearchQuality_0 * _S916, YarnPoint_0 * _S917, float3  _S918)
{
    if(_S917->hole_3)
    {
        return true;
    }
    bool _S919 = _S917->back_6;
    float3  _S920 = to_face_frame_0(_S918, _S917->back_6);
    float _S921 = _S920.z;
    bool _S922 = _S921 < 0.0f;
    float3  _S923 = _S917->surface_normal_0;
    float _S924 = _S917->height_5;
    float3  normal_8;
    float height_11;
    if(_S922)
    {
        SurfacePoint_0 _S925 = surface_at_0(_S915, _S917->x_23, _S917->y_13, !_S919);
        normal_8 = _S925.normal_2;
        height_11 = _S925.height_4;
    }
    else
    {
        normal_8 = _S923;
        height_11 = _S924;
    }
    float3  _S926 = make_float3 (float2 {_S920.x, _S920.y}.x, float2 {_S920.x, _S920.y}.y, (F32_abs((_S921))));
    if((dot_0(normal_8, _S926)) <= 0.0f)
    {
        return false;
    }
    bool _S927 = unoccluded_0(_S915, _S916, _S917->x_23, _S917->y_13, height_11, _S926, _S919 != _S922);
    return _S927;
}

__device__ float3  evaluate_with_0(uint _S928, SearchQuality_0 * _S929, YarnPoint_0 * _S930, Bounced_0 * _S931, float3  _S932, float3  _S933)
{
    Fabric_0 * _S934 = (&(globalParams_0->fabrics_0)[_S928]);
    float3  _S935 = to_face_frame_0(_S933, _S930->back_6);
    float3  _S936 = scattered_0(_S928, _S930, to_face_frame_0(_S932, _S930->back_6), _S935);
    bool _S937;
    if((F32_max((_S936.x), ((F32_max((_S936.y), (_S936.z)))))) <= 0.0f)
    {
        _S937 = true;
    }
    else
    {
        bool _S938 = is_lit_0(_S928, _S929, _S930, _S932);
        _S937 = !_S938;
    }
    float3  value_2;
    if(_S937)
    {
        value_2 = make_float3 (0.0f);
    }
    else
    {
        value_2 = _S936;
    }
    float3  _S939 = bounced_value_0(_S931, _S932, _S933);
    float _S940 = __ldg(&_S934->sheen_strength_0);
    float3  between_1;
    if(_S940 > 0.0f)
    {
        float _S941 = (F32_abs((_S935.z)));
        float _S942 = __ldg(&_S934->sheen_roughness_0);
        between_1 = _S939 * make_float3 (1.0f - _S940 * sheen_lobe_0(_S941, _S942).z);
    }
    else
    {
        between_1 = _S939;
    }
    return value_2 + between_1;
}

__device__ float3  evaluate_0(uint _S943, SearchQuality_0 * _S944, YarnPoint_0 * _S945, float3  _S946, float3  _S947)
{
    Bounced_0 _S948 = bounced_at_0(_S943, _S945, make_float3 (1.0f));
    Bounced_0 _S949 = _S948;
    float3  _S950 = evaluate_with_0(_S943, _S944, _S945, &_S949, _S946, _S947);
    return _S950;
}

__device__ float straight_through_0(uint _S951, YarnPoint_0 * _S952, float3  _S953)
{
    Fabric_0 * _S954 = (&(globalParams_0->fabrics_0)[_S951]);
    if(!_S952->hole_3)
    {
        return 0.0f;
    }
    float _S955 = __ldg(&_S954->sheen_strength_0);
    if(_S955 <= 0.0f)
    {
        return 1.0f;
    }
    float _S956 = (F32_abs((_S953.z)));
    float _S957 = __ldg(&_S954->sheen_roughness_0);
    return 1.0f - _S955 * sheen_lobe_0(_S956, _S957).z;
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_1, float2  dx_1, float2  dy_1, float3  light_8, float3  view_7)
{
    SearchQuality_0 _S958 = default_quality_0();
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_1;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    float _S959 = centre_1.x;
    float _S960 = centre_1.y;
    Footprint_0 _S961 = footprint_0;
    float _S962 = Footprint_spread_side_0(&_S961);
    SearchQuality_0 _S963 = _S958;
    YarnPoint_0 _S964 = locate_yarn_0(fabric_2, &_S963, _S959, _S960, view_7, _S962);
    SearchQuality_0 _S965 = _S958;
    YarnPoint_0 _S966 = _S964;
    float3  _S967 = evaluate_0(fabric_2, &_S965, &_S966, light_8, view_7);
    YarnPoint_0 _S968 = _S964;
    float _S969 = straight_through_0(fabric_2, &_S968, view_7);
    return make_float4 (_S967.x, _S967.y, _S967.z, _S969);
}

extern "C" __global__ void point_queries()
{
    uint _S970 = (blockIdx * blockDim + threadIdx).x;
    uint _S971 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S970 >= _S971)
    {
        return;
    }
    Query_0 _S972 = slang_ldg_0((&(globalParams_0->queries_0)[_S970]));
    *(&(globalParams_0->answers_0)[_S970]) = cloth_value_0(_S972.fabric_1, make_float2 (_S972.centre_x_0, _S972.centre_y_0), make_float2 (_S972.dx_x_0, _S972.dx_y_0), make_float2 (_S972.dy_x_0, _S972.dy_y_0), make_float3 (_S972.light_x_0, _S972.light_y_0, _S972.light_z_0), make_float3 (_S972.view_x_0, _S972.view_y_0, _S972.view_z_0));
    return;
}

