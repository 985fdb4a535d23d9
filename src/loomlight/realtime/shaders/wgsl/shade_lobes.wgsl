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

struct Neural_std430_0
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

struct Clustered_std430_0
{
    @align(4) is_baked_1 : u32,
    @align(4) clusters_0 : u32,
    @align(4) rank_0 : u32,
    @align(4) channels_0 : u32,
    @align(4) columns_0 : u32,
    @align(4) rows_0 : u32,
    @align(4) texel_width_0 : f32,
    @align(4) texel_height_0 : f32,
    @align(4) samples_1 : u32,
    @align(4) sums_0 : u32,
    @align(4) labels_0 : u32,
    @align(4) coefficients_0 : u32,
    @align(4) basis_0 : u32,
    @align(4) moments_1 : u32,
    @align(4) light_0 : u32,
    @align(4) view_0 : u32,
    @align(4) offset_1 : u32,
    @align(4) trust_0 : u32,
};

struct Fabric_std430_0
{
    @align(4) warp_0 : u32,
    @align(4) weft_0 : u32,
    @align(4) lobes_0 : Lobes_std430_0,
    @align(4) neural_0 : Neural_std430_0,
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
    @align(4) has_detail_0 : u32,
    @align(4) uv_width_0 : f32,
    @align(4) uv_height_0 : f32,
    @align(4) is_open_0 : u32,
    @align(4) openness_0 : u32,
    @align(4) albedo_map_0 : u32,
    @align(4) albedo_map_levels_0 : u32,
    @align(4) has_yarns_0 : u32,
    @align(4) mean_hole_0 : f32,
    @align(4) latent_0 : Latent_std430_0,
    @align(4) clustered_0 : Clustered_std430_0,
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
    @align(4) has_plies_0 : f32,
    @align(4) plies_per_mm_0 : f32,
    @align(4) ply_sine_0 : f32,
    @align(4) ply_cosine_0 : f32,
    @align(4) fibre_tilt_0 : f32,
    @align(4) fibre_tone_0 : f32,
    @align(4) slub_0 : f32,
    @align(4) slubs_per_mm_0 : f32,
    @align(4) per_half_width_0 : f32,
    @align(4) hairiness_0 : f32,
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
     view_1 : vec3<f32>,
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

fn hash_key_0( thread_0 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_0 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_0 : u32) -> u32
{
    return scramble_0(cell_0 + key_0);
}

fn uniform_hash_0( thread_1 : u32,  cell_1 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_1)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_1 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S27 : u32 = pixel_0.x;
    var _S28 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S27, _S28, stream_2), uniform_hash_0(_S27, _S28, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
     thread_2 : u32,
     across_2 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S51 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S52 : f32 = fma(- _S51, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S52;
    cell_2.above_0 = families_0[family_1].size_0 - _S52;
    cell_2.across_2 = _S52 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S51).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_2;
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
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S54 : u32;
    if(_S53 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1))))
    {
        _S54 = u32(1);
    }
    else
    {
        _S54 = u32(0);
    }
    var _S55 : u32 = min(thread_3 + _S54, u32(families_0[family_2].count_0) - u32(1));
    var _S56 : u32 = families_0[family_2].place_table_0 + _S55 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S55;
    cell_3.below_0 = _S53 - table_number_0(_S56);
    cell_3.above_0 = table_number_0(_S56 + u32(1)) - _S53;
    cell_3.across_2 = _S53 - table_number_0(_S56 + u32(2));
    cell_3.half_width_1 = table_number_0(_S56 + u32(3));
    return cell_3;
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
    var cell_4 : Cell_0;
    var _S61 : u32;
    if(is_first_0)
    {
        _S61 = first_1.thread_2;
    }
    else
    {
        _S61 = second_0.thread_2;
    }
    cell_4.thread_2 = _S61;
    var _S62 : f32;
    if(is_first_0)
    {
        _S62 = first_1.across_2;
    }
    else
    {
        _S62 = second_0.across_2;
    }
    cell_4.across_2 = _S62;
    if(is_first_0)
    {
        _S62 = first_1.half_width_1;
    }
    else
    {
        _S62 = second_0.half_width_1;
    }
    cell_4.half_width_1 = _S62;
    if(is_first_0)
    {
        _S62 = first_1.below_0;
    }
    else
    {
        _S62 = second_0.below_0;
    }
    cell_4.below_0 = _S62;
    if(is_first_0)
    {
        _S62 = first_1.above_0;
    }
    else
    {
        _S62 = second_0.above_0;
    }
    cell_4.above_0 = _S62;
    return cell_4;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S63 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S63.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S63.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_5 : u32,  first_2 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_2) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_5, last_0) - boundary_0(family_5, thread_5, first_2);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_6 : u32) -> Bend_0
{
    var _S64 : u32 = families_0[family_6].bend_table_0;
    var _S65 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S65 = u32(0);
    }
    else
    {
        _S65 = thread_6 * u32(4);
    }
    var _S66 : u32 = _S64 + _S65;
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

fn unpack_0( own_0 : u32,  other_0 : u32,  thread_7 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S67 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S68 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S69 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S70 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S71 : i32 = - _S67;
    var _S72 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S71, i32(0));
    run_0.from_start_0 = _S72;
    var _S73 : i32 = _S68 + i32(1);
    var _S74 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S73);
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
    run_0.bend_1 = bend_of_0(own_0, thread_7);
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
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S76, _S77), run_0.bend_1.arc_0);
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

fn section_at_0( cell_5 : Cell_0) -> Section_0
{
    var _S79 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S80 : f32 = clamp(cell_5.across_2, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_3 = _S80;
    var _S81 : f32 = _S79 * _S79 - square_1(_S80);
    var _S82 : f32 = rsqrt_0(_S81);
    section_0.drop_0 = _S79 - _S81 * _S82;
    section_0.slope_0 = - _S80 * _S82;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_7].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_7].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_7].bend_table_0 + u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4) + u32(3));
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
        _S85 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S88 : f32;
    if((shown_1.on_top_0) != _S87)
    {
        _S88 = 0.0f;
    }
    else
    {
        var _S89 : f32 = families_0[other_1].height_scale_0;
        var _S90 : i32;
        if(_S83)
        {
            _S90 = i32(-1);
        }
        else
        {
            _S90 = i32(1);
        }
        _S88 = _S89 * edge_drop_0(other_1, crossed_1.thread_2, _S90);
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

fn outline_distance_0( cell_6 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S97 : f32;
    if(forwards_0)
    {
        _S97 = cell_6.across_2;
    }
    else
    {
        _S97 = - cell_6.across_2;
    }
    var _S98 : f32;
    if(forwards_0)
    {
        _S98 = cell_6.above_0;
    }
    else
    {
        _S98 = cell_6.below_0;
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
    var _S101 : f32 = - cell_6.half_width_1;
    var _S102 : bool = _S97 < _S101;
    var _S103 : bool = _S97 >= (cell_6.half_width_1);
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
        _S105 = cell_6.half_width_1;
    }
    var _S106 : f32 = _S105 - _S97;
    if(_S99)
    {
        _S97 = 2.0f * _S98 + _S97 - cell_6.half_width_1;
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

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S135 : Hair_0;
    _S135.cover_0 = cover_1;
    _S135.normal_3 = normal_4;
    _S135.tangent_2 = tangent_3;
    return _S135;
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
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

fn albedos_of_0( family_8 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_8].albedo_table_0 + families_0[family_8].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_4 : f32,  along_0 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S136 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S136, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S136, 2.0f * (across_4 / width_2 - _S136) - 1.0f);
}

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S137 : f32;
    if(back_4)
    {
        _S137 = - families_0[family_9].ply_sine_0;
    }
    else
    {
        _S137 = families_0[family_9].ply_sine_0;
    }
    var _S138 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * _S137) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S138 - floor(_S138)) - 1.0f;
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_1 : u32,  position_4 : f32) -> vec2<f32>
{
    var _S139 : f32 = floor(position_4);
    var _S140 : f32 = position_4 - _S139;
    var _S141 : u32 = u32(i32(_S139));
    var _S142 : f32 = signed_noise_0(hash_bits_0(key_1, _S141));
    var _S143 : f32 = signed_noise_0(hash_bits_0(key_1, _S141 + u32(1)));
    return vec2<f32>(mix(_S142, _S143, smooth_share_0(_S140)), 6.0f * _S140 * (1.0f - _S140) * (_S143 - _S142));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S144 : f32 = cell_7.y;
    var _S145 : f32 = floor(_S144);
    var _S146 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S145));
    var _S147 : u32 = hash_bits_0(key_2, _S146);
    var _S148 : u32 = hash_bits_0(key_2, _S146 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S147), signed_noise_0((_S147 >> (u32(16))))), vec2<f32>(signed_noise_0(_S148), signed_noise_0((_S148 >> (u32(16))))), vec2<f32>(smooth_share_0(_S144 - _S145)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S149 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S149.x, _S149.y), _S149.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S150 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S150.x, _S150.y), _S150.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_8 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S151 : vec3<f32>;
    if((dot(frame_0.tangent_4, hair_0.tangent_2)) < 0.0f)
    {
        _S151 = (vec3<f32>(0) - hair_0.tangent_2);
    }
    else
    {
        _S151 = hair_0.tangent_2;
    }
    var blended_0 : YarnFrame_0;
    var _S152 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S153 : vec3<f32> = normalize(mix(frame_0.normal_5, hair_0.normal_3, _S152));
    blended_0.normal_5 = _S153;
    var _S154 : vec3<f32> = mix(frame_0.tangent_4, _S151, _S152);
    var _S155 : vec3<f32> = _S154 - vec3<f32>(dot(_S154, _S153)) * _S153;
    blended_0.tangent_4 = _S155 * vec3<f32>(rsqrt_0(max(dot(_S155, _S155), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_5.z - 1.0f) + 1.0f));
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_6 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S156 : f32 = light_1.z;
    if(_S156 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S156, 0.0f), max(dot(light_1, normal_6), 0.0f), blend_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S157 : f32 = dot(direction_3, tangent_5);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S157 * _S157 + 1.0f, roughness_1 * roughness_1));
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
    var _S158 : f32 = roughness_2 * roughness_2;
    var _S159 : f32 = squared_along_0 * (1.0f - _S158) + _S158;
    return 0.31830987334251404f * _S158 * roughness_2 / (_S159 * _S159);
}

fn density_between_0( light_2 : vec3<f32>,  view_2 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S160 : vec3<f32> = light_2 + view_2;
    var _S161 : f32 = dot(_S160, tangent_6);
    return flake_density_0(min(_S161 * _S161 / max(square_0(_S160), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_3 : vec3<f32>,  view_3 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S162 : f32 = - dot(light_3, normal_7);
    var _S163 : f32 = dot(view_3, normal_7);
    var _S164 : bool;
    if(_S162 <= 0.0f)
    {
        _S164 = true;
    }
    else
    {
        _S164 = _S163 <= 0.0f;
    }
    if(_S164)
    {
        return 0.0f;
    }
    var _S165 : f32 = 1.0f / max(_S163, 9.99999997475242708e-07f);
    var _S166 : f32 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S162, 9.99999997475242708e-07f);
    var _S167 : f32 = projected_area_1(view_3, tangent_7, roughness_4) * _S165;
    return density_between_0(light_3, view_3, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S166, _S167)) * mean_attenuation_0(optical_depth_1 * abs(_S166 - _S167)) * _S165;
}

fn reflection_0( light_4 : vec3<f32>,  view_4 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S168 : f32 = dot(light_4, normal_8);
    var _S169 : bool;
    if(_S168 <= 0.0f)
    {
        _S169 = true;
    }
    else
    {
        _S169 = (dot(view_4, normal_8)) <= 0.0f;
    }
    if(_S169)
    {
        return 0.0f;
    }
    var _S170 : f32 = max(_S168, 9.99999997475242708e-07f);
    var _S171 : f32 = max(dot(view_4, normal_8), 9.99999997475242708e-07f);
    var _S172 : f32 = projected_area_1(light_4, tangent_8, roughness_5) * _S171 + projected_area_1(view_4, tangent_8, roughness_5) * _S170;
    var _S173 : f32 = optical_depth_2 * _S172 / (_S170 * _S171);
    return 0.25f * density_between_0(light_4, view_4, tangent_8, roughness_5) * (_S173 * mean_attenuation_0(_S173)) * _S170 / _S172;
}

fn with_added_0( sums_1 : Components_0,  more_0 : Components_0,  weight_1 : f32) -> Components_0
{
    var result_0 : Components_0;
    result_0.diffuse_warp_0 = sums_1.diffuse_warp_0 + weight_1 * more_0.diffuse_warp_0;
    result_0.diffuse_weft_0 = sums_1.diffuse_weft_0 + weight_1 * more_0.diffuse_weft_0;
    result_0.specular_warp_0 = sums_1.specular_warp_0 + weight_1 * more_0.specular_warp_0;
    result_0.specular_weft_0 = sums_1.specular_weft_0 + weight_1 * more_0.specular_weft_0;
    result_0.light_visibility_1 = sums_1.light_visibility_1 + weight_1 * more_0.light_visibility_1;
    result_0.hole_2 = sums_1.hole_2 + weight_1 * more_0.hole_2;
    return result_0;
}

fn scaled_0( blocked_0 : Blocked_0,  share_3 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_3 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_3 * blocked_0.by_weft_0;
    result_1.far_0 = share_3 * blocked_0.far_0;
    return result_1;
}

fn wrapped_cell_0( position_5 : f32,  count_2 : f32) -> f32
{
    return min(floor((position_5 - floor(position_5)) * count_2), count_2 - 1.0f);
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
    var _S174 : f32 = abs(x_10);
    var _S175 : f32 = abs(y_3);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S174, _S175) / max(max(_S174, _S175), 1.00000000317107685e-30f));
    var angle_1 : f32;
    if(_S175 > _S174)
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
    var _S176 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * 5.09295797348022461f;
    var _S177 : f32 = floor(_S176);
    var _S178 : f32 = _S176 - _S177;
    var _S179 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S180 : f32 = 7.0f * _S179 * sqrt(_S179);
    var _S181 : f32 = min(floor(_S180), 6.0f);
    var _S182 : f32 = _S180 - _S181;
    var _S183 : u32 = u32(i32(_S177) + i32(32)) % u32(32);
    var _S184 : u32 = u32(_S181);
    var _S185 : u32 = _S183 * u32(8) + _S184;
    var _S186 : u32 = (_S183 + u32(1)) % u32(32) * u32(8) + _S184;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S185, _S185 + u32(1), _S186, _S186 + u32(1));
    var _S187 : f32 = 1.0f - _S178;
    var _S188 : f32 = 1.0f - _S182;
    var _S189 : vec4<u32> = vec4<u32>(vec4<f32>(_S187 * _S188, _S187 * _S182, _S178 * _S188, _S178 * _S182) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S189;
    taps_0.inverse_sum_0 = 1.0f / f32(_S189.x + _S189.y + _S189.z + _S189.w);
    return taps_0;
}

fn half_vector_0( light_5 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S190 : vec3<f32> = light_5 + view_5;
    return _S190 * vec3<f32>(rsqrt_0(max(square_0(_S190), 9.999999960041972e-13f)));
}

