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
     warp_2 : vec3<f32>,
     weft_2 : vec3<f32>,
     leaked_1 : vec3<f32>,
     far_1 : vec3<f32>,
     far_leaked_0 : vec3<f32>,
};

fn bounced_by_0( blocked_0 : Blocked_0,  yarn_0 : Scattered_0,  interior_0 : Interior_0) -> Bounced_0
{
    var _S143 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S144 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_0.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_0.back_4 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_2 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_2) + _S144 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S144 * interior_0.far_1 + yarn_0.back_4 * _S143;
    return bounced_0;
}

fn summed_0( tables_1 : ptr<function, Clustered_std430_0>,  first_3 : u32,  column_0 : u32,  row_3 : u32) -> i32
{
    return i32(words_0[first_3 + (row_3 * ((*tables_1).columns_0 + u32(1)) + column_0) * (*tables_1).channels_0]);
}

fn box_mean_0( tables_2 : ptr<function, Clustered_std430_0>,  box_1 : TexelBox_0,  face_1 : u32,  channel_0 : u32) -> f32
{
    var _S145 : u32 = (*tables_2).columns_0;
    var _S146 : u32 = (*tables_2).rows_0;
    var _S147 : u32 = (*tables_2).sums_0 + face_1 * ((*tables_2).columns_0 + u32(1)) * ((*tables_2).rows_0 + u32(1)) * (*tables_2).channels_0 + channel_0;
    var _S148 : u32 = box_1.last_0.x;
    var _S149 : u32 = box_1.first_2.y;
    var _S150 : i32 = summed_0(&((*tables_2)), _S147, _S148, _S149);
    var _S151 : u32 = box_1.first_2.x;
    var _S152 : i32 = summed_0(&((*tables_2)), _S147, _S151, _S149);
    var _S153 : i32 = _S150 - _S152;
    var _S154 : u32 = box_1.last_0.y;
    var _S155 : i32 = summed_0(&((*tables_2)), _S147, _S148, _S154);
    var _S156 : i32 = summed_0(&((*tables_2)), _S147, _S151, _S154);
    var total_0 : f32 = f32(_S155 - _S156 - _S153);
    var _S157 : f32 = box_1.turns_0.x;
    var _S158 : bool = _S157 > 0.0f;
    var total_1 : f32;
    if(_S158)
    {
        var _S159 : i32 = summed_0(&((*tables_2)), _S147, _S145, _S154);
        var _S160 : i32 = summed_0(&((*tables_2)), _S147, _S145, _S149);
        total_1 = total_0 + _S157 * f32(_S159 - _S160);
    }
    else
    {
        total_1 = total_0;
    }
    var _S161 : f32 = box_1.turns_0.y;
    var _S162 : bool = _S161 > 0.0f;
    if(_S162)
    {
        var _S163 : i32 = summed_0(&((*tables_2)), _S147, _S148, _S146);
        var _S164 : i32 = summed_0(&((*tables_2)), _S147, _S151, _S146);
        total_1 = total_1 + _S161 * f32(_S163 - _S164);
    }
    var _S165 : bool;
    if(_S158)
    {
        _S165 = _S162;
    }
    else
    {
        _S165 = false;
    }
    if(_S165)
    {
        var _S166 : f32 = _S157 * _S161;
        var _S167 : i32 = summed_0(&((*tables_2)), _S147, _S145, _S146);
        total_1 = total_1 + _S166 * f32(_S167);
    }
    return total_1 / (box_1.extent_0.x * box_1.extent_0.y);
}

fn box_mean_1( tables_3 : ptr<function, Clustered_std430_0>,  box_2 : TexelBox_0,  face_2 : u32,  channel_1 : u32) -> f32
{
    var _S168 : u32 = (*tables_3).columns_0;
    var _S169 : u32 = (*tables_3).rows_0;
    var _S170 : u32 = (*tables_3).sums_0 + face_2 * ((*tables_3).columns_0 + u32(1)) * ((*tables_3).rows_0 + u32(1)) * (*tables_3).channels_0 + channel_1;
    var _S171 : u32 = box_2.last_0.x;
    var _S172 : u32 = box_2.first_2.y;
    var _S173 : i32 = summed_0(&((*tables_3)), _S170, _S171, _S172);
    var _S174 : u32 = box_2.first_2.x;
    var _S175 : i32 = summed_0(&((*tables_3)), _S170, _S174, _S172);
    var _S176 : i32 = _S173 - _S175;
    var _S177 : u32 = box_2.last_0.y;
    var _S178 : i32 = summed_0(&((*tables_3)), _S170, _S171, _S177);
    var _S179 : i32 = summed_0(&((*tables_3)), _S170, _S174, _S177);
    var total_2 : f32 = f32(_S178 - _S179 - _S176);
    var _S180 : f32 = box_2.turns_0.x;
    var _S181 : bool = _S180 > 0.0f;
    var total_3 : f32;
    if(_S181)
    {
        var _S182 : i32 = summed_0(&((*tables_3)), _S170, _S168, _S177);
        var _S183 : i32 = summed_0(&((*tables_3)), _S170, _S168, _S172);
        total_3 = total_2 + _S180 * f32(_S182 - _S183);
    }
    else
    {
        total_3 = total_2;
    }
    var _S184 : f32 = box_2.turns_0.y;
    var _S185 : bool = _S184 > 0.0f;
    if(_S185)
    {
        var _S186 : i32 = summed_0(&((*tables_3)), _S170, _S171, _S169);
        var _S187 : i32 = summed_0(&((*tables_3)), _S170, _S174, _S169);
        total_3 = total_3 + _S184 * f32(_S186 - _S187);
    }
    var _S188 : bool;
    if(_S181)
    {
        _S188 = _S185;
    }
    else
    {
        _S188 = false;
    }
    if(_S188)
    {
        var _S189 : f32 = _S180 * _S184;
        var _S190 : i32 = summed_0(&((*tables_3)), _S170, _S168, _S169);
        total_3 = total_3 + _S189 * f32(_S190);
    }
    return total_3 / (box_2.extent_0.x * box_2.extent_0.y);
}

struct ViewedBase_0
{
     view_3 : vec3<f32>,
     back_5 : bool,
     face_3 : u32,
     around_0 : BinTaps_0,
     box_3 : TexelBox_0,
     trust_1 : vec2<f32>,
};

struct FamilyAlbedos_0
{
     warp_3 : Albedos_0,
     weft_3 : Albedos_0,
};

struct ClusteredView_0
{
     base_0 : ViewedBase_0,
     albedos_4 : FamilyAlbedos_0,
     bounced_1 : Bounced_0,
     bounced_warp_0 : Bounced_0,
     bounced_weft_0 : Bounced_0,
     view_4 : vec3<f32>,
     is_alone_0 : bool,
};

fn bounced_by_base_0( seen_0 : ClusteredView_0,  shown_0 : vec2<f32>) -> Bounced_0
{
    var result_1 : Bounced_0;
    var _S191 : vec3<f32> = vec3<f32>(shown_0.x);
    var _S192 : vec3<f32> = vec3<f32>(shown_0.y);
    result_1.reflected_0 = _S191 * seen_0.bounced_warp_0.reflected_0 + _S192 * seen_0.bounced_weft_0.reflected_0;
    result_1.transmitted_0 = _S191 * seen_0.bounced_warp_0.transmitted_0 + _S192 * seen_0.bounced_weft_0.transmitted_0;
    return result_1;
}

fn Albedos_x24init_0( diffuse_reflect_1 : vec3<f32>,  diffuse_transmit_1 : vec3<f32>,  specular_reflect_1 : vec3<f32>,  specular_transmit_1 : vec3<f32>) -> Albedos_0
{
    var _S193 : Albedos_0;
    _S193.diffuse_reflect_0 = diffuse_reflect_1;
    _S193.diffuse_transmit_0 = diffuse_transmit_1;
    _S193.specular_reflect_0 = specular_reflect_1;
    _S193.specular_transmit_0 = specular_transmit_1;
    return _S193;
}

struct YarnPoint_0
{
     back_6 : bool,
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
     albedos_5 : Albedos_0,
};

fn YarnPoint_x24init_0( back_7 : bool,  hole_1 : bool,  is_warp_1 : bool,  x_9 : f32,  y_4 : f32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  surface_normal_1 : vec3<f32>,  diffuse_gain_1 : f32,  roughness_2 : f32,  albedos_6 : Albedos_0) -> YarnPoint_0
{
    var _S194 : YarnPoint_0;
    _S194.back_6 = back_7;
    _S194.hole_0 = hole_1;
    _S194.is_warp_0 = is_warp_1;
    _S194.x_8 = x_9;
    _S194.y_3 = y_4;
    _S194.height_2 = height_3;
    _S194.normal_1 = normal_2;
    _S194.tangent_0 = tangent_1;
    _S194.surface_normal_0 = surface_normal_1;
    _S194.diffuse_gain_0 = diffuse_gain_1;
    _S194.roughness_1 = roughness_2;
    _S194.albedos_5 = albedos_6;
    return _S194;
}

fn Bounced_x24init_0( reflected_1 : vec3<f32>,  transmitted_1 : vec3<f32>) -> Bounced_0
{
    var _S195 : Bounced_0;
    _S195.reflected_0 = reflected_1;
    _S195.transmitted_0 = transmitted_1;
    return _S195;
}

struct ResidualPoint_0
{
     point_1 : YarnPoint_0,
     texel_0 : u32,
     bounced_2 : Bounced_0,
};

fn ResidualPoint_x24init_0( point_2 : YarnPoint_0,  texel_1 : u32,  bounced_3 : Bounced_0) -> ResidualPoint_0
{
    var _S196 : ResidualPoint_0;
    _S196.point_1 = point_2;
    _S196.texel_0 = texel_1;
    _S196.bounced_2 = bounced_3;
    return _S196;
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
     warp_4 : Cell_0,
     weft_4 : Cell_0,
     warp_word_0 : u32,
     weft_word_0 : u32,
     warp_above_0 : bool,
};

fn shown_at_0( crossing_1 : Crossing_0,  back_8 : bool) -> Shown_0
{
    var _S197 : bool = (abs(crossing_1.warp_4.across_0)) < (crossing_1.warp_4.half_width_1);
    var _S198 : bool = (abs(crossing_1.weft_4.across_0)) < (crossing_1.weft_4.half_width_1);
    var shown_1 : Shown_0;
    var _S199 : bool;
    if(_S197)
    {
        if(!_S198)
        {
            _S199 = true;
        }
        else
        {
            _S199 = crossing_1.warp_above_0;
        }
    }
    else
    {
        _S199 = false;
    }
    shown_1.is_warp_2 = _S199;
    if(!_S197)
    {
        _S199 = !_S198;
    }
    else
    {
        _S199 = false;
    }
    shown_1.hole_2 = _S199;
    var _S200 : u32;
    if(shown_1.is_warp_2)
    {
        _S200 = crossing_1.warp_word_0;
    }
    else
    {
        _S200 = crossing_1.weft_word_0;
    }
    shown_1.word_0 = _S200;
    shown_1.on_top_0 = (((_S200 & (u32(1)))) == u32(1)) != back_8;
    return shown_1;
}

fn select_cell_0( is_first_0 : bool,  first_4 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_3 : Cell_0;
    var _S201 : u32;
    if(is_first_0)
    {
        _S201 = first_4.thread_0;
    }
    else
    {
        _S201 = second_0.thread_0;
    }
    cell_3.thread_0 = _S201;
    var _S202 : f32;
    if(is_first_0)
    {
        _S202 = first_4.across_0;
    }
    else
    {
        _S202 = second_0.across_0;
    }
    cell_3.across_0 = _S202;
    if(is_first_0)
    {
        _S202 = first_4.half_width_1;
    }
    else
    {
        _S202 = second_0.half_width_1;
    }
    cell_3.half_width_1 = _S202;
    if(is_first_0)
    {
        _S202 = first_4.below_0;
    }
    else
    {
        _S202 = second_0.below_0;
    }
    cell_3.below_0 = _S202;
    if(is_first_0)
    {
        _S202 = first_4.above_0;
    }
    else
    {
        _S202 = second_0.above_0;
    }
    cell_3.above_0 = _S202;
    return cell_3;
}

fn boundary_0( family_10 : u32,  thread_3 : u32,  step_0 : i32) -> f32
{
    var _S203 : vec2<f32> = turns_and_remainder_0(family_10, f32(i32(thread_3) + step_0));
    return fma(_S203.x, families_0[family_10].period_0, table_number_0(families_0[family_10].place_table_0 + u32(_S203.y) * u32(4)));
}

fn span_0( family_11 : u32,  thread_4 : u32,  first_5 : i32,  last_1 : i32) -> f32
{
    if((families_0[family_11].is_alike_0) != u32(0))
    {
        return f32(last_1 - first_5) * families_0[family_11].size_0;
    }
    return boundary_0(family_11, thread_4, last_1) - boundary_0(family_11, thread_4, first_5);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_12 : u32,  thread_5 : u32) -> Bend_0
{
    var _S204 : u32 = families_0[family_12].bend_table_0;
    var _S205 : u32;
    if((families_0[family_12].is_alike_0) != u32(0))
    {
        _S205 = u32(0);
    }
    else
    {
        _S205 = thread_5 * u32(4);
    }
    var _S206 : u32 = _S204 + _S205;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S206);
    bend_0.half_tangent_0 = table_number_0(_S206 + u32(1));
    bend_0.arc_0 = table_number_0(_S206 + u32(2));
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
    var _S207 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S208 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S209 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S210 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S211 : i32 = - _S207;
    var _S212 : f32 = crossed_0.below_0 + span_0(other_1, crossed_0.thread_0, _S211, i32(0));
    run_0.from_start_0 = _S212;
    var _S213 : i32 = _S208 + i32(1);
    var _S214 : f32 = crossed_0.above_0 + span_0(other_1, crossed_0.thread_0, i32(1), _S213);
    run_0.to_end_0 = _S214;
    var _S215 : bool = _S212 < _S214;
    run_0.near_start_0 = _S215;
    var _S216 : i32;
    if(_S215)
    {
        _S216 = _S211 - _S209;
    }
    else
    {
        _S216 = _S213;
    }
    var _S217 : i32;
    if(run_0.near_start_0)
    {
        _S217 = _S211;
    }
    else
    {
        _S217 = _S213 + _S210;
    }
    run_0.bend_1 = bend_of_0(own_1, thread_6);
    var _S218 : f32;
    if(run_0.straight_0)
    {
        _S218 = 1.0e+06f;
    }
    else
    {
        _S218 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S218;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_1, crossed_0.thread_0, _S216, _S217), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S207 == i32(0);
    run_0.last_crossing_0 = _S208 == i32(0);
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
    var _S219 : f32 = cell_4.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S220 : f32 = clamp(cell_4.across_0, - cell_4.half_width_1, cell_4.half_width_1);
    section_0.across_3 = _S220;
    var _S221 : f32 = _S219 * _S219 - square_1(_S220);
    var _S222 : f32 = rsqrt_0(_S221);
    section_0.drop_0 = _S219 - _S221 * _S222;
    section_0.slope_0 = - _S220 * _S222;
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

