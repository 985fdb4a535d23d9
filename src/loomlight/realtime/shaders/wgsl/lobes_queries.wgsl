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

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
var<private> POINT_OFFSETS_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(0.0f, 0.0f), vec2<f32>(-0.23010000586509705f, 0.35670000314712524f), vec2<f32>(0.36809998750686646f, -0.22939999401569366f), vec2<f32>(-0.28040000796318054f, -0.34400001168251038f), vec2<f32>(0.3465999960899353f, 0.28859999775886536f), vec2<f32>(-0.36349999904632568f, 0.0511000007390976f), vec2<f32>(0.09929999709129333f, -0.35699999332427979f), vec2<f32>(0.10710000246763229f, 0.32879999279975891f) );
struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S1 : vec2<f32> = this_0.dx_0;
    var _S2 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S1, _S1) + dot(_S2, _S2)));
}

fn natural_logarithm_0( x_1 : f32) -> f32
{
    var _S3 : u32 = (bitcast<u32>((x_1)));
    var exponent_0 : f32 = f32(i32((_S3 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S3 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S4 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S4 - exponent_1 * 0.00021219444170129f - 0.5f * _S4) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_2 : f32) -> f32
{
    return natural_logarithm_0(x_2) * 1.4426950216293335f;
}

fn to_face_frame_0( direction_0 : vec3<f32>,  back_1 : bool) -> vec3<f32>
{
    var _S5 : vec2<f32> = direction_0.xy;
    var _S6 : f32;
    if(back_1)
    {
        _S6 = - direction_0.z;
    }
    else
    {
        _S6 = direction_0.z;
    }
    return vec3<f32>(_S5, _S6);
}

struct SurfacePoint_0
{
     hole_0 : bool,
     is_warp_0 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_0 : f32,
     normal_0 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_0 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_1 : f32,  normal_1 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32) -> SurfacePoint_0
{
    var _S7 : SurfacePoint_0;
    _S7.hole_0 = hole_1;
    _S7.is_warp_0 = is_warp_1;
    _S7.warp_thread_0 = warp_thread_1;
    _S7.weft_thread_0 = weft_thread_1;
    _S7.height_0 = height_1;
    _S7.normal_0 = normal_1;
    _S7.tangent_0 = tangent_1;
    _S7.across_0 = across_1;
    _S7.fibre_across_0 = fibre_across_1;
    _S7.fibre_along_0 = fibre_along_1;
    return _S7;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_2 : f32,
};

fn no_components_0() -> Components_0
{
    var nothing_0 : Components_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_2 = 0.0f;
    return nothing_0;
}

struct SearchQuality_0
{
     steps_per_thread_0 : f32,
     steps_per_relief_0 : f32,
     shadow_share_0 : f32,
     refinements_0 : u32,
};

fn quality_of_0( threads_0 : f32) -> SearchQuality_0
{
    var _S8 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S9 : f32 = mix(2.5f, 5.0f, _S8);
    quality_0.steps_per_thread_0 = _S9;
    quality_0.steps_per_relief_0 = _S9;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S8);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S8) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_0 : f32) -> vec2<f32>
{
    var _S10 : f32 = floor(fma(index_0, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S10, fma(- _S10, families_0[family_0].count_0, index_0));
}

struct Cell_0
{
     thread_0 : u32,
     across_2 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_0 : f32) -> Cell_0
{
    var _S11 : f32 = floor(position_0 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S12 : f32 = fma(- _S11, families_0[family_1].size_0, position_0);
    cell_0.below_0 = _S12;
    cell_0.above_0 = families_0[family_1].size_0 - _S12;
    cell_0.across_2 = _S12 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S11).y, 0.0f, families_0[family_1].count_0 - 1.0f));
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
    var _S13 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S14 : u32;
    if(_S13 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S14 = u32(1);
    }
    else
    {
        _S14 = u32(0);
    }
    var _S15 : u32 = min(thread_1 + _S14, u32(families_0[family_2].count_0) - u32(1));
    var _S16 : u32 = families_0[family_2].place_table_0 + _S15 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S15;
    cell_1.below_0 = _S13 - table_number_0(_S16);
    cell_1.above_0 = table_number_0(_S16 + u32(1)) - _S13;
    cell_1.across_2 = _S13 - table_number_0(_S16 + u32(2));
    cell_1.half_width_1 = table_number_0(_S16 + u32(3));
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
     is_warp_2 : bool,
     hole_3 : bool,
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
    var _S17 : bool = (abs(crossing_0.warp_1.across_2)) < (crossing_0.warp_1.half_width_1);
    var _S18 : bool = (abs(crossing_0.weft_1.across_2)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S19 : bool;
    if(_S17)
    {
        if(!_S18)
        {
            _S19 = true;
        }
        else
        {
            _S19 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S19 = false;
    }
    shown_0.is_warp_2 = _S19;
    if(!_S17)
    {
        _S19 = !_S18;
    }
    else
    {
        _S19 = false;
    }
    shown_0.hole_3 = _S19;
    var _S20 : u32;
    if(shown_0.is_warp_2)
    {
        _S20 = crossing_0.warp_word_0;
    }
    else
    {
        _S20 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S20;
    shown_0.on_top_0 = (((_S20 & (u32(1)))) == u32(1)) != back_2;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    var _S21 : u32;
    if(is_first_0)
    {
        _S21 = first_0.thread_0;
    }
    else
    {
        _S21 = second_0.thread_0;
    }
    cell_2.thread_0 = _S21;
    var _S22 : f32;
    if(is_first_0)
    {
        _S22 = first_0.across_2;
    }
    else
    {
        _S22 = second_0.across_2;
    }
    cell_2.across_2 = _S22;
    if(is_first_0)
    {
        _S22 = first_0.half_width_1;
    }
    else
    {
        _S22 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S22;
    if(is_first_0)
    {
        _S22 = first_0.below_0;
    }
    else
    {
        _S22 = second_0.below_0;
    }
    cell_2.below_0 = _S22;
    if(is_first_0)
    {
        _S22 = first_0.above_0;
    }
    else
    {
        _S22 = second_0.above_0;
    }
    cell_2.above_0 = _S22;
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S23 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S23.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S23.y) * u32(4)));
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
    var _S24 : Family_std430_0 = families_0[family_6];
    var _S25 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S25 = u32(0);
    }
    else
    {
        _S25 = thread_4 * u32(4);
    }
    var _S26 : u32 = _S24.bend_table_0 + _S25;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S26);
    bend_0.half_tangent_0 = table_number_0(_S26 + u32(1));
    bend_0.arc_0 = table_number_0(_S26 + u32(2));
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
    var _S27 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S28 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S29 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S30 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S31 : i32 = - _S27;
    var _S32 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S31, i32(0));
    run_0.from_start_0 = _S32;
    var _S33 : i32 = _S28 + i32(1);
    var _S34 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S33);
    run_0.to_end_0 = _S34;
    var _S35 : bool = _S32 < _S34;
    run_0.near_start_0 = _S35;
    var _S36 : i32;
    if(_S35)
    {
        _S36 = _S31 - _S29;
    }
    else
    {
        _S36 = _S33;
    }
    var _S37 : i32;
    if(run_0.near_start_0)
    {
        _S37 = _S31;
    }
    else
    {
        _S37 = _S33 + _S30;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    var _S38 : f32;
    if(run_0.straight_0)
    {
        _S38 = 1.0e+06f;
    }
    else
    {
        _S38 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S38;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S36, _S37), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S27 == i32(0);
    run_0.last_crossing_0 = _S28 == i32(0);
    return run_0;
}

fn square_0( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_3 : Cell_0) -> Section_0
{
    var _S39 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S40 : f32 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S40;
    var _S41 : f32 = _S39 * _S39 - square_0(_S40);
    var _S42 : f32 = rsqrt_0(_S41);
    section_0.drop_0 = _S39 - _S41 * _S42;
    section_0.slope_0 = - _S40 * _S42;
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
    var _S43 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S44 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S45 : f32;
    if(_S43)
    {
        _S45 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S45 = crossed_1.above_0 + crossed_1.across_2;
    }
    var _S46 : f32 = _S45 - crossed_1.half_width_1;
    var _S47 : bool;
    if(_S43)
    {
        _S47 = run_1.first_crossing_0;
    }
    else
    {
        _S47 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S45 = 0.0f;
    }
    else
    {
        _S45 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S48 : f32;
    if((shown_1.on_top_0) != _S47)
    {
        _S48 = 0.0f;
    }
    else
    {
        var _S49 : Family_std430_0 = families_0[other_1];
        var _S50 : i32;
        if(_S43)
        {
            _S50 = i32(-1);
        }
        else
        {
            _S50 = i32(1);
        }
        _S48 = _S49.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S50);
    }
    var _S51 : f32 = 1.0f / max(2.0f * _S46, 9.999999960041972e-13f);
    var _S52 : f32 = clamp((_S46 - _S44) * _S51, 0.0f, 1.0f);
    var _S53 : f32 = _S45 + (_S48 - _S45) * (_S52 * _S52 * (3.0f - 2.0f * _S52));
    var _S54 : f32 = (_S45 - _S48) * (6.0f * _S52 * (1.0f - _S52) * _S51);
    if(_S43)
    {
        _S45 = 1.0f;
    }
    else
    {
        _S45 = -1.0f;
    }
    return vec2<f32>(_S53, _S54 * _S45);
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
    var _S55 : f32 = direction_1.x;
    control_0.per_x_0 = 1.0f / max(abs(_S55), 9.99999971718068537e-10f);
    var _S56 : f32 = direction_1.y;
    control_0.per_y_0 = 1.0f / max(abs(_S56), 9.99999971718068537e-10f);
    control_0.right_0 = _S55 > 0.0f;
    control_0.up_0 = _S56 > 0.0f;
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
    var _S57 : f32;
    if(forwards_0)
    {
        _S57 = cell_4.across_2;
    }
    else
    {
        _S57 = - cell_4.across_2;
    }
    var _S58 : f32;
    if(forwards_0)
    {
        _S58 = cell_4.above_0;
    }
    else
    {
        _S58 = cell_4.below_0;
    }
    var _S59 : bool;
    if(forwards_0)
    {
        _S59 = run_2.last_crossing_0;
    }
    else
    {
        _S59 = run_2.first_crossing_0;
    }
    var _S60 : bool;
    if(forwards_0)
    {
        _S60 = run_2.first_crossing_0;
    }
    else
    {
        _S60 = run_2.last_crossing_0;
    }
    var _S61 : f32 = - cell_4.half_width_1;
    var _S62 : bool = _S57 < _S61;
    var _S63 : bool = _S57 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S59 = !_S59;
    }
    else
    {
        _S59 = false;
    }
    if(_S59)
    {
        _S59 = !shown_2.hole_3;
    }
    else
    {
        _S59 = false;
    }
    var _S64 : bool;
    if(_S59)
    {
        _S64 = shown_2.on_top_0;
    }
    else
    {
        _S64 = false;
    }
    if(_S64)
    {
        if(_S60)
        {
            _S60 = _S62;
        }
        else
        {
            _S60 = false;
        }
        _S60 = !_S60;
    }
    else
    {
        _S60 = false;
    }
    if(shown_2.hole_3)
    {
        _S59 = true;
    }
    else
    {
        if(_S59)
        {
            _S59 = !shown_2.on_top_0;
        }
        else
        {
            _S59 = false;
        }
    }
    var _S65 : f32;
    if(_S62)
    {
        _S65 = _S61;
    }
    else
    {
        _S65 = cell_4.half_width_1;
    }
    var _S66 : f32 = _S65 - _S57;
    if(_S59)
    {
        _S57 = 2.0f * _S58 + _S57 - cell_4.half_width_1;
    }
    else
    {
        _S57 = _S58;
    }
    if(_S60)
    {
        if(forwards_0)
        {
            _S57 = run_2.to_end_0;
        }
        else
        {
            _S57 = run_2.from_start_0;
        }
        return _S57;
    }
    if(_S63)
    {
    }
    else
    {
        _S57 = _S66;
    }
    return _S57;
}

