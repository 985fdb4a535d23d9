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

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S29 : vec2<f32> = this_0.dx_0;
    var _S30 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S29, _S29) + dot(_S30, _S30)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S31 : vec2<f32> = direction_1.xy;
    var _S32 : f32;
    if(back_2)
    {
        _S32 = - direction_1.z;
    }
    else
    {
        _S32 = direction_1.z;
    }
    return vec3<f32>(_S31, _S32);
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S33 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S33, fma(- _S33, families_0[family_0].count_0, index_2));
}

struct Cell_0
{
     thread_2 : u32,
     across_0 : f32,
     half_width_1 : f32,
     below_0 : f32,
     above_0 : f32,
};

fn locate_alike_0( family_1 : u32,  position_1 : f32) -> Cell_0
{
    var _S34 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S35 : f32 = fma(- _S34, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S35;
    cell_2.above_0 = families_0[family_1].size_0 - _S35;
    cell_2.across_0 = _S35 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S34).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_2;
}

fn table_number_0( index_3 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_3])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S36 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S37 : u32;
    if(_S36 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1))))
    {
        _S37 = u32(1);
    }
    else
    {
        _S37 = u32(0);
    }
    var _S38 : u32 = min(thread_3 + _S37, u32(families_0[family_2].count_0) - u32(1));
    var _S39 : u32 = families_0[family_2].place_table_0 + _S38 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S38;
    cell_3.below_0 = _S36 - table_number_0(_S39);
    cell_3.above_0 = table_number_0(_S39 + u32(1)) - _S36;
    cell_3.across_0 = _S36 - table_number_0(_S39 + u32(2));
    cell_3.half_width_1 = table_number_0(_S39 + u32(3));
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
    var _S40 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var _S41 : bool = (abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1);
    var shown_0 : Shown_0;
    var _S42 : bool;
    if(_S40)
    {
        if(!_S41)
        {
            _S42 = true;
        }
        else
        {
            _S42 = crossing_0.warp_above_0;
        }
    }
    else
    {
        _S42 = false;
    }
    shown_0.is_warp_0 = _S42;
    if(!_S40)
    {
        _S42 = !_S41;
    }
    else
    {
        _S42 = false;
    }
    shown_0.hole_0 = _S42;
    var _S43 : u32;
    if(shown_0.is_warp_0)
    {
        _S43 = crossing_0.warp_word_0;
    }
    else
    {
        _S43 = crossing_0.weft_word_0;
    }
    shown_0.word_0 = _S43;
    shown_0.on_top_0 = (((_S43 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_1 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_4 : Cell_0;
    var _S44 : u32;
    if(is_first_0)
    {
        _S44 = first_1.thread_2;
    }
    else
    {
        _S44 = second_0.thread_2;
    }
    cell_4.thread_2 = _S44;
    var _S45 : f32;
    if(is_first_0)
    {
        _S45 = first_1.across_0;
    }
    else
    {
        _S45 = second_0.across_0;
    }
    cell_4.across_0 = _S45;
    if(is_first_0)
    {
        _S45 = first_1.half_width_1;
    }
    else
    {
        _S45 = second_0.half_width_1;
    }
    cell_4.half_width_1 = _S45;
    if(is_first_0)
    {
        _S45 = first_1.below_0;
    }
    else
    {
        _S45 = second_0.below_0;
    }
    cell_4.below_0 = _S45;
    if(is_first_0)
    {
        _S45 = first_1.above_0;
    }
    else
    {
        _S45 = second_0.above_0;
    }
    cell_4.above_0 = _S45;
    return cell_4;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S46 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S46.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S46.y) * u32(4)));
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
    var _S47 : u32 = families_0[family_6].bend_table_0;
    var _S48 : u32;
    if((families_0[family_6].is_alike_0) != u32(0))
    {
        _S48 = u32(0);
    }
    else
    {
        _S48 = thread_6 * u32(4);
    }
    var _S49 : u32 = _S47 + _S48;
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S49);
    bend_0.half_tangent_0 = table_number_0(_S49 + u32(1));
    bend_0.arc_0 = table_number_0(_S49 + u32(2));
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
    var _S50 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S51 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S52 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S53 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    run_0.straight_0 = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    var _S54 : i32 = - _S50;
    var _S55 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S54, i32(0));
    run_0.from_start_0 = _S55;
    var _S56 : i32 = _S51 + i32(1);
    var _S57 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S56);
    run_0.to_end_0 = _S57;
    var _S58 : bool = _S55 < _S57;
    run_0.near_start_0 = _S58;
    var _S59 : i32;
    if(_S58)
    {
        _S59 = _S54 - _S52;
    }
    else
    {
        _S59 = _S56;
    }
    var _S60 : i32;
    if(run_0.near_start_0)
    {
        _S60 = _S54;
    }
    else
    {
        _S60 = _S56 + _S53;
    }
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    var _S61 : f32;
    if(run_0.straight_0)
    {
        _S61 = 1.0e+06f;
    }
    else
    {
        _S61 = min(run_0.from_start_0, run_0.to_end_0);
    }
    run_0.distance_0 = _S61;
    run_0.reach_0 = min(0.5f * (run_0.from_start_0 + run_0.to_end_0), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S59, _S60), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S50 == i32(0);
    run_0.last_crossing_0 = _S51 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_5 : Cell_0) -> Section_0
{
    var _S62 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S63 : f32 = clamp(cell_5.across_0, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_1 = _S63;
    var _S64 : f32 = _S62 * _S62 - square_1(_S63);
    var _S65 : f32 = rsqrt_0(_S64);
    section_0.drop_0 = _S62 - _S64 * _S65;
    section_0.slope_0 = - _S63 * _S65;
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
    var _S66 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S67 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S68 : f32;
    if(_S66)
    {
        _S68 = crossed_1.below_0 - crossed_1.across_0;
    }
    else
    {
        _S68 = crossed_1.above_0 + crossed_1.across_0;
    }
    var _S69 : f32 = _S68 - crossed_1.half_width_1;
    var _S70 : bool;
    if(_S66)
    {
        _S70 = run_1.first_crossing_0;
    }
    else
    {
        _S70 = run_1.last_crossing_0;
    }
    if(shown_1.on_top_0)
    {
        _S68 = 0.0f;
    }
    else
    {
        _S68 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S71 : f32;
    if((shown_1.on_top_0) != _S70)
    {
        _S71 = 0.0f;
    }
    else
    {
        var _S72 : f32 = families_0[other_1].height_scale_0;
        var _S73 : i32;
        if(_S66)
        {
            _S73 = i32(-1);
        }
        else
        {
            _S73 = i32(1);
        }
        _S71 = _S72 * edge_drop_0(other_1, crossed_1.thread_2, _S73);
    }
    var _S74 : f32 = 1.0f / max(2.0f * _S69, 9.999999960041972e-13f);
    var _S75 : f32 = clamp((_S69 - _S67) * _S74, 0.0f, 1.0f);
    var _S76 : f32 = _S68 + (_S71 - _S68) * (_S75 * _S75 * (3.0f - 2.0f * _S75));
    var _S77 : f32 = (_S68 - _S71) * (6.0f * _S75 * (1.0f - _S75) * _S74);
    if(_S66)
    {
        _S68 = 1.0f;
    }
    else
    {
        _S68 = -1.0f;
    }
    return vec2<f32>(_S76, _S77 * _S68);
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
    var _S78 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S78), 9.99999971718068537e-10f);
    var _S79 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S79), 9.99999971718068537e-10f);
    control_0.right_0 = _S78 > 0.0f;
    control_0.up_0 = _S79 > 0.0f;
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
    var _S80 : f32;
    if(forwards_0)
    {
        _S80 = cell_6.across_0;
    }
    else
    {
        _S80 = - cell_6.across_0;
    }
    var _S81 : f32;
    if(forwards_0)
    {
        _S81 = cell_6.above_0;
    }
    else
    {
        _S81 = cell_6.below_0;
    }
    var _S82 : bool;
    if(forwards_0)
    {
        _S82 = run_2.last_crossing_0;
    }
    else
    {
        _S82 = run_2.first_crossing_0;
    }
    var _S83 : bool;
    if(forwards_0)
    {
        _S83 = run_2.first_crossing_0;
    }
    else
    {
        _S83 = run_2.last_crossing_0;
    }
    var _S84 : f32 = - cell_6.half_width_1;
    var _S85 : bool = _S80 < _S84;
    var _S86 : bool = _S80 >= (cell_6.half_width_1);
    if(lengthwise_0)
    {
        _S82 = !_S82;
    }
    else
    {
        _S82 = false;
    }
    if(_S82)
    {
        _S82 = !shown_2.hole_0;
    }
    else
    {
        _S82 = false;
    }
    var _S87 : bool;
    if(_S82)
    {
        _S87 = shown_2.on_top_0;
    }
    else
    {
        _S87 = false;
    }
    if(_S87)
    {
        if(_S83)
        {
            _S83 = _S85;
        }
        else
        {
            _S83 = false;
        }
        _S83 = !_S83;
    }
    else
    {
        _S83 = false;
    }
    if(shown_2.hole_0)
    {
        _S82 = true;
    }
    else
    {
        if(_S82)
        {
            _S82 = !shown_2.on_top_0;
        }
        else
        {
            _S82 = false;
        }
    }
    var _S88 : f32;
    if(_S85)
    {
        _S88 = _S84;
    }
    else
    {
        _S88 = cell_6.half_width_1;
    }
    var _S89 : f32 = _S88 - _S80;
    if(_S82)
    {
        _S80 = 2.0f * _S81 + _S80 - cell_6.half_width_1;
    }
    else
    {
        _S80 = _S81;
    }
    if(_S83)
    {
        if(forwards_0)
        {
            _S80 = run_2.to_end_0;
        }
        else
        {
            _S80 = run_2.from_start_0;
        }
        return _S80;
    }
    if(_S86)
    {
    }
    else
    {
        _S80 = _S89;
    }
    return _S80;
}

