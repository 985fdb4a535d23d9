struct Frame_std430_0
{
    @align(4) width_0 : u32,
    @align(4) height_0 : u32,
    @align(4) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(4) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(4) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(4) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(4) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(4) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(4) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(4) ray_offset_0 : f32,
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

struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(12) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

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

@binding(11) @group(0) var<storage, read> scene_words_0 : array<u32>;

@binding(13) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

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

fn position_of_1( vertex_1 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_1).x_0, (*vertex_1).y_0, (*vertex_1).z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_2 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_2).normal_x_0, (*vertex_2).normal_y_0, (*vertex_2).normal_z_0);
}

fn square_1( x_3 : f32) -> f32
{
    return x_3 * x_3;
}

fn natural_logarithm_0( x_4 : f32) -> f32
{
    var _S1 : u32 = (bitcast<u32>((x_4)));
    var exponent_0 : f32 = f32(i32((_S1 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((_S1 & (u32(8388607)))) | (u32(1056964608))))));
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
    var _S2 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * _S2 - exponent_1 * 0.00021219444170129f - 0.5f * _S2) + exponent_1 * 0.693359375f;
}

fn binary_logarithm_0( x_5 : f32) -> f32
{
    return natural_logarithm_0(x_5) * 1.4426950216293335f;
}

fn exponential_0( x_6 : f32) -> f32
{
    var _S3 : f32 = clamp(x_6, -87.0f, 88.0f);
    var _S4 : f32 = floor(_S3 * 1.4426950216293335f + 0.5f);
    var _S5 : f32 = _S3 - _S4 * 0.693359375f + _S4 * 0.00021219444170129f;
    var p_0 : f32 = ((((0.00019875691214111f * _S5 + 0.00139819993637502f) * _S5 + 0.00833345204591751f) * _S5 + 0.04166579619050026f) * _S5 + 0.1666666567325592f) * _S5 + 0.5f;
    var _S6 : f32 = (bitcast<f32>(((u32(i32(_S4) + i32(127)) << (u32(23))))));
    var _S7 : f32;
    if(x_6 < -87.0f)
    {
        _S7 = 0.0f;
    }
    else
    {
        _S7 = (p_0 * _S5 * _S5 + _S5 + 1.0f) * _S6;
    }
    return _S7;
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S8 : u32 = scene_words_0[index_0];
    var _S9 : vec3<f32> = vec3<f32>(f32((_S8 & (u32(1023)))), f32((((_S8 >> (u32(10)))) & (u32(1023)))), f32((_S8 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S9 * _S9;
}

fn map_level_0( first_0 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S10 : f32 = uv_0.x;
    var _S11 : f32 = f32(side_0);
    var _S12 : f32 = (_S10 - floor(_S10)) * _S11 - 0.5f;
    var _S13 : f32 = uv_0.y;
    var _S14 : f32 = (_S13 - floor(_S13)) * _S11 - 0.5f;
    var _S15 : f32 = floor(_S12);
    var _S16 : i32 = i32(side_0);
    var _S17 : u32 = side_0 - u32(1);
    var _S18 : u32 = (u32(i32(_S15) + _S16) & (_S17));
    var _S19 : f32 = floor(_S14);
    var _S20 : u32 = (u32(i32(_S19) + _S16) & (_S17));
    var _S21 : u32 = ((_S18 + u32(1)) & (_S17));
    var _S22 : u32 = first_0 + _S20 * side_0;
    var _S23 : vec3<f32> = vec3<f32>((_S12 - _S15));
    var _S24 : u32 = first_0 + (((_S20 + u32(1)) & (_S17))) * side_0;
    return mix(mix(map_texel_0(_S22 + _S18), map_texel_0(_S22 + _S21), _S23), mix(map_texel_0(_S24 + _S18), map_texel_0(_S24 + _S21), _S23), vec3<f32>((_S14 - _S19)));
}

struct VisiblePoint_0
{
     position_0 : vec3<f32>,
     view_0 : vec3<f32>,
     axis_x_0 : vec3<f32>,
     axis_y_0 : vec3<f32>,
     normal_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     uv_1 : vec2<f32>,
     draft_per_uv_0 : vec2<f32>,
     draft_0 : vec2<f32>,
     draft_dx_0 : vec2<f32>,
     draft_dy_0 : vec2<f32>,
};

fn to_local_0( point_0 : VisiblePoint_0,  direction_0 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(direction_0, point_0.axis_x_0), dot(direction_0, point_0.axis_y_0), dot(direction_0, point_0.normal_0));
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S25 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S26 : u32 = ((((_S25 >> ((((_S25 >> (u32(28)))) + u32(4))))) ^ (_S25))) * u32(277803737);
    return (((_S26 >> (u32(22)))) ^ (_S26));
}

fn uniform_hash_0( thread_0 : u32,  cell_0 : u32,  stream_0 : u32) -> f32
{
    return (f32(((scramble_0(cell_0 + scramble_0(thread_0 + scramble_0(stream_0)))) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_1 : u32,  stream_1 : u32) -> vec2<f32>
{
    var _S27 : u32 = pixel_0.x;
    var _S28 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S27, _S28, stream_1), uniform_hash_0(_S27, _S28, stream_1 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_2 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_2])));
}

struct Choice_0
{
     index_3 : u32,
     remainder_0 : f32,
};

fn choose_0( table_0 : u32,  count_1 : u32,  number_0 : f32) -> Choice_0
{
    var high_0 : u32 = count_1;
    var low_0 : u32 = u32(0);
    for(;;)
    {
        if((high_0 - low_0) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S29 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S29)) <= number_0)
        {
            low_0 = _S29;
        }
        else
        {
            high_0 = _S29;
        }
    }
    var _S30 : u32 = table_0 + low_0;
    var _S31 : f32 = scene_number_0(_S30);
    var _S32 : f32 = scene_number_0(_S30 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_3 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S31) / max(_S32 - _S31, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S33 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S34 : f32 = x_7 - _S33 * 1.5703125f - _S33 * 0.00048375129699707f - _S33 * 7.54979012640433211e-08f;
    var _S35 : f32 = _S34 * _S34;
    var _S36 : f32 = ((-0.00019515295571182f * _S35 + 0.00833216123282909f) * _S35 - 0.16666655242443085f) * _S35 * _S34 + _S34;
    var _S37 : f32 = ((0.00002443315679557f * _S35 - 0.00138873164542019f) * _S35 + 0.04166664555668831f) * _S35 * _S35 - 0.5f * _S35 + 1.0f;
    var _S38 : u32 = (u32(i32(_S33)) & (u32(3)));
    var _S39 : vec2<f32>;
    if(((_S38 & (u32(1)))) != u32(0))
    {
        _S39 = vec2<f32>(_S37, _S36);
    }
    else
    {
        _S39 = vec2<f32>(_S36, _S37);
    }
    var _S40 : f32;
    if(((_S38 & (u32(2)))) != u32(0))
    {
        _S40 = - _S39.x;
    }
    else
    {
        _S40 = _S39.x;
    }
    var _S41 : f32;
    if((((_S38 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S41 = - _S39.y;
    }
    else
    {
        _S41 = _S39.y;
    }
    return vec2<f32>(_S40, _S41);
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S42 : vec2<f32> = this_0.dx_0;
    var _S43 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S42, _S42) + dot(_S43, _S43)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_1 : bool) -> vec3<f32>
{
    var _S44 : vec2<f32> = direction_1.xy;
    var _S45 : f32;
    if(back_1)
    {
        _S45 = - direction_1.z;
    }
    else
    {
        _S45 = direction_1.z;
    }
    return vec3<f32>(_S44, _S45);
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
    var _S46 : SurfacePoint_0;
    _S46.hole_0 = hole_1;
    _S46.is_warp_0 = is_warp_1;
    _S46.warp_thread_0 = warp_thread_1;
    _S46.weft_thread_0 = weft_thread_1;
    _S46.height_1 = height_2;
    _S46.normal_1 = normal_2;
    _S46.tangent_0 = tangent_1;
    _S46.across_0 = across_1;
    _S46.fibre_across_0 = fibre_across_1;
    _S46.fibre_along_0 = fibre_along_1;
    return _S46;
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
    var _S47 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S48 : f32 = mix(2.5f, 5.0f, _S47);
    quality_0.steps_per_thread_0 = _S48;
    quality_0.steps_per_relief_0 = _S48;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S47);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S47) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_4 : f32) -> vec2<f32>
{
    var _S49 : f32 = floor(fma(index_4, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S49, fma(- _S49, families_0[family_0].count_0, index_4));
}

struct Cell_0
{
     thread_1 : u32,
     across_2 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S50 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_1 : Cell_0;
    var _S51 : f32 = fma(- _S50, families_0[family_1].size_0, position_1);
    cell_1.below_0 = _S51;
    cell_1.above_0 = families_0[family_1].size_0 - _S51;
    cell_1.across_2 = _S51 - 0.5f * families_0[family_1].size_0;
    cell_1.half_width_1 = families_0[family_1].half_width_0;
    cell_1.thread_1 = u32(clamp(turns_and_remainder_0(family_1, _S50).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_1;
}

fn table_number_0( index_5 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_5])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S52 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_2 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S53 : u32;
    if(_S52 >= (table_number_0(families_0[family_2].place_table_0 + thread_2 * u32(4) + u32(1))))
    {
        _S53 = u32(1);
    }
    else
    {
        _S53 = u32(0);
    }
    var _S54 : u32 = min(thread_2 + _S53, u32(families_0[family_2].count_0) - u32(1));
    var _S55 : u32 = families_0[family_2].place_table_0 + _S54 * u32(4);
    var cell_2 : Cell_0;
    cell_2.thread_1 = _S54;
    cell_2.below_0 = _S52 - table_number_0(_S55);
    cell_2.above_0 = table_number_0(_S55 + u32(1)) - _S52;
    cell_2.across_2 = _S52 - table_number_0(_S55 + u32(2));
    cell_2.half_width_1 = table_number_0(_S55 + u32(3));
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
    var _S56 : bool = (abs(crossing_0.warp_1.across_2)) < (crossing_0.warp_1.half_width_1);
    var _S57 : bool = (abs(crossing_0.weft_1.across_2)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S58 : bool;
    if(_S56)
    {
        if(!_S57)
        {
            _S58 = true;
        }
        else
        {
            _S58 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S58 = false;
    }
    shown_0.is_warp_2 = _S58;
    if(!_S56)
    {
        _S58 = !_S57;
    }
    else
    {
        _S58 = false;
    }
    shown_0.hole_3 = _S58;
    var _S59 : u32;
    if(shown_0.is_warp_2)
    {
        _S59 = crossing_0.warp_word_0;
    }
    else
    {
        _S59 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S59;
    shown_0.on_top_0 = (((_S59 & (u32(1)))) == u32(1)) != back_2;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_1 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    var _S60 : u32;
    if(is_first_0)
    {
        _S60 = first_1.thread_1;
    }
    else
    {
        _S60 = second_0.thread_1;
    }
    cell_3.thread_1 = _S60;
    var _S61 : f32;
    if(is_first_0)
    {
        _S61 = first_1.across_2;
    }
    else
    {
        _S61 = second_0.across_2;
    }
    cell_3.across_2 = _S61;
    if(is_first_0)
    {
        _S61 = first_1.half_width_1;
    }
    else
    {
        _S61 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S61;
    if(is_first_0)
    {
        _S61 = first_1.below_0;
    }
    else
    {
        _S61 = second_0.below_0;
    }
    cell_3.below_0 = _S61;
    if(is_first_0)
    {
        _S61 = first_1.above_0;
    }
    else
    {
        _S61 = second_0.above_0;
    }
    cell_3.above_0 = _S61;
    return cell_3;
}

fn boundary_0( family_4 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S62 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_3) + step_0));
    return fma(_S62.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S62.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_4 : u32,  first_2 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_2) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_4, last_0) - boundary_0(family_5, thread_4, first_2);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_5 : u32) -> Bend_0
{
    var _S63 : Family_std430_0 = families_0[family_6];
    var _S64 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S64 = u32(0);
    }
    else
    {
        _S64 = thread_5 * u32(4);
    }
    var _S65 : u32 = _S63.bend_table_0 + _S64;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S65);
    bend_0.half_tangent_0 = table_number_0(_S65 + u32(1));
    bend_0.arc_0 = table_number_0(_S65 + u32(2));
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
    var _S66 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S67 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S68 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S69 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S70 : i32 = - _S66;
    var _S71 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S70, i32(0));
    run_0.from_start_0 = _S71;
    var _S72 : i32 = _S67 + i32(1);
    var _S73 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S72);
    run_0.to_end_0 = _S73;
    var _S74 : bool = _S71 < _S73;
    run_0.near_start_0 = _S74;
    var _S75 : i32;
    if(_S74)
    {
        _S75 = _S70 - _S68;
    }
    else
    {
        _S75 = _S72;
    }
    var _S76 : i32;
    if(run_0.near_start_0)
    {
        _S76 = _S70;
    }
    else
    {
        _S76 = _S72 + _S69;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    var _S77 : f32;
    if(run_0.straight_0)
    {
        _S77 = 1.0e+06f;
    }
    else
    {
        _S77 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S77;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S75, _S76), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S66 == i32(0);
    run_0.last_crossing_0 = _S67 == i32(0);
    return run_0;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_4 : Cell_0) -> Section_0
{
    var _S78 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S79 : f32 = clamp(cell_4.across_2, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S79;
    var _S80 : f32 = _S78 * _S78 - square_1(_S79);
    var _S81 : f32 = rsqrt_0(_S80);
    section_0.drop_0 = _S78 - _S80 * _S81;
    section_0.slope_0 = - _S79 * _S81;
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
    var _S82 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S83 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S84 : f32;
    if(_S82)
    {
        _S84 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S84 = crossed_1.above_0 + crossed_1.across_2;
    }
    var _S85 : f32 = _S84 - crossed_1.half_width_1;
    var _S86 : bool;
    if(_S82)
    {
        _S86 = run_1.first_crossing_0;
    }
    else
    {
        _S86 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S84 = 0.0f;
    }
    else
    {
        _S84 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S87 : f32;
    if((shown_1.on_top_0) != _S86)
    {
        _S87 = 0.0f;
    }
    else
    {
        var _S88 : Family_std430_0 = families_0[other_1];
        var _S89 : i32;
        if(_S82)
        {
            _S89 = i32(-1);
        }
        else
        {
            _S89 = i32(1);
        }
        _S87 = _S88.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S89);
    }
    var _S90 : f32 = 1.0f / max(2.0f * _S85, 9.999999960041972e-13f);
    var _S91 : f32 = clamp((_S85 - _S83) * _S90, 0.0f, 1.0f);
    var _S92 : f32 = _S84 + (_S87 - _S84) * (_S91 * _S91 * (3.0f - 2.0f * _S91));
    var _S93 : f32 = (_S84 - _S87) * (6.0f * _S91 * (1.0f - _S91) * _S90);
    if(_S82)
    {
        _S84 = 1.0f;
    }
    else
    {
        _S84 = -1.0f;
    }
    return vec2<f32>(_S92, _S93 * _S84);
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
    var _S94 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S94), 9.99999971718068537e-10f);
    var _S95 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S95), 9.99999971718068537e-10f);
    control_0.right_0 = _S94 > 0.0f;
    control_0.up_0 = _S95 > 0.0f;
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
    var _S96 : f32;
    if(forwards_0)
    {
        _S96 = cell_5.across_2;
    }
    else
    {
        _S96 = - cell_5.across_2;
    }
    var _S97 : f32;
    if(forwards_0)
    {
        _S97 = cell_5.above_0;
    }
    else
    {
        _S97 = cell_5.below_0;
    }
    var _S98 : bool;
    if(forwards_0)
    {
        _S98 = run_2.last_crossing_0;
    }
    else
    {
        _S98 = run_2.first_crossing_0;
    }
    var _S99 : bool;
    if(forwards_0)
    {
        _S99 = run_2.first_crossing_0;
    }
    else
    {
        _S99 = run_2.last_crossing_0;
    }
    var _S100 : f32 = - cell_5.half_width_1;
    var _S101 : bool = _S96 < _S100;
    var _S102 : bool = _S96 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S98 = !_S98;
    }
    else
    {
        _S98 = false;
    }
    if(_S98)
    {
        _S98 = !shown_2.hole_3;
    }
    else
    {
        _S98 = false;
    }
    var _S103 : bool;
    if(_S98)
    {
        _S103 = shown_2.on_top_0;
    }
    else
    {
        _S103 = false;
    }
    if(_S103)
    {
        if(_S99)
        {
            _S99 = _S101;
        }
        else
        {
            _S99 = false;
        }
        _S99 = !_S99;
    }
    else
    {
        _S99 = false;
    }
    if(shown_2.hole_3)
    {
        _S98 = true;
    }
    else
    {
        if(_S98)
        {
            _S98 = !shown_2.on_top_0;
        }
        else
        {
            _S98 = false;
        }
    }
    var _S104 : f32;
    if(_S101)
    {
        _S104 = _S100;
    }
    else
    {
        _S104 = cell_5.half_width_1;
    }
    var _S105 : f32 = _S104 - _S96;
    if(_S98)
    {
        _S96 = 2.0f * _S97 + _S96 - cell_5.half_width_1;
    }
    else
    {
        _S96 = _S97;
    }
    if(_S99)
    {
        if(forwards_0)
        {
            _S96 = run_2.to_end_0;
        }
        else
        {
            _S96 = run_2.from_start_0;
        }
        return _S96;
    }
    if(_S102)
    {
    }
    else
    {
        _S96 = _S105;
    }
    return _S96;
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
    var _S106 : f32 = previous_1.rate_0 * step_4;
    var _S107 : f32 = rate_1 * step_4;
    var _S108 : bool;
    if(!previous_1.known_0)
    {
        _S108 = true;
    }
    else
    {
        _S108 = here_0.hole_4;
    }
    if(_S108)
    {
        _S108 = true;
    }
    else
    {
        _S108 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S108)
    {
        _S108 = true;
    }
    else
    {
        _S108 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S108)
    {
        _S108 = true;
    }
    else
    {
        _S108 = rate_1 <= 0.0f;
    }
    if(_S108)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S106) >= 0.0f)
    {
        _S108 = (3.0f * clearance_1 - _S107) >= 0.0f;
    }
    else
    {
        _S108 = false;
    }
    if(_S108)
    {
        return -1.0f;
    }
    var _S109 : f32 = clearance_1 - previous_1.clearance_0;
    var _S110 : f32 = 6.0f * _S109 - 4.0f * _S106 - 2.0f * _S107;
    var _S111 : f32 = -2.0f * _S106 / max(_S110 + sqrt(max(_S110 * _S110 - 4.0f * (3.0f * (_S106 + _S107 - 2.0f * _S109)) * _S106, 0.0f)), 9.99999968265522539e-21f);
    var _S112 : f32 = 1.0f - _S111;
    var _S113 : f32 = (previous_1.clearance_0 * (2.0f * _S111 + 1.0f) + _S106 * _S111) * _S112 * _S112;
    var _S114 : f32 = (clearance_1 * (2.0f * _S112 + 1.0f) - _S107 * _S112) * _S111 * _S111;
    if(_S111 > 0.01999999955296516f)
    {
        _S108 = _S112 > 0.01999999955296516f;
    }
    else
    {
        _S108 = false;
    }
    if(_S108)
    {
        _S108 = (_S113 + _S114) < 0.0f;
    }
    else
    {
        _S108 = false;
    }
    var _S115 : f32;
    if(_S108)
    {
        _S115 = _S112 * step_4;
    }
    else
    {
        _S115 = -1.0f;
    }
    return _S115;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S116 : f32;
    if(here_1.hole_4)
    {
        _S116 = 1.0e+09f;
    }
    else
    {
        _S116 = clearance_2;
    }
    previous_2.clearance_0 = _S116;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S117 : bool;
    if(!here_1.hole_4)
    {
        _S117 = !is_cell_exit_0;
    }
    else
    {
        _S117 = false;
    }
    previous_2.known_0 = _S117;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S118 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S119 : bool;
    if(!here_2.hole_4)
    {
        _S119 = (rate_3 * _S118 + clearance_3) < 0.0f;
    }
    else
    {
        _S119 = false;
    }
    if(_S119)
    {
        _S119 = _S118 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S119 = false;
    }
    var _S120 : f32;
    if(_S119)
    {
        _S120 = _S118 - this_2.epsilon_0;
    }
    else
    {
        _S120 = max(_S118, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S120);
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
    var _S121 : f32 = end_0 - start_1;
    var _S122 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S121;
    var _S123 : f32 = 3.0f * _S121 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S121, 9.99999968265522539e-21f);
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
        var _S124 : f32 = clamp(share_1 - (((_S122 * share_1 + _S123) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S122 * share_1 + 2.0f * _S123) * share_1 + start_rate_0, 0.10000000149011612f * _S121 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S125 : i32 = i_0 + i32(1);
        share_1 = _S124;
        i_0 = _S125;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S126 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S127 : f32 = rsqrt_0(_S126);
    var _S128 : f32 = sine_1 * _S127 * rsqrt_0(_S126 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S128 * _S126, _S128 * across_slope_0 * along_slope_0 + cosine_0 * _S127);
}

fn arc_sine_0( x_8 : f32) -> f32
{
    var _S129 : f32 = abs(x_8);
    var _S130 : bool = _S129 > 0.5f;
    var _S131 : f32;
    if(_S130)
    {
        _S131 = 0.5f * (1.0f - _S129);
    }
    else
    {
        _S131 = _S129 * _S129;
    }
    var _S132 : f32;
    if(_S130)
    {
        _S132 = sqrt(max(_S131, 0.0f));
    }
    else
    {
        _S132 = _S129;
    }
    var _S133 : f32 = ((((0.04216320067644119f * _S131 + 0.02418131195008755f) * _S131 + 0.04547002539038658f) * _S131 + 0.07495300471782684f) * _S131 + 0.16666752099990845f) * _S131 * _S132 + _S132;
    if(_S130)
    {
        _S131 = 1.57079637050628662f - 2.0f * _S133;
    }
    else
    {
        _S131 = _S133;
    }
    if(x_8 < 0.0f)
    {
        _S131 = - _S131;
    }
    return _S131;
}

fn table_colour_0( index_6 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_6), table_number_0(index_6 + u32(1)), table_number_0(index_6 + u32(2)));
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
    var _S134 : vec3<f32> = room_0 / max(albedo_0, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S134.x, _S134.y), _S134.z), 0.0f));
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn diffuse_reflection_0( light_0 : vec3<f32>,  normal_3 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S135 : f32 = light_0.z;
    if(_S135 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S135, 0.0f), max(dot(light_0, normal_3), 0.0f), blend_0);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S136 : f32 = dot(direction_3, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S136 * _S136 + 1.0f, roughness_1 * roughness_1));
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
    var _S137 : f32 = roughness_2 * roughness_2;
    var _S138 : f32 = squared_along_0 * (1.0f - _S137) + _S137;
    return 0.31830987334251404f * _S137 * roughness_2 / (_S138 * _S138);
}

