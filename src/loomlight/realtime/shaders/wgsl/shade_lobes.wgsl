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
    @align(4) frames_1 : u32,
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
    @align(4) width_1 : f32,
    @align(4) height_1 : f32,
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

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S44 : vec2<f32> = direction_1.xy;
    var _S45 : f32;
    if(back_2)
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
     height_2 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     across_0 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32) -> SurfacePoint_0
{
    var _S46 : SurfacePoint_0;
    _S46.hole_0 = hole_1;
    _S46.is_warp_0 = is_warp_1;
    _S46.warp_thread_0 = warp_thread_1;
    _S46.weft_thread_0 = weft_thread_1;
    _S46.height_2 = height_3;
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

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

fn no_blocked_0() -> Blocked_0
{
    var nothing_1 : Blocked_0;
    nothing_1.by_warp_0 = 0.0f;
    nothing_1.by_weft_0 = 0.0f;
    nothing_1.far_0 = 0.0f;
    return nothing_1;
}

struct CloseUp_0
{
     weight_0 : f32,
     warp_1 : Blocked_0,
     weft_1 : Blocked_0,
};

fn no_close_up_0() -> CloseUp_0
{
    var nothing_2 : CloseUp_0;
    nothing_2.weight_0 = 0.0f;
    var _S47 : Blocked_0 = no_blocked_0();
    nothing_2.warp_1 = _S47;
    nothing_2.weft_1 = _S47;
    return nothing_2;
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
    var _S48 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S49 : f32 = mix(2.5f, 5.0f, _S48);
    quality_0.steps_per_thread_0 = _S49;
    quality_0.steps_per_relief_0 = _S49;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S48);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S48) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_4 : f32) -> vec2<f32>
{
    var _S50 : f32 = floor(fma(index_4, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S50, fma(- _S50, families_0[family_0].count_0, index_4));
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
    var _S51 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_1 : Cell_0;
    var _S52 : f32 = fma(- _S51, families_0[family_1].size_0, position_1);
    cell_1.below_0 = _S52;
    cell_1.above_0 = families_0[family_1].size_0 - _S52;
    cell_1.across_2 = _S52 - 0.5f * families_0[family_1].size_0;
    cell_1.half_width_1 = families_0[family_1].half_width_0;
    cell_1.thread_1 = u32(clamp(turns_and_remainder_0(family_1, _S51).y, 0.0f, families_0[family_1].count_0 - 1.0f));
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
    var _S53 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_2 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S54 : u32;
    if(_S53 >= (table_number_0(families_0[family_2].place_table_0 + thread_2 * u32(4) + u32(1))))
    {
        _S54 = u32(1);
    }
    else
    {
        _S54 = u32(0);
    }
    var _S55 : u32 = min(thread_2 + _S54, u32(families_0[family_2].count_0) - u32(1));
    var _S56 : u32 = families_0[family_2].place_table_0 + _S55 * u32(4);
    var cell_2 : Cell_0;
    cell_2.thread_1 = _S55;
    cell_2.below_0 = _S53 - table_number_0(_S56);
    cell_2.above_0 = table_number_0(_S56 + u32(1)) - _S53;
    cell_2.across_2 = _S53 - table_number_0(_S56 + u32(2));
    cell_2.half_width_1 = table_number_0(_S56 + u32(3));
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
     warp_2 : Cell_0,
     weft_2 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_0 : Crossing_0,  back_3 : bool) -> Shown_0
{
    var _S57 : bool = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    var _S58 : bool = (abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1);
    var shown_0 : Shown_0;
    var _S59 : bool;
    if(_S57)
    {
        if(!_S58)
        {
            _S59 = true;
        }
        else
        {
            _S59 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S59 = false;
    }
    shown_0.is_warp_2 = _S59;
    if(!_S57)
    {
        _S59 = !_S58;
    }
    else
    {
        _S59 = false;
    }
    shown_0.hole_3 = _S59;
    var _S60 : u32;
    if(shown_0.is_warp_2)
    {
        _S60 = crossing_0.warp_word_0;
    }
    else
    {
        _S60 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S60;
    shown_0.on_top_0 = (((_S60 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_1 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    var _S61 : u32;
    if(is_first_0)
    {
        _S61 = first_1.thread_1;
    }
    else
    {
        _S61 = second_0.thread_1;
    }
    cell_3.thread_1 = _S61;
    var _S62 : f32;
    if(is_first_0)
    {
        _S62 = first_1.across_2;
    }
    else
    {
        _S62 = second_0.across_2;
    }
    cell_3.across_2 = _S62;
    if(is_first_0)
    {
        _S62 = first_1.half_width_1;
    }
    else
    {
        _S62 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S62;
    if(is_first_0)
    {
        _S62 = first_1.below_0;
    }
    else
    {
        _S62 = second_0.below_0;
    }
    cell_3.below_0 = _S62;
    if(is_first_0)
    {
        _S62 = first_1.above_0;
    }
    else
    {
        _S62 = second_0.above_0;
    }
    cell_3.above_0 = _S62;
    return cell_3;
}

fn boundary_0( family_4 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S63 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_3) + step_0));
    return fma(_S63.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S63.y) * u32(4)));
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
    var _S64 : Family_std430_0 = families_0[family_6];
    var _S65 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S65 = u32(0);
    }
    else
    {
        _S65 = thread_5 * u32(4);
    }
    var _S66 : u32 = _S64.bend_table_0 + _S65;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S66);
    bend_0.half_tangent_0 = table_number_0(_S66 + u32(1));
    bend_0.arc_0 = table_number_0(_S66 + u32(2));
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
    var _S67 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S68 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S69 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S70 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S71 : i32 = - _S67;
    var _S72 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_1, _S71, i32(0));
    run_0.from_start_0 = _S72;
    var _S73 : i32 = _S68 + i32(1);
    var _S74 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_1, i32(1), _S73);
    run_0.to_end_0 = _S74;
    var _S75 : bool = _S72 < _S74;
    run_0.near_start_0 = _S75;
    var _S76 : i32;
    if(_S75)
    {
        _S76 = _S71 - _S69;
    }
    else
    {
        _S76 = _S73;
    }
    var _S77 : i32;
    if(run_0.near_start_0)
    {
        _S77 = _S71;
    }
    else
    {
        _S77 = _S73 + _S70;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_6);
    var _S78 : f32;
    if(run_0.straight_0)
    {
        _S78 = 1.0e+06f;
    }
    else
    {
        _S78 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S78;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_1, _S76, _S77), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S67 == i32(0);
    run_0.last_crossing_0 = _S68 == i32(0);
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
    var _S79 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S80 : f32 = clamp(cell_4.across_2, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S80;
    var _S81 : f32 = _S79 * _S79 - square_1(_S80);
    var _S82 : f32 = rsqrt_0(_S81);
    section_0.drop_0 = _S79 - _S81 * _S82;
    section_0.slope_0 = - _S80 * _S82;
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
    var _S83 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S84 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S85 : f32;
    if(_S83)
    {
        _S85 = crossed_1.below_0 - crossed_1.across_2;
    }
    else
    {
        _S85 = crossed_1.above_0 + crossed_1.across_2;
    }
    var _S86 : f32 = _S85 - crossed_1.half_width_1;
    var _S87 : bool;
    if(_S83)
    {
        _S87 = run_1.first_crossing_0;
    }
    else
    {
        _S87 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S85 = 0.0f;
    }
    else
    {
        _S85 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, i32(0));
    }
    var _S88 : f32;
    if((shown_1.on_top_0) != _S87)
    {
        _S88 = 0.0f;
    }
    else
    {
        var _S89 : Family_std430_0 = families_0[other_1];
        var _S90 : i32;
        if(_S83)
        {
            _S90 = i32(-1);
        }
        else
        {
            _S90 = i32(1);
        }
        _S88 = _S89.height_scale_0 * edge_drop_0(other_1, crossed_1.thread_1, _S90);
    }
    var _S91 : f32 = 1.0f / max(2.0f * _S86, 9.999999960041972e-13f);
    var _S92 : f32 = clamp((_S86 - _S84) * _S91, 0.0f, 1.0f);
    var _S93 : f32 = _S85 + (_S88 - _S85) * (_S92 * _S92 * (3.0f - 2.0f * _S92));
    var _S94 : f32 = (_S85 - _S88) * (6.0f * _S92 * (1.0f - _S92) * _S91);
    if(_S83)
    {
        _S85 = 1.0f;
    }
    else
    {
        _S85 = -1.0f;
    }
    return vec2<f32>(_S93, _S94 * _S85);
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
    var _S95 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S95), 9.99999971718068537e-10f);
    var _S96 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S96), 9.99999971718068537e-10f);
    control_0.right_0 = _S95 > 0.0f;
    control_0.up_0 = _S96 > 0.0f;
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
    var _S97 : f32;
    if(forwards_0)
    {
        _S97 = cell_5.across_2;
    }
    else
    {
        _S97 = - cell_5.across_2;
    }
    var _S98 : f32;
    if(forwards_0)
    {
        _S98 = cell_5.above_0;
    }
    else
    {
        _S98 = cell_5.below_0;
    }
    var _S99 : bool;
    if(forwards_0)
    {
        _S99 = run_2.last_crossing_0;
    }
    else
    {
        _S99 = run_2.first_crossing_0;
    }
    var _S100 : bool;
    if(forwards_0)
    {
        _S100 = run_2.first_crossing_0;
    }
    else
    {
        _S100 = run_2.last_crossing_0;
    }
    var _S101 : f32 = - cell_5.half_width_1;
    var _S102 : bool = _S97 < _S101;
    var _S103 : bool = _S97 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S99 = !_S99;
    }
    else
    {
        _S99 = false;
    }
    if(_S99)
    {
        _S99 = !shown_2.hole_3;
    }
    else
    {
        _S99 = false;
    }
    var _S104 : bool;
    if(_S99)
    {
        _S104 = shown_2.on_top_0;
    }
    else
    {
        _S104 = false;
    }
    if(_S104)
    {
        if(_S100)
        {
            _S100 = _S102;
        }
        else
        {
            _S100 = false;
        }
        _S100 = !_S100;
    }
    else
    {
        _S100 = false;
    }
    if(shown_2.hole_3)
    {
        _S99 = true;
    }
    else
    {
        if(_S99)
        {
            _S99 = !shown_2.on_top_0;
        }
        else
        {
            _S99 = false;
        }
    }
    var _S105 : f32;
    if(_S102)
    {
        _S105 = _S101;
    }
    else
    {
        _S105 = cell_5.half_width_1;
    }
    var _S106 : f32 = _S105 - _S97;
    if(_S99)
    {
        _S97 = 2.0f * _S98 + _S97 - cell_5.half_width_1;
    }
    else
    {
        _S97 = _S98;
    }
    if(_S100)
    {
        if(forwards_0)
        {
            _S97 = run_2.to_end_0;
        }
        else
        {
            _S97 = run_2.from_start_0;
        }
        return _S97;
    }
    if(_S103)
    {
    }
    else
    {
        _S97 = _S106;
    }
    return _S97;
}

struct Probe_0
{
     height_4 : f32,
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
    var _S107 : f32 = previous_1.rate_0 * step_4;
    var _S108 : f32 = rate_1 * step_4;
    var _S109 : bool;
    if(!previous_1.known_0)
    {
        _S109 = true;
    }
    else
    {
        _S109 = here_0.hole_4;
    }
    if(_S109)
    {
        _S109 = true;
    }
    else
    {
        _S109 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S109)
    {
        _S109 = true;
    }
    else
    {
        _S109 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S109)
    {
        _S109 = true;
    }
    else
    {
        _S109 = rate_1 <= 0.0f;
    }
    if(_S109)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S107) >= 0.0f)
    {
        _S109 = (3.0f * clearance_1 - _S108) >= 0.0f;
    }
    else
    {
        _S109 = false;
    }
    if(_S109)
    {
        return -1.0f;
    }
    var _S110 : f32 = clearance_1 - previous_1.clearance_0;
    var _S111 : f32 = 6.0f * _S110 - 4.0f * _S107 - 2.0f * _S108;
    var _S112 : f32 = -2.0f * _S107 / max(_S111 + sqrt(max(_S111 * _S111 - 4.0f * (3.0f * (_S107 + _S108 - 2.0f * _S110)) * _S107, 0.0f)), 9.99999968265522539e-21f);
    var _S113 : f32 = 1.0f - _S112;
    var _S114 : f32 = (previous_1.clearance_0 * (2.0f * _S112 + 1.0f) + _S107 * _S112) * _S113 * _S113;
    var _S115 : f32 = (clearance_1 * (2.0f * _S113 + 1.0f) - _S108 * _S113) * _S112 * _S112;
    if(_S112 > 0.01999999955296516f)
    {
        _S109 = _S113 > 0.01999999955296516f;
    }
    else
    {
        _S109 = false;
    }
    if(_S109)
    {
        _S109 = (_S114 + _S115) < 0.0f;
    }
    else
    {
        _S109 = false;
    }
    var _S116 : f32;
    if(_S109)
    {
        _S116 = _S113 * step_4;
    }
    else
    {
        _S116 = -1.0f;
    }
    return _S116;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S117 : f32;
    if(here_1.hole_4)
    {
        _S117 = 1.0e+09f;
    }
    else
    {
        _S117 = clearance_2;
    }
    previous_2.clearance_0 = _S117;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S118 : bool;
    if(!here_1.hole_4)
    {
        _S118 = !is_cell_exit_0;
    }
    else
    {
        _S118 = false;
    }
    previous_2.known_0 = _S118;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S119 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S120 : bool;
    if(!here_2.hole_4)
    {
        _S120 = (rate_3 * _S119 + clearance_3) < 0.0f;
    }
    else
    {
        _S120 = false;
    }
    if(_S120)
    {
        _S120 = _S119 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S120 = false;
    }
    var _S121 : f32;
    if(_S120)
    {
        _S121 = _S119 - this_2.epsilon_0;
    }
    else
    {
        _S121 = max(_S119, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S121);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_3 : ViewRay_0,  height_5 : f32) -> vec2<f32>
{
    return this_3.origin_0 + this_3.slope_1 * vec2<f32>(height_5);
}

