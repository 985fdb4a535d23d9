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

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

@binding(2) @group(0) var<storage, read> words_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn select_vector_0( condition_0 : bool,  yes_0 : vec2<f32>,  no_0 : vec2<f32>) -> vec2<f32>
{
    var chosen_0 : vec2<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    return chosen_0;
}

fn rsqrt_0( x_0 : f32) -> f32
{
    return 1.0f / sqrt(x_0);
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec3<f32>,  no_1 : vec3<f32>) -> vec3<f32>
{
    var chosen_1 : vec3<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    chosen_1[i32(2)] = select(no_1[i32(2)], yes_1[i32(2)], condition_1);
    return chosen_1;
}

fn select_vector_2( condition_2 : bool,  yes_2 : vec4<u32>,  no_2 : vec4<u32>) -> vec4<u32>
{
    var chosen_2 : vec4<u32>;
    chosen_2[i32(0)] = select(no_2[i32(0)], yes_2[i32(0)], condition_2);
    chosen_2[i32(1)] = select(no_2[i32(1)], yes_2[i32(1)], condition_2);
    chosen_2[i32(2)] = select(no_2[i32(2)], yes_2[i32(2)], condition_2);
    chosen_2[i32(3)] = select(no_2[i32(3)], yes_2[i32(3)], condition_2);
    return chosen_2;
}

var<private> TAP_OFFSETS_0 : array<vec2<f32>, i32(9)> = array<vec2<f32>, i32(9)>( vec2<f32>(-0.3333333432674408f, -0.3333333432674408f), vec2<f32>(-0.3333333432674408f, 0.0f), vec2<f32>(-0.3333333432674408f, 0.3333333432674408f), vec2<f32>(0.0f, -0.3333333432674408f), vec2<f32>(0.0f, 0.0f), vec2<f32>(0.0f, 0.3333333432674408f), vec2<f32>(0.3333333432674408f, -0.3333333432674408f), vec2<f32>(0.3333333432674408f, 0.0f), vec2<f32>(0.3333333432674408f, 0.3333333432674408f) );
var<private> PYRAMID_RADII_0 : array<f32, i32(4)> = array<f32, i32(4)>( 1.0f, 2.0f, 4.0f, 8.0f );
var<private> POINT_OFFSETS_0 : array<vec2<f32>, i32(8)> = array<vec2<f32>, i32(8)>( vec2<f32>(0.0f, 0.0f), vec2<f32>(-0.23010000586509705f, 0.35670000314712524f), vec2<f32>(0.36809998750686646f, -0.22939999401569366f), vec2<f32>(-0.28040000796318054f, -0.34400001168251038f), vec2<f32>(0.3465999960899353f, 0.28859999775886536f), vec2<f32>(-0.36349999904632568f, 0.0511000007390976f), vec2<f32>(0.09929999709129333f, -0.35699999332427979f), vec2<f32>(0.10710000246763229f, 0.32879999279975891f) );
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
        var _S33 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S33)) <= number_0)
        {
            low_0 = _S33;
        }
        else
        {
            high_0 = _S33;
        }
    }
    var _S34 : u32 = table_0 + low_0;
    var _S35 : f32 = scene_number_0(_S34);
    var _S36 : f32 = scene_number_0(_S34 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_3 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S35) / max(_S36 - _S35, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_6 : f32) -> vec2<f32>
{
    var _S37 : f32 = floor(x_6 * 0.63661974668502808f + 0.5f);
    var _S38 : f32 = x_6 - _S37 * 1.5703125f - _S37 * 0.00048375129699707f - _S37 * 7.54979012640433211e-08f;
    var _S39 : f32 = _S38 * _S38;
    var _S40 : f32 = ((-0.00019515295571182f * _S39 + 0.00833216123282909f) * _S39 - 0.16666655242443085f) * _S39 * _S38 + _S38;
    var _S41 : f32 = ((0.00002443315679557f * _S39 - 0.00138873164542019f) * _S39 + 0.04166664555668831f) * _S39 * _S39 - 0.5f * _S39 + 1.0f;
    var _S42 : u32 = (u32(i32(_S37)) & (u32(3)));
    var _S43 : vec2<f32> = select_vector_0(((_S42 & (u32(1)))) != u32(0), vec2<f32>(_S41, _S40), vec2<f32>(_S40, _S41));
    var _S44 : f32 = _S43.x;
    var _S45 : f32 = _S43.y;
    return vec2<f32>(select(_S44, - _S44, ((_S42 & (u32(2)))) != u32(0)), select(_S45, - _S45, (((_S42 + u32(1)) & (u32(2)))) != u32(0)));
}

struct Light_0
{
     is_point_0 : u32,
     x_7 : f32,
     y_1 : f32,
     z_1 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_2 : u32) -> Light_0
{
    var record_1 : Light_0;
    record_1.is_point_0 = scene_words_0[first_2];
    record_1.x_7 = (bitcast<f32>((scene_words_0[first_2 + u32(1)])));
    record_1.y_1 = (bitcast<f32>((scene_words_0[first_2 + u32(2)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_2 + u32(3)])));
    record_1.red_0 = (bitcast<f32>((scene_words_0[first_2 + u32(4)])));
    record_1.green_0 = (bitcast<f32>((scene_words_0[first_2 + u32(5)])));
    record_1.blue_0 = (bitcast<f32>((scene_words_0[first_2 + u32(6)])));
    return record_1;
}

struct Footprint_0
{
     centre_0 : vec2<f32>,
     dx_0 : vec2<f32>,
     dy_0 : vec2<f32>,
};

fn Footprint_spread_side_0( this_0 : Footprint_0) -> f32
{
    var _S46 : vec2<f32> = this_0.dx_0;
    var _S47 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S46, _S46) + dot(_S47, _S47)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S48 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S48, - _S48, back_2));
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
     x_8 : f32,
     y_2 : f32,
     shown_share_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32,  x_9 : f32,  y_3 : f32,  shown_share_1 : f32) -> SurfacePoint_0
{
    var _S49 : SurfacePoint_0;
    _S49.hole_0 = hole_1;
    _S49.is_warp_0 = is_warp_1;
    _S49.warp_thread_0 = warp_thread_1;
    _S49.weft_thread_0 = weft_thread_1;
    _S49.height_2 = height_3;
    _S49.normal_1 = normal_2;
    _S49.tangent_0 = tangent_1;
    _S49.across_0 = across_1;
    _S49.fibre_across_0 = fibre_across_1;
    _S49.fibre_along_0 = fibre_along_1;
    _S49.x_8 = x_9;
    _S49.y_2 = y_3;
    _S49.shown_share_0 = shown_share_1;
    return _S49;
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
    var _S50 : Blocked_0 = no_blocked_0();
    nothing_2.warp_1 = _S50;
    nothing_2.weft_1 = _S50;
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
    var _S51 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S52 : f32 = mix(2.5f, 5.0f, _S51);
    quality_0.steps_per_thread_0 = _S52;
    quality_0.steps_per_relief_0 = _S52;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S51);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S51) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_4 : f32) -> vec2<f32>
{
    var _S53 : f32 = floor(fma(index_4, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S53, fma(- _S53, families_0[family_0].count_0, index_4));
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
    var _S54 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_3 : Cell_0;
    var _S55 : f32 = fma(- _S54, families_0[family_1].size_0, position_1);
    cell_3.below_0 = _S55;
    cell_3.above_0 = families_0[family_1].size_0 - _S55;
    cell_3.across_2 = _S55 - 0.5f * families_0[family_1].size_0;
    cell_3.half_width_1 = families_0[family_1].half_width_0;
    cell_3.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S54).y, 0.0f, families_0[family_1].count_0 - 1.0f));
    return cell_3;
}

fn table_number_0( index_5 : u32) -> f32
{
    return (bitcast<f32>((words_0[index_5])));
}

fn locate_varied_0( family_2 : u32,  position_2 : f32) -> Cell_0
{
    var turns_0 : f32 = (position_2 - families_0[family_2].start_0) * families_0[family_2].inverse_period_0;
    var turns_1 : f32 = turns_0 - floor(turns_0);
    var _S56 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S57 : u32 = min(thread_3 + select(u32(0), u32(1), _S56 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S58 : u32 = families_0[family_2].place_table_0 + _S57 * u32(4);
    var cell_4 : Cell_0;
    cell_4.thread_2 = _S57;
    cell_4.below_0 = _S56 - table_number_0(_S58);
    cell_4.above_0 = table_number_0(_S58 + u32(1)) - _S56;
    cell_4.across_2 = _S56 - table_number_0(_S58 + u32(2));
    cell_4.half_width_1 = table_number_0(_S58 + u32(3));
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
    var _S59 : bool = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S60 : bool = !((abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1));
    var _S61 : bool = (_S59 & (((_S60 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_2 = _S61;
    shown_0.hole_3 = ((!_S59) & (_S60));
    var _S62 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S61);
    shown_0.word_0 = _S62;
    shown_0.on_top_0 = (((_S62 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_3 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_5 : Cell_0;
    cell_5.thread_2 = select(second_0.thread_2, first_3.thread_2, is_first_0);
    cell_5.across_2 = select(second_0.across_2, first_3.across_2, is_first_0);
    cell_5.half_width_1 = select(second_0.half_width_1, first_3.half_width_1, is_first_0);
    cell_5.below_0 = select(second_0.below_0, first_3.below_0, is_first_0);
    cell_5.above_0 = select(second_0.above_0, first_3.above_0, is_first_0);
    return cell_5;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S63 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S63.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S63.y) * u32(4)));
}

fn span_0( family_5 : u32,  thread_5 : u32,  first_4 : i32,  last_0 : i32) -> f32
{
    if((families_0[family_5].is_alike_0) != u32(0))
    {
        return f32(last_0 - first_4) * families_0[family_5].size_0;
    }
    return boundary_0(family_5, thread_5, last_0) - boundary_0(family_5, thread_5, first_4);
}

struct Bend_0
{
     sine_0 : f32,
     half_tangent_0 : f32,
     arc_0 : f32,
};

fn bend_of_0( family_6 : u32,  thread_6 : u32) -> Bend_0
{
    var _S64 : u32 = families_0[family_6].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S64);
    bend_0.half_tangent_0 = table_number_0(_S64 + u32(1));
    bend_0.arc_0 = table_number_0(_S64 + u32(2));
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
    var _S65 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S66 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S67 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S68 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S69 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S69;
    var _S70 : i32 = - _S65;
    var _S71 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S70, i32(0));
    run_0.from_start_0 = _S71;
    var _S72 : i32 = _S66 + i32(1);
    var _S73 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S72);
    run_0.to_end_0 = _S73;
    var _S74 : bool = _S71 < _S73;
    run_0.near_start_0 = _S74;
    var _S75 : i32 = select(_S72, _S70 - _S67, _S74);
    var _S76 : i32 = select(_S72 + _S68, _S70, _S74);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S71, _S73), 1.0e+06f, _S69);
    run_0.reach_0 = min(0.5f * (_S71 + _S73), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S75, _S76), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S65 == i32(0);
    run_0.last_crossing_0 = _S66 == i32(0);
    return run_0;
}

struct Section_0
{
     across_3 : f32,
     drop_0 : f32,
     slope_0 : f32,
};

fn section_at_0( cell_6 : Cell_0) -> Section_0
{
    var _S77 : f32 = cell_6.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S78 : f32 = clamp(cell_6.across_2, - cell_6.half_width_1, cell_6.half_width_1);
    section_0.across_3 = _S78;
    var _S79 : f32 = _S77 * _S77 - square_1(_S78);
    var _S80 : f32 = rsqrt_0(_S79);
    section_0.drop_0 = _S77 - _S79 * _S80;
    section_0.slope_0 = - _S78 * _S80;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S81 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S82 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S83 : f32 = select(crossed_1.above_0 + crossed_1.across_2, crossed_1.below_0 - crossed_1.across_2, _S81) - crossed_1.half_width_1;
    var _S84 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S81);
    var _S85 : f32;
    if(shown_1.on_top_0)
    {
        _S85 = 0.0f;
    }
    else
    {
        _S85 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S86 : f32;
    if((shown_1.on_top_0) != _S84)
    {
        _S86 = 0.0f;
    }
    else
    {
        _S86 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S81));
    }
    var _S87 : f32 = 2.0f * _S83;
    var _S88 : f32 = 1.0f / max(_S87, 9.999999960041972e-13f);
    var _S89 : f32 = clamp((_S83 - _S82) * _S88, 0.0f, 1.0f);
    var _S90 : f32 = clamp((0.44999998807907104f - _S87 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S85 + (_S86 - _S85) * (_S89 * _S89 * (3.0f - 2.0f * _S89)), (_S85 - _S86) * (6.0f * _S89 * (1.0f - _S89) * _S88) * select(-1.0f, 1.0f, _S81), _S90 * _S90 * (3.0f - 2.0f * _S90));
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
    var _S91 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S91), 9.99999971718068537e-10f);
    var _S92 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S92), 9.99999971718068537e-10f);
    control_0.right_0 = _S91 > 0.0f;
    control_0.up_0 = _S92 > 0.0f;
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
    var _S93 : f32 = select(- cell_7.across_2, cell_7.across_2, forwards_0);
    var _S94 : f32 = select(cell_7.below_0, cell_7.above_0, forwards_0);
    var _S95 : f32 = - cell_7.half_width_1;
    var _S96 : bool = _S93 < _S95;
    var _S97 : bool = _S93 >= (cell_7.half_width_1);
    var _S98 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_3)));
    var _S99 : f32 = select(cell_7.half_width_1, _S95, _S96) - _S93;
    var _S100 : f32 = select(_S94, 2.0f * _S94 + _S93 - cell_7.half_width_1, ((shown_2.hole_3) | (((_S98 & ((!shown_2.on_top_0)))))));
    if((((_S98 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S96)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S99, _S100, _S97);
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
    var _S101 : f32 = previous_1.rate_0 * step_4;
    var _S102 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_4)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S101) >= 0.0f) & (((3.0f * clearance_1 - _S102) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S103 : f32 = clearance_1 - previous_1.clearance_0;
    var _S104 : f32 = 6.0f * _S103 - 4.0f * _S101 - 2.0f * _S102;
    var _S105 : f32 = -2.0f * _S101 / max(_S104 + sqrt(max(_S104 * _S104 - 4.0f * (3.0f * (_S101 + _S102 - 2.0f * _S103)) * _S101, 0.0f)), 9.99999968265522539e-21f);
    var _S106 : f32 = 1.0f - _S105;
    return select(-1.0f, _S106 * step_4, ((((_S105 > 0.01999999955296516f) & ((_S106 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S105 + 1.0f) + _S101 * _S105) * _S106 * _S106 + (clearance_1 * (2.0f * _S106 + 1.0f) - _S102 * _S106) * _S105 * _S105) < 0.0f))));
}

fn after_sample_0( clearance_2 : f32,  rate_2 : f32,  here_1 : Probe_0,  is_cell_exit_0 : bool) -> PreviousSample_0
{
    var previous_2 : PreviousSample_0;
    previous_2.clearance_0 = select(clearance_2, 1.0e+09f, here_1.hole_4);
    previous_2.rate_0 = rate_2;
    previous_2.yarn_0 = here_1.yarn_1;
    previous_2.known_0 = ((!here_1.hole_4) & ((!is_cell_exit_0)));
    return previous_2;
}

fn StepControl_to_cell_exit_0( this_1 : StepControl_0,  side_x_1 : f32,  side_y_1 : f32) -> f32
{
    return max(min(side_x_1 * this_1.per_x_0, side_y_1 * this_1.per_y_0), 0.0f) + this_1.epsilon_0;
}

