struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
    @align(4) jitter_x_0 : f32,
    @align(4) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(4) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(4) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(4) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(4) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(4) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(4) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(4) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(4) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
};

@binding(4) @group(0) var<storage, read> frames_0 : array<Frame_std430_0>;

@binding(11) @group(0) var visible_faces_0 : texture_2d<u32>;

@binding(7) @group(0) var<storage, read> face_fabrics_0 : array<u32>;

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

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) woven_0 : Woven_std430_0,
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
};

@binding(0) @group(0) var<storage, read> fabrics_0 : array<Fabric_std430_0>;

@binding(6) @group(0) var<storage, read> corners_0 : array<u32>;

struct Vertex_std430_0
{
    @align(4) x_0 : f32,
    @align(4) y_0 : f32,
    @align(4) z_0 : f32,
    @align(4) normal_x_0 : f32,
    @align(4) normal_y_0 : f32,
    @align(4) normal_z_0 : f32,
    @align(4) u_0 : f32,
    @align(4) v_0 : f32,
};

@binding(5) @group(0) var<storage, read> vertices_0 : array<Vertex_std430_0>;

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

struct Light_std430_0
{
    @align(4) is_point_0 : u32,
    @align(4) x_1 : f32,
    @align(4) y_1 : f32,
    @align(4) z_1 : f32,
    @align(4) red_0 : f32,
    @align(4) green_0 : f32,
    @align(4) blue_0 : f32,
};

@binding(3) @group(0) var<storage, read> lights_1 : array<Light_std430_0>;

@binding(8) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn rsqrt_0( x_2 : f32) -> f32
{
    return 1.0f / sqrt(x_2);
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn position_of_0( vertex_0 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_0).x_0, (*vertex_0).y_0, (*vertex_0).z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn camera_right_0( frame_0 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_0).right_x_0, (*frame_0).right_y_0, (*frame_0).right_z_0);
}

fn camera_up_0( frame_1 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_1).up_x_0, (*frame_1).up_y_0, (*frame_1).up_z_0);
}

fn camera_forward_0( frame_2 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_2).forward_x_0, (*frame_2).forward_y_0, (*frame_2).forward_z_0);
}

fn camera_origin_0( frame_3 : ptr<function, Frame_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*frame_3).origin_x_0, (*frame_3).origin_y_0, (*frame_3).origin_z_0);
}

fn normal_of_0( vertex_1 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_1).normal_x_0, (*vertex_1).normal_y_0, (*vertex_1).normal_z_0);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S1 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S2 : u32 = ((((_S1 >> ((((_S1 >> (u32(28)))) + u32(4))))) ^ (_S1))) * u32(277803737);
    return (((_S2 >> (u32(22)))) ^ (_S2));
}

fn uniform_hash_0( thread_0 : u32,  cell_0 : u32,  stream_0 : u32) -> f32
{
    return (f32(((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn footprint_sample_0( pixel_0 : vec2<u32>,  index_0 : u32) -> vec2<f32>
{
    var _S3 : u32 = pixel_0.x;
    var _S4 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S3, _S4, u32(1)), uniform_hash_0(_S3, _S4, u32(2))) + vec2<f32>(f32((index_0 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f)) - vec2<f32>(0.5f);
}

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

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
     view_0 : vec3<f32>,
     axis_x_0 : vec3<f32>,
     axis_y_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     draft_0 : vec2<f32>,
     draft_dx_0 : vec2<f32>,
     draft_dy_0 : vec2<f32>,
};

fn to_local_0( point_0 : VisiblePoint_0,  direction_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_0 : bool) -> vec3<f32>
{
    var _S5 : vec2<f32> = direction_1.xy;
    var _S6 : f32;
    if(back_0)
    {
        _S6 = - direction_1.z;
    }
    else
    {
        _S6 = direction_1.z;
    }
    return vec3<f32>(_S5, _S6);
}

fn turns_and_remainder_0( family_0 : u32,  index_1 : f32) -> vec2<f32>
{
    var _S7 : f32 = floor(fma(index_1, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S7, fma(- _S7, families_0[family_0].count_0, index_1));
}

struct Cell_0
{
     thread_1 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S8 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_1 : Cell_0;
    var _S9 : f32 = fma(- _S8, families_0[family_1].size_0, position_1);
    cell_1.below_0 = _S9;
    cell_1.above_0 = families_0[family_1].size_0 - _S9;
    cell_1.across_0 = _S9 - 0.5f * families_0[family_1].size_0;
    cell_1.half_width_1 = families_0[family_1].half_width_0;
    cell_1.thread_1 = u32(clamp(turns_and_remainder_0(family_1, _S8).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_1;
}

fn table_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_2])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S10 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_2 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S11 : u32;
    if(_S10 >= (table_number_0(families_0[family_2].place_table_0 + thread_2 * u32(4) + u32(1))))
    {
        _S11 = u32(1);
    }
    else
    {
        _S11 = u32(0);
    }
    var _S12 : u32 = min(thread_2 + _S11, u32(families_0[family_2].count_0) - u32(1));
    var _S13 : u32 = families_0[family_2].place_table_0 + _S12 * u32(4);
    var cell_2 : Cell_0;
    cell_2.thread_1 = _S12;
    cell_2.below_0 = _S10 - table_number_0(_S13);
    cell_2.above_0 = table_number_0(_S13 + u32(1)) - _S10;
    cell_2.across_0 = _S10 - table_number_0(_S13 + u32(2));
    cell_2.half_width_1 = table_number_0(_S13 + u32(3));
    return cell_2;
}

fn locate_0( family_3 : u32,  position_3 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
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

fn shown_at_0( crossing_0 : Crossing_0,  back_1 : bool) -> Shown_0
{
    var _S14 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S15 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S16 : bool;
    if(_S14)
    {
        if(!_S15)
        {
            _S16 = true;
        }
        else
        {
            _S16 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S16 = false;
    }
    shown_0.is_warp_0 = _S16;
    if(!_S14)
    {
        _S16 = !_S15;
    }
    else
    {
        _S16 = false;
    }
    shown_0.hole_0 = _S16;
    var _S17 : u32;
    if(shown_0.is_warp_0)
    {
        _S17 = crossing_0.warp_word_0;
    }
    else
    {
        _S17 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S17;
    shown_0.on_top_0 = (((_S17 & (u32(1)))) == u32(1)) != back_1;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    var _S18 : u32;
    if(is_first_0)
    {
        _S18 = first_0.thread_1;
    }
    else
    {
        _S18 = second_0.thread_1;
    }
    cell_3.thread_1 = _S18;
    var _S19 : f32;
    if(is_first_0)
    {
        _S19 = first_0.across_0;
    }
    else
    {
        _S19 = second_0.across_0;
    }
    cell_3.across_0 = _S19;
    if(is_first_0)
    {
        _S19 = first_0.half_width_1;
    }
    else
    {
        _S19 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S19;
    if(is_first_0)
    {
        _S19 = first_0.below_0;
    }
    else
    {
        _S19 = second_0.below_0;
    }
    cell_3.below_0 = _S19;
    if(is_first_0)
    {
        _S19 = first_0.above_0;
    }
    else
    {
        _S19 = second_0.above_0;
    }
    cell_3.above_0 = _S19;
    return cell_3;
}

fn boundary_0( family_4 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S20 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_3) + step_0));
    return fma(_S20.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S20.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_4 : u32,  first_1 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_1) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_4, last_0) - boundary_0(family_5, thread_4, first_1);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_5 : u32) -> Bend_0
{
    var _S21 : Family_std430_0 = families_0[family_6];
    var _S22 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S22 = u32(0);
    }
    else
    {
        _S22 = thread_5 * u32(4);
    }
    var _S23 : u32 = _S21.bend_table_0 + _S22;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S23);
    bend_0.half_tangent_0 = table_number_0(_S23 + u32(1));
    bend_0.arc_0 = table_number_0(_S23 + u32(2));
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

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_6 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S24 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S25 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S26 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S27 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S28 : i32 = - _S24;
    var _S29 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S28, i32(0));
    run_0.from_start_0 = _S29;
    var _S30 : i32 = _S25 + i32(1);
    var _S31 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S30);
    run_0.to_end_0 = _S31;
    var _S32 : bool = _S29 < _S31;
    run_0.near_start_0 = _S32;
    var _S33 : i32;
    if(_S32)
    {
        _S33 = _S28 - _S26;
    }
    else
    {
        _S33 = _S30;
    }
    var _S34 : i32;
    if(run_0.near_start_0)
    {
        _S34 = _S28;
    }
    else
    {
        _S34 = _S30 + _S27;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    var _S35 : f32;
    if(run_0.straight_0)
    {
        _S35 = 1.0e+06f;
    }
    else
    {
        _S35 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S35;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S33, _S34), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S24 == i32(0);
    run_0.last_crossing_0 = _S25 == i32(0);
    return run_0;
}