fn dive_0( other_2 : u32,  shown_2 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S223 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S224 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S225 : f32;
    if(_S223)
    {
        _S225 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S225 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S226 : f32 = _S225 - crossed_1.half_width_1;
    var _S227 : bool;
    if(_S223)
    {
        _S227 = run_1.first_crossing_0;
    }
    else
    {
        _S227 = run_1.last_crossing_0;
    }
    if(shown_2.on_top_0)
    {
        _S225 = 0.0f;
    }
    else
    {
        _S225 = families_0[other_2].height_scale_0 * edge_drop_0(other_2, crossed_1.thread_0, i32(0));
    }
    var _S228 : f32;
    if((shown_2.on_top_0) != _S227)
    {
        _S228 = 0.0f;
    }
    else
    {
        var _S229 : f32 = families_0[other_2].height_scale_0;
        var _S230 : i32;
        if(_S223)
        {
            _S230 = i32(-1);
        }
        else
        {
            _S230 = i32(1);
        }
        _S228 = _S229 * edge_drop_0(other_2, crossed_1.thread_0, _S230);
    }
    var _S231 : f32 = 1.0f / max(2.0f * _S226, 9.999999960041972e-13f);
    var _S232 : f32 = clamp((_S226 - _S224) * _S231, 0.0f, 1.0f);
    var _S233 : f32 = _S225 + (_S228 - _S225) * (_S232 * _S232 * (3.0f - 2.0f * _S232));
    var _S234 : f32 = (_S225 - _S228) * (6.0f * _S232 * (1.0f - _S232) * _S231);
    if(_S223)
    {
        _S225 = 1.0f;
    }
    else
    {
        _S225 = -1.0f;
    }
    return vec2<f32>(_S233, _S234 * _S225);
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
    var _S235 : f32 = direction_3.x;
    control_0.per_x_0 = 1.0f / max(abs(_S235), 9.99999971718068537e-10f);
    var _S236 : f32 = direction_3.y;
    control_0.per_y_0 = 1.0f / max(abs(_S236), 9.99999971718068537e-10f);
    control_0.right_0 = _S235 > 0.0f;
    control_0.up_0 = _S236 > 0.0f;
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

fn outline_distance_0( cell_5 : Cell_0,  shown_3 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S237 : f32;
    if(forwards_0)
    {
        _S237 = cell_5.across_0;
    }
    else
    {
        _S237 = - cell_5.across_0;
    }
    var _S238 : f32;
    if(forwards_0)
    {
        _S238 = cell_5.above_0;
    }
    else
    {
        _S238 = cell_5.below_0;
    }
    var _S239 : bool;
    if(forwards_0)
    {
        _S239 = run_2.last_crossing_0;
    }
    else
    {
        _S239 = run_2.first_crossing_0;
    }
    var _S240 : bool;
    if(forwards_0)
    {
        _S240 = run_2.first_crossing_0;
    }
    else
    {
        _S240 = run_2.last_crossing_0;
    }
    var _S241 : f32 = - cell_5.half_width_1;
    var _S242 : bool = _S237 < _S241;
    var _S243 : bool = _S237 >= (cell_5.half_width_1);
    if(lengthwise_0)
    {
        _S239 = !_S239;
    }
    else
    {
        _S239 = false;
    }
    if(_S239)
    {
        _S239 = !shown_3.hole_2;
    }
    else
    {
        _S239 = false;
    }
    var _S244 : bool;
    if(_S239)
    {
        _S244 = shown_3.on_top_0;
    }
    else
    {
        _S244 = false;
    }
    if(_S244)
    {
        if(_S240)
        {
            _S240 = _S242;
        }
        else
        {
            _S240 = false;
        }
        _S240 = !_S240;
    }
    else
    {
        _S240 = false;
    }
    if(shown_3.hole_2)
    {
        _S239 = true;
    }
    else
    {
        if(_S239)
        {
            _S239 = !shown_3.on_top_0;
        }
        else
        {
            _S239 = false;
        }
    }
    var _S245 : f32;
    if(_S242)
    {
        _S245 = _S241;
    }
    else
    {
        _S245 = cell_5.half_width_1;
    }
    var _S246 : f32 = _S245 - _S237;
    if(_S239)
    {
        _S237 = 2.0f * _S238 + _S237 - cell_5.half_width_1;
    }
    else
    {
        _S237 = _S238;
    }
    if(_S240)
    {
        if(forwards_0)
        {
            _S237 = run_2.to_end_0;
        }
        else
        {
            _S237 = run_2.from_start_0;
        }
        return _S237;
    }
    if(_S243)
    {
    }
    else
    {
        _S237 = _S246;
    }
    return _S237;
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
    var _S247 : f32 = previous_1.rate_0 * step_4;
    var _S248 : f32 = rate_1 * step_4;
    var _S249 : bool;
    if(!previous_1.known_0)
    {
        _S249 = true;
    }
    else
    {
        _S249 = here_0.hole_3;
    }
    if(_S249)
    {
        _S249 = true;
    }
    else
    {
        _S249 = (previous_1.yarn_1) != (here_0.yarn_2);
    }
    if(_S249)
    {
        _S249 = true;
    }
    else
    {
        _S249 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S249)
    {
        _S249 = true;
    }
    else
    {
        _S249 = rate_1 <= 0.0f;
    }
    if(_S249)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S247) >= 0.0f)
    {
        _S249 = (3.0f * clearance_1 - _S248) >= 0.0f;
    }
    else
    {
        _S249 = false;
    }
    if(_S249)
    {
        return -1.0f;
    }
    var _S250 : f32 = clearance_1 - previous_1.clearance_0;
    var _S251 : f32 = 6.0f * _S250 - 4.0f * _S247 - 2.0f * _S248;
    var _S252 : f32 = -2.0f * _S247 / max(_S251 + sqrt(max(_S251 * _S251 - 4.0f * (3.0f * (_S247 + _S248 - 2.0f * _S250)) * _S247, 0.0f)), 9.99999968265522539e-21f);
    var _S253 : f32 = 1.0f - _S252;
    var _S254 : f32 = (previous_1.clearance_0 * (2.0f * _S252 + 1.0f) + _S247 * _S252) * _S253 * _S253;
    var _S255 : f32 = (clearance_1 * (2.0f * _S253 + 1.0f) - _S248 * _S253) * _S252 * _S252;
    if(_S252 > 0.01999999955296516f)
    {
        _S249 = _S253 > 0.01999999955296516f;
    }
    else
    {
        _S249 = false;
    }
    if(_S249)
    {
        _S249 = (_S254 + _S255) < 0.0f;
    }
    else
    {
        _S249 = false;
    }
    var _S256 : f32;
    if(_S249)
    {
        _S256 = _S253 * step_4;
    }
    else
    {
        _S256 = -1.0f;
    }
    return _S256;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S257 : f32;
    if(here_1.hole_3)
    {
        _S257 = 1.0e+09f;
    }
    else
    {
        _S257 = clearance_2;
    }
    previous_2.clearance_0 = _S257;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_1 = here_1.yarn_2;
    var _S258 : bool;
    if(!here_1.hole_3)
    {
        _S258 = !is_cell_exit_0;
    }
    else
    {
        _S258 = false;
    }
    previous_2.known_0 = _S258;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_5 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_5.per_x_0, side_y_1 * this_5.per_y_0), 0.0f) + this_5.epsilon_0;
}

fn StepControl_to_next_sample_0( this_6 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S259 : f32 = min(here_2.edge_x_0 * this_6.per_x_0, here_2.edge_y_0 * this_6.per_y_0);
    var _S260 : bool;
    if(!here_2.hole_3)
    {
        _S260 = (rate_3 * _S259 + clearance_3) < 0.0f;
    }
    else
    {
        _S260 = false;
    }
    if(_S260)
    {
        _S260 = _S259 > (2.0f * this_6.epsilon_0);
    }
    else
    {
        _S260 = false;
    }
    var _S261 : f32;
    if(_S260)
    {
        _S261 = _S259 - this_6.epsilon_0;
    }
    else
    {
        _S261 = max(_S259, 0.0f) + this_6.epsilon_0;
    }
    return min(this_6.step_2, _S261);
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
    var _S262 : f32 = end_0 - start_1;
    var _S263 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S262;
    var _S264 : f32 = 3.0f * _S262 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S262, 9.99999968265522539e-21f);
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
        var _S265 : f32 = clamp(share_1 - (((_S263 * share_1 + _S264) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S263 * share_1 + 2.0f * _S264) * share_1 + start_rate_0, 0.10000000149011612f * _S262 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S266 : i32 = i_0 + i32(1);
        share_1 = _S265;
        i_0 = _S266;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S267 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S268 : f32 = rsqrt_0(_S267);
    var _S269 : f32 = sine_1 * _S268 * rsqrt_0(_S267 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S269 * _S267, _S269 * across_slope_0 * along_slope_0 + cosine_0 * _S268);
}

fn arc_sine_0( x_10 : f32) -> f32
{
    var _S270 : f32 = abs(x_10);
    var _S271 : bool = _S270 > 0.5f;
    var _S272 : f32;
    if(_S271)
    {
        _S272 = 0.5f * (1.0f - _S270);
    }
    else
    {
        _S272 = _S270 * _S270;
    }
    var _S273 : f32;
    if(_S271)
    {
        _S273 = sqrt(max(_S272, 0.0f));
    }
    else
    {
        _S273 = _S270;
    }
    var _S274 : f32 = ((((0.04216320067644119f * _S272 + 0.02418131195008755f) * _S272 + 0.04547002539038658f) * _S272 + 0.07495300471782684f) * _S272 + 0.16666752099990845f) * _S272 * _S273 + _S273;
    if(_S271)
    {
        _S272 = 1.57079637050628662f - 2.0f * _S274;
    }
    else
    {
        _S272 = _S274;
    }
    if(x_10 < 0.0f)
    {
        _S272 = - _S272;
    }
    return _S272;
}

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S275 : Hair_0;
    _S275.cover_0 = cover_1;
    _S275.normal_3 = normal_4;
    _S275.tangent_2 = tangent_3;
    return _S275;
}

fn fade_0( size_3 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_3 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S276 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S277 : u32 = ((((_S276 >> ((((_S276 >> (u32(28)))) + u32(4))))) ^ (_S276))) * u32(277803737);
    return (((_S277 >> (u32(22)))) ^ (_S277));
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
    var _S278 : f32 = floor(x_11 * 0.63661974668502808f + 0.5f);
    var _S279 : f32 = x_11 - _S278 * 1.5703125f - _S278 * 0.00048375129699707f - _S278 * 7.54979012640433211e-08f;
    var _S280 : f32 = _S279 * _S279;
    var _S281 : f32 = ((-0.00019515295571182f * _S280 + 0.00833216123282909f) * _S280 - 0.16666655242443085f) * _S280 * _S279 + _S279;
    var _S282 : f32 = ((0.00002443315679557f * _S280 - 0.00138873164542019f) * _S280 + 0.04166664555668831f) * _S280 * _S280 - 0.5f * _S280 + 1.0f;
    var _S283 : u32 = (u32(i32(_S278)) & (u32(3)));
    var _S284 : vec2<f32>;
    if(((_S283 & (u32(1)))) != u32(0))
    {
        _S284 = vec2<f32>(_S282, _S281);
    }
    else
    {
        _S284 = vec2<f32>(_S281, _S282);
    }
    var _S285 : f32;
    if(((_S283 & (u32(2)))) != u32(0))
    {
        _S285 = - _S284.x;
    }
    else
    {
        _S285 = _S284.x;
    }
    var _S286 : f32;
    if((((_S283 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S286 = - _S284.y;
    }
    else
    {
        _S286 = _S284.y;
    }
    return vec2<f32>(_S285, _S286);
}

fn albedos_of_0( family_14 : u32,  thread_9 : u32) -> Albedos_0
{
    return table_albedos_0(families_0[family_14].albedo_table_0 + families_0[family_14].albedo_stride_0 * thread_9);
}

fn fibre_cell_0( across_4 : f32,  along_1 : f32,  width_3 : f32) -> vec3<f32>
{
    var _S287 : f32 = floor(across_4 / width_3);
    return vec3<f32>(_S287, along_1 / (width_3 * 40.0f) + 0.61799997091293335f * _S287, 2.0f * (across_4 / width_3 - _S287) - 1.0f);
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

fn ply_offset_0( family_15 : u32,  point_3 : SurfacePoint_0,  back_9 : bool) -> f32
{
    var _S288 : f32;
    if(back_9)
    {
        _S288 = - families_0[family_15].ply_sine_0;
    }
    else
    {
        _S288 = families_0[family_15].ply_sine_0;
    }
    var _S289 : f32 = (point_3.fibre_across_0 * families_0[family_15].ply_cosine_0 + point_3.fibre_along_0 * _S288) * families_0[family_15].plies_per_mm_0;
    return 2.0f * (_S289 - floor(_S289)) - 1.0f;
}

fn signed_noise_0( bits_3 : u32) -> f32
{
    return (f32((bits_3 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_1 : u32,  position_5 : f32) -> vec2<f32>
{
    var _S290 : f32 = floor(position_5);
    var _S291 : f32 = position_5 - _S290;
    var _S292 : u32 = u32(i32(_S290));
    var _S293 : f32 = signed_noise_0(hash_bits_0(key_1, _S292));
    var _S294 : f32 = signed_noise_0(hash_bits_0(key_1, _S292 + u32(1)));
    return vec2<f32>(mix(_S293, _S294, smooth_share_0(_S291)), 6.0f * _S291 * (1.0f - _S291) * (_S294 - _S293));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S295 : f32 = cell_7.y;
    var _S296 : f32 = floor(_S295);
    var _S297 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S296));
    var _S298 : u32 = hash_bits_0(key_2, _S297);
    var _S299 : u32 = hash_bits_0(key_2, _S297 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S298), signed_noise_0((_S298 >> (u32(16))))), vec2<f32>(signed_noise_0(_S299), signed_noise_0((_S299 >> (u32(16))))), vec2<f32>(smooth_share_0(_S295 - _S296)));
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
    var _S300 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S300.x, _S300.y), _S300.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S301 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S301.x, _S301.y), _S301.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
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
    var _S302 : vec3<f32>;
    if((dot(frame_0.tangent_5, hair_0.tangent_2)) < 0.0f)
    {
        _S302 = (vec3<f32>(0) - hair_0.tangent_2);
    }
    else
    {
        _S302 = hair_0.tangent_2;
    }
    var blended_0 : YarnFrame_0;
    var _S303 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S304 : vec3<f32> = normalize(mix(frame_0.normal_6, hair_0.normal_3, _S303));
    blended_0.normal_6 = _S304;
    var _S305 : vec3<f32> = mix(frame_0.tangent_5, _S302, _S303);
    var _S306 : vec3<f32> = _S305 - vec3<f32>(dot(_S305, _S304)) * _S304;
    blended_0.tangent_5 = _S306 * vec3<f32>(rsqrt_0(max(dot(_S306, _S306), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_2( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_6.z - 1.0f) + 1.0f));
}

fn texel_along_0( share_3 : f32,  first_6 : u32,  extent_1 : f32,  count_2 : u32) -> u32
{
    var _S307 : f32 = min(floor(share_3 * extent_1), extent_1 - 1.0f);
    var _S308 : f32 = f32(count_2);
    var _S309 : u32 = first_6 + min(u32(max(_S307 - floor(_S307 / _S308) * _S308, 0.0f)), count_2 - u32(1));
    var _S310 : u32;
    if(_S309 >= count_2)
    {
        _S310 = _S309 - count_2;
    }
    else
    {
        _S310 = _S309;
    }
    return _S310;
}

fn texel_of_0( tables_4 : ptr<function, Clustered_std430_0>,  box_4 : TexelBox_0,  share_4 : vec2<f32>) -> u32
{
    return texel_along_0(share_4.y, box_4.first_2.y, box_4.extent_0.y, (*tables_4).rows_0) * (*tables_4).columns_0 + texel_along_0(share_4.x, box_4.first_2.x, box_4.extent_0.x, (*tables_4).columns_0);
}

fn table_byte_0( table_1 : u32,  index_4 : u32) -> u32
{
    return (((words_0[table_1 + index_4 / u32(4)] >> ((u32(8) * ((index_4 & (u32(3)))))))) & (u32(255)));
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_5 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S311 : u32 = pixel_0.x;
    var _S312 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S311, _S312, stream_2), uniform_hash_0(_S311, _S312, stream_2 + u32(1))) + vec2<f32>(f32((index_5 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn scene_number_0( index_6 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_6])));
}

struct Choice_0
{
     index_7 : u32,
     remainder_0 : f32,
};

fn choose_0( table_2 : u32,  count_3 : u32,  number_1 : f32) -> Choice_0
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
        var _S313 : u32 = (low_1 + high_1) / u32(2);
        if((scene_number_0(table_2 + _S313)) <= number_1)
        {
            low_1 = _S313;
        }
        else
        {
            high_1 = _S313;
        }
    }
    var _S314 : u32 = table_2 + low_1;
    var _S315 : f32 = scene_number_0(_S314);
    var _S316 : f32 = scene_number_0(_S314 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_7 = low_1;
    choice_0.remainder_0 = saturate((number_1 - _S315) / max(_S316 - _S315, 9.999999960041972e-13f));
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
     around_1 : BinTaps_0,
     first_7 : u32,
     half_vector_0 : BinTaps_0,
};

fn base_taps_0( seen_1 : ViewedBase_0,  light_1 : vec3<f32>) -> BaseTaps_0
{
    var taps_1 : BaseTaps_0;
    var _S317 : vec3<f32> = to_face_frame_0(light_1, seen_1.back_5);
    taps_1.facing_0 = _S317;
    var _S318 : f32 = _S317.z;
    var _S319 : bool = _S318 < 0.0f;
    taps_1.transmits_1 = _S319;
    taps_1.around_1 = bin_taps_0(vec3<f32>(_S317.xy, abs(_S318)), u32(32));
    var _S320 : u32 = seen_1.face_3 * u32(2);
    var _S321 : u32;
    if(_S319)
    {
        _S321 = u32(1);
    }
    else
    {
        _S321 = u32(0);
    }
    taps_1.first_7 = (_S320 + _S321) * u32(1024);
    var _S322 : vec3<f32> = taps_1.facing_0 + seen_1.view_3;
    var half_vector_1 : vec3<f32> = _S322 * vec3<f32>((1.0f / sqrt(max(square_0(_S322), 9.999999960041972e-13f))));
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
    var _S323 : f32 = dot(direction_4, tangent_6);
    return sqrt(max((roughness_3 + 1.0f) * (roughness_3 - 1.0f) * _S323 * _S323 + 1.0f, roughness_3 * roughness_3));
}

fn shaded_0( components_0 : Components_0,  albedos_7 : FamilyAlbedos_0,  transmits_2 : bool) -> vec3<f32>
{
    if(transmits_2)
    {
        return albedos_7.warp_3.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_7.weft_3.diffuse_transmit_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_7.warp_3.specular_transmit_0 * vec3<f32>(components_0.specular_warp_0) + albedos_7.weft_3.specular_transmit_0 * vec3<f32>(components_0.specular_weft_0);
    }
    return albedos_7.warp_3.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_warp_0) + albedos_7.weft_3.diffuse_reflect_0 * vec3<f32>(components_0.diffuse_weft_0) + albedos_7.warp_3.specular_reflect_0 * vec3<f32>(components_0.specular_warp_0) + albedos_7.weft_3.specular_reflect_0 * vec3<f32>(components_0.specular_weft_0);
}