fn StepControl_to_next_sample_0( this_2 : StepControl_0,  here_2 : Probe_0,  clearance_3 : f32,  rate_3 : f32) -> f32
{
    var _S107 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S107, 0.0f) + this_2.epsilon_0, _S107 - this_2.epsilon_0, ((((!here_2.hole_4) & (((rate_3 * _S107 + clearance_3) < 0.0f)))) & ((_S107 > (2.0f * this_2.epsilon_0))))));
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
    var _S108 : f32 = end_0 - start_1;
    var _S109 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S108;
    var _S110 : f32 = 3.0f * _S108 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S108, 9.99999968265522539e-21f);
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
        var _S111 : f32 = clamp(share_1 - (((_S109 * share_1 + _S110) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S109 * share_1 + 2.0f * _S110) * share_1 + start_rate_0, 0.10000000149011612f * _S108 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S112 : i32 = i_0 + i32(1);
        share_1 = _S111;
        i_0 = _S112;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S113 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S114 : f32 = rsqrt_0(_S113);
    var _S115 : f32 = sine_1 * _S114 * rsqrt_0(_S113 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S115 * _S113, _S115 * across_slope_0 * along_slope_0 + cosine_0 * _S114);
}

fn arc_sine_0( x_10 : f32) -> f32
{
    var _S116 : f32 = abs(x_10);
    var _S117 : bool = _S116 > 0.5f;
    var _S118 : f32 = select(_S116 * _S116, 0.5f * (1.0f - _S116), _S117);
    var _S119 : f32 = select(_S116, sqrt(max(_S118, 0.0f)), _S117);
    var _S120 : f32 = ((((0.04216320067644119f * _S118 + 0.02418131195008755f) * _S118 + 0.04547002539038658f) * _S118 + 0.07495300471782684f) * _S118 + 0.16666752099990845f) * _S118 * _S119 + _S119;
    var _S121 : f32 = select(_S120, 1.57079637050628662f - 2.0f * _S120, _S117);
    return select(_S121, - _S121, x_10 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S122 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S122 / (_S122 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S123 : f32 = direction_3.x;
    var _S124 : f32 = arc_sine_0(_S123);
    var _S125 : bool = _S123 < 0.0f;
    var _S126 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S125);
    var _S127 : f32 = direction_3.y;
    return select(0.5f * _S126 - select(1.0f, -1.0f, _S125) * arc_sine_0(_S127), select(_S124, _S126 - _S124, _S127 < 0.0f), (abs(_S123)) < 0.69999998807907104f);
}

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
     is_warp_3 : bool,
     shade_0 : f32,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>,  is_warp_4 : bool,  shade_1 : f32) -> Hair_0
{
    var _S128 : Hair_0;
    _S128.cover_0 = cover_1;
    _S128.normal_3 = normal_4;
    _S128.tangent_2 = tangent_3;
    _S128.is_warp_3 = is_warp_4;
    _S128.shade_0 = shade_1;
    return _S128;
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
    var _S129 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S129, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S129, 2.0f * (across_4 / width_2 - _S129) - 1.0f);
}

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S130 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S130 - floor(_S130)) - 1.0f;
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
    var _S131 : f32 = floor(position_4);
    var _S132 : f32 = position_4 - _S131;
    var _S133 : u32 = u32(i32(_S131));
    var _S134 : f32 = signed_noise_0(hash_bits_0(key_3, _S133));
    var _S135 : f32 = signed_noise_0(hash_bits_0(key_3, _S133 + u32(1)));
    return vec2<f32>(mix(_S134, _S135, smooth_share_0(_S132)), 6.0f * _S132 * (1.0f - _S132) * (_S135 - _S134));
}

