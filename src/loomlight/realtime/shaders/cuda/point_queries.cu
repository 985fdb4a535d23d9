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
    Query_0 _S20 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19 };
    return _S20;
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
    float2  _S21 = float2 {direction_0.x, direction_0.y};
    float _S22;
    if(back_2)
    {
        _S22 = - direction_0.z;
    }
    else
    {
        _S22 = direction_0.z;
    }
    return make_float3 (_S21.x, _S21.y, _S22);
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    float _S23 = __ldg(&(&(globalParams_0->families_0)[family_0])->inverse_count_0);
    float _S24 = __ldg(&(&(globalParams_0->families_0)[family_0])->half_inverse_count_0);
    float _S25 = (F32_floor(((F32_fma((index_0), (_S23), (_S24))))));
    float _S26 = - _S25;
    float _S27 = __ldg(&(&(globalParams_0->families_0)[family_0])->count_0);
    return make_float2 (_S25, (F32_fma((_S26), (_S27), (index_0))));
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
    float _S28 = __ldg(&(&(globalParams_0->families_0)[family_1])->inverse_size_0);
    float _S29 = (F32_floor((position_0 * _S28)));
    Cell_0 cell_0;
    float _S30 = - _S29;
    float _S31 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    float _S32 = (F32_fma((_S30), (_S31), (position_0)));
    (&cell_0)->below_0 = _S32;
    float _S33 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->above_0 = _S33 - _S32;
    float _S34 = __ldg(&(&(globalParams_0->families_0)[family_1])->size_0);
    (&cell_0)->across_0 = _S32 - 0.5f * _S34;
    float _S35 = __ldg(&(&(globalParams_0->families_0)[family_1])->half_width_0);
    (&cell_0)->half_width_1 = _S35;
    float _S36 = turns_and_remainder_0(family_1, _S29).y;
    float _S37 = __ldg(&(&(globalParams_0->families_0)[family_1])->count_0);
    (&cell_0)->thread_0 = uint(clamp_0(_S36, 0.0f, _S37 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S38 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S38)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    float _S39 = __ldg(&(&(globalParams_0->families_0)[family_2])->start_0);
    float _S40 = position_1 - _S39;
    float _S41 = __ldg(&(&(globalParams_0->families_0)[family_2])->inverse_period_0);
    float turns_0 = _S40 * _S41;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    float _S42 = __ldg(&(&(globalParams_0->families_0)[family_2])->period_0);
    float _S43 = turns_1 * _S42;
    float _S44 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    float _S45 = turns_1 * _S44;
    float _S46 = __ldg(&(&(globalParams_0->families_0)[family_2])->bins_0);
    uint _S47 = uint(clamp_0(_S45, 0.0f, _S46 - 1.0f));
    uint _S48 = __ldg(&(&(globalParams_0->families_0)[family_2])->first_thread_table_0);
    uint _S49 = __ldg((&(globalParams_0->words_0)[_S48 + _S47]));
    uint _S50 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S51;
    if(_S43 >= (table_number_0(_S50 + _S49 * 4U + 1U)))
    {
        _S51 = 1U;
    }
    else
    {
        _S51 = 0U;
    }
    uint _S52 = _S49 + _S51;
    float _S53 = __ldg(&(&(globalParams_0->families_0)[family_2])->count_0);
    uint _S54 = (U32_min((_S52), (uint(_S53) - 1U)));
    uint _S55 = __ldg(&(&(globalParams_0->families_0)[family_2])->place_table_0);
    uint _S56 = _S55 + _S54 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S54;
    (&cell_1)->below_0 = _S43 - table_number_0(_S56);
    (&cell_1)->above_0 = table_number_0(_S56 + 1U) - _S43;
    (&cell_1)->across_0 = _S43 - table_number_0(_S56 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S56 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    uint _S57 = __ldg(&(&(globalParams_0->families_0)[family_3])->is_alike_0);
    if(_S57 != 0U)
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
    bool _S58 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S59 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S60;
    if(_S58)
    {
        if(!_S59)
        {
            _S60 = true;
        }
        else
        {
            _S60 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S60 = false;
    }
    (&shown_0)->is_warp_0 = _S60;
    if(!_S58)
    {
        _S60 = !_S59;
    }
    else
    {
        _S60 = false;
    }
    (&shown_0)->hole_0 = _S60;
    uint _S61;
    if((&shown_0)->is_warp_0)
    {
        _S61 = crossing_0->warp_word_0;
    }
    else
    {
        _S61 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S61;
    (&shown_0)->on_top_0 = ((_S61 & 1U) == 1U) != back_3;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S62;
    if(is_first_0)
    {
        _S62 = first_0->thread_0;
    }
    else
    {
        _S62 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S62;
    float _S63;
    if(is_first_0)
    {
        _S63 = first_0->across_0;
    }
    else
    {
        _S63 = second_0->across_0;
    }
    (&cell_2)->across_0 = _S63;
    if(is_first_0)
    {
        _S63 = first_0->half_width_1;
    }
    else
    {
        _S63 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S63;
    if(is_first_0)
    {
        _S63 = first_0->below_0;
    }
    else
    {
        _S63 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S63;
    if(is_first_0)
    {
        _S63 = first_0->above_0;
    }
    else
    {
        _S63 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S63;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S64 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S65 = _S64.x;
    float _S66 = __ldg(&(&(globalParams_0->families_0)[family_4])->period_0);
    uint _S67 = __ldg(&(&(globalParams_0->families_0)[family_4])->place_table_0);
    return (F32_fma((_S65), (_S66), (table_number_0(_S67 + uint(_S64.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    uint _S68 = __ldg(&(&(globalParams_0->families_0)[family_5])->is_alike_0);
    if(_S68 != 0U)
    {
        float _S69 = float(last_0 - first_1);
        float _S70 = __ldg(&(&(globalParams_0->families_0)[family_5])->size_0);
        return _S69 * _S70;
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
    uint _S71 = __ldg(&(&(globalParams_0->families_0)[family_6])->bend_table_0);
    uint _S72 = __ldg(&(&(globalParams_0->families_0)[family_6])->is_alike_0);
    uint _S73;
    if(_S72 != 0U)
    {
        _S73 = 0U;
    }
    else
    {
        _S73 = thread_3 * 4U;
    }
    uint _S74 = _S71 + _S73;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S74);
    (&bend_0)->half_tangent_0 = table_number_0(_S74 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S74 + 2U);
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
    int _S75 = int((word_1 >> int(1)) & 127U);
    int _S76 = int((word_1 >> int(8)) & 127U);
    int _S77 = int((word_1 >> int(15)) & 63U);
    int _S78 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S79 = crossed_0->thread_0;
    int _S80 = - _S75;
    float _S81 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S80, int(0));
    (&run_0)->from_start_0 = _S81;
    int _S82 = _S76 + int(1);
    float _S83 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S82);
    (&run_0)->to_end_0 = _S83;
    bool _S84 = _S81 < _S83;
    (&run_0)->near_start_0 = _S84;
    int _S85;
    if(_S84)
    {
        _S85 = _S80 - _S77;
    }
    else
    {
        _S85 = _S82;
    }
    int _S86;
    if((&run_0)->near_start_0)
    {
        _S86 = _S80;
    }
    else
    {
        _S86 = _S82 + _S78;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S87;
    if((&run_0)->straight_0)
    {
        _S87 = 1.0e+06f;
    }
    else
    {
        _S87 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S87;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S79, _S85, _S86)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S75 == int(0);
    (&run_0)->last_crossing_0 = _S76 == int(0);
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
    float _S88 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S89 = clamp_0(cell_3->across_0, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_1 = _S89;
    float _S90 = _S88 * _S88 - square_0(_S89);
    float _S91 = (F32_rsqrt((_S90)));
    (&section_0)->drop_0 = _S88 - _S90 * _S91;
    (&section_0)->slope_0 = - _S89 * _S91;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    uint _S92 = __ldg(&(&(globalParams_0->families_0)[family_7])->is_alike_0);
    if(_S92 != 0U)
    {
        uint _S93 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
        return table_number_0(_S93 + 3U);
    }
    uint _S94 = __ldg(&(&(globalParams_0->families_0)[family_7])->bend_table_0);
    return table_number_0(_S94 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S95 = crossed_1->below_0;
    float _S96 = crossed_1->above_0;
    bool _S97 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S98 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S99;
    if(_S97)
    {
        _S99 = _S95 - crossed_1->across_0;
    }
    else
    {
        _S99 = _S96 + crossed_1->across_0;
    }
    float _S100 = _S99 - crossed_1->half_width_1;
    bool _S101;
    if(_S97)
    {
        _S101 = run_1->first_crossing_0;
    }
    else
    {
        _S101 = run_1->last_crossing_0;
    }
    bool _S102 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S99 = 0.0f;
    }
    else
    {
        float _S103 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        _S99 = _S103 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S104;
    if(_S102 != _S101)
    {
        _S104 = 0.0f;
    }
    else
    {
        float _S105 = __ldg(&(&(globalParams_0->families_0)[other_1])->height_scale_0);
        uint _S106 = crossed_1->thread_0;
        int _S107;
        if(_S97)
        {
            _S107 = int(-1);
        }
        else
        {
            _S107 = int(1);
        }
        _S104 = _S105 * edge_drop_0(other_1, _S106, _S107);
    }
    float _S108 = 1.0f / (F32_max((2.0f * _S100), (9.999999960041972e-13f)));
    float _S109 = clamp_0((_S100 - _S98) * _S108, 0.0f, 1.0f);
    float _S110 = _S99 + (_S104 - _S99) * (_S109 * _S109 * (3.0f - 2.0f * _S109));
    float _S111 = (_S99 - _S104) * (6.0f * _S109 * (1.0f - _S109) * _S108);
    if(_S97)
    {
        _S99 = 1.0f;
    }
    else
    {
        _S99 = -1.0f;
    }
    return make_float2 (_S110, _S111 * _S99);
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
    float _S112 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S112)))), (9.99999971718068537e-10f)));
    float _S113 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S113)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S112 > 0.0f;
    (&control_0)->up_0 = _S113 > 0.0f;
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
    float _S114;
    if(forwards_0)
    {
        _S114 = cell_4->across_0;
    }
    else
    {
        _S114 = - cell_4->across_0;
    }
    float _S115;
    if(forwards_0)
    {
        _S115 = cell_4->above_0;
    }
    else
    {
        _S115 = cell_4->below_0;
    }
    bool _S116;
    if(forwards_0)
    {
        _S116 = run_2->last_crossing_0;
    }
    else
    {
        _S116 = run_2->first_crossing_0;
    }
    bool _S117;
    if(forwards_0)
    {
        _S117 = run_2->first_crossing_0;
    }
    else
    {
        _S117 = run_2->last_crossing_0;
    }
    float _S118 = cell_4->half_width_1;
    float _S119 = - cell_4->half_width_1;
    bool _S120 = _S114 < _S119;
    bool _S121 = _S114 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S116 = !_S116;
    }
    else
    {
        _S116 = false;
    }
    if(_S116)
    {
        _S116 = !shown_2->hole_0;
    }
    else
    {
        _S116 = false;
    }
    bool _S122;
    if(_S116)
    {
        _S122 = shown_2->on_top_0;
    }
    else
    {
        _S122 = false;
    }
    if(_S122)
    {
        if(_S117)
        {
            _S117 = _S120;
        }
        else
        {
            _S117 = false;
        }
        _S117 = !_S117;
    }
    else
    {
        _S117 = false;
    }
    if(shown_2->hole_0)
    {
        _S116 = true;
    }
    else
    {
        if(_S116)
        {
            _S116 = !shown_2->on_top_0;
        }
        else
        {
            _S116 = false;
        }
    }
    float _S123;
    if(_S120)
    {
        _S123 = _S119;
    }
    else
    {
        _S123 = _S118;
    }
    float _S124 = _S123 - _S114;
    if(_S116)
    {
        _S114 = 2.0f * _S115 + _S114 - _S118;
    }
    else
    {
        _S114 = _S115;
    }
    if(_S117)
    {
        if(forwards_0)
        {
            _S114 = run_2->to_end_0;
        }
        else
        {
            _S114 = run_2->from_start_0;
        }
        return _S114;
    }
    if(_S121)
    {
    }
    else
    {
        _S114 = _S124;
    }
    return _S114;
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
    float _S125 = previous_1->rate_0;
    float _S126 = previous_1->rate_0 * step_4;
    float _S127 = rate_1 * step_4;
    bool _S128;
    if(!previous_1->known_0)
    {
        _S128 = true;
    }
    else
    {
        _S128 = here_0->hole_1;
    }
    if(_S128)
    {
        _S128 = true;
    }
    else
    {
        _S128 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S128)
    {
        _S128 = true;
    }
    else
    {
        _S128 = _S125 >= 0.0f;
    }
    if(_S128)
    {
        _S128 = true;
    }
    else
    {
        _S128 = rate_1 <= 0.0f;
    }
    if(_S128)
    {
        return -1.0f;
    }
    float _S129 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S126) >= 0.0f)
    {
        _S128 = (3.0f * clearance_1 - _S127) >= 0.0f;
    }
    else
    {
        _S128 = false;
    }
    if(_S128)
    {
        return -1.0f;
    }
    float _S130 = clearance_1 - _S129;
    float _S131 = 6.0f * _S130 - 4.0f * _S126 - 2.0f * _S127;
    float _S132 = -2.0f * _S126 / (F32_max((_S131 + (F32_sqrt(((F32_max((_S131 * _S131 - 4.0f * (3.0f * (_S126 + _S127 - 2.0f * _S130)) * _S126), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S133 = 1.0f - _S132;
    float _S134 = (_S129 * (2.0f * _S132 + 1.0f) + _S126 * _S132) * _S133 * _S133;
    float _S135 = (clearance_1 * (2.0f * _S133 + 1.0f) - _S127 * _S133) * _S132 * _S132;
    if(_S132 > 0.01999999955296516f)
    {
        _S128 = _S133 > 0.01999999955296516f;
    }
    else
    {
        _S128 = false;
    }
    if(_S128)
    {
        _S128 = (_S134 + _S135) < 0.0f;
    }
    else
    {
        _S128 = false;
    }
    float _S136;
    if(_S128)
    {
        _S136 = _S133 * step_4;
    }
    else
    {
        _S136 = -1.0f;
    }
    return _S136;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S137 = here_1->hole_1;
    float _S138;
    if(here_1->hole_1)
    {
        _S138 = 1.0e+09f;
    }
    else
    {
        _S138 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S138;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S139;
    if(!_S137)
    {
        _S139 = !is_cell_exit_0;
    }
    else
    {
        _S139 = false;
    }
    (&previous_2)->known_0 = _S139;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S140 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S141;
    if(!here_2->hole_1)
    {
        _S141 = (rate_3 * _S140 + clearance_3) < 0.0f;
    }
    else
    {
        _S141 = false;
    }
    if(_S141)
    {
        _S141 = _S140 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S141 = false;
    }
    float _S142 = this_2->step_2;
    float _S143;
    if(_S141)
    {
        _S143 = _S140 - this_2->epsilon_0;
    }
    else
    {
        _S143 = (F32_max((_S140), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S142), (_S143)));
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
    float _S144 = end_0 - start_1;
    float _S145 = start_rate_0 + end_rate_0 - 2.0f * _S144;
    float _S146 = 3.0f * _S144 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S144), (9.99999968265522539e-21f)));
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
        float _S147 = clamp_0(share_1 - (((_S145 * share_1 + _S146) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S145 * share_1 + 2.0f * _S146) * share_1 + start_rate_0), (0.10000000149011612f * _S144 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S148 = i_5 + int(1);
        share_1 = _S147;
        i_5 = _S148;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S149 = along_slope_0 * along_slope_0 + 1.0f;
    float _S150 = (F32_rsqrt((_S149)));
    float _S151 = sine_1 * _S150 * (F32_rsqrt((_S149 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S151 * _S149, _S151 * across_slope_0 * along_slope_0 + cosine_0 * _S150);
}

__device__ float arc_sine_0(float x_16)
{
    float _S152 = (F32_abs((x_16)));
    bool _S153 = _S152 > 0.5f;
    float _S154;
    if(_S153)
    {
        _S154 = 0.5f * (1.0f - _S152);
    }
    else
    {
        _S154 = _S152 * _S152;
    }
    float _S155;
    if(_S153)
    {
        _S155 = (F32_sqrt(((F32_max((_S154), (0.0f))))));
    }
    else
    {
        _S155 = _S152;
    }
    float _S156 = ((((0.04216320067644119f * _S154 + 0.02418131195008755f) * _S154 + 0.04547002539038658f) * _S154 + 0.07495300471782684f) * _S154 + 0.16666752099990845f) * _S154 * _S155 + _S155;
    if(_S153)
    {
        _S154 = 1.57079637050628662f - 2.0f * _S156;
    }
    else
    {
        _S154 = _S156;
    }
    if(x_16 < 0.0f)
    {
        _S154 = - _S154;
    }
    return _S154;
}

struct Hair_0
{
    float cover_0;
    float3  normal_0;
    float3  tangent_0;
};

__device__ Hair_0 Hair_x24init_0(float cover_1, float3  normal_1, float3  tangent_1)
{
    Hair_0 _S157;
    (&_S157)->cover_0 = cover_1;
    (&_S157)->normal_0 = normal_1;
    (&_S157)->tangent_0 = tangent_1;
    return _S157;
}

__device__ float fade_0(float size_1, float period_1)
{
    return clamp_0((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S158 = value_0 * 747796405U + 2891336453U;
    uint _S159 = ((_S158 >> ((_S158 >> int(28)) + 4U)) ^ _S158) * 277803737U;
    return (_S159 >> int(22)) ^ _S159;
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
    float _S160 = (F32_floor((x_17 * 0.63661974668502808f + 0.5f)));
    float _S161 = x_17 - _S160 * 1.5703125f - _S160 * 0.00048375129699707f - _S160 * 7.54979012640433211e-08f;
    float _S162 = _S161 * _S161;
    float _S163 = ((-0.00019515295571182f * _S162 + 0.00833216123282909f) * _S162 - 0.16666655242443085f) * _S162 * _S161 + _S161;
    float _S164 = ((0.00002443315679557f * _S162 - 0.00138873164542019f) * _S162 + 0.04166664555668831f) * _S162 * _S162 - 0.5f * _S162 + 1.0f;
    uint _S165 = uint(int(_S160)) & 3U;
    float2  _S166;
    if((_S165 & 1U) != 0U)
    {
        _S166 = make_float2 (_S164, _S163);
    }
    else
    {
        _S166 = make_float2 (_S163, _S164);
    }
    float _S167;
    if((_S165 & 2U) != 0U)
    {
        _S167 = - _S166.x;
    }
    else
    {
        _S167 = _S166.x;
    }
    float _S168;
    if(((_S165 + 1U) & 2U) != 0U)
    {
        _S168 = - _S166.y;
    }
    else
    {
        _S168 = _S166.y;
    }
    return make_float2 (_S167, _S168);
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
    uint _S169 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_table_0);
    uint _S170 = __ldg(&(&(globalParams_0->families_0)[family_8])->albedo_stride_0);
    return table_albedos_0(_S169 + _S170 * thread_7);
}

__device__ float3  fibre_cell_0(float across_2, float along_0, float width_2)
{
    float _S171 = (F32_floor((across_2 / width_2)));
    return make_float3 (_S171, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S171, 2.0f * (across_2 / width_2 - _S171) - 1.0f);
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
    float _S172;
    if(back_4)
    {
        float _S173 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S172 = - _S173;
    }
    else
    {
        float _S174 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_sine_0);
        _S172 = _S174;
    }
    float _S175 = point_0->fibre_across_0;
    float _S176 = __ldg(&(&(globalParams_0->families_0)[family_9])->ply_cosine_0);
    float _S177 = _S175 * _S176 + point_0->fibre_along_0 * _S172;
    float _S178 = __ldg(&(&(globalParams_0->families_0)[family_9])->plies_per_mm_0);
    float _S179 = _S177 * _S178;
    return 2.0f * (_S179 - (F32_floor((_S179)))) - 1.0f;
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
    float _S180 = (F32_floor((position_3)));
    float _S181 = position_3 - _S180;
    uint _S182 = uint(int(_S180));
    float _S183 = signed_noise_0(hash_bits_0(key_1, _S182));
    float _S184 = signed_noise_0(hash_bits_0(key_1, _S182 + 1U));
    return make_float2 (lerp_0(_S183, _S184, smooth_share_0(_S181)), 6.0f * _S181 * (1.0f - _S181) * (_S184 - _S183));
}

__device__ float2  cell_noise_0(uint key_2, float3  cell_6)
{
    float _S185 = cell_6.y;
    float _S186 = (F32_floor((_S185)));
    uint _S187 = uint(int(cell_6.x)) * 65536U + uint(int(_S186));
    uint _S188 = hash_bits_0(key_2, _S187);
    uint _S189 = hash_bits_0(key_2, _S187 + 1U);
    return lerp_2(make_float2 (signed_noise_0(_S188), signed_noise_0(_S188 >> int(16))), make_float2 (signed_noise_0(_S189), signed_noise_0(_S189 >> int(16))), make_float2 (smooth_share_0(_S185 - _S186)));
}

__device__ float uniform_hash_0(uint thread_8, uint cell_7, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_8, stream_1), cell_7)) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_1, float3  room_0)
{
    float3  _S190 = room_0 / max_0(albedo_1, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S190.x), (_S190.y)))), (_S190.z)))), (0.0f))))));
}

