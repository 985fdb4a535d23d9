#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
constant array<float2, int(9)> TAP_OFFSETS_0 = { float2(-0.3333333432674408f, -0.3333333432674408f), float2(-0.3333333432674408f, 0.0f), float2(-0.3333333432674408f, 0.3333333432674408f), float2(0.0f, -0.3333333432674408f), float2(0.0f, 0.0f), float2(0.0f, 0.3333333432674408f), float2(0.3333333432674408f, -0.3333333432674408f), float2(0.3333333432674408f, 0.0f), float2(0.3333333432674408f, 0.3333333432674408f) };
constant array<float, int(4)> PYRAMID_RADII_0 = { 1.0f, 2.0f, 4.0f, 8.0f };
constant array<float2, int(8)> POINT_OFFSETS_0 = { float2(0.0f, 0.0f), float2(-0.23010000586509705f, 0.35670000314712524f), float2(0.36809998750686646f, -0.22939999401569366f), float2(-0.28040000796318054f, -0.34400001168251038f), float2(0.3465999960899353f, 0.28859999775886536f), float2(-0.36349999904632568f, 0.0511000007390976f), float2(0.09929999709129333f, -0.35699999332427979f), float2(0.10710000246763229f, 0.32879999279975891f) };
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

float3 position_of_0(const Vertex_0 thread* vertex_0)
{
    return float3(vertex_0->x_0, vertex_0->y_0, vertex_0->z_0);
}

float square_0(float3 v_1)
{
    return dot(v_1, v_1);
}

float3 normal_of_0(const Vertex_0 thread* vertex_1)
{
    return float3(vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

float square_1(float x_1)
{
    return x_1 * x_1;
}

float natural_logarithm_0(float x_2)
{
    uint _S1 = (as_type<uint>((x_2)));
    float exponent_0 = float(int(_S1 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S1 & 8388607U) | 1056964608U)));
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

float binary_logarithm_0(float x_3)
{
    return natural_logarithm_0(x_3) * 1.4426950216293335f;
}

float exponential_0(float x_4)
{
    float _S3 = clamp(x_4, -87.0f, 88.0f);
    float _S4 = floor(_S3 * 1.4426950216293335f + 0.5f);
    float _S5 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f;
    float _S6 = (as_type<float>((uint(int(_S4) + int(127)) << 23U)));
    float _S7;
    if(x_4 < -87.0f)
    {
        _S7 = 0.0f;
    }
    else
    {
        _S7 = (p_0 * _S5 * _S5 + _S5 + 1.0f) * _S6;
    }
    return _S7;
}

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

struct Layer_0
{
    uint face_0;
    float share_0;
};

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

struct Light_0
{
    uint is_point_0;
    float x_5;
    float y_1;
    float z_1;
    float red_0;
    float green_0;
    float blue_0;
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

struct KernelContext_0
{
    Frame_0 device* frames_0;
    Layer_0 device* layers_0;
    uint device* face_fabrics_0;
    Fabric_0 device* fabrics_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
    uint device* scene_words_0;
    float device* visibilities_0;
    Light_0 device* lights_1;
    Family_0 device* families_0;
    uint device* words_0;
    packed_float4 device* radiance_0;
};

float3 map_texel_0(uint index_0, KernelContext_0 thread* kernelContext_0)
{
    uint _S8 = kernelContext_0->scene_words_0[index_0];
    float3 _S9 = float3(float(_S8 & 1023U), float((_S8 >> 10U) & 1023U), float(_S8 >> 20U)) / float3(1023.0f) ;
    return _S9 * _S9;
}

float3 map_level_0(uint first_0, uint side_0, float2 uv_0, KernelContext_0 thread* kernelContext_1)
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
    uint _S22 = (_S20 + 1U) & _S17;
    float _S23 = _S12 - _S15;
    uint _S24 = first_0 + _S20 * side_0;
    float3 _S25 = map_texel_0(_S24 + _S18, kernelContext_1);
    float3 _S26 = map_texel_0(_S24 + _S21, kernelContext_1);
    float3 _S27 = float3(_S23) ;
    float3 _S28 = mix(_S25, _S26, _S27);
    uint _S29 = first_0 + _S22 * side_0;
    float3 _S30 = map_texel_0(_S29 + _S18, kernelContext_1);
    float3 _S31 = map_texel_0(_S29 + _S21, kernelContext_1);
    return mix(_S28, mix(_S30, _S31, _S27), float3((_S14 - _S19)) );
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

float3 to_local_0(const VisiblePoint_0 thread* point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0->axis_x_0), dot(direction_0, point_0->axis_y_0), dot(direction_0, point_0->normal_0));
}

uint scramble_0(uint value_0)
{
    uint _S32 = value_0 * 747796405U + 2891336453U;
    uint _S33 = ((_S32 >> ((_S32 >> 28U) + 4U)) ^ _S32) * 277803737U;
    return (_S33 >> 22U) ^ _S33;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_1, uint stream_1)
{
    uint _S34 = pixel_0.x;
    uint _S35 = pixel_0.y;
    return fract(float2(uniform_hash_0(_S34, _S35, stream_1), uniform_hash_0(_S34, _S35, stream_1 + 1U)) + float2(float(index_1 & 65535U))  * float2(0.75487768650054932f, 0.56984031200408936f));
}

float scene_number_0(uint index_2, KernelContext_0 thread* kernelContext_2)
{
    return (as_type<float>((kernelContext_2->scene_words_0[index_2])));
}

struct Choice_0
{
    uint index_3;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_1, float number_0, KernelContext_0 thread* kernelContext_3)
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
        uint _S36 = (low_0 + high_0) / 2U;
        float _S37 = scene_number_0(table_0 + _S36, kernelContext_3);
        if(_S37 <= number_0)
        {
            low_0 = _S36;
        }
        else
        {
            high_0 = _S36;
        }
    }
    uint _S38 = table_0 + low_0;
    float _S39 = scene_number_0(_S38, kernelContext_3);
    float _S40 = scene_number_0(_S38 + 1U, kernelContext_3);
    thread Choice_0 choice_0;
    (&choice_0)->index_3 = low_0;
    (&choice_0)->remainder_0 = saturate((number_0 - _S39) / max(_S40 - _S39, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_6)
{
    float _S41 = floor(x_6 * 0.63661974668502808f + 0.5f);
    float _S42 = x_6 - _S41 * 1.5703125f - _S41 * 0.00048375129699707f - _S41 * 7.54979012640433211e-08f;
    float _S43 = _S42 * _S42;
    float _S44 = ((-0.00019515295571182f * _S43 + 0.00833216123282909f) * _S43 - 0.16666655242443085f) * _S43 * _S42 + _S42;
    float _S45 = ((0.00002443315679557f * _S43 - 0.00138873164542019f) * _S43 + 0.04166664555668831f) * _S43 * _S43 - 0.5f * _S43 + 1.0f;
    uint _S46 = uint(int(_S41)) & 3U;
    float2 _S47;
    if((_S46 & 1U) != 0U)
    {
        _S47 = float2(_S45, _S44);
    }
    else
    {
        _S47 = float2(_S44, _S45);
    }
    float _S48;
    if((_S46 & 2U) != 0U)
    {
        _S48 = - _S47.x;
    }
    else
    {
        _S48 = _S47.x;
    }
    float _S49;
    if(((_S46 + 1U) & 2U) != 0U)
    {
        _S49 = - _S47.y;
    }
    else
    {
        _S49 = _S47.y;
    }
    return float2(_S48, _S49);
}

struct Footprint_0
{
    float2 centre_0;
    float2 dx_0;
    float2 dy_0;
};

float Footprint_spread_side_0(const Footprint_0 thread* this_0)
{
    return sqrt(0.5f * (dot(this_0->dx_0, this_0->dx_0) + dot(this_0->dy_0, this_0->dy_0)));
}

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S50 = direction_1.xy;
    float _S51;
    if(back_1)
    {
        _S51 = - direction_1.z;
    }
    else
    {
        _S51 = direction_1.z;
    }
    return float3(_S50, _S51);
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
    thread SurfacePoint_0 _S52;
    (&_S52)->hole_0 = hole_1;
    (&_S52)->is_warp_0 = is_warp_1;
    (&_S52)->warp_thread_0 = warp_thread_1;
    (&_S52)->weft_thread_0 = weft_thread_1;
    (&_S52)->height_1 = height_2;
    (&_S52)->normal_1 = normal_2;
    (&_S52)->tangent_0 = tangent_1;
    (&_S52)->across_0 = across_1;
    (&_S52)->fibre_across_0 = fibre_across_1;
    (&_S52)->fibre_along_0 = fibre_along_1;
    return _S52;
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
    thread Components_0 nothing_0;
    (&nothing_0)->diffuse_warp_0 = 0.0f;
    (&nothing_0)->diffuse_weft_0 = 0.0f;
    (&nothing_0)->specular_warp_0 = 0.0f;
    (&nothing_0)->specular_weft_0 = 0.0f;
    (&nothing_0)->light_visibility_1 = 0.0f;
    (&nothing_0)->hole_2 = 0.0f;
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
    float _S53 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    thread SearchQuality_0 quality_0;
    float _S54 = mix(2.5f, 5.0f, _S53);
    (&quality_0)->steps_per_thread_0 = _S54;
    (&quality_0)->steps_per_relief_0 = _S54;
    (&quality_0)->shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S53);
    (&quality_0)->refinements_0 = uint(mix(1.0f, 2.0f, _S53) + 0.5f);
    return quality_0;
}

float2 turns_and_remainder_0(uint family_0, float index_4, KernelContext_0 thread* kernelContext_4)
{
    float _S55 = floor(fma(index_4, kernelContext_4->families_0[family_0].inverse_count_0, kernelContext_4->families_0[family_0].half_inverse_count_0));
    return float2(_S55, fma(- _S55, kernelContext_4->families_0[family_0].count_0, index_4));
}

