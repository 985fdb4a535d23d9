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

__device__ float saturate_0(float x_9)
{
    return clamp_0(x_9, 0.0f, 1.0f);
}

__device__ float3  min_0(float3  x_10, float3  y_6)
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
        *_slang_vector_get_element_ptr(&result_4, i_2) = (F32_min((_slang_vector_get_element(x_10, i_2)), (_slang_vector_get_element(y_6, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_4;
}

__device__ float3  max_0(float3  x_11, float3  y_7)
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
        *_slang_vector_get_element_ptr(&result_5, i_3) = (F32_max((_slang_vector_get_element(x_11, i_3)), (_slang_vector_get_element(y_7, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_5;
}

__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float2  frac_0(float2  x_12)
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
        *_slang_vector_get_element_ptr(&result_6, i_4) = (F32_frac((_slang_vector_get_element(x_12, i_4))));
        i_4 = i_4 + int(1);
    }
    return result_6;
}

__device__ float3  lerp_1(float3  x_13, float3  y_8, float3  s_1)
{
    return x_13 + (y_8 - x_13) * s_1;
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

__device__ Vertex_0 slang_ldg_0(Vertex_0 * ptr_0)
{
    float _S7 = __ldg(&ptr_0->x_1);
    float _S8 = __ldg(&ptr_0->y_1);
    float _S9 = __ldg(&ptr_0->z_1);
    float _S10 = __ldg(&ptr_0->normal_x_0);
    float _S11 = __ldg(&ptr_0->normal_y_0);
    float _S12 = __ldg(&ptr_0->normal_z_0);
    float _S13 = __ldg(&ptr_0->u_0);
    float _S14 = __ldg(&ptr_0->v_0);
    Vertex_0 _S15 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14 };
    return _S15;
}

__device__ float3  position_of_0(Vertex_0 * vertex_0)
{
    return make_float3 (vertex_0->x_1, vertex_0->y_1, vertex_0->z_1);
}

__device__ float square_0(float3  v_1)
{
    return dot_0(v_1, v_1);
}

__device__ float3  normal_of_0(Vertex_0 * vertex_1)
{
    return make_float3 (vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

__device__ float square_1(float x_14)
{
    return x_14 * x_14;
}

__device__ float natural_logarithm_0(float x_15)
{
    uint _S16 = (F32_asuint((x_15)));
    float exponent_0 = float(int(_S16 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S16 & 8388607U) | 1056964608U)));
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
    float _S17 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S17 - exponent_1 * 0.00021219444170129f - 0.5f * _S17) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_16)
{
    return natural_logarithm_0(x_16) * 1.4426950216293335f;
}

__device__ float exponential_0(float x_17)
{
    float _S18 = clamp_0(x_17, -87.0f, 88.0f);
    float _S19 = (F32_floor((_S18 * 1.4426950216293335f + 0.5f)));
    float _S20 = _S18 - _S19 * 0.693359375f + _S19 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S20 + 0.00139819993637502f) * _S20 + 0.00833345204591751f) * _S20 + 0.04166579619050026f) * _S20 + 0.1666666567325592f) * _S20 + 0.5f;
    float _S21 = (U32_asfloat((uint(int(_S19) + int(127)) << int(23))));
    float _S22;
    if(x_17 < -87.0f)
    {
        _S22 = 0.0f;
    }
    else
    {
        _S22 = (p_0 * _S20 * _S20 + _S20 + 1.0f) * _S21;
    }
    return _S22;
}

__device__ float3  map_texel_0(uint index_0)
{
    uint _S23 = __ldg((&(globalParams_0->scene_words_0)[index_0]));
    float3  _S24 = make_float3 (float(_S23 & 1023U), float((_S23 >> int(10)) & 1023U), float(_S23 >> int(20))) / make_float3 (1023.0f);
    return _S24 * _S24;
}

__device__ float3  map_level_0(uint first_0, uint side_0, float2  uv_0)
{
    float _S25 = uv_0.x;
    float _S26 = float(side_0);
    float _S27 = (_S25 - (F32_floor((_S25)))) * _S26 - 0.5f;
    float _S28 = uv_0.y;
    float _S29 = (_S28 - (F32_floor((_S28)))) * _S26 - 0.5f;
    float _S30 = (F32_floor((_S27)));
    int _S31 = int(side_0);
    uint _S32 = side_0 - 1U;
    uint _S33 = uint(int(_S30) + _S31) & _S32;
    float _S34 = (F32_floor((_S29)));
    uint _S35 = uint(int(_S34) + _S31) & _S32;
    uint _S36 = (_S33 + 1U) & _S32;
    uint _S37 = first_0 + _S35 * side_0;
    float3  _S38 = make_float3 (_S27 - _S30);
    uint _S39 = first_0 + ((_S35 + 1U) & _S32) * side_0;
    return lerp_1(lerp_1(map_texel_0(_S37 + _S33), map_texel_0(_S37 + _S36), _S38), lerp_1(map_texel_0(_S39 + _S33), map_texel_0(_S39 + _S36), _S38), make_float3 (_S29 - _S34));
}

__device__ uint scramble_0(uint value_0)
{
    uint _S40 = value_0 * 747796405U + 2891336453U;
    uint _S41 = ((_S40 >> ((_S40 >> int(28)) + 4U)) ^ _S40) * 277803737U;
    return (_S41 >> int(22)) ^ _S41;
}

__device__ float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  pixel_sequence_0(uint2  pixel_0, uint index_1, uint stream_1)
{
    uint _S42 = pixel_0.x;
    uint _S43 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S42, _S43, stream_1), uniform_hash_0(_S42, _S43, stream_1 + 1U)) + make_float2 (float(index_1 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f));
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
    float3  face_normal_0;
    float2  uv_1;
    float2  draft_per_uv_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_0)
{
    return make_float3 (dot_0(direction_0, point_0->axis_x_0), dot_0(direction_0, point_0->axis_y_0), dot_0(direction_0, point_0->normal_0));
}

__device__ float3  to_face_frame_0(float3  direction_1, bool back_1)
{
    float2  _S44 = float2 {direction_1.x, direction_1.y};
    float _S45;
    if(back_1)
    {
        _S45 = - direction_1.z;
    }
    else
    {
        _S45 = direction_1.z;
    }
    return make_float3 (_S44.x, _S44.y, _S45);
}

