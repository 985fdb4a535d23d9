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

__device__ float3  min_0(float3  x_9, float3  y_6)
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
        *_slang_vector_get_element_ptr(&result_4, i_2) = (F32_min((_slang_vector_get_element(x_9, i_2)), (_slang_vector_get_element(y_6, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_4;
}

__device__ float3  max_0(float3  x_10, float3  y_7)
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
        *_slang_vector_get_element_ptr(&result_5, i_3) = (F32_max((_slang_vector_get_element(x_10, i_3)), (_slang_vector_get_element(y_7, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_5;
}

__device__ float3  normalize_0(float3  x_11)
{
    return x_11 / make_float3 (length_0(x_11));
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ Query_0 slang_ldg_0(Query_0 * ptr_0)
{
    uint _S1 = __ldg(&ptr_0->fabric_1);
    float _S2 = __ldg(&ptr_0->centre_x_0);
    float _S3 = __ldg(&ptr_0->centre_y_0);
    float _S4 = __ldg(&ptr_0->dx_x_0);
    float _S5 = __ldg(&ptr_0->dx_y_0);
    float _S6 = __ldg(&ptr_0->dy_x_0);
    float _S7 = __ldg(&ptr_0->dy_y_0);
    float _S8 = __ldg(&ptr_0->light_x_0);
    float _S9 = __ldg(&ptr_0->light_y_0);
    float _S10 = __ldg(&ptr_0->light_z_0);
    float _S11 = __ldg(&ptr_0->view_x_0);
    float _S12 = __ldg(&ptr_0->view_y_0);
    float _S13 = __ldg(&ptr_0->view_z_0);
    Query_0 _S14 = { _S1, _S2, _S3, _S4, _S5, _S6, _S7, _S8, _S9, _S10, _S11, _S12, _S13 };
    return _S14;
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

__device__ float3  to_face_frame_0(float3  direction_0, bool back_2)
{
    float2  _S15 = float2 {direction_0.x, direction_0.y};
    float _S16;
    if(back_2)
    {
        _S16 = - direction_0.z;
    }
    else
    {
        _S16 = direction_0.z;
    }
    return make_float3 (_S15.x, _S15.y, _S16);
}

__device__ Family_0 slang_ldg_1(Family_0 * ptr_1)
{
    uint _S17 = __ldg(&ptr_1->is_alike_0);
    float _S18 = __ldg(&ptr_1->count_0);
    float _S19 = __ldg(&ptr_1->inverse_count_0);
    float _S20 = __ldg(&ptr_1->half_inverse_count_0);
    float _S21 = __ldg(&ptr_1->size_0);
    float _S22 = __ldg(&ptr_1->inverse_size_0);
    float _S23 = __ldg(&ptr_1->half_width_0);
    float _S24 = __ldg(&ptr_1->start_0);
    float _S25 = __ldg(&ptr_1->period_0);
    float _S26 = __ldg(&ptr_1->inverse_period_0);
    float _S27 = __ldg(&ptr_1->bins_0);
    uint _S28 = __ldg(&ptr_1->first_thread_table_0);
    uint _S29 = __ldg(&ptr_1->place_table_0);
    uint _S30 = __ldg(&ptr_1->bend_table_0);
    float _S31 = __ldg(&ptr_1->height_scale_0);
    float _S32 = __ldg(&ptr_1->twist_sine_0);
    float _S33 = __ldg(&ptr_1->twist_cosine_0);
    float _S34 = __ldg(&ptr_1->level_0);
    float _S35 = __ldg(&ptr_1->roughness_0);
    uint _S36 = __ldg(&ptr_1->albedo_table_0);
    uint _S37 = __ldg(&ptr_1->albedo_stride_0);
    uint _S38 = __ldg(&ptr_1->before_0);
    float _S39 = __ldg(&ptr_1->visible_total_0);
    float _S40 = __ldg(&ptr_1->smallest_box_0);
    uint _S41 = __ldg(&ptr_1->quantities_0);
    uint _S42 = __ldg(&ptr_1->colour_mean_0);
    uint _S43 = __ldg(&ptr_1->colour_axes_0);
    uint _S44 = __ldg(&ptr_1->colour_threads_0);
    uint _S45 = __ldg(&ptr_1->colour_areas_0);
    float _S46 = __ldg(&ptr_1->area_unit_0);
    float _S47 = __ldg(&ptr_1->crossing_area_0);
    Family_0 _S48 = { _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30, _S31, _S32, _S33, _S34, _S35, _S36, _S37, _S38, _S39, _S40, _S41, _S42, _S43, _S44, _S45, _S46, _S47 };
    return _S48;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_0)
{
    Family_0 _S49 = slang_ldg_1((&(globalParams_0->families_0)[family_0]));
    Family_0 _S50 = slang_ldg_1((&(globalParams_0->families_0)[family_0]));
    float _S51 = (F32_floor(((F32_fma((index_0), (_S49.inverse_count_0), (_S50.half_inverse_count_0))))));
    float _S52 = - _S51;
    Family_0 _S53 = slang_ldg_1((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S51, (F32_fma((_S52), (_S53.count_0), (index_0))));
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
    Family_0 _S54 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    float _S55 = (F32_floor((position_0 * _S54.inverse_size_0)));
    Cell_0 cell_0;
    float _S56 = - _S55;
    Family_0 _S57 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    float _S58 = (F32_fma((_S56), (_S57.size_0), (position_0)));
    (&cell_0)->below_0 = _S58;
    Family_0 _S59 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->above_0 = _S59.size_0 - _S58;
    Family_0 _S60 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->across_0 = _S58 - 0.5f * _S60.size_0;
    Family_0 _S61 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->half_width_1 = _S61.half_width_0;
    float _S62 = turns_and_remainder_0(family_1, _S55).y;
    Family_0 _S63 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_0)->thread_0 = uint(clamp_0(_S62, 0.0f, _S63.count_0 - 1.0f));
    return cell_0;
}

__device__ float table_number_0(uint index_1)
{
    uint _S64 = __ldg((&(globalParams_0->words_0)[index_1]));
    return (U32_asfloat((_S64)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_1)
{
    Family_0 _S65 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float _S66 = position_1 - _S65.start_0;
    Family_0 _S67 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S66 * _S67.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S68 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float _S69 = turns_1 * _S68.period_0;
    Family_0 _S70 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float _S71 = turns_1 * _S70.bins_0;
    Family_0 _S72 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S73 = uint(clamp_0(_S71, 0.0f, _S72.bins_0 - 1.0f));
    Family_0 _S74 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S75 = __ldg((&(globalParams_0->words_0)[_S74.first_thread_table_0 + _S73]));
    Family_0 _S76 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S77;
    if(_S69 >= (table_number_0(_S76.place_table_0 + _S75 * 4U + 1U)))
    {
        _S77 = 1U;
    }
    else
    {
        _S77 = 0U;
    }
    uint _S78 = _S75 + _S77;
    Family_0 _S79 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S80 = (U32_min((_S78), (uint(_S79.count_0) - 1U)));
    Family_0 _S81 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S82 = _S81.place_table_0 + _S80 * 4U;
    Cell_0 cell_1;
    (&cell_1)->thread_0 = _S80;
    (&cell_1)->below_0 = _S69 - table_number_0(_S82);
    (&cell_1)->above_0 = table_number_0(_S82 + 1U) - _S69;
    (&cell_1)->across_0 = _S69 - table_number_0(_S82 + 2U);
    (&cell_1)->half_width_1 = table_number_0(_S82 + 3U);
    return cell_1;
}

__device__ Cell_0 locate_0(uint family_3, float position_2)
{
    Family_0 _S83 = slang_ldg_1((&(globalParams_0->families_0)[family_3]));
    if((_S83.is_alike_0) != 0U)
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
    bool _S84 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S85 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S86;
    if(_S84)
    {
        if(!_S85)
        {
            _S86 = true;
        }
        else
        {
            _S86 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S86 = false;
    }
    (&shown_0)->is_warp_0 = _S86;
    if(!_S84)
    {
        _S86 = !_S85;
    }
    else
    {
        _S86 = false;
    }
    (&shown_0)->hole_0 = _S86;
    uint _S87;
    if((&shown_0)->is_warp_0)
    {
        _S87 = crossing_0->warp_word_0;
    }
    else
    {
        _S87 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S87;
    (&shown_0)->on_top_0 = ((_S87 & 1U) == 1U) != back_3;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_2;
    uint _S88;
    if(is_first_0)
    {
        _S88 = first_0->thread_0;
    }
    else
    {
        _S88 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S88;
    float _S89;
    if(is_first_0)
    {
        _S89 = first_0->across_0;
    }
    else
    {
        _S89 = second_0->across_0;
    }
    (&cell_2)->across_0 = _S89;
    if(is_first_0)
    {
        _S89 = first_0->half_width_1;
    }
    else
    {
        _S89 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S89;
    if(is_first_0)
    {
        _S89 = first_0->below_0;
    }
    else
    {
        _S89 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S89;
    if(is_first_0)
    {
        _S89 = first_0->above_0;
    }
    else
    {
        _S89 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S89;
    return cell_2;
}

__device__ float boundary_0(uint family_4, uint thread_1, int step_0)
{
    float2  _S90 = turns_and_remainder_0(family_4, float(int(thread_1) + step_0));
    float _S91 = _S90.x;
    Family_0 _S92 = slang_ldg_1((&(globalParams_0->families_0)[family_4]));
    Family_0 _S93 = slang_ldg_1((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S91), (_S92.period_0), (table_number_0(_S93.place_table_0 + uint(_S90.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_2, int first_1, int last_0)
{
    Family_0 _S94 = slang_ldg_1((&(globalParams_0->families_0)[family_5]));
    if((_S94.is_alike_0) != 0U)
    {
        float _S95 = float(last_0 - first_1);
        Family_0 _S96 = slang_ldg_1((&(globalParams_0->families_0)[family_5]));
        return _S95 * _S96.size_0;
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
    Family_0 _S97 = slang_ldg_1((&(globalParams_0->families_0)[family_6]));
    Family_0 _S98 = slang_ldg_1((&(globalParams_0->families_0)[family_6]));
    uint _S99;
    if((_S98.is_alike_0) != 0U)
    {
        _S99 = 0U;
    }
    else
    {
        _S99 = thread_3 * 4U;
    }
    uint _S100 = _S97.bend_table_0 + _S99;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S100);
    (&bend_0)->half_tangent_0 = table_number_0(_S100 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S100 + 2U);
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
    int _S101 = int((word_1 >> int(1)) & 127U);
    int _S102 = int((word_1 >> int(8)) & 127U);
    int _S103 = int((word_1 >> int(15)) & 63U);
    int _S104 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S105 = crossed_0->thread_0;
    int _S106 = - _S101;
    float _S107 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_0, _S106, int(0));
    (&run_0)->from_start_0 = _S107;
    int _S108 = _S102 + int(1);
    float _S109 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_0, int(1), _S108);
    (&run_0)->to_end_0 = _S109;
    bool _S110 = _S107 < _S109;
    (&run_0)->near_start_0 = _S110;
    int _S111;
    if(_S110)
    {
        _S111 = _S106 - _S103;
    }
    else
    {
        _S111 = _S108;
    }
    int _S112;
    if((&run_0)->near_start_0)
    {
        _S112 = _S106;
    }
    else
    {
        _S112 = _S108 + _S104;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_4);
    float _S113;
    if((&run_0)->straight_0)
    {
        _S113 = 1.0e+06f;
    }
    else
    {
        _S113 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S113;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S105, _S111, _S112)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S101 == int(0);
    (&run_0)->last_crossing_0 = _S102 == int(0);
    return run_0;
}

__device__ float square_0(float x_12)
{
    return x_12 * x_12;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_3)
{
    float _S114 = cell_3->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S115 = clamp_0(cell_3->across_0, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_1 = _S115;
    float _S116 = _S114 * _S114 - square_0(_S115);
    float _S117 = (F32_rsqrt((_S116)));
    (&section_0)->drop_0 = _S114 - _S116 * _S117;
    (&section_0)->slope_0 = - _S115 * _S117;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_5, int step_1)
{
    Family_0 _S118 = slang_ldg_1((&(globalParams_0->families_0)[family_7]));
    if((_S118.is_alike_0) != 0U)
    {
        Family_0 _S119 = slang_ldg_1((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S119.bend_table_0 + 3U);
    }
    Family_0 _S120 = slang_ldg_1((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S120.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_5) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S121 = crossed_1->below_0;
    float _S122 = crossed_1->above_0;
    bool _S123 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S124 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S125;
    if(_S123)
    {
        _S125 = _S121 - crossed_1->across_0;
    }
    else
    {
        _S125 = _S122 + crossed_1->across_0;
    }
    float _S126 = _S125 - crossed_1->half_width_1;
    bool _S127;
    if(_S123)
    {
        _S127 = run_1->first_crossing_0;
    }
    else
    {
        _S127 = run_1->last_crossing_0;
    }
    bool _S128 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S125 = 0.0f;
    }
    else
    {
        Family_0 _S129 = slang_ldg_1((&(globalParams_0->families_0)[other_1]));
        _S125 = _S129.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_0, int(0));
    }
    float _S130;
    if(_S128 != _S127)
    {
        _S130 = 0.0f;
    }
    else
    {
        Family_0 _S131 = slang_ldg_1((&(globalParams_0->families_0)[other_1]));
        uint _S132 = crossed_1->thread_0;
        int _S133;
        if(_S123)
        {
            _S133 = int(-1);
        }
        else
        {
            _S133 = int(1);
        }
        _S130 = _S131.height_scale_0 * edge_drop_0(other_1, _S132, _S133);
    }
    float _S134 = 1.0f / (F32_max((2.0f * _S126), (9.999999960041972e-13f)));
    float _S135 = clamp_0((_S126 - _S124) * _S134, 0.0f, 1.0f);
    float _S136 = _S125 + (_S130 - _S125) * (_S135 * _S135 * (3.0f - 2.0f * _S135));
    float _S137 = (_S125 - _S130) * (6.0f * _S135 * (1.0f - _S135) * _S134);
    if(_S123)
    {
        _S125 = 1.0f;
    }
    else
    {
        _S125 = -1.0f;
    }
    return make_float2 (_S136, _S137 * _S125);
}

struct StepControl_0
{
    float step_2;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_0;
    bool up_0;
};

__device__ StepControl_0 step_control_0(float2  direction_1, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S138 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S138)))), (9.99999971718068537e-10f)));
    float _S139 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S139)))), (9.99999971718068537e-10f)));
    (&control_0)->right_0 = _S138 > 0.0f;
    (&control_0)->up_0 = _S139 > 0.0f;
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
    float _S140;
    if(forwards_0)
    {
        _S140 = cell_4->across_0;
    }
    else
    {
        _S140 = - cell_4->across_0;
    }
    float _S141;
    if(forwards_0)
    {
        _S141 = cell_4->above_0;
    }
    else
    {
        _S141 = cell_4->below_0;
    }
    bool _S142;
    if(forwards_0)
    {
        _S142 = run_2->last_crossing_0;
    }
    else
    {
        _S142 = run_2->first_crossing_0;
    }
    bool _S143;
    if(forwards_0)
    {
        _S143 = run_2->first_crossing_0;
    }
    else
    {
        _S143 = run_2->last_crossing_0;
    }
    float _S144 = cell_4->half_width_1;
    float _S145 = - cell_4->half_width_1;
    bool _S146 = _S140 < _S145;
    bool _S147 = _S140 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S142 = !_S142;
    }
    else
    {
        _S142 = false;
    }
    if(_S142)
    {
        _S142 = !shown_2->hole_0;
    }
    else
    {
        _S142 = false;
    }
    bool _S148;
    if(_S142)
    {
        _S148 = shown_2->on_top_0;
    }
    else
    {
        _S148 = false;
    }
    if(_S148)
    {
        if(_S143)
        {
            _S143 = _S146;
        }
        else
        {
            _S143 = false;
        }
        _S143 = !_S143;
    }
    else
    {
        _S143 = false;
    }
    if(shown_2->hole_0)
    {
        _S142 = true;
    }
    else
    {
        if(_S142)
        {
            _S142 = !shown_2->on_top_0;
        }
        else
        {
            _S142 = false;
        }
    }
    float _S149;
    if(_S146)
    {
        _S149 = _S145;
    }
    else
    {
        _S149 = _S144;
    }
    float _S150 = _S149 - _S140;
    if(_S142)
    {
        _S140 = 2.0f * _S141 + _S140 - _S144;
    }
    else
    {
        _S140 = _S141;
    }
    if(_S143)
    {
        if(forwards_0)
        {
            _S140 = run_2->to_end_0;
        }
        else
        {
            _S140 = run_2->from_start_0;
        }
        return _S140;
    }
    if(_S147)
    {
    }
    else
    {
        _S140 = _S150;
    }
    return _S140;
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
    float _S151 = previous_1->rate_0;
    float _S152 = previous_1->rate_0 * step_4;
    float _S153 = rate_1 * step_4;
    bool _S154;
    if(!previous_1->known_0)
    {
        _S154 = true;
    }
    else
    {
        _S154 = here_0->hole_1;
    }
    if(_S154)
    {
        _S154 = true;
    }
    else
    {
        _S154 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S154)
    {
        _S154 = true;
    }
    else
    {
        _S154 = _S151 >= 0.0f;
    }
    if(_S154)
    {
        _S154 = true;
    }
    else
    {
        _S154 = rate_1 <= 0.0f;
    }
    if(_S154)
    {
        return -1.0f;
    }
    float _S155 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S152) >= 0.0f)
    {
        _S154 = (3.0f * clearance_1 - _S153) >= 0.0f;
    }
    else
    {
        _S154 = false;
    }
    if(_S154)
    {
        return -1.0f;
    }
    float _S156 = clearance_1 - _S155;
    float _S157 = 6.0f * _S156 - 4.0f * _S152 - 2.0f * _S153;
    float _S158 = -2.0f * _S152 / (F32_max((_S157 + (F32_sqrt(((F32_max((_S157 * _S157 - 4.0f * (3.0f * (_S152 + _S153 - 2.0f * _S156)) * _S152), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S159 = 1.0f - _S158;
    float _S160 = (_S155 * (2.0f * _S158 + 1.0f) + _S152 * _S158) * _S159 * _S159;
    float _S161 = (clearance_1 * (2.0f * _S159 + 1.0f) - _S153 * _S159) * _S158 * _S158;
    if(_S158 > 0.01999999955296516f)
    {
        _S154 = _S159 > 0.01999999955296516f;
    }
    else
    {
        _S154 = false;
    }
    if(_S154)
    {
        _S154 = (_S160 + _S161) < 0.0f;
    }
    else
    {
        _S154 = false;
    }
    float _S162;
    if(_S154)
    {
        _S162 = _S159 * step_4;
    }
    else
    {
        _S162 = -1.0f;
    }
    return _S162;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S163 = here_1->hole_1;
    float _S164;
    if(here_1->hole_1)
    {
        _S164 = 1.0e+09f;
    }
    else
    {
        _S164 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S164;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S165;
    if(!_S163)
    {
        _S165 = !is_cell_exit_0;
    }
    else
    {
        _S165 = false;
    }
    (&previous_2)->known_0 = _S165;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_0, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_0->per_x_0), (side_y_1 * this_0->per_y_0)))), (0.0f))) + this_0->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_1, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S166 = (F32_min((here_2->edge_x_0 * this_1->per_x_0), (here_2->edge_y_0 * this_1->per_y_0)));
    bool _S167;
    if(!here_2->hole_1)
    {
        _S167 = (rate_3 * _S166 + clearance_3) < 0.0f;
    }
    else
    {
        _S167 = false;
    }
    if(_S167)
    {
        _S167 = _S166 > (2.0f * this_1->epsilon_0);
    }
    else
    {
        _S167 = false;
    }
    float _S168 = this_1->step_2;
    float _S169;
    if(_S167)
    {
        _S169 = _S166 - this_1->epsilon_0;
    }
    else
    {
        _S169 = (F32_max((_S166), (0.0f))) + this_1->epsilon_0;
    }
    return (F32_min((_S168), (_S169)));
}

struct ViewRay_0
{
    float2  origin_0;
    float2  slope_1;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_2, float height_3)
{
    return this_2->origin_0 + this_2->slope_1 * make_float2 (height_3);
}

__device__ float ViewRay_rate_0(ViewRay_0 * this_3, Probe_0 * here_3)
{
    return here_3->slope_x_0 * this_3->slope_1.x + here_3->slope_y_0 * this_3->slope_1.y - 1.0f;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S170 = end_0 - start_1;
    float _S171 = start_rate_0 + end_rate_0 - 2.0f * _S170;
    float _S172 = 3.0f * _S170 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S170), (9.99999968265522539e-21f)));
    int i_4 = int(0);
    for(;;)
    {
        if(uint(i_4) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S173 = clamp_0(share_1 - (((_S171 * share_1 + _S172) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S171 * share_1 + 2.0f * _S172) * share_1 + start_rate_0), (0.10000000149011612f * _S170 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S174 = i_4 + int(1);
        share_1 = _S173;
        i_4 = _S174;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S175 = along_slope_0 * along_slope_0 + 1.0f;
    float _S176 = (F32_rsqrt((_S175)));
    float _S177 = sine_1 * _S176 * (F32_rsqrt((_S175 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S177 * _S175, _S177 * across_slope_0 * along_slope_0 + cosine_0 * _S176);
}

__device__ float arc_sine_0(float x_13)
{
    float _S178 = (F32_abs((x_13)));
    bool _S179 = _S178 > 0.5f;
    float _S180;
    if(_S179)
    {
        _S180 = 0.5f * (1.0f - _S178);
    }
    else
    {
        _S180 = _S178 * _S178;
    }
    float _S181;
    if(_S179)
    {
        _S181 = (F32_sqrt(((F32_max((_S180), (0.0f))))));
    }
    else
    {
        _S181 = _S178;
    }
    float _S182 = ((((0.04216320067644119f * _S180 + 0.02418131195008755f) * _S180 + 0.04547002539038658f) * _S180 + 0.07495300471782684f) * _S180 + 0.16666752099990845f) * _S180 * _S181 + _S181;
    if(_S179)
    {
        _S180 = 1.57079637050628662f - 2.0f * _S182;
    }
    else
    {
        _S180 = _S182;
    }
    if(x_13 < 0.0f)
    {
        _S180 = - _S180;
    }
    return _S180;
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

__device__ Albedos_0 albedos_of_0(uint family_8, uint thread_6)
{
    Family_0 _S183 = slang_ldg_1((&(globalParams_0->families_0)[family_8]));
    Family_0 _S184 = slang_ldg_1((&(globalParams_0->families_0)[family_8]));
    return table_albedos_0(_S183.albedo_table_0 + _S184.albedo_stride_0 * thread_6);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S185 = value_0 * 747796405U + 2891336453U;
    uint _S186 = ((_S185 >> ((_S185 >> int(28)) + 4U)) ^ _S185) * 277803737U;
    return (_S186 >> int(22)) ^ _S186;
}

__device__ float uniform_hash_0(uint thread_7, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_7 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_1, float3  room_0)
{
    float3  _S187 = room_0 / max_0(albedo_1, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S187.x), (_S187.y)))), (_S187.z)))), (0.0f))))));
}

