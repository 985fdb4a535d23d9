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

struct StepControl_0
{
    float step_0;
    float epsilon_0;
    float per_x_0;
    float per_y_0;
    bool right_0;
    bool up_0;
};

StepControl_0 step_control_0(float2 direction_2, float step_1)
{
    thread StepControl_0 control_0;
    (&control_0)->step_0 = step_1;
    (&control_0)->epsilon_0 = 0.00499999988824129f * step_1;
    float _S7 = direction_2.x;
    (&control_0)->per_x_0 = 1.0f / max(abs(_S7), 9.99999971718068537e-10f);
    float _S8 = direction_2.y;
    (&control_0)->per_y_0 = 1.0f / max(abs(_S8), 9.99999971718068537e-10f);
    (&control_0)->right_0 = _S7 > 0.0f;
    (&control_0)->up_0 = _S8 > 0.0f;
    return control_0;
}

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
};

float2 turns_and_remainder_0(const Family_0 thread* family_0, float index_1)
{
    float _S9 = floor(fma(index_1, family_0->inverse_count_0, family_0->half_inverse_count_0));
    return float2(_S9, fma(- _S9, family_0->count_0, index_1));
}

struct Cell_0
{
    uint thread_1;
    float across_0;
    float half_width_1;
    float below_0;
    float above_0;
};

Cell_0 locate_alike_0(const Family_0 thread* family_1, float position_1)
{
    float _S10 = floor(position_1 * family_1->inverse_size_0);
    thread Cell_0 cell_1;
    float _S11 = fma(- _S10, family_1->size_0, position_1);
    (&cell_1)->below_0 = _S11;
    (&cell_1)->above_0 = family_1->size_0 - _S11;
    (&cell_1)->across_0 = _S11 - 0.5f * family_1->size_0;
    (&cell_1)->half_width_1 = family_1->half_width_0;
    float2 _S12 = turns_and_remainder_0(family_1, _S10);
    (&cell_1)->thread_1 = uint(clamp(_S12.y, 0.0f, family_1->count_0 - 1.0f));
    return cell_1;
}

struct Fabric_0
{
    Family_0 warp_0;
    Family_0 weft_0;
    uint run_words_0;
    uint ends_0;
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
    uint device* words_0;
    Light_0 device* lights_1;
    packed_float4 device* radiance_0;
};

float table_number_0(uint index_2, KernelContext_0 thread* kernelContext_0)
{
    return (as_type<float>((kernelContext_0->words_0[index_2])));
}

float table_number_1(uint index_3, KernelContext_0 thread* kernelContext_1)
{
    return (as_type<float>((kernelContext_1->words_0[index_3])));
}

Cell_0 locate_varied_0(const Family_0 thread* family_2, float position_2, KernelContext_0 thread* kernelContext_2)
{
    float turns_0 = (position_2 - family_2->start_0) * family_2->inverse_period_0;
    float turns_1 = turns_0 - floor(turns_0);
    float _S13 = turns_1 * family_2->period_0;
    uint thread_2 = kernelContext_2->words_0[family_2->first_thread_table_0 + uint(clamp(turns_1 * family_2->bins_0, 0.0f, family_2->bins_0 - 1.0f))];
    uint _S14 = family_2->place_table_0;
    float _S15 = table_number_0(family_2->place_table_0 + thread_2 * 4U + 1U, kernelContext_2);
    uint _S16;
    if(_S13 >= _S15)
    {
        _S16 = 1U;
    }
    else
    {
        _S16 = 0U;
    }
    uint _S17 = min(thread_2 + _S16, uint(family_2->count_0) - 1U);
    uint _S18 = _S14 + _S17 * 4U;
    thread Cell_0 cell_2;
    (&cell_2)->thread_1 = _S17;
    float _S19 = table_number_0(_S18, kernelContext_2);
    (&cell_2)->below_0 = _S13 - _S19;
    float _S20 = table_number_0(_S18 + 1U, kernelContext_2);
    (&cell_2)->above_0 = _S20 - _S13;
    float _S21 = table_number_0(_S18 + 2U, kernelContext_2);
    (&cell_2)->across_0 = _S13 - _S21;
    float _S22 = table_number_0(_S18 + 3U, kernelContext_2);
    (&cell_2)->half_width_1 = _S22;
    return cell_2;
}

Cell_0 locate_0(const Family_0 thread* family_3, float position_3, KernelContext_0 thread* kernelContext_3)
{
    if((family_3->is_alike_0) != 0U)
    {
        Cell_0 _S23 = locate_alike_0(family_3, position_3);
        return _S23;
    }
    Cell_0 _S24 = locate_varied_0(family_3, position_3, kernelContext_3);
    return _S24;
}

struct ViewRay_0
{
    float2 origin_0;
    float2 slope_0;
};

float2 ViewRay_at_0(const ViewRay_0 thread* this_0, float height_1)
{
    return this_0->origin_0 + this_0->slope_0 * float2(height_1) ;
}

