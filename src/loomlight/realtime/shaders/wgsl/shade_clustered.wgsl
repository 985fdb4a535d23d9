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

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

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

fn mixed_0( number_0 : u32) -> u32
{
    var bits_0 : u32 = ((number_0 ^ (((number_0 >> (u32(16))))))) * u32(2246822507);
    var bits_1 : u32 = ((bits_0 ^ (((bits_0 >> (u32(13))))))) * u32(3266489909);
    return (bits_1 ^ (((bits_1 >> (u32(16))))));
}

fn uniform_of_0( seed_1 : u32,  dimension_0 : u32) -> f32
{
    return f32(((mixed_0(seed_1 + (dimension_0 + u32(1)) * u32(2654435769))) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S25 : vec2<f32> = direction_1.xy;
    var _S26 : f32;
    if(back_2)
    {
        _S26 = - direction_1.z;
    }
    else
    {
        _S26 = direction_1.z;
    }
    return vec3<f32>(_S25, _S26);
}

fn arc_tangent_quotient_0( x_7 : f32,  y_2 : f32) -> f32
{
    return ((((((0.0f * x_7 + 0.00809729471802711f) * x_7 + -0.0377517081797123f) * x_7 + 0.08475969731807709f) * x_7 + -0.13537675142288208f) * x_7 + 0.19895026087760925f) * x_7 + -0.33327975869178772f) * x_7 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

struct BinTaps_0
{
     corner_0 : u32,
     bins_1 : u32,
     weights_0 : vec4<f32>,
};

fn bin_taps_0( direction_2 : vec3<f32>,  bins_2 : u32) -> BinTaps_0
{
    var _S27 : f32 = sqrt(max(1.0f - direction_2.z, 0.0f));
    var _S28 : f32 = direction_2.x;
    var _S29 : f32 = abs(_S28);
    var _S30 : f32 = direction_2.y;
    var _S31 : f32 = abs(_S30);
    var _S32 : f32 = arc_tangent_of_ratio_0(min(_S29, _S31) / max(max(_S29, _S31), 9.999999960041972e-13f)) * 1.27323949337005615f;
    var _S33 : bool = _S29 >= _S31;
    var _S34 : f32;
    if(_S28 < 0.0f)
    {
        _S34 = -1.0f;
    }
    else
    {
        _S34 = 1.0f;
    }
    var _S35 : f32;
    if(_S33)
    {
        _S35 = _S27;
    }
    else
    {
        _S35 = _S27 * _S32;
    }
    var _S36 : f32 = _S34 * _S35;
    if(_S30 < 0.0f)
    {
        _S34 = -1.0f;
    }
    else
    {
        _S34 = 1.0f;
    }
    if(_S33)
    {
        _S35 = _S27 * _S32;
    }
    else
    {
        _S35 = _S27;
    }
    var _S37 : f32 = f32(bins_2);
    var _S38 : vec2<f32> = clamp((vec2<f32>(_S36, _S34 * _S35) + vec2<f32>(1.0f)) * vec2<f32>((0.5f * _S37)) - vec2<f32>(0.5f), vec2<f32>(0.0f), vec2<f32>((_S37 - 1.0f)));
    var _S39 : f32 = _S38.x;
    var _S40 : u32 = bins_2 - u32(2);
    var _S41 : u32 = min(u32(_S39), _S40);
    var _S42 : f32 = _S38.y;
    var _S43 : u32 = min(u32(_S42), _S40);
    var _S44 : f32 = _S39 - f32(_S41);
    var _S45 : f32 = _S42 - f32(_S43);
    var taps_0 : BinTaps_0;
    taps_0.corner_0 = _S43 * bins_2 + _S41;
    taps_0.bins_1 = bins_2;
    var _S46 : f32 = 1.0f - _S44;
    var _S47 : f32 = 1.0f - _S45;
    taps_0.weights_0 = vec4<f32>(_S46 * _S47, _S44 * _S47, _S46 * _S45, _S44 * _S45);
    return taps_0;
}

fn table_number_0( index_1 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_1])));
}

fn BinTaps_read_0( this_0 : BinTaps_0,  table_0 : u32,  first_1 : u32,  stride_0 : u32,  offset_2 : u32) -> f32
{
    var _S48 : u32 = table_0 + (first_1 + this_0.corner_0) * stride_0 + offset_2;
    return table_number_0(_S48) * this_0.weights_0.x + table_number_0(_S48 + stride_0) * this_0.weights_0.y + table_number_0(_S48 + this_0.bins_1 * stride_0) * this_0.weights_0.z + table_number_0(_S48 + (this_0.bins_1 + u32(1)) * stride_0) * this_0.weights_0.w;
}

