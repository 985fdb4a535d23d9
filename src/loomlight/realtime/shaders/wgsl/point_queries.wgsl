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
    @align(4) transmits_0 : u32,
    @align(4) transmission_0 : u32,
    @align(4) has_holes_0 : u32,
    @align(4) opacity_0 : u32,
};

struct Latent_std430_0
{
    @align(4) is_trained_1 : u32,
    @align(4) decoder_1 : u32,
    @align(4) hidden_0 : u32,
    @align(4) frames_0 : u32,
    @align(4) sampler_0 : u32,
    @align(4) albedo_0 : u32,
    @align(4) texels_1 : u32,
    @align(4) texel_elements_1 : u32,
    @align(4) levels_3 : u32,
    @align(4) last_level_2 : f32,
    @align(4) face_texels_1 : u32,
    @align(4) back_1 : u32,
    @align(4) repeats_per_x_1 : f32,
    @align(4) repeats_per_y_1 : f32,
    @align(4) texels_per_mm_1 : f32,
    @align(4) width_0 : f32,
    @align(4) height_0 : f32,
    @align(4) is_trilinear_0 : u32,
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
    @align(4) openness_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
    @align(4) has_yarns_0 : u32,
    @align(4) mean_hole_0 : f32,
    @align(4) latent_0 : Latent_std430_0,
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

fn to_face_frame_0( direction_0 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S1 : vec2<f32> = direction_0.xy;
    var _S2 : f32;
    if(back_2)
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

fn shown_at_0( crossing_0 : Crossing_0,  back_3 : bool) -> Shown_0
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
    shown_0.on_top_0 = (((_S13 & (u32(1)))) == u32(1)) != back_3;
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
     height_1 : f32,
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

fn ViewRay_at_0( this_2 : ViewRay_0,  height_2 : f32) -> vec2<f32>
{
    return this_2.origin_0 + this_2.slope_1 * vec2<f32>(height_2);
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

fn bounded_gain_0( gain_0 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S90 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
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

struct FaceRadiance_0
{
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     mean_0 : vec3<f32>,
     leaked_0 : vec3<f32>,
};

struct FaceSends_0
{
     sky_warp_0 : vec3<f32>,
     sky_weft_0 : vec3<f32>,
     crossing_warp_0 : vec3<f32>,
     crossing_weft_0 : vec3<f32>,
     open_0 : f32,
     blocks_warp_0 : f32,
     blocks_weft_0 : f32,
};

fn face_radiance_0( sends_0 : FaceSends_0,  open_of_other_0 : f32,  passed_0 : vec3<f32>,  from_other_0 : vec3<f32>) -> FaceRadiance_0
{
    var _S93 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S94 : vec3<f32> = sends_0.sky_warp_0 + _S93 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S94;
    var _S95 : vec3<f32> = sends_0.sky_weft_0 + _S93 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S95;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S94 + vec3<f32>(sends_0.blocks_weft_0) * _S95;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

struct Scattered_0
{
     back_4 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_3 : vec3<f32>,
     weft_3 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S96 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S97 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_4 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S97 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S97 * interior_0.far_1 + yarn_2.back_4 * _S96;
    return bounced_0;
}

fn diffuse_reflection_0( light_0 : vec3<f32>,  normal_0 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S98 : f32 = light_0.z;
    if(_S98 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S98, 0.0f), max(dot(light_0, normal_0), 0.0f), blend_0);
}

fn projected_area_1( direction_2 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S99 : f32 = dot(direction_2, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S99 * _S99 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_4 : f32) -> f32
{
    var _S100 : f32 = clamp(x_4, -87.0f, 88.0f);
    var _S101 : f32 = floor(_S100 * 1.4426950216293335f + 0.5f);
    var _S102 : f32 = _S100 - _S101 * 0.693359375f + _S101 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S102 + 0.00139819993637502f) * _S102 + 0.00833345204591751f) * _S102 + 0.04166579619050026f) * _S102 + 0.1666666567325592f) * _S102 + 0.5f;
    var _S103 : f32 = (bitcast<f32>(((u32(i32(_S101) + i32(127)) << (u32(23))))));
    var _S104 : f32;
    if(x_4 < -87.0f)
    {
        _S104 = 0.0f;
    }
    else
    {
        _S104 = (p_0 * _S102 * _S102 + _S102 + 1.0f) * _S103;
    }
    return _S104;
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
    var _S105 : f32 = roughness_2 * roughness_2;
    var _S106 : f32 = squared_along_0 * (1.0f - _S105) + _S105;
    return 0.31830987334251404f * _S105 * roughness_2 / (_S106 * _S106);
}

fn density_between_0( light_1 : vec3<f32>,  view_0 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S107 : vec3<f32> = light_1 + view_0;
    var _S108 : f32 = dot(_S107, tangent_1);
    return flake_density_0(min(_S108 * _S108 / max(square_1(_S107), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  normal_1 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S109 : f32 = dot(light_2, normal_1);
    var _S110 : bool;
    if(_S109 <= 0.0f)
    {
        _S110 = true;
    }
    else
    {
        _S110 = (dot(view_1, normal_1)) <= 0.0f;
    }
    if(_S110)
    {
        return 0.0f;
    }
    var _S111 : f32 = max(_S109, 9.99999997475242708e-07f);
    var _S112 : f32 = max(dot(view_1, normal_1), 9.99999997475242708e-07f);
    var _S113 : f32 = projected_area_1(light_2, tangent_2, roughness_4) * _S112 + projected_area_1(view_1, tangent_2, roughness_4) * _S111;
    var _S114 : f32 = optical_depth_1 * _S113 / (_S111 * _S112);
    return 0.25f * density_between_0(light_2, view_1, tangent_2, roughness_4) * (_S114 * mean_attenuation_0(_S114)) * _S111 / _S113;
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_2 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S115 : f32 = - dot(light_3, normal_2);
    var _S116 : f32 = dot(view_2, normal_2);
    var _S117 : bool;
    if(_S115 <= 0.0f)
    {
        _S117 = true;
    }
    else
    {
        _S117 = _S116 <= 0.0f;
    }
    if(_S117)
    {
        return 0.0f;
    }
    var _S118 : f32 = 1.0f / max(_S116, 9.99999997475242708e-07f);
    var _S119 : f32 = projected_area_1(light_3, tangent_3, roughness_5) / max(_S115, 9.99999997475242708e-07f);
    var _S120 : f32 = projected_area_1(view_2, tangent_3, roughness_5) * _S118;
    return density_between_0(light_3, view_2, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S119, _S120)) * mean_attenuation_0(optical_depth_2 * abs(_S119 - _S120)) * _S118;
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
    var _S121 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S122 : f32 = 2.0f * sqrt(_S121) - 1.0f;
    var _S123 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S122, _S123), 0.00999999977648258f, 1.0f), clamp((1.0f - _S121) * sheen_shear_0(_S122, _S123), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S122, _S123), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S124 : f32 = light_4.z;
    var _S125 : bool;
    if(_S124 <= 0.0f)
    {
        _S125 = true;
    }
    else
    {
        _S125 = (view_3.z) <= 0.0f;
    }
    if(_S125)
    {
        return 0.0f;
    }
    var _S126 : vec2<f32> = view_3.xy;
    var _S127 : f32 = dot(_S126, _S126);
    var _S128 : vec2<f32>;
    if(_S127 > 9.99999968265522539e-21f)
    {
        _S128 = _S126 * vec2<f32>(rsqrt_0(_S127));
    }
    else
    {
        _S128 = vec2<f32>(1.0f, 0.0f);
    }
    var _S129 : f32 = scale_0 * dot(light_4.xy, _S128) + shear_0 * _S124;
    var _S130 : f32 = scale_0 * (light_4.y * _S128.x - light_4.x * _S128.y);
    var _S131 : f32 = _S129 * _S129 + _S130 * _S130 + _S124 * _S124;
    return 0.31830987334251404f * scale_0 * scale_0 * _S124 / max(_S131 * _S131, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S132 : vec3<f32> = sheen_lobe_0(view_4.z, roughness_7);
    var _S133 : f32 = strength_0 * _S132.z;
    return vec2<f32>(_S133 * transformed_cosine_0(light_5, view_4, _S132.x, _S132.y), 1.0f - _S133);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_6 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S134 : f32 = light_6.z;
    var _S135 : vec3<f32>;
    if((_S134 * view_5.z) < 0.0f)
    {
        _S135 = bounced_1.transmitted_0;
    }
    else
    {
        _S135 = bounced_1.reflected_0;
    }
    return _S135 * vec3<f32>((abs(_S134) * 0.31830987334251404f));
}

struct YarnPoint_0
{
     back_5 : bool,
     hole_2 : bool,
     is_warp_1 : bool,
     x_8 : f32,
     y_3 : f32,
     height_3 : f32,
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
     height_4 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_5 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S136 : u32,  _S137 : f32,  _S138 : f32,  _S139 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S136].warp_0, _S137);
    crossing_2.weft_1 = locate_0(fabrics_0[_S136].weft_0, _S138);
    var _S140 : u32 = fabrics_0[_S136].run_words_0 + u32(2) * (crossing_2.weft_1.thread_0 * fabrics_0[_S136].ends_1 + crossing_2.warp_1.thread_0);
    var _S141 : u32 = words_0[_S140];
    crossing_2.warp_word_0 = _S141;
    crossing_2.weft_word_0 = words_0[_S140 + u32(1)];
    crossing_2.warp_above_0 = (((_S141 & (u32(1)))) == u32(1)) != _S139;
    return crossing_2;
}