fn shadow_correlation_0( light_6 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S191 : vec2<f32> = light_6.xy;
    var _S192 : vec2<f32> = view_6.xy;
    var _S193 : f32 = dot(_S191, _S192) / max(sqrt(dot(_S191, _S191) * dot(_S192, _S192)), 9.99999997475242708e-07f);
    if((light_6.z) < 0.0f)
    {
        return vec3<f32>(vec2<f32>((-0.09000000357627869f + -0.07999999821186066f * _S193)), 0.0f);
    }
    return vec3<f32>(min(0.62000000476837158f + 0.62999999523162842f * _S193, 1.20000004768371582f), 0.62000000476837158f, 0.37000000476837158f);
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_1 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S194 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S195 : vec4<u32> = ((packs_1 & (_S194))) * taps_1.weights_0;
    var _S196 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S194))) * taps_1.weights_0;
    return bytes_of_sums_0(_S195.x + _S195.y + _S195.z + _S195.w, _S196.x + _S196.y + _S196.z + _S196.w) * vec4<f32>(taps_1.inverse_sum_0);
}

fn interpolate_table_0( taps_2 : NodeTaps_0,  table_1 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S197 : vec4<u32> = vec4<u32>(table_1) + taps_2.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_2, vec4<u32>(words_0[_S197.x], words_0[_S197.y], words_0[_S197.z], words_0[_S197.w]));
}

struct Group_0
{
     normal_9 : vec3<f32>,
     weight_2 : f32,
     tangent_9 : vec3<f32>,
     variance_0 : vec3<f32>,
     covariance_0 : vec3<f32>,
     roughness_6 : f32,
};

fn group_at_0( row_1 : u32,  roughness_7 : f32) -> Group_0
{
    var group_0 : Group_0;
    group_0.normal_9 = vec3<f32>(table_number_0(row_1), table_number_0(row_1 + u32(1)), table_number_0(row_1 + u32(2)));
    group_0.weight_2 = table_number_0(row_1 + u32(3));
    var _S198 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_9 = _S198;
    var _S199 : f32 = table_number_0(row_1 + u32(7));
    var _S200 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S199, _S200, 1.0f - square_0(_S198) - _S199 - _S200);
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
    var _S201 : f32 = direction_5.x;
    var _S202 : f32 = direction_5.y;
    var _S203 : f32 = direction_5.z;
    return max(dot(this_5.variance_0, direction_5 * direction_5) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S201 * _S202, _S201 * _S203, _S202 * _S203)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_6 : vec3<f32>) -> f32
{
    var _S204 : f32 = dot(direction_6, group_1.tangent_9);
    var _S205 : f32 = group_1.roughness_6;
    var _S206 : f32 = _S205 * _S205;
    return sqrt(max((_S206 - 1.0f) * (_S204 * _S204 + Group_variance_along_0(group_1, direction_6)) + 1.0f, _S206));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S207 : f32 = group_2.roughness_6;
    var _S208 : f32 = max(sqrt(max(1.0f - _S207 * _S207, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S209 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S210 : f32 = dot(half_0, group_2.tangent_9);
    var _S211 : f32 = _S208 * (_S210 - _S209);
    var _S212 : f32 = _S208 * (_S210 + _S209);
    var _S213 : f32 = _S211 * _S212;
    var _S214 : f32 = 2.0f * _S209 * _S208;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S213) / ((_S211 * _S211 + 1.0f) * (_S212 * _S212 + 1.0f)) + arc_tangent_0(_S214, 1.0f + _S213) / _S214);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_7 : vec3<f32>,  view_7 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S215 : bool = (light_7.z) < 0.0f;
    var _S216 : f32 = dot(light_7, group_3.normal_9);
    var _S217 : f32;
    if(_S215)
    {
        _S217 = - _S216;
    }
    else
    {
        _S217 = _S216;
    }
    var _S218 : f32 = max(dot(view_7, group_3.normal_9), 0.01999999955296516f);
    var _S219 : f32 = mean_area_0(group_3, light_7) / max(_S217, 0.01999999955296516f);
    var _S220 : f32 = mean_area_0(group_3, view_7) / _S218;
    if(_S215)
    {
        _S217 = abs(_S219 - _S220);
    }
    else
    {
        _S217 = _S219 + _S220;
    }
    var _S221 : f32 = optical_depth_3 * max(_S217, 0.00100000004749745f);
    if(_S215)
    {
        _S217 = exponential_0(- optical_depth_3 * min(_S219, _S220));
    }
    else
    {
        _S217 = 1.0f;
    }
    var _S222 : f32 = optical_depth_3 * _S217 * (1.0f - exponential_0(- _S221)) / _S221 / _S218;
    if(_S215)
    {
        _S217 = 1.0f;
    }
    else
    {
        _S217 = 1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_9));
    }
    return 0.25f * mean_density_0(group_3, half_1) * _S217 * _S222;
}

struct Bound_0
{
     thread_12 : u32,
     turns_2 : f32,
     cell_9 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_10 : u32,  position_6 : f32) -> Bound_0
{
    var _S223 : Cell_0 = locate_0(family_10, position_6);
    var _S224 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S223.thread_2 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_12 = _S223.thread_2;
    bound_0.turns_2 = round((position_6 - families_0[family_10].start_0 - _S224 - _S223.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_9 = _S223.below_0;
    var _S225 : f32 = 2.0f * _S223.half_width_1;
    bound_0.width_3 = _S225;
    bound_0.visible_0 = clamp((_S223.across_2 + _S223.half_width_1) / _S225, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S223.below_0, _S223.below_0 - _S223.across_2 - _S223.half_width_1) + max(_S223.across_2 - _S223.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S226 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S227 : f32 = 0.5f * max(size_2, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_11, _S226 - _S227);
    stretch_0.high_1 = bound_at_0(family_11, _S226 + _S227);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S228 : f32 = Stretch_turns_0(stretch_1);
    var _S229 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_1.thread_12;
    var _S230 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_1.thread_12;
    var _S231 : f32 = table_number_0(_S230) - table_number_0(_S229);
    var _S232 : f32 = table_number_0(_S230 + u32(1)) - table_number_0(_S229 + u32(1));
    return vec3<f32>(_S231 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_3 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_3 + _S228 * families_0[family_12].visible_total_0, _S232 - _S231 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S228 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S232 + stretch_1.high_1.cell_9 - stretch_1.low_1.cell_9 + _S228 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S233 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S234 : u32 = families_0[family_13].colour_threads_0 + _S233 * stretch_2.low_1.thread_12 + quantity_0;
    var _S235 : u32 = families_0[family_13].colour_threads_0 + _S233 * stretch_2.high_1.thread_12 + quantity_0;
    var _S236 : u32 = families_0[family_13].colour_threads_0 + _S233 * u32(families_0[family_13].count_0) + quantity_0;
    var _S237 : f32 = table_number_0(_S234);
    var _S238 : f32 = table_number_0(_S235);
    var _S239 : f32 = Stretch_turns_0(stretch_2);
    var _S240 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S235 + families_0[family_13].quantities_0) - table_number_0(_S234 + families_0[family_13].quantities_0) + _S238 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_3 - _S237 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_3 + _S239 * table_number_0(_S236 + families_0[family_13].quantities_0), table_number_0(_S235 + _S240) - table_number_0(_S234 + _S240) + _S238 * stretch_2.high_1.cell_9 - _S237 * stretch_2.low_1.cell_9 + _S239 * table_number_0(_S236 + _S240));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_12) < (this_7.low_1.thread_12);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S241 : u32 = entries_0.z;
    var _S242 : u32 = entries_0.x;
    var _S243 : u32 = _S241 - _S242;
    var _S244 : u32;
    if(Stretch_wraps_0(this_8))
    {
        _S244 = whole_0;
    }
    else
    {
        _S244 = u32(0);
    }
    return vec4<u32>(_S243 + _S244, entries_0.w - _S241, entries_0.y - _S242, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_2 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S245 : u32 = row_2 + across_5.low_1.thread_12 * quantities_1;
    var _S246 : u32 = row_2 + across_5.high_1.thread_12 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S245], words_0[_S245 + quantities_1], words_0[_S246], words_0[_S246 + quantities_1]), words_0[row_2 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    var _S247 : f32 = - this_9.low_1.visible_0;
    var _S248 : f32 = Stretch_turns_0(this_9);
    var _S249 : f32;
    if(Stretch_wraps_0(this_9))
    {
        _S249 = 1.0f;
    }
    else
    {
        _S249 = 0.0f;
    }
    return vec4<f32>(1.0f, this_9.high_1.visible_0, _S247, _S248 - _S249);
}

fn integral_on_top_0( family_14 : u32,  across_6 : Stretch_0,  along_1 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S250 : u32 = u32(families_0[family_14].count_0);
    var _S251 : u32 = (_S250 + u32(1)) * families_0[family_14].quantities_0;
    var _S252 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S253 : vec4<u32> = row_differences_0(across_6, _S252 + along_1.low_1.thread_12 * _S251, _S250, families_0[family_14].quantities_0);
    var _S254 : vec4<u32> = row_differences_0(across_6, _S252 + (along_1.low_1.thread_12 + u32(1)) * _S251, _S250, families_0[family_14].quantities_0);
    var _S255 : vec4<u32> = row_differences_0(across_6, _S252 + along_1.high_1.thread_12 * _S251, _S250, families_0[family_14].quantities_0);
    var _S256 : vec4<u32> = row_differences_0(across_6, _S252 + (along_1.high_1.thread_12 + u32(1)) * _S251, _S250, families_0[family_14].quantities_0);
    var _S257 : vec4<u32> = row_differences_0(across_6, _S252 + crossing_count_0 * _S251, _S250, families_0[family_14].quantities_0);
    var _S258 : vec4<u32> = _S255 - _S253;
    var _S259 : vec4<u32>;
    if(Stretch_wraps_0(along_1))
    {
        _S259 = _S257;
    }
    else
    {
        _S259 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S260 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S258 + _S259)), _S260), dot(vec4<f32>(vec4<i32>(_S256 - _S255)), _S260), dot(vec4<f32>(vec4<i32>(_S254 - _S253)), _S260), dot(vec4<f32>(vec4<i32>(_S257)), _S260)), Stretch_weights_0(along_1)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S261 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S262 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S262 * _S261.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S262 * _S261.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S262 * _S261.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S262 * _S261.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_5 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S263 : vec3<f32> = lengths_0(crossing_1, other_2);
    var is_exposed_0 : bool = false;
    var weight_4 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_15].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S264 : vec2<f32> = integrals_along_0(family_15, own_1, quantity_2);
        var _S265 : f32 = integral_on_top_0(family_15, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S266 : f32 = _S264.x;
        var _S267 : f32 = _S266 * _S263.x;
        var _S268 : f32;
        if(back_5)
        {
            _S268 = _S267 - _S265;
        }
        else
        {
            _S268 = _S265;
        }
        var _S269 : bool = quantity_2 == u32(0);
        if(_S269)
        {
            is_exposed_0 = _S268 > (16.0f * families_0[family_15].area_unit_0 * min(_S267 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S267);
        }
        var _S270 : f32 = _S266 * _S263.y;
        var _S271 : f32;
        if(is_exposed_0)
        {
            _S271 = _S268;
        }
        else
        {
            _S271 = 0.0f;
        }
        var _S272 : f32 = _S270 + _S271 + 0.000244140625f * _S263.z * _S264.y;
        if(_S269)
        {
            weight_4 = 1.0f / max(_S272, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S272 * weight_4, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
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
    var _S273 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_3.diffuse_reflect_0, second_1.diffuse_reflect_0, _S273);
    albedos_3.diffuse_transmit_0 = mix(first_3.diffuse_transmit_0, second_1.diffuse_transmit_0, _S273);
    albedos_3.specular_reflect_0 = mix(first_3.specular_reflect_0, second_1.specular_reflect_0, _S273);
    albedos_3.specular_transmit_0 = mix(first_3.specular_transmit_0, second_1.specular_transmit_0, _S273);
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
    var _S274 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S275 : vec3<f32> = sends_0.sky_warp_0 + _S274 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S275;
    var _S276 : vec3<f32> = sends_0.sky_weft_0 + _S274 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S276;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S275 + vec3<f32>(sends_0.blocks_weft_0) * _S276;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_8 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S277 : f32 = 1.0f - view_8.z;
    var _S278 : f32 = _S277 * _S277;
    (*terms_0)[i32(0)] = 1.0f;
    var _S279 : f32 = view_8.x;
    var _S280 : f32 = _S279 * _S279;
    var _S281 : f32 = view_8.y;
    var _S282 : f32 = _S281 * _S281;
    (*terms_0)[i32(1)] = sqrt(max(_S280 + _S282, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S278;
    (*terms_0)[i32(3)] = _S278 * _S278;
    (*terms_0)[i32(4)] = _S280 - _S282;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_9 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S283 : f32 = 1.0f - view_9.z;
    var _S284 : f32 = _S283 * _S283;
    (*terms_1)[i32(0)] = 1.0f;
    var _S285 : f32 = view_9.x;
    var _S286 : f32 = _S285 * _S285;
    var _S287 : f32 = view_9.y;
    var _S288 : f32 = _S287 * _S287;
    (*terms_1)[i32(1)] = sqrt(max(_S286 + _S288, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S284;
    (*terms_1)[i32(3)] = _S284 * _S284;
    (*terms_1)[i32(4)] = _S286 - _S288;
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
     back_6 : vec3<f32>,
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
    var _S289 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S290 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_6 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S290 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S290 * interior_0.far_1 + yarn_2.back_6 * _S289;
    return bounced_0;
}

fn sum_of_0( first_4 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_4.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_4.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_8 : vec3<f32>,  view_10 : vec3<f32>) -> vec3<f32>
{
    var _S291 : f32 = light_8.z;
    var _S292 : vec3<f32>;
    if((_S291 * view_10.z) < 0.0f)
    {
        _S292 = bounced_1.transmitted_0;
    }
    else
    {
        _S292 = bounced_1.reflected_0;
    }
    return _S292 * vec3<f32>((abs(_S291) * 0.31830987334251404f));
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
    var _S293 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S294 : f32 = 2.0f * sqrt(_S293) - 1.0f;
    var _S295 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S294, _S295), 0.00999999977648258f, 1.0f), clamp((1.0f - _S293) * sheen_shear_0(_S294, _S295), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S294, _S295), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_9 : vec3<f32>,  view_11 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S296 : f32 = light_9.z;
    var _S297 : bool;
    if(_S296 <= 0.0f)
    {
        _S297 = true;
    }
    else
    {
        _S297 = (view_11.z) <= 0.0f;
    }
    if(_S297)
    {
        return 0.0f;
    }
    var _S298 : vec2<f32> = view_11.xy;
    var _S299 : f32 = dot(_S298, _S298);
    var _S300 : vec2<f32>;
    if(_S299 > 9.99999968265522539e-21f)
    {
        _S300 = _S298 * vec2<f32>(rsqrt_0(_S299));
    }
    else
    {
        _S300 = vec2<f32>(1.0f, 0.0f);
    }
    var _S301 : f32 = scale_0 * dot(light_9.xy, _S300) + shear_0 * _S296;
    var _S302 : f32 = scale_0 * (light_9.y * _S300.x - light_9.x * _S300.y);
    var _S303 : f32 = _S301 * _S301 + _S302 * _S302 + _S296 * _S296;
    return 0.31830987334251404f * scale_0 * scale_0 * _S296 / max(_S303 * _S303, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_10 : vec3<f32>,  view_12 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S304 : vec3<f32> = sheen_lobe_0(view_12.z, roughness_9);
    var _S305 : f32 = strength_0 * _S304.z;
    return vec2<f32>(_S305 * transformed_cosine_0(light_10, view_12, _S304.x, _S304.y), 1.0f - _S305);
}

fn accumulate_0( index_7 : u32,  light_11 : vec4<f32>)
{
    var _S306 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_11;
    layers_0[index_7].share_0 = _S306 * (1.0f - light_11.w);
    return;
}

fn camera_right_0( _S307 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S307].right_x_0, frames_0[_S307].right_y_0, frames_0[_S307].right_z_0);
}

fn camera_up_0( _S308 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S308].up_x_0, frames_0[_S308].up_y_0, frames_0[_S308].up_z_0);
}

fn camera_forward_0( _S309 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S309].forward_x_0, frames_0[_S309].forward_y_0, frames_0[_S309].forward_z_0);
}