fn cell_noise_0( key_4 : u32,  cell_8 : vec3<f32>) -> vec2<f32>
{
    var _S136 : f32 = cell_8.y;
    var _S137 : f32 = floor(_S136);
    var _S138 : u32 = u32(i32(cell_8.x)) * u32(65536) + u32(i32(_S137));
    var _S139 : u32 = hash_bits_0(key_4, _S138);
    var _S140 : u32 = hash_bits_0(key_4, _S138 + u32(1));
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

fn fibre_gain_0( thread_11 : u32,  cell_9 : u32,  amount_1 : f32,  seed_2 : u32) -> f32
{
    return amount_1 * (min(- natural_logarithm_0(uniform_hash_0(thread_11, cell_9, (seed_2 ^ (u32(2654435769))))), 10.0f) - 1.0f) + 1.0f;
}

struct YarnFrame_0
{
     normal_5 : vec3<f32>,
     tangent_4 : vec3<f32>,
     loss_0 : f32,
     shade_2 : f32,
};

fn under_hair_0( frame_0 : YarnFrame_0,  hair_0 : Hair_0) -> YarnFrame_0
{
    var _S143 : vec3<f32> = select_vector_1((dot(frame_0.tangent_4, hair_0.tangent_2)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_2), hair_0.tangent_2);
    var blended_0 : YarnFrame_0;
    var _S144 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S145 : vec3<f32> = normalize(mix(frame_0.normal_5, hair_0.normal_3, _S144));
    blended_0.normal_5 = _S145;
    var _S146 : vec3<f32> = mix(frame_0.tangent_4, _S143, _S144);
    var _S147 : vec3<f32> = _S146 - vec3<f32>(dot(_S146, _S145)) * _S145;
    blended_0.tangent_4 = _S147 * vec3<f32>(rsqrt_0(max(dot(_S147, _S147), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    blended_0.shade_2 = hair_0.shade_0;
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f + frame_1.shade_2, 1.0f / (0.5f * blend_0 * (frame_1.normal_5.z - 1.0f) + 1.0f));
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_6 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S148 : f32 = light_1.z;
    if(_S148 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S148, 0.0f), max(dot(light_1, normal_6), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S149 : f32 = dot(direction_4, tangent_5);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S149 * _S149 + 1.0f, roughness_1 * roughness_1));
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
    var _S150 : f32 = roughness_2 * roughness_2;
    var _S151 : f32 = squared_along_0 * (1.0f - _S150) + _S150;
    return 0.31830987334251404f * _S150 * roughness_2 / (_S151 * _S151);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S152 : vec3<f32> = light_2 + view_1;
    var _S153 : f32 = dot(_S152, tangent_6);
    return flake_density_0(min(_S153 * _S153 / max(square_0(_S152), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S154 : f32 = - dot(light_3, normal_7);
    var _S155 : f32 = dot(view_2, normal_7);
    if(((_S154 <= 0.0f) | ((_S155 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S156 : f32 = 1.0f / max(_S155, 9.99999997475242708e-07f);
    var _S157 : f32 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S154, 9.99999997475242708e-07f);
    var _S158 : f32 = projected_area_1(view_2, tangent_7, roughness_4) * _S156;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S157, _S158)) * mean_attenuation_0(optical_depth_1 * abs(_S157 - _S158)) * _S156;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S159 : f32 = dot(light_4, normal_8);
    var _S160 : f32 = dot(view_3, normal_8);
    if(((_S159 <= 0.0f) | ((_S160 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S161 : f32 = max(_S159, 9.99999997475242708e-07f);
    var _S162 : f32 = max(_S160, 9.99999997475242708e-07f);
    var _S163 : f32 = projected_area_1(light_4, tangent_8, roughness_5) * _S162 + projected_area_1(view_3, tangent_8, roughness_5) * _S161;
    var _S164 : f32 = optical_depth_2 * _S163 / (_S161 * _S162);
    return 0.25f * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S164 * mean_attenuation_0(_S164)) * _S161 / _S163;
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

fn arc_tangent_quotient_0( x_11 : f32,  y_4 : f32) -> f32
{
    return ((((((0.0f * x_11 + 0.00809729471802711f) * x_11 + -0.0377517081797123f) * x_11 + 0.08475969731807709f) * x_11 + -0.13537675142288208f) * x_11 + 0.19895026087760925f) * x_11 + -0.33327975869178772f) * x_11 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_5 : f32,  x_12 : f32) -> f32
{
    var _S165 : f32 = abs(x_12);
    var _S166 : f32 = abs(y_5);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S165, _S166) / max(max(_S165, _S166), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S166 > _S165);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_12 < 0.0f);
    return select(angle_2, - angle_2, y_5 < 0.0f);
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_of_0( direction_5 : vec3<f32>,  azimuths_0 : u32) -> NodeTaps_0
{
    var _S167 : f32 = arc_tangent_0(direction_5.y, direction_5.x) * (0.5f * f32(azimuths_0) * 0.31830987334251404f);
    var _S168 : f32 = floor(_S167);
    var _S169 : f32 = _S167 - _S168;
    var _S170 : f32 = sqrt(clamp((1.0f - abs(direction_5.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S171 : f32 = 7.0f * _S170 * sqrt(_S170);
    var _S172 : f32 = min(floor(_S171), 6.0f);
    var _S173 : f32 = _S171 - _S172;
    var _S174 : u32 = u32(i32(_S168) + i32(azimuths_0)) % azimuths_0;
    var _S175 : u32 = u32(_S172);
    var _S176 : u32 = _S174 * u32(8) + _S175;
    var _S177 : u32 = (_S174 + u32(1)) % azimuths_0;
    var _S178 : u32 = _S177 * u32(8) + _S175;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S176, _S176 + u32(1), _S178, _S178 + u32(1));
    var _S179 : f32 = 1.0f - _S169;
    var _S180 : f32 = 1.0f - _S173;
    var _S181 : vec4<u32> = vec4<u32>(vec4<f32>(_S179 * _S180, _S179 * _S173, _S169 * _S180, _S169 * _S173) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S181;
    taps_0.inverse_sum_0 = 1.0f / f32(_S181.x + _S181.y + _S181.z + _S181.w);
    return taps_0;
}

fn node_taps_0( direction_6 : vec3<f32>) -> NodeTaps_0
{
    var _S182 : NodeTaps_0 = node_taps_of_0(direction_6, u32(32));
    return _S182;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S183 : vec3<f32> = light_5 + view_4;
    return _S183 * vec3<f32>(rsqrt_0(max(square_0(_S183), 9.999999960041972e-13f)));
}

fn joint_terms_0( taps_1 : NodeTaps_0,  table_1 : u32,  ratio_1 : u32) -> vec4<f32>
{
    var _S184 : vec4<f32> = vec4<f32>(0.0f);
    var i_1 : u32 = u32(0);
    var sums_2 : vec4<f32> = _S184;
    for(;;)
    {
        if(i_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S185 : u32 = table_1 + u32(4) * taps_1.nodes_0[i_1] + u32(2) * ratio_1;
        var _S186 : vec2<u32> = vec2<u32>(words_0[_S185], words_0[_S185 + u32(1)]);
        var sums_3 : vec4<f32> = sums_2 + vec4<f32>(((vec4<i32>(vec2<i32>((_S186 << (vec2<u32>(u32(16))))), vec2<i32>(_S186)).xzyw) >> (vec4<u32>(u32(16))))) * vec4<f32>(f32(taps_1.weights_0[i_1]));
        i_1 = i_1 + u32(1);
        sums_2 = sums_3;
    }
    return sums_2 * vec4<f32>((taps_1.inverse_sum_0 / 4096.0f));
}

fn bytes_of_sums_0( even_0 : u32,  odd_0 : u32) -> vec4<f32>
{
    return vec4<f32>(f32((even_0 & (u32(65535)))), f32((odd_0 & (u32(65535)))), f32((even_0 >> (u32(16)))), f32((odd_0 >> (u32(16)))));
}

fn interpolate_0( taps_2 : NodeTaps_0,  packs_1 : vec4<u32>) -> vec4<f32>
{
    var _S187 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S188 : vec4<u32> = ((packs_1 & (_S187))) * taps_2.weights_0;
    var _S189 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S187))) * taps_2.weights_0;
    return bytes_of_sums_0(_S188.x + _S188.y + _S188.z + _S188.w, _S189.x + _S189.y + _S189.z + _S189.w) * vec4<f32>(taps_2.inverse_sum_0);
}

fn interpolate_table_0( taps_3 : NodeTaps_0,  table_2 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S190 : vec4<u32> = vec4<u32>(table_2) + taps_3.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_3, vec4<u32>(words_0[_S190.x], words_0[_S190.y], words_0[_S190.z], words_0[_S190.w]));
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
    var _S191 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_9 = _S191;
    var _S192 : f32 = table_number_0(row_1 + u32(7));
    var _S193 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S192, _S193, 1.0f - square_0(_S191) - _S192 - _S193);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn Group_variance_along_0( this_5 : Group_0,  direction_7 : vec3<f32>) -> f32
{
    var _S194 : f32 = direction_7.x;
    var _S195 : f32 = direction_7.y;
    var _S196 : f32 = direction_7.z;
    return max(dot(this_5.variance_0, direction_7 * direction_7) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S194 * _S195, _S194 * _S196, _S195 * _S196)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_8 : vec3<f32>) -> f32
{
    var _S197 : f32 = dot(direction_8, group_1.tangent_9);
    var _S198 : f32 = group_1.roughness_6;
    var _S199 : f32 = _S198 * _S198;
    return sqrt(max((_S199 - 1.0f) * (_S197 * _S197 + Group_variance_along_0(group_1, direction_8)) + 1.0f, _S199));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S200 : f32 = group_2.roughness_6;
    var _S201 : f32 = max(sqrt(max(1.0f - _S200 * _S200, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S202 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S203 : f32 = dot(half_0, group_2.tangent_9);
    var _S204 : f32 = _S201 * (_S203 - _S202);
    var _S205 : f32 = _S201 * (_S203 + _S202);
    var _S206 : f32 = _S204 * _S205;
    var _S207 : f32 = 2.0f * _S202 * _S201;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S206) / ((_S204 * _S204 + 1.0f) * (_S205 * _S205 + 1.0f)) + arc_tangent_0(_S207, 1.0f + _S206) / _S207);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S208 : bool = (light_6.z) < 0.0f;
    var _S209 : f32 = dot(light_6, group_3.normal_9);
    var _S210 : f32 = max(dot(view_5, group_3.normal_9), 0.01999999955296516f);
    var _S211 : f32 = mean_area_0(group_3, light_6) / max(select(_S209, - _S209, _S208), 0.01999999955296516f);
    var _S212 : f32 = mean_area_0(group_3, view_5) / _S210;
    var _S213 : f32 = optical_depth_3 * max(select(_S211 + _S212, abs(_S211 - _S212), _S208), 0.00100000004749745f);
    return 0.25f * mean_density_0(group_3, half_1) * select(1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_9)), 1.0f, _S208) * (optical_depth_3 * select(1.0f, exponential_0(- optical_depth_3 * min(_S211, _S212)), _S208) * (1.0f - exponential_0(- _S213)) / _S213 / _S210);
}

struct Bound_0
{
     thread_12 : u32,
     turns_2 : f32,
     cell_10 : f32,
     visible_0 : f32,
     width_3 : f32,
     gap_0 : f32,
};

fn bound_at_0( family_10 : u32,  position_6 : f32) -> Bound_0
{
    var _S214 : Cell_0 = locate_0(family_10, position_6);
    var _S215 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S214.thread_2 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_12 = _S214.thread_2;
    bound_0.turns_2 = round((position_6 - families_0[family_10].start_0 - _S215 - _S214.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_10 = _S214.below_0;
    var _S216 : f32 = 2.0f * _S214.half_width_1;
    bound_0.width_3 = _S216;
    bound_0.visible_0 = clamp((_S214.across_2 + _S214.half_width_1) / _S216, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S214.below_0, _S214.below_0 - _S214.across_2 - _S214.half_width_1) + max(_S214.across_2 - _S214.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S217 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S218 : f32 = 0.5f * max(size_2, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_11, _S217 - _S218);
    stretch_0.high_1 = bound_at_0(family_11, _S217 + _S218);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S219 : f32 = Stretch_turns_0(stretch_1);
    var _S220 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_1.thread_12;
    var _S221 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_1.thread_12;
    var _S222 : f32 = table_number_0(_S221) - table_number_0(_S220);
    var _S223 : f32 = table_number_0(_S221 + u32(1)) - table_number_0(_S220 + u32(1));
    return vec3<f32>(_S222 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_3 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_3 + _S219 * families_0[family_12].visible_total_0, _S223 - _S222 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S219 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S223 + stretch_1.high_1.cell_10 - stretch_1.low_1.cell_10 + _S219 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S224 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S225 : u32 = families_0[family_13].colour_threads_0 + _S224 * stretch_2.low_1.thread_12 + quantity_0;
    var _S226 : u32 = families_0[family_13].colour_threads_0 + _S224 * stretch_2.high_1.thread_12 + quantity_0;
    var _S227 : u32 = families_0[family_13].colour_threads_0 + _S224 * u32(families_0[family_13].count_0) + quantity_0;
    var _S228 : f32 = table_number_0(_S225);
    var _S229 : f32 = table_number_0(_S226);
    var _S230 : f32 = Stretch_turns_0(stretch_2);
    var _S231 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S226 + families_0[family_13].quantities_0) - table_number_0(_S225 + families_0[family_13].quantities_0) + _S229 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_3 - _S228 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_3 + _S230 * table_number_0(_S227 + families_0[family_13].quantities_0), table_number_0(_S226 + _S231) - table_number_0(_S225 + _S231) + _S229 * stretch_2.high_1.cell_10 - _S228 * stretch_2.low_1.cell_10 + _S230 * table_number_0(_S227 + _S231));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_12) < (this_7.low_1.thread_12);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S232 : u32 = entries_0.z;
    var _S233 : u32 = entries_0.x;
    return vec4<u32>(_S232 - _S233 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S232, entries_0.y - _S233, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_2 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S234 : u32 = row_2 + across_5.low_1.thread_12 * quantities_1;
    var _S235 : u32 = row_2 + across_5.high_1.thread_12 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S234], words_0[_S234 + quantities_1], words_0[_S235], words_0[_S235 + quantities_1]), words_0[row_2 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_1.visible_0, - this_9.low_1.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_14 : u32,  across_6 : Stretch_0,  along_1 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S236 : u32 = u32(families_0[family_14].count_0);
    var _S237 : u32 = (_S236 + u32(1)) * families_0[family_14].quantities_0;
    var _S238 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S239 : vec4<u32> = row_differences_0(across_6, _S238 + along_1.low_1.thread_12 * _S237, _S236, families_0[family_14].quantities_0);
    var _S240 : vec4<u32> = row_differences_0(across_6, _S238 + along_1.high_1.thread_12 * _S237, _S236, families_0[family_14].quantities_0);
    var _S241 : vec4<u32> = row_differences_0(across_6, _S238 + crossing_count_0 * _S237, _S236, families_0[family_14].quantities_0);
    var _S242 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S240 - _S239 + select_vector_2(Stretch_wraps_0(along_1), _S241, vec4<u32>(vec4<i32>(i32(0)))))), _S242), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S238 + (along_1.high_1.thread_12 + u32(1)) * _S237, _S236, families_0[family_14].quantities_0) - _S240)), _S242), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S238 + (along_1.low_1.thread_12 + u32(1)) * _S237, _S236, families_0[family_14].quantities_0) - _S239)), _S242), dot(vec4<f32>(vec4<i32>(_S241)), _S242)), Stretch_weights_0(along_1)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S243 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S244 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S244 * _S243.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S244 * _S243.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S244 * _S243.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S244 * _S243.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_5 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S245 : vec3<f32> = lengths_0(crossing_1, other_2);
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
        var _S246 : vec2<f32> = integrals_along_0(family_15, own_1, quantity_2);
        var _S247 : f32 = integral_on_top_0(family_15, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S248 : f32 = _S246.x;
        var _S249 : f32 = _S248 * _S245.x;
        var _S250 : f32 = select(_S247, _S249 - _S247, back_5);
        var _S251 : bool = quantity_2 == u32(0);
        if(_S251)
        {
            is_exposed_0 = _S250 > (16.0f * families_0[family_15].area_unit_0 * min(_S249 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S249);
        }
        var _S252 : f32 = _S248 * _S245.y + select(0.0f, _S250, is_exposed_0) + 0.000244140625f * _S245.z * _S246.y;
        if(_S251)
        {
            weight_4 = 1.0f / max(_S252, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S252 * weight_4, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
        }
        quantity_2 = quantity_2 + u32(1);
    }
    albedos_2.diffuse_reflect_0 = saturate(albedos_2.diffuse_reflect_0);
    albedos_2.diffuse_transmit_0 = saturate(albedos_2.diffuse_transmit_0);
    albedos_2.specular_reflect_0 = saturate(albedos_2.specular_reflect_0);
    albedos_2.specular_transmit_0 = saturate(albedos_2.specular_transmit_0);
    return albedos_2;
}

fn lerp_albedos_0( first_5 : Albedos_0,  second_1 : Albedos_0,  weight_5 : f32) -> Albedos_0
{
    var albedos_3 : Albedos_0;
    var _S253 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_5.diffuse_reflect_0, second_1.diffuse_reflect_0, _S253);
    albedos_3.diffuse_transmit_0 = mix(first_5.diffuse_transmit_0, second_1.diffuse_transmit_0, _S253);
    albedos_3.specular_reflect_0 = mix(first_5.specular_reflect_0, second_1.specular_reflect_0, _S253);
    albedos_3.specular_transmit_0 = mix(first_5.specular_transmit_0, second_1.specular_transmit_0, _S253);
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
    var _S254 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S255 : vec3<f32> = sends_0.sky_warp_0 + _S254 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S255;
    var _S256 : vec3<f32> = sends_0.sky_weft_0 + _S254 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S256;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S255 + vec3<f32>(sends_0.blocks_weft_0) * _S256;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_6 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S257 : f32 = 1.0f - view_6.z;
    var _S258 : f32 = _S257 * _S257;
    (*terms_0)[i32(0)] = 1.0f;
    var _S259 : f32 = view_6.x;
    var _S260 : f32 = _S259 * _S259;
    var _S261 : f32 = view_6.y;
    var _S262 : f32 = _S261 * _S261;
    (*terms_0)[i32(1)] = sqrt(max(_S260 + _S262, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S258;
    (*terms_0)[i32(3)] = _S258 * _S258;
    (*terms_0)[i32(4)] = _S260 - _S262;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_7 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S263 : f32 = 1.0f - view_7.z;
    var _S264 : f32 = _S263 * _S263;
    (*terms_1)[i32(0)] = 1.0f;
    var _S265 : f32 = view_7.x;
    var _S266 : f32 = _S265 * _S265;
    var _S267 : f32 = view_7.y;
    var _S268 : f32 = _S267 * _S267;
    (*terms_1)[i32(1)] = sqrt(max(_S266 + _S268, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S264;
    (*terms_1)[i32(3)] = _S264 * _S264;
    (*terms_1)[i32(4)] = _S266 - _S268;
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
    var _S269 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S270 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_6 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S270 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S270 * interior_0.far_1 + yarn_2.back_6 * _S269;
    return bounced_0;
}

fn sum_of_0( first_6 : Bounced_0,  second_2 : Bounced_0) -> Bounced_0
{
    var sum_1 : Bounced_0;
    sum_1.reflected_0 = first_6.reflected_0 + second_2.reflected_0;
    sum_1.transmitted_0 = first_6.transmitted_0 + second_2.transmitted_0;
    return sum_1;
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_8 : vec3<f32>) -> vec3<f32>
{
    var _S271 : f32 = light_7.z;
    return select_vector_1((_S271 * view_8.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S271) * 0.31830987334251404f));
}

fn sheen_scale_0( x_13 : f32,  y_6 : f32) -> f32
{
    return (((((0.0f * x_13 + (((((-1.1402510404586792f * y_6 + 0.40672621130943298f) * y_6 + 1.65398800373077393f) * y_6 + -1.29730904102325439f) * y_6 + 0.30570998787879944f) * y_6 + -0.0220868494361639f)) * x_13 + (((((-0.21142719686031342f * y_6 + 1.05947399139404297f) * y_6 + -0.41116121411323547f) * y_6 + -0.93859231472015381f) * y_6 + 0.51606941223144531f) * y_6 + 0.05409301072359085f)) * x_13 + (((((1.22944498062133789f * y_6 + -0.45962560176849365f) * y_6 + -1.63861405849456787f) * y_6 + 1.33565104007720947f) * y_6 + -0.45725581049919128f) * y_6 + 0.08243165910243988f)) * x_13 + (((((0.39779931306838989f * y_6 + -1.18879103660583496f) * y_6 + 0.28251591324806213f) * y_6 + 1.168984055519104f) * y_6 + -0.76864629983901978f) * y_6 + 0.0091691892594099f)) * x_13 + (((((-0.26563560962677002f * y_6 + -0.19379159808158875f) * y_6 + 0.2677634060382843f) * y_6 + 0.00270519289188087f) * y_6 + 0.14349560439586639f) * y_6 + 0.10290180146694183f)) * x_13 + (((((-0.20701569318771362f * y_6 + 0.24526430666446686f) * y_6 + 0.19551840424537659f) * y_6 + 0.07586126774549484f) * y_6 + 0.38894739747047424f) * y_6 + 0.15043120086193085f);
}

fn sheen_shear_0( x_14 : f32,  y_7 : f32) -> f32
{
    return ((((0.0f * x_14 + (((((-0.10608240216970444f * y_7 + 1.99214303493499756f) * y_7 + -1.42255294322967529f) * y_7 + -1.09495604038238525f) * y_7 + 0.59180057048797607f) * y_7 + 0.06902855634689331f)) * x_14 + (((((-0.46220690011978149f * y_7 + -0.29113379120826721f) * y_7 + 1.39025199413299561f) * y_7 + 0.35589990019798279f) * y_7 + -1.17120099067687988f) * y_7 + 0.15940259397029877f)) * x_14 + (((((2.26068711280822754f * y_7 + -3.64728999137878418f) * y_7 + -0.72173482179641724f) * y_7 + 3.07659196853637695f) * y_7 + -0.6827620267868042f) * y_7 + -0.3039557933807373f)) * x_14 + (((((0.81201767921447754f * y_7 + 0.36014080047607422f) * y_7 + -1.72646903991699219f) * y_7 + -0.22630110383033752f) * y_7 + 0.89514690637588501f) * y_7 + -0.10397960245609283f)) * x_14 + (((((-0.37648698687553406f * y_7 + 1.10974001884460449f) * y_7 + 0.17824520170688629f) * y_7 + -1.04968702793121338f) * y_7 + 0.1461234986782074f) * y_7 + -0.00475129019469023f);
}

fn sheen_reflectance_0( x_15 : f32,  y_8 : f32) -> f32
{
    return ((((0.0f * x_15 + (((((12.95646953582763672f * y_8 + -21.38032913208007812f) * y_8 + -7.37853097915649414f) * y_8 + 34.55607986450195312f) * y_8 + -23.61347007751464844f) * y_8 + 5.00126314163208008f)) * x_15 + (((((10.91487026214599609f * y_8 + -6.08202791213989258f) * y_8 + -38.2036285400390625f) * y_8 + 53.3440399169921875f) * y_8 + -21.91996002197265625f) * y_8 + 2.01606011390686035f)) * x_15 + (((((-14.52206039428710938f * y_8 + 36.803619384765625f) * y_8 + -22.94047927856445312f) * y_8 + -10.07973003387451172f) * y_8 + 15.77003955841064453f) * y_8 + -4.92722177505493164f)) * x_15 + (((((-7.62505722045898438f * y_8 + 1.27310299873352051f) * y_8 + 31.19523048400878906f) * y_8 + -44.39989852905273438f) * y_8 + 26.44947052001953125f) * y_8 + -8.73507976531982422f)) * x_15 + (((((5.65633487701416016f * y_8 + -17.66820907592773438f) * y_8 + 24.65356063842773438f) * y_8 + -19.38941001892089844f) * y_8 + 11.06159019470214844f) * y_8 + -3.06573700904846191f);
}

fn sheen_lobe_0( cos_view_0 : f32,  roughness_8 : f32) -> vec3<f32>
{
    var _S272 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S273 : f32 = 2.0f * sqrt(_S272) - 1.0f;
    var _S274 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S273, _S274), 0.00999999977648258f, 1.0f), clamp((1.0f - _S272) * sheen_shear_0(_S273, _S274), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S273, _S274), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_9 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S275 : f32 = light_8.z;
    if(((_S275 <= 0.0f) | (((view_9.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S276 : vec2<f32> = view_9.xy;
    var _S277 : f32 = dot(_S276, _S276);
    var _S278 : vec2<f32> = select_vector_0(_S277 > 9.99999968265522539e-21f, _S276 * vec2<f32>(rsqrt_0(max(_S277, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S279 : f32 = scale_0 * dot(light_8.xy, _S278) + shear_0 * _S275;
    var _S280 : f32 = scale_0 * (light_8.y * _S278.x - light_8.x * _S278.y);
    var _S281 : f32 = _S279 * _S279 + _S280 * _S280 + _S275 * _S275;
    return 0.31830987334251404f * scale_0 * scale_0 * _S275 / max(_S281 * _S281, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S282 : vec3<f32> = sheen_lobe_0(view_10.z, roughness_9);
    var _S283 : f32 = strength_0 * _S282.z;
    return vec2<f32>(_S283 * transformed_cosine_0(light_9, view_10, _S282.x, _S282.y), 1.0f - _S283);
}

fn accumulate_0( index_7 : u32,  light_10 : vec4<f32>)
{
    var _S284 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_10;
    layers_0[index_7].share_0 = _S284 * (1.0f - light_10.w);
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

fn uneven_shift_0( _S285 : u32,  _S286 : u32,  _S287 : u32,  _S288 : vec2<f32>) -> f32
{
    var _S289 : f32 = families_0[_S287].period_0 / families_0[_S287].count_0;
    var _S290 : u32 = hash_key_0(_S286, ((fabrics_0[_S285].seed_0) ^ (u32(625341585))));
    var _S291 : vec2<f32> = vec2<f32>(_S288.x, _S288.y / 4.0f) / vec2<f32>(_S289);
    return 0.20000000298023224f * sqrt(families_0[_S287].slub_0) * _S289 * (uneven_octave_0(_S290, _S291) * 0.66666668653488159f + uneven_octave_0(_S290 + u32(1), vec2<f32>(2.0f) * _S291 + vec2<f32>(0.5f, 0.0f)) / 3.0f);
}

fn uneven_place_0( _S292 : u32,  _S293 : vec2<f32>) -> vec2<f32>
{
    return select_vector_0((fabrics_0[_S292].has_detail_0) == u32(0), _S293, _S293 + vec2<f32>(uneven_shift_0(_S292, u32(0), fabrics_0[_S292].warp_0, _S293), uneven_shift_0(_S292, u32(1), fabrics_0[_S292].weft_0, _S293.yx)));
}

fn face_point_0( _S294 : u32,  _S295 : u32,  _S296 : f32,  _S297 : f32) -> VisiblePoint_0
{
    var _S298 : u32 = u32(3) * _S295;
    var _S299 : Vertex_0 = vertex_at_0(_S298);
    var _S300 : Vertex_0 = vertex_at_0(_S298 + u32(1));
    var _S301 : Vertex_0 = vertex_at_0(_S298 + u32(2));
    var _S302 : vec3<f32> = position_of_0(_S299);
    var _S303 : vec3<f32> = position_of_0(_S300) - _S302;
    var _S304 : vec3<f32> = position_of_0(_S301) - _S302;
    var _S305 : f32 = _S300.u_0 - _S299.u_0;
    var _S306 : f32 = _S300.v_0 - _S299.v_0;
    var _S307 : vec2<f32> = vec2<f32>(_S305, _S306);
    var _S308 : f32 = _S301.u_0 - _S299.u_0;
    var _S309 : f32 = _S301.v_0 - _S299.v_0;
    var _S310 : vec2<f32> = vec2<f32>(_S308, _S309);
    var _S311 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S305 * _S309 - _S306 * _S308) < 0.0f));
    var _S312 : vec3<f32> = _S311 * (vec3<f32>(_S309) * _S303 - vec3<f32>(_S306) * _S304);
    var _S313 : vec3<f32> = _S311 * (vec3<f32>(_S305) * _S304 - vec3<f32>(_S308) * _S303);
    var point_2 : VisiblePoint_0;
    var _S314 : vec3<f32> = vec3<f32>(_S296);
    var _S315 : vec3<f32> = vec3<f32>(_S297);
    var _S316 : vec3<f32> = normalize(vec3<f32>((1.0f - _S296 - _S297)) * normal_of_0(_S299) + _S314 * normal_of_0(_S300) + _S315 * normal_of_0(_S301));
    point_2.normal_0 = _S316;
    var _S317 : vec3<f32> = normalize(_S312 - _S316 * vec3<f32>(dot(_S316, _S312)));
    point_2.axis_x_0 = _S317;
    point_2.axis_y_0 = cross(_S316, _S317);
    var _S318 : vec3<f32> = normalize(cross(_S303, _S304));
    point_2.face_normal_0 = select_vector_1((dot(_S318, _S316)) < 0.0f, (vec3<f32>(0) - _S318), _S318);
    point_2.position_0 = _S302 + _S314 * _S303 + _S315 * _S304;
    point_2.view_0 = _S316;
    var _S319 : vec2<f32> = vec2<f32>(_S299.u_0, _S299.v_0) + vec2<f32>(_S296) * _S307 + vec2<f32>(_S297) * _S310;
    point_2.uv_1 = _S319;
    var _S320 : bool = (dot(cross(_S312, _S313), _S316)) < 0.0f;
    var _S321 : vec2<f32> = vec2<f32>(fabrics_0[_S294].uv_width_0, select(fabrics_0[_S294].uv_height_0, - fabrics_0[_S294].uv_height_0, _S320));
    point_2.draft_per_uv_0 = _S321;
    point_2.draft_0 = uneven_place_0(_S294, _S319 * _S321 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S294].uv_height_0, _S320)));
    var _S322 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S322;
    point_2.draft_dy_0 = _S322;
    return point_2;
}

fn visible_point_0( _S323 : u32,  _S324 : u32,  _S325 : vec2<u32>) -> VisiblePoint_0
{
    var _S326 : u32 = u32(3) * _S324;
    var _S327 : Vertex_0 = vertex_at_0(_S326);
    var _S328 : Vertex_0 = vertex_at_0(_S326 + u32(1));
    var _S329 : Vertex_0 = vertex_at_0(_S326 + u32(2));
    var _S330 : vec3<f32> = position_of_0(_S327);
    var _S331 : vec3<f32> = position_of_0(_S328) - _S330;
    var _S332 : vec3<f32> = position_of_0(_S329) - _S330;
    var _S333 : vec3<f32> = cross(_S331, _S332);
    var _S334 : f32 = f32(frame_record_0.width_0);
    var _S335 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S334));
    var _S336 : f32 = f32(frame_record_0.height_0);
    var _S337 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S336));
    var _S338 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S325.x) + 0.5f - 0.5f * _S334)) * _S335 + vec3<f32>((f32(_S325.y) + 0.5f - 0.5f * _S336)) * _S337;
    var _S339 : f32 = dot(_S338, _S333);
    var _S340 : f32 = 1.0f / select(1.00000000317107685e-30f, _S339, (abs(_S339)) > 1.00000000317107685e-30f);
    var _S341 : vec3<f32> = _S330 - camera_origin_0();
    var _S342 : vec3<f32> = vec3<f32>((dot(_S341, _S333) * _S340));
    var _S343 : vec3<f32> = _S338 * _S342 - _S341;
    var _S344 : vec3<f32> = _S342 * (_S335 - _S338 * vec3<f32>((dot(_S335, _S333) * _S340)));
    var _S345 : vec3<f32> = _S342 * (_S337 - _S338 * vec3<f32>((dot(_S337, _S333) * _S340)));
    var _S346 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S333), 1.00000000317107685e-30f)));
    var _S347 : vec3<f32> = cross(_S332, _S333) * _S346;
    var _S348 : vec3<f32> = cross(_S333, _S331) * _S346;
    var _S349 : vec2<f32> = vec2<f32>(_S328.u_0 - _S327.u_0, _S328.v_0 - _S327.v_0);
    var _S350 : vec2<f32> = vec2<f32>(_S329.u_0 - _S327.u_0, _S329.v_0 - _S327.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S323, _S324, dot(_S343, _S347), dot(_S343, _S348));
    point_3.position_0 = _S330 + _S343;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S338));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S344, _S347)) * _S349 + vec2<f32>(dot(_S344, _S348)) * _S350) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S345, _S347)) * _S349 + vec2<f32>(dot(_S345, _S348)) * _S350) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S351 : u32,  _S352 : VisiblePoint_0) -> vec3<f32>
{
    var _S353 : u32 = fabrics_0[_S351].albedo_map_levels_0;
    if((fabrics_0[_S351].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S354 : vec2<f32> = vec2<f32>(fabrics_0[_S351].uv_width_0, fabrics_0[_S351].uv_height_0);
    var _S355 : vec2<f32> = _S352.draft_dx_0 / _S354;
    var _S356 : vec2<f32> = _S352.draft_dy_0 / _S354;
    var _S357 : u32 = _S353 - u32(1);
    var _S358 : u32 = (u32(1) << (_S357));
    var _S359 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S355.x * _S356.y - _S355.y * _S356.x), 9.99999968265522539e-21f) * (square_1(f32(_S358)) / 3.0f)), 0.0f, f32(_S353) - 1.0f);
    var _S360 : u32 = min(u32(_S359), max(_S353, u32(2)) - u32(2));
    var _S361 : u32 = min(_S360 + u32(1), _S357);
    var _S362 : u32 = (u32(1) << ((u32(2) * _S353)));
    return mix(map_level_0(fabrics_0[_S351].albedo_map_0 + (_S362 - ((_S362 >> ((u32(2) * _S360))))) / u32(3), (_S358 >> (_S360)), _S352.uv_1), map_level_0(fabrics_0[_S351].albedo_map_0 + (_S362 - ((_S362 >> ((u32(2) * _S361))))) / u32(3), (_S358 >> (_S361)), _S352.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S359 - f32(_S360))) - 1.0f) / 3.0f)));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S363 : u32,  _S364 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S363 * frame_record_0.height_0 + _S364.y) * frame_record_0.width_0 + _S364.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S365 : u32,  _S366 : u32) -> vec3<f32>
{
    var _S367 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S365 * frame_record_0.environment_columns_0 + _S366);
    return vec3<f32>(scene_number_0(_S367), scene_number_0(_S367 + u32(1)), scene_number_0(_S367 + u32(2)));
}

