struct Frame_std140_0
{
    @align(16) width_0 : u32,
    @align(4) height_0 : u32,
    @align(8) lights_0 : u32,
    @align(4) samples_0 : u32,
    @align(16) pass_number_0 : u32,
    @align(4) environment_samples_0 : u32,
    @align(8) environment_columns_0 : u32,
    @align(4) environment_rows_0 : u32,
    @align(16) environment_table_0 : u32,
    @align(4) environment_total_0 : f32,
    @align(8) environment_sine_0 : f32,
    @align(4) environment_cosine_0 : f32,
    @align(16) shows_environment_0 : u32,
    @align(4) casts_shadows_0 : u32,
    @align(8) leaves_0 : u32,
    @align(4) leaf_faces_0 : u32,
    @align(16) corners_0 : u32,
    @align(4) face_fabrics_0 : u32,
    @align(8) vertices_0 : u32,
    @align(4) light_records_0 : u32,
    @align(16) ray_offset_0 : f32,
    @align(4) jitter_x_0 : f32,
    @align(8) jitter_y_0 : f32,
    @align(4) gain_0 : f32,
    @align(16) origin_x_0 : f32,
    @align(4) origin_y_0 : f32,
    @align(8) origin_z_0 : f32,
    @align(4) right_x_0 : f32,
    @align(16) right_y_0 : f32,
    @align(4) right_z_0 : f32,
    @align(8) up_x_0 : f32,
    @align(4) up_y_0 : f32,
    @align(16) up_z_0 : f32,
    @align(4) forward_x_0 : f32,
    @align(8) forward_y_0 : f32,
    @align(4) forward_z_0 : f32,
    @align(16) near_0 : f32,
    @align(4) background_red_0 : f32,
    @align(8) background_green_0 : f32,
    @align(4) background_blue_0 : f32,
    @align(16) ground_x_0 : f32,
    @align(4) ground_y_0 : f32,
    @align(8) ground_z_0 : f32,
    @align(4) ground_offset_0 : f32,
    @align(16) ground_lamp_0 : f32,
};

@binding(10) @group(0) var<uniform> frame_record_0 : Frame_std140_0;
struct Layer_std430_0
{
    @align(4) face_0 : u32,
    @align(4) share_0 : f32,
};

@binding(5) @group(0) var<storage, read_write> layers_0 : array<Layer_std430_0>;

@binding(4) @group(0) var<storage, read> scene_words_0 : array<u32>;

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
    @align(4) joint_0 : u32,
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
    @align(4) frames_0 : u32,
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
    @align(4) is_apart_0 : u32,
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
    @align(4) texels_2 : u32,
    @align(4) light_0 : u32,
    @align(4) heights_0 : u32,
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
    @align(4) hairiness_0 : f32,
};

@binding(1) @group(0) var<storage, read> families_0 : array<Family_std430_0>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec3<f32>,  no_0 : vec3<f32>) -> vec3<f32>
{
    var chosen_0 : vec3<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    chosen_0[i32(2)] = select(no_0[i32(2)], yes_0[i32(2)], condition_0);
    return chosen_0;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec2<f32>,  no_1 : vec2<f32>) -> vec2<f32>
{
    var chosen_1 : vec2<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    return chosen_1;
}

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
fn fabric_of_0( face_1 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_1];
}

struct Vertex_0
{
     x_1 : f32,
     y_0 : f32,
     z_0 : f32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     u_0 : f32,
     v_0 : f32,
};

fn scene_vertex_0( first_0 : u32) -> Vertex_0
{
    var record_0 : Vertex_0;
    record_0.x_1 = (bitcast<f32>((scene_words_0[first_0])));
    record_0.y_0 = (bitcast<f32>((scene_words_0[first_0 + u32(1)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_0 + u32(2)])));
    record_0.normal_x_0 = (bitcast<f32>((scene_words_0[first_0 + u32(3)])));
    record_0.normal_y_0 = (bitcast<f32>((scene_words_0[first_0 + u32(4)])));
    record_0.normal_z_0 = (bitcast<f32>((scene_words_0[first_0 + u32(5)])));
    record_0.u_0 = (bitcast<f32>((scene_words_0[first_0 + u32(6)])));
    record_0.v_0 = (bitcast<f32>((scene_words_0[first_0 + u32(7)])));
    return record_0;
}

fn vertex_at_0( corner_0 : u32) -> Vertex_0
{
    return scene_vertex_0(frame_record_0.vertices_0 + u32(8) * scene_words_0[frame_record_0.corners_0 + corner_0]);
}

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.x_1, vertex_0.y_0, vertex_0.z_0);
}

fn square_0( v_1 : vec3<f32>) -> f32
{
    return dot(v_1, v_1);
}

fn normal_of_0( vertex_1 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_1.normal_x_0, vertex_1.normal_y_0, vertex_1.normal_z_0);
}

fn scramble_0( value_0 : u32) -> u32
{
    var _S1 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S2 : u32 = ((((_S1 >> ((((_S1 >> (u32(28)))) + u32(4))))) ^ (_S1))) * u32(277803737);
    return (((_S2 >> (u32(22)))) ^ (_S2));
}

fn hash_key_0( thread_0 : u32,  stream_0 : u32) -> u32
{
    return scramble_0(thread_0 + scramble_0(stream_0));
}

fn hash_bits_0( key_0 : u32,  cell_0 : u32) -> u32
{
    return scramble_0(cell_0 + key_0);
}

fn uneven_corner_0( key_1 : u32,  cell_1 : u32) -> f32
{
    return f32(((hash_bits_0(key_1, cell_1)) >> (u32(9)))) * 2.384185791015625e-07f - 1.0f;
}

fn uneven_octave_0( key_2 : u32,  place_0 : vec2<f32>) -> f32
{
    var _S3 : vec2<f32> = floor(place_0);
    var _S4 : vec2<f32> = place_0 - _S3;
    var _S5 : vec2<f32> = _S4 * _S4 * (vec2<f32>(3.0f) - vec2<f32>(2.0f) * _S4);
    var _S6 : u32 = u32(i32(_S3.x)) * u32(65536) + u32(i32(_S3.y));
    var _S7 : f32 = _S5.x;
    return mix(mix(uneven_corner_0(key_2, _S6), uneven_corner_0(key_2, _S6 + u32(65536)), _S7), mix(uneven_corner_0(key_2, _S6 + u32(1)), uneven_corner_0(key_2, _S6 + u32(65537)), _S7), _S5.y);
}

fn square_1( x_2 : f32) -> f32
{
    return x_2 * x_2;
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S8 : u32 = (bitcast<u32>((x_3)));
    var m_0 : f32 = (bitcast<f32>(((((_S8 & (u32(8388607)))) | (u32(1056964608))))));
    var _S9 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S8 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S9);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S9) - 1.0f;
    var _S10 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S10 - exponent_0 * 0.00021219444170129f - 0.5f * _S10) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S11 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S12 : f32 = floor(_S11 * 1.4426950216293335f + 0.5f);
    var _S13 : f32 = _S11 - _S12 * 0.693359375f + _S12 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S13 + 0.00139819993637502f) * _S13 + 0.00833345204591751f) * _S13 + 0.04166579619050026f) * _S13 + 0.1666666567325592f) * _S13 + 0.5f) * _S13 * _S13 + _S13 + 1.0f) * (bitcast<f32>(((u32(i32(_S12) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S14 : u32 = scene_words_0[index_0];
    var _S15 : vec3<f32> = vec3<f32>(f32((_S14 & (u32(1023)))), f32((((_S14 >> (u32(10)))) & (u32(1023)))), f32((_S14 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S15 * _S15;
}

fn map_level_0( first_1 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S16 : f32 = uv_0.x;
    var _S17 : f32 = f32(side_0);
    var _S18 : f32 = (_S16 - floor(_S16)) * _S17 - 0.5f;
    var _S19 : f32 = uv_0.y;
    var _S20 : f32 = (_S19 - floor(_S19)) * _S17 - 0.5f;
    var _S21 : f32 = floor(_S18);
    var _S22 : i32 = i32(side_0);
    var _S23 : u32 = side_0 - u32(1);
    var _S24 : u32 = (u32(i32(_S21) + _S22) & (_S23));
    var _S25 : f32 = floor(_S20);
    var _S26 : u32 = (u32(i32(_S25) + _S22) & (_S23));
    var _S27 : u32 = ((_S24 + u32(1)) & (_S23));
    var _S28 : u32 = first_1 + _S26 * side_0;
    var _S29 : vec3<f32> = vec3<f32>((_S18 - _S21));
    var _S30 : u32 = first_1 + (((_S26 + u32(1)) & (_S23))) * side_0;
    return mix(mix(map_texel_0(_S28 + _S24), map_texel_0(_S28 + _S27), _S29), mix(map_texel_0(_S30 + _S24), map_texel_0(_S30 + _S27), _S29), vec3<f32>((_S20 - _S25)));
}

fn uniform_hash_0( thread_1 : u32,  cell_2 : u32,  stream_1 : u32) -> f32
{
    return (f32(((hash_bits_0(hash_key_0(thread_1, stream_1), cell_2)) >> (u32(9)))) + 0.5f) * 1.1920928955078125e-07f;
}

fn pixel_sequence_0( pixel_0 : vec2<u32>,  index_1 : u32,  stream_2 : u32) -> vec2<f32>
{
    var _S31 : u32 = pixel_0.x;
    var _S32 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S31, _S32, stream_2), uniform_hash_0(_S31, _S32, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
    var _S33 : vec2<f32> = this_0.dx_0;
    var _S34 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S33, _S33) + dot(_S34, _S34)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S35 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S35, - _S35, back_2));
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S36 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S36, fma(- _S36, families_0[family_0].count_0, index_2));
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
    var _S37 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_3 : Cell_0;
    var _S38 : f32 = fma(- _S37, families_0[family_1].size_0, position_1);
    cell_3.below_0 = _S38;
    cell_3.above_0 = families_0[family_1].size_0 - _S38;
    cell_3.across_0 = _S38 - 0.5f * families_0[family_1].size_0;
    cell_3.half_width_1 = families_0[family_1].half_width_0;
    cell_3.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S37).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_3;
}

fn table_number_0( index_3 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_3])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S39 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S40 : u32 = min(thread_3 + select(u32(0), u32(1), _S39 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S41 : u32 = families_0[family_2].place_table_0 + _S40 * u32(4);
    var cell_4 : Cell_0;
    cell_4.thread_2 = _S40;
    cell_4.below_0 = _S39 - table_number_0(_S41);
    cell_4.above_0 = table_number_0(_S41 + u32(1)) - _S39;
    cell_4.across_0 = _S39 - table_number_0(_S41 + u32(2));
    cell_4.half_width_1 = table_number_0(_S41 + u32(3));
    return cell_4;
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
    var _S42 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var shown_0 : Shown_0;
    var _S43 : bool = !((abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1));
    var _S44 : bool = (_S42 & (((_S43 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_0 = _S44;
    shown_0.hole_0 = ((!_S42) & (_S43));
    var _S45 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S44);
    shown_0.word_0 = _S45;
    shown_0.on_top_0 = (((_S45 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_2 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_5 : Cell_0;
    cell_5.thread_2 = select(second_0.thread_2, first_2.thread_2, is_first_0);
    cell_5.across_0 = select(second_0.across_0, first_2.across_0, is_first_0);
    cell_5.half_width_1 = select(second_0.half_width_1, first_2.half_width_1, is_first_0);
    cell_5.below_0 = select(second_0.below_0, first_2.below_0, is_first_0);
    cell_5.above_0 = select(second_0.above_0, first_2.above_0, is_first_0);
    return cell_5;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S46 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S46.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S46.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_5 : u32,  first_3 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_3) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_5, last_0) - boundary_0(family_5, thread_5, first_3);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_6 : u32) -> Bend_0
{
    var _S47 : u32 = families_0[family_6].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S47);
    bend_0.half_tangent_0 = table_number_0(_S47 + u32(1));
    bend_0.arc_0 = table_number_0(_S47 + u32(2));
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
    var _S48 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S49 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S50 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S51 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S52 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S52;
    var _S53 : i32 = - _S48;
    var _S54 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S53, i32(0));
    run_0.from_start_0 = _S54;
    var _S55 : i32 = _S49 + i32(1);
    var _S56 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S55);
    run_0.to_end_0 = _S56;
    var _S57 : bool = _S54 < _S56;
    run_0.near_start_0 = _S57;
    var _S58 : i32 = select(_S55, _S53 - _S50, _S57);
    var _S59 : i32 = select(_S55 + _S51, _S53, _S57);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S54, _S56), 1.0e+06f, _S52);
    run_0.reach_0 = min(0.5f * (_S54 + _S56), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S58, _S59), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S48 == i32(0);
    run_0.last_crossing_0 = _S49 == i32(0);
    return run_0;
}

struct Section_0
{
     across_1 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_6 : Cell_0) -> Section_0
{
    var _S60 : f32 = cell_6.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S61 : f32 = clamp(cell_6.across_0, - cell_6.half_width_1, cell_6.half_width_1);
    section_0.across_1 = _S61;
    var _S62 : f32 = _S60 * _S60 - square_1(_S61);
    var _S63 : f32 = rsqrt_0(_S62);
    section_0.drop_0 = _S60 - _S62 * _S63;
    section_0.slope_0 = - _S61 * _S63;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S64 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S65 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S66 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S64) - crossed_1.half_width_1;
    var _S67 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S64);
    var _S68 : f32;
    if(shown_1.on_top_0)
    {
        _S68 = 0.0f;
    }
    else
    {
        _S68 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S69 : f32;
    if((shown_1.on_top_0) != _S67)
    {
        _S69 = 0.0f;
    }
    else
    {
        _S69 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S64));
    }
    var _S70 : f32 = 2.0f * _S66;
    var _S71 : f32 = 1.0f / max(_S70, 9.999999960041972e-13f);
    var _S72 : f32 = clamp((_S66 - _S65) * _S71, 0.0f, 1.0f);
    var _S73 : f32 = clamp((0.44999998807907104f - _S70 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S68 + (_S69 - _S68) * (_S72 * _S72 * (3.0f - 2.0f * _S72)), (_S68 - _S69) * (6.0f * _S72 * (1.0f - _S72) * _S71) * select(-1.0f, 1.0f, _S64), _S73 * _S73 * (3.0f - 2.0f * _S73));
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
    var _S74 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S74), 9.99999971718068537e-10f);
    var _S75 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S75), 9.99999971718068537e-10f);
    control_0.right_0 = _S74 > 0.0f;
    control_0.up_0 = _S75 > 0.0f;
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

