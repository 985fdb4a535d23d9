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

float3 camera_right_0(const Frame_0 thread* frame_0)
{
    return float3(frame_0->right_x_0, frame_0->right_y_0, frame_0->right_z_0);
}

float3 camera_up_0(const Frame_0 thread* frame_1)
{
    return float3(frame_1->up_x_0, frame_1->up_y_0, frame_1->up_z_0);
}

float3 camera_forward_0(const Frame_0 thread* frame_2)
{
    return float3(frame_2->forward_x_0, frame_2->forward_y_0, frame_2->forward_z_0);
}

float3 camera_origin_0(const Frame_0 thread* frame_3)
{
    return float3(frame_3->origin_x_0, frame_3->origin_y_0, frame_3->origin_z_0);
}

float3 normal_of_0(const Vertex_0 thread* vertex_1)
{
    return float3(vertex_1->normal_x_0, vertex_1->normal_y_0, vertex_1->normal_z_0);
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(const VisiblePoint_0 thread* point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0->axis_x_0), dot(direction_0, point_0->axis_y_0), dot(direction_0, point_0->normal_0));
}

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

float3 towards_light_0(const Light_0 thread* light_0, float3 position_1, float3 thread* irradiance_0)
{
    *irradiance_0 = float3(light_0->red_0, light_0->green_0, light_0->blue_0);
    float3 _S1 = float3(light_0->x_1, light_0->y_1, light_0->z_1);
    if((light_0->is_point_0) == 0U)
    {
        return _S1;
    }
    float3 _S2 = _S1 - position_1;
    *irradiance_0 = *irradiance_0 / float3(max(square_0(_S2), 9.999999960041972e-13f)) ;
    return normalize(_S2);
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

float natural_logarithm_0(float x_2)
{
    uint _S3 = (as_type<uint>((x_2)));
    float exponent_0 = float(int(_S3 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S3 & 8388607U) | 1056964608U)));
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
    float _S4 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S4 - exponent_1 * 0.00021219444170129f - 0.5f * _S4) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_3)
{
    return natural_logarithm_0(x_3) * 1.4426950216293335f;
}

float3 to_face_frame_0(float3 direction_1, bool back_0)
{
    float2 _S5 = direction_1.xy;
    float _S6;
    if(back_0)
    {
        _S6 = - direction_1.z;
    }
    else
    {
        _S6 = direction_1.z;
    }
    return float3(_S5, _S6);
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
    thread SurfacePoint_0 _S7;
    (&_S7)->hole_0 = hole_1;
    (&_S7)->is_warp_0 = is_warp_1;
    (&_S7)->warp_thread_0 = warp_thread_1;
    (&_S7)->weft_thread_0 = weft_thread_1;
    (&_S7)->height_1 = height_2;
    (&_S7)->normal_1 = normal_2;
    (&_S7)->tangent_0 = tangent_1;
    (&_S7)->across_0 = across_1;
    (&_S7)->fibre_across_0 = fibre_across_1;
    (&_S7)->fibre_along_0 = fibre_along_1;
    return _S7;
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
    float _S8 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    thread SearchQuality_0 quality_0;
    float _S9 = mix(2.5f, 5.0f, _S8);
    (&quality_0)->steps_per_thread_0 = _S9;
    (&quality_0)->steps_per_relief_0 = _S9;
    (&quality_0)->shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S8);
    (&quality_0)->refinements_0 = uint(mix(1.0f, 2.0f, _S8) + 0.5f);
    return quality_0;
}

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
    uint irradiance_1;
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

struct Fabric_0
{
    uint warp_0;
    uint weft_0;
    Lobes_0 lobes_0;
    Woven_0 woven_0;
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
    texture2d<uint, access::sample> visible_faces_0;
    uint device* face_fabrics_0;
    Fabric_0 device* fabrics_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
    Light_0 device* lights_1;
    Family_0 device* families_0;
    uint device* words_0;
    packed_float4 device* radiance_0;
};

float2 turns_and_remainder_0(uint family_0, float index_0, KernelContext_0 thread* kernelContext_0)
{
    float _S10 = floor(fma(index_0, kernelContext_0->families_0[family_0].inverse_count_0, kernelContext_0->families_0[family_0].half_inverse_count_0));
    return float2(_S10, fma(- _S10, kernelContext_0->families_0[family_0].count_0, index_0));
}

struct Cell_0
{
    uint thread_0;
    float across_2;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_2, KernelContext_0 thread* kernelContext_1)
{
    float _S11 = floor(position_2 * kernelContext_1->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_0;
    float _S12 = fma(- _S11, kernelContext_1->families_0[family_1].size_0, position_2);
    (&cell_0)->below_0 = _S12;
    (&cell_0)->above_0 = kernelContext_1->families_0[family_1].size_0 - _S12;
    (&cell_0)->across_2 = _S12 - 0.5f * kernelContext_1->families_0[family_1].size_0;
    (&cell_0)->half_width_1 = kernelContext_1->families_0[family_1].half_width_0;
    float2 _S13 = turns_and_remainder_0(family_1, _S11, kernelContext_1);
    (&cell_0)->thread_0 = uint(clamp(_S13.y, 0.0f, kernelContext_1->families_0[family_1].count_0 - 1.0f));
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

Cell_0 locate_varied_0(uint family_2, float position_3, KernelContext_0 thread* kernelContext_4)
{
    float turns_0 = (position_3 - kernelContext_4->families_0[family_2].start_0) * kernelContext_4->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S14 = turns_1 * kernelContext_4->families_0[family_2].period_0;
    uint thread_1 = kernelContext_4->words_0[kernelContext_4->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_4->families_0[family_2].bins_0, 0.0f, kernelContext_4->families_0[family_2].bins_0 - 1.0f))];
    float _S15 = table_number_0(kernelContext_4->families_0[family_2].place_table_0 + thread_1 * 4U + 1U, kernelContext_4);
    uint _S16;
    if(_S14 >= _S15)
    {
        _S16 = 1U;
    }
    else
    {
        _S16 = 0U;
    }
    uint _S17 = min(thread_1 + _S16, uint(kernelContext_4->families_0[family_2].count_0) - 1U);
    uint _S18 = kernelContext_4->families_0[family_2].place_table_0 + _S17 * 4U;
    thread Cell_0 cell_1;
    (&cell_1)->thread_0 = _S17;
    float _S19 = table_number_0(_S18, kernelContext_4);
    (&cell_1)->below_0 = _S14 - _S19;
    float _S20 = table_number_0(_S18 + 1U, kernelContext_4);
    (&cell_1)->above_0 = _S20 - _S14;
    float _S21 = table_number_0(_S18 + 2U, kernelContext_4);
    (&cell_1)->across_2 = _S14 - _S21;
    float _S22 = table_number_0(_S18 + 3U, kernelContext_4);
    (&cell_1)->half_width_1 = _S22;
    return cell_1;
}