fn ViewRay_rate_0( this_4 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_4.slope_1.x + here_3.slope_y_0 * this_4.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S122 : f32 = end_0 - start_1;
    var _S123 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S122;
    var _S124 : f32 = 3.0f * _S122 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S122, 9.99999968265522539e-21f);
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
        var _S125 : f32 = clamp(share_1 - (((_S123 * share_1 + _S124) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S123 * share_1 + 2.0f * _S124) * share_1 + start_rate_0, 0.10000000149011612f * _S122 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S126 : i32 = i_0 + i32(1);
        share_1 = _S125;
        i_0 = _S126;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S127 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S128 : f32 = rsqrt_0(_S127);
    var _S129 : f32 = sine_1 * _S128 * rsqrt_0(_S127 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S129 * _S127, _S129 * across_slope_0 * along_slope_0 + cosine_0 * _S128);
}

fn arc_sine_0( x_8 : f32) -> f32
{
    var _S130 : f32 = abs(x_8);
    var _S131 : bool = _S130 > 0.5f;
    var _S132 : f32;
    if(_S131)
    {
        _S132 = 0.5f * (1.0f - _S130);
    }
    else
    {
        _S132 = _S130 * _S130;
    }
    var _S133 : f32;
    if(_S131)
    {
        _S133 = sqrt(max(_S132, 0.0f));
    }
    else
    {
        _S133 = _S130;
    }
    var _S134 : f32 = ((((0.04216320067644119f * _S132 + 0.02418131195008755f) * _S132 + 0.04547002539038658f) * _S132 + 0.07495300471782684f) * _S132 + 0.16666752099990845f) * _S132 * _S133 + _S133;
    if(_S131)
    {
        _S132 = 1.57079637050628662f - 2.0f * _S134;
    }
    else
    {
        _S132 = _S134;
    }
    if(x_8 < 0.0f)
    {
        _S132 = - _S132;
    }
    return _S132;
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

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S135 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S135.x, _S135.y), _S135.z), 0.0f));
}

fn fibre_gain_0( thread_10 : u32,  cell_6 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_10, cell_6, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

fn diffuse_reflection_0( light_0 : vec3<f32>,  normal_3 : vec3<f32>,  blend_0 : f32) -> f32
{
    var _S136 : f32 = light_0.z;
    if(_S136 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S136, 0.0f), max(dot(light_0, normal_3), 0.0f), blend_0);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_2 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S137 : f32 = dot(direction_3, tangent_2);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S137 * _S137 + 1.0f, roughness_1 * roughness_1));
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
    var _S138 : f32 = roughness_2 * roughness_2;
    var _S139 : f32 = squared_along_0 * (1.0f - _S138) + _S138;
    return 0.31830987334251404f * _S138 * roughness_2 / (_S139 * _S139);
}

fn density_between_0( light_1 : vec3<f32>,  view_1 : vec3<f32>,  tangent_3 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S140 : vec3<f32> = light_1 + view_1;
    var _S141 : f32 = dot(_S140, tangent_3);
    return flake_density_0(min(_S141 * _S141 / max(square_0(_S140), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_2 : vec3<f32>,  view_2 : vec3<f32>,  normal_4 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S142 : f32 = - dot(light_2, normal_4);
    var _S143 : f32 = dot(view_2, normal_4);
    var _S144 : bool;
    if(_S142 <= 0.0f)
    {
        _S144 = true;
    }
    else
    {
        _S144 = _S143 <= 0.0f;
    }
    if(_S144)
    {
        return 0.0f;
    }
    var _S145 : f32 = 1.0f / max(_S143, 9.99999997475242708e-07f);
    var _S146 : f32 = projected_area_1(light_2, tangent_4, roughness_4) / max(_S142, 9.99999997475242708e-07f);
    var _S147 : f32 = projected_area_1(view_2, tangent_4, roughness_4) * _S145;
    return density_between_0(light_2, view_2, tangent_4, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S146, _S147)) * mean_attenuation_0(optical_depth_1 * abs(_S146 - _S147)) * _S145;
}

fn reflection_0( light_3 : vec3<f32>,  view_3 : vec3<f32>,  normal_5 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S148 : f32 = dot(light_3, normal_5);
    var _S149 : bool;
    if(_S148 <= 0.0f)
    {
        _S149 = true;
    }
    else
    {
        _S149 = (dot(view_3, normal_5)) <= 0.0f;
    }
    if(_S149)
    {
        return 0.0f;
    }
    var _S150 : f32 = max(_S148, 9.99999997475242708e-07f);
    var _S151 : f32 = max(dot(view_3, normal_5), 9.99999997475242708e-07f);
    var _S152 : f32 = projected_area_1(light_3, tangent_5, roughness_5) * _S151 + projected_area_1(view_3, tangent_5, roughness_5) * _S150;
    var _S153 : f32 = optical_depth_2 * _S152 / (_S150 * _S151);
    return 0.25f * density_between_0(light_3, view_3, tangent_5, roughness_5) * (_S153 * mean_attenuation_0(_S153)) * _S150 / _S152;
}

fn with_added_0( sums_0 : Components_0,  more_0 : Components_0,  weight_1 : f32) -> Components_0
{
    var result_0 : Components_0;
    result_0.diffuse_warp_0 = sums_0.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_0.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_0.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_0.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_0.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_0.hole_2 + weight_1 * more_0.hole_2;
    return result_0;
}

fn scaled_0( blocked_0 : Blocked_0,  share_2 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_2 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_2 * blocked_0.by_weft_0;
    result_1.far_0 = share_2 * blocked_0.far_0;
    return result_1;
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
    var _S154 : f32 = abs(x_10);
    var _S155 : f32 = abs(y_3);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S154, _S155) / max(max(_S154, _S155), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S155 > _S154)
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
    var _S156 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    var _S157 : f32 = floor(_S156);
    var _S158 : f32 = _S156 - _S157;
    var _S159 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S160 : f32 = 7.0f * _S159 * sqrt(_S159);
    var _S161 : f32 = min(floor(_S160), 6.0f);
    var _S162 : f32 = _S160 - _S161;
    var _S163 : u32 = u32(i32(_S157) + i32(32)) % u32(32);
    var _S164 : u32 = u32(_S161);
    var _S165 : u32 = _S163 * u32(8) + _S164;
    var _S166 : u32 = (_S163 + u32(1)) % u32(32) * u32(8) + _S164;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S165, _S165 + u32(1), _S166, _S166 + u32(1));
    var _S167 : f32 = 1.0f - _S158;
    var _S168 : f32 = 1.0f - _S162;
    var _S169 : vec4<u32> = vec4<u32>(vec4<f32>(_S167 * _S168, _S167 * _S162, _S158 * _S168, _S158 * _S162) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S169;
    taps_0.inverse_sum_0 = 1.0f / f32(_S169.x + _S169.y + _S169.z + _S169.w);
    return taps_0;
}

fn half_vector_0( light_4 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S170 : vec3<f32> = light_4 + view_4;
    return _S170 * vec3<f32>(rsqrt_0(max(square_0(_S170), 9.999999960041972e-13f)));
}

fn shadow_correlation_0( light_5 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S171 : vec2<f32> = light_5.xy;
    var _S172 : vec2<f32> = view_5.xy;
    var _S173 : f32 = dot(_S171, _S172) / max(sqrt(dot(_S171, _S171) * dot(_S172, _S172)), 9.99999997475242708e-07f);
    if((light_5.z) < 0.0f)
    {
        return vec3<f32>(vec2<f32>((-0.09000000357627869f + -0.07999999821186066f * _S173)), 0.0f);
    }
    return vec3<f32>(min(0.62000000476837158f + 0.62999999523162842f * _S173, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S174 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S175 : vec4<u32> = ((packs_1 & (_S174))) * taps_1.weights_0;
    var _S176 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S174))) * taps_1.weights_0;
    return bytes_of_sums_0(_S175.x + _S175.y + _S175.z + _S175.w, _S176.x + _S176.y + _S176.z + _S176.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_1 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S177 : vec4<u32> = vec4<u32>(table_1) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S177.x], words_0[_S177.y], words_0[_S177.z], words_0[_S177.w]));
}

struct Group_0
{
     normal_6 : vec3<f32>,
     weight_2 : f32,
     tangent_6 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_6 : f32,
};

fn group_at_0( row_1 : u32,  roughness_7 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_6 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_2 = table_number_0(row_1 + u32(3));
    var _S178 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_6 = _S178;
    var _S179 : f32 = table_number_0(row_1 + u32(7));
    var _S180 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S179, _S180, 1.0f - square_0(_S178) - _S179 - _S180);
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
    var _S181 : f32 = direction_5.x;
    var _S182 : f32 = direction_5.y;
    var _S183 : f32 = direction_5.z;
    return max(dot(this_5.variance_0, direction_5 * direction_5) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S181 * _S182, _S181 * _S183, _S182 * _S183)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_6 : vec3<f32>) -> f32
{
    var _S184 : f32 = dot(direction_6, group_1.tangent_6);
    var _S185 : f32 = group_1.roughness_6;
    var _S186 : f32 = _S185 * _S185;
    return sqrt(max((_S186 - 1.0f) * (_S184 * _S184 + Group_variance_along_0(group_1, direction_6)) + 1.0f, _S186));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S187 : f32 = group_2.roughness_6;
    var _S188 : f32 = max(sqrt(max(1.0f - _S187 * _S187, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S189 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S190 : f32 = dot(half_0, group_2.tangent_6);
    var _S191 : f32 = _S188 * (_S190 - _S189);
    var _S192 : f32 = _S188 * (_S190 + _S189);
    var _S193 : f32 = _S191 * _S192;
    var _S194 : f32 = 2.0f * _S189 * _S188;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S193) / ((_S191 * _S191 + 1.0f) * (_S192 * _S192 + 1.0f)) + arc_tangent_0(_S194, 1.0f + _S193) / _S194);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_6 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S195 : bool = (light_6.z) < 0.0f;
    var _S196 : f32 = dot(light_6, group_3.normal_6);
    var _S197 : f32;
    if(_S195)
    {
        _S197 = - _S196;
    }
    else
    {
        _S197 = _S196;
    }
    var _S198 : f32 = max(dot(view_6, group_3.normal_6), 0.01999999955296516f);
    var _S199 : f32 = mean_area_0(group_3, light_6) / max(_S197, 0.01999999955296516f);
    var _S200 : f32 = mean_area_0(group_3, view_6) / _S198;
    if(_S195)
    {
        _S197 = abs(_S199 - _S200);
    }
    else
    {
        _S197 = _S199 + _S200;
    }
    var _S201 : f32 = optical_depth_3 * max(_S197, 0.00100000004749745f);
    if(_S195)
    {
        _S197 = exponential_0(- optical_depth_3 * min(_S199, _S200));
    }
    else
    {
        _S197 = 1.0f;
    }
    var _S202 : f32 = optical_depth_3 * _S197 * (1.0f - exponential_0(- _S201)) / _S201 / _S198;
    if(_S195)
    {
        _S197 = 1.0f;
    }
    else
    {
        _S197 = 1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_6));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S197 * _S202;
}

