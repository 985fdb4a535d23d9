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

__device__ float3  max_0(float3  x_4, float3  y_4)
{
    float3  result_2;
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
        *_slang_vector_get_element_ptr(&result_2, i_1) = (F32_max((_slang_vector_get_element(x_4, i_1)), (_slang_vector_get_element(y_4, i_1))));
        i_1 = i_1 + int(1);
    }
    return result_2;
}

__device__ float3  min_0(float3  x_5, float3  y_5)
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
        *_slang_vector_get_element_ptr(&result_3, i_2) = (F32_min((_slang_vector_get_element(x_5, i_2)), (_slang_vector_get_element(y_5, i_2))));
        i_2 = i_2 + int(1);
    }
    return result_3;
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

__device__ float inverse_of_0(float component_0)
{
    float _S16;
    if((F32_abs((component_0))) > 9.99999968265522539e-21f)
    {
        _S16 = component_0;
    }
    else
    {
        _S16 = 9.99999968265522539e-21f;
    }
    return 1.0f / _S16;
}

__device__ float scene_number_0(uint index_0)
{
    uint _S17 = __ldg((&(globalParams_0->scene_words_0)[index_0]));
    return (U32_asfloat((_S17)));
}

__device__ bool meets_node_0(uint node_0, float3  origin_0, float3  inverse_0, float nearest_0, float farthest_0)
{
    uint _S18 = 6U * (node_0 - 1U);
    float3  _S19 = (make_float3 (scene_number_0(_S18), scene_number_0(_S18 + 1U), scene_number_0(_S18 + 2U)) - origin_0) * inverse_0;
    float3  _S20 = (make_float3 (scene_number_0(_S18 + 3U), scene_number_0(_S18 + 4U), scene_number_0(_S18 + 5U)) - origin_0) * inverse_0;
    float3  _S21 = min_0(_S19, _S20);
    float3  _S22 = max_0(_S19, _S20) * make_float3 (1.0000004768371582f);
    return (F32_max(((F32_max((_S21.x), (_S21.y)))), ((F32_max((_S21.z), (nearest_0)))))) <= (F32_min(((F32_min((_S22.x), (_S22.y)))), ((F32_min((_S22.z), (farthest_0))))));
}

__device__ uint following_node_0(uint node_1)
{
    uint _S23 = node_1 + 1U;
    uint _S24 = _S23 >> (U32_firstbitlow((_S23)));
    uint _S25;
    if(_S24 == 1U)
    {
        _S25 = 0U;
    }
    else
    {
        _S25 = _S24;
    }
    return _S25;
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
    uint _S26 = 3U * face_2;
    uint _S27 = __ldg((&(globalParams_0->corners_0)[_S26]));
    Vertex_0 _S28 = slang_ldg_0((&(globalParams_0->vertices_0)[_S27]));
    Vertex_0 _S29 = _S28;
    float3  _S30 = position_of_0(&_S29);
    uint _S31 = __ldg((&(globalParams_0->corners_0)[_S26 + 1U]));
    Vertex_0 _S32 = slang_ldg_0((&(globalParams_0->vertices_0)[_S31]));
    Vertex_0 _S33 = _S32;
    float3  _S34 = position_of_0(&_S33);
    float3  _S35 = _S34 - _S30;
    uint _S36 = __ldg((&(globalParams_0->corners_0)[_S26 + 2U]));
    Vertex_0 _S37 = slang_ldg_0((&(globalParams_0->vertices_0)[_S36]));
    Vertex_0 _S38 = _S37;
    float3  _S39 = position_of_0(&_S38);
    float3  _S40 = _S39 - _S30;
    float3  _S41 = cross_0(direction_0, _S40);
    float _S42 = dot_0(_S35, _S41);
    bool _S43 = (F32_abs((_S42))) > 1.00000000317107685e-30f;
    float _S44;
    if(_S43)
    {
        _S44 = _S42;
    }
    else
    {
        _S44 = 1.00000000317107685e-30f;
    }
    float _S45 = 1.0f / _S44;
    float3  _S46 = origin_1 - _S30;
    float3  _S47 = cross_0(_S46, _S35);
    Hit_0 hit_0;
    float _S48 = dot_0(_S46, _S41) * _S45;
    (&hit_0)->weight_b_0 = _S48;
    (&hit_0)->weight_c_0 = dot_0(direction_0, _S47) * _S45;
    (&hit_0)->distance_0 = dot_0(_S40, _S47) * _S45;
    bool _S49;
    if(_S48 >= 0.0f)
    {
        _S49 = ((&hit_0)->weight_c_0) >= 0.0f;
    }
    else
    {
        _S49 = false;
    }
    if(_S49)
    {
        _S49 = ((&hit_0)->weight_b_0 + (&hit_0)->weight_c_0) <= 1.0f;
    }
    else
    {
        _S49 = false;
    }
    if(_S49)
    {
        _S49 = _S43;
    }
    else
    {
        _S49 = false;
    }
    uint _S50;
    if(_S49)
    {
        _S50 = face_2;
    }
    else
    {
        _S50 = 4294967295U;
    }
    (&hit_0)->face_1 = _S50;
    return hit_0;
}