fn sample_at_0( _S142 : u32,  _S143 : f32,  _S144 : f32,  _S145 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S146 : Crossing_0 = crossing_at_0(_S142, _S143, _S144, _S145);
    sample_0.crossing_1 = _S146;
    var _S147 : Shown_0 = shown_at_0(_S146, _S145);
    sample_0.shown_3 = _S147;
    var _S148 : u32;
    if(_S147.is_warp_0)
    {
        _S148 = fabrics_0[_S142].warp_0;
    }
    else
    {
        _S148 = fabrics_0[_S142].weft_0;
    }
    var _S149 : u32;
    if(_S147.is_warp_0)
    {
        _S149 = fabrics_0[_S142].weft_0;
    }
    else
    {
        _S149 = fabrics_0[_S142].warp_0;
    }
    var _S150 : Cell_0 = select_cell_0(_S147.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S151 : Cell_0 = select_cell_0(_S147.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S152 : Run_0 = unpack_0(_S148, _S149, _S150.thread_0, _S151, _S147.word_0);
    var _S153 : Section_0 = section_at_0(_S150);
    var _S154 : bool;
    if(_S147.on_top_0)
    {
        _S154 = (_S152.distance_0) < (_S153.drop_0 * _S152.bend_1.sine_0);
    }
    else
    {
        _S154 = false;
    }
    var _S155 : bool;
    if(_S147.on_top_0)
    {
        _S155 = !_S154;
    }
    else
    {
        _S155 = false;
    }
    var _S156 : f32;
    if(_S155)
    {
        _S156 = 1.0f;
    }
    else
    {
        _S156 = -1.0f;
    }
    var _S157 : f32;
    if(_S154)
    {
        _S157 = _S152.other_reach_0;
    }
    else
    {
        _S157 = _S152.reach_0;
    }
    var _S158 : f32;
    if(_S154)
    {
        _S158 = _S157 + _S152.distance_0;
    }
    else
    {
        _S158 = max(_S157 - _S152.distance_0, 0.0f);
    }
    var _S159 : f32 = _S157 / _S152.bend_1.sine_0 - _S156 * _S153.drop_0;
    var _S160 : f32 = _S158 * _S158;
    var _S161 : f32 = max(_S159 * _S159 - _S160, 9.99999968265522539e-21f);
    var _S162 : f32 = rsqrt_0(_S161);
    var _S163 : f32 = _S160 / (_S161 * _S162 + _S159);
    var _S164 : bool = _S158 > 0.0f;
    var _S165 : f32;
    if(_S147.on_top_0)
    {
        _S165 = 1.0f;
    }
    else
    {
        _S165 = -1.0f;
    }
    var _S166 : f32;
    if(_S152.near_start_0)
    {
        _S166 = 1.0f;
    }
    else
    {
        _S166 = -1.0f;
    }
    var _S167 : f32 = _S165 * _S166;
    if(_S164)
    {
        _S165 = _S159 * _S162;
    }
    else
    {
        _S165 = 1.0f;
    }
    sample_0.slope_across_0 = _S153.slope_0 * _S165;
    if(_S164)
    {
        _S158 = _S167 * _S158 * _S162;
    }
    else
    {
        _S158 = 0.0f;
    }
    sample_0.slope_along_0 = _S158;
    var _S168 : Family_std430_0 = families_0[_S148];
    var _S169 : vec2<f32> = dive_0(_S149, _S147, _S152, _S151);
    if(_S152.straight_0)
    {
        _S156 = 0.0f;
    }
    else
    {
        _S156 = _S168.height_scale_0 * _S156;
    }
    sample_0.height_5 = _S156 * (_S157 * _S152.bend_1.half_tangent_0 - _S163) - _S168.height_scale_0 * _S153.drop_0 - _S169.x;
    var _S170 : f32 = _S168.height_scale_0 * sample_0.slope_across_0;
    var _S171 : f32 = _S168.height_scale_0 * sample_0.slope_along_0 - _S169.y;
    if(_S147.is_warp_0)
    {
        _S156 = _S170;
    }
    else
    {
        _S156 = _S171;
    }
    sample_0.slope_x_1 = _S156;
    if(_S147.is_warp_0)
    {
        _S156 = _S171;
    }
    else
    {
        _S156 = _S170;
    }
    sample_0.slope_y_1 = _S156;
    sample_0.run_3 = _S152;
    sample_0.section_1 = _S153;
    return sample_0;
}

fn steps_per_length_0( _S172 : u32,  _S173 : SearchQuality_0,  _S174 : vec3<f32>) -> f32
{
    return max(max(abs(_S174.x) * fabrics_0[_S172].threads_per_x_0, abs(_S174.y) * fabrics_0[_S172].threads_per_y_0) * _S173.steps_per_thread_0, abs(_S174.z) * fabrics_0[_S172].per_relief_0 * _S173.steps_per_relief_0);
}

fn cell_maximum_0( _S175 : u32,  _S176 : Crossing_0) -> f32
{
    var _S177 : u32;
    if(_S176.warp_above_0)
    {
        _S177 = fabrics_0[_S175].warp_0;
    }
    else
    {
        _S177 = fabrics_0[_S175].weft_0;
    }
    var _S178 : u32;
    if(_S176.warp_above_0)
    {
        _S178 = _S176.warp_word_0;
    }
    else
    {
        _S178 = _S176.weft_word_0;
    }
    return f32((_S178 >> (u32(28)))) * families_0[_S177].height_scale_0 * families_0[_S177].level_0;
}

fn probe_0( _S179 : u32,  _S180 : f32,  _S181 : f32,  _S182 : bool,  _S183 : bool,  _S184 : bool) -> Probe_0
{
    var _S185 : Sample_0 = sample_at_0(_S179, _S180, _S181, _S182);
    var probe_1 : Probe_0;
    probe_1.height_1 = _S185.height_5;
    probe_1.hole_1 = _S185.shown_3.hole_0;
    probe_1.slope_x_0 = _S185.slope_x_1;
    probe_1.slope_y_0 = _S185.slope_y_1;
    var _S186 : u32;
    if(_S185.shown_3.is_warp_0)
    {
        _S186 = _S185.crossing_1.warp_1.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S186 = _S185.crossing_1.weft_1.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S186;
    probe_1.cell_max_0 = cell_maximum_0(_S179, _S185.crossing_1);
    var _S187 : f32;
    if(_S183)
    {
        _S187 = _S185.crossing_1.warp_1.above_0;
    }
    else
    {
        _S187 = _S185.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S187;
    if(_S184)
    {
        _S187 = _S185.crossing_1.weft_1.above_0;
    }
    else
    {
        _S187 = _S185.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S187;
    probe_1.edge_x_0 = outline_distance_0(_S185.crossing_1.warp_1, _S185.shown_3, _S185.run_3, !_S185.shown_3.is_warp_0, _S183);
    probe_1.edge_y_0 = outline_distance_0(_S185.crossing_1.weft_1, _S185.shown_3, _S185.run_3, _S185.shown_3.is_warp_0, _S184);
    return probe_1;
}

fn is_free_0( _S188 : u32,  _S189 : SearchQuality_0,  _S190 : vec3<f32>,  _S191 : vec3<f32>,  _S192 : bool,  _S193 : f32) -> bool
{
    var _S194 : f32 = _S191.z;
    if(_S194 <= 0.0f)
    {
        return false;
    }
    var _S195 : f32 = 1.0f / max(_S189.shadow_share_0 * steps_per_length_0(_S188, _S189, _S191), 9.99999971718068537e-10f);
    var _S196 : StepControl_0 = step_control_0(_S191.xy, _S195);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_1 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S197 : bool;
        if(count_1 < u32(1024))
        {
            _S197 = (_S190.z + _S194 * distance_1) < _S193;
        }
        else
        {
            _S197 = false;
        }
        if(_S197)
        {
        }
        else
        {
            break;
        }
        var _S198 : vec3<f32> = _S190 + _S191 * vec3<f32>(distance_1);
        var _S199 : Probe_0 = probe_0(_S188, _S198.x, _S198.y, _S192, _S196.right_0, _S196.up_0);
        var _S200 : f32 = _S198.z;
        var _S201 : f32 = _S200 - _S199.height_1;
        var _S202 : f32 = _S194 - _S199.slope_x_0 * _S191.x - _S199.slope_y_0 * _S191.y;
        var _S203 : bool;
        if(!_S199.hole_1)
        {
            _S203 = _S201 < 0.0f;
        }
        else
        {
            _S203 = false;
        }
        if(_S203)
        {
            return false;
        }
        var _S204 : f32 = way_back_to_dip_0(previous_3, _S201, _S202, last_step_0, _S199);
        if(_S204 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S204;
            distance_1 = distance_1 - _S204;
            last_step_0 = last_step_1;
            count_1 = count_1 + u32(1);
            continue;
        }
        var _S205 : bool = _S200 > (_S199.cell_max_0);
        var _S206 : PreviousSample_0 = after_sample_0(_S201, _S202, _S199, _S205);
        var last_step_2 : f32;
        if(_S205)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S196, _S199.side_x_0, _S199.side_y_0), _S195);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S196, _S199, _S201, _S202);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S206;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + u32(1);
    }
    return true;
}

fn passes_through_0( _S207 : u32,  _S208 : SearchQuality_0,  _S209 : f32,  _S210 : f32,  _S211 : vec3<f32>,  _S212 : bool) -> bool
{
    if(!sample_at_0(_S207, _S209, _S210, _S212).shown_3.hole_0)
    {
        return false;
    }
    var _S213 : vec3<f32> = vec3<f32>(_S209, _S210, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S214 : bool;
        if(side_0 < u32(2))
        {
            _S214 = passes_0;
        }
        else
        {
            _S214 = false;
        }
        if(_S214)
        {
        }
        else
        {
            break;
        }
        var _S215 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S215 = _S211;
        }
        else
        {
            _S215 = vec3<f32>(- _S211.x, - _S211.y, _S211.z);
        }
        var _S216 : bool = is_free_0(_S207, _S208, _S213, _S215, _S212 != (side_0 == u32(1)), fabrics_0[_S207].height_high_0);
        var _S217 : u32 = side_0 + u32(1);
        passes_0 = _S216;
        side_0 = _S217;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_6 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S218 : u32,  _S219 : f32,  _S220 : f32,  _S221 : f32,  _S222 : vec3<f32>,  _S223 : bool) -> f32
{
    var _S224 : u32 = locate_0(fabrics_0[_S218].warp_0, _S219).thread_0 / u32(2);
    var _S225 : u32 = locate_0(fabrics_0[_S218].weft_0, _S220).thread_0 / u32(2);
    var _S226 : f32 = _S222.x;
    var _S227 : u32;
    if(_S226 > 0.0f)
    {
        _S227 = u32(1);
    }
    else
    {
        _S227 = u32(0);
    }
    var _S228 : f32 = _S222.y;
    var _S229 : u32;
    if(_S228 > 0.0f)
    {
        _S229 = u32(2);
    }
    else
    {
        _S229 = u32(0);
    }
    var _S230 : u32 = words_0[fabrics_0[_S218].max_heights_0 + u32(4) * (_S225 * fabrics_0[_S218].max_height_columns_0 + _S224) + (_S227 + _S229)];
    var number_0 : i32;
    if(_S223)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S231 : u32 = (_S230 >> (u32(number_0)));
    var _S232 : f32 = max(abs(_S226) * fabrics_0[_S218].threads_per_x_0, abs(_S228) * fabrics_0[_S218].threads_per_y_0) / _S222.z;
    var _S233 : f32 = fabrics_0[_S218].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S218].height_high_0;
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
        if(((max_height_0 - _S221) * _S232) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S231 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S233);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S234 : u32,  _S235 : f32,  _S236 : f32,  _S237 : bool,  _S238 : bool,  _S239 : bool) -> vec3<f32>
{
    var _S240 : Crossing_0 = crossing_at_0(_S234, _S235, _S236, _S237);
    var _S241 : f32 = cell_maximum_0(_S234, _S240);
    var _S242 : f32;
    if(_S238)
    {
        _S242 = _S240.warp_1.above_0;
    }
    else
    {
        _S242 = _S240.warp_1.below_0;
    }
    var _S243 : f32;
    if(_S239)
    {
        _S243 = _S240.weft_1.above_0;
    }
    else
    {
        _S243 = _S240.weft_1.below_0;
    }
    return vec3<f32>(_S241, _S242, _S243);
}