struct TexelBox_0
{
     corner_1 : vec2<f32>,
     size_1 : vec2<f32>,
     first_2 : vec2<u32>,
     extent_0 : vec2<f32>,
     last_0 : vec2<u32>,
     turns_0 : vec2<f32>,
};

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn texel_box_0( tables_0 : ptr<function, Clustered_std430_0>,  footprint_0 : Footprint_0,  offset_3 : vec2<f32>,  place_0 : f32) -> TexelBox_0
{
    var _S49 : f32 = footprint_0.dx_0.x;
    var _S50 : f32 = footprint_0.dy_0.x;
    var _S51 : f32 = sqrt(_S49 * _S49 + _S50 * _S50);
    var _S52 : f32 = footprint_0.dx_0.y;
    var _S53 : f32 = footprint_0.dy_0.y;
    var _S54 : f32 = sqrt(_S52 * _S52 + _S53 * _S53);
    var _S55 : vec2<f32> = vec2<f32>(_S51, _S54);
    var _S56 : f32 = (_S49 * _S52 + _S50 * _S53) / max(_S51 * _S54, 1.00000000317107685e-30f);
    var _S57 : f32 = abs(_S56);
    var _S58 : f32 = place_0 * sqrt(min(_S57, 1.0f));
    var _S59 : f32;
    if(_S56 < 0.0f)
    {
        _S59 = - _S58;
    }
    else
    {
        _S59 = _S58;
    }
    var _S60 : vec2<f32> = _S55 * vec2<f32>(_S58, _S59);
    var _S61 : vec2<f32> = vec2<f32>((*tables_0).texel_width_0, (*tables_0).texel_height_0);
    var _S62 : u32 = (*tables_0).columns_0;
    var _S63 : u32 = (*tables_0).rows_0;
    var _S64 : vec2<f32> = vec2<f32>(f32((*tables_0).columns_0), f32((*tables_0).rows_0));
    var box_0 : TexelBox_0;
    var _S65 : vec2<f32> = _S55 * vec2<f32>(sqrt(max(1.0f - _S57, 0.0f)));
    box_0.size_1 = _S65;
    var _S66 : vec2<f32> = vec2<f32>(0.5f);
    var _S67 : vec2<f32> = _S66 * _S65;
    var _S68 : vec2<f32> = footprint_0.centre_0 + _S60 - _S67;
    box_0.corner_1 = _S68;
    var _S69 : vec2<f32> = max(round(_S65 / _S61), vec2<f32>(1.0f));
    box_0.extent_0 = _S69;
    var _S70 : vec2<f32> = round((_S68 + _S67 + offset_3) / _S61 - _S66 * _S69);
    var _S71 : vec2<f32> = vec2<f32>(0.0f);
    var _S72 : vec2<f32> = max(_S70 - floor(_S70 / _S64) * _S64, _S71);
    var _S73 : vec2<u32> = vec2<u32>(min(u32(_S72.x), (*tables_0).columns_0 - u32(1)), min(u32(_S72.y), (*tables_0).rows_0 - u32(1)));
    box_0.first_2 = _S73;
    var _S74 : vec2<f32> = floor(_S69 / _S64);
    box_0.turns_0 = _S74;
    var _S75 : vec2<f32> = max(_S69 - _S74 * _S64, _S71);
    var _S76 : vec2<u32> = _S73 + vec2<u32>(u32(_S75.x), u32(_S75.y));
    box_0.last_0 = _S76;
    if((_S76.x) >= ((*tables_0).columns_0))
    {
        box_0.last_0[i32(0)] = box_0.last_0[i32(0)] - _S62;
        box_0.turns_0[i32(0)] = box_0.turns_0[i32(0)] + 1.0f;
    }
    if((box_0.last_0.y) >= _S63)
    {
        box_0.last_0[i32(1)] = box_0.last_0[i32(1)] - _S63;
        box_0.turns_0[i32(1)] = box_0.turns_0[i32(1)] + 1.0f;
    }
    return box_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S77 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S77, fma(- _S77, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
     thread_0 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S78 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_0 : Cell_0;
    var _S79 : f32 = fma(- _S78, families_0[family_1].size_0, position_1);
    cell_0.below_0 = _S79;
    cell_0.above_0 = families_0[family_1].size_0 - _S79;
    cell_0.across_0 = _S79 - 0.5f * families_0[family_1].size_0;
    cell_0.half_width_1 = families_0[family_1].half_width_0;
    cell_0.thread_0 = u32(clamp(turns_and_remainder_0(family_1, _S78).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_0;
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_1 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_2 : f32 = turns_1 - floor(turns_1);
    var _S80 : f32 = turns_2 * families_0[family_2].period_0;
    var thread_1 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_2 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S81 : u32;
    if(_S80 >= (table_number_0(families_0[family_2].place_table_0 + thread_1 * u32(4) + u32(1))))
    {
        _S81 = u32(1);
    }
    else
    {
        _S81 = u32(0);
    }
    var _S82 : u32 = min(thread_1 + _S81, u32(families_0[family_2].count_0) - u32(1));
    var _S83 : u32 = families_0[family_2].place_table_0 + _S82 * u32(4);
    var cell_1 : Cell_0;
    cell_1.thread_0 = _S82;
    cell_1.below_0 = _S80 - table_number_0(_S83);
    cell_1.above_0 = table_number_0(_S83 + u32(1)) - _S80;
    cell_1.across_0 = _S80 - table_number_0(_S83 + u32(2));
    cell_1.half_width_1 = table_number_0(_S83 + u32(3));
    return cell_1;
}

fn locate_0( family_3 : u32,  position_3 : f32) -> Cell_0
{
    if((families_0[family_3].is_alike_0) != u32(0))
    {
        return locate_alike_0(family_3, position_3);
    }
    return locate_varied_0(family_3, position_3);
}

struct Bound_0
{
     thread_2 : u32,
     turns_3 : f32,
     cell_2 : f32,
     visible_0 : f32,
     width_2 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_4 : u32,  position_4 : f32) -> Bound_0
{
    var _S84 : Cell_0 = locate_0(family_4, position_4);
    var _S85 : f32 = table_number_0(families_0[family_4].before_0 + u32(2) * _S84.thread_0 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_2 = _S84.thread_0;
    bound_0.turns_3 = round((position_4 - families_0[family_4].start_0 - _S85 - _S84.below_0) * families_0[family_4].inverse_period_0);
    bound_0.cell_2 = _S84.below_0;
    var _S86 : f32 = 2.0f * _S84.half_width_1;
    bound_0.width_2 = _S86;
    bound_0.visible_0 = clamp((_S84.across_0 + _S84.half_width_1) / _S86, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S84.below_0, _S84.below_0 - _S84.across_0 - _S84.half_width_1) + max(_S84.across_0 - _S84.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_0 : Bound_0,
     high_0 : Bound_0,
};

fn stretch_of_0( family_5 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S87 : f32 = centre_1 - floor((centre_1 - families_0[family_5].start_0) * families_0[family_5].inverse_period_0) * families_0[family_5].period_0;
    var _S88 : f32 = 0.5f * max(size_2, families_0[family_5].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_0 = bound_at_0(family_5, _S87 - _S88);
    stretch_0.high_0 = bound_at_0(family_5, _S87 + _S88);
    return stretch_0;
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

fn Stretch_turns_0( this_1 : Stretch_0) -> f32
{
    return this_1.high_0.turns_3 - this_1.low_0.turns_3;
}

fn lengths_0( family_6 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S89 : f32 = Stretch_turns_0(stretch_1);
    var _S90 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.low_0.thread_2;
    var _S91 : u32 = families_0[family_6].before_0 + u32(2) * stretch_1.high_0.thread_2;
    var _S92 : f32 = table_number_0(_S91) - table_number_0(_S90);
    var _S93 : f32 = table_number_0(_S91 + u32(1)) - table_number_0(_S90 + u32(1));
    return vec3<f32>(_S92 + stretch_1.high_0.visible_0 * stretch_1.high_0.width_2 - stretch_1.low_0.visible_0 * stretch_1.low_0.width_2 + _S89 * families_0[family_6].visible_total_0, _S93 - _S92 + stretch_1.high_0.gap_0 - stretch_1.low_0.gap_0 + _S89 * (families_0[family_6].period_0 - families_0[family_6].visible_total_0), _S93 + stretch_1.high_0.cell_2 - stretch_1.low_0.cell_2 + _S89 * families_0[family_6].period_0);
}

fn integrals_along_0( family_7 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S94 : u32 = u32(3) * families_0[family_7].quantities_0;
    var _S95 : u32 = families_0[family_7].colour_threads_0 + _S94 * stretch_2.low_0.thread_2 + quantity_0;
    var _S96 : u32 = families_0[family_7].colour_threads_0 + _S94 * stretch_2.high_0.thread_2 + quantity_0;
    var _S97 : u32 = families_0[family_7].colour_threads_0 + _S94 * u32(families_0[family_7].count_0) + quantity_0;
    var _S98 : f32 = table_number_0(_S95);
    var _S99 : f32 = table_number_0(_S96);
    var _S100 : f32 = Stretch_turns_0(stretch_2);
    var _S101 : u32 = u32(2) * families_0[family_7].quantities_0;
    return vec2<f32>(table_number_0(_S96 + families_0[family_7].quantities_0) - table_number_0(_S95 + families_0[family_7].quantities_0) + _S99 * stretch_2.high_0.visible_0 * stretch_2.high_0.width_2 - _S98 * stretch_2.low_0.visible_0 * stretch_2.low_0.width_2 + _S100 * table_number_0(_S97 + families_0[family_7].quantities_0), table_number_0(_S96 + _S101) - table_number_0(_S95 + _S101) + _S99 * stretch_2.high_0.cell_2 - _S98 * stretch_2.low_0.cell_2 + _S100 * table_number_0(_S97 + _S101));
}

fn Stretch_wraps_0( this_2 : Stretch_0) -> bool
{
    return (this_2.high_0.thread_2) < (this_2.low_0.thread_2);
}

fn Stretch_differences_0( this_3 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S102 : u32 = entries_0.z;
    var _S103 : u32 = entries_0.x;
    var _S104 : u32 = _S102 - _S103;
    var _S105 : u32;
    if(Stretch_wraps_0(this_3))
    {
        _S105 = whole_0;
    }
    else
    {
        _S105 = u32(0);
    }
    return vec4<u32>(_S104 + _S105, entries_0.w - _S102, entries_0.y - _S103, whole_0);
}

fn row_differences_0( across_1 : Stretch_0,  row_1 : u32,  count_1 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S106 : u32 = row_1 + across_1.low_0.thread_2 * quantities_1;
    var _S107 : u32 = row_1 + across_1.high_0.thread_2 * quantities_1;
    return Stretch_differences_0(across_1, vec4<u32>(words_0[_S106], words_0[_S106 + quantities_1], words_0[_S107], words_0[_S107 + quantities_1]), words_0[row_1 + count_1 * quantities_1]);
}

fn Stretch_weights_0( this_4 : Stretch_0) -> vec4<f32>
{
    var _S108 : f32 = - this_4.low_0.visible_0;
    var _S109 : f32 = Stretch_turns_0(this_4);
    var _S110 : f32;
    if(Stretch_wraps_0(this_4))
    {
        _S110 = 1.0f;
    }
    else
    {
        _S110 = 0.0f;
    }
    return vec4<f32>(1.0f, this_4.high_0.visible_0, _S108, _S109 - _S110);
}

fn integral_on_top_0( family_8 : u32,  across_2 : Stretch_0,  along_0 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S111 : u32 = u32(families_0[family_8].count_0);
    var _S112 : u32 = (_S111 + u32(1)) * families_0[family_8].quantities_0;
    var _S113 : u32 = families_0[family_8].colour_areas_0 + quantity_1;
    var _S114 : vec4<u32> = row_differences_0(across_2, _S113 + along_0.low_0.thread_2 * _S112, _S111, families_0[family_8].quantities_0);
    var _S115 : vec4<u32> = row_differences_0(across_2, _S113 + (along_0.low_0.thread_2 + u32(1)) * _S112, _S111, families_0[family_8].quantities_0);
    var _S116 : vec4<u32> = row_differences_0(across_2, _S113 + along_0.high_0.thread_2 * _S112, _S111, families_0[family_8].quantities_0);
    var _S117 : vec4<u32> = row_differences_0(across_2, _S113 + (along_0.high_0.thread_2 + u32(1)) * _S112, _S111, families_0[family_8].quantities_0);
    var _S118 : vec4<u32> = row_differences_0(across_2, _S113 + crossing_count_0 * _S112, _S111, families_0[family_8].quantities_0);
    var _S119 : vec4<u32> = _S116 - _S114;
    var _S120 : vec4<u32>;
    if(Stretch_wraps_0(along_0))
    {
        _S120 = _S118;
    }
    else
    {
        _S120 = vec4<u32>(vec4<i32>(i32(0)));
    }
    var _S121 : vec4<f32> = Stretch_weights_0(across_2);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S119 + _S120)), _S121), dot(vec4<f32>(vec4<i32>(_S117 - _S116)), _S121), dot(vec4<f32>(vec4<i32>(_S115 - _S114)), _S121), dot(vec4<f32>(vec4<i32>(_S118)), _S121)), Stretch_weights_0(along_0)) * families_0[family_8].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_0 : f32,  row_2 : u32) -> Albedos_0
{
    var _S122 : Albedos_0 = table_albedos_0(row_2);
    var sum_0 : Albedos_0;
    var _S123 : vec3<f32> = vec3<f32>(weight_0);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S123 * _S122.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S123 * _S122.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S123 * _S122.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S123 * _S122.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_9 : u32,  crossing_0 : u32,  own_0 : Stretch_0,  other_0 : Stretch_0,  back_3 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_9].colour_mean_0);
    if((families_0[family_9].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S124 : vec3<f32> = lengths_0(crossing_0, other_0);
    var is_exposed_0 : bool = false;
    var weight_1 : f32 = 0.0f;
    var quantity_2 : u32 = u32(0);
    for(;;)
    {
        if(quantity_2 < (families_0[family_9].quantities_0))
        {
        }
        else
        {
            break;
        }
        var _S125 : vec2<f32> = integrals_along_0(family_9, own_0, quantity_2);
        var _S126 : f32 = integral_on_top_0(family_9, own_0, other_0, u32(families_0[crossing_0].count_0), quantity_2);
        var _S127 : f32 = _S125.x;
        var _S128 : f32 = _S127 * _S124.x;
        var _S129 : f32;
        if(back_3)
        {
            _S129 = _S128 - _S126;
        }
        else
        {
            _S129 = _S126;
        }
        var _S130 : bool = quantity_2 == u32(0);
        if(_S130)
        {
            is_exposed_0 = _S129 > (16.0f * families_0[family_9].area_unit_0 * min(_S128 / families_0[family_9].crossing_area_0, 1.0f) + 0.00000999999974738f * _S128);
        }
        var _S131 : f32 = _S127 * _S124.y;
        var _S132 : f32;
        if(is_exposed_0)
        {
            _S132 = _S129;
        }
        else
        {
            _S132 = 0.0f;
        }
        var _S133 : f32 = _S131 + _S132 + 0.000244140625f * _S124.z * _S125.y;
        if(_S130)
        {
            weight_1 = 1.0f / max(_S133, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S133 * weight_1, families_0[family_9].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn tinted_0( albedos_3 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_3;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
}

struct FaceRadiance_0
{
     warp_1 : vec3<f32>,
     weft_1 : vec3<f32>,
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
    var _S134 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S135 : vec3<f32> = sends_0.sky_warp_0 + _S134 * sends_0.crossing_warp_0;
    found_0.warp_1 = _S135;
    var _S136 : vec3<f32> = sends_0.sky_weft_0 + _S134 * sends_0.crossing_weft_0;
    found_0.weft_1 = _S136;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S135 + vec3<f32>(sends_0.blocks_weft_0) * _S136;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_2 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S137 : f32 = 1.0f - view_2.z;
    var _S138 : f32 = _S137 * _S137;
    (*terms_0)[i32(0)] = 1.0f;
    var _S139 : f32 = view_2.x;
    var _S140 : f32 = _S139 * _S139;
    var _S141 : f32 = view_2.y;
    var _S142 : f32 = _S141 * _S141;
    (*terms_0)[i32(1)] = sqrt(max(_S140 + _S142, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S138;
    (*terms_0)[i32(3)] = _S138 * _S138;
    (*terms_0)[i32(4)] = _S140 - _S142;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_3 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S143 : f32 = 1.0f - view_3.z;
    var _S144 : f32 = _S143 * _S143;
    (*terms_1)[i32(0)] = 1.0f;
    var _S145 : f32 = view_3.x;
    var _S146 : f32 = _S145 * _S145;
    var _S147 : f32 = view_3.y;
    var _S148 : f32 = _S147 * _S147;
    (*terms_1)[i32(1)] = sqrt(max(_S146 + _S148, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S144;
    (*terms_1)[i32(3)] = _S144 * _S144;
    (*terms_1)[i32(4)] = _S146 - _S148;
    (*terms_1)[i32(5)] = 0.0f;
    return;
}

struct Blocked_0
{
     by_warp_0 : f32,
     by_weft_0 : f32,
     far_0 : f32,
};

fn scaled_0( blocked_0 : Blocked_0,  share_1 : f32) -> Blocked_0
{
    var result_1 : Blocked_0;
    result_1.by_warp_0 = share_1 * blocked_0.by_warp_0;
    result_1.by_weft_0 = share_1 * blocked_0.by_weft_0;
    result_1.far_0 = share_1 * blocked_0.far_0;
    return result_1;
}

struct Bounced_0
{
     reflected_0 : vec3<f32>,
     transmitted_0 : vec3<f32>,
};

struct Scattered_0
{
     back_4 : vec3<f32>,
     through_0 : vec3<f32>,
};

struct Interior_0
{
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_1 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S149 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S150 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_2 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_2) + _S150 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S150 * interior_0.far_1 + yarn_0.back_4 * _S149;
    return bounced_0;
}

fn sum_of_0( first_3 : Bounced_0,  second_0 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_3.reflected_0 + second_0.reflected_0;
    sum_1.transmitted_0 = first_3.transmitted_0 + second_0.transmitted_0;
    return sum_1;
}

fn summed_0( tables_1 : ptr<function, Clustered_std430_0>,  first_4 : u32,  column_0 : u32,  row_3 : u32) -> i32
{
    return i32(words_0[first_4 + (row_3 * ((*tables_1).columns_0 + u32(1)) + column_0) * (*tables_1).channels_0]);
}

fn box_mean_0( tables_2 : ptr<function, Clustered_std430_0>,  box_1 : TexelBox_0,  face_1 : u32,  channel_0 : u32) -> f32
{
    var _S151 : u32 = (*tables_2).columns_0;
    var _S152 : u32 = (*tables_2).rows_0;
    var _S153 : u32 = (*tables_2).sums_0 + face_1 * ((*tables_2).columns_0 + u32(1)) * ((*tables_2).rows_0 + u32(1)) * (*tables_2).channels_0 + channel_0;
    var _S154 : u32 = box_1.last_0.x;
    var _S155 : u32 = box_1.first_2.y;
    var _S156 : i32 = summed_0(&((*tables_2)), _S153, _S154, _S155);
    var _S157 : u32 = box_1.first_2.x;
    var _S158 : i32 = summed_0(&((*tables_2)), _S153, _S157, _S155);
    var _S159 : i32 = _S156 - _S158;
    var _S160 : u32 = box_1.last_0.y;
    var _S161 : i32 = summed_0(&((*tables_2)), _S153, _S154, _S160);
    var _S162 : i32 = summed_0(&((*tables_2)), _S153, _S157, _S160);
    var total_0 : f32 = f32(_S161 - _S162 - _S159);
    var _S163 : f32 = box_1.turns_0.x;
    var _S164 : bool = _S163 > 0.0f;
    var total_1 : f32;
    if(_S164)
    {
        var _S165 : i32 = summed_0(&((*tables_2)), _S153, _S151, _S160);
        var _S166 : i32 = summed_0(&((*tables_2)), _S153, _S151, _S155);
        total_1 = total_0 + _S163 * f32(_S165 - _S166);
    }
    else
    {
        total_1 = total_0;
    }
    var _S167 : f32 = box_1.turns_0.y;
    var _S168 : bool = _S167 > 0.0f;
    if(_S168)
    {
        var _S169 : i32 = summed_0(&((*tables_2)), _S153, _S154, _S152);
        var _S170 : i32 = summed_0(&((*tables_2)), _S153, _S157, _S152);
        total_1 = total_1 + _S167 * f32(_S169 - _S170);
    }
    var _S171 : bool;
    if(_S164)
    {
        _S171 = _S168;
    }
    else
    {
        _S171 = false;
    }
    if(_S171)
    {
        var _S172 : f32 = _S163 * _S167;
        var _S173 : i32 = summed_0(&((*tables_2)), _S153, _S151, _S152);
        total_1 = total_1 + _S172 * f32(_S173);
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

fn Albedos_x24init_0( diffuse_reflect_1 : vec3<f32>,  diffuse_transmit_1 : vec3<f32>,  specular_reflect_1 : vec3<f32>,  specular_transmit_1 : vec3<f32>) -> Albedos_0
{
    var _S174 : Albedos_0;
    _S174.diffuse_reflect_0 = diffuse_reflect_1;
    _S174.diffuse_transmit_0 = diffuse_transmit_1;
    _S174.specular_reflect_0 = specular_reflect_1;
    _S174.specular_transmit_0 = specular_transmit_1;
    return _S174;
}

struct YarnPoint_0
{
     back_5 : bool,
     hole_0 : bool,
     is_warp_0 : bool,
     x_8 : f32,
     y_3 : f32,
     height_2 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_0 : f32,
     roughness_1 : f32,
     albedos_4 : Albedos_0,
};

fn YarnPoint_x24init_0( back_6 : bool,  hole_1 : bool,  is_warp_1 : bool,  x_9 : f32,  y_4 : f32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  surface_normal_1 : vec3<f32>,  diffuse_gain_1 : f32,  roughness_2 : f32,  albedos_5 : Albedos_0) -> YarnPoint_0
{
    var _S175 : YarnPoint_0;
    _S175.back_5 = back_6;
    _S175.hole_0 = hole_1;
    _S175.is_warp_0 = is_warp_1;
    _S175.x_8 = x_9;
    _S175.y_3 = y_4;
    _S175.height_2 = height_3;
    _S175.normal_1 = normal_2;
    _S175.tangent_0 = tangent_1;
    _S175.surface_normal_0 = surface_normal_1;
    _S175.diffuse_gain_0 = diffuse_gain_1;
    _S175.roughness_1 = roughness_2;
    _S175.albedos_4 = albedos_5;
    return _S175;
}

struct ResidualPoint_0
{
     point_1 : YarnPoint_0,
     texel_0 : u32,
};

fn ResidualPoint_x24init_0( point_2 : YarnPoint_0,  texel_1 : u32) -> ResidualPoint_0
{
    var _S176 : ResidualPoint_0;
    _S176.point_1 = point_2;
    _S176.texel_0 = texel_1;
    return _S176;
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

struct Shown_0
{
     is_warp_2 : bool,
     hole_2 : bool,
     on_top_0 : bool,
     word_0 : u32,
};

struct Crossing_0
{
     warp_3 : Cell_0,
     weft_3 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_1 : Crossing_0,  back_7 : bool) -> Shown_0
{
    var _S177 : bool = (abs(crossing_1.warp_3.across_0)) < (crossing_1.warp_3.half_width_1);
    var _S178 : bool = (abs(crossing_1.weft_3.across_0)) < (crossing_1.weft_3.half_width_1);
    var shown_0 : Shown_0;
    var _S179 : bool;
    if(_S177)
    {
        if(!_S178)
        {
            _S179 = true;
        }
        else
        {
            _S179 = crossing_1.warp_above_0;
        }
    }
    else
    {
        _S179 = false;
    }
    shown_0.is_warp_2 = _S179;
    if(!_S177)
    {
        _S179 = !_S178;
    }
    else
    {
        _S179 = false;
    }
    shown_0.hole_2 = _S179;
    var _S180 : u32;
    if(shown_0.is_warp_2)
    {
        _S180 = crossing_1.warp_word_0;
    }
    else
    {
        _S180 = crossing_1.weft_word_0;
    }
    shown_0.word_0 = _S180;
    shown_0.on_top_0 = (((_S180 & (u32(1)))) == u32(1)) != back_7;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_5 : Cell_0,  second_1 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    var _S181 : u32;
    if(is_first_0)
    {
        _S181 = first_5.thread_0;
    }
    else
    {
        _S181 = second_1.thread_0;
    }
    cell_3.thread_0 = _S181;
    var _S182 : f32;
    if(is_first_0)
    {
        _S182 = first_5.across_0;
    }
    else
    {
        _S182 = second_1.across_0;
    }
    cell_3.across_0 = _S182;
    if(is_first_0)
    {
        _S182 = first_5.half_width_1;
    }
    else
    {
        _S182 = second_1.half_width_1;
    }
    cell_3.half_width_1 = _S182;
    if(is_first_0)
    {
        _S182 = first_5.below_0;
    }
    else
    {
        _S182 = second_1.below_0;
    }
    cell_3.below_0 = _S182;
    if(is_first_0)
    {
        _S182 = first_5.above_0;
    }
    else
    {
        _S182 = second_1.above_0;
    }
    cell_3.above_0 = _S182;
    return cell_3;
}

fn boundary_0( family_10 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S183 : vec2<f32> = turns_and_remainder_0(family_10, f32(i32(thread_3) + step_0));
    return fma(_S183.x, families_0[family_10].period_0, table_number_0(families_0[family_10].place_table_0 + u32(_S183.y) * u32(4)));
}

fn span_0( family_11 : u32,  thread_4 : u32,  first_6 : i32,  last_1 : i32) -> f32
{
    if((families_0[family_11].is_alike_0) != u32(0))
    {
        return f32(last_1 - first_6) * families_0[family_11].size_0;
    }
    return boundary_0(family_11, thread_4, last_1) - boundary_0(family_11, thread_4, first_6);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_12 : u32,  thread_5 : u32) -> Bend_0
{
    var _S184 : u32 = families_0[family_12].bend_table_0;
    var _S185 : u32;
    if((families_0[family_12].is_alike_0) != u32(0))
    {
        _S185 = u32(0);
    }
    else
    {
        _S185 = thread_5 * u32(4);
    }
    var _S186 : u32 = _S184 + _S185;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S186);
    bend_0.half_tangent_0 = table_number_0(_S186 + u32(1));
    bend_0.arc_0 = table_number_0(_S186 + u32(2));
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

fn unpack_0( own_1 : u32,  other_1 : u32,  thread_6 : u32,  crossed_0 : Cell_0,  word_1 : u32) -> Run_0
{
    var _S187 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S188 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S189 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S190 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S191 : i32 = - _S187;
    var _S192 : f32 = crossed_0.below_0 + span_0(other_1, crossed_0.thread_0, _S191, i32(0));
    run_0.from_start_0 = _S192;
    var _S193 : i32 = _S188 + i32(1);
    var _S194 : f32 = crossed_0.above_0 + span_0(other_1, crossed_0.thread_0, i32(1), _S193);
    run_0.to_end_0 = _S194;
    var _S195 : bool = _S192 < _S194;
    run_0.near_start_0 = _S195;
    var _S196 : i32;
    if(_S195)
    {
        _S196 = _S191 - _S189;
    }
    else
    {
        _S196 = _S193;
    }
    var _S197 : i32;
    if(run_0.near_start_0)
    {
        _S197 = _S191;
    }
    else
    {
        _S197 = _S193 + _S190;
    }
    run_0.bend_1 = bend_of_0(own_1, thread_6);
    var _S198 : f32;
    if(run_0.straight_0)
    {
        _S198 = 1.0e+06f;
    }
    else
    {
        _S198 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S198;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_1, crossed_0.thread_0, _S196, _S197), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S187 == i32(0);
    run_0.last_crossing_0 = _S188 == i32(0);
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
    var _S199 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S200 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S200;
    var _S201 : f32 = _S199 * _S199 - square_1(_S200);
    var _S202 : f32 = rsqrt_0(_S201);
    section_0.drop_0 = _S199 - _S201 * _S202;
    section_0.slope_0 = - _S200 * _S202;
    return section_0;
}

fn edge_drop_0( family_13 : u32,  thread_7 : u32,  step_1 : i32) -> f32
{
    if((families_0[family_13].is_alike_0) != u32(0))
    {
        return table_number_0(families_0[family_13].bend_table_0 + u32(3));
    }
    return table_number_0(families_0[family_13].bend_table_0 + u32(turns_and_remainder_0(family_13, f32(i32(thread_7) + step_1)).y) * u32(4) + u32(3));
}

fn dive_0( other_2 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S203 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S204 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S205 : f32;
    if(_S203)
    {
        _S205 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S205 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S206 : f32 = _S205 - crossed_1.half_width_1;
    var _S207 : bool;
    if(_S203)
    {
        _S207 = run_1.first_crossing_0;
    }
    else
    {
        _S207 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S205 = 0.0f;
    }
    else
    {
        _S205 = families_0[other_2].height_scale_0 * edge_drop_0(other_2, crossed_1.thread_0, i32(0));
    }
    var _S208 : f32;
    if((shown_1.on_top_0) != _S207)
    {
        _S208 = 0.0f;
    }
    else
    {
        var _S209 : f32 = families_0[other_2].height_scale_0;
        var _S210 : i32;
        if(_S203)
        {
            _S210 = i32(-1);
        }
        else
        {
            _S210 = i32(1);
        }
        _S208 = _S209 * edge_drop_0(other_2, crossed_1.thread_0, _S210);
    }
    var _S211 : f32 = 1.0f / max(2.0f * _S206, 9.999999960041972e-13f);
    var _S212 : f32 = clamp((_S206 - _S204) * _S211, 0.0f, 1.0f);
    var _S213 : f32 = _S205 + (_S208 - _S205) * (_S212 * _S212 * (3.0f - 2.0f * _S212));
    var _S214 : f32 = (_S205 - _S208) * (6.0f * _S212 * (1.0f - _S212) * _S211);
    if(_S203)
    {
        _S205 = 1.0f;
    }
    else
    {
        _S205 = -1.0f;
    }
    return vec2<f32>(_S213, _S214 * _S205);
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

fn step_control_0( direction_3 : vec2<f32>,  step_3 : f32) -> StepControl_0
{
    var control_0 : StepControl_0;
    control_0.step_2 = step_3;
    control_0.epsilon_0 = 0.00499999988824129f * step_3;
    var _S215 : f32 = direction_3.x;
    control_0.per_x_0 = 1.0f / max(abs(_S215), 9.99999971718068537e-10f);
    var _S216 : f32 = direction_3.y;
    control_0.per_y_0 = 1.0f / max(abs(_S216), 9.99999971718068537e-10f);
    control_0.right_0 = _S215 > 0.0f;
    control_0.up_0 = _S216 > 0.0f;
    return control_0;
}

struct PreviousSample_0
{
     clearance_0 : f32,
     rate_0 : f32,
     yarn_1 : u32,
     known_0 : bool,
};

fn no_previous_sample_0() -> PreviousSample_0
{
    var previous_0 : PreviousSample_0;
    previous_0.clearance_0 = 0.0f;
    previous_0.rate_0 = 0.0f;
    previous_0.yarn_1 = u32(0);
    previous_0.known_0 = false;
    return previous_0;
}

fn outline_distance_0( cell_5 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S217 : f32;
    if(forwards_0)
    {
        _S217 = cell_5.across_0;
    }
    else
    {
        _S217 = - cell_5.across_0;
    }
    var _S218 : f32;
    if(forwards_0)
    {
        _S218 = cell_5.above_0;
    }
    else
    {
        _S218 = cell_5.below_0;
    }
    var _S219 : bool;
    if(forwards_0)
    {
        _S219 = run_2.last_crossing_0;
    }
    else
    {
        _S219 = run_2.first_crossing_0;
    }
    var _S220 : bool;
    if(forwards_0)
    {
        _S220 = run_2.first_crossing_0;
    }
    else
    {
        _S220 = run_2.last_crossing_0;
    }
    var _S221 : f32 = - cell_5.half_width_1;
    var _S222 : bool = _S217 < _S221;
    var _S223 : bool = _S217 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S219 = !_S219;
    }
    else
    {
        _S219 = false;
    }
    if(_S219)
    {
        _S219 = !shown_2.hole_2;
    }
    else
    {
        _S219 = false;
    }
    var _S224 : bool;
    if(_S219)
    {
        _S224 = shown_2.on_top_0;
    }
    else
    {
        _S224 = false;
    }
    if(_S224)
    {
        if(_S220)
        {
            _S220 = _S222;
        }
        else
        {
            _S220 = false;
        }
        _S220 = !_S220;
    }
    else
    {
        _S220 = false;
    }
    if(shown_2.hole_2)
    {
        _S219 = true;
    }
    else
    {
        if(_S219)
        {
            _S219 = !shown_2.on_top_0;
        }
        else
        {
            _S219 = false;
        }
    }
    var _S225 : f32;
    if(_S222)
    {
        _S225 = _S221;
    }
    else
    {
        _S225 = cell_5.half_width_1;
    }
    var _S226 : f32 = _S225 - _S217;
    if(_S219)
    {
        _S217 = 2.0f * _S218 + _S217 - cell_5.half_width_1;
    }
    else
    {
        _S217 = _S218;
    }
    if(_S220)
    {
        if(forwards_0)
        {
            _S217 = run_2.to_end_0;
        }
        else
        {
            _S217 = run_2.from_start_0;
        }
        return _S217;
    }
    if(_S223)
    {
    }
    else
    {
        _S217 = _S226;
    }
    return _S217;
}

struct Probe_0
{
     height_4 : f32,
     hole_3 : bool,
     slope_x_0 : f32,
     slope_y_0 : f32,
     yarn_2 : u32,
     cell_max_0 : f32,
     side_x_0 : f32,
     side_y_0 : f32,
     edge_x_0 : f32,
     edge_y_0 : f32,
};

fn way_back_to_dip_0( previous_1 : PreviousSample_0,  clearance_1 : f32,  rate_1 : f32,  step_4 : f32,  here_0 : Probe_0) -> f32
{
    var _S227 : f32 = previous_1.rate_0 * step_4;
    var _S228 : f32 = rate_1 * step_4;
    var _S229 : bool;
    if(!previous_1.known_0)
    {
        _S229 = true;
    }
    else
    {
        _S229 = here_0.hole_3;
    }
    if(_S229)
    {
        _S229 = true;
    }
    else
    {
        _S229 = (previous_1.yarn_1) != (here_0.yarn_2);
    }
    if(_S229)
    {
        _S229 = true;
    }
    else
    {
        _S229 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S229)
    {
        _S229 = true;
    }
    else
    {
        _S229 = rate_1 <= 0.0f;
    }
    if(_S229)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S227) >= 0.0f)
    {
        _S229 = (3.0f * clearance_1 - _S228) >= 0.0f;
    }
    else
    {
        _S229 = false;
    }
    if(_S229)
    {
        return -1.0f;
    }
    var _S230 : f32 = clearance_1 - previous_1.clearance_0;
    var _S231 : f32 = 6.0f * _S230 - 4.0f * _S227 - 2.0f * _S228;
    var _S232 : f32 = -2.0f * _S227 / max(_S231 + sqrt(max(_S231 * _S231 - 4.0f * (3.0f * (_S227 + _S228 - 2.0f * _S230)) * _S227, 0.0f)), 9.99999968265522539e-21f);
    var _S233 : f32 = 1.0f - _S232;
    var _S234 : f32 = (previous_1.clearance_0 * (2.0f * _S232 + 1.0f) + _S227 * _S232) * _S233 * _S233;
    var _S235 : f32 = (clearance_1 * (2.0f * _S233 + 1.0f) - _S228 * _S233) * _S232 * _S232;
    if(_S232 > 0.01999999955296516f)
    {
        _S229 = _S233 > 0.01999999955296516f;
    }
    else
    {
        _S229 = false;
    }
    if(_S229)
    {
        _S229 = (_S234 + _S235) < 0.0f;
    }
    else
    {
        _S229 = false;
    }
    var _S236 : f32;
    if(_S229)
    {
        _S236 = _S233 * step_4;
    }
    else
    {
        _S236 = -1.0f;
    }
    return _S236;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S237 : f32;
    if(here_1.hole_3)
    {
        _S237 = 1.0e+09f;
    }
    else
    {
        _S237 = clearance_2;
    }
    previous_2.clearance_0 = _S237;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_1 = here_1.yarn_2;
    var _S238 : bool;
    if(!here_1.hole_3)
    {
        _S238 = !is_cell_exit_0;
    }
    else
    {
        _S238 = false;
    }
    previous_2.known_0 = _S238;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_5 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_5.per_x_0, side_y_1 * this_5.per_y_0), 0.0f) + this_5.epsilon_0;
}

fn StepControl_to_next_sample_0( this_6 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S239 : f32 = min(here_2.edge_x_0 * this_6.per_x_0, here_2.edge_y_0 * this_6.per_y_0);
    var _S240 : bool;
    if(!here_2.hole_3)
    {
        _S240 = (rate_3 * _S239 + clearance_3) < 0.0f;
    }
    else
    {
        _S240 = false;
    }
    if(_S240)
    {
        _S240 = _S239 > (2.0f * this_6.epsilon_0);
    }
    else
    {
        _S240 = false;
    }
    var _S241 : f32;
    if(_S240)
    {
        _S241 = _S239 - this_6.epsilon_0;
    }
    else
    {
        _S241 = max(_S239, 0.0f) + this_6.epsilon_0;
    }
    return min(this_6.step_2, _S241);
}

struct ViewRay_0
{
     origin_0 : vec2<f32>,
     slope_1 : vec2<f32>,
};

fn ViewRay_at_0( this_7 : ViewRay_0,  height_5 : f32) -> vec2<f32>
{
    return this_7.origin_0 + this_7.slope_1 * vec2<f32>(height_5);
}

fn ViewRay_rate_0( this_8 : ViewRay_0,  here_3 : Probe_0) -> f32
{
    return here_3.slope_x_0 * this_8.slope_1.x + here_3.slope_y_0 * this_8.slope_1.y - 1.0f;
}

fn cubic_root_0( start_1 : f32,  end_0 : f32,  start_rate_0 : f32,  end_rate_0 : f32) -> f32
{
    var _S242 : f32 = end_0 - start_1;
    var _S243 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S242;
    var _S244 : f32 = 3.0f * _S242 - 2.0f * start_rate_0 - end_rate_0;
    var share_2 : f32 = start_1 / max(- _S242, 9.99999968265522539e-21f);
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
        var _S245 : f32 = clamp(share_2 - (((_S243 * share_2 + _S244) * share_2 + start_rate_0) * share_2 + start_1) / min((3.0f * _S243 * share_2 + 2.0f * _S244) * share_2 + start_rate_0, 0.10000000149011612f * _S242 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S246 : i32 = i_0 + i32(1);
        share_2 = _S245;
        i_0 = _S246;
    }
    return share_2;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S247 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S248 : f32 = rsqrt_0(_S247);
    var _S249 : f32 = sine_1 * _S248 * rsqrt_0(_S247 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S249 * _S247, _S249 * across_slope_0 * along_slope_0 + cosine_0 * _S248);
}

fn arc_sine_0( x_10 : f32) -> f32
{
    var _S250 : f32 = abs(x_10);
    var _S251 : bool = _S250 > 0.5f;
    var _S252 : f32;
    if(_S251)
    {
        _S252 = 0.5f * (1.0f - _S250);
    }
    else
    {
        _S252 = _S250 * _S250;
    }
    var _S253 : f32;
    if(_S251)
    {
        _S253 = sqrt(max(_S252, 0.0f));
    }
    else
    {
        _S253 = _S250;
    }
    var _S254 : f32 = ((((0.04216320067644119f * _S252 + 0.02418131195008755f) * _S252 + 0.04547002539038658f) * _S252 + 0.07495300471782684f) * _S252 + 0.16666752099990845f) * _S252 * _S253 + _S253;
    if(_S251)
    {
        _S252 = 1.57079637050628662f - 2.0f * _S254;
    }
    else
    {
        _S252 = _S254;
    }
    if(x_10 < 0.0f)
    {
        _S252 = - _S252;
    }
    return _S252;
}

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S255 : Hair_0;
    _S255.cover_0 = cover_1;
    _S255.normal_3 = normal_4;
    _S255.tangent_2 = tangent_3;
    return _S255;
}

fn fade_0( size_3 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_3 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S256 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S257 : u32 = ((((_S256 >> ((((_S256 >> (u32(28)))) + u32(4))))) ^ (_S256))) * u32(277803737);
    return (((_S257 >> (u32(22)))) ^ (_S257));
}

fn hash_key_0( thread_8 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_8 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_6 : u32) -> u32
{
    return scramble_0(cell_6 + key_0);
}

fn share_of_0( bits_2 : u32) -> f32
{
    return (f32((bits_2 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_11 : f32) -> vec2<f32>
{
    var _S258 : f32 = floor(x_11 * 0.63661974668502808f + 0.5f);
    var _S259 : f32 = x_11 - _S258 * 1.5703125f - _S258 * 0.00048375129699707f - _S258 * 7.54979012640433211e-08f;
    var _S260 : f32 = _S259 * _S259;
    var _S261 : f32 = ((-0.00019515295571182f * _S260 + 0.00833216123282909f) * _S260 - 0.16666655242443085f) * _S260 * _S259 + _S259;
    var _S262 : f32 = ((0.00002443315679557f * _S260 - 0.00138873164542019f) * _S260 + 0.04166664555668831f) * _S260 * _S260 - 0.5f * _S260 + 1.0f;
    var _S263 : u32 = (u32(i32(_S258)) & (u32(3)));
    var _S264 : vec2<f32>;
    if(((_S263 & (u32(1)))) != u32(0))
    {
        _S264 = vec2<f32>(_S262, _S261);
    }
    else
    {
        _S264 = vec2<f32>(_S261, _S262);
    }
    var _S265 : f32;
    if(((_S263 & (u32(2)))) != u32(0))
    {
        _S265 = - _S264.x;
    }
    else
    {
        _S265 = _S264.x;
    }
    var _S266 : f32;
    if((((_S263 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S266 = - _S264.y;
    }
    else
    {
        _S266 = _S264.y;
    }
    return vec2<f32>(_S265, _S266);
}

fn albedos_of_0( family_14 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_14].albedo_table_0 + families_0[family_14].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_4 : f32,  along_1 : f32,  width_3 : f32) -> vec3<f32>
{
    var _S267 : f32 = floor(across_4 / width_3);
    return vec3<f32>(_S267, along_1 / (width_3 * 40.0f) + 0.61799997091293335f * _S267, 2.0f * (across_4 / width_3 - _S267) - 1.0f);
}

struct SurfacePoint_0
{
     hole_4 : bool,
     is_warp_3 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_6 : f32,
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     across_5 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn ply_offset_0( family_15 : u32,  point_3 : SurfacePoint_0,  back_8 : bool) -> f32
{
    var _S268 : f32;
    if(back_8)
    {
        _S268 = - families_0[family_15].ply_sine_0;
    }
    else
    {
        _S268 = families_0[family_15].ply_sine_0;
    }
    var _S269 : f32 = (point_3.fibre_across_0 * families_0[family_15].ply_cosine_0 + point_3.fibre_along_0 * _S268) * families_0[family_15].plies_per_mm_0;
    return 2.0f * (_S269 - floor(_S269)) - 1.0f;
}

fn signed_noise_0( bits_3 : u32) -> f32
{
    return (f32((bits_3 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_3 : f32) -> f32
{
    return share_3 * share_3 * (3.0f - 2.0f * share_3);
}

fn wave_noise_0( key_1 : u32,  position_5 : f32) -> vec2<f32>
{
    var _S270 : f32 = floor(position_5);
    var _S271 : f32 = position_5 - _S270;
    var _S272 : u32 = u32(i32(_S270));
    var _S273 : f32 = signed_noise_0(hash_bits_0(key_1, _S272));
    var _S274 : f32 = signed_noise_0(hash_bits_0(key_1, _S272 + u32(1)));
    return vec2<f32>(mix(_S273, _S274, smooth_share_0(_S271)), 6.0f * _S271 * (1.0f - _S271) * (_S274 - _S273));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S275 : f32 = cell_7.y;
    var _S276 : f32 = floor(_S275);
    var _S277 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S276));
    var _S278 : u32 = hash_bits_0(key_2, _S277);
    var _S279 : u32 = hash_bits_0(key_2, _S277 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S278), signed_noise_0((_S278 >> (u32(16))))), vec2<f32>(signed_noise_0(_S279), signed_noise_0((_S279 >> (u32(16))))), vec2<f32>(smooth_share_0(_S275 - _S276)));
}

fn uniform_hash_0( thread_10 : u32,  cell_8 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_10, stream_1), cell_8)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn thread_gain_0( thread_11 : u32,  amount_0 : f32,  seed_2 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_11, u32(0), (seed_2 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S280 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S280.x, _S280.y), _S280.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S281 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S281.x, _S281.y), _S281.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_12 : u32,  cell_9 : u32,  amount_1 : f32,  seed_3 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_12, cell_9, (seed_3 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_6 : vec3<f32>,
     tangent_5 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S282 : vec3<f32>;
    if((dot(frame_0.tangent_5, hair_0.tangent_2)) < 0.0f)
    {
        _S282 = (vec3<f32>(0) - hair_0.tangent_2);
    }
    else
    {
        _S282 = hair_0.tangent_2;
    }
    var blended_0 : YarnFrame_0;
    var _S283 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S284 : vec3<f32> = normalize(mix(frame_0.normal_6, hair_0.normal_3, _S283));
    blended_0.normal_6 = _S284;
    var _S285 : vec3<f32> = mix(frame_0.tangent_5, _S282, _S283);
    var _S286 : vec3<f32> = _S285 - vec3<f32>(dot(_S285, _S284)) * _S284;
    blended_0.tangent_5 = _S286 * vec3<f32>(rsqrt_0(max(dot(_S286, _S286), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_2( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_6.z - 1.0f) + 1.0f));
}

fn texel_along_0( share_4 : f32,  first_7 : u32,  extent_1 : f32,  count_2 : u32) -> u32
{
    var _S287 : f32 = min(floor(share_4 * extent_1), extent_1 - 1.0f);
    var _S288 : f32 = f32(count_2);
    var _S289 : u32 = first_7 + min(u32(max(_S287 - floor(_S287 / _S288) * _S288, 0.0f)), count_2 - u32(1));
    var _S290 : u32;
    if(_S289 >= count_2)
    {
        _S290 = _S289 - count_2;
    }
    else
    {
        _S290 = _S289;
    }
    return _S290;
}

fn texel_of_0( tables_3 : ptr<function, Clustered_std430_0>,  box_2 : TexelBox_0,  share_5 : vec2<f32>) -> u32
{
    return texel_along_0(share_5.y, box_2.first_2.y, box_2.extent_0.y, (*tables_3).rows_0) * (*tables_3).columns_0 + texel_along_0(share_5.x, box_2.first_2.x, box_2.extent_0.x, (*tables_3).columns_0);
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_4 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S291 : u32 = pixel_0.x;
    var _S292 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S291, _S292, stream_2), uniform_hash_0(_S291, _S292, stream_2 + u32(1))) + vec2<f32>(f32((index_4 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_5 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_5])));
}

struct Choice_0
{
     index_6 : u32,
     remainder_0 : f32,
};

fn choose_0( table_1 : u32,  count_3 : u32,  number_1 : f32) -> Choice_0
{
    var high_1 : u32 = count_3;
    var low_1 : u32 = u32(0);
    for(;;)
    {
        if((high_1 - low_1) > u32(1))
        {
        }
        else
        {
            break;
        }
        var _S293 : u32 = (low_1 + high_1) / u32(2);
        if((scene_number_0(table_1 + _S293)) <= number_1)
        {
            low_1 = _S293;
        }
        else
        {
            high_1 = _S293;
        }
    }
    var _S294 : u32 = table_1 + low_1;
    var _S295 : f32 = scene_number_0(_S294);
    var _S296 : f32 = scene_number_0(_S294 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_1;
    choice_0.remainder_0 = saturate((number_1 - _S295) / max(_S296 - _S295, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

struct BaseTaps_0
{
     facing_0 : vec3<f32>,
     transmits_1 : bool,
     around_0 : BinTaps_0,
     first_8 : u32,
     half_vector_0 : BinTaps_0,
};

struct ViewedBase_0
{
     view_4 : vec3<f32>,
     back_9 : bool,
     face_2 : u32,
     around_1 : BinTaps_0,
     box_3 : TexelBox_0,
     trust_1 : vec2<f32>,
};

fn base_taps_0( seen_0 : ViewedBase_0,  light_1 : vec3<f32>) -> BaseTaps_0
{
    var taps_1 : BaseTaps_0;
    var _S297 : vec3<f32> = to_face_frame_0(light_1, seen_0.back_9);
    taps_1.facing_0 = _S297;
    var _S298 : f32 = _S297.z;
    var _S299 : bool = _S298 < 0.0f;
    taps_1.transmits_1 = _S299;
    taps_1.around_0 = bin_taps_0(vec3<f32>(_S297.xy, abs(_S298)), u32(32));
    var _S300 : u32 = seen_0.face_2 * u32(2);
    var _S301 : u32;
    if(_S299)
    {
        _S301 = u32(1);
    }
    else
    {
        _S301 = u32(0);
    }
    taps_1.first_8 = (_S300 + _S301) * u32(1024);
    var _S302 : vec3<f32> = taps_1.facing_0 + seen_0.view_4;
    var half_vector_1 : vec3<f32> = _S302 * vec3<f32>((1.0f / sqrt(max(square_0(_S302), 9.999999960041972e-13f))));
    var half_vector_2 : vec3<f32>;
    if((half_vector_1.z) < 0.0f)
    {
        half_vector_2 = (vec3<f32>(0) - half_vector_1);
    }
    else
    {
        half_vector_2 = half_vector_1;
    }
    taps_1.half_vector_0 = bin_taps_0(half_vector_2, u32(32));
    return taps_1;
}

struct Components_0
{
     diffuse_warp_0 : f32,
     diffuse_weft_0 : f32,
     specular_warp_0 : f32,
     specular_weft_0 : f32,
     light_visibility_1 : f32,
     hole_5 : f32,
};

fn no_components_0() -> Components_0
{
    var nothing_0 : Components_0;
    nothing_0.diffuse_warp_0 = 0.0f;
    nothing_0.diffuse_weft_0 = 0.0f;
    nothing_0.specular_warp_0 = 0.0f;
    nothing_0.specular_weft_0 = 0.0f;
    nothing_0.light_visibility_1 = 0.0f;
    nothing_0.hole_5 = 0.0f;
    return nothing_0;
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S303 : f32 = dot(direction_4, tangent_6);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S303 * _S303 + 1.0f, roughness_3 * roughness_3));
}

struct FamilyAlbedos_0
{
     warp_4 : Albedos_0,
     weft_4 : Albedos_0,
};

fn shaded_0( components_0 : Components_0,  albedos_6 : FamilyAlbedos_0,  transmits_2 : bool) -> vec3<f32>
{
    if(transmits_2)
    {
        return albedos_6.warp_4.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_6.weft_4.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_6.warp_4.specular_transmit_0 * vec3<f32>(components_0.specular_warp_0) + albedos_6.weft_4.specular_transmit_0 * vec3<f32>(components_0.specular_weft_0);
    }
    return albedos_6.warp_4.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_6.weft_4.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_6.warp_4.specular_reflect_0 * vec3<f32>(components_0.specular_warp_0) + albedos_6.weft_4.specular_reflect_0 * vec3<f32>(components_0.specular_weft_0);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_2 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S304 : f32 = light_2.z;
    var _S305 : vec3<f32>;
    if((_S304 * view_5.z) < 0.0f)
    {
        _S305 = bounced_1.transmitted_0;
    }
    else
    {
        _S305 = bounced_1.reflected_0;
    }
    return _S305 * vec3<f32>((abs(_S304) * 0.31830987334251404f));
}

fn sheen_scale_0( x_12 : f32,  y_5 : f32) -> f32
{
    return (((((0.0f * x_12 + (((((-1.1402510404586792f * y_5 + 0.40672621130943298f) * y_5 + 1.65398800373077393f) * y_5 + -1.29730904102325439f) * y_5 + 0.30570998787879944f) * y_5 + -0.0220868494361639f)) * x_12 + (((((-0.21142719686031342f * y_5 + 1.05947399139404297f) * y_5 + -0.41116121411323547f) * y_5 + -0.93859231472015381f) * y_5 + 0.51606941223144531f) * y_5 + 0.05409301072359085f)) * x_12 + (((((1.22944498062133789f * y_5 + -0.45962560176849365f) * y_5 + -1.63861405849456787f) * y_5 + 1.33565104007720947f) * y_5 + -0.45725581049919128f) * y_5 + 0.08243165910243988f)) * x_12 + (((((0.39779931306838989f * y_5 + -1.18879103660583496f) * y_5 + 0.28251591324806213f) * y_5 + 1.168984055519104f) * y_5 + -0.76864629983901978f) * y_5 + 0.0091691892594099f)) * x_12 + (((((-0.26563560962677002f * y_5 + -0.19379159808158875f) * y_5 + 0.2677634060382843f) * y_5 + 0.00270519289188087f) * y_5 + 0.14349560439586639f) * y_5 + 0.10290180146694183f)) * x_12 + (((((-0.20701569318771362f * y_5 + 0.24526430666446686f) * y_5 + 0.19551840424537659f) * y_5 + 0.07586126774549484f) * y_5 + 0.38894739747047424f) * y_5 + 0.15043120086193085f);
}

fn sheen_shear_0( x_13 : f32,  y_6 : f32) -> f32
{
    return ((((0.0f * x_13 + (((((-0.10608240216970444f * y_6 + 1.99214303493499756f) * y_6 + -1.42255294322967529f) * y_6 + -1.09495604038238525f) * y_6 + 0.59180057048797607f) * y_6 + 0.06902855634689331f)) * x_13 + (((((-0.46220690011978149f * y_6 + -0.29113379120826721f) * y_6 + 1.39025199413299561f) * y_6 + 0.35589990019798279f) * y_6 + -1.17120099067687988f) * y_6 + 0.15940259397029877f)) * x_13 + (((((2.26068711280822754f * y_6 + -3.64728999137878418f) * y_6 + -0.72173482179641724f) * y_6 + 3.07659196853637695f) * y_6 + -0.6827620267868042f) * y_6 + -0.3039557933807373f)) * x_13 + (((((0.81201767921447754f * y_6 + 0.36014080047607422f) * y_6 + -1.72646903991699219f) * y_6 + -0.22630110383033752f) * y_6 + 0.89514690637588501f) * y_6 + -0.10397960245609283f)) * x_13 + (((((-0.37648698687553406f * y_6 + 1.10974001884460449f) * y_6 + 0.17824520170688629f) * y_6 + -1.04968702793121338f) * y_6 + 0.1461234986782074f) * y_6 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_14 : f32,  y_7 : f32) -> f32
{
    return ((((0.0f * x_14 + (((((12.95646953582763672f * y_7 + -21.38032913208007812f) * y_7 + -7.37853097915649414f) * y_7 + 34.55607986450195312f) * y_7 + -23.61347007751464844f) * y_7 + 5.00126314163208008f)) * x_14 + (((((10.91487026214599609f * y_7 + -6.08202791213989258f) * y_7 + -38.2036285400390625f) * y_7 + 53.3440399169921875f) * y_7 + -21.91996002197265625f) * y_7 + 2.01606011390686035f)) * x_14 + (((((-14.52206039428710938f * y_7 + 36.803619384765625f) * y_7 + -22.94047927856445312f) * y_7 + -10.07973003387451172f) * y_7 + 15.77003955841064453f) * y_7 + -4.92722177505493164f)) * x_14 + (((((-7.62505722045898438f * y_7 + 1.27310299873352051f) * y_7 + 31.19523048400878906f) * y_7 + -44.39989852905273438f) * y_7 + 26.44947052001953125f) * y_7 + -8.73507976531982422f)) * x_14 + (((((5.65633487701416016f * y_7 + -17.66820907592773438f) * y_7 + 24.65356063842773438f) * y_7 + -19.38941001892089844f) * y_7 + 11.06159019470214844f) * y_7 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_4 : f32) -> vec3<f32>
{
    var _S306 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S307 : f32 = 2.0f * sqrt(_S306) - 1.0f;
    var _S308 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_4, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S307, _S308), 0.00999999977648258f, 1.0f), clamp((1.0f - _S306) * sheen_shear_0(_S307, _S308), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S307, _S308), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_6 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S309 : f32 = light_3.z;
    var _S310 : bool;
    if(_S309 <= 0.0f)
    {
        _S310 = true;
    }
    else
    {
        _S310 = (view_6.z) <= 0.0f;
    }
    if(_S310)
    {
        return 0.0f;
    }
    var _S311 : vec2<f32> = view_6.xy;
    var _S312 : f32 = dot(_S311, _S311);
    var _S313 : vec2<f32>;
    if(_S312 > 9.99999968265522539e-21f)
    {
        _S313 = _S311 * vec2<f32>(rsqrt_0(_S312));
    }
    else
    {
        _S313 = vec2<f32>(1.0f, 0.0f);
    }
    var _S314 : f32 = scale_0 * dot(light_3.xy, _S313) + shear_0 * _S309;
    var _S315 : f32 = scale_0 * (light_3.y * _S313.x - light_3.x * _S313.y);
    var _S316 : f32 = _S314 * _S314 + _S315 * _S315 + _S309 * _S309;
    return 0.31830987334251404f * scale_0 * scale_0 * _S309 / max(_S316 * _S316, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_5 : f32) -> vec2<f32>
{
    var _S317 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_5);
    var _S318 : f32 = strength_0 * _S317.z;
    return vec2<f32>(_S318 * transformed_cosine_0(light_4, view_7, _S317.x, _S317.y), 1.0f - _S318);
}

fn table_byte_0( table_2 : u32,  index_7 : u32) -> u32
{
    return (((words_0[table_2 + index_7 / u32(4)] >> ((u32(8) * ((index_7 & (u32(3)))))))) & (u32(255)));
}

fn diffuse_reflection_0( light_5 : vec3<f32>,  normal_7 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S319 : f32 = light_5.z;
    if(_S319 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S319, 0.0f), max(dot(light_5, normal_7), 0.0f), blend_1);
}

fn mean_attenuation_0( depth_0 : f32) -> f32
{
    if(depth_0 < 0.10000000149011612f)
    {
        return (((depth_0 / 120.0f - 0.0416666679084301f) * depth_0 + 0.1666666716337204f) * depth_0 - 0.5f) * depth_0 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_0)) / depth_0;
}

fn flake_density_0( squared_along_0 : f32,  roughness_6 : f32) -> f32
{
    var _S320 : f32 = roughness_6 * roughness_6;
    var _S321 : f32 = squared_along_0 * (1.0f - _S320) + _S320;
    return 0.31830987334251404f * _S320 * roughness_6 / (_S321 * _S321);
}

fn density_between_0( light_6 : vec3<f32>,  view_8 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_7 : f32) -> f32
{
    var _S322 : vec3<f32> = light_6 + view_8;
    var _S323 : f32 = dot(_S322, tangent_7);
    return flake_density_0(min(_S323 * _S323 / max(square_0(_S322), 9.999999960041972e-13f), 1.0f), roughness_7);
}

fn transmission_1( light_7 : vec3<f32>,  view_9 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_8 : f32,  optical_depth_1 : f32) -> f32
{
    var _S324 : f32 = - dot(light_7, normal_8);
    var _S325 : f32 = dot(view_9, normal_8);
    var _S326 : bool;
    if(_S324 <= 0.0f)
    {
        _S326 = true;
    }
    else
    {
        _S326 = _S325 <= 0.0f;
    }
    if(_S326)
    {
        return 0.0f;
    }
    var _S327 : f32 = 1.0f / max(_S325, 9.99999997475242708e-07f);
    var _S328 : f32 = projected_area_1(light_7, tangent_8, roughness_8) / max(_S324, 9.99999997475242708e-07f);
    var _S329 : f32 = projected_area_1(view_9, tangent_8, roughness_8) * _S327;
    return density_between_0(light_7, view_9, tangent_8, roughness_8) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S328, _S329)) * mean_attenuation_0(optical_depth_1 * abs(_S328 - _S329)) * _S327;
}

fn reflection_0( light_8 : vec3<f32>,  view_10 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_9 : f32,  optical_depth_2 : f32) -> f32
{
    var _S330 : f32 = dot(light_8, normal_9);
    var _S331 : bool;
    if(_S330 <= 0.0f)
    {
        _S331 = true;
    }
    else
    {
        _S331 = (dot(view_10, normal_9)) <= 0.0f;
    }
    if(_S331)
    {
        return 0.0f;
    }
    var _S332 : f32 = max(_S330, 9.99999997475242708e-07f);
    var _S333 : f32 = max(dot(view_10, normal_9), 9.99999997475242708e-07f);
    var _S334 : f32 = projected_area_1(light_8, tangent_9, roughness_9) * _S333 + projected_area_1(view_10, tangent_9, roughness_9) * _S332;
    var _S335 : f32 = optical_depth_2 * _S334 / (_S332 * _S333);
    return 0.25f * density_between_0(light_8, view_10, tangent_9, roughness_9) * (_S335 * mean_attenuation_0(_S335)) * _S332 / _S334;
}

fn accumulate_0( index_8 : u32,  light_9 : vec4<f32>)
{
    var _S336 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_9;
    layers_0[index_8].share_0 = _S336 * (1.0f - light_9.w);
    return;
}

fn camera_right_0( _S337 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S337].right_x_0, frames_0[_S337].right_y_0, frames_0[_S337].right_z_0);
}

fn camera_up_0( _S338 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S338].up_x_0, frames_0[_S338].up_y_0, frames_0[_S338].up_z_0);
}

fn camera_forward_0( _S339 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S339].forward_x_0, frames_0[_S339].forward_y_0, frames_0[_S339].forward_z_0);
}

fn camera_origin_0( _S340 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S340].origin_x_0, frames_0[_S340].origin_y_0, frames_0[_S340].origin_z_0);
}

fn face_point_0( _S341 : u32,  _S342 : u32,  _S343 : f32,  _S344 : f32) -> VisiblePoint_0
{
    var _S345 : u32 = u32(3) * _S342;
    var _S346 : Vertex_std430_0 = vertices_0[corners_0[_S345]];
    var _S347 : Vertex_std430_0 = vertices_0[corners_0[_S345 + u32(1)]];
    var _S348 : Vertex_std430_0 = vertices_0[corners_0[_S345 + u32(2)]];
    var _S349 : vec3<f32> = position_of_0(&(_S347));
    var _S350 : vec3<f32> = position_of_0(&(_S346));
    var _S351 : vec3<f32> = _S349 - _S350;
    var _S352 : vec3<f32> = position_of_0(&(_S348));
    var _S353 : vec3<f32> = _S352 - _S350;
    var _S354 : f32 = _S346.u_0;
    var _S355 : f32 = _S347.u_0 - _S346.u_0;
    var _S356 : f32 = _S346.v_0;
    var _S357 : f32 = _S347.v_0 - _S346.v_0;
    var _S358 : vec2<f32> = vec2<f32>(_S355, _S357);
    var _S359 : f32 = _S348.u_0 - _S346.u_0;
    var _S360 : f32 = _S348.v_0 - _S346.v_0;
    var _S361 : vec2<f32> = vec2<f32>(_S359, _S360);
    var _S362 : f32;
    if((_S355 * _S360 - _S357 * _S359) < 0.0f)
    {
        _S362 = -1.0f;
    }
    else
    {
        _S362 = 1.0f;
    }
    var _S363 : vec3<f32> = vec3<f32>(_S362) * (vec3<f32>(_S360) * _S351 - vec3<f32>(_S357) * _S353);
    var _S364 : vec3<f32> = vec3<f32>(_S362) * (vec3<f32>(_S355) * _S353 - vec3<f32>(_S359) * _S351);
    var point_4 : VisiblePoint_0;
    var _S365 : f32 = 1.0f - _S343 - _S344;
    var _S366 : vec3<f32> = normal_of_0(&(_S346));
    var _S367 : vec3<f32> = vec3<f32>(_S365) * _S366;
    var _S368 : vec3<f32> = normal_of_0(&(_S347));
    var _S369 : vec3<f32> = vec3<f32>(_S343);
    var _S370 : vec3<f32> = _S367 + _S369 * _S368;
    var _S371 : vec3<f32> = normal_of_0(&(_S348));
    var _S372 : vec3<f32> = vec3<f32>(_S344);
    var _S373 : vec3<f32> = normalize(_S370 + _S372 * _S371);
    point_4.normal_0 = _S373;
    var _S374 : vec3<f32> = normalize(_S363 - _S373 * vec3<f32>(dot(_S373, _S363)));
    point_4.axis_x_0 = _S374;
    point_4.axis_y_0 = cross(_S373, _S374);
    var _S375 : vec3<f32> = normalize(cross(_S351, _S353));
    var _S376 : vec3<f32>;
    if((dot(_S375, _S373)) < 0.0f)
    {
        _S376 = (vec3<f32>(0) - _S375);
    }
    else
    {
        _S376 = _S375;
    }
    point_4.face_normal_0 = _S376;
    point_4.position_0 = _S350 + _S369 * _S351 + _S372 * _S353;
    point_4.view_1 = point_4.normal_0;
    point_4.uv_1 = vec2<f32>(_S354, _S356) + vec2<f32>(_S343) * _S358 + vec2<f32>(_S344) * _S361;
    var _S377 : bool = (dot(cross(_S363, _S364), point_4.normal_0)) < 0.0f;
    var _S378 : f32 = fabrics_0[_S341].uv_width_0;
    if(_S377)
    {
        _S362 = - fabrics_0[_S341].uv_height_0;
    }
    else
    {
        _S362 = fabrics_0[_S341].uv_height_0;
    }
    var _S379 : vec2<f32> = vec2<f32>(_S378, _S362);
    point_4.draft_per_uv_0 = _S379;
    var _S380 : vec2<f32> = point_4.uv_1 * _S379;
    if(_S377)
    {
        _S362 = fabrics_0[_S341].uv_height_0;
    }
    else
    {
        _S362 = 0.0f;
    }
    point_4.draft_0 = _S380 + vec2<f32>(0.0f, _S362);
    var _S381 : vec2<f32> = vec2<f32>(0.0f);
    point_4.draft_dx_0 = _S381;
    point_4.draft_dy_0 = _S381;
    return point_4;
}

fn visible_point_0( _S382 : i32,  _S383 : u32,  _S384 : u32,  _S385 : vec2<u32>) -> VisiblePoint_0
{
    var _S386 : u32 = u32(3) * _S384;
    var _S387 : Vertex_std430_0 = vertices_0[corners_0[_S386]];
    var _S388 : Vertex_std430_0 = vertices_0[corners_0[_S386 + u32(1)]];
    var _S389 : Vertex_std430_0 = vertices_0[corners_0[_S386 + u32(2)]];
    var _S390 : vec3<f32> = position_of_1(&(_S388));
    var _S391 : vec3<f32> = position_of_1(&(_S387));
    var _S392 : vec3<f32> = _S390 - _S391;
    var _S393 : vec3<f32> = position_of_1(&(_S389));
    var _S394 : vec3<f32> = _S393 - _S391;
    var _S395 : vec3<f32> = cross(_S392, _S394);
    var _S396 : f32 = 1.0f / max(square_0(_S395), 1.00000000317107685e-30f);
    var _S397 : f32 = f32(frames_0[_S382].width_0);
    var _S398 : vec3<f32> = camera_right_0(_S382) * vec3<f32>((2.0f / _S397));
    var _S399 : f32 = f32(frames_0[_S382].height_0);
    var _S400 : vec3<f32> = camera_up_0(_S382) * vec3<f32>((-2.0f / _S399));
    var _S401 : vec3<f32> = camera_forward_0(_S382) + vec3<f32>((f32(_S385.x) + 0.5f - 0.5f * _S397)) * _S398 + vec3<f32>((f32(_S385.y) + 0.5f - 0.5f * _S399)) * _S400;
    var _S402 : f32 = dot(_S401, _S395);
    var _S403 : f32;
    if((abs(_S402)) > 1.00000000317107685e-30f)
    {
        _S403 = _S402;
    }
    else
    {
        _S403 = 1.00000000317107685e-30f;
    }
    var _S404 : f32 = 1.0f / _S403;
    var _S405 : vec3<f32> = _S391 - camera_origin_0(_S382);
    var _S406 : vec3<f32> = vec3<f32>((dot(_S405, _S395) * _S404));
    var _S407 : vec3<f32> = _S401 * _S406 - _S405;
    var _S408 : vec3<f32> = _S406 * (_S398 - _S401 * vec3<f32>((dot(_S398, _S395) * _S404)));
    var _S409 : vec3<f32> = _S406 * (_S400 - _S401 * vec3<f32>((dot(_S400, _S395) * _S404)));
    var _S410 : vec3<f32> = vec3<f32>(_S396);
    var _S411 : vec3<f32> = cross(_S394, _S395) * _S410;
    var _S412 : vec3<f32> = cross(_S395, _S392) * _S410;
    var _S413 : vec2<f32> = vec2<f32>(_S388.u_0 - _S387.u_0, _S388.v_0 - _S387.v_0);
    var _S414 : vec2<f32> = vec2<f32>(_S389.u_0 - _S387.u_0, _S389.v_0 - _S387.v_0);
    var point_5 : VisiblePoint_0 = face_point_0(_S383, _S384, dot(_S407, _S411), dot(_S407, _S412));
    point_5.position_0 = _S391 + _S407;
    point_5.view_1 = (vec3<f32>(0) - normalize(_S401));
    point_5.draft_dx_0 = (vec2<f32>(dot(_S408, _S411)) * _S413 + vec2<f32>(dot(_S408, _S412)) * _S414) * point_5.draft_per_uv_0;
    point_5.draft_dy_0 = (vec2<f32>(dot(_S409, _S411)) * _S413 + vec2<f32>(dot(_S409, _S412)) * _S414) * point_5.draft_per_uv_0;
    return point_5;
}

fn filtered_albedo_0( _S415 : u32,  _S416 : VisiblePoint_0) -> vec3<f32>
{
    var _S417 : u32 = fabrics_0[_S415].albedo_map_levels_0;
    if((fabrics_0[_S415].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S418 : vec2<f32> = vec2<f32>(fabrics_0[_S415].uv_width_0, fabrics_0[_S415].uv_height_0);
    var _S419 : vec2<f32> = _S416.draft_dx_0 / _S418;
    var _S420 : vec2<f32> = _S416.draft_dy_0 / _S418;
    var _S421 : u32 = _S417 - u32(1);
    var _S422 : u32 = (u32(1) << (_S421));
    var _S423 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S419.x * _S420.y - _S419.y * _S420.x), 9.99999968265522539e-21f) * (square_1(f32(_S422)) / 3.0f)), 0.0f, f32(_S417) - 1.0f);
    var _S424 : u32 = min(u32(_S423), max(_S417, u32(2)) - u32(2));
    var _S425 : u32 = min(_S424 + u32(1), _S421);
    var _S426 : u32 = (u32(1) << ((u32(2) * _S417)));
    return mix(map_level_0(fabrics_0[_S415].albedo_map_0 + (_S426 - ((_S426 >> ((u32(2) * _S424))))) / u32(3), (_S422 >> (_S424)), _S416.uv_1), map_level_0(fabrics_0[_S415].albedo_map_0 + (_S426 - ((_S426 >> ((u32(2) * _S425))))) / u32(3), (_S422 >> (_S425)), _S416.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S423 - f32(_S424))) - 1.0f) / 3.0f)));
}

