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

@binding(8) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn rsqrt_0( x_2 : f32) -> f32
{
    return 1.0f / sqrt(x_2);
}

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
var<private> POINT_OFFSETS_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(0.0f, 0.0f), vec2<f32>(-0.23010000586509705f, 0.35670000314712524f), vec2<f32>(0.36809998750686646f, -0.22939999401569366f), vec2<f32>(-0.28040000796318054f, -0.34400001168251038f), vec2<f32>(0.3465999960899353f, 0.28859999775886536f), vec2<f32>(-0.36349999904632568f, 0.0511000007390976f), vec2<f32>(0.09929999709129333f, -0.35699999332427979f), vec2<f32>(0.10710000246763229f, 0.32879999279975891f) );
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

fn towards_light_0( light_0 : ptr<function, Light_std430_0>,  position_1 : vec3<f32>,  irradiance_1 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    (*irradiance_1) = vec3<f32>((*light_0).red_0, (*light_0).green_0, (*light_0).blue_0);
    var _S1 : vec3<f32> = vec3<f32>((*light_0).x_1, (*light_0).y_1, (*light_0).z_1);
    if(((*light_0).is_point_0) == u32(0))
    {
        return _S1;
    }
    var _S2 : vec3<f32> = _S1 - position_1;
    (*irradiance_1) = (*irradiance_1) / vec3<f32>(max(square_0(_S2), 9.999999960041972e-13f));
    return normalize(_S2);
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S3 : vec2<f32> = this_0.dx_0;
    var _S4 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S3, _S3) + dot(_S4, _S4)));
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S5 : u32 = (bitcast<u32>((x_3)));
    var exponent_0 : f32 = f32(i32((_S5 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S5 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S6 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S6 - exponent_1 * 0.00021219444170129f - 0.5f * _S6) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_0 : bool) -> vec3<f32>
{
    var _S7 : vec2<f32> = direction_1.xy;
    var _S8 : f32;
    if(back_0)
    {
        _S8 = - direction_1.z;
    }
    else
    {
        _S8 = direction_1.z;
    }
    return vec3<f32>(_S7, _S8);
}

struct SurfacePoint_0
{
     hole_0 : bool,
     is_warp_0 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_1 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_0 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_2 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32) -> SurfacePoint_0
{
    var _S9 : SurfacePoint_0;
    _S9.hole_0 = hole_1;
    _S9.is_warp_0 = is_warp_1;
    _S9.warp_thread_0 = warp_thread_1;
    _S9.weft_thread_0 = weft_thread_1;
    _S9.height_1 = height_2;
    _S9.normal_1 = normal_2;
    _S9.tangent_0 = tangent_1;
    _S9.across_0 = across_1;
    _S9.fibre_across_0 = fibre_across_1;
    _S9.fibre_along_0 = fibre_along_1;
    return _S9;
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
    var _S10 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S11 : f32 = mix(2.5f, 5.0f, _S10);
    quality_0.steps_per_thread_0 = _S11;
    quality_0.steps_per_relief_0 = _S11;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S10);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S10) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_0 : f32) -> vec2<f32>
{
    var _S12 : f32 = floor(fma(index_0, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S12, fma(- _S12, families_0[family_0].count_0, index_0));
}

struct Cell_0
{
     thread_0 : u32,
     across_2 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_2 : f32) -> Cell_0
{
    var _S13 : f32 = floor(position_2 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S14 : f32 = fma(- _S13, families_0[family_1].size_0, position_2);
    cell_0.below_0 = _S14;
    cell_0.above_0 = families_0[family_1].size_0 - _S14;
    cell_0.across_2 = _S14 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S13).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn locate_varied_0( family_2 : u32,  position_3 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_3 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S15 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S16 : u32;
    if(_S15 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S16 = u32(1);
    }
    else
    {
        _S16 = u32(0);
    }
    var _S17 : u32 = min(thread_1 + _S16, u32(families_0[family_2].count_0) - u32(1));
    var _S18 : u32 = families_0[family_2].place_table_0 + _S17 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S17;
    cell_1.below_0 = _S15 - table_number_0(_S18);
    cell_1.above_0 = table_number_0(_S18 + u32(1)) - _S15;
    cell_1.across_2 = _S15 - table_number_0(_S18 + u32(2));
    cell_1.half_width_1 = table_number_0(_S18 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_4 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_4);
    }
    return locate_varied_0(family_3, position_4);
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

fn shown_at_0( crossing_0 : Crossing_0,  back_1 : bool) -> Shown_0
{
    var _S19 : bool = (abs(crossing_0.warp_1.across_2)) < (crossing_0.warp_1.half_width_1);
    var _S20 : bool = (abs(crossing_0.weft_1.across_2)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S21 : bool;
    if(_S19)
    {
        if(!_S20)
        {
            _S21 = true;
        }
        else
        {
            _S21 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S21 = false;
    }
    shown_0.is_warp_2 = _S21;
    if(!_S19)
    {
        _S21 = !_S20;
    }
    else
    {
        _S21 = false;
    }
    shown_0.hole_3 = _S21;
    var _S22 : u32;
    if(shown_0.is_warp_2)
    {
        _S22 = crossing_0.warp_word_0;
    }
    else
    {
        _S22 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S22;
    shown_0.on_top_0 = (((_S22 & (u32(1)))) == u32(1)) != back_1;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_0 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_2 : Cell_0;
    var _S23 : u32;
    if(is_first_0)
    {
        _S23 = first_0.thread_0;
    }
    else
    {
        _S23 = second_0.thread_0;
    }
    cell_2.thread_0 = _S23;
    var _S24 : f32;
    if(is_first_0)
    {
        _S24 = first_0.across_2;
    }
    else
    {
        _S24 = second_0.across_2;
    }
    cell_2.across_2 = _S24;
    if(is_first_0)
    {
        _S24 = first_0.half_width_1;
    }
    else
    {
        _S24 = second_0.half_width_1;
    }
    cell_2.half_width_1 = _S24;
    if(is_first_0)
    {
        _S24 = first_0.below_0;
    }
    else
    {
        _S24 = second_0.below_0;
    }
    cell_2.below_0 = _S24;
    if(is_first_0)
    {
        _S24 = first_0.above_0;
    }
    else
    {
        _S24 = second_0.above_0;
    }
    cell_2.above_0 = _S24;
    return cell_2;
}

fn boundary_0( family_4 : u32,  thread_2 : u32,  step_0 : i32) -> f32
{
    var _S25 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_2) + step_0));
    return fma(_S25.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S25.y) * u32(4)));
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
    var _S26 : Family_std430_0 = families_0[family_6];
    var _S27 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S27 = u32(0);
    }
    else
    {
        _S27 = thread_4 * u32(4);
    }
    var _S28 : u32 = _S26.bend_table_0 + _S27;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S28);
    bend_0.half_tangent_0 = table_number_0(_S28 + u32(1));
    bend_0.arc_0 = table_number_0(_S28 + u32(2));
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
    var _S29 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S30 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S31 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S32 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S33 : i32 = - _S29;
    var _S34 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_0, _S33, i32(0));
    run_0.from_start_0 = _S34;
    var _S35 : i32 = _S30 + i32(1);
    var _S36 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_0, i32(1), _S35);
    run_0.to_end_0 = _S36;
    var _S37 : bool = _S34 < _S36;
    run_0.near_start_0 = _S37;
    var _S38 : i32;
    if(_S37)
    {
        _S38 = _S33 - _S31;
    }
    else
    {
        _S38 = _S35;
    }
    var _S39 : i32;
    if(run_0.near_start_0)
    {
        _S39 = _S33;
    }
    else
    {
        _S39 = _S35 + _S32;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_5);
    var _S40 : f32;
    if(run_0.straight_0)
    {
        _S40 = 1.0e+06f;
    }
    else
    {
        _S40 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S40;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_0, _S38, _S39), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S29 == i32(0);
    run_0.last_crossing_0 = _S30 == i32(0);
    return run_0;
}

fn square_1( x_5 : f32) -> f32
{
    return x_5 * x_5;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_3 : Cell_0) -> Section_0
{
    var _S41 : f32 = cell_3.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S42 : f32 = clamp(cell_3.across_2, - cell_3.half_width_1, cell_3.half_width_1);
    section_0.across_3 = _S42;
    var _S43 : f32 = _S41 * _S41 - square_1(_S42);
    var _S44 : f32 = rsqrt_0(_S43);
    section_0.drop_0 = _S41 - _S43 * _S44;
    section_0.slope_0 = - _S42 * _S44;
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
    var _S45 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S46 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S47 : f32;
    if(_S45)
    {
        _S47 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S47 = crossed_1.above_0 + crossed_1.across_2;
    }
    var _S48 : f32 = _S47 - crossed_1.half_width_1;
    var _S49 : bool;
    if(_S45)
    {
        _S49 = run_1.first_crossing_0;
    }
    else
    {
        _S49 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S47 = 0.0f;
    }
    else
    {
        _S47 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, i32(0));
    }
    var _S50 : f32;
    if((shown_1.on_top_0) != _S49)
    {
        _S50 = 0.0f;
    }
    else
    {
        var _S51 : Family_std430_0 = families_0[other_1];
        var _S52 : i32;
        if(_S45)
        {
            _S52 = i32(-1);
        }
        else
        {
            _S52 = i32(1);
        }
        _S50 = _S51.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_0, _S52);
    }
    var _S53 : f32 = 1.0f / max(2.0f * _S48, 9.999999960041972e-13f);
    var _S54 : f32 = clamp((_S48 - _S46) * _S53, 0.0f, 1.0f);
    var _S55 : f32 = _S47 + (_S50 - _S47) * (_S54 * _S54 * (3.0f - 2.0f * _S54));
    var _S56 : f32 = (_S47 - _S50) * (6.0f * _S54 * (1.0f - _S54) * _S53);
    if(_S45)
    {
        _S47 = 1.0f;
    }
    else
    {
        _S47 = -1.0f;
    }
    return vec2<f32>(_S55, _S56 * _S47);
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
    var _S57 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S57), 9.99999971718068537e-10f);
    var _S58 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S58), 9.99999971718068537e-10f);
    control_0.right_0 = _S57 > 0.0f;
    control_0.up_0 = _S58 > 0.0f;
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
    var _S59 : f32;
    if(forwards_0)
    {
        _S59 = cell_4.across_2;
    }
    else
    {
        _S59 = - cell_4.across_2;
    }
    var _S60 : f32;
    if(forwards_0)
    {
        _S60 = cell_4.above_0;
    }
    else
    {
        _S60 = cell_4.below_0;
    }
    var _S61 : bool;
    if(forwards_0)
    {
        _S61 = run_2.last_crossing_0;
    }
    else
    {
        _S61 = run_2.first_crossing_0;
    }
    var _S62 : bool;
    if(forwards_0)
    {
        _S62 = run_2.first_crossing_0;
    }
    else
    {
        _S62 = run_2.last_crossing_0;
    }
    var _S63 : f32 = - cell_4.half_width_1;
    var _S64 : bool = _S59 < _S63;
    var _S65 : bool = _S59 >= (cell_4.half_width_1);
    if(lengthwise_0)
    {
        _S61 = !_S61;
    }
    else
    {
        _S61 = false;
    }
    if(_S61)
    {
        _S61 = !shown_2.hole_3;
    }
    else
    {
        _S61 = false;
    }
    var _S66 : bool;
    if(_S61)
    {
        _S66 = shown_2.on_top_0;
    }
    else
    {
        _S66 = false;
    }
    if(_S66)
    {
        if(_S62)
        {
            _S62 = _S64;
        }
        else
        {
            _S62 = false;
        }
        _S62 = !_S62;
    }
    else
    {
        _S62 = false;
    }
    if(shown_2.hole_3)
    {
        _S61 = true;
    }
    else
    {
        if(_S61)
        {
            _S61 = !shown_2.on_top_0;
        }
        else
        {
            _S61 = false;
        }
    }
    var _S67 : f32;
    if(_S64)
    {
        _S67 = _S63;
    }
    else
    {
        _S67 = cell_4.half_width_1;
    }
    var _S68 : f32 = _S67 - _S59;
    if(_S61)
    {
        _S59 = 2.0f * _S60 + _S59 - cell_4.half_width_1;
    }
    else
    {
        _S59 = _S60;
    }
    if(_S62)
    {
        if(forwards_0)
        {
            _S59 = run_2.to_end_0;
        }
        else
        {
            _S59 = run_2.from_start_0;
        }
        return _S59;
    }
    if(_S65)
    {
    }
    else
    {
        _S59 = _S68;
    }
    return _S59;
}