float StepControl_to_cell_exit_0(const StepControl_0 thread* this_1, float side_x_0, float side_y_0)
{
    return max(min(side_x_0 * this_1->per_x_0, side_y_0 * this_1->per_y_0), 0.0f) + this_1->epsilon_0;
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
    bool _S25 = (abs((&crossing_0->warp_1)->across_0)) < ((&crossing_0->warp_1)->half_width_1);
    bool _S26 = (abs((&crossing_0->weft_1)->across_0)) < ((&crossing_0->weft_1)->half_width_1);
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
    (&shown_0)->is_warp_0 = _S27;
    if(!_S25)
    {
        _S27 = !_S26;
    }
    else
    {
        _S27 = false;
    }
    (&shown_0)->hole_0 = _S27;
    uint _S28;
    if((&shown_0)->is_warp_0)
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

float boundary_0(const Family_0 thread* family_4, uint thread_3, int step_2, KernelContext_0 thread* kernelContext_4)
{
    float2 _S29 = turns_and_remainder_0(family_4, float(int(thread_3) + step_2));
    float _S30 = _S29.x;
    float _S31 = family_4->period_0;
    float _S32 = table_number_0(family_4->place_table_0 + uint(_S29.y) * 4U, kernelContext_4);
    return fma(_S30, _S31, _S32);
}

float span_0(const Family_0 thread* family_5, uint thread_4, int first_0, int last_0, KernelContext_0 thread* kernelContext_5)
{
    if((family_5->is_alike_0) != 0U)
    {
        return float(last_0 - first_0) * family_5->size_0;
    }
    float _S33 = boundary_0(family_5, thread_4, last_0, kernelContext_5);
    float _S34 = boundary_0(family_5, thread_4, first_0, kernelContext_5);
    return _S33 - _S34;
}

struct Bend_0
{
    float sine_0;
    float half_tangent_0;
    float arc_0;
};

Bend_0 bend_of_0(const Family_0 thread* family_6, uint thread_5, KernelContext_0 thread* kernelContext_6)
{
    uint _S35 = family_6->bend_table_0;
    uint _S36;
    if((family_6->is_alike_0) != 0U)
    {
        _S36 = 0U;
    }
    else
    {
        _S36 = thread_5 * 4U;
    }
    uint _S37 = _S35 + _S36;
    thread Bend_0 bend_0;
    float _S38 = table_number_0(_S37, kernelContext_6);
    (&bend_0)->sine_0 = _S38;
    float _S39 = table_number_0(_S37 + 1U, kernelContext_6);
    (&bend_0)->half_tangent_0 = _S39;
    float _S40 = table_number_0(_S37 + 2U, kernelContext_6);
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

Run_0 unpack_0(const Family_0 thread* own_0, const Family_0 thread* other_0, uint thread_6, const Cell_0 thread* crossed_0, uint word_1, KernelContext_0 thread* kernelContext_7)
{
    int _S41 = int((word_1 >> 1U) & 127U);
    int _S42 = int((word_1 >> 8U) & 127U);
    int _S43 = int((word_1 >> 15U) & 63U);
    int _S44 = int((word_1 >> 21U) & 63U);
    thread Run_0 run_0;
    (&run_0)->straight_0 = ((word_1 >> 27U) & 1U) == 1U;
    float _S45 = crossed_0->below_0;
    uint _S46 = crossed_0->thread_1;
    int _S47 = - _S41;
    float _S48 = span_0(other_0, crossed_0->thread_1, _S47, int(0), kernelContext_7);
    float _S49 = _S45 + _S48;
    (&run_0)->from_start_0 = _S49;
    float _S50 = crossed_0->above_0;
    int _S51 = _S42 + int(1);
    float _S52 = span_0(other_0, _S46, int(1), _S51, kernelContext_7);
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
    Bend_0 _S57 = bend_of_0(own_0, thread_6, kernelContext_7);
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
    float _S59 = span_0(other_0, _S46, _S55, _S56, kernelContext_7);
    (&run_0)->other_reach_0 = min(0.5f * _S59, (&(&run_0)->bend_1)->arc_0);
    (&run_0)->first_crossing_0 = _S41 == int(0);
    (&run_0)->last_crossing_0 = _S42 == int(0);
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
    float slope_1;
};

Section_0 section_at_0(const Cell_0 thread* cell_3)
{
    float _S60 = cell_3->half_width_1 * 1.0154266357421875f;
    thread Section_0 section_0;
    float _S61 = clamp(cell_3->across_0, - cell_3->half_width_1, cell_3->half_width_1);
    (&section_0)->across_1 = _S61;
    float _S62 = _S60 * _S60 - square_1(_S61);
    float _S63 = rsqrt(_S62);
    (&section_0)->drop_0 = _S60 - _S62 * _S63;
    (&section_0)->slope_1 = - _S61 * _S63;
    return section_0;
}

float edge_drop_0(const Family_0 thread* family_7, uint thread_7, int step_3, KernelContext_0 thread* kernelContext_8)
{
    if((family_7->is_alike_0) != 0U)
    {
        float _S64 = table_number_0(family_7->bend_table_0 + 3U, kernelContext_8);
        return _S64;
    }
    uint _S65 = family_7->bend_table_0;
    float2 _S66 = turns_and_remainder_0(family_7, float(int(thread_7) + step_3));
    float _S67 = table_number_0(_S65 + uint(_S66.y) * 4U + 3U, kernelContext_8);
    return _S67;
}

float2 dive_0(const Family_0 thread* other_1, const Shown_0 thread* shown_1, const Run_0 thread* run_1, const Cell_0 thread* crossed_1, KernelContext_0 thread* kernelContext_9)
{
    float _S68 = crossed_1->below_0;
    float _S69 = crossed_1->above_0;
    bool _S70 = (crossed_1->below_0) < (crossed_1->above_0);
    float _S71 = min(crossed_1->below_0, crossed_1->above_0);
    float _S72;
    if(_S70)
    {
        _S72 = _S68 - crossed_1->across_0;
    }
    else
    {
        _S72 = _S69 + crossed_1->across_0;
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
        float _S76 = other_1->height_scale_0;
        float _S77 = edge_drop_0(other_1, crossed_1->thread_1, int(0), kernelContext_9);
        _S72 = _S76 * _S77;
    }
    float _S78;
    if(_S75 != _S74)
    {
        _S78 = 0.0f;
    }
    else
    {
        float _S79 = other_1->height_scale_0;
        uint _S80 = crossed_1->thread_1;
        int _S81;
        if(_S70)
        {
            _S81 = int(-1);
        }
        else
        {
            _S81 = int(1);
        }
        float _S82 = edge_drop_0(other_1, _S80, _S81, kernelContext_9);
        _S78 = _S79 * _S82;
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

struct Sample_0
{
    Crossing_0 crossing_1;
    Shown_0 shown_2;
    Run_0 run_2;
    Section_0 section_1;
    float height_2;
    float slope_across_0;
    float slope_along_0;
    float slope_x_0;
    float slope_y_0;
};

void shape_0(const Family_0 thread* own_1, const Family_0 thread* other_2, const Cell_0 thread* own_cell_0, const Cell_0 thread* crossed_2, Sample_0 thread* sample_0, KernelContext_0 thread* kernelContext_10)
{
    Shown_0 _S87 = sample_0->shown_2;
    Run_0 _S88 = unpack_0(own_1, other_2, own_cell_0->thread_1, crossed_2, sample_0->shown_2.word_0, kernelContext_10);
    Section_0 _S89 = section_at_0(own_cell_0);
    bool _S90;
    if(_S87.on_top_0)
    {
        _S90 = (_S88.distance_0) < (_S89.drop_0 * _S88.bend_1.sine_0);
    }
    else
    {
        _S90 = false;
    }
    bool _S91;
    if(_S87.on_top_0)
    {
        _S91 = !_S90;
    }
    else
    {
        _S91 = false;
    }
    float _S92;
    if(_S91)
    {
        _S92 = 1.0f;
    }
    else
    {
        _S92 = -1.0f;
    }
    float _S93;
    if(_S90)
    {
        _S93 = _S88.other_reach_0;
    }
    else
    {
        _S93 = _S88.reach_0;
    }
    float _S94;
    if(_S90)
    {
        _S94 = _S93 + _S88.distance_0;
    }
    else
    {
        _S94 = max(_S93 - _S88.distance_0, 0.0f);
    }
    float _S95 = _S93 / _S88.bend_1.sine_0 - _S92 * _S89.drop_0;
    float _S96 = _S94 * _S94;
    float _S97 = max(_S95 * _S95 - _S96, 9.99999968265522539e-21f);
    float _S98 = rsqrt(_S97);
    float _S99 = _S96 / (_S97 * _S98 + _S95);
    bool _S100 = _S94 > 0.0f;
    float _S101;
    if(_S87.on_top_0)
    {
        _S101 = 1.0f;
    }
    else
    {
        _S101 = -1.0f;
    }
    float _S102;
    if(_S88.near_start_0)
    {
        _S102 = 1.0f;
    }
    else
    {
        _S102 = -1.0f;
    }
    float _S103 = _S101 * _S102;
    if(_S100)
    {
        _S101 = _S95 * _S98;
    }
    else
    {
        _S101 = 1.0f;
    }
    sample_0->slope_across_0 = _S89.slope_1 * _S101;
    if(_S100)
    {
        _S94 = _S103 * _S94 * _S98;
    }
    else
    {
        _S94 = 0.0f;
    }
    sample_0->slope_along_0 = _S94;
    float _S104 = own_1->height_scale_0;
    thread Shown_0 _S105 = _S87;
    thread Run_0 _S106 = _S88;
    float2 _S107 = dive_0(other_2, &_S105, &_S106, crossed_2, kernelContext_10);
    if(_S88.straight_0)
    {
        _S92 = 0.0f;
    }
    else
    {
        _S92 = _S104 * _S92;
    }
    sample_0->height_2 = _S92 * (_S93 * _S88.bend_1.half_tangent_0 - _S99) - _S104 * _S89.drop_0 - _S107.x;
    float _S108 = _S104 * sample_0->slope_across_0;
    float _S109 = _S104 * sample_0->slope_along_0 - _S107.y;
    if(_S87.is_warp_0)
    {
        _S92 = _S108;
    }
    else
    {
        _S92 = _S109;
    }
    sample_0->slope_x_0 = _S92;
    if(_S87.is_warp_0)
    {
        _S92 = _S109;
    }
    else
    {
        _S92 = _S108;
    }
    sample_0->slope_y_0 = _S92;
    sample_0->run_2 = _S88;
    sample_0->section_1 = _S89;
    return;
}

float outline_distance_0(const Cell_0 thread* cell_4, const Shown_0 thread* shown_3, const Run_0 thread* run_3, bool lengthwise_0, bool forwards_0)
{
    float _S110;
    if(forwards_0)
    {
        _S110 = cell_4->across_0;
    }
    else
    {
        _S110 = - cell_4->across_0;
    }
    float _S111;
    if(forwards_0)
    {
        _S111 = cell_4->above_0;
    }
    else
    {
        _S111 = cell_4->below_0;
    }
    bool _S112;
    if(forwards_0)
    {
        _S112 = run_3->last_crossing_0;
    }
    else
    {
        _S112 = run_3->first_crossing_0;
    }
    bool _S113;
    if(forwards_0)
    {
        _S113 = run_3->first_crossing_0;
    }
    else
    {
        _S113 = run_3->last_crossing_0;
    }
    float _S114 = cell_4->half_width_1;
    float _S115 = - cell_4->half_width_1;
    bool _S116 = _S110 < _S115;
    bool _S117 = _S110 >= (cell_4->half_width_1);
    if(lengthwise_0)
    {
        _S112 = !_S112;
    }
    else
    {
        _S112 = false;
    }
    if(_S112)
    {
        _S112 = !shown_3->hole_0;
    }
    else
    {
        _S112 = false;
    }
    bool _S118;
    if(_S112)
    {
        _S118 = shown_3->on_top_0;
    }
    else
    {
        _S118 = false;
    }
    if(_S118)
    {
        if(_S113)
        {
            _S113 = _S116;
        }
        else
        {
            _S113 = false;
        }
        _S113 = !_S113;
    }
    else
    {
        _S113 = false;
    }
    if(shown_3->hole_0)
    {
        _S112 = true;
    }
    else
    {
        if(_S112)
        {
            _S112 = !shown_3->on_top_0;
        }
        else
        {
            _S112 = false;
        }
    }
    float _S119;
    if(_S116)
    {
        _S119 = _S115;
    }
    else
    {
        _S119 = _S114;
    }
    float _S120 = _S119 - _S110;
    if(_S112)
    {
        _S110 = 2.0f * _S111 + _S110 - _S114;
    }
    else
    {
        _S110 = _S111;
    }
    if(_S113)
    {
        if(forwards_0)
        {
            _S110 = run_3->to_end_0;
        }
        else
        {
            _S110 = run_3->from_start_0;
        }
        return _S110;
    }
    if(_S117)
    {
    }
    else
    {
        _S110 = _S120;
    }
    return _S110;
}

struct Probe_0
{
    float height_3;
    bool hole_1;
    float slope_x_1;
    float slope_y_1;
    uint yarn_1;
    float cell_max_0;
    float side_x_1;
    float side_y_1;
    float edge_x_0;
    float edge_y_0;
};

float ViewRay_rate_0(const ViewRay_0 thread* this_2, const Probe_0 thread* here_0)
{
    return here_0->slope_x_1 * this_2->slope_0.x + here_0->slope_y_1 * this_2->slope_0.y - 1.0f;
}

float way_back_to_dip_0(const PreviousSample_0 thread* previous_1, float clearance_1, float rate_1, float step_4, const Probe_0 thread* here_1)
{
    float _S121 = previous_1->rate_0;
    float _S122 = previous_1->rate_0 * step_4;
    float _S123 = rate_1 * step_4;
    bool _S124;
    if(!previous_1->known_0)
    {
        _S124 = true;
    }
    else
    {
        _S124 = here_1->hole_1;
    }
    if(_S124)
    {
        _S124 = true;
    }
    else
    {
        _S124 = (previous_1->yarn_0) != (here_1->yarn_1);
    }
    if(_S124)
    {
        _S124 = true;
    }
    else
    {
        _S124 = _S121 >= 0.0f;
    }
    if(_S124)
    {
        _S124 = true;
    }
    else
    {
        _S124 = rate_1 <= 0.0f;
    }
    if(_S124)
    {
        return -1.0f;
    }
    float _S125 = previous_1->clearance_0;
    if((3.0f * previous_1->clearance_0 + _S122) >= 0.0f)
    {
        _S124 = (3.0f * clearance_1 - _S123) >= 0.0f;
    }
    else
    {
        _S124 = false;
    }
    if(_S124)
    {
        return -1.0f;
    }
    float _S126 = clearance_1 - _S125;
    float _S127 = 6.0f * _S126 - 4.0f * _S122 - 2.0f * _S123;
    float _S128 = -2.0f * _S122 / max(_S127 + sqrt(max(_S127 * _S127 - 4.0f * (3.0f * (_S122 + _S123 - 2.0f * _S126)) * _S122, 0.0f)), 9.99999968265522539e-21f);
    float _S129 = 1.0f - _S128;
    float _S130 = (_S125 * (2.0f * _S128 + 1.0f) + _S122 * _S128) * _S129 * _S129;
    float _S131 = (clearance_1 * (2.0f * _S129 + 1.0f) - _S123 * _S129) * _S128 * _S128;
    if(_S128 > 0.01999999955296516f)
    {
        _S124 = _S129 > 0.01999999955296516f;
    }
    else
    {
        _S124 = false;
    }
    if(_S124)
    {
        _S124 = (_S130 + _S131) < 0.0f;
    }
    else
    {
        _S124 = false;
    }
    float _S132;
    if(_S124)
    {
        _S132 = _S129 * step_4;
    }
    else
    {
        _S132 = -1.0f;
    }
    return _S132;
}

float StepControl_to_next_sample_0(const StepControl_0 thread* this_3, const Probe_0 thread* here_2, float clearance_2, float rate_2)
{
    float _S133 = min(here_2->edge_x_0 * this_3->per_x_0, here_2->edge_y_0 * this_3->per_y_0);
    bool _S134;
    if(!here_2->hole_1)
    {
        _S134 = (rate_2 * _S133 + clearance_2) < 0.0f;
    }
    else
    {
        _S134 = false;
    }
    if(_S134)
    {
        _S134 = _S133 > (2.0f * this_3->epsilon_0);
    }
    else
    {
        _S134 = false;
    }
    float _S135 = this_3->step_0;
    float _S136;
    if(_S134)
    {
        _S136 = _S133 - this_3->epsilon_0;
    }
    else
    {
        _S136 = max(_S133, 0.0f) + this_3->epsilon_0;
    }
    return min(_S135, _S136);
}

PreviousSample_0 after_sample_0(float clearance_3, float rate_3, const Probe_0 thread* here_3, bool is_cell_exit_0)
{
    thread PreviousSample_0 previous_2;
    bool _S137 = here_3->hole_1;
    float _S138;
    if(here_3->hole_1)
    {
        _S138 = 1.0e+09f;
    }
    else
    {
        _S138 = clearance_3;
    }
    (&previous_2)->clearance_0 = _S138;
    (&previous_2)->rate_0 = rate_3;
    (&previous_2)->yarn_0 = here_3->yarn_1;
    bool _S139;
    if(!_S137)
    {
        _S139 = !is_cell_exit_0;
    }
    else
    {
        _S139 = false;
    }
    (&previous_2)->known_0 = _S139;
    return previous_2;
}

float cubic_root_0(float start_1, float end_0, float start_rate_0, float end_rate_0)
{
    float _S140 = end_0 - start_1;
    float _S141 = start_rate_0 + end_rate_0 - 2.0f * _S140;
    float _S142 = 3.0f * _S140 - 2.0f * start_rate_0 - end_rate_0;
    float share_0 = start_1 / max(- _S140, 9.99999968265522539e-21f);
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
        float _S143 = clamp(share_0 - (((_S141 * share_0 + _S142) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S141 * share_0 + 2.0f * _S142) * share_0 + start_rate_0, 0.10000000149011612f * _S140 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        int _S144 = i_0 + int(1);
        share_0 = _S143;
        i_0 = _S144;
    }
    return share_0;
}

float between_0(float above_1, float under_0, float above_gap_0, float under_gap_0)
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

float2 fibre_direction_0(float across_slope_0, float along_slope_0, float sine_1, float cosine_0)
{
    float _S145 = along_slope_0 * along_slope_0 + 1.0f;
    float _S146 = rsqrt(_S145);
    float _S147 = sine_1 * _S146 * rsqrt(_S145 + across_slope_0 * across_slope_0);
    return float2(- _S147 * _S145, _S147 * across_slope_0 * along_slope_0 + cosine_0 * _S146);
}

float arc_sine_0(float x_3)
{
    float _S148 = abs(x_3);
    bool _S149 = _S148 > 0.5f;
    float _S150;
    if(_S149)
    {
        _S150 = 0.5f * (1.0f - _S148);
    }
    else
    {
        _S150 = _S148 * _S148;
    }
    float _S151;
    if(_S149)
    {
        _S151 = sqrt(max(_S150, 0.0f));
    }
    else
    {
        _S151 = _S148;
    }
    float _S152 = ((((0.04216320067644119f * _S150 + 0.02418131195008755f) * _S150 + 0.04547002539038658f) * _S150 + 0.07495300471782684f) * _S150 + 0.16666752099990845f) * _S150 * _S151 + _S151;
    if(_S149)
    {
        _S150 = 1.57079637050628662f - 2.0f * _S152;
    }
    else
    {
        _S150 = _S152;
    }
    if(x_3 < 0.0f)
    {
        _S150 = - _S150;
    }
    return _S150;
}

float3 table_colour_0(uint index_4, KernelContext_0 thread* kernelContext_11)
{
    float _S153 = table_number_1(index_4, kernelContext_11);
    float _S154 = table_number_1(index_4 + 1U, kernelContext_11);
    float _S155 = table_number_1(index_4 + 2U, kernelContext_11);
    return float3(_S153, _S154, _S155);
}

struct Albedos_0
{
    float3 diffuse_reflect_0;
    float3 diffuse_transmit_0;
    float3 specular_reflect_0;
    float3 specular_transmit_0;
};

Albedos_0 albedos_of_0(const Family_0 thread* family_8, uint thread_8, KernelContext_0 thread* kernelContext_12)
{
    uint _S156 = family_8->albedo_table_0 + family_8->albedo_stride_0 * thread_8;
    thread Albedos_0 albedos_0;
    float3 _S157 = table_colour_0(_S156, kernelContext_12);
    (&albedos_0)->diffuse_reflect_0 = _S157;
    float3 _S158 = table_colour_0(_S156 + 3U, kernelContext_12);
    (&albedos_0)->diffuse_transmit_0 = _S158;
    float3 _S159 = table_colour_0(_S156 + 6U, kernelContext_12);
    (&albedos_0)->specular_reflect_0 = _S159;
    float3 _S160 = table_colour_0(_S156 + 9U, kernelContext_12);
    (&albedos_0)->specular_transmit_0 = _S160;
    return albedos_0;
}

float thread_gain_0(uint thread_9, float amount_0, uint seed_1)
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, 0U, seed_1 ^ 2135587861U) - 1.0f) + 1.0f;
}

float bounded_gain_0(float gain_1, float3 albedo_0, float3 room_0)
{
    float3 _S161 = room_0 / max(albedo_0, float3(9.99999997475242708e-07f) );
    return min(gain_1, max(min(min(_S161.x, _S161.y), _S161.z), 0.0f));
}

float natural_logarithm_0(float x_4)
{
    uint _S162 = (as_type<uint>((x_4)));
    float exponent_0 = float(int(_S162 >> 23U) - int(126));
    float m_0 = (as_type<float>(((_S162 & 8388607U) | 1056964608U)));
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
    float _S163 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S163 - exponent_1 * 0.00021219444170129f - 0.5f * _S163) + exponent_1 * 0.693359375f;
}

float fibre_gain_0(uint thread_10, uint cell_5, float amount_1, uint seed_2)
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_5, seed_2 ^ 2654435769U)), 10.0f) - 1.0f) + 1.0f;
}

