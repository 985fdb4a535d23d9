@binding(1) @group(1) var<storage, read> query_count_0 : array<u32>;

struct Query_std430_0
{
    @align(4) fabric_0 : u32,
    @align(4) centre_x_0 : f32,
    @align(4) centre_y_0 : f32,
    @align(4) dx_x_0 : f32,
    @align(4) dx_y_0 : f32,
    @align(4) dy_x_0 : f32,
    @align(4) dy_y_0 : f32,
    @align(4) light_x_0 : f32,
    @align(4) light_y_0 : f32,
    @align(4) light_z_0 : f32,
    @align(4) view_x_0 : f32,
    @align(4) view_y_0 : f32,
    @align(4) view_z_0 : f32,
};

@binding(0) @group(1) var<storage, read> queries_0 : array<Query_std430_0>;

@binding(2) @group(1) var<storage, read_write> answers_0 : array<vec4<f32>>;

struct Lobes_std430_0
{
    @align(4) is_baked_0 : u32,
    @align(4) inverse_base_size_0 : f32,
    @align(4) last_level_0 : f32,
    @align(4) levels_0 : u32,
    @align(4) face_nodes_0 : u32,
    @align(4) packs_0 : u32,
    @align(4) front_warp_packs_0 : u32,
    @align(4) back_warp_packs_0 : u32,
    @align(4) coverage_0 : u32,
    @align(4) coverage_holes_0 : u32,
    @align(4) projected_area_0 : u32,
    @align(4) light_visibility_0 : u32,
    @align(4) irradiance_0 : u32,
    @align(4) moments_0 : u32,
    @align(4) front_hole_weight_0 : f32,
    @align(4) back_hole_weight_0 : f32,
    @align(4) threads_per_mm_0 : f32,
    @align(4) unit_level_0 : f32,
};

struct Woven_std430_0
{
    @align(4) is_encoded_0 : u32,
    @align(4) network_0 : u32,
    @align(4) latents_0 : u32,
    @align(4) texels_0 : u32,
    @align(4) levels_1 : u32,
    @align(4) top_level_0 : u32,
    @align(4) ends_0 : f32,
    @align(4) picks_0 : f32,
    @align(4) ends_per_mm_0 : f32,
    @align(4) picks_per_mm_0 : f32,
    @align(4) pitch_0 : f32,
    @align(4) warp_x_0 : f32,
    @align(4) warp_y_0 : f32,
    @align(4) warp_roughness_0 : f32,
    @align(4) weft_x_0 : f32,
    @align(4) weft_y_0 : f32,
    @align(4) weft_roughness_0 : f32,
    @align(4) warp_lobe_roughness_0 : f32,
    @align(4) weft_lobe_roughness_0 : f32,
    @align(4) bundles_0 : u32,
    @align(4) is_corrected_0 : u32,
    @align(4) correction_0 : u32,
};

struct Neumip_std430_0
{
    @align(4) is_trained_0 : u32,
    @align(4) decoder_0 : u32,
    @align(4) has_offset_0 : u32,
    @align(4) offset_0 : u32,
    @align(4) offset_texels_0 : u32,
    @align(4) features_0 : u32,
    @align(4) texel_elements_0 : u32,
    @align(4) levels_2 : u32,
    @align(4) last_level_1 : f32,
    @align(4) face_texels_0 : u32,
    @align(4) back_0 : u32,
    @align(4) repeats_per_x_0 : f32,
    @align(4) repeats_per_y_0 : f32,
    @align(4) texels_per_mm_0 : f32,
    @align(4) unit_x_0 : f32,
    @align(4) unit_y_0 : f32,
};

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) woven_0 : Woven_std430_0,
    @align(4) neumip_0 : Neumip_std430_0,
    @align(4) run_words_0 : u32,
    @align(4) ends_1 : u32,
    @align(4) max_heights_0 : u32,
    @align(4) max_height_columns_0 : u32,
    @align(4) height_low_0 : f32,
    @align(4) height_high_0 : f32,
    @align(4) lift_0 : f32,
    @align(4) threads_per_x_0 : f32,
    @align(4) threads_per_y_0 : f32,
    @align(4) per_relief_0 : f32,
    @align(4) diffuse_blend_0 : f32,
    @align(4) optical_depth_0 : f32,
    @align(4) sheen_strength_0 : f32,
    @align(4) sheen_roughness_0 : f32,
    @align(4) fibre_noise_0 : f32,
    @align(4) colour_noise_0 : f32,
    @align(4) seed_0 : u32,
    @align(4) layer_bound_0 : f32,
    @align(4) fibre_size_0 : f32,
    @align(4) uv_width_0 : f32,
    @align(4) uv_height_0 : f32,
    @align(4) is_open_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
};

@binding(0) @group(0) var<storage, read> fabrics_0 : array<Fabric_std430_0>;

struct Family_std430_0
{
    @align(4) is_alike_0 : u32,
    @align(4) count_0 : f32,
    @align(4) inverse_count_0 : f32,
    @align(4) half_inverse_count_0 : f32,
    @align(4) size_0 : f32,
    @align(4) inverse_size_0 : f32,
    @align(4) half_width_0 : f32,
    @align(4) start_0 : f32,
    @align(4) period_0 : f32,
    @align(4) inverse_period_0 : f32,
    @align(4) bins_0 : f32,
    @align(4) first_thread_table_0 : u32,
    @align(4) place_table_0 : u32,
    @align(4) bend_table_0 : u32,
    @align(4) height_scale_0 : f32,
    @align(4) twist_sine_0 : f32,
    @align(4) twist_cosine_0 : f32,
    @align(4) level_0 : f32,
    @align(4) roughness_0 : f32,
    @align(4) albedo_table_0 : u32,
    @align(4) albedo_stride_0 : u32,
    @align(4) before_0 : u32,
    @align(4) visible_total_0 : f32,
    @align(4) smallest_box_0 : f32,
    @align(4) quantities_0 : u32,
    @align(4) colour_mean_0 : u32,
    @align(4) colour_axes_0 : u32,
    @align(4) colour_threads_0 : u32,
    @align(4) colour_areas_0 : u32,
    @align(4) area_unit_0 : f32,
    @align(4) crossing_area_0 : f32,
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn default_quality_0() -> SearchQuality_0
{
    var quality_0 : SearchQuality_0;
    quality_0.steps_per_thread_0 = 5.0f;
    quality_0.steps_per_relief_0 = 8.0f;
    quality_0.shadow_share_0 = 1.0f;
    quality_0.refinements_0 = u32(2);
    return quality_0;
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_1 : bool) -> vec3<f32>
{
    var _S1 : vec2<f32> = direction_0.xy;
    var _S2 : f32;
    if(back_1)
    {
        _S2 = - direction_0.z;
    }
    else
    {
        _S2 = direction_0.z;
    }
    return vec3<f32>(_S1, _S2);
}

fn turns_and_remainder_0( family_0 : u32,  index_0 : f32) -> vec2<f32>
{
    var _S3 : f32 = floor(fma(index_0, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S3, fma(- _S3, families_0[family_0].count_0, index_0));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_0 : f32) -> Cell_0
{
    var _S4 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S5 : f32 = fma(- _S4, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S5;
    cell_0.above_0 = families_0[family_1].size_0 - _S5;
    cell_0.across_0 = _S5 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S4).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn locate_varied_0( family_2 : u32,  position_1 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_1 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S6 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S7 : u32;
    if(_S6 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S7 = u32(1);
    }
    else
    {
        _S7 = u32(0);
    }
    var _S8 : u32 = min(thread_1 + _S7, u32(families_0[family_2].count_0) - u32(1));
    var _S9 : u32 = families_0[family_2].place_table_0 + _S8 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S8;
    cell_1.below_0 = _S6 - table_number_0(_S9);
    cell_1.above_0 = table_number_0(_S9 + u32(1)) - _S6;
    cell_1.across_0 = _S6 - table_number_0(_S9 + u32(2));
    cell_1.half_width_1 = table_number_0(_S9 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_2 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_2);
    }
    return locate_varied_0(family_3, position_2);
}

struct Shown_0
{
     is_warp_0 : bool,
     hole_0 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_1 : Cell_0,
     weft_1 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_0 : Crossing_0,  back_2 : bool) -> Shown_0
{
    var _S10 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S11 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S12 : bool;
    if(_S10)
    {
        if(!_S11)
        {
            _S12 = true;
        }
        else
        {
            _S12 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S12 = false;
    }
    shown_0.is_warp_0 = _S12;
    if(!_S10)
    {
        _S12 = !_S11;
    }
    else
    {
        _S12 = false;
    }
    shown_0.hole_0 = _S12;
    var _S13 : u32;
    if(shown_0.is_warp_0)
    {
        _S13 = crossing_0.warp_word_0;
    }
    else
    {
        _S13 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S13;
    shown_0.on_top_0 = (((_S13 & (u32(1)))) == u32(1)) != back_2;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    var _S14 : u32;
    if(is_first_0)
    {
        _S14 = first_0.thread_0;
    }
    else
    {
        _S14 = second_0.thread_0;
    }
    cell_2.thread_0 = _S14;
    var _S15 : f32;
    if(is_first_0)
    {
        _S15 = first_0.across_0;
    }
    else
    {
        _S15 = second_0.across_0;
    }
    cell_2.across_0 = _S15;
    if(is_first_0)
    {
        _S15 = first_0.half_width_1;
    }
    else
    {
        _S15 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S15;
    if(is_first_0)
    {
        _S15 = first_0.below_0;
    }
    else
    {
        _S15 = second_0.below_0;
    }
    cell_2.below_0 = _S15;
    if(is_first_0)
    {
        _S15 = first_0.above_0;
    }
    else
    {
        _S15 = second_0.above_0;
    }
    cell_2.above_0 = _S15;
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S16 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S16.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S16.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_3 : u32,  first_1 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_1) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_3, last_0) - boundary_0(family_5, thread_3, first_1);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_4 : u32) -> Bend_0
{
    var _S17 : Family_std430_0 = families_0[family_6];
    var _S18 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S18 = u32(0);
    }
    else
    {
        _S18 = thread_4 * u32(4);
    }
    var _S19 : u32 = _S17.bend_table_0 + _S18;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S19);
    bend_0.half_tangent_0 = table_number_0(_S19 + u32(1));
    bend_0.arc_0 = table_number_0(_S19 + u32(2));
    return bend_0;
}

struct Run_0
{
     distance_0 : f32,
     near_start_0 : bool,
     from_start_0 : f32,
     to_end_0 : f32,
     reach_0 : f32,
     other_reach_0 : f32,
     bend_1 : Bend_0,
     straight_0 : bool,
     first_crossing_0 : bool,
     last_crossing_0 : bool,
};

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_5 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S20 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S21 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S22 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S23 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S24 : i32 = - _S20;
    var _S25 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S24, i32(0));
    run_0.from_start_0 = _S25;
    var _S26 : i32 = _S21 + i32(1);
    var _S27 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S26);
    run_0.to_end_0 = _S27;
    var _S28 : bool = _S25 < _S27;
    run_0.near_start_0 = _S28;
    var _S29 : i32;
    if(_S28)
    {
        _S29 = _S24 - _S22;
    }
    else
    {
        _S29 = _S26;
    }
    var _S30 : i32;
    if(run_0.near_start_0)
    {
        _S30 = _S24;
    }
    else
    {
        _S30 = _S26 + _S23;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    var _S31 : f32;
    if(run_0.straight_0)
    {
        _S31 = 1.0e+06f;
    }
    else
    {
        _S31 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S31;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S29, _S30), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S20 == i32(0);
    run_0.last_crossing_0 = _S21 == i32(0);
    return run_0;
}