Cell_0 locate_0(uint family_3, float position_4, KernelContext_0 thread* kernelContext_5)
{
    if((kernelContext_5->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S23 = locate_alike_0(family_3, position_4, kernelContext_5);
        return _S23;
    }
    Cell_0 _S24 = locate_varied_0(family_3, position_4, kernelContext_5);
    return _S24;
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

Shown_0 shown_at_0(const Crossing_0 thread* crossing_0, bool back_1)
{
    bool _S25 = (abs((&crossing_0->warp_1)->across_2)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S26 = (abs((&crossing_0->weft_1)->across_2)) < ((&crossing_0->weft_1)->half_width_1);
    thread Shown_0 shown_0;
    bool _S27;
    if(_S25)
    {
        if(!_S26)
        {
            _S27 = true;
        }
        else
        {
            _S27 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S27 = false;
    }
    (&shown_0)->is_warp_2 = _S27;
    if(!_S25)
    {
        _S27 = !_S26;
    }
    else
    {
        _S27 = false;
    }
    (&shown_0)->hole_3 = _S27;
    uint _S28;
    if((&shown_0)->is_warp_2)
    {
        _S28 = crossing_0->warp_word_0;
    }
    else
    {
        _S28 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S28;
    (&shown_0)->on_top_0 = ((_S28 & 1U) == 1U) != back_1;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_0, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_2;
    uint _S29;
    if(is_first_0)
    {
        _S29 = first_0->thread_0;
    }
    else
    {
        _S29 = second_0->thread_0;
    }
    (&cell_2)->thread_0 = _S29;
    float _S30;
    if(is_first_0)
    {
        _S30 = first_0->across_2;
    }
    else
    {
        _S30 = second_0->across_2;
    }
    (&cell_2)->across_2 = _S30;
    if(is_first_0)
    {
        _S30 = first_0->half_width_1;
    }
    else
    {
        _S30 = second_0->half_width_1;
    }
    (&cell_2)->half_width_1 = _S30;
    if(is_first_0)
    {
        _S30 = first_0->below_0;
    }
    else
    {
        _S30 = second_0->below_0;
    }
    (&cell_2)->below_0 = _S30;
    if(is_first_0)
    {
        _S30 = first_0->above_0;
    }
    else
    {
        _S30 = second_0->above_0;
    }
    (&cell_2)->above_0 = _S30;
    return cell_2;
}

float boundary_0(uint family_4, uint thread_2, int step_0, KernelContext_0 thread* kernelContext_6)
{
    float2 _S31 = turns_and_remainder_0(family_4, float(int(thread_2) + step_0), kernelContext_6);
    float _S32 = _S31.x;
    Family_0 _S33 = kernelContext_6->families_0[family_4];
    float _S34 = table_number_0(kernelContext_6->families_0[family_4].place_table_0 + uint(_S31.y) * 4U, kernelContext_6);
    return fma(_S32, _S33.period_0, _S34);
}

float span_0(uint family_5, uint thread_3, int first_1, int last_0, KernelContext_0 thread* kernelContext_7)
{
    if((kernelContext_7->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * kernelContext_7->families_0[family_5].size_0;
    }
    float _S35 = boundary_0(family_5, thread_3, last_0, kernelContext_7);
    float _S36 = boundary_0(family_5, thread_3, first_1, kernelContext_7);
    return _S35 - _S36;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_4, KernelContext_0 thread* kernelContext_8)
{
    Family_0 _S37 = kernelContext_8->families_0[family_6];
    uint _S38;
    if((kernelContext_8->families_0[family_6].is_alike_0) != 0U)
    {
        _S38 = 0U;
    }
    else
    {
        _S38 = thread_4 * 4U;
    }
    uint _S39 = _S37.bend_table_0 + _S38;
    thread Bend_0 bend_0;
    float _S40 = table_number_0(_S39, kernelContext_8);
    (&bend_0)->sine_0 = _S40;
    float _S41 = table_number_0(_S39 + 1U, kernelContext_8);
    (&bend_0)->half_tangent_0 = _S41;
    float _S42 = table_number_0(_S39 + 2U, kernelContext_8);
    (&bend_0)->arc_0 = _S42;
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
    int _S43 = int((word_1 >> 1U) & 127U);
    int _S44 = int((word_1 >> 8U) & 127U);
    int _S45 = int((word_1 >> 15U) & 63U);
    int _S46 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S47 = crossed_0->below_0;
    uint _S48 = crossed_0->thread_0;
    int _S49 = - _S43;
    float _S50 = span_0(other_0, crossed_0->thread_0, _S49, int(0), kernelContext_9);
    float _S51 = _S47 + _S50;
    (&run_0)->from_start_0 = _S51;
    float _S52 = crossed_0->above_0;
    int _S53 = _S44 + int(1);
    float _S54 = span_0(other_0, _S48, int(1), _S53, kernelContext_9);
    float _S55 = _S52 + _S54;
    (&run_0)->to_end_0 = _S55;
    bool _S56 = _S51 < _S55;
    (&run_0)->near_start_0 = _S56;
    int _S57;
    if(_S56)
    {
        _S57 = _S49 - _S45;
    }
    else
    {
        _S57 = _S53;
    }
    int _S58;
    if((&run_0)->near_start_0)
    {
        _S58 = _S49;
    }
    else
    {
        _S58 = _S53 + _S46;
    }
    Bend_0 _S59 = bend_of_0(own_0, thread_5, kernelContext_9);
    (&run_0)->bend_1 = _S59;
    float _S60;
    if((&run_0)->straight_0)
    {
        _S60 = 1.0e+06f;
    }
    else
    {
        _S60 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S60;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S61 = span_0(other_0, _S48, _S57, _S58, kernelContext_9);
    (&run_0)->other_reach_0 = min(0.5f * _S61, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S43 == int(0);
    (&run_0)->last_crossing_0 = _S44 == int(0);
    return run_0;
}

float square_1(float x_4)
{
    return x_4 * x_4;
}

struct Section_0
{
    float across_3;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(const Cell_0 thread* cell_3)
{
    float _S62 = cell_3->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S63 = clamp(cell_3->across_2, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_3 = _S63;
    float _S64 = _S62 * _S62 - square_1(_S63);
    float _S65 = rsqrt(_S64);
    (&section_0)->drop_0 = _S62 - _S64 * _S65;
    (&section_0)->slope_0 = - _S63 * _S65;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_6, int step_1, KernelContext_0 thread* kernelContext_10)
{
    if((kernelContext_10->families_0[family_7].is_alike_0) != 0U)
    {
        float _S66 = table_number_0(kernelContext_10->families_0[family_7].bend_table_0 + 3U, kernelContext_10);
        return _S66;
    }
    Family_0 _S67 = kernelContext_10->families_0[family_7];
    float2 _S68 = turns_and_remainder_0(family_7, float(int(thread_6) + step_1), kernelContext_10);
    float _S69 = table_number_0(_S67.bend_table_0 + uint(_S68.y) * 4U + 3U, kernelContext_10);
    return _S69;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_11)
{
    float _S70 = crossed_1->below_0;
    float _S71 = crossed_1->above_0;
    bool _S72 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S73 = min(crossed_1->below_0, crossed_1->above_0);
    float _S74;
    if(_S72)
    {
        _S74 = _S70 - crossed_1->across_2;
    }
    else
    {
        _S74 = _S71 + crossed_1->across_2;
    }
    float _S75 = _S74 - crossed_1->half_width_1;
    bool _S76;
    if(_S72)
    {
        _S76 = run_1->first_crossing_0;
    }
    else
    {
        _S76 = run_1->last_crossing_0;
    }
    bool _S77 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S74 = 0.0f;
    }
    else
    {
        Family_0 _S78 = kernelContext_11->families_0[other_1];
        float _S79 = edge_drop_0(other_1, crossed_1->thread_0, int(0), kernelContext_11);
        _S74 = _S78.height_scale_0 * _S79;
    }
    float _S80;
    if(_S77 != _S76)
    {
        _S80 = 0.0f;
    }
    else
    {
        Family_0 _S81 = kernelContext_11->families_0[other_1];
        uint _S82 = crossed_1->thread_0;
        int _S83;
        if(_S72)
        {
            _S83 = int(-1);
        }
        else
        {
            _S83 = int(1);
        }
        float _S84 = edge_drop_0(other_1, _S82, _S83, kernelContext_11);
        _S80 = _S81.height_scale_0 * _S84;
    }
    float _S85 = 1.0f / max(2.0f * _S75, 9.999999960041972e-13f);
    float _S86 = clamp((_S75 - _S73) * _S85, 0.0f, 1.0f);
    float _S87 = _S74 + (_S80 - _S74) * (_S86 * _S86 * (3.0f - 2.0f * _S86));
    float _S88 = (_S74 - _S80) * (6.0f * _S86 * (1.0f - _S86) * _S85);
    if(_S72)
    {
        _S74 = 1.0f;
    }
    else
    {
        _S74 = -1.0f;
    }
    return float2(_S87, _S88 * _S74);
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
    float _S89 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S89), 9.99999971718068537e-10f);
    float _S90 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S90), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S89 > 0.0f;
    (&control_0)->up_0 = _S90 > 0.0f;
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
    float _S91;
    if(forwards_0)
    {
        _S91 = cell_4->across_2;
    }
    else
    {
        _S91 = - cell_4->across_2;
    }
    float _S92;
    if(forwards_0)
    {
        _S92 = cell_4->above_0;
    }
    else
    {
        _S92 = cell_4->below_0;
    }
    bool _S93;
    if(forwards_0)
    {
        _S93 = run_2->last_crossing_0;
    }
    else
    {
        _S93 = run_2->first_crossing_0;
    }
    bool _S94;
    if(forwards_0)
    {
        _S94 = run_2->first_crossing_0;
    }
    else
    {
        _S94 = run_2->last_crossing_0;
    }
    float _S95 = cell_4->half_width_1;
    float _S96 = - cell_4->half_width_1;
    bool _S97 = _S91 < _S96;
    bool _S98 = _S91 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S93 = !_S93;
    }
    else
    {
        _S93 = false;
    }
    if(_S93)
    {
        _S93 = !shown_2->hole_3;
    }
    else
    {
        _S93 = false;
    }
    bool _S99;
    if(_S93)
    {
        _S99 = shown_2->on_top_0;
    }
    else
    {
        _S99 = false;
    }
    if(_S99)
    {
        if(_S94)
        {
            _S94 = _S97;
        }
        else
        {
            _S94 = false;
        }
        _S94 = !_S94;
    }
    else
    {
        _S94 = false;
    }
    if(shown_2->hole_3)
    {
        _S93 = true;
    }
    else
    {
        if(_S93)
        {
            _S93 = !shown_2->on_top_0;
        }
        else
        {
            _S93 = false;
        }
    }
    float _S100;
    if(_S97)
    {
        _S100 = _S96;
    }
    else
    {
        _S100 = _S95;
    }
    float _S101 = _S100 - _S91;
    if(_S93)
    {
        _S91 = 2.0f * _S92 + _S91 - _S95;
    }
    else
    {
        _S91 = _S92;
    }
    if(_S94)
    {
        if(forwards_0)
        {
            _S91 = run_2->to_end_0;
        }
        else
        {
            _S91 = run_2->from_start_0;
        }
        return _S91;
    }
    if(_S98)
    {
    }
    else
    {
        _S91 = _S101;
    }
    return _S91;
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
    float _S102 = previous_1->rate_0;
    float _S103 = previous_1->rate_0 * step_4;
    float _S104 = rate_1 * step_4;
    bool _S105;
    if(!previous_1->known_0)
    {
        _S105 = true;
    }
    else
    {
        _S105 = here_0->hole_4;
    }
    if(_S105)
    {
        _S105 = true;
    }
    else
    {
        _S105 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S105)
    {
        _S105 = true;
    }
    else
    {
        _S105 = _S102 >= 0.0f;
    }
    if(_S105)
    {
        _S105 = true;
    }
    else
    {
        _S105 = rate_1 <= 0.0f;
    }
    if(_S105)
    {
        return -1.0f;
    }
    float _S106 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S103) >= 0.0f)
    {
        _S105 = (3.0f * clearance_1 - _S104) >= 0.0f;
    }
    else
    {
        _S105 = false;
    }
    if(_S105)
    {
        return -1.0f;
    }
    float _S107 = clearance_1 - _S106;
    float _S108 = 6.0f * _S107 - 4.0f * _S103 - 2.0f * _S104;
    float _S109 = -2.0f * _S103 / max(_S108 + sqrt(max(_S108 * _S108 - 4.0f * (3.0f * (_S103 + _S104 - 2.0f * _S107)) * _S103, 0.0f)), 9.99999968265522539e-21f);
    float _S110 = 1.0f - _S109;
    float _S111 = (_S106 * (2.0f * _S109 + 1.0f) + _S103 * _S109) * _S110 * _S110;
    float _S112 = (clearance_1 * (2.0f * _S110 + 1.0f) - _S104 * _S110) * _S109 * _S109;
    if(_S109 > 0.01999999955296516f)
    {
        _S105 = _S110 > 0.01999999955296516f;
    }
    else
    {
        _S105 = false;
    }
    if(_S105)
    {
        _S105 = (_S111 + _S112) < 0.0f;
    }
    else
    {
        _S105 = false;
    }
    float _S113;
    if(_S105)
    {
        _S113 = _S110 * step_4;
    }
    else
    {
        _S113 = -1.0f;
    }
    return _S113;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S114 = here_1->hole_4;
    float _S115;
    if(here_1->hole_4)
    {
        _S115 = 1.0e+09f;
    }
    else
    {
        _S115 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S115;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S116;
    if(!_S114)
    {
        _S116 = !is_cell_exit_0;
    }
    else
    {
        _S116 = false;
    }
    (&previous_2)->known_0 = _S116;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1->per_x_0, side_y_1 * this_1->per_y_0), 0.0f) + this_1->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_2, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S117 = min(here_2->edge_x_0 * this_2->per_x_0, here_2->edge_y_0 * this_2->per_y_0);
    bool _S118;
    if(!here_2->hole_4)
    {
        _S118 = (rate_3 * _S117 + clearance_3) < 0.0f;
    }
    else
    {
        _S118 = false;
    }
    if(_S118)
    {
        _S118 = _S117 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S118 = false;
    }
    float _S119 = this_2->step_2;
    float _S120;
    if(_S118)
    {
        _S120 = _S117 - this_2->epsilon_0;
    }
    else
    {
        _S120 = max(_S117, 0.0f) + this_2->epsilon_0;
    }
    return min(_S119, _S120);
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
    float _S121 = end_0 - start_1;
    float _S122 = start_rate_0 + end_rate_0 - 2.0f * _S121;
    float _S123 = 3.0f * _S121 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S121, 9.99999968265522539e-21f);
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
        float _S124 = clamp(share_0 - (((_S122 * share_0 + _S123) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S122 * share_0 + 2.0f * _S123) * share_0 + start_rate_0, 0.10000000149011612f * _S121 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S125 = i_0 + int(1);
        share_0 = _S124;
        i_0 = _S125;
    }
    return share_0;
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

float arc_sine_0(float x_5)
{
    float _S129 = abs(x_5);
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
    if(x_5 < 0.0f)
    {
        _S131 = - _S131;
    }
    return _S131;
}

float3 table_colour_0(uint index_3, KernelContext_0 thread* kernelContext_12)
{
    float _S134 = table_number_1(index_3, kernelContext_12);
    float _S135 = table_number_1(index_3 + 1U, kernelContext_12);
    float _S136 = table_number_1(index_3 + 2U, kernelContext_12);
    return float3(_S134, _S135, _S136);
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
    float3 _S137 = table_colour_0(row_0, kernelContext_13);
    (&albedos_0)->diffuse_reflect_0 = _S137;
    float3 _S138 = table_colour_0(row_0 + 3U, kernelContext_13);
    (&albedos_0)->diffuse_transmit_0 = _S138;
    float3 _S139 = table_colour_0(row_0 + 6U, kernelContext_13);
    (&albedos_0)->specular_reflect_0 = _S139;
    float3 _S140 = table_colour_0(row_0 + 9U, kernelContext_13);
    (&albedos_0)->specular_transmit_0 = _S140;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_7, KernelContext_0 thread* kernelContext_14)
{
    Albedos_0 _S141 = table_albedos_0(kernelContext_14->families_0[family_8].albedo_table_0 + kernelContext_14->families_0[family_8].albedo_stride_0 * thread_7, kernelContext_14);
    return _S141;
}

uint scramble_0(uint value_0)
{
    uint _S142 = value_0 * 747796405U + 2891336453U;
    uint _S143 = ((_S142 >> ((_S142 >> 28U) + 4U)) ^ _S142) * 277803737U;
    return (_S143 >> 22U) ^ _S143;
}

float uniform_hash_0(uint thread_8, uint cell_5, uint stream_0)
{
    return (float((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S144 = room_0 / max(albedo_0, float3(9.99999997475242708e-07f) );
    return min(gain_1, max(min(min(_S144.x, _S144.y), _S144.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float diffuse_reflection_0(float3 light_1, float3 normal_3, float blend_0)
{
    float _S145 = light_1.z;
    if(_S145 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S145, 0.0f), max(dot(light_1, normal_3), 0.0f), blend_0);
}

float projected_area_1(float3 direction_3, float3 tangent_2, float roughness_1)
{
    float _S146 = dot(direction_3, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S146 * _S146 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_6)
{
    float _S147 = clamp(x_6, -87.0f, 88.0f);
    float _S148 = floor(_S147 * 1.4426950216293335f + 0.5f);
    float _S149 = _S147 - _S148 * 0.693359375f + _S148 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S149 + 0.00139819993637502f) * _S149 + 0.00833345204591751f) * _S149 + 0.04166579619050026f) * _S149 + 0.1666666567325592f) * _S149 + 0.5f;
    float _S150 = (as_type<float>((uint(int(_S148) + int(127)) << 23U)));
    float _S151;
    if(x_6 < -87.0f)
    {
        _S151 = 0.0f;
    }
    else
    {
        _S151 = (p_0 * _S149 * _S149 + _S149 + 1.0f) * _S150;
    }
    return _S151;
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
    float _S152 = roughness_2 * roughness_2;
    float _S153 = squared_along_0 * (1.0f - _S152) + _S152;
    return 0.31830987334251404f * _S152 * roughness_2 / (_S153 * _S153);
}

float density_between_0(float3 light_2, float3 view_1, float3 tangent_3, float roughness_3)
{
    float3 _S154 = light_2 + view_1;
    float _S155 = dot(_S154, tangent_3);
    return flake_density_0(min(_S155 * _S155 / max(square_0(_S154), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float transmission_0(float3 light_3, float3 view_2, float3 normal_4, float3 tangent_4, float roughness_4, float optical_depth_1)
{
    float _S156 = - dot(light_3, normal_4);
    float _S157 = dot(view_2, normal_4);
    bool _S158;
    if(_S156 <= 0.0f)
    {
        _S158 = true;
    }
    else
    {
        _S158 = _S157 <= 0.0f;
    }
    if(_S158)
    {
        return 0.0f;
    }
    float _S159 = 1.0f / max(_S157, 9.99999997475242708e-07f);
    float _S160 = projected_area_1(light_3, tangent_4, roughness_4) / max(_S156, 9.99999997475242708e-07f);
    float _S161 = projected_area_1(view_2, tangent_4, roughness_4) * _S159;
    return density_between_0(light_3, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S160, _S161)) * mean_attenuation_0(optical_depth_1 * abs(_S160 - _S161)) * _S159;
}

float reflection_0(float3 light_4, float3 view_3, float3 normal_5, float3 tangent_5, float roughness_5, float optical_depth_2)
{
    float _S162 = dot(light_4, normal_5);
    bool _S163;
    if(_S162 <= 0.0f)
    {
        _S163 = true;
    }
    else
    {
        _S163 = (dot(view_3, normal_5)) <= 0.0f;
    }
    if(_S163)
    {
        return 0.0f;
    }
    float _S164 = max(_S162, 9.99999997475242708e-07f);
    float _S165 = max(dot(view_3, normal_5), 9.99999997475242708e-07f);
    float _S166 = projected_area_1(light_4, tangent_5, roughness_5) * _S165 + projected_area_1(view_3, tangent_5, roughness_5) * _S164;
    float _S167 = optical_depth_2 * _S166 / (_S164 * _S165);
    return 0.25f * density_between_0(light_4, view_3, tangent_5, roughness_5) * (_S167 * mean_attenuation_0(_S167)) * _S164 / _S166;
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

float wrapped_cell_0(float position_5, float count_1)
{
    return min(floor((position_5 - floor(position_5)) * count_1), count_1 - 1.0f);
}

float arc_tangent_quotient_0(float x_7, float y_2)
{
    return ((((((0.0f * x_7 + 0.00809729471802711f) * x_7 + -0.0377517081797123f) * x_7 + 0.08475969731807709f) * x_7 + -0.13537675142288208f) * x_7 + 0.19895026087760925f) * x_7 + -0.33327975869178772f) * x_7 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_3, float x_8)
{
    float _S168 = abs(x_8);
    float _S169 = abs(y_3);
    float angle_0 = arc_tangent_of_ratio_0(min(_S168, _S169) / max(max(_S168, _S169), 1.00000000317107685e-30f));
    float angle_1;
    if(_S169 > _S168)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_8 < 0.0f)
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
    float _S170 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S171 = floor(_S170);
    float _S172 = _S170 - _S171;
    float _S173 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S174 = 7.0f * _S173 * sqrt(_S173);
    float _S175 = min(floor(_S174), 6.0f);
    float _S176 = _S174 - _S175;
    uint _S177 = uint(int(_S171) + int(32)) % 32U;
    uint _S178 = uint(_S175);
    uint _S179 = _S177 * 8U + _S178;
    uint _S180 = (_S177 + 1U) % 32U * 8U + _S178;
    thread NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = uint4(_S179, _S179 + 1U, _S180, _S180 + 1U);
    float _S181 = 1.0f - _S172;
    float _S182 = 1.0f - _S176;
    uint4 _S183 = uint4(float4(_S181 * _S182, _S181 * _S176, _S172 * _S182, _S172 * _S176) * float4(252.0f)  + float4(0.5f) );
    (&taps_0)->weights_0 = _S183;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S183.x + _S183.y + _S183.z + _S183.w);
    return taps_0;
}

float3 half_vector_0(float3 light_5, float3 view_4)
{
    float3 _S184 = light_5 + view_4;
    return _S184 * float3(rsqrt(max(square_0(_S184), 9.999999960041972e-13f))) ;
}

float3 shadow_correlation_0(float3 light_6, float3 view_5)
{
    float2 _S185 = light_6.xy;
    float2 _S186 = view_5.xy;
    float _S187 = dot(_S185, _S186) / max(sqrt(dot(_S185, _S185) * dot(_S186, _S186)), 9.99999997475242708e-07f);
    if((light_6.z) < 0.0f)
    {
        return float3(float2((-0.09000000357627869f + -0.07999999821186066f * _S187)) , 0.0f);
    }
    return float3(min(0.62000000476837158f + 0.62999999523162842f * _S187, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16U), float(odd_0 >> 16U));
}

float4 interpolate_0(const NodeTaps_0 thread* taps_1, uint4 packs_1)
{
    uint4 _S188 = uint4(16711935U) ;
    uint4 _S189 = (packs_1 & _S188) * taps_1->weights_0;
    uint4 _S190 = ((packs_1 >> (uint4(8U) )) & _S188) * taps_1->weights_0;
    return bytes_of_sums_0(_S189.x + _S189.y + _S189.z + _S189.w, _S190.x + _S190.y + _S190.z + _S190.w) * float4(taps_1->inverse_sum_0) ;
}

float4 interpolate_table_0(const NodeTaps_0 thread* taps_2, uint table_0, uint stride_0, KernelContext_0 thread* kernelContext_15)
{
    uint4 _S191 = uint4(table_0)  + taps_2->nodes_0 * uint4(stride_0) ;
    float4 _S192 = interpolate_0(taps_2, uint4(kernelContext_15->words_0[_S191.x], kernelContext_15->words_0[_S191.y], kernelContext_15->words_0[_S191.z], kernelContext_15->words_0[_S191.w]));
    return _S192;
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

Group_0 group_at_0(uint row_1, float roughness_7, KernelContext_0 thread* kernelContext_16)
{
    thread Group_0 group_0;
    float _S193 = table_number_0(row_1, kernelContext_16);
    float _S194 = table_number_0(row_1 + 1U, kernelContext_16);
    float _S195 = table_number_0(row_1 + 2U, kernelContext_16);
    (&group_0)->normal_6 = float3(_S193, _S194, _S195);
    float _S196 = table_number_0(row_1 + 3U, kernelContext_16);
    (&group_0)->weight_1 = _S196;
    float _S197 = table_number_0(row_1 + 4U, kernelContext_16);
    float _S198 = table_number_0(row_1 + 5U, kernelContext_16);
    float _S199 = table_number_0(row_1 + 6U, kernelContext_16);
    float3 _S200 = float3(_S197, _S198, _S199);
    (&group_0)->tangent_6 = _S200;
    float _S201 = table_number_0(row_1 + 7U, kernelContext_16);
    float _S202 = table_number_0(row_1 + 8U, kernelContext_16);
    (&group_0)->variance_0 = float3(_S201, _S202, 1.0f - square_0(_S200) - _S201 - _S202);
    float _S203 = table_number_0(row_1 + 9U, kernelContext_16);
    float _S204 = table_number_0(row_1 + 10U, kernelContext_16);
    float _S205 = table_number_0(row_1 + 11U, kernelContext_16);
    (&group_0)->covariance_0 = float3(_S203, _S204, _S205);
    (&group_0)->roughness_6 = roughness_7;
    return group_0;
}

float2 visibility_gain_0(float3 correlations_0, float from_light_0, float from_view_0)
{
    return max(correlations_0.xy * float2((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f))  + float2(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), float2(0.0f) );
}

float Group_variance_along_0(const Group_0 thread* this_5, float3 direction_5)
{
    float _S206 = direction_5.x;
    float _S207 = direction_5.y;
    float _S208 = direction_5.z;
    return max(dot(this_5->variance_0, direction_5 * direction_5) + 2.0f * dot(this_5->covariance_0, float3(_S206 * _S207, _S206 * _S208, _S207 * _S208)), 0.0f);
}

float mean_area_0(const Group_0 thread* group_1, float3 direction_6)
{
    float _S209 = dot(direction_6, group_1->tangent_6);
    float _S210 = _S209 * _S209;
    float _S211 = Group_variance_along_0(group_1, direction_6);
    float _S212 = group_1->roughness_6 * group_1->roughness_6;
    return sqrt(max((_S212 - 1.0f) * (_S210 + _S211) + 1.0f, _S212));
}

float mean_density_0(const Group_0 thread* group_2, float3 half_0)
{
    float _S213 = group_2->roughness_6;
    float _S214 = max(sqrt(max(1.0f - group_2->roughness_6 * group_2->roughness_6, 0.0f)) / group_2->roughness_6, 0.00100000004749745f);
    float _S215 = Group_variance_along_0(group_2, half_0);
    float _S216 = max(sqrt(3.0f * _S215), _S213 * 0.01999999955296516f + 0.00009999999747379f);
    float _S217 = dot(half_0, group_2->tangent_6);
    float _S218 = _S214 * (_S217 - _S216);
    float _S219 = _S214 * (_S217 + _S216);
    float _S220 = _S218 * _S219;
    float _S221 = 2.0f * _S216 * _S214;
    return 0.15915493667125702f / _S213 * ((1.0f - _S220) / ((_S218 * _S218 + 1.0f) * (_S219 * _S219 + 1.0f)) + arc_tangent_0(_S221, 1.0f + _S220) / _S221);
}

float layer_value_0(const Group_0 thread* group_3, float3 half_1, float3 light_7, float3 view_6, float optical_depth_3)
{
    bool _S222 = (light_7.z) < 0.0f;
    float3 _S223 = group_3->normal_6;
    float _S224 = dot(light_7, group_3->normal_6);
    float _S225;
    if(_S222)
    {
        _S225 = - _S224;
    }
    else
    {
        _S225 = _S224;
    }
    float _S226 = max(_S225, 0.01999999955296516f);
    float _S227 = max(dot(view_6, _S223), 0.01999999955296516f);
    float _S228 = mean_area_0(group_3, light_7);
    float _S229 = _S228 / _S226;
    float _S230 = mean_area_0(group_3, view_6);
    float _S231 = _S230 / _S227;
    if(_S222)
    {
        _S225 = abs(_S229 - _S231);
    }
    else
    {
        _S225 = _S229 + _S231;
    }
    float _S232 = optical_depth_3 * max(_S225, 0.00100000004749745f);
    if(_S222)
    {
        _S225 = exponential_0(- optical_depth_3 * min(_S229, _S231));
    }
    else
    {
        _S225 = 1.0f;
    }
    float _S233 = optical_depth_3 * _S225 * (1.0f - exponential_0(- _S232)) / _S232 / _S227;
    if(_S222)
    {
        _S225 = 1.0f;
    }
    else
    {
        _S225 = 1.0f - 0.34999999403953552f * (1.0f - square_0(_S223));
    }
    float _S234 = mean_density_0(group_3, half_1);
    return 0.25f * _S234 * _S225 * _S233;
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

Bound_0 bound_at_0(uint family_9, float position_6, KernelContext_0 thread* kernelContext_17)
{
    Cell_0 _S235 = locate_0(family_9, position_6, kernelContext_17);
    float _S236 = table_number_0(kernelContext_17->families_0[family_9].before_0 + 2U * _S235.thread_0 + 1U, kernelContext_17);
    thread Bound_0 bound_0;
    (&bound_0)->thread_11 = _S235.thread_0;
    (&bound_0)->turns_2 = round((position_6 - kernelContext_17->families_0[family_9].start_0 - _S236 - _S235.below_0) * kernelContext_17->families_0[family_9].inverse_period_0);
    (&bound_0)->cell_7 = _S235.below_0;
    float _S237 = 2.0f * _S235.half_width_1;
    (&bound_0)->width_1 = _S237;
    (&bound_0)->visible_0 = clamp((_S235.across_2 + _S235.half_width_1) / _S237, 0.0f, 1.0f);
    (&bound_0)->gap_0 = min(_S235.below_0, _S235.below_0 - _S235.across_2 - _S235.half_width_1) + max(_S235.across_2 - _S235.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
    Bound_0 low_0;
    Bound_0 high_0;
};

Stretch_0 stretch_of_0(uint family_10, float centre_1, float size_1, KernelContext_0 thread* kernelContext_18)
{
    float _S238 = centre_1 - floor((centre_1 - kernelContext_18->families_0[family_10].start_0) * kernelContext_18->families_0[family_10].inverse_period_0) * kernelContext_18->families_0[family_10].period_0;
    float _S239 = 0.5f * max(size_1, kernelContext_18->families_0[family_10].smallest_box_0);
    thread Stretch_0 stretch_0;
    Bound_0 _S240 = bound_at_0(family_10, _S238 - _S239, kernelContext_18);
    (&stretch_0)->low_0 = _S240;
    Bound_0 _S241 = bound_at_0(family_10, _S238 + _S239, kernelContext_18);
    (&stretch_0)->high_0 = _S241;
    return stretch_0;
}

float Stretch_turns_0(const Stretch_0 thread* this_6)
{
    return (&this_6->high_0)->turns_2 - (&this_6->low_0)->turns_2;
}

float3 lengths_0(uint family_11, const Stretch_0 thread* stretch_1, KernelContext_0 thread* kernelContext_19)
{
    float _S242 = Stretch_turns_0(stretch_1);
    uint _S243 = kernelContext_19->families_0[family_11].before_0 + 2U * (&stretch_1->low_0)->thread_11;
    uint _S244 = kernelContext_19->families_0[family_11].before_0 + 2U * (&stretch_1->high_0)->thread_11;
    float _S245 = table_number_0(_S244, kernelContext_19);
    float _S246 = table_number_0(_S243, kernelContext_19);
    float _S247 = _S245 - _S246;
    float _S248 = table_number_0(_S244 + 1U, kernelContext_19);
    float _S249 = table_number_0(_S243 + 1U, kernelContext_19);
    float _S250 = _S248 - _S249;
    return float3(_S247 + (&stretch_1->high_0)->visible_0 * (&stretch_1->high_0)->width_1 - (&stretch_1->low_0)->visible_0 * (&stretch_1->low_0)->width_1 + _S242 * kernelContext_19->families_0[family_11].visible_total_0, _S250 - _S247 + (&stretch_1->high_0)->gap_0 - (&stretch_1->low_0)->gap_0 + _S242 * (kernelContext_19->families_0[family_11].period_0 - kernelContext_19->families_0[family_11].visible_total_0), _S250 + (&stretch_1->high_0)->cell_7 - (&stretch_1->low_0)->cell_7 + _S242 * kernelContext_19->families_0[family_11].period_0);
}

float2 integrals_along_0(uint family_12, const Stretch_0 thread* stretch_2, uint quantity_0, KernelContext_0 thread* kernelContext_20)
{
    Family_0 _S251 = kernelContext_20->families_0[family_12];
    uint _S252 = 3U * _S251.quantities_0;
    uint _S253 = kernelContext_20->families_0[family_12].colour_threads_0 + _S252 * (&stretch_2->low_0)->thread_11 + quantity_0;
    uint _S254 = kernelContext_20->families_0[family_12].colour_threads_0 + _S252 * (&stretch_2->high_0)->thread_11 + quantity_0;
    uint _S255 = kernelContext_20->families_0[family_12].colour_threads_0 + _S252 * uint(kernelContext_20->families_0[family_12].count_0) + quantity_0;
    float _S256 = table_number_0(_S253, kernelContext_20);
    float _S257 = table_number_0(_S254, kernelContext_20);
    float _S258 = Stretch_turns_0(stretch_2);
    float _S259 = table_number_0(_S254 + _S251.quantities_0, kernelContext_20);
    float _S260 = table_number_0(_S253 + _S251.quantities_0, kernelContext_20);
    float _S261 = _S259 - _S260 + _S257 * (&stretch_2->high_0)->visible_0 * (&stretch_2->high_0)->width_1 - _S256 * (&stretch_2->low_0)->visible_0 * (&stretch_2->low_0)->width_1;
    float _S262 = table_number_0(_S255 + _S251.quantities_0, kernelContext_20);
    float _S263 = _S261 + _S258 * _S262;
    uint _S264 = 2U * _S251.quantities_0;
    float _S265 = table_number_0(_S254 + _S264, kernelContext_20);
    float _S266 = table_number_0(_S253 + _S264, kernelContext_20);
    float _S267 = _S265 - _S266 + _S257 * (&stretch_2->high_0)->cell_7 - _S256 * (&stretch_2->low_0)->cell_7;
    float _S268 = table_number_0(_S255 + _S264, kernelContext_20);
    return float2(_S263, _S267 + _S258 * _S268);
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
    uint _S269 = entries_0.z;
    uint _S270 = entries_0.x;
    uint _S271 = _S269 - _S270;
    bool _S272 = Stretch_wraps_1(this_9);
    uint _S273;
    if(_S272)
    {
        _S273 = whole_0;
    }
    else
    {
        _S273 = 0U;
    }
    return uint4(_S271 + _S273, entries_0.w - _S269, entries_0.y - _S270, whole_0);
}

uint4 row_differences_0(const Stretch_0 thread* across_4, uint row_2, uint count_2, uint quantities_1, KernelContext_0 thread* kernelContext_21)
{
    uint _S274 = row_2 + (&across_4->low_0)->thread_11 * quantities_1;
    uint _S275 = row_2 + (&across_4->high_0)->thread_11 * quantities_1;
    uint4 _S276 = Stretch_differences_0(across_4, uint4(kernelContext_21->words_0[_S274], kernelContext_21->words_0[_S274 + quantities_1], kernelContext_21->words_0[_S275], kernelContext_21->words_0[_S275 + quantities_1]), kernelContext_21->words_0[row_2 + count_2 * quantities_1]);
    return _S276;
}

float4 Stretch_weights_0(const Stretch_0 thread* this_10)
{
    float _S277 = (&this_10->high_0)->visible_0;
    float _S278 = - (&this_10->low_0)->visible_0;
    float _S279 = Stretch_turns_0(this_10);
    bool _S280 = Stretch_wraps_0(this_10);
    float _S281;
    if(_S280)
    {
        _S281 = 1.0f;
    }
    else
    {
        _S281 = 0.0f;
    }
    return float4(1.0f, _S277, _S278, _S279 - _S281);
}

float integral_on_top_0(uint family_13, const Stretch_0 thread* across_5, const Stretch_0 thread* along_0, uint crossing_count_0, uint quantity_1, KernelContext_0 thread* kernelContext_22)
{
    uint _S282 = uint(kernelContext_22->families_0[family_13].count_0);
    uint _S283 = (_S282 + 1U) * kernelContext_22->families_0[family_13].quantities_0;
    uint _S284 = kernelContext_22->families_0[family_13].colour_areas_0 + quantity_1;
    uint _S285 = (&along_0->low_0)->thread_11;
    uint4 _S286 = row_differences_0(across_5, _S284 + (&along_0->low_0)->thread_11 * _S283, _S282, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S287 = row_differences_0(across_5, _S284 + (_S285 + 1U) * _S283, _S282, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint _S288 = (&along_0->high_0)->thread_11;
    uint4 _S289 = row_differences_0(across_5, _S284 + (&along_0->high_0)->thread_11 * _S283, _S282, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S290 = row_differences_0(across_5, _S284 + (_S288 + 1U) * _S283, _S282, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S291 = row_differences_0(across_5, _S284 + crossing_count_0 * _S283, _S282, kernelContext_22->families_0[family_13].quantities_0, kernelContext_22);
    uint4 _S292 = _S289 - _S286;
    bool _S293 = Stretch_wraps_0(along_0);
    uint4 _S294;
    if(_S293)
    {
        _S294 = _S291;
    }
    else
    {
        _S294 = uint4(int4(int(0)) );
    }
    uint4 _S295 = _S292 + _S294;
    float4 _S296 = Stretch_weights_0(across_5);
    float4 _S297 = Stretch_weights_0(along_0);
    return dot(float4(dot(float4(int4(_S295)), _S296), dot(float4(int4(_S290 - _S289)), _S296), dot(float4(int4(_S287 - _S286)), _S296), dot(float4(int4(_S291)), _S296)), _S297) * kernelContext_22->families_0[family_13].area_unit_0;
}

Albedos_0 with_added_albedos_0(const Albedos_0 thread* albedos_1, float weight_2, uint row_3, KernelContext_0 thread* kernelContext_23)
{
    Albedos_0 _S298 = table_albedos_0(row_3, kernelContext_23);
    thread Albedos_0 sum_0;
    float3 _S299 = float3(weight_2) ;
    (&sum_0)->diffuse_reflect_0 = albedos_1->diffuse_reflect_0 + _S299 * _S298.diffuse_reflect_0;
    (&sum_0)->diffuse_transmit_0 = albedos_1->diffuse_transmit_0 + _S299 * _S298.diffuse_transmit_0;
    (&sum_0)->specular_reflect_0 = albedos_1->specular_reflect_0 + _S299 * _S298.specular_reflect_0;
    (&sum_0)->specular_transmit_0 = albedos_1->specular_transmit_0 + _S299 * _S298.specular_transmit_0;
    return sum_0;
}

Albedos_0 mean_albedos_0(uint family_14, uint crossing_1, const Stretch_0 thread* own_1, const Stretch_0 thread* other_2, bool back_2, KernelContext_0 thread* kernelContext_24)
{
    Albedos_0 _S300 = table_albedos_0(kernelContext_24->families_0[family_14].colour_mean_0, kernelContext_24);
    thread Albedos_0 albedos_2 = _S300;
    if((kernelContext_24->families_0[family_14].quantities_0) == 1U)
    {
        return albedos_2;
    }
    float3 _S301 = lengths_0(crossing_1, other_2, kernelContext_24);
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
        float2 _S302 = integrals_along_0(family_14, own_1, quantity_2, kernelContext_24);
        float _S303 = integral_on_top_0(family_14, own_1, other_2, uint(kernelContext_24->families_0[crossing_1].count_0), quantity_2, kernelContext_24);
        float _S304 = _S302.x;
        float _S305 = _S304 * _S301.x;
        float _S306;
        if(back_2)
        {
            _S306 = _S305 - _S303;
        }
        else
        {
            _S306 = _S303;
        }
        bool _S307 = quantity_2 == 0U;
        if(_S307)
        {
            is_exposed_0 = _S306 > (16.0f * kernelContext_24->families_0[family_14].area_unit_0 * min(_S305 / kernelContext_24->families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S305);
        }
        float _S308 = _S304 * _S301.y;
        float _S309;
        if(is_exposed_0)
        {
            _S309 = _S306;
        }
        else
        {
            _S309 = 0.0f;
        }
        float _S310 = _S308 + _S309 + 0.000244140625f * _S301.z * _S302.y;
        if(_S307)
        {
            weight_3 = 1.0f / max(_S310, 9.99999968265522539e-21f);
        }
        else
        {
            float _S311 = _S310 * weight_3;
            uint _S312 = kernelContext_24->families_0[family_14].colour_axes_0 + 12U * (quantity_2 - 1U);
            thread Albedos_0 _S313 = albedos_2;
            Albedos_0 _S314 = with_added_albedos_0(&_S313, _S311, _S312, kernelContext_24);
            albedos_2 = _S314;
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
    float3 _S315 = float3(weight_4) ;
    (&albedos_3)->diffuse_reflect_0 = mix(first_2->diffuse_reflect_0, second_1->diffuse_reflect_0, _S315);
    (&albedos_3)->diffuse_transmit_0 = mix(first_2->diffuse_transmit_0, second_1->diffuse_transmit_0, _S315);
    (&albedos_3)->specular_reflect_0 = mix(first_2->specular_reflect_0, second_1->specular_reflect_0, _S315);
    (&albedos_3)->specular_transmit_0 = mix(first_2->specular_transmit_0, second_1->specular_transmit_0, _S315);
    return albedos_3;
}

float sheen_scale_0(float x_9, float y_4)
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

float sheen_shear_0(float x_10, float y_5)
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_11, float y_6)
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_8)
{
    float _S316 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S317 = 2.0f * sqrt(_S316) - 1.0f;
    float _S318 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S317, _S318), 0.00999999977648258f, 1.0f), clamp((1.0f - _S316) * sheen_shear_0(_S317, _S318), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S317, _S318), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_8, float3 view_7, float scale_0, float shear_0)
{
    float _S319 = light_8.z;
    bool _S320;
    if(_S319 <= 0.0f)
    {
        _S320 = true;
    }
    else
    {
        _S320 = (view_7.z) <= 0.0f;
    }
    if(_S320)
    {
        return 0.0f;
    }
    float2 _S321 = view_7.xy;
    float _S322 = dot(_S321, _S321);
    float2 _S323;
    if(_S322 > 9.99999968265522539e-21f)
    {
        _S323 = _S321 * float2(rsqrt(_S322)) ;
    }
    else
    {
        _S323 = float2(1.0f, 0.0f);
    }
    float _S324 = scale_0 * dot(light_8.xy, _S323) + shear_0 * _S319;
    float _S325 = scale_0 * (light_8.y * _S323.x - light_8.x * _S323.y);
    float _S326 = _S324 * _S324 + _S325 * _S325 + _S319 * _S319;
    return 0.31830987334251404f * scale_0 * scale_0 * _S319 / max(_S326 * _S326, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_9, float3 view_8, float strength_0, float roughness_9)
{
    float3 _S327 = sheen_lobe_0(view_8.z, roughness_9);
    float _S328 = strength_0 * _S327.z;
    return float2(_S328 * transformed_cosine_0(light_9, view_8, _S327.x, _S327.y), 1.0f - _S328);
}

void accumulate_0(const Frame_0 thread* frame_4, uint2 pixel_0, float4 light_10, KernelContext_0 thread* kernelContext_25)
{
    uint _S329 = pixel_0.y * frame_4->width_0 + pixel_0.x;
    float _S330 = light_10.w;
    float4 _S331 = float4(light_10.xyz + float3((1.0f - _S330))  * float3(frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0), _S330);
    packed_float4 device* _S332 = kernelContext_25->radiance_0+_S329;
    float4 _S333;
    if((frame_4->pass_number_0) == 0U)
    {
        _S333 = _S331;
    }
    else
    {
        _S333 = float4(*(kernelContext_25->radiance_0+_S329))  + _S331;
    }
    *_S332 = packed_float4(_S333) ;
    return;
}

VisiblePoint_0 visible_point_0(const Frame_0 thread* _S334, uint _S335, uint _S336, uint2 _S337, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S338 = kernelContext_26->fabrics_0+_S335;
    uint _S339 = 3U * _S336;
    Vertex_0 _S340 = kernelContext_26->vertices_0[kernelContext_26->corners_0[_S339]];
    Vertex_0 _S341 = kernelContext_26->vertices_0[kernelContext_26->corners_0[_S339 + 1U]];
    Vertex_0 _S342 = kernelContext_26->vertices_0[kernelContext_26->corners_0[_S339 + 2U]];
    thread Vertex_0 _S343 = _S341;
    float3 _S344 = position_of_0(&_S343);
    thread Vertex_0 _S345 = _S340;
    float3 _S346 = position_of_0(&_S345);
    float3 _S347 = _S344 - _S346;
    thread Vertex_0 _S348 = _S342;
    float3 _S349 = position_of_0(&_S348);
    float3 _S350 = _S349 - _S346;
    float3 _S351 = cross(_S347, _S350);
    float _S352 = 1.0f / max(square_0(_S351), 1.00000000317107685e-30f);
    float3 _S353 = camera_right_0(_S334);
    float _S354 = float(_S334->width_0);
    float3 _S355 = _S353 * float3((2.0f / _S354)) ;
    float3 _S356 = camera_up_0(_S334);
    float _S357 = float(_S334->height_0);
    float3 _S358 = _S356 * float3((-2.0f / _S357)) ;
    float _S359 = float(_S337.x) + 0.5f - 0.5f * _S354;
    float _S360 = float(_S337.y) + 0.5f - 0.5f * _S357;
    float3 _S361 = camera_forward_0(_S334);
    float3 _S362 = _S361 + float3(_S359)  * _S355 + float3(_S360)  * _S358;
    float _S363 = dot(_S362, _S351);
    float _S364;
    if((abs(_S363)) > 1.00000000317107685e-30f)
    {
        _S364 = _S363;
    }
    else
    {
        _S364 = 1.00000000317107685e-30f;
    }
    float _S365 = 1.0f / _S364;
    float3 _S366 = camera_origin_0(_S334);
    float3 _S367 = _S346 - _S366;
    float3 _S368 = float3((dot(_S367, _S351) * _S365)) ;
    float3 _S369 = _S362 * _S368 - _S367;
    float3 _S370 = _S368 * (_S355 - _S362 * float3((dot(_S355, _S351) * _S365)) );
    float3 _S371 = _S368 * (_S358 - _S362 * float3((dot(_S358, _S351) * _S365)) );
    float3 _S372 = float3(_S352) ;
    float3 _S373 = cross(_S350, _S351) * _S372;
    float3 _S374 = cross(_S351, _S347) * _S372;
    float _S375 = dot(_S369, _S373);
    float _S376 = dot(_S369, _S374);
    float _S377 = _S341.u_0 - _S340.u_0;
    float _S378 = _S341.v_0 - _S340.v_0;
    float2 _S379 = float2(_S377, _S378);
    float _S380 = _S342.u_0 - _S340.u_0;
    float _S381 = _S342.v_0 - _S340.v_0;
    float2 _S382 = float2(_S380, _S381);
    float2 _S383 = float2(_S340.u_0, _S340.v_0) + float2(_S375)  * _S379 + float2(_S376)  * _S382;
    float2 _S384 = float2(dot(_S370, _S373))  * _S379 + float2(dot(_S370, _S374))  * _S382;
    float2 _S385 = float2(dot(_S371, _S373))  * _S379 + float2(dot(_S371, _S374))  * _S382;
    if((_S377 * _S381 - _S378 * _S380) < 0.0f)
    {
        _S364 = -1.0f;
    }
    else
    {
        _S364 = 1.0f;
    }
    float3 _S386 = float3(_S364)  * (float3(_S381)  * _S347 - float3(_S378)  * _S350);
    float3 _S387 = float3(_S364)  * (float3(_S377)  * _S350 - float3(_S380)  * _S347);
    thread VisiblePoint_0 point_1;
    float _S388 = 1.0f - _S375 - _S376;
    thread Vertex_0 _S389 = _S340;
    float3 _S390 = normal_of_0(&_S389);
    float3 _S391 = float3(_S388)  * _S390;
    thread Vertex_0 _S392 = _S341;
    float3 _S393 = normal_of_0(&_S392);
    float3 _S394 = _S391 + float3(_S375)  * _S393;
    thread Vertex_0 _S395 = _S342;
    float3 _S396 = normal_of_0(&_S395);
    float3 _S397 = normalize(_S394 + float3(_S376)  * _S396);
    (&point_1)->normal_0 = _S397;
    float3 _S398 = normalize(_S386 - _S397 * float3(dot(_S397, _S386)) );
    (&point_1)->axis_x_0 = _S398;
    (&point_1)->axis_y_0 = cross(_S397, _S398);
    (&point_1)->position_0 = _S346 + _S369;
    (&point_1)->view_0 = - normalize(_S362);
    bool _S399 = (dot(cross(_S386, _S387), _S397)) < 0.0f;
    float _S400 = _S338->uv_width_0;
    if(_S399)
    {
        _S364 = - _S338->uv_height_0;
    }
    else
    {
        _S364 = _S338->uv_height_0;
    }
    float2 _S401 = float2(_S400, _S364);
    float2 _S402 = _S383 * _S401;
    if(_S399)
    {
        _S364 = _S338->uv_height_0;
    }
    else
    {
        _S364 = 0.0f;
    }
    (&point_1)->draft_0 = _S402 + float2(0.0f, _S364);
    (&point_1)->draft_dx_0 = _S384 * _S401;
    (&point_1)->draft_dy_0 = _S385 * _S401;
    return point_1;
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

Regime_0 regime_of_0(uint _S403, const Footprint_0 thread* _S404, float _S405, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S406 = kernelContext_27->fabrics_0+_S403;
    float _S407 = Footprint_spread_side_0(_S404);
    float _S408 = clamp((binary_logarithm_0(max(_S407, 9.99999971718068537e-10f)) - _S406->lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    thread Regime_0 regime_0;
    float _S409 = _S408 * _S408 * (3.0f - 2.0f * _S408);
    (&regime_0)->prefiltered_0 = _S409;
    (&regime_0)->threads_1 = _S407 * _S406->lobes_0.threads_per_mm_0;
    float _S410 = mix(max(8.0f / _S405, 1.0f), 1.0f, _S409);
    float _S411;
    if(_S409 < 1.0f)
    {
        _S411 = clamp((&regime_0)->threads_1 * 12.0f, 1.0f, _S410);
    }
    else
    {
        _S411 = 0.0f;
    }
    (&regime_0)->points_0 = _S411;
    return regime_0;
}

struct Hit_0
{
    float x_12;
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

Crossing_0 crossing_at_0(uint _S412, float _S413, float _S414, bool _S415, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S416 = kernelContext_28->fabrics_0+_S412;
    thread Crossing_0 crossing_3;
    Cell_0 _S417 = locate_0(_S416->warp_0, _S413, kernelContext_28);
    (&crossing_3)->warp_1 = _S417;
    Cell_0 _S418 = locate_0(_S416->weft_0, _S414, kernelContext_28);
    (&crossing_3)->weft_1 = _S418;
    uint _S419 = _S416->run_words_0 + 2U * ((&(&crossing_3)->weft_1)->thread_0 * _S416->ends_1 + (&(&crossing_3)->warp_1)->thread_0);
    uint _S420 = kernelContext_28->words_0[_S419];
    (&crossing_3)->warp_word_0 = _S420;
    (&crossing_3)->weft_word_0 = kernelContext_28->words_0[_S419 + 1U];
    (&crossing_3)->warp_above_0 = ((_S420 & 1U) == 1U) != _S415;
    return crossing_3;
}

Sample_0 sample_at_0(uint _S421, float _S422, float _S423, bool _S424, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S425 = kernelContext_29->fabrics_0+_S421;
    thread Sample_0 sample_0;
    Crossing_0 _S426 = crossing_at_0(_S421, _S422, _S423, _S424, kernelContext_29);
    (&sample_0)->crossing_2 = _S426;
    thread Crossing_0 _S427 = _S426;
    Shown_0 _S428 = shown_at_0(&_S427, _S424);
    (&sample_0)->shown_3 = _S428;
    uint _S429;
    if(_S428.is_warp_2)
    {
        _S429 = _S425->warp_0;
    }
    else
    {
        _S429 = _S425->weft_0;
    }
    uint _S430;
    if(_S428.is_warp_2)
    {
        _S430 = _S425->weft_0;
    }
    else
    {
        _S430 = _S425->warp_0;
    }
    thread Cell_0 _S431 = (&(&sample_0)->crossing_2)->warp_1;
    thread Cell_0 _S432 = (&(&sample_0)->crossing_2)->weft_1;
    Cell_0 _S433 = select_cell_0(_S428.is_warp_2, &_S431, &_S432);
    thread Cell_0 _S434 = (&(&sample_0)->crossing_2)->weft_1;
    thread Cell_0 _S435 = (&(&sample_0)->crossing_2)->warp_1;
    Cell_0 _S436 = select_cell_0(_S428.is_warp_2, &_S434, &_S435);
    thread Cell_0 _S437 = _S436;
    Run_0 _S438 = unpack_0(_S429, _S430, _S433.thread_0, &_S437, _S428.word_0, kernelContext_29);
    thread Cell_0 _S439 = _S433;
    Section_0 _S440 = section_at_0(&_S439);
    bool _S441;
    if(_S428.on_top_0)
    {
        _S441 = (_S438.distance_0) < (_S440.drop_0 * _S438.bend_1.sine_0);
    }
    else
    {
        _S441 = false;
    }
    bool _S442;
    if(_S428.on_top_0)
    {
        _S442 = !_S441;
    }
    else
    {
        _S442 = false;
    }
    float _S443;
    if(_S442)
    {
        _S443 = 1.0f;
    }
    else
    {
        _S443 = -1.0f;
    }
    float _S444;
    if(_S441)
    {
        _S444 = _S438.other_reach_0;
    }
    else
    {
        _S444 = _S438.reach_0;
    }
    float _S445;
    if(_S441)
    {
        _S445 = _S444 + _S438.distance_0;
    }
    else
    {
        _S445 = max(_S444 - _S438.distance_0, 0.0f);
    }
    float _S446 = _S444 / _S438.bend_1.sine_0 - _S443 * _S440.drop_0;
    float _S447 = _S445 * _S445;
    float _S448 = max(_S446 * _S446 - _S447, 9.99999968265522539e-21f);
    float _S449 = rsqrt(_S448);
    float _S450 = _S447 / (_S448 * _S449 + _S446);
    bool _S451 = _S445 > 0.0f;
    float _S452;
    if(_S428.on_top_0)
    {
        _S452 = 1.0f;
    }
    else
    {
        _S452 = -1.0f;
    }
    float _S453;
    if(_S438.near_start_0)
    {
        _S453 = 1.0f;
    }
    else
    {
        _S453 = -1.0f;
    }
    float _S454 = _S452 * _S453;
    if(_S451)
    {
        _S452 = _S446 * _S449;
    }
    else
    {
        _S452 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S440.slope_0 * _S452;
    if(_S451)
    {
        _S445 = _S454 * _S445 * _S449;
    }
    else
    {
        _S445 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S445;
    Family_0 _S455 = kernelContext_29->families_0[_S429];
    thread Shown_0 _S456 = _S428;
    thread Run_0 _S457 = _S438;
    thread Cell_0 _S458 = _S436;
    float2 _S459 = dive_0(_S430, &_S456, &_S457, &_S458, kernelContext_29);
    if(_S438.straight_0)
    {
        _S443 = 0.0f;
    }
    else
    {
        _S443 = _S455.height_scale_0 * _S443;
    }
    (&sample_0)->height_6 = _S443 * (_S444 * _S438.bend_1.half_tangent_0 - _S450) - _S455.height_scale_0 * _S440.drop_0 - _S459.x;
    float _S460 = _S455.height_scale_0 * (&sample_0)->slope_across_0;
    float _S461 = _S455.height_scale_0 * (&sample_0)->slope_along_0 - _S459.y;
    if(_S428.is_warp_2)
    {
        _S443 = _S460;
    }
    else
    {
        _S443 = _S461;
    }
    (&sample_0)->slope_x_1 = _S443;
    if(_S428.is_warp_2)
    {
        _S443 = _S461;
    }
    else
    {
        _S443 = _S460;
    }
    (&sample_0)->slope_y_1 = _S443;
    (&sample_0)->run_3 = _S438;
    (&sample_0)->section_1 = _S440;
    return sample_0;
}

float steps_per_length_0(uint _S462, const SearchQuality_0 thread* _S463, float3 _S464, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S465 = kernelContext_30->fabrics_0+_S462;
    return max(max(abs(_S464.x) * _S465->threads_per_x_0, abs(_S464.y) * _S465->threads_per_y_0) * _S463->steps_per_thread_0, abs(_S464.z) * _S465->per_relief_0 * _S463->steps_per_relief_0);
}

float cell_maximum_0(uint _S466, const Crossing_0 thread* _S467, KernelContext_0 thread* kernelContext_31)
{
    Fabric_0 device* _S468 = kernelContext_31->fabrics_0+_S466;
    bool _S469 = _S467->warp_above_0;
    uint _S470;
    if(_S467->warp_above_0)
    {
        _S470 = _S468->warp_0;
    }
    else
    {
        _S470 = _S468->weft_0;
    }
    uint _S471;
    if(_S469)
    {
        _S471 = _S467->warp_word_0;
    }
    else
    {
        _S471 = _S467->weft_word_0;
    }
    return float(_S471 >> 28U) * kernelContext_31->families_0[_S470].height_scale_0 * kernelContext_31->families_0[_S470].level_0;
}

Probe_0 probe_0(uint _S472, float _S473, float _S474, bool _S475, bool _S476, bool _S477, KernelContext_0 thread* kernelContext_32)
{
    Sample_0 _S478 = sample_at_0(_S472, _S473, _S474, _S475, kernelContext_32);
    thread Probe_0 probe_1;
    (&probe_1)->height_3 = _S478.height_6;
    (&probe_1)->hole_4 = _S478.shown_3.hole_3;
    (&probe_1)->slope_x_0 = _S478.slope_x_1;
    (&probe_1)->slope_y_0 = _S478.slope_y_1;
    uint _S479;
    if(_S478.shown_3.is_warp_2)
    {
        _S479 = _S478.crossing_2.warp_1.thread_0 * 2U + 1U;
    }
    else
    {
        _S479 = _S478.crossing_2.weft_1.thread_0 * 2U;
    }
    (&probe_1)->yarn_1 = _S479;
    thread Crossing_0 _S480 = _S478.crossing_2;
    float _S481 = cell_maximum_0(_S472, &_S480, kernelContext_32);
    (&probe_1)->cell_max_0 = _S481;
    float _S482;
    if(_S476)
    {
        _S482 = _S478.crossing_2.warp_1.above_0;
    }
    else
    {
        _S482 = _S478.crossing_2.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S482;
    if(_S477)
    {
        _S482 = _S478.crossing_2.weft_1.above_0;
    }
    else
    {
        _S482 = _S478.crossing_2.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S482;
    bool _S483 = !_S478.shown_3.is_warp_2;
    thread Cell_0 _S484 = _S478.crossing_2.warp_1;
    thread Shown_0 _S485 = _S478.shown_3;
    thread Run_0 _S486 = _S478.run_3;
    float _S487 = outline_distance_0(&_S484, &_S485, &_S486, _S483, _S476);
    (&probe_1)->edge_x_0 = _S487;
    thread Cell_0 _S488 = _S478.crossing_2.weft_1;
    thread Shown_0 _S489 = _S478.shown_3;
    thread Run_0 _S490 = _S478.run_3;
    float _S491 = outline_distance_0(&_S488, &_S489, &_S490, _S478.shown_3.is_warp_2, _S477);
    (&probe_1)->edge_y_0 = _S491;
    return probe_1;
}

bool is_free_0(uint _S492, const SearchQuality_0 thread* _S493, float3 _S494, float3 _S495, bool _S496, float _S497, KernelContext_0 thread* kernelContext_33)
{
    float _S498 = _S495.z;
    if(_S498 <= 0.0f)
    {
        return false;
    }
    float _S499 = _S493->shadow_share_0;
    float _S500 = steps_per_length_0(_S492, _S493, _S495, kernelContext_33);
    float _S501 = 1.0f / max(_S499 * _S500, 9.99999971718068537e-10f);
    StepControl_0 _S502 = step_control_0(_S495.xy, _S501);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S503;
        if(count_3 < 1024U)
        {
            _S503 = (_S494.z + _S498 * distance_1) < _S497;
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
        float3 _S504 = _S494 + _S495 * float3(distance_1) ;
        Probe_0 _S505 = probe_0(_S492, _S504.x, _S504.y, _S496, _S502.right_0, _S502.up_0, kernelContext_33);
        float _S506 = _S504.z;
        float _S507 = _S506 - _S505.height_3;
        float _S508 = _S498 - _S505.slope_x_0 * _S495.x - _S505.slope_y_0 * _S495.y;
        bool _S509;
        if(!_S505.hole_4)
        {
            _S509 = _S507 < 0.0f;
        }
        else
        {
            _S509 = false;
        }
        if(_S509)
        {
            return false;
        }
        thread PreviousSample_0 _S510 = previous_3;
        thread Probe_0 _S511 = _S505;
        float _S512 = way_back_to_dip_0(&_S510, _S507, _S508, last_step_0, &_S511);
        if(_S512 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S512;
            distance_1 = distance_1 - _S512;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S513 = _S506 > (_S505.cell_max_0);
        thread Probe_0 _S514 = _S505;
        PreviousSample_0 _S515 = after_sample_0(_S507, _S508, &_S514, _S513);
        float last_step_2;
        if(_S513)
        {
            thread StepControl_0 _S516 = _S502;
            float _S517 = StepControl_to_cell_exit_0(&_S516, _S505.side_x_0, _S505.side_y_0);
            last_step_2 = max(_S517, _S501);
        }
        else
        {
            thread StepControl_0 _S518 = _S502;
            thread Probe_0 _S519 = _S505;
            float _S520 = StepControl_to_next_sample_0(&_S518, &_S519, _S507, _S508);
            last_step_2 = _S520;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S515;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S521, const SearchQuality_0 thread* _S522, float _S523, float _S524, float3 _S525, bool _S526, KernelContext_0 thread* kernelContext_34)
{
    Fabric_0 device* _S527 = kernelContext_34->fabrics_0+_S521;
    Sample_0 _S528 = sample_at_0(_S521, _S523, _S524, _S526, kernelContext_34);
    if(!_S528.shown_3.hole_3)
    {
        return false;
    }
    float3 _S529 = float3(_S523, _S524, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S530;
        if(side_0 < 2U)
        {
            _S530 = passes_0;
        }
        else
        {
            _S530 = false;
        }
        if(_S530)
        {
        }
        else
        {
            break;
        }
        float3 _S531;
        if(side_0 == 0U)
        {
            _S531 = _S525;
        }
        else
        {
            _S531 = float3(- _S525.x, - _S525.y, _S525.z);
        }
        bool _S532 = is_free_0(_S521, _S522, _S529, _S531, _S526 != (side_0 == 1U), _S527->height_high_0, kernelContext_34);
        uint _S533 = side_0 + 1U;
        passes_0 = _S532;
        side_0 = _S533;
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

float max_height_along_0(uint _S534, float _S535, float _S536, float _S537, float3 _S538, bool _S539, KernelContext_0 thread* kernelContext_35)
{
    Fabric_0 device* _S540 = kernelContext_35->fabrics_0+_S534;
    Cell_0 _S541 = locate_0(_S540->warp_0, _S535, kernelContext_35);
    uint _S542 = _S541.thread_0 / 2U;
    Cell_0 _S543 = locate_0(_S540->weft_0, _S536, kernelContext_35);
    uint _S544 = _S543.thread_0 / 2U;
    float _S545 = _S538.x;
    uint _S546;
    if(_S545 > 0.0f)
    {
        _S546 = 1U;
    }
    else
    {
        _S546 = 0U;
    }
    float _S547 = _S538.y;
    uint _S548;
    if(_S547 > 0.0f)
    {
        _S548 = 2U;
    }
    else
    {
        _S548 = 0U;
    }
    uint _S549 = kernelContext_35->words_0[_S540->max_heights_0 + 4U * (_S544 * _S540->max_height_columns_0 + _S542) + (_S546 + _S548)];
    int number_0;
    if(_S539)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S550 = _S549 >> uint(number_0);
    float _S551 = max(abs(_S545) * _S540->threads_per_x_0, abs(_S547) * _S540->threads_per_y_0) / _S538.z;
    float _S552 = _S540->height_high_0;
    float max_height_0 = _S540->height_high_0;
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
        if(((max_height_0 - _S537) * _S551) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S550 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S552);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S553, float _S554, float _S555, bool _S556, bool _S557, bool _S558, KernelContext_0 thread* kernelContext_36)
{
    Crossing_0 _S559 = crossing_at_0(_S553, _S554, _S555, _S556, kernelContext_36);
    thread Crossing_0 _S560 = _S559;
    float _S561 = cell_maximum_0(_S553, &_S560, kernelContext_36);
    float _S562;
    if(_S557)
    {
        _S562 = _S559.warp_1.above_0;
    }
    else
    {
        _S562 = _S559.warp_1.below_0;
    }
    float _S563;
    if(_S558)
    {
        _S563 = _S559.weft_1.above_0;
    }
    else
    {
        _S563 = _S559.weft_1.below_0;
    }
    return float3(_S561, _S562, _S563);
}

float first_sample_height_0(uint _S564, const ViewRay_0 thread* _S565, const StepControl_0 thread* _S566, bool _S567, KernelContext_0 thread* kernelContext_37)
{
    float _S568 = max_height_along_0(_S564, _S565->origin_0.x, _S565->origin_0.y, 0.0f, float3(_S565->slope_1, 1.0f), _S567, kernelContext_37);
    uint count_4 = 0U;
    float height_8 = _S568;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S569 = ViewRay_at_0(_S565, height_8);
        float3 _S570 = cell_bounds_0(_S564, _S569.x, _S569.y, _S567, _S566->right_0, _S566->up_0, kernelContext_37);
        float _S571 = height_8 - _S570.x;
        float _S572 = StepControl_to_cell_exit_0(_S566, _S570.y, _S570.z);
        float height_9 = height_8 - clamp(_S571, 0.0f, _S572);
        if(_S571 <= _S572)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + 1U;
        height_8 = height_9;
    }
    return height_8;
}

ViewRayEnd_0 search_down_0(uint _S573, const ViewRay_0 thread* _S574, const StepControl_0 thread* _S575, bool _S576, KernelContext_0 thread* kernelContext_38)
{
    Fabric_0 device* _S577 = kernelContext_38->fabrics_0+_S573;
    float _S578 = _S577->height_low_0 - (_S577->height_high_0 - _S577->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S579 = first_sample_height_0(_S573, _S574, _S575, _S576, kernelContext_38);
    (&end_1)->height_7 = _S579;
    (&end_1)->last_step_3 = _S575->epsilon_0;
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
        float2 _S580 = ViewRay_at_0(_S574, (&end_1)->height_7);
        Probe_0 _S581 = probe_0(_S573, _S580.x, _S580.y, _S576, _S575->right_0, _S575->up_0, kernelContext_38);
        float _S582 = (&end_1)->height_7 - _S581.height_3;
        thread Probe_0 _S583 = _S581;
        float _S584 = ViewRay_rate_0(_S574, &_S583);
        (&end_1)->depth_1 = - _S582;
        (&end_1)->rate_4 = _S584;
        bool _S585;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S585 = !_S581.hole_4;
        }
        else
        {
            _S585 = false;
        }
        bool _S586;
        if(_S585)
        {
            _S586 = ((&(&end_1)->previous_4)->yarn_0) == (_S581.yarn_1);
        }
        else
        {
            _S586 = false;
        }
        (&end_1)->smooth_0 = _S586;
        bool _S587;
        if(!_S581.hole_4)
        {
            _S587 = _S582 <= 0.0f;
        }
        else
        {
            _S587 = false;
        }
        bool _S588;
        if(_S587)
        {
            _S588 = true;
        }
        else
        {
            _S588 = ((&end_1)->height_7) <= _S578;
        }
        if(_S588)
        {
            break;
        }
        thread PreviousSample_0 _S589 = (&end_1)->previous_4;
        thread Probe_0 _S590 = _S581;
        float _S591 = way_back_to_dip_0(&_S589, _S582, _S584, (&end_1)->last_step_3, &_S590);
        if(_S591 >= 0.0f)
        {
            (&end_1)->height_7 = (&end_1)->height_7 + _S591;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S591;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S592 = StepControl_to_cell_exit_0(_S575, _S581.side_x_0, _S581.side_y_0);
        float _S593 = min(_S592, (&end_1)->height_7 - _S581.cell_max_0);
        thread Probe_0 _S594 = _S581;
        float _S595 = StepControl_to_next_sample_0(_S575, &_S594, _S582, _S584);
        bool _S596 = _S593 > _S595;
        thread Probe_0 _S597 = _S581;
        PreviousSample_0 _S598 = after_sample_0(_S582, _S584, &_S597, _S596);
        (&end_1)->previous_4 = _S598;
        float _S599 = max(_S593, _S595);
        (&end_1)->last_step_3 = _S599;
        (&end_1)->height_7 = (&end_1)->height_7 - _S599;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S600, const ViewRay_0 thread* _S601, const StepControl_0 thread* _S602, bool _S603, const ViewRayEnd_0 thread* _S604, uint _S605, KernelContext_0 thread* kernelContext_39)
{
    Fabric_0 device* _S606 = kernelContext_39->fabrics_0+_S600;
    float _S607 = _S606->height_high_0 - _S606->height_low_0;
    float _S608 = _S604->height_7;
    float _S609 = _S604->last_step_3;
    float above_2 = _S604->height_7 + _S604->last_step_3;
    float above_gap_1 = clamp((&_S604->previous_4)->clearance_0, 0.0f, _S607);
    float under_gap_1 = clamp(_S604->depth_1, 0.0f, _S607);
    float _S610 = cubic_root_0(above_gap_1, - under_gap_1, (&_S604->previous_4)->rate_0 * _S604->last_step_3, _S604->rate_4 * _S604->last_step_3);
    bool _S611 = _S604->smooth_0;
    float middle_0;
    if(_S604->smooth_0)
    {
        middle_0 = above_2 - _S610 * _S609;
    }
    else
    {
        middle_0 = between_0(above_2, _S608, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S608;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S605)
        {
        }
        else
        {
            break;
        }
        float2 _S612 = ViewRay_at_0(_S601, middle_0);
        Probe_0 _S613 = probe_0(_S600, _S612.x, _S612.y, _S603, _S602->right_0, _S602->up_0, kernelContext_39);
        float _S614;
        if(_S613.hole_4)
        {
            _S614 = -1.0e+09f;
        }
        else
        {
            _S614 = _S613.height_3;
        }
        float _S615 = clamp(middle_0 - _S614, - _S607, _S607);
        float _S616;
        if(_S615 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S616 = 0.5f * above_gap_2;
            }
            else
            {
                _S616 = above_gap_2;
            }
            float _S617 = - _S615;
            under_1 = middle_0;
            above_gap_2 = _S616;
            under_gap_2 = _S617;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S616 = 0.5f * under_gap_2;
            }
            else
            {
                _S616 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S615;
            under_gap_2 = _S616;
            side_1 = -1.0f;
        }
        if(_S611)
        {
            thread Probe_0 _S618 = _S613;
            float _S619 = ViewRay_rate_0(_S601, &_S618);
            middle_0 = clamp(middle_0 + _S615 / min(_S619, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S611)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S620, const SearchQuality_0 thread* _S621, float _S622, float _S623, float3 _S624, bool _S625, KernelContext_0 thread* kernelContext_40)
{
    float _S626 = max(_S624.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S622, _S623);
    float2 _S627 = _S624.xy / float2(_S626) ;
    (&ray_0)->slope_1 = _S627;
    float2 _S628 = - _S627;
    float _S629 = steps_per_length_0(_S620, _S621, _S624, kernelContext_40);
    StepControl_0 _S630 = step_control_0(_S628, 1.0f / max(_S629 / _S626, 9.99999971718068537e-10f));
    thread ViewRay_0 _S631 = ray_0;
    thread StepControl_0 _S632 = _S630;
    ViewRayEnd_0 _S633 = search_down_0(_S620, &_S631, &_S632, _S625, kernelContext_40);
    thread Hit_0 hit_0;
    (&hit_0)->hole_5 = false;
    thread ViewRay_0 _S634 = ray_0;
    thread StepControl_0 _S635 = _S630;
    thread ViewRayEnd_0 _S636 = _S633;
    float _S637 = refined_height_0(_S620, &_S634, &_S635, _S625, &_S636, _S621->refinements_0, kernelContext_40);
    (&hit_0)->height_5 = _S637;
    thread ViewRay_0 _S638 = ray_0;
    float2 _S639 = ViewRay_at_0(&_S638, _S637);
    (&hit_0)->x_12 = _S639.x;
    (&hit_0)->y_7 = _S639.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S640, const SearchQuality_0 thread* _S641, float _S642, float _S643, float3 _S644, bool _S645, KernelContext_0 thread* kernelContext_41)
{
    bool _S646 = passes_through_0(_S640, _S641, _S642, _S643, _S644, _S645, kernelContext_41);
    if(!_S646)
    {
        Hit_0 _S647 = first_hit_of_yarn_0(_S640, _S641, _S642, _S643, _S644, _S645, kernelContext_41);
        return _S647;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_12 = _S642;
    (&hit_1)->y_7 = _S643;
    (&hit_1)->height_5 = 0.0f;
    (&hit_1)->hole_5 = true;
    return hit_1;
}

SurfacePoint_0 surface_at_0(uint _S648, float _S649, float _S650, bool _S651, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S652 = kernelContext_42->fabrics_0+_S648;
    Sample_0 _S653 = sample_at_0(_S648, _S649, _S650, _S651, kernelContext_42);
    float _S654;
    if(_S653.shown_3.is_warp_2)
    {
        _S654 = _S653.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S654 = _S653.crossing_2.weft_1.half_width_1;
    }
    uint _S655;
    if(_S653.shown_3.is_warp_2)
    {
        _S655 = _S652->warp_0;
    }
    else
    {
        _S655 = _S652->weft_0;
    }
    Family_0 _S656 = kernelContext_42->families_0[_S655];
    float _S657;
    if(_S651)
    {
        _S657 = -1.0f;
    }
    else
    {
        _S657 = 1.0f;
    }
    float _S658 = _S656.twist_sine_0 * _S657;
    Family_0 _S659 = kernelContext_42->families_0[_S655];
    if(_S653.shown_3.is_warp_2)
    {
        _S657 = 1.0f;
    }
    else
    {
        _S657 = -1.0f;
    }
    float2 _S660 = fibre_direction_0(_S653.slope_across_0, _S657 * _S653.slope_along_0, _S658, _S659.twist_cosine_0);
    float _S661;
    if(_S653.shown_3.is_warp_2)
    {
        _S661 = _S653.slope_x_1;
    }
    else
    {
        _S661 = _S653.slope_y_1;
    }
    float _S662;
    if(_S653.shown_3.is_warp_2)
    {
        _S662 = _S653.slope_y_1;
    }
    else
    {
        _S662 = _S653.slope_x_1;
    }
    float _S663 = _S660.x;
    float _S664 = _S660.y;
    float _S665 = _S661 * _S663 + _S657 * _S662 * _S664;
    float _S666 = _S654 * 1.0154266357421875f;
    float _S667 = _S666 * arc_sine_0(clamp(_S653.section_1.across_3 / _S666, -1.0f, 1.0f));
    if(_S653.shown_3.is_warp_2)
    {
        _S654 = _S650;
    }
    else
    {
        _S654 = - _S649;
    }
    thread SurfacePoint_0 point_2;
    (&point_2)->hole_0 = _S653.shown_3.hole_3;
    (&point_2)->is_warp_0 = _S653.shown_3.is_warp_2;
    (&point_2)->warp_thread_0 = _S653.crossing_2.warp_1.thread_0;
    (&point_2)->weft_thread_0 = _S653.crossing_2.weft_1.thread_0;
    (&point_2)->height_1 = _S653.height_6;
    (&point_2)->normal_1 = normalize(float3(- _S653.slope_x_1, - _S653.slope_y_1, 1.0f));
    float3 _S668;
    if(_S653.shown_3.is_warp_2)
    {
        _S668 = float3(_S663, _S664, _S665);
    }
    else
    {
        _S668 = float3(- _S664, _S663, _S665);
    }
    (&point_2)->tangent_0 = normalize(_S668);
    (&point_2)->across_0 = _S653.section_1.across_3;
    (&point_2)->fibre_across_0 = _S667 * _S659.twist_cosine_0 + _S654 * _S658;
    (&point_2)->fibre_along_0 = _S654 * _S659.twist_cosine_0 - _S667 * _S658;
    return point_2;
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_6;
    bool is_warp_3;
    float x_13;
    float y_8;
    float height_10;
    float3 normal_7;
    float3 tangent_7;
    float roughness_10;
    Albedos_0 albedos_5;
};

Albedos_0 vary_albedos_0(uint _S669, const Albedos_0 thread* _S670, uint _S671, uint _S672, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S673 = kernelContext_43->fabrics_0+_S669;
    float3 _S674 = max(_S670->specular_reflect_0, _S670->specular_transmit_0);
    float3 _S675 = _S670->diffuse_reflect_0 + _S670->diffuse_transmit_0;
    float3 _S676 = float3(_S673->layer_bound_0) ;
    float3 _S677 = float3(1.0f) ;
    float3 _S678 = float3(bounded_gain_0(thread_gain_0(_S671, _S673->colour_noise_0, _S673->seed_0), _S675, _S677 - _S676 * _S674)) ;
    float _S679 = bounded_gain_0(fibre_gain_0(_S671, _S672, _S673->fibre_noise_0, _S673->seed_0), _S674, min((_S677 - _S678 * _S675) / _S676, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S678 * _S670->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S678 * _S670->diffuse_transmit_0;
    float3 _S680 = float3(_S679) ;
    (&varied_0)->specular_reflect_0 = _S680 * _S670->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S680 * _S670->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S681, const SurfacePoint_0 thread* _S682, const Albedos_0 thread* _S683, float _S684, float _S685, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S686 = kernelContext_44->fabrics_0+_S681;
    bool _S687 = _S682->is_warp_0;
    float _S688;
    if(_S682->is_warp_0)
    {
        _S688 = _S684;
    }
    else
    {
        _S688 = _S685;
    }
    float _S689 = _S688 - _S682->across_0;
    uint _S690;
    if(_S687)
    {
        _S690 = _S686->warp_0;
    }
    else
    {
        _S690 = _S686->weft_0;
    }
    Family_0 _S691 = kernelContext_44->families_0[_S690];
    int _S692 = int(kernelContext_44->families_0[_S690].count_0);
    if(_S687)
    {
        _S690 = _S682->warp_thread_0;
    }
    else
    {
        _S690 = _S682->weft_thread_0;
    }
    uint _S693 = uint(int(floor(_S689 / _S691.period_0)) * _S692 + int(_S690)) * 2U;
    if(_S687)
    {
        _S690 = 1U;
    }
    else
    {
        _S690 = 0U;
    }
    float _S694 = floor(_S682->fibre_across_0 / _S686->fibre_size_0);
    Albedos_0 _S695 = vary_albedos_0(_S681, _S683, _S693 + _S690, uint(int(_S694)) * 65536U + uint(int(floor(_S682->fibre_along_0 / (_S686->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S694))), kernelContext_44);
    return _S695;
}

YarnPoint_0 yarn_point_of_0(uint _S696, const SurfacePoint_0 thread* _S697, float _S698, float _S699, bool _S700, bool _S701, KernelContext_0 thread* kernelContext_45)
{
    Fabric_0 device* _S702 = kernelContext_45->fabrics_0+_S696;
    bool _S703 = _S697->is_warp_0;
    uint _S704;
    if(_S697->is_warp_0)
    {
        _S704 = _S702->warp_0;
    }
    else
    {
        _S704 = _S702->weft_0;
    }
    uint _S705;
    if(_S703)
    {
        _S705 = _S697->warp_thread_0;
    }
    else
    {
        _S705 = _S697->weft_thread_0;
    }
    Albedos_0 _S706 = albedos_of_0(_S704, _S705, kernelContext_45);
    bool _S707;
    if((_S702->fibre_noise_0) > 0.0f)
    {
        _S707 = true;
    }
    else
    {
        _S707 = (_S702->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_6;
    if(_S707)
    {
        thread Albedos_0 _S708 = _S706;
        Albedos_0 _S709 = varied_at_0(_S696, _S697, &_S708, _S698, _S699, kernelContext_45);
        albedos_6 = _S709;
    }
    else
    {
        albedos_6 = _S706;
    }
    thread YarnPoint_0 point_3;
    (&point_3)->back_3 = _S700;
    (&point_3)->hole_6 = _S701;
    (&point_3)->is_warp_3 = _S703;
    (&point_3)->x_13 = _S698;
    (&point_3)->y_8 = _S699;
    (&point_3)->height_10 = _S697->height_1;
    (&point_3)->normal_7 = _S697->normal_1;
    (&point_3)->tangent_7 = _S697->tangent_0;
    (&point_3)->roughness_10 = kernelContext_45->families_0[_S704].roughness_0;
    (&point_3)->albedos_5 = albedos_6;
    return point_3;
}

bool unoccluded_0(uint _S710, const SearchQuality_0 thread* _S711, float _S712, float _S713, float _S714, float3 _S715, bool _S716, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S717 = kernelContext_46->fabrics_0+_S710;
    if((_S715.z) <= 0.0f)
    {
        return false;
    }
    float _S718 = max_height_along_0(_S710, _S712, _S713, _S714, _S715, _S716, kernelContext_46);
    bool _S719 = is_free_0(_S710, _S711, float3(_S712, _S713, _S714 + _S717->lift_0), _S715, _S716, _S718, kernelContext_46);
    return _S719;
}

bool is_lit_0(uint _S720, const SearchQuality_0 thread* _S721, const YarnPoint_0 thread* _S722, float3 _S723, KernelContext_0 thread* kernelContext_47)
{
    if(_S722->hole_6)
    {
        return true;
    }
    bool _S724 = _S722->back_3;
    float3 _S725 = to_face_frame_0(_S723, _S722->back_3);
    float _S726 = _S725.z;
    bool _S727 = _S726 < 0.0f;
    float3 _S728 = _S722->normal_7;
    float _S729 = _S722->height_10;
    float3 normal_8;
    float height_11;
    if(_S727)
    {
        SurfacePoint_0 _S730 = surface_at_0(_S720, _S722->x_13, _S722->y_8, !_S724, kernelContext_47);
        normal_8 = _S730.normal_1;
        height_11 = _S730.height_1;
    }
    else
    {
        normal_8 = _S728;
        height_11 = _S729;
    }
    float3 _S731 = float3(_S725.xy, abs(_S726));
    if((dot(normal_8, _S731)) <= 0.0f)
    {
        return false;
    }
    bool _S732 = unoccluded_0(_S720, _S721, _S722->x_13, _S722->y_8, height_11, _S731, _S724 != _S727, kernelContext_47);
    return _S732;
}

Components_0 components_of_point_0(uint _S733, const SearchQuality_0 thread* _S734, const YarnPoint_0 thread* _S735, float3 _S736, float3 _S737, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S738 = kernelContext_48->fabrics_0+_S733;
    thread Components_0 result_1 = no_components_0();
    bool _S739 = _S735->hole_6;
    float _S740;
    if(_S735->hole_6)
    {
        _S740 = 1.0f;
    }
    else
    {
        _S740 = 0.0f;
    }
    (&result_1)->hole_2 = _S740;
    bool _S741;
    if(_S739)
    {
        _S741 = true;
    }
    else
    {
        bool _S742 = is_lit_0(_S733, _S734, _S735, _S736, kernelContext_48);
        _S741 = !_S742;
    }
    if(_S741)
    {
        return result_1;
    }
    float3 _S743 = to_face_frame_0(_S736, _S735->back_3);
    float3 _S744 = to_face_frame_0(_S737, _S735->back_3);
    bool _S745 = (_S743.z) < 0.0f;
    float3 _S746;
    if(_S745)
    {
        _S746 = - _S743;
    }
    else
    {
        _S746 = _S743;
    }
    float3 _S747 = _S735->normal_7;
    float _S748 = diffuse_reflection_0(_S746, _S735->normal_7, _S738->diffuse_blend_0);
    if(_S745)
    {
        _S740 = transmission_0(_S743, _S744, _S747, _S735->tangent_7, _S735->roughness_10, _S738->optical_depth_0);
    }
    else
    {
        _S740 = reflection_0(_S743, _S744, _S747, _S735->tangent_7, _S735->roughness_10, _S738->optical_depth_0);
    }
    bool _S749 = _S735->is_warp_3;
    float _S750;
    if(_S735->is_warp_3)
    {
        _S750 = _S748;
    }
    else
    {
        _S750 = 0.0f;
    }
    (&result_1)->diffuse_warp_0 = _S750;
    if(_S749)
    {
        _S750 = 0.0f;
    }
    else
    {
        _S750 = _S748;
    }
    (&result_1)->diffuse_weft_0 = _S750;
    if(_S749)
    {
        _S750 = _S740;
    }
    else
    {
        _S750 = 0.0f;
    }
    (&result_1)->specular_warp_0 = _S750;
    if(_S749)
    {
        _S740 = 0.0f;
    }
    (&result_1)->specular_weft_0 = _S740;
    (&result_1)->light_visibility_0 = 1.0f;
    return result_1;
}

struct CoverageTaps_0
{
    array<uint, int(9)> nodes_1;
};

float3 pyramid_level_0(uint _S751, float _S752, KernelContext_0 thread* kernelContext_49)
{
    uint _S753 = (kernelContext_49->fabrics_0+_S751)->lobes_0.levels_0 + 4U * uint(min(_S752, (kernelContext_49->fabrics_0+_S751)->lobes_0.last_level_0));
    float _S754 = table_number_0(_S753, kernelContext_49);
    float _S755 = table_number_0(_S753 + 1U, kernelContext_49);
    float _S756 = table_number_0(_S753 + 2U, kernelContext_49);
    return float3(_S754, _S755, _S756);
}

CoverageTaps_0 coverage_taps_0(uint _S757, const Footprint_0 thread* _S758, bool _S759, KernelContext_0 thread* kernelContext_50)
{
    Fabric_0 device* _S760 = kernelContext_50->fabrics_0+_S757;
    float _S761 = Footprint_spread_side_0(_S758);
    Lobes_0 _S762 = _S760->lobes_0;
    float _S763 = _S761 * _S760->lobes_0.inverse_base_size_0;
    float3 _S764 = pyramid_level_0(_S757, floor(binary_logarithm_0(max(0.68000000715255737f * _S763, 1.0f))), kernelContext_50);
    float _S765 = 1.0f / max(_S763, 9.99999997475242708e-07f);
    float2 _S766 = float2(kernelContext_50->families_0[_S760->warp_0].inverse_period_0, kernelContext_50->families_0[_S760->weft_0].inverse_period_0);
    float2 _S767 = _S758->centre_0 * _S766;
    float2 _S768 = float2(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S765 * _S765), 0.0f, 1.0f)), 0.3333333432674408f * _S765), 1.0f)) ;
    float2 _S769 = _S758->dx_0 * _S766 * _S768;
    float2 _S770 = _S758->dy_0 * _S766 * _S768;
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
        float2 _S771 = _S767 + float2(TAP_OFFSETS_0[number_1].x)  * _S769 + float2(TAP_OFFSETS_0[number_1].y)  * _S770;
        float _S772 = _S764.y;
        float _S773 = wrapped_cell_0(_S771.x, _S772);
        float _S774 = wrapped_cell_0(_S771.y, _S764.z);
        uint _S775;
        if(_S759)
        {
            _S775 = _S762.face_nodes_0;
        }
        else
        {
            _S775 = 0U;
        }
        (&taps_3)->nodes_1[number_1] = _S775 + uint(_S774 * _S772 + _S773 + _S764.x);
        number_1 = number_1 + 1U;
    }
    return taps_3;
}

float4 coverage_of_pack_0(uint _S776, const CoverageTaps_0 thread* _S777, uint _S778, KernelContext_0 thread* kernelContext_51)
{
    Fabric_0 device* _S779 = kernelContext_51->fabrics_0+_S776;
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
        uint _S780 = kernelContext_51->words_0[_S779->lobes_0.coverage_0 + _S777->nodes_1[number_2] * _S779->lobes_0.packs_0 + _S778];
        uint even_2 = even_1 + (_S780 & 16711935U);
        uint odd_2 = odd_1 + ((_S780 >> 8U) & 16711935U);
        number_2 = number_2 + 1U;
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / float4(9.0f) ;
}

float coverage_of_holes_0(uint _S781, const CoverageTaps_0 thread* _S782, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S783 = kernelContext_52->fabrics_0+_S781;
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
        uint total_1 = total_0 + ((kernelContext_52->words_0[_S783->lobes_0.coverage_holes_0 + _S782->nodes_1[number_3] / 4U] >> (8U * (_S782->nodes_1[number_3] % 4U))) & 255U);
        number_3 = number_3 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S784, const CoverageTaps_0 thread* _S785, const NodeTaps_0 thread* _S786, bool _S787, KernelContext_0 thread* kernelContext_53)
{
    Lobes_0 _S788 = (kernelContext_53->fabrics_0+_S784)->lobes_0;
    float4 _S789 = interpolate_table_0(_S786, (kernelContext_53->fabrics_0+_S784)->lobes_0.projected_area_0 + (kernelContext_53->fabrics_0+_S784)->lobes_0.packs_0, (kernelContext_53->fabrics_0+_S784)->lobes_0.packs_0 + 1U, kernelContext_53);
    float _S790 = _S789.x;
    float _S791;
    if(_S787)
    {
        _S791 = _S788.back_hole_weight_0;
    }
    else
    {
        _S791 = _S788.front_hole_weight_0;
    }
    float _S792 = coverage_of_holes_0(_S784, _S785, kernelContext_53);
    return min(_S792 * _S790 * _S790 * _S791, 1.0f);
}

Components_0 prefiltered_components_0(uint _S793, const Footprint_0 thread* _S794, float3 _S795, float3 _S796, bool _S797, KernelContext_0 thread* kernelContext_54)
{
    Fabric_0 device* _S798 = kernelContext_54->fabrics_0+_S793;
    CoverageTaps_0 _S799 = coverage_taps_0(_S793, _S794, _S797, kernelContext_54);
    NodeTaps_0 _S800 = node_taps_0(_S796);
    thread NodeTaps_0 view_nodes_0 = _S800;
    thread NodeTaps_0 light_nodes_0 = node_taps_0(_S795);
    thread NodeTaps_0 seen_nodes_0 = _S800;
    uint _S801;
    if(_S797)
    {
        _S801 = 1U;
    }
    else
    {
        _S801 = 0U;
    }
    (&view_nodes_0)->nodes_0 = (&view_nodes_0)->nodes_0 + uint4((_S801 * 256U)) ;
    uint _S802 = 2U * _S801;
    (&seen_nodes_0)->nodes_0 = (&seen_nodes_0)->nodes_0 + uint4((_S802 * 256U)) ;
    uint _S803;
    if((_S795.z) < 0.0f)
    {
        _S803 = 1U;
    }
    else
    {
        _S803 = 0U;
    }
    (&light_nodes_0)->nodes_0 = (&light_nodes_0)->nodes_0 + uint4(((_S802 + _S803) * 256U)) ;
    float3 _S804 = half_vector_0(_S795, _S796);
    float3 _S805 = shadow_correlation_0(_S795, _S796);
    if(_S797)
    {
        _S803 = _S798->lobes_0.back_warp_packs_0;
    }
    else
    {
        _S803 = _S798->lobes_0.front_warp_packs_0;
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
        Lobes_0 _S806 = _S798->lobes_0;
        if(pack_0 < (_S798->lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        thread CoverageTaps_0 _S807 = _S799;
        float4 _S808 = coverage_of_pack_0(_S793, &_S807, pack_0, kernelContext_54);
        uint _S809 = _S806.projected_area_0 + pack_0;
        uint _S810 = _S806.packs_0 + 1U;
        thread NodeTaps_0 _S811 = view_nodes_0;
        float4 _S812 = interpolate_table_0(&_S811, _S809, _S810, kernelContext_54);
        uint _S813 = _S806.light_visibility_1 + pack_0;
        thread NodeTaps_0 _S814 = seen_nodes_0;
        float4 _S815 = interpolate_table_0(&_S814, _S813, _S806.packs_0, kernelContext_54);
        float4 _S816 = float4(255.0f) ;
        float4 _S817 = _S815 / _S816;
        thread NodeTaps_0 _S818 = light_nodes_0;
        float4 _S819 = interpolate_table_0(&_S818, _S813, _S806.packs_0, kernelContext_54);
        float4 _S820 = _S819 / _S816;
        uint _S821 = _S806.irradiance_1 + pack_0;
        thread NodeTaps_0 _S822 = light_nodes_0;
        float4 _S823 = interpolate_table_0(&_S822, _S821, _S806.packs_0, kernelContext_54);
        float4 _S824 = _S823 * float4(0.00124827399849892f) ;
        bool _S825 = pack_0 < _S803;
        uint _S826;
        if(_S825)
        {
            _S826 = _S798->warp_0;
        }
        else
        {
            _S826 = _S798->weft_0;
        }
        Family_0 _S827 = kernelContext_54->families_0[_S826];
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
            Group_0 _S828 = group_at_0(_S806.moments_0 + 12U * (4U * (_S801 * _S806.packs_0 + pack_0) + number_4), _S827.roughness_0, kernelContext_54);
            float _S829 = _S808[number_4] * _S812[number_4] * _S812[number_4] * _S828.weight_1;
            float2 _S830 = visibility_gain_0(_S805, _S820[number_4], _S817[number_4]);
            thread Group_0 _S831 = _S828;
            float _S832 = layer_value_0(&_S831, _S804, _S795, _S796, _S798->optical_depth_0);
            float _S833 = _S830.x;
            float diffuse_1 = diffuse_0 + _S829 * _S824[number_4] * _S833;
            float specular_1 = specular_0 + _S829 * _S832 * _S820[number_4] * _S830.y;
            (&sums_1)->light_visibility_0 = (&sums_1)->light_visibility_0 + _S829 * _S820[number_4] * _S833;
            float total_3 = total_2 + _S829;
            number_4 = number_4 + 1U;
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        float _S834;
        if(_S825)
        {
            _S834 = diffuse_0;
        }
        else
        {
            _S834 = 0.0f;
        }
        (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 + _S834;
        float _S835;
        if(_S825)
        {
            _S835 = 0.0f;
        }
        else
        {
            _S835 = diffuse_0;
        }
        (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 + _S835;
        float _S836;
        if(_S825)
        {
            _S836 = specular_0;
        }
        else
        {
            _S836 = 0.0f;
        }
        (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 + _S836;
        float _S837;
        if(_S825)
        {
            _S837 = 0.0f;
        }
        else
        {
            _S837 = specular_0;
        }
        (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 + _S837;
        pack_0 = pack_0 + 1U;
    }
    thread CoverageTaps_0 _S838 = _S799;
    thread NodeTaps_0 _S839 = view_nodes_0;
    float _S840 = prefiltered_hole_0(_S793, &_S838, &_S839, _S797, kernelContext_54);
    (&sums_1)->hole_2 = _S840;
    float _S841 = (1.0f - _S840) / max(total_2, 9.999999960041972e-13f);
    (&sums_1)->diffuse_warp_0 = (&sums_1)->diffuse_warp_0 * _S841;
    (&sums_1)->diffuse_weft_0 = (&sums_1)->diffuse_weft_0 * _S841;
    (&sums_1)->specular_warp_0 = (&sums_1)->specular_warp_0 * _S841;
    (&sums_1)->specular_weft_0 = (&sums_1)->specular_weft_0 * _S841;
    (&sums_1)->light_visibility_0 = (&sums_1)->light_visibility_0 * _S841;
    return sums_1;
}

FamilyAlbedos_0 albedos_over_0(uint _S842, const Footprint_0 thread* _S843, bool _S844, KernelContext_0 thread* kernelContext_55)
{
    Fabric_0 device* _S845 = kernelContext_55->fabrics_0+_S842;
    float2 _S846 = sqrt(_S843->dx_0 * _S843->dx_0 + _S843->dy_0 * _S843->dy_0);
    uint _S847 = _S845->warp_0;
    float2 _S848 = _S843->centre_0;
    Stretch_0 _S849 = stretch_of_0(_S845->warp_0, _S843->centre_0.x, _S846.x, kernelContext_55);
    uint _S850 = _S845->weft_0;
    Stretch_0 _S851 = stretch_of_0(_S845->weft_0, _S848.y, _S846.y, kernelContext_55);
    thread FamilyAlbedos_0 albedos_7;
    thread Stretch_0 _S852 = _S849;
    thread Stretch_0 _S853 = _S851;
    Albedos_0 _S854 = mean_albedos_0(_S847, _S850, &_S852, &_S853, _S844, kernelContext_55);
    (&albedos_7)->warp_2 = _S854;
    thread Stretch_0 _S855 = _S851;
    thread Stretch_0 _S856 = _S849;
    Albedos_0 _S857 = mean_albedos_0(_S850, _S847, &_S855, &_S856, _S844, kernelContext_55);
    (&albedos_7)->weft_2 = _S857;
    return albedos_7;
}

Estimate_0 lobes_estimate_0(uint _S858, const Footprint_0 thread* _S859, float _S860, float3 _S861, float3 _S862, KernelContext_0 thread* kernelContext_56)
{
    float _S863;
    Fabric_0 device* _S864 = kernelContext_56->fabrics_0+_S858;
    Regime_0 _S865 = regime_of_0(_S858, _S859, _S860, kernelContext_56);
    bool _S866 = (_S862.z) < 0.0f;
    float3 _S867 = to_face_frame_0(_S862, _S866);
    bool _S868;
    if((_S864->fibre_noise_0) > 0.0f)
    {
        _S868 = true;
    }
    else
    {
        _S868 = (_S864->colour_noise_0) > 0.0f;
    }
    bool _S869;
    if((kernelContext_56->families_0[_S864->warp_0].quantities_0) > 1U)
    {
        _S869 = true;
    }
    else
    {
        _S869 = (kernelContext_56->families_0[_S864->weft_0].quantities_0) > 1U;
    }
    float _S870 = 1.0f - _S865.prefiltered_0;
    if(_S870 > 0.0f)
    {
        if(_S868)
        {
            _S869 = true;
        }
    }
    else
    {
        _S869 = false;
    }
    thread Footprint_0 box_0 = *_S859;
    float3 _S871 = float3(0.0f) ;
    SurfacePoint_0 _S872 = SurfacePoint_x24init_0(false, false, 0U, 0U, 0.0f, _S871, _S871, 0.0f, 0.0f, 0.0f);
    float2 _S873 = _S859->centre_0;
    Components_0 _S874 = no_components_0();
    int _S875;
    if(_S869)
    {
        _S875 = int(0);
    }
    else
    {
        _S875 = int(1);
    }
    uint _S876 = uint(_S875);
    Components_0 points_1 = _S874;
    float central_weight_0 = 0.0f;
    SurfacePoint_0 central_0 = _S872;
    float2 central_place_0 = _S873;
    uint number_5 = _S876;
    for(;;)
    {
        float _S877 = float(number_5);
        _S863 = _S865.points_0;
        if(_S877 < (_S865.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        bool _S878 = number_5 == 0U;
        float2 _S879;
        if(_S878)
        {
            _S879 = float2(0.0f) ;
        }
        else
        {
            _S879 = POINT_OFFSETS_0[number_5 - 1U];
        }
        float2 _S880 = _S873 + float2(_S879.x)  * _S859->dx_0 + float2(_S879.y)  * _S859->dy_0;
        float _S881;
        if(_S878)
        {
            _S881 = 0.0f;
        }
        else
        {
            _S881 = _S865.threads_1;
        }
        SearchQuality_0 _S882 = quality_of_0(_S881);
        float _S883 = _S880.x;
        float _S884 = _S880.y;
        thread SearchQuality_0 _S885 = _S882;
        Hit_0 _S886 = first_hit_0(_S858, &_S885, _S883, _S884, _S867, _S866, kernelContext_56);
        SurfacePoint_0 _S887 = surface_at_0(_S858, _S886.x_12, _S886.y_7, _S866, kernelContext_56);
        if(_S878)
        {
            float central_weight_1;
            if(_S886.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S870;
            }
            float2 central_place_1 = float2(_S886.x_12, _S886.y_7);
            (&box_0)->centre_0 = mix(_S873, central_place_1, float2(central_weight_1) );
            central_weight_0 = central_weight_1;
            central_0 = _S887;
            central_place_0 = central_place_1;
            number_5 = number_5 + 1U;
            continue;
        }
        thread SurfacePoint_0 _S888 = _S887;
        YarnPoint_0 _S889 = yarn_point_of_0(_S858, &_S888, _S886.x_12, _S886.y_7, _S866, _S886.hole_5, kernelContext_56);
        thread SearchQuality_0 _S890 = _S882;
        thread YarnPoint_0 _S891 = _S889;
        Components_0 _S892 = components_of_point_0(_S858, &_S890, &_S891, _S861, _S862, kernelContext_56);
        float _S893 = min(_S865.points_0 - float(number_5 - 1U), 1.0f);
        thread Components_0 _S894 = points_1;
        thread Components_0 _S895 = _S892;
        Components_0 _S896 = with_added_0(&_S894, &_S895, _S893);
        points_1 = _S896;
        number_5 = number_5 + 1U;
    }
    thread Estimate_0 estimate_0;
    float _S897 = _S870 / max(_S863, 1.0f);
    thread Components_0 _S898 = _S874;
    thread Components_0 _S899 = points_1;
    Components_0 _S900 = with_added_0(&_S898, &_S899, _S897);
    (&estimate_0)->components_0 = _S900;
    if((_S865.prefiltered_0) > 0.0f)
    {
        Components_0 _S901 = prefiltered_components_0(_S858, _S859, to_face_frame_0(_S861, _S866), _S867, _S866, kernelContext_56);
        thread Components_0 _S902 = (&estimate_0)->components_0;
        thread Components_0 _S903 = _S901;
        Components_0 _S904 = with_added_0(&_S902, &_S903, _S865.prefiltered_0);
        (&estimate_0)->components_0 = _S904;
    }
    thread Footprint_0 _S905 = box_0;
    FamilyAlbedos_0 _S906 = albedos_over_0(_S858, &_S905, _S866, kernelContext_56);
    (&estimate_0)->albedos_4 = _S906;
    if(_S868)
    {
        _S868 = central_weight_0 > 0.0f;
    }
    else
    {
        _S868 = false;
    }
    if(_S868)
    {
        SurfacePoint_0 _S907 = central_0;
        Albedos_0 _S908;
        if(central_0.is_warp_0)
        {
            _S908 = (&(&estimate_0)->albedos_4)->warp_2;
        }
        else
        {
            _S908 = (&(&estimate_0)->albedos_4)->weft_2;
        }
        float _S909 = central_place_0.x;
        float _S910 = central_place_0.y;
        thread SurfacePoint_0 _S911 = central_0;
        thread Albedos_0 _S912 = _S908;
        Albedos_0 _S913 = varied_at_0(_S858, &_S911, &_S912, _S909, _S910, kernelContext_56);
        thread Albedos_0 _S914 = _S908;
        thread Albedos_0 _S915 = _S913;
        Albedos_0 _S916 = lerp_albedos_0(&_S914, &_S915, central_weight_0);
        if(_S907.is_warp_0)
        {
            (&(&estimate_0)->albedos_4)->warp_2 = _S916;
        }
        else
        {
            (&(&estimate_0)->albedos_4)->weft_2 = _S916;
        }
    }
    return estimate_0;
}

float3 composed_0(uint _S917, const Components_0 thread* _S918, const FamilyAlbedos_0 thread* _S919, float3 _S920, float3 _S921, KernelContext_0 thread* kernelContext_57)
{
    Fabric_0 device* _S922 = kernelContext_57->fabrics_0+_S917;
    float3 _S923 = float3(_S918->diffuse_warp_0) ;
    float3 _S924 = float3(_S918->diffuse_weft_0) ;
    float3 _S925 = float3(_S918->specular_warp_0) ;
    float3 _S926 = float3(_S918->specular_weft_0) ;
    float3 _S927 = (&_S919->warp_2)->diffuse_reflect_0 * _S923 + (&_S919->weft_2)->diffuse_reflect_0 * _S924 + (&_S919->warp_2)->specular_reflect_0 * _S925 + (&_S919->weft_2)->specular_reflect_0 * _S926;
    float _S928 = _S921.z;
    float3 body_0;
    if((_S920.z * _S928) < 0.0f)
    {
        body_0 = (&_S919->warp_2)->diffuse_transmit_0 * _S923 + (&_S919->weft_2)->diffuse_transmit_0 * _S924 + (&_S919->warp_2)->specular_transmit_0 * _S925 + (&_S919->weft_2)->specular_transmit_0 * _S926;
    }
    else
    {
        body_0 = _S927;
    }
    float _S929 = _S922->sheen_strength_0;
    if((_S922->sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    bool _S930 = _S928 < 0.0f;
    float2 _S931 = sheen_with_transmittance_0(to_face_frame_0(_S920, _S930), to_face_frame_0(_S921, _S930), _S929, _S922->sheen_roughness_0);
    return float3(_S931.y)  * body_0 + float3(((_S918->light_visibility_0 + _S918->hole_2) * _S931.x)) ;
}

float4 light_of_footprint_0(const Frame_0 thread* _S932, uint _S933, const VisiblePoint_0 thread* _S934, KernelContext_0 thread* kernelContext_58)
{
    Fabric_0 device* _S935 = kernelContext_58->fabrics_0+_S933;
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S934->draft_0;
    (&footprint_0)->dx_0 = _S934->draft_dx_0;
    (&footprint_0)->dy_0 = _S934->draft_dy_0;
    float3 _S936 = to_local_0(_S934, _S934->view_0);
    float3 _S937 = float3(0.0f) ;
    uint number_6 = 0U;
    float3 radiance_1 = _S937;
    float hole_7 = 0.0f;
    for(;;)
    {
        uint _S938 = _S932->lights_0;
        if(number_6 < (max(_S932->lights_0, 1U)))
        {
        }
        else
        {
            break;
        }
        thread Light_0 _S939 = kernelContext_58->lights_1[number_6];
        thread float3 irradiance_2;
        float3 _S940 = towards_light_0(&_S939, _S934->position_0, &irradiance_2);
        float3 _S941 = to_local_0(_S934, _S940);
        thread Footprint_0 _S942 = footprint_0;
        Estimate_0 _S943 = lobes_estimate_0(_S933, &_S942, 1.0f, _S941, _S936, kernelContext_58);
        if(number_6 < _S938)
        {
            thread Components_0 _S944 = _S943.components_0;
            thread FamilyAlbedos_0 _S945 = _S943.albedos_4;
            float3 _S946 = composed_0(_S933, &_S944, &_S945, _S941, _S936, kernelContext_58);
            radiance_1 = radiance_1 + irradiance_2 * _S946;
        }
        number_6 = number_6 + 1U;
        hole_7 = _S943.components_0.hole_2;
    }
    float _S947 = _S935->sheen_strength_0;
    if((_S935->sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S947 * sheen_lobe_0(abs(_S936.z), _S935->sheen_roughness_0).z);
    }
    return float4(radiance_1, 1.0f - hole_7);
}

[[kernel]] void shade_lobes(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], texture2d<uint, access::sample> visible_faces_1 [[texture(0)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], Light_0 device* lights_2 [[buffer(3)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]], packed_float4 device* radiance_2 [[buffer(8)]])
{
    thread KernelContext_0 kernelContext_59;
    (&kernelContext_59)->frames_0 = frames_1;
    (&kernelContext_59)->visible_faces_0 = visible_faces_1;
    (&kernelContext_59)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_59)->fabrics_0 = fabrics_1;
    (&kernelContext_59)->corners_0 = corners_1;
    (&kernelContext_59)->vertices_0 = vertices_1;
    (&kernelContext_59)->lights_1 = lights_2;
    (&kernelContext_59)->families_0 = families_1;
    (&kernelContext_59)->words_0 = words_1;
    (&kernelContext_59)->radiance_0 = radiance_2;
    Frame_0 _S948 = frames_1[int(0)];
    bool _S949;
    if((id_0.x) >= (_S948.width_0))
    {
        _S949 = true;
    }
    else
    {
        _S949 = (id_0.y) >= (_S948.height_0);
    }
    if(_S949)
    {
        return;
    }
    uint2 _S950 = id_0.xy;
    int3 _S951 = int3(int2(_S950), int(0));
    uint _S952 = (((&kernelContext_59)->visible_faces_0).read(vec<uint,2>(((_S951)).xy), uint(((_S951)).z)).x);
    float4 _S953 = float4(0.0f) ;
    float4 sum_1;
    if(_S952 > 0U)
    {
        uint _S954 = _S952 - 1U;
        uint _S955 = (&kernelContext_59)->face_fabrics_0[_S954];
        thread Frame_0 _S956 = _S948;
        VisiblePoint_0 _S957 = visible_point_0(&_S956, _S955, _S954, _S950, &kernelContext_59);
        thread Frame_0 _S958 = _S948;
        thread VisiblePoint_0 _S959 = _S957;
        float4 _S960 = light_of_footprint_0(&_S958, _S955, &_S959, &kernelContext_59);
        sum_1 = _S960;
    }
    else
    {
        sum_1 = _S953;
    }
    thread Frame_0 _S961 = _S948;
    accumulate_0(&_S961, _S950, sum_1, &kernelContext_59);
    return;
}