float3 towards_light_0(const Light_0 thread* light_0, float3 position_4, float3 thread* irradiance_0)
{
    *irradiance_0 = float3(light_0->red_0, light_0->green_0, light_0->blue_0);
    float3 _S164 = float3(light_0->x_1, light_0->y_1, light_0->z_1);
    if((light_0->is_point_0) == 0U)
    {
        return _S164;
    }
    float3 _S165 = _S164 - position_4;
    *irradiance_0 = *irradiance_0 / float3(max(square_0(_S165), 9.999999960041972e-13f)) ;
    return normalize(_S165);
}

float diffuse_reflection_0(float3 light_1, float3 normal_1, float blend_0)
{
    float _S166 = light_1.z;
    if(_S166 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S166, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_0);
}

float projected_area_0(float3 direction_3, float3 tangent_0, float roughness_1)
{
    float _S167 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S167 * _S167 + 1.0f, roughness_1 * roughness_1));
}

float exponential_0(float x_5)
{
    float _S168 = clamp(x_5, -87.0f, 88.0f);
    float _S169 = floor(_S168 * 1.4426950216293335f + 0.5f);
    float _S170 = _S168 - _S169 * 0.693359375f + _S169 * 0.00021219444170129f;
    float p_0 = ((((0.00019875691214111f * _S170 + 0.00139819993637502f) * _S170 + 0.00833345204591751f) * _S170 + 0.04166579619050026f) * _S170 + 0.1666666567325592f) * _S170 + 0.5f;
    float _S171 = (as_type<float>((uint(int(_S169) + int(127)) << 23U)));
    float _S172;
    if(x_5 < -87.0f)
    {
        _S172 = 0.0f;
    }
    else
    {
        _S172 = (p_0 * _S170 * _S170 + _S170 + 1.0f) * _S171;
    }
    return _S172;
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
    float _S173 = roughness_2 * roughness_2;
    float _S174 = squared_along_0 * (1.0f - _S173) + _S173;
    return 0.31830987334251404f * _S173 * roughness_2 / (_S174 * _S174);
}

float density_between_0(float3 light_2, float3 view_1, float3 tangent_1, float roughness_3)
{
    float3 _S175 = light_2 + view_1;
    float _S176 = dot(_S175, tangent_1);
    return flake_density_0(min(_S176 * _S176 / max(square_0(_S175), 9.999999960041972e-13f), 1.0f), roughness_3);
}

float reflection_0(float3 light_3, float3 view_2, float3 normal_2, float3 tangent_2, float roughness_4, float optical_depth_1)
{
    float _S177 = dot(light_3, normal_2);
    bool _S178;
    if(_S177 <= 0.0f)
    {
        _S178 = true;
    }
    else
    {
        _S178 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S178)
    {
        return 0.0f;
    }
    float _S179 = max(_S177, 9.99999997475242708e-07f);
    float _S180 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    float _S181 = projected_area_0(light_3, tangent_2, roughness_4) * _S180 + projected_area_0(view_2, tangent_2, roughness_4) * _S179;
    float _S182 = optical_depth_1 * _S181 / (_S179 * _S180);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S182 * mean_attenuation_0(_S182)) * _S179 / _S181;
}