struct ClusteredView_0
{
     base_0 : ViewedBase_0,
     albedos_7 : FamilyAlbedos_0,
     bounced_2 : Bounced_0,
     view_11 : vec3<f32>,
     is_alone_0 : bool,
};

fn viewed_base_0( _S427 : u32,  _S428 : Footprint_0,  _S429 : vec3<f32>,  _S430 : f32,  _S431 : bool) -> ViewedBase_0
{
    var seen_1 : ViewedBase_0;
    var _S432 : bool = (_S429.z) < 0.0f;
    seen_1.back_9 = _S432;
    seen_1.view_4 = to_face_frame_0(_S429, _S432);
    var _S433 : u32;
    if(_S432)
    {
        _S433 = u32(1);
    }
    else
    {
        _S433 = u32(0);
    }
    seen_1.face_2 = _S433;
    var _S434 : BinTaps_0 = bin_taps_0(seen_1.view_4, u32(16));
    seen_1.around_1 = _S434;
    var _S435 : u32 = _S433 * u32(256);
    var _S436 : Clustered_std430_0 = fabrics_0[_S427].clustered_0;
    var _S437 : TexelBox_0 = texel_box_0(&(_S436), _S428, vec2<f32>(BinTaps_read_0(_S434, _S436.offset_1, _S435, u32(2), u32(0)), BinTaps_read_0(_S434, _S436.offset_1, _S435, u32(2), u32(1))), _S430 - 0.5f);
    seen_1.box_3 = _S437;
    seen_1.trust_1 = vec2<f32>(1.0f);
    if(!_S431)
    {
        seen_1.trust_1 = vec2<f32>(BinTaps_read_0(seen_1.around_1, _S436.trust_0, _S435, u32(2), u32(0)), BinTaps_read_0(seen_1.around_1, _S436.trust_0, _S435, u32(2), u32(1)));
    }
    return seen_1;
}