fn square_0( x_1 : f32) -> f32
{
    return x_1 * x_1;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_3 : Cell_0) -> Section_0
{
    var _S32 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S33 : f32 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S33;
    var _S34 : f32 = _S32 * _S32 - square_0(_S33);
    var _S35 : f32 = rsqrt_0(_S34);
    section_0.drop_0 = _S32 - _S34 * _S35;
    section_0.slope_0 = - _S33 * _S35;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_6 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_6) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S36 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S37 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S38 : f32;
    if(_S36)
    {
        _S38 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S38 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S39 : f32 = _S38 - crossed_1.half_width_1;
    var _S40 : bool;
    if(_S36)
    {
        _S40 = run_1.first_crossing_0;
    }
    else
    {
        _S40 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S38 = 0.0f;
    }
    else
    {
        _S38 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S41 : f32;
    if((shown_1.on_top_0) != _S40)
    {
        _S41 = 0.0f;
    }
    else
    {
        var _S42 : Family_std430_0 = families_0[other_1];
        var _S43 : i32;
        if(_S36)
        {
            _S43 = i32(-1);
        }
        else
        {
            _S43 = i32(1);
        }
        _S41 = _S42.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S43);
    }
    var _S44 : f32 = 1.0f / max(2.0f * _S39, 9.999999960041972e-13f);
    var _S45 : f32 = clamp((_S39 - _S37) * _S44, 0.0f, 1.0f);
    var _S46 : f32 = _S38 + (_S41 - _S38) * (_S45 * _S45 * (3.0f - 2.0f * _S45));
    var _S47 : f32 = (_S38 - _S41) * (6.0f * _S45 * (1.0f - _S45) * _S44);
    if(_S36)
    {
        _S38 = 1.0f;
    }
    else
    {
        _S38 = -1.0f;
    }
    return vec2<f32>(_S46, _S47 * _S38);
}

struct StepControl_0
{
     step_2 : f32,
     epsilon_0 : f32,
     per_x_0 : f32,
     per_y_0 : f32,
     right_0 : bool,
     up_0 : bool,
};

fn step_control_0( direction_1 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S48 : f32 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S48), 9.99999971718068537e-10f);
    var _S49 : f32 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S49), 9.99999971718068537e-10f);
    control_0.right_0 = _S48 > 0.0f;
    control_0.up_0 = _S49 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
     clearance_0 : f32,
     rate_0 : f32,
     yarn_0 : u32,
     known_0 : bool,
};

fn no_previous_sample_0() -> PreviousSample_0
{
    var previous_0 : PreviousSample_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_0 = u32(0);
    previous_0.known_0 = false;
    return previous_0;
}

fn outline_distance_0( cell_4 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S50 : f32;
    if(forwards_0)
    {
        _S50 = cell_4.across_0;
    }
    else
    {
        _S50 = - cell_4.across_0;
    }
    var _S51 : f32;
    if(forwards_0)
    {
        _S51 = cell_4.above_0;
    }
    else
    {
        _S51 = cell_4.below_0;
    }
    var _S52 : bool;
    if(forwards_0)
    {
        _S52 = run_2.last_crossing_0;
    }
    else
    {
        _S52 = run_2.first_crossing_0;
    }
    var _S53 : bool;
    if(forwards_0)
    {
        _S53 = run_2.first_crossing_0;
    }
    else
    {
        _S53 = run_2.last_crossing_0;
    }
    var _S54 : f32 = - cell_4.half_width_1;
    var _S55 : bool = _S50 < _S54;
    var _S56 : bool = _S50 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S52 = !_S52;
    }
    else
    {
        _S52 = false;
    }
    if(_S52)
    {
        _S52 = !shown_2.hole_0;
    }
    else
    {
        _S52 = false;
    }
    var _S57 : bool;
    if(_S52)
    {
        _S57 = shown_2.on_top_0;
    }
    else
    {
        _S57 = false;
    }
    if(_S57)
    {
        if(_S53)
        {
            _S53 = _S55;
        }
        else
        {
            _S53 = false;
        }
        _S53 = !_S53;
    }
    else
    {
        _S53 = false;
    }
    if(shown_2.hole_0)
    {
        _S52 = true;
    }
    else
    {
        if(_S52)
        {
            _S52 = !shown_2.on_top_0;
        }
        else
        {
            _S52 = false;
        }
    }
    var _S58 : f32;
    if(_S55)
    {
        _S58 = _S54;
    }
    else
    {
        _S58 = cell_4.half_width_1;
    }
    var _S59 : f32 = _S58 - _S50;
    if(_S52)
    {
        _S50 = 2.0f * _S51 + _S50 - cell_4.half_width_1;
    }
    else
    {
        _S50 = _S51;
    }
    if(_S53)
    {
        if(forwards_0)
        {
            _S50 = run_2.to_end_0;
        }
        else
        {
            _S50 = run_2.from_start_0;
        }
        return _S50;
    }
    if(_S56)
    {
    }
    else
    {
        _S50 = _S59;
    }
    return _S50;
}