__device__ float natural_logarithm_0(float x_14)
{
    uint _S188 = (F32_asuint((x_14)));
    float exponent_0 = float(int(_S188 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S188 & 8388607U) | 1056964608U)));
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
    float _S189 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S189 - exponent_1 * 0.00021219444170129f - 0.5f * _S189) + exponent_1 * 0.693359375f;
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
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
    float3  _S190 = make_float3 (1.0f - open_of_other_0) * passed_0;
    FaceRadiance_0 found_0;
    float3  _S191 = sends_0->sky_warp_0 + _S190 * sends_0->crossing_warp_0;
    (&found_0)->warp_2 = _S191;
    float3  _S192 = sends_0->sky_weft_0 + _S190 * sends_0->crossing_weft_0;
    (&found_0)->weft_2 = _S192;
    (&found_0)->mean_0 = make_float3 (sends_0->blocks_warp_0) * _S191 + make_float3 (sends_0->blocks_weft_0) * _S192;
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

__device__ Bounced_0 bounced_by_0(Blocked_0 * blocked_0, Scattered_0 * yarn_2, Interior_0 * interior_0)
{
    float3  _S193 = make_float3 (blocked_0->by_warp_0 + blocked_0->by_weft_0) * interior_0->leaked_1;
    float3  _S194 = make_float3 (blocked_0->far_0) * yarn_2->through_0;
    Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_4 * (make_float3 (blocked_0->by_warp_0) * interior_0->warp_3 + make_float3 (blocked_0->by_weft_0) * interior_0->weft_3) + _S194 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S194 * interior_0->far_1 + yarn_2->back_4 * _S193;
    return bounced_0;
}

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_0, float blend_0)
{
    float _S195 = light_0.z;
    if(_S195 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S195), (0.0f))), (F32_max((dot_0(light_0, normal_0)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_0, float roughness_1)
{
    float _S196 = dot_0(direction_2, tangent_0);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S196 * _S196 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_15)
{
    float _S197 = clamp_0(x_15, -87.0f, 88.0f);
    float _S198 = (F32_floor((_S197 * 1.4426950216293335f + 0.5f)));
    float _S199 = _S197 - _S198 * 0.693359375f + _S198 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S199 + 0.00139819993637502f) * _S199 + 0.00833345204591751f) * _S199 + 0.04166579619050026f) * _S199 + 0.1666666567325592f) * _S199 + 0.5f;
    float _S200 = (U32_asfloat((uint(int(_S198) + int(127)) << int(23))));
    float _S201;
    if(x_15 < -87.0f)
    {
        _S201 = 0.0f;
    }
    else
    {
        _S201 = (p_0 * _S199 * _S199 + _S199 + 1.0f) * _S200;
    }
    return _S201;
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
    float _S202 = roughness_2 * roughness_2;
    float _S203 = squared_along_0 * (1.0f - _S202) + _S202;
    return 0.31830987334251404f * _S202 * roughness_2 / (_S203 * _S203);
}