fn first_sample_height_0( _S244 : u32,  _S245 : ViewRay_0,  _S246 : StepControl_0,  _S247 : bool) -> f32
{
    var _S248 : f32 = max_height_along_0(_S244, _S245.origin_0.x, _S245.origin_0.y, 0.0f, vec3<f32>(_S245.slope_1, 1.0f), _S247);
    var count_2 : u32 = u32(0);
    var height_7 : f32 = _S248;
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S249 : vec2<f32> = ViewRay_at_0(_S245, height_7);
        var _S250 : vec3<f32> = cell_bounds_0(_S244, _S249.x, _S249.y, _S247, _S246.right_0, _S246.up_0);
        var _S251 : f32 = height_7 - _S250.x;
        var _S252 : f32 = StepControl_to_cell_exit_0(_S246, _S250.y, _S250.z);
        var height_8 : f32 = height_7 - clamp(_S251, 0.0f, _S252);
        if(_S251 <= _S252)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S253 : u32,  _S254 : ViewRay_0,  _S255 : StepControl_0,  _S256 : bool) -> ViewRayEnd_0
{
    var _S257 : f32 = fabrics_0[_S253].height_low_0 - (fabrics_0[_S253].height_high_0 - fabrics_0[_S253].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S253, _S254, _S255, _S256);
    end_1.last_step_3 = _S255.epsilon_0;
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
        var _S258 : vec2<f32> = ViewRay_at_0(_S254, end_1.height_6);
        var _S259 : Probe_0 = probe_0(_S253, _S258.x, _S258.y, _S256, _S255.right_0, _S255.up_0);
        var _S260 : f32 = end_1.height_6 - _S259.height_1;
        var _S261 : f32 = ViewRay_rate_0(_S254, _S259);
        end_1.depth_1 = - _S260;
        end_1.rate_4 = _S261;
        var _S262 : bool;
        if(end_1.previous_4.known_0)
        {
            _S262 = !_S259.hole_1;
        }
        else
        {
            _S262 = false;
        }
        var _S263 : bool;
        if(_S262)
        {
            _S263 = (end_1.previous_4.yarn_0) == (_S259.yarn_1);
        }
        else
        {
            _S263 = false;
        }
        end_1.smooth_0 = _S263;
        var _S264 : bool;
        if(!_S259.hole_1)
        {
            _S264 = _S260 <= 0.0f;
        }
        else
        {
            _S264 = false;
        }
        var _S265 : bool;
        if(_S264)
        {
            _S265 = true;
        }
        else
        {
            _S265 = (end_1.height_6) <= _S257;
        }
        if(_S265)
        {
            break;
        }
        var _S266 : f32 = way_back_to_dip_0(end_1.previous_4, _S260, _S261, end_1.last_step_3, _S259);
        if(_S266 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S266;
            end_1.last_step_3 = end_1.last_step_3 - _S266;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S267 : f32 = min(StepControl_to_cell_exit_0(_S255, _S259.side_x_0, _S259.side_y_0), end_1.height_6 - _S259.cell_max_0);
        var _S268 : f32 = StepControl_to_next_sample_0(_S255, _S259, _S260, _S261);
        end_1.previous_4 = after_sample_0(_S260, _S261, _S259, _S267 > _S268);
        var _S269 : f32 = max(_S267, _S268);
        end_1.last_step_3 = _S269;
        end_1.height_6 = end_1.height_6 - _S269;
        count_3 = count_3 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S270 : u32,  _S271 : ViewRay_0,  _S272 : StepControl_0,  _S273 : bool,  _S274 : ViewRayEnd_0,  _S275 : u32) -> f32
{
    var _S276 : f32 = fabrics_0[_S270].height_high_0 - fabrics_0[_S270].height_low_0;
    var above_2 : f32 = _S274.height_6 + _S274.last_step_3;
    var above_gap_1 : f32 = clamp(_S274.previous_4.clearance_0, 0.0f, _S276);
    var under_gap_1 : f32 = clamp(_S274.depth_1, 0.0f, _S276);
    var _S277 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S274.previous_4.rate_0 * _S274.last_step_3, _S274.rate_4 * _S274.last_step_3);
    var middle_0 : f32;
    if(_S274.smooth_0)
    {
        middle_0 = above_2 - _S277 * _S274.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S274.height_6, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S274.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S275)
        {
        }
        else
        {
            break;
        }
        var _S278 : vec2<f32> = ViewRay_at_0(_S271, middle_0);
        var _S279 : Probe_0 = probe_0(_S270, _S278.x, _S278.y, _S273, _S272.right_0, _S272.up_0);
        var _S280 : f32;
        if(_S279.hole_1)
        {
            _S280 = -1.0e+09f;
        }
        else
        {
            _S280 = _S279.height_1;
        }
        var _S281 : f32 = clamp(middle_0 - _S280, - _S276, _S276);
        var _S282 : f32;
        if(_S281 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S282 = 0.5f * above_gap_2;
            }
            else
            {
                _S282 = above_gap_2;
            }
            var _S283 : f32 = - _S281;
            under_1 = middle_0;
            above_gap_2 = _S282;
            under_gap_2 = _S283;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S282 = 0.5f * under_gap_2;
            }
            else
            {
                _S282 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S281;
            under_gap_2 = _S282;
            side_1 = -1.0f;
        }
        if(_S274.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S281 / min(ViewRay_rate_0(_S271, _S279), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S274.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S284 : u32,  _S285 : SearchQuality_0,  _S286 : f32,  _S287 : f32,  _S288 : vec3<f32>,  _S289 : bool) -> Hit_0
{
    var _S290 : f32 = max(_S288.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S286, _S287);
    var _S291 : vec2<f32> = _S288.xy / vec2<f32>(_S290);
    ray_0.slope_1 = _S291;
    var _S292 : StepControl_0 = step_control_0((vec2<f32>(0) - _S291), 1.0f / max(steps_per_length_0(_S284, _S285, _S288) / _S290, 9.99999971718068537e-10f));
    var _S293 : ViewRayEnd_0 = search_down_0(_S284, ray_0, _S292, _S289);
    var hit_0 : Hit_0;
    hit_0.hole_3 = false;
    var _S294 : f32 = refined_height_0(_S284, ray_0, _S292, _S289, _S293, _S285.refinements_0);
    hit_0.height_4 = _S294;
    var _S295 : vec2<f32> = ViewRay_at_0(ray_0, _S294);
    hit_0.x_9 = _S295.x;
    hit_0.y_4 = _S295.y;
    return hit_0;
}

fn first_hit_0( _S296 : u32,  _S297 : SearchQuality_0,  _S298 : f32,  _S299 : f32,  _S300 : vec3<f32>,  _S301 : bool) -> Hit_0
{
    if(!passes_through_0(_S296, _S297, _S298, _S299, _S300, _S301))
    {
        return first_hit_of_yarn_0(_S296, _S297, _S298, _S299, _S300, _S301);
    }
    var hit_1 : Hit_0;
    hit_1.x_9 = _S298;
    hit_1.y_4 = _S299;
    hit_1.height_4 = 0.0f;
    hit_1.hole_3 = true;
    return hit_1;
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_2 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_9 : f32,
     normal_4 : vec3<f32>,
     tangent_5 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn surface_at_0( _S302 : u32,  _S303 : f32,  _S304 : f32,  _S305 : bool) -> SurfacePoint_0
{
    var _S306 : Sample_0 = sample_at_0(_S302, _S303, _S304, _S305);
    var _S307 : f32;
    if(_S306.shown_3.is_warp_0)
    {
        _S307 = _S306.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S307 = _S306.crossing_1.weft_1.half_width_1;
    }
    var _S308 : u32;
    if(_S306.shown_3.is_warp_0)
    {
        _S308 = fabrics_0[_S302].warp_0;
    }
    else
    {
        _S308 = fabrics_0[_S302].weft_0;
    }
    var _S309 : Family_std430_0 = families_0[_S308];
    var _S310 : f32;
    if(_S305)
    {
        _S310 = -1.0f;
    }
    else
    {
        _S310 = 1.0f;
    }
    var _S311 : f32 = _S309.twist_sine_0 * _S310;
    var _S312 : Family_std430_0 = families_0[_S308];
    if(_S306.shown_3.is_warp_0)
    {
        _S310 = 1.0f;
    }
    else
    {
        _S310 = -1.0f;
    }
    var _S313 : vec2<f32> = fibre_direction_0(_S306.slope_across_0, _S310 * _S306.slope_along_0, _S311, _S312.twist_cosine_0);
    var _S314 : f32;
    if(_S306.shown_3.is_warp_0)
    {
        _S314 = _S306.slope_x_1;
    }
    else
    {
        _S314 = _S306.slope_y_1;
    }
    var _S315 : f32;
    if(_S306.shown_3.is_warp_0)
    {
        _S315 = _S306.slope_y_1;
    }
    else
    {
        _S315 = _S306.slope_x_1;
    }
    var _S316 : f32 = _S313.x;
    var _S317 : f32 = _S313.y;
    var _S318 : f32 = _S314 * _S316 + _S310 * _S315 * _S317;
    var _S319 : f32 = _S307 * 1.0154266357421875f;
    var _S320 : f32 = _S319 * arc_sine_0(clamp(_S306.section_1.across_1 / _S319, -1.0f, 1.0f));
    if(_S306.shown_3.is_warp_0)
    {
        _S307 = _S304;
    }
    else
    {
        _S307 = - _S303;
    }
    var point_0 : SurfacePoint_0;
    point_0.hole_4 = _S306.shown_3.hole_0;
    point_0.is_warp_2 = _S306.shown_3.is_warp_0;
    point_0.warp_thread_0 = _S306.crossing_1.warp_1.thread_0;
    point_0.weft_thread_0 = _S306.crossing_1.weft_1.thread_0;
    point_0.height_9 = _S306.height_5;
    point_0.normal_4 = normalize(vec3<f32>(- _S306.slope_x_1, - _S306.slope_y_1, 1.0f));
    var _S321 : vec3<f32>;
    if(_S306.shown_3.is_warp_0)
    {
        _S321 = vec3<f32>(_S316, _S317, _S318);
    }
    else
    {
        _S321 = vec3<f32>(- _S317, _S316, _S318);
    }
    point_0.tangent_5 = normalize(_S321);
    point_0.across_2 = _S306.section_1.across_1;
    point_0.fibre_across_0 = _S320 * _S312.twist_cosine_0 + _S307 * _S311;
    point_0.fibre_along_0 = _S307 * _S312.twist_cosine_0 - _S320 * _S311;
    return point_0;
}

fn vary_albedos_0( _S322 : u32,  _S323 : Albedos_0,  _S324 : u32,  _S325 : u32) -> Albedos_0
{
    var _S326 : vec3<f32> = max(_S323.specular_reflect_0, _S323.specular_transmit_0);
    var _S327 : vec3<f32> = _S323.diffuse_reflect_0 + _S323.diffuse_transmit_0;
    var _S328 : vec3<f32> = vec3<f32>(fabrics_0[_S322].layer_bound_0);
    var _S329 : vec3<f32> = vec3<f32>(1.0f);
    var _S330 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S324, fabrics_0[_S322].colour_noise_0, fabrics_0[_S322].seed_0), _S327, _S329 - _S328 * _S326));
    var _S331 : f32 = bounded_gain_0(fibre_gain_0(_S324, _S325, fabrics_0[_S322].fibre_noise_0, fabrics_0[_S322].seed_0), _S326, min((_S329 - _S330 * _S327) / _S328, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S330 * _S323.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S330 * _S323.diffuse_transmit_0;
    var _S332 : vec3<f32> = vec3<f32>(_S331);
    varied_0.specular_reflect_0 = _S332 * _S323.specular_reflect_0;
    varied_0.specular_transmit_0 = _S332 * _S323.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S333 : u32,  _S334 : SurfacePoint_0,  _S335 : Albedos_0,  _S336 : f32,  _S337 : f32) -> Albedos_0
{
    var _S338 : f32;
    if(_S334.is_warp_2)
    {
        _S338 = _S336;
    }
    else
    {
        _S338 = _S337;
    }
    var _S339 : f32 = _S338 - _S334.across_2;
    var _S340 : u32;
    if(_S334.is_warp_2)
    {
        _S340 = fabrics_0[_S333].warp_0;
    }
    else
    {
        _S340 = fabrics_0[_S333].weft_0;
    }
    var _S341 : Family_std430_0 = families_0[_S340];
    var _S342 : i32 = i32(families_0[_S340].count_0);
    if(_S334.is_warp_2)
    {
        _S340 = _S334.warp_thread_0;
    }
    else
    {
        _S340 = _S334.weft_thread_0;
    }
    var _S343 : u32 = u32(i32(floor(_S339 / _S341.period_0)) * _S342 + i32(_S340)) * u32(2);
    if(_S334.is_warp_2)
    {
        _S340 = u32(1);
    }
    else
    {
        _S340 = u32(0);
    }
    var _S344 : f32 = floor(_S334.fibre_across_0 / fabrics_0[_S333].fibre_size_0);
    return vary_albedos_0(_S333, _S335, _S343 + _S340, u32(i32(_S344)) * u32(65536) + u32(i32(floor(_S334.fibre_along_0 / (fabrics_0[_S333].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S344))));
}

fn yarn_point_of_0( _S345 : u32,  _S346 : SurfacePoint_0,  _S347 : f32,  _S348 : f32,  _S349 : bool,  _S350 : bool) -> YarnPoint_0
{
    var _S351 : u32;
    if(_S346.is_warp_2)
    {
        _S351 = fabrics_0[_S345].warp_0;
    }
    else
    {
        _S351 = fabrics_0[_S345].weft_0;
    }
    var _S352 : u32;
    if(_S346.is_warp_2)
    {
        _S352 = _S346.warp_thread_0;
    }
    else
    {
        _S352 = _S346.weft_thread_0;
    }
    var albedos_2 : Albedos_0 = albedos_of_0(_S351, _S352);
    var _S353 : bool;
    if((fabrics_0[_S345].fibre_noise_0) > 0.0f)
    {
        _S353 = true;
    }
    else
    {
        _S353 = (fabrics_0[_S345].colour_noise_0) > 0.0f;
    }
    var albedos_3 : Albedos_0;
    if(_S353)
    {
        albedos_3 = varied_at_0(_S345, _S346, albedos_2, _S347, _S348);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    var point_1 : YarnPoint_0;
    point_1.back_5 = _S349;
    point_1.hole_2 = _S350;
    point_1.is_warp_1 = _S346.is_warp_2;
    point_1.x_8 = _S347;
    point_1.y_3 = _S348;
    point_1.height_3 = _S346.height_9;
    point_1.normal_3 = _S346.normal_4;
    point_1.tangent_4 = _S346.tangent_5;
    point_1.roughness_8 = families_0[_S351].roughness_0;
    point_1.albedos_1 = albedos_3;
    return point_1;
}

fn locate_yarn_0( _S354 : u32,  _S355 : SearchQuality_0,  _S356 : f32,  _S357 : f32,  _S358 : vec3<f32>) -> YarnPoint_0
{
    var _S359 : bool = (_S358.z) < 0.0f;
    var _S360 : Hit_0 = first_hit_0(_S354, _S355, _S356, _S357, to_face_frame_0(_S358, _S359), _S359);
    return yarn_point_of_0(_S354, surface_at_0(_S354, _S360.x_9, _S360.y_4, _S359), _S360.x_9, _S360.y_4, _S359, _S360.hole_3);
}

fn openness_number_0( _S361 : u32,  _S362 : u32) -> f32
{
    return table_number_0(fabrics_0[_S361].openness_0 + _S362);
}

fn blocked_of_terms_0( _S363 : u32,  _S364 : u32,  _S365 : array<f32, i32(6)>,  _S366 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_1 : u32 = u32(0);
    for(;;)
    {
        if(share_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_1] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S366)
            {
            }
            else
            {
                break;
            }
            shares_0[share_1] = shares_0[share_1] + openness_number_0(_S363, _S364 + share_1 * _S366 + term_0) * _S365[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_1] = saturate(shares_0[share_1]);
        share_1 = share_1 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_at_0( _S367 : u32,  _S368 : bool,  _S369 : bool,  _S370 : f32,  _S371 : f32) -> Blocked_0
{
    var _S372 : f32 = _S371 * openness_number_0(_S367, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S370, _S372, _S370 * _S370, _S370 * _S372, _S372 * _S372 );
    var _S373 : u32;
    if(_S369)
    {
        _S373 = u32(2);
    }
    else
    {
        _S373 = u32(0);
    }
    var _S374 : u32;
    if(_S368)
    {
        _S374 = u32(0);
    }
    else
    {
        _S374 = u32(1);
    }
    return blocked_of_terms_0(_S367, u32(60) + (_S373 + _S374) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S375 : u32,  _S376 : Albedos_0,  _S377 : u32,  _S378 : vec3<f32>) -> Scattered_0
{
    var _S379 : u32 = u32(159) + u32(2) * _S377;
    var yarn_3 : Scattered_0;
    yarn_3.back_4 = _S378 * _S376.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S375, _S379)) * _S376.specular_reflect_0;
    yarn_3.through_0 = _S378 * _S376.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S375, _S379 + u32(1))) * _S376.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S380 : u32,  _S381 : u32,  _S382 : vec3<f32>,  _S383 : vec3<f32>,  _S384 : vec3<f32>,  _S385 : vec3<f32>,  _S386 : ptr<function, vec3<f32>>,  _S387 : ptr<function, vec3<f32>>)
{
    var _S388 : u32 = u32(146) + u32(4) * _S381;
    var _S389 : f32 = openness_number_0(_S380, _S388 + u32(1));
    var _S390 : f32 = openness_number_0(_S380, _S388 + u32(2));
    var _S391 : vec3<f32> = vec3<f32>(1.0f);
    var _S392 : vec3<f32> = _S391 - _S384 * vec3<f32>(openness_number_0(_S380, _S388));
    var _S393 : vec3<f32> = _S391 - _S385 * vec3<f32>(openness_number_0(_S380, _S388 + u32(3)));
    var _S394 : vec3<f32> = _S391 / (_S392 * _S393 - _S384 * _S385 * vec3<f32>((_S389 * _S390)));
    (*_S386) = (_S382 * _S393 + _S384 * vec3<f32>(_S389) * _S383) * _S394;
    (*_S387) = (_S383 * _S392 + _S385 * vec3<f32>(_S390) * _S382) * _S394;
    return;
}

fn face_sends_0( _S395 : u32,  _S396 : u32,  _S397 : Scattered_0,  _S398 : Scattered_0) -> FaceSends_0
{
    var _S399 : u32 = u32(2) * _S396;
    var _S400 : u32 = u32(142) + _S399;
    var _S401 : f32 = openness_number_0(_S395, _S400);
    var _S402 : f32 = openness_number_0(_S395, _S400 + u32(1));
    var _S403 : vec3<f32> = vec3<f32>((1.0f - _S401)) * _S397.back_4;
    var _S404 : vec3<f32> = vec3<f32>((1.0f - _S402)) * _S398.back_4;
    var sends_1 : FaceSends_0;
    var _S405 : u32 = u32(154) + _S399;
    var _S406 : f32 = openness_number_0(_S395, _S405);
    sends_1.blocks_warp_0 = _S406;
    var _S407 : f32 = openness_number_0(_S395, _S405 + u32(1));
    sends_1.blocks_weft_0 = _S407;
    sends_1.open_0 = _S406 * _S401 + _S407 * _S402;
    var _S408 : vec3<f32> = vec3<f32>(_S401) * _S397.back_4;
    var _S409 : vec3<f32> = vec3<f32>(_S402) * _S398.back_4;
    var _S410 : vec3<f32> = sends_1.sky_warp_0;
    var _S411 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S395, _S396, _S408, _S409, _S403, _S404, &(_S410), &(_S411));
    sends_1.sky_warp_0 = _S410;
    sends_1.sky_weft_0 = _S411;
    var _S412 : vec3<f32> = sends_1.crossing_warp_0;
    var _S413 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S395, _S396, _S397.through_0, _S398.through_0, _S403, _S404, &(_S412), &(_S413));
    sends_1.crossing_warp_0 = _S412;
    sends_1.crossing_weft_0 = _S413;
    return sends_1;
}