fn density_between_0( light_1 : vec3<f32>,  view_1 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S139 : vec3<f32> = light_1 + view_1;
    var _S140 : f32 = dot(_S139, tangent_3);
    return flake_density_0(min(_S140 * _S140 / max(square_0(_S139), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_0( light_2 : vec3<f32>,  view_2 : vec3<f32>,  normal_4 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S141 : f32 = - dot(light_2, normal_4);
    var _S142 : f32 = dot(view_2, normal_4);
    var _S143 : bool;
    if(_S141 <= 0.0f)
    {
        _S143 = true;
    }
    else
    {
        _S143 = _S142 <= 0.0f;
    }
    if(_S143)
    {
        return 0.0f;
    }
    var _S144 : f32 = 1.0f / max(_S142, 9.99999997475242708e-07f);
    var _S145 : f32 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S141, 9.99999997475242708e-07f);
    var _S146 : f32 = projected_area_1(view_2, tangent_4, roughness_4) * _S144;
    return density_between_0(light_2, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S145, _S146)) * mean_attenuation_0(optical_depth_1 * abs(_S145 - _S146)) * _S144;
}

fn reflection_0( light_3 : vec3<f32>,  view_3 : vec3<f32>,  normal_5 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S147 : f32 = dot(light_3, normal_5);
    var _S148 : bool;
    if(_S147 <= 0.0f)
    {
        _S148 = true;
    }
    else
    {
        _S148 = (dot(view_3, normal_5)) <= 0.0f;
    }
    if(_S148)
    {
        return 0.0f;
    }
    var _S149 : f32 = max(_S147, 9.99999997475242708e-07f);
    var _S150 : f32 = max(dot(view_3, normal_5), 9.99999997475242708e-07f);
    var _S151 : f32 = projected_area_1(light_3, tangent_5, roughness_5) * _S150 + projected_area_1(view_3, tangent_5, roughness_5) * _S149;
    var _S152 : f32 = optical_depth_2 * _S151 / (_S149 * _S150);
    return 0.25f * density_between_0(light_3, view_3, tangent_5, roughness_5) * (_S152 * mean_attenuation_0(_S152)) * _S149 / _S151;
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

fn wrapped_cell_0( position_4 : f32,  count_2 : f32) -> f32
{
    return min(floor((position_4 - floor(position_4)) * count_2), count_2 - 1.0f);
}

fn arc_tangent_quotient_0( x_9 : f32,  y_2 : f32) -> f32
{
    return ((((((0.0f * x_9 + 0.00809729471802711f) * x_9 + -0.0377517081797123f) * x_9 + 0.08475969731807709f) * x_9 + -0.13537675142288208f) * x_9 + 0.19895026087760925f) * x_9 + -0.33327975869178772f) * x_9 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_3 : f32,  x_10 : f32) -> f32
{
    var _S153 : f32 = abs(x_10);
    var _S154 : f32 = abs(y_3);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S153, _S154) / max(max(_S153, _S154), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S154 > _S153)
    {
        angle_1 = 1.57079637050628662f - angle_0;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(x_10 < 0.0f)
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
    var _S155 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    var _S156 : f32 = floor(_S155);
    var _S157 : f32 = _S155 - _S156;
    var _S158 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S159 : f32 = 7.0f * _S158 * sqrt(_S158);
    var _S160 : f32 = min(floor(_S159), 6.0f);
    var _S161 : f32 = _S159 - _S160;
    var _S162 : u32 = u32(i32(_S156) + i32(32)) % u32(32);
    var _S163 : u32 = u32(_S160);
    var _S164 : u32 = _S162 * u32(8) + _S163;
    var _S165 : u32 = (_S162 + u32(1)) % u32(32) * u32(8) + _S163;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S164, _S164 + u32(1), _S165, _S165 + u32(1));
    var _S166 : f32 = 1.0f - _S157;
    var _S167 : f32 = 1.0f - _S161;
    var _S168 : vec4<u32> = vec4<u32>(vec4<f32>(_S166 * _S167, _S166 * _S161, _S157 * _S167, _S157 * _S161) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S168;
    taps_0.inverse_sum_0 = 1.0f / f32(_S168.x + _S168.y + _S168.z + _S168.w);
    return taps_0;
}

fn half_vector_0( light_4 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S169 : vec3<f32> = light_4 + view_4;
    return _S169 * vec3<f32>(rsqrt_0(max(square_0(_S169), 9.999999960041972e-13f)));
}

fn shadow_correlation_0( light_5 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S170 : vec2<f32> = light_5.xy;
    var _S171 : vec2<f32> = view_5.xy;
    var _S172 : f32 = dot(_S170, _S171) / max(sqrt(dot(_S170, _S170) * dot(_S171, _S171)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return vec3<f32>(vec2<f32>((-0.09000000357627869f + -0.07999999821186066f * _S172)), 0.0f);
    }
    return vec3<f32>(min(0.62000000476837158f + 0.62999999523162842f * _S172, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S173 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S174 : vec4<u32> = ((packs_1 & (_S173))) * taps_1.weights_0;
    var _S175 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S173))) * taps_1.weights_0;
    return bytes_of_sums_0(_S174.x + _S174.y + _S174.z + _S174.w, _S175.x + _S175.y + _S175.z + _S175.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_1 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S176 : vec4<u32> = vec4<u32>(table_1) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S176.x], words_0[_S176.y], words_0[_S176.z], words_0[_S176.w]));
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
    var _S177 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_6 = _S177;
    var _S178 : f32 = table_number_0(row_1 + u32(7));
    var _S179 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S178, _S179, 1.0f - square_0(_S177) - _S178 - _S179);
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
    var _S180 : f32 = direction_5.x;
    var _S181 : f32 = direction_5.y;
    var _S182 : f32 = direction_5.z;
    return max(dot(this_5.variance_0, direction_5 * direction_5) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S180 * _S181, _S180 * _S182, _S181 * _S182)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_6 : vec3<f32>) -> f32
{
    var _S183 : f32 = dot(direction_6, group_1.tangent_6);
    var _S184 : f32 = group_1.roughness_6;
    var _S185 : f32 = _S184 * _S184;
    return sqrt(max((_S185 - 1.0f) * (_S183 * _S183 + Group_variance_along_0(group_1, direction_6)) + 1.0f, _S185));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S186 : f32 = group_2.roughness_6;
    var _S187 : f32 = max(sqrt(max(1.0f - _S186 * _S186, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S188 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S189 : f32 = dot(half_0, group_2.tangent_6);
    var _S190 : f32 = _S187 * (_S189 - _S188);
    var _S191 : f32 = _S187 * (_S189 + _S188);
    var _S192 : f32 = _S190 * _S191;
    var _S193 : f32 = 2.0f * _S188 * _S187;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S192) / ((_S190 * _S190 + 1.0f) * (_S191 * _S191 + 1.0f)) + arc_tangent_0(_S193, 1.0f + _S192) / _S193);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_6 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S194 : bool = (light_6.z) < 0.0f;
    var _S195 : f32 = dot(light_6, group_3.normal_6);
    var _S196 : f32;
    if(_S194)
    {
        _S196 = - _S195;
    }
    else
    {
        _S196 = _S195;
    }
    var _S197 : f32 = max(dot(view_6, group_3.normal_6), 0.01999999955296516f);
    var _S198 : f32 = mean_area_0(group_3, light_6) / max(_S196, 0.01999999955296516f);
    var _S199 : f32 = mean_area_0(group_3, view_6) / _S197;
    if(_S194)
    {
        _S196 = abs(_S198 - _S199);
    }
    else
    {
        _S196 = _S198 + _S199;
    }
    var _S200 : f32 = optical_depth_3 * max(_S196, 0.00100000004749745f);
    if(_S194)
    {
        _S196 = exponential_0(- optical_depth_3 * min(_S198, _S199));
    }
    else
    {
        _S196 = 1.0f;
    }
    var _S201 : f32 = optical_depth_3 * _S196 * (1.0f - exponential_0(- _S200)) / _S200 / _S197;
    if(_S194)
    {
        _S196 = 1.0f;
    }
    else
    {
        _S196 = 1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_6));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S196 * _S201;
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

fn bound_at_0( family_9 : u32,  position_5 : f32) -> Bound_0
{
    var _S202 : Cell_0 = locate_0(family_9, position_5);
    var _S203 : f32 = table_number_0(families_0[family_9].before_0 + u32(2) * _S202.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_11 = _S202.thread_1;
    bound_0.turns_2 = round((position_5 - families_0[family_9].start_0 - _S203 - _S202.below_0) * families_0[family_9].inverse_period_0);
    bound_0.cell_7 = _S202.below_0;
    var _S204 : f32 = 2.0f * _S202.half_width_1;
    bound_0.width_1 = _S204;
    bound_0.visible_0 = clamp((_S202.across_2 + _S202.half_width_1) / _S204, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S202.below_0, _S202.below_0 - _S202.across_2 - _S202.half_width_1) + max(_S202.across_2 - _S202.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_10 : u32,  centre_1 : f32,  size_1 : f32) -> Stretch_0
{
    var _S205 : f32 = centre_1 - floor((centre_1 - families_0[family_10].start_0) * families_0[family_10].inverse_period_0) * families_0[family_10].period_0;
    var _S206 : f32 = 0.5f * max(size_1, families_0[family_10].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_10, _S205 - _S206);
    stretch_0.high_1 = bound_at_0(family_10, _S205 + _S206);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_11 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S207 : f32 = Stretch_turns_0(stretch_1);
    var _S208 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.low_1.thread_11;
    var _S209 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.high_1.thread_11;
    var _S210 : f32 = table_number_0(_S209) - table_number_0(_S208);
    var _S211 : f32 = table_number_0(_S209 + u32(1)) - table_number_0(_S208 + u32(1));
    return vec3<f32>(_S210 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_1 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_1 + _S207 * families_0[family_11].visible_total_0, _S211 - _S210 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S207 * (families_0[family_11].period_0 - families_0[family_11].visible_total_0), _S211 + stretch_1.high_1.cell_7 - stretch_1.low_1.cell_7 + _S207 * families_0[family_11].period_0);
}

fn integrals_along_0( family_12 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S212 : Family_std430_0 = families_0[family_12];
    var _S213 : u32 = u32(3) * _S212.quantities_0;
    var _S214 : u32 = families_0[family_12].colour_threads_0 + _S213 * stretch_2.low_1.thread_11 + quantity_0;
    var _S215 : u32 = families_0[family_12].colour_threads_0 + _S213 * stretch_2.high_1.thread_11 + quantity_0;
    var _S216 : u32 = families_0[family_12].colour_threads_0 + _S213 * u32(families_0[family_12].count_0) + quantity_0;
    var _S217 : f32 = table_number_0(_S214);
    var _S218 : f32 = table_number_0(_S215);
    var _S219 : f32 = Stretch_turns_0(stretch_2);
    var _S220 : u32 = u32(2) * _S212.quantities_0;
    return vec2<f32>(table_number_0(_S215 + _S212.quantities_0) - table_number_0(_S214 + _S212.quantities_0) + _S218 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_1 - _S217 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_1 + _S219 * table_number_0(_S216 + _S212.quantities_0), table_number_0(_S215 + _S220) - table_number_0(_S214 + _S220) + _S218 * stretch_2.high_1.cell_7 - _S217 * stretch_2.low_1.cell_7 + _S219 * table_number_0(_S216 + _S220));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_11) < (this_7.low_1.thread_11);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S221 : u32 = entries_0.z;
    var _S222 : u32 = entries_0.x;
    var _S223 : u32 = _S221 - _S222;
    var _S224 : u32;
    if(Stretch_wraps_0(this_8))
    {
        _S224 = whole_0;
    }
    else
    {
        _S224 = u32(0);
    }
    return vec4<u32>(_S223 + _S224, entries_0.w - _S221, entries_0.y - _S222, whole_0);
}

fn row_differences_0( across_4 : Stretch_0,  row_2 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S225 : u32 = row_2 + across_4.low_1.thread_11 * quantities_1;
    var _S226 : u32 = row_2 + across_4.high_1.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, vec4<u32>(words_0[_S225], words_0[_S225 + quantities_1], words_0[_S226], words_0[_S226 + quantities_1]), words_0[row_2 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    var _S227 : f32 = - this_9.low_1.visible_0;
    var _S228 : f32 = Stretch_turns_0(this_9);
    var _S229 : f32;
    if(Stretch_wraps_0(this_9))
    {
        _S229 = 1.0f;
    }
    else
    {
        _S229 = 0.0f;
    }
    return vec4<f32>(1.0f, this_9.high_1.visible_0, _S227, _S228 - _S229);
}

fn integral_on_top_0( family_13 : u32,  across_5 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S230 : u32 = u32(families_0[family_13].count_0);
    var _S231 : u32 = (_S230 + u32(1)) * families_0[family_13].quantities_0;
    var _S232 : u32 = families_0[family_13].colour_areas_0 + quantity_1;
    var _S233 : vec4<u32> = row_differences_0(across_5, _S232 + along_0.low_1.thread_11 * _S231, _S230, families_0[family_13].quantities_0);
    var _S234 : vec4<u32> = row_differences_0(across_5, _S232 + (along_0.low_1.thread_11 + u32(1)) * _S231, _S230, families_0[family_13].quantities_0);
    var _S235 : vec4<u32> = row_differences_0(across_5, _S232 + along_0.high_1.thread_11 * _S231, _S230, families_0[family_13].quantities_0);
    var _S236 : vec4<u32> = row_differences_0(across_5, _S232 + (along_0.high_1.thread_11 + u32(1)) * _S231, _S230, families_0[family_13].quantities_0);
    var _S237 : vec4<u32> = row_differences_0(across_5, _S232 + crossing_count_0 * _S231, _S230, families_0[family_13].quantities_0);
    var _S238 : vec4<u32> = _S235 - _S233;
    var _S239 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S239 = _S237;
    }
    else
    {
        _S239 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S240 : vec4<f32> = Stretch_weights_0(across_5);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S238 + _S239)), _S240), dot(vec4<f32>(vec4<i32>(_S236 - _S235)), _S240), dot(vec4<f32>(vec4<i32>(_S234 - _S233)), _S240), dot(vec4<f32>(vec4<i32>(_S237)), _S240)), Stretch_weights_0(along_0)) * families_0[family_13].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_2 : f32,  row_3 : u32) -> Albedos_0
{
    var _S241 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S242 : vec3<f32> = vec3<f32>(weight_2);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S242 * _S241.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S242 * _S241.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S242 * _S241.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S242 * _S241.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_14 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_14].colour_mean_0);
    if((families_0[family_14].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S243 : vec3<f32> = lengths_0(crossing_1, other_2);
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
        var _S244 : vec2<f32> = integrals_along_0(family_14, own_1, quantity_2);
        var _S245 : f32 = integral_on_top_0(family_14, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S246 : f32 = _S244.x;
        var _S247 : f32 = _S246 * _S243.x;
        var _S248 : f32;
        if(back_3)
        {
            _S248 = _S247 - _S245;
        }
        else
        {
            _S248 = _S245;
        }
        var _S249 : bool = quantity_2 == u32(0);
        if(_S249)
        {
            is_exposed_0 = _S248 > (16.0f * families_0[family_14].area_unit_0 * min(_S247 / families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S247);
        }
        var _S250 : f32 = _S246 * _S243.y;
        var _S251 : f32;
        if(is_exposed_0)
        {
            _S251 = _S248;
        }
        else
        {
            _S251 = 0.0f;
        }
        var _S252 : f32 = _S250 + _S251 + 0.000244140625f * _S243.z * _S244.y;
        if(_S249)
        {
            weight_3 = 1.0f / max(_S252, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S252 * weight_3, families_0[family_14].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn lerp_albedos_0( first_3 : Albedos_0,  second_1 : Albedos_0,  weight_4 : f32) -> Albedos_0
{
    var albedos_3 : Albedos_0;
    var _S253 : vec3<f32> = vec3<f32>(weight_4);
    albedos_3.diffuse_reflect_0 = mix(first_3.diffuse_reflect_0, second_1.diffuse_reflect_0, _S253);
    albedos_3.diffuse_transmit_0 = mix(first_3.diffuse_transmit_0, second_1.diffuse_transmit_0, _S253);
    albedos_3.specular_reflect_0 = mix(first_3.specular_reflect_0, second_1.specular_reflect_0, _S253);
    albedos_3.specular_transmit_0 = mix(first_3.specular_transmit_0, second_1.specular_transmit_0, _S253);
    return albedos_3;
}

fn tinted_0( albedos_4 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_1 : Albedos_0 = albedos_4;
    result_1.diffuse_reflect_0 = result_1.diffuse_reflect_0 * tint_0;
    result_1.diffuse_transmit_0 = result_1.diffuse_transmit_0 * tint_0;
    return result_1;
}

fn sheen_scale_0( x_11 : f32,  y_4 : f32) -> f32
{
    return (((((0.0f * x_11 + (((((-1.1402510404586792f * y_4 + 0.40672621130943298f) * y_4 + 1.65398800373077393f) * y_4 + -1.29730904102325439f) * y_4 + 0.30570998787879944f) * y_4 + -0.0220868494361639f)) * x_11 + (((((-0.21142719686031342f * y_4 + 1.05947399139404297f) * y_4 + -0.41116121411323547f) * y_4 + -0.93859231472015381f) * y_4 + 0.51606941223144531f) * y_4 + 0.05409301072359085f)) * x_11 + (((((1.22944498062133789f * y_4 + -0.45962560176849365f) * y_4 + -1.63861405849456787f) * y_4 + 1.33565104007720947f) * y_4 + -0.45725581049919128f) * y_4 + 0.08243165910243988f)) * x_11 + (((((0.39779931306838989f * y_4 + -1.18879103660583496f) * y_4 + 0.28251591324806213f) * y_4 + 1.168984055519104f) * y_4 + -0.76864629983901978f) * y_4 + 0.0091691892594099f)) * x_11 + (((((-0.26563560962677002f * y_4 + -0.19379159808158875f) * y_4 + 0.2677634060382843f) * y_4 + 0.00270519289188087f) * y_4 + 0.14349560439586639f) * y_4 + 0.10290180146694183f)) * x_11 + (((((-0.20701569318771362f * y_4 + 0.24526430666446686f) * y_4 + 0.19551840424537659f) * y_4 + 0.07586126774549484f) * y_4 + 0.38894739747047424f) * y_4 + 0.15043120086193085f);
}

fn sheen_shear_0( x_12 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_12 + (((((-0.10608240216970444f * y_5 + 1.99214303493499756f) * y_5 + -1.42255294322967529f) * y_5 + -1.09495604038238525f) * y_5 + 0.59180057048797607f) * y_5 + 0.06902855634689331f)) * x_12 + (((((-0.46220690011978149f * y_5 + -0.29113379120826721f) * y_5 + 1.39025199413299561f) * y_5 + 0.35589990019798279f) * y_5 + -1.17120099067687988f) * y_5 + 0.15940259397029877f)) * x_12 + (((((2.26068711280822754f * y_5 + -3.64728999137878418f) * y_5 + -0.72173482179641724f) * y_5 + 3.07659196853637695f) * y_5 + -0.6827620267868042f) * y_5 + -0.3039557933807373f)) * x_12 + (((((0.81201767921447754f * y_5 + 0.36014080047607422f) * y_5 + -1.72646903991699219f) * y_5 + -0.22630110383033752f) * y_5 + 0.89514690637588501f) * y_5 + -0.10397960245609283f)) * x_12 + (((((-0.37648698687553406f * y_5 + 1.10974001884460449f) * y_5 + 0.17824520170688629f) * y_5 + -1.04968702793121338f) * y_5 + 0.1461234986782074f) * y_5 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_13 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_13 + (((((12.95646953582763672f * y_6 + -21.38032913208007812f) * y_6 + -7.37853097915649414f) * y_6 + 34.55607986450195312f) * y_6 + -23.61347007751464844f) * y_6 + 5.00126314163208008f)) * x_13 + (((((10.91487026214599609f * y_6 + -6.08202791213989258f) * y_6 + -38.2036285400390625f) * y_6 + 53.3440399169921875f) * y_6 + -21.91996002197265625f) * y_6 + 2.01606011390686035f)) * x_13 + (((((-14.52206039428710938f * y_6 + 36.803619384765625f) * y_6 + -22.94047927856445312f) * y_6 + -10.07973003387451172f) * y_6 + 15.77003955841064453f) * y_6 + -4.92722177505493164f)) * x_13 + (((((-7.62505722045898438f * y_6 + 1.27310299873352051f) * y_6 + 31.19523048400878906f) * y_6 + -44.39989852905273438f) * y_6 + 26.44947052001953125f) * y_6 + -8.73507976531982422f)) * x_13 + (((((5.65633487701416016f * y_6 + -17.66820907592773438f) * y_6 + 24.65356063842773438f) * y_6 + -19.38941001892089844f) * y_6 + 11.06159019470214844f) * y_6 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S254 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S255 : f32 = 2.0f * sqrt(_S254) - 1.0f;
    var _S256 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S255, _S256), 0.00999999977648258f, 1.0f), clamp((1.0f - _S254) * sheen_shear_0(_S255, _S256), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S255, _S256), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_7 : vec3<f32>,  view_7 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S257 : f32 = light_7.z;
    var _S258 : bool;
    if(_S257 <= 0.0f)
    {
        _S258 = true;
    }
    else
    {
        _S258 = (view_7.z) <= 0.0f;
    }
    if(_S258)
    {
        return 0.0f;
    }
    var _S259 : vec2<f32> = view_7.xy;
    var _S260 : f32 = dot(_S259, _S259);
    var _S261 : vec2<f32>;
    if(_S260 > 9.99999968265522539e-21f)
    {
        _S261 = _S259 * vec2<f32>(rsqrt_0(_S260));
    }
    else
    {
        _S261 = vec2<f32>(1.0f, 0.0f);
    }
    var _S262 : f32 = scale_0 * dot(light_7.xy, _S261) + shear_0 * _S257;
    var _S263 : f32 = scale_0 * (light_7.y * _S261.x - light_7.x * _S261.y);
    var _S264 : f32 = _S262 * _S262 + _S263 * _S263 + _S257 * _S257;
    return 0.31830987334251404f * scale_0 * scale_0 * _S257 / max(_S264 * _S264, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_8 : vec3<f32>,  view_8 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S265 : vec3<f32> = sheen_lobe_0(view_8.z, roughness_9);
    var _S266 : f32 = strength_0 * _S265.z;
    return vec2<f32>(_S266 * transformed_cosine_0(light_8, view_8, _S265.x, _S265.y), 1.0f - _S266);
}

