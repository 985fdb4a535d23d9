#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
constant array<float, int(4)> PYRAMID_RADII_0 = { 1.0f, 2.0f, 4.0f, 8.0f };
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
    float x_5;
    float y_1;
    float z_1;
    float red_0;
    float green_0;
    float blue_0;
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
    Family_0 device* families_0;
    uint device* words_0;
    float device* visibilities_0;
    Light_0 device* lights_1;
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

struct SearchQuality_0
{
    float steps_per_thread_0;
    float steps_per_relief_0;
    float shadow_share_0;
    uint refinements_0;
};

SearchQuality_0 default_quality_0()
{
    thread SearchQuality_0 quality_0;
    (&quality_0)->steps_per_thread_0 = 5.0f;
    (&quality_0)->steps_per_relief_0 = 8.0f;
    (&quality_0)->shadow_share_0 = 1.0f;
    (&quality_0)->refinements_0 = 2U;
    return quality_0;
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

float3 to_face_frame_0(float3 direction_1, bool back_1)
{
    float2 _S36 = direction_1.xy;
    float _S37;
    if(back_1)
    {
        _S37 = - direction_1.z;
    }
    else
    {
        _S37 = direction_1.z;
    }
    return float3(_S36, _S37);
}

float2 turns_and_remainder_0(uint family_0, float index_2, KernelContext_0 thread* kernelContext_2)
{
    float _S38 = floor(fma(index_2, kernelContext_2->families_0[family_0].inverse_count_0, kernelContext_2->families_0[family_0].half_inverse_count_0));
    return float2(_S38, fma(- _S38, kernelContext_2->families_0[family_0].count_0, index_2));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1, KernelContext_0 thread* kernelContext_3)
{
    float _S39 = floor(position_1 * kernelContext_3->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_1;
    float _S40 = fma(- _S39, kernelContext_3->families_0[family_1].size_0, position_1);
    (&cell_1)->below_0 = _S40;
    (&cell_1)->above_0 = kernelContext_3->families_0[family_1].size_0 - _S40;
    (&cell_1)->across_0 = _S40 - 0.5f * kernelContext_3->families_0[family_1].size_0;
    (&cell_1)->half_width_1 = kernelContext_3->families_0[family_1].half_width_0;
    float2 _S41 = turns_and_remainder_0(family_1, _S39, kernelContext_3);
    (&cell_1)->thread_1 = uint(clamp(_S41.y, 0.0f, kernelContext_3->families_0[family_1].count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_3, KernelContext_0 thread* kernelContext_4)
{
    return (as_type<float>((kernelContext_4->words_0[index_3])));
}

float table_number_1(uint index_4, KernelContext_0 thread* kernelContext_5)
{
    return (as_type<float>((kernelContext_5->words_0[index_4])));
}

Cell_0 locate_varied_0(uint family_2, float position_2, KernelContext_0 thread* kernelContext_6)
{
    float turns_0 = (position_2 - kernelContext_6->families_0[family_2].start_0) * kernelContext_6->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S42 = turns_1 * kernelContext_6->families_0[family_2].period_0;
    uint thread_2 = kernelContext_6->words_0[kernelContext_6->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_6->families_0[family_2].bins_0, 0.0f, kernelContext_6->families_0[family_2].bins_0 - 1.0f))];
    float _S43 = table_number_0(kernelContext_6->families_0[family_2].place_table_0 + thread_2 * 4U + 1U, kernelContext_6);
    uint _S44;
    if(_S42 >= _S43)
    {
        _S44 = 1U;
    }
    else
    {
        _S44 = 0U;
    }
    uint _S45 = min(thread_2 + _S44, uint(kernelContext_6->families_0[family_2].count_0) - 1U);
    uint _S46 = kernelContext_6->families_0[family_2].place_table_0 + _S45 * 4U;
    thread Cell_0 cell_2;
    (&cell_2)->thread_1 = _S45;
    float _S47 = table_number_0(_S46, kernelContext_6);
    (&cell_2)->below_0 = _S42 - _S47;
    float _S48 = table_number_0(_S46 + 1U, kernelContext_6);
    (&cell_2)->above_0 = _S48 - _S42;
    float _S49 = table_number_0(_S46 + 2U, kernelContext_6);
    (&cell_2)->across_0 = _S42 - _S49;
    float _S50 = table_number_0(_S46 + 3U, kernelContext_6);
    (&cell_2)->half_width_1 = _S50;
    return cell_2;
}

Cell_0 locate_0(uint family_3, float position_3, KernelContext_0 thread* kernelContext_7)
{
    if((kernelContext_7->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S51 = locate_alike_0(family_3, position_3, kernelContext_7);
        return _S51;
    }
    Cell_0 _S52 = locate_varied_0(family_3, position_3, kernelContext_7);
    return _S52;
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

Shown_0 shown_at_0(const Crossing_0 thread* crossing_0, bool back_2)
{
    bool _S53 = (abs((&crossing_0->warp_1)->across_0)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S54 = (abs((&crossing_0->weft_1)->across_0)) < ((&crossing_0->weft_1)->half_width_1);
    thread Shown_0 shown_0;
    bool _S55;
    if(_S53)
    {
        if(!_S54)
        {
            _S55 = true;
        }
        else
        {
            _S55 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S55 = false;
    }
    (&shown_0)->is_warp_0 = _S55;
    if(!_S53)
    {
        _S55 = !_S54;
    }
    else
    {
        _S55 = false;
    }
    (&shown_0)->hole_0 = _S55;
    uint _S56;
    if((&shown_0)->is_warp_0)
    {
        _S56 = crossing_0->warp_word_0;
    }
    else
    {
        _S56 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S56;
    (&shown_0)->on_top_0 = ((_S56 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_1, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_3;
    uint _S57;
    if(is_first_0)
    {
        _S57 = first_1->thread_1;
    }
    else
    {
        _S57 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S57;
    float _S58;
    if(is_first_0)
    {
        _S58 = first_1->across_0;
    }
    else
    {
        _S58 = second_0->across_0;
    }
    (&cell_3)->across_0 = _S58;
    if(is_first_0)
    {
        _S58 = first_1->half_width_1;
    }
    else
    {
        _S58 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S58;
    if(is_first_0)
    {
        _S58 = first_1->below_0;
    }
    else
    {
        _S58 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S58;
    if(is_first_0)
    {
        _S58 = first_1->above_0;
    }
    else
    {
        _S58 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S58;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0, KernelContext_0 thread* kernelContext_8)
{
    float2 _S59 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0), kernelContext_8);
    float _S60 = _S59.x;
    Family_0 _S61 = kernelContext_8->families_0[family_4];
    float _S62 = table_number_0(kernelContext_8->families_0[family_4].place_table_0 + uint(_S59.y) * 4U, kernelContext_8);
    return fma(_S60, _S61.period_0, _S62);
}

float span_0(uint family_5, uint thread_4, int first_2, int last_0, KernelContext_0 thread* kernelContext_9)
{
    if((kernelContext_9->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_2) * kernelContext_9->families_0[family_5].size_0;
    }
    float _S63 = boundary_0(family_5, thread_4, last_0, kernelContext_9);
    float _S64 = boundary_0(family_5, thread_4, first_2, kernelContext_9);
    return _S63 - _S64;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_5, KernelContext_0 thread* kernelContext_10)
{
    Family_0 _S65 = kernelContext_10->families_0[family_6];
    uint _S66;
    if((kernelContext_10->families_0[family_6].is_alike_0) != 0U)
    {
        _S66 = 0U;
    }
    else
    {
        _S66 = thread_5 * 4U;
    }
    uint _S67 = _S65.bend_table_0 + _S66;
    thread Bend_0 bend_0;
    float _S68 = table_number_0(_S67, kernelContext_10);
    (&bend_0)->sine_0 = _S68;
    float _S69 = table_number_0(_S67 + 1U, kernelContext_10);
    (&bend_0)->half_tangent_0 = _S69;
    float _S70 = table_number_0(_S67 + 2U, kernelContext_10);
    (&bend_0)->arc_0 = _S70;
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_6, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_11)
{
    int _S71 = int((word_1 >> 1U) & 127U);
    int _S72 = int((word_1 >> 8U) & 127U);
    int _S73 = int((word_1 >> 15U) & 63U);
    int _S74 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S75 = crossed_0->below_0;
    uint _S76 = crossed_0->thread_1;
    int _S77 = - _S71;
    float _S78 = span_0(other_0, crossed_0->thread_1, _S77, int(0), kernelContext_11);
    float _S79 = _S75 + _S78;
    (&run_0)->from_start_0 = _S79;
    float _S80 = crossed_0->above_0;
    int _S81 = _S72 + int(1);
    float _S82 = span_0(other_0, _S76, int(1), _S81, kernelContext_11);
    float _S83 = _S80 + _S82;
    (&run_0)->to_end_0 = _S83;
    bool _S84 = _S79 < _S83;
    (&run_0)->near_start_0 = _S84;
    int _S85;
    if(_S84)
    {
        _S85 = _S77 - _S73;
    }
    else
    {
        _S85 = _S81;
    }
    int _S86;
    if((&run_0)->near_start_0)
    {
        _S86 = _S77;
    }
    else
    {
        _S86 = _S81 + _S74;
    }
    Bend_0 _S87 = bend_of_0(own_0, thread_6, kernelContext_11);
    (&run_0)->bend_1 = _S87;
    float _S88;
    if((&run_0)->straight_0)
    {
        _S88 = 1.0e+06f;
    }
    else
    {
        _S88 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S88;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S89 = span_0(other_0, _S76, _S85, _S86, kernelContext_11);
    (&run_0)->other_reach_0 = min(0.5f * _S89, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S71 == int(0);
    (&run_0)->last_crossing_0 = _S72 == int(0);
    return run_0;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(const Cell_0 thread* cell_4)
{
    float _S90 = cell_4->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S91 = clamp(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_1 = _S91;
    float _S92 = _S90 * _S90 - square_1(_S91);
    float _S93 = rsqrt(_S92);
    (&section_0)->drop_0 = _S90 - _S92 * _S93;
    (&section_0)->slope_0 = - _S91 * _S93;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_7, int step_1, KernelContext_0 thread* kernelContext_12)
{
    if((kernelContext_12->families_0[family_7].is_alike_0) != 0U)
    {
        float _S94 = table_number_0(kernelContext_12->families_0[family_7].bend_table_0 + 3U, kernelContext_12);
        return _S94;
    }
    Family_0 _S95 = kernelContext_12->families_0[family_7];
    float2 _S96 = turns_and_remainder_0(family_7, float(int(thread_7) + step_1), kernelContext_12);
    float _S97 = table_number_0(_S95.bend_table_0 + uint(_S96.y) * 4U + 3U, kernelContext_12);
    return _S97;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_13)
{
    float _S98 = crossed_1->below_0;
    float _S99 = crossed_1->above_0;
    bool _S100 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S101 = min(crossed_1->below_0, crossed_1->above_0);
    float _S102;
    if(_S100)
    {
        _S102 = _S98 - crossed_1->across_0;
    }
    else
    {
        _S102 = _S99 + crossed_1->across_0;
    }
    float _S103 = _S102 - crossed_1->half_width_1;
    bool _S104;
    if(_S100)
    {
        _S104 = run_1->first_crossing_0;
    }
    else
    {
        _S104 = run_1->last_crossing_0;
    }
    bool _S105 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S102 = 0.0f;
    }
    else
    {
        Family_0 _S106 = kernelContext_13->families_0[other_1];
        float _S107 = edge_drop_0(other_1, crossed_1->thread_1, int(0), kernelContext_13);
        _S102 = _S106.height_scale_0 * _S107;
    }
    float _S108;
    if(_S105 != _S104)
    {
        _S108 = 0.0f;
    }
    else
    {
        Family_0 _S109 = kernelContext_13->families_0[other_1];
        uint _S110 = crossed_1->thread_1;
        int _S111;
        if(_S100)
        {
            _S111 = int(-1);
        }
        else
        {
            _S111 = int(1);
        }
        float _S112 = edge_drop_0(other_1, _S110, _S111, kernelContext_13);
        _S108 = _S109.height_scale_0 * _S112;
    }
    float _S113 = 1.0f / max(2.0f * _S103, 9.999999960041972e-13f);
    float _S114 = clamp((_S103 - _S101) * _S113, 0.0f, 1.0f);
    float _S115 = _S102 + (_S108 - _S102) * (_S114 * _S114 * (3.0f - 2.0f * _S114));
    float _S116 = (_S102 - _S108) * (6.0f * _S114 * (1.0f - _S114) * _S113);
    if(_S100)
    {
        _S102 = 1.0f;
    }
    else
    {
        _S102 = -1.0f;
    }
    return float2(_S115, _S116 * _S102);
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
    float _S117 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S117), 9.99999971718068537e-10f);
    float _S118 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S118), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S117 > 0.0f;
    (&control_0)->up_0 = _S118 > 0.0f;
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
    float _S119;
    if(forwards_0)
    {
        _S119 = cell_5->across_0;
    }
    else
    {
        _S119 = - cell_5->across_0;
    }
    float _S120;
    if(forwards_0)
    {
        _S120 = cell_5->above_0;
    }
    else
    {
        _S120 = cell_5->below_0;
    }
    bool _S121;
    if(forwards_0)
    {
        _S121 = run_2->last_crossing_0;
    }
    else
    {
        _S121 = run_2->first_crossing_0;
    }
    bool _S122;
    if(forwards_0)
    {
        _S122 = run_2->first_crossing_0;
    }
    else
    {
        _S122 = run_2->last_crossing_0;
    }
    float _S123 = cell_5->half_width_1;
    float _S124 = - cell_5->half_width_1;
    bool _S125 = _S119 < _S124;
    bool _S126 = _S119 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S121 = !_S121;
    }
    else
    {
        _S121 = false;
    }
    if(_S121)
    {
        _S121 = !shown_2->hole_0;
    }
    else
    {
        _S121 = false;
    }
    bool _S127;
    if(_S121)
    {
        _S127 = shown_2->on_top_0;
    }
    else
    {
        _S127 = false;
    }
    if(_S127)
    {
        if(_S122)
        {
            _S122 = _S125;
        }
        else
        {
            _S122 = false;
        }
        _S122 = !_S122;
    }
    else
    {
        _S122 = false;
    }
    if(shown_2->hole_0)
    {
        _S121 = true;
    }
    else
    {
        if(_S121)
        {
            _S121 = !shown_2->on_top_0;
        }
        else
        {
            _S121 = false;
        }
    }
    float _S128;
    if(_S125)
    {
        _S128 = _S124;
    }
    else
    {
        _S128 = _S123;
    }
    float _S129 = _S128 - _S119;
    if(_S121)
    {
        _S119 = 2.0f * _S120 + _S119 - _S123;
    }
    else
    {
        _S119 = _S120;
    }
    if(_S122)
    {
        if(forwards_0)
        {
            _S119 = run_2->to_end_0;
        }
        else
        {
            _S119 = run_2->from_start_0;
        }
        return _S119;
    }
    if(_S126)
    {
    }
    else
    {
        _S119 = _S129;
    }
    return _S119;
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

float way_back_to_dip_0(const PreviousSample_0 thread* previous_1, float clearance_1, float rate_1, float step_4, const Probe_0 thread* here_0)
{
    float _S130 = previous_1->rate_0;
    float _S131 = previous_1->rate_0 * step_4;
    float _S132 = rate_1 * step_4;
    bool _S133;
    if(!previous_1->known_0)
    {
        _S133 = true;
    }
    else
    {
        _S133 = here_0->hole_1;
    }
    if(_S133)
    {
        _S133 = true;
    }
    else
    {
        _S133 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S133)
    {
        _S133 = true;
    }
    else
    {
        _S133 = _S130 >= 0.0f;
    }
    if(_S133)
    {
        _S133 = true;
    }
    else
    {
        _S133 = rate_1 <= 0.0f;
    }
    if(_S133)
    {
        return -1.0f;
    }
    float _S134 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S131) >= 0.0f)
    {
        _S133 = (3.0f * clearance_1 - _S132) >= 0.0f;
    }
    else
    {
        _S133 = false;
    }
    if(_S133)
    {
        return -1.0f;
    }
    float _S135 = clearance_1 - _S134;
    float _S136 = 6.0f * _S135 - 4.0f * _S131 - 2.0f * _S132;
    float _S137 = -2.0f * _S131 / max(_S136 + sqrt(max(_S136 * _S136 - 4.0f * (3.0f * (_S131 + _S132 - 2.0f * _S135)) * _S131, 0.0f)), 9.99999968265522539e-21f);
    float _S138 = 1.0f - _S137;
    float _S139 = (_S134 * (2.0f * _S137 + 1.0f) + _S131 * _S137) * _S138 * _S138;
    float _S140 = (clearance_1 * (2.0f * _S138 + 1.0f) - _S132 * _S138) * _S137 * _S137;
    if(_S137 > 0.01999999955296516f)
    {
        _S133 = _S138 > 0.01999999955296516f;
    }
    else
    {
        _S133 = false;
    }
    if(_S133)
    {
        _S133 = (_S139 + _S140) < 0.0f;
    }
    else
    {
        _S133 = false;
    }
    float _S141;
    if(_S133)
    {
        _S141 = _S138 * step_4;
    }
    else
    {
        _S141 = -1.0f;
    }
    return _S141;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S142 = here_1->hole_1;
    float _S143;
    if(here_1->hole_1)
    {
        _S143 = 1.0e+09f;
    }
    else
    {
        _S143 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S143;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S144;
    if(!_S142)
    {
        _S144 = !is_cell_exit_0;
    }
    else
    {
        _S144 = false;
    }
    (&previous_2)->known_0 = _S144;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_0, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_0->per_x_0, side_y_1 * this_0->per_y_0), 0.0f) + this_0->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_1, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S145 = min(here_2->edge_x_0 * this_1->per_x_0, here_2->edge_y_0 * this_1->per_y_0);
    bool _S146;
    if(!here_2->hole_1)
    {
        _S146 = (rate_3 * _S145 + clearance_3) < 0.0f;
    }
    else
    {
        _S146 = false;
    }
    if(_S146)
    {
        _S146 = _S145 > (2.0f * this_1->epsilon_0);
    }
    else
    {
        _S146 = false;
    }
    float _S147 = this_1->step_2;
    float _S148;
    if(_S146)
    {
        _S148 = _S145 - this_1->epsilon_0;
    }
    else
    {
        _S148 = max(_S145, 0.0f) + this_1->epsilon_0;
    }
    return min(_S147, _S148);
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_1;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_2, float height_2)
{
    return this_2->origin_0 + this_2->slope_1 * float2(height_2) ;
}

float ViewRay_rate_0(const ViewRay_0 thread* this_3, const Probe_0 thread* here_3)
{
    return here_3->slope_x_0 * this_3->slope_1.x + here_3->slope_y_0 * this_3->slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S149 = end_0 - start_1;
    float _S150 = start_rate_0 + end_rate_0 - 2.0f * _S149;
    float _S151 = 3.0f * _S149 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S149, 9.99999968265522539e-21f);
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
        float _S152 = clamp(share_1 - (((_S150 * share_1 + _S151) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S150 * share_1 + 2.0f * _S151) * share_1 + start_rate_0, 0.10000000149011612f * _S149 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S153 = i_0 + int(1);
        share_1 = _S152;
        i_0 = _S153;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S154 = along_slope_0 * along_slope_0 + 1.0f;
    float _S155 = rsqrt(_S154);
    float _S156 = sine_1 * _S155 * rsqrt(_S154 + across_slope_0 * across_slope_0);
    return float2(- _S156 * _S154, _S156 * across_slope_0 * along_slope_0 + cosine_0 * _S155);
}

float arc_sine_0(float x_6)
{
    float _S157 = abs(x_6);
    bool _S158 = _S157 > 0.5f;
    float _S159;
    if(_S158)
    {
        _S159 = 0.5f * (1.0f - _S157);
    }
    else
    {
        _S159 = _S157 * _S157;
    }
    float _S160;
    if(_S158)
    {
        _S160 = sqrt(max(_S159, 0.0f));
    }
    else
    {
        _S160 = _S157;
    }
    float _S161 = ((((0.04216320067644119f * _S159 + 0.02418131195008755f) * _S159 + 0.04547002539038658f) * _S159 + 0.07495300471782684f) * _S159 + 0.16666752099990845f) * _S159 * _S160 + _S160;
    if(_S158)
    {
        _S159 = 1.57079637050628662f - 2.0f * _S161;
    }
    else
    {
        _S159 = _S161;
    }
    if(x_6 < 0.0f)
    {
        _S159 = - _S159;
    }
    return _S159;
}

float3 table_colour_0(uint index_5, KernelContext_0 thread* kernelContext_14)
{
    float _S162 = table_number_1(index_5, kernelContext_14);
    float _S163 = table_number_1(index_5 + 1U, kernelContext_14);
    float _S164 = table_number_1(index_5 + 2U, kernelContext_14);
    return float3(_S162, _S163, _S164);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 table_albedos_0(uint row_0, KernelContext_0 thread* kernelContext_15)
{
    thread Albedos_0 albedos_0;
    float3 _S165 = table_colour_0(row_0, kernelContext_15);
    (&albedos_0)->diffuse_reflect_0 = _S165;
    float3 _S166 = table_colour_0(row_0 + 3U, kernelContext_15);
    (&albedos_0)->diffuse_transmit_0 = _S166;
    float3 _S167 = table_colour_0(row_0 + 6U, kernelContext_15);
    (&albedos_0)->specular_reflect_0 = _S167;
    float3 _S168 = table_colour_0(row_0 + 9U, kernelContext_15);
    (&albedos_0)->specular_transmit_0 = _S168;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_8, KernelContext_0 thread* kernelContext_16)
{
    Albedos_0 _S169 = table_albedos_0(kernelContext_16->families_0[family_8].albedo_table_0 + kernelContext_16->families_0[family_8].albedo_stride_0 * thread_8, kernelContext_16);
    return _S169;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S170 = room_0 / max(albedo_0, float3(9.99999997475242708e-07f) );
    return min(gain_1, max(min(min(_S170.x, _S170.y), _S170.z), 0.0f));
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

Albedos_0 tinted_0(const Albedos_0 thread* albedos_1, float3 tint_0)
{
    thread Albedos_0 result_0 = *albedos_1;
    (&result_0)->diffuse_reflect_0 = (&result_0)->diffuse_reflect_0 * tint_0;
    (&result_0)->diffuse_transmit_0 = (&result_0)->diffuse_transmit_0 * tint_0;
    return result_0;
}

float scene_number_0(uint index_6, KernelContext_0 thread* kernelContext_17)
{
    return (as_type<float>((kernelContext_17->scene_words_0[index_6])));
}

struct Choice_0
{
    uint index_7;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_1, float number_0, KernelContext_0 thread* kernelContext_18)
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
        uint _S171 = (low_0 + high_0) / 2U;
        float _S172 = scene_number_0(table_0 + _S171, kernelContext_18);
        if(_S172 <= number_0)
        {
            low_0 = _S171;
        }
        else
        {
            high_0 = _S171;
        }
    }
    uint _S173 = table_0 + low_0;
    float _S174 = scene_number_0(_S173, kernelContext_18);
    float _S175 = scene_number_0(_S173 + 1U, kernelContext_18);
    thread Choice_0 choice_0;
    (&choice_0)->index_7 = low_0;
    (&choice_0)->remainder_0 = saturate((number_0 - _S174) / max(_S175 - _S174, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_7)
{
    float _S176 = floor(x_7 * 0.63661974668502808f + 0.5f);
    float _S177 = x_7 - _S176 * 1.5703125f - _S176 * 0.00048375129699707f - _S176 * 7.54979012640433211e-08f;
    float _S178 = _S177 * _S177;
    float _S179 = ((-0.00019515295571182f * _S178 + 0.00833216123282909f) * _S178 - 0.16666655242443085f) * _S178 * _S177 + _S177;
    float _S180 = ((0.00002443315679557f * _S178 - 0.00138873164542019f) * _S178 + 0.04166664555668831f) * _S178 * _S178 - 0.5f * _S178 + 1.0f;
    uint _S181 = uint(int(_S176)) & 3U;
    float2 _S182;
    if((_S181 & 1U) != 0U)
    {
        _S182 = float2(_S180, _S179);
    }
    else
    {
        _S182 = float2(_S179, _S180);
    }
    float _S183;
    if((_S181 & 2U) != 0U)
    {
        _S183 = - _S182.x;
    }
    else
    {
        _S183 = _S182.x;
    }
    float _S184;
    if(((_S181 + 1U) & 2U) != 0U)
    {
        _S184 = - _S182.y;
    }
    else
    {
        _S184 = _S182.y;
    }
    return float2(_S183, _S184);
}

float diffuse_reflection_0(float3 light_0, float3 normal_1, float blend_0)
{
    float _S185 = light_0.z;
    if(_S185 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S185, 0.0f), max(dot(light_0, normal_1), 0.0f), blend_0);
}

float projected_area_1(float3 direction_3, float3 tangent_0, float roughness_1)
{
    float _S186 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S186 * _S186 + 1.0f, roughness_1 * roughness_1));
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
    float _S187 = roughness_2 * roughness_2;
    float _S188 = squared_along_0 * (1.0f - _S187) + _S187;
    return 0.31830987334251404f * _S187 * roughness_2 / (_S188 * _S188);
}

float density_between_0(float3 light_1, float3 view_1, float3 tangent_1, float roughness_3)
{
    float3 _S189 = light_1 + view_1;
    float _S190 = dot(_S189, tangent_1);
    return flake_density_0(min(_S190 * _S190 / max(square_0(_S189), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_2, float3 view_2, float3 normal_2, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S191 = dot(light_2, normal_2);
    bool _S192;
    if(_S191 <= 0.0f)
    {
        _S192 = true;
    }
    else
    {
        _S192 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S192)
    {
        return 0.0f;
    }
    float _S193 = max(_S191, 9.99999997475242708e-07f);
    float _S194 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    float _S195 = projected_area_1(light_2, tangent_2, roughness_4) * _S194 + projected_area_1(view_2, tangent_2, roughness_4) * _S193;
    float _S196 = optical_depth_1 * _S195 / (_S193 * _S194);
    return 0.25f * density_between_0(light_2, view_2, tangent_2, roughness_4) * (_S196 * mean_attenuation_0(_S196)) * _S193 / _S195;
}

float transmission_0(float3 light_3, float3 view_3, float3 normal_3, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S197 = - dot(light_3, normal_3);
    float _S198 = dot(view_3, normal_3);
    bool _S199;
    if(_S197 <= 0.0f)
    {
        _S199 = true;
    }
    else
    {
        _S199 = _S198 <= 0.0f;
    }
    if(_S199)
    {
        return 0.0f;
    }
    float _S200 = 1.0f / max(_S198, 9.99999997475242708e-07f);
    float _S201 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S197, 9.99999997475242708e-07f);
    float _S202 = projected_area_1(view_3, tangent_3, roughness_5) * _S200;
    return density_between_0(light_3, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S201, _S202)) * mean_attenuation_0(optical_depth_2 * abs(_S201 - _S202)) * _S200;
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

float3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S203 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S204 = 2.0f * sqrt(_S203) - 1.0f;
    float _S205 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S204, _S205), 0.00999999977648258f, 1.0f), clamp((1.0f - _S203) * sheen_shear_0(_S204, _S205), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S204, _S205), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_4, float3 view_4, float scale_0, float shear_0)
{
    float _S206 = light_4.z;
    bool _S207;
    if(_S206 <= 0.0f)
    {
        _S207 = true;
    }
    else
    {
        _S207 = (view_4.z) <= 0.0f;
    }
    if(_S207)
    {
        return 0.0f;
    }
    float2 _S208 = view_4.xy;
    float _S209 = dot(_S208, _S208);
    float2 _S210;
    if(_S209 > 9.99999968265522539e-21f)
    {
        _S210 = _S208 * float2(rsqrt(_S209)) ;
    }
    else
    {
        _S210 = float2(1.0f, 0.0f);
    }
    float _S211 = scale_0 * dot(light_4.xy, _S210) + shear_0 * _S206;
    float _S212 = scale_0 * (light_4.y * _S210.x - light_4.x * _S210.y);
    float _S213 = _S211 * _S211 + _S212 * _S212 + _S206 * _S206;
    return 0.31830987334251404f * scale_0 * scale_0 * _S206 / max(_S213 * _S213, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_5, float3 view_5, float strength_0, float roughness_7)
{
    float3 _S214 = sheen_lobe_0(view_5.z, roughness_7);
    float _S215 = strength_0 * _S214.z;
    return float2(_S215 * transformed_cosine_0(light_5, view_5, _S214.x, _S214.y), 1.0f - _S215);
}

void accumulate_0(uint index_8, float4 light_6, KernelContext_0 thread* kernelContext_19)
{
    float _S216 = (kernelContext_19->layers_0+index_8)->share_0;
    packed_float4 device* _S217 = kernelContext_19->radiance_0+index_8;
    *_S217 = packed_float4((float4(*_S217)  + float4((kernelContext_19->layers_0+index_8)->share_0)  * light_6)) ;
    (kernelContext_19->layers_0+index_8)->share_0 = _S216 * (1.0f - light_6.w);
    return;
}

float3 camera_right_0(int _S218, KernelContext_0 thread* kernelContext_20)
{
    Frame_0 device* _S219 = kernelContext_20->frames_0+_S218;
    return float3(_S219->right_x_0, _S219->right_y_0, _S219->right_z_0);
}

float3 camera_up_0(int _S220, KernelContext_0 thread* kernelContext_21)
{
    Frame_0 device* _S221 = kernelContext_21->frames_0+_S220;
    return float3(_S221->up_x_0, _S221->up_y_0, _S221->up_z_0);
}

float3 camera_forward_0(int _S222, KernelContext_0 thread* kernelContext_22)
{
    Frame_0 device* _S223 = kernelContext_22->frames_0+_S222;
    return float3(_S223->forward_x_0, _S223->forward_y_0, _S223->forward_z_0);
}

float3 camera_origin_0(int _S224, KernelContext_0 thread* kernelContext_23)
{
    Frame_0 device* _S225 = kernelContext_23->frames_0+_S224;
    return float3(_S225->origin_x_0, _S225->origin_y_0, _S225->origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S226, uint _S227, float _S228, float _S229, KernelContext_0 thread* kernelContext_24)
{
    Fabric_0 device* _S230 = kernelContext_24->fabrics_0+_S226;
    uint _S231 = 3U * _S227;
    Vertex_0 _S232 = kernelContext_24->vertices_0[kernelContext_24->corners_0[_S231]];
    Vertex_0 _S233 = kernelContext_24->vertices_0[kernelContext_24->corners_0[_S231 + 1U]];
    Vertex_0 _S234 = kernelContext_24->vertices_0[kernelContext_24->corners_0[_S231 + 2U]];
    thread Vertex_0 _S235 = _S233;
    float3 _S236 = position_of_0(&_S235);
    thread Vertex_0 _S237 = _S232;
    float3 _S238 = position_of_0(&_S237);
    float3 _S239 = _S236 - _S238;
    thread Vertex_0 _S240 = _S234;
    float3 _S241 = position_of_0(&_S240);
    float3 _S242 = _S241 - _S238;
    float _S243 = _S233.u_0 - _S232.u_0;
    float _S244 = _S233.v_0 - _S232.v_0;
    float2 _S245 = float2(_S243, _S244);
    float _S246 = _S234.u_0 - _S232.u_0;
    float _S247 = _S234.v_0 - _S232.v_0;
    float2 _S248 = float2(_S246, _S247);
    float _S249;
    if((_S243 * _S247 - _S244 * _S246) < 0.0f)
    {
        _S249 = -1.0f;
    }
    else
    {
        _S249 = 1.0f;
    }
    float3 _S250 = float3(_S249)  * (float3(_S247)  * _S239 - float3(_S244)  * _S242);
    float3 _S251 = float3(_S249)  * (float3(_S243)  * _S242 - float3(_S246)  * _S239);
    thread VisiblePoint_0 point_1;
    float _S252 = 1.0f - _S228 - _S229;
    thread Vertex_0 _S253 = _S232;
    float3 _S254 = normal_of_0(&_S253);
    float3 _S255 = float3(_S252)  * _S254;
    thread Vertex_0 _S256 = _S233;
    float3 _S257 = normal_of_0(&_S256);
    float3 _S258 = float3(_S228) ;
    float3 _S259 = _S255 + _S258 * _S257;
    thread Vertex_0 _S260 = _S234;
    float3 _S261 = normal_of_0(&_S260);
    float3 _S262 = float3(_S229) ;
    float3 _S263 = normalize(_S259 + _S262 * _S261);
    (&point_1)->normal_0 = _S263;
    float3 _S264 = normalize(_S250 - _S263 * float3(dot(_S263, _S250)) );
    (&point_1)->axis_x_0 = _S264;
    (&point_1)->axis_y_0 = cross(_S263, _S264);
    float3 _S265 = normalize(cross(_S239, _S242));
    float3 _S266;
    if((dot(_S265, _S263)) < 0.0f)
    {
        _S266 = - _S265;
    }
    else
    {
        _S266 = _S265;
    }
    (&point_1)->face_normal_0 = _S266;
    (&point_1)->position_0 = _S238 + _S258 * _S239 + _S262 * _S242;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_1 = float2(_S232.u_0, _S232.v_0) + float2(_S228)  * _S245 + float2(_S229)  * _S248;
    bool _S267 = (dot(cross(_S250, _S251), (&point_1)->normal_0)) < 0.0f;
    float _S268 = _S230->uv_width_0;
    if(_S267)
    {
        _S249 = - _S230->uv_height_0;
    }
    else
    {
        _S249 = _S230->uv_height_0;
    }
    float2 _S269 = float2(_S268, _S249);
    (&point_1)->draft_per_uv_0 = _S269;
    float2 _S270 = (&point_1)->uv_1 * _S269;
    if(_S267)
    {
        _S249 = _S230->uv_height_0;
    }
    else
    {
        _S249 = 0.0f;
    }
    (&point_1)->draft_0 = _S270 + float2(0.0f, _S249);
    float2 _S271 = float2(0.0f) ;
    (&point_1)->draft_dx_0 = _S271;
    (&point_1)->draft_dy_0 = _S271;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S272, uint _S273, uint _S274, uint2 _S275, KernelContext_0 thread* kernelContext_25)
{
    Frame_0 device* _S276 = kernelContext_25->frames_0+_S272;
    uint _S277 = 3U * _S274;
    Vertex_0 _S278 = kernelContext_25->vertices_0[kernelContext_25->corners_0[_S277]];
    Vertex_0 _S279 = kernelContext_25->vertices_0[kernelContext_25->corners_0[_S277 + 1U]];
    Vertex_0 _S280 = kernelContext_25->vertices_0[kernelContext_25->corners_0[_S277 + 2U]];
    thread Vertex_0 _S281 = _S279;
    float3 _S282 = position_of_0(&_S281);
    thread Vertex_0 _S283 = _S278;
    float3 _S284 = position_of_0(&_S283);
    float3 _S285 = _S282 - _S284;
    thread Vertex_0 _S286 = _S280;
    float3 _S287 = position_of_0(&_S286);
    float3 _S288 = _S287 - _S284;
    float3 _S289 = cross(_S285, _S288);
    float _S290 = 1.0f / max(square_0(_S289), 1.00000000317107685e-30f);
    float3 _S291 = camera_right_0(_S272, kernelContext_25);
    float _S292 = float(_S276->width_0);
    float3 _S293 = _S291 * float3((2.0f / _S292)) ;
    float3 _S294 = camera_up_0(_S272, kernelContext_25);
    float _S295 = float(_S276->height_0);
    float3 _S296 = _S294 * float3((-2.0f / _S295)) ;
    float _S297 = float(_S275.x) + 0.5f - 0.5f * _S292;
    float _S298 = float(_S275.y) + 0.5f - 0.5f * _S295;
    float3 _S299 = camera_forward_0(_S272, kernelContext_25);
    float3 _S300 = _S299 + float3(_S297)  * _S293 + float3(_S298)  * _S296;
    float _S301 = dot(_S300, _S289);
    float _S302;
    if((abs(_S301)) > 1.00000000317107685e-30f)
    {
        _S302 = _S301;
    }
    else
    {
        _S302 = 1.00000000317107685e-30f;
    }
    float _S303 = 1.0f / _S302;
    float3 _S304 = camera_origin_0(_S272, kernelContext_25);
    float3 _S305 = _S284 - _S304;
    float3 _S306 = float3((dot(_S305, _S289) * _S303)) ;
    float3 _S307 = _S300 * _S306 - _S305;
    float3 _S308 = _S306 * (_S293 - _S300 * float3((dot(_S293, _S289) * _S303)) );
    float3 _S309 = _S306 * (_S296 - _S300 * float3((dot(_S296, _S289) * _S303)) );
    float3 _S310 = float3(_S290) ;
    float3 _S311 = cross(_S288, _S289) * _S310;
    float3 _S312 = cross(_S289, _S285) * _S310;
    float2 _S313 = float2(_S279.u_0 - _S278.u_0, _S279.v_0 - _S278.v_0);
    float2 _S314 = float2(_S280.u_0 - _S278.u_0, _S280.v_0 - _S278.v_0);
    VisiblePoint_0 _S315 = face_point_0(_S273, _S274, dot(_S307, _S311), dot(_S307, _S312), kernelContext_25);
    thread VisiblePoint_0 point_2 = _S315;
    (&point_2)->position_0 = _S284 + _S307;
    (&point_2)->view_0 = - normalize(_S300);
    (&point_2)->draft_dx_0 = (float2(dot(_S308, _S311))  * _S313 + float2(dot(_S308, _S312))  * _S314) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (float2(dot(_S309, _S311))  * _S313 + float2(dot(_S309, _S312))  * _S314) * (&point_2)->draft_per_uv_0;
    return point_2;
}

float3 filtered_albedo_0(uint _S316, const VisiblePoint_0 thread* _S317, KernelContext_0 thread* kernelContext_26)
{
    Fabric_0 device* _S318 = kernelContext_26->fabrics_0+_S316;
    uint _S319 = _S318->albedo_map_levels_0;
    if((_S318->albedo_map_levels_0) == 0U)
    {
        return float3(1.0f) ;
    }
    float2 _S320 = float2(_S318->uv_width_0, _S318->uv_height_0);
    float2 _S321 = _S317->draft_dx_0 / _S320;
    float2 _S322 = _S317->draft_dy_0 / _S320;
    uint _S323 = _S319 - 1U;
    uint _S324 = 1U << _S323;
    float _S325 = clamp(0.5f * binary_logarithm_0(max(abs(_S321.x * _S322.y - _S321.y * _S322.x), 9.99999968265522539e-21f) * (square_1(float(_S324)) / 3.0f)), 0.0f, float(_S319) - 1.0f);
    uint _S326 = min(uint(_S325), max(_S319, 2U) - 2U);
    uint _S327 = min(_S326 + 1U, _S323);
    uint _S328 = 1U << (2U * _S319);
    uint _S329 = _S318->albedo_map_0 + (_S328 - (_S328 >> (2U * _S327))) / 3U;
    float _S330 = (exponential_0(1.38629436492919922f * (_S325 - float(_S326))) - 1.0f) / 3.0f;
    float2 _S331 = _S317->uv_1;
    float3 _S332 = map_level_0(_S318->albedo_map_0 + (_S328 - (_S328 >> (2U * _S326))) / 3U, _S324 >> _S326, _S317->uv_1, kernelContext_26);
    float3 _S333 = map_level_0(_S329, _S324 >> _S327, _S331, kernelContext_26);
    return mix(_S332, _S333, float3(_S330) );
}

struct YarnPoint_0
{
    bool back_3;
    bool hole_2;
    bool is_warp_1;
    float x_11;
    float y_5;
    float height_3;
    float3 normal_4;
    float3 tangent_4;
    float roughness_8;
    Albedos_0 albedos_2;
};

struct Hit_0
{
    float x_12;
    float y_6;
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

Crossing_0 crossing_at_0(uint _S334, float _S335, float _S336, bool _S337, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S338 = kernelContext_27->fabrics_0+_S334;
    thread Crossing_0 crossing_2;
    Cell_0 _S339 = locate_0(_S338->warp_0, _S335, kernelContext_27);
    (&crossing_2)->warp_1 = _S339;
    Cell_0 _S340 = locate_0(_S338->weft_0, _S336, kernelContext_27);
    (&crossing_2)->weft_1 = _S340;
    uint _S341 = _S338->run_words_0 + 2U * ((&(&crossing_2)->weft_1)->thread_1 * _S338->ends_1 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S342 = kernelContext_27->words_0[_S341];
    (&crossing_2)->warp_word_0 = _S342;
    (&crossing_2)->weft_word_0 = kernelContext_27->words_0[_S341 + 1U];
    (&crossing_2)->warp_above_0 = ((_S342 & 1U) == 1U) != _S337;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S343, float _S344, float _S345, bool _S346, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S347 = kernelContext_28->fabrics_0+_S343;
    thread Sample_0 sample_0;
    Crossing_0 _S348 = crossing_at_0(_S343, _S344, _S345, _S346, kernelContext_28);
    (&sample_0)->crossing_1 = _S348;
    thread Crossing_0 _S349 = _S348;
    Shown_0 _S350 = shown_at_0(&_S349, _S346);
    (&sample_0)->shown_3 = _S350;
    uint _S351;
    if(_S350.is_warp_0)
    {
        _S351 = _S347->warp_0;
    }
    else
    {
        _S351 = _S347->weft_0;
    }
    uint _S352;
    if(_S350.is_warp_0)
    {
        _S352 = _S347->weft_0;
    }
    else
    {
        _S352 = _S347->warp_0;
    }
    thread Cell_0 _S353 = (&(&sample_0)->crossing_1)->warp_1;
    thread Cell_0 _S354 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S355 = select_cell_0(_S350.is_warp_0, &_S353, &_S354);
    thread Cell_0 _S356 = (&(&sample_0)->crossing_1)->weft_1;
    thread Cell_0 _S357 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S358 = select_cell_0(_S350.is_warp_0, &_S356, &_S357);
    thread Cell_0 _S359 = _S358;
    Run_0 _S360 = unpack_0(_S351, _S352, _S355.thread_1, &_S359, _S350.word_0, kernelContext_28);
    thread Cell_0 _S361 = _S355;
    Section_0 _S362 = section_at_0(&_S361);
    bool _S363;
    if(_S350.on_top_0)
    {
        _S363 = (_S360.distance_0) < (_S362.drop_0 * _S360.bend_1.sine_0);
    }
    else
    {
        _S363 = false;
    }
    bool _S364;
    if(_S350.on_top_0)
    {
        _S364 = !_S363;
    }
    else
    {
        _S364 = false;
    }
    float _S365;
    if(_S364)
    {
        _S365 = 1.0f;
    }
    else
    {
        _S365 = -1.0f;
    }
    float _S366;
    if(_S363)
    {
        _S366 = _S360.other_reach_0;
    }
    else
    {
        _S366 = _S360.reach_0;
    }
    float _S367;
    if(_S363)
    {
        _S367 = _S366 + _S360.distance_0;
    }
    else
    {
        _S367 = max(_S366 - _S360.distance_0, 0.0f);
    }
    float _S368 = _S366 / _S360.bend_1.sine_0 - _S365 * _S362.drop_0;
    float _S369 = _S367 * _S367;
    float _S370 = max(_S368 * _S368 - _S369, 9.99999968265522539e-21f);
    float _S371 = rsqrt(_S370);
    float _S372 = _S369 / (_S370 * _S371 + _S368);
    bool _S373 = _S367 > 0.0f;
    float _S374;
    if(_S350.on_top_0)
    {
        _S374 = 1.0f;
    }
    else
    {
        _S374 = -1.0f;
    }
    float _S375;
    if(_S360.near_start_0)
    {
        _S375 = 1.0f;
    }
    else
    {
        _S375 = -1.0f;
    }
    float _S376 = _S374 * _S375;
    if(_S373)
    {
        _S374 = _S368 * _S371;
    }
    else
    {
        _S374 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S362.slope_0 * _S374;
    if(_S373)
    {
        _S367 = _S376 * _S367 * _S371;
    }
    else
    {
        _S367 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S367;
    Family_0 _S377 = kernelContext_28->families_0[_S351];
    thread Shown_0 _S378 = _S350;
    thread Run_0 _S379 = _S360;
    thread Cell_0 _S380 = _S358;
    float2 _S381 = dive_0(_S352, &_S378, &_S379, &_S380, kernelContext_28);
    if(_S360.straight_0)
    {
        _S365 = 0.0f;
    }
    else
    {
        _S365 = _S377.height_scale_0 * _S365;
    }
    (&sample_0)->height_5 = _S365 * (_S366 * _S360.bend_1.half_tangent_0 - _S372) - _S377.height_scale_0 * _S362.drop_0 - _S381.x;
    float _S382 = _S377.height_scale_0 * (&sample_0)->slope_across_0;
    float _S383 = _S377.height_scale_0 * (&sample_0)->slope_along_0 - _S381.y;
    if(_S350.is_warp_0)
    {
        _S365 = _S382;
    }
    else
    {
        _S365 = _S383;
    }
    (&sample_0)->slope_x_1 = _S365;
    if(_S350.is_warp_0)
    {
        _S365 = _S383;
    }
    else
    {
        _S365 = _S382;
    }
    (&sample_0)->slope_y_1 = _S365;
    (&sample_0)->run_3 = _S360;
    (&sample_0)->section_1 = _S362;
    return sample_0;
}

float steps_per_length_0(uint _S384, const SearchQuality_0 thread* _S385, float3 _S386, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S387 = kernelContext_29->fabrics_0+_S384;
    return max(max(abs(_S386.x) * _S387->threads_per_x_0, abs(_S386.y) * _S387->threads_per_y_0) * _S385->steps_per_thread_0, abs(_S386.z) * _S387->per_relief_0 * _S385->steps_per_relief_0);
}

float cell_maximum_0(uint _S388, const Crossing_0 thread* _S389, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S390 = kernelContext_30->fabrics_0+_S388;
    bool _S391 = _S389->warp_above_0;
    uint _S392;
    if(_S389->warp_above_0)
    {
        _S392 = _S390->warp_0;
    }
    else
    {
        _S392 = _S390->weft_0;
    }
    uint _S393;
    if(_S391)
    {
        _S393 = _S389->warp_word_0;
    }
    else
    {
        _S393 = _S389->weft_word_0;
    }
    return float(_S393 >> 28U) * kernelContext_30->families_0[_S392].height_scale_0 * kernelContext_30->families_0[_S392].level_0;
}

Probe_0 probe_0(uint _S394, float _S395, float _S396, bool _S397, bool _S398, bool _S399, KernelContext_0 thread* kernelContext_31)
{
    Sample_0 _S400 = sample_at_0(_S394, _S395, _S396, _S397, kernelContext_31);
    thread Probe_0 probe_1;
    (&probe_1)->height_1 = _S400.height_5;
    (&probe_1)->hole_1 = _S400.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S400.slope_x_1;
    (&probe_1)->slope_y_0 = _S400.slope_y_1;
    uint _S401;
    if(_S400.shown_3.is_warp_0)
    {
        _S401 = _S400.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S401 = _S400.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S401;
    thread Crossing_0 _S402 = _S400.crossing_1;
    float _S403 = cell_maximum_0(_S394, &_S402, kernelContext_31);
    (&probe_1)->cell_max_0 = _S403;
    float _S404;
    if(_S398)
    {
        _S404 = _S400.crossing_1.warp_1.above_0;
    }
    else
    {
        _S404 = _S400.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S404;
    if(_S399)
    {
        _S404 = _S400.crossing_1.weft_1.above_0;
    }
    else
    {
        _S404 = _S400.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S404;
    bool _S405 = !_S400.shown_3.is_warp_0;
    thread Cell_0 _S406 = _S400.crossing_1.warp_1;
    thread Shown_0 _S407 = _S400.shown_3;
    thread Run_0 _S408 = _S400.run_3;
    float _S409 = outline_distance_0(&_S406, &_S407, &_S408, _S405, _S398);
    (&probe_1)->edge_x_0 = _S409;
    thread Cell_0 _S410 = _S400.crossing_1.weft_1;
    thread Shown_0 _S411 = _S400.shown_3;
    thread Run_0 _S412 = _S400.run_3;
    float _S413 = outline_distance_0(&_S410, &_S411, &_S412, _S400.shown_3.is_warp_0, _S399);
    (&probe_1)->edge_y_0 = _S413;
    return probe_1;
}

bool is_free_0(uint _S414, const SearchQuality_0 thread* _S415, float3 _S416, float3 _S417, bool _S418, float _S419, KernelContext_0 thread* kernelContext_32)
{
    float _S420 = _S417.z;
    if(_S420 <= 0.0f)
    {
        return false;
    }
    float _S421 = _S415->shadow_share_0;
    float _S422 = steps_per_length_0(_S414, _S415, _S417, kernelContext_32);
    float _S423 = 1.0f / max(_S421 * _S422, 9.99999971718068537e-10f);
    StepControl_0 _S424 = step_control_0(_S417.xy, _S423);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_2 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S425;
        if(count_2 < 1024U)
        {
            _S425 = (_S416.z + _S420 * distance_1) < _S419;
        }
        else
        {
            _S425 = false;
        }
        if(_S425)
        {
        }
        else
        {
            break;
        }
        float3 _S426 = _S416 + _S417 * float3(distance_1) ;
        Probe_0 _S427 = probe_0(_S414, _S426.x, _S426.y, _S418, _S424.right_0, _S424.up_0, kernelContext_32);
        float _S428 = _S426.z;
        float _S429 = _S428 - _S427.height_1;
        float _S430 = _S420 - _S427.slope_x_0 * _S417.x - _S427.slope_y_0 * _S417.y;
        bool _S431;
        if(!_S427.hole_1)
        {
            _S431 = _S429 < 0.0f;
        }
        else
        {
            _S431 = false;
        }
        if(_S431)
        {
            return false;
        }
        thread PreviousSample_0 _S432 = previous_3;
        thread Probe_0 _S433 = _S427;
        float _S434 = way_back_to_dip_0(&_S432, _S429, _S430, last_step_0, &_S433);
        if(_S434 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S434;
            distance_1 = distance_1 - _S434;
            last_step_0 = last_step_1;
            count_2 = count_2 + 1U;
            continue;
        }
        bool _S435 = _S428 > (_S427.cell_max_0);
        thread Probe_0 _S436 = _S427;
        PreviousSample_0 _S437 = after_sample_0(_S429, _S430, &_S436, _S435);
        float last_step_2;
        if(_S435)
        {
            thread StepControl_0 _S438 = _S424;
            float _S439 = StepControl_to_cell_exit_0(&_S438, _S427.side_x_0, _S427.side_y_0);
            last_step_2 = max(_S439, _S423);
        }
        else
        {
            thread StepControl_0 _S440 = _S424;
            thread Probe_0 _S441 = _S427;
            float _S442 = StepControl_to_next_sample_0(&_S440, &_S441, _S429, _S430);
            last_step_2 = _S442;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S437;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S443, const SearchQuality_0 thread* _S444, float _S445, float _S446, float3 _S447, bool _S448, KernelContext_0 thread* kernelContext_33)
{
    Fabric_0 device* _S449 = kernelContext_33->fabrics_0+_S443;
    Sample_0 _S450 = sample_at_0(_S443, _S445, _S446, _S448, kernelContext_33);
    if(!_S450.shown_3.hole_0)
    {
        return false;
    }
    float3 _S451 = float3(_S445, _S446, 0.0f);
    bool passes_0 = true;
    uint side_1 = 0U;
    for(;;)
    {
        bool _S452;
        if(side_1 < 2U)
        {
            _S452 = passes_0;
        }
        else
        {
            _S452 = false;
        }
        if(_S452)
        {
        }
        else
        {
            break;
        }
        float3 _S453;
        if(side_1 == 0U)
        {
            _S453 = _S447;
        }
        else
        {
            _S453 = float3(- _S447.x, - _S447.y, _S447.z);
        }
        bool _S454 = is_free_0(_S443, _S444, _S451, _S453, _S448 != (side_1 == 1U), _S449->height_high_0, kernelContext_33);
        uint _S455 = side_1 + 1U;
        passes_0 = _S454;
        side_1 = _S455;
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

float max_height_along_0(uint _S456, float _S457, float _S458, float _S459, float3 _S460, bool _S461, KernelContext_0 thread* kernelContext_34)
{
    Fabric_0 device* _S462 = kernelContext_34->fabrics_0+_S456;
    Cell_0 _S463 = locate_0(_S462->warp_0, _S457, kernelContext_34);
    uint _S464 = _S463.thread_1 / 2U;
    Cell_0 _S465 = locate_0(_S462->weft_0, _S458, kernelContext_34);
    uint _S466 = _S465.thread_1 / 2U;
    float _S467 = _S460.x;
    uint _S468;
    if(_S467 > 0.0f)
    {
        _S468 = 1U;
    }
    else
    {
        _S468 = 0U;
    }
    float _S469 = _S460.y;
    uint _S470;
    if(_S469 > 0.0f)
    {
        _S470 = 2U;
    }
    else
    {
        _S470 = 0U;
    }
    uint _S471 = kernelContext_34->words_0[_S462->max_heights_0 + 4U * (_S466 * _S462->max_height_columns_0 + _S464) + (_S468 + _S470)];
    int number_1;
    if(_S461)
    {
        number_1 = int(4);
    }
    else
    {
        number_1 = int(0);
    }
    uint _S472 = _S471 >> uint(number_1);
    float _S473 = max(abs(_S467) * _S462->threads_per_x_0, abs(_S469) * _S462->threads_per_y_0) / _S460.z;
    float _S474 = _S462->height_high_0;
    float max_height_0 = _S462->height_high_0;
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
        if(((max_height_0 - _S459) * _S473) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, float((_S472 >> uint(int(8) * number_1)) & 15U) * 0.06666667014360428f * _S474);
        }
        number_1 = number_1 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S475, float _S476, float _S477, bool _S478, bool _S479, bool _S480, KernelContext_0 thread* kernelContext_35)
{
    Crossing_0 _S481 = crossing_at_0(_S475, _S476, _S477, _S478, kernelContext_35);
    thread Crossing_0 _S482 = _S481;
    float _S483 = cell_maximum_0(_S475, &_S482, kernelContext_35);
    float _S484;
    if(_S479)
    {
        _S484 = _S481.warp_1.above_0;
    }
    else
    {
        _S484 = _S481.warp_1.below_0;
    }
    float _S485;
    if(_S480)
    {
        _S485 = _S481.weft_1.above_0;
    }
    else
    {
        _S485 = _S481.weft_1.below_0;
    }
    return float3(_S483, _S484, _S485);
}

float first_sample_height_0(uint _S486, const ViewRay_0 thread* _S487, const StepControl_0 thread* _S488, bool _S489, KernelContext_0 thread* kernelContext_36)
{
    float _S490 = max_height_along_0(_S486, _S487->origin_0.x, _S487->origin_0.y, 0.0f, float3(_S487->slope_1, 1.0f), _S489, kernelContext_36);
    uint count_3 = 0U;
    float height_7 = _S490;
    for(;;)
    {
        if(count_3 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S491 = ViewRay_at_0(_S487, height_7);
        float3 _S492 = cell_bounds_0(_S486, _S491.x, _S491.y, _S489, _S488->right_0, _S488->up_0, kernelContext_36);
        float _S493 = height_7 - _S492.x;
        float _S494 = StepControl_to_cell_exit_0(_S488, _S492.y, _S492.z);
        float height_8 = height_7 - clamp(_S493, 0.0f, _S494);
        if(_S493 <= _S494)
        {
            height_7 = height_8;
            break;
        }
        count_3 = count_3 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S495, const ViewRay_0 thread* _S496, const StepControl_0 thread* _S497, bool _S498, KernelContext_0 thread* kernelContext_37)
{
    Fabric_0 device* _S499 = kernelContext_37->fabrics_0+_S495;
    float _S500 = _S499->height_low_0 - (_S499->height_high_0 - _S499->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S501 = first_sample_height_0(_S495, _S496, _S497, _S498, kernelContext_37);
    (&end_1)->height_6 = _S501;
    (&end_1)->last_step_3 = _S497->epsilon_0;
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
        float2 _S502 = ViewRay_at_0(_S496, (&end_1)->height_6);
        Probe_0 _S503 = probe_0(_S495, _S502.x, _S502.y, _S498, _S497->right_0, _S497->up_0, kernelContext_37);
        float _S504 = (&end_1)->height_6 - _S503.height_1;
        thread Probe_0 _S505 = _S503;
        float _S506 = ViewRay_rate_0(_S496, &_S505);
        (&end_1)->depth_1 = - _S504;
        (&end_1)->rate_4 = _S506;
        bool _S507;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S507 = !_S503.hole_1;
        }
        else
        {
            _S507 = false;
        }
        bool _S508;
        if(_S507)
        {
            _S508 = ((&(&end_1)->previous_4)->yarn_0) == (_S503.yarn_1);
        }
        else
        {
            _S508 = false;
        }
        (&end_1)->smooth_0 = _S508;
        bool _S509;
        if(!_S503.hole_1)
        {
            _S509 = _S504 <= 0.0f;
        }
        else
        {
            _S509 = false;
        }
        bool _S510;
        if(_S509)
        {
            _S510 = true;
        }
        else
        {
            _S510 = ((&end_1)->height_6) <= _S500;
        }
        if(_S510)
        {
            break;
        }
        thread PreviousSample_0 _S511 = (&end_1)->previous_4;
        thread Probe_0 _S512 = _S503;
        float _S513 = way_back_to_dip_0(&_S511, _S504, _S506, (&end_1)->last_step_3, &_S512);
        if(_S513 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S513;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S513;
            count_4 = count_4 + 1U;
            continue;
        }
        float _S514 = StepControl_to_cell_exit_0(_S497, _S503.side_x_0, _S503.side_y_0);
        float _S515 = min(_S514, (&end_1)->height_6 - _S503.cell_max_0);
        thread Probe_0 _S516 = _S503;
        float _S517 = StepControl_to_next_sample_0(_S497, &_S516, _S504, _S506);
        bool _S518 = _S515 > _S517;
        thread Probe_0 _S519 = _S503;
        PreviousSample_0 _S520 = after_sample_0(_S504, _S506, &_S519, _S518);
        (&end_1)->previous_4 = _S520;
        float _S521 = max(_S515, _S517);
        (&end_1)->last_step_3 = _S521;
        (&end_1)->height_6 = (&end_1)->height_6 - _S521;
        count_4 = count_4 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S522, const ViewRay_0 thread* _S523, const StepControl_0 thread* _S524, bool _S525, const ViewRayEnd_0 thread* _S526, uint _S527, KernelContext_0 thread* kernelContext_38)
{
    Fabric_0 device* _S528 = kernelContext_38->fabrics_0+_S522;
    float _S529 = _S528->height_high_0 - _S528->height_low_0;
    float _S530 = _S526->height_6;
    float _S531 = _S526->last_step_3;
    float above_2 = _S526->height_6 + _S526->last_step_3;
    float above_gap_1 = clamp((&_S526->previous_4)->clearance_0, 0.0f, _S529);
    float under_gap_1 = clamp(_S526->depth_1, 0.0f, _S529);
    float _S532 = cubic_root_0(above_gap_1, - under_gap_1, (&_S526->previous_4)->rate_0 * _S526->last_step_3, _S526->rate_4 * _S526->last_step_3);
    bool _S533 = _S526->smooth_0;
    float middle_0;
    if(_S526->smooth_0)
    {
        middle_0 = above_2 - _S532 * _S531;
    }
    else
    {
        middle_0 = between_0(above_2, _S530, above_gap_1, under_gap_1);
    }
    float side_2 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S530;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S527)
        {
        }
        else
        {
            break;
        }
        float2 _S534 = ViewRay_at_0(_S523, middle_0);
        Probe_0 _S535 = probe_0(_S522, _S534.x, _S534.y, _S525, _S524->right_0, _S524->up_0, kernelContext_38);
        float _S536;
        if(_S535.hole_1)
        {
            _S536 = -1.0e+09f;
        }
        else
        {
            _S536 = _S535.height_1;
        }
        float _S537 = clamp(middle_0 - _S536, - _S529, _S529);
        float _S538;
        if(_S537 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S538 = 0.5f * above_gap_2;
            }
            else
            {
                _S538 = above_gap_2;
            }
            float _S539 = - _S537;
            under_1 = middle_0;
            above_gap_2 = _S538;
            under_gap_2 = _S539;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S538 = 0.5f * under_gap_2;
            }
            else
            {
                _S538 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S537;
            under_gap_2 = _S538;
            side_2 = -1.0f;
        }
        if(_S533)
        {
            thread Probe_0 _S540 = _S535;
            float _S541 = ViewRay_rate_0(_S523, &_S540);
            middle_0 = clamp(middle_0 + _S537 / min(_S541, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S533)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S542, const SearchQuality_0 thread* _S543, float _S544, float _S545, float3 _S546, bool _S547, KernelContext_0 thread* kernelContext_39)
{
    float _S548 = max(_S546.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S544, _S545);
    float2 _S549 = _S546.xy / float2(_S548) ;
    (&ray_0)->slope_1 = _S549;
    float2 _S550 = - _S549;
    float _S551 = steps_per_length_0(_S542, _S543, _S546, kernelContext_39);
    StepControl_0 _S552 = step_control_0(_S550, 1.0f / max(_S551 / _S548, 9.99999971718068537e-10f));
    thread ViewRay_0 _S553 = ray_0;
    thread StepControl_0 _S554 = _S552;
    ViewRayEnd_0 _S555 = search_down_0(_S542, &_S553, &_S554, _S547, kernelContext_39);
    thread Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    thread ViewRay_0 _S556 = ray_0;
    thread StepControl_0 _S557 = _S552;
    thread ViewRayEnd_0 _S558 = _S555;
    float _S559 = refined_height_0(_S542, &_S556, &_S557, _S547, &_S558, _S543->refinements_0, kernelContext_39);
    (&hit_0)->height_4 = _S559;
    thread ViewRay_0 _S560 = ray_0;
    float2 _S561 = ViewRay_at_0(&_S560, _S559);
    (&hit_0)->x_12 = _S561.x;
    (&hit_0)->y_6 = _S561.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S562, const SearchQuality_0 thread* _S563, float _S564, float _S565, float3 _S566, bool _S567, KernelContext_0 thread* kernelContext_40)
{
    bool _S568 = passes_through_0(_S562, _S563, _S564, _S565, _S566, _S567, kernelContext_40);
    if(!_S568)
    {
        Hit_0 _S569 = first_hit_of_yarn_0(_S562, _S563, _S564, _S565, _S566, _S567, kernelContext_40);
        return _S569;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_12 = _S564;
    (&hit_1)->y_6 = _S565;
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
    float3 normal_5;
    float3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S570, float _S571, float _S572, bool _S573, KernelContext_0 thread* kernelContext_41)
{
    Fabric_0 device* _S574 = kernelContext_41->fabrics_0+_S570;
    Sample_0 _S575 = sample_at_0(_S570, _S571, _S572, _S573, kernelContext_41);
    float _S576;
    if(_S575.shown_3.is_warp_0)
    {
        _S576 = _S575.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S576 = _S575.crossing_1.weft_1.half_width_1;
    }
    uint _S577;
    if(_S575.shown_3.is_warp_0)
    {
        _S577 = _S574->warp_0;
    }
    else
    {
        _S577 = _S574->weft_0;
    }
    Family_0 _S578 = kernelContext_41->families_0[_S577];
    float _S579;
    if(_S573)
    {
        _S579 = -1.0f;
    }
    else
    {
        _S579 = 1.0f;
    }
    float _S580 = _S578.twist_sine_0 * _S579;
    Family_0 _S581 = kernelContext_41->families_0[_S577];
    if(_S575.shown_3.is_warp_0)
    {
        _S579 = 1.0f;
    }
    else
    {
        _S579 = -1.0f;
    }
    float2 _S582 = fibre_direction_0(_S575.slope_across_0, _S579 * _S575.slope_along_0, _S580, _S581.twist_cosine_0);
    float _S583;
    if(_S575.shown_3.is_warp_0)
    {
        _S583 = _S575.slope_x_1;
    }
    else
    {
        _S583 = _S575.slope_y_1;
    }
    float _S584;
    if(_S575.shown_3.is_warp_0)
    {
        _S584 = _S575.slope_y_1;
    }
    else
    {
        _S584 = _S575.slope_x_1;
    }
    float _S585 = _S582.x;
    float _S586 = _S582.y;
    float _S587 = _S583 * _S585 + _S579 * _S584 * _S586;
    float _S588 = _S576 * 1.0154266357421875f;
    float _S589 = _S588 * arc_sine_0(clamp(_S575.section_1.across_1 / _S588, -1.0f, 1.0f));
    if(_S575.shown_3.is_warp_0)
    {
        _S576 = _S572;
    }
    else
    {
        _S576 = - _S571;
    }
    thread SurfacePoint_0 point_3;
    (&point_3)->hole_4 = _S575.shown_3.hole_0;
    (&point_3)->is_warp_2 = _S575.shown_3.is_warp_0;
    (&point_3)->warp_thread_0 = _S575.crossing_1.warp_1.thread_1;
    (&point_3)->weft_thread_0 = _S575.crossing_1.weft_1.thread_1;
    (&point_3)->height_9 = _S575.height_5;
    (&point_3)->normal_5 = normalize(float3(- _S575.slope_x_1, - _S575.slope_y_1, 1.0f));
    float3 _S590;
    if(_S575.shown_3.is_warp_0)
    {
        _S590 = float3(_S585, _S586, _S587);
    }
    else
    {
        _S590 = float3(- _S586, _S585, _S587);
    }
    (&point_3)->tangent_5 = normalize(_S590);
    (&point_3)->across_2 = _S575.section_1.across_1;
    (&point_3)->fibre_across_0 = _S589 * _S581.twist_cosine_0 + _S576 * _S580;
    (&point_3)->fibre_along_0 = _S576 * _S581.twist_cosine_0 - _S589 * _S580;
    return point_3;
}

Albedos_0 vary_albedos_0(uint _S591, const Albedos_0 thread* _S592, uint _S593, uint _S594, KernelContext_0 thread* kernelContext_42)
{
    Fabric_0 device* _S595 = kernelContext_42->fabrics_0+_S591;
    float3 _S596 = max(_S592->specular_reflect_0, _S592->specular_transmit_0);
    float3 _S597 = _S592->diffuse_reflect_0 + _S592->diffuse_transmit_0;
    float3 _S598 = float3(_S595->layer_bound_0) ;
    float3 _S599 = float3(1.0f) ;
    float3 _S600 = float3(bounded_gain_0(thread_gain_0(_S593, _S595->colour_noise_0, _S595->seed_0), _S597, _S599 - _S598 * _S596)) ;
    float _S601 = bounded_gain_0(fibre_gain_0(_S593, _S594, _S595->fibre_noise_0, _S595->seed_0), _S596, min((_S599 - _S600 * _S597) / _S598, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S600 * _S592->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S600 * _S592->diffuse_transmit_0;
    float3 _S602 = float3(_S601) ;
    (&varied_0)->specular_reflect_0 = _S602 * _S592->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S602 * _S592->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S603, const SurfacePoint_0 thread* _S604, const Albedos_0 thread* _S605, float _S606, float _S607, KernelContext_0 thread* kernelContext_43)
{
    Fabric_0 device* _S608 = kernelContext_43->fabrics_0+_S603;
    bool _S609 = _S604->is_warp_2;
    float _S610;
    if(_S604->is_warp_2)
    {
        _S610 = _S606;
    }
    else
    {
        _S610 = _S607;
    }
    float _S611 = _S610 - _S604->across_2;
    uint _S612;
    if(_S609)
    {
        _S612 = _S608->warp_0;
    }
    else
    {
        _S612 = _S608->weft_0;
    }
    Family_0 _S613 = kernelContext_43->families_0[_S612];
    int _S614 = int(kernelContext_43->families_0[_S612].count_0);
    if(_S609)
    {
        _S612 = _S604->warp_thread_0;
    }
    else
    {
        _S612 = _S604->weft_thread_0;
    }
    uint _S615 = uint(int(floor(_S611 / _S613.period_0)) * _S614 + int(_S612)) * 2U;
    if(_S609)
    {
        _S612 = 1U;
    }
    else
    {
        _S612 = 0U;
    }
    float _S616 = floor(_S604->fibre_across_0 / _S608->fibre_size_0);
    Albedos_0 _S617 = vary_albedos_0(_S603, _S605, _S615 + _S612, uint(int(_S616)) * 65536U + uint(int(floor(_S604->fibre_along_0 / (_S608->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S616))), kernelContext_43);
    return _S617;
}

YarnPoint_0 yarn_point_of_0(uint _S618, const SurfacePoint_0 thread* _S619, float _S620, float _S621, bool _S622, bool _S623, KernelContext_0 thread* kernelContext_44)
{
    Fabric_0 device* _S624 = kernelContext_44->fabrics_0+_S618;
    bool _S625 = _S619->is_warp_2;
    uint _S626;
    if(_S619->is_warp_2)
    {
        _S626 = _S624->warp_0;
    }
    else
    {
        _S626 = _S624->weft_0;
    }
    uint _S627;
    if(_S625)
    {
        _S627 = _S619->warp_thread_0;
    }
    else
    {
        _S627 = _S619->weft_thread_0;
    }
    Albedos_0 _S628 = albedos_of_0(_S626, _S627, kernelContext_44);
    bool _S629;
    if((_S624->fibre_noise_0) > 0.0f)
    {
        _S629 = true;
    }
    else
    {
        _S629 = (_S624->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_3;
    if(_S629)
    {
        thread Albedos_0 _S630 = _S628;
        Albedos_0 _S631 = varied_at_0(_S618, _S619, &_S630, _S620, _S621, kernelContext_44);
        albedos_3 = _S631;
    }
    else
    {
        albedos_3 = _S628;
    }
    thread YarnPoint_0 point_4;
    (&point_4)->back_3 = _S622;
    (&point_4)->hole_2 = _S623;
    (&point_4)->is_warp_1 = _S625;
    (&point_4)->x_11 = _S620;
    (&point_4)->y_5 = _S621;
    (&point_4)->height_3 = _S619->height_9;
    (&point_4)->normal_4 = _S619->normal_5;
    (&point_4)->tangent_4 = _S619->tangent_5;
    (&point_4)->roughness_8 = kernelContext_44->families_0[_S626].roughness_0;
    (&point_4)->albedos_2 = albedos_3;
    return point_4;
}

YarnPoint_0 locate_yarn_0(uint _S632, const SearchQuality_0 thread* _S633, float _S634, float _S635, float3 _S636, KernelContext_0 thread* kernelContext_45)
{
    bool _S637 = (_S636.z) < 0.0f;
    Hit_0 _S638 = first_hit_0(_S632, _S633, _S634, _S635, to_face_frame_0(_S636, _S637), _S637, kernelContext_45);
    SurfacePoint_0 _S639 = surface_at_0(_S632, _S638.x_12, _S638.y_6, _S637, kernelContext_45);
    thread SurfacePoint_0 _S640 = _S639;
    YarnPoint_0 _S641 = yarn_point_of_0(_S632, &_S640, _S638.x_12, _S638.y_6, _S637, _S638.hole_3, kernelContext_45);
    return _S641;
}

uint light_sample_count_0(int _S642, KernelContext_0 thread* kernelContext_46)
{
    Frame_0 device* _S643 = kernelContext_46->frames_0+_S642;
    return _S643->lights_0 + _S643->environment_samples_0;
}

float visibility_at_0(int _S644, uint _S645, uint2 _S646, KernelContext_0 thread* kernelContext_47)
{
    Frame_0 device* _S647 = kernelContext_47->frames_0+_S644;
    if((_S647->casts_shadows_0) == 0U)
    {
        return 1.0f;
    }
    return *(kernelContext_47->visibilities_0+((_S645 * _S647->height_0 + _S646.y) * _S647->width_0 + _S646.x));
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_3;
};

float3 environment_texel_0(int _S648, uint _S649, uint _S650, KernelContext_0 thread* kernelContext_48)
{
    Frame_0 device* _S651 = kernelContext_48->frames_0+_S648;
    uint _S652 = _S651->environment_table_0 + _S651->environment_rows_0 + 1U + _S651->environment_rows_0 * (_S651->environment_columns_0 + 1U) + 3U * (_S649 * _S651->environment_columns_0 + _S650);
    float _S653 = scene_number_0(_S652, kernelContext_48);
    float _S654 = scene_number_0(_S652 + 1U, kernelContext_48);
    float _S655 = scene_number_0(_S652 + 2U, kernelContext_48);
    return float3(_S653, _S654, _S655);
}

float3 sample_environment_0(int _S656, float2 _S657, float3 thread* _S658, KernelContext_0 thread* kernelContext_49)
{
    Frame_0 device* _S659 = kernelContext_49->frames_0+_S656;
    uint _S660 = _S659->environment_table_0;
    uint _S661 = _S659->environment_rows_0;
    Choice_0 _S662 = choose_0(_S659->environment_table_0, _S659->environment_rows_0, _S657.y, kernelContext_49);
    uint _S663 = _S659->environment_columns_0;
    Choice_0 _S664 = choose_0(_S660 + _S661 + 1U + _S662.index_7 * (_S659->environment_columns_0 + 1U), _S659->environment_columns_0, _S657.x, kernelContext_49);
    float3 _S665 = environment_texel_0(_S656, _S662.index_7, _S664.index_7, kernelContext_49);
    *_S658 = _S665 * float3((_S659->environment_total_0 / max(mean_0(_S665), 9.99999968265522539e-21f))) ;
    float _S666 = 3.14159274101257324f / float(_S661);
    float _S667 = mix(sine_cosine_0(float(_S662.index_7) * _S666).y, sine_cosine_0(float(_S662.index_7 + 1U) * _S666).y, _S662.remainder_0);
    float _S668 = sqrt(max(1.0f - _S667 * _S667, 0.0f));
    float2 _S669 = sine_cosine_0((float(_S664.index_7) + _S664.remainder_0) * (6.28318548202514648f / float(_S663)));
    float _S670 = _S668 * _S669.x;
    float _S671 = - _S668 * _S669.y;
    return float3(_S659->environment_cosine_0 * _S670 + _S659->environment_sine_0 * _S671, _S667, _S659->environment_cosine_0 * _S671 - _S659->environment_sine_0 * _S670);
}

LightSample_0 light_sample_0(int _S672, uint _S673, uint2 _S674, float3 _S675, KernelContext_0 thread* kernelContext_50)
{
    Frame_0 device* _S676 = kernelContext_50->frames_0+_S672;
    thread LightSample_0 sample_1;
    (&sample_1)->distance_3 = 1.00000001504746622e+30f;
    uint _S677 = _S676->lights_0;
    if(_S673 >= (_S676->lights_0))
    {
        uint _S678 = _S676->environment_samples_0;
        thread float3 weight_0;
        float3 _S679 = sample_environment_0(_S672, pixel_sequence_0(_S674, _S676->pass_number_0 * _S676->environment_samples_0 + (_S673 - _S677), 3U), &weight_0, kernelContext_50);
        (&sample_1)->towards_0 = _S679;
        (&sample_1)->irradiance_1 = weight_0 / float3(float(_S678)) ;
        return sample_1;
    }
    Light_0 _S680 = kernelContext_50->lights_1[_S673];
    (&sample_1)->irradiance_1 = float3(_S680.red_0, _S680.green_0, _S680.blue_0);
    (&sample_1)->towards_0 = float3(_S680.x_5, _S680.y_1, _S680.z_1);
    if((_S680.is_point_0) != 0U)
    {
        float3 _S681 = (&sample_1)->towards_0 - _S675;
        float _S682 = max(square_0(_S681), 9.999999960041972e-13f);
        (&sample_1)->distance_3 = sqrt(_S682);
        (&sample_1)->irradiance_1 = (&sample_1)->irradiance_1 / float3(_S682) ;
        (&sample_1)->towards_0 = normalize(_S681);
    }
    return sample_1;
}

float3 scattered_0(uint _S683, const YarnPoint_0 thread* _S684, float3 _S685, float3 _S686, KernelContext_0 thread* kernelContext_51)
{
    Fabric_0 device* _S687 = kernelContext_51->fabrics_0+_S683;
    float3 _S688 = float3(0.0f) ;
    bool _S689 = !_S684->hole_2;
    bool _S690;
    if(_S689)
    {
        _S690 = (_S685.z) > 0.0f;
    }
    else
    {
        _S690 = false;
    }
    float3 value_1;
    if(_S690)
    {
        value_1 = (&_S684->albedos_2)->diffuse_reflect_0 * float3(diffuse_reflection_0(_S685, _S684->normal_4, _S687->diffuse_blend_0))  + (&_S684->albedos_2)->specular_reflect_0 * float3(reflection_0(_S685, _S686, _S684->normal_4, _S684->tangent_4, _S684->roughness_8, _S687->optical_depth_0)) ;
    }
    else
    {
        if(_S689)
        {
            _S690 = (_S685.z) < 0.0f;
        }
        else
        {
            _S690 = false;
        }
        if(_S690)
        {
            value_1 = (&_S684->albedos_2)->diffuse_transmit_0 * float3(diffuse_reflection_0(- _S685, _S684->normal_4, _S687->diffuse_blend_0))  + (&_S684->albedos_2)->specular_transmit_0 * float3(transmission_0(_S685, _S686, _S684->normal_4, _S684->tangent_4, _S684->roughness_8, _S687->optical_depth_0)) ;
        }
        else
        {
            value_1 = _S688;
        }
    }
    float _S691 = _S687->sheen_strength_0;
    if((_S687->sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S692 = sheen_with_transmittance_0(_S685, _S686, _S691, _S687->sheen_roughness_0);
    return float3(_S692.y)  * value_1 + float3(_S692.x) ;
}

bool unoccluded_0(uint _S693, const SearchQuality_0 thread* _S694, float _S695, float _S696, float _S697, float3 _S698, bool _S699, KernelContext_0 thread* kernelContext_52)
{
    Fabric_0 device* _S700 = kernelContext_52->fabrics_0+_S693;
    if((_S698.z) <= 0.0f)
    {
        return false;
    }
    float _S701 = max_height_along_0(_S693, _S695, _S696, _S697, _S698, _S699, kernelContext_52);
    bool _S702 = is_free_0(_S693, _S694, float3(_S695, _S696, _S697 + _S700->lift_0), _S698, _S699, _S701, kernelContext_52);
    return _S702;
}

bool is_lit_0(uint _S703, const SearchQuality_0 thread* _S704, const YarnPoint_0 thread* _S705, float3 _S706, KernelContext_0 thread* kernelContext_53)
{
    if(_S705->hole_2)
    {
        return true;
    }
    bool _S707 = _S705->back_3;
    float3 _S708 = to_face_frame_0(_S706, _S705->back_3);
    float _S709 = _S708.z;
    bool _S710 = _S709 < 0.0f;
    float3 _S711 = _S705->normal_4;
    float _S712 = _S705->height_3;
    float3 normal_6;
    float height_10;
    if(_S710)
    {
        SurfacePoint_0 _S713 = surface_at_0(_S703, _S705->x_11, _S705->y_5, !_S707, kernelContext_53);
        normal_6 = _S713.normal_5;
        height_10 = _S713.height_9;
    }
    else
    {
        normal_6 = _S711;
        height_10 = _S712;
    }
    float3 _S714 = float3(_S708.xy, abs(_S709));
    if((dot(normal_6, _S714)) <= 0.0f)
    {
        return false;
    }
    bool _S715 = unoccluded_0(_S703, _S704, _S705->x_11, _S705->y_5, height_10, _S714, _S707 != _S710, kernelContext_53);
    return _S715;
}

float3 evaluate_0(uint _S716, const SearchQuality_0 thread* _S717, const YarnPoint_0 thread* _S718, float3 _S719, float3 _S720, KernelContext_0 thread* kernelContext_54)
{
    float3 _S721 = scattered_0(_S716, _S718, to_face_frame_0(_S719, _S718->back_3), to_face_frame_0(_S720, _S718->back_3), kernelContext_54);
    bool _S722;
    if((max(_S721.x, max(_S721.y, _S721.z))) <= 0.0f)
    {
        _S722 = true;
    }
    else
    {
        bool _S723 = is_lit_0(_S716, _S717, _S718, _S719, kernelContext_54);
        _S722 = !_S723;
    }
    if(_S722)
    {
        return float3(0.0f) ;
    }
    return _S721;
}

float straight_through_0(uint _S724, const YarnPoint_0 thread* _S725, float3 _S726, KernelContext_0 thread* kernelContext_55)
{
    Fabric_0 device* _S727 = kernelContext_55->fabrics_0+_S724;
    if(!_S725->hole_2)
    {
        return 0.0f;
    }
    float _S728 = _S727->sheen_strength_0;
    if((_S727->sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S728 * sheen_lobe_0(abs(_S726.z), _S727->sheen_roughness_0).z;
}

float4 light_of_point_0(int _S729, uint _S730, const VisiblePoint_0 thread* _S731, uint2 _S732, float3 _S733, float2 _S734, KernelContext_0 thread* kernelContext_56)
{
    SearchQuality_0 _S735 = default_quality_0();
    float3 _S736 = to_local_0(_S731, _S731->view_0);
    float _S737 = _S734.x;
    float _S738 = _S734.y;
    thread SearchQuality_0 _S739 = _S735;
    YarnPoint_0 _S740 = locate_yarn_0(_S730, &_S739, _S737, _S738, _S736, kernelContext_56);
    thread YarnPoint_0 point_5 = _S740;
    thread Albedos_0 _S741 = (&point_5)->albedos_2;
    Albedos_0 _S742 = tinted_0(&_S741, _S733);
    (&point_5)->albedos_2 = _S742;
    float3 _S743 = float3(0.0f) ;
    uint number_2 = 0U;
    float3 radiance_1 = _S743;
    for(;;)
    {
        uint _S744 = light_sample_count_0(_S729, kernelContext_56);
        if(number_2 < _S744)
        {
        }
        else
        {
            break;
        }
        float _S745 = visibility_at_0(_S729, number_2, _S732, kernelContext_56);
        if(_S745 <= 0.0f)
        {
            number_2 = number_2 + 1U;
            continue;
        }
        LightSample_0 _S746 = light_sample_0(_S729, number_2, _S732, _S731->position_0, kernelContext_56);
        float3 _S747 = float3(_S745)  * _S746.irradiance_1;
        float3 _S748 = to_local_0(_S731, _S746.towards_0);
        thread SearchQuality_0 _S749 = _S735;
        thread YarnPoint_0 _S750 = point_5;
        float3 _S751 = evaluate_0(_S730, &_S749, &_S750, _S748, _S736, kernelContext_56);
        radiance_1 = radiance_1 + _S747 * _S751;
        number_2 = number_2 + 1U;
    }
    thread YarnPoint_0 _S752 = point_5;
    float _S753 = straight_through_0(_S730, &_S752, _S736, kernelContext_56);
    return float4(radiance_1, 1.0f - _S753);
}

[[kernel]] void shade_points(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], uint device* scene_words_1 [[buffer(11)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]], float device* visibilities_1 [[buffer(13)]], Light_0 device* lights_2 [[buffer(3)]], packed_float4 device* radiance_2 [[buffer(8)]])
{
    uint _S754;
    thread KernelContext_0 kernelContext_57;
    (&kernelContext_57)->frames_0 = frames_1;
    (&kernelContext_57)->layers_0 = layers_1;
    (&kernelContext_57)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_57)->fabrics_0 = fabrics_1;
    (&kernelContext_57)->corners_0 = corners_1;
    (&kernelContext_57)->vertices_0 = vertices_1;
    (&kernelContext_57)->scene_words_0 = scene_words_1;
    (&kernelContext_57)->families_0 = families_1;
    (&kernelContext_57)->words_0 = words_1;
    (&kernelContext_57)->visibilities_0 = visibilities_1;
    (&kernelContext_57)->lights_1 = lights_2;
    (&kernelContext_57)->radiance_0 = radiance_2;
    Frame_0 device* _S755 = frames_1+int(0);
    uint _S756 = id_0.x;
    uint _S757 = _S755->width_0;
    bool _S758;
    if(_S756 >= (_S755->width_0))
    {
        _S758 = true;
    }
    else
    {
        _S758 = (id_0.y) >= (_S755->height_0);
    }
    if(_S758)
    {
        return;
    }
    uint2 _S759 = id_0.xy;
    uint _S760 = id_0.y * _S757 + _S756;
    uint _S761 = ((&kernelContext_57)->layers_0+_S760)->face_0;
    if((((&kernelContext_57)->layers_0+_S760)->face_0) == 0U)
    {
        return;
    }
    uint _S762 = _S761 - 1U;
    uint _S763 = (&kernelContext_57)->face_fabrics_0[_S762];
    VisiblePoint_0 _S764 = visible_point_0(int(0), _S763, _S762, _S759, &kernelContext_57);
    thread VisiblePoint_0 _S765 = _S764;
    float3 _S766 = filtered_albedo_0(_S763, &_S765, &kernelContext_57);
    float4 _S767 = float4(0.0f) ;
    uint k_0 = 0U;
    float4 sum_0 = _S767;
    for(;;)
    {
        uint _S768 = _S755->samples_0;
        _S754 = _S755->samples_0;
        if(k_0 < (_S755->samples_0))
        {
        }
        else
        {
            break;
        }
        float2 _S769 = pixel_sequence_0(_S759, _S755->pass_number_0 * _S768 + k_0, 1U) - float2(0.5f) ;
        float2 _S770 = _S764.draft_0 + float2(_S769.x)  * _S764.draft_dx_0 + float2(_S769.y)  * _S764.draft_dy_0;
        thread VisiblePoint_0 _S771 = _S764;
        float4 _S772 = light_of_point_0(int(0), _S763, &_S771, _S759, _S766, _S770, &kernelContext_57);
        float4 sum_1 = sum_0 + _S772;
        k_0 = k_0 + 1U;
        sum_0 = sum_1;
    }
    accumulate_0(_S760, sum_0 / float4(float(_S754)) , &kernelContext_57);
    return;
}