fn bounced_value_0( bounced_4 : Bounced_0,  light_2 : vec3<f32>,  view_5 : vec3<f32>) -> vec3<f32>
{
    var _S324 : f32 = light_2.z;
    var _S325 : vec3<f32>;
    if((_S324 * view_5.z) < 0.0f)
    {
        _S325 = bounced_4.transmitted_0;
    }
    else
    {
        _S325 = bounced_4.reflected_0;
    }
    return _S325 * vec3<f32>((abs(_S324) * 0.31830987334251404f));
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
    var _S326 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S327 : f32 = 2.0f * sqrt(_S326) - 1.0f;
    var _S328 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_4, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S327, _S328), 0.00999999977648258f, 1.0f), clamp((1.0f - _S326) * sheen_shear_0(_S327, _S328), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S327, _S328), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_3 : vec3<f32>,  view_6 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S329 : f32 = light_3.z;
    var _S330 : bool;
    if(_S329 <= 0.0f)
    {
        _S330 = true;
    }
    else
    {
        _S330 = (view_6.z) <= 0.0f;
    }
    if(_S330)
    {
        return 0.0f;
    }
    var _S331 : vec2<f32> = view_6.xy;
    var _S332 : f32 = dot(_S331, _S331);
    var _S333 : vec2<f32>;
    if(_S332 > 9.99999968265522539e-21f)
    {
        _S333 = _S331 * vec2<f32>(rsqrt_0(_S332));
    }
    else
    {
        _S333 = vec2<f32>(1.0f, 0.0f);
    }
    var _S334 : f32 = scale_0 * dot(light_3.xy, _S333) + shear_0 * _S329;
    var _S335 : f32 = scale_0 * (light_3.y * _S333.x - light_3.x * _S333.y);
    var _S336 : f32 = _S334 * _S334 + _S335 * _S335 + _S329 * _S329;
    return 0.31830987334251404f * scale_0 * scale_0 * _S329 / max(_S336 * _S336, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_4 : vec3<f32>,  view_7 : vec3<f32>,  strength_0 : f32,  roughness_5 : f32) -> vec2<f32>
{
    var _S337 : vec3<f32> = sheen_lobe_0(view_7.z, roughness_5);
    var _S338 : f32 = strength_0 * _S337.z;
    return vec2<f32>(_S338 * transformed_cosine_0(light_4, view_7, _S337.x, _S337.y), 1.0f - _S338);
}

fn diffuse_reflection_0( light_5 : vec3<f32>,  normal_7 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S339 : f32 = light_5.z;
    if(_S339 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S339, 0.0f), max(dot(light_5, normal_7), 0.0f), blend_1);
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
    var _S340 : f32 = roughness_6 * roughness_6;
    var _S341 : f32 = squared_along_0 * (1.0f - _S340) + _S340;
    return 0.31830987334251404f * _S340 * roughness_6 / (_S341 * _S341);
}

fn density_between_0( light_6 : vec3<f32>,  view_8 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_7 : f32) -> f32
{
    var _S342 : vec3<f32> = light_6 + view_8;
    var _S343 : f32 = dot(_S342, tangent_7);
    return flake_density_0(min(_S343 * _S343 / max(square_0(_S342), 9.999999960041972e-13f), 1.0f), roughness_7);
}

fn transmission_1( light_7 : vec3<f32>,  view_9 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_8 : f32,  optical_depth_1 : f32) -> f32
{
    var _S344 : f32 = - dot(light_7, normal_8);
    var _S345 : f32 = dot(view_9, normal_8);
    var _S346 : bool;
    if(_S344 <= 0.0f)
    {
        _S346 = true;
    }
    else
    {
        _S346 = _S345 <= 0.0f;
    }
    if(_S346)
    {
        return 0.0f;
    }
    var _S347 : f32 = 1.0f / max(_S345, 9.99999997475242708e-07f);
    var _S348 : f32 = projected_area_1(light_7, tangent_8, roughness_8) / max(_S344, 9.99999997475242708e-07f);
    var _S349 : f32 = projected_area_1(view_9, tangent_8, roughness_8) * _S347;
    return density_between_0(light_7, view_9, tangent_8, roughness_8) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S348, _S349)) * mean_attenuation_0(optical_depth_1 * abs(_S348 - _S349)) * _S347;
}

fn reflection_0( light_8 : vec3<f32>,  view_10 : vec3<f32>,  normal_9 : vec3<f32>,  tangent_9 : vec3<f32>,  roughness_9 : f32,  optical_depth_2 : f32) -> f32
{
    var _S350 : f32 = dot(light_8, normal_9);
    var _S351 : bool;
    if(_S350 <= 0.0f)
    {
        _S351 = true;
    }
    else
    {
        _S351 = (dot(view_10, normal_9)) <= 0.0f;
    }
    if(_S351)
    {
        return 0.0f;
    }
    var _S352 : f32 = max(_S350, 9.99999997475242708e-07f);
    var _S353 : f32 = max(dot(view_10, normal_9), 9.99999997475242708e-07f);
    var _S354 : f32 = projected_area_1(light_8, tangent_9, roughness_9) * _S353 + projected_area_1(view_10, tangent_9, roughness_9) * _S352;
    var _S355 : f32 = optical_depth_2 * _S354 / (_S352 * _S353);
    return 0.25f * density_between_0(light_8, view_10, tangent_9, roughness_9) * (_S355 * mean_attenuation_0(_S355)) * _S352 / _S354;
}

fn accumulate_0( index_8 : u32,  light_9 : vec4<f32>)
{
    var _S356 : f32 = layers_0[index_8].share_0;
    radiance_0[index_8] = radiance_0[index_8] + vec4<f32>(layers_0[index_8].share_0) * light_9;
    layers_0[index_8].share_0 = _S356 * (1.0f - light_9.w);
    return;
}

fn camera_right_0( _S357 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S357].right_x_0, frames_0[_S357].right_y_0, frames_0[_S357].right_z_0);
}

fn camera_up_0( _S358 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S358].up_x_0, frames_0[_S358].up_y_0, frames_0[_S358].up_z_0);
}

fn camera_forward_0( _S359 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S359].forward_x_0, frames_0[_S359].forward_y_0, frames_0[_S359].forward_z_0);
}

fn camera_origin_0( _S360 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S360].origin_x_0, frames_0[_S360].origin_y_0, frames_0[_S360].origin_z_0);
}

fn face_point_0( _S361 : u32,  _S362 : u32,  _S363 : f32,  _S364 : f32) -> VisiblePoint_0
{
    var _S365 : u32 = u32(3) * _S362;
    var _S366 : Vertex_std430_0 = vertices_0[corners_0[_S365]];
    var _S367 : Vertex_std430_0 = vertices_0[corners_0[_S365 + u32(1)]];
    var _S368 : Vertex_std430_0 = vertices_0[corners_0[_S365 + u32(2)]];
    var _S369 : vec3<f32> = position_of_0(&(_S367));
    var _S370 : vec3<f32> = position_of_0(&(_S366));
    var _S371 : vec3<f32> = _S369 - _S370;
    var _S372 : vec3<f32> = position_of_0(&(_S368));
    var _S373 : vec3<f32> = _S372 - _S370;
    var _S374 : f32 = _S366.u_0;
    var _S375 : f32 = _S367.u_0 - _S366.u_0;
    var _S376 : f32 = _S366.v_0;
    var _S377 : f32 = _S367.v_0 - _S366.v_0;
    var _S378 : vec2<f32> = vec2<f32>(_S375, _S377);
    var _S379 : f32 = _S368.u_0 - _S366.u_0;
    var _S380 : f32 = _S368.v_0 - _S366.v_0;
    var _S381 : vec2<f32> = vec2<f32>(_S379, _S380);
    var _S382 : f32;
    if((_S375 * _S380 - _S377 * _S379) < 0.0f)
    {
        _S382 = -1.0f;
    }
    else
    {
        _S382 = 1.0f;
    }
    var _S383 : vec3<f32> = vec3<f32>(_S382) * (vec3<f32>(_S380) * _S371 - vec3<f32>(_S377) * _S373);
    var _S384 : vec3<f32> = vec3<f32>(_S382) * (vec3<f32>(_S375) * _S373 - vec3<f32>(_S379) * _S371);
    var point_4 : VisiblePoint_0;
    var _S385 : f32 = 1.0f - _S363 - _S364;
    var _S386 : vec3<f32> = normal_of_0(&(_S366));
    var _S387 : vec3<f32> = vec3<f32>(_S385) * _S386;
    var _S388 : vec3<f32> = normal_of_0(&(_S367));
    var _S389 : vec3<f32> = vec3<f32>(_S363);
    var _S390 : vec3<f32> = _S387 + _S389 * _S388;
    var _S391 : vec3<f32> = normal_of_0(&(_S368));
    var _S392 : vec3<f32> = vec3<f32>(_S364);
    var _S393 : vec3<f32> = normalize(_S390 + _S392 * _S391);
    point_4.normal_0 = _S393;
    var _S394 : vec3<f32> = normalize(_S383 - _S393 * vec3<f32>(dot(_S393, _S383)));
    point_4.axis_x_0 = _S394;
    point_4.axis_y_0 = cross(_S393, _S394);
    var _S395 : vec3<f32> = normalize(cross(_S371, _S373));
    var _S396 : vec3<f32>;
    if((dot(_S395, _S393)) < 0.0f)
    {
        _S396 = (vec3<f32>(0) - _S395);
    }
    else
    {
        _S396 = _S395;
    }
    point_4.face_normal_0 = _S396;
    point_4.position_0 = _S370 + _S389 * _S371 + _S392 * _S373;
    point_4.view_1 = point_4.normal_0;
    point_4.uv_1 = vec2<f32>(_S374, _S376) + vec2<f32>(_S363) * _S378 + vec2<f32>(_S364) * _S381;
    var _S397 : bool = (dot(cross(_S383, _S384), point_4.normal_0)) < 0.0f;
    var _S398 : f32 = fabrics_0[_S361].uv_width_0;
    if(_S397)
    {
        _S382 = - fabrics_0[_S361].uv_height_0;
    }
    else
    {
        _S382 = fabrics_0[_S361].uv_height_0;
    }
    var _S399 : vec2<f32> = vec2<f32>(_S398, _S382);
    point_4.draft_per_uv_0 = _S399;
    var _S400 : vec2<f32> = point_4.uv_1 * _S399;
    if(_S397)
    {
        _S382 = fabrics_0[_S361].uv_height_0;
    }
    else
    {
        _S382 = 0.0f;
    }
    point_4.draft_0 = _S400 + vec2<f32>(0.0f, _S382);
    var _S401 : vec2<f32> = vec2<f32>(0.0f);
    point_4.draft_dx_0 = _S401;
    point_4.draft_dy_0 = _S401;
    return point_4;
}

fn visible_point_0( _S402 : i32,  _S403 : u32,  _S404 : u32,  _S405 : vec2<u32>) -> VisiblePoint_0
{
    var _S406 : u32 = u32(3) * _S404;
    var _S407 : Vertex_std430_0 = vertices_0[corners_0[_S406]];
    var _S408 : Vertex_std430_0 = vertices_0[corners_0[_S406 + u32(1)]];
    var _S409 : Vertex_std430_0 = vertices_0[corners_0[_S406 + u32(2)]];
    var _S410 : vec3<f32> = position_of_1(&(_S408));
    var _S411 : vec3<f32> = position_of_1(&(_S407));
    var _S412 : vec3<f32> = _S410 - _S411;
    var _S413 : vec3<f32> = position_of_1(&(_S409));
    var _S414 : vec3<f32> = _S413 - _S411;
    var _S415 : vec3<f32> = cross(_S412, _S414);
    var _S416 : f32 = 1.0f / max(square_0(_S415), 1.00000000317107685e-30f);
    var _S417 : f32 = f32(frames_0[_S402].width_0);
    var _S418 : vec3<f32> = camera_right_0(_S402) * vec3<f32>((2.0f / _S417));
    var _S419 : f32 = f32(frames_0[_S402].height_0);
    var _S420 : vec3<f32> = camera_up_0(_S402) * vec3<f32>((-2.0f / _S419));
    var _S421 : vec3<f32> = camera_forward_0(_S402) + vec3<f32>((f32(_S405.x) + 0.5f - 0.5f * _S417)) * _S418 + vec3<f32>((f32(_S405.y) + 0.5f - 0.5f * _S419)) * _S420;
    var _S422 : f32 = dot(_S421, _S415);
    var _S423 : f32;
    if((abs(_S422)) > 1.00000000317107685e-30f)
    {
        _S423 = _S422;
    }
    else
    {
        _S423 = 1.00000000317107685e-30f;
    }
    var _S424 : f32 = 1.0f / _S423;
    var _S425 : vec3<f32> = _S411 - camera_origin_0(_S402);
    var _S426 : vec3<f32> = vec3<f32>((dot(_S425, _S415) * _S424));
    var _S427 : vec3<f32> = _S421 * _S426 - _S425;
    var _S428 : vec3<f32> = _S426 * (_S418 - _S421 * vec3<f32>((dot(_S418, _S415) * _S424)));
    var _S429 : vec3<f32> = _S426 * (_S420 - _S421 * vec3<f32>((dot(_S420, _S415) * _S424)));
    var _S430 : vec3<f32> = vec3<f32>(_S416);
    var _S431 : vec3<f32> = cross(_S414, _S415) * _S430;
    var _S432 : vec3<f32> = cross(_S415, _S412) * _S430;
    var _S433 : vec2<f32> = vec2<f32>(_S408.u_0 - _S407.u_0, _S408.v_0 - _S407.v_0);
    var _S434 : vec2<f32> = vec2<f32>(_S409.u_0 - _S407.u_0, _S409.v_0 - _S407.v_0);
    var point_5 : VisiblePoint_0 = face_point_0(_S403, _S404, dot(_S427, _S431), dot(_S427, _S432));
    point_5.position_0 = _S411 + _S427;
    point_5.view_1 = (vec3<f32>(0) - normalize(_S421));
    point_5.draft_dx_0 = (vec2<f32>(dot(_S428, _S431)) * _S433 + vec2<f32>(dot(_S428, _S432)) * _S434) * point_5.draft_per_uv_0;
    point_5.draft_dy_0 = (vec2<f32>(dot(_S429, _S431)) * _S433 + vec2<f32>(dot(_S429, _S432)) * _S434) * point_5.draft_per_uv_0;
    return point_5;
}

fn filtered_albedo_0( _S435 : u32,  _S436 : VisiblePoint_0) -> vec3<f32>
{
    var _S437 : u32 = fabrics_0[_S435].albedo_map_levels_0;
    if((fabrics_0[_S435].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S438 : vec2<f32> = vec2<f32>(fabrics_0[_S435].uv_width_0, fabrics_0[_S435].uv_height_0);
    var _S439 : vec2<f32> = _S436.draft_dx_0 / _S438;
    var _S440 : vec2<f32> = _S436.draft_dy_0 / _S438;
    var _S441 : u32 = _S437 - u32(1);
    var _S442 : u32 = (u32(1) << (_S441));
    var _S443 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S439.x * _S440.y - _S439.y * _S440.x), 9.99999968265522539e-21f) * (square_1(f32(_S442)) / 3.0f)), 0.0f, f32(_S437) - 1.0f);
    var _S444 : u32 = min(u32(_S443), max(_S437, u32(2)) - u32(2));
    var _S445 : u32 = min(_S444 + u32(1), _S441);
    var _S446 : u32 = (u32(1) << ((u32(2) * _S437)));
    return mix(map_level_0(fabrics_0[_S435].albedo_map_0 + (_S446 - ((_S446 >> ((u32(2) * _S444))))) / u32(3), (_S442 >> (_S444)), _S436.uv_1), map_level_0(fabrics_0[_S435].albedo_map_0 + (_S446 - ((_S446 >> ((u32(2) * _S445))))) / u32(3), (_S442 >> (_S445)), _S436.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S443 - f32(_S444))) - 1.0f) / 3.0f)));
}

fn viewed_base_0( _S447 : u32,  _S448 : Footprint_0,  _S449 : vec3<f32>,  _S450 : f32,  _S451 : bool) -> ViewedBase_0
{
    var seen_2 : ViewedBase_0;
    var _S452 : bool = (_S449.z) < 0.0f;
    seen_2.back_5 = _S452;
    seen_2.view_3 = to_face_frame_0(_S449, _S452);
    var _S453 : u32;
    if(_S452)
    {
        _S453 = u32(1);
    }
    else
    {
        _S453 = u32(0);
    }
    seen_2.face_3 = _S453;
    var _S454 : BinTaps_0 = bin_taps_0(seen_2.view_3, u32(16));
    seen_2.around_0 = _S454;
    var _S455 : u32 = _S453 * u32(256);
    var _S456 : Clustered_std430_0 = fabrics_0[_S447].clustered_0;
    var _S457 : TexelBox_0 = texel_box_0(&(_S456), _S448, vec2<f32>(BinTaps_read_0(_S454, _S456.offset_1, _S455, u32(2), u32(0)), BinTaps_read_0(_S454, _S456.offset_1, _S455, u32(2), u32(1))), _S450 - 0.5f);
    seen_2.box_3 = _S457;
    seen_2.trust_1 = vec2<f32>(1.0f);
    if(!_S451)
    {
        seen_2.trust_1 = vec2<f32>(BinTaps_read_0(seen_2.around_0, _S456.trust_0, _S455, u32(2), u32(0)), BinTaps_read_0(seen_2.around_0, _S456.trust_0, _S455, u32(2), u32(1)));
    }
    return seen_2;
}