__device__ float flattened_0(float largest_0, float3  albedo_2, float3  room_1)
{
    float3  _S191 = room_1 / max_0(albedo_2, make_float3 (9.99999997475242708e-07f)) - make_float3 (1.0f);
    return (F32_min(((F32_max(((F32_min(((F32_min((_S191.x), (_S191.y)))), (_S191.z)))), (0.0f))) / (F32_max((largest_0), (9.99999997475242708e-07f)))), (1.0f)));
}

__device__ float natural_logarithm_0(float x_18)
{
    uint _S192 = (F32_asuint((x_18)));
    float exponent_0 = float(int(_S192 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S192 & 8388607U) | 1056964608U)));
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
    float _S193 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S193 - exponent_1 * 0.00021219444170129f - 0.5f * _S193) + exponent_1 * 0.693359375f;
}

__device__ float fibre_gain_0(uint thread_10, uint cell_8, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_10, cell_8, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3  normal_3;
    float3  tangent_3;
    float loss_0;
};

__device__ YarnFrame_0 under_hair_0(YarnFrame_0 * frame_0, Hair_0 * hair_0)
{
    float3  _S194 = frame_0->tangent_3;
    float3  _S195 = hair_0->tangent_0;
    float3  _S196;
    if((dot_0(frame_0->tangent_3, hair_0->tangent_0)) < 0.0f)
    {
        _S196 = - _S195;
    }
    else
    {
        _S196 = _S195;
    }
    YarnFrame_0 blended_0;
    float3  _S197 = make_float3 (hair_0->cover_0);
    float3  _S198 = normalize_0(lerp_1(frame_0->normal_3, hair_0->normal_0, _S197));
    (&blended_0)->normal_3 = _S198;
    float3  _S199 = lerp_1(_S194, _S196, _S197);
    float3  _S200 = _S199 - make_float3 (dot_0(_S199, _S198)) * _S198;
    (&blended_0)->tangent_3 = _S200 * make_float3 ((F32_rsqrt(((F32_max((dot_0(_S200, _S200)), (9.999999960041972e-13f)))))));
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
    float3  _S201 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S202 = sends_0->sky_warp_0 + _S201 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S202;
    float3  _S203 = sends_0->sky_weft_0 + _S201 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S203;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S202 + make_float3 (sends_0->blocks_weft_0) * _S203;
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
    float3  _S204 = make_float3 (blocked_0->by_warp_0 + blocked_0->by_weft_0) * interior_0->leaked_1;
    float3  _S205 = make_float3 (blocked_0->far_0) * yarn_2->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_5 * (make_float3 (blocked_0->by_warp_0) * interior_0->warp_3 + make_float3 (blocked_0->by_weft_0) * interior_0->weft_3) + _S205 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S205 * interior_0->far_1 + yarn_2->back_5 * _S204;
    return bounced_0;
}

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_4, float blend_1)
{
    float _S206 = light_0.z;
    if(_S206 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S206), (0.0f))), (F32_max((dot_0(light_0, normal_4)), (0.0f))), blend_1);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_4, float roughness_1)
{
    float _S207 = dot_0(direction_2, tangent_4);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S207 * _S207 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_19)
{
    float _S208 = clamp_0(x_19, -87.0f, 88.0f);
    float _S209 = (F32_floor((_S208 * 1.4426950216293335f + 0.5f)));
    float _S210 = _S208 - _S209 * 0.693359375f + _S209 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S210 + 0.00139819993637502f) * _S210 + 0.00833345204591751f) * _S210 + 0.04166579619050026f) * _S210 + 0.1666666567325592f) * _S210 + 0.5f;
    float _S211 = (U32_asfloat((uint(int(_S209) + int(127)) << int(23))));
    float _S212;
    if(x_19 < -87.0f)
    {
        _S212 = 0.0f;
    }
    else
    {
        _S212 = (p_0 * _S210 * _S210 + _S210 + 1.0f) * _S211;
    }
    return _S212;
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
    float _S213 = roughness_2 * roughness_2;
    float _S214 = squared_along_0 * (1.0f - _S213) + _S213;
    return 0.31830987334251404f * _S213 * roughness_2 / (_S214 * _S214);
}

