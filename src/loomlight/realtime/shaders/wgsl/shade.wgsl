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

@binding(3) @group(0) var<storage, read> frames_0 : array<Frame_std430_0>;

@binding(9) @group(0) var visible_faces_0 : texture_2d<u32>;

@binding(6) @group(0) var<storage, read> face_fabrics_0 : array<u32>;

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
};

struct Fabric_std430_0
{
    @align(4) warp_0 : Family_std430_0,
    @align(4) weft_0 : Family_std430_0,
    @align(4) run_words_0 : u32,
    @align(4) ends_0 : u32,
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

@binding(5) @group(0) var<storage, read> corners_0 : array<u32>;

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

@binding(4) @group(0) var<storage, read> vertices_0 : array<Vertex_std430_0>;

@binding(1) @group(0) var<storage, read> words_0 : array<u32>;

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

@binding(2) @group(0) var<storage, read> lights_1 : array<Light_std430_0>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

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

struct StepControl_0
{
     step_0 : f32,
     epsilon_0 : f32,
     per_x_0 : f32,
     per_y_0 : f32,
     right_0 : bool,
     up_0 : bool,
};

fn step_control_0( direction_2 : vec2<f32>,  step_1 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_0 = step_1;
    control_0.epsilon_0 = 0.00499999988824129f * step_1;
    var _S7 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S7), 9.99999971718068537e-10f);
    var _S8 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S8), 9.99999971718068537e-10f);
    control_0.right_0 = _S7 > 0.0f;
    control_0.up_0 = _S8 > 0.0f;
    return control_0;
}

fn turns_and_remainder_0( family_0 : ptr<function, Family_std430_0>,  index_1 : f32) -> vec2<f32>
{
    var _S9 : f32 = floor(fma(index_1, (*family_0).inverse_count_0, (*family_0).half_inverse_count_0));
    return vec2<f32>(_S9, fma(- _S9, (*family_0).count_0, index_1));
}

struct Cell_0
{
     thread_1 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : ptr<function, Family_std430_0>,  position_1 : f32) -> Cell_0
{
    var _S10 : f32 = floor(position_1 * (*family_1).inverse_size_0);
    var cell_1 : Cell_0;
    var _S11 : f32 = fma(- _S10, (*family_1).size_0, position_1);
    cell_1.below_0 = _S11;
    cell_1.above_0 = (*family_1).size_0 - _S11;
    cell_1.across_0 = _S11 - 0.5f * (*family_1).size_0;
    cell_1.half_width_1 = (*family_1).half_width_0;
    var _S12 : vec2<f32> = turns_and_remainder_0(&((*family_1)), _S10);
    cell_1.thread_1 = u32(clamp(_S12.y, 0.0f, (*family_1).count_0 - 1.0f));
    return cell_1;
}

fn table_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_2])));
}

fn locate_varied_0( family_2 : ptr<function, Family_std430_0>,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - (*family_2).start_0) * (*family_2).inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S13 : f32 = turns_1 * (*family_2).period_0;
    var thread_2 : u32 = words_0[(*family_2).first_thread_table_0 + u32(clamp(turns_1 * (*family_2).bins_0, 0.0f, (*family_2).bins_0 - 1.0f))];
    var _S14 : u32 = (*family_2).place_table_0;
    var _S15 : u32;
    if(_S13 >= (table_number_0((*family_2).place_table_0 + thread_2 * u32(4) + u32(1))))
    {
        _S15 = u32(1);
    }
    else
    {
        _S15 = u32(0);
    }
    var _S16 : u32 = min(thread_2 + _S15, u32((*family_2).count_0) - u32(1));
    var _S17 : u32 = _S14 + _S16 * u32(4);
    var cell_2 : Cell_0;
    cell_2.thread_1 = _S16;
    cell_2.below_0 = _S13 - table_number_0(_S17);
    cell_2.above_0 = table_number_0(_S17 + u32(1)) - _S13;
    cell_2.across_0 = _S13 - table_number_0(_S17 + u32(2));
    cell_2.half_width_1 = table_number_0(_S17 + u32(3));
    return cell_2;
}

fn locate_0( family_3 : ptr<function, Family_std430_0>,  position_3 : f32) -> Cell_0
{
    if(((*family_3).is_alike_0) != u32(0))
    {
        var _S18 : Cell_0 = locate_alike_0(&((*family_3)), position_3);
        return _S18;
    }
    var _S19 : Cell_0 = locate_varied_0(&((*family_3)), position_3);
    return _S19;
}

fn locate_1( family_4 : ptr<function, Family_std430_0>,  position_4 : f32) -> Cell_0
{
    if(((*family_4).is_alike_0) != u32(0))
    {
        var _S20 : Cell_0 = locate_alike_0(&((*family_4)), position_4);
        return _S20;
    }
    var _S21 : Cell_0 = locate_varied_0(&((*family_4)), position_4);
    return _S21;
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_0 : vec2<f32>,
};