fn albedos_over_0( _S438 : u32,  _S439 : Footprint_0,  _S440 : bool) -> FamilyAlbedos_0
{
    var _S441 : vec2<f32> = _S439.dx_0;
    var _S442 : vec2<f32> = _S439.dy_0;
    var _S443 : vec2<f32> = sqrt(_S441 * _S441 + _S442 * _S442);
    var _S444 : Stretch_0 = stretch_of_0(fabrics_0[_S438].warp_0, _S439.centre_0.x, _S443.x);
    var _S445 : Stretch_0 = stretch_of_0(fabrics_0[_S438].weft_0, _S439.centre_0.y, _S443.y);
    var albedos_8 : FamilyAlbedos_0;
    albedos_8.warp_4 = mean_albedos_0(fabrics_0[_S438].warp_0, fabrics_0[_S438].weft_0, _S444, _S445, _S440);
    albedos_8.weft_4 = mean_albedos_0(fabrics_0[_S438].weft_0, fabrics_0[_S438].warp_0, _S445, _S444, _S440);
    return albedos_8;
}

fn openness_number_0( _S446 : u32,  _S447 : u32) -> f32
{
    return table_number_0(fabrics_0[_S446].openness_0 + _S447);
}

fn scattered_by_0( _S448 : u32,  _S449 : Albedos_0,  _S450 : u32,  _S451 : vec3<f32>) -> Scattered_0
{
    var _S452 : u32 = u32(159) + u32(2) * _S450;
    var yarn_3 : Scattered_0;
    yarn_3.back_4 = _S451 * _S449.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S448, _S452)) * _S449.specular_reflect_0;
    yarn_3.through_0 = _S451 * _S449.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S448, _S452 + u32(1))) * _S449.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S453 : u32,  _S454 : u32,  _S455 : vec3<f32>,  _S456 : vec3<f32>,  _S457 : vec3<f32>,  _S458 : vec3<f32>,  _S459 : ptr<function, vec3<f32>>,  _S460 : ptr<function, vec3<f32>>)
{
    var _S461 : u32 = u32(146) + u32(4) * _S454;
    var _S462 : f32 = openness_number_0(_S453, _S461 + u32(1));
    var _S463 : f32 = openness_number_0(_S453, _S461 + u32(2));
    var _S464 : vec3<f32> = vec3<f32>(1.0f);
    var _S465 : vec3<f32> = _S464 - _S457 * vec3<f32>(openness_number_0(_S453, _S461));
    var _S466 : vec3<f32> = _S464 - _S458 * vec3<f32>(openness_number_0(_S453, _S461 + u32(3)));
    var _S467 : vec3<f32> = _S464 / (_S465 * _S466 - _S457 * _S458 * vec3<f32>((_S462 * _S463)));
    (*_S459) = (_S455 * _S466 + _S457 * vec3<f32>(_S462) * _S456) * _S467;
    (*_S460) = (_S456 * _S465 + _S458 * vec3<f32>(_S463) * _S455) * _S467;
    return;
}