fn outline_distance_0( cell_7 : Cell_0,  shown_2 : Shown_0,  run_2 : Run_0,  lengthwise_0 : bool,  forwards_0 : bool) -> f32
{
    var _S76 : f32 = select(- cell_7.across_0, cell_7.across_0, forwards_0);
    var _S77 : f32 = select(cell_7.below_0, cell_7.above_0, forwards_0);
    var _S78 : f32 = - cell_7.half_width_1;
    var _S79 : bool = _S76 < _S78;
    var _S80 : bool = _S76 >= (cell_7.half_width_1);
    var _S81 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_0)));
    var _S82 : f32 = select(cell_7.half_width_1, _S78, _S79) - _S76;
    var _S83 : f32 = select(_S77, 2.0f * _S77 + _S76 - cell_7.half_width_1, ((shown_2.hole_0) | (((_S81 & ((!shown_2.on_top_0)))))));
    if((((_S81 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S79)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S82, _S83, _S80);
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
    var _S84 : f32 = previous_1.rate_0 * step_4;
    var _S85 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_1)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S84) >= 0.0f) & (((3.0f * clearance_1 - _S85) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S86 : f32 = clearance_1 - previous_1.clearance_0;
    var _S87 : f32 = 6.0f * _S86 - 4.0f * _S84 - 2.0f * _S85;
    var _S88 : f32 = -2.0f * _S84 / max(_S87 + sqrt(max(_S87 * _S87 - 4.0f * (3.0f * (_S84 + _S85 - 2.0f * _S86)) * _S84, 0.0f)), 9.99999968265522539e-21f);
    var _S89 : f32 = 1.0f - _S88;
    return select(-1.0f, _S89 * step_4, ((((_S88 > 0.01999999955296516f) & ((_S89 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S88 + 1.0f) + _S84 * _S88) * _S89 * _S89 + (clearance_1 * (2.0f * _S89 + 1.0f) - _S85 * _S89) * _S88 * _S88) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_1.hole_1);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    previous_2.known_0 = ((!here_1.hole_1) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S90 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S90, 0.0f) + this_2.epsilon_0, _S90 - this_2.epsilon_0, ((((!here_2.hole_1) & (((rate_3 * _S90 + clearance_3) < 0.0f)))) & ((_S90 > (2.0f * this_2.epsilon_0))))));
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
    var _S91 : f32 = end_0 - start_1;
    var _S92 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S91;
    var _S93 : f32 = 3.0f * _S91 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S91, 9.99999968265522539e-21f);
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
        var _S94 : f32 = clamp(share_1 - (((_S92 * share_1 + _S93) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S92 * share_1 + 2.0f * _S93) * share_1 + start_rate_0, 0.10000000149011612f * _S91 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S95 : i32 = i_0 + i32(1);
        share_1 = _S94;
        i_0 = _S95;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S96 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S97 : f32 = rsqrt_0(_S96);
    var _S98 : f32 = sine_1 * _S97 * rsqrt_0(_S96 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S98 * _S96, _S98 * across_slope_0 * along_slope_0 + cosine_0 * _S97);
}

fn arc_sine_0( x_6 : f32) -> f32
{
    var _S99 : f32 = abs(x_6);
    var _S100 : bool = _S99 > 0.5f;
    var _S101 : f32 = select(_S99 * _S99, 0.5f * (1.0f - _S99), _S100);
    var _S102 : f32 = select(_S99, sqrt(max(_S101, 0.0f)), _S100);
    var _S103 : f32 = ((((0.04216320067644119f * _S101 + 0.02418131195008755f) * _S101 + 0.04547002539038658f) * _S101 + 0.07495300471782684f) * _S101 + 0.16666752099990845f) * _S101 * _S102 + _S102;
    var _S104 : f32 = select(_S103, 1.57079637050628662f - 2.0f * _S103, _S100);
    return select(_S104, - _S104, x_6 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S105 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S105 / (_S105 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S106 : f32 = direction_3.x;
    var _S107 : f32 = arc_sine_0(_S106);
    var _S108 : bool = _S106 < 0.0f;
    var _S109 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S108);
    var _S110 : f32 = direction_3.y;
    return select(0.5f * _S109 - select(1.0f, -1.0f, _S108) * arc_sine_0(_S110), select(_S107, _S109 - _S107, _S110 < 0.0f), (abs(_S106)) < 0.69999998807907104f);
}

struct Hair_0
{
     cover_0 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
     is_warp_1 : bool,
     shade_0 : f32,
};

fn Hair_x24init_0( cover_1 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  is_warp_2 : bool,  shade_1 : f32) -> Hair_0
{
    var _S111 : Hair_0;
    _S111.cover_0 = cover_1;
    _S111.normal_1 = normal_2;
    _S111.tangent_0 = tangent_1;
    _S111.is_warp_1 = is_warp_2;
    _S111.shade_0 = shade_1;
    return _S111;
}

fn fade_0( size_1 : f32,  period_1 : f32) -> f32
{
    return clamp((1.0f - size_1 / period_1) * 1.33333337306976318f, 0.0f, 1.0f);
}

fn share_of_0( bits_0 : u32) -> f32
{
    return (f32((bits_0 & (u32(1023)))) + 0.5f) * 0.0009765625f;
}

fn sine_cosine_0( x_7 : f32) -> vec2<f32>
{
    var _S112 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S113 : f32 = x_7 - _S112 * 1.5703125f - _S112 * 0.00048375129699707f - _S112 * 7.54979012640433211e-08f;
    var _S114 : f32 = _S113 * _S113;
    var _S115 : f32 = ((-0.00019515295571182f * _S114 + 0.00833216123282909f) * _S114 - 0.16666655242443085f) * _S114 * _S113 + _S113;
    var _S116 : f32 = ((0.00002443315679557f * _S114 - 0.00138873164542019f) * _S114 + 0.04166664555668831f) * _S114 * _S114 - 0.5f * _S114 + 1.0f;
    var _S117 : u32 = (u32(i32(_S112)) & (u32(3)));
    var _S118 : vec2<f32> = select_vector_1(((_S117 & (u32(1)))) != u32(0), vec2<f32>(_S116, _S115), vec2<f32>(_S115, _S116));
    var _S119 : f32 = _S118.x;
    var _S120 : f32 = _S118.y;
    return vec2<f32>(select(_S119, - _S119, ((_S117 & (u32(2)))) != u32(0)), select(_S120, - _S120, (((_S117 + u32(1)) & (u32(2)))) != u32(0)));
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
    var _S121 : f32 = floor(across_2 / width_2);
    return vec3<f32>(_S121, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S121, 2.0f * (across_2 / width_2 - _S121) - 1.0f);
}

struct SurfacePoint_0
{
     hole_2 : bool,
     is_warp_3 : bool,
     warp_thread_0 : u32,
     weft_thread_0 : u32,
     height_4 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     across_3 : f32,
     fibre_across_0 : f32,
     fibre_along_0 : f32,
     x_8 : f32,
     y_1 : f32,
     shown_share_0 : f32,
};

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S122 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S122 - floor(_S122)) - 1.0f;
}

fn groove_0( depth_0 : f32,  offset_1 : f32) -> vec2<f32>
{
    return vec2<f32>(depth_0) * vec2<f32>(0.1111111119389534f - square_1(square_1(square_1(offset_1))), 0.1111111119389534f);
}

fn signed_noise_0( bits_1 : u32) -> f32
{
    return (f32((bits_1 & (u32(65535)))) + 0.5f) * 0.000030517578125f - 1.0f;
}

fn smooth_share_0( share_2 : f32) -> f32
{
    return share_2 * share_2 * (3.0f - 2.0f * share_2);
}

fn wave_noise_0( key_3 : u32,  position_4 : f32) -> vec2<f32>
{
    var _S123 : f32 = floor(position_4);
    var _S124 : f32 = position_4 - _S123;
    var _S125 : u32 = u32(i32(_S123));
    var _S126 : f32 = signed_noise_0(hash_bits_0(key_3, _S125));
    var _S127 : f32 = signed_noise_0(hash_bits_0(key_3, _S125 + u32(1)));
    return vec2<f32>(mix(_S126, _S127, smooth_share_0(_S124)), 6.0f * _S124 * (1.0f - _S124) * (_S127 - _S126));
}

fn cell_noise_0( key_4 : u32,  cell_8 : vec3<f32>) -> vec2<f32>
{
    var _S128 : f32 = cell_8.y;
    var _S129 : f32 = floor(_S128);
    var _S130 : u32 = u32(i32(cell_8.x)) * u32(65536) + u32(i32(_S129));
    var _S131 : u32 = hash_bits_0(key_4, _S130);
    var _S132 : u32 = hash_bits_0(key_4, _S130 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S131), signed_noise_0((_S131 >> (u32(16))))), vec2<f32>(signed_noise_0(_S132), signed_noise_0((_S132 >> (u32(16))))), vec2<f32>(smooth_share_0(_S128 - _S129)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S133 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S133.x, _S133.y), _S133.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S134 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S134.x, _S134.y), _S134.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
}