fn accumulate_0( index_7 : u32,  light_9 : vec4<f32>)
{
    var _S267 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_9;
    layers_0[index_7].share_0 = _S267 * (1.0f - light_9.w);
    return;
}

fn camera_right_0( _S268 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S268].right_x_0, frames_0[_S268].right_y_0, frames_0[_S268].right_z_0);
}

fn camera_up_0( _S269 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S269].up_x_0, frames_0[_S269].up_y_0, frames_0[_S269].up_z_0);
}

fn camera_forward_0( _S270 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S270].forward_x_0, frames_0[_S270].forward_y_0, frames_0[_S270].forward_z_0);
}

fn camera_origin_0( _S271 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S271].origin_x_0, frames_0[_S271].origin_y_0, frames_0[_S271].origin_z_0);
}

fn face_point_0( _S272 : u32,  _S273 : u32,  _S274 : f32,  _S275 : f32) -> VisiblePoint_0
{
    var _S276 : u32 = u32(3) * _S273;
    var _S277 : Vertex_std430_0 = vertices_0[corners_0[_S276]];
    var _S278 : Vertex_std430_0 = vertices_0[corners_0[_S276 + u32(1)]];
    var _S279 : Vertex_std430_0 = vertices_0[corners_0[_S276 + u32(2)]];
    var _S280 : vec3<f32> = position_of_0(&(_S278));
    var _S281 : vec3<f32> = position_of_0(&(_S277));
    var _S282 : vec3<f32> = _S280 - _S281;
    var _S283 : vec3<f32> = position_of_0(&(_S279));
    var _S284 : vec3<f32> = _S283 - _S281;
    var _S285 : f32 = _S277.u_0;
    var _S286 : f32 = _S278.u_0 - _S277.u_0;
    var _S287 : f32 = _S277.v_0;
    var _S288 : f32 = _S278.v_0 - _S277.v_0;
    var _S289 : vec2<f32> = vec2<f32>(_S286, _S288);
    var _S290 : f32 = _S279.u_0 - _S277.u_0;
    var _S291 : f32 = _S279.v_0 - _S277.v_0;
    var _S292 : vec2<f32> = vec2<f32>(_S290, _S291);
    var _S293 : f32;
    if((_S286 * _S291 - _S288 * _S290) < 0.0f)
    {
        _S293 = -1.0f;
    }
    else
    {
        _S293 = 1.0f;
    }
    var _S294 : vec3<f32> = vec3<f32>(_S293) * (vec3<f32>(_S291) * _S282 - vec3<f32>(_S288) * _S284);
    var _S295 : vec3<f32> = vec3<f32>(_S293) * (vec3<f32>(_S286) * _S284 - vec3<f32>(_S290) * _S282);
    var point_1 : VisiblePoint_0;
    var _S296 : f32 = 1.0f - _S274 - _S275;
    var _S297 : vec3<f32> = normal_of_0(&(_S277));
    var _S298 : vec3<f32> = vec3<f32>(_S296) * _S297;
    var _S299 : vec3<f32> = normal_of_0(&(_S278));
    var _S300 : vec3<f32> = vec3<f32>(_S274);
    var _S301 : vec3<f32> = _S298 + _S300 * _S299;
    var _S302 : vec3<f32> = normal_of_0(&(_S279));
    var _S303 : vec3<f32> = vec3<f32>(_S275);
    var _S304 : vec3<f32> = normalize(_S301 + _S303 * _S302);
    point_1.normal_0 = _S304;
    var _S305 : vec3<f32> = normalize(_S294 - _S304 * vec3<f32>(dot(_S304, _S294)));
    point_1.axis_x_0 = _S305;
    point_1.axis_y_0 = cross(_S304, _S305);
    var _S306 : vec3<f32> = normalize(cross(_S282, _S284));
    var _S307 : vec3<f32>;
    if((dot(_S306, _S304)) < 0.0f)
    {
        _S307 = (vec3<f32>(0) - _S306);
    }
    else
    {
        _S307 = _S306;
    }
    point_1.face_normal_0 = _S307;
    point_1.position_0 = _S281 + _S300 * _S282 + _S303 * _S284;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_1 = vec2<f32>(_S285, _S287) + vec2<f32>(_S274) * _S289 + vec2<f32>(_S275) * _S292;
    var _S308 : bool = (dot(cross(_S294, _S295), point_1.normal_0)) < 0.0f;
    var _S309 : f32 = fabrics_0[_S272].uv_width_0;
    if(_S308)
    {
        _S293 = - fabrics_0[_S272].uv_height_0;
    }
    else
    {
        _S293 = fabrics_0[_S272].uv_height_0;
    }
    var _S310 : vec2<f32> = vec2<f32>(_S309, _S293);
    point_1.draft_per_uv_0 = _S310;
    var _S311 : vec2<f32> = point_1.uv_1 * _S310;
    if(_S308)
    {
        _S293 = fabrics_0[_S272].uv_height_0;
    }
    else
    {
        _S293 = 0.0f;
    }
    point_1.draft_0 = _S311 + vec2<f32>(0.0f, _S293);
    var _S312 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S312;
    point_1.draft_dy_0 = _S312;
    return point_1;
}