fn face_sends_0( _S468 : u32,  _S469 : u32,  _S470 : Scattered_0,  _S471 : Scattered_0) -> FaceSends_0
{
    var _S472 : u32 = u32(2) * _S469;
    var _S473 : u32 = u32(142) + _S472;
    var _S474 : f32 = openness_number_0(_S468, _S473);
    var _S475 : f32 = openness_number_0(_S468, _S473 + u32(1));
    var _S476 : vec3<f32> = vec3<f32>((1.0f - _S474)) * _S470.back_4;
    var _S477 : vec3<f32> = vec3<f32>((1.0f - _S475)) * _S471.back_4;
    var sends_1 : FaceSends_0;
    var _S478 : u32 = u32(154) + _S472;
    var _S479 : f32 = openness_number_0(_S468, _S478);
    sends_1.blocks_warp_0 = _S479;
    var _S480 : f32 = openness_number_0(_S468, _S478 + u32(1));
    sends_1.blocks_weft_0 = _S480;
    sends_1.open_0 = _S479 * _S474 + _S480 * _S475;
    var _S481 : vec3<f32> = vec3<f32>(_S474) * _S470.back_4;
    var _S482 : vec3<f32> = vec3<f32>(_S475) * _S471.back_4;
    var _S483 : vec3<f32> = sends_1.sky_warp_0;
    var _S484 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S468, _S469, _S481, _S482, _S476, _S477, &(_S483), &(_S484));
    sends_1.sky_warp_0 = _S483;
    sends_1.sky_weft_0 = _S484;
    var _S485 : vec3<f32> = sends_1.crossing_warp_0;
    var _S486 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S468, _S469, _S470.through_0, _S471.through_0, _S476, _S477, &(_S485), &(_S486));
    sends_1.crossing_warp_0 = _S485;
    sends_1.crossing_weft_0 = _S486;
    return sends_1;
}

fn interior_of_0( _S487 : u32,  _S488 : vec3<f32>,  _S489 : bool) -> Interior_0
{
    var _S490 : Scattered_0 = scattered_by_0(_S487, table_albedos_0(families_0[fabrics_0[_S487].warp_0].colour_mean_0), u32(0), _S488);
    var _S491 : Scattered_0 = scattered_by_0(_S487, table_albedos_0(families_0[fabrics_0[_S487].weft_0].colour_mean_0), u32(1), _S488);
    var _S492 : u32;
    if(_S489)
    {
        _S492 = u32(1);
    }
    else
    {
        _S492 = u32(0);
    }
    var _S493 : FaceSends_0 = face_sends_0(_S487, _S492, _S490, _S491);
    if(_S489)
    {
        _S492 = u32(0);
    }
    else
    {
        _S492 = u32(1);
    }
    var _S494 : FaceSends_0 = face_sends_0(_S487, _S492, _S490, _S491);
    var _S495 : vec3<f32> = vec3<f32>(_S493.blocks_warp_0);
    var _S496 : vec3<f32> = vec3<f32>(_S493.blocks_weft_0);
    var _S497 : vec3<f32> = _S495 * _S493.crossing_warp_0 + _S496 * _S493.crossing_weft_0;
    var _S498 : vec3<f32> = vec3<f32>(_S494.blocks_warp_0);
    var _S499 : vec3<f32> = vec3<f32>(_S494.blocks_weft_0);
    var _S500 : vec3<f32> = _S498 * _S494.crossing_warp_0 + _S499 * _S494.crossing_weft_0;
    var _S501 : f32 = 1.0f - _S493.open_0;
    var _S502 : f32 = 1.0f - _S494.open_0;
    var _S503 : vec3<f32> = vec3<f32>(1.0f);
    var _S504 : vec3<f32> = _S503 / (_S503 - _S497 * _S500 * vec3<f32>((_S501 * _S502)));
    var _S505 : vec3<f32> = _S500 * (vec3<f32>(_S493.open_0) + vec3<f32>(_S501) * (_S495 * _S493.sky_warp_0 + _S496 * _S493.sky_weft_0)) * _S504;
    var _S506 : vec3<f32> = _S497 * (vec3<f32>(_S494.open_0) + vec3<f32>(_S502) * (_S498 * _S494.sky_warp_0 + _S499 * _S494.sky_weft_0)) * _S504;
    var _S507 : FaceRadiance_0 = face_radiance_0(_S493, _S494.open_0, _S505, _S506);
    var _S508 : FaceRadiance_0 = face_radiance_0(_S494, _S493.open_0, _S506, _S505);
    var interior_1 : Interior_0;
    interior_1.warp_2 = _S507.warp_1;
    interior_1.weft_2 = _S507.weft_1;
    interior_1.leaked_1 = _S507.leaked_0;
    interior_1.far_1 = _S508.mean_0;
    interior_1.far_leaked_0 = _S508.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S509 : u32,  _S510 : u32,  _S511 : array<f32, i32(6)>,  _S512 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_6 : u32 = u32(0);
    for(;;)
    {
        if(share_6 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_6] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S512)
            {
            }
            else
            {
                break;
            }
            shares_0[share_6] = shares_0[share_6] + openness_number_0(_S509, _S510 + share_6 * _S512 + term_0) * _S511[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_6] = saturate(shares_0[share_6]);
        share_6 = share_6 + u32(1);
    }
    var blocked_2 : Blocked_0;
    blocked_2.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_2.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_2.far_0 = shares_0[i32(1)];
    return blocked_2;
}

fn blocked_from_0( _S513 : u32,  _S514 : vec3<f32>,  _S515 : bool,  _S516 : bool) -> Blocked_0
{
    var terms_2 : array<f32, i32(6)>;
    view_terms_0(_S514, &(terms_2));
    var _S517 : u32;
    if(_S516)
    {
        _S517 = u32(2);
    }
    else
    {
        _S517 = u32(0);
    }
    var _S518 : u32;
    if(_S515)
    {
        _S518 = u32(0);
    }
    else
    {
        _S518 = u32(1);
    }
    return blocked_of_terms_0(_S513, (_S517 + _S518) * u32(15), terms_2, u32(5));
}

fn warp_seen_from_0( _S519 : u32,  _S520 : vec3<f32>,  _S521 : bool) -> f32
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_1(_S520, &(terms_3));
    var term_1 : u32 = u32(0);
    var share_7 : f32 = 0.0f;
    for(;;)
    {
        if(term_1 < u32(5))
        {
        }
        else
        {
            break;
        }
        var _S522 : u32;
        if(_S521)
        {
            _S522 = u32(5);
        }
        else
        {
            _S522 = u32(0);
        }
        var share_8 : f32 = share_7 + openness_number_0(_S519, u32(132) + _S522 + term_1) * terms_3[term_1];
        term_1 = term_1 + u32(1);
        share_7 = share_8;
    }
    return saturate(share_7);
}

fn bounced_of_families_0( _S523 : u32,  _S524 : FamilyAlbedos_0,  _S525 : vec3<f32>,  _S526 : Interior_0,  _S527 : Blocked_0,  _S528 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S527, scattered_by_0(_S523, _S524.warp_4, u32(0), _S525), _S526), bounced_by_0(_S528, scattered_by_0(_S523, _S524.weft_4, u32(1), _S525), _S526));
}

fn bounced_far_0( _S529 : u32,  _S530 : FamilyAlbedos_0,  _S531 : vec3<f32>,  _S532 : Interior_0,  _S533 : vec3<f32>,  _S534 : bool,  _S535 : f32,  _S536 : f32,  _S537 : f32) -> Bounced_0
{
    var _S538 : Blocked_0 = blocked_from_0(_S529, _S533, true, _S534);
    var _S539 : Blocked_0 = blocked_from_0(_S529, _S533, false, _S534);
    var _S540 : f32 = _S535 / max(1.0f - _S538.by_warp_0 - _S538.by_weft_0, 0.10000000149011612f);
    var _S541 : f32 = (0.0020000000949949f * warp_seen_from_0(_S529, _S533, _S534) + _S540) / (_S540 + _S536 / max(1.0f - _S539.by_warp_0 - _S539.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S542 : f32 = 1.0f - _S537;
    return bounced_of_families_0(_S529, _S530, _S531, _S532, scaled_0(_S538, _S541 * _S542), scaled_0(_S539, (1.0f - _S541) * _S542));
}

fn clustered_view_0( _S543 : u32,  _S544 : Footprint_0,  _S545 : vec3<f32>,  _S546 : vec3<f32>,  _S547 : u32,  _S548 : bool) -> ClusteredView_0
{
    var seen_2 : ClusteredView_0;
    seen_2.base_0 = viewed_base_0(_S543, _S544, _S545, uniform_of_0(_S547, u32(0)), _S548);
    seen_2.view_11 = _S545;
    seen_2.is_alone_0 = _S548;
    var _S549 : FamilyAlbedos_0 = albedos_over_0(_S543, _S544, seen_2.base_0.back_9);
    seen_2.albedos_7.warp_4 = tinted_0(_S549.warp_4, _S546);
    seen_2.albedos_7.weft_4 = tinted_0(_S549.weft_4, _S546);
    var _S550 : vec3<f32> = vec3<f32>(0.0f);
    seen_2.bounced_2.reflected_0 = _S550;
    seen_2.bounced_2.transmitted_0 = _S550;
    if((fabrics_0[_S543].openness_0) != u32(4294967295))
    {
        seen_2.bounced_2 = bounced_far_0(_S543, _S549, _S546, interior_of_0(_S543, _S546, seen_2.base_0.back_9), seen_2.base_0.view_4, seen_2.base_0.back_9, 0.0f, 0.0f, 0.0f);
    }
    return seen_2;
}

fn clustered_hole_0( _S551 : u32,  _S552 : ViewedBase_0) -> f32
{
    var cluster_0 : u32 = u32(0);
    var covered_0 : f32 = 0.0f;
    for(;;)
    {
        var _S553 : Clustered_std430_0 = fabrics_0[_S551].clustered_0;
        if(cluster_0 < (_S553.clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S554 : f32 = box_mean_0(&(_S553), _S552.box_3, _S552.face_2, cluster_0);
        var covered_1 : f32 = covered_0 + _S554;
        cluster_0 = cluster_0 + u32(1);
        covered_0 = covered_1;
    }
    return clamp(1.0f - covered_0, 0.0f, 1.0f);
}

struct Hit_0
{
     x_15 : f32,
     y_8 : f32,
     hole_6 : bool,
     height_7 : f32,
};

struct Sample_0
{
     crossing_2 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_8 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S555 : u32,  _S556 : f32,  _S557 : f32,  _S558 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_3 = locate_0(fabrics_0[_S555].warp_0, _S556);
    crossing_3.weft_3 = locate_0(fabrics_0[_S555].weft_0, _S557);
    var _S559 : u32 = fabrics_0[_S555].run_words_0 + u32(2) * (crossing_3.weft_3.thread_0 * fabrics_0[_S555].ends_1 + crossing_3.warp_3.thread_0);
    var _S560 : u32 = words_0[_S559];
    crossing_3.warp_word_0 = _S560;
    crossing_3.weft_word_0 = words_0[_S559 + u32(1)];
    crossing_3.warp_above_0 = (((_S560 & (u32(1)))) == u32(1)) != _S558;
    return crossing_3;
}

fn sample_at_0( _S561 : u32,  _S562 : f32,  _S563 : f32,  _S564 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S565 : Crossing_0 = crossing_at_0(_S561, _S562, _S563, _S564);
    sample_0.crossing_2 = _S565;
    var _S566 : Shown_0 = shown_at_0(_S565, _S564);
    sample_0.shown_3 = _S566;
    var _S567 : u32;
    if(_S566.is_warp_2)
    {
        _S567 = fabrics_0[_S561].warp_0;
    }
    else
    {
        _S567 = fabrics_0[_S561].weft_0;
    }
    var _S568 : u32;
    if(_S566.is_warp_2)
    {
        _S568 = fabrics_0[_S561].weft_0;
    }
    else
    {
        _S568 = fabrics_0[_S561].warp_0;
    }
    var _S569 : Cell_0 = select_cell_0(_S566.is_warp_2, sample_0.crossing_2.warp_3, sample_0.crossing_2.weft_3);
    var _S570 : Cell_0 = select_cell_0(_S566.is_warp_2, sample_0.crossing_2.weft_3, sample_0.crossing_2.warp_3);
    var _S571 : Run_0 = unpack_0(_S567, _S568, _S569.thread_0, _S570, _S566.word_0);
    var _S572 : Section_0 = section_at_0(_S569);
    var _S573 : bool;
    if(_S566.on_top_0)
    {
        _S573 = (_S571.distance_0) < (_S572.drop_0 * _S571.bend_1.sine_0);
    }
    else
    {
        _S573 = false;
    }
    var _S574 : bool;
    if(_S566.on_top_0)
    {
        _S574 = !_S573;
    }
    else
    {
        _S574 = false;
    }
    var _S575 : f32;
    if(_S574)
    {
        _S575 = 1.0f;
    }
    else
    {
        _S575 = -1.0f;
    }
    var _S576 : f32;
    if(_S573)
    {
        _S576 = _S571.other_reach_0;
    }
    else
    {
        _S576 = _S571.reach_0;
    }
    var _S577 : f32;
    if(_S573)
    {
        _S577 = _S576 + _S571.distance_0;
    }
    else
    {
        _S577 = max(_S576 - _S571.distance_0, 0.0f);
    }
    var _S578 : f32 = _S576 / _S571.bend_1.sine_0 - _S575 * _S572.drop_0;
    var _S579 : f32 = _S577 * _S577;
    var _S580 : f32 = max(_S578 * _S578 - _S579, 9.99999968265522539e-21f);
    var _S581 : f32 = rsqrt_0(_S580);
    var _S582 : f32 = _S579 / (_S580 * _S581 + _S578);
    var _S583 : bool = _S577 > 0.0f;
    var _S584 : f32;
    if(_S566.on_top_0)
    {
        _S584 = 1.0f;
    }
    else
    {
        _S584 = -1.0f;
    }
    var _S585 : f32;
    if(_S571.near_start_0)
    {
        _S585 = 1.0f;
    }
    else
    {
        _S585 = -1.0f;
    }
    var _S586 : f32 = _S584 * _S585;
    if(_S583)
    {
        _S584 = _S578 * _S581;
    }
    else
    {
        _S584 = 1.0f;
    }
    sample_0.slope_across_0 = _S572.slope_0 * _S584;
    if(_S583)
    {
        _S577 = _S586 * _S577 * _S581;
    }
    else
    {
        _S577 = 0.0f;
    }
    sample_0.slope_along_0 = _S577;
    var _S587 : f32 = families_0[_S567].height_scale_0;
    var _S588 : vec2<f32> = dive_0(_S568, _S566, _S571, _S570);
    if(_S571.straight_0)
    {
        _S575 = 0.0f;
    }
    else
    {
        _S575 = _S587 * _S575;
    }
    sample_0.height_8 = _S575 * (_S576 * _S571.bend_1.half_tangent_0 - _S582) - _S587 * _S572.drop_0 - _S588.x;
    var _S589 : f32 = _S587 * sample_0.slope_across_0;
    var _S590 : f32 = _S587 * sample_0.slope_along_0 - _S588.y;
    if(_S566.is_warp_2)
    {
        _S575 = _S589;
    }
    else
    {
        _S575 = _S590;
    }
    sample_0.slope_x_1 = _S575;
    if(_S566.is_warp_2)
    {
        _S575 = _S590;
    }
    else
    {
        _S575 = _S589;
    }
    sample_0.slope_y_1 = _S575;
    sample_0.run_3 = _S571;
    sample_0.section_1 = _S572;
    return sample_0;
}

fn steps_per_length_0( _S591 : u32,  _S592 : SearchQuality_0,  _S593 : vec3<f32>) -> f32
{
    return max(max(abs(_S593.x) * fabrics_0[_S591].threads_per_x_0, abs(_S593.y) * fabrics_0[_S591].threads_per_y_0) * _S592.steps_per_thread_0, abs(_S593.z) * fabrics_0[_S591].per_relief_0 * _S592.steps_per_relief_0);
}

fn cell_maximum_0( _S594 : u32,  _S595 : Crossing_0) -> f32
{
    var _S596 : u32;
    if(_S595.warp_above_0)
    {
        _S596 = fabrics_0[_S594].warp_0;
    }
    else
    {
        _S596 = fabrics_0[_S594].weft_0;
    }
    var _S597 : u32;
    if(_S595.warp_above_0)
    {
        _S597 = _S595.warp_word_0;
    }
    else
    {
        _S597 = _S595.weft_word_0;
    }
    return f32((_S597 >> (u32(28)))) * families_0[_S596].height_scale_0 * families_0[_S596].level_0;
}

fn probe_0( _S598 : u32,  _S599 : f32,  _S600 : f32,  _S601 : bool,  _S602 : bool,  _S603 : bool) -> Probe_0
{
    var _S604 : Sample_0 = sample_at_0(_S598, _S599, _S600, _S601);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S604.height_8;
    probe_1.hole_3 = _S604.shown_3.hole_2;
    probe_1.slope_x_0 = _S604.slope_x_1;
    probe_1.slope_y_0 = _S604.slope_y_1;
    var _S605 : u32;
    if(_S604.shown_3.is_warp_2)
    {
        _S605 = _S604.crossing_2.warp_3.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S605 = _S604.crossing_2.weft_3.thread_0 * u32(2);
    }
    probe_1.yarn_2 = _S605;
    probe_1.cell_max_0 = cell_maximum_0(_S598, _S604.crossing_2);
    var _S606 : f32;
    if(_S602)
    {
        _S606 = _S604.crossing_2.warp_3.above_0;
    }
    else
    {
        _S606 = _S604.crossing_2.warp_3.below_0;
    }
    probe_1.side_x_0 = _S606;
    if(_S603)
    {
        _S606 = _S604.crossing_2.weft_3.above_0;
    }
    else
    {
        _S606 = _S604.crossing_2.weft_3.below_0;
    }
    probe_1.side_y_0 = _S606;
    probe_1.edge_x_0 = outline_distance_0(_S604.crossing_2.warp_3, _S604.shown_3, _S604.run_3, !_S604.shown_3.is_warp_2, _S602);
    probe_1.edge_y_0 = outline_distance_0(_S604.crossing_2.weft_3, _S604.shown_3, _S604.run_3, _S604.shown_3.is_warp_2, _S603);
    return probe_1;
}

fn is_free_0( _S607 : u32,  _S608 : SearchQuality_0,  _S609 : vec3<f32>,  _S610 : vec3<f32>,  _S611 : bool,  _S612 : f32) -> bool
{
    var _S613 : f32 = _S610.z;
    if(_S613 <= 0.0f)
    {
        return false;
    }
    var _S614 : f32 = 1.0f / max(_S608.shadow_share_0 * steps_per_length_0(_S607, _S608, _S610), 9.99999971718068537e-10f);
    var _S615 : StepControl_0 = step_control_0(_S610.xy, _S614);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S616 : bool;
        if(count_4 < u32(1024))
        {
            _S616 = (_S609.z + _S613 * distance_1) < _S612;
        }
        else
        {
            _S616 = false;
        }
        if(_S616)
        {
        }
        else
        {
            break;
        }
        var _S617 : vec3<f32> = _S609 + _S610 * vec3<f32>(distance_1);
        var _S618 : Probe_0 = probe_0(_S607, _S617.x, _S617.y, _S611, _S615.right_0, _S615.up_0);
        var _S619 : f32 = _S617.z;
        var _S620 : f32 = _S619 - _S618.height_4;
        var _S621 : f32 = _S613 - _S618.slope_x_0 * _S610.x - _S618.slope_y_0 * _S610.y;
        var _S622 : bool;
        if(!_S618.hole_3)
        {
            _S622 = _S620 < 0.0f;
        }
        else
        {
            _S622 = false;
        }
        if(_S622)
        {
            return false;
        }
        var _S623 : f32 = way_back_to_dip_0(previous_3, _S620, _S621, last_step_0, _S618);
        if(_S623 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S623;
            distance_1 = distance_1 - _S623;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S624 : bool = _S619 > (_S618.cell_max_0);
        var _S625 : PreviousSample_0 = after_sample_0(_S620, _S621, _S618, _S624);
        var last_step_2 : f32;
        if(_S624)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S615, _S618.side_x_0, _S618.side_y_0), _S614);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S615, _S618, _S620, _S621);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S625;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S626 : u32,  _S627 : SearchQuality_0,  _S628 : f32,  _S629 : f32,  _S630 : vec3<f32>,  _S631 : bool) -> bool
{
    if(!sample_at_0(_S626, _S628, _S629, _S631).shown_3.hole_2)
    {
        return false;
    }
    var _S632 : vec3<f32> = vec3<f32>(_S628, _S629, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S633 : bool;
        if(side_1 < u32(2))
        {
            _S633 = passes_0;
        }
        else
        {
            _S633 = false;
        }
        if(_S633)
        {
        }
        else
        {
            break;
        }
        var _S634 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S634 = _S630;
        }
        else
        {
            _S634 = vec3<f32>(- _S630.x, - _S630.y, _S630.z);
        }
        var _S635 : bool = is_free_0(_S626, _S627, _S632, _S634, _S631 != (side_1 == u32(1)), fabrics_0[_S626].height_high_0);
        var _S636 : u32 = side_1 + u32(1);
        passes_0 = _S635;
        side_1 = _S636;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_9 : f32,
     last_step_3 : f32,
     depth_1 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S637 : u32,  _S638 : f32,  _S639 : f32,  _S640 : f32,  _S641 : vec3<f32>,  _S642 : bool) -> f32
{
    var _S643 : u32 = locate_0(fabrics_0[_S637].warp_0, _S638).thread_0 / u32(2);
    var _S644 : u32 = locate_0(fabrics_0[_S637].weft_0, _S639).thread_0 / u32(2);
    var _S645 : f32 = _S641.x;
    var _S646 : u32;
    if(_S645 > 0.0f)
    {
        _S646 = u32(1);
    }
    else
    {
        _S646 = u32(0);
    }
    var _S647 : f32 = _S641.y;
    var _S648 : u32;
    if(_S647 > 0.0f)
    {
        _S648 = u32(2);
    }
    else
    {
        _S648 = u32(0);
    }
    var _S649 : u32 = words_0[fabrics_0[_S637].max_heights_0 + u32(4) * (_S644 * fabrics_0[_S637].max_height_columns_0 + _S643) + (_S646 + _S648)];
    var number_2 : i32;
    if(_S642)
    {
        number_2 = i32(4);
    }
    else
    {
        number_2 = i32(0);
    }
    var _S650 : u32 = (_S649 >> (u32(number_2)));
    var _S651 : f32 = max(abs(_S645) * fabrics_0[_S637].threads_per_x_0, abs(_S647) * fabrics_0[_S637].threads_per_y_0) / _S641.z;
    var _S652 : f32 = fabrics_0[_S637].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S637].height_high_0;
    number_2 = i32(3);
    for(;;)
    {
        if(number_2 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S640) * _S651) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, f32((((_S650 >> (u32(i32(8) * number_2)))) & (u32(15)))) * 0.06666667014360428f * _S652);
        }
        number_2 = number_2 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S653 : u32,  _S654 : f32,  _S655 : f32,  _S656 : bool,  _S657 : bool,  _S658 : bool) -> vec3<f32>
{
    var _S659 : Crossing_0 = crossing_at_0(_S653, _S654, _S655, _S656);
    var _S660 : f32 = cell_maximum_0(_S653, _S659);
    var _S661 : f32;
    if(_S657)
    {
        _S661 = _S659.warp_3.above_0;
    }
    else
    {
        _S661 = _S659.warp_3.below_0;
    }
    var _S662 : f32;
    if(_S658)
    {
        _S662 = _S659.weft_3.above_0;
    }
    else
    {
        _S662 = _S659.weft_3.below_0;
    }
    return vec3<f32>(_S660, _S661, _S662);
}

