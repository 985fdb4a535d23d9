#include <metal_stdlib>
#include <metal_math>
#include <metal_texture>
using namespace metal;
constant array<float2, int(9)> TAP_OFFSETS_0 = { float2(-0.3333333432674408f, -0.3333333432674408f), float2(-0.3333333432674408f, 0.0f), float2(-0.3333333432674408f, 0.3333333432674408f), float2(0.0f, -0.3333333432674408f), float2(0.0f, 0.0f), float2(0.0f, 0.3333333432674408f), float2(0.3333333432674408f, -0.3333333432674408f), float2(0.3333333432674408f, 0.0f), float2(0.3333333432674408f, 0.3333333432674408f) };
constant array<float, int(4)> PYRAMID_RADII_0 = { 1.0f, 2.0f, 4.0f, 8.0f };
uint firstbitlow_0(uint value_0)
{
    uint _S1;
    if(value_0 == 0U)
    {
        _S1 = 4294967295U;
    }
    else
    {
        uint _S2 = ctz(value_0);
        _S1 = _S2;
    }
    return _S1;
}

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

uint scramble_0(uint value_1)
{
    uint _S3 = value_1 * 747796405U + 2891336453U;
    uint _S4 = ((_S3 >> ((_S3 >> 28U) + 4U)) ^ _S3) * 277803737U;
    return (_S4 >> 22U) ^ _S4;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float2 pixel_sequence_0(uint2 pixel_0, uint index_0, uint stream_1)
{
    uint _S5 = pixel_0.x;
    uint _S6 = pixel_0.y;
    return fract(float2(uniform_hash_0(_S5, _S6, stream_1), uniform_hash_0(_S5, _S6, stream_1 + 1U)) + float2(float(index_0 & 65535U))  * float2(0.75487768650054932f, 0.56984031200408936f));
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
    float x_1;
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
    float device* visibilities_0;
    uint device* scene_words_0;
    Light_0 device* lights_1;
    Family_0 device* families_0;
    uint device* words_0;
};

float scene_number_0(uint index_1, KernelContext_0 thread* kernelContext_0)
{
    return (as_type<float>((kernelContext_0->scene_words_0[index_1])));
}

float scene_number_1(uint index_2, KernelContext_0 thread* kernelContext_1)
{
    return (as_type<float>((kernelContext_1->scene_words_0[index_2])));
}

struct Choice_0
{
    uint index_3;
    float remainder_0;
};

Choice_0 choose_0(uint table_0, uint count_1, float number_0, KernelContext_0 thread* kernelContext_2)
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
        uint _S7 = (low_0 + high_0) / 2U;
        float _S8 = scene_number_0(table_0 + _S7, kernelContext_2);
        if(_S8 <= number_0)
        {
            low_0 = _S7;
        }
        else
        {
            high_0 = _S7;
        }
    }
    uint _S9 = table_0 + low_0;
    float _S10 = scene_number_0(_S9, kernelContext_2);
    float _S11 = scene_number_0(_S9 + 1U, kernelContext_2);
    thread Choice_0 choice_0;
    (&choice_0)->index_3 = low_0;
    (&choice_0)->remainder_0 = saturate((number_0 - _S10) / max(_S11 - _S10, 9.999999960041972e-13f));
    return choice_0;
}

float mean_0(float3 colour_0)
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

float2 sine_cosine_0(float x_2)
{
    float _S12 = floor(x_2 * 0.63661974668502808f + 0.5f);
    float _S13 = x_2 - _S12 * 1.5703125f - _S12 * 0.00048375129699707f - _S12 * 7.54979012640433211e-08f;
    float _S14 = _S13 * _S13;
    float _S15 = ((-0.00019515295571182f * _S14 + 0.00833216123282909f) * _S14 - 0.16666655242443085f) * _S14 * _S13 + _S13;
    float _S16 = ((0.00002443315679557f * _S14 - 0.00138873164542019f) * _S14 + 0.04166664555668831f) * _S14 * _S14 - 0.5f * _S14 + 1.0f;
    uint _S17 = uint(int(_S12)) & 3U;
    float2 _S18;
    if((_S17 & 1U) != 0U)
    {
        _S18 = float2(_S16, _S15);
    }
    else
    {
        _S18 = float2(_S15, _S16);
    }
    float _S19;
    if((_S17 & 2U) != 0U)
    {
        _S19 = - _S18.x;
    }
    else
    {
        _S19 = _S18.x;
    }
    float _S20;
    if(((_S17 + 1U) & 2U) != 0U)
    {
        _S20 = - _S18.y;
    }
    else
    {
        _S20 = _S18.y;
    }
    return float2(_S19, _S20);
}

float inverse_of_0(float component_0)
{
    float _S21;
    if((abs(component_0)) > 9.99999968265522539e-21f)
    {
        _S21 = component_0;
    }
    else
    {
        _S21 = 9.99999968265522539e-21f;
    }
    return 1.0f / _S21;
}

bool meets_node_0(uint node_0, float3 origin_0, float3 inverse_0, float nearest_0, float farthest_0, KernelContext_0 thread* kernelContext_3)
{
    uint _S22 = 6U * (node_0 - 1U);
    float _S23 = scene_number_1(_S22, kernelContext_3);
    float _S24 = scene_number_1(_S22 + 1U, kernelContext_3);
    float _S25 = scene_number_1(_S22 + 2U, kernelContext_3);
    float3 _S26 = float3(_S23, _S24, _S25);
    float _S27 = scene_number_1(_S22 + 3U, kernelContext_3);
    float _S28 = scene_number_1(_S22 + 4U, kernelContext_3);
    float _S29 = scene_number_1(_S22 + 5U, kernelContext_3);
    float3 _S30 = (_S26 - origin_0) * inverse_0;
    float3 _S31 = (float3(_S27, _S28, _S29) - origin_0) * inverse_0;
    float3 _S32 = min(_S30, _S31);
    float3 _S33 = max(_S30, _S31) * float3(1.0000004768371582f) ;
    return (max(max(_S32.x, _S32.y), max(_S32.z, nearest_0))) <= (min(min(_S33.x, _S33.y), min(_S33.z, farthest_0)));
}

uint following_node_0(uint node_1)
{
    uint _S34 = node_1 + 1U;
    uint _S35 = _S34 >> (firstbitlow_0(_S34));
    uint _S36;
    if(_S35 == 1U)
    {
        _S36 = 0U;
    }
    else
    {
        _S36 = _S35;
    }
    return _S36;
}

struct Hit_0
{
    uint face_1;
    float distance_0;
    float weight_b_0;
    float weight_c_0;
};

Hit_0 meet_face_0(uint face_2, float3 origin_1, float3 direction_0, KernelContext_0 thread* kernelContext_4)
{
    uint _S37 = 3U * face_2;
    thread Vertex_0 _S38 = kernelContext_4->vertices_0[kernelContext_4->corners_0[_S37]];
    float3 _S39 = position_of_0(&_S38);
    thread Vertex_0 _S40 = kernelContext_4->vertices_0[kernelContext_4->corners_0[_S37 + 1U]];
    float3 _S41 = position_of_0(&_S40);
    float3 _S42 = _S41 - _S39;
    thread Vertex_0 _S43 = kernelContext_4->vertices_0[kernelContext_4->corners_0[_S37 + 2U]];
    float3 _S44 = position_of_0(&_S43);
    float3 _S45 = _S44 - _S39;
    float3 _S46 = cross(direction_0, _S45);
    float _S47 = dot(_S42, _S46);
    bool _S48 = (abs(_S47)) > 1.00000000317107685e-30f;
    float _S49;
    if(_S48)
    {
        _S49 = _S47;
    }
    else
    {
        _S49 = 1.00000000317107685e-30f;
    }
    float _S50 = 1.0f / _S49;
    float3 _S51 = origin_1 - _S39;
    float3 _S52 = cross(_S51, _S42);
    thread Hit_0 hit_0;
    float _S53 = dot(_S51, _S46) * _S50;
    (&hit_0)->weight_b_0 = _S53;
    (&hit_0)->weight_c_0 = dot(direction_0, _S52) * _S50;
    (&hit_0)->distance_0 = dot(_S45, _S52) * _S50;
    bool _S54;
    if(_S53 >= 0.0f)
    {
        _S54 = ((&hit_0)->weight_c_0) >= 0.0f;
    }
    else
    {
        _S54 = false;
    }
    if(_S54)
    {
        _S54 = ((&hit_0)->weight_b_0 + (&hit_0)->weight_c_0) <= 1.0f;
    }
    else
    {
        _S54 = false;
    }
    if(_S54)
    {
        _S54 = _S48;
    }
    else
    {
        _S54 = false;
    }
    uint _S55;
    if(_S54)
    {
        _S55 = face_2;
    }
    else
    {
        _S55 = 4294967295U;
    }
    (&hit_0)->face_1 = _S55;
    return hit_0;
}

struct VisiblePoint_0
{
    float3 position_0;
    float3 view_0;
    float3 axis_x_0;
    float3 axis_y_0;
    float3 normal_0;
    float3 face_normal_0;
    float2 uv_0;
    float2 draft_per_uv_0;
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(const VisiblePoint_0 thread* point_0, float3 direction_1)
{
    return float3(dot(direction_1, point_0->axis_x_0), dot(direction_1, point_0->axis_y_0), dot(direction_1, point_0->normal_0));
}

float3 to_face_frame_0(float3 direction_2, bool back_1)
{
    float2 _S56 = direction_2.xy;
    float _S57;
    if(back_1)
    {
        _S57 = - direction_2.z;
    }
    else
    {
        _S57 = direction_2.z;
    }
    return float3(_S56, _S57);
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

float natural_logarithm_0(float x_3)
{
    uint _S58 = (as_type<uint>((x_3)));
    float exponent_0 = float(int(_S58 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S58 & 8388607U) | 1056964608U)));
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
    float _S59 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S59 - exponent_1 * 0.00021219444170129f - 0.5f * _S59) + exponent_1 * 0.693359375f;
}

float binary_logarithm_0(float x_4)
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
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