fn sample_environment_0( _S368 : vec2<f32>,  _S369 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S370 : u32 = frame_record_0.environment_rows_0;
    var _S371 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S368.y);
    var _S372 : u32 = frame_record_0.environment_columns_0;
    var _S373 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S371.index_3 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S368.x);
    var _S374 : vec3<f32> = environment_texel_0(_S371.index_3, _S373.index_3);
    (*_S369) = _S374 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S374), 9.99999968265522539e-21f)));
    var _S375 : f32 = 3.14159274101257324f / f32(_S370);
    var _S376 : f32 = mix(sine_cosine_0(f32(_S371.index_3) * _S375).y, sine_cosine_0(f32(_S371.index_3 + u32(1)) * _S375).y, _S371.remainder_0);
    var _S377 : f32 = sqrt(max(1.0f - _S376 * _S376, 0.0f));
    var _S378 : vec2<f32> = sine_cosine_0((f32(_S373.index_3) + _S373.remainder_0) * (6.28318548202514648f / f32(_S372)));
    var _S379 : f32 = _S377 * _S378.x;
    var _S380 : f32 = - _S377 * _S378.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S379 + frame_record_0.environment_sine_0 * _S380, _S376, frame_record_0.environment_cosine_0 * _S380 - frame_record_0.environment_sine_0 * _S379);
}

fn light_sample_0( _S381 : u32,  _S382 : vec2<u32>,  _S383 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S384 : u32 = frame_record_0.lights_0;
    if(_S381 >= (frame_record_0.lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S385 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S382, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S381 - _S384), u32(3)), &(weight_6));
        sample_0.towards_0 = _S385;
        sample_0.irradiance_1 = weight_6 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S386 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S381);
    sample_0.irradiance_1 = vec3<f32>(_S386.red_0, _S386.green_0, _S386.blue_0);
    sample_0.towards_0 = vec3<f32>(_S386.x_7, _S386.y_1, _S386.z_1);
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

fn regime_of_0( _S389 : u32,  _S390 : Footprint_0,  _S391 : f32) -> Regime_0
{
    var _S392 : f32 = Footprint_spread_side_0(_S390);
    var _S393 : f32 = clamp((binary_logarithm_0(max(_S392, 9.99999971718068537e-10f)) - fabrics_0[_S389].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S394 : f32 = _S393 * _S393 * (3.0f - 2.0f * _S393);
    regime_0.prefiltered_0 = _S394;
    var _S395 : f32 = _S392 * fabrics_0[_S389].lobes_0.threads_per_mm_0;
    regime_0.threads_1 = _S395;
    regime_0.points_0 = select(0.0f, clamp(_S395 * 12.0f, 1.0f, mix(max(8.0f / _S391, 1.0f), 1.0f, _S394)), _S394 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S396 : u32,  _S397 : f32) -> bool
{
    return (((((fabrics_0[_S396].fibre_noise_0) > 0.0f) | (((fabrics_0[_S396].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S396].has_detail_0) != u32(0)) & ((_S397 >= 0.0f))))));
}

struct Hit_0
{
     x_16 : f32,
     y_9 : f32,
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
     dive_1 : vec3<f32>,
     slope_x_1 : f32,
     slope_y_1 : f32,
};

fn crossing_at_0( _S398 : u32,  _S399 : f32,  _S400 : f32,  _S401 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S398].warp_0, _S399);
    crossing_3.weft_2 = locate_0(fabrics_0[_S398].weft_0, _S400);
    var _S402 : u32 = fabrics_0[_S398].run_words_0 + u32(2) * (crossing_3.weft_2.thread_2 * fabrics_0[_S398].ends_1 + crossing_3.warp_2.thread_2);
    var _S403 : u32 = words_0[_S402];
    crossing_3.warp_word_0 = _S403;
    crossing_3.weft_word_0 = words_0[_S402 + u32(1)];
    crossing_3.warp_above_0 = (((_S403 & (u32(1)))) == u32(1)) != _S401;
    return crossing_3;
}

fn sample_at_0( _S404 : u32,  _S405 : f32,  _S406 : f32,  _S407 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S408 : Crossing_0 = crossing_at_0(_S404, _S405, _S406, _S407);
    sample_1.crossing_2 = _S408;
    var _S409 : Shown_0 = shown_at_0(_S408, _S407);
    sample_1.shown_3 = _S409;
    var _S410 : u32 = select(fabrics_0[_S404].weft_0, fabrics_0[_S404].warp_0, _S409.is_warp_2);
    var _S411 : u32 = select(fabrics_0[_S404].warp_0, fabrics_0[_S404].weft_0, _S409.is_warp_2);
    var _S412 : Cell_0 = select_cell_0(_S409.is_warp_2, sample_1.crossing_2.warp_2, sample_1.crossing_2.weft_2);
    var _S413 : Cell_0 = select_cell_0(_S409.is_warp_2, sample_1.crossing_2.weft_2, sample_1.crossing_2.warp_2);
    var _S414 : Run_0 = unpack_0(_S410, _S411, _S412.thread_2, _S413, _S409.word_0);
    var _S415 : Section_0 = section_at_0(_S412);
    var _S416 : bool = ((_S409.on_top_0) & (((_S414.distance_0) < (_S415.drop_0 * _S414.bend_1.sine_0))));
    var _S417 : f32 = select(-1.0f, 1.0f, ((_S409.on_top_0) & ((!_S416))));
    var _S418 : f32 = select(_S414.reach_0, _S414.other_reach_0, _S416);
    var _S419 : f32 = select(max(_S418 - _S414.distance_0, 0.0f), _S418 + _S414.distance_0, _S416);
    var _S420 : f32 = _S418 / _S414.bend_1.sine_0 - _S417 * _S415.drop_0;
    var _S421 : f32 = _S419 * _S419;
    var _S422 : f32 = max(_S420 * _S420 - _S421, 9.99999968265522539e-21f);
    var _S423 : f32 = rsqrt_0(_S422);
    var _S424 : f32 = _S421 / (_S422 * _S423 + _S420);
    var _S425 : bool = _S419 > 0.0f;
    var _S426 : f32 = select(-1.0f, 1.0f, _S409.on_top_0) * select(-1.0f, 1.0f, _S414.near_start_0);
    var _S427 : f32 = _S415.slope_0 * select(1.0f, _S420 * _S423, _S425);
    sample_1.slope_across_0 = _S427;
    var _S428 : f32 = select(0.0f, _S426 * _S419 * _S423, _S425);
    sample_1.slope_along_0 = _S428;
    var _S429 : vec3<f32> = dive_0(_S411, _S409, _S414, _S413);
    sample_1.dive_1 = _S429;
    sample_1.height_7 = select(families_0[_S410].height_scale_0 * _S417, 0.0f, _S414.straight_0) * (_S418 * _S414.bend_1.half_tangent_0 - _S424) - families_0[_S410].height_scale_0 * _S415.drop_0 - _S429.x;
    var _S430 : f32 = families_0[_S410].height_scale_0 * _S427;
    var _S431 : f32 = families_0[_S410].height_scale_0 * _S428 - _S429.y;
    sample_1.slope_x_1 = select(_S431, _S430, _S409.is_warp_2);
    sample_1.slope_y_1 = select(_S430, _S431, _S409.is_warp_2);
    sample_1.run_3 = _S414;
    sample_1.section_1 = _S415;
    return sample_1;
}

fn steps_per_length_0( _S432 : u32,  _S433 : SearchQuality_0,  _S434 : vec3<f32>) -> f32
{
    return max(max(abs(_S434.x) * fabrics_0[_S432].threads_per_x_0, abs(_S434.y) * fabrics_0[_S432].threads_per_y_0) * _S433.steps_per_thread_0, abs(_S434.z) * fabrics_0[_S432].per_relief_0 * _S433.steps_per_relief_0);
}

fn cell_maximum_0( _S435 : u32,  _S436 : Crossing_0) -> f32
{
    var _S437 : u32 = select(fabrics_0[_S435].weft_0, fabrics_0[_S435].warp_0, _S436.warp_above_0);
    return f32((select(_S436.weft_word_0, _S436.warp_word_0, _S436.warp_above_0) >> (u32(28)))) * families_0[_S437].height_scale_0 * families_0[_S437].level_0;
}

fn probe_0( _S438 : u32,  _S439 : f32,  _S440 : f32,  _S441 : bool,  _S442 : bool,  _S443 : bool) -> Probe_0
{
    var _S444 : Sample_0 = sample_at_0(_S438, _S439, _S440, _S441);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S444.height_7;
    probe_1.hole_4 = _S444.shown_3.hole_3;
    probe_1.slope_x_0 = _S444.slope_x_1;
    probe_1.slope_y_0 = _S444.slope_y_1;
    probe_1.yarn_1 = select(_S444.crossing_2.weft_2.thread_2 * u32(2), _S444.crossing_2.warp_2.thread_2 * u32(2) + u32(1), _S444.shown_3.is_warp_2);
    probe_1.cell_max_0 = cell_maximum_0(_S438, _S444.crossing_2);
    probe_1.side_x_0 = select(_S444.crossing_2.warp_2.below_0, _S444.crossing_2.warp_2.above_0, _S442);
    probe_1.side_y_0 = select(_S444.crossing_2.weft_2.below_0, _S444.crossing_2.weft_2.above_0, _S443);
    probe_1.edge_x_0 = outline_distance_0(_S444.crossing_2.warp_2, _S444.shown_3, _S444.run_3, !_S444.shown_3.is_warp_2, _S442);
    probe_1.edge_y_0 = outline_distance_0(_S444.crossing_2.weft_2, _S444.shown_3, _S444.run_3, _S444.shown_3.is_warp_2, _S443);
    return probe_1;
}

fn is_free_0( _S445 : u32,  _S446 : SearchQuality_0,  _S447 : vec3<f32>,  _S448 : vec3<f32>,  _S449 : bool,  _S450 : f32) -> bool
{
    var _S451 : f32 = _S448.z;
    if(_S451 <= 0.0f)
    {
        return false;
    }
    var _S452 : f32 = 1.0f / max(_S446.shadow_share_0 * steps_per_length_0(_S445, _S446, _S448), 9.99999971718068537e-10f);
    var _S453 : StepControl_0 = step_control_0(_S448.xy, _S452);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S447.z + _S451 * distance_2) < _S450))))
        {
        }
        else
        {
            break;
        }
        var _S454 : vec3<f32> = _S447 + _S448 * vec3<f32>(distance_2);
        var _S455 : Probe_0 = probe_0(_S445, _S454.x, _S454.y, _S449, _S453.right_0, _S453.up_0);
        var _S456 : f32 = _S454.z;
        var _S457 : f32 = _S456 - _S455.height_4;
        var _S458 : f32 = _S451 - _S455.slope_x_0 * _S448.x - _S455.slope_y_0 * _S448.y;
        if(((!_S455.hole_4) & ((_S457 < 0.0f))))
        {
            return false;
        }
        var _S459 : f32 = way_back_to_dip_0(previous_3, _S457, _S458, last_step_0, _S455);
        if(_S459 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S459;
            distance_2 = distance_2 - _S459;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S460 : bool = _S456 > (_S455.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S453, _S455, _S457, _S458), max(StepControl_to_cell_exit_0(_S453, _S455.side_x_0, _S455.side_y_0), _S452), _S460);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S457, _S458, _S455, _S460);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S461 : u32,  _S462 : SearchQuality_0,  _S463 : f32,  _S464 : f32,  _S465 : vec3<f32>,  _S466 : bool) -> bool
{
    if(!sample_at_0(_S461, _S463, _S464, _S466).shown_3.hole_3)
    {
        return false;
    }
    var _S467 : vec3<f32> = vec3<f32>(_S463, _S464, 0.0f);
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
        var _S468 : bool = is_free_0(_S461, _S462, _S467, select_vector_1(side_1 == u32(0), _S465, vec3<f32>(- _S465.x, - _S465.y, _S465.z)), _S466 != (side_1 == u32(1)), fabrics_0[_S461].height_high_0);
        var _S469 : u32 = side_1 + u32(1);
        passes_0 = _S468;
        side_1 = _S469;
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

fn max_height_along_0( _S470 : u32,  _S471 : f32,  _S472 : f32,  _S473 : f32,  _S474 : vec3<f32>,  _S475 : bool) -> f32
{
    var _S476 : f32 = _S474.x;
    var _S477 : f32 = _S474.y;
    var _S478 : u32 = (words_0[fabrics_0[_S470].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S470].weft_0, _S472).thread_2 / u32(2) * fabrics_0[_S470].max_height_columns_0 + locate_0(fabrics_0[_S470].warp_0, _S471).thread_2 / u32(2)) + (select(u32(0), u32(1), _S476 > 0.0f) + select(u32(0), u32(2), _S477 > 0.0f))] >> (u32(select(i32(0), i32(4), _S475))));
    var _S479 : f32 = max(abs(_S476) * fabrics_0[_S470].threads_per_x_0, abs(_S477) * fabrics_0[_S470].threads_per_y_0) / _S474.z;
    var _S480 : f32 = fabrics_0[_S470].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S470].height_high_0;
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
        if(((max_height_0 - _S473) * _S479) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S478 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S480);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S481 : u32,  _S482 : f32,  _S483 : f32,  _S484 : bool,  _S485 : bool,  _S486 : bool) -> vec3<f32>
{
    var _S487 : Crossing_0 = crossing_at_0(_S481, _S482, _S483, _S484);
    return vec3<f32>(cell_maximum_0(_S481, _S487), select(_S487.warp_2.below_0, _S487.warp_2.above_0, _S485), select(_S487.weft_2.below_0, _S487.weft_2.above_0, _S486));
}