fn first_sample_height_0( _S663 : u32,  _S664 : ViewRay_0,  _S665 : StepControl_0,  _S666 : bool) -> f32
{
    var _S667 : f32 = max_height_along_0(_S663, _S664.origin_0.x, _S664.origin_0.y, 0.0f, vec3<f32>(_S664.slope_1, 1.0f), _S666);
    var count_5 : u32 = u32(0);
    var height_10 : f32 = _S667;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S668 : vec2<f32> = ViewRay_at_0(_S664, height_10);
        var _S669 : vec3<f32> = cell_bounds_0(_S663, _S668.x, _S668.y, _S666, _S665.right_0, _S665.up_0);
        var _S670 : f32 = height_10 - _S669.x;
        var _S671 : f32 = StepControl_to_cell_exit_0(_S665, _S669.y, _S669.z);
        var height_11 : f32 = height_10 - clamp(_S670, 0.0f, _S671);
        if(_S670 <= _S671)
        {
            height_10 = height_11;
            break;
        }
        count_5 = count_5 + u32(1);
        height_10 = height_11;
    }
    return height_10;
}

fn search_down_0( _S672 : u32,  _S673 : ViewRay_0,  _S674 : StepControl_0,  _S675 : bool) -> ViewRayEnd_0
{
    var _S676 : f32 = fabrics_0[_S672].height_low_0 - (fabrics_0[_S672].height_high_0 - fabrics_0[_S672].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_9 = first_sample_height_0(_S672, _S673, _S674, _S675);
    end_1.last_step_3 = _S674.epsilon_0;
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
        var _S677 : vec2<f32> = ViewRay_at_0(_S673, end_1.height_9);
        var _S678 : Probe_0 = probe_0(_S672, _S677.x, _S677.y, _S675, _S674.right_0, _S674.up_0);
        var _S679 : f32 = end_1.height_9 - _S678.height_4;
        var _S680 : f32 = ViewRay_rate_0(_S673, _S678);
        end_1.depth_1 = - _S679;
        end_1.rate_4 = _S680;
        var _S681 : bool;
        if(end_1.previous_4.known_0)
        {
            _S681 = !_S678.hole_3;
        }
        else
        {
            _S681 = false;
        }
        var _S682 : bool;
        if(_S681)
        {
            _S682 = (end_1.previous_4.yarn_1) == (_S678.yarn_2);
        }
        else
        {
            _S682 = false;
        }
        end_1.smooth_0 = _S682;
        var _S683 : bool;
        if(!_S678.hole_3)
        {
            _S683 = _S679 <= 0.0f;
        }
        else
        {
            _S683 = false;
        }
        var _S684 : bool;
        if(_S683)
        {
            _S684 = true;
        }
        else
        {
            _S684 = (end_1.height_9) <= _S676;
        }
        if(_S684)
        {
            break;
        }
        var _S685 : f32 = way_back_to_dip_0(end_1.previous_4, _S679, _S680, end_1.last_step_3, _S678);
        if(_S685 >= 0.0f)
        {
            end_1.height_9 = end_1.height_9 + _S685;
            end_1.last_step_3 = end_1.last_step_3 - _S685;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S686 : f32 = min(StepControl_to_cell_exit_0(_S674, _S678.side_x_0, _S678.side_y_0), end_1.height_9 - _S678.cell_max_0);
        var _S687 : f32 = StepControl_to_next_sample_0(_S674, _S678, _S679, _S680);
        end_1.previous_4 = after_sample_0(_S679, _S680, _S678, _S686 > _S687);
        var _S688 : f32 = max(_S686, _S687);
        end_1.last_step_3 = _S688;
        end_1.height_9 = end_1.height_9 - _S688;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S689 : u32,  _S690 : ViewRay_0,  _S691 : StepControl_0,  _S692 : bool,  _S693 : ViewRayEnd_0,  _S694 : u32) -> f32
{
    var _S695 : f32 = fabrics_0[_S689].height_high_0 - fabrics_0[_S689].height_low_0;
    var above_2 : f32 = _S693.height_9 + _S693.last_step_3;
    var above_gap_1 : f32 = clamp(_S693.previous_4.clearance_0, 0.0f, _S695);
    var under_gap_1 : f32 = clamp(_S693.depth_1, 0.0f, _S695);
    var _S696 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S693.previous_4.rate_0 * _S693.last_step_3, _S693.rate_4 * _S693.last_step_3);
    var middle_0 : f32;
    if(_S693.smooth_0)
    {
        middle_0 = above_2 - _S696 * _S693.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S693.height_9, above_gap_1, under_gap_1);
    }
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S693.height_9;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S694)
        {
        }
        else
        {
            break;
        }
        var _S697 : vec2<f32> = ViewRay_at_0(_S690, middle_0);
        var _S698 : Probe_0 = probe_0(_S689, _S697.x, _S697.y, _S692, _S691.right_0, _S691.up_0);
        var _S699 : f32;
        if(_S698.hole_3)
        {
            _S699 = -1.0e+09f;
        }
        else
        {
            _S699 = _S698.height_4;
        }
        var _S700 : f32 = clamp(middle_0 - _S699, - _S695, _S695);
        var _S701 : f32;
        if(_S700 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S701 = 0.5f * above_gap_2;
            }
            else
            {
                _S701 = above_gap_2;
            }
            var _S702 : f32 = - _S700;
            under_1 = middle_0;
            above_gap_2 = _S701;
            under_gap_2 = _S702;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S701 = 0.5f * under_gap_2;
            }
            else
            {
                _S701 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S700;
            under_gap_2 = _S701;
            side_2 = -1.0f;
        }
        if(_S693.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S700 / min(ViewRay_rate_0(_S690, _S698), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S693.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S703 : u32,  _S704 : SearchQuality_0,  _S705 : f32,  _S706 : f32,  _S707 : vec3<f32>,  _S708 : bool) -> Hit_0
{
    var _S709 : f32 = max(_S707.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S705, _S706);
    var _S710 : vec2<f32> = _S707.xy / vec2<f32>(_S709);
    ray_0.slope_1 = _S710;
    var _S711 : StepControl_0 = step_control_0((vec2<f32>(0) - _S710), 1.0f / max(steps_per_length_0(_S703, _S704, _S707) / _S709, 9.99999971718068537e-10f));
    var _S712 : ViewRayEnd_0 = search_down_0(_S703, ray_0, _S711, _S708);
    var hit_0 : Hit_0;
    hit_0.hole_6 = false;
    var _S713 : f32 = refined_height_0(_S703, ray_0, _S711, _S708, _S712, _S704.refinements_0);
    hit_0.height_7 = _S713;
    var _S714 : vec2<f32> = ViewRay_at_0(ray_0, _S713);
    hit_0.x_15 = _S714.x;
    hit_0.y_8 = _S714.y;
    return hit_0;
}

fn first_hit_0( _S715 : u32,  _S716 : SearchQuality_0,  _S717 : f32,  _S718 : f32,  _S719 : vec3<f32>,  _S720 : bool) -> Hit_0
{
    if(!passes_through_0(_S715, _S716, _S717, _S718, _S719, _S720))
    {
        return first_hit_of_yarn_0(_S715, _S716, _S717, _S718, _S719, _S720);
    }
    var hit_1 : Hit_0;
    hit_1.x_15 = _S717;
    hit_1.y_8 = _S718;
    hit_1.height_7 = 0.0f;
    hit_1.hole_6 = true;
    return hit_1;
}

fn surface_at_0( _S721 : u32,  _S722 : f32,  _S723 : f32,  _S724 : bool) -> SurfacePoint_0
{
    var _S725 : Sample_0 = sample_at_0(_S721, _S722, _S723, _S724);
    var _S726 : f32;
    if(_S725.shown_3.is_warp_2)
    {
        _S726 = _S725.crossing_2.warp_3.half_width_1;
    }
    else
    {
        _S726 = _S725.crossing_2.weft_3.half_width_1;
    }
    var _S727 : u32;
    if(_S725.shown_3.is_warp_2)
    {
        _S727 = fabrics_0[_S721].warp_0;
    }
    else
    {
        _S727 = fabrics_0[_S721].weft_0;
    }
    var _S728 : f32 = families_0[_S727].twist_sine_0;
    var _S729 : f32;
    if(_S724)
    {
        _S729 = -1.0f;
    }
    else
    {
        _S729 = 1.0f;
    }
    var _S730 : f32 = _S728 * _S729;
    var _S731 : f32 = families_0[_S727].twist_cosine_0;
    if(_S725.shown_3.is_warp_2)
    {
        _S729 = 1.0f;
    }
    else
    {
        _S729 = -1.0f;
    }
    var _S732 : vec2<f32> = fibre_direction_0(_S725.slope_across_0, _S729 * _S725.slope_along_0, _S730, _S731);
    var _S733 : f32;
    if(_S725.shown_3.is_warp_2)
    {
        _S733 = _S725.slope_x_1;
    }
    else
    {
        _S733 = _S725.slope_y_1;
    }
    var _S734 : f32;
    if(_S725.shown_3.is_warp_2)
    {
        _S734 = _S725.slope_y_1;
    }
    else
    {
        _S734 = _S725.slope_x_1;
    }
    var _S735 : f32 = _S732.x;
    var _S736 : f32 = _S732.y;
    var _S737 : f32 = _S733 * _S735 + _S729 * _S734 * _S736;
    var _S738 : f32 = _S726 * 1.0154266357421875f;
    var _S739 : f32 = _S738 * arc_sine_0(clamp(_S725.section_1.across_3 / _S738, -1.0f, 1.0f));
    if(_S725.shown_3.is_warp_2)
    {
        _S726 = _S723;
    }
    else
    {
        _S726 = - _S722;
    }
    var point_6 : SurfacePoint_0;
    point_6.hole_4 = _S725.shown_3.hole_2;
    point_6.is_warp_3 = _S725.shown_3.is_warp_2;
    point_6.warp_thread_0 = _S725.crossing_2.warp_3.thread_0;
    point_6.weft_thread_0 = _S725.crossing_2.weft_3.thread_0;
    point_6.height_6 = _S725.height_8;
    point_6.normal_5 = normalize(vec3<f32>(- _S725.slope_x_1, - _S725.slope_y_1, 1.0f));
    var _S740 : vec3<f32>;
    if(_S725.shown_3.is_warp_2)
    {
        _S740 = vec3<f32>(_S735, _S736, _S737);
    }
    else
    {
        _S740 = vec3<f32>(- _S736, _S735, _S737);
    }
    point_6.tangent_4 = normalize(_S740);
    point_6.across_5 = _S725.section_1.across_3;
    point_6.fibre_across_0 = _S739 * _S731 + _S726 * _S730;
    point_6.fibre_along_0 = _S726 * _S731 - _S739 * _S730;
    return point_6;
}

fn has_hairs_0( _S741 : u32) -> bool
{
    var _S742 : bool;
    if((families_0[fabrics_0[_S741].warp_0].hairiness_0) > 0.0f)
    {
        _S742 = true;
    }
    else
    {
        _S742 = (families_0[fabrics_0[_S741].weft_0].hairiness_0) > 0.0f;
    }
    return _S742;
}

fn hair_at_0( _S743 : u32,  _S744 : vec2<f32>,  _S745 : bool,  _S746 : f32) -> Hair_0
{
    var _S747 : f32 = fabrics_0[_S743].fibre_size_0;
    var _S748 : f32 = 17.0f * fabrics_0[_S743].fibre_size_0;
    var _S749 : f32 = fade_0(_S746, _S748);
    var _S750 : vec2<f32> = _S744 / vec2<f32>(_S748);
    var number_3 : u32;
    if(_S745)
    {
        number_3 = u32(1);
    }
    else
    {
        number_3 = u32(0);
    }
    var _S751 : u32 = hash_key_0(number_3, ((fabrics_0[_S743].seed_0) ^ (u32(1013904242))));
    var _S752 : f32 = 1.0f / max(_S746, 0.07999999821186066f * _S747);
    var _S753 : f32 = min(0.63999998569488525f * _S747 * _S752, 1.0f);
    const _S754 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S754;
    number_3 = u32(0);
    for(;;)
    {
        var _S755 : bool;
        if(_S749 > 0.0f)
        {
            _S755 = number_3 < u32(18);
        }
        else
        {
            _S755 = false;
        }
        if(_S755)
        {
        }
        else
        {
            break;
        }
        var _S756 : u32 = number_3 / u32(9);
        var _S757 : u32 = number_3 / u32(3) - u32(3) * _S756;
        var _S758 : vec2<f32> = floor(_S750) + vec2<f32>(f32(number_3 - u32(3) * _S757 - u32(9) * _S756), f32(_S757)) - vec2<f32>(1.0f);
        var _S759 : u32 = hash_bits_0(_S751 + _S756, u32(i32(_S758.x)) * u32(65536) + u32(i32(_S758.y)));
        var _S760 : u32 = hash_bits_0(_S751, _S759);
        var _S761 : vec2<f32> = _S750 - _S758 - vec2<f32>(share_of_0(_S759), share_of_0((_S759 >> (u32(10)))));
        var _S762 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S759 >> (u32(20)))));
        var _S763 : f32 = mix(5.0f, 16.0f, share_of_0((_S760 >> (u32(10))))) / 17.0f;
        var _S764 : f32 = _S761.x;
        var _S765 : f32 = _S762.y;
        var _S766 : f32 = _S761.y;
        var _S767 : f32 = _S762.x;
        var _S768 : f32 = (_S764 * _S765 + _S766 * _S767) / _S763;
        var _S769 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S760 >> (u32(20)))) - 1.0f);
        var _S770 : f32 = 2.0f * _S769 * _S768;
        var _S771 : f32 = rsqrt_0(_S770 * _S770 + 1.0f);
        var _S772 : f32 = (_S766 * _S765 - _S764 * _S767 - _S769 * _S763 * _S768 * _S768) * _S771 * 17.0f;
        var _S773 : f32 = clamp((0.31999999284744263f - abs(_S772)) * _S747 * _S752 + 0.5f, 0.0f, _S753);
        var _S774 : u32;
        if(((((_S760 >> (u32(30)))) & (u32(1)))) == u32(1))
        {
            _S774 = fabrics_0[_S743].warp_0;
        }
        else
        {
            _S774 = fabrics_0[_S743].weft_0;
        }
        var _S775 : bool;
        if((share_of_0(_S760)) < (families_0[_S774].hairiness_0))
        {
            _S775 = (abs(_S768)) < 1.0f;
        }
        else
        {
            _S775 = false;
        }
        var _S776 : bool;
        if(_S775)
        {
            _S776 = _S773 > cover_2;
        }
        else
        {
            _S776 = false;
        }
        if(_S776)
        {
            var _S777 : vec2<f32> = vec2<f32>(- _S767 - _S770 * _S765, _S765 - _S770 * _S767) * vec2<f32>(_S771);
            cover_2 = _S773;
            hair_away_0 = _S772;
            hair_across_0 = _S777;
        }
        number_3 = number_3 + u32(1);
    }
    var _S778 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S749 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S778) * hair_across_0, sqrt(1.0f - _S778 * _S778));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S779 : u32,  _S780 : f32) -> bool
{
    var _S781 : bool;
    if((fabrics_0[_S779].fibre_noise_0) > 0.0f)
    {
        _S781 = true;
    }
    else
    {
        _S781 = (fabrics_0[_S779].colour_noise_0) > 0.0f;
    }
    if(_S781)
    {
        _S781 = true;
    }
    else
    {
        if((fabrics_0[_S779].has_detail_0) != u32(0))
        {
            _S781 = _S780 >= 0.0f;
        }
        else
        {
            _S781 = false;
        }
    }
    return _S781;
}