float transmission_0(float3 light_4, float3 view_3, float3 normal_3, float3 tangent_3, float roughness_5, float optical_depth_2)
{
    float _S183 = - dot(light_4, normal_3);
    float _S184 = dot(view_3, normal_3);
    bool _S185;
    if(_S183 <= 0.0f)
    {
        _S185 = true;
    }
    else
    {
        _S185 = _S184 <= 0.0f;
    }
    if(_S185)
    {
        return 0.0f;
    }
    float _S186 = 1.0f / max(_S184, 9.99999997475242708e-07f);
    float _S187 = projected_area_0(light_4, tangent_3, roughness_5) / max(_S183, 9.99999997475242708e-07f);
    float _S188 = projected_area_0(view_3, tangent_3, roughness_5) * _S186;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S187, _S188)) * mean_attenuation_0(optical_depth_2 * abs(_S187 - _S188)) * _S186;
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
    float _S189 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    float _S190 = 2.0f * sqrt(_S189) - 1.0f;
    float _S191 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return float3(clamp(sheen_scale_0(_S190, _S191), 0.00999999977648258f, 1.0f), clamp((1.0f - _S189) * sheen_shear_0(_S190, _S191), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S190, _S191), -60.0f, 60.0f))));
}

float transformed_cosine_0(float3 light_5, float3 view_4, float scale_0, float shear_0)
{
    float _S192 = light_5.z;
    bool _S193;
    if(_S192 <= 0.0f)
    {
        _S193 = true;
    }
    else
    {
        _S193 = (view_4.z) <= 0.0f;
    }
    if(_S193)
    {
        return 0.0f;
    }
    float2 _S194 = view_4.xy;
    float _S195 = dot(_S194, _S194);
    float2 _S196;
    if(_S195 > 9.99999968265522539e-21f)
    {
        _S196 = _S194 * float2(rsqrt(_S195)) ;
    }
    else
    {
        _S196 = float2(1.0f, 0.0f);
    }
    float _S197 = scale_0 * dot(light_5.xy, _S196) + shear_0 * _S192;
    float _S198 = scale_0 * (light_5.y * _S196.x - light_5.x * _S196.y);
    float _S199 = _S197 * _S197 + _S198 * _S198 + _S192 * _S192;
    return 0.31830987334251404f * scale_0 * scale_0 * _S192 / max(_S199 * _S199, 9.99999968265522539e-21f);
}

float2 sheen_with_transmittance_0(float3 light_6, float3 view_5, float strength_0, float roughness_7)
{
    float3 _S200 = sheen_lobe_0(view_5.z, roughness_7);
    float _S201 = strength_0 * _S200.z;
    return float2(_S201 * transformed_cosine_0(light_6, view_5, _S200.x, _S200.y), 1.0f - _S201);
}

VisiblePoint_0 visible_point_0(const Frame_0 thread* _S202, uint _S203, uint _S204, uint2 _S205, KernelContext_0 thread* kernelContext_13)
{
    Fabric_0 device* _S206 = kernelContext_13->fabrics_0+_S203;
    uint _S207 = 3U * _S204;
    Vertex_0 _S208 = kernelContext_13->vertices_0[kernelContext_13->corners_0[_S207]];
    Vertex_0 _S209 = kernelContext_13->vertices_0[kernelContext_13->corners_0[_S207 + 1U]];
    Vertex_0 _S210 = kernelContext_13->vertices_0[kernelContext_13->corners_0[_S207 + 2U]];
    thread Vertex_0 _S211 = _S209;
    float3 _S212 = position_of_0(&_S211);
    thread Vertex_0 _S213 = _S208;
    float3 _S214 = position_of_0(&_S213);
    float3 _S215 = _S212 - _S214;
    thread Vertex_0 _S216 = _S210;
    float3 _S217 = position_of_0(&_S216);
    float3 _S218 = _S217 - _S214;
    float3 _S219 = cross(_S215, _S218);
    float _S220 = 1.0f / max(square_0(_S219), 1.00000000317107685e-30f);
    float3 _S221 = camera_right_0(_S202);
    float _S222 = float(_S202->width_0);
    float3 _S223 = _S221 * float3((2.0f / _S222)) ;
    float3 _S224 = camera_up_0(_S202);
    float _S225 = float(_S202->height_0);
    float3 _S226 = _S224 * float3((-2.0f / _S225)) ;
    float _S227 = float(_S205.x) + 0.5f - 0.5f * _S222;
    float _S228 = float(_S205.y) + 0.5f - 0.5f * _S225;
    float3 _S229 = camera_forward_0(_S202);
    float3 _S230 = _S229 + float3(_S227)  * _S223 + float3(_S228)  * _S226;
    float _S231 = dot(_S230, _S219);
    float _S232;
    if((abs(_S231)) > 1.00000000317107685e-30f)
    {
        _S232 = _S231;
    }
    else
    {
        _S232 = 1.00000000317107685e-30f;
    }
    float _S233 = 1.0f / _S232;
    float3 _S234 = camera_origin_0(_S202);
    float3 _S235 = _S214 - _S234;
    float3 _S236 = float3((dot(_S235, _S219) * _S233)) ;
    float3 _S237 = _S230 * _S236 - _S235;
    float3 _S238 = _S236 * (_S223 - _S230 * float3((dot(_S223, _S219) * _S233)) );
    float3 _S239 = _S236 * (_S226 - _S230 * float3((dot(_S226, _S219) * _S233)) );
    float3 _S240 = float3(_S220) ;
    float3 _S241 = cross(_S218, _S219) * _S240;
    float3 _S242 = cross(_S219, _S215) * _S240;
    float _S243 = dot(_S237, _S241);
    float _S244 = dot(_S237, _S242);
    float _S245 = _S209.u_0 - _S208.u_0;
    float _S246 = _S209.v_0 - _S208.v_0;
    float2 _S247 = float2(_S245, _S246);
    float _S248 = _S210.u_0 - _S208.u_0;
    float _S249 = _S210.v_0 - _S208.v_0;
    float2 _S250 = float2(_S248, _S249);
    float2 _S251 = float2(_S208.u_0, _S208.v_0) + float2(_S243)  * _S247 + float2(_S244)  * _S250;
    float2 _S252 = float2(dot(_S238, _S241))  * _S247 + float2(dot(_S238, _S242))  * _S250;
    float2 _S253 = float2(dot(_S239, _S241))  * _S247 + float2(dot(_S239, _S242))  * _S250;
    if((_S245 * _S249 - _S246 * _S248) < 0.0f)
    {
        _S232 = -1.0f;
    }
    else
    {
        _S232 = 1.0f;
    }
    float3 _S254 = float3(_S232)  * (float3(_S249)  * _S215 - float3(_S246)  * _S218);
    float3 _S255 = float3(_S232)  * (float3(_S245)  * _S218 - float3(_S248)  * _S215);
    thread VisiblePoint_0 point_1;
    float _S256 = 1.0f - _S243 - _S244;
    thread Vertex_0 _S257 = _S208;
    float3 _S258 = normal_of_0(&_S257);
    float3 _S259 = float3(_S256)  * _S258;
    thread Vertex_0 _S260 = _S209;
    float3 _S261 = normal_of_0(&_S260);
    float3 _S262 = _S259 + float3(_S243)  * _S261;
    thread Vertex_0 _S263 = _S210;
    float3 _S264 = normal_of_0(&_S263);
    float3 _S265 = normalize(_S262 + float3(_S244)  * _S264);
    (&point_1)->normal_0 = _S265;
    float3 _S266 = normalize(_S254 - _S265 * float3(dot(_S265, _S254)) );
    (&point_1)->axis_x_0 = _S266;
    (&point_1)->axis_y_0 = cross(_S265, _S266);
    (&point_1)->position_0 = _S214 + _S237;
    (&point_1)->view_0 = - normalize(_S230);
    bool _S267 = (dot(cross(_S254, _S255), _S265)) < 0.0f;
    float _S268 = _S206->uv_width_0;
    if(_S267)
    {
        _S232 = - _S206->uv_height_0;
    }
    else
    {
        _S232 = _S206->uv_height_0;
    }
    float2 _S269 = float2(_S268, _S232);
    float2 _S270 = _S251 * _S269;
    if(_S267)
    {
        _S232 = _S206->uv_height_0;
    }
    else
    {
        _S232 = 0.0f;
    }
    (&point_1)->draft_0 = _S270 + float2(0.0f, _S232);
    (&point_1)->draft_dx_0 = _S252 * _S269;
    (&point_1)->draft_dy_0 = _S253 * _S269;
    return point_1;
}

struct YarnPoint_0
{
    bool back_2;
    bool hole_2;
    float x_9;
    float y_5;
    float height_4;
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
    float height_5;
};

float steps_per_length_0(uint _S271, float3 _S272, KernelContext_0 thread* kernelContext_14)
{
    Fabric_0 device* _S273 = kernelContext_14->fabrics_0+_S271;
    return max(max(abs(_S272.x) * _S273->threads_per_x_0, abs(_S272.y) * _S273->threads_per_y_0) * 5.0f, abs(_S272.z) * _S273->per_relief_0 * 8.0f);
}

struct ViewRayEnd_0
{
    float height_6;
    float last_step_0;
    float depth_1;
    float rate_4;
    bool smooth_0;
    PreviousSample_0 previous_3;
};