fn visible_point_0( _S313 : i32,  _S314 : u32,  _S315 : u32,  _S316 : vec2<u32>) -> VisiblePoint_0
{
    var _S317 : u32 = u32(3) * _S315;
    var _S318 : Vertex_std430_0 = vertices_0[corners_0[_S317]];
    var _S319 : Vertex_std430_0 = vertices_0[corners_0[_S317 + u32(1)]];
    var _S320 : Vertex_std430_0 = vertices_0[corners_0[_S317 + u32(2)]];
    var _S321 : vec3<f32> = position_of_1(&(_S319));
    var _S322 : vec3<f32> = position_of_1(&(_S318));
    var _S323 : vec3<f32> = _S321 - _S322;
    var _S324 : vec3<f32> = position_of_1(&(_S320));
    var _S325 : vec3<f32> = _S324 - _S322;
    var _S326 : vec3<f32> = cross(_S323, _S325);
    var _S327 : f32 = 1.0f / max(square_0(_S326), 1.00000000317107685e-30f);
    var _S328 : f32 = f32(frames_0[_S313].width_0);
    var _S329 : vec3<f32> = camera_right_0(_S313) * vec3<f32>((2.0f / _S328));
    var _S330 : f32 = f32(frames_0[_S313].height_0);
    var _S331 : vec3<f32> = camera_up_0(_S313) * vec3<f32>((-2.0f / _S330));
    var _S332 : vec3<f32> = camera_forward_0(_S313) + vec3<f32>((f32(_S316.x) + 0.5f - 0.5f * _S328)) * _S329 + vec3<f32>((f32(_S316.y) + 0.5f - 0.5f * _S330)) * _S331;
    var _S333 : f32 = dot(_S332, _S326);
    var _S334 : f32;
    if((abs(_S333)) > 1.00000000317107685e-30f)
    {
        _S334 = _S333;
    }
    else
    {
        _S334 = 1.00000000317107685e-30f;
    }
    var _S335 : f32 = 1.0f / _S334;
    var _S336 : vec3<f32> = _S322 - camera_origin_0(_S313);
    var _S337 : vec3<f32> = vec3<f32>((dot(_S336, _S326) * _S335));
    var _S338 : vec3<f32> = _S332 * _S337 - _S336;
    var _S339 : vec3<f32> = _S337 * (_S329 - _S332 * vec3<f32>((dot(_S329, _S326) * _S335)));
    var _S340 : vec3<f32> = _S337 * (_S331 - _S332 * vec3<f32>((dot(_S331, _S326) * _S335)));
    var _S341 : vec3<f32> = vec3<f32>(_S327);
    var _S342 : vec3<f32> = cross(_S325, _S326) * _S341;
    var _S343 : vec3<f32> = cross(_S326, _S323) * _S341;
    var _S344 : vec2<f32> = vec2<f32>(_S319.u_0 - _S318.u_0, _S319.v_0 - _S318.v_0);
    var _S345 : vec2<f32> = vec2<f32>(_S320.u_0 - _S318.u_0, _S320.v_0 - _S318.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S314, _S315, dot(_S338, _S342), dot(_S338, _S343));
    point_2.position_0 = _S322 + _S338;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S332));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S339, _S342)) * _S344 + vec2<f32>(dot(_S339, _S343)) * _S345) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S340, _S342)) * _S344 + vec2<f32>(dot(_S340, _S343)) * _S345) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S346 : u32,  _S347 : VisiblePoint_0) -> vec3<f32>
{
    var _S348 : u32 = fabrics_0[_S346].albedo_map_levels_0;
    if((fabrics_0[_S346].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S349 : vec2<f32> = vec2<f32>(fabrics_0[_S346].uv_width_0, fabrics_0[_S346].uv_height_0);
    var _S350 : vec2<f32> = _S347.draft_dx_0 / _S349;
    var _S351 : vec2<f32> = _S347.draft_dy_0 / _S349;
    var _S352 : u32 = _S348 - u32(1);
    var _S353 : u32 = (u32(1) << (_S352));
    var _S354 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S350.x * _S351.y - _S350.y * _S351.x), 9.99999968265522539e-21f) * (square_1(f32(_S353)) / 3.0f)), 0.0f, f32(_S348) - 1.0f);
    var _S355 : u32 = min(u32(_S354), max(_S348, u32(2)) - u32(2));
    var _S356 : u32 = min(_S355 + u32(1), _S352);
    var _S357 : u32 = (u32(1) << ((u32(2) * _S348)));
    return mix(map_level_0(fabrics_0[_S346].albedo_map_0 + (_S357 - ((_S357 >> ((u32(2) * _S355))))) / u32(3), (_S353 >> (_S355)), _S347.uv_1), map_level_0(fabrics_0[_S346].albedo_map_0 + (_S357 - ((_S357 >> ((u32(2) * _S356))))) / u32(3), (_S353 >> (_S356)), _S347.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S354 - f32(_S355))) - 1.0f) / 3.0f)));
}

fn light_sample_count_0( _S358 : i32) -> u32
{
    return frames_0[_S358].lights_0 + frames_0[_S358].environment_samples_0;
}