struct Probe_0
{
     height_0 : f32,
     hole_1 : bool,
     slope_x_0 : f32,
     slope_y_0 : f32,
     yarn_1 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_0 : Probe_0) -> f32
{
    var _S60 : f32 = previous_1.rate_0 * step_4;
    var _S61 : f32 = rate_1 * step_4;
    var _S62 : bool;
    if(!previous_1.known_0)
    {
        _S62 = true;
    }
    else
    {
        _S62 = here_0.hole_1;
    }
    if(_S62)
    {
        _S62 = true;
    }
    else
    {
        _S62 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S62)
    {
        _S62 = true;
    }
    else
    {
        _S62 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S62)
    {
        _S62 = true;
    }
    else
    {
        _S62 = rate_1 <= 0.0f;
    }
    if(_S62)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S60) >= 0.0f)
    {
        _S62 = (3.0f * clearance_1 - _S61) >= 0.0f;
    }
    else
    {
        _S62 = false;
    }
    if(_S62)
    {
        return -1.0f;
    }
    var _S63 : f32 = clearance_1 - previous_1.clearance_0;
    var _S64 : f32 = 6.0f * _S63 - 4.0f * _S60 - 2.0f * _S61;
    var _S65 : f32 = -2.0f * _S60 / max(_S64 + sqrt(max(_S64 * _S64 - 4.0f * (3.0f * (_S60 + _S61 - 2.0f * _S63)) * _S60, 0.0f)), 9.99999968265522539e-21f);
    var _S66 : f32 = 1.0f - _S65;
    var _S67 : f32 = (previous_1.clearance_0 * (2.0f * _S65 + 1.0f) + _S60 * _S65) * _S66 * _S66;
    var _S68 : f32 = (clearance_1 * (2.0f * _S66 + 1.0f) - _S61 * _S66) * _S65 * _S65;
    if(_S65 > 0.01999999955296516f)
    {
        _S62 = _S66 > 0.01999999955296516f;
    }
    else
    {
        _S62 = false;
    }
    if(_S62)
    {
        _S62 = (_S67 + _S68) < 0.0f;
    }
    else
    {
        _S62 = false;
    }
    var _S69 : f32;
    if(_S62)
    {
        _S69 = _S66 * step_4;
    }
    else
    {
        _S69 = -1.0f;
    }
    return _S69;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S70 : f32;
    if(here_1.hole_1)
    {
        _S70 = 1.0e+09f;
    }
    else
    {
        _S70 = clearance_2;
    }
    previous_2.clearance_0 = _S70;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S71 : bool;
    if(!here_1.hole_1)
    {
        _S71 = !is_cell_exit_0;
    }
    else
    {
        _S71 = false;
    }
    previous_2.known_0 = _S71;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_0 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

fn StepControl_to_next_sample_0( this_1 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S72 : f32 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    var _S73 : bool;
    if(!here_2.hole_1)
    {
        _S73 = (rate_3 * _S72 + clearance_3) < 0.0f;
    }
    else
    {
        _S73 = false;
    }
    if(_S73)
    {
        _S73 = _S72 > (2.0f * this_1.epsilon_0);
    }
    else
    {
        _S73 = false;
    }
    var _S74 : f32;
    if(_S73)
    {
        _S74 = _S72 - this_1.epsilon_0;
    }
    else
    {
        _S74 = max(_S72, 0.0f) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S74);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_2 : ViewRay_0,  height_1 : f32) -> vec2<f32>
{
    return this_2.origin_0 + this_2.slope_1 * vec2<f32>(height_1);
}