struct Probe_0
{
     height_3 : f32,
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
    var _S69 : f32 = previous_1.rate_0 * step_4;
    var _S70 : f32 = rate_1 * step_4;
    var _S71 : bool;
    if(!previous_1.known_0)
    {
        _S71 = true;
    }
    else
    {
        _S71 = here_0.hole_4;
    }
    if(_S71)
    {
        _S71 = true;
    }
    else
    {
        _S71 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S71)
    {
        _S71 = true;
    }
    else
    {
        _S71 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S71)
    {
        _S71 = true;
    }
    else
    {
        _S71 = rate_1 <= 0.0f;
    }
    if(_S71)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S69) >= 0.0f)
    {
        _S71 = (3.0f * clearance_1 - _S70) >= 0.0f;
    }
    else
    {
        _S71 = false;
    }
    if(_S71)
    {
        return -1.0f;
    }
    var _S72 : f32 = clearance_1 - previous_1.clearance_0;
    var _S73 : f32 = 6.0f * _S72 - 4.0f * _S69 - 2.0f * _S70;
    var _S74 : f32 = -2.0f * _S69 / max(_S73 + sqrt(max(_S73 * _S73 - 4.0f * (3.0f * (_S69 + _S70 - 2.0f * _S72)) * _S69, 0.0f)), 9.99999968265522539e-21f);
    var _S75 : f32 = 1.0f - _S74;
    var _S76 : f32 = (previous_1.clearance_0 * (2.0f * _S74 + 1.0f) + _S69 * _S74) * _S75 * _S75;
    var _S77 : f32 = (clearance_1 * (2.0f * _S75 + 1.0f) - _S70 * _S75) * _S74 * _S74;
    if(_S74 > 0.01999999955296516f)
    {
        _S71 = _S75 > 0.01999999955296516f;
    }
    else
    {
        _S71 = false;
    }
    if(_S71)
    {
        _S71 = (_S76 + _S77) < 0.0f;
    }
    else
    {
        _S71 = false;
    }
    var _S78 : f32;
    if(_S71)
    {
        _S78 = _S75 * step_4;
    }
    else
    {
        _S78 = -1.0f;
    }
    return _S78;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S79 : f32;
    if(here_1.hole_4)
    {
        _S79 = 1.0e+09f;
    }
    else
    {
        _S79 = clearance_2;
    }
    previous_2.clearance_0 = _S79;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S80 : bool;
    if(!here_1.hole_4)
    {
        _S80 = !is_cell_exit_0;
    }
    else
    {
        _S80 = false;
    }
    previous_2.known_0 = _S80;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S81 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S82 : bool;
    if(!here_2.hole_4)
    {
        _S82 = (rate_3 * _S81 + clearance_3) < 0.0f;
    }
    else
    {
        _S82 = false;
    }
    if(_S82)
    {
        _S82 = _S81 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S82 = false;
    }
    var _S83 : f32;
    if(_S82)
    {
        _S83 = _S81 - this_2.epsilon_0;
    }
    else
    {
        _S83 = max(_S81, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S83);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_4 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_4);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S84 : f32 = end_0 - start_1;
    var _S85 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S84;
    var _S86 : f32 = 3.0f * _S84 - 2.0f * start_rate_0 - end_rate_0;
    var share_0 : f32 = start_1 / max(- _S84, 9.99999968265522539e-21f);
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
        var _S87 : f32 = clamp(share_0 - (((_S85 * share_0 + _S86) * share_0 + start_rate_0) * share_0 + start_1) / min((3.0f * _S85 * share_0 + 2.0f * _S86) * share_0 + start_rate_0, 0.10000000149011612f * _S84 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S88 : i32 = i_0 + i32(1);
        share_0 = _S87;
        i_0 = _S88;
    }
    return share_0;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S89 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S90 : f32 = rsqrt_0(_S89);
    var _S91 : f32 = sine_1 * _S90 * rsqrt_0(_S89 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S91 * _S89, _S91 * across_slope_0 * along_slope_0 + cosine_0 * _S90);
}

fn arc_sine_0( x_6 : f32) -> f32
{
    var _S92 : f32 = abs(x_6);
    var _S93 : bool = _S92 > 0.5f;
    var _S94 : f32;
    if(_S93)
    {
        _S94 = 0.5f * (1.0f - _S92);
    }
    else
    {
        _S94 = _S92 * _S92;
    }
    var _S95 : f32;
    if(_S93)
    {
        _S95 = sqrt(max(_S94, 0.0f));
    }
    else
    {
        _S95 = _S92;
    }
    var _S96 : f32 = ((((0.04216320067644119f * _S94 + 0.02418131195008755f) * _S94 + 0.04547002539038658f) * _S94 + 0.07495300471782684f) * _S94 + 0.16666752099990845f) * _S94 * _S95 + _S95;
    if(_S93)
    {
        _S94 = 1.57079637050628662f - 2.0f * _S96;
    }
    else
    {
        _S94 = _S96;
    }
    if(x_6 < 0.0f)
    {
        _S94 = - _S94;
    }
    return _S94;
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
    var _S97 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S98 : u32 = ((((_S97 >> ((((_S97 >> (u32(28)))) + u32(4))))) ^ (_S97))) * u32(277803737);
    return (((_S98 >> (u32(22)))) ^ (_S98));
}

fn uniform_hash_0( thread_8 : u32,  cell_5 : u32,  stream_0 : u32) -> f32
{
    return (f32(((scramble_0(cell_5 + scramble_0(thread_8 + scramble_0(stream_0)))) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_9 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_9, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_0 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S99 : vec3<f32> = room_0 / max(albedo_0, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S99.x, _S99.y), _S99.z), 0.0f));
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_3 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S100 : f32 = light_1.z;
    if(_S100 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S100, 0.0f), max(dot(light_1, normal_3), 0.0f), blend_0);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S101 : f32 = dot(direction_3, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S101 * _S101 + 1.0f, roughness_1 * roughness_1));
}

fn exponential_0( x_7 : f32) -> f32
{
    var _S102 : f32 = clamp(x_7, -87.0f, 88.0f);
    var _S103 : f32 = floor(_S102 * 1.4426950216293335f + 0.5f);
    var _S104 : f32 = _S102 - _S103 * 0.693359375f + _S103 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S104 + 0.00139819993637502f) * _S104 + 0.00833345204591751f) * _S104 + 0.04166579619050026f) * _S104 + 0.1666666567325592f) * _S104 + 0.5f;
    var _S105 : f32 = (bitcast<f32>(((u32(i32(_S103) + i32(127)) << (u32(23))))));
    var _S106 : f32;
    if(x_7 < -87.0f)
    {
        _S106 = 0.0f;
    }
    else
    {
        _S106 = (p_0 * _S104 * _S104 + _S104 + 1.0f) * _S105;
    }
    return _S106;
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
    var _S107 : f32 = roughness_2 * roughness_2;
    var _S108 : f32 = squared_along_0 * (1.0f - _S107) + _S107;
    return 0.31830987334251404f * _S107 * roughness_2 / (_S108 * _S108);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S109 : vec3<f32> = light_2 + view_1;
    var _S110 : f32 = dot(_S109, tangent_3);
    return flake_density_0(min(_S110 * _S110 / max(square_0(_S109), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_4 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S111 : f32 = - dot(light_3, normal_4);
    var _S112 : f32 = dot(view_2, normal_4);
    var _S113 : bool;
    if(_S111 <= 0.0f)
    {
        _S113 = true;
    }
    else
    {
        _S113 = _S112 <= 0.0f;
    }
    if(_S113)
    {
        return 0.0f;
    }
    var _S114 : f32 = 1.0f / max(_S112, 9.99999997475242708e-07f);
    var _S115 : f32 = projected_area_1(light_3, tangent_4, roughness_4) / max(_S111, 9.99999997475242708e-07f);
    var _S116 : f32 = projected_area_1(view_2, tangent_4, roughness_4) * _S114;
    return density_between_0(light_3, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S115, _S116)) * mean_attenuation_0(optical_depth_1 * abs(_S115 - _S116)) * _S114;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_5 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S117 : f32 = dot(light_4, normal_5);
    var _S118 : bool;
    if(_S117 <= 0.0f)
    {
        _S118 = true;
    }
    else
    {
        _S118 = (dot(view_3, normal_5)) <= 0.0f;
    }
    if(_S118)
    {
        return 0.0f;
    }
    var _S119 : f32 = max(_S117, 9.99999997475242708e-07f);
    var _S120 : f32 = max(dot(view_3, normal_5), 9.99999997475242708e-07f);
    var _S121 : f32 = projected_area_1(light_4, tangent_5, roughness_5) * _S120 + projected_area_1(view_3, tangent_5, roughness_5) * _S119;
    var _S122 : f32 = optical_depth_2 * _S121 / (_S119 * _S120);
    return 0.25f * density_between_0(light_4, view_3, tangent_5, roughness_5) * (_S122 * mean_attenuation_0(_S122)) * _S119 / _S121;
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

fn wrapped_cell_0( position_5 : f32,  count_1 : f32) -> f32
{
    return min(floor((position_5 - floor(position_5)) * count_1), count_1 - 1.0f);
}

fn arc_tangent_quotient_0( x_8 : f32,  y_2 : f32) -> f32
{
    return ((((((0.0f * x_8 + 0.00809729471802711f) * x_8 + -0.0377517081797123f) * x_8 + 0.08475969731807709f) * x_8 + -0.13537675142288208f) * x_8 + 0.19895026087760925f) * x_8 + -0.33327975869178772f) * x_8 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_3 : f32,  x_9 : f32) -> f32
{
    var _S123 : f32 = abs(x_9);
    var _S124 : f32 = abs(y_3);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S123, _S124) / max(max(_S123, _S124), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S124 > _S123)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_9 < 0.0f)
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
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_0( direction_4 : vec3<f32>) -> NodeTaps_0
{
    var _S125 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    var _S126 : f32 = floor(_S125);
    var _S127 : f32 = _S125 - _S126;
    var _S128 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S129 : f32 = 7.0f * _S128 * sqrt(_S128);
    var _S130 : f32 = min(floor(_S129), 6.0f);
    var _S131 : f32 = _S129 - _S130;
    var _S132 : u32 = u32(i32(_S126) + i32(32)) % u32(32);
    var _S133 : u32 = u32(_S130);
    var _S134 : u32 = _S132 * u32(8) + _S133;
    var _S135 : u32 = (_S132 + u32(1)) % u32(32) * u32(8) + _S133;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S134, _S134 + u32(1), _S135, _S135 + u32(1));
    var _S136 : f32 = 1.0f - _S127;
    var _S137 : f32 = 1.0f - _S131;
    var _S138 : vec4<u32> = vec4<u32>(vec4<f32>(_S136 * _S137, _S136 * _S131, _S127 * _S137, _S127 * _S131) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S138;
    taps_0.inverse_sum_0 = 1.0f / f32(_S138.x + _S138.y + _S138.z + _S138.w);
    return taps_0;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S139 : vec3<f32> = light_5 + view_4;
    return _S139 * vec3<f32>(rsqrt_0(max(square_0(_S139), 9.999999960041972e-13f)));
}

fn shadow_correlation_0( light_6 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S140 : vec2<f32> = light_6.xy;
    var _S141 : vec2<f32> = view_5.xy;
    var _S142 : f32 = dot(_S140, _S141) / max(sqrt(dot(_S140, _S140) * dot(_S141, _S141)), 9.99999997475242708e-07f);
    if((light_6.z) < 0.0f)
    {
        return vec3<f32>(vec2<f32>((-0.09000000357627869f + -0.07999999821186066f * _S142)), 0.0f);
    }
    return vec3<f32>(min(0.62000000476837158f + 0.62999999523162842f * _S142, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S143 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S144 : vec4<u32> = ((packs_1 & (_S143))) * taps_1.weights_0;
    var _S145 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S143))) * taps_1.weights_0;
    return bytes_of_sums_0(_S144.x + _S144.y + _S144.z + _S144.w, _S145.x + _S145.y + _S145.z + _S145.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_0 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S146 : vec4<u32> = vec4<u32>(table_0) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S146.x], words_0[_S146.y], words_0[_S146.z], words_0[_S146.w]));
}