fn square_1( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_4 : Cell_0) -> Section_0
{
    var _S36 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S37 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_1 = _S37;
    var _S38 : f32 = _S36 * _S36 - square_1(_S37);
    var _S39 : f32 = rsqrt_0(_S38);
    section_0.drop_0 = _S36 - _S38 * _S39;
    section_0.slope_0 = - _S37 * _S39;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_7) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S40 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S41 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S42 : f32;
    if(_S40)
    {
        _S42 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S42 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S43 : f32 = _S42 - crossed_1.half_width_1;
    var _S44 : bool;
    if(_S40)
    {
        _S44 = run_1.first_crossing_0;
    }
    else
    {
        _S44 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S42 = 0.0f;
    }
    else
    {
        _S42 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S45 : f32;
    if((shown_1.on_top_0) != _S44)
    {
        _S45 = 0.0f;
    }
    else
    {
        var _S46 : Family_std430_0 = families_0[other_1];
        var _S47 : i32;
        if(_S40)
        {
            _S47 = i32(-1);
        }
        else
        {
            _S47 = i32(1);
        }
        _S45 = _S46.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S47);
    }
    var _S48 : f32 = 1.0f / max(2.0f * _S43, 9.999999960041972e-13f);
    var _S49 : f32 = clamp((_S43 - _S41) * _S48, 0.0f, 1.0f);
    var _S50 : f32 = _S42 + (_S45 - _S42) * (_S49 * _S49 * (3.0f - 2.0f * _S49));
    var _S51 : f32 = (_S42 - _S45) * (6.0f * _S49 * (1.0f - _S49) * _S48);
    if(_S40)
    {
        _S42 = 1.0f;
    }
    else
    {
        _S42 = -1.0f;
    }
    return vec2<f32>(_S50, _S51 * _S42);
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

fn step_control_0( direction_2 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S52 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S52), 9.99999971718068537e-10f);
    var _S53 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S53), 9.99999971718068537e-10f);
    control_0.right_0 = _S52 > 0.0f;
    control_0.up_0 = _S53 > 0.0f;
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

fn outline_distance_0( cell_5 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S54 : f32;
    if(forwards_0)
    {
        _S54 = cell_5.across_0;
    }
    else
    {
        _S54 = - cell_5.across_0;
    }
    var _S55 : f32;
    if(forwards_0)
    {
        _S55 = cell_5.above_0;
    }
    else
    {
        _S55 = cell_5.below_0;
    }
    var _S56 : bool;
    if(forwards_0)
    {
        _S56 = run_2.last_crossing_0;
    }
    else
    {
        _S56 = run_2.first_crossing_0;
    }
    var _S57 : bool;
    if(forwards_0)
    {
        _S57 = run_2.first_crossing_0;
    }
    else
    {
        _S57 = run_2.last_crossing_0;
    }
    var _S58 : f32 = - cell_5.half_width_1;
    var _S59 : bool = _S54 < _S58;
    var _S60 : bool = _S54 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S56 = !_S56;
    }
    else
    {
        _S56 = false;
    }
    if(_S56)
    {
        _S56 = !shown_2.hole_0;
    }
    else
    {
        _S56 = false;
    }
    var _S61 : bool;
    if(_S56)
    {
        _S61 = shown_2.on_top_0;
    }
    else
    {
        _S61 = false;
    }
    if(_S61)
    {
        if(_S57)
        {
            _S57 = _S59;
        }
        else
        {
            _S57 = false;
        }
        _S57 = !_S57;
    }
    else
    {
        _S57 = false;
    }
    if(shown_2.hole_0)
    {
        _S56 = true;
    }
    else
    {
        if(_S56)
        {
            _S56 = !shown_2.on_top_0;
        }
        else
        {
            _S56 = false;
        }
    }
    var _S62 : f32;
    if(_S59)
    {
        _S62 = _S58;
    }
    else
    {
        _S62 = cell_5.half_width_1;
    }
    var _S63 : f32 = _S62 - _S54;
    if(_S56)
    {
        _S54 = 2.0f * _S55 + _S54 - cell_5.half_width_1;
    }
    else
    {
        _S54 = _S55;
    }
    if(_S57)
    {
        if(forwards_0)
        {
            _S54 = run_2.to_end_0;
        }
        else
        {
            _S54 = run_2.from_start_0;
        }
        return _S54;
    }
    if(_S60)
    {
    }
    else
    {
        _S54 = _S63;
    }
    return _S54;
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
    var _S64 : f32 = previous_1.rate_0 * step_4;
    var _S65 : f32 = rate_1 * step_4;
    var _S66 : bool;
    if(!previous_1.known_0)
    {
        _S66 = true;
    }
    else
    {
        _S66 = here_0.hole_1;
    }
    if(_S66)
    {
        _S66 = true;
    }
    else
    {
        _S66 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S66)
    {
        _S66 = true;
    }
    else
    {
        _S66 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S66)
    {
        _S66 = true;
    }
    else
    {
        _S66 = rate_1 <= 0.0f;
    }
    if(_S66)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S64) >= 0.0f)
    {
        _S66 = (3.0f * clearance_1 - _S65) >= 0.0f;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        return -1.0f;
    }
    var _S67 : f32 = clearance_1 - previous_1.clearance_0;
    var _S68 : f32 = 6.0f * _S67 - 4.0f * _S64 - 2.0f * _S65;
    var _S69 : f32 = -2.0f * _S64 / max(_S68 + sqrt(max(_S68 * _S68 - 4.0f * (3.0f * (_S64 + _S65 - 2.0f * _S67)) * _S64, 0.0f)), 9.99999968265522539e-21f);
    var _S70 : f32 = 1.0f - _S69;
    var _S71 : f32 = (previous_1.clearance_0 * (2.0f * _S69 + 1.0f) + _S64 * _S69) * _S70 * _S70;
    var _S72 : f32 = (clearance_1 * (2.0f * _S70 + 1.0f) - _S65 * _S70) * _S69 * _S69;
    if(_S69 > 0.01999999955296516f)
    {
        _S66 = _S70 > 0.01999999955296516f;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        _S66 = (_S71 + _S72) < 0.0f;
    }
    else
    {
        _S66 = false;
    }
    var _S73 : f32;
    if(_S66)
    {
        _S73 = _S70 * step_4;
    }
    else
    {
        _S73 = -1.0f;
    }
    return _S73;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S74 : f32;
    if(here_1.hole_1)
    {
        _S74 = 1.0e+09f;
    }
    else
    {
        _S74 = clearance_2;
    }
    previous_2.clearance_0 = _S74;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S75 : bool;
    if(!here_1.hole_1)
    {
        _S75 = !is_cell_exit_0;
    }
    else
    {
        _S75 = false;
    }
    previous_2.known_0 = _S75;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_0 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_0.per_x_0, side_y_1 * this_0.per_y_0), 0.0f) + this_0.epsilon_0;
}

fn StepControl_to_next_sample_0( this_1 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S76 : f32 = min(here_2.edge_x_0 * this_1.per_x_0, here_2.edge_y_0 * this_1.per_y_0);
    var _S77 : bool;
    if(!here_2.hole_1)
    {
        _S77 = (rate_3 * _S76 + clearance_3) < 0.0f;
    }
    else
    {
        _S77 = false;
    }
    if(_S77)
    {
        _S77 = _S76 > (2.0f * this_1.epsilon_0);
    }
    else
    {
        _S77 = false;
    }
    var _S78 : f32;
    if(_S77)
    {
        _S78 = _S76 - this_1.epsilon_0;
    }
    else
    {
        _S78 = max(_S76, 0.0f) + this_1.epsilon_0;
    }
    return min(this_1.step_2, _S78);
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
    var _S79 : f32 = end_0 - start_1;
    var _S80 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S79;
    var _S81 : f32 = 3.0f * _S79 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S79, 9.99999968265522539e-21f);
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
        var _S82 : f32 = clamp(share_0 - (((_S80 * share_0 + _S81) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S80 * share_0 + 2.0f * _S81) * share_0 + start_rate_0, 0.10000000149011612f * _S79 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S83 : i32 = i_0 + i32(1);
        share_0 = _S82;
        i_0 = _S83;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S84 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S85 : f32 = rsqrt_0(_S84);
    var _S86 : f32 = sine_1 * _S85 * rsqrt_0(_S84 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S86 * _S84, _S86 * across_slope_0 * along_slope_0 + cosine_0 * _S85);
}

fn arc_sine_0( x_4 : f32) -> f32
{
    var _S87 : f32 = abs(x_4);
    var _S88 : bool = _S87 > 0.5f;
    var _S89 : f32;
    if(_S88)
    {
        _S89 = 0.5f * (1.0f - _S87);
    }
    else
    {
        _S89 = _S87 * _S87;
    }
    var _S90 : f32;
    if(_S88)
    {
        _S90 = sqrt(max(_S89, 0.0f));
    }
    else
    {
        _S90 = _S87;
    }
    var _S91 : f32 = ((((0.04216320067644119f * _S89 + 0.02418131195008755f) * _S89 + 0.04547002539038658f) * _S89 + 0.07495300471782684f) * _S89 + 0.16666752099990845f) * _S89 * _S90 + _S90;
    if(_S88)
    {
        _S89 = 1.57079637050628662f - 2.0f * _S91;
    }
    else
    {
        _S89 = _S91;
    }
    if(x_4 < 0.0f)
    {
        _S89 = - _S89;
    }
    return _S89;
}

fn table_colour_0( index_3 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_3), table_number_0(index_3 + u32(1)), table_number_0(index_3 + u32(2)));
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