struct Probe_0
{
     height_2 : f32,
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
    var _S90 : f32 = previous_1.rate_0 * step_4;
    var _S91 : f32 = rate_1 * step_4;
    var _S92 : bool;
    if(!previous_1.known_0)
    {
        _S92 = true;
    }
    else
    {
        _S92 = here_0.hole_1;
    }
    if(_S92)
    {
        _S92 = true;
    }
    else
    {
        _S92 = (previous_1.yarn_0) != (here_0.yarn_1);
    }
    if(_S92)
    {
        _S92 = true;
    }
    else
    {
        _S92 = (previous_1.rate_0) >= 0.0f;
    }
    if(_S92)
    {
        _S92 = true;
    }
    else
    {
        _S92 = rate_1 <= 0.0f;
    }
    if(_S92)
    {
        return -1.0f;
    }
    if((3.0f * previous_1.clearance_0 + _S90) >= 0.0f)
    {
        _S92 = (3.0f * clearance_1 - _S91) >= 0.0f;
    }
    else
    {
        _S92 = false;
    }
    if(_S92)
    {
        return -1.0f;
    }
    var _S93 : f32 = clearance_1 - previous_1.clearance_0;
    var _S94 : f32 = 6.0f * _S93 - 4.0f * _S90 - 2.0f * _S91;
    var _S95 : f32 = -2.0f * _S90 / max(_S94 + sqrt(max(_S94 * _S94 - 4.0f * (3.0f * (_S90 + _S91 - 2.0f * _S93)) * _S90, 0.0f)), 9.99999968265522539e-21f);
    var _S96 : f32 = 1.0f - _S95;
    var _S97 : f32 = (previous_1.clearance_0 * (2.0f * _S95 + 1.0f) + _S90 * _S95) * _S96 * _S96;
    var _S98 : f32 = (clearance_1 * (2.0f * _S96 + 1.0f) - _S91 * _S96) * _S95 * _S95;
    if(_S95 > 0.01999999955296516f)
    {
        _S92 = _S96 > 0.01999999955296516f;
    }
    else
    {
        _S92 = false;
    }
    if(_S92)
    {
        _S92 = (_S97 + _S98) < 0.0f;
    }
    else
    {
        _S92 = false;
    }
    var _S99 : f32;
    if(_S92)
    {
        _S99 = _S96 * step_4;
    }
    else
    {
        _S99 = -1.0f;
    }
    return _S99;
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    var _S100 : f32;
    if(here_1.hole_1)
    {
        _S100 = 1.0e+09f;
    }
    else
    {
        _S100 = clearance_2;
    }
    previous_2.clearance_0 = _S100;
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    var _S101 : bool;
    if(!here_1.hole_1)
    {
        _S101 = !is_cell_exit_0;
    }
    else
    {
        _S101 = false;
    }
    previous_2.known_0 = _S101;
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S102 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    var _S103 : bool;
    if(!here_2.hole_1)
    {
        _S103 = (rate_3 * _S102 + clearance_3) < 0.0f;
    }
    else
    {
        _S103 = false;
    }
    if(_S103)
    {
        _S103 = _S102 > (2.0f * this_2.epsilon_0);
    }
    else
    {
        _S103 = false;
    }
    var _S104 : f32;
    if(_S103)
    {
        _S104 = _S102 - this_2.epsilon_0;
    }
    else
    {
        _S104 = max(_S102, 0.0f) + this_2.epsilon_0;
    }
    return min(this_2.step_2, _S104);
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
    var _S105 : f32 = end_0 - start_1;
    var _S106 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S105;
    var _S107 : f32 = 3.0f * _S105 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S105, 9.99999968265522539e-21f);
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
        var _S108 : f32 = clamp(share_1 - (((_S106 * share_1 + _S107) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S106 * share_1 + 2.0f * _S107) * share_1 + start_rate_0, 0.10000000149011612f * _S105 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S109 : i32 = i_0 + i32(1);
        share_1 = _S108;
        i_0 = _S109;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S110 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S111 : f32 = rsqrt_0(_S110);
    var _S112 : f32 = sine_1 * _S111 * rsqrt_0(_S110 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S112 * _S110, _S112 * across_slope_0 * along_slope_0 + cosine_0 * _S111);
}

fn arc_sine_0( x_7 : f32) -> f32
{
    var _S113 : f32 = abs(x_7);
    var _S114 : bool = _S113 > 0.5f;
    var _S115 : f32;
    if(_S114)
    {
        _S115 = 0.5f * (1.0f - _S113);
    }
    else
    {
        _S115 = _S113 * _S113;
    }
    var _S116 : f32;
    if(_S114)
    {
        _S116 = sqrt(max(_S115, 0.0f));
    }
    else
    {
        _S116 = _S113;
    }
    var _S117 : f32 = ((((0.04216320067644119f * _S115 + 0.02418131195008755f) * _S115 + 0.04547002539038658f) * _S115 + 0.07495300471782684f) * _S115 + 0.16666752099990845f) * _S115 * _S116 + _S116;
    if(_S114)
    {
        _S115 = 1.57079637050628662f - 2.0f * _S117;
    }
    else
    {
        _S115 = _S117;
    }
    if(x_7 < 0.0f)
    {
        _S115 = - _S115;
    }
    return _S115;
}

struct Hair_0
{
     cover_0 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>) -> Hair_0
{
    var _S118 : Hair_0;
    _S118.cover_0 = cover_1;
    _S118.normal_1 = normal_2;
    _S118.tangent_0 = tangent_1;
    return _S118;
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_8 : f32) -> vec2<f32>
{
    var _S119 : f32 = floor(x_8 * 0.63661974668502808f + 0.5f);
    var _S120 : f32 = x_8 - _S119 * 1.5703125f - _S119 * 0.00048375129699707f - _S119 * 7.54979012640433211e-08f;
    var _S121 : f32 = _S120 * _S120;
    var _S122 : f32 = ((-0.00019515295571182f * _S121 + 0.00833216123282909f) * _S121 - 0.16666655242443085f) * _S121 * _S120 + _S120;
    var _S123 : f32 = ((0.00002443315679557f * _S121 - 0.00138873164542019f) * _S121 + 0.04166664555668831f) * _S121 * _S121 - 0.5f * _S121 + 1.0f;
    var _S124 : u32 = (u32(i32(_S119)) & (u32(3)));
    var _S125 : vec2<f32>;
    if(((_S124 & (u32(1)))) != u32(0))
    {
        _S125 = vec2<f32>(_S123, _S122);
    }
    else
    {
        _S125 = vec2<f32>(_S122, _S123);
    }
    var _S126 : f32;
    if(((_S124 & (u32(2)))) != u32(0))
    {
        _S126 = - _S125.x;
    }
    else
    {
        _S126 = _S125.x;
    }
    var _S127 : f32;
    if((((_S124 + u32(1)) & (u32(2)))) != u32(0))
    {
        _S127 = - _S125.y;
    }
    else
    {
        _S127 = _S125.y;
    }
    return vec2<f32>(_S126, _S127);
}

fn table_colour_0( index_4 : u32) -> vec3<f32>
{
    return vec3<f32>(table_number_0(index_4), table_number_0(index_4 + u32(1)), table_number_0(index_4 + u32(2)));
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

fn fibre_cell_0( across_2 : f32,  along_0 : f32,  width_2 : f32) -> vec3<f32>
{
    var _S128 : f32 = floor(across_2 / width_2);
    return vec3<f32>(_S128, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S128, 2.0f * (across_2 / width_2 - _S128) - 1.0f);
}

struct SurfacePoint_0
{
     hole_2 : bool,
     is_warp_1 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_4 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     across_3 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
};

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S129 : f32;
    if(back_4)
    {
        _S129 = - families_0[family_9].ply_sine_0;
    }
    else
    {
        _S129 = families_0[family_9].ply_sine_0;
    }
    var _S130 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * _S129) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S130 - floor(_S130)) - 1.0f;
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
    var _S131 : f32 = floor(position_4);
    var _S132 : f32 = position_4 - _S131;
    var _S133 : u32 = u32(i32(_S131));
    var _S134 : f32 = signed_noise_0(hash_bits_0(key_1, _S133));
    var _S135 : f32 = signed_noise_0(hash_bits_0(key_1, _S133 + u32(1)));
    return vec2<f32>(mix(_S134, _S135, smooth_share_0(_S132)), 6.0f * _S132 * (1.0f - _S132) * (_S135 - _S134));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S136 : f32 = cell_7.y;
    var _S137 : f32 = floor(_S136);
    var _S138 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S137));
    var _S139 : u32 = hash_bits_0(key_2, _S138);
    var _S140 : u32 = hash_bits_0(key_2, _S138 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S139), signed_noise_0((_S139 >> (u32(16))))), vec2<f32>(signed_noise_0(_S140), signed_noise_0((_S140 >> (u32(16))))), vec2<f32>(smooth_share_0(_S136 - _S137)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S141 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S141.x, _S141.y), _S141.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S142 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S142.x, _S142.y), _S142.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_8 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_8, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_4 : vec3<f32>,
     tangent_3 : vec3<f32>,
     loss_0 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S143 : vec3<f32>;
    if((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0f)
    {
        _S143 = (vec3<f32>(0) - hair_0.tangent_0);
    }
    else
    {
        _S143 = hair_0.tangent_0;
    }
    var blended_0 : YarnFrame_0;
    var _S144 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S145 : vec3<f32> = normalize(mix(frame_0.normal_4, hair_0.normal_1, _S144));
    blended_0.normal_4 = _S145;
    var _S146 : vec3<f32> = mix(frame_0.tangent_3, _S143, _S144);
    var _S147 : vec3<f32> = _S146 - vec3<f32>(dot(_S146, _S145)) * _S145;
    blended_0.tangent_3 = _S147 * vec3<f32>(rsqrt_0(max(dot(_S147, _S147), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_4.z - 1.0f) + 1.0f));
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
    var _S148 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S149 : vec3<f32> = sends_0.sky_warp_0 + _S148 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S149;
    var _S150 : vec3<f32> = sends_0.sky_weft_0 + _S148 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S150;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S149 + vec3<f32>(sends_0.blocks_weft_0) * _S150;
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
     back_5 : vec3<f32>,
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
    var _S151 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S152 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S152 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S152 * interior_0.far_1 + yarn_2.back_5 * _S151;
    return bounced_0;
}

fn tinted_0( albedos_1 : Albedos_0,  tint_0 : vec3<f32>) -> Albedos_0
{
    var result_0 : Albedos_0 = albedos_1;
    result_0.diffuse_reflect_0 = result_0.diffuse_reflect_0 * tint_0;
    result_0.diffuse_transmit_0 = result_0.diffuse_transmit_0 * tint_0;
    return result_0;
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
        var _S153 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S153)) <= number_0)
        {
            low_0 = _S153;
        }
        else
        {
            high_0 = _S153;
        }
    }
    var _S154 : u32 = table_0 + low_0;
    var _S155 : f32 = scene_number_0(_S154);
    var _S156 : f32 = scene_number_0(_S154 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S155) / max(_S156 - _S155, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_5 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S157 : f32 = light_1.z;
    if(_S157 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S157, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S158 : f32 = dot(direction_3, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S158 * _S158 + 1.0f, roughness_1 * roughness_1));
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
    var _S159 : f32 = roughness_2 * roughness_2;
    var _S160 : f32 = squared_along_0 * (1.0f - _S159) + _S159;
    return 0.31830987334251404f * _S159 * roughness_2 / (_S160 * _S160);
}

fn density_between_0( light_2 : vec3<f32>,  view_2 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S161 : vec3<f32> = light_2 + view_2;
    var _S162 : f32 = dot(_S161, tangent_5);
    return flake_density_0(min(_S162 * _S162 / max(square_0(_S161), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_3 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S163 : f32 = dot(light_3, normal_6);
    var _S164 : bool;
    if(_S163 <= 0.0f)
    {
        _S164 = true;
    }
    else
    {
        _S164 = (dot(view_3, normal_6)) <= 0.0f;
    }
    if(_S164)
    {
        return 0.0f;
    }
    var _S165 : f32 = max(_S163, 9.99999997475242708e-07f);
    var _S166 : f32 = max(dot(view_3, normal_6), 9.99999997475242708e-07f);
    var _S167 : f32 = projected_area_1(light_3, tangent_6, roughness_4) * _S166 + projected_area_1(view_3, tangent_6, roughness_4) * _S165;
    var _S168 : f32 = optical_depth_1 * _S167 / (_S165 * _S166);
    return 0.25f * density_between_0(light_3, view_3, tangent_6, roughness_4) * (_S168 * mean_attenuation_0(_S168)) * _S165 / _S167;
}

fn transmission_1( light_4 : vec3<f32>,  view_4 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S169 : f32 = - dot(light_4, normal_7);
    var _S170 : f32 = dot(view_4, normal_7);
    var _S171 : bool;
    if(_S169 <= 0.0f)
    {
        _S171 = true;
    }
    else
    {
        _S171 = _S170 <= 0.0f;
    }
    if(_S171)
    {
        return 0.0f;
    }
    var _S172 : f32 = 1.0f / max(_S170, 9.99999997475242708e-07f);
    var _S173 : f32 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S169, 9.99999997475242708e-07f);
    var _S174 : f32 = projected_area_1(view_4, tangent_7, roughness_5) * _S172;
    return density_between_0(light_4, view_4, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S173, _S174)) * mean_attenuation_0(optical_depth_2 * abs(_S173 - _S174)) * _S172;
}

fn sheen_scale_0( x_9 : f32,  y_2 : f32) -> f32
{
    return (((((0.0f * x_9 + (((((-1.1402510404586792f * y_2 + 0.40672621130943298f) * y_2 + 1.65398800373077393f) * y_2 + -1.29730904102325439f) * y_2 + 0.30570998787879944f) * y_2 + -0.0220868494361639f)) * x_9 + (((((-0.21142719686031342f * y_2 + 1.05947399139404297f) * y_2 + -0.41116121411323547f) * y_2 + -0.93859231472015381f) * y_2 + 0.51606941223144531f) * y_2 + 0.05409301072359085f)) * x_9 + (((((1.22944498062133789f * y_2 + -0.45962560176849365f) * y_2 + -1.63861405849456787f) * y_2 + 1.33565104007720947f) * y_2 + -0.45725581049919128f) * y_2 + 0.08243165910243988f)) * x_9 + (((((0.39779931306838989f * y_2 + -1.18879103660583496f) * y_2 + 0.28251591324806213f) * y_2 + 1.168984055519104f) * y_2 + -0.76864629983901978f) * y_2 + 0.0091691892594099f)) * x_9 + (((((-0.26563560962677002f * y_2 + -0.19379159808158875f) * y_2 + 0.2677634060382843f) * y_2 + 0.00270519289188087f) * y_2 + 0.14349560439586639f) * y_2 + 0.10290180146694183f)) * x_9 + (((((-0.20701569318771362f * y_2 + 0.24526430666446686f) * y_2 + 0.19551840424537659f) * y_2 + 0.07586126774549484f) * y_2 + 0.38894739747047424f) * y_2 + 0.15043120086193085f);
}

fn sheen_shear_0( x_10 : f32,  y_3 : f32) -> f32
{
    return ((((0.0f * x_10 + (((((-0.10608240216970444f * y_3 + 1.99214303493499756f) * y_3 + -1.42255294322967529f) * y_3 + -1.09495604038238525f) * y_3 + 0.59180057048797607f) * y_3 + 0.06902855634689331f)) * x_10 + (((((-0.46220690011978149f * y_3 + -0.29113379120826721f) * y_3 + 1.39025199413299561f) * y_3 + 0.35589990019798279f) * y_3 + -1.17120099067687988f) * y_3 + 0.15940259397029877f)) * x_10 + (((((2.26068711280822754f * y_3 + -3.64728999137878418f) * y_3 + -0.72173482179641724f) * y_3 + 3.07659196853637695f) * y_3 + -0.6827620267868042f) * y_3 + -0.3039557933807373f)) * x_10 + (((((0.81201767921447754f * y_3 + 0.36014080047607422f) * y_3 + -1.72646903991699219f) * y_3 + -0.22630110383033752f) * y_3 + 0.89514690637588501f) * y_3 + -0.10397960245609283f)) * x_10 + (((((-0.37648698687553406f * y_3 + 1.10974001884460449f) * y_3 + 0.17824520170688629f) * y_3 + -1.04968702793121338f) * y_3 + 0.1461234986782074f) * y_3 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_11 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((12.95646953582763672f * y_4 + -21.38032913208007812f) * y_4 + -7.37853097915649414f) * y_4 + 34.55607986450195312f) * y_4 + -23.61347007751464844f) * y_4 + 5.00126314163208008f)) * x_11 + (((((10.91487026214599609f * y_4 + -6.08202791213989258f) * y_4 + -38.2036285400390625f) * y_4 + 53.3440399169921875f) * y_4 + -21.91996002197265625f) * y_4 + 2.01606011390686035f)) * x_11 + (((((-14.52206039428710938f * y_4 + 36.803619384765625f) * y_4 + -22.94047927856445312f) * y_4 + -10.07973003387451172f) * y_4 + 15.77003955841064453f) * y_4 + -4.92722177505493164f)) * x_11 + (((((-7.62505722045898438f * y_4 + 1.27310299873352051f) * y_4 + 31.19523048400878906f) * y_4 + -44.39989852905273438f) * y_4 + 26.44947052001953125f) * y_4 + -8.73507976531982422f)) * x_11 + (((((5.65633487701416016f * y_4 + -17.66820907592773438f) * y_4 + 24.65356063842773438f) * y_4 + -19.38941001892089844f) * y_4 + 11.06159019470214844f) * y_4 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_6 : f32) -> vec3<f32>
{
    var _S175 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S176 : f32 = 2.0f * sqrt(_S175) - 1.0f;
    var _S177 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S176, _S177), 0.00999999977648258f, 1.0f), clamp((1.0f - _S175) * sheen_shear_0(_S176, _S177), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S176, _S177), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_5 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S178 : f32 = light_5.z;
    var _S179 : bool;
    if(_S178 <= 0.0f)
    {
        _S179 = true;
    }
    else
    {
        _S179 = (view_5.z) <= 0.0f;
    }
    if(_S179)
    {
        return 0.0f;
    }
    var _S180 : vec2<f32> = view_5.xy;
    var _S181 : f32 = dot(_S180, _S180);
    var _S182 : vec2<f32>;
    if(_S181 > 9.99999968265522539e-21f)
    {
        _S182 = _S180 * vec2<f32>(rsqrt_0(_S181));
    }
    else
    {
        _S182 = vec2<f32>(1.0f, 0.0f);
    }
    var _S183 : f32 = scale_0 * dot(light_5.xy, _S182) + shear_0 * _S178;
    var _S184 : f32 = scale_0 * (light_5.y * _S182.x - light_5.x * _S182.y);
    var _S185 : f32 = _S183 * _S183 + _S184 * _S184 + _S178 * _S178;
    return 0.31830987334251404f * scale_0 * scale_0 * _S178 / max(_S185 * _S185, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_6 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S186 : vec3<f32> = sheen_lobe_0(view_6.z, roughness_7);
    var _S187 : f32 = strength_0 * _S186.z;
    return vec2<f32>(_S187 * transformed_cosine_0(light_6, view_6, _S186.x, _S186.y), 1.0f - _S187);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_7 : vec3<f32>) -> vec3<f32>
{
    var _S188 : f32 = light_7.z;
    var _S189 : vec3<f32>;
    if((_S188 * view_7.z) < 0.0f)
    {
        _S189 = bounced_1.transmitted_0;
    }
    else
    {
        _S189 = bounced_1.reflected_0;
    }
    return _S189 * vec3<f32>((abs(_S188) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S190 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S190 * (1.0f - light_8.w);
    return;
}

fn camera_right_0( _S191 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S191].right_x_0, frames_0[_S191].right_y_0, frames_0[_S191].right_z_0);
}