__device__ float density_between_0(float3  light_1, float3  view_0, float3  tangent_1, float roughness_3)
{
    float3  _S204 = light_1 + view_0;
    float _S205 = dot_0(_S204, tangent_1);
    return flake_density_0((F32_min((_S205 * _S205 / (F32_max((square_1(_S204)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_2, float3  view_1, float3  normal_1, float3  tangent_2, float roughness_4, float optical_depth_1)
{
    float _S206 = dot_0(light_2, normal_1);
    bool _S207;
    if(_S206 <= 0.0f)
    {
        _S207 = true;
    }
    else
    {
        _S207 = (dot_0(view_1, normal_1)) <= 0.0f;
    }
    if(_S207)
    {
        return 0.0f;
    }
    float _S208 = (F32_max((_S206), (9.99999997475242708e-07f)));
    float _S209 = (F32_max((dot_0(view_1, normal_1)), (9.99999997475242708e-07f)));
    float _S210 = projected_area_1(light_2, tangent_2, roughness_4) * _S209 + projected_area_1(view_1, tangent_2, roughness_4) * _S208;
    float _S211 = optical_depth_1 * _S210 / (_S208 * _S209);
    return 0.25f * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S211 * mean_attenuation_0(_S211)) * _S208 / _S210;
}

__device__ float transmission_1(float3  light_3, float3  view_2, float3  normal_2, float3  tangent_3, float roughness_5, float optical_depth_2)
{
    float _S212 = - dot_0(light_3, normal_2);
    float _S213 = dot_0(view_2, normal_2);
    bool _S214;
    if(_S212 <= 0.0f)
    {
        _S214 = true;
    }
    else
    {
        _S214 = _S213 <= 0.0f;
    }
    if(_S214)
    {
        return 0.0f;
    }
    float _S215 = 1.0f / (F32_max((_S213), (9.99999997475242708e-07f)));
    float _S216 = projected_area_1(light_3, tangent_3, roughness_5) / (F32_max((_S212), (9.99999997475242708e-07f)));
    float _S217 = projected_area_1(view_2, tangent_3, roughness_5) * _S215;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S216), (_S217)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S216 - _S217)))) * _S215;
}

__device__ float sheen_scale_0(float x_16, float y_8)
{
    return (((((0.0f * x_16 + (((((-1.1402510404586792f * y_8 + 0.40672621130943298f) * y_8 + 1.65398800373077393f) * y_8 + -1.29730904102325439f) * y_8 + 0.30570998787879944f) * y_8 + -0.0220868494361639f)) * x_16 + (((((-0.21142719686031342f * y_8 + 1.05947399139404297f) * y_8 + -0.41116121411323547f) * y_8 + -0.93859231472015381f) * y_8 + 0.51606941223144531f) * y_8 + 0.05409301072359085f)) * x_16 + (((((1.22944498062133789f * y_8 + -0.45962560176849365f) * y_8 + -1.63861405849456787f) * y_8 + 1.33565104007720947f) * y_8 + -0.45725581049919128f) * y_8 + 0.08243165910243988f)) * x_16 + (((((0.39779931306838989f * y_8 + -1.18879103660583496f) * y_8 + 0.28251591324806213f) * y_8 + 1.168984055519104f) * y_8 + -0.76864629983901978f) * y_8 + 0.0091691892594099f)) * x_16 + (((((-0.26563560962677002f * y_8 + -0.19379159808158875f) * y_8 + 0.2677634060382843f) * y_8 + 0.00270519289188087f) * y_8 + 0.14349560439586639f) * y_8 + 0.10290180146694183f)) * x_16 + (((((-0.20701569318771362f * y_8 + 0.24526430666446686f) * y_8 + 0.19551840424537659f) * y_8 + 0.07586126774549484f) * y_8 + 0.38894739747047424f) * y_8 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_17, float y_9)
{
    return ((((0.0f * x_17 + (((((-0.10608240216970444f * y_9 + 1.99214303493499756f) * y_9 + -1.42255294322967529f) * y_9 + -1.09495604038238525f) * y_9 + 0.59180057048797607f) * y_9 + 0.06902855634689331f)) * x_17 + (((((-0.46220690011978149f * y_9 + -0.29113379120826721f) * y_9 + 1.39025199413299561f) * y_9 + 0.35589990019798279f) * y_9 + -1.17120099067687988f) * y_9 + 0.15940259397029877f)) * x_17 + (((((2.26068711280822754f * y_9 + -3.64728999137878418f) * y_9 + -0.72173482179641724f) * y_9 + 3.07659196853637695f) * y_9 + -0.6827620267868042f) * y_9 + -0.3039557933807373f)) * x_17 + (((((0.81201767921447754f * y_9 + 0.36014080047607422f) * y_9 + -1.72646903991699219f) * y_9 + -0.22630110383033752f) * y_9 + 0.89514690637588501f) * y_9 + -0.10397960245609283f)) * x_17 + (((((-0.37648698687553406f * y_9 + 1.10974001884460449f) * y_9 + 0.17824520170688629f) * y_9 + -1.04968702793121338f) * y_9 + 0.1461234986782074f) * y_9 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_18, float y_10)
{
    return ((((0.0f * x_18 + (((((12.95646953582763672f * y_10 + -21.38032913208007812f) * y_10 + -7.37853097915649414f) * y_10 + 34.55607986450195312f) * y_10 + -23.61347007751464844f) * y_10 + 5.00126314163208008f)) * x_18 + (((((10.91487026214599609f * y_10 + -6.08202791213989258f) * y_10 + -38.2036285400390625f) * y_10 + 53.3440399169921875f) * y_10 + -21.91996002197265625f) * y_10 + 2.01606011390686035f)) * x_18 + (((((-14.52206039428710938f * y_10 + 36.803619384765625f) * y_10 + -22.94047927856445312f) * y_10 + -10.07973003387451172f) * y_10 + 15.77003955841064453f) * y_10 + -4.92722177505493164f)) * x_18 + (((((-7.62505722045898438f * y_10 + 1.27310299873352051f) * y_10 + 31.19523048400878906f) * y_10 + -44.39989852905273438f) * y_10 + 26.44947052001953125f) * y_10 + -8.73507976531982422f)) * x_18 + (((((5.65633487701416016f * y_10 + -17.66820907592773438f) * y_10 + 24.65356063842773438f) * y_10 + -19.38941001892089844f) * y_10 + 11.06159019470214844f) * y_10 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S218 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S219 = 2.0f * (F32_sqrt((_S218))) - 1.0f;
    float _S220 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S219, _S220), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S218) * sheen_shear_0(_S219, _S220), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S219, _S220), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_4, float3  view_3, float scale_0, float shear_0)
{
    float _S221 = light_4.z;
    bool _S222;
    if(_S221 <= 0.0f)
    {
        _S222 = true;
    }
    else
    {
        _S222 = (view_3.z) <= 0.0f;
    }
    if(_S222)
    {
        return 0.0f;
    }
    float2  _S223 = float2 {view_3.x, view_3.y};
    float _S224 = dot_1(_S223, _S223);
    float2  _S225;
    if(_S224 > 9.99999968265522539e-21f)
    {
        _S225 = _S223 * make_float2 ((F32_rsqrt((_S224))));
    }
    else
    {
        _S225 = make_float2 (1.0f, 0.0f);
    }
    float _S226 = scale_0 * dot_1(float2 {light_4.x, light_4.y}, _S225) + shear_0 * _S221;
    float _S227 = scale_0 * (light_4.y * _S225.x - light_4.x * _S225.y);
    float _S228 = _S226 * _S226 + _S227 * _S227 + _S221 * _S221;
    return 0.31830987334251404f * scale_0 * scale_0 * _S221 / (F32_max((_S228 * _S228), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_5, float3  view_4, float strength_0, float roughness_7)
{
    float3  _S229 = sheen_lobe_0(view_4.z, roughness_7);
    float _S230 = strength_0 * _S229.z;
    return make_float2 (_S230 * transformed_cosine_0(light_5, view_4, _S229.x, _S229.y), 1.0f - _S230);
}

__device__ float3  bounced_value_0(Bounced_0 * bounced_1, float3  light_6, float3  view_5)
{
    float _S231 = light_6.z;
    float3  _S232;
    if((_S231 * view_5.z) < 0.0f)
    {
        _S232 = bounced_1->transmitted_0;
    }
    else
    {
        _S232 = bounced_1->reflected_0;
    }
    return _S232 * make_float3 ((F32_abs((_S231))) * 0.31830987334251404f);
}

struct YarnPoint_0
{
    bool back_5;
    bool hole_2;
    bool is_warp_1;
    float x_19;
    float y_11;
    float height_4;
    float3  normal_3;
    float3  tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_20;
    float y_12;
    bool hole_3;
    float height_5;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_6;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

__device__ Crossing_0 crossing_at_0(uint _S233, float _S234, float _S235, bool _S236)
{
    Fabric_0 * _S237 = (&(globalParams_0->fabrics_0)[_S233]);
    Crossing_0 crossing_2;
    uint _S238 = __ldg(&_S237->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S238, _S234);
    uint _S239 = __ldg(&_S237->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S239, _S235);
    uint _S240 = __ldg(&_S237->run_words_0);
    uint _S241 = (&(&crossing_2)->weft_1)->thread_0;
    uint _S242 = __ldg(&_S237->ends_1);
    uint _S243 = _S240 + 2U * (_S241 * _S242 + (&(&crossing_2)->warp_1)->thread_0);
    uint _S244 = __ldg((&(globalParams_0->words_0)[_S243]));
    (&crossing_2)->warp_word_0 = _S244;
    uint _S245 = __ldg((&(globalParams_0->words_0)[_S243 + 1U]));
    (&crossing_2)->weft_word_0 = _S245;
    (&crossing_2)->warp_above_0 = ((_S244 & 1U) == 1U) != _S236;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S246, float _S247, float _S248, bool _S249)
{
    Fabric_0 * _S250 = (&(globalParams_0->fabrics_0)[_S246]);
    Sample_0 sample_0;
    Crossing_0 _S251 = crossing_at_0(_S246, _S247, _S248, _S249);
    (&sample_0)->crossing_1 = _S251;
    Crossing_0 _S252 = _S251;
    Shown_0 _S253 = shown_at_0(&_S252, _S249);
    (&sample_0)->shown_3 = _S253;
    uint _S254;
    if(_S253.is_warp_0)
    {
        uint _S255 = __ldg(&_S250->warp_0);
        _S254 = _S255;
    }
    else
    {
        uint _S256 = __ldg(&_S250->weft_0);
        _S254 = _S256;
    }
    uint _S257;
    if(_S253.is_warp_0)
    {
        uint _S258 = __ldg(&_S250->weft_0);
        _S257 = _S258;
    }
    else
    {
        uint _S259 = __ldg(&_S250->warp_0);
        _S257 = _S259;
    }
    Cell_0 _S260 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S261 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S262 = select_cell_0(_S253.is_warp_0, &_S260, &_S261);
    Cell_0 _S263 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S264 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S265 = select_cell_0(_S253.is_warp_0, &_S263, &_S264);
    Cell_0 _S266 = _S265;
    Run_0 _S267 = unpack_0(_S254, _S257, _S262.thread_0, &_S266, _S253.word_0);
    Cell_0 _S268 = _S262;
    Section_0 _S269 = section_at_0(&_S268);
    bool _S270;
    if(_S253.on_top_0)
    {
        _S270 = (_S267.distance_0) < (_S269.drop_0 * _S267.bend_1.sine_0);
    }
    else
    {
        _S270 = false;
    }
    bool _S271;
    if(_S253.on_top_0)
    {
        _S271 = !_S270;
    }
    else
    {
        _S271 = false;
    }
    float _S272;
    if(_S271)
    {
        _S272 = 1.0f;
    }
    else
    {
        _S272 = -1.0f;
    }
    float _S273;
    if(_S270)
    {
        _S273 = _S267.other_reach_0;
    }
    else
    {
        _S273 = _S267.reach_0;
    }
    float _S274;
    if(_S270)
    {
        _S274 = _S273 + _S267.distance_0;
    }
    else
    {
        _S274 = (F32_max((_S273 - _S267.distance_0), (0.0f)));
    }
    float _S275 = _S273 / _S267.bend_1.sine_0 - _S272 * _S269.drop_0;
    float _S276 = _S274 * _S274;
    float _S277 = (F32_max((_S275 * _S275 - _S276), (9.99999968265522539e-21f)));
    float _S278 = (F32_rsqrt((_S277)));
    float _S279 = _S276 / (_S277 * _S278 + _S275);
    bool _S280 = _S274 > 0.0f;
    float _S281;
    if(_S253.on_top_0)
    {
        _S281 = 1.0f;
    }
    else
    {
        _S281 = -1.0f;
    }
    float _S282;
    if(_S267.near_start_0)
    {
        _S282 = 1.0f;
    }
    else
    {
        _S282 = -1.0f;
    }
    float _S283 = _S281 * _S282;
    if(_S280)
    {
        _S281 = _S275 * _S278;
    }
    else
    {
        _S281 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S269.slope_0 * _S281;
    if(_S280)
    {
        _S274 = _S283 * _S274 * _S278;
    }
    else
    {
        _S274 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S274;
    Family_0 _S284 = slang_ldg_1((&(globalParams_0->families_0)[_S254]));
    Shown_0 _S285 = _S253;
    Run_0 _S286 = _S267;
    Cell_0 _S287 = _S265;
    float2  _S288 = dive_0(_S257, &_S285, &_S286, &_S287);
    if(_S267.straight_0)
    {
        _S272 = 0.0f;
    }
    else
    {
        _S272 = _S284.height_scale_0 * _S272;
    }
    (&sample_0)->height_6 = _S272 * (_S273 * _S267.bend_1.half_tangent_0 - _S279) - _S284.height_scale_0 * _S269.drop_0 - _S288.x;
    float _S289 = _S284.height_scale_0 * (&sample_0)->slope_across_0;
    float _S290 = _S284.height_scale_0 * (&sample_0)->slope_along_0 - _S288.y;
    if(_S253.is_warp_0)
    {
        _S272 = _S289;
    }
    else
    {
        _S272 = _S290;
    }
    (&sample_0)->slope_x_1 = _S272;
    if(_S253.is_warp_0)
    {
        _S272 = _S290;
    }
    else
    {
        _S272 = _S289;
    }
    (&sample_0)->slope_y_1 = _S272;
    (&sample_0)->run_3 = _S267;
    (&sample_0)->section_1 = _S269;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S291, SearchQuality_0 * _S292, float3  _S293)
{
    Fabric_0 * _S294 = (&(globalParams_0->fabrics_0)[_S291]);
    float _S295 = (F32_abs((_S293.x)));
    float _S296 = __ldg(&_S294->threads_per_x_0);
    float _S297 = _S295 * _S296;
    float _S298 = (F32_abs((_S293.y)));
    float _S299 = __ldg(&_S294->threads_per_y_0);
    float _S300 = (F32_max((_S297), (_S298 * _S299))) * _S292->steps_per_thread_0;
    float _S301 = (F32_abs((_S293.z)));
    float _S302 = __ldg(&_S294->per_relief_0);
    return (F32_max((_S300), (_S301 * _S302 * _S292->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S303, Crossing_0 * _S304)
{
    Fabric_0 * _S305 = (&(globalParams_0->fabrics_0)[_S303]);
    bool _S306 = _S304->warp_above_0;
    uint _S307;
    if(_S304->warp_above_0)
    {
        uint _S308 = __ldg(&_S305->warp_0);
        _S307 = _S308;
    }
    else
    {
        uint _S309 = __ldg(&_S305->weft_0);
        _S307 = _S309;
    }
    uint _S310;
    if(_S306)
    {
        _S310 = _S304->warp_word_0;
    }
    else
    {
        _S310 = _S304->weft_word_0;
    }
    float _S311 = float(_S310 >> int(28));
    Family_0 _S312 = slang_ldg_1((&(globalParams_0->families_0)[_S307]));
    float _S313 = _S311 * _S312.height_scale_0;
    Family_0 _S314 = slang_ldg_1((&(globalParams_0->families_0)[_S307]));
    return _S313 * _S314.level_0;
}

__device__ Probe_0 probe_0(uint _S315, float _S316, float _S317, bool _S318, bool _S319, bool _S320)
{
    Sample_0 _S321 = sample_at_0(_S315, _S316, _S317, _S318);
    Probe_0 probe_1;
    (&probe_1)->height_2 = _S321.height_6;
    (&probe_1)->hole_1 = _S321.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S321.slope_x_1;
    (&probe_1)->slope_y_0 = _S321.slope_y_1;
    uint _S322;
    if(_S321.shown_3.is_warp_0)
    {
        _S322 = _S321.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S322 = _S321.crossing_1.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S322;
    Crossing_0 _S323 = _S321.crossing_1;
    float _S324 = cell_maximum_0(_S315, &_S323);
    (&probe_1)->cell_max_0 = _S324;
    float _S325;
    if(_S319)
    {
        _S325 = _S321.crossing_1.warp_1.above_0;
    }
    else
    {
        _S325 = _S321.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S325;
    if(_S320)
    {
        _S325 = _S321.crossing_1.weft_1.above_0;
    }
    else
    {
        _S325 = _S321.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S325;
    bool _S326 = !_S321.shown_3.is_warp_0;
    Cell_0 _S327 = _S321.crossing_1.warp_1;
    Shown_0 _S328 = _S321.shown_3;
    Run_0 _S329 = _S321.run_3;
    float _S330 = outline_distance_0(&_S327, &_S328, &_S329, _S326, _S319);
    (&probe_1)->edge_x_0 = _S330;
    Cell_0 _S331 = _S321.crossing_1.weft_1;
    Shown_0 _S332 = _S321.shown_3;
    Run_0 _S333 = _S321.run_3;
    float _S334 = outline_distance_0(&_S331, &_S332, &_S333, _S321.shown_3.is_warp_0, _S320);
    (&probe_1)->edge_y_0 = _S334;
    return probe_1;
}

__device__ bool is_free_0(uint _S335, SearchQuality_0 * _S336, float3  _S337, float3  _S338, bool _S339, float _S340)
{
    float _S341 = _S338.z;
    if(_S341 <= 0.0f)
    {
        return false;
    }
    float _S342 = _S336->shadow_share_0;
    float _S343 = steps_per_length_0(_S335, _S336, _S338);
    float _S344 = 1.0f / (F32_max((_S342 * _S343), (9.99999971718068537e-10f)));
    StepControl_0 _S345 = step_control_0(float2 {_S338.x, _S338.y}, _S344);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S346;
        if(count_1 < 1024U)
        {
            _S346 = (_S337.z + _S341 * distance_1) < _S340;
        }
        else
        {
            _S346 = false;
        }
        if(_S346)
        {
        }
        else
        {
            break;
        }
        float3  _S347 = _S337 + _S338 * make_float3 (distance_1);
        Probe_0 _S348 = probe_0(_S335, _S347.x, _S347.y, _S339, _S345.right_0, _S345.up_0);
        float _S349 = _S347.z;
        float _S350 = _S349 - _S348.height_2;
        float _S351 = _S341 - _S348.slope_x_0 * _S338.x - _S348.slope_y_0 * _S338.y;
        bool _S352;
        if(!_S348.hole_1)
        {
            _S352 = _S350 < 0.0f;
        }
        else
        {
            _S352 = false;
        }
        if(_S352)
        {
            return false;
        }
        PreviousSample_0 _S353 = previous_3;
        Probe_0 _S354 = _S348;
        float _S355 = way_back_to_dip_0(&_S353, _S350, _S351, last_step_0, &_S354);
        if(_S355 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S355;
            distance_1 = distance_1 - _S355;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S356 = _S349 > (_S348.cell_max_0);
        Probe_0 _S357 = _S348;
        PreviousSample_0 _S358 = after_sample_0(_S350, _S351, &_S357, _S356);
        float last_step_2;
        if(_S356)
        {
            StepControl_0 _S359 = _S345;
            float _S360 = StepControl_to_cell_exit_0(&_S359, _S348.side_x_0, _S348.side_y_0);
            last_step_2 = (F32_max((_S360), (_S344)));
        }
        else
        {
            StepControl_0 _S361 = _S345;
            Probe_0 _S362 = _S348;
            float _S363 = StepControl_to_next_sample_0(&_S361, &_S362, _S350, _S351);
            last_step_2 = _S363;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S358;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S364, SearchQuality_0 * _S365, float _S366, float _S367, float3  _S368, bool _S369)
{
    Fabric_0 * _S370 = (&(globalParams_0->fabrics_0)[_S364]);
    Sample_0 _S371 = sample_at_0(_S364, _S366, _S367, _S369);
    if(!_S371.shown_3.hole_0)
    {
        return false;
    }
    float3  _S372 = make_float3 (_S366, _S367, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S373;
        if(side_0 < 2U)
        {
            _S373 = passes_0;
        }
        else
        {
            _S373 = false;
        }
        if(_S373)
        {
        }
        else
        {
            break;
        }
        float3  _S374;
        if(side_0 == 0U)
        {
            _S374 = _S368;
        }
        else
        {
            _S374 = make_float3 (- _S368.x, - _S368.y, _S368.z);
        }
        bool _S375 = _S369 != (side_0 == 1U);
        float _S376 = __ldg(&_S370->height_high_0);
        bool _S377 = is_free_0(_S364, _S365, _S372, _S374, _S375, _S376);
        uint _S378 = side_0 + 1U;
        passes_0 = _S377;
        side_0 = _S378;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_7;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

__device__ float max_height_along_0(uint _S379, float _S380, float _S381, float _S382, float3  _S383, bool _S384)
{
    Fabric_0 * _S385 = (&(globalParams_0->fabrics_0)[_S379]);
    uint _S386 = __ldg(&_S385->warp_0);
    uint _S387 = locate_0(_S386, _S380).thread_0 / 2U;
    uint _S388 = __ldg(&_S385->weft_0);
    uint _S389 = locate_0(_S388, _S381).thread_0 / 2U;
    float _S390 = _S383.x;
    uint _S391;
    if(_S390 > 0.0f)
    {
        _S391 = 1U;
    }
    else
    {
        _S391 = 0U;
    }
    float _S392 = _S383.y;
    uint _S393;
    if(_S392 > 0.0f)
    {
        _S393 = 2U;
    }
    else
    {
        _S393 = 0U;
    }
    uint _S394 = _S391 + _S393;
    uint _S395 = __ldg(&_S385->max_heights_0);
    uint _S396 = __ldg(&_S385->max_height_columns_0);
    uint _S397 = __ldg((&(globalParams_0->words_0)[_S395 + 4U * (_S389 * _S396 + _S387) + _S394]));
    int number_0;
    if(_S384)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S398 = _S397 >> number_0;
    float _S399 = (F32_abs((_S390)));
    float _S400 = __ldg(&_S385->threads_per_x_0);
    float _S401 = _S399 * _S400;
    float _S402 = (F32_abs((_S392)));
    float _S403 = __ldg(&_S385->threads_per_y_0);
    float _S404 = (F32_max((_S401), (_S402 * _S403))) / _S383.z;
    float _S405 = __ldg(&_S385->height_high_0);
    float max_height_0 = _S405;
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
        if(((max_height_0 - _S382) * _S404) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S398 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S405)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S406, float _S407, float _S408, bool _S409, bool _S410, bool _S411)
{
    Crossing_0 _S412 = crossing_at_0(_S406, _S407, _S408, _S409);
    Crossing_0 _S413 = _S412;
    float _S414 = cell_maximum_0(_S406, &_S413);
    float _S415;
    if(_S410)
    {
        _S415 = _S412.warp_1.above_0;
    }
    else
    {
        _S415 = _S412.warp_1.below_0;
    }
    float _S416;
    if(_S411)
    {
        _S416 = _S412.weft_1.above_0;
    }
    else
    {
        _S416 = _S412.weft_1.below_0;
    }
    return make_float3 (_S414, _S415, _S416);
}

__device__ float first_sample_height_0(uint _S417, ViewRay_0 * _S418, StepControl_0 * _S419, bool _S420)
{
    float _S421 = max_height_along_0(_S417, _S418->origin_0.x, _S418->origin_0.y, 0.0f, make_float3 (_S418->slope_1.x, _S418->slope_1.y, 1.0f), _S420);
    uint count_2 = 0U;
    float height_8 = _S421;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S422 = ViewRay_at_0(_S418, height_8);
        float3  _S423 = cell_bounds_0(_S417, _S422.x, _S422.y, _S420, _S419->right_0, _S419->up_0);
        float _S424 = height_8 - _S423.x;
        float _S425 = StepControl_to_cell_exit_0(_S419, _S423.y, _S423.z);
        float height_9 = height_8 - clamp_0(_S424, 0.0f, _S425);
        if(_S424 <= _S425)
        {
            height_8 = height_9;
            break;
        }
        count_2 = count_2 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

__device__ ViewRayEnd_0 search_down_0(uint _S426, ViewRay_0 * _S427, StepControl_0 * _S428, bool _S429)
{
    Fabric_0 * _S430 = (&(globalParams_0->fabrics_0)[_S426]);
    float _S431 = __ldg(&_S430->height_low_0);
    float _S432 = __ldg(&_S430->height_high_0);
    float _S433 = _S431 - (_S432 - _S431);
    ViewRayEnd_0 end_1;
    float _S434 = first_sample_height_0(_S426, _S427, _S428, _S429);
    (&end_1)->height_7 = _S434;
    (&end_1)->last_step_3 = _S428->epsilon_0;
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
        float2  _S435 = ViewRay_at_0(_S427, (&end_1)->height_7);
        Probe_0 _S436 = probe_0(_S426, _S435.x, _S435.y, _S429, _S428->right_0, _S428->up_0);
        float _S437 = (&end_1)->height_7 - _S436.height_2;
        Probe_0 _S438 = _S436;
        float _S439 = ViewRay_rate_0(_S427, &_S438);
        (&end_1)->depth_1 = - _S437;
        (&end_1)->rate_4 = _S439;
        bool _S440;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S440 = !_S436.hole_1;
        }
        else
        {
            _S440 = false;
        }
        bool _S441;
        if(_S440)
        {
            _S441 = ((&(&end_1)->previous_4)->yarn_0) == (_S436.yarn_1);
        }
        else
        {
            _S441 = false;
        }
        (&end_1)->smooth_0 = _S441;
        bool _S442;
        if(!_S436.hole_1)
        {
            _S442 = _S437 <= 0.0f;
        }
        else
        {
            _S442 = false;
        }
        bool _S443;
        if(_S442)
        {
            _S443 = true;
        }
        else
        {
            _S443 = ((&end_1)->height_7) <= _S433;
        }
        if(_S443)
        {
            break;
        }
        PreviousSample_0 _S444 = (&end_1)->previous_4;
        Probe_0 _S445 = _S436;
        float _S446 = way_back_to_dip_0(&_S444, _S437, _S439, (&end_1)->last_step_3, &_S445);
        if(_S446 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S446;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S446;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S447 = StepControl_to_cell_exit_0(_S428, _S436.side_x_0, _S436.side_y_0);
        float _S448 = (F32_min((_S447), ((&end_1)->height_7 - _S436.cell_max_0)));
        Probe_0 _S449 = _S436;
        float _S450 = StepControl_to_next_sample_0(_S428, &_S449, _S437, _S439);
        bool _S451 = _S448 > _S450;
        Probe_0 _S452 = _S436;
        PreviousSample_0 _S453 = after_sample_0(_S437, _S439, &_S452, _S451);
        (&end_1)->previous_4 = _S453;
        float _S454 = (F32_max((_S448), (_S450)));
        (&end_1)->last_step_3 = _S454;
        (&end_1)->height_7 = (&end_1)->height_7 - _S454;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S455, ViewRay_0 * _S456, StepControl_0 * _S457, bool _S458, ViewRayEnd_0 * _S459, uint _S460)
{
    Fabric_0 * _S461 = (&(globalParams_0->fabrics_0)[_S455]);
    float _S462 = __ldg(&_S461->height_high_0);
    float _S463 = __ldg(&_S461->height_low_0);
    float _S464 = _S462 - _S463;
    float _S465 = _S459->height_7;
    float _S466 = _S459->last_step_3;
    float above_2 = _S459->height_7 + _S459->last_step_3;
    float above_gap_1 = clamp_0((&_S459->previous_4)->clearance_0, 0.0f, _S464);
    float under_gap_1 = clamp_0(_S459->depth_1, 0.0f, _S464);
    float _S467 = cubic_root_0(above_gap_1, - under_gap_1, (&_S459->previous_4)->rate_0 * _S459->last_step_3, _S459->rate_4 * _S459->last_step_3);
    bool _S468 = _S459->smooth_0;
    float middle_0;
    if(_S459->smooth_0)
    {
        middle_0 = above_2 - _S467 * _S466;
    }
    else
    {
        middle_0 = between_0(above_2, _S465, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S465;
    float above_3 = above_2;
    uint i_5 = 0U;
    for(;;)
    {
        if(i_5 < _S460)
        {
        }
        else
        {
            break;
        }
        float2  _S469 = ViewRay_at_0(_S456, middle_0);
        Probe_0 _S470 = probe_0(_S455, _S469.x, _S469.y, _S458, _S457->right_0, _S457->up_0);
        float _S471;
        if(_S470.hole_1)
        {
            _S471 = -1.0e+09f;
        }
        else
        {
            _S471 = _S470.height_2;
        }
        float _S472 = clamp_0(middle_0 - _S471, - _S464, _S464);
        float _S473;
        if(_S472 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S473 = 0.5f * above_gap_2;
            }
            else
            {
                _S473 = above_gap_2;
            }
            float _S474 = - _S472;
            under_1 = middle_0;
            above_gap_2 = _S473;
            under_gap_2 = _S474;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S473 = 0.5f * under_gap_2;
            }
            else
            {
                _S473 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S472;
            under_gap_2 = _S473;
            side_1 = -1.0f;
        }
        if(_S468)
        {
            Probe_0 _S475 = _S470;
            float _S476 = ViewRay_rate_0(_S456, &_S475);
            middle_0 = clamp_0(middle_0 + _S472 / (F32_min((_S476), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_5 = i_5 + 1U;
    }
    if(_S468)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S477, SearchQuality_0 * _S478, float _S479, float _S480, float3  _S481, bool _S482)
{
    float _S483 = (F32_max((_S481.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S479, _S480);
    float2  _S484 = float2 {_S481.x, _S481.y} / make_float2 (_S483);
    (&ray_0)->slope_1 = _S484;
    float2  _S485 = - _S484;
    float _S486 = steps_per_length_0(_S477, _S478, _S481);
    StepControl_0 _S487 = step_control_0(_S485, 1.0f / (F32_max((_S486 / _S483), (9.99999971718068537e-10f))));
    ViewRay_0 _S488 = ray_0;
    StepControl_0 _S489 = _S487;
    ViewRayEnd_0 _S490 = search_down_0(_S477, &_S488, &_S489, _S482);
    Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    ViewRay_0 _S491 = ray_0;
    StepControl_0 _S492 = _S487;
    ViewRayEnd_0 _S493 = _S490;
    float _S494 = refined_height_0(_S477, &_S491, &_S492, _S482, &_S493, _S478->refinements_0);
    (&hit_0)->height_5 = _S494;
    ViewRay_0 _S495 = ray_0;
    float2  _S496 = ViewRay_at_0(&_S495, _S494);
    (&hit_0)->x_20 = _S496.x;
    (&hit_0)->y_12 = _S496.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S497, SearchQuality_0 * _S498, float _S499, float _S500, float3  _S501, bool _S502)
{
    bool _S503 = passes_through_0(_S497, _S498, _S499, _S500, _S501, _S502);
    if(!_S503)
    {
        Hit_0 _S504 = first_hit_of_yarn_0(_S497, _S498, _S499, _S500, _S501, _S502);
        return _S504;
    }
    Hit_0 hit_1;
    (&hit_1)->x_20 = _S499;
    (&hit_1)->y_12 = _S500;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_2;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_10;
    float3  normal_4;
    float3  tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 surface_at_0(uint _S505, float _S506, float _S507, bool _S508)
{
    Fabric_0 * _S509 = (&(globalParams_0->fabrics_0)[_S505]);
    Sample_0 _S510 = sample_at_0(_S505, _S506, _S507, _S508);
    float _S511;
    if(_S510.shown_3.is_warp_0)
    {
        _S511 = _S510.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S511 = _S510.crossing_1.weft_1.half_width_1;
    }
    uint _S512;
    if(_S510.shown_3.is_warp_0)
    {
        uint _S513 = __ldg(&_S509->warp_0);
        _S512 = _S513;
    }
    else
    {
        uint _S514 = __ldg(&_S509->weft_0);
        _S512 = _S514;
    }
    Family_0 _S515 = slang_ldg_1((&(globalParams_0->families_0)[_S512]));
    float _S516;
    if(_S508)
    {
        _S516 = -1.0f;
    }
    else
    {
        _S516 = 1.0f;
    }
    float _S517 = _S515.twist_sine_0 * _S516;
    Family_0 _S518 = slang_ldg_1((&(globalParams_0->families_0)[_S512]));
    if(_S510.shown_3.is_warp_0)
    {
        _S516 = 1.0f;
    }
    else
    {
        _S516 = -1.0f;
    }
    float2  _S519 = fibre_direction_0(_S510.slope_across_0, _S516 * _S510.slope_along_0, _S517, _S518.twist_cosine_0);
    float _S520;
    if(_S510.shown_3.is_warp_0)
    {
        _S520 = _S510.slope_x_1;
    }
    else
    {
        _S520 = _S510.slope_y_1;
    }
    float _S521;
    if(_S510.shown_3.is_warp_0)
    {
        _S521 = _S510.slope_y_1;
    }
    else
    {
        _S521 = _S510.slope_x_1;
    }
    float _S522 = _S519.x;
    float _S523 = _S519.y;
    float _S524 = _S520 * _S522 + _S516 * _S521 * _S523;
    float _S525 = _S511 * 1.0154266357421875f;
    float _S526 = _S525 * arc_sine_0(clamp_0(_S510.section_1.across_1 / _S525, -1.0f, 1.0f));
    if(_S510.shown_3.is_warp_0)
    {
        _S511 = _S507;
    }
    else
    {
        _S511 = - _S506;
    }
    SurfacePoint_0 point_0;
    (&point_0)->hole_4 = _S510.shown_3.hole_0;
    (&point_0)->is_warp_2 = _S510.shown_3.is_warp_0;
    (&point_0)->warp_thread_0 = _S510.crossing_1.warp_1.thread_0;
    (&point_0)->weft_thread_0 = _S510.crossing_1.weft_1.thread_0;
    (&point_0)->height_10 = _S510.height_6;
    (&point_0)->normal_4 = normalize_0(make_float3 (- _S510.slope_x_1, - _S510.slope_y_1, 1.0f));
    float3  _S527;
    if(_S510.shown_3.is_warp_0)
    {
        _S527 = make_float3 (_S522, _S523, _S524);
    }
    else
    {
        _S527 = make_float3 (- _S523, _S522, _S524);
    }
    (&point_0)->tangent_5 = normalize_0(_S527);
    (&point_0)->across_2 = _S510.section_1.across_1;
    (&point_0)->fibre_across_0 = _S526 * _S518.twist_cosine_0 + _S511 * _S517;
    (&point_0)->fibre_along_0 = _S511 * _S518.twist_cosine_0 - _S526 * _S517;
    return point_0;
}

__device__ Albedos_0 vary_albedos_0(uint _S528, Albedos_0 * _S529, uint _S530, uint _S531)
{
    Fabric_0 * _S532 = (&(globalParams_0->fabrics_0)[_S528]);
    float3  _S533 = _S529->specular_reflect_0;
    float3  _S534 = _S529->specular_transmit_0;
    float3  _S535 = max_0(_S529->specular_reflect_0, _S529->specular_transmit_0);
    float3  _S536 = _S529->diffuse_reflect_0;
    float3  _S537 = _S529->diffuse_transmit_0;
    float3  _S538 = _S529->diffuse_reflect_0 + _S529->diffuse_transmit_0;
    float _S539 = __ldg(&_S532->colour_noise_0);
    uint _S540 = __ldg(&_S532->seed_0);
    float _S541 = thread_gain_0(_S530, _S539, _S540);
    float _S542 = __ldg(&_S532->layer_bound_0);
    float _S543 = bounded_gain_0(_S541, _S538, make_float3 (1.0f) - make_float3 (_S542) * _S535);
    float3  _S544 = min_0((make_float3 (1.0f) - make_float3 (_S543) * _S538) / make_float3 (_S542), make_float3 (1.0f));
    float _S545 = __ldg(&_S532->fibre_noise_0);
    float _S546 = bounded_gain_0(fibre_gain_0(_S530, _S531, _S545, _S540), _S535, _S544);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S543) * _S536;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S543) * _S537;
    (&varied_0)->specular_reflect_0 = make_float3 (_S546) * _S533;
    (&varied_0)->specular_transmit_0 = make_float3 (_S546) * _S534;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S547, SurfacePoint_0 * _S548, Albedos_0 * _S549, float _S550, float _S551)
{
    Fabric_0 * _S552 = (&(globalParams_0->fabrics_0)[_S547]);
    bool _S553 = _S548->is_warp_2;
    float _S554;
    if(_S548->is_warp_2)
    {
        _S554 = _S550;
    }
    else
    {
        _S554 = _S551;
    }
    float _S555 = _S554 - _S548->across_2;
    uint _S556;
    if(_S553)
    {
        uint _S557 = __ldg(&_S552->warp_0);
        _S556 = _S557;
    }
    else
    {
        uint _S558 = __ldg(&_S552->weft_0);
        _S556 = _S558;
    }
    Family_0 _S559 = slang_ldg_1((&(globalParams_0->families_0)[_S556]));
    Family_0 _S560 = slang_ldg_1((&(globalParams_0->families_0)[_S556]));
    int _S561 = int(_S560.count_0);
    if(_S553)
    {
        _S556 = _S548->warp_thread_0;
    }
    else
    {
        _S556 = _S548->weft_thread_0;
    }
    uint _S562 = uint(int((F32_floor((_S555 / _S559.period_0)))) * _S561 + int(_S556)) * 2U;
    if(_S553)
    {
        _S556 = 1U;
    }
    else
    {
        _S556 = 0U;
    }
    uint _S563 = _S562 + _S556;
    float _S564 = _S548->fibre_across_0;
    float _S565 = __ldg(&_S552->fibre_size_0);
    float _S566 = (F32_floor((_S564 / _S565)));
    Albedos_0 _S567 = vary_albedos_0(_S547, _S549, _S563, uint(int(_S566)) * 65536U + uint(int((F32_floor((_S548->fibre_along_0 / (_S565 * 40.0f) + 0.61799997091293335f * _S566))))));
    return _S567;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S568, SurfacePoint_0 * _S569, float _S570, float _S571, bool _S572, bool _S573)
{
    Fabric_0 * _S574 = (&(globalParams_0->fabrics_0)[_S568]);
    bool _S575 = _S569->is_warp_2;
    uint _S576;
    if(_S569->is_warp_2)
    {
        uint _S577 = __ldg(&_S574->warp_0);
        _S576 = _S577;
    }
    else
    {
        uint _S578 = __ldg(&_S574->weft_0);
        _S576 = _S578;
    }
    uint _S579;
    if(_S575)
    {
        _S579 = _S569->warp_thread_0;
    }
    else
    {
        _S579 = _S569->weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S576, _S579);
    float _S580 = __ldg(&_S574->fibre_noise_0);
    bool _S581;
    if(_S580 > 0.0f)
    {
        _S581 = true;
    }
    else
    {
        float _S582 = __ldg(&_S574->colour_noise_0);
        _S581 = _S582 > 0.0f;
    }
    Albedos_0 albedos_3;
    if(_S581)
    {
        Albedos_0 _S583 = albedos_2;
        Albedos_0 _S584 = varied_at_0(_S568, _S569, &_S583, _S570, _S571);
        albedos_3 = _S584;
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_1;
    (&point_1)->back_5 = _S572;
    (&point_1)->hole_2 = _S573;
    (&point_1)->is_warp_1 = _S575;
    (&point_1)->x_19 = _S570;
    (&point_1)->y_11 = _S571;
    (&point_1)->height_4 = _S569->height_10;
    (&point_1)->normal_3 = _S569->normal_4;
    (&point_1)->tangent_4 = _S569->tangent_5;
    Family_0 _S585 = slang_ldg_1((&(globalParams_0->families_0)[_S576]));
    (&point_1)->roughness_8 = _S585.roughness_0;
    (&point_1)->albedos_1 = albedos_3;
    return point_1;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S586, SearchQuality_0 * _S587, float _S588, float _S589, float3  _S590)
{
    bool _S591 = (_S590.z) < 0.0f;
    Hit_0 _S592 = first_hit_0(_S586, _S587, _S588, _S589, to_face_frame_0(_S590, _S591), _S591);
    SurfacePoint_0 _S593 = surface_at_0(_S586, _S592.x_20, _S592.y_12, _S591);
    SurfacePoint_0 _S594 = _S593;
    YarnPoint_0 _S595 = yarn_point_of_0(_S586, &_S594, _S592.x_20, _S592.y_12, _S591, _S592.hole_3);
    return _S595;
}

__device__ float openness_number_0(uint _S596, uint _S597)
{
    uint _S598 = __ldg(&(&(globalParams_0->fabrics_0)[_S596])->openness_0);
    return table_number_0(_S598 + _S597);
}

__device__ Blocked_0 blocked_of_terms_0(uint _S599, uint _S600, FixedArray<float, 6>  * _S601, uint _S602)
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
            if(term_0 < _S602)
            {
            }
            else
            {
                break;
            }
            float _S603 = openness_number_0(_S599, _S600 + share_2 * _S602 + term_0);
            shares_0[share_2] = shares_0[share_2] + _S603 * (*_S601)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_2] = saturate_0(shares_0[share_2]);
        share_2 = share_2 + 1U;
    }
    Blocked_0 blocked_1;
    (&blocked_1)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_1)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_1)->far_0 = shares_0[int(1)];
    return blocked_1;
}

__device__ Blocked_0 blocked_at_0(uint _S604, bool _S605, bool _S606, float _S607, float _S608)
{
    float _S609 = openness_number_0(_S604, 158U);
    float _S610 = _S608 * _S609;
    float _S611 = _S607 * _S607;
    float _S612 = _S607 * _S610;
    float _S613 = _S610 * _S610;
    uint _S614;
    if(_S606)
    {
        _S614 = 2U;
    }
    else
    {
        _S614 = 0U;
    }
    uint _S615;
    if(_S605)
    {
        _S615 = 0U;
    }
    else
    {
        _S615 = 1U;
    }
    uint _S616 = 60U + (_S614 + _S615) * 18U;
    FixedArray<float, 6>  _S617;
    _S617[int(0)] = 1.0f;
    _S617[int(1)] = _S607;
    _S617[int(2)] = _S610;
    _S617[int(3)] = _S611;
    _S617[int(4)] = _S612;
    _S617[int(5)] = _S613;
    Blocked_0 _S618 = blocked_of_terms_0(_S604, _S616, &_S617, 6U);
    return _S618;
}

__device__ Scattered_0 scattered_by_0(uint _S619, Albedos_0 * _S620, uint _S621, float3  _S622)
{
    uint _S623 = 159U + 2U * _S621;
    Scattered_0 yarn_3;
    float3  _S624 = _S622 * _S620->diffuse_reflect_0;
    float _S625 = openness_number_0(_S619, _S623);
    (&yarn_3)->back_4 = _S624 + make_float3 (_S625) * _S620->specular_reflect_0;
    float3  _S626 = _S622 * _S620->diffuse_transmit_0;
    float _S627 = openness_number_0(_S619, _S623 + 1U);
    (&yarn_3)->through_0 = _S626 + make_float3 (_S627) * _S620->specular_transmit_0;
    return yarn_3;
}

__device__ void sent_0(uint _S628, uint _S629, float3  _S630, float3  _S631, float3  _S632, float3  _S633, float3  * _S634, float3  * _S635)
{
    uint _S636 = 146U + 4U * _S629;
    float _S637 = openness_number_0(_S628, _S636);
    float _S638 = openness_number_0(_S628, _S636 + 1U);
    float _S639 = openness_number_0(_S628, _S636 + 2U);
    float _S640 = openness_number_0(_S628, _S636 + 3U);
    float3  _S641 = make_float3 (1.0f) - _S632 * make_float3 (_S637);
    float3  _S642 = make_float3 (1.0f) - _S633 * make_float3 (_S640);
    float3  _S643 = make_float3 (1.0f) / (_S641 * _S642 - _S632 * _S633 * make_float3 (_S638 * _S639));
    *_S634 = (_S630 * _S642 + _S632 * make_float3 (_S638) * _S631) * _S643;
    *_S635 = (_S631 * _S641 + _S633 * make_float3 (_S639) * _S630) * _S643;
    return;
}

__device__ FaceSends_0 face_sends_0(uint _S644, uint _S645, Scattered_0 * _S646, Scattered_0 * _S647)
{
    uint _S648 = 2U * _S645;
    uint _S649 = 142U + _S648;
    float _S650 = openness_number_0(_S644, _S649);
    float _S651 = openness_number_0(_S644, _S649 + 1U);
    float3  _S652 = make_float3 (1.0f - _S650) * _S646->back_4;
    float3  _S653 = make_float3 (1.0f - _S651) * _S647->back_4;
    FaceSends_0 sends_1;
    uint _S654 = 154U + _S648;
    float _S655 = openness_number_0(_S644, _S654);
    (&sends_1)->blocks_warp_0 = _S655;
    float _S656 = openness_number_0(_S644, _S654 + 1U);
    (&sends_1)->blocks_weft_0 = _S656;
    (&sends_1)->open_0 = _S655 * _S650 + _S656 * _S651;
    sent_0(_S644, _S645, make_float3 (_S650) * _S646->back_4, make_float3 (_S651) * _S647->back_4, _S652, _S653, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0);
    sent_0(_S644, _S645, _S646->through_0, _S647->through_0, _S652, _S653, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0);
    return sends_1;
}

__device__ Interior_0 interior_of_0(uint _S657, float3  _S658, bool _S659)
{
    Fabric_0 * _S660 = (&(globalParams_0->fabrics_0)[_S657]);
    uint _S661 = __ldg(&_S660->warp_0);
    Family_0 _S662 = slang_ldg_1((&(globalParams_0->families_0)[_S661]));
    Albedos_0 _S663 = table_albedos_0(_S662.colour_mean_0);
    Scattered_0 _S664 = scattered_by_0(_S657, &_S663, 0U, _S658);
    uint _S665 = __ldg(&_S660->weft_0);
    Family_0 _S666 = slang_ldg_1((&(globalParams_0->families_0)[_S665]));
    Albedos_0 _S667 = table_albedos_0(_S666.colour_mean_0);
    Scattered_0 _S668 = scattered_by_0(_S657, &_S667, 1U, _S658);
    uint _S669;
    if(_S659)
    {
        _S669 = 1U;
    }
    else
    {
        _S669 = 0U;
    }
    Scattered_0 _S670 = _S664;
    Scattered_0 _S671 = _S668;
    FaceSends_0 _S672 = face_sends_0(_S657, _S669, &_S670, &_S671);
    if(_S659)
    {
        _S669 = 0U;
    }
    else
    {
        _S669 = 1U;
    }
    Scattered_0 _S673 = _S664;
    Scattered_0 _S674 = _S668;
    FaceSends_0 _S675 = face_sends_0(_S657, _S669, &_S673, &_S674);
    float3  _S676 = make_float3 (_S672.blocks_warp_0) * _S672.crossing_warp_0 + make_float3 (_S672.blocks_weft_0) * _S672.crossing_weft_0;
    float3  _S677 = make_float3 (_S675.blocks_warp_0) * _S675.crossing_warp_0 + make_float3 (_S675.blocks_weft_0) * _S675.crossing_weft_0;
    float _S678 = 1.0f - _S672.open_0;
    float _S679 = 1.0f - _S675.open_0;
    float3  _S680 = make_float3 (1.0f) / (make_float3 (1.0f) - _S676 * _S677 * make_float3 (_S678 * _S679));
    float3  _S681 = _S677 * (make_float3 (_S672.open_0) + make_float3 (_S678) * (make_float3 (_S672.blocks_warp_0) * _S672.sky_warp_0 + make_float3 (_S672.blocks_weft_0) * _S672.sky_weft_0)) * _S680;
    float3  _S682 = _S676 * (make_float3 (_S675.open_0) + make_float3 (_S679) * (make_float3 (_S675.blocks_warp_0) * _S675.sky_warp_0 + make_float3 (_S675.blocks_weft_0) * _S675.sky_weft_0)) * _S680;
    FaceSends_0 _S683 = _S672;
    FaceRadiance_0 _S684 = face_radiance_0(&_S683, _S675.open_0, _S681, _S682);
    FaceSends_0 _S685 = _S675;
    FaceRadiance_0 _S686 = face_radiance_0(&_S685, _S672.open_0, _S682, _S681);
    Interior_0 interior_1;
    (&interior_1)->warp_3 = _S684.warp_2;
    (&interior_1)->weft_3 = _S684.weft_2;
    (&interior_1)->leaked_1 = _S684.leaked_0;
    (&interior_1)->far_1 = _S686.mean_0;
    (&interior_1)->far_leaked_0 = _S686.leaked_0;
    return interior_1;
}

__device__ Bounced_0 bounced_at_0(uint _S687, YarnPoint_0 * _S688, float3  _S689)
{
    Fabric_0 * _S690 = (&(globalParams_0->fabrics_0)[_S687]);
    Bounced_0 nothing_0;
    float3  _S691 = make_float3 (0.0f);
    (&nothing_0)->reflected_0 = _S691;
    (&nothing_0)->transmitted_0 = _S691;
    uint _S692 = __ldg(&_S690->openness_0);
    bool _S693;
    if(_S692 == 4294967295U)
    {
        _S693 = true;
    }
    else
    {
        _S693 = _S688->hole_2;
    }
    if(_S693)
    {
        return nothing_0;
    }
    bool _S694 = _S688->back_5;
    Blocked_0 _S695 = blocked_at_0(_S687, _S688->is_warp_1, _S688->back_5, _S688->normal_3.z, _S688->height_4);
    uint _S696;
    if(_S688->is_warp_1)
    {
        _S696 = 0U;
    }
    else
    {
        _S696 = 1U;
    }
    Scattered_0 _S697 = scattered_by_0(_S687, &_S688->albedos_1, _S696, _S689);
    Interior_0 _S698 = interior_of_0(_S687, _S689, _S694);
    Blocked_0 _S699 = _S695;
    Scattered_0 _S700 = _S697;
    Interior_0 _S701 = _S698;
    Bounced_0 _S702 = bounced_by_0(&_S699, &_S700, &_S701);
    return _S702;
}

__device__ float3  scattered_0(uint _S703, YarnPoint_0 * _S704, float3  _S705, float3  _S706)
{
    Fabric_0 * _S707 = (&(globalParams_0->fabrics_0)[_S703]);
    float3  _S708 = make_float3 (0.0f);
    bool _S709 = !_S704->hole_2;
    bool _S710;
    if(_S709)
    {
        _S710 = (_S705.z) > 0.0f;
    }
    else
    {
        _S710 = false;
    }
    float3  value_1;
    if(_S710)
    {
        float3  _S711 = (&_S704->albedos_1)->diffuse_reflect_0;
        float3  _S712 = _S704->normal_3;
        float _S713 = __ldg(&_S707->diffuse_blend_0);
        float3  _S714 = _S711 * make_float3 (diffuse_reflection_0(_S705, _S712, _S713));
        float3  _S715 = (&_S704->albedos_1)->specular_reflect_0;
        float3  _S716 = _S704->tangent_4;
        float _S717 = _S704->roughness_8;
        float _S718 = __ldg(&_S707->optical_depth_0);
        value_1 = _S714 + _S715 * make_float3 (reflection_0(_S705, _S706, _S712, _S716, _S717, _S718));
    }
    else
    {
        if(_S709)
        {
            _S710 = (_S705.z) < 0.0f;
        }
        else
        {
            _S710 = false;
        }
        if(_S710)
        {
            float3  _S719 = (&_S704->albedos_1)->diffuse_transmit_0;
            float3  _S720 = - _S705;
            float3  _S721 = _S704->normal_3;
            float _S722 = __ldg(&_S707->diffuse_blend_0);
            float3  _S723 = _S719 * make_float3 (diffuse_reflection_0(_S720, _S721, _S722));
            float3  _S724 = (&_S704->albedos_1)->specular_transmit_0;
            float3  _S725 = _S704->tangent_4;
            float _S726 = _S704->roughness_8;
            float _S727 = __ldg(&_S707->optical_depth_0);
            value_1 = _S723 + _S724 * make_float3 (transmission_1(_S705, _S706, _S721, _S725, _S726, _S727));
        }
        else
        {
            value_1 = _S708;
        }
    }
    float _S728 = __ldg(&_S707->sheen_strength_0);
    if(_S728 <= 0.0f)
    {
        return value_1;
    }
    float _S729 = __ldg(&_S707->sheen_roughness_0);
    float2  _S730 = sheen_with_transmittance_0(_S705, _S706, _S728, _S729);
    return make_float3 (_S730.y) * value_1 + make_float3 (_S730.x);
}

__device__ bool unoccluded_0(uint _S731, SearchQuality_0 * _S732, float _S733, float _S734, float _S735, float3  _S736, bool _S737)
{
    Fabric_0 * _S738 = (&(globalParams_0->fabrics_0)[_S731]);
    if((_S736.z) <= 0.0f)
    {
        return false;
    }
    float _S739 = max_height_along_0(_S731, _S733, _S734, _S735, _S736, _S737);
    float _S740 = __ldg(&_S738->lift_0);
    bool _S741 = is_free_0(_S731, _S732, make_float3 (_S733, _S734, _S735 + _S740), _S736, _S737, _S739);
    return _S741;
}

__device__ bool is_lit_0(uint _S742, SearchQuality_0 * _S743, YarnPoint_0 * _S744, float3  _S745)
{
    if(_S744->hole_2)
    {
        return true;
    }
    bool _S746 = _S744->back_5;
    float3  _S747 = to_face_frame_0(_S745, _S744->back_5);
    float _S748 = _S747.z;
    bool _S749 = _S748 < 0.0f;
    float3  _S750 = _S744->normal_3;
    float _S751 = _S744->height_4;
    float3  normal_5;
    float height_11;
    if(_S749)
    {
        SurfacePoint_0 _S752 = surface_at_0(_S742, _S744->x_19, _S744->y_11, !_S746);
        normal_5 = _S752.normal_4;
        height_11 = _S752.height_10;
    }
    else
    {
        normal_5 = _S750;
        height_11 = _S751;
    }
    float3  _S753 = make_float3 (float2 {_S747.x, _S747.y}.x, float2 {_S747.x, _S747.y}.y, (F32_abs((_S748))));
    if((dot_0(normal_5, _S753)) <= 0.0f)
    {
        return false;
    }
    bool _S754 = unoccluded_0(_S742, _S743, _S744->x_19, _S744->y_11, height_11, _S753, _S746 != _S749);
    return _S754;
}

__device__ float3  evaluate_with_0(uint _S755, SearchQuality_0 * _S756, YarnPoint_0 * _S757, Bounced_0 * _S758, float3  _S759, float3  _S760)
{
    Fabric_0 * _S761 = (&(globalParams_0->fabrics_0)[_S755]);
    float3  _S762 = to_face_frame_0(_S760, _S757->back_5);
    float3  _S763 = scattered_0(_S755, _S757, to_face_frame_0(_S759, _S757->back_5), _S762);
    bool _S764;
    if((F32_max((_S763.x), ((F32_max((_S763.y), (_S763.z)))))) <= 0.0f)
    {
        _S764 = true;
    }
    else
    {
        bool _S765 = is_lit_0(_S755, _S756, _S757, _S759);
        _S764 = !_S765;
    }
    float3  value_2;
    if(_S764)
    {
        value_2 = make_float3 (0.0f);
    }
    else
    {
        value_2 = _S763;
    }
    float3  _S766 = bounced_value_0(_S758, _S759, _S760);
    float _S767 = __ldg(&_S761->sheen_strength_0);
    float3  between_1;
    if(_S767 > 0.0f)
    {
        float _S768 = (F32_abs((_S762.z)));
        float _S769 = __ldg(&_S761->sheen_roughness_0);
        between_1 = _S766 * make_float3 (1.0f - _S767 * sheen_lobe_0(_S768, _S769).z);
    }
    else
    {
        between_1 = _S766;
    }
    return value_2 + between_1;
}

__device__ float3  evaluate_0(uint _S770, SearchQuality_0 * _S771, YarnPoint_0 * _S772, float3  _S773, float3  _S774)
{
    Bounced_0 _S775 = bounced_at_0(_S770, _S772, make_float3 (1.0f));
    Bounced_0 _S776 = _S775;
    float3  _S777 = evaluate_with_0(_S770, _S771, _S772, &_S776, _S773, _S774);
    return _S777;
}

__device__ float straight_through_0(uint _S778, YarnPoint_0 * _S779, float3  _S780)
{
    Fabric_0 * _S781 = (&(globalParams_0->fabrics_0)[_S778]);
    if(!_S779->hole_2)
    {
        return 0.0f;
    }
    float _S782 = __ldg(&_S781->sheen_strength_0);
    if(_S782 <= 0.0f)
    {
        return 1.0f;
    }
    float _S783 = (F32_abs((_S780.z)));
    float _S784 = __ldg(&_S781->sheen_roughness_0);
    return 1.0f - _S782 * sheen_lobe_0(_S783, _S784).z;
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_0, float2  dx_0, float2  dy_0, float3  light_7, float3  view_6)
{
    SearchQuality_0 _S785 = default_quality_0();
    float _S786 = centre_0.x;
    float _S787 = centre_0.y;
    SearchQuality_0 _S788 = _S785;
    YarnPoint_0 _S789 = locate_yarn_0(fabric_2, &_S788, _S786, _S787, view_6);
    SearchQuality_0 _S790 = _S785;
    YarnPoint_0 _S791 = _S789;
    float3  _S792 = evaluate_0(fabric_2, &_S790, &_S791, light_7, view_6);
    YarnPoint_0 _S793 = _S789;
    float _S794 = straight_through_0(fabric_2, &_S793, view_6);
    return make_float4 (_S792.x, _S792.y, _S792.z, _S794);
}

extern "C" __global__ void point_queries()
{
    uint _S795 = (blockIdx * blockDim + threadIdx).x;
    uint _S796 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S795 >= _S796)
    {
        return;
    }
    Query_0 _S797 = slang_ldg_0((&(globalParams_0->queries_0)[_S795]));
    *(&(globalParams_0->answers_0)[_S795]) = cloth_value_0(_S797.fabric_1, make_float2 (_S797.centre_x_0, _S797.centre_y_0), make_float2 (_S797.dx_x_0, _S797.dx_y_0), make_float2 (_S797.dy_x_0, _S797.dy_y_0), make_float3 (_S797.light_x_0, _S797.light_y_0, _S797.light_z_0), make_float3 (_S797.view_x_0, _S797.view_y_0, _S797.view_z_0));
    return;
}

