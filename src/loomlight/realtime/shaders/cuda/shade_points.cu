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

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    uint run_words_0;
    uint ends_0;
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

struct Bake_0
{
    uint fabric_0;
    uint per_family_0;
    uint packs_1;
    uint max_clusters_0;
    uint rays_0;
    float ends_1;
    float picks_0;
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

__device__ float3  normalize_0(float3  x_8)
{
    return x_8 / make_float3 (length_0(x_8));
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

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float2  frac_0(float2  x_11)
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
        *_slang_vector_get_element_ptr(&result_6, i_4) = (F32_frac((_slang_vector_get_element(x_11, i_4))));
        i_4 = i_4 + int(1);
    }
    return result_6;
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

__device__ Frame_0 slang_ldg_0(Frame_0 * ptr_0)
{
    uint _S7 = __ldg(&ptr_0->width_0);
    uint _S8 = __ldg(&ptr_0->height_0);
    uint _S9 = __ldg(&ptr_0->lights_0);
    uint _S10 = __ldg(&ptr_0->samples_0);
    uint _S11 = __ldg(&ptr_0->pass_number_0);
    float _S12 = __ldg(&ptr_0->jitter_x_0);
    float _S13 = __ldg(&ptr_0->jitter_y_0);
    float _S14 = __ldg(&ptr_0->gain_0);
    float _S15 = __ldg(&ptr_0->origin_x_0);
    float _S16 = __ldg(&ptr_0->origin_y_0);
    float _S17 = __ldg(&ptr_0->origin_z_0);
    float _S18 = __ldg(&ptr_0->right_x_0);
    float _S19 = __ldg(&ptr_0->right_y_0);
    float _S20 = __ldg(&ptr_0->right_z_0);
    float _S21 = __ldg(&ptr_0->up_x_0);
    float _S22 = __ldg(&ptr_0->up_y_0);
    float _S23 = __ldg(&ptr_0->up_z_0);
    float _S24 = __ldg(&ptr_0->forward_x_0);
    float _S25 = __ldg(&ptr_0->forward_y_0);
    float _S26 = __ldg(&ptr_0->forward_z_0);
    float _S27 = __ldg(&ptr_0->near_0);
    float _S28 = __ldg(&ptr_0->background_red_0);
    float _S29 = __ldg(&ptr_0->background_green_0);
    float _S30 = __ldg(&ptr_0->background_blue_0);
    Frame_0 _S31 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24, _S25, _S26, _S27, _S28, _S29, _S30 };
    return _S31;
}

__device__ Vertex_0 slang_ldg_1(Vertex_0 * ptr_1)
{
    float _S32 = __ldg(&ptr_1->x_1);
    float _S33 = __ldg(&ptr_1->y_1);
    float _S34 = __ldg(&ptr_1->z_1);
    float _S35 = __ldg(&ptr_1->normal_x_0);
    float _S36 = __ldg(&ptr_1->normal_y_0);
    float _S37 = __ldg(&ptr_1->normal_z_0);
    float _S38 = __ldg(&ptr_1->u_0);
    float _S39 = __ldg(&ptr_1->v_0);
    Vertex_0 _S40 = { _S32, _S33, _S34, _S35, _S36, _S37, _S38, _S39 };
    return _S40;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_0(v_1, v_1);
}

__device__ float3  camera_right_0(Frame_0 * frame_0)
{
    return make_float3 (frame_0->right_x_0, frame_0->right_y_0, frame_0->right_z_0);
}

__device__ float3  camera_up_0(Frame_0 * frame_1)
{
    return make_float3 (frame_1->up_x_0, frame_1->up_y_0, frame_1->up_z_0);
}

__device__ float3  camera_forward_0(Frame_0 * frame_2)
{
    return make_float3 (frame_2->forward_x_0, frame_2->forward_y_0, frame_2->forward_z_0);
}

__device__ float3  camera_origin_0(Frame_0 * frame_3)
{
    return make_float3 (frame_3->origin_x_0, frame_3->origin_y_0, frame_3->origin_z_0);
}