float max_height_along_0(uint _S274, float _S275, float _S276, float _S277, float3 _S278, bool _S279, KernelContext_0 thread* kernelContext_15)
{
    Fabric_0 device* _S280 = kernelContext_15->fabrics_0+_S274;
    thread Family_0 _S281 = _S280->warp_0;
    Cell_0 _S282 = locate_0(&_S281, _S275, kernelContext_15);
    uint _S283 = _S282.thread_1 / 2U;
    thread Family_0 _S284 = _S280->weft_0;
    Cell_0 _S285 = locate_0(&_S284, _S276, kernelContext_15);
    uint _S286 = _S285.thread_1 / 2U;
    float _S287 = _S278.x;
    uint _S288;
    if(_S287 > 0.0f)
    {
        _S288 = 1U;
    }
    else
    {
        _S288 = 0U;
    }
    float _S289 = _S278.y;
    uint _S290;
    if(_S289 > 0.0f)
    {
        _S290 = 2U;
    }
    else
    {
        _S290 = 0U;
    }
    uint _S291 = kernelContext_15->words_0[_S280->max_heights_0 + 4U * (_S286 * _S280->max_height_columns_0 + _S283) + (_S288 + _S290)];
    int number_0;
    if(_S279)
    {
        number_0 = int(4);
    }
    else
    {
        number_0 = int(0);
    }
    uint _S292 = _S291 >> uint(number_0);
    float _S293 = max(abs(_S287) * _S280->threads_per_x_0, abs(_S289) * _S280->threads_per_y_0) / _S278.z;
    float _S294 = _S280->height_high_0;
    float max_height_0 = _S280->height_high_0;
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
        if(((max_height_0 - _S277) * _S293) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, float((_S292 >> uint(int(8) * number_0)) & 15U) * 0.06666667014360428f * _S294);
        }
        number_0 = number_0 - int(1);
    }
    return max_height_0;
}

Crossing_0 crossing_at_0(uint _S295, float _S296, float _S297, bool _S298, KernelContext_0 thread* kernelContext_16)
{
    Fabric_0 device* _S299 = kernelContext_16->fabrics_0+_S295;
    thread Crossing_0 crossing_2;
    thread Family_0 _S300 = _S299->warp_0;
    Cell_0 _S301 = locate_0(&_S300, _S296, kernelContext_16);
    (&crossing_2)->warp_1 = _S301;
    thread Family_0 _S302 = _S299->weft_0;
    Cell_0 _S303 = locate_0(&_S302, _S297, kernelContext_16);
    (&crossing_2)->weft_1 = _S303;
    uint _S304 = _S299->run_words_0 + 2U * ((&(&crossing_2)->weft_1)->thread_1 * _S299->ends_0 + (&(&crossing_2)->warp_1)->thread_1);
    uint _S305 = kernelContext_16->words_0[_S304];
    (&crossing_2)->warp_word_0 = _S305;
    (&crossing_2)->weft_word_0 = kernelContext_16->words_0[_S304 + 1U];
    (&crossing_2)->warp_above_0 = ((_S305 & 1U) == 1U) != _S298;
    return crossing_2;
}

float cell_maximum_0(uint _S306, const Crossing_0 thread* _S307, KernelContext_0 thread* kernelContext_17)
{
    Fabric_0 device* _S308 = kernelContext_17->fabrics_0+_S306;
    if(_S307->warp_above_0)
    {
        return float((_S307->warp_word_0) >> 28U) * _S308->warp_0.height_scale_0 * _S308->warp_0.level_0;
    }
    return float((_S307->weft_word_0) >> 28U) * _S308->weft_0.height_scale_0 * _S308->weft_0.level_0;
}

float3 cell_bounds_0(uint _S309, float _S310, float _S311, bool _S312, bool _S313, bool _S314, KernelContext_0 thread* kernelContext_18)
{
    Crossing_0 _S315 = crossing_at_0(_S309, _S310, _S311, _S312, kernelContext_18);
    thread Crossing_0 _S316 = _S315;
    float _S317 = cell_maximum_0(_S309, &_S316, kernelContext_18);
    float _S318;
    if(_S313)
    {
        _S318 = _S315.warp_1.above_0;
    }
    else
    {
        _S318 = _S315.warp_1.below_0;
    }
    float _S319;
    if(_S314)
    {
        _S319 = _S315.weft_1.above_0;
    }
    else
    {
        _S319 = _S315.weft_1.below_0;
    }
    return float3(_S317, _S318, _S319);
}