fn camera_up_0( _S192 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S192].up_x_0, frames_0[_S192].up_y_0, frames_0[_S192].up_z_0);
}

fn camera_forward_0( _S193 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S193].forward_x_0, frames_0[_S193].forward_y_0, frames_0[_S193].forward_z_0);
}

fn camera_origin_0( _S194 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S194].origin_x_0, frames_0[_S194].origin_y_0, frames_0[_S194].origin_z_0);
}

fn face_point_0( _S195 : u32,  _S196 : u32,  _S197 : f32,  _S198 : f32) -> VisiblePoint_0
{
    var _S199 : u32 = u32(3) * _S196;
    var _S200 : Vertex_std430_0 = vertices_0[corners_0[_S199]];
    var _S201 : Vertex_std430_0 = vertices_0[corners_0[_S199 + u32(1)]];
    var _S202 : Vertex_std430_0 = vertices_0[corners_0[_S199 + u32(2)]];
    var _S203 : vec3<f32> = position_of_0(&(_S201));
    var _S204 : vec3<f32> = position_of_0(&(_S200));
    var _S205 : vec3<f32> = _S203 - _S204;
    var _S206 : vec3<f32> = position_of_0(&(_S202));
    var _S207 : vec3<f32> = _S206 - _S204;
    var _S208 : f32 = _S200.u_0;
    var _S209 : f32 = _S201.u_0 - _S200.u_0;
    var _S210 : f32 = _S200.v_0;
    var _S211 : f32 = _S201.v_0 - _S200.v_0;
    var _S212 : vec2<f32> = vec2<f32>(_S209, _S211);
    var _S213 : f32 = _S202.u_0 - _S200.u_0;
    var _S214 : f32 = _S202.v_0 - _S200.v_0;
    var _S215 : vec2<f32> = vec2<f32>(_S213, _S214);
    var _S216 : f32;
    if((_S209 * _S214 - _S211 * _S213) < 0.0f)
    {
        _S216 = -1.0f;
    }
    else
    {
        _S216 = 1.0f;
    }
    var _S217 : vec3<f32> = vec3<f32>(_S216) * (vec3<f32>(_S214) * _S205 - vec3<f32>(_S211) * _S207);
    var _S218 : vec3<f32> = vec3<f32>(_S216) * (vec3<f32>(_S209) * _S207 - vec3<f32>(_S213) * _S205);
    var point_2 : VisiblePoint_0;
    var _S219 : f32 = 1.0f - _S197 - _S198;
    var _S220 : vec3<f32> = normal_of_0(&(_S200));
    var _S221 : vec3<f32> = vec3<f32>(_S219) * _S220;
    var _S222 : vec3<f32> = normal_of_0(&(_S201));
    var _S223 : vec3<f32> = vec3<f32>(_S197);
    var _S224 : vec3<f32> = _S221 + _S223 * _S222;
    var _S225 : vec3<f32> = normal_of_0(&(_S202));
    var _S226 : vec3<f32> = vec3<f32>(_S198);
    var _S227 : vec3<f32> = normalize(_S224 + _S226 * _S225);
    point_2.normal_0 = _S227;
    var _S228 : vec3<f32> = normalize(_S217 - _S227 * vec3<f32>(dot(_S227, _S217)));
    point_2.axis_x_0 = _S228;
    point_2.axis_y_0 = cross(_S227, _S228);
    var _S229 : vec3<f32> = normalize(cross(_S205, _S207));
    var _S230 : vec3<f32>;
    if((dot(_S229, _S227)) < 0.0f)
    {
        _S230 = (vec3<f32>(0) - _S229);
    }
    else
    {
        _S230 = _S229;
    }
    point_2.face_normal_0 = _S230;
    point_2.position_0 = _S204 + _S223 * _S205 + _S226 * _S207;
    point_2.view_1 = point_2.normal_0;
    point_2.uv_1 = vec2<f32>(_S208, _S210) + vec2<f32>(_S197) * _S212 + vec2<f32>(_S198) * _S215;
    var _S231 : bool = (dot(cross(_S217, _S218), point_2.normal_0)) < 0.0f;
    var _S232 : f32 = fabrics_0[_S195].uv_width_0;
    if(_S231)
    {
        _S216 = - fabrics_0[_S195].uv_height_0;
    }
    else
    {
        _S216 = fabrics_0[_S195].uv_height_0;
    }
    var _S233 : vec2<f32> = vec2<f32>(_S232, _S216);
    point_2.draft_per_uv_0 = _S233;
    var _S234 : vec2<f32> = point_2.uv_1 * _S233;
    if(_S231)
    {
        _S216 = fabrics_0[_S195].uv_height_0;
    }
    else
    {
        _S216 = 0.0f;
    }
    point_2.draft_0 = _S234 + vec2<f32>(0.0f, _S216);
    var _S235 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S235;
    point_2.draft_dy_0 = _S235;
    return point_2;
}

fn visible_point_0( _S236 : i32,  _S237 : u32,  _S238 : u32,  _S239 : vec2<u32>) -> VisiblePoint_0
{
    var _S240 : u32 = u32(3) * _S238;
    var _S241 : Vertex_std430_0 = vertices_0[corners_0[_S240]];
    var _S242 : Vertex_std430_0 = vertices_0[corners_0[_S240 + u32(1)]];
    var _S243 : Vertex_std430_0 = vertices_0[corners_0[_S240 + u32(2)]];
    var _S244 : vec3<f32> = position_of_1(&(_S242));
    var _S245 : vec3<f32> = position_of_1(&(_S241));
    var _S246 : vec3<f32> = _S244 - _S245;
    var _S247 : vec3<f32> = position_of_1(&(_S243));
    var _S248 : vec3<f32> = _S247 - _S245;
    var _S249 : vec3<f32> = cross(_S246, _S248);
    var _S250 : f32 = 1.0f / max(square_0(_S249), 1.00000000317107685e-30f);
    var _S251 : f32 = f32(frames_0[_S236].width_0);
    var _S252 : vec3<f32> = camera_right_0(_S236) * vec3<f32>((2.0f / _S251));
    var _S253 : f32 = f32(frames_0[_S236].height_0);
    var _S254 : vec3<f32> = camera_up_0(_S236) * vec3<f32>((-2.0f / _S253));
    var _S255 : vec3<f32> = camera_forward_0(_S236) + vec3<f32>((f32(_S239.x) + 0.5f - 0.5f * _S251)) * _S252 + vec3<f32>((f32(_S239.y) + 0.5f - 0.5f * _S253)) * _S254;
    var _S256 : f32 = dot(_S255, _S249);
    var _S257 : f32;
    if((abs(_S256)) > 1.00000000317107685e-30f)
    {
        _S257 = _S256;
    }
    else
    {
        _S257 = 1.00000000317107685e-30f;
    }
    var _S258 : f32 = 1.0f / _S257;
    var _S259 : vec3<f32> = _S245 - camera_origin_0(_S236);
    var _S260 : vec3<f32> = vec3<f32>((dot(_S259, _S249) * _S258));
    var _S261 : vec3<f32> = _S255 * _S260 - _S259;
    var _S262 : vec3<f32> = _S260 * (_S252 - _S255 * vec3<f32>((dot(_S252, _S249) * _S258)));
    var _S263 : vec3<f32> = _S260 * (_S254 - _S255 * vec3<f32>((dot(_S254, _S249) * _S258)));
    var _S264 : vec3<f32> = vec3<f32>(_S250);
    var _S265 : vec3<f32> = cross(_S248, _S249) * _S264;
    var _S266 : vec3<f32> = cross(_S249, _S246) * _S264;
    var _S267 : vec2<f32> = vec2<f32>(_S242.u_0 - _S241.u_0, _S242.v_0 - _S241.v_0);
    var _S268 : vec2<f32> = vec2<f32>(_S243.u_0 - _S241.u_0, _S243.v_0 - _S241.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S237, _S238, dot(_S261, _S265), dot(_S261, _S266));
    point_3.position_0 = _S245 + _S261;
    point_3.view_1 = (vec3<f32>(0) - normalize(_S255));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S262, _S265)) * _S267 + vec2<f32>(dot(_S262, _S266)) * _S268) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S263, _S265)) * _S267 + vec2<f32>(dot(_S263, _S266)) * _S268) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S269 : u32,  _S270 : VisiblePoint_0) -> vec3<f32>
{
    var _S271 : u32 = fabrics_0[_S269].albedo_map_levels_0;
    if((fabrics_0[_S269].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S272 : vec2<f32> = vec2<f32>(fabrics_0[_S269].uv_width_0, fabrics_0[_S269].uv_height_0);
    var _S273 : vec2<f32> = _S270.draft_dx_0 / _S272;
    var _S274 : vec2<f32> = _S270.draft_dy_0 / _S272;
    var _S275 : u32 = _S271 - u32(1);
    var _S276 : u32 = (u32(1) << (_S275));
    var _S277 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S273.x * _S274.y - _S273.y * _S274.x), 9.99999968265522539e-21f) * (square_1(f32(_S276)) / 3.0f)), 0.0f, f32(_S271) - 1.0f);
    var _S278 : u32 = min(u32(_S277), max(_S271, u32(2)) - u32(2));
    var _S279 : u32 = min(_S278 + u32(1), _S275);
    var _S280 : u32 = (u32(1) << ((u32(2) * _S271)));
    return mix(map_level_0(fabrics_0[_S269].albedo_map_0 + (_S280 - ((_S280 >> ((u32(2) * _S278))))) / u32(3), (_S276 >> (_S278)), _S270.uv_1), map_level_0(fabrics_0[_S269].albedo_map_0 + (_S280 - ((_S280 >> ((u32(2) * _S279))))) / u32(3), (_S276 >> (_S279)), _S270.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S277 - f32(_S278))) - 1.0f) / 3.0f)));
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_3 : bool,
     is_warp_2 : bool,
     x_12 : f32,
     y_5 : f32,
     height_5 : f32,
     normal_8 : vec3<f32>,
     tangent_8 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_8 : f32,
     albedos_2 : Albedos_0,
};