fn albedos_over_0( _S458 : u32,  _S459 : Footprint_0,  _S460 : bool) -> FamilyAlbedos_0
{
    var _S461 : vec2<f32> = _S459.dx_0;
    var _S462 : vec2<f32> = _S459.dy_0;
    var _S463 : vec2<f32> = sqrt(_S461 * _S461 + _S462 * _S462);
    var _S464 : Stretch_0 = stretch_of_0(fabrics_0[_S458].warp_0, _S459.centre_0.x, _S463.x);
    var _S465 : Stretch_0 = stretch_of_0(fabrics_0[_S458].weft_0, _S459.centre_0.y, _S463.y);
    var albedos_8 : FamilyAlbedos_0;
    albedos_8.warp_3 = mean_albedos_0(fabrics_0[_S458].warp_0, fabrics_0[_S458].weft_0, _S464, _S465, _S460);
    albedos_8.weft_3 = mean_albedos_0(fabrics_0[_S458].weft_0, fabrics_0[_S458].warp_0, _S465, _S464, _S460);
    return albedos_8;
}

fn openness_number_0( _S466 : u32,  _S467 : u32) -> f32
{
    return table_number_0(fabrics_0[_S466].openness_0 + _S467);
}

fn scattered_by_0( _S468 : u32,  _S469 : Albedos_0,  _S470 : u32,  _S471 : vec3<f32>) -> Scattered_0
{
    var _S472 : u32 = u32(159) + u32(2) * _S470;
    var yarn_3 : Scattered_0;
    yarn_3.back_4 = _S471 * _S469.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S468, _S472)) * _S469.specular_reflect_0;
    yarn_3.through_0 = _S471 * _S469.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S468, _S472 + u32(1))) * _S469.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S473 : u32,  _S474 : u32,  _S475 : vec3<f32>,  _S476 : vec3<f32>,  _S477 : vec3<f32>,  _S478 : vec3<f32>,  _S479 : ptr<function, vec3<f32>>,  _S480 : ptr<function, vec3<f32>>)
{
    var _S481 : u32 = u32(146) + u32(4) * _S474;
    var _S482 : f32 = openness_number_0(_S473, _S481 + u32(1));
    var _S483 : f32 = openness_number_0(_S473, _S481 + u32(2));
    var _S484 : vec3<f32> = vec3<f32>(1.0f);
    var _S485 : vec3<f32> = _S484 - _S477 * vec3<f32>(openness_number_0(_S473, _S481));
    var _S486 : vec3<f32> = _S484 - _S478 * vec3<f32>(openness_number_0(_S473, _S481 + u32(3)));
    var _S487 : vec3<f32> = _S484 / (_S485 * _S486 - _S477 * _S478 * vec3<f32>((_S482 * _S483)));
    (*_S479) = (_S475 * _S486 + _S477 * vec3<f32>(_S482) * _S476) * _S487;
    (*_S480) = (_S476 * _S485 + _S478 * vec3<f32>(_S483) * _S475) * _S487;
    return;
}

fn face_sends_0( _S488 : u32,  _S489 : u32,  _S490 : Scattered_0,  _S491 : Scattered_0) -> FaceSends_0
{
    var _S492 : u32 = u32(2) * _S489;
    var _S493 : u32 = u32(142) + _S492;
    var _S494 : f32 = openness_number_0(_S488, _S493);
    var _S495 : f32 = openness_number_0(_S488, _S493 + u32(1));
    var _S496 : vec3<f32> = vec3<f32>((1.0f - _S494)) * _S490.back_4;
    var _S497 : vec3<f32> = vec3<f32>((1.0f - _S495)) * _S491.back_4;
    var sends_1 : FaceSends_0;
    var _S498 : u32 = u32(154) + _S492;
    var _S499 : f32 = openness_number_0(_S488, _S498);
    sends_1.blocks_warp_0 = _S499;
    var _S500 : f32 = openness_number_0(_S488, _S498 + u32(1));
    sends_1.blocks_weft_0 = _S500;
    sends_1.open_0 = _S499 * _S494 + _S500 * _S495;
    var _S501 : vec3<f32> = vec3<f32>(_S494) * _S490.back_4;
    var _S502 : vec3<f32> = vec3<f32>(_S495) * _S491.back_4;
    var _S503 : vec3<f32> = sends_1.sky_warp_0;
    var _S504 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S488, _S489, _S501, _S502, _S496, _S497, &(_S503), &(_S504));
    sends_1.sky_warp_0 = _S503;
    sends_1.sky_weft_0 = _S504;
    var _S505 : vec3<f32> = sends_1.crossing_warp_0;
    var _S506 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S488, _S489, _S490.through_0, _S491.through_0, _S496, _S497, &(_S505), &(_S506));
    sends_1.crossing_warp_0 = _S505;
    sends_1.crossing_weft_0 = _S506;
    return sends_1;
}

fn interior_of_0( _S507 : u32,  _S508 : vec3<f32>,  _S509 : bool) -> Interior_0
{
    var _S510 : Scattered_0 = scattered_by_0(_S507, table_albedos_0(families_0[fabrics_0[_S507].warp_0].colour_mean_0), u32(0), _S508);
    var _S511 : Scattered_0 = scattered_by_0(_S507, table_albedos_0(families_0[fabrics_0[_S507].weft_0].colour_mean_0), u32(1), _S508);
    var _S512 : u32;
    if(_S509)
    {
        _S512 = u32(1);
    }
    else
    {
        _S512 = u32(0);
    }
    var _S513 : FaceSends_0 = face_sends_0(_S507, _S512, _S510, _S511);
    if(_S509)
    {
        _S512 = u32(0);
    }
    else
    {
        _S512 = u32(1);
    }
    var _S514 : FaceSends_0 = face_sends_0(_S507, _S512, _S510, _S511);
    var _S515 : vec3<f32> = vec3<f32>(_S513.blocks_warp_0);
    var _S516 : vec3<f32> = vec3<f32>(_S513.blocks_weft_0);
    var _S517 : vec3<f32> = _S515 * _S513.crossing_warp_0 + _S516 * _S513.crossing_weft_0;
    var _S518 : vec3<f32> = vec3<f32>(_S514.blocks_warp_0);
    var _S519 : vec3<f32> = vec3<f32>(_S514.blocks_weft_0);
    var _S520 : vec3<f32> = _S518 * _S514.crossing_warp_0 + _S519 * _S514.crossing_weft_0;
    var _S521 : f32 = 1.0f - _S513.open_0;
    var _S522 : f32 = 1.0f - _S514.open_0;
    var _S523 : vec3<f32> = vec3<f32>(1.0f);
    var _S524 : vec3<f32> = _S523 / (_S523 - _S517 * _S520 * vec3<f32>((_S521 * _S522)));
    var _S525 : vec3<f32> = _S520 * (vec3<f32>(_S513.open_0) + vec3<f32>(_S521) * (_S515 * _S513.sky_warp_0 + _S516 * _S513.sky_weft_0)) * _S524;
    var _S526 : vec3<f32> = _S517 * (vec3<f32>(_S514.open_0) + vec3<f32>(_S522) * (_S518 * _S514.sky_warp_0 + _S519 * _S514.sky_weft_0)) * _S524;
    var _S527 : FaceRadiance_0 = face_radiance_0(_S513, _S514.open_0, _S525, _S526);
    var _S528 : FaceRadiance_0 = face_radiance_0(_S514, _S513.open_0, _S526, _S525);
    var interior_1 : Interior_0;
    interior_1.warp_2 = _S527.warp_1;
    interior_1.weft_2 = _S527.weft_1;
    interior_1.leaked_1 = _S527.leaked_0;
    interior_1.far_1 = _S528.mean_0;
    interior_1.far_leaked_0 = _S528.leaked_0;
    return interior_1;
}