fn ViewRay_rate_0( this_3 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_3.slope_1.x + here_3.slope_y_0 * this_3.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S75 : f32 = end_0 - start_1;
    var _S76 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S75;
    var _S77 : f32 = 3.0f * _S75 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S75, 9.99999968265522539e-21f);
    var i_0 : i32 = i32(0);
    for(;;)
    {
        if(u32(i_0) < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S78 : f32 = clamp(share_0 - (((_S76 * share_0 + _S77) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S76 * share_0 + 2.0f * _S77) * share_0 + start_rate_0, 0.10000000149011612f * _S75 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S79 : i32 = i_0 + i32(1);
        share_0 = _S78;
        i_0 = _S79;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S80 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S81 : f32 = rsqrt_0(_S80);
    var _S82 : f32 = sine_1 * _S81 * rsqrt_0(_S80 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S82 * _S80, _S82 * across_slope_0 * along_slope_0 + cosine_0 * _S81);
}

fn arc_sine_0( x_2 : f32) -> f32
{
    var _S83 : f32 = abs(x_2);
    var _S84 : bool = _S83 > 0.5f;
    var _S85 : f32;
    if(_S84)
    {
        _S85 = 0.5f * (1.0f - _S83);
    }
    else
    {
        _S85 = _S83 * _S83;
    }
    var _S86 : f32;
    if(_S84)
    {
        _S86 = sqrt(max(_S85, 0.0f));
    }
    else
    {
        _S86 = _S83;
    }
    var _S87 : f32 = ((((0.04216320067644119f * _S85 + 0.02418131195008755f) * _S85 + 0.04547002539038658f) * _S85 + 0.07495300471782684f) * _S85 + 0.16666752099990845f) * _S85 * _S86 + _S86;
    if(_S84)
    {
        _S85 = 1.57079637050628662f - 2.0f * _S87;
    }
    else
    {
        _S85 = _S87;
    }
    if(x_2 < 0.0f)
    {
        _S85 = - _S85;
    }
    return _S85;
}

fn table_colour_0( index_2 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_2), table_number_0(index_2 + u32(1)), table_number_0(index_2 + u32(2)));
}

struct Albedos_0
{
     diffuse_reflect_0 : vec3<f32>,
     diffuse_transmit_0 : vec3<f32>,
     specular_reflect_0 : vec3<f32>,
     specular_transmit_0 : vec3<f32>,
};

fn table_albedos_0( row_0 : u32) -> Albedos_0
{
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(row_0);
    albedos_0.diffuse_transmit_0 = table_colour_0(row_0 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(row_0 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(row_0 + u32(9));
    return albedos_0;
}

fn albedos_of_0( family_8 : u32,  thread_7 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_7);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S88 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S89 : u32 = ((((_S88 >> ((((_S88 >> (u32(28)))) + u32(4))))) ^ (_S88))) * u32(277803737);
    return (((_S89 >> (u32(22)))) ^ (_S89));
}

fn uniform_hash_0( thread_8 : u32,  cell_5 : u32,  stream_0 : u32) -> f32
{
    return (f32(((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_9 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_0 : f32,  albedo_0 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S90 : vec3<f32> = room_0 / max(albedo_0, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_0, max(min(min(_S90.x, _S90.y), _S90.z), 0.0f));
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S91 : u32 = (bitcast<u32>((x_3)));
    var exponent_0 : f32 = f32(i32((_S91 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S91 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var exponent_1 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var exponent_2 : f32 = exponent_0 - 1.0f;
        m_1 = m_0 + m_0;
        exponent_1 = exponent_2;
    }
    else
    {
        m_1 = m_0;
        exponent_1 = exponent_0;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var _S92 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S92 - exponent_1 * 0.00021219444170129f - 0.5f * _S92) + exponent_1 * 0.693359375f;
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn diffuse_reflection_0( light_0 : vec3<f32>,  normal_0 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S93 : f32 = light_0.z;
    if(_S93 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S93, 0.0f), max(dot(light_0, normal_0), 0.0f), blend_0);
}

fn projected_area_1( direction_2 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S94 : f32 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S94 * _S94 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_4 : f32) -> f32
{
    var _S95 : f32 = clamp(x_4, -87.0f, 88.0f);
    var _S96 : f32 = floor(_S95 * 1.4426950216293335f + 0.5f);
    var _S97 : f32 = _S95 - _S96 * 0.693359375f + _S96 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S97 + 0.00139819993637502f) * _S97 + 0.00833345204591751f) * _S97 + 0.04166579619050026f) * _S97 + 0.1666666567325592f) * _S97 + 0.5f;
    var _S98 : f32 = (bitcast<f32>(((u32(i32(_S96) + i32(127)) << (u32(23))))));
    var _S99 : f32;
    if(x_4 < -87.0f)
    {
        _S99 = 0.0f;
    }
    else
    {
        _S99 = (p_0 * _S97 * _S97 + _S97 + 1.0f) * _S98;
    }
    return _S99;
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn square_1( v_0 : vec3<f32>) -> f32
{
    return dot(v_0, v_0);
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S100 : f32 = roughness_2 * roughness_2;
    var _S101 : f32 = squared_along_0 * (1.0f - _S100) + _S100;
    return 0.31830987334251404f * _S100 * roughness_2 / (_S101 * _S101);
}

fn density_between_0( light_1 : vec3<f32>,  view_0 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S102 : vec3<f32> = light_1 + view_0;
    var _S103 : f32 = dot(_S102, tangent_1);
    return flake_density_0(min(_S103 * _S103 / max(square_1(_S102), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  normal_1 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S104 : f32 = dot(light_2, normal_1);
    var _S105 : bool;
    if(_S104 <= 0.0f)
    {
        _S105 = true;
    }
    else
    {
        _S105 = (dot(view_1, normal_1)) <= 0.0f;
    }
    if(_S105)
    {
        return 0.0f;
    }
    var _S106 : f32 = max(_S104, 9.99999997475242708e-07f);
    var _S107 : f32 = max(dot(view_1, normal_1), 9.99999997475242708e-07f);
    var _S108 : f32 = projected_area_1(light_2, tangent_2, roughness_4) * _S107 + projected_area_1(view_1, tangent_2, roughness_4) * _S106;
    var _S109 : f32 = optical_depth_1 * _S108 / (_S106 * _S107);
    return 0.25f * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S109 * mean_attenuation_0(_S109)) * _S106 / _S108;
}

fn transmission_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_2 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S110 : f32 = - dot(light_3, normal_2);
    var _S111 : f32 = dot(view_2, normal_2);
    var _S112 : bool;
    if(_S110 <= 0.0f)
    {
        _S112 = true;
    }
    else
    {
        _S112 = _S111 <= 0.0f;
    }
    if(_S112)
    {
        return 0.0f;
    }
    var _S113 : f32 = 1.0f / max(_S111, 9.99999997475242708e-07f);
    var _S114 : f32 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S110, 9.99999997475242708e-07f);
    var _S115 : f32 = projected_area_1(view_2, tangent_3, roughness_5) * _S113;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S114, _S115)) * mean_attenuation_0(optical_depth_2 * abs(_S114 - _S115)) * _S113;
}

fn sheen_scale_0( x_5 : f32,  y_0 : f32) -> f32
{
    return (((((0.0f * x_5 + (((((-1.1402510404586792f * y_0 + 0.40672621130943298f) * y_0 + 1.65398800373077393f) * y_0 + -1.29730904102325439f) * y_0 + 0.30570998787879944f) * y_0 + -0.0220868494361639f)) * x_5 + (((((-0.21142719686031342f * y_0 + 1.05947399139404297f) * y_0 + -0.41116121411323547f) * y_0 + -0.93859231472015381f) * y_0 + 0.51606941223144531f) * y_0 + 0.05409301072359085f)) * x_5 + (((((1.22944498062133789f * y_0 + -0.45962560176849365f) * y_0 + -1.63861405849456787f) * y_0 + 1.33565104007720947f) * y_0 + -0.45725581049919128f) * y_0 + 0.08243165910243988f)) * x_5 + (((((0.39779931306838989f * y_0 + -1.18879103660583496f) * y_0 + 0.28251591324806213f) * y_0 + 1.168984055519104f) * y_0 + -0.76864629983901978f) * y_0 + 0.0091691892594099f)) * x_5 + (((((-0.26563560962677002f * y_0 + -0.19379159808158875f) * y_0 + 0.2677634060382843f) * y_0 + 0.00270519289188087f) * y_0 + 0.14349560439586639f) * y_0 + 0.10290180146694183f)) * x_5 + (((((-0.20701569318771362f * y_0 + 0.24526430666446686f) * y_0 + 0.19551840424537659f) * y_0 + 0.07586126774549484f) * y_0 + 0.38894739747047424f) * y_0 + 0.15043120086193085f);
}

fn sheen_shear_0( x_6 : f32,  y_1 : f32) -> f32
{
    return ((((0.0f * x_6 + (((((-0.10608240216970444f * y_1 + 1.99214303493499756f) * y_1 + -1.42255294322967529f) * y_1 + -1.09495604038238525f) * y_1 + 0.59180057048797607f) * y_1 + 0.06902855634689331f)) * x_6 + (((((-0.46220690011978149f * y_1 + -0.29113379120826721f) * y_1 + 1.39025199413299561f) * y_1 + 0.35589990019798279f) * y_1 + -1.17120099067687988f) * y_1 + 0.15940259397029877f)) * x_6 + (((((2.26068711280822754f * y_1 + -3.64728999137878418f) * y_1 + -0.72173482179641724f) * y_1 + 3.07659196853637695f) * y_1 + -0.6827620267868042f) * y_1 + -0.3039557933807373f)) * x_6 + (((((0.81201767921447754f * y_1 + 0.36014080047607422f) * y_1 + -1.72646903991699219f) * y_1 + -0.22630110383033752f) * y_1 + 0.89514690637588501f) * y_1 + -0.10397960245609283f)) * x_6 + (((((-0.37648698687553406f * y_1 + 1.10974001884460449f) * y_1 + 0.17824520170688629f) * y_1 + -1.04968702793121338f) * y_1 + 0.1461234986782074f) * y_1 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_7 : f32,  y_2 : f32) -> f32
{
    return ((((0.0f * x_7 + (((((12.95646953582763672f * y_2 + -21.38032913208007812f) * y_2 + -7.37853097915649414f) * y_2 + 34.55607986450195312f) * y_2 + -23.61347007751464844f) * y_2 + 5.00126314163208008f)) * x_7 + (((((10.91487026214599609f * y_2 + -6.08202791213989258f) * y_2 + -38.2036285400390625f) * y_2 + 53.3440399169921875f) * y_2 + -21.91996002197265625f) * y_2 + 2.01606011390686035f)) * x_7 + (((((-14.52206039428710938f * y_2 + 36.803619384765625f) * y_2 + -22.94047927856445312f) * y_2 + -10.07973003387451172f) * y_2 + 15.77003955841064453f) * y_2 + -4.92722177505493164f)) * x_7 + (((((-7.62505722045898438f * y_2 + 1.27310299873352051f) * y_2 + 31.19523048400878906f) * y_2 + -44.39989852905273438f) * y_2 + 26.44947052001953125f) * y_2 + -8.73507976531982422f)) * x_7 + (((((5.65633487701416016f * y_2 + -17.66820907592773438f) * y_2 + 24.65356063842773438f) * y_2 + -19.38941001892089844f) * y_2 + 11.06159019470214844f) * y_2 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_6 : f32) -> vec3<f32>
{
    var _S116 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S117 : f32 = 2.0f * sqrt(_S116) - 1.0f;
    var _S118 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S117, _S118), 0.00999999977648258f, 1.0f), clamp((1.0f - _S116) * sheen_shear_0(_S117, _S118), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S117, _S118), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S119 : f32 = light_4.z;
    var _S120 : bool;
    if(_S119 <= 0.0f)
    {
        _S120 = true;
    }
    else
    {
        _S120 = (view_3.z) <= 0.0f;
    }
    if(_S120)
    {
        return 0.0f;
    }
    var _S121 : vec2<f32> = view_3.xy;
    var _S122 : f32 = dot(_S121, _S121);
    var _S123 : vec2<f32>;
    if(_S122 > 9.99999968265522539e-21f)
    {
        _S123 = _S121 * vec2<f32>(rsqrt_0(_S122));
    }
    else
    {
        _S123 = vec2<f32>(1.0f, 0.0f);
    }
    var _S124 : f32 = scale_0 * dot(light_4.xy, _S123) + shear_0 * _S119;
    var _S125 : f32 = scale_0 * (light_4.y * _S123.x - light_4.x * _S123.y);
    var _S126 : f32 = _S124 * _S124 + _S125 * _S125 + _S119 * _S119;
    return 0.31830987334251404f * scale_0 * scale_0 * _S119 / max(_S126 * _S126, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S127 : vec3<f32> = sheen_lobe_0(view_4.z, roughness_7);
    var _S128 : f32 = strength_0 * _S127.z;
    return vec2<f32>(_S128 * transformed_cosine_0(light_5, view_4, _S127.x, _S127.y), 1.0f - _S128);
}

struct YarnPoint_0
{
     back_3 : bool,
     hole_2 : bool,
     is_warp_1 : bool,
     x_8 : f32,
     y_3 : f32,
     height_2 : f32,
     normal_3 : vec3<f32>,
     tangent_4 : vec3<f32>,
     roughness_8 : f32,
     albedos_1 : Albedos_0,
};

struct Hit_0
{
     x_9 : f32,
     y_4 : f32,
     hole_3 : bool,
     height_3 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_4 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S129 : u32,  _S130 : f32,  _S131 : f32,  _S132 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S129].warp_0, _S130);
    crossing_2.weft_1 = locate_0(fabrics_0[_S129].weft_0, _S131);
    var _S133 : u32 = fabrics_0[_S129].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S129].ends_1 + crossing_2.warp_1.thread_0);
    var _S134 : u32 = words_0[_S133];
    crossing_2.warp_word_0 = _S134;
    crossing_2.weft_word_0 = words_0[_S133 + u32(1)];
    crossing_2.warp_above_0 = (((_S134 & (u32(1)))) == u32(1)) != _S132;
    return crossing_2;
}