struct Bound_0
{
     thread_11 : u32,
     turns_2 : f32,
     cell_7 : f32,
     visible_0 : f32,
     width_2 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_9 : u32,  position_5 : f32) -> Bound_0
{
    var _S203 : Cell_0 = locate_0(family_9, position_5);
    var _S204 : f32 = table_number_0(families_0[family_9].before_0 + u32(2) * _S203.thread_1 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_11 = _S203.thread_1;
    bound_0.turns_2 = round((position_5 - families_0[family_9].start_0 - _S204 - _S203.below_0) * families_0[family_9].inverse_period_0);
    bound_0.cell_7 = _S203.below_0;
    var _S205 : f32 = 2.0f * _S203.half_width_1;
    bound_0.width_2 = _S205;
    bound_0.visible_0 = clamp((_S203.across_2 + _S203.half_width_1) / _S205, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S203.below_0, _S203.below_0 - _S203.across_2 - _S203.half_width_1) + max(_S203.across_2 - _S203.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_10 : u32,  centre_1 : f32,  size_1 : f32) -> Stretch_0
{
    var _S206 : f32 = centre_1 - floor((centre_1 - families_0[family_10].start_0) * families_0[family_10].inverse_period_0) * families_0[family_10].period_0;
    var _S207 : f32 = 0.5f * max(size_1, families_0[family_10].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_10, _S206 - _S207);
    stretch_0.high_1 = bound_at_0(family_10, _S206 + _S207);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_11 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S208 : f32 = Stretch_turns_0(stretch_1);
    var _S209 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.low_1.thread_11;
    var _S210 : u32 = families_0[family_11].before_0 + u32(2) * stretch_1.high_1.thread_11;
    var _S211 : f32 = table_number_0(_S210) - table_number_0(_S209);
    var _S212 : f32 = table_number_0(_S210 + u32(1)) - table_number_0(_S209 + u32(1));
    return vec3<f32>(_S211 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_2 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_2 + _S208 * families_0[family_11].visible_total_0, _S212 - _S211 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S208 * (families_0[family_11].period_0 - families_0[family_11].visible_total_0), _S212 + stretch_1.high_1.cell_7 - stretch_1.low_1.cell_7 + _S208 * families_0[family_11].period_0);
}

fn integrals_along_0( family_12 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S213 : Family_std430_0 = families_0[family_12];
    var _S214 : u32 = u32(3) * _S213.quantities_0;
    var _S215 : u32 = families_0[family_12].colour_threads_0 + _S214 * stretch_2.low_1.thread_11 + quantity_0;
    var _S216 : u32 = families_0[family_12].colour_threads_0 + _S214 * stretch_2.high_1.thread_11 + quantity_0;
    var _S217 : u32 = families_0[family_12].colour_threads_0 + _S214 * u32(families_0[family_12].count_0) + quantity_0;
    var _S218 : f32 = table_number_0(_S215);
    var _S219 : f32 = table_number_0(_S216);
    var _S220 : f32 = Stretch_turns_0(stretch_2);
    var _S221 : u32 = u32(2) * _S213.quantities_0;
    return vec2<f32>(table_number_0(_S216 + _S213.quantities_0) - table_number_0(_S215 + _S213.quantities_0) + _S219 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_2 - _S218 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_2 + _S220 * table_number_0(_S217 + _S213.quantities_0), table_number_0(_S216 + _S221) - table_number_0(_S215 + _S221) + _S219 * stretch_2.high_1.cell_7 - _S218 * stretch_2.low_1.cell_7 + _S220 * table_number_0(_S217 + _S221));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_11) < (this_7.low_1.thread_11);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S222 : u32 = entries_0.z;
    var _S223 : u32 = entries_0.x;
    var _S224 : u32 = _S222 - _S223;
    var _S225 : u32;
    if(Stretch_wraps_0(this_8))
    {
        _S225 = whole_0;
    }
    else
    {
        _S225 = u32(0);
    }
    return vec4<u32>(_S224 + _S225, entries_0.w - _S222, entries_0.y - _S223, whole_0);
}

fn row_differences_0( across_4 : Stretch_0,  row_2 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S226 : u32 = row_2 + across_4.low_1.thread_11 * quantities_1;
    var _S227 : u32 = row_2 + across_4.high_1.thread_11 * quantities_1;
    return Stretch_differences_0(across_4, vec4<u32>(words_0[_S226], words_0[_S226 + quantities_1], words_0[_S227], words_0[_S227 + quantities_1]), words_0[row_2 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    var _S228 : f32 = - this_9.low_1.visible_0;
    var _S229 : f32 = Stretch_turns_0(this_9);
    var _S230 : f32;
    if(Stretch_wraps_0(this_9))
    {
        _S230 = 1.0f;
    }
    else
    {
        _S230 = 0.0f;
    }
    return vec4<f32>(1.0f, this_9.high_1.visible_0, _S228, _S229 - _S230);
}

fn integral_on_top_0( family_13 : u32,  across_5 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S231 : u32 = u32(families_0[family_13].count_0);
    var _S232 : u32 = (_S231 + u32(1)) * families_0[family_13].quantities_0;
    var _S233 : u32 = families_0[family_13].colour_areas_0 + quantity_1;
    var _S234 : vec4<u32> = row_differences_0(across_5, _S233 + along_0.low_1.thread_11 * _S232, _S231, families_0[family_13].quantities_0);
    var _S235 : vec4<u32> = row_differences_0(across_5, _S233 + (along_0.low_1.thread_11 + u32(1)) * _S232, _S231, families_0[family_13].quantities_0);
    var _S236 : vec4<u32> = row_differences_0(across_5, _S233 + along_0.high_1.thread_11 * _S232, _S231, families_0[family_13].quantities_0);
    var _S237 : vec4<u32> = row_differences_0(across_5, _S233 + (along_0.high_1.thread_11 + u32(1)) * _S232, _S231, families_0[family_13].quantities_0);
    var _S238 : vec4<u32> = row_differences_0(across_5, _S233 + crossing_count_0 * _S232, _S231, families_0[family_13].quantities_0);
    var _S239 : vec4<u32> = _S236 - _S234;
    var _S240 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S240 = _S238;
    }
    else
    {
        _S240 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S241 : vec4<f32> = Stretch_weights_0(across_5);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S239 + _S240)), _S241), dot(vec4<f32>(vec4<i32>(_S237 - _S236)), _S241), dot(vec4<f32>(vec4<i32>(_S235 - _S234)), _S241), dot(vec4<f32>(vec4<i32>(_S238)), _S241)), Stretch_weights_0(along_0)) * families_0[family_13].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S242 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S243 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S243 * _S242.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S243 * _S242.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S243 * _S242.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S243 * _S242.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_14 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_4 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_14].colour_mean_0);
    if((families_0[family_14].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S244 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_4 : f32 = 0.0f;
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
        var _S245 : vec2<f32> = integrals_along_0(family_14, own_1, quantity_2);
        var _S246 : f32 = integral_on_top_0(family_14, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S247 : f32 = _S245.x;
        var _S248 : f32 = _S247 * _S244.x;
        var _S249 : f32;
        if(back_4)
        {
            _S249 = _S248 - _S246;
        }
        else
        {
            _S249 = _S246;
        }
        var _S250 : bool = quantity_2 == u32(0);
        if(_S250)
        {
            is_exposed_0 = _S249 > (16.0f * families_0[family_14].area_unit_0 * min(_S248 / families_0[family_14].crossing_area_0, 1.0f) + 0.00000999999974738f * _S248);
        }
        var _S251 : f32 = _S247 * _S244.y;
        var _S252 : f32;
        if(is_exposed_0)
        {
            _S252 = _S249;
        }
        else
        {
            _S252 = 0.0f;
        }
        var _S253 : f32 = _S251 + _S252 + 0.000244140625f * _S244.z * _S245.y;
        if(_S250)
        {
            weight_4 = 1.0f / max(_S253, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S253 * weight_4, families_0[family_14].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn lerp_albedos_0( first_3 : Albedos_0,  second_1 : Albedos_0,  weight_5 : f32) -> Albedos_0
{
    var albedos_3 : Albedos_0;
    var _S254 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_3.diffuse_reflect_0, second_1.diffuse_reflect_0, _S254);
    albedos_3.diffuse_transmit_0 = mix(first_3.diffuse_transmit_0, second_1.diffuse_transmit_0, _S254);
    albedos_3.specular_reflect_0 = mix(first_3.specular_reflect_0, second_1.specular_reflect_0, _S254);
    albedos_3.specular_transmit_0 = mix(first_3.specular_transmit_0, second_1.specular_transmit_0, _S254);
    return albedos_3;
}

fn tinted_0( albedos_4 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_2 : Albedos_0 = albedos_4;
    result_2.diffuse_reflect_0 = result_2.diffuse_reflect_0 * tint_0;
    result_2.diffuse_transmit_0 = result_2.diffuse_transmit_0 * tint_0;
    return result_2;
}

struct FaceRadiance_0
{
     warp_3 : vec3<f32>,
     weft_3 : vec3<f32>,
     mean_1 : vec3<f32>,
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
    var _S255 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S256 : vec3<f32> = sends_0.sky_warp_0 + _S255 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S256;
    var _S257 : vec3<f32> = sends_0.sky_weft_0 + _S255 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S257;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S256 + vec3<f32>(sends_0.blocks_weft_0) * _S257;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_7 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S258 : f32 = 1.0f - view_7.z;
    var _S259 : f32 = _S258 * _S258;
    (*terms_0)[i32(0)] = 1.0f;
    var _S260 : f32 = view_7.x;
    var _S261 : f32 = _S260 * _S260;
    var _S262 : f32 = view_7.y;
    var _S263 : f32 = _S262 * _S262;
    (*terms_0)[i32(1)] = sqrt(max(_S261 + _S263, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S259;
    (*terms_0)[i32(3)] = _S259 * _S259;
    (*terms_0)[i32(4)] = _S261 - _S263;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_8 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S264 : f32 = 1.0f - view_8.z;
    var _S265 : f32 = _S264 * _S264;
    (*terms_1)[i32(0)] = 1.0f;
    var _S266 : f32 = view_8.x;
    var _S267 : f32 = _S266 * _S266;
    var _S268 : f32 = view_8.y;
    var _S269 : f32 = _S268 * _S268;
    (*terms_1)[i32(1)] = sqrt(max(_S267 + _S269, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S265;
    (*terms_1)[i32(3)] = _S265 * _S265;
    (*terms_1)[i32(4)] = _S267 - _S269;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Scattered_0
{
     back_5 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_4 : vec3<f32>,
     weft_4 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_2 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S270 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S271 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S271 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S271 * interior_0.far_1 + yarn_2.back_5 * _S270;
    return bounced_0;
}

fn sum_of_0( first_4 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_4.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_4.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_9 : vec3<f32>) -> vec3<f32>
{
    var _S272 : f32 = light_7.z;
    var _S273 : vec3<f32>;
    if((_S272 * view_9.z) < 0.0f)
    {
        _S273 = bounced_1.transmitted_0;
    }
    else
    {
        _S273 = bounced_1.reflected_0;
    }
    return _S273 * vec3<f32>((abs(_S272) * 0.31830987334251404f));
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
    var _S274 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S275 : f32 = 2.0f * sqrt(_S274) - 1.0f;
    var _S276 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S275, _S276), 0.00999999977648258f, 1.0f), clamp((1.0f - _S274) * sheen_shear_0(_S275, _S276), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S275, _S276), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_10 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S277 : f32 = light_8.z;
    var _S278 : bool;
    if(_S277 <= 0.0f)
    {
        _S278 = true;
    }
    else
    {
        _S278 = (view_10.z) <= 0.0f;
    }
    if(_S278)
    {
        return 0.0f;
    }
    var _S279 : vec2<f32> = view_10.xy;
    var _S280 : f32 = dot(_S279, _S279);
    var _S281 : vec2<f32>;
    if(_S280 > 9.99999968265522539e-21f)
    {
        _S281 = _S279 * vec2<f32>(rsqrt_0(_S280));
    }
    else
    {
        _S281 = vec2<f32>(1.0f, 0.0f);
    }
    var _S282 : f32 = scale_0 * dot(light_8.xy, _S281) + shear_0 * _S277;
    var _S283 : f32 = scale_0 * (light_8.y * _S281.x - light_8.x * _S281.y);
    var _S284 : f32 = _S282 * _S282 + _S283 * _S283 + _S277 * _S277;
    return 0.31830987334251404f * scale_0 * scale_0 * _S277 / max(_S284 * _S284, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_11 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S285 : vec3<f32> = sheen_lobe_0(view_11.z, roughness_9);
    var _S286 : f32 = strength_0 * _S285.z;
    return vec2<f32>(_S286 * transformed_cosine_0(light_9, view_11, _S285.x, _S285.y), 1.0f - _S286);
}

fn accumulate_0( index_7 : u32,  light_10 : vec4<f32>)
{
    var _S287 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_10;
    layers_0[index_7].share_0 = _S287 * (1.0f - light_10.w);
    return;
}

fn camera_right_0( _S288 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S288].right_x_0, frames_0[_S288].right_y_0, frames_0[_S288].right_z_0);
}

fn camera_up_0( _S289 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S289].up_x_0, frames_0[_S289].up_y_0, frames_0[_S289].up_z_0);
}

fn camera_forward_0( _S290 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S290].forward_x_0, frames_0[_S290].forward_y_0, frames_0[_S290].forward_z_0);
}

fn camera_origin_0( _S291 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S291].origin_x_0, frames_0[_S291].origin_y_0, frames_0[_S291].origin_z_0);
}

fn face_point_0( _S292 : u32,  _S293 : u32,  _S294 : f32,  _S295 : f32) -> VisiblePoint_0
{
    var _S296 : u32 = u32(3) * _S293;
    var _S297 : Vertex_std430_0 = vertices_0[corners_0[_S296]];
    var _S298 : Vertex_std430_0 = vertices_0[corners_0[_S296 + u32(1)]];
    var _S299 : Vertex_std430_0 = vertices_0[corners_0[_S296 + u32(2)]];
    var _S300 : vec3<f32> = position_of_0(&(_S298));
    var _S301 : vec3<f32> = position_of_0(&(_S297));
    var _S302 : vec3<f32> = _S300 - _S301;
    var _S303 : vec3<f32> = position_of_0(&(_S299));
    var _S304 : vec3<f32> = _S303 - _S301;
    var _S305 : f32 = _S297.u_0;
    var _S306 : f32 = _S298.u_0 - _S297.u_0;
    var _S307 : f32 = _S297.v_0;
    var _S308 : f32 = _S298.v_0 - _S297.v_0;
    var _S309 : vec2<f32> = vec2<f32>(_S306, _S308);
    var _S310 : f32 = _S299.u_0 - _S297.u_0;
    var _S311 : f32 = _S299.v_0 - _S297.v_0;
    var _S312 : vec2<f32> = vec2<f32>(_S310, _S311);
    var _S313 : f32;
    if((_S306 * _S311 - _S308 * _S310) < 0.0f)
    {
        _S313 = -1.0f;
    }
    else
    {
        _S313 = 1.0f;
    }
    var _S314 : vec3<f32> = vec3<f32>(_S313) * (vec3<f32>(_S311) * _S302 - vec3<f32>(_S308) * _S304);
    var _S315 : vec3<f32> = vec3<f32>(_S313) * (vec3<f32>(_S306) * _S304 - vec3<f32>(_S310) * _S302);
    var point_1 : VisiblePoint_0;
    var _S316 : f32 = 1.0f - _S294 - _S295;
    var _S317 : vec3<f32> = normal_of_0(&(_S297));
    var _S318 : vec3<f32> = vec3<f32>(_S316) * _S317;
    var _S319 : vec3<f32> = normal_of_0(&(_S298));
    var _S320 : vec3<f32> = vec3<f32>(_S294);
    var _S321 : vec3<f32> = _S318 + _S320 * _S319;
    var _S322 : vec3<f32> = normal_of_0(&(_S299));
    var _S323 : vec3<f32> = vec3<f32>(_S295);
    var _S324 : vec3<f32> = normalize(_S321 + _S323 * _S322);
    point_1.normal_0 = _S324;
    var _S325 : vec3<f32> = normalize(_S314 - _S324 * vec3<f32>(dot(_S324, _S314)));
    point_1.axis_x_0 = _S325;
    point_1.axis_y_0 = cross(_S324, _S325);
    var _S326 : vec3<f32> = normalize(cross(_S302, _S304));
    var _S327 : vec3<f32>;
    if((dot(_S326, _S324)) < 0.0f)
    {
        _S327 = (vec3<f32>(0) - _S326);
    }
    else
    {
        _S327 = _S326;
    }
    point_1.face_normal_0 = _S327;
    point_1.position_0 = _S301 + _S320 * _S302 + _S323 * _S304;
    point_1.view_0 = point_1.normal_0;
    point_1.uv_1 = vec2<f32>(_S305, _S307) + vec2<f32>(_S294) * _S309 + vec2<f32>(_S295) * _S312;
    var _S328 : bool = (dot(cross(_S314, _S315), point_1.normal_0)) < 0.0f;
    var _S329 : f32 = fabrics_0[_S292].uv_width_0;
    if(_S328)
    {
        _S313 = - fabrics_0[_S292].uv_height_0;
    }
    else
    {
        _S313 = fabrics_0[_S292].uv_height_0;
    }
    var _S330 : vec2<f32> = vec2<f32>(_S329, _S313);
    point_1.draft_per_uv_0 = _S330;
    var _S331 : vec2<f32> = point_1.uv_1 * _S330;
    if(_S328)
    {
        _S313 = fabrics_0[_S292].uv_height_0;
    }
    else
    {
        _S313 = 0.0f;
    }
    point_1.draft_0 = _S331 + vec2<f32>(0.0f, _S313);
    var _S332 : vec2<f32> = vec2<f32>(0.0f);
    point_1.draft_dx_0 = _S332;
    point_1.draft_dy_0 = _S332;
    return point_1;
}

