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

uint scramble_0(uint value_0)
{
    uint _S1 = value_0 * 747796405U + 2891336453U;
    uint _S2 = ((_S1 >> ((_S1 >> 28U) + 4U)) ^ _S1) * 277803737U;
    return (_S2 >> 22U) ^ _S2;
}

float uniform_hash_0(uint thread_0, uint cell_0, uint stream_0)
{
    return (float((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> 9U) + 0.5f) * 1.1920928955078125e-07f;
}

float2 footprint_sample_0(uint2 pixel_0, uint index_0)
{
    uint _S3 = pixel_0.x;
    uint _S4 = pixel_0.y;
    return fract(float2(uniform_hash_0(_S3, _S4, 1U), uniform_hash_0(_S3, _S4, 2U)) + float2(float(index_0 & 65535U))  * float2(0.75487768650054932f, 0.56984031200408936f)) - float2(0.5f) ;
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
    float2 draft_0;
    float2 draft_dx_0;
    float2 draft_dy_0;
};

float3 to_local_0(const VisiblePoint_0 thread* point_0, float3 direction_0)
{
    return float3(dot(direction_0, point_0->axis_x_0), dot(direction_0, point_0->axis_y_0), dot(direction_0, point_0->normal_0));
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

struct KernelContext_0
{
    Frame_0 device* frames_0;
    texture2d<uint, access::sample> visible_faces_0;
    uint device* face_fabrics_0;
    Fabric_0 device* fabrics_0;
    uint device* corners_0;
    Vertex_0 device* vertices_0;
    Family_0 device* families_0;
    uint device* words_0;
    Light_0 device* lights_1;
    packed_float4 device* radiance_0;
};

float2 turns_and_remainder_0(uint family_0, float index_1, KernelContext_0 thread* kernelContext_0)
{
    float _S7 = floor(fma(index_1, kernelContext_0->families_0[family_0].inverse_count_0, kernelContext_0->families_0[family_0].half_inverse_count_0));
    return float2(_S7, fma(- _S7, kernelContext_0->families_0[family_0].count_0, index_1));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(uint family_1, float position_1, KernelContext_0 thread* kernelContext_1)
{
    float _S8 = floor(position_1 * kernelContext_1->families_0[family_1].inverse_size_0);
    thread Cell_0 cell_1;
    float _S9 = fma(- _S8, kernelContext_1->families_0[family_1].size_0, position_1);
    (&cell_1)->below_0 = _S9;
    (&cell_1)->above_0 = kernelContext_1->families_0[family_1].size_0 - _S9;
    (&cell_1)->across_0 = _S9 - 0.5f * kernelContext_1->families_0[family_1].size_0;
    (&cell_1)->half_width_1 = kernelContext_1->families_0[family_1].half_width_0;
    float2 _S10 = turns_and_remainder_0(family_1, _S8, kernelContext_1);
    (&cell_1)->thread_1 = uint(clamp(_S10.y, 0.0f, kernelContext_1->families_0[family_1].count_0 - 1.0f));
    return cell_1;
}

float table_number_0(uint index_2, KernelContext_0 thread* kernelContext_2)
{
    return (as_type<float>((kernelContext_2->words_0[index_2])));
}

float table_number_1(uint index_3, KernelContext_0 thread* kernelContext_3)
{
    return (as_type<float>((kernelContext_3->words_0[index_3])));
}

Cell_0 locate_varied_0(uint family_2, float position_2, KernelContext_0 thread* kernelContext_4)
{
    float turns_0 = (position_2 - kernelContext_4->families_0[family_2].start_0) * kernelContext_4->families_0[family_2].inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S11 = turns_1 * kernelContext_4->families_0[family_2].period_0;
    uint thread_2 = kernelContext_4->words_0[kernelContext_4->families_0[family_2].first_thread_table_0 + uint(clamp(turns_1 * kernelContext_4->families_0[family_2].bins_0, 0.0f, kernelContext_4->families_0[family_2].bins_0 - 1.0f))];
    float _S12 = table_number_0(kernelContext_4->families_0[family_2].place_table_0 + thread_2 * 4U + 1U, kernelContext_4);
    uint _S13;
    if(_S11 >= _S12)
    {
        _S13 = 1U;
    }
    else
    {
        _S13 = 0U;
    }
    uint _S14 = min(thread_2 + _S13, uint(kernelContext_4->families_0[family_2].count_0) - 1U);
    uint _S15 = kernelContext_4->families_0[family_2].place_table_0 + _S14 * 4U;
    thread Cell_0 cell_2;
    (&cell_2)->thread_1 = _S14;
    float _S16 = table_number_0(_S15, kernelContext_4);
    (&cell_2)->below_0 = _S11 - _S16;
    float _S17 = table_number_0(_S15 + 1U, kernelContext_4);
    (&cell_2)->above_0 = _S17 - _S11;
    float _S18 = table_number_0(_S15 + 2U, kernelContext_4);
    (&cell_2)->across_0 = _S11 - _S18;
    float _S19 = table_number_0(_S15 + 3U, kernelContext_4);
    (&cell_2)->half_width_1 = _S19;
    return cell_2;
}

Cell_0 locate_0(uint family_3, float position_3, KernelContext_0 thread* kernelContext_5)
{
    if((kernelContext_5->families_0[family_3].is_alike_0) != 0U)
    {
        Cell_0 _S20 = locate_alike_0(family_3, position_3, kernelContext_5);
        return _S20;
    }
    Cell_0 _S21 = locate_varied_0(family_3, position_3, kernelContext_5);
    return _S21;
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

Shown_0 shown_at_0(const Crossing_0 thread* crossing_0, bool back_1)
{
    bool _S22 = (abs((&crossing_0->warp_1)->across_0)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S23 = (abs((&crossing_0->weft_1)->across_0)) < ((&crossing_0->weft_1)->half_width_1);
    thread Shown_0 shown_0;
    bool _S24;
    if(_S22)
    {
        if(!_S23)
        {
            _S24 = true;
        }
        else
        {
            _S24 = crossing_0->warp_above_0;
        }
    }
    else
    {
        _S24 = false;
    }
    (&shown_0)->is_warp_0 = _S24;
    if(!_S22)
    {
        _S24 = !_S23;
    }
    else
    {
        _S24 = false;
    }
    (&shown_0)->hole_0 = _S24;
    uint _S25;
    if((&shown_0)->is_warp_0)
    {
        _S25 = crossing_0->warp_word_0;
    }
    else
    {
        _S25 = crossing_0->weft_word_0;
    }
    (&shown_0)->word_0 = _S25;
    (&shown_0)->on_top_0 = ((_S25 & 1U) == 1U) != back_1;
    return shown_0;
}

Cell_0 select_cell_0(bool is_first_0, const Cell_0 thread* first_0, const Cell_0 thread* second_0)
{
    thread Cell_0 cell_3;
    uint _S26;
    if(is_first_0)
    {
        _S26 = first_0->thread_1;
    }
    else
    {
        _S26 = second_0->thread_1;
    }
    (&cell_3)->thread_1 = _S26;
    float _S27;
    if(is_first_0)
    {
        _S27 = first_0->across_0;
    }
    else
    {
        _S27 = second_0->across_0;
    }
    (&cell_3)->across_0 = _S27;
    if(is_first_0)
    {
        _S27 = first_0->half_width_1;
    }
    else
    {
        _S27 = second_0->half_width_1;
    }
    (&cell_3)->half_width_1 = _S27;
    if(is_first_0)
    {
        _S27 = first_0->below_0;
    }
    else
    {
        _S27 = second_0->below_0;
    }
    (&cell_3)->below_0 = _S27;
    if(is_first_0)
    {
        _S27 = first_0->above_0;
    }
    else
    {
        _S27 = second_0->above_0;
    }
    (&cell_3)->above_0 = _S27;
    return cell_3;
}

float boundary_0(uint family_4, uint thread_3, int step_0, KernelContext_0 thread* kernelContext_6)
{
    float2 _S28 = turns_and_remainder_0(family_4, float(int(thread_3) + step_0), kernelContext_6);
    float _S29 = _S28.x;
    Family_0 _S30 = kernelContext_6->families_0[family_4];
    float _S31 = table_number_0(kernelContext_6->families_0[family_4].place_table_0 + uint(_S28.y) * 4U, kernelContext_6);
    return fma(_S29, _S30.period_0, _S31);
}

float span_0(uint family_5, uint thread_4, int first_1, int last_0, KernelContext_0 thread* kernelContext_7)
{
    if((kernelContext_7->families_0[family_5].is_alike_0) != 0U)
    {
        return float(last_0 - first_1) * kernelContext_7->families_0[family_5].size_0;
    }
    float _S32 = boundary_0(family_5, thread_4, last_0, kernelContext_7);
    float _S33 = boundary_0(family_5, thread_4, first_1, kernelContext_7);
    return _S32 - _S33;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(uint family_6, uint thread_5, KernelContext_0 thread* kernelContext_8)
{
    Family_0 _S34 = kernelContext_8->families_0[family_6];
    uint _S35;
    if((kernelContext_8->families_0[family_6].is_alike_0) != 0U)
    {
        _S35 = 0U;
    }
    else
    {
        _S35 = thread_5 * 4U;
    }
    uint _S36 = _S34.bend_table_0 + _S35;
    thread Bend_0 bend_0;
    float _S37 = table_number_0(_S36, kernelContext_8);
    (&bend_0)->sine_0 = _S37;
    float _S38 = table_number_0(_S36 + 1U, kernelContext_8);
    (&bend_0)->half_tangent_0 = _S38;
    float _S39 = table_number_0(_S36 + 2U, kernelContext_8);
    (&bend_0)->arc_0 = _S39;
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

Run_0 unpack_0(uint own_0, uint other_0, uint thread_6, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_9)
{
    int _S40 = int((word_1 >> 1U) & 127U);
    int _S41 = int((word_1 >> 8U) & 127U);
    int _S42 = int((word_1 >> 15U) & 63U);
    int _S43 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S44 = crossed_0->below_0;
    uint _S45 = crossed_0->thread_1;
    int _S46 = - _S40;
    float _S47 = span_0(other_0, crossed_0->thread_1, _S46, int(0), kernelContext_9);
    float _S48 = _S44 + _S47;
    (&run_0)->from_start_0 = _S48;
    float _S49 = crossed_0->above_0;
    int _S50 = _S41 + int(1);
    float _S51 = span_0(other_0, _S45, int(1), _S50, kernelContext_9);
    float _S52 = _S49 + _S51;
    (&run_0)->to_end_0 = _S52;
    bool _S53 = _S48 < _S52;
    (&run_0)->near_start_0 = _S53;
    int _S54;
    if(_S53)
    {
        _S54 = _S46 - _S42;
    }
    else
    {
        _S54 = _S50;
    }
    int _S55;
    if((&run_0)->near_start_0)
    {
        _S55 = _S46;
    }
    else
    {
        _S55 = _S50 + _S43;
    }
    Bend_0 _S56 = bend_of_0(own_0, thread_6, kernelContext_9);
    (&run_0)->bend_1 = _S56;
    float _S57;
    if((&run_0)->straight_0)
    {
        _S57 = 1.0e+06f;
    }
    else
    {
        _S57 = min((&run_0)->from_start_0, (&run_0)->to_end_0);
    }
    (&run_0)->distance_0 = _S57;
    (&run_0)->reach_0 = min(0.5f * ((&run_0)->from_start_0 + (&run_0)->to_end_0), (&(&run_0)->bend_1)->arc_0);
    float _S58 = span_0(other_0, _S45, _S54, _S55, kernelContext_9);
    (&run_0)->other_reach_0 = min(0.5f * _S58, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S40 == int(0);
    (&run_0)->last_crossing_0 = _S41 == int(0);
    return run_0;
}

float square_1(float x_2)
{
    return x_2 * x_2;
}

struct Section_0
{
    float across_1;
    float drop_0;
    float slope_0;
};

Section_0 section_at_0(const Cell_0 thread* cell_4)
{
    float _S59 = cell_4->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S60 = clamp(cell_4->across_0, - cell_4->half_width_1, cell_4->half_width_1);
    (&section_0)->across_1 = _S60;
    float _S61 = _S59 * _S59 - square_1(_S60);
    float _S62 = rsqrt(_S61);
    (&section_0)->drop_0 = _S59 - _S61 * _S62;
    (&section_0)->slope_0 = - _S60 * _S62;
    return section_0;
}

float edge_drop_0(uint family_7, uint thread_7, int step_1, KernelContext_0 thread* kernelContext_10)
{
    if((kernelContext_10->families_0[family_7].is_alike_0) != 0U)
    {
        float _S63 = table_number_0(kernelContext_10->families_0[family_7].bend_table_0 + 3U, kernelContext_10);
        return _S63;
    }
    Family_0 _S64 = kernelContext_10->families_0[family_7];
    float2 _S65 = turns_and_remainder_0(family_7, float(int(thread_7) + step_1), kernelContext_10);
    float _S66 = table_number_0(_S64.bend_table_0 + uint(_S65.y) * 4U + 3U, kernelContext_10);
    return _S66;
}

float2 dive_0(uint other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_11)
{
    float _S67 = crossed_1->below_0;
    float _S68 = crossed_1->above_0;
    bool _S69 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S70 = min(crossed_1->below_0, crossed_1->above_0);
    float _S71;
    if(_S69)
    {
        _S71 = _S67 - crossed_1->across_0;
    }
    else
    {
        _S71 = _S68 + crossed_1->across_0;
    }
    float _S72 = _S71 - crossed_1->half_width_1;
    bool _S73;
    if(_S69)
    {
        _S73 = run_1->first_crossing_0;
    }
    else
    {
        _S73 = run_1->last_crossing_0;
    }
    bool _S74 = shown_1->on_top_0;
    if(shown_1->on_top_0)
    {
        _S71 = 0.0f;
    }
    else
    {
        Family_0 _S75 = kernelContext_11->families_0[other_1];
        float _S76 = edge_drop_0(other_1, crossed_1->thread_1, int(0), kernelContext_11);
        _S71 = _S75.height_scale_0 * _S76;
    }
    float _S77;
    if(_S74 != _S73)
    {
        _S77 = 0.0f;
    }
    else
    {
        Family_0 _S78 = kernelContext_11->families_0[other_1];
        uint _S79 = crossed_1->thread_1;
        int _S80;
        if(_S69)
        {
            _S80 = int(-1);
        }
        else
        {
            _S80 = int(1);
        }
        float _S81 = edge_drop_0(other_1, _S79, _S80, kernelContext_11);
        _S77 = _S78.height_scale_0 * _S81;
    }
    float _S82 = 1.0f / max(2.0f * _S72, 9.999999960041972e-13f);
    float _S83 = clamp((_S72 - _S70) * _S82, 0.0f, 1.0f);
    float _S84 = _S71 + (_S77 - _S71) * (_S83 * _S83 * (3.0f - 2.0f * _S83));
    float _S85 = (_S71 - _S77) * (6.0f * _S83 * (1.0f - _S83) * _S82);
    if(_S69)
    {
        _S71 = 1.0f;
    }
    else
    {
        _S71 = -1.0f;
    }
    return float2(_S84, _S85 * _S71);
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
    float _S86 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S86), 9.99999971718068537e-10f);
    float _S87 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S87), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S86 > 0.0f;
    (&control_0)->up_0 = _S87 > 0.0f;
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
    float _S88;
    if(forwards_0)
    {
        _S88 = cell_5->across_0;
    }
    else
    {
        _S88 = - cell_5->across_0;
    }
    float _S89;
    if(forwards_0)
    {
        _S89 = cell_5->above_0;
    }
    else
    {
        _S89 = cell_5->below_0;
    }
    bool _S90;
    if(forwards_0)
    {
        _S90 = run_2->last_crossing_0;
    }
    else
    {
        _S90 = run_2->first_crossing_0;
    }
    bool _S91;
    if(forwards_0)
    {
        _S91 = run_2->first_crossing_0;
    }
    else
    {
        _S91 = run_2->last_crossing_0;
    }
    float _S92 = cell_5->half_width_1;
    float _S93 = - cell_5->half_width_1;
    bool _S94 = _S88 < _S93;
    bool _S95 = _S88 >= (cell_5->half_width_1);
    if(lengthwise_0)
    {
        _S90 = !_S90;
    }
    else
    {
        _S90 = false;
    }
    if(_S90)
    {
        _S90 = !shown_2->hole_0;
    }
    else
    {
        _S90 = false;
    }
    bool _S96;
    if(_S90)
    {
        _S96 = shown_2->on_top_0;
    }
    else
    {
        _S96 = false;
    }
    if(_S96)
    {
        if(_S91)
        {
            _S91 = _S94;
        }
        else
        {
            _S91 = false;
        }
        _S91 = !_S91;
    }
    else
    {
        _S91 = false;
    }
    if(shown_2->hole_0)
    {
        _S90 = true;
    }
    else
    {
        if(_S90)
        {
            _S90 = !shown_2->on_top_0;
        }
        else
        {
            _S90 = false;
        }
    }
    float _S97;
    if(_S94)
    {
        _S97 = _S93;
    }
    else
    {
        _S97 = _S92;
    }
    float _S98 = _S97 - _S88;
    if(_S90)
    {
        _S88 = 2.0f * _S89 + _S88 - _S92;
    }
    else
    {
        _S88 = _S89;
    }
    if(_S91)
    {
        if(forwards_0)
        {
            _S88 = run_2->to_end_0;
        }
        else
        {
            _S88 = run_2->from_start_0;
        }
        return _S88;
    }
    if(_S95)
    {
    }
    else
    {
        _S88 = _S98;
    }
    return _S88;
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
    float _S99 = previous_1->rate_0;
    float _S100 = previous_1->rate_0 * step_4;
    float _S101 = rate_1 * step_4;
    bool _S102;
    if(!previous_1->known_0)
    {
        _S102 = true;
    }
    else
    {
        _S102 = here_0->hole_1;
    }
    if(_S102)
    {
        _S102 = true;
    }
    else
    {
        _S102 = (previous_1->yarn_0) != (here_0->yarn_1);
    }
    if(_S102)
    {
        _S102 = true;
    }
    else
    {
        _S102 = _S99 >= 0.0f;
    }
    if(_S102)
    {
        _S102 = true;
    }
    else
    {
        _S102 = rate_1 <= 0.0f;
    }
    if(_S102)
    {
        return -1.0f;
    }
    float _S103 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S100) >= 0.0f)
    {
        _S102 = (3.0f * clearance_1 - _S101) >= 0.0f;
    }
    else
    {
        _S102 = false;
    }
    if(_S102)
    {
        return -1.0f;
    }
    float _S104 = clearance_1 - _S103;
    float _S105 = 6.0f * _S104 - 4.0f * _S100 - 2.0f * _S101;
    float _S106 = -2.0f * _S100 / max(_S105 + sqrt(max(_S105 * _S105 - 4.0f * (3.0f * (_S100 + _S101 - 2.0f * _S104)) * _S100, 0.0f)), 9.99999968265522539e-21f);
    float _S107 = 1.0f - _S106;
    float _S108 = (_S103 * (2.0f * _S106 + 1.0f) + _S100 * _S106) * _S107 * _S107;
    float _S109 = (clearance_1 * (2.0f * _S107 + 1.0f) - _S101 * _S107) * _S106 * _S106;
    if(_S106 > 0.01999999955296516f)
    {
        _S102 = _S107 > 0.01999999955296516f;
    }
    else
    {
        _S102 = false;
    }
    if(_S102)
    {
        _S102 = (_S108 + _S109) < 0.0f;
    }
    else
    {
        _S102 = false;
    }
    float _S110;
    if(_S102)
    {
        _S110 = _S107 * step_4;
    }
    else
    {
        _S110 = -1.0f;
    }
    return _S110;
}

PreviousSample_0 after_sample_0(float clearance_2, float rate_2, const Probe_0 thread* here_1, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S111 = here_1->hole_1;
    float _S112;
    if(here_1->hole_1)
    {
        _S112 = 1.0e+09f;
    }
    else
    {
        _S112 = clearance_2;
    }
    (&previous_2)->clearance_0 = _S112;
    (&previous_2)->rate_0 = rate_2;
    (&previous_2)->yarn_0 = here_1->yarn_1;
    bool _S113;
    if(!_S111)
    {
        _S113 = !is_cell_exit_0;
    }
    else
    {
        _S113 = false;
    }
    (&previous_2)->known_0 = _S113;
    return previous_2;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_0, float side_x_1, float side_y_1)
{
    return max(min(side_x_1 * this_0->per_x_0, side_y_1 * this_0->per_y_0), 0.0f) + this_0->epsilon_0;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_1, const Probe_0 thread* here_2, float clearance_3, float rate_3)
{
    float _S114 = min(here_2->edge_x_0 * this_1->per_x_0, here_2->edge_y_0 * this_1->per_y_0);
    bool _S115;
    if(!here_2->hole_1)
    {
        _S115 = (rate_3 * _S114 + clearance_3) < 0.0f;
    }
    else
    {
        _S115 = false;
    }
    if(_S115)
    {
        _S115 = _S114 > (2.0f * this_1->epsilon_0);
    }
    else
    {
        _S115 = false;
    }
    float _S116 = this_1->step_2;
    float _S117;
    if(_S115)
    {
        _S117 = _S114 - this_1->epsilon_0;
    }
    else
    {
        _S117 = max(_S114, 0.0f) + this_1->epsilon_0;
    }
    return min(_S116, _S117);
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
    float _S118 = end_0 - start_1;
    float _S119 = start_rate_0 + end_rate_0 - 2.0f * _S118;
    float _S120 = 3.0f * _S118 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S118, 9.99999968265522539e-21f);
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
        float _S121 = clamp(share_0 - (((_S119 * share_0 + _S120) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S119 * share_0 + 2.0f * _S120) * share_0 + start_rate_0, 0.10000000149011612f * _S118 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S122 = i_0 + int(1);
        share_0 = _S121;
        i_0 = _S122;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S123 = along_slope_0 * along_slope_0 + 1.0f;
    float _S124 = rsqrt(_S123);
    float _S125 = sine_1 * _S124 * rsqrt(_S123 + across_slope_0 * across_slope_0);
    return float2(- _S125 * _S123, _S125 * across_slope_0 * along_slope_0 + cosine_0 * _S124);
}

float arc_sine_0(float x_3)
{
    float _S126 = abs(x_3);
    bool _S127 = _S126 > 0.5f;
    float _S128;
    if(_S127)
    {
        _S128 = 0.5f * (1.0f - _S126);
    }
    else
    {
        _S128 = _S126 * _S126;
    }
    float _S129;
    if(_S127)
    {
        _S129 = sqrt(max(_S128, 0.0f));
    }
    else
    {
        _S129 = _S126;
    }
    float _S130 = ((((0.04216320067644119f * _S128 + 0.02418131195008755f) * _S128 + 0.04547002539038658f) * _S128 + 0.07495300471782684f) * _S128 + 0.16666752099990845f) * _S128 * _S129 + _S129;
    if(_S127)
    {
        _S128 = 1.57079637050628662f - 2.0f * _S130;
    }
    else
    {
        _S128 = _S130;
    }
    if(x_3 < 0.0f)
    {
        _S128 = - _S128;
    }
    return _S128;
}

float3 table_colour_0(uint index_4, KernelContext_0 thread* kernelContext_12)
{
    float _S131 = table_number_1(index_4, kernelContext_12);
    float _S132 = table_number_1(index_4 + 1U, kernelContext_12);
    float _S133 = table_number_1(index_4 + 2U, kernelContext_12);
    return float3(_S131, _S132, _S133);
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
    float3 _S134 = table_colour_0(row_0, kernelContext_13);
    (&albedos_0)->diffuse_reflect_0 = _S134;
    float3 _S135 = table_colour_0(row_0 + 3U, kernelContext_13);
    (&albedos_0)->diffuse_transmit_0 = _S135;
    float3 _S136 = table_colour_0(row_0 + 6U, kernelContext_13);
    (&albedos_0)->specular_reflect_0 = _S136;
    float3 _S137 = table_colour_0(row_0 + 9U, kernelContext_13);
    (&albedos_0)->specular_transmit_0 = _S137;
    return albedos_0;
}

Albedos_0 albedos_of_0(uint family_8, uint thread_8, KernelContext_0 thread* kernelContext_14)
{
    Albedos_0 _S138 = table_albedos_0(kernelContext_14->families_0[family_8].albedo_table_0 + kernelContext_14->families_0[family_8].albedo_stride_0 * thread_8, kernelContext_14);
    return _S138;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S139 = room_0 / max(albedo_0, float3(9.99999997475242708e-07f) );
    return min(gain_1, max(min(min(_S139.x, _S139.y), _S139.z), 0.0f));
}

float natural_logarithm_0(float x_4)
{
    uint _S140 = (as_type<uint>((x_4)));
    float exponent_0 = float(int(_S140 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S140 & 8388607U) | 1056964608U)));
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
    float _S141 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S141 - exponent_1 * 0.00021219444170129f - 0.5f * _S141) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_10, uint cell_6, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float3 towards_light_0(const Light_0 thread* light_0, float3 position_4, float3 thread* irradiance_1)
{
    *irradiance_1 = float3(light_0->red_0, light_0->green_0, light_0->blue_0);
    float3 _S142 = float3(light_0->x_1, light_0->y_1, light_0->z_1);
    if((light_0->is_point_0) == 0U)
    {
        return _S142;
    }
    float3 _S143 = _S142 - position_4;
    *irradiance_1 = *irradiance_1 / float3(max(square_0(_S143), 9.999999960041972e-13f)) ;
    return normalize(_S143);
}

float diffuse_reflection_0(float3 light_1, float3 normal_1, float blend_0)
{
    float _S144 = light_1.z;
    if(_S144 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S144, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_0);
}

float projected_area_1(float3 direction_3, float3 tangent_0, float roughness_1)
{
    float _S145 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S145 * _S145 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S146 = clamp(x_5, -87.0f, 88.0f);
    float _S147 = floor(_S146 * 1.4426950216293335f + 0.5f);
    float _S148 = _S146 - _S147 * 0.693359375f + _S147 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S148 + 0.00139819993637502f) * _S148 + 0.00833345204591751f) * _S148 + 0.04166579619050026f) * _S148 + 0.1666666567325592f) * _S148 + 0.5f;
    float _S149 = (as_type<float>((uint(int(_S147) + int(127)) << 23U)));
    float _S150;
    if(x_5 < -87.0f)
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