fn fibre_gain_0( thread_11 : u32,  cell_9 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_9, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_4 : vec3<f32>,
     tangent_3 : vec3<f32>,
     loss_0 : f32,
     shade_2 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S135 : vec3<f32> = select_vector_0((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_0), hair_0.tangent_0);
    var blended_0 : YarnFrame_0;
    var _S136 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S137 : vec3<f32> = normalize(mix(frame_0.normal_4, hair_0.normal_1, _S136));
    blended_0.normal_4 = _S137;
    var _S138 : vec3<f32> = mix(frame_0.tangent_3, _S135, _S136);
    var _S139 : vec3<f32> = _S138 - vec3<f32>(dot(_S138, _S137)) * _S137;
    blended_0.tangent_3 = _S139 * vec3<f32>(rsqrt_0(max(dot(_S139, _S139), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    blended_0.shade_2 = hair_0.shade_0;
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f + frame_1.shade_2, 1.0f / (0.5f * blend_0 * (frame_1.normal_4.z - 1.0f) + 1.0f));
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
    var _S140 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S141 : vec3<f32> = sends_0.sky_warp_0 + _S140 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S141;
    var _S142 : vec3<f32> = sends_0.sky_weft_0 + _S140 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S142;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S141 + vec3<f32>(sends_0.blocks_weft_0) * _S142;
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
    var _S143 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S144 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S144 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S144 * interior_0.far_1 + yarn_2.back_5 * _S143;
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
        var _S145 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S145)) <= number_0)
        {
            low_0 = _S145;
        }
        else
        {
            high_0 = _S145;
        }
    }
    var _S146 : u32 = table_0 + low_0;
    var _S147 : f32 = scene_number_0(_S146);
    var _S148 : f32 = scene_number_0(_S146 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S147) / max(_S148 - _S147, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_1( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

struct Light_0
{
     is_point_0 : u32,
     x_9 : f32,
     y_2 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_4 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_4];
    record_1.x_9 = (bitcast<f32>((scene_words_0[first_4 + u32(1)])));
    record_1.y_2 = (bitcast<f32>((scene_words_0[first_4 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_4 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_4 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_4 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_4 + u32(6)])));
    return record_1;
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_5 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S149 : f32 = light_1.z;
    if(_S149 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S149, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S150 : f32 = dot(direction_4, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S150 * _S150 + 1.0f, roughness_1 * roughness_1));
}

fn mean_attenuation_0( depth_1 : f32) -> f32
{
    if(depth_1 < 0.10000000149011612f)
    {
        return (((depth_1 / 120.0f - 0.0416666679084301f) * depth_1 + 0.1666666716337204f) * depth_1 - 0.5f) * depth_1 + 1.0f;
    }
    return (1.0f - exponential_0(- depth_1)) / depth_1;
}

fn flake_density_0( squared_along_0 : f32,  roughness_2 : f32) -> f32
{
    var _S151 : f32 = roughness_2 * roughness_2;
    var _S152 : f32 = squared_along_0 * (1.0f - _S151) + _S151;
    return 0.31830987334251404f * _S151 * roughness_2 / (_S152 * _S152);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S153 : vec3<f32> = light_2 + view_1;
    var _S154 : f32 = dot(_S153, tangent_5);
    return flake_density_0(min(_S154 * _S154 / max(square_0(_S153), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S155 : f32 = dot(light_3, normal_6);
    var _S156 : f32 = dot(view_2, normal_6);
    if(((_S155 <= 0.0f) | ((_S156 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S157 : f32 = max(_S155, 9.99999997475242708e-07f);
    var _S158 : f32 = max(_S156, 9.99999997475242708e-07f);
    var _S159 : f32 = projected_area_1(light_3, tangent_6, roughness_4) * _S158 + projected_area_1(view_2, tangent_6, roughness_4) * _S157;
    var _S160 : f32 = optical_depth_1 * _S159 / (_S157 * _S158);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S160 * mean_attenuation_0(_S160)) * _S157 / _S159;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S161 : f32 = - dot(light_4, normal_7);
    var _S162 : f32 = dot(view_3, normal_7);
    if(((_S161 <= 0.0f) | ((_S162 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S163 : f32 = 1.0f / max(_S162, 9.99999997475242708e-07f);
    var _S164 : f32 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S161, 9.99999997475242708e-07f);
    var _S165 : f32 = projected_area_1(view_3, tangent_7, roughness_5) * _S163;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S164, _S165)) * mean_attenuation_0(optical_depth_2 * abs(_S164 - _S165)) * _S163;
}

fn sheen_scale_0( x_10 : f32,  y_3 : f32) -> f32
{
    return (((((0.0f * x_10 + (((((-1.1402510404586792f * y_3 + 0.40672621130943298f) * y_3 + 1.65398800373077393f) * y_3 + -1.29730904102325439f) * y_3 + 0.30570998787879944f) * y_3 + -0.0220868494361639f)) * x_10 + (((((-0.21142719686031342f * y_3 + 1.05947399139404297f) * y_3 + -0.41116121411323547f) * y_3 + -0.93859231472015381f) * y_3 + 0.51606941223144531f) * y_3 + 0.05409301072359085f)) * x_10 + (((((1.22944498062133789f * y_3 + -0.45962560176849365f) * y_3 + -1.63861405849456787f) * y_3 + 1.33565104007720947f) * y_3 + -0.45725581049919128f) * y_3 + 0.08243165910243988f)) * x_10 + (((((0.39779931306838989f * y_3 + -1.18879103660583496f) * y_3 + 0.28251591324806213f) * y_3 + 1.168984055519104f) * y_3 + -0.76864629983901978f) * y_3 + 0.0091691892594099f)) * x_10 + (((((-0.26563560962677002f * y_3 + -0.19379159808158875f) * y_3 + 0.2677634060382843f) * y_3 + 0.00270519289188087f) * y_3 + 0.14349560439586639f) * y_3 + 0.10290180146694183f)) * x_10 + (((((-0.20701569318771362f * y_3 + 0.24526430666446686f) * y_3 + 0.19551840424537659f) * y_3 + 0.07586126774549484f) * y_3 + 0.38894739747047424f) * y_3 + 0.15043120086193085f);
}

fn sheen_shear_0( x_11 : f32,  y_4 : f32) -> f32
{
    return ((((0.0f * x_11 + (((((-0.10608240216970444f * y_4 + 1.99214303493499756f) * y_4 + -1.42255294322967529f) * y_4 + -1.09495604038238525f) * y_4 + 0.59180057048797607f) * y_4 + 0.06902855634689331f)) * x_11 + (((((-0.46220690011978149f * y_4 + -0.29113379120826721f) * y_4 + 1.39025199413299561f) * y_4 + 0.35589990019798279f) * y_4 + -1.17120099067687988f) * y_4 + 0.15940259397029877f)) * x_11 + (((((2.26068711280822754f * y_4 + -3.64728999137878418f) * y_4 + -0.72173482179641724f) * y_4 + 3.07659196853637695f) * y_4 + -0.6827620267868042f) * y_4 + -0.3039557933807373f)) * x_11 + (((((0.81201767921447754f * y_4 + 0.36014080047607422f) * y_4 + -1.72646903991699219f) * y_4 + -0.22630110383033752f) * y_4 + 0.89514690637588501f) * y_4 + -0.10397960245609283f)) * x_11 + (((((-0.37648698687553406f * y_4 + 1.10974001884460449f) * y_4 + 0.17824520170688629f) * y_4 + -1.04968702793121338f) * y_4 + 0.1461234986782074f) * y_4 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_12 : f32,  y_5 : f32) -> f32
{
    return ((((0.0f * x_12 + (((((12.95646953582763672f * y_5 + -21.38032913208007812f) * y_5 + -7.37853097915649414f) * y_5 + 34.55607986450195312f) * y_5 + -23.61347007751464844f) * y_5 + 5.00126314163208008f)) * x_12 + (((((10.91487026214599609f * y_5 + -6.08202791213989258f) * y_5 + -38.2036285400390625f) * y_5 + 53.3440399169921875f) * y_5 + -21.91996002197265625f) * y_5 + 2.01606011390686035f)) * x_12 + (((((-14.52206039428710938f * y_5 + 36.803619384765625f) * y_5 + -22.94047927856445312f) * y_5 + -10.07973003387451172f) * y_5 + 15.77003955841064453f) * y_5 + -4.92722177505493164f)) * x_12 + (((((-7.62505722045898438f * y_5 + 1.27310299873352051f) * y_5 + 31.19523048400878906f) * y_5 + -44.39989852905273438f) * y_5 + 26.44947052001953125f) * y_5 + -8.73507976531982422f)) * x_12 + (((((5.65633487701416016f * y_5 + -17.66820907592773438f) * y_5 + 24.65356063842773438f) * y_5 + -19.38941001892089844f) * y_5 + 11.06159019470214844f) * y_5 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_6 : f32) -> vec3<f32>
{
    var _S166 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S167 : f32 = 2.0f * sqrt(_S166) - 1.0f;
    var _S168 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S167, _S168), 0.00999999977648258f, 1.0f), clamp((1.0f - _S166) * sheen_shear_0(_S167, _S168), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S167, _S168), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S169 : f32 = light_5.z;
    if(((_S169 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S170 : vec2<f32> = view_4.xy;
    var _S171 : f32 = dot(_S170, _S170);
    var _S172 : vec2<f32> = select_vector_1(_S171 > 9.99999968265522539e-21f, _S170 * vec2<f32>(rsqrt_0(max(_S171, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S173 : f32 = scale_0 * dot(light_5.xy, _S172) + shear_0 * _S169;
    var _S174 : f32 = scale_0 * (light_5.y * _S172.x - light_5.x * _S172.y);
    var _S175 : f32 = _S173 * _S173 + _S174 * _S174 + _S169 * _S169;
    return 0.31830987334251404f * scale_0 * scale_0 * _S169 / max(_S175 * _S175, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S176 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S177 : f32 = strength_0 * _S176.z;
    return vec2<f32>(_S177 * transformed_cosine_0(light_6, view_5, _S176.x, _S176.y), 1.0f - _S177);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S178 : f32 = light_7.z;
    return select_vector_0((_S178 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S178) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S179 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S179 * (1.0f - light_8.w);
    return;
}

fn camera_right_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.right_x_0, frame_record_0.right_y_0, frame_record_0.right_z_0);
}

fn camera_up_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.up_x_0, frame_record_0.up_y_0, frame_record_0.up_z_0);
}

fn camera_forward_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.forward_x_0, frame_record_0.forward_y_0, frame_record_0.forward_z_0);
}

fn camera_origin_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.origin_x_0, frame_record_0.origin_y_0, frame_record_0.origin_z_0);
}

fn uneven_shift_0( _S180 : u32,  _S181 : u32,  _S182 : u32,  _S183 : vec2<f32>) -> f32
{
    var _S184 : f32 = families_0[_S182].period_0 / families_0[_S182].count_0;
    var _S185 : u32 = hash_key_0(_S181, ((fabrics_0[_S180].seed_0) ^ (u32(625341585))));
    var _S186 : vec2<f32> = vec2<f32>(_S183.x, _S183.y / 4.0f) / vec2<f32>(_S184);
    return 0.20000000298023224f * sqrt(families_0[_S182].slub_0) * _S184 * (uneven_octave_0(_S185, _S186) * 0.66666668653488159f + uneven_octave_0(_S185 + u32(1), vec2<f32>(2.0f) * _S186 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S187 : u32,  _S188 : vec2<f32>) -> vec2<f32>
{
    return select_vector_1((fabrics_0[_S187].has_detail_0) == u32(0), _S188, _S188 + vec2<f32>(uneven_shift_0(_S187, u32(0), fabrics_0[_S187].warp_0, _S188), uneven_shift_0(_S187, u32(1), fabrics_0[_S187].weft_0, _S188.yx)));
}

fn face_point_0( _S189 : u32,  _S190 : u32,  _S191 : f32,  _S192 : f32) -> VisiblePoint_0
{
    var _S193 : u32 = u32(3) * _S190;
    var _S194 : Vertex_0 = vertex_at_0(_S193);
    var _S195 : Vertex_0 = vertex_at_0(_S193 + u32(1));
    var _S196 : Vertex_0 = vertex_at_0(_S193 + u32(2));
    var _S197 : vec3<f32> = position_of_0(_S194);
    var _S198 : vec3<f32> = position_of_0(_S195) - _S197;
    var _S199 : vec3<f32> = position_of_0(_S196) - _S197;
    var _S200 : f32 = _S195.u_0 - _S194.u_0;
    var _S201 : f32 = _S195.v_0 - _S194.v_0;
    var _S202 : vec2<f32> = vec2<f32>(_S200, _S201);
    var _S203 : f32 = _S196.u_0 - _S194.u_0;
    var _S204 : f32 = _S196.v_0 - _S194.v_0;
    var _S205 : vec2<f32> = vec2<f32>(_S203, _S204);
    var _S206 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S200 * _S204 - _S201 * _S203) < 0.0f));
    var _S207 : vec3<f32> = _S206 * (vec3<f32>(_S204) * _S198 - vec3<f32>(_S201) * _S199);
    var _S208 : vec3<f32> = _S206 * (vec3<f32>(_S200) * _S199 - vec3<f32>(_S203) * _S198);
    var point_2 : VisiblePoint_0;
    var _S209 : vec3<f32> = vec3<f32>(_S191);
    var _S210 : vec3<f32> = vec3<f32>(_S192);
    var _S211 : vec3<f32> = normalize(vec3<f32>((1.0f - _S191 - _S192)) * normal_of_0(_S194) + _S209 * normal_of_0(_S195) + _S210 * normal_of_0(_S196));
    point_2.normal_0 = _S211;
    var _S212 : vec3<f32> = normalize(_S207 - _S211 * vec3<f32>(dot(_S211, _S207)));
    point_2.axis_x_0 = _S212;
    point_2.axis_y_0 = cross(_S211, _S212);
    var _S213 : vec3<f32> = normalize(cross(_S198, _S199));
    point_2.face_normal_0 = select_vector_0((dot(_S213, _S211)) < 0.0f, (vec3<f32>(0) - _S213), _S213);
    point_2.position_0 = _S197 + _S209 * _S198 + _S210 * _S199;
    point_2.view_0 = _S211;
    var _S214 : vec2<f32> = vec2<f32>(_S194.u_0, _S194.v_0) + vec2<f32>(_S191) * _S202 + vec2<f32>(_S192) * _S205;
    point_2.uv_1 = _S214;
    var _S215 : bool = (dot(cross(_S207, _S208), _S211)) < 0.0f;
    var _S216 : vec2<f32> = vec2<f32>(fabrics_0[_S189].uv_width_0, select(fabrics_0[_S189].uv_height_0, - fabrics_0[_S189].uv_height_0, _S215));
    point_2.draft_per_uv_0 = _S216;
    point_2.draft_0 = uneven_place_0(_S189, _S214 * _S216 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S189].uv_height_0, _S215)));
    var _S217 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S217;
    point_2.draft_dy_0 = _S217;
    return point_2;
}

fn visible_point_0( _S218 : u32,  _S219 : u32,  _S220 : vec2<u32>) -> VisiblePoint_0
{
    var _S221 : u32 = u32(3) * _S219;
    var _S222 : Vertex_0 = vertex_at_0(_S221);
    var _S223 : Vertex_0 = vertex_at_0(_S221 + u32(1));
    var _S224 : Vertex_0 = vertex_at_0(_S221 + u32(2));
    var _S225 : vec3<f32> = position_of_0(_S222);
    var _S226 : vec3<f32> = position_of_0(_S223) - _S225;
    var _S227 : vec3<f32> = position_of_0(_S224) - _S225;
    var _S228 : vec3<f32> = cross(_S226, _S227);
    var _S229 : f32 = f32(frame_record_0.width_0);
    var _S230 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S229));
    var _S231 : f32 = f32(frame_record_0.height_0);
    var _S232 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S231));
    var _S233 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S220.x) + 0.5f - 0.5f * _S229)) * _S230 + vec3<f32>((f32(_S220.y) + 0.5f - 0.5f * _S231)) * _S232;
    var _S234 : f32 = dot(_S233, _S228);
    var _S235 : f32 = 1.0f / select(1.00000000317107685e-30f, _S234, (abs(_S234)) > 1.00000000317107685e-30f);
    var _S236 : vec3<f32> = _S225 - camera_origin_0();
    var _S237 : vec3<f32> = vec3<f32>((dot(_S236, _S228) * _S235));
    var _S238 : vec3<f32> = _S233 * _S237 - _S236;
    var _S239 : vec3<f32> = _S237 * (_S230 - _S233 * vec3<f32>((dot(_S230, _S228) * _S235)));
    var _S240 : vec3<f32> = _S237 * (_S232 - _S233 * vec3<f32>((dot(_S232, _S228) * _S235)));
    var _S241 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S228), 1.00000000317107685e-30f)));
    var _S242 : vec3<f32> = cross(_S227, _S228) * _S241;
    var _S243 : vec3<f32> = cross(_S228, _S226) * _S241;
    var _S244 : vec2<f32> = vec2<f32>(_S223.u_0 - _S222.u_0, _S223.v_0 - _S222.v_0);
    var _S245 : vec2<f32> = vec2<f32>(_S224.u_0 - _S222.u_0, _S224.v_0 - _S222.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S218, _S219, dot(_S238, _S242), dot(_S238, _S243));
    point_3.position_0 = _S225 + _S238;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S233));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S239, _S242)) * _S244 + vec2<f32>(dot(_S239, _S243)) * _S245) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S240, _S242)) * _S244 + vec2<f32>(dot(_S240, _S243)) * _S245) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S246 : u32,  _S247 : VisiblePoint_0) -> vec3<f32>
{
    var _S248 : u32 = fabrics_0[_S246].albedo_map_levels_0;
    if((fabrics_0[_S246].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S249 : vec2<f32> = vec2<f32>(fabrics_0[_S246].uv_width_0, fabrics_0[_S246].uv_height_0);
    var _S250 : vec2<f32> = _S247.draft_dx_0 / _S249;
    var _S251 : vec2<f32> = _S247.draft_dy_0 / _S249;
    var _S252 : u32 = _S248 - u32(1);
    var _S253 : u32 = (u32(1) << (_S252));
    var _S254 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S250.x * _S251.y - _S250.y * _S251.x), 9.99999968265522539e-21f) * (square_1(f32(_S253)) / 3.0f)), 0.0f, f32(_S248) - 1.0f);
    var _S255 : u32 = min(u32(_S254), max(_S248, u32(2)) - u32(2));
    var _S256 : u32 = min(_S255 + u32(1), _S252);
    var _S257 : u32 = (u32(1) << ((u32(2) * _S248)));
    return mix(map_level_0(fabrics_0[_S246].albedo_map_0 + (_S257 - ((_S257 >> ((u32(2) * _S255))))) / u32(3), (_S253 >> (_S255)), _S247.uv_1), map_level_0(fabrics_0[_S246].albedo_map_0 + (_S257 - ((_S257 >> ((u32(2) * _S256))))) / u32(3), (_S253 >> (_S256)), _S247.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S254 - f32(_S255))) - 1.0f) / 3.0f)));
}