fn camera_origin_0( _S310 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S310].origin_x_0, frames_0[_S310].origin_y_0, frames_0[_S310].origin_z_0);
}

fn face_point_0( _S311 : u32,  _S312 : u32,  _S313 : f32,  _S314 : f32) -> VisiblePoint_0
{
    var _S315 : u32 = u32(3) * _S312;
    var _S316 : Vertex_std430_0 = vertices_0[corners_0[_S315]];
    var _S317 : Vertex_std430_0 = vertices_0[corners_0[_S315 + u32(1)]];
    var _S318 : Vertex_std430_0 = vertices_0[corners_0[_S315 + u32(2)]];
    var _S319 : vec3<f32> = position_of_0(&(_S317));
    var _S320 : vec3<f32> = position_of_0(&(_S316));
    var _S321 : vec3<f32> = _S319 - _S320;
    var _S322 : vec3<f32> = position_of_0(&(_S318));
    var _S323 : vec3<f32> = _S322 - _S320;
    var _S324 : f32 = _S316.u_0;
    var _S325 : f32 = _S317.u_0 - _S316.u_0;
    var _S326 : f32 = _S316.v_0;
    var _S327 : f32 = _S317.v_0 - _S316.v_0;
    var _S328 : vec2<f32> = vec2<f32>(_S325, _S327);
    var _S329 : f32 = _S318.u_0 - _S316.u_0;
    var _S330 : f32 = _S318.v_0 - _S316.v_0;
    var _S331 : vec2<f32> = vec2<f32>(_S329, _S330);
    var _S332 : f32;
    if((_S325 * _S330 - _S327 * _S329) < 0.0f)
    {
        _S332 = -1.0f;
    }
    else
    {
        _S332 = 1.0f;
    }
    var _S333 : vec3<f32> = vec3<f32>(_S332) * (vec3<f32>(_S330) * _S321 - vec3<f32>(_S327) * _S323);
    var _S334 : vec3<f32> = vec3<f32>(_S332) * (vec3<f32>(_S325) * _S323 - vec3<f32>(_S329) * _S321);
    var point_2 : VisiblePoint_0;
    var _S335 : f32 = 1.0f - _S313 - _S314;
    var _S336 : vec3<f32> = normal_of_0(&(_S316));
    var _S337 : vec3<f32> = vec3<f32>(_S335) * _S336;
    var _S338 : vec3<f32> = normal_of_0(&(_S317));
    var _S339 : vec3<f32> = vec3<f32>(_S313);
    var _S340 : vec3<f32> = _S337 + _S339 * _S338;
    var _S341 : vec3<f32> = normal_of_0(&(_S318));
    var _S342 : vec3<f32> = vec3<f32>(_S314);
    var _S343 : vec3<f32> = normalize(_S340 + _S342 * _S341);
    point_2.normal_0 = _S343;
    var _S344 : vec3<f32> = normalize(_S333 - _S343 * vec3<f32>(dot(_S343, _S333)));
    point_2.axis_x_0 = _S344;
    point_2.axis_y_0 = cross(_S343, _S344);
    var _S345 : vec3<f32> = normalize(cross(_S321, _S323));
    var _S346 : vec3<f32>;
    if((dot(_S345, _S343)) < 0.0f)
    {
        _S346 = (vec3<f32>(0) - _S345);
    }
    else
    {
        _S346 = _S345;
    }
    point_2.face_normal_0 = _S346;
    point_2.position_0 = _S320 + _S339 * _S321 + _S342 * _S323;
    point_2.view_1 = point_2.normal_0;
    point_2.uv_1 = vec2<f32>(_S324, _S326) + vec2<f32>(_S313) * _S328 + vec2<f32>(_S314) * _S331;
    var _S347 : bool = (dot(cross(_S333, _S334), point_2.normal_0)) < 0.0f;
    var _S348 : f32 = fabrics_0[_S311].uv_width_0;
    if(_S347)
    {
        _S332 = - fabrics_0[_S311].uv_height_0;
    }
    else
    {
        _S332 = fabrics_0[_S311].uv_height_0;
    }
    var _S349 : vec2<f32> = vec2<f32>(_S348, _S332);
    point_2.draft_per_uv_0 = _S349;
    var _S350 : vec2<f32> = point_2.uv_1 * _S349;
    if(_S347)
    {
        _S332 = fabrics_0[_S311].uv_height_0;
    }
    else
    {
        _S332 = 0.0f;
    }
    point_2.draft_0 = _S350 + vec2<f32>(0.0f, _S332);
    var _S351 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S351;
    point_2.draft_dy_0 = _S351;
    return point_2;
}

fn visible_point_0( _S352 : i32,  _S353 : u32,  _S354 : u32,  _S355 : vec2<u32>) -> VisiblePoint_0
{
    var _S356 : u32 = u32(3) * _S354;
    var _S357 : Vertex_std430_0 = vertices_0[corners_0[_S356]];
    var _S358 : Vertex_std430_0 = vertices_0[corners_0[_S356 + u32(1)]];
    var _S359 : Vertex_std430_0 = vertices_0[corners_0[_S356 + u32(2)]];
    var _S360 : vec3<f32> = position_of_1(&(_S358));
    var _S361 : vec3<f32> = position_of_1(&(_S357));
    var _S362 : vec3<f32> = _S360 - _S361;
    var _S363 : vec3<f32> = position_of_1(&(_S359));
    var _S364 : vec3<f32> = _S363 - _S361;
    var _S365 : vec3<f32> = cross(_S362, _S364);
    var _S366 : f32 = 1.0f / max(square_0(_S365), 1.00000000317107685e-30f);
    var _S367 : f32 = f32(frames_0[_S352].width_0);
    var _S368 : vec3<f32> = camera_right_0(_S352) * vec3<f32>((2.0f / _S367));
    var _S369 : f32 = f32(frames_0[_S352].height_0);
    var _S370 : vec3<f32> = camera_up_0(_S352) * vec3<f32>((-2.0f / _S369));
    var _S371 : vec3<f32> = camera_forward_0(_S352) + vec3<f32>((f32(_S355.x) + 0.5f - 0.5f * _S367)) * _S368 + vec3<f32>((f32(_S355.y) + 0.5f - 0.5f * _S369)) * _S370;
    var _S372 : f32 = dot(_S371, _S365);
    var _S373 : f32;
    if((abs(_S372)) > 1.00000000317107685e-30f)
    {
        _S373 = _S372;
    }
    else
    {
        _S373 = 1.00000000317107685e-30f;
    }
    var _S374 : f32 = 1.0f / _S373;
    var _S375 : vec3<f32> = _S361 - camera_origin_0(_S352);
    var _S376 : vec3<f32> = vec3<f32>((dot(_S375, _S365) * _S374));
    var _S377 : vec3<f32> = _S371 * _S376 - _S375;
    var _S378 : vec3<f32> = _S376 * (_S368 - _S371 * vec3<f32>((dot(_S368, _S365) * _S374)));
    var _S379 : vec3<f32> = _S376 * (_S370 - _S371 * vec3<f32>((dot(_S370, _S365) * _S374)));
    var _S380 : vec3<f32> = vec3<f32>(_S366);
    var _S381 : vec3<f32> = cross(_S364, _S365) * _S380;
    var _S382 : vec3<f32> = cross(_S365, _S362) * _S380;
    var _S383 : vec2<f32> = vec2<f32>(_S358.u_0 - _S357.u_0, _S358.v_0 - _S357.v_0);
    var _S384 : vec2<f32> = vec2<f32>(_S359.u_0 - _S357.u_0, _S359.v_0 - _S357.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S353, _S354, dot(_S377, _S381), dot(_S377, _S382));
    point_3.position_0 = _S361 + _S377;
    point_3.view_1 = (vec3<f32>(0) - normalize(_S371));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S378, _S381)) * _S383 + vec2<f32>(dot(_S378, _S382)) * _S384) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S379, _S381)) * _S383 + vec2<f32>(dot(_S379, _S382)) * _S384) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S385 : u32,  _S386 : VisiblePoint_0) -> vec3<f32>
{
    var _S387 : u32 = fabrics_0[_S385].albedo_map_levels_0;
    if((fabrics_0[_S385].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S388 : vec2<f32> = vec2<f32>(fabrics_0[_S385].uv_width_0, fabrics_0[_S385].uv_height_0);
    var _S389 : vec2<f32> = _S386.draft_dx_0 / _S388;
    var _S390 : vec2<f32> = _S386.draft_dy_0 / _S388;
    var _S391 : u32 = _S387 - u32(1);
    var _S392 : u32 = (u32(1) << (_S391));
    var _S393 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S389.x * _S390.y - _S389.y * _S390.x), 9.99999968265522539e-21f) * (square_1(f32(_S392)) / 3.0f)), 0.0f, f32(_S387) - 1.0f);
    var _S394 : u32 = min(u32(_S393), max(_S387, u32(2)) - u32(2));
    var _S395 : u32 = min(_S394 + u32(1), _S391);
    var _S396 : u32 = (u32(1) << ((u32(2) * _S387)));
    return mix(map_level_0(fabrics_0[_S385].albedo_map_0 + (_S396 - ((_S396 >> ((u32(2) * _S394))))) / u32(3), (_S392 >> (_S394)), _S386.uv_1), map_level_0(fabrics_0[_S385].albedo_map_0 + (_S396 - ((_S396 >> ((u32(2) * _S395))))) / u32(3), (_S392 >> (_S395)), _S386.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S393 - f32(_S394))) - 1.0f) / 3.0f)));
}

fn light_sample_count_0( _S397 : i32) -> u32
{
    return frames_0[_S397].lights_0 + frames_0[_S397].environment_samples_0;
}