struct Hit_0
{
     x_13 : f32,
     y_6 : f32,
     hole_4 : bool,
     height_6 : f32,
};

struct Sample_0
{
     crossing_1 : Crossing_0,
     shown_3 : Shown_0,
     run_3 : Run_0,
     section_1 : Section_0,
     height_7 : f32,
     slope_across_0 : f32,
     slope_along_0 : f32,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S281 : u32,  _S282 : f32,  _S283 : f32,  _S284 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S281].warp_0, _S282);
    crossing_2.weft_1 = locate_0(fabrics_0[_S281].weft_0, _S283);
    var _S285 : u32 = fabrics_0[_S281].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S281].ends_1 + crossing_2.warp_1.thread_2);
    var _S286 : u32 = words_0[_S285];
    crossing_2.warp_word_0 = _S286;
    crossing_2.weft_word_0 = words_0[_S285 + u32(1)];
    crossing_2.warp_above_0 = (((_S286 & (u32(1)))) == u32(1)) != _S284;
    return crossing_2;
}

fn sample_at_0( _S287 : u32,  _S288 : f32,  _S289 : f32,  _S290 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S291 : Crossing_0 = crossing_at_0(_S287, _S288, _S289, _S290);
    sample_0.crossing_1 = _S291;
    var _S292 : Shown_0 = shown_at_0(_S291, _S290);
    sample_0.shown_3 = _S292;
    var _S293 : u32;
    if(_S292.is_warp_0)
    {
        _S293 = fabrics_0[_S287].warp_0;
    }
    else
    {
        _S293 = fabrics_0[_S287].weft_0;
    }
    var _S294 : u32;
    if(_S292.is_warp_0)
    {
        _S294 = fabrics_0[_S287].weft_0;
    }
    else
    {
        _S294 = fabrics_0[_S287].warp_0;
    }
    var _S295 : Cell_0 = select_cell_0(_S292.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S296 : Cell_0 = select_cell_0(_S292.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S297 : Run_0 = unpack_0(_S293, _S294, _S295.thread_2, _S296, _S292.word_0);
    var _S298 : Section_0 = section_at_0(_S295);
    var _S299 : bool;
    if(_S292.on_top_0)
    {
        _S299 = (_S297.distance_0) < (_S298.drop_0 * _S297.bend_1.sine_0);
    }
    else
    {
        _S299 = false;
    }
    var _S300 : bool;
    if(_S292.on_top_0)
    {
        _S300 = !_S299;
    }
    else
    {
        _S300 = false;
    }
    var _S301 : f32;
    if(_S300)
    {
        _S301 = 1.0f;
    }
    else
    {
        _S301 = -1.0f;
    }
    var _S302 : f32;
    if(_S299)
    {
        _S302 = _S297.other_reach_0;
    }
    else
    {
        _S302 = _S297.reach_0;
    }
    var _S303 : f32;
    if(_S299)
    {
        _S303 = _S302 + _S297.distance_0;
    }
    else
    {
        _S303 = max(_S302 - _S297.distance_0, 0.0f);
    }
    var _S304 : f32 = _S302 / _S297.bend_1.sine_0 - _S301 * _S298.drop_0;
    var _S305 : f32 = _S303 * _S303;
    var _S306 : f32 = max(_S304 * _S304 - _S305, 9.99999968265522539e-21f);
    var _S307 : f32 = rsqrt_0(_S306);
    var _S308 : f32 = _S305 / (_S306 * _S307 + _S304);
    var _S309 : bool = _S303 > 0.0f;
    var _S310 : f32;
    if(_S292.on_top_0)
    {
        _S310 = 1.0f;
    }
    else
    {
        _S310 = -1.0f;
    }
    var _S311 : f32;
    if(_S297.near_start_0)
    {
        _S311 = 1.0f;
    }
    else
    {
        _S311 = -1.0f;
    }
    var _S312 : f32 = _S310 * _S311;
    if(_S309)
    {
        _S310 = _S304 * _S307;
    }
    else
    {
        _S310 = 1.0f;
    }
    sample_0.slope_across_0 = _S298.slope_0 * _S310;
    if(_S309)
    {
        _S303 = _S312 * _S303 * _S307;
    }
    else
    {
        _S303 = 0.0f;
    }
    sample_0.slope_along_0 = _S303;
    var _S313 : f32 = families_0[_S293].height_scale_0;
    var _S314 : vec2<f32> = dive_0(_S294, _S292, _S297, _S296);
    if(_S297.straight_0)
    {
        _S301 = 0.0f;
    }
    else
    {
        _S301 = _S313 * _S301;
    }
    sample_0.height_7 = _S301 * (_S302 * _S297.bend_1.half_tangent_0 - _S308) - _S313 * _S298.drop_0 - _S314.x;
    var _S315 : f32 = _S313 * sample_0.slope_across_0;
    var _S316 : f32 = _S313 * sample_0.slope_along_0 - _S314.y;
    if(_S292.is_warp_0)
    {
        _S301 = _S315;
    }
    else
    {
        _S301 = _S316;
    }
    sample_0.slope_x_1 = _S301;
    if(_S292.is_warp_0)
    {
        _S301 = _S316;
    }
    else
    {
        _S301 = _S315;
    }
    sample_0.slope_y_1 = _S301;
    sample_0.run_3 = _S297;
    sample_0.section_1 = _S298;
    return sample_0;
}

fn steps_per_length_0( _S317 : u32,  _S318 : SearchQuality_0,  _S319 : vec3<f32>) -> f32
{
    return max(max(abs(_S319.x) * fabrics_0[_S317].threads_per_x_0, abs(_S319.y) * fabrics_0[_S317].threads_per_y_0) * _S318.steps_per_thread_0, abs(_S319.z) * fabrics_0[_S317].per_relief_0 * _S318.steps_per_relief_0);
}

fn cell_maximum_0( _S320 : u32,  _S321 : Crossing_0) -> f32
{
    var _S322 : u32;
    if(_S321.warp_above_0)
    {
        _S322 = fabrics_0[_S320].warp_0;
    }
    else
    {
        _S322 = fabrics_0[_S320].weft_0;
    }
    var _S323 : u32;
    if(_S321.warp_above_0)
    {
        _S323 = _S321.warp_word_0;
    }
    else
    {
        _S323 = _S321.weft_word_0;
    }
    return f32((_S323 >> (u32(28)))) * families_0[_S322].height_scale_0 * families_0[_S322].level_0;
}

fn probe_0( _S324 : u32,  _S325 : f32,  _S326 : f32,  _S327 : bool,  _S328 : bool,  _S329 : bool) -> Probe_0
{
    var _S330 : Sample_0 = sample_at_0(_S324, _S325, _S326, _S327);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S330.height_7;
    probe_1.hole_1 = _S330.shown_3.hole_0;
    probe_1.slope_x_0 = _S330.slope_x_1;
    probe_1.slope_y_0 = _S330.slope_y_1;
    var _S331 : u32;
    if(_S330.shown_3.is_warp_0)
    {
        _S331 = _S330.crossing_1.warp_1.thread_2 * u32(2) + u32(1);
    }
    else
    {
        _S331 = _S330.crossing_1.weft_1.thread_2 * u32(2);
    }
    probe_1.yarn_1 = _S331;
    probe_1.cell_max_0 = cell_maximum_0(_S324, _S330.crossing_1);
    var _S332 : f32;
    if(_S328)
    {
        _S332 = _S330.crossing_1.warp_1.above_0;
    }
    else
    {
        _S332 = _S330.crossing_1.warp_1.below_0;
    }
    probe_1.side_x_0 = _S332;
    if(_S329)
    {
        _S332 = _S330.crossing_1.weft_1.above_0;
    }
    else
    {
        _S332 = _S330.crossing_1.weft_1.below_0;
    }
    probe_1.side_y_0 = _S332;
    probe_1.edge_x_0 = outline_distance_0(_S330.crossing_1.warp_1, _S330.shown_3, _S330.run_3, !_S330.shown_3.is_warp_0, _S328);
    probe_1.edge_y_0 = outline_distance_0(_S330.crossing_1.weft_1, _S330.shown_3, _S330.run_3, _S330.shown_3.is_warp_0, _S329);
    return probe_1;
}

fn is_free_0( _S333 : u32,  _S334 : SearchQuality_0,  _S335 : vec3<f32>,  _S336 : vec3<f32>,  _S337 : bool,  _S338 : f32) -> bool
{
    var _S339 : f32 = _S336.z;
    if(_S339 <= 0.0f)
    {
        return false;
    }
    var _S340 : f32 = 1.0f / max(_S334.shadow_share_0 * steps_per_length_0(_S333, _S334, _S336), 9.99999971718068537e-10f);
    var _S341 : StepControl_0 = step_control_0(_S336.xy, _S340);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        var _S342 : bool;
        if(count_2 < u32(1024))
        {
            _S342 = (_S335.z + _S339 * distance_1) < _S338;
        }
        else
        {
            _S342 = false;
        }
        if(_S342)
        {
        }
        else
        {
            break;
        }
        var _S343 : vec3<f32> = _S335 + _S336 * vec3<f32>(distance_1);
        var _S344 : Probe_0 = probe_0(_S333, _S343.x, _S343.y, _S337, _S341.right_0, _S341.up_0);
        var _S345 : f32 = _S343.z;
        var _S346 : f32 = _S345 - _S344.height_2;
        var _S347 : f32 = _S339 - _S344.slope_x_0 * _S336.x - _S344.slope_y_0 * _S336.y;
        var _S348 : bool;
        if(!_S344.hole_1)
        {
            _S348 = _S346 < 0.0f;
        }
        else
        {
            _S348 = false;
        }
        if(_S348)
        {
            return false;
        }
        var _S349 : f32 = way_back_to_dip_0(previous_3, _S346, _S347, last_step_0, _S344);
        if(_S349 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S349;
            distance_1 = distance_1 - _S349;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S350 : bool = _S345 > (_S344.cell_max_0);
        var _S351 : PreviousSample_0 = after_sample_0(_S346, _S347, _S344, _S350);
        var last_step_2 : f32;
        if(_S350)
        {
            last_step_2 = max(StepControl_to_cell_exit_0(_S341, _S344.side_x_0, _S344.side_y_0), _S340);
        }
        else
        {
            last_step_2 = StepControl_to_next_sample_0(_S341, _S344, _S346, _S347);
        }
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = _S351;
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S352 : u32,  _S353 : SearchQuality_0,  _S354 : f32,  _S355 : f32,  _S356 : vec3<f32>,  _S357 : bool) -> bool
{
    if(!sample_at_0(_S352, _S354, _S355, _S357).shown_3.hole_0)
    {
        return false;
    }
    var _S358 : vec3<f32> = vec3<f32>(_S354, _S355, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        var _S359 : bool;
        if(side_1 < u32(2))
        {
            _S359 = passes_0;
        }
        else
        {
            _S359 = false;
        }
        if(_S359)
        {
        }
        else
        {
            break;
        }
        var _S360 : vec3<f32>;
        if(side_1 == u32(0))
        {
            _S360 = _S356;
        }
        else
        {
            _S360 = vec3<f32>(- _S356.x, - _S356.y, _S356.z);
        }
        var _S361 : bool = is_free_0(_S352, _S353, _S358, _S360, _S357 != (side_1 == u32(1)), fabrics_0[_S352].height_high_0);
        var _S362 : u32 = side_1 + u32(1);
        passes_0 = _S361;
        side_1 = _S362;
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

fn max_height_along_0( _S363 : u32,  _S364 : f32,  _S365 : f32,  _S366 : f32,  _S367 : vec3<f32>,  _S368 : bool) -> f32
{
    var _S369 : u32 = locate_0(fabrics_0[_S363].warp_0, _S364).thread_2 / u32(2);
    var _S370 : u32 = locate_0(fabrics_0[_S363].weft_0, _S365).thread_2 / u32(2);
    var _S371 : f32 = _S367.x;
    var _S372 : u32;
    if(_S371 > 0.0f)
    {
        _S372 = u32(1);
    }
    else
    {
        _S372 = u32(0);
    }
    var _S373 : f32 = _S367.y;
    var _S374 : u32;
    if(_S373 > 0.0f)
    {
        _S374 = u32(2);
    }
    else
    {
        _S374 = u32(0);
    }
    var _S375 : u32 = words_0[fabrics_0[_S363].max_heights_0 + u32(4) * (_S370 * fabrics_0[_S363].max_height_columns_0 + _S369) + (_S372 + _S374)];
    var number_1 : i32;
    if(_S368)
    {
        number_1 = i32(4);
    }
    else
    {
        number_1 = i32(0);
    }
    var _S376 : u32 = (_S375 >> (u32(number_1)));
    var _S377 : f32 = max(abs(_S371) * fabrics_0[_S363].threads_per_x_0, abs(_S373) * fabrics_0[_S363].threads_per_y_0) / _S367.z;
    var _S378 : f32 = fabrics_0[_S363].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S363].height_high_0;
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
        if(((max_height_0 - _S366) * _S377) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S376 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S378);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S379 : u32,  _S380 : f32,  _S381 : f32,  _S382 : bool,  _S383 : bool,  _S384 : bool) -> vec3<f32>
{
    var _S385 : Crossing_0 = crossing_at_0(_S379, _S380, _S381, _S382);
    var _S386 : f32 = cell_maximum_0(_S379, _S385);
    var _S387 : f32;
    if(_S383)
    {
        _S387 = _S385.warp_1.above_0;
    }
    else
    {
        _S387 = _S385.warp_1.below_0;
    }
    var _S388 : f32;
    if(_S384)
    {
        _S388 = _S385.weft_1.above_0;
    }
    else
    {
        _S388 = _S385.weft_1.below_0;
    }
    return vec3<f32>(_S386, _S387, _S388);
}

fn first_sample_height_0( _S389 : u32,  _S390 : ViewRay_0,  _S391 : StepControl_0,  _S392 : bool) -> f32
{
    var _S393 : f32 = max_height_along_0(_S389, _S390.origin_0.x, _S390.origin_0.y, 0.0f, vec3<f32>(_S390.slope_1, 1.0f), _S392);
    var count_3 : u32 = u32(0);
    var height_9 : f32 = _S393;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S394 : vec2<f32> = ViewRay_at_0(_S390, height_9);
        var _S395 : vec3<f32> = cell_bounds_0(_S389, _S394.x, _S394.y, _S392, _S391.right_0, _S391.up_0);
        var _S396 : f32 = height_9 - _S395.x;
        var _S397 : f32 = StepControl_to_cell_exit_0(_S391, _S395.y, _S395.z);
        var height_10 : f32 = height_9 - clamp(_S396, 0.0f, _S397);
        if(_S396 <= _S397)
        {
            height_9 = height_10;
            break;
        }
        count_3 = count_3 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S398 : u32,  _S399 : ViewRay_0,  _S400 : StepControl_0,  _S401 : bool) -> ViewRayEnd_0
{
    var _S402 : f32 = fabrics_0[_S398].height_low_0 - (fabrics_0[_S398].height_high_0 - fabrics_0[_S398].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S398, _S399, _S400, _S401);
    end_1.last_step_3 = _S400.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_1 = 0.0f;
    end_1.rate_4 = 0.0f;
    end_1.smooth_0 = false;
    var count_4 : u32 = u32(0);
    for(;;)
    {
        if(count_4 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S403 : vec2<f32> = ViewRay_at_0(_S399, end_1.height_8);
        var _S404 : Probe_0 = probe_0(_S398, _S403.x, _S403.y, _S401, _S400.right_0, _S400.up_0);
        var _S405 : f32 = end_1.height_8 - _S404.height_2;
        var _S406 : f32 = ViewRay_rate_0(_S399, _S404);
        end_1.depth_1 = - _S405;
        end_1.rate_4 = _S406;
        var _S407 : bool;
        if(end_1.previous_4.known_0)
        {
            _S407 = !_S404.hole_1;
        }
        else
        {
            _S407 = false;
        }
        var _S408 : bool;
        if(_S407)
        {
            _S408 = (end_1.previous_4.yarn_0) == (_S404.yarn_1);
        }
        else
        {
            _S408 = false;
        }
        end_1.smooth_0 = _S408;
        var _S409 : bool;
        if(!_S404.hole_1)
        {
            _S409 = _S405 <= 0.0f;
        }
        else
        {
            _S409 = false;
        }
        var _S410 : bool;
        if(_S409)
        {
            _S410 = true;
        }
        else
        {
            _S410 = (end_1.height_8) <= _S402;
        }
        if(_S410)
        {
            break;
        }
        var _S411 : f32 = way_back_to_dip_0(end_1.previous_4, _S405, _S406, end_1.last_step_3, _S404);
        if(_S411 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S411;
            end_1.last_step_3 = end_1.last_step_3 - _S411;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S412 : f32 = min(StepControl_to_cell_exit_0(_S400, _S404.side_x_0, _S404.side_y_0), end_1.height_8 - _S404.cell_max_0);
        var _S413 : f32 = StepControl_to_next_sample_0(_S400, _S404, _S405, _S406);
        end_1.previous_4 = after_sample_0(_S405, _S406, _S404, _S412 > _S413);
        var _S414 : f32 = max(_S412, _S413);
        end_1.last_step_3 = _S414;
        end_1.height_8 = end_1.height_8 - _S414;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S415 : u32,  _S416 : ViewRay_0,  _S417 : StepControl_0,  _S418 : bool,  _S419 : ViewRayEnd_0,  _S420 : u32) -> f32
{
    var _S421 : f32 = fabrics_0[_S415].height_high_0 - fabrics_0[_S415].height_low_0;
    var above_2 : f32 = _S419.height_8 + _S419.last_step_3;
    var above_gap_1 : f32 = clamp(_S419.previous_4.clearance_0, 0.0f, _S421);
    var under_gap_1 : f32 = clamp(_S419.depth_1, 0.0f, _S421);
    var _S422 : f32 = cubic_root_0(above_gap_1, - under_gap_1, _S419.previous_4.rate_0 * _S419.last_step_3, _S419.rate_4 * _S419.last_step_3);
    var middle_0 : f32;
    if(_S419.smooth_0)
    {
        middle_0 = above_2 - _S422 * _S419.last_step_3;
    }
    else
    {
        middle_0 = between_0(above_2, _S419.height_8, above_gap_1, under_gap_1);
    }
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S419.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S420)
        {
        }
        else
        {
            break;
        }
        var _S423 : vec2<f32> = ViewRay_at_0(_S416, middle_0);
        var _S424 : Probe_0 = probe_0(_S415, _S423.x, _S423.y, _S418, _S417.right_0, _S417.up_0);
        var _S425 : f32;
        if(_S424.hole_1)
        {
            _S425 = -1.0e+09f;
        }
        else
        {
            _S425 = _S424.height_2;
        }
        var _S426 : f32 = clamp(middle_0 - _S425, - _S421, _S421);
        var _S427 : f32;
        if(_S426 <= 0.0f)
        {
            if(side_2 > 0.0f)
            {
                _S427 = 0.5f * above_gap_2;
            }
            else
            {
                _S427 = above_gap_2;
            }
            var _S428 : f32 = - _S426;
            under_1 = middle_0;
            above_gap_2 = _S427;
            under_gap_2 = _S428;
            side_2 = 1.0f;
        }
        else
        {
            if(side_2 < 0.0f)
            {
                _S427 = 0.5f * under_gap_2;
            }
            else
            {
                _S427 = under_gap_2;
            }
            above_3 = middle_0;
            above_gap_2 = _S426;
            under_gap_2 = _S427;
            side_2 = -1.0f;
        }
        if(_S419.smooth_0)
        {
            middle_0 = clamp(middle_0 + _S426 / min(ViewRay_rate_0(_S416, _S424), -9.99999997475242708e-07f), under_1, above_3);
        }
        else
        {
            middle_0 = between_0(above_3, under_1, above_gap_2, under_gap_2);
        }
        i_1 = i_1 + u32(1);
    }
    if(_S419.smooth_0)
    {
    }
    else
    {
        middle_0 = under_1;
    }
    return middle_0;
}

fn first_hit_of_yarn_0( _S429 : u32,  _S430 : SearchQuality_0,  _S431 : f32,  _S432 : f32,  _S433 : vec3<f32>,  _S434 : bool) -> Hit_0
{
    var _S435 : f32 = max(_S433.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S431, _S432);
    var _S436 : vec2<f32> = _S433.xy / vec2<f32>(_S435);
    ray_0.slope_1 = _S436;
    var _S437 : StepControl_0 = step_control_0((vec2<f32>(0) - _S436), 1.0f / max(steps_per_length_0(_S429, _S430, _S433) / _S435, 9.99999971718068537e-10f));
    var _S438 : ViewRayEnd_0 = search_down_0(_S429, ray_0, _S437, _S434);
    var hit_0 : Hit_0;
    hit_0.hole_4 = false;
    var _S439 : f32 = refined_height_0(_S429, ray_0, _S437, _S434, _S438, _S430.refinements_0);
    hit_0.height_6 = _S439;
    var _S440 : vec2<f32> = ViewRay_at_0(ray_0, _S439);
    hit_0.x_13 = _S440.x;
    hit_0.y_6 = _S440.y;
    return hit_0;
}

fn first_hit_0( _S441 : u32,  _S442 : SearchQuality_0,  _S443 : f32,  _S444 : f32,  _S445 : vec3<f32>,  _S446 : bool) -> Hit_0
{
    if(!passes_through_0(_S441, _S442, _S443, _S444, _S445, _S446))
    {
        return first_hit_of_yarn_0(_S441, _S442, _S443, _S444, _S445, _S446);
    }
    var hit_1 : Hit_0;
    hit_1.x_13 = _S443;
    hit_1.y_6 = _S444;
    hit_1.height_6 = 0.0f;
    hit_1.hole_4 = true;
    return hit_1;
}

fn surface_at_0( _S447 : u32,  _S448 : f32,  _S449 : f32,  _S450 : bool) -> SurfacePoint_0
{
    var _S451 : Sample_0 = sample_at_0(_S447, _S448, _S449, _S450);
    var _S452 : f32;
    if(_S451.shown_3.is_warp_0)
    {
        _S452 = _S451.crossing_1.warp_1.half_width_1;
    }
    else
    {
        _S452 = _S451.crossing_1.weft_1.half_width_1;
    }
    var _S453 : u32;
    if(_S451.shown_3.is_warp_0)
    {
        _S453 = fabrics_0[_S447].warp_0;
    }
    else
    {
        _S453 = fabrics_0[_S447].weft_0;
    }
    var _S454 : f32 = families_0[_S453].twist_sine_0;
    var _S455 : f32;
    if(_S450)
    {
        _S455 = -1.0f;
    }
    else
    {
        _S455 = 1.0f;
    }
    var _S456 : f32 = _S454 * _S455;
    var _S457 : f32 = families_0[_S453].twist_cosine_0;
    if(_S451.shown_3.is_warp_0)
    {
        _S455 = 1.0f;
    }
    else
    {
        _S455 = -1.0f;
    }
    var _S458 : vec2<f32> = fibre_direction_0(_S451.slope_across_0, _S455 * _S451.slope_along_0, _S456, _S457);
    var _S459 : f32;
    if(_S451.shown_3.is_warp_0)
    {
        _S459 = _S451.slope_x_1;
    }
    else
    {
        _S459 = _S451.slope_y_1;
    }
    var _S460 : f32;
    if(_S451.shown_3.is_warp_0)
    {
        _S460 = _S451.slope_y_1;
    }
    else
    {
        _S460 = _S451.slope_x_1;
    }
    var _S461 : f32 = _S458.x;
    var _S462 : f32 = _S458.y;
    var _S463 : f32 = _S459 * _S461 + _S455 * _S460 * _S462;
    var _S464 : f32 = _S452 * 1.0154266357421875f;
    var _S465 : f32 = _S464 * arc_sine_0(clamp(_S451.section_1.across_1 / _S464, -1.0f, 1.0f));
    if(_S451.shown_3.is_warp_0)
    {
        _S452 = _S449;
    }
    else
    {
        _S452 = - _S448;
    }
    var point_4 : SurfacePoint_0;
    point_4.hole_2 = _S451.shown_3.hole_0;
    point_4.is_warp_1 = _S451.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S451.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S451.crossing_1.weft_1.thread_2;
    point_4.height_4 = _S451.height_7;
    point_4.normal_3 = normalize(vec3<f32>(- _S451.slope_x_1, - _S451.slope_y_1, 1.0f));
    var _S466 : vec3<f32>;
    if(_S451.shown_3.is_warp_0)
    {
        _S466 = vec3<f32>(_S461, _S462, _S463);
    }
    else
    {
        _S466 = vec3<f32>(- _S462, _S461, _S463);
    }
    point_4.tangent_2 = normalize(_S466);
    point_4.across_3 = _S451.section_1.across_1;
    point_4.fibre_across_0 = _S465 * _S457 + _S452 * _S456;
    point_4.fibre_along_0 = _S452 * _S457 - _S465 * _S456;
    return point_4;
}

fn has_hairs_0( _S467 : u32) -> bool
{
    var _S468 : bool;
    if((families_0[fabrics_0[_S467].warp_0].hairiness_0) > 0.0f)
    {
        _S468 = true;
    }
    else
    {
        _S468 = (families_0[fabrics_0[_S467].weft_0].hairiness_0) > 0.0f;
    }
    return _S468;
}

fn hair_at_0( _S469 : u32,  _S470 : vec2<f32>,  _S471 : bool,  _S472 : f32) -> Hair_0
{
    var _S473 : f32 = fabrics_0[_S469].fibre_size_0;
    var _S474 : f32 = 17.0f * fabrics_0[_S469].fibre_size_0;
    var _S475 : f32 = fade_0(_S472, _S474);
    var _S476 : vec2<f32> = _S470 / vec2<f32>(_S474);
    var number_2 : u32;
    if(_S471)
    {
        number_2 = u32(1);
    }
    else
    {
        number_2 = u32(0);
    }
    var _S477 : u32 = hash_key_0(number_2, ((fabrics_0[_S469].seed_0) ^ (u32(1013904242))));
    var _S478 : f32 = 1.0f / max(_S472, 0.07999999821186066f * _S473);
    var _S479 : f32 = min(0.63999998569488525f * _S473 * _S478, 1.0f);
    const _S480 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S480;
    number_2 = u32(0);
    for(;;)
    {
        var _S481 : bool;
        if(_S475 > 0.0f)
        {
            _S481 = number_2 < u32(18);
        }
        else
        {
            _S481 = false;
        }
        if(_S481)
        {
        }
        else
        {
            break;
        }
        var _S482 : u32 = number_2 / u32(9);
        var _S483 : u32 = number_2 / u32(3) - u32(3) * _S482;
        var _S484 : vec2<f32> = floor(_S476) + vec2<f32>(f32(number_2 - u32(3) * _S483 - u32(9) * _S482), f32(_S483)) - vec2<f32>(1.0f);
        var _S485 : u32 = hash_bits_0(_S477 + _S482, u32(i32(_S484.x)) * u32(65536) + u32(i32(_S484.y)));
        var _S486 : u32 = hash_bits_0(_S477, _S485);
        var _S487 : vec2<f32> = _S476 - _S484 - vec2<f32>(share_of_0(_S485), share_of_0((_S485 >> (u32(10)))));
        var _S488 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S485 >> (u32(20)))));
        var _S489 : f32 = mix(5.0f, 16.0f, share_of_0((_S486 >> (u32(10))))) / 17.0f;
        var _S490 : f32 = _S487.x;
        var _S491 : f32 = _S488.y;
        var _S492 : f32 = _S487.y;
        var _S493 : f32 = _S488.x;
        var _S494 : f32 = (_S490 * _S491 + _S492 * _S493) / _S489;
        var _S495 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S486 >> (u32(20)))) - 1.0f);
        var _S496 : f32 = 2.0f * _S495 * _S494;
        var _S497 : f32 = rsqrt_0(_S496 * _S496 + 1.0f);
        var _S498 : f32 = (_S492 * _S491 - _S490 * _S493 - _S495 * _S489 * _S494 * _S494) * _S497 * 17.0f;
        var _S499 : f32 = clamp((0.31999999284744263f - abs(_S498)) * _S473 * _S478 + 0.5f, 0.0f, _S479);
        var _S500 : u32;
        if(((((_S486 >> (u32(30)))) & (u32(1)))) == u32(1))
        {
            _S500 = fabrics_0[_S469].warp_0;
        }
        else
        {
            _S500 = fabrics_0[_S469].weft_0;
        }
        var _S501 : bool;
        if((share_of_0(_S486)) < (families_0[_S500].hairiness_0))
        {
            _S501 = (abs(_S494)) < 1.0f;
        }
        else
        {
            _S501 = false;
        }
        var _S502 : bool;
        if(_S501)
        {
            _S502 = _S499 > cover_2;
        }
        else
        {
            _S502 = false;
        }
        if(_S502)
        {
            var _S503 : vec2<f32> = vec2<f32>(- _S493 - _S496 * _S491, _S491 - _S496 * _S493) * vec2<f32>(_S497);
            cover_2 = _S499;
            hair_away_0 = _S498;
            hair_across_0 = _S503;
        }
        number_2 = number_2 + u32(1);
    }
    var _S504 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S475 * cover_2;
    hair_1.normal_1 = vec3<f32>(vec2<f32>(_S504) * hair_across_0, sqrt(1.0f - _S504 * _S504));
    hair_1.tangent_0 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S505 : u32,  _S506 : f32) -> bool
{
    var _S507 : bool;
    if((fabrics_0[_S505].fibre_noise_0) > 0.0f)
    {
        _S507 = true;
    }
    else
    {
        _S507 = (fabrics_0[_S505].colour_noise_0) > 0.0f;
    }
    if(_S507)
    {
        _S507 = true;
    }
    else
    {
        if((fabrics_0[_S505].has_detail_0) != u32(0))
        {
            _S507 = _S506 >= 0.0f;
        }
        else
        {
            _S507 = false;
        }
    }
    return _S507;
}