float2 turns_and_remainder_0(uint family_0, float index_4, KernelContext_0 thread* kernelContext_5)
{
    float _S60 = floor(fma(index_4, kernelContext_5->families_0[family_0].inverse_count_0, kernelContext_5->families_0[family_0].half_inverse_count_0));
    return float2(_S60, fma(- _S60, kernelContext_5->families_0[family_0].count_0, index_4));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1, KernelContext_0 thread* kernelContext_6)
{
    float _S61 = floor(position_1 * kernelContext_6->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_1;
    float _S62 = fma(- _S61, kernelContext_6->families_0[family_1].size_0, position_1);
    (&cell_1)->below_0 = _S62;
    (&cell_1)->above_0 = kernelContext_6->families_0[family_1].size_0 - _S62;
    (&cell_1)->across_0 = _S62 - 0.5f * kernelContext_6->families_0[family_1].size_0;
    (&cell_1)->half_width_1 = kernelContext_6->families_0[family_1].half_width_0;
    float2 _S63 = turns_and_remainder_0(family_1, _S61, kernelContext_6);
    (&cell_1)->thread_1 = uint(clamp(_S63.y, 0.0f, kernelContext_6->families_0[family_1].count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_5, KernelContext_0 thread* kernelContext_7)
{
    return (as_type<float>((kernelContext_7->words_0[index_5])));
}

Cell_0 locate_varied_0(uint family_2, float position_2, KernelContext_0 thread* kernelContext_8)
{
    float turns_0 = (position_2 - kernelContext_8->families_0[family_2].start_0) * kernelContext_8->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S64 = turns_1 * kernelContext_8->families_0[family_2].period_0;
    uint thread_2 = kernelContext_8->words_0[kernelContext_8->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_8->families_0[family_2].bins_0, 0.0f, kernelContext_8->families_0[family_2].bins_0 - 1.0f))];
    float _S65 = table_number_0(kernelContext_8->families_0[family_2].place_table_0 + thread_2 * 4U + 1U, kernelContext_8);
    uint _S66;
    if(_S64 >= _S65)
    {
        _S66 = 1U;
    }
    else
    {
        _S66 = 0U;
    }
    uint _S67 = min(thread_2 + _S66, uint(kernelContext_8->families_0[family_2].count_0) - 1U);
    uint _S68 = kernelContext_8->families_0[family_2].place_table_0 + _S67 * 4U;
    thread Cell_0 cell_2;
    (&cell_2)->thread_1 = _S67;
    float _S69 = table_number_0(_S68, kernelContext_8);
    (&cell_2)->below_0 = _S64 - _S69;
    float _S70 = table_number_0(_S68 + 1U, kernelContext_8);
    (&cell_2)->above_0 = _S70 - _S64;
    float _S71 = table_number_0(_S68 + 2U, kernelContext_8);
    (&cell_2)->across_0 = _S64 - _S71;
    float _S72 = table_number_0(_S68 + 3U, kernelContext_8);
    (&cell_2)->half_width_1 = _S72;
    return cell_2;
}

Cell_0 locate_0(uint family_3, float position_3, KernelContext_0 thread* kernelContext_9)
{
    if((kernelContext_9->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S73 = locate_alike_0(family_3, position_3, kernelContext_9);
        return _S73;
    }
    Cell_0 _S74 = locate_varied_0(family_3, position_3, kernelContext_9);
    return _S74;
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
    bool _S75 = (abs((&crossing_0->warp_1)->across_0)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S76 = (abs((&crossing_0->weft_1)->across_0)) < ((&crossing_0->weft_1)->half_width_1);
    thread Shown_0 shown_0;
    bool _S77;
    if(_S75)
    {
        if(!_S76)
        {
            _S77 = true;
        }
        else
        {
            _S77 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S77 = false;
    }
    (&shown_0)->is_warp_0 = _S77;
    if(!_S75)
    {
        _S77 = !_S76;
    }
    else
    {
        _S77 = false;
    }
    (&shown_0)->hole_0 = _S77;
    uint _S78;
    if((&shown_0)->is_warp_0)
    {
        _S78 = crossing_0->warp_word_0;
    }
    else
    {
        _S78 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S78;
    (&shown_0)->on_top_0 = ((_S78 & 1U) == 1U) != back_2;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_0, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_3;
    uint _S79;
    if(is_first_0)
    {
        _S79 = first_0->thread_1;
    }
    else
    {
        _S79 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S79;
    float _S80;
    if(is_first_0)
    {
        _S80 = first_0->across_0;
    }
    else
    {
        _S80 = second_0->across_0;
    }
    (&cell_3)->across_0 = _S80;
    if(is_first_0)
    {
        _S80 = first_0->half_width_1;
    }
    else
    {
        _S80 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S80;
    if(is_first_0)
    {
        _S80 = first_0->below_0;
    }
    else
    {
        _S80 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S80;
    if(is_first_0)
    {
        _S80 = first_0->above_0;
    }
    else
    {
        _S80 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S80;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0, KernelContext_0 thread* kernelContext_10)
{
    float2 _S81 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0), kernelContext_10);
    float _S82 = _S81.x;
    Family_0 _S83 = kernelContext_10->families_0[family_4];
    float _S84 = table_number_0(kernelContext_10->families_0[family_4].place_table_0 + uint(_S81.y) * 4U, kernelContext_10);
    return fma(_S82, _S83.period_0, _S84);
}

float span_0(uint family_5, uint thread_4, int first_1, int last_0, KernelContext_0 thread* kernelContext_11)
{
    if((kernelContext_11->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * kernelContext_11->families_0[family_5].size_0;
    }
    float _S85 = boundary_0(family_5, thread_4, last_0, kernelContext_11);
    float _S86 = boundary_0(family_5, thread_4, first_1, kernelContext_11);
    return _S85 - _S86;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_5, KernelContext_0 thread* kernelContext_12)
{
    Family_0 _S87 = kernelContext_12->families_0[family_6];
    uint _S88;
    if((kernelContext_12->families_0[family_6].is_alike_0) != 0U)
    {
        _S88 = 0U;
    }
    else
    {
        _S88 = thread_5 * 4U;
    }
    uint _S89 = _S87.bend_table_0 + _S88;
    thread Bend_0 bend_0;
    float _S90 = table_number_0(_S89, kernelContext_12);
    (&bend_0)->sine_0 = _S90;
    float _S91 = table_number_0(_S89 + 1U, kernelContext_12);
    (&bend_0)->half_tangent_0 = _S91;
    float _S92 = table_number_0(_S89 + 2U, kernelContext_12);
    (&bend_0)->arc_0 = _S92;
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_6, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_13)
{
    int _S93 = int((word_1 >> 1U) & 127U);
    int _S94 = int((word_1 >> 8U) & 127U);
    int _S95 = int((word_1 >> 15U) & 63U);
    int _S96 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S97 = crossed_0->below_0;
    uint _S98 = crossed_0->thread_1;
    int _S99 = - _S93;
    float _S100 = span_0(other_0, crossed_0->thread_1, _S99, int(0), kernelContext_13);
    float _S101 = _S97 + _S100;
    (&run_0)->from_start_0 = _S101;
    float _S102 = crossed_0->above_0;
    int _S103 = _S94 + int(1);
    float _S104 = span_0(other_0, _S98, int(1), _S103, kernelContext_13);
    float _S105 = _S102 + _S104;
    (&run_0)->to_end_0 = _S105;
    bool _S106 = _S101 < _S105;
    (&run_0)->near_start_0 = _S106;
    int _S107;
    if(_S106)
    {
        _S107 = _S99 - _S95;
    }
    else
    {
        _S107 = _S103;
    }
    int _S108;
    if((&run_0)->near_start_0)
    {
        _S108 = _S99;
    }
    else
    {
        _S108 = _S103 + _S96;
    }
    Bend_0 _S109 = bend_of_0(own_0, thread_6, kernelContext_13);
    (&run_0)->bend_1 = _S109;
    float _S110;
    if((&run_0)->straight_0)
    {
        _S110 = 1.0e+06f;
    }
    else
    {
        _S110 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_1 = _S110;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S111 = span_0(other_0, _S98, _S107, _S108, kernelContext_13);
    (&run_0)->other_reach_0 = min(0.5f * _S111, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S93 == int(0);
    (&run_0)->last_crossing_0 = _S94 == int(0);
    return run_0;
}

float square_1(float x_5)
{
    return x_5 * x_5;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(const Cell_0 thread* cell_4)
{
    float _S112 = cell_4->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S113 = clamp(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_1 = _S113;
    float _S114 = _S112 * _S112 - square_1(_S113);
    float _S115 = rsqrt(_S114);
    (&section_0)->drop_0 = _S112 - _S114 * _S115;
    (&section_0)->slope_0 = - _S113 * _S115;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_7, int step_1, KernelContext_0 thread* kernelContext_14)
{
    if((kernelContext_14->families_0[family_7].is_alike_0) != 0U)
    {
        float _S116 = table_number_0(kernelContext_14->families_0[family_7].bend_table_0 + 3U, kernelContext_14);
        return _S116;
    }
    Family_0 _S117 = kernelContext_14->families_0[family_7];
    float2 _S118 = turns_and_remainder_0(family_7, float(int(thread_7) + step_1), kernelContext_14);
    float _S119 = table_number_0(_S117.bend_table_0 + uint(_S118.y) * 4U + 3U, kernelContext_14);
    return _S119;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_15)
{
    float _S120 = crossed_1->below_0;
    float _S121 = crossed_1->above_0;
    bool _S122 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S123 = min(crossed_1->below_0, crossed_1->above_0);
    float _S124;
    if(_S122)
    {
        _S124 = _S120 - crossed_1->across_0;
    }
    else
    {
        _S124 = _S121 + crossed_1->across_0;
    }
    float _S125 = _S124 - crossed_1->half_width_1;
    bool _S126;
    if(_S122)
    {
        _S126 = run_1->first_crossing_0;
    }
    else
    {
        _S126 = run_1->last_crossing_0;
    }
    bool _S127 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S124 = 0.0f;
    }
    else
    {
        Family_0 _S128 = kernelContext_15->families_0[other_1];
        float _S129 = edge_drop_0(other_1, crossed_1->thread_1, int(0), kernelContext_15);
        _S124 = _S128.height_scale_0 * _S129;
    }
    float _S130;
    if(_S127 != _S126)
    {
        _S130 = 0.0f;
    }
    else
    {
        Family_0 _S131 = kernelContext_15->families_0[other_1];
        uint _S132 = crossed_1->thread_1;
        int _S133;
        if(_S122)
        {
            _S133 = int(-1);
        }
        else
        {
            _S133 = int(1);
        }
        float _S134 = edge_drop_0(other_1, _S132, _S133, kernelContext_15);
        _S130 = _S131.height_scale_0 * _S134;
    }
    float _S135 = 1.0f / max(2.0f * _S125, 9.999999960041972e-13f);
    float _S136 = clamp((_S125 - _S123) * _S135, 0.0f, 1.0f);
    float _S137 = _S124 + (_S130 - _S124) * (_S136 * _S136 * (3.0f - 2.0f * _S136));
    float _S138 = (_S124 - _S130) * (6.0f * _S136 * (1.0f - _S136) * _S135);
    if(_S122)
    {
        _S124 = 1.0f;
    }
    else
    {
        _S124 = -1.0f;
    }
    return float2(_S137, _S138 * _S124);
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

StepControl_0 step_control_0(float2 direction_3, float step_3)
{
    thread StepControl_0 control_0;
    (&control_0)->step_2 = step_3;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_3;
    float _S139 = direction_3.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S139), 9.99999971718068537e-10f);
    float _S140 = direction_3.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S140), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S139 > 0.0f;
    (&control_0)->up_0 = _S140 > 0.0f;
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
    float _S141;
    if(forwards_0)
    {
        _S141 = cell_5->across_0;
    }
    else
    {
        _S141 = - cell_5->across_0;
    }
    float _S142;
    if(forwards_0)
    {
        _S142 = cell_5->above_0;
    }
    else
    {
        _S142 = cell_5->below_0;
    }
    bool _S143;
    if(forwards_0)
    {
        _S143 = run_2->last_crossing_0;
    }
    else
    {
        _S143 = run_2->first_crossing_0;
    }
    bool _S144;
    if(forwards_0)
    {
        _S144 = run_2->first_crossing_0;
    }
    else
    {
        _S144 = run_2->last_crossing_0;
    }
    float _S145 = cell_5->half_width_1;
    float _S146 = - cell_5->half_width_1;
    bool _S147 = _S141 < _S146;
    bool _S148 = _S141 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S143 = !_S143;
    }
    else
    {
        _S143 = false;
    }
    if(_S143)
    {
        _S143 = !shown_2->hole_0;
    }
    else
    {
        _S143 = false;
    }
    bool _S149;
    if(_S143)
    {
        _S149 = shown_2->on_top_0;
    }
    else
    {
        _S149 = false;
    }
    if(_S149)
    {
        if(_S144)
        {
            _S144 = _S147;
        }
        else
        {
            _S144 = false;
        }
        _S144 = !_S144;
    }
    else
    {
        _S144 = false;
    }
    if(shown_2->hole_0)
    {
        _S143 = true;
    }
    else
    {
        if(_S143)
        {
            _S143 = !shown_2->on_top_0;
        }
        else
        {
            _S143 = false;
        }
    }
    float _S150;
    if(_S147)
    {
        _S150 = _S146;
    }
    else
    {
        _S150 = _S145;
    }
    float _S151 = _S150 - _S141;
    if(_S143)
    {
        _S141 = 2.0f * _S142 + _S141 - _S145;
    }
    else
    {
        _S141 = _S142;
    }
    if(_S144)
    {
        if(forwards_0)
        {
            _S141 = run_2->to_end_0;
        }
        else
        {
            _S141 = run_2->from_start_0;
        }
        return _S141;
    }
    if(_S148)
    {
    }
    else
    {
        _S141 = _S151;
    }
    return _S141;
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
    float _S152 = previous_1->rate_0;
    float _S153 = previous_1->rate_0 * step_4;
    float _S154 = rate_1 * step_4;
    bool _S155;
    if(!previous_1->known_0)
    {
        _S155 = true;
    }
    else
    {
        _S155 = here_0->hole_1;
    }
    if(_S155)
    {
        _S155 = true;
    }
    else
    {
        _S155 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S155)
    {
        _S155 = true;
    }
    else
    {
        _S155 = _S152 >= 0.0f;
    }
    if(_S155)
    {
        _S155 = true;
    }
    else
    {
        _S155 = rate_1 <= 0.0f;
    }
    if(_S155)
    {
        return -1.0f;
    }
    float _S156 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S153) >= 0.0f)
    {
        _S155 = (3.0f * clearance_1 - _S154) >= 0.0f;
    }
    else
    {
        _S155 = false;
    }
    if(_S155)
    {
        return -1.0f;
    }
    float _S157 = clearance_1 - _S156;
    float _S158 = 6.0f * _S157 - 4.0f * _S153 - 2.0f * _S154;
    float _S159 = -2.0f * _S153 / max(_S158 + sqrt(max(_S158 * _S158 - 4.0f * (3.0f * (_S153 + _S154 - 2.0f * _S157)) * _S153, 0.0f)), 9.99999968265522539e-21f);
    float _S160 = 1.0f - _S159;
    float _S161 = (_S156 * (2.0f * _S159 + 1.0f) + _S153 * _S159) * _S160 * _S160;
    float _S162 = (clearance_1 * (2.0f * _S160 + 1.0f) - _S154 * _S160) * _S159 * _S159;
    if(_S159 > 0.01999999955296516f)
    {
        _S155 = _S160 > 0.01999999955296516f;
    }
    else
    {
        _S155 = false;
    }
    if(_S155)
    {
        _S155 = (_S161 + _S162) < 0.0f;
    }
    else
    {
        _S155 = false;
    }
    float _S163;
    if(_S155)
    {
        _S163 = _S160 * step_4;
    }
    else
    {
        _S163 = -1.0f;
    }
    return _S163;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S164 = here_1->hole_1;
    float _S165;
    if(here_1->hole_1)
    {
        _S165 = 1.0e+09f;
    }
    else
    {
        _S165 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S165;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S166;
    if(!_S164)
    {
        _S166 = !is_cell_exit_0;
    }
    else
    {
        _S166 = false;
    }
    (&previous_2)->known_0 = _S166;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_1, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_1->per_x_0, side_y_1 * this_1->per_y_0), 0.0f) + this_1->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_2, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S167 = min(here_2->edge_x_0 * this_2->per_x_0, here_2->edge_y_0 * this_2->per_y_0);
    bool _S168;
    if(!here_2->hole_1)
    {
        _S168 = (rate_3 * _S167 + clearance_3) < 0.0f;
    }
    else
    {
        _S168 = false;
    }
    if(_S168)
    {
        _S168 = _S167 > (2.0f * this_2->epsilon_0);
    }
    else
    {
        _S168 = false;
    }
    float _S169 = this_2->step_2;
    float _S170;
    if(_S168)
    {
        _S170 = _S167 - this_2->epsilon_0;
    }
    else
    {
        _S170 = max(_S167, 0.0f) + this_2->epsilon_0;
    }
    return min(_S169, _S170);
}

struct ViewRay_0
{
    float2 origin_2;
    float2 slope_1;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_3, float height_2)
{
    return this_3->origin_2 + this_3->slope_1 * float2(height_2) ;
}

float ViewRay_rate_0(const ViewRay_0 thread* this_4, const Probe_0 thread* here_3)
{
    return here_3->slope_x_0 * this_4->slope_1.x + here_3->slope_y_0 * this_4->slope_1.y - 1.0f;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S171 = end_0 - start_1;
    float _S172 = start_rate_0 + end_rate_0 - 2.0f * _S171;
    float _S173 = 3.0f * _S171 - 2.0f * start_rate_0 - end_rate_0;
    float share_1 = start_1 / max(- _S171, 9.99999968265522539e-21f);
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
        float _S174 = clamp(share_1 - (((_S172 * share_1 + _S173) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S172 * share_1 + 2.0f * _S173) * share_1 + start_rate_0, 0.10000000149011612f * _S171 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S175 = i_0 + int(1);
        share_1 = _S174;
        i_0 = _S175;
    }
    return share_1;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float arc_tangent_quotient_0(float x_6, float y_2)
{
    return ((((((0.0f * x_6 + 0.00809729471802711f) * x_6 + -0.0377517081797123f) * x_6 + 0.08475969731807709f) * x_6 + -0.13537675142288208f) * x_6 + 0.19895026087760925f) * x_6 + -0.33327975869178772f) * x_6 + 0.99999970197677612f;
}

float arc_tangent_of_ratio_0(float ratio_0)
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

float arc_tangent_0(float y_3, float x_7)
{
    float _S176 = abs(x_7);
    float _S177 = abs(y_3);
    float angle_0 = arc_tangent_of_ratio_0(min(_S176, _S177) / max(max(_S176, _S177), 1.00000000317107685e-30f));
    float angle_1;
    if(_S177 > _S176)
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
    float _S178 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    float _S179 = floor(_S178);
    float _S180 = _S178 - _S179;
    float _S181 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    float _S182 = 7.0f * _S181 * sqrt(_S181);
    float _S183 = min(floor(_S182), 6.0f);
    float _S184 = _S182 - _S183;
    uint _S185 = uint(int(_S179) + int(32)) % 32U;
    uint _S186 = uint(_S183);
    uint _S187 = _S185 * 8U + _S186;
    uint _S188 = (_S185 + 1U) % 32U * 8U + _S186;
    thread NodeTaps_0 taps_0;
    (&taps_0)->nodes_0 = uint4(_S187, _S187 + 1U, _S188, _S188 + 1U);
    float _S189 = 1.0f - _S180;
    float _S190 = 1.0f - _S184;
    uint4 _S191 = uint4(float4(_S189 * _S190, _S189 * _S184, _S180 * _S190, _S180 * _S184) * float4(252.0f)  + float4(0.5f) );
    (&taps_0)->weights_0 = _S191;
    (&taps_0)->inverse_sum_0 = 1.0f / float(_S191.x + _S191.y + _S191.z + _S191.w);
    return taps_0;
}

float wrapped_cell_0(float position_4, float count_2)
{
    return min(floor((position_4 - floor(position_4)) * count_2), count_2 - 1.0f);
}

float4 bytes_of_sums_0(uint even_0, uint odd_0)
{
    return float4(float(even_0 & 65535U), float(odd_0 & 65535U), float(even_0 >> 16U), float(odd_0 >> 16U));
}

float4 interpolate_0(const NodeTaps_0 thread* taps_1, uint4 packs_1)
{
    uint4 _S192 = uint4(16711935U) ;
    uint4 _S193 = (packs_1 & _S192) * taps_1->weights_0;
    uint4 _S194 = ((packs_1 >> (uint4(8U) )) & _S192) * taps_1->weights_0;
    return bytes_of_sums_0(_S193.x + _S193.y + _S193.z + _S193.w, _S194.x + _S194.y + _S194.z + _S194.w) * float4(taps_1->inverse_sum_0) ;
}

float4 interpolate_table_0(const NodeTaps_0 thread* taps_2, uint table_1, uint stride_0, KernelContext_0 thread* kernelContext_16)
{
    uint4 _S195 = uint4(table_1)  + taps_2->nodes_0 * uint4(stride_0) ;
    float4 _S196 = interpolate_0(taps_2, uint4(kernelContext_16->words_0[_S195.x], kernelContext_16->words_0[_S195.y], kernelContext_16->words_0[_S195.z], kernelContext_16->words_0[_S195.w]));
    return _S196;
}

float sheen_scale_0(float x_8, float y_4)
{
    return (((((0.0f * x_8 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_8 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_8 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_8 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_8 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_8 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

float sheen_shear_0(float x_9, float y_5)
{
    return ((((0.0f * x_9 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_9 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_9 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_9 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_9 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_10, float y_6)
{
    return ((((0.0f * x_10 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_10 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_10 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_10 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_10 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

float exponential_0(float x_11)
{
    float _S197 = clamp(x_11, -87.0f, 88.0f);
    float _S198 = floor(_S197 * 1.4426950216293335f + 0.5f);
    float _S199 = _S197 - _S198 * 0.693359375f + _S198 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S199 + 0.00139819993637502f) * _S199 + 0.00833345204591751f) * _S199 + 0.04166579619050026f) * _S199 + 0.1666666567325592f) * _S199 + 0.5f;
    float _S200 = (as_type<float>((uint(int(_S198) + int(127)) << 23U)));
    float _S201;
    if(x_11 < -87.0f)
    {
        _S201 = 0.0f;
    }
    else
    {
        _S201 = (p_0 * _S199 * _S199 + _S199 + 1.0f) * _S200;
    }
    return _S201;
}

float3 sheen_lobe_0(float cos_view_0, float roughness_1)
{
    float _S202 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S203 = 2.0f * sqrt(_S202) - 1.0f;
    float _S204 = 3.0f * sqrt(sqrt(clamp(roughness_1, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S203, _S204), 0.00999999977648258f, 1.0f), clamp((1.0f - _S202) * sheen_shear_0(_S203, _S204), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S203, _S204), -60.0f, 60.0f))));
}

float3 camera_right_0(int _S205, KernelContext_0 thread* kernelContext_17)
{
    Frame_0 device* _S206 = kernelContext_17->frames_0+_S205;
    return float3(_S206->right_x_0, _S206->right_y_0, _S206->right_z_0);
}

float3 camera_up_0(int _S207, KernelContext_0 thread* kernelContext_18)
{
    Frame_0 device* _S208 = kernelContext_18->frames_0+_S207;
    return float3(_S208->up_x_0, _S208->up_y_0, _S208->up_z_0);
}

float3 camera_forward_0(int _S209, KernelContext_0 thread* kernelContext_19)
{
    Frame_0 device* _S210 = kernelContext_19->frames_0+_S209;
    return float3(_S210->forward_x_0, _S210->forward_y_0, _S210->forward_z_0);
}

float3 camera_origin_0(int _S211, KernelContext_0 thread* kernelContext_20)
{
    Frame_0 device* _S212 = kernelContext_20->frames_0+_S211;
    return float3(_S212->origin_x_0, _S212->origin_y_0, _S212->origin_z_0);
}

VisiblePoint_0 face_point_0(uint _S213, uint _S214, float _S215, float _S216, KernelContext_0 thread* kernelContext_21)
{
    Fabric_0 device* _S217 = kernelContext_21->fabrics_0+_S213;
    uint _S218 = 3U * _S214;
    Vertex_0 _S219 = kernelContext_21->vertices_0[kernelContext_21->corners_0[_S218]];
    Vertex_0 _S220 = kernelContext_21->vertices_0[kernelContext_21->corners_0[_S218 + 1U]];
    Vertex_0 _S221 = kernelContext_21->vertices_0[kernelContext_21->corners_0[_S218 + 2U]];
    thread Vertex_0 _S222 = _S220;
    float3 _S223 = position_of_0(&_S222);
    thread Vertex_0 _S224 = _S219;
    float3 _S225 = position_of_0(&_S224);
    float3 _S226 = _S223 - _S225;
    thread Vertex_0 _S227 = _S221;
    float3 _S228 = position_of_0(&_S227);
    float3 _S229 = _S228 - _S225;
    float _S230 = _S220.u_0 - _S219.u_0;
    float _S231 = _S220.v_0 - _S219.v_0;
    float2 _S232 = float2(_S230, _S231);
    float _S233 = _S221.u_0 - _S219.u_0;
    float _S234 = _S221.v_0 - _S219.v_0;
    float2 _S235 = float2(_S233, _S234);
    float _S236;
    if((_S230 * _S234 - _S231 * _S233) < 0.0f)
    {
        _S236 = -1.0f;
    }
    else
    {
        _S236 = 1.0f;
    }
    float3 _S237 = float3(_S236)  * (float3(_S234)  * _S226 - float3(_S231)  * _S229);
    float3 _S238 = float3(_S236)  * (float3(_S230)  * _S229 - float3(_S233)  * _S226);
    thread VisiblePoint_0 point_1;
    float _S239 = 1.0f - _S215 - _S216;
    thread Vertex_0 _S240 = _S219;
    float3 _S241 = normal_of_0(&_S240);
    float3 _S242 = float3(_S239)  * _S241;
    thread Vertex_0 _S243 = _S220;
    float3 _S244 = normal_of_0(&_S243);
    float3 _S245 = float3(_S215) ;
    float3 _S246 = _S242 + _S245 * _S244;
    thread Vertex_0 _S247 = _S221;
    float3 _S248 = normal_of_0(&_S247);
    float3 _S249 = float3(_S216) ;
    float3 _S250 = normalize(_S246 + _S249 * _S248);
    (&point_1)->normal_0 = _S250;
    float3 _S251 = normalize(_S237 - _S250 * float3(dot(_S250, _S237)) );
    (&point_1)->axis_x_0 = _S251;
    (&point_1)->axis_y_0 = cross(_S250, _S251);
    float3 _S252 = normalize(cross(_S226, _S229));
    float3 _S253;
    if((dot(_S252, _S250)) < 0.0f)
    {
        _S253 = - _S252;
    }
    else
    {
        _S253 = _S252;
    }
    (&point_1)->face_normal_0 = _S253;
    (&point_1)->position_0 = _S225 + _S245 * _S226 + _S249 * _S229;
    (&point_1)->view_0 = (&point_1)->normal_0;
    (&point_1)->uv_0 = float2(_S219.u_0, _S219.v_0) + float2(_S215)  * _S232 + float2(_S216)  * _S235;
    bool _S254 = (dot(cross(_S237, _S238), (&point_1)->normal_0)) < 0.0f;
    float _S255 = _S217->uv_width_0;
    if(_S254)
    {
        _S236 = - _S217->uv_height_0;
    }
    else
    {
        _S236 = _S217->uv_height_0;
    }
    float2 _S256 = float2(_S255, _S236);
    (&point_1)->draft_per_uv_0 = _S256;
    float2 _S257 = (&point_1)->uv_0 * _S256;
    if(_S254)
    {
        _S236 = _S217->uv_height_0;
    }
    else
    {
        _S236 = 0.0f;
    }
    (&point_1)->draft_0 = _S257 + float2(0.0f, _S236);
    float2 _S258 = float2(0.0f) ;
    (&point_1)->draft_dx_0 = _S258;
    (&point_1)->draft_dy_0 = _S258;
    return point_1;
}

VisiblePoint_0 visible_point_0(int _S259, uint _S260, uint _S261, uint2 _S262, KernelContext_0 thread* kernelContext_22)
{
    Frame_0 device* _S263 = kernelContext_22->frames_0+_S259;
    uint _S264 = 3U * _S261;
    Vertex_0 _S265 = kernelContext_22->vertices_0[kernelContext_22->corners_0[_S264]];
    Vertex_0 _S266 = kernelContext_22->vertices_0[kernelContext_22->corners_0[_S264 + 1U]];
    Vertex_0 _S267 = kernelContext_22->vertices_0[kernelContext_22->corners_0[_S264 + 2U]];
    thread Vertex_0 _S268 = _S266;
    float3 _S269 = position_of_0(&_S268);
    thread Vertex_0 _S270 = _S265;
    float3 _S271 = position_of_0(&_S270);
    float3 _S272 = _S269 - _S271;
    thread Vertex_0 _S273 = _S267;
    float3 _S274 = position_of_0(&_S273);
    float3 _S275 = _S274 - _S271;
    float3 _S276 = cross(_S272, _S275);
    float _S277 = 1.0f / max(square_0(_S276), 1.00000000317107685e-30f);
    float3 _S278 = camera_right_0(_S259, kernelContext_22);
    float _S279 = float(_S263->width_0);
    float3 _S280 = _S278 * float3((2.0f / _S279)) ;
    float3 _S281 = camera_up_0(_S259, kernelContext_22);
    float _S282 = float(_S263->height_0);
    float3 _S283 = _S281 * float3((-2.0f / _S282)) ;
    float _S284 = float(_S262.x) + 0.5f - 0.5f * _S279;
    float _S285 = float(_S262.y) + 0.5f - 0.5f * _S282;
    float3 _S286 = camera_forward_0(_S259, kernelContext_22);
    float3 _S287 = _S286 + float3(_S284)  * _S280 + float3(_S285)  * _S283;
    float _S288 = dot(_S287, _S276);
    float _S289;
    if((abs(_S288)) > 1.00000000317107685e-30f)
    {
        _S289 = _S288;
    }
    else
    {
        _S289 = 1.00000000317107685e-30f;
    }
    float _S290 = 1.0f / _S289;
    float3 _S291 = camera_origin_0(_S259, kernelContext_22);
    float3 _S292 = _S271 - _S291;
    float3 _S293 = float3((dot(_S292, _S276) * _S290)) ;
    float3 _S294 = _S287 * _S293 - _S292;
    float3 _S295 = _S293 * (_S280 - _S287 * float3((dot(_S280, _S276) * _S290)) );
    float3 _S296 = _S293 * (_S283 - _S287 * float3((dot(_S283, _S276) * _S290)) );
    float3 _S297 = float3(_S277) ;
    float3 _S298 = cross(_S275, _S276) * _S297;
    float3 _S299 = cross(_S276, _S272) * _S297;
    float2 _S300 = float2(_S266.u_0 - _S265.u_0, _S266.v_0 - _S265.v_0);
    float2 _S301 = float2(_S267.u_0 - _S265.u_0, _S267.v_0 - _S265.v_0);
    VisiblePoint_0 _S302 = face_point_0(_S260, _S261, dot(_S294, _S298), dot(_S294, _S299), kernelContext_22);
    thread VisiblePoint_0 point_2 = _S302;
    (&point_2)->position_0 = _S271 + _S294;
    (&point_2)->view_0 = - normalize(_S287);
    (&point_2)->draft_dx_0 = (float2(dot(_S295, _S298))  * _S300 + float2(dot(_S295, _S299))  * _S301) * (&point_2)->draft_per_uv_0;
    (&point_2)->draft_dy_0 = (float2(dot(_S296, _S298))  * _S300 + float2(dot(_S296, _S299))  * _S301) * (&point_2)->draft_per_uv_0;
    return point_2;
}

uint light_sample_count_0(int _S303, KernelContext_0 thread* kernelContext_23)
{
    Frame_0 device* _S304 = kernelContext_23->frames_0+_S303;
    return _S304->lights_0 + _S304->environment_samples_0;
}

struct LightSample_0
{
    float3 towards_0;
    float3 irradiance_1;
    float distance_2;
};

float3 environment_texel_0(int _S305, uint _S306, uint _S307, KernelContext_0 thread* kernelContext_24)
{
    Frame_0 device* _S308 = kernelContext_24->frames_0+_S305;
    uint _S309 = _S308->environment_table_0 + _S308->environment_rows_0 + 1U + _S308->environment_rows_0 * (_S308->environment_columns_0 + 1U) + 3U * (_S306 * _S308->environment_columns_0 + _S307);
    float _S310 = scene_number_0(_S309, kernelContext_24);
    float _S311 = scene_number_0(_S309 + 1U, kernelContext_24);
    float _S312 = scene_number_0(_S309 + 2U, kernelContext_24);
    return float3(_S310, _S311, _S312);
}

float3 sample_environment_0(int _S313, float2 _S314, float3 thread* _S315, KernelContext_0 thread* kernelContext_25)
{
    Frame_0 device* _S316 = kernelContext_25->frames_0+_S313;
    uint _S317 = _S316->environment_table_0;
    uint _S318 = _S316->environment_rows_0;
    Choice_0 _S319 = choose_0(_S316->environment_table_0, _S316->environment_rows_0, _S314.y, kernelContext_25);
    uint _S320 = _S316->environment_columns_0;
    Choice_0 _S321 = choose_0(_S317 + _S318 + 1U + _S319.index_3 * (_S316->environment_columns_0 + 1U), _S316->environment_columns_0, _S314.x, kernelContext_25);
    float3 _S322 = environment_texel_0(_S313, _S319.index_3, _S321.index_3, kernelContext_25);
    *_S315 = _S322 * float3((_S316->environment_total_0 / max(mean_0(_S322), 9.99999968265522539e-21f))) ;
    float _S323 = 3.14159274101257324f / float(_S318);
    float _S324 = mix(sine_cosine_0(float(_S319.index_3) * _S323).y, sine_cosine_0(float(_S319.index_3 + 1U) * _S323).y, _S319.remainder_0);
    float _S325 = sqrt(max(1.0f - _S324 * _S324, 0.0f));
    float2 _S326 = sine_cosine_0((float(_S321.index_3) + _S321.remainder_0) * (6.28318548202514648f / float(_S320)));
    float _S327 = _S325 * _S326.x;
    float _S328 = - _S325 * _S326.y;
    return float3(_S316->environment_cosine_0 * _S327 + _S316->environment_sine_0 * _S328, _S324, _S316->environment_cosine_0 * _S328 - _S316->environment_sine_0 * _S327);
}

LightSample_0 light_sample_0(int _S329, uint _S330, uint2 _S331, float3 _S332, KernelContext_0 thread* kernelContext_26)
{
    Frame_0 device* _S333 = kernelContext_26->frames_0+_S329;
    thread LightSample_0 sample_0;
    (&sample_0)->distance_2 = 1.00000001504746622e+30f;
    uint _S334 = _S333->lights_0;
    if(_S330 >= (_S333->lights_0))
    {
        uint _S335 = _S333->environment_samples_0;
        thread float3 weight_0;
        float3 _S336 = sample_environment_0(_S329, pixel_sequence_0(_S331, _S333->pass_number_0 * _S333->environment_samples_0 + (_S330 - _S334), 3U), &weight_0, kernelContext_26);
        (&sample_0)->towards_0 = _S336;
        (&sample_0)->irradiance_1 = weight_0 / float3(float(_S335)) ;
        return sample_0;
    }
    Light_0 _S337 = kernelContext_26->lights_1[_S330];
    (&sample_0)->irradiance_1 = float3(_S337.red_0, _S337.green_0, _S337.blue_0);
    (&sample_0)->towards_0 = float3(_S337.x_1, _S337.y_1, _S337.z_1);
    if((_S337.is_point_0) != 0U)
    {
        float3 _S338 = (&sample_0)->towards_0 - _S332;
        float _S339 = max(square_0(_S338), 9.999999960041972e-13f);
        (&sample_0)->distance_2 = sqrt(_S339);
        (&sample_0)->irradiance_1 = (&sample_0)->irradiance_1 / float3(_S339) ;
        (&sample_0)->towards_0 = normalize(_S338);
    }
    return sample_0;
}

float3 seen_position_0(int _S340, uint _S341, uint2 _S342, KernelContext_0 thread* kernelContext_27)
{
    Frame_0 device* _S343 = kernelContext_27->frames_0+_S340;
    uint _S344 = 3U * _S341;
    thread Vertex_0 _S345 = kernelContext_27->vertices_0[kernelContext_27->corners_0[_S344]];
    float3 _S346 = position_of_0(&_S345);
    thread Vertex_0 _S347 = kernelContext_27->vertices_0[kernelContext_27->corners_0[_S344 + 1U]];
    float3 _S348 = position_of_0(&_S347);
    float3 _S349 = _S348 - _S346;
    thread Vertex_0 _S350 = kernelContext_27->vertices_0[kernelContext_27->corners_0[_S344 + 2U]];
    float3 _S351 = position_of_0(&_S350);
    float3 _S352 = _S351 - _S346;
    float3 _S353 = cross(_S349, _S352);
    float _S354 = 1.0f / max(square_0(_S353), 1.00000000317107685e-30f);
    float _S355 = float(_S343->width_0);
    float _S356 = float(_S342.x) + 0.5f + _S343->jitter_x_0 - 0.5f * _S355;
    float _S357 = float(_S343->height_0);
    float _S358 = float(_S342.y) + 0.5f + _S343->jitter_y_0 - 0.5f * _S357;
    float3 _S359 = camera_forward_0(_S340, kernelContext_27);
    float3 _S360 = camera_right_0(_S340, kernelContext_27);
    float3 _S361 = _S359 + _S360 * float3((2.0f * _S356 / _S355)) ;
    float3 _S362 = camera_up_0(_S340, kernelContext_27);
    float3 _S363 = _S361 - _S362 * float3((2.0f * _S358 / _S357)) ;
    float _S364 = dot(_S363, _S353);
    float3 _S365 = camera_origin_0(_S340, kernelContext_27);
    float3 _S366 = _S346 - _S365;
    float _S367 = dot(_S366, _S353);
    float _S368;
    if((abs(_S364)) > 1.00000000317107685e-30f)
    {
        _S368 = _S364;
    }
    else
    {
        _S368 = 1.00000000317107685e-30f;
    }
    float3 _S369 = _S363 * float3((_S367 / _S368))  - _S366;
    float _S370 = clamp(dot(_S369, cross(_S352, _S353)) * _S354, 0.0f, 1.0f);
    return _S346 + float3(_S370)  * _S349 + float3(clamp(dot(_S369, cross(_S353, _S349)) * _S354, 0.0f, 1.0f - _S370))  * _S352;
}

Hit_0 nearest_hit_0(int _S371, float3 _S372, float3 _S373, float _S374, float _S375, uint _S376, bool _S377, KernelContext_0 thread* kernelContext_28)
{
    Frame_0 device* _S378 = kernelContext_28->frames_0+_S371;
    float3 _S379 = float3(inverse_of_0(_S373.x), inverse_of_0(_S373.y), inverse_of_0(_S373.z));
    thread Hit_0 found_0;
    (&found_0)->face_1 = 4294967295U;
    (&found_0)->distance_0 = _S375;
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
        bool _S380 = meets_node_0(node_2, _S372, _S379, _S374, (&found_0)->distance_0, kernelContext_28);
        uint node_3;
        if(!_S380)
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            uint _S381 = _S378->leaves_0;
            if(node_2 < (_S378->leaves_0))
            {
                node_3 = node_2 * 2U;
            }
            else
            {
                uint _S382 = _S378->leaf_faces_0 + 4U * (node_2 - _S381);
                uint _S383 = following_node_0(node_2);
                uint number_1 = 0U;
                node_3 = _S383;
                for(;;)
                {
                    if(number_1 < 4U)
                    {
                    }
                    else
                    {
                        break;
                    }
                    uint _S384 = kernelContext_28->scene_words_0[_S382 + number_1];
                    bool _S385;
                    if(_S384 == 4294967295U)
                    {
                        _S385 = true;
                    }
                    else
                    {
                        _S385 = _S384 == _S376;
                    }
                    if(_S385)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    Hit_0 _S386 = meet_face_0(_S384, _S372, _S373, kernelContext_28);
                    bool _S387;
                    if((_S386.face_1) == 4294967295U)
                    {
                        _S387 = true;
                    }
                    else
                    {
                        _S387 = (_S386.distance_0) <= _S374;
                    }
                    bool _S388;
                    if(_S387)
                    {
                        _S388 = true;
                    }
                    else
                    {
                        _S388 = (_S386.distance_0) >= ((&found_0)->distance_0);
                    }
                    if(_S388)
                    {
                        number_1 = number_1 + 1U;
                        continue;
                    }
                    found_0 = _S386;
                    bool _S389;
                    if(_S377)
                    {
                        _S389 = ((kernelContext_28->fabrics_0+kernelContext_28->face_fabrics_0[_S384])->is_open_0) == 0U;
                    }
                    else
                    {
                        _S389 = false;
                    }
                    uint node_4;
                    if(_S389)
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
    float points_0;
};

Regime_0 regime_of_0(uint _S390, const Footprint_0 thread* _S391, float _S392, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S393 = kernelContext_29->fabrics_0+_S390;
    float _S394 = Footprint_spread_side_0(_S391);
    float _S395 = clamp((binary_logarithm_0(max(_S394, 9.99999971718068537e-10f)) - _S393->lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    thread Regime_0 regime_0;
    float _S396 = _S395 * _S395 * (3.0f - 2.0f * _S395);
    (&regime_0)->prefiltered_0 = _S396;
    (&regime_0)->threads_0 = _S394 * _S393->lobes_0.threads_per_mm_0;
    float _S397 = mix(max(8.0f / _S392, 1.0f), 1.0f, _S396);
    float _S398;
    if(_S396 < 1.0f)
    {
        _S398 = clamp((&regime_0)->threads_0 * 12.0f, 1.0f, _S397);
    }
    else
    {
        _S398 = 0.0f;
    }
    (&regime_0)->points_0 = _S398;
    return regime_0;
}

struct Hit_1
{
    float x_12;
    float y_7;
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

Crossing_0 crossing_at_0(uint _S399, float _S400, float _S401, bool _S402, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S403 = kernelContext_30->fabrics_0+_S399;
    thread Crossing_0 crossing_2;
    Cell_0 _S404 = locate_0(_S403->warp_0, _S400, kernelContext_30);
    (&crossing_2)->warp_1 = _S404;
    Cell_0 _S405 = locate_0(_S403->weft_0, _S401, kernelContext_30);
    (&crossing_2)->weft_1 = _S405;
    uint _S406 = _S403->run_words_0 + 2U * ((&(&crossing_2)->weft_1)->thread_1 * _S403->ends_1 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S407 = kernelContext_30->words_0[_S406];
    (&crossing_2)->warp_word_0 = _S407;
    (&crossing_2)->weft_word_0 = kernelContext_30->words_0[_S406 + 1U];
    (&crossing_2)->warp_above_0 = ((_S407 & 1U) == 1U) != _S402;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S408, float _S409, float _S410, bool _S411, KernelContext_0 thread* kernelContext_31)
{
    Fabric_0 device* _S412 = kernelContext_31->fabrics_0+_S408;
    thread Sample_0 sample_1;
    Crossing_0 _S413 = crossing_at_0(_S408, _S409, _S410, _S411, kernelContext_31);
    (&sample_1)->crossing_1 = _S413;
    thread Crossing_0 _S414 = _S413;
    Shown_0 _S415 = shown_at_0(&_S414, _S411);
    (&sample_1)->shown_3 = _S415;
    uint _S416;
    if(_S415.is_warp_0)
    {
        _S416 = _S412->warp_0;
    }
    else
    {
        _S416 = _S412->weft_0;
    }
    uint _S417;
    if(_S415.is_warp_0)
    {
        _S417 = _S412->weft_0;
    }
    else
    {
        _S417 = _S412->warp_0;
    }
    thread Cell_0 _S418 = (&(&sample_1)->crossing_1)->warp_1;
    thread Cell_0 _S419 = (&(&sample_1)->crossing_1)->weft_1;
    Cell_0 _S420 = select_cell_0(_S415.is_warp_0, &_S418, &_S419);
    thread Cell_0 _S421 = (&(&sample_1)->crossing_1)->weft_1;
    thread Cell_0 _S422 = (&(&sample_1)->crossing_1)->warp_1;
    Cell_0 _S423 = select_cell_0(_S415.is_warp_0, &_S421, &_S422);
    thread Cell_0 _S424 = _S423;
    Run_0 _S425 = unpack_0(_S416, _S417, _S420.thread_1, &_S424, _S415.word_0, kernelContext_31);
    thread Cell_0 _S426 = _S420;
    Section_0 _S427 = section_at_0(&_S426);
    bool _S428;
    if(_S415.on_top_0)
    {
        _S428 = (_S425.distance_1) < (_S427.drop_0 * _S425.bend_1.sine_0);
    }
    else
    {
        _S428 = false;
    }
    bool _S429;
    if(_S415.on_top_0)
    {
        _S429 = !_S428;
    }
    else
    {
        _S429 = false;
    }
    float _S430;
    if(_S429)
    {
        _S430 = 1.0f;
    }
    else
    {
        _S430 = -1.0f;
    }
    float _S431;
    if(_S428)
    {
        _S431 = _S425.other_reach_0;
    }
    else
    {
        _S431 = _S425.reach_0;
    }
    float _S432;
    if(_S428)
    {
        _S432 = _S431 + _S425.distance_1;
    }
    else
    {
        _S432 = max(_S431 - _S425.distance_1, 0.0f);
    }
    float _S433 = _S431 / _S425.bend_1.sine_0 - _S430 * _S427.drop_0;
    float _S434 = _S432 * _S432;
    float _S435 = max(_S433 * _S433 - _S434, 9.99999968265522539e-21f);
    float _S436 = rsqrt(_S435);
    float _S437 = _S434 / (_S435 * _S436 + _S433);
    bool _S438 = _S432 > 0.0f;
    float _S439;
    if(_S415.on_top_0)
    {
        _S439 = 1.0f;
    }
    else
    {
        _S439 = -1.0f;
    }
    float _S440;
    if(_S425.near_start_0)
    {
        _S440 = 1.0f;
    }
    else
    {
        _S440 = -1.0f;
    }
    float _S441 = _S439 * _S440;
    if(_S438)
    {
        _S439 = _S433 * _S436;
    }
    else
    {
        _S439 = 1.0f;
    }
    (&sample_1)->slope_across_0 = _S427.slope_0 * _S439;
    if(_S438)
    {
        _S432 = _S441 * _S432 * _S436;
    }
    else
    {
        _S432 = 0.0f;
    }
    (&sample_1)->slope_along_0 = _S432;
    Family_0 _S442 = kernelContext_31->families_0[_S416];
    thread Shown_0 _S443 = _S415;
    thread Run_0 _S444 = _S425;
    thread Cell_0 _S445 = _S423;
    float2 _S446 = dive_0(_S417, &_S443, &_S444, &_S445, kernelContext_31);
    if(_S425.straight_0)
    {
        _S430 = 0.0f;
    }
    else
    {
        _S430 = _S442.height_scale_0 * _S430;
    }
    (&sample_1)->height_4 = _S430 * (_S431 * _S425.bend_1.half_tangent_0 - _S437) - _S442.height_scale_0 * _S427.drop_0 - _S446.x;
    float _S447 = _S442.height_scale_0 * (&sample_1)->slope_across_0;
    float _S448 = _S442.height_scale_0 * (&sample_1)->slope_along_0 - _S446.y;
    if(_S415.is_warp_0)
    {
        _S430 = _S447;
    }
    else
    {
        _S430 = _S448;
    }
    (&sample_1)->slope_x_1 = _S430;
    if(_S415.is_warp_0)
    {
        _S430 = _S448;
    }
    else
    {
        _S430 = _S447;
    }
    (&sample_1)->slope_y_1 = _S430;
    (&sample_1)->run_3 = _S425;
    (&sample_1)->section_1 = _S427;
    return sample_1;
}

float steps_per_length_0(uint _S449, const SearchQuality_0 thread* _S450, float3 _S451, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S452 = kernelContext_32->fabrics_0+_S449;
    return max(max(abs(_S451.x) * _S452->threads_per_x_0, abs(_S451.y) * _S452->threads_per_y_0) * _S450->steps_per_thread_0, abs(_S451.z) * _S452->per_relief_0 * _S450->steps_per_relief_0);
}

float cell_maximum_0(uint _S453, const Crossing_0 thread* _S454, KernelContext_0 thread* kernelContext_33)
{
    Fabric_0 device* _S455 = kernelContext_33->fabrics_0+_S453;
    bool _S456 = _S454->warp_above_0;
    uint _S457;
    if(_S454->warp_above_0)
    {
        _S457 = _S455->warp_0;
    }
    else
    {
        _S457 = _S455->weft_0;
    }
    uint _S458;
    if(_S456)
    {
        _S458 = _S454->warp_word_0;
    }
    else
    {
        _S458 = _S454->weft_word_0;
    }
    return float(_S458 >> 28U) * kernelContext_33->families_0[_S457].height_scale_0 * kernelContext_33->families_0[_S457].level_0;
}

Probe_0 probe_0(uint _S459, float _S460, float _S461, bool _S462, bool _S463, bool _S464, KernelContext_0 thread* kernelContext_34)
{
    Sample_0 _S465 = sample_at_0(_S459, _S460, _S461, _S462, kernelContext_34);
    thread Probe_0 probe_1;
    (&probe_1)->height_1 = _S465.height_4;
    (&probe_1)->hole_1 = _S465.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S465.slope_x_1;
    (&probe_1)->slope_y_0 = _S465.slope_y_1;
    uint _S466;
    if(_S465.shown_3.is_warp_0)
    {
        _S466 = _S465.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S466 = _S465.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S466;
    thread Crossing_0 _S467 = _S465.crossing_1;
    float _S468 = cell_maximum_0(_S459, &_S467, kernelContext_34);
    (&probe_1)->cell_max_0 = _S468;
    float _S469;
    if(_S463)
    {
        _S469 = _S465.crossing_1.warp_1.above_0;
    }
    else
    {
        _S469 = _S465.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S469;
    if(_S464)
    {
        _S469 = _S465.crossing_1.weft_1.above_0;
    }
    else
    {
        _S469 = _S465.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S469;
    bool _S470 = !_S465.shown_3.is_warp_0;
    thread Cell_0 _S471 = _S465.crossing_1.warp_1;
    thread Shown_0 _S472 = _S465.shown_3;
    thread Run_0 _S473 = _S465.run_3;
    float _S474 = outline_distance_0(&_S471, &_S472, &_S473, _S470, _S463);
    (&probe_1)->edge_x_0 = _S474;
    thread Cell_0 _S475 = _S465.crossing_1.weft_1;
    thread Shown_0 _S476 = _S465.shown_3;
    thread Run_0 _S477 = _S465.run_3;
    float _S478 = outline_distance_0(&_S475, &_S476, &_S477, _S465.shown_3.is_warp_0, _S464);
    (&probe_1)->edge_y_0 = _S478;
    return probe_1;
}

bool is_free_0(uint _S479, const SearchQuality_0 thread* _S480, float3 _S481, float3 _S482, bool _S483, float _S484, KernelContext_0 thread* kernelContext_35)
{
    float _S485 = _S482.z;
    if(_S485 <= 0.0f)
    {
        return false;
    }
    float _S486 = _S480->shadow_share_0;
    float _S487 = steps_per_length_0(_S479, _S480, _S482, kernelContext_35);
    float _S488 = 1.0f / max(_S486 * _S487, 9.99999971718068537e-10f);
    StepControl_0 _S489 = step_control_0(_S482.xy, _S488);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_3 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S490;
        if(count_3 < 1024U)
        {
            _S490 = (_S481.z + _S485 * distance_3) < _S484;
        }
        else
        {
            _S490 = false;
        }
        if(_S490)
        {
        }
        else
        {
            break;
        }
        float3 _S491 = _S481 + _S482 * float3(distance_3) ;
        Probe_0 _S492 = probe_0(_S479, _S491.x, _S491.y, _S483, _S489.right_0, _S489.up_0, kernelContext_35);
        float _S493 = _S491.z;
        float _S494 = _S493 - _S492.height_1;
        float _S495 = _S485 - _S492.slope_x_0 * _S482.x - _S492.slope_y_0 * _S482.y;
        bool _S496;
        if(!_S492.hole_1)
        {
            _S496 = _S494 < 0.0f;
        }
        else
        {
            _S496 = false;
        }
        if(_S496)
        {
            return false;
        }
        thread PreviousSample_0 _S497 = previous_3;
        thread Probe_0 _S498 = _S492;
        float _S499 = way_back_to_dip_0(&_S497, _S494, _S495, last_step_0, &_S498);
        if(_S499 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S499;
            distance_3 = distance_3 - _S499;
            last_step_0 = last_step_1;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S500 = _S493 > (_S492.cell_max_0);
        thread Probe_0 _S501 = _S492;
        PreviousSample_0 _S502 = after_sample_0(_S494, _S495, &_S501, _S500);
        float last_step_2;
        if(_S500)
        {
            thread StepControl_0 _S503 = _S489;
            float _S504 = StepControl_to_cell_exit_0(&_S503, _S492.side_x_0, _S492.side_y_0);
            last_step_2 = max(_S504, _S488);
        }
        else
        {
            thread StepControl_0 _S505 = _S489;
            thread Probe_0 _S506 = _S492;
            float _S507 = StepControl_to_next_sample_0(&_S505, &_S506, _S494, _S495);
            last_step_2 = _S507;
        }
        float distance_4 = distance_3 + last_step_2;
        previous_3 = _S502;
        distance_3 = distance_4;
        last_step_0 = last_step_2;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S508, const SearchQuality_0 thread* _S509, float _S510, float _S511, float3 _S512, bool _S513, KernelContext_0 thread* kernelContext_36)
{
    Fabric_0 device* _S514 = kernelContext_36->fabrics_0+_S508;
    Sample_0 _S515 = sample_at_0(_S508, _S510, _S511, _S513, kernelContext_36);
    if(!_S515.shown_3.hole_0)
    {
        return false;
    }
    float3 _S516 = float3(_S510, _S511, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S517;
        if(side_0 < 2U)
        {
            _S517 = passes_0;
        }
        else
        {
            _S517 = false;
        }
        if(_S517)
        {
        }
        else
        {
            break;
        }
        float3 _S518;
        if(side_0 == 0U)
        {
            _S518 = _S512;
        }
        else
        {
            _S518 = float3(- _S512.x, - _S512.y, _S512.z);
        }
        bool _S519 = is_free_0(_S508, _S509, _S516, _S518, _S513 != (side_0 == 1U), _S514->height_high_0, kernelContext_36);
        uint _S520 = side_0 + 1U;
        passes_0 = _S519;
        side_0 = _S520;
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

float max_height_along_0(uint _S521, float _S522, float _S523, float _S524, float3 _S525, bool _S526, KernelContext_0 thread* kernelContext_37)
{
    Fabric_0 device* _S527 = kernelContext_37->fabrics_0+_S521;
    Cell_0 _S528 = locate_0(_S527->warp_0, _S522, kernelContext_37);
    uint _S529 = _S528.thread_1 / 2U;
    Cell_0 _S530 = locate_0(_S527->weft_0, _S523, kernelContext_37);
    uint _S531 = _S530.thread_1 / 2U;
    float _S532 = _S525.x;
    uint _S533;
    if(_S532 > 0.0f)
    {
        _S533 = 1U;
    }
    else
    {
        _S533 = 0U;
    }
    float _S534 = _S525.y;
    uint _S535;
    if(_S534 > 0.0f)
    {
        _S535 = 2U;
    }
    else
    {
        _S535 = 0U;
    }
    uint _S536 = kernelContext_37->words_0[_S527->max_heights_0 + 4U * (_S531 * _S527->max_height_columns_0 + _S529) + (_S533 + _S535)];
    int number_2;
    if(_S526)
    {
        number_2 = int(4);
    }
    else
    {
        number_2 = int(0);
    }
    uint _S537 = _S536 >> uint(number_2);
    float _S538 = max(abs(_S532) * _S527->threads_per_x_0, abs(_S534) * _S527->threads_per_y_0) / _S525.z;
    float _S539 = _S527->height_high_0;
    float max_height_0 = _S527->height_high_0;
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
        if(((max_height_0 - _S524) * _S538) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, float((_S537 >> uint(int(8) * number_2)) & 15U) * 0.06666667014360428f * _S539);
        }
        number_2 = number_2 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S540, float _S541, float _S542, bool _S543, bool _S544, bool _S545, KernelContext_0 thread* kernelContext_38)
{
    Crossing_0 _S546 = crossing_at_0(_S540, _S541, _S542, _S543, kernelContext_38);
    thread Crossing_0 _S547 = _S546;
    float _S548 = cell_maximum_0(_S540, &_S547, kernelContext_38);
    float _S549;
    if(_S544)
    {
        _S549 = _S546.warp_1.above_0;
    }
    else
    {
        _S549 = _S546.warp_1.below_0;
    }
    float _S550;
    if(_S545)
    {
        _S550 = _S546.weft_1.above_0;
    }
    else
    {
        _S550 = _S546.weft_1.below_0;
    }
    return float3(_S548, _S549, _S550);
}

float first_sample_height_0(uint _S551, const ViewRay_0 thread* _S552, const StepControl_0 thread* _S553, bool _S554, KernelContext_0 thread* kernelContext_39)
{
    float _S555 = max_height_along_0(_S551, _S552->origin_2.x, _S552->origin_2.y, 0.0f, float3(_S552->slope_1, 1.0f), _S554, kernelContext_39);
    uint count_4 = 0U;
    float height_6 = _S555;
    for(;;)
    {
        if(count_4 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S556 = ViewRay_at_0(_S552, height_6);
        float3 _S557 = cell_bounds_0(_S551, _S556.x, _S556.y, _S554, _S553->right_0, _S553->up_0, kernelContext_39);
        float _S558 = height_6 - _S557.x;
        float _S559 = StepControl_to_cell_exit_0(_S553, _S557.y, _S557.z);
        float height_7 = height_6 - clamp(_S558, 0.0f, _S559);
        if(_S558 <= _S559)
        {
            height_6 = height_7;
            break;
        }
        count_4 = count_4 + 1U;
        height_6 = height_7;
    }
    return height_6;
}

ViewRayEnd_0 search_down_0(uint _S560, const ViewRay_0 thread* _S561, const StepControl_0 thread* _S562, bool _S563, KernelContext_0 thread* kernelContext_40)
{
    Fabric_0 device* _S564 = kernelContext_40->fabrics_0+_S560;
    float _S565 = _S564->height_low_0 - (_S564->height_high_0 - _S564->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S566 = first_sample_height_0(_S560, _S561, _S562, _S563, kernelContext_40);
    (&end_1)->height_5 = _S566;
    (&end_1)->last_step_3 = _S562->epsilon_0;
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
        float2 _S567 = ViewRay_at_0(_S561, (&end_1)->height_5);
        Probe_0 _S568 = probe_0(_S560, _S567.x, _S567.y, _S563, _S562->right_0, _S562->up_0, kernelContext_40);
        float _S569 = (&end_1)->height_5 - _S568.height_1;
        thread Probe_0 _S570 = _S568;
        float _S571 = ViewRay_rate_0(_S561, &_S570);
        (&end_1)->depth_0 = - _S569;
        (&end_1)->rate_4 = _S571;
        bool _S572;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S572 = !_S568.hole_1;
        }
        else
        {
            _S572 = false;
        }
        bool _S573;
        if(_S572)
        {
            _S573 = ((&(&end_1)->previous_4)->yarn_0) == (_S568.yarn_1);
        }
        else
        {
            _S573 = false;
        }
        (&end_1)->smooth_0 = _S573;
        bool _S574;
        if(!_S568.hole_1)
        {
            _S574 = _S569 <= 0.0f;
        }
        else
        {
            _S574 = false;
        }
        bool _S575;
        if(_S574)
        {
            _S575 = true;
        }
        else
        {
            _S575 = ((&end_1)->height_5) <= _S565;
        }
        if(_S575)
        {
            break;
        }
        thread PreviousSample_0 _S576 = (&end_1)->previous_4;
        thread Probe_0 _S577 = _S568;
        float _S578 = way_back_to_dip_0(&_S576, _S569, _S571, (&end_1)->last_step_3, &_S577);
        if(_S578 >= 0.0f)
        {
            (&end_1)->height_5 = (&end_1)->height_5 + _S578;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S578;
            count_5 = count_5 + 1U;
            continue;
        }
        float _S579 = StepControl_to_cell_exit_0(_S562, _S568.side_x_0, _S568.side_y_0);
        float _S580 = min(_S579, (&end_1)->height_5 - _S568.cell_max_0);
        thread Probe_0 _S581 = _S568;
        float _S582 = StepControl_to_next_sample_0(_S562, &_S581, _S569, _S571);
        bool _S583 = _S580 > _S582;
        thread Probe_0 _S584 = _S568;
        PreviousSample_0 _S585 = after_sample_0(_S569, _S571, &_S584, _S583);
        (&end_1)->previous_4 = _S585;
        float _S586 = max(_S580, _S582);
        (&end_1)->last_step_3 = _S586;
        (&end_1)->height_5 = (&end_1)->height_5 - _S586;
        count_5 = count_5 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S587, const ViewRay_0 thread* _S588, const StepControl_0 thread* _S589, bool _S590, const ViewRayEnd_0 thread* _S591, uint _S592, KernelContext_0 thread* kernelContext_41)
{
    Fabric_0 device* _S593 = kernelContext_41->fabrics_0+_S587;
    float _S594 = _S593->height_high_0 - _S593->height_low_0;
    float _S595 = _S591->height_5;
    float _S596 = _S591->last_step_3;
    float above_2 = _S591->height_5 + _S591->last_step_3;
    float above_gap_1 = clamp((&_S591->previous_4)->clearance_0, 0.0f, _S594);
    float under_gap_1 = clamp(_S591->depth_0, 0.0f, _S594);
    float _S597 = cubic_root_0(above_gap_1, - under_gap_1, (&_S591->previous_4)->rate_0 * _S591->last_step_3, _S591->rate_4 * _S591->last_step_3);
    bool _S598 = _S591->smooth_0;
    float middle_0;
    if(_S591->smooth_0)
    {
        middle_0 = above_2 - _S597 * _S596;
    }
    else
    {
        middle_0 = between_0(above_2, _S595, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S595;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S592)
        {
        }
        else
        {
            break;
        }
        float2 _S599 = ViewRay_at_0(_S588, middle_0);
        Probe_0 _S600 = probe_0(_S587, _S599.x, _S599.y, _S590, _S589->right_0, _S589->up_0, kernelContext_41);
        float _S601;
        if(_S600.hole_1)
        {
            _S601 = -1.0e+09f;
        }
        else
        {
            _S601 = _S600.height_1;
        }
        float _S602 = clamp(middle_0 - _S601, - _S594, _S594);
        float _S603;
        if(_S602 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S603 = 0.5f * above_gap_2;
            }
            else
            {
                _S603 = above_gap_2;
            }
            float _S604 = - _S602;
            under_1 = middle_0;
            above_gap_2 = _S603;
            under_gap_2 = _S604;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S603 = 0.5f * under_gap_2;
            }
            else
            {
                _S603 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S602;
            under_gap_2 = _S603;
            side_1 = -1.0f;
        }
        if(_S598)
        {
            thread Probe_0 _S605 = _S600;
            float _S606 = ViewRay_rate_0(_S588, &_S605);
            middle_0 = clamp(middle_0 + _S602 / min(_S606, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S598)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_1 first_hit_of_yarn_0(uint _S607, const SearchQuality_0 thread* _S608, float _S609, float _S610, float3 _S611, bool _S612, KernelContext_0 thread* kernelContext_42)
{
    float _S613 = max(_S611.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_2 = float2(_S609, _S610);
    float2 _S614 = _S611.xy / float2(_S613) ;
    (&ray_0)->slope_1 = _S614;
    float2 _S615 = - _S614;
    float _S616 = steps_per_length_0(_S607, _S608, _S611, kernelContext_42);
    StepControl_0 _S617 = step_control_0(_S615, 1.0f / max(_S616 / _S613, 9.99999971718068537e-10f));
    thread ViewRay_0 _S618 = ray_0;
    thread StepControl_0 _S619 = _S617;
    ViewRayEnd_0 _S620 = search_down_0(_S607, &_S618, &_S619, _S612, kernelContext_42);
    thread Hit_1 hit_1;
    (&hit_1)->hole_2 = false;
    thread ViewRay_0 _S621 = ray_0;
    thread StepControl_0 _S622 = _S617;
    thread ViewRayEnd_0 _S623 = _S620;
    float _S624 = refined_height_0(_S607, &_S621, &_S622, _S612, &_S623, _S608->refinements_0, kernelContext_42);
    (&hit_1)->height_3 = _S624;
    thread ViewRay_0 _S625 = ray_0;
    float2 _S626 = ViewRay_at_0(&_S625, _S624);
    (&hit_1)->x_12 = _S626.x;
    (&hit_1)->y_7 = _S626.y;
    return hit_1;
}

Hit_1 first_hit_0(uint _S627, const SearchQuality_0 thread* _S628, float _S629, float _S630, float3 _S631, bool _S632, KernelContext_0 thread* kernelContext_43)
{
    bool _S633 = passes_through_0(_S627, _S628, _S629, _S630, _S631, _S632, kernelContext_43);
    if(!_S633)
    {
        Hit_1 _S634 = first_hit_of_yarn_0(_S627, _S628, _S629, _S630, _S631, _S632, kernelContext_43);
        return _S634;
    }
    thread Hit_1 hit_2;
    (&hit_2)->x_12 = _S629;
    (&hit_2)->y_7 = _S630;
    (&hit_2)->height_3 = 0.0f;
    (&hit_2)->hole_2 = true;
    return hit_2;
}

struct CoverageTaps_0
{
    array<uint, int(9)> nodes_1;
};

float3 pyramid_level_0(uint _S635, float _S636, KernelContext_0 thread* kernelContext_44)
{
    uint _S637 = (kernelContext_44->fabrics_0+_S635)->lobes_0.levels_0 + 4U * uint(min(_S636, (kernelContext_44->fabrics_0+_S635)->lobes_0.last_level_0));
    float _S638 = table_number_0(_S637, kernelContext_44);
    float _S639 = table_number_0(_S637 + 1U, kernelContext_44);
    float _S640 = table_number_0(_S637 + 2U, kernelContext_44);
    return float3(_S638, _S639, _S640);
}

CoverageTaps_0 coverage_taps_0(uint _S641, const Footprint_0 thread* _S642, bool _S643, KernelContext_0 thread* kernelContext_45)
{
    Fabric_0 device* _S644 = kernelContext_45->fabrics_0+_S641;
    float _S645 = Footprint_spread_side_0(_S642);
    Lobes_0 _S646 = _S644->lobes_0;
    float _S647 = _S645 * _S644->lobes_0.inverse_base_size_0;
    float3 _S648 = pyramid_level_0(_S641, floor(binary_logarithm_0(max(0.68000000715255737f * _S647, 1.0f))), kernelContext_45);
    float _S649 = 1.0f / max(_S647, 9.99999997475242708e-07f);
    float2 _S650 = float2(kernelContext_45->families_0[_S644->warp_0].inverse_period_0, kernelContext_45->families_0[_S644->weft_0].inverse_period_0);
    float2 _S651 = _S642->centre_0 * _S650;
    float2 _S652 = float2(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S649 * _S649), 0.0f, 1.0f)), 0.3333333432674408f * _S649), 1.0f)) ;
    float2 _S653 = _S642->dx_0 * _S650 * _S652;
    float2 _S654 = _S642->dy_0 * _S650 * _S652;
    thread CoverageTaps_0 taps_3;
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
        float2 _S655 = _S651 + float2(TAP_OFFSETS_0[number_3].x)  * _S653 + float2(TAP_OFFSETS_0[number_3].y)  * _S654;
        float _S656 = _S648.y;
        float _S657 = wrapped_cell_0(_S655.x, _S656);
        float _S658 = wrapped_cell_0(_S655.y, _S648.z);
        uint _S659;
        if(_S643)
        {
            _S659 = _S646.face_nodes_0;
        }
        else
        {
            _S659 = 0U;
        }
        (&taps_3)->nodes_1[number_3] = _S659 + uint(_S658 * _S656 + _S657 + _S648.x);
        number_3 = number_3 + 1U;
    }
    return taps_3;
}

float coverage_of_holes_0(uint _S660, const CoverageTaps_0 thread* _S661, KernelContext_0 thread* kernelContext_46)
{
    Fabric_0 device* _S662 = kernelContext_46->fabrics_0+_S660;
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
        uint total_1 = total_0 + ((kernelContext_46->words_0[_S662->lobes_0.coverage_holes_0 + _S661->nodes_1[number_4] / 4U] >> (8U * (_S661->nodes_1[number_4] % 4U))) & 255U);
        number_4 = number_4 + 1U;
        total_0 = total_1;
    }
    return float(total_0) / 9.0f;
}

float prefiltered_hole_0(uint _S663, const CoverageTaps_0 thread* _S664, const NodeTaps_0 thread* _S665, bool _S666, KernelContext_0 thread* kernelContext_47)
{
    Lobes_0 _S667 = (kernelContext_47->fabrics_0+_S663)->lobes_0;
    float4 _S668 = interpolate_table_0(_S665, (kernelContext_47->fabrics_0+_S663)->lobes_0.projected_area_0 + (kernelContext_47->fabrics_0+_S663)->lobes_0.packs_0, (kernelContext_47->fabrics_0+_S663)->lobes_0.packs_0 + 1U, kernelContext_47);
    float _S669 = _S668.x;
    float _S670;
    if(_S666)
    {
        _S670 = _S667.back_hole_weight_0;
    }
    else
    {
        _S670 = _S667.front_hole_weight_0;
    }
    float _S671 = coverage_of_holes_0(_S663, _S664, kernelContext_47);
    return min(_S671 * _S669 * _S669 * _S670, 1.0f);
}

float passed_share_0(uint _S672, const VisiblePoint_0 thread* _S673, float3 _S674, float _S675, float2 _S676, KernelContext_0 thread* kernelContext_48)
{
    Fabric_0 device* _S677 = kernelContext_48->fabrics_0+_S672;
    float3 _S678 = to_local_0(_S673, _S674);
    bool _S679 = (_S678.z) < 0.0f;
    float3 _S680 = to_face_frame_0(_S678, _S679);
    thread Footprint_0 footprint_0;
    (&footprint_0)->centre_0 = _S673->draft_0;
    (&footprint_0)->dx_0 = float2(_S675, 0.0f);
    (&footprint_0)->dy_0 = float2(0.0f, _S675);
    float _S681;
    if((_S677->lobes_0.is_baked_0) != 0U)
    {
        thread Footprint_0 _S682 = footprint_0;
        Regime_0 _S683 = regime_of_0(_S672, &_S682, 1.0f, kernelContext_48);
        _S681 = _S683.prefiltered_0;
    }
    else
    {
        _S681 = 0.0f;
    }
    float share_2;
    if(_S681 < 1.0f)
    {
        float2 _S684 = (&footprint_0)->centre_0 + (_S676 - float2(0.5f) ) * float2(_S675) ;
        float _S685 = _S684.x;
        float _S686 = _S684.y;
        thread SearchQuality_0 _S687 = default_quality_0();
        Hit_1 _S688 = first_hit_0(_S672, &_S687, _S685, _S686, _S680, _S679, kernelContext_48);
        if(_S688.hole_2)
        {
            share_2 = 1.0f - _S681;
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
    if(_S681 > 0.0f)
    {
        thread NodeTaps_0 nodes_2 = node_taps_0(_S680);
        uint _S689;
        if(_S679)
        {
            _S689 = 1U;
        }
        else
        {
            _S689 = 0U;
        }
        (&nodes_2)->nodes_0 = (&nodes_2)->nodes_0 + uint4((_S689 * 256U)) ;
        thread Footprint_0 _S690 = footprint_0;
        CoverageTaps_0 _S691 = coverage_taps_0(_S672, &_S690, _S679, kernelContext_48);
        thread CoverageTaps_0 _S692 = _S691;
        thread NodeTaps_0 _S693 = nodes_2;
        float _S694 = prefiltered_hole_0(_S672, &_S692, &_S693, _S679, kernelContext_48);
        share_2 = share_2 + _S681 * _S694;
    }
    float _S695 = _S677->sheen_strength_0;
    if((_S677->sheen_strength_0) > 0.0f)
    {
        share_2 = share_2 * (1.0f - _S695 * sheen_lobe_0(_S680.z, _S677->sheen_roughness_0).z);
    }
    return share_2;
}

float visibility_of_0(int _S696, const VisiblePoint_0 thread* _S697, uint _S698, uint2 _S699, uint _S700, KernelContext_0 thread* kernelContext_49)
{
    Frame_0 device* _S701 = kernelContext_49->frames_0+_S696;
    LightSample_0 _S702 = light_sample_0(_S696, _S700, _S699, _S697->position_0, kernelContext_49);
    float3 _S703 = _S697->face_normal_0;
    float nearest_1;
    if((dot(_S702.towards_0, _S697->face_normal_0)) < 0.0f)
    {
        nearest_1 = -1.0f;
    }
    else
    {
        nearest_1 = 1.0f;
    }
    float3 _S704 = seen_position_0(_S696, _S698, _S699, kernelContext_49);
    float3 _S705 = _S704 + float3((nearest_1 * _S701->ray_offset_0))  * _S703;
    float _S706 = sqrt(0.5f * (dot(_S697->draft_dx_0, _S697->draft_dx_0) + dot(_S697->draft_dy_0, _S697->draft_dy_0)));
    nearest_1 = 0.0f;
    uint without_0 = _S698;
    uint layer_0 = 0U;
    float visibility_0 = 1.0f;
    for(;;)
    {
        bool _S707;
        if(layer_0 < 8U)
        {
            _S707 = visibility_0 > 0.00100000004749745f;
        }
        else
        {
            _S707 = false;
        }
        if(_S707)
        {
        }
        else
        {
            break;
        }
        Hit_0 _S708 = nearest_hit_0(_S696, _S705, _S702.towards_0, nearest_1, _S702.distance_2, without_0, true, kernelContext_49);
        if((_S708.face_1) == 4294967295U)
        {
            break;
        }
        uint _S709 = kernelContext_49->face_fabrics_0[_S708.face_1];
        VisiblePoint_0 _S710 = face_point_0(_S709, _S708.face_1, _S708.weight_b_0, _S708.weight_c_0, kernelContext_49);
        float2 _S711 = pixel_sequence_0(_S699, _S701->pass_number_0, 5U + 2U * (8U * _S700 + layer_0));
        float _S712;
        if(((kernelContext_49->fabrics_0+_S709)->is_open_0) != 0U)
        {
            float3 _S713 = - _S702.towards_0;
            thread VisiblePoint_0 _S714 = _S710;
            float _S715 = passed_share_0(_S709, &_S714, _S713, _S706, _S711, kernelContext_49);
            _S712 = _S715;
        }
        else
        {
            _S712 = 0.0f;
        }
        float visibility_1 = visibility_0 * _S712;
        uint _S716 = layer_0 + 1U;
        nearest_1 = _S708.distance_0;
        without_0 = _S708.face_1;
        layer_0 = _S716;
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

[[kernel]] void cast_shadows(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], Layer_0 device* layers_1 [[buffer(12)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], float device* visibilities_1 [[buffer(13)]], uint device* scene_words_1 [[buffer(11)]], Light_0 device* lights_2 [[buffer(3)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]])
{
    thread KernelContext_0 kernelContext_50;
    (&kernelContext_50)->frames_0 = frames_1;
    (&kernelContext_50)->layers_0 = layers_1;
    (&kernelContext_50)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_50)->fabrics_0 = fabrics_1;
    (&kernelContext_50)->corners_0 = corners_1;
    (&kernelContext_50)->vertices_0 = vertices_1;
    (&kernelContext_50)->visibilities_0 = visibilities_1;
    (&kernelContext_50)->scene_words_0 = scene_words_1;
    (&kernelContext_50)->lights_1 = lights_2;
    (&kernelContext_50)->families_0 = families_1;
    (&kernelContext_50)->words_0 = words_1;
    Frame_0 device* _S717 = frames_1+int(0);
    uint _S718 = id_0.x;
    uint _S719 = _S717->width_0;
    bool _S720;
    if(_S718 >= (_S717->width_0))
    {
        _S720 = true;
    }
    else
    {
        _S720 = (id_0.y) >= (_S717->height_0);
    }
    if(_S720)
    {
        return;
    }
    uint _S721 = id_0.y * _S719 + _S718;
    uint _S722 = ((&kernelContext_50)->layers_0+_S721)->face_0;
    if((((&kernelContext_50)->layers_0+_S721)->face_0) == 0U)
    {
        return;
    }
    uint _S723 = _S722 - 1U;
    uint2 _S724 = id_0.xy;
    VisiblePoint_0 _S725 = visible_point_0(int(0), (&kernelContext_50)->face_fabrics_0[_S723], _S723, _S724, &kernelContext_50);
    uint number_5 = 0U;
    for(;;)
    {
        uint _S726 = light_sample_count_0(int(0), &kernelContext_50);
        if(number_5 < _S726)
        {
        }
        else
        {
            break;
        }
        float device* _S727 = (&kernelContext_50)->visibilities_0+(number_5 * _S719 * _S717->height_0 + _S721);
        thread VisiblePoint_0 _S728 = _S725;
        float _S729 = visibility_of_0(int(0), &_S728, _S723, _S724, number_5, &kernelContext_50);
        *_S727 = _S729;
        number_5 = number_5 + 1U;
    }
    return;
}