fn thread_number_0( _S782 : u32,  _S783 : SurfacePoint_0,  _S784 : f32,  _S785 : f32) -> u32
{
    var _S786 : f32;
    if(_S783.is_warp_3)
    {
        _S786 = _S784;
    }
    else
    {
        _S786 = _S785;
    }
    var _S787 : f32 = _S786 - _S783.across_5;
    var _S788 : u32;
    if(_S783.is_warp_3)
    {
        _S788 = fabrics_0[_S782].warp_0;
    }
    else
    {
        _S788 = fabrics_0[_S782].weft_0;
    }
    var _S789 : f32 = families_0[_S788].period_0;
    var _S790 : i32 = i32(families_0[_S788].count_0);
    if(_S783.is_warp_3)
    {
        _S788 = _S783.warp_thread_0;
    }
    else
    {
        _S788 = _S783.weft_thread_0;
    }
    var _S791 : u32 = u32(i32(floor(_S787 / _S789)) * _S790 + i32(_S788)) * u32(2);
    if(_S783.is_warp_3)
    {
        _S788 = u32(1);
    }
    else
    {
        _S788 = u32(0);
    }
    return _S791 + _S788;
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_4 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S792 : u32,  _S793 : u32,  _S794 : SurfacePoint_0,  _S795 : u32,  _S796 : f32) -> FibreNoise_0
{
    var _S797 : f32 = 5.0f * fabrics_0[_S792].fibre_size_0;
    var _S798 : vec2<f32> = wave_noise_0(hash_key_0(_S795, ((fabrics_0[_S792].seed_0) ^ (u32(458671337)))), _S794.fibre_along_0 / (25.0f * fabrics_0[_S792].fibre_size_0));
    var _S799 : f32 = _S794.fibre_across_0 + families_0[_S793].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S792].fibre_size_0 * _S798.x;
    var _S800 : vec3<f32> = fibre_cell_0(_S799, _S794.fibre_along_0, fabrics_0[_S792].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S795, ((fabrics_0[_S792].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S799, _S794.fibre_along_0, _S797));
    noise_0.bundle_weight_0 = fade_0(_S796, _S797);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S795, ((fabrics_0[_S792].seed_0) ^ (u32(48610963)))), _S800);
    noise_0.fibre_weight_0 = fade_0(_S796, fabrics_0[_S792].fibre_size_0);
    noise_0.offset_4 = _S800.z;
    noise_0.slope_2 = 0.5f * _S798.y;
    return noise_0;
}

fn detail_gain_0( _S801 : u32,  _S802 : u32,  _S803 : SurfacePoint_0,  _S804 : vec2<f32>,  _S805 : bool,  _S806 : u32,  _S807 : f32) -> vec2<f32>
{
    var _S808 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S802].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S807, 1.0f / families_0[_S802].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S802, _S803, _S805))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S808;
    }
    if((families_0[_S802].fibre_tone_0) > 0.0f)
    {
        var _S809 : FibreNoise_0 = fibre_noise_at_0(_S801, _S802, _S803, _S806, _S807);
        gain_2 = gain_2 + vec2<f32>(families_0[_S802].fibre_tone_0) * vec2<f32>(_S809.bundle_weight_0 * _S809.bundle_0.y + _S809.fibre_weight_0 * _S809.fibre_0.y, _S809.bundle_weight_0 + _S809.fibre_weight_0);
    }
    if((families_0[_S802].slub_0) > 0.0f)
    {
        var _S810 : f32 = 0.25f * families_0[_S802].slub_0 * fade_0(_S807, 1.0f / families_0[_S802].slubs_per_mm_0);
        var _S811 : f32;
        if(_S803.is_warp_3)
        {
            _S811 = _S804.y;
        }
        else
        {
            _S811 = - _S804.x;
        }
        gain_2 = gain_2 + vec2<f32>(_S810) * vec2<f32>(wave_noise_0(hash_key_0(_S806, ((fabrics_0[_S801].seed_0) ^ (u32(1373058189)))), _S811 * families_0[_S802].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S803.across_5 * families_0[_S802].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S812 : u32,  _S813 : Albedos_0,  _S814 : u32,  _S815 : u32,  _S816 : vec2<f32>) -> Albedos_0
{
    var _S817 : vec3<f32> = max(_S813.specular_reflect_0, _S813.specular_transmit_0);
    var _S818 : vec3<f32> = _S813.diffuse_reflect_0 + _S813.diffuse_transmit_0;
    var _S819 : vec3<f32> = vec3<f32>(fabrics_0[_S812].layer_bound_0);
    var _S820 : vec3<f32> = vec3<f32>(1.0f);
    var _S821 : vec3<f32> = _S820 - _S819 * _S817;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S814, fabrics_0[_S812].colour_noise_0, fabrics_0[_S812].seed_0), _S818, _S821);
    var _S822 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S816.y, vec3<f32>(colour_1) * _S818, _S821) * _S816.x)));
    var _S823 : f32 = bounded_gain_0(fibre_gain_0(_S814, _S815, fabrics_0[_S812].fibre_noise_0, fabrics_0[_S812].seed_0), _S817, min((_S820 - _S822 * _S818) / _S819, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S822 * _S813.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S822 * _S813.diffuse_transmit_0;
    var _S824 : vec3<f32> = vec3<f32>(_S823);
    varied_0.specular_reflect_0 = _S824 * _S813.specular_reflect_0;
    varied_0.specular_transmit_0 = _S824 * _S813.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S825 : u32,  _S826 : SurfacePoint_0,  _S827 : Albedos_0,  _S828 : f32,  _S829 : f32,  _S830 : bool,  _S831 : f32,  _S832 : f32) -> Albedos_0
{
    var _S833 : u32 = thread_number_0(_S825, _S826, _S828, _S829);
    var _S834 : vec3<f32> = fibre_cell_0(_S826.fibre_across_0, _S826.fibre_along_0, fabrics_0[_S825].fibre_size_0);
    var _S835 : vec2<f32> = vec2<f32>(0.0f);
    var _S836 : bool;
    if((fabrics_0[_S825].has_detail_0) != u32(0))
    {
        _S836 = _S831 >= 0.0f;
    }
    else
    {
        _S836 = false;
    }
    var gain_3 : vec2<f32>;
    if(_S836)
    {
        var _S837 : u32;
        if(_S826.is_warp_3)
        {
            _S837 = fabrics_0[_S825].warp_0;
        }
        else
        {
            _S837 = fabrics_0[_S825].weft_0;
        }
        gain_3 = detail_gain_0(_S825, _S837, _S826, vec2<f32>(_S828, _S829), _S830, _S833, _S831) * vec2<f32>(1.0f - _S832, 1.0f);
    }
    else
    {
        gain_3 = _S835;
    }
    return vary_albedos_0(_S825, _S827, _S833, u32(i32(_S834.x)) * u32(65536) + u32(i32(floor(_S834.y))), gain_3);
}

fn turned_frame_0( _S838 : u32,  _S839 : u32,  _S840 : SurfacePoint_0,  _S841 : bool,  _S842 : u32,  _S843 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_6 = _S840.normal_5;
    frame_2.tangent_5 = _S840.tangent_4;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S839].has_plies_0) > 0.0f)
    {
        var _S844 : f32 = fade_0(_S843, 1.0f / families_0[_S839].plies_per_mm_0);
        var _S845 : f32 = _S844 * 0.41999998688697815f * ply_offset_0(_S839, _S840, _S841);
        var _S846 : f32 = sqrt(1.0f - _S845 * _S845);
        var _S847 : f32;
        if(_S841)
        {
            _S847 = - families_0[_S839].ply_sine_0;
        }
        else
        {
            _S847 = families_0[_S839].ply_sine_0;
        }
        var _S848 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S849 : vec3<f32> = vec3<f32>(families_0[_S839].ply_cosine_0);
        var _S850 : vec3<f32> = _S849 * _S848 + vec3<f32>(_S847) * frame_2.tangent_5;
        var _S851 : vec3<f32> = vec3<f32>(_S846);
        var _S852 : vec3<f32> = vec3<f32>(_S845);
        frame_2.tangent_5 = _S849 * (_S849 * frame_2.tangent_5 - vec3<f32>(_S847) * _S848) + vec3<f32>(_S847) * (_S851 * _S850 - _S852 * frame_2.normal_6);
        frame_2.normal_6 = _S851 * frame_2.normal_6 + _S852 * _S850;
        frame_2.loss_0 = _S844 * _S844 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S853 : f32 = families_0[_S839].fibre_tilt_0;
    if((families_0[_S839].fibre_tilt_0) > 0.0f)
    {
        var _S854 : FibreNoise_0 = fibre_noise_at_0(_S838, _S839, _S840, _S842, _S843);
        var _S855 : f32 = 1.09858846664428711f * _S853 * (_S854.bundle_weight_0 * _S854.bundle_0.x + _S854.fibre_weight_0 * (_S854.fibre_0.x + _S854.offset_4));
        var _S856 : f32 = _S853 * (1.42099642753601074f * (_S854.bundle_weight_0 * _S854.bundle_0.y + _S854.fibre_weight_0 * _S854.fibre_0.y) - _S854.bundle_weight_0 * _S854.slope_2);
        var _S857 : f32 = square_1(_S854.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S853 * _S853 * ((0.24761904776096344f * (square_1(_S854.bundle_weight_0) + _S857) + _S857 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S858 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S859 : vec2<f32> = sine_cosine_0(_S855);
        var _S860 : vec2<f32> = sine_cosine_0(_S856);
        var _S861 : vec3<f32> = vec3<f32>(_S859.y);
        var _S862 : vec3<f32> = vec3<f32>(_S859.x);
        var _S863 : vec3<f32> = _S861 * _S858 - _S862 * frame_2.normal_6;
        frame_2.normal_6 = _S861 * frame_2.normal_6 + _S862 * _S858;
        frame_2.tangent_5 = vec3<f32>(_S860.y) * frame_2.tangent_5 + vec3<f32>(_S860.x) * _S863;
    }
    return frame_2;
}

fn yarn_point_of_0( _S864 : u32,  _S865 : SurfacePoint_0,  _S866 : f32,  _S867 : f32,  _S868 : bool,  _S869 : bool,  _S870 : f32) -> YarnPoint_0
{
    var _S871 : u32;
    if(_S865.is_warp_3)
    {
        _S871 = fabrics_0[_S864].warp_0;
    }
    else
    {
        _S871 = fabrics_0[_S864].weft_0;
    }
    var _S872 : bool;
    if((fabrics_0[_S864].has_detail_0) != u32(0))
    {
        _S872 = _S870 >= 0.0f;
    }
    else
    {
        _S872 = false;
    }
    var _S873 : vec3<f32> = vec3<f32>(0.0f);
    var _S874 : Hair_0 = Hair_x24init_0(0.0f, _S873, _S873);
    var _S875 : bool;
    if(_S872)
    {
        _S875 = has_hairs_0(_S864);
    }
    else
    {
        _S875 = false;
    }
    var hair_2 : Hair_0;
    if(_S875)
    {
        hair_2 = hair_at_0(_S864, vec2<f32>(_S866, _S867), _S868, _S870);
    }
    else
    {
        hair_2 = _S874;
    }
    var _S876 : u32;
    if(_S865.is_warp_3)
    {
        _S876 = _S865.warp_thread_0;
    }
    else
    {
        _S876 = _S865.weft_thread_0;
    }
    var albedos_9 : Albedos_0 = albedos_of_0(_S871, _S876);
    var albedos_10 : Albedos_0;
    if(varies_at_0(_S864, _S870))
    {
        albedos_10 = varied_at_0(_S864, _S865, albedos_9, _S866, _S867, _S868, _S870, hair_2.cover_0);
    }
    else
    {
        albedos_10 = albedos_9;
    }
    var point_7 : YarnPoint_0;
    point_7.back_5 = _S868;
    point_7.hole_0 = _S869;
    point_7.is_warp_0 = _S865.is_warp_3;
    point_7.x_8 = _S866;
    point_7.y_3 = _S867;
    point_7.height_2 = _S865.height_6;
    point_7.normal_1 = _S865.normal_5;
    point_7.tangent_0 = _S865.tangent_4;
    point_7.surface_normal_0 = _S865.normal_5;
    point_7.diffuse_gain_0 = 1.0f;
    if(_S872)
    {
        var _S877 : YarnFrame_0 = turned_frame_0(_S864, _S871, _S865, _S868, thread_number_0(_S864, _S865, _S866, _S867), _S870);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S864))
        {
            frame_3 = under_hair_0(_S877, hair_2);
        }
        else
        {
            frame_3 = _S877;
        }
        point_7.normal_1 = frame_3.normal_6;
        point_7.tangent_0 = frame_3.tangent_5;
        point_7.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S864].diffuse_blend_0);
    }
    point_7.roughness_1 = families_0[_S871].roughness_0;
    point_7.albedos_4 = albedos_10;
    return point_7;
}

fn locate_yarn_0( _S878 : u32,  _S879 : SearchQuality_0,  _S880 : f32,  _S881 : f32,  _S882 : vec3<f32>,  _S883 : f32) -> YarnPoint_0
{
    var _S884 : bool = (_S882.z) < 0.0f;
    var _S885 : Hit_0 = first_hit_0(_S878, _S879, _S880, _S881, to_face_frame_0(_S882, _S884), _S884);
    return yarn_point_of_0(_S878, surface_at_0(_S878, _S885.x_15, _S885.y_8, _S884), _S885.x_15, _S885.y_8, _S884, _S885.hole_6, _S883);
}

fn locate_yarn_1( _S886 : u32,  _S887 : SearchQuality_0,  _S888 : f32,  _S889 : f32,  _S890 : vec3<f32>) -> YarnPoint_0
{
    return locate_yarn_0(_S886, _S887, _S888, _S889, _S890, -1.0f);
}

fn residual_point_0( _S891 : u32,  _S892 : ViewedBase_0,  _S893 : vec3<f32>,  _S894 : u32,  _S895 : u32) -> ResidualPoint_0
{
    var _S896 : u32 = _S894 + _S895 * u32(1663821227);
    var _S897 : vec2<f32> = vec2<f32>(uniform_of_0(_S896, u32(1)), uniform_of_0(_S896, u32(2)));
    var _S898 : vec2<f32> = _S892.box_3.corner_1 + _S897 * _S892.box_3.size_1;
    var result_2 : ResidualPoint_0;
    result_2.point_1 = locate_yarn_1(_S891, default_quality_0(), _S898.x, _S898.y, _S893);
    var _S899 : Clustered_std430_0 = fabrics_0[_S891].clustered_0;
    var _S900 : u32 = texel_of_0(&(_S899), _S892.box_3, _S897);
    result_2.texel_0 = _S900;
    return result_2;
}

fn light_sample_count_0( _S901 : i32) -> u32
{
    return frames_0[_S901].lights_0 + frames_0[_S901].environment_samples_0;
}

fn visibility_at_0( _S902 : i32,  _S903 : u32,  _S904 : vec2<u32>) -> f32
{
    if((frames_0[_S902].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S903 * frames_0[_S902].height_0 + _S904.y) * frames_0[_S902].width_0 + _S904.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S905 : i32,  _S906 : u32,  _S907 : u32) -> vec3<f32>
{
    var _S908 : u32 = frames_0[_S905].environment_table_0 + frames_0[_S905].environment_rows_0 + u32(1) + frames_0[_S905].environment_rows_0 * (frames_0[_S905].environment_columns_0 + u32(1)) + u32(3) * (_S906 * frames_0[_S905].environment_columns_0 + _S907);
    return vec3<f32>(scene_number_0(_S908), scene_number_0(_S908 + u32(1)), scene_number_0(_S908 + u32(2)));
}

fn sample_environment_0( _S909 : i32,  _S910 : vec2<f32>,  _S911 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S912 : u32 = frames_0[_S909].environment_rows_0;
    var _S913 : Choice_0 = choose_0(frames_0[_S909].environment_table_0, frames_0[_S909].environment_rows_0, _S910.y);
    var _S914 : u32 = frames_0[_S909].environment_columns_0;
    var _S915 : Choice_0 = choose_0(frames_0[_S909].environment_table_0 + frames_0[_S909].environment_rows_0 + u32(1) + _S913.index_6 * (frames_0[_S909].environment_columns_0 + u32(1)), frames_0[_S909].environment_columns_0, _S910.x);
    var _S916 : vec3<f32> = environment_texel_0(_S909, _S913.index_6, _S915.index_6);
    (*_S911) = _S916 * vec3<f32>((frames_0[_S909].environment_total_0 / max(mean_1(_S916), 9.99999968265522539e-21f)));
    var _S917 : f32 = 3.14159274101257324f / f32(_S912);
    var _S918 : f32 = mix(sine_cosine_0(f32(_S913.index_6) * _S917).y, sine_cosine_0(f32(_S913.index_6 + u32(1)) * _S917).y, _S913.remainder_0);
    var _S919 : f32 = sqrt(max(1.0f - _S918 * _S918, 0.0f));
    var _S920 : vec2<f32> = sine_cosine_0((f32(_S915.index_6) + _S915.remainder_0) * (6.28318548202514648f / f32(_S914)));
    var _S921 : f32 = _S919 * _S920.x;
    var _S922 : f32 = - _S919 * _S920.y;
    return vec3<f32>(frames_0[_S909].environment_cosine_0 * _S921 + frames_0[_S909].environment_sine_0 * _S922, _S918, frames_0[_S909].environment_cosine_0 * _S922 - frames_0[_S909].environment_sine_0 * _S921);
}

fn light_sample_0( _S923 : i32,  _S924 : u32,  _S925 : vec2<u32>,  _S926 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S927 : u32 = frames_0[_S923].lights_0;
    if(_S924 >= (frames_0[_S923].lights_0))
    {
        var weight_2 : vec3<f32>;
        var _S928 : vec3<f32> = sample_environment_0(_S923, pixel_sequence_0(_S925, frames_0[_S923].pass_number_0 * frames_0[_S923].environment_samples_0 + (_S924 - _S927), u32(3)), &(weight_2));
        sample_1.towards_0 = _S928;
        sample_1.irradiance_1 = weight_2 / vec3<f32>(f32(frames_0[_S923].environment_samples_0));
        return sample_1;
    }
    var _S929 : Light_std430_0 = lights_1[_S924];
    sample_1.irradiance_1 = vec3<f32>(_S929.red_0, _S929.green_0, _S929.blue_0);
    sample_1.towards_0 = vec3<f32>(_S929.x_1, _S929.y_1, _S929.z_1);
    if((_S929.is_point_0) != u32(0))
    {
        var _S930 : vec3<f32> = sample_1.towards_0 - _S926;
        var _S931 : f32 = max(square_0(_S930), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S931);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S931);
        sample_1.towards_0 = normalize(_S930);
    }
    return sample_1;
}

fn cluster_density_0( _S932 : u32,  _S933 : ViewedBase_0,  _S934 : BaseTaps_0,  _S935 : u32,  _S936 : u32) -> f32
{
    return BinTaps_read_0(_S934.half_vector_0, fabrics_0[_S932].clustered_0.basis_0, _S933.face_2 * u32(1024), fabrics_0[_S932].clustered_0.clusters_0 * (u32(1) + fabrics_0[_S932].clustered_0.rank_0), _S936 * fabrics_0[_S932].clustered_0.clusters_0 + _S935);
}