struct Cell_0
{
    uint thread_1;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1, KernelContext_0 thread* kernelContext_5)
{
    float _S56 = floor(position_1 * kernelContext_5->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_1;
    float _S57 = fma(- _S56, kernelContext_5->families_0[family_1].size_0, position_1);
    (&cell_1)->below_0 = _S57;
    (&cell_1)->above_0 = kernelContext_5->families_0[family_1].size_0 - _S57;
    (&cell_1)->across_2 = _S57 - 0.5f * kernelContext_5->families_0[family_1].size_0;
    (&cell_1)->half_width_1 = kernelContext_5->families_0[family_1].half_width_0;
    float2 _S58 = turns_and_remainder_0(family_1, _S56, kernelContext_5);
    (&cell_1)->thread_1 = uint(clamp(_S58.y, 0.0f, kernelContext_5->families_0[family_1].count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_5, KernelContext_0 thread* kernelContext_6)
{
    return (as_type<float>((kernelContext_6->words_0[index_5])));
}

float table_number_1(uint index_6, KernelContext_0 thread* kernelContext_7)
{
    return (as_type<float>((kernelContext_7->words_0[index_6])));
}

Cell_0 locate_varied_0(uint family_2, float position_2, KernelContext_0 thread* kernelContext_8)
{
    float turns_0 = (position_2 - kernelContext_8->families_0[family_2].start_0) * kernelContext_8->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S59 = turns_1 * kernelContext_8->families_0[family_2].period_0;
    uint thread_2 = kernelContext_8->words_0[kernelContext_8->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_8->families_0[family_2].bins_0, 0.0f, kernelContext_8->families_0[family_2].bins_0 - 1.0f))];
    float _S60 = table_number_0(kernelContext_8->families_0[family_2].place_table_0 + thread_2 * 4U + 1U, kernelContext_8);
    uint _S61;
    if(_S59 >= _S60)
    {
        _S61 = 1U;
    }
    else
    {
        _S61 = 0U;
    }
    uint _S62 = min(thread_2 + _S61, uint(kernelContext_8->families_0[family_2].count_0) - 1U);
    uint _S63 = kernelContext_8->families_0[family_2].place_table_0 + _S62 * 4U;
    thread Cell_0 cell_2;
    (&cell_2)->thread_1 = _S62;
    float _S64 = table_number_0(_S63, kernelContext_8);
    (&cell_2)->below_0 = _S59 - _S64;
    float _S65 = table_number_0(_S63 + 1U, kernelContext_8);
    (&cell_2)->above_0 = _S65 - _S59;
    float _S66 = table_number_0(_S63 + 2U, kernelContext_8);
    (&cell_2)->across_2 = _S59 - _S66;
    float _S67 = table_number_0(_S63 + 3U, kernelContext_8);
    (&cell_2)->half_width_1 = _S67;
    return cell_2;
}

Cell_0 locate_0(uint family_3, float position_3, KernelContext_0 thread* kernelContext_9)
{
    if((kernelContext_9->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S68 = locate_alike_0(family_3, position_3, kernelContext_9);
        return _S68;
    }
    Cell_0 _S69 = locate_varied_0(family_3, position_3, kernelContext_9);
    return _S69;
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

Shown_0 shown_at_0(const Crossing_0 thread* crossing_0, bool back_2)
{
    bool _S70 = (abs((&crossing_0->warp_1)->across_2)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S71 = (abs((&crossing_0->weft_1)->across_2)) < ((&crossing_0->weft_1)->half_width_1);
    thread Shown_0 shown_0;
    bool _S72;
    if(_S70)
    {
        if(!_S71)
        {
            _S72 = true;
        }
        else
        {
            _S72 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S72 = false;
    }
    (&shown_0)->is_warp_2 = _S72;
    if(!_S70)
    {
        _S72 = !_S71;
    }
    else
    {
        _S72 = false;
    }
    (&shown_0)->hole_3 = _S72;
    uint _S73;
    if((&shown_0)->is_warp_2)
    {
        _S73 = crossing_0->warp_word_0;
    }
    else
    {
        _S73 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S73;
    (&shown_0)->on_top_0 = ((_S73 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_1, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_3;
    uint _S74;
    if(is_first_0)
    {
        _S74 = first_1->thread_1;
    }
    else
    {
        _S74 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S74;
    float _S75;
    if(is_first_0)
    {
        _S75 = first_1->across_2;
    }
    else
    {
        _S75 = second_0->across_2;
    }
    (&cell_3)->across_2 = _S75;
    if(is_first_0)
    {
        _S75 = first_1->half_width_1;
    }
    else
    {
        _S75 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S75;
    if(is_first_0)
    {
        _S75 = first_1->below_0;
    }
    else
    {
        _S75 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S75;
    if(is_first_0)
    {
        _S75 = first_1->above_0;
    }
    else
    {
        _S75 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S75;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0, KernelContext_0 thread* kernelContext_10)
{
    float2 _S76 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0), kernelContext_10);
    float _S77 = _S76.x;
    Family_0 _S78 = kernelContext_10->families_0[family_4];
    float _S79 = table_number_0(kernelContext_10->families_0[family_4].place_table_0 + uint(_S76.y) * 4U, kernelContext_10);
    return fma(_S77, _S78.period_0, _S79);
}

float span_0(uint family_5, uint thread_4, int first_2, int last_0, KernelContext_0 thread* kernelContext_11)
{
    if((kernelContext_11->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_2) * kernelContext_11->families_0[family_5].size_0;
    }
    float _S80 = boundary_0(family_5, thread_4, last_0, kernelContext_11);
    float _S81 = boundary_0(family_5, thread_4, first_2, kernelContext_11);
    return _S80 - _S81;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_5, KernelContext_0 thread* kernelContext_12)
{
    Family_0 _S82 = kernelContext_12->families_0[family_6];
    uint _S83;
    if((kernelContext_12->families_0[family_6].is_alike_0) != 0U)
    {
        _S83 = 0U;
    }
    else
    {
        _S83 = thread_5 * 4U;
    }
    uint _S84 = _S82.bend_table_0 + _S83;
    thread Bend_0 bend_0;
    float _S85 = table_number_0(_S84, kernelContext_12);
    (&bend_0)->sine_0 = _S85;
    float _S86 = table_number_0(_S84 + 1U, kernelContext_12);
    (&bend_0)->half_tangent_0 = _S86;
    float _S87 = table_number_0(_S84 + 2U, kernelContext_12);
    (&bend_0)->arc_0 = _S87;
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_6, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_13)
{
    int _S88 = int((word_1 >> 1U) & 127U);
    int _S89 = int((word_1 >> 8U) & 127U);
    int _S90 = int((word_1 >> 15U) & 63U);
    int _S91 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S92 = crossed_0->below_0;
    uint _S93 = crossed_0->thread_1;
    int _S94 = - _S88;
    float _S95 = span_0(other_0, crossed_0->thread_1, _S94, int(0), kernelContext_13);
    float _S96 = _S92 + _S95;
    (&run_0)->from_start_0 = _S96;
    float _S97 = crossed_0->above_0;
    int _S98 = _S89 + int(1);
    float _S99 = span_0(other_0, _S93, int(1), _S98, kernelContext_13);
    float _S100 = _S97 + _S99;
    (&run_0)->to_end_0 = _S100;
    bool _S101 = _S96 < _S100;
    (&run_0)->near_start_0 = _S101;
    int _S102;
    if(_S101)
    {
        _S102 = _S94 - _S90;
    }
    else
    {
        _S102 = _S98;
    }
    int _S103;
    if((&run_0)->near_start_0)
    {
        _S103 = _S94;
    }
    else
    {
        _S103 = _S98 + _S91;
    }
    Bend_0 _S104 = bend_of_0(own_0, thread_6, kernelContext_13);
    (&run_0)->bend_1 = _S104;
    float _S105;
    if((&run_0)->straight_0)
    {
        _S105 = 1.0e+06f;
    }
    else
    {
        _S105 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S105;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S106 = span_0(other_0, _S93, _S102, _S103, kernelContext_13);
    (&run_0)->other_reach_0 = min(0.5f * _S106, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S88 == int(0);
    (&run_0)->last_crossing_0 = _S89 == int(0);
    return run_0;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(const Cell_0 thread* cell_4)
{
    float _S107 = cell_4->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S108 = clamp(cell_4->across_2, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_3 = _S108;
    float _S109 = _S107 * _S107 - square_1(_S108);
    float _S110 = rsqrt(_S109);
    (&section_0)->drop_0 = _S107 - _S109 * _S110;
    (&section_0)->slope_0 = - _S108 * _S110;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_7, int step_1, KernelContext_0 thread* kernelContext_14)
{
    if((kernelContext_14->families_0[family_7].is_alike_0) != 0U)
    {
        float _S111 = table_number_0(kernelContext_14->families_0[family_7].bend_table_0 + 3U, kernelContext_14);
        return _S111;
    }
    Family_0 _S112 = kernelContext_14->families_0[family_7];
    float2 _S113 = turns_and_remainder_0(family_7, float(int(thread_7) + step_1), kernelContext_14);
    float _S114 = table_number_0(_S112.bend_table_0 + uint(_S113.y) * 4U + 3U, kernelContext_14);
    return _S114;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_15)
{
    float _S115 = crossed_1->below_0;
    float _S116 = crossed_1->above_0;
    bool _S117 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S118 = min(crossed_1->below_0, crossed_1->above_0);
    float _S119;
    if(_S117)
    {
        _S119 = _S115 - crossed_1->across_2;
    }
    else
    {
        _S119 = _S116 + crossed_1->across_2;
    }
    float _S120 = _S119 - crossed_1->half_width_1;
    bool _S121;
    if(_S117)
    {
        _S121 = run_1->first_crossing_0;
    }
    else
    {
        _S121 = run_1->last_crossing_0;
    }
    bool _S122 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S119 = 0.0f;
    }
    else
    {
        Family_0 _S123 = kernelContext_15->families_0[other_1];
        float _S124 = edge_drop_0(other_1, crossed_1->thread_1, int(0), kernelContext_15);
        _S119 = _S123.height_scale_0 * _S124;
    }
    float _S125;
    if(_S122 != _S121)
    {
        _S125 = 0.0f;
    }
    else
    {
        Family_0 _S126 = kernelContext_15->families_0[other_1];
        uint _S127 = crossed_1->thread_1;
        int _S128;
        if(_S117)
        {
            _S128 = int(-1);
        }
        else
        {
            _S128 = int(1);
        }
        float _S129 = edge_drop_0(other_1, _S127, _S128, kernelContext_15);
        _S125 = _S126.height_scale_0 * _S129;
    }
    float _S130 = 1.0f / max(2.0f * _S120, 9.999999960041972e-13f);
    float _S131 = clamp((_S120 - _S118) * _S130, 0.0f, 1.0f);
    float _S132 = _S119 + (_S125 - _S119) * (_S131 * _S131 * (3.0f - 2.0f * _S131));
    float _S133 = (_S119 - _S125) * (6.0f * _S131 * (1.0f - _S131) * _S130);
    if(_S117)
    {
        _S119 = 1.0f;
    }
    else
    {
        _S119 = -1.0f;
    }
    return float2(_S132, _S133 * _S119);
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
    thread StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S134 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S134), 9.99999971718068537e-10f);
    float _S135 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S135), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S134 > 0.0f;
    (&control_0)->up_0 = _S135 > 0.0f;
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
    thread PreviousSample_0 previous_0;
    (&previous_0)->clearance_0 = 0.0f;
    (&previous_0)->rate_0 = 0.0f;
    (&previous_0)->yarn_0 = 0U;
    (&previous_0)->known_0 = false;
    return previous_0;
}

float outline_distance_0(const Cell_0 thread* cell_5, const Shown_0 thread* shown_2, const Run_0 thread* run_2, bool lengthwise_0, bool forwards_0)
{
    float _S136;
    if(forwards_0)
    {
        _S136 = cell_5->across_2;
    }
    else
    {
        _S136 = - cell_5->across_2;
    }
    float _S137;
    if(forwards_0)
    {
        _S137 = cell_5->above_0;
    }
    else
    {
        _S137 = cell_5->below_0;
    }
    bool _S138;
    if(forwards_0)
    {
        _S138 = run_2->last_crossing_0;
    }
    else
    {
        _S138 = run_2->first_crossing_0;
    }
    bool _S139;
    if(forwards_0)
    {
        _S139 = run_2->first_crossing_0;
    }
    else
    {
        _S139 = run_2->last_crossing_0;
    }
    float _S140 = cell_5->half_width_1;
    float _S141 = - cell_5->half_width_1;
    bool _S142 = _S136 < _S141;
    bool _S143 = _S136 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S138 = !_S138;
    }
    else
    {
        _S138 = false;
    }
    if(_S138)
    {
        _S138 = !shown_2->hole_3;
    }
    else
    {
        _S138 = false;
    }
    bool _S144;
    if(_S138)
    {
        _S144 = shown_2->on_top_0;
    }
    else
    {
        _S144 = false;
    }
    if(_S144)
    {
        if(_S139)
        {
            _S139 = _S142;
        }
        else
        {
            _S139 = false;
        }
        _S139 = !_S139;
    }
    else
    {
        _S139 = false;
    }
    if(shown_2->hole_3)
    {
        _S138 = true;
    }
    else
    {
        if(_S138)
        {
            _S138 = !shown_2->on_top_0;
        }
        else
        {
            _S138 = false;
        }
    }
    float _S145;
    if(_S142)
    {
        _S145 = _S141;
    }
    else
    {
        _S145 = _S140;
    }
    float _S146 = _S145 - _S136;
    if(_S138)
    {
        _S136 = 2.0f * _S137 + _S136 - _S140;
    }
    else
    {
        _S136 = _S137;
    }
    if(_S139)
    {
        if(forwards_0)
        {
            _S136 = run_2->to_end_0;
        }
        else
        {
            _S136 = run_2->from_start_0;
        }
        return _S136;
    }
    if(_S143)
    {
    }
    else
    {
        _S136 = _S146;
    }
    return _S136;
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

float way_back_to_dip_0(const PreviousSample_0 thread* previous_1, float clearance_1, float rate_1, float step_4, const Probe_0 thread* here_0)
{
    float _S147 = previous_1->rate_0;
    float _S148 = previous_1->rate_0 * step_4;
    float _S149 = rate_1 * step_4;
    bool _S150;
    if(!previous_1->known_0)
    {
        _S150 = true;
    }
    else
    {
        _S150 = here_0->hole_4;
    }
    if(_S150)
    {
        _S150 = true;
    }
    else
    {
        _S150 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S150)
    {
        _S150 = true;
    }
    else
    {
        _S150 = _S147 >= 0.0f;
    }
    if(_S150)
    {
        _S150 = true;
    }
    else
    {
        _S150 = rate_1 <= 0.0f;
    }
    if(_S150)
    {
        return -1.0f;
    }
    float _S151 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S148) >= 0.0f)
    {
        _S150 = (3.0f * clearance_1 - _S149) >= 0.0f;
    }
    else
    {
        _S150 = false;
    }
    if(_S150)
    {
        return -1.0f;
    }
    float _S152 = clearance_1 - _S151;
    float _S153 = 6.0f * _S152 - 4.0f * _S148 - 2.0f * _S149;
    float _S154 = -2.0f * _S148 / max(_S153 + sqrt(max(_S153 * _S153 - 4.0f * (3.0f * (_S148 + _S149 - 2.0f * _S152)) * _S148, 0.0f)), 9.99999968265522539e-21f);
    float _S155 = 1.0f - _S154;
    float _S156 = (_S151 * (2.0f * _S154 + 1.0f) + _S148 * _S154) * _S155 * _S155;
    float _S157 = (clearance_1 * (2.0f * _S155 + 1.0f) - _S149 * _S155) * _S154 * _S154;
    if(_S154 > 0.01999999955296516f)
    {
        _S150 = _S155 > 0.01999999955296516f;
    }
    else
    {
        _S150 = false;
    }
    if(_S150)
    {
        _S150 = (_S156 + _S157) < 0.0f;
    }
    else
    {
        _S150 = false;
    }
    float _S158;
    if(_S150)
    {
        _S158 = _S155 * step_4;
    }
    else
    {
        _S158 = -1.0f;
    }
    return _S158;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S159 = here_1->hole_4;
    float _S160;
    if(here_1->hole_4)
    {
        _S160 = 1.0e+09f;
    }
    else
    {
        _S160 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S160;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S161;
    if(!_S159)
    {
        _S161 = !is_cell_exit_0;
    }
    else
    {
        _S161 = false;
    }
    (&previous_2)->known_0 = _S161;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1->per_x_0, side_y_1 * this_1->per_y_0), 0.0f) + this_1->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_2, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S162 = min(here_2->edge_x_0 * this_2->per_x_0, here_2->edge_y_0 * this_2->per_y_0);
    bool _S163;
    if(!here_2->hole_4)
    {
        _S163 = (rate_3 * _S162 + clearance_3) < 0.0f;
    }
    else
    {
        _S163 = false;
    }
    if(_S163)
    {
        _S163 = _S162 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S163 = false;
    }
    float _S164 = this_2->step_2;
    float _S165;
    if(_S163)
    {
        _S165 = _S162 - this_2->epsilon_0;
    }
    else
    {
        _S165 = max(_S162, 0.0f) + this_2->epsilon_0;
    }
    return min(_S164, _S165);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_3, float height_4)
{
    return this_3->origin_0 + this_3->slope_1 * float2(height_4) ;
}

float ViewRay_rate_0(const ViewRay_0 thread* this_4, const Probe_0 thread* here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S166 = end_0 - start_1;
    float _S167 = start_rate_0 + end_rate_0 - 2.0f * _S166;
    float _S168 = 3.0f * _S166 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S166, 9.99999968265522539e-21f);
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
        float _S169 = clamp(share_1 - (((_S167 * share_1 + _S168) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S167 * share_1 + 2.0f * _S168) * share_1 + start_rate_0, 0.10000000149011612f * _S166 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S170 = i_0 + int(1);
        share_1 = _S169;
        i_0 = _S170;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S171 = along_slope_0 * along_slope_0 + 1.0f;
    float _S172 = rsqrt(_S171);
    float _S173 = sine_1 * _S172 * rsqrt(_S171 + across_slope_0 * across_slope_0);
    return float2(- _S173 * _S171, _S173 * across_slope_0 * along_slope_0 + cosine_0 * _S172);
}

float arc_sine_0(float x_7)
{
    float _S174 = abs(x_7);
    bool _S175 = _S174 > 0.5f;
    float _S176;
    if(_S175)
    {
        _S176 = 0.5f * (1.0f - _S174);
    }
    else
    {
        _S176 = _S174 * _S174;
    }
    float _S177;
    if(_S175)
    {
        _S177 = sqrt(max(_S176, 0.0f));
    }
    else
    {
        _S177 = _S174;
    }
    float _S178 = ((((0.04216320067644119f * _S176 + 0.02418131195008755f) * _S176 + 0.04547002539038658f) * _S176 + 0.07495300471782684f) * _S176 + 0.16666752099990845f) * _S176 * _S177 + _S177;
    if(_S175)
    {
        _S176 = 1.57079637050628662f - 2.0f * _S178;
    }
    else
    {
        _S176 = _S178;
    }
    if(x_7 < 0.0f)
    {
        _S176 = - _S176;
    }
    return _S176;
}

float3 table_colour_0(uint index_7, KernelContext_0 thread* kernelContext_16)
{
    float _S179 = table_number_1(index_7, kernelContext_16);
    float _S180 = table_number_1(index_7 + 1U, kernelContext_16);
    float _S181 = table_number_1(index_7 + 2U, kernelContext_16);
    return float3(_S179, _S180, _S181);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0, KernelContext_0 thread* kernelContext_17)
{
    thread Albedos_0 albedos_0;
    float3 _S182 = table_colour_0(row_0, kernelContext_17);
    (&albedos_0)->diffuse_reflect_0 = _S182;
    float3 _S183 = table_colour_0(row_0 + 3U, kernelContext_17);
    (&albedos_0)->diffuse_transmit_0 = _S183;
    float3 _S184 = table_colour_0(row_0 + 6U, kernelContext_17);
    (&albedos_0)->specular_reflect_0 = _S184;
    float3 _S185 = table_colour_0(row_0 + 9U, kernelContext_17);
    (&albedos_0)->specular_transmit_0 = _S185;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_8, KernelContext_0 thread* kernelContext_18)
{
    Albedos_0 _S186 = table_albedos_0(kernelContext_18->families_0[family_8].albedo_table_0 + kernelContext_18->families_0[family_8].albedo_stride_0 * thread_8, kernelContext_18);
    return _S186;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S187 = room_0 / max(albedo_0, float3(9.99999997475242708e-07f) );
    return min(gain_1, max(min(min(_S187.x, _S187.y), _S187.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float diffuse_reflection_0(float3 light_0, float3 normal_3, float blend_0)
{
    float _S188 = light_0.z;
    if(_S188 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S188, 0.0f), max(dot(light_0, normal_3), 0.0f), blend_0);
}

float projected_area_1(float3 direction_3, float3 tangent_2, float roughness_1)
{
    float _S189 = dot(direction_3, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S189 * _S189 + 1.0f, roughness_1 * roughness_1));
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
    float _S190 = roughness_2 * roughness_2;
    float _S191 = squared_along_0 * (1.0f - _S190) + _S190;
    return 0.31830987334251404f * _S190 * roughness_2 / (_S191 * _S191);
}

float density_between_0(float3 light_1, float3 view_1, float3 tangent_3, float roughness_3)
{
    float3 _S192 = light_1 + view_1;
    float _S193 = dot(_S192, tangent_3);
    return flake_density_0(min(_S193 * _S193 / max(square_0(_S192), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float transmission_0(float3 light_2, float3 view_2, float3 normal_4, float3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S194 = - dot(light_2, normal_4);
    float _S195 = dot(view_2, normal_4);
    bool _S196;
    if(_S194 <= 0.0f)
    {
        _S196 = true;
    }
    else
    {
        _S196 = _S195 <= 0.0f;
    }
    if(_S196)
    {
        return 0.0f;
    }
    float _S197 = 1.0f / max(_S195, 9.99999997475242708e-07f);
    float _S198 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S194, 9.99999997475242708e-07f);
    float _S199 = projected_area_1(view_2, tangent_4, roughness_4) * _S197;
    return density_between_0(light_2, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S198, _S199)) * mean_attenuation_0(optical_depth_1 * abs(_S198 - _S199)) * _S197;
}

float reflection_0(float3 light_3, float3 view_3, float3 normal_5, float3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S200 = dot(light_3, normal_5);
    bool _S201;
    if(_S200 <= 0.0f)
    {
        _S201 = true;
    }
    else
    {
        _S201 = (dot(view_3, normal_5)) <= 0.0f;
    }
    if(_S201)
    {
        return 0.0f;
    }
    float _S202 = max(_S200, 9.99999997475242708e-07f);
    float _S203 = max(dot(view_3, normal_5), 9.99999997475242708e-07f);
    float _S204 = projected_area_1(light_3, tangent_5, roughness_5) * _S203 + projected_area_1(view_3, tangent_5, roughness_5) * _S202;
    float _S205 = optical_depth_2 * _S204 / (_S202 * _S203);
    return 0.25f * density_between_0(light_3, view_3, tangent_5, roughness_5) * (_S205 * mean_attenuation_0(_S205)) * _S202 / _S204;
}

Components_0 with_added_0(const Components_0 thread* sums_0, const Components_0 thread* more_0, float weight_0)
{
    thread Components_0 result_0;
    (&result_0)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_0 * more_0->diffuse_warp_0;
    (&result_0)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_0 * more_0->diffuse_weft_0;
    (&result_0)->specular_warp_0 = sums_0->specular_warp_0 + weight_0 * more_0->specular_warp_0;
    (&result_0)->specular_weft_0 = sums_0->specular_weft_0 + weight_0 * more_0->specular_weft_0;
    (&result_0)->light_visibility_1 = sums_0->light_visibility_1 + weight_0 * more_0->light_visibility_1;
    (&result_0)->hole_2 = sums_0->hole_2 + weight_0 * more_0->hole_2;
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
    float _S206 = abs(x_9);
    float _S207 = abs(y_3);
    float angle_0 = arc_tangent_of_ratio_0(min(_S206, _S207) / max(max(_S206, _S207), 1.00000000317107685e-30f));
    float angle_1;
    if(_S207 > _S206)
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
    float _S208 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S209 = floor(_S208);
    float _S210 = _S208 - _S209;
    float _S211 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S212 = 7.0f * _S211 * sqrt(_S211);
    float _S213 = min(floor(_S212), 6.0f);
    float _S214 = _S212 - _S213;
    uint _S215 = uint(int(_S209) + int(32)) % 32U;
    uint _S216 = uint(_S213);
    uint _S217 = _S215 * 8U + _S216;
    uint _S218 = (_S215 + 1U) % 32U * 8U + _S216;
    thread NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = uint4(_S217, _S217 + 1U, _S218, _S218 + 1U);
    float _S219 = 1.0f - _S210;
    float _S220 = 1.0f - _S214;
    uint4 _S221 = uint4(float4(_S219 * _S220, _S219 * _S214, _S210 * _S220, _S210 * _S214) * float4(252.0f)  + float4(0.5f) );
    (&taps_0)->weights_0 = _S221;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S221.x + _S221.y + _S221.z + _S221.w);
    return taps_0;
}

float3 half_vector_0(float3 light_4, float3 view_4)
{
    float3 _S222 = light_4 + view_4;
    return _S222 * float3(rsqrt(max(square_0(_S222), 9.999999960041972e-13f))) ;
}

float3 shadow_correlation_0(float3 light_5, float3 view_5)
{
    float2 _S223 = light_5.xy;
    float2 _S224 = view_5.xy;
    float _S225 = dot(_S223, _S224) / max(sqrt(dot(_S223, _S223) * dot(_S224, _S224)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return float3(float2((-0.09000000357627869f + -0.07999999821186066f * _S225)) , 0.0f);
    }
    return float3(min(0.62000000476837158f + 0.62999999523162842f * _S225, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16U), float(odd_0 >> 16U));
}

float4 interpolate_0(const NodeTaps_0 thread* taps_1, uint4 packs_1)
{
    uint4 _S226 = uint4(16711935U) ;
    uint4 _S227 = (packs_1 & _S226) * taps_1->weights_0;
    uint4 _S228 = ((packs_1 >> (uint4(8U) )) & _S226) * taps_1->weights_0;
    return bytes_of_sums_0(_S227.x + _S227.y + _S227.z + _S227.w, _S228.x + _S228.y + _S228.z + _S228.w) * float4(taps_1->inverse_sum_0) ;
}

float4 interpolate_table_0(const NodeTaps_0 thread* taps_2, uint table_1, uint stride_0, KernelContext_0 thread* kernelContext_19)
{
    uint4 _S229 = uint4(table_1)  + taps_2->nodes_0 * uint4(stride_0) ;
    float4 _S230 = interpolate_0(taps_2, uint4(kernelContext_19->words_0[_S229.x], kernelContext_19->words_0[_S229.y], kernelContext_19->words_0[_S229.z], kernelContext_19->words_0[_S229.w]));
    return _S230;
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

Group_0 group_at_0(uint row_1, float roughness_7, KernelContext_0 thread* kernelContext_20)
{
    thread Group_0 group_0;
    float _S231 = table_number_0(row_1, kernelContext_20);
    float _S232 = table_number_0(row_1 + 1U, kernelContext_20);
    float _S233 = table_number_0(row_1 + 2U, kernelContext_20);
    (&group_0)->normal_6 = float3(_S231, _S232, _S233);
    float _S234 = table_number_0(row_1 + 3U, kernelContext_20);
    (&group_0)->weight_1 = _S234;
    float _S235 = table_number_0(row_1 + 4U, kernelContext_20);
    float _S236 = table_number_0(row_1 + 5U, kernelContext_20);
    float _S237 = table_number_0(row_1 + 6U, kernelContext_20);
    float3 _S238 = float3(_S235, _S236, _S237);
    (&group_0)->tangent_6 = _S238;
    float _S239 = table_number_0(row_1 + 7U, kernelContext_20);
    float _S240 = table_number_0(row_1 + 8U, kernelContext_20);
    (&group_0)->variance_0 = float3(_S239, _S240, 1.0f - square_0(_S238) - _S239 - _S240);
    float _S241 = table_number_0(row_1 + 9U, kernelContext_20);
    float _S242 = table_number_0(row_1 + 10U, kernelContext_20);
    float _S243 = table_number_0(row_1 + 11U, kernelContext_20);
    (&group_0)->covariance_0 = float3(_S241, _S242, _S243);
    (&group_0)->roughness_6 = roughness_7;
    return group_0;
}

float2 visibility_gain_0(float3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * float2((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f))  + float2(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), float2(0.0f) );
}

float Group_variance_along_0(const Group_0 thread* this_5, float3 direction_5)
{
    float _S244 = direction_5.x;
    float _S245 = direction_5.y;
    float _S246 = direction_5.z;
    return max(dot(this_5->variance_0, direction_5 * direction_5) + 2.0f * dot(this_5->covariance_0, float3(_S244 * _S245, _S244 * _S246, _S245 * _S246)), 0.0f);
}

float mean_area_0(const Group_0 thread* group_1, float3 direction_6)
{
    float _S247 = dot(direction_6, group_1->tangent_6);
    float _S248 = _S247 * _S247;
    float _S249 = Group_variance_along_0(group_1, direction_6);
    float _S250 = group_1->roughness_6 * group_1->roughness_6;
    return sqrt(max((_S250 - 1.0f) * (_S248 + _S249) + 1.0f, _S250));
}

float mean_density_0(const Group_0 thread* group_2, float3 half_0)
{
    float _S251 = group_2->roughness_6;
    float _S252 = max(sqrt(max(1.0f - group_2->roughness_6 * group_2->roughness_6, 0.0f)) / group_2->roughness_6, 0.00100000004749745f);
    float _S253 = Group_variance_along_0(group_2, half_0);
    float _S254 = max(sqrt(3.0f * _S253), _S251 * 0.01999999955296516f + 0.00009999999747379f);
    float _S255 = dot(half_0, group_2->tangent_6);
    float _S256 = _S252 * (_S255 - _S254);
    float _S257 = _S252 * (_S255 + _S254);
    float _S258 = _S256 * _S257;
    float _S259 = 2.0f * _S254 * _S252;
    return 0.15915493667125702f / _S251 * ((1.0f - _S258) / ((_S256 * _S256 + 1.0f) * (_S257 * _S257 + 1.0f)) + arc_tangent_0(_S259, 1.0f + _S258) / _S259);
}

float layer_value_0(const Group_0 thread* group_3, float3 half_1, float3 light_6, float3 view_6, float optical_depth_3)
{
    bool _S260 = (light_6.z) < 0.0f;
    float3 _S261 = group_3->normal_6;
    float _S262 = dot(light_6, group_3->normal_6);
    float _S263;
    if(_S260)
    {
        _S263 = - _S262;
    }
    else
    {
        _S263 = _S262;
    }
    float _S264 = max(_S263, 0.01999999955296516f);
    float _S265 = max(dot(view_6, _S261), 0.01999999955296516f);
    float _S266 = mean_area_0(group_3, light_6);
    float _S267 = _S266 / _S264;
    float _S268 = mean_area_0(group_3, view_6);
    float _S269 = _S268 / _S265;
    if(_S260)
    {
        _S263 = abs(_S267 - _S269);
    }
    else
    {
        _S263 = _S267 + _S269;
    }
    float _S270 = optical_depth_3 * max(_S263, 0.00100000004749745f);
    if(_S260)
    {
        _S263 = exponential_0(- optical_depth_3 * min(_S267, _S269));
    }
    else
    {
        _S263 = 1.0f;
    }
    float _S271 = optical_depth_3 * _S263 * (1.0f - exponential_0(- _S270)) / _S270 / _S265;
    if(_S260)
    {
        _S263 = 1.0f;
    }
    else
    {
        _S263 = 1.0f - 0.34999999403953552f * (1.0f - square_0(_S261));
    }
    float _S272 = mean_density_0(group_3, half_1);
    return 0.25f * _S272 * _S263 * _S271;
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

Bound_0 bound_at_0(uint family_9, float position_5, KernelContext_0 thread* kernelContext_21)
{
    Cell_0 _S273 = locate_0(family_9, position_5, kernelContext_21);
    float _S274 = table_number_0(kernelContext_21->families_0[family_9].before_0 + 2U * _S273.thread_1 + 1U, kernelContext_21);
    thread Bound_0 bound_0;
    (&bound_0)->thread_11 = _S273.thread_1;
    (&bound_0)->turns_2 = round((position_5 - kernelContext_21->families_0[family_9].start_0 - _S274 - _S273.below_0) * kernelContext_21->families_0[family_9].inverse_period_0);
    (&bound_0)->cell_7 = _S273.below_0;
    float _S275 = 2.0f * _S273.half_width_1;
    (&bound_0)->width_1 = _S275;
    (&bound_0)->visible_0 = clamp((_S273.across_2 + _S273.half_width_1) / _S275, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S273.below_0, _S273.below_0 - _S273.across_2 - _S273.half_width_1) + max(_S273.across_2 - _S273.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_1;
    Bound_0 high_1;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1, KernelContext_0 thread* kernelContext_22)
{
    float _S276 = centre_1 - floor((centre_1 - kernelContext_22->families_0[family_10].start_0) * kernelContext_22->families_0[family_10].inverse_period_0) * kernelContext_22->families_0[family_10].period_0;
    float _S277 = 0.5f * max(size_1, kernelContext_22->families_0[family_10].smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S278 = bound_at_0(family_10, _S276 - _S277, kernelContext_22);
    (&stretch_0)->low_1 = _S278;
    Bound_0 _S279 = bound_at_0(family_10, _S276 + _S277, kernelContext_22);
    (&stretch_0)->high_1 = _S279;
    return stretch_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_6)
{
    return (&this_6->high_1)->turns_2 - (&this_6->low_1)->turns_2;
}

float3 lengths_0(uint family_11, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_23)
{
    float _S280 = Stretch_turns_0(stretch_1);
    uint _S281 = kernelContext_23->families_0[family_11].before_0 + 2U * (&stretch_1->low_1)->thread_11;
    uint _S282 = kernelContext_23->families_0[family_11].before_0 + 2U * (&stretch_1->high_1)->thread_11;
    float _S283 = table_number_0(_S282, kernelContext_23);
    float _S284 = table_number_0(_S281, kernelContext_23);
    float _S285 = _S283 - _S284;
    float _S286 = table_number_0(_S282 + 1U, kernelContext_23);
    float _S287 = table_number_0(_S281 + 1U, kernelContext_23);
    float _S288 = _S286 - _S287;
    return float3(_S285 + (&stretch_1->high_1)->visible_0 * (&stretch_1->high_1)->width_1 - (&stretch_1->low_1)->visible_0 * (&stretch_1->low_1)->width_1 + _S280 * kernelContext_23->families_0[family_11].visible_total_0, _S288 - _S285 + (&stretch_1->high_1)->gap_0 - (&stretch_1->low_1)->gap_0 + _S280 * (kernelContext_23->families_0[family_11].period_0 - kernelContext_23->families_0[family_11].visible_total_0), _S288 + (&stretch_1->high_1)->cell_7 - (&stretch_1->low_1)->cell_7 + _S280 * kernelContext_23->families_0[family_11].period_0);
}

float2 integrals_along_0(uint family_12, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_24)
{
    Family_0 _S289 = kernelContext_24->families_0[family_12];
    uint _S290 = 3U * _S289.quantities_0;
    uint _S291 = kernelContext_24->families_0[family_12].colour_threads_0 + _S290 * (&stretch_2->low_1)->thread_11 + quantity_0;
    uint _S292 = kernelContext_24->families_0[family_12].colour_threads_0 + _S290 * (&stretch_2->high_1)->thread_11 + quantity_0;
    uint _S293 = kernelContext_24->families_0[family_12].colour_threads_0 + _S290 * uint(kernelContext_24->families_0[family_12].count_0) + quantity_0;
    float _S294 = table_number_0(_S291, kernelContext_24);
    float _S295 = table_number_0(_S292, kernelContext_24);
    float _S296 = Stretch_turns_0(stretch_2);
    float _S297 = table_number_0(_S292 + _S289.quantities_0, kernelContext_24);
    float _S298 = table_number_0(_S291 + _S289.quantities_0, kernelContext_24);
    float _S299 = _S297 - _S298 + _S295 * (&stretch_2->high_1)->visible_0 * (&stretch_2->high_1)->width_1 - _S294 * (&stretch_2->low_1)->visible_0 * (&stretch_2->low_1)->width_1;
    float _S300 = table_number_0(_S293 + _S289.quantities_0, kernelContext_24);
    float _S301 = _S299 + _S296 * _S300;
    uint _S302 = 2U * _S289.quantities_0;
    float _S303 = table_number_0(_S292 + _S302, kernelContext_24);
    float _S304 = table_number_0(_S291 + _S302, kernelContext_24);
    float _S305 = _S303 - _S304 + _S295 * (&stretch_2->high_1)->cell_7 - _S294 * (&stretch_2->low_1)->cell_7;
    float _S306 = table_number_0(_S293 + _S302, kernelContext_24);
    return float2(_S301, _S305 + _S296 * _S306);
}

bool Stretch_wraps_0(const Stretch_0 thread* this_7)
{
    return ((&this_7->high_1)->thread_11) < ((&this_7->low_1)->thread_11);
}

bool Stretch_wraps_1(const Stretch_0 thread* this_8)
{
    return ((&this_8->high_1)->thread_11) < ((&this_8->low_1)->thread_11);
}

uint4 Stretch_differences_0(const Stretch_0 thread* this_9, uint4 entries_0, uint whole_0)
{
    uint _S307 = entries_0.z;
    uint _S308 = entries_0.x;
    uint _S309 = _S307 - _S308;
    bool _S310 = Stretch_wraps_1(this_9);
    uint _S311;
    if(_S310)
    {
        _S311 = whole_0;
    }
    else
    {
        _S311 = 0U;
    }
    return uint4(_S309 + _S311, entries_0.w - _S307, entries_0.y - _S308, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_4, uint row_2, uint count_3, uint quantities_1, KernelContext_0 thread* kernelContext_25)
{
    uint _S312 = row_2 + (&across_4->low_1)->thread_11 * quantities_1;
    uint _S313 = row_2 + (&across_4->high_1)->thread_11 * quantities_1;
    uint4 _S314 = Stretch_differences_0(across_4, uint4(kernelContext_25->words_0[_S312], kernelContext_25->words_0[_S312 + quantities_1], kernelContext_25->words_0[_S313], kernelContext_25->words_0[_S313 + quantities_1]), kernelContext_25->words_0[row_2 + count_3 * quantities_1]);
    return _S314;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_10)
{
    float _S315 = (&this_10->high_1)->visible_0;
    float _S316 = - (&this_10->low_1)->visible_0;
    float _S317 = Stretch_turns_0(this_10);
    bool _S318 = Stretch_wraps_0(this_10);
    float _S319;
    if(_S318)
    {
        _S319 = 1.0f;
    }
    else
    {
        _S319 = 0.0f;
    }
    return float4(1.0f, _S315, _S316, _S317 - _S319);
}

float integral_on_top_0(uint family_13, const Stretch_0 thread* across_5, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_26)
{
    uint _S320 = uint(kernelContext_26->families_0[family_13].count_0);
    uint _S321 = (_S320 + 1U) * kernelContext_26->families_0[family_13].quantities_0;
    uint _S322 = kernelContext_26->families_0[family_13].colour_areas_0 + quantity_1;
    uint _S323 = (&along_0->low_1)->thread_11;
    uint4 _S324 = row_differences_0(across_5, _S322 + (&along_0->low_1)->thread_11 * _S321, _S320, kernelContext_26->families_0[family_13].quantities_0, kernelContext_26);
    uint4 _S325 = row_differences_0(across_5, _S322 + (_S323 + 1U) * _S321, _S320, kernelContext_26->families_0[family_13].quantities_0, kernelContext_26);
    uint _S326 = (&along_0->high_1)->thread_11;
    uint4 _S327 = row_differences_0(across_5, _S322 + (&along_0->high_1)->thread_11 * _S321, _S320, kernelContext_26->families_0[family_13].quantities_0, kernelContext_26);
    uint4 _S328 = row_differences_0(across_5, _S322 + (_S326 + 1U) * _S321, _S320, kernelContext_26->families_0[family_13].quantities_0, kernelContext_26);
    uint4 _S329 = row_differences_0(across_5, _S322 + crossing_count_0 * _S321, _S320, kernelContext_26->families_0[family_13].quantities_0, kernelContext_26);
    uint4 _S330 = _S327 - _S324;
    bool _S331 = Stretch_wraps_0(along_0);
    uint4 _S332;
    if(_S331)
    {
        _S332 = _S329;
    }
    else
    {
        _S332 = uint4(int4(int(0)) );
    }
    uint4 _S333 = _S330 + _S332;
    float4 _S334 = Stretch_weights_0(across_5);
    float4 _S335 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S333)), _S334), dot(float4(int4(_S328 - _S327)), _S334), dot(float4(int4(_S325 - _S324)), _S334), dot(float4(int4(_S329)), _S334)), _S335) * kernelContext_26->families_0[family_13].area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_2, uint row_3, KernelContext_0 thread* kernelContext_27)
{
    Albedos_0 _S336 = table_albedos_0(row_3, kernelContext_27);
    thread Albedos_0 sum_0;
    float3 _S337 = float3(weight_2) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S337 * _S336.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S337 * _S336.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S337 * _S336.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S337 * _S336.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, const Stretch_0 thread* own_1, const Stretch_0 thread* other_2, bool back_3, KernelContext_0 thread* kernelContext_28)
{
    Albedos_0 _S338 = table_albedos_0(kernelContext_28->families_0[family_14].colour_mean_0, kernelContext_28);
    thread Albedos_0 albedos_2 = _S338;
    if((kernelContext_28->families_0[family_14].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S339 = lengths_0(crossing_1, other_2, kernelContext_28);
    bool is_exposed_0 = false;
    float weight_3 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (kernelContext_28->families_0[family_14].quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S340 = integrals_along_0(family_14, own_1, quantity_2, kernelContext_28);
        float _S341 = integral_on_top_0(family_14, own_1, other_2, uint(kernelContext_28->families_0[crossing_1].count_0), quantity_2, kernelContext_28);
        float _S342 = _S340.x;
        float _S343 = _S342 * _S339.x;
        float _S344;
        if(back_3)
        {
            _S344 = _S343 - _S341;
        }
        else
        {
            _S344 = _S341;
        }
        bool _S345 = quantity_2 == 0U;
        if(_S345)
        {
            is_exposed_0 = _S344 > (16.0f * kernelContext_28->families_0[family_14].area_unit_0 * min(_S343 / kernelContext_28->families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S343);
        }
        float _S346 = _S342 * _S339.y;
        float _S347;
        if(is_exposed_0)
        {
            _S347 = _S344;
        }
        else
        {
            _S347 = 0.0f;
        }
        float _S348 = _S346 + _S347 + 0.000244140625f * _S339.z * _S340.y;
        if(_S345)
        {
            weight_3 = 1.0f / max(_S348, 9.99999968265522539e-21f);
        }
        else
        {
            float _S349 = _S348 * weight_3;
            uint _S350 = kernelContext_28->families_0[family_14].colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S351 = albedos_2;
            Albedos_0 _S352 = with_added_albedos_0(&_S351, _S349, _S350, kernelContext_28);
            albedos_2 = _S352;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

Albedos_0 lerp_albedos_0(const Albedos_0 thread* first_3, const Albedos_0 thread* second_1, float weight_4)
{
    thread Albedos_0 albedos_3;
    float3 _S353 = float3(weight_4) ;
    (&albedos_3)->diffuse_reflect_0 = mix(first_3->diffuse_reflect_0, second_1->diffuse_reflect_0, _S353);
    (&albedos_3)->diffuse_transmit_0 = mix(first_3->diffuse_transmit_0, second_1->diffuse_transmit_0, _S353);
    (&albedos_3)->specular_reflect_0 = mix(first_3->specular_reflect_0, second_1->specular_reflect_0, _S353);
    (&albedos_3)->specular_transmit_0 = mix(first_3->specular_transmit_0, second_1->specular_transmit_0, _S353);
    return albedos_3;
}

Albedos_0 tinted_0(const Albedos_0 thread* albedos_4, float3 tint_0)
{
    thread Albedos_0 result_1 = *albedos_4;
    (&result_1)->diffuse_reflect_0 = (&result_1)->diffuse_reflect_0 * tint_0;
    (&result_1)->diffuse_transmit_0 = (&result_1)->diffuse_transmit_0 * tint_0;
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
    float _S354 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S355 = 2.0f * sqrt(_S354) - 1.0f;
    float _S356 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S355, _S356), 0.00999999977648258f, 1.0f), clamp((1.0f - _S354) * sheen_shear_0(_S355, _S356), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S355, _S356), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_7, float3 view_7, float scale_0, float shear_0)
{
    float _S357 = light_7.z;
    bool _S358;
    if(_S357 <= 0.0f)
    {
        _S358 = true;
    }
    else
    {
        _S358 = (view_7.z) <= 0.0f;
    }
    if(_S358)
    {
        return 0.0f;
    }
    float2 _S359 = view_7.xy;
    float _S360 = dot(_S359, _S359);
    float2 _S361;
    if(_S360 > 9.99999968265522539e-21f)
    {
        _S361 = _S359 * float2(rsqrt(_S360)) ;
    }
    else
    {
        _S361 = float2(1.0f, 0.0f);
    }
    float _S362 = scale_0 * dot(light_7.xy, _S361) + shear_0 * _S357;
    float _S363 = scale_0 * (light_7.y * _S361.x - light_7.x * _S361.y);
    float _S364 = _S362 * _S362 + _S363 * _S363 + _S357 * _S357;
    return 0.31830987334251404f * scale_0 * scale_0 * _S357 / max(_S364 * _S364, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_8, float3 view_8, float strength_0, float roughness_9)
{
    float3 _S365 = sheen_lobe_0(view_8.z, roughness_9);
    float _S366 = strength_0 * _S365.z;
    return float2(_S366 * transformed_cosine_0(light_8, view_8, _S365.x, _S365.y), 1.0f - _S366);
}

void accumulate_0(uint index_8, float4 light_9, KernelContext_0 thread* kernelContext_29)
{
    float _S367 = (kernelContext_29->layers_0+index_8)->share_0;
    packed_float4 device* _S368 = kernelContext_29->radiance_0+index_8;
    *_S368 = packed_float4((float4(*_S368)  + float4((kernelContext_29->layers_0+index_8)->share_0)  * light_9)) ;
    (kernelContext_29->layers_0+index_8)->share_0 = _S367 * (1.0f - light_9.w);
    return;
}

float3 camera_right_0(int _S369, KernelContext_0 thread* kernelContext_30)
{
    Frame_0 device* _S370 = kernelContext_30->frames_0+_S369;
    return float3(_S370->right_x_0, _S370->right_y_0, _S370->right_z_0);
}

float3 camera_up_0(int _S371, KernelContext_0 thread* kernelContext_31)
{
    Frame_0 device* _S372 = kernelContext_31->frames_0+_S371;
    return float3(_S372->up_x_0, _S372->up_y_0, _S372->up_z_0);
}

float3 camera_forward_0(int _S373, KernelContext_0 thread* kernelContext_32)
{
    Frame_0 device* _S374 = kernelContext_32->frames_0+_S373;
    return float3(_S374->forward_x_0, _S374->forward_y_0, _S374->forward_z_0);
}

float3 camera_origin_0(int _S375, KernelContext_0 thread* kernelContext_33)
{
    Frame_0 device* _S376 = kernelContext_33->frames_0+_S375;
    return float3(_S376->origin_x_0, _S376->origin_y_0, _S376->origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S377, uint _S378, float _S379, float _S380, KernelContext_0 thread* kernelContext_34)
{
    Fabric_0 device* _S381 = kernelContext_34->fabrics_0+_S377;
    uint _S382 = 3U * _S378;
    Vertex_0 _S383 = kernelContext_34->vertices_0[kernelContext_34->corners_0[_S382]];
    Vertex_0 _S384 = kernelContext_34->vertices_0[kernelContext_34->corners_0[_S382 + 1U]];
    Vertex_0 _S385 = kernelContext_34->vertices_0[kernelContext_34->corners_0[_S382 + 2U]];
    thread Vertex_0 _S386 = _S384;
    float3 _S387 = position_of_0(&_S386);
    thread Vertex_0 _S388 = _S383;
    float3 _S389 = position_of_0(&_S388);
    float3 _S390 = _S387 - _S389;
    thread Vertex_0 _S391 = _S385;
    float3 _S392 = position_of_0(&_S391);
    float3 _S393 = _S392 - _S389;
    float _S394 = _S384.u_0 - _S383.u_0;
    float _S395 = _S384.v_0 - _S383.v_0;
    float2 _S396 = float2(_S394, _S395);
    float _S397 = _S385.u_0 - _S383.u_0;
    float _S398 = _S385.v_0 - _S383.v_0;
    float2 _S399 = float2(_S397, _S398);
    float _S400;
    if((_S394 * _S398 - _S395 * _S397) < 0.0f)
    {
        _S400 = -1.0f;
    }
    else
    {
        _S400 = 1.0f;
    }
    float3 _S401 = float3(_S400)  * (float3(_S398)  * _S390 - float3(_S395)  * _S393);
    float3 _S402 = float3(_S400)  * (float3(_S394)  * _S393 - float3(_S397)  * _S390);
    thread VisiblePoint_0 point_1;
    float _S403 = 1.0f - _S379 - _S380;
    thread Vertex_0 _S404 = _S383;
    float3 _S405 = normal_of_0(&_S404);
    float3 _S406 = float3(_S403)  * _S405;
    thread Vertex_0 _S407 = _S384;
    float3 _S408 = normal_of_0(&_S407);
    float3 _S409 = float3(_S379) ;
    float3 _S410 = _S406 + _S409 * _S408;
    thread Vertex_0 _S411 = _S385;
    float3 _S412 = normal_of_0(&_S411);
    float3 _S413 = float3(_S380) ;
    float3 _S414 = normalize(_S410 + _S413 * _S412);
    (&point_1)->normal_0 = _S414;
    float3 _S415 = normalize(_S401 - _S414 * float3(dot(_S414, _S401)) );
    (&point_1)->axis_x_0 = _S415;
    (&point_1)->axis_y_0 = cross(_S414, _S415);
    float3 _S416 = normalize(cross(_S390, _S393));
    float3 _S417;
    if((dot(_S416, _S414)) < 0.0f)
    {
        _S417 = - _S416;
    }
    else
    {
        _S417 = _S416;
    }
    (&point_1)->face_normal_0 = _S417;
    (&point_1)->position_0 = _S389 + _S409 * _S390 + _S413 * _S393;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_1 = float2(_S383.u_0, _S383.v_0) + float2(_S379)  * _S396 + float2(_S380)  * _S399;
    bool _S418 = (dot(cross(_S401, _S402), (&point_1)->normal_0)) < 0.0f;
    float _S419 = _S381->uv_width_0;
    if(_S418)
    {
        _S400 = - _S381->uv_height_0;
    }
    else
    {
        _S400 = _S381->uv_height_0;
    }
    float2 _S420 = float2(_S419, _S400);
    (&point_1)->draft_per_uv_0 = _S420;
    float2 _S421 = (&point_1)->uv_1 * _S420;
    if(_S418)
    {
        _S400 = _S381->uv_height_0;
    }
    else
    {
        _S400 = 0.0f;
    }
    (&point_1)->draft_0 = _S421 + float2(0.0f, _S400);
    float2 _S422 = float2(0.0f) ;
    (&point_1)->draft_dx_0 = _S422;
    (&point_1)->draft_dy_0 = _S422;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S423, uint _S424, uint _S425, uint2 _S426, KernelContext_0 thread* kernelContext_35)
{
    Frame_0 device* _S427 = kernelContext_35->frames_0+_S423;
    uint _S428 = 3U * _S425;
    Vertex_0 _S429 = kernelContext_35->vertices_0[kernelContext_35->corners_0[_S428]];
    Vertex_0 _S430 = kernelContext_35->vertices_0[kernelContext_35->corners_0[_S428 + 1U]];
    Vertex_0 _S431 = kernelContext_35->vertices_0[kernelContext_35->corners_0[_S428 + 2U]];
    thread Vertex_0 _S432 = _S430;
    float3 _S433 = position_of_0(&_S432);
    thread Vertex_0 _S434 = _S429;
    float3 _S435 = position_of_0(&_S434);
    float3 _S436 = _S433 - _S435;
    thread Vertex_0 _S437 = _S431;
    float3 _S438 = position_of_0(&_S437);
    float3 _S439 = _S438 - _S435;
    float3 _S440 = cross(_S436, _S439);
    float _S441 = 1.0f / max(square_0(_S440), 1.00000000317107685e-30f);
    float3 _S442 = camera_right_0(_S423, kernelContext_35);
    float _S443 = float(_S427->width_0);
    float3 _S444 = _S442 * float3((2.0f / _S443)) ;
    float3 _S445 = camera_up_0(_S423, kernelContext_35);
    float _S446 = float(_S427->height_0);
    float3 _S447 = _S445 * float3((-2.0f / _S446)) ;
    float _S448 = float(_S426.x) + 0.5f - 0.5f * _S443;
    float _S449 = float(_S426.y) + 0.5f - 0.5f * _S446;
    float3 _S450 = camera_forward_0(_S423, kernelContext_35);
    float3 _S451 = _S450 + float3(_S448)  * _S444 + float3(_S449)  * _S447;
    float _S452 = dot(_S451, _S440);
    float _S453;
    if((abs(_S452)) > 1.00000000317107685e-30f)
    {
        _S453 = _S452;
    }
    else
    {
        _S453 = 1.00000000317107685e-30f;
    }
    float _S454 = 1.0f / _S453;
    float3 _S455 = camera_origin_0(_S423, kernelContext_35);
    float3 _S456 = _S435 - _S455;
    float3 _S457 = float3((dot(_S456, _S440) * _S454)) ;
    float3 _S458 = _S451 * _S457 - _S456;
    float3 _S459 = _S457 * (_S444 - _S451 * float3((dot(_S444, _S440) * _S454)) );
    float3 _S460 = _S457 * (_S447 - _S451 * float3((dot(_S447, _S440) * _S454)) );
    float3 _S461 = float3(_S441) ;
    float3 _S462 = cross(_S439, _S440) * _S461;
    float3 _S463 = cross(_S440, _S436) * _S461;
    float2 _S464 = float2(_S430.u_0 - _S429.u_0, _S430.v_0 - _S429.v_0);
    float2 _S465 = float2(_S431.u_0 - _S429.u_0, _S431.v_0 - _S429.v_0);
    VisiblePoint_0 _S466 = face_point_0(_S424, _S425, dot(_S458, _S462), dot(_S458, _S463), kernelContext_35);
    thread VisiblePoint_0 point_2 = _S466;
    (&point_2)->position_0 = _S435 + _S458;
    (&point_2)->view_0 = - normalize(_S451);
    (&point_2)->draft_dx_0 = (float2(dot(_S459, _S462))  * _S464 + float2(dot(_S459, _S463))  * _S465) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (float2(dot(_S460, _S462))  * _S464 + float2(dot(_S460, _S463))  * _S465) * (&point_2)->draft_per_uv_0;
    return point_2;
}

float3 filtered_albedo_0(uint _S467, const VisiblePoint_0 thread* _S468, KernelContext_0 thread* kernelContext_36)
{
    Fabric_0 device* _S469 = kernelContext_36->fabrics_0+_S467;
    uint _S470 = _S469->albedo_map_levels_0;
    if((_S469->albedo_map_levels_0) == 0U)
    {
        return float3(1.0f) ;
    }
    float2 _S471 = float2(_S469->uv_width_0, _S469->uv_height_0);
    float2 _S472 = _S468->draft_dx_0 / _S471;
    float2 _S473 = _S468->draft_dy_0 / _S471;
    uint _S474 = _S470 - 1U;
    uint _S475 = 1U << _S474;
    float _S476 = clamp(0.5f * binary_logarithm_0(max(abs(_S472.x * _S473.y - _S472.y * _S473.x), 9.99999968265522539e-21f) * (square_1(float(_S475)) / 3.0f)), 0.0f, float(_S470) - 1.0f);
    uint _S477 = min(uint(_S476), max(_S470, 2U) - 2U);
    uint _S478 = min(_S477 + 1U, _S474);
    uint _S479 = 1U << (2U * _S470);
    uint _S480 = _S469->albedo_map_0 + (_S479 - (_S479 >> (2U * _S478))) / 3U;
    float _S481 = (exponential_0(1.38629436492919922f * (_S476 - float(_S477))) - 1.0f) / 3.0f;
    float2 _S482 = _S468->uv_1;
    float3 _S483 = map_level_0(_S469->albedo_map_0 + (_S479 - (_S479 >> (2U * _S477))) / 3U, _S475 >> _S477, _S468->uv_1, kernelContext_36);
    float3 _S484 = map_level_0(_S480, _S475 >> _S478, _S482, kernelContext_36);
    return mix(_S483, _S484, float3(_S481) );
}

uint light_sample_count_0(int _S485, KernelContext_0 thread* kernelContext_37)
{
    Frame_0 device* _S486 = kernelContext_37->frames_0+_S485;
    return _S486->lights_0 + _S486->environment_samples_0;
}

float visibility_at_0(int _S487, uint _S488, uint2 _S489, KernelContext_0 thread* kernelContext_38)
{
    Frame_0 device* _S490 = kernelContext_38->frames_0+_S487;
    if((_S490->casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return *(kernelContext_38->visibilities_0+((_S488 * _S490->height_0 + _S489.y) * _S490->width_0 + _S489.x));
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_1;
};

float3 environment_texel_0(int _S491, uint _S492, uint _S493, KernelContext_0 thread* kernelContext_39)
{
    Frame_0 device* _S494 = kernelContext_39->frames_0+_S491;
    uint _S495 = _S494->environment_table_0 + _S494->environment_rows_0 + 1U + _S494->environment_rows_0 * (_S494->environment_columns_0 + 1U) + 3U * (_S492 * _S494->environment_columns_0 + _S493);
    float _S496 = scene_number_0(_S495, kernelContext_39);
    float _S497 = scene_number_0(_S495 + 1U, kernelContext_39);
    float _S498 = scene_number_0(_S495 + 2U, kernelContext_39);
    return float3(_S496, _S497, _S498);
}

float3 sample_environment_0(int _S499, float2 _S500, float3 thread* _S501, KernelContext_0 thread* kernelContext_40)
{
    Frame_0 device* _S502 = kernelContext_40->frames_0+_S499;
    uint _S503 = _S502->environment_table_0;
    uint _S504 = _S502->environment_rows_0;
    Choice_0 _S505 = choose_0(_S502->environment_table_0, _S502->environment_rows_0, _S500.y, kernelContext_40);
    uint _S506 = _S502->environment_columns_0;
    Choice_0 _S507 = choose_0(_S503 + _S504 + 1U + _S505.index_3 * (_S502->environment_columns_0 + 1U), _S502->environment_columns_0, _S500.x, kernelContext_40);
    float3 _S508 = environment_texel_0(_S499, _S505.index_3, _S507.index_3, kernelContext_40);
    *_S501 = _S508 * float3((_S502->environment_total_0 / max(mean_0(_S508), 9.99999968265522539e-21f))) ;
    float _S509 = 3.14159274101257324f / float(_S504);
    float _S510 = mix(sine_cosine_0(float(_S505.index_3) * _S509).y, sine_cosine_0(float(_S505.index_3 + 1U) * _S509).y, _S505.remainder_0);
    float _S511 = sqrt(max(1.0f - _S510 * _S510, 0.0f));
    float2 _S512 = sine_cosine_0((float(_S507.index_3) + _S507.remainder_0) * (6.28318548202514648f / float(_S506)));
    float _S513 = _S511 * _S512.x;
    float _S514 = - _S511 * _S512.y;
    return float3(_S502->environment_cosine_0 * _S513 + _S502->environment_sine_0 * _S514, _S510, _S502->environment_cosine_0 * _S514 - _S502->environment_sine_0 * _S513);
}

LightSample_0 light_sample_0(int _S515, uint _S516, uint2 _S517, float3 _S518, KernelContext_0 thread* kernelContext_41)
{
    Frame_0 device* _S519 = kernelContext_41->frames_0+_S515;
    thread LightSample_0 sample_0;
    (&sample_0)->distance_1 = 1.00000001504746622e+30f;
    uint _S520 = _S519->lights_0;
    if(_S516 >= (_S519->lights_0))
    {
        uint _S521 = _S519->environment_samples_0;
        thread float3 weight_5;
        float3 _S522 = sample_environment_0(_S515, pixel_sequence_0(_S517, _S519->pass_number_0 * _S519->environment_samples_0 + (_S516 - _S520), 3U), &weight_5, kernelContext_41);
        (&sample_0)->towards_0 = _S522;
        (&sample_0)->irradiance_1 = weight_5 / float3(float(_S521)) ;
        return sample_0;
    }
    Light_0 _S523 = kernelContext_41->lights_1[_S516];
    (&sample_0)->irradiance_1 = float3(_S523.red_0, _S523.green_0, _S523.blue_0);
    (&sample_0)->towards_0 = float3(_S523.x_5, _S523.y_1, _S523.z_1);
    if((_S523.is_point_0) != 0U)
    {
        float3 _S524 = (&sample_0)->towards_0 - _S518;
        float _S525 = max(square_0(_S524), 9.999999960041972e-13f);
        (&sample_0)->distance_1 = sqrt(_S525);
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / float3(_S525) ;
        (&sample_0)->towards_0 = normalize(_S524);
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

Regime_0 regime_of_0(uint _S526, const Footprint_0 thread* _S527, float _S528, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S529 = kernelContext_42->fabrics_0+_S526;
    float _S530 = Footprint_spread_side_0(_S527);
    float _S531 = clamp((binary_logarithm_0(max(_S530, 9.99999971718068537e-10f)) - _S529->lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    thread Regime_0 regime_0;
    float _S532 = _S531 * _S531 * (3.0f - 2.0f * _S531);
    (&regime_0)->prefiltered_0 = _S532;
    (&regime_0)->threads_1 = _S530 * _S529->lobes_0.threads_per_mm_0;
    float _S533 = mix(max(8.0f / _S528, 1.0f), 1.0f, _S532);
    float _S534;
    if(_S532 < 1.0f)
    {
        _S534 = clamp((&regime_0)->threads_1 * 12.0f, 1.0f, _S533);
    }
    else
    {
        _S534 = 0.0f;
    }
    (&regime_0)->points_0 = _S534;
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

Crossing_0 crossing_at_0(uint _S535, float _S536, float _S537, bool _S538, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S539 = kernelContext_43->fabrics_0+_S535;
    thread Crossing_0 crossing_3;
    Cell_0 _S540 = locate_0(_S539->warp_0, _S536, kernelContext_43);
    (&crossing_3)->warp_1 = _S540;
    Cell_0 _S541 = locate_0(_S539->weft_0, _S537, kernelContext_43);
    (&crossing_3)->weft_1 = _S541;
    uint _S542 = _S539->run_words_0 + 2U * ((&(&crossing_3)->weft_1)->thread_1 * _S539->ends_1 + (&(&crossing_3)->warp_1)->thread_1);
    uint _S543 = kernelContext_43->words_0[_S542];
    (&crossing_3)->warp_word_0 = _S543;
    (&crossing_3)->weft_word_0 = kernelContext_43->words_0[_S542 + 1U];
    (&crossing_3)->warp_above_0 = ((_S543 & 1U) == 1U) != _S538;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S544, float _S545, float _S546, bool _S547, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S548 = kernelContext_44->fabrics_0+_S544;
    thread Sample_0 sample_1;
    Crossing_0 _S549 = crossing_at_0(_S544, _S545, _S546, _S547, kernelContext_44);
    (&sample_1)->crossing_2 = _S549;
    thread Crossing_0 _S550 = _S549;
    Shown_0 _S551 = shown_at_0(&_S550, _S547);
    (&sample_1)->shown_3 = _S551;
    uint _S552;
    if(_S551.is_warp_2)
    {
        _S552 = _S548->warp_0;
    }
    else
    {
        _S552 = _S548->weft_0;
    }
    uint _S553;
    if(_S551.is_warp_2)
    {
        _S553 = _S548->weft_0;
    }
    else
    {
        _S553 = _S548->warp_0;
    }
    thread Cell_0 _S554 = (&(&sample_1)->crossing_2)->warp_1;
    thread Cell_0 _S555 = (&(&sample_1)->crossing_2)->weft_1;
    Cell_0 _S556 = select_cell_0(_S551.is_warp_2, &_S554, &_S555);
    thread Cell_0 _S557 = (&(&sample_1)->crossing_2)->weft_1;
    thread Cell_0 _S558 = (&(&sample_1)->crossing_2)->warp_1;
    Cell_0 _S559 = select_cell_0(_S551.is_warp_2, &_S557, &_S558);
    thread Cell_0 _S560 = _S559;
    Run_0 _S561 = unpack_0(_S552, _S553, _S556.thread_1, &_S560, _S551.word_0, kernelContext_44);
    thread Cell_0 _S562 = _S556;
    Section_0 _S563 = section_at_0(&_S562);
    bool _S564;
    if(_S551.on_top_0)
    {
        _S564 = (_S561.distance_0) < (_S563.drop_0 * _S561.bend_1.sine_0);
    }
    else
    {
        _S564 = false;
    }
    bool _S565;
    if(_S551.on_top_0)
    {
        _S565 = !_S564;
    }
    else
    {
        _S565 = false;
    }
    float _S566;
    if(_S565)
    {
        _S566 = 1.0f;
    }
    else
    {
        _S566 = -1.0f;
    }
    float _S567;
    if(_S564)
    {
        _S567 = _S561.other_reach_0;
    }
    else
    {
        _S567 = _S561.reach_0;
    }
    float _S568;
    if(_S564)
    {
        _S568 = _S567 + _S561.distance_0;
    }
    else
    {
        _S568 = max(_S567 - _S561.distance_0, 0.0f);
    }
    float _S569 = _S567 / _S561.bend_1.sine_0 - _S566 * _S563.drop_0;
    float _S570 = _S568 * _S568;
    float _S571 = max(_S569 * _S569 - _S570, 9.99999968265522539e-21f);
    float _S572 = rsqrt(_S571);
    float _S573 = _S570 / (_S571 * _S572 + _S569);
    bool _S574 = _S568 > 0.0f;
    float _S575;
    if(_S551.on_top_0)
    {
        _S575 = 1.0f;
    }
    else
    {
        _S575 = -1.0f;
    }
    float _S576;
    if(_S561.near_start_0)
    {
        _S576 = 1.0f;
    }
    else
    {
        _S576 = -1.0f;
    }
    float _S577 = _S575 * _S576;
    if(_S574)
    {
        _S575 = _S569 * _S572;
    }
    else
    {
        _S575 = 1.0f;
    }
    (&sample_1)->slope_across_0 = _S563.slope_0 * _S575;
    if(_S574)
    {
        _S568 = _S577 * _S568 * _S572;
    }
    else
    {
        _S568 = 0.0f;
    }
    (&sample_1)->slope_along_0 = _S568;
    Family_0 _S578 = kernelContext_44->families_0[_S552];
    thread Shown_0 _S579 = _S551;
    thread Run_0 _S580 = _S561;
    thread Cell_0 _S581 = _S559;
    float2 _S582 = dive_0(_S553, &_S579, &_S580, &_S581, kernelContext_44);
    if(_S561.straight_0)
    {
        _S566 = 0.0f;
    }
    else
    {
        _S566 = _S578.height_scale_0 * _S566;
    }
    (&sample_1)->height_6 = _S566 * (_S567 * _S561.bend_1.half_tangent_0 - _S573) - _S578.height_scale_0 * _S563.drop_0 - _S582.x;
    float _S583 = _S578.height_scale_0 * (&sample_1)->slope_across_0;
    float _S584 = _S578.height_scale_0 * (&sample_1)->slope_along_0 - _S582.y;
    if(_S551.is_warp_2)
    {
        _S566 = _S583;
    }
    else
    {
        _S566 = _S584;
    }
    (&sample_1)->slope_x_1 = _S566;
    if(_S551.is_warp_2)
    {
        _S566 = _S584;
    }
    else
    {
        _S566 = _S583;
    }
    (&sample_1)->slope_y_1 = _S566;
    (&sample_1)->run_3 = _S561;
    (&sample_1)->section_1 = _S563;
    return sample_1;
}

float steps_per_length_0(uint _S585, const SearchQuality_0 thread* _S586, float3 _S587, KernelContext_0 thread* kernelContext_45)
{
    Fabric_0 device* _S588 = kernelContext_45->fabrics_0+_S585;
    return max(max(abs(_S587.x) * _S588->threads_per_x_0, abs(_S587.y) * _S588->threads_per_y_0) * _S586->steps_per_thread_0, abs(_S587.z) * _S588->per_relief_0 * _S586->steps_per_relief_0);
}

float cell_maximum_0(uint _S589, const Crossing_0 thread* _S590, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S591 = kernelContext_46->fabrics_0+_S589;
    bool _S592 = _S590->warp_above_0;
    uint _S593;
    if(_S590->warp_above_0)
    {
        _S593 = _S591->warp_0;
    }
    else
    {
        _S593 = _S591->weft_0;
    }
    uint _S594;
    if(_S592)
    {
        _S594 = _S590->warp_word_0;
    }
    else
    {
        _S594 = _S590->weft_word_0;
    }
    return float(_S594 >> 28U) * kernelContext_46->families_0[_S593].height_scale_0 * kernelContext_46->families_0[_S593].level_0;
}

Probe_0 probe_0(uint _S595, float _S596, float _S597, bool _S598, bool _S599, bool _S600, KernelContext_0 thread* kernelContext_47)
{
    Sample_0 _S601 = sample_at_0(_S595, _S596, _S597, _S598, kernelContext_47);
    thread Probe_0 probe_1;
    (&probe_1)->height_3 = _S601.height_6;
    (&probe_1)->hole_4 = _S601.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S601.slope_x_1;
    (&probe_1)->slope_y_0 = _S601.slope_y_1;
    uint _S602;
    if(_S601.shown_3.is_warp_2)
    {
        _S602 = _S601.crossing_2.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S602 = _S601.crossing_2.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S602;
    thread Crossing_0 _S603 = _S601.crossing_2;
    float _S604 = cell_maximum_0(_S595, &_S603, kernelContext_47);
    (&probe_1)->cell_max_0 = _S604;
    float _S605;
    if(_S599)
    {
        _S605 = _S601.crossing_2.warp_1.above_0;
    }
    else
    {
        _S605 = _S601.crossing_2.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S605;
    if(_S600)
    {
        _S605 = _S601.crossing_2.weft_1.above_0;
    }
    else
    {
        _S605 = _S601.crossing_2.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S605;
    bool _S606 = !_S601.shown_3.is_warp_2;
    thread Cell_0 _S607 = _S601.crossing_2.warp_1;
    thread Shown_0 _S608 = _S601.shown_3;
    thread Run_0 _S609 = _S601.run_3;
    float _S610 = outline_distance_0(&_S607, &_S608, &_S609, _S606, _S599);
    (&probe_1)->edge_x_0 = _S610;
    thread Cell_0 _S611 = _S601.crossing_2.weft_1;
    thread Shown_0 _S612 = _S601.shown_3;
    thread Run_0 _S613 = _S601.run_3;
    float _S614 = outline_distance_0(&_S611, &_S612, &_S613, _S601.shown_3.is_warp_2, _S600);
    (&probe_1)->edge_y_0 = _S614;
    return probe_1;
}

bool is_free_0(uint _S615, const SearchQuality_0 thread* _S616, float3 _S617, float3 _S618, bool _S619, float _S620, KernelContext_0 thread* kernelContext_48)
{
    float _S621 = _S618.z;
    if(_S621 <= 0.0f)
    {
        return false;
    }
    float _S622 = _S616->shadow_share_0;
    float _S623 = steps_per_length_0(_S615, _S616, _S618, kernelContext_48);
    float _S624 = 1.0f / max(_S622 * _S623, 9.99999971718068537e-10f);
    StepControl_0 _S625 = step_control_0(_S618.xy, _S624);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_4 = 0U;
    float distance_2 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S626;
        if(count_4 < 1024U)
        {
            _S626 = (_S617.z + _S621 * distance_2) < _S620;
        }
        else
        {
            _S626 = false;
        }
        if(_S626)
        {
        }
        else
        {
            break;
        }
        float3 _S627 = _S617 + _S618 * float3(distance_2) ;
        Probe_0 _S628 = probe_0(_S615, _S627.x, _S627.y, _S619, _S625.right_0, _S625.up_0, kernelContext_48);
        float _S629 = _S627.z;
        float _S630 = _S629 - _S628.height_3;
        float _S631 = _S621 - _S628.slope_x_0 * _S618.x - _S628.slope_y_0 * _S618.y;
        bool _S632;
        if(!_S628.hole_4)
        {
            _S632 = _S630 < 0.0f;
        }
        else
        {
            _S632 = false;
        }
        if(_S632)
        {
            return false;
        }
        thread PreviousSample_0 _S633 = previous_3;
        thread Probe_0 _S634 = _S628;
        float _S635 = way_back_to_dip_0(&_S633, _S630, _S631, last_step_0, &_S634);
        if(_S635 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S635;
            distance_2 = distance_2 - _S635;
            last_step_0 = last_step_1;
            count_4 = count_4 + 1U;
            continue;
        }
        bool _S636 = _S629 > (_S628.cell_max_0);
        thread Probe_0 _S637 = _S628;
        PreviousSample_0 _S638 = after_sample_0(_S630, _S631, &_S637, _S636);
        float last_step_2;
        if(_S636)
        {
            thread StepControl_0 _S639 = _S625;
            float _S640 = StepControl_to_cell_exit_0(&_S639, _S628.side_x_0, _S628.side_y_0);
            last_step_2 = max(_S640, _S624);
        }
        else
        {
            thread StepControl_0 _S641 = _S625;
            thread Probe_0 _S642 = _S628;
            float _S643 = StepControl_to_next_sample_0(&_S641, &_S642, _S630, _S631);
            last_step_2 = _S643;
        }
        float distance_3 = distance_2 + last_step_2;
        previous_3 = _S638;
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S644, const SearchQuality_0 thread* _S645, float _S646, float _S647, float3 _S648, bool _S649, KernelContext_0 thread* kernelContext_49)
{
    Fabric_0 device* _S650 = kernelContext_49->fabrics_0+_S644;
    Sample_0 _S651 = sample_at_0(_S644, _S646, _S647, _S649, kernelContext_49);
    if(!_S651.shown_3.hole_3)
    {
        return false;
    }
    float3 _S652 = float3(_S646, _S647, 0.0f);
    bool passes_0 = true;
    uint side_1 = 0U;
    for(;;)
    {
        bool _S653;
        if(side_1 < 2U)
        {
            _S653 = passes_0;
        }
        else
        {
            _S653 = false;
        }
        if(_S653)
        {
        }
        else
        {
            break;
        }
        float3 _S654;
        if(side_1 == 0U)
        {
            _S654 = _S648;
        }
        else
        {
            _S654 = float3(- _S648.x, - _S648.y, _S648.z);
        }
        bool _S655 = is_free_0(_S644, _S645, _S652, _S654, _S649 != (side_1 == 1U), _S650->height_high_0, kernelContext_49);
        uint _S656 = side_1 + 1U;
        passes_0 = _S655;
        side_1 = _S656;
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

float max_height_along_0(uint _S657, float _S658, float _S659, float _S660, float3 _S661, bool _S662, KernelContext_0 thread* kernelContext_50)
{
    Fabric_0 device* _S663 = kernelContext_50->fabrics_0+_S657;
    Cell_0 _S664 = locate_0(_S663->warp_0, _S658, kernelContext_50);
    uint _S665 = _S664.thread_1 / 2U;
    Cell_0 _S666 = locate_0(_S663->weft_0, _S659, kernelContext_50);
    uint _S667 = _S666.thread_1 / 2U;
    float _S668 = _S661.x;
    uint _S669;
    if(_S668 > 0.0f)
    {
        _S669 = 1U;
    }
    else
    {
        _S669 = 0U;
    }
    float _S670 = _S661.y;
    uint _S671;
    if(_S670 > 0.0f)
    {
        _S671 = 2U;
    }
    else
    {
        _S671 = 0U;
    }
    uint _S672 = kernelContext_50->words_0[_S663->max_heights_0 + 4U * (_S667 * _S663->max_height_columns_0 + _S665) + (_S669 + _S671)];
    int number_1;
    if(_S662)
    {
        number_1 = int(4);
    }
    else
    {
        number_1 = int(0);
    }
    uint _S673 = _S672 >> uint(number_1);
    float _S674 = max(abs(_S668) * _S663->threads_per_x_0, abs(_S670) * _S663->threads_per_y_0) / _S661.z;
    float _S675 = _S663->height_high_0;
    float max_height_0 = _S663->height_high_0;
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
        if(((max_height_0 - _S660) * _S674) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, float((_S673 >> uint(int(8) * number_1)) & 15U) * 0.06666667014360428f * _S675);
        }
        number_1 = number_1 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S676, float _S677, float _S678, bool _S679, bool _S680, bool _S681, KernelContext_0 thread* kernelContext_51)
{
    Crossing_0 _S682 = crossing_at_0(_S676, _S677, _S678, _S679, kernelContext_51);
    thread Crossing_0 _S683 = _S682;
    float _S684 = cell_maximum_0(_S676, &_S683, kernelContext_51);
    float _S685;
    if(_S680)
    {
        _S685 = _S682.warp_1.above_0;
    }
    else
    {
        _S685 = _S682.warp_1.below_0;
    }
    float _S686;
    if(_S681)
    {
        _S686 = _S682.weft_1.above_0;
    }
    else
    {
        _S686 = _S682.weft_1.below_0;
    }
    return float3(_S684, _S685, _S686);
}

float first_sample_height_0(uint _S687, const ViewRay_0 thread* _S688, const StepControl_0 thread* _S689, bool _S690, KernelContext_0 thread* kernelContext_52)
{
    float _S691 = max_height_along_0(_S687, _S688->origin_0.x, _S688->origin_0.y, 0.0f, float3(_S688->slope_1, 1.0f), _S690, kernelContext_52);
    uint count_5 = 0U;
    float height_8 = _S691;
    for(;;)
    {
        if(count_5 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S692 = ViewRay_at_0(_S688, height_8);
        float3 _S693 = cell_bounds_0(_S687, _S692.x, _S692.y, _S690, _S689->right_0, _S689->up_0, kernelContext_52);
        float _S694 = height_8 - _S693.x;
        float _S695 = StepControl_to_cell_exit_0(_S689, _S693.y, _S693.z);
        float height_9 = height_8 - clamp(_S694, 0.0f, _S695);
        if(_S694 <= _S695)
        {
            height_8 = height_9;
            break;
        }
        count_5 = count_5 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S696, const ViewRay_0 thread* _S697, const StepControl_0 thread* _S698, bool _S699, KernelContext_0 thread* kernelContext_53)
{
    Fabric_0 device* _S700 = kernelContext_53->fabrics_0+_S696;
    float _S701 = _S700->height_low_0 - (_S700->height_high_0 - _S700->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S702 = first_sample_height_0(_S696, _S697, _S698, _S699, kernelContext_53);
    (&end_1)->height_7 = _S702;
    (&end_1)->last_step_3 = _S698->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
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
        float2 _S703 = ViewRay_at_0(_S697, (&end_1)->height_7);
        Probe_0 _S704 = probe_0(_S696, _S703.x, _S703.y, _S699, _S698->right_0, _S698->up_0, kernelContext_53);
        float _S705 = (&end_1)->height_7 - _S704.height_3;
        thread Probe_0 _S706 = _S704;
        float _S707 = ViewRay_rate_0(_S697, &_S706);
        (&end_1)->depth_1 = - _S705;
        (&end_1)->rate_4 = _S707;
        bool _S708;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S708 = !_S704.hole_4;
        }
        else
        {
            _S708 = false;
        }
        bool _S709;
        if(_S708)
        {
            _S709 = ((&(&end_1)->previous_4)->yarn_0) == (_S704.yarn_1);
        }
        else
        {
            _S709 = false;
        }
        (&end_1)->smooth_0 = _S709;
        bool _S710;
        if(!_S704.hole_4)
        {
            _S710 = _S705 <= 0.0f;
        }
        else
        {
            _S710 = false;
        }
        bool _S711;
        if(_S710)
        {
            _S711 = true;
        }
        else
        {
            _S711 = ((&end_1)->height_7) <= _S701;
        }
        if(_S711)
        {
            break;
        }
        thread PreviousSample_0 _S712 = (&end_1)->previous_4;
        thread Probe_0 _S713 = _S704;
        float _S714 = way_back_to_dip_0(&_S712, _S705, _S707, (&end_1)->last_step_3, &_S713);
        if(_S714 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S714;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S714;
            count_6 = count_6 + 1U;
            continue;
        }
        float _S715 = StepControl_to_cell_exit_0(_S698, _S704.side_x_0, _S704.side_y_0);
        float _S716 = min(_S715, (&end_1)->height_7 - _S704.cell_max_0);
        thread Probe_0 _S717 = _S704;
        float _S718 = StepControl_to_next_sample_0(_S698, &_S717, _S705, _S707);
        bool _S719 = _S716 > _S718;
        thread Probe_0 _S720 = _S704;
        PreviousSample_0 _S721 = after_sample_0(_S705, _S707, &_S720, _S719);
        (&end_1)->previous_4 = _S721;
        float _S722 = max(_S716, _S718);
        (&end_1)->last_step_3 = _S722;
        (&end_1)->height_7 = (&end_1)->height_7 - _S722;
        count_6 = count_6 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S723, const ViewRay_0 thread* _S724, const StepControl_0 thread* _S725, bool _S726, const ViewRayEnd_0 thread* _S727, uint _S728, KernelContext_0 thread* kernelContext_54)
{
    Fabric_0 device* _S729 = kernelContext_54->fabrics_0+_S723;
    float _S730 = _S729->height_high_0 - _S729->height_low_0;
    float _S731 = _S727->height_7;
    float _S732 = _S727->last_step_3;
    float above_2 = _S727->height_7 + _S727->last_step_3;
    float above_gap_1 = clamp((&_S727->previous_4)->clearance_0, 0.0f, _S730);
    float under_gap_1 = clamp(_S727->depth_1, 0.0f, _S730);
    float _S733 = cubic_root_0(above_gap_1, - under_gap_1, (&_S727->previous_4)->rate_0 * _S727->last_step_3, _S727->rate_4 * _S727->last_step_3);
    bool _S734 = _S727->smooth_0;
    float middle_0;
    if(_S727->smooth_0)
    {
        middle_0 = above_2 - _S733 * _S732;
    }
    else
    {
        middle_0 = between_0(above_2, _S731, above_gap_1, under_gap_1);
    }
    float side_2 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S731;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S728)
        {
        }
        else
        {
            break;
        }
        float2 _S735 = ViewRay_at_0(_S724, middle_0);
        Probe_0 _S736 = probe_0(_S723, _S735.x, _S735.y, _S726, _S725->right_0, _S725->up_0, kernelContext_54);
        float _S737;
        if(_S736.hole_4)
        {
            _S737 = -1.0e+09f;
        }
        else
        {
            _S737 = _S736.height_3;
        }
        float _S738 = clamp(middle_0 - _S737, - _S730, _S730);
        float _S739;
        if(_S738 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S739 = 0.5f * above_gap_2;
            }
            else
            {
                _S739 = above_gap_2;
            }
            float _S740 = - _S738;
            under_1 = middle_0;
            above_gap_2 = _S739;
            under_gap_2 = _S740;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S739 = 0.5f * under_gap_2;
            }
            else
            {
                _S739 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S738;
            under_gap_2 = _S739;
            side_2 = -1.0f;
        }
        if(_S734)
        {
            thread Probe_0 _S741 = _S736;
            float _S742 = ViewRay_rate_0(_S724, &_S741);
            middle_0 = clamp(middle_0 + _S738 / min(_S742, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S734)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S743, const SearchQuality_0 thread* _S744, float _S745, float _S746, float3 _S747, bool _S748, KernelContext_0 thread* kernelContext_55)
{
    float _S749 = max(_S747.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S745, _S746);
    float2 _S750 = _S747.xy / float2(_S749) ;
    (&ray_0)->slope_1 = _S750;
    float2 _S751 = - _S750;
    float _S752 = steps_per_length_0(_S743, _S744, _S747, kernelContext_55);
    StepControl_0 _S753 = step_control_0(_S751, 1.0f / max(_S752 / _S749, 9.99999971718068537e-10f));
    thread ViewRay_0 _S754 = ray_0;
    thread StepControl_0 _S755 = _S753;
    ViewRayEnd_0 _S756 = search_down_0(_S743, &_S754, &_S755, _S748, kernelContext_55);
    thread Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    thread ViewRay_0 _S757 = ray_0;
    thread StepControl_0 _S758 = _S753;
    thread ViewRayEnd_0 _S759 = _S756;
    float _S760 = refined_height_0(_S743, &_S757, &_S758, _S748, &_S759, _S744->refinements_0, kernelContext_55);
    (&hit_0)->height_5 = _S760;
    thread ViewRay_0 _S761 = ray_0;
    float2 _S762 = ViewRay_at_0(&_S761, _S760);
    (&hit_0)->x_13 = _S762.x;
    (&hit_0)->y_7 = _S762.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S763, const SearchQuality_0 thread* _S764, float _S765, float _S766, float3 _S767, bool _S768, KernelContext_0 thread* kernelContext_56)
{
    bool _S769 = passes_through_0(_S763, _S764, _S765, _S766, _S767, _S768, kernelContext_56);
    if(!_S769)
    {
        Hit_0 _S770 = first_hit_of_yarn_0(_S763, _S764, _S765, _S766, _S767, _S768, kernelContext_56);
        return _S770;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_13 = _S765;
    (&hit_1)->y_7 = _S766;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S771, float _S772, float _S773, bool _S774, KernelContext_0 thread* kernelContext_57)
{
    Fabric_0 device* _S775 = kernelContext_57->fabrics_0+_S771;
    Sample_0 _S776 = sample_at_0(_S771, _S772, _S773, _S774, kernelContext_57);
    float _S777;
    if(_S776.shown_3.is_warp_2)
    {
        _S777 = _S776.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S777 = _S776.crossing_2.weft_1.half_width_1;
    }
    uint _S778;
    if(_S776.shown_3.is_warp_2)
    {
        _S778 = _S775->warp_0;
    }
    else
    {
        _S778 = _S775->weft_0;
    }
    Family_0 _S779 = kernelContext_57->families_0[_S778];
    float _S780;
    if(_S774)
    {
        _S780 = -1.0f;
    }
    else
    {
        _S780 = 1.0f;
    }
    float _S781 = _S779.twist_sine_0 * _S780;
    Family_0 _S782 = kernelContext_57->families_0[_S778];
    if(_S776.shown_3.is_warp_2)
    {
        _S780 = 1.0f;
    }
    else
    {
        _S780 = -1.0f;
    }
    float2 _S783 = fibre_direction_0(_S776.slope_across_0, _S780 * _S776.slope_along_0, _S781, _S782.twist_cosine_0);
    float _S784;
    if(_S776.shown_3.is_warp_2)
    {
        _S784 = _S776.slope_x_1;
    }
    else
    {
        _S784 = _S776.slope_y_1;
    }
    float _S785;
    if(_S776.shown_3.is_warp_2)
    {
        _S785 = _S776.slope_y_1;
    }
    else
    {
        _S785 = _S776.slope_x_1;
    }
    float _S786 = _S783.x;
    float _S787 = _S783.y;
    float _S788 = _S784 * _S786 + _S780 * _S785 * _S787;
    float _S789 = _S777 * 1.0154266357421875f;
    float _S790 = _S789 * arc_sine_0(clamp(_S776.section_1.across_3 / _S789, -1.0f, 1.0f));
    if(_S776.shown_3.is_warp_2)
    {
        _S777 = _S773;
    }
    else
    {
        _S777 = - _S772;
    }
    thread SurfacePoint_0 point_3;
    (&point_3)->hole_0 = _S776.shown_3.hole_3;
    (&point_3)->is_warp_0 = _S776.shown_3.is_warp_2;
    (&point_3)->warp_thread_0 = _S776.crossing_2.warp_1.thread_1;
    (&point_3)->weft_thread_0 = _S776.crossing_2.weft_1.thread_1;
    (&point_3)->height_1 = _S776.height_6;
    (&point_3)->normal_1 = normalize(float3(- _S776.slope_x_1, - _S776.slope_y_1, 1.0f));
    float3 _S791;
    if(_S776.shown_3.is_warp_2)
    {
        _S791 = float3(_S786, _S787, _S788);
    }
    else
    {
        _S791 = float3(- _S787, _S786, _S788);
    }
    (&point_3)->tangent_0 = normalize(_S791);
    (&point_3)->across_0 = _S776.section_1.across_3;
    (&point_3)->fibre_across_0 = _S790 * _S782.twist_cosine_0 + _S777 * _S781;
    (&point_3)->fibre_along_0 = _S777 * _S782.twist_cosine_0 - _S790 * _S781;
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

Albedos_0 vary_albedos_0(uint _S792, const Albedos_0 thread* _S793, uint _S794, uint _S795, KernelContext_0 thread* kernelContext_58)
{
    Fabric_0 device* _S796 = kernelContext_58->fabrics_0+_S792;
    float3 _S797 = max(_S793->specular_reflect_0, _S793->specular_transmit_0);
    float3 _S798 = _S793->diffuse_reflect_0 + _S793->diffuse_transmit_0;
    float3 _S799 = float3(_S796->layer_bound_0) ;
    float3 _S800 = float3(1.0f) ;
    float3 _S801 = float3(bounded_gain_0(thread_gain_0(_S794, _S796->colour_noise_0, _S796->seed_0), _S798, _S800 - _S799 * _S797)) ;
    float _S802 = bounded_gain_0(fibre_gain_0(_S794, _S795, _S796->fibre_noise_0, _S796->seed_0), _S797, min((_S800 - _S801 * _S798) / _S799, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S801 * _S793->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S801 * _S793->diffuse_transmit_0;
    float3 _S803 = float3(_S802) ;
    (&varied_0)->specular_reflect_0 = _S803 * _S793->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S803 * _S793->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S804, const SurfacePoint_0 thread* _S805, const Albedos_0 thread* _S806, float _S807, float _S808, KernelContext_0 thread* kernelContext_59)
{
    Fabric_0 device* _S809 = kernelContext_59->fabrics_0+_S804;
    bool _S810 = _S805->is_warp_0;
    float _S811;
    if(_S805->is_warp_0)
    {
        _S811 = _S807;
    }
    else
    {
        _S811 = _S808;
    }
    float _S812 = _S811 - _S805->across_0;
    uint _S813;
    if(_S810)
    {
        _S813 = _S809->warp_0;
    }
    else
    {
        _S813 = _S809->weft_0;
    }
    Family_0 _S814 = kernelContext_59->families_0[_S813];
    int _S815 = int(kernelContext_59->families_0[_S813].count_0);
    if(_S810)
    {
        _S813 = _S805->warp_thread_0;
    }
    else
    {
        _S813 = _S805->weft_thread_0;
    }
    uint _S816 = uint(int(floor(_S812 / _S814.period_0)) * _S815 + int(_S813)) * 2U;
    if(_S810)
    {
        _S813 = 1U;
    }
    else
    {
        _S813 = 0U;
    }
    float _S817 = floor(_S805->fibre_across_0 / _S809->fibre_size_0);
    Albedos_0 _S818 = vary_albedos_0(_S804, _S806, _S816 + _S813, uint(int(_S817)) * 65536U + uint(int(floor(_S805->fibre_along_0 / (_S809->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S817))), kernelContext_59);
    return _S818;
}

YarnPoint_0 yarn_point_of_0(uint _S819, const SurfacePoint_0 thread* _S820, float _S821, float _S822, bool _S823, bool _S824, KernelContext_0 thread* kernelContext_60)
{
    Fabric_0 device* _S825 = kernelContext_60->fabrics_0+_S819;
    bool _S826 = _S820->is_warp_0;
    uint _S827;
    if(_S820->is_warp_0)
    {
        _S827 = _S825->warp_0;
    }
    else
    {
        _S827 = _S825->weft_0;
    }
    uint _S828;
    if(_S826)
    {
        _S828 = _S820->warp_thread_0;
    }
    else
    {
        _S828 = _S820->weft_thread_0;
    }
    Albedos_0 _S829 = albedos_of_0(_S827, _S828, kernelContext_60);
    bool _S830;
    if((_S825->fibre_noise_0) > 0.0f)
    {
        _S830 = true;
    }
    else
    {
        _S830 = (_S825->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_7;
    if(_S830)
    {
        thread Albedos_0 _S831 = _S829;
        Albedos_0 _S832 = varied_at_0(_S819, _S820, &_S831, _S821, _S822, kernelContext_60);
        albedos_7 = _S832;
    }
    else
    {
        albedos_7 = _S829;
    }
    thread YarnPoint_0 point_4;
    (&point_4)->back_4 = _S823;
    (&point_4)->hole_6 = _S824;
    (&point_4)->is_warp_3 = _S826;
    (&point_4)->x_14 = _S821;
    (&point_4)->y_8 = _S822;
    (&point_4)->height_10 = _S820->height_1;
    (&point_4)->normal_7 = _S820->normal_1;
    (&point_4)->tangent_7 = _S820->tangent_0;
    (&point_4)->roughness_10 = kernelContext_60->families_0[_S827].roughness_0;
    (&point_4)->albedos_6 = albedos_7;
    return point_4;
}

bool unoccluded_0(uint _S833, const SearchQuality_0 thread* _S834, float _S835, float _S836, float _S837, float3 _S838, bool _S839, KernelContext_0 thread* kernelContext_61)
{
    Fabric_0 device* _S840 = kernelContext_61->fabrics_0+_S833;
    if((_S838.z) <= 0.0f)
    {
        return false;
    }
    float _S841 = max_height_along_0(_S833, _S835, _S836, _S837, _S838, _S839, kernelContext_61);
    bool _S842 = is_free_0(_S833, _S834, float3(_S835, _S836, _S837 + _S840->lift_0), _S838, _S839, _S841, kernelContext_61);
    return _S842;
}

bool is_lit_0(uint _S843, const SearchQuality_0 thread* _S844, const YarnPoint_0 thread* _S845, float3 _S846, KernelContext_0 thread* kernelContext_62)
{
    if(_S845->hole_6)
    {
        return true;
    }
    bool _S847 = _S845->back_4;
    float3 _S848 = to_face_frame_0(_S846, _S845->back_4);
    float _S849 = _S848.z;
    bool _S850 = _S849 < 0.0f;
    float3 _S851 = _S845->normal_7;
    float _S852 = _S845->height_10;
    float3 normal_8;
    float height_11;
    if(_S850)
    {
        SurfacePoint_0 _S853 = surface_at_0(_S843, _S845->x_14, _S845->y_8, !_S847, kernelContext_62);
        normal_8 = _S853.normal_1;
        height_11 = _S853.height_1;
    }
    else
    {
        normal_8 = _S851;
        height_11 = _S852;
    }
    float3 _S854 = float3(_S848.xy, abs(_S849));
    if((dot(normal_8, _S854)) <= 0.0f)
    {
        return false;
    }
    bool _S855 = unoccluded_0(_S843, _S844, _S845->x_14, _S845->y_8, height_11, _S854, _S847 != _S850, kernelContext_62);
    return _S855;
}

Components_0 components_of_point_0(uint _S856, const SearchQuality_0 thread* _S857, const YarnPoint_0 thread* _S858, float3 _S859, float3 _S860, KernelContext_0 thread* kernelContext_63)
{
    Fabric_0 device* _S861 = kernelContext_63->fabrics_0+_S856;
    thread Components_0 result_2 = no_components_0();
    bool _S862 = _S858->hole_6;
    float _S863;
    if(_S858->hole_6)
    {
        _S863 = 1.0f;
    }
    else
    {
        _S863 = 0.0f;
    }
    (&result_2)->hole_2 = _S863;
    bool _S864;
    if(_S862)
    {
        _S864 = true;
    }
    else
    {
        bool _S865 = is_lit_0(_S856, _S857, _S858, _S859, kernelContext_63);
        _S864 = !_S865;
    }
    if(_S864)
    {
        return result_2;
    }
    float3 _S866 = to_face_frame_0(_S859, _S858->back_4);
    float3 _S867 = to_face_frame_0(_S860, _S858->back_4);
    bool _S868 = (_S866.z) < 0.0f;
    float3 _S869;
    if(_S868)
    {
        _S869 = - _S866;
    }
    else
    {
        _S869 = _S866;
    }
    float3 _S870 = _S858->normal_7;
    float _S871 = diffuse_reflection_0(_S869, _S858->normal_7, _S861->diffuse_blend_0);
    if(_S868)
    {
        _S863 = transmission_0(_S866, _S867, _S870, _S858->tangent_7, _S858->roughness_10, _S861->optical_depth_0);
    }
    else
    {
        _S863 = reflection_0(_S866, _S867, _S870, _S858->tangent_7, _S858->roughness_10, _S861->optical_depth_0);
    }
    bool _S872 = _S858->is_warp_3;
    float _S873;
    if(_S858->is_warp_3)
    {
        _S873 = _S871;
    }
    else
    {
        _S873 = 0.0f;
    }
    (&result_2)->diffuse_warp_0 = _S873;
    if(_S872)
    {
        _S873 = 0.0f;
    }
    else
    {
        _S873 = _S871;
    }
    (&result_2)->diffuse_weft_0 = _S873;
    if(_S872)
    {
        _S873 = _S863;
    }
    else
    {
        _S873 = 0.0f;
    }
    (&result_2)->specular_warp_0 = _S873;
    if(_S872)
    {
        _S863 = 0.0f;
    }
    (&result_2)->specular_weft_0 = _S863;
    (&result_2)->light_visibility_1 = 1.0f;
    return result_2;
}

struct CoverageTaps_0
{
    array<uint, int(9)> nodes_1;
};

float3 pyramid_level_0(uint _S874, float _S875, KernelContext_0 thread* kernelContext_64)
{
    uint _S876 = (kernelContext_64->fabrics_0+_S874)->lobes_0.levels_0 + 4U * uint(min(_S875, (kernelContext_64->fabrics_0+_S874)->lobes_0.last_level_0));
    float _S877 = table_number_0(_S876, kernelContext_64);
    float _S878 = table_number_0(_S876 + 1U, kernelContext_64);
    float _S879 = table_number_0(_S876 + 2U, kernelContext_64);
    return float3(_S877, _S878, _S879);
}

CoverageTaps_0 coverage_taps_0(uint _S880, const Footprint_0 thread* _S881, bool _S882, KernelContext_0 thread* kernelContext_65)
{
    Fabric_0 device* _S883 = kernelContext_65->fabrics_0+_S880;
    float _S884 = Footprint_spread_side_0(_S881);
    Lobes_0 _S885 = _S883->lobes_0;
    float _S886 = _S884 * _S883->lobes_0.inverse_base_size_0;
    float3 _S887 = pyramid_level_0(_S880, floor(binary_logarithm_0(max(0.68000000715255737f * _S886, 1.0f))), kernelContext_65);
    float _S888 = 1.0f / max(_S886, 9.99999997475242708e-07f);
    float2 _S889 = float2(kernelContext_65->families_0[_S883->warp_0].inverse_period_0, kernelContext_65->families_0[_S883->weft_0].inverse_period_0);
    float2 _S890 = _S881->centre_0 * _S889;
    float2 _S891 = float2(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S888 * _S888), 0.0f, 1.0f)), 0.3333333432674408f * _S888), 1.0f)) ;
    float2 _S892 = _S881->dx_0 * _S889 * _S891;
    float2 _S893 = _S881->dy_0 * _S889 * _S891;
    thread CoverageTaps_0 taps_3;
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
        float2 _S894 = _S890 + float2(TAP_OFFSETS_0[number_2].x)  * _S892 + float2(TAP_OFFSETS_0[number_2].y)  * _S893;
        float _S895 = _S887.y;
        float _S896 = wrapped_cell_0(_S894.x, _S895);
        float _S897 = wrapped_cell_0(_S894.y, _S887.z);
        uint _S898;
        if(_S882)
        {
            _S898 = _S885.face_nodes_0;
        }
        else
        {
            _S898 = 0U;
        }
        (&taps_3)->nodes_1[number_2] = _S898 + uint(_S897 * _S895 + _S896 + _S887.x);
        number_2 = number_2 + 1U;
    }
    return taps_3;
}

float4 coverage_of_pack_0(uint _S899, const CoverageTaps_0 thread* _S900, uint _S901, KernelContext_0 thread* kernelContext_66)
{
    Fabric_0 device* _S902 = kernelContext_66->fabrics_0+_S899;
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
        uint _S903 = kernelContext_66->words_0[_S902->lobes_0.coverage_0 + _S900->nodes_1[number_3] * _S902->lobes_0.packs_0 + _S901];
        uint even_2 = even_1 + (_S903 & 16711935U);
        uint odd_2 = odd_1 + ((_S903 >> 8U) & 16711935U);
        number_3 = number_3 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / float4(9.0f) ;
}

float coverage_of_holes_0(uint _S904, const CoverageTaps_0 thread* _S905, KernelContext_0 thread* kernelContext_67)
{
    Fabric_0 device* _S906 = kernelContext_67->fabrics_0+_S904;
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
        uint total_1 = total_0 + ((kernelContext_67->words_0[_S906->lobes_0.coverage_holes_0 + _S905->nodes_1[number_4] / 4U] >> (8U * (_S905->nodes_1[number_4] % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S907, const CoverageTaps_0 thread* _S908, const NodeTaps_0 thread* _S909, bool _S910, KernelContext_0 thread* kernelContext_68)
{
    Lobes_0 _S911 = (kernelContext_68->fabrics_0+_S907)->lobes_0;
    float4 _S912 = interpolate_table_0(_S909, (kernelContext_68->fabrics_0+_S907)->lobes_0.projected_area_0 + (kernelContext_68->fabrics_0+_S907)->lobes_0.packs_0, (kernelContext_68->fabrics_0+_S907)->lobes_0.packs_0 + 1U, kernelContext_68);
    float _S913 = _S912.x;
    float _S914;
    if(_S910)
    {
        _S914 = _S911.back_hole_weight_0;
    }
    else
    {
        _S914 = _S911.front_hole_weight_0;
    }
    float _S915 = coverage_of_holes_0(_S907, _S908, kernelContext_68);
    return min(_S915 * _S913 * _S913 * _S914, 1.0f);
}

Components_0 prefiltered_components_0(uint _S916, const Footprint_0 thread* _S917, float3 _S918, float3 _S919, bool _S920, KernelContext_0 thread* kernelContext_69)
{
    Fabric_0 device* _S921 = kernelContext_69->fabrics_0+_S916;
    CoverageTaps_0 _S922 = coverage_taps_0(_S916, _S917, _S920, kernelContext_69);
    NodeTaps_0 _S923 = node_taps_0(_S919);
    thread NodeTaps_0 view_nodes_0 = _S923;
    thread NodeTaps_0 light_nodes_0 = node_taps_0(_S918);
    thread NodeTaps_0 seen_nodes_0 = _S923;
    uint _S924;
    if(_S920)
    {
        _S924 = 1U;
    }
    else
    {
        _S924 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + uint4((_S924 * 256U)) ;
    uint _S925 = 2U * _S924;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + uint4((_S925 * 256U)) ;
    uint _S926;
    if((_S918.z) < 0.0f)
    {
        _S926 = 1U;
    }
    else
    {
        _S926 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + uint4(((_S925 + _S926) * 256U)) ;
    float3 _S927 = half_vector_0(_S918, _S919);
    float3 _S928 = shadow_correlation_0(_S918, _S919);
    if(_S920)
    {
        _S926 = _S921->lobes_0.back_warp_packs_0;
    }
    else
    {
        _S926 = _S921->lobes_0.front_warp_packs_0;
    }
    thread Components_0 sums_1;
    (&sums_1)->diffuse_warp_0 = 0.0f;
    (&sums_1)->diffuse_weft_0 = 0.0f;
    (&sums_1)->specular_warp_0 = 0.0f;
    (&sums_1)->specular_weft_0 = 0.0f;
    (&sums_1)->light_visibility_1 = 0.0f;
    uint pack_0 = 0U;
    float total_2 = 0.0f;
    for(;;)
    {
        Lobes_0 _S929 = _S921->lobes_0;
        if(pack_0 < (_S921->lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        thread CoverageTaps_0 _S930 = _S922;
        float4 _S931 = coverage_of_pack_0(_S916, &_S930, pack_0, kernelContext_69);
        uint _S932 = _S929.projected_area_0 + pack_0;
        uint _S933 = _S929.packs_0 + 1U;
        thread NodeTaps_0 _S934 = view_nodes_0;
        float4 _S935 = interpolate_table_0(&_S934, _S932, _S933, kernelContext_69);
        uint _S936 = _S929.light_visibility_0 + pack_0;
        thread NodeTaps_0 _S937 = seen_nodes_0;
        float4 _S938 = interpolate_table_0(&_S937, _S936, _S929.packs_0, kernelContext_69);
        float4 _S939 = float4(255.0f) ;
        float4 _S940 = _S938 / _S939;
        thread NodeTaps_0 _S941 = light_nodes_0;
        float4 _S942 = interpolate_table_0(&_S941, _S936, _S929.packs_0, kernelContext_69);
        float4 _S943 = _S942 / _S939;
        uint _S944 = _S929.irradiance_0 + pack_0;
        thread NodeTaps_0 _S945 = light_nodes_0;
        float4 _S946 = interpolate_table_0(&_S945, _S944, _S929.packs_0, kernelContext_69);
        float4 _S947 = _S946 * float4(0.00124827399849892f) ;
        bool _S948 = pack_0 < _S926;
        uint _S949;
        if(_S948)
        {
            _S949 = _S921->warp_0;
        }
        else
        {
            _S949 = _S921->weft_0;
        }
        Family_0 _S950 = kernelContext_69->families_0[_S949];
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
            Group_0 _S951 = group_at_0(_S929.moments_0 + 12U * (4U * (_S924 * _S929.packs_0 + pack_0) + number_5), _S950.roughness_0, kernelContext_69);
            float _S952 = _S931[number_5] * _S935[number_5] * _S935[number_5] * _S951.weight_1;
            float2 _S953 = visibility_gain_0(_S928, _S943[number_5], _S940[number_5]);
            thread Group_0 _S954 = _S951;
            float _S955 = layer_value_0(&_S954, _S927, _S918, _S919, _S921->optical_depth_0);
            float _S956 = _S953.x;
            float diffuse_1 = diffuse_0 + _S952 * _S947[number_5] * _S956;
            float specular_1 = specular_0 + _S952 * _S955 * _S943[number_5] * _S953.y;
            (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 + _S952 * _S943[number_5] * _S956;
            float total_3 = total_2 + _S952;
            number_5 = number_5 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S957;
        if(_S948)
        {
            _S957 = diffuse_0;
        }
        else
        {
            _S957 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S957;
        float _S958;
        if(_S948)
        {
            _S958 = 0.0f;
        }
        else
        {
            _S958 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S958;
        float _S959;
        if(_S948)
        {
            _S959 = specular_0;
        }
        else
        {
            _S959 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S959;
        float _S960;
        if(_S948)
        {
            _S960 = 0.0f;
        }
        else
        {
            _S960 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S960;
        pack_0 = pack_0 + 1U;
    }
    thread CoverageTaps_0 _S961 = _S922;
    thread NodeTaps_0 _S962 = view_nodes_0;
    float _S963 = prefiltered_hole_0(_S916, &_S961, &_S962, _S920, kernelContext_69);
    (&sums_1)->hole_2 = _S963;
    float _S964 = (1.0f - _S963) / max(total_2, 9.999999960041972e-13f);
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S964;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S964;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S964;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S964;
    (&sums_1)->light_visibility_1 = (&sums_1)->light_visibility_1 * _S964;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S965, const Footprint_0 thread* _S966, bool _S967, KernelContext_0 thread* kernelContext_70)
{
    Fabric_0 device* _S968 = kernelContext_70->fabrics_0+_S965;
    float2 _S969 = sqrt(_S966->dx_0 * _S966->dx_0 + _S966->dy_0 * _S966->dy_0);
    uint _S970 = _S968->warp_0;
    float2 _S971 = _S966->centre_0;
    Stretch_0 _S972 = stretch_of_0(_S968->warp_0, _S966->centre_0.x, _S969.x, kernelContext_70);
    uint _S973 = _S968->weft_0;
    Stretch_0 _S974 = stretch_of_0(_S968->weft_0, _S971.y, _S969.y, kernelContext_70);
    thread FamilyAlbedos_0 albedos_8;
    thread Stretch_0 _S975 = _S972;
    thread Stretch_0 _S976 = _S974;
    Albedos_0 _S977 = mean_albedos_0(_S970, _S973, &_S975, &_S976, _S967, kernelContext_70);
    (&albedos_8)->warp_2 = _S977;
    thread Stretch_0 _S978 = _S974;
    thread Stretch_0 _S979 = _S972;
    Albedos_0 _S980 = mean_albedos_0(_S973, _S970, &_S978, &_S979, _S967, kernelContext_70);
    (&albedos_8)->weft_2 = _S980;
    return albedos_8;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S981, const Footprint_0 thread* _S982, float _S983, float2 _S984, float3 _S985, float3 _S986, KernelContext_0 thread* kernelContext_71)
{
    float _S987;
    Fabric_0 device* _S988 = kernelContext_71->fabrics_0+_S981;
    Regime_0 _S989 = regime_of_0(_S981, _S982, _S983, kernelContext_71);
    bool _S990 = (_S986.z) < 0.0f;
    float3 _S991 = to_face_frame_0(_S986, _S990);
    bool _S992;
    if((_S988->fibre_noise_0) > 0.0f)
    {
        _S992 = true;
    }
    else
    {
        _S992 = (_S988->colour_noise_0) > 0.0f;
    }
    bool _S993;
    if((kernelContext_71->families_0[_S988->warp_0].quantities_0) > 1U)
    {
        _S993 = true;
    }
    else
    {
        _S993 = (kernelContext_71->families_0[_S988->weft_0].quantities_0) > 1U;
    }
    float _S994 = 1.0f - _S989.prefiltered_0;
    if(_S994 > 0.0f)
    {
        if(_S992)
        {
            _S993 = true;
        }
    }
    else
    {
        _S993 = false;
    }
    thread Footprint_0 box_0 = *_S982;
    float3 _S995 = float3(0.0f) ;
    SurfacePoint_0 _S996 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S995, _S995, 0.0f, 0.0f, 0.0f);
    float2 _S997 = _S982->centre_0;
    Components_0 _S998 = no_components_0();
    int _S999;
    if(_S993)
    {
        _S999 = int(0);
    }
    else
    {
        _S999 = int(1);
    }
    uint _S1000 = uint(_S999);
    Components_0 points_1 = _S998;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S996;
    float2 central_place_0 = _S997;
    uint number_6 = _S1000;
    for(;;)
    {
        float _S1001 = float(number_6);
        _S987 = _S989.points_0;
        if(_S1001 < (_S989.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S1002 = number_6 == 0U;
        uint _S1003;
        if(_S1002)
        {
            _S1003 = 0U;
        }
        else
        {
            _S1003 = number_6 - 1U;
        }
        float2 _S1004 = POINT_OFFSETS_0[_S1003] + _S984;
        float2 _S1005;
        if(_S1002)
        {
            _S1005 = float2(0.0f) ;
        }
        else
        {
            _S1005 = _S1004 - round(_S1004);
        }
        float2 _S1006 = _S997 + float2(_S1005.x)  * _S982->dx_0 + float2(_S1005.y)  * _S982->dy_0;
        float _S1007;
        if(_S1002)
        {
            _S1007 = 0.0f;
        }
        else
        {
            _S1007 = _S989.threads_1;
        }
        SearchQuality_0 _S1008 = quality_of_0(_S1007);
        float _S1009 = _S1006.x;
        float _S1010 = _S1006.y;
        thread SearchQuality_0 _S1011 = _S1008;
        Hit_0 _S1012 = first_hit_0(_S981, &_S1011, _S1009, _S1010, _S991, _S990, kernelContext_71);
        SurfacePoint_0 _S1013 = surface_at_0(_S981, _S1012.x_13, _S1012.y_7, _S990, kernelContext_71);
        if(_S1002)
        {
            float central_weight_1;
            if(_S1012.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S994;
            }
            float2 central_place_1 = float2(_S1012.x_13, _S1012.y_7);
            (&box_0)->centre_0 = mix(_S997, central_place_1, float2(central_weight_1) );
            central_weight_0 = central_weight_1;
            central_0 = _S1013;
            central_place_0 = central_place_1;
            number_6 = number_6 + 1U;
            continue;
        }
        thread SurfacePoint_0 _S1014 = _S1013;
        YarnPoint_0 _S1015 = yarn_point_of_0(_S981, &_S1014, _S1012.x_13, _S1012.y_7, _S990, _S1012.hole_5, kernelContext_71);
        thread SearchQuality_0 _S1016 = _S1008;
        thread YarnPoint_0 _S1017 = _S1015;
        Components_0 _S1018 = components_of_point_0(_S981, &_S1016, &_S1017, _S985, _S986, kernelContext_71);
        float _S1019 = min(_S989.points_0 - float(number_6 - 1U), 1.0f);
        thread Components_0 _S1020 = points_1;
        thread Components_0 _S1021 = _S1018;
        Components_0 _S1022 = with_added_0(&_S1020, &_S1021, _S1019);
        points_1 = _S1022;
        number_6 = number_6 + 1U;
    }
    thread Estimate_0 estimate_0;
    float _S1023 = _S994 / max(_S987, 1.0f);
    thread Components_0 _S1024 = _S998;
    thread Components_0 _S1025 = points_1;
    Components_0 _S1026 = with_added_0(&_S1024, &_S1025, _S1023);
    (&estimate_0)->components_0 = _S1026;
    if((_S989.prefiltered_0) > 0.0f)
    {
        Components_0 _S1027 = prefiltered_components_0(_S981, _S982, to_face_frame_0(_S985, _S990), _S991, _S990, kernelContext_71);
        thread Components_0 _S1028 = (&estimate_0)->components_0;
        thread Components_0 _S1029 = _S1027;
        Components_0 _S1030 = with_added_0(&_S1028, &_S1029, _S989.prefiltered_0);
        (&estimate_0)->components_0 = _S1030;
    }
    thread Footprint_0 _S1031 = box_0;
    FamilyAlbedos_0 _S1032 = albedos_over_0(_S981, &_S1031, _S990, kernelContext_71);
    (&estimate_0)->albedos_5 = _S1032;
    if(_S992)
    {
        _S992 = central_weight_0 > 0.0f;
    }
    else
    {
        _S992 = false;
    }
    if(_S992)
    {
        SurfacePoint_0 _S1033 = central_0;
        Albedos_0 _S1034;
        if(central_0.is_warp_0)
        {
            _S1034 = (&(&estimate_0)->albedos_5)->warp_2;
        }
        else
        {
            _S1034 = (&(&estimate_0)->albedos_5)->weft_2;
        }
        float _S1035 = central_place_0.x;
        float _S1036 = central_place_0.y;
        thread SurfacePoint_0 _S1037 = central_0;
        thread Albedos_0 _S1038 = _S1034;
        Albedos_0 _S1039 = varied_at_0(_S981, &_S1037, &_S1038, _S1035, _S1036, kernelContext_71);
        thread Albedos_0 _S1040 = _S1034;
        thread Albedos_0 _S1041 = _S1039;
        Albedos_0 _S1042 = lerp_albedos_0(&_S1040, &_S1041, central_weight_0);
        if(_S1033.is_warp_0)
        {
            (&(&estimate_0)->albedos_5)->warp_2 = _S1042;
        }
        else
        {
            (&(&estimate_0)->albedos_5)->weft_2 = _S1042;
        }
    }
    return estimate_0;
}

float3 composed_0(uint _S1043, const Components_0 thread* _S1044, const FamilyAlbedos_0 thread* _S1045, float3 _S1046, float3 _S1047, KernelContext_0 thread* kernelContext_72)
{
    Fabric_0 device* _S1048 = kernelContext_72->fabrics_0+_S1043;
    float3 _S1049 = float3(_S1044->diffuse_warp_0) ;
    float3 _S1050 = float3(_S1044->diffuse_weft_0) ;
    float3 _S1051 = float3(_S1044->specular_warp_0) ;
    float3 _S1052 = float3(_S1044->specular_weft_0) ;
    float3 _S1053 = (&_S1045->warp_2)->diffuse_reflect_0 * _S1049 + (&_S1045->weft_2)->diffuse_reflect_0 * _S1050 + (&_S1045->warp_2)->specular_reflect_0 * _S1051 + (&_S1045->weft_2)->specular_reflect_0 * _S1052;
    float _S1054 = _S1047.z;
    float3 body_0;
    if((_S1046.z * _S1054) < 0.0f)
    {
        body_0 = (&_S1045->warp_2)->diffuse_transmit_0 * _S1049 + (&_S1045->weft_2)->diffuse_transmit_0 * _S1050 + (&_S1045->warp_2)->specular_transmit_0 * _S1051 + (&_S1045->weft_2)->specular_transmit_0 * _S1052;
    }
    else
    {
        body_0 = _S1053;
    }
    float _S1055 = _S1048->sheen_strength_0;
    if((_S1048->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S1056 = _S1054 < 0.0f;
    float2 _S1057 = sheen_with_transmittance_0(to_face_frame_0(_S1046, _S1056), to_face_frame_0(_S1047, _S1056), _S1055, _S1048->sheen_roughness_0);
    return float3(_S1057.y)  * body_0 + float3(((_S1044->light_visibility_1 + _S1044->hole_2) * _S1057.x)) ;
}

float4 light_of_footprint_0(int _S1058, uint _S1059, const VisiblePoint_0 thread* _S1060, uint2 _S1061, float3 _S1062, KernelContext_0 thread* kernelContext_73)
{
    Frame_0 device* _S1063 = kernelContext_73->frames_0+_S1058;
    Fabric_0 device* _S1064 = kernelContext_73->fabrics_0+_S1059;
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S1060->draft_0;
    (&footprint_0)->dx_0 = _S1060->draft_dx_0;
    (&footprint_0)->dy_0 = _S1060->draft_dy_0;
    float2 _S1065 = fract(float2(float((_S1063->pass_number_0) & 65535U))  * float2(0.75487768650054932f, 0.56984031200408936f));
    float3 _S1066 = to_local_0(_S1060, _S1060->view_0);
    uint _S1067 = light_sample_count_0(_S1058, kernelContext_73);
    float3 _S1068 = float3(0.0f) ;
    uint number_7 = 0U;
    float3 radiance_1 = _S1068;
    float hole_7 = 0.0f;
    for(;;)
    {
        if(number_7 < (max(_S1067, 1U)))
        {
        }
        else
        {
            break;
        }
        float _S1069;
        if(number_7 < _S1067)
        {
            float _S1070 = visibility_at_0(_S1058, number_7, _S1061, kernelContext_73);
            _S1069 = _S1070;
        }
        else
        {
            _S1069 = 0.0f;
        }
        bool _S1071;
        if(_S1069 <= 0.0f)
        {
            _S1071 = number_7 > 0U;
        }
        else
        {
            _S1071 = false;
        }
        if(_S1071)
        {
            number_7 = number_7 + 1U;
            continue;
        }
        LightSample_0 _S1072 = light_sample_0(_S1058, number_7, _S1061, _S1060->position_0, kernelContext_73);
        float3 _S1073 = to_local_0(_S1060, _S1072.towards_0);
        thread Footprint_0 _S1074 = footprint_0;
        Estimate_0 _S1075 = lobes_estimate_of_pass_0(_S1059, &_S1074, 1.0f, _S1065, _S1073, _S1066, kernelContext_73);
        thread FamilyAlbedos_0 albedos_9;
        thread Albedos_0 _S1076 = _S1075.albedos_5.warp_2;
        Albedos_0 _S1077 = tinted_0(&_S1076, _S1062);
        (&albedos_9)->warp_2 = _S1077;
        thread Albedos_0 _S1078 = _S1075.albedos_5.weft_2;
        Albedos_0 _S1079 = tinted_0(&_S1078, _S1062);
        (&albedos_9)->weft_2 = _S1079;
        float3 _S1080 = float3(_S1069)  * _S1072.irradiance_1;
        thread Components_0 _S1081 = _S1075.components_0;
        thread FamilyAlbedos_0 _S1082 = albedos_9;
        float3 _S1083 = composed_0(_S1059, &_S1081, &_S1082, _S1073, _S1066, kernelContext_73);
        radiance_1 = radiance_1 + _S1080 * _S1083;
        hole_7 = _S1075.components_0.hole_2;
        number_7 = number_7 + 1U;
    }
    float _S1084 = _S1064->sheen_strength_0;
    if((_S1064->sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S1084 * sheen_lobe_0(abs(_S1066.z), _S1064->sheen_roughness_0).z);
    }
    return float4(radiance_1, 1.0f - hole_7);
}

[[kernel]] void shade_lobes(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], uint device* scene_words_1 [[buffer(11)]], float device* visibilities_1 [[buffer(13)]], Light_0 device* lights_2 [[buffer(3)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]], packed_float4 device* radiance_2 [[buffer(8)]])
{
    thread KernelContext_0 kernelContext_74;
    (&kernelContext_74)->frames_0 = frames_1;
    (&kernelContext_74)->layers_0 = layers_1;
    (&kernelContext_74)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_74)->fabrics_0 = fabrics_1;
    (&kernelContext_74)->corners_0 = corners_1;
    (&kernelContext_74)->vertices_0 = vertices_1;
    (&kernelContext_74)->scene_words_0 = scene_words_1;
    (&kernelContext_74)->visibilities_0 = visibilities_1;
    (&kernelContext_74)->lights_1 = lights_2;
    (&kernelContext_74)->families_0 = families_1;
    (&kernelContext_74)->words_0 = words_1;
    (&kernelContext_74)->radiance_0 = radiance_2;
    Frame_0 device* _S1085 = frames_1+int(0);
    uint _S1086 = id_0.x;
    uint _S1087 = _S1085->width_0;
    bool _S1088;
    if(_S1086 >= (_S1085->width_0))
    {
        _S1088 = true;
    }
    else
    {
        _S1088 = (id_0.y) >= (_S1085->height_0);
    }
    if(_S1088)
    {
        return;
    }
    uint _S1089 = id_0.y * _S1087 + _S1086;
    uint _S1090 = ((&kernelContext_74)->layers_0+_S1089)->face_0;
    if((((&kernelContext_74)->layers_0+_S1089)->face_0) == 0U)
    {
        return;
    }
    uint _S1091 = _S1090 - 1U;
    uint _S1092 = (&kernelContext_74)->face_fabrics_0[_S1091];
    uint2 _S1093 = id_0.xy;
    VisiblePoint_0 _S1094 = visible_point_0(int(0), _S1092, _S1091, _S1093, &kernelContext_74);
    thread VisiblePoint_0 _S1095 = _S1094;
    float3 _S1096 = filtered_albedo_0(_S1092, &_S1095, &kernelContext_74);
    thread VisiblePoint_0 _S1097 = _S1094;
    float4 _S1098 = light_of_footprint_0(int(0), _S1092, &_S1097, _S1093, _S1096, &kernelContext_74);
    accumulate_0(_S1089, _S1098, &kernelContext_74);
    return;
}

