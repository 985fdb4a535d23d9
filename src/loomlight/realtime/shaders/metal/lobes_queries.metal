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
    uint seed_0;
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

struct Neural_0
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

struct Clustered_0
{
    uint is_baked_1;
    uint clusters_0;
    uint rank_0;
    uint channels_0;
    uint columns_0;
    uint rows_0;
    float texel_width_0;
    float texel_height_0;
    uint samples_0;
    uint sums_0;
    uint labels_0;
    uint coefficients_0;
    uint basis_0;
    uint moments_1;
    uint light_0;
    uint view_0;
    uint offset_1;
    uint trust_0;
};

struct Fabric_0
{
    uint warp_1;
    uint weft_1;
    Lobes_0 lobes_0;
    Neural_0 neural_0;
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
    uint seed_1;
    float layer_bound_0;
    float fibre_size_0;
    uint has_detail_0;
    float uv_width_0;
    float uv_height_0;
    uint is_open_0;
    uint openness_0;
    uint albedo_map_0;
    uint albedo_map_levels_0;
    uint has_yarns_0;
    float mean_hole_0;
    Latent_0 latent_0;
    Clustered_0 clustered_0;
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
    float has_plies_0;
    float plies_per_mm_0;
    float ply_sine_0;
    float ply_cosine_0;
    float fibre_tilt_0;
    float fibre_tone_0;
    float slub_0;
    float slubs_per_mm_0;
    float per_half_width_0;
    float hairiness_0;
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
    float _S9 = floor(fma(index_0, (kernelContext_0->families_0+family_0)->inverse_count_0, (kernelContext_0->families_0+family_0)->half_inverse_count_0));
    return float2(_S9, fma(- _S9, (kernelContext_0->families_0+family_0)->count_0, index_0));
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
    float _S10 = floor(position_0 * (kernelContext_1->families_0+family_1)->inverse_size_0);
    thread Cell_0 cell_0;
    float _S11 = fma(- _S10, (kernelContext_1->families_0+family_1)->size_0, position_0);
    (&cell_0)->below_0 = _S11;
    (&cell_0)->above_0 = (kernelContext_1->families_0+family_1)->size_0 - _S11;
    (&cell_0)->across_2 = _S11 - 0.5f * (kernelContext_1->families_0+family_1)->size_0;
    (&cell_0)->half_width_1 = (kernelContext_1->families_0+family_1)->half_width_0;
    float2 _S12 = turns_and_remainder_0(family_1, _S10, kernelContext_1);
    (&cell_0)->thread_0 = uint(clamp(_S12.y, 0.0f, (kernelContext_1->families_0+family_1)->count_0 - 1.0f));
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
    float turns_0 = (position_1 - (kernelContext_4->families_0+family_2)->start_0) * (kernelContext_4->families_0+family_2)->inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S13 = turns_1 * (kernelContext_4->families_0+family_2)->period_0;
    uint thread_1 = kernelContext_4->words_0[(kernelContext_4->families_0+family_2)->first_thread_table_0 + uint(clamp(turns_1 * (kernelContext_4->families_0+family_2)->bins_0, 0.0f, (kernelContext_4->families_0+family_2)->bins_0 - 1.0f))];
    float _S14 = table_number_0((kernelContext_4->families_0+family_2)->place_table_0 + thread_1 * 4U + 1U, kernelContext_4);
    uint _S15;
    if(_S13 >= _S14)
    {
        _S15 = 1U;
    }
    else
    {
        _S15 = 0U;
    }
    uint _S16 = min(thread_1 + _S15, uint((kernelContext_4->families_0+family_2)->count_0) - 1U);
    uint _S17 = (kernelContext_4->families_0+family_2)->place_table_0 + _S16 * 4U;
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
    if(((kernelContext_5->families_0+family_3)->is_alike_0) != 0U)
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
    float _S32 = (kernelContext_6->families_0+family_4)->period_0;
    float _S33 = table_number_0((kernelContext_6->families_0+family_4)->place_table_0 + uint(_S30.y) * 4U, kernelContext_6);
    return fma(_S31, _S32, _S33);
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0, KernelContext_0 thread* kernelContext_7)
{
    if(((kernelContext_7->families_0+family_5)->is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * (kernelContext_7->families_0+family_5)->size_0;
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
    uint _S36 = (kernelContext_8->families_0+family_6)->bend_table_0;
    uint _S37;
    if(((kernelContext_8->families_0+family_6)->is_alike_0) != 0U)
    {
        _S37 = 0U;
    }
    else
    {
        _S37 = thread_4 * 4U;
    }
    uint _S38 = _S36 + _S37;
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
    if(((kernelContext_10->families_0+family_7)->is_alike_0) != 0U)
    {
        float _S65 = table_number_0((kernelContext_10->families_0+family_7)->bend_table_0 + 3U, kernelContext_10);
        return _S65;
    }
    uint _S66 = (kernelContext_10->families_0+family_7)->bend_table_0;
    float2 _S67 = turns_and_remainder_0(family_7, float(int(thread_6) + step_1), kernelContext_10);
    float _S68 = table_number_0(_S66 + uint(_S67.y) * 4U + 3U, kernelContext_10);
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
        float _S77 = (kernelContext_11->families_0+other_1)->height_scale_0;
        float _S78 = edge_drop_0(other_1, crossed_1->thread_0, int(0), kernelContext_11);
        _S73 = _S77 * _S78;
    }
    float _S79;
    if(_S76 != _S75)
    {
        _S79 = 0.0f;
    }
    else
    {
        float _S80 = (kernelContext_11->families_0+other_1)->height_scale_0;
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
        _S79 = _S80 * _S83;
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

struct Hair_0
{
    float cover_0;
    float3 normal_2;
    float3 tangent_2;
};

Hair_0 Hair_x24init_0(float cover_1, float3 normal_3, float3 tangent_3)
{
    thread Hair_0 _S133;
    (&_S133)->cover_0 = cover_1;
    (&_S133)->normal_2 = normal_3;
    (&_S133)->tangent_2 = tangent_3;
    return _S133;
}

float fade_0(float size_1, float period_1)
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

uint scramble_0(uint value_0)
{
    uint _S134 = value_0 * 747796405U + 2891336453U;
    uint _S135 = ((_S134 >> ((_S134 >> 28U) + 4U)) ^ _S134) * 277803737U;
    return (_S135 >> 22U) ^ _S135;
}

uint hash_key_0(uint thread_7, uint stream_0)
{
    return scramble_0(thread_7 + scramble_0(stream_0));
}

uint hash_bits_0(uint key_0, uint cell_5)
{
    return scramble_0(cell_5 + key_0);
}

float share_of_0(uint bits_0)
{
    return (float(bits_0 & 1023U) + 0.5f) * 0.0009765625f;
}

float2 sine_cosine_0(float x_4)
{
    float _S136 = floor(x_4 * 0.63661974668502808f + 0.5f);
    float _S137 = x_4 - _S136 * 1.5703125f - _S136 * 0.00048375129699707f - _S136 * 7.54979012640433211e-08f;
    float _S138 = _S137 * _S137;
    float _S139 = ((-0.00019515295571182f * _S138 + 0.00833216123282909f) * _S138 - 0.16666655242443085f) * _S138 * _S137 + _S137;
    float _S140 = ((0.00002443315679557f * _S138 - 0.00138873164542019f) * _S138 + 0.04166664555668831f) * _S138 * _S138 - 0.5f * _S138 + 1.0f;
    uint _S141 = uint(int(_S136)) & 3U;
    float2 _S142;
    if((_S141 & 1U) != 0U)
    {
        _S142 = float2(_S140, _S139);
    }
    else
    {
        _S142 = float2(_S139, _S140);
    }
    float _S143;
    if((_S141 & 2U) != 0U)
    {
        _S143 = - _S142.x;
    }
    else
    {
        _S143 = _S142.x;
    }
    float _S144;
    if(((_S141 + 1U) & 2U) != 0U)
    {
        _S144 = - _S142.y;
    }
    else
    {
        _S144 = _S142.y;
    }
    return float2(_S143, _S144);
}

float3 table_colour_0(uint index_3, KernelContext_0 thread* kernelContext_12)
{
    float _S145 = table_number_1(index_3, kernelContext_12);
    float _S146 = table_number_1(index_3 + 1U, kernelContext_12);
    float _S147 = table_number_1(index_3 + 2U, kernelContext_12);
    return float3(_S145, _S146, _S147);
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
    float3 _S148 = table_colour_0(row_0, kernelContext_13);
    (&albedos_0)->diffuse_reflect_0 = _S148;
    float3 _S149 = table_colour_0(row_0 + 3U, kernelContext_13);
    (&albedos_0)->diffuse_transmit_0 = _S149;
    float3 _S150 = table_colour_0(row_0 + 6U, kernelContext_13);
    (&albedos_0)->specular_reflect_0 = _S150;
    float3 _S151 = table_colour_0(row_0 + 9U, kernelContext_13);
    (&albedos_0)->specular_transmit_0 = _S151;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_8, KernelContext_0 thread* kernelContext_14)
{
    Albedos_0 _S152 = table_albedos_0((kernelContext_14->families_0+family_8)->albedo_table_0 + (kernelContext_14->families_0+family_8)->albedo_stride_0 * thread_8, kernelContext_14);
    return _S152;
}

float3 fibre_cell_0(float across_4, float along_0, float width_1)
{
    float _S153 = floor(across_4 / width_1);
    return float3(_S153, along_0 / (width_1 * 40.0f) + 0.61799997091293335f * _S153, 2.0f * (across_4 / width_1 - _S153) - 1.0f);
}

float ply_offset_0(uint family_9, const SurfacePoint_0 thread* point_0, bool back_4, KernelContext_0 thread* kernelContext_15)
{
    float _S154;
    if(back_4)
    {
        _S154 = - (kernelContext_15->families_0+family_9)->ply_sine_0;
    }
    else
    {
        _S154 = (kernelContext_15->families_0+family_9)->ply_sine_0;
    }
    float _S155 = (point_0->fibre_across_0 * (kernelContext_15->families_0+family_9)->ply_cosine_0 + point_0->fibre_along_0 * _S154) * (kernelContext_15->families_0+family_9)->plies_per_mm_0;
    return 2.0f * (_S155 - floor(_S155)) - 1.0f;
}

float signed_noise_0(uint bits_1)
{
    return (float(bits_1 & 65535U) + 0.5f) * 0.000030517578125f - 1.0f;
}

float smooth_share_0(float share_1)
{
    return share_1 * share_1 * (3.0f - 2.0f * share_1);
}

float2 wave_noise_0(uint key_1, float position_3)
{
    float _S156 = floor(position_3);
    float _S157 = position_3 - _S156;
    uint _S158 = uint(int(_S156));
    float _S159 = signed_noise_0(hash_bits_0(key_1, _S158));
    float _S160 = signed_noise_0(hash_bits_0(key_1, _S158 + 1U));
    return float2(mix(_S159, _S160, smooth_share_0(_S157)), 6.0f * _S157 * (1.0f - _S157) * (_S160 - _S159));
}

float2 cell_noise_0(uint key_2, float3 cell_6)
{
    float _S161 = cell_6.y;
    float _S162 = floor(_S161);
    uint _S163 = uint(int(cell_6.x)) * 65536U + uint(int(_S162));
    uint _S164 = hash_bits_0(key_2, _S163);
    uint _S165 = hash_bits_0(key_2, _S163 + 1U);
    return mix(float2(signed_noise_0(_S164), signed_noise_0(_S164 >> 16U)), float2(signed_noise_0(_S165), signed_noise_0(_S165 >> 16U)), float2(smooth_share_0(_S161 - _S162)) );
}

float uniform_hash_0(uint thread_9, uint cell_7, uint stream_1)
{
    return (float((hash_bits_0(hash_key_0(thread_9, stream_1), cell_7)) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_10, float amount_0, uint seed_2)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, 0U, seed_2 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_0, float3 albedo_1, float3 room_0)
{
    float3 _S166 = room_0 / max(albedo_1, float3(9.99999997475242708e-07f) );
    return min(gain_0, max(min(min(_S166.x, _S166.y), _S166.z), 0.0f));
}

float flattened_0(float largest_0, float3 albedo_2, float3 room_1)
{
    float3 _S167 = room_1 / max(albedo_2, float3(9.99999997475242708e-07f) ) - float3(1.0f) ;
    return min(max(min(min(_S167.x, _S167.y), _S167.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

float fibre_gain_0(uint thread_11, uint cell_8, float amount_1, uint seed_3)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, seed_3 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
    float3 normal_4;
    float3 tangent_4;
    float loss_0;
};

YarnFrame_0 under_hair_0(const YarnFrame_0 thread* frame_0, const Hair_0 thread* hair_0)
{
    float3 _S168 = frame_0->tangent_4;
    float3 _S169 = hair_0->tangent_2;
    float3 _S170;
    if((dot(frame_0->tangent_4, hair_0->tangent_2)) < 0.0f)
    {
        _S170 = - _S169;
    }
    else
    {
        _S170 = _S169;
    }
    thread YarnFrame_0 blended_0;
    float3 _S171 = float3(hair_0->cover_0) ;
    float3 _S172 = normalize(mix(frame_0->normal_4, hair_0->normal_2, _S171));
    (&blended_0)->normal_4 = _S172;
    float3 _S173 = mix(_S168, _S170, _S171);
    float3 _S174 = _S173 - float3(dot(_S173, _S172))  * _S172;
    (&blended_0)->tangent_4 = _S174 * float3(rsqrt(max(dot(_S174, _S174), 9.999999960041972e-13f))) ;
    (&blended_0)->loss_0 = frame_0->loss_0 * (1.0f - hair_0->cover_0);
    return blended_0;
}

float diffuse_gain_0(const YarnFrame_0 thread* frame_1, float blend_0)
{
    return min(0.85000002384185791f * blend_0 * frame_1->loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1->normal_4.z - 1.0f) + 1.0f));
}

float diffuse_reflection_0(float3 light_1, float3 normal_5, float blend_1)
{
    float _S175 = light_1.z;
    if(_S175 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S175, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

float projected_area_1(float3 direction_2, float3 tangent_5, float roughness_1)
{
    float _S176 = dot(direction_2, tangent_5);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S176 * _S176 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S177 = clamp(x_5, -87.0f, 88.0f);
    float _S178 = floor(_S177 * 1.4426950216293335f + 0.5f);
    float _S179 = _S177 - _S178 * 0.693359375f + _S178 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S179 + 0.00139819993637502f) * _S179 + 0.00833345204591751f) * _S179 + 0.04166579619050026f) * _S179 + 0.1666666567325592f) * _S179 + 0.5f;
    float _S180 = (as_type<float>((uint(int(_S178) + int(127)) << 23U)));
    float _S181;
    if(x_5 < -87.0f)
    {
        _S181 = 0.0f;
    }
    else
    {
        _S181 = (p_0 * _S179 * _S179 + _S179 + 1.0f) * _S180;
    }
    return _S181;
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
    float _S182 = roughness_2 * roughness_2;
    float _S183 = squared_along_0 * (1.0f - _S182) + _S182;
    return 0.31830987334251404f * _S182 * roughness_2 / (_S183 * _S183);
}

float density_between_0(float3 light_2, float3 view_1, float3 tangent_6, float roughness_3)
{
    float3 _S184 = light_2 + view_1;
    float _S185 = dot(_S184, tangent_6);
    return flake_density_0(min(_S185 * _S185 / max(square_1(_S184), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float transmission_1(float3 light_3, float3 view_2, float3 normal_6, float3 tangent_7, float roughness_4, float optical_depth_1)
{
    float _S186 = - dot(light_3, normal_6);
    float _S187 = dot(view_2, normal_6);
    bool _S188;
    if(_S186 <= 0.0f)
    {
        _S188 = true;
    }
    else
    {
        _S188 = _S187 <= 0.0f;
    }
    if(_S188)
    {
        return 0.0f;
    }
    float _S189 = 1.0f / max(_S187, 9.99999997475242708e-07f);
    float _S190 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S186, 9.99999997475242708e-07f);
    float _S191 = projected_area_1(view_2, tangent_7, roughness_4) * _S189;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S190, _S191)) * mean_attenuation_0(optical_depth_1 * abs(_S190 - _S191)) * _S189;
}

float reflection_0(float3 light_4, float3 view_3, float3 normal_7, float3 tangent_8, float roughness_5, float optical_depth_2)
{
    float _S192 = dot(light_4, normal_7);
    bool _S193;
    if(_S192 <= 0.0f)
    {
        _S193 = true;
    }
    else
    {
        _S193 = (dot(view_3, normal_7)) <= 0.0f;
    }
    if(_S193)
    {
        return 0.0f;
    }
    float _S194 = max(_S192, 9.99999997475242708e-07f);
    float _S195 = max(dot(view_3, normal_7), 9.99999997475242708e-07f);
    float _S196 = projected_area_1(light_4, tangent_8, roughness_5) * _S195 + projected_area_1(view_3, tangent_8, roughness_5) * _S194;
    float _S197 = optical_depth_2 * _S196 / (_S194 * _S195);
    return 0.25f * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S197 * mean_attenuation_0(_S197)) * _S194 / _S196;
}

Components_0 with_added_0(const Components_0 thread* sums_1, const Components_0 thread* more_0, float weight_1)
{
    thread Components_0 result_0;
    (&result_0)->diffuse_warp_0 = sums_1->diffuse_warp_0 + weight_1 * more_0->diffuse_warp_0;
    (&result_0)->diffuse_weft_0 = sums_1->diffuse_weft_0 + weight_1 * more_0->diffuse_weft_0;
    (&result_0)->specular_warp_0 = sums_1->specular_warp_0 + weight_1 * more_0->specular_warp_0;
    (&result_0)->specular_weft_0 = sums_1->specular_weft_0 + weight_1 * more_0->specular_weft_0;
    (&result_0)->light_visibility_0 = sums_1->light_visibility_0 + weight_1 * more_0->light_visibility_0;
    (&result_0)->hole_2 = sums_1->hole_2 + weight_1 * more_0->hole_2;
    return result_0;
}

Blocked_0 scaled_0(const Blocked_0 thread* blocked_0, float share_2)
{
    thread Blocked_0 result_1;
    (&result_1)->by_warp_0 = share_2 * blocked_0->by_warp_0;
    (&result_1)->by_weft_0 = share_2 * blocked_0->by_weft_0;
    (&result_1)->far_0 = share_2 * blocked_0->far_0;
    return result_1;
}

float wrapped_cell_0(float position_4, float count_1)
{
    return min(floor((position_4 - floor(position_4)) * count_1), count_1 - 1.0f);
}

float arc_tangent_quotient_0(float x_6, float y_0)
{
    return ((((((0.0f * x_6 + 0.00809729471802711f) * x_6 + -0.0377517081797123f) * x_6 + 0.08475969731807709f) * x_6 + -0.13537675142288208f) * x_6 + 0.19895026087760925f) * x_6 + -0.33327975869178772f) * x_6 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_1, float x_7)
{
    float _S198 = abs(x_7);
    float _S199 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S198, _S199) / max(max(_S198, _S199), 1.00000000317107685e-30f));
    float angle_1;
    if(_S199 > _S198)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_7 < 0.0f)
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
    float _S200 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S201 = floor(_S200);
    float _S202 = _S200 - _S201;
    float _S203 = sqrt(clamp((1.0f - abs(direction_3.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S204 = 7.0f * _S203 * sqrt(_S203);
    float _S205 = min(floor(_S204), 6.0f);
    float _S206 = _S204 - _S205;
    uint _S207 = uint(int(_S201) + int(32)) % 32U;
    uint _S208 = uint(_S205);
    uint _S209 = _S207 * 8U + _S208;
    uint _S210 = (_S207 + 1U) % 32U * 8U + _S208;
    thread NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = uint4(_S209, _S209 + 1U, _S210, _S210 + 1U);
    float _S211 = 1.0f - _S202;
    float _S212 = 1.0f - _S206;
    uint4 _S213 = uint4(float4(_S211 * _S212, _S211 * _S206, _S202 * _S212, _S202 * _S206) * float4(252.0f)  + float4(0.5f) );
    (&taps_0)->weights_0 = _S213;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S213.x + _S213.y + _S213.z + _S213.w);
    return taps_0;
}

float3 half_vector_0(float3 light_5, float3 view_4)
{
    float3 _S214 = light_5 + view_4;
    return _S214 * float3(rsqrt(max(square_1(_S214), 9.999999960041972e-13f))) ;
}

float3 shadow_correlation_0(float3 light_6, float3 view_5)
{
    float2 _S215 = light_6.xy;
    float2 _S216 = view_5.xy;
    float _S217 = dot(_S215, _S216) / max(sqrt(dot(_S215, _S215) * dot(_S216, _S216)), 9.99999997475242708e-07f);
    if((light_6.z) < 0.0f)
    {
        return float3(float2((-0.09000000357627869f + -0.07999999821186066f * _S217)) , 0.0f);
    }
    return float3(min(0.62000000476837158f + 0.62999999523162842f * _S217, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16U), float(odd_0 >> 16U));
}

float4 interpolate_0(const NodeTaps_0 thread* taps_1, uint4 packs_1)
{
    uint4 _S218 = uint4(16711935U) ;
    uint4 _S219 = (packs_1 & _S218) * taps_1->weights_0;
    uint4 _S220 = ((packs_1 >> (uint4(8U) )) & _S218) * taps_1->weights_0;
    return bytes_of_sums_0(_S219.x + _S219.y + _S219.z + _S219.w, _S220.x + _S220.y + _S220.z + _S220.w) * float4(taps_1->inverse_sum_0) ;
}

float4 interpolate_table_0(const NodeTaps_0 thread* taps_2, uint table_0, uint stride_0, KernelContext_0 thread* kernelContext_16)
{
    uint4 _S221 = uint4(table_0)  + taps_2->nodes_0 * uint4(stride_0) ;
    float4 _S222 = interpolate_0(taps_2, uint4(kernelContext_16->words_0[_S221.x], kernelContext_16->words_0[_S221.y], kernelContext_16->words_0[_S221.z], kernelContext_16->words_0[_S221.w]));
    return _S222;
}

struct Group_0
{
    float3 normal_8;
    float weight_2;
    float3 tangent_9;
    float3 variance_0;
    float3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7, KernelContext_0 thread* kernelContext_17)
{
    thread Group_0 group_0;
    float _S223 = table_number_0(row_1, kernelContext_17);
    float _S224 = table_number_0(row_1 + 1U, kernelContext_17);
    float _S225 = table_number_0(row_1 + 2U, kernelContext_17);
    (&group_0)->normal_8 = float3(_S223, _S224, _S225);
    float _S226 = table_number_0(row_1 + 3U, kernelContext_17);
    (&group_0)->weight_2 = _S226;
    float _S227 = table_number_0(row_1 + 4U, kernelContext_17);
    float _S228 = table_number_0(row_1 + 5U, kernelContext_17);
    float _S229 = table_number_0(row_1 + 6U, kernelContext_17);
    float3 _S230 = float3(_S227, _S228, _S229);
    (&group_0)->tangent_9 = _S230;
    float _S231 = table_number_0(row_1 + 7U, kernelContext_17);
    float _S232 = table_number_0(row_1 + 8U, kernelContext_17);
    (&group_0)->variance_0 = float3(_S231, _S232, 1.0f - square_1(_S230) - _S231 - _S232);
    float _S233 = table_number_0(row_1 + 9U, kernelContext_17);
    float _S234 = table_number_0(row_1 + 10U, kernelContext_17);
    float _S235 = table_number_0(row_1 + 11U, kernelContext_17);
    (&group_0)->covariance_0 = float3(_S233, _S234, _S235);
    (&group_0)->roughness_6 = roughness_7;
    return group_0;
}

float2 visibility_gain_0(float3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * float2((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f))  + float2(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), float2(0.0f) );
}

float Group_variance_along_0(const Group_0 thread* this_5, float3 direction_4)
{
    float _S236 = direction_4.x;
    float _S237 = direction_4.y;
    float _S238 = direction_4.z;
    return max(dot(this_5->variance_0, direction_4 * direction_4) + 2.0f * dot(this_5->covariance_0, float3(_S236 * _S237, _S236 * _S238, _S237 * _S238)), 0.0f);
}

float mean_area_0(const Group_0 thread* group_1, float3 direction_5)
{
    float _S239 = dot(direction_5, group_1->tangent_9);
    float _S240 = _S239 * _S239;
    float _S241 = Group_variance_along_0(group_1, direction_5);
    float _S242 = group_1->roughness_6 * group_1->roughness_6;
    return sqrt(max((_S242 - 1.0f) * (_S240 + _S241) + 1.0f, _S242));
}

float mean_density_0(const Group_0 thread* group_2, float3 half_0)
{
    float _S243 = group_2->roughness_6;
    float _S244 = max(sqrt(max(1.0f - group_2->roughness_6 * group_2->roughness_6, 0.0f)) / group_2->roughness_6, 0.00100000004749745f);
    float _S245 = Group_variance_along_0(group_2, half_0);
    float _S246 = max(sqrt(3.0f * _S245), _S243 * 0.01999999955296516f + 0.00009999999747379f);
    float _S247 = dot(half_0, group_2->tangent_9);
    float _S248 = _S244 * (_S247 - _S246);
    float _S249 = _S244 * (_S247 + _S246);
    float _S250 = _S248 * _S249;
    float _S251 = 2.0f * _S246 * _S244;
    return 0.15915493667125702f / _S243 * ((1.0f - _S250) / ((_S248 * _S248 + 1.0f) * (_S249 * _S249 + 1.0f)) + arc_tangent_0(_S251, 1.0f + _S250) / _S251);
}

float layer_value_0(const Group_0 thread* group_3, float3 half_1, float3 light_7, float3 view_6, float optical_depth_3)
{
    bool _S252 = (light_7.z) < 0.0f;
    float3 _S253 = group_3->normal_8;
    float _S254 = dot(light_7, group_3->normal_8);
    float _S255;
    if(_S252)
    {
        _S255 = - _S254;
    }
    else
    {
        _S255 = _S254;
    }
    float _S256 = max(_S255, 0.01999999955296516f);
    float _S257 = max(dot(view_6, _S253), 0.01999999955296516f);
    float _S258 = mean_area_0(group_3, light_7);
    float _S259 = _S258 / _S256;
    float _S260 = mean_area_0(group_3, view_6);
    float _S261 = _S260 / _S257;
    if(_S252)
    {
        _S255 = abs(_S259 - _S261);
    }
    else
    {
        _S255 = _S259 + _S261;
    }
    float _S262 = optical_depth_3 * max(_S255, 0.00100000004749745f);
    if(_S252)
    {
        _S255 = exponential_0(- optical_depth_3 * min(_S259, _S261));
    }
    else
    {
        _S255 = 1.0f;
    }
    float _S263 = optical_depth_3 * _S255 * (1.0f - exponential_0(- _S262)) / _S262 / _S257;
    if(_S252)
    {
        _S255 = 1.0f;
    }
    else
    {
        _S255 = 1.0f - 0.34999999403953552f * (1.0f - square_1(_S253));
    }
    float _S264 = mean_density_0(group_3, half_1);
    return 0.25f * _S264 * _S255 * _S263;
}

struct Bound_0
{
    uint thread_12;
    float turns_2;
    float cell_9;
    float visible_0;
    float width_2;
    float gap_0;
};

Bound_0 bound_at_0(uint family_10, float position_5, KernelContext_0 thread* kernelContext_18)
{
    Cell_0 _S265 = locate_0(family_10, position_5, kernelContext_18);
    float _S266 = table_number_0((kernelContext_18->families_0+family_10)->before_0 + 2U * _S265.thread_0 + 1U, kernelContext_18);
    thread Bound_0 bound_0;
    (&bound_0)->thread_12 = _S265.thread_0;
    (&bound_0)->turns_2 = round((position_5 - (kernelContext_18->families_0+family_10)->start_0 - _S266 - _S265.below_0) * (kernelContext_18->families_0+family_10)->inverse_period_0);
    (&bound_0)->cell_9 = _S265.below_0;
    float _S267 = 2.0f * _S265.half_width_1;
    (&bound_0)->width_2 = _S267;
    (&bound_0)->visible_0 = clamp((_S265.across_2 + _S265.half_width_1) / _S267, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S265.below_0, _S265.below_0 - _S265.across_2 - _S265.half_width_1) + max(_S265.across_2 - _S265.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_11, float centre_1, float size_2, KernelContext_0 thread* kernelContext_19)
{
    float _S268 = centre_1 - floor((centre_1 - (kernelContext_19->families_0+family_11)->start_0) * (kernelContext_19->families_0+family_11)->inverse_period_0) * (kernelContext_19->families_0+family_11)->period_0;
    float _S269 = 0.5f * max(size_2, (kernelContext_19->families_0+family_11)->smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S270 = bound_at_0(family_11, _S268 - _S269, kernelContext_19);
    (&stretch_0)->low_0 = _S270;
    Bound_0 _S271 = bound_at_0(family_11, _S268 + _S269, kernelContext_19);
    (&stretch_0)->high_0 = _S271;
    return stretch_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

float3 lengths_0(uint family_12, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_20)
{
    float _S272 = Stretch_turns_0(stretch_1);
    uint _S273 = (kernelContext_20->families_0+family_12)->before_0 + 2U * (&stretch_1->low_0)->thread_12;
    uint _S274 = (kernelContext_20->families_0+family_12)->before_0 + 2U * (&stretch_1->high_0)->thread_12;
    float _S275 = table_number_0(_S274, kernelContext_20);
    float _S276 = table_number_0(_S273, kernelContext_20);
    float _S277 = _S275 - _S276;
    float _S278 = table_number_0(_S274 + 1U, kernelContext_20);
    float _S279 = table_number_0(_S273 + 1U, kernelContext_20);
    float _S280 = _S278 - _S279;
    return float3(_S277 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_2 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_2 + _S272 * (kernelContext_20->families_0+family_12)->visible_total_0, _S280 - _S277 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0 + _S272 * ((kernelContext_20->families_0+family_12)->period_0 - (kernelContext_20->families_0+family_12)->visible_total_0), _S280 + (&stretch_1->high_0)->cell_9 - (&stretch_1->low_0)->cell_9 + _S272 * (kernelContext_20->families_0+family_12)->period_0);
}

float2 integrals_along_0(uint family_13, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_21)
{
    uint _S281 = (kernelContext_21->families_0+family_13)->quantities_0;
    uint _S282 = 3U * (kernelContext_21->families_0+family_13)->quantities_0;
    uint _S283 = (kernelContext_21->families_0+family_13)->colour_threads_0 + _S282 * (&stretch_2->low_0)->thread_12 + quantity_0;
    uint _S284 = (kernelContext_21->families_0+family_13)->colour_threads_0 + _S282 * (&stretch_2->high_0)->thread_12 + quantity_0;
    uint _S285 = (kernelContext_21->families_0+family_13)->colour_threads_0 + _S282 * uint((kernelContext_21->families_0+family_13)->count_0) + quantity_0;
    float _S286 = table_number_0(_S283, kernelContext_21);
    float _S287 = table_number_0(_S284, kernelContext_21);
    float _S288 = Stretch_turns_0(stretch_2);
    float _S289 = table_number_0(_S284 + _S281, kernelContext_21);
    float _S290 = table_number_0(_S283 + _S281, kernelContext_21);
    float _S291 = _S289 - _S290 + _S287 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_2 - _S286 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_2;
    float _S292 = table_number_0(_S285 + _S281, kernelContext_21);
    float _S293 = _S291 + _S288 * _S292;
    uint _S294 = 2U * _S281;
    float _S295 = table_number_0(_S284 + _S294, kernelContext_21);
    float _S296 = table_number_0(_S283 + _S294, kernelContext_21);
    float _S297 = _S295 - _S296 + _S287 * (&stretch_2->high_0)->cell_9 - _S286 * (&stretch_2->low_0)->cell_9;
    float _S298 = table_number_0(_S285 + _S294, kernelContext_21);
    return float2(_S293, _S297 + _S288 * _S298);
}

bool Stretch_wraps_0(const Stretch_0 thread* this_7)
{
    return ((&this_7->high_0)->thread_12) < ((&this_7->low_0)->thread_12);
}

bool Stretch_wraps_1(const Stretch_0 thread* this_8)
{
    return ((&this_8->high_0)->thread_12) < ((&this_8->low_0)->thread_12);
}

uint4 Stretch_differences_0(const Stretch_0 thread* this_9, uint4 entries_0, uint whole_0)
{
    uint _S299 = entries_0.z;
    uint _S300 = entries_0.x;
    uint _S301 = _S299 - _S300;
    bool _S302 = Stretch_wraps_1(this_9);
    uint _S303;
    if(_S302)
    {
        _S303 = whole_0;
    }
    else
    {
        _S303 = 0U;
    }
    return uint4(_S301 + _S303, entries_0.w - _S299, entries_0.y - _S300, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_5, uint row_2, uint count_2, uint quantities_1, KernelContext_0 thread* kernelContext_22)
{
    uint _S304 = row_2 + (&across_5->low_0)->thread_12 * quantities_1;
    uint _S305 = row_2 + (&across_5->high_0)->thread_12 * quantities_1;
    uint4 _S306 = Stretch_differences_0(across_5, uint4(kernelContext_22->words_0[_S304], kernelContext_22->words_0[_S304 + quantities_1], kernelContext_22->words_0[_S305], kernelContext_22->words_0[_S305 + quantities_1]), kernelContext_22->words_0[row_2 + count_2 * quantities_1]);
    return _S306;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_10)
{
    float _S307 = (&this_10->high_0)->visible_0;
    float _S308 = - (&this_10->low_0)->visible_0;
    float _S309 = Stretch_turns_0(this_10);
    bool _S310 = Stretch_wraps_0(this_10);
    float _S311;
    if(_S310)
    {
        _S311 = 1.0f;
    }
    else
    {
        _S311 = 0.0f;
    }
    return float4(1.0f, _S307, _S308, _S309 - _S311);
}

float integral_on_top_0(uint family_14, const Stretch_0 thread* across_6, const Stretch_0 thread* along_1, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_23)
{
    uint _S312 = uint((kernelContext_23->families_0+family_14)->count_0);
    uint _S313 = (_S312 + 1U) * (kernelContext_23->families_0+family_14)->quantities_0;
    uint _S314 = (kernelContext_23->families_0+family_14)->colour_areas_0 + quantity_1;
    uint _S315 = (&along_1->low_0)->thread_12;
    uint4 _S316 = row_differences_0(across_6, _S314 + (&along_1->low_0)->thread_12 * _S313, _S312, (kernelContext_23->families_0+family_14)->quantities_0, kernelContext_23);
    uint4 _S317 = row_differences_0(across_6, _S314 + (_S315 + 1U) * _S313, _S312, (kernelContext_23->families_0+family_14)->quantities_0, kernelContext_23);
    uint _S318 = (&along_1->high_0)->thread_12;
    uint4 _S319 = row_differences_0(across_6, _S314 + (&along_1->high_0)->thread_12 * _S313, _S312, (kernelContext_23->families_0+family_14)->quantities_0, kernelContext_23);
    uint4 _S320 = row_differences_0(across_6, _S314 + (_S318 + 1U) * _S313, _S312, (kernelContext_23->families_0+family_14)->quantities_0, kernelContext_23);
    uint4 _S321 = row_differences_0(across_6, _S314 + crossing_count_0 * _S313, _S312, (kernelContext_23->families_0+family_14)->quantities_0, kernelContext_23);
    uint4 _S322 = _S319 - _S316;
    bool _S323 = Stretch_wraps_0(along_1);
    uint4 _S324;
    if(_S323)
    {
        _S324 = _S321;
    }
    else
    {
        _S324 = uint4(int4(int(0)) );
    }
    uint4 _S325 = _S322 + _S324;
    float4 _S326 = Stretch_weights_0(across_6);
    float4 _S327 = Stretch_weights_0(along_1);
    return dot(float4(dot(float4(int4(_S325)), _S326), dot(float4(int4(_S320 - _S319)), _S326), dot(float4(int4(_S317 - _S316)), _S326), dot(float4(int4(_S321)), _S326)), _S327) * (kernelContext_23->families_0+family_14)->area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_3, uint row_3, KernelContext_0 thread* kernelContext_24)
{
    Albedos_0 _S328 = table_albedos_0(row_3, kernelContext_24);
    thread Albedos_0 sum_0;
    float3 _S329 = float3(weight_3) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S329 * _S328.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S329 * _S328.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S329 * _S328.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S329 * _S328.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_15, uint crossing_1, const Stretch_0 thread* own_1, const Stretch_0 thread* other_2, bool back_5, KernelContext_0 thread* kernelContext_25)
{
    Albedos_0 _S330 = table_albedos_0((kernelContext_25->families_0+family_15)->colour_mean_0, kernelContext_25);
    thread Albedos_0 albedos_2 = _S330;
    if(((kernelContext_25->families_0+family_15)->quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S331 = lengths_0(crossing_1, other_2, kernelContext_25);
    bool is_exposed_0 = false;
    float weight_4 = 0.0f;
    uint quantity_2 = 0U;
    for(;;)
    {
        if(quantity_2 < ((kernelContext_25->families_0+family_15)->quantities_0))
        {
        }
        else
        {
            break;
        }
        float2 _S332 = integrals_along_0(family_15, own_1, quantity_2, kernelContext_25);
        float _S333 = integral_on_top_0(family_15, own_1, other_2, uint((kernelContext_25->families_0+crossing_1)->count_0), quantity_2, kernelContext_25);
        float _S334 = _S332.x;
        float _S335 = _S334 * _S331.x;
        float _S336;
        if(back_5)
        {
            _S336 = _S335 - _S333;
        }
        else
        {
            _S336 = _S333;
        }
        bool _S337 = quantity_2 == 0U;
        if(_S337)
        {
            is_exposed_0 = _S336 > (16.0f * (kernelContext_25->families_0+family_15)->area_unit_0 * min(_S335 / (kernelContext_25->families_0+family_15)->crossing_area_0, 1.0f) + 0.00000999999974738f * _S335);
        }
        float _S338 = _S334 * _S331.y;
        float _S339;
        if(is_exposed_0)
        {
            _S339 = _S336;
        }
        else
        {
            _S339 = 0.0f;
        }
        float _S340 = _S338 + _S339 + 0.000244140625f * _S331.z * _S332.y;
        if(_S337)
        {
            weight_4 = 1.0f / max(_S340, 9.99999968265522539e-21f);
        }
        else
        {
            float _S341 = _S340 * weight_4;
            uint _S342 = (kernelContext_25->families_0+family_15)->colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S343 = albedos_2;
            Albedos_0 _S344 = with_added_albedos_0(&_S343, _S341, _S342, kernelContext_25);
            albedos_2 = _S344;
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
    float3 _S345 = float3(weight_5) ;
    (&albedos_3)->diffuse_reflect_0 = mix(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S345);
    (&albedos_3)->diffuse_transmit_0 = mix(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S345);
    (&albedos_3)->specular_reflect_0 = mix(first_2->specular_reflect_0, second_1->specular_reflect_0, _S345);
    (&albedos_3)->specular_transmit_0 = mix(first_2->specular_transmit_0, second_1->specular_transmit_0, _S345);
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
    float3 _S346 = float3((1.0f - open_of_other_0))  * passed_0;
    thread FaceRadiance_0 found_0;
    float3 _S347 = sends_0->sky_warp_0 + _S346 * sends_0->crossing_warp_0;
    (&found_0)->warp_3 = _S347;
    float3 _S348 = sends_0->sky_weft_0 + _S346 * sends_0->crossing_weft_0;
    (&found_0)->weft_3 = _S348;
    (&found_0)->mean_0 = float3(sends_0->blocks_warp_0)  * _S347 + float3(sends_0->blocks_weft_0)  * _S348;
    (&found_0)->leaked_0 = from_other_0;
    return found_0;
}

void view_terms_0(float3 view_7, array<float, int(6)> thread* terms_0)
{
    float _S349 = 1.0f - view_7.z;
    float _S350 = _S349 * _S349;
    (*terms_0)[int(0)] = 1.0f;
    float _S351 = view_7.x;
    float _S352 = _S351 * _S351;
    float _S353 = view_7.y;
    float _S354 = _S353 * _S353;
    (*terms_0)[int(1)] = sqrt(max(_S352 + _S354, 9.999999960041972e-13f));
    (*terms_0)[int(2)] = _S350;
    (*terms_0)[int(3)] = _S350 * _S350;
    (*terms_0)[int(4)] = _S352 - _S354;
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
    float3 back_6;
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
    float3 _S355 = float3((blocked_1->by_warp_0 + blocked_1->by_weft_0))  * interior_0->leaked_1;
    float3 _S356 = float3(blocked_1->far_0)  * yarn_2->through_0;
    thread Bounced_0 bounced_0;
    (&bounced_0)->reflected_0 = yarn_2->back_6 * (float3(blocked_1->by_warp_0)  * interior_0->warp_4 + float3(blocked_1->by_weft_0)  * interior_0->weft_4) + _S356 * interior_0->far_leaked_0;
    (&bounced_0)->transmitted_0 = _S356 * interior_0->far_1 + yarn_2->back_6 * _S355;
    return bounced_0;
}

Bounced_0 sum_of_0(const Bounced_0 thread* first_3, const Bounced_0 thread* second_2)
{
    thread Bounced_0 sum_1;
    (&sum_1)->reflected_0 = first_3->reflected_0 + second_2->reflected_0;
    (&sum_1)->transmitted_0 = first_3->transmitted_0 + second_2->transmitted_0;
    return sum_1;
}

float3 bounced_value_0(const Bounced_0 thread* bounced_1, float3 light_8, float3 view_8)
{
    float _S357 = light_8.z;
    float3 _S358;
    if((_S357 * view_8.z) < 0.0f)
    {
        _S358 = bounced_1->transmitted_0;
    }
    else
    {
        _S358 = bounced_1->reflected_0;
    }
    return _S358 * float3((abs(_S357) * 0.31830987334251404f)) ;
}

float sheen_scale_0(float x_8, float y_2)
{
    return (((((0.0f * x_8 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_8 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_8 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_8 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_8 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_8 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_9, float y_3)
{
    return ((((0.0f * x_9 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_9 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_9 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_9 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_9 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_10, float y_4)
{
    return ((((0.0f * x_10 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_10 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_10 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_10 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_10 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S359 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S360 = 2.0f * sqrt(_S359) - 1.0f;
    float _S361 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S360, _S361), 0.00999999977648258f, 1.0f), clamp((1.0f - _S359) * sheen_shear_0(_S360, _S361), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S360, _S361), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_9, float3 view_9, float scale_0, float shear_0)
{
    float _S362 = light_9.z;
    bool _S363;
    if(_S362 <= 0.0f)
    {
        _S363 = true;
    }
    else
    {
        _S363 = (view_9.z) <= 0.0f;
    }
    if(_S363)
    {
        return 0.0f;
    }
    float2 _S364 = view_9.xy;
    float _S365 = dot(_S364, _S364);
    float2 _S366;
    if(_S365 > 9.99999968265522539e-21f)
    {
        _S366 = _S364 * float2(rsqrt(_S365)) ;
    }
    else
    {
        _S366 = float2(1.0f, 0.0f);
    }
    float _S367 = scale_0 * dot(light_9.xy, _S366) + shear_0 * _S362;
    float _S368 = scale_0 * (light_9.y * _S366.x - light_9.x * _S366.y);
    float _S369 = _S367 * _S367 + _S368 * _S368 + _S362 * _S362;
    return 0.31830987334251404f * scale_0 * scale_0 * _S362 / max(_S369 * _S369, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_10, float3 view_10, float strength_0, float roughness_9)
{
    float3 _S370 = sheen_lobe_0(view_10.z, roughness_9);
    float _S371 = strength_0 * _S370.z;
    return float2(_S371 * transformed_cosine_0(light_10, view_10, _S370.x, _S370.y), 1.0f - _S371);
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

Regime_0 regime_of_0(uint _S372, const Footprint_0 thread* _S373, float _S374, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S375 = kernelContext_26->fabrics_0+_S372;
    float _S376 = Footprint_spread_side_0(_S373);
    float _S377 = clamp((binary_logarithm_0(max(_S376, 9.99999971718068537e-10f)) - _S375->lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    thread Regime_0 regime_0;
    float _S378 = _S377 * _S377 * (3.0f - 2.0f * _S377);
    (&regime_0)->prefiltered_0 = _S378;
    (&regime_0)->threads_1 = _S376 * _S375->lobes_0.threads_per_mm_0;
    float _S379 = mix(max(8.0f / _S374, 1.0f), 1.0f, _S378);
    float _S380;
    if(_S378 < 1.0f)
    {
        _S380 = clamp((&regime_0)->threads_1 * 12.0f, 1.0f, _S379);
    }
    else
    {
        _S380 = 0.0f;
    }
    (&regime_0)->points_0 = _S380;
    return regime_0;
}

bool varies_at_0(uint _S381, float _S382, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S383 = kernelContext_27->fabrics_0+_S381;
    bool _S384;
    if((_S383->fibre_noise_0) > 0.0f)
    {
        _S384 = true;
    }
    else
    {
        _S384 = (_S383->colour_noise_0) > 0.0f;
    }
    if(_S384)
    {
        _S384 = true;
    }
    else
    {
        if((_S383->has_detail_0) != 0U)
        {
            _S384 = _S382 >= 0.0f;
        }
        else
        {
            _S384 = false;
        }
    }
    return _S384;
}

struct Hit_0
{
    float x_11;
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

Crossing_0 crossing_at_0(uint _S385, float _S386, float _S387, bool _S388, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S389 = kernelContext_28->fabrics_0+_S385;
    thread Crossing_0 crossing_3;
    Cell_0 _S390 = locate_0(_S389->warp_1, _S386, kernelContext_28);
    (&crossing_3)->warp_2 = _S390;
    Cell_0 _S391 = locate_0(_S389->weft_1, _S387, kernelContext_28);
    (&crossing_3)->weft_2 = _S391;
    uint _S392 = _S389->run_words_0 + 2U * ((&(&crossing_3)->weft_2)->thread_0 * _S389->ends_1 + (&(&crossing_3)->warp_2)->thread_0);
    uint _S393 = kernelContext_28->words_0[_S392];
    (&crossing_3)->warp_word_0 = _S393;
    (&crossing_3)->weft_word_0 = kernelContext_28->words_0[_S392 + 1U];
    (&crossing_3)->warp_above_0 = ((_S393 & 1U) == 1U) != _S388;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S394, float _S395, float _S396, bool _S397, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S398 = kernelContext_29->fabrics_0+_S394;
    thread Sample_0 sample_0;
    Crossing_0 _S399 = crossing_at_0(_S394, _S395, _S396, _S397, kernelContext_29);
    (&sample_0)->crossing_2 = _S399;
    thread Crossing_0 _S400 = _S399;
    Shown_0 _S401 = shown_at_0(&_S400, _S397);
    (&sample_0)->shown_3 = _S401;
    uint _S402;
    if(_S401.is_warp_2)
    {
        _S402 = _S398->warp_1;
    }
    else
    {
        _S402 = _S398->weft_1;
    }
    uint _S403;
    if(_S401.is_warp_2)
    {
        _S403 = _S398->weft_1;
    }
    else
    {
        _S403 = _S398->warp_1;
    }
    thread Cell_0 _S404 = (&(&sample_0)->crossing_2)->warp_2;
    thread Cell_0 _S405 = (&(&sample_0)->crossing_2)->weft_2;
    Cell_0 _S406 = select_cell_0(_S401.is_warp_2, &_S404, &_S405);
    thread Cell_0 _S407 = (&(&sample_0)->crossing_2)->weft_2;
    thread Cell_0 _S408 = (&(&sample_0)->crossing_2)->warp_2;
    Cell_0 _S409 = select_cell_0(_S401.is_warp_2, &_S407, &_S408);
    thread Cell_0 _S410 = _S409;
    Run_0 _S411 = unpack_0(_S402, _S403, _S406.thread_0, &_S410, _S401.word_0, kernelContext_29);
    thread Cell_0 _S412 = _S406;
    Section_0 _S413 = section_at_0(&_S412);
    bool _S414;
    if(_S401.on_top_0)
    {
        _S414 = (_S411.distance_0) < (_S413.drop_0 * _S411.bend_1.sine_0);
    }
    else
    {
        _S414 = false;
    }
    bool _S415;
    if(_S401.on_top_0)
    {
        _S415 = !_S414;
    }
    else
    {
        _S415 = false;
    }
    float _S416;
    if(_S415)
    {
        _S416 = 1.0f;
    }
    else
    {
        _S416 = -1.0f;
    }
    float _S417;
    if(_S414)
    {
        _S417 = _S411.other_reach_0;
    }
    else
    {
        _S417 = _S411.reach_0;
    }
    float _S418;
    if(_S414)
    {
        _S418 = _S417 + _S411.distance_0;
    }
    else
    {
        _S418 = max(_S417 - _S411.distance_0, 0.0f);
    }
    float _S419 = _S417 / _S411.bend_1.sine_0 - _S416 * _S413.drop_0;
    float _S420 = _S418 * _S418;
    float _S421 = max(_S419 * _S419 - _S420, 9.99999968265522539e-21f);
    float _S422 = rsqrt(_S421);
    float _S423 = _S420 / (_S421 * _S422 + _S419);
    bool _S424 = _S418 > 0.0f;
    float _S425;
    if(_S401.on_top_0)
    {
        _S425 = 1.0f;
    }
    else
    {
        _S425 = -1.0f;
    }
    float _S426;
    if(_S411.near_start_0)
    {
        _S426 = 1.0f;
    }
    else
    {
        _S426 = -1.0f;
    }
    float _S427 = _S425 * _S426;
    if(_S424)
    {
        _S425 = _S419 * _S422;
    }
    else
    {
        _S425 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S413.slope_0 * _S425;
    if(_S424)
    {
        _S418 = _S427 * _S418 * _S422;
    }
    else
    {
        _S418 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S418;
    float _S428 = (kernelContext_29->families_0+_S402)->height_scale_0;
    thread Shown_0 _S429 = _S401;
    thread Run_0 _S430 = _S411;
    thread Cell_0 _S431 = _S409;
    float2 _S432 = dive_0(_S403, &_S429, &_S430, &_S431, kernelContext_29);
    if(_S411.straight_0)
    {
        _S416 = 0.0f;
    }
    else
    {
        _S416 = _S428 * _S416;
    }
    (&sample_0)->height_6 = _S416 * (_S417 * _S411.bend_1.half_tangent_0 - _S423) - _S428 * _S413.drop_0 - _S432.x;
    float _S433 = _S428 * (&sample_0)->slope_across_0;
    float _S434 = _S428 * (&sample_0)->slope_along_0 - _S432.y;
    if(_S401.is_warp_2)
    {
        _S416 = _S433;
    }
    else
    {
        _S416 = _S434;
    }
    (&sample_0)->slope_x_1 = _S416;
    if(_S401.is_warp_2)
    {
        _S416 = _S434;
    }
    else
    {
        _S416 = _S433;
    }
    (&sample_0)->slope_y_1 = _S416;
    (&sample_0)->run_3 = _S411;
    (&sample_0)->section_1 = _S413;
    return sample_0;
}

float steps_per_length_0(uint _S435, const SearchQuality_0 thread* _S436, float3 _S437, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S438 = kernelContext_30->fabrics_0+_S435;
    return max(max(abs(_S437.x) * _S438->threads_per_x_0, abs(_S437.y) * _S438->threads_per_y_0) * _S436->steps_per_thread_0, abs(_S437.z) * _S438->per_relief_0 * _S436->steps_per_relief_0);
}

float cell_maximum_0(uint _S439, const Crossing_0 thread* _S440, KernelContext_0 thread* kernelContext_31)
{
    Fabric_0 device* _S441 = kernelContext_31->fabrics_0+_S439;
    bool _S442 = _S440->warp_above_0;
    uint _S443;
    if(_S440->warp_above_0)
    {
        _S443 = _S441->warp_1;
    }
    else
    {
        _S443 = _S441->weft_1;
    }
    uint _S444;
    if(_S442)
    {
        _S444 = _S440->warp_word_0;
    }
    else
    {
        _S444 = _S440->weft_word_0;
    }
    return float(_S444 >> 28U) * (kernelContext_31->families_0+_S443)->height_scale_0 * (kernelContext_31->families_0+_S443)->level_0;
}

Probe_0 probe_0(uint _S445, float _S446, float _S447, bool _S448, bool _S449, bool _S450, KernelContext_0 thread* kernelContext_32)
{
    Sample_0 _S451 = sample_at_0(_S445, _S446, _S447, _S448, kernelContext_32);
    thread Probe_0 probe_1;
    (&probe_1)->height_3 = _S451.height_6;
    (&probe_1)->hole_4 = _S451.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S451.slope_x_1;
    (&probe_1)->slope_y_0 = _S451.slope_y_1;
    uint _S452;
    if(_S451.shown_3.is_warp_2)
    {
        _S452 = _S451.crossing_2.warp_2.thread_0 * 2U + 1U;
    }
    else
    {
        _S452 = _S451.crossing_2.weft_2.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S452;
    thread Crossing_0 _S453 = _S451.crossing_2;
    float _S454 = cell_maximum_0(_S445, &_S453, kernelContext_32);
    (&probe_1)->cell_max_0 = _S454;
    float _S455;
    if(_S449)
    {
        _S455 = _S451.crossing_2.warp_2.above_0;
    }
    else
    {
        _S455 = _S451.crossing_2.warp_2.below_0;
    }
    (&probe_1)->side_x_0 = _S455;
    if(_S450)
    {
        _S455 = _S451.crossing_2.weft_2.above_0;
    }
    else
    {
        _S455 = _S451.crossing_2.weft_2.below_0;
    }
    (&probe_1)->side_y_0 = _S455;
    bool _S456 = !_S451.shown_3.is_warp_2;
    thread Cell_0 _S457 = _S451.crossing_2.warp_2;
    thread Shown_0 _S458 = _S451.shown_3;
    thread Run_0 _S459 = _S451.run_3;
    float _S460 = outline_distance_0(&_S457, &_S458, &_S459, _S456, _S449);
    (&probe_1)->edge_x_0 = _S460;
    thread Cell_0 _S461 = _S451.crossing_2.weft_2;
    thread Shown_0 _S462 = _S451.shown_3;
    thread Run_0 _S463 = _S451.run_3;
    float _S464 = outline_distance_0(&_S461, &_S462, &_S463, _S451.shown_3.is_warp_2, _S450);
    (&probe_1)->edge_y_0 = _S464;
    return probe_1;
}

bool is_free_0(uint _S465, const SearchQuality_0 thread* _S466, float3 _S467, float3 _S468, bool _S469, float _S470, KernelContext_0 thread* kernelContext_33)
{
    float _S471 = _S468.z;
    if(_S471 <= 0.0f)
    {
        return false;
    }
    float _S472 = _S466->shadow_share_0;
    float _S473 = steps_per_length_0(_S465, _S466, _S468, kernelContext_33);
    float _S474 = 1.0f / max(_S472 * _S473, 9.99999971718068537e-10f);
    StepControl_0 _S475 = step_control_0(_S468.xy, _S474);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S476;
        if(count_3 < 1024U)
        {
            _S476 = (_S467.z + _S471 * distance_1) < _S470;
        }
        else
        {
            _S476 = false;
        }
        if(_S476)
        {
        }
        else
        {
            break;
        }
        float3 _S477 = _S467 + _S468 * float3(distance_1) ;
        Probe_0 _S478 = probe_0(_S465, _S477.x, _S477.y, _S469, _S475.right_0, _S475.up_0, kernelContext_33);
        float _S479 = _S477.z;
        float _S480 = _S479 - _S478.height_3;
        float _S481 = _S471 - _S478.slope_x_0 * _S468.x - _S478.slope_y_0 * _S468.y;
        bool _S482;
        if(!_S478.hole_4)
        {
            _S482 = _S480 < 0.0f;
        }
        else
        {
            _S482 = false;
        }
        if(_S482)
        {
            return false;
        }
        thread PreviousSample_0 _S483 = previous_3;
        thread Probe_0 _S484 = _S478;
        float _S485 = way_back_to_dip_0(&_S483, _S480, _S481, last_step_0, &_S484);
        if(_S485 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S485;
            distance_1 = distance_1 - _S485;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S486 = _S479 > (_S478.cell_max_0);
        thread Probe_0 _S487 = _S478;
        PreviousSample_0 _S488 = after_sample_0(_S480, _S481, &_S487, _S486);
        float last_step_2;
        if(_S486)
        {
            thread StepControl_0 _S489 = _S475;
            float _S490 = StepControl_to_cell_exit_0(&_S489, _S478.side_x_0, _S478.side_y_0);
            last_step_2 = max(_S490, _S474);
        }
        else
        {
            thread StepControl_0 _S491 = _S475;
            thread Probe_0 _S492 = _S478;
            float _S493 = StepControl_to_next_sample_0(&_S491, &_S492, _S480, _S481);
            last_step_2 = _S493;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S488;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S494, const SearchQuality_0 thread* _S495, float _S496, float _S497, float3 _S498, bool _S499, KernelContext_0 thread* kernelContext_34)
{
    Fabric_0 device* _S500 = kernelContext_34->fabrics_0+_S494;
    Sample_0 _S501 = sample_at_0(_S494, _S496, _S497, _S499, kernelContext_34);
    if(!_S501.shown_3.hole_3)
    {
        return false;
    }
    float3 _S502 = float3(_S496, _S497, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S503;
        if(side_0 < 2U)
        {
            _S503 = passes_0;
        }
        else
        {
            _S503 = false;
        }
        if(_S503)
        {
        }
        else
        {
            break;
        }
        float3 _S504;
        if(side_0 == 0U)
        {
            _S504 = _S498;
        }
        else
        {
            _S504 = float3(- _S498.x, - _S498.y, _S498.z);
        }
        bool _S505 = is_free_0(_S494, _S495, _S502, _S504, _S499 != (side_0 == 1U), _S500->height_high_0, kernelContext_34);
        uint _S506 = side_0 + 1U;
        passes_0 = _S505;
        side_0 = _S506;
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

float max_height_along_0(uint _S507, float _S508, float _S509, float _S510, float3 _S511, bool _S512, KernelContext_0 thread* kernelContext_35)
{
    Fabric_0 device* _S513 = kernelContext_35->fabrics_0+_S507;
    Cell_0 _S514 = locate_0(_S513->warp_1, _S508, kernelContext_35);
    uint _S515 = _S514.thread_0 / 2U;
    Cell_0 _S516 = locate_0(_S513->weft_1, _S509, kernelContext_35);
    uint _S517 = _S516.thread_0 / 2U;
    float _S518 = _S511.x;
    uint _S519;
    if(_S518 > 0.0f)
    {
        _S519 = 1U;
    }
    else
    {
        _S519 = 0U;
    }
    float _S520 = _S511.y;
    uint _S521;
    if(_S520 > 0.0f)
    {
        _S521 = 2U;
    }
    else
    {
        _S521 = 0U;
    }
    uint _S522 = kernelContext_35->words_0[_S513->max_heights_0 + 4U * (_S517 * _S513->max_height_columns_0 + _S515) + (_S519 + _S521)];
    int number_0;
    if(_S512)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S523 = _S522 >> uint(number_0);
    float _S524 = max(abs(_S518) * _S513->threads_per_x_0, abs(_S520) * _S513->threads_per_y_0) / _S511.z;
    float _S525 = _S513->height_high_0;
    float max_height_0 = _S513->height_high_0;
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
        if(((max_height_0 - _S510) * _S524) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S523 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S525);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S526, float _S527, float _S528, bool _S529, bool _S530, bool _S531, KernelContext_0 thread* kernelContext_36)
{
    Crossing_0 _S532 = crossing_at_0(_S526, _S527, _S528, _S529, kernelContext_36);
    thread Crossing_0 _S533 = _S532;
    float _S534 = cell_maximum_0(_S526, &_S533, kernelContext_36);
    float _S535;
    if(_S530)
    {
        _S535 = _S532.warp_2.above_0;
    }
    else
    {
        _S535 = _S532.warp_2.below_0;
    }
    float _S536;
    if(_S531)
    {
        _S536 = _S532.weft_2.above_0;
    }
    else
    {
        _S536 = _S532.weft_2.below_0;
    }
    return float3(_S534, _S535, _S536);
}

float first_sample_height_0(uint _S537, const ViewRay_0 thread* _S538, const StepControl_0 thread* _S539, bool _S540, KernelContext_0 thread* kernelContext_37)
{
    float _S541 = max_height_along_0(_S537, _S538->origin_0.x, _S538->origin_0.y, 0.0f, float3(_S538->slope_1, 1.0f), _S540, kernelContext_37);
    uint count_4 = 0U;
    float height_8 = _S541;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S542 = ViewRay_at_0(_S538, height_8);
        float3 _S543 = cell_bounds_0(_S537, _S542.x, _S542.y, _S540, _S539->right_0, _S539->up_0, kernelContext_37);
        float _S544 = height_8 - _S543.x;
        float _S545 = StepControl_to_cell_exit_0(_S539, _S543.y, _S543.z);
        float height_9 = height_8 - clamp(_S544, 0.0f, _S545);
        if(_S544 <= _S545)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S546, const ViewRay_0 thread* _S547, const StepControl_0 thread* _S548, bool _S549, KernelContext_0 thread* kernelContext_38)
{
    Fabric_0 device* _S550 = kernelContext_38->fabrics_0+_S546;
    float _S551 = _S550->height_low_0 - (_S550->height_high_0 - _S550->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S552 = first_sample_height_0(_S546, _S547, _S548, _S549, kernelContext_38);
    (&end_1)->height_7 = _S552;
    (&end_1)->last_step_3 = _S548->epsilon_0;
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
        float2 _S553 = ViewRay_at_0(_S547, (&end_1)->height_7);
        Probe_0 _S554 = probe_0(_S546, _S553.x, _S553.y, _S549, _S548->right_0, _S548->up_0, kernelContext_38);
        float _S555 = (&end_1)->height_7 - _S554.height_3;
        thread Probe_0 _S556 = _S554;
        float _S557 = ViewRay_rate_0(_S547, &_S556);
        (&end_1)->depth_1 = - _S555;
        (&end_1)->rate_4 = _S557;
        bool _S558;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S558 = !_S554.hole_4;
        }
        else
        {
            _S558 = false;
        }
        bool _S559;
        if(_S558)
        {
            _S559 = ((&(&end_1)->previous_4)->yarn_0) == (_S554.yarn_1);
        }
        else
        {
            _S559 = false;
        }
        (&end_1)->smooth_0 = _S559;
        bool _S560;
        if(!_S554.hole_4)
        {
            _S560 = _S555 <= 0.0f;
        }
        else
        {
            _S560 = false;
        }
        bool _S561;
        if(_S560)
        {
            _S561 = true;
        }
        else
        {
            _S561 = ((&end_1)->height_7) <= _S551;
        }
        if(_S561)
        {
            break;
        }
        thread PreviousSample_0 _S562 = (&end_1)->previous_4;
        thread Probe_0 _S563 = _S554;
        float _S564 = way_back_to_dip_0(&_S562, _S555, _S557, (&end_1)->last_step_3, &_S563);
        if(_S564 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S564;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S564;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S565 = StepControl_to_cell_exit_0(_S548, _S554.side_x_0, _S554.side_y_0);
        float _S566 = min(_S565, (&end_1)->height_7 - _S554.cell_max_0);
        thread Probe_0 _S567 = _S554;
        float _S568 = StepControl_to_next_sample_0(_S548, &_S567, _S555, _S557);
        bool _S569 = _S566 > _S568;
        thread Probe_0 _S570 = _S554;
        PreviousSample_0 _S571 = after_sample_0(_S555, _S557, &_S570, _S569);
        (&end_1)->previous_4 = _S571;
        float _S572 = max(_S566, _S568);
        (&end_1)->last_step_3 = _S572;
        (&end_1)->height_7 = (&end_1)->height_7 - _S572;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S573, const ViewRay_0 thread* _S574, const StepControl_0 thread* _S575, bool _S576, const ViewRayEnd_0 thread* _S577, uint _S578, KernelContext_0 thread* kernelContext_39)
{
    Fabric_0 device* _S579 = kernelContext_39->fabrics_0+_S573;
    float _S580 = _S579->height_high_0 - _S579->height_low_0;
    float _S581 = _S577->height_7;
    float _S582 = _S577->last_step_3;
    float above_2 = _S577->height_7 + _S577->last_step_3;
    float above_gap_1 = clamp((&_S577->previous_4)->clearance_0, 0.0f, _S580);
    float under_gap_1 = clamp(_S577->depth_1, 0.0f, _S580);
    float _S583 = cubic_root_0(above_gap_1, - under_gap_1, (&_S577->previous_4)->rate_0 * _S577->last_step_3, _S577->rate_4 * _S577->last_step_3);
    bool _S584 = _S577->smooth_0;
    float middle_0;
    if(_S577->smooth_0)
    {
        middle_0 = above_2 - _S583 * _S582;
    }
    else
    {
        middle_0 = between_0(above_2, _S581, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S581;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S578)
        {
        }
        else
        {
            break;
        }
        float2 _S585 = ViewRay_at_0(_S574, middle_0);
        Probe_0 _S586 = probe_0(_S573, _S585.x, _S585.y, _S576, _S575->right_0, _S575->up_0, kernelContext_39);
        float _S587;
        if(_S586.hole_4)
        {
            _S587 = -1.0e+09f;
        }
        else
        {
            _S587 = _S586.height_3;
        }
        float _S588 = clamp(middle_0 - _S587, - _S580, _S580);
        float _S589;
        if(_S588 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S589 = 0.5f * above_gap_2;
            }
            else
            {
                _S589 = above_gap_2;
            }
            float _S590 = - _S588;
            under_1 = middle_0;
            above_gap_2 = _S589;
            under_gap_2 = _S590;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S589 = 0.5f * under_gap_2;
            }
            else
            {
                _S589 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S588;
            under_gap_2 = _S589;
            side_1 = -1.0f;
        }
        if(_S584)
        {
            thread Probe_0 _S591 = _S586;
            float _S592 = ViewRay_rate_0(_S574, &_S591);
            middle_0 = clamp(middle_0 + _S588 / min(_S592, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S584)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S593, const SearchQuality_0 thread* _S594, float _S595, float _S596, float3 _S597, bool _S598, KernelContext_0 thread* kernelContext_40)
{
    float _S599 = max(_S597.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S595, _S596);
    float2 _S600 = _S597.xy / float2(_S599) ;
    (&ray_0)->slope_1 = _S600;
    float2 _S601 = - _S600;
    float _S602 = steps_per_length_0(_S593, _S594, _S597, kernelContext_40);
    StepControl_0 _S603 = step_control_0(_S601, 1.0f / max(_S602 / _S599, 9.99999971718068537e-10f));
    thread ViewRay_0 _S604 = ray_0;
    thread StepControl_0 _S605 = _S603;
    ViewRayEnd_0 _S606 = search_down_0(_S593, &_S604, &_S605, _S598, kernelContext_40);
    thread Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    thread ViewRay_0 _S607 = ray_0;
    thread StepControl_0 _S608 = _S603;
    thread ViewRayEnd_0 _S609 = _S606;
    float _S610 = refined_height_0(_S593, &_S607, &_S608, _S598, &_S609, _S594->refinements_0, kernelContext_40);
    (&hit_0)->height_5 = _S610;
    thread ViewRay_0 _S611 = ray_0;
    float2 _S612 = ViewRay_at_0(&_S611, _S610);
    (&hit_0)->x_11 = _S612.x;
    (&hit_0)->y_5 = _S612.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S613, const SearchQuality_0 thread* _S614, float _S615, float _S616, float3 _S617, bool _S618, KernelContext_0 thread* kernelContext_41)
{
    bool _S619 = passes_through_0(_S613, _S614, _S615, _S616, _S617, _S618, kernelContext_41);
    if(!_S619)
    {
        Hit_0 _S620 = first_hit_of_yarn_0(_S613, _S614, _S615, _S616, _S617, _S618, kernelContext_41);
        return _S620;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_11 = _S615;
    (&hit_1)->y_5 = _S616;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S621, float _S622, float _S623, bool _S624, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S625 = kernelContext_42->fabrics_0+_S621;
    Sample_0 _S626 = sample_at_0(_S621, _S622, _S623, _S624, kernelContext_42);
    float _S627;
    if(_S626.shown_3.is_warp_2)
    {
        _S627 = _S626.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S627 = _S626.crossing_2.weft_2.half_width_1;
    }
    uint _S628;
    if(_S626.shown_3.is_warp_2)
    {
        _S628 = _S625->warp_1;
    }
    else
    {
        _S628 = _S625->weft_1;
    }
    float _S629 = (kernelContext_42->families_0+_S628)->twist_sine_0;
    float _S630;
    if(_S624)
    {
        _S630 = -1.0f;
    }
    else
    {
        _S630 = 1.0f;
    }
    float _S631 = _S629 * _S630;
    float _S632 = (kernelContext_42->families_0+_S628)->twist_cosine_0;
    if(_S626.shown_3.is_warp_2)
    {
        _S630 = 1.0f;
    }
    else
    {
        _S630 = -1.0f;
    }
    float2 _S633 = fibre_direction_0(_S626.slope_across_0, _S630 * _S626.slope_along_0, _S631, _S632);
    float _S634;
    if(_S626.shown_3.is_warp_2)
    {
        _S634 = _S626.slope_x_1;
    }
    else
    {
        _S634 = _S626.slope_y_1;
    }
    float _S635;
    if(_S626.shown_3.is_warp_2)
    {
        _S635 = _S626.slope_y_1;
    }
    else
    {
        _S635 = _S626.slope_x_1;
    }
    float _S636 = _S633.x;
    float _S637 = _S633.y;
    float _S638 = _S634 * _S636 + _S630 * _S635 * _S637;
    float _S639 = _S627 * 1.0154266357421875f;
    float _S640 = _S639 * arc_sine_0(clamp(_S626.section_1.across_3 / _S639, -1.0f, 1.0f));
    if(_S626.shown_3.is_warp_2)
    {
        _S627 = _S623;
    }
    else
    {
        _S627 = - _S622;
    }
    thread SurfacePoint_0 point_1;
    (&point_1)->hole_0 = _S626.shown_3.hole_3;
    (&point_1)->is_warp_0 = _S626.shown_3.is_warp_2;
    (&point_1)->warp_thread_0 = _S626.crossing_2.warp_2.thread_0;
    (&point_1)->weft_thread_0 = _S626.crossing_2.weft_2.thread_0;
    (&point_1)->height_0 = _S626.height_6;
    (&point_1)->normal_0 = normalize(float3(- _S626.slope_x_1, - _S626.slope_y_1, 1.0f));
    float3 _S641;
    if(_S626.shown_3.is_warp_2)
    {
        _S641 = float3(_S636, _S637, _S638);
    }
    else
    {
        _S641 = float3(- _S637, _S636, _S638);
    }
    (&point_1)->tangent_0 = normalize(_S641);
    (&point_1)->across_0 = _S626.section_1.across_3;
    (&point_1)->fibre_across_0 = _S640 * _S632 + _S627 * _S631;
    (&point_1)->fibre_along_0 = _S627 * _S632 - _S640 * _S631;
    return point_1;
}

struct YarnPoint_0
{
    bool back_7;
    bool hole_6;
    bool is_warp_3;
    float x_12;
    float y_6;
    float height_10;
    float3 normal_9;
    float3 tangent_10;
    float3 surface_normal_0;
    float diffuse_gain_1;
    float roughness_10;
    Albedos_0 albedos_6;
};

bool has_hairs_0(uint _S642, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S643 = kernelContext_43->fabrics_0+_S642;
    bool _S644;
    if(((kernelContext_43->families_0+_S643->warp_1)->hairiness_0) > 0.0f)
    {
        _S644 = true;
    }
    else
    {
        _S644 = ((kernelContext_43->families_0+_S643->weft_1)->hairiness_0) > 0.0f;
    }
    return _S644;
}

Hair_0 hair_at_0(uint _S645, float2 _S646, bool _S647, float _S648, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S649 = kernelContext_44->fabrics_0+_S645;
    float _S650 = _S649->fibre_size_0;
    float _S651 = 17.0f * _S649->fibre_size_0;
    float _S652 = fade_0(_S648, _S651);
    float2 _S653 = _S646 / float2(_S651) ;
    uint number_1;
    if(_S647)
    {
        number_1 = 1U;
    }
    else
    {
        number_1 = 0U;
    }
    uint _S654 = hash_key_0(number_1, (_S649->seed_1) ^ 1013904242U);
    float _S655 = 1.0f / max(_S648, 0.07999999821186066f * _S650);
    float _S656 = min(0.63999998569488525f * _S650 * _S655, 1.0f);
    float2 _S657 = float2(0.0f, 1.0f);
    float cover_2 = 0.0f;
    float hair_away_0 = 0.0f;
    float2 hair_across_0 = _S657;
    number_1 = 0U;
    for(;;)
    {
        bool _S658;
        if(_S652 > 0.0f)
        {
            _S658 = number_1 < 18U;
        }
        else
        {
            _S658 = false;
        }
        if(_S658)
        {
        }
        else
        {
            break;
        }
        uint _S659 = number_1 / 9U;
        uint _S660 = number_1 / 3U - 3U * _S659;
        float2 _S661 = floor(_S653) + float2(float(number_1 - 3U * _S660 - 9U * _S659), float(_S660)) - float2(1.0f) ;
        uint _S662 = hash_bits_0(_S654 + _S659, uint(int(_S661.x)) * 65536U + uint(int(_S661.y)));
        uint _S663 = hash_bits_0(_S654, _S662);
        float2 _S664 = _S653 - _S661 - float2(share_of_0(_S662), share_of_0(_S662 >> 10U));
        float2 _S665 = sine_cosine_0(3.14159274101257324f * share_of_0(_S662 >> 20U));
        float _S666 = mix(5.0f, 16.0f, share_of_0(_S663 >> 10U)) / 17.0f;
        float _S667 = _S664.x;
        float _S668 = _S665.y;
        float _S669 = _S664.y;
        float _S670 = _S665.x;
        float _S671 = (_S667 * _S668 + _S669 * _S670) / _S666;
        float _S672 = 0.69999998807907104f * (2.0f * share_of_0(_S663 >> 20U) - 1.0f);
        float _S673 = 2.0f * _S672 * _S671;
        float _S674 = rsqrt(_S673 * _S673 + 1.0f);
        float _S675 = (_S669 * _S668 - _S667 * _S670 - _S672 * _S666 * _S671 * _S671) * _S674 * 17.0f;
        float _S676 = clamp((0.31999999284744263f - abs(_S675)) * _S650 * _S655 + 0.5f, 0.0f, _S656);
        uint _S677;
        if(((_S663 >> 30U) & 1U) == 1U)
        {
            _S677 = _S649->warp_1;
        }
        else
        {
            _S677 = _S649->weft_1;
        }
        bool _S678;
        if((share_of_0(_S663)) < ((kernelContext_44->families_0+_S677)->hairiness_0))
        {
            _S678 = (abs(_S671)) < 1.0f;
        }
        else
        {
            _S678 = false;
        }
        bool _S679;
        if(_S678)
        {
            _S679 = _S676 > cover_2;
        }
        else
        {
            _S679 = false;
        }
        if(_S679)
        {
            float2 _S680 = float2(- _S670 - _S673 * _S668, _S668 - _S673 * _S670) * float2(_S674) ;
            cover_2 = _S676;
            hair_away_0 = _S675;
            hair_across_0 = _S680;
        }
        number_1 = number_1 + 1U;
    }
    float _S681 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    thread Hair_0 hair_1;
    (&hair_1)->cover_0 = _S652 * cover_2;
    (&hair_1)->normal_2 = float3(float2(_S681)  * hair_across_0, sqrt(1.0f - _S681 * _S681));
    (&hair_1)->tangent_2 = float3(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

uint thread_number_0(uint _S682, const SurfacePoint_0 thread* _S683, float _S684, float _S685, KernelContext_0 thread* kernelContext_45)
{
    Fabric_0 device* _S686 = kernelContext_45->fabrics_0+_S682;
    bool _S687 = _S683->is_warp_0;
    float _S688;
    if(_S683->is_warp_0)
    {
        _S688 = _S684;
    }
    else
    {
        _S688 = _S685;
    }
    float _S689 = _S688 - _S683->across_0;
    uint _S690;
    if(_S687)
    {
        _S690 = _S686->warp_1;
    }
    else
    {
        _S690 = _S686->weft_1;
    }
    float _S691 = (kernelContext_45->families_0+_S690)->period_0;
    int _S692 = int((kernelContext_45->families_0+_S690)->count_0);
    if(_S687)
    {
        _S690 = _S683->warp_thread_0;
    }
    else
    {
        _S690 = _S683->weft_thread_0;
    }
    uint _S693 = uint(int(floor(_S689 / _S691)) * _S692 + int(_S690)) * 2U;
    if(_S687)
    {
        _S690 = 1U;
    }
    else
    {
        _S690 = 0U;
    }
    return _S693 + _S690;
}

struct FibreNoise_0
{
    float2 bundle_0;
    float bundle_weight_0;
    float2 fibre_0;
    float fibre_weight_0;
    float offset_2;
    float slope_2;
};

FibreNoise_0 fibre_noise_at_0(uint _S694, uint _S695, const SurfacePoint_0 thread* _S696, uint _S697, float _S698, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S699 = kernelContext_46->fabrics_0+_S694;
    float _S700 = 5.0f * _S699->fibre_size_0;
    float2 _S701 = wave_noise_0(hash_key_0(_S697, (_S699->seed_1) ^ 458671337U), _S696->fibre_along_0 / (25.0f * _S699->fibre_size_0));
    float _S702 = _S696->fibre_across_0 + (kernelContext_46->families_0+_S695)->fibre_tilt_0 * 0.5f * 25.0f * _S699->fibre_size_0 * _S701.x;
    float3 _S703 = fibre_cell_0(_S702, _S696->fibre_along_0, _S699->fibre_size_0);
    thread FibreNoise_0 noise_0;
    (&noise_0)->bundle_0 = cell_noise_0(hash_key_0(_S697, (_S699->seed_1) ^ 1757159915U), fibre_cell_0(_S702, _S696->fibre_along_0, _S700));
    (&noise_0)->bundle_weight_0 = fade_0(_S698, _S700);
    (&noise_0)->fibre_0 = cell_noise_0(hash_key_0(_S697, (_S699->seed_1) ^ 48610963U), _S703);
    (&noise_0)->fibre_weight_0 = fade_0(_S698, _S699->fibre_size_0);
    (&noise_0)->offset_2 = _S703.z;
    (&noise_0)->slope_2 = 0.5f * _S701.y;
    return noise_0;
}

float2 detail_gain_0(uint _S704, uint _S705, const SurfacePoint_0 thread* _S706, float2 _S707, bool _S708, uint _S709, float _S710, KernelContext_0 thread* kernelContext_47)
{
    Fabric_0 device* _S711 = kernelContext_47->fabrics_0+_S704;
    float2 _S712 = float2(0.0f) ;
    float2 gain_1;
    if(((kernelContext_47->families_0+_S705)->has_plies_0) > 0.0f)
    {
        float _S713 = 0.60000002384185791f * fade_0(_S710, 1.0f / (kernelContext_47->families_0+_S705)->plies_per_mm_0);
        float _S714 = ply_offset_0(_S705, _S706, _S708, kernelContext_47);
        gain_1 = float2(_S713)  * float2(0.20000000298023224f - square_0(square_0(_S714)), 0.20000000298023224f);
    }
    else
    {
        gain_1 = _S712;
    }
    if(((kernelContext_47->families_0+_S705)->fibre_tone_0) > 0.0f)
    {
        FibreNoise_0 _S715 = fibre_noise_at_0(_S704, _S705, _S706, _S709, _S710, kernelContext_47);
        gain_1 = gain_1 + float2((kernelContext_47->families_0+_S705)->fibre_tone_0)  * float2(_S715.bundle_weight_0 * _S715.bundle_0.y + _S715.fibre_weight_0 * _S715.fibre_0.y, _S715.bundle_weight_0 + _S715.fibre_weight_0);
    }
    if(((kernelContext_47->families_0+_S705)->slub_0) > 0.0f)
    {
        float _S716 = 0.25f * (kernelContext_47->families_0+_S705)->slub_0 * fade_0(_S710, 1.0f / (kernelContext_47->families_0+_S705)->slubs_per_mm_0);
        float _S717;
        if(_S706->is_warp_0)
        {
            _S717 = _S707.y;
        }
        else
        {
            _S717 = - _S707.x;
        }
        gain_1 = gain_1 + float2(_S716)  * float2(wave_noise_0(hash_key_0(_S709, (_S711->seed_1) ^ 1373058189U), _S717 * (kernelContext_47->families_0+_S705)->slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_0(_S706->across_0 * (kernelContext_47->families_0+_S705)->per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_1;
}

Albedos_0 vary_albedos_0(uint _S718, const Albedos_0 thread* _S719, uint _S720, uint _S721, float2 _S722, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S723 = kernelContext_48->fabrics_0+_S718;
    float3 _S724 = max(_S719->specular_reflect_0, _S719->specular_transmit_0);
    float3 _S725 = _S719->diffuse_reflect_0 + _S719->diffuse_transmit_0;
    float3 _S726 = float3(_S723->layer_bound_0) ;
    float3 _S727 = float3(1.0f) ;
    float3 _S728 = _S727 - _S726 * _S724;
    float colour_0 = bounded_gain_0(thread_gain_0(_S720, _S723->colour_noise_0, _S723->seed_1), _S725, _S728);
    float3 _S729 = float3((colour_0 * (1.0f + flattened_0(_S722.y, float3(colour_0)  * _S725, _S728) * _S722.x))) ;
    float _S730 = bounded_gain_0(fibre_gain_0(_S720, _S721, _S723->fibre_noise_0, _S723->seed_1), _S724, min((_S727 - _S729 * _S725) / _S726, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S729 * _S719->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S729 * _S719->diffuse_transmit_0;
    float3 _S731 = float3(_S730) ;
    (&varied_0)->specular_reflect_0 = _S731 * _S719->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S731 * _S719->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S732, const SurfacePoint_0 thread* _S733, const Albedos_0 thread* _S734, float _S735, float _S736, bool _S737, float _S738, float _S739, KernelContext_0 thread* kernelContext_49)
{
    Fabric_0 device* _S740 = kernelContext_49->fabrics_0+_S732;
    uint _S741 = thread_number_0(_S732, _S733, _S735, _S736, kernelContext_49);
    float3 _S742 = fibre_cell_0(_S733->fibre_across_0, _S733->fibre_along_0, _S740->fibre_size_0);
    float2 _S743 = float2(0.0f) ;
    bool _S744;
    if((_S740->has_detail_0) != 0U)
    {
        _S744 = _S738 >= 0.0f;
    }
    else
    {
        _S744 = false;
    }
    float2 gain_2;
    if(_S744)
    {
        uint _S745;
        if(_S733->is_warp_0)
        {
            _S745 = _S740->warp_1;
        }
        else
        {
            _S745 = _S740->weft_1;
        }
        float2 _S746 = detail_gain_0(_S732, _S745, _S733, float2(_S735, _S736), _S737, _S741, _S738, kernelContext_49);
        gain_2 = _S746 * float2(1.0f - _S739, 1.0f);
    }
    else
    {
        gain_2 = _S743;
    }
    Albedos_0 _S747 = vary_albedos_0(_S732, _S734, _S741, uint(int(_S742.x)) * 65536U + uint(int(floor(_S742.y))), gain_2, kernelContext_49);
    return _S747;
}

YarnFrame_0 turned_frame_0(uint _S748, uint _S749, const SurfacePoint_0 thread* _S750, bool _S751, uint _S752, float _S753, KernelContext_0 thread* kernelContext_50)
{
    thread YarnFrame_0 frame_2;
    (&frame_2)->normal_4 = _S750->normal_0;
    (&frame_2)->tangent_4 = _S750->tangent_0;
    (&frame_2)->loss_0 = 0.0f;
    if(((kernelContext_50->families_0+_S749)->has_plies_0) > 0.0f)
    {
        float _S754 = fade_0(_S753, 1.0f / (kernelContext_50->families_0+_S749)->plies_per_mm_0);
        float _S755 = _S754 * 0.41999998688697815f;
        float _S756 = ply_offset_0(_S749, _S750, _S751, kernelContext_50);
        float _S757 = _S755 * _S756;
        float _S758 = sqrt(1.0f - _S757 * _S757);
        float _S759;
        if(_S751)
        {
            _S759 = - (kernelContext_50->families_0+_S749)->ply_sine_0;
        }
        else
        {
            _S759 = (kernelContext_50->families_0+_S749)->ply_sine_0;
        }
        float3 _S760 = cross((&frame_2)->tangent_4, (&frame_2)->normal_4);
        float3 _S761 = float3((kernelContext_50->families_0+_S749)->ply_cosine_0) ;
        float3 _S762 = _S761 * _S760 + float3(_S759)  * (&frame_2)->tangent_4;
        float3 _S763 = float3(_S758) ;
        float3 _S764 = float3(_S757) ;
        (&frame_2)->tangent_4 = _S761 * (_S761 * (&frame_2)->tangent_4 - float3(_S759)  * _S760) + float3(_S759)  * (_S763 * _S762 - _S764 * (&frame_2)->normal_4);
        (&frame_2)->normal_4 = _S763 * (&frame_2)->normal_4 + _S764 * _S762;
        (&frame_2)->loss_0 = _S754 * _S754 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    float _S765 = (kernelContext_50->families_0+_S749)->fibre_tilt_0;
    if(((kernelContext_50->families_0+_S749)->fibre_tilt_0) > 0.0f)
    {
        FibreNoise_0 _S766 = fibre_noise_at_0(_S748, _S749, _S750, _S752, _S753, kernelContext_50);
        float _S767 = 1.09858846664428711f * _S765 * (_S766.bundle_weight_0 * _S766.bundle_0.x + _S766.fibre_weight_0 * (_S766.fibre_0.x + _S766.offset_2));
        float _S768 = _S765 * (1.42099642753601074f * (_S766.bundle_weight_0 * _S766.bundle_0.y + _S766.fibre_weight_0 * _S766.fibre_0.y) - _S766.bundle_weight_0 * _S766.slope_2);
        float _S769 = square_0(_S766.fibre_weight_0);
        (&frame_2)->loss_0 = (&frame_2)->loss_0 + 0.5f * _S765 * _S765 * ((0.24761904776096344f * (square_0(_S766.bundle_weight_0) + _S769) + _S769 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        float3 _S770 = cross((&frame_2)->tangent_4, (&frame_2)->normal_4);
        float2 _S771 = sine_cosine_0(_S767);
        float2 _S772 = sine_cosine_0(_S768);
        float3 _S773 = float3(_S771.y) ;
        float3 _S774 = float3(_S771.x) ;
        float3 _S775 = _S773 * _S770 - _S774 * (&frame_2)->normal_4;
        (&frame_2)->normal_4 = _S773 * (&frame_2)->normal_4 + _S774 * _S770;
        (&frame_2)->tangent_4 = float3(_S772.y)  * (&frame_2)->tangent_4 + float3(_S772.x)  * _S775;
    }
    return frame_2;
}

YarnPoint_0 yarn_point_of_0(uint _S776, const SurfacePoint_0 thread* _S777, float _S778, float _S779, bool _S780, bool _S781, float _S782, KernelContext_0 thread* kernelContext_51)
{
    Fabric_0 device* _S783 = kernelContext_51->fabrics_0+_S776;
    bool _S784 = _S777->is_warp_0;
    uint _S785;
    if(_S777->is_warp_0)
    {
        _S785 = _S783->warp_1;
    }
    else
    {
        _S785 = _S783->weft_1;
    }
    bool _S786;
    if((_S783->has_detail_0) != 0U)
    {
        _S786 = _S782 >= 0.0f;
    }
    else
    {
        _S786 = false;
    }
    float3 _S787 = float3(0.0f) ;
    Hair_0 _S788 = Hair_x24init_0(0.0f, _S787, _S787);
    bool _S789;
    if(_S786)
    {
        bool _S790 = has_hairs_0(_S776, kernelContext_51);
        _S789 = _S790;
    }
    else
    {
        _S789 = false;
    }
    Hair_0 hair_2;
    if(_S789)
    {
        Hair_0 _S791 = hair_at_0(_S776, float2(_S778, _S779), _S780, _S782, kernelContext_51);
        hair_2 = _S791;
    }
    else
    {
        hair_2 = _S788;
    }
    uint _S792;
    if(_S784)
    {
        _S792 = _S777->warp_thread_0;
    }
    else
    {
        _S792 = _S777->weft_thread_0;
    }
    Albedos_0 _S793 = albedos_of_0(_S785, _S792, kernelContext_51);
    bool _S794 = varies_at_0(_S776, _S782, kernelContext_51);
    Albedos_0 albedos_7;
    if(_S794)
    {
        thread Albedos_0 _S795 = _S793;
        Albedos_0 _S796 = varied_at_0(_S776, _S777, &_S795, _S778, _S779, _S780, _S782, hair_2.cover_0, kernelContext_51);
        albedos_7 = _S796;
    }
    else
    {
        albedos_7 = _S793;
    }
    thread YarnPoint_0 point_2;
    (&point_2)->back_7 = _S780;
    (&point_2)->hole_6 = _S781;
    (&point_2)->is_warp_3 = _S784;
    (&point_2)->x_12 = _S778;
    (&point_2)->y_6 = _S779;
    (&point_2)->height_10 = _S777->height_0;
    (&point_2)->normal_9 = _S777->normal_0;
    (&point_2)->tangent_10 = _S777->tangent_0;
    (&point_2)->surface_normal_0 = _S777->normal_0;
    (&point_2)->diffuse_gain_1 = 1.0f;
    if(_S786)
    {
        uint _S797 = thread_number_0(_S776, _S777, _S778, _S779, kernelContext_51);
        YarnFrame_0 _S798 = turned_frame_0(_S776, _S785, _S777, _S780, _S797, _S782, kernelContext_51);
        bool _S799 = has_hairs_0(_S776, kernelContext_51);
        YarnFrame_0 frame_3;
        if(_S799)
        {
            thread YarnFrame_0 _S800 = _S798;
            thread Hair_0 _S801 = hair_2;
            YarnFrame_0 _S802 = under_hair_0(&_S800, &_S801);
            frame_3 = _S802;
        }
        else
        {
            frame_3 = _S798;
        }
        (&point_2)->normal_9 = frame_3.normal_4;
        (&point_2)->tangent_10 = frame_3.tangent_4;
        thread YarnFrame_0 _S803 = frame_3;
        float _S804 = diffuse_gain_0(&_S803, _S783->diffuse_blend_0);
        (&point_2)->diffuse_gain_1 = _S804;
    }
    (&point_2)->roughness_10 = (kernelContext_51->families_0+_S785)->roughness_0;
    (&point_2)->albedos_6 = albedos_7;
    return point_2;
}

bool unoccluded_0(uint _S805, const SearchQuality_0 thread* _S806, float _S807, float _S808, float _S809, float3 _S810, bool _S811, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S812 = kernelContext_52->fabrics_0+_S805;
    if((_S810.z) <= 0.0f)
    {
        return false;
    }
    float _S813 = max_height_along_0(_S805, _S807, _S808, _S809, _S810, _S811, kernelContext_52);
    bool _S814 = is_free_0(_S805, _S806, float3(_S807, _S808, _S809 + _S812->lift_0), _S810, _S811, _S813, kernelContext_52);
    return _S814;
}

bool is_lit_0(uint _S815, const SearchQuality_0 thread* _S816, const YarnPoint_0 thread* _S817, float3 _S818, KernelContext_0 thread* kernelContext_53)
{
    if(_S817->hole_6)
    {
        return true;
    }
    bool _S819 = _S817->back_7;
    float3 _S820 = to_face_frame_0(_S818, _S817->back_7);
    float _S821 = _S820.z;
    bool _S822 = _S821 < 0.0f;
    float3 _S823 = _S817->surface_normal_0;
    float _S824 = _S817->height_10;
    float3 normal_10;
    float height_11;
    if(_S822)
    {
        SurfacePoint_0 _S825 = surface_at_0(_S815, _S817->x_12, _S817->y_6, !_S819, kernelContext_53);
        normal_10 = _S825.normal_0;
        height_11 = _S825.height_0;
    }
    else
    {
        normal_10 = _S823;
        height_11 = _S824;
    }
    float3 _S826 = float3(_S820.xy, abs(_S821));
    if((dot(normal_10, _S826)) <= 0.0f)
    {
        return false;
    }
    bool _S827 = unoccluded_0(_S815, _S816, _S817->x_12, _S817->y_6, height_11, _S826, _S819 != _S822, kernelContext_53);
    return _S827;
}

Components_0 components_of_point_0(uint _S828, const SearchQuality_0 thread* _S829, const YarnPoint_0 thread* _S830, float3 _S831, float3 _S832, KernelContext_0 thread* kernelContext_54)
{
    Fabric_0 device* _S833 = kernelContext_54->fabrics_0+_S828;
    thread Components_0 result_3 = no_components_0();
    bool _S834 = _S830->hole_6;
    float _S835;
    if(_S830->hole_6)
    {
        _S835 = 1.0f;
    }
    else
    {
        _S835 = 0.0f;
    }
    (&result_3)->hole_2 = _S835;
    bool _S836;
    if(_S834)
    {
        _S836 = true;
    }
    else
    {
        bool _S837 = is_lit_0(_S828, _S829, _S830, _S831, kernelContext_54);
        _S836 = !_S837;
    }
    if(_S836)
    {
        return result_3;
    }
    float3 _S838 = to_face_frame_0(_S831, _S830->back_7);
    float3 _S839 = to_face_frame_0(_S832, _S830->back_7);
    float _S840 = _S830->diffuse_gain_1;
    bool _S841 = (_S838.z) < 0.0f;
    float3 _S842;
    if(_S841)
    {
        _S842 = - _S838;
    }
    else
    {
        _S842 = _S838;
    }
    float3 _S843 = _S830->normal_9;
    float _S844 = _S840 * diffuse_reflection_0(_S842, _S830->normal_9, _S833->diffuse_blend_0);
    if(_S841)
    {
        _S835 = transmission_1(_S838, _S839, _S843, _S830->tangent_10, _S830->roughness_10, _S833->optical_depth_0);
    }
    else
    {
        _S835 = reflection_0(_S838, _S839, _S843, _S830->tangent_10, _S830->roughness_10, _S833->optical_depth_0);
    }
    bool _S845 = _S830->is_warp_3;
    float _S846;
    if(_S830->is_warp_3)
    {
        _S846 = _S844;
    }
    else
    {
        _S846 = 0.0f;
    }
    (&result_3)->diffuse_warp_0 = _S846;
    if(_S845)
    {
        _S846 = 0.0f;
    }
    else
    {
        _S846 = _S844;
    }
    (&result_3)->diffuse_weft_0 = _S846;
    if(_S845)
    {
        _S846 = _S835;
    }
    else
    {
        _S846 = 0.0f;
    }
    (&result_3)->specular_warp_0 = _S846;
    if(_S845)
    {
        _S835 = 0.0f;
    }
    (&result_3)->specular_weft_0 = _S835;
    (&result_3)->light_visibility_0 = 1.0f;
    return result_3;
}

float openness_number_0(uint _S847, uint _S848, KernelContext_0 thread* kernelContext_55)
{
    float _S849 = table_number_0((kernelContext_55->fabrics_0+_S847)->openness_0 + _S848, kernelContext_55);
    return _S849;
}

Blocked_0 blocked_of_terms_0(uint _S850, uint _S851, const array<float, int(6)> thread* _S852, uint _S853, KernelContext_0 thread* kernelContext_56)
{
    thread array<float, int(3)> shares_0;
    uint share_3 = 0U;
    for(;;)
    {
        if(share_3 < 3U)
        {
        }
        else
        {
            break;
        }
        shares_0[share_3] = 0.0f;
        uint term_0 = 0U;
        for(;;)
        {
            if(term_0 < _S853)
            {
            }
            else
            {
                break;
            }
            float _S854 = openness_number_0(_S850, _S851 + share_3 * _S853 + term_0, kernelContext_56);
            shares_0[share_3] = shares_0[share_3] + _S854 * (*_S852)[term_0];
            term_0 = term_0 + 1U;
        }
        shares_0[share_3] = saturate(shares_0[share_3]);
        share_3 = share_3 + 1U;
    }
    thread Blocked_0 blocked_2;
    (&blocked_2)->by_warp_0 = shares_0[int(0)] * shares_0[int(2)];
    (&blocked_2)->by_weft_0 = shares_0[int(0)] * (1.0f - shares_0[int(2)]);
    (&blocked_2)->far_0 = shares_0[int(1)];
    return blocked_2;
}

Blocked_0 blocked_at_0(uint _S855, bool _S856, bool _S857, float _S858, float _S859, KernelContext_0 thread* kernelContext_57)
{
    float _S860 = openness_number_0(_S855, 158U, kernelContext_57);
    float _S861 = _S859 * _S860;
    float _S862 = _S858 * _S858;
    float _S863 = _S858 * _S861;
    float _S864 = _S861 * _S861;
    uint _S865;
    if(_S857)
    {
        _S865 = 2U;
    }
    else
    {
        _S865 = 0U;
    }
    uint _S866;
    if(_S856)
    {
        _S866 = 0U;
    }
    else
    {
        _S866 = 1U;
    }
    uint _S867 = 60U + (_S865 + _S866) * 18U;
    thread array<float, int(6)> _S868;
    _S868[int(0)] = 1.0f;
    _S868[int(1)] = _S858;
    _S868[int(2)] = _S861;
    _S868[int(3)] = _S862;
    _S868[int(4)] = _S863;
    _S868[int(5)] = _S864;
    Blocked_0 _S869 = blocked_of_terms_0(_S855, _S867, &_S868, 6U, kernelContext_57);
    return _S869;
}

Blocked_0 with_blocked_0(uint _S870, const Blocked_0 thread* _S871, const YarnPoint_0 thread* _S872, bool _S873, float _S874, KernelContext_0 thread* kernelContext_58)
{
    bool _S875;
    if(_S872->hole_6)
    {
        _S875 = true;
    }
    else
    {
        _S875 = (_S872->is_warp_3) != _S873;
    }
    if(_S875)
    {
        return *_S871;
    }
    Blocked_0 _S876 = blocked_at_0(_S870, _S873, _S872->back_7, _S872->normal_9.z, _S872->height_10, kernelContext_58);
    thread Blocked_0 result_4;
    (&result_4)->by_warp_0 = _S871->by_warp_0 + _S874 * _S876.by_warp_0;
    (&result_4)->by_weft_0 = _S871->by_weft_0 + _S874 * _S876.by_weft_0;
    (&result_4)->far_0 = _S871->far_0 + _S874 * _S876.far_0;
    return result_4;
}

struct CoverageTaps_0
{
    array<uint, int(9)> nodes_1;
};

float3 pyramid_level_0(uint _S877, float _S878, KernelContext_0 thread* kernelContext_59)
{
    uint _S879 = (kernelContext_59->fabrics_0+_S877)->lobes_0.levels_0 + 4U * uint(min(_S878, (kernelContext_59->fabrics_0+_S877)->lobes_0.last_level_0));
    float _S880 = table_number_0(_S879, kernelContext_59);
    float _S881 = table_number_0(_S879 + 1U, kernelContext_59);
    float _S882 = table_number_0(_S879 + 2U, kernelContext_59);
    return float3(_S880, _S881, _S882);
}

CoverageTaps_0 coverage_taps_0(uint _S883, const Footprint_0 thread* _S884, bool _S885, KernelContext_0 thread* kernelContext_60)
{
    Fabric_0 device* _S886 = kernelContext_60->fabrics_0+_S883;
    float _S887 = Footprint_spread_side_0(_S884);
    Lobes_0 _S888 = _S886->lobes_0;
    float _S889 = _S887 * _S886->lobes_0.inverse_base_size_0;
    float3 _S890 = pyramid_level_0(_S883, floor(binary_logarithm_0(max(0.68000000715255737f * _S889, 1.0f))), kernelContext_60);
    float _S891 = 1.0f / max(_S889, 9.99999997475242708e-07f);
    float2 _S892 = float2((kernelContext_60->families_0+_S886->warp_1)->inverse_period_0, (kernelContext_60->families_0+_S886->weft_1)->inverse_period_0);
    float2 _S893 = _S884->centre_0 * _S892;
    float2 _S894 = float2(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S891 * _S891), 0.0f, 1.0f)), 0.3333333432674408f * _S891), 1.0f)) ;
    float2 _S895 = _S884->dx_0 * _S892 * _S894;
    float2 _S896 = _S884->dy_0 * _S892 * _S894;
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
        float2 _S897 = _S893 + float2(TAP_OFFSETS_0[number_2].x)  * _S895 + float2(TAP_OFFSETS_0[number_2].y)  * _S896;
        float _S898 = _S890.y;
        float _S899 = wrapped_cell_0(_S897.x, _S898);
        float _S900 = wrapped_cell_0(_S897.y, _S890.z);
        uint _S901;
        if(_S885)
        {
            _S901 = _S888.face_nodes_0;
        }
        else
        {
            _S901 = 0U;
        }
        (&taps_3)->nodes_1[number_2] = _S901 + uint(_S900 * _S898 + _S899 + _S890.x);
        number_2 = number_2 + 1U;
    }
    return taps_3;
}

float4 coverage_of_pack_0(uint _S902, const CoverageTaps_0 thread* _S903, uint _S904, KernelContext_0 thread* kernelContext_61)
{
    Fabric_0 device* _S905 = kernelContext_61->fabrics_0+_S902;
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
        uint _S906 = kernelContext_61->words_0[_S905->lobes_0.coverage_0 + _S903->nodes_1[number_3] * _S905->lobes_0.packs_0 + _S904];
        uint even_2 = even_1 + (_S906 & 16711935U);
        uint odd_2 = odd_1 + ((_S906 >> 8U) & 16711935U);
        number_3 = number_3 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / float4(9.0f) ;
}

float coverage_of_holes_0(uint _S907, const CoverageTaps_0 thread* _S908, KernelContext_0 thread* kernelContext_62)
{
    Fabric_0 device* _S909 = kernelContext_62->fabrics_0+_S907;
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
        uint total_1 = total_0 + ((kernelContext_62->words_0[_S909->lobes_0.coverage_holes_0 + _S908->nodes_1[number_4] / 4U] >> (8U * (_S908->nodes_1[number_4] % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S910, const CoverageTaps_0 thread* _S911, const NodeTaps_0 thread* _S912, bool _S913, KernelContext_0 thread* kernelContext_63)
{
    Lobes_0 _S914 = (kernelContext_63->fabrics_0+_S910)->lobes_0;
    float4 _S915 = interpolate_table_0(_S912, (kernelContext_63->fabrics_0+_S910)->lobes_0.projected_area_0 + (kernelContext_63->fabrics_0+_S910)->lobes_0.packs_0, (kernelContext_63->fabrics_0+_S910)->lobes_0.packs_0 + 1U, kernelContext_63);
    float _S916 = _S915.x;
    float _S917;
    if(_S913)
    {
        _S917 = _S914.back_hole_weight_0;
    }
    else
    {
        _S917 = _S914.front_hole_weight_0;
    }
    float _S918 = coverage_of_holes_0(_S910, _S911, kernelContext_63);
    return min(_S918 * _S916 * _S916 * _S917, 1.0f);
}

Components_0 prefiltered_components_0(uint _S919, const Footprint_0 thread* _S920, float3 _S921, float3 _S922, bool _S923, KernelContext_0 thread* kernelContext_64)
{
    Fabric_0 device* _S924 = kernelContext_64->fabrics_0+_S919;
    CoverageTaps_0 _S925 = coverage_taps_0(_S919, _S920, _S923, kernelContext_64);
    NodeTaps_0 _S926 = node_taps_0(_S922);
    thread NodeTaps_0 view_nodes_0 = _S926;
    thread NodeTaps_0 light_nodes_0 = node_taps_0(_S921);
    thread NodeTaps_0 seen_nodes_0 = _S926;
    uint _S927;
    if(_S923)
    {
        _S927 = 1U;
    }
    else
    {
        _S927 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + uint4((_S927 * 256U)) ;
    uint _S928 = 2U * _S927;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + uint4((_S928 * 256U)) ;
    uint _S929;
    if((_S921.z) < 0.0f)
    {
        _S929 = 1U;
    }
    else
    {
        _S929 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + uint4(((_S928 + _S929) * 256U)) ;
    float3 _S930 = half_vector_0(_S921, _S922);
    float3 _S931 = shadow_correlation_0(_S921, _S922);
    if(_S923)
    {
        _S929 = _S924->lobes_0.back_warp_packs_0;
    }
    else
    {
        _S929 = _S924->lobes_0.front_warp_packs_0;
    }
    thread Components_0 sums_2;
    (&sums_2)->diffuse_warp_0 = 0.0f;
    (&sums_2)->diffuse_weft_0 = 0.0f;
    (&sums_2)->specular_warp_0 = 0.0f;
    (&sums_2)->specular_weft_0 = 0.0f;
    (&sums_2)->light_visibility_0 = 0.0f;
    uint pack_0 = 0U;
    float total_2 = 0.0f;
    for(;;)
    {
        Lobes_0 _S932 = _S924->lobes_0;
        if(pack_0 < (_S924->lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        thread CoverageTaps_0 _S933 = _S925;
        float4 _S934 = coverage_of_pack_0(_S919, &_S933, pack_0, kernelContext_64);
        uint _S935 = _S932.projected_area_0 + pack_0;
        uint _S936 = _S932.packs_0 + 1U;
        thread NodeTaps_0 _S937 = view_nodes_0;
        float4 _S938 = interpolate_table_0(&_S937, _S935, _S936, kernelContext_64);
        uint _S939 = _S932.light_visibility_1 + pack_0;
        thread NodeTaps_0 _S940 = seen_nodes_0;
        float4 _S941 = interpolate_table_0(&_S940, _S939, _S932.packs_0, kernelContext_64);
        float4 _S942 = float4(255.0f) ;
        float4 _S943 = _S941 / _S942;
        thread NodeTaps_0 _S944 = light_nodes_0;
        float4 _S945 = interpolate_table_0(&_S944, _S939, _S932.packs_0, kernelContext_64);
        float4 _S946 = _S945 / _S942;
        uint _S947 = _S932.irradiance_0 + pack_0;
        thread NodeTaps_0 _S948 = light_nodes_0;
        float4 _S949 = interpolate_table_0(&_S948, _S947, _S932.packs_0, kernelContext_64);
        float4 _S950 = _S949 * float4(0.00124827399849892f) ;
        bool _S951 = pack_0 < _S929;
        uint _S952;
        if(_S951)
        {
            _S952 = _S924->warp_1;
        }
        else
        {
            _S952 = _S924->weft_1;
        }
        float _S953 = (kernelContext_64->families_0+_S952)->roughness_0;
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
            Group_0 _S954 = group_at_0(_S932.moments_0 + 12U * (4U * (_S927 * _S932.packs_0 + pack_0) + number_5), _S953, kernelContext_64);
            float _S955 = _S934[number_5] * _S938[number_5] * _S938[number_5] * _S954.weight_2;
            float2 _S956 = visibility_gain_0(_S931, _S946[number_5], _S943[number_5]);
            thread Group_0 _S957 = _S954;
            float _S958 = layer_value_0(&_S957, _S930, _S921, _S922, _S924->optical_depth_0);
            float _S959 = _S956.x;
            float diffuse_1 = diffuse_0 + _S955 * _S950[number_5] * _S959;
            float specular_1 = specular_0 + _S955 * _S958 * _S946[number_5] * _S956.y;
            (&sums_2)->light_visibility_0 = (&sums_2)->light_visibility_0 + _S955 * _S946[number_5] * _S959;
            float total_3 = total_2 + _S955;
            number_5 = number_5 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S960;
        if(_S951)
        {
            _S960 = diffuse_0;
        }
        else
        {
            _S960 = 0.0f;
        }
        (&sums_2)->diffuse_warp_0 = (&sums_2)->diffuse_warp_0 + _S960;
        float _S961;
        if(_S951)
        {
            _S961 = 0.0f;
        }
        else
        {
            _S961 = diffuse_0;
        }
        (&sums_2)->diffuse_weft_0 = (&sums_2)->diffuse_weft_0 + _S961;
        float _S962;
        if(_S951)
        {
            _S962 = specular_0;
        }
        else
        {
            _S962 = 0.0f;
        }
        (&sums_2)->specular_warp_0 = (&sums_2)->specular_warp_0 + _S962;
        float _S963;
        if(_S951)
        {
            _S963 = 0.0f;
        }
        else
        {
            _S963 = specular_0;
        }
        (&sums_2)->specular_weft_0 = (&sums_2)->specular_weft_0 + _S963;
        pack_0 = pack_0 + 1U;
    }
    thread CoverageTaps_0 _S964 = _S925;
    thread NodeTaps_0 _S965 = view_nodes_0;
    float _S966 = prefiltered_hole_0(_S919, &_S964, &_S965, _S923, kernelContext_64);
    (&sums_2)->hole_2 = _S966;
    float _S967 = (1.0f - _S966) / max(total_2, 9.999999960041972e-13f);
    (&sums_2)->diffuse_warp_0 = (&sums_2)->diffuse_warp_0 * _S967;
    (&sums_2)->diffuse_weft_0 = (&sums_2)->diffuse_weft_0 * _S967;
    (&sums_2)->specular_warp_0 = (&sums_2)->specular_warp_0 * _S967;
    (&sums_2)->specular_weft_0 = (&sums_2)->specular_weft_0 * _S967;
    (&sums_2)->light_visibility_0 = (&sums_2)->light_visibility_0 * _S967;
    return sums_2;
}

FamilyAlbedos_0 albedos_over_0(uint _S968, const Footprint_0 thread* _S969, bool _S970, KernelContext_0 thread* kernelContext_65)
{
    Fabric_0 device* _S971 = kernelContext_65->fabrics_0+_S968;
    float2 _S972 = sqrt(_S969->dx_0 * _S969->dx_0 + _S969->dy_0 * _S969->dy_0);
    uint _S973 = _S971->warp_1;
    float2 _S974 = _S969->centre_0;
    Stretch_0 _S975 = stretch_of_0(_S971->warp_1, _S969->centre_0.x, _S972.x, kernelContext_65);
    uint _S976 = _S971->weft_1;
    Stretch_0 _S977 = stretch_of_0(_S971->weft_1, _S974.y, _S972.y, kernelContext_65);
    thread FamilyAlbedos_0 albedos_8;
    thread Stretch_0 _S978 = _S975;
    thread Stretch_0 _S979 = _S977;
    Albedos_0 _S980 = mean_albedos_0(_S973, _S976, &_S978, &_S979, _S970, kernelContext_65);
    (&albedos_8)->warp_5 = _S980;
    thread Stretch_0 _S981 = _S977;
    thread Stretch_0 _S982 = _S975;
    Albedos_0 _S983 = mean_albedos_0(_S976, _S973, &_S981, &_S982, _S970, kernelContext_65);
    (&albedos_8)->weft_5 = _S983;
    return albedos_8;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S984, const Footprint_0 thread* _S985, float _S986, float2 _S987, float3 _S988, float3 _S989, KernelContext_0 thread* kernelContext_66)
{
    float _S990;
    float _S991;
    Fabric_0 device* _S992 = kernelContext_66->fabrics_0+_S984;
    Regime_0 _S993 = regime_of_0(_S984, _S985, _S986, kernelContext_66);
    bool _S994 = (_S989.z) < 0.0f;
    float3 _S995 = to_face_frame_0(_S989, _S994);
    float _S996 = Footprint_spread_side_0(_S985);
    bool _S997 = varies_at_0(_S984, _S996, kernelContext_66);
    bool _S998;
    if(((kernelContext_66->families_0+_S992->warp_1)->quantities_0) > 1U)
    {
        _S998 = true;
    }
    else
    {
        _S998 = ((kernelContext_66->families_0+_S992->weft_1)->quantities_0) > 1U;
    }
    float _S999 = 1.0f - _S993.prefiltered_0;
    if(_S999 > 0.0f)
    {
        if(_S997)
        {
            _S998 = true;
        }
    }
    else
    {
        _S998 = false;
    }
    thread Footprint_0 box_0 = *_S985;
    float3 _S1000 = float3(0.0f) ;
    SurfacePoint_0 _S1001 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S1000, _S1000, 0.0f, 0.0f, 0.0f);
    float2 _S1002 = _S985->centre_0;
    Components_0 _S1003 = no_components_0();
    thread CloseUp_0 close_1 = no_close_up_0();
    int _S1004;
    if(_S998)
    {
        _S1004 = int(0);
    }
    else
    {
        _S1004 = int(1);
    }
    uint _S1005 = uint(_S1004);
    Components_0 points_1 = _S1003;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S1001;
    float2 central_place_0 = _S1002;
    uint number_6 = _S1005;
    for(;;)
    {
        float _S1006 = float(number_6);
        _S990 = _S993.points_0;
        if(_S1006 < (_S993.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S1007 = number_6 == 0U;
        uint _S1008;
        if(_S1007)
        {
            _S1008 = 0U;
        }
        else
        {
            _S1008 = number_6 - 1U;
        }
        float2 _S1009 = POINT_OFFSETS_0[_S1008] + _S987;
        float2 _S1010;
        if(_S1007)
        {
            _S1010 = float2(0.0f) ;
        }
        else
        {
            _S1010 = _S1009 - round(_S1009);
        }
        float2 _S1011 = _S1002 + float2(_S1010.x)  * _S985->dx_0 + float2(_S1010.y)  * _S985->dy_0;
        if(_S1007)
        {
            _S991 = 0.0f;
        }
        else
        {
            _S991 = _S993.threads_1;
        }
        SearchQuality_0 _S1012 = quality_of_0(_S991);
        float _S1013 = _S1011.x;
        float _S1014 = _S1011.y;
        thread SearchQuality_0 _S1015 = _S1012;
        Hit_0 _S1016 = first_hit_0(_S984, &_S1015, _S1013, _S1014, _S995, _S994, kernelContext_66);
        SurfacePoint_0 _S1017 = surface_at_0(_S984, _S1016.x_11, _S1016.y_5, _S994, kernelContext_66);
        if(_S1007)
        {
            float central_weight_1;
            if(_S1016.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S999;
            }
            float2 central_place_1 = float2(_S1016.x_11, _S1016.y_5);
            (&box_0)->centre_0 = mix(_S1002, central_place_1, float2(central_weight_1) );
            central_weight_0 = central_weight_1;
            central_0 = _S1017;
            central_place_0 = central_place_1;
            number_6 = number_6 + 1U;
            continue;
        }
        thread SurfacePoint_0 _S1018 = _S1017;
        YarnPoint_0 _S1019 = yarn_point_of_0(_S984, &_S1018, _S1016.x_11, _S1016.y_5, _S994, _S1016.hole_5, _S996, kernelContext_66);
        thread SearchQuality_0 _S1020 = _S1012;
        thread YarnPoint_0 _S1021 = _S1019;
        Components_0 _S1022 = components_of_point_0(_S984, &_S1020, &_S1021, _S988, _S989, kernelContext_66);
        float _S1023 = min(_S993.points_0 - float(number_6 - 1U), 1.0f);
        thread Components_0 _S1024 = points_1;
        thread Components_0 _S1025 = _S1022;
        Components_0 _S1026 = with_added_0(&_S1024, &_S1025, _S1023);
        if((_S992->openness_0) != 4294967295U)
        {
            thread Blocked_0 _S1027 = (&close_1)->warp_0;
            thread YarnPoint_0 _S1028 = _S1019;
            Blocked_0 _S1029 = with_blocked_0(_S984, &_S1027, &_S1028, true, _S1023, kernelContext_66);
            (&close_1)->warp_0 = _S1029;
            thread Blocked_0 _S1030 = (&close_1)->weft_0;
            thread YarnPoint_0 _S1031 = _S1019;
            Blocked_0 _S1032 = with_blocked_0(_S984, &_S1030, &_S1031, false, _S1023, kernelContext_66);
            (&close_1)->weft_0 = _S1032;
        }
        points_1 = _S1026;
        number_6 = number_6 + 1U;
    }
    (&close_1)->weight_0 = _S999;
    float _S1033 = max(_S990, 1.0f);
    float _S1034 = 1.0f / _S1033;
    thread Blocked_0 _S1035 = (&close_1)->warp_0;
    Blocked_0 _S1036 = scaled_0(&_S1035, _S1034);
    (&close_1)->warp_0 = _S1036;
    float _S1037 = 1.0f / _S1033;
    thread Blocked_0 _S1038 = (&close_1)->weft_0;
    Blocked_0 _S1039 = scaled_0(&_S1038, _S1037);
    (&close_1)->weft_0 = _S1039;
    thread Estimate_0 estimate_0;
    (&estimate_0)->close_0 = close_1;
    float _S1040 = _S999 / _S1033;
    thread Components_0 _S1041 = _S1003;
    thread Components_0 _S1042 = points_1;
    Components_0 _S1043 = with_added_0(&_S1041, &_S1042, _S1040);
    (&estimate_0)->components_0 = _S1043;
    if((_S993.prefiltered_0) > 0.0f)
    {
        Components_0 _S1044 = prefiltered_components_0(_S984, _S985, to_face_frame_0(_S988, _S994), _S995, _S994, kernelContext_66);
        thread Components_0 _S1045 = (&estimate_0)->components_0;
        thread Components_0 _S1046 = _S1044;
        Components_0 _S1047 = with_added_0(&_S1045, &_S1046, _S993.prefiltered_0);
        (&estimate_0)->components_0 = _S1047;
    }
    thread Footprint_0 _S1048 = box_0;
    FamilyAlbedos_0 _S1049 = albedos_over_0(_S984, &_S1048, _S994, kernelContext_66);
    (&estimate_0)->albedos_5 = _S1049;
    if(_S997)
    {
        _S998 = central_weight_0 > 0.0f;
    }
    else
    {
        _S998 = false;
    }
    if(_S998)
    {
        SurfacePoint_0 _S1050 = central_0;
        Albedos_0 _S1051;
        if(central_0.is_warp_0)
        {
            _S1051 = (&(&estimate_0)->albedos_5)->warp_5;
        }
        else
        {
            _S1051 = (&(&estimate_0)->albedos_5)->weft_5;
        }
        if((_S992->has_detail_0) != 0U)
        {
            bool _S1052 = has_hairs_0(_S984, kernelContext_66);
            _S998 = _S1052;
        }
        else
        {
            _S998 = false;
        }
        if(_S998)
        {
            Hair_0 _S1053 = hair_at_0(_S984, central_place_0, _S994, _S996, kernelContext_66);
            _S991 = _S1053.cover_0;
        }
        else
        {
            _S991 = 0.0f;
        }
        float _S1054 = central_place_0.x;
        float _S1055 = central_place_0.y;
        thread SurfacePoint_0 _S1056 = central_0;
        thread Albedos_0 _S1057 = _S1051;
        Albedos_0 _S1058 = varied_at_0(_S984, &_S1056, &_S1057, _S1054, _S1055, _S994, _S996, _S991, kernelContext_66);
        thread Albedos_0 _S1059 = _S1051;
        thread Albedos_0 _S1060 = _S1058;
        Albedos_0 _S1061 = lerp_albedos_0(&_S1059, &_S1060, central_weight_0);
        if(_S1050.is_warp_0)
        {
            (&(&estimate_0)->albedos_5)->warp_5 = _S1061;
        }
        else
        {
            (&(&estimate_0)->albedos_5)->weft_5 = _S1061;
        }
    }
    return estimate_0;
}

Estimate_0 lobes_estimate_0(uint _S1062, const Footprint_0 thread* _S1063, float _S1064, float3 _S1065, float3 _S1066, KernelContext_0 thread* kernelContext_67)
{
    Estimate_0 _S1067 = lobes_estimate_of_pass_0(_S1062, _S1063, _S1064, float2(0.0f) , _S1065, _S1066, kernelContext_67);
    return _S1067;
}

Scattered_0 scattered_by_0(uint _S1068, const Albedos_0 thread* _S1069, uint _S1070, float3 _S1071, KernelContext_0 thread* kernelContext_68)
{
    uint _S1072 = 159U + 2U * _S1070;
    thread Scattered_0 yarn_3;
    float3 _S1073 = _S1071 * _S1069->diffuse_reflect_0;
    float _S1074 = openness_number_0(_S1068, _S1072, kernelContext_68);
    (&yarn_3)->back_6 = _S1073 + float3(_S1074)  * _S1069->specular_reflect_0;
    float3 _S1075 = _S1071 * _S1069->diffuse_transmit_0;
    float _S1076 = openness_number_0(_S1068, _S1072 + 1U, kernelContext_68);
    (&yarn_3)->through_0 = _S1075 + float3(_S1076)  * _S1069->specular_transmit_0;
    return yarn_3;
}

float openness_number_1(uint _S1077, uint _S1078, KernelContext_0 thread* kernelContext_69)
{
    float _S1079 = table_number_0((kernelContext_69->fabrics_0+_S1077)->openness_0 + _S1078, kernelContext_69);
    return _S1079;
}

void sent_0(uint _S1080, uint _S1081, float3 _S1082, float3 _S1083, float3 _S1084, float3 _S1085, float3 thread* _S1086, float3 thread* _S1087, KernelContext_0 thread* kernelContext_70)
{
    uint _S1088 = 146U + 4U * _S1081;
    float _S1089 = openness_number_1(_S1080, _S1088, kernelContext_70);
    float _S1090 = openness_number_1(_S1080, _S1088 + 1U, kernelContext_70);
    float _S1091 = openness_number_1(_S1080, _S1088 + 2U, kernelContext_70);
    float _S1092 = openness_number_1(_S1080, _S1088 + 3U, kernelContext_70);
    float3 _S1093 = float3(1.0f) ;
    float3 _S1094 = _S1093 - _S1084 * float3(_S1089) ;
    float3 _S1095 = _S1093 - _S1085 * float3(_S1092) ;
    float3 _S1096 = _S1093 / (_S1094 * _S1095 - _S1084 * _S1085 * float3((_S1090 * _S1091)) );
    *_S1086 = (_S1082 * _S1095 + _S1084 * float3(_S1090)  * _S1083) * _S1096;
    *_S1087 = (_S1083 * _S1094 + _S1085 * float3(_S1091)  * _S1082) * _S1096;
    return;
}

FaceSends_0 face_sends_0(uint _S1097, uint _S1098, const Scattered_0 thread* _S1099, const Scattered_0 thread* _S1100, KernelContext_0 thread* kernelContext_71)
{
    uint _S1101 = 2U * _S1098;
    uint _S1102 = 142U + _S1101;
    float _S1103 = openness_number_0(_S1097, _S1102, kernelContext_71);
    float _S1104 = openness_number_0(_S1097, _S1102 + 1U, kernelContext_71);
    float3 _S1105 = _S1099->back_6;
    float3 _S1106 = float3((1.0f - _S1103))  * _S1099->back_6;
    float3 _S1107 = _S1100->back_6;
    float3 _S1108 = float3((1.0f - _S1104))  * _S1100->back_6;
    thread FaceSends_0 sends_1;
    uint _S1109 = 154U + _S1101;
    float _S1110 = openness_number_0(_S1097, _S1109, kernelContext_71);
    (&sends_1)->blocks_warp_0 = _S1110;
    float _S1111 = openness_number_0(_S1097, _S1109 + 1U, kernelContext_71);
    (&sends_1)->blocks_weft_0 = _S1111;
    (&sends_1)->open_0 = _S1110 * _S1103 + _S1111 * _S1104;
    sent_0(_S1097, _S1098, float3(_S1103)  * _S1105, float3(_S1104)  * _S1107, _S1106, _S1108, &(&sends_1)->sky_warp_0, &(&sends_1)->sky_weft_0, kernelContext_71);
    sent_0(_S1097, _S1098, _S1099->through_0, _S1100->through_0, _S1106, _S1108, &(&sends_1)->crossing_warp_0, &(&sends_1)->crossing_weft_0, kernelContext_71);
    return sends_1;
}

Interior_0 interior_of_0(uint _S1112, float3 _S1113, bool _S1114, KernelContext_0 thread* kernelContext_72)
{
    Fabric_0 device* _S1115 = kernelContext_72->fabrics_0+_S1112;
    Albedos_0 _S1116 = table_albedos_0((kernelContext_72->families_0+_S1115->warp_1)->colour_mean_0, kernelContext_72);
    thread Albedos_0 _S1117 = _S1116;
    Scattered_0 _S1118 = scattered_by_0(_S1112, &_S1117, 0U, _S1113, kernelContext_72);
    Albedos_0 _S1119 = table_albedos_0((kernelContext_72->families_0+_S1115->weft_1)->colour_mean_0, kernelContext_72);
    thread Albedos_0 _S1120 = _S1119;
    Scattered_0 _S1121 = scattered_by_0(_S1112, &_S1120, 1U, _S1113, kernelContext_72);
    uint _S1122;
    if(_S1114)
    {
        _S1122 = 1U;
    }
    else
    {
        _S1122 = 0U;
    }
    thread Scattered_0 _S1123 = _S1118;
    thread Scattered_0 _S1124 = _S1121;
    FaceSends_0 _S1125 = face_sends_0(_S1112, _S1122, &_S1123, &_S1124, kernelContext_72);
    if(_S1114)
    {
        _S1122 = 0U;
    }
    else
    {
        _S1122 = 1U;
    }
    thread Scattered_0 _S1126 = _S1118;
    thread Scattered_0 _S1127 = _S1121;
    FaceSends_0 _S1128 = face_sends_0(_S1112, _S1122, &_S1126, &_S1127, kernelContext_72);
    float3 _S1129 = float3(_S1125.blocks_warp_0) ;
    float3 _S1130 = float3(_S1125.blocks_weft_0) ;
    float3 _S1131 = _S1129 * _S1125.crossing_warp_0 + _S1130 * _S1125.crossing_weft_0;
    float3 _S1132 = float3(_S1128.blocks_warp_0) ;
    float3 _S1133 = float3(_S1128.blocks_weft_0) ;
    float3 _S1134 = _S1132 * _S1128.crossing_warp_0 + _S1133 * _S1128.crossing_weft_0;
    float _S1135 = 1.0f - _S1125.open_0;
    float _S1136 = 1.0f - _S1128.open_0;
    float3 _S1137 = float3(1.0f) ;
    float3 _S1138 = _S1137 / (_S1137 - _S1131 * _S1134 * float3((_S1135 * _S1136)) );
    float3 _S1139 = _S1134 * (float3(_S1125.open_0)  + float3(_S1135)  * (_S1129 * _S1125.sky_warp_0 + _S1130 * _S1125.sky_weft_0)) * _S1138;
    float3 _S1140 = _S1131 * (float3(_S1128.open_0)  + float3(_S1136)  * (_S1132 * _S1128.sky_warp_0 + _S1133 * _S1128.sky_weft_0)) * _S1138;
    thread FaceSends_0 _S1141 = _S1125;
    FaceRadiance_0 _S1142 = face_radiance_0(&_S1141, _S1128.open_0, _S1139, _S1140);
    thread FaceSends_0 _S1143 = _S1128;
    FaceRadiance_0 _S1144 = face_radiance_0(&_S1143, _S1125.open_0, _S1140, _S1139);
    thread Interior_0 interior_1;
    (&interior_1)->warp_4 = _S1142.warp_3;
    (&interior_1)->weft_4 = _S1142.weft_3;
    (&interior_1)->leaked_1 = _S1142.leaked_0;
    (&interior_1)->far_1 = _S1144.mean_0;
    (&interior_1)->far_leaked_0 = _S1144.leaked_0;
    return interior_1;
}

Blocked_0 blocked_from_0(uint _S1145, float3 _S1146, bool _S1147, bool _S1148, KernelContext_0 thread* kernelContext_73)
{
    thread array<float, int(6)> terms_1;
    view_terms_0(_S1146, &terms_1);
    uint _S1149;
    if(_S1148)
    {
        _S1149 = 2U;
    }
    else
    {
        _S1149 = 0U;
    }
    uint _S1150;
    if(_S1147)
    {
        _S1150 = 0U;
    }
    else
    {
        _S1150 = 1U;
    }
    uint _S1151 = (_S1149 + _S1150) * 15U;
    thread array<float, int(6)> _S1152 = terms_1;
    Blocked_0 _S1153 = blocked_of_terms_0(_S1145, _S1151, &_S1152, 5U, kernelContext_73);
    return _S1153;
}

float warp_seen_from_0(uint _S1154, float3 _S1155, bool _S1156, KernelContext_0 thread* kernelContext_74)
{
    thread array<float, int(6)> terms_2;
    view_terms_0(_S1155, &terms_2);
    uint term_1 = 0U;
    float share_4 = 0.0f;
    for(;;)
    {
        if(term_1 < 5U)
        {
        }
        else
        {
            break;
        }
        uint _S1157;
        if(_S1156)
        {
            _S1157 = 5U;
        }
        else
        {
            _S1157 = 0U;
        }
        float _S1158 = openness_number_0(_S1154, 132U + _S1157 + term_1, kernelContext_74);
        float share_5 = share_4 + _S1158 * terms_2[term_1];
        term_1 = term_1 + 1U;
        share_4 = share_5;
    }
    return saturate(share_4);
}

Bounced_0 bounced_of_families_0(uint _S1159, const FamilyAlbedos_0 thread* _S1160, float3 _S1161, const Interior_0 thread* _S1162, const Blocked_0 thread* _S1163, const Blocked_0 thread* _S1164, KernelContext_0 thread* kernelContext_75)
{
    Scattered_0 _S1165 = scattered_by_0(_S1159, &_S1160->warp_5, 0U, _S1161, kernelContext_75);
    thread Scattered_0 _S1166 = _S1165;
    Bounced_0 _S1167 = bounced_by_0(_S1163, &_S1166, _S1162);
    Scattered_0 _S1168 = scattered_by_0(_S1159, &_S1160->weft_5, 1U, _S1161, kernelContext_75);
    thread Scattered_0 _S1169 = _S1168;
    Bounced_0 _S1170 = bounced_by_0(_S1164, &_S1169, _S1162);
    thread Bounced_0 _S1171 = _S1167;
    thread Bounced_0 _S1172 = _S1170;
    Bounced_0 _S1173 = sum_of_0(&_S1171, &_S1172);
    return _S1173;
}

Bounced_0 bounced_far_0(uint _S1174, const FamilyAlbedos_0 thread* _S1175, float3 _S1176, const Interior_0 thread* _S1177, float3 _S1178, bool _S1179, float _S1180, float _S1181, float _S1182, KernelContext_0 thread* kernelContext_76)
{
    Blocked_0 _S1183 = blocked_from_0(_S1174, _S1178, true, _S1179, kernelContext_76);
    Blocked_0 _S1184 = blocked_from_0(_S1174, _S1178, false, _S1179, kernelContext_76);
    float _S1185 = _S1180 / max(1.0f - _S1183.by_warp_0 - _S1183.by_weft_0, 0.10000000149011612f);
    float _S1186 = _S1181 / max(1.0f - _S1184.by_warp_0 - _S1184.by_weft_0, 0.10000000149011612f);
    float _S1187 = warp_seen_from_0(_S1174, _S1178, _S1179, kernelContext_76);
    float _S1188 = (0.0020000000949949f * _S1187 + _S1185) / (_S1185 + _S1186 + 0.0020000000949949f);
    float _S1189 = 1.0f - _S1182;
    float _S1190 = _S1188 * _S1189;
    thread Blocked_0 _S1191 = _S1183;
    Blocked_0 _S1192 = scaled_0(&_S1191, _S1190);
    float _S1193 = (1.0f - _S1188) * _S1189;
    thread Blocked_0 _S1194 = _S1184;
    Blocked_0 _S1195 = scaled_0(&_S1194, _S1193);
    thread Blocked_0 _S1196 = _S1192;
    thread Blocked_0 _S1197 = _S1195;
    Bounced_0 _S1198 = bounced_of_families_0(_S1174, _S1175, _S1176, _S1177, &_S1196, &_S1197, kernelContext_76);
    return _S1198;
}

Bounced_0 bounced_over_0(uint _S1199, const Components_0 thread* _S1200, const CloseUp_0 thread* _S1201, const FamilyAlbedos_0 thread* _S1202, float3 _S1203, float3 _S1204, KernelContext_0 thread* kernelContext_77)
{
    bool _S1205 = (_S1204.z) < 0.0f;
    Interior_0 _S1206 = interior_of_0(_S1199, _S1203, _S1205, kernelContext_77);
    float3 _S1207 = to_face_frame_0(_S1204, _S1205);
    thread Interior_0 _S1208 = _S1206;
    Bounced_0 _S1209 = bounced_far_0(_S1199, _S1202, _S1203, &_S1208, _S1207, _S1205, _S1200->diffuse_warp_0, _S1200->diffuse_weft_0, _S1200->hole_2, kernelContext_77);
    thread Bounced_0 bounced_2 = _S1209;
    float _S1210 = _S1201->weight_0;
    if((_S1201->weight_0) > 0.0f)
    {
        thread Interior_0 _S1211 = _S1206;
        Bounced_0 _S1212 = bounced_of_families_0(_S1199, _S1202, _S1203, &_S1211, &_S1201->warp_0, &_S1201->weft_0, kernelContext_77);
        float3 _S1213 = float3(_S1210) ;
        (&bounced_2)->reflected_0 = mix((&bounced_2)->reflected_0, _S1212.reflected_0, _S1213);
        (&bounced_2)->transmitted_0 = mix((&bounced_2)->transmitted_0, _S1212.transmitted_0, _S1213);
    }
    return bounced_2;
}

float3 composed_0(uint _S1214, const Components_0 thread* _S1215, const CloseUp_0 thread* _S1216, const FamilyAlbedos_0 thread* _S1217, float3 _S1218, float3 _S1219, float3 _S1220, KernelContext_0 thread* kernelContext_78)
{
    Fabric_0 device* _S1221 = kernelContext_78->fabrics_0+_S1214;
    Albedos_0 _S1222 = tinted_0(&_S1217->warp_5, _S1218);
    Albedos_0 _S1223 = tinted_0(&_S1217->weft_5, _S1218);
    float3 _S1224 = float3(_S1215->diffuse_warp_0) ;
    float3 _S1225 = float3(_S1215->diffuse_weft_0) ;
    float3 _S1226 = float3(_S1215->specular_warp_0) ;
    float3 _S1227 = float3(_S1215->specular_weft_0) ;
    float3 _S1228 = _S1222.diffuse_reflect_0 * _S1224 + _S1223.diffuse_reflect_0 * _S1225 + _S1222.specular_reflect_0 * _S1226 + _S1223.specular_reflect_0 * _S1227;
    float _S1229 = _S1220.z;
    float3 body_0;
    if((_S1219.z * _S1229) < 0.0f)
    {
        body_0 = _S1222.diffuse_transmit_0 * _S1224 + _S1223.diffuse_transmit_0 * _S1225 + _S1222.specular_transmit_0 * _S1226 + _S1223.specular_transmit_0 * _S1227;
    }
    else
    {
        body_0 = _S1228;
    }
    if((_S1221->openness_0) != 4294967295U)
    {
        Bounced_0 _S1230 = bounced_over_0(_S1214, _S1215, _S1216, _S1217, _S1218, _S1220, kernelContext_78);
        thread Bounced_0 _S1231 = _S1230;
        float3 _S1232 = bounced_value_0(&_S1231, _S1219, _S1220);
        body_0 = body_0 + _S1232;
    }
    float _S1233 = _S1221->sheen_strength_0;
    if((_S1221->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S1234 = _S1229 < 0.0f;
    float2 _S1235 = sheen_with_transmittance_0(to_face_frame_0(_S1219, _S1234), to_face_frame_0(_S1220, _S1234), _S1233, _S1221->sheen_roughness_0);
    return float3(_S1235.y)  * body_0 + float3(((_S1215->light_visibility_0 + _S1215->hole_2) * _S1235.x)) ;
}

float4 cloth_value_0(uint fabric_1, float2 centre_2, float2 dx_1, float2 dy_1, float3 light_11, float3 view_11, KernelContext_0 thread* kernelContext_79)
{
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_2;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    thread Footprint_0 _S1236 = footprint_0;
    Estimate_0 _S1237 = lobes_estimate_0(fabric_1, &_S1236, 1.0f, light_11, view_11, kernelContext_79);
    float3 _S1238 = float3(1.0f) ;
    thread Components_0 _S1239 = _S1237.components_0;
    thread CloseUp_0 _S1240 = _S1237.close_0;
    thread FamilyAlbedos_0 _S1241 = _S1237.albedos_5;
    float3 _S1242 = composed_0(fabric_1, &_S1239, &_S1240, &_S1241, _S1238, light_11, view_11, kernelContext_79);
    float through_1;
    if(((kernelContext_79->fabrics_0+fabric_1)->sheen_strength_0) > 0.0f)
    {
        through_1 = _S1237.components_0.hole_2 * (1.0f - (kernelContext_79->fabrics_0+fabric_1)->sheen_strength_0 * sheen_lobe_0(abs(view_11.z), (kernelContext_79->fabrics_0+fabric_1)->sheen_roughness_0).z);
    }
    else
    {
        through_1 = _S1237.components_0.hole_2;
    }
    return float4(_S1242, through_1);
}

[[kernel]] void lobes_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]])
{
    thread KernelContext_0 kernelContext_80;
    (&kernelContext_80)->query_count_0 = query_count_1;
    (&kernelContext_80)->queries_0 = queries_1;
    (&kernelContext_80)->answers_0 = answers_1;
    (&kernelContext_80)->fabrics_0 = fabrics_1;
    (&kernelContext_80)->families_0 = families_1;
    (&kernelContext_80)->words_0 = words_1;
    uint _S1243 = id_0.x;
    if(_S1243 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S1244 = (&kernelContext_80)->queries_0[_S1243];
    packed_float4 device* _S1245 = (&kernelContext_80)->answers_0+_S1243;
    float4 _S1246 = cloth_value_0(_S1244.fabric_0, float2(_S1244.centre_x_0, _S1244.centre_y_0), float2(_S1244.dx_x_0, _S1244.dx_y_0), float2(_S1244.dy_x_0, _S1244.dy_y_0), float3(_S1244.light_x_0, _S1244.light_y_0, _S1244.light_z_0), float3(_S1244.view_x_0, _S1244.view_y_0, _S1244.view_z_0), &kernelContext_80);
    *_S1245 = packed_float4(_S1246) ;
    return;
}