struct Group_0
{
     normal_6 : vec3<f32>,
     weight_1 : f32,
     tangent_6 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_6 : f32,
};

fn group_at_0( row_1 : u32,  roughness_7 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_6 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_1 = table_number_0(row_1 + u32(3));
    var _S147 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_6 = _S147;
    var _S148 : f32 = table_number_0(row_1 + u32(7));
    var _S149 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S148, _S149, 1.0f - square_0(_S147) - _S148 - _S149);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn visibility_gain_0( correlations_0 : vec3<f32>,  from_light_0 : f32,  from_view_0 : f32) -> vec2<f32>
{
    return max(correlations_0.xy * vec2<f32>((1.0f / max(max(from_light_0, from_view_0), 0.00392156885936856f) - 1.0f)) + vec2<f32>(1.0f - correlations_0.z * (1.0f - from_light_0), 1.0f), vec2<f32>(0.0f));
}

fn Group_variance_along_0( this_5 : Group_0,  direction_5 : vec3<f32>) -> f32
{
    var _S150 : f32 = direction_5.x;
    var _S151 : f32 = direction_5.y;
    var _S152 : f32 = direction_5.z;
    return max(dot(this_5.variance_0, direction_5 * direction_5) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S150 * _S151, _S150 * _S152, _S151 * _S152)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_6 : vec3<f32>) -> f32
{
    var _S153 : f32 = dot(direction_6, group_1.tangent_6);
    var _S154 : f32 = group_1.roughness_6;
    var _S155 : f32 = _S154 * _S154;
    return sqrt(max((_S155 - 1.0f) * (_S153 * _S153 + Group_variance_along_0(group_1, direction_6)) + 1.0f, _S155));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S156 : f32 = group_2.roughness_6;
    var _S157 : f32 = max(sqrt(max(1.0f - _S156 * _S156, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S158 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S159 : f32 = dot(half_0, group_2.tangent_6);
    var _S160 : f32 = _S157 * (_S159 - _S158);
    var _S161 : f32 = _S157 * (_S159 + _S158);
    var _S162 : f32 = _S160 * _S161;
    var _S163 : f32 = 2.0f * _S158 * _S157;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S162) / ((_S160 * _S160 + 1.0f) * (_S161 * _S161 + 1.0f)) + arc_tangent_0(_S163, 1.0f + _S162) / _S163);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_7 : vec3<f32>,  view_6 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S164 : bool = (light_7.z) < 0.0f;
    var _S165 : f32 = dot(light_7, group_3.normal_6);
    var _S166 : f32;
    if(_S164)
    {
        _S166 = - _S165;
    }
    else
    {
        _S166 = _S165;
    }
    var _S167 : f32 = max(dot(view_6, group_3.normal_6), 0.01999999955296516f);
    var _S168 : f32 = mean_area_0(group_3, light_7) / max(_S166, 0.01999999955296516f);
    var _S169 : f32 = mean_area_0(group_3, view_6) / _S167;
    if(_S164)
    {
        _S166 = abs(_S168 - _S169);
    }
    else
    {
        _S166 = _S168 + _S169;
    }
    var _S170 : f32 = optical_depth_3 * max(_S166, 0.00100000004749745f);
    if(_S164)
    {
        _S166 = exponential_0(- optical_depth_3 * min(_S168, _S169));
    }
    else
    {
        _S166 = 1.0f;
    }
    var _S171 : f32 = optical_depth_3 * _S166 * (1.0f - exponential_0(- _S170)) / _S170 / _S167;
    if(_S164)
    {
        _S166 = 1.0f;
    }
    else
    {
        _S166 = 1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_6));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S166 * _S171;
}