float flake_density_0(float squared_along_0, float roughness_2)
{
    float _S151 = roughness_2 * roughness_2;
    float _S152 = squared_along_0 * (1.0f - _S151) + _S151;
    return 0.31830987334251404f * _S151 * roughness_2 / (_S152 * _S152);
}

float density_between_0(float3 light_2, float3 view_1, float3 tangent_1, float roughness_3)
{
    float3 _S153 = light_2 + view_1;
    float _S154 = dot(_S153, tangent_1);
    return flake_density_0(min(_S154 * _S154 / max(square_0(_S153), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_2, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S155 = dot(light_3, normal_2);
    bool _S156;
    if(_S155 <= 0.0f)
    {
        _S156 = true;
    }
    else
    {
        _S156 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S156)
    {
        return 0.0f;
    }
    float _S157 = max(_S155, 9.99999997475242708e-07f);
    float _S158 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    float _S159 = projected_area_1(light_3, tangent_2, roughness_4) * _S158 + projected_area_1(view_2, tangent_2, roughness_4) * _S157;
    float _S160 = optical_depth_1 * _S159 / (_S157 * _S158);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S160 * mean_attenuation_0(_S160)) * _S157 / _S159;
}

float transmission_0(float3 light_4, float3 view_3, float3 normal_3, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S161 = - dot(light_4, normal_3);
    float _S162 = dot(view_3, normal_3);
    bool _S163;
    if(_S161 <= 0.0f)
    {
        _S163 = true;
    }
    else
    {
        _S163 = _S162 <= 0.0f;
    }
    if(_S163)
    {
        return 0.0f;
    }
    float _S164 = 1.0f / max(_S162, 9.99999997475242708e-07f);
    float _S165 = projected_area_1(light_4, tangent_3, roughness_5) / max(_S161, 9.99999997475242708e-07f);
    float _S166 = projected_area_1(view_3, tangent_3, roughness_5) * _S164;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S165, _S166)) * mean_attenuation_0(optical_depth_2 * abs(_S165 - _S166)) * _S164;
}