fn ViewRay_at_0( this_0 : ViewRay_0,  height_1 : f32) -> vec2<f32>
{
    return this_0.origin_0 + this_0.slope_0 * vec2<f32>(height_1);
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_0 : f32,  side_y_0 : f32) -> f32
{
    return max(min(side_x_0 * this_1.per_x_0, side_y_0 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
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
    var _S22 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S23 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S24 : bool;
    if(_S22)
    {
        if(!_S23)
        {
            _S24 = true;
        }
        else
        {
            _S24 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S24 = false;
    }
    shown_0.is_warp_0 = _S24;
    if(!_S22)
    {
        _S24 = !_S23;
    }
    else
    {
        _S24 = false;
    }
    shown_0.hole_0 = _S24;
    var _S25 : u32;
    if(shown_0.is_warp_0)
    {
        _S25 = crossing_0.warp_word_0;
    }
    else
    {
        _S25 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S25;
    shown_0.on_top_0 = (((_S25 & (u32(1)))) == u32(1)) != back_1;
    return shown_0;
}

fn boundary_0( family_5 : ptr<function, Family_std430_0>,  thread_3 : u32,  step_2 : i32) -> f32
{
    var _S26 : vec2<f32> = turns_and_remainder_0(&((*family_5)), f32(i32(thread_3) + step_2));
    return fma(_S26.x, (*family_5).period_0, table_number_0((*family_5).place_table_0 + u32(_S26.y) * u32(4)));
}

fn span_0( family_6 : ptr<function, Family_std430_0>,  thread_4 : u32,  first_0 : i32,  last_0 : i32) -> f32
{
    if(((*family_6).is_alike_0) != u32(0))
    {
        return f32(last_0 - first_0) * (*family_6).size_0;
    }
    var _S27 : f32 = boundary_0(&((*family_6)), thread_4, last_0);
    var _S28 : f32 = boundary_0(&((*family_6)), thread_4, first_0);
    return _S27 - _S28;
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_7 : ptr<function, Family_std430_0>,  thread_5 : u32) -> Bend_0
{
    var _S29 : u32 = (*family_7).bend_table_0;
    var _S30 : u32;
    if(((*family_7).is_alike_0) != u32(0))
    {
        _S30 = u32(0);
    }
    else
    {
        _S30 = thread_5 * u32(4);
    }
    var _S31 : u32 = _S29 + _S30;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S31);
    bend_0.half_tangent_0 = table_number_0(_S31 + u32(1));
    bend_0.arc_0 = table_number_0(_S31 + u32(2));
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

fn unpack_0( own_0 : ptr<function, Family_std430_0>,  other_0 : ptr<function, Family_std430_0>,  thread_6 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S32 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S33 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S34 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S35 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S36 : i32 = - _S32;
    var _S37 : f32 = span_0(&((*other_0)), crossed_0.thread_1, _S36, i32(0));
    var _S38 : f32 = crossed_0.below_0 + _S37;
    run_0.from_start_0 = _S38;
    var _S39 : i32 = _S33 + i32(1);
    var _S40 : f32 = span_0(&((*other_0)), crossed_0.thread_1, i32(1), _S39);
    var _S41 : f32 = crossed_0.above_0 + _S40;
    run_0.to_end_0 = _S41;
    var _S42 : bool = _S38 < _S41;
    run_0.near_start_0 = _S42;
    var _S43 : i32;
    if(_S42)
    {
        _S43 = _S36 - _S34;
    }
    else
    {
        _S43 = _S39;
    }
    var _S44 : i32;
    if(run_0.near_start_0)
    {
        _S44 = _S36;
    }
    else
    {
        _S44 = _S39 + _S35;
    }
    var _S45 : Bend_0 = bend_of_0(&((*own_0)), thread_6);
    run_0.bend_1 = _S45;
    var _S46 : f32;
    if(run_0.straight_0)
    {
        _S46 = 1.0e+06f;
    }
    else
    {
        _S46 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S46;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    var _S47 : f32 = span_0(&((*other_0)), crossed_0.thread_1, _S43, _S44);
    run_0.other_reach_0 = min(0.5f * _S47, run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S32 == i32(0);
    run_0.last_crossing_0 = _S33 == i32(0);
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
     slope_1 : f32,
};

fn section_at_0( cell_3 : Cell_0) -> Section_0
{
    var _S48 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S49 : f32 = clamp(cell_3.across_0, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_1 = _S49;
    var _S50 : f32 = _S48 * _S48 - square_1(_S49);
    var _S51 : f32 = rsqrt_0(_S50);
    section_0.drop_0 = _S48 - _S50 * _S51;
    section_0.slope_1 = - _S49 * _S51;
    return section_0;
}

fn edge_drop_0( family_8 : ptr<function, Family_std430_0>,  thread_7 : u32,  step_3 : i32) -> f32
{
    if(((*family_8).is_alike_0) != u32(0))
    {
        return table_number_0((*family_8).bend_table_0 + u32(3));
    }
    var _S52 : u32 = (*family_8).bend_table_0;
    var _S53 : vec2<f32> = turns_and_remainder_0(&((*family_8)), f32(i32(thread_7) + step_3));
    return table_number_0(_S52 + u32(_S53.y) * u32(4) + u32(3));
}

fn dive_0( other_1 : ptr<function, Family_std430_0>,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S54 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S55 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S56 : f32;
    if(_S54)
    {
        _S56 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S56 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S57 : f32 = _S56 - crossed_1.half_width_1;
    var _S58 : bool;
    if(_S54)
    {
        _S58 = run_1.first_crossing_0;
    }
    else
    {
        _S58 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S56 = 0.0f;
    }
    else
    {
        var _S59 : f32 = (*other_1).height_scale_0;
        var _S60 : f32 = edge_drop_0(&((*other_1)), crossed_1.thread_1, i32(0));
        _S56 = _S59 * _S60;
    }
    var _S61 : f32;
    if((shown_1.on_top_0) != _S58)
    {
        _S61 = 0.0f;
    }
    else
    {
        var _S62 : f32 = (*other_1).height_scale_0;
        var _S63 : i32;
        if(_S54)
        {
            _S63 = i32(-1);
        }
        else
        {
            _S63 = i32(1);
        }
        var _S64 : f32 = edge_drop_0(&((*other_1)), crossed_1.thread_1, _S63);
        _S61 = _S62 * _S64;
    }
    var _S65 : f32 = 1.0f / max(2.0f * _S57, 9.999999960041972e-13f);
    var _S66 : f32 = clamp((_S57 - _S55) * _S65, 0.0f, 1.0f);
    var _S67 : f32 = _S56 + (_S61 - _S56) * (_S66 * _S66 * (3.0f - 2.0f * _S66));
    var _S68 : f32 = (_S56 - _S61) * (6.0f * _S66 * (1.0f - _S66) * _S65);
    if(_S54)
    {
        _S56 = 1.0f;
    }
    else
    {
        _S56 = -1.0f;
    }
    return vec2<f32>(_S67, _S68 * _S56);
}

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_2 : Shown_0,
     run_2 : Run_0,
     section_1 : Section_0,
     height_2 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_0 : f32,
     slope_y_0 : f32,
};

fn shape_0( own_1 : ptr<function, Family_std430_0>,  other_2 : ptr<function, Family_std430_0>,  own_cell_0 : Cell_0,  crossed_2 : Cell_0,  sample_0 : ptr<function, Sample_0>)
{
    var _S69 : Shown_0 = (*sample_0).shown_2;
    var _S70 : Run_0 = unpack_0(&((*own_1)), &((*other_2)), own_cell_0.thread_1, crossed_2, (*sample_0).shown_2.word_0);
    var _S71 : Section_0 = section_at_0(own_cell_0);
    var _S72 : bool;
    if(_S69.on_top_0)
    {
        _S72 = (_S70.distance_0) < (_S71.drop_0 * _S70.bend_1.sine_0);
    }
    else
    {
        _S72 = false;
    }
    var _S73 : bool;
    if(_S69.on_top_0)
    {
        _S73 = !_S72;
    }
    else
    {
        _S73 = false;
    }
    var _S74 : f32;
    if(_S73)
    {
        _S74 = 1.0f;
    }
    else
    {
        _S74 = -1.0f;
    }
    var _S75 : f32;
    if(_S72)
    {
        _S75 = _S70.other_reach_0;
    }
    else
    {
        _S75 = _S70.reach_0;
    }
    var _S76 : f32;
    if(_S72)
    {
        _S76 = _S75 + _S70.distance_0;
    }
    else
    {
        _S76 = max(_S75 - _S70.distance_0, 0.0f);
    }
    var _S77 : f32 = _S75 / _S70.bend_1.sine_0 - _S74 * _S71.drop_0;
    var _S78 : f32 = _S76 * _S76;
    var _S79 : f32 = max(_S77 * _S77 - _S78, 9.99999968265522539e-21f);
    var _S80 : f32 = rsqrt_0(_S79);
    var _S81 : f32 = _S78 / (_S79 * _S80 + _S77);
    var _S82 : bool = _S76 > 0.0f;
    var _S83 : f32;
    if(_S69.on_top_0)
    {
        _S83 = 1.0f;
    }
    else
    {
        _S83 = -1.0f;
    }
    var _S84 : f32;
    if(_S70.near_start_0)
    {
        _S84 = 1.0f;
    }
    else
    {
        _S84 = -1.0f;
    }
    var _S85 : f32 = _S83 * _S84;
    if(_S82)
    {
        _S83 = _S77 * _S80;
    }
    else
    {
        _S83 = 1.0f;
    }
    (*sample_0).slope_across_0 = _S71.slope_1 * _S83;
    if(_S82)
    {
        _S76 = _S85 * _S76 * _S80;
    }
    else
    {
        _S76 = 0.0f;
    }
    (*sample_0).slope_along_0 = _S76;
    var _S86 : f32 = (*own_1).height_scale_0;
    var _S87 : vec2<f32> = dive_0(&((*other_2)), _S69, _S70, crossed_2);
    if(_S70.straight_0)
    {
        _S74 = 0.0f;
    }
    else
    {
        _S74 = _S86 * _S74;
    }
    (*sample_0).height_2 = _S74 * (_S75 * _S70.bend_1.half_tangent_0 - _S81) - _S86 * _S71.drop_0 - _S87.x;
    var _S88 : f32 = _S86 * (*sample_0).slope_across_0;
    var _S89 : f32 = _S86 * (*sample_0).slope_along_0 - _S87.y;
    if(_S69.is_warp_0)
    {
        _S74 = _S88;
    }
    else
    {
        _S74 = _S89;
    }
    (*sample_0).slope_x_0 = _S74;
    if(_S69.is_warp_0)
    {
        _S74 = _S89;
    }
    else
    {
        _S74 = _S88;
    }
    (*sample_0).slope_y_0 = _S74;
    (*sample_0).run_2 = _S70;
    (*sample_0).section_1 = _S71;
    return;
}

fn outline_distance_0( cell_4 : Cell_0,  shown_3 : Shown_0,  run_3 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S90 : f32;
    if(forwards_0)
    {
        _S90 = cell_4.across_0;
    }
    else
    {
        _S90 = - cell_4.across_0;
    }
    var _S91 : f32;
    if(forwards_0)
    {
        _S91 = cell_4.above_0;
    }
    else
    {
        _S91 = cell_4.below_0;
    }
    var _S92 : bool;
    if(forwards_0)
    {
        _S92 = run_3.last_crossing_0;
    }
    else
    {
        _S92 = run_3.first_crossing_0;
    }
    var _S93 : bool;
    if(forwards_0)
    {
        _S93 = run_3.first_crossing_0;
    }
    else
    {
        _S93 = run_3.last_crossing_0;
    }
    var _S94 : f32 = - cell_4.half_width_1;
    var _S95 : bool = _S90 < _S94;
    var _S96 : bool = _S90 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S92 = !_S92;
    }
    else
    {
        _S92 = false;
    }
    if(_S92)
    {
        _S92 = !shown_3.hole_0;
    }
    else
    {
        _S92 = false;
    }
    var _S97 : bool;
    if(_S92)
    {
        _S97 = shown_3.on_top_0;
    }
    else
    {
        _S97 = false;
    }
    if(_S97)
    {
        if(_S93)
        {
            _S93 = _S95;
        }
        else
        {
            _S93 = false;
        }
        _S93 = !_S93;
    }
    else
    {
        _S93 = false;
    }
    if(shown_3.hole_0)
    {
        _S92 = true;
    }
    else
    {
        if(_S92)
        {
            _S92 = !shown_3.on_top_0;
        }
        else
        {
            _S92 = false;
        }
    }
    var _S98 : f32;
    if(_S95)
    {
        _S98 = _S94;
    }
    else
    {
        _S98 = cell_4.half_width_1;
    }
    var _S99 : f32 = _S98 - _S90;
    if(_S92)
    {
        _S90 = 2.0f * _S91 + _S90 - cell_4.half_width_1;
    }
    else
    {
        _S90 = _S91;
    }
    if(_S93)
    {
        if(forwards_0)
        {
            _S90 = run_3.to_end_0;
        }
        else
        {
            _S90 = run_3.from_start_0;
        }
        return _S90;
    }
    if(_S96)
    {
    }
    else
    {
        _S90 = _S99;
    }
    return _S90;
}

struct Probe_0
{
     height_3 : f32,
     hole_1 : bool,
     slope_x_1 : f32,
     slope_y_1 : f32,
     yarn_1 : u32,
     cell_max_0 : f32,
     side_x_1 : f32,
     side_y_1 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn ViewRay_rate_0( this_2 : ViewRay_0,  here_0 : Probe_0) -> f32
{
    return here_0.slope_x_1 * this_2.slope_0.x + here_0.slope_y_1 * this_2.slope_0.y - 1.0f;
}

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_1 : Probe_0) -> f32
{
    var _S100 : f32 = previous_1.rate_0 * step_4;
    var _S101 : f32 = rate_1 * step_4;
    var _S102 : bool;
    if(!previous_1.known_0)
    {
        _S102 = true;
    }
    else
    {
        _S102 = here_1.hole_1;
    }
    if(_S102)
    {
        _S102 = true;
    }
    else
    {
        _S102 = (previous_1.yarn_0) != (here_1.yarn_1);
    }
    if(_S102)
    {
        _S102 = true;
    }
    else
    {
        _S102 = (previous_1.rate_0) >= 0.0f;
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
    if((3.0f * previous_1.clearance_0 + _S100) >= 0.0f)
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
    var _S103 : f32 = clearance_1 - previous_1.clearance_0;
    var _S104 : f32 = 6.0f * _S103 - 4.0f * _S100 - 2.0f * _S101;
    var _S105 : f32 = -2.0f * _S100 / max(_S104 + sqrt(max(_S104 * _S104 - 4.0f * (3.0f * (_S100 + _S101 - 2.0f * _S103)) * _S100, 0.0f)), 9.99999968265522539e-21f);
    var _S106 : f32 = 1.0f - _S105;
    var _S107 : f32 = (previous_1.clearance_0 * (2.0f * _S105 + 1.0f) + _S100 * _S105) * _S106 * _S106;
    var _S108 : f32 = (clearance_1 * (2.0f * _S106 + 1.0f) - _S101 * _S106) * _S105 * _S105;
    if(_S105 > 0.01999999955296516f)
    {
        _S102 = _S106 > 0.01999999955296516f;
    }
    else
    {
        _S102 = false;
    }
    if(_S102)
    {
        _S102 = (_S107 + _S108) < 0.0f;
    }
    else
    {
        _S102 = false;
    }
    var _S109 : f32;
    if(_S102)
    {
        _S109 = _S106 * step_4;
    }
    else
    {
        _S109 = -1.0f;
    }
    return _S109;
}

fn StepControl_to_next_sample_0( this_3 : StepControl_0,  here_2 : Probe_0,  clearance_2 : f32,  rate_2 : f32) -> f32
{
    var _S110 : f32 = min(here_2.edge_x_0 * this_3.per_x_0, here_2.edge_y_0 * this_3.per_y_0);
    var _S111 : bool;
    if(!here_2.hole_1)
    {
        _S111 = (rate_2 * _S110 + clearance_2) < 0.0f;
    }
    else
    {
        _S111 = false;
    }
    if(_S111)
    {
        _S111 = _S110 > (2.0f * this_3.epsilon_0);
    }
    else
    {
        _S111 = false;
    }
    var _S112 : f32;
    if(_S111)
    {
        _S112 = _S110 - this_3.epsilon_0;
    }
    else
    {
        _S112 = max(_S110, 0.0f) + this_3.epsilon_0;
    }
    return min(this_3.step_0, _S112);
}

fn after_sample_0( clearance_3 : f32,  rate_3 : f32,  here_3 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S113 : f32;
    if(here_3.hole_1)
    {
        _S113 = 1.0e+09f;
    }
    else
    {
        _S113 = clearance_3;
    }
    previous_2.clearance_0 = _S113;
    previous_2.rate_0 = rate_3;
    previous_2.yarn_0 = here_3.yarn_1;
    var _S114 : bool;
    if(!here_3.hole_1)
    {
        _S114 = !is_cell_exit_0;
    }
    else
    {
        _S114 = false;
    }
    previous_2.known_0 = _S114;
    return previous_2;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S115 : f32 = end_0 - start_1;
    var _S116 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S115;
    var _S117 : f32 = 3.0f * _S115 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S115, 9.99999968265522539e-21f);
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
        var _S118 : f32 = clamp(share_0 - (((_S116 * share_0 + _S117) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S116 * share_0 + 2.0f * _S117) * share_0 + start_rate_0, 0.10000000149011612f * _S115 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S119 : i32 = i_0 + i32(1);
        share_0 = _S118;
        i_0 = _S119;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S120 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S121 : f32 = rsqrt_0(_S120);
    var _S122 : f32 = sine_1 * _S121 * rsqrt_0(_S120 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S122 * _S120, _S122 * across_slope_0 * along_slope_0 + cosine_0 * _S121);
}

fn arc_sine_0( x_4 : f32) -> f32
{
    var _S123 : f32 = abs(x_4);
    var _S124 : bool = _S123 > 0.5f;
    var _S125 : f32;
    if(_S124)
    {
        _S125 = 0.5f * (1.0f - _S123);
    }
    else
    {
        _S125 = _S123 * _S123;
    }
    var _S126 : f32;
    if(_S124)
    {
        _S126 = sqrt(max(_S125, 0.0f));
    }
    else
    {
        _S126 = _S123;
    }
    var _S127 : f32 = ((((0.04216320067644119f * _S125 + 0.02418131195008755f) * _S125 + 0.04547002539038658f) * _S125 + 0.07495300471782684f) * _S125 + 0.16666752099990845f) * _S125 * _S126 + _S126;
    if(_S124)
    {
        _S125 = 1.57079637050628662f - 2.0f * _S127;
    }
    else
    {
        _S125 = _S127;
    }
    if(x_4 < 0.0f)
    {
        _S125 = - _S125;
    }
    return _S125;
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

fn albedos_of_0( family_9 : ptr<function, Family_std430_0>,  thread_8 : u32) -> Albedos_0
{
    var _S128 : u32 = (*family_9).albedo_table_0 + (*family_9).albedo_stride_0 * thread_8;
    var albedos_0 : Albedos_0;
    albedos_0.diffuse_reflect_0 = table_colour_0(_S128);
    albedos_0.diffuse_transmit_0 = table_colour_0(_S128 + u32(3));
    albedos_0.specular_reflect_0 = table_colour_0(_S128 + u32(6));
    albedos_0.specular_transmit_0 = table_colour_0(_S128 + u32(9));
    return albedos_0;
}

fn thread_gain_0( thread_9 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_0 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S129 : vec3<f32> = room_0 / max(albedo_0, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S129.x, _S129.y), _S129.z), 0.0f));
}

fn natural_logarithm_0( x_5 : f32) -> f32
{
    var _S130 : u32 = (bitcast<u32>((x_5)));
    var exponent_0 : f32 = f32(i32((_S130 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S130 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S131 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S131 - exponent_1 * 0.00021219444170129f - 0.5f * _S131) + exponent_1 * 0.693359375f;
}

fn fibre_gain_0( thread_10 : u32,  cell_5 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_5, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn towards_light_0( light_0 : ptr<function, Light_std430_0>,  position_5 : vec3<f32>,  irradiance_0 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    (*irradiance_0) = vec3<f32>((*light_0).red_0, (*light_0).green_0, (*light_0).blue_0);
    var _S132 : vec3<f32> = vec3<f32>((*light_0).x_1, (*light_0).y_1, (*light_0).z_1);
    if(((*light_0).is_point_0) == u32(0))
    {
        return _S132;
    }
    var _S133 : vec3<f32> = _S132 - position_5;
    (*irradiance_0) = (*irradiance_0) / vec3<f32>(max(square_0(_S133), 9.999999960041972e-13f));
    return normalize(_S133);
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_1 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S134 : f32 = light_1.z;
    if(_S134 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S134, 0.0f), max(dot(light_1, normal_1), 0.0f), blend_0);
}

fn projected_area_0( direction_3 : vec3<f32>,  tangent_0 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S135 : f32 = dot(direction_3, tangent_0);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S135 * _S135 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_6 : f32) -> f32
{
    var _S136 : f32 = clamp(x_6, -87.0f, 88.0f);
    var _S137 : f32 = floor(_S136 * 1.4426950216293335f + 0.5f);
    var _S138 : f32 = _S136 - _S137 * 0.693359375f + _S137 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S138 + 0.00139819993637502f) * _S138 + 0.00833345204591751f) * _S138 + 0.04166579619050026f) * _S138 + 0.1666666567325592f) * _S138 + 0.5f;
    var _S139 : f32 = (bitcast<f32>(((u32(i32(_S137) + i32(127)) << (u32(23))))));
    var _S140 : f32;
    if(x_6 < -87.0f)
    {
        _S140 = 0.0f;
    }
    else
    {
        _S140 = (p_0 * _S138 * _S138 + _S138 + 1.0f) * _S139;
    }
    return _S140;
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
    var _S141 : f32 = roughness_2 * roughness_2;
    var _S142 : f32 = squared_along_0 * (1.0f - _S141) + _S141;
    return 0.31830987334251404f * _S141 * roughness_2 / (_S142 * _S142);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_1 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S143 : vec3<f32> = light_2 + view_1;
    var _S144 : f32 = dot(_S143, tangent_1);
    return flake_density_0(min(_S144 * _S144 / max(square_0(_S143), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_2 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S145 : f32 = dot(light_3, normal_2);
    var _S146 : bool;
    if(_S145 <= 0.0f)
    {
        _S146 = true;
    }
    else
    {
        _S146 = (dot(view_2, normal_2)) <= 0.0f;
    }
    if(_S146)
    {
        return 0.0f;
    }
    var _S147 : f32 = max(_S145, 9.99999997475242708e-07f);
    var _S148 : f32 = max(dot(view_2, normal_2), 9.99999997475242708e-07f);
    var _S149 : f32 = projected_area_0(light_3, tangent_2, roughness_4) * _S148 + projected_area_0(view_2, tangent_2, roughness_4) * _S147;
    var _S150 : f32 = optical_depth_1 * _S149 / (_S147 * _S148);
    return 0.25f * density_between_0(light_3, view_2, tangent_2, roughness_4) * (_S150 * mean_attenuation_0(_S150)) * _S147 / _S149;
}

fn transmission_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_3 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S151 : f32 = - dot(light_4, normal_3);
    var _S152 : f32 = dot(view_3, normal_3);
    var _S153 : bool;
    if(_S151 <= 0.0f)
    {
        _S153 = true;
    }
    else
    {
        _S153 = _S152 <= 0.0f;
    }
    if(_S153)
    {
        return 0.0f;
    }
    var _S154 : f32 = 1.0f / max(_S152, 9.99999997475242708e-07f);
    var _S155 : f32 = projected_area_0(light_4, tangent_3, roughness_5) / max(_S151, 9.99999997475242708e-07f);
    var _S156 : f32 = projected_area_0(view_3, tangent_3, roughness_5) * _S154;
    return density_between_0(light_4, view_3, tangent_3, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S155, _S156)) * mean_attenuation_0(optical_depth_2 * abs(_S155 - _S156)) * _S154;
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
    var _S157 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S158 : f32 = 2.0f * sqrt(_S157) - 1.0f;
    var _S159 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S158, _S159), 0.00999999977648258f, 1.0f), clamp((1.0f - _S157) * sheen_shear_0(_S158, _S159), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S158, _S159), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S160 : f32 = light_5.z;
    var _S161 : bool;
    if(_S160 <= 0.0f)
    {
        _S161 = true;
    }
    else
    {
        _S161 = (view_4.z) <= 0.0f;
    }
    if(_S161)
    {
        return 0.0f;
    }
    var _S162 : vec2<f32> = view_4.xy;
    var _S163 : f32 = dot(_S162, _S162);
    var _S164 : vec2<f32>;
    if(_S163 > 9.99999968265522539e-21f)
    {
        _S164 = _S162 * vec2<f32>(rsqrt_0(_S163));
    }
    else
    {
        _S164 = vec2<f32>(1.0f, 0.0f);
    }
    var _S165 : f32 = scale_0 * dot(light_5.xy, _S164) + shear_0 * _S160;
    var _S166 : f32 = scale_0 * (light_5.y * _S164.x - light_5.x * _S164.y);
    var _S167 : f32 = _S165 * _S165 + _S166 * _S166 + _S160 * _S160;
    return 0.31830987334251404f * scale_0 * scale_0 * _S160 / max(_S167 * _S167, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S168 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S169 : f32 = strength_0 * _S168.z;
    return vec2<f32>(_S169 * transformed_cosine_0(light_6, view_5, _S168.x, _S168.y), 1.0f - _S169);
}

fn visible_point_0( _S170 : ptr<function, Frame_std430_0>,  _S171 : u32,  _S172 : u32,  _S173 : vec2<u32>) -> VisiblePoint_0
{
    var _S174 : u32 = u32(3) * _S172;
    var _S175 : Vertex_std430_0 = vertices_0[corners_0[_S174]];
    var _S176 : Vertex_std430_0 = vertices_0[corners_0[_S174 + u32(1)]];
    var _S177 : Vertex_std430_0 = vertices_0[corners_0[_S174 + u32(2)]];
    var _S178 : vec3<f32> = position_of_0(&(_S176));
    var _S179 : vec3<f32> = position_of_0(&(_S175));
    var _S180 : vec3<f32> = _S178 - _S179;
    var _S181 : vec3<f32> = position_of_0(&(_S177));
    var _S182 : vec3<f32> = _S181 - _S179;
    var _S183 : vec3<f32> = cross(_S180, _S182);
    var _S184 : f32 = 1.0f / max(square_0(_S183), 1.00000000317107685e-30f);
    var _S185 : vec3<f32> = camera_right_0(&((*_S170)));
    var _S186 : f32 = f32((*_S170).width_0);
    var _S187 : vec3<f32> = _S185 * vec3<f32>((2.0f / _S186));
    var _S188 : vec3<f32> = camera_up_0(&((*_S170)));
    var _S189 : f32 = f32((*_S170).height_0);
    var _S190 : vec3<f32> = _S188 * vec3<f32>((-2.0f / _S189));
    var _S191 : f32 = f32(_S173.x) + 0.5f - 0.5f * _S186;
    var _S192 : f32 = f32(_S173.y) + 0.5f - 0.5f * _S189;
    var _S193 : vec3<f32> = camera_forward_0(&((*_S170)));
    var _S194 : vec3<f32> = _S193 + vec3<f32>(_S191) * _S187 + vec3<f32>(_S192) * _S190;
    var _S195 : f32 = dot(_S194, _S183);
    var _S196 : f32;
    if((abs(_S195)) > 1.00000000317107685e-30f)
    {
        _S196 = _S195;
    }
    else
    {
        _S196 = 1.00000000317107685e-30f;
    }
    var _S197 : f32 = 1.0f / _S196;
    var _S198 : vec3<f32> = camera_origin_0(&((*_S170)));
    var _S199 : vec3<f32> = _S179 - _S198;
    var _S200 : vec3<f32> = vec3<f32>((dot(_S199, _S183) * _S197));
    var _S201 : vec3<f32> = _S194 * _S200 - _S199;
    var _S202 : vec3<f32> = _S200 * (_S187 - _S194 * vec3<f32>((dot(_S187, _S183) * _S197)));
    var _S203 : vec3<f32> = _S200 * (_S190 - _S194 * vec3<f32>((dot(_S190, _S183) * _S197)));
    var _S204 : vec3<f32> = vec3<f32>(_S184);
    var _S205 : vec3<f32> = cross(_S182, _S183) * _S204;
    var _S206 : vec3<f32> = cross(_S183, _S180) * _S204;
    var _S207 : f32 = dot(_S201, _S205);
    var _S208 : f32 = dot(_S201, _S206);
    var _S209 : f32 = _S176.u_0 - _S175.u_0;
    var _S210 : f32 = _S176.v_0 - _S175.v_0;
    var _S211 : vec2<f32> = vec2<f32>(_S209, _S210);
    var _S212 : f32 = _S177.u_0 - _S175.u_0;
    var _S213 : f32 = _S177.v_0 - _S175.v_0;
    var _S214 : vec2<f32> = vec2<f32>(_S212, _S213);
    var _S215 : vec2<f32> = vec2<f32>(_S175.u_0, _S175.v_0) + vec2<f32>(_S207) * _S211 + vec2<f32>(_S208) * _S214;
    var _S216 : vec2<f32> = vec2<f32>(dot(_S202, _S205)) * _S211 + vec2<f32>(dot(_S202, _S206)) * _S214;
    var _S217 : vec2<f32> = vec2<f32>(dot(_S203, _S205)) * _S211 + vec2<f32>(dot(_S203, _S206)) * _S214;
    if((_S209 * _S213 - _S210 * _S212) < 0.0f)
    {
        _S196 = -1.0f;
    }
    else
    {
        _S196 = 1.0f;
    }
    var _S218 : vec3<f32> = vec3<f32>(_S196) * (vec3<f32>(_S213) * _S180 - vec3<f32>(_S210) * _S182);
    var _S219 : vec3<f32> = vec3<f32>(_S196) * (vec3<f32>(_S209) * _S182 - vec3<f32>(_S212) * _S180);
    var point_1 : VisiblePoint_0;
    var _S220 : f32 = 1.0f - _S207 - _S208;
    var _S221 : vec3<f32> = normal_of_0(&(_S175));
    var _S222 : vec3<f32> = vec3<f32>(_S220) * _S221;
    var _S223 : vec3<f32> = normal_of_0(&(_S176));
    var _S224 : vec3<f32> = _S222 + vec3<f32>(_S207) * _S223;
    var _S225 : vec3<f32> = normal_of_0(&(_S177));
    var _S226 : vec3<f32> = normalize(_S224 + vec3<f32>(_S208) * _S225);
    point_1.normal_0 = _S226;
    var _S227 : vec3<f32> = normalize(_S218 - _S226 * vec3<f32>(dot(_S226, _S218)));
    point_1.axis_x_0 = _S227;
    point_1.axis_y_0 = cross(_S226, _S227);
    point_1.position_0 = _S179 + _S201;
    point_1.view_0 = (vec3<f32>(0) - normalize(_S194));
    var _S228 : bool = (dot(cross(_S218, _S219), _S226)) < 0.0f;
    var _S229 : f32 = fabrics_0[_S171].uv_width_0;
    if(_S228)
    {
        _S196 = - fabrics_0[_S171].uv_height_0;
    }
    else
    {
        _S196 = fabrics_0[_S171].uv_height_0;
    }
    var _S230 : vec2<f32> = vec2<f32>(_S229, _S196);
    var _S231 : vec2<f32> = _S215 * _S230;
    if(_S228)
    {
        _S196 = fabrics_0[_S171].uv_height_0;
    }
    else
    {
        _S196 = 0.0f;
    }
    point_1.draft_0 = _S231 + vec2<f32>(0.0f, _S196);
    point_1.draft_dx_0 = _S216 * _S230;
    point_1.draft_dy_0 = _S217 * _S230;
    return point_1;
}

struct YarnPoint_0
{
     back_2 : bool,
     hole_2 : bool,
     x_10 : f32,
     y_5 : f32,
     height_4 : f32,
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
     height_5 : f32,
};

fn steps_per_length_0( _S232 : u32,  _S233 : vec3<f32>) -> f32
{
    return max(max(abs(_S233.x) * fabrics_0[_S232].threads_per_x_0, abs(_S233.y) * fabrics_0[_S232].threads_per_y_0) * 5.0f, abs(_S233.z) * fabrics_0[_S232].per_relief_0 * 8.0f);
}

struct ViewRayEnd_0
{
     height_6 : f32,
     last_step_0 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_3 : PreviousSample_0,
};

fn max_height_along_0( _S234 : u32,  _S235 : f32,  _S236 : f32,  _S237 : f32,  _S238 : vec3<f32>,  _S239 : bool) -> f32
{
    var _S240 : Family_std430_0 = fabrics_0[_S234].warp_0;
    var _S241 : Cell_0 = locate_1(&(_S240), _S235);
    var _S242 : u32 = _S241.thread_1 / u32(2);
    var _S243 : Family_std430_0 = fabrics_0[_S234].weft_0;
    var _S244 : Cell_0 = locate_1(&(_S243), _S236);
    var _S245 : u32 = _S244.thread_1 / u32(2);
    var _S246 : f32 = _S238.x;
    var _S247 : u32;
    if(_S246 > 0.0f)
    {
        _S247 = u32(1);
    }
    else
    {
        _S247 = u32(0);
    }
    var _S248 : f32 = _S238.y;
    var _S249 : u32;
    if(_S248 > 0.0f)
    {
        _S249 = u32(2);
    }
    else
    {
        _S249 = u32(0);
    }
    var _S250 : u32 = words_0[fabrics_0[_S234].max_heights_0 + u32(4) * (_S245 * fabrics_0[_S234].max_height_columns_0 + _S242) + (_S247 + _S249)];
    var number_0 : i32;
    if(_S239)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S251 : u32 = (_S250 >> (u32(number_0)));
    var _S252 : f32 = max(abs(_S246) * fabrics_0[_S234].threads_per_x_0, abs(_S248) * fabrics_0[_S234].threads_per_y_0) / _S238.z;
    var _S253 : f32 = fabrics_0[_S234].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S234].height_high_0;
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
        if(((max_height_0 - _S237) * _S252) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S251 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S253);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn crossing_at_0( _S254 : u32,  _S255 : f32,  _S256 : f32,  _S257 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    var _S258 : Family_std430_0 = fabrics_0[_S254].warp_0;
    var _S259 : Cell_0 = locate_0(&(_S258), _S255);
    crossing_2.warp_1 = _S259;
    var _S260 : Family_std430_0 = fabrics_0[_S254].weft_0;
    var _S261 : Cell_0 = locate_0(&(_S260), _S256);
    crossing_2.weft_1 = _S261;
    var _S262 : u32 = fabrics_0[_S254].run_words_0 + u32(2) * (crossing_2.weft_1.thread_1 * fabrics_0[_S254].ends_0 + crossing_2.warp_1.thread_1);
    var _S263 : u32 = words_0[_S262];
    crossing_2.warp_word_0 = _S263;
    crossing_2.weft_word_0 = words_0[_S262 + u32(1)];
    crossing_2.warp_above_0 = (((_S263 & (u32(1)))) == u32(1)) != _S257;
    return crossing_2;
}

fn cell_maximum_0( _S264 : u32,  _S265 : Crossing_0) -> f32
{
    if(_S265.warp_above_0)
    {
        return f32(((_S265.warp_word_0) >> (u32(28)))) * fabrics_0[_S264].warp_0.height_scale_0 * fabrics_0[_S264].warp_0.level_0;
    }
    return f32(((_S265.weft_word_0) >> (u32(28)))) * fabrics_0[_S264].weft_0.height_scale_0 * fabrics_0[_S264].weft_0.level_0;
}

fn cell_bounds_0( _S266 : u32,  _S267 : f32,  _S268 : f32,  _S269 : bool,  _S270 : bool,  _S271 : bool) -> vec3<f32>
{
    var _S272 : Crossing_0 = crossing_at_0(_S266, _S267, _S268, _S269);
    var _S273 : f32 = cell_maximum_0(_S266, _S272);
    var _S274 : f32;
    if(_S270)
    {
        _S274 = _S272.warp_1.above_0;
    }
    else
    {
        _S274 = _S272.warp_1.below_0;
    }
    var _S275 : f32;
    if(_S271)
    {
        _S275 = _S272.weft_1.above_0;
    }
    else
    {
        _S275 = _S272.weft_1.below_0;
    }
    return vec3<f32>(_S273, _S274, _S275);
}

fn first_sample_height_0( _S276 : u32,  _S277 : ViewRay_0,  _S278 : StepControl_0,  _S279 : bool) -> f32
{
    var _S280 : f32 = max_height_along_0(_S276, _S277.origin_0.x, _S277.origin_0.y, 0.0f, vec3<f32>(_S277.slope_0, 1.0f), _S279);
    var count_1 : u32 = u32(0);
    var height_7 : f32 = _S280;
    for(;;)
    {
        if(count_1 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S281 : vec2<f32> = ViewRay_at_0(_S277, height_7);
        var _S282 : vec3<f32> = cell_bounds_0(_S276, _S281.x, _S281.y, _S279, _S278.right_0, _S278.up_0);
        var _S283 : f32 = height_7 - _S282.x;
        var _S284 : f32 = StepControl_to_cell_exit_0(_S278, _S282.y, _S282.z);
        var height_8 : f32 = height_7 - clamp(_S283, 0.0f, _S284);
        if(_S283 <= _S284)
        {
            height_7 = height_8;
            break;
        }
        count_1 = count_1 + u32(1);
        height_7 = height_8;
    }
    return height_7;
}

fn sample_at_0( _S285 : u32,  _S286 : f32,  _S287 : f32,  _S288 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S289 : Crossing_0 = crossing_at_0(_S285, _S286, _S287, _S288);
    sample_1.crossing_1 = _S289;
    sample_1.shown_2 = shown_at_0(_S289, _S288);
    if(sample_1.shown_2.is_warp_0)
    {
        var _S290 : Family_std430_0 = fabrics_0[_S285].warp_0;
        var _S291 : Family_std430_0 = fabrics_0[_S285].weft_0;
        shape_0(&(_S290), &(_S291), sample_1.crossing_1.warp_1, sample_1.crossing_1.weft_1, &(sample_1));
    }
    else
    {
        var _S292 : Family_std430_0 = fabrics_0[_S285].weft_0;
        var _S293 : Family_std430_0 = fabrics_0[_S285].warp_0;
        shape_0(&(_S292), &(_S293), sample_1.crossing_1.weft_1, sample_1.crossing_1.warp_1, &(sample_1));
    }
    return sample_1;
}

fn probe_0( _S294 : u32,  _S295 : f32,  _S296 : f32,  _S297 : bool,  _S298 : bool,  _S299 : bool) -> Probe_0
{
    var _S300 : Sample_0 = sample_at_0(_S294, _S295, _S296, _S297);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S300.height_2;
    probe_1.hole_1 = _S300.shown_2.hole_0;
    probe_1.slope_x_1 = _S300.slope_x_0;
    probe_1.slope_y_1 = _S300.slope_y_0;
    var _S301 : u32;
    if(_S300.shown_2.is_warp_0)
    {
        _S301 = _S300.crossing_1.warp_1.thread_1 * u32(2) + u32(1);
    }
    else
    {
        _S301 = _S300.crossing_1.weft_1.thread_1 * u32(2);
    }
    probe_1.yarn_1 = _S301;
    probe_1.cell_max_0 = cell_maximum_0(_S294, _S300.crossing_1);
    var _S302 : f32;
    if(_S298)
    {
        _S302 = _S300.crossing_1.warp_1.above_0;
    }
    else
    {
        _S302 = _S300.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_1 = _S302;
    if(_S299)
    {
        _S302 = _S300.crossing_1.weft_1.above_0;
    }
    else
    {
        _S302 = _S300.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_1 = _S302;
    probe_1.edge_x_0 = outline_distance_0(_S300.crossing_1.warp_1, _S300.shown_2, _S300.run_2, !_S300.shown_2.is_warp_0, _S298);
    probe_1.edge_y_0 = outline_distance_0(_S300.crossing_1.weft_1, _S300.shown_2, _S300.run_2, _S300.shown_2.is_warp_0, _S299);
    return probe_1;
}

fn search_down_0( _S303 : u32,  _S304 : ViewRay_0,  _S305 : StepControl_0,  _S306 : bool) -> ViewRayEnd_0
{
    var _S307 : f32 = fabrics_0[_S303].height_low_0 - (fabrics_0[_S303].height_high_0 - fabrics_0[_S303].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_6 = first_sample_height_0(_S303, _S304, _S305, _S306);
    end_1.last_step_0 = _S305.epsilon_0;
    end_1.previous_3 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_2 : u32 = u32(0);
    for(;;)
    {
        if(count_2 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S308 : vec2<f32> = ViewRay_at_0(_S304, end_1.height_6);
        var _S309 : Probe_0 = probe_0(_S303, _S308.x, _S308.y, _S306, _S305.right_0, _S305.up_0);
        var _S310 : f32 = end_1.height_6 - _S309.height_3;
        var _S311 : f32 = ViewRay_rate_0(_S304, _S309);
        end_1.depth_1 = - _S310;
        end_1.rate_4 = _S311;
        var _S312 : bool;
        if(end_1.previous_3.known_0)
        {
            _S312 = !_S309.hole_1;
        }
        else
        {
            _S312 = false;
        }
        var _S313 : bool;
        if(_S312)
        {
            _S313 = (end_1.previous_3.yarn_0) == (_S309.yarn_1);
        }
        else
        {
            _S313 = false;
        }
        end_1.smooth_0 = _S313;
        var _S314 : bool;
        if(!_S309.hole_1)
        {
            _S314 = _S310 <= 0.0f;
        }
        else
        {
            _S314 = false;
        }
        var _S315 : bool;
        if(_S314)
        {
            _S315 = true;
        }
        else
        {
            _S315 = (end_1.height_6) <= _S307;
        }
        if(_S315)
        {
            break;
        }
        var _S316 : f32 = way_back_to_dip_0(end_1.previous_3, _S310, _S311, end_1.last_step_0, _S309);
        if(_S316 >= 0.0f)
        {
            end_1.height_6 = end_1.height_6 + _S316;
            end_1.last_step_0 = end_1.last_step_0 - _S316;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S317 : f32 = min(StepControl_to_cell_exit_0(_S305, _S309.side_x_1, _S309.side_y_1), end_1.height_6 - _S309.cell_max_0);
        var _S318 : f32 = StepControl_to_next_sample_0(_S305, _S309, _S310, _S311);
        end_1.previous_3 = after_sample_0(_S310, _S311, _S309, _S317 > _S318);
        var _S319 : f32 = max(_S317, _S318);
        end_1.last_step_0 = _S319;
        end_1.height_6 = end_1.height_6 - _S319;
        count_2 = count_2 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S320 : u32,  _S321 : ViewRay_0,  _S322 : StepControl_0,  _S323 : bool,  _S324 : ViewRayEnd_0) -> f32
{
    var _S325 : f32 = fabrics_0[_S320].height_high_0 - fabrics_0[_S320].height_low_0;
    var above_2 : f32 = _S324.height_6 + _S324.last_step_0;
    var above_gap_1 : f32 = clamp(_S324.previous_3.clearance_0, 0.0f, _S325);
    var under_gap_1 : f32 = clamp(_S324.depth_1, 0.0f, _S325);
    var _S326 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S324.previous_3.rate_0 * _S324.last_step_0, _S324.rate_4 * _S324.last_step_0);
    var middle_0 : f32;
    if(_S324.smooth_0)
    {
        middle_0 = above_2 - _S326 * _S324.last_step_0;
    }
    else
    {
        middle_0 = between_0(above_2, _S324.height_6, above_gap_1, under_gap_1);
    }
    var side_0 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S324.height_6;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S327 : vec2<f32> = ViewRay_at_0(_S321, middle_0);
        var _S328 : Probe_0 = probe_0(_S320, _S327.x, _S327.y, _S323, _S322.right_0, _S322.up_0);
        var _S329 : f32;
        if(_S328.hole_1)
        {
            _S329 = -1.0e+09f;
        }
        else
        {
            _S329 = _S328.height_3;
        }
        var _S330 : f32 = clamp(middle_0 - _S329, - _S325, _S325);
        var _S331 : f32;
        if(_S330 <= 0.0f)
        {
            if(side_0 > 0.0f)
            {
                _S331 = 0.5f * above_gap_2;
            }
            else
            {
                _S331 = above_gap_2;
            }
            var _S332 : f32 = - _S330;
            under_1 = middle_0;
            above_gap_2 = _S331;
            under_gap_2 = _S332;
            side_0 = 1.0f;
        }
        else
        {
            if(side_0 < 0.0f)
            {
                _S331 = 0.5f * under_gap_2;
            }
            else
            {
                _S331 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S330;
            under_gap_2 = _S331;
            side_0 = -1.0f;
        }
        if(_S324.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S330 / min(ViewRay_rate_0(_S321, _S328), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S324.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn is_free_0( _S333 : u32,  _S334 : vec3<f32>,  _S335 : vec3<f32>,  _S336 : bool,  _S337 : f32) -> bool
{
    var _S338 : f32 = _S335.z;
    if(_S338 <= 0.0f)
    {
        return false;
    }
    var _S339 : f32 = 1.0f / max(steps_per_length_0(_S333, _S335), 9.99999971718068537e-10f);
    var _S340 : StepControl_0 = step_control_0(_S335.xy, _S339);
    var previous_4 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_1 : f32 = 0.0f;
    for(;;)
    {
        var _S341 : bool;
        if(count_3 < u32(1024))
        {
            _S341 = (_S334.z + _S338 * distance_1) < _S337;
        }
        else
        {
            _S341 = false;
        }
        if(_S341)
        {
        }
        else
        {
            break;
        }
        var _S342 : vec3<f32> = _S334 + _S335 * vec3<f32>(distance_1);
        var _S343 : Probe_0 = probe_0(_S333, _S342.x, _S342.y, _S336, _S340.right_0, _S340.up_0);
        var _S344 : f32 = _S342.z;
        var _S345 : f32 = _S344 - _S343.height_3;
        var _S346 : f32 = _S338 - _S343.slope_x_1 * _S335.x - _S343.slope_y_1 * _S335.y;
        var _S347 : bool;
        if(!_S343.hole_1)
        {
            _S347 = _S345 < 0.0f;
        }
        else
        {
            _S347 = false;
        }
        if(_S347)
        {
            return false;
        }
        var _S348 : f32 = way_back_to_dip_0(previous_4, _S345, _S346, last_step_1, _S343);
        if(_S348 >= 0.0f)
        {
            var last_step_2 : f32 = last_step_1 - _S348;
            distance_1 = distance_1 - _S348;
            last_step_1 = last_step_2;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S349 : bool = _S344 > (_S343.cell_max_0);
        var _S350 : PreviousSample_0 = after_sample_0(_S345, _S346, _S343, _S349);
        var last_step_3 : f32;
        if(_S349)
        {
            last_step_3 = max(StepControl_to_cell_exit_0(_S340, _S343.side_x_1, _S343.side_y_1), _S339);
        }
        else
        {
            last_step_3 = StepControl_to_next_sample_0(_S340, _S343, _S345, _S346);
        }
        var distance_2 : f32 = distance_1 + last_step_3;
        previous_4 = _S350;
        distance_1 = distance_2;
        last_step_1 = last_step_3;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S351 : u32,  _S352 : f32,  _S353 : f32,  _S354 : vec3<f32>,  _S355 : bool) -> bool
{
    if(!sample_at_0(_S351, _S352, _S353, _S355).shown_2.hole_0)
    {
        return false;
    }
    var _S356 : vec3<f32> = vec3<f32>(_S352, _S353, 0.0f);
    var _S357 : f32 = fabrics_0[_S351].height_high_0;
    if(!is_free_0(_S351, _S356, _S354, _S355, fabrics_0[_S351].height_high_0))
    {
        return false;
    }
    return is_free_0(_S351, _S356, vec3<f32>(- _S354.x, - _S354.y, _S354.z), !_S355, _S357);
}

fn first_hit_0( _S358 : u32,  _S359 : f32,  _S360 : f32,  _S361 : vec3<f32>,  _S362 : bool) -> Hit_0
{
    var _S363 : f32 = max(_S361.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S359, _S360);
    var _S364 : vec2<f32> = _S361.xy / vec2<f32>(_S363);
    ray_0.slope_0 = _S364;
    var _S365 : StepControl_0 = step_control_0((vec2<f32>(0) - _S364), 1.0f / max(steps_per_length_0(_S358, _S361) / _S363, 9.99999971718068537e-10f));
    var hit_0 : Hit_0;
    var _S366 : f32 = refined_height_0(_S358, ray_0, _S365, _S362, search_down_0(_S358, ray_0, _S365, _S362));
    hit_0.height_5 = _S366;
    var _S367 : vec2<f32> = ViewRay_at_0(ray_0, _S366);
    hit_0.x_11 = _S367.x;
    hit_0.y_6 = _S367.y;
    var _S368 : bool;
    if(_S366 <= 0.0f)
    {
        _S368 = passes_through_0(_S358, _S359, _S360, _S361, _S362);
    }
    else
    {
        _S368 = false;
    }
    hit_0.hole_3 = _S368;
    return hit_0;
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_9 : f32,
     normal_5 : vec3<f32>,
     tangent_5 : vec3<f32>,
     across_2 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn surface_at_0( _S369 : u32,  _S370 : f32,  _S371 : f32,  _S372 : bool) -> SurfacePoint_0
{
    var _S373 : Sample_0 = sample_at_0(_S369, _S370, _S371, _S372);
    var _S374 : f32;
    if(_S373.shown_2.is_warp_0)
    {
        _S374 = _S373.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S374 = _S373.crossing_1.weft_1.half_width_1;
    }
    var _S375 : f32;
    if(_S373.shown_2.is_warp_0)
    {
        _S375 = fabrics_0[_S369].warp_0.twist_sine_0;
    }
    else
    {
        _S375 = fabrics_0[_S369].weft_0.twist_sine_0;
    }
    var _S376 : f32;
    if(_S372)
    {
        _S376 = -1.0f;
    }
    else
    {
        _S376 = 1.0f;
    }
    var _S377 : f32 = _S375 * _S376;
    if(_S373.shown_2.is_warp_0)
    {
        _S375 = fabrics_0[_S369].warp_0.twist_cosine_0;
    }
    else
    {
        _S375 = fabrics_0[_S369].weft_0.twist_cosine_0;
    }
    if(_S373.shown_2.is_warp_0)
    {
        _S376 = 1.0f;
    }
    else
    {
        _S376 = -1.0f;
    }
    var _S378 : vec2<f32> = fibre_direction_0(_S373.slope_across_0, _S376 * _S373.slope_along_0, _S377, _S375);
    var _S379 : f32;
    if(_S373.shown_2.is_warp_0)
    {
        _S379 = _S373.slope_x_0;
    }
    else
    {
        _S379 = _S373.slope_y_0;
    }
    var _S380 : f32;
    if(_S373.shown_2.is_warp_0)
    {
        _S380 = _S373.slope_y_0;
    }
    else
    {
        _S380 = _S373.slope_x_0;
    }
    var _S381 : f32 = _S378.x;
    var _S382 : f32 = _S378.y;
    var _S383 : f32 = _S379 * _S381 + _S376 * _S380 * _S382;
    var _S384 : f32 = _S374 * 1.0154266357421875f;
    var _S385 : f32 = _S384 * arc_sine_0(clamp(_S373.section_1.across_1 / _S384, -1.0f, 1.0f));
    if(_S373.shown_2.is_warp_0)
    {
        _S374 = _S371;
    }
    else
    {
        _S374 = - _S370;
    }
    var point_2 : SurfacePoint_0;
    point_2.hole_4 = _S373.shown_2.hole_0;
    point_2.is_warp_1 = _S373.shown_2.is_warp_0;
    point_2.warp_thread_0 = _S373.crossing_1.warp_1.thread_1;
    point_2.weft_thread_0 = _S373.crossing_1.weft_1.thread_1;
    point_2.height_9 = _S373.height_2;
    point_2.normal_5 = normalize(vec3<f32>(- _S373.slope_x_0, - _S373.slope_y_0, 1.0f));
    var _S386 : vec3<f32>;
    if(_S373.shown_2.is_warp_0)
    {
        _S386 = vec3<f32>(_S381, _S382, _S383);
    }
    else
    {
        _S386 = vec3<f32>(- _S382, _S381, _S383);
    }
    point_2.tangent_5 = normalize(_S386);
    point_2.across_2 = _S373.section_1.across_1;
    point_2.fibre_across_0 = _S385 * _S375 + _S374 * _S377;
    point_2.fibre_along_0 = _S374 * _S375 - _S385 * _S377;
    return point_2;
}

fn vary_albedos_0( _S387 : u32,  _S388 : Albedos_0,  _S389 : u32,  _S390 : u32) -> Albedos_0
{
    var _S391 : vec3<f32> = max(_S388.specular_reflect_0, _S388.specular_transmit_0);
    var _S392 : vec3<f32> = _S388.diffuse_reflect_0 + _S388.diffuse_transmit_0;
    var _S393 : vec3<f32> = vec3<f32>(fabrics_0[_S387].layer_bound_0);
    var _S394 : vec3<f32> = vec3<f32>(1.0f);
    var _S395 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S389, fabrics_0[_S387].colour_noise_0, fabrics_0[_S387].seed_0), _S392, _S394 - _S393 * _S391));
    var _S396 : f32 = bounded_gain_0(fibre_gain_0(_S389, _S390, fabrics_0[_S387].fibre_noise_0, fabrics_0[_S387].seed_0), _S391, min((_S394 - _S395 * _S392) / _S393, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S395 * _S388.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S395 * _S388.diffuse_transmit_0;
    var _S397 : vec3<f32> = vec3<f32>(_S396);
    varied_0.specular_reflect_0 = _S397 * _S388.specular_reflect_0;
    varied_0.specular_transmit_0 = _S397 * _S388.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S398 : u32,  _S399 : SurfacePoint_0,  _S400 : Albedos_0,  _S401 : f32,  _S402 : f32) -> Albedos_0
{
    var _S403 : f32;
    if(_S399.is_warp_1)
    {
        _S403 = _S401;
    }
    else
    {
        _S403 = _S402;
    }
    var _S404 : f32 = _S403 - _S399.across_2;
    if(_S399.is_warp_1)
    {
        _S403 = fabrics_0[_S398].warp_0.period_0;
    }
    else
    {
        _S403 = fabrics_0[_S398].weft_0.period_0;
    }
    var _S405 : f32;
    if(_S399.is_warp_1)
    {
        _S405 = fabrics_0[_S398].warp_0.count_0;
    }
    else
    {
        _S405 = fabrics_0[_S398].weft_0.count_0;
    }
    var _S406 : i32 = i32(_S405);
    var _S407 : u32;
    if(_S399.is_warp_1)
    {
        _S407 = _S399.warp_thread_0;
    }
    else
    {
        _S407 = _S399.weft_thread_0;
    }
    var _S408 : u32 = u32(i32(floor(_S404 / _S403)) * _S406 + i32(_S407)) * u32(2);
    if(_S399.is_warp_1)
    {
        _S407 = u32(1);
    }
    else
    {
        _S407 = u32(0);
    }
    var _S409 : f32 = floor(_S399.fibre_across_0 / fabrics_0[_S398].fibre_size_0);
    return vary_albedos_0(_S398, _S400, _S408 + _S407, u32(i32(_S409)) * u32(65536) + u32(i32(floor(_S399.fibre_along_0 / (fabrics_0[_S398].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S409))));
}

fn yarn_point_at_0( _S410 : u32,  _S411 : f32,  _S412 : f32,  _S413 : bool,  _S414 : bool) -> YarnPoint_0
{
    var _S415 : SurfacePoint_0 = surface_at_0(_S410, _S411, _S412, _S413);
    var albedos_2 : Albedos_0;
    if(_S415.is_warp_1)
    {
        var _S416 : Family_std430_0 = fabrics_0[_S410].warp_0;
        var _S417 : Albedos_0 = albedos_of_0(&(_S416), _S415.warp_thread_0);
        albedos_2 = _S417;
    }
    else
    {
        var _S418 : Family_std430_0 = fabrics_0[_S410].weft_0;
        var _S419 : Albedos_0 = albedos_of_0(&(_S418), _S415.weft_thread_0);
        albedos_2 = _S419;
    }
    var _S420 : bool;
    if((fabrics_0[_S410].fibre_noise_0) > 0.0f)
    {
        _S420 = true;
    }
    else
    {
        _S420 = (fabrics_0[_S410].colour_noise_0) > 0.0f;
    }
    if(_S420)
    {
        albedos_2 = varied_at_0(_S410, _S415, albedos_2, _S411, _S412);
    }
    var point_3 : YarnPoint_0;
    point_3.back_2 = _S413;
    point_3.hole_2 = _S414;
    point_3.x_10 = _S411;
    point_3.y_5 = _S412;
    point_3.height_4 = _S415.height_9;
    point_3.normal_4 = _S415.normal_5;
    point_3.tangent_4 = _S415.tangent_5;
    var _S421 : f32;
    if(_S415.is_warp_1)
    {
        _S421 = fabrics_0[_S410].warp_0.roughness_0;
    }
    else
    {
        _S421 = fabrics_0[_S410].weft_0.roughness_0;
    }
    point_3.roughness_8 = _S421;
    point_3.albedos_1 = albedos_2;
    return point_3;
}

fn locate_yarn_0( _S422 : u32,  _S423 : f32,  _S424 : f32,  _S425 : vec3<f32>) -> YarnPoint_0
{
    var _S426 : bool = (_S425.z) < 0.0f;
    var _S427 : Hit_0 = first_hit_0(_S422, _S423, _S424, to_face_frame_0(_S425, _S426), _S426);
    return yarn_point_at_0(_S422, _S427.x_11, _S427.y_6, _S426, _S427.hole_3);
}

fn scattered_0( _S428 : u32,  _S429 : YarnPoint_0,  _S430 : vec3<f32>,  _S431 : vec3<f32>) -> vec3<f32>
{
    var _S432 : vec3<f32> = vec3<f32>(0.0f);
    var _S433 : bool = !_S429.hole_2;
    var _S434 : bool;
    if(_S433)
    {
        _S434 = (_S430.z) > 0.0f;
    }
    else
    {
        _S434 = false;
    }
    var value_1 : vec3<f32>;
    if(_S434)
    {
        value_1 = _S429.albedos_1.diffuse_reflect_0 * vec3<f32>(diffuse_reflection_0(_S430, _S429.normal_4, fabrics_0[_S428].diffuse_blend_0)) + _S429.albedos_1.specular_reflect_0 * vec3<f32>(reflection_0(_S430, _S431, _S429.normal_4, _S429.tangent_4, _S429.roughness_8, fabrics_0[_S428].optical_depth_0));
    }
    else
    {
        if(_S433)
        {
            _S434 = (_S430.z) < 0.0f;
        }
        else
        {
            _S434 = false;
        }
        if(_S434)
        {
            value_1 = _S429.albedos_1.diffuse_transmit_0 * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S430), _S429.normal_4, fabrics_0[_S428].diffuse_blend_0)) + _S429.albedos_1.specular_transmit_0 * vec3<f32>(transmission_0(_S430, _S431, _S429.normal_4, _S429.tangent_4, _S429.roughness_8, fabrics_0[_S428].optical_depth_0));
        }
        else
        {
            value_1 = _S432;
        }
    }
    var _S435 : f32 = fabrics_0[_S428].sheen_strength_0;
    if((fabrics_0[_S428].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S436 : vec2<f32> = sheen_with_transmittance_0(_S430, _S431, _S435, fabrics_0[_S428].sheen_roughness_0);
    return vec3<f32>(_S436.y) * value_1 + vec3<f32>(_S436.x);
}

fn unoccluded_0( _S437 : u32,  _S438 : f32,  _S439 : f32,  _S440 : f32,  _S441 : vec3<f32>,  _S442 : bool) -> bool
{
    if((_S441.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S437, vec3<f32>(_S438, _S439, _S440 + fabrics_0[_S437].lift_0), _S441, _S442, max_height_along_0(_S437, _S438, _S439, _S440, _S441, _S442));
}

fn is_lit_0( _S443 : u32,  _S444 : YarnPoint_0,  _S445 : vec3<f32>) -> bool
{
    if(_S444.hole_2)
    {
        return true;
    }
    var _S446 : vec3<f32> = to_face_frame_0(_S445, _S444.back_2);
    var _S447 : f32 = _S446.z;
    var _S448 : bool = _S447 < 0.0f;
    var normal_6 : vec3<f32>;
    var height_10 : f32;
    if(_S448)
    {
        var _S449 : SurfacePoint_0 = surface_at_0(_S443, _S444.x_10, _S444.y_5, !_S444.back_2);
        normal_6 = _S449.normal_5;
        height_10 = _S449.height_9;
    }
    else
    {
        normal_6 = _S444.normal_4;
        height_10 = _S444.height_4;
    }
    var _S450 : vec3<f32> = vec3<f32>(_S446.xy, abs(_S447));
    if((dot(normal_6, _S450)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S443, _S444.x_10, _S444.y_5, height_10, _S450, (_S444.back_2) != _S448);
}

fn evaluate_0( _S451 : u32,  _S452 : YarnPoint_0,  _S453 : vec3<f32>,  _S454 : vec3<f32>) -> vec3<f32>
{
    var _S455 : vec3<f32> = scattered_0(_S451, _S452, to_face_frame_0(_S453, _S452.back_2), to_face_frame_0(_S454, _S452.back_2));
    var _S456 : bool;
    if((max(_S455.x, max(_S455.y, _S455.z))) <= 0.0f)
    {
        _S456 = true;
    }
    else
    {
        _S456 = !is_lit_0(_S451, _S452, _S453);
    }
    if(_S456)
    {
        return vec3<f32>(0.0f);
    }
    return _S455;
}

fn straight_through_0( _S457 : u32,  _S458 : YarnPoint_0,  _S459 : vec3<f32>) -> f32
{
    if(!_S458.hole_2)
    {
        return 0.0f;
    }
    var _S460 : f32 = fabrics_0[_S457].sheen_strength_0;
    if((fabrics_0[_S457].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S460 * sheen_lobe_0(abs(_S459.z), fabrics_0[_S457].sheen_roughness_0).z;
}

fn direct_light_0( _S461 : ptr<function, Frame_std430_0>,  _S462 : u32,  _S463 : VisiblePoint_0,  _S464 : vec2<f32>) -> vec4<f32>
{
    var _S465 : vec3<f32> = to_local_0(_S463, _S463.view_0);
    var _S466 : YarnPoint_0 = locate_yarn_0(_S462, _S464.x, _S464.y, _S465);
    var _S467 : vec3<f32> = vec3<f32>(0.0f);
    var number_1 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S467;
    for(;;)
    {
        if(number_1 < ((*_S461).lights_0))
        {
        }
        else
        {
            break;
        }
        var _S468 : Light_std430_0 = lights_1[number_1];
        var irradiance_1 : vec3<f32>;
        var _S469 : vec3<f32> = towards_light_0(&(_S468), _S463.position_0, &(irradiance_1));
        var radiance_2 : vec3<f32> = radiance_1 + irradiance_1 * evaluate_0(_S462, _S466, to_local_0(_S463, _S469), _S465);
        number_1 = number_1 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S462, _S466, _S465));
}

@compute
@workgroup_size(8, 8, 1)
fn shade(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S470 : u32;
    var _S471 : Frame_std430_0 = frames_0[i32(0)];
    var _S472 : u32 = _S471.width_0;
    var _S473 : bool;
    if((id_0.x) >= (_S471.width_0))
    {
        _S473 = true;
    }
    else
    {
        _S473 = (id_0.y) >= (_S471.height_0);
    }
    if(_S473)
    {
        return;
    }
    var _S474 : vec2<u32> = id_0.xy;
    var _S475 : u32 = _S474.y * _S472 + _S474.x;
    var _S476 : vec3<i32> = vec3<i32>(vec2<i32>(_S474), i32(0));
    var _S477 : u32 = (textureLoad((visible_faces_0), ((_S476)).xy, ((_S476)).z).x);
    var sum_0 : vec4<f32> = vec4<f32>(0.0f);
    if(_S477 > u32(0))
    {
        var _S478 : u32 = _S477 - u32(1);
        var _S479 : u32 = face_fabrics_0[_S478];
        var _S480 : VisiblePoint_0 = visible_point_0(&(_S471), _S479, _S478, _S474);
        var k_0 : u32 = u32(0);
        for(;;)
        {
            var _S481 : u32 = _S471.samples_0;
            _S470 = _S471.samples_0;
            if(k_0 < (_S471.samples_0))
            {
            }
            else
            {
                break;
            }
            var _S482 : vec2<f32> = footprint_sample_0(_S474, _S471.pass_number_0 * _S481 + k_0);
            var _S483 : vec4<f32> = direct_light_0(&(_S471), _S479, _S480, _S480.draft_0 + vec2<f32>(_S482.x) * _S480.draft_dx_0 + vec2<f32>(_S482.y) * _S480.draft_dy_0);
            sum_0 = sum_0 + _S483;
            k_0 = k_0 + u32(1);
        }
        sum_0 = sum_0 / vec4<f32>(f32(_S470));
    }
    var _S484 : vec3<f32> = sum_0.xyz + vec3<f32>((1.0f - sum_0.w)) * vec3<f32>(_S471.background_red_0, _S471.background_green_0, _S471.background_blue_0);
    sum_0.x = _S484.x;
    sum_0.y = _S484.y;
    sum_0.z = _S484.z;
    var _S485 : vec4<f32>;
    if((_S471.pass_number_0) == u32(0))
    {
        _S485 = sum_0;
    }
    else
    {
        _S485 = radiance_0[_S475] + sum_0;
    }
    radiance_0[_S475] = _S485;
    return;
}