fn thread_number_0( _S508 : u32,  _S509 : SurfacePoint_0,  _S510 : f32,  _S511 : f32) -> u32
{
    var _S512 : f32;
    if(_S509.is_warp_1)
    {
        _S512 = _S510;
    }
    else
    {
        _S512 = _S511;
    }
    var _S513 : f32 = _S512 - _S509.across_3;
    var _S514 : u32;
    if(_S509.is_warp_1)
    {
        _S514 = fabrics_0[_S508].warp_0;
    }
    else
    {
        _S514 = fabrics_0[_S508].weft_0;
    }
    var _S515 : f32 = families_0[_S514].period_0;
    var _S516 : i32 = i32(families_0[_S514].count_0);
    if(_S509.is_warp_1)
    {
        _S514 = _S509.warp_thread_0;
    }
    else
    {
        _S514 = _S509.weft_thread_0;
    }
    var _S517 : u32 = u32(i32(floor(_S513 / _S515)) * _S516 + i32(_S514)) * u32(2);
    if(_S509.is_warp_1)
    {
        _S514 = u32(1);
    }
    else
    {
        _S514 = u32(0);
    }
    return _S517 + _S514;
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

fn fibre_noise_at_0( _S518 : u32,  _S519 : u32,  _S520 : SurfacePoint_0,  _S521 : u32,  _S522 : f32) -> FibreNoise_0
{
    var _S523 : f32 = 5.0f * fabrics_0[_S518].fibre_size_0;
    var _S524 : vec2<f32> = wave_noise_0(hash_key_0(_S521, ((fabrics_0[_S518].seed_0) ^ (u32(458671337)))), _S520.fibre_along_0 / (25.0f * fabrics_0[_S518].fibre_size_0));
    var _S525 : f32 = _S520.fibre_across_0 + families_0[_S519].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S518].fibre_size_0 * _S524.x;
    var _S526 : vec3<f32> = fibre_cell_0(_S525, _S520.fibre_along_0, fabrics_0[_S518].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S521, ((fabrics_0[_S518].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S525, _S520.fibre_along_0, _S523));
    noise_0.bundle_weight_0 = fade_0(_S522, _S523);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S521, ((fabrics_0[_S518].seed_0) ^ (u32(48610963)))), _S526);
    noise_0.fibre_weight_0 = fade_0(_S522, fabrics_0[_S518].fibre_size_0);
    noise_0.offset_2 = _S526.z;
    noise_0.slope_2 = 0.5f * _S524.y;
    return noise_0;
}