fn albedos_of_0( family_8 : u32,  thread_8 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_8);
}

fn thread_gain_0( thread_9 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_0 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S92 : vec3<f32> = room_0 / max(albedo_0, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S92.x, _S92.y), _S92.z), 0.0f));
}

fn natural_logarithm_0( x_5 : f32) -> f32
{
    var _S93 : u32 = (bitcast<u32>((x_5)));
    var exponent_0 : f32 = f32(i32((_S93 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S93 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S94 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S94 - exponent_1 * 0.00021219444170129f - 0.5f * _S94) + exponent_1 * 0.693359375f;
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn towards_light_0( light_0 : ptr<function, Light_std430_0>,  position_4 : vec3<f32>,  irradiance_1 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    (*irradiance_1) = vec3<f32>((*light_0).red_0, (*light_0).green_0, (*light_0).blue_0);
    var _S95 : vec3<f32> = vec3<f32>((*light_0).x_1, (*light_0).y_1, (*light_0).z_1);
    if(((*light_0).is_point_0) == u32(0))
    {
        return _S95;
    }
    var _S96 : vec3<f32> = _S95 - position_4;
    (*irradiance_1) = (*irradiance_1) / vec3<f32>(max(square_0(_S96), 9.999999960041972e-13f));
    return normalize(_S96);
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_1 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S97 : f32 = light_1.z;
    if(_S97 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S97, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_0);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S98 : f32 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S98 * _S98 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_6 : f32) -> f32
{
    var _S99 : f32 = clamp(x_6, -87.0f, 88.0f);
    var _S100 : f32 = floor(_S99 * 1.4426950216293335f + 0.5f);
    var _S101 : f32 = _S99 - _S100 * 0.693359375f + _S100 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S101 + 0.00139819993637502f) * _S101 + 0.00833345204591751f) * _S101 + 0.04166579619050026f) * _S101 + 0.1666666567325592f) * _S101 + 0.5f;
    var _S102 : f32 = (bitcast<f32>(((u32(i32(_S100) + i32(127)) << (u32(23))))));
    var _S103 : f32;
    if(x_6 < -87.0f)
    {
        _S103 = 0.0f;
    }
    else
    {
        _S103 = (p_0 * _S101 * _S101 + _S101 + 1.0f) * _S102;
    }
    return _S103;
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S104 : f32 = roughness_2 * roughness_2;
    var _S105 : f32 = squared_along_0 * (1.0f - _S104) + _S104;
    return 0.31830987334251404f * _S104 * roughness_2 / (_S105 * _S105);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S106 : vec3<f32> = light_2 + view_1;
    var _S107 : f32 = dot(_S106, tangent_1);
    return flake_density_0(min(_S107 * _S107 / max(square_0(_S106), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_2 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S108 : f32 = dot(light_3, normal_2);
    var _S109 : bool;
    if(_S108 <= 0.0f)
    {
        _S109 = true;
    }
    else
    {
        _S109 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S109)
    {
        return 0.0f;
    }
    var _S110 : f32 = max(_S108, 9.99999997475242708e-07f);
    var _S111 : f32 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    var _S112 : f32 = projected_area_1(light_3, tangent_2, roughness_4) * _S111 + projected_area_1(view_2, tangent_2, roughness_4) * _S110;
    var _S113 : f32 = optical_depth_1 * _S112 / (_S110 * _S111);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S113 * mean_attenuation_0(_S113)) * _S110 / _S112;
}

fn transmission_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S114 : f32 = - dot(light_4, normal_3);
    var _S115 : f32 = dot(view_3, normal_3);
    var _S116 : bool;
    if(_S114 <= 0.0f)
    {
        _S116 = true;
    }
    else
    {
        _S116 = _S115 <= 0.0f;
    }
    if(_S116)
    {
        return 0.0f;
    }
    var _S117 : f32 = 1.0f / max(_S115, 9.99999997475242708e-07f);
    var _S118 : f32 = projected_area_1(light_4, tangent_3, roughness_5) / max(_S114, 9.99999997475242708e-07f);
    var _S119 : f32 = projected_area_1(view_3, tangent_3, roughness_5) * _S117;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S118, _S119)) * mean_attenuation_0(optical_depth_2 * abs(_S118 - _S119)) * _S117;
}