fn visibility_at_0( _S398 : i32,  _S399 : u32,  _S400 : vec2<u32>) -> f32
{
    if((frames_0[_S398].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S399 * frames_0[_S398].height_0 + _S400.y) * frames_0[_S398].width_0 + _S400.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S401 : i32,  _S402 : u32,  _S403 : u32) -> vec3<f32>
{
    var _S404 : u32 = frames_0[_S401].environment_table_0 + frames_0[_S401].environment_rows_0 + u32(1) + frames_0[_S401].environment_rows_0 * (frames_0[_S401].environment_columns_0 + u32(1)) + u32(3) * (_S402 * frames_0[_S401].environment_columns_0 + _S403);
    return vec3<f32>(scene_number_0(_S404), scene_number_0(_S404 + u32(1)), scene_number_0(_S404 + u32(2)));
}

fn sample_environment_0( _S405 : i32,  _S406 : vec2<f32>,  _S407 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S408 : u32 = frames_0[_S405].environment_rows_0;
    var _S409 : Choice_0 = choose_0(frames_0[_S405].environment_table_0, frames_0[_S405].environment_rows_0, _S406.y);
    var _S410 : u32 = frames_0[_S405].environment_columns_0;
    var _S411 : Choice_0 = choose_0(frames_0[_S405].environment_table_0 + frames_0[_S405].environment_rows_0 + u32(1) + _S409.index_3 * (frames_0[_S405].environment_columns_0 + u32(1)), frames_0[_S405].environment_columns_0, _S406.x);
    var _S412 : vec3<f32> = environment_texel_0(_S405, _S409.index_3, _S411.index_3);
    (*_S407) = _S412 * vec3<f32>((frames_0[_S405].environment_total_0 / max(mean_0(_S412), 9.99999968265522539e-21f)));
    var _S413 : f32 = 3.14159274101257324f / f32(_S408);
    var _S414 : f32 = mix(sine_cosine_0(f32(_S409.index_3) * _S413).y, sine_cosine_0(f32(_S409.index_3 + u32(1)) * _S413).y, _S409.remainder_0);
    var _S415 : f32 = sqrt(max(1.0f - _S414 * _S414, 0.0f));
    var _S416 : vec2<f32> = sine_cosine_0((f32(_S411.index_3) + _S411.remainder_0) * (6.28318548202514648f / f32(_S410)));
    var _S417 : f32 = _S415 * _S416.x;
    var _S418 : f32 = - _S415 * _S416.y;
    return vec3<f32>(frames_0[_S405].environment_cosine_0 * _S417 + frames_0[_S405].environment_sine_0 * _S418, _S414, frames_0[_S405].environment_cosine_0 * _S418 - frames_0[_S405].environment_sine_0 * _S417);
}

fn light_sample_0( _S419 : i32,  _S420 : u32,  _S421 : vec2<u32>,  _S422 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S423 : u32 = frames_0[_S419].lights_0;
    if(_S420 >= (frames_0[_S419].lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S424 : vec3<f32> = sample_environment_0(_S419, pixel_sequence_0(_S421, frames_0[_S419].pass_number_0 * frames_0[_S419].environment_samples_0 + (_S420 - _S423), u32(3)), &(weight_6));
        sample_0.towards_0 = _S424;
        sample_0.irradiance_1 = weight_6 / vec3<f32>(f32(frames_0[_S419].environment_samples_0));
        return sample_0;
    }
    var _S425 : Light_std430_0 = lights_1[_S420];
    sample_0.irradiance_1 = vec3<f32>(_S425.red_0, _S425.green_0, _S425.blue_0);
    sample_0.towards_0 = vec3<f32>(_S425.x_1, _S425.y_1, _S425.z_1);
    if((_S425.is_point_0) != u32(0))
    {
        var _S426 : vec3<f32> = sample_0.towards_0 - _S422;
        var _S427 : f32 = max(square_0(_S426), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S427);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S427);
        sample_0.towards_0 = normalize(_S426);
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

fn regime_of_0( _S428 : u32,  _S429 : Footprint_0,  _S430 : f32) -> Regime_0
{
    var _S431 : f32 = Footprint_spread_side_0(_S429);
    var _S432 : f32 = clamp((binary_logarithm_0(max(_S431, 9.99999971718068537e-10f)) - fabrics_0[_S428].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S433 : f32 = _S432 * _S432 * (3.0f - 2.0f * _S432);
    regime_0.prefiltered_0 = _S433;
    regime_0.threads_1 = _S431 * fabrics_0[_S428].lobes_0.threads_per_mm_0;
    var _S434 : f32 = mix(max(8.0f / _S430, 1.0f), 1.0f, _S433);
    var _S435 : f32;
    if(_S433 < 1.0f)
    {
        _S435 = clamp(regime_0.threads_1 * 12.0f, 1.0f, _S434);
    }
    else
    {
        _S435 = 0.0f;
    }
    regime_0.points_0 = _S435;
    return regime_0;
}

fn varies_at_0( _S436 : u32,  _S437 : f32) -> bool
{
    var _S438 : bool;
    if((fabrics_0[_S436].fibre_noise_0) > 0.0f)
    {
        _S438 = true;
    }
    else
    {
        _S438 = (fabrics_0[_S436].colour_noise_0) > 0.0f;
    }
    if(_S438)
    {
        _S438 = true;
    }
    else
    {
        if((fabrics_0[_S436].has_detail_0) != u32(0))
        {
            _S438 = _S437 >= 0.0f;
        }
        else
        {
            _S438 = false;
        }
    }
    return _S438;
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

fn crossing_at_0( _S439 : u32,  _S440 : f32,  _S441 : f32,  _S442 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S439].warp_0, _S440);
    crossing_3.weft_2 = locate_0(fabrics_0[_S439].weft_0, _S441);
    var _S443 : u32 = fabrics_0[_S439].run_words_0 + u32(2) * (crossing_3.weft_2.thread_2 * fabrics_0[_S439].ends_1 + crossing_3.warp_2.thread_2);
    var _S444 : u32 = words_0[_S443];
    crossing_3.warp_word_0 = _S444;
    crossing_3.weft_word_0 = words_0[_S443 + u32(1)];
    crossing_3.warp_above_0 = (((_S444 & (u32(1)))) == u32(1)) != _S442;
    return crossing_3;
}

fn sample_at_0( _S445 : u32,  _S446 : f32,  _S447 : f32,  _S448 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S449 : Crossing_0 = crossing_at_0(_S445, _S446, _S447, _S448);
    sample_1.crossing_2 = _S449;
    var _S450 : Shown_0 = shown_at_0(_S449, _S448);
    sample_1.shown_3 = _S450;
    var _S451 : u32;
    if(_S450.is_warp_2)
    {
        _S451 = fabrics_0[_S445].warp_0;
    }
    else
    {
        _S451 = fabrics_0[_S445].weft_0;
    }
    var _S452 : u32;
    if(_S450.is_warp_2)
    {
        _S452 = fabrics_0[_S445].weft_0;
    }
    else
    {
        _S452 = fabrics_0[_S445].warp_0;
    }
    var _S453 : Cell_0 = select_cell_0(_S450.is_warp_2, sample_1.crossing_2.warp_2, sample_1.crossing_2.weft_2);
    var _S454 : Cell_0 = select_cell_0(_S450.is_warp_2, sample_1.crossing_2.weft_2, sample_1.crossing_2.warp_2);
    var _S455 : Run_0 = unpack_0(_S451, _S452, _S453.thread_2, _S454, _S450.word_0);
    var _S456 : Section_0 = section_at_0(_S453);
    var _S457 : bool;
    if(_S450.on_top_0)
    {
        _S457 = (_S455.distance_0) < (_S456.drop_0 * _S455.bend_1.sine_0);
    }
    else
    {
        _S457 = false;
    }
    var _S458 : bool;
    if(_S450.on_top_0)
    {
        _S458 = !_S457;
    }
    else
    {
        _S458 = false;
    }
    var _S459 : f32;
    if(_S458)
    {
        _S459 = 1.0f;
    }
    else
    {
        _S459 = -1.0f;
    }
    var _S460 : f32;
    if(_S457)
    {
        _S460 = _S455.other_reach_0;
    }
    else
    {
        _S460 = _S455.reach_0;
    }
    var _S461 : f32;
    if(_S457)
    {
        _S461 = _S460 + _S455.distance_0;
    }
    else
    {
        _S461 = max(_S460 - _S455.distance_0, 0.0f);
    }
    var _S462 : f32 = _S460 / _S455.bend_1.sine_0 - _S459 * _S456.drop_0;
    var _S463 : f32 = _S461 * _S461;
    var _S464 : f32 = max(_S462 * _S462 - _S463, 9.99999968265522539e-21f);
    var _S465 : f32 = rsqrt_0(_S464);
    var _S466 : f32 = _S463 / (_S464 * _S465 + _S462);
    var _S467 : bool = _S461 > 0.0f;
    var _S468 : f32;
    if(_S450.on_top_0)
    {
        _S468 = 1.0f;
    }
    else
    {
        _S468 = -1.0f;
    }
    var _S469 : f32;
    if(_S455.near_start_0)
    {
        _S469 = 1.0f;
    }
    else
    {
        _S469 = -1.0f;
    }
    var _S470 : f32 = _S468 * _S469;
    if(_S467)
    {
        _S468 = _S462 * _S465;
    }
    else
    {
        _S468 = 1.0f;
    }
    sample_1.slope_across_0 = _S456.slope_0 * _S468;
    if(_S467)
    {
        _S461 = _S470 * _S461 * _S465;
    }
    else
    {
        _S461 = 0.0f;
    }
    sample_1.slope_along_0 = _S461;
    var _S471 : f32 = families_0[_S451].height_scale_0;
    var _S472 : vec2<f32> = dive_0(_S452, _S450, _S455, _S454);
    if(_S455.straight_0)
    {
        _S459 = 0.0f;
    }
    else
    {
        _S459 = _S471 * _S459;
    }
    sample_1.height_7 = _S459 * (_S460 * _S455.bend_1.half_tangent_0 - _S466) - _S471 * _S456.drop_0 - _S472.x;
    var _S473 : f32 = _S471 * sample_1.slope_across_0;
    var _S474 : f32 = _S471 * sample_1.slope_along_0 - _S472.y;
    if(_S450.is_warp_2)
    {
        _S459 = _S473;
    }
    else
    {
        _S459 = _S474;
    }
    sample_1.slope_x_1 = _S459;
    if(_S450.is_warp_2)
    {
        _S459 = _S474;
    }
    else
    {
        _S459 = _S473;
    }
    sample_1.slope_y_1 = _S459;
    sample_1.run_3 = _S455;
    sample_1.section_1 = _S456;
    return sample_1;
}

fn steps_per_length_0( _S475 : u32,  _S476 : SearchQuality_0,  _S477 : vec3<f32>) -> f32
{
    return max(max(abs(_S477.x) * fabrics_0[_S475].threads_per_x_0, abs(_S477.y) * fabrics_0[_S475].threads_per_y_0) * _S476.steps_per_thread_0, abs(_S477.z) * fabrics_0[_S475].per_relief_0 * _S476.steps_per_relief_0);
}

fn cell_maximum_0( _S478 : u32,  _S479 : Crossing_0) -> f32
{
    var _S480 : u32;
    if(_S479.warp_above_0)
    {
        _S480 = fabrics_0[_S478].warp_0;
    }
    else
    {
        _S480 = fabrics_0[_S478].weft_0;
    }
    var _S481 : u32;
    if(_S479.warp_above_0)
    {
        _S481 = _S479.warp_word_0;
    }
    else
    {
        _S481 = _S479.weft_word_0;
    }
    return f32((_S481 >> (u32(28)))) * families_0[_S480].height_scale_0 * families_0[_S480].level_0;
}

fn probe_0( _S482 : u32,  _S483 : f32,  _S484 : f32,  _S485 : bool,  _S486 : bool,  _S487 : bool) -> Probe_0
{
    var _S488 : Sample_0 = sample_at_0(_S482, _S483, _S484, _S485);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S488.height_7;
    probe_1.hole_4 = _S488.shown_3.hole_3;
    probe_1.slope_x_0 = _S488.slope_x_1;
    probe_1.slope_y_0 = _S488.slope_y_1;
    var _S489 : u32;
    if(_S488.shown_3.is_warp_2)
    {
        _S489 = _S488.crossing_2.warp_2.thread_2 * u32(2) + u32(1);
    }
    else
    {
        _S489 = _S488.crossing_2.weft_2.thread_2 * u32(2);
    }
    probe_1.yarn_1 = _S489;
    probe_1.cell_max_0 = cell_maximum_0(_S482, _S488.crossing_2);
    var _S490 : f32;
    if(_S486)
    {
        _S490 = _S488.crossing_2.warp_2.above_0;
    }
    else
    {
        _S490 = _S488.crossing_2.warp_2.below_0;
    }
    probe_1.side_x_0 = _S490;
    if(_S487)
    {
        _S490 = _S488.crossing_2.weft_2.above_0;
    }
    else
    {
        _S490 = _S488.crossing_2.weft_2.below_0;
    }
    probe_1.side_y_0 = _S490;
    probe_1.edge_x_0 = outline_distance_0(_S488.crossing_2.warp_2, _S488.shown_3, _S488.run_3, !_S488.shown_3.is_warp_2, _S486);
    probe_1.edge_y_0 = outline_distance_0(_S488.crossing_2.weft_2, _S488.shown_3, _S488.run_3, _S488.shown_3.is_warp_2, _S487);
    return probe_1;
}

fn is_free_0( _S491 : u32,  _S492 : SearchQuality_0,  _S493 : vec3<f32>,  _S494 : vec3<f32>,  _S495 : bool,  _S496 : f32) -> bool
{
    var _S497 : f32 = _S494.z;
    if(_S497 <= 0.0f)
    {
        return false;
    }
    var _S498 : f32 = 1.0f / max(_S492.shadow_share_0 * steps_per_length_0(_S491, _S492, _S494), 9.99999971718068537e-10f);
    var _S499 : StepControl_0 = step_control_0(_S494.xy, _S498);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S500 : bool;
        if(count_4 < u32(1024))
        {
            _S500 = (_S493.z + _S497 * distance_2) < _S496;
        }
        else
        {
            _S500 = false;
        }
        if(_S500)
        {
        }
        else
        {
            break;
        }
        var _S501 : vec3<f32> = _S493 + _S494 * vec3<f32>(distance_2);
        var _S502 : Probe_0 = probe_0(_S491, _S501.x, _S501.y, _S495, _S499.right_0, _S499.up_0);
        var _S503 : f32 = _S501.z;
        var _S504 : f32 = _S503 - _S502.height_4;
        var _S505 : f32 = _S497 - _S502.slope_x_0 * _S494.x - _S502.slope_y_0 * _S494.y;
        var _S506 : bool;
        if(!_S502.hole_4)
        {
            _S506 = _S504 < 0.0f;
        }
        else
        {
            _S506 = false;
        }
        if(_S506)
        {
            return false;
        }
        var _S507 : f32 = way_back_to_dip_0(previous_3, _S504, _S505, last_step_0, _S502);
        if(_S507 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S507;
            distance_2 = distance_2 - _S507;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S508 : bool = _S503 > (_S502.cell_max_0);
        var _S509 : PreviousSample_0 = after_sample_0(_S504, _S505, _S502, _S508);
        var last_step_2 : f32;
        if(_S508)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S499, _S502.side_x_0, _S502.side_y_0), _S498);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S499, _S502, _S504, _S505);
        }
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = _S509;
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S510 : u32,  _S511 : SearchQuality_0,  _S512 : f32,  _S513 : f32,  _S514 : vec3<f32>,  _S515 : bool) -> bool
{
    if(!sample_at_0(_S510, _S512, _S513, _S515).shown_3.hole_3)
    {
        return false;
    }
    var _S516 : vec3<f32> = vec3<f32>(_S512, _S513, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S517 : bool;
        if(side_1 < u32(2))
        {
            _S517 = passes_0;
        }
        else
        {
            _S517 = false;
        }
        if(_S517)
        {
        }
        else
        {
            break;
        }
        var _S518 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S518 = _S514;
        }
        else
        {
            _S518 = vec3<f32>(- _S514.x, - _S514.y, _S514.z);
        }
        var _S519 : bool = is_free_0(_S510, _S511, _S516, _S518, _S515 != (side_1 == u32(1)), fabrics_0[_S510].height_high_0);
        var _S520 : u32 = side_1 + u32(1);
        passes_0 = _S519;
        side_1 = _S520;
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

fn max_height_along_0( _S521 : u32,  _S522 : f32,  _S523 : f32,  _S524 : f32,  _S525 : vec3<f32>,  _S526 : bool) -> f32
{
    var _S527 : u32 = locate_0(fabrics_0[_S521].warp_0, _S522).thread_2 / u32(2);
    var _S528 : u32 = locate_0(fabrics_0[_S521].weft_0, _S523).thread_2 / u32(2);
    var _S529 : f32 = _S525.x;
    var _S530 : u32;
    if(_S529 > 0.0f)
    {
        _S530 = u32(1);
    }
    else
    {
        _S530 = u32(0);
    }
    var _S531 : f32 = _S525.y;
    var _S532 : u32;
    if(_S531 > 0.0f)
    {
        _S532 = u32(2);
    }
    else
    {
        _S532 = u32(0);
    }
    var _S533 : u32 = words_0[fabrics_0[_S521].max_heights_0 + u32(4) * (_S528 * fabrics_0[_S521].max_height_columns_0 + _S527) + (_S530 + _S532)];
    var number_1 : i32;
    if(_S526)
    {
        number_1 = i32(4);
    }
    else
    {
        number_1 = i32(0);
    }
    var _S534 : u32 = (_S533 >> (u32(number_1)));
    var _S535 : f32 = max(abs(_S529) * fabrics_0[_S521].threads_per_x_0, abs(_S531) * fabrics_0[_S521].threads_per_y_0) / _S525.z;
    var _S536 : f32 = fabrics_0[_S521].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S521].height_high_0;
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
        if(((max_height_0 - _S524) * _S535) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S534 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S536);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S537 : u32,  _S538 : f32,  _S539 : f32,  _S540 : bool,  _S541 : bool,  _S542 : bool) -> vec3<f32>
{
    var _S543 : Crossing_0 = crossing_at_0(_S537, _S538, _S539, _S540);
    var _S544 : f32 = cell_maximum_0(_S537, _S543);
    var _S545 : f32;
    if(_S541)
    {
        _S545 = _S543.warp_2.above_0;
    }
    else
    {
        _S545 = _S543.warp_2.below_0;
    }
    var _S546 : f32;
    if(_S542)
    {
        _S546 = _S543.weft_2.above_0;
    }
    else
    {
        _S546 = _S543.weft_2.below_0;
    }
    return vec3<f32>(_S544, _S545, _S546);
}

fn first_sample_height_0( _S547 : u32,  _S548 : ViewRay_0,  _S549 : StepControl_0,  _S550 : bool) -> f32
{
    var _S551 : f32 = max_height_along_0(_S547, _S548.origin_0.x, _S548.origin_0.y, 0.0f, vec3<f32>(_S548.slope_1, 1.0f), _S550);
    var count_5 : u32 = u32(0);
    var height_9 : f32 = _S551;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S552 : vec2<f32> = ViewRay_at_0(_S548, height_9);
        var _S553 : vec3<f32> = cell_bounds_0(_S547, _S552.x, _S552.y, _S550, _S549.right_0, _S549.up_0);
        var _S554 : f32 = height_9 - _S553.x;
        var _S555 : f32 = StepControl_to_cell_exit_0(_S549, _S553.y, _S553.z);
        var height_10 : f32 = height_9 - clamp(_S554, 0.0f, _S555);
        if(_S554 <= _S555)
        {
            height_9 = height_10;
            break;
        }
        count_5 = count_5 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S556 : u32,  _S557 : ViewRay_0,  _S558 : StepControl_0,  _S559 : bool) -> ViewRayEnd_0
{
    var _S560 : f32 = fabrics_0[_S556].height_low_0 - (fabrics_0[_S556].height_high_0 - fabrics_0[_S556].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S556, _S557, _S558, _S559);
    end_1.last_step_3 = _S558.epsilon_0;
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
        var _S561 : vec2<f32> = ViewRay_at_0(_S557, end_1.height_8);
        var _S562 : Probe_0 = probe_0(_S556, _S561.x, _S561.y, _S559, _S558.right_0, _S558.up_0);
        var _S563 : f32 = end_1.height_8 - _S562.height_4;
        var _S564 : f32 = ViewRay_rate_0(_S557, _S562);
        end_1.depth_1 = - _S563;
        end_1.rate_4 = _S564;
        var _S565 : bool;
        if(end_1.previous_4.known_0)
        {
            _S565 = !_S562.hole_4;
        }
        else
        {
            _S565 = false;
        }
        var _S566 : bool;
        if(_S565)
        {
            _S566 = (end_1.previous_4.yarn_0) == (_S562.yarn_1);
        }
        else
        {
            _S566 = false;
        }
        end_1.smooth_0 = _S566;
        var _S567 : bool;
        if(!_S562.hole_4)
        {
            _S567 = _S563 <= 0.0f;
        }
        else
        {
            _S567 = false;
        }
        var _S568 : bool;
        if(_S567)
        {
            _S568 = true;
        }
        else
        {
            _S568 = (end_1.height_8) <= _S560;
        }
        if(_S568)
        {
            break;
        }
        var _S569 : f32 = way_back_to_dip_0(end_1.previous_4, _S563, _S564, end_1.last_step_3, _S562);
        if(_S569 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S569;
            end_1.last_step_3 = end_1.last_step_3 - _S569;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S570 : f32 = min(StepControl_to_cell_exit_0(_S558, _S562.side_x_0, _S562.side_y_0), end_1.height_8 - _S562.cell_max_0);
        var _S571 : f32 = StepControl_to_next_sample_0(_S558, _S562, _S563, _S564);
        end_1.previous_4 = after_sample_0(_S563, _S564, _S562, _S570 > _S571);
        var _S572 : f32 = max(_S570, _S571);
        end_1.last_step_3 = _S572;
        end_1.height_8 = end_1.height_8 - _S572;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S573 : u32,  _S574 : ViewRay_0,  _S575 : StepControl_0,  _S576 : bool,  _S577 : ViewRayEnd_0,  _S578 : u32) -> f32
{
    var _S579 : f32 = fabrics_0[_S573].height_high_0 - fabrics_0[_S573].height_low_0;
    var above_2 : f32 = _S577.height_8 + _S577.last_step_3;
    var above_gap_1 : f32 = clamp(_S577.previous_4.clearance_0, 0.0f, _S579);
    var under_gap_1 : f32 = clamp(_S577.depth_1, 0.0f, _S579);
    var _S580 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S577.previous_4.rate_0 * _S577.last_step_3, _S577.rate_4 * _S577.last_step_3);
    var middle_0 : f32;
    if(_S577.smooth_0)
    {
        middle_0 = above_2 - _S580 * _S577.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S577.height_8, above_gap_1, under_gap_1);
    }
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S577.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S578)
        {
        }
        else
        {
            break;
        }
        var _S581 : vec2<f32> = ViewRay_at_0(_S574, middle_0);
        var _S582 : Probe_0 = probe_0(_S573, _S581.x, _S581.y, _S576, _S575.right_0, _S575.up_0);
        var _S583 : f32;
        if(_S582.hole_4)
        {
            _S583 = -1.0e+09f;
        }
        else
        {
            _S583 = _S582.height_4;
        }
        var _S584 : f32 = clamp(middle_0 - _S583, - _S579, _S579);
        var _S585 : f32;
        if(_S584 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S585 = 0.5f * above_gap_2;
            }
            else
            {
                _S585 = above_gap_2;
            }
            var _S586 : f32 = - _S584;
            under_1 = middle_0;
            above_gap_2 = _S585;
            under_gap_2 = _S586;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S585 = 0.5f * under_gap_2;
            }
            else
            {
                _S585 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S584;
            under_gap_2 = _S585;
            side_2 = -1.0f;
        }
        if(_S577.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S584 / min(ViewRay_rate_0(_S574, _S582), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S577.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S587 : u32,  _S588 : SearchQuality_0,  _S589 : f32,  _S590 : f32,  _S591 : vec3<f32>,  _S592 : bool) -> Hit_0
{
    var _S593 : f32 = max(_S591.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S589, _S590);
    var _S594 : vec2<f32> = _S591.xy / vec2<f32>(_S593);
    ray_0.slope_1 = _S594;
    var _S595 : StepControl_0 = step_control_0((vec2<f32>(0) - _S594), 1.0f / max(steps_per_length_0(_S587, _S588, _S591) / _S593, 9.99999971718068537e-10f));
    var _S596 : ViewRayEnd_0 = search_down_0(_S587, ray_0, _S595, _S592);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S597 : f32 = refined_height_0(_S587, ray_0, _S595, _S592, _S596, _S588.refinements_0);
    hit_0.height_6 = _S597;
    var _S598 : vec2<f32> = ViewRay_at_0(ray_0, _S597);
    hit_0.x_14 = _S598.x;
    hit_0.y_7 = _S598.y;
    return hit_0;
}

fn first_hit_0( _S599 : u32,  _S600 : SearchQuality_0,  _S601 : f32,  _S602 : f32,  _S603 : vec3<f32>,  _S604 : bool) -> Hit_0
{
    if(!passes_through_0(_S599, _S600, _S601, _S602, _S603, _S604))
    {
        return first_hit_of_yarn_0(_S599, _S600, _S601, _S602, _S603, _S604);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S601;
    hit_1.y_7 = _S602;
    hit_1.height_6 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S605 : u32,  _S606 : f32,  _S607 : f32,  _S608 : bool) -> SurfacePoint_0
{
    var _S609 : Sample_0 = sample_at_0(_S605, _S606, _S607, _S608);
    var _S610 : f32;
    if(_S609.shown_3.is_warp_2)
    {
        _S610 = _S609.crossing_2.warp_2.half_width_1;
    }
    else
    {
        _S610 = _S609.crossing_2.weft_2.half_width_1;
    }
    var _S611 : u32;
    if(_S609.shown_3.is_warp_2)
    {
        _S611 = fabrics_0[_S605].warp_0;
    }
    else
    {
        _S611 = fabrics_0[_S605].weft_0;
    }
    var _S612 : f32 = families_0[_S611].twist_sine_0;
    var _S613 : f32;
    if(_S608)
    {
        _S613 = -1.0f;
    }
    else
    {
        _S613 = 1.0f;
    }
    var _S614 : f32 = _S612 * _S613;
    var _S615 : f32 = families_0[_S611].twist_cosine_0;
    if(_S609.shown_3.is_warp_2)
    {
        _S613 = 1.0f;
    }
    else
    {
        _S613 = -1.0f;
    }
    var _S616 : vec2<f32> = fibre_direction_0(_S609.slope_across_0, _S613 * _S609.slope_along_0, _S614, _S615);
    var _S617 : f32;
    if(_S609.shown_3.is_warp_2)
    {
        _S617 = _S609.slope_x_1;
    }
    else
    {
        _S617 = _S609.slope_y_1;
    }
    var _S618 : f32;
    if(_S609.shown_3.is_warp_2)
    {
        _S618 = _S609.slope_y_1;
    }
    else
    {
        _S618 = _S609.slope_x_1;
    }
    var _S619 : f32 = _S616.x;
    var _S620 : f32 = _S616.y;
    var _S621 : f32 = _S617 * _S619 + _S613 * _S618 * _S620;
    var _S622 : f32 = _S610 * 1.0154266357421875f;
    var _S623 : f32 = _S622 * arc_sine_0(clamp(_S609.section_1.across_3 / _S622, -1.0f, 1.0f));
    if(_S609.shown_3.is_warp_2)
    {
        _S610 = _S607;
    }
    else
    {
        _S610 = - _S606;
    }
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S609.shown_3.hole_3;
    point_4.is_warp_0 = _S609.shown_3.is_warp_2;
    point_4.warp_thread_0 = _S609.crossing_2.warp_2.thread_2;
    point_4.weft_thread_0 = _S609.crossing_2.weft_2.thread_2;
    point_4.height_2 = _S609.height_7;
    point_4.normal_1 = normalize(vec3<f32>(- _S609.slope_x_1, - _S609.slope_y_1, 1.0f));
    var _S624 : vec3<f32>;
    if(_S609.shown_3.is_warp_2)
    {
        _S624 = vec3<f32>(_S619, _S620, _S621);
    }
    else
    {
        _S624 = vec3<f32>(- _S620, _S619, _S621);
    }
    point_4.tangent_0 = normalize(_S624);
    point_4.across_0 = _S609.section_1.across_3;
    point_4.fibre_across_0 = _S623 * _S615 + _S610 * _S614;
    point_4.fibre_along_0 = _S610 * _S615 - _S623 * _S614;
    return point_4;
}

struct YarnPoint_0
{
     back_7 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_15 : f32,
     y_8 : f32,
     height_11 : f32,
     normal_10 : vec3<f32>,
     tangent_10 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
};

fn has_hairs_0( _S625 : u32) -> bool
{
    var _S626 : bool;
    if((families_0[fabrics_0[_S625].warp_0].hairiness_0) > 0.0f)
    {
        _S626 = true;
    }
    else
    {
        _S626 = (families_0[fabrics_0[_S625].weft_0].hairiness_0) > 0.0f;
    }
    return _S626;
}

fn hair_at_0( _S627 : u32,  _S628 : vec2<f32>,  _S629 : bool,  _S630 : f32) -> Hair_0
{
    var _S631 : f32 = fabrics_0[_S627].fibre_size_0;
    var _S632 : f32 = 17.0f * fabrics_0[_S627].fibre_size_0;
    var _S633 : f32 = fade_0(_S630, _S632);
    var _S634 : vec2<f32> = _S628 / vec2<f32>(_S632);
    var number_2 : u32;
    if(_S629)
    {
        number_2 = u32(1);
    }
    else
    {
        number_2 = u32(0);
    }
    var _S635 : u32 = hash_key_0(number_2, ((fabrics_0[_S627].seed_0) ^ (u32(1013904242))));
    var _S636 : f32 = 1.0f / max(_S630, 0.07999999821186066f * _S631);
    var _S637 : f32 = min(0.63999998569488525f * _S631 * _S636, 1.0f);
    const _S638 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S638;
    number_2 = u32(0);
    for(;;)
    {
        var _S639 : bool;
        if(_S633 > 0.0f)
        {
            _S639 = number_2 < u32(18);
        }
        else
        {
            _S639 = false;
        }
        if(_S639)
        {
        }
        else
        {
            break;
        }
        var _S640 : u32 = number_2 / u32(9);
        var _S641 : u32 = number_2 / u32(3) - u32(3) * _S640;
        var _S642 : vec2<f32> = floor(_S634) + vec2<f32>(f32(number_2 - u32(3) * _S641 - u32(9) * _S640), f32(_S641)) - vec2<f32>(1.0f);
        var _S643 : u32 = hash_bits_0(_S635 + _S640, u32(i32(_S642.x)) * u32(65536) + u32(i32(_S642.y)));
        var _S644 : u32 = hash_bits_0(_S635, _S643);
        var _S645 : vec2<f32> = _S634 - _S642 - vec2<f32>(share_of_0(_S643), share_of_0((_S643 >> (u32(10)))));
        var _S646 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S643 >> (u32(20)))));
        var _S647 : f32 = mix(5.0f, 16.0f, share_of_0((_S644 >> (u32(10))))) / 17.0f;
        var _S648 : f32 = _S645.x;
        var _S649 : f32 = _S646.y;
        var _S650 : f32 = _S645.y;
        var _S651 : f32 = _S646.x;
        var _S652 : f32 = (_S648 * _S649 + _S650 * _S651) / _S647;
        var _S653 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S644 >> (u32(20)))) - 1.0f);
        var _S654 : f32 = 2.0f * _S653 * _S652;
        var _S655 : f32 = rsqrt_0(_S654 * _S654 + 1.0f);
        var _S656 : f32 = (_S650 * _S649 - _S648 * _S651 - _S653 * _S647 * _S652 * _S652) * _S655 * 17.0f;
        var _S657 : f32 = clamp((0.31999999284744263f - abs(_S656)) * _S631 * _S636 + 0.5f, 0.0f, _S637);
        var _S658 : u32;
        if(((((_S644 >> (u32(30)))) & (u32(1)))) == u32(1))
        {
            _S658 = fabrics_0[_S627].warp_0;
        }
        else
        {
            _S658 = fabrics_0[_S627].weft_0;
        }
        var _S659 : bool;
        if((share_of_0(_S644)) < (families_0[_S658].hairiness_0))
        {
            _S659 = (abs(_S652)) < 1.0f;
        }
        else
        {
            _S659 = false;
        }
        var _S660 : bool;
        if(_S659)
        {
            _S660 = _S657 > cover_2;
        }
        else
        {
            _S660 = false;
        }
        if(_S660)
        {
            var _S661 : vec2<f32> = vec2<f32>(- _S651 - _S654 * _S649, _S649 - _S654 * _S651) * vec2<f32>(_S655);
            cover_2 = _S657;
            hair_away_0 = _S656;
            hair_across_0 = _S661;
        }
        number_2 = number_2 + u32(1);
    }
    var _S662 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S633 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S662) * hair_across_0, sqrt(1.0f - _S662 * _S662));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn thread_number_0( _S663 : u32,  _S664 : SurfacePoint_0,  _S665 : f32,  _S666 : f32) -> u32
{
    var _S667 : f32;
    if(_S664.is_warp_0)
    {
        _S667 = _S665;
    }
    else
    {
        _S667 = _S666;
    }
    var _S668 : f32 = _S667 - _S664.across_0;
    var _S669 : u32;
    if(_S664.is_warp_0)
    {
        _S669 = fabrics_0[_S663].warp_0;
    }
    else
    {
        _S669 = fabrics_0[_S663].weft_0;
    }
    var _S670 : f32 = families_0[_S669].period_0;
    var _S671 : i32 = i32(families_0[_S669].count_0);
    if(_S664.is_warp_0)
    {
        _S669 = _S664.warp_thread_0;
    }
    else
    {
        _S669 = _S664.weft_thread_0;
    }
    var _S672 : u32 = u32(i32(floor(_S668 / _S670)) * _S671 + i32(_S669)) * u32(2);
    if(_S664.is_warp_0)
    {
        _S669 = u32(1);
    }
    else
    {
        _S669 = u32(0);
    }
    return _S672 + _S669;
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_2 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S673 : u32,  _S674 : u32,  _S675 : SurfacePoint_0,  _S676 : u32,  _S677 : f32) -> FibreNoise_0
{
    var _S678 : f32 = 5.0f * fabrics_0[_S673].fibre_size_0;
    var _S679 : vec2<f32> = wave_noise_0(hash_key_0(_S676, ((fabrics_0[_S673].seed_0) ^ (u32(458671337)))), _S675.fibre_along_0 / (25.0f * fabrics_0[_S673].fibre_size_0));
    var _S680 : f32 = _S675.fibre_across_0 + families_0[_S674].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S673].fibre_size_0 * _S679.x;
    var _S681 : vec3<f32> = fibre_cell_0(_S680, _S675.fibre_along_0, fabrics_0[_S673].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S676, ((fabrics_0[_S673].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S680, _S675.fibre_along_0, _S678));
    noise_0.bundle_weight_0 = fade_0(_S677, _S678);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S676, ((fabrics_0[_S673].seed_0) ^ (u32(48610963)))), _S681);
    noise_0.fibre_weight_0 = fade_0(_S677, fabrics_0[_S673].fibre_size_0);
    noise_0.offset_2 = _S681.z;
    noise_0.slope_2 = 0.5f * _S679.y;
    return noise_0;
}

