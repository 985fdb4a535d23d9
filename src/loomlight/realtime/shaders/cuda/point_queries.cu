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

__device__ float3  min_0(float3  x_8, float3  y_6)
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
        *_slang_vector_get_element_ptr(&result_4, i_2) = (F32_min((_slang_vector_get_element(x_8, i_2)), (_slang_vector_get_element(y_6, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_4;
}

__device__ float3  max_0(float3  x_9, float3  y_7)
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
        *_slang_vector_get_element_ptr(&result_5, i_3) = (F32_max((_slang_vector_get_element(x_9, i_3)), (_slang_vector_get_element(y_7, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_5;
}

__device__ float3  normalize_0(float3  x_10)
{
    return x_10 / make_float3 (length_0(x_10));
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

__device__ float3  to_face_frame_0(float3  direction_0, bool back_1)
{
    float2  _S15 = float2 {direction_0.x, direction_0.y};
    float _S16;
    if(back_1)
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

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_2)
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
    (&shown_0)->on_top_0 = ((_S87 & 1U) == 1U) != back_2;
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

__device__ float square_0(float x_11)
{
    return x_11 * x_11;
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
    float height_1;
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

__device__ float2  ViewRay_at_0(ViewRay_0 * this_2, float height_2)
{
    return this_2->origin_0 + this_2->slope_1 * make_float2 (height_2);
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

__device__ float arc_sine_0(float x_12)
{
    float _S178 = (F32_abs((x_12)));
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
    if(x_12 < 0.0f)
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

__device__ float bounded_gain_0(float gain_1, float3  albedo_0, float3  room_0)
{
    float3  _S187 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S187.x), (_S187.y)))), (_S187.z)))), (0.0f))))));
}

__device__ float natural_logarithm_0(float x_13)
{
    uint _S188 = (F32_asuint((x_13)));
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

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_0, float blend_0)
{
    float _S190 = light_0.z;
    if(_S190 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S190), (0.0f))), (F32_max((dot_0(light_0, normal_0)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_2, float3  tangent_0, float roughness_1)
{
    float _S191 = dot_0(direction_2, tangent_0);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S191 * _S191 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_14)
{
    float _S192 = clamp_0(x_14, -87.0f, 88.0f);
    float _S193 = (F32_floor((_S192 * 1.4426950216293335f + 0.5f)));
    float _S194 = _S192 - _S193 * 0.693359375f + _S193 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S194 + 0.00139819993637502f) * _S194 + 0.00833345204591751f) * _S194 + 0.04166579619050026f) * _S194 + 0.1666666567325592f) * _S194 + 0.5f;
    float _S195 = (U32_asfloat((uint(int(_S193) + int(127)) << int(23))));
    float _S196;
    if(x_14 < -87.0f)
    {
        _S196 = 0.0f;
    }
    else
    {
        _S196 = (p_0 * _S194 * _S194 + _S194 + 1.0f) * _S195;
    }
    return _S196;
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
    float _S197 = roughness_2 * roughness_2;
    float _S198 = squared_along_0 * (1.0f - _S197) + _S197;
    return 0.31830987334251404f * _S197 * roughness_2 / (_S198 * _S198);
}