fn first_sample_height_0( _S488 : u32,  _S489 : ViewRay_0,  _S490 : StepControl_0,  _S491 : bool) -> f32
{
    var _S492 : f32 = max_height_along_0(_S488, _S489.origin_0.x, _S489.origin_0.y, 0.0f, vec3<f32>(_S489.slope_1, 1.0f), _S491);
    var count_5 : u32 = u32(0);
    var height_9 : f32 = _S492;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S493 : vec2<f32> = ViewRay_at_0(_S489, height_9);
        var _S494 : vec3<f32> = cell_bounds_0(_S488, _S493.x, _S493.y, _S491, _S490.right_0, _S490.up_0);
        var _S495 : f32 = height_9 - _S494.x;
        var _S496 : f32 = StepControl_to_cell_exit_0(_S490, _S494.y, _S494.z);
        var height_10 : f32 = height_9 - clamp(_S495, 0.0f, _S496);
        if(_S495 <= _S496)
        {
            height_9 = height_10;
            break;
        }
        count_5 = count_5 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S497 : u32,  _S498 : ViewRay_0,  _S499 : StepControl_0,  _S500 : bool) -> ViewRayEnd_0
{
    var _S501 : f32 = fabrics_0[_S497].height_low_0 - (fabrics_0[_S497].height_high_0 - fabrics_0[_S497].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S497, _S498, _S499, _S500);
    end_1.last_step_3 = _S499.epsilon_0;
    end_1.previous_4 = no_previous_sample_0();
    end_1.depth_2 = 0.0f;
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
        var _S502 : vec2<f32> = ViewRay_at_0(_S498, end_1.height_8);
        var _S503 : Probe_0 = probe_0(_S497, _S502.x, _S502.y, _S500, _S499.right_0, _S499.up_0);
        var _S504 : f32 = end_1.height_8 - _S503.height_4;
        var _S505 : f32 = ViewRay_rate_0(_S498, _S503);
        end_1.depth_2 = - _S504;
        end_1.rate_4 = _S505;
        var _S506 : bool = !_S503.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S506))) & (((end_1.previous_4.yarn_0) == (_S503.yarn_1))));
        if((((_S506 & ((_S504 <= 0.0f)))) | (((end_1.height_8) <= _S501))))
        {
            break;
        }
        var _S507 : f32 = way_back_to_dip_0(end_1.previous_4, _S504, _S505, end_1.last_step_3, _S503);
        if(_S507 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S507;
            end_1.last_step_3 = end_1.last_step_3 - _S507;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S508 : f32 = min(StepControl_to_cell_exit_0(_S499, _S503.side_x_0, _S503.side_y_0), end_1.height_8 - _S503.cell_max_0);
        var _S509 : f32 = StepControl_to_next_sample_0(_S499, _S503, _S504, _S505);
        end_1.previous_4 = after_sample_0(_S504, _S505, _S503, _S508 > _S509);
        var _S510 : f32 = max(_S508, _S509);
        end_1.last_step_3 = _S510;
        end_1.height_8 = end_1.height_8 - _S510;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S511 : u32,  _S512 : ViewRay_0,  _S513 : StepControl_0,  _S514 : bool,  _S515 : ViewRayEnd_0,  _S516 : u32) -> f32
{
    var _S517 : f32 = fabrics_0[_S511].height_high_0 - fabrics_0[_S511].height_low_0;
    var above_2 : f32 = _S515.height_8 + _S515.last_step_3;
    var above_gap_1 : f32 = clamp(_S515.previous_4.clearance_0, 0.0f, _S517);
    var under_gap_1 : f32 = clamp(_S515.depth_2, 0.0f, _S517);
    var middle_0 : f32 = select(between_0(above_2, _S515.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S515.previous_4.rate_0 * _S515.last_step_3, _S515.rate_4 * _S515.last_step_3) * _S515.last_step_3, _S515.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S515.height_8;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S516)
        {
        }
        else
        {
            break;
        }
        var _S518 : vec2<f32> = ViewRay_at_0(_S512, middle_0);
        var _S519 : Probe_0 = probe_0(_S511, _S518.x, _S518.y, _S514, _S513.right_0, _S513.up_0);
        var _S520 : f32 = clamp(middle_0 - select(_S519.height_4, -1.0e+09f, _S519.hole_4), - _S517, _S517);
        if(_S520 <= 0.0f)
        {
            var _S521 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S522 : f32 = - _S520;
            under_1 = middle_0;
            above_gap_2 = _S521;
            under_gap_2 = _S522;
            side_2 = 1.0f;
        }
        else
        {
            var _S523 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S520;
            under_gap_2 = _S523;
            side_2 = -1.0f;
        }
        var _S524 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S520 / min(ViewRay_rate_0(_S512, _S519), -9.99999997475242708e-07f), under_1, above_3), _S515.smooth_0);
        var _S525 : u32 = i_2 + u32(1);
        middle_0 = _S524;
        i_2 = _S525;
    }
    return select(under_1, middle_0, _S515.smooth_0);
}

fn first_hit_of_yarn_0( _S526 : u32,  _S527 : SearchQuality_0,  _S528 : f32,  _S529 : f32,  _S530 : vec3<f32>,  _S531 : bool) -> Hit_0
{
    var _S532 : f32 = max(_S530.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S528, _S529);
    var _S533 : vec2<f32> = _S530.xy / vec2<f32>(_S532);
    ray_0.slope_1 = _S533;
    var _S534 : StepControl_0 = step_control_0((vec2<f32>(0) - _S533), 1.0f / max(steps_per_length_0(_S526, _S527, _S530) / _S532, 9.99999971718068537e-10f));
    var _S535 : ViewRayEnd_0 = search_down_0(_S526, ray_0, _S534, _S531);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S536 : f32 = refined_height_0(_S526, ray_0, _S534, _S531, _S535, _S527.refinements_0);
    hit_0.height_6 = _S536;
    var _S537 : vec2<f32> = ViewRay_at_0(ray_0, _S536);
    hit_0.x_16 = _S537.x;
    hit_0.y_9 = _S537.y;
    return hit_0;
}

fn first_hit_0( _S538 : u32,  _S539 : SearchQuality_0,  _S540 : f32,  _S541 : f32,  _S542 : vec3<f32>,  _S543 : bool) -> Hit_0
{
    if(!passes_through_0(_S538, _S539, _S540, _S541, _S542, _S543))
    {
        return first_hit_of_yarn_0(_S538, _S539, _S540, _S541, _S542, _S543);
    }
    var hit_1 : Hit_0;
    hit_1.x_16 = _S540;
    hit_1.y_9 = _S541;
    hit_1.height_6 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_of_0( _S544 : u32,  _S545 : Sample_0,  _S546 : f32,  _S547 : f32,  _S548 : bool) -> SurfacePoint_0
{
    var _S549 : u32 = select(fabrics_0[_S544].weft_0, fabrics_0[_S544].warp_0, _S545.shown_3.is_warp_2);
    var _S550 : f32 = families_0[_S549].twist_sine_0 * select(1.0f, -1.0f, _S548);
    var _S551 : f32 = select(-1.0f, 1.0f, _S545.shown_3.is_warp_2);
    var _S552 : vec2<f32> = fibre_direction_0(_S545.slope_across_0, _S551 * _S545.slope_along_0, _S550, families_0[_S549].twist_cosine_0);
    var _S553 : f32 = _S552.x;
    var _S554 : f32 = _S552.y;
    var _S555 : f32 = select(_S545.slope_y_1, _S545.slope_x_1, _S545.shown_3.is_warp_2) * _S553 + _S551 * select(_S545.slope_x_1, _S545.slope_y_1, _S545.shown_3.is_warp_2) * _S554;
    var _S556 : f32 = select(_S545.crossing_2.weft_2.half_width_1, _S545.crossing_2.warp_2.half_width_1, _S545.shown_3.is_warp_2) * 1.0154266357421875f;
    var _S557 : f32 = _S556 * arc_sine_0(clamp(_S545.section_1.across_3 / _S556, -1.0f, 1.0f));
    var _S558 : f32 = select(- _S546, _S547, _S545.shown_3.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S545.shown_3.hole_3;
    point_4.is_warp_0 = _S545.shown_3.is_warp_2;
    point_4.warp_thread_0 = _S545.crossing_2.warp_2.thread_2;
    point_4.weft_thread_0 = _S545.crossing_2.weft_2.thread_2;
    point_4.height_2 = _S545.height_7;
    point_4.normal_1 = normalize(vec3<f32>(- _S545.slope_x_1, - _S545.slope_y_1, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S545.shown_3.is_warp_2, vec3<f32>(_S553, _S554, _S555), vec3<f32>(- _S554, _S553, _S555)));
    point_4.across_0 = _S545.section_1.across_3;
    point_4.fibre_across_0 = _S557 * families_0[_S549].twist_cosine_0 + _S558 * _S550;
    point_4.fibre_along_0 = _S558 * families_0[_S549].twist_cosine_0 - _S557 * _S550;
    var _S559 : f32 = run_share_0(_S545.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S559, _S559, _S545.shown_3.on_top_0);
    point_4.x_8 = _S546;
    point_4.y_2 = _S547;
    return point_4;
}

fn surface_met_0( _S560 : u32,  _S561 : f32,  _S562 : f32,  _S563 : f32,  _S564 : vec3<f32>,  _S565 : bool) -> SurfacePoint_0
{
    var _S566 : Sample_0 = sample_at_0(_S560, _S561, _S562, _S565);
    var point_5 : SurfacePoint_0 = surface_of_0(_S560, _S566, _S561, _S562, _S565);
    var _S567 : u32 = select(fabrics_0[_S560].weft_0, fabrics_0[_S560].warp_0, point_5.is_warp_0);
    var _S568 : f32 = select(_S566.crossing_2.weft_2.half_width_1, _S566.crossing_2.warp_2.half_width_1, point_5.is_warp_0) * 1.0154266357421875f;
    var _S569 : f32 = _S566.dive_1.z;
    var _S570 : f32 = _S566.slope_along_0 - (1.0f - _S569) * _S566.dive_1.y / families_0[_S567].height_scale_0;
    var _S571 : f32 = rsqrt_0(_S570 * _S570 + 1.0f);
    var _S572 : f32 = _S564.x;
    var _S573 : f32 = _S564.y;
    var _S574 : f32 = select(_S573, _S572, point_5.is_warp_0);
    var _S575 : f32 = _S564.z;
    var _S576 : f32 = (_S575 / families_0[_S567].height_scale_0 - _S570 * select(_S572, _S573, point_5.is_warp_0)) * _S571;
    var _S577 : f32 = square_1(_S568);
    var _S578 : f32 = sqrt(max(_S577 - square_1(point_5.across_0), 0.0f)) - (_S566.height_7 + _S569 * _S566.dive_1.x - _S563) / families_0[_S567].height_scale_0 * _S571;
    var _S579 : f32 = square_1(_S574) + square_1(_S576) + 9.999999960041972e-13f;
    var _S580 : f32 = point_5.across_0 * _S574 + _S578 * _S576;
    var _S581 : f32 = square_1(point_5.across_0) + square_1(_S578) - _S577;
    var _S582 : f32 = sqrt(max(square_1(_S580) - _S579 * _S581, 0.0f));
    var _S583 : f32 = clamp(select((_S582 - _S580) / _S579, - _S581 / max(_S580 + _S582, 9.999999960041972e-13f), _S580 > 0.0f), - _S568, _S568);
    var _S584 : f32 = point_5.across_0 + _S583 * _S574;
    point_5.across_0 = _S584;
    var _S585 : vec2<f32> = normalize(vec2<f32>(_S584, _S578 + _S583 * _S576));
    var _S586 : f32 = select(-1.0f, 1.0f, point_5.is_warp_0);
    var _S587 : f32 = families_0[_S567].twist_sine_0 * select(1.0f, -1.0f, _S565);
    var _S588 : f32 = _S585.x;
    var _S589 : f32 = _S587 * _S588 * _S571;
    var _S590 : f32 = _S585.y;
    var _S591 : f32 = - _S587 * _S590;
    var _S592 : f32 = families_0[_S567].twist_cosine_0 * _S571 - _S586 * _S570 * _S589;
    var _S593 : f32 = families_0[_S567].height_scale_0 * (families_0[_S567].twist_cosine_0 * _S586 * _S570 * _S571 + _S589);
    var _S594 : f32 = families_0[_S567].height_scale_0 * _S588;
    var _S595 : f32 = - families_0[_S567].height_scale_0 * _S570 * _S571 * _S590;
    point_5.normal_1 = normalize(vec3<f32>(select(_S595, _S594, point_5.is_warp_0), select(_S594, _S595, point_5.is_warp_0), _S571 * _S590));
    point_5.tangent_0 = normalize(vec3<f32>(select(- _S592, _S591, point_5.is_warp_0), select(_S591, _S592, point_5.is_warp_0), _S593));
    var _S596 : f32 = _S568 * angle_of_0(_S585);
    var _S597 : f32 = select(- _S561 - _S583 * _S572, _S562 + _S583 * _S573, point_5.is_warp_0);
    point_5.fibre_across_0 = _S596 * families_0[_S567].twist_cosine_0 + _S597 * _S587;
    point_5.fibre_along_0 = _S597 * families_0[_S567].twist_cosine_0 - _S596 * _S587;
    var _S598 : f32 = 0.00999999977648258f * _S568;
    var _S599 : f32 = - _S598;
    var _S600 : bool = _S583 < _S599;
    var _S601 : f32 = select(_S598, _S599, _S574 < 0.0f);
    var _S602 : f32 = max(_S583, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S602 * _S572, select(0.0f, _S601, point_5.is_warp_0), _S600);
    point_5.y_2 = point_5.y_2 + select(_S602 * _S573, select(_S601, 0.0f, point_5.is_warp_0), _S600);
    point_5.height_2 = select(_S563 + _S583 * _S575, _S563, _S600);
    return point_5;
}

struct Hairs_0
{
     place_1 : vec2<f32>,
     below_1 : f32,
     back_7 : bool,
     size_3 : f32,
};

struct YarnPoint_0
{
     back_8 : bool,
     hole_6 : bool,
     is_warp_5 : bool,
     x_17 : f32,
     y_10 : f32,
     height_11 : f32,
     normal_10 : vec3<f32>,
     tangent_10 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
     hairs_0 : Hairs_0,
     hair_cover_0 : f32,
};

fn hairs_over_0( _S603 : u32,  _S604 : SurfacePoint_0,  _S605 : bool,  _S606 : f32) -> Hairs_0
{
    var hairs_1 : Hairs_0;
    hairs_1.place_1 = vec2<f32>(_S604.x_8, _S604.y_2);
    hairs_1.below_1 = fabrics_0[_S603].height_high_0 - _S604.height_2;
    hairs_1.back_7 = _S605;
    hairs_1.size_3 = _S606;
    return hairs_1;
}

fn has_hairs_0( _S607 : u32) -> bool
{
    return (((families_0[fabrics_0[_S607].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S607].weft_0].hairiness_0) > 0.0f)));
}

