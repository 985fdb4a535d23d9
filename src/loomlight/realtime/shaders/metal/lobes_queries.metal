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

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 quality_of_0(float threads_0)
{
    float _S6 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    thread SearchQuality_0 quality_0;
    float _S7 = mix(2.5f, 5.0f, _S6);
    (&quality_0)->steps_per_thread_0 = _S7;
    (&quality_0)->steps_per_relief_0 = _S7;
    (&quality_0)->shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S6);
    (&quality_0)->refinements_0 = uint(mix(1.0f, 2.0f, _S6) + 0.5f);
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
    float _S8 = floor(fma(index_0, kernelContext_0->families_0[family_0].inverse_count_0, kernelContext_0->families_0[family_0].half_inverse_count_0));
    return float2(_S8, fma(- _S8, kernelContext_0->families_0[family_0].count_0, index_0));
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
    float _S9 = floor(position_0 * kernelContext_1->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_0;
    float _S10 = fma(- _S9, kernelContext_1->families_0[family_1].size_0, position_0);
    (&cell_0)->below_0 = _S10;
    (&cell_0)->above_0 = kernelContext_1->families_0[family_1].size_0 - _S10;
    (&cell_0)->across_2 = _S10 - 0.5f * kernelContext_1->families_0[family_1].size_0;
    (&cell_0)->half_width_1 = kernelContext_1->families_0[family_1].half_width_0;
    float2 _S11 = turns_and_remainder_0(family_1, _S9, kernelContext_1);
    (&cell_0)->thread_0 = uint(clamp(_S11.y, 0.0f, kernelContext_1->families_0[family_1].count_0 - 1.0f));
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
    float _S12 = turns_1 * kernelContext_4->families_0[family_2].period_0;
    uint thread_1 = kernelContext_4->words_0[kernelContext_4->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_4->families_0[family_2].bins_0, 0.0f, kernelContext_4->families_0[family_2].bins_0 - 1.0f))];
    float _S13 = table_number_0(kernelContext_4->families_0[family_2].place_table_0 + thread_1 * 4U + 1U, kernelContext_4);
    uint _S14;
    if(_S12 >= _S13)
    {
        _S14 = 1U;
    }
    else
    {
        _S14 = 0U;
    }
    uint _S15 = min(thread_1 + _S14, uint(kernelContext_4->families_0[family_2].count_0) - 1U);
    uint _S16 = kernelContext_4->families_0[family_2].place_table_0 + _S15 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S15;
    float _S17 = table_number_0(_S16, kernelContext_4);
    (&cell_1)->below_0 = _S12 - _S17;
    float _S18 = table_number_0(_S16 + 1U, kernelContext_4);
    (&cell_1)->above_0 = _S18 - _S12;
    float _S19 = table_number_0(_S16 + 2U, kernelContext_4);
    (&cell_1)->across_2 = _S12 - _S19;
    float _S20 = table_number_0(_S16 + 3U, kernelContext_4);
    (&cell_1)->half_width_1 = _S20;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_2, KernelContext_0 thread* kernelContext_5)
{
    if((kernelContext_5->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S21 = locate_alike_0(family_3, position_2, kernelContext_5);
        return _S21;
    }
    Cell_0 _S22 = locate_varied_0(family_3, position_2, kernelContext_5);
    return _S22;
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
    bool _S23 = (abs((&crossing_0->warp_1)->across_2)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S24 = (abs((&crossing_0->weft_1)->across_2)) < ((&crossing_0->weft_1)->half_width_1);
    thread Shown_0 shown_0;
    bool _S25;
    if(_S23)
    {
        if(!_S24)
        {
            _S25 = true;
        }
        else
        {
            _S25 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S25 = false;
    }
    (&shown_0)->is_warp_2 = _S25;
    if(!_S23)
    {
        _S25 = !_S24;
    }
    else
    {
        _S25 = false;
    }
    (&shown_0)->hole_3 = _S25;
    uint _S26;
    if((&shown_0)->is_warp_2)
    {
        _S26 = crossing_0->warp_word_0;
    }
    else
    {
        _S26 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S26;
    (&shown_0)->on_top_0 = ((_S26 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_0, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_2;
    uint _S27;
    if(is_first_0)
    {
        _S27 = first_0->thread_0;
    }
    else
    {
        _S27 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S27;
    float _S28;
    if(is_first_0)
    {
        _S28 = first_0->across_2;
    }
    else
    {
        _S28 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S28;
    if(is_first_0)
    {
        _S28 = first_0->half_width_1;
    }
    else
    {
        _S28 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S28;
    if(is_first_0)
    {
        _S28 = first_0->below_0;
    }
    else
    {
        _S28 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S28;
    if(is_first_0)
    {
        _S28 = first_0->above_0;
    }
    else
    {
        _S28 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S28;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0, KernelContext_0 thread* kernelContext_6)
{
    float2 _S29 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0), kernelContext_6);
    float _S30 = _S29.x;
    Family_0 _S31 = kernelContext_6->families_0[family_4];
    float _S32 = table_number_0(kernelContext_6->families_0[family_4].place_table_0 + uint(_S29.y) * 4U, kernelContext_6);
    return fma(_S30, _S31.period_0, _S32);
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0, KernelContext_0 thread* kernelContext_7)
{
    if((kernelContext_7->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * kernelContext_7->families_0[family_5].size_0;
    }
    float _S33 = boundary_0(family_5, thread_3, last_0, kernelContext_7);
    float _S34 = boundary_0(family_5, thread_3, first_1, kernelContext_7);
    return _S33 - _S34;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_4, KernelContext_0 thread* kernelContext_8)
{
    Family_0 _S35 = kernelContext_8->families_0[family_6];
    uint _S36;
    if((kernelContext_8->families_0[family_6].is_alike_0) != 0U)
    {
        _S36 = 0U;
    }
    else
    {
        _S36 = thread_4 * 4U;
    }
    uint _S37 = _S35.bend_table_0 + _S36;
    thread Bend_0 bend_0;
    float _S38 = table_number_0(_S37, kernelContext_8);
    (&bend_0)->sine_0 = _S38;
    float _S39 = table_number_0(_S37 + 1U, kernelContext_8);
    (&bend_0)->half_tangent_0 = _S39;
    float _S40 = table_number_0(_S37 + 2U, kernelContext_8);
    (&bend_0)->arc_0 = _S40;
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
    int _S41 = int((word_1 >> 1U) & 127U);
    int _S42 = int((word_1 >> 8U) & 127U);
    int _S43 = int((word_1 >> 15U) & 63U);
    int _S44 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S45 = crossed_0->below_0;
    uint _S46 = crossed_0->thread_0;
    int _S47 = - _S41;
    float _S48 = span_0(other_0, crossed_0->thread_0, _S47, int(0), kernelContext_9);
    float _S49 = _S45 + _S48;
    (&run_0)->from_start_0 = _S49;
    float _S50 = crossed_0->above_0;
    int _S51 = _S42 + int(1);
    float _S52 = span_0(other_0, _S46, int(1), _S51, kernelContext_9);
    float _S53 = _S50 + _S52;
    (&run_0)->to_end_0 = _S53;
    bool _S54 = _S49 < _S53;
    (&run_0)->near_start_0 = _S54;
    int _S55;
    if(_S54)
    {
        _S55 = _S47 - _S43;
    }
    else
    {
        _S55 = _S51;
    }
    int _S56;
    if((&run_0)->near_start_0)
    {
        _S56 = _S47;
    }
    else
    {
        _S56 = _S51 + _S44;
    }
    Bend_0 _S57 = bend_of_0(own_0, thread_5, kernelContext_9);
    (&run_0)->bend_1 = _S57;
    float _S58;
    if((&run_0)->straight_0)
    {
        _S58 = 1.0e+06f;
    }
    else
    {
        _S58 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S58;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S59 = span_0(other_0, _S46, _S55, _S56, kernelContext_9);
    (&run_0)->other_reach_0 = min(0.5f * _S59, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S41 == int(0);
    (&run_0)->last_crossing_0 = _S42 == int(0);
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
    float _S60 = cell_3->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S61 = clamp(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S61;
    float _S62 = _S60 * _S60 - square_0(_S61);
    float _S63 = rsqrt(_S62);
    (&section_0)->drop_0 = _S60 - _S62 * _S63;
    (&section_0)->slope_0 = - _S61 * _S63;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_6, int step_1, KernelContext_0 thread* kernelContext_10)
{
    if((kernelContext_10->families_0[family_7].is_alike_0) != 0U)
    {
        float _S64 = table_number_0(kernelContext_10->families_0[family_7].bend_table_0 + 3U, kernelContext_10);
        return _S64;
    }
    Family_0 _S65 = kernelContext_10->families_0[family_7];
    float2 _S66 = turns_and_remainder_0(family_7, float(int(thread_6) + step_1), kernelContext_10);
    float _S67 = table_number_0(_S65.bend_table_0 + uint(_S66.y) * 4U + 3U, kernelContext_10);
    return _S67;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_11)
{
    float _S68 = crossed_1->below_0;
    float _S69 = crossed_1->above_0;
    bool _S70 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S71 = min(crossed_1->below_0, crossed_1->above_0);
    float _S72;
    if(_S70)
    {
        _S72 = _S68 - crossed_1->across_2;
    }
    else
    {
        _S72 = _S69 + crossed_1->across_2;
    }
    float _S73 = _S72 - crossed_1->half_width_1;
    bool _S74;
    if(_S70)
    {
        _S74 = run_1->first_crossing_0;
    }
    else
    {
        _S74 = run_1->last_crossing_0;
    }
    bool _S75 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S72 = 0.0f;
    }
    else
    {
        Family_0 _S76 = kernelContext_11->families_0[other_1];
        float _S77 = edge_drop_0(other_1, crossed_1->thread_0, int(0), kernelContext_11);
        _S72 = _S76.height_scale_0 * _S77;
    }
    float _S78;
    if(_S75 != _S74)
    {
        _S78 = 0.0f;
    }
    else
    {
        Family_0 _S79 = kernelContext_11->families_0[other_1];
        uint _S80 = crossed_1->thread_0;
        int _S81;
        if(_S70)
        {
            _S81 = int(-1);
        }
        else
        {
            _S81 = int(1);
        }
        float _S82 = edge_drop_0(other_1, _S80, _S81, kernelContext_11);
        _S78 = _S79.height_scale_0 * _S82;
    }
    float _S83 = 1.0f / max(2.0f * _S73, 9.999999960041972e-13f);
    float _S84 = clamp((_S73 - _S71) * _S83, 0.0f, 1.0f);
    float _S85 = _S72 + (_S78 - _S72) * (_S84 * _S84 * (3.0f - 2.0f * _S84));
    float _S86 = (_S72 - _S78) * (6.0f * _S84 * (1.0f - _S84) * _S83);
    if(_S70)
    {
        _S72 = 1.0f;
    }
    else
    {
        _S72 = -1.0f;
    }
    return float2(_S85, _S86 * _S72);
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
    float _S87 = direction_1.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S87), 9.99999971718068537e-10f);
    float _S88 = direction_1.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S88), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S87 > 0.0f;
    (&control_0)->up_0 = _S88 > 0.0f;
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
    float _S89;
    if(forwards_0)
    {
        _S89 = cell_4->across_2;
    }
    else
    {
        _S89 = - cell_4->across_2;
    }
    float _S90;
    if(forwards_0)
    {
        _S90 = cell_4->above_0;
    }
    else
    {
        _S90 = cell_4->below_0;
    }
    bool _S91;
    if(forwards_0)
    {
        _S91 = run_2->last_crossing_0;
    }
    else
    {
        _S91 = run_2->first_crossing_0;
    }
    bool _S92;
    if(forwards_0)
    {
        _S92 = run_2->first_crossing_0;
    }
    else
    {
        _S92 = run_2->last_crossing_0;
    }
    float _S93 = cell_4->half_width_1;
    float _S94 = - cell_4->half_width_1;
    bool _S95 = _S89 < _S94;
    bool _S96 = _S89 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S91 = !_S91;
    }
    else
    {
        _S91 = false;
    }
    if(_S91)
    {
        _S91 = !shown_2->hole_3;
    }
    else
    {
        _S91 = false;
    }
    bool _S97;
    if(_S91)
    {
        _S97 = shown_2->on_top_0;
    }
    else
    {
        _S97 = false;
    }
    if(_S97)
    {
        if(_S92)
        {
            _S92 = _S95;
        }
        else
        {
            _S92 = false;
        }
        _S92 = !_S92;
    }
    else
    {
        _S92 = false;
    }
    if(shown_2->hole_3)
    {
        _S91 = true;
    }
    else
    {
        if(_S91)
        {
            _S91 = !shown_2->on_top_0;
        }
        else
        {
            _S91 = false;
        }
    }
    float _S98;
    if(_S95)
    {
        _S98 = _S94;
    }
    else
    {
        _S98 = _S93;
    }
    float _S99 = _S98 - _S89;
    if(_S91)
    {
        _S89 = 2.0f * _S90 + _S89 - _S93;
    }
    else
    {
        _S89 = _S90;
    }
    if(_S92)
    {
        if(forwards_0)
        {
            _S89 = run_2->to_end_0;
        }
        else
        {
            _S89 = run_2->from_start_0;
        }
        return _S89;
    }
    if(_S96)
    {
    }
    else
    {
        _S89 = _S99;
    }
    return _S89;
}

struct Probe_0
{
    float height_2;
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
    float _S100 = previous_1->rate_0;
    float _S101 = previous_1->rate_0 * step_4;
    float _S102 = rate_1 * step_4;
    bool _S103;
    if(!previous_1->known_0)
    {
        _S103 = true;
    }
    else
    {
        _S103 = here_0->hole_4;
    }
    if(_S103)
    {
        _S103 = true;
    }
    else
    {
        _S103 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S103)
    {
        _S103 = true;
    }
    else
    {
        _S103 = _S100 >= 0.0f;
    }
    if(_S103)
    {
        _S103 = true;
    }
    else
    {
        _S103 = rate_1 <= 0.0f;
    }
    if(_S103)
    {
        return -1.0f;
    }
    float _S104 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S101) >= 0.0f)
    {
        _S103 = (3.0f * clearance_1 - _S102) >= 0.0f;
    }
    else
    {
        _S103 = false;
    }
    if(_S103)
    {
        return -1.0f;
    }
    float _S105 = clearance_1 - _S104;
    float _S106 = 6.0f * _S105 - 4.0f * _S101 - 2.0f * _S102;
    float _S107 = -2.0f * _S101 / max(_S106 + sqrt(max(_S106 * _S106 - 4.0f * (3.0f * (_S101 + _S102 - 2.0f * _S105)) * _S101, 0.0f)), 9.99999968265522539e-21f);
    float _S108 = 1.0f - _S107;
    float _S109 = (_S104 * (2.0f * _S107 + 1.0f) + _S101 * _S107) * _S108 * _S108;
    float _S110 = (clearance_1 * (2.0f * _S108 + 1.0f) - _S102 * _S108) * _S107 * _S107;
    if(_S107 > 0.01999999955296516f)
    {
        _S103 = _S108 > 0.01999999955296516f;
    }
    else
    {
        _S103 = false;
    }
    if(_S103)
    {
        _S103 = (_S109 + _S110) < 0.0f;
    }
    else
    {
        _S103 = false;
    }
    float _S111;
    if(_S103)
    {
        _S111 = _S108 * step_4;
    }
    else
    {
        _S111 = -1.0f;
    }
    return _S111;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S112 = here_1->hole_4;
    float _S113;
    if(here_1->hole_4)
    {
        _S113 = 1.0e+09f;
    }
    else
    {
        _S113 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S113;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S114;
    if(!_S112)
    {
        _S114 = !is_cell_exit_0;
    }
    else
    {
        _S114 = false;
    }
    (&previous_2)->known_0 = _S114;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1->per_x_0, side_y_1 * this_1->per_y_0), 0.0f) + this_1->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_2, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S115 = min(here_2->edge_x_0 * this_2->per_x_0, here_2->edge_y_0 * this_2->per_y_0);
    bool _S116;
    if(!here_2->hole_4)
    {
        _S116 = (rate_3 * _S115 + clearance_3) < 0.0f;
    }
    else
    {
        _S116 = false;
    }
    if(_S116)
    {
        _S116 = _S115 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S116 = false;
    }
    float _S117 = this_2->step_2;
    float _S118;
    if(_S116)
    {
        _S118 = _S115 - this_2->epsilon_0;
    }
    else
    {
        _S118 = max(_S115, 0.0f) + this_2->epsilon_0;
    }
    return min(_S117, _S118);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_3, float height_3)
{
    return this_3->origin_0 + this_3->slope_1 * float2(height_3) ;
}

float ViewRay_rate_0(const ViewRay_0 thread* this_4, const Probe_0 thread* here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S119 = end_0 - start_1;
    float _S120 = start_rate_0 + end_rate_0 - 2.0f * _S119;
    float _S121 = 3.0f * _S119 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S119, 9.99999968265522539e-21f);
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
        float _S122 = clamp(share_0 - (((_S120 * share_0 + _S121) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S120 * share_0 + 2.0f * _S121) * share_0 + start_rate_0, 0.10000000149011612f * _S119 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S123 = i_0 + int(1);
        share_0 = _S122;
        i_0 = _S123;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S124 = along_slope_0 * along_slope_0 + 1.0f;
    float _S125 = rsqrt(_S124);
    float _S126 = sine_1 * _S125 * rsqrt(_S124 + across_slope_0 * across_slope_0);
    return float2(- _S126 * _S124, _S126 * across_slope_0 * along_slope_0 + cosine_0 * _S125);
}

float arc_sine_0(float x_3)
{
    float _S127 = abs(x_3);
    bool _S128 = _S127 > 0.5f;
    float _S129;
    if(_S128)
    {
        _S129 = 0.5f * (1.0f - _S127);
    }
    else
    {
        _S129 = _S127 * _S127;
    }
    float _S130;
    if(_S128)
    {
        _S130 = sqrt(max(_S129, 0.0f));
    }
    else
    {
        _S130 = _S127;
    }
    float _S131 = ((((0.04216320067644119f * _S129 + 0.02418131195008755f) * _S129 + 0.04547002539038658f) * _S129 + 0.07495300471782684f) * _S129 + 0.16666752099990845f) * _S129 * _S130 + _S130;
    if(_S128)
    {
        _S129 = 1.57079637050628662f - 2.0f * _S131;
    }
    else
    {
        _S129 = _S131;
    }
    if(x_3 < 0.0f)
    {
        _S129 = - _S129;
    }
    return _S129;
}

float3 table_colour_0(uint index_3, KernelContext_0 thread* kernelContext_12)
{
    float _S132 = table_number_1(index_3, kernelContext_12);
    float _S133 = table_number_1(index_3 + 1U, kernelContext_12);
    float _S134 = table_number_1(index_3 + 2U, kernelContext_12);
    return float3(_S132, _S133, _S134);
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
    float3 _S135 = table_colour_0(row_0, kernelContext_13);
    (&albedos_0)->diffuse_reflect_0 = _S135;
    float3 _S136 = table_colour_0(row_0 + 3U, kernelContext_13);
    (&albedos_0)->diffuse_transmit_0 = _S136;
    float3 _S137 = table_colour_0(row_0 + 6U, kernelContext_13);
    (&albedos_0)->specular_reflect_0 = _S137;
    float3 _S138 = table_colour_0(row_0 + 9U, kernelContext_13);
    (&albedos_0)->specular_transmit_0 = _S138;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_7, KernelContext_0 thread* kernelContext_14)
{
    Albedos_0 _S139 = table_albedos_0(kernelContext_14->families_0[family_8].albedo_table_0 + kernelContext_14->families_0[family_8].albedo_stride_0 * thread_7, kernelContext_14);
    return _S139;
}

uint scramble_0(uint value_0)
{
    uint _S140 = value_0 * 747796405U + 2891336453U;
    uint _S141 = ((_S140 >> ((_S140 >> 28U) + 4U)) ^ _S140) * 277803737U;
    return (_S141 >> 22U) ^ _S141;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_0, float3 albedo_0, float3 room_0)
{
    float3 _S142 = room_0 / max(albedo_0, float3(9.99999997475242708e-07f) );
    return min(gain_0, max(min(min(_S142.x, _S142.y), _S142.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float diffuse_reflection_0(float3 light_0, float3 normal_2, float blend_0)
{
    float _S143 = light_0.z;
    if(_S143 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S143, 0.0f), max(dot(light_0, normal_2), 0.0f), blend_0);
}

float projected_area_1(float3 direction_2, float3 tangent_2, float roughness_1)
{
    float _S144 = dot(direction_2, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S144 * _S144 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_4)
{
    float _S145 = clamp(x_4, -87.0f, 88.0f);
    float _S146 = floor(_S145 * 1.4426950216293335f + 0.5f);
    float _S147 = _S145 - _S146 * 0.693359375f + _S146 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S147 + 0.00139819993637502f) * _S147 + 0.00833345204591751f) * _S147 + 0.04166579619050026f) * _S147 + 0.1666666567325592f) * _S147 + 0.5f;
    float _S148 = (as_type<float>((uint(int(_S146) + int(127)) << 23U)));
    float _S149;
    if(x_4 < -87.0f)
    {
        _S149 = 0.0f;
    }
    else
    {
        _S149 = (p_0 * _S147 * _S147 + _S147 + 1.0f) * _S148;
    }
    return _S149;
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
    float _S150 = roughness_2 * roughness_2;
    float _S151 = squared_along_0 * (1.0f - _S150) + _S150;
    return 0.31830987334251404f * _S150 * roughness_2 / (_S151 * _S151);
}

float density_between_0(float3 light_1, float3 view_0, float3 tangent_3, float roughness_3)
{
    float3 _S152 = light_1 + view_0;
    float _S153 = dot(_S152, tangent_3);
    return flake_density_0(min(_S153 * _S153 / max(square_1(_S152), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float transmission_0(float3 light_2, float3 view_1, float3 normal_3, float3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S154 = - dot(light_2, normal_3);
    float _S155 = dot(view_1, normal_3);
    bool _S156;
    if(_S154 <= 0.0f)
    {
        _S156 = true;
    }
    else
    {
        _S156 = _S155 <= 0.0f;
    }
    if(_S156)
    {
        return 0.0f;
    }
    float _S157 = 1.0f / max(_S155, 9.99999997475242708e-07f);
    float _S158 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S154, 9.99999997475242708e-07f);
    float _S159 = projected_area_1(view_1, tangent_4, roughness_4) * _S157;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S158, _S159)) * mean_attenuation_0(optical_depth_1 * abs(_S158 - _S159)) * _S157;
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_4, float3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S160 = dot(light_3, normal_4);
    bool _S161;
    if(_S160 <= 0.0f)
    {
        _S161 = true;
    }
    else
    {
        _S161 = (dot(view_2, normal_4)) <= 0.0f;
    }
    if(_S161)
    {
        return 0.0f;
    }
    float _S162 = max(_S160, 9.99999997475242708e-07f);
    float _S163 = max(dot(view_2, normal_4), 9.99999997475242708e-07f);
    float _S164 = projected_area_1(light_3, tangent_5, roughness_5) * _S163 + projected_area_1(view_2, tangent_5, roughness_5) * _S162;
    float _S165 = optical_depth_2 * _S164 / (_S162 * _S163);
    return 0.25f * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S165 * mean_attenuation_0(_S165)) * _S162 / _S164;
}

Components_0 with_added_0(const Components_0 thread* sums_0, const Components_0 thread* more_0, float weight_0)
{
    thread Components_0 result_0;
    (&result_0)->diffuse_warp_0 = sums_0->diffuse_warp_0 + weight_0 * more_0->diffuse_warp_0;
    (&result_0)->diffuse_weft_0 = sums_0->diffuse_weft_0 + weight_0 * more_0->diffuse_weft_0;
    (&result_0)->specular_warp_0 = sums_0->specular_warp_0 + weight_0 * more_0->specular_warp_0;
    (&result_0)->specular_weft_0 = sums_0->specular_weft_0 + weight_0 * more_0->specular_weft_0;
    (&result_0)->light_visibility_0 = sums_0->light_visibility_0 + weight_0 * more_0->light_visibility_0;
    (&result_0)->hole_2 = sums_0->hole_2 + weight_0 * more_0->hole_2;
    return result_0;
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
    float _S166 = abs(x_6);
    float _S167 = abs(y_1);
    float angle_0 = arc_tangent_of_ratio_0(min(_S166, _S167) / max(max(_S166, _S167), 1.00000000317107685e-30f));
    float angle_1;
    if(_S167 > _S166)
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
    float _S168 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    float _S169 = floor(_S168);
    float _S170 = _S168 - _S169;
    float _S171 = sqrt(clamp((1.0f - abs(direction_3.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S172 = 7.0f * _S171 * sqrt(_S171);
    float _S173 = min(floor(_S172), 6.0f);
    float _S174 = _S172 - _S173;
    uint _S175 = uint(int(_S169) + int(32)) % 32U;
    uint _S176 = uint(_S173);
    uint _S177 = _S175 * 8U + _S176;
    uint _S178 = (_S175 + 1U) % 32U * 8U + _S176;
    thread NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = uint4(_S177, _S177 + 1U, _S178, _S178 + 1U);
    float _S179 = 1.0f - _S170;
    float _S180 = 1.0f - _S174;
    uint4 _S181 = uint4(float4(_S179 * _S180, _S179 * _S174, _S170 * _S180, _S170 * _S174) * float4(252.0f)  + float4(0.5f) );
    (&taps_0)->weights_0 = _S181;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S181.x + _S181.y + _S181.z + _S181.w);
    return taps_0;
}

float3 half_vector_0(float3 light_4, float3 view_3)
{
    float3 _S182 = light_4 + view_3;
    return _S182 * float3(rsqrt(max(square_1(_S182), 9.999999960041972e-13f))) ;
}

float3 shadow_correlation_0(float3 light_5, float3 view_4)
{
    float2 _S183 = light_5.xy;
    float2 _S184 = view_4.xy;
    float _S185 = dot(_S183, _S184) / max(sqrt(dot(_S183, _S183) * dot(_S184, _S184)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return float3(float2((-0.09000000357627869f + -0.07999999821186066f * _S185)) , 0.0f);
    }
    return float3(min(0.62000000476837158f + 0.62999999523162842f * _S185, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16U), float(odd_0 >> 16U));
}

float4 interpolate_0(const NodeTaps_0 thread* taps_1, uint4 packs_1)
{
    uint4 _S186 = uint4(16711935U) ;
    uint4 _S187 = (packs_1 & _S186) * taps_1->weights_0;
    uint4 _S188 = ((packs_1 >> (uint4(8U) )) & _S186) * taps_1->weights_0;
    return bytes_of_sums_0(_S187.x + _S187.y + _S187.z + _S187.w, _S188.x + _S188.y + _S188.z + _S188.w) * float4(taps_1->inverse_sum_0) ;
}

float4 interpolate_table_0(const NodeTaps_0 thread* taps_2, uint table_0, uint stride_0, KernelContext_0 thread* kernelContext_15)
{
    uint4 _S189 = uint4(table_0)  + taps_2->nodes_0 * uint4(stride_0) ;
    float4 _S190 = interpolate_0(taps_2, uint4(kernelContext_15->words_0[_S189.x], kernelContext_15->words_0[_S189.y], kernelContext_15->words_0[_S189.z], kernelContext_15->words_0[_S189.w]));
    return _S190;
}

struct Group_0
{
    float3 normal_5;
    float weight_1;
    float3 tangent_6;
    float3 variance_0;
    float3 covariance_0;
    float roughness_6;
};

Group_0 group_at_0(uint row_1, float roughness_7, KernelContext_0 thread* kernelContext_16)
{
    thread Group_0 group_0;
    float _S191 = table_number_0(row_1, kernelContext_16);
    float _S192 = table_number_0(row_1 + 1U, kernelContext_16);
    float _S193 = table_number_0(row_1 + 2U, kernelContext_16);
    (&group_0)->normal_5 = float3(_S191, _S192, _S193);
    float _S194 = table_number_0(row_1 + 3U, kernelContext_16);
    (&group_0)->weight_1 = _S194;
    float _S195 = table_number_0(row_1 + 4U, kernelContext_16);
    float _S196 = table_number_0(row_1 + 5U, kernelContext_16);
    float _S197 = table_number_0(row_1 + 6U, kernelContext_16);
    float3 _S198 = float3(_S195, _S196, _S197);
    (&group_0)->tangent_6 = _S198;
    float _S199 = table_number_0(row_1 + 7U, kernelContext_16);
    float _S200 = table_number_0(row_1 + 8U, kernelContext_16);
    (&group_0)->variance_0 = float3(_S199, _S200, 1.0f - square_1(_S198) - _S199 - _S200);
    float _S201 = table_number_0(row_1 + 9U, kernelContext_16);
    float _S202 = table_number_0(row_1 + 10U, kernelContext_16);
    float _S203 = table_number_0(row_1 + 11U, kernelContext_16);
    (&group_0)->covariance_0 = float3(_S201, _S202, _S203);
    (&group_0)->roughness_6 = roughness_7;
    return group_0;
}

float2 visibility_gain_0(float3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * float2((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f))  + float2(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), float2(0.0f) );
}

float Group_variance_along_0(const Group_0 thread* this_5, float3 direction_4)
{
    float _S204 = direction_4.x;
    float _S205 = direction_4.y;
    float _S206 = direction_4.z;
    return max(dot(this_5->variance_0, direction_4 * direction_4) + 2.0f * dot(this_5->covariance_0, float3(_S204 * _S205, _S204 * _S206, _S205 * _S206)), 0.0f);
}

float mean_area_0(const Group_0 thread* group_1, float3 direction_5)
{
    float _S207 = dot(direction_5, group_1->tangent_6);
    float _S208 = _S207 * _S207;
    float _S209 = Group_variance_along_0(group_1, direction_5);
    float _S210 = group_1->roughness_6 * group_1->roughness_6;
    return sqrt(max((_S210 - 1.0f) * (_S208 + _S209) + 1.0f, _S210));
}

float mean_density_0(const Group_0 thread* group_2, float3 half_0)
{
    float _S211 = group_2->roughness_6;
    float _S212 = max(sqrt(max(1.0f - group_2->roughness_6 * group_2->roughness_6, 0.0f)) / group_2->roughness_6, 0.00100000004749745f);
    float _S213 = Group_variance_along_0(group_2, half_0);
    float _S214 = max(sqrt(3.0f * _S213), _S211 * 0.01999999955296516f + 0.00009999999747379f);
    float _S215 = dot(half_0, group_2->tangent_6);
    float _S216 = _S212 * (_S215 - _S214);
    float _S217 = _S212 * (_S215 + _S214);
    float _S218 = _S216 * _S217;
    float _S219 = 2.0f * _S214 * _S212;
    return 0.15915493667125702f / _S211 * ((1.0f - _S218) / ((_S216 * _S216 + 1.0f) * (_S217 * _S217 + 1.0f)) + arc_tangent_0(_S219, 1.0f + _S218) / _S219);
}

float layer_value_0(const Group_0 thread* group_3, float3 half_1, float3 light_6, float3 view_5, float optical_depth_3)
{
    bool _S220 = (light_6.z) < 0.0f;
    float3 _S221 = group_3->normal_5;
    float _S222 = dot(light_6, group_3->normal_5);
    float _S223;
    if(_S220)
    {
        _S223 = - _S222;
    }
    else
    {
        _S223 = _S222;
    }
    float _S224 = max(_S223, 0.01999999955296516f);
    float _S225 = max(dot(view_5, _S221), 0.01999999955296516f);
    float _S226 = mean_area_0(group_3, light_6);
    float _S227 = _S226 / _S224;
    float _S228 = mean_area_0(group_3, view_5);
    float _S229 = _S228 / _S225;
    if(_S220)
    {
        _S223 = abs(_S227 - _S229);
    }
    else
    {
        _S223 = _S227 + _S229;
    }
    float _S230 = optical_depth_3 * max(_S223, 0.00100000004749745f);
    if(_S220)
    {
        _S223 = exponential_0(- optical_depth_3 * min(_S227, _S229));
    }
    else
    {
        _S223 = 1.0f;
    }
    float _S231 = optical_depth_3 * _S223 * (1.0f - exponential_0(- _S230)) / _S230 / _S225;
    if(_S220)
    {
        _S223 = 1.0f;
    }
    else
    {
        _S223 = 1.0f - 0.34999999403953552f * (1.0f - square_1(_S221));
    }
    float _S232 = mean_density_0(group_3, half_1);
    return 0.25f * _S232 * _S223 * _S231;
}

struct Bound_0
{
    uint thread_11;
    float turns_2;
    float cell_7;
    float visible_0;
    float width_0;
    float gap_0;
};

Bound_0 bound_at_0(uint family_9, float position_4, KernelContext_0 thread* kernelContext_17)
{
    Cell_0 _S233 = locate_0(family_9, position_4, kernelContext_17);
    float _S234 = table_number_0(kernelContext_17->families_0[family_9].before_0 + 2U * _S233.thread_0 + 1U, kernelContext_17);
    thread Bound_0 bound_0;
    (&bound_0)->thread_11 = _S233.thread_0;
    (&bound_0)->turns_2 = round((position_4 - kernelContext_17->families_0[family_9].start_0 - _S234 - _S233.below_0) * kernelContext_17->families_0[family_9].inverse_period_0);
    (&bound_0)->cell_7 = _S233.below_0;
    float _S235 = 2.0f * _S233.half_width_1;
    (&bound_0)->width_0 = _S235;
    (&bound_0)->visible_0 = clamp((_S233.across_2 + _S233.half_width_1) / _S235, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S233.below_0, _S233.below_0 - _S233.across_2 - _S233.half_width_1) + max(_S233.across_2 - _S233.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1, KernelContext_0 thread* kernelContext_18)
{
    float _S236 = centre_1 - floor((centre_1 - kernelContext_18->families_0[family_10].start_0) * kernelContext_18->families_0[family_10].inverse_period_0) * kernelContext_18->families_0[family_10].period_0;
    float _S237 = 0.5f * max(size_1, kernelContext_18->families_0[family_10].smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S238 = bound_at_0(family_10, _S236 - _S237, kernelContext_18);
    (&stretch_0)->low_0 = _S238;
    Bound_0 _S239 = bound_at_0(family_10, _S236 + _S237, kernelContext_18);
    (&stretch_0)->high_0 = _S239;
    return stretch_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

float3 lengths_0(uint family_11, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_19)
{
    float _S240 = Stretch_turns_0(stretch_1);
    uint _S241 = kernelContext_19->families_0[family_11].before_0 + 2U * (&stretch_1->low_0)->thread_11;
    uint _S242 = kernelContext_19->families_0[family_11].before_0 + 2U * (&stretch_1->high_0)->thread_11;
    float _S243 = table_number_0(_S242, kernelContext_19);
    float _S244 = table_number_0(_S241, kernelContext_19);
    float _S245 = _S243 - _S244;
    float _S246 = table_number_0(_S242 + 1U, kernelContext_19);
    float _S247 = table_number_0(_S241 + 1U, kernelContext_19);
    float _S248 = _S246 - _S247;
    return float3(_S245 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_0 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_0 + _S240 * kernelContext_19->families_0[family_11].visible_total_0, _S248 - _S245 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0 + _S240 * (kernelContext_19->families_0[family_11].period_0 - kernelContext_19->families_0[family_11].visible_total_0), _S248 + (&stretch_1->high_0)->cell_7 - (&stretch_1->low_0)->cell_7 + _S240 * kernelContext_19->families_0[family_11].period_0);
}

float2 integrals_along_0(uint family_12, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_20)
{
    Family_0 _S249 = kernelContext_20->families_0[family_12];
    uint _S250 = 3U * _S249.quantities_0;
    uint _S251 = kernelContext_20->families_0[family_12].colour_threads_0 + _S250 * (&stretch_2->low_0)->thread_11 + quantity_0;
    uint _S252 = kernelContext_20->families_0[family_12].colour_threads_0 + _S250 * (&stretch_2->high_0)->thread_11 + quantity_0;
    uint _S253 = kernelContext_20->families_0[family_12].colour_threads_0 + _S250 * uint(kernelContext_20->families_0[family_12].count_0) + quantity_0;
    float _S254 = table_number_0(_S251, kernelContext_20);
    float _S255 = table_number_0(_S252, kernelContext_20);
    float _S256 = Stretch_turns_0(stretch_2);
    float _S257 = table_number_0(_S252 + _S249.quantities_0, kernelContext_20);
    float _S258 = table_number_0(_S251 + _S249.quantities_0, kernelContext_20);
    float _S259 = _S257 - _S258 + _S255 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_0 - _S254 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_0;
    float _S260 = table_number_0(_S253 + _S249.quantities_0, kernelContext_20);
    float _S261 = _S259 + _S256 * _S260;
    uint _S262 = 2U * _S249.quantities_0;
    float _S263 = table_number_0(_S252 + _S262, kernelContext_20);
    float _S264 = table_number_0(_S251 + _S262, kernelContext_20);
    float _S265 = _S263 - _S264 + _S255 * (&stretch_2->high_0)->cell_7 - _S254 * (&stretch_2->low_0)->cell_7;
    float _S266 = table_number_0(_S253 + _S262, kernelContext_20);
    return float2(_S261, _S265 + _S256 * _S266);
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
    uint _S267 = entries_0.z;
    uint _S268 = entries_0.x;
    uint _S269 = _S267 - _S268;
    bool _S270 = Stretch_wraps_1(this_9);
    uint _S271;
    if(_S270)
    {
        _S271 = whole_0;
    }
    else
    {
        _S271 = 0U;
    }
    return uint4(_S269 + _S271, entries_0.w - _S267, entries_0.y - _S268, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_4, uint row_2, uint count_2, uint quantities_1, KernelContext_0 thread* kernelContext_21)
{
    uint _S272 = row_2 + (&across_4->low_0)->thread_11 * quantities_1;
    uint _S273 = row_2 + (&across_4->high_0)->thread_11 * quantities_1;
    uint4 _S274 = Stretch_differences_0(across_4, uint4(kernelContext_21->words_0[_S272], kernelContext_21->words_0[_S272 + quantities_1], kernelContext_21->words_0[_S273], kernelContext_21->words_0[_S273 + quantities_1]), kernelContext_21->words_0[row_2 + count_2 * quantities_1]);
    return _S274;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_10)
{
    float _S275 = (&this_10->high_0)->visible_0;
    float _S276 = - (&this_10->low_0)->visible_0;
    float _S277 = Stretch_turns_0(this_10);
    bool _S278 = Stretch_wraps_0(this_10);
    float _S279;
    if(_S278)
    {
        _S279 = 1.0f;
    }
    else
    {
        _S279 = 0.0f;
    }
    return float4(1.0f, _S275, _S276, _S277 - _S279);
}

float integral_on_top_0(uint family_13, const Stretch_0 thread* across_5, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_22)
{
    uint _S280 = uint(kernelContext_22->families_0[family_13].count_0);
    uint _S281 = (_S280 + 1U) * kernelContext_22->families_0[family_13].quantities_0;
    uint _S282 = kernelContext_22->families_0[family_13].colour_areas_0 + quantity_1;
    uint _S283 = (&along_0->low_0)->thread_11;
    uint4 _S284 = row_differences_0(across_5, _S282 + (&along_0->low_0)->thread_11 * _S281, _S280, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S285 = row_differences_0(across_5, _S282 + (_S283 + 1U) * _S281, _S280, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint _S286 = (&along_0->high_0)->thread_11;
    uint4 _S287 = row_differences_0(across_5, _S282 + (&along_0->high_0)->thread_11 * _S281, _S280, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S288 = row_differences_0(across_5, _S282 + (_S286 + 1U) * _S281, _S280, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S289 = row_differences_0(across_5, _S282 + crossing_count_0 * _S281, _S280, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S290 = _S287 - _S284;
    bool _S291 = Stretch_wraps_0(along_0);
    uint4 _S292;
    if(_S291)
    {
        _S292 = _S289;
    }
    else
    {
        _S292 = uint4(int4(int(0)) );
    }
    uint4 _S293 = _S290 + _S292;
    float4 _S294 = Stretch_weights_0(across_5);
    float4 _S295 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S293)), _S294), dot(float4(int4(_S288 - _S287)), _S294), dot(float4(int4(_S285 - _S284)), _S294), dot(float4(int4(_S289)), _S294)), _S295) * kernelContext_22->families_0[family_13].area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_2, uint row_3, KernelContext_0 thread* kernelContext_23)
{
    Albedos_0 _S296 = table_albedos_0(row_3, kernelContext_23);
    thread Albedos_0 sum_0;
    float3 _S297 = float3(weight_2) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S297 * _S296.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S297 * _S296.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S297 * _S296.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S297 * _S296.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, const Stretch_0 thread* own_1, const Stretch_0 thread* other_2, bool back_3, KernelContext_0 thread* kernelContext_24)
{
    Albedos_0 _S298 = table_albedos_0(kernelContext_24->families_0[family_14].colour_mean_0, kernelContext_24);
    thread Albedos_0 albedos_2 = _S298;
    if((kernelContext_24->families_0[family_14].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S299 = lengths_0(crossing_1, other_2, kernelContext_24);
    bool is_exposed_0 = false;
    float weight_3 = 0.0f;
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
        float2 _S300 = integrals_along_0(family_14, own_1, quantity_2, kernelContext_24);
        float _S301 = integral_on_top_0(family_14, own_1, other_2, uint(kernelContext_24->families_0[crossing_1].count_0), quantity_2, kernelContext_24);
        float _S302 = _S300.x;
        float _S303 = _S302 * _S299.x;
        float _S304;
        if(back_3)
        {
            _S304 = _S303 - _S301;
        }
        else
        {
            _S304 = _S301;
        }
        bool _S305 = quantity_2 == 0U;
        if(_S305)
        {
            is_exposed_0 = _S304 > (16.0f * kernelContext_24->families_0[family_14].area_unit_0 * min(_S303 / kernelContext_24->families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S303);
        }
        float _S306 = _S302 * _S299.y;
        float _S307;
        if(is_exposed_0)
        {
            _S307 = _S304;
        }
        else
        {
            _S307 = 0.0f;
        }
        float _S308 = _S306 + _S307 + 0.000244140625f * _S299.z * _S300.y;
        if(_S305)
        {
            weight_3 = 1.0f / max(_S308, 9.99999968265522539e-21f);
        }
        else
        {
            float _S309 = _S308 * weight_3;
            uint _S310 = kernelContext_24->families_0[family_14].colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S311 = albedos_2;
            Albedos_0 _S312 = with_added_albedos_0(&_S311, _S309, _S310, kernelContext_24);
            albedos_2 = _S312;
        }
        quantity_2 = quantity_2 + 1U;
    }
    (&albedos_2)->diffuse_reflect_0 = saturate((&albedos_2)->diffuse_reflect_0);
    (&albedos_2)->diffuse_transmit_0 = saturate((&albedos_2)->diffuse_transmit_0);
    (&albedos_2)->specular_reflect_0 = saturate((&albedos_2)->specular_reflect_0);
    (&albedos_2)->specular_transmit_0 = saturate((&albedos_2)->specular_transmit_0);
    return albedos_2;
}

Albedos_0 lerp_albedos_0(const Albedos_0 thread* first_2, const Albedos_0 thread* second_1, float weight_4)
{
    thread Albedos_0 albedos_3;
    float3 _S313 = float3(weight_4) ;
    (&albedos_3)->diffuse_reflect_0 = mix(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S313);
    (&albedos_3)->diffuse_transmit_0 = mix(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S313);
    (&albedos_3)->specular_reflect_0 = mix(first_2->specular_reflect_0, second_1->specular_reflect_0, _S313);
    (&albedos_3)->specular_transmit_0 = mix(first_2->specular_transmit_0, second_1->specular_transmit_0, _S313);
    return albedos_3;
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
    float _S314 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S315 = 2.0f * sqrt(_S314) - 1.0f;
    float _S316 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S315, _S316), 0.00999999977648258f, 1.0f), clamp((1.0f - _S314) * sheen_shear_0(_S315, _S316), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S315, _S316), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_7, float3 view_6, float scale_0, float shear_0)
{
    float _S317 = light_7.z;
    bool _S318;
    if(_S317 <= 0.0f)
    {
        _S318 = true;
    }
    else
    {
        _S318 = (view_6.z) <= 0.0f;
    }
    if(_S318)
    {
        return 0.0f;
    }
    float2 _S319 = view_6.xy;
    float _S320 = dot(_S319, _S319);
    float2 _S321;
    if(_S320 > 9.99999968265522539e-21f)
    {
        _S321 = _S319 * float2(rsqrt(_S320)) ;
    }
    else
    {
        _S321 = float2(1.0f, 0.0f);
    }
    float _S322 = scale_0 * dot(light_7.xy, _S321) + shear_0 * _S317;
    float _S323 = scale_0 * (light_7.y * _S321.x - light_7.x * _S321.y);
    float _S324 = _S322 * _S322 + _S323 * _S323 + _S317 * _S317;
    return 0.31830987334251404f * scale_0 * scale_0 * _S317 / max(_S324 * _S324, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_8, float3 view_7, float strength_0, float roughness_9)
{
    float3 _S325 = sheen_lobe_0(view_7.z, roughness_9);
    float _S326 = strength_0 * _S325.z;
    return float2(_S326 * transformed_cosine_0(light_8, view_7, _S325.x, _S325.y), 1.0f - _S326);
}

struct FamilyAlbedos_0
{
    Albedos_0 warp_2;
    Albedos_0 weft_2;
};

struct Estimate_0
{
    Components_0 components_0;
    FamilyAlbedos_0 albedos_4;
};

struct Regime_0
{
    float prefiltered_0;
    float threads_1;
    float points_0;
};

Regime_0 regime_of_0(uint _S327, const Footprint_0 thread* _S328, float _S329, KernelContext_0 thread* kernelContext_25)
{
    Fabric_0 device* _S330 = kernelContext_25->fabrics_0+_S327;
    float _S331 = Footprint_spread_side_0(_S328);
    float _S332 = clamp((binary_logarithm_0(max(_S331, 9.99999971718068537e-10f)) - _S330->lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    thread Regime_0 regime_0;
    float _S333 = _S332 * _S332 * (3.0f - 2.0f * _S332);
    (&regime_0)->prefiltered_0 = _S333;
    (&regime_0)->threads_1 = _S331 * _S330->lobes_0.threads_per_mm_0;
    float _S334 = mix(max(8.0f / _S329, 1.0f), 1.0f, _S333);
    float _S335;
    if(_S333 < 1.0f)
    {
        _S335 = clamp((&regime_0)->threads_1 * 12.0f, 1.0f, _S334);
    }
    else
    {
        _S335 = 0.0f;
    }
    (&regime_0)->points_0 = _S335;
    return regime_0;
}

struct Hit_0
{
    float x_10;
    float y_5;
    bool hole_5;
    float height_4;
};

struct Sample_0
{
    Crossing_0 crossing_2;
    Shown_0 shown_3;
    Run_0 run_3;
    Section_0 section_1;
    float height_5;
    float slope_across_0;
    float slope_along_0;
    float slope_x_1;
    float slope_y_1;
};

Crossing_0 crossing_at_0(uint _S336, float _S337, float _S338, bool _S339, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S340 = kernelContext_26->fabrics_0+_S336;
    thread Crossing_0 crossing_3;
    Cell_0 _S341 = locate_0(_S340->warp_0, _S337, kernelContext_26);
    (&crossing_3)->warp_1 = _S341;
    Cell_0 _S342 = locate_0(_S340->weft_0, _S338, kernelContext_26);
    (&crossing_3)->weft_1 = _S342;
    uint _S343 = _S340->run_words_0 + 2U * ((&(&crossing_3)->weft_1)->thread_0 * _S340->ends_1 + (&(&crossing_3)->warp_1)->thread_0);
    uint _S344 = kernelContext_26->words_0[_S343];
    (&crossing_3)->warp_word_0 = _S344;
    (&crossing_3)->weft_word_0 = kernelContext_26->words_0[_S343 + 1U];
    (&crossing_3)->warp_above_0 = ((_S344 & 1U) == 1U) != _S339;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S345, float _S346, float _S347, bool _S348, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S349 = kernelContext_27->fabrics_0+_S345;
    thread Sample_0 sample_0;
    Crossing_0 _S350 = crossing_at_0(_S345, _S346, _S347, _S348, kernelContext_27);
    (&sample_0)->crossing_2 = _S350;
    thread Crossing_0 _S351 = _S350;
    Shown_0 _S352 = shown_at_0(&_S351, _S348);
    (&sample_0)->shown_3 = _S352;
    uint _S353;
    if(_S352.is_warp_2)
    {
        _S353 = _S349->warp_0;
    }
    else
    {
        _S353 = _S349->weft_0;
    }
    uint _S354;
    if(_S352.is_warp_2)
    {
        _S354 = _S349->weft_0;
    }
    else
    {
        _S354 = _S349->warp_0;
    }
    thread Cell_0 _S355 = (&(&sample_0)->crossing_2)->warp_1;
    thread Cell_0 _S356 = (&(&sample_0)->crossing_2)->weft_1;
    Cell_0 _S357 = select_cell_0(_S352.is_warp_2, &_S355, &_S356);
    thread Cell_0 _S358 = (&(&sample_0)->crossing_2)->weft_1;
    thread Cell_0 _S359 = (&(&sample_0)->crossing_2)->warp_1;
    Cell_0 _S360 = select_cell_0(_S352.is_warp_2, &_S358, &_S359);
    thread Cell_0 _S361 = _S360;
    Run_0 _S362 = unpack_0(_S353, _S354, _S357.thread_0, &_S361, _S352.word_0, kernelContext_27);
    thread Cell_0 _S363 = _S357;
    Section_0 _S364 = section_at_0(&_S363);
    bool _S365;
    if(_S352.on_top_0)
    {
        _S365 = (_S362.distance_0) < (_S364.drop_0 * _S362.bend_1.sine_0);
    }
    else
    {
        _S365 = false;
    }
    bool _S366;
    if(_S352.on_top_0)
    {
        _S366 = !_S365;
    }
    else
    {
        _S366 = false;
    }
    float _S367;
    if(_S366)
    {
        _S367 = 1.0f;
    }
    else
    {
        _S367 = -1.0f;
    }
    float _S368;
    if(_S365)
    {
        _S368 = _S362.other_reach_0;
    }
    else
    {
        _S368 = _S362.reach_0;
    }
    float _S369;
    if(_S365)
    {
        _S369 = _S368 + _S362.distance_0;
    }
    else
    {
        _S369 = max(_S368 - _S362.distance_0, 0.0f);
    }
    float _S370 = _S368 / _S362.bend_1.sine_0 - _S367 * _S364.drop_0;
    float _S371 = _S369 * _S369;
    float _S372 = max(_S370 * _S370 - _S371, 9.99999968265522539e-21f);
    float _S373 = rsqrt(_S372);
    float _S374 = _S371 / (_S372 * _S373 + _S370);
    bool _S375 = _S369 > 0.0f;
    float _S376;
    if(_S352.on_top_0)
    {
        _S376 = 1.0f;
    }
    else
    {
        _S376 = -1.0f;
    }
    float _S377;
    if(_S362.near_start_0)
    {
        _S377 = 1.0f;
    }
    else
    {
        _S377 = -1.0f;
    }
    float _S378 = _S376 * _S377;
    if(_S375)
    {
        _S376 = _S370 * _S373;
    }
    else
    {
        _S376 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S364.slope_0 * _S376;
    if(_S375)
    {
        _S369 = _S378 * _S369 * _S373;
    }
    else
    {
        _S369 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S369;
    Family_0 _S379 = kernelContext_27->families_0[_S353];
    thread Shown_0 _S380 = _S352;
    thread Run_0 _S381 = _S362;
    thread Cell_0 _S382 = _S360;
    float2 _S383 = dive_0(_S354, &_S380, &_S381, &_S382, kernelContext_27);
    if(_S362.straight_0)
    {
        _S367 = 0.0f;
    }
    else
    {
        _S367 = _S379.height_scale_0 * _S367;
    }
    (&sample_0)->height_5 = _S367 * (_S368 * _S362.bend_1.half_tangent_0 - _S374) - _S379.height_scale_0 * _S364.drop_0 - _S383.x;
    float _S384 = _S379.height_scale_0 * (&sample_0)->slope_across_0;
    float _S385 = _S379.height_scale_0 * (&sample_0)->slope_along_0 - _S383.y;
    if(_S352.is_warp_2)
    {
        _S367 = _S384;
    }
    else
    {
        _S367 = _S385;
    }
    (&sample_0)->slope_x_1 = _S367;
    if(_S352.is_warp_2)
    {
        _S367 = _S385;
    }
    else
    {
        _S367 = _S384;
    }
    (&sample_0)->slope_y_1 = _S367;
    (&sample_0)->run_3 = _S362;
    (&sample_0)->section_1 = _S364;
    return sample_0;
}

float steps_per_length_0(uint _S386, const SearchQuality_0 thread* _S387, float3 _S388, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S389 = kernelContext_28->fabrics_0+_S386;
    return max(max(abs(_S388.x) * _S389->threads_per_x_0, abs(_S388.y) * _S389->threads_per_y_0) * _S387->steps_per_thread_0, abs(_S388.z) * _S389->per_relief_0 * _S387->steps_per_relief_0);
}

float cell_maximum_0(uint _S390, const Crossing_0 thread* _S391, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S392 = kernelContext_29->fabrics_0+_S390;
    bool _S393 = _S391->warp_above_0;
    uint _S394;
    if(_S391->warp_above_0)
    {
        _S394 = _S392->warp_0;
    }
    else
    {
        _S394 = _S392->weft_0;
    }
    uint _S395;
    if(_S393)
    {
        _S395 = _S391->warp_word_0;
    }
    else
    {
        _S395 = _S391->weft_word_0;
    }
    return float(_S395 >> 28U) * kernelContext_29->families_0[_S394].height_scale_0 * kernelContext_29->families_0[_S394].level_0;
}

Probe_0 probe_0(uint _S396, float _S397, float _S398, bool _S399, bool _S400, bool _S401, KernelContext_0 thread* kernelContext_30)
{
    Sample_0 _S402 = sample_at_0(_S396, _S397, _S398, _S399, kernelContext_30);
    thread Probe_0 probe_1;
    (&probe_1)->height_2 = _S402.height_5;
    (&probe_1)->hole_4 = _S402.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S402.slope_x_1;
    (&probe_1)->slope_y_0 = _S402.slope_y_1;
    uint _S403;
    if(_S402.shown_3.is_warp_2)
    {
        _S403 = _S402.crossing_2.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S403 = _S402.crossing_2.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S403;
    thread Crossing_0 _S404 = _S402.crossing_2;
    float _S405 = cell_maximum_0(_S396, &_S404, kernelContext_30);
    (&probe_1)->cell_max_0 = _S405;
    float _S406;
    if(_S400)
    {
        _S406 = _S402.crossing_2.warp_1.above_0;
    }
    else
    {
        _S406 = _S402.crossing_2.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S406;
    if(_S401)
    {
        _S406 = _S402.crossing_2.weft_1.above_0;
    }
    else
    {
        _S406 = _S402.crossing_2.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S406;
    bool _S407 = !_S402.shown_3.is_warp_2;
    thread Cell_0 _S408 = _S402.crossing_2.warp_1;
    thread Shown_0 _S409 = _S402.shown_3;
    thread Run_0 _S410 = _S402.run_3;
    float _S411 = outline_distance_0(&_S408, &_S409, &_S410, _S407, _S400);
    (&probe_1)->edge_x_0 = _S411;
    thread Cell_0 _S412 = _S402.crossing_2.weft_1;
    thread Shown_0 _S413 = _S402.shown_3;
    thread Run_0 _S414 = _S402.run_3;
    float _S415 = outline_distance_0(&_S412, &_S413, &_S414, _S402.shown_3.is_warp_2, _S401);
    (&probe_1)->edge_y_0 = _S415;
    return probe_1;
}

bool is_free_0(uint _S416, const SearchQuality_0 thread* _S417, float3 _S418, float3 _S419, bool _S420, float _S421, KernelContext_0 thread* kernelContext_31)
{
    float _S422 = _S419.z;
    if(_S422 <= 0.0f)
    {
        return false;
    }
    float _S423 = _S417->shadow_share_0;
    float _S424 = steps_per_length_0(_S416, _S417, _S419, kernelContext_31);
    float _S425 = 1.0f / max(_S423 * _S424, 9.99999971718068537e-10f);
    StepControl_0 _S426 = step_control_0(_S419.xy, _S425);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S427;
        if(count_3 < 1024U)
        {
            _S427 = (_S418.z + _S422 * distance_1) < _S421;
        }
        else
        {
            _S427 = false;
        }
        if(_S427)
        {
        }
        else
        {
            break;
        }
        float3 _S428 = _S418 + _S419 * float3(distance_1) ;
        Probe_0 _S429 = probe_0(_S416, _S428.x, _S428.y, _S420, _S426.right_0, _S426.up_0, kernelContext_31);
        float _S430 = _S428.z;
        float _S431 = _S430 - _S429.height_2;
        float _S432 = _S422 - _S429.slope_x_0 * _S419.x - _S429.slope_y_0 * _S419.y;
        bool _S433;
        if(!_S429.hole_4)
        {
            _S433 = _S431 < 0.0f;
        }
        else
        {
            _S433 = false;
        }
        if(_S433)
        {
            return false;
        }
        thread PreviousSample_0 _S434 = previous_3;
        thread Probe_0 _S435 = _S429;
        float _S436 = way_back_to_dip_0(&_S434, _S431, _S432, last_step_0, &_S435);
        if(_S436 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S436;
            distance_1 = distance_1 - _S436;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S437 = _S430 > (_S429.cell_max_0);
        thread Probe_0 _S438 = _S429;
        PreviousSample_0 _S439 = after_sample_0(_S431, _S432, &_S438, _S437);
        float last_step_2;
        if(_S437)
        {
            thread StepControl_0 _S440 = _S426;
            float _S441 = StepControl_to_cell_exit_0(&_S440, _S429.side_x_0, _S429.side_y_0);
            last_step_2 = max(_S441, _S425);
        }
        else
        {
            thread StepControl_0 _S442 = _S426;
            thread Probe_0 _S443 = _S429;
            float _S444 = StepControl_to_next_sample_0(&_S442, &_S443, _S431, _S432);
            last_step_2 = _S444;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S439;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S445, const SearchQuality_0 thread* _S446, float _S447, float _S448, float3 _S449, bool _S450, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S451 = kernelContext_32->fabrics_0+_S445;
    Sample_0 _S452 = sample_at_0(_S445, _S447, _S448, _S450, kernelContext_32);
    if(!_S452.shown_3.hole_3)
    {
        return false;
    }
    float3 _S453 = float3(_S447, _S448, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S454;
        if(side_0 < 2U)
        {
            _S454 = passes_0;
        }
        else
        {
            _S454 = false;
        }
        if(_S454)
        {
        }
        else
        {
            break;
        }
        float3 _S455;
        if(side_0 == 0U)
        {
            _S455 = _S449;
        }
        else
        {
            _S455 = float3(- _S449.x, - _S449.y, _S449.z);
        }
        bool _S456 = is_free_0(_S445, _S446, _S453, _S455, _S450 != (side_0 == 1U), _S451->height_high_0, kernelContext_32);
        uint _S457 = side_0 + 1U;
        passes_0 = _S456;
        side_0 = _S457;
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

float max_height_along_0(uint _S458, float _S459, float _S460, float _S461, float3 _S462, bool _S463, KernelContext_0 thread* kernelContext_33)
{
    Fabric_0 device* _S464 = kernelContext_33->fabrics_0+_S458;
    Cell_0 _S465 = locate_0(_S464->warp_0, _S459, kernelContext_33);
    uint _S466 = _S465.thread_0 / 2U;
    Cell_0 _S467 = locate_0(_S464->weft_0, _S460, kernelContext_33);
    uint _S468 = _S467.thread_0 / 2U;
    float _S469 = _S462.x;
    uint _S470;
    if(_S469 > 0.0f)
    {
        _S470 = 1U;
    }
    else
    {
        _S470 = 0U;
    }
    float _S471 = _S462.y;
    uint _S472;
    if(_S471 > 0.0f)
    {
        _S472 = 2U;
    }
    else
    {
        _S472 = 0U;
    }
    uint _S473 = kernelContext_33->words_0[_S464->max_heights_0 + 4U * (_S468 * _S464->max_height_columns_0 + _S466) + (_S470 + _S472)];
    int number_0;
    if(_S463)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S474 = _S473 >> uint(number_0);
    float _S475 = max(abs(_S469) * _S464->threads_per_x_0, abs(_S471) * _S464->threads_per_y_0) / _S462.z;
    float _S476 = _S464->height_high_0;
    float max_height_0 = _S464->height_high_0;
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
        if(((max_height_0 - _S461) * _S475) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S474 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S476);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S477, float _S478, float _S479, bool _S480, bool _S481, bool _S482, KernelContext_0 thread* kernelContext_34)
{
    Crossing_0 _S483 = crossing_at_0(_S477, _S478, _S479, _S480, kernelContext_34);
    thread Crossing_0 _S484 = _S483;
    float _S485 = cell_maximum_0(_S477, &_S484, kernelContext_34);
    float _S486;
    if(_S481)
    {
        _S486 = _S483.warp_1.above_0;
    }
    else
    {
        _S486 = _S483.warp_1.below_0;
    }
    float _S487;
    if(_S482)
    {
        _S487 = _S483.weft_1.above_0;
    }
    else
    {
        _S487 = _S483.weft_1.below_0;
    }
    return float3(_S485, _S486, _S487);
}

float first_sample_height_0(uint _S488, const ViewRay_0 thread* _S489, const StepControl_0 thread* _S490, bool _S491, KernelContext_0 thread* kernelContext_35)
{
    float _S492 = max_height_along_0(_S488, _S489->origin_0.x, _S489->origin_0.y, 0.0f, float3(_S489->slope_1, 1.0f), _S491, kernelContext_35);
    uint count_4 = 0U;
    float height_7 = _S492;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S493 = ViewRay_at_0(_S489, height_7);
        float3 _S494 = cell_bounds_0(_S488, _S493.x, _S493.y, _S491, _S490->right_0, _S490->up_0, kernelContext_35);
        float _S495 = height_7 - _S494.x;
        float _S496 = StepControl_to_cell_exit_0(_S490, _S494.y, _S494.z);
        float height_8 = height_7 - clamp(_S495, 0.0f, _S496);
        if(_S495 <= _S496)
        {
            height_7 = height_8;
            break;
        }
        count_4 = count_4 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S497, const ViewRay_0 thread* _S498, const StepControl_0 thread* _S499, bool _S500, KernelContext_0 thread* kernelContext_36)
{
    Fabric_0 device* _S501 = kernelContext_36->fabrics_0+_S497;
    float _S502 = _S501->height_low_0 - (_S501->height_high_0 - _S501->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S503 = first_sample_height_0(_S497, _S498, _S499, _S500, kernelContext_36);
    (&end_1)->height_6 = _S503;
    (&end_1)->last_step_3 = _S499->epsilon_0;
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
        float2 _S504 = ViewRay_at_0(_S498, (&end_1)->height_6);
        Probe_0 _S505 = probe_0(_S497, _S504.x, _S504.y, _S500, _S499->right_0, _S499->up_0, kernelContext_36);
        float _S506 = (&end_1)->height_6 - _S505.height_2;
        thread Probe_0 _S507 = _S505;
        float _S508 = ViewRay_rate_0(_S498, &_S507);
        (&end_1)->depth_1 = - _S506;
        (&end_1)->rate_4 = _S508;
        bool _S509;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S509 = !_S505.hole_4;
        }
        else
        {
            _S509 = false;
        }
        bool _S510;
        if(_S509)
        {
            _S510 = ((&(&end_1)->previous_4)->yarn_0) == (_S505.yarn_1);
        }
        else
        {
            _S510 = false;
        }
        (&end_1)->smooth_0 = _S510;
        bool _S511;
        if(!_S505.hole_4)
        {
            _S511 = _S506 <= 0.0f;
        }
        else
        {
            _S511 = false;
        }
        bool _S512;
        if(_S511)
        {
            _S512 = true;
        }
        else
        {
            _S512 = ((&end_1)->height_6) <= _S502;
        }
        if(_S512)
        {
            break;
        }
        thread PreviousSample_0 _S513 = (&end_1)->previous_4;
        thread Probe_0 _S514 = _S505;
        float _S515 = way_back_to_dip_0(&_S513, _S506, _S508, (&end_1)->last_step_3, &_S514);
        if(_S515 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S515;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S515;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S516 = StepControl_to_cell_exit_0(_S499, _S505.side_x_0, _S505.side_y_0);
        float _S517 = min(_S516, (&end_1)->height_6 - _S505.cell_max_0);
        thread Probe_0 _S518 = _S505;
        float _S519 = StepControl_to_next_sample_0(_S499, &_S518, _S506, _S508);
        bool _S520 = _S517 > _S519;
        thread Probe_0 _S521 = _S505;
        PreviousSample_0 _S522 = after_sample_0(_S506, _S508, &_S521, _S520);
        (&end_1)->previous_4 = _S522;
        float _S523 = max(_S517, _S519);
        (&end_1)->last_step_3 = _S523;
        (&end_1)->height_6 = (&end_1)->height_6 - _S523;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S524, const ViewRay_0 thread* _S525, const StepControl_0 thread* _S526, bool _S527, const ViewRayEnd_0 thread* _S528, uint _S529, KernelContext_0 thread* kernelContext_37)
{
    Fabric_0 device* _S530 = kernelContext_37->fabrics_0+_S524;
    float _S531 = _S530->height_high_0 - _S530->height_low_0;
    float _S532 = _S528->height_6;
    float _S533 = _S528->last_step_3;
    float above_2 = _S528->height_6 + _S528->last_step_3;
    float above_gap_1 = clamp((&_S528->previous_4)->clearance_0, 0.0f, _S531);
    float under_gap_1 = clamp(_S528->depth_1, 0.0f, _S531);
    float _S534 = cubic_root_0(above_gap_1, - under_gap_1, (&_S528->previous_4)->rate_0 * _S528->last_step_3, _S528->rate_4 * _S528->last_step_3);
    bool _S535 = _S528->smooth_0;
    float middle_0;
    if(_S528->smooth_0)
    {
        middle_0 = above_2 - _S534 * _S533;
    }
    else
    {
        middle_0 = between_0(above_2, _S532, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S532;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S529)
        {
        }
        else
        {
            break;
        }
        float2 _S536 = ViewRay_at_0(_S525, middle_0);
        Probe_0 _S537 = probe_0(_S524, _S536.x, _S536.y, _S527, _S526->right_0, _S526->up_0, kernelContext_37);
        float _S538;
        if(_S537.hole_4)
        {
            _S538 = -1.0e+09f;
        }
        else
        {
            _S538 = _S537.height_2;
        }
        float _S539 = clamp(middle_0 - _S538, - _S531, _S531);
        float _S540;
        if(_S539 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S540 = 0.5f * above_gap_2;
            }
            else
            {
                _S540 = above_gap_2;
            }
            float _S541 = - _S539;
            under_1 = middle_0;
            above_gap_2 = _S540;
            under_gap_2 = _S541;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S540 = 0.5f * under_gap_2;
            }
            else
            {
                _S540 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S539;
            under_gap_2 = _S540;
            side_1 = -1.0f;
        }
        if(_S535)
        {
            thread Probe_0 _S542 = _S537;
            float _S543 = ViewRay_rate_0(_S525, &_S542);
            middle_0 = clamp(middle_0 + _S539 / min(_S543, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S535)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S544, const SearchQuality_0 thread* _S545, float _S546, float _S547, float3 _S548, bool _S549, KernelContext_0 thread* kernelContext_38)
{
    float _S550 = max(_S548.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S546, _S547);
    float2 _S551 = _S548.xy / float2(_S550) ;
    (&ray_0)->slope_1 = _S551;
    float2 _S552 = - _S551;
    float _S553 = steps_per_length_0(_S544, _S545, _S548, kernelContext_38);
    StepControl_0 _S554 = step_control_0(_S552, 1.0f / max(_S553 / _S550, 9.99999971718068537e-10f));
    thread ViewRay_0 _S555 = ray_0;
    thread StepControl_0 _S556 = _S554;
    ViewRayEnd_0 _S557 = search_down_0(_S544, &_S555, &_S556, _S549, kernelContext_38);
    thread Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    thread ViewRay_0 _S558 = ray_0;
    thread StepControl_0 _S559 = _S554;
    thread ViewRayEnd_0 _S560 = _S557;
    float _S561 = refined_height_0(_S544, &_S558, &_S559, _S549, &_S560, _S545->refinements_0, kernelContext_38);
    (&hit_0)->height_4 = _S561;
    thread ViewRay_0 _S562 = ray_0;
    float2 _S563 = ViewRay_at_0(&_S562, _S561);
    (&hit_0)->x_10 = _S563.x;
    (&hit_0)->y_5 = _S563.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S564, const SearchQuality_0 thread* _S565, float _S566, float _S567, float3 _S568, bool _S569, KernelContext_0 thread* kernelContext_39)
{
    bool _S570 = passes_through_0(_S564, _S565, _S566, _S567, _S568, _S569, kernelContext_39);
    if(!_S570)
    {
        Hit_0 _S571 = first_hit_of_yarn_0(_S564, _S565, _S566, _S567, _S568, _S569, kernelContext_39);
        return _S571;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_10 = _S566;
    (&hit_1)->y_5 = _S567;
    (&hit_1)->height_4 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S572, float _S573, float _S574, bool _S575, KernelContext_0 thread* kernelContext_40)
{
    Fabric_0 device* _S576 = kernelContext_40->fabrics_0+_S572;
    Sample_0 _S577 = sample_at_0(_S572, _S573, _S574, _S575, kernelContext_40);
    float _S578;
    if(_S577.shown_3.is_warp_2)
    {
        _S578 = _S577.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S578 = _S577.crossing_2.weft_1.half_width_1;
    }
    uint _S579;
    if(_S577.shown_3.is_warp_2)
    {
        _S579 = _S576->warp_0;
    }
    else
    {
        _S579 = _S576->weft_0;
    }
    Family_0 _S580 = kernelContext_40->families_0[_S579];
    float _S581;
    if(_S575)
    {
        _S581 = -1.0f;
    }
    else
    {
        _S581 = 1.0f;
    }
    float _S582 = _S580.twist_sine_0 * _S581;
    Family_0 _S583 = kernelContext_40->families_0[_S579];
    if(_S577.shown_3.is_warp_2)
    {
        _S581 = 1.0f;
    }
    else
    {
        _S581 = -1.0f;
    }
    float2 _S584 = fibre_direction_0(_S577.slope_across_0, _S581 * _S577.slope_along_0, _S582, _S583.twist_cosine_0);
    float _S585;
    if(_S577.shown_3.is_warp_2)
    {
        _S585 = _S577.slope_x_1;
    }
    else
    {
        _S585 = _S577.slope_y_1;
    }
    float _S586;
    if(_S577.shown_3.is_warp_2)
    {
        _S586 = _S577.slope_y_1;
    }
    else
    {
        _S586 = _S577.slope_x_1;
    }
    float _S587 = _S584.x;
    float _S588 = _S584.y;
    float _S589 = _S585 * _S587 + _S581 * _S586 * _S588;
    float _S590 = _S578 * 1.0154266357421875f;
    float _S591 = _S590 * arc_sine_0(clamp(_S577.section_1.across_3 / _S590, -1.0f, 1.0f));
    if(_S577.shown_3.is_warp_2)
    {
        _S578 = _S574;
    }
    else
    {
        _S578 = - _S573;
    }
    thread SurfacePoint_0 point_0;
    (&point_0)->hole_0 = _S577.shown_3.hole_3;
    (&point_0)->is_warp_0 = _S577.shown_3.is_warp_2;
    (&point_0)->warp_thread_0 = _S577.crossing_2.warp_1.thread_0;
    (&point_0)->weft_thread_0 = _S577.crossing_2.weft_1.thread_0;
    (&point_0)->height_0 = _S577.height_5;
    (&point_0)->normal_0 = normalize(float3(- _S577.slope_x_1, - _S577.slope_y_1, 1.0f));
    float3 _S592;
    if(_S577.shown_3.is_warp_2)
    {
        _S592 = float3(_S587, _S588, _S589);
    }
    else
    {
        _S592 = float3(- _S588, _S587, _S589);
    }
    (&point_0)->tangent_0 = normalize(_S592);
    (&point_0)->across_0 = _S577.section_1.across_3;
    (&point_0)->fibre_across_0 = _S591 * _S583.twist_cosine_0 + _S578 * _S582;
    (&point_0)->fibre_along_0 = _S578 * _S583.twist_cosine_0 - _S591 * _S582;
    return point_0;
}

struct YarnPoint_0
{
    bool back_4;
    bool hole_6;
    bool is_warp_3;
    float x_11;
    float y_6;
    float height_9;
    float3 normal_6;
    float3 tangent_7;
    float roughness_10;
    Albedos_0 albedos_5;
};

Albedos_0 vary_albedos_0(uint _S593, const Albedos_0 thread* _S594, uint _S595, uint _S596, KernelContext_0 thread* kernelContext_41)
{
    Fabric_0 device* _S597 = kernelContext_41->fabrics_0+_S593;
    float3 _S598 = max(_S594->specular_reflect_0, _S594->specular_transmit_0);
    float3 _S599 = _S594->diffuse_reflect_0 + _S594->diffuse_transmit_0;
    float3 _S600 = float3(_S597->layer_bound_0) ;
    float3 _S601 = float3(1.0f) ;
    float3 _S602 = float3(bounded_gain_0(thread_gain_0(_S595, _S597->colour_noise_0, _S597->seed_0), _S599, _S601 - _S600 * _S598)) ;
    float _S603 = bounded_gain_0(fibre_gain_0(_S595, _S596, _S597->fibre_noise_0, _S597->seed_0), _S598, min((_S601 - _S602 * _S599) / _S600, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S602 * _S594->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S602 * _S594->diffuse_transmit_0;
    float3 _S604 = float3(_S603) ;
    (&varied_0)->specular_reflect_0 = _S604 * _S594->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S604 * _S594->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S605, const SurfacePoint_0 thread* _S606, const Albedos_0 thread* _S607, float _S608, float _S609, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S610 = kernelContext_42->fabrics_0+_S605;
    bool _S611 = _S606->is_warp_0;
    float _S612;
    if(_S606->is_warp_0)
    {
        _S612 = _S608;
    }
    else
    {
        _S612 = _S609;
    }
    float _S613 = _S612 - _S606->across_0;
    uint _S614;
    if(_S611)
    {
        _S614 = _S610->warp_0;
    }
    else
    {
        _S614 = _S610->weft_0;
    }
    Family_0 _S615 = kernelContext_42->families_0[_S614];
    int _S616 = int(kernelContext_42->families_0[_S614].count_0);
    if(_S611)
    {
        _S614 = _S606->warp_thread_0;
    }
    else
    {
        _S614 = _S606->weft_thread_0;
    }
    uint _S617 = uint(int(floor(_S613 / _S615.period_0)) * _S616 + int(_S614)) * 2U;
    if(_S611)
    {
        _S614 = 1U;
    }
    else
    {
        _S614 = 0U;
    }
    float _S618 = floor(_S606->fibre_across_0 / _S610->fibre_size_0);
    Albedos_0 _S619 = vary_albedos_0(_S605, _S607, _S617 + _S614, uint(int(_S618)) * 65536U + uint(int(floor(_S606->fibre_along_0 / (_S610->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S618))), kernelContext_42);
    return _S619;
}

YarnPoint_0 yarn_point_of_0(uint _S620, const SurfacePoint_0 thread* _S621, float _S622, float _S623, bool _S624, bool _S625, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S626 = kernelContext_43->fabrics_0+_S620;
    bool _S627 = _S621->is_warp_0;
    uint _S628;
    if(_S621->is_warp_0)
    {
        _S628 = _S626->warp_0;
    }
    else
    {
        _S628 = _S626->weft_0;
    }
    uint _S629;
    if(_S627)
    {
        _S629 = _S621->warp_thread_0;
    }
    else
    {
        _S629 = _S621->weft_thread_0;
    }
    Albedos_0 _S630 = albedos_of_0(_S628, _S629, kernelContext_43);
    bool _S631;
    if((_S626->fibre_noise_0) > 0.0f)
    {
        _S631 = true;
    }
    else
    {
        _S631 = (_S626->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_6;
    if(_S631)
    {
        thread Albedos_0 _S632 = _S630;
        Albedos_0 _S633 = varied_at_0(_S620, _S621, &_S632, _S622, _S623, kernelContext_43);
        albedos_6 = _S633;
    }
    else
    {
        albedos_6 = _S630;
    }
    thread YarnPoint_0 point_1;
    (&point_1)->back_4 = _S624;
    (&point_1)->hole_6 = _S625;
    (&point_1)->is_warp_3 = _S627;
    (&point_1)->x_11 = _S622;
    (&point_1)->y_6 = _S623;
    (&point_1)->height_9 = _S621->height_0;
    (&point_1)->normal_6 = _S621->normal_0;
    (&point_1)->tangent_7 = _S621->tangent_0;
    (&point_1)->roughness_10 = kernelContext_43->families_0[_S628].roughness_0;
    (&point_1)->albedos_5 = albedos_6;
    return point_1;
}

bool unoccluded_0(uint _S634, const SearchQuality_0 thread* _S635, float _S636, float _S637, float _S638, float3 _S639, bool _S640, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S641 = kernelContext_44->fabrics_0+_S634;
    if((_S639.z) <= 0.0f)
    {
        return false;
    }
    float _S642 = max_height_along_0(_S634, _S636, _S637, _S638, _S639, _S640, kernelContext_44);
    bool _S643 = is_free_0(_S634, _S635, float3(_S636, _S637, _S638 + _S641->lift_0), _S639, _S640, _S642, kernelContext_44);
    return _S643;
}

bool is_lit_0(uint _S644, const SearchQuality_0 thread* _S645, const YarnPoint_0 thread* _S646, float3 _S647, KernelContext_0 thread* kernelContext_45)
{
    if(_S646->hole_6)
    {
        return true;
    }
    bool _S648 = _S646->back_4;
    float3 _S649 = to_face_frame_0(_S647, _S646->back_4);
    float _S650 = _S649.z;
    bool _S651 = _S650 < 0.0f;
    float3 _S652 = _S646->normal_6;
    float _S653 = _S646->height_9;
    float3 normal_7;
    float height_10;
    if(_S651)
    {
        SurfacePoint_0 _S654 = surface_at_0(_S644, _S646->x_11, _S646->y_6, !_S648, kernelContext_45);
        normal_7 = _S654.normal_0;
        height_10 = _S654.height_0;
    }
    else
    {
        normal_7 = _S652;
        height_10 = _S653;
    }
    float3 _S655 = float3(_S649.xy, abs(_S650));
    if((dot(normal_7, _S655)) <= 0.0f)
    {
        return false;
    }
    bool _S656 = unoccluded_0(_S644, _S645, _S646->x_11, _S646->y_6, height_10, _S655, _S648 != _S651, kernelContext_45);
    return _S656;
}

Components_0 components_of_point_0(uint _S657, const SearchQuality_0 thread* _S658, const YarnPoint_0 thread* _S659, float3 _S660, float3 _S661, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S662 = kernelContext_46->fabrics_0+_S657;
    thread Components_0 result_1 = no_components_0();
    bool _S663 = _S659->hole_6;
    float _S664;
    if(_S659->hole_6)
    {
        _S664 = 1.0f;
    }
    else
    {
        _S664 = 0.0f;
    }
    (&result_1)->hole_2 = _S664;
    bool _S665;
    if(_S663)
    {
        _S665 = true;
    }
    else
    {
        bool _S666 = is_lit_0(_S657, _S658, _S659, _S660, kernelContext_46);
        _S665 = !_S666;
    }
    if(_S665)
    {
        return result_1;
    }
    float3 _S667 = to_face_frame_0(_S660, _S659->back_4);
    float3 _S668 = to_face_frame_0(_S661, _S659->back_4);
    bool _S669 = (_S667.z) < 0.0f;
    float3 _S670;
    if(_S669)
    {
        _S670 = - _S667;
    }
    else
    {
        _S670 = _S667;
    }
    float3 _S671 = _S659->normal_6;
    float _S672 = diffuse_reflection_0(_S670, _S659->normal_6, _S662->diffuse_blend_0);
    if(_S669)
    {
        _S664 = transmission_0(_S667, _S668, _S671, _S659->tangent_7, _S659->roughness_10, _S662->optical_depth_0);
    }
    else
    {
        _S664 = reflection_0(_S667, _S668, _S671, _S659->tangent_7, _S659->roughness_10, _S662->optical_depth_0);
    }
    bool _S673 = _S659->is_warp_3;
    float _S674;
    if(_S659->is_warp_3)
    {
        _S674 = _S672;
    }
    else
    {
        _S674 = 0.0f;
    }
    (&result_1)->diffuse_warp_0 = _S674;
    if(_S673)
    {
        _S674 = 0.0f;
    }
    else
    {
        _S674 = _S672;
    }
    (&result_1)->diffuse_weft_0 = _S674;
    if(_S673)
    {
        _S674 = _S664;
    }
    else
    {
        _S674 = 0.0f;
    }
    (&result_1)->specular_warp_0 = _S674;
    if(_S673)
    {
        _S664 = 0.0f;
    }
    (&result_1)->specular_weft_0 = _S664;
    (&result_1)->light_visibility_0 = 1.0f;
    return result_1;
}

struct CoverageTaps_0
{
    array<uint, int(9)> nodes_1;
};

float3 pyramid_level_0(uint _S675, float _S676, KernelContext_0 thread* kernelContext_47)
{
    uint _S677 = (kernelContext_47->fabrics_0+_S675)->lobes_0.levels_0 + 4U * uint(min(_S676, (kernelContext_47->fabrics_0+_S675)->lobes_0.last_level_0));
    float _S678 = table_number_0(_S677, kernelContext_47);
    float _S679 = table_number_0(_S677 + 1U, kernelContext_47);
    float _S680 = table_number_0(_S677 + 2U, kernelContext_47);
    return float3(_S678, _S679, _S680);
}

CoverageTaps_0 coverage_taps_0(uint _S681, const Footprint_0 thread* _S682, bool _S683, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S684 = kernelContext_48->fabrics_0+_S681;
    float _S685 = Footprint_spread_side_0(_S682);
    Lobes_0 _S686 = _S684->lobes_0;
    float _S687 = _S685 * _S684->lobes_0.inverse_base_size_0;
    float3 _S688 = pyramid_level_0(_S681, floor(binary_logarithm_0(max(0.68000000715255737f * _S687, 1.0f))), kernelContext_48);
    float _S689 = 1.0f / max(_S687, 9.99999997475242708e-07f);
    float2 _S690 = float2(kernelContext_48->families_0[_S684->warp_0].inverse_period_0, kernelContext_48->families_0[_S684->weft_0].inverse_period_0);
    float2 _S691 = _S682->centre_0 * _S690;
    float2 _S692 = float2(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S689 * _S689), 0.0f, 1.0f)), 0.3333333432674408f * _S689), 1.0f)) ;
    float2 _S693 = _S682->dx_0 * _S690 * _S692;
    float2 _S694 = _S682->dy_0 * _S690 * _S692;
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
        float2 _S695 = _S691 + float2(TAP_OFFSETS_0[number_1].x)  * _S693 + float2(TAP_OFFSETS_0[number_1].y)  * _S694;
        float _S696 = _S688.y;
        float _S697 = wrapped_cell_0(_S695.x, _S696);
        float _S698 = wrapped_cell_0(_S695.y, _S688.z);
        uint _S699;
        if(_S683)
        {
            _S699 = _S686.face_nodes_0;
        }
        else
        {
            _S699 = 0U;
        }
        (&taps_3)->nodes_1[number_1] = _S699 + uint(_S698 * _S696 + _S697 + _S688.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

float4 coverage_of_pack_0(uint _S700, const CoverageTaps_0 thread* _S701, uint _S702, KernelContext_0 thread* kernelContext_49)
{
    Fabric_0 device* _S703 = kernelContext_49->fabrics_0+_S700;
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
        uint _S704 = kernelContext_49->words_0[_S703->lobes_0.coverage_0 + _S701->nodes_1[number_2] * _S703->lobes_0.packs_0 + _S702];
        uint even_2 = even_1 + (_S704 & 16711935U);
        uint odd_2 = odd_1 + ((_S704 >> 8U) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / float4(9.0f) ;
}

float coverage_of_holes_0(uint _S705, const CoverageTaps_0 thread* _S706, KernelContext_0 thread* kernelContext_50)
{
    Fabric_0 device* _S707 = kernelContext_50->fabrics_0+_S705;
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
        uint total_1 = total_0 + ((kernelContext_50->words_0[_S707->lobes_0.coverage_holes_0 + _S706->nodes_1[number_3] / 4U] >> (8U * (_S706->nodes_1[number_3] % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S708, const CoverageTaps_0 thread* _S709, const NodeTaps_0 thread* _S710, bool _S711, KernelContext_0 thread* kernelContext_51)
{
    Lobes_0 _S712 = (kernelContext_51->fabrics_0+_S708)->lobes_0;
    float4 _S713 = interpolate_table_0(_S710, (kernelContext_51->fabrics_0+_S708)->lobes_0.projected_area_0 + (kernelContext_51->fabrics_0+_S708)->lobes_0.packs_0, (kernelContext_51->fabrics_0+_S708)->lobes_0.packs_0 + 1U, kernelContext_51);
    float _S714 = _S713.x;
    float _S715;
    if(_S711)
    {
        _S715 = _S712.back_hole_weight_0;
    }
    else
    {
        _S715 = _S712.front_hole_weight_0;
    }
    float _S716 = coverage_of_holes_0(_S708, _S709, kernelContext_51);
    return min(_S716 * _S714 * _S714 * _S715, 1.0f);
}

Components_0 prefiltered_components_0(uint _S717, const Footprint_0 thread* _S718, float3 _S719, float3 _S720, bool _S721, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S722 = kernelContext_52->fabrics_0+_S717;
    CoverageTaps_0 _S723 = coverage_taps_0(_S717, _S718, _S721, kernelContext_52);
    NodeTaps_0 _S724 = node_taps_0(_S720);
    thread NodeTaps_0 view_nodes_0 = _S724;
    thread NodeTaps_0 light_nodes_0 = node_taps_0(_S719);
    thread NodeTaps_0 seen_nodes_0 = _S724;
    uint _S725;
    if(_S721)
    {
        _S725 = 1U;
    }
    else
    {
        _S725 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + uint4((_S725 * 256U)) ;
    uint _S726 = 2U * _S725;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + uint4((_S726 * 256U)) ;
    uint _S727;
    if((_S719.z) < 0.0f)
    {
        _S727 = 1U;
    }
    else
    {
        _S727 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + uint4(((_S726 + _S727) * 256U)) ;
    float3 _S728 = half_vector_0(_S719, _S720);
    float3 _S729 = shadow_correlation_0(_S719, _S720);
    if(_S721)
    {
        _S727 = _S722->lobes_0.back_warp_packs_0;
    }
    else
    {
        _S727 = _S722->lobes_0.front_warp_packs_0;
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
        Lobes_0 _S730 = _S722->lobes_0;
        if(pack_0 < (_S722->lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        thread CoverageTaps_0 _S731 = _S723;
        float4 _S732 = coverage_of_pack_0(_S717, &_S731, pack_0, kernelContext_52);
        uint _S733 = _S730.projected_area_0 + pack_0;
        uint _S734 = _S730.packs_0 + 1U;
        thread NodeTaps_0 _S735 = view_nodes_0;
        float4 _S736 = interpolate_table_0(&_S735, _S733, _S734, kernelContext_52);
        uint _S737 = _S730.light_visibility_1 + pack_0;
        thread NodeTaps_0 _S738 = seen_nodes_0;
        float4 _S739 = interpolate_table_0(&_S738, _S737, _S730.packs_0, kernelContext_52);
        float4 _S740 = float4(255.0f) ;
        float4 _S741 = _S739 / _S740;
        thread NodeTaps_0 _S742 = light_nodes_0;
        float4 _S743 = interpolate_table_0(&_S742, _S737, _S730.packs_0, kernelContext_52);
        float4 _S744 = _S743 / _S740;
        uint _S745 = _S730.irradiance_0 + pack_0;
        thread NodeTaps_0 _S746 = light_nodes_0;
        float4 _S747 = interpolate_table_0(&_S746, _S745, _S730.packs_0, kernelContext_52);
        float4 _S748 = _S747 * float4(0.00124827399849892f) ;
        bool _S749 = pack_0 < _S727;
        uint _S750;
        if(_S749)
        {
            _S750 = _S722->warp_0;
        }
        else
        {
            _S750 = _S722->weft_0;
        }
        Family_0 _S751 = kernelContext_52->families_0[_S750];
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
            Group_0 _S752 = group_at_0(_S730.moments_0 + 12U * (4U * (_S725 * _S730.packs_0 + pack_0) + number_4), _S751.roughness_0, kernelContext_52);
            float _S753 = _S732[number_4] * _S736[number_4] * _S736[number_4] * _S752.weight_1;
            float2 _S754 = visibility_gain_0(_S729, _S744[number_4], _S741[number_4]);
            thread Group_0 _S755 = _S752;
            float _S756 = layer_value_0(&_S755, _S728, _S719, _S720, _S722->optical_depth_0);
            float _S757 = _S754.x;
            float diffuse_1 = diffuse_0 + _S753 * _S748[number_4] * _S757;
            float specular_1 = specular_0 + _S753 * _S756 * _S744[number_4] * _S754.y;
            (&sums_1)->light_visibility_0 = (&sums_1)->light_visibility_0 + _S753 * _S744[number_4] * _S757;
            float total_3 = total_2 + _S753;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S758;
        if(_S749)
        {
            _S758 = diffuse_0;
        }
        else
        {
            _S758 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S758;
        float _S759;
        if(_S749)
        {
            _S759 = 0.0f;
        }
        else
        {
            _S759 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S759;
        float _S760;
        if(_S749)
        {
            _S760 = specular_0;
        }
        else
        {
            _S760 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S760;
        float _S761;
        if(_S749)
        {
            _S761 = 0.0f;
        }
        else
        {
            _S761 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S761;
        pack_0 = pack_0 + 1U;
    }
    thread CoverageTaps_0 _S762 = _S723;
    thread NodeTaps_0 _S763 = view_nodes_0;
    float _S764 = prefiltered_hole_0(_S717, &_S762, &_S763, _S721, kernelContext_52);
    (&sums_1)->hole_2 = _S764;
    float _S765 = (1.0f - _S764) / max(total_2, 9.999999960041972e-13f);
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S765;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S765;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S765;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S765;
    (&sums_1)->light_visibility_0 = (&sums_1)->light_visibility_0 * _S765;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S766, const Footprint_0 thread* _S767, bool _S768, KernelContext_0 thread* kernelContext_53)
{
    Fabric_0 device* _S769 = kernelContext_53->fabrics_0+_S766;
    float2 _S770 = sqrt(_S767->dx_0 * _S767->dx_0 + _S767->dy_0 * _S767->dy_0);
    uint _S771 = _S769->warp_0;
    float2 _S772 = _S767->centre_0;
    Stretch_0 _S773 = stretch_of_0(_S769->warp_0, _S767->centre_0.x, _S770.x, kernelContext_53);
    uint _S774 = _S769->weft_0;
    Stretch_0 _S775 = stretch_of_0(_S769->weft_0, _S772.y, _S770.y, kernelContext_53);
    thread FamilyAlbedos_0 albedos_7;
    thread Stretch_0 _S776 = _S773;
    thread Stretch_0 _S777 = _S775;
    Albedos_0 _S778 = mean_albedos_0(_S771, _S774, &_S776, &_S777, _S768, kernelContext_53);
    (&albedos_7)->warp_2 = _S778;
    thread Stretch_0 _S779 = _S775;
    thread Stretch_0 _S780 = _S773;
    Albedos_0 _S781 = mean_albedos_0(_S774, _S771, &_S779, &_S780, _S768, kernelContext_53);
    (&albedos_7)->weft_2 = _S781;
    return albedos_7;
}

Estimate_0 lobes_estimate_of_pass_0(uint _S782, const Footprint_0 thread* _S783, float _S784, float2 _S785, float3 _S786, float3 _S787, KernelContext_0 thread* kernelContext_54)
{
    float _S788;
    Fabric_0 device* _S789 = kernelContext_54->fabrics_0+_S782;
    Regime_0 _S790 = regime_of_0(_S782, _S783, _S784, kernelContext_54);
    bool _S791 = (_S787.z) < 0.0f;
    float3 _S792 = to_face_frame_0(_S787, _S791);
    bool _S793;
    if((_S789->fibre_noise_0) > 0.0f)
    {
        _S793 = true;
    }
    else
    {
        _S793 = (_S789->colour_noise_0) > 0.0f;
    }
    bool _S794;
    if((kernelContext_54->families_0[_S789->warp_0].quantities_0) > 1U)
    {
        _S794 = true;
    }
    else
    {
        _S794 = (kernelContext_54->families_0[_S789->weft_0].quantities_0) > 1U;
    }
    float _S795 = 1.0f - _S790.prefiltered_0;
    if(_S795 > 0.0f)
    {
        if(_S793)
        {
            _S794 = true;
        }
    }
    else
    {
        _S794 = false;
    }
    thread Footprint_0 box_0 = *_S783;
    float3 _S796 = float3(0.0f) ;
    SurfacePoint_0 _S797 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S796, _S796, 0.0f, 0.0f, 0.0f);
    float2 _S798 = _S783->centre_0;
    Components_0 _S799 = no_components_0();
    int _S800;
    if(_S794)
    {
        _S800 = int(0);
    }
    else
    {
        _S800 = int(1);
    }
    uint _S801 = uint(_S800);
    Components_0 points_1 = _S799;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S797;
    float2 central_place_0 = _S798;
    uint number_5 = _S801;
    for(;;)
    {
        float _S802 = float(number_5);
        _S788 = _S790.points_0;
        if(_S802 < (_S790.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S803 = number_5 == 0U;
        uint _S804;
        if(_S803)
        {
            _S804 = 0U;
        }
        else
        {
            _S804 = number_5 - 1U;
        }
        float2 _S805 = POINT_OFFSETS_0[_S804] + _S785;
        float2 _S806;
        if(_S803)
        {
            _S806 = float2(0.0f) ;
        }
        else
        {
            _S806 = _S805 - round(_S805);
        }
        float2 _S807 = _S798 + float2(_S806.x)  * _S783->dx_0 + float2(_S806.y)  * _S783->dy_0;
        float _S808;
        if(_S803)
        {
            _S808 = 0.0f;
        }
        else
        {
            _S808 = _S790.threads_1;
        }
        SearchQuality_0 _S809 = quality_of_0(_S808);
        float _S810 = _S807.x;
        float _S811 = _S807.y;
        thread SearchQuality_0 _S812 = _S809;
        Hit_0 _S813 = first_hit_0(_S782, &_S812, _S810, _S811, _S792, _S791, kernelContext_54);
        SurfacePoint_0 _S814 = surface_at_0(_S782, _S813.x_10, _S813.y_5, _S791, kernelContext_54);
        if(_S803)
        {
            float central_weight_1;
            if(_S813.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S795;
            }
            float2 central_place_1 = float2(_S813.x_10, _S813.y_5);
            (&box_0)->centre_0 = mix(_S798, central_place_1, float2(central_weight_1) );
            central_weight_0 = central_weight_1;
            central_0 = _S814;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        thread SurfacePoint_0 _S815 = _S814;
        YarnPoint_0 _S816 = yarn_point_of_0(_S782, &_S815, _S813.x_10, _S813.y_5, _S791, _S813.hole_5, kernelContext_54);
        thread SearchQuality_0 _S817 = _S809;
        thread YarnPoint_0 _S818 = _S816;
        Components_0 _S819 = components_of_point_0(_S782, &_S817, &_S818, _S786, _S787, kernelContext_54);
        float _S820 = min(_S790.points_0 - float(number_5 - 1U), 1.0f);
        thread Components_0 _S821 = points_1;
        thread Components_0 _S822 = _S819;
        Components_0 _S823 = with_added_0(&_S821, &_S822, _S820);
        points_1 = _S823;
        number_5 = number_5 + 1U;
    }
    thread Estimate_0 estimate_0;
    float _S824 = _S795 / max(_S788, 1.0f);
    thread Components_0 _S825 = _S799;
    thread Components_0 _S826 = points_1;
    Components_0 _S827 = with_added_0(&_S825, &_S826, _S824);
    (&estimate_0)->components_0 = _S827;
    if((_S790.prefiltered_0) > 0.0f)
    {
        Components_0 _S828 = prefiltered_components_0(_S782, _S783, to_face_frame_0(_S786, _S791), _S792, _S791, kernelContext_54);
        thread Components_0 _S829 = (&estimate_0)->components_0;
        thread Components_0 _S830 = _S828;
        Components_0 _S831 = with_added_0(&_S829, &_S830, _S790.prefiltered_0);
        (&estimate_0)->components_0 = _S831;
    }
    thread Footprint_0 _S832 = box_0;
    FamilyAlbedos_0 _S833 = albedos_over_0(_S782, &_S832, _S791, kernelContext_54);
    (&estimate_0)->albedos_4 = _S833;
    if(_S793)
    {
        _S793 = central_weight_0 > 0.0f;
    }
    else
    {
        _S793 = false;
    }
    if(_S793)
    {
        SurfacePoint_0 _S834 = central_0;
        Albedos_0 _S835;
        if(central_0.is_warp_0)
        {
            _S835 = (&(&estimate_0)->albedos_4)->warp_2;
        }
        else
        {
            _S835 = (&(&estimate_0)->albedos_4)->weft_2;
        }
        float _S836 = central_place_0.x;
        float _S837 = central_place_0.y;
        thread SurfacePoint_0 _S838 = central_0;
        thread Albedos_0 _S839 = _S835;
        Albedos_0 _S840 = varied_at_0(_S782, &_S838, &_S839, _S836, _S837, kernelContext_54);
        thread Albedos_0 _S841 = _S835;
        thread Albedos_0 _S842 = _S840;
        Albedos_0 _S843 = lerp_albedos_0(&_S841, &_S842, central_weight_0);
        if(_S834.is_warp_0)
        {
            (&(&estimate_0)->albedos_4)->warp_2 = _S843;
        }
        else
        {
            (&(&estimate_0)->albedos_4)->weft_2 = _S843;
        }
    }
    return estimate_0;
}

Estimate_0 lobes_estimate_0(uint _S844, const Footprint_0 thread* _S845, float _S846, float3 _S847, float3 _S848, KernelContext_0 thread* kernelContext_55)
{
    Estimate_0 _S849 = lobes_estimate_of_pass_0(_S844, _S845, _S846, float2(0.0f) , _S847, _S848, kernelContext_55);
    return _S849;
}

float3 composed_0(uint _S850, const Components_0 thread* _S851, const FamilyAlbedos_0 thread* _S852, float3 _S853, float3 _S854, KernelContext_0 thread* kernelContext_56)
{
    Fabric_0 device* _S855 = kernelContext_56->fabrics_0+_S850;
    float3 _S856 = float3(_S851->diffuse_warp_0) ;
    float3 _S857 = float3(_S851->diffuse_weft_0) ;
    float3 _S858 = float3(_S851->specular_warp_0) ;
    float3 _S859 = float3(_S851->specular_weft_0) ;
    float3 _S860 = (&_S852->warp_2)->diffuse_reflect_0 * _S856 + (&_S852->weft_2)->diffuse_reflect_0 * _S857 + (&_S852->warp_2)->specular_reflect_0 * _S858 + (&_S852->weft_2)->specular_reflect_0 * _S859;
    float _S861 = _S854.z;
    float3 body_0;
    if((_S853.z * _S861) < 0.0f)
    {
        body_0 = (&_S852->warp_2)->diffuse_transmit_0 * _S856 + (&_S852->weft_2)->diffuse_transmit_0 * _S857 + (&_S852->warp_2)->specular_transmit_0 * _S858 + (&_S852->weft_2)->specular_transmit_0 * _S859;
    }
    else
    {
        body_0 = _S860;
    }
    float _S862 = _S855->sheen_strength_0;
    if((_S855->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S863 = _S861 < 0.0f;
    float2 _S864 = sheen_with_transmittance_0(to_face_frame_0(_S853, _S863), to_face_frame_0(_S854, _S863), _S862, _S855->sheen_roughness_0);
    return float3(_S864.y)  * body_0 + float3(((_S851->light_visibility_0 + _S851->hole_2) * _S864.x)) ;
}

float4 cloth_value_0(uint fabric_1, float2 centre_2, float2 dx_1, float2 dy_1, float3 light_9, float3 view_8, KernelContext_0 thread* kernelContext_57)
{
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = centre_2;
    (&footprint_0)->dx_0 = dx_1;
    (&footprint_0)->dy_0 = dy_1;
    thread Footprint_0 _S865 = footprint_0;
    Estimate_0 _S866 = lobes_estimate_0(fabric_1, &_S865, 1.0f, light_9, view_8, kernelContext_57);
    thread Components_0 _S867 = _S866.components_0;
    thread FamilyAlbedos_0 _S868 = _S866.albedos_4;
    float3 _S869 = composed_0(fabric_1, &_S867, &_S868, light_9, view_8, kernelContext_57);
    float through_0;
    if(((kernelContext_57->fabrics_0+fabric_1)->sheen_strength_0) > 0.0f)
    {
        through_0 = _S866.components_0.hole_2 * (1.0f - (kernelContext_57->fabrics_0+fabric_1)->sheen_strength_0 * sheen_lobe_0(abs(view_8.z), (kernelContext_57->fabrics_0+fabric_1)->sheen_roughness_0).z);
    }
    else
    {
        through_0 = _S866.components_0.hole_2;
    }
    return float4(_S869, through_0);
}

[[kernel]] void lobes_queries(uint3 id_0 [[thread_position_in_grid]], uint device* query_count_1 [[buffer(24)]], Query_0 device* queries_1 [[buffer(23)]], packed_float4 device* answers_1 [[buffer(25)]], Fabric_0 device* fabrics_1 [[buffer(0)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]])
{
    thread KernelContext_0 kernelContext_58;
    (&kernelContext_58)->query_count_0 = query_count_1;
    (&kernelContext_58)->queries_0 = queries_1;
    (&kernelContext_58)->answers_0 = answers_1;
    (&kernelContext_58)->fabrics_0 = fabrics_1;
    (&kernelContext_58)->families_0 = families_1;
    (&kernelContext_58)->words_0 = words_1;
    uint _S870 = id_0.x;
    if(_S870 >= query_count_1[int(0)])
    {
        return;
    }
    Query_0 _S871 = (&kernelContext_58)->queries_0[_S870];
    packed_float4 device* _S872 = (&kernelContext_58)->answers_0+_S870;
    float4 _S873 = cloth_value_0(_S871.fabric_0, float2(_S871.centre_x_0, _S871.centre_y_0), float2(_S871.dx_x_0, _S871.dx_y_0), float2(_S871.dy_x_0, _S871.dy_y_0), float3(_S871.light_x_0, _S871.light_y_0, _S871.light_z_0), float3(_S871.view_x_0, _S871.view_y_0, _S871.view_z_0), &kernelContext_58);
    *_S872 = packed_float4(_S873) ;
    return;
}