fn sample_at_0( _S135 : u32,  _S136 : f32,  _S137 : f32,  _S138 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S139 : Crossing_0 = crossing_at_0(_S135, _S136, _S137, _S138);
    sample_0.crossing_1 = _S139;
    var _S140 : Shown_0 = shown_at_0(_S139, _S138);
    sample_0.shown_3 = _S140;
    var _S141 : u32;
    if(_S140.is_warp_0)
    {
        _S141 = fabrics_0[_S135].warp_0;
    }
    else
    {
        _S141 = fabrics_0[_S135].weft_0;
    }
    var _S142 : u32;
    if(_S140.is_warp_0)
    {
        _S142 = fabrics_0[_S135].weft_0;
    }
    else
    {
        _S142 = fabrics_0[_S135].warp_0;
    }
    var _S143 : Cell_0 = select_cell_0(_S140.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S144 : Cell_0 = select_cell_0(_S140.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S145 : Run_0 = unpack_0(_S141, _S142, _S143.thread_0, _S144, _S140.word_0);
    var _S146 : Section_0 = section_at_0(_S143);
    var _S147 : bool;
    if(_S140.on_top_0)
    {
        _S147 = (_S145.distance_0) < (_S146.drop_0 * _S145.bend_1.sine_0);
    }
    else
    {
        _S147 = false;
    }
    var _S148 : bool;
    if(_S140.on_top_0)
    {
        _S148 = !_S147;
    }
    else
    {
        _S148 = false;
    }
    var _S149 : f32;
    if(_S148)
    {
        _S149 = 1.0f;
    }
    else
    {
        _S149 = -1.0f;
    }
    var _S150 : f32;
    if(_S147)
    {
        _S150 = _S145.other_reach_0;
    }
    else
    {
        _S150 = _S145.reach_0;
    }
    var _S151 : f32;
    if(_S147)
    {
        _S151 = _S150 + _S145.distance_0;
    }
    else
    {
        _S151 = max(_S150 - _S145.distance_0, 0.0f);
    }
    var _S152 : f32 = _S150 / _S145.bend_1.sine_0 - _S149 * _S146.drop_0;
    var _S153 : f32 = _S151 * _S151;
    var _S154 : f32 = max(_S152 * _S152 - _S153, 9.99999968265522539e-21f);
    var _S155 : f32 = rsqrt_0(_S154);
    var _S156 : f32 = _S153 / (_S154 * _S155 + _S152);
    var _S157 : bool = _S151 > 0.0f;
    var _S158 : f32;
    if(_S140.on_top_0)
    {
        _S158 = 1.0f;
    }
    else
    {
        _S158 = -1.0f;
    }
    var _S159 : f32;
    if(_S145.near_start_0)
    {
        _S159 = 1.0f;
    }
    else
    {
        _S159 = -1.0f;
    }
    var _S160 : f32 = _S158 * _S159;
    if(_S157)
    {
        _S158 = _S152 * _S155;
    }
    else
    {
        _S158 = 1.0f;
    }
    sample_0.slope_across_0 = _S146.slope_0 * _S158;
    if(_S157)
    {
        _S151 = _S160 * _S151 * _S155;
    }
    else
    {
        _S151 = 0.0f;
    }
    sample_0.slope_along_0 = _S151;
    var _S161 : Family_std430_0 = families_0[_S141];
    var _S162 : vec2<f32> = dive_0(_S142, _S140, _S145, _S144);
    if(_S145.straight_0)
    {
        _S149 = 0.0f;
    }
    else
    {
        _S149 = _S161.height_scale_0 * _S149;
    }
    sample_0.height_4 = _S149 * (_S150 * _S145.bend_1.half_tangent_0 - _S156) - _S161.height_scale_0 * _S146.drop_0 - _S162.x;
    var _S163 : f32 = _S161.height_scale_0 * sample_0.slope_across_0;
    var _S164 : f32 = _S161.height_scale_0 * sample_0.slope_along_0 - _S162.y;
    if(_S140.is_warp_0)
    {
        _S149 = _S163;
    }
    else
    {
        _S149 = _S164;
    }
    sample_0.slope_x_1 = _S149;
    if(_S140.is_warp_0)
    {
        _S149 = _S164;
    }
    else
    {
        _S149 = _S163;
    }
    sample_0.slope_y_1 = _S149;
    sample_0.run_3 = _S145;
    sample_0.section_1 = _S146;
    return sample_0;
}

fn steps_per_length_0( _S165 : u32,  _S166 : SearchQuality_0,  _S167 : vec3<f32>) -> f32
{
    return max(max(abs(_S167.x) * fabrics_0[_S165].threads_per_x_0, abs(_S167.y) * fabrics_0[_S165].threads_per_y_0) * _S166.steps_per_thread_0, abs(_S167.z) * fabrics_0[_S165].per_relief_0 * _S166.steps_per_relief_0);
}

fn cell_maximum_0( _S168 : u32,  _S169 : Crossing_0) -> f32
{
    var _S170 : u32;
    if(_S169.warp_above_0)
    {
        _S170 = fabrics_0[_S168].warp_0;
    }
    else
    {
        _S170 = fabrics_0[_S168].weft_0;
    }
    var _S171 : u32;
    if(_S169.warp_above_0)
    {
        _S171 = _S169.warp_word_0;
    }
    else
    {
        _S171 = _S169.weft_word_0;
    }
    return f32((_S171 >> (u32(28)))) * families_0[_S170].height_scale_0 * families_0[_S170].level_0;
}

fn probe_0( _S172 : u32,  _S173 : f32,  _S174 : f32,  _S175 : bool,  _S176 : bool,  _S177 : bool) -> Probe_0
{
    var _S178 : Sample_0 = sample_at_0(_S172, _S173, _S174, _S175);
    var probe_1 : Probe_0;
    probe_1.height_0 = _S178.height_4;
    probe_1.hole_1 = _S178.shown_3.hole_0;
    probe_1.slope_x_0 = _S178.slope_x_1;
    probe_1.slope_y_0 = _S178.slope_y_1;
    var _S179 : u32;
    if(_S178.shown_3.is_warp_0)
    {
        _S179 = _S178.crossing_1.warp_1.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S179 = _S178.crossing_1.weft_1.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S179;
    probe_1.cell_max_0 = cell_maximum_0(_S172, _S178.crossing_1);
    var _S180 : f32;
    if(_S176)
    {
        _S180 = _S178.crossing_1.warp_1.above_0;
    }
    else
    {
        _S180 = _S178.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S180;
    if(_S177)
    {
        _S180 = _S178.crossing_1.weft_1.above_0;
    }
    else
    {
        _S180 = _S178.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S180;
    probe_1.edge_x_0 = outline_distance_0(_S178.crossing_1.warp_1, _S178.shown_3, _S178.run_3, !_S178.shown_3.is_warp_0, _S176);
    probe_1.edge_y_0 = outline_distance_0(_S178.crossing_1.weft_1, _S178.shown_3, _S178.run_3, _S178.shown_3.is_warp_0, _S177);
    return probe_1;
}

fn is_free_0( _S181 : u32,  _S182 : SearchQuality_0,  _S183 : vec3<f32>,  _S184 : vec3<f32>,  _S185 : bool,  _S186 : f32) -> bool
{
    var _S187 : f32 = _S184.z;
    if(_S187 <= 0.0f)
    {
        return false;
    }
    var _S188 : f32 = 1.0f / max(_S182.shadow_share_0 * steps_per_length_0(_S181, _S182, _S184), 9.99999971718068537e-10f);
    var _S189 : StepControl_0 = step_control_0(_S184.xy, _S188);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_1 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S190 : bool;
        if(count_1 < u32(1024))
        {
            _S190 = (_S183.z + _S187 * distance_1) < _S186;
        }
        else
        {
            _S190 = false;
        }
        if(_S190)
        {
        }
        else
        {
            break;
        }
        var _S191 : vec3<f32> = _S183 + _S184 * vec3<f32>(distance_1);
        var _S192 : Probe_0 = probe_0(_S181, _S191.x, _S191.y, _S185, _S189.right_0, _S189.up_0);
        var _S193 : f32 = _S191.z;
        var _S194 : f32 = _S193 - _S192.height_0;
        var _S195 : f32 = _S187 - _S192.slope_x_0 * _S184.x - _S192.slope_y_0 * _S184.y;
        var _S196 : bool;
        if(!_S192.hole_1)
        {
            _S196 = _S194 < 0.0f;
        }
        else
        {
            _S196 = false;
        }
        if(_S196)
        {
            return false;
        }
        var _S197 : f32 = way_back_to_dip_0(previous_3, _S194, _S195, last_step_0, _S192);
        if(_S197 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S197;
            distance_1 = distance_1 - _S197;
            last_step_0 = last_step_1;
            count_1 = count_1 + u32(1);
            continue;
        }
        var _S198 : bool = _S193 > (_S192.cell_max_0);
        var _S199 : PreviousSample_0 = after_sample_0(_S194, _S195, _S192, _S198);
        var last_step_2 : f32;
        if(_S198)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S189, _S192.side_x_0, _S192.side_y_0), _S188);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S189, _S192, _S194, _S195);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S199;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + u32(1);
    }
    return true;
}

fn passes_through_0( _S200 : u32,  _S201 : SearchQuality_0,  _S202 : f32,  _S203 : f32,  _S204 : vec3<f32>,  _S205 : bool) -> bool
{
    if(!sample_at_0(_S200, _S202, _S203, _S205).shown_3.hole_0)
    {
        return false;
    }
    var _S206 : vec3<f32> = vec3<f32>(_S202, _S203, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S207 : bool;
        if(side_0 < u32(2))
        {
            _S207 = passes_0;
        }
        else
        {
            _S207 = false;
        }
        if(_S207)
        {
        }
        else
        {
            break;
        }
        var _S208 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S208 = _S204;
        }
        else
        {
            _S208 = vec3<f32>(- _S204.x, - _S204.y, _S204.z);
        }
        var _S209 : bool = is_free_0(_S200, _S201, _S206, _S208, _S205 != (side_0 == u32(1)), fabrics_0[_S200].height_high_0);
        var _S210 : u32 = side_0 + u32(1);
        passes_0 = _S209;
        side_0 = _S210;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_5 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S211 : u32,  _S212 : f32,  _S213 : f32,  _S214 : f32,  _S215 : vec3<f32>,  _S216 : bool) -> f32
{
    var _S217 : u32 = locate_0(fabrics_0[_S211].warp_0, _S212).thread_0 / u32(2);
    var _S218 : u32 = locate_0(fabrics_0[_S211].weft_0, _S213).thread_0 / u32(2);
    var _S219 : f32 = _S215.x;
    var _S220 : u32;
    if(_S219 > 0.0f)
    {
        _S220 = u32(1);
    }
    else
    {
        _S220 = u32(0);
    }
    var _S221 : f32 = _S215.y;
    var _S222 : u32;
    if(_S221 > 0.0f)
    {
        _S222 = u32(2);
    }
    else
    {
        _S222 = u32(0);
    }
    var _S223 : u32 = words_0[fabrics_0[_S211].max_heights_0 + u32(4) * (_S218 * fabrics_0[_S211].max_height_columns_0 + _S217) + (_S220 + _S222)];
    var number_0 : i32;
    if(_S216)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S224 : u32 = (_S223 >> (u32(number_0)));
    var _S225 : f32 = max(abs(_S219) * fabrics_0[_S211].threads_per_x_0, abs(_S221) * fabrics_0[_S211].threads_per_y_0) / _S215.z;
    var _S226 : f32 = fabrics_0[_S211].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S211].height_high_0;
    number_0 = i32(3);
    for(;;)
    {
        if(number_0 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S214) * _S225) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S224 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S226);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S227 : u32,  _S228 : f32,  _S229 : f32,  _S230 : bool,  _S231 : bool,  _S232 : bool) -> vec3<f32>
{
    var _S233 : Crossing_0 = crossing_at_0(_S227, _S228, _S229, _S230);
    var _S234 : f32 = cell_maximum_0(_S227, _S233);
    var _S235 : f32;
    if(_S231)
    {
        _S235 = _S233.warp_1.above_0;
    }
    else
    {
        _S235 = _S233.warp_1.below_0;
    }
    var _S236 : f32;
    if(_S232)
    {
        _S236 = _S233.weft_1.above_0;
    }
    else
    {
        _S236 = _S233.weft_1.below_0;
    }
    return vec3<f32>(_S234, _S235, _S236);
}