float first_sample_height_0(uint _S320, const ViewRay_0 thread* _S321, const StepControl_0 thread* _S322, bool _S323, KernelContext_0 thread* kernelContext_19)
{
    float _S324 = max_height_along_0(_S320, _S321->origin_0.x, _S321->origin_0.y, 0.0f, float3(_S321->slope_0, 1.0f), _S323, kernelContext_19);
    uint count_1 = 0U;
    float height_7 = _S324;
    for(;;)
    {
        if(count_1 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S325 = ViewRay_at_0(_S321, height_7);
        float3 _S326 = cell_bounds_0(_S320, _S325.x, _S325.y, _S323, _S322->right_0, _S322->up_0, kernelContext_19);
        float _S327 = height_7 - _S326.x;
        float _S328 = StepControl_to_cell_exit_0(_S322, _S326.y, _S326.z);
        float height_8 = height_7 - clamp(_S327, 0.0f, _S328);
        if(_S327 <= _S328)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + 1U;
        height_7 = height_8;
    }
    return height_7;
}

Sample_0 sample_at_0(uint _S329, float _S330, float _S331, bool _S332, KernelContext_0 thread* kernelContext_20)
{
    Fabric_0 device* _S333 = kernelContext_20->fabrics_0+_S329;
    thread Sample_0 sample_1;
    Crossing_0 _S334 = crossing_at_0(_S329, _S330, _S331, _S332, kernelContext_20);
    (&sample_1)->crossing_1 = _S334;
    thread Crossing_0 _S335 = _S334;
    Shown_0 _S336 = shown_at_0(&_S335, _S332);
    (&sample_1)->shown_2 = _S336;
    if((&(&sample_1)->shown_2)->is_warp_0)
    {
        thread Family_0 _S337 = _S333->warp_0;
        thread Family_0 _S338 = _S333->weft_0;
        thread Cell_0 _S339 = (&(&sample_1)->crossing_1)->warp_1;
        thread Cell_0 _S340 = (&(&sample_1)->crossing_1)->weft_1;
        shape_0(&_S337, &_S338, &_S339, &_S340, &sample_1, kernelContext_20);
    }
    else
    {
        thread Family_0 _S341 = _S333->weft_0;
        thread Family_0 _S342 = _S333->warp_0;
        thread Cell_0 _S343 = (&(&sample_1)->crossing_1)->weft_1;
        thread Cell_0 _S344 = (&(&sample_1)->crossing_1)->warp_1;
        shape_0(&_S341, &_S342, &_S343, &_S344, &sample_1, kernelContext_20);
    }
    return sample_1;
}

Probe_0 probe_0(uint _S345, float _S346, float _S347, bool _S348, bool _S349, bool _S350, KernelContext_0 thread* kernelContext_21)
{
    Sample_0 _S351 = sample_at_0(_S345, _S346, _S347, _S348, kernelContext_21);
    thread Probe_0 probe_1;
    (&probe_1)->height_3 = _S351.height_2;
    (&probe_1)->hole_1 = _S351.shown_2.hole_0;
    (&probe_1)->slope_x_1 = _S351.slope_x_0;
    (&probe_1)->slope_y_1 = _S351.slope_y_0;
    uint _S352;
    if(_S351.shown_2.is_warp_0)
    {
        _S352 = _S351.crossing_1.warp_1.thread_1 * 2U + 1U;
    }
    else
    {
        _S352 = _S351.crossing_1.weft_1.thread_1 * 2U;
    }
    (&probe_1)->yarn_1 = _S352;
    thread Crossing_0 _S353 = _S351.crossing_1;
    float _S354 = cell_maximum_0(_S345, &_S353, kernelContext_21);
    (&probe_1)->cell_max_0 = _S354;
    float _S355;
    if(_S349)
    {
        _S355 = _S351.crossing_1.warp_1.above_0;
    }
    else
    {
        _S355 = _S351.crossing_1.warp_1.below_0;
    }
    (&probe_1)->side_x_1 = _S355;
    if(_S350)
    {
        _S355 = _S351.crossing_1.weft_1.above_0;
    }
    else
    {
        _S355 = _S351.crossing_1.weft_1.below_0;
    }
    (&probe_1)->side_y_1 = _S355;
    bool _S356 = !_S351.shown_2.is_warp_0;
    thread Cell_0 _S357 = _S351.crossing_1.warp_1;
    thread Shown_0 _S358 = _S351.shown_2;
    thread Run_0 _S359 = _S351.run_2;
    float _S360 = outline_distance_0(&_S357, &_S358, &_S359, _S356, _S349);
    (&probe_1)->edge_x_0 = _S360;
    thread Cell_0 _S361 = _S351.crossing_1.weft_1;
    thread Shown_0 _S362 = _S351.shown_2;
    thread Run_0 _S363 = _S351.run_2;
    float _S364 = outline_distance_0(&_S361, &_S362, &_S363, _S351.shown_2.is_warp_0, _S350);
    (&probe_1)->edge_y_0 = _S364;
    return probe_1;
}

ViewRayEnd_0 search_down_0(uint _S365, const ViewRay_0 thread* _S366, const StepControl_0 thread* _S367, bool _S368, KernelContext_0 thread* kernelContext_22)
{
    Fabric_0 device* _S369 = kernelContext_22->fabrics_0+_S365;
    float _S370 = _S369->height_low_0 - (_S369->height_high_0 - _S369->height_low_0);
    thread ViewRayEnd_0 end_1;
    float _S371 = first_sample_height_0(_S365, _S366, _S367, _S368, kernelContext_22);
    (&end_1)->height_6 = _S371;
    (&end_1)->last_step_0 = _S367->epsilon_0;
    (&end_1)->previous_3 = no_previous_sample_0();
    (&end_1)->depth_1 = 0.0f;
    (&end_1)->rate_4 = 0.0f;
    (&end_1)->smooth_0 = false;
    uint count_2 = 0U;
    for(;;)
    {
        if(count_2 < 1024U)
        {
        }
        else
        {
            break;
        }
        float2 _S372 = ViewRay_at_0(_S366, (&end_1)->height_6);
        Probe_0 _S373 = probe_0(_S365, _S372.x, _S372.y, _S368, _S367->right_0, _S367->up_0, kernelContext_22);
        float _S374 = (&end_1)->height_6 - _S373.height_3;
        thread Probe_0 _S375 = _S373;
        float _S376 = ViewRay_rate_0(_S366, &_S375);
        (&end_1)->depth_1 = - _S374;
        (&end_1)->rate_4 = _S376;
        bool _S377;
        if((&(&end_1)->previous_3)->known_0)
        {
            _S377 = !_S373.hole_1;
        }
        else
        {
            _S377 = false;
        }
        bool _S378;
        if(_S377)
        {
            _S378 = ((&(&end_1)->previous_3)->yarn_0) == (_S373.yarn_1);
        }
        else
        {
            _S378 = false;
        }
        (&end_1)->smooth_0 = _S378;
        bool _S379;
        if(!_S373.hole_1)
        {
            _S379 = _S374 <= 0.0f;
        }
        else
        {
            _S379 = false;
        }
        bool _S380;
        if(_S379)
        {
            _S380 = true;
        }
        else
        {
            _S380 = ((&end_1)->height_6) <= _S370;
        }
        if(_S380)
        {
            break;
        }
        thread PreviousSample_0 _S381 = (&end_1)->previous_3;
        thread Probe_0 _S382 = _S373;
        float _S383 = way_back_to_dip_0(&_S381, _S374, _S376, (&end_1)->last_step_0, &_S382);
        if(_S383 >= 0.0f)
        {
            (&end_1)->height_6 = (&end_1)->height_6 + _S383;
            (&end_1)->last_step_0 = (&end_1)->last_step_0 - _S383;
            count_2 = count_2 + 1U;
            continue;
        }
        float _S384 = StepControl_to_cell_exit_0(_S367, _S373.side_x_1, _S373.side_y_1);
        float _S385 = min(_S384, (&end_1)->height_6 - _S373.cell_max_0);
        thread Probe_0 _S386 = _S373;
        float _S387 = StepControl_to_next_sample_0(_S367, &_S386, _S374, _S376);
        bool _S388 = _S385 > _S387;
        thread Probe_0 _S389 = _S373;
        PreviousSample_0 _S390 = after_sample_0(_S374, _S376, &_S389, _S388);
        (&end_1)->previous_3 = _S390;
        float _S391 = max(_S385, _S387);
        (&end_1)->last_step_0 = _S391;
        (&end_1)->height_6 = (&end_1)->height_6 - _S391;
        count_2 = count_2 + 1U;
    }
    return end_1;
}

float refined_height_0(uint _S392, const ViewRay_0 thread* _S393, const StepControl_0 thread* _S394, bool _S395, const ViewRayEnd_0 thread* _S396, KernelContext_0 thread* kernelContext_23)
{
    Fabric_0 device* _S397 = kernelContext_23->fabrics_0+_S392;
    float _S398 = _S397->height_high_0 - _S397->height_low_0;
    float _S399 = _S396->height_6;
    float _S400 = _S396->last_step_0;
    float above_2 = _S396->height_6 + _S396->last_step_0;
    float above_gap_1 = clamp((&_S396->previous_3)->clearance_0, 0.0f, _S398);
    float under_gap_1 = clamp(_S396->depth_1, 0.0f, _S398);
    float _S401 = cubic_root_0(above_gap_1, - under_gap_1, (&_S396->previous_3)->rate_0 * _S396->last_step_0, _S396->rate_4 * _S396->last_step_0);
    bool _S402 = _S396->smooth_0;
    float middle_0;
    if(_S396->smooth_0)
    {
        middle_0 = above_2 - _S401 * _S400;
    }
    else
    {
        middle_0 = between_0(above_2, _S399, above_gap_1, under_gap_1);
    }
    float side_0 = 0.0f;
    float above_gap_2 = above_gap_1;
    float under_gap_2 = under_gap_1;
    float under_1 = _S399;
    float above_3 = above_2;
    uint i_1 = 0U;
    for(;;)
    {
        if(i_1 < 2U)
        {
        }
        else
        {
            break;
        }
        float2 _S403 = ViewRay_at_0(_S393, middle_0);
        Probe_0 _S404 = probe_0(_S392, _S403.x, _S403.y, _S395, _S394->right_0, _S394->up_0, kernelContext_23);
        float _S405;
        if(_S404.hole_1)
        {
            _S405 = -1.0e+09f;
        }
        else
        {
            _S405 = _S404.height_3;
        }
        float _S406 = clamp(middle_0 - _S405, - _S398, _S398);
        float _S407;
        if(_S406 <= 0.0f)
        {
            if(side_0 > 0.0f)
            {
                _S407 = 0.5f * above_gap_2;
            }
            else
            {
                _S407 = above_gap_2;
            }
            float _S408 = - _S406;
            under_1 = middle_0;
            above_gap_2 = _S407;
            under_gap_2 = _S408;
            side_0 = 1.0f;
        }
        else
        {
            if(side_0 < 0.0f)
            {
                _S407 = 0.5f * under_gap_2;
            }
            else
            {
                _S407 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S406;
            under_gap_2 = _S407;
            side_0 = -1.0f;
        }
        if(_S402)
        {
            thread Probe_0 _S409 = _S404;
            float _S410 = ViewRay_rate_0(_S393, &_S409);
            middle_0 = clamp(middle_0 + _S406 / min(_S410, -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + 1U;
    }
    if(_S402)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

bool is_free_0(uint _S411, float3 _S412, float3 _S413, bool _S414, float _S415, KernelContext_0 thread* kernelContext_24)
{
    float _S416 = _S413.z;
    if(_S416 <= 0.0f)
    {
        return false;
    }
    float _S417 = steps_per_length_0(_S411, _S413, kernelContext_24);
    float _S418 = 1.0f / max(_S417, 9.99999971718068537e-10f);
    StepControl_0 _S419 = step_control_0(_S413.xy, _S418);
    PreviousSample_0 previous_4 = no_previous_sample_0();
    uint count_3 = 0U;
    float distance_1 = 0.0f;
    float last_step_1 = 0.0f;
    for(;;)
    {
        bool _S420;
        if(count_3 < 1024U)
        {
            _S420 = (_S412.z + _S416 * distance_1) < _S415;
        }
        else
        {
            _S420 = false;
        }
        if(_S420)
        {
        }
        else
        {
            break;
        }
        float3 _S421 = _S412 + _S413 * float3(distance_1) ;
        Probe_0 _S422 = probe_0(_S411, _S421.x, _S421.y, _S414, _S419.right_0, _S419.up_0, kernelContext_24);
        float _S423 = _S421.z;
        float _S424 = _S423 - _S422.height_3;
        float _S425 = _S416 - _S422.slope_x_1 * _S413.x - _S422.slope_y_1 * _S413.y;
        bool _S426;
        if(!_S422.hole_1)
        {
            _S426 = _S424 < 0.0f;
        }
        else
        {
            _S426 = false;
        }
        if(_S426)
        {
            return false;
        }
        thread PreviousSample_0 _S427 = previous_4;
        thread Probe_0 _S428 = _S422;
        float _S429 = way_back_to_dip_0(&_S427, _S424, _S425, last_step_1, &_S428);
        if(_S429 >= 0.0f)
        {
            float last_step_2 = last_step_1 - _S429;
            distance_1 = distance_1 - _S429;
            last_step_1 = last_step_2;
            count_3 = count_3 + 1U;
            continue;
        }
        bool _S430 = _S423 > (_S422.cell_max_0);
        thread Probe_0 _S431 = _S422;
        PreviousSample_0 _S432 = after_sample_0(_S424, _S425, &_S431, _S430);
        float last_step_3;
        if(_S430)
        {
            thread StepControl_0 _S433 = _S419;
            float _S434 = StepControl_to_cell_exit_0(&_S433, _S422.side_x_1, _S422.side_y_1);
            last_step_3 = max(_S434, _S418);
        }
        else
        {
            thread StepControl_0 _S435 = _S419;
            thread Probe_0 _S436 = _S422;
            float _S437 = StepControl_to_next_sample_0(&_S435, &_S436, _S424, _S425);
            last_step_3 = _S437;
        }
        float distance_2 = distance_1 + last_step_3;
        previous_4 = _S432;
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + 1U;
    }
    return true;
}

bool passes_through_0(uint _S438, float _S439, float _S440, float3 _S441, bool _S442, KernelContext_0 thread* kernelContext_25)
{
    Fabric_0 device* _S443 = kernelContext_25->fabrics_0+_S438;
    Sample_0 _S444 = sample_at_0(_S438, _S439, _S440, _S442, kernelContext_25);
    if(!_S444.shown_2.hole_0)
    {
        return false;
    }
    float3 _S445 = float3(_S439, _S440, 0.0f);
    float _S446 = _S443->height_high_0;
    bool _S447 = is_free_0(_S438, _S445, _S441, _S442, _S443->height_high_0, kernelContext_25);
    if(!_S447)
    {
        return false;
    }
    bool _S448 = is_free_0(_S438, _S445, float3(- _S441.x, - _S441.y, _S441.z), !_S442, _S446, kernelContext_25);
    return _S448;
}

Hit_0 first_hit_0(uint _S449, float _S450, float _S451, float3 _S452, bool _S453, KernelContext_0 thread* kernelContext_26)
{
    float _S454 = max(_S452.z, 0.00009999999747379f);
    thread ViewRay_0 ray_0;
    (&ray_0)->origin_0 = float2(_S450, _S451);
    float2 _S455 = _S452.xy / float2(_S454) ;
    (&ray_0)->slope_0 = _S455;
    float2 _S456 = - _S455;
    float _S457 = steps_per_length_0(_S449, _S452, kernelContext_26);
    StepControl_0 _S458 = step_control_0(_S456, 1.0f / max(_S457 / _S454, 9.99999971718068537e-10f));
    thread ViewRay_0 _S459 = ray_0;
    thread StepControl_0 _S460 = _S458;
    ViewRayEnd_0 _S461 = search_down_0(_S449, &_S459, &_S460, _S453, kernelContext_26);
    thread Hit_0 hit_0;
    thread ViewRay_0 _S462 = ray_0;
    thread StepControl_0 _S463 = _S458;
    thread ViewRayEnd_0 _S464 = _S461;
    float _S465 = refined_height_0(_S449, &_S462, &_S463, _S453, &_S464, kernelContext_26);
    (&hit_0)->height_5 = _S465;
    thread ViewRay_0 _S466 = ray_0;
    float2 _S467 = ViewRay_at_0(&_S466, _S465);
    (&hit_0)->x_10 = _S467.x;
    (&hit_0)->y_6 = _S467.y;
    bool _S468;
    if(_S465 <= 0.0f)
    {
        bool _S469 = passes_through_0(_S449, _S450, _S451, _S452, _S453, kernelContext_26);
        _S468 = _S469;
    }
    else
    {
        _S468 = false;
    }
    (&hit_0)->hole_3 = _S468;
    return hit_0;
}

struct SurfacePoint_0
{
    bool hole_4;
    bool is_warp_1;
    uint warp_thread_0;
    uint weft_thread_0;
    float height_9;
    float3 normal_5;
    float3 tangent_5;
    float across_2;
    float fibre_across_0;
    float fibre_along_0;
};

SurfacePoint_0 surface_at_0(uint _S470, float _S471, float _S472, bool _S473, KernelContext_0 thread* kernelContext_27)
{
    Fabric_0 device* _S474 = kernelContext_27->fabrics_0+_S470;
    Sample_0 _S475 = sample_at_0(_S470, _S471, _S472, _S473, kernelContext_27);
    float _S476;
    if(_S475.shown_2.is_warp_0)
    {
        _S476 = _S475.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S476 = _S475.crossing_1.weft_1.half_width_1;
    }
    float _S477;
    if(_S475.shown_2.is_warp_0)
    {
        _S477 = _S474->warp_0.twist_sine_0;
    }
    else
    {
        _S477 = _S474->weft_0.twist_sine_0;
    }
    float _S478;
    if(_S473)
    {
        _S478 = -1.0f;
    }
    else
    {
        _S478 = 1.0f;
    }
    float _S479 = _S477 * _S478;
    if(_S475.shown_2.is_warp_0)
    {
        _S477 = _S474->warp_0.twist_cosine_0;
    }
    else
    {
        _S477 = _S474->weft_0.twist_cosine_0;
    }
    if(_S475.shown_2.is_warp_0)
    {
        _S478 = 1.0f;
    }
    else
    {
        _S478 = -1.0f;
    }
    float2 _S480 = fibre_direction_0(_S475.slope_across_0, _S478 * _S475.slope_along_0, _S479, _S477);
    float _S481;
    if(_S475.shown_2.is_warp_0)
    {
        _S481 = _S475.slope_x_0;
    }
    else
    {
        _S481 = _S475.slope_y_0;
    }
    float _S482;
    if(_S475.shown_2.is_warp_0)
    {
        _S482 = _S475.slope_y_0;
    }
    else
    {
        _S482 = _S475.slope_x_0;
    }
    float _S483 = _S480.x;
    float _S484 = _S480.y;
    float _S485 = _S481 * _S483 + _S478 * _S482 * _S484;
    float _S486 = _S476 * 1.0154266357421875f;
    float _S487 = _S486 * arc_sine_0(clamp(_S475.section_1.across_1 / _S486, -1.0f, 1.0f));
    if(_S475.shown_2.is_warp_0)
    {
        _S476 = _S472;
    }
    else
    {
        _S476 = - _S471;
    }
    thread SurfacePoint_0 point_2;
    (&point_2)->hole_4 = _S475.shown_2.hole_0;
    (&point_2)->is_warp_1 = _S475.shown_2.is_warp_0;
    (&point_2)->warp_thread_0 = _S475.crossing_1.warp_1.thread_1;
    (&point_2)->weft_thread_0 = _S475.crossing_1.weft_1.thread_1;
    (&point_2)->height_9 = _S475.height_2;
    (&point_2)->normal_5 = normalize(float3(- _S475.slope_x_0, - _S475.slope_y_0, 1.0f));
    float3 _S488;
    if(_S475.shown_2.is_warp_0)
    {
        _S488 = float3(_S483, _S484, _S485);
    }
    else
    {
        _S488 = float3(- _S484, _S483, _S485);
    }
    (&point_2)->tangent_5 = normalize(_S488);
    (&point_2)->across_2 = _S475.section_1.across_1;
    (&point_2)->fibre_across_0 = _S487 * _S477 + _S476 * _S479;
    (&point_2)->fibre_along_0 = _S476 * _S477 - _S487 * _S479;
    return point_2;
}

Albedos_0 vary_albedos_0(uint _S489, const Albedos_0 thread* _S490, uint _S491, uint _S492, KernelContext_0 thread* kernelContext_28)
{
    Fabric_0 device* _S493 = kernelContext_28->fabrics_0+_S489;
    float3 _S494 = max(_S490->specular_reflect_0, _S490->specular_transmit_0);
    float3 _S495 = _S490->diffuse_reflect_0 + _S490->diffuse_transmit_0;
    float3 _S496 = float3(_S493->layer_bound_0) ;
    float3 _S497 = float3(1.0f) ;
    float3 _S498 = float3(bounded_gain_0(thread_gain_0(_S491, _S493->colour_noise_0, _S493->seed_0), _S495, _S497 - _S496 * _S494)) ;
    float _S499 = bounded_gain_0(fibre_gain_0(_S491, _S492, _S493->fibre_noise_0, _S493->seed_0), _S494, min((_S497 - _S498 * _S495) / _S496, float3(1.0f) ));
    thread Albedos_0 varied_0;
    (&varied_0)->diffuse_reflect_0 = _S498 * _S490->diffuse_reflect_0;
    (&varied_0)->diffuse_transmit_0 = _S498 * _S490->diffuse_transmit_0;
    float3 _S500 = float3(_S499) ;
    (&varied_0)->specular_reflect_0 = _S500 * _S490->specular_reflect_0;
    (&varied_0)->specular_transmit_0 = _S500 * _S490->specular_transmit_0;
    return varied_0;
}

Albedos_0 varied_at_0(uint _S501, const SurfacePoint_0 thread* _S502, const Albedos_0 thread* _S503, float _S504, float _S505, KernelContext_0 thread* kernelContext_29)
{
    Fabric_0 device* _S506 = kernelContext_29->fabrics_0+_S501;
    bool _S507 = _S502->is_warp_1;
    float _S508;
    if(_S502->is_warp_1)
    {
        _S508 = _S504;
    }
    else
    {
        _S508 = _S505;
    }
    float _S509 = _S508 - _S502->across_2;
    if(_S507)
    {
        _S508 = _S506->warp_0.period_0;
    }
    else
    {
        _S508 = _S506->weft_0.period_0;
    }
    float _S510;
    if(_S507)
    {
        _S510 = _S506->warp_0.count_0;
    }
    else
    {
        _S510 = _S506->weft_0.count_0;
    }
    int _S511 = int(_S510);
    uint _S512;
    if(_S507)
    {
        _S512 = _S502->warp_thread_0;
    }
    else
    {
        _S512 = _S502->weft_thread_0;
    }
    uint _S513 = uint(int(floor(_S509 / _S508)) * _S511 + int(_S512)) * 2U;
    if(_S507)
    {
        _S512 = 1U;
    }
    else
    {
        _S512 = 0U;
    }
    float _S514 = floor(_S502->fibre_across_0 / _S506->fibre_size_0);
    Albedos_0 _S515 = vary_albedos_0(_S501, _S503, _S513 + _S512, uint(int(_S514)) * 65536U + uint(int(floor(_S502->fibre_along_0 / (_S506->fibre_size_0 * 40.0f) + 0.61799997091293335f * _S514))), kernelContext_29);
    return _S515;
}

YarnPoint_0 yarn_point_at_0(uint _S516, float _S517, float _S518, bool _S519, bool _S520, KernelContext_0 thread* kernelContext_30)
{
    Fabric_0 device* _S521 = kernelContext_30->fabrics_0+_S516;
    SurfacePoint_0 _S522 = surface_at_0(_S516, _S517, _S518, _S519, kernelContext_30);
    Albedos_0 albedos_2;
    if(_S522.is_warp_1)
    {
        thread Family_0 _S523 = _S521->warp_0;
        Albedos_0 _S524 = albedos_of_0(&_S523, _S522.warp_thread_0, kernelContext_30);
        albedos_2 = _S524;
    }
    else
    {
        thread Family_0 _S525 = _S521->weft_0;
        Albedos_0 _S526 = albedos_of_0(&_S525, _S522.weft_thread_0, kernelContext_30);
        albedos_2 = _S526;
    }
    bool _S527;
    if((_S521->fibre_noise_0) > 0.0f)
    {
        _S527 = true;
    }
    else
    {
        _S527 = (_S521->colour_noise_0) > 0.0f;
    }
    if(_S527)
    {
        thread SurfacePoint_0 _S528 = _S522;
        thread Albedos_0 _S529 = albedos_2;
        Albedos_0 _S530 = varied_at_0(_S516, &_S528, &_S529, _S517, _S518, kernelContext_30);
        albedos_2 = _S530;
    }
    thread YarnPoint_0 point_3;
    (&point_3)->back_2 = _S519;
    (&point_3)->hole_2 = _S520;
    (&point_3)->x_9 = _S517;
    (&point_3)->y_5 = _S518;
    (&point_3)->height_4 = _S522.height_9;
    (&point_3)->normal_4 = _S522.normal_5;
    (&point_3)->tangent_4 = _S522.tangent_5;
    float _S531;
    if(_S522.is_warp_1)
    {
        _S531 = _S521->warp_0.roughness_0;
    }
    else
    {
        _S531 = _S521->weft_0.roughness_0;
    }
    (&point_3)->roughness_8 = _S531;
    (&point_3)->albedos_1 = albedos_2;
    return point_3;
}

YarnPoint_0 locate_yarn_0(uint _S532, float _S533, float _S534, float3 _S535, KernelContext_0 thread* kernelContext_31)
{
    bool _S536 = (_S535.z) < 0.0f;
    Hit_0 _S537 = first_hit_0(_S532, _S533, _S534, to_face_frame_0(_S535, _S536), _S536, kernelContext_31);
    YarnPoint_0 _S538 = yarn_point_at_0(_S532, _S537.x_10, _S537.y_6, _S536, _S537.hole_3, kernelContext_31);
    return _S538;
}

float3 scattered_0(uint _S539, const YarnPoint_0 thread* _S540, float3 _S541, float3 _S542, KernelContext_0 thread* kernelContext_32)
{
    Fabric_0 device* _S543 = kernelContext_32->fabrics_0+_S539;
    float3 _S544 = float3(0.0f) ;
    bool _S545 = !_S540->hole_2;
    bool _S546;
    if(_S545)
    {
        _S546 = (_S541.z) > 0.0f;
    }
    else
    {
        _S546 = false;
    }
    float3 value_1;
    if(_S546)
    {
        value_1 = (&_S540->albedos_1)->diffuse_reflect_0 * float3(diffuse_reflection_0(_S541, _S540->normal_4, _S543->diffuse_blend_0))  + (&_S540->albedos_1)->specular_reflect_0 * float3(reflection_0(_S541, _S542, _S540->normal_4, _S540->tangent_4, _S540->roughness_8, _S543->optical_depth_0)) ;
    }
    else
    {
        if(_S545)
        {
            _S546 = (_S541.z) < 0.0f;
        }
        else
        {
            _S546 = false;
        }
        if(_S546)
        {
            value_1 = (&_S540->albedos_1)->diffuse_transmit_0 * float3(diffuse_reflection_0(- _S541, _S540->normal_4, _S543->diffuse_blend_0))  + (&_S540->albedos_1)->specular_transmit_0 * float3(transmission_0(_S541, _S542, _S540->normal_4, _S540->tangent_4, _S540->roughness_8, _S543->optical_depth_0)) ;
        }
        else
        {
            value_1 = _S544;
        }
    }
    float _S547 = _S543->sheen_strength_0;
    if((_S543->sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    float2 _S548 = sheen_with_transmittance_0(_S541, _S542, _S547, _S543->sheen_roughness_0);
    return float3(_S548.y)  * value_1 + float3(_S548.x) ;
}

bool unoccluded_0(uint _S549, float _S550, float _S551, float _S552, float3 _S553, bool _S554, KernelContext_0 thread* kernelContext_33)
{
    Fabric_0 device* _S555 = kernelContext_33->fabrics_0+_S549;
    if((_S553.z) <= 0.0f)
    {
        return false;
    }
    float _S556 = max_height_along_0(_S549, _S550, _S551, _S552, _S553, _S554, kernelContext_33);
    bool _S557 = is_free_0(_S549, float3(_S550, _S551, _S552 + _S555->lift_0), _S553, _S554, _S556, kernelContext_33);
    return _S557;
}

bool is_lit_0(uint _S558, const YarnPoint_0 thread* _S559, float3 _S560, KernelContext_0 thread* kernelContext_34)
{
    if(_S559->hole_2)
    {
        return true;
    }
    bool _S561 = _S559->back_2;
    float3 _S562 = to_face_frame_0(_S560, _S559->back_2);
    float _S563 = _S562.z;
    bool _S564 = _S563 < 0.0f;
    float3 _S565 = _S559->normal_4;
    float _S566 = _S559->height_4;
    float3 normal_6;
    float height_10;
    if(_S564)
    {
        SurfacePoint_0 _S567 = surface_at_0(_S558, _S559->x_9, _S559->y_5, !_S561, kernelContext_34);
        normal_6 = _S567.normal_5;
        height_10 = _S567.height_9;
    }
    else
    {
        normal_6 = _S565;
        height_10 = _S566;
    }
    float3 _S568 = float3(_S562.xy, abs(_S563));
    if((dot(normal_6, _S568)) <= 0.0f)
    {
        return false;
    }
    bool _S569 = unoccluded_0(_S558, _S559->x_9, _S559->y_5, height_10, _S568, _S561 != _S564, kernelContext_34);
    return _S569;
}

float3 evaluate_0(uint _S570, const YarnPoint_0 thread* _S571, float3 _S572, float3 _S573, KernelContext_0 thread* kernelContext_35)
{
    float3 _S574 = scattered_0(_S570, _S571, to_face_frame_0(_S572, _S571->back_2), to_face_frame_0(_S573, _S571->back_2), kernelContext_35);
    bool _S575;
    if((max(_S574.x, max(_S574.y, _S574.z))) <= 0.0f)
    {
        _S575 = true;
    }
    else
    {
        bool _S576 = is_lit_0(_S570, _S571, _S572, kernelContext_35);
        _S575 = !_S576;
    }
    if(_S575)
    {
        return float3(0.0f) ;
    }
    return _S574;
}

float straight_through_0(uint _S577, const YarnPoint_0 thread* _S578, float3 _S579, KernelContext_0 thread* kernelContext_36)
{
    Fabric_0 device* _S580 = kernelContext_36->fabrics_0+_S577;
    if(!_S578->hole_2)
    {
        return 0.0f;
    }
    float _S581 = _S580->sheen_strength_0;
    if((_S580->sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S581 * sheen_lobe_0(abs(_S579.z), _S580->sheen_roughness_0).z;
}

float4 direct_light_0(const Frame_0 thread* _S582, uint _S583, const VisiblePoint_0 thread* _S584, float2 _S585, KernelContext_0 thread* kernelContext_37)
{
    float3 _S586 = to_local_0(_S584, _S584->view_0);
    YarnPoint_0 _S587 = locate_yarn_0(_S583, _S585.x, _S585.y, _S586, kernelContext_37);
    float3 _S588 = float3(0.0f) ;
    uint number_1 = 0U;
    float3 radiance_1 = _S588;
    for(;;)
    {
        if(number_1 < (_S582->lights_0))
        {
        }
        else
        {
            break;
        }
        thread Light_0 _S589 = kernelContext_37->lights_1[number_1];
        thread float3 irradiance_1;
        float3 _S590 = towards_light_0(&_S589, _S584->position_0, &irradiance_1);
        float3 _S591 = to_local_0(_S584, _S590);
        thread YarnPoint_0 _S592 = _S587;
        float3 _S593 = evaluate_0(_S583, &_S592, _S591, _S586, kernelContext_37);
        float3 radiance_2 = radiance_1 + irradiance_1 * _S593;
        number_1 = number_1 + 1U;
        radiance_1 = radiance_2;
    }
    thread YarnPoint_0 _S594 = _S587;
    float _S595 = straight_through_0(_S583, &_S594, _S586, kernelContext_37);
    return float4(radiance_1, 1.0f - _S595);
}

[[kernel]] void shade(uint3 id_0 [[thread_position_in_grid]], Frame_0 device* frames_1 [[buffer(3)]], texture2d<uint, access::sample> visible_faces_1 [[texture(0)]], uint device* face_fabrics_1 [[buffer(6)]], Fabric_0 device* fabrics_1 [[buffer(0)]], uint device* corners_1 [[buffer(5)]], Vertex_0 device* vertices_1 [[buffer(4)]], uint device* words_1 [[buffer(1)]], Light_0 device* lights_2 [[buffer(2)]], packed_float4 device* radiance_3 [[buffer(7)]])
{
    uint _S596;
    thread KernelContext_0 kernelContext_38;
    (&kernelContext_38)->frames_0 = frames_1;
    (&kernelContext_38)->visible_faces_0 = visible_faces_1;
    (&kernelContext_38)->face_fabrics_0 = face_fabrics_1;
    (&kernelContext_38)->fabrics_0 = fabrics_1;
    (&kernelContext_38)->corners_0 = corners_1;
    (&kernelContext_38)->vertices_0 = vertices_1;
    (&kernelContext_38)->words_0 = words_1;
    (&kernelContext_38)->lights_1 = lights_2;
    (&kernelContext_38)->radiance_0 = radiance_3;
    Frame_0 _S597 = frames_1[int(0)];
    bool _S598;
    if((id_0.x) >= (_S597.width_0))
    {
        _S598 = true;
    }
    else
    {
        _S598 = (id_0.y) >= (_S597.height_0);
    }
    if(_S598)
    {
        return;
    }
    uint2 _S599 = id_0.xy;
    uint _S600 = _S599.y * _S597.width_0 + _S599.x;
    int3 _S601 = int3(int2(_S599), int(0));
    uint _S602 = (((&kernelContext_38)->visible_faces_0).read(vec<uint,2>(((_S601)).xy), uint(((_S601)).z)).x);
    thread float4 sum_0 = float4(0.0f) ;
    if(_S602 > 0U)
    {
        uint _S603 = _S602 - 1U;
        uint _S604 = (&kernelContext_38)->face_fabrics_0[_S603];
        thread Frame_0 _S605 = _S597;
        VisiblePoint_0 _S606 = visible_point_0(&_S605, _S604, _S603, _S599, &kernelContext_38);
        uint k_0 = 0U;
        for(;;)
        {
            _S596 = _S597.samples_0;
            if(k_0 < (_S597.samples_0))
            {
            }
            else
            {
                break;
            }
            float2 _S607 = footprint_sample_0(_S599, _S597.pass_number_0 * _S597.samples_0 + k_0);
            float2 _S608 = _S606.draft_0 + float2(_S607.x)  * _S606.draft_dx_0 + float2(_S607.y)  * _S606.draft_dy_0;
            thread Frame_0 _S609 = _S597;
            thread VisiblePoint_0 _S610 = _S606;
            float4 _S611 = direct_light_0(&_S609, _S604, &_S610, _S608, &kernelContext_38);
            sum_0 = sum_0 + _S611;
            k_0 = k_0 + 1U;
        }
        sum_0 = sum_0 / float4(float(_S596)) ;
    }
    sum_0.xyz = sum_0.xyz + float3((1.0f - sum_0.w))  * float3(_S597.background_red_0, _S597.background_green_0, _S597.background_blue_0);
    packed_float4 device* _S612 = (&kernelContext_38)->radiance_0+_S600;
    float4 _S613;
    if((_S597.pass_number_0) == 0U)
    {
        _S613 = sum_0;
    }
    else
    {
        _S613 = float4(*((&kernelContext_38)->radiance_0+_S600))  + sum_0;
    }
    *_S612 = packed_float4(_S613) ;
    return;
}