float sheen_scale_0(float x_6, float y_2)
{
    return (((((0.0f * x_6 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_6 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_6 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_6 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_6 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_6 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

float sheen_shear_0(float x_7, float y_3)
{
    return ((((0.0f * x_7 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_7 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_7 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_7 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_7 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

float sheen_reflectance_0(float x_8, float y_4)
{
    return ((((0.0f * x_8 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_8 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_8 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_8 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_8 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

float3 sheen_lobe_0(float cos_view_0, float roughness_6)
{
    float _S167 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S168 = 2.0f * sqrt(_S167) - 1.0f;
    float _S169 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S168, _S169), 0.00999999977648258f, 1.0f), clamp((1.0f - _S167) * sheen_shear_0(_S168, _S169), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S168, _S169), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_5, float3 view_4, float scale_0, float shear_0)
{
    float _S170 = light_5.z;
    bool _S171;
    if(_S170 <= 0.0f)
    {
        _S171 = true;
    }
    else
    {
        _S171 = (view_4.z) <= 0.0f;
    }
    if(_S171)
    {
        return 0.0f;
    }
    float2 _S172 = view_4.xy;
    float _S173 = dot(_S172, _S172);
    float2 _S174;
    if(_S173 > 9.99999968265522539e-21f)
    {
        _S174 = _S172 * float2(rsqrt(_S173)) ;
    }
    else
    {
        _S174 = float2(1.0f, 0.0f);
    }
    float _S175 = scale_0 * dot(light_5.xy, _S174) + shear_0 * _S170;
    float _S176 = scale_0 * (light_5.y * _S174.x - light_5.x * _S174.y);
    float _S177 = _S175 * _S175 + _S176 * _S176 + _S170 * _S170;
    return 0.31830987334251404f * scale_0 * scale_0 * _S170 / max(_S177 * _S177, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_6, float3 view_5, float strength_0, float roughness_7)
{
    float3 _S178 = sheen_lobe_0(view_5.z, roughness_7);
    float _S179 = strength_0 * _S178.z;
    return float2(_S179 * transformed_cosine_0(light_6, view_5, _S178.x, _S178.y), 1.0f - _S179);
}

void accumulate_0(const Frame_0 thread* frame_4, uint2 pixel_1, float4 light_7, KernelContext_0 thread* kernelContext_15)
{
    uint _S180 = pixel_1.y * frame_4->width_0 + pixel_1.x;
    float _S181 = light_7.w;
    float4 _S182 = float4(light_7.xyz + float3((1.0f - _S181))  * float3(frame_4->background_red_0, frame_4->background_green_0, frame_4->background_blue_0), _S181);
    packed_float4 device* _S183 = kernelContext_15->radiance_0+_S180;
    float4 _S184;
    if((frame_4->pass_number_0) == 0U)
    {
        _S184 = _S182;
    }
    else
    {
        _S184 = float4(*(kernelContext_15->radiance_0+_S180))  + _S182;
    }
    *_S183 = packed_float4(_S184) ;
    return;
}

VisiblePoint_0 visible_point_0(const Frame_0 thread* _S185, uint _S186, uint _S187, uint2 _S188, KernelContext_0 thread* kernelContext_16)
{
    Fabric_0 device* _S189 = kernelContext_16->fabrics_0+_S186;
    uint _S190 = 3U * _S187;
    Vertex_0 _S191 = kernelContext_16->vertices_0[kernelContext_16->corners_0[_S190]];
    Vertex_0 _S192 = kernelContext_16->vertices_0[kernelContext_16->corners_0[_S190 + 1U]];
    Vertex_0 _S193 = kernelContext_16->vertices_0[kernelContext_16->corners_0[_S190 + 2U]];
    thread Vertex_0 _S194 = _S192;
    float3 _S195 = position_of_0(&_S194);
    thread Vertex_0 _S196 = _S191;
    float3 _S197 = position_of_0(&_S196);
    float3 _S198 = _S195 - _S197;
    thread Vertex_0 _S199 = _S193;
    float3 _S200 = position_of_0(&_S199);
    float3 _S201 = _S200 - _S197;
    float3 _S202 = cross(_S198, _S201);
    float _S203 = 1.0f / max(square_0(_S202), 1.00000000317107685e-30f);
    float3 _S204 = camera_right_0(_S185);
    float _S205 = float(_S185->width_0);
    float3 _S206 = _S204 * float3((2.0f / _S205)) ;
    float3 _S207 = camera_up_0(_S185);
    float _S208 = float(_S185->height_0);
    float3 _S209 = _S207 * float3((-2.0f / _S208)) ;
    float _S210 = float(_S188.x) + 0.5f - 0.5f * _S205;
    float _S211 = float(_S188.y) + 0.5f - 0.5f * _S208;
    float3 _S212 = camera_forward_0(_S185);
    float3 _S213 = _S212 + float3(_S210)  * _S206 + float3(_S211)  * _S209;
    float _S214 = dot(_S213, _S202);
    float _S215;
    if((abs(_S214)) > 1.00000000317107685e-30f)
    {
        _S215 = _S214;
    }
    else
    {
        _S215 = 1.00000000317107685e-30f;
    }
    float _S216 = 1.0f / _S215;
    float3 _S217 = camera_origin_0(_S185);
    float3 _S218 = _S197 - _S217;
    float3 _S219 = float3((dot(_S218, _S202) * _S216)) ;
    float3 _S220 = _S213 * _S219 - _S218;
    float3 _S221 = _S219 * (_S206 - _S213 * float3((dot(_S206, _S202) * _S216)) );
    float3 _S222 = _S219 * (_S209 - _S213 * float3((dot(_S209, _S202) * _S216)) );
    float3 _S223 = float3(_S203) ;
    float3 _S224 = cross(_S201, _S202) * _S223;
    float3 _S225 = cross(_S202, _S198) * _S223;
    float _S226 = dot(_S220, _S224);
    float _S227 = dot(_S220, _S225);
    float _S228 = _S192.u_0 - _S191.u_0;
    float _S229 = _S192.v_0 - _S191.v_0;
    float2 _S230 = float2(_S228, _S229);
    float _S231 = _S193.u_0 - _S191.u_0;
    float _S232 = _S193.v_0 - _S191.v_0;
    float2 _S233 = float2(_S231, _S232);
    float2 _S234 = float2(_S191.u_0, _S191.v_0) + float2(_S226)  * _S230 + float2(_S227)  * _S233;
    float2 _S235 = float2(dot(_S221, _S224))  * _S230 + float2(dot(_S221, _S225))  * _S233;
    float2 _S236 = float2(dot(_S222, _S224))  * _S230 + float2(dot(_S222, _S225))  * _S233;
    if((_S228 * _S232 - _S229 * _S231) < 0.0f)
    {
        _S215 = -1.0f;
    }
    else
    {
        _S215 = 1.0f;
    }
    float3 _S237 = float3(_S215)  * (float3(_S232)  * _S198 - float3(_S229)  * _S201);
    float3 _S238 = float3(_S215)  * (float3(_S228)  * _S201 - float3(_S231)  * _S198);
    thread VisiblePoint_0 point_1;
    float _S239 = 1.0f - _S226 - _S227;
    thread Vertex_0 _S240 = _S191;
    float3 _S241 = normal_of_0(&_S240);
    float3 _S242 = float3(_S239)  * _S241;
    thread Vertex_0 _S243 = _S192;
    float3 _S244 = normal_of_0(&_S243);
    float3 _S245 = _S242 + float3(_S226)  * _S244;
    thread Vertex_0 _S246 = _S193;
    float3 _S247 = normal_of_0(&_S246);
    float3 _S248 = normalize(_S245 + float3(_S227)  * _S247);
    (&point_1)->normal_0 = _S248;
    float3 _S249 = normalize(_S237 - _S248 * float3(dot(_S248, _S237)) );
    (&point_1)->axis_x_0 = _S249;
    (&point_1)->axis_y_0 = cross(_S248, _S249);
    (&point_1)->position_0 = _S197 + _S220;
    (&point_1)->view_0 = - normalize(_S213);
    bool _S250 = (dot(cross(_S237, _S238), _S248)) < 0.0f;
    float _S251 = _S189->uv_width_0;
    if(_S250)
    {
        _S215 = - _S189->uv_height_0;
    }
    else
    {
        _S215 = _S189->uv_height_0;
    }
    float2 _S252 = float2(_S251, _S215);
    float2 _S253 = _S234 * _S252;
    if(_S250)
    {
        _S215 = _S189->uv_height_0;
    }
    else
    {
        _S215 = 0.0f;
    }
    (&point_1)->draft_0 = _S253 + float2(0.0f, _S215);
    (&point_1)->draft_dx_0 = _S235 * _S252;
    (&point_1)->draft_dy_0 = _S236 * _S252;
    return point_1;
}

struct YarnPoint_0
{
    bool back_2;
    bool hole_2;
    bool is_warp_1;
    float x_9;
    float y_5;
    float height_3;
    float3 normal_4;
    float3 tangent_4;
    float roughness_8;
    Albedos_0 albedos_1;
};

struct Hit_0
{
    float x_10;
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

Crossing_0 crossing_at_0(uint _S254, float _S255, float _S256, bool _S257, KernelContext_0 thread* kernelContext_17)
{
    Fabric_0 device* _S258 = kernelContext_17->fabrics_0+_S254;
    thread Crossing_0 crossing_2;
    Cell_0 _S259 = locate_0(_S258->warp_0, _S255, kernelContext_17);
    (&crossing_2)->warp_1 = _S259;
    Cell_0 _S260 = locate_0(_S258->weft_0, _S256, kernelContext_17);
    (&crossing_2)->weft_1 = _S260;
    uint _S261 = _S258->run_words_0 + 2U * ((&(&crossing_2)->weft_1)->thread_1 * _S258->ends_1 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S262 = kernelContext_17->words_0[_S261];
    (&crossing_2)->warp_word_0 = _S262;
    (&crossing_2)->weft_word_0 = kernelContext_17->words_0[_S261 + 1U];
    (&crossing_2)->warp_above_0 = ((_S262 & 1U) == 1U) != _S257;
    return crossing_2;
}

Sample_0 sample_at_0(uint _S263, float _S264, float _S265, bool _S266, KernelContext_0 thread* kernelContext_18)
{
    Fabric_0 device* _S267 = kernelContext_18->fabrics_0+_S263;
    thread Sample_0 sample_0;
    Crossing_0 _S268 = crossing_at_0(_S263, _S264, _S265, _S266, kernelContext_18);
    (&sample_0)->crossing_1 = _S268;
    thread Crossing_0 _S269 = _S268;
    Shown_0 _S270 = shown_at_0(&_S269, _S266);
    (&sample_0)->shown_3 = _S270;
    uint _S271;
    if(_S270.is_warp_0)
    {
        _S271 = _S267->warp_0;
    }
    else
    {
        _S271 = _S267->weft_0;
    }
    uint _S272;
    if(_S270.is_warp_0)
    {
        _S272 = _S267->weft_0;
    }
    else
    {
        _S272 = _S267->warp_0;
    }
    thread Cell_0 _S273 = (&(&sample_0)->crossing_1)->warp_1;
    thread Cell_0 _S274 = (&(&sample_0)->crossing_1)->weft_1;
    Cell_0 _S275 = select_cell_0(_S270.is_warp_0, &_S273, &_S274);
    thread Cell_0 _S276 = (&(&sample_0)->crossing_1)->weft_1;
    thread Cell_0 _S277 = (&(&sample_0)->crossing_1)->warp_1;
    Cell_0 _S278 = select_cell_0(_S270.is_warp_0, &_S276, &_S277);
    thread Cell_0 _S279 = _S278;
    Run_0 _S280 = unpack_0(_S271, _S272, _S275.thread_1, &_S279, _S270.word_0, kernelContext_18);
    thread Cell_0 _S281 = _S275;
    Section_0 _S282 = section_at_0(&_S281);
    bool _S283;
    if(_S270.on_top_0)
    {
        _S283 = (_S280.distance_0) < (_S282.drop_0 * _S280.bend_1.sine_0);
    }
    else
    {
        _S283 = false;
    }
    bool _S284;
    if(_S270.on_top_0)
    {
        _S284 = !_S283;
    }
    else
    {
        _S284 = false;
    }
    float _S285;
    if(_S284)
    {
        _S285 = 1.0f;
    }
    else
    {
        _S285 = -1.0f;
    }
    float _S286;
    if(_S283)
    {
        _S286 = _S280.other_reach_0;
    }
    else
    {
        _S286 = _S280.reach_0;
    }
    float _S287;
    if(_S283)
    {
        _S287 = _S286 + _S280.distance_0;
    }
    else
    {
        _S287 = max(_S286 - _S280.distance_0, 0.0f);
    }
    float _S288 = _S286 / _S280.bend_1.sine_0 - _S285 * _S282.drop_0;
    float _S289 = _S287 * _S287;
    float _S290 = max(_S288 * _S288 - _S289, 9.99999968265522539e-21f);
    float _S291 = rsqrt(_S290);
    float _S292 = _S289 / (_S290 * _S291 + _S288);
    bool _S293 = _S287 > 0.0f;
    float _S294;
    if(_S270.on_top_0)
    {
        _S294 = 1.0f;
    }
    else
    {
        _S294 = -1.0f;
    }
    float _S295;
    if(_S280.near_start_0)
    {
        _S295 = 1.0f;
    }
    else
    {
        _S295 = -1.0f;
    }
    float _S296 = _S294 * _S295;
    if(_S293)
    {
        _S294 = _S288 * _S291;
    }
    else
    {
        _S294 = 1.0f;
    }
    (&sample_0)->slope_across_0 = _S282.slope_0 * _S294;
    if(_S293)
    {
        _S287 = _S296 * _S287 * _S291;
    }
    else
    {
        _S287 = 0.0f;
    }
    (&sample_0)->slope_along_0 = _S287;
    Family_0 _S297 = kernelContext_18->families_0[_S271];
    thread Shown_0 _S298 = _S270;
    thread Run_0 _S299 = _S280;
    thread Cell_0 _S300 = _S278;
    float2 _S301 = dive_0(_S272, &_S298, &_S299, &_S300, kernelContext_18);
    if(_S280.straight_0)
    {
        _S285 = 0.0f;
    }
    else
    {
        _S285 = _S297.height_scale_0 * _S285;
    }
    (&sample_0)->height_5 = _S285 * (_S286 * _S280.bend_1.half_tangent_0 - _S292) - _S297.height_scale_0 * _S282.drop_0 - _S301.x;
    float _S302 = _S297.height_scale_0 * (&sample_0)->slope_across_0;
    float _S303 = _S297.height_scale_0 * (&sample_0)->slope_along_0 - _S301.y;
    if(_S270.is_warp_0)
    {
        _S285 = _S302;
    }
    else
    {
        _S285 = _S303;
    }
    (&sample_0)->slope_x_1 = _S285;
    if(_S270.is_warp_0)
    {
        _S285 = _S303;
    }
    else
    {
        _S285 = _S302;
    }
    (&sample_0)->slope_y_1 = _S285;
    (&sample_0)->run_3 = _S280;
    (&sample_0)->section_1 = _S282;
    return sample_0;
}

float steps_per_length_0(uint _S304, const SearchQuality_0 thread* _S305, float3 _S306, KernelContext_0 thread* kernelContext_19)
{
    Fabric_0 device* _S307 = kernelContext_19->fabrics_0+_S304;
    return max(max(abs(_S306.x) * _S307->threads_per_x_0, abs(_S306.y) * _S307->threads_per_y_0) * _S305->steps_per_thread_0, abs(_S306.z) * _S307->per_relief_0 * _S305->steps_per_relief_0);
}

float cell_maximum_0(uint _S308, const Crossing_0 thread* _S309, KernelContext_0 thread* kernelContext_20)
{
    Fabric_0 device* _S310 = kernelContext_20->fabrics_0+_S308;
    bool _S311 = _S309->warp_above_0;
    uint _S312;
    if(_S309->warp_above_0)
    {
        _S312 = _S310->warp_0;
    }
    else
    {
        _S312 = _S310->weft_0;
    }
    uint _S313;
    if(_S311)
    {
        _S313 = _S309->warp_word_0;
    }
    else
    {
        _S313 = _S309->weft_word_0;
    }
    return float(_S313 >> 28U) * kernelContext_20->families_0[_S312].height_scale_0 * kernelContext_20->families_0[_S312].level_0;
}

Probe_0 probe_0(uint _S314, float _S315, float _S316, bool _S317, bool _S318, bool _S319, KernelContext_0 thread* kernelContext_21)
{
    Sample_0 _S320 = sample_at_0(_S314, _S315, _S316, _S317, kernelContext_21);
    thread Probe_0 probe_1;
    (&probe_1)->height_1 = _S320.height_5;
    (&probe_1)->hole_1 = _S320.shown_3.hole_0;
    (&probe_1)->slope_x_0 = _S320.slope_x_1;
    (&probe_1)->slope_y_0 = _S320.slope_y_1;
    uint _S321;
    if(_S320.shown_3.is_warp_0)
    {
        _S321 = _S320.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S321 = _S320.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S321;
    thread Crossing_0 _S322 = _S320.crossing_1;
    float _S323 = cell_maximum_0(_S314, &_S322, kernelContext_21);
    (&probe_1)->cell_max_0 = _S323;
    float _S324;
    if(_S318)
    {
        _S324 = _S320.crossing_1.warp_1.above_0;
    }
    else
    {
        _S324 = _S320.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_0 = _S324;
    if(_S319)
    {
        _S324 = _S320.crossing_1.weft_1.above_0;
    }
    else
    {
        _S324 = _S320.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_0 = _S324;
    bool _S325 = !_S320.shown_3.is_warp_0;
    thread Cell_0 _S326 = _S320.crossing_1.warp_1;
    thread Shown_0 _S327 = _S320.shown_3;
    thread Run_0 _S328 = _S320.run_3;
    float _S329 = outline_distance_0(&_S326, &_S327, &_S328, _S325, _S318);
    (&probe_1)->edge_x_0 = _S329;
    thread Cell_0 _S330 = _S320.crossing_1.weft_1;
    thread Shown_0 _S331 = _S320.shown_3;
    thread Run_0 _S332 = _S320.run_3;
    float _S333 = outline_distance_0(&_S330, &_S331, &_S332, _S320.shown_3.is_warp_0, _S319);
    (&probe_1)->edge_y_0 = _S333;
    return probe_1;
}

bool is_free_0(uint _S334, const SearchQuality_0 thread* _S335, float3 _S336, float3 _S337, bool _S338, float _S339, KernelContext_0 thread* kernelContext_22)
{
    float _S340 = _S337.z;
    if(_S340 <= 0.0f)
    {
        return false;
    }
    float _S341 = _S335->shadow_share_0;
    float _S342 = steps_per_length_0(_S334, _S335, _S337, kernelContext_22);
    float _S343 = 1.0f / max(_S341 * _S342, 9.99999971718068537e-10f);
    StepControl_0 _S344 = step_control_0(_S337.xy, _S343);
    PreviousSample_0 previous_3 = no_previous_sample_0();
    uint count_1 = 0U;
    float distance_1 = 0.0f;
    float last_step_0 = 0.0f;
    for(;;)
    {
        bool _S345;
        if(count_1 < 1024U)
        {
            _S345 = (_S336.z + _S340 * distance_1) < _S339;
        }
        else
        {
            _S345 = false;
        }
        if(_S345)
        {
        }
        else
        {
            break;
        }
        float3 _S346 = _S336 + _S337 * float3(distance_1) ;
        Probe_0 _S347 = probe_0(_S334, _S346.x, _S346.y, _S338, _S344.right_0, _S344.up_0, kernelContext_22);
        float _S348 = _S346.z;
        float _S349 = _S348 - _S347.height_1;
        float _S350 = _S340 - _S347.slope_x_0 * _S337.x - _S347.slope_y_0 * _S337.y;
        bool _S351;
        if(!_S347.hole_1)
        {
            _S351 = _S349 < 0.0f;
        }
        else
        {
            _S351 = false;
        }
        if(_S351)
        {
            return false;
        }
        thread PreviousSample_0 _S352 = previous_3;
        thread Probe_0 _S353 = _S347;
        float _S354 = way_back_to_dip_0(&_S352, _S349, _S350, last_step_0, &_S353);
        if(_S354 >= 0.0f)
        {
            float last_step_1 = last_step_0 - _S354;
            distance_1 = distance_1 - _S354;
            last_step_0 = last_step_1;
            count_1 = count_1 + 1U;
            continue;
        }
        bool _S355 = _S348 > (_S347.cell_max_0);
        thread Probe_0 _S356 = _S347;
        PreviousSample_0 _S357 = after_sample_0(_S349, _S350, &_S356, _S355);
        float last_step_2;
        if(_S355)
        {
            thread StepControl_0 _S358 = _S344;
            float _S359 = StepControl_to_cell_exit_0(&_S358, _S347.side_x_0, _S347.side_y_0);
            last_step_2 = max(_S359, _S343);
        }
        else
        {
            thread StepControl_0 _S360 = _S344;
            thread Probe_0 _S361 = _S347;
            float _S362 = StepControl_to_next_sample_0(&_S360, &_S361, _S349, _S350);
            last_step_2 = _S362;
        }
        float distance_2 = distance_1 + last_step_2;
        previous_3 = _S357;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S363, const SearchQuality_0 thread* _S364, float _S365, float _S366, float3 _S367, bool _S368, KernelContext_0 thread* kernelContext_23)
{
    Fabric_0 device* _S369 = kernelContext_23->fabrics_0+_S363;
    Sample_0 _S370 = sample_at_0(_S363, _S365, _S366, _S368, kernelContext_23);
    if(!_S370.shown_3.hole_0)
    {
        return false;
    }
    float3 _S371 = float3(_S365, _S366, 0.0f);
    bool passes_0 = true;
    uint side_0 = 0U;
    for(;;)
    {
        bool _S372;
        if(side_0 < 2U)
        {
            _S372 = passes_0;
        }
        else
        {
            _S372 = false;
        }
        if(_S372)
        {
        }
        else
        {
            break;
        }
        float3 _S373;
        if(side_0 == 0U)
        {
            _S373 = _S367;
        }
        else
        {
            _S373 = float3(- _S367.x, - _S367.y, _S367.z);
        }
        bool _S374 = is_free_0(_S363, _S364, _S371, _S373, _S368 != (side_0 == 1U), _S369->height_high_0, kernelContext_23);
        uint _S375 = side_0 + 1U;
        passes_0 = _S374;
        side_0 = _S375;
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

float max_height_along_0(uint _S376, float _S377, float _S378, float _S379, float3 _S380, bool _S381, KernelContext_0 thread* kernelContext_24)
{
    Fabric_0 device* _S382 = kernelContext_24->fabrics_0+_S376;
    Cell_0 _S383 = locate_0(_S382->warp_0, _S377, kernelContext_24);
    uint _S384 = _S383.thread_1 / 2U;
    Cell_0 _S385 = locate_0(_S382->weft_0, _S378, kernelContext_24);
    uint _S386 = _S385.thread_1 / 2U;
    float _S387 = _S380.x;
    uint _S388;
    if(_S387 > 0.0f)
    {
        _S388 = 1U;
    }
    else
    {
        _S388 = 0U;
    }
    float _S389 = _S380.y;
    uint _S390;
    if(_S389 > 0.0f)
    {
        _S390 = 2U;
    }
    else
    {
        _S390 = 0U;
    }
    uint _S391 = kernelContext_24->words_0[_S382->max_heights_0 + 4U * (_S386 * _S382->max_height_columns_0 + _S384) + (_S388 + _S390)];
    int number_0;
    if(_S381)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S392 = _S391 >> uint(number_0);
    float _S393 = max(abs(_S387) * _S382->threads_per_x_0, abs(_S389) * _S382->threads_per_y_0) / _S380.z;
    float _S394 = _S382->height_high_0;
    float max_height_0 = _S382->height_high_0;
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
        if(((max_height_0 - _S379) * _S393) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S392 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S394);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

float3 cell_bounds_0(uint _S395, float _S396, float _S397, bool _S398, bool _S399, bool _S400, KernelContext_0 thread* kernelContext_25)
{
    Crossing_0 _S401 = crossing_at_0(_S395, _S396, _S397, _S398, kernelContext_25);
    thread Crossing_0 _S402 = _S401;
    float _S403 = cell_maximum_0(_S395, &_S402, kernelContext_25);
    float _S404;
    if(_S399)
    {
        _S404 = _S401.warp_1.above_0;
    }
    else
    {
        _S404 = _S401.warp_1.below_0;
    }
    float _S405;
    if(_S400)
    {
        _S405 = _S401.weft_1.above_0;
    }
    else
    {
        _S405 = _S401.weft_1.below_0;
    }
    return float3(_S403, _S404, _S405);
}

float first_sample_height_0(uint _S406, const ViewRay_0 thread* _S407, const StepControl_0 thread* _S408, bool _S409, KernelContext_0 thread* kernelContext_26)
{
    float _S410 = max_height_along_0(_S406, _S407->origin_0.x, _S407->origin_0.y, 0.0f, float3(_S407->slope_1, 1.0f), _S409, kernelContext_26);
    uint count_2 = 0U;
    float height_7 = _S410;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S411 = ViewRay_at_0(_S407, height_7);
        float3 _S412 = cell_bounds_0(_S406, _S411.x, _S411.y, _S409, _S408->right_0, _S408->up_0, kernelContext_26);
        float _S413 = height_7 - _S412.x;
        float _S414 = StepControl_to_cell_exit_0(_S408, _S412.y, _S412.z);
        float height_8 = height_7 - clamp(_S413, 0.0f, _S414);
        if(_S413 <= _S414)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

ViewRayEnd_0 search_down_0(uint _S415, const ViewRay_0 thread* _S416, const StepControl_0 thread* _S417, bool _S418, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S419 = kernelContext_27->fabrics_0+_S415;
    float _S420 = _S419->height_low_0 - (_S419->height_high_0 - _S419->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S421 = first_sample_height_0(_S415, _S416, _S417, _S418, kernelContext_27);
    (&end_1)->height_6 = _S421;
    (&end_1)->last_step_3 = _S417->epsilon_0;
    (&end_1)->previous_4 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
    uint count_3 = 0U;
    for(;;)
    {
        if(count_3 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S422 = ViewRay_at_0(_S416, (&end_1)->height_6);
        Probe_0 _S423 = probe_0(_S415, _S422.x, _S422.y, _S418, _S417->right_0, _S417->up_0, kernelContext_27);
        float _S424 = (&end_1)->height_6 - _S423.height_1;
        thread Probe_0 _S425 = _S423;
        float _S426 = ViewRay_rate_0(_S416, &_S425);
        (&end_1)->depth_1 = - _S424;
        (&end_1)->rate_4 = _S426;
        bool _S427;
        if((&(&end_1)->previous_4)->known_0)
        {
            _S427 = !_S423.hole_1;
        }
        else
        {
            _S427 = false;
        }
        bool _S428;
        if(_S427)
        {
            _S428 = ((&(&end_1)->previous_4)->yarn_0) == (_S423.yarn_1);
        }
        else
        {
            _S428 = false;
        }
        (&end_1)->smooth_0 = _S428;
        bool _S429;
        if(!_S423.hole_1)
        {
            _S429 = _S424 <= 0.0f;
        }
        else
        {
            _S429 = false;
        }
        bool _S430;
        if(_S429)
        {
            _S430 = true;
        }
        else
        {
            _S430 = ((&end_1)->height_6) <= _S420;
        }
        if(_S430)
        {
            break;
        }
        thread PreviousSample_0 _S431 = (&end_1)->previous_4;
        thread Probe_0 _S432 = _S423;
        float _S433 = way_back_to_dip_0(&_S431, _S424, _S426, (&end_1)->last_step_3, &_S432);
        if(_S433 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S433;
            (&end_1)->last_step_3 = (&end_1)->last_step_3 - _S433;
            count_3 = count_3 + 1U;
            continue;
        }
        float _S434 = StepControl_to_cell_exit_0(_S417, _S423.side_x_0, _S423.side_y_0);
        float _S435 = min(_S434, (&end_1)->height_6 - _S423.cell_max_0);
        thread Probe_0 _S436 = _S423;
        float _S437 = StepControl_to_next_sample_0(_S417, &_S436, _S424, _S426);
        bool _S438 = _S435 > _S437;
        thread Probe_0 _S439 = _S423;
        PreviousSample_0 _S440 = after_sample_0(_S424, _S426, &_S439, _S438);
        (&end_1)->previous_4 = _S440;
        float _S441 = max(_S435, _S437);
        (&end_1)->last_step_3 = _S441;
        (&end_1)->height_6 = (&end_1)->height_6 - _S441;
        count_3 = count_3 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S442, const ViewRay_0 thread* _S443, const StepControl_0 thread* _S444, bool _S445, const ViewRayEnd_0 thread* _S446, uint _S447, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S448 = kernelContext_28->fabrics_0+_S442;
    float _S449 = _S448->height_high_0 - _S448->height_low_0;
    float _S450 = _S446->height_6;
    float _S451 = _S446->last_step_3;
    float above_2 = _S446->height_6 + _S446->last_step_3;
    float above_gap_1 = clamp((&_S446->previous_4)->clearance_0, 0.0f, _S449);
    float under_gap_1 = clamp(_S446->depth_1, 0.0f, _S449);
    float _S452 = cubic_root_0(above_gap_1, - under_gap_1, (&_S446->previous_4)->rate_0 * _S446->last_step_3, _S446->rate_4 * _S446->last_step_3);
    bool _S453 = _S446->smooth_0;
    float middle_0;
    if(_S446->smooth_0)
    {
        middle_0 = above_2 - _S452 * _S451;
    }
    else
    {
        middle_0 = between_0(above_2, _S450, above_gap_1, under_gap_1);
    }
    float side_1 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S450;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < _S447)
        {
        }
        else
        {
            break;
        }
        float2 _S454 = ViewRay_at_0(_S443, middle_0);
        Probe_0 _S455 = probe_0(_S442, _S454.x, _S454.y, _S445, _S444->right_0, _S444->up_0, kernelContext_28);
        float _S456;
        if(_S455.hole_1)
        {
            _S456 = -1.0e+09f;
        }
        else
        {
            _S456 = _S455.height_1;
        }
        float _S457 = clamp(middle_0 - _S456, - _S449, _S449);
        float _S458;
        if(_S457 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S458 = 0.5f * above_gap_2;
            }
            else
            {
                _S458 = above_gap_2;
            }
            float _S459 = - _S457;
            under_1 = middle_0;
            above_gap_2 = _S458;
            under_gap_2 = _S459;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S458 = 0.5f * under_gap_2;
            }
            else
            {
                _S458 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S457;
            under_gap_2 = _S458;
            side_1 = -1.0f;
        }
        if(_S453)
        {
            thread Probe_0 _S460 = _S455;
            float _S461 = ViewRay_rate_0(_S443, &_S460);
            middle_0 = clamp(middle_0 + _S457 / min(_S461, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S453)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

Hit_0 first_hit_of_yarn_0(uint _S462, const SearchQuality_0 thread* _S463, float _S464, float _S465, float3 _S466, bool _S467, KernelContext_0 thread* kernelContext_29)
{
    float _S468 = max(_S466.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S464, _S465);
    float2 _S469 = _S466.xy / float2(_S468) ;
    (&ray_0)->slope_1 = _S469;
    float2 _S470 = - _S469;
    float _S471 = steps_per_length_0(_S462, _S463, _S466, kernelContext_29);
    StepControl_0 _S472 = step_control_0(_S470, 1.0f / max(_S471 / _S468, 9.99999971718068537e-10f));
    thread ViewRay_0 _S473 = ray_0;
    thread StepControl_0 _S474 = _S472;
    ViewRayEnd_0 _S475 = search_down_0(_S462, &_S473, &_S474, _S467, kernelContext_29);
    thread Hit_0 hit_0;
    (&hit_0)->hole_3 = false;
    thread ViewRay_0 _S476 = ray_0;
    thread StepControl_0 _S477 = _S472;
    thread ViewRayEnd_0 _S478 = _S475;
    float _S479 = refined_height_0(_S462, &_S476, &_S477, _S467, &_S478, _S463->refinements_0, kernelContext_29);
    (&hit_0)->height_4 = _S479;
    thread ViewRay_0 _S480 = ray_0;
    float2 _S481 = ViewRay_at_0(&_S480, _S479);
    (&hit_0)->x_10 = _S481.x;
    (&hit_0)->y_6 = _S481.y;
    return hit_0;
}

Hit_0 first_hit_0(uint _S482, const SearchQuality_0 thread* _S483, float _S484, float _S485, float3 _S486, bool _S487, KernelContext_0 thread* kernelContext_30)
{
    bool _S488 = passes_through_0(_S482, _S483, _S484, _S485, _S486, _S487, kernelContext_30);
    if(!_S488)
    {
        Hit_0 _S489 = first_hit_of_yarn_0(_S482, _S483, _S484, _S485, _S486, _S487, kernelContext_30);
        return _S489;
    }
    thread Hit_0 hit_1;
    (&hit_1)->x_10 = _S484;
    (&hit_1)->y_6 = _S485;
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

SurfacePoint_0 surface_at_0(uint _S490, float _S491, float _S492, bool _S493, KernelContext_0 thread* kernelContext_31)
{
    Fabric_0 device* _S494 = kernelContext_31->fabrics_0+_S490;
    Sample_0 _S495 = sample_at_0(_S490, _S491, _S492, _S493, kernelContext_31);
    float _S496;
    if(_S495.shown_3.is_warp_0)
    {
        _S496 = _S495.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S496 = _S495.crossing_1.weft_1.half_width_1;
    }
    uint _S497;
    if(_S495.shown_3.is_warp_0)
    {
        _S497 = _S494->warp_0;
    }
    else
    {
        _S497 = _S494->weft_0;
    }
    Family_0 _S498 = kernelContext_31->families_0[_S497];
    float _S499;
    if(_S493)
    {
        _S499 = -1.0f;
    }
    else
    {
        _S499 = 1.0f;
    }
    float _S500 = _S498.twist_sine_0 * _S499;
    Family_0 _S501 = kernelContext_31->families_0[_S497];
    if(_S495.shown_3.is_warp_0)
    {
        _S499 = 1.0f;
    }
    else
    {
        _S499 = -1.0f;
    }
    float2 _S502 = fibre_direction_0(_S495.slope_across_0, _S499 * _S495.slope_along_0, _S500, _S501.twist_cosine_0);
    float _S503;
    if(_S495.shown_3.is_warp_0)
    {
        _S503 = _S495.slope_x_1;
    }
    else
    {
        _S503 = _S495.slope_y_1;
    }
    float _S504;
    if(_S495.shown_3.is_warp_0)
    {
        _S504 = _S495.slope_y_1;
    }
    else
    {
        _S504 = _S495.slope_x_1;
    }
    float _S505 = _S502.x;
    float _S506 = _S502.y;
    float _S507 = _S503 * _S505 + _S499 * _S504 * _S506;
    float _S508 = _S496 * 1.0154266357421875f;
    float _S509 = _S508 * arc_sine_0(clamp(_S495.section_1.across_1 / _S508, -1.0f, 1.0f));
    if(_S495.shown_3.is_warp_0)
    {
        _S496 = _S492;
    }
    else
    {
        _S496 = - _S491;
    }
    thread SurfacePoint_0 point_2;
    (&point_2)->hole_4 = _S495.shown_3.hole_0;
    (&point_2)->is_warp_2 = _S495.shown_3.is_warp_0;
    (&point_2)->warp_thread_0 = _S495.crossing_1.warp_1.thread_1;
    (&point_2)->weft_thread_0 = _S495.crossing_1.weft_1.thread_1;
    (&point_2)->height_9 = _S495.height_5;
    (&point_2)->normal_5 = normalize(float3(- _S495.slope_x_1, - _S495.slope_y_1, 1.0f));
    float3 _S510;
    if(_S495.shown_3.is_warp_0)
    {
        _S510 = float3(_S505, _S506, _S507);
    }
    else
    {
        _S510 = float3(- _S506, _S505, _S507);
    }
    (&point_2)->tangent_5 = normalize(_S510);
    (&point_2)->across_2 = _S495.section_1.across_1;
    (&point_2)->fibre_across_0 = _S509 * _S501.twist_cosine_0 + _S496 * _S500;
    (&point_2)->fibre_along_0 = _S496 * _S501.twist_cosine_0 - _S509 * _S500;
    return point_2;
}

Albedos_0 vary_albedos_0(uint _S511, const Albedos_0 thread* _S512, uint _S513, uint _S514, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S515 = kernelContext_32->fabrics_0+_S511;
    float3 _S516 = max(_S512->specular_reflect_0, _S512->specular_transmit_0);
    float3 _S517 = _S512->diffuse_reflect_0 + _S512->diffuse_transmit_0;
    float3 _S518 = float3(_S515->layer_bound_0) ;
    float3 _S519 = float3(1.0f) ;
    float3 _S520 = float3(bounded_gain_0(thread_gain_0(_S513, _S515->colour_noise_0, _S515->seed_0), _S517, _S519 - _S518 * _S516)) ;
    float _S521 = bounded_gain_0(fibre_gain_0(_S513, _S514, _S515->fibre_noise_0, _S515->seed_0), _S516, min((_S519 - _S520 * _S517) / _S518, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S520 * _S512->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S520 * _S512->diffuse_transmit_0;
    float3 _S522 = float3(_S521) ;
    (&varied_0)->specular_reflect_0 = _S522 * _S512->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S522 * _S512->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S523, const SurfacePoint_0 thread* _S524, const Albedos_0 thread* _S525, float _S526, float _S527, KernelContext_0 thread* kernelContext_33)
{
    Fabric_0 device* _S528 = kernelContext_33->fabrics_0+_S523;
    bool _S529 = _S524->is_warp_2;
    float _S530;
    if(_S524->is_warp_2)
    {
        _S530 = _S526;
    }
    else
    {
        _S530 = _S527;
    }
    float _S531 = _S530 - _S524->across_2;
    uint _S532;
    if(_S529)
    {
        _S532 = _S528->warp_0;
    }
    else
    {
        _S532 = _S528->weft_0;
    }
    Family_0 _S533 = kernelContext_33->families_0[_S532];
    int _S534 = int(kernelContext_33->families_0[_S532].count_0);
    if(_S529)
    {
        _S532 = _S524->warp_thread_0;
    }
    else
    {
        _S532 = _S524->weft_thread_0;
    }
    uint _S535 = uint(int(floor(_S531 / _S533.period_0)) * _S534 + int(_S532)) * 2U;
    if(_S529)
    {
        _S532 = 1U;
    }
    else
    {
        _S532 = 0U;
    }
    float _S536 = floor(_S524->fibre_across_0 / _S528->fibre_size_0);
    Albedos_0 _S537 = vary_albedos_0(_S523, _S525, _S535 + _S532, uint(int(_S536)) * 65536U + uint(int(floor(_S524->fibre_along_0 / (_S528->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S536))), kernelContext_33);
    return _S537;
}

YarnPoint_0 yarn_point_of_0(uint _S538, const SurfacePoint_0 thread* _S539, float _S540, float _S541, bool _S542, bool _S543, KernelContext_0 thread* kernelContext_34)
{
    Fabric_0 device* _S544 = kernelContext_34->fabrics_0+_S538;
    bool _S545 = _S539->is_warp_2;
    uint _S546;
    if(_S539->is_warp_2)
    {
        _S546 = _S544->warp_0;
    }
    else
    {
        _S546 = _S544->weft_0;
    }
    uint _S547;
    if(_S545)
    {
        _S547 = _S539->warp_thread_0;
    }
    else
    {
        _S547 = _S539->weft_thread_0;
    }
    Albedos_0 _S548 = albedos_of_0(_S546, _S547, kernelContext_34);
    bool _S549;
    if((_S544->fibre_noise_0) > 0.0f)
    {
        _S549 = true;
    }
    else
    {
        _S549 = (_S544->colour_noise_0) > 0.0f;
    }
    Albedos_0 albedos_2;
    if(_S549)
    {
        thread Albedos_0 _S550 = _S548;
        Albedos_0 _S551 = varied_at_0(_S538, _S539, &_S550, _S540, _S541, kernelContext_34);
        albedos_2 = _S551;
    }
    else
    {
        albedos_2 = _S548;
    }
    thread YarnPoint_0 point_3;
    (&point_3)->back_2 = _S542;
    (&point_3)->hole_2 = _S543;
    (&point_3)->is_warp_1 = _S545;
    (&point_3)->x_9 = _S540;
    (&point_3)->y_5 = _S541;
    (&point_3)->height_3 = _S539->height_9;
    (&point_3)->normal_4 = _S539->normal_5;
    (&point_3)->tangent_4 = _S539->tangent_5;
    (&point_3)->roughness_8 = kernelContext_34->families_0[_S546].roughness_0;
    (&point_3)->albedos_1 = albedos_2;
    return point_3;
}

YarnPoint_0 locate_yarn_0(uint _S552, const SearchQuality_0 thread* _S553, float _S554, float _S555, float3 _S556, KernelContext_0 thread* kernelContext_35)
{
    bool _S557 = (_S556.z) < 0.0f;
    Hit_0 _S558 = first_hit_0(_S552, _S553, _S554, _S555, to_face_frame_0(_S556, _S557), _S557, kernelContext_35);
    SurfacePoint_0 _S559 = surface_at_0(_S552, _S558.x_10, _S558.y_6, _S557, kernelContext_35);
    thread SurfacePoint_0 _S560 = _S559;
    YarnPoint_0 _S561 = yarn_point_of_0(_S552, &_S560, _S558.x_10, _S558.y_6, _S557, _S558.hole_3, kernelContext_35);
    return _S561;
}

float3 scattered_0(uint _S562, const YarnPoint_0 thread* _S563, float3 _S564, float3 _S565, KernelContext_0 thread* kernelContext_36)
{
    Fabric_0 device* _S566 = kernelContext_36->fabrics_0+_S562;
    float3 _S567 = float3(0.0f) ;
    bool _S568 = !_S563->hole_2;
    bool _S569;
    if(_S568)
    {
        _S569 = (_S564.z) > 0.0f;
    }
    else
    {
        _S569 = false;
    }
    float3 value_1;
    if(_S569)
    {
        value_1 = (&_S563->albedos_1)->diffuse_reflect_0 * float3(diffuse_reflection_0(_S564, _S563->normal_4, _S566->diffuse_blend_0))  + (&_S563->albedos_1)->specular_reflect_0 * float3(reflection_0(_S564, _S565, _S563->normal_4, _S563->tangent_4, _S563->roughness_8, _S566->optical_depth_0)) ;
    }
    else
    {
        if(_S568)
        {
            _S569 = (_S564.z) < 0.0f;
        }
        else
        {
            _S569 = false;
        }
        if(_S569)
        {
            value_1 = (&_S563->albedos_1)->diffuse_transmit_0 * float3(diffuse_reflection_0(- _S564, _S563->normal_4, _S566->diffuse_blend_0))  + (&_S563->albedos_1)->specular_transmit_0 * float3(transmission_0(_S564, _S565, _S563->normal_4, _S563->tangent_4, _S563->roughness_8, _S566->optical_depth_0)) ;
        }
        else
        {
            value_1 = _S567;
        }
    }
    float _S570 = _S566->sheen_strength_0;
    if((_S566->sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S571 = sheen_with_transmittance_0(_S564, _S565, _S570, _S566->sheen_roughness_0);
    return float3(_S571.y)  * value_1 + float3(_S571.x) ;
}

bool unoccluded_0(uint _S572, const SearchQuality_0 thread* _S573, float _S574, float _S575, float _S576, float3 _S577, bool _S578, KernelContext_0 thread* kernelContext_37)
{
    Fabric_0 device* _S579 = kernelContext_37->fabrics_0+_S572;
    if((_S577.z) <= 0.0f)
    {
        return false;
    }
    float _S580 = max_height_along_0(_S572, _S574, _S575, _S576, _S577, _S578, kernelContext_37);
    bool _S581 = is_free_0(_S572, _S573, float3(_S574, _S575, _S576 + _S579->lift_0), _S577, _S578, _S580, kernelContext_37);
    return _S581;
}

bool is_lit_0(uint _S582, const SearchQuality_0 thread* _S583, const YarnPoint_0 thread* _S584, float3 _S585, KernelContext_0 thread* kernelContext_38)
{
    if(_S584->hole_2)
    {
        return true;
    }
    bool _S586 = _S584->back_2;
    float3 _S587 = to_face_frame_0(_S585, _S584->back_2);
    float _S588 = _S587.z;
    bool _S589 = _S588 < 0.0f;
    float3 _S590 = _S584->normal_4;
    float _S591 = _S584->height_3;
    float3 normal_6;
    float height_10;
    if(_S589)
    {
        SurfacePoint_0 _S592 = surface_at_0(_S582, _S584->x_9, _S584->y_5, !_S586, kernelContext_38);
        normal_6 = _S592.normal_5;
        height_10 = _S592.height_9;
    }
    else
    {
        normal_6 = _S590;
        height_10 = _S591;
    }
    float3 _S593 = float3(_S587.xy, abs(_S588));
    if((dot(normal_6, _S593)) <= 0.0f)
    {
        return false;
    }
    bool _S594 = unoccluded_0(_S582, _S583, _S584->x_9, _S584->y_5, height_10, _S593, _S586 != _S589, kernelContext_38);
    return _S594;
}

float3 evaluate_0(uint _S595, const SearchQuality_0 thread* _S596, const YarnPoint_0 thread* _S597, float3 _S598, float3 _S599, KernelContext_0 thread* kernelContext_39)
{
    float3 _S600 = scattered_0(_S595, _S597, to_face_frame_0(_S598, _S597->back_2), to_face_frame_0(_S599, _S597->back_2), kernelContext_39);
    bool _S601;
    if((max(_S600.x, max(_S600.y, _S600.z))) <= 0.0f)
    {
        _S601 = true;
    }
    else
    {
        bool _S602 = is_lit_0(_S595, _S596, _S597, _S598, kernelContext_39);
        _S601 = !_S602;
    }
    if(_S601)
    {
        return float3(0.0f) ;
    }
    return _S600;
}

float straight_through_0(uint _S603, const YarnPoint_0 thread* _S604, float3 _S605, KernelContext_0 thread* kernelContext_40)
{
    Fabric_0 device* _S606 = kernelContext_40->fabrics_0+_S603;
    if(!_S604->hole_2)
    {
        return 0.0f;
    }
    float _S607 = _S606->sheen_strength_0;
    if((_S606->sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S607 * sheen_lobe_0(abs(_S605.z), _S606->sheen_roughness_0).z;
}

float4 light_of_point_0(const Frame_0 thread* _S608, uint _S609, const VisiblePoint_0 thread* _S610, float2 _S611, KernelContext_0 thread* kernelContext_41)
{
    SearchQuality_0 _S612 = default_quality_0();
    float3 _S613 = to_local_0(_S610, _S610->view_0);
    float _S614 = _S611.x;
    float _S615 = _S611.y;
    thread SearchQuality_0 _S616 = _S612;
    YarnPoint_0 _S617 = locate_yarn_0(_S609, &_S616, _S614, _S615, _S613, kernelContext_41);
    float3 _S618 = float3(0.0f) ;
    uint number_1 = 0U;
    float3 radiance_1 = _S618;
    for(;;)
    {
        if(number_1 < (_S608->lights_0))
        {
        }
        else
        {
            break;
        }
        thread Light_0 _S619 = kernelContext_41->lights_1[number_1];
        thread float3 irradiance_2;
        float3 _S620 = towards_light_0(&_S619, _S610->position_0, &irradiance_2);
        float3 _S621 = to_local_0(_S610, _S620);
        thread SearchQuality_0 _S622 = _S612;
        thread YarnPoint_0 _S623 = _S617;
        float3 _S624 = evaluate_0(_S609, &_S622, &_S623, _S621, _S613, kernelContext_41);
        float3 radiance_2 = radiance_1 + irradiance_2 * _S624;
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    thread YarnPoint_0 _S625 = _S617;
    float _S626 = straight_through_0(_S609, &_S625, _S613, kernelContext_41);
    return float4(radiance_1, 1.0f - _S626);
}

[[kernel]] void shade_points(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(4)]], texture2d<uint, access::sample> visible_faces_1 [[texture(0)]], uint device* face_fabrics_1 [[buffer(7)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(6)]], Vertex_0 device* vertices_1 [[buffer(5)]], Family_0 device* families_1 [[buffer(1)]], uint device* words_1 [[buffer(2)]], Light_0 device* lights_2 [[buffer(3)]], packed_float4 device* radiance_3 [[buffer(8)]])
{
    uint _S627;
    thread KernelContext_0 kernelContext_42;
    (&kernelContext_42)->frames_0 = frames_1;
    (&kernelContext_42)->visible_faces_0 = visible_faces_1;
    (&kernelContext_42)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_42)->fabrics_0 = fabrics_1;
    (&kernelContext_42)->corners_0 = corners_1;
    (&kernelContext_42)->vertices_0 = vertices_1;
    (&kernelContext_42)->families_0 = families_1;
    (&kernelContext_42)->words_0 = words_1;
    (&kernelContext_42)->lights_1 = lights_2;
    (&kernelContext_42)->radiance_0 = radiance_3;
    Frame_0 _S628 = frames_1[int(0)];
    bool _S629;
    if((id_0.x) >= (_S628.width_0))
    {
        _S629 = true;
    }
    else
    {
        _S629 = (id_0.y) >= (_S628.height_0);
    }
    if(_S629)
    {
        return;
    }
    uint2 _S630 = id_0.xy;
    int3 _S631 = int3(int2(_S630), int(0));
    uint _S632 = (((&kernelContext_42)->visible_faces_0).read(vec<uint,2>(((_S631)).xy), uint(((_S631)).z)).x);
    float4 _S633 = float4(0.0f) ;
    float4 sum_0;
    if(_S632 > 0U)
    {
        uint _S634 = _S632 - 1U;
        uint _S635 = (&kernelContext_42)->face_fabrics_0[_S634];
        thread Frame_0 _S636 = _S628;
        VisiblePoint_0 _S637 = visible_point_0(&_S636, _S635, _S634, _S630, &kernelContext_42);
        uint k_0 = 0U;
        sum_0 = _S633;
        for(;;)
        {
            _S627 = _S628.samples_0;
            if(k_0 < (_S628.samples_0))
            {
            }
            else
            {
                break;
            }
            float2 _S638 = footprint_sample_0(_S630, _S628.pass_number_0 * _S628.samples_0 + k_0);
            float2 _S639 = _S637.draft_0 + float2(_S638.x)  * _S637.draft_dx_0 + float2(_S638.y)  * _S637.draft_dy_0;
            thread Frame_0 _S640 = _S628;
            thread VisiblePoint_0 _S641 = _S637;
            float4 _S642 = light_of_point_0(&_S640, _S635, &_S641, _S639, &kernelContext_42);
            float4 sum_1 = sum_0 + _S642;
            k_0 = k_0 + 1U;
            sum_0 = sum_1;
        }
        sum_0 = sum_0 / float4(float(_S627)) ;
    }
    else
    {
        sum_0 = _S633;
    }
    thread Frame_0 _S643 = _S628;
    accumulate_0(&_S643, _S630, sum_0, &kernelContext_42);
    return;
}