__device__ float3  normal_of_0(Vertex_0 * vertex_1)
{
    return make_float3 (vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

__device__ uint scramble_0(uint value_0)
{
    uint _S41 = value_0 * 747796405U + 2891336453U;
    uint _S42 = ((_S41 >> ((_S41 >> int(28)) + 4U)) ^ _S41) * 277803737U;
    return (_S42 >> int(22)) ^ _S42;
}

__device__ float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  footprint_sample_0(uint2  pixel_0, uint index_0)
{
    uint _S43 = pixel_0.x;
    uint _S44 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S43, _S44, 1U), uniform_hash_0(_S43, _S44, 2U)) + make_float2 (float(index_0 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f)) - make_float2 (0.5f);
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

struct VisiblePoint_0
{
    float3  position_0;
    float3  view_0;
    float3  axis_x_0;
    float3  axis_y_0;
    float3  normal_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_0)
{
    return make_float3 (dot_0(direction_0, point_0->axis_x_0), dot_0(direction_0, point_0->axis_y_0), dot_0(direction_0, point_0->normal_0));
}

__device__ float3  to_face_frame_0(float3  direction_1, bool back_0)
{
    float2  _S45 = float2 {direction_1.x, direction_1.y};
    float _S46;
    if(back_0)
    {
        _S46 = - direction_1.z;
    }
    else
    {
        _S46 = direction_1.z;
    }
    return make_float3 (_S45.x, _S45.y, _S46);
}

__device__ Family_0 slang_ldg_2(Family_0 * ptr_2)
{
    uint _S47 = __ldg(&ptr_2->is_alike_0);
    float _S48 = __ldg(&ptr_2->count_0);
    float _S49 = __ldg(&ptr_2->inverse_count_0);
    float _S50 = __ldg(&ptr_2->half_inverse_count_0);
    float _S51 = __ldg(&ptr_2->size_0);
    float _S52 = __ldg(&ptr_2->inverse_size_0);
    float _S53 = __ldg(&ptr_2->half_width_0);
    float _S54 = __ldg(&ptr_2->start_0);
    float _S55 = __ldg(&ptr_2->period_0);
    float _S56 = __ldg(&ptr_2->inverse_period_0);
    float _S57 = __ldg(&ptr_2->bins_0);
    uint _S58 = __ldg(&ptr_2->first_thread_table_0);
    uint _S59 = __ldg(&ptr_2->place_table_0);
    uint _S60 = __ldg(&ptr_2->bend_table_0);
    float _S61 = __ldg(&ptr_2->height_scale_0);
    float _S62 = __ldg(&ptr_2->twist_sine_0);
    float _S63 = __ldg(&ptr_2->twist_cosine_0);
    float _S64 = __ldg(&ptr_2->level_0);
    float _S65 = __ldg(&ptr_2->roughness_0);
    uint _S66 = __ldg(&ptr_2->albedo_table_0);
    uint _S67 = __ldg(&ptr_2->albedo_stride_0);
    uint _S68 = __ldg(&ptr_2->before_0);
    float _S69 = __ldg(&ptr_2->visible_total_0);
    float _S70 = __ldg(&ptr_2->smallest_box_0);
    uint _S71 = __ldg(&ptr_2->quantities_0);
    uint _S72 = __ldg(&ptr_2->colour_mean_0);
    uint _S73 = __ldg(&ptr_2->colour_axes_0);
    uint _S74 = __ldg(&ptr_2->colour_threads_0);
    uint _S75 = __ldg(&ptr_2->colour_areas_0);
    float _S76 = __ldg(&ptr_2->area_unit_0);
    float _S77 = __ldg(&ptr_2->crossing_area_0);
    Family_0 _S78 = { _S47, _S48, _S49, _S50, _S51, _S52, _S53, _S54, _S55, _S56, _S57, _S58, _S59, _S60, _S61, _S62, _S63, _S64, _S65, _S66, _S67, _S68, _S69, _S70, _S71, _S72, _S73, _S74, _S75, _S76, _S77 };
    return _S78;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_1)
{
    Family_0 _S79 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    Family_0 _S80 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    float _S81 = (F32_floor(((F32_fma((index_1), (_S79.inverse_count_0), (_S80.half_inverse_count_0))))));
    float _S82 = - _S81;
    Family_0 _S83 = slang_ldg_2((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S81, (F32_fma((_S82), (_S83.count_0), (index_1))));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

__device__ Cell_0 locate_alike_0(uint family_1, float position_1)
{
    Family_0 _S84 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S85 = (F32_floor((position_1 * _S84.inverse_size_0)));
    Cell_0 cell_1;
    float _S86 = - _S85;
    Family_0 _S87 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    float _S88 = (F32_fma((_S86), (_S87.size_0), (position_1)));
    (&cell_1)->below_0 = _S88;
    Family_0 _S89 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->above_0 = _S89.size_0 - _S88;
    Family_0 _S90 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->across_0 = _S88 - 0.5f * _S90.size_0;
    Family_0 _S91 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->half_width_1 = _S91.half_width_0;
    float _S92 = turns_and_remainder_0(family_1, _S85).y;
    Family_0 _S93 = slang_ldg_2((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->thread_1 = uint(clamp_0(_S92, 0.0f, _S93.count_0 - 1.0f));
    return cell_1;
}

__device__ float table_number_0(uint index_2)
{
    uint _S94 = __ldg((&(globalParams_0->words_0)[index_2]));
    return (U32_asfloat((_S94)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_2)
{
    Family_0 _S95 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S96 = position_2 - _S95.start_0;
    Family_0 _S97 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S96 * _S97.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S98 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S99 = turns_1 * _S98.period_0;
    Family_0 _S100 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    float _S101 = turns_1 * _S100.bins_0;
    Family_0 _S102 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S103 = uint(clamp_0(_S101, 0.0f, _S102.bins_0 - 1.0f));
    Family_0 _S104 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S105 = __ldg((&(globalParams_0->words_0)[_S104.first_thread_table_0 + _S103]));
    Family_0 _S106 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S107;
    if(_S99 >= (table_number_0(_S106.place_table_0 + _S105 * 4U + 1U)))
    {
        _S107 = 1U;
    }
    else
    {
        _S107 = 0U;
    }
    uint _S108 = _S105 + _S107;
    Family_0 _S109 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S110 = (U32_min((_S108), (uint(_S109.count_0) - 1U)));
    Family_0 _S111 = slang_ldg_2((&(globalParams_0->families_0)[family_2]));
    uint _S112 = _S111.place_table_0 + _S110 * 4U;
    Cell_0 cell_2;
    (&cell_2)->thread_1 = _S110;
    (&cell_2)->below_0 = _S99 - table_number_0(_S112);
    (&cell_2)->above_0 = table_number_0(_S112 + 1U) - _S99;
    (&cell_2)->across_0 = _S99 - table_number_0(_S112 + 2U);
    (&cell_2)->half_width_1 = table_number_0(_S112 + 3U);
    return cell_2;
}

__device__ Cell_0 locate_0(uint family_3, float position_3)
{
    Family_0 _S113 = slang_ldg_2((&(globalParams_0->families_0)[family_3]));
    if((_S113.is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
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

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_1)
{
    bool _S114 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S115 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S116;
    if(_S114)
    {
        if(!_S115)
        {
            _S116 = true;
        }
        else
        {
            _S116 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S116 = false;
    }
    (&shown_0)->is_warp_0 = _S116;
    if(!_S114)
    {
        _S116 = !_S115;
    }
    else
    {
        _S116 = false;
    }
    (&shown_0)->hole_0 = _S116;
    uint _S117;
    if((&shown_0)->is_warp_0)
    {
        _S117 = crossing_0->warp_word_0;
    }
    else
    {
        _S117 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S117;
    (&shown_0)->on_top_0 = ((_S117 & 1U) == 1U) != back_1;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_3;
    uint _S118;
    if(is_first_0)
    {
        _S118 = first_0->thread_1;
    }
    else
    {
        _S118 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S118;
    float _S119;
    if(is_first_0)
    {
        _S119 = first_0->across_0;
    }
    else
    {
        _S119 = second_0->across_0;
    }
    (&cell_3)->across_0 = _S119;
    if(is_first_0)
    {
        _S119 = first_0->half_width_1;
    }
    else
    {
        _S119 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S119;
    if(is_first_0)
    {
        _S119 = first_0->below_0;
    }
    else
    {
        _S119 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S119;
    if(is_first_0)
    {
        _S119 = first_0->above_0;
    }
    else
    {
        _S119 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S119;
    return cell_3;
}

__device__ float boundary_0(uint family_4, uint thread_2, int step_0)
{
    float2  _S120 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    float _S121 = _S120.x;
    Family_0 _S122 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    Family_0 _S123 = slang_ldg_2((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S121), (_S122.period_0), (table_number_0(_S123.place_table_0 + uint(_S120.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_3, int first_1, int last_0)
{
    Family_0 _S124 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
    if((_S124.is_alike_0) != 0U)
    {
        float _S125 = float(last_0 - first_1);
        Family_0 _S126 = slang_ldg_2((&(globalParams_0->families_0)[family_5]));
        return _S125 * _S126.size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(uint family_6, uint thread_4)
{
    Family_0 _S127 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    Family_0 _S128 = slang_ldg_2((&(globalParams_0->families_0)[family_6]));
    uint _S129;
    if((_S128.is_alike_0) != 0U)
    {
        _S129 = 0U;
    }
    else
    {
        _S129 = thread_4 * 4U;
    }
    uint _S130 = _S127.bend_table_0 + _S129;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S130);
    (&bend_0)->half_tangent_0 = table_number_0(_S130 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S130 + 2U);
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

__device__ Run_0 unpack_0(uint own_0, uint other_0, uint thread_5, Cell_0 * crossed_0, uint word_1)
{
    int _S131 = int((word_1 >> int(1)) & 127U);
    int _S132 = int((word_1 >> int(8)) & 127U);
    int _S133 = int((word_1 >> int(15)) & 63U);
    int _S134 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S135 = crossed_0->thread_1;
    int _S136 = - _S131;
    float _S137 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_1, _S136, int(0));
    (&run_0)->from_start_0 = _S137;
    int _S138 = _S132 + int(1);
    float _S139 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_1, int(1), _S138);
    (&run_0)->to_end_0 = _S139;
    bool _S140 = _S137 < _S139;
    (&run_0)->near_start_0 = _S140;
    int _S141;
    if(_S140)
    {
        _S141 = _S136 - _S133;
    }
    else
    {
        _S141 = _S138;
    }
    int _S142;
    if((&run_0)->near_start_0)
    {
        _S142 = _S136;
    }
    else
    {
        _S142 = _S138 + _S134;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_5);
    float _S143;
    if((&run_0)->straight_0)
    {
        _S143 = 1.0e+06f;
    }
    else
    {
        _S143 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S143;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S135, _S141, _S142)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S131 == int(0);
    (&run_0)->last_crossing_0 = _S132 == int(0);
    return run_0;
}

__device__ float square_1(float x_12)
{
    return x_12 * x_12;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_4)
{
    float _S144 = cell_4->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S145 = clamp_0(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_1 = _S145;
    float _S146 = _S144 * _S144 - square_1(_S145);
    float _S147 = (F32_rsqrt((_S146)));
    (&section_0)->drop_0 = _S144 - _S146 * _S147;
    (&section_0)->slope_0 = - _S145 * _S147;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    Family_0 _S148 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    if((_S148.is_alike_0) != 0U)
    {
        Family_0 _S149 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S149.bend_table_0 + 3U);
    }
    Family_0 _S150 = slang_ldg_2((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S150.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S151 = crossed_1->below_0;
    float _S152 = crossed_1->above_0;
    bool _S153 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S154 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S155;
    if(_S153)
    {
        _S155 = _S151 - crossed_1->across_0;
    }
    else
    {
        _S155 = _S152 + crossed_1->across_0;
    }
    float _S156 = _S155 - crossed_1->half_width_1;
    bool _S157;
    if(_S153)
    {
        _S157 = run_1->first_crossing_0;
    }
    else
    {
        _S157 = run_1->last_crossing_0;
    }
    bool _S158 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S155 = 0.0f;
    }
    else
    {
        Family_0 _S159 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        _S155 = _S159.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_1, int(0));
    }
    float _S160;
    if(_S158 != _S157)
    {
        _S160 = 0.0f;
    }
    else
    {
        Family_0 _S161 = slang_ldg_2((&(globalParams_0->families_0)[other_1]));
        uint _S162 = crossed_1->thread_1;
        int _S163;
        if(_S153)
        {
            _S163 = int(-1);
        }
        else
        {
            _S163 = int(1);
        }
        _S160 = _S161.height_scale_0 * edge_drop_0(other_1, _S162, _S163);
    }
    float _S164 = 1.0f / (F32_max((2.0f * _S156), (9.999999960041972e-13f)));
    float _S165 = clamp_0((_S156 - _S154) * _S164, 0.0f, 1.0f);
    float _S166 = _S155 + (_S160 - _S155) * (_S165 * _S165 * (3.0f - 2.0f * _S165));
    float _S167 = (_S155 - _S160) * (6.0f * _S165 * (1.0f - _S165) * _S164);
    if(_S153)
    {
        _S155 = 1.0f;
    }
    else
    {
        _S155 = -1.0f;
    }
    return make_float2 (_S166, _S167 * _S155);
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

__device__ StepControl_0 step_control_0(float2  direction_2, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S168 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S168)))), (9.99999971718068537e-10f)));
    float _S169 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S169)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S168 > 0.0f;
    (&control_0)->up_0 = _S169 > 0.0f;
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

__device__ float outline_distance_0(Cell_0 * cell_5, Shown_0 * shown_2, Run_0 * run_2, bool lengthwise_0, bool forwards_0)
{
    float _S170;
    if(forwards_0)
    {
        _S170 = cell_5->across_0;
    }
    else
    {
        _S170 = - cell_5->across_0;
    }
    float _S171;
    if(forwards_0)
    {
        _S171 = cell_5->above_0;
    }
    else
    {
        _S171 = cell_5->below_0;
    }
    bool _S172;
    if(forwards_0)
    {
        _S172 = run_2->last_crossing_0;
    }
    else
    {
        _S172 = run_2->first_crossing_0;
    }
    bool _S173;
    if(forwards_0)
    {
        _S173 = run_2->first_crossing_0;
    }
    else
    {
        _S173 = run_2->last_crossing_0;
    }
    float _S174 = cell_5->half_width_1;
    float _S175 = - cell_5->half_width_1;
    bool _S176 = _S170 < _S175;
    bool _S177 = _S170 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S172 = !_S172;
    }
    else
    {
        _S172 = false;
    }
    if(_S172)
    {
        _S172 = !shown_2->hole_0;
    }
    else
    {
        _S172 = false;
    }
    bool _S178;
    if(_S172)
    {
        _S178 = shown_2->on_top_0;
    }
    else
    {
        _S178 = false;
    }
    if(_S178)
    {
        if(_S173)
        {
            _S173 = _S176;
        }
        else
        {
            _S173 = false;
        }
        _S173 = !_S173;
    }
    else
    {
        _S173 = false;
    }
    if(shown_2->hole_0)
    {
        _S172 = true;
    }
    else
    {
        if(_S172)
        {
            _S172 = !shown_2->on_top_0;
        }
        else
        {
            _S172 = false;
        }
    }
    float _S179;
    if(_S176)
    {
        _S179 = _S175;
    }
    else
    {
        _S179 = _S174;
    }
    float _S180 = _S179 - _S170;
    if(_S172)
    {
        _S170 = 2.0f * _S171 + _S170 - _S174;
    }
    else
    {
        _S170 = _S171;
    }
    if(_S173)
    {
        if(forwards_0)
        {
            _S170 = run_2->to_end_0;
        }
        else
        {
            _S170 = run_2->from_start_0;
        }
        return _S170;
    }
    if(_S177)
    {
    }
    else
    {
        _S170 = _S180;
    }
    return _S170;
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
    float _S181 = previous_1->rate_0;
    float _S182 = previous_1->rate_0 * step_4;
    float _S183 = rate_1 * step_4;
    bool _S184;
    if(!previous_1->known_0)
    {
        _S184 = true;
    }
    else
    {
        _S184 = here_0->hole_1;
    }
    if(_S184)
    {
        _S184 = true;
    }
    else
    {
        _S184 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S184)
    {
        _S184 = true;
    }
    else
    {
        _S184 = _S181 >= 0.0f;
    }
    if(_S184)
    {
        _S184 = true;
    }
    else
    {
        _S184 = rate_1 <= 0.0f;
    }
    if(_S184)
    {
        return -1.0f;
    }
    float _S185 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S182) >= 0.0f)
    {
        _S184 = (3.0f * clearance_1 - _S183) >= 0.0f;
    }
    else
    {
        _S184 = false;
    }
    if(_S184)
    {
        return -1.0f;
    }
    float _S186 = clearance_1 - _S185;
    float _S187 = 6.0f * _S186 - 4.0f * _S182 - 2.0f * _S183;
    float _S188 = -2.0f * _S182 / (F32_max((_S187 + (F32_sqrt(((F32_max((_S187 * _S187 - 4.0f * (3.0f * (_S182 + _S183 - 2.0f * _S186)) * _S182), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S189 = 1.0f - _S188;
    float _S190 = (_S185 * (2.0f * _S188 + 1.0f) + _S182 * _S188) * _S189 * _S189;
    float _S191 = (clearance_1 * (2.0f * _S189 + 1.0f) - _S183 * _S189) * _S188 * _S188;
    if(_S188 > 0.01999999955296516f)
    {
        _S184 = _S189 > 0.01999999955296516f;
    }
    else
    {
        _S184 = false;
    }
    if(_S184)
    {
        _S184 = (_S190 + _S191) < 0.0f;
    }
    else
    {
        _S184 = false;
    }
    float _S192;
    if(_S184)
    {
        _S192 = _S189 * step_4;
    }
    else
    {
        _S192 = -1.0f;
    }
    return _S192;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S193 = here_1->hole_1;
    float _S194;
    if(here_1->hole_1)
    {
        _S194 = 1.0e+09f;
    }
    else
    {
        _S194 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S194;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S195;
    if(!_S193)
    {
        _S195 = !is_cell_exit_0;
    }
    else
    {
        _S195 = false;
    }
    (&previous_2)->known_0 = _S195;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_0, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_0->per_x_0), (side_y_1 * this_0->per_y_0)))), (0.0f))) + this_0->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_1, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S196 = (F32_min((here_2->edge_x_0 * this_1->per_x_0), (here_2->edge_y_0 * this_1->per_y_0)));
    bool _S197;
    if(!here_2->hole_1)
    {
        _S197 = (rate_3 * _S196 + clearance_3) < 0.0f;
    }
    else
    {
        _S197 = false;
    }
    if(_S197)
    {
        _S197 = _S196 > (2.0f * this_1->epsilon_0);
    }
    else
    {
        _S197 = false;
    }
    float _S198 = this_1->step_2;
    float _S199;
    if(_S197)
    {
        _S199 = _S196 - this_1->epsilon_0;
    }
    else
    {
        _S199 = (F32_max((_S196), (0.0f))) + this_1->epsilon_0;
    }
    return (F32_min((_S198), (_S199)));
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
    float _S200 = end_0 - start_1;
    float _S201 = start_rate_0 + end_rate_0 - 2.0f * _S200;
    float _S202 = 3.0f * _S200 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / (F32_max((- _S200), (9.99999968265522539e-21f)));
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
        float _S203 = clamp_0(share_0 - (((_S201 * share_0 + _S202) * share_0 + start_rate_0) * share_0 + start_1) / (F32_min(((3.0f * _S201 * share_0 + 2.0f * _S202) * share_0 + start_rate_0), (0.10000000149011612f * _S200 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S204 = i_5 + int(1);
        share_0 = _S203;
        i_5 = _S204;
    }
    return share_0;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S205 = along_slope_0 * along_slope_0 + 1.0f;
    float _S206 = (F32_rsqrt((_S205)));
    float _S207 = sine_1 * _S206 * (F32_rsqrt((_S205 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S207 * _S205, _S207 * across_slope_0 * along_slope_0 + cosine_0 * _S206);
}

__device__ float arc_sine_0(float x_13)
{
    float _S208 = (F32_abs((x_13)));
    bool _S209 = _S208 > 0.5f;
    float _S210;
    if(_S209)
    {
        _S210 = 0.5f * (1.0f - _S208);
    }
    else
    {
        _S210 = _S208 * _S208;
    }
    float _S211;
    if(_S209)
    {
        _S211 = (F32_sqrt(((F32_max((_S210), (0.0f))))));
    }
    else
    {
        _S211 = _S208;
    }
    float _S212 = ((((0.04216320067644119f * _S210 + 0.02418131195008755f) * _S210 + 0.04547002539038658f) * _S210 + 0.07495300471782684f) * _S210 + 0.16666752099990845f) * _S210 * _S211 + _S211;
    if(_S209)
    {
        _S210 = 1.57079637050628662f - 2.0f * _S212;
    }
    else
    {
        _S210 = _S212;
    }
    if(x_13 < 0.0f)
    {
        _S210 = - _S210;
    }
    return _S210;
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
    Family_0 _S213 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    Family_0 _S214 = slang_ldg_2((&(globalParams_0->families_0)[family_8]));
    return table_albedos_0(_S213.albedo_table_0 + _S214.albedo_stride_0 * thread_7);
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_0, float3  room_0)
{
    float3  _S215 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S215.x), (_S215.y)))), (_S215.z)))), (0.0f))))));
}

__device__ float natural_logarithm_0(float x_14)
{
    uint _S216 = (F32_asuint((x_14)));
    float exponent_0 = float(int(_S216 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S216 & 8388607U) | 1056964608U)));
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
    float _S217 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S217 - exponent_1 * 0.00021219444170129f - 0.5f * _S217) + exponent_1 * 0.693359375f;
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ Light_0 slang_ldg_3(Light_0 * ptr_3)
{
    uint _S218 = __ldg(&ptr_3->is_point_0);
    float _S219 = __ldg(&ptr_3->x_0);
    float _S220 = __ldg(&ptr_3->y_0);
    float _S221 = __ldg(&ptr_3->z_0);
    float _S222 = __ldg(&ptr_3->red_0);
    float _S223 = __ldg(&ptr_3->green_0);
    float _S224 = __ldg(&ptr_3->blue_0);
    Light_0 _S225 = { _S218, _S219, _S220, _S221, _S222, _S223, _S224 };
    return _S225;
}

__device__ float3  towards_light_0(Light_0 * light_0, float3  position_4, float3  * irradiance_1)
{
    *irradiance_1 = make_float3 (light_0->red_0, light_0->green_0, light_0->blue_0);
    float3  _S226 = make_float3 (light_0->x_0, light_0->y_0, light_0->z_0);
    if((light_0->is_point_0) == 0U)
    {
        return _S226;
    }
    float3  _S227 = _S226 - position_4;
    *irradiance_1 = *irradiance_1 / make_float3 ((F32_max((square_0(_S227)), (9.999999960041972e-13f))));
    return normalize_0(_S227);
}

__device__ float diffuse_reflection_0(float3  light_1, float3  normal_1, float blend_0)
{
    float _S228 = light_1.z;
    if(_S228 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S228), (0.0f))), (F32_max((dot_0(light_1, normal_1)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_3, float3  tangent_0, float roughness_1)
{
    float _S229 = dot_0(direction_3, tangent_0);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S229 * _S229 + 1.0f), (roughness_1 * roughness_1))))));
}