struct Hairs_0
{
     place_1 : vec2<f32>,
     below_1 : f32,
     back_6 : bool,
     size_2 : f32,
};

struct YarnPoint_0
{
     back_7 : bool,
     hole_3 : bool,
     is_warp_4 : bool,
     x_13 : f32,
     y_6 : f32,
     height_5 : f32,
     normal_8 : vec3<f32>,
     tangent_8 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_8 : f32,
     albedos_2 : Albedos_0,
     hairs_0 : Hairs_0,
     hair_cover_0 : f32,
};

struct Hit_0
{
     x_14 : f32,
     y_7 : f32,
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
     dive_1 : vec3<f32>,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S258 : u32,  _S259 : f32,  _S260 : f32,  _S261 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S258].warp_0, _S259);
    crossing_2.weft_1 = locate_0(fabrics_0[_S258].weft_0, _S260);
    var _S262 : u32 = fabrics_0[_S258].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S258].ends_1 + crossing_2.warp_1.thread_2);
    var _S263 : u32 = words_0[_S262];
    crossing_2.warp_word_0 = _S263;
    crossing_2.weft_word_0 = words_0[_S262 + u32(1)];
    crossing_2.warp_above_0 = (((_S263 & (u32(1)))) == u32(1)) != _S261;
    return crossing_2;
}

fn sample_at_0( _S264 : u32,  _S265 : f32,  _S266 : f32,  _S267 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S268 : Crossing_0 = crossing_at_0(_S264, _S265, _S266, _S267);
    sample_0.crossing_1 = _S268;
    var _S269 : Shown_0 = shown_at_0(_S268, _S267);
    sample_0.shown_3 = _S269;
    var _S270 : u32 = select(fabrics_0[_S264].weft_0, fabrics_0[_S264].warp_0, _S269.is_warp_0);
    var _S271 : u32 = select(fabrics_0[_S264].warp_0, fabrics_0[_S264].weft_0, _S269.is_warp_0);
    var _S272 : Cell_0 = select_cell_0(_S269.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S273 : Cell_0 = select_cell_0(_S269.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S274 : Run_0 = unpack_0(_S270, _S271, _S272.thread_2, _S273, _S269.word_0);
    var _S275 : Section_0 = section_at_0(_S272);
    var _S276 : bool = ((_S269.on_top_0) & (((_S274.distance_0) < (_S275.drop_0 * _S274.bend_1.sine_0))));
    var _S277 : f32 = select(-1.0f, 1.0f, ((_S269.on_top_0) & ((!_S276))));
    var _S278 : f32 = select(_S274.reach_0, _S274.other_reach_0, _S276);
    var _S279 : f32 = select(max(_S278 - _S274.distance_0, 0.0f), _S278 + _S274.distance_0, _S276);
    var _S280 : f32 = _S278 / _S274.bend_1.sine_0 - _S277 * _S275.drop_0;
    var _S281 : f32 = _S279 * _S279;
    var _S282 : f32 = max(_S280 * _S280 - _S281, 9.99999968265522539e-21f);
    var _S283 : f32 = rsqrt_0(_S282);
    var _S284 : f32 = _S281 / (_S282 * _S283 + _S280);
    var _S285 : bool = _S279 > 0.0f;
    var _S286 : f32 = select(-1.0f, 1.0f, _S269.on_top_0) * select(-1.0f, 1.0f, _S274.near_start_0);
    var _S287 : f32 = _S275.slope_0 * select(1.0f, _S280 * _S283, _S285);
    sample_0.slope_across_0 = _S287;
    var _S288 : f32 = select(0.0f, _S286 * _S279 * _S283, _S285);
    sample_0.slope_along_0 = _S288;
    var _S289 : vec3<f32> = dive_0(_S271, _S269, _S274, _S273);
    sample_0.dive_1 = _S289;
    sample_0.height_7 = select(families_0[_S270].height_scale_0 * _S277, 0.0f, _S274.straight_0) * (_S278 * _S274.bend_1.half_tangent_0 - _S284) - families_0[_S270].height_scale_0 * _S275.drop_0 - _S289.x;
    var _S290 : f32 = families_0[_S270].height_scale_0 * _S287;
    var _S291 : f32 = families_0[_S270].height_scale_0 * _S288 - _S289.y;
    sample_0.slope_x_1 = select(_S291, _S290, _S269.is_warp_0);
    sample_0.slope_y_1 = select(_S290, _S291, _S269.is_warp_0);
    sample_0.run_3 = _S274;
    sample_0.section_1 = _S275;
    return sample_0;
}

fn steps_per_length_0( _S292 : u32,  _S293 : SearchQuality_0,  _S294 : vec3<f32>) -> f32
{
    return max(max(abs(_S294.x) * fabrics_0[_S292].threads_per_x_0, abs(_S294.y) * fabrics_0[_S292].threads_per_y_0) * _S293.steps_per_thread_0, abs(_S294.z) * fabrics_0[_S292].per_relief_0 * _S293.steps_per_relief_0);
}

fn cell_maximum_0( _S295 : u32,  _S296 : Crossing_0) -> f32
{
    var _S297 : u32 = select(fabrics_0[_S295].weft_0, fabrics_0[_S295].warp_0, _S296.warp_above_0);
    return f32((select(_S296.weft_word_0, _S296.warp_word_0, _S296.warp_above_0) >> (u32(28)))) * families_0[_S297].height_scale_0 * families_0[_S297].level_0;
}

fn probe_0( _S298 : u32,  _S299 : f32,  _S300 : f32,  _S301 : bool,  _S302 : bool,  _S303 : bool) -> Probe_0
{
    var _S304 : Sample_0 = sample_at_0(_S298, _S299, _S300, _S301);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S304.height_7;
    probe_1.hole_1 = _S304.shown_3.hole_0;
    probe_1.slope_x_0 = _S304.slope_x_1;
    probe_1.slope_y_0 = _S304.slope_y_1;
    probe_1.yarn_1 = select(_S304.crossing_1.weft_1.thread_2 * u32(2), _S304.crossing_1.warp_1.thread_2 * u32(2) + u32(1), _S304.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S298, _S304.crossing_1);
    probe_1.side_x_0 = select(_S304.crossing_1.warp_1.below_0, _S304.crossing_1.warp_1.above_0, _S302);
    probe_1.side_y_0 = select(_S304.crossing_1.weft_1.below_0, _S304.crossing_1.weft_1.above_0, _S303);
    probe_1.edge_x_0 = outline_distance_0(_S304.crossing_1.warp_1, _S304.shown_3, _S304.run_3, !_S304.shown_3.is_warp_0, _S302);
    probe_1.edge_y_0 = outline_distance_0(_S304.crossing_1.weft_1, _S304.shown_3, _S304.run_3, _S304.shown_3.is_warp_0, _S303);
    return probe_1;
}

fn is_free_0( _S305 : u32,  _S306 : SearchQuality_0,  _S307 : vec3<f32>,  _S308 : vec3<f32>,  _S309 : bool,  _S310 : f32) -> bool
{
    var _S311 : f32 = _S308.z;
    if(_S311 <= 0.0f)
    {
        return false;
    }
    var _S312 : f32 = 1.0f / max(_S306.shadow_share_0 * steps_per_length_0(_S305, _S306, _S308), 9.99999971718068537e-10f);
    var _S313 : StepControl_0 = step_control_0(_S308.xy, _S312);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S307.z + _S311 * distance_1) < _S310))))
        {
        }
        else
        {
            break;
        }
        var _S314 : vec3<f32> = _S307 + _S308 * vec3<f32>(distance_1);
        var _S315 : Probe_0 = probe_0(_S305, _S314.x, _S314.y, _S309, _S313.right_0, _S313.up_0);
        var _S316 : f32 = _S314.z;
        var _S317 : f32 = _S316 - _S315.height_2;
        var _S318 : f32 = _S311 - _S315.slope_x_0 * _S308.x - _S315.slope_y_0 * _S308.y;
        if(((!_S315.hole_1) & ((_S317 < 0.0f))))
        {
            return false;
        }
        var _S319 : f32 = way_back_to_dip_0(previous_3, _S317, _S318, last_step_0, _S315);
        if(_S319 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S319;
            distance_1 = distance_1 - _S319;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S320 : bool = _S316 > (_S315.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S313, _S315, _S317, _S318), max(StepControl_to_cell_exit_0(_S313, _S315.side_x_0, _S315.side_y_0), _S312), _S320);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S317, _S318, _S315, _S320);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S321 : u32,  _S322 : SearchQuality_0,  _S323 : f32,  _S324 : f32,  _S325 : vec3<f32>,  _S326 : bool) -> bool
{
    if(!sample_at_0(_S321, _S323, _S324, _S326).shown_3.hole_0)
    {
        return false;
    }
    var _S327 : vec3<f32> = vec3<f32>(_S323, _S324, 0.0f);
    var passes_0 : bool = true;
    var side_1 : u32 = u32(0);
    for(;;)
    {
        if(((side_1 < u32(2)) & (passes_0)))
        {
        }
        else
        {
            break;
        }
        var _S328 : bool = is_free_0(_S321, _S322, _S327, select_vector_0(side_1 == u32(0), _S325, vec3<f32>(- _S325.x, - _S325.y, _S325.z)), _S326 != (side_1 == u32(1)), fabrics_0[_S321].height_high_0);
        var _S329 : u32 = side_1 + u32(1);
        passes_0 = _S328;
        side_1 = _S329;
    }
    return passes_0;
}