struct ClusterTerms_0
{
     diffuse_0 : f32,
     specular_0 : f32,
     lit_0 : f32,
};

fn cluster_attenuation_0( _S937 : u32,  _S938 : ViewedBase_0,  _S939 : BaseTaps_0,  _S940 : u32) -> f32
{
    var _S941 : u32 = fabrics_0[_S937].clustered_0.moments_1 + (_S938.face_2 * fabrics_0[_S937].clustered_0.clusters_0 + _S940) * u32(8);
    var _S942 : vec3<f32> = vec3<f32>(table_number_0(_S941), table_number_0(_S941 + u32(1)), table_number_0(_S941 + u32(2)));
    var _S943 : vec3<f32> = vec3<f32>(table_number_0(_S941 + u32(3)), table_number_0(_S941 + u32(4)), table_number_0(_S941 + u32(5)));
    var _S944 : f32 = table_number_0(_S941 + u32(7));
    var _S945 : f32 = fabrics_0[_S937].optical_depth_0;
    var _S946 : f32 = dot(_S939.facing_0, _S942);
    var _S947 : f32;
    if(_S939.transmits_1)
    {
        _S947 = - _S946;
    }
    else
    {
        _S947 = _S946;
    }
    var _S948 : f32 = max(dot(_S938.view_4, _S942), 0.10000000149011612f);
    var _S949 : f32 = projected_area_1(_S939.facing_0, _S943, _S944) / max(_S947, 0.10000000149011612f);
    var _S950 : f32 = projected_area_1(_S938.view_4, _S943, _S944) / _S948;
    if(!_S939.transmits_1)
    {
        var _S951 : f32 = _S949 + _S950;
        return 0.25f * (1.0f - exponential_0(- _S945 * _S951)) / (_S951 * _S948);
    }
    var _S952 : f32 = max(_S945 * abs(_S949 - _S950), 0.00100000004749745f);
    return 0.25f * _S945 * exponential_0(- _S945 * min(_S949, _S950)) * (1.0f - exponential_0(- _S952)) / (_S952 * _S948);
}

fn cluster_terms_0( _S953 : u32,  _S954 : ViewedBase_0,  _S955 : BaseTaps_0,  _S956 : u32) -> ClusterTerms_0
{
    var _S957 : u32 = u32(2) * fabrics_0[_S953].clustered_0.clusters_0;
    var _S958 : f32 = BinTaps_read_0(_S955.around_0, fabrics_0[_S953].clustered_0.light_0, _S955.first_8, _S957, _S956);
    var _S959 : f32 = BinTaps_read_0(_S954.around_1, fabrics_0[_S953].clustered_0.view_0, _S954.face_2 * u32(256), fabrics_0[_S953].clustered_0.clusters_0, _S956);
    var terms_4 : ClusterTerms_0;
    var _S960 : f32 = _S954.trust_1.x * _S959;
    terms_4.diffuse_0 = _S960 * 0.31830987334251404f * ((1.0f - fabrics_0[_S953].diffuse_blend_0) * abs(_S955.facing_0.z) * _S958 + fabrics_0[_S953].diffuse_blend_0 * BinTaps_read_0(_S955.around_0, fabrics_0[_S953].clustered_0.light_0, _S955.first_8, _S957, fabrics_0[_S953].clustered_0.clusters_0 + _S956));
    terms_4.specular_0 = _S954.trust_1.y * _S959 * _S958 * cluster_attenuation_0(_S953, _S954, _S955, _S956);
    terms_4.lit_0 = _S960 * _S958;
    return terms_4;
}

fn with_cluster_0( _S961 : u32,  _S962 : Components_0,  _S963 : ClusterTerms_0,  _S964 : u32,  _S965 : f32,  _S966 : f32) -> Components_0
{
    var _S967 : bool = _S964 < (fabrics_0[_S961].clustered_0.clusters_0 / u32(2));
    var result_3 : Components_0 = _S962;
    var _S968 : f32;
    if(_S967)
    {
        _S968 = _S965 * _S963.diffuse_0;
    }
    else
    {
        _S968 = 0.0f;
    }
    result_3.diffuse_warp_0 = result_3.diffuse_warp_0 + _S968;
    if(_S967)
    {
        _S968 = 0.0f;
    }
    else
    {
        _S968 = _S965 * _S963.diffuse_0;
    }
    result_3.diffuse_weft_0 = result_3.diffuse_weft_0 + _S968;
    if(_S967)
    {
        _S968 = _S963.specular_0 * _S966;
    }
    else
    {
        _S968 = 0.0f;
    }
    result_3.specular_warp_0 = result_3.specular_warp_0 + _S968;
    if(_S967)
    {
        _S968 = 0.0f;
    }
    else
    {
        _S968 = _S963.specular_0 * _S966;
    }
    result_3.specular_weft_0 = result_3.specular_weft_0 + _S968;
    result_3.light_visibility_1 = result_3.light_visibility_1 + _S965 * _S963.lit_0;
    return result_3;
}

fn clustered_base_0( _S969 : u32,  _S970 : ViewedBase_0,  _S971 : BaseTaps_0) -> Components_0
{
    var _S972 : Clustered_std430_0 = fabrics_0[_S969].clustered_0;
    var _S973 : u32 = _S972.clusters_0;
    var base_1 : Components_0 = no_components_0();
    var cluster_1 : u32 = u32(0);
    for(;;)
    {
        if(cluster_1 < _S973)
        {
        }
        else
        {
            break;
        }
        var _S974 : f32 = box_mean_0(&(_S972), _S970.box_3, _S970.face_2, cluster_1);
        if(_S974 <= 0.0f)
        {
            cluster_1 = cluster_1 + u32(1);
            continue;
        }
        var _S975 : f32 = _S974 * cluster_density_0(_S969, _S970, _S971, cluster_1, u32(0));
        var number_4 : u32 = u32(1);
        var density_0 : f32 = _S975;
        for(;;)
        {
            if(number_4 <= (_S972.rank_0))
            {
            }
            else
            {
                break;
            }
            var _S976 : f32 = box_mean_0(&(_S972), _S970.box_3, _S970.face_2, number_4 * _S973 + cluster_1);
            var density_1 : f32 = density_0 + _S976 * cluster_density_0(_S969, _S970, _S971, cluster_1, number_4);
            number_4 = number_4 + u32(1);
            density_0 = density_1;
        }
        base_1 = with_cluster_0(_S969, base_1, cluster_terms_0(_S969, _S970, _S971, cluster_1), cluster_1, _S974, density_0);
        cluster_1 = cluster_1 + u32(1);
    }
    return base_1;
}

fn under_sheen_0( _S977 : u32,  _S978 : ClusteredView_0,  _S979 : vec3<f32>,  _S980 : f32,  _S981 : vec3<f32>) -> vec3<f32>
{
    var _S982 : f32 = fabrics_0[_S977].sheen_strength_0;
    if((fabrics_0[_S977].sheen_strength_0) <= 0.0f)
    {
        return _S979;
    }
    var _S983 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S981, _S978.base_0.back_9), _S978.base_0.view_4, _S982, fabrics_0[_S977].sheen_roughness_0);
    return vec3<f32>(_S983.y) * _S979 + vec3<f32>((_S980 * _S983.x));
}

fn clustered_base_value_0( _S984 : u32,  _S985 : ClusteredView_0,  _S986 : f32,  _S987 : vec3<f32>) -> vec3<f32>
{
    var _S988 : BaseTaps_0 = base_taps_0(_S985.base_0, _S987);
    var _S989 : Components_0 = clustered_base_0(_S984, _S985.base_0, _S988);
    return under_sheen_0(_S984, _S985, shaded_0(_S989, _S985.albedos_7, _S988.transmits_1) + vec3<f32>((1.0f - _S986)) * bounced_value_0(_S985.bounced_2, _S987, _S985.view_11), _S989.light_visibility_1 + _S986, _S987);
}

fn clustered_at_texel_0( _S990 : u32,  _S991 : ViewedBase_0,  _S992 : u32,  _S993 : BaseTaps_0) -> Components_0
{
    var _S994 : Clustered_std430_0 = fabrics_0[_S990].clustered_0;
    var _S995 : u32 = _S991.face_2 * fabrics_0[_S990].clustered_0.columns_0 * fabrics_0[_S990].clustered_0.rows_0 + _S992;
    var _S996 : u32 = table_byte_0(fabrics_0[_S990].clustered_0.labels_0, _S995);
    var base_2 : Components_0 = no_components_0();
    if(_S996 >= (fabrics_0[_S990].clustered_0.clusters_0))
    {
        return base_2;
    }
    var _S997 : f32 = cluster_density_0(_S990, _S991, _S993, _S996, u32(0));
    var number_5 : u32 = u32(1);
    var density_2 : f32 = _S997;
    for(;;)
    {
        if(number_5 <= (_S994.rank_0))
        {
        }
        else
        {
            break;
        }
        var _S998 : i32 = i32(table_byte_0(_S994.coefficients_0, _S995 * _S994.rank_0 + number_5 - u32(1)));
        var _S999 : i32;
        if(_S998 > i32(127))
        {
            _S999 = _S998 - i32(256);
        }
        else
        {
            _S999 = _S998;
        }
        var density_3 : f32 = density_2 + f32(_S999) * cluster_density_0(_S990, _S991, _S993, _S996, number_5);
        number_5 = number_5 + u32(1);
        density_2 = density_3;
    }
    return with_cluster_0(_S990, base_2, cluster_terms_0(_S990, _S991, _S993, _S996), _S996, 1.0f, density_2);
}

fn unoccluded_0( _S1000 : u32,  _S1001 : SearchQuality_0,  _S1002 : f32,  _S1003 : f32,  _S1004 : f32,  _S1005 : vec3<f32>,  _S1006 : bool) -> bool
{
    if((_S1005.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S1000, _S1001, vec3<f32>(_S1002, _S1003, _S1004 + fabrics_0[_S1000].lift_0), _S1005, _S1006, max_height_along_0(_S1000, _S1002, _S1003, _S1004, _S1005, _S1006));
}

fn is_lit_0( _S1007 : u32,  _S1008 : SearchQuality_0,  _S1009 : YarnPoint_0,  _S1010 : vec3<f32>) -> bool
{
    if(_S1009.hole_0)
    {
        return true;
    }
    var _S1011 : vec3<f32> = to_face_frame_0(_S1010, _S1009.back_5);
    var _S1012 : f32 = _S1011.z;
    var _S1013 : bool = _S1012 < 0.0f;
    var normal_10 : vec3<f32>;
    var height_12 : f32;
    if(_S1013)
    {
        var _S1014 : SurfacePoint_0 = surface_at_0(_S1007, _S1009.x_8, _S1009.y_3, !_S1009.back_5);
        normal_10 = _S1014.normal_5;
        height_12 = _S1014.height_6;
    }
    else
    {
        normal_10 = _S1009.surface_normal_0;
        height_12 = _S1009.height_2;
    }
    var _S1015 : vec3<f32> = vec3<f32>(_S1011.xy, abs(_S1012));
    if((dot(normal_10, _S1015)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S1007, _S1008, _S1009.x_8, _S1009.y_3, height_12, _S1015, (_S1009.back_5) != _S1013);
}

fn components_of_point_0( _S1016 : u32,  _S1017 : SearchQuality_0,  _S1018 : YarnPoint_0,  _S1019 : vec3<f32>,  _S1020 : vec3<f32>) -> Components_0
{
    var result_4 : Components_0 = no_components_0();
    var _S1021 : f32;
    if(_S1018.hole_0)
    {
        _S1021 = 1.0f;
    }
    else
    {
        _S1021 = 0.0f;
    }
    result_4.hole_5 = _S1021;
    var _S1022 : bool;
    if(_S1018.hole_0)
    {
        _S1022 = true;
    }
    else
    {
        _S1022 = !is_lit_0(_S1016, _S1017, _S1018, _S1019);
    }
    if(_S1022)
    {
        return result_4;
    }
    var _S1023 : vec3<f32> = to_face_frame_0(_S1019, _S1018.back_5);
    var _S1024 : vec3<f32> = to_face_frame_0(_S1020, _S1018.back_5);
    var _S1025 : bool = (_S1023.z) < 0.0f;
    var _S1026 : vec3<f32>;
    if(_S1025)
    {
        _S1026 = (vec3<f32>(0) - _S1023);
    }
    else
    {
        _S1026 = _S1023;
    }
    var _S1027 : f32 = _S1018.diffuse_gain_0 * diffuse_reflection_0(_S1026, _S1018.normal_1, fabrics_0[_S1016].diffuse_blend_0);
    if(_S1025)
    {
        _S1021 = transmission_1(_S1023, _S1024, _S1018.normal_1, _S1018.tangent_0, _S1018.roughness_1, fabrics_0[_S1016].optical_depth_0);
    }
    else
    {
        _S1021 = reflection_0(_S1023, _S1024, _S1018.normal_1, _S1018.tangent_0, _S1018.roughness_1, fabrics_0[_S1016].optical_depth_0);
    }
    var _S1028 : f32;
    if(_S1018.is_warp_0)
    {
        _S1028 = _S1027;
    }
    else
    {
        _S1028 = 0.0f;
    }
    result_4.diffuse_warp_0 = _S1028;
    if(_S1018.is_warp_0)
    {
        _S1028 = 0.0f;
    }
    else
    {
        _S1028 = _S1027;
    }
    result_4.diffuse_weft_0 = _S1028;
    if(_S1018.is_warp_0)
    {
        _S1028 = _S1021;
    }
    else
    {
        _S1028 = 0.0f;
    }
    result_4.specular_warp_0 = _S1028;
    if(_S1018.is_warp_0)
    {
        _S1021 = 0.0f;
    }
    result_4.specular_weft_0 = _S1021;
    result_4.light_visibility_1 = 1.0f;
    return result_4;
}

fn clustered_residual_0( _S1029 : u32,  _S1030 : ClusteredView_0,  _S1031 : ResidualPoint_0,  _S1032 : vec3<f32>,  _S1033 : vec3<f32>) -> vec3<f32>
{
    var _S1034 : BaseTaps_0 = base_taps_0(_S1030.base_0, _S1033);
    var _S1035 : Components_0 = clustered_at_texel_0(_S1029, _S1030.base_0, _S1031.texel_0, _S1034);
    var _S1036 : Components_0 = components_of_point_0(_S1029, default_quality_0(), _S1031.point_1, _S1033, _S1030.view_11);
    var own_2 : FamilyAlbedos_0;
    var _S1037 : Albedos_0 = tinted_0(_S1031.point_1.albedos_4, _S1032);
    own_2.warp_4 = _S1037;
    own_2.weft_4 = _S1037;
    return under_sheen_0(_S1029, _S1030, shaded_0(_S1036, own_2, _S1034.transmits_1) - shaded_0(_S1035, _S1030.albedos_7, _S1034.transmits_1) - vec3<f32>(_S1036.hole_5) * bounced_value_0(_S1030.bounced_2, _S1033, _S1030.view_11), _S1036.light_visibility_1 + _S1036.hole_5 - _S1035.light_visibility_1, _S1033);
}

fn passed_by_sheen_0( _S1038 : u32,  _S1039 : f32,  _S1040 : vec3<f32>) -> f32
{
    var _S1041 : f32 = fabrics_0[_S1038].sheen_strength_0;
    if((fabrics_0[_S1038].sheen_strength_0) <= 0.0f)
    {
        return _S1039;
    }
    return _S1039 * (1.0f - _S1041 * sheen_lobe_0(abs(_S1040.z), fabrics_0[_S1038].sheen_roughness_0).z);
}

fn light_of_clustered_0( _S1042 : i32,  _S1043 : u32,  _S1044 : VisiblePoint_0,  _S1045 : vec2<u32>,  _S1046 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = _S1044.draft_0;
    footprint_1.dx_0 = _S1044.draft_dx_0;
    footprint_1.dy_0 = _S1044.draft_dy_0;
    var _S1047 : vec3<f32> = to_local_0(_S1044, _S1044.view_1);
    var _S1048 : Clustered_std430_0 = fabrics_0[_S1043].clustered_0;
    var _S1049 : u32 = mixed_0(mixed_0(_S1045.x + u32(65536) * _S1045.y) + frames_0[_S1042].pass_number_0 * u32(2654435769));
    var _S1050 : bool = (fabrics_0[_S1043].clustered_0.samples_1) == u32(0);
    var _S1051 : ClusteredView_0 = clustered_view_0(_S1043, footprint_1, _S1047, _S1046, _S1049, _S1050);
    var _S1052 : vec3<f32> = vec3<f32>(0.0f);
    var hole_7 : f32;
    if(_S1050)
    {
        hole_7 = clustered_hole_0(_S1043, _S1051.base_0);
    }
    else
    {
        hole_7 = 0.0f;
    }
    var term_2 : u32 = u32(0);
    var hole_8 : f32 = hole_7;
    var radiance_1 : vec3<f32> = _S1052;
    for(;;)
    {
        if(term_2 <= (_S1048.samples_1))
        {
        }
        else
        {
            break;
        }
        var _S1053 : ResidualPoint_0 = ResidualPoint_x24init_0(YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S1052, _S1052, _S1052, 0.0f, 0.0f, Albedos_x24init_0(_S1052, _S1052, _S1052, _S1052)), u32(0));
        var sample_2 : ResidualPoint_0;
        if(term_2 > u32(0))
        {
            var _S1054 : ResidualPoint_0 = residual_point_0(_S1043, _S1051.base_0, _S1047, _S1049, term_2 - u32(1));
            var _S1055 : f32;
            if(_S1054.point_1.hole_0)
            {
                _S1055 = 1.0f;
            }
            else
            {
                _S1055 = 0.0f;
            }
            var hole_9 : f32 = hole_8 + _S1055 / f32(_S1048.samples_1);
            sample_2 = _S1054;
            hole_8 = hole_9;
        }
        else
        {
            sample_2 = _S1053;
        }
        var number_6 : u32 = u32(0);
        var radiance_2 : vec3<f32> = radiance_1;
        for(;;)
        {
            if(number_6 < (light_sample_count_0(_S1042)))
            {
            }
            else
            {
                break;
            }
            var _S1056 : f32 = visibility_at_0(_S1042, number_6, _S1045);
            if(_S1056 <= 0.0f)
            {
                number_6 = number_6 + u32(1);
                continue;
            }
            var _S1057 : LightSample_0 = light_sample_0(_S1042, number_6, _S1045, _S1044.position_0);
            var _S1058 : vec3<f32> = to_local_0(_S1044, _S1057.towards_0);
            var value_1 : vec3<f32>;
            if(term_2 == u32(0))
            {
                value_1 = clustered_base_value_0(_S1043, _S1051, hole_7, _S1058);
            }
            else
            {
                value_1 = clustered_residual_0(_S1043, _S1051, sample_2, _S1046, _S1058) / vec3<f32>(f32(_S1048.samples_1));
            }
            radiance_2 = radiance_2 + vec3<f32>(_S1056) * _S1057.irradiance_1 * value_1;
            number_6 = number_6 + u32(1);
        }
        term_2 = term_2 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - passed_by_sheen_0(_S1043, hole_8, _S1047));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_clustered(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1059 : u32 = id_0.x;
    var _S1060 : u32 = frames_0[i32(0)].width_0;
    var _S1061 : bool;
    if(_S1059 >= (frames_0[i32(0)].width_0))
    {
        _S1061 = true;
    }
    else
    {
        _S1061 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S1061)
    {
        return;
    }
    var _S1062 : u32 = id_0.y * _S1060 + _S1059;
    var _S1063 : u32 = layers_0[_S1062].face_0;
    if((layers_0[_S1062].face_0) == u32(0))
    {
        return;
    }
    var _S1064 : u32 = _S1063 - u32(1);
    var _S1065 : u32 = face_fabrics_0[_S1064];
    var _S1066 : vec2<u32> = id_0.xy;
    var _S1067 : VisiblePoint_0 = visible_point_0(i32(0), _S1065, _S1064, _S1066);
    accumulate_0(_S1062, light_of_clustered_0(i32(0), _S1065, _S1067, _S1066, filtered_albedo_0(_S1065, _S1067)));
    return;
}