fn interior_of_0( _S414 : u32,  _S415 : vec3<f32>,  _S416 : bool) -> Interior_0
{
    var _S417 : Scattered_0 = scattered_by_0(_S414, table_albedos_0(families_0[fabrics_0[_S414].warp_0].colour_mean_0), u32(0), _S415);
    var _S418 : Scattered_0 = scattered_by_0(_S414, table_albedos_0(families_0[fabrics_0[_S414].weft_0].colour_mean_0), u32(1), _S415);
    var _S419 : u32;
    if(_S416)
    {
        _S419 = u32(1);
    }
    else
    {
        _S419 = u32(0);
    }
    var _S420 : FaceSends_0 = face_sends_0(_S414, _S419, _S417, _S418);
    if(_S416)
    {
        _S419 = u32(0);
    }
    else
    {
        _S419 = u32(1);
    }
    var _S421 : FaceSends_0 = face_sends_0(_S414, _S419, _S417, _S418);
    var _S422 : vec3<f32> = vec3<f32>(_S420.blocks_warp_0);
    var _S423 : vec3<f32> = vec3<f32>(_S420.blocks_weft_0);
    var _S424 : vec3<f32> = _S422 * _S420.crossing_warp_0 + _S423 * _S420.crossing_weft_0;
    var _S425 : vec3<f32> = vec3<f32>(_S421.blocks_warp_0);
    var _S426 : vec3<f32> = vec3<f32>(_S421.blocks_weft_0);
    var _S427 : vec3<f32> = _S425 * _S421.crossing_warp_0 + _S426 * _S421.crossing_weft_0;
    var _S428 : f32 = 1.0f - _S420.open_0;
    var _S429 : f32 = 1.0f - _S421.open_0;
    var _S430 : vec3<f32> = vec3<f32>(1.0f);
    var _S431 : vec3<f32> = _S430 / (_S430 - _S424 * _S427 * vec3<f32>((_S428 * _S429)));
    var _S432 : vec3<f32> = _S427 * (vec3<f32>(_S420.open_0) + vec3<f32>(_S428) * (_S422 * _S420.sky_warp_0 + _S423 * _S420.sky_weft_0)) * _S431;
    var _S433 : vec3<f32> = _S424 * (vec3<f32>(_S421.open_0) + vec3<f32>(_S429) * (_S425 * _S421.sky_warp_0 + _S426 * _S421.sky_weft_0)) * _S431;
    var _S434 : FaceRadiance_0 = face_radiance_0(_S420, _S421.open_0, _S432, _S433);
    var _S435 : FaceRadiance_0 = face_radiance_0(_S421, _S420.open_0, _S433, _S432);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S434.warp_2;
    interior_1.weft_3 = _S434.weft_2;
    interior_1.leaked_1 = _S434.leaked_0;
    interior_1.far_1 = _S435.mean_0;
    interior_1.far_leaked_0 = _S435.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S436 : u32,  _S437 : YarnPoint_0,  _S438 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S439 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S439;
    nothing_0.transmitted_0 = _S439;
    var _S440 : bool;
    if((fabrics_0[_S436].openness_0) == u32(4294967295))
    {
        _S440 = true;
    }
    else
    {
        _S440 = _S437.hole_2;
    }
    if(_S440)
    {
        return nothing_0;
    }
    var _S441 : Blocked_0 = blocked_at_0(_S436, _S437.is_warp_1, _S437.back_5, _S437.normal_3.z, _S437.height_3);
    var _S442 : u32;
    if(_S437.is_warp_1)
    {
        _S442 = u32(0);
    }
    else
    {
        _S442 = u32(1);
    }
    return bounced_by_0(_S441, scattered_by_0(_S436, _S437.albedos_1, _S442, _S438), interior_of_0(_S436, _S438, _S437.back_5));
}