fn hair_towards_0( _S608 : u32,  _S609 : Hairs_0,  _S610 : vec3<f32>,  _S611 : f32) -> Hair_0
{
    var _S612 : f32 = fabrics_0[_S608].fibre_size_0;
    var _S613 : f32 = 17.0f * fabrics_0[_S608].fibre_size_0;
    var _S614 : f32 = fade_0(_S611, _S613);
    var _S615 : vec2<f32> = _S610.xy / vec2<f32>(max(_S610.z, 0.3333333432674408f));
    var _S616 : u32 = hash_key_0(select(u32(0), u32(1), _S609.back_7), ((fabrics_0[_S608].seed_0) ^ (u32(1013904242))));
    var _S617 : f32 = fabrics_0[_S608].fibre_size_0 / max(_S611, 0.07000000029802322f * fabrics_0[_S608].fibre_size_0);
    const _S618 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S618;
    var hair_away_0 : f32 = 0.0f;
    var is_warp_6 : bool = false;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S614 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S619 : u32 = number_2 / u32(9);
        var _S620 : u32 = number_2 / u32(3) - u32(3) * _S619;
        var _S621 : vec2<f32> = (vec2<f32>(((f32(_S619) * 6.0f + 2.0f) * _S612 + _S609.below_1)) * _S615 + _S609.place_1) / vec2<f32>(_S613);
        var _S622 : vec2<f32> = floor(_S621) + vec2<f32>(f32(number_2 - u32(3) * _S620 - u32(9) * _S619), f32(_S620)) - vec2<f32>(1.0f);
        var _S623 : u32 = hash_bits_0(_S616 + _S619, u32(i32(_S622.x)) * u32(65536) + u32(i32(_S622.y)));
        var _S624 : u32 = hash_bits_0(_S616, _S623);
        var _S625 : vec2<f32> = _S621 - _S622 - vec2<f32>(share_of_0(_S623), share_of_0((_S623 >> (u32(10)))));
        var _S626 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S623 >> (u32(20)))));
        var _S627 : f32 = mix(5.0f, 16.0f, share_of_0((_S624 >> (u32(10))))) / 17.0f;
        var _S628 : f32 = _S625.x;
        var _S629 : f32 = _S626.y;
        var _S630 : f32 = _S625.y;
        var _S631 : f32 = _S626.x;
        var _S632 : f32 = (_S628 * _S629 + _S630 * _S631) / _S627;
        var _S633 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S624 >> (u32(20)))) - 1.0f);
        var _S634 : f32 = 0.5f * (2.0f * share_of_0((_S623 ^ (_S624))) - 1.0f);
        var _S635 : f32 = _S632 * (3.0f * _S634 * _S632 + 2.0f * _S633);
        var _S636 : f32 = rsqrt_0(_S635 * _S635 + 1.0f);
        var _S637 : f32 = (_S630 * _S629 - _S628 * _S631 - _S627 * _S632 * _S632 * (_S634 * _S632 + _S633)) * _S636 * 17.0f;
        var _S638 : f32 = 0.2800000011920929f * max(1.0f - square_1(square_1(_S632)), 0.0f) * _S617;
        var _S639 : f32 = clamp(_S638 + 0.5f - abs(_S637) * _S617, 0.0f, min(2.0f * _S638, 1.0f));
        var _S640 : bool = ((((_S624 >> (u32(30)))) & (u32(1)))) == u32(1);
        var _S641 : bool = (((((share_of_0(_S624)) < (families_0[select(fabrics_0[_S608].weft_0, fabrics_0[_S608].warp_0, _S640)].hairiness_0)) & (((abs(_S632)) < 1.0f)))) & ((_S639 > cover_2)));
        var _S642 : vec2<f32> = vec2<f32>(- _S631 - _S635 * _S629, _S629 - _S635 * _S631) * vec2<f32>(_S636);
        var _S643 : f32 = select(cover_2, _S639, _S641);
        var _S644 : vec2<f32> = vec2<f32>(select(hair_across_0.x, _S642.x, _S641), select(hair_across_0.y, _S642.y, _S641));
        var _S645 : f32 = select(hair_away_0, _S637, _S641);
        var _S646 : bool = select(is_warp_6, _S640, _S641);
        var _S647 : u32 = number_2 + u32(1);
        cover_2 = _S643;
        hair_across_0 = _S644;
        hair_away_0 = _S645;
        is_warp_6 = _S646;
        number_2 = _S647;
    }
    var _S648 : f32 = clamp(hair_away_0 * 2.85714292526245117f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S614 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S648) * hair_across_0, sqrt(1.0f - _S648 * _S648));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    hair_1.is_warp_3 = is_warp_6;
    hair_1.shade_0 = _S614 * 0.03255363181233406f * (families_0[fabrics_0[_S608].warp_0].hairiness_0 + families_0[fabrics_0[_S608].weft_0].hairiness_0);
    return hair_1;
}

fn thread_number_0( _S649 : u32,  _S650 : SurfacePoint_0) -> u32
{
    var _S651 : u32 = select(fabrics_0[_S649].weft_0, fabrics_0[_S649].warp_0, _S650.is_warp_0);
    return u32(i32(floor((select(_S650.y_2, _S650.x_8, _S650.is_warp_0) - _S650.across_0) / families_0[_S651].period_0)) * i32(families_0[_S651].count_0) + i32(select(_S650.weft_thread_0, _S650.warp_thread_0, _S650.is_warp_0))) * u32(2) + select(u32(0), u32(1), _S650.is_warp_0);
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

fn fibre_noise_at_0( _S652 : u32,  _S653 : u32,  _S654 : SurfacePoint_0,  _S655 : u32,  _S656 : f32) -> FibreNoise_0
{
    var _S657 : f32 = 5.0f * fabrics_0[_S652].fibre_size_0;
    var _S658 : vec2<f32> = wave_noise_0(hash_key_0(_S655, ((fabrics_0[_S652].seed_0) ^ (u32(458671337)))), _S654.fibre_along_0 / (25.0f * fabrics_0[_S652].fibre_size_0));
    var _S659 : f32 = _S654.fibre_across_0 + families_0[_S653].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S652].fibre_size_0 * _S658.x;
    var _S660 : vec3<f32> = fibre_cell_0(_S659, _S654.fibre_along_0, fabrics_0[_S652].fibre_size_0);
    var _S661 : vec3<f32> = fibre_cell_0(_S659, _S654.fibre_along_0, _S657);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S655, ((fabrics_0[_S652].seed_0) ^ (u32(1757159915)))), _S661);
    noise_0.bundle_offset_0 = _S661.z;
    noise_0.bundle_weight_0 = fade_0(_S656, _S657);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S655, ((fabrics_0[_S652].seed_0) ^ (u32(48610963)))), _S660);
    noise_0.fibre_weight_0 = fade_0(_S656, fabrics_0[_S652].fibre_size_0);
    noise_0.offset_2 = _S660.z;
    noise_0.slope_2 = 0.5f * _S658.y;
    return noise_0;
}

fn detail_gain_0( _S662 : u32,  _S663 : u32,  _S664 : SurfacePoint_0,  _S665 : bool,  _S666 : u32,  _S667 : f32) -> vec2<f32>
{
    var _S668 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S663].has_plies_0) > 0.0f)
    {
        gain_2 = groove_0(0.94999998807907104f * fade_0(_S667, 1.0f / families_0[_S663].plies_per_mm_0), ply_offset_0(_S663, _S664, _S665));
    }
    else
    {
        gain_2 = _S668;
    }
    if((families_0[_S663].fibre_tone_0) > 0.0f)
    {
        var _S669 : FibreNoise_0 = fibre_noise_at_0(_S662, _S663, _S664, _S666, _S667);
        var _S670 : f32 = 4.5f * families_0[_S663].fibre_tone_0;
        gain_2 = gain_2 + vec2<f32>(families_0[_S663].fibre_tone_0) * vec2<f32>(_S669.bundle_weight_0 * _S669.bundle_0.y + _S669.fibre_weight_0 * _S669.fibre_0.y, _S669.bundle_weight_0 + _S669.fibre_weight_0) + (groove_0(_S670 * (_S669.bundle_weight_0 * (0.5f * (_S669.bundle_0.x - 1.0f) + 1.0f)), _S669.bundle_offset_0) + groove_0(_S670 * _S669.fibre_weight_0, _S669.offset_2));
    }
    if((families_0[_S663].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.15000000596046448f * families_0[_S663].slub_0 * fade_0(_S667, 1.0f / families_0[_S663].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S666, ((fabrics_0[_S662].seed_0) ^ (u32(1373058189)))), select(- _S664.x_8, _S664.y_2, _S664.is_warp_0) * families_0[_S663].slubs_per_mm_0).x, 1.0f);
    }
    return vec2<f32>(max(gain_2.x, -0.94999998807907104f), gain_2.y);
}

fn vary_albedos_0( _S671 : u32,  _S672 : Albedos_0,  _S673 : u32,  _S674 : u32,  _S675 : vec2<f32>) -> Albedos_0
{
    var _S676 : vec3<f32> = max(_S672.specular_reflect_0, _S672.specular_transmit_0);
    var _S677 : vec3<f32> = _S672.diffuse_reflect_0 + _S672.diffuse_transmit_0;
    var _S678 : vec3<f32> = vec3<f32>(fabrics_0[_S671].layer_bound_0);
    var _S679 : vec3<f32> = vec3<f32>(1.0f);
    var _S680 : vec3<f32> = _S679 - _S678 * _S676;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S673, fabrics_0[_S671].colour_noise_0, fabrics_0[_S671].seed_0), _S677, _S680);
    var _S681 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S675.y, vec3<f32>(colour_1) * _S677, _S680) * _S675.x)));
    var _S682 : f32 = bounded_gain_0(fibre_gain_0(_S673, _S674, fabrics_0[_S671].fibre_noise_0, fabrics_0[_S671].seed_0), _S676, min((_S679 - _S681 * _S677) / _S678, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S681 * _S672.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S681 * _S672.diffuse_transmit_0;
    var _S683 : vec3<f32> = vec3<f32>(_S682);
    varied_0.specular_reflect_0 = _S683 * _S672.specular_reflect_0;
    varied_0.specular_transmit_0 = _S683 * _S672.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S684 : u32,  _S685 : SurfacePoint_0,  _S686 : Albedos_0,  _S687 : bool,  _S688 : f32,  _S689 : f32) -> Albedos_0
{
    var _S690 : u32 = thread_number_0(_S684, _S685);
    var _S691 : vec3<f32> = fibre_cell_0(_S685.fibre_across_0, _S685.fibre_along_0, fabrics_0[_S684].fibre_size_0);
    var _S692 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S684].has_detail_0) != u32(0)) & ((_S688 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S684, select(fabrics_0[_S684].weft_0, fabrics_0[_S684].warp_0, _S685.is_warp_0), _S685, _S687, _S690, _S688) * vec2<f32>(1.0f - _S689, 1.0f);
    }
    else
    {
        gain_3 = _S692;
    }
    return vary_albedos_0(_S684, _S686, _S690, u32(i32(_S691.x)) * u32(65536) + u32(i32(floor(_S691.y))), gain_3);
}

fn turned_frame_0( _S693 : u32,  _S694 : u32,  _S695 : SurfacePoint_0,  _S696 : bool,  _S697 : u32,  _S698 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_5 = _S695.normal_1;
    frame_2.tangent_4 = _S695.tangent_0;
    frame_2.loss_0 = 0.0f;
    frame_2.shade_2 = 0.0f;
    if((families_0[_S694].has_plies_0) > 0.0f)
    {
        var _S699 : f32 = fade_0(_S698, 1.0f / families_0[_S694].plies_per_mm_0);
        var _S700 : f32 = _S699 * 0.62000000476837158f * ply_offset_0(_S694, _S695, _S696);
        var _S701 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S702 : vec3<f32> = vec3<f32>(families_0[_S694].ply_cosine_0);
        var _S703 : vec3<f32> = vec3<f32>(select(families_0[_S694].ply_sine_0, - families_0[_S694].ply_sine_0, _S696));
        var _S704 : vec3<f32> = _S702 * _S701 + _S703 * frame_2.tangent_4;
        var _S705 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S700 * _S700));
        var _S706 : vec3<f32> = vec3<f32>(_S700);
        frame_2.tangent_4 = _S702 * (_S702 * frame_2.tangent_4 - _S703 * _S701) + _S703 * (_S705 * _S704 - _S706 * frame_2.normal_5);
        frame_2.normal_5 = _S705 * frame_2.normal_5 + _S706 * _S704;
        frame_2.loss_0 = _S699 * _S699 * 0.62000000476837158f * 0.62000000476837158f / 3.0f;
    }
    var _S707 : f32 = families_0[_S694].fibre_tilt_0;
    if((families_0[_S694].fibre_tilt_0) > 0.0f)
    {
        var _S708 : FibreNoise_0 = fibre_noise_at_0(_S693, _S694, _S695, _S697, _S698);
        var _S709 : f32 = 1.09858846664428711f * _S707 * (_S708.bundle_weight_0 * _S708.bundle_0.x + _S708.fibre_weight_0 * (_S708.fibre_0.x + _S708.offset_2));
        var _S710 : f32 = _S707 * (1.42099642753601074f * (_S708.bundle_weight_0 * _S708.bundle_0.y + _S708.fibre_weight_0 * _S708.fibre_0.y) - _S708.bundle_weight_0 * _S708.slope_2);
        var _S711 : f32 = square_1(_S708.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S707 * _S707 * ((0.24761904776096344f * (square_1(_S708.bundle_weight_0) + _S711) + _S711 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S712 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S713 : vec2<f32> = sine_cosine_0(_S709);
        var _S714 : vec2<f32> = sine_cosine_0(_S710);
        var _S715 : vec3<f32> = vec3<f32>(_S713.y);
        var _S716 : vec3<f32> = vec3<f32>(_S713.x);
        var _S717 : vec3<f32> = _S715 * _S712 - _S716 * frame_2.normal_5;
        frame_2.normal_5 = _S715 * frame_2.normal_5 + _S716 * _S712;
        frame_2.tangent_4 = vec3<f32>(_S714.y) * frame_2.tangent_4 + vec3<f32>(_S714.x) * _S717;
    }
    return frame_2;
}

fn yarn_point_of_0( _S718 : u32,  _S719 : SurfacePoint_0,  _S720 : vec3<f32>,  _S721 : bool,  _S722 : bool,  _S723 : f32) -> YarnPoint_0
{
    var _S724 : u32 = fabrics_0[_S718].warp_0;
    var _S725 : u32 = fabrics_0[_S718].weft_0;
    var _S726 : u32 = select(fabrics_0[_S718].weft_0, fabrics_0[_S718].warp_0, _S719.is_warp_0);
    var _S727 : bool = (((fabrics_0[_S718].has_detail_0) != u32(0)) & ((_S723 >= 0.0f)));
    var point_6 : YarnPoint_0;
    point_6.hairs_0 = hairs_over_0(_S718, _S719, _S721, _S723);
    point_6.hair_cover_0 = 1.0f;
    var _S728 : vec3<f32> = vec3<f32>(0.0f);
    var _S729 : Hair_0 = Hair_x24init_0(0.0f, _S728, _S728, false, 0.0f);
    point_6.is_warp_5 = _S719.is_warp_0;
    var _S730 : bool = (_S727 & ((has_hairs_0(_S718))));
    var hair_2 : Hair_0;
    if(_S730)
    {
        var _S731 : Hair_0 = hair_towards_0(_S718, point_6.hairs_0, _S720, _S723);
        point_6.hair_cover_0 = _S731.cover_0;
        point_6.is_warp_5 = select(_S719.is_warp_0, _S731.is_warp_3, (_S731.cover_0) > 0.5f);
        hair_2 = _S731;
    }
    else
    {
        hair_2 = _S729;
    }
    var _S732 : u32 = select(_S725, _S724, point_6.is_warp_5);
    var albedos_7 : Albedos_0 = albedos_of_0(_S732, select(_S719.weft_thread_0, _S719.warp_thread_0, point_6.is_warp_5));
    var albedos_8 : Albedos_0;
    if(varies_at_0(_S718, _S723))
    {
        albedos_8 = varied_at_0(_S718, _S719, albedos_7, _S721, _S723, hair_2.cover_0);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    point_6.back_8 = _S721;
    point_6.hole_6 = _S722;
    point_6.x_17 = _S719.x_8;
    point_6.y_10 = _S719.y_2;
    point_6.height_11 = _S719.height_2 + hair_2.cover_0 * point_6.hairs_0.below_1;
    point_6.normal_10 = _S719.normal_1;
    point_6.tangent_10 = _S719.tangent_0;
    point_6.surface_normal_0 = normalize(mix(_S719.normal_1, vec3<f32>(0.0f, 0.0f, 1.0f), vec3<f32>(hair_2.cover_0)));
    point_6.diffuse_gain_1 = 1.0f;
    if(_S727)
    {
        var _S733 : YarnFrame_0 = turned_frame_0(_S718, _S726, _S719, _S721, thread_number_0(_S718, _S719), _S723);
        var frame_3 : YarnFrame_0;
        if(_S730)
        {
            frame_3 = under_hair_0(_S733, hair_2);
        }
        else
        {
            frame_3 = _S733;
        }
        point_6.normal_10 = frame_3.normal_5;
        point_6.tangent_10 = frame_3.tangent_4;
        point_6.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S718].diffuse_blend_0);
    }
    point_6.roughness_10 = families_0[_S732].roughness_0;
    point_6.albedos_6 = albedos_8;
    return point_6;
}

fn surface_at_0( _S734 : u32,  _S735 : f32,  _S736 : f32,  _S737 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S734, sample_at_0(_S734, _S735, _S736, _S737), _S735, _S736, _S737);
}

