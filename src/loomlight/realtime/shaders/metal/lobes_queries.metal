#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
constant array<float2, int(9)> TAP_OFFSETS_0 = { float2(-0.3333333432674408f, -0.3333333432674408f), float2(-0.3333333432674408f, 0.0f), float2(-0.3333333432674408f, 0.3333333432674408f), float2(0.0f, -0.3333333432674408f), float2(0.0f, 0.0f), float2(0.0f, 0.3333333432674408f), float2(0.3333333432674408f, -0.3333333432674408f), float2(0.3333333432674408f, 0.0f), float2(0.3333333432674408f, 0.3333333432674408f) };
constant array<float, int(4)> PYRAMID_RADII_0 = { 1.0f, 2.0f, 4.0f, 8.0f };
constant array<float2, int(8)> POINT_OFFSETS_0 = { float2(0.0f, 0.0f), float2(-0.23010000586509705f, 0.35670000314712524f), float2(0.36809998750686646f, -0.22939999401569366f), float2(-0.28040000796318054f, -0.34400001168251038f), float2(0.3465999960899353f, 0.28859999775886536f), float2(-0.36349999904632568f, 0.0511000007390976f), float2(0.09929999709129333f, -0.35699999332427979f), float2(0.10710000246763229f, 0.32879999279975891f) };
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