fn blocked_of_terms_0( _S529 : u32,  _S530 : u32,  _S531 : array<f32, i32(6)>,  _S532 : u32) -> Blocked_0
{
    var shares_0 : array<f32, i32(3)>;
    var share_5 : u32 = u32(0);
    for(;;)
    {
        if(share_5 < u32(3))
        {
        }
        else
        {
            break;
        }
        shares_0[share_5] = 0.0f;
        var term_0 : u32 = u32(0);
        for(;;)
        {
            if(term_0 < _S532)
            {
            }
            else
            {
                break;
            }
            shares_0[share_5] = shares_0[share_5] + openness_number_0(_S529, _S530 + share_5 * _S532 + term_0) * _S531[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_5] = saturate(shares_0[share_5]);
        share_5 = share_5 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_from_0( _S533 : u32,  _S534 : vec3<f32>,  _S535 : bool,  _S536 : bool) -> Blocked_0
{
    var terms_1 : array<f32, i32(6)>;
    view_terms_0(_S534, &(terms_1));
    var _S537 : u32;
    if(_S536)
    {
        _S537 = u32(2);
    }
    else
    {
        _S537 = u32(0);
    }
    var _S538 : u32;
    if(_S535)
    {
        _S538 = u32(0);
    }
    else
    {
        _S538 = u32(1);
    }
    return blocked_of_terms_0(_S533, (_S537 + _S538) * u32(15), terms_1, u32(5));
}

fn family_share_0( _S539 : u32,  _S540 : u32,  _S541 : f32) -> vec2<f32>
{
    var _S542 : bool = _S540 < (fabrics_0[_S539].clustered_0.clusters_0 / u32(2));
    return vec2<f32>(select(0.0f, _S541, _S542), select(_S541, 0.0f, _S542));
}

fn clustered_shown_0( _S543 : u32,  _S544 : ViewedBase_0) -> vec2<f32>
{
    var _S545 : Clustered_std430_0 = fabrics_0[_S543].clustered_0;
    var _S546 : u32 = _S545.clusters_0;
    var _S547 : u32 = _S544.face_3 * u32(256);
    var _S548 : vec2<f32> = vec2<f32>(0.0f);
    var cluster_0 : u32 = u32(0);
    var shown_4 : vec2<f32> = _S548;
    for(;;)
    {
        if(cluster_0 < _S546)
        {
        }
        else
        {
            break;
        }
        var _S549 : f32 = box_mean_0(&(_S545), _S544.box_3, _S544.face_3, cluster_0);
        if(_S549 > 0.0f)
        {
            shown_4 = shown_4 + family_share_0(_S543, cluster_0, _S544.trust_1.x * _S549 * BinTaps_read_0(_S544.around_0, _S545.view_0, _S547, _S546, cluster_0));
        }
        cluster_0 = cluster_0 + u32(1);
    }
    return shown_4;
}

fn clustered_view_0( _S550 : u32,  _S551 : Footprint_0,  _S552 : vec3<f32>,  _S553 : vec3<f32>,  _S554 : u32,  _S555 : bool) -> ClusteredView_0
{
    var seen_3 : ClusteredView_0;
    seen_3.base_0 = viewed_base_0(_S550, _S551, _S552, uniform_of_0(_S554, u32(0)), _S555);
    seen_3.view_4 = _S552;
    seen_3.is_alone_0 = _S555;
    var _S556 : FamilyAlbedos_0 = albedos_over_0(_S550, _S551, seen_3.base_0.back_5);
    seen_3.albedos_4.warp_3 = tinted_0(_S556.warp_3, _S553);
    seen_3.albedos_4.weft_3 = tinted_0(_S556.weft_3, _S553);
    var _S557 : vec3<f32> = vec3<f32>(0.0f);
    seen_3.bounced_warp_0.reflected_0 = _S557;
    seen_3.bounced_warp_0.transmitted_0 = _S557;
    seen_3.bounced_weft_0 = seen_3.bounced_warp_0;
    seen_3.bounced_1 = seen_3.bounced_warp_0;
    if((fabrics_0[_S550].openness_0) == u32(4294967295))
    {
        return seen_3;
    }
    var _S558 : Interior_0 = interior_of_0(_S550, _S553, seen_3.base_0.back_5);
    seen_3.bounced_warp_0 = bounced_by_0(blocked_from_0(_S550, seen_3.base_0.view_3, true, seen_3.base_0.back_5), scattered_by_0(_S550, _S556.warp_3, u32(0), _S553), _S558);
    seen_3.bounced_weft_0 = bounced_by_0(blocked_from_0(_S550, seen_3.base_0.view_3, false, seen_3.base_0.back_5), scattered_by_0(_S550, _S556.weft_3, u32(1), _S553), _S558);
    seen_3.bounced_1 = bounced_by_base_0(seen_3, clustered_shown_0(_S550, seen_3.base_0));
    return seen_3;
}

fn clustered_hole_0( _S559 : u32,  _S560 : ViewedBase_0) -> f32
{
    var cluster_1 : u32 = u32(0);
    var covered_0 : f32 = 0.0f;
    for(;;)
    {
        var _S561 : Clustered_std430_0 = fabrics_0[_S559].clustered_0;
        if(cluster_1 < (_S561.clusters_0))
        {
        }
        else
        {
            break;
        }
        var _S562 : f32 = box_mean_1(&(_S561), _S560.box_3, _S560.face_3, cluster_1);
        var covered_1 : f32 = covered_0 + _S562;
        cluster_1 = cluster_1 + u32(1);
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
     shown_5 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_8 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S563 : u32,  _S564 : f32,  _S565 : f32,  _S566 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_4 = locate_0(fabrics_0[_S563].warp_0, _S564);
    crossing_3.weft_4 = locate_0(fabrics_0[_S563].weft_0, _S565);
    var _S567 : u32 = fabrics_0[_S563].run_words_0 + u32(2) * (crossing_3.weft_4.thread_0 * fabrics_0[_S563].ends_1 + crossing_3.warp_4.thread_0);
    var _S568 : u32 = words_0[_S567];
    crossing_3.warp_word_0 = _S568;
    crossing_3.weft_word_0 = words_0[_S567 + u32(1)];
    crossing_3.warp_above_0 = (((_S568 & (u32(1)))) == u32(1)) != _S566;
    return crossing_3;
}

fn sample_at_0( _S569 : u32,  _S570 : f32,  _S571 : f32,  _S572 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S573 : Crossing_0 = crossing_at_0(_S569, _S570, _S571, _S572);
    sample_0.crossing_2 = _S573;
    var _S574 : Shown_0 = shown_at_0(_S573, _S572);
    sample_0.shown_5 = _S574;
    var _S575 : u32;
    if(_S574.is_warp_2)
    {
        _S575 = fabrics_0[_S569].warp_0;
    }
    else
    {
        _S575 = fabrics_0[_S569].weft_0;
    }
    var _S576 : u32;
    if(_S574.is_warp_2)
    {
        _S576 = fabrics_0[_S569].weft_0;
    }
    else
    {
        _S576 = fabrics_0[_S569].warp_0;
    }
    var _S577 : Cell_0 = select_cell_0(_S574.is_warp_2, sample_0.crossing_2.warp_4, sample_0.crossing_2.weft_4);
    var _S578 : Cell_0 = select_cell_0(_S574.is_warp_2, sample_0.crossing_2.weft_4, sample_0.crossing_2.warp_4);
    var _S579 : Run_0 = unpack_0(_S575, _S576, _S577.thread_0, _S578, _S574.word_0);
    var _S580 : Section_0 = section_at_0(_S577);
    var _S581 : bool;
    if(_S574.on_top_0)
    {
        _S581 = (_S579.distance_0) < (_S580.drop_0 * _S579.bend_1.sine_0);
    }
    else
    {
        _S581 = false;
    }
    var _S582 : bool;
    if(_S574.on_top_0)
    {
        _S582 = !_S581;
    }
    else
    {
        _S582 = false;
    }
    var _S583 : f32;
    if(_S582)
    {
        _S583 = 1.0f;
    }
    else
    {
        _S583 = -1.0f;
    }
    var _S584 : f32;
    if(_S581)
    {
        _S584 = _S579.other_reach_0;
    }
    else
    {
        _S584 = _S579.reach_0;
    }
    var _S585 : f32;
    if(_S581)
    {
        _S585 = _S584 + _S579.distance_0;
    }
    else
    {
        _S585 = max(_S584 - _S579.distance_0, 0.0f);
    }
    var _S586 : f32 = _S584 / _S579.bend_1.sine_0 - _S583 * _S580.drop_0;
    var _S587 : f32 = _S585 * _S585;
    var _S588 : f32 = max(_S586 * _S586 - _S587, 9.99999968265522539e-21f);
    var _S589 : f32 = rsqrt_0(_S588);
    var _S590 : f32 = _S587 / (_S588 * _S589 + _S586);
    var _S591 : bool = _S585 > 0.0f;
    var _S592 : f32;
    if(_S574.on_top_0)
    {
        _S592 = 1.0f;
    }
    else
    {
        _S592 = -1.0f;
    }
    var _S593 : f32;
    if(_S579.near_start_0)
    {
        _S593 = 1.0f;
    }
    else
    {
        _S593 = -1.0f;
    }
    var _S594 : f32 = _S592 * _S593;
    if(_S591)
    {
        _S592 = _S586 * _S589;
    }
    else
    {
        _S592 = 1.0f;
    }
    sample_0.slope_across_0 = _S580.slope_0 * _S592;
    if(_S591)
    {
        _S585 = _S594 * _S585 * _S589;
    }
    else
    {
        _S585 = 0.0f;
    }
    sample_0.slope_along_0 = _S585;
    var _S595 : f32 = families_0[_S575].height_scale_0;
    var _S596 : vec2<f32> = dive_0(_S576, _S574, _S579, _S578);
    if(_S579.straight_0)
    {
        _S583 = 0.0f;
    }
    else
    {
        _S583 = _S595 * _S583;
    }
    sample_0.height_8 = _S583 * (_S584 * _S579.bend_1.half_tangent_0 - _S590) - _S595 * _S580.drop_0 - _S596.x;
    var _S597 : f32 = _S595 * sample_0.slope_across_0;
    var _S598 : f32 = _S595 * sample_0.slope_along_0 - _S596.y;
    if(_S574.is_warp_2)
    {
        _S583 = _S597;
    }
    else
    {
        _S583 = _S598;
    }
    sample_0.slope_x_1 = _S583;
    if(_S574.is_warp_2)
    {
        _S583 = _S598;
    }
    else
    {
        _S583 = _S597;
    }
    sample_0.slope_y_1 = _S583;
    sample_0.run_3 = _S579;
    sample_0.section_1 = _S580;
    return sample_0;
}

fn steps_per_length_0( _S599 : u32,  _S600 : SearchQuality_0,  _S601 : vec3<f32>) -> f32
{
    return max(max(abs(_S601.x) * fabrics_0[_S599].threads_per_x_0, abs(_S601.y) * fabrics_0[_S599].threads_per_y_0) * _S600.steps_per_thread_0, abs(_S601.z) * fabrics_0[_S599].per_relief_0 * _S600.steps_per_relief_0);
}

fn cell_maximum_0( _S602 : u32,  _S603 : Crossing_0) -> f32
{
    var _S604 : u32;
    if(_S603.warp_above_0)
    {
        _S604 = fabrics_0[_S602].warp_0;
    }
    else
    {
        _S604 = fabrics_0[_S602].weft_0;
    }
    var _S605 : u32;
    if(_S603.warp_above_0)
    {
        _S605 = _S603.warp_word_0;
    }
    else
    {
        _S605 = _S603.weft_word_0;
    }
    return f32((_S605 >> (u32(28)))) * families_0[_S604].height_scale_0 * families_0[_S604].level_0;
}

fn probe_0( _S606 : u32,  _S607 : f32,  _S608 : f32,  _S609 : bool,  _S610 : bool,  _S611 : bool) -> Probe_0
{
    var _S612 : Sample_0 = sample_at_0(_S606, _S607, _S608, _S609);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S612.height_8;
    probe_1.hole_3 = _S612.shown_5.hole_2;
    probe_1.slope_x_0 = _S612.slope_x_1;
    probe_1.slope_y_0 = _S612.slope_y_1;
    var _S613 : u32;
    if(_S612.shown_5.is_warp_2)
    {
        _S613 = _S612.crossing_2.warp_4.thread_0 * u32(2) + u32(1);
    }
    else
    {
        _S613 = _S612.crossing_2.weft_4.thread_0 * u32(2);
    }
    probe_1.yarn_2 = _S613;
    probe_1.cell_max_0 = cell_maximum_0(_S606, _S612.crossing_2);
    var _S614 : f32;
    if(_S610)
    {
        _S614 = _S612.crossing_2.warp_4.above_0;
    }
    else
    {
        _S614 = _S612.crossing_2.warp_4.below_0;
    }
    probe_1.side_x_0 = _S614;
    if(_S611)
    {
        _S614 = _S612.crossing_2.weft_4.above_0;
    }
    else
    {
        _S614 = _S612.crossing_2.weft_4.below_0;
    }
    probe_1.side_y_0 = _S614;
    probe_1.edge_x_0 = outline_distance_0(_S612.crossing_2.warp_4, _S612.shown_5, _S612.run_3, !_S612.shown_5.is_warp_2, _S610);
    probe_1.edge_y_0 = outline_distance_0(_S612.crossing_2.weft_4, _S612.shown_5, _S612.run_3, _S612.shown_5.is_warp_2, _S611);
    return probe_1;
}

fn is_free_0( _S615 : u32,  _S616 : SearchQuality_0,  _S617 : vec3<f32>,  _S618 : vec3<f32>,  _S619 : bool,  _S620 : f32) -> bool
{
    var _S621 : f32 = _S618.z;
    if(_S621 <= 0.0f)
    {
        return false;
    }
    var _S622 : f32 = 1.0f / max(_S616.shadow_share_0 * steps_per_length_0(_S615, _S616, _S618), 9.99999971718068537e-10f);
    var _S623 : StepControl_0 = step_control_0(_S618.xy, _S622);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S624 : bool;
        if(count_4 < u32(1024))
        {
            _S624 = (_S617.z + _S621 * distance_1) < _S620;
        }
        else
        {
            _S624 = false;
        }
        if(_S624)
        {
        }
        else
        {
            break;
        }
        var _S625 : vec3<f32> = _S617 + _S618 * vec3<f32>(distance_1);
        var _S626 : Probe_0 = probe_0(_S615, _S625.x, _S625.y, _S619, _S623.right_0, _S623.up_0);
        var _S627 : f32 = _S625.z;
        var _S628 : f32 = _S627 - _S626.height_4;
        var _S629 : f32 = _S621 - _S626.slope_x_0 * _S618.x - _S626.slope_y_0 * _S618.y;
        var _S630 : bool;
        if(!_S626.hole_3)
        {
            _S630 = _S628 < 0.0f;
        }
        else
        {
            _S630 = false;
        }
        if(_S630)
        {
            return false;
        }
        var _S631 : f32 = way_back_to_dip_0(previous_3, _S628, _S629, last_step_0, _S626);
        if(_S631 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S631;
            distance_1 = distance_1 - _S631;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S632 : bool = _S627 > (_S626.cell_max_0);
        var _S633 : PreviousSample_0 = after_sample_0(_S628, _S629, _S626, _S632);
        var last_step_2 : f32;
        if(_S632)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S623, _S626.side_x_0, _S626.side_y_0), _S622);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S623, _S626, _S628, _S629);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S633;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S634 : u32,  _S635 : SearchQuality_0,  _S636 : f32,  _S637 : f32,  _S638 : vec3<f32>,  _S639 : bool) -> bool
{
    if(!sample_at_0(_S634, _S636, _S637, _S639).shown_5.hole_2)
    {
        return false;
    }
    var _S640 : vec3<f32> = vec3<f32>(_S636, _S637, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S641 : bool;
        if(side_1 < u32(2))
        {
            _S641 = passes_0;
        }
        else
        {
            _S641 = false;
        }
        if(_S641)
        {
        }
        else
        {
            break;
        }
        var _S642 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S642 = _S638;
        }
        else
        {
            _S642 = vec3<f32>(- _S638.x, - _S638.y, _S638.z);
        }
        var _S643 : bool = is_free_0(_S634, _S635, _S640, _S642, _S639 != (side_1 == u32(1)), fabrics_0[_S634].height_high_0);
        var _S644 : u32 = side_1 + u32(1);
        passes_0 = _S643;
        side_1 = _S644;
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

fn max_height_along_0( _S645 : u32,  _S646 : f32,  _S647 : f32,  _S648 : f32,  _S649 : vec3<f32>,  _S650 : bool) -> f32
{
    var _S651 : u32 = locate_0(fabrics_0[_S645].warp_0, _S646).thread_0 / u32(2);
    var _S652 : u32 = locate_0(fabrics_0[_S645].weft_0, _S647).thread_0 / u32(2);
    var _S653 : f32 = _S649.x;
    var _S654 : u32;
    if(_S653 > 0.0f)
    {
        _S654 = u32(1);
    }
    else
    {
        _S654 = u32(0);
    }
    var _S655 : f32 = _S649.y;
    var _S656 : u32;
    if(_S655 > 0.0f)
    {
        _S656 = u32(2);
    }
    else
    {
        _S656 = u32(0);
    }
    var _S657 : u32 = words_0[fabrics_0[_S645].max_heights_0 + u32(4) * (_S652 * fabrics_0[_S645].max_height_columns_0 + _S651) + (_S654 + _S656)];
    var number_2 : i32;
    if(_S650)
    {
        number_2 = i32(4);
    }
    else
    {
        number_2 = i32(0);
    }
    var _S658 : u32 = (_S657 >> (u32(number_2)));
    var _S659 : f32 = max(abs(_S653) * fabrics_0[_S645].threads_per_x_0, abs(_S655) * fabrics_0[_S645].threads_per_y_0) / _S649.z;
    var _S660 : f32 = fabrics_0[_S645].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S645].height_high_0;
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
        if(((max_height_0 - _S648) * _S659) <= (PYRAMID_RADII_0[number_2]))
        {
            max_height_0 = min(max_height_0, f32((((_S658 >> (u32(i32(8) * number_2)))) & (u32(15)))) * 0.06666667014360428f * _S660);
        }
        number_2 = number_2 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S661 : u32,  _S662 : f32,  _S663 : f32,  _S664 : bool,  _S665 : bool,  _S666 : bool) -> vec3<f32>
{
    var _S667 : Crossing_0 = crossing_at_0(_S661, _S662, _S663, _S664);
    var _S668 : f32 = cell_maximum_0(_S661, _S667);
    var _S669 : f32;
    if(_S665)
    {
        _S669 = _S667.warp_4.above_0;
    }
    else
    {
        _S669 = _S667.warp_4.below_0;
    }
    var _S670 : f32;
    if(_S666)
    {
        _S670 = _S667.weft_4.above_0;
    }
    else
    {
        _S670 = _S667.weft_4.below_0;
    }
    return vec3<f32>(_S668, _S669, _S670);
}

fn first_sample_height_0( _S671 : u32,  _S672 : ViewRay_0,  _S673 : StepControl_0,  _S674 : bool) -> f32
{
    var _S675 : f32 = max_height_along_0(_S671, _S672.origin_0.x, _S672.origin_0.y, 0.0f, vec3<f32>(_S672.slope_1, 1.0f), _S674);
    var count_5 : u32 = u32(0);
    var height_10 : f32 = _S675;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S676 : vec2<f32> = ViewRay_at_0(_S672, height_10);
        var _S677 : vec3<f32> = cell_bounds_0(_S671, _S676.x, _S676.y, _S674, _S673.right_0, _S673.up_0);
        var _S678 : f32 = height_10 - _S677.x;
        var _S679 : f32 = StepControl_to_cell_exit_0(_S673, _S677.y, _S677.z);
        var height_11 : f32 = height_10 - clamp(_S678, 0.0f, _S679);
        if(_S678 <= _S679)
        {
            height_10 = height_11;
            break;
        }
        count_5 = count_5 + u32(1);
        height_10 = height_11;
    }
    return height_10;
}

fn search_down_0( _S680 : u32,  _S681 : ViewRay_0,  _S682 : StepControl_0,  _S683 : bool) -> ViewRayEnd_0
{
    var _S684 : f32 = fabrics_0[_S680].height_low_0 - (fabrics_0[_S680].height_high_0 - fabrics_0[_S680].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_9 = first_sample_height_0(_S680, _S681, _S682, _S683);
    end_1.last_step_3 = _S682.epsilon_0;
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
        var _S685 : vec2<f32> = ViewRay_at_0(_S681, end_1.height_9);
        var _S686 : Probe_0 = probe_0(_S680, _S685.x, _S685.y, _S683, _S682.right_0, _S682.up_0);
        var _S687 : f32 = end_1.height_9 - _S686.height_4;
        var _S688 : f32 = ViewRay_rate_0(_S681, _S686);
        end_1.depth_1 = - _S687;
        end_1.rate_4 = _S688;
        var _S689 : bool;
        if(end_1.previous_4.known_0)
        {
            _S689 = !_S686.hole_3;
        }
        else
        {
            _S689 = false;
        }
        var _S690 : bool;
        if(_S689)
        {
            _S690 = (end_1.previous_4.yarn_1) == (_S686.yarn_2);
        }
        else
        {
            _S690 = false;
        }
        end_1.smooth_0 = _S690;
        var _S691 : bool;
        if(!_S686.hole_3)
        {
            _S691 = _S687 <= 0.0f;
        }
        else
        {
            _S691 = false;
        }
        var _S692 : bool;
        if(_S691)
        {
            _S692 = true;
        }
        else
        {
            _S692 = (end_1.height_9) <= _S684;
        }
        if(_S692)
        {
            break;
        }
        var _S693 : f32 = way_back_to_dip_0(end_1.previous_4, _S687, _S688, end_1.last_step_3, _S686);
        if(_S693 >= 0.0f)
        {
            end_1.height_9 = end_1.height_9 + _S693;
            end_1.last_step_3 = end_1.last_step_3 - _S693;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S694 : f32 = min(StepControl_to_cell_exit_0(_S682, _S686.side_x_0, _S686.side_y_0), end_1.height_9 - _S686.cell_max_0);
        var _S695 : f32 = StepControl_to_next_sample_0(_S682, _S686, _S687, _S688);
        end_1.previous_4 = after_sample_0(_S687, _S688, _S686, _S694 > _S695);
        var _S696 : f32 = max(_S694, _S695);
        end_1.last_step_3 = _S696;
        end_1.height_9 = end_1.height_9 - _S696;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S697 : u32,  _S698 : ViewRay_0,  _S699 : StepControl_0,  _S700 : bool,  _S701 : ViewRayEnd_0,  _S702 : u32) -> f32
{
    var _S703 : f32 = fabrics_0[_S697].height_high_0 - fabrics_0[_S697].height_low_0;
    var above_2 : f32 = _S701.height_9 + _S701.last_step_3;
    var above_gap_1 : f32 = clamp(_S701.previous_4.clearance_0, 0.0f, _S703);
    var under_gap_1 : f32 = clamp(_S701.depth_1, 0.0f, _S703);
    var _S704 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S701.previous_4.rate_0 * _S701.last_step_3, _S701.rate_4 * _S701.last_step_3);
    var middle_0 : f32;
    if(_S701.smooth_0)
    {
        middle_0 = above_2 - _S704 * _S701.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S701.height_9, above_gap_1, under_gap_1);
    }
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S701.height_9;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S702)
        {
        }
        else
        {
            break;
        }
        var _S705 : vec2<f32> = ViewRay_at_0(_S698, middle_0);
        var _S706 : Probe_0 = probe_0(_S697, _S705.x, _S705.y, _S700, _S699.right_0, _S699.up_0);
        var _S707 : f32;
        if(_S706.hole_3)
        {
            _S707 = -1.0e+09f;
        }
        else
        {
            _S707 = _S706.height_4;
        }
        var _S708 : f32 = clamp(middle_0 - _S707, - _S703, _S703);
        var _S709 : f32;
        if(_S708 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S709 = 0.5f * above_gap_2;
            }
            else
            {
                _S709 = above_gap_2;
            }
            var _S710 : f32 = - _S708;
            under_1 = middle_0;
            above_gap_2 = _S709;
            under_gap_2 = _S710;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S709 = 0.5f * under_gap_2;
            }
            else
            {
                _S709 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S708;
            under_gap_2 = _S709;
            side_2 = -1.0f;
        }
        if(_S701.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S708 / min(ViewRay_rate_0(_S698, _S706), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S701.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S711 : u32,  _S712 : SearchQuality_0,  _S713 : f32,  _S714 : f32,  _S715 : vec3<f32>,  _S716 : bool) -> Hit_0
{
    var _S717 : f32 = max(_S715.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S713, _S714);
    var _S718 : vec2<f32> = _S715.xy / vec2<f32>(_S717);
    ray_0.slope_1 = _S718;
    var _S719 : StepControl_0 = step_control_0((vec2<f32>(0) - _S718), 1.0f / max(steps_per_length_0(_S711, _S712, _S715) / _S717, 9.99999971718068537e-10f));
    var _S720 : ViewRayEnd_0 = search_down_0(_S711, ray_0, _S719, _S716);
    var hit_0 : Hit_0;
    hit_0.hole_6 = false;
    var _S721 : f32 = refined_height_0(_S711, ray_0, _S719, _S716, _S720, _S712.refinements_0);
    hit_0.height_7 = _S721;
    var _S722 : vec2<f32> = ViewRay_at_0(ray_0, _S721);
    hit_0.x_15 = _S722.x;
    hit_0.y_8 = _S722.y;
    return hit_0;
}

fn first_hit_0( _S723 : u32,  _S724 : SearchQuality_0,  _S725 : f32,  _S726 : f32,  _S727 : vec3<f32>,  _S728 : bool) -> Hit_0
{
    if(!passes_through_0(_S723, _S724, _S725, _S726, _S727, _S728))
    {
        return first_hit_of_yarn_0(_S723, _S724, _S725, _S726, _S727, _S728);
    }
    var hit_1 : Hit_0;
    hit_1.x_15 = _S725;
    hit_1.y_8 = _S726;
    hit_1.height_7 = 0.0f;
    hit_1.hole_6 = true;
    return hit_1;
}

fn surface_at_0( _S729 : u32,  _S730 : f32,  _S731 : f32,  _S732 : bool) -> SurfacePoint_0
{
    var _S733 : Sample_0 = sample_at_0(_S729, _S730, _S731, _S732);
    var _S734 : f32;
    if(_S733.shown_5.is_warp_2)
    {
        _S734 = _S733.crossing_2.warp_4.half_width_1;
    }
    else
    {
        _S734 = _S733.crossing_2.weft_4.half_width_1;
    }
    var _S735 : u32;
    if(_S733.shown_5.is_warp_2)
    {
        _S735 = fabrics_0[_S729].warp_0;
    }
    else
    {
        _S735 = fabrics_0[_S729].weft_0;
    }
    var _S736 : f32 = families_0[_S735].twist_sine_0;
    var _S737 : f32;
    if(_S732)
    {
        _S737 = -1.0f;
    }
    else
    {
        _S737 = 1.0f;
    }
    var _S738 : f32 = _S736 * _S737;
    var _S739 : f32 = families_0[_S735].twist_cosine_0;
    if(_S733.shown_5.is_warp_2)
    {
        _S737 = 1.0f;
    }
    else
    {
        _S737 = -1.0f;
    }
    var _S740 : vec2<f32> = fibre_direction_0(_S733.slope_across_0, _S737 * _S733.slope_along_0, _S738, _S739);
    var _S741 : f32;
    if(_S733.shown_5.is_warp_2)
    {
        _S741 = _S733.slope_x_1;
    }
    else
    {
        _S741 = _S733.slope_y_1;
    }
    var _S742 : f32;
    if(_S733.shown_5.is_warp_2)
    {
        _S742 = _S733.slope_y_1;
    }
    else
    {
        _S742 = _S733.slope_x_1;
    }
    var _S743 : f32 = _S740.x;
    var _S744 : f32 = _S740.y;
    var _S745 : f32 = _S741 * _S743 + _S737 * _S742 * _S744;
    var _S746 : f32 = _S734 * 1.0154266357421875f;
    var _S747 : f32 = _S746 * arc_sine_0(clamp(_S733.section_1.across_3 / _S746, -1.0f, 1.0f));
    if(_S733.shown_5.is_warp_2)
    {
        _S734 = _S731;
    }
    else
    {
        _S734 = - _S730;
    }
    var point_6 : SurfacePoint_0;
    point_6.hole_4 = _S733.shown_5.hole_2;
    point_6.is_warp_3 = _S733.shown_5.is_warp_2;
    point_6.warp_thread_0 = _S733.crossing_2.warp_4.thread_0;
    point_6.weft_thread_0 = _S733.crossing_2.weft_4.thread_0;
    point_6.height_6 = _S733.height_8;
    point_6.normal_5 = normalize(vec3<f32>(- _S733.slope_x_1, - _S733.slope_y_1, 1.0f));
    var _S748 : vec3<f32>;
    if(_S733.shown_5.is_warp_2)
    {
        _S748 = vec3<f32>(_S743, _S744, _S745);
    }
    else
    {
        _S748 = vec3<f32>(- _S744, _S743, _S745);
    }
    point_6.tangent_4 = normalize(_S748);
    point_6.across_5 = _S733.section_1.across_3;
    point_6.fibre_across_0 = _S747 * _S739 + _S734 * _S738;
    point_6.fibre_along_0 = _S734 * _S739 - _S747 * _S738;
    return point_6;
}

fn has_hairs_0( _S749 : u32) -> bool
{
    var _S750 : bool;
    if((families_0[fabrics_0[_S749].warp_0].hairiness_0) > 0.0f)
    {
        _S750 = true;
    }
    else
    {
        _S750 = (families_0[fabrics_0[_S749].weft_0].hairiness_0) > 0.0f;
    }
    return _S750;
}

fn hair_at_0( _S751 : u32,  _S752 : vec2<f32>,  _S753 : bool,  _S754 : f32) -> Hair_0
{
    var _S755 : f32 = fabrics_0[_S751].fibre_size_0;
    var _S756 : f32 = 17.0f * fabrics_0[_S751].fibre_size_0;
    var _S757 : f32 = fade_0(_S754, _S756);
    var _S758 : vec2<f32> = _S752 / vec2<f32>(_S756);
    var number_3 : u32;
    if(_S753)
    {
        number_3 = u32(1);
    }
    else
    {
        number_3 = u32(0);
    }
    var _S759 : u32 = hash_key_0(number_3, ((fabrics_0[_S751].seed_0) ^ (u32(1013904242))));
    var _S760 : f32 = 1.0f / max(_S754, 0.07999999821186066f * _S755);
    var _S761 : f32 = min(0.63999998569488525f * _S755 * _S760, 1.0f);
    const _S762 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S762;
    number_3 = u32(0);
    for(;;)
    {
        var _S763 : bool;
        if(_S757 > 0.0f)
        {
            _S763 = number_3 < u32(18);
        }
        else
        {
            _S763 = false;
        }
        if(_S763)
        {
        }
        else
        {
            break;
        }
        var _S764 : u32 = number_3 / u32(9);
        var _S765 : u32 = number_3 / u32(3) - u32(3) * _S764;
        var _S766 : vec2<f32> = floor(_S758) + vec2<f32>(f32(number_3 - u32(3) * _S765 - u32(9) * _S764), f32(_S765)) - vec2<f32>(1.0f);
        var _S767 : u32 = hash_bits_0(_S759 + _S764, u32(i32(_S766.x)) * u32(65536) + u32(i32(_S766.y)));
        var _S768 : u32 = hash_bits_0(_S759, _S767);
        var _S769 : vec2<f32> = _S758 - _S766 - vec2<f32>(share_of_0(_S767), share_of_0((_S767 >> (u32(10)))));
        var _S770 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S767 >> (u32(20)))));
        var _S771 : f32 = mix(5.0f, 16.0f, share_of_0((_S768 >> (u32(10))))) / 17.0f;
        var _S772 : f32 = _S769.x;
        var _S773 : f32 = _S770.y;
        var _S774 : f32 = _S769.y;
        var _S775 : f32 = _S770.x;
        var _S776 : f32 = (_S772 * _S773 + _S774 * _S775) / _S771;
        var _S777 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S768 >> (u32(20)))) - 1.0f);
        var _S778 : f32 = 2.0f * _S777 * _S776;
        var _S779 : f32 = rsqrt_0(_S778 * _S778 + 1.0f);
        var _S780 : f32 = (_S774 * _S773 - _S772 * _S775 - _S777 * _S771 * _S776 * _S776) * _S779 * 17.0f;
        var _S781 : f32 = clamp((0.31999999284744263f - abs(_S780)) * _S755 * _S760 + 0.5f, 0.0f, _S761);
        var _S782 : u32;
        if(((((_S768 >> (u32(30)))) & (u32(1)))) == u32(1))
        {
            _S782 = fabrics_0[_S751].warp_0;
        }
        else
        {
            _S782 = fabrics_0[_S751].weft_0;
        }
        var _S783 : bool;
        if((share_of_0(_S768)) < (families_0[_S782].hairiness_0))
        {
            _S783 = (abs(_S776)) < 1.0f;
        }
        else
        {
            _S783 = false;
        }
        var _S784 : bool;
        if(_S783)
        {
            _S784 = _S781 > cover_2;
        }
        else
        {
            _S784 = false;
        }
        if(_S784)
        {
            var _S785 : vec2<f32> = vec2<f32>(- _S775 - _S778 * _S773, _S773 - _S778 * _S775) * vec2<f32>(_S779);
            cover_2 = _S781;
            hair_away_0 = _S780;
            hair_across_0 = _S785;
        }
        number_3 = number_3 + u32(1);
    }
    var _S786 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S757 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S786) * hair_across_0, sqrt(1.0f - _S786 * _S786));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S787 : u32,  _S788 : f32) -> bool
{
    var _S789 : bool;
    if((fabrics_0[_S787].fibre_noise_0) > 0.0f)
    {
        _S789 = true;
    }
    else
    {
        _S789 = (fabrics_0[_S787].colour_noise_0) > 0.0f;
    }
    if(_S789)
    {
        _S789 = true;
    }
    else
    {
        if((fabrics_0[_S787].has_detail_0) != u32(0))
        {
            _S789 = _S788 >= 0.0f;
        }
        else
        {
            _S789 = false;
        }
    }
    return _S789;
}