fn visible_point_0( _S333 : i32,  _S334 : u32,  _S335 : u32,  _S336 : vec2<u32>) -> VisiblePoint_0
{
    var _S337 : u32 = u32(3) * _S335;
    var _S338 : Vertex_std430_0 = vertices_0[corners_0[_S337]];
    var _S339 : Vertex_std430_0 = vertices_0[corners_0[_S337 + u32(1)]];
    var _S340 : Vertex_std430_0 = vertices_0[corners_0[_S337 + u32(2)]];
    var _S341 : vec3<f32> = position_of_1(&(_S339));
    var _S342 : vec3<f32> = position_of_1(&(_S338));
    var _S343 : vec3<f32> = _S341 - _S342;
    var _S344 : vec3<f32> = position_of_1(&(_S340));
    var _S345 : vec3<f32> = _S344 - _S342;
    var _S346 : vec3<f32> = cross(_S343, _S345);
    var _S347 : f32 = 1.0f / max(square_0(_S346), 1.00000000317107685e-30f);
    var _S348 : f32 = f32(frames_0[_S333].width_0);
    var _S349 : vec3<f32> = camera_right_0(_S333) * vec3<f32>((2.0f / _S348));
    var _S350 : f32 = f32(frames_0[_S333].height_0);
    var _S351 : vec3<f32> = camera_up_0(_S333) * vec3<f32>((-2.0f / _S350));
    var _S352 : vec3<f32> = camera_forward_0(_S333) + vec3<f32>((f32(_S336.x) + 0.5f - 0.5f * _S348)) * _S349 + vec3<f32>((f32(_S336.y) + 0.5f - 0.5f * _S350)) * _S351;
    var _S353 : f32 = dot(_S352, _S346);
    var _S354 : f32;
    if((abs(_S353)) > 1.00000000317107685e-30f)
    {
        _S354 = _S353;
    }
    else
    {
        _S354 = 1.00000000317107685e-30f;
    }
    var _S355 : f32 = 1.0f / _S354;
    var _S356 : vec3<f32> = _S342 - camera_origin_0(_S333);
    var _S357 : vec3<f32> = vec3<f32>((dot(_S356, _S346) * _S355));
    var _S358 : vec3<f32> = _S352 * _S357 - _S356;
    var _S359 : vec3<f32> = _S357 * (_S349 - _S352 * vec3<f32>((dot(_S349, _S346) * _S355)));
    var _S360 : vec3<f32> = _S357 * (_S351 - _S352 * vec3<f32>((dot(_S351, _S346) * _S355)));
    var _S361 : vec3<f32> = vec3<f32>(_S347);
    var _S362 : vec3<f32> = cross(_S345, _S346) * _S361;
    var _S363 : vec3<f32> = cross(_S346, _S343) * _S361;
    var _S364 : vec2<f32> = vec2<f32>(_S339.u_0 - _S338.u_0, _S339.v_0 - _S338.v_0);
    var _S365 : vec2<f32> = vec2<f32>(_S340.u_0 - _S338.u_0, _S340.v_0 - _S338.v_0);
    var point_2 : VisiblePoint_0 = face_point_0(_S334, _S335, dot(_S358, _S362), dot(_S358, _S363));
    point_2.position_0 = _S342 + _S358;
    point_2.view_0 = (vec3<f32>(0) - normalize(_S352));
    point_2.draft_dx_0 = (vec2<f32>(dot(_S359, _S362)) * _S364 + vec2<f32>(dot(_S359, _S363)) * _S365) * point_2.draft_per_uv_0;
    point_2.draft_dy_0 = (vec2<f32>(dot(_S360, _S362)) * _S364 + vec2<f32>(dot(_S360, _S363)) * _S365) * point_2.draft_per_uv_0;
    return point_2;
}

fn filtered_albedo_0( _S366 : u32,  _S367 : VisiblePoint_0) -> vec3<f32>
{
    var _S368 : u32 = fabrics_0[_S366].albedo_map_levels_0;
    if((fabrics_0[_S366].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S369 : vec2<f32> = vec2<f32>(fabrics_0[_S366].uv_width_0, fabrics_0[_S366].uv_height_0);
    var _S370 : vec2<f32> = _S367.draft_dx_0 / _S369;
    var _S371 : vec2<f32> = _S367.draft_dy_0 / _S369;
    var _S372 : u32 = _S368 - u32(1);
    var _S373 : u32 = (u32(1) << (_S372));
    var _S374 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S370.x * _S371.y - _S370.y * _S371.x), 9.99999968265522539e-21f) * (square_1(f32(_S373)) / 3.0f)), 0.0f, f32(_S368) - 1.0f);
    var _S375 : u32 = min(u32(_S374), max(_S368, u32(2)) - u32(2));
    var _S376 : u32 = min(_S375 + u32(1), _S372);
    var _S377 : u32 = (u32(1) << ((u32(2) * _S368)));
    return mix(map_level_0(fabrics_0[_S366].albedo_map_0 + (_S377 - ((_S377 >> ((u32(2) * _S375))))) / u32(3), (_S373 >> (_S375)), _S367.uv_1), map_level_0(fabrics_0[_S366].albedo_map_0 + (_S377 - ((_S377 >> ((u32(2) * _S376))))) / u32(3), (_S373 >> (_S376)), _S367.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S374 - f32(_S375))) - 1.0f) / 3.0f)));
}

fn light_sample_count_0( _S378 : i32) -> u32
{
    return frames_0[_S378].lights_0 + frames_0[_S378].environment_samples_0;
}

fn visibility_at_0( _S379 : i32,  _S380 : u32,  _S381 : vec2<u32>) -> f32
{
    if((frames_0[_S379].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S380 * frames_0[_S379].height_0 + _S381.y) * frames_0[_S379].width_0 + _S381.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S382 : i32,  _S383 : u32,  _S384 : u32) -> vec3<f32>
{
    var _S385 : u32 = frames_0[_S382].environment_table_0 + frames_0[_S382].environment_rows_0 + u32(1) + frames_0[_S382].environment_rows_0 * (frames_0[_S382].environment_columns_0 + u32(1)) + u32(3) * (_S383 * frames_0[_S382].environment_columns_0 + _S384);
    return vec3<f32>(scene_number_0(_S385), scene_number_0(_S385 + u32(1)), scene_number_0(_S385 + u32(2)));
}

fn sample_environment_0( _S386 : i32,  _S387 : vec2<f32>,  _S388 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S389 : u32 = frames_0[_S386].environment_rows_0;
    var _S390 : Choice_0 = choose_0(frames_0[_S386].environment_table_0, frames_0[_S386].environment_rows_0, _S387.y);
    var _S391 : u32 = frames_0[_S386].environment_columns_0;
    var _S392 : Choice_0 = choose_0(frames_0[_S386].environment_table_0 + frames_0[_S386].environment_rows_0 + u32(1) + _S390.index_3 * (frames_0[_S386].environment_columns_0 + u32(1)), frames_0[_S386].environment_columns_0, _S387.x);
    var _S393 : vec3<f32> = environment_texel_0(_S386, _S390.index_3, _S392.index_3);
    (*_S388) = _S393 * vec3<f32>((frames_0[_S386].environment_total_0 / max(mean_0(_S393), 9.99999968265522539e-21f)));
    var _S394 : f32 = 3.14159274101257324f / f32(_S389);
    var _S395 : f32 = mix(sine_cosine_0(f32(_S390.index_3) * _S394).y, sine_cosine_0(f32(_S390.index_3 + u32(1)) * _S394).y, _S390.remainder_0);
    var _S396 : f32 = sqrt(max(1.0f - _S395 * _S395, 0.0f));
    var _S397 : vec2<f32> = sine_cosine_0((f32(_S392.index_3) + _S392.remainder_0) * (6.28318548202514648f / f32(_S391)));
    var _S398 : f32 = _S396 * _S397.x;
    var _S399 : f32 = - _S396 * _S397.y;
    return vec3<f32>(frames_0[_S386].environment_cosine_0 * _S398 + frames_0[_S386].environment_sine_0 * _S399, _S395, frames_0[_S386].environment_cosine_0 * _S399 - frames_0[_S386].environment_sine_0 * _S398);
}

fn light_sample_0( _S400 : i32,  _S401 : u32,  _S402 : vec2<u32>,  _S403 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S404 : u32 = frames_0[_S400].lights_0;
    if(_S401 >= (frames_0[_S400].lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S405 : vec3<f32> = sample_environment_0(_S400, pixel_sequence_0(_S402, frames_0[_S400].pass_number_0 * frames_0[_S400].environment_samples_0 + (_S401 - _S404), u32(3)), &(weight_6));
        sample_0.towards_0 = _S405;
        sample_0.irradiance_1 = weight_6 / vec3<f32>(f32(frames_0[_S400].environment_samples_0));
        return sample_0;
    }
    var _S406 : Light_std430_0 = lights_1[_S401];
    sample_0.irradiance_1 = vec3<f32>(_S406.red_0, _S406.green_0, _S406.blue_0);
    sample_0.towards_0 = vec3<f32>(_S406.x_1, _S406.y_1, _S406.z_1);
    if((_S406.is_point_0) != u32(0))
    {
        var _S407 : vec3<f32> = sample_0.towards_0 - _S403;
        var _S408 : f32 = max(square_0(_S407), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S408);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S408);
        sample_0.towards_0 = normalize(_S407);
    }
    return sample_0;
}

struct FamilyAlbedos_0
{
     warp_5 : Albedos_0,
     weft_5 : Albedos_0,
};

struct Estimate_0
{
     components_0 : Components_0,
     close_0 : CloseUp_0,
     albedos_5 : FamilyAlbedos_0,
};

struct Regime_0
{
     prefiltered_0 : f32,
     threads_1 : f32,
     points_0 : f32,
};

fn regime_of_0( _S409 : u32,  _S410 : Footprint_0,  _S411 : f32) -> Regime_0
{
    var _S412 : f32 = Footprint_spread_side_0(_S410);
    var _S413 : f32 = clamp((binary_logarithm_0(max(_S412, 9.99999971718068537e-10f)) - fabrics_0[_S409].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S414 : f32 = _S413 * _S413 * (3.0f - 2.0f * _S413);
    regime_0.prefiltered_0 = _S414;
    regime_0.threads_1 = _S412 * fabrics_0[_S409].lobes_0.threads_per_mm_0;
    var _S415 : f32 = mix(max(8.0f / _S411, 1.0f), 1.0f, _S414);
    var _S416 : f32;
    if(_S414 < 1.0f)
    {
        _S416 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S415);
    }
    else
    {
        _S416 = 0.0f;
    }
    regime_0.points_0 = _S416;
    return regime_0;
}

struct Hit_0
{
     x_14 : f32,
     y_7 : f32,
     hole_5 : bool,
     height_6 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_7 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S417 : u32,  _S418 : f32,  _S419 : f32,  _S420 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S417].warp_0, _S418);
    crossing_3.weft_2 = locate_0(fabrics_0[_S417].weft_0, _S419);
    var _S421 : u32 = fabrics_0[_S417].run_words_0 + u32(2) * (crossing_3.weft_2.thread_1 * fabrics_0[_S417].ends_1 + crossing_3.warp_2.thread_1);
    var _S422 : u32 = words_0[_S421];
    crossing_3.warp_word_0 = _S422;
    crossing_3.weft_word_0 = words_0[_S421 + u32(1)];
    crossing_3.warp_above_0 = (((_S422 & (u32(1)))) == u32(1)) != _S420;
    return crossing_3;
}

fn sample_at_0( _S423 : u32,  _S424 : f32,  _S425 : f32,  _S426 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S427 : Crossing_0 = crossing_at_0(_S423, _S424, _S425, _S426);
    sample_1.crossing_2 = _S427;
    var _S428 : Shown_0 = shown_at_0(_S427, _S426);
    sample_1.shown_3 = _S428;
    var _S429 : u32;
    if(_S428.is_warp_2)
    {
        _S429 = fabrics_0[_S423].warp_0;
    }
    else
    {
        _S429 = fabrics_0[_S423].weft_0;
    }
    var _S430 : u32;
    if(_S428.is_warp_2)
    {
        _S430 = fabrics_0[_S423].weft_0;
    }
    else
    {
        _S430 = fabrics_0[_S423].warp_0;
    }
    var _S431 : Cell_0 = select_cell_0(_S428.is_warp_2, sample_1.crossing_2.warp_2, sample_1.crossing_2.weft_2);
    var _S432 : Cell_0 = select_cell_0(_S428.is_warp_2, sample_1.crossing_2.weft_2, sample_1.crossing_2.warp_2);
    var _S433 : Run_0 = unpack_0(_S429, _S430, _S431.thread_1, _S432, _S428.word_0);
    var _S434 : Section_0 = section_at_0(_S431);
    var _S435 : bool;
    if(_S428.on_top_0)
    {
        _S435 = (_S433.distance_0) < (_S434.drop_0 * _S433.bend_1.sine_0);
    }
    else
    {
        _S435 = false;
    }
    var _S436 : bool;
    if(_S428.on_top_0)
    {
        _S436 = !_S435;
    }
    else
    {
        _S436 = false;
    }
    var _S437 : f32;
    if(_S436)
    {
        _S437 = 1.0f;
    }
    else
    {
        _S437 = -1.0f;
    }
    var _S438 : f32;
    if(_S435)
    {
        _S438 = _S433.other_reach_0;
    }
    else
    {
        _S438 = _S433.reach_0;
    }
    var _S439 : f32;
    if(_S435)
    {
        _S439 = _S438 + _S433.distance_0;
    }
    else
    {
        _S439 = max(_S438 - _S433.distance_0, 0.0f);
    }
    var _S440 : f32 = _S438 / _S433.bend_1.sine_0 - _S437 * _S434.drop_0;
    var _S441 : f32 = _S439 * _S439;
    var _S442 : f32 = max(_S440 * _S440 - _S441, 9.99999968265522539e-21f);
    var _S443 : f32 = rsqrt_0(_S442);
    var _S444 : f32 = _S441 / (_S442 * _S443 + _S440);
    var _S445 : bool = _S439 > 0.0f;
    var _S446 : f32;
    if(_S428.on_top_0)
    {
        _S446 = 1.0f;
    }
    else
    {
        _S446 = -1.0f;
    }
    var _S447 : f32;
    if(_S433.near_start_0)
    {
        _S447 = 1.0f;
    }
    else
    {
        _S447 = -1.0f;
    }
    var _S448 : f32 = _S446 * _S447;
    if(_S445)
    {
        _S446 = _S440 * _S443;
    }
    else
    {
        _S446 = 1.0f;
    }
    sample_1.slope_across_0 = _S434.slope_0 * _S446;
    if(_S445)
    {
        _S439 = _S448 * _S439 * _S443;
    }
    else
    {
        _S439 = 0.0f;
    }
    sample_1.slope_along_0 = _S439;
    var _S449 : Family_std430_0 = families_0[_S429];
    var _S450 : vec2<f32> = dive_0(_S430, _S428, _S433, _S432);
    if(_S433.straight_0)
    {
        _S437 = 0.0f;
    }
    else
    {
        _S437 = _S449.height_scale_0 * _S437;
    }
    sample_1.height_7 = _S437 * (_S438 * _S433.bend_1.half_tangent_0 - _S444) - _S449.height_scale_0 * _S434.drop_0 - _S450.x;
    var _S451 : f32 = _S449.height_scale_0 * sample_1.slope_across_0;
    var _S452 : f32 = _S449.height_scale_0 * sample_1.slope_along_0 - _S450.y;
    if(_S428.is_warp_2)
    {
        _S437 = _S451;
    }
    else
    {
        _S437 = _S452;
    }
    sample_1.slope_x_1 = _S437;
    if(_S428.is_warp_2)
    {
        _S437 = _S452;
    }
    else
    {
        _S437 = _S451;
    }
    sample_1.slope_y_1 = _S437;
    sample_1.run_3 = _S433;
    sample_1.section_1 = _S434;
    return sample_1;
}