fn detail_gain_0( _S527 : u32,  _S528 : u32,  _S529 : SurfacePoint_0,  _S530 : vec2<f32>,  _S531 : bool,  _S532 : u32,  _S533 : f32) -> vec2<f32>
{
    var _S534 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S528].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S533, 1.0f / families_0[_S528].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S528, _S529, _S531))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S534;
    }
    if((families_0[_S528].fibre_tone_0) > 0.0f)
    {
        var _S535 : FibreNoise_0 = fibre_noise_at_0(_S527, _S528, _S529, _S532, _S533);
        gain_2 = gain_2 + vec2<f32>(families_0[_S528].fibre_tone_0) * vec2<f32>(_S535.bundle_weight_0 * _S535.bundle_0.y + _S535.fibre_weight_0 * _S535.fibre_0.y, _S535.bundle_weight_0 + _S535.fibre_weight_0);
    }
    if((families_0[_S528].slub_0) > 0.0f)
    {
        var _S536 : f32 = 0.25f * families_0[_S528].slub_0 * fade_0(_S533, 1.0f / families_0[_S528].slubs_per_mm_0);
        var _S537 : f32;
        if(_S529.is_warp_1)
        {
            _S537 = _S530.y;
        }
        else
        {
            _S537 = - _S530.x;
        }
        gain_2 = gain_2 + vec2<f32>(_S536) * vec2<f32>(wave_noise_0(hash_key_0(_S532, ((fabrics_0[_S527].seed_0) ^ (u32(1373058189)))), _S537 * families_0[_S528].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S529.across_3 * families_0[_S528].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S538 : u32,  _S539 : Albedos_0,  _S540 : u32,  _S541 : u32,  _S542 : vec2<f32>) -> Albedos_0
{
    var _S543 : vec3<f32> = max(_S539.specular_reflect_0, _S539.specular_transmit_0);
    var _S544 : vec3<f32> = _S539.diffuse_reflect_0 + _S539.diffuse_transmit_0;
    var _S545 : vec3<f32> = vec3<f32>(fabrics_0[_S538].layer_bound_0);
    var _S546 : vec3<f32> = vec3<f32>(1.0f);
    var _S547 : vec3<f32> = _S546 - _S545 * _S543;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S540, fabrics_0[_S538].colour_noise_0, fabrics_0[_S538].seed_0), _S544, _S547);
    var _S548 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S542.y, vec3<f32>(colour_1) * _S544, _S547) * _S542.x)));
    var _S549 : f32 = bounded_gain_0(fibre_gain_0(_S540, _S541, fabrics_0[_S538].fibre_noise_0, fabrics_0[_S538].seed_0), _S543, min((_S546 - _S548 * _S544) / _S545, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S548 * _S539.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S548 * _S539.diffuse_transmit_0;
    var _S550 : vec3<f32> = vec3<f32>(_S549);
    varied_0.specular_reflect_0 = _S550 * _S539.specular_reflect_0;
    varied_0.specular_transmit_0 = _S550 * _S539.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S551 : u32,  _S552 : SurfacePoint_0,  _S553 : Albedos_0,  _S554 : f32,  _S555 : f32,  _S556 : bool,  _S557 : f32,  _S558 : f32) -> Albedos_0
{
    var _S559 : u32 = thread_number_0(_S551, _S552, _S554, _S555);
    var _S560 : vec3<f32> = fibre_cell_0(_S552.fibre_across_0, _S552.fibre_along_0, fabrics_0[_S551].fibre_size_0);
    var _S561 : vec2<f32> = vec2<f32>(0.0f);
    var _S562 : bool;
    if((fabrics_0[_S551].has_detail_0) != u32(0))
    {
        _S562 = _S557 >= 0.0f;
    }
    else
    {
        _S562 = false;
    }
    var gain_3 : vec2<f32>;
    if(_S562)
    {
        var _S563 : u32;
        if(_S552.is_warp_1)
        {
            _S563 = fabrics_0[_S551].warp_0;
        }
        else
        {
            _S563 = fabrics_0[_S551].weft_0;
        }
        gain_3 = detail_gain_0(_S551, _S563, _S552, vec2<f32>(_S554, _S555), _S556, _S559, _S557) * vec2<f32>(1.0f - _S558, 1.0f);
    }
    else
    {
        gain_3 = _S561;
    }
    return vary_albedos_0(_S551, _S553, _S559, u32(i32(_S560.x)) * u32(65536) + u32(i32(floor(_S560.y))), gain_3);
}

fn turned_frame_0( _S564 : u32,  _S565 : u32,  _S566 : SurfacePoint_0,  _S567 : bool,  _S568 : u32,  _S569 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_4 = _S566.normal_3;
    frame_2.tangent_3 = _S566.tangent_2;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S565].has_plies_0) > 0.0f)
    {
        var _S570 : f32 = fade_0(_S569, 1.0f / families_0[_S565].plies_per_mm_0);
        var _S571 : f32 = _S570 * 0.41999998688697815f * ply_offset_0(_S565, _S566, _S567);
        var _S572 : f32 = sqrt(1.0f - _S571 * _S571);
        var _S573 : f32;
        if(_S567)
        {
            _S573 = - families_0[_S565].ply_sine_0;
        }
        else
        {
            _S573 = families_0[_S565].ply_sine_0;
        }
        var _S574 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S575 : vec3<f32> = vec3<f32>(families_0[_S565].ply_cosine_0);
        var _S576 : vec3<f32> = _S575 * _S574 + vec3<f32>(_S573) * frame_2.tangent_3;
        var _S577 : vec3<f32> = vec3<f32>(_S572);
        var _S578 : vec3<f32> = vec3<f32>(_S571);
        frame_2.tangent_3 = _S575 * (_S575 * frame_2.tangent_3 - vec3<f32>(_S573) * _S574) + vec3<f32>(_S573) * (_S577 * _S576 - _S578 * frame_2.normal_4);
        frame_2.normal_4 = _S577 * frame_2.normal_4 + _S578 * _S576;
        frame_2.loss_0 = _S570 * _S570 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S579 : f32 = families_0[_S565].fibre_tilt_0;
    if((families_0[_S565].fibre_tilt_0) > 0.0f)
    {
        var _S580 : FibreNoise_0 = fibre_noise_at_0(_S564, _S565, _S566, _S568, _S569);
        var _S581 : f32 = 1.09858846664428711f * _S579 * (_S580.bundle_weight_0 * _S580.bundle_0.x + _S580.fibre_weight_0 * (_S580.fibre_0.x + _S580.offset_2));
        var _S582 : f32 = _S579 * (1.42099642753601074f * (_S580.bundle_weight_0 * _S580.bundle_0.y + _S580.fibre_weight_0 * _S580.fibre_0.y) - _S580.bundle_weight_0 * _S580.slope_2);
        var _S583 : f32 = square_1(_S580.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S579 * _S579 * ((0.24761904776096344f * (square_1(_S580.bundle_weight_0) + _S583) + _S583 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S584 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S585 : vec2<f32> = sine_cosine_0(_S581);
        var _S586 : vec2<f32> = sine_cosine_0(_S582);
        var _S587 : vec3<f32> = vec3<f32>(_S585.y);
        var _S588 : vec3<f32> = vec3<f32>(_S585.x);
        var _S589 : vec3<f32> = _S587 * _S584 - _S588 * frame_2.normal_4;
        frame_2.normal_4 = _S587 * frame_2.normal_4 + _S588 * _S584;
        frame_2.tangent_3 = vec3<f32>(_S586.y) * frame_2.tangent_3 + vec3<f32>(_S586.x) * _S589;
    }
    return frame_2;
}

fn yarn_point_of_0( _S590 : u32,  _S591 : SurfacePoint_0,  _S592 : f32,  _S593 : f32,  _S594 : bool,  _S595 : bool,  _S596 : f32) -> YarnPoint_0
{
    var _S597 : u32;
    if(_S591.is_warp_1)
    {
        _S597 = fabrics_0[_S590].warp_0;
    }
    else
    {
        _S597 = fabrics_0[_S590].weft_0;
    }
    var _S598 : bool;
    if((fabrics_0[_S590].has_detail_0) != u32(0))
    {
        _S598 = _S596 >= 0.0f;
    }
    else
    {
        _S598 = false;
    }
    var _S599 : vec3<f32> = vec3<f32>(0.0f);
    var _S600 : Hair_0 = Hair_x24init_0(0.0f, _S599, _S599);
    var _S601 : bool;
    if(_S598)
    {
        _S601 = has_hairs_0(_S590);
    }
    else
    {
        _S601 = false;
    }
    var hair_2 : Hair_0;
    if(_S601)
    {
        hair_2 = hair_at_0(_S590, vec2<f32>(_S592, _S593), _S594, _S596);
    }
    else
    {
        hair_2 = _S600;
    }
    var _S602 : u32;
    if(_S591.is_warp_1)
    {
        _S602 = _S591.warp_thread_0;
    }
    else
    {
        _S602 = _S591.weft_thread_0;
    }
    var albedos_3 : Albedos_0 = albedos_of_0(_S597, _S602);
    var albedos_4 : Albedos_0;
    if(varies_at_0(_S590, _S596))
    {
        albedos_4 = varied_at_0(_S590, _S591, albedos_3, _S592, _S593, _S594, _S596, hair_2.cover_0);
    }
    else
    {
        albedos_4 = albedos_3;
    }
    var point_5 : YarnPoint_0;
    point_5.back_6 = _S594;
    point_5.hole_3 = _S595;
    point_5.is_warp_2 = _S591.is_warp_1;
    point_5.x_12 = _S592;
    point_5.y_5 = _S593;
    point_5.height_5 = _S591.height_4;
    point_5.normal_8 = _S591.normal_3;
    point_5.tangent_8 = _S591.tangent_2;
    point_5.surface_normal_0 = _S591.normal_3;
    point_5.diffuse_gain_1 = 1.0f;
    if(_S598)
    {
        var _S603 : YarnFrame_0 = turned_frame_0(_S590, _S597, _S591, _S594, thread_number_0(_S590, _S591, _S592, _S593), _S596);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S590))
        {
            frame_3 = under_hair_0(_S603, hair_2);
        }
        else
        {
            frame_3 = _S603;
        }
        point_5.normal_8 = frame_3.normal_4;
        point_5.tangent_8 = frame_3.tangent_3;
        point_5.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S590].diffuse_blend_0);
    }
    point_5.roughness_8 = families_0[_S597].roughness_0;
    point_5.albedos_2 = albedos_4;
    return point_5;
}