struct Probe_0
{
     height_2 : f32,
     hole_4 : bool,
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
    var _S67 : f32 = previous_1.rate_0 * step_4;
    var _S68 : f32 = rate_1 * step_4;
    var _S69 : bool;
    if(!previous_1.known_0)
    {
        _S69 = true;
    }
    else
    {
        _S69 = here_0.hole_4;
    }
    if(_S69)
    {
        _S69 = true;
    }
    else
    {
        _S69 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S69)
    {
        _S69 = true;
    }
    else
    {
        _S69 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S69)
    {
        _S69 = true;
    }
    else
    {
        _S69 = rate_1 <= 0.0f;
    }
    if(_S69)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S67) >= 0.0f)
    {
        _S69 = (3.0f * clearance_1 - _S68) >= 0.0f;
    }
    else
    {
        _S69 = false;
    }
    if(_S69)
    {
        return -1.0f;
    }
    var _S70 : f32 = clearance_1 - previous_1.clearance_0;
    var _S71 : f32 = 6.0f * _S70 - 4.0f * _S67 - 2.0f * _S68;
    var _S72 : f32 = -2.0f * _S67 / max(_S71 + sqrt(max(_S71 * _S71 - 4.0f * (3.0f * (_S67 + _S68 - 2.0f * _S70)) * _S67, 0.0f)), 9.99999968265522539e-21f);
    var _S73 : f32 = 1.0f - _S72;
    var _S74 : f32 = (previous_1.clearance_0 * (2.0f * _S72 + 1.0f) + _S67 * _S72) * _S73 * _S73;
    var _S75 : f32 = (clearance_1 * (2.0f * _S73 + 1.0f) - _S68 * _S73) * _S72 * _S72;
    if(_S72 > 0.01999999955296516f)
    {
        _S69 = _S73 > 0.01999999955296516f;
    }
    else
    {
        _S69 = false;
    }
    if(_S69)
    {
        _S69 = (_S74 + _S75) < 0.0f;
    }
    else
    {
        _S69 = false;
    }
    var _S76 : f32;
    if(_S69)
    {
        _S76 = _S73 * step_4;
    }
    else
    {
        _S76 = -1.0f;
    }
    return _S76;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S77 : f32;
    if(here_1.hole_4)
    {
        _S77 = 1.0e+09f;
    }
    else
    {
        _S77 = clearance_2;
    }
    previous_2.clearance_0 = _S77;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S78 : bool;
    if(!here_1.hole_4)
    {
        _S78 = !is_cell_exit_0;
    }
    else
    {
        _S78 = false;
    }
    previous_2.known_0 = _S78;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S79 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S80 : bool;
    if(!here_2.hole_4)
    {
        _S80 = (rate_3 * _S79 + clearance_3) < 0.0f;
    }
    else
    {
        _S80 = false;
    }
    if(_S80)
    {
        _S80 = _S79 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S80 = false;
    }
    var _S81 : f32;
    if(_S80)
    {
        _S81 = _S79 - this_2.epsilon_0;
    }
    else
    {
        _S81 = max(_S79, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S81);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_3 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_3);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S82 : f32 = end_0 - start_1;
    var _S83 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S82;
    var _S84 : f32 = 3.0f * _S82 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S82, 9.99999968265522539e-21f);
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
        var _S85 : f32 = clamp(share_0 - (((_S83 * share_0 + _S84) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S83 * share_0 + 2.0f * _S84) * share_0 + start_rate_0, 0.10000000149011612f * _S82 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S86 : i32 = i_0 + i32(1);
        share_0 = _S85;
        i_0 = _S86;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S87 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S88 : f32 = rsqrt_0(_S87);
    var _S89 : f32 = sine_1 * _S88 * rsqrt_0(_S87 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S89 * _S87, _S89 * across_slope_0 * along_slope_0 + cosine_0 * _S88);
}

fn arc_sine_0( x_4 : f32) -> f32
{
    var _S90 : f32 = abs(x_4);
    var _S91 : bool = _S90 > 0.5f;
    var _S92 : f32;
    if(_S91)
    {
        _S92 = 0.5f * (1.0f - _S90);
    }
    else
    {
        _S92 = _S90 * _S90;
    }
    var _S93 : f32;
    if(_S91)
    {
        _S93 = sqrt(max(_S92, 0.0f));
    }
    else
    {
        _S93 = _S90;
    }
    var _S94 : f32 = ((((0.04216320067644119f * _S92 + 0.02418131195008755f) * _S92 + 0.04547002539038658f) * _S92 + 0.07495300471782684f) * _S92 + 0.16666752099990845f) * _S92 * _S93 + _S93;
    if(_S91)
    {
        _S92 = 1.57079637050628662f - 2.0f * _S94;
    }
    else
    {
        _S92 = _S94;
    }
    if(x_4 < 0.0f)
    {
        _S92 = - _S92;
    }
    return _S92;
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
    var _S95 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S96 : u32 = ((((_S95 >> ((((_S95 >> (u32(28)))) + u32(4))))) ^ (_S95))) * u32(277803737);
    return (((_S96 >> (u32(22)))) ^ (_S96));
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
    var _S97 : vec3<f32> = room_0 / max(albedo_0, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_0, max(min(min(_S97.x, _S97.y), _S97.z), 0.0f));
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn diffuse_reflection_0( light_0 : vec3<f32>,  normal_2 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S98 : f32 = light_0.z;
    if(_S98 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S98, 0.0f), max(dot(light_0, normal_2), 0.0f), blend_0);
}

fn projected_area_1( direction_2 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S99 : f32 = dot(direction_2, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S99 * _S99 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S100 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S101 : f32 = floor(_S100 * 1.4426950216293335f + 0.5f);
    var _S102 : f32 = _S100 - _S101 * 0.693359375f + _S101 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S102 + 0.00139819993637502f) * _S102 + 0.00833345204591751f) * _S102 + 0.04166579619050026f) * _S102 + 0.1666666567325592f) * _S102 + 0.5f;
    var _S103 : f32 = (bitcast<f32>(((u32(i32(_S101) + i32(127)) << (u32(23))))));
    var _S104 : f32;
    if(x_5 < -87.0f)
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