fn detail_gain_0( _S682 : u32,  _S683 : u32,  _S684 : SurfacePoint_0,  _S685 : vec2<f32>,  _S686 : bool,  _S687 : u32,  _S688 : f32) -> vec2<f32>
{
    var _S689 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S683].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S688, 1.0f / families_0[_S683].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S683, _S684, _S686))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S689;
    }
    if((families_0[_S683].fibre_tone_0) > 0.0f)
    {
        var _S690 : FibreNoise_0 = fibre_noise_at_0(_S682, _S683, _S684, _S687, _S688);
        gain_2 = gain_2 + vec2<f32>(families_0[_S683].fibre_tone_0) * vec2<f32>(_S690.bundle_weight_0 * _S690.bundle_0.y + _S690.fibre_weight_0 * _S690.fibre_0.y, _S690.bundle_weight_0 + _S690.fibre_weight_0);
    }
    if((families_0[_S683].slub_0) > 0.0f)
    {
        var _S691 : f32 = 0.25f * families_0[_S683].slub_0 * fade_0(_S688, 1.0f / families_0[_S683].slubs_per_mm_0);
        var _S692 : f32;
        if(_S684.is_warp_0)
        {
            _S692 = _S685.y;
        }
        else
        {
            _S692 = - _S685.x;
        }
        gain_2 = gain_2 + vec2<f32>(_S691) * vec2<f32>(wave_noise_0(hash_key_0(_S687, ((fabrics_0[_S682].seed_0) ^ (u32(1373058189)))), _S692 * families_0[_S683].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S684.across_0 * families_0[_S683].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S693 : u32,  _S694 : Albedos_0,  _S695 : u32,  _S696 : u32,  _S697 : vec2<f32>) -> Albedos_0
{
    var _S698 : vec3<f32> = max(_S694.specular_reflect_0, _S694.specular_transmit_0);
    var _S699 : vec3<f32> = _S694.diffuse_reflect_0 + _S694.diffuse_transmit_0;
    var _S700 : vec3<f32> = vec3<f32>(fabrics_0[_S693].layer_bound_0);
    var _S701 : vec3<f32> = vec3<f32>(1.0f);
    var _S702 : vec3<f32> = _S701 - _S700 * _S698;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S695, fabrics_0[_S693].colour_noise_0, fabrics_0[_S693].seed_0), _S699, _S702);
    var _S703 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S697.y, vec3<f32>(colour_1) * _S699, _S702) * _S697.x)));
    var _S704 : f32 = bounded_gain_0(fibre_gain_0(_S695, _S696, fabrics_0[_S693].fibre_noise_0, fabrics_0[_S693].seed_0), _S698, min((_S701 - _S703 * _S699) / _S700, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S703 * _S694.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S703 * _S694.diffuse_transmit_0;
    var _S705 : vec3<f32> = vec3<f32>(_S704);
    varied_0.specular_reflect_0 = _S705 * _S694.specular_reflect_0;
    varied_0.specular_transmit_0 = _S705 * _S694.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S706 : u32,  _S707 : SurfacePoint_0,  _S708 : Albedos_0,  _S709 : f32,  _S710 : f32,  _S711 : bool,  _S712 : f32,  _S713 : f32) -> Albedos_0
{
    var _S714 : u32 = thread_number_0(_S706, _S707, _S709, _S710);
    var _S715 : vec3<f32> = fibre_cell_0(_S707.fibre_across_0, _S707.fibre_along_0, fabrics_0[_S706].fibre_size_0);
    var _S716 : vec2<f32> = vec2<f32>(0.0f);
    var _S717 : bool;
    if((fabrics_0[_S706].has_detail_0) != u32(0))
    {
        _S717 = _S712 >= 0.0f;
    }
    else
    {
        _S717 = false;
    }
    var gain_3 : vec2<f32>;
    if(_S717)
    {
        var _S718 : u32;
        if(_S707.is_warp_0)
        {
            _S718 = fabrics_0[_S706].warp_0;
        }
        else
        {
            _S718 = fabrics_0[_S706].weft_0;
        }
        gain_3 = detail_gain_0(_S706, _S718, _S707, vec2<f32>(_S709, _S710), _S711, _S714, _S712) * vec2<f32>(1.0f - _S713, 1.0f);
    }
    else
    {
        gain_3 = _S716;
    }
    return vary_albedos_0(_S706, _S708, _S714, u32(i32(_S715.x)) * u32(65536) + u32(i32(floor(_S715.y))), gain_3);
}

fn turned_frame_0( _S719 : u32,  _S720 : u32,  _S721 : SurfacePoint_0,  _S722 : bool,  _S723 : u32,  _S724 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_5 = _S721.normal_1;
    frame_2.tangent_4 = _S721.tangent_0;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S720].has_plies_0) > 0.0f)
    {
        var _S725 : f32 = fade_0(_S724, 1.0f / families_0[_S720].plies_per_mm_0);
        var _S726 : f32 = _S725 * 0.41999998688697815f * ply_offset_0(_S720, _S721, _S722);
        var _S727 : f32 = sqrt(1.0f - _S726 * _S726);
        var _S728 : f32;
        if(_S722)
        {
            _S728 = - families_0[_S720].ply_sine_0;
        }
        else
        {
            _S728 = families_0[_S720].ply_sine_0;
        }
        var _S729 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S730 : vec3<f32> = vec3<f32>(families_0[_S720].ply_cosine_0);
        var _S731 : vec3<f32> = _S730 * _S729 + vec3<f32>(_S728) * frame_2.tangent_4;
        var _S732 : vec3<f32> = vec3<f32>(_S727);
        var _S733 : vec3<f32> = vec3<f32>(_S726);
        frame_2.tangent_4 = _S730 * (_S730 * frame_2.tangent_4 - vec3<f32>(_S728) * _S729) + vec3<f32>(_S728) * (_S732 * _S731 - _S733 * frame_2.normal_5);
        frame_2.normal_5 = _S732 * frame_2.normal_5 + _S733 * _S731;
        frame_2.loss_0 = _S725 * _S725 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S734 : f32 = families_0[_S720].fibre_tilt_0;
    if((families_0[_S720].fibre_tilt_0) > 0.0f)
    {
        var _S735 : FibreNoise_0 = fibre_noise_at_0(_S719, _S720, _S721, _S723, _S724);
        var _S736 : f32 = 1.09858846664428711f * _S734 * (_S735.bundle_weight_0 * _S735.bundle_0.x + _S735.fibre_weight_0 * (_S735.fibre_0.x + _S735.offset_2));
        var _S737 : f32 = _S734 * (1.42099642753601074f * (_S735.bundle_weight_0 * _S735.bundle_0.y + _S735.fibre_weight_0 * _S735.fibre_0.y) - _S735.bundle_weight_0 * _S735.slope_2);
        var _S738 : f32 = square_1(_S735.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S734 * _S734 * ((0.24761904776096344f * (square_1(_S735.bundle_weight_0) + _S738) + _S738 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S739 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S740 : vec2<f32> = sine_cosine_0(_S736);
        var _S741 : vec2<f32> = sine_cosine_0(_S737);
        var _S742 : vec3<f32> = vec3<f32>(_S740.y);
        var _S743 : vec3<f32> = vec3<f32>(_S740.x);
        var _S744 : vec3<f32> = _S742 * _S739 - _S743 * frame_2.normal_5;
        frame_2.normal_5 = _S742 * frame_2.normal_5 + _S743 * _S739;
        frame_2.tangent_4 = vec3<f32>(_S741.y) * frame_2.tangent_4 + vec3<f32>(_S741.x) * _S744;
    }
    return frame_2;
}

fn yarn_point_of_0( _S745 : u32,  _S746 : SurfacePoint_0,  _S747 : f32,  _S748 : f32,  _S749 : bool,  _S750 : bool,  _S751 : f32) -> YarnPoint_0
{
    var _S752 : u32;
    if(_S746.is_warp_0)
    {
        _S752 = fabrics_0[_S745].warp_0;
    }
    else
    {
        _S752 = fabrics_0[_S745].weft_0;
    }
    var _S753 : bool;
    if((fabrics_0[_S745].has_detail_0) != u32(0))
    {
        _S753 = _S751 >= 0.0f;
    }
    else
    {
        _S753 = false;
    }
    var _S754 : vec3<f32> = vec3<f32>(0.0f);
    var _S755 : Hair_0 = Hair_x24init_0(0.0f, _S754, _S754);
    var _S756 : bool;
    if(_S753)
    {
        _S756 = has_hairs_0(_S745);
    }
    else
    {
        _S756 = false;
    }
    var hair_2 : Hair_0;
    if(_S756)
    {
        hair_2 = hair_at_0(_S745, vec2<f32>(_S747, _S748), _S749, _S751);
    }
    else
    {
        hair_2 = _S755;
    }
    var _S757 : u32;
    if(_S746.is_warp_0)
    {
        _S757 = _S746.warp_thread_0;
    }
    else
    {
        _S757 = _S746.weft_thread_0;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S752, _S757);
    var albedos_8 : Albedos_0;
    if(varies_at_0(_S745, _S751))
    {
        albedos_8 = varied_at_0(_S745, _S746, albedos_7, _S747, _S748, _S749, _S751, hair_2.cover_0);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_5 : YarnPoint_0;
    point_5.back_7 = _S749;
    point_5.hole_6 = _S750;
    point_5.is_warp_3 = _S746.is_warp_0;
    point_5.x_15 = _S747;
    point_5.y_8 = _S748;
    point_5.height_11 = _S746.height_2;
    point_5.normal_10 = _S746.normal_1;
    point_5.tangent_10 = _S746.tangent_0;
    point_5.surface_normal_0 = _S746.normal_1;
    point_5.diffuse_gain_1 = 1.0f;
    if(_S753)
    {
        var _S758 : YarnFrame_0 = turned_frame_0(_S745, _S752, _S746, _S749, thread_number_0(_S745, _S746, _S747, _S748), _S751);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S745))
        {
            frame_3 = under_hair_0(_S758, hair_2);
        }
        else
        {
            frame_3 = _S758;
        }
        point_5.normal_10 = frame_3.normal_5;
        point_5.tangent_10 = frame_3.tangent_4;
        point_5.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S745].diffuse_blend_0);
    }
    point_5.roughness_10 = families_0[_S752].roughness_0;
    point_5.albedos_6 = albedos_8;
    return point_5;
}