fn unoccluded_0( _S738 : u32,  _S739 : SearchQuality_0,  _S740 : f32,  _S741 : f32,  _S742 : f32,  _S743 : vec3<f32>,  _S744 : bool) -> bool
{
    if((_S743.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S738, _S739, vec3<f32>(_S740, _S741, _S742 + fabrics_0[_S738].lift_0), _S743, _S744, max_height_along_0(_S738, _S740, _S741, _S742, _S743, _S744));
}

fn is_lit_0( _S745 : u32,  _S746 : SearchQuality_0,  _S747 : YarnPoint_0,  _S748 : vec3<f32>) -> bool
{
    if(_S747.hole_6)
    {
        return true;
    }
    var _S749 : vec3<f32> = to_face_frame_0(_S748, _S747.back_8);
    var _S750 : f32 = _S749.z;
    var _S751 : bool = _S750 < 0.0f;
    var normal_11 : vec3<f32>;
    var height_12 : f32;
    if(_S751)
    {
        var _S752 : SurfacePoint_0 = surface_at_0(_S745, _S747.x_17, _S747.y_10, !_S747.back_8);
        normal_11 = _S752.normal_1;
        height_12 = _S752.height_2;
    }
    else
    {
        normal_11 = _S747.surface_normal_0;
        height_12 = _S747.height_11;
    }
    var _S753 : vec3<f32> = vec3<f32>(_S749.xy, abs(_S750));
    if((dot(normal_11, _S753)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S745, _S746, _S747.x_17, _S747.y_10, height_12, _S753, (_S747.back_8) != _S751);
}

fn hairs_lit_0( _S754 : u32,  _S755 : Hairs_0,  _S756 : vec3<f32>) -> f32
{
    return 1.0f - 0.5f * hair_towards_0(_S754, _S755, _S756, _S755.size_3 + fabrics_0[_S754].fibre_size_0).cover_0;
}

fn under_hairs_0( _S757 : u32,  _S758 : YarnPoint_0,  _S759 : vec3<f32>) -> f32
{
    if((((_S758.hair_cover_0) >= 1.0f) | (((_S759.z) <= 0.0f))))
    {
        return 1.0f;
    }
    return mix(hairs_lit_0(_S757, _S758.hairs_0, _S759), 1.0f, _S758.hair_cover_0);
}

fn components_of_point_0( _S760 : u32,  _S761 : SearchQuality_0,  _S762 : YarnPoint_0,  _S763 : vec3<f32>,  _S764 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    result_3.hole_2 = select(0.0f, 1.0f, _S762.hole_6);
    var _S765 : bool;
    if(_S762.hole_6)
    {
        _S765 = true;
    }
    else
    {
        _S765 = !is_lit_0(_S760, _S761, _S762, _S763);
    }
    if(_S765)
    {
        return result_3;
    }
    var _S766 : vec3<f32> = to_face_frame_0(_S763, _S762.back_8);
    var _S767 : vec3<f32> = to_face_frame_0(_S764, _S762.back_8);
    var _S768 : bool = (_S766.z) < 0.0f;
    var _S769 : f32 = under_hairs_0(_S760, _S762, _S766);
    var _S770 : f32 = _S769 * _S762.diffuse_gain_1 * diffuse_reflection_0(select_vector_1(_S768, (vec3<f32>(0) - _S766), _S766), _S762.normal_10, fabrics_0[_S760].diffuse_blend_0);
    var _S771 : f32;
    if(_S768)
    {
        _S771 = transmission_1(_S766, _S767, _S762.normal_10, _S762.tangent_10, _S762.roughness_10, fabrics_0[_S760].optical_depth_0);
    }
    else
    {
        _S771 = reflection_0(_S766, _S767, _S762.normal_10, _S762.tangent_10, _S762.roughness_10, fabrics_0[_S760].optical_depth_0);
    }
    var _S772 : f32 = _S769 * _S771;
    result_3.diffuse_warp_0 = select(0.0f, _S770, _S762.is_warp_5);
    result_3.diffuse_weft_0 = select(_S770, 0.0f, _S762.is_warp_5);
    result_3.specular_warp_0 = select(0.0f, _S772, _S762.is_warp_5);
    result_3.specular_weft_0 = select(_S772, 0.0f, _S762.is_warp_5);
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S773 : u32,  _S774 : u32) -> f32
{
    return table_number_0(fabrics_0[_S773].openness_0 + _S774);
}

fn blocked_of_terms_0( _S775 : u32,  _S776 : u32,  _S777 : array<f32, i32(6)>,  _S778 : u32) -> Blocked_0
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
            if(term_0 < _S778)
            {
            }
            else
            {
                break;
            }
            shares_0[share_4] = shares_0[share_4] + openness_number_0(_S775, _S776 + share_4 * _S778 + term_0) * _S777[term_0];
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

fn blocked_at_0( _S779 : u32,  _S780 : bool,  _S781 : bool,  _S782 : f32,  _S783 : f32) -> Blocked_0
{
    var _S784 : f32 = _S783 * openness_number_0(_S779, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S782, _S784, _S782 * _S782, _S782 * _S784, _S784 * _S784 );
    return blocked_of_terms_0(_S779, u32(60) + (select(u32(0), u32(2), _S781) + select(u32(1), u32(0), _S780)) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S785 : u32,  _S786 : Blocked_0,  _S787 : YarnPoint_0,  _S788 : bool,  _S789 : f32) -> Blocked_0
{
    if(((_S787.hole_6) | (((_S787.is_warp_5) != _S788))))
    {
        return _S786;
    }
    var _S790 : Blocked_0 = blocked_at_0(_S785, _S788, _S787.back_8, _S787.surface_normal_0.z, _S787.height_11);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S786.by_warp_0 + _S789 * _S790.by_warp_0;
    result_4.by_weft_0 = _S786.by_weft_0 + _S789 * _S790.by_weft_0;
    result_4.far_0 = _S786.far_0 + _S789 * _S790.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S791 : u32,  _S792 : f32) -> vec3<f32>
{
    var _S793 : u32 = fabrics_0[_S791].lobes_0.levels_0 + u32(4) * u32(min(_S792, fabrics_0[_S791].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S793), table_number_0(_S793 + u32(1)), table_number_0(_S793 + u32(2)));
}

fn coverage_taps_0( _S794 : u32,  _S795 : Footprint_0,  _S796 : bool) -> CoverageTaps_0
{
    var _S797 : Lobes_std430_0 = fabrics_0[_S794].lobes_0;
    var _S798 : f32 = Footprint_spread_side_0(_S795) * fabrics_0[_S794].lobes_0.inverse_base_size_0;
    var _S799 : vec3<f32> = pyramid_level_0(_S794, floor(binary_logarithm_0(max(0.68000000715255737f * _S798, 1.0f))));
    var _S800 : f32 = 1.0f / max(_S798, 9.99999997475242708e-07f);
    var _S801 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S794].warp_0].inverse_period_0, families_0[fabrics_0[_S794].weft_0].inverse_period_0);
    var _S802 : vec2<f32> = _S795.centre_0 * _S801;
    var _S803 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S800 * _S800), 0.0f, 1.0f)), 0.3333333432674408f * _S800), 1.0f));
    var _S804 : vec2<f32> = _S795.dx_0 * _S801 * _S803;
    var _S805 : vec2<f32> = _S795.dy_0 * _S801 * _S803;
    var taps_4 : CoverageTaps_0;
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
        var _S806 : vec2<f32> = _S802 + vec2<f32>(TAP_OFFSETS_0[number_3].x) * _S804 + vec2<f32>(TAP_OFFSETS_0[number_3].y) * _S805;
        var _S807 : f32 = _S799.y;
        taps_4.nodes_1[number_3] = select(u32(0), _S797.face_nodes_0, _S796) + u32(wrapped_cell_0(_S806.y, _S799.z) * _S807 + wrapped_cell_0(_S806.x, _S807) + _S799.x);
        number_3 = number_3 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S808 : u32,  _S809 : vec3<f32>,  _S810 : vec3<f32>,  _S811 : bool) -> vec2<f32>
{
    var _S812 : NodeTaps_0 = node_taps_of_0(_S810, u32(16));
    var _S813 : NodeTaps_0 = node_taps_of_0(_S809, u32(16));
    var _S814 : u32 = fabrics_0[_S808].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S811) + select(u32(0), u32(1), (_S809.z) < 0.0f)) * u32(512);
    var _S815 : u32 = _S814 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S812, _S814, u32(0)), joint_terms_0(_S813, _S815, u32(0))), dot(joint_terms_0(_S812, _S814, u32(1)), joint_terms_0(_S813, _S815, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S816 : u32,  _S817 : CoverageTaps_0,  _S818 : u32) -> vec4<f32>
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
        var _S819 : u32 = words_0[fabrics_0[_S816].lobes_0.coverage_0 + _S817.nodes_1[number_4] * fabrics_0[_S816].lobes_0.packs_0 + _S818];
        var even_2 : u32 = even_1 + ((_S819 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S819 >> (u32(8)))) & (u32(16711935))));
        number_4 = number_4 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S820 : u32,  _S821 : CoverageTaps_0) -> f32
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
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S820].lobes_0.coverage_holes_0 + _S821.nodes_1[number_5] / u32(4)] >> ((u32(8) * (_S821.nodes_1[number_5] % u32(4)))))) & (u32(255))));
        number_5 = number_5 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S822 : u32,  _S823 : CoverageTaps_0,  _S824 : NodeTaps_0,  _S825 : bool) -> f32
{
    var _S826 : f32 = interpolate_table_0(_S824, fabrics_0[_S822].lobes_0.projected_area_0 + fabrics_0[_S822].lobes_0.packs_0, fabrics_0[_S822].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S822, _S823) * _S826 * _S826 * select(fabrics_0[_S822].lobes_0.front_hole_weight_0, fabrics_0[_S822].lobes_0.back_hole_weight_0, _S825), 1.0f);
}

fn prefiltered_components_0( _S827 : u32,  _S828 : Footprint_0,  _S829 : vec3<f32>,  _S830 : vec3<f32>,  _S831 : bool) -> Components_0
{
    var _S832 : CoverageTaps_0 = coverage_taps_0(_S827, _S828, _S831);
    var _S833 : NodeTaps_0 = node_taps_0(_S830);
    var view_nodes_0 : NodeTaps_0 = _S833;
    var _S834 : NodeTaps_0 = node_taps_0(_S829);
    var light_nodes_0 : NodeTaps_0 = _S834;
    var _S835 : u32 = select(u32(0), u32(1), _S831);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S835 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S835 + select(u32(0), u32(1), (_S829.z) < 0.0f)) * u32(256)));
    var _S836 : vec3<f32> = half_vector_0(_S829, _S830);
    var _S837 : vec2<f32> = joint_ratios_0(_S827, _S829, _S830, _S831);
    var _S838 : Lobes_std430_0 = fabrics_0[_S827].lobes_0;
    var _S839 : u32 = select(fabrics_0[_S827].lobes_0.front_warp_packs_0, fabrics_0[_S827].lobes_0.back_warp_packs_0, _S831);
    var sums_4 : Components_0;
    sums_4.diffuse_warp_0 = 0.0f;
    sums_4.diffuse_weft_0 = 0.0f;
    sums_4.specular_warp_0 = 0.0f;
    sums_4.specular_weft_0 = 0.0f;
    sums_4.light_visibility_1 = 0.0f;
    var pack_0 : u32 = u32(0);
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        if(pack_0 < (_S838.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S840 : vec4<f32> = coverage_of_pack_0(_S827, _S832, pack_0);
        var _S841 : vec4<f32> = interpolate_table_0(view_nodes_0, _S838.projected_area_0 + pack_0, _S838.packs_0 + u32(1));
        var _S842 : vec4<f32> = interpolate_table_0(light_nodes_0, _S838.light_visibility_0 + pack_0, _S838.packs_0) / vec4<f32>(255.0f);
        var _S843 : vec4<f32> = interpolate_table_0(light_nodes_0, _S838.irradiance_0 + pack_0, _S838.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S844 : bool = pack_0 < _S839;
        var _S845 : f32 = families_0[select(fabrics_0[_S827].weft_0, fabrics_0[_S827].warp_0, _S844)].roughness_0;
        var number_6 : u32 = u32(0);
        var diffuse_0 : f32 = 0.0f;
        var specular_0 : f32 = 0.0f;
        var lit_0 : f32 = 0.0f;
        for(;;)
        {
            if(number_6 < u32(4))
            {
            }
            else
            {
                break;
            }
            var _S846 : Group_0 = group_at_0(_S838.moments_0 + u32(12) * (u32(4) * (_S835 * _S838.packs_0 + pack_0) + number_6), _S845);
            var _S847 : f32 = _S840[number_6] * _S841[number_6] * _S841[number_6] * _S846.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S847 * _S843[number_6];
            var specular_1 : f32 = specular_0 + _S847 * layer_value_0(_S846, _S836, _S829, _S830, fabrics_0[_S827].optical_depth_0) * _S842[number_6];
            var lit_1 : f32 = lit_0 + _S847 * _S842[number_6];
            var total_3 : f32 = total_2 + _S847;
            number_6 = number_6 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_0 = lit_1;
            total_2 = total_3;
        }
        sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 + select(0.0f, diffuse_0, _S844);
        sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 + select(diffuse_0, 0.0f, _S844);
        sums_4.specular_warp_0 = sums_4.specular_warp_0 + select(0.0f, specular_0, _S844);
        sums_4.specular_weft_0 = sums_4.specular_weft_0 + select(specular_0, 0.0f, _S844);
        sums_4.light_visibility_1 = sums_4.light_visibility_1 + lit_0 * select(_S837.y, _S837.x, _S844);
        pack_0 = pack_0 + u32(1);
    }
    var _S848 : f32 = prefiltered_hole_0(_S827, _S832, view_nodes_0, _S831);
    sums_4.hole_2 = _S848;
    var _S849 : f32 = 1.0f - _S848;
    var _S850 : f32 = _S849 / max(total_2, 9.999999960041972e-13f);
    var _S851 : f32 = _S850 * _S837.x;
    sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 * _S851;
    var _S852 : f32 = _S850 * _S837.y;
    sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 * _S852;
    sums_4.specular_warp_0 = sums_4.specular_warp_0 * _S851;
    sums_4.specular_weft_0 = sums_4.specular_weft_0 * _S852;
    sums_4.light_visibility_1 = min(sums_4.light_visibility_1 * _S850, _S849);
    return sums_4;
}

fn albedos_over_0( _S853 : u32,  _S854 : Footprint_0,  _S855 : bool) -> FamilyAlbedos_0
{
    var _S856 : vec2<f32> = _S854.dx_0;
    var _S857 : vec2<f32> = _S854.dy_0;
    var _S858 : vec2<f32> = sqrt(_S856 * _S856 + _S857 * _S857);
    var _S859 : Stretch_0 = stretch_of_0(fabrics_0[_S853].warp_0, _S854.centre_0.x, _S858.x);
    var _S860 : Stretch_0 = stretch_of_0(fabrics_0[_S853].weft_0, _S854.centre_0.y, _S858.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S853].warp_0, fabrics_0[_S853].weft_0, _S859, _S860, _S855);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S853].weft_0, fabrics_0[_S853].warp_0, _S860, _S859, _S855);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S861 : u32,  _S862 : Footprint_0,  _S863 : f32,  _S864 : vec2<f32>,  _S865 : vec3<f32>,  _S866 : vec3<f32>) -> Estimate_0
{
    var _S867 : f32;
    var _S868 : Regime_0 = regime_of_0(_S861, _S862, _S863);
    var _S869 : bool = (_S866.z) < 0.0f;
    var _S870 : vec3<f32> = to_face_frame_0(_S866, _S869);
    var _S871 : f32 = Footprint_spread_side_0(_S862);
    var _S872 : bool = varies_at_0(_S861, _S871);
    var _S873 : f32 = 1.0f - _S868.prefiltered_0;
    var _S874 : bool = ((_S873 > 0.0f) & (((_S872 | (((((families_0[fabrics_0[_S861].warp_0].quantities_0) > u32(1)) | (((families_0[fabrics_0[_S861].weft_0].quantities_0) > u32(1))))))))));
    var box_0 : Footprint_0 = _S862;
    var _S875 : vec3<f32> = vec3<f32>(0.0f);
    var _S876 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S875, _S875, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f);
    var _S877 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S878 : u32 = select(u32(1), u32(0), _S874);
    var points_1 : Components_0 = _S877;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S876;
    var number_7 : u32 = _S878;
    for(;;)
    {
        var _S879 : f32 = f32(number_7);
        _S867 = _S868.points_0;
        if(_S879 < (_S868.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S880 : bool = number_7 == u32(0);
        var _S881 : u32 = number_7 - u32(1);
        var _S882 : vec2<f32> = POINT_OFFSETS_0[select(_S881, u32(0), _S880)] + _S864;
        var _S883 : vec2<f32> = select_vector_0(_S880, vec2<f32>(0.0f), _S882 - round(_S882));
        var _S884 : vec2<f32> = _S862.centre_0 + vec2<f32>(_S883.x) * _S862.dx_0 + vec2<f32>(_S883.y) * _S862.dy_0;
        var _S885 : SearchQuality_0 = quality_of_0(select(_S868.threads_1, 0.0f, _S880));
        var _S886 : Hit_0 = first_hit_0(_S861, _S885, _S884.x, _S884.y, _S870, _S869);
        var _S887 : SurfacePoint_0 = surface_met_0(_S861, _S886.x_16, _S886.y_9, _S886.height_6, _S870, _S869);
        if(_S880)
        {
            var central_weight_1 : f32 = select(_S873, 0.0f, _S886.hole_5);
            box_0.centre_0 = mix(_S862.centre_0, vec2<f32>(_S886.x_16, _S886.y_9), vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S887;
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S888 : YarnPoint_0 = yarn_point_of_0(_S861, _S887, _S870, _S869, _S886.hole_5, _S871);
        var _S889 : f32 = min(_S868.points_0 - f32(_S881), 1.0f);
        var _S890 : Components_0 = with_added_0(points_1, components_of_point_0(_S861, _S885, _S888, _S865, _S866), _S889);
        if((fabrics_0[_S861].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S861, close_1.warp_1, _S888, true, _S889);
            close_1.weft_1 = with_blocked_0(_S861, close_1.weft_1, _S888, false, _S889);
        }
        points_1 = _S890;
        number_7 = number_7 + u32(1);
    }
    close_1.weight_0 = _S873;
    var _S891 : f32 = max(_S867, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S891);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S891);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S877, points_1, _S873 / _S891);
    if((_S868.prefiltered_0) > 0.0f)
    {
        var _S892 : Components_0 = prefiltered_components_0(_S861, _S862, to_face_frame_0(_S865, _S869), _S870, _S869);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S892, _S868.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S861, box_0, _S869);
    if((_S872 & ((central_weight_0 > 0.0f))))
    {
        var _S893 : SurfacePoint_0 = central_0;
        var _S894 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S894 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S894 = estimate_0.albedos_5.weft_5;
        }
        var _S895 : bool;
        if((fabrics_0[_S861].has_detail_0) != u32(0))
        {
            _S895 = has_hairs_0(_S861);
        }
        else
        {
            _S895 = false;
        }
        var cover_3 : f32;
        if(_S895)
        {
            cover_3 = hair_towards_0(_S861, hairs_over_0(_S861, central_0, _S869, _S871), _S870, _S871).cover_0;
        }
        else
        {
            cover_3 = 0.0f;
        }
        var _S896 : Albedos_0 = lerp_albedos_0(_S894, varied_at_0(_S861, central_0, _S894, _S869, _S871, cover_3), central_weight_0);
        if(_S893.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S896;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S896;
        }
    }
    return estimate_0;
}