struct ViewRayEnd_0
{
     height_8 : f32,
     last_step_3 : f32,
     depth_2 : f32,
     rate_4 : f32,
     smooth_0 : bool,
     previous_4 : PreviousSample_0,
};

fn max_height_along_0( _S330 : u32,  _S331 : f32,  _S332 : f32,  _S333 : f32,  _S334 : vec3<f32>,  _S335 : bool) -> f32
{
    var _S336 : f32 = _S334.x;
    var _S337 : f32 = _S334.y;
    var _S338 : u32 = (words_0[fabrics_0[_S330].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S330].weft_0, _S332).thread_2 / u32(2) * fabrics_0[_S330].max_height_columns_0 + locate_0(fabrics_0[_S330].warp_0, _S331).thread_2 / u32(2)) + (select(u32(0), u32(1), _S336 > 0.0f) + select(u32(0), u32(2), _S337 > 0.0f))] >> (u32(select(i32(0), i32(4), _S335))));
    var _S339 : f32 = max(abs(_S336) * fabrics_0[_S330].threads_per_x_0, abs(_S337) * fabrics_0[_S330].threads_per_y_0) / _S334.z;
    var _S340 : f32 = fabrics_0[_S330].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S330].height_high_0;
    var number_1 : i32 = i32(3);
    for(;;)
    {
        if(number_1 >= i32(0))
        {
        }
        else
        {
            break;
        }
        if(((max_height_0 - _S333) * _S339) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S338 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S340);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S341 : u32,  _S342 : f32,  _S343 : f32,  _S344 : bool,  _S345 : bool,  _S346 : bool) -> vec3<f32>
{
    var _S347 : Crossing_0 = crossing_at_0(_S341, _S342, _S343, _S344);
    return vec3<f32>(cell_maximum_0(_S341, _S347), select(_S347.warp_1.below_0, _S347.warp_1.above_0, _S345), select(_S347.weft_1.below_0, _S347.weft_1.above_0, _S346));
}

fn first_sample_height_0( _S348 : u32,  _S349 : ViewRay_0,  _S350 : StepControl_0,  _S351 : bool) -> f32
{
    var _S352 : f32 = max_height_along_0(_S348, _S349.origin_0.x, _S349.origin_0.y, 0.0f, vec3<f32>(_S349.slope_1, 1.0f), _S351);
    var count_3 : u32 = u32(0);
    var height_9 : f32 = _S352;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S353 : vec2<f32> = ViewRay_at_0(_S349, height_9);
        var _S354 : vec3<f32> = cell_bounds_0(_S348, _S353.x, _S353.y, _S351, _S350.right_0, _S350.up_0);
        var _S355 : f32 = height_9 - _S354.x;
        var _S356 : f32 = StepControl_to_cell_exit_0(_S350, _S354.y, _S354.z);
        var height_10 : f32 = height_9 - clamp(_S355, 0.0f, _S356);
        if(_S355 <= _S356)
        {
            height_9 = height_10;
            break;
        }
        count_3 = count_3 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S357 : u32,  _S358 : ViewRay_0,  _S359 : StepControl_0,  _S360 : bool) -> ViewRayEnd_0
{
    var _S361 : f32 = fabrics_0[_S357].height_low_0 - (fabrics_0[_S357].height_high_0 - fabrics_0[_S357].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S357, _S358, _S359, _S360);
    end_1.last_step_3 = _S359.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_2 = 0.0f;
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
        var _S362 : vec2<f32> = ViewRay_at_0(_S358, end_1.height_8);
        var _S363 : Probe_0 = probe_0(_S357, _S362.x, _S362.y, _S360, _S359.right_0, _S359.up_0);
        var _S364 : f32 = end_1.height_8 - _S363.height_2;
        var _S365 : f32 = ViewRay_rate_0(_S358, _S363);
        end_1.depth_2 = - _S364;
        end_1.rate_4 = _S365;
        var _S366 : bool = !_S363.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S366))) & (((end_1.previous_4.yarn_0) == (_S363.yarn_1))));
        if((((_S366 & ((_S364 <= 0.0f)))) | (((end_1.height_8) <= _S361))))
        {
            break;
        }
        var _S367 : f32 = way_back_to_dip_0(end_1.previous_4, _S364, _S365, end_1.last_step_3, _S363);
        if(_S367 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S367;
            end_1.last_step_3 = end_1.last_step_3 - _S367;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S368 : f32 = min(StepControl_to_cell_exit_0(_S359, _S363.side_x_0, _S363.side_y_0), end_1.height_8 - _S363.cell_max_0);
        var _S369 : f32 = StepControl_to_next_sample_0(_S359, _S363, _S364, _S365);
        end_1.previous_4 = after_sample_0(_S364, _S365, _S363, _S368 > _S369);
        var _S370 : f32 = max(_S368, _S369);
        end_1.last_step_3 = _S370;
        end_1.height_8 = end_1.height_8 - _S370;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S371 : u32,  _S372 : ViewRay_0,  _S373 : StepControl_0,  _S374 : bool,  _S375 : ViewRayEnd_0,  _S376 : u32) -> f32
{
    var _S377 : f32 = fabrics_0[_S371].height_high_0 - fabrics_0[_S371].height_low_0;
    var above_2 : f32 = _S375.height_8 + _S375.last_step_3;
    var above_gap_1 : f32 = clamp(_S375.previous_4.clearance_0, 0.0f, _S377);
    var under_gap_1 : f32 = clamp(_S375.depth_2, 0.0f, _S377);
    var middle_0 : f32 = select(between_0(above_2, _S375.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S375.previous_4.rate_0 * _S375.last_step_3, _S375.rate_4 * _S375.last_step_3) * _S375.last_step_3, _S375.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S375.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S376)
        {
        }
        else
        {
            break;
        }
        var _S378 : vec2<f32> = ViewRay_at_0(_S372, middle_0);
        var _S379 : Probe_0 = probe_0(_S371, _S378.x, _S378.y, _S374, _S373.right_0, _S373.up_0);
        var _S380 : f32 = clamp(middle_0 - select(_S379.height_2, -1.0e+09f, _S379.hole_1), - _S377, _S377);
        if(_S380 <= 0.0f)
        {
            var _S381 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S382 : f32 = - _S380;
            under_1 = middle_0;
            above_gap_2 = _S381;
            under_gap_2 = _S382;
            side_2 = 1.0f;
        }
        else
        {
            var _S383 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S380;
            under_gap_2 = _S383;
            side_2 = -1.0f;
        }
        var _S384 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S380 / min(ViewRay_rate_0(_S372, _S379), -9.99999997475242708e-07f), under_1, above_3), _S375.smooth_0);
        var _S385 : u32 = i_1 + u32(1);
        middle_0 = _S384;
        i_1 = _S385;
    }
    return select(under_1, middle_0, _S375.smooth_0);
}

fn first_hit_of_yarn_0( _S386 : u32,  _S387 : SearchQuality_0,  _S388 : f32,  _S389 : f32,  _S390 : vec3<f32>,  _S391 : bool) -> Hit_0
{
    var _S392 : f32 = max(_S390.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S388, _S389);
    var _S393 : vec2<f32> = _S390.xy / vec2<f32>(_S392);
    ray_0.slope_1 = _S393;
    var _S394 : StepControl_0 = step_control_0((vec2<f32>(0) - _S393), 1.0f / max(steps_per_length_0(_S386, _S387, _S390) / _S392, 9.99999971718068537e-10f));
    var _S395 : ViewRayEnd_0 = search_down_0(_S386, ray_0, _S394, _S391);
    var hit_0 : Hit_0;
    hit_0.hole_4 = false;
    var _S396 : f32 = refined_height_0(_S386, ray_0, _S394, _S391, _S395, _S387.refinements_0);
    hit_0.height_6 = _S396;
    var _S397 : vec2<f32> = ViewRay_at_0(ray_0, _S396);
    hit_0.x_14 = _S397.x;
    hit_0.y_7 = _S397.y;
    return hit_0;
}