fn steps_per_length_0( _S453 : u32,  _S454 : SearchQuality_0,  _S455 : vec3<f32>) -> f32
{
    return max(max(abs(_S455.x) * fabrics_0[_S453].threads_per_x_0, abs(_S455.y) * fabrics_0[_S453].threads_per_y_0) * _S454.steps_per_thread_0, abs(_S455.z) * fabrics_0[_S453].per_relief_0 * _S454.steps_per_relief_0);
}

fn cell_maximum_0( _S456 : u32,  _S457 : Crossing_0) -> f32
{
    var _S458 : u32;
    if(_S457.warp_above_0)
    {
        _S458 = fabrics_0[_S456].warp_0;
    }
    else
    {
        _S458 = fabrics_0[_S456].weft_0;
    }
    var _S459 : u32;
    if(_S457.warp_above_0)
    {
        _S459 = _S457.warp_word_0;
    }
    else
    {
        _S459 = _S457.weft_word_0;
    }
    return f32((_S459 >> (u32(28)))) * families_0[_S458].height_scale_0 * families_0[_S458].level_0;
}

fn probe_0( _S460 : u32,  _S461 : f32,  _S462 : f32,  _S463 : bool,  _S464 : bool,  _S465 : bool) -> Probe_0
{
    var _S466 : Sample_0 = sample_at_0(_S460, _S461, _S462, _S463);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S466.height_7;
    probe_1.hole_4 = _S466.shown_3.hole_3;
    probe_1.slope_x_0 = _S466.slope_x_1;
    probe_1.slope_y_0 = _S466.slope_y_1;
    var _S467 : u32;
    if(_S466.shown_3.is_warp_2)
    {
        _S467 = _S466.crossing_2.warp_2.thread_1 * u32(2) + u32(1);
    }
    else
    {
        _S467 = _S466.crossing_2.weft_2.thread_1 * u32(2);
    }
    probe_1.yarn_1 = _S467;
    probe_1.cell_max_0 = cell_maximum_0(_S460, _S466.crossing_2);
    var _S468 : f32;
    if(_S464)
    {
        _S468 = _S466.crossing_2.warp_2.above_0;
    }
    else
    {
        _S468 = _S466.crossing_2.warp_2.below_0;
    }
    probe_1.side_x_0 = _S468;
    if(_S465)
    {
        _S468 = _S466.crossing_2.weft_2.above_0;
    }
    else
    {
        _S468 = _S466.crossing_2.weft_2.below_0;
    }
    probe_1.side_y_0 = _S468;
    probe_1.edge_x_0 = outline_distance_0(_S466.crossing_2.warp_2, _S466.shown_3, _S466.run_3, !_S466.shown_3.is_warp_2, _S464);
    probe_1.edge_y_0 = outline_distance_0(_S466.crossing_2.weft_2, _S466.shown_3, _S466.run_3, _S466.shown_3.is_warp_2, _S465);
    return probe_1;
}

fn is_free_0( _S469 : u32,  _S470 : SearchQuality_0,  _S471 : vec3<f32>,  _S472 : vec3<f32>,  _S473 : bool,  _S474 : f32) -> bool
{
    var _S475 : f32 = _S472.z;
    if(_S475 <= 0.0f)
    {
        return false;
    }
    var _S476 : f32 = 1.0f / max(_S470.shadow_share_0 * steps_per_length_0(_S469, _S470, _S472), 9.99999971718068537e-10f);
    var _S477 : StepControl_0 = step_control_0(_S472.xy, _S476);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S478 : bool;
        if(count_4 < u32(1024))
        {
            _S478 = (_S471.z + _S475 * distance_2) < _S474;
        }
        else
        {
            _S478 = false;
        }
        if(_S478)
        {
        }
        else
        {
            break;
        }
        var _S479 : vec3<f32> = _S471 + _S472 * vec3<f32>(distance_2);
        var _S480 : Probe_0 = probe_0(_S469, _S479.x, _S479.y, _S473, _S477.right_0, _S477.up_0);
        var _S481 : f32 = _S479.z;
        var _S482 : f32 = _S481 - _S480.height_4;
        var _S483 : f32 = _S475 - _S480.slope_x_0 * _S472.x - _S480.slope_y_0 * _S472.y;
        var _S484 : bool;
        if(!_S480.hole_4)
        {
            _S484 = _S482 < 0.0f;
        }
        else
        {
            _S484 = false;
        }
        if(_S484)
        {
            return false;
        }
        var _S485 : f32 = way_back_to_dip_0(previous_3, _S482, _S483, last_step_0, _S480);
        if(_S485 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S485;
            distance_2 = distance_2 - _S485;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S486 : bool = _S481 > (_S480.cell_max_0);
        var _S487 : PreviousSample_0 = after_sample_0(_S482, _S483, _S480, _S486);
        var last_step_2 : f32;
        if(_S486)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S477, _S480.side_x_0, _S480.side_y_0), _S476);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S477, _S480, _S482, _S483);
        }
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = _S487;
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S488 : u32,  _S489 : SearchQuality_0,  _S490 : f32,  _S491 : f32,  _S492 : vec3<f32>,  _S493 : bool) -> bool
{
    if(!sample_at_0(_S488, _S490, _S491, _S493).shown_3.hole_3)
    {
        return false;
    }
    var _S494 : vec3<f32> = vec3<f32>(_S490, _S491, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S495 : bool;
        if(side_1 < u32(2))
        {
            _S495 = passes_0;
        }
        else
        {
            _S495 = false;
        }
        if(_S495)
        {
        }
        else
        {
            break;
        }
        var _S496 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S496 = _S492;
        }
        else
        {
            _S496 = vec3<f32>(- _S492.x, - _S492.y, _S492.z);
        }
        var _S497 : bool = is_free_0(_S488, _S489, _S494, _S496, _S493 != (side_1 == u32(1)), fabrics_0[_S488].height_high_0);
        var _S498 : u32 = side_1 + u32(1);
        passes_0 = _S497;
        side_1 = _S498;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_8 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S499 : u32,  _S500 : f32,  _S501 : f32,  _S502 : f32,  _S503 : vec3<f32>,  _S504 : bool) -> f32
{
    var _S505 : u32 = locate_0(fabrics_0[_S499].warp_0, _S500).thread_1 / u32(2);
    var _S506 : u32 = locate_0(fabrics_0[_S499].weft_0, _S501).thread_1 / u32(2);
    var _S507 : f32 = _S503.x;
    var _S508 : u32;
    if(_S507 > 0.0f)
    {
        _S508 = u32(1);
    }
    else
    {
        _S508 = u32(0);
    }
    var _S509 : f32 = _S503.y;
    var _S510 : u32;
    if(_S509 > 0.0f)
    {
        _S510 = u32(2);
    }
    else
    {
        _S510 = u32(0);
    }
    var _S511 : u32 = words_0[fabrics_0[_S499].max_heights_0 + u32(4) * (_S506 * fabrics_0[_S499].max_height_columns_0 + _S505) + (_S508 + _S510)];
    var number_1 : i32;
    if(_S504)
    {
        number_1 = i32(4);
    }
    else
    {
        number_1 = i32(0);
    }
    var _S512 : u32 = (_S511 >> (u32(number_1)));
    var _S513 : f32 = max(abs(_S507) * fabrics_0[_S499].threads_per_x_0, abs(_S509) * fabrics_0[_S499].threads_per_y_0) / _S503.z;
    var _S514 : f32 = fabrics_0[_S499].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S499].height_high_0;
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
        if(((max_height_0 - _S502) * _S513) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S512 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S514);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S515 : u32,  _S516 : f32,  _S517 : f32,  _S518 : bool,  _S519 : bool,  _S520 : bool) -> vec3<f32>
{
    var _S521 : Crossing_0 = crossing_at_0(_S515, _S516, _S517, _S518);
    var _S522 : f32 = cell_maximum_0(_S515, _S521);
    var _S523 : f32;
    if(_S519)
    {
        _S523 = _S521.warp_2.above_0;
    }
    else
    {
        _S523 = _S521.warp_2.below_0;
    }
    var _S524 : f32;
    if(_S520)
    {
        _S524 = _S521.weft_2.above_0;
    }
    else
    {
        _S524 = _S521.weft_2.below_0;
    }
    return vec3<f32>(_S522, _S523, _S524);
}