__device__ Family_0 slang_ldg_1(Family_0 * ptr_1)
{
    uint _S46 = __ldg(&ptr_1->is_alike_0);
    float _S47 = __ldg(&ptr_1->count_0);
    float _S48 = __ldg(&ptr_1->inverse_count_0);
    float _S49 = __ldg(&ptr_1->half_inverse_count_0);
    float _S50 = __ldg(&ptr_1->size_0);
    float _S51 = __ldg(&ptr_1->inverse_size_0);
    float _S52 = __ldg(&ptr_1->half_width_0);
    float _S53 = __ldg(&ptr_1->start_0);
    float _S54 = __ldg(&ptr_1->period_0);
    float _S55 = __ldg(&ptr_1->inverse_period_0);
    float _S56 = __ldg(&ptr_1->bins_0);
    uint _S57 = __ldg(&ptr_1->first_thread_table_0);
    uint _S58 = __ldg(&ptr_1->place_table_0);
    uint _S59 = __ldg(&ptr_1->bend_table_0);
    float _S60 = __ldg(&ptr_1->height_scale_0);
    float _S61 = __ldg(&ptr_1->twist_sine_0);
    float _S62 = __ldg(&ptr_1->twist_cosine_0);
    float _S63 = __ldg(&ptr_1->level_0);
    float _S64 = __ldg(&ptr_1->roughness_0);
    uint _S65 = __ldg(&ptr_1->albedo_table_0);
    uint _S66 = __ldg(&ptr_1->albedo_stride_0);
    uint _S67 = __ldg(&ptr_1->before_0);
    float _S68 = __ldg(&ptr_1->visible_total_0);
    float _S69 = __ldg(&ptr_1->smallest_box_0);
    uint _S70 = __ldg(&ptr_1->quantities_0);
    uint _S71 = __ldg(&ptr_1->colour_mean_0);
    uint _S72 = __ldg(&ptr_1->colour_axes_0);
    uint _S73 = __ldg(&ptr_1->colour_threads_0);
    uint _S74 = __ldg(&ptr_1->colour_areas_0);
    float _S75 = __ldg(&ptr_1->area_unit_0);
    float _S76 = __ldg(&ptr_1->crossing_area_0);
    Family_0 _S77 = { _S46, _S47, _S48, _S49, _S50, _S51, _S52, _S53, _S54, _S55, _S56, _S57, _S58, _S59, _S60, _S61, _S62, _S63, _S64, _S65, _S66, _S67, _S68, _S69, _S70, _S71, _S72, _S73, _S74, _S75, _S76 };
    return _S77;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_2)
{
    Family_0 _S78 = slang_ldg_1((&(globalParams_0->families_0)[family_0]));
    Family_0 _S79 = slang_ldg_1((&(globalParams_0->families_0)[family_0]));
    float _S80 = (F32_floor(((F32_fma((index_2), (_S78.inverse_count_0), (_S79.half_inverse_count_0))))));
    float _S81 = - _S80;
    Family_0 _S82 = slang_ldg_1((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S80, (F32_fma((_S81), (_S82.count_0), (index_2))));
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
    Family_0 _S83 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    float _S84 = (F32_floor((position_1 * _S83.inverse_size_0)));
    Cell_0 cell_1;
    float _S85 = - _S84;
    Family_0 _S86 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    float _S87 = (F32_fma((_S85), (_S86.size_0), (position_1)));
    (&cell_1)->below_0 = _S87;
    Family_0 _S88 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->above_0 = _S88.size_0 - _S87;
    Family_0 _S89 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->across_0 = _S87 - 0.5f * _S89.size_0;
    Family_0 _S90 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->half_width_1 = _S90.half_width_0;
    float _S91 = turns_and_remainder_0(family_1, _S84).y;
    Family_0 _S92 = slang_ldg_1((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->thread_1 = uint(clamp_0(_S91, 0.0f, _S92.count_0 - 1.0f));
    return cell_1;
}

__device__ float table_number_0(uint index_3)
{
    uint _S93 = __ldg((&(globalParams_0->words_0)[index_3]));
    return (U32_asfloat((_S93)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_2)
{
    Family_0 _S94 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float _S95 = position_2 - _S94.start_0;
    Family_0 _S96 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S95 * _S96.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S97 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float _S98 = turns_1 * _S97.period_0;
    Family_0 _S99 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    float _S100 = turns_1 * _S99.bins_0;
    Family_0 _S101 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S102 = uint(clamp_0(_S100, 0.0f, _S101.bins_0 - 1.0f));
    Family_0 _S103 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S104 = __ldg((&(globalParams_0->words_0)[_S103.first_thread_table_0 + _S102]));
    Family_0 _S105 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S106;
    if(_S98 >= (table_number_0(_S105.place_table_0 + _S104 * 4U + 1U)))
    {
        _S106 = 1U;
    }
    else
    {
        _S106 = 0U;
    }
    uint _S107 = _S104 + _S106;
    Family_0 _S108 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S109 = (U32_min((_S107), (uint(_S108.count_0) - 1U)));
    Family_0 _S110 = slang_ldg_1((&(globalParams_0->families_0)[family_2]));
    uint _S111 = _S110.place_table_0 + _S109 * 4U;
    Cell_0 cell_2;
    (&cell_2)->thread_1 = _S109;
    (&cell_2)->below_0 = _S98 - table_number_0(_S111);
    (&cell_2)->above_0 = table_number_0(_S111 + 1U) - _S98;
    (&cell_2)->across_0 = _S98 - table_number_0(_S111 + 2U);
    (&cell_2)->half_width_1 = table_number_0(_S111 + 3U);
    return cell_2;
}

__device__ Cell_0 locate_0(uint family_3, float position_3)
{
    Family_0 _S112 = slang_ldg_1((&(globalParams_0->families_0)[family_3]));
    if((_S112.is_alike_0) != 0U)
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

__device__ Shown_0 shown_at_0(Crossing_0 * crossing_0, bool back_2)
{
    bool _S113 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S114 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S115;
    if(_S113)
    {
        if(!_S114)
        {
            _S115 = true;
        }
        else
        {
            _S115 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S115 = false;
    }
    (&shown_0)->is_warp_0 = _S115;
    if(!_S113)
    {
        _S115 = !_S114;
    }
    else
    {
        _S115 = false;
    }
    (&shown_0)->hole_0 = _S115;
    uint _S116;
    if((&shown_0)->is_warp_0)
    {
        _S116 = crossing_0->warp_word_0;
    }
    else
    {
        _S116 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S116;
    (&shown_0)->on_top_0 = ((_S116 & 1U) == 1U) != back_2;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_1, Cell_0 * second_0)
{
    Cell_0 cell_3;
    uint _S117;
    if(is_first_0)
    {
        _S117 = first_1->thread_1;
    }
    else
    {
        _S117 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S117;
    float _S118;
    if(is_first_0)
    {
        _S118 = first_1->across_0;
    }
    else
    {
        _S118 = second_0->across_0;
    }
    (&cell_3)->across_0 = _S118;
    if(is_first_0)
    {
        _S118 = first_1->half_width_1;
    }
    else
    {
        _S118 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S118;
    if(is_first_0)
    {
        _S118 = first_1->below_0;
    }
    else
    {
        _S118 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S118;
    if(is_first_0)
    {
        _S118 = first_1->above_0;
    }
    else
    {
        _S118 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S118;
    return cell_3;
}

__device__ float boundary_0(uint family_4, uint thread_2, int step_0)
{
    float2  _S119 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    float _S120 = _S119.x;
    Family_0 _S121 = slang_ldg_1((&(globalParams_0->families_0)[family_4]));
    Family_0 _S122 = slang_ldg_1((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S120), (_S121.period_0), (table_number_0(_S122.place_table_0 + uint(_S119.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_3, int first_2, int last_0)
{
    Family_0 _S123 = slang_ldg_1((&(globalParams_0->families_0)[family_5]));
    if((_S123.is_alike_0) != 0U)
    {
        float _S124 = float(last_0 - first_2);
        Family_0 _S125 = slang_ldg_1((&(globalParams_0->families_0)[family_5]));
        return _S124 * _S125.size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_2);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

__device__ Bend_0 bend_of_0(uint family_6, uint thread_4)
{
    Family_0 _S126 = slang_ldg_1((&(globalParams_0->families_0)[family_6]));
    Family_0 _S127 = slang_ldg_1((&(globalParams_0->families_0)[family_6]));
    uint _S128;
    if((_S127.is_alike_0) != 0U)
    {
        _S128 = 0U;
    }
    else
    {
        _S128 = thread_4 * 4U;
    }
    uint _S129 = _S126.bend_table_0 + _S128;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S129);
    (&bend_0)->half_tangent_0 = table_number_0(_S129 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S129 + 2U);
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
    int _S130 = int((word_1 >> int(1)) & 127U);
    int _S131 = int((word_1 >> int(8)) & 127U);
    int _S132 = int((word_1 >> int(15)) & 63U);
    int _S133 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S134 = crossed_0->thread_1;
    int _S135 = - _S130;
    float _S136 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_1, _S135, int(0));
    (&run_0)->from_start_0 = _S136;
    int _S137 = _S131 + int(1);
    float _S138 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_1, int(1), _S137);
    (&run_0)->to_end_0 = _S138;
    bool _S139 = _S136 < _S138;
    (&run_0)->near_start_0 = _S139;
    int _S140;
    if(_S139)
    {
        _S140 = _S135 - _S132;
    }
    else
    {
        _S140 = _S137;
    }
    int _S141;
    if((&run_0)->near_start_0)
    {
        _S141 = _S135;
    }
    else
    {
        _S141 = _S137 + _S133;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_5);
    float _S142;
    if((&run_0)->straight_0)
    {
        _S142 = 1.0e+06f;
    }
    else
    {
        _S142 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_0 = _S142;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S134, _S140, _S141)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S130 == int(0);
    (&run_0)->last_crossing_0 = _S131 == int(0);
    return run_0;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_4)
{
    float _S143 = cell_4->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S144 = clamp_0(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_1 = _S144;
    float _S145 = _S143 * _S143 - square_1(_S144);
    float _S146 = (F32_rsqrt((_S145)));
    (&section_0)->drop_0 = _S143 - _S145 * _S146;
    (&section_0)->slope_0 = - _S144 * _S146;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    Family_0 _S147 = slang_ldg_1((&(globalParams_0->families_0)[family_7]));
    if((_S147.is_alike_0) != 0U)
    {
        Family_0 _S148 = slang_ldg_1((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S148.bend_table_0 + 3U);
    }
    Family_0 _S149 = slang_ldg_1((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S149.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S150 = crossed_1->below_0;
    float _S151 = crossed_1->above_0;
    bool _S152 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S153 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S154;
    if(_S152)
    {
        _S154 = _S150 - crossed_1->across_0;
    }
    else
    {
        _S154 = _S151 + crossed_1->across_0;
    }
    float _S155 = _S154 - crossed_1->half_width_1;
    bool _S156;
    if(_S152)
    {
        _S156 = run_1->first_crossing_0;
    }
    else
    {
        _S156 = run_1->last_crossing_0;
    }
    bool _S157 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S154 = 0.0f;
    }
    else
    {
        Family_0 _S158 = slang_ldg_1((&(globalParams_0->families_0)[other_1]));
        _S154 = _S158.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_1, int(0));
    }
    float _S159;
    if(_S157 != _S156)
    {
        _S159 = 0.0f;
    }
    else
    {
        Family_0 _S160 = slang_ldg_1((&(globalParams_0->families_0)[other_1]));
        uint _S161 = crossed_1->thread_1;
        int _S162;
        if(_S152)
        {
            _S162 = int(-1);
        }
        else
        {
            _S162 = int(1);
        }
        _S159 = _S160.height_scale_0 * edge_drop_0(other_1, _S161, _S162);
    }
    float _S163 = 1.0f / (F32_max((2.0f * _S155), (9.999999960041972e-13f)));
    float _S164 = clamp_0((_S155 - _S153) * _S163, 0.0f, 1.0f);
    float _S165 = _S154 + (_S159 - _S154) * (_S164 * _S164 * (3.0f - 2.0f * _S164));
    float _S166 = (_S154 - _S159) * (6.0f * _S164 * (1.0f - _S164) * _S163);
    if(_S152)
    {
        _S154 = 1.0f;
    }
    else
    {
        _S154 = -1.0f;
    }
    return make_float2 (_S165, _S166 * _S154);
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
    float _S167 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S167)))), (9.99999971718068537e-10f)));
    float _S168 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S168)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S167 > 0.0f;
    (&control_0)->up_0 = _S168 > 0.0f;
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
    float _S169;
    if(forwards_0)
    {
        _S169 = cell_5->across_0;
    }
    else
    {
        _S169 = - cell_5->across_0;
    }
    float _S170;
    if(forwards_0)
    {
        _S170 = cell_5->above_0;
    }
    else
    {
        _S170 = cell_5->below_0;
    }
    bool _S171;
    if(forwards_0)
    {
        _S171 = run_2->last_crossing_0;
    }
    else
    {
        _S171 = run_2->first_crossing_0;
    }
    bool _S172;
    if(forwards_0)
    {
        _S172 = run_2->first_crossing_0;
    }
    else
    {
        _S172 = run_2->last_crossing_0;
    }
    float _S173 = cell_5->half_width_1;
    float _S174 = - cell_5->half_width_1;
    bool _S175 = _S169 < _S174;
    bool _S176 = _S169 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S171 = !_S171;
    }
    else
    {
        _S171 = false;
    }
    if(_S171)
    {
        _S171 = !shown_2->hole_0;
    }
    else
    {
        _S171 = false;
    }
    bool _S177;
    if(_S171)
    {
        _S177 = shown_2->on_top_0;
    }
    else
    {
        _S177 = false;
    }
    if(_S177)
    {
        if(_S172)
        {
            _S172 = _S175;
        }
        else
        {
            _S172 = false;
        }
        _S172 = !_S172;
    }
    else
    {
        _S172 = false;
    }
    if(shown_2->hole_0)
    {
        _S171 = true;
    }
    else
    {
        if(_S171)
        {
            _S171 = !shown_2->on_top_0;
        }
        else
        {
            _S171 = false;
        }
    }
    float _S178;
    if(_S175)
    {
        _S178 = _S174;
    }
    else
    {
        _S178 = _S173;
    }
    float _S179 = _S178 - _S169;
    if(_S171)
    {
        _S169 = 2.0f * _S170 + _S169 - _S173;
    }
    else
    {
        _S169 = _S170;
    }
    if(_S172)
    {
        if(forwards_0)
        {
            _S169 = run_2->to_end_0;
        }
        else
        {
            _S169 = run_2->from_start_0;
        }
        return _S169;
    }
    if(_S176)
    {
    }
    else
    {
        _S169 = _S179;
    }
    return _S169;
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
    float _S180 = previous_1->rate_0;
    float _S181 = previous_1->rate_0 * step_4;
    float _S182 = rate_1 * step_4;
    bool _S183;
    if(!previous_1->known_0)
    {
        _S183 = true;
    }
    else
    {
        _S183 = here_0->hole_1;
    }
    if(_S183)
    {
        _S183 = true;
    }
    else
    {
        _S183 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S183)
    {
        _S183 = true;
    }
    else
    {
        _S183 = _S180 >= 0.0f;
    }
    if(_S183)
    {
        _S183 = true;
    }
    else
    {
        _S183 = rate_1 <= 0.0f;
    }
    if(_S183)
    {
        return -1.0f;
    }
    float _S184 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S181) >= 0.0f)
    {
        _S183 = (3.0f * clearance_1 - _S182) >= 0.0f;
    }
    else
    {
        _S183 = false;
    }
    if(_S183)
    {
        return -1.0f;
    }
    float _S185 = clearance_1 - _S184;
    float _S186 = 6.0f * _S185 - 4.0f * _S181 - 2.0f * _S182;
    float _S187 = -2.0f * _S181 / (F32_max((_S186 + (F32_sqrt(((F32_max((_S186 * _S186 - 4.0f * (3.0f * (_S181 + _S182 - 2.0f * _S185)) * _S181), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S188 = 1.0f - _S187;
    float _S189 = (_S184 * (2.0f * _S187 + 1.0f) + _S181 * _S187) * _S188 * _S188;
    float _S190 = (clearance_1 * (2.0f * _S188 + 1.0f) - _S182 * _S188) * _S187 * _S187;
    if(_S187 > 0.01999999955296516f)
    {
        _S183 = _S188 > 0.01999999955296516f;
    }
    else
    {
        _S183 = false;
    }
    if(_S183)
    {
        _S183 = (_S189 + _S190) < 0.0f;
    }
    else
    {
        _S183 = false;
    }
    float _S191;
    if(_S183)
    {
        _S191 = _S188 * step_4;
    }
    else
    {
        _S191 = -1.0f;
    }
    return _S191;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S192 = here_1->hole_1;
    float _S193;
    if(here_1->hole_1)
    {
        _S193 = 1.0e+09f;
    }
    else
    {
        _S193 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S193;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S194;
    if(!_S192)
    {
        _S194 = !is_cell_exit_0;
    }
    else
    {
        _S194 = false;
    }
    (&previous_2)->known_0 = _S194;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_0, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_0->per_x_0), (side_y_1 * this_0->per_y_0)))), (0.0f))) + this_0->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_1, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S195 = (F32_min((here_2->edge_x_0 * this_1->per_x_0), (here_2->edge_y_0 * this_1->per_y_0)));
    bool _S196;
    if(!here_2->hole_1)
    {
        _S196 = (rate_3 * _S195 + clearance_3) < 0.0f;
    }
    else
    {
        _S196 = false;
    }
    if(_S196)
    {
        _S196 = _S195 > (2.0f * this_1->epsilon_0);
    }
    else
    {
        _S196 = false;
    }
    float _S197 = this_1->step_2;
    float _S198;
    if(_S196)
    {
        _S198 = _S195 - this_1->epsilon_0;
    }
    else
    {
        _S198 = (F32_max((_S195), (0.0f))) + this_1->epsilon_0;
    }
    return (F32_min((_S197), (_S198)));
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
    float _S199 = end_0 - start_1;
    float _S200 = start_rate_0 + end_rate_0 - 2.0f * _S199;
    float _S201 = 3.0f * _S199 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S199), (9.99999968265522539e-21f)));
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
        float _S202 = clamp_0(share_1 - (((_S200 * share_1 + _S201) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S200 * share_1 + 2.0f * _S201) * share_1 + start_rate_0), (0.10000000149011612f * _S199 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S203 = i_5 + int(1);
        share_1 = _S202;
        i_5 = _S203;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float2  fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S204 = along_slope_0 * along_slope_0 + 1.0f;
    float _S205 = (F32_rsqrt((_S204)));
    float _S206 = sine_1 * _S205 * (F32_rsqrt((_S204 + across_slope_0 * across_slope_0)));
    return make_float2 (- _S206 * _S204, _S206 * across_slope_0 * along_slope_0 + cosine_0 * _S205);
}

__device__ float arc_sine_0(float x_18)
{
    float _S207 = (F32_abs((x_18)));
    bool _S208 = _S207 > 0.5f;
    float _S209;
    if(_S208)
    {
        _S209 = 0.5f * (1.0f - _S207);
    }
    else
    {
        _S209 = _S207 * _S207;
    }
    float _S210;
    if(_S208)
    {
        _S210 = (F32_sqrt(((F32_max((_S209), (0.0f))))));
    }
    else
    {
        _S210 = _S207;
    }
    float _S211 = ((((0.04216320067644119f * _S209 + 0.02418131195008755f) * _S209 + 0.04547002539038658f) * _S209 + 0.07495300471782684f) * _S209 + 0.16666752099990845f) * _S209 * _S210 + _S210;
    if(_S208)
    {
        _S209 = 1.57079637050628662f - 2.0f * _S211;
    }
    else
    {
        _S209 = _S211;
    }
    if(x_18 < 0.0f)
    {
        _S209 = - _S209;
    }
    return _S209;
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
    Family_0 _S212 = slang_ldg_1((&(globalParams_0->families_0)[family_8]));
    Family_0 _S213 = slang_ldg_1((&(globalParams_0->families_0)[family_8]));
    return table_albedos_0(_S212.albedo_table_0 + _S213.albedo_stride_0 * thread_7);
}

__device__ float thread_gain_0(uint thread_8, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_8, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

__device__ float bounded_gain_0(float gain_1, float3  albedo_0, float3  room_0)
{
    float3  _S214 = room_0 / max_0(albedo_0, make_float3 (9.99999997475242708e-07f));
    return (F32_min((gain_1), ((F32_max(((F32_min(((F32_min((_S214.x), (_S214.y)))), (_S214.z)))), (0.0f))))));
}

__device__ float fibre_gain_0(uint thread_9, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * ((F32_min((- natural_logarithm_0(uniform_hash_0(thread_9, cell_6, seed_2 ^ 2654435769U))), (10.0f))) - 1.0f) + 1.0f;
}

__device__ Albedos_0 tinted_0(Albedos_0 * albedos_1, float3  tint_0)
{
    Albedos_0 result_7 = *albedos_1;
    (&result_7)->diffuse_reflect_0 = (&result_7)->diffuse_reflect_0 * tint_0;
    (&result_7)->diffuse_transmit_0 = (&result_7)->diffuse_transmit_0 * tint_0;
    return result_7;
}

__device__ float scene_number_0(uint index_5)
{
    uint _S215 = __ldg((&(globalParams_0->scene_words_0)[index_5]));
    return (U32_asfloat((_S215)));
}

struct Choice_0
{
    uint index_6;
    float remainder_0;
};

__device__ Choice_0 choose_0(uint table_0, uint count_1, float number_0)
{
    uint high_0 = count_1;
    uint low_0 = 0U;
    for(;;)
    {
        if((high_0 - low_0) > 1U)
        {
        }
        else
        {
            break;
        }
        uint _S216 = (low_0 + high_0) / 2U;
        if((scene_number_0(table_0 + _S216)) <= number_0)
        {
            low_0 = _S216;
        }
        else
        {
            high_0 = _S216;
        }
    }
    uint _S217 = table_0 + low_0;
    float _S218 = scene_number_0(_S217);
    float _S219 = scene_number_0(_S217 + 1U);
    Choice_0 choice_0;
    (&choice_0)->index_6 = low_0;
    (&choice_0)->remainder_0 = saturate_0((number_0 - _S218) / (F32_max((_S219 - _S218), (9.999999960041972e-13f))));
    return choice_0;
}

__device__ float mean_0(float3  colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

__device__ float2  sine_cosine_0(float x_19)
{
    float _S220 = (F32_floor((x_19 * 0.63661974668502808f + 0.5f)));
    float _S221 = x_19 - _S220 * 1.5703125f - _S220 * 0.00048375129699707f - _S220 * 7.54979012640433211e-08f;
    float _S222 = _S221 * _S221;
    float _S223 = ((-0.00019515295571182f * _S222 + 0.00833216123282909f) * _S222 - 0.16666655242443085f) * _S222 * _S221 + _S221;
    float _S224 = ((0.00002443315679557f * _S222 - 0.00138873164542019f) * _S222 + 0.04166664555668831f) * _S222 * _S222 - 0.5f * _S222 + 1.0f;
    uint _S225 = uint(int(_S220)) & 3U;
    float2  _S226;
    if((_S225 & 1U) != 0U)
    {
        _S226 = make_float2 (_S224, _S223);
    }
    else
    {
        _S226 = make_float2 (_S223, _S224);
    }
    float _S227;
    if((_S225 & 2U) != 0U)
    {
        _S227 = - _S226.x;
    }
    else
    {
        _S227 = _S226.x;
    }
    float _S228;
    if(((_S225 + 1U) & 2U) != 0U)
    {
        _S228 = - _S226.y;
    }
    else
    {
        _S228 = _S226.y;
    }
    return make_float2 (_S227, _S228);
}

__device__ Light_0 slang_ldg_2(Light_0 * ptr_2)
{
    uint _S229 = __ldg(&ptr_2->is_point_0);
    float _S230 = __ldg(&ptr_2->x_0);
    float _S231 = __ldg(&ptr_2->y_0);
    float _S232 = __ldg(&ptr_2->z_0);
    float _S233 = __ldg(&ptr_2->red_0);
    float _S234 = __ldg(&ptr_2->green_0);
    float _S235 = __ldg(&ptr_2->blue_0);
    Light_0 _S236 = { _S229, _S230, _S231, _S232, _S233, _S234, _S235 };
    return _S236;
}

__device__ float diffuse_reflection_0(float3  light_0, float3  normal_1, float blend_0)
{
    float _S237 = light_0.z;
    if(_S237 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp_0((F32_max((_S237), (0.0f))), (F32_max((dot_0(light_0, normal_1)), (0.0f))), blend_0);
}

__device__ float projected_area_1(float3  direction_3, float3  tangent_0, float roughness_1)
{
    float _S238 = dot_0(direction_3, tangent_0);
    return (F32_sqrt(((F32_max(((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S238 * _S238 + 1.0f), (roughness_1 * roughness_1))))));
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
    float _S239 = roughness_2 * roughness_2;
    float _S240 = squared_along_0 * (1.0f - _S239) + _S239;
    return 0.31830987334251404f * _S239 * roughness_2 / (_S240 * _S240);
}

__device__ float density_between_0(float3  light_1, float3  view_1, float3  tangent_1, float roughness_3)
{
    float3  _S241 = light_1 + view_1;
    float _S242 = dot_0(_S241, tangent_1);
    return flake_density_0((F32_min((_S242 * _S242 / (F32_max((square_0(_S241)), (9.999999960041972e-13f)))), (1.0f))), roughness_3);
}

__device__ float reflection_0(float3  light_2, float3  view_2, float3  normal_2, float3  tangent_2, float roughness_4, float optical_depth_1)
{
    float _S243 = dot_0(light_2, normal_2);
    bool _S244;
    if(_S243 <= 0.0f)
    {
        _S244 = true;
    }
    else
    {
        _S244 = (dot_0(view_2, normal_2)) <= 0.0f;
    }
    if(_S244)
    {
        return 0.0f;
    }
    float _S245 = (F32_max((_S243), (9.99999997475242708e-07f)));
    float _S246 = (F32_max((dot_0(view_2, normal_2)), (9.99999997475242708e-07f)));
    float _S247 = projected_area_1(light_2, tangent_2, roughness_4) * _S246 + projected_area_1(view_2, tangent_2, roughness_4) * _S245;
    float _S248 = optical_depth_1 * _S247 / (_S245 * _S246);
    return 0.25f * density_between_0(light_2, view_2, tangent_2, roughness_4) * (_S248 * mean_attenuation_0(_S248)) * _S245 / _S247;
}

__device__ float transmission_0(float3  light_3, float3  view_3, float3  normal_3, float3  tangent_3, float roughness_5, float optical_depth_2)
{
    float _S249 = - dot_0(light_3, normal_3);
    float _S250 = dot_0(view_3, normal_3);
    bool _S251;
    if(_S249 <= 0.0f)
    {
        _S251 = true;
    }
    else
    {
        _S251 = _S250 <= 0.0f;
    }
    if(_S251)
    {
        return 0.0f;
    }
    float _S252 = 1.0f / (F32_max((_S250), (9.99999997475242708e-07f)));
    float _S253 = projected_area_1(light_3, tangent_3, roughness_5) / (F32_max((_S249), (9.99999997475242708e-07f)));
    float _S254 = projected_area_1(view_3, tangent_3, roughness_5) * _S252;
    return density_between_0(light_3, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * (F32_min((_S253), (_S254)))) * mean_attenuation_0(optical_depth_2 * (F32_abs((_S253 - _S254)))) * _S252;
}

__device__ float sheen_scale_0(float x_20, float y_9)
{
    return (((((0.0f * x_20 + (((((-1.1402510404586792f * y_9 + 0.40672621130943298f) * y_9 + 1.65398800373077393f) * y_9 + -1.29730904102325439f) * y_9 + 0.30570998787879944f) * y_9 + -0.0220868494361639f)) * x_20 + (((((-0.21142719686031342f * y_9 + 1.05947399139404297f) * y_9 + -0.41116121411323547f) * y_9 + -0.93859231472015381f) * y_9 + 0.51606941223144531f) * y_9 + 0.05409301072359085f)) * x_20 + (((((1.22944498062133789f * y_9 + -0.45962560176849365f) * y_9 + -1.63861405849456787f) * y_9 + 1.33565104007720947f) * y_9 + -0.45725581049919128f) * y_9 + 0.08243165910243988f)) * x_20 + (((((0.39779931306838989f * y_9 + -1.18879103660583496f) * y_9 + 0.28251591324806213f) * y_9 + 1.168984055519104f) * y_9 + -0.76864629983901978f) * y_9 + 0.0091691892594099f)) * x_20 + (((((-0.26563560962677002f * y_9 + -0.19379159808158875f) * y_9 + 0.2677634060382843f) * y_9 + 0.00270519289188087f) * y_9 + 0.14349560439586639f) * y_9 + 0.10290180146694183f)) * x_20 + (((((-0.20701569318771362f * y_9 + 0.24526430666446686f) * y_9 + 0.19551840424537659f) * y_9 + 0.07586126774549484f) * y_9 + 0.38894739747047424f) * y_9 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_21, float y_10)
{
    return ((((0.0f * x_21 + (((((-0.10608240216970444f * y_10 + 1.99214303493499756f) * y_10 + -1.42255294322967529f) * y_10 + -1.09495604038238525f) * y_10 + 0.59180057048797607f) * y_10 + 0.06902855634689331f)) * x_21 + (((((-0.46220690011978149f * y_10 + -0.29113379120826721f) * y_10 + 1.39025199413299561f) * y_10 + 0.35589990019798279f) * y_10 + -1.17120099067687988f) * y_10 + 0.15940259397029877f)) * x_21 + (((((2.26068711280822754f * y_10 + -3.64728999137878418f) * y_10 + -0.72173482179641724f) * y_10 + 3.07659196853637695f) * y_10 + -0.6827620267868042f) * y_10 + -0.3039557933807373f)) * x_21 + (((((0.81201767921447754f * y_10 + 0.36014080047607422f) * y_10 + -1.72646903991699219f) * y_10 + -0.22630110383033752f) * y_10 + 0.89514690637588501f) * y_10 + -0.10397960245609283f)) * x_21 + (((((-0.37648698687553406f * y_10 + 1.10974001884460449f) * y_10 + 0.17824520170688629f) * y_10 + -1.04968702793121338f) * y_10 + 0.1461234986782074f) * y_10 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_22, float y_11)
{
    return ((((0.0f * x_22 + (((((12.95646953582763672f * y_11 + -21.38032913208007812f) * y_11 + -7.37853097915649414f) * y_11 + 34.55607986450195312f) * y_11 + -23.61347007751464844f) * y_11 + 5.00126314163208008f)) * x_22 + (((((10.91487026214599609f * y_11 + -6.08202791213989258f) * y_11 + -38.2036285400390625f) * y_11 + 53.3440399169921875f) * y_11 + -21.91996002197265625f) * y_11 + 2.01606011390686035f)) * x_22 + (((((-14.52206039428710938f * y_11 + 36.803619384765625f) * y_11 + -22.94047927856445312f) * y_11 + -10.07973003387451172f) * y_11 + 15.77003955841064453f) * y_11 + -4.92722177505493164f)) * x_22 + (((((-7.62505722045898438f * y_11 + 1.27310299873352051f) * y_11 + 31.19523048400878906f) * y_11 + -44.39989852905273438f) * y_11 + 26.44947052001953125f) * y_11 + -8.73507976531982422f)) * x_22 + (((((5.65633487701416016f * y_11 + -17.66820907592773438f) * y_11 + 24.65356063842773438f) * y_11 + -19.38941001892089844f) * y_11 + 11.06159019470214844f) * y_11 + -3.06573700904846191f);
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S255 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S256 = 2.0f * (F32_sqrt((_S255))) - 1.0f;
    float _S257 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_6, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S256, _S257), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S255) * sheen_shear_0(_S256, _S257), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S256, _S257), -60.0f, 60.0f))));
}

__device__ float transformed_cosine_0(float3  light_4, float3  view_4, float scale_0, float shear_0)
{
    float _S258 = light_4.z;
    bool _S259;
    if(_S258 <= 0.0f)
    {
        _S259 = true;
    }
    else
    {
        _S259 = (view_4.z) <= 0.0f;
    }
    if(_S259)
    {
        return 0.0f;
    }
    float2  _S260 = float2 {view_4.x, view_4.y};
    float _S261 = dot_1(_S260, _S260);
    float2  _S262;
    if(_S261 > 9.99999968265522539e-21f)
    {
        _S262 = _S260 * make_float2 ((F32_rsqrt((_S261))));
    }
    else
    {
        _S262 = make_float2 (1.0f, 0.0f);
    }
    float _S263 = scale_0 * dot_1(float2 {light_4.x, light_4.y}, _S262) + shear_0 * _S258;
    float _S264 = scale_0 * (light_4.y * _S262.x - light_4.x * _S262.y);
    float _S265 = _S263 * _S263 + _S264 * _S264 + _S258 * _S258;
    return 0.31830987334251404f * scale_0 * scale_0 * _S258 / (F32_max((_S265 * _S265), (9.99999968265522539e-21f)));
}

__device__ float2  sheen_with_transmittance_0(float3  light_5, float3  view_5, float strength_0, float roughness_7)
{
    float3  _S266 = sheen_lobe_0(view_5.z, roughness_7);
    float _S267 = strength_0 * _S266.z;
    return make_float2 (_S267 * transformed_cosine_0(light_5, view_5, _S266.x, _S266.y), 1.0f - _S267);
}

__device__ void accumulate_0(uint index_7, float4  light_6)
{
    float4  * _S268 = (&(globalParams_0->radiance_0)[index_7]);
    *_S268 = *_S268 + make_float4 ((&(globalParams_0->layers_0)[index_7])->share_0) * light_6;
    (&(globalParams_0->layers_0)[index_7])->share_0 = (&(globalParams_0->layers_0)[index_7])->share_0 * (1.0f - light_6.w);
    return;
}

__device__ float3  camera_right_0(int _S269)
{
    Frame_0 * _S270 = (&(globalParams_0->frames_0)[_S269]);
    float _S271 = __ldg(&_S270->right_x_0);
    float _S272 = __ldg(&_S270->right_y_0);
    float _S273 = __ldg(&_S270->right_z_0);
    return make_float3 (_S271, _S272, _S273);
}

__device__ float3  camera_up_0(int _S274)
{
    Frame_0 * _S275 = (&(globalParams_0->frames_0)[_S274]);
    float _S276 = __ldg(&_S275->up_x_0);
    float _S277 = __ldg(&_S275->up_y_0);
    float _S278 = __ldg(&_S275->up_z_0);
    return make_float3 (_S276, _S277, _S278);
}

__device__ float3  camera_forward_0(int _S279)
{
    Frame_0 * _S280 = (&(globalParams_0->frames_0)[_S279]);
    float _S281 = __ldg(&_S280->forward_x_0);
    float _S282 = __ldg(&_S280->forward_y_0);
    float _S283 = __ldg(&_S280->forward_z_0);
    return make_float3 (_S281, _S282, _S283);
}

__device__ float3  camera_origin_0(int _S284)
{
    Frame_0 * _S285 = (&(globalParams_0->frames_0)[_S284]);
    float _S286 = __ldg(&_S285->origin_x_0);
    float _S287 = __ldg(&_S285->origin_y_0);
    float _S288 = __ldg(&_S285->origin_z_0);
    return make_float3 (_S286, _S287, _S288);
}

__device__ VisiblePoint_0 face_point_0(uint _S289, uint _S290, float _S291, float _S292)
{
    Fabric_0 * _S293 = (&(globalParams_0->fabrics_0)[_S289]);
    uint _S294 = 3U * _S290;
    uint _S295 = __ldg((&(globalParams_0->corners_0)[_S294]));
    Vertex_0 _S296 = slang_ldg_0((&(globalParams_0->vertices_0)[_S295]));
    uint _S297 = __ldg((&(globalParams_0->corners_0)[_S294 + 1U]));
    Vertex_0 _S298 = slang_ldg_0((&(globalParams_0->vertices_0)[_S297]));
    uint _S299 = __ldg((&(globalParams_0->corners_0)[_S294 + 2U]));
    Vertex_0 _S300 = slang_ldg_0((&(globalParams_0->vertices_0)[_S299]));
    Vertex_0 _S301 = _S298;
    float3  _S302 = position_of_0(&_S301);
    Vertex_0 _S303 = _S296;
    float3  _S304 = position_of_0(&_S303);
    float3  _S305 = _S302 - _S304;
    Vertex_0 _S306 = _S300;
    float3  _S307 = position_of_0(&_S306);
    float3  _S308 = _S307 - _S304;
    float _S309 = _S298.u_0 - _S296.u_0;
    float _S310 = _S298.v_0 - _S296.v_0;
    float2  _S311 = make_float2 (_S309, _S310);
    float _S312 = _S300.u_0 - _S296.u_0;
    float _S313 = _S300.v_0 - _S296.v_0;
    float2  _S314 = make_float2 (_S312, _S313);
    float _S315;
    if((_S309 * _S313 - _S310 * _S312) < 0.0f)
    {
        _S315 = -1.0f;
    }
    else
    {
        _S315 = 1.0f;
    }
    float3  _S316 = make_float3 (_S315) * (make_float3 (_S313) * _S305 - make_float3 (_S310) * _S308);
    float3  _S317 = make_float3 (_S315) * (make_float3 (_S309) * _S308 - make_float3 (_S312) * _S305);
    VisiblePoint_0 point_1;
    float _S318 = 1.0f - _S291 - _S292;
    Vertex_0 _S319 = _S296;
    float3  _S320 = normal_of_0(&_S319);
    float3  _S321 = make_float3 (_S318) * _S320;
    Vertex_0 _S322 = _S298;
    float3  _S323 = normal_of_0(&_S322);
    float3  _S324 = _S321 + make_float3 (_S291) * _S323;
    Vertex_0 _S325 = _S300;
    float3  _S326 = normal_of_0(&_S325);
    float3  _S327 = normalize_0(_S324 + make_float3 (_S292) * _S326);
    (&point_1)->normal_0 = _S327;
    float3  _S328 = normalize_0(_S316 - _S327 * make_float3 (dot_0(_S327, _S316)));
    (&point_1)->axis_x_0 = _S328;
    (&point_1)->axis_y_0 = cross_0(_S327, _S328);
    float3  _S329 = normalize_0(cross_0(_S305, _S308));
    float3  _S330;
    if((dot_0(_S329, _S327)) < 0.0f)
    {
        _S330 = - _S329;
    }
    else
    {
        _S330 = _S329;
    }
    (&point_1)->face_normal_0 = _S330;
    (&point_1)->position_0 = _S304 + make_float3 (_S291) * _S305 + make_float3 (_S292) * _S308;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_1 = make_float2 (_S296.u_0, _S296.v_0) + make_float2 (_S291) * _S311 + make_float2 (_S292) * _S314;
    bool _S331 = (dot_0(cross_0(_S316, _S317), (&point_1)->normal_0)) < 0.0f;
    float _S332 = __ldg(&_S293->uv_width_0);
    if(_S331)
    {
        float _S333 = __ldg(&_S293->uv_height_0);
        _S315 = - _S333;
    }
    else
    {
        float _S334 = __ldg(&_S293->uv_height_0);
        _S315 = _S334;
    }
    float2  _S335 = make_float2 (_S332, _S315);
    (&point_1)->draft_per_uv_0 = _S335;
    float2  _S336 = (&point_1)->uv_1 * _S335;
    if(_S331)
    {
        float _S337 = __ldg(&_S293->uv_height_0);
        _S315 = _S337;
    }
    else
    {
        _S315 = 0.0f;
    }
    (&point_1)->draft_0 = _S336 + make_float2 (0.0f, _S315);
    float2  _S338 = make_float2 (0.0f);
    (&point_1)->draft_dx_0 = _S338;
    (&point_1)->draft_dy_0 = _S338;
    return point_1;
}

__device__ VisiblePoint_0 visible_point_0(int _S339, uint _S340, uint _S341, uint2  _S342)
{
    Frame_0 * _S343 = (&(globalParams_0->frames_0)[_S339]);
    uint _S344 = 3U * _S341;
    uint _S345 = __ldg((&(globalParams_0->corners_0)[_S344]));
    Vertex_0 _S346 = slang_ldg_0((&(globalParams_0->vertices_0)[_S345]));
    uint _S347 = __ldg((&(globalParams_0->corners_0)[_S344 + 1U]));
    Vertex_0 _S348 = slang_ldg_0((&(globalParams_0->vertices_0)[_S347]));
    uint _S349 = __ldg((&(globalParams_0->corners_0)[_S344 + 2U]));
    Vertex_0 _S350 = slang_ldg_0((&(globalParams_0->vertices_0)[_S349]));
    Vertex_0 _S351 = _S348;
    float3  _S352 = position_of_0(&_S351);
    Vertex_0 _S353 = _S346;
    float3  _S354 = position_of_0(&_S353);
    float3  _S355 = _S352 - _S354;
    Vertex_0 _S356 = _S350;
    float3  _S357 = position_of_0(&_S356);
    float3  _S358 = _S357 - _S354;
    float3  _S359 = cross_0(_S355, _S358);
    float _S360 = 1.0f / (F32_max((square_0(_S359)), (1.00000000317107685e-30f)));
    float3  _S361 = camera_right_0(_S339);
    uint _S362 = __ldg(&_S343->width_0);
    float _S363 = float(_S362);
    float3  _S364 = _S361 * make_float3 (2.0f / _S363);
    float3  _S365 = camera_up_0(_S339);
    uint _S366 = __ldg(&_S343->height_0);
    float _S367 = float(_S366);
    float3  _S368 = _S365 * make_float3 (-2.0f / _S367);
    float _S369 = float(_S342.x) + 0.5f - 0.5f * _S363;
    float _S370 = float(_S342.y) + 0.5f - 0.5f * _S367;
    float3  _S371 = camera_forward_0(_S339);
    float3  _S372 = _S371 + make_float3 (_S369) * _S364 + make_float3 (_S370) * _S368;
    float _S373 = dot_0(_S372, _S359);
    float _S374;
    if((F32_abs((_S373))) > 1.00000000317107685e-30f)
    {
        _S374 = _S373;
    }
    else
    {
        _S374 = 1.00000000317107685e-30f;
    }
    float _S375 = 1.0f / _S374;
    float3  _S376 = camera_origin_0(_S339);
    float3  _S377 = _S354 - _S376;
    float _S378 = dot_0(_S377, _S359) * _S375;
    float3  _S379 = _S372 * make_float3 (_S378) - _S377;
    float3  _S380 = make_float3 (_S378) * (_S364 - _S372 * make_float3 (dot_0(_S364, _S359) * _S375));
    float3  _S381 = make_float3 (_S378) * (_S368 - _S372 * make_float3 (dot_0(_S368, _S359) * _S375));
    float3  _S382 = cross_0(_S358, _S359) * make_float3 (_S360);
    float3  _S383 = cross_0(_S359, _S355) * make_float3 (_S360);
    float2  _S384 = make_float2 (_S348.u_0 - _S346.u_0, _S348.v_0 - _S346.v_0);
    float2  _S385 = make_float2 (_S350.u_0 - _S346.u_0, _S350.v_0 - _S346.v_0);
    VisiblePoint_0 _S386 = face_point_0(_S340, _S341, dot_0(_S379, _S382), dot_0(_S379, _S383));
    VisiblePoint_0 point_2 = _S386;
    (&point_2)->position_0 = _S354 + _S379;
    (&point_2)->view_0 = - normalize_0(_S372);
    (&point_2)->draft_dx_0 = (make_float2 (dot_0(_S380, _S382)) * _S384 + make_float2 (dot_0(_S380, _S383)) * _S385) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (make_float2 (dot_0(_S381, _S382)) * _S384 + make_float2 (dot_0(_S381, _S383)) * _S385) * (&point_2)->draft_per_uv_0;
    return point_2;
}

__device__ float3  filtered_albedo_0(uint _S387, VisiblePoint_0 * _S388)
{
    Fabric_0 * _S389 = (&(globalParams_0->fabrics_0)[_S387]);
    uint _S390 = __ldg(&_S389->albedo_map_levels_0);
    if(_S390 == 0U)
    {
        return make_float3 (1.0f);
    }
    float _S391 = __ldg(&_S389->uv_width_0);
    float _S392 = __ldg(&_S389->uv_height_0);
    float2  _S393 = make_float2 (_S391, _S392);
    float2  _S394 = _S388->draft_dx_0 / _S393;
    float2  _S395 = _S388->draft_dy_0 / _S393;
    uint _S396 = _S390 - 1U;
    uint _S397 = 1U << _S396;
    float _S398 = clamp_0(0.5f * binary_logarithm_0((F32_max(((F32_abs((_S394.x * _S395.y - _S394.y * _S395.x)))), (9.99999968265522539e-21f))) * (square_1(float(_S397)) / 3.0f)), 0.0f, float(_S390) - 1.0f);
    uint _S399 = (U32_min((uint(_S398)), ((U32_max((_S390), (2U))) - 2U)));
    uint _S400 = (U32_min((_S399 + 1U), (_S396)));
    uint _S401 = 1U << (2U * _S390);
    uint _S402 = __ldg(&_S389->albedo_map_0);
    return lerp_1(map_level_0(_S402 + (_S401 - (_S401 >> (2U * _S399))) / 3U, _S397 >> _S399, _S388->uv_1), map_level_0(_S402 + (_S401 - (_S401 >> (2U * _S400))) / 3U, _S397 >> _S400, _S388->uv_1), make_float3 ((exponential_0(1.38629436492919922f * (_S398 - float(_S399))) - 1.0f) / 3.0f));
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_2;
    bool is_warp_1;
    float x_23;
    float y_12;
    float height_3;
    float3  normal_4;
    float3  tangent_4;
    float roughness_8;
    Albedos_0 albedos_2;
};

struct Hit_0
{
    float x_24;
    float y_13;
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

__device__ Crossing_0 crossing_at_0(uint _S403, float _S404, float _S405, bool _S406)
{
    Fabric_0 * _S407 = (&(globalParams_0->fabrics_0)[_S403]);
    Crossing_0 crossing_2;
    uint _S408 = __ldg(&_S407->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S408, _S404);
    uint _S409 = __ldg(&_S407->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S409, _S405);
    uint _S410 = __ldg(&_S407->run_words_0);
    uint _S411 = (&(&crossing_2)->weft_1)->thread_1;
    uint _S412 = __ldg(&_S407->ends_1);
    uint _S413 = _S410 + 2U * (_S411 * _S412 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S414 = __ldg((&(globalParams_0->words_0)[_S413]));
    (&crossing_2)->warp_word_0 = _S414;
    uint _S415 = __ldg((&(globalParams_0->words_0)[_S413 + 1U]));
    (&crossing_2)->weft_word_0 = _S415;
    (&crossing_2)->warp_above_0 = ((_S414 & 1U) == 1U) != _S406;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S416, float _S417, float _S418, bool _S419)
{
    Fabric_0 * _S420 = (&(globalParams_0->fabrics_0)[_S416]);
    Sample_0 sample_0;
    Crossing_0 _S421 = crossing_at_0(_S416, _S417, _S418, _S419);
    (&sample_0)->crossing_1 = _S421;
    Crossing_0 _S422 = _S421;
    Shown_0 _S423 = shown_at_0(&_S422, _S419);
    (&sample_0)->shown_3 = _S423;
    uint _S424;
    if(_S423.is_warp_0)
    {
        uint _S425 = __ldg(&_S420->warp_0);
        _S424 = _S425;
    }
    else
    {
        uint _S426 = __ldg(&_S420->weft_0);
        _S424 = _S426;
    }
    uint _S427;
    if(_S423.is_warp_0)
    {
        uint _S428 = __ldg(&_S420->weft_0);
        _S427 = _S428;
    }
    else
    {
        uint _S429 = __ldg(&_S420->warp_0);
        _S427 = _S429;
    }
    Cell_0 _S430 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S431 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S432 = select_cell_0(_S423.is_warp_0, &_S430, &_S431);
    Cell_0 _S433 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S434 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S435 = select_cell_0(_S423.is_warp_0, &_S433, &_S434);
    Cell_0 _S436 = _S435;
    Run_0 _S437 = unpack_0(_S424, _S427, _S432.thread_1, &_S436, _S423.word_0);
    Cell_0 _S438 = _S432;
    Section_0 _S439 = section_at_0(&_S438);
    bool _S440;
    if(_S423.on_top_0)
    {
        _S440 = (_S437.distance_0) < (_S439.drop_0 * _S437.bend_1.sine_0);
    }
    else
    {
        _S440 = false;
    }
    bool _S441;
    if(_S423.on_top_0)
    {
        _S441 = !_S440;
    }
    else
    {
        _S441 = false;
    }
    float _S442;
    if(_S441)
    {
        _S442 = 1.0f;
    }
    else
    {
        _S442 = -1.0f;
    }
    float _S443;
    if(_S440)
    {
        _S443 = _S437.other_reach_0;
    }
    else
    {
        _S443 = _S437.reach_0;
    }
    float _S444;
    if(_S440)
    {
        _S444 = _S443 + _S437.distance_0;
    }
    else
    {
        _S444 = (F32_max((_S443 - _S437.distance_0), (0.0f)));
    }
    float _S445 = _S443 / _S437.bend_1.sine_0 - _S442 * _S439.drop_0;
    float _S446 = _S444 * _S444;
    float _S447 = (F32_max((_S445 * _S445 - _S446), (9.99999968265522539e-21f)));
    float _S448 = (F32_rsqrt((_S447)));
    float _S449 = _S446 / (_S447 * _S448 + _S445);
    bool _S450 = _S444 > 0.0f;
    float _S451;
    if(_S423.on_top_0)
    {
        _S451 = 1.0f;
    }
    else
    {
        _S451 = -1.0f;
    }
    float _S452;
    if(_S437.near_start_0)
    {
        _S452 = 1.0f;
    }
    else
    {
        _S452 = -1.0f;
    }
    float _S453 = _S451 * _S452;
    if(_S450)
    {
        _S451 = _S445 * _S448;
    }
    else
    {
        _S451 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S439.slope_0 * _S451;
    if(_S450)
    {
        _S444 = _S453 * _S444 * _S448;
    }
    else
    {
        _S444 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S444;
    Family_0 _S454 = slang_ldg_1((&(globalParams_0->families_0)[_S424]));
    Shown_0 _S455 = _S423;
    Run_0 _S456 = _S437;
    Cell_0 _S457 = _S435;
    float2  _S458 = dive_0(_S427, &_S455, &_S456, &_S457);
    if(_S437.straight_0)
    {
        _S442 = 0.0f;
    }
    else
    {
        _S442 = _S454.height_scale_0 * _S442;
    }
    (&sample_0)->height_5 = _S442 * (_S443 * _S437.bend_1.half_tangent_0 - _S449) - _S454.height_scale_0 * _S439.drop_0 - _S458.x;
    float _S459 = _S454.height_scale_0 * (&sample_0)->slope_across_0;
    float _S460 = _S454.height_scale_0 * (&sample_0)->slope_along_0 - _S458.y;
    if(_S423.is_warp_0)
    {
        _S442 = _S459;
    }
    else
    {
        _S442 = _S460;
    }
    (&sample_0)->slope_x_1 = _S442;
    if(_S423.is_warp_0)
    {
        _S442 = _S460;
    }
    else
    {
        _S442 = _S459;
    }
    (&sample_0)->slope_y_1 = _S442;
    (&sample_0)->run_3 = _S437;
    (&sample_0)->section_1 = _S439;
    return sample_0;
}

__device__ float steps_per_length_0(uint _S461, SearchQuality_0 * _S462, float3  _S463)
{
    Fabric_0 * _S464 = (&(globalParams_0->fabrics_0)[_S461]);
    float _S465 = (F32_abs((_S463.x)));
    float _S466 = __ldg(&_S464->threads_per_x_0);
    float _S467 = _S465 * _S466;
    float _S468 = (F32_abs((_S463.y)));
    float _S469 = __ldg(&_S464->threads_per_y_0);
    float _S470 = (F32_max((_S467), (_S468 * _S469))) * _S462->steps_per_thread_0;
    float _S471 = (F32_abs((_S463.z)));
    float _S472 = __ldg(&_S464->per_relief_0);
    return (F32_max((_S470), (_S471 * _S472 * _S462->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S473, Crossing_0 * _S474)
{
    Fabric_0 * _S475 = (&(globalParams_0->fabrics_0)[_S473]);
    bool _S476 = _S474->warp_above_0;
    uint _S477;
    if(_S474->warp_above_0)
    {
        uint _S478 = __ldg(&_S475->warp_0);
        _S477 = _S478;
    }
    else
    {
        uint _S479 = __ldg(&_S475->weft_0);
        _S477 = _S479;
    }
    uint _S480;
    if(_S476)
    {
        _S480 = _S474->warp_word_0;
    }
    else
    {
        _S480 = _S474->weft_word_0;
    }
    float _S481 = float(_S480 >> int(28));
    Family_0 _S482 = slang_ldg_1((&(globalParams_0->families_0)[_S477]));
    float _S483 = _S481 * _S482.height_scale_0;
    Family_0 _S484 = slang_ldg_1((&(globalParams_0->families_0)[_S477]));
    return _S483 * _S484.level_0;
}

__device__ Probe_0 probe_0(uint _S485, float _S486, float _S487, bool _S488, bool _S489, bool _S490)
{
    Sample_0 _S491 = sample_at_0(_S485, _S486, _S487, _S488);
    Probe_0 probe_1;
    (&probe_1)->height_1 = _S491.height_5;
    (&probe_1)->hole_1 = _S491.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S491.slope_x_1;
    (&probe_1)->slope_y_0 = _S491.slope_y_1;
    uint _S492;
    if(_S491.shown_3.is_warp_0)
    {
        _S492 = _S491.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S492 = _S491.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S492;
    Crossing_0 _S493 = _S491.crossing_1;
    float _S494 = cell_maximum_0(_S485, &_S493);
    (&probe_1)->cell_max_0 = _S494;
    float _S495;
    if(_S489)
    {
        _S495 = _S491.crossing_1.warp_1.above_0;
    }
    else
    {
        _S495 = _S491.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S495;
    if(_S490)
    {
        _S495 = _S491.crossing_1.weft_1.above_0;
    }
    else
    {
        _S495 = _S491.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S495;
    bool _S496 = !_S491.shown_3.is_warp_0;
    Cell_0 _S497 = _S491.crossing_1.warp_1;
    Shown_0 _S498 = _S491.shown_3;
    Run_0 _S499 = _S491.run_3;
    float _S500 = outline_distance_0(&_S497, &_S498, &_S499, _S496, _S489);
    (&probe_1)->edge_x_0 = _S500;
    Cell_0 _S501 = _S491.crossing_1.weft_1;
    Shown_0 _S502 = _S491.shown_3;
    Run_0 _S503 = _S491.run_3;
    float _S504 = outline_distance_0(&_S501, &_S502, &_S503, _S491.shown_3.is_warp_0, _S490);
    (&probe_1)->edge_y_0 = _S504;
    return probe_1;
}

__device__ bool is_free_0(uint _S505, SearchQuality_0 * _S506, float3  _S507, float3  _S508, bool _S509, float _S510)
{
    float _S511 = _S508.z;
    if(_S511 <= 0.0f)
    {
        return false;
    }
    float _S512 = _S506->shadow_share_0;
    float _S513 = steps_per_length_0(_S505, _S506, _S508);
    float _S514 = 1.0f / (F32_max((_S512 * _S513), (9.99999971718068537e-10f)));
    StepControl_0 _S515 = step_control_0(float2 {_S508.x, _S508.y}, _S514);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_2 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S516;
        if(count_2 < 1024U)
        {
            _S516 = (_S507.z + _S511 * distance_1) < _S510;
        }
        else
        {
            _S516 = false;
        }
        if(_S516)
        {
        }
        else
        {
            break;
        }
        float3  _S517 = _S507 + _S508 * make_float3 (distance_1);
        Probe_0 _S518 = probe_0(_S505, _S517.x, _S517.y, _S509, _S515.right_1, _S515.up_0);
        float _S519 = _S517.z;
        float _S520 = _S519 - _S518.height_1;
        float _S521 = _S511 - _S518.slope_x_0 * _S508.x - _S518.slope_y_0 * _S508.y;
        bool _S522;
        if(!_S518.hole_1)
        {
            _S522 = _S520 < 0.0f;
        }
        else
        {
            _S522 = false;
        }
        if(_S522)
        {
            return false;
        }
        PreviousSample_0 _S523 = previous_3;
        Probe_0 _S524 = _S518;
        float _S525 = way_back_to_dip_0(&_S523, _S520, _S521, last_step_0, &_S524);
        if(_S525 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S525;
            distance_1 = distance_1 - _S525;
            last_step_0 = last_step_1;
            count_2 = count_2 + 1U;
            continue;
        }
        bool _S526 = _S519 > (_S518.cell_max_0);
        Probe_0 _S527 = _S518;
        PreviousSample_0 _S528 = after_sample_0(_S520, _S521, &_S527, _S526);
        float last_step_2;
        if(_S526)
        {
            StepControl_0 _S529 = _S515;
            float _S530 = StepControl_to_cell_exit_0(&_S529, _S518.side_x_0, _S518.side_y_0);
            last_step_2 = (F32_max((_S530), (_S514)));
        }
        else
        {
            StepControl_0 _S531 = _S515;
            Probe_0 _S532 = _S518;
            float _S533 = StepControl_to_next_sample_0(&_S531, &_S532, _S520, _S521);
            last_step_2 = _S533;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S528;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S534, SearchQuality_0 * _S535, float _S536, float _S537, float3  _S538, bool _S539)
{
    Fabric_0 * _S540 = (&(globalParams_0->fabrics_0)[_S534]);
    Sample_0 _S541 = sample_at_0(_S534, _S536, _S537, _S539);
    if(!_S541.shown_3.hole_0)
    {
        return false;
    }
    float3  _S542 = make_float3 (_S536, _S537, 0.0f);
    bool passes_0 = true;
    uint side_1 = 0U;
    for(;;)
    {
        bool _S543;
        if(side_1 < 2U)
        {
            _S543 = passes_0;
        }
        else
        {
            _S543 = false;
        }
        if(_S543)
        {
        }
        else
        {
            break;
        }
        float3  _S544;
        if(side_1 == 0U)
        {
            _S544 = _S538;
        }
        else
        {
            _S544 = make_float3 (- _S538.x, - _S538.y, _S538.z);
        }
        bool _S545 = _S539 != (side_1 == 1U);
        float _S546 = __ldg(&_S540->height_high_0);
        bool _S547 = is_free_0(_S534, _S535, _S542, _S544, _S545, _S546);
        uint _S548 = side_1 + 1U;
        passes_0 = _S547;
        side_1 = _S548;
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

__device__ float max_height_along_0(uint _S549, float _S550, float _S551, float _S552, float3  _S553, bool _S554)
{
    Fabric_0 * _S555 = (&(globalParams_0->fabrics_0)[_S549]);
    uint _S556 = __ldg(&_S555->warp_0);
    uint _S557 = locate_0(_S556, _S550).thread_1 / 2U;
    uint _S558 = __ldg(&_S555->weft_0);
    uint _S559 = locate_0(_S558, _S551).thread_1 / 2U;
    float _S560 = _S553.x;
    uint _S561;
    if(_S560 > 0.0f)
    {
        _S561 = 1U;
    }
    else
    {
        _S561 = 0U;
    }
    float _S562 = _S553.y;
    uint _S563;
    if(_S562 > 0.0f)
    {
        _S563 = 2U;
    }
    else
    {
        _S563 = 0U;
    }
    uint _S564 = _S561 + _S563;
    uint _S565 = __ldg(&_S555->max_heights_0);
    uint _S566 = __ldg(&_S555->max_height_columns_0);
    uint _S567 = __ldg((&(globalParams_0->words_0)[_S565 + 4U * (_S559 * _S566 + _S557) + _S564]));
    int number_1;
    if(_S554)
    {
        number_1 = int(4);
    }
    else
    {
        number_1 = int(0);
    }
    uint _S568 = _S567 >> number_1;
    float _S569 = (F32_abs((_S560)));
    float _S570 = __ldg(&_S555->threads_per_x_0);
    float _S571 = _S569 * _S570;
    float _S572 = (F32_abs((_S562)));
    float _S573 = __ldg(&_S555->threads_per_y_0);
    float _S574 = (F32_max((_S571), (_S572 * _S573))) / _S553.z;
    float _S575 = __ldg(&_S555->height_high_0);
    float max_height_0 = _S575;
    number_1 = int(3);
    for(;;)
    {
        if(number_1 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S552) * _S574) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S568 >> uint(int(8) * number_1)) & 15U) * 0.06666667014360428f * _S575)));
        }
        number_1 = number_1 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S576, float _S577, float _S578, bool _S579, bool _S580, bool _S581)
{
    Crossing_0 _S582 = crossing_at_0(_S576, _S577, _S578, _S579);
    Crossing_0 _S583 = _S582;
    float _S584 = cell_maximum_0(_S576, &_S583);
    float _S585;
    if(_S580)
    {
        _S585 = _S582.warp_1.above_0;
    }
    else
    {
        _S585 = _S582.warp_1.below_0;
    }
    float _S586;
    if(_S581)
    {
        _S586 = _S582.weft_1.above_0;
    }
    else
    {
        _S586 = _S582.weft_1.below_0;
    }
    return make_float3 (_S584, _S585, _S586);
}

__device__ float first_sample_height_0(uint _S587, ViewRay_0 * _S588, StepControl_0 * _S589, bool _S590)
{
    float _S591 = max_height_along_0(_S587, _S588->origin_0.x, _S588->origin_0.y, 0.0f, make_float3 (_S588->slope_1.x, _S588->slope_1.y, 1.0f), _S590);
    uint count_3 = 0U;
    float height_7 = _S591;
    for(;;)
    {
        if(count_3 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S592 = ViewRay_at_0(_S588, height_7);
        float3  _S593 = cell_bounds_0(_S587, _S592.x, _S592.y, _S590, _S589->right_1, _S589->up_0);
        float _S594 = height_7 - _S593.x;
        float _S595 = StepControl_to_cell_exit_0(_S589, _S593.y, _S593.z);
        float height_8 = height_7 - clamp_0(_S594, 0.0f, _S595);
        if(_S594 <= _S595)
        {
            height_7 = height_8;
            break;
        }
        count_3 = count_3 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

__device__ ViewRayEnd_0 search_down_0(uint _S596, ViewRay_0 * _S597, StepControl_0 * _S598, bool _S599)
{
    Fabric_0 * _S600 = (&(globalParams_0->fabrics_0)[_S596]);
    float _S601 = __ldg(&_S600->height_low_0);
    float _S602 = __ldg(&_S600->height_high_0);
    float _S603 = _S601 - (_S602 - _S601);
    ViewRayEnd_0 end_1;
    float _S604 = first_sample_height_0(_S596, _S597, _S598, _S599);
    (&end_1)->height_6 = _S604;
    (&end_1)->last_step_3 = _S598->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
    uint count_4 = 0U;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S605 = ViewRay_at_0(_S597, (&end_1)->height_6);
        Probe_0 _S606 = probe_0(_S596, _S605.x, _S605.y, _S599, _S598->right_1, _S598->up_0);
        float _S607 = (&end_1)->height_6 - _S606.height_1;
        Probe_0 _S608 = _S606;
        float _S609 = ViewRay_rate_0(_S597, &_S608);
        (&end_1)->depth_1 = - _S607;
        (&end_1)->rate_4 = _S609;
        bool _S610;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S610 = !_S606.hole_1;
        }
        else
        {
            _S610 = false;
        }
        bool _S611;
        if(_S610)
        {
            _S611 = ((&(&end_1)->previous_4)->yarn_0) == (_S606.yarn_1);
        }
        else
        {
            _S611 = false;
        }
        (&end_1)->smooth_0 = _S611;
        bool _S612;
        if(!_S606.hole_1)
        {
            _S612 = _S607 <= 0.0f;
        }
        else
        {
            _S612 = false;
        }
        bool _S613;
        if(_S612)
        {
            _S613 = true;
        }
        else
        {
            _S613 = ((&end_1)->height_6) <= _S603;
        }
        if(_S613)
        {
            break;
        }
        PreviousSample_0 _S614 = (&end_1)->previous_4;
        Probe_0 _S615 = _S606;
        float _S616 = way_back_to_dip_0(&_S614, _S607, _S609, (&end_1)->last_step_3, &_S615);
        if(_S616 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S616;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S616;
            count_4 = count_4 + 1U;
            continue;
        }
        float _S617 = StepControl_to_cell_exit_0(_S598, _S606.side_x_0, _S606.side_y_0);
        float _S618 = (F32_min((_S617), ((&end_1)->height_6 - _S606.cell_max_0)));
        Probe_0 _S619 = _S606;
        float _S620 = StepControl_to_next_sample_0(_S598, &_S619, _S607, _S609);
        bool _S621 = _S618 > _S620;
        Probe_0 _S622 = _S606;
        PreviousSample_0 _S623 = after_sample_0(_S607, _S609, &_S622, _S621);
        (&end_1)->previous_4 = _S623;
        float _S624 = (F32_max((_S618), (_S620)));
        (&end_1)->last_step_3 = _S624;
        (&end_1)->height_6 = (&end_1)->height_6 - _S624;
        count_4 = count_4 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S625, ViewRay_0 * _S626, StepControl_0 * _S627, bool _S628, ViewRayEnd_0 * _S629, uint _S630)
{
    Fabric_0 * _S631 = (&(globalParams_0->fabrics_0)[_S625]);
    float _S632 = __ldg(&_S631->height_high_0);
    float _S633 = __ldg(&_S631->height_low_0);
    float _S634 = _S632 - _S633;
    float _S635 = _S629->height_6;
    float _S636 = _S629->last_step_3;
    float above_2 = _S629->height_6 + _S629->last_step_3;
    float above_gap_1 = clamp_0((&_S629->previous_4)->clearance_0, 0.0f, _S634);
    float under_gap_1 = clamp_0(_S629->depth_1, 0.0f, _S634);
    float _S637 = cubic_root_0(above_gap_1, - under_gap_1, (&_S629->previous_4)->rate_0 * _S629->last_step_3, _S629->rate_4 * _S629->last_step_3);
    bool _S638 = _S629->smooth_0;
    float middle_0;
    if(_S629->smooth_0)
    {
        middle_0 = above_2 - _S637 * _S636;
    }
    else
    {
        middle_0 = between_0(above_2, _S635, above_gap_1, under_gap_1);
    }
    float side_2 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S635;
    float above_3 = above_2;
    uint i_6 = 0U;
    for(;;)
    {
        if(i_6 < _S630)
        {
        }
        else
        {
            break;
        }
        float2  _S639 = ViewRay_at_0(_S626, middle_0);
        Probe_0 _S640 = probe_0(_S625, _S639.x, _S639.y, _S628, _S627->right_1, _S627->up_0);
        float _S641;
        if(_S640.hole_1)
        {
            _S641 = -1.0e+09f;
        }
        else
        {
            _S641 = _S640.height_1;
        }
        float _S642 = clamp_0(middle_0 - _S641, - _S634, _S634);
        float _S643;
        if(_S642 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S643 = 0.5f * above_gap_2;
            }
            else
            {
                _S643 = above_gap_2;
            }
            float _S644 = - _S642;
            under_1 = middle_0;
            above_gap_2 = _S643;
            under_gap_2 = _S644;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S643 = 0.5f * under_gap_2;
            }
            else
            {
                _S643 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S642;
            under_gap_2 = _S643;
            side_2 = -1.0f;
        }
        if(_S638)
        {
            Probe_0 _S645 = _S640;
            float _S646 = ViewRay_rate_0(_S626, &_S645);
            middle_0 = clamp_0(middle_0 + _S642 / (F32_min((_S646), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_6 = i_6 + 1U;
    }
    if(_S638)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_0 first_hit_of_yarn_0(uint _S647, SearchQuality_0 * _S648, float _S649, float _S650, float3  _S651, bool _S652)
{
    float _S653 = (F32_max((_S651.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_0 = make_float2 (_S649, _S650);
    float2  _S654 = float2 {_S651.x, _S651.y} / make_float2 (_S653);
    (&ray_0)->slope_1 = _S654;
    float2  _S655 = - _S654;
    float _S656 = steps_per_length_0(_S647, _S648, _S651);
    StepControl_0 _S657 = step_control_0(_S655, 1.0f / (F32_max((_S656 / _S653), (9.99999971718068537e-10f))));
    ViewRay_0 _S658 = ray_0;
    StepControl_0 _S659 = _S657;
    ViewRayEnd_0 _S660 = search_down_0(_S647, &_S658, &_S659, _S652);
    Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    ViewRay_0 _S661 = ray_0;
    StepControl_0 _S662 = _S657;
    ViewRayEnd_0 _S663 = _S660;
    float _S664 = refined_height_0(_S647, &_S661, &_S662, _S652, &_S663, _S648->refinements_0);
    (&hit_0)->height_4 = _S664;
    ViewRay_0 _S665 = ray_0;
    float2  _S666 = ViewRay_at_0(&_S665, _S664);
    (&hit_0)->x_24 = _S666.x;
    (&hit_0)->y_13 = _S666.y;
    return hit_0;
}

__device__ Hit_0 first_hit_0(uint _S667, SearchQuality_0 * _S668, float _S669, float _S670, float3  _S671, bool _S672)
{
    bool _S673 = passes_through_0(_S667, _S668, _S669, _S670, _S671, _S672);
    if(!_S673)
    {
        Hit_0 _S674 = first_hit_of_yarn_0(_S667, _S668, _S669, _S670, _S671, _S672);
        return _S674;
    }
    Hit_0 hit_1;
    (&hit_1)->x_24 = _S669;
    (&hit_1)->y_13 = _S670;
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

__device__ SurfacePoint_0 surface_at_0(uint _S675, float _S676, float _S677, bool _S678)
{
    Fabric_0 * _S679 = (&(globalParams_0->fabrics_0)[_S675]);
    Sample_0 _S680 = sample_at_0(_S675, _S676, _S677, _S678);
    float _S681;
    if(_S680.shown_3.is_warp_0)
    {
        _S681 = _S680.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S681 = _S680.crossing_1.weft_1.half_width_1;
    }
    uint _S682;
    if(_S680.shown_3.is_warp_0)
    {
        uint _S683 = __ldg(&_S679->warp_0);
        _S682 = _S683;
    }
    else
    {
        uint _S684 = __ldg(&_S679->weft_0);
        _S682 = _S684;
    }
    Family_0 _S685 = slang_ldg_1((&(globalParams_0->families_0)[_S682]));
    float _S686;
    if(_S678)
    {
        _S686 = -1.0f;
    }
    else
    {
        _S686 = 1.0f;
    }
    float _S687 = _S685.twist_sine_0 * _S686;
    Family_0 _S688 = slang_ldg_1((&(globalParams_0->families_0)[_S682]));
    if(_S680.shown_3.is_warp_0)
    {
        _S686 = 1.0f;
    }
    else
    {
        _S686 = -1.0f;
    }
    float2  _S689 = fibre_direction_0(_S680.slope_across_0, _S686 * _S680.slope_along_0, _S687, _S688.twist_cosine_0);
    float _S690;
    if(_S680.shown_3.is_warp_0)
    {
        _S690 = _S680.slope_x_1;
    }
    else
    {
        _S690 = _S680.slope_y_1;
    }
    float _S691;
    if(_S680.shown_3.is_warp_0)
    {
        _S691 = _S680.slope_y_1;
    }
    else
    {
        _S691 = _S680.slope_x_1;
    }
    float _S692 = _S689.x;
    float _S693 = _S689.y;
    float _S694 = _S690 * _S692 + _S686 * _S691 * _S693;
    float _S695 = _S681 * 1.0154266357421875f;
    float _S696 = _S695 * arc_sine_0(clamp_0(_S680.section_1.across_1 / _S695, -1.0f, 1.0f));
    if(_S680.shown_3.is_warp_0)
    {
        _S681 = _S677;
    }
    else
    {
        _S681 = - _S676;
    }
    SurfacePoint_0 point_3;
    (&point_3)->hole_4 = _S680.shown_3.hole_0;
    (&point_3)->is_warp_2 = _S680.shown_3.is_warp_0;
    (&point_3)->warp_thread_0 = _S680.crossing_1.warp_1.thread_1;
    (&point_3)->weft_thread_0 = _S680.crossing_1.weft_1.thread_1;
    (&point_3)->height_9 = _S680.height_5;
    (&point_3)->normal_5 = normalize_0(make_float3 (- _S680.slope_x_1, - _S680.slope_y_1, 1.0f));
    float3  _S697;
    if(_S680.shown_3.is_warp_0)
    {
        _S697 = make_float3 (_S692, _S693, _S694);
    }
    else
    {
        _S697 = make_float3 (- _S693, _S692, _S694);
    }
    (&point_3)->tangent_5 = normalize_0(_S697);
    (&point_3)->across_2 = _S680.section_1.across_1;
    (&point_3)->fibre_across_0 = _S696 * _S688.twist_cosine_0 + _S681 * _S687;
    (&point_3)->fibre_along_0 = _S681 * _S688.twist_cosine_0 - _S696 * _S687;
    return point_3;
}

__device__ Albedos_0 vary_albedos_0(uint _S698, Albedos_0 * _S699, uint _S700, uint _S701)
{
    Fabric_0 * _S702 = (&(globalParams_0->fabrics_0)[_S698]);
    float3  _S703 = _S699->specular_reflect_0;
    float3  _S704 = _S699->specular_transmit_0;
    float3  _S705 = max_0(_S699->specular_reflect_0, _S699->specular_transmit_0);
    float3  _S706 = _S699->diffuse_reflect_0;
    float3  _S707 = _S699->diffuse_transmit_0;
    float3  _S708 = _S699->diffuse_reflect_0 + _S699->diffuse_transmit_0;
    float _S709 = __ldg(&_S702->colour_noise_0);
    uint _S710 = __ldg(&_S702->seed_0);
    float _S711 = thread_gain_0(_S700, _S709, _S710);
    float _S712 = __ldg(&_S702->layer_bound_0);
    float _S713 = bounded_gain_0(_S711, _S708, make_float3 (1.0f) - make_float3 (_S712) * _S705);
    float3  _S714 = min_0((make_float3 (1.0f) - make_float3 (_S713) * _S708) / make_float3 (_S712), make_float3 (1.0f));
    float _S715 = __ldg(&_S702->fibre_noise_0);
    float _S716 = bounded_gain_0(fibre_gain_0(_S700, _S701, _S715, _S710), _S705, _S714);
    Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = make_float3 (_S713) * _S706;
    (&varied_0)->diffuse_transmit_0 = make_float3 (_S713) * _S707;
    (&varied_0)->specular_reflect_0 = make_float3 (_S716) * _S703;
    (&varied_0)->specular_transmit_0 = make_float3 (_S716) * _S704;
    return varied_0;
}

__device__ Albedos_0 varied_at_0(uint _S717, SurfacePoint_0 * _S718, Albedos_0 * _S719, float _S720, float _S721)
{
    Fabric_0 * _S722 = (&(globalParams_0->fabrics_0)[_S717]);
    bool _S723 = _S718->is_warp_2;
    float _S724;
    if(_S718->is_warp_2)
    {
        _S724 = _S720;
    }
    else
    {
        _S724 = _S721;
    }
    float _S725 = _S724 - _S718->across_2;
    uint _S726;
    if(_S723)
    {
        uint _S727 = __ldg(&_S722->warp_0);
        _S726 = _S727;
    }
    else
    {
        uint _S728 = __ldg(&_S722->weft_0);
        _S726 = _S728;
    }
    Family_0 _S729 = slang_ldg_1((&(globalParams_0->families_0)[_S726]));
    Family_0 _S730 = slang_ldg_1((&(globalParams_0->families_0)[_S726]));
    int _S731 = int(_S730.count_0);
    if(_S723)
    {
        _S726 = _S718->warp_thread_0;
    }
    else
    {
        _S726 = _S718->weft_thread_0;
    }
    uint _S732 = uint(int((F32_floor((_S725 / _S729.period_0)))) * _S731 + int(_S726)) * 2U;
    if(_S723)
    {
        _S726 = 1U;
    }
    else
    {
        _S726 = 0U;
    }
    uint _S733 = _S732 + _S726;
    float _S734 = _S718->fibre_across_0;
    float _S735 = __ldg(&_S722->fibre_size_0);
    float _S736 = (F32_floor((_S734 / _S735)));
    Albedos_0 _S737 = vary_albedos_0(_S717, _S719, _S733, uint(int(_S736)) * 65536U + uint(int((F32_floor((_S718->fibre_along_0 / (_S735 * 40.0f) + 0.61799997091293335f * _S736))))));
    return _S737;
}

__device__ YarnPoint_0 yarn_point_of_0(uint _S738, SurfacePoint_0 * _S739, float _S740, float _S741, bool _S742, bool _S743)
{
    Fabric_0 * _S744 = (&(globalParams_0->fabrics_0)[_S738]);
    bool _S745 = _S739->is_warp_2;
    uint _S746;
    if(_S739->is_warp_2)
    {
        uint _S747 = __ldg(&_S744->warp_0);
        _S746 = _S747;
    }
    else
    {
        uint _S748 = __ldg(&_S744->weft_0);
        _S746 = _S748;
    }
    uint _S749;
    if(_S745)
    {
        _S749 = _S739->warp_thread_0;
    }
    else
    {
        _S749 = _S739->weft_thread_0;
    }
    Albedos_0 albedos_3 = albedos_of_0(_S746, _S749);
    float _S750 = __ldg(&_S744->fibre_noise_0);
    bool _S751;
    if(_S750 > 0.0f)
    {
        _S751 = true;
    }
    else
    {
        float _S752 = __ldg(&_S744->colour_noise_0);
        _S751 = _S752 > 0.0f;
    }
    Albedos_0 albedos_4;
    if(_S751)
    {
        Albedos_0 _S753 = albedos_3;
        Albedos_0 _S754 = varied_at_0(_S738, _S739, &_S753, _S740, _S741);
        albedos_4 = _S754;
    }
    else
    {
        albedos_4 = albedos_3;
    }
    YarnPoint_0 point_4;
    (&point_4)->back_3 = _S742;
    (&point_4)->hole_2 = _S743;
    (&point_4)->is_warp_1 = _S745;
    (&point_4)->x_23 = _S740;
    (&point_4)->y_12 = _S741;
    (&point_4)->height_3 = _S739->height_9;
    (&point_4)->normal_4 = _S739->normal_5;
    (&point_4)->tangent_4 = _S739->tangent_5;
    Family_0 _S755 = slang_ldg_1((&(globalParams_0->families_0)[_S746]));
    (&point_4)->roughness_8 = _S755.roughness_0;
    (&point_4)->albedos_2 = albedos_4;
    return point_4;
}

__device__ YarnPoint_0 locate_yarn_0(uint _S756, SearchQuality_0 * _S757, float _S758, float _S759, float3  _S760)
{
    bool _S761 = (_S760.z) < 0.0f;
    Hit_0 _S762 = first_hit_0(_S756, _S757, _S758, _S759, to_face_frame_0(_S760, _S761), _S761);
    SurfacePoint_0 _S763 = surface_at_0(_S756, _S762.x_24, _S762.y_13, _S761);
    SurfacePoint_0 _S764 = _S763;
    YarnPoint_0 _S765 = yarn_point_of_0(_S756, &_S764, _S762.x_24, _S762.y_13, _S761, _S762.hole_3);
    return _S765;
}

__device__ uint light_sample_count_0(int _S766)
{
    Frame_0 * _S767 = (&(globalParams_0->frames_0)[_S766]);
    uint _S768 = __ldg(&_S767->lights_0);
    uint _S769 = __ldg(&_S767->environment_samples_0);
    return _S768 + _S769;
}

__device__ float visibility_at_0(int _S770, uint _S771, uint2  _S772)
{
    Frame_0 * _S773 = (&(globalParams_0->frames_0)[_S770]);
    uint _S774 = __ldg(&_S773->casts_shadows_0);
    if(_S774 == 0U)
    {
        return 1.0f;
    }
    uint _S775 = __ldg(&_S773->height_0);
    uint _S776 = _S771 * _S775 + _S772.y;
    uint _S777 = __ldg(&_S773->width_0);
    return *(&(globalParams_0->visibilities_0)[_S776 * _S777 + _S772.x]);
}

struct LightSample_0
{
    float3  towards_0;
    float3  irradiance_1;
    float distance_3;
};

__device__ float3  environment_texel_0(int _S778, uint _S779, uint _S780)
{
    Frame_0 * _S781 = (&(globalParams_0->frames_0)[_S778]);
    uint _S782 = __ldg(&_S781->environment_table_0);
    uint _S783 = __ldg(&_S781->environment_rows_0);
    uint _S784 = _S782 + _S783 + 1U;
    uint _S785 = __ldg(&_S781->environment_columns_0);
    uint _S786 = _S784 + _S783 * (_S785 + 1U) + 3U * (_S779 * _S785 + _S780);
    return make_float3 (scene_number_0(_S786), scene_number_0(_S786 + 1U), scene_number_0(_S786 + 2U));
}

__device__ float3  sample_environment_0(int _S787, float2  _S788, float3  * _S789)
{
    Frame_0 * _S790 = (&(globalParams_0->frames_0)[_S787]);
    uint _S791 = __ldg(&_S790->environment_table_0);
    uint _S792 = __ldg(&_S790->environment_rows_0);
    Choice_0 _S793 = choose_0(_S791, _S792, _S788.y);
    uint _S794 = _S791 + _S792 + 1U;
    uint _S795 = __ldg(&_S790->environment_columns_0);
    Choice_0 _S796 = choose_0(_S794 + _S793.index_6 * (_S795 + 1U), _S795, _S788.x);
    float3  _S797 = environment_texel_0(_S787, _S793.index_6, _S796.index_6);
    float _S798 = __ldg(&_S790->environment_total_0);
    *_S789 = _S797 * make_float3 (_S798 / (F32_max((mean_0(_S797)), (9.99999968265522539e-21f))));
    float _S799 = 3.14159274101257324f / float(_S792);
    float _S800 = lerp_0(sine_cosine_0(float(_S793.index_6) * _S799).y, sine_cosine_0(float(_S793.index_6 + 1U) * _S799).y, _S793.remainder_0);
    float _S801 = (F32_sqrt(((F32_max((1.0f - _S800 * _S800), (0.0f))))));
    float2  _S802 = sine_cosine_0((float(_S796.index_6) + _S796.remainder_0) * (6.28318548202514648f / float(_S795)));
    float _S803 = _S801 * _S802.x;
    float _S804 = - _S801 * _S802.y;
    float _S805 = __ldg(&_S790->environment_cosine_0);
    float _S806 = _S805 * _S803;
    float _S807 = __ldg(&_S790->environment_sine_0);
    return make_float3 (_S806 + _S807 * _S804, _S800, _S805 * _S804 - _S807 * _S803);
}

__device__ LightSample_0 light_sample_0(int _S808, uint _S809, uint2  _S810, float3  _S811)
{
    Frame_0 * _S812 = (&(globalParams_0->frames_0)[_S808]);
    LightSample_0 sample_1;
    (&sample_1)->distance_3 = 1.00000001504746622e+30f;
    uint _S813 = __ldg(&_S812->lights_0);
    if(_S809 >= _S813)
    {
        uint _S814 = __ldg(&_S812->pass_number_0);
        uint _S815 = __ldg(&_S812->environment_samples_0);
        float3  weight_0;
        float3  _S816 = sample_environment_0(_S808, pixel_sequence_0(_S810, _S814 * _S815 + (_S809 - _S813), 3U), &weight_0);
        (&sample_1)->towards_0 = _S816;
        (&sample_1)->irradiance_1 = weight_0 / make_float3 (float(_S815));
        return sample_1;
    }
    Light_0 _S817 = slang_ldg_2((&(globalParams_0->lights_1)[_S809]));
    (&sample_1)->irradiance_1 = make_float3 (_S817.red_0, _S817.green_0, _S817.blue_0);
    (&sample_1)->towards_0 = make_float3 (_S817.x_0, _S817.y_0, _S817.z_0);
    if((_S817.is_point_0) != 0U)
    {
        float3  _S818 = (&sample_1)->towards_0 - _S811;
        float _S819 = (F32_max((square_0(_S818)), (9.999999960041972e-13f)));
        (&sample_1)->distance_3 = (F32_sqrt((_S819)));
        (&sample_1)->irradiance_1 = (&sample_1)->irradiance_1 / make_float3 (_S819);
        (&sample_1)->towards_0 = normalize_0(_S818);
    }
    return sample_1;
}

__device__ float3  scattered_0(uint _S820, YarnPoint_0 * _S821, float3  _S822, float3  _S823)
{
    Fabric_0 * _S824 = (&(globalParams_0->fabrics_0)[_S820]);
    float3  _S825 = make_float3 (0.0f);
    bool _S826 = !_S821->hole_2;
    bool _S827;
    if(_S826)
    {
        _S827 = (_S822.z) > 0.0f;
    }
    else
    {
        _S827 = false;
    }
    float3  value_1;
    if(_S827)
    {
        float3  _S828 = (&_S821->albedos_2)->diffuse_reflect_0;
        float3  _S829 = _S821->normal_4;
        float _S830 = __ldg(&_S824->diffuse_blend_0);
        float3  _S831 = _S828 * make_float3 (diffuse_reflection_0(_S822, _S829, _S830));
        float3  _S832 = (&_S821->albedos_2)->specular_reflect_0;
        float3  _S833 = _S821->tangent_4;
        float _S834 = _S821->roughness_8;
        float _S835 = __ldg(&_S824->optical_depth_0);
        value_1 = _S831 + _S832 * make_float3 (reflection_0(_S822, _S823, _S829, _S833, _S834, _S835));
    }
    else
    {
        if(_S826)
        {
            _S827 = (_S822.z) < 0.0f;
        }
        else
        {
            _S827 = false;
        }
        if(_S827)
        {
            float3  _S836 = (&_S821->albedos_2)->diffuse_transmit_0;
            float3  _S837 = - _S822;
            float3  _S838 = _S821->normal_4;
            float _S839 = __ldg(&_S824->diffuse_blend_0);
            float3  _S840 = _S836 * make_float3 (diffuse_reflection_0(_S837, _S838, _S839));
            float3  _S841 = (&_S821->albedos_2)->specular_transmit_0;
            float3  _S842 = _S821->tangent_4;
            float _S843 = _S821->roughness_8;
            float _S844 = __ldg(&_S824->optical_depth_0);
            value_1 = _S840 + _S841 * make_float3 (transmission_0(_S822, _S823, _S838, _S842, _S843, _S844));
        }
        else
        {
            value_1 = _S825;
        }
    }
    float _S845 = __ldg(&_S824->sheen_strength_0);
    if(_S845 <= 0.0f)
    {
        return value_1;
    }
    float _S846 = __ldg(&_S824->sheen_roughness_0);
    float2  _S847 = sheen_with_transmittance_0(_S822, _S823, _S845, _S846);
    return make_float3 (_S847.y) * value_1 + make_float3 (_S847.x);
}

__device__ bool unoccluded_0(uint _S848, SearchQuality_0 * _S849, float _S850, float _S851, float _S852, float3  _S853, bool _S854)
{
    Fabric_0 * _S855 = (&(globalParams_0->fabrics_0)[_S848]);
    if((_S853.z) <= 0.0f)
    {
        return false;
    }
    float _S856 = max_height_along_0(_S848, _S850, _S851, _S852, _S853, _S854);
    float _S857 = __ldg(&_S855->lift_0);
    bool _S858 = is_free_0(_S848, _S849, make_float3 (_S850, _S851, _S852 + _S857), _S853, _S854, _S856);
    return _S858;
}

__device__ bool is_lit_0(uint _S859, SearchQuality_0 * _S860, YarnPoint_0 * _S861, float3  _S862)
{
    if(_S861->hole_2)
    {
        return true;
    }
    bool _S863 = _S861->back_3;
    float3  _S864 = to_face_frame_0(_S862, _S861->back_3);
    float _S865 = _S864.z;
    bool _S866 = _S865 < 0.0f;
    float3  _S867 = _S861->normal_4;
    float _S868 = _S861->height_3;
    float3  normal_6;
    float height_10;
    if(_S866)
    {
        SurfacePoint_0 _S869 = surface_at_0(_S859, _S861->x_23, _S861->y_12, !_S863);
        normal_6 = _S869.normal_5;
        height_10 = _S869.height_9;
    }
    else
    {
        normal_6 = _S867;
        height_10 = _S868;
    }
    float3  _S870 = make_float3 (float2 {_S864.x, _S864.y}.x, float2 {_S864.x, _S864.y}.y, (F32_abs((_S865))));
    if((dot_0(normal_6, _S870)) <= 0.0f)
    {
        return false;
    }
    bool _S871 = unoccluded_0(_S859, _S860, _S861->x_23, _S861->y_12, height_10, _S870, _S863 != _S866);
    return _S871;
}

__device__ float3  evaluate_0(uint _S872, SearchQuality_0 * _S873, YarnPoint_0 * _S874, float3  _S875, float3  _S876)
{
    float3  _S877 = scattered_0(_S872, _S874, to_face_frame_0(_S875, _S874->back_3), to_face_frame_0(_S876, _S874->back_3));
    bool _S878;
    if((F32_max((_S877.x), ((F32_max((_S877.y), (_S877.z)))))) <= 0.0f)
    {
        _S878 = true;
    }
    else
    {
        bool _S879 = is_lit_0(_S872, _S873, _S874, _S875);
        _S878 = !_S879;
    }
    if(_S878)
    {
        return make_float3 (0.0f);
    }
    return _S877;
}

__device__ float straight_through_0(uint _S880, YarnPoint_0 * _S881, float3  _S882)
{
    Fabric_0 * _S883 = (&(globalParams_0->fabrics_0)[_S880]);
    if(!_S881->hole_2)
    {
        return 0.0f;
    }
    float _S884 = __ldg(&_S883->sheen_strength_0);
    if(_S884 <= 0.0f)
    {
        return 1.0f;
    }
    float _S885 = (F32_abs((_S882.z)));
    float _S886 = __ldg(&_S883->sheen_roughness_0);
    return 1.0f - _S884 * sheen_lobe_0(_S885, _S886).z;
}

__device__ float4  light_of_point_0(int _S887, uint _S888, VisiblePoint_0 * _S889, uint2  _S890, float3  _S891, float2  _S892)
{
    SearchQuality_0 _S893 = default_quality_0();
    float3  _S894 = to_local_0(_S889, _S889->view_0);
    float _S895 = _S892.x;
    float _S896 = _S892.y;
    SearchQuality_0 _S897 = _S893;
    YarnPoint_0 _S898 = locate_yarn_0(_S888, &_S897, _S895, _S896, _S894);
    YarnPoint_0 point_5 = _S898;
    Albedos_0 _S899 = (&point_5)->albedos_2;
    Albedos_0 _S900 = tinted_0(&_S899, _S891);
    (&point_5)->albedos_2 = _S900;
    float3  _S901 = make_float3 (0.0f);
    uint number_2 = 0U;
    float3  radiance_1 = _S901;
    for(;;)
    {
        uint _S902 = light_sample_count_0(_S887);
        if(number_2 < _S902)
        {
        }
        else
        {
            break;
        }
        float _S903 = visibility_at_0(_S887, number_2, _S890);
        if(_S903 <= 0.0f)
        {
            number_2 = number_2 + 1U;
            continue;
        }
        LightSample_0 _S904 = light_sample_0(_S887, number_2, _S890, _S889->position_0);
        float3  _S905 = make_float3 (_S903) * _S904.irradiance_1;
        float3  _S906 = to_local_0(_S889, _S904.towards_0);
        SearchQuality_0 _S907 = _S893;
        YarnPoint_0 _S908 = point_5;
        float3  _S909 = evaluate_0(_S888, &_S907, &_S908, _S906, _S894);
        radiance_1 = radiance_1 + _S905 * _S909;
        number_2 = number_2 + 1U;
    }
    YarnPoint_0 _S910 = point_5;
    float _S911 = straight_through_0(_S888, &_S910, _S894);
    return make_float4 (radiance_1.x, radiance_1.y, radiance_1.z, 1.0f - _S911);
}

extern "C" __global__ void shade_points()
{
    uint _S912;
    uint3  _S913 = blockIdx * blockDim + threadIdx;
    Frame_0 * _S914 = (&(globalParams_0->frames_0)[int(0)]);
    uint _S915 = _S913.x;
    uint _S916 = __ldg(&_S914->width_0);
    bool _S917;
    if(_S915 >= _S916)
    {
        _S917 = true;
    }
    else
    {
        uint _S918 = _S913.y;
        uint _S919 = __ldg(&_S914->height_0);
        _S917 = _S918 >= _S919;
    }
    if(_S917)
    {
        return;
    }
    uint2  _S920 = uint2 {_S913.x, _S913.y};
    uint _S921 = _S913.y * _S916 + _S915;
    uint _S922 = (&(globalParams_0->layers_0)[_S921])->face_0;
    if(((&(globalParams_0->layers_0)[_S921])->face_0) == 0U)
    {
        return;
    }
    uint _S923 = _S922 - 1U;
    uint _S924 = __ldg((&(globalParams_0->face_fabrics_0)[_S923]));
    VisiblePoint_0 _S925 = visible_point_0(int(0), _S924, _S923, _S920);
    VisiblePoint_0 _S926 = _S925;
    float3  _S927 = filtered_albedo_0(_S924, &_S926);
    float4  _S928 = make_float4 (0.0f);
    uint k_0 = 0U;
    float4  sum_0 = _S928;
    for(;;)
    {
        uint _S929 = __ldg(&_S914->samples_0);
        _S912 = _S929;
        if(k_0 < _S929)
        {
        }
        else
        {
            break;
        }
        uint _S930 = __ldg(&_S914->pass_number_0);
        float2  _S931 = pixel_sequence_0(_S920, _S930 * _S929 + k_0, 1U) - make_float2 (0.5f);
        float2  _S932 = _S925.draft_0 + make_float2 (_S931.x) * _S925.draft_dx_0 + make_float2 (_S931.y) * _S925.draft_dy_0;
        VisiblePoint_0 _S933 = _S925;
        float4  _S934 = light_of_point_0(int(0), _S924, &_S933, _S920, _S927, _S932);
        float4  sum_1 = sum_0 + _S934;
        k_0 = k_0 + 1U;
        sum_0 = sum_1;
    }
    accumulate_0(_S921, sum_0 / make_float4 (float(_S912)));
    return;
}