fn first_hit_0( _S398 : u32,  _S399 : SearchQuality_0,  _S400 : f32,  _S401 : f32,  _S402 : vec3<f32>,  _S403 : bool) -> Hit_0
{
    if(!passes_through_0(_S398, _S399, _S400, _S401, _S402, _S403))
    {
        return first_hit_of_yarn_0(_S398, _S399, _S400, _S401, _S402, _S403);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S400;
    hit_1.y_7 = _S401;
    hit_1.height_6 = 0.0f;
    hit_1.hole_4 = true;
    return hit_1;
}

fn surface_of_0( _S404 : u32,  _S405 : Sample_0,  _S406 : f32,  _S407 : f32,  _S408 : bool) -> SurfacePoint_0
{
    var _S409 : u32 = select(fabrics_0[_S404].weft_0, fabrics_0[_S404].warp_0, _S405.shown_3.is_warp_0);
    var _S410 : f32 = families_0[_S409].twist_sine_0 * select(1.0f, -1.0f, _S408);
    var _S411 : f32 = select(-1.0f, 1.0f, _S405.shown_3.is_warp_0);
    var _S412 : vec2<f32> = fibre_direction_0(_S405.slope_across_0, _S411 * _S405.slope_along_0, _S410, families_0[_S409].twist_cosine_0);
    var _S413 : f32 = _S412.x;
    var _S414 : f32 = _S412.y;
    var _S415 : f32 = select(_S405.slope_y_1, _S405.slope_x_1, _S405.shown_3.is_warp_0) * _S413 + _S411 * select(_S405.slope_x_1, _S405.slope_y_1, _S405.shown_3.is_warp_0) * _S414;
    var _S416 : f32 = select(_S405.crossing_1.weft_1.half_width_1, _S405.crossing_1.warp_1.half_width_1, _S405.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S417 : f32 = _S416 * arc_sine_0(clamp(_S405.section_1.across_1 / _S416, -1.0f, 1.0f));
    var _S418 : f32 = select(- _S406, _S407, _S405.shown_3.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_2 = _S405.shown_3.hole_0;
    point_4.is_warp_3 = _S405.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S405.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S405.crossing_1.weft_1.thread_2;
    point_4.height_4 = _S405.height_7;
    point_4.normal_3 = normalize(vec3<f32>(- _S405.slope_x_1, - _S405.slope_y_1, 1.0f));
    point_4.tangent_2 = normalize(select_vector_0(_S405.shown_3.is_warp_0, vec3<f32>(_S413, _S414, _S415), vec3<f32>(- _S414, _S413, _S415)));
    point_4.across_3 = _S405.section_1.across_1;
    point_4.fibre_across_0 = _S417 * families_0[_S409].twist_cosine_0 + _S418 * _S410;
    point_4.fibre_along_0 = _S418 * families_0[_S409].twist_cosine_0 - _S417 * _S410;
    var _S419 : f32 = run_share_0(_S405.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S419, _S419, _S405.shown_3.on_top_0);
    point_4.x_8 = _S406;
    point_4.y_1 = _S407;
    return point_4;
}

fn surface_met_0( _S420 : u32,  _S421 : f32,  _S422 : f32,  _S423 : f32,  _S424 : vec3<f32>,  _S425 : bool) -> SurfacePoint_0
{
    var _S426 : Sample_0 = sample_at_0(_S420, _S421, _S422, _S425);
    var point_5 : SurfacePoint_0 = surface_of_0(_S420, _S426, _S421, _S422, _S425);
    var _S427 : u32 = select(fabrics_0[_S420].weft_0, fabrics_0[_S420].warp_0, point_5.is_warp_3);
    var _S428 : f32 = select(_S426.crossing_1.weft_1.half_width_1, _S426.crossing_1.warp_1.half_width_1, point_5.is_warp_3) * 1.0154266357421875f;
    var _S429 : f32 = _S426.dive_1.z;
    var _S430 : f32 = _S426.slope_along_0 - (1.0f - _S429) * _S426.dive_1.y / families_0[_S427].height_scale_0;
    var _S431 : f32 = rsqrt_0(_S430 * _S430 + 1.0f);
    var _S432 : f32 = _S424.x;
    var _S433 : f32 = _S424.y;
    var _S434 : f32 = select(_S433, _S432, point_5.is_warp_3);
    var _S435 : f32 = _S424.z;
    var _S436 : f32 = (_S435 / families_0[_S427].height_scale_0 - _S430 * select(_S432, _S433, point_5.is_warp_3)) * _S431;
    var _S437 : f32 = square_1(_S428);
    var _S438 : f32 = sqrt(max(_S437 - square_1(point_5.across_3), 0.0f)) - (_S426.height_7 + _S429 * _S426.dive_1.x - _S423) / families_0[_S427].height_scale_0 * _S431;
    var _S439 : f32 = square_1(_S434) + square_1(_S436) + 9.999999960041972e-13f;
    var _S440 : f32 = point_5.across_3 * _S434 + _S438 * _S436;
    var _S441 : f32 = square_1(point_5.across_3) + square_1(_S438) - _S437;
    var _S442 : f32 = sqrt(max(square_1(_S440) - _S439 * _S441, 0.0f));
    var _S443 : f32 = clamp(select((_S442 - _S440) / _S439, - _S441 / max(_S440 + _S442, 9.999999960041972e-13f), _S440 > 0.0f), - _S428, _S428);
    var _S444 : f32 = point_5.across_3 + _S443 * _S434;
    point_5.across_3 = _S444;
    var _S445 : vec2<f32> = normalize(vec2<f32>(_S444, _S438 + _S443 * _S436));
    var _S446 : f32 = select(-1.0f, 1.0f, point_5.is_warp_3);
    var _S447 : f32 = families_0[_S427].twist_sine_0 * select(1.0f, -1.0f, _S425);
    var _S448 : f32 = _S445.x;
    var _S449 : f32 = _S447 * _S448 * _S431;
    var _S450 : f32 = _S445.y;
    var _S451 : f32 = - _S447 * _S450;
    var _S452 : f32 = families_0[_S427].twist_cosine_0 * _S431 - _S446 * _S430 * _S449;
    var _S453 : f32 = families_0[_S427].height_scale_0 * (families_0[_S427].twist_cosine_0 * _S446 * _S430 * _S431 + _S449);
    var _S454 : f32 = families_0[_S427].height_scale_0 * _S448;
    var _S455 : f32 = - families_0[_S427].height_scale_0 * _S430 * _S431 * _S450;
    point_5.normal_3 = normalize(vec3<f32>(select(_S455, _S454, point_5.is_warp_3), select(_S454, _S455, point_5.is_warp_3), _S431 * _S450));
    point_5.tangent_2 = normalize(vec3<f32>(select(- _S452, _S451, point_5.is_warp_3), select(_S451, _S452, point_5.is_warp_3), _S453));
    var _S456 : f32 = _S428 * angle_of_0(_S445);
    var _S457 : f32 = select(- _S421 - _S443 * _S432, _S422 + _S443 * _S433, point_5.is_warp_3);
    point_5.fibre_across_0 = _S456 * families_0[_S427].twist_cosine_0 + _S457 * _S447;
    point_5.fibre_along_0 = _S457 * families_0[_S427].twist_cosine_0 - _S456 * _S447;
    var _S458 : f32 = 0.00999999977648258f * _S428;
    var _S459 : f32 = - _S458;
    var _S460 : bool = _S443 < _S459;
    var _S461 : f32 = select(_S458, _S459, _S434 < 0.0f);
    var _S462 : f32 = max(_S443, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S462 * _S432, select(0.0f, _S461, point_5.is_warp_3), _S460);
    point_5.y_1 = point_5.y_1 + select(_S462 * _S433, select(_S461, 0.0f, point_5.is_warp_3), _S460);
    point_5.height_4 = select(_S423 + _S443 * _S435, _S423, _S460);
    return point_5;
}

fn hairs_over_0( _S463 : u32,  _S464 : SurfacePoint_0,  _S465 : bool,  _S466 : f32) -> Hairs_0
{
    var hairs_1 : Hairs_0;
    hairs_1.place_1 = vec2<f32>(_S464.x_8, _S464.y_1);
    hairs_1.below_1 = fabrics_0[_S463].height_high_0 - _S464.height_4;
    hairs_1.back_6 = _S465;
    hairs_1.size_2 = _S466;
    return hairs_1;
}

fn has_hairs_0( _S467 : u32) -> bool
{
    return (((families_0[fabrics_0[_S467].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S467].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S468 : u32,  _S469 : Hairs_0,  _S470 : vec3<f32>,  _S471 : f32) -> Hair_0
{
    var _S472 : f32 = fabrics_0[_S468].fibre_size_0;
    var _S473 : f32 = 17.0f * fabrics_0[_S468].fibre_size_0;
    var _S474 : f32 = fade_0(_S471, _S473);
    var _S475 : vec2<f32> = _S470.xy / vec2<f32>(max(_S470.z, 0.3333333432674408f));
    var _S476 : u32 = hash_key_0(select(u32(0), u32(1), _S469.back_6), ((fabrics_0[_S468].seed_0) ^ (u32(1013904242))));
    var _S477 : f32 = fabrics_0[_S468].fibre_size_0 / max(_S471, 0.07000000029802322f * fabrics_0[_S468].fibre_size_0);
    const _S478 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S478;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_5 : bool = false;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S474 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S479 : u32 = number_2 / u32(9);
        var _S480 : u32 = number_2 / u32(3) - u32(3) * _S479;
        var _S481 : vec2<f32> = (vec2<f32>(((f32(_S479) * 6.0f + 2.0f) * _S472 + _S469.below_1)) * _S475 + _S469.place_1) / vec2<f32>(_S473);
        var _S482 : vec2<f32> = floor(_S481) + vec2<f32>(f32(number_2 - u32(3) * _S480 - u32(9) * _S479), f32(_S480)) - vec2<f32>(1.0f);
        var _S483 : u32 = hash_bits_0(_S476 + _S479, u32(i32(_S482.x)) * u32(65536) + u32(i32(_S482.y)));
        var _S484 : u32 = hash_bits_0(_S476, _S483);
        var _S485 : vec2<f32> = _S481 - _S482 - vec2<f32>(share_of_0(_S483), share_of_0((_S483 >> (u32(10)))));
        var _S486 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S483 >> (u32(20)))));
        var _S487 : f32 = mix(5.0f, 16.0f, share_of_0((_S484 >> (u32(10))))) / 17.0f;
        var _S488 : f32 = _S485.x;
        var _S489 : f32 = _S486.y;
        var _S490 : f32 = _S485.y;
        var _S491 : f32 = _S486.x;
        var _S492 : f32 = (_S488 * _S489 + _S490 * _S491) / _S487;
        var _S493 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S484 >> (u32(20)))) - 1.0f);
        var _S494 : f32 = 0.5f * (2.0f * share_of_0((_S483 ^ (_S484))) - 1.0f);
        var _S495 : f32 = _S492 * (3.0f * _S494 * _S492 + 2.0f * _S493);
        var _S496 : f32 = rsqrt_0(_S495 * _S495 + 1.0f);
        var _S497 : f32 = (_S490 * _S489 - _S488 * _S491 - _S487 * _S492 * _S492 * (_S494 * _S492 + _S493)) * _S496 * 17.0f;
        var _S498 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S492)), 0.0f) * _S477;
        var _S499 : f32 = clamp(_S498 + 0.5f - abs(_S497) * _S477, 0.0f, min(2.0f * _S498, 1.0f));
        var _S500 : bool = ((((_S484 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S501 : bool = (((((share_of_0(_S484)) < (families_0[select(fabrics_0[_S468].weft_0, fabrics_0[_S468].warp_0, _S500)].hairiness_0)) & (((abs(_S492)) < 1.0f)))) & ((_S499 > cover_2)));
        var _S502 : vec2<f32> = vec2<f32>(- _S491 - _S495 * _S489, _S489 - _S495 * _S491) * vec2<f32>(_S496);
        var _S503 : f32 = select(cover_2, _S499, _S501);
        var _S504 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S502.x, _S501), select(hair_across_0.y, _S502.y, _S501));
        var _S505 : f32 = select(hair_away_0, _S497, _S501);
        var _S506 : bool = select(is_warp_5, _S500, _S501);
        var _S507 : u32 = number_2 + u32(1);
        cover_2 = _S503;
        hair_across_0 = _S504;
        hair_away_0 = _S505;
        is_warp_5 = _S506;
        number_2 = _S507;
    }
    var _S508 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S474 * cover_2;
    hair_1.normal_1 = vec3<f32>(vec2<f32>(_S508) * hair_across_0, sqrt(1.0f - _S508 * _S508));
    hair_1.tangent_0 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_1 = is_warp_5;
    hair_1.shade_0 = _S474 * 0.03255363181233406f * (families_0[fabrics_0[_S468].warp_0].hairiness_0 + families_0[fabrics_0[_S468].weft_0].hairiness_0);
    return hair_1;
}

fn varies_at_0( _S509 : u32,  _S510 : f32) -> bool
{
    return (((((fabrics_0[_S509].fibre_noise_0) > 0.0f) | (((fabrics_0[_S509].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S509].has_detail_0) != u32(0)) & ((_S510 >= 0.0f))))));
}

fn thread_number_0( _S511 : u32,  _S512 : SurfacePoint_0) -> u32
{
    var _S513 : u32 = select(fabrics_0[_S511].weft_0, fabrics_0[_S511].warp_0, _S512.is_warp_3);
    return u32(i32(floor((select(_S512.y_1, _S512.x_8, _S512.is_warp_3) - _S512.across_3) / families_0[_S513].period_0)) * i32(families_0[_S513].count_0) + i32(select(_S512.weft_thread_0, _S512.warp_thread_0, _S512.is_warp_3))) * u32(2) + select(u32(0), u32(1), _S512.is_warp_3);
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     bundle_offset_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_2 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S514 : u32,  _S515 : u32,  _S516 : SurfacePoint_0,  _S517 : u32,  _S518 : f32) -> FibreNoise_0
{
    var _S519 : f32 = 5.0f * fabrics_0[_S514].fibre_size_0;
    var _S520 : vec2<f32> = wave_noise_0(hash_key_0(_S517, ((fabrics_0[_S514].seed_0) ^ (u32(458671337)))), _S516.fibre_along_0 / (25.0f * fabrics_0[_S514].fibre_size_0));
    var _S521 : f32 = _S516.fibre_across_0 + families_0[_S515].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S514].fibre_size_0 * _S520.x;
    var _S522 : vec3<f32> = fibre_cell_0(_S521, _S516.fibre_along_0, fabrics_0[_S514].fibre_size_0);
    var _S523 : vec3<f32> = fibre_cell_0(_S521, _S516.fibre_along_0, _S519);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S517, ((fabrics_0[_S514].seed_0) ^ (u32(1757159915)))), _S523);
    noise_0.bundle_offset_0 = _S523.z;
    noise_0.bundle_weight_0 = fade_0(_S518, _S519);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S517, ((fabrics_0[_S514].seed_0) ^ (u32(48610963)))), _S522);
    noise_0.fibre_weight_0 = fade_0(_S518, fabrics_0[_S514].fibre_size_0);
    noise_0.offset_2 = _S522.z;
    noise_0.slope_2 = 0.5f * _S520.y;
    return noise_0;
}

fn detail_gain_0( _S524 : u32,  _S525 : u32,  _S526 : SurfacePoint_0,  _S527 : bool,  _S528 : u32,  _S529 : f32) -> vec2<f32>
{
    var _S530 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S525].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S529, 1.0f / families_0[_S525].plies_per_mm_0), ply_offset_0(_S525, _S526, _S527));
    }
    else
    {
        gain_2 = _S530;
    }
    if((families_0[_S525].fibre_tone_0) > 0.0f)
    {
        var _S531 : FibreNoise_0 = fibre_noise_at_0(_S524, _S525, _S526, _S528, _S529);
        var _S532 : f32 = 4.5f * families_0[_S525].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S525].fibre_tone_0) * vec2<f32>(_S531.bundle_weight_0 * _S531.bundle_0.y + _S531.fibre_weight_0 * _S531.fibre_0.y, _S531.bundle_weight_0 + _S531.fibre_weight_0) + (groove_0(_S532 * (_S531.bundle_weight_0 * (0.5f * (_S531.bundle_0.x - 1.0f) + 1.0f)), _S531.bundle_offset_0) + groove_0(_S532 * _S531.fibre_weight_0, _S531.offset_2));
    }
    if((families_0[_S525].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S525].slub_0 * fade_0(_S529, 1.0f / families_0[_S525].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S528, ((fabrics_0[_S524].seed_0) ^ (u32(1373058189)))), select(- _S526.x_8, _S526.y_1, _S526.is_warp_3) * families_0[_S525].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S533 : u32,  _S534 : Albedos_0,  _S535 : u32,  _S536 : u32,  _S537 : vec2<f32>) -> Albedos_0
{
    var _S538 : vec3<f32> = max(_S534.specular_reflect_0, _S534.specular_transmit_0);
    var _S539 : vec3<f32> = _S534.diffuse_reflect_0 + _S534.diffuse_transmit_0;
    var _S540 : vec3<f32> = vec3<f32>(fabrics_0[_S533].layer_bound_0);
    var _S541 : vec3<f32> = vec3<f32>(1.0f);
    var _S542 : vec3<f32> = _S541 - _S540 * _S538;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S535, fabrics_0[_S533].colour_noise_0, fabrics_0[_S533].seed_0), _S539, _S542);
    var _S543 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S537.y, vec3<f32>(colour_1) * _S539, _S542) * _S537.x)));
    var _S544 : f32 = bounded_gain_0(fibre_gain_0(_S535, _S536, fabrics_0[_S533].fibre_noise_0, fabrics_0[_S533].seed_0), _S538, min((_S541 - _S543 * _S539) / _S540, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S543 * _S534.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S543 * _S534.diffuse_transmit_0;
    var _S545 : vec3<f32> = vec3<f32>(_S544);
    varied_0.specular_reflect_0 = _S545 * _S534.specular_reflect_0;
    varied_0.specular_transmit_0 = _S545 * _S534.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S546 : u32,  _S547 : SurfacePoint_0,  _S548 : Albedos_0,  _S549 : bool,  _S550 : f32,  _S551 : f32) -> Albedos_0
{
    var _S552 : u32 = thread_number_0(_S546, _S547);
    var _S553 : vec3<f32> = fibre_cell_0(_S547.fibre_across_0, _S547.fibre_along_0, fabrics_0[_S546].fibre_size_0);
    var _S554 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S546].has_detail_0) != u32(0)) & ((_S550 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S546, select(fabrics_0[_S546].weft_0, fabrics_0[_S546].warp_0, _S547.is_warp_3), _S547, _S549, _S552, _S550) * vec2<f32>(1.0f - _S551, 1.0f);
    }
    else
    {
        gain_3 = _S554;
    }
    return vary_albedos_0(_S546, _S548, _S552, u32(i32(_S553.x)) * u32(65536) + u32(i32(floor(_S553.y))), gain_3);
}