struct Bound_0
{
     thread_11 : u32,
     turns_2 : f32,
     cell_7 : f32,
     visible_0 : f32,
     width_1 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_9 : u32,  position_6 : f32) -> Bound_0
{
    var _S172 : Cell_0 = locate_0(family_9, position_6);
    var _S173 : f32 = table_number_0(families_0[family_9].before_0 + u32(2) * _S172.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_11 = _S172.thread_0;
    bound_0.turns_2 = round((position_6 - families_0[family_9].start_0 - _S173 - _S172.below_0) * families_0[family_9].inverse_period_0);
    bound_0.cell_7 = _S172.below_0;
    var _S174 : f32 = 2.0f * _S172.half_width_1;
    bound_0.width_1 = _S174;
    bound_0.visible_0 = clamp((_S172.across_2 + _S172.half_width_1) / _S174, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S172.below_0, _S172.below_0 - _S172.across_2 - _S172.half_width_1) + max(_S172.across_2 - _S172.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_10 : u32,  centre_1 : f32,  size_1 : f32) -> Stretch_0
{
    var _S175 : f32 = centre_1 - floor((centre_1 - families_0[family_10].start_0) * families_0[family_10].inverse_period_0) * families_0[family_10].period_0;
    var _S176 : f32 = 0.5f * max(size_1, families_0[family_10].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_10, _S175 - _S176);
    stretch_0.high_0 = bound_at_0(family_10, _S175 + _S176);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_0.turns_2 - this_6.low_0.turns_2;
}

fn lengths_0( family_11 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S177 : f32 = Stretch_turns_0(stretch_1);
    var _S178 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.low_0.thread_11;
    var _S179 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.high_0.thread_11;
    var _S180 : f32 = table_number_0(_S179) - table_number_0(_S178);
    var _S181 : f32 = table_number_0(_S179 + u32(1)) - table_number_0(_S178 + u32(1));
    return vec3<f32>(_S180 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_1 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_1 + _S177 * families_0[family_11].visible_total_0, _S181 - _S180 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S177 * (families_0[family_11].period_0 - families_0[family_11].visible_total_0), _S181 + stretch_1.high_0.cell_7 - stretch_1.low_0.cell_7 + _S177 * families_0[family_11].period_0);
}

fn integrals_along_0( family_12 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S182 : Family_std430_0 = families_0[family_12];
    var _S183 : u32 = u32(3) * _S182.quantities_0;
    var _S184 : u32 = families_0[family_12].colour_threads_0 + _S183 * stretch_2.low_0.thread_11 + quantity_0;
    var _S185 : u32 = families_0[family_12].colour_threads_0 + _S183 * stretch_2.high_0.thread_11 + quantity_0;
    var _S186 : u32 = families_0[family_12].colour_threads_0 + _S183 * u32(families_0[family_12].count_0) + quantity_0;
    var _S187 : f32 = table_number_0(_S184);
    var _S188 : f32 = table_number_0(_S185);
    var _S189 : f32 = Stretch_turns_0(stretch_2);
    var _S190 : u32 = u32(2) * _S182.quantities_0;
    return vec2<f32>(table_number_0(_S185 + _S182.quantities_0) - table_number_0(_S184 + _S182.quantities_0) + _S188 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_1 - _S187 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_1 + _S189 * table_number_0(_S186 + _S182.quantities_0), table_number_0(_S185 + _S190) - table_number_0(_S184 + _S190) + _S188 * stretch_2.high_0.cell_7 - _S187 * stretch_2.low_0.cell_7 + _S189 * table_number_0(_S186 + _S190));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_0.thread_11) < (this_7.low_0.thread_11);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S191 : u32 = entries_0.z;
    var _S192 : u32 = entries_0.x;
    var _S193 : u32 = _S191 - _S192;
    var _S194 : u32;
    if(Stretch_wraps_0(this_8))
    {
        _S194 = whole_0;
    }
    else
    {
        _S194 = u32(0);
    }
    return vec4<u32>(_S193 + _S194, entries_0.w - _S191, entries_0.y - _S192, whole_0);
}

fn row_differences_0( across_4 : Stretch_0,  row_2 : u32,  count_2 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S195 : u32 = row_2 + across_4.low_0.thread_11 * quantities_1;
    var _S196 : u32 = row_2 + across_4.high_0.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, vec4<u32>(words_0[_S195], words_0[_S195 + quantities_1], words_0[_S196], words_0[_S196 + quantities_1]), words_0[row_2 + count_2 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    var _S197 : f32 = - this_9.low_0.visible_0;
    var _S198 : f32 = Stretch_turns_0(this_9);
    var _S199 : f32;
    if(Stretch_wraps_0(this_9))
    {
        _S199 = 1.0f;
    }
    else
    {
        _S199 = 0.0f;
    }
    return vec4<f32>(1.0f, this_9.high_0.visible_0, _S197, _S198 - _S199);
}

fn integral_on_top_0( family_13 : u32,  across_5 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S200 : u32 = u32(families_0[family_13].count_0);
    var _S201 : u32 = (_S200 + u32(1)) * families_0[family_13].quantities_0;
    var _S202 : u32 = families_0[family_13].colour_areas_0 + quantity_1;
    var _S203 : vec4<u32> = row_differences_0(across_5, _S202 + along_0.low_0.thread_11 * _S201, _S200, families_0[family_13].quantities_0);
    var _S204 : vec4<u32> = row_differences_0(across_5, _S202 + (along_0.low_0.thread_11 + u32(1)) * _S201, _S200, families_0[family_13].quantities_0);
    var _S205 : vec4<u32> = row_differences_0(across_5, _S202 + along_0.high_0.thread_11 * _S201, _S200, families_0[family_13].quantities_0);
    var _S206 : vec4<u32> = row_differences_0(across_5, _S202 + (along_0.high_0.thread_11 + u32(1)) * _S201, _S200, families_0[family_13].quantities_0);
    var _S207 : vec4<u32> = row_differences_0(across_5, _S202 + crossing_count_0 * _S201, _S200, families_0[family_13].quantities_0);
    var _S208 : vec4<u32> = _S205 - _S203;
    var _S209 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S209 = _S207;
    }
    else
    {
        _S209 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S210 : vec4<f32> = Stretch_weights_0(across_5);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S208 + _S209)), _S210), dot(vec4<f32>(vec4<i32>(_S206 - _S205)), _S210), dot(vec4<f32>(vec4<i32>(_S204 - _S203)), _S210), dot(vec4<f32>(vec4<i32>(_S207)), _S210)), Stretch_weights_0(along_0)) * families_0[family_13].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_2 : f32,  row_3 : u32) -> Albedos_0
{
    var _S211 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S212 : vec3<f32> = vec3<f32>(weight_2);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S212 * _S211.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S212 * _S211.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S212 * _S211.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S212 * _S211.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_14 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_2 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_14].colour_mean_0);
    if((families_0[family_14].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S213 : vec3<f32> = lengths_0(crossing_1, other_2);
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
        var _S214 : vec2<f32> = integrals_along_0(family_14, own_1, quantity_2);
        var _S215 : f32 = integral_on_top_0(family_14, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S216 : f32 = _S214.x;
        var _S217 : f32 = _S216 * _S213.x;
        var _S218 : f32;
        if(back_2)
        {
            _S218 = _S217 - _S215;
        }
        else
        {
            _S218 = _S215;
        }
        var _S219 : bool = quantity_2 == u32(0);
        if(_S219)
        {
            is_exposed_0 = _S218 > (16.0f * families_0[family_14].area_unit_0 * min(_S217 / families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S217);
        }
        var _S220 : f32 = _S216 * _S213.y;
        var _S221 : f32;
        if(is_exposed_0)
        {
            _S221 = _S218;
        }
        else
        {
            _S221 = 0.0f;
        }
        var _S222 : f32 = _S220 + _S221 + 0.000244140625f * _S213.z * _S214.y;
        if(_S219)
        {
            weight_3 = 1.0f / max(_S222, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S222 * weight_3, families_0[family_14].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
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
    var _S223 : vec3<f32> = vec3<f32>(weight_4);
    albedos_3.diffuse_reflect_0 = mix(first_2.diffuse_reflect_0, second_1.diffuse_reflect_0, _S223);
    albedos_3.diffuse_transmit_0 = mix(first_2.diffuse_transmit_0, second_1.diffuse_transmit_0, _S223);
    albedos_3.specular_reflect_0 = mix(first_2.specular_reflect_0, second_1.specular_reflect_0, _S223);
    albedos_3.specular_transmit_0 = mix(first_2.specular_transmit_0, second_1.specular_transmit_0, _S223);
    return albedos_3;
}

fn sheen_scale_0( x_10 : f32,  y_4 : f32) -> f32
{
    return (((((0.0f * x_10 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_10 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_10 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_10 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_10 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_10 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

fn sheen_shear_0( x_11 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_11 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_11 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_11 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_11 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_12 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_12 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_12 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_12 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_12 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_12 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S224 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S225 : f32 = 2.0f * sqrt(_S224) - 1.0f;
    var _S226 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S225, _S226), 0.00999999977648258f, 1.0f), clamp((1.0f - _S224) * sheen_shear_0(_S225, _S226), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S225, _S226), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_7 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S227 : f32 = light_8.z;
    var _S228 : bool;
    if(_S227 <= 0.0f)
    {
        _S228 = true;
    }
    else
    {
        _S228 = (view_7.z) <= 0.0f;
    }
    if(_S228)
    {
        return 0.0f;
    }
    var _S229 : vec2<f32> = view_7.xy;
    var _S230 : f32 = dot(_S229, _S229);
    var _S231 : vec2<f32>;
    if(_S230 > 9.99999968265522539e-21f)
    {
        _S231 = _S229 * vec2<f32>(rsqrt_0(_S230));
    }
    else
    {
        _S231 = vec2<f32>(1.0f, 0.0f);
    }
    var _S232 : f32 = scale_0 * dot(light_8.xy, _S231) + shear_0 * _S227;
    var _S233 : f32 = scale_0 * (light_8.y * _S231.x - light_8.x * _S231.y);
    var _S234 : f32 = _S232 * _S232 + _S233 * _S233 + _S227 * _S227;
    return 0.31830987334251404f * scale_0 * scale_0 * _S227 / max(_S234 * _S234, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_8 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S235 : vec3<f32> = sheen_lobe_0(view_8.z, roughness_9);
    var _S236 : f32 = strength_0 * _S235.z;
    return vec2<f32>(_S236 * transformed_cosine_0(light_9, view_8, _S235.x, _S235.y), 1.0f - _S236);
}

fn accumulate_0( frame_4 : ptr<function, Frame_std430_0>,  pixel_0 : vec2<u32>,  light_10 : vec4<f32>)
{
    var _S237 : u32 = pixel_0.y * (*frame_4).width_0 + pixel_0.x;
    var _S238 : f32 = light_10.w;
    var _S239 : vec4<f32> = vec4<f32>(light_10.xyz + vec3<f32>((1.0f - _S238)) * vec3<f32>((*frame_4).background_red_0, (*frame_4).background_green_0, (*frame_4).background_blue_0), _S238);
    var _S240 : vec4<f32>;
    if(((*frame_4).pass_number_0) == u32(0))
    {
        _S240 = _S239;
    }
    else
    {
        _S240 = radiance_0[_S237] + _S239;
    }
    radiance_0[_S237] = _S240;
    return;
}

fn visible_point_0( _S241 : ptr<function, Frame_std430_0>,  _S242 : u32,  _S243 : u32,  _S244 : vec2<u32>) -> VisiblePoint_0
{
    var _S245 : u32 = u32(3) * _S243;
    var _S246 : Vertex_std430_0 = vertices_0[corners_0[_S245]];
    var _S247 : Vertex_std430_0 = vertices_0[corners_0[_S245 + u32(1)]];
    var _S248 : Vertex_std430_0 = vertices_0[corners_0[_S245 + u32(2)]];
    var _S249 : vec3<f32> = position_of_0(&(_S247));
    var _S250 : vec3<f32> = position_of_0(&(_S246));
    var _S251 : vec3<f32> = _S249 - _S250;
    var _S252 : vec3<f32> = position_of_0(&(_S248));
    var _S253 : vec3<f32> = _S252 - _S250;
    var _S254 : vec3<f32> = cross(_S251, _S253);
    var _S255 : f32 = 1.0f / max(square_0(_S254), 1.00000000317107685e-30f);
    var _S256 : vec3<f32> = camera_right_0(&((*_S241)));
    var _S257 : f32 = f32((*_S241).width_0);
    var _S258 : vec3<f32> = _S256 * vec3<f32>((2.0f / _S257));
    var _S259 : vec3<f32> = camera_up_0(&((*_S241)));
    var _S260 : f32 = f32((*_S241).height_0);
    var _S261 : vec3<f32> = _S259 * vec3<f32>((-2.0f / _S260));
    var _S262 : f32 = f32(_S244.x) + 0.5f - 0.5f * _S257;
    var _S263 : f32 = f32(_S244.y) + 0.5f - 0.5f * _S260;
    var _S264 : vec3<f32> = camera_forward_0(&((*_S241)));
    var _S265 : vec3<f32> = _S264 + vec3<f32>(_S262) * _S258 + vec3<f32>(_S263) * _S261;
    var _S266 : f32 = dot(_S265, _S254);
    var _S267 : f32;
    if((abs(_S266)) > 1.00000000317107685e-30f)
    {
        _S267 = _S266;
    }
    else
    {
        _S267 = 1.00000000317107685e-30f;
    }
    var _S268 : f32 = 1.0f / _S267;
    var _S269 : vec3<f32> = camera_origin_0(&((*_S241)));
    var _S270 : vec3<f32> = _S250 - _S269;
    var _S271 : vec3<f32> = vec3<f32>((dot(_S270, _S254) * _S268));
    var _S272 : vec3<f32> = _S265 * _S271 - _S270;
    var _S273 : vec3<f32> = _S271 * (_S258 - _S265 * vec3<f32>((dot(_S258, _S254) * _S268)));
    var _S274 : vec3<f32> = _S271 * (_S261 - _S265 * vec3<f32>((dot(_S261, _S254) * _S268)));
    var _S275 : vec3<f32> = vec3<f32>(_S255);
    var _S276 : vec3<f32> = cross(_S253, _S254) * _S275;
    var _S277 : vec3<f32> = cross(_S254, _S251) * _S275;
    var _S278 : f32 = dot(_S272, _S276);
    var _S279 : f32 = dot(_S272, _S277);
    var _S280 : f32 = _S247.u_0 - _S246.u_0;
    var _S281 : f32 = _S247.v_0 - _S246.v_0;
    var _S282 : vec2<f32> = vec2<f32>(_S280, _S281);
    var _S283 : f32 = _S248.u_0 - _S246.u_0;
    var _S284 : f32 = _S248.v_0 - _S246.v_0;
    var _S285 : vec2<f32> = vec2<f32>(_S283, _S284);
    var _S286 : vec2<f32> = vec2<f32>(_S246.u_0, _S246.v_0) + vec2<f32>(_S278) * _S282 + vec2<f32>(_S279) * _S285;
    var _S287 : vec2<f32> = vec2<f32>(dot(_S273, _S276)) * _S282 + vec2<f32>(dot(_S273, _S277)) * _S285;
    var _S288 : vec2<f32> = vec2<f32>(dot(_S274, _S276)) * _S282 + vec2<f32>(dot(_S274, _S277)) * _S285;
    if((_S280 * _S284 - _S281 * _S283) < 0.0f)
    {
        _S267 = -1.0f;
    }
    else
    {
        _S267 = 1.0f;
    }
    var _S289 : vec3<f32> = vec3<f32>(_S267) * (vec3<f32>(_S284) * _S251 - vec3<f32>(_S281) * _S253);
    var _S290 : vec3<f32> = vec3<f32>(_S267) * (vec3<f32>(_S280) * _S253 - vec3<f32>(_S283) * _S251);
    var point_1 : VisiblePoint_0;
    var _S291 : f32 = 1.0f - _S278 - _S279;
    var _S292 : vec3<f32> = normal_of_0(&(_S246));
    var _S293 : vec3<f32> = vec3<f32>(_S291) * _S292;
    var _S294 : vec3<f32> = normal_of_0(&(_S247));
    var _S295 : vec3<f32> = _S293 + vec3<f32>(_S278) * _S294;
    var _S296 : vec3<f32> = normal_of_0(&(_S248));
    var _S297 : vec3<f32> = normalize(_S295 + vec3<f32>(_S279) * _S296);
    point_1.normal_0 = _S297;
    var _S298 : vec3<f32> = normalize(_S289 - _S297 * vec3<f32>(dot(_S297, _S289)));
    point_1.axis_x_0 = _S298;
    point_1.axis_y_0 = cross(_S297, _S298);
    point_1.position_0 = _S250 + _S272;
    point_1.view_0 = (vec3<f32>(0) - normalize(_S265));
    var _S299 : bool = (dot(cross(_S289, _S290), _S297)) < 0.0f;
    var _S300 : f32 = fabrics_0[_S242].uv_width_0;
    if(_S299)
    {
        _S267 = - fabrics_0[_S242].uv_height_0;
    }
    else
    {
        _S267 = fabrics_0[_S242].uv_height_0;
    }
    var _S301 : vec2<f32> = vec2<f32>(_S300, _S267);
    var _S302 : vec2<f32> = _S286 * _S301;
    if(_S299)
    {
        _S267 = fabrics_0[_S242].uv_height_0;
    }
    else
    {
        _S267 = 0.0f;
    }
    point_1.draft_0 = _S302 + vec2<f32>(0.0f, _S267);
    point_1.draft_dx_0 = _S287 * _S301;
    point_1.draft_dy_0 = _S288 * _S301;
    return point_1;
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

fn regime_of_0( _S303 : u32,  _S304 : Footprint_0,  _S305 : f32) -> Regime_0
{
    var _S306 : f32 = Footprint_spread_side_0(_S304);
    var _S307 : f32 = clamp((binary_logarithm_0(max(_S306, 9.99999971718068537e-10f)) - fabrics_0[_S303].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S308 : f32 = _S307 * _S307 * (3.0f - 2.0f * _S307);
    regime_0.prefiltered_0 = _S308;
    regime_0.threads_1 = _S306 * fabrics_0[_S303].lobes_0.threads_per_mm_0;
    var _S309 : f32 = mix(max(8.0f / _S305, 1.0f), 1.0f, _S308);
    var _S310 : f32;
    if(_S308 < 1.0f)
    {
        _S310 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S309);
    }
    else
    {
        _S310 = 0.0f;
    }
    regime_0.points_0 = _S310;
    return regime_0;
}

struct Hit_0
{
     x_13 : f32,
     y_7 : f32,
     hole_5 : bool,
     height_5 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_6 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S311 : u32,  _S312 : f32,  _S313 : f32,  _S314 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_1 = locate_0(fabrics_0[_S311].warp_0, _S312);
    crossing_3.weft_1 = locate_0(fabrics_0[_S311].weft_0, _S313);
    var _S315 : u32 = fabrics_0[_S311].run_words_0 + u32(2) * (crossing_3.weft_1.thread_0 * fabrics_0[_S311].ends_1 + crossing_3.warp_1.thread_0);
    var _S316 : u32 = words_0[_S315];
    crossing_3.warp_word_0 = _S316;
    crossing_3.weft_word_0 = words_0[_S315 + u32(1)];
    crossing_3.warp_above_0 = (((_S316 & (u32(1)))) == u32(1)) != _S314;
    return crossing_3;
}

fn sample_at_0( _S317 : u32,  _S318 : f32,  _S319 : f32,  _S320 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S321 : Crossing_0 = crossing_at_0(_S317, _S318, _S319, _S320);
    sample_0.crossing_2 = _S321;
    var _S322 : Shown_0 = shown_at_0(_S321, _S320);
    sample_0.shown_3 = _S322;
    var _S323 : u32;
    if(_S322.is_warp_2)
    {
        _S323 = fabrics_0[_S317].warp_0;
    }
    else
    {
        _S323 = fabrics_0[_S317].weft_0;
    }
    var _S324 : u32;
    if(_S322.is_warp_2)
    {
        _S324 = fabrics_0[_S317].weft_0;
    }
    else
    {
        _S324 = fabrics_0[_S317].warp_0;
    }
    var _S325 : Cell_0 = select_cell_0(_S322.is_warp_2, sample_0.crossing_2.warp_1, sample_0.crossing_2.weft_1);
    var _S326 : Cell_0 = select_cell_0(_S322.is_warp_2, sample_0.crossing_2.weft_1, sample_0.crossing_2.warp_1);
    var _S327 : Run_0 = unpack_0(_S323, _S324, _S325.thread_0, _S326, _S322.word_0);
    var _S328 : Section_0 = section_at_0(_S325);
    var _S329 : bool;
    if(_S322.on_top_0)
    {
        _S329 = (_S327.distance_0) < (_S328.drop_0 * _S327.bend_1.sine_0);
    }
    else
    {
        _S329 = false;
    }
    var _S330 : bool;
    if(_S322.on_top_0)
    {
        _S330 = !_S329;
    }
    else
    {
        _S330 = false;
    }
    var _S331 : f32;
    if(_S330)
    {
        _S331 = 1.0f;
    }
    else
    {
        _S331 = -1.0f;
    }
    var _S332 : f32;
    if(_S329)
    {
        _S332 = _S327.other_reach_0;
    }
    else
    {
        _S332 = _S327.reach_0;
    }
    var _S333 : f32;
    if(_S329)
    {
        _S333 = _S332 + _S327.distance_0;
    }
    else
    {
        _S333 = max(_S332 - _S327.distance_0, 0.0f);
    }
    var _S334 : f32 = _S332 / _S327.bend_1.sine_0 - _S331 * _S328.drop_0;
    var _S335 : f32 = _S333 * _S333;
    var _S336 : f32 = max(_S334 * _S334 - _S335, 9.99999968265522539e-21f);
    var _S337 : f32 = rsqrt_0(_S336);
    var _S338 : f32 = _S335 / (_S336 * _S337 + _S334);
    var _S339 : bool = _S333 > 0.0f;
    var _S340 : f32;
    if(_S322.on_top_0)
    {
        _S340 = 1.0f;
    }
    else
    {
        _S340 = -1.0f;
    }
    var _S341 : f32;
    if(_S327.near_start_0)
    {
        _S341 = 1.0f;
    }
    else
    {
        _S341 = -1.0f;
    }
    var _S342 : f32 = _S340 * _S341;
    if(_S339)
    {
        _S340 = _S334 * _S337;
    }
    else
    {
        _S340 = 1.0f;
    }
    sample_0.slope_across_0 = _S328.slope_0 * _S340;
    if(_S339)
    {
        _S333 = _S342 * _S333 * _S337;
    }
    else
    {
        _S333 = 0.0f;
    }
    sample_0.slope_along_0 = _S333;
    var _S343 : Family_std430_0 = families_0[_S323];
    var _S344 : vec2<f32> = dive_0(_S324, _S322, _S327, _S326);
    if(_S327.straight_0)
    {
        _S331 = 0.0f;
    }
    else
    {
        _S331 = _S343.height_scale_0 * _S331;
    }
    sample_0.height_6 = _S331 * (_S332 * _S327.bend_1.half_tangent_0 - _S338) - _S343.height_scale_0 * _S328.drop_0 - _S344.x;
    var _S345 : f32 = _S343.height_scale_0 * sample_0.slope_across_0;
    var _S346 : f32 = _S343.height_scale_0 * sample_0.slope_along_0 - _S344.y;
    if(_S322.is_warp_2)
    {
        _S331 = _S345;
    }
    else
    {
        _S331 = _S346;
    }
    sample_0.slope_x_1 = _S331;
    if(_S322.is_warp_2)
    {
        _S331 = _S346;
    }
    else
    {
        _S331 = _S345;
    }
    sample_0.slope_y_1 = _S331;
    sample_0.run_3 = _S327;
    sample_0.section_1 = _S328;
    return sample_0;
}

fn steps_per_length_0( _S347 : u32,  _S348 : SearchQuality_0,  _S349 : vec3<f32>) -> f32
{
    return max(max(abs(_S349.x) * fabrics_0[_S347].threads_per_x_0, abs(_S349.y) * fabrics_0[_S347].threads_per_y_0) * _S348.steps_per_thread_0, abs(_S349.z) * fabrics_0[_S347].per_relief_0 * _S348.steps_per_relief_0);
}

fn cell_maximum_0( _S350 : u32,  _S351 : Crossing_0) -> f32
{
    var _S352 : u32;
    if(_S351.warp_above_0)
    {
        _S352 = fabrics_0[_S350].warp_0;
    }
    else
    {
        _S352 = fabrics_0[_S350].weft_0;
    }
    var _S353 : u32;
    if(_S351.warp_above_0)
    {
        _S353 = _S351.warp_word_0;
    }
    else
    {
        _S353 = _S351.weft_word_0;
    }
    return f32((_S353 >> (u32(28)))) * families_0[_S352].height_scale_0 * families_0[_S352].level_0;
}

fn probe_0( _S354 : u32,  _S355 : f32,  _S356 : f32,  _S357 : bool,  _S358 : bool,  _S359 : bool) -> Probe_0
{
    var _S360 : Sample_0 = sample_at_0(_S354, _S355, _S356, _S357);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S360.height_6;
    probe_1.hole_4 = _S360.shown_3.hole_3;
    probe_1.slope_x_0 = _S360.slope_x_1;
    probe_1.slope_y_0 = _S360.slope_y_1;
    var _S361 : u32;
    if(_S360.shown_3.is_warp_2)
    {
        _S361 = _S360.crossing_2.warp_1.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S361 = _S360.crossing_2.weft_1.thread_0 * u32(2);
    }
    probe_1.yarn_1 = _S361;
    probe_1.cell_max_0 = cell_maximum_0(_S354, _S360.crossing_2);
    var _S362 : f32;
    if(_S358)
    {
        _S362 = _S360.crossing_2.warp_1.above_0;
    }
    else
    {
        _S362 = _S360.crossing_2.warp_1.below_0;
    }
    probe_1.side_x_0 = _S362;
    if(_S359)
    {
        _S362 = _S360.crossing_2.weft_1.above_0;
    }
    else
    {
        _S362 = _S360.crossing_2.weft_1.below_0;
    }
    probe_1.side_y_0 = _S362;
    probe_1.edge_x_0 = outline_distance_0(_S360.crossing_2.warp_1, _S360.shown_3, _S360.run_3, !_S360.shown_3.is_warp_2, _S358);
    probe_1.edge_y_0 = outline_distance_0(_S360.crossing_2.weft_1, _S360.shown_3, _S360.run_3, _S360.shown_3.is_warp_2, _S359);
    return probe_1;
}

fn is_free_0( _S363 : u32,  _S364 : SearchQuality_0,  _S365 : vec3<f32>,  _S366 : vec3<f32>,  _S367 : bool,  _S368 : f32) -> bool
{
    var _S369 : f32 = _S366.z;
    if(_S369 <= 0.0f)
    {
        return false;
    }
    var _S370 : f32 = 1.0f / max(_S364.shadow_share_0 * steps_per_length_0(_S363, _S364, _S366), 9.99999971718068537e-10f);
    var _S371 : StepControl_0 = step_control_0(_S366.xy, _S370);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_3 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S372 : bool;
        if(count_3 < u32(1024))
        {
            _S372 = (_S365.z + _S369 * distance_1) < _S368;
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
        var _S373 : vec3<f32> = _S365 + _S366 * vec3<f32>(distance_1);
        var _S374 : Probe_0 = probe_0(_S363, _S373.x, _S373.y, _S367, _S371.right_0, _S371.up_0);
        var _S375 : f32 = _S373.z;
        var _S376 : f32 = _S375 - _S374.height_3;
        var _S377 : f32 = _S369 - _S374.slope_x_0 * _S366.x - _S374.slope_y_0 * _S366.y;
        var _S378 : bool;
        if(!_S374.hole_4)
        {
            _S378 = _S376 < 0.0f;
        }
        else
        {
            _S378 = false;
        }
        if(_S378)
        {
            return false;
        }
        var _S379 : f32 = way_back_to_dip_0(previous_3, _S376, _S377, last_step_0, _S374);
        if(_S379 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S379;
            distance_1 = distance_1 - _S379;
            last_step_0 = last_step_1;
            count_3 = count_3 + u32(1);
            continue;
        }
        var _S380 : bool = _S375 > (_S374.cell_max_0);
        var _S381 : PreviousSample_0 = after_sample_0(_S376, _S377, _S374, _S380);
        var last_step_2 : f32;
        if(_S380)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S371, _S374.side_x_0, _S374.side_y_0), _S370);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S371, _S374, _S376, _S377);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S381;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_3 = count_3 + u32(1);
    }
    return true;
}

fn passes_through_0( _S382 : u32,  _S383 : SearchQuality_0,  _S384 : f32,  _S385 : f32,  _S386 : vec3<f32>,  _S387 : bool) -> bool
{
    if(!sample_at_0(_S382, _S384, _S385, _S387).shown_3.hole_3)
    {
        return false;
    }
    var _S388 : vec3<f32> = vec3<f32>(_S384, _S385, 0.0f);
    var passes_0 : bool = true;
    var side_0 : u32 = u32(0);
    for(;;)
    {
        var _S389 : bool;
        if(side_0 < u32(2))
        {
            _S389 = passes_0;
        }
        else
        {
            _S389 = false;
        }
        if(_S389)
        {
        }
        else
        {
            break;
        }
        var _S390 : vec3<f32>;
        if(side_0 == u32(0))
        {
            _S390 = _S386;
        }
        else
        {
            _S390 = vec3<f32>(- _S386.x, - _S386.y, _S386.z);
        }
        var _S391 : bool = is_free_0(_S382, _S383, _S388, _S390, _S387 != (side_0 == u32(1)), fabrics_0[_S382].height_high_0);
        var _S392 : u32 = side_0 + u32(1);
        passes_0 = _S391;
        side_0 = _S392;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_7 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S393 : u32,  _S394 : f32,  _S395 : f32,  _S396 : f32,  _S397 : vec3<f32>,  _S398 : bool) -> f32
{
    var _S399 : u32 = locate_0(fabrics_0[_S393].warp_0, _S394).thread_0 / u32(2);
    var _S400 : u32 = locate_0(fabrics_0[_S393].weft_0, _S395).thread_0 / u32(2);
    var _S401 : f32 = _S397.x;
    var _S402 : u32;
    if(_S401 > 0.0f)
    {
        _S402 = u32(1);
    }
    else
    {
        _S402 = u32(0);
    }
    var _S403 : f32 = _S397.y;
    var _S404 : u32;
    if(_S403 > 0.0f)
    {
        _S404 = u32(2);
    }
    else
    {
        _S404 = u32(0);
    }
    var _S405 : u32 = words_0[fabrics_0[_S393].max_heights_0 + u32(4) * (_S400 * fabrics_0[_S393].max_height_columns_0 + _S399) + (_S402 + _S404)];
    var number_0 : i32;
    if(_S398)
    {
        number_0 = i32(4);
    }
    else
    {
        number_0 = i32(0);
    }
    var _S406 : u32 = (_S405 >> (u32(number_0)));
    var _S407 : f32 = max(abs(_S401) * fabrics_0[_S393].threads_per_x_0, abs(_S403) * fabrics_0[_S393].threads_per_y_0) / _S397.z;
    var _S408 : f32 = fabrics_0[_S393].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S393].height_high_0;
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
        if(((max_height_0 - _S396) * _S407) <= (PYRAMID_RADII_0[number_0]))
        {
            max_height_0 = min(max_height_0, f32((((_S406 >> (u32(i32(8) * number_0)))) & (u32(15)))) * 0.06666667014360428f * _S408);
        }
        number_0 = number_0 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S409 : u32,  _S410 : f32,  _S411 : f32,  _S412 : bool,  _S413 : bool,  _S414 : bool) -> vec3<f32>
{
    var _S415 : Crossing_0 = crossing_at_0(_S409, _S410, _S411, _S412);
    var _S416 : f32 = cell_maximum_0(_S409, _S415);
    var _S417 : f32;
    if(_S413)
    {
        _S417 = _S415.warp_1.above_0;
    }
    else
    {
        _S417 = _S415.warp_1.below_0;
    }
    var _S418 : f32;
    if(_S414)
    {
        _S418 = _S415.weft_1.above_0;
    }
    else
    {
        _S418 = _S415.weft_1.below_0;
    }
    return vec3<f32>(_S416, _S417, _S418);
}

fn first_sample_height_0( _S419 : u32,  _S420 : ViewRay_0,  _S421 : StepControl_0,  _S422 : bool) -> f32
{
    var _S423 : f32 = max_height_along_0(_S419, _S420.origin_0.x, _S420.origin_0.y, 0.0f, vec3<f32>(_S420.slope_1, 1.0f), _S422);
    var count_4 : u32 = u32(0);
    var height_8 : f32 = _S423;
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S424 : vec2<f32> = ViewRay_at_0(_S420, height_8);
        var _S425 : vec3<f32> = cell_bounds_0(_S419, _S424.x, _S424.y, _S422, _S421.right_0, _S421.up_0);
        var _S426 : f32 = height_8 - _S425.x;
        var _S427 : f32 = StepControl_to_cell_exit_0(_S421, _S425.y, _S425.z);
        var height_9 : f32 = height_8 - clamp(_S426, 0.0f, _S427);
        if(_S426 <= _S427)
        {
            height_8 = height_9;
            break;
        }
        count_4 = count_4 + u32(1);
        height_8 = height_9;
    }
    return height_8;
}

fn search_down_0( _S428 : u32,  _S429 : ViewRay_0,  _S430 : StepControl_0,  _S431 : bool) -> ViewRayEnd_0
{
    var _S432 : f32 = fabrics_0[_S428].height_low_0 - (fabrics_0[_S428].height_high_0 - fabrics_0[_S428].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_7 = first_sample_height_0(_S428, _S429, _S430, _S431);
    end_1.last_step_3 = _S430.epsilon_0;
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
        var _S433 : vec2<f32> = ViewRay_at_0(_S429, end_1.height_7);
        var _S434 : Probe_0 = probe_0(_S428, _S433.x, _S433.y, _S431, _S430.right_0, _S430.up_0);
        var _S435 : f32 = end_1.height_7 - _S434.height_3;
        var _S436 : f32 = ViewRay_rate_0(_S429, _S434);
        end_1.depth_1 = - _S435;
        end_1.rate_4 = _S436;
        var _S437 : bool;
        if(end_1.previous_4.known_0)
        {
            _S437 = !_S434.hole_4;
        }
        else
        {
            _S437 = false;
        }
        var _S438 : bool;
        if(_S437)
        {
            _S438 = (end_1.previous_4.yarn_0) == (_S434.yarn_1);
        }
        else
        {
            _S438 = false;
        }
        end_1.smooth_0 = _S438;
        var _S439 : bool;
        if(!_S434.hole_4)
        {
            _S439 = _S435 <= 0.0f;
        }
        else
        {
            _S439 = false;
        }
        var _S440 : bool;
        if(_S439)
        {
            _S440 = true;
        }
        else
        {
            _S440 = (end_1.height_7) <= _S432;
        }
        if(_S440)
        {
            break;
        }
        var _S441 : f32 = way_back_to_dip_0(end_1.previous_4, _S435, _S436, end_1.last_step_3, _S434);
        if(_S441 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S441;
            end_1.last_step_3 = end_1.last_step_3 - _S441;
            count_5 = count_5 + u32(1);
            continue;
        }
        var _S442 : f32 = min(StepControl_to_cell_exit_0(_S430, _S434.side_x_0, _S434.side_y_0), end_1.height_7 - _S434.cell_max_0);
        var _S443 : f32 = StepControl_to_next_sample_0(_S430, _S434, _S435, _S436);
        end_1.previous_4 = after_sample_0(_S435, _S436, _S434, _S442 > _S443);
        var _S444 : f32 = max(_S442, _S443);
        end_1.last_step_3 = _S444;
        end_1.height_7 = end_1.height_7 - _S444;
        count_5 = count_5 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S445 : u32,  _S446 : ViewRay_0,  _S447 : StepControl_0,  _S448 : bool,  _S449 : ViewRayEnd_0,  _S450 : u32) -> f32
{
    var _S451 : f32 = fabrics_0[_S445].height_high_0 - fabrics_0[_S445].height_low_0;
    var above_2 : f32 = _S449.height_7 + _S449.last_step_3;
    var above_gap_1 : f32 = clamp(_S449.previous_4.clearance_0, 0.0f, _S451);
    var under_gap_1 : f32 = clamp(_S449.depth_1, 0.0f, _S451);
    var _S452 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S449.previous_4.rate_0 * _S449.last_step_3, _S449.rate_4 * _S449.last_step_3);
    var middle_0 : f32;
    if(_S449.smooth_0)
    {
        middle_0 = above_2 - _S452 * _S449.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S449.height_7, above_gap_1, under_gap_1);
    }
    var side_1 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S449.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S450)
        {
        }
        else
        {
            break;
        }
        var _S453 : vec2<f32> = ViewRay_at_0(_S446, middle_0);
        var _S454 : Probe_0 = probe_0(_S445, _S453.x, _S453.y, _S448, _S447.right_0, _S447.up_0);
        var _S455 : f32;
        if(_S454.hole_4)
        {
            _S455 = -1.0e+09f;
        }
        else
        {
            _S455 = _S454.height_3;
        }
        var _S456 : f32 = clamp(middle_0 - _S455, - _S451, _S451);
        var _S457 : f32;
        if(_S456 <= 0.0f)
        {
            if(side_1 > 0.0f)
            {
                _S457 = 0.5f * above_gap_2;
            }
            else
            {
                _S457 = above_gap_2;
            }
            var _S458 : f32 = - _S456;
            under_1 = middle_0;
            above_gap_2 = _S457;
            under_gap_2 = _S458;
            side_1 = 1.0f;
        }
        else
        {
            if(side_1 < 0.0f)
            {
                _S457 = 0.5f * under_gap_2;
            }
            else
            {
                _S457 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S456;
            under_gap_2 = _S457;
            side_1 = -1.0f;
        }
        if(_S449.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S456 / min(ViewRay_rate_0(_S446, _S454), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S449.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S459 : u32,  _S460 : SearchQuality_0,  _S461 : f32,  _S462 : f32,  _S463 : vec3<f32>,  _S464 : bool) -> Hit_0
{
    var _S465 : f32 = max(_S463.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S461, _S462);
    var _S466 : vec2<f32> = _S463.xy / vec2<f32>(_S465);
    ray_0.slope_1 = _S466;
    var _S467 : StepControl_0 = step_control_0((vec2<f32>(0) - _S466), 1.0f / max(steps_per_length_0(_S459, _S460, _S463) / _S465, 9.99999971718068537e-10f));
    var _S468 : ViewRayEnd_0 = search_down_0(_S459, ray_0, _S467, _S464);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S469 : f32 = refined_height_0(_S459, ray_0, _S467, _S464, _S468, _S460.refinements_0);
    hit_0.height_5 = _S469;
    var _S470 : vec2<f32> = ViewRay_at_0(ray_0, _S469);
    hit_0.x_13 = _S470.x;
    hit_0.y_7 = _S470.y;
    return hit_0;
}

fn first_hit_0( _S471 : u32,  _S472 : SearchQuality_0,  _S473 : f32,  _S474 : f32,  _S475 : vec3<f32>,  _S476 : bool) -> Hit_0
{
    if(!passes_through_0(_S471, _S472, _S473, _S474, _S475, _S476))
    {
        return first_hit_of_yarn_0(_S471, _S472, _S473, _S474, _S475, _S476);
    }
    var hit_1 : Hit_0;
    hit_1.x_13 = _S473;
    hit_1.y_7 = _S474;
    hit_1.height_5 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S477 : u32,  _S478 : f32,  _S479 : f32,  _S480 : bool) -> SurfacePoint_0
{
    var _S481 : Sample_0 = sample_at_0(_S477, _S478, _S479, _S480);
    var _S482 : f32;
    if(_S481.shown_3.is_warp_2)
    {
        _S482 = _S481.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S482 = _S481.crossing_2.weft_1.half_width_1;
    }
    var _S483 : u32;
    if(_S481.shown_3.is_warp_2)
    {
        _S483 = fabrics_0[_S477].warp_0;
    }
    else
    {
        _S483 = fabrics_0[_S477].weft_0;
    }
    var _S484 : Family_std430_0 = families_0[_S483];
    var _S485 : f32;
    if(_S480)
    {
        _S485 = -1.0f;
    }
    else
    {
        _S485 = 1.0f;
    }
    var _S486 : f32 = _S484.twist_sine_0 * _S485;
    var _S487 : Family_std430_0 = families_0[_S483];
    if(_S481.shown_3.is_warp_2)
    {
        _S485 = 1.0f;
    }
    else
    {
        _S485 = -1.0f;
    }
    var _S488 : vec2<f32> = fibre_direction_0(_S481.slope_across_0, _S485 * _S481.slope_along_0, _S486, _S487.twist_cosine_0);
    var _S489 : f32;
    if(_S481.shown_3.is_warp_2)
    {
        _S489 = _S481.slope_x_1;
    }
    else
    {
        _S489 = _S481.slope_y_1;
    }
    var _S490 : f32;
    if(_S481.shown_3.is_warp_2)
    {
        _S490 = _S481.slope_y_1;
    }
    else
    {
        _S490 = _S481.slope_x_1;
    }
    var _S491 : f32 = _S488.x;
    var _S492 : f32 = _S488.y;
    var _S493 : f32 = _S489 * _S491 + _S485 * _S490 * _S492;
    var _S494 : f32 = _S482 * 1.0154266357421875f;
    var _S495 : f32 = _S494 * arc_sine_0(clamp(_S481.section_1.across_3 / _S494, -1.0f, 1.0f));
    if(_S481.shown_3.is_warp_2)
    {
        _S482 = _S479;
    }
    else
    {
        _S482 = - _S478;
    }
    var point_2 : SurfacePoint_0;
    point_2.hole_0 = _S481.shown_3.hole_3;
    point_2.is_warp_0 = _S481.shown_3.is_warp_2;
    point_2.warp_thread_0 = _S481.crossing_2.warp_1.thread_0;
    point_2.weft_thread_0 = _S481.crossing_2.weft_1.thread_0;
    point_2.height_1 = _S481.height_6;
    point_2.normal_1 = normalize(vec3<f32>(- _S481.slope_x_1, - _S481.slope_y_1, 1.0f));
    var _S496 : vec3<f32>;
    if(_S481.shown_3.is_warp_2)
    {
        _S496 = vec3<f32>(_S491, _S492, _S493);
    }
    else
    {
        _S496 = vec3<f32>(- _S492, _S491, _S493);
    }
    point_2.tangent_0 = normalize(_S496);
    point_2.across_0 = _S481.section_1.across_3;
    point_2.fibre_across_0 = _S495 * _S487.twist_cosine_0 + _S482 * _S486;
    point_2.fibre_along_0 = _S482 * _S487.twist_cosine_0 - _S495 * _S486;
    return point_2;
}

struct YarnPoint_0
{
     back_3 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_14 : f32,
     y_8 : f32,
     height_10 : f32,
     normal_7 : vec3<f32>,
     tangent_7 : vec3<f32>,
     roughness_10 : f32,
     albedos_5 : Albedos_0,
};

fn vary_albedos_0( _S497 : u32,  _S498 : Albedos_0,  _S499 : u32,  _S500 : u32) -> Albedos_0
{
    var _S501 : vec3<f32> = max(_S498.specular_reflect_0, _S498.specular_transmit_0);
    var _S502 : vec3<f32> = _S498.diffuse_reflect_0 + _S498.diffuse_transmit_0;
    var _S503 : vec3<f32> = vec3<f32>(fabrics_0[_S497].layer_bound_0);
    var _S504 : vec3<f32> = vec3<f32>(1.0f);
    var _S505 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S499, fabrics_0[_S497].colour_noise_0, fabrics_0[_S497].seed_0), _S502, _S504 - _S503 * _S501));
    var _S506 : f32 = bounded_gain_0(fibre_gain_0(_S499, _S500, fabrics_0[_S497].fibre_noise_0, fabrics_0[_S497].seed_0), _S501, min((_S504 - _S505 * _S502) / _S503, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S505 * _S498.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S505 * _S498.diffuse_transmit_0;
    var _S507 : vec3<f32> = vec3<f32>(_S506);
    varied_0.specular_reflect_0 = _S507 * _S498.specular_reflect_0;
    varied_0.specular_transmit_0 = _S507 * _S498.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S508 : u32,  _S509 : SurfacePoint_0,  _S510 : Albedos_0,  _S511 : f32,  _S512 : f32) -> Albedos_0
{
    var _S513 : f32;
    if(_S509.is_warp_0)
    {
        _S513 = _S511;
    }
    else
    {
        _S513 = _S512;
    }
    var _S514 : f32 = _S513 - _S509.across_0;
    var _S515 : u32;
    if(_S509.is_warp_0)
    {
        _S515 = fabrics_0[_S508].warp_0;
    }
    else
    {
        _S515 = fabrics_0[_S508].weft_0;
    }
    var _S516 : Family_std430_0 = families_0[_S515];
    var _S517 : i32 = i32(families_0[_S515].count_0);
    if(_S509.is_warp_0)
    {
        _S515 = _S509.warp_thread_0;
    }
    else
    {
        _S515 = _S509.weft_thread_0;
    }
    var _S518 : u32 = u32(i32(floor(_S514 / _S516.period_0)) * _S517 + i32(_S515)) * u32(2);
    if(_S509.is_warp_0)
    {
        _S515 = u32(1);
    }
    else
    {
        _S515 = u32(0);
    }
    var _S519 : f32 = floor(_S509.fibre_across_0 / fabrics_0[_S508].fibre_size_0);
    return vary_albedos_0(_S508, _S510, _S518 + _S515, u32(i32(_S519)) * u32(65536) + u32(i32(floor(_S509.fibre_along_0 / (fabrics_0[_S508].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S519))));
}

fn yarn_point_of_0( _S520 : u32,  _S521 : SurfacePoint_0,  _S522 : f32,  _S523 : f32,  _S524 : bool,  _S525 : bool) -> YarnPoint_0
{
    var _S526 : u32;
    if(_S521.is_warp_0)
    {
        _S526 = fabrics_0[_S520].warp_0;
    }
    else
    {
        _S526 = fabrics_0[_S520].weft_0;
    }
    var _S527 : u32;
    if(_S521.is_warp_0)
    {
        _S527 = _S521.warp_thread_0;
    }
    else
    {
        _S527 = _S521.weft_thread_0;
    }
    var albedos_6 : Albedos_0 = albedos_of_0(_S526, _S527);
    var _S528 : bool;
    if((fabrics_0[_S520].fibre_noise_0) > 0.0f)
    {
        _S528 = true;
    }
    else
    {
        _S528 = (fabrics_0[_S520].colour_noise_0) > 0.0f;
    }
    var albedos_7 : Albedos_0;
    if(_S528)
    {
        albedos_7 = varied_at_0(_S520, _S521, albedos_6, _S522, _S523);
    }
    else
    {
        albedos_7 = albedos_6;
    }
    var point_3 : YarnPoint_0;
    point_3.back_3 = _S524;
    point_3.hole_6 = _S525;
    point_3.is_warp_3 = _S521.is_warp_0;
    point_3.x_14 = _S522;
    point_3.y_8 = _S523;
    point_3.height_10 = _S521.height_1;
    point_3.normal_7 = _S521.normal_1;
    point_3.tangent_7 = _S521.tangent_0;
    point_3.roughness_10 = families_0[_S526].roughness_0;
    point_3.albedos_5 = albedos_7;
    return point_3;
}

fn unoccluded_0( _S529 : u32,  _S530 : SearchQuality_0,  _S531 : f32,  _S532 : f32,  _S533 : f32,  _S534 : vec3<f32>,  _S535 : bool) -> bool
{
    if((_S534.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S529, _S530, vec3<f32>(_S531, _S532, _S533 + fabrics_0[_S529].lift_0), _S534, _S535, max_height_along_0(_S529, _S531, _S532, _S533, _S534, _S535));
}

fn is_lit_0( _S536 : u32,  _S537 : SearchQuality_0,  _S538 : YarnPoint_0,  _S539 : vec3<f32>) -> bool
{
    if(_S538.hole_6)
    {
        return true;
    }
    var _S540 : vec3<f32> = to_face_frame_0(_S539, _S538.back_3);
    var _S541 : f32 = _S540.z;
    var _S542 : bool = _S541 < 0.0f;
    var normal_8 : vec3<f32>;
    var height_11 : f32;
    if(_S542)
    {
        var _S543 : SurfacePoint_0 = surface_at_0(_S536, _S538.x_14, _S538.y_8, !_S538.back_3);
        normal_8 = _S543.normal_1;
        height_11 = _S543.height_1;
    }
    else
    {
        normal_8 = _S538.normal_7;
        height_11 = _S538.height_10;
    }
    var _S544 : vec3<f32> = vec3<f32>(_S540.xy, abs(_S541));
    if((dot(normal_8, _S544)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S536, _S537, _S538.x_14, _S538.y_8, height_11, _S544, (_S538.back_3) != _S542);
}

fn components_of_point_0( _S545 : u32,  _S546 : SearchQuality_0,  _S547 : YarnPoint_0,  _S548 : vec3<f32>,  _S549 : vec3<f32>) -> Components_0
{
    var result_1 : Components_0 = no_components_0();
    var _S550 : f32;
    if(_S547.hole_6)
    {
        _S550 = 1.0f;
    }
    else
    {
        _S550 = 0.0f;
    }
    result_1.hole_2 = _S550;
    var _S551 : bool;
    if(_S547.hole_6)
    {
        _S551 = true;
    }
    else
    {
        _S551 = !is_lit_0(_S545, _S546, _S547, _S548);
    }
    if(_S551)
    {
        return result_1;
    }
    var _S552 : vec3<f32> = to_face_frame_0(_S548, _S547.back_3);
    var _S553 : vec3<f32> = to_face_frame_0(_S549, _S547.back_3);
    var _S554 : bool = (_S552.z) < 0.0f;
    var _S555 : vec3<f32>;
    if(_S554)
    {
        _S555 = (vec3<f32>(0) - _S552);
    }
    else
    {
        _S555 = _S552;
    }
    var _S556 : f32 = diffuse_reflection_0(_S555, _S547.normal_7, fabrics_0[_S545].diffuse_blend_0);
    if(_S554)
    {
        _S550 = transmission_0(_S552, _S553, _S547.normal_7, _S547.tangent_7, _S547.roughness_10, fabrics_0[_S545].optical_depth_0);
    }
    else
    {
        _S550 = reflection_0(_S552, _S553, _S547.normal_7, _S547.tangent_7, _S547.roughness_10, fabrics_0[_S545].optical_depth_0);
    }
    var _S557 : f32;
    if(_S547.is_warp_3)
    {
        _S557 = _S556;
    }
    else
    {
        _S557 = 0.0f;
    }
    result_1.diffuse_warp_0 = _S557;
    if(_S547.is_warp_3)
    {
        _S557 = 0.0f;
    }
    else
    {
        _S557 = _S556;
    }
    result_1.diffuse_weft_0 = _S557;
    if(_S547.is_warp_3)
    {
        _S557 = _S550;
    }
    else
    {
        _S557 = 0.0f;
    }
    result_1.specular_warp_0 = _S557;
    if(_S547.is_warp_3)
    {
        _S550 = 0.0f;
    }
    result_1.specular_weft_0 = _S550;
    result_1.light_visibility_1 = 1.0f;
    return result_1;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S558 : u32,  _S559 : f32) -> vec3<f32>
{
    var _S560 : u32 = fabrics_0[_S558].lobes_0.levels_0 + u32(4) * u32(min(_S559, fabrics_0[_S558].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S560), table_number_0(_S560 + u32(1)), table_number_0(_S560 + u32(2)));
}

fn coverage_taps_0( _S561 : u32,  _S562 : Footprint_0,  _S563 : bool) -> CoverageTaps_0
{
    var _S564 : Lobes_std430_0 = fabrics_0[_S561].lobes_0;
    var _S565 : f32 = Footprint_spread_side_0(_S562) * fabrics_0[_S561].lobes_0.inverse_base_size_0;
    var _S566 : vec3<f32> = pyramid_level_0(_S561, floor(binary_logarithm_0(max(0.68000000715255737f * _S565, 1.0f))));
    var _S567 : f32 = 1.0f / max(_S565, 9.99999997475242708e-07f);
    var _S568 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S561].warp_0].inverse_period_0, families_0[fabrics_0[_S561].weft_0].inverse_period_0);
    var _S569 : vec2<f32> = _S562.centre_0 * _S568;
    var _S570 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S567 * _S567), 0.0f, 1.0f)), 0.3333333432674408f * _S567), 1.0f));
    var _S571 : vec2<f32> = _S562.dx_0 * _S568 * _S570;
    var _S572 : vec2<f32> = _S562.dy_0 * _S568 * _S570;
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
        var _S573 : vec2<f32> = _S569 + vec2<f32>(TAP_OFFSETS_0[number_1].x) * _S571 + vec2<f32>(TAP_OFFSETS_0[number_1].y) * _S572;
        var _S574 : f32 = _S566.y;
        var _S575 : f32 = wrapped_cell_0(_S573.x, _S574);
        var _S576 : f32 = wrapped_cell_0(_S573.y, _S566.z);
        var _S577 : u32;
        if(_S563)
        {
            _S577 = _S564.face_nodes_0;
        }
        else
        {
            _S577 = u32(0);
        }
        taps_3.nodes_1[number_1] = _S577 + u32(_S576 * _S574 + _S575 + _S566.x);
        number_1 = number_1 + u32(1);
    }
    return taps_3;
}

fn coverage_of_pack_0( _S578 : u32,  _S579 : CoverageTaps_0,  _S580 : u32) -> vec4<f32>
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
        var _S581 : u32 = words_0[fabrics_0[_S578].lobes_0.coverage_0 + _S579.nodes_1[number_2] * fabrics_0[_S578].lobes_0.packs_0 + _S580];
        var even_2 : u32 = even_1 + ((_S581 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S581 >> (u32(8)))) & (u32(16711935))));
        number_2 = number_2 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S582 : u32,  _S583 : CoverageTaps_0) -> f32
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
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S582].lobes_0.coverage_holes_0 + _S583.nodes_1[number_3] / u32(4)] >> ((u32(8) * (_S583.nodes_1[number_3] % u32(4)))))) & (u32(255))));
        number_3 = number_3 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S584 : u32,  _S585 : CoverageTaps_0,  _S586 : NodeTaps_0,  _S587 : bool) -> f32
{
    var _S588 : Lobes_std430_0 = fabrics_0[_S584].lobes_0;
    var _S589 : f32 = interpolate_table_0(_S586, fabrics_0[_S584].lobes_0.projected_area_0 + fabrics_0[_S584].lobes_0.packs_0, fabrics_0[_S584].lobes_0.packs_0 + u32(1)).x;
    var _S590 : f32;
    if(_S587)
    {
        _S590 = _S588.back_hole_weight_0;
    }
    else
    {
        _S590 = _S588.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S584, _S585) * _S589 * _S589 * _S590, 1.0f);
}

