#pragma pack_matrix(column_major)
#ifdef SLANG_HLSL_ENABLE_NVAPI
#include "nvHLSLExtns.h"
#endif

#ifndef __DXC_VERSION_MAJOR
// warning X3557: loop doesn't seem to do anything, forcing loop to unroll
#pragma warning(disable : 3557)
#endif

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

StructuredBuffer<Frame_0 > frames_0 : register(t4);

struct Layer_0
{
    uint face_0;
    float share_0;
};

RWStructuredBuffer<Layer_0 > layers_0 : register(u2);

StructuredBuffer<uint > face_fabrics_0 : register(t7);

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

StructuredBuffer<Fabric_0 > fabrics_0 : register(t0);

StructuredBuffer<uint > corners_0 : register(t6);

struct Vertex_0
{
    float x_0;
    float y_0;
    float z_0;
    float normal_x_0;
    float normal_y_0;
    float normal_z_0;
    float u_0;
    float v_0;
};

StructuredBuffer<Vertex_0 > vertices_0 : register(t5);

StructuredBuffer<uint > scene_words_0 : register(t9);

RWStructuredBuffer<float > visibilities_0 : register(u3);

struct Light_0
{
    uint is_point_0;
    float x_1;
    float y_1;
    float z_1;
    float red_0;
    float green_0;
    float blue_0;
};

StructuredBuffer<Light_0 > lights_1 : register(t3);

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

StructuredBuffer<Family_0 > families_0 : register(t1);

StructuredBuffer<uint > words_0 : register(t2);

RWStructuredBuffer<float4 > radiance_0 : register(u0);