fn first_sample_height_0( _S525 : u32,  _S526 : ViewRay_0,  _S527 : StepControl_0,  _S528 : bool) -> f32
{
    var _S529 : f32 = max_height_along_0(_S525, _S526.origin_0.x, _S526.origin_0.y, 0.0f, vec3<f32>(_S526.slope_1, 1.0f), _S528);
    var count_5 : u32 = u32(0);
    var height_9 : f32 = _S529;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S530 : vec2<f32> = ViewRay_at_0(_S526, height_9);
        var _S531 : vec3<f32> = cell_bounds_0(_S525, _S530.x, _S530.y, _S528, _S527.right_0, _S527.up_0);
        var _S532 : f32 = height_9 - _S531.x;
        var _S533 : f32 = StepControl_to_cell_exit_0(_S527, _S531.y, _S531.z);
        var height_10 : f32 = height_9 - clamp(_S532, 0.0f, _S533);
        if(_S532 <= _S533)
        {
            height_9 = height_10;
            break;
        }
        count_5 = count_5 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S534 : u32,  _S535 : ViewRay_0,  _S536 : StepControl_0,  _S537 : bool) -> ViewRayEnd_0
{
    var _S538 : f32 = fabrics_0[_S534].height_low_0 - (fabrics_0[_S534].height_high_0 - fabrics_0[_S534].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S534, _S535, _S536, _S537);
    end_1.last_step_3 = _S536.epsilon_0;
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
        var _S539 : vec2<f32> = ViewRay_at_0(_S535, end_1.height_8);
        var _S540 : Probe_0 = probe_0(_S534, _S539.x, _S539.y, _S537, _S536.right_0, _S536.up_0);
        var _S541 : f32 = end_1.height_8 - _S540.height_4;
        var _S542 : f32 = ViewRay_rate_0(_S535, _S540);
        end_1.depth_1 = - _S541;
        end_1.rate_4 = _S542;
        var _S543 : bool;
        if(end_1.previous_4.known_0)
        {
            _S543 = !_S540.hole_4;
        }
        else
        {
            _S543 = false;
        }
        var _S544 : bool;
        if(_S543)
        {
            _S544 = (end_1.previous_4.yarn_0) == (_S540.yarn_1);
        }
        else
        {
            _S544 = false;
        }
        end_1.smooth_0 = _S544;
        var _S545 : bool;
        if(!_S540.hole_4)
        {
            _S545 = _S541 <= 0.0f;
        }
        else
        {
            _S545 = false;
        }
        var _S546 : bool;
        if(_S545)
        {
            _S546 = true;
        }
        else
        {
            _S546 = (end_1.height_8) <= _S538;
        }
        if(_S546)
        {
            break;
        }
        var _S547 : f32 = way_back_to_dip_0(end_1.previous_4, _S541, _S542, end_1.last_step_3, _S540);
        if(_S547 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S547;
            end_1.last_step_3 = end_1.last_step_3 - _S547;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S548 : f32 = min(StepControl_to_cell_exit_0(_S536, _S540.side_x_0, _S540.side_y_0), end_1.height_8 - _S540.cell_max_0);
        var _S549 : f32 = StepControl_to_next_sample_0(_S536, _S540, _S541, _S542);
        end_1.previous_4 = after_sample_0(_S541, _S542, _S540, _S548 > _S549);
        var _S550 : f32 = max(_S548, _S549);
        end_1.last_step_3 = _S550;
        end_1.height_8 = end_1.height_8 - _S550;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S551 : u32,  _S552 : ViewRay_0,  _S553 : StepControl_0,  _S554 : bool,  _S555 : ViewRayEnd_0,  _S556 : u32) -> f32
{
    var _S557 : f32 = fabrics_0[_S551].height_high_0 - fabrics_0[_S551].height_low_0;
    var above_2 : f32 = _S555.height_8 + _S555.last_step_3;
    var above_gap_1 : f32 = clamp(_S555.previous_4.clearance_0, 0.0f, _S557);
    var under_gap_1 : f32 = clamp(_S555.depth_1, 0.0f, _S557);
    var _S558 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S555.previous_4.rate_0 * _S555.last_step_3, _S555.rate_4 * _S555.last_step_3);
    var middle_0 : f32;
    if(_S555.smooth_0)
    {
        middle_0 = above_2 - _S558 * _S555.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S555.height_8, above_gap_1, under_gap_1);
    }
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S555.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S556)
        {
        }
        else
        {
            break;
        }
        var _S559 : vec2<f32> = ViewRay_at_0(_S552, middle_0);
        var _S560 : Probe_0 = probe_0(_S551, _S559.x, _S559.y, _S554, _S553.right_0, _S553.up_0);
        var _S561 : f32;
        if(_S560.hole_4)
        {
            _S561 = -1.0e+09f;
        }
        else
        {
            _S561 = _S560.height_4;
        }
        var _S562 : f32 = clamp(middle_0 - _S561, - _S557, _S557);
        var _S563 : f32;
        if(_S562 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S563 = 0.5f * above_gap_2;
            }
            else
            {
                _S563 = above_gap_2;
            }
            var _S564 : f32 = - _S562;
            under_1 = middle_0;
            above_gap_2 = _S563;
            under_gap_2 = _S564;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S563 = 0.5f * under_gap_2;
            }
            else
            {
                _S563 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S562;
            under_gap_2 = _S563;
            side_2 = -1.0f;
        }
        if(_S555.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S562 / min(ViewRay_rate_0(_S552, _S560), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S555.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S565 : u32,  _S566 : SearchQuality_0,  _S567 : f32,  _S568 : f32,  _S569 : vec3<f32>,  _S570 : bool) -> Hit_0
{
    var _S571 : f32 = max(_S569.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S567, _S568);
    var _S572 : vec2<f32> = _S569.xy / vec2<f32>(_S571);
    ray_0.slope_1 = _S572;
    var _S573 : StepControl_0 = step_control_0((vec2<f32>(0) - _S572), 1.0f / max(steps_per_length_0(_S565, _S566, _S569) / _S571, 9.99999971718068537e-10f));
    var _S574 : ViewRayEnd_0 = search_down_0(_S565, ray_0, _S573, _S570);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S575 : f32 = refined_height_0(_S565, ray_0, _S573, _S570, _S574, _S566.refinements_0);
    hit_0.height_6 = _S575;
    var _S576 : vec2<f32> = ViewRay_at_0(ray_0, _S575);
    hit_0.x_14 = _S576.x;
    hit_0.y_7 = _S576.y;
    return hit_0;
}

fn first_hit_0( _S577 : u32,  _S578 : SearchQuality_0,  _S579 : f32,  _S580 : f32,  _S581 : vec3<f32>,  _S582 : bool) -> Hit_0
{
    if(!passes_through_0(_S577, _S578, _S579, _S580, _S581, _S582))
    {
        return first_hit_of_yarn_0(_S577, _S578, _S579, _S580, _S581, _S582);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S579;
    hit_1.y_7 = _S580;
    hit_1.height_6 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S583 : u32,  _S584 : f32,  _S585 : f32,  _S586 : bool) -> SurfacePoint_0
{
    var _S587 : Sample_0 = sample_at_0(_S583, _S584, _S585, _S586);
    var _S588 : f32;
    if(_S587.shown_3.is_warp_2)
    {
        _S588 = _S587.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S588 = _S587.crossing_2.weft_2.half_width_1;
    }
    var _S589 : u32;
    if(_S587.shown_3.is_warp_2)
    {
        _S589 = fabrics_0[_S583].warp_0;
    }
    else
    {
        _S589 = fabrics_0[_S583].weft_0;
    }
    var _S590 : Family_std430_0 = families_0[_S589];
    var _S591 : f32;
    if(_S586)
    {
        _S591 = -1.0f;
    }
    else
    {
        _S591 = 1.0f;
    }
    var _S592 : f32 = _S590.twist_sine_0 * _S591;
    var _S593 : Family_std430_0 = families_0[_S589];
    if(_S587.shown_3.is_warp_2)
    {
        _S591 = 1.0f;
    }
    else
    {
        _S591 = -1.0f;
    }
    var _S594 : vec2<f32> = fibre_direction_0(_S587.slope_across_0, _S591 * _S587.slope_along_0, _S592, _S593.twist_cosine_0);
    var _S595 : f32;
    if(_S587.shown_3.is_warp_2)
    {
        _S595 = _S587.slope_x_1;
    }
    else
    {
        _S595 = _S587.slope_y_1;
    }
    var _S596 : f32;
    if(_S587.shown_3.is_warp_2)
    {
        _S596 = _S587.slope_y_1;
    }
    else
    {
        _S596 = _S587.slope_x_1;
    }
    var _S597 : f32 = _S594.x;
    var _S598 : f32 = _S594.y;
    var _S599 : f32 = _S595 * _S597 + _S591 * _S596 * _S598;
    var _S600 : f32 = _S588 * 1.0154266357421875f;
    var _S601 : f32 = _S600 * arc_sine_0(clamp(_S587.section_1.across_3 / _S600, -1.0f, 1.0f));
    if(_S587.shown_3.is_warp_2)
    {
        _S588 = _S585;
    }
    else
    {
        _S588 = - _S584;
    }
    var point_3 : SurfacePoint_0;
    point_3.hole_0 = _S587.shown_3.hole_3;
    point_3.is_warp_0 = _S587.shown_3.is_warp_2;
    point_3.warp_thread_0 = _S587.crossing_2.warp_2.thread_1;
    point_3.weft_thread_0 = _S587.crossing_2.weft_2.thread_1;
    point_3.height_2 = _S587.height_7;
    point_3.normal_1 = normalize(vec3<f32>(- _S587.slope_x_1, - _S587.slope_y_1, 1.0f));
    var _S602 : vec3<f32>;
    if(_S587.shown_3.is_warp_2)
    {
        _S602 = vec3<f32>(_S597, _S598, _S599);
    }
    else
    {
        _S602 = vec3<f32>(- _S598, _S597, _S599);
    }
    point_3.tangent_0 = normalize(_S602);
    point_3.across_0 = _S587.section_1.across_3;
    point_3.fibre_across_0 = _S601 * _S593.twist_cosine_0 + _S588 * _S592;
    point_3.fibre_along_0 = _S588 * _S593.twist_cosine_0 - _S601 * _S592;
    return point_3;
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_15 : f32,
     y_8 : f32,
     height_11 : f32,
     normal_7 : vec3<f32>,
     tangent_7 : vec3<f32>,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
};

fn vary_albedos_0( _S603 : u32,  _S604 : Albedos_0,  _S605 : u32,  _S606 : u32) -> Albedos_0
{
    var _S607 : vec3<f32> = max(_S604.specular_reflect_0, _S604.specular_transmit_0);
    var _S608 : vec3<f32> = _S604.diffuse_reflect_0 + _S604.diffuse_transmit_0;
    var _S609 : vec3<f32> = vec3<f32>(fabrics_0[_S603].layer_bound_0);
    var _S610 : vec3<f32> = vec3<f32>(1.0f);
    var _S611 : vec3<f32> = vec3<f32>(bounded_gain_0(thread_gain_0(_S605, fabrics_0[_S603].colour_noise_0, fabrics_0[_S603].seed_0), _S608, _S610 - _S609 * _S607));
    var _S612 : f32 = bounded_gain_0(fibre_gain_0(_S605, _S606, fabrics_0[_S603].fibre_noise_0, fabrics_0[_S603].seed_0), _S607, min((_S610 - _S611 * _S608) / _S609, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S611 * _S604.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S611 * _S604.diffuse_transmit_0;
    var _S613 : vec3<f32> = vec3<f32>(_S612);
    varied_0.specular_reflect_0 = _S613 * _S604.specular_reflect_0;
    varied_0.specular_transmit_0 = _S613 * _S604.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S614 : u32,  _S615 : SurfacePoint_0,  _S616 : Albedos_0,  _S617 : f32,  _S618 : f32) -> Albedos_0
{
    var _S619 : f32;
    if(_S615.is_warp_0)
    {
        _S619 = _S617;
    }
    else
    {
        _S619 = _S618;
    }
    var _S620 : f32 = _S619 - _S615.across_0;
    var _S621 : u32;
    if(_S615.is_warp_0)
    {
        _S621 = fabrics_0[_S614].warp_0;
    }
    else
    {
        _S621 = fabrics_0[_S614].weft_0;
    }
    var _S622 : Family_std430_0 = families_0[_S621];
    var _S623 : i32 = i32(families_0[_S621].count_0);
    if(_S615.is_warp_0)
    {
        _S621 = _S615.warp_thread_0;
    }
    else
    {
        _S621 = _S615.weft_thread_0;
    }
    var _S624 : u32 = u32(i32(floor(_S620 / _S622.period_0)) * _S623 + i32(_S621)) * u32(2);
    if(_S615.is_warp_0)
    {
        _S621 = u32(1);
    }
    else
    {
        _S621 = u32(0);
    }
    var _S625 : f32 = floor(_S615.fibre_across_0 / fabrics_0[_S614].fibre_size_0);
    return vary_albedos_0(_S614, _S616, _S624 + _S621, u32(i32(_S625)) * u32(65536) + u32(i32(floor(_S615.fibre_along_0 / (fabrics_0[_S614].fibre_size_0 * 40.0f) + 0.61799997091293335f * _S625))));
}

fn yarn_point_of_0( _S626 : u32,  _S627 : SurfacePoint_0,  _S628 : f32,  _S629 : f32,  _S630 : bool,  _S631 : bool) -> YarnPoint_0
{
    var _S632 : u32;
    if(_S627.is_warp_0)
    {
        _S632 = fabrics_0[_S626].warp_0;
    }
    else
    {
        _S632 = fabrics_0[_S626].weft_0;
    }
    var _S633 : u32;
    if(_S627.is_warp_0)
    {
        _S633 = _S627.warp_thread_0;
    }
    else
    {
        _S633 = _S627.weft_thread_0;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S632, _S633);
    var _S634 : bool;
    if((fabrics_0[_S626].fibre_noise_0) > 0.0f)
    {
        _S634 = true;
    }
    else
    {
        _S634 = (fabrics_0[_S626].colour_noise_0) > 0.0f;
    }
    var albedos_8 : Albedos_0;
    if(_S634)
    {
        albedos_8 = varied_at_0(_S626, _S627, albedos_7, _S628, _S629);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_4 : YarnPoint_0;
    point_4.back_6 = _S630;
    point_4.hole_6 = _S631;
    point_4.is_warp_3 = _S627.is_warp_0;
    point_4.x_15 = _S628;
    point_4.y_8 = _S629;
    point_4.height_11 = _S627.height_2;
    point_4.normal_7 = _S627.normal_1;
    point_4.tangent_7 = _S627.tangent_0;
    point_4.roughness_10 = families_0[_S632].roughness_0;
    point_4.albedos_6 = albedos_8;
    return point_4;
}

fn unoccluded_0( _S635 : u32,  _S636 : SearchQuality_0,  _S637 : f32,  _S638 : f32,  _S639 : f32,  _S640 : vec3<f32>,  _S641 : bool) -> bool
{
    if((_S640.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S635, _S636, vec3<f32>(_S637, _S638, _S639 + fabrics_0[_S635].lift_0), _S640, _S641, max_height_along_0(_S635, _S637, _S638, _S639, _S640, _S641));
}

fn is_lit_0( _S642 : u32,  _S643 : SearchQuality_0,  _S644 : YarnPoint_0,  _S645 : vec3<f32>) -> bool
{
    if(_S644.hole_6)
    {
        return true;
    }
    var _S646 : vec3<f32> = to_face_frame_0(_S645, _S644.back_6);
    var _S647 : f32 = _S646.z;
    var _S648 : bool = _S647 < 0.0f;
    var normal_8 : vec3<f32>;
    var height_12 : f32;
    if(_S648)
    {
        var _S649 : SurfacePoint_0 = surface_at_0(_S642, _S644.x_15, _S644.y_8, !_S644.back_6);
        normal_8 = _S649.normal_1;
        height_12 = _S649.height_2;
    }
    else
    {
        normal_8 = _S644.normal_7;
        height_12 = _S644.height_11;
    }
    var _S650 : vec3<f32> = vec3<f32>(_S646.xy, abs(_S647));
    if((dot(normal_8, _S650)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S642, _S643, _S644.x_15, _S644.y_8, height_12, _S650, (_S644.back_6) != _S648);
}

fn components_of_point_0( _S651 : u32,  _S652 : SearchQuality_0,  _S653 : YarnPoint_0,  _S654 : vec3<f32>,  _S655 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    var _S656 : f32;
    if(_S653.hole_6)
    {
        _S656 = 1.0f;
    }
    else
    {
        _S656 = 0.0f;
    }
    result_3.hole_2 = _S656;
    var _S657 : bool;
    if(_S653.hole_6)
    {
        _S657 = true;
    }
    else
    {
        _S657 = !is_lit_0(_S651, _S652, _S653, _S654);
    }
    if(_S657)
    {
        return result_3;
    }
    var _S658 : vec3<f32> = to_face_frame_0(_S654, _S653.back_6);
    var _S659 : vec3<f32> = to_face_frame_0(_S655, _S653.back_6);
    var _S660 : bool = (_S658.z) < 0.0f;
    var _S661 : vec3<f32>;
    if(_S660)
    {
        _S661 = (vec3<f32>(0) - _S658);
    }
    else
    {
        _S661 = _S658;
    }
    var _S662 : f32 = diffuse_reflection_0(_S661, _S653.normal_7, fabrics_0[_S651].diffuse_blend_0);
    if(_S660)
    {
        _S656 = transmission_1(_S658, _S659, _S653.normal_7, _S653.tangent_7, _S653.roughness_10, fabrics_0[_S651].optical_depth_0);
    }
    else
    {
        _S656 = reflection_0(_S658, _S659, _S653.normal_7, _S653.tangent_7, _S653.roughness_10, fabrics_0[_S651].optical_depth_0);
    }
    var _S663 : f32;
    if(_S653.is_warp_3)
    {
        _S663 = _S662;
    }
    else
    {
        _S663 = 0.0f;
    }
    result_3.diffuse_warp_0 = _S663;
    if(_S653.is_warp_3)
    {
        _S663 = 0.0f;
    }
    else
    {
        _S663 = _S662;
    }
    result_3.diffuse_weft_0 = _S663;
    if(_S653.is_warp_3)
    {
        _S663 = _S656;
    }
    else
    {
        _S663 = 0.0f;
    }
    result_3.specular_warp_0 = _S663;
    if(_S653.is_warp_3)
    {
        _S656 = 0.0f;
    }
    result_3.specular_weft_0 = _S656;
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S664 : u32,  _S665 : u32) -> f32
{
    return table_number_0(fabrics_0[_S664].openness_0 + _S665);
}

fn blocked_of_terms_0( _S666 : u32,  _S667 : u32,  _S668 : array<f32, i32(6)>,  _S669 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_3 : u32 = u32(0);
    for(;;)
    {
        if(share_3 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_3] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S669)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S666, _S667 + share_3 * _S669 + term_0) * _S668[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_3] = saturate(shares_0[share_3]);
        share_3 = share_3 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_at_0( _S670 : u32,  _S671 : bool,  _S672 : bool,  _S673 : f32,  _S674 : f32) -> Blocked_0
{
    var _S675 : f32 = _S674 * openness_number_0(_S670, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S673, _S675, _S673 * _S673, _S673 * _S675, _S675 * _S675 );
    var _S676 : u32;
    if(_S672)
    {
        _S676 = u32(2);
    }
    else
    {
        _S676 = u32(0);
    }
    var _S677 : u32;
    if(_S671)
    {
        _S677 = u32(0);
    }
    else
    {
        _S677 = u32(1);
    }
    return blocked_of_terms_0(_S670, u32(60) + (_S676 + _S677) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S678 : u32,  _S679 : Blocked_0,  _S680 : YarnPoint_0,  _S681 : bool,  _S682 : f32) -> Blocked_0
{
    var _S683 : bool;
    if(_S680.hole_6)
    {
        _S683 = true;
    }
    else
    {
        _S683 = (_S680.is_warp_3) != _S681;
    }
    if(_S683)
    {
        return _S679;
    }
    var _S684 : Blocked_0 = blocked_at_0(_S678, _S681, _S680.back_6, _S680.normal_7.z, _S680.height_11);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S679.by_warp_0 + _S682 * _S684.by_warp_0;
    result_4.by_weft_0 = _S679.by_weft_0 + _S682 * _S684.by_weft_0;
    result_4.far_0 = _S679.far_0 + _S682 * _S684.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S685 : u32,  _S686 : f32) -> vec3<f32>
{
    var _S687 : u32 = fabrics_0[_S685].lobes_0.levels_0 + u32(4) * u32(min(_S686, fabrics_0[_S685].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S687), table_number_0(_S687 + u32(1)), table_number_0(_S687 + u32(2)));
}

fn coverage_taps_0( _S688 : u32,  _S689 : Footprint_0,  _S690 : bool) -> CoverageTaps_0
{
    var _S691 : Lobes_std430_0 = fabrics_0[_S688].lobes_0;
    var _S692 : f32 = Footprint_spread_side_0(_S689) * fabrics_0[_S688].lobes_0.inverse_base_size_0;
    var _S693 : vec3<f32> = pyramid_level_0(_S688, floor(binary_logarithm_0(max(0.68000000715255737f * _S692, 1.0f))));
    var _S694 : f32 = 1.0f / max(_S692, 9.99999997475242708e-07f);
    var _S695 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S688].warp_0].inverse_period_0, families_0[fabrics_0[_S688].weft_0].inverse_period_0);
    var _S696 : vec2<f32> = _S689.centre_0 * _S695;
    var _S697 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S694 * _S694), 0.0f, 1.0f)), 0.3333333432674408f * _S694), 1.0f));
    var _S698 : vec2<f32> = _S689.dx_0 * _S695 * _S697;
    var _S699 : vec2<f32> = _S689.dy_0 * _S695 * _S697;
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
        var _S700 : vec2<f32> = _S696 + vec2<f32>(TAP_OFFSETS_0[number_2].x) * _S698 + vec2<f32>(TAP_OFFSETS_0[number_2].y) * _S699;
        var _S701 : f32 = _S693.y;
        var _S702 : f32 = wrapped_cell_0(_S700.x, _S701);
        var _S703 : f32 = wrapped_cell_0(_S700.y, _S693.z);
        var _S704 : u32;
        if(_S690)
        {
            _S704 = _S691.face_nodes_0;
        }
        else
        {
            _S704 = u32(0);
        }
        taps_3.nodes_1[number_2] = _S704 + u32(_S703 * _S701 + _S702 + _S693.x);
        number_2 = number_2 + u32(1);
    }
    return taps_3;
}