__device__ float density_between_0(float3  light_1, float3  view_0, float3  tangent_5, float roughness_3)
{
    float3  _S215 = light_1 + view_0;
    float _S216 = dot_0(_S215, tangent_5);
    return flake_density_0((F32_min((_S216 * _S216 / (F32_max((square_1(_S215)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_2, float3  view_1, float3  normal_5, float3  tangent_6, float roughness_4, float optical_depth_1)
{
    float _S217 = dot_0(light_2, normal_5);
    bool _S218;
    if(_S217 <= 0.0f)
    {
        _S218 = true;
    }
    else
    {
        _S218 = (dot_0(view_1, normal_5)) <= 0.0f;
    }
    if(_S218)
    {
        return 0.0f;
    }
    float _S219 = (F32_max((_S217), (9.99999997475242708e-07f)));
    float _S220 = (F32_max((dot_0(view_1, normal_5)), (9.99999997475242708e-07f)));
    float _S221 = projected_area_1(light_2, tangent_6, roughness_4) * _S220 + projected_area_1(view_1, tangent_6, roughness_4) * _S219;
    float _S222 = optical_depth_1 * _S221 / (_S219 * _S220);
    return 0.25f * density_between_0(light_2, view_1, tangent_6, roughness_4) * (_S222 * mean_attenuation_0(_S222)) * _S219 / _S221;
}

__device__ float transmission_1(float3  light_3, float3  view_2, float3  normal_6, float3  tangent_7, float roughness_5, float optical_depth_2)
{
    float _S223 = - dot_0(light_3, normal_6);
    float _S224 = dot_0(view_2, normal_6);
    bool _S225;
    if(_S223 <= 0.0f)
    {
        _S225 = true;
    }
    else
    {
        _S225 = _S224 <= 0.0f;
    }
    if(_S225)
    {
        return 0.0f;
    }
    float _S226 = 1.0f / (F32_max((_S224), (9.99999997475242708e-07f)));
    float _S227 = projected_area_1(light_3, tangent_7, roughness_5) / (F32_max((_S223), (9.99999997475242708e-07f)));
    float _S228 = projected_area_1(view_2, tangent_7, roughness_5) * _S226;
    return density_between_0(light_3, view_2, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S227), (_S228)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S227 - _S228)))) * _S226;
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
    float _S229 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S230 = 2.0f * (F32_sqrt((_S229))) - 1.0f;
    float _S231 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S230, _S231), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S229) * sheen_shear_0(_S230, _S231), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S230, _S231), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_4, float3  view_3, float scale_0, float shear_0)
{
    float _S232 = light_4.z;
    bool _S233;
    if(_S232 <= 0.0f)
    {
        _S233 = true;
    }
    else
    {
        _S233 = (view_3.z) <= 0.0f;
    }
    if(_S233)
    {
        return 0.0f;
    }
    float2  _S234 = float2 {view_3.x, view_3.y};
    float _S235 = dot_1(_S234, _S234);
    float2  _S236;
    if(_S235 > 9.99999968265522539e-21f)
    {
        _S236 = _S234 * make_float2 ((F32_rsqrt((_S235))));
    }
    else
    {
        _S236 = make_float2 (1.0f, 0.0f);
    }
    float _S237 = scale_0 * dot_1(float2 {light_4.x, light_4.y}, _S236) + shear_0 * _S232;
    float _S238 = scale_0 * (light_4.y * _S236.x - light_4.x * _S236.y);
    float _S239 = _S237 * _S237 + _S238 * _S238 + _S232 * _S232;
    return 0.31830987334251404f * scale_0 * scale_0 * _S232 / (F32_max((_S239 * _S239), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_5, float3  view_4, float strength_0, float roughness_7)
{
    float3  _S240 = sheen_lobe_0(view_4.z, roughness_7);
    float _S241 = strength_0 * _S240.z;
    return make_float2 (_S241 * transformed_cosine_0(light_5, view_4, _S240.x, _S240.y), 1.0f - _S241);
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_6, float3  view_5)
{
    float _S242 = light_6.z;
    float3  _S243;
    if((_S242 * view_5.z) < 0.0f)
    {
        _S243 = bounced_1->transmitted_0;
    }
    else
    {
        _S243 = bounced_1->reflected_0;
    }
    return _S243 * make_float3 ((F32_abs((_S242))) * 0.31830987334251404f);
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

__device__ Crossing_0 crossing_at_0(uint _S244, float _S245, float _S246, bool _S247)
{
    Fabric_0 * _S248 = (&(globalParams_0->fabrics_0)[_S244]);
    Crossing_0 crossing_2;
    uint _S249 = __ldg(&_S248->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S249, _S245);
    uint _S250 = __ldg(&_S248->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S250, _S246);
    uint _S251 = __ldg(&_S248->run_words_0);
    uint _S252 = (&(&crossing_2)->weft_1)->thread_0;
    uint _S253 = __ldg(&_S248->ends_1);
    uint _S254 = _S251 + 2U * (_S252 * _S253 + (&(&crossing_2)->warp_1)->thread_0);
    uint _S255 = __ldg((&(globalParams_0->words_0)[_S254]));
    (&crossing_2)->warp_word_0 = _S255;
    uint _S256 = __ldg((&(globalParams_0->words_0)[_S254 + 1U]));
    (&crossing_2)->weft_word_0 = _S256;
    (&crossing_2)->warp_above_0 = ((_S255 & 1U) == 1U) != _S247;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S257, float _S258, float _S259, bool _S260)
{
    Fabric_0 * _S261 = (&(globalParams_0->fabrics_0)[_S257]);
    Sample_0 sample_0;
    Crossing_0 _S262 = crossing_at_0(_S257, _S258, _S259, _S260);
    (&sample_0)->crossing_1 = _S262;
    Crossing_0 _S263 = _S262;
    Shown_0 _S264 = shown_at_0(&_S263, _S260);
    (&sample_0)->shown_3 = _S264;
    uint _S265;
    if(_S264.is_warp_0)
    {
        uint _S266 = __ldg(&_S261->warp_0);
        _S265 = _S266;
    }
    else
    {
        uint _S267 = __ldg(&_S261->weft_0);
        _S265 = _S267;
    }
    uint _S268;
    if(_S264.is_warp_0)
    {
        uint _S269 = __ldg(&_S261->weft_0);
        _S268 = _S269;
    }
    else
    {
        uint _S270 = __ldg(&_S261->warp_0);
        _S268 = _S270;
    }
    Cell_0 _S271 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S272 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S273 = select_cell_0(_S264.is_warp_0, &_S271, &_S272);
    Cell_0 _S274 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S275 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S276 = select_cell_0(_S264.is_warp_0, &_S274, &_S275);
    Cell_0 _S277 = _S276;
    Run_0 _S278 = unpack_0(_S265, _S268, _S273.thread_0, &_S277, _S264.word_0);
    Cell_0 _S279 = _S273;
    Section_0 _S280 = section_at_0(&_S279);
    bool _S281;
    if(_S264.on_top_0)
    {
        _S281 = (_S278.distance_0) < (_S280.drop_0 * _S278.bend_1.sine_0);
    }
    else
    {
        _S281 = false;
    }
    bool _S282;
    if(_S264.on_top_0)
    {
        _S282 = !_S281;
    }
    else
    {
        _S282 = false;
    }
    float _S283;
    if(_S282)
    {
        _S283 = 1.0f;
    }
    else
    {
        _S283 = -1.0f;
    }
    float _S284;
    if(_S281)
    {
        _S284 = _S278.other_reach_0;
    }
    else
    {
        _S284 = _S278.reach_0;
    }
    float _S285;
    if(_S281)
    {
        _S285 = _S284 + _S278.distance_0;
    }
    else
    {
        _S285 = (F32_max((_S284 - _S278.distance_0), (0.0f)));
    }
    float _S286 = _S284 / _S278.bend_1.sine_0 - _S283 * _S280.drop_0;
    float _S287 = _S285 * _S285;
    float _S288 = (F32_max((_S286 * _S286 - _S287), (9.99999968265522539e-21f)));
    float _S289 = (F32_rsqrt((_S288)));
    float _S290 = _S287 / (_S288 * _S289 + _S286);
    bool _S291 = _S285 > 0.0f;
    float _S292;
    if(_S264.on_top_0)
    {
        _S292 = 1.0f;
    }
    else
    {
        _S292 = -1.0f;
    }
    float _S293;
    if(_S278.near_start_0)
    {
        _S293 = 1.0f;
    }
    else
    {
        _S293 = -1.0f;
    }
    float _S294 = _S292 * _S293;
    if(_S291)
    {
        _S292 = _S286 * _S289;
    }
    else
    {
        _S292 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S280.slope_0 * _S292;
    if(_S291)
    {
        _S285 = _S294 * _S285 * _S289;
    }
    else
    {
        _S285 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S285;
    float _S295 = __ldg(&(&(globalParams_0->families_0)[_S265])->height_scale_0);
    Shown_0 _S296 = _S264;
    Run_0 _S297 = _S278;
    Cell_0 _S298 = _S276;
    float2  _S299 = dive_0(_S268, &_S296, &_S297, &_S298);
    if(_S278.straight_0)
    {
        _S283 = 0.0f;
    }
    else
    {
        _S283 = _S295 * _S283;
    }
    (&sample_0)->height_7 = _S283 * (_S284 * _S278.bend_1.half_tangent_0 - _S290) - _S295 * _S280.drop_0 - _S299.x;
    float _S300 = _S295 * (&sample_0)->slope_across_0;
    float _S301 = _S295 * (&sample_0)->slope_along_0 - _S299.y;
    if(_S264.is_warp_0)
    {
        _S283 = _S300;
    }
    else
    {
        _S283 = _S301;
    }
    (&sample_0)->slope_x_1 = _S283;
    if(_S264.is_warp_0)
    {
        _S283 = _S301;
    }
    else
    {
        _S283 = _S300;
    }
    (&sample_0)->slope_y_1 = _S283;
    (&sample_0)->run_3 = _S278;
    (&sample_0)->section_1 = _S280;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S302, SearchQuality_0 * _S303, float3  _S304)
{
    Fabric_0 * _S305 = (&(globalParams_0->fabrics_0)[_S302]);
    float _S306 = (F32_abs((_S304.x)));
    float _S307 = __ldg(&_S305->threads_per_x_0);
    float _S308 = _S306 * _S307;
    float _S309 = (F32_abs((_S304.y)));
    float _S310 = __ldg(&_S305->threads_per_y_0);
    float _S311 = (F32_max((_S308), (_S309 * _S310))) * _S303->steps_per_thread_0;
    float _S312 = (F32_abs((_S304.z)));
    float _S313 = __ldg(&_S305->per_relief_0);
    return (F32_max((_S311), (_S312 * _S313 * _S303->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S314, Crossing_0 * _S315)
{
    Fabric_0 * _S316 = (&(globalParams_0->fabrics_0)[_S314]);
    bool _S317 = _S315->warp_above_0;
    uint _S318;
    if(_S315->warp_above_0)
    {
        uint _S319 = __ldg(&_S316->warp_0);
        _S318 = _S319;
    }
    else
    {
        uint _S320 = __ldg(&_S316->weft_0);
        _S318 = _S320;
    }
    uint _S321;
    if(_S317)
    {
        _S321 = _S315->warp_word_0;
    }
    else
    {
        _S321 = _S315->weft_word_0;
    }
    float _S322 = float(_S321 >> int(28));
    float _S323 = __ldg(&(&(globalParams_0->families_0)[_S318])->height_scale_0);
    float _S324 = _S322 * _S323;
    float _S325 = __ldg(&(&(globalParams_0->families_0)[_S318])->level_0);
    return _S324 * _S325;
}

__device__ Probe_0 probe_0(uint _S326, float _S327, float _S328, bool _S329, bool _S330, bool _S331)
{
    Sample_0 _S332 = sample_at_0(_S326, _S327, _S328, _S329);
    Probe_0 probe_1;
    (&probe_1)->height_2 = _S332.height_7;
    (&probe_1)->hole_1 = _S332.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S332.slope_x_1;
    (&probe_1)->slope_y_0 = _S332.slope_y_1;
    uint _S333;
    if(_S332.shown_3.is_warp_0)
    {
        _S333 = _S332.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S333 = _S332.crossing_1.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S333;
    Crossing_0 _S334 = _S332.crossing_1;
    float _S335 = cell_maximum_0(_S326, &_S334);
    (&probe_1)->cell_max_0 = _S335;
    float _S336;
    if(_S330)
    {
        _S336 = _S332.crossing_1.warp_1.above_0;
    }
    else
    {
        _S336 = _S332.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S336;
    if(_S331)
    {
        _S336 = _S332.crossing_1.weft_1.above_0;
    }
    else
    {
        _S336 = _S332.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S336;
    bool _S337 = !_S332.shown_3.is_warp_0;
    Cell_0 _S338 = _S332.crossing_1.warp_1;
    Shown_0 _S339 = _S332.shown_3;
    Run_0 _S340 = _S332.run_3;
    float _S341 = outline_distance_0(&_S338, &_S339, &_S340, _S337, _S330);
    (&probe_1)->edge_x_0 = _S341;
    Cell_0 _S342 = _S332.crossing_1.weft_1;
    Shown_0 _S343 = _S332.shown_3;
    Run_0 _S344 = _S332.run_3;
    float _S345 = outline_distance_0(&_S342, &_S343, &_S344, _S332.shown_3.is_warp_0, _S331);
    (&probe_1)->edge_y_0 = _S345;
    return probe_1;
}

__device__ bool is_free_0(uint _S346, SearchQuality_0 * _S347, float3  _S348, float3  _S349, bool _S350, float _S351)
{
    float _S352 = _S349.z;
    if(_S352 <= 0.0f)
    {
        return false;
    }
    float _S353 = _S347->shadow_share_0;
    float _S354 = steps_per_length_0(_S346, _S347, _S349);
    float _S355 = 1.0f / (F32_max((_S353 * _S354), (9.99999971718068537e-10f)));
    StepControl_0 _S356 = step_control_0(float2 {_S349.x, _S349.y}, _S355);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S357;
        if(count_1 < 1024U)
        {
            _S357 = (_S348.z + _S352 * distance_1) < _S351;
        }
        else
        {
            _S357 = false;
        }
        if(_S357)
        {
        }
        else
        {
            break;
        }
        float3  _S358 = _S348 + _S349 * make_float3 (distance_1);
        Probe_0 _S359 = probe_0(_S346, _S358.x, _S358.y, _S350, _S356.right_1, _S356.up_0);
        float _S360 = _S358.z;
        float _S361 = _S360 - _S359.height_2;
        float _S362 = _S352 - _S359.slope_x_0 * _S349.x - _S359.slope_y_0 * _S349.y;
        bool _S363;
        if(!_S359.hole_1)
        {
            _S363 = _S361 < 0.0f;
        }
        else
        {
            _S363 = false;
        }
        if(_S363)
        {
            return false;
        }
        PreviousSample_0 _S364 = previous_3;
        Probe_0 _S365 = _S359;
        float _S366 = way_back_to_dip_0(&_S364, _S361, _S362, last_step_0, &_S365);
        if(_S366 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S366;
            distance_1 = distance_1 - _S366;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S367 = _S360 > (_S359.cell_max_0);
        Probe_0 _S368 = _S359;
        PreviousSample_0 _S369 = after_sample_0(_S361, _S362, &_S368, _S367);
        float last_step_2;
        if(_S367)
        {
            StepControl_0 _S370 = _S356;
            float _S371 = StepControl_to_cell_exit_0(&_S370, _S359.side_x_0, _S359.side_y_0);
            last_step_2 = (F32_max((_S371), (_S355)));
        }
        else
        {
            StepControl_0 _S372 = _S356;
            Probe_0 _S373 = _S359;
            float _S374 = StepControl_to_next_sample_0(&_S372, &_S373, _S361, _S362);
            last_step_2 = _S374;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S369;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S375, SearchQuality_0 * _S376, float _S377, float _S378, float3  _S379, bool _S380)
{
    Fabric_0 * _S381 = (&(globalParams_0->fabrics_0)[_S375]);
    Sample_0 _S382 = sample_at_0(_S375, _S377, _S378, _S380);
    if(!_S382.shown_3.hole_0)
    {
        return false;
    }
    float3  _S383 = make_float3 (_S377, _S378, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S384;
        if(side_0 < 2U)
        {
            _S384 = passes_0;
        }
        else
        {
            _S384 = false;
        }
        if(_S384)
        {
        }
        else
        {
            break;
        }
        float3  _S385;
        if(side_0 == 0U)
        {
            _S385 = _S379;
        }
        else
        {
            _S385 = make_float3 (- _S379.x, - _S379.y, _S379.z);
        }
        bool _S386 = _S380 != (side_0 == 1U);
        float _S387 = __ldg(&_S381->height_high_0);
        bool _S388 = is_free_0(_S375, _S376, _S383, _S385, _S386, _S387);
        uint _S389 = side_0 + 1U;
        passes_0 = _S388;
        side_0 = _S389;
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

__device__ float max_height_along_0(uint _S390, float _S391, float _S392, float _S393, float3  _S394, bool _S395)
{
    Fabric_0 * _S396 = (&(globalParams_0->fabrics_0)[_S390]);
    uint _S397 = __ldg(&_S396->warp_0);
    uint _S398 = locate_0(_S397, _S391).thread_0 / 2U;
    uint _S399 = __ldg(&_S396->weft_0);
    uint _S400 = locate_0(_S399, _S392).thread_0 / 2U;
    float _S401 = _S394.x;
    uint _S402;
    if(_S401 > 0.0f)
    {
        _S402 = 1U;
    }
    else
    {
        _S402 = 0U;
    }
    float _S403 = _S394.y;
    uint _S404;
    if(_S403 > 0.0f)
    {
        _S404 = 2U;
    }
    else
    {
        _S404 = 0U;
    }
    uint _S405 = _S402 + _S404;
    uint _S406 = __ldg(&_S396->max_heights_0);
    uint _S407 = __ldg(&_S396->max_height_columns_0);
    uint _S408 = __ldg((&(globalParams_0->words_0)[_S406 + 4U * (_S400 * _S407 + _S398) + _S405]));
    int number_0;
    if(_S395)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S409 = _S408 >> number_0;
    float _S410 = (F32_abs((_S401)));
    float _S411 = __ldg(&_S396->threads_per_x_0);
    float _S412 = _S410 * _S411;
    float _S413 = (F32_abs((_S403)));
    float _S414 = __ldg(&_S396->threads_per_y_0);
    float _S415 = (F32_max((_S412), (_S413 * _S414))) / _S394.z;
    float _S416 = __ldg(&_S396->height_high_0);
    float max_height_0 = _S416;
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
        if(((max_height_0 - _S393) * _S415) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S409 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S416)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S417, float _S418, float _S419, bool _S420, bool _S421, bool _S422)
{
    Crossing_0 _S423 = crossing_at_0(_S417, _S418, _S419, _S420);
    Crossing_0 _S424 = _S423;
    float _S425 = cell_maximum_0(_S417, &_S424);
    float _S426;
    if(_S421)
    {
        _S426 = _S423.warp_1.above_0;
    }
    else
    {
        _S426 = _S423.warp_1.below_0;
    }
    float _S427;
    if(_S422)
    {
        _S427 = _S423.weft_1.above_0;
    }
    else
    {
        _S427 = _S423.weft_1.below_0;
    }
    return make_float3 (_S425, _S426, _S427);
}

__device__ float first_sample_height_0(uint _S428, ViewRay_0 * _S429, StepControl_0 * _S430, bool _S431)
{
    float _S432 = max_height_along_0(_S428, _S429->origin_0.x, _S429->origin_0.y, 0.0f, make_float3 (_S429->slope_1.x, _S429->slope_1.y, 1.0f), _S431);
    uint count_2 = 0U;
    float height_9 = _S432;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S433 = ViewRay_at_0(_S429, height_9);
        float3  _S434 = cell_bounds_0(_S428, _S433.x, _S433.y, _S431, _S430->right_1, _S430->up_0);
        float _S435 = height_9 - _S434.x;
        float _S436 = StepControl_to_cell_exit_0(_S430, _S434.y, _S434.z);
        float height_10 = height_9 - clamp_0(_S435, 0.0f, _S436);
        if(_S435 <= _S436)
        {
            height_9 = height_10;
            break;
        }
        count_2 = count_2 + 1U;
        height_9 = height_10;
    }
    return height_9;
}

__device__ ViewRayEnd_0 search_down_0(uint _S437, ViewRay_0 * _S438, StepControl_0 * _S439, bool _S440)
{
    Fabric_0 * _S441 = (&(globalParams_0->fabrics_0)[_S437]);
    float _S442 = __ldg(&_S441->height_low_0);
    float _S443 = __ldg(&_S441->height_high_0);
    float _S444 = _S442 - (_S443 - _S442);
    ViewRayEnd_0 end_1;
    float _S445 = first_sample_height_0(_S437, _S438, _S439, _S440);
    (&end_1)->height_8 = _S445;
    (&end_1)->last_step_3 = _S439->epsilon_0;
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
        float2  _S446 = ViewRay_at_0(_S438, (&end_1)->height_8);
        Probe_0 _S447 = probe_0(_S437, _S446.x, _S446.y, _S440, _S439->right_1, _S439->up_0);
        float _S448 = (&end_1)->height_8 - _S447.height_2;
        Probe_0 _S449 = _S447;
        float _S450 = ViewRay_rate_0(_S438, &_S449);
        (&end_1)->depth_1 = - _S448;
        (&end_1)->rate_4 = _S450;
        bool _S451;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S451 = !_S447.hole_1;
        }
        else
        {
            _S451 = false;
        }
        bool _S452;
        if(_S451)
        {
            _S452 = ((&(&end_1)->previous_4)->yarn_0) == (_S447.yarn_1);
        }
        else
        {
            _S452 = false;
        }
        (&end_1)->smooth_0 = _S452;
        bool _S453;
        if(!_S447.hole_1)
        {
            _S453 = _S448 <= 0.0f;
        }
        else
        {
            _S453 = false;
        }
        bool _S454;
        if(_S453)
        {
            _S454 = true;
        }
        else
        {
            _S454 = ((&end_1)->height_8) <= _S444;
        }
        if(_S454)
        {
            break;
        }
        PreviousSample_0 _S455 = (&end_1)->previous_4;
        Probe_0 _S456 = _S447;
        float _S457 = way_back_to_dip_0(&_S455, _S448, _S450, (&end_1)->last_step_3, &_S456);
        if(_S457 >= 0.0f)
        {
            (&end_1)->height_8 = (&end_1)->height_8 + _S457;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S457;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S458 = StepControl_to_cell_exit_0(_S439, _S447.side_x_0, _S447.side_y_0);
        float _S459 = (F32_min((_S458), ((&end_1)->height_8 - _S447.cell_max_0)));
        Probe_0 _S460 = _S447;
        float _S461 = StepControl_to_next_sample_0(_S439, &_S460, _S448, _S450);
        bool _S462 = _S459 > _S461;
        Probe_0 _S463 = _S447;
        PreviousSample_0 _S464 = after_sample_0(_S448, _S450, &_S463, _S462);
        (&end_1)->previous_4 = _S464;
        float _S465 = (F32_max((_S459), (_S461)));
        (&end_1)->last_step_3 = _S465;
        (&end_1)->height_8 = (&end_1)->height_8 - _S465;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S466, ViewRay_0 * _S467, StepControl_0 * _S468, bool _S469, ViewRayEnd_0 * _S470, uint _S471)
{
    Fabric_0 * _S472 = (&(globalParams_0->fabrics_0)[_S466]);
    float _S473 = __ldg(&_S472->height_high_0);
    float _S474 = __ldg(&_S472->height_low_0);
    float _S475 = _S473 - _S474;
    float _S476 = _S470->height_8;
    float _S477 = _S470->last_step_3;
    float above_2 = _S470->height_8 + _S470->last_step_3;
    float above_gap_1 = clamp_0((&_S470->previous_4)->clearance_0, 0.0f, _S475);
    float under_gap_1 = clamp_0(_S470->depth_1, 0.0f, _S475);
    float _S478 = cubic_root_0(above_gap_1, - under_gap_1, (&_S470->previous_4)->rate_0 * _S470->last_step_3, _S470->rate_4 * _S470->last_step_3);
    bool _S479 = _S470->smooth_0;
    float middle_0;
    if(_S470->smooth_0)
    {
        middle_0 = above_2 - _S478 * _S477;
    }
    else
    {
        middle_0 = between_0(above_2, _S476, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S476;
    float above_3 = above_2;
    uint i_6 = 0U;
    for(;;)
    {
        if(i_6 < _S471)
        {
        }
        else
        {
            break;
        }
        float2  _S480 = ViewRay_at_0(_S467, middle_0);
        Probe_0 _S481 = probe_0(_S466, _S480.x, _S480.y, _S469, _S468->right_1, _S468->up_0);
        float _S482;
        if(_S481.hole_1)
        {
            _S482 = -1.0e+09f;
        }
        else
        {
            _S482 = _S481.height_2;
        }
        float _S483 = clamp_0(middle_0 - _S482, - _S475, _S475);
        float _S484;
        if(_S483 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S484 = 0.5f * above_gap_2;
            }
            else
            {
                _S484 = above_gap_2;
            }
            float _S485 = - _S483;
            under_1 = middle_0;
            above_gap_2 = _S484;
            under_gap_2 = _S485;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S484 = 0.5f * under_gap_2;
            }
            else
            {
                _S484 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S483;
            under_gap_2 = _S484;
            side_1 = -1.0f;
        }
        if(_S479)
        {
            Probe_0 _S486 = _S481;
            float _S487 = ViewRay_rate_0(_S467, &_S486);
            middle_0 = clamp_0(middle_0 + _S483 / (F32_min((_S487), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_6 = i_6 + 1U;
    }
    if(_S479)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S488, SearchQuality_0 * _S489, float _S490, float _S491, float3  _S492, bool _S493)
{
    float _S494 = (F32_max((_S492.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S490, _S491);
    float2  _S495 = float2 {_S492.x, _S492.y} / make_float2 (_S494);
    (&ray_0)->slope_1 = _S495;
    float2  _S496 = - _S495;
    float _S497 = steps_per_length_0(_S488, _S489, _S492);
    StepControl_0 _S498 = step_control_0(_S496, 1.0f / (F32_max((_S497 / _S494), (9.99999971718068537e-10f))));
    ViewRay_0 _S499 = ray_0;
    StepControl_0 _S500 = _S498;
    ViewRayEnd_0 _S501 = search_down_0(_S488, &_S499, &_S500, _S493);
    Hit_0 hit_0;
    (&hit_0)->hole_4 = false;
    ViewRay_0 _S502 = ray_0;
    StepControl_0 _S503 = _S498;
    ViewRayEnd_0 _S504 = _S501;
    float _S505 = refined_height_0(_S488, &_S502, &_S503, _S493, &_S504, _S489->refinements_0);
    (&hit_0)->height_6 = _S505;
    ViewRay_0 _S506 = ray_0;
    float2  _S507 = ViewRay_at_0(&_S506, _S505);
    (&hit_0)->x_24 = _S507.x;
    (&hit_0)->y_14 = _S507.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S508, SearchQuality_0 * _S509, float _S510, float _S511, float3  _S512, bool _S513)
{
    bool _S514 = passes_through_0(_S508, _S509, _S510, _S511, _S512, _S513);
    if(!_S514)
    {
        Hit_0 _S515 = first_hit_of_yarn_0(_S508, _S509, _S510, _S511, _S512, _S513);
        return _S515;
    }
    Hit_0 hit_1;
    (&hit_1)->x_24 = _S510;
    (&hit_1)->y_14 = _S511;
    (&hit_1)->height_6 = 0.0f;
    (&hit_1)->hole_4 = true;
    return hit_1;
}

__device__ SurfacePoint_0 surface_at_0(uint _S516, float _S517, float _S518, bool _S519)
{
    Fabric_0 * _S520 = (&(globalParams_0->fabrics_0)[_S516]);
    Sample_0 _S521 = sample_at_0(_S516, _S517, _S518, _S519);
    float _S522;
    if(_S521.shown_3.is_warp_0)
    {
        _S522 = _S521.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S522 = _S521.crossing_1.weft_1.half_width_1;
    }
    uint _S523;
    if(_S521.shown_3.is_warp_0)
    {
        uint _S524 = __ldg(&_S520->warp_0);
        _S523 = _S524;
    }
    else
    {
        uint _S525 = __ldg(&_S520->weft_0);
        _S523 = _S525;
    }
    float _S526 = __ldg(&(&(globalParams_0->families_0)[_S523])->twist_sine_0);
    float _S527;
    if(_S519)
    {
        _S527 = -1.0f;
    }
    else
    {
        _S527 = 1.0f;
    }
    float _S528 = _S526 * _S527;
    float _S529 = __ldg(&(&(globalParams_0->families_0)[_S523])->twist_cosine_0);
    if(_S521.shown_3.is_warp_0)
    {
        _S527 = 1.0f;
    }
    else
    {
        _S527 = -1.0f;
    }
    float2  _S530 = fibre_direction_0(_S521.slope_across_0, _S527 * _S521.slope_along_0, _S528, _S529);
    float _S531;
    if(_S521.shown_3.is_warp_0)
    {
        _S531 = _S521.slope_x_1;
    }
    else
    {
        _S531 = _S521.slope_y_1;
    }
    float _S532;
    if(_S521.shown_3.is_warp_0)
    {
        _S532 = _S521.slope_y_1;
    }
    else
    {
        _S532 = _S521.slope_x_1;
    }
    float _S533 = _S530.x;
    float _S534 = _S530.y;
    float _S535 = _S531 * _S533 + _S527 * _S532 * _S534;
    float _S536 = _S522 * 1.0154266357421875f;
    float _S537 = _S536 * arc_sine_0(clamp_0(_S521.section_1.across_1 / _S536, -1.0f, 1.0f));
    if(_S521.shown_3.is_warp_0)
    {
        _S522 = _S518;
    }
    else
    {
        _S522 = - _S517;
    }
    SurfacePoint_0 point_1;
    (&point_1)->hole_2 = _S521.shown_3.hole_0;
    (&point_1)->is_warp_1 = _S521.shown_3.is_warp_0;
    (&point_1)->warp_thread_0 = _S521.crossing_1.warp_1.thread_0;
    (&point_1)->weft_thread_0 = _S521.crossing_1.weft_1.thread_0;
    (&point_1)->height_4 = _S521.height_7;
    (&point_1)->normal_2 = normalize_0(make_float3 (- _S521.slope_x_1, - _S521.slope_y_1, 1.0f));
    float3  _S538;
    if(_S521.shown_3.is_warp_0)
    {
        _S538 = make_float3 (_S533, _S534, _S535);
    }
    else
    {
        _S538 = make_float3 (- _S534, _S533, _S535);
    }
    (&point_1)->tangent_2 = normalize_0(_S538);
    (&point_1)->across_3 = _S521.section_1.across_1;
    (&point_1)->fibre_across_0 = _S537 * _S529 + _S522 * _S528;
    (&point_1)->fibre_along_0 = _S522 * _S529 - _S537 * _S528;
    return point_1;
}

__device__ bool has_hairs_0(uint _S539)
{
    Fabric_0 * _S540 = (&(globalParams_0->fabrics_0)[_S539]);
    uint _S541 = __ldg(&_S540->warp_0);
    float _S542 = __ldg(&(&(globalParams_0->families_0)[_S541])->hairiness_0);
    bool _S543;
    if(_S542 > 0.0f)
    {
        _S543 = true;
    }
    else
    {
        uint _S544 = __ldg(&_S540->weft_0);
        float _S545 = __ldg(&(&(globalParams_0->families_0)[_S544])->hairiness_0);
        _S543 = _S545 > 0.0f;
    }
    return _S543;
}

__device__ Hair_0 hair_at_0(uint _S546, float2  _S547, bool _S548, float _S549)
{
    Fabric_0 * _S550 = (&(globalParams_0->fabrics_0)[_S546]);
    float _S551 = __ldg(&_S550->fibre_size_0);
    float _S552 = 17.0f * _S551;
    float _S553 = fade_0(_S549, _S552);
    float2  _S554 = _S547 / make_float2 (_S552);
    uint number_1;
    if(_S548)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S555 = __ldg(&_S550->seed_0);
    uint _S556 = hash_key_0(number_1, _S555 ^ 1013904242U);
    float _S557 = 1.0f / (F32_max((_S549), (0.07999999821186066f * _S551)));
    float _S558 = (F32_min((0.63999998569488525f * _S551 * _S557), (1.0f)));
    float2  _S559 = make_float2 (0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2  hair_across_0 = _S559;
    number_1 = 0U;
    for(;;)
    {
        bool _S560;
        if(_S553 > 0.0f)
        {
            _S560 = number_1 < 18U;
        }
        else
        {
            _S560 = false;
        }
        if(_S560)
        {
        }
        else
        {
            break;
        }
        uint _S561 = number_1 / 9U;
        uint _S562 = number_1 / 3U - 3U * _S561;
        float2  _S563 = floor_0(_S554) + make_float2 (float(number_1 - 3U * _S562 - 9U * _S561), float(_S562)) - make_float2 (1.0f);
        uint _S564 = hash_bits_0(_S556 + _S561, uint(int(_S563.x)) * 65536U + uint(int(_S563.y)));
        uint _S565 = hash_bits_0(_S556, _S564);
        float2  _S566 = _S554 - _S563 - make_float2 (share_of_0(_S564), share_of_0(_S564 >> int(10)));
        float2  _S567 = sine_cosine_0(3.14159274101257324f * share_of_0(_S564 >> int(20)));
        float _S568 = lerp_0(5.0f, 16.0f, share_of_0(_S565 >> int(10))) / 17.0f;
        float _S569 = _S566.x;
        float _S570 = _S567.y;
        float _S571 = _S566.y;
        float _S572 = _S567.x;
        float _S573 = (_S569 * _S570 + _S571 * _S572) / _S568;
        float _S574 = 0.69999998807907104f * (2.0f * share_of_0(_S565 >> int(20)) - 1.0f);
        float _S575 = 2.0f * _S574 * _S573;
        float _S576 = (F32_rsqrt((_S575 * _S575 + 1.0f)));
        float _S577 = (_S571 * _S570 - _S569 * _S572 - _S574 * _S568 * _S573 * _S573) * _S576 * 17.0f;
        float _S578 = clamp_0((0.31999999284744263f - (F32_abs((_S577)))) * _S551 * _S557 + 0.5f, 0.0f, _S558);
        uint _S579;
        if(((_S565 >> int(30)) & 1U) == 1U)
        {
            uint _S580 = __ldg(&_S550->warp_0);
            _S579 = _S580;
        }
        else
        {
            uint _S581 = __ldg(&_S550->weft_0);
            _S579 = _S581;
        }
        float _S582 = share_of_0(_S565);
        float _S583 = __ldg(&(&(globalParams_0->families_0)[_S579])->hairiness_0);
        bool _S584;
        if(_S582 < _S583)
        {
            _S584 = (F32_abs((_S573))) < 1.0f;
        }
        else
        {
            _S584 = false;
        }
        bool _S585;
        if(_S584)
        {
            _S585 = _S578 > cover_2;
        }
        else
        {
            _S585 = false;
        }
        if(_S585)
        {
            float2  _S586 = make_float2 (- _S572 - _S575 * _S570, _S570 - _S575 * _S572) * make_float2 (_S576);
            cover_2 = _S578;
            hair_away_0 = _S577;
            hair_across_0 = _S586;
        }
        number_1 = number_1 + 1U;
    }
    float _S587 = clamp_0(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    Hair_0 hair_1;
    (&hair_1)->cover_0 = _S553 * cover_2;
    (&hair_1)->normal_0 = make_float3 ((make_float2 (_S587) * hair_across_0).x, (make_float2 (_S587) * hair_across_0).y, (F32_sqrt((1.0f - _S587 * _S587))));
    (&hair_1)->tangent_0 = make_float3 (hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

__device__ bool varies_at_0(uint _S588, float _S589)
{
    Fabric_0 * _S590 = (&(globalParams_0->fabrics_0)[_S588]);
    float _S591 = __ldg(&_S590->fibre_noise_0);
    bool _S592;
    if(_S591 > 0.0f)
    {
        _S592 = true;
    }
    else
    {
        float _S593 = __ldg(&_S590->colour_noise_0);
        _S592 = _S593 > 0.0f;
    }
    if(_S592)
    {
        _S592 = true;
    }
    else
    {
        uint _S594 = __ldg(&_S590->has_detail_0);
        if(_S594 != 0U)
        {
            _S592 = _S589 >= 0.0f;
        }
        else
        {
            _S592 = false;
        }
    }
    return _S592;
}

__device__ uint thread_number_0(uint _S595, SurfacePoint_0 * _S596, float _S597, float _S598)
{
    Fabric_0 * _S599 = (&(globalParams_0->fabrics_0)[_S595]);
    bool _S600 = _S596->is_warp_1;
    float _S601;
    if(_S596->is_warp_1)
    {
        _S601 = _S597;
    }
    else
    {
        _S601 = _S598;
    }
    float _S602 = _S601 - _S596->across_3;
    uint _S603;
    if(_S600)
    {
        uint _S604 = __ldg(&_S599->warp_0);
        _S603 = _S604;
    }
    else
    {
        uint _S605 = __ldg(&_S599->weft_0);
        _S603 = _S605;
    }
    float _S606 = __ldg(&(&(globalParams_0->families_0)[_S603])->period_0);
    float _S607 = __ldg(&(&(globalParams_0->families_0)[_S603])->count_0);
    int _S608 = int(_S607);
    if(_S600)
    {
        _S603 = _S596->warp_thread_0;
    }
    else
    {
        _S603 = _S596->weft_thread_0;
    }
    uint _S609 = uint(int((F32_floor((_S602 / _S606)))) * _S608 + int(_S603)) * 2U;
    if(_S600)
    {
        _S603 = 1U;
    }
    else
    {
        _S603 = 0U;
    }
    return _S609 + _S603;
}

struct FibreNoise_0
{
    float2  bundle_0;
    float bundle_weight_0;
    float2  fibre_0;
    float fibre_weight_0;
    float offset_1;
    float slope_2;
};

__device__ FibreNoise_0 fibre_noise_at_0(uint _S610, uint _S611, SurfacePoint_0 * _S612, uint _S613, float _S614)
{
    Fabric_0 * _S615 = (&(globalParams_0->fabrics_0)[_S610]);
    float _S616 = __ldg(&_S615->fibre_size_0);
    float _S617 = 5.0f * _S616;
    uint _S618 = __ldg(&_S615->seed_0);
    float _S619 = _S612->fibre_along_0;
    float2  _S620 = wave_noise_0(hash_key_0(_S613, _S618 ^ 458671337U), _S612->fibre_along_0 / (25.0f * _S616));
    float _S621 = _S612->fibre_across_0;
    float _S622 = __ldg(&(&(globalParams_0->families_0)[_S611])->fibre_tilt_0);
    float _S623 = _S621 + _S622 * 0.5f * 25.0f * _S616 * _S620.x;
    float3  _S624 = fibre_cell_0(_S623, _S619, _S616);
    FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S613, _S618 ^ 1757159915U), fibre_cell_0(_S623, _S619, _S617));
    (&noise_0)->bundle_weight_0 = fade_0(_S614, _S617);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S613, _S618 ^ 48610963U), _S624);
    (&noise_0)->fibre_weight_0 = fade_0(_S614, _S616);
    (&noise_0)->offset_1 = _S624.z;
    (&noise_0)->slope_2 = 0.5f * _S620.y;
    return noise_0;
}

__device__ float2  detail_gain_0(uint _S625, uint _S626, SurfacePoint_0 * _S627, float2  _S628, bool _S629, uint _S630, float _S631)
{
    Fabric_0 * _S632 = (&(globalParams_0->fabrics_0)[_S625]);
    float2  _S633 = make_float2 (0.0f);
    float _S634 = __ldg(&(&(globalParams_0->families_0)[_S626])->has_plies_0);
    float2  gain_2;
    if(_S634 > 0.0f)
    {
        float _S635 = __ldg(&(&(globalParams_0->families_0)[_S626])->plies_per_mm_0);
        float _S636 = 0.60000002384185791f * fade_0(_S631, 1.0f / _S635);
        float _S637 = ply_offset_0(_S626, _S627, _S629);
        gain_2 = make_float2 (_S636) * make_float2 (0.20000000298023224f - square_0(square_0(_S637)), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S633;
    }
    float _S638 = __ldg(&(&(globalParams_0->families_0)[_S626])->fibre_tone_0);
    if(_S638 > 0.0f)
    {
        FibreNoise_0 _S639 = fibre_noise_at_0(_S625, _S626, _S627, _S630, _S631);
        float _S640 = __ldg(&(&(globalParams_0->families_0)[_S626])->fibre_tone_0);
        gain_2 = gain_2 + make_float2 (_S640) * make_float2 (_S639.bundle_weight_0 * _S639.bundle_0.y + _S639.fibre_weight_0 * _S639.fibre_0.y, _S639.bundle_weight_0 + _S639.fibre_weight_0);
    }
    float _S641 = __ldg(&(&(globalParams_0->families_0)[_S626])->slub_0);
    if(_S641 > 0.0f)
    {
        float _S642 = __ldg(&(&(globalParams_0->families_0)[_S626])->slub_0);
        float _S643 = 0.25f * _S642;
        float _S644 = __ldg(&(&(globalParams_0->families_0)[_S626])->slubs_per_mm_0);
        float _S645 = _S643 * fade_0(_S631, 1.0f / _S644);
        float _S646;
        if(_S627->is_warp_1)
        {
            _S646 = _S628.y;
        }
        else
        {
            _S646 = - _S628.x;
        }
        uint _S647 = __ldg(&_S632->seed_0);
        uint _S648 = hash_key_0(_S630, _S647 ^ 1373058189U);
        float _S649 = __ldg(&(&(globalParams_0->families_0)[_S626])->slubs_per_mm_0);
        float2  _S650 = wave_noise_0(_S648, _S646 * _S649);
        float _S651 = _S627->across_3;
        float _S652 = __ldg(&(&(globalParams_0->families_0)[_S626])->per_half_width_0);
        gain_2 = gain_2 + make_float2 (_S645) * make_float2 (_S650.x * lerp_0(0.40000000596046448f, 1.0f, (F32_min((square_0(_S651 * _S652)), (1.0f)))), 1.0f);
    }
    return gain_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S653, Albedos_0 * _S654, uint _S655, uint _S656, float2  _S657)
{
    Fabric_0 * _S658 = (&(globalParams_0->fabrics_0)[_S653]);
    float3  _S659 = _S654->specular_reflect_0;
    float3  _S660 = _S654->specular_transmit_0;
    float3  _S661 = max_0(_S654->specular_reflect_0, _S654->specular_transmit_0);
    float3  _S662 = _S654->diffuse_reflect_0;
    float3  _S663 = _S654->diffuse_transmit_0;
    float3  _S664 = _S654->diffuse_reflect_0 + _S654->diffuse_transmit_0;
    float _S665 = __ldg(&_S658->layer_bound_0);
    float3  _S666 = make_float3 (1.0f) - make_float3 (_S665) * _S661;
    float _S667 = __ldg(&_S658->colour_noise_0);
    uint _S668 = __ldg(&_S658->seed_0);
    float colour_0 = bounded_gain_0(thread_gain_0(_S655, _S667, _S668), _S664, _S666);
    float colour_1 = colour_0 * (1.0f + flattened_0(_S657.y, make_float3 (colour_0) * _S664, _S666) * _S657.x);
    float3  _S669 = min_0((make_float3 (1.0f) - make_float3 (colour_1) * _S664) / make_float3 (_S665), make_float3 (1.0f));
    float _S670 = __ldg(&_S658->fibre_noise_0);
    float _S671 = bounded_gain_0(fibre_gain_0(_S655, _S656, _S670, _S668), _S661, _S669);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (colour_1) * _S662;
    (&varied_0)->diffuse_transmit_0 = make_float3 (colour_1) * _S663;
    (&varied_0)->specular_reflect_0 = make_float3 (_S671) * _S659;
    (&varied_0)->specular_transmit_0 = make_float3 (_S671) * _S660;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S672, SurfacePoint_0 * _S673, Albedos_0 * _S674, float _S675, float _S676, bool _S677, float _S678, float _S679)
{
    Fabric_0 * _S680 = (&(globalParams_0->fabrics_0)[_S672]);
    uint _S681 = thread_number_0(_S672, _S673, _S675, _S676);
    float _S682 = _S673->fibre_across_0;
    float _S683 = _S673->fibre_along_0;
    float _S684 = __ldg(&_S680->fibre_size_0);
    float3  _S685 = fibre_cell_0(_S682, _S683, _S684);
    float2  _S686 = make_float2 (0.0f);
    uint _S687 = __ldg(&_S680->has_detail_0);
    bool _S688;
    if(_S687 != 0U)
    {
        _S688 = _S678 >= 0.0f;
    }
    else
    {
        _S688 = false;
    }
    float2  gain_3;
    if(_S688)
    {
        uint _S689;
        if(_S673->is_warp_1)
        {
            uint _S690 = __ldg(&_S680->warp_0);
            _S689 = _S690;
        }
        else
        {
            uint _S691 = __ldg(&_S680->weft_0);
            _S689 = _S691;
        }
        float2  _S692 = detail_gain_0(_S672, _S689, _S673, make_float2 (_S675, _S676), _S677, _S681, _S678);
        gain_3 = _S692 * make_float2 (1.0f - _S679, 1.0f);
    }
    else
    {
        gain_3 = _S686;
    }
    Albedos_0 _S693 = vary_albedos_0(_S672, _S674, _S681, uint(int(_S685.x)) * 65536U + uint(int((F32_floor((_S685.y))))), gain_3);
    return _S693;
}

__device__ YarnFrame_0 turned_frame_0(uint _S694, uint _S695, SurfacePoint_0 * _S696, bool _S697, uint _S698, float _S699)
{
    YarnFrame_0 frame_2;
    (&frame_2)->normal_3 = _S696->normal_2;
    (&frame_2)->tangent_3 = _S696->tangent_2;
    (&frame_2)->loss_0 = 0.0f;
    float _S700 = __ldg(&(&(globalParams_0->families_0)[_S695])->has_plies_0);
    if(_S700 > 0.0f)
    {
        float _S701 = __ldg(&(&(globalParams_0->families_0)[_S695])->plies_per_mm_0);
        float _S702 = fade_0(_S699, 1.0f / _S701);
        float _S703 = _S702 * 0.41999998688697815f;
        float _S704 = ply_offset_0(_S695, _S696, _S697);
        float _S705 = _S703 * _S704;
        float _S706 = (F32_sqrt((1.0f - _S705 * _S705)));
        float _S707;
        if(_S697)
        {
            float _S708 = __ldg(&(&(globalParams_0->families_0)[_S695])->ply_sine_0);
            _S707 = - _S708;
        }
        else
        {
            float _S709 = __ldg(&(&(globalParams_0->families_0)[_S695])->ply_sine_0);
            _S707 = _S709;
        }
        float _S710 = __ldg(&(&(globalParams_0->families_0)[_S695])->ply_cosine_0);
        float3  _S711 = cross_0((&frame_2)->tangent_3, (&frame_2)->normal_3);
        float3  _S712 = make_float3 (_S710) * _S711 + make_float3 (_S707) * (&frame_2)->tangent_3;
        (&frame_2)->tangent_3 = make_float3 (_S710) * (make_float3 (_S710) * (&frame_2)->tangent_3 - make_float3 (_S707) * _S711) + make_float3 (_S707) * (make_float3 (_S706) * _S712 - make_float3 (_S705) * (&frame_2)->normal_3);
        (&frame_2)->normal_3 = make_float3 (_S706) * (&frame_2)->normal_3 + make_float3 (_S705) * _S712;
        (&frame_2)->loss_0 = _S702 * _S702 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S713 = __ldg(&(&(globalParams_0->families_0)[_S695])->fibre_tilt_0);
    if(_S713 > 0.0f)
    {
        FibreNoise_0 _S714 = fibre_noise_at_0(_S694, _S695, _S696, _S698, _S699);
        float _S715 = 1.09858846664428711f * _S713 * (_S714.bundle_weight_0 * _S714.bundle_0.x + _S714.fibre_weight_0 * (_S714.fibre_0.x + _S714.offset_1));
        float _S716 = _S713 * (1.42099642753601074f * (_S714.bundle_weight_0 * _S714.bundle_0.y + _S714.fibre_weight_0 * _S714.fibre_0.y) - _S714.bundle_weight_0 * _S714.slope_2);
        float _S717 = square_0(_S714.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S713 * _S713 * ((0.24761904776096344f * (square_0(_S714.bundle_weight_0) + _S717) + _S717 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3  _S718 = cross_0((&frame_2)->tangent_3, (&frame_2)->normal_3);
        float2  _S719 = sine_cosine_0(_S715);
        float2  _S720 = sine_cosine_0(_S716);
        float _S721 = _S719.y;
        float _S722 = _S719.x;
        float3  _S723 = make_float3 (_S721) * _S718 - make_float3 (_S722) * (&frame_2)->normal_3;
        (&frame_2)->normal_3 = make_float3 (_S721) * (&frame_2)->normal_3 + make_float3 (_S722) * _S718;
        (&frame_2)->tangent_3 = make_float3 (_S720.y) * (&frame_2)->tangent_3 + make_float3 (_S720.x) * _S723;
    }
    return frame_2;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S724, SurfacePoint_0 * _S725, float _S726, float _S727, bool _S728, bool _S729, float _S730)
{
    Fabric_0 * _S731 = (&(globalParams_0->fabrics_0)[_S724]);
    bool _S732 = _S725->is_warp_1;
    uint _S733;
    if(_S725->is_warp_1)
    {
        uint _S734 = __ldg(&_S731->warp_0);
        _S733 = _S734;
    }
    else
    {
        uint _S735 = __ldg(&_S731->weft_0);
        _S733 = _S735;
    }
    uint _S736 = __ldg(&_S731->has_detail_0);
    bool _S737;
    if(_S736 != 0U)
    {
        _S737 = _S730 >= 0.0f;
    }
    else
    {
        _S737 = false;
    }
    float3  _S738 = make_float3 (0.0f);
    Hair_0 _S739 = Hair_x24init_0(0.0f, _S738, _S738);
    bool _S740;
    if(_S737)
    {
        bool _S741 = has_hairs_0(_S724);
        _S740 = _S741;
    }
    else
    {
        _S740 = false;
    }
    Hair_0 hair_2;
    if(_S740)
    {
        Hair_0 _S742 = hair_at_0(_S724, make_float2 (_S726, _S727), _S728, _S730);
        hair_2 = _S742;
    }
    else
    {
        hair_2 = _S739;
    }
    uint _S743;
    if(_S732)
    {
        _S743 = _S725->warp_thread_0;
    }
    else
    {
        _S743 = _S725->weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S733, _S743);
    bool _S744 = varies_at_0(_S724, _S730);
    Albedos_0 albedos_3;
    if(_S744)
    {
        Albedos_0 _S745 = albedos_2;
        Albedos_0 _S746 = varied_at_0(_S724, _S725, &_S745, _S726, _S727, _S728, _S730, hair_2.cover_0);
        albedos_3 = _S746;
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_2;
    (&point_2)->back_6 = _S728;
    (&point_2)->hole_3 = _S729;
    (&point_2)->is_warp_2 = _S732;
    (&point_2)->x_23 = _S726;
    (&point_2)->y_13 = _S727;
    (&point_2)->height_5 = _S725->height_4;
    (&point_2)->normal_7 = _S725->normal_2;
    (&point_2)->tangent_8 = _S725->tangent_2;
    (&point_2)->surface_normal_0 = _S725->normal_2;
    (&point_2)->diffuse_gain_1 = 1.0f;
    if(_S737)
    {
        uint _S747 = thread_number_0(_S724, _S725, _S726, _S727);
        YarnFrame_0 _S748 = turned_frame_0(_S724, _S733, _S725, _S728, _S747, _S730);
        bool _S749 = has_hairs_0(_S724);
        YarnFrame_0 frame_3;
        if(_S749)
        {
            YarnFrame_0 _S750 = _S748;
            Hair_0 _S751 = hair_2;
            YarnFrame_0 _S752 = under_hair_0(&_S750, &_S751);
            frame_3 = _S752;
        }
        else
        {
            frame_3 = _S748;
        }
        (&point_2)->normal_7 = frame_3.normal_3;
        (&point_2)->tangent_8 = frame_3.tangent_3;
        float _S753 = __ldg(&_S731->diffuse_blend_0);
        YarnFrame_0 _S754 = frame_3;
        float _S755 = diffuse_gain_0(&_S754, _S753);
        (&point_2)->diffuse_gain_1 = _S755;
    }
    float _S756 = __ldg(&(&(globalParams_0->families_0)[_S733])->roughness_0);
    (&point_2)->roughness_8 = _S756;
    (&point_2)->albedos_1 = albedos_3;
    return point_2;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S757, SearchQuality_0 * _S758, float _S759, float _S760, float3  _S761, float _S762)
{
    bool _S763 = (_S761.z) < 0.0f;
    Hit_0 _S764 = first_hit_0(_S757, _S758, _S759, _S760, to_face_frame_0(_S761, _S763), _S763);
    SurfacePoint_0 _S765 = surface_at_0(_S757, _S764.x_24, _S764.y_14, _S763);
    SurfacePoint_0 _S766 = _S765;
    YarnPoint_0 _S767 = yarn_point_of_0(_S757, &_S766, _S764.x_24, _S764.y_14, _S763, _S764.hole_4, _S762);
    return _S767;
}

__device__ float openness_number_0(uint _S768, uint _S769)
{
    uint _S770 = __ldg(&(&(globalParams_0->fabrics_0)[_S768])->openness_0);
    return table_number_0(_S770 + _S769);
}

__device__ Blocked_0 blocked_of_terms_0(uint _S771, uint _S772, FixedArray<float, 6>  * _S773, uint _S774)
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
            if(term_0 < _S774)
            {
            }
            else
            {
                break;
            }
            float _S775 = openness_number_0(_S771, _S772 + share_3 * _S774 + term_0);
            shares_0[share_3] = shares_0[share_3] + _S775 * (*_S773)[term_0];
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

__device__ Blocked_0 blocked_at_0(uint _S776, bool _S777, bool _S778, float _S779, float _S780)
{
    float _S781 = openness_number_0(_S776, 158U);
    float _S782 = _S780 * _S781;
    float _S783 = _S779 * _S779;
    float _S784 = _S779 * _S782;
    float _S785 = _S782 * _S782;
    uint _S786;
    if(_S778)
    {
        _S786 = 2U;
    }
    else
    {
        _S786 = 0U;
    }
    uint _S787;
    if(_S777)
    {
        _S787 = 0U;
    }
    else
    {
        _S787 = 1U;
    }
    uint _S788 = 60U + (_S786 + _S787) * 18U;
    FixedArray<float, 6>  _S789;
    _S789[int(0)] = 1.0f;
    _S789[int(1)] = _S779;
    _S789[int(2)] = _S782;
    _S789[int(3)] = _S783;
    _S789[int(4)] = _S784;
    _S789[int(5)] = _S785;
    Blocked_0 _S790 = blocked_of_terms_0(_S776, _S788, &_S789, 6U);
    return _S790;
}

__device__ Scattered_0 scattered_by_0(uint _S791, Albedos_0 * _S792, uint _S793, float3  _S794)
{
    uint _S795 = 159U + 2U * _S793;
    Scattered_0 yarn_3;
    float3  _S796 = _S794 * _S792->diffuse_reflect_0;
    float _S797 = openness_number_0(_S791, _S795);
    (&yarn_3)->back_5 = _S796 + make_float3 (_S797) * _S792->specular_reflect_0;
    float3  _S798 = _S794 * _S792->diffuse_transmit_0;
    float _S799 = openness_number_0(_S791, _S795 + 1U);
    (&yarn_3)->through_0 = _S798 + make_float3 (_S799) * _S792->specular_transmit_0;
    return yarn_3;
}

__device__ void sent_0(uint _S800, uint _S801, float3  _S802, float3  _S803, float3  _S804, float3  _S805, float3  * _S806, float3  * _S807)
{
    uint _S808 = 146U + 4U * _S801;
    float _S809 = openness_number_0(_S800, _S808);
    float _S810 = openness_number_0(_S800, _S808 + 1U);
    float _S811 = openness_number_0(_S800, _S808 + 2U);
    float _S812 = openness_number_0(_S800, _S808 + 3U);
    float3  _S813 = make_float3 (1.0f) - _S804 * make_float3 (_S809);
    float3  _S814 = make_float3 (1.0f) - _S805 * make_float3 (_S812);
    float3  _S815 = make_float3 (1.0f) / (_S813 * _S814 - _S804 * _S805 * make_float3 (_S810 * _S811));
    *_S806 = (_S802 * _S814 + _S804 * make_float3 (_S810) * _S803) * _S815;
    *_S807 = (_S803 * _S813 + _S805 * make_float3 (_S811) * _S802) * _S815;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S816, uint _S817, Scattered_0 * _S818, Scattered_0 * _S819)
{
    uint _S820 = 2U * _S817;
    uint _S821 = 142U + _S820;
    float _S822 = openness_number_0(_S816, _S821);
    float _S823 = openness_number_0(_S816, _S821 + 1U);
    float3  _S824 = make_float3 (1.0f - _S822) * _S818->back_5;
    float3  _S825 = make_float3 (1.0f - _S823) * _S819->back_5;
    FaceSends_0 sends_1;
    uint _S826 = 154U + _S820;
    float _S827 = openness_number_0(_S816, _S826);
    (&sends_1)->blocks_warp_0 = _S827;
    float _S828 = openness_number_0(_S816, _S826 + 1U);
    (&sends_1)->blocks_weft_0 = _S828;
    (&sends_1)->open_0 = _S827 * _S822 + _S828 * _S823;
    sent_0(_S816, _S817, make_float3 (_S822) * _S818->back_5, make_float3 (_S823) * _S819->back_5, _S824, _S825, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S816, _S817, _S818->through_0, _S819->through_0, _S824, _S825, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S829, float3  _S830, bool _S831)
{
    Fabric_0 * _S832 = (&(globalParams_0->fabrics_0)[_S829]);
    uint _S833 = __ldg(&_S832->warp_0);
    uint _S834 = __ldg(&(&(globalParams_0->families_0)[_S833])->colour_mean_0);
    Albedos_0 _S835 = table_albedos_0(_S834);
    Scattered_0 _S836 = scattered_by_0(_S829, &_S835, 0U, _S830);
    uint _S837 = __ldg(&_S832->weft_0);
    uint _S838 = __ldg(&(&(globalParams_0->families_0)[_S837])->colour_mean_0);
    Albedos_0 _S839 = table_albedos_0(_S838);
    Scattered_0 _S840 = scattered_by_0(_S829, &_S839, 1U, _S830);
    uint _S841;
    if(_S831)
    {
        _S841 = 1U;
    }
    else
    {
        _S841 = 0U;
    }
    Scattered_0 _S842 = _S836;
    Scattered_0 _S843 = _S840;
    FaceSends_0 _S844 = face_sends_0(_S829, _S841, &_S842, &_S843);
    if(_S831)
    {
        _S841 = 0U;
    }
    else
    {
        _S841 = 1U;
    }
    Scattered_0 _S845 = _S836;
    Scattered_0 _S846 = _S840;
    FaceSends_0 _S847 = face_sends_0(_S829, _S841, &_S845, &_S846);
    float3  _S848 = make_float3 (_S844.blocks_warp_0) * _S844.crossing_warp_0 + make_float3 (_S844.blocks_weft_0) * _S844.crossing_weft_0;
    float3  _S849 = make_float3 (_S847.blocks_warp_0) * _S847.crossing_warp_0 + make_float3 (_S847.blocks_weft_0) * _S847.crossing_weft_0;
    float _S850 = 1.0f - _S844.open_0;
    float _S851 = 1.0f - _S847.open_0;
    float3  _S852 = make_float3 (1.0f) / (make_float3 (1.0f) - _S848 * _S849 * make_float3 (_S850 * _S851));
    float3  _S853 = _S849 * (make_float3 (_S844.open_0) + make_float3 (_S850) * (make_float3 (_S844.blocks_warp_0) * _S844.sky_warp_0 + make_float3 (_S844.blocks_weft_0) * _S844.sky_weft_0)) * _S852;
    float3  _S854 = _S848 * (make_float3 (_S847.open_0) + make_float3 (_S851) * (make_float3 (_S847.blocks_warp_0) * _S847.sky_warp_0 + make_float3 (_S847.blocks_weft_0) * _S847.sky_weft_0)) * _S852;
    FaceSends_0 _S855 = _S844;
    FaceRadiance_0 _S856 = face_radiance_0(&_S855, _S847.open_0, _S853, _S854);
    FaceSends_0 _S857 = _S847;
    FaceRadiance_0 _S858 = face_radiance_0(&_S857, _S844.open_0, _S854, _S853);
    Interior_0 interior_1;
    (&interior_1)->warp_3 = _S856.warp_2;
    (&interior_1)->weft_3 = _S856.weft_2;
    (&interior_1)->leaked_1 = _S856.leaked_0;
    (&interior_1)->far_1 = _S858.mean_0;
    (&interior_1)->far_leaked_0 = _S858.leaked_0;
    return interior_1;
}

__device__ Bounced_0 bounced_at_0(uint _S859, YarnPoint_0 * _S860, float3  _S861)
{
    Fabric_0 * _S862 = (&(globalParams_0->fabrics_0)[_S859]);
    Bounced_0 nothing_0;
    float3  _S863 = make_float3 (0.0f);
    (&nothing_0)->reflected_0 = _S863;
    (&nothing_0)->transmitted_0 = _S863;
    uint _S864 = __ldg(&_S862->openness_0);
    bool _S865;
    if(_S864 == 4294967295U)
    {
        _S865 = true;
    }
    else
    {
        _S865 = _S860->hole_3;
    }
    if(_S865)
    {
        return nothing_0;
    }
    bool _S866 = _S860->back_6;
    Blocked_0 _S867 = blocked_at_0(_S859, _S860->is_warp_2, _S860->back_6, _S860->surface_normal_0.z, _S860->height_5);
    uint _S868;
    if(_S860->is_warp_2)
    {
        _S868 = 0U;
    }
    else
    {
        _S868 = 1U;
    }
    Scattered_0 _S869 = scattered_by_0(_S859, &_S860->albedos_1, _S868, _S861);
    Interior_0 _S870 = interior_of_0(_S859, _S861, _S866);
    Blocked_0 _S871 = _S867;
    Scattered_0 _S872 = _S869;
    Interior_0 _S873 = _S870;
    Bounced_0 _S874 = bounced_by_0(&_S871, &_S872, &_S873);
    return _S874;
}

__device__ float3  scattered_0(uint _S875, YarnPoint_0 * _S876, float3  _S877, float3  _S878)
{
    Fabric_0 * _S879 = (&(globalParams_0->fabrics_0)[_S875]);
    float3  _S880 = make_float3 (0.0f);
    bool _S881 = !_S876->hole_3;
    bool _S882;
    if(_S881)
    {
        _S882 = (_S877.z) > 0.0f;
    }
    else
    {
        _S882 = false;
    }
    float3  value_1;
    if(_S882)
    {
        float3  _S883 = (&_S876->albedos_1)->diffuse_reflect_0 * make_float3 (_S876->diffuse_gain_1);
        float3  _S884 = _S876->normal_7;
        float _S885 = __ldg(&_S879->diffuse_blend_0);
        float3  _S886 = _S883 * make_float3 (diffuse_reflection_0(_S877, _S884, _S885));
        float3  _S887 = (&_S876->albedos_1)->specular_reflect_0;
        float3  _S888 = _S876->tangent_8;
        float _S889 = _S876->roughness_8;
        float _S890 = __ldg(&_S879->optical_depth_0);
        value_1 = _S886 + _S887 * make_float3 (reflection_0(_S877, _S878, _S884, _S888, _S889, _S890));
    }
    else
    {
        if(_S881)
        {
            _S882 = (_S877.z) < 0.0f;
        }
        else
        {
            _S882 = false;
        }
        if(_S882)
        {
            float3  _S891 = (&_S876->albedos_1)->diffuse_transmit_0 * make_float3 (_S876->diffuse_gain_1);
            float3  _S892 = - _S877;
            float3  _S893 = _S876->normal_7;
            float _S894 = __ldg(&_S879->diffuse_blend_0);
            float3  _S895 = _S891 * make_float3 (diffuse_reflection_0(_S892, _S893, _S894));
            float3  _S896 = (&_S876->albedos_1)->specular_transmit_0;
            float3  _S897 = _S876->tangent_8;
            float _S898 = _S876->roughness_8;
            float _S899 = __ldg(&_S879->optical_depth_0);
            value_1 = _S895 + _S896 * make_float3 (transmission_1(_S877, _S878, _S893, _S897, _S898, _S899));
        }
        else
        {
            value_1 = _S880;
        }
    }
    float _S900 = __ldg(&_S879->sheen_strength_0);
    if(_S900 <= 0.0f)
    {
        return value_1;
    }
    float _S901 = __ldg(&_S879->sheen_roughness_0);
    float2  _S902 = sheen_with_transmittance_0(_S877, _S878, _S900, _S901);
    return make_float3 (_S902.y) * value_1 + make_float3 (_S902.x);
}

__device__ bool unoccluded_0(uint _S903, SearchQuality_0 * _S904, float _S905, float _S906, float _S907, float3  _S908, bool _S909)
{
    Fabric_0 * _S910 = (&(globalParams_0->fabrics_0)[_S903]);
    if((_S908.z) <= 0.0f)
    {
        return false;
    }
    float _S911 = max_height_along_0(_S903, _S905, _S906, _S907, _S908, _S909);
    float _S912 = __ldg(&_S910->lift_0);
    bool _S913 = is_free_0(_S903, _S904, make_float3 (_S905, _S906, _S907 + _S912), _S908, _S909, _S911);
    return _S913;
}

__device__ bool is_lit_0(uint _S914, SearchQuality_0 * _S915, YarnPoint_0 * _S916, float3  _S917)
{
    if(_S916->hole_3)
    {
        return true;
    }
    bool _S918 = _S916->back_6;
    float3  _S919 = to_face_frame_0(_S917, _S916->back_6);
    float _S920 = _S919.z;
    bool _S921 = _S920 < 0.0f;
    float3  _S922 = _S916->surface_normal_0;
    float _S923 = _S916->height_5;
    float3  normal_8;
    float height_11;
    if(_S921)
    {
        SurfacePoint_0 _S924 = surface_at_0(_S914, _S916->x_23, _S916->y_13, !_S918);
        normal_8 = _S924.normal_2;
        height_11 = _S924.height_4;
    }
    else
    {
        normal_8 = _S922;
        height_11 = _S923;
    }
    float3  _S925 = make_float3 (float2 {_S919.x, _S919.y}.x, float2 {_S919.x, _S919.y}.y, (F32_abs((_S920))));
    if((dot_0(normal_8, _S925)) <= 0.0f)
    {
        return false;
    }
    bool _S926 = unoccluded_0(_S914, _S915, _S916->x_23, _S916->y_13, height_11, _S925, _S918 != _S921);
    return _S926;
}

__device__ float3  evaluate_with_0(uint _S927, SearchQuality_0 * _S928, YarnPoint_0 * _S929, Bounced_0 * _S930, float3  _S931, float3  _S932)
{
    Fabric_0 * _S933 = (&(globalParams_0->fabrics_0)[_S927]);
    float3  _S934 = to_face_frame_0(_S932, _S929->back_6);
    float3  _S935 = scattered_0(_S927, _S929, to_face_frame_0(_S931, _S929->back_6), _S934);
    bool _S936;
    if((F32_max((_S935.x), ((F32_max((_S935.y), (_S935.z)))))) <= 0.0f)
    {
        _S936 = true;
    }
    else
    {
        bool _S937 = is_lit_0(_S927, _S928, _S929, _S931);
        _S936 = !_S937;
    }
    float3  value_2;
    if(_S936)
    {
        value_2 = make_float3 (0.0f);
    }
    else
    {
        value_2 = _S935;
    }
    float3  _S938 = bounced_value_0(_S930, _S931, _S932);
    float _S939 = __ldg(&_S933->sheen_strength_0);
    float3  between_1;
    if(_S939 > 0.0f)
    {
        float _S940 = (F32_abs((_S934.z)));
        float _S941 = __ldg(&_S933->sheen_roughness_0);
        between_1 = _S938 * make_float3 (1.0f - _S939 * sheen_lobe_0(_S940, _S941).z);
    }
    else
    {
        between_1 = _S938;
    }
    return value_2 + between_1;
}

__device__ float3  evaluate_0(uint _S942, SearchQuality_0 * _S943, YarnPoint_0 * _S944, float3  _S945, float3  _S946)
{
    Bounced_0 _S947 = bounced_at_0(_S942, _S944, make_float3 (1.0f));
    Bounced_0 _S948 = _S947;
    float3  _S949 = evaluate_with_0(_S942, _S943, _S944, &_S948, _S945, _S946);
    return _S949;
}

__device__ float straight_through_0(uint _S950, YarnPoint_0 * _S951, float3  _S952)
{
    Fabric_0 * _S953 = (&(globalParams_0->fabrics_0)[_S950]);
    if(!_S951->hole_3)
    {
        return 0.0f;
    }
    float _S954 = __ldg(&_S953->sheen_strength_0);
    if(_S954 <= 0.0f)
    {
        return 1.0f;
    }
    float _S955 = (F32_abs((_S952.z)));
    float _S956 = __ldg(&_S953->sheen_roughness_0);
    return 1.0f - _S954 * sheen_lobe_0(_S955, _S956).z;
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_1, float2  dx_1, float2  dy_1, float3  light_7, float3  view_6)
{
    SearchQuality_0 _S957 = default_quality_0();
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_1;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    float _S958 = centre_1.x;
    float _S959 = centre_1.y;
    Footprint_0 _S960 = footprint_0;
    float _S961 = Footprint_spread_side_0(&_S960);
    SearchQuality_0 _S962 = _S957;
    YarnPoint_0 _S963 = locate_yarn_0(fabric_2, &_S962, _S958, _S959, view_6, _S961);
    SearchQuality_0 _S964 = _S957;
    YarnPoint_0 _S965 = _S963;
    float3  _S966 = evaluate_0(fabric_2, &_S964, &_S965, light_7, view_6);
    YarnPoint_0 _S967 = _S963;
    float _S968 = straight_through_0(fabric_2, &_S967, view_6);
    return make_float4 (_S966.x, _S966.y, _S966.z, _S968);
}

extern "C" __global__ void point_queries()
{
    uint _S969 = (blockIdx * blockDim + threadIdx).x;
    uint _S970 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S969 >= _S970)
    {
        return;
    }
    Query_0 _S971 = slang_ldg_0((&(globalParams_0->queries_0)[_S969]));
    *(&(globalParams_0->answers_0)[_S969]) = cloth_value_0(_S971.fabric_1, make_float2 (_S971.centre_x_0, _S971.centre_y_0), make_float2 (_S971.dx_x_0, _S971.dx_y_0), make_float2 (_S971.dy_x_0, _S971.dy_y_0), make_float3 (_S971.light_x_0, _S971.light_y_0, _S971.light_z_0), make_float3 (_S971.view_x_0, _S971.view_y_0, _S971.view_z_0));
    return;
}