fn visibility_at_0( _S359 : i32,  _S360 : u32,  _S361 : vec2<u32>) -> f32
{
    if((frames_0[_S359].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S360 * frames_0[_S359].height_0 + _S361.y) * frames_0[_S359].width_0 + _S361.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S362 : i32,  _S363 : u32,  _S364 : u32) -> vec3<f32>
{
    var _S365 : u32 = frames_0[_S362].environment_table_0 + frames_0[_S362].environment_rows_0 + u32(1) + frames_0[_S362].environment_rows_0 * (frames_0[_S362].environment_columns_0 + u32(1)) + u32(3) * (_S363 * frames_0[_S362].environment_columns_0 + _S364);
    return vec3<f32>(scene_number_0(_S365), scene_number_0(_S365 + u32(1)), scene_number_0(_S365 + u32(2)));
}

fn sample_environment_0( _S366 : i32,  _S367 : vec2<f32>,  _S368 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S369 : u32 = frames_0[_S366].environment_rows_0;
    var _S370 : Choice_0 = choose_0(frames_0[_S366].environment_table_0, frames_0[_S366].environment_rows_0, _S367.y);
    var _S371 : u32 = frames_0[_S366].environment_columns_0;
    var _S372 : Choice_0 = choose_0(frames_0[_S366].environment_table_0 + frames_0[_S366].environment_rows_0 + u32(1) + _S370.index_3 * (frames_0[_S366].environment_columns_0 + u32(1)), frames_0[_S366].environment_columns_0, _S367.x);
    var _S373 : vec3<f32> = environment_texel_0(_S366, _S370.index_3, _S372.index_3);
    (*_S368) = _S373 * vec3<f32>((frames_0[_S366].environment_total_0 / max(mean_0(_S373), 9.99999968265522539e-21f)));
    var _S374 : f32 = 3.14159274101257324f / f32(_S369);
    var _S375 : f32 = mix(sine_cosine_0(f32(_S370.index_3) * _S374).y, sine_cosine_0(f32(_S370.index_3 + u32(1)) * _S374).y, _S370.remainder_0);
    var _S376 : f32 = sqrt(max(1.0f - _S375 * _S375, 0.0f));
    var _S377 : vec2<f32> = sine_cosine_0((f32(_S372.index_3) + _S372.remainder_0) * (6.28318548202514648f / f32(_S371)));
    var _S378 : f32 = _S376 * _S377.x;
    var _S379 : f32 = - _S376 * _S377.y;
    return vec3<f32>(frames_0[_S366].environment_cosine_0 * _S378 + frames_0[_S366].environment_sine_0 * _S379, _S375, frames_0[_S366].environment_cosine_0 * _S379 - frames_0[_S366].environment_sine_0 * _S378);
}

fn light_sample_0( _S380 : i32,  _S381 : u32,  _S382 : vec2<u32>,  _S383 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S384 : u32 = frames_0[_S380].lights_0;
    if(_S381 >= (frames_0[_S380].lights_0))
    {
        var weight_5 : vec3<f32>;
        var _S385 : vec3<f32> = sample_environment_0(_S380, pixel_sequence_0(_S382, frames_0[_S380].pass_number_0 * frames_0[_S380].environment_samples_0 + (_S381 - _S384), u32(3)), &(weight_5));
        sample_0.towards_0 = _S385;
        sample_0.irradiance_1 = weight_5 / vec3<f32>(f32(frames_0[_S380].environment_samples_0));
        return sample_0;
    }
    var _S386 : Light_std430_0 = lights_1[_S381];
    sample_0.irradiance_1 = vec3<f32>(_S386.red_0, _S386.green_0, _S386.blue_0);
    sample_0.towards_0 = vec3<f32>(_S386.x_1, _S386.y_1, _S386.z_1);
    if((_S386.is_point_0) != u32(0))
    {
        var _S387 : vec3<f32> = sample_0.towards_0 - _S383;
        var _S388 : f32 = max(square_0(_S387), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S388);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S388);
        sample_0.towards_0 = normalize(_S387);
    }
    return sample_0;
}

struct FamilyAlbedos_0
{
     warp_2 : Albedos_0,
     weft_2 : Albedos_0,
};

struct Estimate_0
{
     components_0 : Components_0,
     albedos_5 : FamilyAlbedos_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_1 : f32,
     points_0 : f32,
};

fn regime_of_0( _S389 : u32,  _S390 : Footprint_0,  _S391 : f32) -> Regime_0
{
    var _S392 : f32 = Footprint_spread_side_0(_S390);
    var _S393 : f32 = clamp((binary_logarithm_0(max(_S392, 9.99999971718068537e-10f)) - fabrics_0[_S389].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S394 : f32 = _S393 * _S393 * (3.0f - 2.0f * _S393);
    regime_0.prefiltered_0 = _S394;
    regime_0.threads_1 = _S392 * fabrics_0[_S389].lobes_0.threads_per_mm_0;
    var _S395 : f32 = mix(max(8.0f / _S391, 1.0f), 1.0f, _S394);
    var _S396 : f32;
    if(_S394 < 1.0f)
    {
        _S396 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S395);
    }
    else
    {
        _S396 = 0.0f;
    }
    regime_0.points_0 = _S396;
    return regime_0;
}

struct Hit_0
{
     x_14 : f32,
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

fn crossing_at_0( _S397 : u32,  _S398 : f32,  _S399 : f32,  _S400 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_1 = locate_0(fabrics_0[_S397].warp_0, _S398);
    crossing_3.weft_1 = locate_0(fabrics_0[_S397].weft_0, _S399);
    var _S401 : u32 = fabrics_0[_S397].run_words_0 + u32(2) * (crossing_3.weft_1.thread_1 * fabrics_0[_S397].ends_1 + crossing_3.warp_1.thread_1);
    var _S402 : u32 = words_0[_S401];
    crossing_3.warp_word_0 = _S402;
    crossing_3.weft_word_0 = words_0[_S401 + u32(1)];
    crossing_3.warp_above_0 = (((_S402 & (u32(1)))) == u32(1)) != _S400;
    return crossing_3;
}

fn sample_at_0( _S403 : u32,  _S404 : f32,  _S405 : f32,  _S406 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S407 : Crossing_0 = crossing_at_0(_S403, _S404, _S405, _S406);
    sample_1.crossing_2 = _S407;
    var _S408 : Shown_0 = shown_at_0(_S407, _S406);
    sample_1.shown_3 = _S408;
    var _S409 : u32;
    if(_S408.is_warp_2)
    {
        _S409 = fabrics_0[_S403].warp_0;
    }
    else
    {
        _S409 = fabrics_0[_S403].weft_0;
    }
    var _S410 : u32;
    if(_S408.is_warp_2)
    {
        _S410 = fabrics_0[_S403].weft_0;
    }
    else
    {
        _S410 = fabrics_0[_S403].warp_0;
    }
    var _S411 : Cell_0 = select_cell_0(_S408.is_warp_2, sample_1.crossing_2.warp_1, sample_1.crossing_2.weft_1);
    var _S412 : Cell_0 = select_cell_0(_S408.is_warp_2, sample_1.crossing_2.weft_1, sample_1.crossing_2.warp_1);
    var _S413 : Run_0 = unpack_0(_S409, _S410, _S411.thread_1, _S412, _S408.word_0);
    var _S414 : Section_0 = section_at_0(_S411);
    var _S415 : bool;
    if(_S408.on_top_0)
    {
        _S415 = (_S413.distance_0) < (_S414.drop_0 * _S413.bend_1.sine_0);
    }
    else
    {
        _S415 = false;
    }
    var _S416 : bool;
    if(_S408.on_top_0)
    {
        _S416 = !_S415;
    }
    else
    {
        _S416 = false;
    }
    var _S417 : f32;
    if(_S416)
    {
        _S417 = 1.0f;
    }
    else
    {
        _S417 = -1.0f;
    }
    var _S418 : f32;
    if(_S415)
    {
        _S418 = _S413.other_reach_0;
    }
    else
    {
        _S418 = _S413.reach_0;
    }
    var _S419 : f32;
    if(_S415)
    {
        _S419 = _S418 + _S413.distance_0;
    }
    else
    {
        _S419 = max(_S418 - _S413.distance_0, 0.0f);
    }
    var _S420 : f32 = _S418 / _S413.bend_1.sine_0 - _S417 * _S414.drop_0;
    var _S421 : f32 = _S419 * _S419;
    var _S422 : f32 = max(_S420 * _S420 - _S421, 9.99999968265522539e-21f);
    var _S423 : f32 = rsqrt_0(_S422);
    var _S424 : f32 = _S421 / (_S422 * _S423 + _S420);
    var _S425 : bool = _S419 > 0.0f;
    var _S426 : f32;
    if(_S408.on_top_0)
    {
        _S426 = 1.0f;
    }
    else
    {
        _S426 = -1.0f;
    }
    var _S427 : f32;
    if(_S413.near_start_0)
    {
        _S427 = 1.0f;
    }
    else
    {
        _S427 = -1.0f;
    }
    var _S428 : f32 = _S426 * _S427;
    if(_S425)
    {
        _S426 = _S420 * _S423;
    }
    else
    {
        _S426 = 1.0f;
    }
    sample_1.slope_across_0 = _S414.slope_0 * _S426;
    if(_S425)
    {
        _S419 = _S428 * _S419 * _S423;
    }
    else
    {
        _S419 = 0.0f;
    }
    sample_1.slope_along_0 = _S419;
    var _S429 : Family_std430_0 = families_0[_S409];
    var _S430 : vec2<f32> = dive_0(_S410, _S408, _S413, _S412);
    if(_S413.straight_0)
    {
        _S417 = 0.0f;
    }
    else
    {
        _S417 = _S429.height_scale_0 * _S417;
    }
    sample_1.height_6 = _S417 * (_S418 * _S413.bend_1.half_tangent_0 - _S424) - _S429.height_scale_0 * _S414.drop_0 - _S430.x;
    var _S431 : f32 = _S429.height_scale_0 * sample_1.slope_across_0;
    var _S432 : f32 = _S429.height_scale_0 * sample_1.slope_along_0 - _S430.y;
    if(_S408.is_warp_2)
    {
        _S417 = _S431;
    }
    else
    {
        _S417 = _S432;
    }
    sample_1.slope_x_1 = _S417;
    if(_S408.is_warp_2)
    {
        _S417 = _S432;
    }
    else
    {
        _S417 = _S431;
    }
    sample_1.slope_y_1 = _S417;
    sample_1.run_3 = _S413;
    sample_1.section_1 = _S414;
    return sample_1;
}

fn steps_per_length_0( _S433 : u32,  _S434 : SearchQuality_0,  _S435 : vec3<f32>) -> f32
{
    return max(max(abs(_S435.x) * fabrics_0[_S433].threads_per_x_0, abs(_S435.y) * fabrics_0[_S433].threads_per_y_0) * _S434.steps_per_thread_0, abs(_S435.z) * fabrics_0[_S433].per_relief_0 * _S434.steps_per_relief_0);
}

fn cell_maximum_0( _S436 : u32,  _S437 : Crossing_0) -> f32
{
    var _S438 : u32;
    if(_S437.warp_above_0)
    {
        _S438 = fabrics_0[_S436].warp_0;
    }
    else
    {
        _S438 = fabrics_0[_S436].weft_0;
    }
    var _S439 : u32;
    if(_S437.warp_above_0)
    {
        _S439 = _S437.warp_word_0;
    }
    else
    {
        _S439 = _S437.weft_word_0;
    }
    return f32((_S439 >> (u32(28)))) * families_0[_S438].height_scale_0 * families_0[_S438].level_0;
}

fn probe_0( _S440 : u32,  _S441 : f32,  _S442 : f32,  _S443 : bool,  _S444 : bool,  _S445 : bool) -> Probe_0
{
    var _S446 : Sample_0 = sample_at_0(_S440, _S441, _S442, _S443);
    var probe_1 : Probe_0;
    probe_1.height_3 = _S446.height_6;
    probe_1.hole_4 = _S446.shown_3.hole_3;
    probe_1.slope_x_0 = _S446.slope_x_1;
    probe_1.slope_y_0 = _S446.slope_y_1;
    var _S447 : u32;
    if(_S446.shown_3.is_warp_2)
    {
        _S447 = _S446.crossing_2.warp_1.thread_1 * u32(2) + u32(1);
    }
    else
    {
        _S447 = _S446.crossing_2.weft_1.thread_1 * u32(2);
    }
    probe_1.yarn_1 = _S447;
    probe_1.cell_max_0 = cell_maximum_0(_S440, _S446.crossing_2);
    var _S448 : f32;
    if(_S444)
    {
        _S448 = _S446.crossing_2.warp_1.above_0;
    }
    else
    {
        _S448 = _S446.crossing_2.warp_1.below_0;
    }
    probe_1.side_x_0 = _S448;
    if(_S445)
    {
        _S448 = _S446.crossing_2.weft_1.above_0;
    }
    else
    {
        _S448 = _S446.crossing_2.weft_1.below_0;
    }
    probe_1.side_y_0 = _S448;
    probe_1.edge_x_0 = outline_distance_0(_S446.crossing_2.warp_1, _S446.shown_3, _S446.run_3, !_S446.shown_3.is_warp_2, _S444);
    probe_1.edge_y_0 = outline_distance_0(_S446.crossing_2.weft_1, _S446.shown_3, _S446.run_3, _S446.shown_3.is_warp_2, _S445);
    return probe_1;
}

fn is_free_0( _S449 : u32,  _S450 : SearchQuality_0,  _S451 : vec3<f32>,  _S452 : vec3<f32>,  _S453 : bool,  _S454 : f32) -> bool
{
    var _S455 : f32 = _S452.z;
    if(_S455 <= 0.0f)
    {
        return false;
    }
    var _S456 : f32 = 1.0f / max(_S450.shadow_share_0 * steps_per_length_0(_S449, _S450, _S452), 9.99999971718068537e-10f);
    var _S457 : StepControl_0 = step_control_0(_S452.xy, _S456);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S458 : bool;
        if(count_4 < u32(1024))
        {
            _S458 = (_S451.z + _S455 * distance_2) < _S454;
        }
        else
        {
            _S458 = false;
        }
        if(_S458)
        {
        }
        else
        {
            break;
        }
        var _S459 : vec3<f32> = _S451 + _S452 * vec3<f32>(distance_2);
        var _S460 : Probe_0 = probe_0(_S449, _S459.x, _S459.y, _S453, _S457.right_0, _S457.up_0);
        var _S461 : f32 = _S459.z;
        var _S462 : f32 = _S461 - _S460.height_3;
        var _S463 : f32 = _S455 - _S460.slope_x_0 * _S452.x - _S460.slope_y_0 * _S452.y;
        var _S464 : bool;
        if(!_S460.hole_4)
        {
            _S464 = _S462 < 0.0f;
        }
        else
        {
            _S464 = false;
        }
        if(_S464)
        {
            return false;
        }
        var _S465 : f32 = way_back_to_dip_0(previous_3, _S462, _S463, last_step_0, _S460);
        if(_S465 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S465;
            distance_2 = distance_2 - _S465;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S466 : bool = _S461 > (_S460.cell_max_0);
        var _S467 : PreviousSample_0 = after_sample_0(_S462, _S463, _S460, _S466);
        var last_step_2 : f32;
        if(_S466)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S457, _S460.side_x_0, _S460.side_y_0), _S456);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S457, _S460, _S462, _S463);
        }
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = _S467;
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S468 : u32,  _S469 : SearchQuality_0,  _S470 : f32,  _S471 : f32,  _S472 : vec3<f32>,  _S473 : bool) -> bool
{
    if(!sample_at_0(_S468, _S470, _S471, _S473).shown_3.hole_3)
    {
        return false;
    }
    var _S474 : vec3<f32> = vec3<f32>(_S470, _S471, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S475 : bool;
        if(side_1 < u32(2))
        {
            _S475 = passes_0;
        }
        else
        {
            _S475 = false;
        }
        if(_S475)
        {
        }
        else
        {
            break;
        }
        var _S476 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S476 = _S472;
        }
        else
        {
            _S476 = vec3<f32>(- _S472.x, - _S472.y, _S472.z);
        }
        var _S477 : bool = is_free_0(_S468, _S469, _S474, _S476, _S473 != (side_1 == u32(1)), fabrics_0[_S468].height_high_0);
        var _S478 : u32 = side_1 + u32(1);
        passes_0 = _S477;
        side_1 = _S478;
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

fn max_height_along_0( _S479 : u32,  _S480 : f32,  _S481 : f32,  _S482 : f32,  _S483 : vec3<f32>,  _S484 : bool) -> f32
{
    var _S485 : u32 = locate_0(fabrics_0[_S479].warp_0, _S480).thread_1 / u32(2);
    var _S486 : u32 = locate_0(fabrics_0[_S479].weft_0, _S481).thread_1 / u32(2);
    var _S487 : f32 = _S483.x;
    var _S488 : u32;
    if(_S487 > 0.0f)
    {
        _S488 = u32(1);
    }
    else
    {
        _S488 = u32(0);
    }
    var _S489 : f32 = _S483.y;
    var _S490 : u32;
    if(_S489 > 0.0f)
    {
        _S490 = u32(2);
    }
    else
    {
        _S490 = u32(0);
    }
    var _S491 : u32 = words_0[fabrics_0[_S479].max_heights_0 + u32(4) * (_S486 * fabrics_0[_S479].max_height_columns_0 + _S485) + (_S488 + _S490)];
    var number_1 : i32;
    if(_S484)
    {
        number_1 = i32(4);
    }
    else
    {
        number_1 = i32(0);
    }
    var _S492 : u32 = (_S491 >> (u32(number_1)));
    var _S493 : f32 = max(abs(_S487) * fabrics_0[_S479].threads_per_x_0, abs(_S489) * fabrics_0[_S479].threads_per_y_0) / _S483.z;
    var _S494 : f32 = fabrics_0[_S479].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S479].height_high_0;
    number_1 = i32(3);
    for(;;)
    {
        if(number_1 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S482) * _S493) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S492 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S494);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S495 : u32,  _S496 : f32,  _S497 : f32,  _S498 : bool,  _S499 : bool,  _S500 : bool) -> vec3<f32>
{
    var _S501 : Crossing_0 = crossing_at_0(_S495, _S496, _S497, _S498);
    var _S502 : f32 = cell_maximum_0(_S495, _S501);
    var _S503 : f32;
    if(_S499)
    {
        _S503 = _S501.warp_1.above_0;
    }
    else
    {
        _S503 = _S501.warp_1.below_0;
    }
    var _S504 : f32;
    if(_S500)
    {
        _S504 = _S501.weft_1.above_0;
    }
    else
    {
        _S504 = _S501.weft_1.below_0;
    }
    return vec3<f32>(_S502, _S503, _S504);
}

