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

__device__ float clamp_0(float x_5, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_5), (minBound_0)))), (maxBound_0)));
}

__device__ static const FixedArray<float2 , 9>  TAP_OFFSETS_0 = {
    float2 {
        -0.3333333432674408f, -0.3333333432674408f
    }, float2 {
        -0.3333333432674408f, 0.0f
    }, float2 {
        -0.3333333432674408f, 0.3333333432674408f
    }, float2 {
        0.0f, -0.3333333432674408f
    }, float2 {
        0.0f, 0.0f
    }, float2 {
        0.0f, 0.3333333432674408f
    }, float2 {
        0.3333333432674408f, -0.3333333432674408f
    }, float2 {
        0.3333333432674408f, 0.0f
    }, float2 {
        0.3333333432674408f, 0.3333333432674408f
    }
};
__device__ static const FixedArray<float, 4>  PYRAMID_RADII_0 = {
    1.0f, 2.0f, 4.0f, 8.0f
};
__device__ float lerp_0(float x_6, float y_4, float s_0)
{
    return x_6 + (y_4 - x_6) * s_0;
}

__device__ float dot_1(float2  x_7, float2  y_5)
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
        float result_3 = result_2 + _slang_vector_get_element(x_7, i_1) * _slang_vector_get_element(y_5, i_1);
        i_1 = i_1 + int(1);
        result_2 = result_3;
    }
    return result_2;
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