fn coverage_of_pack_0( _S705 : u32,  _S706 : CoverageTaps_0,  _S707 : u32) -> vec4<f32>
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
        var _S708 : u32 = words_0[fabrics_0[_S705].lobes_0.coverage_0 + _S706.nodes_1[number_3] * fabrics_0[_S705].lobes_0.packs_0 + _S707];
        var even_2 : u32 = even_1 + ((_S708 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S708 >> (u32(8)))) & (u32(16711935))));
        number_3 = number_3 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S709 : u32,  _S710 : CoverageTaps_0) -> f32
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
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S709].lobes_0.coverage_holes_0 + _S710.nodes_1[number_4] / u32(4)] >> ((u32(8) * (_S710.nodes_1[number_4] % u32(4)))))) & (u32(255))));
        number_4 = number_4 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S711 : u32,  _S712 : CoverageTaps_0,  _S713 : NodeTaps_0,  _S714 : bool) -> f32
{
    var _S715 : Lobes_std430_0 = fabrics_0[_S711].lobes_0;
    var _S716 : f32 = interpolate_table_0(_S713, fabrics_0[_S711].lobes_0.projected_area_0 + fabrics_0[_S711].lobes_0.packs_0, fabrics_0[_S711].lobes_0.packs_0 + u32(1)).x;
    var _S717 : f32;
    if(_S714)
    {
        _S717 = _S715.back_hole_weight_0;
    }
    else
    {
        _S717 = _S715.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S711, _S712) * _S716 * _S716 * _S717, 1.0f);
}

fn prefiltered_components_0( _S718 : u32,  _S719 : Footprint_0,  _S720 : vec3<f32>,  _S721 : vec3<f32>,  _S722 : bool) -> Components_0
{
    var _S723 : CoverageTaps_0 = coverage_taps_0(_S718, _S719, _S722);
    var _S724 : NodeTaps_0 = node_taps_0(_S721);
    var view_nodes_0 : NodeTaps_0 = _S724;
    var light_nodes_0 : NodeTaps_0 = node_taps_0(_S720);
    var seen_nodes_0 : NodeTaps_0 = _S724;
    var _S725 : u32;
    if(_S722)
    {
        _S725 = u32(1);
    }
    else
    {
        _S725 = u32(0);
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S725 * u32(256)));
    var _S726 : u32 = u32(2) * _S725;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + vec4<u32>((_S726 * u32(256)));
    var _S727 : u32;
    if((_S720.z) < 0.0f)
    {
        _S727 = u32(1);
    }
    else
    {
        _S727 = u32(0);
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((_S726 + _S727) * u32(256)));
    var _S728 : vec3<f32> = half_vector_0(_S720, _S721);
    var _S729 : vec3<f32> = shadow_correlation_0(_S720, _S721);
    if(_S722)
    {
        _S727 = fabrics_0[_S718].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S727 = fabrics_0[_S718].lobes_0.front_warp_packs_0;
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
        var _S730 : Lobes_std430_0 = fabrics_0[_S718].lobes_0;
        if(pack_0 < (fabrics_0[_S718].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S731 : vec4<f32> = coverage_of_pack_0(_S718, _S723, pack_0);
        var _S732 : vec4<f32> = interpolate_table_0(view_nodes_0, _S730.projected_area_0 + pack_0, _S730.packs_0 + u32(1));
        var _S733 : u32 = _S730.light_visibility_0 + pack_0;
        var _S734 : vec4<f32> = vec4<f32>(255.0f);
        var _S735 : vec4<f32> = interpolate_table_0(seen_nodes_0, _S733, _S730.packs_0) / _S734;
        var _S736 : vec4<f32> = interpolate_table_0(light_nodes_0, _S733, _S730.packs_0) / _S734;
        var _S737 : vec4<f32> = interpolate_table_0(light_nodes_0, _S730.irradiance_0 + pack_0, _S730.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S738 : bool = pack_0 < _S727;
        var _S739 : u32;
        if(_S738)
        {
            _S739 = fabrics_0[_S718].warp_0;
        }
        else
        {
            _S739 = fabrics_0[_S718].weft_0;
        }
        var _S740 : Family_std430_0 = families_0[_S739];
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
            var _S741 : Group_0 = group_at_0(_S730.moments_0 + u32(12) * (u32(4) * (_S725 * _S730.packs_0 + pack_0) + number_5), _S740.roughness_0);
            var _S742 : f32 = _S731[number_5] * _S732[number_5] * _S732[number_5] * _S741.weight_2;
            var _S743 : vec2<f32> = visibility_gain_0(_S729, _S736[number_5], _S735[number_5]);
            var _S744 : f32 = _S743.x;
            var diffuse_1 : f32 = diffuse_0 + _S742 * _S737[number_5] * _S744;
            var specular_1 : f32 = specular_0 + _S742 * layer_value_0(_S741, _S728, _S720, _S721, fabrics_0[_S718].optical_depth_0) * _S736[number_5] * _S743.y;
            sums_1.light_visibility_1 = sums_1.light_visibility_1 + _S742 * _S736[number_5] * _S744;
            var total_3 : f32 = total_2 + _S742;
            number_5 = number_5 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        var _S745 : f32;
        if(_S738)
        {
            _S745 = diffuse_0;
        }
        else
        {
            _S745 = 0.0f;
        }
        sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 + _S745;
        var _S746 : f32;
        if(_S738)
        {
            _S746 = 0.0f;
        }
        else
        {
            _S746 = diffuse_0;
        }
        sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 + _S746;
        var _S747 : f32;
        if(_S738)
        {
            _S747 = specular_0;
        }
        else
        {
            _S747 = 0.0f;
        }
        sums_1.specular_warp_0 = sums_1.specular_warp_0 + _S747;
        var _S748 : f32;
        if(_S738)
        {
            _S748 = 0.0f;
        }
        else
        {
            _S748 = specular_0;
        }
        sums_1.specular_weft_0 = sums_1.specular_weft_0 + _S748;
        pack_0 = pack_0 + u32(1);
    }
    var _S749 : f32 = prefiltered_hole_0(_S718, _S723, view_nodes_0, _S722);
    sums_1.hole_2 = _S749;
    var _S750 : f32 = (1.0f - _S749) / max(total_2, 9.999999960041972e-13f);
    sums_1.diffuse_warp_0 = sums_1.diffuse_warp_0 * _S750;
    sums_1.diffuse_weft_0 = sums_1.diffuse_weft_0 * _S750;
    sums_1.specular_warp_0 = sums_1.specular_warp_0 * _S750;
    sums_1.specular_weft_0 = sums_1.specular_weft_0 * _S750;
    sums_1.light_visibility_1 = sums_1.light_visibility_1 * _S750;
    return sums_1;
}

fn albedos_over_0( _S751 : u32,  _S752 : Footprint_0,  _S753 : bool) -> FamilyAlbedos_0
{
    var _S754 : vec2<f32> = _S752.dx_0;
    var _S755 : vec2<f32> = _S752.dy_0;
    var _S756 : vec2<f32> = sqrt(_S754 * _S754 + _S755 * _S755);
    var _S757 : Stretch_0 = stretch_of_0(fabrics_0[_S751].warp_0, _S752.centre_0.x, _S756.x);
    var _S758 : Stretch_0 = stretch_of_0(fabrics_0[_S751].weft_0, _S752.centre_0.y, _S756.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S751].warp_0, fabrics_0[_S751].weft_0, _S757, _S758, _S753);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S751].weft_0, fabrics_0[_S751].warp_0, _S758, _S757, _S753);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S759 : u32,  _S760 : Footprint_0,  _S761 : f32,  _S762 : vec2<f32>,  _S763 : vec3<f32>,  _S764 : vec3<f32>) -> Estimate_0
{
    var _S765 : f32;
    var _S766 : Regime_0 = regime_of_0(_S759, _S760, _S761);
    var _S767 : bool = (_S764.z) < 0.0f;
    var _S768 : vec3<f32> = to_face_frame_0(_S764, _S767);
    var _S769 : bool;
    if((fabrics_0[_S759].fibre_noise_0) > 0.0f)
    {
        _S769 = true;
    }
    else
    {
        _S769 = (fabrics_0[_S759].colour_noise_0) > 0.0f;
    }
    var _S770 : bool;
    if((families_0[fabrics_0[_S759].warp_0].quantities_0) > u32(1))
    {
        _S770 = true;
    }
    else
    {
        _S770 = (families_0[fabrics_0[_S759].weft_0].quantities_0) > u32(1);
    }
    var _S771 : f32 = 1.0f - _S766.prefiltered_0;
    if(_S771 > 0.0f)
    {
        if(_S769)
        {
            _S770 = true;
        }
    }
    else
    {
        _S770 = false;
    }
    var box_0 : Footprint_0 = _S760;
    var _S772 : vec3<f32> = vec3<f32>(0.0f);
    var _S773 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S772, _S772, 0.0f, 0.0f, 0.0f);
    var _S774 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S775 : i32;
    if(_S770)
    {
        _S775 = i32(0);
    }
    else
    {
        _S775 = i32(1);
    }
    var _S776 : u32 = u32(_S775);
    var points_1 : Components_0 = _S774;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S773;
    var central_place_0 : vec2<f32> = _S760.centre_0;
    var number_6 : u32 = _S776;
    for(;;)
    {
        var _S777 : f32 = f32(number_6);
        _S765 = _S766.points_0;
        if(_S777 < (_S766.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S778 : bool = number_6 == u32(0);
        var _S779 : u32;
        if(_S778)
        {
            _S779 = u32(0);
        }
        else
        {
            _S779 = number_6 - u32(1);
        }
        var _S780 : vec2<f32> = POINT_OFFSETS_0[_S779] + _S762;
        var _S781 : vec2<f32>;
        if(_S778)
        {
            _S781 = vec2<f32>(0.0f);
        }
        else
        {
            _S781 = _S780 - round(_S780);
        }
        var _S782 : vec2<f32> = _S760.centre_0 + vec2<f32>(_S781.x) * _S760.dx_0 + vec2<f32>(_S781.y) * _S760.dy_0;
        var _S783 : f32;
        if(_S778)
        {
            _S783 = 0.0f;
        }
        else
        {
            _S783 = _S766.threads_1;
        }
        var _S784 : SearchQuality_0 = quality_of_0(_S783);
        var _S785 : Hit_0 = first_hit_0(_S759, _S784, _S782.x, _S782.y, _S768, _S767);
        var _S786 : SurfacePoint_0 = surface_at_0(_S759, _S785.x_14, _S785.y_7, _S767);
        if(_S778)
        {
            var central_weight_1 : f32;
            if(_S785.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S771;
            }
            var central_place_1 : vec2<f32> = vec2<f32>(_S785.x_14, _S785.y_7);
            box_0.centre_0 = mix(_S760.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S786;
            central_place_0 = central_place_1;
            number_6 = number_6 + u32(1);
            continue;
        }
        var _S787 : YarnPoint_0 = yarn_point_of_0(_S759, _S786, _S785.x_14, _S785.y_7, _S767, _S785.hole_5);
        var _S788 : f32 = min(_S766.points_0 - f32(number_6 - u32(1)), 1.0f);
        var _S789 : Components_0 = with_added_0(points_1, components_of_point_0(_S759, _S784, _S787, _S763, _S764), _S788);
        if((fabrics_0[_S759].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S759, close_1.warp_1, _S787, true, _S788);
            close_1.weft_1 = with_blocked_0(_S759, close_1.weft_1, _S787, false, _S788);
        }
        points_1 = _S789;
        number_6 = number_6 + u32(1);
    }
    close_1.weight_0 = _S771;
    var _S790 : f32 = max(_S765, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S790);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S790);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S774, points_1, _S771 / _S790);
    if((_S766.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S759, _S760, to_face_frame_0(_S763, _S767), _S768, _S767), _S766.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S759, box_0, _S767);
    if(_S769)
    {
        _S769 = central_weight_0 > 0.0f;
    }
    else
    {
        _S769 = false;
    }
    if(_S769)
    {
        var _S791 : SurfacePoint_0 = central_0;
        var _S792 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S792 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S792 = estimate_0.albedos_5.weft_5;
        }
        var _S793 : Albedos_0 = lerp_albedos_0(_S792, varied_at_0(_S759, central_0, _S792, central_place_0.x, central_place_0.y), central_weight_0);
        if(_S791.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S793;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S793;
        }
    }
    return estimate_0;
}