fn locate_yarn_0( _S604 : u32,  _S605 : SearchQuality_0,  _S606 : f32,  _S607 : f32,  _S608 : vec3<f32>,  _S609 : f32) -> YarnPoint_0
{
    var _S610 : bool = (_S608.z) < 0.0f;
    var _S611 : Hit_0 = first_hit_0(_S604, _S605, _S606, _S607, to_face_frame_0(_S608, _S610), _S610);
    return yarn_point_of_0(_S604, surface_at_0(_S604, _S611.x_13, _S611.y_6, _S610), _S611.x_13, _S611.y_6, _S610, _S611.hole_4, _S609);
}

fn openness_number_0( _S612 : u32,  _S613 : u32) -> f32
{
    return table_number_0(fabrics_0[_S612].openness_0 + _S613);
}

fn blocked_of_terms_0( _S614 : u32,  _S615 : u32,  _S616 : array<f32, i32(6)>,  _S617 : u32) -> Blocked_0
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
            if(term_0 < _S617)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S614, _S615 + share_3 * _S617 + term_0) * _S616[term_0];
            term_0 = term_0 + u32(1);
        }
        shares_0[share_3] = saturate(shares_0[share_3]);
        share_3 = share_3 + u32(1);
    }
    var blocked_1 : Blocked_0;
    blocked_1.by_warp_0 = shares_0[i32(0)] * shares_0[i32(2)];
    blocked_1.by_weft_0 = shares_0[i32(0)] * (1.0f - shares_0[i32(2)]);
    blocked_1.far_0 = shares_0[i32(1)];
    return blocked_1;
}

fn blocked_at_0( _S618 : u32,  _S619 : bool,  _S620 : bool,  _S621 : f32,  _S622 : f32) -> Blocked_0
{
    var _S623 : f32 = _S622 * openness_number_0(_S618, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S621, _S623, _S621 * _S621, _S621 * _S623, _S623 * _S623 );
    var _S624 : u32;
    if(_S620)
    {
        _S624 = u32(2);
    }
    else
    {
        _S624 = u32(0);
    }
    var _S625 : u32;
    if(_S619)
    {
        _S625 = u32(0);
    }
    else
    {
        _S625 = u32(1);
    }
    return blocked_of_terms_0(_S618, u32(60) + (_S624 + _S625) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S626 : u32,  _S627 : Albedos_0,  _S628 : u32,  _S629 : vec3<f32>) -> Scattered_0
{
    var _S630 : u32 = u32(159) + u32(2) * _S628;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S629 * _S627.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S626, _S630)) * _S627.specular_reflect_0;
    yarn_3.through_0 = _S629 * _S627.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S626, _S630 + u32(1))) * _S627.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S631 : u32,  _S632 : u32,  _S633 : vec3<f32>,  _S634 : vec3<f32>,  _S635 : vec3<f32>,  _S636 : vec3<f32>,  _S637 : ptr<function, vec3<f32>>,  _S638 : ptr<function, vec3<f32>>)
{
    var _S639 : u32 = u32(146) + u32(4) * _S632;
    var _S640 : f32 = openness_number_0(_S631, _S639 + u32(1));
    var _S641 : f32 = openness_number_0(_S631, _S639 + u32(2));
    var _S642 : vec3<f32> = vec3<f32>(1.0f);
    var _S643 : vec3<f32> = _S642 - _S635 * vec3<f32>(openness_number_0(_S631, _S639));
    var _S644 : vec3<f32> = _S642 - _S636 * vec3<f32>(openness_number_0(_S631, _S639 + u32(3)));
    var _S645 : vec3<f32> = _S642 / (_S643 * _S644 - _S635 * _S636 * vec3<f32>((_S640 * _S641)));
    (*_S637) = (_S633 * _S644 + _S635 * vec3<f32>(_S640) * _S634) * _S645;
    (*_S638) = (_S634 * _S643 + _S636 * vec3<f32>(_S641) * _S633) * _S645;
    return;
}

fn face_sends_0( _S646 : u32,  _S647 : u32,  _S648 : Scattered_0,  _S649 : Scattered_0) -> FaceSends_0
{
    var _S650 : u32 = u32(2) * _S647;
    var _S651 : u32 = u32(142) + _S650;
    var _S652 : f32 = openness_number_0(_S646, _S651);
    var _S653 : f32 = openness_number_0(_S646, _S651 + u32(1));
    var _S654 : vec3<f32> = vec3<f32>((1.0f - _S652)) * _S648.back_5;
    var _S655 : vec3<f32> = vec3<f32>((1.0f - _S653)) * _S649.back_5;
    var sends_1 : FaceSends_0;
    var _S656 : u32 = u32(154) + _S650;
    var _S657 : f32 = openness_number_0(_S646, _S656);
    sends_1.blocks_warp_0 = _S657;
    var _S658 : f32 = openness_number_0(_S646, _S656 + u32(1));
    sends_1.blocks_weft_0 = _S658;
    sends_1.open_0 = _S657 * _S652 + _S658 * _S653;
    var _S659 : vec3<f32> = vec3<f32>(_S652) * _S648.back_5;
    var _S660 : vec3<f32> = vec3<f32>(_S653) * _S649.back_5;
    var _S661 : vec3<f32> = sends_1.sky_warp_0;
    var _S662 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S646, _S647, _S659, _S660, _S654, _S655, &(_S661), &(_S662));
    sends_1.sky_warp_0 = _S661;
    sends_1.sky_weft_0 = _S662;
    var _S663 : vec3<f32> = sends_1.crossing_warp_0;
    var _S664 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S646, _S647, _S648.through_0, _S649.through_0, _S654, _S655, &(_S663), &(_S664));
    sends_1.crossing_warp_0 = _S663;
    sends_1.crossing_weft_0 = _S664;
    return sends_1;
}

fn interior_of_0( _S665 : u32,  _S666 : vec3<f32>,  _S667 : bool) -> Interior_0
{
    var _S668 : Scattered_0 = scattered_by_0(_S665, table_albedos_0(families_0[fabrics_0[_S665].warp_0].colour_mean_0), u32(0), _S666);
    var _S669 : Scattered_0 = scattered_by_0(_S665, table_albedos_0(families_0[fabrics_0[_S665].weft_0].colour_mean_0), u32(1), _S666);
    var _S670 : u32;
    if(_S667)
    {
        _S670 = u32(1);
    }
    else
    {
        _S670 = u32(0);
    }
    var _S671 : FaceSends_0 = face_sends_0(_S665, _S670, _S668, _S669);
    if(_S667)
    {
        _S670 = u32(0);
    }
    else
    {
        _S670 = u32(1);
    }
    var _S672 : FaceSends_0 = face_sends_0(_S665, _S670, _S668, _S669);
    var _S673 : vec3<f32> = vec3<f32>(_S671.blocks_warp_0);
    var _S674 : vec3<f32> = vec3<f32>(_S671.blocks_weft_0);
    var _S675 : vec3<f32> = _S673 * _S671.crossing_warp_0 + _S674 * _S671.crossing_weft_0;
    var _S676 : vec3<f32> = vec3<f32>(_S672.blocks_warp_0);
    var _S677 : vec3<f32> = vec3<f32>(_S672.blocks_weft_0);
    var _S678 : vec3<f32> = _S676 * _S672.crossing_warp_0 + _S677 * _S672.crossing_weft_0;
    var _S679 : f32 = 1.0f - _S671.open_0;
    var _S680 : f32 = 1.0f - _S672.open_0;
    var _S681 : vec3<f32> = vec3<f32>(1.0f);
    var _S682 : vec3<f32> = _S681 / (_S681 - _S675 * _S678 * vec3<f32>((_S679 * _S680)));
    var _S683 : vec3<f32> = _S678 * (vec3<f32>(_S671.open_0) + vec3<f32>(_S679) * (_S673 * _S671.sky_warp_0 + _S674 * _S671.sky_weft_0)) * _S682;
    var _S684 : vec3<f32> = _S675 * (vec3<f32>(_S672.open_0) + vec3<f32>(_S680) * (_S676 * _S672.sky_warp_0 + _S677 * _S672.sky_weft_0)) * _S682;
    var _S685 : FaceRadiance_0 = face_radiance_0(_S671, _S672.open_0, _S683, _S684);
    var _S686 : FaceRadiance_0 = face_radiance_0(_S672, _S671.open_0, _S684, _S683);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S685.warp_2;
    interior_1.weft_3 = _S685.weft_2;
    interior_1.leaked_1 = _S685.leaked_0;
    interior_1.far_1 = _S686.mean_0;
    interior_1.far_leaked_0 = _S686.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S687 : u32,  _S688 : YarnPoint_0,  _S689 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S690 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S690;
    nothing_0.transmitted_0 = _S690;
    var _S691 : bool;
    if((fabrics_0[_S687].openness_0) == u32(4294967295))
    {
        _S691 = true;
    }
    else
    {
        _S691 = _S688.hole_3;
    }
    if(_S691)
    {
        return nothing_0;
    }
    var _S692 : Blocked_0 = blocked_at_0(_S687, _S688.is_warp_2, _S688.back_6, _S688.surface_normal_0.z, _S688.height_5);
    var _S693 : u32;
    if(_S688.is_warp_2)
    {
        _S693 = u32(0);
    }
    else
    {
        _S693 = u32(1);
    }
    return bounced_by_0(_S692, scattered_by_0(_S687, _S688.albedos_2, _S693, _S689), interior_of_0(_S687, _S689, _S688.back_6));
}