fn first_sample_height_0( _S505 : u32,  _S506 : ViewRay_0,  _S507 : StepControl_0,  _S508 : bool) -> f32
{
    var _S509 : f32 = max_height_along_0(_S505, _S506.origin_0.x, _S506.origin_0.y, 0.0f, vec3<f32>(_S506.slope_1, 1.0f), _S508);
    var count_5 : u32 = u32(0);
    var height_8 : f32 = _S509;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S510 : vec2<f32> = ViewRay_at_0(_S506, height_8);
        var _S511 : vec3<f32> = cell_bounds_0(_S505, _S510.x, _S510.y, _S508, _S507.right_0, _S507.up_0);
        var _S512 : f32 = height_8 - _S511.x;
        var _S513 : f32 = StepControl_to_cell_exit_0(_S507, _S511.y, _S511.z);
        var height_9 : f32 = height_8 - clamp(_S512, 0.0f, _S513);
        if(_S512 <= _S513)
        {
            height_8 = height_9;
            break;
        }
        count_5 = count_5 + u32(1);
        height_8 = height_9;
    }
    return height_8;
}

fn search_down_0( _S514 : u32,  _S515 : ViewRay_0,  _S516 : StepControl_0,  _S517 : bool) -> ViewRayEnd_0
{
    var _S518 : f32 = fabrics_0[_S514].height_low_0 - (fabrics_0[_S514].height_high_0 - fabrics_0[_S514].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_7 = first_sample_height_0(_S514, _S515, _S516, _S517);
    end_1.last_step_3 = _S516.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_6 : u32 = u32(0);
    for(;;)
    {
        if(count_6 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S519 : vec2<f32> = ViewRay_at_0(_S515, end_1.height_7);
        var _S520 : Probe_0 = probe_0(_S514, _S519.x, _S519.y, _S517, _S516.right_0, _S516.up_0);
        var _S521 : f32 = end_1.height_7 - _S520.height_3;
        var _S522 : f32 = ViewRay_rate_0(_S515, _S520);
        end_1.depth_1 = - _S521;
        end_1.rate_4 = _S522;
        var _S523 : bool;
        if(end_1.previous_4.known_0)
        {
            _S523 = !_S520.hole_4;
        }
        else
        {
            _S523 = false;
        }
        var _S524 : bool;
        if(_S523)
        {
            _S524 = (end_1.previous_4.yarn_0) == (_S520.yarn_1);
        }
        else
        {
            _S524 = false;
        }
        end_1.smooth_0 = _S524;
        var _S525 : bool;
        if(!_S520.hole_4)
        {
            _S525 = _S521 <= 0.0f;
        }
        else
        {
            _S525 = false;
        }
        var _S526 : bool;
        if(_S525)
        {
            _S526 = true;
        }
        else
        {
            _S526 = (end_1.height_7) <= _S518;
        }
        if(_S526)
        {
            break;
        }
        var _S527 : f32 = way_back_to_dip_0(end_1.previous_4, _S521, _S522, end_1.last_step_3, _S520);
        if(_S527 >= 0.0f)
        {
            end_1.height_7 = end_1.height_7 + _S527;
            end_1.last_step_3 = end_1.last_step_3 - _S527;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S528 : f32 = min(StepControl_to_cell_exit_0(_S516, _S520.side_x_0, _S520.side_y_0), end_1.height_7 - _S520.cell_max_0);
        var _S529 : f32 = StepControl_to_next_sample_0(_S516, _S520, _S521, _S522);
        end_1.previous_4 = after_sample_0(_S521, _S522, _S520, _S528 > _S529);
        var _S530 : f32 = max(_S528, _S529);
        end_1.last_step_3 = _S530;
        end_1.height_7 = end_1.height_7 - _S530;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S531 : u32,  _S532 : ViewRay_0,  _S533 : StepControl_0,  _S534 : bool,  _S535 : ViewRayEnd_0,  _S536 : u32) -> f32
{
    var _S537 : f32 = fabrics_0[_S531].height_high_0 - fabrics_0[_S531].height_low_0;
    var above_2 : f32 = _S535.height_7 + _S535.last_step_3;
    var above_gap_1 : f32 = clamp(_S535.previous_4.clearance_0, 0.0f, _S537);
    var under_gap_1 : f32 = clamp(_S535.depth_1, 0.0f, _S537);
    var _S538 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S535.previous_4.rate_0 * _S535.last_step_3, _S535.rate_4 * _S535.last_step_3);
    var middle_0 : f32;
    if(_S535.smooth_0)
    {
        middle_0 = above_2 - _S538 * _S535.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S535.height_7, above_gap_1, under_gap_1);
    }
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S535.height_7;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S536)
        {
        }
        else
        {
            break;
        }
        var _S539 : vec2<f32> = ViewRay_at_0(_S532, middle_0);
        var _S540 : Probe_0 = probe_0(_S531, _S539.x, _S539.y, _S534, _S533.right_0, _S533.up_0);
        var _S541 : f32;
        if(_S540.hole_4)
        {
            _S541 = -1.0e+09f;
        }
        else
        {
            _S541 = _S540.height_3;
        }
        var _S542 : f32 = clamp(middle_0 - _S541, - _S537, _S537);
        var _S543 : f32;
        if(_S542 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S543 = 0.5f * above_gap_2;
            }
            else
            {
                _S543 = above_gap_2;
            }
            var _S544 : f32 = - _S542;
            under_1 = middle_0;
            above_gap_2 = _S543;
            under_gap_2 = _S544;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S543 = 0.5f * under_gap_2;
            }
            else
            {
                _S543 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S542;
            under_gap_2 = _S543;
            side_2 = -1.0f;
        }
        if(_S535.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S542 / min(ViewRay_rate_0(_S532, _S540), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S535.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S545 : u32,  _S546 : SearchQuality_0,  _S547 : f32,  _S548 : f32,  _S549 : vec3<f32>,  _S550 : bool) -> Hit_0
{
    var _S551 : f32 = max(_S549.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S547, _S548);
    var _S552 : vec2<f32> = _S549.xy / vec2<f32>(_S551);
    ray_0.slope_1 = _S552;
    var _S553 : StepControl_0 = step_control_0((vec2<f32>(0) - _S552), 1.0f / max(steps_per_length_0(_S545, _S546, _S549) / _S551, 9.99999971718068537e-10f));
    var _S554 : ViewRayEnd_0 = search_down_0(_S545, ray_0, _S553, _S550);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S555 : f32 = refined_height_0(_S545, ray_0, _S553, _S550, _S554, _S546.refinements_0);
    hit_0.height_5 = _S555;
    var _S556 : vec2<f32> = ViewRay_at_0(ray_0, _S555);
    hit_0.x_14 = _S556.x;
    hit_0.y_7 = _S556.y;
    return hit_0;
}

fn first_hit_0( _S557 : u32,  _S558 : SearchQuality_0,  _S559 : f32,  _S560 : f32,  _S561 : vec3<f32>,  _S562 : bool) -> Hit_0
{
    if(!passes_through_0(_S557, _S558, _S559, _S560, _S561, _S562))
    {
        return first_hit_of_yarn_0(_S557, _S558, _S559, _S560, _S561, _S562);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S559;
    hit_1.y_7 = _S560;
    hit_1.height_5 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S563 : u32,  _S564 : f32,  _S565 : f32,  _S566 : bool) -> SurfacePoint_0
{
    var _S567 : Sample_0 = sample_at_0(_S563, _S564, _S565, _S566);
    var _S568 : f32;
    if(_S567.shown_3.is_warp_2)
    {
        _S568 = _S567.crossing_2.warp_1.half_width_1;
    }
    else
    {
        _S568 = _S567.crossing_2.weft_1.half_width_1;
    }
    var _S569 : u32;
    if(_S567.shown_3.is_warp_2)
    {
        _S569 = fabrics_0[_S563].warp_0;
    }
    else
    {
        _S569 = fabrics_0[_S563].weft_0;
    }
    var _S570 : Family_std430_0 = families_0[_S569];
    var _S571 : f32;
    if(_S566)
    {
        _S571 = -1.0f;
    }
    else
    {
        _S571 = 1.0f;
    }
    var _S572 : f32 = _S570.twist_sine_0 * _S571;
    var _S573 : Family_std430_0 = families_0[_S569];
    if(_S567.shown_3.is_warp_2)
    {
        _S571 = 1.0f;
    }
    else
    {
        _S571 = -1.0f;
    }
    var _S574 : vec2<f32> = fibre_direction_0(_S567.slope_across_0, _S571 * _S567.slope_along_0, _S572, _S573.twist_cosine_0);
    var _S575 : f32;
    if(_S567.shown_3.is_warp_2)
    {
        _S575 = _S567.slope_x_1;
    }
    else
    {
        _S575 = _S567.slope_y_1;
    }
    var _S576 : f32;
    if(_S567.shown_3.is_warp_2)
    {
        _S576 = _S567.slope_y_1;
    }
    else
    {
        _S576 = _S567.slope_x_1;
    }
    var _S577 : f32 = _S574.x;
    var _S578 : f32 = _S574.y;
    var _S579 : f32 = _S575 * _S577 + _S571 * _S576 * _S578;
    var _S580 : f32 = _S568 * 1.0154266357421875f;
    var _S581 : f32 = _S580 * arc_sine_0(clamp(_S567.section_1.across_3 / _S580, -1.0f, 1.0f));
    if(_S567.shown_3.is_warp_2)
    {
        _S568 = _S565;
    }
    else
    {
        _S568 = - _S564;
    }
    var point_3 : SurfacePoint_0;
    point_3.hole_0 = _S567.shown_3.hole_3;
    point_3.is_warp_0 = _S567.shown_3.is_warp_2;
    point_3.warp_thread_0 = _S567.crossing_2.warp_1.thread_1;
    point_3.weft_thread_0 = _S567.crossing_2.weft_1.thread_1;
    point_3.height_1 = _S567.height_6;
    point_3.normal_1 = normalize(vec3<f32>(- _S567.slope_x_1, - _S567.slope_y_1, 1.0f));
    var _S582 : vec3<f32>;
    if(_S567.shown_3.is_warp_2)
    {
        _S582 = vec3<f32>(_S577, _S578, _S579);
    }
    else
    {
        _S582 = vec3<f32>(- _S578, _S577, _S579);
    }
    point_3.tangent_0 = normalize(_S582);
    point_3.across_0 = _S567.section_1.across_3;
    point_3.fibre_across_0 = _S581 * _S573.twist_cosine_0 + _S568 * _S572;
    point_3.fibre_along_0 = _S568 * _S573.twist_cosine_0 - _S581 * _S572;
    return point_3;
}

struct YarnPoint_0
{
     back_4 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_15 : f32,
     y_8 : f32,
     height_10 : f32,
     normal_7 : vec3<f32>,
     tangent_7 : vec3<f32>,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
};

fn vary_albedos_0( _S583 : u32,  _S584 : Albedos_0,  _S585 : u32,  _S586 : u32) -> Albedos_0
{
    var _S587 : vec3<f32> = max(_S584.specular_reflect_0, _S584.specular_transmit_0);
    var _S588 : vec3<f32> = _S584.diffuse_reflect_0 + _S584.diffuse_transmit_0;
    var _S589 : vec3<f32> = vec3<f32>(fabrics_0[_S583].layer_bound_0);
    var _S590 : vec3<f32> = vec3<f32>(1.0f);
    var _S591 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S585, fabrics_0[_S583].colour_noise_0, fabrics_0[_S583].seed_0), _S588, _S590 - _S589 * _S587));
    var _S592 : f32 = bounded_gain_0(fibre_gain_0(_S585, _S586, fabrics_0[_S583].fibre_noise_0, fabrics_0[_S583].seed_0), _S587, min((_S590 - _S591 * _S588) / _S589, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S591 * _S584.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S591 * _S584.diffuse_transmit_0;
    var _S593 : vec3<f32> = vec3<f32>(_S592);
    varied_0.specular_reflect_0 = _S593 * _S584.specular_reflect_0;
    varied_0.specular_transmit_0 = _S593 * _S584.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S594 : u32,  _S595 : SurfacePoint_0,  _S596 : Albedos_0,  _S597 : f32,  _S598 : f32) -> Albedos_0
{
    var _S599 : f32;
    if(_S595.is_warp_0)
    {
        _S599 = _S597;
    }
    else
    {
        _S599 = _S598;
    }
    var _S600 : f32 = _S599 - _S595.across_0;
    var _S601 : u32;
    if(_S595.is_warp_0)
    {
        _S601 = fabrics_0[_S594].warp_0;
    }
    else
    {
        _S601 = fabrics_0[_S594].weft_0;
    }
    var _S602 : Family_std430_0 = families_0[_S601];
    var _S603 : i32 = i32(families_0[_S601].count_0);
    if(_S595.is_warp_0)
    {
        _S601 = _S595.warp_thread_0;
    }
    else
    {
        _S601 = _S595.weft_thread_0;
    }
    var _S604 : u32 = u32(i32(floor(_S600 / _S602.period_0)) * _S603 + i32(_S601)) * u32(2);
    if(_S595.is_warp_0)
    {
        _S601 = u32(1);
    }
    else
    {
        _S601 = u32(0);
    }
    var _S605 : f32 = floor(_S595.fibre_across_0 / fabrics_0[_S594].fibre_size_0);
    return vary_albedos_0(_S594, _S596, _S604 + _S601, u32(i32(_S605)) * u32(65536) + u32(i32(floor(_S595.fibre_along_0 / (fabrics_0[_S594].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S605))));
}

fn yarn_point_of_0( _S606 : u32,  _S607 : SurfacePoint_0,  _S608 : f32,  _S609 : f32,  _S610 : bool,  _S611 : bool) -> YarnPoint_0
{
    var _S612 : u32;
    if(_S607.is_warp_0)
    {
        _S612 = fabrics_0[_S606].warp_0;
    }
    else
    {
        _S612 = fabrics_0[_S606].weft_0;
    }
    var _S613 : u32;
    if(_S607.is_warp_0)
    {
        _S613 = _S607.warp_thread_0;
    }
    else
    {
        _S613 = _S607.weft_thread_0;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S612, _S613);
    var _S614 : bool;
    if((fabrics_0[_S606].fibre_noise_0) > 0.0f)
    {
        _S614 = true;
    }
    else
    {
        _S614 = (fabrics_0[_S606].colour_noise_0) > 0.0f;
    }
    var albedos_8 : Albedos_0;
    if(_S614)
    {
        albedos_8 = varied_at_0(_S606, _S607, albedos_7, _S608, _S609);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_4 : YarnPoint_0;
    point_4.back_4 = _S610;
    point_4.hole_6 = _S611;
    point_4.is_warp_3 = _S607.is_warp_0;
    point_4.x_15 = _S608;
    point_4.y_8 = _S609;
    point_4.height_10 = _S607.height_1;
    point_4.normal_7 = _S607.normal_1;
    point_4.tangent_7 = _S607.tangent_0;
    point_4.roughness_10 = families_0[_S612].roughness_0;
    point_4.albedos_6 = albedos_8;
    return point_4;
}

fn unoccluded_0( _S615 : u32,  _S616 : SearchQuality_0,  _S617 : f32,  _S618 : f32,  _S619 : f32,  _S620 : vec3<f32>,  _S621 : bool) -> bool
{
    if((_S620.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S615, _S616, vec3<f32>(_S617, _S618, _S619 + fabrics_0[_S615].lift_0), _S620, _S621, max_height_along_0(_S615, _S617, _S618, _S619, _S620, _S621));
}

fn is_lit_0( _S622 : u32,  _S623 : SearchQuality_0,  _S624 : YarnPoint_0,  _S625 : vec3<f32>) -> bool
{
    if(_S624.hole_6)
    {
        return true;
    }
    var _S626 : vec3<f32> = to_face_frame_0(_S625, _S624.back_4);
    var _S627 : f32 = _S626.z;
    var _S628 : bool = _S627 < 0.0f;
    var normal_8 : vec3<f32>;
    var height_11 : f32;
    if(_S628)
    {
        var _S629 : SurfacePoint_0 = surface_at_0(_S622, _S624.x_15, _S624.y_8, !_S624.back_4);
        normal_8 = _S629.normal_1;
        height_11 = _S629.height_1;
    }
    else
    {
        normal_8 = _S624.normal_7;
        height_11 = _S624.height_10;
    }
    var _S630 : vec3<f32> = vec3<f32>(_S626.xy, abs(_S627));
    if((dot(normal_8, _S630)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S622, _S623, _S624.x_15, _S624.y_8, height_11, _S630, (_S624.back_4) != _S628);
}

fn components_of_point_0( _S631 : u32,  _S632 : SearchQuality_0,  _S633 : YarnPoint_0,  _S634 : vec3<f32>,  _S635 : vec3<f32>) -> Components_0
{
    var result_2 : Components_0 = no_components_0();
    var _S636 : f32;
    if(_S633.hole_6)
    {
        _S636 = 1.0f;
    }
    else
    {
        _S636 = 0.0f;
    }
    result_2.hole_2 = _S636;
    var _S637 : bool;
    if(_S633.hole_6)
    {
        _S637 = true;
    }
    else
    {
        _S637 = !is_lit_0(_S631, _S632, _S633, _S634);
    }
    if(_S637)
    {
        return result_2;
    }
    var _S638 : vec3<f32> = to_face_frame_0(_S634, _S633.back_4);
    var _S639 : vec3<f32> = to_face_frame_0(_S635, _S633.back_4);
    var _S640 : bool = (_S638.z) < 0.0f;
    var _S641 : vec3<f32>;
    if(_S640)
    {
        _S641 = (vec3<f32>(0) - _S638);
    }
    else
    {
        _S641 = _S638;
    }
    var _S642 : f32 = diffuse_reflection_0(_S641, _S633.normal_7, fabrics_0[_S631].diffuse_blend_0);
    if(_S640)
    {
        _S636 = transmission_0(_S638, _S639, _S633.normal_7, _S633.tangent_7, _S633.roughness_10, fabrics_0[_S631].optical_depth_0);
    }
    else
    {
        _S636 = reflection_0(_S638, _S639, _S633.normal_7, _S633.tangent_7, _S633.roughness_10, fabrics_0[_S631].optical_depth_0);
    }
    var _S643 : f32;
    if(_S633.is_warp_3)
    {
        _S643 = _S642;
    }
    else
    {
        _S643 = 0.0f;
    }
    result_2.diffuse_warp_0 = _S643;
    if(_S633.is_warp_3)
    {
        _S643 = 0.0f;
    }
    else
    {
        _S643 = _S642;
    }
    result_2.diffuse_weft_0 = _S643;
    if(_S633.is_warp_3)
    {
        _S643 = _S636;
    }
    else
    {
        _S643 = 0.0f;
    }
    result_2.specular_warp_0 = _S643;
    if(_S633.is_warp_3)
    {
        _S636 = 0.0f;
    }
    result_2.specular_weft_0 = _S636;
    result_2.light_visibility_1 = 1.0f;
    return result_2;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S644 : u32,  _S645 : f32) -> vec3<f32>
{
    var _S646 : u32 = fabrics_0[_S644].lobes_0.levels_0 + u32(4) * u32(min(_S645, fabrics_0[_S644].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S646), table_number_0(_S646 + u32(1)), table_number_0(_S646 + u32(2)));
}

fn coverage_taps_0( _S647 : u32,  _S648 : Footprint_0,  _S649 : bool) -> CoverageTaps_0
{
    var _S650 : Lobes_std430_0 = fabrics_0[_S647].lobes_0;
    var _S651 : f32 = Footprint_spread_side_0(_S648) * fabrics_0[_S647].lobes_0.inverse_base_size_0;
    var _S652 : vec3<f32> = pyramid_level_0(_S647, floor(binary_logarithm_0(max(0.68000000715255737f * _S651, 1.0f))));
    var _S653 : f32 = 1.0f / max(_S651, 9.99999997475242708e-07f);
    var _S654 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S647].warp_0].inverse_period_0, families_0[fabrics_0[_S647].weft_0].inverse_period_0);
    var _S655 : vec2<f32> = _S648.centre_0 * _S654;
    var _S656 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S653 * _S653), 0.0f, 1.0f)), 0.3333333432674408f * _S653), 1.0f));
    var _S657 : vec2<f32> = _S648.dx_0 * _S654 * _S656;
    var _S658 : vec2<f32> = _S648.dy_0 * _S654 * _S656;
    var taps_3 : CoverageTaps_0;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(number_2 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S659 : vec2<f32> = _S655 + vec2<f32>(TAP_OFFSETS_0[number_2].x) * _S657 + vec2<f32>(TAP_OFFSETS_0[number_2].y) * _S658;
        var _S660 : f32 = _S652.y;
        var _S661 : f32 = wrapped_cell_0(_S659.x, _S660);
        var _S662 : f32 = wrapped_cell_0(_S659.y, _S652.z);
        var _S663 : u32;
        if(_S649)
        {
            _S663 = _S650.face_nodes_0;
        }
        else
        {
            _S663 = u32(0);
        }
        taps_3.nodes_1[number_2] = _S663 + u32(_S662 * _S660 + _S661 + _S652.x);
        number_2 = number_2 + u32(1);
    }
    return taps_3;
}