__device__ float3  camera_origin_0(int _S51)
{
    Frame_0 * _S52 = (&(globalParams_0->frames_0)[_S51]);
    float _S53 = __ldg(&_S52->origin_x_0);
    float _S54 = __ldg(&_S52->origin_y_0);
    float _S55 = __ldg(&_S52->origin_z_0);
    return make_float3 (_S53, _S54, _S55);
}

__device__ float3  camera_forward_0(int _S56)
{
    Frame_0 * _S57 = (&(globalParams_0->frames_0)[_S56]);
    float _S58 = __ldg(&_S57->forward_x_0);
    float _S59 = __ldg(&_S57->forward_y_0);
    float _S60 = __ldg(&_S57->forward_z_0);
    return make_float3 (_S58, _S59, _S60);
}

__device__ float3  camera_right_0(int _S61)
{
    Frame_0 * _S62 = (&(globalParams_0->frames_0)[_S61]);
    float _S63 = __ldg(&_S62->right_x_0);
    float _S64 = __ldg(&_S62->right_y_0);
    float _S65 = __ldg(&_S62->right_z_0);
    return make_float3 (_S63, _S64, _S65);
}

__device__ float3  camera_up_0(int _S66)
{
    Frame_0 * _S67 = (&(globalParams_0->frames_0)[_S66]);
    float _S68 = __ldg(&_S67->up_x_0);
    float _S69 = __ldg(&_S67->up_y_0);
    float _S70 = __ldg(&_S67->up_z_0);
    return make_float3 (_S68, _S69, _S70);
}

__device__ float3  pixel_direction_0(int _S71, uint2  _S72, float2  _S73)
{
    Frame_0 * _S74 = (&(globalParams_0->frames_0)[_S71]);
    float _S75 = (float(_S72.x) + 0.5f + _S73.x) * 2.0f;
    uint _S76 = __ldg(&_S74->width_0);
    float _S77 = _S75 / float(_S76) - 1.0f;
    float _S78 = (float(_S72.y) + 0.5f + _S73.y) * 2.0f;
    uint _S79 = __ldg(&_S74->height_0);
    float _S80 = 1.0f - _S78 / float(_S79);
    float3  _S81 = camera_forward_0(_S71);
    float3  _S82 = camera_right_0(_S71);
    float3  _S83 = _S81 + make_float3 (_S77) * _S82;
    float3  _S84 = camera_up_0(_S71);
    return _S83 + make_float3 (_S80) * _S84;
}

__device__ Hit_0 nearest_hit_0(int _S85, float3  _S86, float3  _S87, float _S88, float _S89, uint _S90, bool _S91)
{
    Frame_0 * _S92 = (&(globalParams_0->frames_0)[_S85]);
    float3  _S93 = make_float3 (inverse_of_0(_S87.x), inverse_of_0(_S87.y), inverse_of_0(_S87.z));
    Hit_0 found_0;
    (&found_0)->face_1 = 4294967295U;
    (&found_0)->distance_0 = _S89;
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
        if(!meets_node_0(node_2, _S86, _S93, _S88, (&found_0)->distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            uint _S94 = __ldg(&_S92->leaves_0);
            if(node_2 < _S94)
            {
                node_3 = node_2 * 2U;
            }
            else
            {
                uint _S95 = __ldg(&_S92->leaf_faces_0);
                uint _S96 = _S95 + 4U * (node_2 - _S94);
                uint _S97 = following_node_0(node_2);
                uint number_0 = 0U;
                node_3 = _S97;
                for(;;)
                {
                    if(number_0 < 4U)
                    {
                    }
                    else
                    {
                        break;
                    }
                    uint _S98 = __ldg((&(globalParams_0->scene_words_0)[_S96 + number_0]));
                    bool _S99;
                    if(_S98 == 4294967295U)
                    {
                        _S99 = true;
                    }
                    else
                    {
                        _S99 = _S98 == _S90;
                    }
                    if(_S99)
                    {
                        number_0 = number_0 + 1U;
                        continue;
                    }
                    Hit_0 _S100 = meet_face_0(_S98, _S86, _S87);
                    bool _S101;
                    if((_S100.face_1) == 4294967295U)
                    {
                        _S101 = true;
                    }
                    else
                    {
                        _S101 = (_S100.distance_0) <= _S88;
                    }
                    bool _S102;
                    if(_S101)
                    {
                        _S102 = true;
                    }
                    else
                    {
                        _S102 = (_S100.distance_0) >= ((&found_0)->distance_0);
                    }
                    if(_S102)
                    {
                        number_0 = number_0 + 1U;
                        continue;
                    }
                    found_0 = _S100;
                    bool _S103;
                    if(_S91)
                    {
                        uint _S104 = __ldg((&(globalParams_0->face_fabrics_0)[_S98]));
                        uint _S105 = __ldg(&(&(globalParams_0->fabrics_0)[_S104])->is_open_0);
                        _S103 = _S105 == 0U;
                    }
                    else
                    {
                        _S103 = false;
                    }
                    uint node_4;
                    if(_S103)
                    {
                        node_4 = 0U;
                    }
                    else
                    {
                        node_4 = node_3;
                    }
                    node_3 = node_4;
                    number_0 = number_0 + 1U;
                }
            }
        }
        node_2 = node_3;
    }
    return found_0;
}