fn first_sample_height_0( _S237 : u32,  _S238 : ViewRay_0,  _S239 : StepControl_0,  _S240 : bool) -> f32
{
    var _S241 : f32 = max_height_along_0(_S237, _S238.origin_0.x, _S238.origin_0.y, 0.0f, vec3<f32>(_S238.slope_1, 1.0f), _S240);
    var count_2 : u32 = u32(0);
    var height_6 : f32 = _S241;
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S242 : vec2<f32> = ViewRay_at_0(_S238, height_6);
        var _S243 : vec3<f32> = cell_bounds_0(_S237, _S242.x, _S242.y, _S240, _S239.right_0, _S239.up_0);
        var _S244 : f32 = height_6 - _S243.x;
        var _S245 : f32 = StepControl_to_cell_exit_0(_S239, _S243.y, _S243.z);
        var height_7 : f32 = height_6 - clamp(_S244, 0.0f, _S245);
        if(_S244 <= _S245)
        {
            height_6 = height_7;
            break;
        }
        count_2 = count_2 + u32(1);
        height_6 = height_7;
    }
    return height_6;
}

fn search_down_0( _S246 : u32,  _S247 : ViewRay_0,  _S248 : StepControl_0,  _S249 : bool) -> ViewRayEnd_0
{
    var _S250 : f32 = fabrics_0[_S246].height_low_0 - (fabrics_0[_S246].height_high_0 - fabrics_0[_S246].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_5 = first_sample_height_0(_S246, _S247, _S248, _S249);
    end_1.last_step_3 = _S248.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_3 : u32 = u32(0);
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S251 : vec2<f32> = ViewRay_at_0(_S247, end_1.height_5);
        var _S252 : Probe_0 = probe_0(_S246, _S251.x, _S251.y, _S249, _S248.right_0, _S248.up_0);
        var _S253 : f32 = end_1.height_5 - _S252.height_0;
        var _S254 : f32 = ViewRay_rate_0(_S247, _S252);
        end_1.depth_1 = - _S253;
        end_1.rate_4 = _S254;
        var _S255 : bool;
        if(end_1.previous_4.known_0)
        {
            _S255 = !_S252.hole_1;
        }
        else
        {
            _S255 = false;
        }
        var _S256 : bool;
        if(_S255)
        {
            _S256 = (end_1.previous_4.yarn_0) == (_S252.yarn_1);
        }
        else
        {
            _S256 = false;
        }
        end_1.smooth_0 = _S256;
        var _S257 : bool;
        if(!_S252.hole_1)
        {
            _S257 = _S253 <= 0.0f;
        }
        else
        {
            _S257 = false;
        }
        var _S258 : bool;
        if(_S257)
        {
            _S258 = true;
        }
        else
        {
            _S258 = (end_1.height_5) <= _S250;
        }
        if(_S258)
        {
            break;
        }
        var _S259 : f32 = way_back_to_dip_0(end_1.previous_4, _S253, _S254, end_1.last_step_3, _S252);
        if(_S259 >= 0.0f)
        {
            end_1.height_5 = end_1.height_5 + _S259;
            end_1.last_step_3 = end_1.last_step_3 - _S259;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S260 : f32 = min(StepControl_to_cell_exit_0(_S248, _S252.side_x_0, _S252.side_y_0), end_1.height_5 - _S252.cell_max_0);
        var _S261 : f32 = StepControl_to_next_sample_0(_S248, _S252, _S253, _S254);
        end_1.previous_4 = after_sample_0(_S253, _S254, _S252, _S260 > _S261);
        var _S262 : f32 = max(_S260, _S261);
        end_1.last_step_3 = _S262;
        end_1.height_5 = end_1.height_5 - _S262;
        count_3 = count_3 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S263 : u32,  _S264 : ViewRay_0,  _S265 : StepControl_0,  _S266 : bool,  _S267 : ViewRayEnd_0,  _S268 : u32) -> f32
{
    var _S269 : f32 = fabrics_0[_S263].height_high_0 - fabrics_0[_S263].height_low_0;
    var above_2 : f32 = _S267.height_5 + _S267.last_step_3;
    var above_gap_1 : f32 = clamp(_S267.previous_4.clearance_0, 0.0f, _S269);
    var under_gap_1 : f32 = clamp(_S267.depth_1, 0.0f, _S269);
    var _S270 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S267.previous_4.rate_0 * _S267.last_step_3, _S267.rate_4 * _S267.last_step_3);
    var middle_0 : f32;
    if(_S267.smooth_0)
    {
        middle_0 = above_2 - _S270 * _S267.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S267.height_5, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S267.height_5;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S268)
        {
        }
        else
        {
            break;
        }
        var _S271 : vec2<f32> = ViewRay_at_0(_S264, middle_0);
        var _S272 : Probe_0 = probe_0(_S263, _S271.x, _S271.y, _S266, _S265.right_0, _S265.up_0);
        var _S273 : f32;
        if(_S272.hole_1)
        {
            _S273 = -1.0e+09f;
        }
        else
        {
            _S273 = _S272.height_0;
        }
        var _S274 : f32 = clamp(middle_0 - _S273, - _S269, _S269);
        var _S275 : f32;
        if(_S274 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S275 = 0.5f * above_gap_2;
            }
            else
            {
                _S275 = above_gap_2;
            }
            var _S276 : f32 = - _S274;
            under_1 = middle_0;
            above_gap_2 = _S275;
            under_gap_2 = _S276;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S275 = 0.5f * under_gap_2;
            }
            else
            {
                _S275 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S274;
            under_gap_2 = _S275;
            side_1 = -1.0f;
        }
        if(_S267.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S274 / min(ViewRay_rate_0(_S264, _S272), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S267.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S277 : u32,  _S278 : SearchQuality_0,  _S279 : f32,  _S280 : f32,  _S281 : vec3<f32>,  _S282 : bool) -> Hit_0
{
    var _S283 : f32 = max(_S281.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S279, _S280);
    var _S284 : vec2<f32> = _S281.xy / vec2<f32>(_S283);
    ray_0.slope_1 = _S284;
    var _S285 : StepControl_0 = step_control_0((vec2<f32>(0) - _S284), 1.0f / max(steps_per_length_0(_S277, _S278, _S281) / _S283, 9.99999971718068537e-10f));
    var _S286 : ViewRayEnd_0 = search_down_0(_S277, ray_0, _S285, _S282);
    var hit_0 : Hit_0;
    hit_0.hole_3 = false;
    var _S287 : f32 = refined_height_0(_S277, ray_0, _S285, _S282, _S286, _S278.refinements_0);
    hit_0.height_3 = _S287;
    var _S288 : vec2<f32> = ViewRay_at_0(ray_0, _S287);
    hit_0.x_9 = _S288.x;
    hit_0.y_4 = _S288.y;
    return hit_0;
}

fn first_hit_0( _S289 : u32,  _S290 : SearchQuality_0,  _S291 : f32,  _S292 : f32,  _S293 : vec3<f32>,  _S294 : bool) -> Hit_0
{
    if(!passes_through_0(_S289, _S290, _S291, _S292, _S293, _S294))
    {
        return first_hit_of_yarn_0(_S289, _S290, _S291, _S292, _S293, _S294);
    }
    var hit_1 : Hit_0;
    hit_1.x_9 = _S291;
    hit_1.y_4 = _S292;
    hit_1.height_3 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_2 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_8 : f32,
     normal_4 : vec3<f32>,
     tangent_5 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn surface_at_0( _S295 : u32,  _S296 : f32,  _S297 : f32,  _S298 : bool) -> SurfacePoint_0
{
    var _S299 : Sample_0 = sample_at_0(_S295, _S296, _S297, _S298);
    var _S300 : f32;
    if(_S299.shown_3.is_warp_0)
    {
        _S300 = _S299.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S300 = _S299.crossing_1.weft_1.half_width_1;
    }
    var _S301 : u32;
    if(_S299.shown_3.is_warp_0)
    {
        _S301 = fabrics_0[_S295].warp_0;
    }
    else
    {
        _S301 = fabrics_0[_S295].weft_0;
    }
    var _S302 : Family_std430_0 = families_0[_S301];
    var _S303 : f32;
    if(_S298)
    {
        _S303 = -1.0f;
    }
    else
    {
        _S303 = 1.0f;
    }
    var _S304 : f32 = _S302.twist_sine_0 * _S303;
    var _S305 : Family_std430_0 = families_0[_S301];
    if(_S299.shown_3.is_warp_0)
    {
        _S303 = 1.0f;
    }
    else
    {
        _S303 = -1.0f;
    }
    var _S306 : vec2<f32> = fibre_direction_0(_S299.slope_across_0, _S303 * _S299.slope_along_0, _S304, _S305.twist_cosine_0);
    var _S307 : f32;
    if(_S299.shown_3.is_warp_0)
    {
        _S307 = _S299.slope_x_1;
    }
    else
    {
        _S307 = _S299.slope_y_1;
    }
    var _S308 : f32;
    if(_S299.shown_3.is_warp_0)
    {
        _S308 = _S299.slope_y_1;
    }
    else
    {
        _S308 = _S299.slope_x_1;
    }
    var _S309 : f32 = _S306.x;
    var _S310 : f32 = _S306.y;
    var _S311 : f32 = _S307 * _S309 + _S303 * _S308 * _S310;
    var _S312 : f32 = _S300 * 1.0154266357421875f;
    var _S313 : f32 = _S312 * arc_sine_0(clamp(_S299.section_1.across_1 / _S312, -1.0f, 1.0f));
    if(_S299.shown_3.is_warp_0)
    {
        _S300 = _S297;
    }
    else
    {
        _S300 = - _S296;
    }
    var point_0 : SurfacePoint_0;
    point_0.hole_4 = _S299.shown_3.hole_0;
    point_0.is_warp_2 = _S299.shown_3.is_warp_0;
    point_0.warp_thread_0 = _S299.crossing_1.warp_1.thread_0;
    point_0.weft_thread_0 = _S299.crossing_1.weft_1.thread_0;
    point_0.height_8 = _S299.height_4;
    point_0.normal_4 = normalize(vec3<f32>(- _S299.slope_x_1, - _S299.slope_y_1, 1.0f));
    var _S314 : vec3<f32>;
    if(_S299.shown_3.is_warp_0)
    {
        _S314 = vec3<f32>(_S309, _S310, _S311);
    }
    else
    {
        _S314 = vec3<f32>(- _S310, _S309, _S311);
    }
    point_0.tangent_5 = normalize(_S314);
    point_0.across_2 = _S299.section_1.across_1;
    point_0.fibre_across_0 = _S313 * _S305.twist_cosine_0 + _S300 * _S304;
    point_0.fibre_along_0 = _S300 * _S305.twist_cosine_0 - _S313 * _S304;
    return point_0;
}

fn vary_albedos_0( _S315 : u32,  _S316 : Albedos_0,  _S317 : u32,  _S318 : u32) -> Albedos_0
{
    var _S319 : vec3<f32> = max(_S316.specular_reflect_0, _S316.specular_transmit_0);
    var _S320 : vec3<f32> = _S316.diffuse_reflect_0 + _S316.diffuse_transmit_0;
    var _S321 : vec3<f32> = vec3<f32>(fabrics_0[_S315].layer_bound_0);
    var _S322 : vec3<f32> = vec3<f32>(1.0f);
    var _S323 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S317, fabrics_0[_S315].colour_noise_0, fabrics_0[_S315].seed_0), _S320, _S322 - _S321 * _S319));
    var _S324 : f32 = bounded_gain_0(fibre_gain_0(_S317, _S318, fabrics_0[_S315].fibre_noise_0, fabrics_0[_S315].seed_0), _S319, min((_S322 - _S323 * _S320) / _S321, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S323 * _S316.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S323 * _S316.diffuse_transmit_0;
    var _S325 : vec3<f32> = vec3<f32>(_S324);
    varied_0.specular_reflect_0 = _S325 * _S316.specular_reflect_0;
    varied_0.specular_transmit_0 = _S325 * _S316.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S326 : u32,  _S327 : SurfacePoint_0,  _S328 : Albedos_0,  _S329 : f32,  _S330 : f32) -> Albedos_0
{
    var _S331 : f32;
    if(_S327.is_warp_2)
    {
        _S331 = _S329;
    }
    else
    {
        _S331 = _S330;
    }
    var _S332 : f32 = _S331 - _S327.across_2;
    var _S333 : u32;
    if(_S327.is_warp_2)
    {
        _S333 = fabrics_0[_S326].warp_0;
    }
    else
    {
        _S333 = fabrics_0[_S326].weft_0;
    }
    var _S334 : Family_std430_0 = families_0[_S333];
    var _S335 : i32 = i32(families_0[_S333].count_0);
    if(_S327.is_warp_2)
    {
        _S333 = _S327.warp_thread_0;
    }
    else
    {
        _S333 = _S327.weft_thread_0;
    }
    var _S336 : u32 = u32(i32(floor(_S332 / _S334.period_0)) * _S335 + i32(_S333)) * u32(2);
    if(_S327.is_warp_2)
    {
        _S333 = u32(1);
    }
    else
    {
        _S333 = u32(0);
    }
    var _S337 : f32 = floor(_S327.fibre_across_0 / fabrics_0[_S326].fibre_size_0);
    return vary_albedos_0(_S326, _S328, _S336 + _S333, u32(i32(_S337)) * u32(65536) + u32(i32(floor(_S327.fibre_along_0 / (fabrics_0[_S326].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S337))));
}

fn yarn_point_of_0( _S338 : u32,  _S339 : SurfacePoint_0,  _S340 : f32,  _S341 : f32,  _S342 : bool,  _S343 : bool) -> YarnPoint_0
{
    var _S344 : u32;
    if(_S339.is_warp_2)
    {
        _S344 = fabrics_0[_S338].warp_0;
    }
    else
    {
        _S344 = fabrics_0[_S338].weft_0;
    }
    var _S345 : u32;
    if(_S339.is_warp_2)
    {
        _S345 = _S339.warp_thread_0;
    }
    else
    {
        _S345 = _S339.weft_thread_0;
    }
    var albedos_2 : Albedos_0 = albedos_of_0(_S344, _S345);
    var _S346 : bool;
    if((fabrics_0[_S338].fibre_noise_0) > 0.0f)
    {
        _S346 = true;
    }
    else
    {
        _S346 = (fabrics_0[_S338].colour_noise_0) > 0.0f;
    }
    var albedos_3 : Albedos_0;
    if(_S346)
    {
        albedos_3 = varied_at_0(_S338, _S339, albedos_2, _S340, _S341);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    var point_1 : YarnPoint_0;
    point_1.back_3 = _S342;
    point_1.hole_2 = _S343;
    point_1.is_warp_1 = _S339.is_warp_2;
    point_1.x_8 = _S340;
    point_1.y_3 = _S341;
    point_1.height_2 = _S339.height_8;
    point_1.normal_3 = _S339.normal_4;
    point_1.tangent_4 = _S339.tangent_5;
    point_1.roughness_8 = families_0[_S344].roughness_0;
    point_1.albedos_1 = albedos_3;
    return point_1;
}

fn locate_yarn_0( _S347 : u32,  _S348 : SearchQuality_0,  _S349 : f32,  _S350 : f32,  _S351 : vec3<f32>) -> YarnPoint_0
{
    var _S352 : bool = (_S351.z) < 0.0f;
    var _S353 : Hit_0 = first_hit_0(_S347, _S348, _S349, _S350, to_face_frame_0(_S351, _S352), _S352);
    return yarn_point_of_0(_S347, surface_at_0(_S347, _S353.x_9, _S353.y_4, _S352), _S353.x_9, _S353.y_4, _S352, _S353.hole_3);
}

fn scattered_0( _S354 : u32,  _S355 : YarnPoint_0,  _S356 : vec3<f32>,  _S357 : vec3<f32>) -> vec3<f32>
{
    var _S358 : vec3<f32> = vec3<f32>(0.0f);
    var _S359 : bool = !_S355.hole_2;
    var _S360 : bool;
    if(_S359)
    {
        _S360 = (_S356.z) > 0.0f;
    }
    else
    {
        _S360 = false;
    }
    var value_1 : vec3<f32>;
    if(_S360)
    {
        value_1 = _S355.albedos_1.diffuse_reflect_0 * vec3<f32>(diffuse_reflection_0(_S356, _S355.normal_3, fabrics_0[_S354].diffuse_blend_0)) + _S355.albedos_1.specular_reflect_0 * vec3<f32>(reflection_0(_S356, _S357, _S355.normal_3, _S355.tangent_4, _S355.roughness_8, fabrics_0[_S354].optical_depth_0));
    }
    else
    {
        if(_S359)
        {
            _S360 = (_S356.z) < 0.0f;
        }
        else
        {
            _S360 = false;
        }
        if(_S360)
        {
            value_1 = _S355.albedos_1.diffuse_transmit_0 * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S356), _S355.normal_3, fabrics_0[_S354].diffuse_blend_0)) + _S355.albedos_1.specular_transmit_0 * vec3<f32>(transmission_0(_S356, _S357, _S355.normal_3, _S355.tangent_4, _S355.roughness_8, fabrics_0[_S354].optical_depth_0));
        }
        else
        {
            value_1 = _S358;
        }
    }
    var _S361 : f32 = fabrics_0[_S354].sheen_strength_0;
    if((fabrics_0[_S354].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S362 : vec2<f32> = sheen_with_transmittance_0(_S356, _S357, _S361, fabrics_0[_S354].sheen_roughness_0);
    return vec3<f32>(_S362.y) * value_1 + vec3<f32>(_S362.x);
}

fn unoccluded_0( _S363 : u32,  _S364 : SearchQuality_0,  _S365 : f32,  _S366 : f32,  _S367 : f32,  _S368 : vec3<f32>,  _S369 : bool) -> bool
{
    if((_S368.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S363, _S364, vec3<f32>(_S365, _S366, _S367 + fabrics_0[_S363].lift_0), _S368, _S369, max_height_along_0(_S363, _S365, _S366, _S367, _S368, _S369));
}

fn is_lit_0( _S370 : u32,  _S371 : SearchQuality_0,  _S372 : YarnPoint_0,  _S373 : vec3<f32>) -> bool
{
    if(_S372.hole_2)
    {
        return true;
    }
    var _S374 : vec3<f32> = to_face_frame_0(_S373, _S372.back_3);
    var _S375 : f32 = _S374.z;
    var _S376 : bool = _S375 < 0.0f;
    var normal_5 : vec3<f32>;
    var height_9 : f32;
    if(_S376)
    {
        var _S377 : SurfacePoint_0 = surface_at_0(_S370, _S372.x_8, _S372.y_3, !_S372.back_3);
        normal_5 = _S377.normal_4;
        height_9 = _S377.height_8;
    }
    else
    {
        normal_5 = _S372.normal_3;
        height_9 = _S372.height_2;
    }
    var _S378 : vec3<f32> = vec3<f32>(_S374.xy, abs(_S375));
    if((dot(normal_5, _S378)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S370, _S371, _S372.x_8, _S372.y_3, height_9, _S378, (_S372.back_3) != _S376);
}

fn evaluate_0( _S379 : u32,  _S380 : SearchQuality_0,  _S381 : YarnPoint_0,  _S382 : vec3<f32>,  _S383 : vec3<f32>) -> vec3<f32>
{
    var _S384 : vec3<f32> = scattered_0(_S379, _S381, to_face_frame_0(_S382, _S381.back_3), to_face_frame_0(_S383, _S381.back_3));
    var _S385 : bool;
    if((max(_S384.x, max(_S384.y, _S384.z))) <= 0.0f)
    {
        _S385 = true;
    }
    else
    {
        _S385 = !is_lit_0(_S379, _S380, _S381, _S382);
    }
    if(_S385)
    {
        return vec3<f32>(0.0f);
    }
    return _S384;
}

fn straight_through_0( _S386 : u32,  _S387 : YarnPoint_0,  _S388 : vec3<f32>) -> f32
{
    if(!_S387.hole_2)
    {
        return 0.0f;
    }
    var _S389 : f32 = fabrics_0[_S386].sheen_strength_0;
    if((fabrics_0[_S386].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S389 * sheen_lobe_0(abs(_S388.z), fabrics_0[_S386].sheen_roughness_0).z;
}

fn cloth_value_0( fabric_1 : u32,  centre_0 : vec2<f32>,  dx_0 : vec2<f32>,  dy_0 : vec2<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>) -> vec4<f32>
{
    var _S390 : SearchQuality_0 = default_quality_0();
    var _S391 : YarnPoint_0 = locate_yarn_0(fabric_1, _S390, centre_0.x, centre_0.y, view_5);
    return vec4<f32>(evaluate_0(fabric_1, _S390, _S391, light_6, view_5), straight_through_0(fabric_1, _S391, view_5));
}

@compute
@workgroup_size(64, 1, 1)
fn point_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S392 : u32 = id_0.x;
    if(_S392 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S393 : Query_std430_0 = queries_0[_S392];
    answers_0[_S392] = cloth_value_0(_S393.fabric_0, vec2<f32>(_S393.centre_x_0, _S393.centre_y_0), vec2<f32>(_S393.dx_x_0, _S393.dx_y_0), vec2<f32>(_S393.dy_x_0, _S393.dy_y_0), vec3<f32>(_S393.light_x_0, _S393.light_y_0, _S393.light_z_0), vec3<f32>(_S393.view_x_0, _S393.view_y_0, _S393.view_z_0));
    return;
}