fn sheen_scale_0( x_7 : f32,  y_2 : f32) -> f32
{
    return (((((0.0f * x_7 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_7 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_7 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_7 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_7 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_7 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

fn sheen_shear_0( x_8 : f32,  y_3 : f32) -> f32
{
    return ((((0.0f * x_8 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_8 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_8 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_8 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_8 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_9 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_9 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_9 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_9 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_9 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_9 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_6 : f32) -> vec3<f32>
{
    var _S120 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S121 : f32 = 2.0f * sqrt(_S120) - 1.0f;
    var _S122 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S121, _S122), 0.00999999977648258f, 1.0f), clamp((1.0f - _S120) * sheen_shear_0(_S121, _S122), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S121, _S122), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S123 : f32 = light_5.z;
    var _S124 : bool;
    if(_S123 <= 0.0f)
    {
        _S124 = true;
    }
    else
    {
        _S124 = (view_4.z) <= 0.0f;
    }
    if(_S124)
    {
        return 0.0f;
    }
    var _S125 : vec2<f32> = view_4.xy;
    var _S126 : f32 = dot(_S125, _S125);
    var _S127 : vec2<f32>;
    if(_S126 > 9.99999968265522539e-21f)
    {
        _S127 = _S125 * vec2<f32>(rsqrt_0(_S126));
    }
    else
    {
        _S127 = vec2<f32>(1.0f, 0.0f);
    }
    var _S128 : f32 = scale_0 * dot(light_5.xy, _S127) + shear_0 * _S123;
    var _S129 : f32 = scale_0 * (light_5.y * _S127.x - light_5.x * _S127.y);
    var _S130 : f32 = _S128 * _S128 + _S129 * _S129 + _S123 * _S123;
    return 0.31830987334251404f * scale_0 * scale_0 * _S123 / max(_S130 * _S130, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S131 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S132 : f32 = strength_0 * _S131.z;
    return vec2<f32>(_S132 * transformed_cosine_0(light_6, view_5, _S131.x, _S131.y), 1.0f - _S132);
}

fn accumulate_0( frame_4 : ptr<function, Frame_std430_0>,  pixel_1 : vec2<u32>,  light_7 : vec4<f32>)
{
    var _S133 : u32 = pixel_1.y * (*frame_4).width_0 + pixel_1.x;
    var _S134 : f32 = light_7.w;
    var _S135 : vec4<f32> = vec4<f32>(light_7.xyz + vec3<f32>((1.0f - _S134)) * vec3<f32>((*frame_4).background_red_0, (*frame_4).background_green_0, (*frame_4).background_blue_0), _S134);
    var _S136 : vec4<f32>;
    if(((*frame_4).pass_number_0) == u32(0))
    {
        _S136 = _S135;
    }
    else
    {
        _S136 = radiance_0[_S133] + _S135;
    }
    radiance_0[_S133] = _S136;
    return;
}

fn visible_point_0( _S137 : ptr<function, Frame_std430_0>,  _S138 : u32,  _S139 : u32,  _S140 : vec2<u32>) -> VisiblePoint_0
{
    var _S141 : u32 = u32(3) * _S139;
    var _S142 : Vertex_std430_0 = vertices_0[corners_0[_S141]];
    var _S143 : Vertex_std430_0 = vertices_0[corners_0[_S141 + u32(1)]];
    var _S144 : Vertex_std430_0 = vertices_0[corners_0[_S141 + u32(2)]];
    var _S145 : vec3<f32> = position_of_0(&(_S143));
    var _S146 : vec3<f32> = position_of_0(&(_S142));
    var _S147 : vec3<f32> = _S145 - _S146;
    var _S148 : vec3<f32> = position_of_0(&(_S144));
    var _S149 : vec3<f32> = _S148 - _S146;
    var _S150 : vec3<f32> = cross(_S147, _S149);
    var _S151 : f32 = 1.0f / max(square_0(_S150), 1.00000000317107685e-30f);
    var _S152 : vec3<f32> = camera_right_0(&((*_S137)));
    var _S153 : f32 = f32((*_S137).width_0);
    var _S154 : vec3<f32> = _S152 * vec3<f32>((2.0f / _S153));
    var _S155 : vec3<f32> = camera_up_0(&((*_S137)));
    var _S156 : f32 = f32((*_S137).height_0);
    var _S157 : vec3<f32> = _S155 * vec3<f32>((-2.0f / _S156));
    var _S158 : f32 = f32(_S140.x) + 0.5f - 0.5f * _S153;
    var _S159 : f32 = f32(_S140.y) + 0.5f - 0.5f * _S156;
    var _S160 : vec3<f32> = camera_forward_0(&((*_S137)));
    var _S161 : vec3<f32> = _S160 + vec3<f32>(_S158) * _S154 + vec3<f32>(_S159) * _S157;
    var _S162 : f32 = dot(_S161, _S150);
    var _S163 : f32;
    if((abs(_S162)) > 1.00000000317107685e-30f)
    {
        _S163 = _S162;
    }
    else
    {
        _S163 = 1.00000000317107685e-30f;
    }
    var _S164 : f32 = 1.0f / _S163;
    var _S165 : vec3<f32> = camera_origin_0(&((*_S137)));
    var _S166 : vec3<f32> = _S146 - _S165;
    var _S167 : vec3<f32> = vec3<f32>((dot(_S166, _S150) * _S164));
    var _S168 : vec3<f32> = _S161 * _S167 - _S166;
    var _S169 : vec3<f32> = _S167 * (_S154 - _S161 * vec3<f32>((dot(_S154, _S150) * _S164)));
    var _S170 : vec3<f32> = _S167 * (_S157 - _S161 * vec3<f32>((dot(_S157, _S150) * _S164)));
    var _S171 : vec3<f32> = vec3<f32>(_S151);
    var _S172 : vec3<f32> = cross(_S149, _S150) * _S171;
    var _S173 : vec3<f32> = cross(_S150, _S147) * _S171;
    var _S174 : f32 = dot(_S168, _S172);
    var _S175 : f32 = dot(_S168, _S173);
    var _S176 : f32 = _S143.u_0 - _S142.u_0;
    var _S177 : f32 = _S143.v_0 - _S142.v_0;
    var _S178 : vec2<f32> = vec2<f32>(_S176, _S177);
    var _S179 : f32 = _S144.u_0 - _S142.u_0;
    var _S180 : f32 = _S144.v_0 - _S142.v_0;
    var _S181 : vec2<f32> = vec2<f32>(_S179, _S180);
    var _S182 : vec2<f32> = vec2<f32>(_S142.u_0, _S142.v_0) + vec2<f32>(_S174) * _S178 + vec2<f32>(_S175) * _S181;
    var _S183 : vec2<f32> = vec2<f32>(dot(_S169, _S172)) * _S178 + vec2<f32>(dot(_S169, _S173)) * _S181;
    var _S184 : vec2<f32> = vec2<f32>(dot(_S170, _S172)) * _S178 + vec2<f32>(dot(_S170, _S173)) * _S181;
    if((_S176 * _S180 - _S177 * _S179) < 0.0f)
    {
        _S163 = -1.0f;
    }
    else
    {
        _S163 = 1.0f;
    }
    var _S185 : vec3<f32> = vec3<f32>(_S163) * (vec3<f32>(_S180) * _S147 - vec3<f32>(_S177) * _S149);
    var _S186 : vec3<f32> = vec3<f32>(_S163) * (vec3<f32>(_S176) * _S149 - vec3<f32>(_S179) * _S147);
    var point_1 : VisiblePoint_0;
    var _S187 : f32 = 1.0f - _S174 - _S175;
    var _S188 : vec3<f32> = normal_of_0(&(_S142));
    var _S189 : vec3<f32> = vec3<f32>(_S187) * _S188;
    var _S190 : vec3<f32> = normal_of_0(&(_S143));
    var _S191 : vec3<f32> = _S189 + vec3<f32>(_S174) * _S190;
    var _S192 : vec3<f32> = normal_of_0(&(_S144));
    var _S193 : vec3<f32> = normalize(_S191 + vec3<f32>(_S175) * _S192);
    point_1.normal_0 = _S193;
    var _S194 : vec3<f32> = normalize(_S185 - _S193 * vec3<f32>(dot(_S193, _S185)));
    point_1.axis_x_0 = _S194;
    point_1.axis_y_0 = cross(_S193, _S194);
    point_1.position_0 = _S146 + _S168;
    point_1.view_0 = (vec3<f32>(0) - normalize(_S161));
    var _S195 : bool = (dot(cross(_S185, _S186), _S193)) < 0.0f;
    var _S196 : f32 = fabrics_0[_S138].uv_width_0;
    if(_S195)
    {
        _S163 = - fabrics_0[_S138].uv_height_0;
    }
    else
    {
        _S163 = fabrics_0[_S138].uv_height_0;
    }
    var _S197 : vec2<f32> = vec2<f32>(_S196, _S163);
    var _S198 : vec2<f32> = _S182 * _S197;
    if(_S195)
    {
        _S163 = fabrics_0[_S138].uv_height_0;
    }
    else
    {
        _S163 = 0.0f;
    }
    point_1.draft_0 = _S198 + vec2<f32>(0.0f, _S163);
    point_1.draft_dx_0 = _S183 * _S197;
    point_1.draft_dy_0 = _S184 * _S197;
    return point_1;
}

struct YarnPoint_0
{
     back_2 : bool,
     hole_2 : bool,
     is_warp_1 : bool,
     x_10 : f32,
     y_5 : f32,
     height_3 : f32,
     normal_4 : vec3<f32>,
     tangent_4 : vec3<f32>,
     roughness_8 : f32,
     albedos_1 : Albedos_0,
};

struct Hit_0
{
     x_11 : f32,
     y_6 : f32,
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

fn crossing_at_0( _S199 : u32,  _S200 : f32,  _S201 : f32,  _S202 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S199].warp_0, _S200);
    crossing_2.weft_1 = locate_0(fabrics_0[_S199].weft_0, _S201);
    var _S203 : u32 = fabrics_0[_S199].run_words_0 + u32(2) * (crossing_2.weft_1.thread_1 * fabrics_0[_S199].ends_1 + crossing_2.warp_1.thread_1);
    var _S204 : u32 = words_0[_S203];
    crossing_2.warp_word_0 = _S204;
    crossing_2.weft_word_0 = words_0[_S203 + u32(1)];
    crossing_2.warp_above_0 = (((_S204 & (u32(1)))) == u32(1)) != _S202;
    return crossing_2;
}

fn sample_at_0( _S205 : u32,  _S206 : f32,  _S207 : f32,  _S208 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S209 : Crossing_0 = crossing_at_0(_S205, _S206, _S207, _S208);
    sample_0.crossing_1 = _S209;
    var _S210 : Shown_0 = shown_at_0(_S209, _S208);
    sample_0.shown_3 = _S210;
    var _S211 : u32;
    if(_S210.is_warp_0)
    {
        _S211 = fabrics_0[_S205].warp_0;
    }
    else
    {
        _S211 = fabrics_0[_S205].weft_0;
    }
    var _S212 : u32;
    if(_S210.is_warp_0)
    {
        _S212 = fabrics_0[_S205].weft_0;
    }
    else
    {
        _S212 = fabrics_0[_S205].warp_0;
    }
    var _S213 : Cell_0 = select_cell_0(_S210.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S214 : Cell_0 = select_cell_0(_S210.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S215 : Run_0 = unpack_0(_S211, _S212, _S213.thread_1, _S214, _S210.word_0);
    var _S216 : Section_0 = section_at_0(_S213);
    var _S217 : bool;
    if(_S210.on_top_0)
    {
        _S217 = (_S215.distance_0) < (_S216.drop_0 * _S215.bend_1.sine_0);
    }
    else
    {
        _S217 = false;
    }
    var _S218 : bool;
    if(_S210.on_top_0)
    {
        _S218 = !_S217;
    }
    else
    {
        _S218 = false;
    }
    var _S219 : f32;
    if(_S218)
    {
        _S219 = 1.0f;
    }
    else
    {
        _S219 = -1.0f;
    }
    var _S220 : f32;
    if(_S217)
    {
        _S220 = _S215.other_reach_0;
    }
    else
    {
        _S220 = _S215.reach_0;
    }
    var _S221 : f32;
    if(_S217)
    {
        _S221 = _S220 + _S215.distance_0;
    }
    else
    {
        _S221 = max(_S220 - _S215.distance_0, 0.0f);
    }
    var _S222 : f32 = _S220 / _S215.bend_1.sine_0 - _S219 * _S216.drop_0;
    var _S223 : f32 = _S221 * _S221;
    var _S224 : f32 = max(_S222 * _S222 - _S223, 9.99999968265522539e-21f);
    var _S225 : f32 = rsqrt_0(_S224);
    var _S226 : f32 = _S223 / (_S224 * _S225 + _S222);
    var _S227 : bool = _S221 > 0.0f;
    var _S228 : f32;
    if(_S210.on_top_0)
    {
        _S228 = 1.0f;
    }
    else
    {
        _S228 = -1.0f;
    }
    var _S229 : f32;
    if(_S215.near_start_0)
    {
        _S229 = 1.0f;
    }
    else
    {
        _S229 = -1.0f;
    }
    var _S230 : f32 = _S228 * _S229;
    if(_S227)
    {
        _S228 = _S222 * _S225;
    }
    else
    {
        _S228 = 1.0f;
    }
    sample_0.slope_across_0 = _S216.slope_0 * _S228;
    if(_S227)
    {
        _S221 = _S230 * _S221 * _S225;
    }
    else
    {
        _S221 = 0.0f;
    }
    sample_0.slope_along_0 = _S221;
    var _S231 : Family_std430_0 = families_0[_S211];
    var _S232 : vec2<f32> = dive_0(_S212, _S210, _S215, _S214);
    if(_S215.straight_0)
    {
        _S219 = 0.0f;
    }
    else
    {
        _S219 = _S231.height_scale_0 * _S219;
    }
    sample_0.height_5 = _S219 * (_S220 * _S215.bend_1.half_tangent_0 - _S226) - _S231.height_scale_0 * _S216.drop_0 - _S232.x;
    var _S233 : f32 = _S231.height_scale_0 * sample_0.slope_across_0;
    var _S234 : f32 = _S231.height_scale_0 * sample_0.slope_along_0 - _S232.y;
    if(_S210.is_warp_0)
    {
        _S219 = _S233;
    }
    else
    {
        _S219 = _S234;
    }
    sample_0.slope_x_1 = _S219;
    if(_S210.is_warp_0)
    {
        _S219 = _S234;
    }
    else
    {
        _S219 = _S233;
    }
    sample_0.slope_y_1 = _S219;
    sample_0.run_3 = _S215;
    sample_0.section_1 = _S216;
    return sample_0;
}

fn steps_per_length_0( _S235 : u32,  _S236 : SearchQuality_0,  _S237 : vec3<f32>) -> f32
{
    return max(max(abs(_S237.x) * fabrics_0[_S235].threads_per_x_0, abs(_S237.y) * fabrics_0[_S235].threads_per_y_0) * _S236.steps_per_thread_0, abs(_S237.z) * fabrics_0[_S235].per_relief_0 * _S236.steps_per_relief_0);
}

fn cell_maximum_0( _S238 : u32,  _S239 : Crossing_0) -> f32
{
    var _S240 : u32;
    if(_S239.warp_above_0)
    {
        _S240 = fabrics_0[_S238].warp_0;
    }
    else
    {
        _S240 = fabrics_0[_S238].weft_0;
    }
    var _S241 : u32;
    if(_S239.warp_above_0)
    {
        _S241 = _S239.warp_word_0;
    }
    else
    {
        _S241 = _S239.weft_word_0;
    }
    return f32((_S241 >> (u32(28)))) * families_0[_S240].height_scale_0 * families_0[_S240].level_0;
}

fn probe_0( _S242 : u32,  _S243 : f32,  _S244 : f32,  _S245 : bool,  _S246 : bool,  _S247 : bool) -> Probe_0
{
    var _S248 : Sample_0 = sample_at_0(_S242, _S243, _S244, _S245);
    var probe_1 : Probe_0;
    probe_1.height_1 = _S248.height_5;
    probe_1.hole_1 = _S248.shown_3.hole_0;
    probe_1.slope_x_0 = _S248.slope_x_1;
    probe_1.slope_y_0 = _S248.slope_y_1;
    var _S249 : u32;
    if(_S248.shown_3.is_warp_0)
    {
        _S249 = _S248.crossing_1.warp_1.thread_1 * u32(2) + u32(1);
    }
    else
    {
        _S249 = _S248.crossing_1.weft_1.thread_1 * u32(2);
    }
    probe_1.yarn_1 = _S249;
    probe_1.cell_max_0 = cell_maximum_0(_S242, _S248.crossing_1);
    var _S250 : f32;
    if(_S246)
    {
        _S250 = _S248.crossing_1.warp_1.above_0;
    }
    else
    {
        _S250 = _S248.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S250;
    if(_S247)
    {
        _S250 = _S248.crossing_1.weft_1.above_0;
    }
    else
    {
        _S250 = _S248.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S250;
    probe_1.edge_x_0 = outline_distance_0(_S248.crossing_1.warp_1, _S248.shown_3, _S248.run_3, !_S248.shown_3.is_warp_0, _S246);
    probe_1.edge_y_0 = outline_distance_0(_S248.crossing_1.weft_1, _S248.shown_3, _S248.run_3, _S248.shown_3.is_warp_0, _S247);
    return probe_1;
}

fn is_free_0( _S251 : u32,  _S252 : SearchQuality_0,  _S253 : vec3<f32>,  _S254 : vec3<f32>,  _S255 : bool,  _S256 : f32) -> bool
{
    var _S257 : f32 = _S254.z;
    if(_S257 <= 0.0f)
    {
        return false;
    }
    var _S258 : f32 = 1.0f / max(_S252.shadow_share_0 * steps_per_length_0(_S251, _S252, _S254), 9.99999971718068537e-10f);
    var _S259 : StepControl_0 = step_control_0(_S254.xy, _S258);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_1 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S260 : bool;
        if(count_1 < u32(1024))
        {
            _S260 = (_S253.z + _S257 * distance_1) < _S256;
        }
        else
        {
            _S260 = false;
        }
        if(_S260)
        {
        }
        else
        {
            break;
        }
        var _S261 : vec3<f32> = _S253 + _S254 * vec3<f32>(distance_1);
        var _S262 : Probe_0 = probe_0(_S251, _S261.x, _S261.y, _S255, _S259.right_0, _S259.up_0);
        var _S263 : f32 = _S261.z;
        var _S264 : f32 = _S263 - _S262.height_1;
        var _S265 : f32 = _S257 - _S262.slope_x_0 * _S254.x - _S262.slope_y_0 * _S254.y;
        var _S266 : bool;
        if(!_S262.hole_1)
        {
            _S266 = _S264 < 0.0f;
        }
        else
        {
            _S266 = false;
        }
        if(_S266)
        {
            return false;
        }
        var _S267 : f32 = way_back_to_dip_0(previous_3, _S264, _S265, last_step_0, _S262);
        if(_S267 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S267;
            distance_1 = distance_1 - _S267;
            last_step_0 = last_step_1;
            count_1 = count_1 + u32(1);
            continue;
        }
        var _S268 : bool = _S263 > (_S262.cell_max_0);
        var _S269 : PreviousSample_0 = after_sample_0(_S264, _S265, _S262, _S268);
        var last_step_2 : f32;
        if(_S268)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S259, _S262.side_x_0, _S262.side_y_0), _S258);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S259, _S262, _S264, _S265);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S269;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_1 = count_1 + u32(1);
    }
    return true;
}

fn passes_through_0( _S270 : u32,  _S271 : SearchQuality_0,  _S272 : f32,  _S273 : f32,  _S274 : vec3<f32>,  _S275 : bool) -> bool
{
    if(!sample_at_0(_S270, _S272, _S273, _S275).shown_3.hole_0)
    {
        return false;
    }
    var _S276 : vec3<f32> = vec3<f32>(_S272, _S273, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S277 : bool;
        if(side_0 < u32(2))
        {
            _S277 = passes_0;
        }
        else
        {
            _S277 = false;
        }
        if(_S277)
        {
        }
        else
        {
            break;
        }
        var _S278 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S278 = _S274;
        }
        else
        {
            _S278 = vec3<f32>(- _S274.x, - _S274.y, _S274.z);
        }
        var _S279 : bool = is_free_0(_S270, _S271, _S276, _S278, _S275 != (side_0 == u32(1)), fabrics_0[_S270].height_high_0);
        var _S280 : u32 = side_0 + u32(1);
        passes_0 = _S279;
        side_0 = _S280;
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

fn max_height_along_0( _S281 : u32,  _S282 : f32,  _S283 : f32,  _S284 : f32,  _S285 : vec3<f32>,  _S286 : bool) -> f32
{
    var _S287 : u32 = locate_0(fabrics_0[_S281].warp_0, _S282).thread_1 / u32(2);
    var _S288 : u32 = locate_0(fabrics_0[_S281].weft_0, _S283).thread_1 / u32(2);
    var _S289 : f32 = _S285.x;
    var _S290 : u32;
    if(_S289 > 0.0f)
    {
        _S290 = u32(1);
    }
    else
    {
        _S290 = u32(0);
    }
    var _S291 : f32 = _S285.y;
    var _S292 : u32;
    if(_S291 > 0.0f)
    {
        _S292 = u32(2);
    }
    else
    {
        _S292 = u32(0);
    }
    var _S293 : u32 = words_0[fabrics_0[_S281].max_heights_0 + u32(4) * (_S288 * fabrics_0[_S281].max_height_columns_0 + _S287) + (_S290 + _S292)];
    var number_0 : i32;
    if(_S286)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S294 : u32 = (_S293 >> (u32(number_0)));
    var _S295 : f32 = max(abs(_S289) * fabrics_0[_S281].threads_per_x_0, abs(_S291) * fabrics_0[_S281].threads_per_y_0) / _S285.z;
    var _S296 : f32 = fabrics_0[_S281].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S281].height_high_0;
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
        if(((max_height_0 - _S284) * _S295) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S294 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S296);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S297 : u32,  _S298 : f32,  _S299 : f32,  _S300 : bool,  _S301 : bool,  _S302 : bool) -> vec3<f32>
{
    var _S303 : Crossing_0 = crossing_at_0(_S297, _S298, _S299, _S300);
    var _S304 : f32 = cell_maximum_0(_S297, _S303);
    var _S305 : f32;
    if(_S301)
    {
        _S305 = _S303.warp_1.above_0;
    }
    else
    {
        _S305 = _S303.warp_1.below_0;
    }
    var _S306 : f32;
    if(_S302)
    {
        _S306 = _S303.weft_1.above_0;
    }
    else
    {
        _S306 = _S303.weft_1.below_0;
    }
    return vec3<f32>(_S304, _S305, _S306);
}

fn first_sample_height_0( _S307 : u32,  _S308 : ViewRay_0,  _S309 : StepControl_0,  _S310 : bool) -> f32
{
    var _S311 : f32 = max_height_along_0(_S307, _S308.origin_0.x, _S308.origin_0.y, 0.0f, vec3<f32>(_S308.slope_1, 1.0f), _S310);
    var count_2 : u32 = u32(0);
    var height_7 : f32 = _S311;
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S312 : vec2<f32> = ViewRay_at_0(_S308, height_7);
        var _S313 : vec3<f32> = cell_bounds_0(_S307, _S312.x, _S312.y, _S310, _S309.right_0, _S309.up_0);
        var _S314 : f32 = height_7 - _S313.x;
        var _S315 : f32 = StepControl_to_cell_exit_0(_S309, _S313.y, _S313.z);
        var height_8 : f32 = height_7 - clamp(_S314, 0.0f, _S315);
        if(_S314 <= _S315)
        {
            height_7 = height_8;
            break;
        }
        count_2 = count_2 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn search_down_0( _S316 : u32,  _S317 : ViewRay_0,  _S318 : StepControl_0,  _S319 : bool) -> ViewRayEnd_0
{
    var _S320 : f32 = fabrics_0[_S316].height_low_0 - (fabrics_0[_S316].height_high_0 - fabrics_0[_S316].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S316, _S317, _S318, _S319);
    end_1.last_step_3 = _S318.epsilon_0;
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
        var _S321 : vec2<f32> = ViewRay_at_0(_S317, end_1.height_6);
        var _S322 : Probe_0 = probe_0(_S316, _S321.x, _S321.y, _S319, _S318.right_0, _S318.up_0);
        var _S323 : f32 = end_1.height_6 - _S322.height_1;
        var _S324 : f32 = ViewRay_rate_0(_S317, _S322);
        end_1.depth_1 = - _S323;
        end_1.rate_4 = _S324;
        var _S325 : bool;
        if(end_1.previous_4.known_0)
        {
            _S325 = !_S322.hole_1;
        }
        else
        {
            _S325 = false;
        }
        var _S326 : bool;
        if(_S325)
        {
            _S326 = (end_1.previous_4.yarn_0) == (_S322.yarn_1);
        }
        else
        {
            _S326 = false;
        }
        end_1.smooth_0 = _S326;
        var _S327 : bool;
        if(!_S322.hole_1)
        {
            _S327 = _S323 <= 0.0f;
        }
        else
        {
            _S327 = false;
        }
        var _S328 : bool;
        if(_S327)
        {
            _S328 = true;
        }
        else
        {
            _S328 = (end_1.height_6) <= _S320;
        }
        if(_S328)
        {
            break;
        }
        var _S329 : f32 = way_back_to_dip_0(end_1.previous_4, _S323, _S324, end_1.last_step_3, _S322);
        if(_S329 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S329;
            end_1.last_step_3 = end_1.last_step_3 - _S329;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S330 : f32 = min(StepControl_to_cell_exit_0(_S318, _S322.side_x_0, _S322.side_y_0), end_1.height_6 - _S322.cell_max_0);
        var _S331 : f32 = StepControl_to_next_sample_0(_S318, _S322, _S323, _S324);
        end_1.previous_4 = after_sample_0(_S323, _S324, _S322, _S330 > _S331);
        var _S332 : f32 = max(_S330, _S331);
        end_1.last_step_3 = _S332;
        end_1.height_6 = end_1.height_6 - _S332;
        count_3 = count_3 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S333 : u32,  _S334 : ViewRay_0,  _S335 : StepControl_0,  _S336 : bool,  _S337 : ViewRayEnd_0,  _S338 : u32) -> f32
{
    var _S339 : f32 = fabrics_0[_S333].height_high_0 - fabrics_0[_S333].height_low_0;
    var above_2 : f32 = _S337.height_6 + _S337.last_step_3;
    var above_gap_1 : f32 = clamp(_S337.previous_4.clearance_0, 0.0f, _S339);
    var under_gap_1 : f32 = clamp(_S337.depth_1, 0.0f, _S339);
    var _S340 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S337.previous_4.rate_0 * _S337.last_step_3, _S337.rate_4 * _S337.last_step_3);
    var middle_0 : f32;
    if(_S337.smooth_0)
    {
        middle_0 = above_2 - _S340 * _S337.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S337.height_6, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S337.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S338)
        {
        }
        else
        {
            break;
        }
        var _S341 : vec2<f32> = ViewRay_at_0(_S334, middle_0);
        var _S342 : Probe_0 = probe_0(_S333, _S341.x, _S341.y, _S336, _S335.right_0, _S335.up_0);
        var _S343 : f32;
        if(_S342.hole_1)
        {
            _S343 = -1.0e+09f;
        }
        else
        {
            _S343 = _S342.height_1;
        }
        var _S344 : f32 = clamp(middle_0 - _S343, - _S339, _S339);
        var _S345 : f32;
        if(_S344 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S345 = 0.5f * above_gap_2;
            }
            else
            {
                _S345 = above_gap_2;
            }
            var _S346 : f32 = - _S344;
            under_1 = middle_0;
            above_gap_2 = _S345;
            under_gap_2 = _S346;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S345 = 0.5f * under_gap_2;
            }
            else
            {
                _S345 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S344;
            under_gap_2 = _S345;
            side_1 = -1.0f;
        }
        if(_S337.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S344 / min(ViewRay_rate_0(_S334, _S342), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S337.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S347 : u32,  _S348 : SearchQuality_0,  _S349 : f32,  _S350 : f32,  _S351 : vec3<f32>,  _S352 : bool) -> Hit_0
{
    var _S353 : f32 = max(_S351.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S349, _S350);
    var _S354 : vec2<f32> = _S351.xy / vec2<f32>(_S353);
    ray_0.slope_1 = _S354;
    var _S355 : StepControl_0 = step_control_0((vec2<f32>(0) - _S354), 1.0f / max(steps_per_length_0(_S347, _S348, _S351) / _S353, 9.99999971718068537e-10f));
    var _S356 : ViewRayEnd_0 = search_down_0(_S347, ray_0, _S355, _S352);
    var hit_0 : Hit_0;
    hit_0.hole_3 = false;
    var _S357 : f32 = refined_height_0(_S347, ray_0, _S355, _S352, _S356, _S348.refinements_0);
    hit_0.height_4 = _S357;
    var _S358 : vec2<f32> = ViewRay_at_0(ray_0, _S357);
    hit_0.x_11 = _S358.x;
    hit_0.y_6 = _S358.y;
    return hit_0;
}

fn first_hit_0( _S359 : u32,  _S360 : SearchQuality_0,  _S361 : f32,  _S362 : f32,  _S363 : vec3<f32>,  _S364 : bool) -> Hit_0
{
    if(!passes_through_0(_S359, _S360, _S361, _S362, _S363, _S364))
    {
        return first_hit_of_yarn_0(_S359, _S360, _S361, _S362, _S363, _S364);
    }
    var hit_1 : Hit_0;
    hit_1.x_11 = _S361;
    hit_1.y_6 = _S362;
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
     normal_5 : vec3<f32>,
     tangent_5 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn surface_at_0( _S365 : u32,  _S366 : f32,  _S367 : f32,  _S368 : bool) -> SurfacePoint_0
{
    var _S369 : Sample_0 = sample_at_0(_S365, _S366, _S367, _S368);
    var _S370 : f32;
    if(_S369.shown_3.is_warp_0)
    {
        _S370 = _S369.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S370 = _S369.crossing_1.weft_1.half_width_1;
    }
    var _S371 : u32;
    if(_S369.shown_3.is_warp_0)
    {
        _S371 = fabrics_0[_S365].warp_0;
    }
    else
    {
        _S371 = fabrics_0[_S365].weft_0;
    }
    var _S372 : Family_std430_0 = families_0[_S371];
    var _S373 : f32;
    if(_S368)
    {
        _S373 = -1.0f;
    }
    else
    {
        _S373 = 1.0f;
    }
    var _S374 : f32 = _S372.twist_sine_0 * _S373;
    var _S375 : Family_std430_0 = families_0[_S371];
    if(_S369.shown_3.is_warp_0)
    {
        _S373 = 1.0f;
    }
    else
    {
        _S373 = -1.0f;
    }
    var _S376 : vec2<f32> = fibre_direction_0(_S369.slope_across_0, _S373 * _S369.slope_along_0, _S374, _S375.twist_cosine_0);
    var _S377 : f32;
    if(_S369.shown_3.is_warp_0)
    {
        _S377 = _S369.slope_x_1;
    }
    else
    {
        _S377 = _S369.slope_y_1;
    }
    var _S378 : f32;
    if(_S369.shown_3.is_warp_0)
    {
        _S378 = _S369.slope_y_1;
    }
    else
    {
        _S378 = _S369.slope_x_1;
    }
    var _S379 : f32 = _S376.x;
    var _S380 : f32 = _S376.y;
    var _S381 : f32 = _S377 * _S379 + _S373 * _S378 * _S380;
    var _S382 : f32 = _S370 * 1.0154266357421875f;
    var _S383 : f32 = _S382 * arc_sine_0(clamp(_S369.section_1.across_1 / _S382, -1.0f, 1.0f));
    if(_S369.shown_3.is_warp_0)
    {
        _S370 = _S367;
    }
    else
    {
        _S370 = - _S366;
    }
    var point_2 : SurfacePoint_0;
    point_2.hole_4 = _S369.shown_3.hole_0;
    point_2.is_warp_2 = _S369.shown_3.is_warp_0;
    point_2.warp_thread_0 = _S369.crossing_1.warp_1.thread_1;
    point_2.weft_thread_0 = _S369.crossing_1.weft_1.thread_1;
    point_2.height_9 = _S369.height_5;
    point_2.normal_5 = normalize(vec3<f32>(- _S369.slope_x_1, - _S369.slope_y_1, 1.0f));
    var _S384 : vec3<f32>;
    if(_S369.shown_3.is_warp_0)
    {
        _S384 = vec3<f32>(_S379, _S380, _S381);
    }
    else
    {
        _S384 = vec3<f32>(- _S380, _S379, _S381);
    }
    point_2.tangent_5 = normalize(_S384);
    point_2.across_2 = _S369.section_1.across_1;
    point_2.fibre_across_0 = _S383 * _S375.twist_cosine_0 + _S370 * _S374;
    point_2.fibre_along_0 = _S370 * _S375.twist_cosine_0 - _S383 * _S374;
    return point_2;
}

fn vary_albedos_0( _S385 : u32,  _S386 : Albedos_0,  _S387 : u32,  _S388 : u32) -> Albedos_0
{
    var _S389 : vec3<f32> = max(_S386.specular_reflect_0, _S386.specular_transmit_0);
    var _S390 : vec3<f32> = _S386.diffuse_reflect_0 + _S386.diffuse_transmit_0;
    var _S391 : vec3<f32> = vec3<f32>(fabrics_0[_S385].layer_bound_0);
    var _S392 : vec3<f32> = vec3<f32>(1.0f);
    var _S393 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S387, fabrics_0[_S385].colour_noise_0, fabrics_0[_S385].seed_0), _S390, _S392 - _S391 * _S389));
    var _S394 : f32 = bounded_gain_0(fibre_gain_0(_S387, _S388, fabrics_0[_S385].fibre_noise_0, fabrics_0[_S385].seed_0), _S389, min((_S392 - _S393 * _S390) / _S391, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S393 * _S386.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S393 * _S386.diffuse_transmit_0;
    var _S395 : vec3<f32> = vec3<f32>(_S394);
    varied_0.specular_reflect_0 = _S395 * _S386.specular_reflect_0;
    varied_0.specular_transmit_0 = _S395 * _S386.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S396 : u32,  _S397 : SurfacePoint_0,  _S398 : Albedos_0,  _S399 : f32,  _S400 : f32) -> Albedos_0
{
    var _S401 : f32;
    if(_S397.is_warp_2)
    {
        _S401 = _S399;
    }
    else
    {
        _S401 = _S400;
    }
    var _S402 : f32 = _S401 - _S397.across_2;
    var _S403 : u32;
    if(_S397.is_warp_2)
    {
        _S403 = fabrics_0[_S396].warp_0;
    }
    else
    {
        _S403 = fabrics_0[_S396].weft_0;
    }
    var _S404 : Family_std430_0 = families_0[_S403];
    var _S405 : i32 = i32(families_0[_S403].count_0);
    if(_S397.is_warp_2)
    {
        _S403 = _S397.warp_thread_0;
    }
    else
    {
        _S403 = _S397.weft_thread_0;
    }
    var _S406 : u32 = u32(i32(floor(_S402 / _S404.period_0)) * _S405 + i32(_S403)) * u32(2);
    if(_S397.is_warp_2)
    {
        _S403 = u32(1);
    }
    else
    {
        _S403 = u32(0);
    }
    var _S407 : f32 = floor(_S397.fibre_across_0 / fabrics_0[_S396].fibre_size_0);
    return vary_albedos_0(_S396, _S398, _S406 + _S403, u32(i32(_S407)) * u32(65536) + u32(i32(floor(_S397.fibre_along_0 / (fabrics_0[_S396].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S407))));
}

fn yarn_point_of_0( _S408 : u32,  _S409 : SurfacePoint_0,  _S410 : f32,  _S411 : f32,  _S412 : bool,  _S413 : bool) -> YarnPoint_0
{
    var _S414 : u32;
    if(_S409.is_warp_2)
    {
        _S414 = fabrics_0[_S408].warp_0;
    }
    else
    {
        _S414 = fabrics_0[_S408].weft_0;
    }
    var _S415 : u32;
    if(_S409.is_warp_2)
    {
        _S415 = _S409.warp_thread_0;
    }
    else
    {
        _S415 = _S409.weft_thread_0;
    }
    var albedos_2 : Albedos_0 = albedos_of_0(_S414, _S415);
    var _S416 : bool;
    if((fabrics_0[_S408].fibre_noise_0) > 0.0f)
    {
        _S416 = true;
    }
    else
    {
        _S416 = (fabrics_0[_S408].colour_noise_0) > 0.0f;
    }
    var albedos_3 : Albedos_0;
    if(_S416)
    {
        albedos_3 = varied_at_0(_S408, _S409, albedos_2, _S410, _S411);
    }
    else
    {
        albedos_3 = albedos_2;
    }
    var point_3 : YarnPoint_0;
    point_3.back_2 = _S412;
    point_3.hole_2 = _S413;
    point_3.is_warp_1 = _S409.is_warp_2;
    point_3.x_10 = _S410;
    point_3.y_5 = _S411;
    point_3.height_3 = _S409.height_9;
    point_3.normal_4 = _S409.normal_5;
    point_3.tangent_4 = _S409.tangent_5;
    point_3.roughness_8 = families_0[_S414].roughness_0;
    point_3.albedos_1 = albedos_3;
    return point_3;
}

fn locate_yarn_0( _S417 : u32,  _S418 : SearchQuality_0,  _S419 : f32,  _S420 : f32,  _S421 : vec3<f32>) -> YarnPoint_0
{
    var _S422 : bool = (_S421.z) < 0.0f;
    var _S423 : Hit_0 = first_hit_0(_S417, _S418, _S419, _S420, to_face_frame_0(_S421, _S422), _S422);
    return yarn_point_of_0(_S417, surface_at_0(_S417, _S423.x_11, _S423.y_6, _S422), _S423.x_11, _S423.y_6, _S422, _S423.hole_3);
}

fn scattered_0( _S424 : u32,  _S425 : YarnPoint_0,  _S426 : vec3<f32>,  _S427 : vec3<f32>) -> vec3<f32>
{
    var _S428 : vec3<f32> = vec3<f32>(0.0f);
    var _S429 : bool = !_S425.hole_2;
    var _S430 : bool;
    if(_S429)
    {
        _S430 = (_S426.z) > 0.0f;
    }
    else
    {
        _S430 = false;
    }
    var value_1 : vec3<f32>;
    if(_S430)
    {
        value_1 = _S425.albedos_1.diffuse_reflect_0 * vec3<f32>(diffuse_reflection_0(_S426, _S425.normal_4, fabrics_0[_S424].diffuse_blend_0)) + _S425.albedos_1.specular_reflect_0 * vec3<f32>(reflection_0(_S426, _S427, _S425.normal_4, _S425.tangent_4, _S425.roughness_8, fabrics_0[_S424].optical_depth_0));
    }
    else
    {
        if(_S429)
        {
            _S430 = (_S426.z) < 0.0f;
        }
        else
        {
            _S430 = false;
        }
        if(_S430)
        {
            value_1 = _S425.albedos_1.diffuse_transmit_0 * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S426), _S425.normal_4, fabrics_0[_S424].diffuse_blend_0)) + _S425.albedos_1.specular_transmit_0 * vec3<f32>(transmission_0(_S426, _S427, _S425.normal_4, _S425.tangent_4, _S425.roughness_8, fabrics_0[_S424].optical_depth_0));
        }
        else
        {
            value_1 = _S428;
        }
    }
    var _S431 : f32 = fabrics_0[_S424].sheen_strength_0;
    if((fabrics_0[_S424].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S432 : vec2<f32> = sheen_with_transmittance_0(_S426, _S427, _S431, fabrics_0[_S424].sheen_roughness_0);
    return vec3<f32>(_S432.y) * value_1 + vec3<f32>(_S432.x);
}

fn unoccluded_0( _S433 : u32,  _S434 : SearchQuality_0,  _S435 : f32,  _S436 : f32,  _S437 : f32,  _S438 : vec3<f32>,  _S439 : bool) -> bool
{
    if((_S438.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S433, _S434, vec3<f32>(_S435, _S436, _S437 + fabrics_0[_S433].lift_0), _S438, _S439, max_height_along_0(_S433, _S435, _S436, _S437, _S438, _S439));
}

fn is_lit_0( _S440 : u32,  _S441 : SearchQuality_0,  _S442 : YarnPoint_0,  _S443 : vec3<f32>) -> bool
{
    if(_S442.hole_2)
    {
        return true;
    }
    var _S444 : vec3<f32> = to_face_frame_0(_S443, _S442.back_2);
    var _S445 : f32 = _S444.z;
    var _S446 : bool = _S445 < 0.0f;
    var normal_6 : vec3<f32>;
    var height_10 : f32;
    if(_S446)
    {
        var _S447 : SurfacePoint_0 = surface_at_0(_S440, _S442.x_10, _S442.y_5, !_S442.back_2);
        normal_6 = _S447.normal_5;
        height_10 = _S447.height_9;
    }
    else
    {
        normal_6 = _S442.normal_4;
        height_10 = _S442.height_3;
    }
    var _S448 : vec3<f32> = vec3<f32>(_S444.xy, abs(_S445));
    if((dot(normal_6, _S448)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S440, _S441, _S442.x_10, _S442.y_5, height_10, _S448, (_S442.back_2) != _S446);
}

fn evaluate_0( _S449 : u32,  _S450 : SearchQuality_0,  _S451 : YarnPoint_0,  _S452 : vec3<f32>,  _S453 : vec3<f32>) -> vec3<f32>
{
    var _S454 : vec3<f32> = scattered_0(_S449, _S451, to_face_frame_0(_S452, _S451.back_2), to_face_frame_0(_S453, _S451.back_2));
    var _S455 : bool;
    if((max(_S454.x, max(_S454.y, _S454.z))) <= 0.0f)
    {
        _S455 = true;
    }
    else
    {
        _S455 = !is_lit_0(_S449, _S450, _S451, _S452);
    }
    if(_S455)
    {
        return vec3<f32>(0.0f);
    }
    return _S454;
}

fn straight_through_0( _S456 : u32,  _S457 : YarnPoint_0,  _S458 : vec3<f32>) -> f32
{
    if(!_S457.hole_2)
    {
        return 0.0f;
    }
    var _S459 : f32 = fabrics_0[_S456].sheen_strength_0;
    if((fabrics_0[_S456].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S459 * sheen_lobe_0(abs(_S458.z), fabrics_0[_S456].sheen_roughness_0).z;
}

fn light_of_point_0( _S460 : ptr<function, Frame_std430_0>,  _S461 : u32,  _S462 : VisiblePoint_0,  _S463 : vec2<f32>) -> vec4<f32>
{
    var _S464 : SearchQuality_0 = default_quality_0();
    var _S465 : vec3<f32> = to_local_0(_S462, _S462.view_0);
    var _S466 : YarnPoint_0 = locate_yarn_0(_S461, _S464, _S463.x, _S463.y, _S465);
    var _S467 : vec3<f32> = vec3<f32>(0.0f);
    var number_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S467;
    for(;;)
    {
        if(number_1 < ((*_S460).lights_0))
        {
        }
        else
        {
            break;
        }
        var _S468 : Light_std430_0 = lights_1[number_1];
        var irradiance_2 : vec3<f32>;
        var _S469 : vec3<f32> = towards_light_0(&(_S468), _S462.position_0, &(irradiance_2));
        var radiance_2 : vec3<f32> = radiance_1 + irradiance_2 * evaluate_0(_S461, _S464, _S466, to_local_0(_S462, _S469), _S465);
        number_1 = number_1 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S461, _S466, _S465));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S470 : u32;
    var _S471 : Frame_std430_0 = frames_0[i32(0)];
    var _S472 : bool;
    if((id_0.x) >= (_S471.width_0))
    {
        _S472 = true;
    }
    else
    {
        _S472 = (id_0.y) >= (_S471.height_0);
    }
    if(_S472)
    {
        return;
    }
    var _S473 : vec2<u32> = id_0.xy;
    var _S474 : vec3<i32> = vec3<i32>(vec2<i32>(_S473), i32(0));
    var _S475 : u32 = (textureLoad((visible_faces_0), ((_S474)).xy, ((_S474)).z).x);
    var _S476 : vec4<f32> = vec4<f32>(0.0f);
    var sum_0 : vec4<f32>;
    if(_S475 > u32(0))
    {
        var _S477 : u32 = _S475 - u32(1);
        var _S478 : u32 = face_fabrics_0[_S477];
        var _S479 : VisiblePoint_0 = visible_point_0(&(_S471), _S478, _S477, _S473);
        var k_0 : u32 = u32(0);
        sum_0 = _S476;
        for(;;)
        {
            var _S480 : u32 = _S471.samples_0;
            _S470 = _S471.samples_0;
            if(k_0 < (_S471.samples_0))
            {
            }
            else
            {
                break;
            }
            var _S481 : vec2<f32> = footprint_sample_0(_S473, _S471.pass_number_0 * _S480 + k_0);
            var _S482 : vec4<f32> = light_of_point_0(&(_S471), _S478, _S479, _S479.draft_0 + vec2<f32>(_S481.x) * _S479.draft_dx_0 + vec2<f32>(_S481.y) * _S479.draft_dy_0);
            var sum_1 : vec4<f32> = sum_0 + _S482;
            k_0 = k_0 + u32(1);
            sum_0 = sum_1;
        }
        sum_0 = sum_0 / vec4<f32>(f32(_S470));
    }
    else
    {
        sum_0 = _S476;
    }
    accumulate_0(&(_S471), _S473, sum_0);
    return;
}