fn density_between_0( light_1 : vec3<f32>,  view_0 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S107 : vec3<f32> = light_1 + view_0;
    var _S108 : f32 = dot(_S107, tangent_3);
    return flake_density_0(min(_S108 * _S108 / max(square_1(_S107), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S109 : f32 = - dot(light_2, normal_3);
    var _S110 : f32 = dot(view_1, normal_3);
    var _S111 : bool;
    if(_S109 <= 0.0f)
    {
        _S111 = true;
    }
    else
    {
        _S111 = _S110 <= 0.0f;
    }
    if(_S111)
    {
        return 0.0f;
    }
    var _S112 : f32 = 1.0f / max(_S110, 9.99999997475242708e-07f);
    var _S113 : f32 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S109, 9.99999997475242708e-07f);
    var _S114 : f32 = projected_area_1(view_1, tangent_4, roughness_4) * _S112;
    return density_between_0(light_2, view_1, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S113, _S114)) * mean_attenuation_0(optical_depth_1 * abs(_S113 - _S114)) * _S112;
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_4 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S115 : f32 = dot(light_3, normal_4);
    var _S116 : bool;
    if(_S115 <= 0.0f)
    {
        _S116 = true;
    }
    else
    {
        _S116 = (dot(view_2, normal_4)) <= 0.0f;
    }
    if(_S116)
    {
        return 0.0f;
    }
    var _S117 : f32 = max(_S115, 9.99999997475242708e-07f);
    var _S118 : f32 = max(dot(view_2, normal_4), 9.99999997475242708e-07f);
    var _S119 : f32 = projected_area_1(light_3, tangent_5, roughness_5) * _S118 + projected_area_1(view_2, tangent_5, roughness_5) * _S117;
    var _S120 : f32 = optical_depth_2 * _S119 / (_S117 * _S118);
    return 0.25f * density_between_0(light_3, view_2, tangent_5, roughness_5) * (_S120 * mean_attenuation_0(_S120)) * _S117 / _S119;
}

fn with_added_0( sums_0 : Components_0,  more_0 : Components_0,  weight_0 : f32) -> Components_0
{
    var result_0 : Components_0;
    result_0.diffuse_warp_0 = sums_0.diffuse_warp_0 + weight_0 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_0.diffuse_weft_0 + weight_0 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_0.specular_warp_0 + weight_0 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_0.specular_weft_0 + weight_0 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_0.light_visibility_1 + weight_0 * more_0.light_visibility_1;
    result_0.hole_2 = sums_0.hole_2 + weight_0 * more_0.hole_2;
    return result_0;
}

fn wrapped_cell_0( position_3 : f32,  count_1 : f32) -> f32
{
    return min(floor((position_3 - floor(position_3)) * count_1), count_1 - 1.0f);
}

fn arc_tangent_quotient_0( x_6 : f32,  y_0 : f32) -> f32
{
    return ((((((0.0f * x_6 + 0.00809729471802711f) * x_6 + -0.0377517081797123f) * x_6 + 0.08475969731807709f) * x_6 + -0.13537675142288208f) * x_6 + 0.19895026087760925f) * x_6 + -0.33327975869178772f) * x_6 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_1 : f32,  x_7 : f32) -> f32
{
    var _S121 : f32 = abs(x_7);
    var _S122 : f32 = abs(y_1);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S121, _S122) / max(max(_S121, _S122), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S122 > _S121)
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
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_0( direction_3 : vec3<f32>) -> NodeTaps_0
{
    var _S123 : f32 = arc_tangent_0(direction_3.y, direction_3.x) * 5.09295797348022461f;
    var _S124 : f32 = floor(_S123);
    var _S125 : f32 = _S123 - _S124;
    var _S126 : f32 = sqrt(clamp((1.0f - abs(direction_3.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S127 : f32 = 7.0f * _S126 * sqrt(_S126);
    var _S128 : f32 = min(floor(_S127), 6.0f);
    var _S129 : f32 = _S127 - _S128;
    var _S130 : u32 = u32(i32(_S124) + i32(32)) % u32(32);
    var _S131 : u32 = u32(_S128);
    var _S132 : u32 = _S130 * u32(8) + _S131;
    var _S133 : u32 = (_S130 + u32(1)) % u32(32) * u32(8) + _S131;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S132, _S132 + u32(1), _S133, _S133 + u32(1));
    var _S134 : f32 = 1.0f - _S125;
    var _S135 : f32 = 1.0f - _S129;
    var _S136 : vec4<u32> = vec4<u32>(vec4<f32>(_S134 * _S135, _S134 * _S129, _S125 * _S135, _S125 * _S129) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S136;
    taps_0.inverse_sum_0 = 1.0f / f32(_S136.x + _S136.y + _S136.z + _S136.w);
    return taps_0;
}

fn half_vector_0( light_4 : vec3<f32>,  view_3 : vec3<f32>) -> vec3<f32>
{
    var _S137 : vec3<f32> = light_4 + view_3;
    return _S137 * vec3<f32>(rsqrt_0(max(square_1(_S137), 9.999999960041972e-13f)));
}

fn shadow_correlation_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S138 : vec2<f32> = light_5.xy;
    var _S139 : vec2<f32> = view_4.xy;
    var _S140 : f32 = dot(_S138, _S139) / max(sqrt(dot(_S138, _S138) * dot(_S139, _S139)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return vec3<f32>(vec2<f32>((-0.09000000357627869f + -0.07999999821186066f * _S140)), 0.0f);
    }
    return vec3<f32>(min(0.62000000476837158f + 0.62999999523162842f * _S140, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S141 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S142 : vec4<u32> = ((packs_1 & (_S141))) * taps_1.weights_0;
    var _S143 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S141))) * taps_1.weights_0;
    return bytes_of_sums_0(_S142.x + _S142.y + _S142.z + _S142.w, _S143.x + _S143.y + _S143.z + _S143.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_0 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S144 : vec4<u32> = vec4<u32>(table_0) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S144.x], words_0[_S144.y], words_0[_S144.z], words_0[_S144.w]));
}

struct Group_0
{
     normal_5 : vec3<f32>,
     weight_1 : f32,
     tangent_6 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_6 : f32,
};

fn group_at_0( row_1 : u32,  roughness_7 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_5 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_1 = table_number_0(row_1 + u32(3));
    var _S145 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_6 = _S145;
    var _S146 : f32 = table_number_0(row_1 + u32(7));
    var _S147 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S146, _S147, 1.0f - square_1(_S145) - _S146 - _S147);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn visibility_gain_0( correlations_0 : vec3<f32>,  from_light_0 : f32,  from_view_0 : f32) -> vec2<f32>
{
    return max(correlations_0.xy * vec2<f32>((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f)) + vec2<f32>(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), vec2<f32>(0.0f));
}

fn Group_variance_along_0( this_5 : Group_0,  direction_4 : vec3<f32>) -> f32
{
    var _S148 : f32 = direction_4.x;
    var _S149 : f32 = direction_4.y;
    var _S150 : f32 = direction_4.z;
    return max(dot(this_5.variance_0, direction_4 * direction_4) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S148 * _S149, _S148 * _S150, _S149 * _S150)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_5 : vec3<f32>) -> f32
{
    var _S151 : f32 = dot(direction_5, group_1.tangent_6);
    var _S152 : f32 = group_1.roughness_6;
    var _S153 : f32 = _S152 * _S152;
    return sqrt(max((_S153 - 1.0f) * (_S151 * _S151 + Group_variance_along_0(group_1, direction_5)) + 1.0f, _S153));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S154 : f32 = group_2.roughness_6;
    var _S155 : f32 = max(sqrt(max(1.0f - _S154 * _S154, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S156 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S157 : f32 = dot(half_0, group_2.tangent_6);
    var _S158 : f32 = _S155 * (_S157 - _S156);
    var _S159 : f32 = _S155 * (_S157 + _S156);
    var _S160 : f32 = _S158 * _S159;
    var _S161 : f32 = 2.0f * _S156 * _S155;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S160) / ((_S158 * _S158 + 1.0f) * (_S159 * _S159 + 1.0f)) + arc_tangent_0(_S161, 1.0f + _S160) / _S161);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S162 : bool = (light_6.z) < 0.0f;
    var _S163 : f32 = dot(light_6, group_3.normal_5);
    var _S164 : f32;
    if(_S162)
    {
        _S164 = - _S163;
    }
    else
    {
        _S164 = _S163;
    }
    var _S165 : f32 = max(dot(view_5, group_3.normal_5), 0.01999999955296516f);
    var _S166 : f32 = mean_area_0(group_3, light_6) / max(_S164, 0.01999999955296516f);
    var _S167 : f32 = mean_area_0(group_3, view_5) / _S165;
    if(_S162)
    {
        _S164 = abs(_S166 - _S167);
    }
    else
    {
        _S164 = _S166 + _S167;
    }
    var _S168 : f32 = optical_depth_3 * max(_S164, 0.00100000004749745f);
    if(_S162)
    {
        _S164 = exponential_0(- optical_depth_3 * min(_S166, _S167));
    }
    else
    {
        _S164 = 1.0f;
    }
    var _S169 : f32 = optical_depth_3 * _S164 * (1.0f - exponential_0(- _S168)) / _S168 / _S165;
    if(_S162)
    {
        _S164 = 1.0f;
    }
    else
    {
        _S164 = 1.0f - 0.34999999403953552f * (1.0f - square_1(group_3.normal_5));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S164 * _S169;
}

struct Bound_0
{
     thread_11 : u32,
     turns_2 : f32,
     cell_7 : f32,
     visible_0 : f32,
     width_0 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_9 : u32,  position_4 : f32) -> Bound_0
{
    var _S170 : Cell_0 = locate_0(family_9, position_4);
    var _S171 : f32 = table_number_0(families_0[family_9].before_0 + u32(2) * _S170.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_11 = _S170.thread_0;
    bound_0.turns_2 = round((position_4 - families_0[family_9].start_0 - _S171 - _S170.below_0) * families_0[family_9].inverse_period_0);
    bound_0.cell_7 = _S170.below_0;
    var _S172 : f32 = 2.0f * _S170.half_width_1;
    bound_0.width_0 = _S172;
    bound_0.visible_0 = clamp((_S170.across_2 + _S170.half_width_1) / _S172, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S170.below_0, _S170.below_0 - _S170.across_2 - _S170.half_width_1) + max(_S170.across_2 - _S170.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_10 : u32,  centre_1 : f32,  size_1 : f32) -> Stretch_0
{
    var _S173 : f32 = centre_1 - floor((centre_1 - families_0[family_10].start_0) * families_0[family_10].inverse_period_0) * families_0[family_10].period_0;
    var _S174 : f32 = 0.5f * max(size_1, families_0[family_10].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_10, _S173 - _S174);
    stretch_0.high_0 = bound_at_0(family_10, _S173 + _S174);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

fn lengths_0( family_11 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S175 : f32 = Stretch_turns_0(stretch_1);
    var _S176 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.low_0.thread_11;
    var _S177 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.high_0.thread_11;
    var _S178 : f32 = table_number_0(_S177) - table_number_0(_S176);
    var _S179 : f32 = table_number_0(_S177 + u32(1)) - table_number_0(_S176 + u32(1));
    return vec3<f32>(_S178 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_0 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_0 + _S175 * families_0[family_11].visible_total_0, _S179 - _S178 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S175 * (families_0[family_11].period_0 - families_0[family_11].visible_total_0), _S179 + stretch_1.high_0.cell_7 - stretch_1.low_0.cell_7 + _S175 * families_0[family_11].period_0);
}

fn integrals_along_0( family_12 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S180 : Family_std430_0 = families_0[family_12];
    var _S181 : u32 = u32(3) * _S180.quantities_0;
    var _S182 : u32 = families_0[family_12].colour_threads_0 + _S181 * stretch_2.low_0.thread_11 + quantity_0;
    var _S183 : u32 = families_0[family_12].colour_threads_0 + _S181 * stretch_2.high_0.thread_11 + quantity_0;
    var _S184 : u32 = families_0[family_12].colour_threads_0 + _S181 * u32(families_0[family_12].count_0) + quantity_0;
    var _S185 : f32 = table_number_0(_S182);
    var _S186 : f32 = table_number_0(_S183);
    var _S187 : f32 = Stretch_turns_0(stretch_2);
    var _S188 : u32 = u32(2) * _S180.quantities_0;
    return vec2<f32>(table_number_0(_S183 + _S180.quantities_0) - table_number_0(_S182 + _S180.quantities_0) + _S186 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_0 - _S185 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_0 + _S187 * table_number_0(_S184 + _S180.quantities_0), table_number_0(_S183 + _S188) - table_number_0(_S182 + _S188) + _S186 * stretch_2.high_0.cell_7 - _S185 * stretch_2.low_0.cell_7 + _S187 * table_number_0(_S184 + _S188));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_0.thread_11) < (this_7.low_0.thread_11);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S189 : u32 = entries_0.z;
    var _S190 : u32 = entries_0.x;
    var _S191 : u32 = _S189 - _S190;
    var _S192 : u32;
    if(Stretch_wraps_0(this_8))
    {
        _S192 = whole_0;
    }
    else
    {
        _S192 = u32(0);
    }
    return vec4<u32>(_S191 + _S192, entries_0.w - _S189, entries_0.y - _S190, whole_0);
}

fn row_differences_0( across_4 : Stretch_0,  row_2 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S193 : u32 = row_2 + across_4.low_0.thread_11 * quantities_1;
    var _S194 : u32 = row_2 + across_4.high_0.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, vec4<u32>(words_0[_S193], words_0[_S193 + quantities_1], words_0[_S194], words_0[_S194 + quantities_1]), words_0[row_2 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    var _S195 : f32 = - this_9.low_0.visible_0;
    var _S196 : f32 = Stretch_turns_0(this_9);
    var _S197 : f32;
    if(Stretch_wraps_0(this_9))
    {
        _S197 = 1.0f;
    }
    else
    {
        _S197 = 0.0f;
    }
    return vec4<f32>(1.0f, this_9.high_0.visible_0, _S195, _S196 - _S197);
}

fn integral_on_top_0( family_13 : u32,  across_5 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S198 : u32 = u32(families_0[family_13].count_0);
    var _S199 : u32 = (_S198 + u32(1)) * families_0[family_13].quantities_0;
    var _S200 : u32 = families_0[family_13].colour_areas_0 + quantity_1;
    var _S201 : vec4<u32> = row_differences_0(across_5, _S200 + along_0.low_0.thread_11 * _S199, _S198, families_0[family_13].quantities_0);
    var _S202 : vec4<u32> = row_differences_0(across_5, _S200 + (along_0.low_0.thread_11 + u32(1)) * _S199, _S198, families_0[family_13].quantities_0);
    var _S203 : vec4<u32> = row_differences_0(across_5, _S200 + along_0.high_0.thread_11 * _S199, _S198, families_0[family_13].quantities_0);
    var _S204 : vec4<u32> = row_differences_0(across_5, _S200 + (along_0.high_0.thread_11 + u32(1)) * _S199, _S198, families_0[family_13].quantities_0);
    var _S205 : vec4<u32> = row_differences_0(across_5, _S200 + crossing_count_0 * _S199, _S198, families_0[family_13].quantities_0);
    var _S206 : vec4<u32> = _S203 - _S201;
    var _S207 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S207 = _S205;
    }
    else
    {
        _S207 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S208 : vec4<f32> = Stretch_weights_0(across_5);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S206 + _S207)), _S208), dot(vec4<f32>(vec4<i32>(_S204 - _S203)), _S208), dot(vec4<f32>(vec4<i32>(_S202 - _S201)), _S208), dot(vec4<f32>(vec4<i32>(_S205)), _S208)), Stretch_weights_0(along_0)) * families_0[family_13].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_2 : f32,  row_3 : u32) -> Albedos_0
{
    var _S209 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S210 : vec3<f32> = vec3<f32>(weight_2);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S210 * _S209.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S210 * _S209.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S210 * _S209.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S210 * _S209.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_14 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_14].colour_mean_0);
    if((families_0[family_14].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S211 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_3 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_14].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S212 : vec2<f32> = integrals_along_0(family_14, own_1, quantity_2);
        var _S213 : f32 = integral_on_top_0(family_14, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S214 : f32 = _S212.x;
        var _S215 : f32 = _S214 * _S211.x;
        var _S216 : f32;
        if(back_3)
        {
            _S216 = _S215 - _S213;
        }
        else
        {
            _S216 = _S213;
        }
        var _S217 : bool = quantity_2 == u32(0);
        if(_S217)
        {
            is_exposed_0 = _S216 > (16.0f * families_0[family_14].area_unit_0 * min(_S215 / families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S215);
        }
        var _S218 : f32 = _S214 * _S211.y;
        var _S219 : f32;
        if(is_exposed_0)
        {
            _S219 = _S216;
        }
        else
        {
            _S219 = 0.0f;
        }
        var _S220 : f32 = _S218 + _S219 + 0.000244140625f * _S211.z * _S212.y;
        if(_S217)
        {
            weight_3 = 1.0f / max(_S220, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S220 * weight_3, families_0[family_14].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn lerp_albedos_0( first_2 : Albedos_0,  second_1 : Albedos_0,  weight_4 : f32) -> Albedos_0
{
    var albedos_3 : Albedos_0;
    var _S221 : vec3<f32> = vec3<f32>(weight_4);
    albedos_3.diffuse_reflect_0 = mix(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S221);
    albedos_3.diffuse_transmit_0 = mix(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S221);
    albedos_3.specular_reflect_0 = mix(first_2.specular_reflect_0, second_1.specular_reflect_0, _S221);
    albedos_3.specular_transmit_0 = mix(first_2.specular_transmit_0, second_1.specular_transmit_0, _S221);
    return albedos_3;
}

fn sheen_scale_0( x_8 : f32,  y_2 : f32) -> f32
{
    return (((((0.0f * x_8 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_8 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_8 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_8 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_8 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_8 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

fn sheen_shear_0( x_9 : f32,  y_3 : f32) -> f32
{
    return ((((0.0f * x_9 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_9 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_9 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_9 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_9 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_10 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_10 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_10 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_10 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_10 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_10 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S222 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S223 : f32 = 2.0f * sqrt(_S222) - 1.0f;
    var _S224 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S223, _S224), 0.00999999977648258f, 1.0f), clamp((1.0f - _S222) * sheen_shear_0(_S223, _S224), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S223, _S224), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_7 : vec3<f32>,  view_6 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S225 : f32 = light_7.z;
    var _S226 : bool;
    if(_S225 <= 0.0f)
    {
        _S226 = true;
    }
    else
    {
        _S226 = (view_6.z) <= 0.0f;
    }
    if(_S226)
    {
        return 0.0f;
    }
    var _S227 : vec2<f32> = view_6.xy;
    var _S228 : f32 = dot(_S227, _S227);
    var _S229 : vec2<f32>;
    if(_S228 > 9.99999968265522539e-21f)
    {
        _S229 = _S227 * vec2<f32>(rsqrt_0(_S228));
    }
    else
    {
        _S229 = vec2<f32>(1.0f, 0.0f);
    }
    var _S230 : f32 = scale_0 * dot(light_7.xy, _S229) + shear_0 * _S225;
    var _S231 : f32 = scale_0 * (light_7.y * _S229.x - light_7.x * _S229.y);
    var _S232 : f32 = _S230 * _S230 + _S231 * _S231 + _S225 * _S225;
    return 0.31830987334251404f * scale_0 * scale_0 * _S225 / max(_S232 * _S232, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_8 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S233 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_9);
    var _S234 : f32 = strength_0 * _S233.z;
    return vec2<f32>(_S234 * transformed_cosine_0(light_8, view_7, _S233.x, _S233.y), 1.0f - _S234);
}

struct FamilyAlbedos_0
{
     warp_2 : Albedos_0,
     weft_2 : Albedos_0,
};

struct Estimate_0
{
     components_0 : Components_0,
     albedos_4 : FamilyAlbedos_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_1 : f32,
     points_0 : f32,
};

fn regime_of_0( _S235 : u32,  _S236 : Footprint_0,  _S237 : f32) -> Regime_0
{
    var _S238 : f32 = Footprint_spread_side_0(_S236);
    var _S239 : f32 = clamp((binary_logarithm_0(max(_S238, 9.99999971718068537e-10f)) - fabrics_0[_S235].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S240 : f32 = _S239 * _S239 * (3.0f - 2.0f * _S239);
    regime_0.prefiltered_0 = _S240;
    regime_0.threads_1 = _S238 * fabrics_0[_S235].lobes_0.threads_per_mm_0;
    var _S241 : f32 = mix(max(8.0f / _S237, 1.0f), 1.0f, _S240);
    var _S242 : f32;
    if(_S240 < 1.0f)
    {
        _S242 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S241);
    }
    else
    {
        _S242 = 0.0f;
    }
    regime_0.points_0 = _S242;
    return regime_0;
}

struct Hit_0
{
     x_11 : f32,
     y_5 : f32,
     hole_5 : bool,
     height_4 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_5 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S243 : u32,  _S244 : f32,  _S245 : f32,  _S246 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_1 = locate_0(fabrics_0[_S243].warp_0, _S244);
    crossing_3.weft_1 = locate_0(fabrics_0[_S243].weft_0, _S245);
    var _S247 : u32 = fabrics_0[_S243].run_words_0 + u32(2) * (crossing_3.weft_1.thread_0 * fabrics_0[_S243].ends_1 + crossing_3.warp_1.thread_0);
    var _S248 : u32 = words_0[_S247];
    crossing_3.warp_word_0 = _S248;
    crossing_3.weft_word_0 = words_0[_S247 + u32(1)];
    crossing_3.warp_above_0 = (((_S248 & (u32(1)))) == u32(1)) != _S246;
    return crossing_3;
}

fn sample_at_0( _S249 : u32,  _S250 : f32,  _S251 : f32,  _S252 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S253 : Crossing_0 = crossing_at_0(_S249, _S250, _S251, _S252);
    sample_0.crossing_2 = _S253;
    var _S254 : Shown_0 = shown_at_0(_S253, _S252);
    sample_0.shown_3 = _S254;
    var _S255 : u32;
    if(_S254.is_warp_2)
    {
        _S255 = fabrics_0[_S249].warp_0;
    }
    else
    {
        _S255 = fabrics_0[_S249].weft_0;
    }
    var _S256 : u32;
    if(_S254.is_warp_2)
    {
        _S256 = fabrics_0[_S249].weft_0;
    }
    else
    {
        _S256 = fabrics_0[_S249].warp_0;
    }
    var _S257 : Cell_0 = select_cell_0(_S254.is_warp_2, sample_0.crossing_2.warp_1, sample_0.crossing_2.weft_1);
    var _S258 : Cell_0 = select_cell_0(_S254.is_warp_2, sample_0.crossing_2.weft_1, sample_0.crossing_2.warp_1);
    var _S259 : Run_0 = unpack_0(_S255, _S256, _S257.thread_0, _S258, _S254.word_0);
    var _S260 : Section_0 = section_at_0(_S257);
    var _S261 : bool;
    if(_S254.on_top_0)
    {
        _S261 = (_S259.distance_0) < (_S260.drop_0 * _S259.bend_1.sine_0);
    }
    else
    {
        _S261 = false;
    }
    var _S262 : bool;
    if(_S254.on_top_0)
    {
        _S262 = !_S261;
    }
    else
    {
        _S262 = false;
    }
    var _S263 : f32;
    if(_S262)
    {
        _S263 = 1.0f;
    }
    else
    {
        _S263 = -1.0f;
    }
    var _S264 : f32;
    if(_S261)
    {
        _S264 = _S259.other_reach_0;
    }
    else
    {
        _S264 = _S259.reach_0;
    }
    var _S265 : f32;
    if(_S261)
    {
        _S265 = _S264 + _S259.distance_0;
    }
    else
    {
        _S265 = max(_S264 - _S259.distance_0, 0.0f);
    }
    var _S266 : f32 = _S264 / _S259.bend_1.sine_0 - _S263 * _S260.drop_0;
    var _S267 : f32 = _S265 * _S265;
    var _S268 : f32 = max(_S266 * _S266 - _S267, 9.99999968265522539e-21f);
    var _S269 : f32 = rsqrt_0(_S268);
    var _S270 : f32 = _S267 / (_S268 * _S269 + _S266);
    var _S271 : bool = _S265 > 0.0f;
    var _S272 : f32;
    if(_S254.on_top_0)
    {
        _S272 = 1.0f;
    }
    else
    {
        _S272 = -1.0f;
    }
    var _S273 : f32;
    if(_S259.near_start_0)
    {
        _S273 = 1.0f;
    }
    else
    {
        _S273 = -1.0f;
    }
    var _S274 : f32 = _S272 * _S273;
    if(_S271)
    {
        _S272 = _S266 * _S269;
    }
    else
    {
        _S272 = 1.0f;
    }
    sample_0.slope_across_0 = _S260.slope_0 * _S272;
    if(_S271)
    {
        _S265 = _S274 * _S265 * _S269;
    }
    else
    {
        _S265 = 0.0f;
    }
    sample_0.slope_along_0 = _S265;
    var _S275 : Family_std430_0 = families_0[_S255];
    var _S276 : vec2<f32> = dive_0(_S256, _S254, _S259, _S258);
    if(_S259.straight_0)
    {
        _S263 = 0.0f;
    }
    else
    {
        _S263 = _S275.height_scale_0 * _S263;
    }
    sample_0.height_5 = _S263 * (_S264 * _S259.bend_1.half_tangent_0 - _S270) - _S275.height_scale_0 * _S260.drop_0 - _S276.x;
    var _S277 : f32 = _S275.height_scale_0 * sample_0.slope_across_0;
    var _S278 : f32 = _S275.height_scale_0 * sample_0.slope_along_0 - _S276.y;
    if(_S254.is_warp_2)
    {
        _S263 = _S277;
    }
    else
    {
        _S263 = _S278;
    }
    sample_0.slope_x_1 = _S263;
    if(_S254.is_warp_2)
    {
        _S263 = _S278;
    }
    else
    {
        _S263 = _S277;
    }
    sample_0.slope_y_1 = _S263;
    sample_0.run_3 = _S259;
    sample_0.section_1 = _S260;
    return sample_0;
}

fn steps_per_length_0( _S279 : u32,  _S280 : SearchQuality_0,  _S281 : vec3<f32>) -> f32
{
    return max(max(abs(_S281.x) * fabrics_0[_S279].threads_per_x_0, abs(_S281.y) * fabrics_0[_S279].threads_per_y_0) * _S280.steps_per_thread_0, abs(_S281.z) * fabrics_0[_S279].per_relief_0 * _S280.steps_per_relief_0);
}

fn cell_maximum_0( _S282 : u32,  _S283 : Crossing_0) -> f32
{
    var _S284 : u32;
    if(_S283.warp_above_0)
    {
        _S284 = fabrics_0[_S282].warp_0;
    }
    else
    {
        _S284 = fabrics_0[_S282].weft_0;
    }
    var _S285 : u32;
    if(_S283.warp_above_0)
    {
        _S285 = _S283.warp_word_0;
    }
    else
    {
        _S285 = _S283.weft_word_0;
    }
    return f32((_S285 >> (u32(28)))) * families_0[_S284].height_scale_0 * families_0[_S284].level_0;
}

fn probe_0( _S286 : u32,  _S287 : f32,  _S288 : f32,  _S289 : bool,  _S290 : bool,  _S291 : bool) -> Probe_0
{
    var _S292 : Sample_0 = sample_at_0(_S286, _S287, _S288, _S289);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S292.height_5;
    probe_1.hole_4 = _S292.shown_3.hole_3;
    probe_1.slope_x_0 = _S292.slope_x_1;
    probe_1.slope_y_0 = _S292.slope_y_1;
    var _S293 : u32;
    if(_S292.shown_3.is_warp_2)
    {
        _S293 = _S292.crossing_2.warp_1.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S293 = _S292.crossing_2.weft_1.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S293;
    probe_1.cell_max_0 = cell_maximum_0(_S286, _S292.crossing_2);
    var _S294 : f32;
    if(_S290)
    {
        _S294 = _S292.crossing_2.warp_1.above_0;
    }
    else
    {
        _S294 = _S292.crossing_2.warp_1.below_0;
    }
    probe_1.side_x_0 = _S294;
    if(_S291)
    {
        _S294 = _S292.crossing_2.weft_1.above_0;
    }
    else
    {
        _S294 = _S292.crossing_2.weft_1.below_0;
    }
    probe_1.side_y_0 = _S294;
    probe_1.edge_x_0 = outline_distance_0(_S292.crossing_2.warp_1, _S292.shown_3, _S292.run_3, !_S292.shown_3.is_warp_2, _S290);
    probe_1.edge_y_0 = outline_distance_0(_S292.crossing_2.weft_1, _S292.shown_3, _S292.run_3, _S292.shown_3.is_warp_2, _S291);
    return probe_1;
}

fn is_free_0( _S295 : u32,  _S296 : SearchQuality_0,  _S297 : vec3<f32>,  _S298 : vec3<f32>,  _S299 : bool,  _S300 : f32) -> bool
{
    var _S301 : f32 = _S298.z;
    if(_S301 <= 0.0f)
    {
        return false;
    }
    var _S302 : f32 = 1.0f / max(_S296.shadow_share_0 * steps_per_length_0(_S295, _S296, _S298), 9.99999971718068537e-10f);
    var _S303 : StepControl_0 = step_control_0(_S298.xy, _S302);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S304 : bool;
        if(count_3 < u32(1024))
        {
            _S304 = (_S297.z + _S301 * distance_1) < _S300;
        }
        else
        {
            _S304 = false;
        }
        if(_S304)
        {
        }
        else
        {
            break;
        }
        var _S305 : vec3<f32> = _S297 + _S298 * vec3<f32>(distance_1);
        var _S306 : Probe_0 = probe_0(_S295, _S305.x, _S305.y, _S299, _S303.right_0, _S303.up_0);
        var _S307 : f32 = _S305.z;
        var _S308 : f32 = _S307 - _S306.height_2;
        var _S309 : f32 = _S301 - _S306.slope_x_0 * _S298.x - _S306.slope_y_0 * _S298.y;
        var _S310 : bool;
        if(!_S306.hole_4)
        {
            _S310 = _S308 < 0.0f;
        }
        else
        {
            _S310 = false;
        }
        if(_S310)
        {
            return false;
        }
        var _S311 : f32 = way_back_to_dip_0(previous_3, _S308, _S309, last_step_0, _S306);
        if(_S311 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S311;
            distance_1 = distance_1 - _S311;
            last_step_0 = last_step_1;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S312 : bool = _S307 > (_S306.cell_max_0);
        var _S313 : PreviousSample_0 = after_sample_0(_S308, _S309, _S306, _S312);
        var last_step_2 : f32;
        if(_S312)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S303, _S306.side_x_0, _S306.side_y_0), _S302);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S303, _S306, _S308, _S309);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S313;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S314 : u32,  _S315 : SearchQuality_0,  _S316 : f32,  _S317 : f32,  _S318 : vec3<f32>,  _S319 : bool) -> bool
{
    if(!sample_at_0(_S314, _S316, _S317, _S319).shown_3.hole_3)
    {
        return false;
    }
    var _S320 : vec3<f32> = vec3<f32>(_S316, _S317, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S321 : bool;
        if(side_0 < u32(2))
        {
            _S321 = passes_0;
        }
        else
        {
            _S321 = false;
        }
        if(_S321)
        {
        }
        else
        {
            break;
        }
        var _S322 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S322 = _S318;
        }
        else
        {
            _S322 = vec3<f32>(- _S318.x, - _S318.y, _S318.z);
        }
        var _S323 : bool = is_free_0(_S314, _S315, _S320, _S322, _S319 != (side_0 == u32(1)), fabrics_0[_S314].height_high_0);
        var _S324 : u32 = side_0 + u32(1);
        passes_0 = _S323;
        side_0 = _S324;
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

fn max_height_along_0( _S325 : u32,  _S326 : f32,  _S327 : f32,  _S328 : f32,  _S329 : vec3<f32>,  _S330 : bool) -> f32
{
    var _S331 : u32 = locate_0(fabrics_0[_S325].warp_0, _S326).thread_0 / u32(2);
    var _S332 : u32 = locate_0(fabrics_0[_S325].weft_0, _S327).thread_0 / u32(2);
    var _S333 : f32 = _S329.x;
    var _S334 : u32;
    if(_S333 > 0.0f)
    {
        _S334 = u32(1);
    }
    else
    {
        _S334 = u32(0);
    }
    var _S335 : f32 = _S329.y;
    var _S336 : u32;
    if(_S335 > 0.0f)
    {
        _S336 = u32(2);
    }
    else
    {
        _S336 = u32(0);
    }
    var _S337 : u32 = words_0[fabrics_0[_S325].max_heights_0 + u32(4) * (_S332 * fabrics_0[_S325].max_height_columns_0 + _S331) + (_S334 + _S336)];
    var number_0 : i32;
    if(_S330)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S338 : u32 = (_S337 >> (u32(number_0)));
    var _S339 : f32 = max(abs(_S333) * fabrics_0[_S325].threads_per_x_0, abs(_S335) * fabrics_0[_S325].threads_per_y_0) / _S329.z;
    var _S340 : f32 = fabrics_0[_S325].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S325].height_high_0;
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
        if(((max_height_0 - _S328) * _S339) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S338 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S340);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S341 : u32,  _S342 : f32,  _S343 : f32,  _S344 : bool,  _S345 : bool,  _S346 : bool) -> vec3<f32>
{
    var _S347 : Crossing_0 = crossing_at_0(_S341, _S342, _S343, _S344);
    var _S348 : f32 = cell_maximum_0(_S341, _S347);
    var _S349 : f32;
    if(_S345)
    {
        _S349 = _S347.warp_1.above_0;
    }
    else
    {
        _S349 = _S347.warp_1.below_0;
    }
    var _S350 : f32;
    if(_S346)
    {
        _S350 = _S347.weft_1.above_0;
    }
    else
    {
        _S350 = _S347.weft_1.below_0;
    }
    return vec3<f32>(_S348, _S349, _S350);
}

fn first_sample_height_0( _S351 : u32,  _S352 : ViewRay_0,  _S353 : StepControl_0,  _S354 : bool) -> f32
{
    var _S355 : f32 = max_height_along_0(_S351, _S352.origin_0.x, _S352.origin_0.y, 0.0f, vec3<f32>(_S352.slope_1, 1.0f), _S354);
    var count_4 : u32 = u32(0);
    var height_7 : f32 = _S355;
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S356 : vec2<f32> = ViewRay_at_0(_S352, height_7);
        var _S357 : vec3<f32> = cell_bounds_0(_S351, _S356.x, _S356.y, _S354, _S353.right_0, _S353.up_0);
        var _S358 : f32 = height_7 - _S357.x;
        var _S359 : f32 = StepControl_to_cell_exit_0(_S353, _S357.y, _S357.z);
        var height_8 : f32 = height_7 - clamp(_S358, 0.0f, _S359);
        if(_S358 <= _S359)
        {
            height_7 = height_8;
            break;
        }
        count_4 = count_4 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S360 : u32,  _S361 : ViewRay_0,  _S362 : StepControl_0,  _S363 : bool) -> ViewRayEnd_0
{
    var _S364 : f32 = fabrics_0[_S360].height_low_0 - (fabrics_0[_S360].height_high_0 - fabrics_0[_S360].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S360, _S361, _S362, _S363);
    end_1.last_step_3 = _S362.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_5 : u32 = u32(0);
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S365 : vec2<f32> = ViewRay_at_0(_S361, end_1.height_6);
        var _S366 : Probe_0 = probe_0(_S360, _S365.x, _S365.y, _S363, _S362.right_0, _S362.up_0);
        var _S367 : f32 = end_1.height_6 - _S366.height_2;
        var _S368 : f32 = ViewRay_rate_0(_S361, _S366);
        end_1.depth_1 = - _S367;
        end_1.rate_4 = _S368;
        var _S369 : bool;
        if(end_1.previous_4.known_0)
        {
            _S369 = !_S366.hole_4;
        }
        else
        {
            _S369 = false;
        }
        var _S370 : bool;
        if(_S369)
        {
            _S370 = (end_1.previous_4.yarn_0) == (_S366.yarn_1);
        }
        else
        {
            _S370 = false;
        }
        end_1.smooth_0 = _S370;
        var _S371 : bool;
        if(!_S366.hole_4)
        {
            _S371 = _S367 <= 0.0f;
        }
        else
        {
            _S371 = false;
        }
        var _S372 : bool;
        if(_S371)
        {
            _S372 = true;
        }
        else
        {
            _S372 = (end_1.height_6) <= _S364;
        }
        if(_S372)
        {
            break;
        }
        var _S373 : f32 = way_back_to_dip_0(end_1.previous_4, _S367, _S368, end_1.last_step_3, _S366);
        if(_S373 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S373;
            end_1.last_step_3 = end_1.last_step_3 - _S373;
            count_5 = count_5 + u32(1);
            continue;
        }
        var _S374 : f32 = min(StepControl_to_cell_exit_0(_S362, _S366.side_x_0, _S366.side_y_0), end_1.height_6 - _S366.cell_max_0);
        var _S375 : f32 = StepControl_to_next_sample_0(_S362, _S366, _S367, _S368);
        end_1.previous_4 = after_sample_0(_S367, _S368, _S366, _S374 > _S375);
        var _S376 : f32 = max(_S374, _S375);
        end_1.last_step_3 = _S376;
        end_1.height_6 = end_1.height_6 - _S376;
        count_5 = count_5 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S377 : u32,  _S378 : ViewRay_0,  _S379 : StepControl_0,  _S380 : bool,  _S381 : ViewRayEnd_0,  _S382 : u32) -> f32
{
    var _S383 : f32 = fabrics_0[_S377].height_high_0 - fabrics_0[_S377].height_low_0;
    var above_2 : f32 = _S381.height_6 + _S381.last_step_3;
    var above_gap_1 : f32 = clamp(_S381.previous_4.clearance_0, 0.0f, _S383);
    var under_gap_1 : f32 = clamp(_S381.depth_1, 0.0f, _S383);
    var _S384 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S381.previous_4.rate_0 * _S381.last_step_3, _S381.rate_4 * _S381.last_step_3);
    var middle_0 : f32;
    if(_S381.smooth_0)
    {
        middle_0 = above_2 - _S384 * _S381.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S381.height_6, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S381.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S382)
        {
        }
        else
        {
            break;
        }
        var _S385 : vec2<f32> = ViewRay_at_0(_S378, middle_0);
        var _S386 : Probe_0 = probe_0(_S377, _S385.x, _S385.y, _S380, _S379.right_0, _S379.up_0);
        var _S387 : f32;
        if(_S386.hole_4)
        {
            _S387 = -1.0e+09f;
        }
        else
        {
            _S387 = _S386.height_2;
        }
        var _S388 : f32 = clamp(middle_0 - _S387, - _S383, _S383);
        var _S389 : f32;
        if(_S388 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S389 = 0.5f * above_gap_2;
            }
            else
            {
                _S389 = above_gap_2;
            }
            var _S390 : f32 = - _S388;
            under_1 = middle_0;
            above_gap_2 = _S389;
            under_gap_2 = _S390;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S389 = 0.5f * under_gap_2;
            }
            else
            {
                _S389 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S388;
            under_gap_2 = _S389;
            side_1 = -1.0f;
        }
        if(_S381.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S388 / min(ViewRay_rate_0(_S378, _S386), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S381.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S391 : u32,  _S392 : SearchQuality_0,  _S393 : f32,  _S394 : f32,  _S395 : vec3<f32>,  _S396 : bool) -> Hit_0
{
    var _S397 : f32 = max(_S395.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S393, _S394);
    var _S398 : vec2<f32> = _S395.xy / vec2<f32>(_S397);
    ray_0.slope_1 = _S398;
    var _S399 : StepControl_0 = step_control_0((vec2<f32>(0) - _S398), 1.0f / max(steps_per_length_0(_S391, _S392, _S395) / _S397, 9.99999971718068537e-10f));
    var _S400 : ViewRayEnd_0 = search_down_0(_S391, ray_0, _S399, _S396);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S401 : f32 = refined_height_0(_S391, ray_0, _S399, _S396, _S400, _S392.refinements_0);
    hit_0.height_4 = _S401;
    var _S402 : vec2<f32> = ViewRay_at_0(ray_0, _S401);
    hit_0.x_11 = _S402.x;
    hit_0.y_5 = _S402.y;
    return hit_0;
}

fn first_hit_0( _S403 : u32,  _S404 : SearchQuality_0,  _S405 : f32,  _S406 : f32,  _S407 : vec3<f32>,  _S408 : bool) -> Hit_0
{
    if(!passes_through_0(_S403, _S404, _S405, _S406, _S407, _S408))
    {
        return first_hit_of_yarn_0(_S403, _S404, _S405, _S406, _S407, _S408);
    }
    var hit_1 : Hit_0;
    hit_1.x_11 = _S405;
    hit_1.y_5 = _S406;
    hit_1.height_4 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S409 : u32,  _S410 : f32,  _S411 : f32,  _S412 : bool) -> SurfacePoint_0
{
    var _S413 : Sample_0 = sample_at_0(_S409, _S410, _S411, _S412);
    var _S414 : f32;
    if(_S413.shown_3.is_warp_2)
    {
        _S414 = _S413.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S414 = _S413.crossing_2.weft_1.half_width_1;
    }
    var _S415 : u32;
    if(_S413.shown_3.is_warp_2)
    {
        _S415 = fabrics_0[_S409].warp_0;
    }
    else
    {
        _S415 = fabrics_0[_S409].weft_0;
    }
    var _S416 : Family_std430_0 = families_0[_S415];
    var _S417 : f32;
    if(_S412)
    {
        _S417 = -1.0f;
    }
    else
    {
        _S417 = 1.0f;
    }
    var _S418 : f32 = _S416.twist_sine_0 * _S417;
    var _S419 : Family_std430_0 = families_0[_S415];
    if(_S413.shown_3.is_warp_2)
    {
        _S417 = 1.0f;
    }
    else
    {
        _S417 = -1.0f;
    }
    var _S420 : vec2<f32> = fibre_direction_0(_S413.slope_across_0, _S417 * _S413.slope_along_0, _S418, _S419.twist_cosine_0);
    var _S421 : f32;
    if(_S413.shown_3.is_warp_2)
    {
        _S421 = _S413.slope_x_1;
    }
    else
    {
        _S421 = _S413.slope_y_1;
    }
    var _S422 : f32;
    if(_S413.shown_3.is_warp_2)
    {
        _S422 = _S413.slope_y_1;
    }
    else
    {
        _S422 = _S413.slope_x_1;
    }
    var _S423 : f32 = _S420.x;
    var _S424 : f32 = _S420.y;
    var _S425 : f32 = _S421 * _S423 + _S417 * _S422 * _S424;
    var _S426 : f32 = _S414 * 1.0154266357421875f;
    var _S427 : f32 = _S426 * arc_sine_0(clamp(_S413.section_1.across_3 / _S426, -1.0f, 1.0f));
    if(_S413.shown_3.is_warp_2)
    {
        _S414 = _S411;
    }
    else
    {
        _S414 = - _S410;
    }
    var point_0 : SurfacePoint_0;
    point_0.hole_0 = _S413.shown_3.hole_3;
    point_0.is_warp_0 = _S413.shown_3.is_warp_2;
    point_0.warp_thread_0 = _S413.crossing_2.warp_1.thread_0;
    point_0.weft_thread_0 = _S413.crossing_2.weft_1.thread_0;
    point_0.height_0 = _S413.height_5;
    point_0.normal_0 = normalize(vec3<f32>(- _S413.slope_x_1, - _S413.slope_y_1, 1.0f));
    var _S428 : vec3<f32>;
    if(_S413.shown_3.is_warp_2)
    {
        _S428 = vec3<f32>(_S423, _S424, _S425);
    }
    else
    {
        _S428 = vec3<f32>(- _S424, _S423, _S425);
    }
    point_0.tangent_0 = normalize(_S428);
    point_0.across_0 = _S413.section_1.across_3;
    point_0.fibre_across_0 = _S427 * _S419.twist_cosine_0 + _S414 * _S418;
    point_0.fibre_along_0 = _S414 * _S419.twist_cosine_0 - _S427 * _S418;
    return point_0;
}

struct YarnPoint_0
{
     back_4 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_12 : f32,
     y_6 : f32,
     height_9 : f32,
     normal_6 : vec3<f32>,
     tangent_7 : vec3<f32>,
     roughness_10 : f32,
     albedos_5 : Albedos_0,
};

fn vary_albedos_0( _S429 : u32,  _S430 : Albedos_0,  _S431 : u32,  _S432 : u32) -> Albedos_0
{
    var _S433 : vec3<f32> = max(_S430.specular_reflect_0, _S430.specular_transmit_0);
    var _S434 : vec3<f32> = _S430.diffuse_reflect_0 + _S430.diffuse_transmit_0;
    var _S435 : vec3<f32> = vec3<f32>(fabrics_0[_S429].layer_bound_0);
    var _S436 : vec3<f32> = vec3<f32>(1.0f);
    var _S437 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S431, fabrics_0[_S429].colour_noise_0, fabrics_0[_S429].seed_0), _S434, _S436 - _S435 * _S433));
    var _S438 : f32 = bounded_gain_0(fibre_gain_0(_S431, _S432, fabrics_0[_S429].fibre_noise_0, fabrics_0[_S429].seed_0), _S433, min((_S436 - _S437 * _S434) / _S435, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S437 * _S430.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S437 * _S430.diffuse_transmit_0;
    var _S439 : vec3<f32> = vec3<f32>(_S438);
    varied_0.specular_reflect_0 = _S439 * _S430.specular_reflect_0;
    varied_0.specular_transmit_0 = _S439 * _S430.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S440 : u32,  _S441 : SurfacePoint_0,  _S442 : Albedos_0,  _S443 : f32,  _S444 : f32) -> Albedos_0
{
    var _S445 : f32;
    if(_S441.is_warp_0)
    {
        _S445 = _S443;
    }
    else
    {
        _S445 = _S444;
    }
    var _S446 : f32 = _S445 - _S441.across_0;
    var _S447 : u32;
    if(_S441.is_warp_0)
    {
        _S447 = fabrics_0[_S440].warp_0;
    }
    else
    {
        _S447 = fabrics_0[_S440].weft_0;
    }
    var _S448 : Family_std430_0 = families_0[_S447];
    var _S449 : i32 = i32(families_0[_S447].count_0);
    if(_S441.is_warp_0)
    {
        _S447 = _S441.warp_thread_0;
    }
    else
    {
        _S447 = _S441.weft_thread_0;
    }
    var _S450 : u32 = u32(i32(floor(_S446 / _S448.period_0)) * _S449 + i32(_S447)) * u32(2);
    if(_S441.is_warp_0)
    {
        _S447 = u32(1);
    }
    else
    {
        _S447 = u32(0);
    }
    var _S451 : f32 = floor(_S441.fibre_across_0 / fabrics_0[_S440].fibre_size_0);
    return vary_albedos_0(_S440, _S442, _S450 + _S447, u32(i32(_S451)) * u32(65536) + u32(i32(floor(_S441.fibre_along_0 / (fabrics_0[_S440].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S451))));
}

fn yarn_point_of_0( _S452 : u32,  _S453 : SurfacePoint_0,  _S454 : f32,  _S455 : f32,  _S456 : bool,  _S457 : bool) -> YarnPoint_0
{
    var _S458 : u32;
    if(_S453.is_warp_0)
    {
        _S458 = fabrics_0[_S452].warp_0;
    }
    else
    {
        _S458 = fabrics_0[_S452].weft_0;
    }
    var _S459 : u32;
    if(_S453.is_warp_0)
    {
        _S459 = _S453.warp_thread_0;
    }
    else
    {
        _S459 = _S453.weft_thread_0;
    }
    var albedos_6 : Albedos_0 = albedos_of_0(_S458, _S459);
    var _S460 : bool;
    if((fabrics_0[_S452].fibre_noise_0) > 0.0f)
    {
        _S460 = true;
    }
    else
    {
        _S460 = (fabrics_0[_S452].colour_noise_0) > 0.0f;
    }
    var albedos_7 : Albedos_0;
    if(_S460)
    {
        albedos_7 = varied_at_0(_S452, _S453, albedos_6, _S454, _S455);
    }
    else
    {
        albedos_7 = albedos_6;
    }
    var point_1 : YarnPoint_0;
    point_1.back_4 = _S456;
    point_1.hole_6 = _S457;
    point_1.is_warp_3 = _S453.is_warp_0;
    point_1.x_12 = _S454;
    point_1.y_6 = _S455;
    point_1.height_9 = _S453.height_0;
    point_1.normal_6 = _S453.normal_0;
    point_1.tangent_7 = _S453.tangent_0;
    point_1.roughness_10 = families_0[_S458].roughness_0;
    point_1.albedos_5 = albedos_7;
    return point_1;
}

fn unoccluded_0( _S461 : u32,  _S462 : SearchQuality_0,  _S463 : f32,  _S464 : f32,  _S465 : f32,  _S466 : vec3<f32>,  _S467 : bool) -> bool
{
    if((_S466.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S461, _S462, vec3<f32>(_S463, _S464, _S465 + fabrics_0[_S461].lift_0), _S466, _S467, max_height_along_0(_S461, _S463, _S464, _S465, _S466, _S467));
}

fn is_lit_0( _S468 : u32,  _S469 : SearchQuality_0,  _S470 : YarnPoint_0,  _S471 : vec3<f32>) -> bool
{
    if(_S470.hole_6)
    {
        return true;
    }
    var _S472 : vec3<f32> = to_face_frame_0(_S471, _S470.back_4);
    var _S473 : f32 = _S472.z;
    var _S474 : bool = _S473 < 0.0f;
    var normal_7 : vec3<f32>;
    var height_10 : f32;
    if(_S474)
    {
        var _S475 : SurfacePoint_0 = surface_at_0(_S468, _S470.x_12, _S470.y_6, !_S470.back_4);
        normal_7 = _S475.normal_0;
        height_10 = _S475.height_0;
    }
    else
    {
        normal_7 = _S470.normal_6;
        height_10 = _S470.height_9;
    }
    var _S476 : vec3<f32> = vec3<f32>(_S472.xy, abs(_S473));
    if((dot(normal_7, _S476)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S468, _S469, _S470.x_12, _S470.y_6, height_10, _S476, (_S470.back_4) != _S474);
}

fn components_of_point_0( _S477 : u32,  _S478 : SearchQuality_0,  _S479 : YarnPoint_0,  _S480 : vec3<f32>,  _S481 : vec3<f32>) -> Components_0
{
    var result_1 : Components_0 = no_components_0();
    var _S482 : f32;
    if(_S479.hole_6)
    {
        _S482 = 1.0f;
    }
    else
    {
        _S482 = 0.0f;
    }
    result_1.hole_2 = _S482;
    var _S483 : bool;
    if(_S479.hole_6)
    {
        _S483 = true;
    }
    else
    {
        _S483 = !is_lit_0(_S477, _S478, _S479, _S480);
    }
    if(_S483)
    {
        return result_1;
    }
    var _S484 : vec3<f32> = to_face_frame_0(_S480, _S479.back_4);
    var _S485 : vec3<f32> = to_face_frame_0(_S481, _S479.back_4);
    var _S486 : bool = (_S484.z) < 0.0f;
    var _S487 : vec3<f32>;
    if(_S486)
    {
        _S487 = (vec3<f32>(0) - _S484);
    }
    else
    {
        _S487 = _S484;
    }
    var _S488 : f32 = diffuse_reflection_0(_S487, _S479.normal_6, fabrics_0[_S477].diffuse_blend_0);
    if(_S486)
    {
        _S482 = transmission_0(_S484, _S485, _S479.normal_6, _S479.tangent_7, _S479.roughness_10, fabrics_0[_S477].optical_depth_0);
    }
    else
    {
        _S482 = reflection_0(_S484, _S485, _S479.normal_6, _S479.tangent_7, _S479.roughness_10, fabrics_0[_S477].optical_depth_0);
    }
    var _S489 : f32;
    if(_S479.is_warp_3)
    {
        _S489 = _S488;
    }
    else
    {
        _S489 = 0.0f;
    }
    result_1.diffuse_warp_0 = _S489;
    if(_S479.is_warp_3)
    {
        _S489 = 0.0f;
    }
    else
    {
        _S489 = _S488;
    }
    result_1.diffuse_weft_0 = _S489;
    if(_S479.is_warp_3)
    {
        _S489 = _S482;
    }
    else
    {
        _S489 = 0.0f;
    }
    result_1.specular_warp_0 = _S489;
    if(_S479.is_warp_3)
    {
        _S482 = 0.0f;
    }
    result_1.specular_weft_0 = _S482;
    result_1.light_visibility_1 = 1.0f;
    return result_1;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S490 : u32,  _S491 : f32) -> vec3<f32>
{
    var _S492 : u32 = fabrics_0[_S490].lobes_0.levels_0 + u32(4) * u32(min(_S491, fabrics_0[_S490].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S492), table_number_0(_S492 + u32(1)), table_number_0(_S492 + u32(2)));
}

fn coverage_taps_0( _S493 : u32,  _S494 : Footprint_0,  _S495 : bool) -> CoverageTaps_0
{
    var _S496 : Lobes_std430_0 = fabrics_0[_S493].lobes_0;
    var _S497 : f32 = Footprint_spread_side_0(_S494) * fabrics_0[_S493].lobes_0.inverse_base_size_0;
    var _S498 : vec3<f32> = pyramid_level_0(_S493, floor(binary_logarithm_0(max(0.68000000715255737f * _S497, 1.0f))));
    var _S499 : f32 = 1.0f / max(_S497, 9.99999997475242708e-07f);
    var _S500 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S493].warp_0].inverse_period_0, families_0[fabrics_0[_S493].weft_0].inverse_period_0);
    var _S501 : vec2<f32> = _S494.centre_0 * _S500;
    var _S502 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S499 * _S499), 0.0f, 1.0f)), 0.3333333432674408f * _S499), 1.0f));
    var _S503 : vec2<f32> = _S494.dx_0 * _S500 * _S502;
    var _S504 : vec2<f32> = _S494.dy_0 * _S500 * _S502;
    var taps_3 : CoverageTaps_0;
    var number_1 : u32 = u32(0);
    for(;;)
    {
        if(number_1 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S505 : vec2<f32> = _S501 + vec2<f32>(TAP_OFFSETS_0[number_1].x) * _S503 + vec2<f32>(TAP_OFFSETS_0[number_1].y) * _S504;
        var _S506 : f32 = _S498.y;
        var _S507 : f32 = wrapped_cell_0(_S505.x, _S506);
        var _S508 : f32 = wrapped_cell_0(_S505.y, _S498.z);
        var _S509 : u32;
        if(_S495)
        {
            _S509 = _S496.face_nodes_0;
        }
        else
        {
            _S509 = u32(0);
        }
        taps_3.nodes_1[number_1] = _S509 + u32(_S508 * _S506 + _S507 + _S498.x);
        number_1 = number_1 + u32(1);
    }
    return taps_3;
}

fn coverage_of_pack_0( _S510 : u32,  _S511 : CoverageTaps_0,  _S512 : u32) -> vec4<f32>
{
    var number_2 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_2 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S513 : u32 = words_0[fabrics_0[_S510].lobes_0.coverage_0 + _S511.nodes_1[number_2] * fabrics_0[_S510].lobes_0.packs_0 + _S512];
        var even_2 : u32 = even_1 + ((_S513 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S513 >> (u32(8)))) & (u32(16711935))));
        number_2 = number_2 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S514 : u32,  _S515 : CoverageTaps_0) -> f32
{
    var number_3 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S514].lobes_0.coverage_holes_0 + _S515.nodes_1[number_3] / u32(4)] >> ((u32(8) * (_S515.nodes_1[number_3] % u32(4)))))) & (u32(255))));
        number_3 = number_3 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S516 : u32,  _S517 : CoverageTaps_0,  _S518 : NodeTaps_0,  _S519 : bool) -> f32
{
    var _S520 : Lobes_std430_0 = fabrics_0[_S516].lobes_0;
    var _S521 : f32 = interpolate_table_0(_S518, fabrics_0[_S516].lobes_0.projected_area_0 + fabrics_0[_S516].lobes_0.packs_0, fabrics_0[_S516].lobes_0.packs_0 + u32(1)).x;
    var _S522 : f32;
    if(_S519)
    {
        _S522 = _S520.back_hole_weight_0;
    }
    else
    {
        _S522 = _S520.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S516, _S517) * _S521 * _S521 * _S522, 1.0f);
}