fn light_sample_count_0( _S694 : i32) -> u32
{
    return frames_0[_S694].lights_0 + frames_0[_S694].environment_samples_0;
}

fn visibility_at_0( _S695 : i32,  _S696 : u32,  _S697 : vec2<u32>) -> f32
{
    if((frames_0[_S695].casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S696 * frames_0[_S695].height_0 + _S697.y) * frames_0[_S695].width_0 + _S697.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S698 : i32,  _S699 : u32,  _S700 : u32) -> vec3<f32>
{
    var _S701 : u32 = frames_0[_S698].environment_table_0 + frames_0[_S698].environment_rows_0 + u32(1) + frames_0[_S698].environment_rows_0 * (frames_0[_S698].environment_columns_0 + u32(1)) + u32(3) * (_S699 * frames_0[_S698].environment_columns_0 + _S700);
    return vec3<f32>(scene_number_0(_S701), scene_number_0(_S701 + u32(1)), scene_number_0(_S701 + u32(2)));
}

fn sample_environment_0( _S702 : i32,  _S703 : vec2<f32>,  _S704 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S705 : u32 = frames_0[_S702].environment_rows_0;
    var _S706 : Choice_0 = choose_0(frames_0[_S702].environment_table_0, frames_0[_S702].environment_rows_0, _S703.y);
    var _S707 : u32 = frames_0[_S702].environment_columns_0;
    var _S708 : Choice_0 = choose_0(frames_0[_S702].environment_table_0 + frames_0[_S702].environment_rows_0 + u32(1) + _S706.index_6 * (frames_0[_S702].environment_columns_0 + u32(1)), frames_0[_S702].environment_columns_0, _S703.x);
    var _S709 : vec3<f32> = environment_texel_0(_S702, _S706.index_6, _S708.index_6);
    (*_S704) = _S709 * vec3<f32>((frames_0[_S702].environment_total_0 / max(mean_1(_S709), 9.99999968265522539e-21f)));
    var _S710 : f32 = 3.14159274101257324f / f32(_S705);
    var _S711 : f32 = mix(sine_cosine_0(f32(_S706.index_6) * _S710).y, sine_cosine_0(f32(_S706.index_6 + u32(1)) * _S710).y, _S706.remainder_0);
    var _S712 : f32 = sqrt(max(1.0f - _S711 * _S711, 0.0f));
    var _S713 : vec2<f32> = sine_cosine_0((f32(_S708.index_6) + _S708.remainder_0) * (6.28318548202514648f / f32(_S707)));
    var _S714 : f32 = _S712 * _S713.x;
    var _S715 : f32 = - _S712 * _S713.y;
    return vec3<f32>(frames_0[_S702].environment_cosine_0 * _S714 + frames_0[_S702].environment_sine_0 * _S715, _S711, frames_0[_S702].environment_cosine_0 * _S715 - frames_0[_S702].environment_sine_0 * _S714);
}

fn light_sample_0( _S716 : i32,  _S717 : u32,  _S718 : vec2<u32>,  _S719 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S720 : u32 = frames_0[_S716].lights_0;
    if(_S717 >= (frames_0[_S716].lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S721 : vec3<f32> = sample_environment_0(_S716, pixel_sequence_0(_S718, frames_0[_S716].pass_number_0 * frames_0[_S716].environment_samples_0 + (_S717 - _S720), u32(3)), &(weight_0));
        sample_1.towards_0 = _S721;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frames_0[_S716].environment_samples_0));
        return sample_1;
    }
    var _S722 : Light_std430_0 = lights_1[_S717];
    sample_1.irradiance_1 = vec3<f32>(_S722.red_0, _S722.green_0, _S722.blue_0);
    sample_1.towards_0 = vec3<f32>(_S722.x_1, _S722.y_1, _S722.z_1);
    if((_S722.is_point_0) != u32(0))
    {
        var _S723 : vec3<f32> = sample_1.towards_0 - _S719;
        var _S724 : f32 = max(square_0(_S723), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S724);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S724);
        sample_1.towards_0 = normalize(_S723);
    }
    return sample_1;
}

fn scattered_0( _S725 : u32,  _S726 : YarnPoint_0,  _S727 : vec3<f32>,  _S728 : vec3<f32>) -> vec3<f32>
{
    var _S729 : vec3<f32> = vec3<f32>(0.0f);
    var _S730 : bool = !_S726.hole_3;
    var _S731 : bool;
    if(_S730)
    {
        _S731 = (_S727.z) > 0.0f;
    }
    else
    {
        _S731 = false;
    }
    var value_1 : vec3<f32>;
    if(_S731)
    {
        value_1 = _S726.albedos_2.diffuse_reflect_0 * vec3<f32>(_S726.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0(_S727, _S726.normal_8, fabrics_0[_S725].diffuse_blend_0)) + _S726.albedos_2.specular_reflect_0 * vec3<f32>(reflection_0(_S727, _S728, _S726.normal_8, _S726.tangent_8, _S726.roughness_8, fabrics_0[_S725].optical_depth_0));
    }
    else
    {
        if(_S730)
        {
            _S731 = (_S727.z) < 0.0f;
        }
        else
        {
            _S731 = false;
        }
        if(_S731)
        {
            value_1 = _S726.albedos_2.diffuse_transmit_0 * vec3<f32>(_S726.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S727), _S726.normal_8, fabrics_0[_S725].diffuse_blend_0)) + _S726.albedos_2.specular_transmit_0 * vec3<f32>(transmission_1(_S727, _S728, _S726.normal_8, _S726.tangent_8, _S726.roughness_8, fabrics_0[_S725].optical_depth_0));
        }
        else
        {
            value_1 = _S729;
        }
    }
    var _S732 : f32 = fabrics_0[_S725].sheen_strength_0;
    if((fabrics_0[_S725].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S733 : vec2<f32> = sheen_with_transmittance_0(_S727, _S728, _S732, fabrics_0[_S725].sheen_roughness_0);
    return vec3<f32>(_S733.y) * value_1 + vec3<f32>(_S733.x);
}

fn unoccluded_0( _S734 : u32,  _S735 : SearchQuality_0,  _S736 : f32,  _S737 : f32,  _S738 : f32,  _S739 : vec3<f32>,  _S740 : bool) -> bool
{
    if((_S739.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S734, _S735, vec3<f32>(_S736, _S737, _S738 + fabrics_0[_S734].lift_0), _S739, _S740, max_height_along_0(_S734, _S736, _S737, _S738, _S739, _S740));
}

fn is_lit_0( _S741 : u32,  _S742 : SearchQuality_0,  _S743 : YarnPoint_0,  _S744 : vec3<f32>) -> bool
{
    if(_S743.hole_3)
    {
        return true;
    }
    var _S745 : vec3<f32> = to_face_frame_0(_S744, _S743.back_6);
    var _S746 : f32 = _S745.z;
    var _S747 : bool = _S746 < 0.0f;
    var normal_9 : vec3<f32>;
    var height_11 : f32;
    if(_S747)
    {
        var _S748 : SurfacePoint_0 = surface_at_0(_S741, _S743.x_12, _S743.y_5, !_S743.back_6);
        normal_9 = _S748.normal_3;
        height_11 = _S748.height_4;
    }
    else
    {
        normal_9 = _S743.surface_normal_0;
        height_11 = _S743.height_5;
    }
    var _S749 : vec3<f32> = vec3<f32>(_S745.xy, abs(_S746));
    if((dot(normal_9, _S749)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S741, _S742, _S743.x_12, _S743.y_5, height_11, _S749, (_S743.back_6) != _S747);
}

fn evaluate_with_0( _S750 : u32,  _S751 : SearchQuality_0,  _S752 : YarnPoint_0,  _S753 : Bounced_0,  _S754 : vec3<f32>,  _S755 : vec3<f32>) -> vec3<f32>
{
    var _S756 : vec3<f32> = to_face_frame_0(_S755, _S752.back_6);
    var _S757 : vec3<f32> = scattered_0(_S750, _S752, to_face_frame_0(_S754, _S752.back_6), _S756);
    var _S758 : bool;
    if((max(_S757.x, max(_S757.y, _S757.z))) <= 0.0f)
    {
        _S758 = true;
    }
    else
    {
        _S758 = !is_lit_0(_S750, _S751, _S752, _S754);
    }
    var value_2 : vec3<f32>;
    if(_S758)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S757;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S753, _S754, _S755);
    var _S759 : f32 = fabrics_0[_S750].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S750].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S759 * sheen_lobe_0(abs(_S756.z), fabrics_0[_S750].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S760 : u32,  _S761 : YarnPoint_0,  _S762 : vec3<f32>) -> f32
{
    if(!_S761.hole_3)
    {
        return 0.0f;
    }
    var _S763 : f32 = fabrics_0[_S760].sheen_strength_0;
    if((fabrics_0[_S760].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S763 * sheen_lobe_0(abs(_S762.z), fabrics_0[_S760].sheen_roughness_0).z;
}

fn light_of_point_0( _S764 : i32,  _S765 : u32,  _S766 : VisiblePoint_0,  _S767 : vec2<u32>,  _S768 : vec3<f32>,  _S769 : vec2<f32>) -> vec4<f32>
{
    var _S770 : SearchQuality_0 = default_quality_0();
    var _S771 : vec3<f32> = to_local_0(_S766, _S766.view_1);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S769;
    footprint_0.dx_0 = _S766.draft_dx_0;
    footprint_0.dy_0 = _S766.draft_dy_0;
    var _S772 : YarnPoint_0 = locate_yarn_0(_S765, _S770, _S769.x, _S769.y, _S771, Footprint_spread_side_0(footprint_0));
    var point_6 : YarnPoint_0 = _S772;
    var _S773 : Bounced_0 = bounced_at_0(_S765, _S772, _S768);
    point_6.albedos_2 = tinted_0(point_6.albedos_2, _S768);
    var _S774 : vec3<f32> = vec3<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S774;
    for(;;)
    {
        if(number_3 < (light_sample_count_0(_S764)))
        {
        }
        else
        {
            break;
        }
        var _S775 : f32 = visibility_at_0(_S764, number_3, _S767);
        if(_S775 <= 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S776 : LightSample_0 = light_sample_0(_S764, number_3, _S767, _S766.position_0);
        radiance_1 = radiance_1 + vec3<f32>(_S775) * _S776.irradiance_1 * evaluate_with_0(_S765, _S770, point_6, _S773, to_local_0(_S766, _S776.towards_0), _S771);
        number_3 = number_3 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S765, point_6, _S771));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S777 : u32;
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
    var _S781 : vec2<u32> = id_0.xy;
    var _S782 : u32 = id_0.y * _S779 + _S778;
    var _S783 : u32 = layers_0[_S782].face_0;
    if((layers_0[_S782].face_0) == u32(0))
    {
        return;
    }
    var _S784 : u32 = _S783 - u32(1);
    var _S785 : u32 = face_fabrics_0[_S784];
    var _S786 : VisiblePoint_0 = visible_point_0(i32(0), _S785, _S784, _S781);
    var _S787 : vec3<f32> = filtered_albedo_0(_S785, _S786);
    var _S788 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S788;
    for(;;)
    {
        var _S789 : u32 = frames_0[i32(0)].samples_0;
        _S777 = frames_0[i32(0)].samples_0;
        if(k_0 < (frames_0[i32(0)].samples_0))
        {
        }
        else
        {
            break;
        }
        var _S790 : vec2<f32> = pixel_sequence_0(_S781, frames_0[i32(0)].pass_number_0 * _S789 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(i32(0), _S785, _S786, _S781, _S787, _S786.draft_0 + vec2<f32>(_S790.x) * _S786.draft_dx_0 + vec2<f32>(_S790.y) * _S786.draft_dy_0);
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S782, sum_0 / vec4<f32>(f32(_S777)));
    return;
}