extern "C" __global__ void next_layer()
{
    uint3  _S106 = blockIdx * blockDim + threadIdx;
    Frame_0 * _S107 = (&(globalParams_0->frames_0)[int(0)]);
    uint _S108 = _S106.x;
    uint _S109 = __ldg(&_S107->width_0);
    bool _S110;
    if(_S108 >= _S109)
    {
        _S110 = true;
    }
    else
    {
        uint _S111 = _S106.y;
        uint _S112 = __ldg(&_S107->height_0);
        _S110 = _S111 >= _S112;
    }
    if(_S110)
    {
        return;
    }
    uint _S113 = _S106.y * _S109 + _S108;
    Layer_0 * _S114 = (&(globalParams_0->layers_0)[_S113]);
    Layer_0 _S115 = *_S114;
    if(((*_S114).face_0) == 0U)
    {
        return;
    }
    uint following_0;
    if((_S115.share_0) > 0.00100000004749745f)
    {
        float3  _S116 = camera_origin_0(int(0));
        uint2  _S117 = uint2 {_S106.x, _S106.y};
        float _S118 = __ldg(&_S107->jitter_x_0);
        float _S119 = __ldg(&_S107->jitter_y_0);
        float3  _S120 = pixel_direction_0(int(0), _S117, make_float2 (_S118, _S119));
        uint _S121 = _S115.face_0 - 1U;
        uint _S122 = 3U * _S121;
        uint _S123 = __ldg((&(globalParams_0->corners_0)[_S122]));
        Vertex_0 _S124 = slang_ldg_0((&(globalParams_0->vertices_0)[_S123]));
        Vertex_0 _S125 = _S124;
        float3  _S126 = position_of_0(&_S125);
        uint _S127 = __ldg((&(globalParams_0->corners_0)[_S122 + 1U]));
        Vertex_0 _S128 = slang_ldg_0((&(globalParams_0->vertices_0)[_S127]));
        Vertex_0 _S129 = _S128;
        float3  _S130 = position_of_0(&_S129);
        uint _S131 = __ldg((&(globalParams_0->corners_0)[_S122 + 2U]));
        Vertex_0 _S132 = slang_ldg_0((&(globalParams_0->vertices_0)[_S131]));
        Vertex_0 _S133 = _S132;
        float3  _S134 = position_of_0(&_S133);
        float3  _S135 = cross_0(_S130 - _S126, _S134 - _S126);
        float _S136 = dot_0(_S120, _S135);
        float _S137 = dot_0(_S126 - _S116, _S135);
        float _S138;
        if((F32_abs((_S136))) > 1.00000000317107685e-30f)
        {
            _S138 = _S136;
        }
        else
        {
            _S138 = 1.00000000317107685e-30f;
        }
        float _S139 = _S137 / _S138;
        float _S140 = __ldg(&_S107->ray_offset_0);
        Hit_0 _S141 = nearest_hit_0(int(0), _S116, _S120, _S139 + _S140, 1.00000001504746622e+30f, _S121, false);
        if((_S141.face_1) == 4294967295U)
        {
            following_0 = 0U;
        }
        else
        {
            following_0 = _S141.face_1 + 1U;
        }
    }
    else
    {
        following_0 = 0U;
    }
    (&(globalParams_0->layers_0)[_S113])->face_0 = following_0;
    return;
}