fn thread_number_0( _S790 : u32,  _S791 : SurfacePoint_0,  _S792 : f32,  _S793 : f32) -> u32
{
    var _S794 : f32;
    if(_S791.is_warp_3)
    {
        _S794 = _S792;
    }
    else
    {
        _S794 = _S793;
    }
    var _S795 : f32 = _S794 - _S791.across_5;
    var _S796 : u32;
    if(_S791.is_warp_3)
    {
        _S796 = fabrics_0[_S790].warp_0;
    }
    else
    {
        _S796 = fabrics_0[_S790].weft_0;
    }
    var _S797 : f32 = families_0[_S796].period_0;
    var _S798 : i32 = i32(families_0[_S796].count_0);
    if(_S791.is_warp_3)
    {
        _S796 = _S791.warp_thread_0;
    }
    else
    {
        _S796 = _S791.weft_thread_0;
    }
    var _S799 : u32 = u32(i32(floor(_S795 / _S797)) * _S798 + i32(_S796)) * u32(2);
    if(_S791.is_warp_3)
    {
        _S796 = u32(1);
    }
    else
    {
        _S796 = u32(0);
    }
    return _S799 + _S796;
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

fn fibre_noise_at_0( _S800 : u32,  _S801 : u32,  _S802 : SurfacePoint_0,  _S803 : u32,  _S804 : f32) -> FibreNoise_0
{
    var _S805 : f32 = 5.0f * fabrics_0[_S800].fibre_size_0;
    var _S806 : vec2<f32> = wave_noise_0(hash_key_0(_S803, ((fabrics_0[_S800].seed_0) ^ (u32(458671337)))), _S802.fibre_along_0 / (25.0f * fabrics_0[_S800].fibre_size_0));
    var _S807 : f32 = _S802.fibre_across_0 + families_0[_S801].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S800].fibre_size_0 * _S806.x;
    var _S808 : vec3<f32> = fibre_cell_0(_S807, _S802.fibre_along_0, fabrics_0[_S800].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S803, ((fabrics_0[_S800].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S807, _S802.fibre_along_0, _S805));
    noise_0.bundle_weight_0 = fade_0(_S804, _S805);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S803, ((fabrics_0[_S800].seed_0) ^ (u32(48610963)))), _S808);
    noise_0.fibre_weight_0 = fade_0(_S804, fabrics_0[_S800].fibre_size_0);
    noise_0.offset_4 = _S808.z;
    noise_0.slope_2 = 0.5f * _S806.y;
    return noise_0;
}