fn turned_frame_0( _S555 : u32,  _S556 : u32,  _S557 : SurfacePoint_0,  _S558 : bool,  _S559 : u32,  _S560 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_4 = _S557.normal_3;
    frame_2.tangent_3 = _S557.tangent_2;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S556].has_plies_0) > 0.0f)
    {
        var _S561 : f32 = fade_0(_S560, 1.0f / families_0[_S556].plies_per_mm_0);
        var _S562 : f32 = _S561 * 0.62000000476837158f * ply_offset_0(_S556, _S557, _S558);
        var _S563 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S564 : vec3<f32> = vec3<f32>(families_0[_S556].ply_cosine_0);
        var _S565 : vec3<f32> = vec3<f32>(select(families_0[_S556].ply_sine_0, - families_0[_S556].ply_sine_0, _S558));
        var _S566 : vec3<f32> = _S564 * _S563 + _S565 * frame_2.tangent_3;
        var _S567 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S562 * _S562));
        var _S568 : vec3<f32> = vec3<f32>(_S562);
        frame_2.tangent_3 = _S564 * (_S564 * frame_2.tangent_3 - _S565 * _S563) + _S565 * (_S567 * _S566 - _S568 * frame_2.normal_4);
        frame_2.normal_4 = _S567 * frame_2.normal_4 + _S568 * _S566;
        frame_2.loss_0 = _S561 * _S561 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S569 : f32 = families_0[_S556].fibre_tilt_0;
    if((families_0[_S556].fibre_tilt_0) > 0.0f)
    {
        var _S570 : FibreNoise_0 = fibre_noise_at_0(_S555, _S556, _S557, _S559, _S560);
        var _S571 : f32 = 1.09858846664428711f * _S569 * (_S570.bundle_weight_0 * _S570.bundle_0.x + _S570.fibre_weight_0 * (_S570.fibre_0.x + _S570.offset_2));
        var _S572 : f32 = _S569 * (1.42099642753601074f * (_S570.bundle_weight_0 * _S570.bundle_0.y + _S570.fibre_weight_0 * _S570.fibre_0.y) - _S570.bundle_weight_0 * _S570.slope_2);
        var _S573 : f32 = square_1(_S570.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S569 * _S569 * ((0.24761904776096344f * (square_1(_S570.bundle_weight_0) + _S573) + _S573 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S574 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S575 : vec2<f32> = sine_cosine_0(_S571);
        var _S576 : vec2<f32> = sine_cosine_0(_S572);
        var _S577 : vec3<f32> = vec3<f32>(_S575.y);
        var _S578 : vec3<f32> = vec3<f32>(_S575.x);
        var _S579 : vec3<f32> = _S577 * _S574 - _S578 * frame_2.normal_4;
        frame_2.normal_4 = _S577 * frame_2.normal_4 + _S578 * _S574;
        frame_2.tangent_3 = vec3<f32>(_S576.y) * frame_2.tangent_3 + vec3<f32>(_S576.x) * _S579;
    }
    return frame_2;
}

fn yarn_point_of_0( _S580 : u32,  _S581 : SurfacePoint_0,  _S582 : vec3<f32>,  _S583 : bool,  _S584 : bool,  _S585 : f32) -> YarnPoint_0
{
    var _S586 : u32 = fabrics_0[_S580].warp_0;
    var _S587 : u32 = fabrics_0[_S580].weft_0;
    var _S588 : u32 = select(fabrics_0[_S580].weft_0, fabrics_0[_S580].warp_0, _S581.is_warp_3);
    var _S589 : bool = (((fabrics_0[_S580].has_detail_0) != u32(0)) & ((_S585 >= 0.0f)));
    var point_6 : YarnPoint_0;
    point_6.hairs_0 = hairs_over_0(_S580, _S581, _S583, _S585);
    point_6.hair_cover_0 = 1.0f;
    var _S590 : vec3<f32> = vec3<f32>(0.0f);
    var _S591 : Hair_0 = Hair_x24init_0(0.0f, _S590, _S590, false, 0.0f);
    point_6.is_warp_4 = _S581.is_warp_3;
    var _S592 : bool = (_S589 & ((has_hairs_0(_S580))));
    var hair_2 : Hair_0;
    if(_S592)
    {
        var _S593 : Hair_0 = hair_towards_0(_S580, point_6.hairs_0, _S582, _S585);
        point_6.hair_cover_0 = _S593.cover_0;
        point_6.is_warp_4 = select(_S581.is_warp_3, _S593.is_warp_1, (_S593.cover_0) > 0.5f);
        hair_2 = _S593;
    }
    else
    {
        hair_2 = _S591;
    }
    var _S594 : u32 = select(_S587, _S586, point_6.is_warp_4);
    var albedos_3 : Albedos_0 = albedos_of_0(_S594, select(_S581.weft_thread_0, _S581.warp_thread_0, point_6.is_warp_4));
    var albedos_4 : Albedos_0;
    if(varies_at_0(_S580, _S585))
    {
        albedos_4 = varied_at_0(_S580, _S581, albedos_3, _S583, _S585, hair_2.cover_0);
    }
    else
    {
        albedos_4 = albedos_3;
    }
    point_6.back_7 = _S583;
    point_6.hole_3 = _S584;
    point_6.x_13 = _S581.x_8;
    point_6.y_6 = _S581.y_1;
    point_6.height_5 = _S581.height_4 + hair_2.cover_0 * point_6.hairs_0.below_1;
    point_6.normal_8 = _S581.normal_3;
    point_6.tangent_8 = _S581.tangent_2;
    point_6.surface_normal_0 = normalize(mix(_S581.normal_3, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_0)));
    point_6.diffuse_gain_1 = 1.0f;
    if(_S589)
    {
        var _S595 : YarnFrame_0 = turned_frame_0(_S580, _S588, _S581, _S583, thread_number_0(_S580, _S581), _S585);
        var frame_3 : YarnFrame_0;
        if(_S592)
        {
            frame_3 = under_hair_0(_S595, hair_2);
        }
        else
        {
            frame_3 = _S595;
        }
        point_6.normal_8 = frame_3.normal_4;
        point_6.tangent_8 = frame_3.tangent_3;
        point_6.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S580].diffuse_blend_0);
    }
    point_6.roughness_8 = families_0[_S594].roughness_0;
    point_6.albedos_2 = albedos_4;
    return point_6;
}

fn locate_yarn_0( _S596 : u32,  _S597 : SearchQuality_0,  _S598 : f32,  _S599 : f32,  _S600 : vec3<f32>,  _S601 : f32) -> YarnPoint_0
{
    var _S602 : bool = (_S600.z) < 0.0f;
    var _S603 : vec3<f32> = to_face_frame_0(_S600, _S602);
    var _S604 : Hit_0 = first_hit_0(_S596, _S597, _S598, _S599, _S603, _S602);
    return yarn_point_of_0(_S596, surface_met_0(_S596, _S604.x_14, _S604.y_7, _S604.height_6, _S603, _S602), _S603, _S602, _S604.hole_4, _S601);
}

fn openness_number_0( _S605 : u32,  _S606 : u32) -> f32
{
    return table_number_0(fabrics_0[_S605].openness_0 + _S606);
}

fn blocked_of_terms_0( _S607 : u32,  _S608 : u32,  _S609 : array<f32, i32(6)>,  _S610 : u32) -> Blocked_0
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
            if(term_0 < _S610)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S607, _S608 + share_3 * _S610 + term_0) * _S609[term_0];
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

fn blocked_at_0( _S611 : u32,  _S612 : bool,  _S613 : bool,  _S614 : f32,  _S615 : f32) -> Blocked_0
{
    var _S616 : f32 = _S615 * openness_number_0(_S611, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S614, _S616, _S614 * _S614, _S614 * _S616, _S616 * _S616 );
    return blocked_of_terms_0(_S611, u32(60) + (select(u32(0), u32(2), _S613) + select(u32(1), u32(0), _S612)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S617 : u32,  _S618 : Albedos_0,  _S619 : u32,  _S620 : vec3<f32>) -> Scattered_0
{
    var _S621 : u32 = u32(159) + u32(2) * _S619;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S620 * _S618.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S617, _S621)) * _S618.specular_reflect_0;
    yarn_3.through_0 = _S620 * _S618.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S617, _S621 + u32(1))) * _S618.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S622 : u32,  _S623 : u32,  _S624 : vec3<f32>,  _S625 : vec3<f32>,  _S626 : vec3<f32>,  _S627 : vec3<f32>,  _S628 : ptr<function, vec3<f32>>,  _S629 : ptr<function, vec3<f32>>)
{
    var _S630 : u32 = u32(146) + u32(4) * _S623;
    var _S631 : f32 = openness_number_0(_S622, _S630 + u32(1));
    var _S632 : f32 = openness_number_0(_S622, _S630 + u32(2));
    var _S633 : vec3<f32> = vec3<f32>(1.0f);
    var _S634 : vec3<f32> = _S633 - _S626 * vec3<f32>(openness_number_0(_S622, _S630));
    var _S635 : vec3<f32> = _S633 - _S627 * vec3<f32>(openness_number_0(_S622, _S630 + u32(3)));
    var _S636 : vec3<f32> = _S633 / (_S634 * _S635 - _S626 * _S627 * vec3<f32>((_S631 * _S632)));
    (*_S628) = (_S624 * _S635 + _S626 * vec3<f32>(_S631) * _S625) * _S636;
    (*_S629) = (_S625 * _S634 + _S627 * vec3<f32>(_S632) * _S624) * _S636;
    return;
}

fn face_sends_0( _S637 : u32,  _S638 : u32,  _S639 : Scattered_0,  _S640 : Scattered_0) -> FaceSends_0
{
    var _S641 : u32 = u32(2) * _S638;
    var _S642 : u32 = u32(142) + _S641;
    var _S643 : f32 = openness_number_0(_S637, _S642);
    var _S644 : f32 = openness_number_0(_S637, _S642 + u32(1));
    var _S645 : vec3<f32> = vec3<f32>((1.0f - _S643)) * _S639.back_5;
    var _S646 : vec3<f32> = vec3<f32>((1.0f - _S644)) * _S640.back_5;
    var sends_1 : FaceSends_0;
    var _S647 : u32 = u32(154) + _S641;
    var _S648 : f32 = openness_number_0(_S637, _S647);
    sends_1.blocks_warp_0 = _S648;
    var _S649 : f32 = openness_number_0(_S637, _S647 + u32(1));
    sends_1.blocks_weft_0 = _S649;
    sends_1.open_0 = _S648 * _S643 + _S649 * _S644;
    var _S650 : vec3<f32> = vec3<f32>(_S643) * _S639.back_5;
    var _S651 : vec3<f32> = vec3<f32>(_S644) * _S640.back_5;
    var _S652 : vec3<f32> = sends_1.sky_warp_0;
    var _S653 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S637, _S638, _S650, _S651, _S645, _S646, &(_S652), &(_S653));
    sends_1.sky_warp_0 = _S652;
    sends_1.sky_weft_0 = _S653;
    var _S654 : vec3<f32> = sends_1.crossing_warp_0;
    var _S655 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S637, _S638, _S639.through_0, _S640.through_0, _S645, _S646, &(_S654), &(_S655));
    sends_1.crossing_warp_0 = _S654;
    sends_1.crossing_weft_0 = _S655;
    return sends_1;
}