fn unoccluded_0( _S759 : u32,  _S760 : SearchQuality_0,  _S761 : f32,  _S762 : f32,  _S763 : f32,  _S764 : vec3<f32>,  _S765 : bool) -> bool
{
    if((_S764.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S759, _S760, vec3<f32>(_S761, _S762, _S763 + fabrics_0[_S759].lift_0), _S764, _S765, max_height_along_0(_S759, _S761, _S762, _S763, _S764, _S765));
}

fn is_lit_0( _S766 : u32,  _S767 : SearchQuality_0,  _S768 : YarnPoint_0,  _S769 : vec3<f32>) -> bool
{
    if(_S768.hole_6)
    {
        return true;
    }
    var _S770 : vec3<f32> = to_face_frame_0(_S769, _S768.back_7);
    var _S771 : f32 = _S770.z;
    var _S772 : bool = _S771 < 0.0f;
    var normal_11 : vec3<f32>;
    var height_12 : f32;
    if(_S772)
    {
        var _S773 : SurfacePoint_0 = surface_at_0(_S766, _S768.x_15, _S768.y_8, !_S768.back_7);
        normal_11 = _S773.normal_1;
        height_12 = _S773.height_2;
    }
    else
    {
        normal_11 = _S768.surface_normal_0;
        height_12 = _S768.height_11;
    }
    var _S774 : vec3<f32> = vec3<f32>(_S770.xy, abs(_S771));
    if((dot(normal_11, _S774)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S766, _S767, _S768.x_15, _S768.y_8, height_12, _S774, (_S768.back_7) != _S772);
}

fn components_of_point_0( _S775 : u32,  _S776 : SearchQuality_0,  _S777 : YarnPoint_0,  _S778 : vec3<f32>,  _S779 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    var _S780 : f32;
    if(_S777.hole_6)
    {
        _S780 = 1.0f;
    }
    else
    {
        _S780 = 0.0f;
    }
    result_3.hole_2 = _S780;
    var _S781 : bool;
    if(_S777.hole_6)
    {
        _S781 = true;
    }
    else
    {
        _S781 = !is_lit_0(_S775, _S776, _S777, _S778);
    }
    if(_S781)
    {
        return result_3;
    }
    var _S782 : vec3<f32> = to_face_frame_0(_S778, _S777.back_7);
    var _S783 : vec3<f32> = to_face_frame_0(_S779, _S777.back_7);
    var _S784 : bool = (_S782.z) < 0.0f;
    var _S785 : vec3<f32>;
    if(_S784)
    {
        _S785 = (vec3<f32>(0) - _S782);
    }
    else
    {
        _S785 = _S782;
    }
    var _S786 : f32 = _S777.diffuse_gain_1 * diffuse_reflection_0(_S785, _S777.normal_10, fabrics_0[_S775].diffuse_blend_0);
    if(_S784)
    {
        _S780 = transmission_1(_S782, _S783, _S777.normal_10, _S777.tangent_10, _S777.roughness_10, fabrics_0[_S775].optical_depth_0);
    }
    else
    {
        _S780 = reflection_0(_S782, _S783, _S777.normal_10, _S777.tangent_10, _S777.roughness_10, fabrics_0[_S775].optical_depth_0);
    }
    var _S787 : f32;
    if(_S777.is_warp_3)
    {
        _S787 = _S786;
    }
    else
    {
        _S787 = 0.0f;
    }
    result_3.diffuse_warp_0 = _S787;
    if(_S777.is_warp_3)
    {
        _S787 = 0.0f;
    }
    else
    {
        _S787 = _S786;
    }
    result_3.diffuse_weft_0 = _S787;
    if(_S777.is_warp_3)
    {
        _S787 = _S780;
    }
    else
    {
        _S787 = 0.0f;
    }
    result_3.specular_warp_0 = _S787;
    if(_S777.is_warp_3)
    {
        _S780 = 0.0f;
    }
    result_3.specular_weft_0 = _S780;
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S788 : u32,  _S789 : u32) -> f32
{
    return table_number_0(fabrics_0[_S788].openness_0 + _S789);
}

fn blocked_of_terms_0( _S790 : u32,  _S791 : u32,  _S792 : array<f32, i32(6)>,  _S793 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_4 : u32 = u32(0);
    for(;;)
    {
        if(share_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_4] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S793)
            {
            }
            else
            {
                break;
            }
            shares_0[share_4] = shares_0[share_4] + openness_number_0(_S790, _S791 + share_4 * _S793 + term_0) * _S792[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_4] = saturate(shares_0[share_4]);
        share_4 = share_4 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_at_0( _S794 : u32,  _S795 : bool,  _S796 : bool,  _S797 : f32,  _S798 : f32) -> Blocked_0
{
    var _S799 : f32 = _S798 * openness_number_0(_S794, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S797, _S799, _S797 * _S797, _S797 * _S799, _S799 * _S799 );
    var _S800 : u32;
    if(_S796)
    {
        _S800 = u32(2);
    }
    else
    {
        _S800 = u32(0);
    }
    var _S801 : u32;
    if(_S795)
    {
        _S801 = u32(0);
    }
    else
    {
        _S801 = u32(1);
    }
    return blocked_of_terms_0(_S794, u32(60) + (_S800 + _S801) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S802 : u32,  _S803 : Blocked_0,  _S804 : YarnPoint_0,  _S805 : bool,  _S806 : f32) -> Blocked_0
{
    var _S807 : bool;
    if(_S804.hole_6)
    {
        _S807 = true;
    }
    else
    {
        _S807 = (_S804.is_warp_3) != _S805;
    }
    if(_S807)
    {
        return _S803;
    }
    var _S808 : Blocked_0 = blocked_at_0(_S802, _S805, _S804.back_7, _S804.surface_normal_0.z, _S804.height_11);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S803.by_warp_0 + _S806 * _S808.by_warp_0;
    result_4.by_weft_0 = _S803.by_weft_0 + _S806 * _S808.by_weft_0;
    result_4.far_0 = _S803.far_0 + _S806 * _S808.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S809 : u32,  _S810 : f32) -> vec3<f32>
{
    var _S811 : u32 = fabrics_0[_S809].lobes_0.levels_0 + u32(4) * u32(min(_S810, fabrics_0[_S809].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S811), table_number_0(_S811 + u32(1)), table_number_0(_S811 + u32(2)));
}

fn coverage_taps_0( _S812 : u32,  _S813 : Footprint_0,  _S814 : bool) -> CoverageTaps_0
{
    var _S815 : Lobes_std430_0 = fabrics_0[_S812].lobes_0;
    var _S816 : f32 = Footprint_spread_side_0(_S813) * fabrics_0[_S812].lobes_0.inverse_base_size_0;
    var _S817 : vec3<f32> = pyramid_level_0(_S812, floor(binary_logarithm_0(max(0.68000000715255737f * _S816, 1.0f))));
    var _S818 : f32 = 1.0f / max(_S816, 9.99999997475242708e-07f);
    var _S819 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S812].warp_0].inverse_period_0, families_0[fabrics_0[_S812].weft_0].inverse_period_0);
    var _S820 : vec2<f32> = _S813.centre_0 * _S819;
    var _S821 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S818 * _S818), 0.0f, 1.0f)), 0.3333333432674408f * _S818), 1.0f));
    var _S822 : vec2<f32> = _S813.dx_0 * _S819 * _S821;
    var _S823 : vec2<f32> = _S813.dy_0 * _S819 * _S821;
    var taps_3 : CoverageTaps_0;
    var number_3 : u32 = u32(0);
    for(;;)
    {
        if(number_3 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S824 : vec2<f32> = _S820 + vec2<f32>(TAP_OFFSETS_0[number_3].x) * _S822 + vec2<f32>(TAP_OFFSETS_0[number_3].y) * _S823;
        var _S825 : f32 = _S817.y;
        var _S826 : f32 = wrapped_cell_0(_S824.x, _S825);
        var _S827 : f32 = wrapped_cell_0(_S824.y, _S817.z);
        var _S828 : u32;
        if(_S814)
        {
            _S828 = _S815.face_nodes_0;
        }
        else
        {
            _S828 = u32(0);
        }
        taps_3.nodes_1[number_3] = _S828 + u32(_S827 * _S825 + _S826 + _S817.x);
        number_3 = number_3 + u32(1);
    }
    return taps_3;
}