fn detail_gain_0( _S809 : u32,  _S810 : u32,  _S811 : SurfacePoint_0,  _S812 : vec2<f32>,  _S813 : bool,  _S814 : u32,  _S815 : f32) -> vec2<f32>
{
    var _S816 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S810].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S815, 1.0f / families_0[_S810].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S810, _S811, _S813))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S816;
    }
    if((families_0[_S810].fibre_tone_0) > 0.0f)
    {
        var _S817 : FibreNoise_0 = fibre_noise_at_0(_S809, _S810, _S811, _S814, _S815);
        gain_2 = gain_2 + vec2<f32>(families_0[_S810].fibre_tone_0) * vec2<f32>(_S817.bundle_weight_0 * _S817.bundle_0.y + _S817.fibre_weight_0 * _S817.fibre_0.y, _S817.bundle_weight_0 + _S817.fibre_weight_0);
    }
    if((families_0[_S810].slub_0) > 0.0f)
    {
        var _S818 : f32 = 0.25f * families_0[_S810].slub_0 * fade_0(_S815, 1.0f / families_0[_S810].slubs_per_mm_0);
        var _S819 : f32;
        if(_S811.is_warp_3)
        {
            _S819 = _S812.y;
        }
        else
        {
            _S819 = - _S812.x;
        }
        gain_2 = gain_2 + vec2<f32>(_S818) * vec2<f32>(wave_noise_0(hash_key_0(_S814, ((fabrics_0[_S809].seed_0) ^ (u32(1373058189)))), _S819 * families_0[_S810].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S811.across_5 * families_0[_S810].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S820 : u32,  _S821 : Albedos_0,  _S822 : u32,  _S823 : u32,  _S824 : vec2<f32>) -> Albedos_0
{
    var _S825 : vec3<f32> = max(_S821.specular_reflect_0, _S821.specular_transmit_0);
    var _S826 : vec3<f32> = _S821.diffuse_reflect_0 + _S821.diffuse_transmit_0;
    var _S827 : vec3<f32> = vec3<f32>(fabrics_0[_S820].layer_bound_0);
    var _S828 : vec3<f32> = vec3<f32>(1.0f);
    var _S829 : vec3<f32> = _S828 - _S827 * _S825;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S822, fabrics_0[_S820].colour_noise_0, fabrics_0[_S820].seed_0), _S826, _S829);
    var _S830 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S824.y, vec3<f32>(colour_1) * _S826, _S829) * _S824.x)));
    var _S831 : f32 = bounded_gain_0(fibre_gain_0(_S822, _S823, fabrics_0[_S820].fibre_noise_0, fabrics_0[_S820].seed_0), _S825, min((_S828 - _S830 * _S826) / _S827, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S830 * _S821.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S830 * _S821.diffuse_transmit_0;
    var _S832 : vec3<f32> = vec3<f32>(_S831);
    varied_0.specular_reflect_0 = _S832 * _S821.specular_reflect_0;
    varied_0.specular_transmit_0 = _S832 * _S821.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S833 : u32,  _S834 : SurfacePoint_0,  _S835 : Albedos_0,  _S836 : f32,  _S837 : f32,  _S838 : bool,  _S839 : f32,  _S840 : f32) -> Albedos_0
{
    var _S841 : u32 = thread_number_0(_S833, _S834, _S836, _S837);
    var _S842 : vec3<f32> = fibre_cell_0(_S834.fibre_across_0, _S834.fibre_along_0, fabrics_0[_S833].fibre_size_0);
    var _S843 : vec2<f32> = vec2<f32>(0.0f);
    var _S844 : bool;
    if((fabrics_0[_S833].has_detail_0) != u32(0))
    {
        _S844 = _S839 >= 0.0f;
    }
    else
    {
        _S844 = false;
    }
    var gain_3 : vec2<f32>;
    if(_S844)
    {
        var _S845 : u32;
        if(_S834.is_warp_3)
        {
            _S845 = fabrics_0[_S833].warp_0;
        }
        else
        {
            _S845 = fabrics_0[_S833].weft_0;
        }
        gain_3 = detail_gain_0(_S833, _S845, _S834, vec2<f32>(_S836, _S837), _S838, _S841, _S839) * vec2<f32>(1.0f - _S840, 1.0f);
    }
    else
    {
        gain_3 = _S843;
    }
    return vary_albedos_0(_S833, _S835, _S841, u32(i32(_S842.x)) * u32(65536) + u32(i32(floor(_S842.y))), gain_3);
}

fn turned_frame_0( _S846 : u32,  _S847 : u32,  _S848 : SurfacePoint_0,  _S849 : bool,  _S850 : u32,  _S851 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_6 = _S848.normal_5;
    frame_2.tangent_5 = _S848.tangent_4;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S847].has_plies_0) > 0.0f)
    {
        var _S852 : f32 = fade_0(_S851, 1.0f / families_0[_S847].plies_per_mm_0);
        var _S853 : f32 = _S852 * 0.41999998688697815f * ply_offset_0(_S847, _S848, _S849);
        var _S854 : f32 = sqrt(1.0f - _S853 * _S853);
        var _S855 : f32;
        if(_S849)
        {
            _S855 = - families_0[_S847].ply_sine_0;
        }
        else
        {
            _S855 = families_0[_S847].ply_sine_0;
        }
        var _S856 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S857 : vec3<f32> = vec3<f32>(families_0[_S847].ply_cosine_0);
        var _S858 : vec3<f32> = _S857 * _S856 + vec3<f32>(_S855) * frame_2.tangent_5;
        var _S859 : vec3<f32> = vec3<f32>(_S854);
        var _S860 : vec3<f32> = vec3<f32>(_S853);
        frame_2.tangent_5 = _S857 * (_S857 * frame_2.tangent_5 - vec3<f32>(_S855) * _S856) + vec3<f32>(_S855) * (_S859 * _S858 - _S860 * frame_2.normal_6);
        frame_2.normal_6 = _S859 * frame_2.normal_6 + _S860 * _S858;
        frame_2.loss_0 = _S852 * _S852 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S861 : f32 = families_0[_S847].fibre_tilt_0;
    if((families_0[_S847].fibre_tilt_0) > 0.0f)
    {
        var _S862 : FibreNoise_0 = fibre_noise_at_0(_S846, _S847, _S848, _S850, _S851);
        var _S863 : f32 = 1.09858846664428711f * _S861 * (_S862.bundle_weight_0 * _S862.bundle_0.x + _S862.fibre_weight_0 * (_S862.fibre_0.x + _S862.offset_4));
        var _S864 : f32 = _S861 * (1.42099642753601074f * (_S862.bundle_weight_0 * _S862.bundle_0.y + _S862.fibre_weight_0 * _S862.fibre_0.y) - _S862.bundle_weight_0 * _S862.slope_2);
        var _S865 : f32 = square_1(_S862.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S861 * _S861 * ((0.24761904776096344f * (square_1(_S862.bundle_weight_0) + _S865) + _S865 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S866 : vec3<f32> = cross(frame_2.tangent_5, frame_2.normal_6);
        var _S867 : vec2<f32> = sine_cosine_0(_S863);
        var _S868 : vec2<f32> = sine_cosine_0(_S864);
        var _S869 : vec3<f32> = vec3<f32>(_S867.y);
        var _S870 : vec3<f32> = vec3<f32>(_S867.x);
        var _S871 : vec3<f32> = _S869 * _S866 - _S870 * frame_2.normal_6;
        frame_2.normal_6 = _S869 * frame_2.normal_6 + _S870 * _S866;
        frame_2.tangent_5 = vec3<f32>(_S868.y) * frame_2.tangent_5 + vec3<f32>(_S868.x) * _S871;
    }
    return frame_2;
}

fn yarn_point_of_0( _S872 : u32,  _S873 : SurfacePoint_0,  _S874 : f32,  _S875 : f32,  _S876 : bool,  _S877 : bool,  _S878 : f32) -> YarnPoint_0
{
    var _S879 : u32;
    if(_S873.is_warp_3)
    {
        _S879 = fabrics_0[_S872].warp_0;
    }
    else
    {
        _S879 = fabrics_0[_S872].weft_0;
    }
    var _S880 : bool;
    if((fabrics_0[_S872].has_detail_0) != u32(0))
    {
        _S880 = _S878 >= 0.0f;
    }
    else
    {
        _S880 = false;
    }
    var _S881 : vec3<f32> = vec3<f32>(0.0f);
    var _S882 : Hair_0 = Hair_x24init_0(0.0f, _S881, _S881);
    var _S883 : bool;
    if(_S880)
    {
        _S883 = has_hairs_0(_S872);
    }
    else
    {
        _S883 = false;
    }
    var hair_2 : Hair_0;
    if(_S883)
    {
        hair_2 = hair_at_0(_S872, vec2<f32>(_S874, _S875), _S876, _S878);
    }
    else
    {
        hair_2 = _S882;
    }
    var _S884 : u32;
    if(_S873.is_warp_3)
    {
        _S884 = _S873.warp_thread_0;
    }
    else
    {
        _S884 = _S873.weft_thread_0;
    }
    var albedos_9 : Albedos_0 = albedos_of_0(_S879, _S884);
    var albedos_10 : Albedos_0;
    if(varies_at_0(_S872, _S878))
    {
        albedos_10 = varied_at_0(_S872, _S873, albedos_9, _S874, _S875, _S876, _S878, hair_2.cover_0);
    }
    else
    {
        albedos_10 = albedos_9;
    }
    var point_7 : YarnPoint_0;
    point_7.back_6 = _S876;
    point_7.hole_0 = _S877;
    point_7.is_warp_0 = _S873.is_warp_3;
    point_7.x_8 = _S874;
    point_7.y_3 = _S875;
    point_7.height_2 = _S873.height_6;
    point_7.normal_1 = _S873.normal_5;
    point_7.tangent_0 = _S873.tangent_4;
    point_7.surface_normal_0 = _S873.normal_5;
    point_7.diffuse_gain_0 = 1.0f;
    if(_S880)
    {
        var _S885 : YarnFrame_0 = turned_frame_0(_S872, _S879, _S873, _S876, thread_number_0(_S872, _S873, _S874, _S875), _S878);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S872))
        {
            frame_3 = under_hair_0(_S885, hair_2);
        }
        else
        {
            frame_3 = _S885;
        }
        point_7.normal_1 = frame_3.normal_6;
        point_7.tangent_0 = frame_3.tangent_5;
        point_7.diffuse_gain_0 = diffuse_gain_2(frame_3, fabrics_0[_S872].diffuse_blend_0);
    }
    point_7.roughness_1 = families_0[_S879].roughness_0;
    point_7.albedos_5 = albedos_10;
    return point_7;
}

fn locate_yarn_0( _S886 : u32,  _S887 : SearchQuality_0,  _S888 : f32,  _S889 : f32,  _S890 : vec3<f32>,  _S891 : f32) -> YarnPoint_0
{
    var _S892 : bool = (_S890.z) < 0.0f;
    var _S893 : Hit_0 = first_hit_0(_S886, _S887, _S888, _S889, to_face_frame_0(_S890, _S892), _S892);
    return yarn_point_of_0(_S886, surface_at_0(_S886, _S893.x_15, _S893.y_8, _S892), _S893.x_15, _S893.y_8, _S892, _S893.hole_6, _S891);
}

fn locate_yarn_1( _S894 : u32,  _S895 : SearchQuality_0,  _S896 : f32,  _S897 : f32,  _S898 : vec3<f32>) -> YarnPoint_0
{
    return locate_yarn_0(_S894, _S895, _S896, _S897, _S898, -1.0f);
}

fn blocked_at_0( _S899 : u32,  _S900 : bool,  _S901 : bool,  _S902 : f32,  _S903 : f32) -> Blocked_0
{
    var _S904 : f32 = _S903 * openness_number_0(_S899, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S902, _S904, _S902 * _S902, _S902 * _S904, _S904 * _S904 );
    var _S905 : u32;
    if(_S901)
    {
        _S905 = u32(2);
    }
    else
    {
        _S905 = u32(0);
    }
    var _S906 : u32;
    if(_S900)
    {
        _S906 = u32(0);
    }
    else
    {
        _S906 = u32(1);
    }
    return blocked_of_terms_0(_S899, u32(60) + (_S905 + _S906) * u32(18), terms_2, u32(6));
}

fn bounced_at_0( _S907 : u32,  _S908 : YarnPoint_0,  _S909 : vec3<f32>) -> Bounced_0
{
    var nothing_1 : Bounced_0;
    var _S910 : vec3<f32> = vec3<f32>(0.0f);
    nothing_1.reflected_0 = _S910;
    nothing_1.transmitted_0 = _S910;
    var _S911 : bool;
    if((fabrics_0[_S907].openness_0) == u32(4294967295))
    {
        _S911 = true;
    }
    else
    {
        _S911 = _S908.hole_0;
    }
    if(_S911)
    {
        return nothing_1;
    }
    var _S912 : Blocked_0 = blocked_at_0(_S907, _S908.is_warp_0, _S908.back_6, _S908.surface_normal_0.z, _S908.height_2);
    var _S913 : u32;
    if(_S908.is_warp_0)
    {
        _S913 = u32(0);
    }
    else
    {
        _S913 = u32(1);
    }
    return bounced_by_0(_S912, scattered_by_0(_S907, _S908.albedos_5, _S913, _S909), interior_of_0(_S907, _S909, _S908.back_6));
}

fn shown_at_texel_0( _S914 : u32,  _S915 : ViewedBase_0,  _S916 : u32) -> vec2<f32>
{
    var _S917 : Clustered_std430_0 = fabrics_0[_S914].clustered_0;
    var _S918 : u32 = table_byte_0(fabrics_0[_S914].clustered_0.labels_0, _S915.face_3 * fabrics_0[_S914].clustered_0.columns_0 * fabrics_0[_S914].clustered_0.rows_0 + _S916);
    if(_S918 >= (fabrics_0[_S914].clustered_0.clusters_0))
    {
        return vec2<f32>(0.0f);
    }
    return family_share_0(_S914, _S918, _S915.trust_1.x * BinTaps_read_0(_S915.around_0, _S917.view_0, _S915.face_3 * u32(256), _S917.clusters_0, _S918));
}

fn residual_point_0( _S919 : u32,  _S920 : ClusteredView_0,  _S921 : vec3<f32>,  _S922 : u32,  _S923 : u32) -> ResidualPoint_0
{
    var _S924 : u32 = _S922 + _S923 * u32(1663821227);
    var _S925 : vec2<f32> = vec2<f32>(uniform_of_0(_S924, u32(1)), uniform_of_0(_S924, u32(2)));
    var _S926 : vec2<f32> = _S920.base_0.box_3.corner_1 + _S925 * _S920.base_0.box_3.size_1;
    var result_2 : ResidualPoint_0;
    var _S927 : YarnPoint_0 = locate_yarn_1(_S919, default_quality_0(), _S926.x, _S926.y, _S920.view_4);
    result_2.point_1 = _S927;
    var _S928 : Clustered_std430_0 = fabrics_0[_S919].clustered_0;
    var _S929 : u32 = texel_of_0(&(_S928), _S920.base_0.box_3, _S925);
    result_2.texel_0 = _S929;
    result_2.bounced_2 = bounced_at_0(_S919, _S927, _S921);
    if((fabrics_0[_S919].openness_0) != u32(4294967295))
    {
        var _S930 : Bounced_0 = bounced_by_base_0(_S920, shown_at_texel_0(_S919, _S920.base_0, result_2.texel_0));
        result_2.bounced_2.reflected_0 = result_2.bounced_2.reflected_0 - _S930.reflected_0;
        result_2.bounced_2.transmitted_0 = result_2.bounced_2.transmitted_0 - _S930.transmitted_0;
    }
    return result_2;
}

fn light_sample_count_0( _S931 : i32) -> u32
{
    return frames_0[_S931].lights_0 + frames_0[_S931].environment_samples_0;
}

fn visibility_at_0( _S932 : i32,  _S933 : u32,  _S934 : vec2<u32>) -> f32
{
    if((frames_0[_S932].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S933 * frames_0[_S932].height_0 + _S934.y) * frames_0[_S932].width_0 + _S934.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S935 : i32,  _S936 : u32,  _S937 : u32) -> vec3<f32>
{
    var _S938 : u32 = frames_0[_S935].environment_table_0 + frames_0[_S935].environment_rows_0 + u32(1) + frames_0[_S935].environment_rows_0 * (frames_0[_S935].environment_columns_0 + u32(1)) + u32(3) * (_S936 * frames_0[_S935].environment_columns_0 + _S937);
    return vec3<f32>(scene_number_0(_S938), scene_number_0(_S938 + u32(1)), scene_number_0(_S938 + u32(2)));
}

fn sample_environment_0( _S939 : i32,  _S940 : vec2<f32>,  _S941 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S942 : u32 = frames_0[_S939].environment_rows_0;
    var _S943 : Choice_0 = choose_0(frames_0[_S939].environment_table_0, frames_0[_S939].environment_rows_0, _S940.y);
    var _S944 : u32 = frames_0[_S939].environment_columns_0;
    var _S945 : Choice_0 = choose_0(frames_0[_S939].environment_table_0 + frames_0[_S939].environment_rows_0 + u32(1) + _S943.index_7 * (frames_0[_S939].environment_columns_0 + u32(1)), frames_0[_S939].environment_columns_0, _S940.x);
    var _S946 : vec3<f32> = environment_texel_0(_S939, _S943.index_7, _S945.index_7);
    (*_S941) = _S946 * vec3<f32>((frames_0[_S939].environment_total_0 / max(mean_1(_S946), 9.99999968265522539e-21f)));
    var _S947 : f32 = 3.14159274101257324f / f32(_S942);
    var _S948 : f32 = mix(sine_cosine_0(f32(_S943.index_7) * _S947).y, sine_cosine_0(f32(_S943.index_7 + u32(1)) * _S947).y, _S943.remainder_0);
    var _S949 : f32 = sqrt(max(1.0f - _S948 * _S948, 0.0f));
    var _S950 : vec2<f32> = sine_cosine_0((f32(_S945.index_7) + _S945.remainder_0) * (6.28318548202514648f / f32(_S944)));
    var _S951 : f32 = _S949 * _S950.x;
    var _S952 : f32 = - _S949 * _S950.y;
    return vec3<f32>(frames_0[_S939].environment_cosine_0 * _S951 + frames_0[_S939].environment_sine_0 * _S952, _S948, frames_0[_S939].environment_cosine_0 * _S952 - frames_0[_S939].environment_sine_0 * _S951);
}

fn light_sample_0( _S953 : i32,  _S954 : u32,  _S955 : vec2<u32>,  _S956 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S957 : u32 = frames_0[_S953].lights_0;
    if(_S954 >= (frames_0[_S953].lights_0))
    {
        var weight_2 : vec3<f32>;
        var _S958 : vec3<f32> = sample_environment_0(_S953, pixel_sequence_0(_S955, frames_0[_S953].pass_number_0 * frames_0[_S953].environment_samples_0 + (_S954 - _S957), u32(3)), &(weight_2));
        sample_1.towards_0 = _S958;
        sample_1.irradiance_1 = weight_2 / vec3<f32>(f32(frames_0[_S953].environment_samples_0));
        return sample_1;
    }
    var _S959 : Light_std430_0 = lights_1[_S954];
    sample_1.irradiance_1 = vec3<f32>(_S959.red_0, _S959.green_0, _S959.blue_0);
    sample_1.towards_0 = vec3<f32>(_S959.x_1, _S959.y_1, _S959.z_1);
    if((_S959.is_point_0) != u32(0))
    {
        var _S960 : vec3<f32> = sample_1.towards_0 - _S956;
        var _S961 : f32 = max(square_0(_S960), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S961);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S961);
        sample_1.towards_0 = normalize(_S960);
    }
    return sample_1;
}

fn cluster_density_0( _S962 : u32,  _S963 : ViewedBase_0,  _S964 : BaseTaps_0,  _S965 : u32,  _S966 : u32) -> f32
{
    return BinTaps_read_0(_S964.half_vector_0, fabrics_0[_S962].clustered_0.basis_0, _S963.face_3 * u32(1024), fabrics_0[_S962].clustered_0.clusters_0 * (u32(1) + fabrics_0[_S962].clustered_0.rank_0), _S966 * fabrics_0[_S962].clustered_0.clusters_0 + _S965);
}

struct ClusterTerms_0
{
     diffuse_0 : f32,
     specular_0 : f32,
     lit_0 : f32,
};

fn cluster_attenuation_0( _S967 : u32,  _S968 : ViewedBase_0,  _S969 : BaseTaps_0,  _S970 : u32) -> f32
{
    var _S971 : u32 = fabrics_0[_S967].clustered_0.moments_1 + (_S968.face_3 * fabrics_0[_S967].clustered_0.clusters_0 + _S970) * u32(8);
    var _S972 : vec3<f32> = vec3<f32>(table_number_0(_S971), table_number_0(_S971 + u32(1)), table_number_0(_S971 + u32(2)));
    var _S973 : vec3<f32> = vec3<f32>(table_number_0(_S971 + u32(3)), table_number_0(_S971 + u32(4)), table_number_0(_S971 + u32(5)));
    var _S974 : f32 = table_number_0(_S971 + u32(7));
    var _S975 : f32 = fabrics_0[_S967].optical_depth_0;
    var _S976 : f32 = dot(_S969.facing_0, _S972);
    var _S977 : f32;
    if(_S969.transmits_1)
    {
        _S977 = - _S976;
    }
    else
    {
        _S977 = _S976;
    }
    var _S978 : f32 = max(dot(_S968.view_3, _S972), 0.10000000149011612f);
    var _S979 : f32 = projected_area_1(_S969.facing_0, _S973, _S974) / max(_S977, 0.10000000149011612f);
    var _S980 : f32 = projected_area_1(_S968.view_3, _S973, _S974) / _S978;
    if(!_S969.transmits_1)
    {
        var _S981 : f32 = _S979 + _S980;
        return 0.25f * (1.0f - exponential_0(- _S975 * _S981)) / (_S981 * _S978);
    }
    var _S982 : f32 = max(_S975 * abs(_S979 - _S980), 0.00100000004749745f);
    return 0.25f * _S975 * exponential_0(- _S975 * min(_S979, _S980)) * (1.0f - exponential_0(- _S982)) / (_S982 * _S978);
}

fn cluster_terms_0( _S983 : u32,  _S984 : ViewedBase_0,  _S985 : BaseTaps_0,  _S986 : u32) -> ClusterTerms_0
{
    var _S987 : u32 = u32(2) * fabrics_0[_S983].clustered_0.clusters_0;
    var _S988 : f32 = BinTaps_read_0(_S985.around_1, fabrics_0[_S983].clustered_0.light_0, _S985.first_7, _S987, _S986);
    var _S989 : f32 = BinTaps_read_0(_S984.around_0, fabrics_0[_S983].clustered_0.view_0, _S984.face_3 * u32(256), fabrics_0[_S983].clustered_0.clusters_0, _S986);
    var terms_3 : ClusterTerms_0;
    var _S990 : f32 = _S984.trust_1.x * _S989;
    terms_3.diffuse_0 = _S990 * 0.31830987334251404f * ((1.0f - fabrics_0[_S983].diffuse_blend_0) * abs(_S985.facing_0.z) * _S988 + fabrics_0[_S983].diffuse_blend_0 * BinTaps_read_0(_S985.around_1, fabrics_0[_S983].clustered_0.light_0, _S985.first_7, _S987, fabrics_0[_S983].clustered_0.clusters_0 + _S986));
    terms_3.specular_0 = _S984.trust_1.y * _S989 * _S988 * cluster_attenuation_0(_S983, _S984, _S985, _S986);
    terms_3.lit_0 = _S990 * _S988;
    return terms_3;
}

fn with_cluster_0( _S991 : u32,  _S992 : Components_0,  _S993 : ClusterTerms_0,  _S994 : u32,  _S995 : f32,  _S996 : f32) -> Components_0
{
    var _S997 : bool = _S994 < (fabrics_0[_S991].clustered_0.clusters_0 / u32(2));
    var result_3 : Components_0 = _S992;
    var _S998 : f32;
    if(_S997)
    {
        _S998 = _S995 * _S993.diffuse_0;
    }
    else
    {
        _S998 = 0.0f;
    }
    result_3.diffuse_warp_0 = result_3.diffuse_warp_0 + _S998;
    if(_S997)
    {
        _S998 = 0.0f;
    }
    else
    {
        _S998 = _S995 * _S993.diffuse_0;
    }
    result_3.diffuse_weft_0 = result_3.diffuse_weft_0 + _S998;
    if(_S997)
    {
        _S998 = _S993.specular_0 * _S996;
    }
    else
    {
        _S998 = 0.0f;
    }
    result_3.specular_warp_0 = result_3.specular_warp_0 + _S998;
    if(_S997)
    {
        _S998 = 0.0f;
    }
    else
    {
        _S998 = _S993.specular_0 * _S996;
    }
    result_3.specular_weft_0 = result_3.specular_weft_0 + _S998;
    result_3.light_visibility_1 = result_3.light_visibility_1 + _S995 * _S993.lit_0;
    return result_3;
}

fn clustered_base_0( _S999 : u32,  _S1000 : ViewedBase_0,  _S1001 : BaseTaps_0) -> Components_0
{
    var _S1002 : Clustered_std430_0 = fabrics_0[_S999].clustered_0;
    var _S1003 : u32 = _S1002.clusters_0;
    var base_1 : Components_0 = no_components_0();
    var cluster_2 : u32 = u32(0);
    for(;;)
    {
        if(cluster_2 < _S1003)
        {
        }
        else
        {
            break;
        }
        var _S1004 : f32 = box_mean_1(&(_S1002), _S1000.box_3, _S1000.face_3, cluster_2);
        if(_S1004 <= 0.0f)
        {
            cluster_2 = cluster_2 + u32(1);
            continue;
        }
        var _S1005 : f32 = _S1004 * cluster_density_0(_S999, _S1000, _S1001, cluster_2, u32(0));
        var number_4 : u32 = u32(1);
        var density_0 : f32 = _S1005;
        for(;;)
        {
            if(number_4 <= (_S1002.rank_0))
            {
            }
            else
            {
                break;
            }
            var _S1006 : f32 = box_mean_1(&(_S1002), _S1000.box_3, _S1000.face_3, number_4 * _S1003 + cluster_2);
            var density_1 : f32 = density_0 + _S1006 * cluster_density_0(_S999, _S1000, _S1001, cluster_2, number_4);
            number_4 = number_4 + u32(1);
            density_0 = density_1;
        }
        base_1 = with_cluster_0(_S999, base_1, cluster_terms_0(_S999, _S1000, _S1001, cluster_2), cluster_2, _S1004, density_0);
        cluster_2 = cluster_2 + u32(1);
    }
    return base_1;
}

fn under_sheen_0( _S1007 : u32,  _S1008 : ClusteredView_0,  _S1009 : vec3<f32>,  _S1010 : f32,  _S1011 : vec3<f32>) -> vec3<f32>
{
    var _S1012 : f32 = fabrics_0[_S1007].sheen_strength_0;
    if((fabrics_0[_S1007].sheen_strength_0) <= 0.0f)
    {
        return _S1009;
    }
    var _S1013 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S1011, _S1008.base_0.back_5), _S1008.base_0.view_3, _S1012, fabrics_0[_S1007].sheen_roughness_0);
    return vec3<f32>(_S1013.y) * _S1009 + vec3<f32>((_S1010 * _S1013.x));
}