__device__ float exponential_0(float x_15)
{
    float _S230 = clamp_0(x_15, -87.0f, 88.0f);
    float _S231 = (F32_floor((_S230 * 1.4426950216293335f + 0.5f)));
    float _S232 = _S230 - _S231 * 0.693359375f + _S231 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S232 + 0.00139819993637502f) * _S232 + 0.00833345204591751f) * _S232 + 0.04166579619050026f) * _S232 + 0.1666666567325592f) * _S232 + 0.5f;
    float _S233 = (U32_asfloat((uint(int(_S231) + int(127)) << int(23))));
    float _S234;
    if(x_15 < -87.0f)
    {
        _S234 = 0.0f;
    }
    else
    {
        _S234 = (p_0 * _S232 * _S232 + _S232 + 1.0f) * _S233;
    }
    return _S234;
}

__device__ float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

__device__ float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S235 = roughness_2 * roughness_2;
    float _S236 = squared_along_0 * (1.0f - _S235) + _S235;
    return 0.31830987334251404f * _S235 * roughness_2 / (_S236 * _S236);
}

__device__ float density_between_0(float3  light_2, float3  view_1, float3  tangent_1, float roughness_3)
{
    float3  _S237 = light_2 + view_1;
    float _S238 = dot_0(_S237, tangent_1);
    return flake_density_0((F32_min((_S238 * _S238 / (F32_max((square_0(_S237)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_3, float3  view_2, float3  normal_2, float3  tangent_2, float roughness_4, float optical_depth_1)
{
    float _S239 = dot_0(light_3, normal_2);
    bool _S240;
    if(_S239 <= 0.0f)
    {
        _S240 = true;
    }
    else
    {
        _S240 = (dot_0(view_2, normal_2)) <= 0.0f;
    }
    if(_S240)
    {
        return 0.0f;
    }
    float _S241 = (F32_max((_S239), (9.99999997475242708e-07f)));
    float _S242 = (F32_max((dot_0(view_2, normal_2)), (9.99999997475242708e-07f)));
    float _S243 = projected_area_1(light_3, tangent_2, roughness_4) * _S242 + projected_area_1(view_2, tangent_2, roughness_4) * _S241;
    float _S244 = optical_depth_1 * _S243 / (_S241 * _S242);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S244 * mean_attenuation_0(_S244)) * _S241 / _S243;
}

__device__ float transmission_0(float3  light_4, float3  view_3, float3  normal_3, float3  tangent_3, float roughness_5, float optical_depth_2)
{
    float _S245 = - dot_0(light_4, normal_3);
    float _S246 = dot_0(view_3, normal_3);
    bool _S247;
    if(_S245 <= 0.0f)
    {
        _S247 = true;
    }
    else
    {
        _S247 = _S246 <= 0.0f;
    }
    if(_S247)
    {
        return 0.0f;
    }
    float _S248 = 1.0f / (F32_max((_S246), (9.99999997475242708e-07f)));
    float _S249 = projected_area_1(light_4, tangent_3, roughness_5) / (F32_max((_S245), (9.99999997475242708e-07f)));
    float _S250 = projected_area_1(view_3, tangent_3, roughness_5) * _S248;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S249), (_S250)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S249 - _S250)))) * _S248;
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
    float _S251 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S252 = 2.0f * (F32_sqrt((_S251))) - 1.0f;
    float _S253 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S252, _S253), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S251) * sheen_shear_0(_S252, _S253), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S252, _S253), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_5, float3  view_4, float scale_0, float shear_0)
{
    float _S254 = light_5.z;
    bool _S255;
    if(_S254 <= 0.0f)
    {
        _S255 = true;
    }
    else
    {
        _S255 = (view_4.z) <= 0.0f;
    }
    if(_S255)
    {
        return 0.0f;
    }
    float2  _S256 = float2 {view_4.x, view_4.y};
    float _S257 = dot_1(_S256, _S256);
    float2  _S258;
    if(_S257 > 9.99999968265522539e-21f)
    {
        _S258 = _S256 * make_float2 ((F32_rsqrt((_S257))));
    }
    else
    {
        _S258 = make_float2 (1.0f, 0.0f);
    }
    float _S259 = scale_0 * dot_1(float2 {light_5.x, light_5.y}, _S258) + shear_0 * _S254;
    float _S260 = scale_0 * (light_5.y * _S258.x - light_5.x * _S258.y);
    float _S261 = _S259 * _S259 + _S260 * _S260 + _S254 * _S254;
    return 0.31830987334251404f * scale_0 * scale_0 * _S254 / (F32_max((_S261 * _S261), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_6, float3  view_5, float strength_0, float roughness_7)
{
    float3  _S262 = sheen_lobe_0(view_5.z, roughness_7);
    float _S263 = strength_0 * _S262.z;
    return make_float2 (_S263 * transformed_cosine_0(light_6, view_5, _S262.x, _S262.y), 1.0f - _S263);
}

__device__ void accumulate_0(Frame_0 * frame_4, uint2  pixel_1, float4  light_7)
{
    uint _S264 = pixel_1.y * frame_4->width_0 + pixel_1.x;
    float _S265 = light_7.w;
    float4  _S266 = make_float4 ((float3 {light_7.x, light_7.y, light_7.z} + make_float3 (1.0f - _S265) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).x, (float3 {light_7.x, light_7.y, light_7.z} + make_float3 (1.0f - _S265) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).y, (float3 {light_7.x, light_7.y, light_7.z} + make_float3 (1.0f - _S265) * make_float3 (frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0)).z, _S265);
    float4  * _S267 = (&(globalParams_0->radiance_0)[_S264]);
    float4  _S268;
    if((frame_4->pass_number_0) == 0U)
    {
        _S268 = _S266;
    }
    else
    {
        _S268 = *(&(globalParams_0->radiance_0)[_S264]) + _S266;
    }
    *_S267 = _S268;
    return;
}

__device__ VisiblePoint_0 visible_point_0(Frame_0 * _S269, uint _S270, uint _S271, uint2  _S272)
{
    Fabric_0 * _S273 = (&(globalParams_0->fabrics_0)[_S270]);
    uint _S274 = 3U * _S271;
    uint _S275 = __ldg((&(globalParams_0->corners_0)[_S274]));
    Vertex_0 _S276 = slang_ldg_1((&(globalParams_0->vertices_0)[_S275]));
    uint _S277 = __ldg((&(globalParams_0->corners_0)[_S274 + 1U]));
    Vertex_0 _S278 = slang_ldg_1((&(globalParams_0->vertices_0)[_S277]));
    uint _S279 = __ldg((&(globalParams_0->corners_0)[_S274 + 2U]));
    Vertex_0 _S280 = slang_ldg_1((&(globalParams_0->vertices_0)[_S279]));
    Vertex_0 _S281 = _S278;
    float3  _S282 = position_of_0(&_S281);
    Vertex_0 _S283 = _S276;
    float3  _S284 = position_of_0(&_S283);
    float3  _S285 = _S282 - _S284;
    Vertex_0 _S286 = _S280;
    float3  _S287 = position_of_0(&_S286);
    float3  _S288 = _S287 - _S284;
    float3  _S289 = cross_0(_S285, _S288);
    float _S290 = 1.0f / (F32_max((square_0(_S289)), (1.00000000317107685e-30f)));
    float3  _S291 = camera_right_0(_S269);
    float _S292 = float(_S269->width_0);
    float3  _S293 = _S291 * make_float3 (2.0f / _S292);
    float3  _S294 = camera_up_0(_S269);
    float _S295 = float(_S269->height_0);
    float3  _S296 = _S294 * make_float3 (-2.0f / _S295);
    float _S297 = float(_S272.x) + 0.5f - 0.5f * _S292;
    float _S298 = float(_S272.y) + 0.5f - 0.5f * _S295;
    float3  _S299 = camera_forward_0(_S269);
    float3  _S300 = _S299 + make_float3 (_S297) * _S293 + make_float3 (_S298) * _S296;
    float _S301 = dot_0(_S300, _S289);
    float _S302;
    if((F32_abs((_S301))) > 1.00000000317107685e-30f)
    {
        _S302 = _S301;
    }
    else
    {
        _S302 = 1.00000000317107685e-30f;
    }
    float _S303 = 1.0f / _S302;
    float3  _S304 = camera_origin_0(_S269);
    float3  _S305 = _S284 - _S304;
    float _S306 = dot_0(_S305, _S289) * _S303;
    float3  _S307 = _S300 * make_float3 (_S306) - _S305;
    float3  _S308 = make_float3 (_S306) * (_S293 - _S300 * make_float3 (dot_0(_S293, _S289) * _S303));
    float3  _S309 = make_float3 (_S306) * (_S296 - _S300 * make_float3 (dot_0(_S296, _S289) * _S303));
    float3  _S310 = cross_0(_S288, _S289) * make_float3 (_S290);
    float3  _S311 = cross_0(_S289, _S285) * make_float3 (_S290);
    float _S312 = dot_0(_S307, _S310);
    float _S313 = dot_0(_S307, _S311);
    float _S314 = _S278.u_0 - _S276.u_0;
    float _S315 = _S278.v_0 - _S276.v_0;
    float2  _S316 = make_float2 (_S314, _S315);
    float _S317 = _S280.u_0 - _S276.u_0;
    float _S318 = _S280.v_0 - _S276.v_0;
    float2  _S319 = make_float2 (_S317, _S318);
    float2  _S320 = make_float2 (_S276.u_0, _S276.v_0) + make_float2 (_S312) * _S316 + make_float2 (_S313) * _S319;
    float2  _S321 = make_float2 (dot_0(_S308, _S310)) * _S316 + make_float2 (dot_0(_S308, _S311)) * _S319;
    float2  _S322 = make_float2 (dot_0(_S309, _S310)) * _S316 + make_float2 (dot_0(_S309, _S311)) * _S319;
    if((_S314 * _S318 - _S315 * _S317) < 0.0f)
    {
        _S302 = -1.0f;
    }
    else
    {
        _S302 = 1.0f;
    }
    float3  _S323 = make_float3 (_S302) * (make_float3 (_S318) * _S285 - make_float3 (_S315) * _S288);
    float3  _S324 = make_float3 (_S302) * (make_float3 (_S314) * _S288 - make_float3 (_S317) * _S285);
    VisiblePoint_0 point_1;
    float _S325 = 1.0f - _S312 - _S313;
    Vertex_0 _S326 = _S276;
    float3  _S327 = normal_of_0(&_S326);
    float3  _S328 = make_float3 (_S325) * _S327;
    Vertex_0 _S329 = _S278;
    float3  _S330 = normal_of_0(&_S329);
    float3  _S331 = _S328 + make_float3 (_S312) * _S330;
    Vertex_0 _S332 = _S280;
    float3  _S333 = normal_of_0(&_S332);
    float3  _S334 = normalize_0(_S331 + make_float3 (_S313) * _S333);
    (&point_1)->normal_0 = _S334;
    float3  _S335 = normalize_0(_S323 - _S334 * make_float3 (dot_0(_S334, _S323)));
    (&point_1)->axis_x_0 = _S335;
    (&point_1)->axis_y_0 = cross_0(_S334, _S335);
    (&point_1)->position_0 = _S284 + _S307;
    (&point_1)->view_0 = - normalize_0(_S300);
    bool _S336 = (dot_0(cross_0(_S323, _S324), _S334)) < 0.0f;
    float _S337 = __ldg(&_S273->uv_width_0);
    if(_S336)
    {
        float _S338 = __ldg(&_S273->uv_height_0);
        _S302 = - _S338;
    }
    else
    {
        float _S339 = __ldg(&_S273->uv_height_0);
        _S302 = _S339;
    }
    float2  _S340 = make_float2 (_S337, _S302);
    float2  _S341 = _S320 * _S340;
    if(_S336)
    {
        float _S342 = __ldg(&_S273->uv_height_0);
        _S302 = _S342;
    }
    else
    {
        _S302 = 0.0f;
    }
    (&point_1)->draft_0 = _S341 + make_float2 (0.0f, _S302);
    (&point_1)->draft_dx_0 = _S321 * _S340;
    (&point_1)->draft_dy_0 = _S322 * _S340;
    return point_1;
}

struct YarnPoint_0
{
    bool back_2;
    bool hole_2;
    bool is_warp_1;
    float x_19;
    float y_11;
    float height_3;
    float3  normal_4;
    float3  tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_20;
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

__device__ Crossing_0 crossing_at_0(uint _S343, float _S344, float _S345, bool _S346)
{
    Fabric_0 * _S347 = (&(globalParams_0->fabrics_0)[_S343]);
    Crossing_0 crossing_2;
    uint _S348 = __ldg(&_S347->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S348, _S344);
    uint _S349 = __ldg(&_S347->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S349, _S345);
    uint _S350 = __ldg(&_S347->run_words_0);
    uint _S351 = (&(&crossing_2)->weft_1)->thread_1;
    uint _S352 = __ldg(&_S347->ends_0);
    uint _S353 = _S350 + 2U * (_S351 * _S352 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S354 = __ldg((&(globalParams_0->words_0)[_S353]));
    (&crossing_2)->warp_word_0 = _S354;
    uint _S355 = __ldg((&(globalParams_0->words_0)[_S353 + 1U]));
    (&crossing_2)->weft_word_0 = _S355;
    (&crossing_2)->warp_above_0 = ((_S354 & 1U) == 1U) != _S346;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S356, float _S357, float _S358, bool _S359)
{
    Fabric_0 * _S360 = (&(globalParams_0->fabrics_0)[_S356]);
    Sample_0 sample_0;
    Crossing_0 _S361 = crossing_at_0(_S356, _S357, _S358, _S359);
    (&sample_0)->crossing_1 = _S361;
    Crossing_0 _S362 = _S361;
    Shown_0 _S363 = shown_at_0(&_S362, _S359);
    (&sample_0)->shown_3 = _S363;
    uint _S364;
    if(_S363.is_warp_0)
    {
        uint _S365 = __ldg(&_S360->warp_0);
        _S364 = _S365;
    }
    else
    {
        uint _S366 = __ldg(&_S360->weft_0);
        _S364 = _S366;
    }
    uint _S367;
    if(_S363.is_warp_0)
    {
        uint _S368 = __ldg(&_S360->weft_0);
        _S367 = _S368;
    }
    else
    {
        uint _S369 = __ldg(&_S360->warp_0);
        _S367 = _S369;
    }
    Cell_0 _S370 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S371 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S372 = select_cell_0(_S363.is_warp_0, &_S370, &_S371);
    Cell_0 _S373 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S374 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S375 = select_cell_0(_S363.is_warp_0, &_S373, &_S374);
    Cell_0 _S376 = _S375;
    Run_0 _S377 = unpack_0(_S364, _S367, _S372.thread_1, &_S376, _S363.word_0);
    Cell_0 _S378 = _S372;
    Section_0 _S379 = section_at_0(&_S378);
    bool _S380;
    if(_S363.on_top_0)
    {
        _S380 = (_S377.distance_0) < (_S379.drop_0 * _S377.bend_1.sine_0);
    }
    else
    {
        _S380 = false;
    }
    bool _S381;
    if(_S363.on_top_0)
    {
        _S381 = !_S380;
    }
    else
    {
        _S381 = false;
    }
    float _S382;
    if(_S381)
    {
        _S382 = 1.0f;
    }
    else
    {
        _S382 = -1.0f;
    }
    float _S383;
    if(_S380)
    {
        _S383 = _S377.other_reach_0;
    }
    else
    {
        _S383 = _S377.reach_0;
    }
    float _S384;
    if(_S380)
    {
        _S384 = _S383 + _S377.distance_0;
    }
    else
    {
        _S384 = (F32_max((_S383 - _S377.distance_0), (0.0f)));
    }
    float _S385 = _S383 / _S377.bend_1.sine_0 - _S382 * _S379.drop_0;
    float _S386 = _S384 * _S384;
    float _S387 = (F32_max((_S385 * _S385 - _S386), (9.99999968265522539e-21f)));
    float _S388 = (F32_rsqrt((_S387)));
    float _S389 = _S386 / (_S387 * _S388 + _S385);
    bool _S390 = _S384 > 0.0f;
    float _S391;
    if(_S363.on_top_0)
    {
        _S391 = 1.0f;
    }
    else
    {
        _S391 = -1.0f;
    }
    float _S392;
    if(_S377.near_start_0)
    {
        _S392 = 1.0f;
    }
    else
    {
        _S392 = -1.0f;
    }
    float _S393 = _S391 * _S392;
    if(_S390)
    {
        _S391 = _S385 * _S388;
    }
    else
    {
        _S391 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S379.slope_0 * _S391;
    if(_S390)
    {
        _S384 = _S393 * _S384 * _S388;
    }
    else
    {
        _S384 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S384;
    Family_0 _S394 = slang_ldg_2((&(globalParams_0->families_0)[_S364]));
    Shown_0 _S395 = _S363;
    Run_0 _S396 = _S377;
    Cell_0 _S397 = _S375;
    float2  _S398 = dive_0(_S367, &_S395, &_S396, &_S397);
    if(_S377.straight_0)
    {
        _S382 = 0.0f;
    }
    else
    {
        _S382 = _S394.height_scale_0 * _S382;
    }
    (&sample_0)->height_5 = _S382 * (_S383 * _S377.bend_1.half_tangent_0 - _S389) - _S394.height_scale_0 * _S379.drop_0 - _S398.x;
    float _S399 = _S394.height_scale_0 * (&sample_0)->slope_across_0;
    float _S400 = _S394.height_scale_0 * (&sample_0)->slope_along_0 - _S398.y;
    if(_S363.is_warp_0)
    {
        _S382 = _S399;
    }
    else
    {
        _S382 = _S400;
    }
    (&sample_0)->slope_x_1 = _S382;
    if(_S363.is_warp_0)
    {
        _S382 = _S400;
    }
    else
    {
        _S382 = _S399;
    }
    (&sample_0)->slope_y_1 = _S382;
    (&sample_0)->run_3 = _S377;
    (&sample_0)->section_1 = _S379;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S401, SearchQuality_0 * _S402, float3  _S403)
{
    Fabric_0 * _S404 = (&(globalParams_0->fabrics_0)[_S401]);
    float _S405 = (F32_abs((_S403.x)));
    float _S406 = __ldg(&_S404->threads_per_x_0);
    float _S407 = _S405 * _S406;
    float _S408 = (F32_abs((_S403.y)));
    float _S409 = __ldg(&_S404->threads_per_y_0);
    float _S410 = (F32_max((_S407), (_S408 * _S409))) * _S402->steps_per_thread_0;
    float _S411 = (F32_abs((_S403.z)));
    float _S412 = __ldg(&_S404->per_relief_0);
    return (F32_max((_S410), (_S411 * _S412 * _S402->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S413, Crossing_0 * _S414)
{
    Fabric_0 * _S415 = (&(globalParams_0->fabrics_0)[_S413]);
    bool _S416 = _S414->warp_above_0;
    uint _S417;
    if(_S414->warp_above_0)
    {
        uint _S418 = __ldg(&_S415->warp_0);
        _S417 = _S418;
    }
    else
    {
        uint _S419 = __ldg(&_S415->weft_0);
        _S417 = _S419;
    }
    uint _S420;
    if(_S416)
    {
        _S420 = _S414->warp_word_0;
    }
    else
    {
        _S420 = _S414->weft_word_0;
    }
    float _S421 = float(_S420 >> int(28));
    Family_0 _S422 = slang_ldg_2((&(globalParams_0->families_0)[_S417]));
    float _S423 = _S421 * _S422.height_scale_0;
    Family_0 _S424 = slang_ldg_2((&(globalParams_0->families_0)[_S417]));
    return _S423 * _S424.level_0;
}

__device__ Probe_0 probe_0(uint _S425, float _S426, float _S427, bool _S428, bool _S429, bool _S430)
{
    Sample_0 _S431 = sample_at_0(_S425, _S426, _S427, _S428);
    Probe_0 probe_1;
    (&probe_1)->height_1 = _S431.height_5;
    (&probe_1)->hole_1 = _S431.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S431.slope_x_1;
    (&probe_1)->slope_y_0 = _S431.slope_y_1;
    uint _S432;
    if(_S431.shown_3.is_warp_0)
    {
        _S432 = _S431.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S432 = _S431.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S432;
    Crossing_0 _S433 = _S431.crossing_1;
    float _S434 = cell_maximum_0(_S425, &_S433);
    (&probe_1)->cell_max_0 = _S434;
    float _S435;
    if(_S429)
    {
        _S435 = _S431.crossing_1.warp_1.above_0;
    }
    else
    {
        _S435 = _S431.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S435;
    if(_S430)
    {
        _S435 = _S431.crossing_1.weft_1.above_0;
    }
    else
    {
        _S435 = _S431.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S435;
    bool _S436 = !_S431.shown_3.is_warp_0;
    Cell_0 _S437 = _S431.crossing_1.warp_1;
    Shown_0 _S438 = _S431.shown_3;
    Run_0 _S439 = _S431.run_3;
    float _S440 = outline_distance_0(&_S437, &_S438, &_S439, _S436, _S429);
    (&probe_1)->edge_x_0 = _S440;
    Cell_0 _S441 = _S431.crossing_1.weft_1;
    Shown_0 _S442 = _S431.shown_3;
    Run_0 _S443 = _S431.run_3;
    float _S444 = outline_distance_0(&_S441, &_S442, &_S443, _S431.shown_3.is_warp_0, _S430);
    (&probe_1)->edge_y_0 = _S444;
    return probe_1;
}

__device__ bool is_free_0(uint _S445, SearchQuality_0 * _S446, float3  _S447, float3  _S448, bool _S449, float _S450)
{
    float _S451 = _S448.z;
    if(_S451 <= 0.0f)
    {
        return false;
    }
    float _S452 = _S446->shadow_share_0;
    float _S453 = steps_per_length_0(_S445, _S446, _S448);
    float _S454 = 1.0f / (F32_max((_S452 * _S453), (9.99999971718068537e-10f)));
    StepControl_0 _S455 = step_control_0(float2 {_S448.x, _S448.y}, _S454);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S456;
        if(count_1 < 1024U)
        {
            _S456 = (_S447.z + _S451 * distance_1) < _S450;
        }
        else
        {
            _S456 = false;
        }
        if(_S456)
        {
        }
        else
        {
            break;
        }
        float3  _S457 = _S447 + _S448 * make_float3 (distance_1);
        Probe_0 _S458 = probe_0(_S445, _S457.x, _S457.y, _S449, _S455.right_1, _S455.up_0);
        float _S459 = _S457.z;
        float _S460 = _S459 - _S458.height_1;
        float _S461 = _S451 - _S458.slope_x_0 * _S448.x - _S458.slope_y_0 * _S448.y;
        bool _S462;
        if(!_S458.hole_1)
        {
            _S462 = _S460 < 0.0f;
        }
        else
        {
            _S462 = false;
        }
        if(_S462)
        {
            return false;
        }
        PreviousSample_0 _S463 = previous_3;
        Probe_0 _S464 = _S458;
        float _S465 = way_back_to_dip_0(&_S463, _S460, _S461, last_step_0, &_S464);
        if(_S465 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S465;
            distance_1 = distance_1 - _S465;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S466 = _S459 > (_S458.cell_max_0);
        Probe_0 _S467 = _S458;
        PreviousSample_0 _S468 = after_sample_0(_S460, _S461, &_S467, _S466);
        float last_step_2;
        if(_S466)
        {
            StepControl_0 _S469 = _S455;
            float _S470 = StepControl_to_cell_exit_0(&_S469, _S458.side_x_0, _S458.side_y_0);
            last_step_2 = (F32_max((_S470), (_S454)));
        }
        else
        {
            StepControl_0 _S471 = _S455;
            Probe_0 _S472 = _S458;
            float _S473 = StepControl_to_next_sample_0(&_S471, &_S472, _S460, _S461);
            last_step_2 = _S473;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S468;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S474, SearchQuality_0 * _S475, float _S476, float _S477, float3  _S478, bool _S479)
{
    Fabric_0 * _S480 = (&(globalParams_0->fabrics_0)[_S474]);
    Sample_0 _S481 = sample_at_0(_S474, _S476, _S477, _S479);
    if(!_S481.shown_3.hole_0)
    {
        return false;
    }
    float3  _S482 = make_float3 (_S476, _S477, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S483;
        if(side_0 < 2U)
        {
            _S483 = passes_0;
        }
        else
        {
            _S483 = false;
        }
        if(_S483)
        {
        }
        else
        {
            break;
        }
        float3  _S484;
        if(side_0 == 0U)
        {
            _S484 = _S478;
        }
        else
        {
            _S484 = make_float3 (- _S478.x, - _S478.y, _S478.z);
        }
        bool _S485 = _S479 != (side_0 == 1U);
        float _S486 = __ldg(&_S480->height_high_0);
        bool _S487 = is_free_0(_S474, _S475, _S482, _S484, _S485, _S486);
        uint _S488 = side_0 + 1U;
        passes_0 = _S487;
        side_0 = _S488;
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

__device__ float max_height_along_0(uint _S489, float _S490, float _S491, float _S492, float3  _S493, bool _S494)
{
    Fabric_0 * _S495 = (&(globalParams_0->fabrics_0)[_S489]);
    uint _S496 = __ldg(&_S495->warp_0);
    uint _S497 = locate_0(_S496, _S490).thread_1 / 2U;
    uint _S498 = __ldg(&_S495->weft_0);
    uint _S499 = locate_0(_S498, _S491).thread_1 / 2U;
    float _S500 = _S493.x;
    uint _S501;
    if(_S500 > 0.0f)
    {
        _S501 = 1U;
    }
    else
    {
        _S501 = 0U;
    }
    float _S502 = _S493.y;
    uint _S503;
    if(_S502 > 0.0f)
    {
        _S503 = 2U;
    }
    else
    {
        _S503 = 0U;
    }
    uint _S504 = _S501 + _S503;
    uint _S505 = __ldg(&_S495->max_heights_0);
    uint _S506 = __ldg(&_S495->max_height_columns_0);
    uint _S507 = __ldg((&(globalParams_0->words_0)[_S505 + 4U * (_S499 * _S506 + _S497) + _S504]));
    int number_0;
    if(_S494)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S508 = _S507 >> number_0;
    float _S509 = (F32_abs((_S500)));
    float _S510 = __ldg(&_S495->threads_per_x_0);
    float _S511 = _S509 * _S510;
    float _S512 = (F32_abs((_S502)));
    float _S513 = __ldg(&_S495->threads_per_y_0);
    float _S514 = (F32_max((_S511), (_S512 * _S513))) / _S493.z;
    float _S515 = __ldg(&_S495->height_high_0);
    float max_height_0 = _S515;
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
        if(((max_height_0 - _S492) * _S514) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S508 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S515)));
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S516, float _S517, float _S518, bool _S519, bool _S520, bool _S521)
{
    Crossing_0 _S522 = crossing_at_0(_S516, _S517, _S518, _S519);
    Crossing_0 _S523 = _S522;
    float _S524 = cell_maximum_0(_S516, &_S523);
    float _S525;
    if(_S520)
    {
        _S525 = _S522.warp_1.above_0;
    }
    else
    {
        _S525 = _S522.warp_1.below_0;
    }
    float _S526;
    if(_S521)
    {
        _S526 = _S522.weft_1.above_0;
    }
    else
    {
        _S526 = _S522.weft_1.below_0;
    }
    return make_float3 (_S524, _S525, _S526);
}

__device__ float first_sample_height_0(uint _S527, ViewRay_0 * _S528, StepControl_0 * _S529, bool _S530)
{
    float _S531 = max_height_along_0(_S527, _S528->origin_0.x, _S528->origin_0.y, 0.0f, make_float3 (_S528->slope_1.x, _S528->slope_1.y, 1.0f), _S530);
    uint count_2 = 0U;
    float height_7 = _S531;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S532 = ViewRay_at_0(_S528, height_7);
        float3  _S533 = cell_bounds_0(_S527, _S532.x, _S532.y, _S530, _S529->right_1, _S529->up_0);
        float _S534 = height_7 - _S533.x;
        float _S535 = StepControl_to_cell_exit_0(_S529, _S533.y, _S533.z);
        float height_8 = height_7 - clamp_0(_S534, 0.0f, _S535);
        if(_S534 <= _S535)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

__device__ ViewRayEnd_0 search_down_0(uint _S536, ViewRay_0 * _S537, StepControl_0 * _S538, bool _S539)
{
    Fabric_0 * _S540 = (&(globalParams_0->fabrics_0)[_S536]);
    float _S541 = __ldg(&_S540->height_low_0);
    float _S542 = __ldg(&_S540->height_high_0);
    float _S543 = _S541 - (_S542 - _S541);
    ViewRayEnd_0 end_1;
    float _S544 = first_sample_height_0(_S536, _S537, _S538, _S539);
    (&end_1)->height_6 = _S544;
    (&end_1)->last_step_3 = _S538->epsilon_0;
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
        float2  _S545 = ViewRay_at_0(_S537, (&end_1)->height_6);
        Probe_0 _S546 = probe_0(_S536, _S545.x, _S545.y, _S539, _S538->right_1, _S538->up_0);
        float _S547 = (&end_1)->height_6 - _S546.height_1;
        Probe_0 _S548 = _S546;
        float _S549 = ViewRay_rate_0(_S537, &_S548);
        (&end_1)->depth_1 = - _S547;
        (&end_1)->rate_4 = _S549;
        bool _S550;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S550 = !_S546.hole_1;
        }
        else
        {
            _S550 = false;
        }
        bool _S551;
        if(_S550)
        {
            _S551 = ((&(&end_1)->previous_4)->yarn_0) == (_S546.yarn_1);
        }
        else
        {
            _S551 = false;
        }
        (&end_1)->smooth_0 = _S551;
        bool _S552;
        if(!_S546.hole_1)
        {
            _S552 = _S547 <= 0.0f;
        }
        else
        {
            _S552 = false;
        }
        bool _S553;
        if(_S552)
        {
            _S553 = true;
        }
        else
        {
            _S553 = ((&end_1)->height_6) <= _S543;
        }
        if(_S553)
        {
            break;
        }
        PreviousSample_0 _S554 = (&end_1)->previous_4;
        Probe_0 _S555 = _S546;
        float _S556 = way_back_to_dip_0(&_S554, _S547, _S549, (&end_1)->last_step_3, &_S555);
        if(_S556 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S556;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S556;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S557 = StepControl_to_cell_exit_0(_S538, _S546.side_x_0, _S546.side_y_0);
        float _S558 = (F32_min((_S557), ((&end_1)->height_6 - _S546.cell_max_0)));
        Probe_0 _S559 = _S546;
        float _S560 = StepControl_to_next_sample_0(_S538, &_S559, _S547, _S549);
        bool _S561 = _S558 > _S560;
        Probe_0 _S562 = _S546;
        PreviousSample_0 _S563 = after_sample_0(_S547, _S549, &_S562, _S561);
        (&end_1)->previous_4 = _S563;
        float _S564 = (F32_max((_S558), (_S560)));
        (&end_1)->last_step_3 = _S564;
        (&end_1)->height_6 = (&end_1)->height_6 - _S564;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S565, ViewRay_0 * _S566, StepControl_0 * _S567, bool _S568, ViewRayEnd_0 * _S569, uint _S570)
{
    Fabric_0 * _S571 = (&(globalParams_0->fabrics_0)[_S565]);
    float _S572 = __ldg(&_S571->height_high_0);
    float _S573 = __ldg(&_S571->height_low_0);
    float _S574 = _S572 - _S573;
    float _S575 = _S569->height_6;
    float _S576 = _S569->last_step_3;
    float above_2 = _S569->height_6 + _S569->last_step_3;
    float above_gap_1 = clamp_0((&_S569->previous_4)->clearance_0, 0.0f, _S574);
    float under_gap_1 = clamp_0(_S569->depth_1, 0.0f, _S574);
    float _S577 = cubic_root_0(above_gap_1, - under_gap_1, (&_S569->previous_4)->rate_0 * _S569->last_step_3, _S569->rate_4 * _S569->last_step_3);
    bool _S578 = _S569->smooth_0;
    float middle_0;
    if(_S569->smooth_0)
    {
        middle_0 = above_2 - _S577 * _S576;
    }
    else
    {
        middle_0 = between_0(above_2, _S575, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S575;
    float above_3 = above_2;
    uint i_6 = 0U;
    for(;;)
    {
        if(i_6 < _S570)
        {
        }
        else
        {
            break;
        }
        float2  _S579 = ViewRay_at_0(_S566, middle_0);
        Probe_0 _S580 = probe_0(_S565, _S579.x, _S579.y, _S568, _S567->right_1, _S567->up_0);
        float _S581;
        if(_S580.hole_1)
        {
            _S581 = -1.0e+09f;
        }
        else
        {
            _S581 = _S580.height_1;
        }
        float _S582 = clamp_0(middle_0 - _S581, - _S574, _S574);
        float _S583;
        if(_S582 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S583 = 0.5f * above_gap_2;
            }
            else
            {
                _S583 = above_gap_2;
            }
            float _S584 = - _S582;
            under_1 = middle_0;
            above_gap_2 = _S583;
            under_gap_2 = _S584;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S583 = 0.5f * under_gap_2;
            }
            else
            {
                _S583 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S582;
            under_gap_2 = _S583;
            side_1 = -1.0f;
        }
        if(_S578)
        {
            Probe_0 _S585 = _S580;
            float _S586 = ViewRay_rate_0(_S566, &_S585);
            middle_0 = clamp_0(middle_0 + _S582 / (F32_min((_S586), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_6 = i_6 + 1U;
    }
    if(_S578)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S587, SearchQuality_0 * _S588, float _S589, float _S590, float3  _S591, bool _S592)
{
    float _S593 = (F32_max((_S591.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S589, _S590);
    float2  _S594 = float2 {_S591.x, _S591.y} / make_float2 (_S593);
    (&ray_0)->slope_1 = _S594;
    float2  _S595 = - _S594;
    float _S596 = steps_per_length_0(_S587, _S588, _S591);
    StepControl_0 _S597 = step_control_0(_S595, 1.0f / (F32_max((_S596 / _S593), (9.99999971718068537e-10f))));
    ViewRay_0 _S598 = ray_0;
    StepControl_0 _S599 = _S597;
    ViewRayEnd_0 _S600 = search_down_0(_S587, &_S598, &_S599, _S592);
    Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    ViewRay_0 _S601 = ray_0;
    StepControl_0 _S602 = _S597;
    ViewRayEnd_0 _S603 = _S600;
    float _S604 = refined_height_0(_S587, &_S601, &_S602, _S592, &_S603, _S588->refinements_0);
    (&hit_0)->height_4 = _S604;
    ViewRay_0 _S605 = ray_0;
    float2  _S606 = ViewRay_at_0(&_S605, _S604);
    (&hit_0)->x_20 = _S606.x;
    (&hit_0)->y_12 = _S606.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S607, SearchQuality_0 * _S608, float _S609, float _S610, float3  _S611, bool _S612)
{
    bool _S613 = passes_through_0(_S607, _S608, _S609, _S610, _S611, _S612);
    if(!_S613)
    {
        Hit_0 _S614 = first_hit_of_yarn_0(_S607, _S608, _S609, _S610, _S611, _S612);
        return _S614;
    }
    Hit_0 hit_1;
    (&hit_1)->x_20 = _S609;
    (&hit_1)->y_12 = _S610;
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
    float3  normal_5;
    float3  tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

__device__ SurfacePoint_0 surface_at_0(uint _S615, float _S616, float _S617, bool _S618)
{
    Fabric_0 * _S619 = (&(globalParams_0->fabrics_0)[_S615]);
    Sample_0 _S620 = sample_at_0(_S615, _S616, _S617, _S618);
    float _S621;
    if(_S620.shown_3.is_warp_0)
    {
        _S621 = _S620.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S621 = _S620.crossing_1.weft_1.half_width_1;
    }
    uint _S622;
    if(_S620.shown_3.is_warp_0)
    {
        uint _S623 = __ldg(&_S619->warp_0);
        _S622 = _S623;
    }
    else
    {
        uint _S624 = __ldg(&_S619->weft_0);
        _S622 = _S624;
    }
    Family_0 _S625 = slang_ldg_2((&(globalParams_0->families_0)[_S622]));
    float _S626;
    if(_S618)
    {
        _S626 = -1.0f;
    }
    else
    {
        _S626 = 1.0f;
    }
    float _S627 = _S625.twist_sine_0 * _S626;
    Family_0 _S628 = slang_ldg_2((&(globalParams_0->families_0)[_S622]));
    if(_S620.shown_3.is_warp_0)
    {
        _S626 = 1.0f;
    }
    else
    {
        _S626 = -1.0f;
    }
    float2  _S629 = fibre_direction_0(_S620.slope_across_0, _S626 * _S620.slope_along_0, _S627, _S628.twist_cosine_0);
    float _S630;
    if(_S620.shown_3.is_warp_0)
    {
        _S630 = _S620.slope_x_1;
    }
    else
    {
        _S630 = _S620.slope_y_1;
    }
    float _S631;
    if(_S620.shown_3.is_warp_0)
    {
        _S631 = _S620.slope_y_1;
    }
    else
    {
        _S631 = _S620.slope_x_1;
    }
    float _S632 = _S629.x;
    float _S633 = _S629.y;
    float _S634 = _S630 * _S632 + _S626 * _S631 * _S633;
    float _S635 = _S621 * 1.0154266357421875f;
    float _S636 = _S635 * arc_sine_0(clamp_0(_S620.section_1.across_1 / _S635, -1.0f, 1.0f));
    if(_S620.shown_3.is_warp_0)
    {
        _S621 = _S617;
    }
    else
    {
        _S621 = - _S616;
    }
    SurfacePoint_0 point_2;
    (&point_2)->hole_4 = _S620.shown_3.hole_0;
    (&point_2)->is_warp_2 = _S620.shown_3.is_warp_0;
    (&point_2)->warp_thread_0 = _S620.crossing_1.warp_1.thread_1;
    (&point_2)->weft_thread_0 = _S620.crossing_1.weft_1.thread_1;
    (&point_2)->height_9 = _S620.height_5;
    (&point_2)->normal_5 = normalize_0(make_float3 (- _S620.slope_x_1, - _S620.slope_y_1, 1.0f));
    float3  _S637;
    if(_S620.shown_3.is_warp_0)
    {
        _S637 = make_float3 (_S632, _S633, _S634);
    }
    else
    {
        _S637 = make_float3 (- _S633, _S632, _S634);
    }
    (&point_2)->tangent_5 = normalize_0(_S637);
    (&point_2)->across_2 = _S620.section_1.across_1;
    (&point_2)->fibre_across_0 = _S636 * _S628.twist_cosine_0 + _S621 * _S627;
    (&point_2)->fibre_along_0 = _S621 * _S628.twist_cosine_0 - _S636 * _S627;
    return point_2;
}

__device__ Albedos_0 vary_albedos_0(uint _S638, Albedos_0 * _S639, uint _S640, uint _S641)
{
    Fabric_0 * _S642 = (&(globalParams_0->fabrics_0)[_S638]);
    float3  _S643 = _S639->specular_reflect_0;
    float3  _S644 = _S639->specular_transmit_0;
    float3  _S645 = max_0(_S639->specular_reflect_0, _S639->specular_transmit_0);
    float3  _S646 = _S639->diffuse_reflect_0;
    float3  _S647 = _S639->diffuse_transmit_0;
    float3  _S648 = _S639->diffuse_reflect_0 + _S639->diffuse_transmit_0;
    float _S649 = __ldg(&_S642->colour_noise_0);
    uint _S650 = __ldg(&_S642->seed_0);
    float _S651 = thread_gain_0(_S640, _S649, _S650);
    float _S652 = __ldg(&_S642->layer_bound_0);
    float _S653 = bounded_gain_0(_S651, _S648, make_float3 (1.0f) - make_float3 (_S652) * _S645);
    float3  _S654 = min_0((make_float3 (1.0f) - make_float3 (_S653) * _S648) / make_float3 (_S652), make_float3 (1.0f));
    float _S655 = __ldg(&_S642->fibre_noise_0);
    float _S656 = bounded_gain_0(fibre_gain_0(_S640, _S641, _S655, _S650), _S645, _S654);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S653) * _S646;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S653) * _S647;
    (&varied_0)->specular_reflect_0 = make_float3 (_S656) * _S643;
    (&varied_0)->specular_transmit_0 = make_float3 (_S656) * _S644;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S657, SurfacePoint_0 * _S658, Albedos_0 * _S659, float _S660, float _S661)
{
    Fabric_0 * _S662 = (&(globalParams_0->fabrics_0)[_S657]);
    bool _S663 = _S658->is_warp_2;
    float _S664;
    if(_S658->is_warp_2)
    {
        _S664 = _S660;
    }
    else
    {
        _S664 = _S661;
    }
    float _S665 = _S664 - _S658->across_2;
    uint _S666;
    if(_S663)
    {
        uint _S667 = __ldg(&_S662->warp_0);
        _S666 = _S667;
    }
    else
    {
        uint _S668 = __ldg(&_S662->weft_0);
        _S666 = _S668;
    }
    Family_0 _S669 = slang_ldg_2((&(globalParams_0->families_0)[_S666]));
    Family_0 _S670 = slang_ldg_2((&(globalParams_0->families_0)[_S666]));
    int _S671 = int(_S670.count_0);
    if(_S663)
    {
        _S666 = _S658->warp_thread_0;
    }
    else
    {
        _S666 = _S658->weft_thread_0;
    }
    uint _S672 = uint(int((F32_floor((_S665 / _S669.period_0)))) * _S671 + int(_S666)) * 2U;
    if(_S663)
    {
        _S666 = 1U;
    }
    else
    {
        _S666 = 0U;
    }
    uint _S673 = _S672 + _S666;
    float _S674 = _S658->fibre_across_0;
    float _S675 = __ldg(&_S662->fibre_size_0);
    float _S676 = (F32_floor((_S674 / _S675)));
    Albedos_0 _S677 = vary_albedos_0(_S657, _S659, _S673, uint(int(_S676)) * 65536U + uint(int((F32_floor((_S658->fibre_along_0 / (_S675 * 40.0f) + 0.61799997091293335f * _S676))))));
    return _S677;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S678, SurfacePoint_0 * _S679, float _S680, float _S681, bool _S682, bool _S683)
{
    Fabric_0 * _S684 = (&(globalParams_0->fabrics_0)[_S678]);
    bool _S685 = _S679->is_warp_2;
    uint _S686;
    if(_S679->is_warp_2)
    {
        uint _S687 = __ldg(&_S684->warp_0);
        _S686 = _S687;
    }
    else
    {
        uint _S688 = __ldg(&_S684->weft_0);
        _S686 = _S688;
    }
    uint _S689;
    if(_S685)
    {
        _S689 = _S679->warp_thread_0;
    }
    else
    {
        _S689 = _S679->weft_thread_0;
    }
    Albedos_0 albedos_2 = albedos_of_0(_S686, _S689);
    float _S690 = __ldg(&_S684->fibre_noise_0);
    bool _S691;
    if(_S690 > 0.0f)
    {
        _S691 = true;
    }
    else
    {
        float _S692 = __ldg(&_S684->colour_noise_0);
        _S691 = _S692 > 0.0f;
    }
    Albedos_0 albedos_3;
    if(_S691)
    {
        Albedos_0 _S693 = albedos_2;
        Albedos_0 _S694 = varied_at_0(_S678, _S679, &_S693, _S680, _S681);
        albedos_3 = _S694;
    }
    else
    {
        albedos_3 = albedos_2;
    }
    YarnPoint_0 point_3;
    (&point_3)->back_2 = _S682;
    (&point_3)->hole_2 = _S683;
    (&point_3)->is_warp_1 = _S685;
    (&point_3)->x_19 = _S680;
    (&point_3)->y_11 = _S681;
    (&point_3)->height_3 = _S679->height_9;
    (&point_3)->normal_4 = _S679->normal_5;
    (&point_3)->tangent_4 = _S679->tangent_5;
    Family_0 _S695 = slang_ldg_2((&(globalParams_0->families_0)[_S686]));
    (&point_3)->roughness_8 = _S695.roughness_0;
    (&point_3)->albedos_1 = albedos_3;
    return point_3;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S696, SearchQuality_0 * _S697, float _S698, float _S699, float3  _S700)
{
    bool _S701 = (_S700.z) < 0.0f;
    Hit_0 _S702 = first_hit_0(_S696, _S697, _S698, _S699, to_face_frame_0(_S700, _S701), _S701);
    SurfacePoint_0 _S703 = surface_at_0(_S696, _S702.x_20, _S702.y_12, _S701);
    SurfacePoint_0 _S704 = _S703;
    YarnPoint_0 _S705 = yarn_point_of_0(_S696, &_S704, _S702.x_20, _S702.y_12, _S701, _S702.hole_3);
    return _S705;
}

__device__ float3  scattered_0(uint _S706, YarnPoint_0 * _S707, float3  _S708, float3  _S709)
{
    Fabric_0 * _S710 = (&(globalParams_0->fabrics_0)[_S706]);
    float3  _S711 = make_float3 (0.0f);
    bool _S712 = !_S707->hole_2;
    bool _S713;
    if(_S712)
    {
        _S713 = (_S708.z) > 0.0f;
    }
    else
    {
        _S713 = false;
    }
    float3  value_1;
    if(_S713)
    {
        float3  _S714 = (&_S707->albedos_1)->diffuse_reflect_0;
        float3  _S715 = _S707->normal_4;
        float _S716 = __ldg(&_S710->diffuse_blend_0);
        float3  _S717 = _S714 * make_float3 (diffuse_reflection_0(_S708, _S715, _S716));
        float3  _S718 = (&_S707->albedos_1)->specular_reflect_0;
        float3  _S719 = _S707->tangent_4;
        float _S720 = _S707->roughness_8;
        float _S721 = __ldg(&_S710->optical_depth_0);
        value_1 = _S717 + _S718 * make_float3 (reflection_0(_S708, _S709, _S715, _S719, _S720, _S721));
    }
    else
    {
        if(_S712)
        {
            _S713 = (_S708.z) < 0.0f;
        }
        else
        {
            _S713 = false;
        }
        if(_S713)
        {
            float3  _S722 = (&_S707->albedos_1)->diffuse_transmit_0;
            float3  _S723 = - _S708;
            float3  _S724 = _S707->normal_4;
            float _S725 = __ldg(&_S710->diffuse_blend_0);
            float3  _S726 = _S722 * make_float3 (diffuse_reflection_0(_S723, _S724, _S725));
            float3  _S727 = (&_S707->albedos_1)->specular_transmit_0;
            float3  _S728 = _S707->tangent_4;
            float _S729 = _S707->roughness_8;
            float _S730 = __ldg(&_S710->optical_depth_0);
            value_1 = _S726 + _S727 * make_float3 (transmission_0(_S708, _S709, _S724, _S728, _S729, _S730));
        }
        else
        {
            value_1 = _S711;
        }
    }
    float _S731 = __ldg(&_S710->sheen_strength_0);
    if(_S731 <= 0.0f)
    {
        return value_1;
    }
    float _S732 = __ldg(&_S710->sheen_roughness_0);
    float2  _S733 = sheen_with_transmittance_0(_S708, _S709, _S731, _S732);
    return make_float3 (_S733.y) * value_1 + make_float3 (_S733.x);
}

__device__ bool unoccluded_0(uint _S734, SearchQuality_0 * _S735, float _S736, float _S737, float _S738, float3  _S739, bool _S740)
{
    Fabric_0 * _S741 = (&(globalParams_0->fabrics_0)[_S734]);
    if((_S739.z) <= 0.0f)
    {
        return false;
    }
    float _S742 = max_height_along_0(_S734, _S736, _S737, _S738, _S739, _S740);
    float _S743 = __ldg(&_S741->lift_0);
    bool _S744 = is_free_0(_S734, _S735, make_float3 (_S736, _S737, _S738 + _S743), _S739, _S740, _S742);
    return _S744;
}

__device__ bool is_lit_0(uint _S745, SearchQuality_0 * _S746, YarnPoint_0 * _S747, float3  _S748)
{
    if(_S747->hole_2)
    {
        return true;
    }
    bool _S749 = _S747->back_2;
    float3  _S750 = to_face_frame_0(_S748, _S747->back_2);
    float _S751 = _S750.z;
    bool _S752 = _S751 < 0.0f;
    float3  _S753 = _S747->normal_4;
    float _S754 = _S747->height_3;
    float3  normal_6;
    float height_10;
    if(_S752)
    {
        SurfacePoint_0 _S755 = surface_at_0(_S745, _S747->x_19, _S747->y_11, !_S749);
        normal_6 = _S755.normal_5;
        height_10 = _S755.height_9;
    }
    else
    {
        normal_6 = _S753;
        height_10 = _S754;
    }
    float3  _S756 = make_float3 (float2 {_S750.x, _S750.y}.x, float2 {_S750.x, _S750.y}.y, (F32_abs((_S751))));
    if((dot_0(normal_6, _S756)) <= 0.0f)
    {
        return false;
    }
    bool _S757 = unoccluded_0(_S745, _S746, _S747->x_19, _S747->y_11, height_10, _S756, _S749 != _S752);
    return _S757;
}

__device__ float3  evaluate_0(uint _S758, SearchQuality_0 * _S759, YarnPoint_0 * _S760, float3  _S761, float3  _S762)
{
    float3  _S763 = scattered_0(_S758, _S760, to_face_frame_0(_S761, _S760->back_2), to_face_frame_0(_S762, _S760->back_2));
    bool _S764;
    if((F32_max((_S763.x), ((F32_max((_S763.y), (_S763.z)))))) <= 0.0f)
    {
        _S764 = true;
    }
    else
    {
        bool _S765 = is_lit_0(_S758, _S759, _S760, _S761);
        _S764 = !_S765;
    }
    if(_S764)
    {
        return make_float3 (0.0f);
    }
    return _S763;
}

__device__ float straight_through_0(uint _S766, YarnPoint_0 * _S767, float3  _S768)
{
    Fabric_0 * _S769 = (&(globalParams_0->fabrics_0)[_S766]);
    if(!_S767->hole_2)
    {
        return 0.0f;
    }
    float _S770 = __ldg(&_S769->sheen_strength_0);
    if(_S770 <= 0.0f)
    {
        return 1.0f;
    }
    float _S771 = (F32_abs((_S768.z)));
    float _S772 = __ldg(&_S769->sheen_roughness_0);
    return 1.0f - _S770 * sheen_lobe_0(_S771, _S772).z;
}

__device__ float4  light_of_point_0(Frame_0 * _S773, uint _S774, VisiblePoint_0 * _S775, float2  _S776)
{
    SearchQuality_0 _S777 = default_quality_0();
    float3  _S778 = to_local_0(_S775, _S775->view_0);
    float _S779 = _S776.x;
    float _S780 = _S776.y;
    SearchQuality_0 _S781 = _S777;
    YarnPoint_0 _S782 = locate_yarn_0(_S774, &_S781, _S779, _S780, _S778);
    float3  _S783 = make_float3 (0.0f);
    uint number_1 = 0U;
    float3  radiance_1 = _S783;
    for(;;)
    {
        if(number_1 < (_S773->lights_0))
        {
        }
        else
        {
            break;
        }
        Light_0 _S784 = slang_ldg_3((&(globalParams_0->lights_1)[number_1]));
        Light_0 _S785 = _S784;
        float3  irradiance_2;
        float3  _S786 = towards_light_0(&_S785, _S775->position_0, &irradiance_2);
        float3  _S787 = to_local_0(_S775, _S786);
        SearchQuality_0 _S788 = _S777;
        YarnPoint_0 _S789 = _S782;
        float3  _S790 = evaluate_0(_S774, &_S788, &_S789, _S787, _S778);
        float3  radiance_2 = radiance_1 + irradiance_2 * _S790;
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    YarnPoint_0 _S791 = _S782;
    float _S792 = straight_through_0(_S774, &_S791, _S778);
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - _S792);
}

extern "C" __global__ void shade_points()
{
    uint _S793;
    uint3  _S794 = blockIdx * blockDim + threadIdx;
    Frame_0 _S795 = slang_ldg_0((&(globalParams_0->frames_0)[int(0)]));
    bool _S796;
    if((_S794.x) >= (_S795.width_0))
    {
        _S796 = true;
    }
    else
    {
        _S796 = (_S794.y) >= (_S795.height_0);
    }
    if(_S796)
    {
        return;
    }
    uint2  _S797 = uint2 {_S794.x, _S794.y};
    int2  _S798 = make_int2 ((int)_S797.x, (int)_S797.y);
    int3  _S799 = make_int3 (_S798.x, _S798.y, int(0));
    uint _S800 = (tex2Dfetch_int<uint>((globalParams_0->visible_faces_0), ((_S799)).x, ((_S799)).y, ((_S799)).z));
    float4  _S801 = make_float4 (0.0f);
    float4  sum_0;
    if(_S800 > 0U)
    {
        uint _S802 = _S800 - 1U;
        uint _S803 = __ldg((&(globalParams_0->face_fabrics_0)[_S802]));
        Frame_0 _S804 = _S795;
        VisiblePoint_0 _S805 = visible_point_0(&_S804, _S803, _S802, _S797);
        uint k_0 = 0U;
        sum_0 = _S801;
        for(;;)
        {
            _S793 = _S795.samples_0;
            if(k_0 < (_S795.samples_0))
            {
            }
            else
            {
                break;
            }
            float2  _S806 = footprint_sample_0(_S797, _S795.pass_number_0 * _S795.samples_0 + k_0);
            float2  _S807 = _S805.draft_0 + make_float2 (_S806.x) * _S805.draft_dx_0 + make_float2 (_S806.y) * _S805.draft_dy_0;
            Frame_0 _S808 = _S795;
            VisiblePoint_0 _S809 = _S805;
            float4  _S810 = light_of_point_0(&_S808, _S803, &_S809, _S807);
            float4  sum_1 = sum_0 + _S810;
            k_0 = k_0 + 1U;
            sum_0 = sum_1;
        }
        sum_0 = sum_0 / make_float4 (float(_S793));
    }
    else
    {
        sum_0 = _S801;
    }
    Frame_0 _S811 = _S795;
    accumulate_0(&_S811, _S797, sum_0);
    return;
}