fn scattered_by_0( _S897 : u32,  _S898 : Albedos_0,  _S899 : u32,  _S900 : vec3<f32>) -> Scattered_0
{
    var _S901 : u32 = u32(159) + u32(2) * _S899;
    var yarn_3 : Scattered_0;
    yarn_3.back_6 = _S900 * _S898.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S897, _S901)) * _S898.specular_reflect_0;
    yarn_3.through_0 = _S900 * _S898.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S897, _S901 + u32(1))) * _S898.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S902 : u32,  _S903 : u32,  _S904 : vec3<f32>,  _S905 : vec3<f32>,  _S906 : vec3<f32>,  _S907 : vec3<f32>,  _S908 : ptr<function, vec3<f32>>,  _S909 : ptr<function, vec3<f32>>)
{
    var _S910 : u32 = u32(146) + u32(4) * _S903;
    var _S911 : f32 = openness_number_0(_S902, _S910 + u32(1));
    var _S912 : f32 = openness_number_0(_S902, _S910 + u32(2));
    var _S913 : vec3<f32> = vec3<f32>(1.0f);
    var _S914 : vec3<f32> = _S913 - _S906 * vec3<f32>(openness_number_0(_S902, _S910));
    var _S915 : vec3<f32> = _S913 - _S907 * vec3<f32>(openness_number_0(_S902, _S910 + u32(3)));
    var _S916 : vec3<f32> = _S913 / (_S914 * _S915 - _S906 * _S907 * vec3<f32>((_S911 * _S912)));
    (*_S908) = (_S904 * _S915 + _S906 * vec3<f32>(_S911) * _S905) * _S916;
    (*_S909) = (_S905 * _S914 + _S907 * vec3<f32>(_S912) * _S904) * _S916;
    return;
}

fn face_sends_0( _S917 : u32,  _S918 : u32,  _S919 : Scattered_0,  _S920 : Scattered_0) -> FaceSends_0
{
    var _S921 : u32 = u32(2) * _S918;
    var _S922 : u32 = u32(142) + _S921;
    var _S923 : f32 = openness_number_0(_S917, _S922);
    var _S924 : f32 = openness_number_0(_S917, _S922 + u32(1));
    var _S925 : vec3<f32> = vec3<f32>((1.0f - _S923)) * _S919.back_6;
    var _S926 : vec3<f32> = vec3<f32>((1.0f - _S924)) * _S920.back_6;
    var sends_1 : FaceSends_0;
    var _S927 : u32 = u32(154) + _S921;
    var _S928 : f32 = openness_number_0(_S917, _S927);
    sends_1.blocks_warp_0 = _S928;
    var _S929 : f32 = openness_number_0(_S917, _S927 + u32(1));
    sends_1.blocks_weft_0 = _S929;
    sends_1.open_0 = _S928 * _S923 + _S929 * _S924;
    var _S930 : vec3<f32> = vec3<f32>(_S923) * _S919.back_6;
    var _S931 : vec3<f32> = vec3<f32>(_S924) * _S920.back_6;
    var _S932 : vec3<f32> = sends_1.sky_warp_0;
    var _S933 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S917, _S918, _S930, _S931, _S925, _S926, &(_S932), &(_S933));
    sends_1.sky_warp_0 = _S932;
    sends_1.sky_weft_0 = _S933;
    var _S934 : vec3<f32> = sends_1.crossing_warp_0;
    var _S935 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S917, _S918, _S919.through_0, _S920.through_0, _S925, _S926, &(_S934), &(_S935));
    sends_1.crossing_warp_0 = _S934;
    sends_1.crossing_weft_0 = _S935;
    return sends_1;
}

fn interior_of_0( _S936 : u32,  _S937 : vec3<f32>,  _S938 : bool) -> Interior_0
{
    var _S939 : Scattered_0 = scattered_by_0(_S936, table_albedos_0(families_0[fabrics_0[_S936].warp_0].colour_mean_0), u32(0), _S937);
    var _S940 : Scattered_0 = scattered_by_0(_S936, table_albedos_0(families_0[fabrics_0[_S936].weft_0].colour_mean_0), u32(1), _S937);
    var _S941 : FaceSends_0 = face_sends_0(_S936, select(u32(0), u32(1), _S938), _S939, _S940);
    var _S942 : FaceSends_0 = face_sends_0(_S936, select(u32(1), u32(0), _S938), _S939, _S940);
    var _S943 : vec3<f32> = vec3<f32>(_S941.blocks_warp_0);
    var _S944 : vec3<f32> = vec3<f32>(_S941.blocks_weft_0);
    var _S945 : vec3<f32> = _S943 * _S941.crossing_warp_0 + _S944 * _S941.crossing_weft_0;
    var _S946 : vec3<f32> = vec3<f32>(_S942.blocks_warp_0);
    var _S947 : vec3<f32> = vec3<f32>(_S942.blocks_weft_0);
    var _S948 : vec3<f32> = _S946 * _S942.crossing_warp_0 + _S947 * _S942.crossing_weft_0;
    var _S949 : f32 = 1.0f - _S941.open_0;
    var _S950 : f32 = 1.0f - _S942.open_0;
    var _S951 : vec3<f32> = vec3<f32>(1.0f);
    var _S952 : vec3<f32> = _S951 / (_S951 - _S945 * _S948 * vec3<f32>((_S949 * _S950)));
    var _S953 : vec3<f32> = _S948 * (vec3<f32>(_S941.open_0) + vec3<f32>(_S949) * (_S943 * _S941.sky_warp_0 + _S944 * _S941.sky_weft_0)) * _S952;
    var _S954 : vec3<f32> = _S945 * (vec3<f32>(_S942.open_0) + vec3<f32>(_S950) * (_S946 * _S942.sky_warp_0 + _S947 * _S942.sky_weft_0)) * _S952;
    var _S955 : FaceRadiance_0 = face_radiance_0(_S941, _S942.open_0, _S953, _S954);
    var _S956 : FaceRadiance_0 = face_radiance_0(_S942, _S941.open_0, _S954, _S953);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S955.warp_3;
    interior_1.weft_4 = _S955.weft_3;
    interior_1.leaked_1 = _S955.leaked_0;
    interior_1.far_1 = _S956.mean_1;
    interior_1.far_leaked_0 = _S956.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S957 : u32,  _S958 : vec3<f32>,  _S959 : bool,  _S960 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S958, &(terms_3));
    return blocked_of_terms_0(_S957, (select(u32(0), u32(2), _S960) + select(u32(1), u32(0), _S959)) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S961 : u32,  _S962 : vec3<f32>,  _S963 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S962, &(terms_4));
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
        var share_6 : f32 = share_5 + openness_number_0(_S961, u32(132) + select(u32(0), u32(5), _S963) + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S964 : u32,  _S965 : FamilyAlbedos_0,  _S966 : vec3<f32>,  _S967 : Interior_0,  _S968 : Blocked_0,  _S969 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S968, scattered_by_0(_S964, _S965.warp_5, u32(0), _S966), _S967), bounced_by_0(_S969, scattered_by_0(_S964, _S965.weft_5, u32(1), _S966), _S967));
}

fn bounced_far_0( _S970 : u32,  _S971 : FamilyAlbedos_0,  _S972 : vec3<f32>,  _S973 : Interior_0,  _S974 : vec3<f32>,  _S975 : bool,  _S976 : f32,  _S977 : f32,  _S978 : f32) -> Bounced_0
{
    var _S979 : Blocked_0 = blocked_from_0(_S970, _S974, true, _S975);
    var _S980 : Blocked_0 = blocked_from_0(_S970, _S974, false, _S975);
    var _S981 : f32 = _S976 / max(1.0f - _S979.by_warp_0 - _S979.by_weft_0, 0.10000000149011612f);
    var _S982 : f32 = (0.0020000000949949f * warp_seen_from_0(_S970, _S974, _S975) + _S981) / (_S981 + _S977 / max(1.0f - _S980.by_warp_0 - _S980.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S983 : f32 = 1.0f - _S978;
    return bounced_of_families_0(_S970, _S971, _S972, _S973, scaled_0(_S979, _S982 * _S983), scaled_0(_S980, (1.0f - _S982) * _S983));
}

fn bounced_over_0( _S984 : u32,  _S985 : Components_0,  _S986 : CloseUp_0,  _S987 : FamilyAlbedos_0,  _S988 : vec3<f32>,  _S989 : vec3<f32>) -> Bounced_0
{
    var _S990 : bool = (_S989.z) < 0.0f;
    var _S991 : Interior_0 = interior_of_0(_S984, _S988, _S990);
    var bounced_2 : Bounced_0 = bounced_far_0(_S984, _S987, _S988, _S991, to_face_frame_0(_S989, _S990), _S990, _S985.diffuse_warp_0, _S985.diffuse_weft_0, _S985.hole_2);
    if((_S986.weight_0) > 0.0f)
    {
        var _S992 : Bounced_0 = bounced_of_families_0(_S984, _S987, _S988, _S991, _S986.warp_1, _S986.weft_1);
        var _S993 : vec3<f32> = vec3<f32>(_S986.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S992.reflected_0, _S993);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S992.transmitted_0, _S993);
    }
    return bounced_2;
}

fn composed_0( _S994 : u32,  _S995 : Components_0,  _S996 : CloseUp_0,  _S997 : FamilyAlbedos_0,  _S998 : vec3<f32>,  _S999 : vec3<f32>,  _S1000 : vec3<f32>) -> vec3<f32>
{
    var _S1001 : Albedos_0 = tinted_0(_S997.warp_5, _S998);
    var _S1002 : Albedos_0 = tinted_0(_S997.weft_5, _S998);
    var _S1003 : vec3<f32> = vec3<f32>(_S995.diffuse_warp_0);
    var _S1004 : vec3<f32> = vec3<f32>(_S995.diffuse_weft_0);
    var _S1005 : vec3<f32> = vec3<f32>(_S995.specular_warp_0);
    var _S1006 : vec3<f32> = vec3<f32>(_S995.specular_weft_0);
    var _S1007 : vec3<f32> = _S1001.diffuse_reflect_0 * _S1003 + _S1002.diffuse_reflect_0 * _S1004 + _S1001.specular_reflect_0 * _S1005 + _S1002.specular_reflect_0 * _S1006;
    var _S1008 : f32 = _S1000.z;
    var body_0 : vec3<f32>;
    if((_S999.z * _S1008) < 0.0f)
    {
        body_0 = _S1001.diffuse_transmit_0 * _S1003 + _S1002.diffuse_transmit_0 * _S1004 + _S1001.specular_transmit_0 * _S1005 + _S1002.specular_transmit_0 * _S1006;
    }
    else
    {
        body_0 = _S1007;
    }
    if((fabrics_0[_S994].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S994, _S995, _S996, _S997, _S998, _S1000), _S999, _S1000);
    }
    var _S1009 : f32 = fabrics_0[_S994].sheen_strength_0;
    if((fabrics_0[_S994].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S1010 : bool = _S1008 < 0.0f;
    var _S1011 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S999, _S1010), to_face_frame_0(_S1000, _S1010), _S1009, fabrics_0[_S994].sheen_roughness_0);
    return vec3<f32>(_S1011.y) * body_0 + vec3<f32>(((_S995.light_visibility_1 + _S995.hole_2) * _S1011.x));
}

fn light_of_footprint_0( _S1012 : u32,  _S1013 : VisiblePoint_0,  _S1014 : vec2<u32>,  _S1015 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S1013.draft_0;
    footprint_0.dx_0 = _S1013.draft_dx_0;
    footprint_0.dy_0 = _S1013.draft_dy_0;
    var _S1016 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S1017 : vec3<f32> = to_local_0(_S1013, _S1013.view_0);
    var _S1018 : u32 = light_sample_count_0();
    var _S1019 : vec3<f32> = vec3<f32>(0.0f);
    var number_8 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S1019;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        if(number_8 < (max(_S1018, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S1020 : f32;
        if(number_8 < _S1018)
        {
            _S1020 = visibility_at_0(number_8, _S1014);
        }
        else
        {
            _S1020 = 0.0f;
        }
        var _S1021 : bool;
        if(_S1020 <= 0.0f)
        {
            _S1021 = number_8 > u32(0);
        }
        else
        {
            _S1021 = false;
        }
        if(_S1021)
        {
            number_8 = number_8 + u32(1);
            continue;
        }
        var _S1022 : LightSample_0 = light_sample_0(number_8, _S1014, _S1013.position_0);
        var _S1023 : vec3<f32> = to_local_0(_S1013, _S1022.towards_0);
        var _S1024 : Estimate_0 = lobes_estimate_of_pass_0(_S1012, footprint_0, 1.0f, _S1016, _S1023, _S1017);
        radiance_1 = radiance_1 + vec3<f32>(_S1020) * _S1022.irradiance_1 * composed_0(_S1012, _S1024.components_0, _S1024.close_0, _S1024.albedos_5, _S1015, _S1023, _S1017);
        hole_7 = _S1024.components_0.hole_2;
        number_8 = number_8 + u32(1);
    }
    var _S1025 : f32 = fabrics_0[_S1012].sheen_strength_0;
    if((fabrics_0[_S1012].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S1025 * sheen_lobe_0(abs(_S1017.z), fabrics_0[_S1012].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S1026 : u32 = id_0.x;
    var _S1027 : bool;
    if(_S1026 >= (frame_record_0.width_0))
    {
        _S1027 = true;
    }
    else
    {
        _S1027 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S1027)
    {
        return;
    }
    var _S1028 : u32 = id_0.y * frame_record_0.width_0 + _S1026;
    var _S1029 : u32 = layers_0[_S1028].face_0;
    if((layers_0[_S1028].face_0) == u32(0))
    {
        return;
    }
    var _S1030 : u32 = _S1029 - u32(1);
    var _S1031 : u32 = fabric_of_0(_S1030);
    var _S1032 : vec2<u32> = id_0.xy;
    var _S1033 : VisiblePoint_0 = visible_point_0(_S1031, _S1030, _S1032);
    var _S1034 : vec4<f32> = light_of_footprint_0(_S1031, _S1033, _S1032, filtered_albedo_0(_S1031, _S1033));
    accumulate_0(_S1028, _S1034);
    return;
}