fn interior_of_0( _S656 : u32,  _S657 : vec3<f32>,  _S658 : bool) -> Interior_0
{
    var _S659 : Scattered_0 = scattered_by_0(_S656, table_albedos_0(families_0[fabrics_0[_S656].warp_0].colour_mean_0), u32(0), _S657);
    var _S660 : Scattered_0 = scattered_by_0(_S656, table_albedos_0(families_0[fabrics_0[_S656].weft_0].colour_mean_0), u32(1), _S657);
    var _S661 : FaceSends_0 = face_sends_0(_S656, select(u32(0), u32(1), _S658), _S659, _S660);
    var _S662 : FaceSends_0 = face_sends_0(_S656, select(u32(1), u32(0), _S658), _S659, _S660);
    var _S663 : vec3<f32> = vec3<f32>(_S661.blocks_warp_0);
    var _S664 : vec3<f32> = vec3<f32>(_S661.blocks_weft_0);
    var _S665 : vec3<f32> = _S663 * _S661.crossing_warp_0 + _S664 * _S661.crossing_weft_0;
    var _S666 : vec3<f32> = vec3<f32>(_S662.blocks_warp_0);
    var _S667 : vec3<f32> = vec3<f32>(_S662.blocks_weft_0);
    var _S668 : vec3<f32> = _S666 * _S662.crossing_warp_0 + _S667 * _S662.crossing_weft_0;
    var _S669 : f32 = 1.0f - _S661.open_0;
    var _S670 : f32 = 1.0f - _S662.open_0;
    var _S671 : vec3<f32> = vec3<f32>(1.0f);
    var _S672 : vec3<f32> = _S671 / (_S671 - _S665 * _S668 * vec3<f32>((_S669 * _S670)));
    var _S673 : vec3<f32> = _S668 * (vec3<f32>(_S661.open_0) + vec3<f32>(_S669) * (_S663 * _S661.sky_warp_0 + _S664 * _S661.sky_weft_0)) * _S672;
    var _S674 : vec3<f32> = _S665 * (vec3<f32>(_S662.open_0) + vec3<f32>(_S670) * (_S666 * _S662.sky_warp_0 + _S667 * _S662.sky_weft_0)) * _S672;
    var _S675 : FaceRadiance_0 = face_radiance_0(_S661, _S662.open_0, _S673, _S674);
    var _S676 : FaceRadiance_0 = face_radiance_0(_S662, _S661.open_0, _S674, _S673);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S675.warp_2;
    interior_1.weft_3 = _S675.weft_2;
    interior_1.leaked_1 = _S675.leaked_0;
    interior_1.far_1 = _S676.mean_0;
    interior_1.far_leaked_0 = _S676.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S677 : u32,  _S678 : YarnPoint_0,  _S679 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S680 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S680;
    nothing_0.transmitted_0 = _S680;
    if((((fabrics_0[_S677].openness_0) == u32(4294967295)) | ((_S678.hole_3))))
    {
        return nothing_0;
    }
    return bounced_by_0(blocked_at_0(_S677, _S678.is_warp_4, _S678.back_7, _S678.surface_normal_0.z, _S678.height_5), scattered_by_0(_S677, _S678.albedos_2, select(u32(1), u32(0), _S678.is_warp_4), _S679), interior_of_0(_S677, _S679, _S678.back_7));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S681 : u32,  _S682 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S681 * frame_record_0.height_0 + _S682.y) * frame_record_0.width_0 + _S682.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S683 : u32,  _S684 : u32) -> vec3<f32>
{
    var _S685 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S683 * frame_record_0.environment_columns_0 + _S684);
    return vec3<f32>(scene_number_0(_S685), scene_number_0(_S685 + u32(1)), scene_number_0(_S685 + u32(2)));
}

fn sample_environment_0( _S686 : vec2<f32>,  _S687 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S688 : u32 = frame_record_0.environment_rows_0;
    var _S689 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S686.y);
    var _S690 : u32 = frame_record_0.environment_columns_0;
    var _S691 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S689.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S686.x);
    var _S692 : vec3<f32> = environment_texel_0(_S689.index_6, _S691.index_6);
    (*_S687) = _S692 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S692), 9.99999968265522539e-21f)));
    var _S693 : f32 = 3.14159274101257324f / f32(_S688);
    var _S694 : f32 = mix(sine_cosine_0(f32(_S689.index_6) * _S693).y, sine_cosine_0(f32(_S689.index_6 + u32(1)) * _S693).y, _S689.remainder_0);
    var _S695 : f32 = sqrt(max(1.0f - _S694 * _S694, 0.0f));
    var _S696 : vec2<f32> = sine_cosine_0((f32(_S691.index_6) + _S691.remainder_0) * (6.28318548202514648f / f32(_S690)));
    var _S697 : f32 = _S695 * _S696.x;
    var _S698 : f32 = - _S695 * _S696.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S697 + frame_record_0.environment_sine_0 * _S698, _S694, frame_record_0.environment_cosine_0 * _S698 - frame_record_0.environment_sine_0 * _S697);
}

fn light_sample_0( _S699 : u32,  _S700 : vec2<u32>,  _S701 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S702 : u32 = frame_record_0.lights_0;
    if(_S699 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S703 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S700, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S699 - _S702), u32(3)), &(weight_0));
        sample_1.towards_0 = _S703;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S704 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S699);
    sample_1.irradiance_1 = vec3<f32>(_S704.red_0, _S704.green_0, _S704.blue_0);
    sample_1.towards_0 = vec3<f32>(_S704.x_9, _S704.y_2, _S704.z_1);
    if((_S704.is_point_0) != u32(0))
    {
        var _S705 : vec3<f32> = sample_1.towards_0 - _S701;
        var _S706 : f32 = max(square_0(_S705), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S706);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S706);
        sample_1.towards_0 = normalize(_S705);
    }
    return sample_1;
}

fn hairs_lit_0( _S707 : u32,  _S708 : Hairs_0,  _S709 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S707, _S708, _S709, _S708.size_2 + fabrics_0[_S707].fibre_size_0).cover_0;
}

fn under_hairs_0( _S710 : u32,  _S711 : YarnPoint_0,  _S712 : vec3<f32>) -> f32
{
    if((((_S711.hair_cover_0) >= 1.0f) | (((_S712.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S710, _S711.hairs_0, _S712), 1.0f, _S711.hair_cover_0);
}

fn scattered_0( _S713 : u32,  _S714 : YarnPoint_0,  _S715 : vec3<f32>,  _S716 : vec3<f32>) -> vec3<f32>
{
    var _S717 : vec3<f32> = vec3<f32>(0.0f);
    var _S718 : bool = !_S714.hole_3;
    var _S719 : f32 = _S715.z;
    var value_1 : vec3<f32>;
    if((_S718 & ((_S719 > 0.0f))))
    {
        value_1 = (_S714.albedos_2.diffuse_reflect_0 * vec3<f32>(_S714.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0(_S715, _S714.normal_8, fabrics_0[_S713].diffuse_blend_0)) + _S714.albedos_2.specular_reflect_0 * vec3<f32>(reflection_0(_S715, _S716, _S714.normal_8, _S714.tangent_8, _S714.roughness_8, fabrics_0[_S713].optical_depth_0))) * vec3<f32>(under_hairs_0(_S713, _S714, _S715));
    }
    else
    {
        if((_S718 & ((_S719 < 0.0f))))
        {
            value_1 = _S714.albedos_2.diffuse_transmit_0 * vec3<f32>(_S714.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S715), _S714.normal_8, fabrics_0[_S713].diffuse_blend_0)) + _S714.albedos_2.specular_transmit_0 * vec3<f32>(transmission_1(_S715, _S716, _S714.normal_8, _S714.tangent_8, _S714.roughness_8, fabrics_0[_S713].optical_depth_0));
        }
        else
        {
            value_1 = _S717;
        }
    }
    var _S720 : f32 = fabrics_0[_S713].sheen_strength_0;
    if((fabrics_0[_S713].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S721 : vec2<f32> = sheen_with_transmittance_0(_S715, _S716, _S720, fabrics_0[_S713].sheen_roughness_0);
    return vec3<f32>(_S721.y) * value_1 + vec3<f32>(_S721.x);
}

fn surface_at_0( _S722 : u32,  _S723 : f32,  _S724 : f32,  _S725 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S722, sample_at_0(_S722, _S723, _S724, _S725), _S723, _S724, _S725);
}

fn unoccluded_0( _S726 : u32,  _S727 : SearchQuality_0,  _S728 : f32,  _S729 : f32,  _S730 : f32,  _S731 : vec3<f32>,  _S732 : bool) -> bool
{
    if((_S731.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S726, _S727, vec3<f32>(_S728, _S729, _S730 + fabrics_0[_S726].lift_0), _S731, _S732, max_height_along_0(_S726, _S728, _S729, _S730, _S731, _S732));
}

fn is_lit_0( _S733 : u32,  _S734 : SearchQuality_0,  _S735 : YarnPoint_0,  _S736 : vec3<f32>) -> bool
{
    if(_S735.hole_3)
    {
        return true;
    }
    var _S737 : vec3<f32> = to_face_frame_0(_S736, _S735.back_7);
    var _S738 : f32 = _S737.z;
    var _S739 : bool = _S738 < 0.0f;
    var normal_9 : vec3<f32>;
    var height_11 : f32;
    if(_S739)
    {
        var _S740 : SurfacePoint_0 = surface_at_0(_S733, _S735.x_13, _S735.y_6, !_S735.back_7);
        normal_9 = _S740.normal_3;
        height_11 = _S740.height_4;
    }
    else
    {
        normal_9 = _S735.surface_normal_0;
        height_11 = _S735.height_5;
    }
    var _S741 : vec3<f32> = vec3<f32>(_S737.xy, abs(_S738));
    if((dot(normal_9, _S741)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S733, _S734, _S735.x_13, _S735.y_6, height_11, _S741, (_S735.back_7) != _S739);
}

fn evaluate_with_0( _S742 : u32,  _S743 : SearchQuality_0,  _S744 : YarnPoint_0,  _S745 : Bounced_0,  _S746 : vec3<f32>,  _S747 : vec3<f32>) -> vec3<f32>
{
    var _S748 : vec3<f32> = to_face_frame_0(_S747, _S744.back_7);
    var _S749 : vec3<f32> = scattered_0(_S742, _S744, to_face_frame_0(_S746, _S744.back_7), _S748);
    var _S750 : bool;
    if((max(_S749.x, max(_S749.y, _S749.z))) <= 0.0f)
    {
        _S750 = true;
    }
    else
    {
        _S750 = !is_lit_0(_S742, _S743, _S744, _S746);
    }
    var value_2 : vec3<f32>;
    if(_S750)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S749;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S745, _S746, _S747);
    var _S751 : f32 = fabrics_0[_S742].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S742].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S751 * sheen_lobe_0(abs(_S748.z), fabrics_0[_S742].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S752 : u32,  _S753 : YarnPoint_0,  _S754 : vec3<f32>) -> f32
{
    if(!_S753.hole_3)
    {
        return 0.0f;
    }
    var _S755 : f32 = fabrics_0[_S752].sheen_strength_0;
    if((fabrics_0[_S752].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S755 * sheen_lobe_0(abs(_S754.z), fabrics_0[_S752].sheen_roughness_0).z;
}

fn light_of_point_0( _S756 : u32,  _S757 : VisiblePoint_0,  _S758 : vec2<u32>,  _S759 : vec3<f32>,  _S760 : vec2<f32>) -> vec4<f32>
{
    var _S761 : SearchQuality_0 = default_quality_0();
    var _S762 : vec3<f32> = to_local_0(_S757, _S757.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S760;
    footprint_0.dx_0 = _S757.draft_dx_0;
    footprint_0.dy_0 = _S757.draft_dy_0;
    var _S763 : YarnPoint_0 = locate_yarn_0(_S756, _S761, _S760.x, _S760.y, _S762, Footprint_spread_side_0(footprint_0));
    var point_7 : YarnPoint_0 = _S763;
    var _S764 : Bounced_0 = bounced_at_0(_S756, _S763, _S759);
    point_7.albedos_2 = tinted_0(point_7.albedos_2, _S759);
    var _S765 : vec3<f32> = vec3<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S765;
    for(;;)
    {
        if(number_3 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S766 : f32 = visibility_at_0(number_3, _S758);
        if(_S766 <= 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S767 : LightSample_0 = light_sample_0(number_3, _S758, _S757.position_0);
        radiance_1 = radiance_1 + vec3<f32>(_S766) * _S767.irradiance_1 * evaluate_with_0(_S756, _S761, point_7, _S764, to_local_0(_S757, _S767.towards_0), _S762);
        number_3 = number_3 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S756, point_7, _S762));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S768 : u32 = id_0.x;
    var _S769 : bool;
    if(_S768 >= (frame_record_0.width_0))
    {
        _S769 = true;
    }
    else
    {
        _S769 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S769)
    {
        return;
    }
    var _S770 : vec2<u32> = id_0.xy;
    var _S771 : u32 = id_0.y * frame_record_0.width_0 + _S768;
    var _S772 : u32 = layers_0[_S771].face_0;
    if((layers_0[_S771].face_0) == u32(0))
    {
        return;
    }
    var _S773 : u32 = _S772 - u32(1);
    var _S774 : u32 = fabric_of_0(_S773);
    var _S775 : VisiblePoint_0 = visible_point_0(_S774, _S773, _S770);
    var _S776 : vec3<f32> = filtered_albedo_0(_S774, _S775);
    var _S777 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S777;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S778 : vec2<f32> = pixel_sequence_0(_S770, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S774, _S775, _S770, _S776, _S775.draft_0 + vec2<f32>(_S778.x) * _S775.draft_dx_0 + vec2<f32>(_S778.y) * _S775.draft_dy_0);
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S771, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