__device__ float density_between_0(float3  light_1, float3  view_0, float3  tangent_1, float roughness_3)
{
    float3  _S199 = light_1 + view_0;
    float _S200 = dot_0(_S199, tangent_1);
    return flake_density_0((F32_min((_S200 * _S200 / (F32_max((square_1(_S199)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_2, float3  view_1, float3  normal_1, float3  tangent_2, float roughness_4, float optical_depth_1)
{
    float _S201 = dot_0(light_2, normal_1);
    bool _S202;
    if(_S201 <= 0.0f)
    {
        _S202 = true;
    }
    else
    {
        _S202 = (dot_0(view_1, normal_1)) <= 0.0f;
    }
    if(_S202)
    {
        return 0.0f;
    }
    float _S203 = (F32_max((_S201), (9.99999997475242708e-07f)));
    float _S204 = (F32_max((dot_0(view_1, normal_1)), (9.99999997475242708e-07f)));
    float _S205 = projected_area_1(light_2, tangent_2, roughness_4) * _S204 + projected_area_1(view_1, tangent_2, roughness_4) * _S203;
    float _S206 = optical_depth_1 * _S205 / (_S203 * _S204);
    return 0.25f * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S206 * mean_attenuation_0(_S206)) * _S203 / _S205;
}

__device__ float transmission_0(float3  light_3, float3  view_2, float3  normal_2, float3  tangent_3, float roughness_5, float optical_depth_2)
{
    float _S207 = - dot_0(light_3, normal_2);
    float _S208 = dot_0(view_2, normal_2);
    bool _S209;
    if(_S207 <= 0.0f)
    {
        _S209 = true;
    }
    else
    {
        _S209 = _S208 <= 0.0f;
    }
    if(_S209)
    {
        return 0.0f;
    }
    float _S210 = 1.0f / (F32_max((_S208), (9.99999997475242708e-07f)));
    float _S211 = projected_area_1(light_3, tangent_3, roughness_5) / (F32_max((_S207), (9.99999997475242708e-07f)));
    float _S212 = projected_area_1(view_2, tangent_3, roughness_5) * _S210;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S211), (_S212)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S211 - _S212)))) * _S210;
}

__device__ float sheen_scale_0(float x_15, float y_8)
{
    return (((((0.0f * x_15 + (((((-1.1402510404586792f * y_8 + 0.40672621130943298f) * y_8 + 1.65398800373077393f) * y_8 + -1.29730904102325439f) * y_8 + 0.30570998787879944f) * y_8 + -0.0220868494361639f)) * x_15 + (((((-0.21142719686031342f * y_8 + 1.05947399139404297f) * y_8 + -0.41116121411323547f) * y_8 + -0.93859231472015381f) * y_8 + 0.51606941223144531f) * y_8 + 0.05409301072359085f)) * x_15 + (((((1.22944498062133789f * y_8 + -0.45962560176849365f) * y_8 + -1.63861405849456787f) * y_8 + 1.33565104007720947f) * y_8 + -0.45725581049919128f) * y_8 + 0.08243165910243988f)) * x_15 + (((((0.39779931306838989f * y_8 + -1.18879103660583496f) * y_8 + 0.28251591324806213f) * y_8 + 1.168984055519104f) * y_8 + -0.76864629983901978f) * y_8 + 0.0091691892594099f)) * x_15 + (((((-0.26563560962677002f * y_8 + -0.19379159808158875f) * y_8 + 0.2677634060382843f) * y_8 + 0.00270519289188087f) * y_8 + 0.14349560439586639f) * y_8 + 0.10290180146694183f)) * x_15 + (((((-0.20701569318771362f * y_8 + 0.24526430666446686f) * y_8 + 0.19551840424537659f) * y_8 + 0.07586126774549484f) * y_8 + 0.38894739747047424f) * y_8 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_16, float y_9)
{
    return ((((0.0f * x_16 + (((((-0.10608240216970444f * y_9 + 1.99214303493499756f) * y_9 + -1.42255294322967529f) * y_9 + -1.09495604038238525f) * y_9 + 0.59180057048797607f) * y_9 + 0.06902855634689331f)) * x_16 + (((((-0.46220690011978149f * y_9 + -0.29113379120826721f) * y_9 + 1.39025199413299561f) * y_9 + 0.35589990019798279f) * y_9 + -1.17120099067687988f) * y_9 + 0.15940259397029877f)) * x_16 + (((((2.26068711280822754f * y_9 + -3.64728999137878418f) * y_9 + -0.72173482179641724f) * y_9 + 3.07659196853637695f) * y_9 + -0.6827620267868042f) * y_9 + -0.3039557933807373f)) * x_16 + (((((0.81201767921447754f * y_9 + 0.36014080047607422f) * y_9 + -1.72646903991699219f) * y_9 + -0.22630110383033752f) * y_9 + 0.89514690637588501f) * y_9 + -0.10397960245609283f)) * x_16 + (((((-0.37648698687553406f * y_9 + 1.10974001884460449f) * y_9 + 0.17824520170688629f) * y_9 + -1.04968702793121338f) * y_9 + 0.1461234986782074f) * y_9 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_17, float y_10)
{
    return ((((0.0f * x_17 + (((((12.95646953582763672f * y_10 + -21.38032913208007812f) * y_10 + -7.37853097915649414f) * y_10 + 34.55607986450195312f) * y_10 + -23.61347007751464844f) * y_10 + 5.00126314163208008f)) * x_17 + (((((10.91487026214599609f * y_10 + -6.08202791213989258f) * y_10 + -38.2036285400390625f) * y_10 + 53.3440399169921875f) * y_10 + -21.91996002197265625f) * y_10 + 2.01606011390686035f)) * x_17 + (((((-14.52206039428710938f * y_10 + 36.803619384765625f) * y_10 + -22.94047927856445312f) * y_10 + -10.07973003387451172f) * y_10 + 15.77003955841064453f) * y_10 + -4.92722177505493164f)) * x_17 + (((((-7.62505722045898438f * y_10 + 1.27310299873352051f) * y_10 + 31.19523048400878906f) * y_10 + -44.39989852905273438f) * y_10 + 26.44947052001953125f) * y_10 + -8.73507976531982422f)) * x_17 + (((((5.65633487701416016f * y_10 + -17.66820907592773438f) * y_10 + 24.65356063842773438f) * y_10 + -19.38941001892089844f) * y_10 + 11.06159019470214844f) * y_10 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S213 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S214 = 2.0f * (F32_sqrt((_S213))) - 1.0f;
    float _S215 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S214, _S215), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S213) * sheen_shear_0(_S214, _S215), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S214, _S215), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_4, float3  view_3, float scale_0, float shear_0)
{
    float _S216 = light_4.z;
    bool _S217;
    if(_S216 <= 0.0f)
    {
        _S217 = true;
    }
    else
    {
        _S217 = (view_3.z) <= 0.0f;
    }
    if(_S217)
    {
        return 0.0f;
    }
    float2  _S218 = float2 {view_3.x, view_3.y};
    float _S219 = dot_1(_S218, _S218);
    float2  _S220;
    if(_S219 > 9.99999968265522539e-21f)
    {
        _S220 = _S218 * make_float2 ((F32_rsqrt((_S219))));
    }
    else
    {
        _S220 = make_float2 (1.0f, 0.0f);
    }
    float _S221 = scale_0 * dot_1(float2 {light_4.x, light_4.y}, _S220) + shear_0 * _S216;
    float _S222 = scale_0 * (light_4.y * _S220.x - light_4.x * _S220.y);
    float _S223 = _S221 * _S221 + _S222 * _S222 + _S216 * _S216;
    return 0.31830987334251404f * scale_0 * scale_0 * _S216 / (F32_max((_S223 * _S223), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_5, float3  view_4, float strength_0, float roughness_7)
{
    float3  _S224 = sheen_lobe_0(view_4.z, roughness_7);
    float _S225 = strength_0 * _S224.z;
    return make_float2 (_S225 * transformed_cosine_0(light_5, view_4, _S224.x, _S224.y), 1.0f - _S225);
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_2;
    bool is_warp_1;
    float x_18;
    float y_11;
    float height_3;
    float3  normal_3;
    float3  tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_19;
    float y_12;
    bool hole_3;
    float height_4;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_5;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

__device__ Crossing_0 crossing_at_0(uint _S226, float _S227, float _S228, bool _S229)
{
    Fabric_0 * _S230 = (&(globalParams_0->fabrics_0)[_S226]);
    Crossing_0 crossing_2;
    uint _S231 = __ldg(&_S230->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S231, _S227);
    uint _S232 = __ldg(&_S230->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S232, _S228);
    uint _S233 = __ldg(&_S230->run_words_0);
    uint _S234 = (&(&crossing_2)->weft_1)->thread_0;
    uint _S235 = __ldg(&_S230->ends_1);
    uint _S236 = _S233 + 2U * (_S234 * _S235 + (&(&crossing_2)->warp_1)->thread_0);
    uint _S237 = __ldg((&(globalParams_0->words_0)[_S236]));
    (&crossing_2)->warp_word_0 = _S237;
    uint _S238 = __ldg((&(globalParams_0->words_0)[_S236 + 1U]));
    (&crossing_2)->weft_word_0 = _S238;
    (&crossing_2)->warp_above_0 = ((_S237 & 1U) == 1U) != _S229;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S239, float _S240, float _S241, bool _S242)
{
    Fabric_0 * _S243 = (&(globalParams_0->fabrics_0)[_S239]);
    Sample_0 sample_0;
    Crossing_0 _S244 = crossing_at_0(_S239, _S240, _S241, _S242);
    (&sample_0)->crossing_1 = _S244;
    Crossing_0 _S245 = _S244;
    Shown_0 _S246 = shown_at_0(&_S245, _S242);
    (&sample_0)->shown_3 = _S246;
    uint _S247;
    if(_S246.is_warp_0)
    {
        uint _S248 = __ldg(&_S243->warp_0);
        _S247 = _S248;
    }
    else
    {
        uint _S249 = __ldg(&_S243->weft_0);
        _S247 = _S249;
    }
    uint _S250;
    if(_S246.is_warp_0)
    {
        uint _S251 = __ldg(&_S243->weft_0);
        _S250 = _S251;
    }
    else
    {
        uint _S252 = __ldg(&_S243->warp_0);
        _S250 = _S252;
    }
    Cell_0 _S253 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S254 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S255 = select_cell_0(_S246.is_warp_0, &_S253, &_S254);
    Cell_0 _S256 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S257 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S258 = select_cell_0(_S246.is_warp_0, &_S256, &_S257);
    Cell_0 _S259 = _S258;
    Run_0 _S260 = unpack_0(_S247, _S250, _S255.thread_0, &_S259, _S246.word_0);
    Cell_0 _S261 = _S255;
    Section_0 _S262 = section_at_0(&_S261);
    bool _S263;
    if(_S246.on_top_0)
    {
        _S263 = (_S260.distance_0) < (_S262.drop_0 * _S260.bend_1.sine_0);
    }
    else
    {
        _S263 = false;
    }
    bool _S264;
    if(_S246.on_top_0)
    {
        _S264 = !_S263;
    }
    else
    {
        _S264 = false;
    }
    float _S265;
    if(_S264)
    {
        _S265 = 1.0f;
    }
    else
    {
        _S265 = -1.0f;
    }
    float _S266;
    if(_S263)
    {
        _S266 = _S260.other_reach_0;
    }
    else
    {
        _S266 = _S260.reach_0;
    }
    float _S267;
    if(_S263)
    {
        _S267 = _S266 + _S260.distance_0;
    }
    else
    {
        _S267 = (F32_max((_S266 - _S260.distance_0), (0.0f)));
    }
    float _S268 = _S266 / _S260.bend_1.sine_0 - _S265 * _S262.drop_0;
    float _S269 = _S267 * _S267;
    float _S270 = (F32_max((_S268 * _S268 - _S269), (9.99999968265522539e-21f)));
    float _S271 = (F32_rsqrt((_S270)));
    float _S272 = _S269 / (_S270 * _S271 + _S268);
    bool _S273 = _S267 > 0.0f;
    float _S274;
    if(_S246.on_top_0)
    {
        _S274 = 1.0f;
    }
    else
    {
        _S274 = -1.0f;
    }
    float _S275;
    if(_S260.near_start_0)
    {
        _S275 = 1.0f;
    }
    else
    {
        _S275 = -1.0f;
    }
    float _S276 = _S274 * _S275;
    if(_S273)
    {
        _S274 = _S268 * _S271;
    }
    else
    {
        _S274 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S262.slope_0 * _S274;
    if(_S273)
    {
        _S267 = _S276 * _S267 * _S271;
    }
    else
    {
        _S267 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S267;
    Family_0 _S277 = slang_ldg_1((&(globalParams_0->families_0)[_S247]));
    Shown_0 _S278 = _S246;
    Run_0 _S279 = _S260;
    Cell_0 _S280 = _S258;
    float2  _S281 = dive_0(_S250, &_S278, &_S279, &_S280);
    if(_S260.straight_0)
    {
        _S265 = 0.0f;
    }
    else
    {
        _S265 = _S277.height_scale_0 * _S265;
    }
    (&sample_0)->height_5 = _S265 * (_S266 * _S260.bend_1.half_tangent_0 - _S272) - _S277.height_scale_0 * _S262.drop_0 - _S281.x;
    float _S282 = _S277.height_scale_0 * (&sample_0)->slope_across_0;
    float _S283 = _S277.height_scale_0 * (&sample_0)->slope_along_0 - _S281.y;
    if(_S246.is_warp_0)
    {
        _S265 = _S282;
    }
    else
    {
        _S265 = _S283;
    }
    (&sample_0)->slope_x_1 = _S265;
    if(_S246.is_warp_0)
    {
        _S265 = _S283;
    }
    else
    {
        _S265 = _S282;
    }
    (&sample_0)->slope_y_1 = _S265;
    (&sample_0)->run_3 = _S260;
    (&sample_0)->section_1 = _S262;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S284, SearchQuality_0 * _S285, float3  _S286)
{
    Fabric_0 * _S287 = (&(globalParams_0->fabrics_0)[_S284]);
    float _S288 = (F32_abs((_S286.x)));
    float _S289 = __ldg(&_S287->threads_per_x_0);
    float _S290 = _S288 * _S289;
    float _S291 = (F32_abs((_S286.y)));
    float _S292 = __ldg(&_S287->threads_per_y_0);
    float _S293 = (F32_max((_S290), (_S291 * _S292))) * _S285->steps_per_thread_0;
    float _S294 = (F32_abs((_S286.z)));
    float _S295 = __ldg(&_S287->per_relief_0);
    return (F32_max((_S293), (_S294 * _S295 * _S285->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S296, Crossing_0 * _S297)
{
    Fabric_0 * _S298 = (&(globalParams_0->fabrics_0)[_S296]);
    bool _S299 = _S297->warp_above_0;
    uint _S300;
    if(_S297->warp_above_0)
    {
        uint _S301 = __ldg(&_S298->warp_0);
        _S300 = _S301;
    }
    else
    {
        uint _S302 = __ldg(&_S298->weft_0);
        _S300 = _S302;
    }
    uint _S303;
    if(_S299)
    {
        _S303 = _S297->warp_word_0;
    }
    else
    {
        _S303 = _S297->weft_word_0;
    }
    float _S304 = float(_S303 >> int(28));
    Family_0 _S305 = slang_ldg_1((&(globalParams_0->families_0)[_S300]));
    float _S306 = _S304 * _S305.height_scale_0;
    Family_0 _S307 = slang_ldg_1((&(globalParams_0->families_0)[_S300]));
    return _S306 * _S307.level_0;
}

__device__ Probe_0 probe_0(uint _S308, float _S309, float _S310, bool _S311, bool _S312, bool _S313)
{
    Sample_0 _S314 = sample_at_0(_S308, _S309, _S310, _S311);
    Probe_0 probe_1;
    (&probe_1)->height_1 = _S314.height_5;
    (&probe_1)->hole_1 = _S314.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S314.slope_x_1;
    (&probe_1)->slope_y_0 = _S314.slope_y_1;
    uint _S315;
    if(_S314.shown_3.is_warp_0)
    {
        _S315 = _S314.crossing_1.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S315 = _S314.crossing_1.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S315;
    Crossing_0 _S316 = _S314.crossing_1;
    float _S317 = cell_maximum_0(_S308, &_S316);
    (&probe_1)->cell_max_0 = _S317;
    float _S318;
    if(_S312)
    {
        _S318 = _S314.crossing_1.warp_1.above_0;
    }
    else
    {
        _S318 = _S314.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S318;
    if(_S313)
    {
        _S318 = _S314.crossing_1.weft_1.above_0;
    }
    else
    {
        _S318 = _S314.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S318;
    bool _S319 = !_S314.shown_3.is_warp_0;
    Cell_0 _S320 = _S314.crossing_1.warp_1;
    Shown_0 _S321 = _S314.shown_3;
    Run_0 _S322 = _S314.run_3;
    float _S323 = outline_distance_0(&_S320, &_S321, &_S322, _S319, _S312);
    (&probe_1)->edge_x_0 = _S323;
    Cell_0 _S324 = _S314.crossing_1.weft_1;
    Shown_0 _S325 = _S314.shown_3;
    Run_0 _S326 = _S314.run_3;
    float _S327 = outline_distance_0(&_S324, &_S325, &_S326, _S314.shown_3.is_warp_0, _S313);
    (&probe_1)->edge_y_0 = _S327;
    return probe_1;
}

__device__ bool is_free_0(uint _S328, SearchQuality_0 * _S329, float3  _S330, float3  _S331, bool _S332, float _S333)
{
    float _S334 = _S331.z;
    if(_S334 <= 0.0f)
    {
        return false;
    }
    float _S335 = _S329->shadow_share_0;
    float _S336 = steps_per_length_0(_S328, _S329, _S331);
    float _S337 = 1.0f / (F32_max((_S335 * _S336), (9.99999971718068537e-10f)));
    StepControl_0 _S338 = step_control_0(float2 {_S331.x, _S331.y}, _S337);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S339;
        if(count_1 < 1024U)
        {
            _S339 = (_S330.z + _S334 * distance_1) < _S333;
        }
        else
        {
            _S339 = false;
        }
        if(_S339)
        {
        }
        else
        {
            break;
        }
        float3  _S340 = _S330 + _S331 * make_float3 (distance_1);
        Probe_0 _S341 = probe_0(_S328, _S340.x, _S340.y, _S332, _S338.right_0, _S338.up_0);
        float _S342 = _S340.z;
        float _S343 = _S342 - _S341.height_1;
        float _S344 = _S334 - _S341.slope_x_0 * _S331.x - _S341.slope_y_0 * _S331.y;
        bool _S345;
        if(!_S341.hole_1)
        {
            _S345 = _S343 < 0.0f;
        }
        else
        {
            _S345 = false;
        }
        if(_S345)
        {
            return false;
        }
        PreviousSample_0 _S346 = previous_3;
        Probe_0 _S347 = _S341;
        float _S348 = way_back_to_dip_0(&_S346, _S343, _S344, last_step_0, &_S347);
        if(_S348 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S348;
            distance_1 = distance_1 - _S348;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S349 = _S342 > (_S341.cell_max_0);
        Probe_0 _S350 = _S341;
        PreviousSample_0 _S351 = after_sample_0(_S343, _S344, &_S350, _S349);
        float last_step_2;
        if(_S349)
        {
            StepControl_0 _S352 = _S338;
            float _S353 = StepControl_to_cell_exit_0(&_S352, _S341.side_x_0, _S341.side_y_0);
            last_step_2 = (F32_max((_S353), (_S337)));
        }
        else
        {
            StepControl_0 _S354 = _S338;
            Probe_0 _S355 = _S341;
            float _S356 = StepControl_to_next_sample_0(&_S354, &_S355, _S343, _S344);
            last_step_2 = _S356;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S351;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S357, SearchQuality_0 * _S358, float _S359, float _S360, float3  _S361, bool _S362)
{
    Fabric_0 * _S363 = (&(globalParams_0->fabrics_0)[_S357]);
    Sample_0 _S364 = sample_at_0(_S357, _S359, _S360, _S362);
    if(!_S364.shown_3.hole_0)
    {
        return false;
    }
    float3  _S365 = make_float3 (_S359, _S360, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S366;
        if(side_0 < 2U)
        {
            _S366 = passes_0;
        }
        else
        {
            _S366 = false;
        }
        if(_S366)
        {
        }
        else
        {
            break;
        }
        float3  _S367;
        if(side_0 == 0U)
        {
            _S367 = _S361;
        }
        else
        {
            _S367 = make_float3 (- _S361.x, - _S361.y, _S361.z);
        }
        bool _S368 = _S362 != (side_0 == 1U);
        float _S369 = __ldg(&_S363->height_high_0);
        bool _S370 = is_free_0(_S357, _S358, _S365, _S367, _S368, _S369);
        uint _S371 = side_0 + 1U;
        passes_0 = _S370;
        side_0 = _S371;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_6;
    float last_step_3;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

__device__ float max_height_along_0(uint _S372, float _S373, float _S374, float _S375, float3  _S376, bool _S377)
{
    Fabric_0 * _S378 = (&(globalParams_0->fabrics_0)[_S372]);
    uint _S379 = __ldg(&_S378->warp_0);
    uint _S380 = locate_0(_S379, _S373).thread_0 / 2U;
    uint _S381 = __ldg(&_S378->weft_0);
    uint _S382 = locate_0(_S381, _S374).thread_0 / 2U;
    float _S383 = _S376.x;
    uint _S384;
    if(_S383 > 0.0f)
    {
        _S384 = 1U;
    }
    else
    {
        _S384 = 0U;
    }
    float _S385 = _S376.y;
    uint _S386;
    if(_S385 > 0.0f)
    {
        _S386 = 2U;
    }
    else
    {
        _S386 = 0U;
    }
    uint _S387 = _S384 + _S386;
    uint _S388 = __ldg(&_S378->max_heights_0);
    uint _S389 = __ldg(&_S378->max_height_columns_0);
    uint _S390 = __ldg((&(globalParams_0->words_0)[_S388 + 4U * (_S382 * _S389 + _S380) + _S387]));
    int number_0;
    if(_S377)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S391 = _S390 >> number_0;
    float _S392 = (F32_abs((_S383)));
    float _S393 = __ldg(&_S378->threads_per_x_0);
    float _S394 = _S392 * _S393;
    float _S395 = (F32_abs((_S385)));
    float _S396 = __ldg(&_S378->threads_per_y_0);
    float _S397 = (F32_max((_S394), (_S395 * _S396))) / _S376.z;
    float _S398 = __ldg(&_S378->height_high_0);
    float max_height_0 = _S398;
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
        if(((max_height_0 - _S375) * _S397) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S391 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S398)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S399, float _S400, float _S401, bool _S402, bool _S403, bool _S404)
{
    Crossing_0 _S405 = crossing_at_0(_S399, _S400, _S401, _S402);
    Crossing_0 _S406 = _S405;
    float _S407 = cell_maximum_0(_S399, &_S406);
    float _S408;
    if(_S403)
    {
        _S408 = _S405.warp_1.above_0;
    }
    else
    {
        _S408 = _S405.warp_1.below_0;
    }
    float _S409;
    if(_S404)
    {
        _S409 = _S405.weft_1.above_0;
    }
    else
    {
        _S409 = _S405.weft_1.below_0;
    }
    return make_float3 (_S407, _S408, _S409);
}

__device__ float first_sample_height_0(uint _S410, ViewRay_0 * _S411, StepControl_0 * _S412, bool _S413)
{
    float _S414 = max_height_along_0(_S410, _S411->origin_0.x, _S411->origin_0.y, 0.0f, make_float3 (_S411->slope_1.x, _S411->slope_1.y, 1.0f), _S413);
    uint count_2 = 0U;
    float height_7 = _S414;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S415 = ViewRay_at_0(_S411, height_7);
        float3  _S416 = cell_bounds_0(_S410, _S415.x, _S415.y, _S413, _S412->right_0, _S412->up_0);
        float _S417 = height_7 - _S416.x;
        float _S418 = StepControl_to_cell_exit_0(_S412, _S416.y, _S416.z);
        float height_8 = height_7 - clamp_0(_S417, 0.0f, _S418);
        if(_S417 <= _S418)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

__device__ ViewRayEnd_0 search_down_0(uint _S419, ViewRay_0 * _S420, StepControl_0 * _S421, bool _S422)
{
    Fabric_0 * _S423 = (&(globalParams_0->fabrics_0)[_S419]);
    float _S424 = __ldg(&_S423->height_low_0);
    float _S425 = __ldg(&_S423->height_high_0);
    float _S426 = _S424 - (_S425 - _S424);
    ViewRayEnd_0 end_1;
    float _S427 = first_sample_height_0(_S419, _S420, _S421, _S422);
    (&end_1)->height_6 = _S427;
    (&end_1)->last_step_3 = _S421->epsilon_0;
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
        float2  _S428 = ViewRay_at_0(_S420, (&end_1)->height_6);
        Probe_0 _S429 = probe_0(_S419, _S428.x, _S428.y, _S422, _S421->right_0, _S421->up_0);
        float _S430 = (&end_1)->height_6 - _S429.height_1;
        Probe_0 _S431 = _S429;
        float _S432 = ViewRay_rate_0(_S420, &_S431);
        (&end_1)->depth_1 = - _S430;
        (&end_1)->rate_4 = _S432;
        bool _S433;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S433 = !_S429.hole_1;
        }
        else
        {
            _S433 = false;
        }
        bool _S434;
        if(_S433)
        {
            _S434 = ((&(&end_1)->previous_4)->yarn_0) == (_S429.yarn_1);
        }
        else
        {
            _S434 = false;
        }
        (&end_1)->smooth_0 = _S434;
        bool _S435;
        if(!_S429.hole_1)
        {
            _S435 = _S430 <= 0.0f;
        }
        else
        {
            _S435 = false;
        }
        bool _S436;
        if(_S435)
        {
            _S436 = true;
        }
        else
        {
            _S436 = ((&end_1)->height_6) <= _S426;
        }
        if(_S436)
        {
            break;
        }
        PreviousSample_0 _S437 = (&end_1)->previous_4;
        Probe_0 _S438 = _S429;
        float _S439 = way_back_to_dip_0(&_S437, _S430, _S432, (&end_1)->last_step_3, &_S438);
        if(_S439 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S439;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S439;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S440 = StepControl_to_cell_exit_0(_S421, _S429.side_x_0, _S429.side_y_0);
        float _S441 = (F32_min((_S440), ((&end_1)->height_6 - _S429.cell_max_0)));
        Probe_0 _S442 = _S429;
        float _S443 = StepControl_to_next_sample_0(_S421, &_S442, _S430, _S432);
        bool _S444 = _S441 > _S443;
        Probe_0 _S445 = _S429;
        PreviousSample_0 _S446 = after_sample_0(_S430, _S432, &_S445, _S444);
        (&end_1)->previous_4 = _S446;
        float _S447 = (F32_max((_S441), (_S443)));
        (&end_1)->last_step_3 = _S447;
        (&end_1)->height_6 = (&end_1)->height_6 - _S447;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S448, ViewRay_0 * _S449, StepControl_0 * _S450, bool _S451, ViewRayEnd_0 * _S452, uint _S453)
{
    Fabric_0 * _S454 = (&(globalParams_0->fabrics_0)[_S448]);
    float _S455 = __ldg(&_S454->height_high_0);
    float _S456 = __ldg(&_S454->height_low_0);
    float _S457 = _S455 - _S456;
    float _S458 = _S452->height_6;
    float _S459 = _S452->last_step_3;
    float above_2 = _S452->height_6 + _S452->last_step_3;
    float above_gap_1 = clamp_0((&_S452->previous_4)->clearance_0, 0.0f, _S457);
    float under_gap_1 = clamp_0(_S452->depth_1, 0.0f, _S457);
    float _S460 = cubic_root_0(above_gap_1, - under_gap_1, (&_S452->previous_4)->rate_0 * _S452->last_step_3, _S452->rate_4 * _S452->last_step_3);
    bool _S461 = _S452->smooth_0;
    float middle_0;
    if(_S452->smooth_0)
    {
        middle_0 = above_2 - _S460 * _S459;
    }
    else
    {
        middle_0 = between_0(above_2, _S458, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S458;
    float above_3 = above_2;
    uint i_5 = 0U;
    for(;;)
    {
        if(i_5 < _S453)
        {
        }
        else
        {
            break;
        }
        float2  _S462 = ViewRay_at_0(_S449, middle_0);
        Probe_0 _S463 = probe_0(_S448, _S462.x, _S462.y, _S451, _S450->right_0, _S450->up_0);
        float _S464;
        if(_S463.hole_1)
        {
            _S464 = -1.0e+09f;
        }
        else
        {
            _S464 = _S463.height_1;
        }
        float _S465 = clamp_0(middle_0 - _S464, - _S457, _S457);
        float _S466;
        if(_S465 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S466 = 0.5f * above_gap_2;
            }
            else
            {
                _S466 = above_gap_2;
            }
            float _S467 = - _S465;
            under_1 = middle_0;
            above_gap_2 = _S466;
            under_gap_2 = _S467;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S466 = 0.5f * under_gap_2;
            }
            else
            {
                _S466 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S465;
            under_gap_2 = _S466;
            side_1 = -1.0f;
        }
        if(_S461)
        {
            Probe_0 _S468 = _S463;
            float _S469 = ViewRay_rate_0(_S449, &_S468);
            middle_0 = clamp_0(middle_0 + _S465 / (F32_min((_S469), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_5 = i_5 + 1U;
    }
    if(_S461)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S470, SearchQuality_0 * _S471, float _S472, float _S473, float3  _S474, bool _S475)
{
    float _S476 = (F32_max((_S474.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S472, _S473);
    float2  _S477 = float2 {_S474.x, _S474.y} / make_float2 (_S476);
    (&ray_0)->slope_1 = _S477;
    float2  _S478 = - _S477;
    float _S479 = steps_per_length_0(_S470, _S471, _S474);
    StepControl_0 _S480 = step_control_0(_S478, 1.0f / (F32_max((_S479 / _S476), (9.99999971718068537e-10f))));
    ViewRay_0 _S481 = ray_0;
    StepControl_0 _S482 = _S480;
    ViewRayEnd_0 _S483 = search_down_0(_S470, &_S481, &_S482, _S475);
    Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    ViewRay_0 _S484 = ray_0;
    StepControl_0 _S485 = _S480;
    ViewRayEnd_0 _S486 = _S483;
    float _S487 = refined_height_0(_S470, &_S484, &_S485, _S475, &_S486, _S471->refinements_0);
    (&hit_0)->height_4 = _S487;
    ViewRay_0 _S488 = ray_0;
    float2  _S489 = ViewRay_at_0(&_S488, _S487);
    (&hit_0)->x_19 = _S489.x;
    (&hit_0)->y_12 = _S489.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S490, SearchQuality_0 * _S491, float _S492, float _S493, float3  _S494, bool _S495)
{
    bool _S496 = passes_through_0(_S490, _S491, _S492, _S493, _S494, _S495);
    if(!_S496)
    {
        Hit_0 _S497 = first_hit_of_yarn_0(_S490, _S491, _S492, _S493, _S494, _S495);
        return _S497;
    }
    Hit_0 hit_1;
    (&hit_1)->x_19 = _S492;
    (&hit_1)->y_12 = _S493;
    (&hit_1)->height_4 = 0.0f;
    (&hit_1)->hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_2;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_9;
    float3  normal_4;
    float3  tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 surface_at_0(uint _S498, float _S499, float _S500, bool _S501)
{
    Fabric_0 * _S502 = (&(globalParams_0->fabrics_0)[_S498]);
    Sample_0 _S503 = sample_at_0(_S498, _S499, _S500, _S501);
    float _S504;
    if(_S503.shown_3.is_warp_0)
    {
        _S504 = _S503.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S504 = _S503.crossing_1.weft_1.half_width_1;
    }
    uint _S505;
    if(_S503.shown_3.is_warp_0)
    {
        uint _S506 = __ldg(&_S502->warp_0);
        _S505 = _S506;
    }
    else
    {
        uint _S507 = __ldg(&_S502->weft_0);
        _S505 = _S507;
    }
    Family_0 _S508 = slang_ldg_1((&(globalParams_0->families_0)[_S505]));
    float _S509;
    if(_S501)
    {
        _S509 = -1.0f;
    }
    else
    {
        _S509 = 1.0f;
    }
    float _S510 = _S508.twist_sine_0 * _S509;
    Family_0 _S511 = slang_ldg_1((&(globalParams_0->families_0)[_S505]));
    if(_S503.shown_3.is_warp_0)
    {
        _S509 = 1.0f;
    }
    else
    {
        _S509 = -1.0f;
    }
    float2  _S512 = fibre_direction_0(_S503.slope_across_0, _S509 * _S503.slope_along_0, _S510, _S511.twist_cosine_0);
    float _S513;
    if(_S503.shown_3.is_warp_0)
    {
        _S513 = _S503.slope_x_1;
    }
    else
    {
        _S513 = _S503.slope_y_1;
    }
    float _S514;
    if(_S503.shown_3.is_warp_0)
    {
        _S514 = _S503.slope_y_1;
    }
    else
    {
        _S514 = _S503.slope_x_1;
    }
    float _S515 = _S512.x;
    float _S516 = _S512.y;
    float _S517 = _S513 * _S515 + _S509 * _S514 * _S516;
    float _S518 = _S504 * 1.0154266357421875f;
    float _S519 = _S518 * arc_sine_0(clamp_0(_S503.section_1.across_1 / _S518, -1.0f, 1.0f));
    if(_S503.shown_3.is_warp_0)
    {
        _S504 = _S500;
    }
    else
    {
        _S504 = - _S499;
    }
    SurfacePoint_0 point_0;
    (&point_0)->hole_4 = _S503.shown_3.hole_0;
    (&point_0)->is_warp_2 = _S503.shown_3.is_warp_0;
    (&point_0)->warp_thread_0 = _S503.crossing_1.warp_1.thread_0;
    (&point_0)->weft_thread_0 = _S503.crossing_1.weft_1.thread_0;
    (&point_0)->height_9 = _S503.height_5;
    (&point_0)->normal_4 = normalize_0(make_float3 (- _S503.slope_x_1, - _S503.slope_y_1, 1.0f));
    float3  _S520;
    if(_S503.shown_3.is_warp_0)
    {
        _S520 = make_float3 (_S515, _S516, _S517);
    }
    else
    {
        _S520 = make_float3 (- _S516, _S515, _S517);
    }
    (&point_0)->tangent_5 = normalize_0(_S520);
    (&point_0)->across_2 = _S503.section_1.across_1;
    (&point_0)->fibre_across_0 = _S519 * _S511.twist_cosine_0 + _S504 * _S510;
    (&point_0)->fibre_along_0 = _S504 * _S511.twist_cosine_0 - _S519 * _S510;
    return point_0;
}

__device__ Albedos_0 vary_albedos_0(uint _S521, Albedos_0 * _S522, uint _S523, uint _S524)
{
    Fabric_0 * _S525 = (&(globalParams_0->fabrics_0)[_S521]);
    float3  _S526 = _S522->specular_reflect_0;
    float3  _S527 = _S522->specular_transmit_0;
    float3  _S528 = max_0(_S522->specular_reflect_0, _S522->specular_transmit_0);
    float3  _S529 = _S522->diffuse_reflect_0;
    float3  _S530 = _S522->diffuse_transmit_0;
    float3  _S531 = _S522->diffuse_reflect_0 + _S522->diffuse_transmit_0;
    float _S532 = __ldg(&_S525->colour_noise_0);
    uint _S533 = __ldg(&_S525->seed_0);
    float _S534 = thread_gain_0(_S523, _S532, _S533);
    float _S535 = __ldg(&_S525->layer_bound_0);
    float _S536 = bounded_gain_0(_S534, _S531, make_float3 (1.0f) - make_float3 (_S535) * _S528);
    float3  _S537 = min_0((make_float3 (1.0f) - make_float3 (_S536) * _S531) / make_float3 (_S535), make_float3 (1.0f));
    float _S538 = __ldg(&_S525->fibre_noise_0);
    float _S539 = bounded_gain_0(fibre_gain_0(_S523, _S524, _S538, _S533), _S528, _S537);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S536) * _S529;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S536) * _S530;
    (&varied_0)->specular_reflect_0 = make_float3 (_S539) * _S526;
    (&varied_0)->specular_transmit_0 = make_float3 (_S539) * _S527;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S540, SurfacePoint_0 * _S541, Albedos_0 * _S542, float _S543, float _S544)
{
    Fabric_0 * _S545 = (&(globalParams_0->fabrics_0)[_S540]);
    bool _S546 = _S541->is_warp_2;
    float _S547;
    if(_S541->is_warp_2)
    {
        _S547 = _S543;
    }
    else
    {
        _S547 = _S544;
    }
    float _S548 = _S547 - _S541->across_2;
    uint _S549;
    if(_S546)
    {
        uint _S550 = __ldg(&_S545->warp_0);
        _S549 = _S550;
    }
    else
    {
        uint _S551 = __ldg(&_S545->weft_0);
        _S549 = _S551;
    }
    Family_0 _S552 = slang_ldg_1((&(globalParams_0->families_0)[_S549]));
    Family_0 _S553 = slang_ldg_1((&(globalParams_0->families_0)[_S549]));
    int _S554 = int(_S553.count_0);
    if(_S546)
    {
        _S549 = _S541->warp_thread_0;
    }
    else
    {
        _S549 = _S541->weft_thread_0;
    }
    uint _S555 = uint(int((F32_floor((_S548 / _S552.period_0)))) * _S554 + int(_S549)) * 2U;
    if(_S546)
    {
        _S549 = 1U;
    }
    else
    {
        _S549 = 0U;
    }
    uint _S556 = _S555 + _S549;
    float _S557 = _S541->fibre_across_0;
    float _S558 = __ldg(&_S545->fibre_size_0);
    float _S559 = (F32_floor((_S557 / _S558)));
    Albedos_0 _S560 = vary_albedos_0(_S540, _S542, _S556, uint(int(_S559)) * 65536U + uint(int((F32_floor((_S541->fibre_along_0 / (_S558 * 40.0f) + 0.61799997091293335f * _S559))))));
    return _S560;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S561, SurfacePoint_0 * _S562, float _S563, float _S564, bool _S565, bool _S566)
{
    Fabric_0 * _S567 = (&(globalParams_0->fabrics_0)[_S561]);
    bool _S568 = _S562->is_warp_2;
    uint _S569;
    if(_S562->is_warp_2)
    {
        uint _S570 = __ldg(&_S567->warp_0);
        _S569 = _S570;
    }
    else
    {
        uint _S571 = __ldg(&_S567->weft_0);
        _S569 = _S571;
    }
    uint _S572;
    if(_S568)
    {
        _S572 = _S562->warp_thread_0;
    }
    else
    {
        _S572 = _S562->weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S569, _S572);
    float _S573 = __ldg(&_S567->fibre_noise_0);
    bool _S574;
    if(_S573 > 0.0f)
    {
        _S574 = true;
    }
    else
    {
        float _S575 = __ldg(&_S567->colour_noise_0);
        _S574 = _S575 > 0.0f;
    }
    Albedos_0 albedos_3;
    if(_S574)
    {
        Albedos_0 _S576 = albedos_2;
        Albedos_0 _S577 = varied_at_0(_S561, _S562, &_S576, _S563, _S564);
        albedos_3 = _S577;
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_1;
    (&point_1)->back_3 = _S565;
    (&point_1)->hole_2 = _S566;
    (&point_1)->is_warp_1 = _S568;
    (&point_1)->x_18 = _S563;
    (&point_1)->y_11 = _S564;
    (&point_1)->height_3 = _S562->height_9;
    (&point_1)->normal_3 = _S562->normal_4;
    (&point_1)->tangent_4 = _S562->tangent_5;
    Family_0 _S578 = slang_ldg_1((&(globalParams_0->families_0)[_S569]));
    (&point_1)->roughness_8 = _S578.roughness_0;
    (&point_1)->albedos_1 = albedos_3;
    return point_1;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S579, SearchQuality_0 * _S580, float _S581, float _S582, float3  _S583)
{
    bool _S584 = (_S583.z) < 0.0f;
    Hit_0 _S585 = first_hit_0(_S579, _S580, _S581, _S582, to_face_frame_0(_S583, _S584), _S584);
    SurfacePoint_0 _S586 = surface_at_0(_S579, _S585.x_19, _S585.y_12, _S584);
    SurfacePoint_0 _S587 = _S586;
    YarnPoint_0 _S588 = yarn_point_of_0(_S579, &_S587, _S585.x_19, _S585.y_12, _S584, _S585.hole_3);
    return _S588;
}

__device__ float3  scattered_0(uint _S589, YarnPoint_0 * _S590, float3  _S591, float3  _S592)
{
    Fabric_0 * _S593 = (&(globalParams_0->fabrics_0)[_S589]);
    float3  _S594 = make_float3 (0.0f);
    bool _S595 = !_S590->hole_2;
    bool _S596;
    if(_S595)
    {
        _S596 = (_S591.z) > 0.0f;
    }
    else
    {
        _S596 = false;
    }
    float3  value_1;
    if(_S596)
    {
        float3  _S597 = (&_S590->albedos_1)->diffuse_reflect_0;
        float3  _S598 = _S590->normal_3;
        float _S599 = __ldg(&_S593->diffuse_blend_0);
        float3  _S600 = _S597 * make_float3 (diffuse_reflection_0(_S591, _S598, _S599));
        float3  _S601 = (&_S590->albedos_1)->specular_reflect_0;
        float3  _S602 = _S590->tangent_4;
        float _S603 = _S590->roughness_8;
        float _S604 = __ldg(&_S593->optical_depth_0);
        value_1 = _S600 + _S601 * make_float3 (reflection_0(_S591, _S592, _S598, _S602, _S603, _S604));
    }
    else
    {
        if(_S595)
        {
            _S596 = (_S591.z) < 0.0f;
        }
        else
        {
            _S596 = false;
        }
        if(_S596)
        {
            float3  _S605 = (&_S590->albedos_1)->diffuse_transmit_0;
            float3  _S606 = - _S591;
            float3  _S607 = _S590->normal_3;
            float _S608 = __ldg(&_S593->diffuse_blend_0);
            float3  _S609 = _S605 * make_float3 (diffuse_reflection_0(_S606, _S607, _S608));
            float3  _S610 = (&_S590->albedos_1)->specular_transmit_0;
            float3  _S611 = _S590->tangent_4;
            float _S612 = _S590->roughness_8;
            float _S613 = __ldg(&_S593->optical_depth_0);
            value_1 = _S609 + _S610 * make_float3 (transmission_0(_S591, _S592, _S607, _S611, _S612, _S613));
        }
        else
        {
            value_1 = _S594;
        }
    }
    float _S614 = __ldg(&_S593->sheen_strength_0);
    if(_S614 <= 0.0f)
    {
        return value_1;
    }
    float _S615 = __ldg(&_S593->sheen_roughness_0);
    float2  _S616 = sheen_with_transmittance_0(_S591, _S592, _S614, _S615);
    return make_float3 (_S616.y) * value_1 + make_float3 (_S616.x);
}

__device__ bool unoccluded_0(uint _S617, SearchQuality_0 * _S618, float _S619, float _S620, float _S621, float3  _S622, bool _S623)
{
    Fabric_0 * _S624 = (&(globalParams_0->fabrics_0)[_S617]);
    if((_S622.z) <= 0.0f)
    {
        return false;
    }
    float _S625 = max_height_along_0(_S617, _S619, _S620, _S621, _S622, _S623);
    float _S626 = __ldg(&_S624->lift_0);
    bool _S627 = is_free_0(_S617, _S618, make_float3 (_S619, _S620, _S621 + _S626), _S622, _S623, _S625);
    return _S627;
}

__device__ bool is_lit_0(uint _S628, SearchQuality_0 * _S629, YarnPoint_0 * _S630, float3  _S631)
{
    if(_S630->hole_2)
    {
        return true;
    }
    bool _S632 = _S630->back_3;
    float3  _S633 = to_face_frame_0(_S631, _S630->back_3);
    float _S634 = _S633.z;
    bool _S635 = _S634 < 0.0f;
    float3  _S636 = _S630->normal_3;
    float _S637 = _S630->height_3;
    float3  normal_5;
    float height_10;
    if(_S635)
    {
        SurfacePoint_0 _S638 = surface_at_0(_S628, _S630->x_18, _S630->y_11, !_S632);
        normal_5 = _S638.normal_4;
        height_10 = _S638.height_9;
    }
    else
    {
        normal_5 = _S636;
        height_10 = _S637;
    }
    float3  _S639 = make_float3 (float2 {_S633.x, _S633.y}.x, float2 {_S633.x, _S633.y}.y, (F32_abs((_S634))));
    if((dot_0(normal_5, _S639)) <= 0.0f)
    {
        return false;
    }
    bool _S640 = unoccluded_0(_S628, _S629, _S630->x_18, _S630->y_11, height_10, _S639, _S632 != _S635);
    return _S640;
}

__device__ float3  evaluate_0(uint _S641, SearchQuality_0 * _S642, YarnPoint_0 * _S643, float3  _S644, float3  _S645)
{
    float3  _S646 = scattered_0(_S641, _S643, to_face_frame_0(_S644, _S643->back_3), to_face_frame_0(_S645, _S643->back_3));
    bool _S647;
    if((F32_max((_S646.x), ((F32_max((_S646.y), (_S646.z)))))) <= 0.0f)
    {
        _S647 = true;
    }
    else
    {
        bool _S648 = is_lit_0(_S641, _S642, _S643, _S644);
        _S647 = !_S648;
    }
    if(_S647)
    {
        return make_float3 (0.0f);
    }
    return _S646;
}

__device__ float straight_through_0(uint _S649, YarnPoint_0 * _S650, float3  _S651)
{
    Fabric_0 * _S652 = (&(globalParams_0->fabrics_0)[_S649]);
    if(!_S650->hole_2)
    {
        return 0.0f;
    }
    float _S653 = __ldg(&_S652->sheen_strength_0);
    if(_S653 <= 0.0f)
    {
        return 1.0f;
    }
    float _S654 = (F32_abs((_S651.z)));
    float _S655 = __ldg(&_S652->sheen_roughness_0);
    return 1.0f - _S653 * sheen_lobe_0(_S654, _S655).z;
}

__device__ float4  cloth_value_0(uint fabric_2, float2  centre_0, float2  dx_0, float2  dy_0, float3  light_6, float3  view_5)
{
    SearchQuality_0 _S656 = default_quality_0();
    float _S657 = centre_0.x;
    float _S658 = centre_0.y;
    SearchQuality_0 _S659 = _S656;
    YarnPoint_0 _S660 = locate_yarn_0(fabric_2, &_S659, _S657, _S658, view_5);
    SearchQuality_0 _S661 = _S656;
    YarnPoint_0 _S662 = _S660;
    float3  _S663 = evaluate_0(fabric_2, &_S661, &_S662, light_6, view_5);
    YarnPoint_0 _S664 = _S660;
    float _S665 = straight_through_0(fabric_2, &_S664, view_5);
    return make_float4 (_S663.x, _S663.y, _S663.z, _S665);
}

extern "C" __global__ void point_queries()
{
    uint _S666 = (blockIdx * blockDim + threadIdx).x;
    uint _S667 = __ldg((&(globalParams_0->query_count_0)[int(0)]));
    if(_S666 >= _S667)
    {
        return;
    }
    Query_0 _S668 = slang_ldg_0((&(globalParams_0->queries_0)[_S666]));
    *(&(globalParams_0->answers_0)[_S666]) = cloth_value_0(_S668.fabric_1, make_float2 (_S668.centre_x_0, _S668.centre_y_0), make_float2 (_S668.dx_x_0, _S668.dx_y_0), make_float2 (_S668.dy_x_0, _S668.dy_y_0), make_float3 (_S668.light_x_0, _S668.light_y_0, _S668.light_z_0), make_float3 (_S668.view_x_0, _S668.view_y_0, _S668.view_z_0));
    return;
}