fn coverage_of_pack_0( _S829 : u32,  _S830 : CoverageTaps_0,  _S831 : u32) -> vec4<f32>
{
    var number_4 : u32 = u32(0);
    var even_1 : u32 = u32(0);
    var odd_1 : u32 = u32(0);
    for(;;)
    {
        if(number_4 < u32(9))
        {
        }
        else
        {
            break;
        }
        var _S832 : u32 = words_0[fabrics_0[_S829].lobes_0.coverage_0 + _S830.nodes_1[number_4] * fabrics_0[_S829].lobes_0.packs_0 + _S831];
        var even_2 : u32 = even_1 + ((_S832 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S832 >> (u32(8)))) & (u32(16711935))));
        number_4 = number_4 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S833 : u32,  _S834 : CoverageTaps_0) -> f32
{
    var number_5 : u32 = u32(0);
    var total_0 : u32 = u32(0);
    for(;;)
    {
        if(number_5 < u32(9))
        {
        }
        else
        {
            break;
        }
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S833].lobes_0.coverage_holes_0 + _S834.nodes_1[number_5] / u32(4)] >> ((u32(8) * (_S834.nodes_1[number_5] % u32(4)))))) & (u32(255))));
        number_5 = number_5 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S835 : u32,  _S836 : CoverageTaps_0,  _S837 : NodeTaps_0,  _S838 : bool) -> f32
{
    var _S839 : Lobes_std430_0 = fabrics_0[_S835].lobes_0;
    var _S840 : f32 = interpolate_table_0(_S837, fabrics_0[_S835].lobes_0.projected_area_0 + fabrics_0[_S835].lobes_0.packs_0, fabrics_0[_S835].lobes_0.packs_0 + u32(1)).x;
    var _S841 : f32;
    if(_S838)
    {
        _S841 = _S839.back_hole_weight_0;
    }
    else
    {
        _S841 = _S839.front_hole_weight_0;
    }
    return min(coverage_of_holes_0(_S835, _S836) * _S840 * _S840 * _S841, 1.0f);
}

fn prefiltered_components_0( _S842 : u32,  _S843 : Footprint_0,  _S844 : vec3<f32>,  _S845 : vec3<f32>,  _S846 : bool) -> Components_0
{
    var _S847 : CoverageTaps_0 = coverage_taps_0(_S842, _S843, _S846);
    var _S848 : NodeTaps_0 = node_taps_0(_S845);
    var view_nodes_0 : NodeTaps_0 = _S848;
    var light_nodes_0 : NodeTaps_0 = node_taps_0(_S844);
    var seen_nodes_0 : NodeTaps_0 = _S848;
    var _S849 : u32;
    if(_S846)
    {
        _S849 = u32(1);
    }
    else
    {
        _S849 = u32(0);
    }
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S849 * u32(256)));
    var _S850 : u32 = u32(2) * _S849;
    seen_nodes_0.nodes_0 = seen_nodes_0.nodes_0 + vec4<u32>((_S850 * u32(256)));
    var _S851 : u32;
    if((_S844.z) < 0.0f)
    {
        _S851 = u32(1);
    }
    else
    {
        _S851 = u32(0);
    }
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((_S850 + _S851) * u32(256)));
    var _S852 : vec3<f32> = half_vector_0(_S844, _S845);
    var _S853 : vec3<f32> = shadow_correlation_0(_S844, _S845);
    if(_S846)
    {
        _S851 = fabrics_0[_S842].lobes_0.back_warp_packs_0;
    }
    else
    {
        _S851 = fabrics_0[_S842].lobes_0.front_warp_packs_0;
    }
    var sums_2 : Components_0;
    sums_2.diffuse_warp_0 = 0.0f;
    sums_2.diffuse_weft_0 = 0.0f;
    sums_2.specular_warp_0 = 0.0f;
    sums_2.specular_weft_0 = 0.0f;
    sums_2.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        var _S854 : Lobes_std430_0 = fabrics_0[_S842].lobes_0;
        if(pack_0 < (fabrics_0[_S842].lobes_0.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S855 : vec4<f32> = coverage_of_pack_0(_S842, _S847, pack_0);
        var _S856 : vec4<f32> = interpolate_table_0(view_nodes_0, _S854.projected_area_0 + pack_0, _S854.packs_0 + u32(1));
        var _S857 : u32 = _S854.light_visibility_0 + pack_0;
        var _S858 : vec4<f32> = vec4<f32>(255.0f);
        var _S859 : vec4<f32> = interpolate_table_0(seen_nodes_0, _S857, _S854.packs_0) / _S858;
        var _S860 : vec4<f32> = interpolate_table_0(light_nodes_0, _S857, _S854.packs_0) / _S858;
        var _S861 : vec4<f32> = interpolate_table_0(light_nodes_0, _S854.irradiance_0 + pack_0, _S854.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S862 : bool = pack_0 < _S851;
        var _S863 : u32;
        if(_S862)
        {
            _S863 = fabrics_0[_S842].warp_0;
        }
        else
        {
            _S863 = fabrics_0[_S842].weft_0;
        }
        var _S864 : f32 = families_0[_S863].roughness_0;
        var number_6 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_6 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S865 : Group_0 = group_at_0(_S854.moments_0 + u32(12) * (u32(4) * (_S849 * _S854.packs_0 + pack_0) + number_6), _S864);
            var _S866 : f32 = _S855[number_6] * _S856[number_6] * _S856[number_6] * _S865.weight_2;
            var _S867 : vec2<f32> = visibility_gain_0(_S853, _S860[number_6], _S859[number_6]);
            var _S868 : f32 = _S867.x;
            var diffuse_1 : f32 = diffuse_0 + _S866 * _S861[number_6] * _S868;
            var specular_1 : f32 = specular_0 + _S866 * layer_value_0(_S865, _S852, _S844, _S845, fabrics_0[_S842].optical_depth_0) * _S860[number_6] * _S867.y;
            sums_2.light_visibility_1 = sums_2.light_visibility_1 + _S866 * _S860[number_6] * _S868;
            var total_3 : f32 = total_2 + _S866;
            number_6 = number_6 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            total_2 = total_3;
        }
        var _S869 : f32;
        if(_S862)
        {
            _S869 = diffuse_0;
        }
        else
        {
            _S869 = 0.0f;
        }
        sums_2.diffuse_warp_0 = sums_2.diffuse_warp_0 + _S869;
        var _S870 : f32;
        if(_S862)
        {
            _S870 = 0.0f;
        }
        else
        {
            _S870 = diffuse_0;
        }
        sums_2.diffuse_weft_0 = sums_2.diffuse_weft_0 + _S870;
        var _S871 : f32;
        if(_S862)
        {
            _S871 = specular_0;
        }
        else
        {
            _S871 = 0.0f;
        }
        sums_2.specular_warp_0 = sums_2.specular_warp_0 + _S871;
        var _S872 : f32;
        if(_S862)
        {
            _S872 = 0.0f;
        }
        else
        {
            _S872 = specular_0;
        }
        sums_2.specular_weft_0 = sums_2.specular_weft_0 + _S872;
        pack_0 = pack_0 + u32(1);
    }
    var _S873 : f32 = prefiltered_hole_0(_S842, _S847, view_nodes_0, _S846);
    sums_2.hole_2 = _S873;
    var _S874 : f32 = (1.0f - _S873) / max(total_2, 9.999999960041972e-13f);
    sums_2.diffuse_warp_0 = sums_2.diffuse_warp_0 * _S874;
    sums_2.diffuse_weft_0 = sums_2.diffuse_weft_0 * _S874;
    sums_2.specular_warp_0 = sums_2.specular_warp_0 * _S874;
    sums_2.specular_weft_0 = sums_2.specular_weft_0 * _S874;
    sums_2.light_visibility_1 = sums_2.light_visibility_1 * _S874;
    return sums_2;
}

fn albedos_over_0( _S875 : u32,  _S876 : Footprint_0,  _S877 : bool) -> FamilyAlbedos_0
{
    var _S878 : vec2<f32> = _S876.dx_0;
    var _S879 : vec2<f32> = _S876.dy_0;
    var _S880 : vec2<f32> = sqrt(_S878 * _S878 + _S879 * _S879);
    var _S881 : Stretch_0 = stretch_of_0(fabrics_0[_S875].warp_0, _S876.centre_0.x, _S880.x);
    var _S882 : Stretch_0 = stretch_of_0(fabrics_0[_S875].weft_0, _S876.centre_0.y, _S880.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S875].warp_0, fabrics_0[_S875].weft_0, _S881, _S882, _S877);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S875].weft_0, fabrics_0[_S875].warp_0, _S882, _S881, _S877);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S883 : u32,  _S884 : Footprint_0,  _S885 : f32,  _S886 : vec2<f32>,  _S887 : vec3<f32>,  _S888 : vec3<f32>) -> Estimate_0
{
    var _S889 : f32;
    var _S890 : f32;
    var _S891 : Regime_0 = regime_of_0(_S883, _S884, _S885);
    var _S892 : bool = (_S888.z) < 0.0f;
    var _S893 : vec3<f32> = to_face_frame_0(_S888, _S892);
    var _S894 : f32 = Footprint_spread_side_0(_S884);
    var _S895 : bool = varies_at_0(_S883, _S894);
    var _S896 : bool;
    if((families_0[fabrics_0[_S883].warp_0].quantities_0) > u32(1))
    {
        _S896 = true;
    }
    else
    {
        _S896 = (families_0[fabrics_0[_S883].weft_0].quantities_0) > u32(1);
    }
    var _S897 : f32 = 1.0f - _S891.prefiltered_0;
    if(_S897 > 0.0f)
    {
        if(_S895)
        {
            _S896 = true;
        }
    }
    else
    {
        _S896 = false;
    }
    var box_0 : Footprint_0 = _S884;
    var _S898 : vec3<f32> = vec3<f32>(0.0f);
    var _S899 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S898, _S898, 0.0f, 0.0f, 0.0f);
    var _S900 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S901 : i32;
    if(_S896)
    {
        _S901 = i32(0);
    }
    else
    {
        _S901 = i32(1);
    }
    var _S902 : u32 = u32(_S901);
    var points_1 : Components_0 = _S900;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S899;
    var central_place_0 : vec2<f32> = _S884.centre_0;
    var number_7 : u32 = _S902;
    for(;;)
    {
        var _S903 : f32 = f32(number_7);
        _S889 = _S891.points_0;
        if(_S903 < (_S891.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S904 : bool = number_7 == u32(0);
        var _S905 : u32;
        if(_S904)
        {
            _S905 = u32(0);
        }
        else
        {
            _S905 = number_7 - u32(1);
        }
        var _S906 : vec2<f32> = POINT_OFFSETS_0[_S905] + _S886;
        var _S907 : vec2<f32>;
        if(_S904)
        {
            _S907 = vec2<f32>(0.0f);
        }
        else
        {
            _S907 = _S906 - round(_S906);
        }
        var _S908 : vec2<f32> = _S884.centre_0 + vec2<f32>(_S907.x) * _S884.dx_0 + vec2<f32>(_S907.y) * _S884.dy_0;
        if(_S904)
        {
            _S890 = 0.0f;
        }
        else
        {
            _S890 = _S891.threads_1;
        }
        var _S909 : SearchQuality_0 = quality_of_0(_S890);
        var _S910 : Hit_0 = first_hit_0(_S883, _S909, _S908.x, _S908.y, _S893, _S892);
        var _S911 : SurfacePoint_0 = surface_at_0(_S883, _S910.x_14, _S910.y_7, _S892);
        if(_S904)
        {
            var central_weight_1 : f32;
            if(_S910.hole_5)
            {
                central_weight_1 = 0.0f;
            }
            else
            {
                central_weight_1 = _S897;
            }
            var central_place_1 : vec2<f32> = vec2<f32>(_S910.x_14, _S910.y_7);
            box_0.centre_0 = mix(_S884.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S911;
            central_place_0 = central_place_1;
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S912 : YarnPoint_0 = yarn_point_of_0(_S883, _S911, _S910.x_14, _S910.y_7, _S892, _S910.hole_5, _S894);
        var _S913 : f32 = min(_S891.points_0 - f32(number_7 - u32(1)), 1.0f);
        var _S914 : Components_0 = with_added_0(points_1, components_of_point_0(_S883, _S909, _S912, _S887, _S888), _S913);
        if((fabrics_0[_S883].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S883, close_1.warp_1, _S912, true, _S913);
            close_1.weft_1 = with_blocked_0(_S883, close_1.weft_1, _S912, false, _S913);
        }
        points_1 = _S914;
        number_7 = number_7 + u32(1);
    }
    close_1.weight_0 = _S897;
    var _S915 : f32 = max(_S889, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S915);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S915);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S900, points_1, _S897 / _S915);
    if((_S891.prefiltered_0) > 0.0f)
    {
        estimate_0.components_0 = with_added_0(estimate_0.components_0, prefiltered_components_0(_S883, _S884, to_face_frame_0(_S887, _S892), _S893, _S892), _S891.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S883, box_0, _S892);
    if(_S895)
    {
        _S896 = central_weight_0 > 0.0f;
    }
    else
    {
        _S896 = false;
    }
    if(_S896)
    {
        var _S916 : SurfacePoint_0 = central_0;
        var _S917 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S917 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S917 = estimate_0.albedos_5.weft_5;
        }
        if((fabrics_0[_S883].has_detail_0) != u32(0))
        {
            _S896 = has_hairs_0(_S883);
        }
        else
        {
            _S896 = false;
        }
        if(_S896)
        {
            _S890 = hair_at_0(_S883, central_place_0, _S892, _S894).cover_0;
        }
        else
        {
            _S890 = 0.0f;
        }
        var _S918 : Albedos_0 = lerp_albedos_0(_S917, varied_at_0(_S883, central_0, _S917, central_place_0.x, central_place_0.y, _S892, _S894, _S890), central_weight_0);
        if(_S916.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S918;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S918;
        }
    }
    return estimate_0;
}

fn scattered_by_0( _S919 : u32,  _S920 : Albedos_0,  _S921 : u32,  _S922 : vec3<f32>) -> Scattered_0
{
    var _S923 : u32 = u32(159) + u32(2) * _S921;
    var yarn_3 : Scattered_0;
    yarn_3.back_6 = _S922 * _S920.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S919, _S923)) * _S920.specular_reflect_0;
    yarn_3.through_0 = _S922 * _S920.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S919, _S923 + u32(1))) * _S920.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S924 : u32,  _S925 : u32,  _S926 : vec3<f32>,  _S927 : vec3<f32>,  _S928 : vec3<f32>,  _S929 : vec3<f32>,  _S930 : ptr<function, vec3<f32>>,  _S931 : ptr<function, vec3<f32>>)
{
    var _S932 : u32 = u32(146) + u32(4) * _S925;
    var _S933 : f32 = openness_number_0(_S924, _S932 + u32(1));
    var _S934 : f32 = openness_number_0(_S924, _S932 + u32(2));
    var _S935 : vec3<f32> = vec3<f32>(1.0f);
    var _S936 : vec3<f32> = _S935 - _S928 * vec3<f32>(openness_number_0(_S924, _S932));
    var _S937 : vec3<f32> = _S935 - _S929 * vec3<f32>(openness_number_0(_S924, _S932 + u32(3)));
    var _S938 : vec3<f32> = _S935 / (_S936 * _S937 - _S928 * _S929 * vec3<f32>((_S933 * _S934)));
    (*_S930) = (_S926 * _S937 + _S928 * vec3<f32>(_S933) * _S927) * _S938;
    (*_S931) = (_S927 * _S936 + _S929 * vec3<f32>(_S934) * _S926) * _S938;
    return;
}