fn scattered_by_0( _S794 : u32,  _S795 : Albedos_0,  _S796 : u32,  _S797 : vec3<f32>) -> Scattered_0
{
    var _S798 : u32 = u32(159) + u32(2) * _S796;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S797 * _S795.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S794, _S798)) * _S795.specular_reflect_0;
    yarn_3.through_0 = _S797 * _S795.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S794, _S798 + u32(1))) * _S795.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S799 : u32,  _S800 : u32,  _S801 : vec3<f32>,  _S802 : vec3<f32>,  _S803 : vec3<f32>,  _S804 : vec3<f32>,  _S805 : ptr<function, vec3<f32>>,  _S806 : ptr<function, vec3<f32>>)
{
    var _S807 : u32 = u32(146) + u32(4) * _S800;
    var _S808 : f32 = openness_number_0(_S799, _S807 + u32(1));
    var _S809 : f32 = openness_number_0(_S799, _S807 + u32(2));
    var _S810 : vec3<f32> = vec3<f32>(1.0f);
    var _S811 : vec3<f32> = _S810 - _S803 * vec3<f32>(openness_number_0(_S799, _S807));
    var _S812 : vec3<f32> = _S810 - _S804 * vec3<f32>(openness_number_0(_S799, _S807 + u32(3)));
    var _S813 : vec3<f32> = _S810 / (_S811 * _S812 - _S803 * _S804 * vec3<f32>((_S808 * _S809)));
    (*_S805) = (_S801 * _S812 + _S803 * vec3<f32>(_S808) * _S802) * _S813;
    (*_S806) = (_S802 * _S811 + _S804 * vec3<f32>(_S809) * _S801) * _S813;
    return;
}

fn face_sends_0( _S814 : u32,  _S815 : u32,  _S816 : Scattered_0,  _S817 : Scattered_0) -> FaceSends_0
{
    var _S818 : u32 = u32(2) * _S815;
    var _S819 : u32 = u32(142) + _S818;
    var _S820 : f32 = openness_number_0(_S814, _S819);
    var _S821 : f32 = openness_number_0(_S814, _S819 + u32(1));
    var _S822 : vec3<f32> = vec3<f32>((1.0f - _S820)) * _S816.back_5;
    var _S823 : vec3<f32> = vec3<f32>((1.0f - _S821)) * _S817.back_5;
    var sends_1 : FaceSends_0;
    var _S824 : u32 = u32(154) + _S818;
    var _S825 : f32 = openness_number_0(_S814, _S824);
    sends_1.blocks_warp_0 = _S825;
    var _S826 : f32 = openness_number_0(_S814, _S824 + u32(1));
    sends_1.blocks_weft_0 = _S826;
    sends_1.open_0 = _S825 * _S820 + _S826 * _S821;
    var _S827 : vec3<f32> = vec3<f32>(_S820) * _S816.back_5;
    var _S828 : vec3<f32> = vec3<f32>(_S821) * _S817.back_5;
    var _S829 : vec3<f32> = sends_1.sky_warp_0;
    var _S830 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S814, _S815, _S827, _S828, _S822, _S823, &(_S829), &(_S830));
    sends_1.sky_warp_0 = _S829;
    sends_1.sky_weft_0 = _S830;
    var _S831 : vec3<f32> = sends_1.crossing_warp_0;
    var _S832 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S814, _S815, _S816.through_0, _S817.through_0, _S822, _S823, &(_S831), &(_S832));
    sends_1.crossing_warp_0 = _S831;
    sends_1.crossing_weft_0 = _S832;
    return sends_1;
}

fn interior_of_0( _S833 : u32,  _S834 : vec3<f32>,  _S835 : bool) -> Interior_0
{
    var _S836 : Scattered_0 = scattered_by_0(_S833, table_albedos_0(families_0[fabrics_0[_S833].warp_0].colour_mean_0), u32(0), _S834);
    var _S837 : Scattered_0 = scattered_by_0(_S833, table_albedos_0(families_0[fabrics_0[_S833].weft_0].colour_mean_0), u32(1), _S834);
    var _S838 : u32;
    if(_S835)
    {
        _S838 = u32(1);
    }
    else
    {
        _S838 = u32(0);
    }
    var _S839 : FaceSends_0 = face_sends_0(_S833, _S838, _S836, _S837);
    if(_S835)
    {
        _S838 = u32(0);
    }
    else
    {
        _S838 = u32(1);
    }
    var _S840 : FaceSends_0 = face_sends_0(_S833, _S838, _S836, _S837);
    var _S841 : vec3<f32> = vec3<f32>(_S839.blocks_warp_0);
    var _S842 : vec3<f32> = vec3<f32>(_S839.blocks_weft_0);
    var _S843 : vec3<f32> = _S841 * _S839.crossing_warp_0 + _S842 * _S839.crossing_weft_0;
    var _S844 : vec3<f32> = vec3<f32>(_S840.blocks_warp_0);
    var _S845 : vec3<f32> = vec3<f32>(_S840.blocks_weft_0);
    var _S846 : vec3<f32> = _S844 * _S840.crossing_warp_0 + _S845 * _S840.crossing_weft_0;
    var _S847 : f32 = 1.0f - _S839.open_0;
    var _S848 : f32 = 1.0f - _S840.open_0;
    var _S849 : vec3<f32> = vec3<f32>(1.0f);
    var _S850 : vec3<f32> = _S849 / (_S849 - _S843 * _S846 * vec3<f32>((_S847 * _S848)));
    var _S851 : vec3<f32> = _S846 * (vec3<f32>(_S839.open_0) + vec3<f32>(_S847) * (_S841 * _S839.sky_warp_0 + _S842 * _S839.sky_weft_0)) * _S850;
    var _S852 : vec3<f32> = _S843 * (vec3<f32>(_S840.open_0) + vec3<f32>(_S848) * (_S844 * _S840.sky_warp_0 + _S845 * _S840.sky_weft_0)) * _S850;
    var _S853 : FaceRadiance_0 = face_radiance_0(_S839, _S840.open_0, _S851, _S852);
    var _S854 : FaceRadiance_0 = face_radiance_0(_S840, _S839.open_0, _S852, _S851);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S853.warp_3;
    interior_1.weft_4 = _S853.weft_3;
    interior_1.leaked_1 = _S853.leaked_0;
    interior_1.far_1 = _S854.mean_1;
    interior_1.far_leaked_0 = _S854.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S855 : u32,  _S856 : vec3<f32>,  _S857 : bool,  _S858 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S856, &(terms_3));
    var _S859 : u32;
    if(_S858)
    {
        _S859 = u32(2);
    }
    else
    {
        _S859 = u32(0);
    }
    var _S860 : u32;
    if(_S857)
    {
        _S860 = u32(0);
    }
    else
    {
        _S860 = u32(1);
    }
    return blocked_of_terms_0(_S855, (_S859 + _S860) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S861 : u32,  _S862 : vec3<f32>,  _S863 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S862, &(terms_4));
    var term_1 : u32 = u32(0);
    var share_4 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var _S864 : u32;
        if(_S863)
        {
            _S864 = u32(5);
        }
        else
        {
            _S864 = u32(0);
        }
        var share_5 : f32 = share_4 + openness_number_0(_S861, u32(132) + _S864 + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_4 = share_5;
    }
    return saturate(share_4);
}

fn bounced_of_families_0( _S865 : u32,  _S866 : FamilyAlbedos_0,  _S867 : vec3<f32>,  _S868 : Interior_0,  _S869 : Blocked_0,  _S870 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S869, scattered_by_0(_S865, _S866.warp_5, u32(0), _S867), _S868), bounced_by_0(_S870, scattered_by_0(_S865, _S866.weft_5, u32(1), _S867), _S868));
}

fn bounced_far_0( _S871 : u32,  _S872 : FamilyAlbedos_0,  _S873 : vec3<f32>,  _S874 : Interior_0,  _S875 : vec3<f32>,  _S876 : bool,  _S877 : f32,  _S878 : f32,  _S879 : f32) -> Bounced_0
{
    var _S880 : Blocked_0 = blocked_from_0(_S871, _S875, true, _S876);
    var _S881 : Blocked_0 = blocked_from_0(_S871, _S875, false, _S876);
    var _S882 : f32 = _S877 / max(1.0f - _S880.by_warp_0 - _S880.by_weft_0, 0.10000000149011612f);
    var _S883 : f32 = (0.0020000000949949f * warp_seen_from_0(_S871, _S875, _S876) + _S882) / (_S882 + _S878 / max(1.0f - _S881.by_warp_0 - _S881.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S884 : f32 = 1.0f - _S879;
    return bounced_of_families_0(_S871, _S872, _S873, _S874, scaled_0(_S880, _S883 * _S884), scaled_0(_S881, (1.0f - _S883) * _S884));
}

fn bounced_over_0( _S885 : u32,  _S886 : Components_0,  _S887 : CloseUp_0,  _S888 : FamilyAlbedos_0,  _S889 : vec3<f32>,  _S890 : vec3<f32>) -> Bounced_0
{
    var _S891 : bool = (_S890.z) < 0.0f;
    var _S892 : Interior_0 = interior_of_0(_S885, _S889, _S891);
    var bounced_2 : Bounced_0 = bounced_far_0(_S885, _S888, _S889, _S892, to_face_frame_0(_S890, _S891), _S891, _S886.diffuse_warp_0, _S886.diffuse_weft_0, _S886.hole_2);
    if((_S887.weight_0) > 0.0f)
    {
        var _S893 : Bounced_0 = bounced_of_families_0(_S885, _S888, _S889, _S892, _S887.warp_1, _S887.weft_1);
        var _S894 : vec3<f32> = vec3<f32>(_S887.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S893.reflected_0, _S894);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S893.transmitted_0, _S894);
    }
    return bounced_2;
}

fn composed_0( _S895 : u32,  _S896 : Components_0,  _S897 : CloseUp_0,  _S898 : FamilyAlbedos_0,  _S899 : vec3<f32>,  _S900 : vec3<f32>,  _S901 : vec3<f32>) -> vec3<f32>
{
    var _S902 : Albedos_0 = tinted_0(_S898.warp_5, _S899);
    var _S903 : Albedos_0 = tinted_0(_S898.weft_5, _S899);
    var _S904 : vec3<f32> = vec3<f32>(_S896.diffuse_warp_0);
    var _S905 : vec3<f32> = vec3<f32>(_S896.diffuse_weft_0);
    var _S906 : vec3<f32> = vec3<f32>(_S896.specular_warp_0);
    var _S907 : vec3<f32> = vec3<f32>(_S896.specular_weft_0);
    var _S908 : vec3<f32> = _S902.diffuse_reflect_0 * _S904 + _S903.diffuse_reflect_0 * _S905 + _S902.specular_reflect_0 * _S906 + _S903.specular_reflect_0 * _S907;
    var _S909 : f32 = _S901.z;
    var body_0 : vec3<f32>;
    if((_S900.z * _S909) < 0.0f)
    {
        body_0 = _S902.diffuse_transmit_0 * _S904 + _S903.diffuse_transmit_0 * _S905 + _S902.specular_transmit_0 * _S906 + _S903.specular_transmit_0 * _S907;
    }
    else
    {
        body_0 = _S908;
    }
    if((fabrics_0[_S895].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S895, _S896, _S897, _S898, _S899, _S901), _S900, _S901);
    }
    var _S910 : f32 = fabrics_0[_S895].sheen_strength_0;
    if((fabrics_0[_S895].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S911 : bool = _S909 < 0.0f;
    var _S912 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S900, _S911), to_face_frame_0(_S901, _S911), _S910, fabrics_0[_S895].sheen_roughness_0);
    return vec3<f32>(_S912.y) * body_0 + vec3<f32>(((_S896.light_visibility_1 + _S896.hole_2) * _S912.x));
}

fn light_of_footprint_0( _S913 : i32,  _S914 : u32,  _S915 : VisiblePoint_0,  _S916 : vec2<u32>,  _S917 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S915.draft_0;
    footprint_0.dx_0 = _S915.draft_dx_0;
    footprint_0.dy_0 = _S915.draft_dy_0;
    var _S918 : vec2<f32> = fract(vec2<f32>(f32(((frames_0[_S913].pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S919 : vec3<f32> = to_local_0(_S915, _S915.view_0);
    var _S920 : u32 = light_sample_count_0(_S913);
    var _S921 : vec3<f32> = vec3<f32>(0.0f);
    var number_7 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S921;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        if(number_7 < (max(_S920, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S922 : f32;
        if(number_7 < _S920)
        {
            _S922 = visibility_at_0(_S913, number_7, _S916);
        }
        else
        {
            _S922 = 0.0f;
        }
        var _S923 : bool;
        if(_S922 <= 0.0f)
        {
            _S923 = number_7 > u32(0);
        }
        else
        {
            _S923 = false;
        }
        if(_S923)
        {
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S924 : LightSample_0 = light_sample_0(_S913, number_7, _S916, _S915.position_0);
        var _S925 : vec3<f32> = to_local_0(_S915, _S924.towards_0);
        var _S926 : Estimate_0 = lobes_estimate_of_pass_0(_S914, footprint_0, 1.0f, _S918, _S925, _S919);
        radiance_1 = radiance_1 + vec3<f32>(_S922) * _S924.irradiance_1 * composed_0(_S914, _S926.components_0, _S926.close_0, _S926.albedos_5, _S917, _S925, _S919);
        hole_7 = _S926.components_0.hole_2;
        number_7 = number_7 + u32(1);
    }
    var _S927 : f32 = fabrics_0[_S914].sheen_strength_0;
    if((fabrics_0[_S914].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S927 * sheen_lobe_0(abs(_S919.z), fabrics_0[_S914].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S928 : u32 = id_0.x;
    var _S929 : u32 = frames_0[i32(0)].width_0;
    var _S930 : bool;
    if(_S928 >= (frames_0[i32(0)].width_0))
    {
        _S930 = true;
    }
    else
    {
        _S930 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S930)
    {
        return;
    }
    var _S931 : u32 = id_0.y * _S929 + _S928;
    var _S932 : u32 = layers_0[_S931].face_0;
    if((layers_0[_S931].face_0) == u32(0))
    {
        return;
    }
    var _S933 : u32 = _S932 - u32(1);
    var _S934 : u32 = face_fabrics_0[_S933];
    var _S935 : vec2<u32> = id_0.xy;
    var _S936 : VisiblePoint_0 = visible_point_0(i32(0), _S934, _S933, _S935);
    accumulate_0(_S931, light_of_footprint_0(i32(0), _S934, _S936, _S935, filtered_albedo_0(_S934, _S936)));
    return;
}