fn prefiltered_components_0( _S591 : u32,  _S592 : Footprint_0,  _S593 : vec3<f32>,  _S594 : vec3<f32>,  _S595 : bool) -> Components_0
{
    var _S596 : CoverageTaps_0 = coverage_taps_0(_S591, _S592, _S595);
    var _S597 : NodeTaps_0 = node_taps_0(_S594);
    var view_nodes_0 : NodeTaps_0 = _S597;
    var light_nodes_0 : NodeTaps_0 = node_taps_0(_S593);
    var seen_nodes_0 : NodeTaps_0 = _S597;
    var _S598 : u32;
    if(_S595)
    {
        _S598 = u32(1);
    }
    else
    {
        _S598 = u32(0);
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S598 * u32(256)));
    var _S599 : u32 = u32(2) * _S598;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + vec4<u32>((_S599 * u32(256)));
    var _S600 : u32;
    if((_S593.z) < 0.0f)
    {
        _S600 = u32(1);
    }
    else
    {
        _S600 = u32(0);
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((_S599 + _S600) * u32(256)));
    var _S601 : vec3<f32> = half_vector_0(_S593, _S594);
    var _S602 : vec3<f32> = shadow_correlation_0(_S593, _S594);
    if(_S595)
    {
        _S600 = fabrics_0[_S591].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S600 = fabrics_0[_S591].lobes_0.front_warp_packs_0;
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
        var _S603 : Lobes_std430_0 = fabrics_0[_S591].lobes_0;
        if(pack_0 < (fabrics_0[_S591].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S604 : vec4<f32> = coverage_of_pack_0(_S591, _S596, pack_0);
        var _S605 : vec4<f32> = interpolate_table_0(view_nodes_0, _S603.projected_area_0 + pack_0, _S603.packs_0 + u32(1));
        var _S606 : u32 = _S603.light_visibility_0 + pack_0;
        var _S607 : vec4<f32> = vec4<f32>(255.0f);
        var _S608 : vec4<f32> = interpolate_table_0(seen_nodes_0, _S606, _S603.packs_0) / _S607;
        var _S609 : vec4<f32> = interpolate_table_0(light_nodes_0, _S606, _S603.packs_0) / _S607;
        var _S610 : vec4<f32> = interpolate_table_0(light_nodes_0, _S603.irradiance_0 + pack_0, _S603.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S611 : bool = pack_0 < _S600;
        var _S612 : u32;
        if(_S611)
        {
            _S612 = fabrics_0[_S591].warp_0;
        }
        else
        {
            _S612 = fabrics_0[_S591].weft_0;
        }
        var _S613 : Family_std430_0 = families_0[_S612];
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
            var _S614 : Group_0 = group_at_0(_S603.moments_0 + u32(12) * (u32(4) * (_S598 * _S603.packs_0 + pack_0) + number_4), _S613.roughness_0);
            var _S615 : f32 = _S604[number_4] * _S605[number_4] * _S605[number_4] * _S614.weight_1;
            var _S616 : vec2<f32> = visibility_gain_0(_S602, _S609[number_4], _S608[number_4]);
            var _S617 : f32 = _S616.x;
            var diffuse_1 : f32 = diffuse_0 + _S615 * _S610[number_4] * _S617;
            var specular_1 : f32 = specular_0 + _S615 * layer_value_0(_S614, _S601, _S593, _S594, fabrics_0[_S591].optical_depth_0) * _S609[number_4] * _S616.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S615 * _S609[number_4] * _S617;
            var total_3 : f32 = total_2 + _S615;
            number_4 = number_4 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        var _S618 : f32;
        if(_S611)
        {
            _S618 = diffuse_0;
        }
        else
        {
            _S618 = 0.0f;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S618;
        var _S619 : f32;
        if(_S611)
        {
            _S619 = 0.0f;
        }
        else
        {
            _S619 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S619;
        var _S620 : f32;
        if(_S611)
        {
            _S620 = specular_0;
        }
        else
        {
            _S620 = 0.0f;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S620;
        var _S621 : f32;
        if(_S611)
        {
            _S621 = 0.0f;
        }
        else
        {
            _S621 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S621;
        pack_0 = pack_0 + u32(1);
    }
    var _S622 : f32 = prefiltered_hole_0(_S591, _S596, view_nodes_0, _S595);
    sums_1.hole_2 = _S622;
    var _S623 : f32 = (1.0f - _S622) / max(total_2, 9.999999960041972e-13f);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S623;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S623;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S623;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S623;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S623;
    return sums_1;
}

fn albedos_over_0( _S624 : u32,  _S625 : Footprint_0,  _S626 : bool) -> FamilyAlbedos_0
{
    var _S627 : vec2<f32> = _S625.dx_0;
    var _S628 : vec2<f32> = _S625.dy_0;
    var _S629 : vec2<f32> = sqrt(_S627 * _S627 + _S628 * _S628);
    var _S630 : Stretch_0 = stretch_of_0(fabrics_0[_S624].warp_0, _S625.centre_0.x, _S629.x);
    var _S631 : Stretch_0 = stretch_of_0(fabrics_0[_S624].weft_0, _S625.centre_0.y, _S629.y);
    var albedos_8 : FamilyAlbedos_0;
    albedos_8.warp_2 = mean_albedos_0(fabrics_0[_S624].warp_0, fabrics_0[_S624].weft_0, _S630, _S631, _S626);
    albedos_8.weft_2 = mean_albedos_0(fabrics_0[_S624].weft_0, fabrics_0[_S624].warp_0, _S631, _S630, _S626);
    return albedos_8;
}

fn lobes_estimate_0( _S632 : u32,  _S633 : Footprint_0,  _S634 : f32,  _S635 : vec3<f32>,  _S636 : vec3<f32>) -> Estimate_0
{
    var _S637 : f32;
    var _S638 : Regime_0 = regime_of_0(_S632, _S633, _S634);
    var _S639 : bool = (_S636.z) < 0.0f;
    var _S640 : vec3<f32> = to_face_frame_0(_S636, _S639);
    var _S641 : bool;
    if((fabrics_0[_S632].fibre_noise_0) > 0.0f)
    {
        _S641 = true;
    }
    else
    {
        _S641 = (fabrics_0[_S632].colour_noise_0) > 0.0f;
    }
    var _S642 : bool;
    if((families_0[fabrics_0[_S632].warp_0].quantities_0) > u32(1))
    {
        _S642 = true;
    }
    else
    {
        _S642 = (families_0[fabrics_0[_S632].weft_0].quantities_0) > u32(1);
    }
    var _S643 : f32 = 1.0f - _S638.prefiltered_0;
    if(_S643 > 0.0f)
    {
        if(_S641)
        {
            _S642 = true;
        }
    }
    else
    {
        _S642 = false;
    }
    var box_0 : Footprint_0 = _S633;
    var _S644 : vec3<f32> = vec3<f32>(0.0f);
    var _S645 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S644, _S644, 0.0f, 0.0f, 0.0f);
    var _S646 : Components_0 = no_components_0();
    var _S647 : i32;
    if(_S642)
    {
        _S647 = i32(0);
    }
    else
    {
        _S647 = i32(1);
    }
    var _S648 : u32 = u32(_S647);
    var points_1 : Components_0 = _S646;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S645;
    var central_place_0 : vec2<f32> = _S633.centre_0;
    var number_5 : u32 = _S648;
    for(;;)
    {
        var _S649 : f32 = f32(number_5);
        _S637 = _S638.points_0;
        if(_S649 < (_S638.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S650 : bool = number_5 == u32(0);
        var _S651 : vec2<f32>;
        if(_S650)
        {
            _S651 = vec2<f32>(0.0f);
        }
        else
        {
            _S651 = POINT_OFFSETS_0[number_5 - u32(1)];
        }
        var _S652 : vec2<f32> = _S633.centre_0 + vec2<f32>(_S651.x) * _S633.dx_0 + vec2<f32>(_S651.y) * _S633.dy_0;
        var _S653 : f32;
        if(_S650)
        {
            _S653 = 0.0f;
        }
        else
        {
            _S653 = _S638.threads_1;
        }
        var _S654 : SearchQuality_0 = quality_of_0(_S653);
        var _S655 : Hit_0 = first_hit_0(_S632, _S654, _S652.x, _S652.y, _S640, _S639);
        var _S656 : SurfacePoint_0 = surface_at_0(_S632, _S655.x_13, _S655.y_7, _S639);
        if(_S650)
        {
            var central_weight_1 : f32;
            if(_S655.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S643;
            }
            var central_place_1 : vec2<f32> = vec2<f32>(_S655.x_13, _S655.y_7);
            box_0.centre_0 = mix(_S633.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S656;
            central_place_0 = central_place_1;
            number_5 = number_5 + u32(1);
            continue;
        }
        points_1 = with_added_0(points_1, components_of_point_0(_S632, _S654, yarn_point_of_0(_S632, _S656, _S655.x_13, _S655.y_7, _S639, _S655.hole_5), _S635, _S636), min(_S638.points_0 - f32(number_5 - u32(1)), 1.0f));
        number_5 = number_5 + u32(1);
    }
    var estimate_0 : Estimate_0;
    estimate_0.components_0 = with_added_0(_S646, points_1, _S643 / max(_S637, 1.0f));
    if((_S638.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S632, _S633, to_face_frame_0(_S635, _S639), _S640, _S639), _S638.prefiltered_0);
    }
    estimate_0.albedos_4 = albedos_over_0(_S632, box_0, _S639);
    if(_S641)
    {
        _S641 = central_weight_0 > 0.0f;
    }
    else
    {
        _S641 = false;
    }
    if(_S641)
    {
        var _S657 : SurfacePoint_0 = central_0;
        var _S658 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S658 = estimate_0.albedos_4.warp_2;
        }
        else
        {
            _S658 = estimate_0.albedos_4.weft_2;
        }
        var _S659 : Albedos_0 = lerp_albedos_0(_S658, varied_at_0(_S632, central_0, _S658, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S657.is_warp_0)
        {
            estimate_0.albedos_4.warp_2 = _S659;
        }
        else
        {
            estimate_0.albedos_4.weft_2 = _S659;
        }
    }
    return estimate_0;
}

fn composed_0( _S660 : u32,  _S661 : Components_0,  _S662 : FamilyAlbedos_0,  _S663 : vec3<f32>,  _S664 : vec3<f32>) -> vec3<f32>
{
    var _S665 : vec3<f32> = vec3<f32>(_S661.diffuse_warp_0);
    var _S666 : vec3<f32> = vec3<f32>(_S661.diffuse_weft_0);
    var _S667 : vec3<f32> = vec3<f32>(_S661.specular_warp_0);
    var _S668 : vec3<f32> = vec3<f32>(_S661.specular_weft_0);
    var _S669 : vec3<f32> = _S662.warp_2.diffuse_reflect_0 * _S665 + _S662.weft_2.diffuse_reflect_0 * _S666 + _S662.warp_2.specular_reflect_0 * _S667 + _S662.weft_2.specular_reflect_0 * _S668;
    var _S670 : f32 = _S664.z;
    var body_0 : vec3<f32>;
    if((_S663.z * _S670) < 0.0f)
    {
        body_0 = _S662.warp_2.diffuse_transmit_0 * _S665 + _S662.weft_2.diffuse_transmit_0 * _S666 + _S662.warp_2.specular_transmit_0 * _S667 + _S662.weft_2.specular_transmit_0 * _S668;
    }
    else
    {
        body_0 = _S669;
    }
    var _S671 : f32 = fabrics_0[_S660].sheen_strength_0;
    if((fabrics_0[_S660].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S672 : bool = _S670 < 0.0f;
    var _S673 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S663, _S672), to_face_frame_0(_S664, _S672), _S671, fabrics_0[_S660].sheen_roughness_0);
    return vec3<f32>(_S673.y) * body_0 + vec3<f32>(((_S661.light_visibility_1 + _S661.hole_2) * _S673.x));
}

fn light_of_footprint_0( _S674 : ptr<function, Frame_std430_0>,  _S675 : u32,  _S676 : VisiblePoint_0) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S676.draft_0;
    footprint_0.dx_0 = _S676.draft_dx_0;
    footprint_0.dy_0 = _S676.draft_dy_0;
    var _S677 : vec3<f32> = to_local_0(_S676, _S676.view_0);
    var _S678 : vec3<f32> = vec3<f32>(0.0f);
    var number_6 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S678;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        var _S679 : u32 = (*_S674).lights_0;
        if(number_6 < (max((*_S674).lights_0, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S680 : Light_std430_0 = lights_1[number_6];
        var irradiance_2 : vec3<f32>;
        var _S681 : vec3<f32> = towards_light_0(&(_S680), _S676.position_0, &(irradiance_2));
        var _S682 : vec3<f32> = to_local_0(_S676, _S681);
        var _S683 : Estimate_0 = lobes_estimate_0(_S675, footprint_0, 1.0f, _S682, _S677);
        if(number_6 < _S679)
        {
            radiance_1 = radiance_1 + irradiance_2 * composed_0(_S675, _S683.components_0, _S683.albedos_4, _S682, _S677);
        }
        number_6 = number_6 + u32(1);
        hole_7 = _S683.components_0.hole_2;
    }
    var _S684 : f32 = fabrics_0[_S675].sheen_strength_0;
    if((fabrics_0[_S675].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S684 * sheen_lobe_0(abs(_S677.z), fabrics_0[_S675].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S685 : Frame_std430_0 = frames_0[i32(0)];
    var _S686 : bool;
    if((id_0.x) >= (_S685.width_0))
    {
        _S686 = true;
    }
    else
    {
        _S686 = (id_0.y) >= (_S685.height_0);
    }
    if(_S686)
    {
        return;
    }
    var _S687 : vec2<u32> = id_0.xy;
    var _S688 : vec3<i32> = vec3<i32>(vec2<i32>(_S687), i32(0));
    var _S689 : u32 = (textureLoad((visible_faces_0), ((_S688)).xy, ((_S688)).z).x);
    var _S690 : vec4<f32> = vec4<f32>(0.0f);
    var sum_1 : vec4<f32>;
    if(_S689 > u32(0))
    {
        var _S691 : u32 = _S689 - u32(1);
        var _S692 : u32 = face_fabrics_0[_S691];
        var _S693 : VisiblePoint_0 = visible_point_0(&(_S685), _S692, _S691, _S687);
        var _S694 : vec4<f32> = light_of_footprint_0(&(_S685), _S692, _S693);
        sum_1 = _S694;
    }
    else
    {
        sum_1 = _S690;
    }
    accumulate_0(&(_S685), _S687, sum_1);
    return;
}