__device__ float3  max_0(float3  x_8, float3  y_6)
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
        *_slang_vector_get_element_ptr(&result_4, i_2) = (F32_max((_slang_vector_get_element(x_8, i_2)), (_slang_vector_get_element(y_6, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_4;
}

__device__ float3  min_0(float3  x_9, float3  y_7)
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
        *_slang_vector_get_element_ptr(&result_5, i_3) = (F32_min((_slang_vector_get_element(x_9, i_3)), (_slang_vector_get_element(y_7, i_3))));
        i_3 = i_3 + int(1);
    }
    return result_5;
}

__device__ float3  normalize_0(float3  x_10)
{
    return x_10 / make_float3 (length_0(x_10));
}

__device__ float saturate_0(float x_11)
{
    return clamp_0(x_11, 0.0f, 1.0f);
}

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

__device__ Lobes_0 slang_ldg_0(Lobes_0 * ptr_0)
{
    uint _S7 = __ldg(&ptr_0->is_baked_0);
    float _S8 = __ldg(&ptr_0->inverse_base_size_0);
    float _S9 = __ldg(&ptr_0->last_level_0);
    uint _S10 = __ldg(&ptr_0->levels_0);
    uint _S11 = __ldg(&ptr_0->face_nodes_0);
    uint _S12 = __ldg(&ptr_0->packs_0);
    uint _S13 = __ldg(&ptr_0->front_warp_packs_0);
    uint _S14 = __ldg(&ptr_0->back_warp_packs_0);
    uint _S15 = __ldg(&ptr_0->coverage_0);
    uint _S16 = __ldg(&ptr_0->coverage_holes_0);
    uint _S17 = __ldg(&ptr_0->projected_area_0);
    uint _S18 = __ldg(&ptr_0->light_visibility_0);
    uint _S19 = __ldg(&ptr_0->irradiance_0);
    uint _S20 = __ldg(&ptr_0->moments_0);
    float _S21 = __ldg(&ptr_0->front_hole_weight_0);
    float _S22 = __ldg(&ptr_0->back_hole_weight_0);
    float _S23 = __ldg(&ptr_0->threads_per_mm_0);
    float _S24 = __ldg(&ptr_0->unit_level_0);
    Lobes_0 _S25 = { _S7, _S8, _S9, _S10, _S11, _S12, _S13, _S14, _S15, _S16, _S17, _S18, _S19, _S20, _S21, _S22, _S23, _S24 };
    return _S25;
}

__device__ Vertex_0 slang_ldg_1(Vertex_0 * ptr_1)
{
    float _S26 = __ldg(&ptr_1->x_1);
    float _S27 = __ldg(&ptr_1->y_1);
    float _S28 = __ldg(&ptr_1->z_1);
    float _S29 = __ldg(&ptr_1->normal_x_0);
    float _S30 = __ldg(&ptr_1->normal_y_0);
    float _S31 = __ldg(&ptr_1->normal_z_0);
    float _S32 = __ldg(&ptr_1->u_0);
    float _S33 = __ldg(&ptr_1->v_0);
    Vertex_0 _S34 = { _S26, _S27, _S28, _S29, _S30, _S31, _S32, _S33 };
    return _S34;
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

__device__ uint scramble_0(uint value_0)
{
    uint _S35 = value_0 * 747796405U + 2891336453U;
    uint _S36 = ((_S35 >> ((_S35 >> int(28)) + 4U)) ^ _S35) * 277803737U;
    return (_S36 >> int(22)) ^ _S36;
}

__device__ float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

__device__ float2  pixel_sequence_0(uint2  pixel_0, uint index_0, uint stream_1)
{
    uint _S37 = pixel_0.x;
    uint _S38 = pixel_0.y;
    return frac_0(make_float2 (uniform_hash_0(_S37, _S38, stream_1), uniform_hash_0(_S37, _S38, stream_1 + 1U)) + make_float2 (float(index_0 & 65535U)) * make_float2 (0.75487768650054932f, 0.56984031200408936f));
}

__device__ float scene_number_0(uint index_1)
{
    uint _S39 = __ldg((&(globalParams_0->scene_words_0)[index_1]));
    return (U32_asfloat((_S39)));
}

struct Choice_0
{
    uint index_2;
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
        uint _S40 = (low_0 + high_0) / 2U;
        if((scene_number_0(table_0 + _S40)) <= number_0)
        {
            low_0 = _S40;
        }
        else
        {
            high_0 = _S40;
        }
    }
    uint _S41 = table_0 + low_0;
    float _S42 = scene_number_0(_S41);
    float _S43 = scene_number_0(_S41 + 1U);
    Choice_0 choice_0;
    (&choice_0)->index_2 = low_0;
    (&choice_0)->remainder_0 = saturate_0((number_0 - _S42) / (F32_max((_S43 - _S42), (9.999999960041972e-13f))));
    return choice_0;
}

__device__ float mean_0(float3  colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

__device__ float2  sine_cosine_0(float x_13)
{
    float _S44 = (F32_floor((x_13 * 0.63661974668502808f + 0.5f)));
    float _S45 = x_13 - _S44 * 1.5703125f - _S44 * 0.00048375129699707f - _S44 * 7.54979012640433211e-08f;
    float _S46 = _S45 * _S45;
    float _S47 = ((-0.00019515295571182f * _S46 + 0.00833216123282909f) * _S46 - 0.16666655242443085f) * _S46 * _S45 + _S45;
    float _S48 = ((0.00002443315679557f * _S46 - 0.00138873164542019f) * _S46 + 0.04166664555668831f) * _S46 * _S46 - 0.5f * _S46 + 1.0f;
    uint _S49 = uint(int(_S44)) & 3U;
    float2  _S50;
    if((_S49 & 1U) != 0U)
    {
        _S50 = make_float2 (_S48, _S47);
    }
    else
    {
        _S50 = make_float2 (_S47, _S48);
    }
    float _S51;
    if((_S49 & 2U) != 0U)
    {
        _S51 = - _S50.x;
    }
    else
    {
        _S51 = _S50.x;
    }
    float _S52;
    if(((_S49 + 1U) & 2U) != 0U)
    {
        _S52 = - _S50.y;
    }
    else
    {
        _S52 = _S50.y;
    }
    return make_float2 (_S51, _S52);
}

__device__ Light_0 slang_ldg_2(Light_0 * ptr_2)
{
    uint _S53 = __ldg(&ptr_2->is_point_0);
    float _S54 = __ldg(&ptr_2->x_0);
    float _S55 = __ldg(&ptr_2->y_0);
    float _S56 = __ldg(&ptr_2->z_0);
    float _S57 = __ldg(&ptr_2->red_0);
    float _S58 = __ldg(&ptr_2->green_0);
    float _S59 = __ldg(&ptr_2->blue_0);
    Light_0 _S60 = { _S53, _S54, _S55, _S56, _S57, _S58, _S59 };
    return _S60;
}

__device__ float inverse_of_0(float component_0)
{
    float _S61;
    if((F32_abs((component_0))) > 9.99999968265522539e-21f)
    {
        _S61 = component_0;
    }
    else
    {
        _S61 = 9.99999968265522539e-21f;
    }
    return 1.0f / _S61;
}

__device__ bool meets_node_0(uint node_0, float3  origin_0, float3  inverse_0, float nearest_0, float farthest_0)
{
    uint _S62 = 6U * (node_0 - 1U);
    float3  _S63 = (make_float3 (scene_number_0(_S62), scene_number_0(_S62 + 1U), scene_number_0(_S62 + 2U)) - origin_0) * inverse_0;
    float3  _S64 = (make_float3 (scene_number_0(_S62 + 3U), scene_number_0(_S62 + 4U), scene_number_0(_S62 + 5U)) - origin_0) * inverse_0;
    float3  _S65 = min_0(_S63, _S64);
    float3  _S66 = max_0(_S63, _S64) * make_float3 (1.0000004768371582f);
    return (F32_max(((F32_max((_S65.x), (_S65.y)))), ((F32_max((_S65.z), (nearest_0)))))) <= (F32_min(((F32_min((_S66.x), (_S66.y)))), ((F32_min((_S66.z), (farthest_0))))));
}

__device__ uint following_node_0(uint node_1)
{
    uint _S67 = node_1 + 1U;
    uint _S68 = _S67 >> (U32_firstbitlow((_S67)));
    uint _S69;
    if(_S68 == 1U)
    {
        _S69 = 0U;
    }
    else
    {
        _S69 = _S68;
    }
    return _S69;
}

struct Hit_0
{
    uint face_1;
    float distance_0;
    float weight_b_0;
    float weight_c_0;
};

__device__ Hit_0 meet_face_0(uint face_2, float3  origin_1, float3  direction_0)
{
    uint _S70 = 3U * face_2;
    uint _S71 = __ldg((&(globalParams_0->corners_0)[_S70]));
    Vertex_0 _S72 = slang_ldg_1((&(globalParams_0->vertices_0)[_S71]));
    Vertex_0 _S73 = _S72;
    float3  _S74 = position_of_0(&_S73);
    uint _S75 = __ldg((&(globalParams_0->corners_0)[_S70 + 1U]));
    Vertex_0 _S76 = slang_ldg_1((&(globalParams_0->vertices_0)[_S75]));
    Vertex_0 _S77 = _S76;
    float3  _S78 = position_of_0(&_S77);
    float3  _S79 = _S78 - _S74;
    uint _S80 = __ldg((&(globalParams_0->corners_0)[_S70 + 2U]));
    Vertex_0 _S81 = slang_ldg_1((&(globalParams_0->vertices_0)[_S80]));
    Vertex_0 _S82 = _S81;
    float3  _S83 = position_of_0(&_S82);
    float3  _S84 = _S83 - _S74;
    float3  _S85 = cross_0(direction_0, _S84);
    float _S86 = dot_0(_S79, _S85);
    bool _S87 = (F32_abs((_S86))) > 1.00000000317107685e-30f;
    float _S88;
    if(_S87)
    {
        _S88 = _S86;
    }
    else
    {
        _S88 = 1.00000000317107685e-30f;
    }
    float _S89 = 1.0f / _S88;
    float3  _S90 = origin_1 - _S74;
    float3  _S91 = cross_0(_S90, _S79);
    Hit_0 hit_0;
    float _S92 = dot_0(_S90, _S85) * _S89;
    (&hit_0)->weight_b_0 = _S92;
    (&hit_0)->weight_c_0 = dot_0(direction_0, _S91) * _S89;
    (&hit_0)->distance_0 = dot_0(_S84, _S91) * _S89;
    bool _S93;
    if(_S92 >= 0.0f)
    {
        _S93 = ((&hit_0)->weight_c_0) >= 0.0f;
    }
    else
    {
        _S93 = false;
    }
    if(_S93)
    {
        _S93 = ((&hit_0)->weight_b_0 + (&hit_0)->weight_c_0) <= 1.0f;
    }
    else
    {
        _S93 = false;
    }
    if(_S93)
    {
        _S93 = _S87;
    }
    else
    {
        _S93 = false;
    }
    uint _S94;
    if(_S93)
    {
        _S94 = face_2;
    }
    else
    {
        _S94 = 4294967295U;
    }
    (&hit_0)->face_1 = _S94;
    return hit_0;
}

struct VisiblePoint_0
{
    float3  position_0;
    float3  view_0;
    float3  axis_x_0;
    float3  axis_y_0;
    float3  normal_0;
    float3  face_normal_0;
    float2  uv_0;
    float2  draft_per_uv_0;
    float2  draft_0;
    float2  draft_dx_0;
    float2  draft_dy_0;
};

__device__ float3  to_local_0(VisiblePoint_0 * point_0, float3  direction_1)
{
    return make_float3 (dot_0(direction_1, point_0->axis_x_0), dot_0(direction_1, point_0->axis_y_0), dot_0(direction_1, point_0->normal_0));
}

__device__ float3  to_face_frame_0(float3  direction_2, bool back_1)
{
    float2  _S95 = float2 {direction_2.x, direction_2.y};
    float _S96;
    if(back_1)
    {
        _S96 = - direction_2.z;
    }
    else
    {
        _S96 = direction_2.z;
    }
    return make_float3 (_S95.x, _S95.y, _S96);
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

__device__ float natural_logarithm_0(float x_14)
{
    uint _S97 = (F32_asuint((x_14)));
    float exponent_0 = float(int(_S97 >> int(23)) - int(126));
    float m_0 = (U32_asfloat(((_S97 & 8388607U) | 1056964608U)));
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
    float _S98 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S98 - exponent_1 * 0.00021219444170129f - 0.5f * _S98) + exponent_1 * 0.693359375f;
}

__device__ float binary_logarithm_0(float x_15)
{
    return natural_logarithm_0(x_15) * 1.4426950216293335f;
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

__device__ Family_0 slang_ldg_3(Family_0 * ptr_3)
{
    uint _S99 = __ldg(&ptr_3->is_alike_0);
    float _S100 = __ldg(&ptr_3->count_0);
    float _S101 = __ldg(&ptr_3->inverse_count_0);
    float _S102 = __ldg(&ptr_3->half_inverse_count_0);
    float _S103 = __ldg(&ptr_3->size_0);
    float _S104 = __ldg(&ptr_3->inverse_size_0);
    float _S105 = __ldg(&ptr_3->half_width_0);
    float _S106 = __ldg(&ptr_3->start_0);
    float _S107 = __ldg(&ptr_3->period_0);
    float _S108 = __ldg(&ptr_3->inverse_period_0);
    float _S109 = __ldg(&ptr_3->bins_0);
    uint _S110 = __ldg(&ptr_3->first_thread_table_0);
    uint _S111 = __ldg(&ptr_3->place_table_0);
    uint _S112 = __ldg(&ptr_3->bend_table_0);
    float _S113 = __ldg(&ptr_3->height_scale_0);
    float _S114 = __ldg(&ptr_3->twist_sine_0);
    float _S115 = __ldg(&ptr_3->twist_cosine_0);
    float _S116 = __ldg(&ptr_3->level_0);
    float _S117 = __ldg(&ptr_3->roughness_0);
    uint _S118 = __ldg(&ptr_3->albedo_table_0);
    uint _S119 = __ldg(&ptr_3->albedo_stride_0);
    uint _S120 = __ldg(&ptr_3->before_0);
    float _S121 = __ldg(&ptr_3->visible_total_0);
    float _S122 = __ldg(&ptr_3->smallest_box_0);
    uint _S123 = __ldg(&ptr_3->quantities_0);
    uint _S124 = __ldg(&ptr_3->colour_mean_0);
    uint _S125 = __ldg(&ptr_3->colour_axes_0);
    uint _S126 = __ldg(&ptr_3->colour_threads_0);
    uint _S127 = __ldg(&ptr_3->colour_areas_0);
    float _S128 = __ldg(&ptr_3->area_unit_0);
    float _S129 = __ldg(&ptr_3->crossing_area_0);
    Family_0 _S130 = { _S99, _S100, _S101, _S102, _S103, _S104, _S105, _S106, _S107, _S108, _S109, _S110, _S111, _S112, _S113, _S114, _S115, _S116, _S117, _S118, _S119, _S120, _S121, _S122, _S123, _S124, _S125, _S126, _S127, _S128, _S129 };
    return _S130;
}

__device__ float2  turns_and_remainder_0(uint family_0, float index_3)
{
    Family_0 _S131 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    Family_0 _S132 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    float _S133 = (F32_floor(((F32_fma((index_3), (_S131.inverse_count_0), (_S132.half_inverse_count_0))))));
    float _S134 = - _S133;
    Family_0 _S135 = slang_ldg_3((&(globalParams_0->families_0)[family_0]));
    return make_float2 (_S133, (F32_fma((_S134), (_S135.count_0), (index_3))));
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
    Family_0 _S136 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    float _S137 = (F32_floor((position_1 * _S136.inverse_size_0)));
    Cell_0 cell_1;
    float _S138 = - _S137;
    Family_0 _S139 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    float _S140 = (F32_fma((_S138), (_S139.size_0), (position_1)));
    (&cell_1)->below_0 = _S140;
    Family_0 _S141 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->above_0 = _S141.size_0 - _S140;
    Family_0 _S142 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->across_0 = _S140 - 0.5f * _S142.size_0;
    Family_0 _S143 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->half_width_1 = _S143.half_width_0;
    float _S144 = turns_and_remainder_0(family_1, _S137).y;
    Family_0 _S145 = slang_ldg_3((&(globalParams_0->families_0)[family_1]));
    (&cell_1)->thread_1 = uint(clamp_0(_S144, 0.0f, _S145.count_0 - 1.0f));
    return cell_1;
}

__device__ float table_number_0(uint index_4)
{
    uint _S146 = __ldg((&(globalParams_0->words_0)[index_4]));
    return (U32_asfloat((_S146)));
}

__device__ Cell_0 locate_varied_0(uint family_2, float position_2)
{
    Family_0 _S147 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S148 = position_2 - _S147.start_0;
    Family_0 _S149 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float turns_0 = _S148 * _S149.inverse_period_0;
    float turns_1 = turns_0 - (F32_floor((turns_0)));
    Family_0 _S150 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S151 = turns_1 * _S150.period_0;
    Family_0 _S152 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    float _S153 = turns_1 * _S152.bins_0;
    Family_0 _S154 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S155 = uint(clamp_0(_S153, 0.0f, _S154.bins_0 - 1.0f));
    Family_0 _S156 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S157 = __ldg((&(globalParams_0->words_0)[_S156.first_thread_table_0 + _S155]));
    Family_0 _S158 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S159;
    if(_S151 >= (table_number_0(_S158.place_table_0 + _S157 * 4U + 1U)))
    {
        _S159 = 1U;
    }
    else
    {
        _S159 = 0U;
    }
    uint _S160 = _S157 + _S159;
    Family_0 _S161 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S162 = (U32_min((_S160), (uint(_S161.count_0) - 1U)));
    Family_0 _S163 = slang_ldg_3((&(globalParams_0->families_0)[family_2]));
    uint _S164 = _S163.place_table_0 + _S162 * 4U;
    Cell_0 cell_2;
    (&cell_2)->thread_1 = _S162;
    (&cell_2)->below_0 = _S151 - table_number_0(_S164);
    (&cell_2)->above_0 = table_number_0(_S164 + 1U) - _S151;
    (&cell_2)->across_0 = _S151 - table_number_0(_S164 + 2U);
    (&cell_2)->half_width_1 = table_number_0(_S164 + 3U);
    return cell_2;
}

__device__ Cell_0 locate_0(uint family_3, float position_3)
{
    Family_0 _S165 = slang_ldg_3((&(globalParams_0->families_0)[family_3]));
    if((_S165.is_alike_0) != 0U)
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
    bool _S166 = (F32_abs(((&crossing_0->warp_1)->across_0))) < ((&crossing_0->warp_1)->half_width_1);
    bool _S167 = (F32_abs(((&crossing_0->weft_1)->across_0))) < ((&crossing_0->weft_1)->half_width_1);
    Shown_0 shown_0;
    bool _S168;
    if(_S166)
    {
        if(!_S167)
        {
            _S168 = true;
        }
        else
        {
            _S168 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S168 = false;
    }
    (&shown_0)->is_warp_0 = _S168;
    if(!_S166)
    {
        _S168 = !_S167;
    }
    else
    {
        _S168 = false;
    }
    (&shown_0)->hole_0 = _S168;
    uint _S169;
    if((&shown_0)->is_warp_0)
    {
        _S169 = crossing_0->warp_word_0;
    }
    else
    {
        _S169 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S169;
    (&shown_0)->on_top_0 = ((_S169 & 1U) == 1U) != back_2;
    return shown_0;
}

__device__ Cell_0 select_cell_0(bool is_first_0, Cell_0 * first_0, Cell_0 * second_0)
{
    Cell_0 cell_3;
    uint _S170;
    if(is_first_0)
    {
        _S170 = first_0->thread_1;
    }
    else
    {
        _S170 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S170;
    float _S171;
    if(is_first_0)
    {
        _S171 = first_0->across_0;
    }
    else
    {
        _S171 = second_0->across_0;
    }
    (&cell_3)->across_0 = _S171;
    if(is_first_0)
    {
        _S171 = first_0->half_width_1;
    }
    else
    {
        _S171 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S171;
    if(is_first_0)
    {
        _S171 = first_0->below_0;
    }
    else
    {
        _S171 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S171;
    if(is_first_0)
    {
        _S171 = first_0->above_0;
    }
    else
    {
        _S171 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S171;
    return cell_3;
}

__device__ float boundary_0(uint family_4, uint thread_2, int step_0)
{
    float2  _S172 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0));
    float _S173 = _S172.x;
    Family_0 _S174 = slang_ldg_3((&(globalParams_0->families_0)[family_4]));
    Family_0 _S175 = slang_ldg_3((&(globalParams_0->families_0)[family_4]));
    return (F32_fma((_S173), (_S174.period_0), (table_number_0(_S175.place_table_0 + uint(_S172.y) * 4U))));
}

__device__ float span_0(uint family_5, uint thread_3, int first_1, int last_0)
{
    Family_0 _S176 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
    if((_S176.is_alike_0) != 0U)
    {
        float _S177 = float(last_0 - first_1);
        Family_0 _S178 = slang_ldg_3((&(globalParams_0->families_0)[family_5]));
        return _S177 * _S178.size_0;
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
    Family_0 _S179 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    Family_0 _S180 = slang_ldg_3((&(globalParams_0->families_0)[family_6]));
    uint _S181;
    if((_S180.is_alike_0) != 0U)
    {
        _S181 = 0U;
    }
    else
    {
        _S181 = thread_4 * 4U;
    }
    uint _S182 = _S179.bend_table_0 + _S181;
    Bend_0 bend_0;
    (&bend_0)->sine_0 = table_number_0(_S182);
    (&bend_0)->half_tangent_0 = table_number_0(_S182 + 1U);
    (&bend_0)->arc_0 = table_number_0(_S182 + 2U);
    return bend_0;
}

struct Run_0
{
    float distance_1;
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
    int _S183 = int((word_1 >> int(1)) & 127U);
    int _S184 = int((word_1 >> int(8)) & 127U);
    int _S185 = int((word_1 >> int(15)) & 63U);
    int _S186 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    uint _S187 = crossed_0->thread_1;
    int _S188 = - _S183;
    float _S189 = crossed_0->below_0 + span_0(other_0, crossed_0->thread_1, _S188, int(0));
    (&run_0)->from_start_0 = _S189;
    int _S190 = _S184 + int(1);
    float _S191 = crossed_0->above_0 + span_0(other_0, crossed_0->thread_1, int(1), _S190);
    (&run_0)->to_end_0 = _S191;
    bool _S192 = _S189 < _S191;
    (&run_0)->near_start_0 = _S192;
    int _S193;
    if(_S192)
    {
        _S193 = _S188 - _S185;
    }
    else
    {
        _S193 = _S190;
    }
    int _S194;
    if((&run_0)->near_start_0)
    {
        _S194 = _S188;
    }
    else
    {
        _S194 = _S190 + _S186;
    }
    (&run_0)->bend_1 = bend_of_0(own_0, thread_5);
    float _S195;
    if((&run_0)->straight_0)
    {
        _S195 = 1.0e+06f;
    }
    else
    {
        _S195 = (F32_min(((&run_0)->from_start_0), ((&run_0)->to_end_0)));
    }
    (&run_0)->distance_1 = _S195;
    (&run_0)->reach_0 = (F32_min((0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->other_reach_0 = (F32_min((0.5f * span_0(other_0, _S187, _S193, _S194)), ((&(&run_0)->bend_1)->arc_0)));
    (&run_0)->first_crossing_0 = _S183 == int(0);
    (&run_0)->last_crossing_0 = _S184 == int(0);
    return run_0;
}

__device__ float square_1(float x_16)
{
    return x_16 * x_16;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

__device__ Section_0 section_at_0(Cell_0 * cell_4)
{
    float _S196 = cell_4->half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S197 = clamp_0(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_1 = _S197;
    float _S198 = _S196 * _S196 - square_1(_S197);
    float _S199 = (F32_rsqrt((_S198)));
    (&section_0)->drop_0 = _S196 - _S198 * _S199;
    (&section_0)->slope_0 = - _S197 * _S199;
    return section_0;
}

__device__ float edge_drop_0(uint family_7, uint thread_6, int step_1)
{
    Family_0 _S200 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    if((_S200.is_alike_0) != 0U)
    {
        Family_0 _S201 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
        return table_number_0(_S201.bend_table_0 + 3U);
    }
    Family_0 _S202 = slang_ldg_3((&(globalParams_0->families_0)[family_7]));
    return table_number_0(_S202.bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_6) + step_1)).y) * 4U + 3U);
}

__device__ float2  dive_0(uint other_1, Shown_0 * shown_1, Run_0 * run_1, Cell_0 * crossed_1)
{
    float _S203 = crossed_1->below_0;
    float _S204 = crossed_1->above_0;
    bool _S205 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S206 = (F32_min((crossed_1->below_0), (crossed_1->above_0)));
    float _S207;
    if(_S205)
    {
        _S207 = _S203 - crossed_1->across_0;
    }
    else
    {
        _S207 = _S204 + crossed_1->across_0;
    }
    float _S208 = _S207 - crossed_1->half_width_1;
    bool _S209;
    if(_S205)
    {
        _S209 = run_1->first_crossing_0;
    }
    else
    {
        _S209 = run_1->last_crossing_0;
    }
    bool _S210 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S207 = 0.0f;
    }
    else
    {
        Family_0 _S211 = slang_ldg_3((&(globalParams_0->families_0)[other_1]));
        _S207 = _S211.height_scale_0 * edge_drop_0(other_1, crossed_1->thread_1, int(0));
    }
    float _S212;
    if(_S210 != _S209)
    {
        _S212 = 0.0f;
    }
    else
    {
        Family_0 _S213 = slang_ldg_3((&(globalParams_0->families_0)[other_1]));
        uint _S214 = crossed_1->thread_1;
        int _S215;
        if(_S205)
        {
            _S215 = int(-1);
        }
        else
        {
            _S215 = int(1);
        }
        _S212 = _S213.height_scale_0 * edge_drop_0(other_1, _S214, _S215);
    }
    float _S216 = 1.0f / (F32_max((2.0f * _S208), (9.999999960041972e-13f)));
    float _S217 = clamp_0((_S208 - _S206) * _S216, 0.0f, 1.0f);
    float _S218 = _S207 + (_S212 - _S207) * (_S217 * _S217 * (3.0f - 2.0f * _S217));
    float _S219 = (_S207 - _S212) * (6.0f * _S217 * (1.0f - _S217) * _S216);
    if(_S205)
    {
        _S207 = 1.0f;
    }
    else
    {
        _S207 = -1.0f;
    }
    return make_float2 (_S218, _S219 * _S207);
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

__device__ StepControl_0 step_control_0(float2  direction_3, float step_3)
{
    StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S220 = direction_3.x;
    (&control_0)->per_x_0 = 1.0f / (F32_max(((F32_abs((_S220)))), (9.99999971718068537e-10f)));
    float _S221 = direction_3.y;
    (&control_0)->per_y_0 = 1.0f / (F32_max(((F32_abs((_S221)))), (9.99999971718068537e-10f)));
    (&control_0)->right_1 = _S220 > 0.0f;
    (&control_0)->up_0 = _S221 > 0.0f;
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
    float _S222;
    if(forwards_0)
    {
        _S222 = cell_5->across_0;
    }
    else
    {
        _S222 = - cell_5->across_0;
    }
    float _S223;
    if(forwards_0)
    {
        _S223 = cell_5->above_0;
    }
    else
    {
        _S223 = cell_5->below_0;
    }
    bool _S224;
    if(forwards_0)
    {
        _S224 = run_2->last_crossing_0;
    }
    else
    {
        _S224 = run_2->first_crossing_0;
    }
    bool _S225;
    if(forwards_0)
    {
        _S225 = run_2->first_crossing_0;
    }
    else
    {
        _S225 = run_2->last_crossing_0;
    }
    float _S226 = cell_5->half_width_1;
    float _S227 = - cell_5->half_width_1;
    bool _S228 = _S222 < _S227;
    bool _S229 = _S222 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S224 = !_S224;
    }
    else
    {
        _S224 = false;
    }
    if(_S224)
    {
        _S224 = !shown_2->hole_0;
    }
    else
    {
        _S224 = false;
    }
    bool _S230;
    if(_S224)
    {
        _S230 = shown_2->on_top_0;
    }
    else
    {
        _S230 = false;
    }
    if(_S230)
    {
        if(_S225)
        {
            _S225 = _S228;
        }
        else
        {
            _S225 = false;
        }
        _S225 = !_S225;
    }
    else
    {
        _S225 = false;
    }
    if(shown_2->hole_0)
    {
        _S224 = true;
    }
    else
    {
        if(_S224)
        {
            _S224 = !shown_2->on_top_0;
        }
        else
        {
            _S224 = false;
        }
    }
    float _S231;
    if(_S228)
    {
        _S231 = _S227;
    }
    else
    {
        _S231 = _S226;
    }
    float _S232 = _S231 - _S222;
    if(_S224)
    {
        _S222 = 2.0f * _S223 + _S222 - _S226;
    }
    else
    {
        _S222 = _S223;
    }
    if(_S225)
    {
        if(forwards_0)
        {
            _S222 = run_2->to_end_0;
        }
        else
        {
            _S222 = run_2->from_start_0;
        }
        return _S222;
    }
    if(_S229)
    {
    }
    else
    {
        _S222 = _S232;
    }
    return _S222;
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
    float _S233 = previous_1->rate_0;
    float _S234 = previous_1->rate_0 * step_4;
    float _S235 = rate_1 * step_4;
    bool _S236;
    if(!previous_1->known_0)
    {
        _S236 = true;
    }
    else
    {
        _S236 = here_0->hole_1;
    }
    if(_S236)
    {
        _S236 = true;
    }
    else
    {
        _S236 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S236)
    {
        _S236 = true;
    }
    else
    {
        _S236 = _S233 >= 0.0f;
    }
    if(_S236)
    {
        _S236 = true;
    }
    else
    {
        _S236 = rate_1 <= 0.0f;
    }
    if(_S236)
    {
        return -1.0f;
    }
    float _S237 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S234) >= 0.0f)
    {
        _S236 = (3.0f * clearance_1 - _S235) >= 0.0f;
    }
    else
    {
        _S236 = false;
    }
    if(_S236)
    {
        return -1.0f;
    }
    float _S238 = clearance_1 - _S237;
    float _S239 = 6.0f * _S238 - 4.0f * _S234 - 2.0f * _S235;
    float _S240 = -2.0f * _S234 / (F32_max((_S239 + (F32_sqrt(((F32_max((_S239 * _S239 - 4.0f * (3.0f * (_S234 + _S235 - 2.0f * _S238)) * _S234), (0.0f))))))), (9.99999968265522539e-21f)));
    float _S241 = 1.0f - _S240;
    float _S242 = (_S237 * (2.0f * _S240 + 1.0f) + _S234 * _S240) * _S241 * _S241;
    float _S243 = (clearance_1 * (2.0f * _S241 + 1.0f) - _S235 * _S241) * _S240 * _S240;
    if(_S240 > 0.01999999955296516f)
    {
        _S236 = _S241 > 0.01999999955296516f;
    }
    else
    {
        _S236 = false;
    }
    if(_S236)
    {
        _S236 = (_S242 + _S243) < 0.0f;
    }
    else
    {
        _S236 = false;
    }
    float _S244;
    if(_S236)
    {
        _S244 = _S241 * step_4;
    }
    else
    {
        _S244 = -1.0f;
    }
    return _S244;
}

__device__ PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 * here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    bool _S245 = here_1->hole_1;
    float _S246;
    if(here_1->hole_1)
    {
        _S246 = 1.0e+09f;
    }
    else
    {
        _S246 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S246;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S247;
    if(!_S245)
    {
        _S247 = !is_cell_exit_0;
    }
    else
    {
        _S247 = false;
    }
    (&previous_2)->known_0 = _S247;
    return previous_2;
}

__device__ float StepControl_to_cell_exit_0(StepControl_0 * this_1, float side_x_1, float side_y_1)
{
    return (F32_max(((F32_min((side_x_1 * this_1->per_x_0), (side_y_1 * this_1->per_y_0)))), (0.0f))) + this_1->epsilon_0;
}

__device__ float StepControl_to_next_sample_0(StepControl_0 * this_2, Probe_0 * here_2, float clearance_3, float rate_3)
{
    float _S248 = (F32_min((here_2->edge_x_0 * this_2->per_x_0), (here_2->edge_y_0 * this_2->per_y_0)));
    bool _S249;
    if(!here_2->hole_1)
    {
        _S249 = (rate_3 * _S248 + clearance_3) < 0.0f;
    }
    else
    {
        _S249 = false;
    }
    if(_S249)
    {
        _S249 = _S248 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S249 = false;
    }
    float _S250 = this_2->step_2;
    float _S251;
    if(_S249)
    {
        _S251 = _S248 - this_2->epsilon_0;
    }
    else
    {
        _S251 = (F32_max((_S248), (0.0f))) + this_2->epsilon_0;
    }
    return (F32_min((_S250), (_S251)));
}

struct ViewRay_0
{
    float2  origin_2;
    float2  slope_1;
};

__device__ float2  ViewRay_at_0(ViewRay_0 * this_3, float height_2)
{
    return this_3->origin_2 + this_3->slope_1 * make_float2 (height_2);
}

__device__ float ViewRay_rate_0(ViewRay_0 * this_4, Probe_0 * here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
}

__device__ float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S252 = end_0 - start_1;
    float _S253 = start_rate_0 + end_rate_0 - 2.0f * _S252;
    float _S254 = 3.0f * _S252 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / (F32_max((- _S252), (9.99999968265522539e-21f)));
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
        float _S255 = clamp_0(share_1 - (((_S253 * share_1 + _S254) * share_1 + start_rate_0) * share_1 + start_1) / (F32_min(((3.0f * _S253 * share_1 + 2.0f * _S254) * share_1 + start_rate_0), (0.10000000149011612f * _S252 - 9.99999968265522539e-21f))), 0.0f, 1.0f);
        int _S256 = i_5 + int(1);
        share_1 = _S255;
        i_5 = _S256;
    }
    return share_1;
}

__device__ float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp_0(above_gap_0 / (F32_max((above_gap_0 + under_gap_0), (9.99999968265522539e-21f))), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

__device__ float arc_tangent_quotient_0(float x_17, float y_8)
{
    return ((((((0.0f * x_17 + 0.00809729471802711f) * x_17 + -0.0377517081797123f) * x_17 + 0.08475969731807709f) * x_17 + -0.13537675142288208f) * x_17 + 0.19895026087760925f) * x_17 + -0.33327975869178772f) * x_17 + 0.99999970197677612f;
}

__device__ float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

__device__ float arc_tangent_0(float y_9, float x_18)
{
    float _S257 = (F32_abs((x_18)));
    float _S258 = (F32_abs((y_9)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S257), (_S258))) / (F32_max(((F32_max((_S257), (_S258)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S258 > _S257)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_18 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_9 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
    uint4  nodes_0;
    uint4  weights_0;
    float inverse_sum_0;
};

__device__ NodeTaps_0 node_taps_0(float3  direction_4)
{
    float _S259 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S260 = (F32_floor((_S259)));
    float _S261 = _S259 - _S260;
    float _S262 = (F32_sqrt((clamp_0((1.0f - (F32_abs((direction_4.z)))) / 0.97000002861022949f, 0.0f, 1.0f))));
    float _S263 = 7.0f * _S262 * (F32_sqrt((_S262)));
    float _S264 = (F32_min(((F32_floor((_S263)))), (6.0f)));
    float _S265 = _S263 - _S264;
    uint _S266 = uint(int(_S260) + int(32)) % 32U;
    uint _S267 = uint(_S264);
    uint _S268 = _S266 * 8U + _S267;
    uint _S269 = (_S266 + 1U) % 32U * 8U + _S267;
    NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = make_uint4 (_S268, _S268 + 1U, _S269, _S269 + 1U);
    float _S270 = 1.0f - _S261;
    float _S271 = 1.0f - _S265;
    float4  _S272 = make_float4 (_S270 * _S271, _S270 * _S265, _S261 * _S271, _S261 * _S265) * make_float4 (252.0f) + make_float4 (0.5f);
    uint4  _S273 = make_uint4 ((uint)_S272.x, (uint)_S272.y, (uint)_S272.z, (uint)_S272.w);
    (&taps_0)->weights_0 = _S273;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S273.x + _S273.y + _S273.z + _S273.w);
    return taps_0;
}

__device__ float wrapped_cell_0(float position_4, float count_2)
{
    return (F32_min(((F32_floor(((position_4 - (F32_floor((position_4)))) * count_2)))), (count_2 - 1.0f)));
}

__device__ float4  bytes_of_sums_0(uint even_0, uint odd_0)
{
    return make_float4 (float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

__device__ float4  interpolate_0(NodeTaps_0 * taps_1, uint4  packs_2)
{
    uint4  _S274 = (packs_2 & make_uint4 (16711935U)) * taps_1->weights_0;
    uint4  _S275 = ((packs_2 >> make_uint4 (int(8))) & make_uint4 (16711935U)) * taps_1->weights_0;
    return bytes_of_sums_0(_S274.x + _S274.y + _S274.z + _S274.w, _S275.x + _S275.y + _S275.z + _S275.w) * make_float4 (taps_1->inverse_sum_0);
}

__device__ float4  interpolate_table_0(NodeTaps_0 * taps_2, uint table_1, uint stride_0)
{
    uint4  _S276 = make_uint4 (table_1) + taps_2->nodes_0 * make_uint4 (stride_0);
    uint _S277 = __ldg((&(globalParams_0->words_0)[_S276.x]));
    uint _S278 = __ldg((&(globalParams_0->words_0)[_S276.y]));
    uint _S279 = __ldg((&(globalParams_0->words_0)[_S276.z]));
    uint _S280 = __ldg((&(globalParams_0->words_0)[_S276.w]));
    float4  _S281 = interpolate_0(taps_2, make_uint4 (_S277, _S278, _S279, _S280));
    return _S281;
}

__device__ float sheen_scale_0(float x_19, float y_10)
{
    return (((((0.0f * x_19 + (((((-1.1402510404586792f * y_10 + 0.40672621130943298f) * y_10 + 1.65398800373077393f) * y_10 + -1.29730904102325439f) * y_10 + 0.30570998787879944f) * y_10 + -0.0220868494361639f)) * x_19 + (((((-0.21142719686031342f * y_10 + 1.05947399139404297f) * y_10 + -0.41116121411323547f) * y_10 + -0.93859231472015381f) * y_10 + 0.51606941223144531f) * y_10 + 0.05409301072359085f)) * x_19 + (((((1.22944498062133789f * y_10 + -0.45962560176849365f) * y_10 + -1.63861405849456787f) * y_10 + 1.33565104007720947f) * y_10 + -0.45725581049919128f) * y_10 + 0.08243165910243988f)) * x_19 + (((((0.39779931306838989f * y_10 + -1.18879103660583496f) * y_10 + 0.28251591324806213f) * y_10 + 1.168984055519104f) * y_10 + -0.76864629983901978f) * y_10 + 0.0091691892594099f)) * x_19 + (((((-0.26563560962677002f * y_10 + -0.19379159808158875f) * y_10 + 0.2677634060382843f) * y_10 + 0.00270519289188087f) * y_10 + 0.14349560439586639f) * y_10 + 0.10290180146694183f)) * x_19 + (((((-0.20701569318771362f * y_10 + 0.24526430666446686f) * y_10 + 0.19551840424537659f) * y_10 + 0.07586126774549484f) * y_10 + 0.38894739747047424f) * y_10 + 0.15043120086193085f);
}

__device__ float sheen_shear_0(float x_20, float y_11)
{
    return ((((0.0f * x_20 + (((((-0.10608240216970444f * y_11 + 1.99214303493499756f) * y_11 + -1.42255294322967529f) * y_11 + -1.09495604038238525f) * y_11 + 0.59180057048797607f) * y_11 + 0.06902855634689331f)) * x_20 + (((((-0.46220690011978149f * y_11 + -0.29113379120826721f) * y_11 + 1.39025199413299561f) * y_11 + 0.35589990019798279f) * y_11 + -1.17120099067687988f) * y_11 + 0.15940259397029877f)) * x_20 + (((((2.26068711280822754f * y_11 + -3.64728999137878418f) * y_11 + -0.72173482179641724f) * y_11 + 3.07659196853637695f) * y_11 + -0.6827620267868042f) * y_11 + -0.3039557933807373f)) * x_20 + (((((0.81201767921447754f * y_11 + 0.36014080047607422f) * y_11 + -1.72646903991699219f) * y_11 + -0.22630110383033752f) * y_11 + 0.89514690637588501f) * y_11 + -0.10397960245609283f)) * x_20 + (((((-0.37648698687553406f * y_11 + 1.10974001884460449f) * y_11 + 0.17824520170688629f) * y_11 + -1.04968702793121338f) * y_11 + 0.1461234986782074f) * y_11 + -0.00475129019469023f);
}

__device__ float sheen_reflectance_0(float x_21, float y_12)
{
    return ((((0.0f * x_21 + (((((12.95646953582763672f * y_12 + -21.38032913208007812f) * y_12 + -7.37853097915649414f) * y_12 + 34.55607986450195312f) * y_12 + -23.61347007751464844f) * y_12 + 5.00126314163208008f)) * x_21 + (((((10.91487026214599609f * y_12 + -6.08202791213989258f) * y_12 + -38.2036285400390625f) * y_12 + 53.3440399169921875f) * y_12 + -21.91996002197265625f) * y_12 + 2.01606011390686035f)) * x_21 + (((((-14.52206039428710938f * y_12 + 36.803619384765625f) * y_12 + -22.94047927856445312f) * y_12 + -10.07973003387451172f) * y_12 + 15.77003955841064453f) * y_12 + -4.92722177505493164f)) * x_21 + (((((-7.62505722045898438f * y_12 + 1.27310299873352051f) * y_12 + 31.19523048400878906f) * y_12 + -44.39989852905273438f) * y_12 + 26.44947052001953125f) * y_12 + -8.73507976531982422f)) * x_21 + (((((5.65633487701416016f * y_12 + -17.66820907592773438f) * y_12 + 24.65356063842773438f) * y_12 + -19.38941001892089844f) * y_12 + 11.06159019470214844f) * y_12 + -3.06573700904846191f);
}

__device__ float exponential_0(float x_22)
{
    float _S282 = clamp_0(x_22, -87.0f, 88.0f);
    float _S283 = (F32_floor((_S282 * 1.4426950216293335f + 0.5f)));
    float _S284 = _S282 - _S283 * 0.693359375f + _S283 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S284 + 0.00139819993637502f) * _S284 + 0.00833345204591751f) * _S284 + 0.04166579619050026f) * _S284 + 0.1666666567325592f) * _S284 + 0.5f;
    float _S285 = (U32_asfloat((uint(int(_S283) + int(127)) << int(23))));
    float _S286;
    if(x_22 < -87.0f)
    {
        _S286 = 0.0f;
    }
    else
    {
        _S286 = (p_0 * _S284 * _S284 + _S284 + 1.0f) * _S285;
    }
    return _S286;
}

__device__ float3  sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S287 = clamp_0(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S288 = 2.0f * (F32_sqrt((_S287))) - 1.0f;
    float _S289 = 3.0f * (F32_sqrt(((F32_sqrt((clamp_0(roughness_1, 0.00999999977648258f, 1.0f))))))) - 2.0f;
    return make_float3 (clamp_0(sheen_scale_0(_S288, _S289), 0.00999999977648258f, 1.0f), clamp_0((1.0f - _S287) * sheen_shear_0(_S288, _S289), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp_0(sheen_reflectance_0(_S288, _S289), -60.0f, 60.0f))));
}

__device__ float3  camera_right_0(int _S290)
{
    Frame_0 * _S291 = (&(globalParams_0->frames_0)[_S290]);
    float _S292 = __ldg(&_S291->right_x_0);
    float _S293 = __ldg(&_S291->right_y_0);
    float _S294 = __ldg(&_S291->right_z_0);
    return make_float3 (_S292, _S293, _S294);
}

__device__ float3  camera_up_0(int _S295)
{
    Frame_0 * _S296 = (&(globalParams_0->frames_0)[_S295]);
    float _S297 = __ldg(&_S296->up_x_0);
    float _S298 = __ldg(&_S296->up_y_0);
    float _S299 = __ldg(&_S296->up_z_0);
    return make_float3 (_S297, _S298, _S299);
}

__device__ float3  camera_forward_0(int _S300)
{
    Frame_0 * _S301 = (&(globalParams_0->frames_0)[_S300]);
    float _S302 = __ldg(&_S301->forward_x_0);
    float _S303 = __ldg(&_S301->forward_y_0);
    float _S304 = __ldg(&_S301->forward_z_0);
    return make_float3 (_S302, _S303, _S304);
}

__device__ float3  camera_origin_0(int _S305)
{
    Frame_0 * _S306 = (&(globalParams_0->frames_0)[_S305]);
    float _S307 = __ldg(&_S306->origin_x_0);
    float _S308 = __ldg(&_S306->origin_y_0);
    float _S309 = __ldg(&_S306->origin_z_0);
    return make_float3 (_S307, _S308, _S309);
}

__device__ VisiblePoint_0 face_point_0(uint _S310, uint _S311, float _S312, float _S313)
{
    Fabric_0 * _S314 = (&(globalParams_0->fabrics_0)[_S310]);
    uint _S315 = 3U * _S311;
    uint _S316 = __ldg((&(globalParams_0->corners_0)[_S315]));
    Vertex_0 _S317 = slang_ldg_1((&(globalParams_0->vertices_0)[_S316]));
    uint _S318 = __ldg((&(globalParams_0->corners_0)[_S315 + 1U]));
    Vertex_0 _S319 = slang_ldg_1((&(globalParams_0->vertices_0)[_S318]));
    uint _S320 = __ldg((&(globalParams_0->corners_0)[_S315 + 2U]));
    Vertex_0 _S321 = slang_ldg_1((&(globalParams_0->vertices_0)[_S320]));
    Vertex_0 _S322 = _S319;
    float3  _S323 = position_of_0(&_S322);
    Vertex_0 _S324 = _S317;
    float3  _S325 = position_of_0(&_S324);
    float3  _S326 = _S323 - _S325;
    Vertex_0 _S327 = _S321;
    float3  _S328 = position_of_0(&_S327);
    float3  _S329 = _S328 - _S325;
    float _S330 = _S319.u_0 - _S317.u_0;
    float _S331 = _S319.v_0 - _S317.v_0;
    float2  _S332 = make_float2 (_S330, _S331);
    float _S333 = _S321.u_0 - _S317.u_0;
    float _S334 = _S321.v_0 - _S317.v_0;
    float2  _S335 = make_float2 (_S333, _S334);
    float _S336;
    if((_S330 * _S334 - _S331 * _S333) < 0.0f)
    {
        _S336 = -1.0f;
    }
    else
    {
        _S336 = 1.0f;
    }
    float3  _S337 = make_float3 (_S336) * (make_float3 (_S334) * _S326 - make_float3 (_S331) * _S329);
    float3  _S338 = make_float3 (_S336) * (make_float3 (_S330) * _S329 - make_float3 (_S333) * _S326);
    VisiblePoint_0 point_1;
    float _S339 = 1.0f - _S312 - _S313;
    Vertex_0 _S340 = _S317;
    float3  _S341 = normal_of_0(&_S340);
    float3  _S342 = make_float3 (_S339) * _S341;
    Vertex_0 _S343 = _S319;
    float3  _S344 = normal_of_0(&_S343);
    float3  _S345 = _S342 + make_float3 (_S312) * _S344;
    Vertex_0 _S346 = _S321;
    float3  _S347 = normal_of_0(&_S346);
    float3  _S348 = normalize_0(_S345 + make_float3 (_S313) * _S347);
    (&point_1)->normal_0 = _S348;
    float3  _S349 = normalize_0(_S337 - _S348 * make_float3 (dot_0(_S348, _S337)));
    (&point_1)->axis_x_0 = _S349;
    (&point_1)->axis_y_0 = cross_0(_S348, _S349);
    float3  _S350 = normalize_0(cross_0(_S326, _S329));
    float3  _S351;
    if((dot_0(_S350, _S348)) < 0.0f)
    {
        _S351 = - _S350;
    }
    else
    {
        _S351 = _S350;
    }
    (&point_1)->face_normal_0 = _S351;
    (&point_1)->position_0 = _S325 + make_float3 (_S312) * _S326 + make_float3 (_S313) * _S329;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_0 = make_float2 (_S317.u_0, _S317.v_0) + make_float2 (_S312) * _S332 + make_float2 (_S313) * _S335;
    bool _S352 = (dot_0(cross_0(_S337, _S338), (&point_1)->normal_0)) < 0.0f;
    float _S353 = __ldg(&_S314->uv_width_0);
    if(_S352)
    {
        float _S354 = __ldg(&_S314->uv_height_0);
        _S336 = - _S354;
    }
    else
    {
        float _S355 = __ldg(&_S314->uv_height_0);
        _S336 = _S355;
    }
    float2  _S356 = make_float2 (_S353, _S336);
    (&point_1)->draft_per_uv_0 = _S356;
    float2  _S357 = (&point_1)->uv_0 * _S356;
    if(_S352)
    {
        float _S358 = __ldg(&_S314->uv_height_0);
        _S336 = _S358;
    }
    else
    {
        _S336 = 0.0f;
    }
    (&point_1)->draft_0 = _S357 + make_float2 (0.0f, _S336);
    float2  _S359 = make_float2 (0.0f);
    (&point_1)->draft_dx_0 = _S359;
    (&point_1)->draft_dy_0 = _S359;
    return point_1;
}

__device__ VisiblePoint_0 visible_point_0(int _S360, uint _S361, uint _S362, uint2  _S363)
{
    Frame_0 * _S364 = (&(globalParams_0->frames_0)[_S360]);
    uint _S365 = 3U * _S362;
    uint _S366 = __ldg((&(globalParams_0->corners_0)[_S365]));
    Vertex_0 _S367 = slang_ldg_1((&(globalParams_0->vertices_0)[_S366]));
    uint _S368 = __ldg((&(globalParams_0->corners_0)[_S365 + 1U]));
    Vertex_0 _S369 = slang_ldg_1((&(globalParams_0->vertices_0)[_S368]));
    uint _S370 = __ldg((&(globalParams_0->corners_0)[_S365 + 2U]));
    Vertex_0 _S371 = slang_ldg_1((&(globalParams_0->vertices_0)[_S370]));
    Vertex_0 _S372 = _S369;
    float3  _S373 = position_of_0(&_S372);
    Vertex_0 _S374 = _S367;
    float3  _S375 = position_of_0(&_S374);
    float3  _S376 = _S373 - _S375;
    Vertex_0 _S377 = _S371;
    float3  _S378 = position_of_0(&_S377);
    float3  _S379 = _S378 - _S375;
    float3  _S380 = cross_0(_S376, _S379);
    float _S381 = 1.0f / (F32_max((square_0(_S380)), (1.00000000317107685e-30f)));
    float3  _S382 = camera_right_0(_S360);
    uint _S383 = __ldg(&_S364->width_0);
    float _S384 = float(_S383);
    float3  _S385 = _S382 * make_float3 (2.0f / _S384);
    float3  _S386 = camera_up_0(_S360);
    uint _S387 = __ldg(&_S364->height_0);
    float _S388 = float(_S387);
    float3  _S389 = _S386 * make_float3 (-2.0f / _S388);
    float _S390 = float(_S363.x) + 0.5f - 0.5f * _S384;
    float _S391 = float(_S363.y) + 0.5f - 0.5f * _S388;
    float3  _S392 = camera_forward_0(_S360);
    float3  _S393 = _S392 + make_float3 (_S390) * _S385 + make_float3 (_S391) * _S389;
    float _S394 = dot_0(_S393, _S380);
    float _S395;
    if((F32_abs((_S394))) > 1.00000000317107685e-30f)
    {
        _S395 = _S394;
    }
    else
    {
        _S395 = 1.00000000317107685e-30f;
    }
    float _S396 = 1.0f / _S395;
    float3  _S397 = camera_origin_0(_S360);
    float3  _S398 = _S375 - _S397;
    float _S399 = dot_0(_S398, _S380) * _S396;
    float3  _S400 = _S393 * make_float3 (_S399) - _S398;
    float3  _S401 = make_float3 (_S399) * (_S385 - _S393 * make_float3 (dot_0(_S385, _S380) * _S396));
    float3  _S402 = make_float3 (_S399) * (_S389 - _S393 * make_float3 (dot_0(_S389, _S380) * _S396));
    float3  _S403 = cross_0(_S379, _S380) * make_float3 (_S381);
    float3  _S404 = cross_0(_S380, _S376) * make_float3 (_S381);
    float2  _S405 = make_float2 (_S369.u_0 - _S367.u_0, _S369.v_0 - _S367.v_0);
    float2  _S406 = make_float2 (_S371.u_0 - _S367.u_0, _S371.v_0 - _S367.v_0);
    VisiblePoint_0 _S407 = face_point_0(_S361, _S362, dot_0(_S400, _S403), dot_0(_S400, _S404));
    VisiblePoint_0 point_2 = _S407;
    (&point_2)->position_0 = _S375 + _S400;
    (&point_2)->view_0 = - normalize_0(_S393);
    (&point_2)->draft_dx_0 = (make_float2 (dot_0(_S401, _S403)) * _S405 + make_float2 (dot_0(_S401, _S404)) * _S406) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (make_float2 (dot_0(_S402, _S403)) * _S405 + make_float2 (dot_0(_S402, _S404)) * _S406) * (&point_2)->draft_per_uv_0;
    return point_2;
}

__device__ uint light_sample_count_0(int _S408)
{
    Frame_0 * _S409 = (&(globalParams_0->frames_0)[_S408]);
    uint _S410 = __ldg(&_S409->lights_0);
    uint _S411 = __ldg(&_S409->environment_samples_0);
    return _S410 + _S411;
}

struct LightSample_0
{
    float3  towards_0;
    float3  irradiance_1;
    float distance_2;
};

__device__ float3  environment_texel_0(int _S412, uint _S413, uint _S414)
{
    Frame_0 * _S415 = (&(globalParams_0->frames_0)[_S412]);
    uint _S416 = __ldg(&_S415->environment_table_0);
    uint _S417 = __ldg(&_S415->environment_rows_0);
    uint _S418 = _S416 + _S417 + 1U;
    uint _S419 = __ldg(&_S415->environment_columns_0);
    uint _S420 = _S418 + _S417 * (_S419 + 1U) + 3U * (_S413 * _S419 + _S414);
    return make_float3 (scene_number_0(_S420), scene_number_0(_S420 + 1U), scene_number_0(_S420 + 2U));
}

__device__ float3  sample_environment_0(int _S421, float2  _S422, float3  * _S423)
{
    Frame_0 * _S424 = (&(globalParams_0->frames_0)[_S421]);
    uint _S425 = __ldg(&_S424->environment_table_0);
    uint _S426 = __ldg(&_S424->environment_rows_0);
    Choice_0 _S427 = choose_0(_S425, _S426, _S422.y);
    uint _S428 = _S425 + _S426 + 1U;
    uint _S429 = __ldg(&_S424->environment_columns_0);
    Choice_0 _S430 = choose_0(_S428 + _S427.index_2 * (_S429 + 1U), _S429, _S422.x);
    float3  _S431 = environment_texel_0(_S421, _S427.index_2, _S430.index_2);
    float _S432 = __ldg(&_S424->environment_total_0);
    *_S423 = _S431 * make_float3 (_S432 / (F32_max((mean_0(_S431)), (9.99999968265522539e-21f))));
    float _S433 = 3.14159274101257324f / float(_S426);
    float _S434 = lerp_0(sine_cosine_0(float(_S427.index_2) * _S433).y, sine_cosine_0(float(_S427.index_2 + 1U) * _S433).y, _S427.remainder_0);
    float _S435 = (F32_sqrt(((F32_max((1.0f - _S434 * _S434), (0.0f))))));
    float2  _S436 = sine_cosine_0((float(_S430.index_2) + _S430.remainder_0) * (6.28318548202514648f / float(_S429)));
    float _S437 = _S435 * _S436.x;
    float _S438 = - _S435 * _S436.y;
    float _S439 = __ldg(&_S424->environment_cosine_0);
    float _S440 = _S439 * _S437;
    float _S441 = __ldg(&_S424->environment_sine_0);
    return make_float3 (_S440 + _S441 * _S438, _S434, _S439 * _S438 - _S441 * _S437);
}

__device__ LightSample_0 light_sample_0(int _S442, uint _S443, uint2  _S444, float3  _S445)
{
    Frame_0 * _S446 = (&(globalParams_0->frames_0)[_S442]);
    LightSample_0 sample_0;
    (&sample_0)->distance_2 = 1.00000001504746622e+30f;
    uint _S447 = __ldg(&_S446->lights_0);
    if(_S443 >= _S447)
    {
        uint _S448 = __ldg(&_S446->pass_number_0);
        uint _S449 = __ldg(&_S446->environment_samples_0);
        float3  weight_0;
        float3  _S450 = sample_environment_0(_S442, pixel_sequence_0(_S444, _S448 * _S449 + (_S443 - _S447), 3U), &weight_0);
        (&sample_0)->towards_0 = _S450;
        (&sample_0)->irradiance_1 = weight_0 / make_float3 (float(_S449));
        return sample_0;
    }
    Light_0 _S451 = slang_ldg_2((&(globalParams_0->lights_1)[_S443]));
    (&sample_0)->irradiance_1 = make_float3 (_S451.red_0, _S451.green_0, _S451.blue_0);
    (&sample_0)->towards_0 = make_float3 (_S451.x_0, _S451.y_0, _S451.z_0);
    if((_S451.is_point_0) != 0U)
    {
        float3  _S452 = (&sample_0)->towards_0 - _S445;
        float _S453 = (F32_max((square_0(_S452)), (9.999999960041972e-13f)));
        (&sample_0)->distance_2 = (F32_sqrt((_S453)));
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / make_float3 (_S453);
        (&sample_0)->towards_0 = normalize_0(_S452);
    }
    return sample_0;
}

__device__ float3  seen_position_0(int _S454, uint _S455, uint2  _S456)
{
    Frame_0 * _S457 = (&(globalParams_0->frames_0)[_S454]);
    uint _S458 = 3U * _S455;
    uint _S459 = __ldg((&(globalParams_0->corners_0)[_S458]));
    Vertex_0 _S460 = slang_ldg_1((&(globalParams_0->vertices_0)[_S459]));
    Vertex_0 _S461 = _S460;
    float3  _S462 = position_of_0(&_S461);
    uint _S463 = __ldg((&(globalParams_0->corners_0)[_S458 + 1U]));
    Vertex_0 _S464 = slang_ldg_1((&(globalParams_0->vertices_0)[_S463]));
    Vertex_0 _S465 = _S464;
    float3  _S466 = position_of_0(&_S465);
    float3  _S467 = _S466 - _S462;
    uint _S468 = __ldg((&(globalParams_0->corners_0)[_S458 + 2U]));
    Vertex_0 _S469 = slang_ldg_1((&(globalParams_0->vertices_0)[_S468]));
    Vertex_0 _S470 = _S469;
    float3  _S471 = position_of_0(&_S470);
    float3  _S472 = _S471 - _S462;
    float3  _S473 = cross_0(_S467, _S472);
    float _S474 = 1.0f / (F32_max((square_0(_S473)), (1.00000000317107685e-30f)));
    float _S475 = float(_S456.x) + 0.5f;
    float _S476 = __ldg(&_S457->jitter_x_0);
    float _S477 = _S475 + _S476;
    uint _S478 = __ldg(&_S457->width_0);
    float _S479 = float(_S478);
    float _S480 = _S477 - 0.5f * _S479;
    float _S481 = float(_S456.y) + 0.5f;
    float _S482 = __ldg(&_S457->jitter_y_0);
    float _S483 = _S481 + _S482;
    uint _S484 = __ldg(&_S457->height_0);
    float _S485 = float(_S484);
    float _S486 = _S483 - 0.5f * _S485;
    float3  _S487 = camera_forward_0(_S454);
    float3  _S488 = camera_right_0(_S454);
    float3  _S489 = _S487 + _S488 * make_float3 (2.0f * _S480 / _S479);
    float3  _S490 = camera_up_0(_S454);
    float3  _S491 = _S489 - _S490 * make_float3 (2.0f * _S486 / _S485);
    float _S492 = dot_0(_S491, _S473);
    float3  _S493 = camera_origin_0(_S454);
    float3  _S494 = _S462 - _S493;
    float _S495 = dot_0(_S494, _S473);
    float _S496;
    if((F32_abs((_S492))) > 1.00000000317107685e-30f)
    {
        _S496 = _S492;
    }
    else
    {
        _S496 = 1.00000000317107685e-30f;
    }
    float3  _S497 = _S491 * make_float3 (_S495 / _S496) - _S494;
    float _S498 = clamp_0(dot_0(_S497, cross_0(_S472, _S473)) * _S474, 0.0f, 1.0f);
    return _S462 + make_float3 (_S498) * _S467 + make_float3 (clamp_0(dot_0(_S497, cross_0(_S473, _S467)) * _S474, 0.0f, 1.0f - _S498)) * _S472;
}

__device__ Hit_0 nearest_hit_0(int _S499, float3  _S500, float3  _S501, float _S502, float _S503, uint _S504, bool _S505)
{
    Frame_0 * _S506 = (&(globalParams_0->frames_0)[_S499]);
    float3  _S507 = make_float3 (inverse_of_0(_S501.x), inverse_of_0(_S501.y), inverse_of_0(_S501.z));
    Hit_0 found_0;
    (&found_0)->face_1 = 4294967295U;
    (&found_0)->distance_0 = _S503;
    (&found_0)->weight_b_0 = 0.0f;
    (&found_0)->weight_c_0 = 0.0f;
    uint node_2 = 1U;
    for(;;)
    {
        if(node_2 != 0U)
        {
        }
        else
        {
            break;
        }
        uint node_3;
        if(!meets_node_0(node_2, _S500, _S507, _S502, (&found_0)->distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            uint _S508 = __ldg(&_S506->leaves_0);
            if(node_2 < _S508)
            {
                node_3 = node_2 * 2U;
            }
            else
            {
                uint _S509 = __ldg(&_S506->leaf_faces_0);
                uint _S510 = _S509 + 4U * (node_2 - _S508);
                uint _S511 = following_node_0(node_2);
                uint number_1 = 0U;
                node_3 = _S511;
                for(;;)
                {
                    if(number_1 < 4U)
                    {
                    }
                    else
                    {
                        break;
                    }
                    uint _S512 = __ldg((&(globalParams_0->scene_words_0)[_S510 + number_1]));
                    bool _S513;
                    if(_S512 == 4294967295U)
                    {
                        _S513 = true;
                    }
                    else
                    {
                        _S513 = _S512 == _S504;
                    }
                    if(_S513)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    Hit_0 _S514 = meet_face_0(_S512, _S500, _S501);
                    bool _S515;
                    if((_S514.face_1) == 4294967295U)
                    {
                        _S515 = true;
                    }
                    else
                    {
                        _S515 = (_S514.distance_0) <= _S502;
                    }
                    bool _S516;
                    if(_S515)
                    {
                        _S516 = true;
                    }
                    else
                    {
                        _S516 = (_S514.distance_0) >= ((&found_0)->distance_0);
                    }
                    if(_S516)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    found_0 = _S514;
                    bool _S517;
                    if(_S505)
                    {
                        uint _S518 = __ldg((&(globalParams_0->face_fabrics_0)[_S512]));
                        uint _S519 = __ldg(&(&(globalParams_0->fabrics_0)[_S518])->is_open_0);
                        _S517 = _S519 == 0U;
                    }
                    else
                    {
                        _S517 = false;
                    }
                    uint node_4;
                    if(_S517)
                    {
                        node_4 = 0U;
                    }
                    else
                    {
                        node_4 = node_3;
                    }
                    node_3 = node_4;
                    number_1 = number_1 + 1U;
                }
            }
        }
        node_2 = node_3;
    }
    return found_0;
}

struct Regime_0
{
    float prefiltered_0;
    float threads_0;
    float points_1;
};

__device__ Regime_0 regime_of_0(uint _S520, Footprint_0 * _S521, float _S522)
{
    Fabric_0 * _S523 = (&(globalParams_0->fabrics_0)[_S520]);
    float _S524 = Footprint_spread_side_0(_S521);
    float _S525 = binary_logarithm_0((F32_max((_S524), (9.99999971718068537e-10f))));
    Lobes_0 _S526 = slang_ldg_0(&_S523->lobes_0);
    float _S527 = clamp_0((_S525 - _S526.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S528 = _S527 * _S527 * (3.0f - 2.0f * _S527);
    (&regime_0)->prefiltered_0 = _S528;
    (&regime_0)->threads_0 = _S524 * _S526.threads_per_mm_0;
    float _S529 = lerp_0((F32_max((8.0f / _S522), (1.0f))), 1.0f, _S528);
    float _S530;
    if(_S528 < 1.0f)
    {
        _S530 = clamp_0((&regime_0)->threads_0 * 12.0f, 1.0f, _S529);
    }
    else
    {
        _S530 = 0.0f;
    }
    (&regime_0)->points_1 = _S530;
    return regime_0;
}

struct Hit_1
{
    float x_23;
    float y_13;
    bool hole_2;
    float height_3;
};

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_4;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

__device__ Crossing_0 crossing_at_0(uint _S531, float _S532, float _S533, bool _S534)
{
    Fabric_0 * _S535 = (&(globalParams_0->fabrics_0)[_S531]);
    Crossing_0 crossing_2;
    uint _S536 = __ldg(&_S535->warp_0);
    (&crossing_2)->warp_1 = locate_0(_S536, _S532);
    uint _S537 = __ldg(&_S535->weft_0);
    (&crossing_2)->weft_1 = locate_0(_S537, _S533);
    uint _S538 = __ldg(&_S535->run_words_0);
    uint _S539 = (&(&crossing_2)->weft_1)->thread_1;
    uint _S540 = __ldg(&_S535->ends_1);
    uint _S541 = _S538 + 2U * (_S539 * _S540 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S542 = __ldg((&(globalParams_0->words_0)[_S541]));
    (&crossing_2)->warp_word_0 = _S542;
    uint _S543 = __ldg((&(globalParams_0->words_0)[_S541 + 1U]));
    (&crossing_2)->weft_word_0 = _S543;
    (&crossing_2)->warp_above_0 = ((_S542 & 1U) == 1U) != _S534;
    return crossing_2;
}

__device__ Sample_0 sample_at_0(uint _S544, float _S545, float _S546, bool _S547)
{
    Fabric_0 * _S548 = (&(globalParams_0->fabrics_0)[_S544]);
    Sample_0 sample_1;
    Crossing_0 _S549 = crossing_at_0(_S544, _S545, _S546, _S547);
    (&sample_1)->crossing_1 = _S549;
    Crossing_0 _S550 = _S549;
    Shown_0 _S551 = shown_at_0(&_S550, _S547);
    (&sample_1)->shown_3 = _S551;
    uint _S552;
    if(_S551.is_warp_0)
    {
        uint _S553 = __ldg(&_S548->warp_0);
        _S552 = _S553;
    }
    else
    {
        uint _S554 = __ldg(&_S548->weft_0);
        _S552 = _S554;
    }
    uint _S555;
    if(_S551.is_warp_0)
    {
        uint _S556 = __ldg(&_S548->weft_0);
        _S555 = _S556;
    }
    else
    {
        uint _S557 = __ldg(&_S548->warp_0);
        _S555 = _S557;
    }
    Cell_0 _S558 = (&(&sample_1)->crossing_1)->warp_1;
    Cell_0 _S559 = (&(&sample_1)->crossing_1)->weft_1;
    Cell_0 _S560 = select_cell_0(_S551.is_warp_0, &_S558, &_S559);
    Cell_0 _S561 = (&(&sample_1)->crossing_1)->weft_1;
    Cell_0 _S562 = (&(&sample_1)->crossing_1)->warp_1;
    Cell_0 _S563 = select_cell_0(_S551.is_warp_0, &_S561, &_S562);
    Cell_0 _S564 = _S563;
    Run_0 _S565 = unpack_0(_S552, _S555, _S560.thread_1, &_S564, _S551.word_0);
    Cell_0 _S566 = _S560;
    Section_0 _S567 = section_at_0(&_S566);
    bool _S568;
    if(_S551.on_top_0)
    {
        _S568 = (_S565.distance_1) < (_S567.drop_0 * _S565.bend_1.sine_0);
    }
    else
    {
        _S568 = false;
    }
    bool _S569;
    if(_S551.on_top_0)
    {
        _S569 = !_S568;
    }
    else
    {
        _S569 = false;
    }
    float _S570;
    if(_S569)
    {
        _S570 = 1.0f;
    }
    else
    {
        _S570 = -1.0f;
    }
    float _S571;
    if(_S568)
    {
        _S571 = _S565.other_reach_0;
    }
    else
    {
        _S571 = _S565.reach_0;
    }
    float _S572;
    if(_S568)
    {
        _S572 = _S571 + _S565.distance_1;
    }
    else
    {
        _S572 = (F32_max((_S571 - _S565.distance_1), (0.0f)));
    }
    float _S573 = _S571 / _S565.bend_1.sine_0 - _S570 * _S567.drop_0;
    float _S574 = _S572 * _S572;
    float _S575 = (F32_max((_S573 * _S573 - _S574), (9.99999968265522539e-21f)));
    float _S576 = (F32_rsqrt((_S575)));
    float _S577 = _S574 / (_S575 * _S576 + _S573);
    bool _S578 = _S572 > 0.0f;
    float _S579;
    if(_S551.on_top_0)
    {
        _S579 = 1.0f;
    }
    else
    {
        _S579 = -1.0f;
    }
    float _S580;
    if(_S565.near_start_0)
    {
        _S580 = 1.0f;
    }
    else
    {
        _S580 = -1.0f;
    }
    float _S581 = _S579 * _S580;
    if(_S578)
    {
        _S579 = _S573 * _S576;
    }
    else
    {
        _S579 = 1.0f;
    }
    (&sample_1)->slope_across_0 = _S567.slope_0 * _S579;
    if(_S578)
    {
        _S572 = _S581 * _S572 * _S576;
    }
    else
    {
        _S572 = 0.0f;
    }
    (&sample_1)->slope_along_0 = _S572;
    Family_0 _S582 = slang_ldg_3((&(globalParams_0->families_0)[_S552]));
    Shown_0 _S583 = _S551;
    Run_0 _S584 = _S565;
    Cell_0 _S585 = _S563;
    float2  _S586 = dive_0(_S555, &_S583, &_S584, &_S585);
    if(_S565.straight_0)
    {
        _S570 = 0.0f;
    }
    else
    {
        _S570 = _S582.height_scale_0 * _S570;
    }
    (&sample_1)->height_4 = _S570 * (_S571 * _S565.bend_1.half_tangent_0 - _S577) - _S582.height_scale_0 * _S567.drop_0 - _S586.x;
    float _S587 = _S582.height_scale_0 * (&sample_1)->slope_across_0;
    float _S588 = _S582.height_scale_0 * (&sample_1)->slope_along_0 - _S586.y;
    if(_S551.is_warp_0)
    {
        _S570 = _S587;
    }
    else
    {
        _S570 = _S588;
    }
    (&sample_1)->slope_x_1 = _S570;
    if(_S551.is_warp_0)
    {
        _S570 = _S588;
    }
    else
    {
        _S570 = _S587;
    }
    (&sample_1)->slope_y_1 = _S570;
    (&sample_1)->run_3 = _S565;
    (&sample_1)->section_1 = _S567;
    return sample_1;
}

__device__ float steps_per_length_0(uint _S589, SearchQuality_0 * _S590, float3  _S591)
{
    Fabric_0 * _S592 = (&(globalParams_0->fabrics_0)[_S589]);
    float _S593 = (F32_abs((_S591.x)));
    float _S594 = __ldg(&_S592->threads_per_x_0);
    float _S595 = _S593 * _S594;
    float _S596 = (F32_abs((_S591.y)));
    float _S597 = __ldg(&_S592->threads_per_y_0);
    float _S598 = (F32_max((_S595), (_S596 * _S597))) * _S590->steps_per_thread_0;
    float _S599 = (F32_abs((_S591.z)));
    float _S600 = __ldg(&_S592->per_relief_0);
    return (F32_max((_S598), (_S599 * _S600 * _S590->steps_per_relief_0)));
}

__device__ float cell_maximum_0(uint _S601, Crossing_0 * _S602)
{
    Fabric_0 * _S603 = (&(globalParams_0->fabrics_0)[_S601]);
    bool _S604 = _S602->warp_above_0;
    uint _S605;
    if(_S602->warp_above_0)
    {
        uint _S606 = __ldg(&_S603->warp_0);
        _S605 = _S606;
    }
    else
    {
        uint _S607 = __ldg(&_S603->weft_0);
        _S605 = _S607;
    }
    uint _S608;
    if(_S604)
    {
        _S608 = _S602->warp_word_0;
    }
    else
    {
        _S608 = _S602->weft_word_0;
    }
    float _S609 = float(_S608 >> int(28));
    Family_0 _S610 = slang_ldg_3((&(globalParams_0->families_0)[_S605]));
    float _S611 = _S609 * _S610.height_scale_0;
    Family_0 _S612 = slang_ldg_3((&(globalParams_0->families_0)[_S605]));
    return _S611 * _S612.level_0;
}

__device__ Probe_0 probe_0(uint _S613, float _S614, float _S615, bool _S616, bool _S617, bool _S618)
{
    Sample_0 _S619 = sample_at_0(_S613, _S614, _S615, _S616);
    Probe_0 probe_1;
    (&probe_1)->height_1 = _S619.height_4;
    (&probe_1)->hole_1 = _S619.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S619.slope_x_1;
    (&probe_1)->slope_y_0 = _S619.slope_y_1;
    uint _S620;
    if(_S619.shown_3.is_warp_0)
    {
        _S620 = _S619.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S620 = _S619.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S620;
    Crossing_0 _S621 = _S619.crossing_1;
    float _S622 = cell_maximum_0(_S613, &_S621);
    (&probe_1)->cell_max_0 = _S622;
    float _S623;
    if(_S617)
    {
        _S623 = _S619.crossing_1.warp_1.above_0;
    }
    else
    {
        _S623 = _S619.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S623;
    if(_S618)
    {
        _S623 = _S619.crossing_1.weft_1.above_0;
    }
    else
    {
        _S623 = _S619.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S623;
    bool _S624 = !_S619.shown_3.is_warp_0;
    Cell_0 _S625 = _S619.crossing_1.warp_1;
    Shown_0 _S626 = _S619.shown_3;
    Run_0 _S627 = _S619.run_3;
    float _S628 = outline_distance_0(&_S625, &_S626, &_S627, _S624, _S617);
    (&probe_1)->edge_x_0 = _S628;
    Cell_0 _S629 = _S619.crossing_1.weft_1;
    Shown_0 _S630 = _S619.shown_3;
    Run_0 _S631 = _S619.run_3;
    float _S632 = outline_distance_0(&_S629, &_S630, &_S631, _S619.shown_3.is_warp_0, _S618);
    (&probe_1)->edge_y_0 = _S632;
    return probe_1;
}

__device__ bool is_free_0(uint _S633, SearchQuality_0 * _S634, float3  _S635, float3  _S636, bool _S637, float _S638)
{
    float _S639 = _S636.z;
    if(_S639 <= 0.0f)
    {
        return false;
    }
    float _S640 = _S634->shadow_share_0;
    float _S641 = steps_per_length_0(_S633, _S634, _S636);
    float _S642 = 1.0f / (F32_max((_S640 * _S641), (9.99999971718068537e-10f)));
    StepControl_0 _S643 = step_control_0(float2 {_S636.x, _S636.y}, _S642);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_3 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S644;
        if(count_3 < 1024U)
        {
            _S644 = (_S635.z + _S639 * distance_3) < _S638;
        }
        else
        {
            _S644 = false;
        }
        if(_S644)
        {
        }
        else
        {
            break;
        }
        float3  _S645 = _S635 + _S636 * make_float3 (distance_3);
        Probe_0 _S646 = probe_0(_S633, _S645.x, _S645.y, _S637, _S643.right_1, _S643.up_0);
        float _S647 = _S645.z;
        float _S648 = _S647 - _S646.height_1;
        float _S649 = _S639 - _S646.slope_x_0 * _S636.x - _S646.slope_y_0 * _S636.y;
        bool _S650;
        if(!_S646.hole_1)
        {
            _S650 = _S648 < 0.0f;
        }
        else
        {
            _S650 = false;
        }
        if(_S650)
        {
            return false;
        }
        PreviousSample_0 _S651 = previous_3;
        Probe_0 _S652 = _S646;
        float _S653 = way_back_to_dip_0(&_S651, _S648, _S649, last_step_0, &_S652);
        if(_S653 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S653;
            distance_3 = distance_3 - _S653;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S654 = _S647 > (_S646.cell_max_0);
        Probe_0 _S655 = _S646;
        PreviousSample_0 _S656 = after_sample_0(_S648, _S649, &_S655, _S654);
        float last_step_2;
        if(_S654)
        {
            StepControl_0 _S657 = _S643;
            float _S658 = StepControl_to_cell_exit_0(&_S657, _S646.side_x_0, _S646.side_y_0);
            last_step_2 = (F32_max((_S658), (_S642)));
        }
        else
        {
            StepControl_0 _S659 = _S643;
            Probe_0 _S660 = _S646;
            float _S661 = StepControl_to_next_sample_0(&_S659, &_S660, _S648, _S649);
            last_step_2 = _S661;
        }
        float distance_4 = distance_3 + last_step_2;
        previous_3 = _S656;
        distance_3 = distance_4;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

__device__ bool passes_through_0(uint _S662, SearchQuality_0 * _S663, float _S664, float _S665, float3  _S666, bool _S667)
{
    Fabric_0 * _S668 = (&(globalParams_0->fabrics_0)[_S662]);
    Sample_0 _S669 = sample_at_0(_S662, _S664, _S665, _S667);
    if(!_S669.shown_3.hole_0)
    {
        return false;
    }
    float3  _S670 = make_float3 (_S664, _S665, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S671;
        if(side_0 < 2U)
        {
            _S671 = passes_0;
        }
        else
        {
            _S671 = false;
        }
        if(_S671)
        {
        }
        else
        {
            break;
        }
        float3  _S672;
        if(side_0 == 0U)
        {
            _S672 = _S666;
        }
        else
        {
            _S672 = make_float3 (- _S666.x, - _S666.y, _S666.z);
        }
        bool _S673 = _S667 != (side_0 == 1U);
        float _S674 = __ldg(&_S668->height_high_0);
        bool _S675 = is_free_0(_S662, _S663, _S670, _S672, _S673, _S674);
        uint _S676 = side_0 + 1U;
        passes_0 = _S675;
        side_0 = _S676;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
    float height_5;
    float last_step_3;
    float depth_0;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_4;
};

__device__ float max_height_along_0(uint _S677, float _S678, float _S679, float _S680, float3  _S681, bool _S682)
{
    Fabric_0 * _S683 = (&(globalParams_0->fabrics_0)[_S677]);
    uint _S684 = __ldg(&_S683->warp_0);
    uint _S685 = locate_0(_S684, _S678).thread_1 / 2U;
    uint _S686 = __ldg(&_S683->weft_0);
    uint _S687 = locate_0(_S686, _S679).thread_1 / 2U;
    float _S688 = _S681.x;
    uint _S689;
    if(_S688 > 0.0f)
    {
        _S689 = 1U;
    }
    else
    {
        _S689 = 0U;
    }
    float _S690 = _S681.y;
    uint _S691;
    if(_S690 > 0.0f)
    {
        _S691 = 2U;
    }
    else
    {
        _S691 = 0U;
    }
    uint _S692 = _S689 + _S691;
    uint _S693 = __ldg(&_S683->max_heights_0);
    uint _S694 = __ldg(&_S683->max_height_columns_0);
    uint _S695 = __ldg((&(globalParams_0->words_0)[_S693 + 4U * (_S687 * _S694 + _S685) + _S692]));
    int number_2;
    if(_S682)
    {
        number_2 = int(4);
    }
    else
    {
        number_2 = int(0);
    }
    uint _S696 = _S695 >> number_2;
    float _S697 = (F32_abs((_S688)));
    float _S698 = __ldg(&_S683->threads_per_x_0);
    float _S699 = _S697 * _S698;
    float _S700 = (F32_abs((_S690)));
    float _S701 = __ldg(&_S683->threads_per_y_0);
    float _S702 = (F32_max((_S699), (_S700 * _S701))) / _S681.z;
    float _S703 = __ldg(&_S683->height_high_0);
    float max_height_0 = _S703;
    number_2 = int(3);
    for(;;)
    {
        if(number_2 >= int(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S680) * _S702) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = (F32_min((max_height_0), (float((_S696 >> uint(int(8) * number_2)) & 15U) * 0.06666667014360428f * _S703)));
        }
        number_2 = number_2 - int(1);
    }
    return max_height_0;
}

__device__ float3  cell_bounds_0(uint _S704, float _S705, float _S706, bool _S707, bool _S708, bool _S709)
{
    Crossing_0 _S710 = crossing_at_0(_S704, _S705, _S706, _S707);
    Crossing_0 _S711 = _S710;
    float _S712 = cell_maximum_0(_S704, &_S711);
    float _S713;
    if(_S708)
    {
        _S713 = _S710.warp_1.above_0;
    }
    else
    {
        _S713 = _S710.warp_1.below_0;
    }
    float _S714;
    if(_S709)
    {
        _S714 = _S710.weft_1.above_0;
    }
    else
    {
        _S714 = _S710.weft_1.below_0;
    }
    return make_float3 (_S712, _S713, _S714);
}

__device__ float first_sample_height_0(uint _S715, ViewRay_0 * _S716, StepControl_0 * _S717, bool _S718)
{
    float _S719 = max_height_along_0(_S715, _S716->origin_2.x, _S716->origin_2.y, 0.0f, make_float3 (_S716->slope_1.x, _S716->slope_1.y, 1.0f), _S718);
    uint count_4 = 0U;
    float height_6 = _S719;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S720 = ViewRay_at_0(_S716, height_6);
        float3  _S721 = cell_bounds_0(_S715, _S720.x, _S720.y, _S718, _S717->right_1, _S717->up_0);
        float _S722 = height_6 - _S721.x;
        float _S723 = StepControl_to_cell_exit_0(_S717, _S721.y, _S721.z);
        float height_7 = height_6 - clamp_0(_S722, 0.0f, _S723);
        if(_S722 <= _S723)
        {
            height_6 = height_7;
            break;
        }
        count_4 = count_4 + 1U;
        height_6 = height_7;
    }
    return height_6;
}

__device__ ViewRayEnd_0 search_down_0(uint _S724, ViewRay_0 * _S725, StepControl_0 * _S726, bool _S727)
{
    Fabric_0 * _S728 = (&(globalParams_0->fabrics_0)[_S724]);
    float _S729 = __ldg(&_S728->height_low_0);
    float _S730 = __ldg(&_S728->height_high_0);
    float _S731 = _S729 - (_S730 - _S729);
    ViewRayEnd_0 end_1;
    float _S732 = first_sample_height_0(_S724, _S725, _S726, _S727);
    (&end_1)->height_5 = _S732;
    (&end_1)->last_step_3 = _S726->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_0 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
    uint count_5 = 0U;
    for(;;)
    {
        if(count_5 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2  _S733 = ViewRay_at_0(_S725, (&end_1)->height_5);
        Probe_0 _S734 = probe_0(_S724, _S733.x, _S733.y, _S727, _S726->right_1, _S726->up_0);
        float _S735 = (&end_1)->height_5 - _S734.height_1;
        Probe_0 _S736 = _S734;
        float _S737 = ViewRay_rate_0(_S725, &_S736);
        (&end_1)->depth_0 = - _S735;
        (&end_1)->rate_4 = _S737;
        bool _S738;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S738 = !_S734.hole_1;
        }
        else
        {
            _S738 = false;
        }
        bool _S739;
        if(_S738)
        {
            _S739 = ((&(&end_1)->previous_4)->yarn_0) == (_S734.yarn_1);
        }
        else
        {
            _S739 = false;
        }
        (&end_1)->smooth_0 = _S739;
        bool _S740;
        if(!_S734.hole_1)
        {
            _S740 = _S735 <= 0.0f;
        }
        else
        {
            _S740 = false;
        }
        bool _S741;
        if(_S740)
        {
            _S741 = true;
        }
        else
        {
            _S741 = ((&end_1)->height_5) <= _S731;
        }
        if(_S741)
        {
            break;
        }
        PreviousSample_0 _S742 = (&end_1)->previous_4;
        Probe_0 _S743 = _S734;
        float _S744 = way_back_to_dip_0(&_S742, _S735, _S737, (&end_1)->last_step_3, &_S743);
        if(_S744 >= 0.0f)
        {
            (&end_1)->height_5 = (&end_1)->height_5 + _S744;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S744;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S745 = StepControl_to_cell_exit_0(_S726, _S734.side_x_0, _S734.side_y_0);
        float _S746 = (F32_min((_S745), ((&end_1)->height_5 - _S734.cell_max_0)));
        Probe_0 _S747 = _S734;
        float _S748 = StepControl_to_next_sample_0(_S726, &_S747, _S735, _S737);
        bool _S749 = _S746 > _S748;
        Probe_0 _S750 = _S734;
        PreviousSample_0 _S751 = after_sample_0(_S735, _S737, &_S750, _S749);
        (&end_1)->previous_4 = _S751;
        float _S752 = (F32_max((_S746), (_S748)));
        (&end_1)->last_step_3 = _S752;
        (&end_1)->height_5 = (&end_1)->height_5 - _S752;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

__device__ float refined_height_0(uint _S753, ViewRay_0 * _S754, StepControl_0 * _S755, bool _S756, ViewRayEnd_0 * _S757, uint _S758)
{
    Fabric_0 * _S759 = (&(globalParams_0->fabrics_0)[_S753]);
    float _S760 = __ldg(&_S759->height_high_0);
    float _S761 = __ldg(&_S759->height_low_0);
    float _S762 = _S760 - _S761;
    float _S763 = _S757->height_5;
    float _S764 = _S757->last_step_3;
    float above_2 = _S757->height_5 + _S757->last_step_3;
    float above_gap_1 = clamp_0((&_S757->previous_4)->clearance_0, 0.0f, _S762);
    float under_gap_1 = clamp_0(_S757->depth_0, 0.0f, _S762);
    float _S765 = cubic_root_0(above_gap_1, - under_gap_1, (&_S757->previous_4)->rate_0 * _S757->last_step_3, _S757->rate_4 * _S757->last_step_3);
    bool _S766 = _S757->smooth_0;
    float middle_0;
    if(_S757->smooth_0)
    {
        middle_0 = above_2 - _S765 * _S764;
    }
    else
    {
        middle_0 = between_0(above_2, _S763, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S763;
    float above_3 = above_2;
    uint i_6 = 0U;
    for(;;)
    {
        if(i_6 < _S758)
        {
        }
        else
        {
            break;
        }
        float2  _S767 = ViewRay_at_0(_S754, middle_0);
        Probe_0 _S768 = probe_0(_S753, _S767.x, _S767.y, _S756, _S755->right_1, _S755->up_0);
        float _S769;
        if(_S768.hole_1)
        {
            _S769 = -1.0e+09f;
        }
        else
        {
            _S769 = _S768.height_1;
        }
        float _S770 = clamp_0(middle_0 - _S769, - _S762, _S762);
        float _S771;
        if(_S770 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S771 = 0.5f * above_gap_2;
            }
            else
            {
                _S771 = above_gap_2;
            }
            float _S772 = - _S770;
            under_1 = middle_0;
            above_gap_2 = _S771;
            under_gap_2 = _S772;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S771 = 0.5f * under_gap_2;
            }
            else
            {
                _S771 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S770;
            under_gap_2 = _S771;
            side_1 = -1.0f;
        }
        if(_S766)
        {
            Probe_0 _S773 = _S768;
            float _S774 = ViewRay_rate_0(_S754, &_S773);
            middle_0 = clamp_0(middle_0 + _S770 / (F32_min((_S774), (-9.99999997475242708e-07f))), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_6 = i_6 + 1U;
    }
    if(_S766)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

__device__ Hit_1 first_hit_of_yarn_0(uint _S775, SearchQuality_0 * _S776, float _S777, float _S778, float3  _S779, bool _S780)
{
    float _S781 = (F32_max((_S779.z), (0.00009999999747379f)));
    ViewRay_0 ray_0;
    (&ray_0)->origin_2 = make_float2 (_S777, _S778);
    float2  _S782 = float2 {_S779.x, _S779.y} / make_float2 (_S781);
    (&ray_0)->slope_1 = _S782;
    float2  _S783 = - _S782;
    float _S784 = steps_per_length_0(_S775, _S776, _S779);
    StepControl_0 _S785 = step_control_0(_S783, 1.0f / (F32_max((_S784 / _S781), (9.99999971718068537e-10f))));
    ViewRay_0 _S786 = ray_0;
    StepControl_0 _S787 = _S785;
    ViewRayEnd_0 _S788 = search_down_0(_S775, &_S786, &_S787, _S780);
    Hit_1 hit_1;
    (&hit_1)->hole_2 = false;
    ViewRay_0 _S789 = ray_0;
    StepControl_0 _S790 = _S785;
    ViewRayEnd_0 _S791 = _S788;
    float _S792 = refined_height_0(_S775, &_S789, &_S790, _S780, &_S791, _S776->refinements_0);
    (&hit_1)->height_3 = _S792;
    ViewRay_0 _S793 = ray_0;
    float2  _S794 = ViewRay_at_0(&_S793, _S792);
    (&hit_1)->x_23 = _S794.x;
    (&hit_1)->y_13 = _S794.y;
    return hit_1;
}

__device__ Hit_1 first_hit_0(uint _S795, SearchQuality_0 * _S796, float _S797, float _S798, float3  _S799, bool _S800)
{
    bool _S801 = passes_through_0(_S795, _S796, _S797, _S798, _S799, _S800);
    if(!_S801)
    {
        Hit_1 _S802 = first_hit_of_yarn_0(_S795, _S796, _S797, _S798, _S799, _S800);
        return _S802;
    }
    Hit_1 hit_2;
    (&hit_2)->x_23 = _S797;
    (&hit_2)->y_13 = _S798;
    (&hit_2)->height_3 = 0.0f;
    (&hit_2)->hole_2 = true;
    return hit_2;
}

struct CoverageTaps_0
{
    FixedArray<uint, 9>  nodes_1;
};

__device__ float3  pyramid_level_0(uint _S803, float _S804)
{
    Lobes_0 _S805 = slang_ldg_0(&(&(globalParams_0->fabrics_0)[_S803])->lobes_0);
    uint _S806 = _S805.levels_0 + 4U * uint((F32_min((_S804), (_S805.last_level_0))));
    return make_float3 (table_number_0(_S806), table_number_0(_S806 + 1U), table_number_0(_S806 + 2U));
}

__device__ CoverageTaps_0 coverage_taps_0(uint _S807, Footprint_0 * _S808, bool _S809)
{
    Fabric_0 * _S810 = (&(globalParams_0->fabrics_0)[_S807]);
    float _S811 = Footprint_spread_side_0(_S808);
    Lobes_0 _S812 = slang_ldg_0(&_S810->lobes_0);
    float _S813 = _S811 * _S812.inverse_base_size_0;
    float3  _S814 = pyramid_level_0(_S807, (F32_floor((binary_logarithm_0((F32_max((0.68000000715255737f * _S813), (1.0f))))))));
    float _S815 = 1.0f / (F32_max((_S813), (9.99999997475242708e-07f)));
    float _S816 = (F32_min(((F32_max(((F32_sqrt((clamp_0(1.29999995231628418f * (1.0f - _S815 * _S815), 0.0f, 1.0f))))), (0.3333333432674408f * _S815)))), (1.0f)));
    uint _S817 = __ldg(&_S810->warp_0);
    Family_0 _S818 = slang_ldg_3((&(globalParams_0->families_0)[_S817]));
    uint _S819 = __ldg(&_S810->weft_0);
    Family_0 _S820 = slang_ldg_3((&(globalParams_0->families_0)[_S819]));
    float2  _S821 = make_float2 (_S818.inverse_period_0, _S820.inverse_period_0);
    float2  _S822 = _S808->centre_0 * _S821;
    float2  _S823 = _S808->dx_0 * _S821 * make_float2 (_S816);
    float2  _S824 = _S808->dy_0 * _S821 * make_float2 (_S816);
    CoverageTaps_0 taps_3;
    uint number_3 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        float2  _S825 = _S822 + make_float2 (TAP_OFFSETS_0[number_3].x) * _S823 + make_float2 (TAP_OFFSETS_0[number_3].y) * _S824;
        float _S826 = _S814.y;
        float _S827 = wrapped_cell_0(_S825.x, _S826);
        float _S828 = wrapped_cell_0(_S825.y, _S814.z);
        uint _S829;
        if(_S809)
        {
            _S829 = _S812.face_nodes_0;
        }
        else
        {
            _S829 = 0U;
        }
        (&taps_3)->nodes_1[number_3] = _S829 + uint(_S828 * _S826 + _S827 + _S814.x);
        number_3 = number_3 + 1U;
    }
    return taps_3;
}

__device__ float coverage_of_holes_0(uint _S830, CoverageTaps_0 * _S831)
{
    Fabric_0 * _S832 = (&(globalParams_0->fabrics_0)[_S830]);
    uint number_4 = 0U;
    uint total_0 = 0U;
    for(;;)
    {
        if(number_4 < 9U)
        {
        }
        else
        {
            break;
        }
        uint _S833 = _S831->nodes_1[number_4];
        Lobes_0 _S834 = slang_ldg_0(&_S832->lobes_0);
        uint _S835 = __ldg((&(globalParams_0->words_0)[_S834.coverage_holes_0 + _S833 / 4U]));
        uint total_1 = total_0 + ((_S835 >> (8U * (_S833 % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

__device__ float prefiltered_hole_0(uint _S836, CoverageTaps_0 * _S837, NodeTaps_0 * _S838, bool _S839)
{
    Lobes_0 _S840 = slang_ldg_0(&(&(globalParams_0->fabrics_0)[_S836])->lobes_0);
    float4  _S841 = interpolate_table_0(_S838, _S840.projected_area_0 + _S840.packs_0, _S840.packs_0 + 1U);
    float _S842 = _S841.x;
    float _S843;
    if(_S839)
    {
        _S843 = _S840.back_hole_weight_0;
    }
    else
    {
        _S843 = _S840.front_hole_weight_0;
    }
    float _S844 = coverage_of_holes_0(_S836, _S837);
    return (F32_min((_S844 * _S842 * _S842 * _S843), (1.0f)));
}

__device__ float passed_share_0(uint _S845, VisiblePoint_0 * _S846, float3  _S847, float _S848, float2  _S849)
{
    Fabric_0 * _S850 = (&(globalParams_0->fabrics_0)[_S845]);
    float3  _S851 = to_local_0(_S846, _S847);
    bool _S852 = (_S851.z) < 0.0f;
    float3  _S853 = to_face_frame_0(_S851, _S852);
    Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S846->draft_0;
    (&footprint_0)->dx_0 = make_float2 (_S848, 0.0f);
    (&footprint_0)->dy_0 = make_float2 (0.0f, _S848);
    Lobes_0 _S854 = slang_ldg_0(&_S850->lobes_0);
    float _S855;
    if((_S854.is_baked_0) != 0U)
    {
        Footprint_0 _S856 = footprint_0;
        Regime_0 _S857 = regime_of_0(_S845, &_S856, 1.0f);
        _S855 = _S857.prefiltered_0;
    }
    else
    {
        _S855 = 0.0f;
    }
    float share_2;
    if(_S855 < 1.0f)
    {
        float2  _S858 = (&footprint_0)->centre_0 + (_S849 - make_float2 (0.5f)) * make_float2 (_S848);
        float _S859 = _S858.x;
        float _S860 = _S858.y;
        SearchQuality_0 _S861 = default_quality_0();
        Hit_1 _S862 = first_hit_0(_S845, &_S861, _S859, _S860, _S853, _S852);
        if(_S862.hole_2)
        {
            share_2 = 1.0f - _S855;
        }
        else
        {
            share_2 = 0.0f;
        }
    }
    else
    {
        share_2 = 0.0f;
    }
    if(_S855 > 0.0f)
    {
        NodeTaps_0 nodes_2 = node_taps_0(_S853);
        uint _S863;
        if(_S852)
        {
            _S863 = 1U;
        }
        else
        {
            _S863 = 0U;
        }
        (&nodes_2)->nodes_0 = (&nodes_2)->nodes_0 + make_uint4 (_S863 * 256U);
        Footprint_0 _S864 = footprint_0;
        CoverageTaps_0 _S865 = coverage_taps_0(_S845, &_S864, _S852);
        CoverageTaps_0 _S866 = _S865;
        NodeTaps_0 _S867 = nodes_2;
        float _S868 = prefiltered_hole_0(_S845, &_S866, &_S867, _S852);
        share_2 = share_2 + _S855 * _S868;
    }
    float _S869 = __ldg(&_S850->sheen_strength_0);
    if(_S869 > 0.0f)
    {
        float _S870 = _S853.z;
        float _S871 = __ldg(&_S850->sheen_roughness_0);
        share_2 = share_2 * (1.0f - _S869 * sheen_lobe_0(_S870, _S871).z);
    }
    return share_2;
}

__device__ float visibility_of_0(int _S872, VisiblePoint_0 * _S873, uint _S874, uint2  _S875, uint _S876)
{
    Frame_0 * _S877 = (&(globalParams_0->frames_0)[_S872]);
    LightSample_0 _S878 = light_sample_0(_S872, _S876, _S875, _S873->position_0);
    float3  _S879 = _S873->face_normal_0;
    float nearest_1;
    if((dot_0(_S878.towards_0, _S873->face_normal_0)) < 0.0f)
    {
        nearest_1 = -1.0f;
    }
    else
    {
        nearest_1 = 1.0f;
    }
    float3  _S880 = seen_position_0(_S872, _S874, _S875);
    float _S881 = __ldg(&_S877->ray_offset_0);
    float3  _S882 = _S880 + make_float3 (nearest_1 * _S881) * _S879;
    float _S883 = (F32_sqrt((0.5f * (dot_1(_S873->draft_dx_0, _S873->draft_dx_0) + dot_1(_S873->draft_dy_0, _S873->draft_dy_0)))));
    nearest_1 = 0.0f;
    uint without_0 = _S874;
    uint layer_0 = 0U;
    float visibility_0 = 1.0f;
    for(;;)
    {
        bool _S884;
        if(layer_0 < 8U)
        {
            _S884 = visibility_0 > 0.00100000004749745f;
        }
        else
        {
            _S884 = false;
        }
        if(_S884)
        {
        }
        else
        {
            break;
        }
        Hit_0 _S885 = nearest_hit_0(_S872, _S882, _S878.towards_0, nearest_1, _S878.distance_2, without_0, true);
        if((_S885.face_1) == 4294967295U)
        {
            break;
        }
        uint _S886 = __ldg((&(globalParams_0->face_fabrics_0)[_S885.face_1]));
        VisiblePoint_0 _S887 = face_point_0(_S886, _S885.face_1, _S885.weight_b_0, _S885.weight_c_0);
        uint _S888 = __ldg(&_S877->pass_number_0);
        float2  _S889 = pixel_sequence_0(_S875, _S888, 5U + 2U * (8U * _S876 + layer_0));
        uint _S890 = __ldg(&(&(globalParams_0->fabrics_0)[_S886])->is_open_0);
        float _S891;
        if(_S890 != 0U)
        {
            float3  _S892 = - _S878.towards_0;
            VisiblePoint_0 _S893 = _S887;
            float _S894 = passed_share_0(_S886, &_S893, _S892, _S883, _S889);
            _S891 = _S894;
        }
        else
        {
            _S891 = 0.0f;
        }
        float visibility_1 = visibility_0 * _S891;
        uint _S895 = layer_0 + 1U;
        nearest_1 = _S885.distance_0;
        without_0 = _S885.face_1;
        layer_0 = _S895;
        visibility_0 = visibility_1;
    }
    if(visibility_0 > 0.00100000004749745f)
    {
        nearest_1 = visibility_0;
    }
    else
    {
        nearest_1 = 0.0f;
    }
    return nearest_1;
}

extern "C" __global__ void cast_shadows()
{
    uint3  _S896 = blockIdx * blockDim + threadIdx;
    Frame_0 * _S897 = (&(globalParams_0->frames_0)[int(0)]);
    uint _S898 = _S896.x;
    uint _S899 = __ldg(&_S897->width_0);
    bool _S900;
    if(_S898 >= _S899)
    {
        _S900 = true;
    }
    else
    {
        uint _S901 = _S896.y;
        uint _S902 = __ldg(&_S897->height_0);
        _S900 = _S901 >= _S902;
    }
    if(_S900)
    {
        return;
    }
    uint _S903 = _S896.y * _S899 + _S898;
    uint _S904 = (&(globalParams_0->layers_0)[_S903])->face_0;
    if(((&(globalParams_0->layers_0)[_S903])->face_0) == 0U)
    {
        return;
    }
    uint _S905 = _S904 - 1U;
    uint _S906 = __ldg((&(globalParams_0->face_fabrics_0)[_S905]));
    uint2  _S907 = uint2 {_S896.x, _S896.y};
    VisiblePoint_0 _S908 = visible_point_0(int(0), _S906, _S905, _S907);
    uint number_5 = 0U;
    for(;;)
    {
        uint _S909 = light_sample_count_0(int(0));
        if(number_5 < _S909)
        {
        }
        else
        {
            break;
        }
        uint _S910 = number_5 * _S899;
        uint _S911 = __ldg(&_S897->height_0);
        float * _S912 = (&(globalParams_0->visibilities_0)[_S910 * _S911 + _S903]);
        VisiblePoint_0 _S913 = _S908;
        float _S914 = visibility_of_0(int(0), &_S913, _S905, _S907, number_5);
        *_S912 = _S914;
        number_5 = number_5 + 1U;
    }
    return;
}