fn prefiltered_components_0( _S523 : u32,  _S524 : Footprint_0,  _S525 : vec3<f32>,  _S526 : vec3<f32>,  _S527 : bool) -> Components_0
{
    var _S528 : CoverageTaps_0 = coverage_taps_0(_S523, _S524, _S527);
    var _S529 : NodeTaps_0 = node_taps_0(_S526);
    var view_nodes_0 : NodeTaps_0 = _S529;
    var light_nodes_0 : NodeTaps_0 = node_taps_0(_S525);
    var seen_nodes_0 : NodeTaps_0 = _S529;
    var _S530 : u32;
    if(_S527)
    {
        _S530 = u32(1);
    }
    else
    {
        _S530 = u32(0);
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S530 * u32(256)));
    var _S531 : u32 = u32(2) * _S530;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + vec4<u32>((_S531 * u32(256)));
    var _S532 : u32;
    if((_S525.z) < 0.0f)
    {
        _S532 = u32(1);
    }
    else
    {
        _S532 = u32(0);
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((_S531 + _S532) * u32(256)));
    var _S533 : vec3<f32> = half_vector_0(_S525, _S526);
    var _S534 : vec3<f32> = shadow_correlation_0(_S525, _S526);
    if(_S527)
    {
        _S532 = fabrics_0[_S523].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S532 = fabrics_0[_S523].lobes_0.front_warp_packs_0;
    }
    var sums_1 : Components_0;
    sums_1.diffuse_warp_0 = 0.0f;
    sums_1.diffuse_weft_0 = 0.0f;
    sums_1.specular_warp_0 = 0.0f;
    sums_1.specular_weft_0 = 0.0f;
    sums_1.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        var _S535 : Lobes_std430_0 = fabrics_0[_S523].lobes_0;
        if(pack_0 < (fabrics_0[_S523].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S536 : vec4<f32> = coverage_of_pack_0(_S523, _S528, pack_0);
        var _S537 : vec4<f32> = interpolate_table_0(view_nodes_0, _S535.projected_area_0 + pack_0, _S535.packs_0 + u32(1));
        var _S538 : u32 = _S535.light_visibility_0 + pack_0;
        var _S539 : vec4<f32> = vec4<f32>(255.0f);
        var _S540 : vec4<f32> = interpolate_table_0(seen_nodes_0, _S538, _S535.packs_0) / _S539;
        var _S541 : vec4<f32> = interpolate_table_0(light_nodes_0, _S538, _S535.packs_0) / _S539;
        var _S542 : vec4<f32> = interpolate_table_0(light_nodes_0, _S535.irradiance_0 + pack_0, _S535.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S543 : bool = pack_0 < _S532;
        var _S544 : u32;
        if(_S543)
        {
            _S544 = fabrics_0[_S523].warp_0;
        }
        else
        {
            _S544 = fabrics_0[_S523].weft_0;
        }
        var _S545 : Family_std430_0 = families_0[_S544];
        var number_4 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_4 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S546 : Group_0 = group_at_0(_S535.moments_0 + u32(12) * (u32(4) * (_S530 * _S535.packs_0 + pack_0) + number_4), _S545.roughness_0);
            var _S547 : f32 = _S536[number_4] * _S537[number_4] * _S537[number_4] * _S546.weight_1;
            var _S548 : vec2<f32> = visibility_gain_0(_S534, _S541[number_4], _S540[number_4]);
            var _S549 : f32 = _S548.x;
            var diffuse_1 : f32 = diffuse_0 + _S547 * _S542[number_4] * _S549;
            var specular_1 : f32 = specular_0 + _S547 * layer_value_0(_S546, _S533, _S525, _S526, fabrics_0[_S523].optical_depth_0) * _S541[number_4] * _S548.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S547 * _S541[number_4] * _S549;
            var total_3 : f32 = total_2 + _S547;
            number_4 = number_4 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        var _S550 : f32;
        if(_S543)
        {
            _S550 = diffuse_0;
        }
        else
        {
            _S550 = 0.0f;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S550;
        var _S551 : f32;
        if(_S543)
        {
            _S551 = 0.0f;
        }
        else
        {
            _S551 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S551;
        var _S552 : f32;
        if(_S543)
        {
            _S552 = specular_0;
        }
        else
        {
            _S552 = 0.0f;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S552;
        var _S553 : f32;
        if(_S543)
        {
            _S553 = 0.0f;
        }
        else
        {
            _S553 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S553;
        pack_0 = pack_0 + u32(1);
    }
    var _S554 : f32 = prefiltered_hole_0(_S523, _S528, view_nodes_0, _S527);
    sums_1.hole_2 = _S554;
    var _S555 : f32 = (1.0f - _S554) / max(total_2, 9.999999960041972e-13f);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S555;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S555;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S555;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S555;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S555;
    return sums_1;
}

fn albedos_over_0( _S556 : u32,  _S557 : Footprint_0,  _S558 : bool) -> FamilyAlbedos_0
{
    var _S559 : vec2<f32> = _S557.dx_0;
    var _S560 : vec2<f32> = _S557.dy_0;
    var _S561 : vec2<f32> = sqrt(_S559 * _S559 + _S560 * _S560);
    var _S562 : Stretch_0 = stretch_of_0(fabrics_0[_S556].warp_0, _S557.centre_0.x, _S561.x);
    var _S563 : Stretch_0 = stretch_of_0(fabrics_0[_S556].weft_0, _S557.centre_0.y, _S561.y);
    var albedos_8 : FamilyAlbedos_0;
    albedos_8.warp_2 = mean_albedos_0(fabrics_0[_S556].warp_0, fabrics_0[_S556].weft_0, _S562, _S563, _S558);
    albedos_8.weft_2 = mean_albedos_0(fabrics_0[_S556].weft_0, fabrics_0[_S556].warp_0, _S563, _S562, _S558);
    return albedos_8;
}

fn lobes_estimate_of_pass_0( _S564 : u32,  _S565 : Footprint_0,  _S566 : f32,  _S567 : vec2<f32>,  _S568 : vec3<f32>,  _S569 : vec3<f32>) -> Estimate_0
{
    var _S570 : f32;
    var _S571 : Regime_0 = regime_of_0(_S564, _S565, _S566);
    var _S572 : bool = (_S569.z) < 0.0f;
    var _S573 : vec3<f32> = to_face_frame_0(_S569, _S572);
    var _S574 : bool;
    if((fabrics_0[_S564].fibre_noise_0) > 0.0f)
    {
        _S574 = true;
    }
    else
    {
        _S574 = (fabrics_0[_S564].colour_noise_0) > 0.0f;
    }
    var _S575 : bool;
    if((families_0[fabrics_0[_S564].warp_0].quantities_0) > u32(1))
    {
        _S575 = true;
    }
    else
    {
        _S575 = (families_0[fabrics_0[_S564].weft_0].quantities_0) > u32(1);
    }
    var _S576 : f32 = 1.0f - _S571.prefiltered_0;
    if(_S576 > 0.0f)
    {
        if(_S574)
        {
            _S575 = true;
        }
    }
    else
    {
        _S575 = false;
    }
    var box_0 : Footprint_0 = _S565;
    var _S577 : vec3<f32> = vec3<f32>(0.0f);
    var _S578 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S577, _S577, 0.0f, 0.0f, 0.0f);
    var _S579 : Components_0 = no_components_0();
    var _S580 : i32;
    if(_S575)
    {
        _S580 = i32(0);
    }
    else
    {
        _S580 = i32(1);
    }
    var _S581 : u32 = u32(_S580);
    var points_1 : Components_0 = _S579;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S578;
    var central_place_0 : vec2<f32> = _S565.centre_0;
    var number_5 : u32 = _S581;
    for(;;)
    {
        var _S582 : f32 = f32(number_5);
        _S570 = _S571.points_0;
        if(_S582 < (_S571.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S583 : bool = number_5 == u32(0);
        var _S584 : u32;
        if(_S583)
        {
            _S584 = u32(0);
        }
        else
        {
            _S584 = number_5 - u32(1);
        }
        var _S585 : vec2<f32> = POINT_OFFSETS_0[_S584] + _S567;
        var _S586 : vec2<f32>;
        if(_S583)
        {
            _S586 = vec2<f32>(0.0f);
        }
        else
        {
            _S586 = _S585 - round(_S585);
        }
        var _S587 : vec2<f32> = _S565.centre_0 + vec2<f32>(_S586.x) * _S565.dx_0 + vec2<f32>(_S586.y) * _S565.dy_0;
        var _S588 : f32;
        if(_S583)
        {
            _S588 = 0.0f;
        }
        else
        {
            _S588 = _S571.threads_1;
        }
        var _S589 : SearchQuality_0 = quality_of_0(_S588);
        var _S590 : Hit_0 = first_hit_0(_S564, _S589, _S587.x, _S587.y, _S573, _S572);
        var _S591 : SurfacePoint_0 = surface_at_0(_S564, _S590.x_11, _S590.y_5, _S572);
        if(_S583)
        {
            var central_weight_1 : f32;
            if(_S590.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S576;
            }
            var central_place_1 : vec2<f32> = vec2<f32>(_S590.x_11, _S590.y_5);
            box_0.centre_0 = mix(_S565.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S591;
            central_place_0 = central_place_1;
            number_5 = number_5 + u32(1);
            continue;
        }
        points_1 = with_added_0(points_1, components_of_point_0(_S564, _S589, yarn_point_of_0(_S564, _S591, _S590.x_11, _S590.y_5, _S572, _S590.hole_5), _S568, _S569), min(_S571.points_0 - f32(number_5 - u32(1)), 1.0f));
        number_5 = number_5 + u32(1);
    }
    var estimate_0 : Estimate_0;
    estimate_0.components_0 = with_added_0(_S579, points_1, _S576 / max(_S570, 1.0f));
    if((_S571.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S564, _S565, to_face_frame_0(_S568, _S572), _S573, _S572), _S571.prefiltered_0);
    }
    estimate_0.albedos_4 = albedos_over_0(_S564, box_0, _S572);
    if(_S574)
    {
        _S574 = central_weight_0 > 0.0f;
    }
    else
    {
        _S574 = false;
    }
    if(_S574)
    {
        var _S592 : SurfacePoint_0 = central_0;
        var _S593 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S593 = estimate_0.albedos_4.warp_2;
        }
        else
        {
            _S593 = estimate_0.albedos_4.weft_2;
        }
        var _S594 : Albedos_0 = lerp_albedos_0(_S593, varied_at_0(_S564, central_0, _S593, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S592.is_warp_0)
        {
            estimate_0.albedos_4.warp_2 = _S594;
        }
        else
        {
            estimate_0.albedos_4.weft_2 = _S594;
        }
    }
    return estimate_0;
}

fn lobes_estimate_0( _S595 : u32,  _S596 : Footprint_0,  _S597 : f32,  _S598 : vec3<f32>,  _S599 : vec3<f32>) -> Estimate_0
{
    return lobes_estimate_of_pass_0(_S595, _S596, _S597, vec2<f32>(0.0f), _S598, _S599);
}

fn composed_0( _S600 : u32,  _S601 : Components_0,  _S602 : FamilyAlbedos_0,  _S603 : vec3<f32>,  _S604 : vec3<f32>) -> vec3<f32>
{
    var _S605 : vec3<f32> = vec3<f32>(_S601.diffuse_warp_0);
    var _S606 : vec3<f32> = vec3<f32>(_S601.diffuse_weft_0);
    var _S607 : vec3<f32> = vec3<f32>(_S601.specular_warp_0);
    var _S608 : vec3<f32> = vec3<f32>(_S601.specular_weft_0);
    var _S609 : vec3<f32> = _S602.warp_2.diffuse_reflect_0 * _S605 + _S602.weft_2.diffuse_reflect_0 * _S606 + _S602.warp_2.specular_reflect_0 * _S607 + _S602.weft_2.specular_reflect_0 * _S608;
    var _S610 : f32 = _S604.z;
    var body_0 : vec3<f32>;
    if((_S603.z * _S610) < 0.0f)
    {
        body_0 = _S602.warp_2.diffuse_transmit_0 * _S605 + _S602.weft_2.diffuse_transmit_0 * _S606 + _S602.warp_2.specular_transmit_0 * _S607 + _S602.weft_2.specular_transmit_0 * _S608;
    }
    else
    {
        body_0 = _S609;
    }
    var _S611 : f32 = fabrics_0[_S600].sheen_strength_0;
    if((fabrics_0[_S600].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S612 : bool = _S610 < 0.0f;
    var _S613 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S603, _S612), to_face_frame_0(_S604, _S612), _S611, fabrics_0[_S600].sheen_roughness_0);
    return vec3<f32>(_S613.y) * body_0 + vec3<f32>(((_S601.light_visibility_1 + _S601.hole_2) * _S613.x));
}

fn cloth_value_0( fabric_1 : u32,  centre_2 : vec2<f32>,  dx_1 : vec2<f32>,  dy_1 : vec2<f32>,  light_9 : vec3<f32>,  view_8 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = centre_2;
    footprint_0.dx_0 = dx_1;
    footprint_0.dy_0 = dy_1;
    var _S614 : Estimate_0 = lobes_estimate_0(fabric_1, footprint_0, 1.0f, light_9, view_8);
    var _S615 : vec3<f32> = composed_0(fabric_1, _S614.components_0, _S614.albedos_4, light_9, view_8);
    var through_0 : f32;
    if((fabrics_0[fabric_1].sheen_strength_0) > 0.0f)
    {
        through_0 = _S614.components_0.hole_2 * (1.0f - fabrics_0[fabric_1].sheen_strength_0 * sheen_lobe_0(abs(view_8.z), fabrics_0[fabric_1].sheen_roughness_0).z);
    }
    else
    {
        through_0 = _S614.components_0.hole_2;
    }
    return vec4<f32>(_S615, through_0);
}

@compute
@workgroup_size(64, 1, 1)
fn lobes_queries(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S616 : u32 = id_0.x;
    if(_S616 >= query_count_0[i32(0)])
    {
        return;
    }
    var _S617 : Query_std430_0 = queries_0[_S616];
    answers_0[_S616] = cloth_value_0(_S617.fabric_0, vec2<f32>(_S617.centre_x_0, _S617.centre_y_0), vec2<f32>(_S617.dx_x_0, _S617.dx_y_0), vec2<f32>(_S617.dy_x_0, _S617.dy_y_0), vec3<f32>(_S617.light_x_0, _S617.light_y_0, _S617.light_z_0), vec3<f32>(_S617.view_x_0, _S617.view_y_0, _S617.view_z_0));
    return;
}