fn clustered_base_value_0( _S1014 : u32,  _S1015 : ClusteredView_0,  _S1016 : f32,  _S1017 : vec3<f32>) -> vec3<f32>
{
    var _S1018 : BaseTaps_0 = base_taps_0(_S1015.base_0, _S1017);
    var _S1019 : Components_0 = clustered_base_0(_S1014, _S1015.base_0, _S1018);
    return under_sheen_0(_S1014, _S1015, shaded_0(_S1019, _S1015.albedos_4, _S1018.transmits_1) + bounced_value_0(_S1015.bounced_1, _S1017, _S1015.view_4), _S1019.light_visibility_1 + _S1016, _S1017);
}

fn clustered_at_texel_0( _S1020 : u32,  _S1021 : ViewedBase_0,  _S1022 : u32,  _S1023 : BaseTaps_0) -> Components_0
{
    var _S1024 : Clustered_std430_0 = fabrics_0[_S1020].clustered_0;
    var _S1025 : u32 = _S1021.face_3 * fabrics_0[_S1020].clustered_0.columns_0 * fabrics_0[_S1020].clustered_0.rows_0 + _S1022;
    var _S1026 : u32 = table_byte_0(fabrics_0[_S1020].clustered_0.labels_0, _S1025);
    var base_2 : Components_0 = no_components_0();
    if(_S1026 >= (fabrics_0[_S1020].clustered_0.clusters_0))
    {
        return base_2;
    }
    var _S1027 : f32 = cluster_density_0(_S1020, _S1021, _S1023, _S1026, u32(0));
    var number_5 : u32 = u32(1);
    var density_2 : f32 = _S1027;
    for(;;)
    {
        if(number_5 <= (_S1024.rank_0))
        {
        }
        else
        {
            break;
        }
        var _S1028 : i32 = i32(table_byte_0(_S1024.coefficients_0, _S1025 * _S1024.rank_0 + number_5 - u32(1)));
        var _S1029 : i32;
        if(_S1028 > i32(127))
        {
            _S1029 = _S1028 - i32(256);
        }
        else
        {
            _S1029 = _S1028;
        }
        var density_3 : f32 = density_2 + f32(_S1029) * cluster_density_0(_S1020, _S1021, _S1023, _S1026, number_5);
        number_5 = number_5 + u32(1);
        density_2 = density_3;
    }
    return with_cluster_0(_S1020, base_2, cluster_terms_0(_S1020, _S1021, _S1023, _S1026), _S1026, 1.0f, density_2);
}

fn unoccluded_0( _S1030 : u32,  _S1031 : SearchQuality_0,  _S1032 : f32,  _S1033 : f32,  _S1034 : f32,  _S1035 : vec3<f32>,  _S1036 : bool) -> bool
{
    if((_S1035.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S1030, _S1031, vec3<f32>(_S1032, _S1033, _S1034 + fabrics_0[_S1030].lift_0), _S1035, _S1036, max_height_along_0(_S1030, _S1032, _S1033, _S1034, _S1035, _S1036));
}

fn is_lit_0( _S1037 : u32,  _S1038 : SearchQuality_0,  _S1039 : YarnPoint_0,  _S1040 : vec3<f32>) -> bool
{
    if(_S1039.hole_0)
    {
        return true;
    }
    var _S1041 : vec3<f32> = to_face_frame_0(_S1040, _S1039.back_6);
    var _S1042 : f32 = _S1041.z;
    var _S1043 : bool = _S1042 < 0.0f;
    var normal_10 : vec3<f32>;
    var height_12 : f32;
    if(_S1043)
    {
        var _S1044 : SurfacePoint_0 = surface_at_0(_S1037, _S1039.x_8, _S1039.y_3, !_S1039.back_6);
        normal_10 = _S1044.normal_5;
        height_12 = _S1044.height_6;
    }
    else
    {
        normal_10 = _S1039.surface_normal_0;
        height_12 = _S1039.height_2;
    }
    var _S1045 : vec3<f32> = vec3<f32>(_S1041.xy, abs(_S1042));
    if((dot(normal_10, _S1045)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S1037, _S1038, _S1039.x_8, _S1039.y_3, height_12, _S1045, (_S1039.back_6) != _S1043);
}

fn components_of_point_0( _S1046 : u32,  _S1047 : SearchQuality_0,  _S1048 : YarnPoint_0,  _S1049 : vec3<f32>,  _S1050 : vec3<f32>) -> Components_0
{
    var result_4 : Components_0 = no_components_0();
    var _S1051 : f32;
    if(_S1048.hole_0)
    {
        _S1051 = 1.0f;
    }
    else
    {
        _S1051 = 0.0f;
    }
    result_4.hole_5 = _S1051;
    var _S1052 : bool;
    if(_S1048.hole_0)
    {
        _S1052 = true;
    }
    else
    {
        _S1052 = !is_lit_0(_S1046, _S1047, _S1048, _S1049);
    }
    if(_S1052)
    {
        return result_4;
    }
    var _S1053 : vec3<f32> = to_face_frame_0(_S1049, _S1048.back_6);
    var _S1054 : vec3<f32> = to_face_frame_0(_S1050, _S1048.back_6);
    var _S1055 : bool = (_S1053.z) < 0.0f;
    var _S1056 : vec3<f32>;
    if(_S1055)
    {
        _S1056 = (vec3<f32>(0) - _S1053);
    }
    else
    {
        _S1056 = _S1053;
    }
    var _S1057 : f32 = _S1048.diffuse_gain_0 * diffuse_reflection_0(_S1056, _S1048.normal_1, fabrics_0[_S1046].diffuse_blend_0);
    if(_S1055)
    {
        _S1051 = transmission_1(_S1053, _S1054, _S1048.normal_1, _S1048.tangent_0, _S1048.roughness_1, fabrics_0[_S1046].optical_depth_0);
    }
    else
    {
        _S1051 = reflection_0(_S1053, _S1054, _S1048.normal_1, _S1048.tangent_0, _S1048.roughness_1, fabrics_0[_S1046].optical_depth_0);
    }
    var _S1058 : f32;
    if(_S1048.is_warp_0)
    {
        _S1058 = _S1057;
    }
    else
    {
        _S1058 = 0.0f;
    }
    result_4.diffuse_warp_0 = _S1058;
    if(_S1048.is_warp_0)
    {
        _S1058 = 0.0f;
    }
    else
    {
        _S1058 = _S1057;
    }
    result_4.diffuse_weft_0 = _S1058;
    if(_S1048.is_warp_0)
    {
        _S1058 = _S1051;
    }
    else
    {
        _S1058 = 0.0f;
    }
    result_4.specular_warp_0 = _S1058;
    if(_S1048.is_warp_0)
    {
        _S1051 = 0.0f;
    }
    result_4.specular_weft_0 = _S1051;
    result_4.light_visibility_1 = 1.0f;
    return result_4;
}

fn clustered_residual_0( _S1059 : u32,  _S1060 : ClusteredView_0,  _S1061 : ResidualPoint_0,  _S1062 : vec3<f32>,  _S1063 : vec3<f32>) -> vec3<f32>
{
    var _S1064 : BaseTaps_0 = base_taps_0(_S1060.base_0, _S1063);
    var _S1065 : Components_0 = clustered_at_texel_0(_S1059, _S1060.base_0, _S1061.texel_0, _S1064);
    var _S1066 : Components_0 = components_of_point_0(_S1059, default_quality_0(), _S1061.point_1, _S1063, _S1060.view_4);
    var own_2 : FamilyAlbedos_0;
    var _S1067 : Albedos_0 = tinted_0(_S1061.point_1.albedos_5, _S1062);
    own_2.warp_3 = _S1067;
    own_2.weft_3 = _S1067;
    return under_sheen_0(_S1059, _S1060, shaded_0(_S1066, own_2, _S1064.transmits_1) - shaded_0(_S1065, _S1060.albedos_4, _S1064.transmits_1) + bounced_value_0(_S1061.bounced_2, _S1063, _S1060.view_4), _S1066.light_visibility_1 + _S1066.hole_5 - _S1065.light_visibility_1, _S1063);
}

fn passed_by_sheen_0( _S1068 : u32,  _S1069 : f32,  _S1070 : vec3<f32>) -> f32
{
    var _S1071 : f32 = fabrics_0[_S1068].sheen_strength_0;
    if((fabrics_0[_S1068].sheen_strength_0) <= 0.0f)
    {
        return _S1069;
    }
    return _S1069 * (1.0f - _S1071 * sheen_lobe_0(abs(_S1070.z), fabrics_0[_S1068].sheen_roughness_0).z);
}

fn light_of_clustered_0( _S1072 : i32,  _S1073 : u32,  _S1074 : VisiblePoint_0,  _S1075 : vec2<u32>,  _S1076 : vec3<f32>) -> vec4<f32>
{
    var footprint_1 : Footprint_0;
    footprint_1.centre_0 = _S1074.draft_0;
    footprint_1.dx_0 = _S1074.draft_dx_0;
    footprint_1.dy_0 = _S1074.draft_dy_0;
    var _S1077 : vec3<f32> = to_local_0(_S1074, _S1074.view_1);
    var _S1078 : Clustered_std430_0 = fabrics_0[_S1073].clustered_0;
    var _S1079 : u32 = mixed_0(mixed_0(_S1075.x + u32(65536) * _S1075.y) + frames_0[_S1072].pass_number_0 * u32(2654435769));
    var _S1080 : bool = (fabrics_0[_S1073].clustered_0.samples_1) == u32(0);
    var _S1081 : ClusteredView_0 = clustered_view_0(_S1073, footprint_1, _S1077, _S1076, _S1079, _S1080);
    var _S1082 : vec3<f32> = vec3<f32>(0.0f);
    var hole_7 : f32;
    if(_S1080)
    {
        hole_7 = clustered_hole_0(_S1073, _S1081.base_0);
    }
    else
    {
        hole_7 = 0.0f;
    }
    var term_1 : u32 = u32(0);
    var hole_8 : f32 = hole_7;
    var radiance_1 : vec3<f32> = _S1082;
    for(;;)
    {
        if(term_1 <= (_S1078.samples_1))
        {
        }
        else
        {
            break;
        }
        var _S1083 : ResidualPoint_0 = ResidualPoint_x24init_0(YarnPoint_x24init_0(false, false, false, 0.0f, 0.0f, 0.0f, _S1082, _S1082, _S1082, 0.0f, 0.0f, Albedos_x24init_0(_S1082, _S1082, _S1082, _S1082)), u32(0), Bounced_x24init_0(_S1082, _S1082));
        var sample_2 : ResidualPoint_0;
        if(term_1 > u32(0))
        {
            var _S1084 : ResidualPoint_0 = residual_point_0(_S1073, _S1081, _S1076, _S1079, term_1 - u32(1));
            var _S1085 : f32;
            if(_S1084.point_1.hole_0)
            {
                _S1085 = 1.0f;
            }
            else
            {
                _S1085 = 0.0f;
            }
            var hole_9 : f32 = hole_8 + _S1085 / f32(_S1078.samples_1);
            sample_2 = _S1084;
            hole_8 = hole_9;
        }
        else
        {
            sample_2 = _S1083;
        }
        var number_6 : u32 = u32(0);
        var radiance_2 : vec3<f32> = radiance_1;
        for(;;)
        {
            if(number_6 < (light_sample_count_0(_S1072)))
            {
            }
            else
            {
                break;
            }
            var _S1086 : f32 = visibility_at_0(_S1072, number_6, _S1075);
            if(_S1086 <= 0.0f)
            {
                number_6 = number_6 + u32(1);
                continue;
            }
            var _S1087 : LightSample_0 = light_sample_0(_S1072, number_6, _S1075, _S1074.position_0);
            var _S1088 : vec3<f32> = to_local_0(_S1074, _S1087.towards_0);
            var value_1 : vec3<f32>;
            if(term_1 == u32(0))
            {
                value_1 = clustered_base_value_0(_S1073, _S1081, hole_7, _S1088);
            }
            else
            {
                value_1 = clustered_residual_0(_S1073, _S1081, sample_2, _S1076, _S1088) / vec3<f32>(f32(_S1078.samples_1));
            }
            radiance_2 = radiance_2 + vec3<f32>(_S1086) * _S1087.irradiance_1 * value_1;
            number_6 = number_6 + u32(1);
        }
        term_1 = term_1 + u32(1);
        radiance_1 = radiance_2;
    }
    return vec4<f32>(radiance_1, 1.0f - passed_by_sheen_0(_S1073, hole_8, _S1077));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_clustered(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1089 : u32 = id_0.x;
    var _S1090 : u32 = frames_0[i32(0)].width_0;
    var _S1091 : bool;
    if(_S1089 >= (frames_0[i32(0)].width_0))
    {
        _S1091 = true;
    }
    else
    {
        _S1091 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S1091)
    {
        return;
    }
    var _S1092 : u32 = id_0.y * _S1090 + _S1089;
    var _S1093 : u32 = layers_0[_S1092].face_0;
    if((layers_0[_S1092].face_0) == u32(0))
    {
        return;
    }
    var _S1094 : u32 = _S1093 - u32(1);
    var _S1095 : u32 = face_fabrics_0[_S1094];
    var _S1096 : vec2<u32> = id_0.xy;
    var _S1097 : VisiblePoint_0 = visible_point_0(i32(0), _S1095, _S1094, _S1096);
    accumulate_0(_S1092, light_of_clustered_0(i32(0), _S1095, _S1097, _S1096, filtered_albedo_0(_S1095, _S1097)));
    return;
}

