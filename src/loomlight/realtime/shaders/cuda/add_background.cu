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

__device__ float3  lerp_0(float3  x_5, float3  y_4, float3  s_0)
{
    return x_5 + (y_4 - x_5) * s_0;
}

__device__ float clamp_0(float x_6, float minBound_0, float maxBound_0)
{
    return (F32_min(((F32_max((x_6), (minBound_0)))), (maxBound_0)));
}

__device__ float3  normalize_0(float3  x_7)
{
    return x_7 / make_float3 (length_0(x_7));
}

__device__ float arc_tangent_quotient_0(float x_8, float y_5)
{
    return ((((((0.0f * x_8 + 0.00809729471802711f) * x_8 + -0.0377517081797123f) * x_8 + 0.08475969731807709f) * x_8 + -0.13537675142288208f) * x_8 + 0.19895026087760925f) * x_8 + -0.33327975869178772f) * x_8 + 0.99999970197677612f;
}

__device__ float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

__device__ float arc_tangent_0(float y_6, float x_9)
{
    float _S1 = (F32_abs((x_9)));
    float _S2 = (F32_abs((y_6)));
    float angle_0 = arc_tangent_of_ratio_0((F32_min((_S1), (_S2))) / (F32_max(((F32_max((_S1), (_S2)))), (1.00000000317107685e-30f))));
    float angle_1;
    if(_S2 > _S1)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_9 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_6 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

__device__ float arc_sine_0(float x_10)
{
    float _S3 = (F32_abs((x_10)));
    bool _S4 = _S3 > 0.5f;
    float _S5;
    if(_S4)
    {
        _S5 = 0.5f * (1.0f - _S3);
    }
    else
    {
        _S5 = _S3 * _S3;
    }
    float _S6;
    if(_S4)
    {
        _S6 = (F32_sqrt(((F32_max((_S5), (0.0f))))));
    }
    else
    {
        _S6 = _S3;
    }
    float _S7 = ((((0.04216320067644119f * _S5 + 0.02418131195008755f) * _S5 + 0.04547002539038658f) * _S5 + 0.07495300471782684f) * _S5 + 0.16666752099990845f) * _S5 * _S6 + _S6;
    if(_S4)
    {
        _S5 = 1.57079637050628662f - 2.0f * _S7;
    }
    else
    {
        _S5 = _S7;
    }
    if(x_10 < 0.0f)
    {
        _S5 = - _S5;
    }
    return _S5;
}

__device__ float scene_number_0(uint index_0)
{
    uint _S8 = __ldg((&(globalParams_0->scene_words_0)[index_0]));
    return (U32_asfloat((_S8)));
}

__device__ float3  camera_forward_0(int _S9)
{
    Frame_0 * _S10 = (&(globalParams_0->frames_0)[_S9]);
    float _S11 = __ldg(&_S10->forward_x_0);
    float _S12 = __ldg(&_S10->forward_y_0);
    float _S13 = __ldg(&_S10->forward_z_0);
    return make_float3 (_S11, _S12, _S13);
}

__device__ float3  camera_right_0(int _S14)
{
    Frame_0 * _S15 = (&(globalParams_0->frames_0)[_S14]);
    float _S16 = __ldg(&_S15->right_x_0);
    float _S17 = __ldg(&_S15->right_y_0);
    float _S18 = __ldg(&_S15->right_z_0);
    return make_float3 (_S16, _S17, _S18);
}

__device__ float3  camera_up_0(int _S19)
{
    Frame_0 * _S20 = (&(globalParams_0->frames_0)[_S19]);
    float _S21 = __ldg(&_S20->up_x_0);
    float _S22 = __ldg(&_S20->up_y_0);
    float _S23 = __ldg(&_S20->up_z_0);
    return make_float3 (_S21, _S22, _S23);
}

__device__ float3  pixel_direction_0(int _S24, uint2  _S25, float2  _S26)
{
    Frame_0 * _S27 = (&(globalParams_0->frames_0)[_S24]);
    float _S28 = (float(_S25.x) + 0.5f + _S26.x) * 2.0f;
    uint _S29 = __ldg(&_S27->width_0);
    float _S30 = _S28 / float(_S29) - 1.0f;
    float _S31 = (float(_S25.y) + 0.5f + _S26.y) * 2.0f;
    uint _S32 = __ldg(&_S27->height_0);
    float _S33 = 1.0f - _S31 / float(_S32);
    float3  _S34 = camera_forward_0(_S24);
    float3  _S35 = camera_right_0(_S24);
    float3  _S36 = _S34 + make_float3 (_S30) * _S35;
    float3  _S37 = camera_up_0(_S24);
    return _S36 + make_float3 (_S33) * _S37;
}

__device__ float3  environment_texel_0(int _S38, uint _S39, uint _S40)
{
    Frame_0 * _S41 = (&(globalParams_0->frames_0)[_S38]);
    uint _S42 = __ldg(&_S41->environment_table_0);
    uint _S43 = __ldg(&_S41->environment_rows_0);
    uint _S44 = _S42 + _S43 + 1U;
    uint _S45 = __ldg(&_S41->environment_columns_0);
    uint _S46 = _S44 + _S43 * (_S45 + 1U) + 3U * (_S39 * _S45 + _S40);
    return make_float3 (scene_number_0(_S46), scene_number_0(_S46 + 1U), scene_number_0(_S46 + 2U));
}

__device__ float3  environment_radiance_0(int _S47, float3  _S48)
{
    Frame_0 * _S49 = (&(globalParams_0->frames_0)[_S47]);
    float _S50 = __ldg(&_S49->environment_cosine_0);
    float _S51 = _S48.x;
    float _S52 = _S50 * _S51;
    float _S53 = __ldg(&_S49->environment_sine_0);
    float _S54 = _S48.z;
    float _S55 = arc_tangent_0(_S52 - _S53 * _S54, - (_S53 * _S51 + _S50 * _S54)) / 6.28318548202514648f;
    float _S56 = 0.5f - arc_sine_0(clamp_0(_S48.y, -1.0f, 1.0f)) / 3.14159274101257324f;
    float _S57 = _S55 - (F32_floor((_S55)));
    uint _S58 = __ldg(&_S49->environment_columns_0);
    float _S59 = _S57 * float(_S58) - 0.5f;
    uint _S60 = __ldg(&_S49->environment_rows_0);
    uint _S61 = _S60 - 1U;
    float _S62 = clamp_0(_S56 * float(_S60) - 0.5f, 0.0f, float(_S61));
    float _S63 = (F32_floor((_S59)));
    uint _S64 = uint(int(_S63) + int(_S58)) % _S58;
    uint _S65 = (_S64 + 1U) % _S58;
    uint _S66 = uint(_S62);
    uint _S67 = (U32_min((_S66 + 1U), (_S61)));
    float _S68 = _S59 - _S63;
    float3  _S69 = environment_texel_0(_S47, _S66, _S64);
    float3  _S70 = environment_texel_0(_S47, _S66, _S65);
    float3  _S71 = make_float3 (_S68);
    float3  _S72 = lerp_0(_S69, _S70, _S71);
    float3  _S73 = environment_texel_0(_S47, _S67, _S64);
    float3  _S74 = environment_texel_0(_S47, _S67, _S65);
    return lerp_0(_S72, lerp_0(_S73, _S74, _S71), make_float3 (_S62 - float(_S66)));
}

extern "C" __global__ void add_background()
{
    uint3  _S75 = blockIdx * blockDim + threadIdx;
    Frame_0 * _S76 = (&(globalParams_0->frames_0)[int(0)]);
    uint _S77 = _S75.x;
    uint _S78 = __ldg(&_S76->width_0);
    bool _S79;
    if(_S77 >= _S78)
    {
        _S79 = true;
    }
    else
    {
        uint _S80 = _S75.y;
        uint _S81 = __ldg(&_S76->height_0);
        _S79 = _S80 >= _S81;
    }
    if(_S79)
    {
        return;
    }
    uint _S82 = _S75.y * _S78 + _S77;
    float _S83 = (&(globalParams_0->layers_0)[_S82])->share_0;
    if(((&(globalParams_0->layers_0)[_S82])->share_0) <= 0.0f)
    {
        return;
    }
    float _S84 = __ldg(&_S76->background_red_0);
    float _S85 = __ldg(&_S76->background_green_0);
    float _S86 = __ldg(&_S76->background_blue_0);
    float3  _S87 = make_float3 (_S84, _S85, _S86);
    uint _S88 = __ldg(&_S76->shows_environment_0);
    float3  background_0;
    if(_S88 != 0U)
    {
        uint2  _S89 = uint2 {_S75.x, _S75.y};
        float _S90 = __ldg(&_S76->jitter_x_0);
        float _S91 = __ldg(&_S76->jitter_y_0);
        float3  _S92 = pixel_direction_0(int(0), _S89, make_float2 (_S90, _S91));
        float3  _S93 = environment_radiance_0(int(0), normalize_0(_S92));
        background_0 = _S93;
    }
    else
    {
        background_0 = _S87;
    }
    float4  * _S94 = (&(globalParams_0->radiance_0)[_S82]);
    *_S94 = *_S94 + make_float4 ((make_float3 (_S83) * background_0).x, (make_float3 (_S83) * background_0).y, (make_float3 (_S83) * background_0).z, 0.0f);
    return;
}