float natural_logarithm_0(float x_0)
{
    uint _S1 = (as_type<uint>((x_0)));
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

float binary_logarithm_0(float x_1)
{
    return natural_logarithm_0(x_1) * 1.4426950216293335f;
}

float3 to_face_frame_0(float3 direction_0, bool back_0)
{
    float2 _S3 = direction_0.xy;
    float _S4;
    if(back_0)
    {
        _S4 = - direction_0.z;
    }
    else
    {
        _S4 = direction_0.z;
    }
    return float3(_S3, _S4);
}

struct SurfacePoint_0
{
    bool hole_0;
    bool is_warp_0;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_0;
    float3 normal_0;
    float3 tangent_0;
    float across_0;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 SurfacePoint_x24init_0(bool hole_1, bool is_warp_1, uint warp_thread_1, uint weft_thread_1, float height_1, float3 normal_1, float3 tangent_1, float across_1, float fibre_across_1, float fibre_along_1)
{
    thread SurfacePoint_0 _S5;
    (&_S5)->hole_0 = hole_1;
    (&_S5)->is_warp_0 = is_warp_1;
    (&_S5)->warp_thread_0 = warp_thread_1;
    (&_S5)->weft_thread_0 = weft_thread_1;
    (&_S5)->height_0 = height_1;
    (&_S5)->normal_0 = normal_1;
    (&_S5)->tangent_0 = tangent_1;
    (&_S5)->across_0 = across_1;
    (&_S5)->fibre_across_0 = fibre_across_1;
    (&_S5)->fibre_along_0 = fibre_along_1;
    return _S5;
}

struct Components_0
{
    float diffuse_warp_0;
    float diffuse_weft_0;
    float specular_warp_0;
    float specular_weft_0;
    float light_visibility_0;
    float hole_2;
};

Components_0 no_components_0()
{
    thread Components_0 nothing_0;
    (&nothing_0)->diffuse_warp_0 = 0.0f;
    (&nothing_0)->diffuse_weft_0 = 0.0f;
    (&nothing_0)->specular_warp_0 = 0.0f;
    (&nothing_0)->specular_weft_0 = 0.0f;
    (&nothing_0)->light_visibility_0 = 0.0f;
    (&nothing_0)->hole_2 = 0.0f;
    return nothing_0;
}

struct Blocked_0
{
    float by_warp_0;
    float by_weft_0;
    float far_0;
};

Blocked_0 no_blocked_0()
{
    thread Blocked_0 nothing_1;
    (&nothing_1)->by_warp_0 = 0.0f;
    (&nothing_1)->by_weft_0 = 0.0f;
    (&nothing_1)->far_0 = 0.0f;
    return nothing_1;
}

struct CloseUp_0
{
    float weight_0;
    Blocked_0 warp_0;
    Blocked_0 weft_0;
};

CloseUp_0 no_close_up_0()
{
    thread CloseUp_0 nothing_2;
    (&nothing_2)->weight_0 = 0.0f;
    Blocked_0 _S6 = no_blocked_0();
    (&nothing_2)->warp_0 = _S6;
    (&nothing_2)->weft_0 = _S6;
    return nothing_2;
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
    float _S7 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    thread SearchQuality_0 quality_0;
    float _S8 = mix(2.5f, 5.0f, _S7);
    (&quality_0)->steps_per_thread_0 = _S8;
    (&quality_0)->steps_per_relief_0 = _S8;
    (&quality_0)->shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S7);
    (&quality_0)->refinements_0 = uint(mix(1.0f, 2.0f, _S7) + 0.5f);
    return quality_0;
}

struct Query_0
{
    uint fabric_0;
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
    uint light_visibility_1;
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
    uint back_1;
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
    uint back_2;
    float repeats_per_x_1;
    float repeats_per_y_1;
    float texels_per_mm_1;
    float width_0;
    float height_2;
    uint is_trilinear_0;
};

struct Fabric_0
{
    uint warp_1;
    uint weft_1;
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

struct KernelContext_0
{
    uint device* query_count_0;
    Query_0 device* queries_0;
    packed_float4 device* answers_0;
    Fabric_0 device* fabrics_0;
    Family_0 device* families_0;
    uint device* words_0;
};

float2 turns_and_remainder_0(uint family_0, float index_0, KernelContext_0 thread* kernelContext_0)
{
    float _S9 = floor(fma(index_0, kernelContext_0->families_0[family_0].inverse_count_0, kernelContext_0->families_0[family_0].half_inverse_count_0));
    return float2(_S9, fma(- _S9, kernelContext_0->families_0[family_0].count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_0, KernelContext_0 thread* kernelContext_1)
{
    float _S10 = floor(position_0 * kernelContext_1->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_0;
    float _S11 = fma(- _S10, kernelContext_1->families_0[family_1].size_0, position_0);
    (&cell_0)->below_0 = _S11;
    (&cell_0)->above_0 = kernelContext_1->families_0[family_1].size_0 - _S11;
    (&cell_0)->across_2 = _S11 - 0.5f * kernelContext_1->families_0[family_1].size_0;
    (&cell_0)->half_width_1 = kernelContext_1->families_0[family_1].half_width_0;
    float2 _S12 = turns_and_remainder_0(family_1, _S10, kernelContext_1);
    (&cell_0)->thread_0 = uint(clamp(_S12.y, 0.0f, kernelContext_1->families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

float table_number_0(uint index_1, KernelContext_0 thread* kernelContext_2)
{
    return (as_type<float>((kernelContext_2->words_0[index_1])));
}

float table_number_1(uint index_2, KernelContext_0 thread* kernelContext_3)
{
    return (as_type<float>((kernelContext_3->words_0[index_2])));
}

Cell_0 locate_varied_0(uint family_2, float position_1, KernelContext_0 thread* kernelContext_4)
{
    float turns_0 = (position_1 - kernelContext_4->families_0[family_2].start_0) * kernelContext_4->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S13 = turns_1 * kernelContext_4->families_0[family_2].period_0;
    uint thread_1 = kernelContext_4->words_0[kernelContext_4->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_4->families_0[family_2].bins_0, 0.0f, kernelContext_4->families_0[family_2].bins_0 - 1.0f))];
    float _S14 = table_number_0(kernelContext_4->families_0[family_2].place_table_0 + thread_1 * 4U + 1U, kernelContext_4);
    uint _S15;
    if(_S13 >= _S14)
    {
        _S15 = 1U;
    }
    else
    {
        _S15 = 0U;
    }
    uint _S16 = min(thread_1 + _S15, uint(kernelContext_4->families_0[family_2].count_0) - 1U);
    uint _S17 = kernelContext_4->families_0[family_2].place_table_0 + _S16 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S16;
    float _S18 = table_number_0(_S17, kernelContext_4);
    (&cell_1)->below_0 = _S13 - _S18;
    float _S19 = table_number_0(_S17 + 1U, kernelContext_4);
    (&cell_1)->above_0 = _S19 - _S13;
    float _S20 = table_number_0(_S17 + 2U, kernelContext_4);
    (&cell_1)->across_2 = _S13 - _S20;
    float _S21 = table_number_0(_S17 + 3U, kernelContext_4);
    (&cell_1)->half_width_1 = _S21;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2, KernelContext_0 thread* kernelContext_5)
{
    if((kernelContext_5->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S22 = locate_alike_0(family_3, position_2, kernelContext_5);
        return _S22;
    }
    Cell_0 _S23 = locate_varied_0(family_3, position_2, kernelContext_5);
    return _S23;
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
    Cell_0 warp_2;
    Cell_0 weft_2;
    uint warp_word_0;
    uint weft_word_0;
    bool warp_above_0;
};

Shown_0 shown_at_0(const Crossing_0 thread* crossing_0, bool back_3)
{
    bool _S24 = (abs((&crossing_0->warp_2)->across_2)) < ((&crossing_0->warp_2)->half_width_1);
    bool _S25 = (abs((&crossing_0->weft_2)->across_2)) < ((&crossing_0->weft_2)->half_width_1);
    thread Shown_0 shown_0;
    bool _S26;
    if(_S24)
    {
        if(!_S25)
        {
            _S26 = true;
        }
        else
        {
            _S26 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S26 = false;
    }
    (&shown_0)->is_warp_2 = _S26;
    if(!_S24)
    {
        _S26 = !_S25;
    }
    else
    {
        _S26 = false;
    }
    (&shown_0)->hole_3 = _S26;
    uint _S27;
    if((&shown_0)->is_warp_2)
    {
        _S27 = crossing_0->warp_word_0;
    }
    else
    {
        _S27 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S27;
    (&shown_0)->on_top_0 = ((_S27 & 1U) == 1U) != back_3;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_0, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_2;
    uint _S28;
    if(is_first_0)
    {
        _S28 = first_0->thread_0;
    }
    else
    {
        _S28 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S28;
    float _S29;
    if(is_first_0)
    {
        _S29 = first_0->across_2;
    }
    else
    {
        _S29 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S29;
    if(is_first_0)
    {
        _S29 = first_0->half_width_1;
    }
    else
    {
        _S29 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S29;
    if(is_first_0)
    {
        _S29 = first_0->below_0;
    }
    else
    {
        _S29 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S29;
    if(is_first_0)
    {
        _S29 = first_0->above_0;
    }
    else
    {
        _S29 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S29;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0, KernelContext_0 thread* kernelContext_6)
{
    float2 _S30 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0), kernelContext_6);
    float _S31 = _S30.x;
    Family_0 _S32 = kernelContext_6->families_0[family_4];
    float _S33 = table_number_0(kernelContext_6->families_0[family_4].place_table_0 + uint(_S30.y) * 4U, kernelContext_6);
    return fma(_S31, _S32.period_0, _S33);
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0, KernelContext_0 thread* kernelContext_7)
{
    if((kernelContext_7->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * kernelContext_7->families_0[family_5].size_0;
    }
    float _S34 = boundary_0(family_5, thread_3, last_0, kernelContext_7);
    float _S35 = boundary_0(family_5, thread_3, first_1, kernelContext_7);
    return _S34 - _S35;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_4, KernelContext_0 thread* kernelContext_8)
{
    Family_0 _S36 = kernelContext_8->families_0[family_6];
    uint _S37;
    if((kernelContext_8->families_0[family_6].is_alike_0) != 0U)
    {
        _S37 = 0U;
    }
    else
    {
        _S37 = thread_4 * 4U;
    }
    uint _S38 = _S36.bend_table_0 + _S37;
    thread Bend_0 bend_0;
    float _S39 = table_number_0(_S38, kernelContext_8);
    (&bend_0)->sine_0 = _S39;
    float _S40 = table_number_0(_S38 + 1U, kernelContext_8);
    (&bend_0)->half_tangent_0 = _S40;
    float _S41 = table_number_0(_S38 + 2U, kernelContext_8);
    (&bend_0)->arc_0 = _S41;
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_5, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_9)
{
    int _S42 = int((word_1 >> 1U) & 127U);
    int _S43 = int((word_1 >> 8U) & 127U);
    int _S44 = int((word_1 >> 15U) & 63U);
    int _S45 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S46 = crossed_0->below_0;
    uint _S47 = crossed_0->thread_0;
    int _S48 = - _S42;
    float _S49 = span_0(other_0, crossed_0->thread_0, _S48, int(0), kernelContext_9);
    float _S50 = _S46 + _S49;
    (&run_0)->from_start_0 = _S50;
    float _S51 = crossed_0->above_0;
    int _S52 = _S43 + int(1);
    float _S53 = span_0(other_0, _S47, int(1), _S52, kernelContext_9);
    float _S54 = _S51 + _S53;
    (&run_0)->to_end_0 = _S54;
    bool _S55 = _S50 < _S54;
    (&run_0)->near_start_0 = _S55;
    int _S56;
    if(_S55)
    {
        _S56 = _S48 - _S44;
    }
    else
    {
        _S56 = _S52;
    }
    int _S57;
    if((&run_0)->near_start_0)
    {
        _S57 = _S48;
    }
    else
    {
        _S57 = _S52 + _S45;
    }
    Bend_0 _S58 = bend_of_0(own_0, thread_5, kernelContext_9);
    (&run_0)->bend_1 = _S58;
    float _S59;
    if((&run_0)->straight_0)
    {
        _S59 = 1.0e+06f;
    }
    else
    {
        _S59 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S59;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S60 = span_0(other_0, _S47, _S56, _S57, kernelContext_9);
    (&run_0)->other_reach_0 = min(0.5f * _S60, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S42 == int(0);
    (&run_0)->last_crossing_0 = _S43 == int(0);
    return run_0;
}

float square_0(float x_2)
{
    return x_2 * x_2;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(const Cell_0 thread* cell_3)
{
    float _S61 = cell_3->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S62 = clamp(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S62;
    float _S63 = _S61 * _S61 - square_0(_S62);
    float _S64 = rsqrt(_S63);
    (&section_0)->drop_0 = _S61 - _S63 * _S64;
    (&section_0)->slope_0 = - _S62 * _S64;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_6, int step_1, KernelContext_0 thread* kernelContext_10)
{
    if((kernelContext_10->families_0[family_7].is_alike_0) != 0U)
    {
        float _S65 = table_number_0(kernelContext_10->families_0[family_7].bend_table_0 + 3U, kernelContext_10);
        return _S65;
    }
    Family_0 _S66 = kernelContext_10->families_0[family_7];
    float2 _S67 = turns_and_remainder_0(family_7, float(int(thread_6) + step_1), kernelContext_10);
    float _S68 = table_number_0(_S66.bend_table_0 + uint(_S67.y) * 4U + 3U, kernelContext_10);
    return _S68;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_11)
{
    float _S69 = crossed_1->below_0;
    float _S70 = crossed_1->above_0;
    bool _S71 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S72 = min(crossed_1->below_0, crossed_1->above_0);
    float _S73;
    if(_S71)
    {
        _S73 = _S69 - crossed_1->across_2;
    }
    else
    {
        _S73 = _S70 + crossed_1->across_2;
    }
    float _S74 = _S73 - crossed_1->half_width_1;
    bool _S75;
    if(_S71)
    {
        _S75 = run_1->first_crossing_0;
    }
    else
    {
        _S75 = run_1->last_crossing_0;
    }
    bool _S76 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S73 = 0.0f;
    }
    else
    {
        Family_0 _S77 = kernelContext_11->families_0[other_1];
        float _S78 = edge_drop_0(other_1, crossed_1->thread_0, int(0), kernelContext_11);
        _S73 = _S77.height_scale_0 * _S78;
    }
    float _S79;
    if(_S76 != _S75)
    {
        _S79 = 0.0f;
    }
    else
    {
        Family_0 _S80 = kernelContext_11->families_0[other_1];
        uint _S81 = crossed_1->thread_0;
        int _S82;
        if(_S71)
        {
            _S82 = int(-1);
        }
        else
        {
            _S82 = int(1);
        }
        float _S83 = edge_drop_0(other_1, _S81, _S82, kernelContext_11);
        _S79 = _S80.height_scale_0 * _S83;
    }
    float _S84 = 1.0f / max(2.0f * _S74, 9.999999960041972e-13f);
    float _S85 = clamp((_S74 - _S72) * _S84, 0.0f, 1.0f);
    float _S86 = _S73 + (_S79 - _S73) * (_S85 * _S85 * (3.0f - 2.0f * _S85));
    float _S87 = (_S73 - _S79) * (6.0f * _S85 * (1.0f - _S85) * _S84);
    if(_S71)
    {
        _S73 = 1.0f;
    }
    else
    {
        _S73 = -1.0f;
    }
    return float2(_S86, _S87 * _S73);
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

StepControl_0 step_control_0(float2 direction_1, float step_3)
{
    thread StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S88 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S88), 9.99999971718068537e-10f);
    float _S89 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S89), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S88 > 0.0f;
    (&control_0)->up_0 = _S89 > 0.0f;
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

float outline_distance_0(const Cell_0 thread* cell_4, const Shown_0 thread* shown_2, const Run_0 thread* run_2, bool lengthwise_0, bool forwards_0)
{
    float _S90;
    if(forwards_0)
    {
        _S90 = cell_4->across_2;
    }
    else
    {
        _S90 = - cell_4->across_2;
    }
    float _S91;
    if(forwards_0)
    {
        _S91 = cell_4->above_0;
    }
    else
    {
        _S91 = cell_4->below_0;
    }
    bool _S92;
    if(forwards_0)
    {
        _S92 = run_2->last_crossing_0;
    }
    else
    {
        _S92 = run_2->first_crossing_0;
    }
    bool _S93;
    if(forwards_0)
    {
        _S93 = run_2->first_crossing_0;
    }
    else
    {
        _S93 = run_2->last_crossing_0;
    }
    float _S94 = cell_4->half_width_1;
    float _S95 = - cell_4->half_width_1;
    bool _S96 = _S90 < _S95;
    bool _S97 = _S90 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S92 = !_S92;
    }
    else
    {
        _S92 = false;
    }
    if(_S92)
    {
        _S92 = !shown_2->hole_3;
    }
    else
    {
        _S92 = false;
    }
    bool _S98;
    if(_S92)
    {
        _S98 = shown_2->on_top_0;
    }
    else
    {
        _S98 = false;
    }
    if(_S98)
    {
        if(_S93)
        {
            _S93 = _S96;
        }
        else
        {
            _S93 = false;
        }
        _S93 = !_S93;
    }
    else
    {
        _S93 = false;
    }
    if(shown_2->hole_3)
    {
        _S92 = true;
    }
    else
    {
        if(_S92)
        {
            _S92 = !shown_2->on_top_0;
        }
        else
        {
            _S92 = false;
        }
    }
    float _S99;
    if(_S96)
    {
        _S99 = _S95;
    }
    else
    {
        _S99 = _S94;
    }
    float _S100 = _S99 - _S90;
    if(_S92)
    {
        _S90 = 2.0f * _S91 + _S90 - _S94;
    }
    else
    {
        _S90 = _S91;
    }
    if(_S93)
    {
        if(forwards_0)
        {
            _S90 = run_2->to_end_0;
        }
        else
        {
            _S90 = run_2->from_start_0;
        }
        return _S90;
    }
    if(_S97)
    {
    }
    else
    {
        _S90 = _S100;
    }
    return _S90;
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
    float _S101 = previous_1->rate_0;
    float _S102 = previous_1->rate_0 * step_4;
    float _S103 = rate_1 * step_4;
    bool _S104;
    if(!previous_1->known_0)
    {
        _S104 = true;
    }
    else
    {
        _S104 = here_0->hole_4;
    }
    if(_S104)
    {
        _S104 = true;
    }
    else
    {
        _S104 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S104)
    {
        _S104 = true;
    }
    else
    {
        _S104 = _S101 >= 0.0f;
    }
    if(_S104)
    {
        _S104 = true;
    }
    else
    {
        _S104 = rate_1 <= 0.0f;
    }
    if(_S104)
    {
        return -1.0f;
    }
    float _S105 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S102) >= 0.0f)
    {
        _S104 = (3.0f * clearance_1 - _S103) >= 0.0f;
    }
    else
    {
        _S104 = false;
    }
    if(_S104)
    {
        return -1.0f;
    }
    float _S106 = clearance_1 - _S105;
    float _S107 = 6.0f * _S106 - 4.0f * _S102 - 2.0f * _S103;
    float _S108 = -2.0f * _S102 / max(_S107 + sqrt(max(_S107 * _S107 - 4.0f * (3.0f * (_S102 + _S103 - 2.0f * _S106)) * _S102, 0.0f)), 9.99999968265522539e-21f);
    float _S109 = 1.0f - _S108;
    float _S110 = (_S105 * (2.0f * _S108 + 1.0f) + _S102 * _S108) * _S109 * _S109;
    float _S111 = (clearance_1 * (2.0f * _S109 + 1.0f) - _S103 * _S109) * _S108 * _S108;
    if(_S108 > 0.01999999955296516f)
    {
        _S104 = _S109 > 0.01999999955296516f;
    }
    else
    {
        _S104 = false;
    }
    if(_S104)
    {
        _S104 = (_S110 + _S111) < 0.0f;
    }
    else
    {
        _S104 = false;
    }
    float _S112;
    if(_S104)
    {
        _S112 = _S109 * step_4;
    }
    else
    {
        _S112 = -1.0f;
    }
    return _S112;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S113 = here_1->hole_4;
    float _S114;
    if(here_1->hole_4)
    {
        _S114 = 1.0e+09f;
    }
    else
    {
        _S114 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S114;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S115;
    if(!_S113)
    {
        _S115 = !is_cell_exit_0;
    }
    else
    {
        _S115 = false;
    }
    (&previous_2)->known_0 = _S115;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1->per_x_0, side_y_1 * this_1->per_y_0), 0.0f) + this_1->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_2, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S116 = min(here_2->edge_x_0 * this_2->per_x_0, here_2->edge_y_0 * this_2->per_y_0);
    bool _S117;
    if(!here_2->hole_4)
    {
        _S117 = (rate_3 * _S116 + clearance_3) < 0.0f;
    }
    else
    {
        _S117 = false;
    }
    if(_S117)
    {
        _S117 = _S116 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S117 = false;
    }
    float _S118 = this_2->step_2;
    float _S119;
    if(_S117)
    {
        _S119 = _S116 - this_2->epsilon_0;
    }
    else
    {
        _S119 = max(_S116, 0.0f) + this_2->epsilon_0;
    }
    return min(_S118, _S119);
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
    float _S120 = end_0 - start_1;
    float _S121 = start_rate_0 + end_rate_0 - 2.0f * _S120;
    float _S122 = 3.0f * _S120 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S120, 9.99999968265522539e-21f);
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
        float _S123 = clamp(share_0 - (((_S121 * share_0 + _S122) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S121 * share_0 + 2.0f * _S122) * share_0 + start_rate_0, 0.10000000149011612f * _S120 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S124 = i_0 + int(1);
        share_0 = _S123;
        i_0 = _S124;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S125 = along_slope_0 * along_slope_0 + 1.0f;
    float _S126 = rsqrt(_S125);
    float _S127 = sine_1 * _S126 * rsqrt(_S125 + across_slope_0 * across_slope_0);
    return float2(- _S127 * _S125, _S127 * across_slope_0 * along_slope_0 + cosine_0 * _S126);
}

float arc_sine_0(float x_3)
{
    float _S128 = abs(x_3);
    bool _S129 = _S128 > 0.5f;
    float _S130;
    if(_S129)
    {
        _S130 = 0.5f * (1.0f - _S128);
    }
    else
    {
        _S130 = _S128 * _S128;
    }
    float _S131;
    if(_S129)
    {
        _S131 = sqrt(max(_S130, 0.0f));
    }
    else
    {
        _S131 = _S128;
    }
    float _S132 = ((((0.04216320067644119f * _S130 + 0.02418131195008755f) * _S130 + 0.04547002539038658f) * _S130 + 0.07495300471782684f) * _S130 + 0.16666752099990845f) * _S130 * _S131 + _S131;
    if(_S129)
    {
        _S130 = 1.57079637050628662f - 2.0f * _S132;
    }
    else
    {
        _S130 = _S132;
    }
    if(x_3 < 0.0f)
    {
        _S130 = - _S130;
    }
    return _S130;
}

float3 table_colour_0(uint index_3, KernelContext_0 thread* kernelContext_12)
{
    float _S133 = table_number_1(index_3, kernelContext_12);
    float _S134 = table_number_1(index_3 + 1U, kernelContext_12);
    float _S135 = table_number_1(index_3 + 2U, kernelContext_12);
    return float3(_S133, _S134, _S135);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0, KernelContext_0 thread* kernelContext_13)
{
    thread Albedos_0 albedos_0;
    float3 _S136 = table_colour_0(row_0, kernelContext_13);
    (&albedos_0)->diffuse_reflect_0 = _S136;
    float3 _S137 = table_colour_0(row_0 + 3U, kernelContext_13);
    (&albedos_0)->diffuse_transmit_0 = _S137;
    float3 _S138 = table_colour_0(row_0 + 6U, kernelContext_13);
    (&albedos_0)->specular_reflect_0 = _S138;
    float3 _S139 = table_colour_0(row_0 + 9U, kernelContext_13);
    (&albedos_0)->specular_transmit_0 = _S139;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_7, KernelContext_0 thread* kernelContext_14)
{
    Albedos_0 _S140 = table_albedos_0(kernelContext_14->families_0[family_8].albedo_table_0 + kernelContext_14->families_0[family_8].albedo_stride_0 * thread_7, kernelContext_14);
    return _S140;
}

uint scramble_0(uint value_0)
{
    uint _S141 = value_0 * 747796405U + 2891336453U;
    uint _S142 = ((_S141 >> ((_S141 >> 28U) + 4U)) ^ _S141) * 277803737U;
    return (_S142 >> 22U) ^ _S142;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_0, float3 albedo_1, float3 room_0)
{
    float3 _S143 = room_0 / max(albedo_1, float3(9.99999997475242708e-07f) );
    return min(gain_0, max(min(min(_S143.x, _S143.y), _S143.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float diffuse_reflection_0(float3 light_0, float3 normal_2, float blend_0)
{
    float _S144 = light_0.z;
    if(_S144 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S144, 0.0f), max(dot(light_0, normal_2), 0.0f), blend_0);
}

float projected_area_1(float3 direction_2, float3 tangent_2, float roughness_1)
{
    float _S145 = dot(direction_2, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S145 * _S145 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_4)
{
    float _S146 = clamp(x_4, -87.0f, 88.0f);
    float _S147 = floor(_S146 * 1.4426950216293335f + 0.5f);
    float _S148 = _S146 - _S147 * 0.693359375f + _S147 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S148 + 0.00139819993637502f) * _S148 + 0.00833345204591751f) * _S148 + 0.04166579619050026f) * _S148 + 0.1666666567325592f) * _S148 + 0.5f;
    float _S149 = (as_type<float>((uint(int(_S147) + int(127)) << 23U)));
    float _S150;
    if(x_4 < -87.0f)
    {
        _S150 = 0.0f;
    }
    else
    {
        _S150 = (p_0 * _S148 * _S148 + _S148 + 1.0f) * _S149;
    }
    return _S150;
}

float mean_attenuation_0(float depth_0)
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

float square_1(float3 v_0)
{
    return dot(v_0, v_0);
}

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S151 = roughness_2 * roughness_2;
    float _S152 = squared_along_0 * (1.0f - _S151) + _S151;
    return 0.31830987334251404f * _S151 * roughness_2 / (_S152 * _S152);
}

float density_between_0(float3 light_1, float3 view_0, float3 tangent_3, float roughness_3)
{
    float3 _S153 = light_1 + view_0;
    float _S154 = dot(_S153, tangent_3);
    return flake_density_0(min(_S154 * _S154 / max(square_1(_S153), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float transmission_1(float3 light_2, float3 view_1, float3 normal_3, float3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S155 = - dot(light_2, normal_3);
    float _S156 = dot(view_1, normal_3);
    bool _S157;
    if(_S155 <= 0.0f)
    {
        _S157 = true;
    }
    else
    {
        _S157 = _S156 <= 0.0f;
    }
    if(_S157)
    {
        return 0.0f;
    }
    float _S158 = 1.0f / max(_S156, 9.99999997475242708e-07f);
    float _S159 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S155, 9.99999997475242708e-07f);
    float _S160 = projected_area_1(view_1, tangent_4, roughness_4) * _S158;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S159, _S160)) * mean_attenuation_0(optical_depth_1 * abs(_S159 - _S160)) * _S158;
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_4, float3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S161 = dot(light_3, normal_4);
    bool _S162;
    if(_S161 <= 0.0f)
    {
        _S162 = true;
    }
    else
    {
        _S162 = (dot(view_2, normal_4)) <= 0.0f;
    }
    if(_S162)
    {
        return 0.0f;
    }
    float _S163 = max(_S161, 9.99999997475242708e-07f);
    float _S164 = max(dot(view_2, normal_4), 9.99999997475242708e-07f);
    float _S165 = projected_area_1(light_3, tangent_5, roughness_5) * _S164 + projected_area_1(view_2, tangent_5, roughness_5) * _S163;
    float _S166 = optical_depth_2 * _S165 / (_S163 * _S164);
    return 0.25f * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S166 * mean_attenuation_0(_S166)) * _S163 / _S165;
}

Components_0 with_added_0(const Components_0 thread* sums_0, const Components_0 thread* more_0, float weight_1)
{
    thread Components_0 result_0;
    (&result_0)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_1 * more_0->diffuse_warp_0;
    (&result_0)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_1 * more_0->diffuse_weft_0;
    (&result_0)->specular_warp_0 = sums_0->specular_warp_0 + weight_1 * more_0->specular_warp_0;
    (&result_0)->specular_weft_0 = sums_0->specular_weft_0 + weight_1 * more_0->specular_weft_0;
    (&result_0)->light_visibility_0 = sums_0->light_visibility_0 + weight_1 * more_0->light_visibility_0;
    (&result_0)->hole_2 = sums_0->hole_2 + weight_1 * more_0->hole_2;
    return result_0;
}

Blocked_0 scaled_0(const Blocked_0 thread* blocked_0, float share_1)
{
    thread Blocked_0 result_1;
    (&result_1)->by_warp_0 = share_1 * blocked_0->by_warp_0;
    (&result_1)->by_weft_0 = share_1 * blocked_0->by_weft_0;
    (&result_1)->far_0 = share_1 * blocked_0->far_0;
    return result_1;
}

float wrapped_cell_0(float position_3, float count_1)
{
    return min(floor((position_3 - floor(position_3)) * count_1), count_1 - 1.0f);
}

float arc_tangent_quotient_0(float x_5, float y_0)
{
    return ((((((0.0f * x_5 + 0.00809729471802711f) * x_5 + -0.0377517081797123f) * x_5 + 0.08475969731807709f) * x_5 + -0.13537675142288208f) * x_5 + 0.19895026087760925f) * x_5 + -0.33327975869178772f) * x_5 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_1, float x_6)
{
    float _S167 = abs(x_6);
    float _S168 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S167, _S168) / max(max(_S167, _S168), 1.00000000317107685e-30f));
    float angle_1;
    if(_S168 > _S167)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_6 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_1 < 0.0f)
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

NodeTaps_0 node_taps_0(float3 direction_3)
{
    float _S169 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S170 = floor(_S169);
    float _S171 = _S169 - _S170;
    float _S172 = sqrt(clamp((1.0f - abs(direction_3.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S173 = 7.0f * _S172 * sqrt(_S172);
    float _S174 = min(floor(_S173), 6.0f);
    float _S175 = _S173 - _S174;
    uint _S176 = uint(int(_S170) + int(32)) % 32U;
    uint _S177 = uint(_S174);
    uint _S178 = _S176 * 8U + _S177;
    uint _S179 = (_S176 + 1U) % 32U * 8U + _S177;
    thread NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = uint4(_S178, _S178 + 1U, _S179, _S179 + 1U);
    float _S180 = 1.0f - _S171;
    float _S181 = 1.0f - _S175;
    uint4 _S182 = uint4(float4(_S180 * _S181, _S180 * _S175, _S171 * _S181, _S171 * _S175) * float4(252.0f)  + float4(0.5f) );
    (&taps_0)->weights_0 = _S182;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S182.x + _S182.y + _S182.z + _S182.w);
    return taps_0;
}

float3 half_vector_0(float3 light_4, float3 view_3)
{
    float3 _S183 = light_4 + view_3;
    return _S183 * float3(rsqrt(max(square_1(_S183), 9.999999960041972e-13f))) ;
}

float3 shadow_correlation_0(float3 light_5, float3 view_4)
{
    float2 _S184 = light_5.xy;
    float2 _S185 = view_4.xy;
    float _S186 = dot(_S184, _S185) / max(sqrt(dot(_S184, _S184) * dot(_S185, _S185)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return float3(float2((-0.09000000357627869f + -0.07999999821186066f * _S186)) , 0.0f);
    }
    return float3(min(0.62000000476837158f + 0.62999999523162842f * _S186, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16U), float(odd_0 >> 16U));
}

float4 interpolate_0(const NodeTaps_0 thread* taps_1, uint4 packs_1)
{
    uint4 _S187 = uint4(16711935U) ;
    uint4 _S188 = (packs_1 & _S187) * taps_1->weights_0;
    uint4 _S189 = ((packs_1 >> (uint4(8U) )) & _S187) * taps_1->weights_0;
    return bytes_of_sums_0(_S188.x + _S188.y + _S188.z + _S188.w, _S189.x + _S189.y + _S189.z + _S189.w) * float4(taps_1->inverse_sum_0) ;
}

float4 interpolate_table_0(const NodeTaps_0 thread* taps_2, uint table_0, uint stride_0, KernelContext_0 thread* kernelContext_15)
{
    uint4 _S190 = uint4(table_0)  + taps_2->nodes_0 * uint4(stride_0) ;
    float4 _S191 = interpolate_0(taps_2, uint4(kernelContext_15->words_0[_S190.x], kernelContext_15->words_0[_S190.y], kernelContext_15->words_0[_S190.z], kernelContext_15->words_0[_S190.w]));
    return _S191;
}

struct Group_0
{
    float3 normal_5;
    float weight_2;
    float3 tangent_6;
    float3 variance_0;
    float3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7, KernelContext_0 thread* kernelContext_16)
{
    thread Group_0 group_0;
    float _S192 = table_number_0(row_1, kernelContext_16);
    float _S193 = table_number_0(row_1 + 1U, kernelContext_16);
    float _S194 = table_number_0(row_1 + 2U, kernelContext_16);
    (&group_0)->normal_5 = float3(_S192, _S193, _S194);
    float _S195 = table_number_0(row_1 + 3U, kernelContext_16);
    (&group_0)->weight_2 = _S195;
    float _S196 = table_number_0(row_1 + 4U, kernelContext_16);
    float _S197 = table_number_0(row_1 + 5U, kernelContext_16);
    float _S198 = table_number_0(row_1 + 6U, kernelContext_16);
    float3 _S199 = float3(_S196, _S197, _S198);
    (&group_0)->tangent_6 = _S199;
    float _S200 = table_number_0(row_1 + 7U, kernelContext_16);
    float _S201 = table_number_0(row_1 + 8U, kernelContext_16);
    (&group_0)->variance_0 = float3(_S200, _S201, 1.0f - square_1(_S199) - _S200 - _S201);
    float _S202 = table_number_0(row_1 + 9U, kernelContext_16);
    float _S203 = table_number_0(row_1 + 10U, kernelContext_16);
    float _S204 = table_number_0(row_1 + 11U, kernelContext_16);
    (&group_0)->covariance_0 = float3(_S202, _S203, _S204);
    (&group_0)->roughness_6 = roughness_7;
    return group_0;
}

float2 visibility_gain_0(float3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * float2((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f))  + float2(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), float2(0.0f) );
}

float Group_variance_along_0(const Group_0 thread* this_5, float3 direction_4)
{
    float _S205 = direction_4.x;
    float _S206 = direction_4.y;
    float _S207 = direction_4.z;
    return max(dot(this_5->variance_0, direction_4 * direction_4) + 2.0f * dot(this_5->covariance_0, float3(_S205 * _S206, _S205 * _S207, _S206 * _S207)), 0.0f);
}

float mean_area_0(const Group_0 thread* group_1, float3 direction_5)
{
    float _S208 = dot(direction_5, group_1->tangent_6);
    float _S209 = _S208 * _S208;
    float _S210 = Group_variance_along_0(group_1, direction_5);
    float _S211 = group_1->roughness_6 * group_1->roughness_6;
    return sqrt(max((_S211 - 1.0f) * (_S209 + _S210) + 1.0f, _S211));
}

float mean_density_0(const Group_0 thread* group_2, float3 half_0)
{
    float _S212 = group_2->roughness_6;
    float _S213 = max(sqrt(max(1.0f - group_2->roughness_6 * group_2->roughness_6, 0.0f)) / group_2->roughness_6, 0.00100000004749745f);
    float _S214 = Group_variance_along_0(group_2, half_0);
    float _S215 = max(sqrt(3.0f * _S214), _S212 * 0.01999999955296516f + 0.00009999999747379f);
    float _S216 = dot(half_0, group_2->tangent_6);
    float _S217 = _S213 * (_S216 - _S215);
    float _S218 = _S213 * (_S216 + _S215);
    float _S219 = _S217 * _S218;
    float _S220 = 2.0f * _S215 * _S213;
    return 0.15915493667125702f / _S212 * ((1.0f - _S219) / ((_S217 * _S217 + 1.0f) * (_S218 * _S218 + 1.0f)) + arc_tangent_0(_S220, 1.0f + _S219) / _S220);
}

float layer_value_0(const Group_0 thread* group_3, float3 half_1, float3 light_6, float3 view_5, float optical_depth_3)
{
    bool _S221 = (light_6.z) < 0.0f;
    float3 _S222 = group_3->normal_5;
    float _S223 = dot(light_6, group_3->normal_5);
    float _S224;
    if(_S221)
    {
        _S224 = - _S223;
    }
    else
    {
        _S224 = _S223;
    }
    float _S225 = max(_S224, 0.01999999955296516f);
    float _S226 = max(dot(view_5, _S222), 0.01999999955296516f);
    float _S227 = mean_area_0(group_3, light_6);
    float _S228 = _S227 / _S225;
    float _S229 = mean_area_0(group_3, view_5);
    float _S230 = _S229 / _S226;
    if(_S221)
    {
        _S224 = abs(_S228 - _S230);
    }
    else
    {
        _S224 = _S228 + _S230;
    }
    float _S231 = optical_depth_3 * max(_S224, 0.00100000004749745f);
    if(_S221)
    {
        _S224 = exponential_0(- optical_depth_3 * min(_S228, _S230));
    }
    else
    {
        _S224 = 1.0f;
    }
    float _S232 = optical_depth_3 * _S224 * (1.0f - exponential_0(- _S231)) / _S231 / _S226;
    if(_S221)
    {
        _S224 = 1.0f;
    }
    else
    {
        _S224 = 1.0f - 0.34999999403953552f * (1.0f - square_1(_S222));
    }
    float _S233 = mean_density_0(group_3, half_1);
    return 0.25f * _S233 * _S224 * _S232;
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

Bound_0 bound_at_0(uint family_9, float position_4, KernelContext_0 thread* kernelContext_17)
{
    Cell_0 _S234 = locate_0(family_9, position_4, kernelContext_17);
    float _S235 = table_number_0(kernelContext_17->families_0[family_9].before_0 + 2U * _S234.thread_0 + 1U, kernelContext_17);
    thread Bound_0 bound_0;
    (&bound_0)->thread_11 = _S234.thread_0;
    (&bound_0)->turns_2 = round((position_4 - kernelContext_17->families_0[family_9].start_0 - _S235 - _S234.below_0) * kernelContext_17->families_0[family_9].inverse_period_0);
    (&bound_0)->cell_7 = _S234.below_0;
    float _S236 = 2.0f * _S234.half_width_1;
    (&bound_0)->width_1 = _S236;
    (&bound_0)->visible_0 = clamp((_S234.across_2 + _S234.half_width_1) / _S236, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S234.below_0, _S234.below_0 - _S234.across_2 - _S234.half_width_1) + max(_S234.across_2 - _S234.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1, KernelContext_0 thread* kernelContext_18)
{
    float _S237 = centre_1 - floor((centre_1 - kernelContext_18->families_0[family_10].start_0) * kernelContext_18->families_0[family_10].inverse_period_0) * kernelContext_18->families_0[family_10].period_0;
    float _S238 = 0.5f * max(size_1, kernelContext_18->families_0[family_10].smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S239 = bound_at_0(family_10, _S237 - _S238, kernelContext_18);
    (&stretch_0)->low_0 = _S239;
    Bound_0 _S240 = bound_at_0(family_10, _S237 + _S238, kernelContext_18);
    (&stretch_0)->high_0 = _S240;
    return stretch_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

float3 lengths_0(uint family_11, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_19)
{
    float _S241 = Stretch_turns_0(stretch_1);
    uint _S242 = kernelContext_19->families_0[family_11].before_0 + 2U * (&stretch_1->low_0)->thread_11;
    uint _S243 = kernelContext_19->families_0[family_11].before_0 + 2U * (&stretch_1->high_0)->thread_11;
    float _S244 = table_number_0(_S243, kernelContext_19);
    float _S245 = table_number_0(_S242, kernelContext_19);
    float _S246 = _S244 - _S245;
    float _S247 = table_number_0(_S243 + 1U, kernelContext_19);
    float _S248 = table_number_0(_S242 + 1U, kernelContext_19);
    float _S249 = _S247 - _S248;
    return float3(_S246 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_1 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_1 + _S241 * kernelContext_19->families_0[family_11].visible_total_0, _S249 - _S246 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0 + _S241 * (kernelContext_19->families_0[family_11].period_0 - kernelContext_19->families_0[family_11].visible_total_0), _S249 + (&stretch_1->high_0)->cell_7 - (&stretch_1->low_0)->cell_7 + _S241 * kernelContext_19->families_0[family_11].period_0);
}

float2 integrals_along_0(uint family_12, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_20)
{
    Family_0 _S250 = kernelContext_20->families_0[family_12];
    uint _S251 = 3U * _S250.quantities_0;
    uint _S252 = kernelContext_20->families_0[family_12].colour_threads_0 + _S251 * (&stretch_2->low_0)->thread_11 + quantity_0;
    uint _S253 = kernelContext_20->families_0[family_12].colour_threads_0 + _S251 * (&stretch_2->high_0)->thread_11 + quantity_0;
    uint _S254 = kernelContext_20->families_0[family_12].colour_threads_0 + _S251 * uint(kernelContext_20->families_0[family_12].count_0) + quantity_0;
    float _S255 = table_number_0(_S252, kernelContext_20);
    float _S256 = table_number_0(_S253, kernelContext_20);
    float _S257 = Stretch_turns_0(stretch_2);
    float _S258 = table_number_0(_S253 + _S250.quantities_0, kernelContext_20);
    float _S259 = table_number_0(_S252 + _S250.quantities_0, kernelContext_20);
    float _S260 = _S258 - _S259 + _S256 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_1 - _S255 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_1;
    float _S261 = table_number_0(_S254 + _S250.quantities_0, kernelContext_20);
    float _S262 = _S260 + _S257 * _S261;
    uint _S263 = 2U * _S250.quantities_0;
    float _S264 = table_number_0(_S253 + _S263, kernelContext_20);
    float _S265 = table_number_0(_S252 + _S263, kernelContext_20);
    float _S266 = _S264 - _S265 + _S256 * (&stretch_2->high_0)->cell_7 - _S255 * (&stretch_2->low_0)->cell_7;
    float _S267 = table_number_0(_S254 + _S263, kernelContext_20);
    return float2(_S262, _S266 + _S257 * _S267);
}

bool Stretch_wraps_0(const Stretch_0 thread* this_7)
{
    return ((&this_7->high_0)->thread_11) < ((&this_7->low_0)->thread_11);
}

bool Stretch_wraps_1(const Stretch_0 thread* this_8)
{
    return ((&this_8->high_0)->thread_11) < ((&this_8->low_0)->thread_11);
}

uint4 Stretch_differences_0(const Stretch_0 thread* this_9, uint4 entries_0, uint whole_0)
{
    uint _S268 = entries_0.z;
    uint _S269 = entries_0.x;
    uint _S270 = _S268 - _S269;
    bool _S271 = Stretch_wraps_1(this_9);
    uint _S272;
    if(_S271)
    {
        _S272 = whole_0;
    }
    else
    {
        _S272 = 0U;
    }
    return uint4(_S270 + _S272, entries_0.w - _S268, entries_0.y - _S269, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_4, uint row_2, uint count_2, uint quantities_1, KernelContext_0 thread* kernelContext_21)
{
    uint _S273 = row_2 + (&across_4->low_0)->thread_11 * quantities_1;
    uint _S274 = row_2 + (&across_4->high_0)->thread_11 * quantities_1;
    uint4 _S275 = Stretch_differences_0(across_4, uint4(kernelContext_21->words_0[_S273], kernelContext_21->words_0[_S273 + quantities_1], kernelContext_21->words_0[_S274], kernelContext_21->words_0[_S274 + quantities_1]), kernelContext_21->words_0[row_2 + count_2 * quantities_1]);
    return _S275;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_10)
{
    float _S276 = (&this_10->high_0)->visible_0;
    float _S277 = - (&this_10->low_0)->visible_0;
    float _S278 = Stretch_turns_0(this_10);
    bool _S279 = Stretch_wraps_0(this_10);
    float _S280;
    if(_S279)
    {
        _S280 = 1.0f;
    }
    else
    {
        _S280 = 0.0f;
    }
    return float4(1.0f, _S276, _S277, _S278 - _S280);
}

float integral_on_top_0(uint family_13, const Stretch_0 thread* across_5, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_22)
{
    uint _S281 = uint(kernelContext_22->families_0[family_13].count_0);
    uint _S282 = (_S281 + 1U) * kernelContext_22->families_0[family_13].quantities_0;
    uint _S283 = kernelContext_22->families_0[family_13].colour_areas_0 + quantity_1;
    uint _S284 = (&along_0->low_0)->thread_11;
    uint4 _S285 = row_differences_0(across_5, _S283 + (&along_0->low_0)->thread_11 * _S282, _S281, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S286 = row_differences_0(across_5, _S283 + (_S284 + 1U) * _S282, _S281, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint _S287 = (&along_0->high_0)->thread_11;
    uint4 _S288 = row_differences_0(across_5, _S283 + (&along_0->high_0)->thread_11 * _S282, _S281, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S289 = row_differences_0(across_5, _S283 + (_S287 + 1U) * _S282, _S281, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S290 = row_differences_0(across_5, _S283 + crossing_count_0 * _S282, _S281, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S291 = _S288 - _S285;
    bool _S292 = Stretch_wraps_0(along_0);
    uint4 _S293;
    if(_S292)
    {
        _S293 = _S290;
    }
    else
    {
        _S293 = uint4(int4(int(0)) );
    }
    uint4 _S294 = _S291 + _S293;
    float4 _S295 = Stretch_weights_0(across_5);
    float4 _S296 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S294)), _S295), dot(float4(int4(_S289 - _S288)), _S295), dot(float4(int4(_S286 - _S285)), _S295), dot(float4(int4(_S290)), _S295)), _S296) * kernelContext_22->families_0[family_13].area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_3, uint row_3, KernelContext_0 thread* kernelContext_23)
{
    Albedos_0 _S297 = table_albedos_0(row_3, kernelContext_23);
    thread Albedos_0 sum_0;
    float3 _S298 = float3(weight_3) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S298 * _S297.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S298 * _S297.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S298 * _S297.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S298 * _S297.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, const Stretch_0 thread* own_1, const Stretch_0 thread* other_2, bool back_4, KernelContext_0 thread* kernelContext_24)
{
    Albedos_0 _S299 = table_albedos_0(kernelContext_24->families_0[family_14].colour_mean_0, kernelContext_24);
    thread Albedos_0 albedos_2 = _S299;
    if((kernelContext_24->families_0[family_14].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S300 = lengths_0(crossing_1, other_2, kernelContext_24);
    bool is_exposed_0 = false;
    float weight_4 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < (kernelContext_24->families_0[family_14].quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S301 = integrals_along_0(family_14, own_1, quantity_2, kernelContext_24);
        float _S302 = integral_on_top_0(family_14, own_1, other_2, uint(kernelContext_24->families_0[crossing_1].count_0), quantity_2, kernelContext_24);
        float _S303 = _S301.x;
        float _S304 = _S303 * _S300.x;
        float _S305;
        if(back_4)
        {
            _S305 = _S304 - _S302;
        }
        else
        {
            _S305 = _S302;
        }
        bool _S306 = quantity_2 == 0U;
        if(_S306)
        {
            is_exposed_0 = _S305 > (16.0f * kernelContext_24->families_0[family_14].area_unit_0 * min(_S304 / kernelContext_24->families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S304);
        }
        float _S307 = _S303 * _S300.y;
        float _S308;
        if(is_exposed_0)
        {
            _S308 = _S305;
        }
        else
        {
            _S308 = 0.0f;
        }
        float _S309 = _S307 + _S308 + 0.000244140625f * _S300.z * _S301.y;
        if(_S306)
        {
            weight_4 = 1.0f / max(_S309, 9.99999968265522539e-21f);
        }
        else
        {
            float _S310 = _S309 * weight_4;
            uint _S311 = kernelContext_24->families_0[family_14].colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S312 = albedos_2;
            Albedos_0 _S313 = with_added_albedos_0(&_S312, _S310, _S311, kernelContext_24);
            albedos_2 = _S313;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

Albedos_0 lerp_albedos_0(const Albedos_0 thread* first_2, const Albedos_0 thread* second_1, float weight_5)
{
    thread Albedos_0 albedos_3;
    float3 _S314 = float3(weight_5) ;
    (&albedos_3)->diffuse_reflect_0 = mix(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S314);
    (&albedos_3)->diffuse_transmit_0 = mix(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S314);
    (&albedos_3)->specular_reflect_0 = mix(first_2->specular_reflect_0, second_1->specular_reflect_0, _S314);
    (&albedos_3)->specular_transmit_0 = mix(first_2->specular_transmit_0, second_1->specular_transmit_0, _S314);
    return albedos_3;
}

Albedos_0 tinted_0(const Albedos_0 thread* albedos_4, float3 tint_0)
{
    thread Albedos_0 result_2 = *albedos_4;
    (&result_2)->diffuse_reflect_0 = (&result_2)->diffuse_reflect_0 * tint_0;
    (&result_2)->diffuse_transmit_0 = (&result_2)->diffuse_transmit_0 * tint_0;
    return result_2;
}

struct FaceRadiance_0
{
    float3 warp_3;
    float3 weft_3;
    float3 mean_0;
    float3 leaked_0;
};

struct FaceSends_0
{
    float3 sky_warp_0;
    float3 sky_weft_0;
    float3 crossing_warp_0;
    float3 crossing_weft_0;
    float open_0;
    float blocks_warp_0;
    float blocks_weft_0;
};

FaceRadiance_0 face_radiance_0(const FaceSends_0 thread* sends_0, float open_of_other_0, float3 passed_0, float3 from_other_0)
{
    float3 _S315 = float3((1.0f - open_of_other_0))  * passed_0;
    thread FaceRadiance_0 found_0;
    float3 _S316 = sends_0->sky_warp_0 + _S315 * sends_0->crossing_warp_0;
    (&found_0)->warp_3 = _S316;
    float3 _S317 = sends_0->sky_weft_0 + _S315 * sends_0->crossing_weft_0;
    (&found_0)->weft_3 = _S317;
    (&found_0)->mean_0 = float3(sends_0->blocks_warp_0)  * _S316 + float3(sends_0->blocks_weft_0)  * _S317;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(float3 view_6, array<float, int(6)> thread* terms_0)
{
    float _S318 = 1.0f - view_6.z;
    float _S319 = _S318 * _S318;
    (*terms_0)[int(0)] = 1.0f;
    float _S320 = view_6.x;
    float _S321 = _S320 * _S320;
    float _S322 = view_6.y;
    float _S323 = _S322 * _S322;
    (*terms_0)[int(1)] = sqrt(max(_S321 + _S323, 9.999999960041972e-13f));
    (*terms_0)[int(2)] = _S319;
    (*terms_0)[int(3)] = _S319 * _S319;
    (*terms_0)[int(4)] = _S321 - _S323;
    (*terms_0)[int(5)] = 0.0f;
    return;
}

struct Bounced_0
{
    float3 reflected_0;
    float3 transmitted_0;
};

struct Scattered_0
{
    float3 back_5;
    float3 through_0;
};

struct Interior_0
{
    float3 warp_4;
    float3 weft_4;
    float3 leaked_1;
    float3 far_1;
    float3 far_leaked_0;
};

Bounced_0 bounced_by_0(const Blocked_0 thread* blocked_1, const Scattered_0 thread* yarn_2, const Interior_0 thread* interior_0)
{
    float3 _S324 = float3((blocked_1->by_warp_0 + blocked_1->by_weft_0))  * interior_0->leaked_1;
    float3 _S325 = float3(blocked_1->far_0)  * yarn_2->through_0;
    thread Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_5 * (float3(blocked_1->by_warp_0)  * interior_0->warp_4 + float3(blocked_1->by_weft_0)  * interior_0->weft_4) + _S325 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S325 * interior_0->far_1 + yarn_2->back_5 * _S324;
    return bounced_0;
}

Bounced_0 sum_of_0(const Bounced_0 thread* first_3, const Bounced_0 thread* second_2)
{
    thread Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_3->reflected_0 + second_2->reflected_0;
    (&sum_1)->transmitted_0 = first_3->transmitted_0 + second_2->transmitted_0;
    return sum_1;
}

float3 bounced_value_0(const Bounced_0 thread* bounced_1, float3 light_7, float3 view_7)
{
    float _S326 = light_7.z;
    float3 _S327;
    if((_S326 * view_7.z) < 0.0f)
    {
        _S327 = bounced_1->transmitted_0;
    }
    else
    {
        _S327 = bounced_1->reflected_0;
    }
    return _S327 * float3((abs(_S326) * 0.31830987334251404f)) ;
}

float sheen_scale_0(float x_7, float y_2)
{
    return (((((0.0f * x_7 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_7 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_7 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_7 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_7 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_7 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_8, float y_3)
{
    return ((((0.0f * x_8 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_8 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_8 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_8 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_8 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_9, float y_4)
{
    return ((((0.0f * x_9 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_9 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_9 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_9 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_9 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S328 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S329 = 2.0f * sqrt(_S328) - 1.0f;
    float _S330 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S329, _S330), 0.00999999977648258f, 1.0f), clamp((1.0f - _S328) * sheen_shear_0(_S329, _S330), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S329, _S330), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_8, float3 view_8, float scale_0, float shear_0)
{
    float _S331 = light_8.z;
    bool _S332;
    if(_S331 <= 0.0f)
    {
        _S332 = true;
    }
    else
    {
        _S332 = (view_8.z) <= 0.0f;
    }
    if(_S332)
    {
        return 0.0f;
    }
    float2 _S333 = view_8.xy;
    float _S334 = dot(_S333, _S333);
    float2 _S335;
    if(_S334 > 9.99999968265522539e-21f)
    {
        _S335 = _S333 * float2(rsqrt(_S334)) ;
    }
    else
    {
        _S335 = float2(1.0f, 0.0f);
    }
    float _S336 = scale_0 * dot(light_8.xy, _S335) + shear_0 * _S331;
    float _S337 = scale_0 * (light_8.y * _S335.x - light_8.x * _S335.y);
    float _S338 = _S336 * _S336 + _S337 * _S337 + _S331 * _S331;
    return 0.31830987334251404f * scale_0 * scale_0 * _S331 / max(_S338 * _S338, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_9, float3 view_9, float strength_0, float roughness_9)
{
    float3 _S339 = sheen_lobe_0(view_9.z, roughness_9);
    float _S340 = strength_0 * _S339.z;
    return float2(_S340 * transformed_cosine_0(light_9, view_9, _S339.x, _S339.y), 1.0f - _S340);
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_5;
    Albedos_0 weft_5;
};

struct Estimate_0
{
    Components_0 components_0;
    CloseUp_0 close_0;
    FamilyAlbedos_0 albedos_5;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_0;
};

Regime_0 regime_of_0(uint _S341, const Footprint_0 thread* _S342, float _S343, KernelContext_0 thread* kernelContext_25)
{
    Fabric_0 device* _S344 = kernelContext_25->fabrics_0+_S341;
    float _S345 = Footprint_spread_side_0(_S342);
    float _S346 = clamp((binary_logarithm_0(max(_S345, 9.99999971718068537e-10f)) - _S344->lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    thread Regime_0 regime_0;
    float _S347 = _S346 * _S346 * (3.0f - 2.0f * _S346);
    (&regime_0)->prefiltered_0 = _S347;
    (&regime_0)->threads_1 = _S345 * _S344->lobes_0.threads_per_mm_0;
    float _S348 = mix(max(8.0f / _S343, 1.0f), 1.0f, _S347);
    float _S349;
    if(_S347 < 1.0f)
    {
        _S349 = clamp((&regime_0)->threads_1 * 12.0f, 1.0f, _S348);
    }
    else
    {
        _S349 = 0.0f;
    }
    (&regime_0)->points_0 = _S349;
    return regime_0;
}

struct Hit_0
{
    float x_10;
    float y_5;
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

Crossing_0 crossing_at_0(uint _S350, float _S351, float _S352, bool _S353, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S354 = kernelContext_26->fabrics_0+_S350;
    thread Crossing_0 crossing_3;
    Cell_0 _S355 = locate_0(_S354->warp_1, _S351, kernelContext_26);
    (&crossing_3)->warp_2 = _S355;
    Cell_0 _S356 = locate_0(_S354->weft_1, _S352, kernelContext_26);
    (&crossing_3)->weft_2 = _S356;
    uint _S357 = _S354->run_words_0 + 2U * ((&(&crossing_3)->weft_2)->thread_0 * _S354->ends_1 + (&(&crossing_3)->warp_2)->thread_0);
    uint _S358 = kernelContext_26->words_0[_S357];
    (&crossing_3)->warp_word_0 = _S358;
    (&crossing_3)->weft_word_0 = kernelContext_26->words_0[_S357 + 1U];
    (&crossing_3)->warp_above_0 = ((_S358 & 1U) == 1U) != _S353;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S359, float _S360, float _S361, bool _S362, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S363 = kernelContext_27->fabrics_0+_S359;
    thread Sample_0 sample_0;
    Crossing_0 _S364 = crossing_at_0(_S359, _S360, _S361, _S362, kernelContext_27);
    (&sample_0)->crossing_2 = _S364;
    thread Crossing_0 _S365 = _S364;
    Shown_0 _S366 = shown_at_0(&_S365, _S362);
    (&sample_0)->shown_3 = _S366;
    uint _S367;
    if(_S366.is_warp_2)
    {
        _S367 = _S363->warp_1;
    }
    else
    {
        _S367 = _S363->weft_1;
    }
    uint _S368;
    if(_S366.is_warp_2)
    {
        _S368 = _S363->weft_1;
    }
    else
    {
        _S368 = _S363->warp_1;
    }
    thread Cell_0 _S369 = (&(&sample_0)->crossing_2)->warp_2;
    thread Cell_0 _S370 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S371 = select_cell_0(_S366.is_warp_2, &_S369, &_S370);
    thread Cell_0 _S372 = (&(&sample_0)->crossing_2)->weft_2;
    thread Cell_0 _S373 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S374 = select_cell_0(_S366.is_warp_2, &_S372, &_S373);
    thread Cell_0 _S375 = _S374;
    Run_0 _S376 = unpack_0(_S367, _S368, _S371.thread_0, &_S375, _S366.word_0, kernelContext_27);
    thread Cell_0 _S377 = _S371;
    Section_0 _S378 = section_at_0(&_S377);
    bool _S379;
    if(_S366.on_top_0)
    {
        _S379 = (_S376.distance_0) < (_S378.drop_0 * _S376.bend_1.sine_0);
    }
    else
    {
        _S379 = false;
    }
    bool _S380;
    if(_S366.on_top_0)
    {
        _S380 = !_S379;
    }
    else
    {
        _S380 = false;
    }
    float _S381;
    if(_S380)
    {
        _S381 = 1.0f;
    }
    else
    {
        _S381 = -1.0f;
    }
    float _S382;
    if(_S379)
    {
        _S382 = _S376.other_reach_0;
    }
    else
    {
        _S382 = _S376.reach_0;
    }
    float _S383;
    if(_S379)
    {
        _S383 = _S382 + _S376.distance_0;
    }
    else
    {
        _S383 = max(_S382 - _S376.distance_0, 0.0f);
    }
    float _S384 = _S382 / _S376.bend_1.sine_0 - _S381 * _S378.drop_0;
    float _S385 = _S383 * _S383;
    float _S386 = max(_S384 * _S384 - _S385, 9.99999968265522539e-21f);
    float _S387 = rsqrt(_S386);
    float _S388 = _S385 / (_S386 * _S387 + _S384);
    bool _S389 = _S383 > 0.0f;
    float _S390;
    if(_S366.on_top_0)
    {
        _S390 = 1.0f;
    }
    else
    {
        _S390 = -1.0f;
    }
    float _S391;
    if(_S376.near_start_0)
    {
        _S391 = 1.0f;
    }
    else
    {
        _S391 = -1.0f;
    }
    float _S392 = _S390 * _S391;
    if(_S389)
    {
        _S390 = _S384 * _S387;
    }
    else
    {
        _S390 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S378.slope_0 * _S390;
    if(_S389)
    {
        _S383 = _S392 * _S383 * _S387;
    }
    else
    {
        _S383 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S383;
    Family_0 _S393 = kernelContext_27->families_0[_S367];
    thread Shown_0 _S394 = _S366;
    thread Run_0 _S395 = _S376;
    thread Cell_0 _S396 = _S374;
    float2 _S397 = dive_0(_S368, &_S394, &_S395, &_S396, kernelContext_27);
    if(_S376.straight_0)
    {
        _S381 = 0.0f;
    }
    else
    {
        _S381 = _S393.height_scale_0 * _S381;
    }
    (&sample_0)->height_6 = _S381 * (_S382 * _S376.bend_1.half_tangent_0 - _S388) - _S393.height_scale_0 * _S378.drop_0 - _S397.x;
    float _S398 = _S393.height_scale_0 * (&sample_0)->slope_across_0;
    float _S399 = _S393.height_scale_0 * (&sample_0)->slope_along_0 - _S397.y;
    if(_S366.is_warp_2)
    {
        _S381 = _S398;
    }
    else
    {
        _S381 = _S399;
    }
    (&sample_0)->slope_x_1 = _S381;
    if(_S366.is_warp_2)
    {
        _S381 = _S399;
    }
    else
    {
        _S381 = _S398;
    }
    (&sample_0)->slope_y_1 = _S381;
    (&sample_0)->run_3 = _S376;
    (&sample_0)->section_1 = _S378;
    return sample_0;
}

float steps_per_length_0(uint _S400, const SearchQuality_0 thread* _S401, float3 _S402, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S403 = kernelContext_28->fabrics_0+_S400;
    return max(max(abs(_S402.x) * _S403->threads_per_x_0, abs(_S402.y) * _S403->threads_per_y_0) * _S401->steps_per_thread_0, abs(_S402.z) * _S403->per_relief_0 * _S401->steps_per_relief_0);
}

float cell_maximum_0(uint _S404, const Crossing_0 thread* _S405, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S406 = kernelContext_29->fabrics_0+_S404;
    bool _S407 = _S405->warp_above_0;
    uint _S408;
    if(_S405->warp_above_0)
    {
        _S408 = _S406->warp_1;
    }
    else
    {
        _S408 = _S406->weft_1;
    }
    uint _S409;
    if(_S407)
    {
        _S409 = _S405->warp_word_0;
    }
    else
    {
        _S409 = _S405->weft_word_0;
    }
    return float(_S409 >> 28U) * kernelContext_29->families_0[_S408].height_scale_0 * kernelContext_29->families_0[_S408].level_0;
}

Probe_0 probe_0(uint _S410, float _S411, float _S412, bool _S413, bool _S414, bool _S415, KernelContext_0 thread* kernelContext_30)
{
    Sample_0 _S416 = sample_at_0(_S410, _S411, _S412, _S413, kernelContext_30);
    thread Probe_0 probe_1;
    (&probe_1)->height_3 = _S416.height_6;
    (&probe_1)->hole_4 = _S416.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S416.slope_x_1;
    (&probe_1)->slope_y_0 = _S416.slope_y_1;
    uint _S417;
    if(_S416.shown_3.is_warp_2)
    {
        _S417 = _S416.crossing_2.warp_2.thread_0 * 2U + 1U;
    }
    else
    {
        _S417 = _S416.crossing_2.weft_2.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S417;
    thread Crossing_0 _S418 = _S416.crossing_2;
    float _S419 = cell_maximum_0(_S410, &_S418, kernelContext_30);
    (&probe_1)->cell_max_0 = _S419;
    float _S420;
    if(_S414)
    {
        _S420 = _S416.crossing_2.warp_2.above_0;
    }
    else
    {
        _S420 = _S416.crossing_2.warp_2.below_0;
    }
    (&probe_1)->side_x_0 = _S420;
    if(_S415)
    {
        _S420 = _S416.crossing_2.weft_2.above_0;
    }
    else
    {
        _S420 = _S416.crossing_2.weft_2.below_0;
    }
    (&probe_1)->side_y_0 = _S420;
    bool _S421 = !_S416.shown_3.is_warp_2;
    thread Cell_0 _S422 = _S416.crossing_2.warp_2;
    thread Shown_0 _S423 = _S416.shown_3;
    thread Run_0 _S424 = _S416.run_3;
    float _S425 = outline_distance_0(&_S422, &_S423, &_S424, _S421, _S414);
    (&probe_1)->edge_x_0 = _S425;
    thread Cell_0 _S426 = _S416.crossing_2.weft_2;
    thread Shown_0 _S427 = _S416.shown_3;
    thread Run_0 _S428 = _S416.run_3;
    float _S429 = outline_distance_0(&_S426, &_S427, &_S428, _S416.shown_3.is_warp_2, _S415);
    (&probe_1)->edge_y_0 = _S429;
    return probe_1;
}

bool is_free_0(uint _S430, const SearchQuality_0 thread* _S431, float3 _S432, float3 _S433, bool _S434, float _S435, KernelContext_0 thread* kernelContext_31)
{
    float _S436 = _S433.z;
    if(_S436 <= 0.0f)
    {
        return false;
    }
    float _S437 = _S431->shadow_share_0;
    float _S438 = steps_per_length_0(_S430, _S431, _S433, kernelContext_31);
    float _S439 = 1.0f / max(_S437 * _S438, 9.99999971718068537e-10f);
    StepControl_0 _S440 = step_control_0(_S433.xy, _S439);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S441;
        if(count_3 < 1024U)
        {
            _S441 = (_S432.z + _S436 * distance_1) < _S435;
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
        float3 _S442 = _S432 + _S433 * float3(distance_1) ;
        Probe_0 _S443 = probe_0(_S430, _S442.x, _S442.y, _S434, _S440.right_0, _S440.up_0, kernelContext_31);
        float _S444 = _S442.z;
        float _S445 = _S444 - _S443.height_3;
        float _S446 = _S436 - _S443.slope_x_0 * _S433.x - _S443.slope_y_0 * _S433.y;
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
        thread PreviousSample_0 _S448 = previous_3;
        thread Probe_0 _S449 = _S443;
        float _S450 = way_back_to_dip_0(&_S448, _S445, _S446, last_step_0, &_S449);
        if(_S450 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S450;
            distance_1 = distance_1 - _S450;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S451 = _S444 > (_S443.cell_max_0);
        thread Probe_0 _S452 = _S443;
        PreviousSample_0 _S453 = after_sample_0(_S445, _S446, &_S452, _S451);
        float last_step_2;
        if(_S451)
        {
            thread StepControl_0 _S454 = _S440;
            float _S455 = StepControl_to_cell_exit_0(&_S454, _S443.side_x_0, _S443.side_y_0);
            last_step_2 = max(_S455, _S439);
        }
        else
        {
            thread StepControl_0 _S456 = _S440;
            thread Probe_0 _S457 = _S443;
            float _S458 = StepControl_to_next_sample_0(&_S456, &_S457, _S445, _S446);
            last_step_2 = _S458;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S453;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S459, const SearchQuality_0 thread* _S460, float _S461, float _S462, float3 _S463, bool _S464, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S465 = kernelContext_32->fabrics_0+_S459;
    Sample_0 _S466 = sample_at_0(_S459, _S461, _S462, _S464, kernelContext_32);
    if(!_S466.shown_3.hole_3)
    {
        return false;
    }
    float3 _S467 = float3(_S461, _S462, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S468;
        if(side_0 < 2U)
        {
            _S468 = passes_0;
        }
        else
        {
            _S468 = false;
        }
        if(_S468)
        {
        }
        else
        {
            break;
        }
        float3 _S469;
        if(side_0 == 0U)
        {
            _S469 = _S463;
        }
        else
        {
            _S469 = float3(- _S463.x, - _S463.y, _S463.z);
        }
        bool _S470 = is_free_0(_S459, _S460, _S467, _S469, _S464 != (side_0 == 1U), _S465->height_high_0, kernelContext_32);
        uint _S471 = side_0 + 1U;
        passes_0 = _S470;
        side_0 = _S471;
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

float max_height_along_0(uint _S472, float _S473, float _S474, float _S475, float3 _S476, bool _S477, KernelContext_0 thread* kernelContext_33)
{
    Fabric_0 device* _S478 = kernelContext_33->fabrics_0+_S472;
    Cell_0 _S479 = locate_0(_S478->warp_1, _S473, kernelContext_33);
    uint _S480 = _S479.thread_0 / 2U;
    Cell_0 _S481 = locate_0(_S478->weft_1, _S474, kernelContext_33);
    uint _S482 = _S481.thread_0 / 2U;
    float _S483 = _S476.x;
    uint _S484;
    if(_S483 > 0.0f)
    {
        _S484 = 1U;
    }
    else
    {
        _S484 = 0U;
    }
    float _S485 = _S476.y;
    uint _S486;
    if(_S485 > 0.0f)
    {
        _S486 = 2U;
    }
    else
    {
        _S486 = 0U;
    }
    uint _S487 = kernelContext_33->words_0[_S478->max_heights_0 + 4U * (_S482 * _S478->max_height_columns_0 + _S480) + (_S484 + _S486)];
    int number_0;
    if(_S477)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S488 = _S487 >> uint(number_0);
    float _S489 = max(abs(_S483) * _S478->threads_per_x_0, abs(_S485) * _S478->threads_per_y_0) / _S476.z;
    float _S490 = _S478->height_high_0;
    float max_height_0 = _S478->height_high_0;
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
        if(((max_height_0 - _S475) * _S489) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S488 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S490);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S491, float _S492, float _S493, bool _S494, bool _S495, bool _S496, KernelContext_0 thread* kernelContext_34)
{
    Crossing_0 _S497 = crossing_at_0(_S491, _S492, _S493, _S494, kernelContext_34);
    thread Crossing_0 _S498 = _S497;
    float _S499 = cell_maximum_0(_S491, &_S498, kernelContext_34);
    float _S500;
    if(_S495)
    {
        _S500 = _S497.warp_2.above_0;
    }
    else
    {
        _S500 = _S497.warp_2.below_0;
    }
    float _S501;
    if(_S496)
    {
        _S501 = _S497.weft_2.above_0;
    }
    else
    {
        _S501 = _S497.weft_2.below_0;
    }
    return float3(_S499, _S500, _S501);
}

float first_sample_height_0(uint _S502, const ViewRay_0 thread* _S503, const StepControl_0 thread* _S504, bool _S505, KernelContext_0 thread* kernelContext_35)
{
    float _S506 = max_height_along_0(_S502, _S503->origin_0.x, _S503->origin_0.y, 0.0f, float3(_S503->slope_1, 1.0f), _S505, kernelContext_35);
    uint count_4 = 0U;
    float height_8 = _S506;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S507 = ViewRay_at_0(_S503, height_8);
        float3 _S508 = cell_bounds_0(_S502, _S507.x, _S507.y, _S505, _S504->right_0, _S504->up_0, kernelContext_35);
        float _S509 = height_8 - _S508.x;
        float _S510 = StepControl_to_cell_exit_0(_S504, _S508.y, _S508.z);
        float height_9 = height_8 - clamp(_S509, 0.0f, _S510);
        if(_S509 <= _S510)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S511, const ViewRay_0 thread* _S512, const StepControl_0 thread* _S513, bool _S514, KernelContext_0 thread* kernelContext_36)
{
    Fabric_0 device* _S515 = kernelContext_36->fabrics_0+_S511;
    float _S516 = _S515->height_low_0 - (_S515->height_high_0 - _S515->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S517 = first_sample_height_0(_S511, _S512, _S513, _S514, kernelContext_36);
    (&end_1)->height_7 = _S517;
    (&end_1)->last_step_3 = _S513->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
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
        float2 _S518 = ViewRay_at_0(_S512, (&end_1)->height_7);
        Probe_0 _S519 = probe_0(_S511, _S518.x, _S518.y, _S514, _S513->right_0, _S513->up_0, kernelContext_36);
        float _S520 = (&end_1)->height_7 - _S519.height_3;
        thread Probe_0 _S521 = _S519;
        float _S522 = ViewRay_rate_0(_S512, &_S521);
        (&end_1)->depth_1 = - _S520;
        (&end_1)->rate_4 = _S522;
        bool _S523;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S523 = !_S519.hole_4;
        }
        else
        {
            _S523 = false;
        }
        bool _S524;
        if(_S523)
        {
            _S524 = ((&(&end_1)->previous_4)->yarn_0) == (_S519.yarn_1);
        }
        else
        {
            _S524 = false;
        }
        (&end_1)->smooth_0 = _S524;
        bool _S525;
        if(!_S519.hole_4)
        {
            _S525 = _S520 <= 0.0f;
        }
        else
        {
            _S525 = false;
        }
        bool _S526;
        if(_S525)
        {
            _S526 = true;
        }
        else
        {
            _S526 = ((&end_1)->height_7) <= _S516;
        }
        if(_S526)
        {
            break;
        }
        thread PreviousSample_0 _S527 = (&end_1)->previous_4;
        thread Probe_0 _S528 = _S519;
        float _S529 = way_back_to_dip_0(&_S527, _S520, _S522, (&end_1)->last_step_3, &_S528);
        if(_S529 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S529;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S529;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S530 = StepControl_to_cell_exit_0(_S513, _S519.side_x_0, _S519.side_y_0);
        float _S531 = min(_S530, (&end_1)->height_7 - _S519.cell_max_0);
        thread Probe_0 _S532 = _S519;
        float _S533 = StepControl_to_next_sample_0(_S513, &_S532, _S520, _S522);
        bool _S534 = _S531 > _S533;
        thread Probe_0 _S535 = _S519;
        PreviousSample_0 _S536 = after_sample_0(_S520, _S522, &_S535, _S534);
        (&end_1)->previous_4 = _S536;
        float _S537 = max(_S531, _S533);
        (&end_1)->last_step_3 = _S537;
        (&end_1)->height_7 = (&end_1)->height_7 - _S537;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S538, const ViewRay_0 thread* _S539, const StepControl_0 thread* _S540, bool _S541, const ViewRayEnd_0 thread* _S542, uint _S543, KernelContext_0 thread* kernelContext_37)
{
    Fabric_0 device* _S544 = kernelContext_37->fabrics_0+_S538;
    float _S545 = _S544->height_high_0 - _S544->height_low_0;
    float _S546 = _S542->height_7;
    float _S547 = _S542->last_step_3;
    float above_2 = _S542->height_7 + _S542->last_step_3;
    float above_gap_1 = clamp((&_S542->previous_4)->clearance_0, 0.0f, _S545);
    float under_gap_1 = clamp(_S542->depth_1, 0.0f, _S545);
    float _S548 = cubic_root_0(above_gap_1, - under_gap_1, (&_S542->previous_4)->rate_0 * _S542->last_step_3, _S542->rate_4 * _S542->last_step_3);
    bool _S549 = _S542->smooth_0;
    float middle_0;
    if(_S542->smooth_0)
    {
        middle_0 = above_2 - _S548 * _S547;
    }
    else
    {
        middle_0 = between_0(above_2, _S546, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S546;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S543)
        {
        }
        else
        {
            break;
        }
        float2 _S550 = ViewRay_at_0(_S539, middle_0);
        Probe_0 _S551 = probe_0(_S538, _S550.x, _S550.y, _S541, _S540->right_0, _S540->up_0, kernelContext_37);
        float _S552;
        if(_S551.hole_4)
        {
            _S552 = -1.0e+09f;
        }
        else
        {
            _S552 = _S551.height_3;
        }
        float _S553 = clamp(middle_0 - _S552, - _S545, _S545);
        float _S554;
        if(_S553 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S554 = 0.5f * above_gap_2;
            }
            else
            {
                _S554 = above_gap_2;
            }
            float _S555 = - _S553;
            under_1 = middle_0;
            above_gap_2 = _S554;
            under_gap_2 = _S555;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S554 = 0.5f * under_gap_2;
            }
            else
            {
                _S554 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S553;
            under_gap_2 = _S554;
            side_1 = -1.0f;
        }
        if(_S549)
        {
            thread Probe_0 _S556 = _S551;
            float _S557 = ViewRay_rate_0(_S539, &_S556);
            middle_0 = clamp(middle_0 + _S553 / min(_S557, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S549)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S558, const SearchQuality_0 thread* _S559, float _S560, float _S561, float3 _S562, bool _S563, KernelContext_0 thread* kernelContext_38)
{
    float _S564 = max(_S562.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S560, _S561);
    float2 _S565 = _S562.xy / float2(_S564) ;
    (&ray_0)->slope_1 = _S565;
    float2 _S566 = - _S565;
    float _S567 = steps_per_length_0(_S558, _S559, _S562, kernelContext_38);
    StepControl_0 _S568 = step_control_0(_S566, 1.0f / max(_S567 / _S564, 9.99999971718068537e-10f));
    thread ViewRay_0 _S569 = ray_0;
    thread StepControl_0 _S570 = _S568;
    ViewRayEnd_0 _S571 = search_down_0(_S558, &_S569, &_S570, _S563, kernelContext_38);
    thread Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    thread ViewRay_0 _S572 = ray_0;
    thread StepControl_0 _S573 = _S568;
    thread ViewRayEnd_0 _S574 = _S571;
    float _S575 = refined_height_0(_S558, &_S572, &_S573, _S563, &_S574, _S559->refinements_0, kernelContext_38);
    (&hit_0)->height_5 = _S575;
    thread ViewRay_0 _S576 = ray_0;
    float2 _S577 = ViewRay_at_0(&_S576, _S575);
    (&hit_0)->x_10 = _S577.x;
    (&hit_0)->y_5 = _S577.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S578, const SearchQuality_0 thread* _S579, float _S580, float _S581, float3 _S582, bool _S583, KernelContext_0 thread* kernelContext_39)
{
    bool _S584 = passes_through_0(_S578, _S579, _S580, _S581, _S582, _S583, kernelContext_39);
    if(!_S584)
    {
        Hit_0 _S585 = first_hit_of_yarn_0(_S578, _S579, _S580, _S581, _S582, _S583, kernelContext_39);
        return _S585;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_10 = _S580;
    (&hit_1)->y_5 = _S581;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S586, float _S587, float _S588, bool _S589, KernelContext_0 thread* kernelContext_40)
{
    Fabric_0 device* _S590 = kernelContext_40->fabrics_0+_S586;
    Sample_0 _S591 = sample_at_0(_S586, _S587, _S588, _S589, kernelContext_40);
    float _S592;
    if(_S591.shown_3.is_warp_2)
    {
        _S592 = _S591.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S592 = _S591.crossing_2.weft_2.half_width_1;
    }
    uint _S593;
    if(_S591.shown_3.is_warp_2)
    {
        _S593 = _S590->warp_1;
    }
    else
    {
        _S593 = _S590->weft_1;
    }
    Family_0 _S594 = kernelContext_40->families_0[_S593];
    float _S595;
    if(_S589)
    {
        _S595 = -1.0f;
    }
    else
    {
        _S595 = 1.0f;
    }
    float _S596 = _S594.twist_sine_0 * _S595;
    Family_0 _S597 = kernelContext_40->families_0[_S593];
    if(_S591.shown_3.is_warp_2)
    {
        _S595 = 1.0f;
    }
    else
    {
        _S595 = -1.0f;
    }
    float2 _S598 = fibre_direction_0(_S591.slope_across_0, _S595 * _S591.slope_along_0, _S596, _S597.twist_cosine_0);
    float _S599;
    if(_S591.shown_3.is_warp_2)
    {
        _S599 = _S591.slope_x_1;
    }
    else
    {
        _S599 = _S591.slope_y_1;
    }
    float _S600;
    if(_S591.shown_3.is_warp_2)
    {
        _S600 = _S591.slope_y_1;
    }
    else
    {
        _S600 = _S591.slope_x_1;
    }
    float _S601 = _S598.x;
    float _S602 = _S598.y;
    float _S603 = _S599 * _S601 + _S595 * _S600 * _S602;
    float _S604 = _S592 * 1.0154266357421875f;
    float _S605 = _S604 * arc_sine_0(clamp(_S591.section_1.across_3 / _S604, -1.0f, 1.0f));
    if(_S591.shown_3.is_warp_2)
    {
        _S592 = _S588;
    }
    else
    {
        _S592 = - _S587;
    }
    thread SurfacePoint_0 point_0;
    (&point_0)->hole_0 = _S591.shown_3.hole_3;
    (&point_0)->is_warp_0 = _S591.shown_3.is_warp_2;
    (&point_0)->warp_thread_0 = _S591.crossing_2.warp_2.thread_0;
    (&point_0)->weft_thread_0 = _S591.crossing_2.weft_2.thread_0;
    (&point_0)->height_0 = _S591.height_6;
    (&point_0)->normal_0 = normalize(float3(- _S591.slope_x_1, - _S591.slope_y_1, 1.0f));
    float3 _S606;
    if(_S591.shown_3.is_warp_2)
    {
        _S606 = float3(_S601, _S602, _S603);
    }
    else
    {
        _S606 = float3(- _S602, _S601, _S603);
    }
    (&point_0)->tangent_0 = normalize(_S606);
    (&point_0)->across_0 = _S591.section_1.across_3;
    (&point_0)->fibre_across_0 = _S605 * _S597.twist_cosine_0 + _S592 * _S596;
    (&point_0)->fibre_along_0 = _S592 * _S597.twist_cosine_0 - _S605 * _S596;
    return point_0;
}

struct YarnPoint_0
{
    bool back_6;
    bool hole_6;
    bool is_warp_3;
    float x_11;
    float y_6;
    float height_10;
    float3 normal_6;
    float3 tangent_7;
    float roughness_10;
    Albedos_0 albedos_6;
};

Albedos_0 vary_albedos_0(uint _S607, const Albedos_0 thread* _S608, uint _S609, uint _S610, KernelContext_0 thread* kernelContext_41)
{
    Fabric_0 device* _S611 = kernelContext_41->fabrics_0+_S607;
    float3 _S612 = max(_S608->specular_reflect_0, _S608->specular_transmit_0);
    float3 _S613 = _S608->diffuse_reflect_0 + _S608->diffuse_transmit_0;
    float3 _S614 = float3(_S611->layer_bound_0) ;
    float3 _S615 = float3(1.0f) ;
    float3 _S616 = float3(bounded_gain_0(thread_gain_0(_S609, _S611->colour_noise_0, _S611->seed_0), _S613, _S615 - _S614 * _S612)) ;
    float _S617 = bounded_gain_0(fibre_gain_0(_S609, _S610, _S611->fibre_noise_0, _S611->seed_0), _S612, min((_S615 - _S616 * _S613) / _S614, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S616 * _S608->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S616 * _S608->diffuse_transmit_0;
    float3 _S618 = float3(_S617) ;
    (&varied_0)->specular_reflect_0 = _S618 * _S608->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S618 * _S608->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S619, const SurfacePoint_0 thread* _S620, const Albedos_0 thread* _S621, float _S622, float _S623, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S624 = kernelContext_42->fabrics_0+_S619;
    bool _S625 = _S620->is_warp_0;
    float _S626;
    if(_S620->is_warp_0)
    {
        _S626 = _S622;
    }
    else
    {
        _S626 = _S623;
    }
    float _S627 = _S626 - _S620->across_0;
    uint _S628;
    if(_S625)
    {
        _S628 = _S624->warp_1;
    }
    else
    {
        _S628 = _S624->weft_1;
    }
    Family_0 _S629 = kernelContext_42->families_0[_S628];
    int _S630 = int(kernelContext_42->families_0[_S628].count_0);
    if(_S625)
    {
        _S628 = _S620->warp_thread_0;
    }
    else
    {
        _S628 = _S620->weft_thread_0;
    }
    uint _S631 = uint(int(floor(_S627 / _S629.period_0)) * _S630 + int(_S628)) * 2U;
    if(_S625)
    {
        _S628 = 1U;
    }
    else
    {
        _S628 = 0U;
    }
    float _S632 = floor(_S620->fibre_across_0 / _S624->fibre_size_0);
    Albedos_0 _S633 = vary_albedos_0(_S619, _S621, _S631 + _S628, uint(int(_S632)) * 65536U + uint(int(floor(_S620->fibre_along_0 / (_S624->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S632))), kernelContext_42);
    return _S633;
}

YarnPoint_0 yarn_point_of_0(uint _S634, const SurfacePoint_0 thread* _S635, float _S636, float _S637, bool _S638, bool _S639, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S640 = kernelContext_43->fabrics_0+_S634;
    bool _S641 = _S635->is_warp_0;
    uint _S642;
    if(_S635->is_warp_0)
    {
        _S642 = _S640->warp_1;
    }
    else
    {
        _S642 = _S640->weft_1;
    }
    uint _S643;
    if(_S641)
    {
        _S643 = _S635->warp_thread_0;
    }
    else
    {
        _S643 = _S635->weft_thread_0;
    }
    Albedos_0 _S644 = albedos_of_0(_S642, _S643, kernelContext_43);
    bool _S645;
    if((_S640->fibre_noise_0) > 0.0f)
    {
        _S645 = true;
    }
    else
    {
        _S645 = (_S640->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_7;
    if(_S645)
    {
        thread Albedos_0 _S646 = _S644;
        Albedos_0 _S647 = varied_at_0(_S634, _S635, &_S646, _S636, _S637, kernelContext_43);
        albedos_7 = _S647;
    }
    else
    {
        albedos_7 = _S644;
    }
    thread YarnPoint_0 point_1;
    (&point_1)->back_6 = _S638;
    (&point_1)->hole_6 = _S639;
    (&point_1)->is_warp_3 = _S641;
    (&point_1)->x_11 = _S636;
    (&point_1)->y_6 = _S637;
    (&point_1)->height_10 = _S635->height_0;
    (&point_1)->normal_6 = _S635->normal_0;
    (&point_1)->tangent_7 = _S635->tangent_0;
    (&point_1)->roughness_10 = kernelContext_43->families_0[_S642].roughness_0;
    (&point_1)->albedos_6 = albedos_7;
    return point_1;
}

bool unoccluded_0(uint _S648, const SearchQuality_0 thread* _S649, float _S650, float _S651, float _S652, float3 _S653, bool _S654, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S655 = kernelContext_44->fabrics_0+_S648;
    if((_S653.z) <= 0.0f)
    {
        return false;
    }
    float _S656 = max_height_along_0(_S648, _S650, _S651, _S652, _S653, _S654, kernelContext_44);
    bool _S657 = is_free_0(_S648, _S649, float3(_S650, _S651, _S652 + _S655->lift_0), _S653, _S654, _S656, kernelContext_44);
    return _S657;
}

bool is_lit_0(uint _S658, const SearchQuality_0 thread* _S659, const YarnPoint_0 thread* _S660, float3 _S661, KernelContext_0 thread* kernelContext_45)
{
    if(_S660->hole_6)
    {
        return true;
    }
    bool _S662 = _S660->back_6;
    float3 _S663 = to_face_frame_0(_S661, _S660->back_6);
    float _S664 = _S663.z;
    bool _S665 = _S664 < 0.0f;
    float3 _S666 = _S660->normal_6;
    float _S667 = _S660->height_10;
    float3 normal_7;
    float height_11;
    if(_S665)
    {
        SurfacePoint_0 _S668 = surface_at_0(_S658, _S660->x_11, _S660->y_6, !_S662, kernelContext_45);
        normal_7 = _S668.normal_0;
        height_11 = _S668.height_0;
    }
    else
    {
        normal_7 = _S666;
        height_11 = _S667;
    }
    float3 _S669 = float3(_S663.xy, abs(_S664));
    if((dot(normal_7, _S669)) <= 0.0f)
    {
        return false;
    }
    bool _S670 = unoccluded_0(_S658, _S659, _S660->x_11, _S660->y_6, height_11, _S669, _S662 != _S665, kernelContext_45);
    return _S670;
}

Components_0 components_of_point_0(uint _S671, const SearchQuality_0 thread* _S672, const YarnPoint_0 thread* _S673, float3 _S674, float3 _S675, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S676 = kernelContext_46->fabrics_0+_S671;
    thread Components_0 result_3 = no_components_0();
    bool _S677 = _S673->hole_6;
    float _S678;
    if(_S673->hole_6)
    {
        _S678 = 1.0f;
    }
    else
    {
        _S678 = 0.0f;
    }
    (&result_3)->hole_2 = _S678;
    bool _S679;
    if(_S677)
    {
        _S679 = true;
    }
    else
    {
        bool _S680 = is_lit_0(_S671, _S672, _S673, _S674, kernelContext_46);
        _S679 = !_S680;
    }
    if(_S679)
    {
        return result_3;
    }
    float3 _S681 = to_face_frame_0(_S674, _S673->back_6);
    float3 _S682 = to_face_frame_0(_S675, _S673->back_6);
    bool _S683 = (_S681.z) < 0.0f;
    float3 _S684;
    if(_S683)
    {
        _S684 = - _S681;
    }
    else
    {
        _S684 = _S681;
    }
    float3 _S685 = _S673->normal_6;
    float _S686 = diffuse_reflection_0(_S684, _S673->normal_6, _S676->diffuse_blend_0);
    if(_S683)
    {
        _S678 = transmission_1(_S681, _S682, _S685, _S673->tangent_7, _S673->roughness_10, _S676->optical_depth_0);
    }
    else
    {
        _S678 = reflection_0(_S681, _S682, _S685, _S673->tangent_7, _S673->roughness_10, _S676->optical_depth_0);
    }
    bool _S687 = _S673->is_warp_3;
    float _S688;
    if(_S673->is_warp_3)
    {
        _S688 = _S686;
    }
    else
    {
        _S688 = 0.0f;
    }
    (&result_3)->diffuse_warp_0 = _S688;
    if(_S687)
    {
        _S688 = 0.0f;
    }
    else
    {
        _S688 = _S686;
    }
    (&result_3)->diffuse_weft_0 = _S688;
    if(_S687)
    {
        _S688 = _S678;
    }
    else
    {
        _S688 = 0.0f;
    }
    (&result_3)->specular_warp_0 = _S688;
    if(_S687)
    {
        _S678 = 0.0f;
    }
    (&result_3)->specular_weft_0 = _S678;
    (&result_3)->light_visibility_0 = 1.0f;
    return result_3;
}

float openness_number_0(uint _S689, uint _S690, KernelContext_0 thread* kernelContext_47)
{
    float _S691 = table_number_0((kernelContext_47->fabrics_0+_S689)->openness_0 + _S690, kernelContext_47);
    return _S691;
}

Blocked_0 blocked_of_terms_0(uint _S692, uint _S693, const array<float, int(6)> thread* _S694, uint _S695, KernelContext_0 thread* kernelContext_48)
{
    thread array<float, int(3)> shares_0;
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
            if(term_0 < _S695)
            {
            }
            else
            {
                break;
            }
            float _S696 = openness_number_0(_S692, _S693 + share_2 * _S695 + term_0, kernelContext_48);
            shares_0[share_2] = shares_0[share_2] + _S696 * (*_S694)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_2] = saturate(shares_0[share_2]);
        share_2 = share_2 + 1U;
    }
    thread Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

Blocked_0 blocked_at_0(uint _S697, bool _S698, bool _S699, float _S700, float _S701, KernelContext_0 thread* kernelContext_49)
{
    float _S702 = openness_number_0(_S697, 158U, kernelContext_49);
    float _S703 = _S701 * _S702;
    float _S704 = _S700 * _S700;
    float _S705 = _S700 * _S703;
    float _S706 = _S703 * _S703;
    uint _S707;
    if(_S699)
    {
        _S707 = 2U;
    }
    else
    {
        _S707 = 0U;
    }
    uint _S708;
    if(_S698)
    {
        _S708 = 0U;
    }
    else
    {
        _S708 = 1U;
    }
    uint _S709 = 60U + (_S707 + _S708) * 18U;
    thread array<float, int(6)> _S710;
    _S710[int(0)] = 1.0f;
    _S710[int(1)] = _S700;
    _S710[int(2)] = _S703;
    _S710[int(3)] = _S704;
    _S710[int(4)] = _S705;
    _S710[int(5)] = _S706;
    Blocked_0 _S711 = blocked_of_terms_0(_S697, _S709, &_S710, 6U, kernelContext_49);
    return _S711;
}

Blocked_0 with_blocked_0(uint _S712, const Blocked_0 thread* _S713, const YarnPoint_0 thread* _S714, bool _S715, float _S716, KernelContext_0 thread* kernelContext_50)
{
    bool _S717;
    if(_S714->hole_6)
    {
        _S717 = true;
    }
    else
    {
        _S717 = (_S714->is_warp_3) != _S715;
    }
    if(_S717)
    {
        return *_S713;
    }
    Blocked_0 _S718 = blocked_at_0(_S712, _S715, _S714->back_6, _S714->normal_6.z, _S714->height_10, kernelContext_50);
    thread Blocked_0 result_4;
    (&result_4)->by_warp_0 = _S713->by_warp_0 + _S716 * _S718.by_warp_0;
    (&result_4)->by_weft_0 = _S713->by_weft_0 + _S716 * _S718.by_weft_0;
    (&result_4)->far_0 = _S713->far_0 + _S716 * _S718.far_0;
    return result_4;
}

struct CoverageTaps_0
{
    array<uint, int(9)> nodes_1;
};

float3 pyramid_level_0(uint _S719, float _S720, KernelContext_0 thread* kernelContext_51)
{
    uint _S721 = (kernelContext_51->fabrics_0+_S719)->lobes_0.levels_0 + 4U * uint(min(_S720, (kernelContext_51->fabrics_0+_S719)->lobes_0.last_level_0));
    float _S722 = table_number_0(_S721, kernelContext_51);
    float _S723 = table_number_0(_S721 + 1U, kernelContext_51);
    float _S724 = table_number_0(_S721 + 2U, kernelContext_51);
    return float3(_S722, _S723, _S724);
}

CoverageTaps_0 coverage_taps_0(uint _S725, const Footprint_0 thread* _S726, bool _S727, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S728 = kernelContext_52->fabrics_0+_S725;
    float _S729 = Footprint_spread_side_0(_S726);
    Lobes_0 _S730 = _S728->lobes_0;
    float _S731 = _S729 * _S728->lobes_0.inverse_base_size_0;
    float3 _S732 = pyramid_level_0(_S725, floor(binary_logarithm_0(max(0.68000000715255737f * _S731, 1.0f))), kernelContext_52);
    float _S733 = 1.0f / max(_S731, 9.99999997475242708e-07f);
    float2 _S734 = float2(kernelContext_52->families_0[_S728->warp_1].inverse_period_0, kernelContext_52->families_0[_S728->weft_1].inverse_period_0);
    float2 _S735 = _S726->centre_0 * _S734;
    float2 _S736 = float2(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S733 * _S733), 0.0f, 1.0f)), 0.3333333432674408f * _S733), 1.0f)) ;
    float2 _S737 = _S726->dx_0 * _S734 * _S736;
    float2 _S738 = _S726->dy_0 * _S734 * _S736;
    thread CoverageTaps_0 taps_3;
    uint number_1 = 0U;
    for(;;)
    {
        if(number_1 < 9U)
        {
        }
        else
        {
            break;
        }
        float2 _S739 = _S735 + float2(TAP_OFFSETS_0[number_1].x)  * _S737 + float2(TAP_OFFSETS_0[number_1].y)  * _S738;
        float _S740 = _S732.y;
        float _S741 = wrapped_cell_0(_S739.x, _S740);
        float _S742 = wrapped_cell_0(_S739.y, _S732.z);
        uint _S743;
        if(_S727)
        {
            _S743 = _S730.face_nodes_0;
        }
        else
        {
            _S743 = 0U;
        }
        (&taps_3)->nodes_1[number_1] = _S743 + uint(_S742 * _S740 + _S741 + _S732.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

float4 coverage_of_pack_0(uint _S744, const CoverageTaps_0 thread* _S745, uint _S746, KernelContext_0 thread* kernelContext_53)
{
    Fabric_0 device* _S747 = kernelContext_53->fabrics_0+_S744;
    uint number_2 = 0U;
    uint even_1 = 0U;
    uint odd_1 = 0U;
    for(;;)
    {
        if(number_2 < 9U)
        {
        }
        else
        {
            break;
        }
        uint _S748 = kernelContext_53->words_0[_S747->lobes_0.coverage_0 + _S745->nodes_1[number_2] * _S747->lobes_0.packs_0 + _S746];
        uint even_2 = even_1 + (_S748 & 16711935U);
        uint odd_2 = odd_1 + ((_S748 >> 8U) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / float4(9.0f) ;
}

float coverage_of_holes_0(uint _S749, const CoverageTaps_0 thread* _S750, KernelContext_0 thread* kernelContext_54)
{
    Fabric_0 device* _S751 = kernelContext_54->fabrics_0+_S749;
    uint number_3 = 0U;
    uint total_0 = 0U;
    for(;;)
    {
        if(number_3 < 9U)
        {
        }
        else
        {
            break;
        }
        uint total_1 = total_0 + ((kernelContext_54->words_0[_S751->lobes_0.coverage_holes_0 + _S750->nodes_1[number_3] / 4U] >> (8U * (_S750->nodes_1[number_3] % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S752, const CoverageTaps_0 thread* _S753, const NodeTaps_0 thread* _S754, bool _S755, KernelContext_0 thread* kernelContext_55)
{
    Lobes_0 _S756 = (kernelContext_55->fabrics_0+_S752)->lobes_0;
    float4 _S757 = interpolate_table_0(_S754, (kernelContext_55->fabrics_0+_S752)->lobes_0.projected_area_0 + (kernelContext_55->fabrics_0+_S752)->lobes_0.packs_0, (kernelContext_55->fabrics_0+_S752)->lobes_0.packs_0 + 1U, kernelContext_55);
    float _S758 = _S757.x;
    float _S759;
    if(_S755)
    {
        _S759 = _S756.back_hole_weight_0;
    }
    else
    {
        _S759 = _S756.front_hole_weight_0;
    }
    float _S760 = coverage_of_holes_0(_S752, _S753, kernelContext_55);
    return min(_S760 * _S758 * _S758 * _S759, 1.0f);
}

Components_0 prefiltered_components_0(uint _S761, const Footprint_0 thread* _S762, float3 _S763, float3 _S764, bool _S765, KernelContext_0 thread* kernelContext_56)
{
    Fabric_0 device* _S766 = kernelContext_56->fabrics_0+_S761;
    CoverageTaps_0 _S767 = coverage_taps_0(_S761, _S762, _S765, kernelContext_56);
    NodeTaps_0 _S768 = node_taps_0(_S764);
    thread NodeTaps_0 view_nodes_0 = _S768;
    thread NodeTaps_0 light_nodes_0 = node_taps_0(_S763);
    thread NodeTaps_0 seen_nodes_0 = _S768;
    uint _S769;
    if(_S765)
    {
        _S769 = 1U;
    }
    else
    {
        _S769 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + uint4((_S769 * 256U)) ;
    uint _S770 = 2U * _S769;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + uint4((_S770 * 256U)) ;
    uint _S771;
    if((_S763.z) < 0.0f)
    {
        _S771 = 1U;
    }
    else
    {
        _S771 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + uint4(((_S770 + _S771) * 256U)) ;
    float3 _S772 = half_vector_0(_S763, _S764);
    float3 _S773 = shadow_correlation_0(_S763, _S764);
    if(_S765)
    {
        _S771 = _S766->lobes_0.back_warp_packs_0;
    }
    else
    {
        _S771 = _S766->lobes_0.front_warp_packs_0;
    }
    thread Components_0 sums_1;
    (&sums_1)->diffuse_warp_0 = 0.0f;
    (&sums_1)->diffuse_weft_0 = 0.0f;
    (&sums_1)->specular_warp_0 = 0.0f;
    (&sums_1)->specular_weft_0 = 0.0f;
    (&sums_1)->light_visibility_0 = 0.0f;
    uint pack_0 = 0U;
    float total_2 = 0.0f;
    for(;;)
    {
        Lobes_0 _S774 = _S766->lobes_0;
        if(pack_0 < (_S766->lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        thread CoverageTaps_0 _S775 = _S767;
        float4 _S776 = coverage_of_pack_0(_S761, &_S775, pack_0, kernelContext_56);
        uint _S777 = _S774.projected_area_0 + pack_0;
        uint _S778 = _S774.packs_0 + 1U;
        thread NodeTaps_0 _S779 = view_nodes_0;
        float4 _S780 = interpolate_table_0(&_S779, _S777, _S778, kernelContext_56);
        uint _S781 = _S774.light_visibility_1 + pack_0;
        thread NodeTaps_0 _S782 = seen_nodes_0;
        float4 _S783 = interpolate_table_0(&_S782, _S781, _S774.packs_0, kernelContext_56);
        float4 _S784 = float4(255.0f) ;
        float4 _S785 = _S783 / _S784;
        thread NodeTaps_0 _S786 = light_nodes_0;
        float4 _S787 = interpolate_table_0(&_S786, _S781, _S774.packs_0, kernelContext_56);
        float4 _S788 = _S787 / _S784;
        uint _S789 = _S774.irradiance_0 + pack_0;
        thread NodeTaps_0 _S790 = light_nodes_0;
        float4 _S791 = interpolate_table_0(&_S790, _S789, _S774.packs_0, kernelContext_56);
        float4 _S792 = _S791 * float4(0.00124827399849892f) ;
        bool _S793 = pack_0 < _S771;
        uint _S794;
        if(_S793)
        {
            _S794 = _S766->warp_1;
        }
        else
        {
            _S794 = _S766->weft_1;
        }
        Family_0 _S795 = kernelContext_56->families_0[_S794];
        uint number_4 = 0U;
        float diffuse_0 = 0.0f;
        float specular_0 = 0.0f;
        for(;;)
        {
            if(number_4 < 4U)
            {
            }
            else
            {
                break;
            }
            Group_0 _S796 = group_at_0(_S774.moments_0 + 12U * (4U * (_S769 * _S774.packs_0 + pack_0) + number_4), _S795.roughness_0, kernelContext_56);
            float _S797 = _S776[number_4] * _S780[number_4] * _S780[number_4] * _S796.weight_2;
            float2 _S798 = visibility_gain_0(_S773, _S788[number_4], _S785[number_4]);
            thread Group_0 _S799 = _S796;
            float _S800 = layer_value_0(&_S799, _S772, _S763, _S764, _S766->optical_depth_0);
            float _S801 = _S798.x;
            float diffuse_1 = diffuse_0 + _S797 * _S792[number_4] * _S801;
            float specular_1 = specular_0 + _S797 * _S800 * _S788[number_4] * _S798.y;
            (&sums_1)->light_visibility_0 = (&sums_1)->light_visibility_0 + _S797 * _S788[number_4] * _S801;
            float total_3 = total_2 + _S797;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S802;
        if(_S793)
        {
            _S802 = diffuse_0;
        }
        else
        {
            _S802 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S802;
        float _S803;
        if(_S793)
        {
            _S803 = 0.0f;
        }
        else
        {
            _S803 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S803;
        float _S804;
        if(_S793)
        {
            _S804 = specular_0;
        }
        else
        {
            _S804 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S804;
        float _S805;
        if(_S793)
        {
            _S805 = 0.0f;
        }
        else
        {
            _S805 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S805;
        pack_0 = pack_0 + 1U;
    }
    thread CoverageTaps_0 _S806 = _S767;
    thread NodeTaps_0 _S807 = view_nodes_0;
    float _S808 = prefiltered_hole_0(_S761, &_S806, &_S807, _S765, kernelContext_56);
    (&sums_1)->hole_2 = _S808;
    float _S809 = (1.0f - _S808) / max(total_2, 9.999999960041972e-13f);
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S809;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S809;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S809;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S809;
    (&sums_1)->light_visibility_0 = (&sums_1)->light_visibility_0 * _S809;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S810, const Footprint_0 thread* _S811, bool _S812, KernelContext_0 thread* kernelContext_57)
{
    Fabric_0 device* _S813 = kernelContext_57->fabrics_0+_S810;
    float2 _S814 = sqrt(_S811->dx_0 * _S811->dx_0 + _S811->dy_0 * _S811->dy_0);
    uint _S815 = _S813->warp_1;
    float2 _S816 = _S811->centre_0;
    Stretch_0 _S817 = stretch_of_0(_S813->warp_1, _S811->centre_0.x, _S814.x, kernelContext_57);
    uint _S818 = _S813->weft_1;
    Stretch_0 _S819 = stretch_of_0(_S813->weft_1, _S816.y, _S814.y, kernelContext_57);
    thread FamilyAlbedos_0 albedos_8;
    thread Stretch_0 _S820 = _S817;
    thread Stretch_0 _S821 = _S819;
    Albedos_0 _S822 = mean_albedos_0(_S815, _S818, &_S820, &_S821, _S812, kernelContext_57);
    (&albedos_8)->warp_5 = _S822;
    thread Stretch_0 _S823 = _S819;
    thread Stretch_0 _S824 = _S817;
    Albedos_0 _S825 = mean_albedos_0(_S818, _S815, &_S823, &_S824, _S812, kernelContext_57);
    (&albedos_8)->weft_5 = _S825;
    return albedos_8;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S826, const Footprint_0 thread* _S827, float _S828, float2 _S829, float3 _S830, float3 _S831, KernelContext_0 thread* kernelContext_58)
{
    float _S832;
    Fabric_0 device* _S833 = kernelContext_58->fabrics_0+_S826;
    Regime_0 _S834 = regime_of_0(_S826, _S827, _S828, kernelContext_58);
    bool _S835 = (_S831.z) < 0.0f;
    float3 _S836 = to_face_frame_0(_S831, _S835);
    bool _S837;
    if((_S833->fibre_noise_0) > 0.0f)
    {
        _S837 = true;
    }
    else
    {
        _S837 = (_S833->colour_noise_0) > 0.0f;
    }
    bool _S838;
    if((kernelContext_58->families_0[_S833->warp_1].quantities_0) > 1U)
    {
        _S838 = true;
    }
    else
    {
        _S838 = (kernelContext_58->families_0[_S833->weft_1].quantities_0) > 1U;
    }
    float _S839 = 1.0f - _S834.prefiltered_0;
    if(_S839 > 0.0f)
    {
        if(_S837)
        {
            _S838 = true;
        }
    }
    else
    {
        _S838 = false;
    }
    thread Footprint_0 box_0 = *_S827;
    float3 _S840 = float3(0.0f) ;
    SurfacePoint_0 _S841 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S840, _S840, 0.0f, 0.0f, 0.0f);
    float2 _S842 = _S827->centre_0;
    Components_0 _S843 = no_components_0();
    thread CloseUp_0 close_1 = no_close_up_0();
    int _S844;
    if(_S838)
    {
        _S844 = int(0);
    }
    else
    {
        _S844 = int(1);
    }
    uint _S845 = uint(_S844);
    Components_0 points_1 = _S843;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S841;
    float2 central_place_0 = _S842;
    uint number_5 = _S845;
    for(;;)
    {
        float _S846 = float(number_5);
        _S832 = _S834.points_0;
        if(_S846 < (_S834.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S847 = number_5 == 0U;
        uint _S848;
        if(_S847)
        {
            _S848 = 0U;
        }
        else
        {
            _S848 = number_5 - 1U;
        }
        float2 _S849 = POINT_OFFSETS_0[_S848] + _S829;
        float2 _S850;
        if(_S847)
        {
            _S850 = float2(0.0f) ;
        }
        else
        {
            _S850 = _S849 - round(_S849);
        }
        float2 _S851 = _S842 + float2(_S850.x)  * _S827->dx_0 + float2(_S850.y)  * _S827->dy_0;
        float _S852;
        if(_S847)
        {
            _S852 = 0.0f;
        }
        else
        {
            _S852 = _S834.threads_1;
        }
        SearchQuality_0 _S853 = quality_of_0(_S852);
        float _S854 = _S851.x;
        float _S855 = _S851.y;
        thread SearchQuality_0 _S856 = _S853;
        Hit_0 _S857 = first_hit_0(_S826, &_S856, _S854, _S855, _S836, _S835, kernelContext_58);
        SurfacePoint_0 _S858 = surface_at_0(_S826, _S857.x_10, _S857.y_5, _S835, kernelContext_58);
        if(_S847)
        {
            float central_weight_1;
            if(_S857.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S839;
            }
            float2 central_place_1 = float2(_S857.x_10, _S857.y_5);
            (&box_0)->centre_0 = mix(_S842, central_place_1, float2(central_weight_1) );
            central_weight_0 = central_weight_1;
            central_0 = _S858;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        thread SurfacePoint_0 _S859 = _S858;
        YarnPoint_0 _S860 = yarn_point_of_0(_S826, &_S859, _S857.x_10, _S857.y_5, _S835, _S857.hole_5, kernelContext_58);
        thread SearchQuality_0 _S861 = _S853;
        thread YarnPoint_0 _S862 = _S860;
        Components_0 _S863 = components_of_point_0(_S826, &_S861, &_S862, _S830, _S831, kernelContext_58);
        float _S864 = min(_S834.points_0 - float(number_5 - 1U), 1.0f);
        thread Components_0 _S865 = points_1;
        thread Components_0 _S866 = _S863;
        Components_0 _S867 = with_added_0(&_S865, &_S866, _S864);
        if((_S833->openness_0) != 4294967295U)
        {
            thread Blocked_0 _S868 = (&close_1)->warp_0;
            thread YarnPoint_0 _S869 = _S860;
            Blocked_0 _S870 = with_blocked_0(_S826, &_S868, &_S869, true, _S864, kernelContext_58);
            (&close_1)->warp_0 = _S870;
            thread Blocked_0 _S871 = (&close_1)->weft_0;
            thread YarnPoint_0 _S872 = _S860;
            Blocked_0 _S873 = with_blocked_0(_S826, &_S871, &_S872, false, _S864, kernelContext_58);
            (&close_1)->weft_0 = _S873;
        }
        points_1 = _S867;
        number_5 = number_5 + 1U;
    }
    (&close_1)->weight_0 = _S839;
    float _S874 = max(_S832, 1.0f);
    float _S875 = 1.0f / _S874;
    thread Blocked_0 _S876 = (&close_1)->warp_0;
    Blocked_0 _S877 = scaled_0(&_S876, _S875);
    (&close_1)->warp_0 = _S877;
    float _S878 = 1.0f / _S874;
    thread Blocked_0 _S879 = (&close_1)->weft_0;
    Blocked_0 _S880 = scaled_0(&_S879, _S878);
    (&close_1)->weft_0 = _S880;
    thread Estimate_0 estimate_0;
    (&estimate_0)->close_0 = close_1;
    float _S881 = _S839 / _S874;
    thread Components_0 _S882 = _S843;
    thread Components_0 _S883 = points_1;
    Components_0 _S884 = with_added_0(&_S882, &_S883, _S881);
    (&estimate_0)->components_0 = _S884;
    if((_S834.prefiltered_0) > 0.0f)
    {
        Components_0 _S885 = prefiltered_components_0(_S826, _S827, to_face_frame_0(_S830, _S835), _S836, _S835, kernelContext_58);
        thread Components_0 _S886 = (&estimate_0)->components_0;
        thread Components_0 _S887 = _S885;
        Components_0 _S888 = with_added_0(&_S886, &_S887, _S834.prefiltered_0);
        (&estimate_0)->components_0 = _S888;
    }
    thread Footprint_0 _S889 = box_0;
    FamilyAlbedos_0 _S890 = albedos_over_0(_S826, &_S889, _S835, kernelContext_58);
    (&estimate_0)->albedos_5 = _S890;
    if(_S837)
    {
        _S837 = central_weight_0 > 0.0f;
    }
    else
    {
        _S837 = false;
    }
    if(_S837)
    {
        SurfacePoint_0 _S891 = central_0;
        Albedos_0 _S892;
        if(central_0.is_warp_0)
        {
            _S892 = (&(&estimate_0)->albedos_5)->warp_5;
        }
        else
        {
            _S892 = (&(&estimate_0)->albedos_5)->weft_5;
        }
        float _S893 = central_place_0.x;
        float _S894 = central_place_0.y;
        thread SurfacePoint_0 _S895 = central_0;
        thread Albedos_0 _S896 = _S892;
        Albedos_0 _S897 = varied_at_0(_S826, &_S895, &_S896, _S893, _S894, kernelContext_58);
        thread Albedos_0 _S898 = _S892;
        thread Albedos_0 _S899 = _S897;
        Albedos_0 _S900 = lerp_albedos_0(&_S898, &_S899, central_weight_0);
        if(_S891.is_warp_0)
        {
            (&(&estimate_0)->albedos_5)->warp_5 = _S900;
        }
        else
        {
            (&(&estimate_0)->albedos_5)->weft_5 = _S900;
        }
    }
    return estimate_0;
}

Estimate_0 lobes_estimate_0(uint _S901, const Footprint_0 thread* _S902, float _S903, float3 _S904, float3 _S905, KernelContext_0 thread* kernelContext_59)
{
    Estimate_0 _S906 = lobes_estimate_of_pass_0(_S901, _S902, _S903, float2(0.0f) , _S904, _S905, kernelContext_59);
    return _S906;
}

Scattered_0 scattered_by_0(uint _S907, const Albedos_0 thread* _S908, uint _S909, float3 _S910, KernelContext_0 thread* kernelContext_60)
{
    uint _S911 = 159U + 2U * _S909;
    thread Scattered_0 yarn_3;
    float3 _S912 = _S910 * _S908->diffuse_reflect_0;
    float _S913 = openness_number_0(_S907, _S911, kernelContext_60);
    (&yarn_3)->back_5 = _S912 + float3(_S913)  * _S908->specular_reflect_0;
    float3 _S914 = _S910 * _S908->diffuse_transmit_0;
    float _S915 = openness_number_0(_S907, _S911 + 1U, kernelContext_60);
    (&yarn_3)->through_0 = _S914 + float3(_S915)  * _S908->specular_transmit_0;
    return yarn_3;
}

float openness_number_1(uint _S916, uint _S917, KernelContext_0 thread* kernelContext_61)
{
    float _S918 = table_number_0((kernelContext_61->fabrics_0+_S916)->openness_0 + _S917, kernelContext_61);
    return _S918;
}

void sent_0(uint _S919, uint _S920, float3 _S921, float3 _S922, float3 _S923, float3 _S924, float3 thread* _S925, float3 thread* _S926, KernelContext_0 thread* kernelContext_62)
{
    uint _S927 = 146U + 4U * _S920;
    float _S928 = openness_number_1(_S919, _S927, kernelContext_62);
    float _S929 = openness_number_1(_S919, _S927 + 1U, kernelContext_62);
    float _S930 = openness_number_1(_S919, _S927 + 2U, kernelContext_62);
    float _S931 = openness_number_1(_S919, _S927 + 3U, kernelContext_62);
    float3 _S932 = float3(1.0f) ;
    float3 _S933 = _S932 - _S923 * float3(_S928) ;
    float3 _S934 = _S932 - _S924 * float3(_S931) ;
    float3 _S935 = _S932 / (_S933 * _S934 - _S923 * _S924 * float3((_S929 * _S930)) );
    *_S925 = (_S921 * _S934 + _S923 * float3(_S929)  * _S922) * _S935;
    *_S926 = (_S922 * _S933 + _S924 * float3(_S930)  * _S921) * _S935;
    return;
}

FaceSends_0 face_sends_0(uint _S936, uint _S937, const Scattered_0 thread* _S938, const Scattered_0 thread* _S939, KernelContext_0 thread* kernelContext_63)
{
    uint _S940 = 2U * _S937;
    uint _S941 = 142U + _S940;
    float _S942 = openness_number_0(_S936, _S941, kernelContext_63);
    float _S943 = openness_number_0(_S936, _S941 + 1U, kernelContext_63);
    float3 _S944 = _S938->back_5;
    float3 _S945 = float3((1.0f - _S942))  * _S938->back_5;
    float3 _S946 = _S939->back_5;
    float3 _S947 = float3((1.0f - _S943))  * _S939->back_5;
    thread FaceSends_0 sends_1;
    uint _S948 = 154U + _S940;
    float _S949 = openness_number_0(_S936, _S948, kernelContext_63);
    (&sends_1)->blocks_warp_0 = _S949;
    float _S950 = openness_number_0(_S936, _S948 + 1U, kernelContext_63);
    (&sends_1)->blocks_weft_0 = _S950;
    (&sends_1)->open_0 = _S949 * _S942 + _S950 * _S943;
    sent_0(_S936, _S937, float3(_S942)  * _S944, float3(_S943)  * _S946, _S945, _S947, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0, kernelContext_63);
    sent_0(_S936, _S937, _S938->through_0, _S939->through_0, _S945, _S947, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0, kernelContext_63);
    return sends_1;
}

Interior_0 interior_of_0(uint _S951, float3 _S952, bool _S953, KernelContext_0 thread* kernelContext_64)
{
    Fabric_0 device* _S954 = kernelContext_64->fabrics_0+_S951;
    Albedos_0 _S955 = table_albedos_0(kernelContext_64->families_0[_S954->warp_1].colour_mean_0, kernelContext_64);
    thread Albedos_0 _S956 = _S955;
    Scattered_0 _S957 = scattered_by_0(_S951, &_S956, 0U, _S952, kernelContext_64);
    Albedos_0 _S958 = table_albedos_0(kernelContext_64->families_0[_S954->weft_1].colour_mean_0, kernelContext_64);
    thread Albedos_0 _S959 = _S958;
    Scattered_0 _S960 = scattered_by_0(_S951, &_S959, 1U, _S952, kernelContext_64);
    uint _S961;
    if(_S953)
    {
        _S961 = 1U;
    }
    else
    {
        _S961 = 0U;
    }
    thread Scattered_0 _S962 = _S957;
    thread Scattered_0 _S963 = _S960;
    FaceSends_0 _S964 = face_sends_0(_S951, _S961, &_S962, &_S963, kernelContext_64);
    if(_S953)
    {
        _S961 = 0U;
    }
    else
    {
        _S961 = 1U;
    }
    thread Scattered_0 _S965 = _S957;
    thread Scattered_0 _S966 = _S960;
    FaceSends_0 _S967 = face_sends_0(_S951, _S961, &_S965, &_S966, kernelContext_64);
    float3 _S968 = float3(_S964.blocks_warp_0) ;
    float3 _S969 = float3(_S964.blocks_weft_0) ;
    float3 _S970 = _S968 * _S964.crossing_warp_0 + _S969 * _S964.crossing_weft_0;
    float3 _S971 = float3(_S967.blocks_warp_0) ;
    float3 _S972 = float3(_S967.blocks_weft_0) ;
    float3 _S973 = _S971 * _S967.crossing_warp_0 + _S972 * _S967.crossing_weft_0;
    float _S974 = 1.0f - _S964.open_0;
    float _S975 = 1.0f - _S967.open_0;
    float3 _S976 = float3(1.0f) ;
    float3 _S977 = _S976 / (_S976 - _S970 * _S973 * float3((_S974 * _S975)) );
    float3 _S978 = _S973 * (float3(_S964.open_0)  + float3(_S974)  * (_S968 * _S964.sky_warp_0 + _S969 * _S964.sky_weft_0)) * _S977;
    float3 _S979 = _S970 * (float3(_S967.open_0)  + float3(_S975)  * (_S971 * _S967.sky_warp_0 + _S972 * _S967.sky_weft_0)) * _S977;
    thread FaceSends_0 _S980 = _S964;
    FaceRadiance_0 _S981 = face_radiance_0(&_S980, _S967.open_0, _S978, _S979);
    thread FaceSends_0 _S982 = _S967;
    FaceRadiance_0 _S983 = face_radiance_0(&_S982, _S964.open_0, _S979, _S978);
    thread Interior_0 interior_1;
    (&interior_1)->warp_4 = _S981.warp_3;
    (&interior_1)->weft_4 = _S981.weft_3;
    (&interior_1)->leaked_1 = _S981.leaked_0;
    (&interior_1)->far_1 = _S983.mean_0;
    (&interior_1)->far_leaked_0 = _S983.leaked_0;
    return interior_1;
}

Blocked_0 blocked_from_0(uint _S984, float3 _S985, bool _S986, bool _S987, KernelContext_0 thread* kernelContext_65)
{
    thread array<float, int(6)> terms_1;
    view_terms_0(_S985, &terms_1);
    uint _S988;
    if(_S987)
    {
        _S988 = 2U;
    }
    else
    {
        _S988 = 0U;
    }
    uint _S989;
    if(_S986)
    {
        _S989 = 0U;
    }
    else
    {
        _S989 = 1U;
    }
    uint _S990 = (_S988 + _S989) * 15U;
    thread array<float, int(6)> _S991 = terms_1;
    Blocked_0 _S992 = blocked_of_terms_0(_S984, _S990, &_S991, 5U, kernelContext_65);
    return _S992;
}

float warp_seen_from_0(uint _S993, float3 _S994, bool _S995, KernelContext_0 thread* kernelContext_66)
{
    thread array<float, int(6)> terms_2;
    view_terms_0(_S994, &terms_2);
    uint term_1 = 0U;
    float share_3 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S996;
        if(_S995)
        {
            _S996 = 5U;
        }
        else
        {
            _S996 = 0U;
        }
        float _S997 = openness_number_0(_S993, 132U + _S996 + term_1, kernelContext_66);
        float share_4 = share_3 + _S997 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_3 = share_4;
    }
    return saturate(share_3);
}

Bounced_0 bounced_of_families_0(uint _S998, const FamilyAlbedos_0 thread* _S999, float3 _S1000, const Interior_0 thread* _S1001, const Blocked_0 thread* _S1002, const Blocked_0 thread* _S1003, KernelContext_0 thread* kernelContext_67)
{
    Scattered_0 _S1004 = scattered_by_0(_S998, &_S999->warp_5, 0U, _S1000, kernelContext_67);
    thread Scattered_0 _S1005 = _S1004;
    Bounced_0 _S1006 = bounced_by_0(_S1002, &_S1005, _S1001);
    Scattered_0 _S1007 = scattered_by_0(_S998, &_S999->weft_5, 1U, _S1000, kernelContext_67);
    thread Scattered_0 _S1008 = _S1007;
    Bounced_0 _S1009 = bounced_by_0(_S1003, &_S1008, _S1001);
    thread Bounced_0 _S1010 = _S1006;
    thread Bounced_0 _S1011 = _S1009;
    Bounced_0 _S1012 = sum_of_0(&_S1010, &_S1011);
    return _S1012;
}

Bounced_0 bounced_far_0(uint _S1013, const FamilyAlbedos_0 thread* _S1014, float3 _S1015, const Interior_0 thread* _S1016, float3 _S1017, bool _S1018, float _S1019, float _S1020, float _S1021, KernelContext_0 thread* kernelContext_68)
{
    Blocked_0 _S1022 = blocked_from_0(_S1013, _S1017, true, _S1018, kernelContext_68);
    Blocked_0 _S1023 = blocked_from_0(_S1013, _S1017, false, _S1018, kernelContext_68);
    float _S1024 = _S1019 / max(1.0f - _S1022.by_warp_0 - _S1022.by_weft_0, 0.10000000149011612f);
    float _S1025 = _S1020 / max(1.0f - _S1023.by_warp_0 - _S1023.by_weft_0, 0.10000000149011612f);
    float _S1026 = warp_seen_from_0(_S1013, _S1017, _S1018, kernelContext_68);
    float _S1027 = (0.0020000000949949f * _S1026 + _S1024) / (_S1024 + _S1025 + 0.0020000000949949f);
    float _S1028 = 1.0f - _S1021;
    float _S1029 = _S1027 * _S1028;
    thread Blocked_0 _S1030 = _S1022;
    Blocked_0 _S1031 = scaled_0(&_S1030, _S1029);
    float _S1032 = (1.0f - _S1027) * _S1028;
    thread Blocked_0 _S1033 = _S1023;
    Blocked_0 _S1034 = scaled_0(&_S1033, _S1032);
    thread Blocked_0 _S1035 = _S1031;
    thread Blocked_0 _S1036 = _S1034;
    Bounced_0 _S1037 = bounced_of_families_0(_S1013, _S1014, _S1015, _S1016, &_S1035, &_S1036, kernelContext_68);
    return _S1037;
}

Bounced_0 bounced_over_0(uint _S1038, const Components_0 thread* _S1039, const CloseUp_0 thread* _S1040, const FamilyAlbedos_0 thread* _S1041, float3 _S1042, float3 _S1043, KernelContext_0 thread* kernelContext_69)
{
    bool _S1044 = (_S1043.z) < 0.0f;
    Interior_0 _S1045 = interior_of_0(_S1038, _S1042, _S1044, kernelContext_69);
    float3 _S1046 = to_face_frame_0(_S1043, _S1044);
    thread Interior_0 _S1047 = _S1045;
    Bounced_0 _S1048 = bounced_far_0(_S1038, _S1041, _S1042, &_S1047, _S1046, _S1044, _S1039->diffuse_warp_0, _S1039->diffuse_weft_0, _S1039->hole_2, kernelContext_69);
    thread Bounced_0 bounced_2 = _S1048;
    float _S1049 = _S1040->weight_0;
    if((_S1040->weight_0) > 0.0f)
    {
        thread Interior_0 _S1050 = _S1045;
        Bounced_0 _S1051 = bounced_of_families_0(_S1038, _S1041, _S1042, &_S1050, &_S1040->warp_0, &_S1040->weft_0, kernelContext_69);
        float3 _S1052 = float3(_S1049) ;
        (&bounced_2)->reflected_0 = mix((&bounced_2)->reflected_0, _S1051.reflected_0, _S1052);
        (&bounced_2)->transmitted_0 = mix((&bounced_2)->transmitted_0, _S1051.transmitted_0, _S1052);
    }
    return bounced_2;
}

float3 composed_0(uint _S1053, const Components_0 thread* _S1054, const CloseUp_0 thread* _S1055, const FamilyAlbedos_0 thread* _S1056, float3 _S1057, float3 _S1058, float3 _S1059, KernelContext_0 thread* kernelContext_70)
{
    Fabric_0 device* _S1060 = kernelContext_70->fabrics_0+_S1053;
    Albedos_0 _S1061 = tinted_0(&_S1056->warp_5, _S1057);
    Albedos_0 _S1062 = tinted_0(&_S1056->weft_5, _S1057);
    float3 _S1063 = float3(_S1054->diffuse_warp_0) ;
    float3 _S1064 = float3(_S1054->diffuse_weft_0) ;
    float3 _S1065 = float3(_S1054->specular_warp_0) ;
    float3 _S1066 = float3(_S1054->specular_weft_0) ;
    float3 _S1067 = _S1061.diffuse_reflect_0 * _S1063 + _S1062.diffuse_reflect_0 * _S1064 + _S1061.specular_reflect_0 * _S1065 + _S1062.specular_reflect_0 * _S1066;
    float _S1068 = _S1059.z;
    float3 body_0;
    if((_S1058.z * _S1068) < 0.0f)
    {
        body_0 = _S1061.diffuse_transmit_0 * _S1063 + _S1062.diffuse_transmit_0 * _S1064 + _S1061.specular_transmit_0 * _S1065 + _S1062.specular_transmit_0 * _S1066;
    }
    else
    {
        body_0 = _S1067;
    }
    if((_S1060->openness_0) != 4294967295U)
    {
        Bounced_0 _S1069 = bounced_over_0(_S1053, _S1054, _S1055, _S1056, _S1057, _S1059, kernelContext_70);
        thread Bounced_0 _S1070 = _S1069;
        float3 _S1071 = bounced_value_0(&_S1070, _S1058, _S1059);
        body_0 = body_0 + _S1071;
    }
    float _S1072 = _S1060->sheen_strength_0;
    if((_S1060->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S1073 = _S1068 < 0.0f;
    float2 _S1074 = sheen_with_transmittance_0(to_face_frame_0(_S1058, _S1073), to_face_frame_0(_S1059, _S1073), _S1072, _S1060->sheen_roughness_0);
    return float3(_S1074.y)  * body_0 + float3(((_S1054->light_visibility_0 + _S1054->hole_2) * _S1074.x)) ;
}

float4 cloth_value_0(uint fabric_1, float2 centre_2, float2 dx_1, float2 dy_1, float3 light_10, float3 view_10, KernelContext_0 thread* kernelContext_71)
{
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_2;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    thread Footprint_0 _S1075 = footprint_0;
    Estimate_0 _S1076 = lobes_estimate_0(fabric_1, &_S1075, 1.0f, light_10, view_10, kernelContext_71);
    float3 _S1077 = float3(1.0f) ;
    thread Components_0 _S1078 = _S1076.components_0;
    thread CloseUp_0 _S1079 = _S1076.close_0;
    thread FamilyAlbedos_0 _S1080 = _S1076.albedos_5;
    float3 _S1081 = composed_0(fabric_1, &_S1078, &_S1079, &_S1080, _S1077, light_10, view_10, kernelContext_71);
    float through_1;
    if(((kernelContext_71->fabrics_0+fabric_1)->sheen_strength_0) > 0.0f)
    {
        through_1 = _S1076.components_0.hole_2 * (1.0f - (kernelContext_71->fabrics_0+fabric_1)->sheen_strength_0 * sheen_lobe_0(abs(view_10.z), (kernelContext_71->fabrics_0+fabric_1)->sheen_roughness_0).z);
    }
    else
    {
        through_1 = _S1076.components_0.hole_2;
    }
    return float4(_S1081, through_1);
}

[[kernel]] void lobes_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]])
{
    thread KernelContext_0 kernelContext_72;
    (&kernelContext_72)->query_count_0 = query_count_1;
    (&kernelContext_72)->queries_0 = queries_1;
    (&kernelContext_72)->answers_0 = answers_1;
    (&kernelContext_72)->fabrics_0 = fabrics_1;
    (&kernelContext_72)->families_0 = families_1;
    (&kernelContext_72)->words_0 = words_1;
    uint _S1082 = id_0.x;
    if(_S1082 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S1083 = (&kernelContext_72)->queries_0[_S1082];
    packed_float4 device* _S1084 = (&kernelContext_72)->answers_0+_S1082;
    float4 _S1085 = cloth_value_0(_S1083.fabric_0, float2(_S1083.centre_x_0, _S1083.centre_y_0), float2(_S1083.dx_x_0, _S1083.dx_y_0), float2(_S1083.dy_x_0, _S1083.dy_y_0), float3(_S1083.light_x_0, _S1083.light_y_0, _S1083.light_z_0), float3(_S1083.view_x_0, _S1083.view_y_0, _S1083.view_z_0), &kernelContext_72);
    *_S1084 = packed_float4(_S1085) ;
    return;
}