fn coverage_of_pack_0( _S664 : u32,  _S665 : CoverageTaps_0,  _S666 : u32) -> vec4<f32>
{
    var number_3 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S667 : u32 = words_0[fabrics_0[_S664].lobes_0.coverage_0 + _S665.nodes_1[number_3] * fabrics_0[_S664].lobes_0.packs_0 + _S666];
        var even_2 : u32 = even_1 + ((_S667 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S667 >> (u32(8)))) & (u32(16711935))));
        number_3 = number_3 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S668 : u32,  _S669 : CoverageTaps_0) -> f32
{
    var number_4 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_4 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S668].lobes_0.coverage_holes_0 + _S669.nodes_1[number_4] / u32(4)] >> ((u32(8) * (_S669.nodes_1[number_4] % u32(4)))))) & (u32(255))));
        number_4 = number_4 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S670 : u32,  _S671 : CoverageTaps_0,  _S672 : NodeTaps_0,  _S673 : bool) -> f32
{
    var _S674 : Lobes_std430_0 = fabrics_0[_S670].lobes_0;
    var _S675 : f32 = interpolate_table_0(_S672, fabrics_0[_S670].lobes_0.projected_area_0 + fabrics_0[_S670].lobes_0.packs_0, fabrics_0[_S670].lobes_0.packs_0 + u32(1)).x;
    var _S676 : f32;
    if(_S673)
    {
        _S676 = _S674.back_hole_weight_0;
    }
    else
    {
        _S676 = _S674.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S670, _S671) * _S675 * _S675 * _S676, 1.0f);
}