static const float2  TAP_OFFSETS_0[int(9)] = { float2(-0.3333333432674408f, -0.3333333432674408f), float2(-0.3333333432674408f, 0.0f), float2(-0.3333333432674408f, 0.3333333432674408f), float2(0.0f, -0.3333333432674408f), float2(0.0f, 0.0f), float2(0.0f, 0.3333333432674408f), float2(0.3333333432674408f, -0.3333333432674408f), float2(0.3333333432674408f, 0.0f), float2(0.3333333432674408f, 0.3333333432674408f) };
static const float  PYRAMID_RADII_0[int(4)] = { 1.0f, 2.0f, 4.0f, 8.0f };
static const float2  POINT_OFFSETS_0[int(8)] = { float2(0.0f, 0.0f), float2(-0.23010000586509705f, 0.35670000314712524f), float2(0.36809998750686646f, -0.22939999401569366f), float2(-0.28040000796318054f, -0.34400001168251038f), float2(0.3465999960899353f, 0.28859999775886536f), float2(-0.36349999904632568f, 0.0511000007390976f), float2(0.09929999709129333f, -0.35699999332427979f), float2(0.10710000246763229f, 0.32879999279975891f) };
float3 position_of_0(Vertex_0 vertex_0)
{
    return float3(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

float3 normal_of_0(Vertex_0 vertex_1)
{
    return float3(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

float square_1(float x_2)
{
    return x_2 * x_2;
}

float natural_logarithm_0(float x_3)
{
    uint _S1 = asuint(x_3);
    float exponent_0 = float(int(_S1 >> int(23)) - int(126));
    float m_0 = asfloat((_S1 & 8388607U) | 1056964608U);
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
    float _S2 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S2 - exponent_1 * 0.00021219444170129f - 0.5f * _S2) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

float exponential_0(float x_5)
{
    float _S3 = clamp(x_5, -87.0f, 88.0f);
    float _S4 = floor(_S3 * 1.4426950216293335f + 0.5f);
    float _S5 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f;
    float _S6 = asfloat(uint(int(_S4) + int(127)) << int(23));
    float _S7;
    if(x_5 < -87.0f)
    {
        _S7 = 0.0f;
    }
    else
    {
        _S7 = (p_0 * _S5 * _S5 + _S5 + 1.0f) * _S6;
    }
    return _S7;
}

float3 map_texel_0(uint index_0)
{
    uint _S8 = scene_words_0.Load(index_0);
    float3 _S9 = float3(float(_S8 & 1023U), float((_S8 >> int(10)) & 1023U), float(_S8 >> int(20))) / 1023.0f;
    return _S9 * _S9;
}

float3 map_level_0(uint first_0, uint side_0, float2 uv_0)
{
    float _S10 = uv_0.x;
    float _S11 = float(side_0);
    float _S12 = (_S10 - floor(_S10)) * _S11 - 0.5f;
    float _S13 = uv_0.y;
    float _S14 = (_S13 - floor(_S13)) * _S11 - 0.5f;
    float _S15 = floor(_S12);
    int _S16 = int(side_0);
    uint _S17 = side_0 - 1U;
    uint _S18 = uint(int(_S15) + _S16) & _S17;
    float _S19 = floor(_S14);
    uint _S20 = uint(int(_S19) + _S16) & _S17;
    uint _S21 = (_S18 + 1U) & _S17;
    uint _S22 = first_0 + _S20 * side_0;
    float3 _S23 = (float3)(_S12 - _S15);
    uint _S24 = first_0 + ((_S20 + 1U) & _S17) * side_0;
    return lerp(lerp(map_texel_0(_S22 + _S18), map_texel_0(_S22 + _S21), _S23), lerp(map_texel_0(_S24 + _S18), map_texel_0(_S24 + _S21), _S23), (float3)(_S14 - _S19));
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_1;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(VisiblePoint_0 point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

uint scramble_0(uint value_0)
{
    uint _S25 = value_0 * 747796405U + 2891336453U;
    uint _S26 = ((_S25 >> ((_S25 >> int(28)) + 4U)) ^ _S25) * 277803737U;
    return (_S26 >> int(22)) ^ _S26;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> int(9)) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_1, uint stream_1)
{
    uint _S27 = pixel_0.x;
    uint _S28 = pixel_0.y;
    return frac(float2(uniform_hash_0(_S27, _S28, stream_1), uniform_hash_0(_S27, _S28, stream_1 + 1U)) + float(index_1 & 65535U) * float2(0.75487768650054932f, 0.56984031200408936f));
}

float scene_number_0(uint index_2)
{
    return asfloat(scene_words_0.Load(index_2));
}

struct Choice_0
{
    uint index_3;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_1, float number_0)
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
        uint _S29 = (low_0 + high_0) / 2U;
        if((scene_number_0(table_0 + _S29)) <= number_0)
        {
            low_0 = _S29;
        }
        else
        {
            high_0 = _S29;
        }
    }
    uint _S30 = table_0 + low_0;
    float _S31 = scene_number_0(_S30);
    float _S32 = scene_number_0(_S30 + 1U);
    Choice_0 choice_0;
    choice_0.index_3 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S31) / max(_S32 - _S31, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_6)
{
    float _S33 = floor(x_6 * 0.63661974668502808f + 0.5f);
    float _S34 = x_6 - _S33 * 1.5703125f - _S33 * 0.00048375129699707f - _S33 * 7.54979012640433211e-08f;
    float _S35 = _S34 * _S34;
    float _S36 = ((-0.00019515295571182f * _S35 + 0.00833216123282909f) * _S35 - 0.16666655242443085f) * _S35 * _S34 + _S34;
    float _S37 = ((0.00002443315679557f * _S35 - 0.00138873164542019f) * _S35 + 0.04166664555668831f) * _S35 * _S35 - 0.5f * _S35 + 1.0f;
    uint _S38 = uint(int(_S33)) & 3U;
    float2 _S39;
    if((_S38 & 1U) != 0U)
    {
        _S39 = float2(_S37, _S36);
    }
    else
    {
        _S39 = float2(_S36, _S37);
    }
    float _S40;
    if((_S38 & 2U) != 0U)
    {
        _S40 = - _S39.x;
    }
    else
    {
        _S40 = _S39.x;
    }
    float _S41;
    if(((_S38 + 1U) & 2U) != 0U)
    {
        _S41 = - _S39.y;
    }
    else
    {
        _S41 = _S39.y;
    }
    return float2(_S40, _S41);
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float Footprint_spread_side_0(Footprint_0 this_0)
{
    float2 _S42 = this_0.dx_0;
    float2 _S43 = this_0.dy_0;
    return sqrt(0.5f * (dot(_S42, _S42) + dot(_S43, _S43)));
}

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S44 = direction_1.xy;
    float _S45;
    if(back_1)
    {
        _S45 = - direction_1.z;
    }
    else
    {
        _S45 = direction_1.z;
    }
    return float3(_S44, _S45);
}

struct SurfacePoint_0
{
    bool hole_0;
    bool is_warp_0;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_1;
    float3 normal_1;
    float3 tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_2, float3 normal_2, float3 tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    SurfacePoint_0 _S46;
    _S46.hole_0 = hole_1;
    _S46.is_warp_0 = is_warp_1;
    _S46.warp_thread_0 = warp_thread_1;
    _S46.weft_thread_0 = weft_thread_1;
    _S46.height_1 = height_2;
    _S46.normal_1 = normal_2;
    _S46.tangent_0 = tangent_1;
    _S46.across_0 = across_1;
    _S46.fibre_across_0 = fibre_across_1;
    _S46.fibre_along_0 = fibre_along_1;
    return _S46;
}

struct Components_0
{
    float diffuse_warp_0;
    float diffuse_weft_0;
    float specular_warp_0;
    float specular_weft_0;
    float light_visibility_1;
    float hole_2;
};

Components_0 no_components_0()
{
    Components_0 nothing_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_2 = 0.0f;
    return nothing_0;
}

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 quality_of_0(float threads_0)
{
    float _S47 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    SearchQuality_0 quality_0;
    float _S48 = lerp(2.5f, 5.0f, _S47);
    quality_0.steps_per_thread_0 = _S48;
    quality_0.steps_per_relief_0 = _S48;
    quality_0.shadow_share_0 = lerp(1.60000002384185791f, 1.0f, _S47);
    quality_0.refinements_0 = uint(lerp(1.0f, 2.0f, _S47) + 0.5f);
    return quality_0;
}

float2 turns_and_remainder_0(uint family_0, float index_4)
{
    float _S49 = floor(mad(index_4, families_0.Load(family_0).inverse_count_0, families_0.Load(family_0).half_inverse_count_0));
    return float2(_S49, mad(- _S49, families_0.Load(family_0).count_0, index_4));
}

struct Cell_0
{
    uint thread_1;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1)
{
    float _S50 = floor(position_1 * families_0.Load(family_1).inverse_size_0);
    Cell_0 cell_1;
    float _S51 = mad(- _S50, families_0.Load(family_1).size_0, position_1);
    cell_1.below_0 = _S51;
    cell_1.above_0 = families_0.Load(family_1).size_0 - _S51;
    cell_1.across_2 = _S51 - 0.5f * families_0.Load(family_1).size_0;
    cell_1.half_width_1 = families_0.Load(family_1).half_width_0;
    cell_1.thread_1 = uint(clamp(turns_and_remainder_0(family_1, _S50).y, 0.0f, families_0.Load(family_1).count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_5)
{
    return asfloat(words_0.Load(index_5));
}

Cell_0 locate_varied_0(uint family_2, float position_2)
{
    float turns_0 = (position_2 - families_0.Load(family_2).start_0) * families_0.Load(family_2).inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S52 = turns_1 * families_0.Load(family_2).period_0;
    uint thread_2 = words_0.Load(families_0.Load(family_2).first_thread_table_0 + uint(clamp(turns_1 * families_0.Load(family_2).bins_0, 0.0f, families_0.Load(family_2).bins_0 - 1.0f)));
    uint _S53;
    if(_S52 >= (table_number_0(families_0.Load(family_2).place_table_0 + thread_2 * 4U + 1U)))
    {
        _S53 = 1U;
    }
    else
    {
        _S53 = 0U;
    }
    uint _S54 = min(thread_2 + _S53, uint(families_0.Load(family_2).count_0) - 1U);
    uint _S55 = families_0.Load(family_2).place_table_0 + _S54 * 4U;
    Cell_0 cell_2;
    cell_2.thread_1 = _S54;
    cell_2.below_0 = _S52 - table_number_0(_S55);
    cell_2.above_0 = table_number_0(_S55 + 1U) - _S52;
    cell_2.across_2 = _S52 - table_number_0(_S55 + 2U);
    cell_2.half_width_1 = table_number_0(_S55 + 3U);
    return cell_2;
}

Cell_0 locate_0(uint family_3, float position_3)
{
    if((families_0.Load(family_3).is_alike_0) != 0U)
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Shown_0
{
    bool is_warp_2;
    bool hole_3;
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

Shown_0 shown_at_0(Crossing_0 crossing_0, bool back_2)
{
    bool _S56 = (abs(crossing_0.warp_1.across_2)) < (crossing_0.warp_1.half_width_1);
    bool _S57 = (abs(crossing_0.weft_1.across_2)) < (crossing_0.weft_1.half_width_1);
    Shown_0 shown_0;
    bool _S58;
    if(_S56)
    {
        if(!_S57)
        {
            _S58 = true;
        }
        else
        {
            _S58 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S58 = false;
    }
    shown_0.is_warp_2 = _S58;
    if(!_S56)
    {
        _S58 = !_S57;
    }
    else
    {
        _S58 = false;
    }
    shown_0.hole_3 = _S58;
    uint _S59;
    if(shown_0.is_warp_2)
    {
        _S59 = crossing_0.warp_word_0;
    }
    else
    {
        _S59 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S59;
    shown_0.on_top_0 = ((_S59 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, Cell_0 first_1, Cell_0 second_0)
{
    Cell_0 cell_3;
    uint _S60;
    if(is_first_0)
    {
        _S60 = first_1.thread_1;
    }
    else
    {
        _S60 = second_0.thread_1;
    }
    cell_3.thread_1 = _S60;
    float _S61;
    if(is_first_0)
    {
        _S61 = first_1.across_2;
    }
    else
    {
        _S61 = second_0.across_2;
    }
    cell_3.across_2 = _S61;
    if(is_first_0)
    {
        _S61 = first_1.half_width_1;
    }
    else
    {
        _S61 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S61;
    if(is_first_0)
    {
        _S61 = first_1.below_0;
    }
    else
    {
        _S61 = second_0.below_0;
    }
    cell_3.below_0 = _S61;
    if(is_first_0)
    {
        _S61 = first_1.above_0;
    }
    else
    {
        _S61 = second_0.above_0;
    }
    cell_3.above_0 = _S61;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0)
{
    float2 _S62 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0));
    return mad(_S62.x, families_0.Load(family_4).period_0, table_number_0(families_0.Load(family_4).place_table_0 + uint(_S62.y) * 4U));
}

float span_0(uint family_5, uint thread_4, int first_2, int last_0)
{
    if((families_0.Load(family_5).is_alike_0) != 0U)
    {
        return float(last_0 - first_2) * families_0.Load(family_5).size_0;
    }
    return boundary_0(family_5, thread_4, last_0) - boundary_0(family_5, thread_4, first_2);
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_5)
{
    Family_0 _S63 = families_0.Load(family_6);
    uint _S64;
    if((families_0.Load(family_6).is_alike_0) != 0U)
    {
        _S64 = 0U;
    }
    else
    {
        _S64 = thread_5 * 4U;
    }
    uint _S65 = _S63.bend_table_0 + _S64;
    Bend_0 bend_0;
    bend_0.sine_0 = table_number_0(_S65);
    bend_0.half_tangent_0 = table_number_0(_S65 + 1U);
    bend_0.arc_0 = table_number_0(_S65 + 2U);
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_6, Cell_0 crossed_0, uint word_1)
{
    int _S66 = int((word_1 >> int(1)) & 127U);
    int _S67 = int((word_1 >> int(8)) & 127U);
    int _S68 = int((word_1 >> int(15)) & 63U);
    int _S69 = int((word_1 >> int(21)) & 63U);
    Run_0 run_0;
    run_0.straight_0 = ((word_1 >> int(27)) & 1U) == 1U;
    int _S70 = - _S66;
    float _S71 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S70, int(0));
    run_0.from_start_0 = _S71;
    int _S72 = _S67 + int(1);
    float _S73 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, int(1), _S72);
    run_0.to_end_0 = _S73;
    bool _S74 = _S71 < _S73;
    run_0.near_start_0 = _S74;
    int _S75;
    if(_S74)
    {
        _S75 = _S70 - _S68;
    }
    else
    {
        _S75 = _S72;
    }
    int _S76;
    if(run_0.near_start_0)
    {
        _S76 = _S70;
    }
    else
    {
        _S76 = _S72 + _S69;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    float _S77;
    if(run_0.straight_0)
    {
        _S77 = 1.0e+06f;
    }
    else
    {
        _S77 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S77;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S75, _S76), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S66 == int(0);
    run_0.last_crossing_0 = _S67 == int(0);
    return run_0;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(Cell_0 cell_4)
{
    float _S78 = cell_4.half_width_1 * 1.0154266357421875f;
    Section_0 section_0;
    float _S79 = clamp(cell_4.across_2, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S79;
    float _S80 = _S78 * _S78 - square_1(_S79);
    float _S81 = rsqrt(_S80);
    section_0.drop_0 = _S78 - _S80 * _S81;
    section_0.slope_0 = - _S79 * _S81;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_7, int step_1)
{
    if((families_0.Load(family_7).is_alike_0) != 0U)
    {
        return table_number_0(families_0.Load(family_7).bend_table_0 + 3U);
    }
    return table_number_0(families_0.Load(family_7).bend_table_0 + uint(turns_and_remainder_0(family_7, float(int(thread_7) + step_1)).y) * 4U + 3U);
}

float2 dive_0(uint other_1, Shown_0 shown_1, Run_0 run_1, Cell_0 crossed_1)
{
    bool _S82 = (crossed_1.below_0) < (crossed_1.above_0);
    float _S83 = min(crossed_1.below_0, crossed_1.above_0);
    float _S84;
    if(_S82)
    {
        _S84 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S84 = crossed_1.above_0 + crossed_1.across_2;
    }
    float _S85 = _S84 - crossed_1.half_width_1;
    bool _S86;
    if(_S82)
    {
        _S86 = run_1.first_crossing_0;
    }
    else
    {
        _S86 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S84 = 0.0f;
    }
    else
    {
        _S84 = families_0.Load(other_1).height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, int(0));
    }
    float _S87;
    if((shown_1.on_top_0) != _S86)
    {
        _S87 = 0.0f;
    }
    else
    {
        Family_0 _S88 = families_0.Load(other_1);
        int _S89;
        if(_S82)
        {
            _S89 = int(-1);
        }
        else
        {
            _S89 = int(1);
        }
        _S87 = _S88.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S89);
    }
    float _S90 = 1.0f / max(2.0f * _S85, 9.999999960041972e-13f);
    float _S91 = clamp((_S85 - _S83) * _S90, 0.0f, 1.0f);
    float _S92 = _S84 + (_S87 - _S84) * (_S91 * _S91 * (3.0f - 2.0f * _S91));
    float _S93 = (_S84 - _S87) * (6.0f * _S91 * (1.0f - _S91) * _S90);
    if(_S82)
    {
        _S84 = 1.0f;
    }
    else
    {
        _S84 = -1.0f;
    }
    return float2(_S92, _S93 * _S84);
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

StepControl_0 step_control_0(float2 direction_2, float step_3)
{
    StepControl_0 control_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    float _S94 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S94), 9.99999971718068537e-10f);
    float _S95 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S95), 9.99999971718068537e-10f);
    control_0.right_0 = _S94 > 0.0f;
    control_0.up_0 = _S95 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
    float clearance_0;
    float rate_0;
    uint yarn_0;
    bool known_0;
};

PreviousSample_0 no_previous_sample_0()
{
    PreviousSample_0 previous_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_0 = 0U;
    previous_0.known_0 = false;
    return previous_0;
}

float outline_distance_0(Cell_0 cell_5, Shown_0 shown_2, Run_0 run_2, bool lengthwise_0, bool forwards_0)
{
    float _S96;
    if(forwards_0)
    {
        _S96 = cell_5.across_2;
    }
    else
    {
        _S96 = - cell_5.across_2;
    }
    float _S97;
    if(forwards_0)
    {
        _S97 = cell_5.above_0;
    }
    else
    {
        _S97 = cell_5.below_0;
    }
    bool _S98;
    if(forwards_0)
    {
        _S98 = run_2.last_crossing_0;
    }
    else
    {
        _S98 = run_2.first_crossing_0;
    }
    bool _S99;
    if(forwards_0)
    {
        _S99 = run_2.first_crossing_0;
    }
    else
    {
        _S99 = run_2.last_crossing_0;
    }
    float _S100 = - cell_5.half_width_1;
    bool _S101 = _S96 < _S100;
    bool _S102 = _S96 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S98 = !_S98;
    }
    else
    {
        _S98 = false;
    }
    if(_S98)
    {
        _S98 = !shown_2.hole_3;
    }
    else
    {
        _S98 = false;
    }
    bool _S103;
    if(_S98)
    {
        _S103 = shown_2.on_top_0;
    }
    else
    {
        _S103 = false;
    }
    if(_S103)
    {
        if(_S99)
        {
            _S99 = _S101;
        }
        else
        {
            _S99 = false;
        }
        _S99 = !_S99;
    }
    else
    {
        _S99 = false;
    }
    if(shown_2.hole_3)
    {
        _S98 = true;
    }
    else
    {
        if(_S98)
        {
            _S98 = !shown_2.on_top_0;
        }
        else
        {
            _S98 = false;
        }
    }
    float _S104;
    if(_S101)
    {
        _S104 = _S100;
    }
    else
    {
        _S104 = cell_5.half_width_1;
    }
    float _S105 = _S104 - _S96;
    if(_S98)
    {
        _S96 = 2.0f * _S97 + _S96 - cell_5.half_width_1;
    }
    else
    {
        _S96 = _S97;
    }
    if(_S99)
    {
        if(forwards_0)
        {
            _S96 = run_2.to_end_0;
        }
        else
        {
            _S96 = run_2.from_start_0;
        }
        return _S96;
    }
    if(_S102)
    {
    }
    else
    {
        _S96 = _S105;
    }
    return _S96;
}

struct Probe_0
{
    float height_3;
    bool hole_4;
    float slope_x_0;
    float slope_y_0;
    uint yarn_1;
    float cell_max_0;
    float side_x_0;
    float side_y_0;
    float edge_x_0;
    float edge_y_0;
};

float way_back_to_dip_0(PreviousSample_0 previous_1, float clearance_1, float rate_1, float step_4, Probe_0 here_0)
{
    float _S106 = previous_1.rate_0 * step_4;
    float _S107 = rate_1 * step_4;
    bool _S108;
    if(!previous_1.known_0)
    {
        _S108 = true;
    }
    else
    {
        _S108 = here_0.hole_4;
    }
    if(_S108)
    {
        _S108 = true;
    }
    else
    {
        _S108 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S108)
    {
        _S108 = true;
    }
    else
    {
        _S108 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S108)
    {
        _S108 = true;
    }
    else
    {
        _S108 = rate_1 <= 0.0f;
    }
    if(_S108)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S106) >= 0.0f)
    {
        _S108 = (3.0f * clearance_1 - _S107) >= 0.0f;
    }
    else
    {
        _S108 = false;
    }
    if(_S108)
    {
        return -1.0f;
    }
    float _S109 = clearance_1 - previous_1.clearance_0;
    float _S110 = 6.0f * _S109 - 4.0f * _S106 - 2.0f * _S107;
    float _S111 = -2.0f * _S106 / max(_S110 + sqrt(max(_S110 * _S110 - 4.0f * (3.0f * (_S106 + _S107 - 2.0f * _S109)) * _S106, 0.0f)), 9.99999968265522539e-21f);
    float _S112 = 1.0f - _S111;
    float _S113 = (previous_1.clearance_0 * (2.0f * _S111 + 1.0f) + _S106 * _S111) * _S112 * _S112;
    float _S114 = (clearance_1 * (2.0f * _S112 + 1.0f) - _S107 * _S112) * _S111 * _S111;
    if(_S111 > 0.01999999955296516f)
    {
        _S108 = _S112 > 0.01999999955296516f;
    }
    else
    {
        _S108 = false;
    }
    if(_S108)
    {
        _S108 = (_S113 + _S114) < 0.0f;
    }
    else
    {
        _S108 = false;
    }
    float _S115;
    if(_S108)
    {
        _S115 = _S112 * step_4;
    }
    else
    {
        _S115 = -1.0f;
    }
    return _S115;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, Probe_0 here_1, bool is_cell_exit_0)
{
    PreviousSample_0 previous_2;
    float _S116;
    if(here_1.hole_4)
    {
        _S116 = 1.0e+09f;
    }
    else
    {
        _S116 = clearance_2;
    }
    previous_2.clearance_0 = _S116;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    bool _S117;
    if(!here_1.hole_4)
    {
        _S117 = !is_cell_exit_0;
    }
    else
    {
        _S117 = false;
    }
    previous_2.known_0 = _S117;
    return previous_2;
}

float StepControl_to_cell_exit_0(StepControl_0 this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

float StepControl_to_next_sample_0(StepControl_0 this_2, Probe_0 here_2, float clearance_3, float rate_3)
{
    float _S118 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    bool _S119;
    if(!here_2.hole_4)
    {
        _S119 = (rate_3 * _S118 + clearance_3) < 0.0f;
    }
    else
    {
        _S119 = false;
    }
    if(_S119)
    {
        _S119 = _S118 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S119 = false;
    }
    float _S120;
    if(_S119)
    {
        _S120 = _S118 - this_2.epsilon_0;
    }
    else
    {
        _S120 = max(_S118, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S120);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(ViewRay_0 this_3, float height_4)
{
    return this_3.origin_0 + this_3.slope_1 * height_4;
}

float ViewRay_rate_0(ViewRay_0 this_4, Probe_0 here_3)
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S121 = end_0 - start_1;
    float _S122 = start_rate_0 + end_rate_0 - 2.0f * _S121;
    float _S123 = 3.0f * _S121 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S121, 9.99999968265522539e-21f);
    int i_0 = int(0);
    for(;;)
    {
        if(uint(i_0) < 3U)
        {
        }
        else
        {
            break;
        }
        float _S124 = clamp(share_1 - (((_S122 * share_1 + _S123) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S122 * share_1 + 2.0f * _S123) * share_1 + start_rate_0, 0.10000000149011612f * _S121 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S125 = i_0 + int(1);
        share_1 = _S124;
        i_0 = _S125;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S126 = along_slope_0 * along_slope_0 + 1.0f;
    float _S127 = rsqrt(_S126);
    float _S128 = sine_1 * _S127 * rsqrt(_S126 + across_slope_0 * across_slope_0);
    return float2(- _S128 * _S126, _S128 * across_slope_0 * along_slope_0 + cosine_0 * _S127);
}

float arc_sine_0(float x_7)
{
    float _S129 = abs(x_7);
    bool _S130 = _S129 > 0.5f;
    float _S131;
    if(_S130)
    {
        _S131 = 0.5f * (1.0f - _S129);
    }
    else
    {
        _S131 = _S129 * _S129;
    }
    float _S132;
    if(_S130)
    {
        _S132 = sqrt(max(_S131, 0.0f));
    }
    else
    {
        _S132 = _S129;
    }
    float _S133 = ((((0.04216320067644119f * _S131 + 0.02418131195008755f) * _S131 + 0.04547002539038658f) * _S131 + 0.07495300471782684f) * _S131 + 0.16666752099990845f) * _S131 * _S132 + _S132;
    if(_S130)
    {
        _S131 = 1.57079637050628662f - 2.0f * _S133;
    }
    else
    {
        _S131 = _S133;
    }
    if(x_7 < 0.0f)
    {
        _S131 = - _S131;
    }
    return _S131;
}

float3 table_colour_0(uint index_6)
{
    return float3(table_number_0(index_6), table_number_0(index_6 + 1U), table_number_0(index_6 + 2U));
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0)
{
    Albedos_0 albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_0);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_0 + 3U);
    albedos_0.specular_reflect_0 = table_colour_0(row_0 + 6U);
    albedos_0.specular_transmit_0 = table_colour_0(row_0 + 9U);
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_8)
{
    return table_albedos_0(families_0.Load(family_8).albedo_table_0 + families_0.Load(family_8).albedo_stride_0 * thread_8);
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S134 = room_0 / max(albedo_0, (float3)9.99999997475242708e-07f);
    return min(gain_1, max(min(min(_S134.x, _S134.y), _S134.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float diffuse_reflection_0(float3 light_0, float3 normal_3, float blend_0)
{
    float _S135 = light_0.z;
    if(_S135 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * lerp(max(_S135, 0.0f), max(dot(light_0, normal_3), 0.0f), blend_0);
}

float projected_area_1(float3 direction_3, float3 tangent_2, float roughness_1)
{
    float _S136 = dot(direction_3, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S136 * _S136 + 1.0f, roughness_1 * roughness_1));
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S137 = roughness_2 * roughness_2;
    float _S138 = squared_along_0 * (1.0f - _S137) + _S137;
    return 0.31830987334251404f * _S137 * roughness_2 / (_S138 * _S138);
}

float density_between_0(float3 light_1, float3 view_1, float3 tangent_3, float roughness_3)
{
    float3 _S139 = light_1 + view_1;
    float _S140 = dot(_S139, tangent_3);
    return flake_density_0(min(_S140 * _S140 / max(square_0(_S139), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float transmission_0(float3 light_2, float3 view_2, float3 normal_4, float3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S141 = - dot(light_2, normal_4);
    float _S142 = dot(view_2, normal_4);
    bool _S143;
    if(_S141 <= 0.0f)
    {
        _S143 = true;
    }
    else
    {
        _S143 = _S142 <= 0.0f;
    }
    if(_S143)
    {
        return 0.0f;
    }
    float _S144 = 1.0f / max(_S142, 9.99999997475242708e-07f);
    float _S145 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S141, 9.99999997475242708e-07f);
    float _S146 = projected_area_1(view_2, tangent_4, roughness_4) * _S144;
    return density_between_0(light_2, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S145, _S146)) * mean_attenuation_0(optical_depth_1 * abs(_S145 - _S146)) * _S144;
}

float reflection_0(float3 light_3, float3 view_3, float3 normal_5, float3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S147 = dot(light_3, normal_5);
    bool _S148;
    if(_S147 <= 0.0f)
    {
        _S148 = true;
    }
    else
    {
        _S148 = (dot(view_3, normal_5)) <= 0.0f;
    }
    if(_S148)
    {
        return 0.0f;
    }
    float _S149 = max(_S147, 9.99999997475242708e-07f);
    float _S150 = max(dot(view_3, normal_5), 9.99999997475242708e-07f);
    float _S151 = projected_area_1(light_3, tangent_5, roughness_5) * _S150 + projected_area_1(view_3, tangent_5, roughness_5) * _S149;
    float _S152 = optical_depth_2 * _S151 / (_S149 * _S150);
    return 0.25f * density_between_0(light_3, view_3, tangent_5, roughness_5) * (_S152 * mean_attenuation_0(_S152)) * _S149 / _S151;
}

Components_0 with_added_0(Components_0 sums_0, Components_0 more_0, float weight_0)
{
    Components_0 result_0;
    result_0.diffuse_warp_0 = sums_0.diffuse_warp_0 + weight_0 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_0.diffuse_weft_0 + weight_0 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_0.specular_warp_0 + weight_0 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_0.specular_weft_0 + weight_0 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_0.light_visibility_1 + weight_0 * more_0.light_visibility_1;
    result_0.hole_2 = sums_0.hole_2 + weight_0 * more_0.hole_2;
    return result_0;
}

float wrapped_cell_0(float position_4, float count_2)
{
    return min(floor((position_4 - floor(position_4)) * count_2), count_2 - 1.0f);
}

float arc_tangent_quotient_0(float x_8, float y_2)
{
    return ((((((0.0f * x_8 + 0.00809729471802711f) * x_8 + -0.0377517081797123f) * x_8 + 0.08475969731807709f) * x_8 + -0.13537675142288208f) * x_8 + 0.19895026087760925f) * x_8 + -0.33327975869178772f) * x_8 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_3, float x_9)
{
    float _S153 = abs(x_9);
    float _S154 = abs(y_3);
    float angle_0 = arc_tangent_of_ratio_0(min(_S153, _S154) / max(max(_S153, _S154), 1.00000000317107685e-30f));
    float angle_1;
    if(_S154 > _S153)
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
    if(y_3 < 0.0f)
    {
        angle_1 = - angle_1;
    }
    return angle_1;
}

struct NodeTaps_0
{
    uint4 nodes_0;
    uint4 weights_0;
    float inverse_sum_0;
};

NodeTaps_0 node_taps_0(float3 direction_4)
{
    float _S155 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S156 = floor(_S155);
    float _S157 = _S155 - _S156;
    float _S158 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S159 = 7.0f * _S158 * sqrt(_S158);
    float _S160 = min(floor(_S159), 6.0f);
    float _S161 = _S159 - _S160;
    uint _S162 = uint(int(_S156) + int(32)) % 32U;
    uint _S163 = uint(_S160);
    uint _S164 = _S162 * 8U + _S163;
    uint _S165 = (_S162 + 1U) % 32U * 8U + _S163;
    NodeTaps_0 taps_0;
    taps_0.nodes_0 = uint4(_S164, _S164 + 1U, _S165, _S165 + 1U);
    float _S166 = 1.0f - _S157;
    float _S167 = 1.0f - _S161;
    uint4 _S168 = uint4(float4(_S166 * _S167, _S166 * _S161, _S157 * _S167, _S157 * _S161) * 252.0f + 0.5f);
    taps_0.weights_0 = _S168;
    taps_0.inverse_sum_0 = 1.0f / float(_S168.x + _S168.y + _S168.z + _S168.w);
    return taps_0;
}

float3 half_vector_0(float3 light_4, float3 view_4)
{
    float3 _S169 = light_4 + view_4;
    return _S169 * rsqrt(max(square_0(_S169), 9.999999960041972e-13f));
}

float3 shadow_correlation_0(float3 light_5, float3 view_5)
{
    float2 _S170 = light_5.xy;
    float2 _S171 = view_5.xy;
    float _S172 = dot(_S170, _S171) / max(sqrt(dot(_S170, _S170) * dot(_S171, _S171)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return float3((float2)(-0.09000000357627869f + -0.07999999821186066f * _S172), 0.0f);
    }
    return float3(min(0.62000000476837158f + 0.62999999523162842f * _S172, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> int(16)), float(odd_0 >> int(16)));
}

float4 interpolate_0(NodeTaps_0 taps_1, uint4 packs_1)
{
    uint4 _S173 = (packs_1 & 16711935U) * taps_1.weights_0;
    uint4 _S174 = ((packs_1 >> int(8)) & 16711935U) * taps_1.weights_0;
    return bytes_of_sums_0(_S173.x + _S173.y + _S173.z + _S173.w, _S174.x + _S174.y + _S174.z + _S174.w) * taps_1.inverse_sum_0;
}

float4 interpolate_table_0(NodeTaps_0 taps_2, uint table_1, uint stride_0)
{
    uint4 _S175 = table_1 + taps_2.nodes_0 * stride_0;
    return interpolate_0(taps_2, uint4(words_0.Load(_S175.x), words_0.Load(_S175.y), words_0.Load(_S175.z), words_0.Load(_S175.w)));
}

struct Group_0
{
    float3 normal_6;
    float weight_1;
    float3 tangent_6;
    float3 variance_0;
    float3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7)
{
    Group_0 group_0;
    group_0.normal_6 = float3(table_number_0(row_1), table_number_0(row_1 + 1U), table_number_0(row_1 + 2U));
    group_0.weight_1 = table_number_0(row_1 + 3U);
    float3 _S176 = float3(table_number_0(row_1 + 4U), table_number_0(row_1 + 5U), table_number_0(row_1 + 6U));
    group_0.tangent_6 = _S176;
    float _S177 = table_number_0(row_1 + 7U);
    float _S178 = table_number_0(row_1 + 8U);
    group_0.variance_0 = float3(_S177, _S178, 1.0f - square_0(_S176) - _S177 - _S178);
    group_0.covariance_0 = float3(table_number_0(row_1 + 9U), table_number_0(row_1 + 10U), table_number_0(row_1 + 11U));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

float2 visibility_gain_0(float3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * (1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f) + float2(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), (float2)0.0f);
}

float Group_variance_along_0(Group_0 this_5, float3 direction_5)
{
    float _S179 = direction_5.x;
    float _S180 = direction_5.y;
    float _S181 = direction_5.z;
    return max(dot(this_5.variance_0, direction_5 * direction_5) + 2.0f * dot(this_5.covariance_0, float3(_S179 * _S180, _S179 * _S181, _S180 * _S181)), 0.0f);
}

float mean_area_0(Group_0 group_1, float3 direction_6)
{
    float _S182 = dot(direction_6, group_1.tangent_6);
    float _S183 = group_1.roughness_6;
    float _S184 = _S183 * _S183;
    return sqrt(max((_S184 - 1.0f) * (_S182 * _S182 + Group_variance_along_0(group_1, direction_6)) + 1.0f, _S184));
}

float mean_density_0(Group_0 group_2, float3 half_0)
{
    float _S185 = group_2.roughness_6;
    float _S186 = max(sqrt(max(1.0f - _S185 * _S185, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    float _S187 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    float _S188 = dot(half_0, group_2.tangent_6);
    float _S189 = _S186 * (_S188 - _S187);
    float _S190 = _S186 * (_S188 + _S187);
    float _S191 = _S189 * _S190;
    float _S192 = 2.0f * _S187 * _S186;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S191) / ((_S189 * _S189 + 1.0f) * (_S190 * _S190 + 1.0f)) + arc_tangent_0(_S192, 1.0f + _S191) / _S192);
}

float layer_value_0(Group_0 group_3, float3 half_1, float3 light_6, float3 view_6, float optical_depth_3)
{
    bool _S193 = (light_6.z) < 0.0f;
    float _S194 = dot(light_6, group_3.normal_6);
    float _S195;
    if(_S193)
    {
        _S195 = - _S194;
    }
    else
    {
        _S195 = _S194;
    }
    float _S196 = max(dot(view_6, group_3.normal_6), 0.01999999955296516f);
    float _S197 = mean_area_0(group_3, light_6) / max(_S195, 0.01999999955296516f);
    float _S198 = mean_area_0(group_3, view_6) / _S196;
    if(_S193)
    {
        _S195 = abs(_S197 - _S198);
    }
    else
    {
        _S195 = _S197 + _S198;
    }
    float _S199 = optical_depth_3 * max(_S195, 0.00100000004749745f);
    if(_S193)
    {
        _S195 = exponential_0(- optical_depth_3 * min(_S197, _S198));
    }
    else
    {
        _S195 = 1.0f;
    }
    float _S200 = optical_depth_3 * _S195 * (1.0f - exponential_0(- _S199)) / _S199 / _S196;
    if(_S193)
    {
        _S195 = 1.0f;
    }
    else
    {
        _S195 = 1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_6));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S195 * _S200;
}

struct Bound_0
{
    uint thread_11;
    float turns_2;
    float cell_7;
    float visible_0;
    float width_1;
    float gap_0;
};

Bound_0 bound_at_0(uint family_9, float position_5)
{
    Cell_0 _S201 = locate_0(family_9, position_5);
    float _S202 = table_number_0(families_0.Load(family_9).before_0 + 2U * _S201.thread_1 + 1U);
    Bound_0 bound_0;
    bound_0.thread_11 = _S201.thread_1;
    bound_0.turns_2 = round((position_5 - families_0.Load(family_9).start_0 - _S202 - _S201.below_0) * families_0.Load(family_9).inverse_period_0);
    bound_0.cell_7 = _S201.below_0;
    float _S203 = 2.0f * _S201.half_width_1;
    bound_0.width_1 = _S203;
    bound_0.visible_0 = clamp((_S201.across_2 + _S201.half_width_1) / _S203, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S201.below_0, _S201.below_0 - _S201.across_2 - _S201.half_width_1) + max(_S201.across_2 - _S201.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_1;
    Bound_0 high_1;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1)
{
    float _S204 = centre_1 - floor((centre_1 - families_0.Load(family_10).start_0) * families_0.Load(family_10).inverse_period_0) * families_0.Load(family_10).period_0;
    float _S205 = 0.5f * max(size_1, families_0.Load(family_10).smallest_box_0);
    Stretch_0 stretch_0;
    stretch_0.low_1 = bound_at_0(family_10, _S204 - _S205);
    stretch_0.high_1 = bound_at_0(family_10, _S204 + _S205);
    return stretch_0;
}

float Stretch_turns_0(Stretch_0 this_6)
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

float3 lengths_0(uint family_11, Stretch_0 stretch_1)
{
    float _S206 = Stretch_turns_0(stretch_1);
    uint _S207 = families_0.Load(family_11).before_0 + 2U * stretch_1.low_1.thread_11;
    uint _S208 = families_0.Load(family_11).before_0 + 2U * stretch_1.high_1.thread_11;
    float _S209 = table_number_0(_S208) - table_number_0(_S207);
    float _S210 = table_number_0(_S208 + 1U) - table_number_0(_S207 + 1U);
    return float3(_S209 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_1 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_1 + _S206 * families_0.Load(family_11).visible_total_0, _S210 - _S209 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S206 * (families_0.Load(family_11).period_0 - families_0.Load(family_11).visible_total_0), _S210 + stretch_1.high_1.cell_7 - stretch_1.low_1.cell_7 + _S206 * families_0.Load(family_11).period_0);
}

float2 integrals_along_0(uint family_12, Stretch_0 stretch_2, uint quantity_0)
{
    Family_0 _S211 = families_0.Load(family_12);
    uint _S212 = 3U * _S211.quantities_0;
    uint _S213 = families_0.Load(family_12).colour_threads_0 + _S212 * stretch_2.low_1.thread_11 + quantity_0;
    uint _S214 = families_0.Load(family_12).colour_threads_0 + _S212 * stretch_2.high_1.thread_11 + quantity_0;
    uint _S215 = families_0.Load(family_12).colour_threads_0 + _S212 * uint(families_0.Load(family_12).count_0) + quantity_0;
    float _S216 = table_number_0(_S213);
    float _S217 = table_number_0(_S214);
    float _S218 = Stretch_turns_0(stretch_2);
    uint _S219 = 2U * _S211.quantities_0;
    return float2(table_number_0(_S214 + _S211.quantities_0) - table_number_0(_S213 + _S211.quantities_0) + _S217 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_1 - _S216 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_1 + _S218 * table_number_0(_S215 + _S211.quantities_0), table_number_0(_S214 + _S219) - table_number_0(_S213 + _S219) + _S217 * stretch_2.high_1.cell_7 - _S216 * stretch_2.low_1.cell_7 + _S218 * table_number_0(_S215 + _S219));
}

bool Stretch_wraps_0(Stretch_0 this_7)
{
    return (this_7.high_1.thread_11) < (this_7.low_1.thread_11);
}

uint4 Stretch_differences_0(Stretch_0 this_8, uint4 entries_0, uint whole_0)
{
    uint _S220 = entries_0.z;
    uint _S221 = entries_0.x;
    uint _S222 = _S220 - _S221;
    uint _S223;
    if(Stretch_wraps_0(this_8))
    {
        _S223 = whole_0;
    }
    else
    {
        _S223 = 0U;
    }
    return uint4(_S222 + _S223, entries_0.w - _S220, entries_0.y - _S221, whole_0);
}

uint4 row_differences_0(Stretch_0 across_4, uint row_2, uint count_3, uint quantities_1)
{
    uint _S224 = row_2 + across_4.low_1.thread_11 * quantities_1;
    uint _S225 = row_2 + across_4.high_1.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, uint4(words_0.Load(_S224), words_0.Load(_S224 + quantities_1), words_0.Load(_S225), words_0.Load(_S225 + quantities_1)), words_0.Load(row_2 + count_3 * quantities_1));
}

float4 Stretch_weights_0(Stretch_0 this_9)
{
    float _S226 = - this_9.low_1.visible_0;
    float _S227 = Stretch_turns_0(this_9);
    float _S228;
    if(Stretch_wraps_0(this_9))
    {
        _S228 = 1.0f;
    }
    else
    {
        _S228 = 0.0f;
    }
    return float4(1.0f, this_9.high_1.visible_0, _S226, _S227 - _S228);
}

float integral_on_top_0(uint family_13, Stretch_0 across_5, Stretch_0 along_0, uint crossing_count_0, uint quantity_1)
{
    uint _S229 = uint(families_0.Load(family_13).count_0);
    uint _S230 = (_S229 + 1U) * families_0.Load(family_13).quantities_0;
    uint _S231 = families_0.Load(family_13).colour_areas_0 + quantity_1;
    uint4 _S232 = row_differences_0(across_5, _S231 + along_0.low_1.thread_11 * _S230, _S229, families_0.Load(family_13).quantities_0);
    uint4 _S233 = row_differences_0(across_5, _S231 + (along_0.low_1.thread_11 + 1U) * _S230, _S229, families_0.Load(family_13).quantities_0);
    uint4 _S234 = row_differences_0(across_5, _S231 + along_0.high_1.thread_11 * _S230, _S229, families_0.Load(family_13).quantities_0);
    uint4 _S235 = row_differences_0(across_5, _S231 + (along_0.high_1.thread_11 + 1U) * _S230, _S229, families_0.Load(family_13).quantities_0);
    uint4 _S236 = row_differences_0(across_5, _S231 + crossing_count_0 * _S230, _S229, families_0.Load(family_13).quantities_0);
    uint4 _S237 = _S234 - _S232;
    uint4 _S238;
    if(Stretch_wraps_0(along_0))
    {
        _S238 = _S236;
    }
    else
    {
        _S238 = uint4((int4)int(0));
    }
    float4 _S239 = Stretch_weights_0(across_5);
    return dot(float4(dot(float4(int4(_S237 + _S238)), _S239), dot(float4(int4(_S235 - _S234)), _S239), dot(float4(int4(_S233 - _S232)), _S239), dot(float4(int4(_S236)), _S239)), Stretch_weights_0(along_0)) * families_0.Load(family_13).area_unit_0;
}

Albedos_0 with_added_albedos_0(Albedos_0 albedos_1, float weight_2, uint row_3)
{
    Albedos_0 _S240 = table_albedos_0(row_3);
    Albedos_0 sum_0;
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + weight_2 * _S240.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + weight_2 * _S240.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + weight_2 * _S240.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + weight_2 * _S240.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, Stretch_0 own_1, Stretch_0 other_2, bool back_3)
{
    Albedos_0 albedos_2 = table_albedos_0(families_0.Load(family_14).colour_mean_0);
    if((families_0.Load(family_14).quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S241 = lengths_0(crossing_1, other_2);
    bool is_exposed_0 = false;
    float weight_3 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (families_0.Load(family_14).quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S242 = integrals_along_0(family_14, own_1, quantity_2);
        float _S243 = integral_on_top_0(family_14, own_1, other_2, uint(families_0.Load(crossing_1).count_0), quantity_2);
        float _S244 = _S242.x;
        float _S245 = _S244 * _S241.x;
        float _S246;
        if(back_3)
        {
            _S246 = _S245 - _S243;
        }
        else
        {
            _S246 = _S243;
        }
        bool _S247 = quantity_2 == 0U;
        if(_S247)
        {
            is_exposed_0 = _S246 > (16.0f * families_0.Load(family_14).area_unit_0 * min(_S245 / families_0.Load(family_14).crossing_area_0, 1.0f) + 0.00000999999974738f * _S245);
        }
        float _S248 = _S244 * _S241.y;
        float _S249;
        if(is_exposed_0)
        {
            _S249 = _S246;
        }
        else
        {
            _S249 = 0.0f;
        }
        float _S250 = _S248 + _S249 + 0.000244140625f * _S241.z * _S242.y;
        if(_S247)
        {
            weight_3 = 1.0f / max(_S250, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S250 * weight_3, families_0.Load(family_14).colour_axes_0 + 12U * (quantity_2 - 1U));
        }
        quantity_2 = quantity_2 + 1U;
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

Albedos_0 lerp_albedos_0(Albedos_0 first_3, Albedos_0 second_1, float weight_4)
{
    Albedos_0 albedos_3;
    float3 _S251 = (float3)weight_4;
    albedos_3.diffuse_reflect_0 = lerp(first_3.diffuse_reflect_0, second_1.diffuse_reflect_0, _S251);
    albedos_3.diffuse_transmit_0 = lerp(first_3.diffuse_transmit_0, second_1.diffuse_transmit_0, _S251);
    albedos_3.specular_reflect_0 = lerp(first_3.specular_reflect_0, second_1.specular_reflect_0, _S251);
    albedos_3.specular_transmit_0 = lerp(first_3.specular_transmit_0, second_1.specular_transmit_0, _S251);
    return albedos_3;
}

Albedos_0 tinted_0(Albedos_0 albedos_4, float3 tint_0)
{
    Albedos_0 result_1 = albedos_4;
    result_1.diffuse_reflect_0 = result_1.diffuse_reflect_0 * tint_0;
    result_1.diffuse_transmit_0 = result_1.diffuse_transmit_0 * tint_0;
    return result_1;
}

float sheen_scale_0(float x_10, float y_4)
{
    return (((((0.0f * x_10 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_10 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_10 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_10 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_10 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_10 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

float sheen_shear_0(float x_11, float y_5)
{
    return ((((0.0f * x_11 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_11 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_11 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_11 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_11 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_12, float y_6)
{
    return ((((0.0f * x_12 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_12 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_12 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_12 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_12 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S252 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S253 = 2.0f * sqrt(_S252) - 1.0f;
    float _S254 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S253, _S254), 0.00999999977648258f, 1.0f), clamp((1.0f - _S252) * sheen_shear_0(_S253, _S254), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S253, _S254), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_7, float3 view_7, float scale_0, float shear_0)
{
    float _S255 = light_7.z;
    bool _S256;
    if(_S255 <= 0.0f)
    {
        _S256 = true;
    }
    else
    {
        _S256 = (view_7.z) <= 0.0f;
    }
    if(_S256)
    {
        return 0.0f;
    }
    float2 _S257 = view_7.xy;
    float _S258 = dot(_S257, _S257);
    float2 _S259;
    if(_S258 > 9.99999968265522539e-21f)
    {
        _S259 = _S257 * rsqrt(_S258);
    }
    else
    {
        _S259 = float2(1.0f, 0.0f);
    }
    float _S260 = scale_0 * dot(light_7.xy, _S259) + shear_0 * _S255;
    float _S261 = scale_0 * (light_7.y * _S259.x - light_7.x * _S259.y);
    float _S262 = _S260 * _S260 + _S261 * _S261 + _S255 * _S255;
    return 0.31830987334251404f * scale_0 * scale_0 * _S255 / max(_S262 * _S262, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_8, float3 view_8, float strength_0, float roughness_9)
{
    float3 _S263 = sheen_lobe_0(view_8.z, roughness_9);
    float _S264 = strength_0 * _S263.z;
    return float2(_S264 * transformed_cosine_0(light_8, view_8, _S263.x, _S263.y), 1.0f - _S264);
}

void accumulate_0(uint index_7, float4 light_9)
{
    float _S265 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + layers_0[index_7].share_0 * light_9;
    layers_0[index_7].share_0 = _S265 * (1.0f - light_9.w);
    return;
}

float3 camera_right_0(int _S266)
{
    return float3(frames_0[_S266].right_x_0, frames_0[_S266].right_y_0, frames_0[_S266].right_z_0);
}

float3 camera_up_0(int _S267)
{
    return float3(frames_0[_S267].up_x_0, frames_0[_S267].up_y_0, frames_0[_S267].up_z_0);
}

float3 camera_forward_0(int _S268)
{
    return float3(frames_0[_S268].forward_x_0, frames_0[_S268].forward_y_0, frames_0[_S268].forward_z_0);
}

float3 camera_origin_0(int _S269)
{
    return float3(frames_0[_S269].origin_x_0, frames_0[_S269].origin_y_0, frames_0[_S269].origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S270, uint _S271, float _S272, float _S273)
{
    uint _S274 = 3U * _S271;
    Vertex_0 _S275 = vertices_0.Load(corners_0.Load(_S274));
    Vertex_0 _S276 = vertices_0.Load(corners_0.Load(_S274 + 1U));
    Vertex_0 _S277 = vertices_0.Load(corners_0.Load(_S274 + 2U));
    float3 _S278 = position_of_0(_S275);
    float3 _S279 = position_of_0(_S276) - _S278;
    float3 _S280 = position_of_0(_S277) - _S278;
    float _S281 = _S276.u_0 - _S275.u_0;
    float _S282 = _S276.v_0 - _S275.v_0;
    float2 _S283 = float2(_S281, _S282);
    float _S284 = _S277.u_0 - _S275.u_0;
    float _S285 = _S277.v_0 - _S275.v_0;
    float2 _S286 = float2(_S284, _S285);
    float _S287;
    if((_S281 * _S285 - _S282 * _S284) < 0.0f)
    {
        _S287 = -1.0f;
    }
    else
    {
        _S287 = 1.0f;
    }
    float3 _S288 = _S287 * (_S285 * _S279 - _S282 * _S280);
    float3 _S289 = _S287 * (_S281 * _S280 - _S284 * _S279);
    VisiblePoint_0 point_1;
    float3 _S290 = normalize((1.0f - _S272 - _S273) * normal_of_0(_S275) + _S272 * normal_of_0(_S276) + _S273 * normal_of_0(_S277));
    point_1.normal_0 = _S290;
    float3 _S291 = normalize(_S288 - _S290 * dot(_S290, _S288));
    point_1.axis_x_0 = _S291;
    point_1.axis_y_0 = cross(_S290, _S291);
    float3 _S292 = normalize(cross(_S279, _S280));
    float3 _S293;
    if((dot(_S292, _S290)) < 0.0f)
    {
        _S293 = - _S292;
    }
    else
    {
        _S293 = _S292;
    }
    point_1.face_normal_0 = _S293;
    point_1.position_0 = _S278 + _S272 * _S279 + _S273 * _S280;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_1 = float2(_S275.u_0, _S275.v_0) + _S272 * _S283 + _S273 * _S286;
    bool _S294 = (dot(cross(_S288, _S289), point_1.normal_0)) < 0.0f;
    float _S295 = fabrics_0[_S270].uv_width_0;
    if(_S294)
    {
        _S287 = - fabrics_0[_S270].uv_height_0;
    }
    else
    {
        _S287 = fabrics_0[_S270].uv_height_0;
    }
    float2 _S296 = float2(_S295, _S287);
    point_1.draft_per_uv_0 = _S296;
    float2 _S297 = point_1.uv_1 * _S296;
    if(_S294)
    {
        _S287 = fabrics_0[_S270].uv_height_0;
    }
    else
    {
        _S287 = 0.0f;
    }
    point_1.draft_0 = _S297 + float2(0.0f, _S287);
    float2 _S298 = (float2)0.0f;
    point_1.draft_dx_0 = _S298;
    point_1.draft_dy_0 = _S298;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S299, uint _S300, uint _S301, uint2 _S302)
{
    uint _S303 = 3U * _S301;
    Vertex_0 _S304 = vertices_0.Load(corners_0.Load(_S303));
    Vertex_0 _S305 = vertices_0.Load(corners_0.Load(_S303 + 1U));
    Vertex_0 _S306 = vertices_0.Load(corners_0.Load(_S303 + 2U));
    float3 _S307 = position_of_0(_S304);
    float3 _S308 = position_of_0(_S305) - _S307;
    float3 _S309 = position_of_0(_S306) - _S307;
    float3 _S310 = cross(_S308, _S309);
    float _S311 = 1.0f / max(square_0(_S310), 1.00000000317107685e-30f);
    float _S312 = float(frames_0[_S299].width_0);
    float3 _S313 = camera_right_0(_S299) * (2.0f / _S312);
    float _S314 = float(frames_0[_S299].height_0);
    float3 _S315 = camera_up_0(_S299) * (-2.0f / _S314);
    float3 _S316 = camera_forward_0(_S299) + (float(_S302.x) + 0.5f - 0.5f * _S312) * _S313 + (float(_S302.y) + 0.5f - 0.5f * _S314) * _S315;
    float _S317 = dot(_S316, _S310);
    float _S318;
    if((abs(_S317)) > 1.00000000317107685e-30f)
    {
        _S318 = _S317;
    }
    else
    {
        _S318 = 1.00000000317107685e-30f;
    }
    float _S319 = 1.0f / _S318;
    float3 _S320 = _S307 - camera_origin_0(_S299);
    float _S321 = dot(_S320, _S310) * _S319;
    float3 _S322 = _S316 * _S321 - _S320;
    float3 _S323 = _S321 * (_S313 - _S316 * (dot(_S313, _S310) * _S319));
    float3 _S324 = _S321 * (_S315 - _S316 * (dot(_S315, _S310) * _S319));
    float3 _S325 = cross(_S309, _S310) * _S311;
    float3 _S326 = cross(_S310, _S308) * _S311;
    float2 _S327 = float2(_S305.u_0 - _S304.u_0, _S305.v_0 - _S304.v_0);
    float2 _S328 = float2(_S306.u_0 - _S304.u_0, _S306.v_0 - _S304.v_0);
    VisiblePoint_0 point_2 = face_point_0(_S300, _S301, dot(_S322, _S325), dot(_S322, _S326));
    point_2.position_0 = _S307 + _S322;
    point_2.view_0 = - normalize(_S316);
    point_2.draft_dx_0 = (dot(_S323, _S325) * _S327 + dot(_S323, _S326) * _S328) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (dot(_S324, _S325) * _S327 + dot(_S324, _S326) * _S328) * point_2.draft_per_uv_0;
    return point_2;
}

float3 filtered_albedo_0(uint _S329, VisiblePoint_0 _S330)
{
    uint _S331 = fabrics_0[_S329].albedo_map_levels_0;
    if((fabrics_0[_S329].albedo_map_levels_0) == 0U)
    {
        return (float3)1.0f;
    }
    float2 _S332 = float2(fabrics_0[_S329].uv_width_0, fabrics_0[_S329].uv_height_0);
    float2 _S333 = _S330.draft_dx_0 / _S332;
    float2 _S334 = _S330.draft_dy_0 / _S332;
    uint _S335 = _S331 - 1U;
    uint _S336 = 1U << _S335;
    float _S337 = clamp(0.5f * binary_logarithm_0(max(abs(_S333.x * _S334.y - _S333.y * _S334.x), 9.99999968265522539e-21f) * (square_1(float(_S336)) / 3.0f)), 0.0f, float(_S331) - 1.0f);
    uint _S338 = min(uint(_S337), max(_S331, 2U) - 2U);
    uint _S339 = min(_S338 + 1U, _S335);
    uint _S340 = 1U << (2U * _S331);
    return lerp(map_level_0(fabrics_0[_S329].albedo_map_0 + (_S340 - (_S340 >> (2U * _S338))) / 3U, _S336 >> _S338, _S330.uv_1), map_level_0(fabrics_0[_S329].albedo_map_0 + (_S340 - (_S340 >> (2U * _S339))) / 3U, _S336 >> _S339, _S330.uv_1), (float3)((exponential_0(1.38629436492919922f * (_S337 - float(_S338))) - 1.0f) / 3.0f));
}

uint light_sample_count_0(int _S341)
{
    return frames_0[_S341].lights_0 + frames_0[_S341].environment_samples_0;
}

float visibility_at_0(int _S342, uint _S343, uint2 _S344)
{
    if((frames_0[_S342].casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return visibilities_0[(_S343 * frames_0[_S342].height_0 + _S344.y) * frames_0[_S342].width_0 + _S344.x];
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_1;
};

float3 environment_texel_0(int _S345, uint _S346, uint _S347)
{
    uint _S348 = frames_0[_S345].environment_table_0 + frames_0[_S345].environment_rows_0 + 1U + frames_0[_S345].environment_rows_0 * (frames_0[_S345].environment_columns_0 + 1U) + 3U * (_S346 * frames_0[_S345].environment_columns_0 + _S347);
    return float3(scene_number_0(_S348), scene_number_0(_S348 + 1U), scene_number_0(_S348 + 2U));
}

float3 sample_environment_0(int _S349, float2 _S350, out float3 _S351)
{
    uint _S352 = frames_0[_S349].environment_rows_0;
    Choice_0 _S353 = choose_0(frames_0[_S349].environment_table_0, frames_0[_S349].environment_rows_0, _S350.y);
    uint _S354 = frames_0[_S349].environment_columns_0;
    Choice_0 _S355 = choose_0(frames_0[_S349].environment_table_0 + frames_0[_S349].environment_rows_0 + 1U + _S353.index_3 * (frames_0[_S349].environment_columns_0 + 1U), frames_0[_S349].environment_columns_0, _S350.x);
    float3 _S356 = environment_texel_0(_S349, _S353.index_3, _S355.index_3);
    _S351 = _S356 * (frames_0[_S349].environment_total_0 / max(mean_0(_S356), 9.99999968265522539e-21f));
    float _S357 = 3.14159274101257324f / float(_S352);
    float _S358 = lerp(sine_cosine_0(float(_S353.index_3) * _S357).y, sine_cosine_0(float(_S353.index_3 + 1U) * _S357).y, _S353.remainder_0);
    float _S359 = sqrt(max(1.0f - _S358 * _S358, 0.0f));
    float2 _S360 = sine_cosine_0((float(_S355.index_3) + _S355.remainder_0) * (6.28318548202514648f / float(_S354)));
    float _S361 = _S359 * _S360.x;
    float _S362 = - _S359 * _S360.y;
    return float3(frames_0[_S349].environment_cosine_0 * _S361 + frames_0[_S349].environment_sine_0 * _S362, _S358, frames_0[_S349].environment_cosine_0 * _S362 - frames_0[_S349].environment_sine_0 * _S361);
}

LightSample_0 light_sample_0(int _S363, uint _S364, uint2 _S365, float3 _S366)
{
    LightSample_0 sample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    uint _S367 = frames_0[_S363].lights_0;
    if(_S364 >= (frames_0[_S363].lights_0))
    {
        float3 weight_5;
        float3 _S368 = sample_environment_0(_S363, pixel_sequence_0(_S365, frames_0[_S363].pass_number_0 * frames_0[_S363].environment_samples_0 + (_S364 - _S367), 3U), weight_5);
        sample_0.towards_0 = _S368;
        sample_0.irradiance_1 = weight_5 / float(frames_0[_S363].environment_samples_0);
        return sample_0;
    }
    Light_0 _S369 = lights_1.Load(_S364);
    sample_0.irradiance_1 = float3(_S369.red_0, _S369.green_0, _S369.blue_0);
    sample_0.towards_0 = float3(_S369.x_1, _S369.y_1, _S369.z_1);
    if((_S369.is_point_0) != 0U)
    {
        float3 _S370 = sample_0.towards_0 - _S366;
        float _S371 = max(square_0(_S370), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S371);
        sample_0.irradiance_1 = sample_0.irradiance_1 / _S371;
        sample_0.towards_0 = normalize(_S370);
    }
    return sample_0;
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_2;
    Albedos_0 weft_2;
};

struct Estimate_0
{
    Components_0 components_0;
    FamilyAlbedos_0 albedos_5;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_0;
};

Regime_0 regime_of_0(uint _S372, Footprint_0 _S373, float _S374)
{
    float _S375 = Footprint_spread_side_0(_S373);
    float _S376 = clamp((binary_logarithm_0(max(_S375, 9.99999971718068537e-10f)) - fabrics_0[_S372].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    Regime_0 regime_0;
    float _S377 = _S376 * _S376 * (3.0f - 2.0f * _S376);
    regime_0.prefiltered_0 = _S377;
    regime_0.threads_1 = _S375 * fabrics_0[_S372].lobes_0.threads_per_mm_0;
    float _S378 = lerp(max(8.0f / _S374, 1.0f), 1.0f, _S377);
    float _S379;
    if(_S377 < 1.0f)
    {
        _S379 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S378);
    }
    else
    {
        _S379 = 0.0f;
    }
    regime_0.points_0 = _S379;
    return regime_0;
}

struct Hit_0
{
    float x_13;
    float y_7;
    bool hole_5;
    float height_5;
};

struct Sample_0
{
    Crossing_0 crossing_2;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_6;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S380, float _S381, float _S382, bool _S383)
{
    Crossing_0 crossing_3;
    crossing_3.warp_1 = locate_0(fabrics_0[_S380].warp_0, _S381);
    crossing_3.weft_1 = locate_0(fabrics_0[_S380].weft_0, _S382);
    uint _S384 = fabrics_0[_S380].run_words_0 + 2U * (crossing_3.weft_1.thread_1 * fabrics_0[_S380].ends_1 + crossing_3.warp_1.thread_1);
    uint _S385 = words_0.Load(_S384);
    crossing_3.warp_word_0 = _S385;
    crossing_3.weft_word_0 = words_0.Load(_S384 + 1U);
    crossing_3.warp_above_0 = ((_S385 & 1U) == 1U) != _S383;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S386, float _S387, float _S388, bool _S389)
{
    Sample_0 sample_1;
    Crossing_0 _S390 = crossing_at_0(_S386, _S387, _S388, _S389);
    sample_1.crossing_2 = _S390;
    Shown_0 _S391 = shown_at_0(_S390, _S389);
    sample_1.shown_3 = _S391;
    uint _S392;
    if(_S391.is_warp_2)
    {
        _S392 = fabrics_0[_S386].warp_0;
    }
    else
    {
        _S392 = fabrics_0[_S386].weft_0;
    }
    uint _S393;
    if(_S391.is_warp_2)
    {
        _S393 = fabrics_0[_S386].weft_0;
    }
    else
    {
        _S393 = fabrics_0[_S386].warp_0;
    }
    Cell_0 _S394 = select_cell_0(_S391.is_warp_2, sample_1.crossing_2.warp_1, sample_1.crossing_2.weft_1);
    Cell_0 _S395 = select_cell_0(_S391.is_warp_2, sample_1.crossing_2.weft_1, sample_1.crossing_2.warp_1);
    Run_0 _S396 = unpack_0(_S392, _S393, _S394.thread_1, _S395, _S391.word_0);
    Section_0 _S397 = section_at_0(_S394);
    bool _S398;
    if(_S391.on_top_0)
    {
        _S398 = (_S396.distance_0) < (_S397.drop_0 * _S396.bend_1.sine_0);
    }
    else
    {
        _S398 = false;
    }
    bool _S399;
    if(_S391.on_top_0)
    {
        _S399 = !_S398;
    }
    else
    {
        _S399 = false;
    }
    float _S400;
    if(_S399)
    {
        _S400 = 1.0f;
    }
    else
    {
        _S400 = -1.0f;
    }
    float _S401;
    if(_S398)
    {
        _S401 = _S396.other_reach_0;
    }
    else
    {
        _S401 = _S396.reach_0;
    }
    float _S402;
    if(_S398)
    {
        _S402 = _S401 + _S396.distance_0;
    }
    else
    {
        _S402 = max(_S401 - _S396.distance_0, 0.0f);
    }
    float _S403 = _S401 / _S396.bend_1.sine_0 - _S400 * _S397.drop_0;
    float _S404 = _S402 * _S402;
    float _S405 = max(_S403 * _S403 - _S404, 9.99999968265522539e-21f);
    float _S406 = rsqrt(_S405);
    float _S407 = _S404 / (_S405 * _S406 + _S403);
    bool _S408 = _S402 > 0.0f;
    float _S409;
    if(_S391.on_top_0)
    {
        _S409 = 1.0f;
    }
    else
    {
        _S409 = -1.0f;
    }
    float _S410;
    if(_S396.near_start_0)
    {
        _S410 = 1.0f;
    }
    else
    {
        _S410 = -1.0f;
    }
    float _S411 = _S409 * _S410;
    if(_S408)
    {
        _S409 = _S403 * _S406;
    }
    else
    {
        _S409 = 1.0f;
    }
    sample_1.slope_across_0 = _S397.slope_0 * _S409;
    if(_S408)
    {
        _S402 = _S411 * _S402 * _S406;
    }
    else
    {
        _S402 = 0.0f;
    }
    sample_1.slope_along_0 = _S402;
    Family_0 _S412 = families_0.Load(_S392);
    float2 _S413 = dive_0(_S393, _S391, _S396, _S395);
    if(_S396.straight_0)
    {
        _S400 = 0.0f;
    }
    else
    {
        _S400 = _S412.height_scale_0 * _S400;
    }
    sample_1.height_6 = _S400 * (_S401 * _S396.bend_1.half_tangent_0 - _S407) - _S412.height_scale_0 * _S397.drop_0 - _S413.x;
    float _S414 = _S412.height_scale_0 * sample_1.slope_across_0;
    float _S415 = _S412.height_scale_0 * sample_1.slope_along_0 - _S413.y;
    if(_S391.is_warp_2)
    {
        _S400 = _S414;
    }
    else
    {
        _S400 = _S415;
    }
    sample_1.slope_x_1 = _S400;
    if(_S391.is_warp_2)
    {
        _S400 = _S415;
    }
    else
    {
        _S400 = _S414;
    }
    sample_1.slope_y_1 = _S400;
    sample_1.run_3 = _S396;
    sample_1.section_1 = _S397;
    return sample_1;
}

float steps_per_length_0(uint _S416, SearchQuality_0 _S417, float3 _S418)
{
    return max(max(abs(_S418.x) * fabrics_0[_S416].threads_per_x_0, abs(_S418.y) * fabrics_0[_S416].threads_per_y_0) * _S417.steps_per_thread_0, abs(_S418.z) * fabrics_0[_S416].per_relief_0 * _S417.steps_per_relief_0);
}

float cell_maximum_0(uint _S419, Crossing_0 _S420)
{
    uint _S421;
    if(_S420.warp_above_0)
    {
        _S421 = fabrics_0[_S419].warp_0;
    }
    else
    {
        _S421 = fabrics_0[_S419].weft_0;
    }
    uint _S422;
    if(_S420.warp_above_0)
    {
        _S422 = _S420.warp_word_0;
    }
    else
    {
        _S422 = _S420.weft_word_0;
    }
    return float(_S422 >> int(28)) * families_0.Load(_S421).height_scale_0 * families_0.Load(_S421).level_0;
}

Probe_0 probe_0(uint _S423, float _S424, float _S425, bool _S426, bool _S427, bool _S428)
{
    Sample_0 _S429 = sample_at_0(_S423, _S424, _S425, _S426);
    Probe_0 probe_1;
    probe_1.height_3 = _S429.height_6;
    probe_1.hole_4 = _S429.shown_3.hole_3;
    probe_1.slope_x_0 = _S429.slope_x_1;
    probe_1.slope_y_0 = _S429.slope_y_1;
    uint _S430;
    if(_S429.shown_3.is_warp_2)
    {
        _S430 = _S429.crossing_2.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S430 = _S429.crossing_2.weft_1.thread_1 * 2U;
    }
    probe_1.yarn_1 = _S430;
    probe_1.cell_max_0 = cell_maximum_0(_S423, _S429.crossing_2);
    float _S431;
    if(_S427)
    {
        _S431 = _S429.crossing_2.warp_1.above_0;
    }
    else
    {
        _S431 = _S429.crossing_2.warp_1.below_0;
    }
    probe_1.side_x_0 = _S431;
    if(_S428)
    {
        _S431 = _S429.crossing_2.weft_1.above_0;
    }
    else
    {
        _S431 = _S429.crossing_2.weft_1.below_0;
    }
    probe_1.side_y_0 = _S431;
    probe_1.edge_x_0 = outline_distance_0(_S429.crossing_2.warp_1, _S429.shown_3, _S429.run_3, !_S429.shown_3.is_warp_2, _S427);
    probe_1.edge_y_0 = outline_distance_0(_S429.crossing_2.weft_1, _S429.shown_3, _S429.run_3, _S429.shown_3.is_warp_2, _S428);
    return probe_1;
}

bool is_free_0(uint _S432, SearchQuality_0 _S433, float3 _S434, float3 _S435, bool _S436, float _S437)
{
    float _S438 = _S435.z;
    if(_S438 <= 0.0f)
    {
        return false;
    }
    float _S439 = 1.0f / max(_S433.shadow_share_0 * steps_per_length_0(_S432, _S433, _S435), 9.99999971718068537e-10f);
    StepControl_0 _S440 = step_control_0(_S435.xy, _S439);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_4 = 0U;
    float distance_2 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S441;
        if(count_4 < 1024U)
        {
            _S441 = (_S434.z + _S438 * distance_2) < _S437;
        }
        else
        {
            _S441 = false;
        }
        if(_S441)
        {
        }
        else
        {
            break;
        }
        float3 _S442 = _S434 + _S435 * distance_2;
        Probe_0 _S443 = probe_0(_S432, _S442.x, _S442.y, _S436, _S440.right_0, _S440.up_0);
        float _S444 = _S442.z;
        float _S445 = _S444 - _S443.height_3;
        float _S446 = _S438 - _S443.slope_x_0 * _S435.x - _S443.slope_y_0 * _S435.y;
        bool _S447;
        if(!_S443.hole_4)
        {
            _S447 = _S445 < 0.0f;
        }
        else
        {
            _S447 = false;
        }
        if(_S447)
        {
            return false;
        }
        float _S448 = way_back_to_dip_0(previous_3, _S445, _S446, last_step_0, _S443);
        if(_S448 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S448;
            distance_2 = distance_2 - _S448;
            last_step_0 = last_step_1;
            count_4 = count_4 + 1U;
            continue;
        }
        bool _S449 = _S444 > (_S443.cell_max_0);
        PreviousSample_0 _S450 = after_sample_0(_S445, _S446, _S443, _S449);
        float last_step_2;
        if(_S449)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S440, _S443.side_x_0, _S443.side_y_0), _S439);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S440, _S443, _S445, _S446);
        }
        float distance_3 = distance_2 + last_step_2;
        previous_3 = _S450;
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S451, SearchQuality_0 _S452, float _S453, float _S454, float3 _S455, bool _S456)
{
    if(!sample_at_0(_S451, _S453, _S454, _S456).shown_3.hole_3)
    {
        return false;
    }
    float3 _S457 = float3(_S453, _S454, 0.0f);
    bool passes_0 = true;
    uint side_1 = 0U;
    for(;;)
    {
        bool _S458;
        if(side_1 < 2U)
        {
            _S458 = passes_0;
        }
        else
        {
            _S458 = false;
        }
        if(_S458)
        {
        }
        else
        {
            break;
        }
        float3 _S459;
        if(side_1 == 0U)
        {
            _S459 = _S455;
        }
        else
        {
            _S459 = float3(- _S455.x, - _S455.y, _S455.z);
        }
        bool _S460 = is_free_0(_S451, _S452, _S457, _S459, _S456 != (side_1 == 1U), fabrics_0[_S451].height_high_0);
        uint _S461 = side_1 + 1U;
        passes_0 = _S460;
        side_1 = _S461;
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

float max_height_along_0(uint _S462, float _S463, float _S464, float _S465, float3 _S466, bool _S467)
{
    uint _S468 = locate_0(fabrics_0[_S462].warp_0, _S463).thread_1 / 2U;
    uint _S469 = locate_0(fabrics_0[_S462].weft_0, _S464).thread_1 / 2U;
    float _S470 = _S466.x;
    uint _S471;
    if(_S470 > 0.0f)
    {
        _S471 = 1U;
    }
    else
    {
        _S471 = 0U;
    }
    float _S472 = _S466.y;
    uint _S473;
    if(_S472 > 0.0f)
    {
        _S473 = 2U;
    }
    else
    {
        _S473 = 0U;
    }
    uint _S474 = words_0.Load(fabrics_0[_S462].max_heights_0 + 4U * (_S469 * fabrics_0[_S462].max_height_columns_0 + _S468) + (_S471 + _S473));
    int number_1;
    if(_S467)
    {
        number_1 = int(4);
    }
    else
    {
        number_1 = int(0);
    }
    uint _S475 = _S474 >> number_1;
    float _S476 = max(abs(_S470) * fabrics_0[_S462].threads_per_x_0, abs(_S472) * fabrics_0[_S462].threads_per_y_0) / _S466.z;
    float _S477 = fabrics_0[_S462].height_high_0;
    float max_height_0 = fabrics_0[_S462].height_high_0;
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
        if(((max_height_0 - _S465) * _S476) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, float((_S475 >> uint(int(8) * number_1)) & 15U) * 0.06666667014360428f * _S477);
        }
        number_1 = number_1 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S478, float _S479, float _S480, bool _S481, bool _S482, bool _S483)
{
    Crossing_0 _S484 = crossing_at_0(_S478, _S479, _S480, _S481);
    float _S485 = cell_maximum_0(_S478, _S484);
    float _S486;
    if(_S482)
    {
        _S486 = _S484.warp_1.above_0;
    }
    else
    {
        _S486 = _S484.warp_1.below_0;
    }
    float _S487;
    if(_S483)
    {
        _S487 = _S484.weft_1.above_0;
    }
    else
    {
        _S487 = _S484.weft_1.below_0;
    }
    return float3(_S485, _S486, _S487);
}

float first_sample_height_0(uint _S488, ViewRay_0 _S489, StepControl_0 _S490, bool _S491)
{
    float _S492 = max_height_along_0(_S488, _S489.origin_0.x, _S489.origin_0.y, 0.0f, float3(_S489.slope_1, 1.0f), _S491);
    uint count_5 = 0U;
    float height_8 = _S492;
    for(;;)
    {
        if(count_5 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S493 = ViewRay_at_0(_S489, height_8);
        float3 _S494 = cell_bounds_0(_S488, _S493.x, _S493.y, _S491, _S490.right_0, _S490.up_0);
        float _S495 = height_8 - _S494.x;
        float _S496 = StepControl_to_cell_exit_0(_S490, _S494.y, _S494.z);
        float height_9 = height_8 - clamp(_S495, 0.0f, _S496);
        if(_S495 <= _S496)
        {
            height_8 = height_9;
            break;
        }
        count_5 = count_5 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S497, ViewRay_0 _S498, StepControl_0 _S499, bool _S500)
{
    float _S501 = fabrics_0[_S497].height_low_0 - (fabrics_0[_S497].height_high_0 - fabrics_0[_S497].height_low_0);
    ViewRayEnd_0 end_1;
    end_1.height_7 = first_sample_height_0(_S497, _S498, _S499, _S500);
    end_1.last_step_3 = _S499.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    uint count_6 = 0U;
    for(;;)
    {
        if(count_6 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S502 = ViewRay_at_0(_S498, end_1.height_7);
        Probe_0 _S503 = probe_0(_S497, _S502.x, _S502.y, _S500, _S499.right_0, _S499.up_0);
        float _S504 = end_1.height_7 - _S503.height_3;
        float _S505 = ViewRay_rate_0(_S498, _S503);
        end_1.depth_1 = - _S504;
        end_1.rate_4 = _S505;
        bool _S506;
        if(end_1.previous_4.known_0)
        {
            _S506 = !_S503.hole_4;
        }
        else
        {
            _S506 = false;
        }
        bool _S507;
        if(_S506)
        {
            _S507 = (end_1.previous_4.yarn_0) == (_S503.yarn_1);
        }
        else
        {
            _S507 = false;
        }
        end_1.smooth_0 = _S507;
        bool _S508;
        if(!_S503.hole_4)
        {
            _S508 = _S504 <= 0.0f;
        }
        else
        {
            _S508 = false;
        }
        bool _S509;
        if(_S508)
        {
            _S509 = true;
        }
        else
        {
            _S509 = (end_1.height_7) <= _S501;
        }
        if(_S509)
        {
            break;
        }
        float _S510 = way_back_to_dip_0(end_1.previous_4, _S504, _S505, end_1.last_step_3, _S503);
        if(_S510 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S510;
            end_1.last_step_3 = end_1.last_step_3 - _S510;
            count_6 = count_6 + 1U;
            continue;
        }
        float _S511 = min(StepControl_to_cell_exit_0(_S499, _S503.side_x_0, _S503.side_y_0), end_1.height_7 - _S503.cell_max_0);
        float _S512 = StepControl_to_next_sample_0(_S499, _S503, _S504, _S505);
        end_1.previous_4 = after_sample_0(_S504, _S505, _S503, _S511 > _S512);
        float _S513 = max(_S511, _S512);
        end_1.last_step_3 = _S513;
        end_1.height_7 = end_1.height_7 - _S513;
        count_6 = count_6 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S514, ViewRay_0 _S515, StepControl_0 _S516, bool _S517, ViewRayEnd_0 _S518, uint _S519)
{
    float _S520 = fabrics_0[_S514].height_high_0 - fabrics_0[_S514].height_low_0;
    float above_2 = _S518.height_7 + _S518.last_step_3;
    float above_gap_1 = clamp(_S518.previous_4.clearance_0, 0.0f, _S520);
    float under_gap_1 = clamp(_S518.depth_1, 0.0f, _S520);
    float _S521 = cubic_root_0(above_gap_1, - under_gap_1, _S518.previous_4.rate_0 * _S518.last_step_3, _S518.rate_4 * _S518.last_step_3);
    float middle_0;
    if(_S518.smooth_0)
    {
        middle_0 = above_2 - _S521 * _S518.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S518.height_7, above_gap_1, under_gap_1);
    }
    float side_2 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S518.height_7;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S519)
        {
        }
        else
        {
            break;
        }
        float2 _S522 = ViewRay_at_0(_S515, middle_0);
        Probe_0 _S523 = probe_0(_S514, _S522.x, _S522.y, _S517, _S516.right_0, _S516.up_0);
        float _S524;
        if(_S523.hole_4)
        {
            _S524 = -1.0e+09f;
        }
        else
        {
            _S524 = _S523.height_3;
        }
        float _S525 = clamp(middle_0 - _S524, - _S520, _S520);
        float _S526;
        if(_S525 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S526 = 0.5f * above_gap_2;
            }
            else
            {
                _S526 = above_gap_2;
            }
            float _S527 = - _S525;
            under_1 = middle_0;
            above_gap_2 = _S526;
            under_gap_2 = _S527;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S526 = 0.5f * under_gap_2;
            }
            else
            {
                _S526 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S525;
            under_gap_2 = _S526;
            side_2 = -1.0f;
        }
        if(_S518.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S525 / min(ViewRay_rate_0(_S515, _S523), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S518.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S528, SearchQuality_0 _S529, float _S530, float _S531, float3 _S532, bool _S533)
{
    float _S534 = max(_S532.z, 0.00009999999747379f);
    ViewRay_0 ray_0;
    ray_0.origin_0 = float2(_S530, _S531);
    float2 _S535 = _S532.xy / _S534;
    ray_0.slope_1 = _S535;
    StepControl_0 _S536 = step_control_0(- _S535, 1.0f / max(steps_per_length_0(_S528, _S529, _S532) / _S534, 9.99999971718068537e-10f));
    ViewRayEnd_0 _S537 = search_down_0(_S528, ray_0, _S536, _S533);
    Hit_0 hit_0;
    hit_0.hole_5 = false;
    float _S538 = refined_height_0(_S528, ray_0, _S536, _S533, _S537, _S529.refinements_0);
    hit_0.height_5 = _S538;
    float2 _S539 = ViewRay_at_0(ray_0, _S538);
    hit_0.x_13 = _S539.x;
    hit_0.y_7 = _S539.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S540, SearchQuality_0 _S541, float _S542, float _S543, float3 _S544, bool _S545)
{
    if(!passes_through_0(_S540, _S541, _S542, _S543, _S544, _S545))
    {
        return first_hit_of_yarn_0(_S540, _S541, _S542, _S543, _S544, _S545);
    }
    Hit_0 hit_1;
    hit_1.x_13 = _S542;
    hit_1.y_7 = _S543;
    hit_1.height_5 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S546, float _S547, float _S548, bool _S549)
{
    Sample_0 _S550 = sample_at_0(_S546, _S547, _S548, _S549);
    float _S551;
    if(_S550.shown_3.is_warp_2)
    {
        _S551 = _S550.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S551 = _S550.crossing_2.weft_1.half_width_1;
    }
    uint _S552;
    if(_S550.shown_3.is_warp_2)
    {
        _S552 = fabrics_0[_S546].warp_0;
    }
    else
    {
        _S552 = fabrics_0[_S546].weft_0;
    }
    Family_0 _S553 = families_0.Load(_S552);
    float _S554;
    if(_S549)
    {
        _S554 = -1.0f;
    }
    else
    {
        _S554 = 1.0f;
    }
    float _S555 = _S553.twist_sine_0 * _S554;
    Family_0 _S556 = families_0.Load(_S552);
    if(_S550.shown_3.is_warp_2)
    {
        _S554 = 1.0f;
    }
    else
    {
        _S554 = -1.0f;
    }
    float2 _S557 = fibre_direction_0(_S550.slope_across_0, _S554 * _S550.slope_along_0, _S555, _S556.twist_cosine_0);
    float _S558;
    if(_S550.shown_3.is_warp_2)
    {
        _S558 = _S550.slope_x_1;
    }
    else
    {
        _S558 = _S550.slope_y_1;
    }
    float _S559;
    if(_S550.shown_3.is_warp_2)
    {
        _S559 = _S550.slope_y_1;
    }
    else
    {
        _S559 = _S550.slope_x_1;
    }
    float _S560 = _S557.x;
    float _S561 = _S557.y;
    float _S562 = _S558 * _S560 + _S554 * _S559 * _S561;
    float _S563 = _S551 * 1.0154266357421875f;
    float _S564 = _S563 * arc_sine_0(clamp(_S550.section_1.across_3 / _S563, -1.0f, 1.0f));
    if(_S550.shown_3.is_warp_2)
    {
        _S551 = _S548;
    }
    else
    {
        _S551 = - _S547;
    }
    SurfacePoint_0 point_3;
    point_3.hole_0 = _S550.shown_3.hole_3;
    point_3.is_warp_0 = _S550.shown_3.is_warp_2;
    point_3.warp_thread_0 = _S550.crossing_2.warp_1.thread_1;
    point_3.weft_thread_0 = _S550.crossing_2.weft_1.thread_1;
    point_3.height_1 = _S550.height_6;
    point_3.normal_1 = normalize(float3(- _S550.slope_x_1, - _S550.slope_y_1, 1.0f));
    float3 _S565;
    if(_S550.shown_3.is_warp_2)
    {
        _S565 = float3(_S560, _S561, _S562);
    }
    else
    {
        _S565 = float3(- _S561, _S560, _S562);
    }
    point_3.tangent_0 = normalize(_S565);
    point_3.across_0 = _S550.section_1.across_3;
    point_3.fibre_across_0 = _S564 * _S556.twist_cosine_0 + _S551 * _S555;
    point_3.fibre_along_0 = _S551 * _S556.twist_cosine_0 - _S564 * _S555;
    return point_3;
}

struct YarnPoint_0
{
    bool back_4;
    bool hole_6;
    bool is_warp_3;
    float x_14;
    float y_8;
    float height_10;
    float3 normal_7;
    float3 tangent_7;
    float roughness_10;
    Albedos_0 albedos_6;
};

Albedos_0 vary_albedos_0(uint _S566, Albedos_0 _S567, uint _S568, uint _S569)
{
    float3 _S570 = max(_S567.specular_reflect_0, _S567.specular_transmit_0);
    float3 _S571 = _S567.diffuse_reflect_0 + _S567.diffuse_transmit_0;
    float _S572 = bounded_gain_0(thread_gain_0(_S568, fabrics_0[_S566].colour_noise_0, fabrics_0[_S566].seed_0), _S571, 1.0f - fabrics_0[_S566].layer_bound_0 * _S570);
    float _S573 = bounded_gain_0(fibre_gain_0(_S568, _S569, fabrics_0[_S566].fibre_noise_0, fabrics_0[_S566].seed_0), _S570, min((1.0f - _S572 * _S571) / fabrics_0[_S566].layer_bound_0, (float3)1.0f));
    Albedos_0 varied_0;
    varied_0.diffuse_reflect_0 = _S572 * _S567.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S572 * _S567.diffuse_transmit_0;
    varied_0.specular_reflect_0 = _S573 * _S567.specular_reflect_0;
    varied_0.specular_transmit_0 = _S573 * _S567.specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S574, SurfacePoint_0 _S575, Albedos_0 _S576, float _S577, float _S578)
{
    float _S579;
    if(_S575.is_warp_0)
    {
        _S579 = _S577;
    }
    else
    {
        _S579 = _S578;
    }
    float _S580 = _S579 - _S575.across_0;
    uint _S581;
    if(_S575.is_warp_0)
    {
        _S581 = fabrics_0[_S574].warp_0;
    }
    else
    {
        _S581 = fabrics_0[_S574].weft_0;
    }
    Family_0 _S582 = families_0.Load(_S581);
    int _S583 = int(families_0.Load(_S581).count_0);
    if(_S575.is_warp_0)
    {
        _S581 = _S575.warp_thread_0;
    }
    else
    {
        _S581 = _S575.weft_thread_0;
    }
    uint _S584 = uint(int(floor(_S580 / _S582.period_0)) * _S583 + int(_S581)) * 2U;
    if(_S575.is_warp_0)
    {
        _S581 = 1U;
    }
    else
    {
        _S581 = 0U;
    }
    float _S585 = floor(_S575.fibre_across_0 / fabrics_0[_S574].fibre_size_0);
    return vary_albedos_0(_S574, _S576, _S584 + _S581, uint(int(_S585)) * 65536U + uint(int(floor(_S575.fibre_along_0 / (fabrics_0[_S574].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S585))));
}

YarnPoint_0 yarn_point_of_0(uint _S586, SurfacePoint_0 _S587, float _S588, float _S589, bool _S590, bool _S591)
{
    uint _S592;
    if(_S587.is_warp_0)
    {
        _S592 = fabrics_0[_S586].warp_0;
    }
    else
    {
        _S592 = fabrics_0[_S586].weft_0;
    }
    uint _S593;
    if(_S587.is_warp_0)
    {
        _S593 = _S587.warp_thread_0;
    }
    else
    {
        _S593 = _S587.weft_thread_0;
    }
    Albedos_0 albedos_7 = albedos_of_0(_S592, _S593);
    bool _S594;
    if((fabrics_0[_S586].fibre_noise_0) > 0.0f)
    {
        _S594 = true;
    }
    else
    {
        _S594 = (fabrics_0[_S586].colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_8;
    if(_S594)
    {
        albedos_8 = varied_at_0(_S586, _S587, albedos_7, _S588, _S589);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    YarnPoint_0 point_4;
    point_4.back_4 = _S590;
    point_4.hole_6 = _S591;
    point_4.is_warp_3 = _S587.is_warp_0;
    point_4.x_14 = _S588;
    point_4.y_8 = _S589;
    point_4.height_10 = _S587.height_1;
    point_4.normal_7 = _S587.normal_1;
    point_4.tangent_7 = _S587.tangent_0;
    point_4.roughness_10 = families_0.Load(_S592).roughness_0;
    point_4.albedos_6 = albedos_8;
    return point_4;
}

bool unoccluded_0(uint _S595, SearchQuality_0 _S596, float _S597, float _S598, float _S599, float3 _S600, bool _S601)
{
    if((_S600.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S595, _S596, float3(_S597, _S598, _S599 + fabrics_0[_S595].lift_0), _S600, _S601, max_height_along_0(_S595, _S597, _S598, _S599, _S600, _S601));
}

bool is_lit_0(uint _S602, SearchQuality_0 _S603, YarnPoint_0 _S604, float3 _S605)
{
    if(_S604.hole_6)
    {
        return true;
    }
    float3 _S606 = to_face_frame_0(_S605, _S604.back_4);
    float _S607 = _S606.z;
    bool _S608 = _S607 < 0.0f;
    float3 normal_8;
    float height_11;
    if(_S608)
    {
        SurfacePoint_0 _S609 = surface_at_0(_S602, _S604.x_14, _S604.y_8, !_S604.back_4);
        normal_8 = _S609.normal_1;
        height_11 = _S609.height_1;
    }
    else
    {
        normal_8 = _S604.normal_7;
        height_11 = _S604.height_10;
    }
    float3 _S610 = float3(_S606.xy, abs(_S607));
    if((dot(normal_8, _S610)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S602, _S603, _S604.x_14, _S604.y_8, height_11, _S610, (_S604.back_4) != _S608);
}

Components_0 components_of_point_0(uint _S611, SearchQuality_0 _S612, YarnPoint_0 _S613, float3 _S614, float3 _S615)
{
    Components_0 result_2 = no_components_0();
    float _S616;
    if(_S613.hole_6)
    {
        _S616 = 1.0f;
    }
    else
    {
        _S616 = 0.0f;
    }
    result_2.hole_2 = _S616;
    bool _S617;
    if(_S613.hole_6)
    {
        _S617 = true;
    }
    else
    {
        _S617 = !is_lit_0(_S611, _S612, _S613, _S614);
    }
    if(_S617)
    {
        return result_2;
    }
    float3 _S618 = to_face_frame_0(_S614, _S613.back_4);
    float3 _S619 = to_face_frame_0(_S615, _S613.back_4);
    bool _S620 = (_S618.z) < 0.0f;
    float3 _S621;
    if(_S620)
    {
        _S621 = - _S618;
    }
    else
    {
        _S621 = _S618;
    }
    float _S622 = diffuse_reflection_0(_S621, _S613.normal_7, fabrics_0[_S611].diffuse_blend_0);
    if(_S620)
    {
        _S616 = transmission_0(_S618, _S619, _S613.normal_7, _S613.tangent_7, _S613.roughness_10, fabrics_0[_S611].optical_depth_0);
    }
    else
    {
        _S616 = reflection_0(_S618, _S619, _S613.normal_7, _S613.tangent_7, _S613.roughness_10, fabrics_0[_S611].optical_depth_0);
    }
    float _S623;
    if(_S613.is_warp_3)
    {
        _S623 = _S622;
    }
    else
    {
        _S623 = 0.0f;
    }
    result_2.diffuse_warp_0 = _S623;
    if(_S613.is_warp_3)
    {
        _S623 = 0.0f;
    }
    else
    {
        _S623 = _S622;
    }
    result_2.diffuse_weft_0 = _S623;
    if(_S613.is_warp_3)
    {
        _S623 = _S616;
    }
    else
    {
        _S623 = 0.0f;
    }
    result_2.specular_warp_0 = _S623;
    if(_S613.is_warp_3)
    {
        _S616 = 0.0f;
    }
    result_2.specular_weft_0 = _S616;
    result_2.light_visibility_1 = 1.0f;
    return result_2;
}

struct CoverageTaps_0
{
    uint  nodes_1[int(9)];
};

float3 pyramid_level_0(uint _S624, float _S625)
{
    uint _S626 = fabrics_0[_S624].lobes_0.levels_0 + 4U * uint(min(_S625, fabrics_0[_S624].lobes_0.last_level_0));
    return float3(table_number_0(_S626), table_number_0(_S626 + 1U), table_number_0(_S626 + 2U));
}

CoverageTaps_0 coverage_taps_0(uint _S627, Footprint_0 _S628, bool _S629)
{
    Lobes_0 _S630 = fabrics_0[_S627].lobes_0;
    float _S631 = Footprint_spread_side_0(_S628) * fabrics_0[_S627].lobes_0.inverse_base_size_0;
    float3 _S632 = pyramid_level_0(_S627, floor(binary_logarithm_0(max(0.68000000715255737f * _S631, 1.0f))));
    float _S633 = 1.0f / max(_S631, 9.99999997475242708e-07f);
    float _S634 = min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S633 * _S633), 0.0f, 1.0f)), 0.3333333432674408f * _S633), 1.0f);
    float2 _S635 = float2(families_0.Load(fabrics_0[_S627].warp_0).inverse_period_0, families_0.Load(fabrics_0[_S627].weft_0).inverse_period_0);
    float2 _S636 = _S628.centre_0 * _S635;
    float2 _S637 = _S628.dx_0 * _S635 * _S634;
    float2 _S638 = _S628.dy_0 * _S635 * _S634;
    CoverageTaps_0 taps_3;
    uint number_2 = 0U;
    for(;;)
    {
        if(number_2 < 9U)
        {
        }
        else
        {
            break;
        }
        float2 _S639 = _S636 + TAP_OFFSETS_0[number_2].x * _S637 + TAP_OFFSETS_0[number_2].y * _S638;
        float _S640 = _S632.y;
        float _S641 = wrapped_cell_0(_S639.x, _S640);
        float _S642 = wrapped_cell_0(_S639.y, _S632.z);
        uint _S643;
        if(_S629)
        {
            _S643 = _S630.face_nodes_0;
        }
        else
        {
            _S643 = 0U;
        }
        taps_3.nodes_1[number_2] = _S643 + uint(_S642 * _S640 + _S641 + _S632.x);
        number_2 = number_2 + 1U;
    }
    return taps_3;
}

float4 coverage_of_pack_0(uint _S644, CoverageTaps_0 _S645, uint _S646)
{
    uint number_3 = 0U;
    uint even_1 = 0U;
    uint odd_1 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        uint _S647 = words_0.Load(fabrics_0[_S644].lobes_0.coverage_0 + _S645.nodes_1[number_3] * fabrics_0[_S644].lobes_0.packs_0 + _S646);
        uint even_2 = even_1 + (_S647 & 16711935U);
        uint odd_2 = odd_1 + ((_S647 >> int(8)) & 16711935U);
        number_3 = number_3 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / 9.0f;
}

float coverage_of_holes_0(uint _S648, CoverageTaps_0 _S649)
{
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
        uint total_1 = total_0 + ((words_0.Load(fabrics_0[_S648].lobes_0.coverage_holes_0 + _S649.nodes_1[number_4] / 4U) >> (8U * (_S649.nodes_1[number_4] % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S650, CoverageTaps_0 _S651, NodeTaps_0 _S652, bool _S653)
{
    Lobes_0 _S654 = fabrics_0[_S650].lobes_0;
    float _S655 = interpolate_table_0(_S652, fabrics_0[_S650].lobes_0.projected_area_0 + fabrics_0[_S650].lobes_0.packs_0, fabrics_0[_S650].lobes_0.packs_0 + 1U).x;
    float _S656;
    if(_S653)
    {
        _S656 = _S654.back_hole_weight_0;
    }
    else
    {
        _S656 = _S654.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S650, _S651) * _S655 * _S655 * _S656, 1.0f);
}

Components_0 prefiltered_components_0(uint _S657, Footprint_0 _S658, float3 _S659, float3 _S660, bool _S661)
{
    CoverageTaps_0 _S662 = coverage_taps_0(_S657, _S658, _S661);
    NodeTaps_0 _S663 = node_taps_0(_S660);
    NodeTaps_0 view_nodes_0 = _S663;
    NodeTaps_0 light_nodes_0 = node_taps_0(_S659);
    NodeTaps_0 seen_nodes_0 = _S663;
    uint _S664;
    if(_S661)
    {
        _S664 = 1U;
    }
    else
    {
        _S664 = 0U;
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + _S664 * 256U;
    uint _S665 = 2U * _S664;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + _S665 * 256U;
    uint _S666;
    if((_S659.z) < 0.0f)
    {
        _S666 = 1U;
    }
    else
    {
        _S666 = 0U;
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + (_S665 + _S666) * 256U;
    float3 _S667 = half_vector_0(_S659, _S660);
    float3 _S668 = shadow_correlation_0(_S659, _S660);
    if(_S661)
    {
        _S666 = fabrics_0[_S657].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S666 = fabrics_0[_S657].lobes_0.front_warp_packs_0;
    }
    Components_0 sums_1;
    sums_1.diffuse_warp_0 = 0.0f;
    sums_1.diffuse_weft_0 = 0.0f;
    sums_1.specular_warp_0 = 0.0f;
    sums_1.specular_weft_0 = 0.0f;
    sums_1.light_visibility_1 = 0.0f;
    uint pack_0 = 0U;
    float total_2 = 0.0f;
    for(;;)
    {
        Lobes_0 _S669 = fabrics_0[_S657].lobes_0;
        if(pack_0 < (fabrics_0[_S657].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        float4 _S670 = coverage_of_pack_0(_S657, _S662, pack_0);
        float4 _S671 = interpolate_table_0(view_nodes_0, _S669.projected_area_0 + pack_0, _S669.packs_0 + 1U);
        uint _S672 = _S669.light_visibility_0 + pack_0;
        float4 _S673 = interpolate_table_0(seen_nodes_0, _S672, _S669.packs_0) / 255.0f;
        float4 _S674 = interpolate_table_0(light_nodes_0, _S672, _S669.packs_0) / 255.0f;
        float4 _S675 = interpolate_table_0(light_nodes_0, _S669.irradiance_0 + pack_0, _S669.packs_0) * 0.00124827399849892f;
        bool _S676 = pack_0 < _S666;
        uint _S677;
        if(_S676)
        {
            _S677 = fabrics_0[_S657].warp_0;
        }
        else
        {
            _S677 = fabrics_0[_S657].weft_0;
        }
        Family_0 _S678 = families_0.Load(_S677);
        uint number_5 = 0U;
        float diffuse_0 = 0.0f;
        float specular_0 = 0.0f;
        for(;;)
        {
            if(number_5 < 4U)
            {
            }
            else
            {
                break;
            }
            Group_0 _S679 = group_at_0(_S669.moments_0 + 12U * (4U * (_S664 * _S669.packs_0 + pack_0) + number_5), _S678.roughness_0);
            float _S680 = _S670[number_5] * _S671[number_5] * _S671[number_5] * _S679.weight_1;
            float2 _S681 = visibility_gain_0(_S668, _S674[number_5], _S673[number_5]);
            float _S682 = _S681.x;
            float diffuse_1 = diffuse_0 + _S680 * _S675[number_5] * _S682;
            float specular_1 = specular_0 + _S680 * layer_value_0(_S679, _S667, _S659, _S660, fabrics_0[_S657].optical_depth_0) * _S674[number_5] * _S681.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S680 * _S674[number_5] * _S682;
            float total_3 = total_2 + _S680;
            number_5 = number_5 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S683;
        if(_S676)
        {
            _S683 = diffuse_0;
        }
        else
        {
            _S683 = 0.0f;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S683;
        float _S684;
        if(_S676)
        {
            _S684 = 0.0f;
        }
        else
        {
            _S684 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S684;
        float _S685;
        if(_S676)
        {
            _S685 = specular_0;
        }
        else
        {
            _S685 = 0.0f;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S685;
        float _S686;
        if(_S676)
        {
            _S686 = 0.0f;
        }
        else
        {
            _S686 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S686;
        pack_0 = pack_0 + 1U;
    }
    float _S687 = prefiltered_hole_0(_S657, _S662, view_nodes_0, _S661);
    sums_1.hole_2 = _S687;
    float _S688 = (1.0f - _S687) / max(total_2, 9.999999960041972e-13f);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S688;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S688;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S688;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S688;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S688;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S689, Footprint_0 _S690, bool _S691)
{
    float2 _S692 = _S690.dx_0;
    float2 _S693 = _S690.dy_0;
    float2 _S694 = sqrt(_S692 * _S692 + _S693 * _S693);
    Stretch_0 _S695 = stretch_of_0(fabrics_0[_S689].warp_0, _S690.centre_0.x, _S694.x);
    Stretch_0 _S696 = stretch_of_0(fabrics_0[_S689].weft_0, _S690.centre_0.y, _S694.y);
    FamilyAlbedos_0 albedos_9;
    albedos_9.warp_2 = mean_albedos_0(fabrics_0[_S689].warp_0, fabrics_0[_S689].weft_0, _S695, _S696, _S691);
    albedos_9.weft_2 = mean_albedos_0(fabrics_0[_S689].weft_0, fabrics_0[_S689].warp_0, _S696, _S695, _S691);
    return albedos_9;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S697, Footprint_0 _S698, float _S699, float2 _S700, float3 _S701, float3 _S702)
{
    float _S703;
    Regime_0 _S704 = regime_of_0(_S697, _S698, _S699);
    bool _S705 = (_S702.z) < 0.0f;
    float3 _S706 = to_face_frame_0(_S702, _S705);
    bool _S707;
    if((fabrics_0[_S697].fibre_noise_0) > 0.0f)
    {
        _S707 = true;
    }
    else
    {
        _S707 = (fabrics_0[_S697].colour_noise_0) > 0.0f;
    }
    bool _S708;
    if((families_0.Load(fabrics_0[_S697].warp_0).quantities_0) > 1U)
    {
        _S708 = true;
    }
    else
    {
        _S708 = (families_0.Load(fabrics_0[_S697].weft_0).quantities_0) > 1U;
    }
    float _S709 = 1.0f - _S704.prefiltered_0;
    if(_S709 > 0.0f)
    {
        if(_S707)
        {
            _S708 = true;
        }
    }
    else
    {
        _S708 = false;
    }
    Footprint_0 box_0 = _S698;
    float3 _S710 = (float3)0.0f;
    SurfacePoint_0 _S711 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S710, _S710, 0.0f, 0.0f, 0.0f);
    Components_0 _S712 = no_components_0();
    int _S713;
    if(_S708)
    {
        _S713 = int(0);
    }
    else
    {
        _S713 = int(1);
    }
    uint _S714 = uint(_S713);
    Components_0 points_1 = _S712;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S711;
    float2 central_place_0 = _S698.centre_0;
    uint number_6 = _S714;
    for(;;)
    {
        float _S715 = float(number_6);
        _S703 = _S704.points_0;
        if(_S715 < (_S704.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S716 = number_6 == 0U;
        uint _S717;
        if(_S716)
        {
            _S717 = 0U;
        }
        else
        {
            _S717 = number_6 - 1U;
        }
        float2 _S718 = POINT_OFFSETS_0[_S717] + _S700;
        float2 _S719;
        if(_S716)
        {
            _S719 = (float2)0.0f;
        }
        else
        {
            _S719 = _S718 - round(_S718);
        }
        float2 _S720 = _S698.centre_0 + _S719.x * _S698.dx_0 + _S719.y * _S698.dy_0;
        float _S721;
        if(_S716)
        {
            _S721 = 0.0f;
        }
        else
        {
            _S721 = _S704.threads_1;
        }
        SearchQuality_0 _S722 = quality_of_0(_S721);
        Hit_0 _S723 = first_hit_0(_S697, _S722, _S720.x, _S720.y, _S706, _S705);
        SurfacePoint_0 _S724 = surface_at_0(_S697, _S723.x_13, _S723.y_7, _S705);
        if(_S716)
        {
            float central_weight_1;
            if(_S723.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S709;
            }
            float2 central_place_1 = float2(_S723.x_13, _S723.y_7);
            box_0.centre_0 = lerp(_S698.centre_0, central_place_1, (float2)central_weight_1);
            central_weight_0 = central_weight_1;
            central_0 = _S724;
            central_place_0 = central_place_1;
            number_6 = number_6 + 1U;
            continue;
        }
        points_1 = with_added_0(points_1, components_of_point_0(_S697, _S722, yarn_point_of_0(_S697, _S724, _S723.x_13, _S723.y_7, _S705, _S723.hole_5), _S701, _S702), min(_S704.points_0 - float(number_6 - 1U), 1.0f));
        number_6 = number_6 + 1U;
    }
    Estimate_0 estimate_0;
    estimate_0.components_0 = with_added_0(_S712, points_1, _S709 / max(_S703, 1.0f));
    if((_S704.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S697, _S698, to_face_frame_0(_S701, _S705), _S706, _S705), _S704.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S697, box_0, _S705);
    if(_S707)
    {
        _S707 = central_weight_0 > 0.0f;
    }
    else
    {
        _S707 = false;
    }
    if(_S707)
    {
        SurfacePoint_0 _S725 = central_0;
        Albedos_0 _S726;
        if(central_0.is_warp_0)
        {
            _S726 = estimate_0.albedos_5.warp_2;
        }
        else
        {
            _S726 = estimate_0.albedos_5.weft_2;
        }
        Albedos_0 _S727 = lerp_albedos_0(_S726, varied_at_0(_S697, central_0, _S726, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S725.is_warp_0)
        {
            estimate_0.albedos_5.warp_2 = _S727;
        }
        else
        {
            estimate_0.albedos_5.weft_2 = _S727;
        }
    }
    return estimate_0;
}

float3 composed_0(uint _S728, Components_0 _S729, FamilyAlbedos_0 _S730, float3 _S731, float3 _S732)
{
    float3 _S733 = _S730.warp_2.diffuse_reflect_0 * _S729.diffuse_warp_0 + _S730.weft_2.diffuse_reflect_0 * _S729.diffuse_weft_0 + _S730.warp_2.specular_reflect_0 * _S729.specular_warp_0 + _S730.weft_2.specular_reflect_0 * _S729.specular_weft_0;
    float _S734 = _S732.z;
    float3 body_0;
    if((_S731.z * _S734) < 0.0f)
    {
        body_0 = _S730.warp_2.diffuse_transmit_0 * _S729.diffuse_warp_0 + _S730.weft_2.diffuse_transmit_0 * _S729.diffuse_weft_0 + _S730.warp_2.specular_transmit_0 * _S729.specular_warp_0 + _S730.weft_2.specular_transmit_0 * _S729.specular_weft_0;
    }
    else
    {
        body_0 = _S733;
    }
    float _S735 = fabrics_0[_S728].sheen_strength_0;
    if((fabrics_0[_S728].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S736 = _S734 < 0.0f;
    float2 _S737 = sheen_with_transmittance_0(to_face_frame_0(_S731, _S736), to_face_frame_0(_S732, _S736), _S735, fabrics_0[_S728].sheen_roughness_0);
    return _S737.y * body_0 + (_S729.light_visibility_1 + _S729.hole_2) * _S737.x;
}

float4 light_of_footprint_0(int _S738, uint _S739, VisiblePoint_0 _S740, uint2 _S741, float3 _S742)
{
    Footprint_0 footprint_0;
    footprint_0.centre_0 = _S740.draft_0;
    footprint_0.dx_0 = _S740.draft_dx_0;
    footprint_0.dy_0 = _S740.draft_dy_0;
    float2 _S743 = frac(float((frames_0[_S738].pass_number_0) & 65535U) * float2(0.75487768650054932f, 0.56984031200408936f));
    float3 _S744 = to_local_0(_S740, _S740.view_0);
    uint _S745 = light_sample_count_0(_S738);
    float3 _S746 = (float3)0.0f;
    uint number_7 = 0U;
    float3 radiance_1 = _S746;
    float hole_7 = 0.0f;
    for(;;)
    {
        if(number_7 < (max(_S745, 1U)))
        {
        }
        else
        {
            break;
        }
        float _S747;
        if(number_7 < _S745)
        {
            _S747 = visibility_at_0(_S738, number_7, _S741);
        }
        else
        {
            _S747 = 0.0f;
        }
        bool _S748;
        if(_S747 <= 0.0f)
        {
            _S748 = number_7 > 0U;
        }
        else
        {
            _S748 = false;
        }
        if(_S748)
        {
            number_7 = number_7 + 1U;
            continue;
        }
        LightSample_0 _S749 = light_sample_0(_S738, number_7, _S741, _S740.position_0);
        float3 _S750 = to_local_0(_S740, _S749.towards_0);
        Estimate_0 _S751 = lobes_estimate_of_pass_0(_S739, footprint_0, 1.0f, _S743, _S750, _S744);
        FamilyAlbedos_0 albedos_10;
        albedos_10.warp_2 = tinted_0(_S751.albedos_5.warp_2, _S742);
        albedos_10.weft_2 = tinted_0(_S751.albedos_5.weft_2, _S742);
        radiance_1 = radiance_1 + _S747 * _S749.irradiance_1 * composed_0(_S739, _S751.components_0, albedos_10, _S750, _S744);
        hole_7 = _S751.components_0.hole_2;
        number_7 = number_7 + 1U;
    }
    float _S752 = fabrics_0[_S739].sheen_strength_0;
    if((fabrics_0[_S739].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S752 * sheen_lobe_0(abs(_S744.z), fabrics_0[_S739].sheen_roughness_0).z);
    }
    return float4(radiance_1, 1.0f - hole_7);
}

[numthreads(8, 8, 1)]
void shade_lobes(uint3 id_0 : SV_DispatchThreadID)
{
    uint _S753 = frames_0[int(0)].width_0;
    bool _S754;
    if((id_0.x) >= (frames_0[int(0)].width_0))
    {
        _S754 = true;
    }
    else
    {
        _S754 = (id_0.y) >= (frames_0[int(0)].height_0);
    }
    if(_S754)
    {
        return;
    }
    uint _S755 = id_0.y * _S753 + id_0.x;
    uint _S756 = layers_0[_S755].face_0;
    if((layers_0[_S755].face_0) == 0U)
    {
        return;
    }
    uint _S757 = _S756 - 1U;
    uint _S758 = face_fabrics_0.Load(_S757);
    VisiblePoint_0 _S759 = visible_point_0(int(0), _S758, _S757, id_0.xy);
    accumulate_0(_S755, light_of_footprint_0(int(0), _S758, _S759, id_0.xy, filtered_albedo_0(_S758, _S759)));
    return;
}