fn face_sends_0( _S939 : u32,  _S940 : u32,  _S941 : Scattered_0,  _S942 : Scattered_0) -> FaceSends_0
{
    var _S943 : u32 = u32(2) * _S940;
    var _S944 : u32 = u32(142) + _S943;
    var _S945 : f32 = openness_number_0(_S939, _S944);
    var _S946 : f32 = openness_number_0(_S939, _S944 + u32(1));
    var _S947 : vec3<f32> = vec3<f32>((1.0f - _S945)) * _S941.back_6;
    var _S948 : vec3<f32> = vec3<f32>((1.0f - _S946)) * _S942.back_6;
    var sends_1 : FaceSends_0;
    var _S949 : u32 = u32(154) + _S943;
    var _S950 : f32 = openness_number_0(_S939, _S949);
    sends_1.blocks_warp_0 = _S950;
    var _S951 : f32 = openness_number_0(_S939, _S949 + u32(1));
    sends_1.blocks_weft_0 = _S951;
    sends_1.open_0 = _S950 * _S945 + _S951 * _S946;
    var _S952 : vec3<f32> = vec3<f32>(_S945) * _S941.back_6;
    var _S953 : vec3<f32> = vec3<f32>(_S946) * _S942.back_6;
    var _S954 : vec3<f32> = sends_1.sky_warp_0;
    var _S955 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S939, _S940, _S952, _S953, _S947, _S948, &(_S954), &(_S955));
    sends_1.sky_warp_0 = _S954;
    sends_1.sky_weft_0 = _S955;
    var _S956 : vec3<f32> = sends_1.crossing_warp_0;
    var _S957 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S939, _S940, _S941.through_0, _S942.through_0, _S947, _S948, &(_S956), &(_S957));
    sends_1.crossing_warp_0 = _S956;
    sends_1.crossing_weft_0 = _S957;
    return sends_1;
}

fn interior_of_0( _S958 : u32,  _S959 : vec3<f32>,  _S960 : bool) -> Interior_0
{
    var _S961 : Scattered_0 = scattered_by_0(_S958, table_albedos_0(families_0[fabrics_0[_S958].warp_0].colour_mean_0), u32(0), _S959);
    var _S962 : Scattered_0 = scattered_by_0(_S958, table_albedos_0(families_0[fabrics_0[_S958].weft_0].colour_mean_0), u32(1), _S959);
    var _S963 : u32;
    if(_S960)
    {
        _S963 = u32(1);
    }
    else
    {
        _S963 = u32(0);
    }
    var _S964 : FaceSends_0 = face_sends_0(_S958, _S963, _S961, _S962);
    if(_S960)
    {
        _S963 = u32(0);
    }
    else
    {
        _S963 = u32(1);
    }
    var _S965 : FaceSends_0 = face_sends_0(_S958, _S963, _S961, _S962);
    var _S966 : vec3<f32> = vec3<f32>(_S964.blocks_warp_0);
    var _S967 : vec3<f32> = vec3<f32>(_S964.blocks_weft_0);
    var _S968 : vec3<f32> = _S966 * _S964.crossing_warp_0 + _S967 * _S964.crossing_weft_0;
    var _S969 : vec3<f32> = vec3<f32>(_S965.blocks_warp_0);
    var _S970 : vec3<f32> = vec3<f32>(_S965.blocks_weft_0);
    var _S971 : vec3<f32> = _S969 * _S965.crossing_warp_0 + _S970 * _S965.crossing_weft_0;
    var _S972 : f32 = 1.0f - _S964.open_0;
    var _S973 : f32 = 1.0f - _S965.open_0;
    var _S974 : vec3<f32> = vec3<f32>(1.0f);
    var _S975 : vec3<f32> = _S974 / (_S974 - _S968 * _S971 * vec3<f32>((_S972 * _S973)));
    var _S976 : vec3<f32> = _S971 * (vec3<f32>(_S964.open_0) + vec3<f32>(_S972) * (_S966 * _S964.sky_warp_0 + _S967 * _S964.sky_weft_0)) * _S975;
    var _S977 : vec3<f32> = _S968 * (vec3<f32>(_S965.open_0) + vec3<f32>(_S973) * (_S969 * _S965.sky_warp_0 + _S970 * _S965.sky_weft_0)) * _S975;
    var _S978 : FaceRadiance_0 = face_radiance_0(_S964, _S965.open_0, _S976, _S977);
    var _S979 : FaceRadiance_0 = face_radiance_0(_S965, _S964.open_0, _S977, _S976);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S978.warp_3;
    interior_1.weft_4 = _S978.weft_3;
    interior_1.leaked_1 = _S978.leaked_0;
    interior_1.far_1 = _S979.mean_1;
    interior_1.far_leaked_0 = _S979.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S980 : u32,  _S981 : vec3<f32>,  _S982 : bool,  _S983 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S981, &(terms_3));
    var _S984 : u32;
    if(_S983)
    {
        _S984 = u32(2);
    }
    else
    {
        _S984 = u32(0);
    }
    var _S985 : u32;
    if(_S982)
    {
        _S985 = u32(0);
    }
    else
    {
        _S985 = u32(1);
    }
    return blocked_of_terms_0(_S980, (_S984 + _S985) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S986 : u32,  _S987 : vec3<f32>,  _S988 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S987, &(terms_4));
    var term_1 : u32 = u32(0);
    var share_5 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var _S989 : u32;
        if(_S988)
        {
            _S989 = u32(5);
        }
        else
        {
            _S989 = u32(0);
        }
        var share_6 : f32 = share_5 + openness_number_0(_S986, u32(132) + _S989 + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S990 : u32,  _S991 : FamilyAlbedos_0,  _S992 : vec3<f32>,  _S993 : Interior_0,  _S994 : Blocked_0,  _S995 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S994, scattered_by_0(_S990, _S991.warp_5, u32(0), _S992), _S993), bounced_by_0(_S995, scattered_by_0(_S990, _S991.weft_5, u32(1), _S992), _S993));
}

fn bounced_far_0( _S996 : u32,  _S997 : FamilyAlbedos_0,  _S998 : vec3<f32>,  _S999 : Interior_0,  _S1000 : vec3<f32>,  _S1001 : bool,  _S1002 : f32,  _S1003 : f32,  _S1004 : f32) -> Bounced_0
{
    var _S1005 : Blocked_0 = blocked_from_0(_S996, _S1000, true, _S1001);
    var _S1006 : Blocked_0 = blocked_from_0(_S996, _S1000, false, _S1001);
    var _S1007 : f32 = _S1002 / max(1.0f - _S1005.by_warp_0 - _S1005.by_weft_0, 0.10000000149011612f);
    var _S1008 : f32 = (0.0020000000949949f * warp_seen_from_0(_S996, _S1000, _S1001) + _S1007) / (_S1007 + _S1003 / max(1.0f - _S1006.by_warp_0 - _S1006.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S1009 : f32 = 1.0f - _S1004;
    return bounced_of_families_0(_S996, _S997, _S998, _S999, scaled_0(_S1005, _S1008 * _S1009), scaled_0(_S1006, (1.0f - _S1008) * _S1009));
}

fn bounced_over_0( _S1010 : u32,  _S1011 : Components_0,  _S1012 : CloseUp_0,  _S1013 : FamilyAlbedos_0,  _S1014 : vec3<f32>,  _S1015 : vec3<f32>) -> Bounced_0
{
    var _S1016 : bool = (_S1015.z) < 0.0f;
    var _S1017 : Interior_0 = interior_of_0(_S1010, _S1014, _S1016);
    var bounced_2 : Bounced_0 = bounced_far_0(_S1010, _S1013, _S1014, _S1017, to_face_frame_0(_S1015, _S1016), _S1016, _S1011.diffuse_warp_0, _S1011.diffuse_weft_0, _S1011.hole_2);
    if((_S1012.weight_0) > 0.0f)
    {
        var _S1018 : Bounced_0 = bounced_of_families_0(_S1010, _S1013, _S1014, _S1017, _S1012.warp_1, _S1012.weft_1);
        var _S1019 : vec3<f32> = vec3<f32>(_S1012.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S1018.reflected_0, _S1019);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S1018.transmitted_0, _S1019);
    }
    return bounced_2;
}

fn composed_0( _S1020 : u32,  _S1021 : Components_0,  _S1022 : CloseUp_0,  _S1023 : FamilyAlbedos_0,  _S1024 : vec3<f32>,  _S1025 : vec3<f32>,  _S1026 : vec3<f32>) -> vec3<f32>
{
    var _S1027 : Albedos_0 = tinted_0(_S1023.warp_5, _S1024);
    var _S1028 : Albedos_0 = tinted_0(_S1023.weft_5, _S1024);
    var _S1029 : vec3<f32> = vec3<f32>(_S1021.diffuse_warp_0);
    var _S1030 : vec3<f32> = vec3<f32>(_S1021.diffuse_weft_0);
    var _S1031 : vec3<f32> = vec3<f32>(_S1021.specular_warp_0);
    var _S1032 : vec3<f32> = vec3<f32>(_S1021.specular_weft_0);
    var _S1033 : vec3<f32> = _S1027.diffuse_reflect_0 * _S1029 + _S1028.diffuse_reflect_0 * _S1030 + _S1027.specular_reflect_0 * _S1031 + _S1028.specular_reflect_0 * _S1032;
    var _S1034 : f32 = _S1026.z;
    var body_0 : vec3<f32>;
    if((_S1025.z * _S1034) < 0.0f)
    {
        body_0 = _S1027.diffuse_transmit_0 * _S1029 + _S1028.diffuse_transmit_0 * _S1030 + _S1027.specular_transmit_0 * _S1031 + _S1028.specular_transmit_0 * _S1032;
    }
    else
    {
        body_0 = _S1033;
    }
    if((fabrics_0[_S1020].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S1020, _S1021, _S1022, _S1023, _S1024, _S1026), _S1025, _S1026);
    }
    var _S1035 : f32 = fabrics_0[_S1020].sheen_strength_0;
    if((fabrics_0[_S1020].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1036 : bool = _S1034 < 0.0f;
    var _S1037 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1025, _S1036), to_face_frame_0(_S1026, _S1036), _S1035, fabrics_0[_S1020].sheen_roughness_0);
    return vec3<f32>(_S1037.y) * body_0 + vec3<f32>(((_S1021.light_visibility_1 + _S1021.hole_2) * _S1037.x));
}

fn light_of_footprint_0( _S1038 : i32,  _S1039 : u32,  _S1040 : VisiblePoint_0,  _S1041 : vec2<u32>,  _S1042 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S1040.draft_0;
    footprint_0.dx_0 = _S1040.draft_dx_0;
    footprint_0.dy_0 = _S1040.draft_dy_0;
    var _S1043 : vec2<f32> = fract(vec2<f32>(f32(((frames_0[_S1038].pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S1044 : vec3<f32> = to_local_0(_S1040, _S1040.view_1);
    var _S1045 : u32 = light_sample_count_0(_S1038);
    var _S1046 : vec3<f32> = vec3<f32>(0.0f);
    var number_8 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1046;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        if(number_8 < (max(_S1045, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S1047 : f32;
        if(number_8 < _S1045)
        {
            _S1047 = visibility_at_0(_S1038, number_8, _S1041);
        }
        else
        {
            _S1047 = 0.0f;
        }
        var _S1048 : bool;
        if(_S1047 <= 0.0f)
        {
            _S1048 = number_8 > u32(0);
        }
        else
        {
            _S1048 = false;
        }
        if(_S1048)
        {
            number_8 = number_8 + u32(1);
            continue;
        }
        var _S1049 : LightSample_0 = light_sample_0(_S1038, number_8, _S1041, _S1040.position_0);
        var _S1050 : vec3<f32> = to_local_0(_S1040, _S1049.towards_0);
        var _S1051 : Estimate_0 = lobes_estimate_of_pass_0(_S1039, footprint_0, 1.0f, _S1043, _S1050, _S1044);
        radiance_1 = radiance_1 + vec3<f32>(_S1047) * _S1049.irradiance_1 * composed_0(_S1039, _S1051.components_0, _S1051.close_0, _S1051.albedos_5, _S1042, _S1050, _S1044);
        hole_7 = _S1051.components_0.hole_2;
        number_8 = number_8 + u32(1);
    }
    var _S1052 : f32 = fabrics_0[_S1039].sheen_strength_0;
    if((fabrics_0[_S1039].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S1052 * sheen_lobe_0(abs(_S1044.z), fabrics_0[_S1039].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1053 : u32 = id_0.x;
    var _S1054 : u32 = frames_0[i32(0)].width_0;
    var _S1055 : bool;
    if(_S1053 >= (frames_0[i32(0)].width_0))
    {
        _S1055 = true;
    }
    else
    {
        _S1055 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S1055)
    {
        return;
    }
    var _S1056 : u32 = id_0.y * _S1054 + _S1053;
    var _S1057 : u32 = layers_0[_S1056].face_0;
    if((layers_0[_S1056].face_0) == u32(0))
    {
        return;
    }
    var _S1058 : u32 = _S1057 - u32(1);
    var _S1059 : u32 = face_fabrics_0[_S1058];
    var _S1060 : vec2<u32> = id_0.xy;
    var _S1061 : VisiblePoint_0 = visible_point_0(i32(0), _S1059, _S1058, _S1060);
    accumulate_0(_S1056, light_of_footprint_0(i32(0), _S1059, _S1061, _S1060, filtered_albedo_0(_S1059, _S1061)));
    return;
}