fn scattered_0( _S443 : u32,  _S444 : YarnPoint_0,  _S445 : vec3<f32>,  _S446 : vec3<f32>) -> vec3<f32>
{
    var _S447 : vec3<f32> = vec3<f32>(0.0f);
    var _S448 : bool = !_S444.hole_2;
    var _S449 : bool;
    if(_S448)
    {
        _S449 = (_S445.z) > 0.0f;
    }
    else
    {
        _S449 = false;
    }
    var value_1 : vec3<f32>;
    if(_S449)
    {
        value_1 = _S444.albedos_1.diffuse_reflect_0 * vec3<f32>(diffuse_reflection_0(_S445, _S444.normal_3, fabrics_0[_S443].diffuse_blend_0)) + _S444.albedos_1.specular_reflect_0 * vec3<f32>(reflection_0(_S445, _S446, _S444.normal_3, _S444.tangent_4, _S444.roughness_8, fabrics_0[_S443].optical_depth_0));
    }
    else
    {
        if(_S448)
        {
            _S449 = (_S445.z) < 0.0f;
        }
        else
        {
            _S449 = false;
        }
        if(_S449)
        {
            value_1 = _S444.albedos_1.diffuse_transmit_0 * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S445), _S444.normal_3, fabrics_0[_S443].diffuse_blend_0)) + _S444.albedos_1.specular_transmit_0 * vec3<f32>(transmission_1(_S445, _S446, _S444.normal_3, _S444.tangent_4, _S444.roughness_8, fabrics_0[_S443].optical_depth_0));
        }
        else
        {
            value_1 = _S447;
        }
    }
    var _S450 : f32 = fabrics_0[_S443].sheen_strength_0;
    if((fabrics_0[_S443].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S451 : vec2<f32> = sheen_with_transmittance_0(_S445, _S446, _S450, fabrics_0[_S443].sheen_roughness_0);
    return vec3<f32>(_S451.y) * value_1 + vec3<f32>(_S451.x);
}

fn unoccluded_0( _S452 : u32,  _S453 : SearchQuality_0,  _S454 : f32,  _S455 : f32,  _S456 : f32,  _S457 : vec3<f32>,  _S458 : bool) -> bool
{
    if((_S457.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S452, _S453, vec3<f32>(_S454, _S455, _S456 + fabrics_0[_S452].lift_0), _S457, _S458, max_height_along_0(_S452, _S454, _S455, _S456, _S457, _S458));
}

fn is_lit_0( _S459 : u32,  _S460 : SearchQuality_0,  _S461 : YarnPoint_0,  _S462 : vec3<f32>) -> bool
{
    if(_S461.hole_2)
    {
        return true;
    }
    var _S463 : vec3<f32> = to_face_frame_0(_S462, _S461.back_5);
    var _S464 : f32 = _S463.z;
    var _S465 : bool = _S464 < 0.0f;
    var normal_5 : vec3<f32>;
    var height_10 : f32;
    if(_S465)
    {
        var _S466 : SurfacePoint_0 = surface_at_0(_S459, _S461.x_8, _S461.y_3, !_S461.back_5);
        normal_5 = _S466.normal_4;
        height_10 = _S466.height_9;
    }
    else
    {
        normal_5 = _S461.normal_3;
        height_10 = _S461.height_3;
    }
    var _S467 : vec3<f32> = vec3<f32>(_S463.xy, abs(_S464));
    if((dot(normal_5, _S467)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S459, _S460, _S461.x_8, _S461.y_3, height_10, _S467, (_S461.back_5) != _S465);
}

fn evaluate_with_0( _S468 : u32,  _S469 : SearchQuality_0,  _S470 : YarnPoint_0,  _S471 : Bounced_0,  _S472 : vec3<f32>,  _S473 : vec3<f32>) -> vec3<f32>
{
    var _S474 : vec3<f32> = to_face_frame_0(_S473, _S470.back_5);
    var _S475 : vec3<f32> = scattered_0(_S468, _S470, to_face_frame_0(_S472, _S470.back_5), _S474);
    var _S476 : bool;
    if((max(_S475.x, max(_S475.y, _S475.z))) <= 0.0f)
    {
        _S476 = true;
    }
    else
    {
        _S476 = !is_lit_0(_S468, _S469, _S470, _S472);
    }
    var value_2 : vec3<f32>;
    if(_S476)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S475;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S471, _S472, _S473);
    var _S477 : f32 = fabrics_0[_S468].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S468].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S477 * sheen_lobe_0(abs(_S474.z), fabrics_0[_S468].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn evaluate_0( _S478 : u32,  _S479 : SearchQuality_0,  _S480 : YarnPoint_0,  _S481 : vec3<f32>,  _S482 : vec3<f32>) -> vec3<f32>
{
    return evaluate_with_0(_S478, _S479, _S480, bounced_at_0(_S478, _S480, vec3<f32>(1.0f)), _S481, _S482);
}

fn straight_through_0( _S483 : u32,  _S484 : YarnPoint_0,  _S485 : vec3<f32>) -> f32
{
    if(!_S484.hole_2)
    {
        return 0.0f;
    }
    var _S486 : f32 = fabrics_0[_S483].sheen_strength_0;
    if((fabrics_0[_S483].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S486 * sheen_lobe_0(abs(_S485.z), fabrics_0[_S483].sheen_roughness_0).z;
}

fn cloth_value_0( fabric_1 : u32,  centre_0 : vec2<f32>,  dx_0 : vec2<f32>,  dy_0 : vec2<f32>,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec4<f32>
{
    var _S487 : SearchQuality_0 = default_quality_0();
    var _S488 : YarnPoint_0 = locate_yarn_0(fabric_1, _S487, centre_0.x, centre_0.y, view_6);
    return vec4<f32>(evaluate_0(fabric_1, _S487, _S488, light_7, view_6), straight_through_0(fabric_1, _S488, view_6));
}

@compute
@workgroup_size(64, 1, 1)
fn point_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S489 : u32 = id_0.x;
    if(_S489 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S490 : Query_std430_0 = queries_0[_S489];
    answers_0[_S489] = cloth_value_0(_S490.fabric_0, vec2<f32>(_S490.centre_x_0, _S490.centre_y_0), vec2<f32>(_S490.dx_x_0, _S490.dx_y_0), vec2<f32>(_S490.dy_x_0, _S490.dy_y_0), vec3<f32>(_S490.light_x_0, _S490.light_y_0, _S490.light_z_0), vec3<f32>(_S490.view_x_0, _S490.view_y_0, _S490.view_z_0));
    return;
}