fn prefiltered_components_0( _S677 : u32,  _S678 : Footprint_0,  _S679 : vec3<f32>,  _S680 : vec3<f32>,  _S681 : bool) -> Components_0
{
    var _S682 : CoverageTaps_0 = coverage_taps_0(_S677, _S678, _S681);
    var _S683 : NodeTaps_0 = node_taps_0(_S680);
    var view_nodes_0 : NodeTaps_0 = _S683;
    var light_nodes_0 : NodeTaps_0 = node_taps_0(_S679);
    var seen_nodes_0 : NodeTaps_0 = _S683;
    var _S684 : u32;
    if(_S681)
    {
        _S684 = u32(1);
    }
    else
    {
        _S684 = u32(0);
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S684 * u32(256)));
    var _S685 : u32 = u32(2) * _S684;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + vec4<u32>((_S685 * u32(256)));
    var _S686 : u32;
    if((_S679.z) < 0.0f)
    {
        _S686 = u32(1);
    }
    else
    {
        _S686 = u32(0);
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((_S685 + _S686) * u32(256)));
    var _S687 : vec3<f32> = half_vector_0(_S679, _S680);
    var _S688 : vec3<f32> = shadow_correlation_0(_S679, _S680);
    if(_S681)
    {
        _S686 = fabrics_0[_S677].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S686 = fabrics_0[_S677].lobes_0.front_warp_packs_0;
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
        var _S689 : Lobes_std430_0 = fabrics_0[_S677].lobes_0;
        if(pack_0 < (fabrics_0[_S677].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S690 : vec4<f32> = coverage_of_pack_0(_S677, _S682, pack_0);
        var _S691 : vec4<f32> = interpolate_table_0(view_nodes_0, _S689.projected_area_0 + pack_0, _S689.packs_0 + u32(1));
        var _S692 : u32 = _S689.light_visibility_0 + pack_0;
        var _S693 : vec4<f32> = vec4<f32>(255.0f);
        var _S694 : vec4<f32> = interpolate_table_0(seen_nodes_0, _S692, _S689.packs_0) / _S693;
        var _S695 : vec4<f32> = interpolate_table_0(light_nodes_0, _S692, _S689.packs_0) / _S693;
        var _S696 : vec4<f32> = interpolate_table_0(light_nodes_0, _S689.irradiance_0 + pack_0, _S689.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S697 : bool = pack_0 < _S686;
        var _S698 : u32;
        if(_S697)
        {
            _S698 = fabrics_0[_S677].warp_0;
        }
        else
        {
            _S698 = fabrics_0[_S677].weft_0;
        }
        var _S699 : Family_std430_0 = families_0[_S698];
        var number_5 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_5 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S700 : Group_0 = group_at_0(_S689.moments_0 + u32(12) * (u32(4) * (_S684 * _S689.packs_0 + pack_0) + number_5), _S699.roughness_0);
            var _S701 : f32 = _S690[number_5] * _S691[number_5] * _S691[number_5] * _S700.weight_1;
            var _S702 : vec2<f32> = visibility_gain_0(_S688, _S695[number_5], _S694[number_5]);
            var _S703 : f32 = _S702.x;
            var diffuse_1 : f32 = diffuse_0 + _S701 * _S696[number_5] * _S703;
            var specular_1 : f32 = specular_0 + _S701 * layer_value_0(_S700, _S687, _S679, _S680, fabrics_0[_S677].optical_depth_0) * _S695[number_5] * _S702.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S701 * _S695[number_5] * _S703;
            var total_3 : f32 = total_2 + _S701;
            number_5 = number_5 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        var _S704 : f32;
        if(_S697)
        {
            _S704 = diffuse_0;
        }
        else
        {
            _S704 = 0.0f;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S704;
        var _S705 : f32;
        if(_S697)
        {
            _S705 = 0.0f;
        }
        else
        {
            _S705 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S705;
        var _S706 : f32;
        if(_S697)
        {
            _S706 = specular_0;
        }
        else
        {
            _S706 = 0.0f;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S706;
        var _S707 : f32;
        if(_S697)
        {
            _S707 = 0.0f;
        }
        else
        {
            _S707 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S707;
        pack_0 = pack_0 + u32(1);
    }
    var _S708 : f32 = prefiltered_hole_0(_S677, _S682, view_nodes_0, _S681);
    sums_1.hole_2 = _S708;
    var _S709 : f32 = (1.0f - _S708) / max(total_2, 9.999999960041972e-13f);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S709;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S709;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S709;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S709;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S709;
    return sums_1;
}

fn albedos_over_0( _S710 : u32,  _S711 : Footprint_0,  _S712 : bool) -> FamilyAlbedos_0
{
    var _S713 : vec2<f32> = _S711.dx_0;
    var _S714 : vec2<f32> = _S711.dy_0;
    var _S715 : vec2<f32> = sqrt(_S713 * _S713 + _S714 * _S714);
    var _S716 : Stretch_0 = stretch_of_0(fabrics_0[_S710].warp_0, _S711.centre_0.x, _S715.x);
    var _S717 : Stretch_0 = stretch_of_0(fabrics_0[_S710].weft_0, _S711.centre_0.y, _S715.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_2 = mean_albedos_0(fabrics_0[_S710].warp_0, fabrics_0[_S710].weft_0, _S716, _S717, _S712);
    albedos_9.weft_2 = mean_albedos_0(fabrics_0[_S710].weft_0, fabrics_0[_S710].warp_0, _S717, _S716, _S712);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S718 : u32,  _S719 : Footprint_0,  _S720 : f32,  _S721 : vec2<f32>,  _S722 : vec3<f32>,  _S723 : vec3<f32>) -> Estimate_0
{
    var _S724 : f32;
    var _S725 : Regime_0 = regime_of_0(_S718, _S719, _S720);
    var _S726 : bool = (_S723.z) < 0.0f;
    var _S727 : vec3<f32> = to_face_frame_0(_S723, _S726);
    var _S728 : bool;
    if((fabrics_0[_S718].fibre_noise_0) > 0.0f)
    {
        _S728 = true;
    }
    else
    {
        _S728 = (fabrics_0[_S718].colour_noise_0) > 0.0f;
    }
    var _S729 : bool;
    if((families_0[fabrics_0[_S718].warp_0].quantities_0) > u32(1))
    {
        _S729 = true;
    }
    else
    {
        _S729 = (families_0[fabrics_0[_S718].weft_0].quantities_0) > u32(1);
    }
    var _S730 : f32 = 1.0f - _S725.prefiltered_0;
    if(_S730 > 0.0f)
    {
        if(_S728)
        {
            _S729 = true;
        }
    }
    else
    {
        _S729 = false;
    }
    var box_0 : Footprint_0 = _S719;
    var _S731 : vec3<f32> = vec3<f32>(0.0f);
    var _S732 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S731, _S731, 0.0f, 0.0f, 0.0f);
    var _S733 : Components_0 = no_components_0();
    var _S734 : i32;
    if(_S729)
    {
        _S734 = i32(0);
    }
    else
    {
        _S734 = i32(1);
    }
    var _S735 : u32 = u32(_S734);
    var points_1 : Components_0 = _S733;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S732;
    var central_place_0 : vec2<f32> = _S719.centre_0;
    var number_6 : u32 = _S735;
    for(;;)
    {
        var _S736 : f32 = f32(number_6);
        _S724 = _S725.points_0;
        if(_S736 < (_S725.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S737 : bool = number_6 == u32(0);
        var _S738 : u32;
        if(_S737)
        {
            _S738 = u32(0);
        }
        else
        {
            _S738 = number_6 - u32(1);
        }
        var _S739 : vec2<f32> = POINT_OFFSETS_0[_S738] + _S721;
        var _S740 : vec2<f32>;
        if(_S737)
        {
            _S740 = vec2<f32>(0.0f);
        }
        else
        {
            _S740 = _S739 - round(_S739);
        }
        var _S741 : vec2<f32> = _S719.centre_0 + vec2<f32>(_S740.x) * _S719.dx_0 + vec2<f32>(_S740.y) * _S719.dy_0;
        var _S742 : f32;
        if(_S737)
        {
            _S742 = 0.0f;
        }
        else
        {
            _S742 = _S725.threads_1;
        }
        var _S743 : SearchQuality_0 = quality_of_0(_S742);
        var _S744 : Hit_0 = first_hit_0(_S718, _S743, _S741.x, _S741.y, _S727, _S726);
        var _S745 : SurfacePoint_0 = surface_at_0(_S718, _S744.x_14, _S744.y_7, _S726);
        if(_S737)
        {
            var central_weight_1 : f32;
            if(_S744.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S730;
            }
            var central_place_1 : vec2<f32> = vec2<f32>(_S744.x_14, _S744.y_7);
            box_0.centre_0 = mix(_S719.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S745;
            central_place_0 = central_place_1;
            number_6 = number_6 + u32(1);
            continue;
        }
        points_1 = with_added_0(points_1, components_of_point_0(_S718, _S743, yarn_point_of_0(_S718, _S745, _S744.x_14, _S744.y_7, _S726, _S744.hole_5), _S722, _S723), min(_S725.points_0 - f32(number_6 - u32(1)), 1.0f));
        number_6 = number_6 + u32(1);
    }
    var estimate_0 : Estimate_0;
    estimate_0.components_0 = with_added_0(_S733, points_1, _S730 / max(_S724, 1.0f));
    if((_S725.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S718, _S719, to_face_frame_0(_S722, _S726), _S727, _S726), _S725.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S718, box_0, _S726);
    if(_S728)
    {
        _S728 = central_weight_0 > 0.0f;
    }
    else
    {
        _S728 = false;
    }
    if(_S728)
    {
        var _S746 : SurfacePoint_0 = central_0;
        var _S747 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S747 = estimate_0.albedos_5.warp_2;
        }
        else
        {
            _S747 = estimate_0.albedos_5.weft_2;
        }
        var _S748 : Albedos_0 = lerp_albedos_0(_S747, varied_at_0(_S718, central_0, _S747, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S746.is_warp_0)
        {
            estimate_0.albedos_5.warp_2 = _S748;
        }
        else
        {
            estimate_0.albedos_5.weft_2 = _S748;
        }
    }
    return estimate_0;
}

fn composed_0( _S749 : u32,  _S750 : Components_0,  _S751 : FamilyAlbedos_0,  _S752 : vec3<f32>,  _S753 : vec3<f32>) -> vec3<f32>
{
    var _S754 : vec3<f32> = vec3<f32>(_S750.diffuse_warp_0);
    var _S755 : vec3<f32> = vec3<f32>(_S750.diffuse_weft_0);
    var _S756 : vec3<f32> = vec3<f32>(_S750.specular_warp_0);
    var _S757 : vec3<f32> = vec3<f32>(_S750.specular_weft_0);
    var _S758 : vec3<f32> = _S751.warp_2.diffuse_reflect_0 * _S754 + _S751.weft_2.diffuse_reflect_0 * _S755 + _S751.warp_2.specular_reflect_0 * _S756 + _S751.weft_2.specular_reflect_0 * _S757;
    var _S759 : f32 = _S753.z;
    var body_0 : vec3<f32>;
    if((_S752.z * _S759) < 0.0f)
    {
        body_0 = _S751.warp_2.diffuse_transmit_0 * _S754 + _S751.weft_2.diffuse_transmit_0 * _S755 + _S751.warp_2.specular_transmit_0 * _S756 + _S751.weft_2.specular_transmit_0 * _S757;
    }
    else
    {
        body_0 = _S758;
    }
    var _S760 : f32 = fabrics_0[_S749].sheen_strength_0;
    if((fabrics_0[_S749].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S761 : bool = _S759 < 0.0f;
    var _S762 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S752, _S761), to_face_frame_0(_S753, _S761), _S760, fabrics_0[_S749].sheen_roughness_0);
    return vec3<f32>(_S762.y) * body_0 + vec3<f32>(((_S750.light_visibility_1 + _S750.hole_2) * _S762.x));
}

fn light_of_footprint_0( _S763 : i32,  _S764 : u32,  _S765 : VisiblePoint_0,  _S766 : vec2<u32>,  _S767 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S765.draft_0;
    footprint_0.dx_0 = _S765.draft_dx_0;
    footprint_0.dy_0 = _S765.draft_dy_0;
    var _S768 : vec2<f32> = fract(vec2<f32>(f32(((frames_0[_S763].pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S769 : vec3<f32> = to_local_0(_S765, _S765.view_0);
    var _S770 : u32 = light_sample_count_0(_S763);
    var _S771 : vec3<f32> = vec3<f32>(0.0f);
    var number_7 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S771;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        if(number_7 < (max(_S770, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S772 : f32;
        if(number_7 < _S770)
        {
            _S772 = visibility_at_0(_S763, number_7, _S766);
        }
        else
        {
            _S772 = 0.0f;
        }
        var _S773 : bool;
        if(_S772 <= 0.0f)
        {
            _S773 = number_7 > u32(0);
        }
        else
        {
            _S773 = false;
        }
        if(_S773)
        {
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S774 : LightSample_0 = light_sample_0(_S763, number_7, _S766, _S765.position_0);
        var _S775 : vec3<f32> = to_local_0(_S765, _S774.towards_0);
        var _S776 : Estimate_0 = lobes_estimate_of_pass_0(_S764, footprint_0, 1.0f, _S768, _S775, _S769);
        var albedos_10 : FamilyAlbedos_0;
        albedos_10.warp_2 = tinted_0(_S776.albedos_5.warp_2, _S767);
        albedos_10.weft_2 = tinted_0(_S776.albedos_5.weft_2, _S767);
        radiance_1 = radiance_1 + vec3<f32>(_S772) * _S774.irradiance_1 * composed_0(_S764, _S776.components_0, albedos_10, _S775, _S769);
        hole_7 = _S776.components_0.hole_2;
        number_7 = number_7 + u32(1);
    }
    var _S777 : f32 = fabrics_0[_S764].sheen_strength_0;
    if((fabrics_0[_S764].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S777 * sheen_lobe_0(abs(_S769.z), fabrics_0[_S764].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S778 : u32 = id_0.x;
    var _S779 : u32 = frames_0[i32(0)].width_0;
    var _S780 : bool;
    if(_S778 >= (frames_0[i32(0)].width_0))
    {
        _S780 = true;
    }
    else
    {
        _S780 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S780)
    {
        return;
    }
    var _S781 : u32 = id_0.y * _S779 + _S778;
    var _S782 : u32 = layers_0[_S781].face_0;
    if((layers_0[_S781].face_0) == u32(0))
    {
        return;
    }
    var _S783 : u32 = _S782 - u32(1);
    var _S784 : u32 = face_fabrics_0[_S783];
    var _S785 : vec2<u32> = id_0.xy;
    var _S786 : VisiblePoint_0 = visible_point_0(i32(0), _S784, _S783, _S785);
    accumulate_0(_S781, light_of_footprint_0(i32(0), _S784, _S786, _S785, filtered_albedo_0(_S784, _S786)));
    return;
}

