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

@binding(6) @group(0) var<storage, read_write> visibilities_0 : array<f32>;

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

fn square_1( x_2 : f32) -> f32
{
    return x_2 * x_2;
}

fn natural_logarithm_0( x_3 : f32) -> f32
{
    var _S1 : u32 = (bitcast<u32>((x_3)));
    var m_0 : f32 = (bitcast<f32>(((((_S1 & (u32(8388607)))) | (u32(1056964608))))));
    var _S2 : bool = m_0 < 0.70710676908493042f;
    var exponent_0 : f32 = f32(i32((_S1 >> (u32(23)))) - i32(126)) - select(0.0f, 1.0f, _S2);
    var m_1 : f32 = select(m_0, m_0 + m_0, _S2) - 1.0f;
    var _S3 : f32 = m_1 * m_1;
    return m_1 + (((((((((0.07037683576345444f * m_1 - 0.11514610052108765f) * m_1 + 0.11676998436450958f) * m_1 - 0.12420140951871872f) * m_1 + 0.14249323308467865f) * m_1 - 0.16668057441711426f) * m_1 + 0.20000714063644409f) * m_1 - 0.24999994039535522f) * m_1 + 0.33333331346511841f) * m_1 * _S3 - exponent_0 * 0.00021219444170129f - 0.5f * _S3) + exponent_0 * 0.693359375f;
}

fn binary_logarithm_0( x_4 : f32) -> f32
{
    return natural_logarithm_0(x_4) * 1.4426950216293335f;
}

fn exponential_0( x_5 : f32) -> f32
{
    var _S4 : f32 = clamp(x_5, -87.0f, 88.0f);
    var _S5 : f32 = floor(_S4 * 1.4426950216293335f + 0.5f);
    var _S6 : f32 = _S4 - _S5 * 0.693359375f + _S5 * 0.00021219444170129f;
    return select(((((((0.00019875691214111f * _S6 + 0.00139819993637502f) * _S6 + 0.00833345204591751f) * _S6 + 0.04166579619050026f) * _S6 + 0.1666666567325592f) * _S6 + 0.5f) * _S6 * _S6 + _S6 + 1.0f) * (bitcast<f32>(((u32(i32(_S5) + i32(127)) << (u32(23)))))), 0.0f, x_5 < -87.0f);
}

fn map_texel_0( index_0 : u32) -> vec3<f32>
{
    var _S7 : u32 = scene_words_0[index_0];
    var _S8 : vec3<f32> = vec3<f32>(f32((_S7 & (u32(1023)))), f32((((_S7 >> (u32(10)))) & (u32(1023)))), f32((_S7 >> (u32(20))))) / vec3<f32>(1023.0f);
    return _S8 * _S8;
}

fn map_level_0( first_1 : u32,  side_0 : u32,  uv_0 : vec2<f32>) -> vec3<f32>
{
    var _S9 : f32 = uv_0.x;
    var _S10 : f32 = f32(side_0);
    var _S11 : f32 = (_S9 - floor(_S9)) * _S10 - 0.5f;
    var _S12 : f32 = uv_0.y;
    var _S13 : f32 = (_S12 - floor(_S12)) * _S10 - 0.5f;
    var _S14 : f32 = floor(_S11);
    var _S15 : i32 = i32(side_0);
    var _S16 : u32 = side_0 - u32(1);
    var _S17 : u32 = (u32(i32(_S14) + _S15) & (_S16));
    var _S18 : f32 = floor(_S13);
    var _S19 : u32 = (u32(i32(_S18) + _S15) & (_S16));
    var _S20 : u32 = ((_S17 + u32(1)) & (_S16));
    var _S21 : u32 = first_1 + _S19 * side_0;
    var _S22 : vec3<f32> = vec3<f32>((_S11 - _S14));
    var _S23 : u32 = first_1 + (((_S19 + u32(1)) & (_S16))) * side_0;
    return mix(mix(map_texel_0(_S21 + _S17), map_texel_0(_S21 + _S20), _S22), mix(map_texel_0(_S23 + _S17), map_texel_0(_S23 + _S20), _S22), vec3<f32>((_S13 - _S18)));
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
    var _S24 : u32 = value_0 * u32(747796405) + u32(2891336453);
    var _S25 : u32 = ((((_S24 >> ((((_S24 >> (u32(28)))) + u32(4))))) ^ (_S24))) * u32(277803737);
    return (((_S25 >> (u32(22)))) ^ (_S25));
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
    var _S26 : u32 = pixel_0.x;
    var _S27 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S26, _S27, stream_2), uniform_hash_0(_S26, _S27, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
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
        var _S28 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S28)) <= number_0)
        {
            low_0 = _S28;
        }
        else
        {
            high_0 = _S28;
        }
    }
    var _S29 : u32 = table_0 + low_0;
    var _S30 : f32 = scene_number_0(_S29);
    var _S31 : f32 = scene_number_0(_S29 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_3 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S30) / max(_S31 - _S30, 9.999999960041972e-13f));
    return choice_0;
}

fn mean_0( colour_0 : vec3<f32>) -> f32
{
    return (colour_0.x + colour_0.y + colour_0.z) / 3.0f;
}

fn sine_cosine_0( x_6 : f32) -> vec2<f32>
{
    var _S32 : f32 = floor(x_6 * 0.63661974668502808f + 0.5f);
    var _S33 : f32 = x_6 - _S32 * 1.5703125f - _S32 * 0.00048375129699707f - _S32 * 7.54979012640433211e-08f;
    var _S34 : f32 = _S33 * _S33;
    var _S35 : f32 = ((-0.00019515295571182f * _S34 + 0.00833216123282909f) * _S34 - 0.16666655242443085f) * _S34 * _S33 + _S33;
    var _S36 : f32 = ((0.00002443315679557f * _S34 - 0.00138873164542019f) * _S34 + 0.04166664555668831f) * _S34 * _S34 - 0.5f * _S34 + 1.0f;
    var _S37 : u32 = (u32(i32(_S32)) & (u32(3)));
    var _S38 : vec2<f32> = select_vector_0(((_S37 & (u32(1)))) != u32(0), vec2<f32>(_S36, _S35), vec2<f32>(_S35, _S36));
    var _S39 : f32 = _S38.x;
    var _S40 : f32 = _S38.y;
    return vec2<f32>(select(_S39, - _S39, ((_S37 & (u32(2)))) != u32(0)), select(_S40, - _S40, (((_S37 + u32(1)) & (u32(2)))) != u32(0)));
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
    var _S41 : vec2<f32> = this_0.dx_0;
    var _S42 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S41, _S41) + dot(_S42, _S42)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S43 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S43, - _S43, back_2));
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
     shown_share_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32,  shown_share_1 : f32) -> SurfacePoint_0
{
    var _S44 : SurfacePoint_0;
    _S44.hole_0 = hole_1;
    _S44.is_warp_0 = is_warp_1;
    _S44.warp_thread_0 = warp_thread_1;
    _S44.weft_thread_0 = weft_thread_1;
    _S44.height_2 = height_3;
    _S44.normal_1 = normal_2;
    _S44.tangent_0 = tangent_1;
    _S44.across_0 = across_1;
    _S44.fibre_across_0 = fibre_across_1;
    _S44.fibre_along_0 = fibre_along_1;
    _S44.shown_share_0 = shown_share_1;
    return _S44;
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
    var _S45 : Blocked_0 = no_blocked_0();
    nothing_2.warp_1 = _S45;
    nothing_2.weft_1 = _S45;
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
    var _S46 : f32 = clamp((-3.0f - binary_logarithm_0(max(threads_0, 9.99999971718068537e-10f))) / 2.0f, 0.0f, 1.0f);
    var quality_0 : SearchQuality_0;
    var _S47 : f32 = mix(2.5f, 5.0f, _S46);
    quality_0.steps_per_thread_0 = _S47;
    quality_0.steps_per_relief_0 = _S47;
    quality_0.shadow_share_0 = mix(1.60000002384185791f, 1.0f, _S46);
    quality_0.refinements_0 = u32(mix(1.0f, 2.0f, _S46) + 0.5f);
    return quality_0;
}

fn turns_and_remainder_0( family_0 : u32,  index_4 : f32) -> vec2<f32>
{
    var _S48 : f32 = floor(fma(index_4, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S48, fma(- _S48, families_0[family_0].count_0, index_4));
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
    var _S49 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S50 : f32 = fma(- _S49, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S50;
    cell_2.above_0 = families_0[family_1].size_0 - _S50;
    cell_2.across_2 = _S50 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S49).y, 0.0f, families_0[family_1].count_0 - 1.0f));
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
    var _S51 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S52 : u32 = min(thread_3 + select(u32(0), u32(1), _S51 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S53 : u32 = families_0[family_2].place_table_0 + _S52 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S52;
    cell_3.below_0 = _S51 - table_number_0(_S53);
    cell_3.above_0 = table_number_0(_S53 + u32(1)) - _S51;
    cell_3.across_2 = _S51 - table_number_0(_S53 + u32(2));
    cell_3.half_width_1 = table_number_0(_S53 + u32(3));
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
    var _S54 : bool = (abs(crossing_0.warp_2.across_2)) < (crossing_0.warp_2.half_width_1);
    var shown_0 : Shown_0;
    var _S55 : bool = !((abs(crossing_0.weft_2.across_2)) < (crossing_0.weft_2.half_width_1));
    var _S56 : bool = (_S54 & (((_S55 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_2 = _S56;
    shown_0.hole_3 = ((!_S54) & (_S55));
    var _S57 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S56);
    shown_0.word_0 = _S57;
    shown_0.on_top_0 = (((_S57 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_3 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_4 : Cell_0;
    cell_4.thread_2 = select(second_0.thread_2, first_3.thread_2, is_first_0);
    cell_4.across_2 = select(second_0.across_2, first_3.across_2, is_first_0);
    cell_4.half_width_1 = select(second_0.half_width_1, first_3.half_width_1, is_first_0);
    cell_4.below_0 = select(second_0.below_0, first_3.below_0, is_first_0);
    cell_4.above_0 = select(second_0.above_0, first_3.above_0, is_first_0);
    return cell_4;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S58 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S58.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S58.y) * u32(4)));
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
    var _S59 : u32 = families_0[family_6].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S59);
    bend_0.half_tangent_0 = table_number_0(_S59 + u32(1));
    bend_0.arc_0 = table_number_0(_S59 + u32(2));
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
    var _S60 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S61 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S62 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S63 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S64 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S64;
    var _S65 : i32 = - _S60;
    var _S66 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S65, i32(0));
    run_0.from_start_0 = _S66;
    var _S67 : i32 = _S61 + i32(1);
    var _S68 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S67);
    run_0.to_end_0 = _S68;
    var _S69 : bool = _S66 < _S68;
    run_0.near_start_0 = _S69;
    var _S70 : i32 = select(_S67, _S65 - _S62, _S69);
    var _S71 : i32 = select(_S67 + _S63, _S65, _S69);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S66, _S68), 1.0e+06f, _S64);
    run_0.reach_0 = min(0.5f * (_S66 + _S68), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S70, _S71), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S60 == i32(0);
    run_0.last_crossing_0 = _S61 == i32(0);
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
    var _S72 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S73 : f32 = clamp(cell_5.across_2, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_3 = _S73;
    var _S74 : f32 = _S72 * _S72 - square_1(_S73);
    var _S75 : f32 = rsqrt_0(_S74);
    section_0.drop_0 = _S72 - _S74 * _S75;
    section_0.slope_0 = - _S73 * _S75;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec2<f32>
{
    var _S76 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S77 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S78 : f32 = select(crossed_1.above_0 + crossed_1.across_2, crossed_1.below_0 - crossed_1.across_2, _S76) - crossed_1.half_width_1;
    var _S79 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S76);
    var _S80 : f32;
    if(shown_1.on_top_0)
    {
        _S80 = 0.0f;
    }
    else
    {
        _S80 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S81 : f32;
    if((shown_1.on_top_0) != _S79)
    {
        _S81 = 0.0f;
    }
    else
    {
        _S81 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S76));
    }
    var _S82 : f32 = 1.0f / max(2.0f * _S78, 9.999999960041972e-13f);
    var _S83 : f32 = clamp((_S78 - _S77) * _S82, 0.0f, 1.0f);
    return vec2<f32>(_S80 + (_S81 - _S80) * (_S83 * _S83 * (3.0f - 2.0f * _S83)), (_S80 - _S81) * (6.0f * _S83 * (1.0f - _S83) * _S82) * select(-1.0f, 1.0f, _S76));
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
    var _S84 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S84), 9.99999971718068537e-10f);
    var _S85 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S85), 9.99999971718068537e-10f);
    control_0.right_0 = _S84 > 0.0f;
    control_0.up_0 = _S85 > 0.0f;
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
    var _S86 : f32 = select(- cell_6.across_2, cell_6.across_2, forwards_0);
    var _S87 : f32 = select(cell_6.below_0, cell_6.above_0, forwards_0);
    var _S88 : f32 = - cell_6.half_width_1;
    var _S89 : bool = _S86 < _S88;
    var _S90 : bool = _S86 >= (cell_6.half_width_1);
    var _S91 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_3)));
    var _S92 : f32 = select(cell_6.half_width_1, _S88, _S89) - _S86;
    var _S93 : f32 = select(_S87, 2.0f * _S87 + _S86 - cell_6.half_width_1, ((shown_2.hole_3) | (((_S91 & ((!shown_2.on_top_0)))))));
    if((((_S91 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S89)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S92, _S93, _S90);
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
    var _S94 : f32 = previous_1.rate_0 * step_4;
    var _S95 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_4)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S94) >= 0.0f) & (((3.0f * clearance_1 - _S95) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S96 : f32 = clearance_1 - previous_1.clearance_0;
    var _S97 : f32 = 6.0f * _S96 - 4.0f * _S94 - 2.0f * _S95;
    var _S98 : f32 = -2.0f * _S94 / max(_S97 + sqrt(max(_S97 * _S97 - 4.0f * (3.0f * (_S94 + _S95 - 2.0f * _S96)) * _S94, 0.0f)), 9.99999968265522539e-21f);
    var _S99 : f32 = 1.0f - _S98;
    return select(-1.0f, _S99 * step_4, ((((_S98 > 0.01999999955296516f) & ((_S99 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S98 + 1.0f) + _S94 * _S98) * _S99 * _S99 + (clearance_1 * (2.0f * _S99 + 1.0f) - _S95 * _S99) * _S98 * _S98) < 0.0f))));
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
    var _S100 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S100, 0.0f) + this_2.epsilon_0, _S100 - this_2.epsilon_0, ((((!here_2.hole_4) & (((rate_3 * _S100 + clearance_3) < 0.0f)))) & ((_S100 > (2.0f * this_2.epsilon_0))))));
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
    var _S101 : f32 = end_0 - start_1;
    var _S102 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S101;
    var _S103 : f32 = 3.0f * _S101 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S101, 9.99999968265522539e-21f);
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
        var _S104 : f32 = clamp(share_1 - (((_S102 * share_1 + _S103) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S102 * share_1 + 2.0f * _S103) * share_1 + start_rate_0, 0.10000000149011612f * _S101 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S105 : i32 = i_0 + i32(1);
        share_1 = _S104;
        i_0 = _S105;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S106 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S107 : f32 = rsqrt_0(_S106);
    var _S108 : f32 = sine_1 * _S107 * rsqrt_0(_S106 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S108 * _S106, _S108 * across_slope_0 * along_slope_0 + cosine_0 * _S107);
}

fn arc_sine_0( x_8 : f32) -> f32
{
    var _S109 : f32 = abs(x_8);
    var _S110 : bool = _S109 > 0.5f;
    var _S111 : f32 = select(_S109 * _S109, 0.5f * (1.0f - _S109), _S110);
    var _S112 : f32 = select(_S109, sqrt(max(_S111, 0.0f)), _S110);
    var _S113 : f32 = ((((0.04216320067644119f * _S111 + 0.02418131195008755f) * _S111 + 0.04547002539038658f) * _S111 + 0.07495300471782684f) * _S111 + 0.16666752099990845f) * _S111 * _S112 + _S112;
    var _S114 : f32 = select(_S113, 1.57079637050628662f - 2.0f * _S113, _S110);
    return select(_S114, - _S114, x_8 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S115 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S115 / (_S115 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S116 : Hair_0;
    _S116.cover_0 = cover_1;
    _S116.normal_3 = normal_4;
    _S116.tangent_2 = tangent_3;
    return _S116;
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
    var _S117 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S117, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S117, 2.0f * (across_4 / width_2 - _S117) - 1.0f);
}

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S118 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S118 - floor(_S118)) - 1.0f;
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
    var _S119 : f32 = floor(position_4);
    var _S120 : f32 = position_4 - _S119;
    var _S121 : u32 = u32(i32(_S119));
    var _S122 : f32 = signed_noise_0(hash_bits_0(key_1, _S121));
    var _S123 : f32 = signed_noise_0(hash_bits_0(key_1, _S121 + u32(1)));
    return vec2<f32>(mix(_S122, _S123, smooth_share_0(_S120)), 6.0f * _S120 * (1.0f - _S120) * (_S123 - _S122));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S124 : f32 = cell_7.y;
    var _S125 : f32 = floor(_S124);
    var _S126 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S125));
    var _S127 : u32 = hash_bits_0(key_2, _S126);
    var _S128 : u32 = hash_bits_0(key_2, _S126 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S127), signed_noise_0((_S127 >> (u32(16))))), vec2<f32>(signed_noise_0(_S128), signed_noise_0((_S128 >> (u32(16))))), vec2<f32>(smooth_share_0(_S124 - _S125)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S129 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S129.x, _S129.y), _S129.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S130 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S130.x, _S130.y), _S130.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
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
    var _S131 : vec3<f32> = select_vector_1((dot(frame_0.tangent_4, hair_0.tangent_2)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_2), hair_0.tangent_2);
    var blended_0 : YarnFrame_0;
    var _S132 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S133 : vec3<f32> = normalize(mix(frame_0.normal_5, hair_0.normal_3, _S132));
    blended_0.normal_5 = _S133;
    var _S134 : vec3<f32> = mix(frame_0.tangent_4, _S131, _S132);
    var _S135 : vec3<f32> = _S134 - vec3<f32>(dot(_S134, _S133)) * _S133;
    blended_0.tangent_4 = _S135 * vec3<f32>(rsqrt_0(max(dot(_S135, _S135), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_5.z - 1.0f) + 1.0f));
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_6 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S136 : f32 = light_1.z;
    if(_S136 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S136, 0.0f), max(dot(light_1, normal_6), 0.0f), blend_1);
}

fn projected_area_1( direction_3 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S137 : f32 = dot(direction_3, tangent_5);
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

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S140 : vec3<f32> = light_2 + view_1;
    var _S141 : f32 = dot(_S140, tangent_6);
    return flake_density_0(min(_S141 * _S141 / max(square_0(_S140), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S142 : f32 = - dot(light_3, normal_7);
    var _S143 : f32 = dot(view_2, normal_7);
    if(((_S142 <= 0.0f) | ((_S143 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S144 : f32 = 1.0f / max(_S143, 9.99999997475242708e-07f);
    var _S145 : f32 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S142, 9.99999997475242708e-07f);
    var _S146 : f32 = projected_area_1(view_2, tangent_7, roughness_4) * _S144;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S145, _S146)) * mean_attenuation_0(optical_depth_1 * abs(_S145 - _S146)) * _S144;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S147 : f32 = dot(light_4, normal_8);
    var _S148 : f32 = dot(view_3, normal_8);
    if(((_S147 <= 0.0f) | ((_S148 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S149 : f32 = max(_S147, 9.99999997475242708e-07f);
    var _S150 : f32 = max(_S148, 9.99999997475242708e-07f);
    var _S151 : f32 = projected_area_1(light_4, tangent_8, roughness_5) * _S150 + projected_area_1(view_3, tangent_8, roughness_5) * _S149;
    var _S152 : f32 = optical_depth_2 * _S151 / (_S149 * _S150);
    return 0.25f * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S152 * mean_attenuation_0(_S152)) * _S149 / _S151;
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
    var _S153 : f32 = abs(x_10);
    var _S154 : f32 = abs(y_3);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S153, _S154) / max(max(_S153, _S154), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S154 > _S153);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_10 < 0.0f);
    return select(angle_2, - angle_2, y_3 < 0.0f);
}

struct NodeTaps_0
{
     nodes_0 : vec4<u32>,
     weights_0 : vec4<u32>,
     inverse_sum_0 : f32,
};

fn node_taps_of_0( direction_4 : vec3<f32>,  azimuths_0 : u32) -> NodeTaps_0
{
    var _S155 : f32 = arc_tangent_0(direction_4.y, direction_4.x) * (0.5f * f32(azimuths_0) * 0.31830987334251404f);
    var _S156 : f32 = floor(_S155);
    var _S157 : f32 = _S155 - _S156;
    var _S158 : f32 = sqrt(clamp((1.0f - abs(direction_4.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S159 : f32 = 7.0f * _S158 * sqrt(_S158);
    var _S160 : f32 = min(floor(_S159), 6.0f);
    var _S161 : f32 = _S159 - _S160;
    var _S162 : u32 = u32(i32(_S156) + i32(azimuths_0)) % azimuths_0;
    var _S163 : u32 = u32(_S160);
    var _S164 : u32 = _S162 * u32(8) + _S163;
    var _S165 : u32 = (_S162 + u32(1)) % azimuths_0;
    var _S166 : u32 = _S165 * u32(8) + _S163;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S164, _S164 + u32(1), _S166, _S166 + u32(1));
    var _S167 : f32 = 1.0f - _S157;
    var _S168 : f32 = 1.0f - _S161;
    var _S169 : vec4<u32> = vec4<u32>(vec4<f32>(_S167 * _S168, _S167 * _S161, _S157 * _S168, _S157 * _S161) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S169;
    taps_0.inverse_sum_0 = 1.0f / f32(_S169.x + _S169.y + _S169.z + _S169.w);
    return taps_0;
}

fn node_taps_0( direction_5 : vec3<f32>) -> NodeTaps_0
{
    var _S170 : NodeTaps_0 = node_taps_of_0(direction_5, u32(32));
    return _S170;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S171 : vec3<f32> = light_5 + view_4;
    return _S171 * vec3<f32>(rsqrt_0(max(square_0(_S171), 9.999999960041972e-13f)));
}

fn joint_terms_0( taps_1 : NodeTaps_0,  table_1 : u32,  ratio_1 : u32) -> vec4<f32>
{
    var _S172 : vec4<f32> = vec4<f32>(0.0f);
    var i_1 : u32 = u32(0);
    var sums_2 : vec4<f32> = _S172;
    for(;;)
    {
        if(i_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S173 : u32 = table_1 + u32(4) * taps_1.nodes_0[i_1] + u32(2) * ratio_1;
        var _S174 : vec2<u32> = vec2<u32>(words_0[_S173], words_0[_S173 + u32(1)]);
        var sums_3 : vec4<f32> = sums_2 + vec4<f32>(((vec4<i32>(vec2<i32>((_S174 << (vec2<u32>(u32(16))))), vec2<i32>(_S174)).xzyw) >> (vec4<u32>(u32(16))))) * vec4<f32>(f32(taps_1.weights_0[i_1]));
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
    var _S175 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S176 : vec4<u32> = ((packs_1 & (_S175))) * taps_2.weights_0;
    var _S177 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S175))) * taps_2.weights_0;
    return bytes_of_sums_0(_S176.x + _S176.y + _S176.z + _S176.w, _S177.x + _S177.y + _S177.z + _S177.w) * vec4<f32>(taps_2.inverse_sum_0);
}

fn interpolate_table_0( taps_3 : NodeTaps_0,  table_2 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S178 : vec4<u32> = vec4<u32>(table_2) + taps_3.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_3, vec4<u32>(words_0[_S178.x], words_0[_S178.y], words_0[_S178.z], words_0[_S178.w]));
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
    var _S179 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_9 = _S179;
    var _S180 : f32 = table_number_0(row_1 + u32(7));
    var _S181 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S180, _S181, 1.0f - square_0(_S179) - _S180 - _S181);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn Group_variance_along_0( this_5 : Group_0,  direction_6 : vec3<f32>) -> f32
{
    var _S182 : f32 = direction_6.x;
    var _S183 : f32 = direction_6.y;
    var _S184 : f32 = direction_6.z;
    return max(dot(this_5.variance_0, direction_6 * direction_6) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S182 * _S183, _S182 * _S184, _S183 * _S184)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_7 : vec3<f32>) -> f32
{
    var _S185 : f32 = dot(direction_7, group_1.tangent_9);
    var _S186 : f32 = group_1.roughness_6;
    var _S187 : f32 = _S186 * _S186;
    return sqrt(max((_S187 - 1.0f) * (_S185 * _S185 + Group_variance_along_0(group_1, direction_7)) + 1.0f, _S187));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S188 : f32 = group_2.roughness_6;
    var _S189 : f32 = max(sqrt(max(1.0f - _S188 * _S188, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S190 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S191 : f32 = dot(half_0, group_2.tangent_9);
    var _S192 : f32 = _S189 * (_S191 - _S190);
    var _S193 : f32 = _S189 * (_S191 + _S190);
    var _S194 : f32 = _S192 * _S193;
    var _S195 : f32 = 2.0f * _S190 * _S189;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S194) / ((_S192 * _S192 + 1.0f) * (_S193 * _S193 + 1.0f)) + arc_tangent_0(_S195, 1.0f + _S194) / _S195);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S196 : bool = (light_6.z) < 0.0f;
    var _S197 : f32 = dot(light_6, group_3.normal_9);
    var _S198 : f32 = max(dot(view_5, group_3.normal_9), 0.01999999955296516f);
    var _S199 : f32 = mean_area_0(group_3, light_6) / max(select(_S197, - _S197, _S196), 0.01999999955296516f);
    var _S200 : f32 = mean_area_0(group_3, view_5) / _S198;
    var _S201 : f32 = optical_depth_3 * max(select(_S199 + _S200, abs(_S199 - _S200), _S196), 0.00100000004749745f);
    return 0.25f * mean_density_0(group_3, half_1) * select(1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_9)), 1.0f, _S196) * (optical_depth_3 * select(1.0f, exponential_0(- optical_depth_3 * min(_S199, _S200)), _S196) * (1.0f - exponential_0(- _S201)) / _S201 / _S198);
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
    var _S202 : Cell_0 = locate_0(family_10, position_6);
    var _S203 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S202.thread_2 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_12 = _S202.thread_2;
    bound_0.turns_2 = round((position_6 - families_0[family_10].start_0 - _S203 - _S202.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_9 = _S202.below_0;
    var _S204 : f32 = 2.0f * _S202.half_width_1;
    bound_0.width_3 = _S204;
    bound_0.visible_0 = clamp((_S202.across_2 + _S202.half_width_1) / _S204, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S202.below_0, _S202.below_0 - _S202.across_2 - _S202.half_width_1) + max(_S202.across_2 - _S202.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S205 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S206 : f32 = 0.5f * max(size_2, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_11, _S205 - _S206);
    stretch_0.high_1 = bound_at_0(family_11, _S205 + _S206);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S207 : f32 = Stretch_turns_0(stretch_1);
    var _S208 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_1.thread_12;
    var _S209 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_1.thread_12;
    var _S210 : f32 = table_number_0(_S209) - table_number_0(_S208);
    var _S211 : f32 = table_number_0(_S209 + u32(1)) - table_number_0(_S208 + u32(1));
    return vec3<f32>(_S210 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_3 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_3 + _S207 * families_0[family_12].visible_total_0, _S211 - _S210 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S207 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S211 + stretch_1.high_1.cell_9 - stretch_1.low_1.cell_9 + _S207 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S212 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S213 : u32 = families_0[family_13].colour_threads_0 + _S212 * stretch_2.low_1.thread_12 + quantity_0;
    var _S214 : u32 = families_0[family_13].colour_threads_0 + _S212 * stretch_2.high_1.thread_12 + quantity_0;
    var _S215 : u32 = families_0[family_13].colour_threads_0 + _S212 * u32(families_0[family_13].count_0) + quantity_0;
    var _S216 : f32 = table_number_0(_S213);
    var _S217 : f32 = table_number_0(_S214);
    var _S218 : f32 = Stretch_turns_0(stretch_2);
    var _S219 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S214 + families_0[family_13].quantities_0) - table_number_0(_S213 + families_0[family_13].quantities_0) + _S217 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_3 - _S216 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_3 + _S218 * table_number_0(_S215 + families_0[family_13].quantities_0), table_number_0(_S214 + _S219) - table_number_0(_S213 + _S219) + _S217 * stretch_2.high_1.cell_9 - _S216 * stretch_2.low_1.cell_9 + _S218 * table_number_0(_S215 + _S219));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_12) < (this_7.low_1.thread_12);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S220 : u32 = entries_0.z;
    var _S221 : u32 = entries_0.x;
    return vec4<u32>(_S220 - _S221 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S220, entries_0.y - _S221, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_2 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S222 : u32 = row_2 + across_5.low_1.thread_12 * quantities_1;
    var _S223 : u32 = row_2 + across_5.high_1.thread_12 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S222], words_0[_S222 + quantities_1], words_0[_S223], words_0[_S223 + quantities_1]), words_0[row_2 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_1.visible_0, - this_9.low_1.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_14 : u32,  across_6 : Stretch_0,  along_1 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S224 : u32 = u32(families_0[family_14].count_0);
    var _S225 : u32 = (_S224 + u32(1)) * families_0[family_14].quantities_0;
    var _S226 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S227 : vec4<u32> = row_differences_0(across_6, _S226 + along_1.low_1.thread_12 * _S225, _S224, families_0[family_14].quantities_0);
    var _S228 : vec4<u32> = row_differences_0(across_6, _S226 + along_1.high_1.thread_12 * _S225, _S224, families_0[family_14].quantities_0);
    var _S229 : vec4<u32> = row_differences_0(across_6, _S226 + crossing_count_0 * _S225, _S224, families_0[family_14].quantities_0);
    var _S230 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S228 - _S227 + select_vector_2(Stretch_wraps_0(along_1), _S229, vec4<u32>(vec4<i32>(i32(0)))))), _S230), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S226 + (along_1.high_1.thread_12 + u32(1)) * _S225, _S224, families_0[family_14].quantities_0) - _S228)), _S230), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S226 + (along_1.low_1.thread_12 + u32(1)) * _S225, _S224, families_0[family_14].quantities_0) - _S227)), _S230), dot(vec4<f32>(vec4<i32>(_S229)), _S230)), Stretch_weights_0(along_1)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S231 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S232 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S232 * _S231.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S232 * _S231.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S232 * _S231.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S232 * _S231.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_5 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S233 : vec3<f32> = lengths_0(crossing_1, other_2);
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
        var _S234 : vec2<f32> = integrals_along_0(family_15, own_1, quantity_2);
        var _S235 : f32 = integral_on_top_0(family_15, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S236 : f32 = _S234.x;
        var _S237 : f32 = _S236 * _S233.x;
        var _S238 : f32 = select(_S235, _S237 - _S235, back_5);
        var _S239 : bool = quantity_2 == u32(0);
        if(_S239)
        {
            is_exposed_0 = _S238 > (16.0f * families_0[family_15].area_unit_0 * min(_S237 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S237);
        }
        var _S240 : f32 = _S236 * _S233.y + select(0.0f, _S238, is_exposed_0) + 0.000244140625f * _S233.z * _S234.y;
        if(_S239)
        {
            weight_4 = 1.0f / max(_S240, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S240 * weight_4, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
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
    var _S241 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_5.diffuse_reflect_0, second_1.diffuse_reflect_0, _S241);
    albedos_3.diffuse_transmit_0 = mix(first_5.diffuse_transmit_0, second_1.diffuse_transmit_0, _S241);
    albedos_3.specular_reflect_0 = mix(first_5.specular_reflect_0, second_1.specular_reflect_0, _S241);
    albedos_3.specular_transmit_0 = mix(first_5.specular_transmit_0, second_1.specular_transmit_0, _S241);
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
    var _S242 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S243 : vec3<f32> = sends_0.sky_warp_0 + _S242 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S243;
    var _S244 : vec3<f32> = sends_0.sky_weft_0 + _S242 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S244;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S243 + vec3<f32>(sends_0.blocks_weft_0) * _S244;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_6 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S245 : f32 = 1.0f - view_6.z;
    var _S246 : f32 = _S245 * _S245;
    (*terms_0)[i32(0)] = 1.0f;
    var _S247 : f32 = view_6.x;
    var _S248 : f32 = _S247 * _S247;
    var _S249 : f32 = view_6.y;
    var _S250 : f32 = _S249 * _S249;
    (*terms_0)[i32(1)] = sqrt(max(_S248 + _S250, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S246;
    (*terms_0)[i32(3)] = _S246 * _S246;
    (*terms_0)[i32(4)] = _S248 - _S250;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_7 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S251 : f32 = 1.0f - view_7.z;
    var _S252 : f32 = _S251 * _S251;
    (*terms_1)[i32(0)] = 1.0f;
    var _S253 : f32 = view_7.x;
    var _S254 : f32 = _S253 * _S253;
    var _S255 : f32 = view_7.y;
    var _S256 : f32 = _S255 * _S255;
    (*terms_1)[i32(1)] = sqrt(max(_S254 + _S256, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S252;
    (*terms_1)[i32(3)] = _S252 * _S252;
    (*terms_1)[i32(4)] = _S254 - _S256;
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
    var _S257 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S258 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_6 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S258 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S258 * interior_0.far_1 + yarn_2.back_6 * _S257;
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
    var _S259 : f32 = light_7.z;
    return select_vector_1((_S259 * view_8.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S259) * 0.31830987334251404f));
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
    var _S260 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S261 : f32 = 2.0f * sqrt(_S260) - 1.0f;
    var _S262 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S261, _S262), 0.00999999977648258f, 1.0f), clamp((1.0f - _S260) * sheen_shear_0(_S261, _S262), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S261, _S262), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_9 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S263 : f32 = light_8.z;
    if(((_S263 <= 0.0f) | (((view_9.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S264 : vec2<f32> = view_9.xy;
    var _S265 : f32 = dot(_S264, _S264);
    var _S266 : vec2<f32> = select_vector_0(_S265 > 9.99999968265522539e-21f, _S264 * vec2<f32>(rsqrt_0(max(_S265, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S267 : f32 = scale_0 * dot(light_8.xy, _S266) + shear_0 * _S263;
    var _S268 : f32 = scale_0 * (light_8.y * _S266.x - light_8.x * _S266.y);
    var _S269 : f32 = _S267 * _S267 + _S268 * _S268 + _S263 * _S263;
    return 0.31830987334251404f * scale_0 * scale_0 * _S263 / max(_S269 * _S269, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S270 : vec3<f32> = sheen_lobe_0(view_10.z, roughness_9);
    var _S271 : f32 = strength_0 * _S270.z;
    return vec2<f32>(_S271 * transformed_cosine_0(light_9, view_10, _S270.x, _S270.y), 1.0f - _S271);
}

fn accumulate_0( index_7 : u32,  light_10 : vec4<f32>)
{
    var _S272 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_10;
    layers_0[index_7].share_0 = _S272 * (1.0f - light_10.w);
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

fn face_point_0( _S273 : u32,  _S274 : u32,  _S275 : f32,  _S276 : f32) -> VisiblePoint_0
{
    var _S277 : u32 = u32(3) * _S274;
    var _S278 : Vertex_0 = vertex_at_0(_S277);
    var _S279 : Vertex_0 = vertex_at_0(_S277 + u32(1));
    var _S280 : Vertex_0 = vertex_at_0(_S277 + u32(2));
    var _S281 : vec3<f32> = position_of_0(_S278);
    var _S282 : vec3<f32> = position_of_0(_S279) - _S281;
    var _S283 : vec3<f32> = position_of_0(_S280) - _S281;
    var _S284 : f32 = _S279.u_0 - _S278.u_0;
    var _S285 : f32 = _S279.v_0 - _S278.v_0;
    var _S286 : vec2<f32> = vec2<f32>(_S284, _S285);
    var _S287 : f32 = _S280.u_0 - _S278.u_0;
    var _S288 : f32 = _S280.v_0 - _S278.v_0;
    var _S289 : vec2<f32> = vec2<f32>(_S287, _S288);
    var _S290 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S284 * _S288 - _S285 * _S287) < 0.0f));
    var _S291 : vec3<f32> = _S290 * (vec3<f32>(_S288) * _S282 - vec3<f32>(_S285) * _S283);
    var _S292 : vec3<f32> = _S290 * (vec3<f32>(_S284) * _S283 - vec3<f32>(_S287) * _S282);
    var point_2 : VisiblePoint_0;
    var _S293 : vec3<f32> = vec3<f32>(_S275);
    var _S294 : vec3<f32> = vec3<f32>(_S276);
    var _S295 : vec3<f32> = normalize(vec3<f32>((1.0f - _S275 - _S276)) * normal_of_0(_S278) + _S293 * normal_of_0(_S279) + _S294 * normal_of_0(_S280));
    point_2.normal_0 = _S295;
    var _S296 : vec3<f32> = normalize(_S291 - _S295 * vec3<f32>(dot(_S295, _S291)));
    point_2.axis_x_0 = _S296;
    point_2.axis_y_0 = cross(_S295, _S296);
    var _S297 : vec3<f32> = normalize(cross(_S282, _S283));
    point_2.face_normal_0 = select_vector_1((dot(_S297, _S295)) < 0.0f, (vec3<f32>(0) - _S297), _S297);
    point_2.position_0 = _S281 + _S293 * _S282 + _S294 * _S283;
    point_2.view_0 = _S295;
    var _S298 : vec2<f32> = vec2<f32>(_S278.u_0, _S278.v_0) + vec2<f32>(_S275) * _S286 + vec2<f32>(_S276) * _S289;
    point_2.uv_1 = _S298;
    var _S299 : bool = (dot(cross(_S291, _S292), _S295)) < 0.0f;
    var _S300 : vec2<f32> = vec2<f32>(fabrics_0[_S273].uv_width_0, select(fabrics_0[_S273].uv_height_0, - fabrics_0[_S273].uv_height_0, _S299));
    point_2.draft_per_uv_0 = _S300;
    point_2.draft_0 = _S298 * _S300 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S273].uv_height_0, _S299));
    var _S301 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S301;
    point_2.draft_dy_0 = _S301;
    return point_2;
}

fn visible_point_0( _S302 : u32,  _S303 : u32,  _S304 : vec2<u32>) -> VisiblePoint_0
{
    var _S305 : u32 = u32(3) * _S303;
    var _S306 : Vertex_0 = vertex_at_0(_S305);
    var _S307 : Vertex_0 = vertex_at_0(_S305 + u32(1));
    var _S308 : Vertex_0 = vertex_at_0(_S305 + u32(2));
    var _S309 : vec3<f32> = position_of_0(_S306);
    var _S310 : vec3<f32> = position_of_0(_S307) - _S309;
    var _S311 : vec3<f32> = position_of_0(_S308) - _S309;
    var _S312 : vec3<f32> = cross(_S310, _S311);
    var _S313 : f32 = f32(frame_record_0.width_0);
    var _S314 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S313));
    var _S315 : f32 = f32(frame_record_0.height_0);
    var _S316 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S315));
    var _S317 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S304.x) + 0.5f - 0.5f * _S313)) * _S314 + vec3<f32>((f32(_S304.y) + 0.5f - 0.5f * _S315)) * _S316;
    var _S318 : f32 = dot(_S317, _S312);
    var _S319 : f32 = 1.0f / select(1.00000000317107685e-30f, _S318, (abs(_S318)) > 1.00000000317107685e-30f);
    var _S320 : vec3<f32> = _S309 - camera_origin_0();
    var _S321 : vec3<f32> = vec3<f32>((dot(_S320, _S312) * _S319));
    var _S322 : vec3<f32> = _S317 * _S321 - _S320;
    var _S323 : vec3<f32> = _S321 * (_S314 - _S317 * vec3<f32>((dot(_S314, _S312) * _S319)));
    var _S324 : vec3<f32> = _S321 * (_S316 - _S317 * vec3<f32>((dot(_S316, _S312) * _S319)));
    var _S325 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S312), 1.00000000317107685e-30f)));
    var _S326 : vec3<f32> = cross(_S311, _S312) * _S325;
    var _S327 : vec3<f32> = cross(_S312, _S310) * _S325;
    var _S328 : vec2<f32> = vec2<f32>(_S307.u_0 - _S306.u_0, _S307.v_0 - _S306.v_0);
    var _S329 : vec2<f32> = vec2<f32>(_S308.u_0 - _S306.u_0, _S308.v_0 - _S306.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S302, _S303, dot(_S322, _S326), dot(_S322, _S327));
    point_3.position_0 = _S309 + _S322;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S317));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S323, _S326)) * _S328 + vec2<f32>(dot(_S323, _S327)) * _S329) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S324, _S326)) * _S328 + vec2<f32>(dot(_S324, _S327)) * _S329) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S330 : u32,  _S331 : VisiblePoint_0) -> vec3<f32>
{
    var _S332 : u32 = fabrics_0[_S330].albedo_map_levels_0;
    if((fabrics_0[_S330].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S333 : vec2<f32> = vec2<f32>(fabrics_0[_S330].uv_width_0, fabrics_0[_S330].uv_height_0);
    var _S334 : vec2<f32> = _S331.draft_dx_0 / _S333;
    var _S335 : vec2<f32> = _S331.draft_dy_0 / _S333;
    var _S336 : u32 = _S332 - u32(1);
    var _S337 : u32 = (u32(1) << (_S336));
    var _S338 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S334.x * _S335.y - _S334.y * _S335.x), 9.99999968265522539e-21f) * (square_1(f32(_S337)) / 3.0f)), 0.0f, f32(_S332) - 1.0f);
    var _S339 : u32 = min(u32(_S338), max(_S332, u32(2)) - u32(2));
    var _S340 : u32 = min(_S339 + u32(1), _S336);
    var _S341 : u32 = (u32(1) << ((u32(2) * _S332)));
    return mix(map_level_0(fabrics_0[_S330].albedo_map_0 + (_S341 - ((_S341 >> ((u32(2) * _S339))))) / u32(3), (_S337 >> (_S339)), _S331.uv_1), map_level_0(fabrics_0[_S330].albedo_map_0 + (_S341 - ((_S341 >> ((u32(2) * _S340))))) / u32(3), (_S337 >> (_S340)), _S331.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S338 - f32(_S339))) - 1.0f) / 3.0f)));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S342 : u32,  _S343 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S342 * frame_record_0.height_0 + _S343.y) * frame_record_0.width_0 + _S343.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S344 : u32,  _S345 : u32) -> vec3<f32>
{
    var _S346 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S344 * frame_record_0.environment_columns_0 + _S345);
    return vec3<f32>(scene_number_0(_S346), scene_number_0(_S346 + u32(1)), scene_number_0(_S346 + u32(2)));
}

fn sample_environment_0( _S347 : vec2<f32>,  _S348 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S349 : u32 = frame_record_0.environment_rows_0;
    var _S350 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S347.y);
    var _S351 : u32 = frame_record_0.environment_columns_0;
    var _S352 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S350.index_3 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S347.x);
    var _S353 : vec3<f32> = environment_texel_0(_S350.index_3, _S352.index_3);
    (*_S348) = _S353 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S353), 9.99999968265522539e-21f)));
    var _S354 : f32 = 3.14159274101257324f / f32(_S349);
    var _S355 : f32 = mix(sine_cosine_0(f32(_S350.index_3) * _S354).y, sine_cosine_0(f32(_S350.index_3 + u32(1)) * _S354).y, _S350.remainder_0);
    var _S356 : f32 = sqrt(max(1.0f - _S355 * _S355, 0.0f));
    var _S357 : vec2<f32> = sine_cosine_0((f32(_S352.index_3) + _S352.remainder_0) * (6.28318548202514648f / f32(_S351)));
    var _S358 : f32 = _S356 * _S357.x;
    var _S359 : f32 = - _S356 * _S357.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S358 + frame_record_0.environment_sine_0 * _S359, _S355, frame_record_0.environment_cosine_0 * _S359 - frame_record_0.environment_sine_0 * _S358);
}

fn light_sample_0( _S360 : u32,  _S361 : vec2<u32>,  _S362 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S363 : u32 = frame_record_0.lights_0;
    if(_S360 >= (frame_record_0.lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S364 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S361, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S360 - _S363), u32(3)), &(weight_6));
        sample_0.towards_0 = _S364;
        sample_0.irradiance_1 = weight_6 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S365 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S360);
    sample_0.irradiance_1 = vec3<f32>(_S365.red_0, _S365.green_0, _S365.blue_0);
    sample_0.towards_0 = vec3<f32>(_S365.x_7, _S365.y_1, _S365.z_1);
    if((_S365.is_point_0) != u32(0))
    {
        var _S366 : vec3<f32> = sample_0.towards_0 - _S362;
        var _S367 : f32 = max(square_0(_S366), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S367);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S367);
        sample_0.towards_0 = normalize(_S366);
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

fn regime_of_0( _S368 : u32,  _S369 : Footprint_0,  _S370 : f32) -> Regime_0
{
    var _S371 : f32 = Footprint_spread_side_0(_S369);
    var _S372 : f32 = clamp((binary_logarithm_0(max(_S371, 9.99999971718068537e-10f)) - fabrics_0[_S368].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S373 : f32 = _S372 * _S372 * (3.0f - 2.0f * _S372);
    regime_0.prefiltered_0 = _S373;
    var _S374 : f32 = _S371 * fabrics_0[_S368].lobes_0.threads_per_mm_0;
    regime_0.threads_1 = _S374;
    regime_0.points_0 = select(0.0f, clamp(_S374 * 12.0f, 1.0f, mix(max(8.0f / _S370, 1.0f), 1.0f, _S373)), _S373 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S375 : u32,  _S376 : f32) -> bool
{
    return (((((fabrics_0[_S375].fibre_noise_0) > 0.0f) | (((fabrics_0[_S375].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S375].has_detail_0) != u32(0)) & ((_S376 >= 0.0f))))));
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

fn crossing_at_0( _S377 : u32,  _S378 : f32,  _S379 : f32,  _S380 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S377].warp_0, _S378);
    crossing_3.weft_2 = locate_0(fabrics_0[_S377].weft_0, _S379);
    var _S381 : u32 = fabrics_0[_S377].run_words_0 + u32(2) * (crossing_3.weft_2.thread_2 * fabrics_0[_S377].ends_1 + crossing_3.warp_2.thread_2);
    var _S382 : u32 = words_0[_S381];
    crossing_3.warp_word_0 = _S382;
    crossing_3.weft_word_0 = words_0[_S381 + u32(1)];
    crossing_3.warp_above_0 = (((_S382 & (u32(1)))) == u32(1)) != _S380;
    return crossing_3;
}

fn sample_at_0( _S383 : u32,  _S384 : f32,  _S385 : f32,  _S386 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S387 : Crossing_0 = crossing_at_0(_S383, _S384, _S385, _S386);
    sample_1.crossing_2 = _S387;
    var _S388 : Shown_0 = shown_at_0(_S387, _S386);
    sample_1.shown_3 = _S388;
    var _S389 : u32 = select(fabrics_0[_S383].weft_0, fabrics_0[_S383].warp_0, _S388.is_warp_2);
    var _S390 : u32 = select(fabrics_0[_S383].warp_0, fabrics_0[_S383].weft_0, _S388.is_warp_2);
    var _S391 : Cell_0 = select_cell_0(_S388.is_warp_2, sample_1.crossing_2.warp_2, sample_1.crossing_2.weft_2);
    var _S392 : Cell_0 = select_cell_0(_S388.is_warp_2, sample_1.crossing_2.weft_2, sample_1.crossing_2.warp_2);
    var _S393 : Run_0 = unpack_0(_S389, _S390, _S391.thread_2, _S392, _S388.word_0);
    var _S394 : Section_0 = section_at_0(_S391);
    var _S395 : bool = ((_S388.on_top_0) & (((_S393.distance_0) < (_S394.drop_0 * _S393.bend_1.sine_0))));
    var _S396 : f32 = select(-1.0f, 1.0f, ((_S388.on_top_0) & ((!_S395))));
    var _S397 : f32 = select(_S393.reach_0, _S393.other_reach_0, _S395);
    var _S398 : f32 = select(max(_S397 - _S393.distance_0, 0.0f), _S397 + _S393.distance_0, _S395);
    var _S399 : f32 = _S397 / _S393.bend_1.sine_0 - _S396 * _S394.drop_0;
    var _S400 : f32 = _S398 * _S398;
    var _S401 : f32 = max(_S399 * _S399 - _S400, 9.99999968265522539e-21f);
    var _S402 : f32 = rsqrt_0(_S401);
    var _S403 : f32 = _S400 / (_S401 * _S402 + _S399);
    var _S404 : bool = _S398 > 0.0f;
    var _S405 : f32 = select(-1.0f, 1.0f, _S388.on_top_0) * select(-1.0f, 1.0f, _S393.near_start_0);
    var _S406 : f32 = _S394.slope_0 * select(1.0f, _S399 * _S402, _S404);
    sample_1.slope_across_0 = _S406;
    var _S407 : f32 = select(0.0f, _S405 * _S398 * _S402, _S404);
    sample_1.slope_along_0 = _S407;
    var _S408 : vec2<f32> = dive_0(_S390, _S388, _S393, _S392);
    sample_1.height_7 = select(families_0[_S389].height_scale_0 * _S396, 0.0f, _S393.straight_0) * (_S397 * _S393.bend_1.half_tangent_0 - _S403) - families_0[_S389].height_scale_0 * _S394.drop_0 - _S408.x;
    var _S409 : f32 = families_0[_S389].height_scale_0 * _S406;
    var _S410 : f32 = families_0[_S389].height_scale_0 * _S407 - _S408.y;
    sample_1.slope_x_1 = select(_S410, _S409, _S388.is_warp_2);
    sample_1.slope_y_1 = select(_S409, _S410, _S388.is_warp_2);
    sample_1.run_3 = _S393;
    sample_1.section_1 = _S394;
    return sample_1;
}

fn steps_per_length_0( _S411 : u32,  _S412 : SearchQuality_0,  _S413 : vec3<f32>) -> f32
{
    return max(max(abs(_S413.x) * fabrics_0[_S411].threads_per_x_0, abs(_S413.y) * fabrics_0[_S411].threads_per_y_0) * _S412.steps_per_thread_0, abs(_S413.z) * fabrics_0[_S411].per_relief_0 * _S412.steps_per_relief_0);
}

fn cell_maximum_0( _S414 : u32,  _S415 : Crossing_0) -> f32
{
    var _S416 : u32 = select(fabrics_0[_S414].weft_0, fabrics_0[_S414].warp_0, _S415.warp_above_0);
    return f32((select(_S415.weft_word_0, _S415.warp_word_0, _S415.warp_above_0) >> (u32(28)))) * families_0[_S416].height_scale_0 * families_0[_S416].level_0;
}

fn probe_0( _S417 : u32,  _S418 : f32,  _S419 : f32,  _S420 : bool,  _S421 : bool,  _S422 : bool) -> Probe_0
{
    var _S423 : Sample_0 = sample_at_0(_S417, _S418, _S419, _S420);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S423.height_7;
    probe_1.hole_4 = _S423.shown_3.hole_3;
    probe_1.slope_x_0 = _S423.slope_x_1;
    probe_1.slope_y_0 = _S423.slope_y_1;
    probe_1.yarn_1 = select(_S423.crossing_2.weft_2.thread_2 * u32(2), _S423.crossing_2.warp_2.thread_2 * u32(2) + u32(1), _S423.shown_3.is_warp_2);
    probe_1.cell_max_0 = cell_maximum_0(_S417, _S423.crossing_2);
    probe_1.side_x_0 = select(_S423.crossing_2.warp_2.below_0, _S423.crossing_2.warp_2.above_0, _S421);
    probe_1.side_y_0 = select(_S423.crossing_2.weft_2.below_0, _S423.crossing_2.weft_2.above_0, _S422);
    probe_1.edge_x_0 = outline_distance_0(_S423.crossing_2.warp_2, _S423.shown_3, _S423.run_3, !_S423.shown_3.is_warp_2, _S421);
    probe_1.edge_y_0 = outline_distance_0(_S423.crossing_2.weft_2, _S423.shown_3, _S423.run_3, _S423.shown_3.is_warp_2, _S422);
    return probe_1;
}

fn is_free_0( _S424 : u32,  _S425 : SearchQuality_0,  _S426 : vec3<f32>,  _S427 : vec3<f32>,  _S428 : bool,  _S429 : f32) -> bool
{
    var _S430 : f32 = _S427.z;
    if(_S430 <= 0.0f)
    {
        return false;
    }
    var _S431 : f32 = 1.0f / max(_S425.shadow_share_0 * steps_per_length_0(_S424, _S425, _S427), 9.99999971718068537e-10f);
    var _S432 : StepControl_0 = step_control_0(_S427.xy, _S431);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S426.z + _S430 * distance_2) < _S429))))
        {
        }
        else
        {
            break;
        }
        var _S433 : vec3<f32> = _S426 + _S427 * vec3<f32>(distance_2);
        var _S434 : Probe_0 = probe_0(_S424, _S433.x, _S433.y, _S428, _S432.right_0, _S432.up_0);
        var _S435 : f32 = _S433.z;
        var _S436 : f32 = _S435 - _S434.height_4;
        var _S437 : f32 = _S430 - _S434.slope_x_0 * _S427.x - _S434.slope_y_0 * _S427.y;
        if(((!_S434.hole_4) & ((_S436 < 0.0f))))
        {
            return false;
        }
        var _S438 : f32 = way_back_to_dip_0(previous_3, _S436, _S437, last_step_0, _S434);
        if(_S438 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S438;
            distance_2 = distance_2 - _S438;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S439 : bool = _S435 > (_S434.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S432, _S434, _S436, _S437), max(StepControl_to_cell_exit_0(_S432, _S434.side_x_0, _S434.side_y_0), _S431), _S439);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S436, _S437, _S434, _S439);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S440 : u32,  _S441 : SearchQuality_0,  _S442 : f32,  _S443 : f32,  _S444 : vec3<f32>,  _S445 : bool) -> bool
{
    if(!sample_at_0(_S440, _S442, _S443, _S445).shown_3.hole_3)
    {
        return false;
    }
    var _S446 : vec3<f32> = vec3<f32>(_S442, _S443, 0.0f);
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
        var _S447 : bool = is_free_0(_S440, _S441, _S446, select_vector_1(side_1 == u32(0), _S444, vec3<f32>(- _S444.x, - _S444.y, _S444.z)), _S445 != (side_1 == u32(1)), fabrics_0[_S440].height_high_0);
        var _S448 : u32 = side_1 + u32(1);
        passes_0 = _S447;
        side_1 = _S448;
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

fn max_height_along_0( _S449 : u32,  _S450 : f32,  _S451 : f32,  _S452 : f32,  _S453 : vec3<f32>,  _S454 : bool) -> f32
{
    var _S455 : f32 = _S453.x;
    var _S456 : f32 = _S453.y;
    var _S457 : u32 = (words_0[fabrics_0[_S449].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S449].weft_0, _S451).thread_2 / u32(2) * fabrics_0[_S449].max_height_columns_0 + locate_0(fabrics_0[_S449].warp_0, _S450).thread_2 / u32(2)) + (select(u32(0), u32(1), _S455 > 0.0f) + select(u32(0), u32(2), _S456 > 0.0f))] >> (u32(select(i32(0), i32(4), _S454))));
    var _S458 : f32 = max(abs(_S455) * fabrics_0[_S449].threads_per_x_0, abs(_S456) * fabrics_0[_S449].threads_per_y_0) / _S453.z;
    var _S459 : f32 = fabrics_0[_S449].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S449].height_high_0;
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
        if(((max_height_0 - _S452) * _S458) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S457 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S459);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S460 : u32,  _S461 : f32,  _S462 : f32,  _S463 : bool,  _S464 : bool,  _S465 : bool) -> vec3<f32>
{
    var _S466 : Crossing_0 = crossing_at_0(_S460, _S461, _S462, _S463);
    return vec3<f32>(cell_maximum_0(_S460, _S466), select(_S466.warp_2.below_0, _S466.warp_2.above_0, _S464), select(_S466.weft_2.below_0, _S466.weft_2.above_0, _S465));
}

fn first_sample_height_0( _S467 : u32,  _S468 : ViewRay_0,  _S469 : StepControl_0,  _S470 : bool) -> f32
{
    var _S471 : f32 = max_height_along_0(_S467, _S468.origin_0.x, _S468.origin_0.y, 0.0f, vec3<f32>(_S468.slope_1, 1.0f), _S470);
    var count_5 : u32 = u32(0);
    var height_9 : f32 = _S471;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S472 : vec2<f32> = ViewRay_at_0(_S468, height_9);
        var _S473 : vec3<f32> = cell_bounds_0(_S467, _S472.x, _S472.y, _S470, _S469.right_0, _S469.up_0);
        var _S474 : f32 = height_9 - _S473.x;
        var _S475 : f32 = StepControl_to_cell_exit_0(_S469, _S473.y, _S473.z);
        var height_10 : f32 = height_9 - clamp(_S474, 0.0f, _S475);
        if(_S474 <= _S475)
        {
            height_9 = height_10;
            break;
        }
        count_5 = count_5 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S476 : u32,  _S477 : ViewRay_0,  _S478 : StepControl_0,  _S479 : bool) -> ViewRayEnd_0
{
    var _S480 : f32 = fabrics_0[_S476].height_low_0 - (fabrics_0[_S476].height_high_0 - fabrics_0[_S476].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S476, _S477, _S478, _S479);
    end_1.last_step_3 = _S478.epsilon_0;
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
        var _S481 : vec2<f32> = ViewRay_at_0(_S477, end_1.height_8);
        var _S482 : Probe_0 = probe_0(_S476, _S481.x, _S481.y, _S479, _S478.right_0, _S478.up_0);
        var _S483 : f32 = end_1.height_8 - _S482.height_4;
        var _S484 : f32 = ViewRay_rate_0(_S477, _S482);
        end_1.depth_1 = - _S483;
        end_1.rate_4 = _S484;
        var _S485 : bool = !_S482.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S485))) & (((end_1.previous_4.yarn_0) == (_S482.yarn_1))));
        if((((_S485 & ((_S483 <= 0.0f)))) | (((end_1.height_8) <= _S480))))
        {
            break;
        }
        var _S486 : f32 = way_back_to_dip_0(end_1.previous_4, _S483, _S484, end_1.last_step_3, _S482);
        if(_S486 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S486;
            end_1.last_step_3 = end_1.last_step_3 - _S486;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S487 : f32 = min(StepControl_to_cell_exit_0(_S478, _S482.side_x_0, _S482.side_y_0), end_1.height_8 - _S482.cell_max_0);
        var _S488 : f32 = StepControl_to_next_sample_0(_S478, _S482, _S483, _S484);
        end_1.previous_4 = after_sample_0(_S483, _S484, _S482, _S487 > _S488);
        var _S489 : f32 = max(_S487, _S488);
        end_1.last_step_3 = _S489;
        end_1.height_8 = end_1.height_8 - _S489;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S490 : u32,  _S491 : ViewRay_0,  _S492 : StepControl_0,  _S493 : bool,  _S494 : ViewRayEnd_0,  _S495 : u32) -> f32
{
    var _S496 : f32 = fabrics_0[_S490].height_high_0 - fabrics_0[_S490].height_low_0;
    var above_2 : f32 = _S494.height_8 + _S494.last_step_3;
    var above_gap_1 : f32 = clamp(_S494.previous_4.clearance_0, 0.0f, _S496);
    var under_gap_1 : f32 = clamp(_S494.depth_1, 0.0f, _S496);
    var middle_0 : f32 = select(between_0(above_2, _S494.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S494.previous_4.rate_0 * _S494.last_step_3, _S494.rate_4 * _S494.last_step_3) * _S494.last_step_3, _S494.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S494.height_8;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S495)
        {
        }
        else
        {
            break;
        }
        var _S497 : vec2<f32> = ViewRay_at_0(_S491, middle_0);
        var _S498 : Probe_0 = probe_0(_S490, _S497.x, _S497.y, _S493, _S492.right_0, _S492.up_0);
        var _S499 : f32 = clamp(middle_0 - select(_S498.height_4, -1.0e+09f, _S498.hole_4), - _S496, _S496);
        if(_S499 <= 0.0f)
        {
            var _S500 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S501 : f32 = - _S499;
            under_1 = middle_0;
            above_gap_2 = _S500;
            under_gap_2 = _S501;
            side_2 = 1.0f;
        }
        else
        {
            var _S502 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S499;
            under_gap_2 = _S502;
            side_2 = -1.0f;
        }
        var _S503 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S499 / min(ViewRay_rate_0(_S491, _S498), -9.99999997475242708e-07f), under_1, above_3), _S494.smooth_0);
        var _S504 : u32 = i_2 + u32(1);
        middle_0 = _S503;
        i_2 = _S504;
    }
    return select(under_1, middle_0, _S494.smooth_0);
}

fn first_hit_of_yarn_0( _S505 : u32,  _S506 : SearchQuality_0,  _S507 : f32,  _S508 : f32,  _S509 : vec3<f32>,  _S510 : bool) -> Hit_0
{
    var _S511 : f32 = max(_S509.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S507, _S508);
    var _S512 : vec2<f32> = _S509.xy / vec2<f32>(_S511);
    ray_0.slope_1 = _S512;
    var _S513 : StepControl_0 = step_control_0((vec2<f32>(0) - _S512), 1.0f / max(steps_per_length_0(_S505, _S506, _S509) / _S511, 9.99999971718068537e-10f));
    var _S514 : ViewRayEnd_0 = search_down_0(_S505, ray_0, _S513, _S510);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S515 : f32 = refined_height_0(_S505, ray_0, _S513, _S510, _S514, _S506.refinements_0);
    hit_0.height_6 = _S515;
    var _S516 : vec2<f32> = ViewRay_at_0(ray_0, _S515);
    hit_0.x_14 = _S516.x;
    hit_0.y_7 = _S516.y;
    return hit_0;
}

fn first_hit_0( _S517 : u32,  _S518 : SearchQuality_0,  _S519 : f32,  _S520 : f32,  _S521 : vec3<f32>,  _S522 : bool) -> Hit_0
{
    if(!passes_through_0(_S517, _S518, _S519, _S520, _S521, _S522))
    {
        return first_hit_of_yarn_0(_S517, _S518, _S519, _S520, _S521, _S522);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S519;
    hit_1.y_7 = _S520;
    hit_1.height_6 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_at_0( _S523 : u32,  _S524 : f32,  _S525 : f32,  _S526 : bool) -> SurfacePoint_0
{
    var _S527 : Sample_0 = sample_at_0(_S523, _S524, _S525, _S526);
    var _S528 : u32 = select(fabrics_0[_S523].weft_0, fabrics_0[_S523].warp_0, _S527.shown_3.is_warp_2);
    var _S529 : f32 = families_0[_S528].twist_sine_0 * select(1.0f, -1.0f, _S526);
    var _S530 : f32 = select(-1.0f, 1.0f, _S527.shown_3.is_warp_2);
    var _S531 : vec2<f32> = fibre_direction_0(_S527.slope_across_0, _S530 * _S527.slope_along_0, _S529, families_0[_S528].twist_cosine_0);
    var _S532 : f32 = _S531.x;
    var _S533 : f32 = _S531.y;
    var _S534 : f32 = select(_S527.slope_y_1, _S527.slope_x_1, _S527.shown_3.is_warp_2) * _S532 + _S530 * select(_S527.slope_x_1, _S527.slope_y_1, _S527.shown_3.is_warp_2) * _S533;
    var _S535 : f32 = select(_S527.crossing_2.weft_2.half_width_1, _S527.crossing_2.warp_2.half_width_1, _S527.shown_3.is_warp_2) * 1.0154266357421875f;
    var _S536 : f32 = _S535 * arc_sine_0(clamp(_S527.section_1.across_3 / _S535, -1.0f, 1.0f));
    var _S537 : f32 = select(- _S524, _S525, _S527.shown_3.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S527.shown_3.hole_3;
    point_4.is_warp_0 = _S527.shown_3.is_warp_2;
    point_4.warp_thread_0 = _S527.crossing_2.warp_2.thread_2;
    point_4.weft_thread_0 = _S527.crossing_2.weft_2.thread_2;
    point_4.height_2 = _S527.height_7;
    point_4.normal_1 = normalize(vec3<f32>(- _S527.slope_x_1, - _S527.slope_y_1, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S527.shown_3.is_warp_2, vec3<f32>(_S532, _S533, _S534), vec3<f32>(- _S533, _S532, _S534)));
    point_4.across_0 = _S527.section_1.across_3;
    point_4.fibre_across_0 = _S536 * families_0[_S528].twist_cosine_0 + _S537 * _S529;
    point_4.fibre_along_0 = _S537 * families_0[_S528].twist_cosine_0 - _S536 * _S529;
    var _S538 : f32 = run_share_0(_S527.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S538, _S538, _S527.shown_3.on_top_0);
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

fn has_hairs_0( _S539 : u32) -> bool
{
    return (((families_0[fabrics_0[_S539].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S539].weft_0].hairiness_0) > 0.0f)));
}

fn hair_at_0( _S540 : u32,  _S541 : vec2<f32>,  _S542 : bool,  _S543 : f32) -> Hair_0
{
    var _S544 : f32 = fabrics_0[_S540].fibre_size_0;
    var _S545 : f32 = 17.0f * fabrics_0[_S540].fibre_size_0;
    var _S546 : f32 = fade_0(_S543, _S545);
    var _S547 : vec2<f32> = _S541 / vec2<f32>(_S545);
    var _S548 : u32 = hash_key_0(select(u32(0), u32(1), _S542), ((fabrics_0[_S540].seed_0) ^ (u32(1013904242))));
    var _S549 : f32 = 1.0f / max(_S543, 0.07999999821186066f * fabrics_0[_S540].fibre_size_0);
    var _S550 : f32 = min(0.63999998569488525f * fabrics_0[_S540].fibre_size_0 * _S549, 1.0f);
    const _S551 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S551;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S546 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S552 : u32 = number_2 / u32(9);
        var _S553 : u32 = number_2 / u32(3) - u32(3) * _S552;
        var _S554 : vec2<f32> = floor(_S547) + vec2<f32>(f32(number_2 - u32(3) * _S553 - u32(9) * _S552), f32(_S553)) - vec2<f32>(1.0f);
        var _S555 : u32 = hash_bits_0(_S548 + _S552, u32(i32(_S554.x)) * u32(65536) + u32(i32(_S554.y)));
        var _S556 : u32 = hash_bits_0(_S548, _S555);
        var _S557 : vec2<f32> = _S547 - _S554 - vec2<f32>(share_of_0(_S555), share_of_0((_S555 >> (u32(10)))));
        var _S558 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S555 >> (u32(20)))));
        var _S559 : f32 = mix(5.0f, 16.0f, share_of_0((_S556 >> (u32(10))))) / 17.0f;
        var _S560 : f32 = _S557.x;
        var _S561 : f32 = _S558.y;
        var _S562 : f32 = _S557.y;
        var _S563 : f32 = _S558.x;
        var _S564 : f32 = (_S560 * _S561 + _S562 * _S563) / _S559;
        var _S565 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S556 >> (u32(20)))) - 1.0f);
        var _S566 : f32 = 2.0f * _S565 * _S564;
        var _S567 : f32 = rsqrt_0(_S566 * _S566 + 1.0f);
        var _S568 : f32 = (_S562 * _S561 - _S560 * _S563 - _S565 * _S559 * _S564 * _S564) * _S567 * 17.0f;
        var _S569 : f32 = clamp((0.31999999284744263f - abs(_S568)) * _S544 * _S549 + 0.5f, 0.0f, _S550);
        if((((((share_of_0(_S556)) < (families_0[select(fabrics_0[_S540].weft_0, fabrics_0[_S540].warp_0, ((((_S556 >> (u32(30)))) & (u32(1)))) == u32(1))].hairiness_0)) & (((abs(_S564)) < 1.0f)))) & ((_S569 > cover_2))))
        {
            var _S570 : vec2<f32> = vec2<f32>(- _S563 - _S566 * _S561, _S561 - _S566 * _S563) * vec2<f32>(_S567);
            cover_2 = _S569;
            hair_away_0 = _S568;
            hair_across_0 = _S570;
        }
        number_2 = number_2 + u32(1);
    }
    var _S571 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S546 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S571) * hair_across_0, sqrt(1.0f - _S571 * _S571));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn thread_number_0( _S572 : u32,  _S573 : SurfacePoint_0,  _S574 : f32,  _S575 : f32) -> u32
{
    var _S576 : u32 = select(fabrics_0[_S572].weft_0, fabrics_0[_S572].warp_0, _S573.is_warp_0);
    return u32(i32(floor((select(_S575, _S574, _S573.is_warp_0) - _S573.across_0) / families_0[_S576].period_0)) * i32(families_0[_S576].count_0) + i32(select(_S573.weft_thread_0, _S573.warp_thread_0, _S573.is_warp_0))) * u32(2) + select(u32(0), u32(1), _S573.is_warp_0);
}

struct FibreNoise_0
{
     bundle_0 : vec2<f32>,
     bundle_weight_0 : f32,
     fibre_0 : vec2<f32>,
     fibre_weight_0 : f32,
     offset_1 : f32,
     slope_2 : f32,
};

fn fibre_noise_at_0( _S577 : u32,  _S578 : u32,  _S579 : SurfacePoint_0,  _S580 : u32,  _S581 : f32) -> FibreNoise_0
{
    var _S582 : f32 = 5.0f * fabrics_0[_S577].fibre_size_0;
    var _S583 : vec2<f32> = wave_noise_0(hash_key_0(_S580, ((fabrics_0[_S577].seed_0) ^ (u32(458671337)))), _S579.fibre_along_0 / (25.0f * fabrics_0[_S577].fibre_size_0));
    var _S584 : f32 = _S579.fibre_across_0 + families_0[_S578].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S577].fibre_size_0 * _S583.x;
    var _S585 : vec3<f32> = fibre_cell_0(_S584, _S579.fibre_along_0, fabrics_0[_S577].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S580, ((fabrics_0[_S577].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S584, _S579.fibre_along_0, _S582));
    noise_0.bundle_weight_0 = fade_0(_S581, _S582);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S580, ((fabrics_0[_S577].seed_0) ^ (u32(48610963)))), _S585);
    noise_0.fibre_weight_0 = fade_0(_S581, fabrics_0[_S577].fibre_size_0);
    noise_0.offset_1 = _S585.z;
    noise_0.slope_2 = 0.5f * _S583.y;
    return noise_0;
}

fn detail_gain_0( _S586 : u32,  _S587 : u32,  _S588 : SurfacePoint_0,  _S589 : vec2<f32>,  _S590 : bool,  _S591 : u32,  _S592 : f32) -> vec2<f32>
{
    var _S593 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S587].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S592, 1.0f / families_0[_S587].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S587, _S588, _S590))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S593;
    }
    if((families_0[_S587].fibre_tone_0) > 0.0f)
    {
        var _S594 : FibreNoise_0 = fibre_noise_at_0(_S586, _S587, _S588, _S591, _S592);
        gain_2 = gain_2 + vec2<f32>(families_0[_S587].fibre_tone_0) * vec2<f32>(_S594.bundle_weight_0 * _S594.bundle_0.y + _S594.fibre_weight_0 * _S594.fibre_0.y, _S594.bundle_weight_0 + _S594.fibre_weight_0);
    }
    if((families_0[_S587].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.25f * families_0[_S587].slub_0 * fade_0(_S592, 1.0f / families_0[_S587].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S591, ((fabrics_0[_S586].seed_0) ^ (u32(1373058189)))), select(- _S589.x, _S589.y, _S588.is_warp_0) * families_0[_S587].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S588.across_0 * families_0[_S587].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S595 : u32,  _S596 : Albedos_0,  _S597 : u32,  _S598 : u32,  _S599 : vec2<f32>) -> Albedos_0
{
    var _S600 : vec3<f32> = max(_S596.specular_reflect_0, _S596.specular_transmit_0);
    var _S601 : vec3<f32> = _S596.diffuse_reflect_0 + _S596.diffuse_transmit_0;
    var _S602 : vec3<f32> = vec3<f32>(fabrics_0[_S595].layer_bound_0);
    var _S603 : vec3<f32> = vec3<f32>(1.0f);
    var _S604 : vec3<f32> = _S603 - _S602 * _S600;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S597, fabrics_0[_S595].colour_noise_0, fabrics_0[_S595].seed_0), _S601, _S604);
    var _S605 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S599.y, vec3<f32>(colour_1) * _S601, _S604) * _S599.x)));
    var _S606 : f32 = bounded_gain_0(fibre_gain_0(_S597, _S598, fabrics_0[_S595].fibre_noise_0, fabrics_0[_S595].seed_0), _S600, min((_S603 - _S605 * _S601) / _S602, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S605 * _S596.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S605 * _S596.diffuse_transmit_0;
    var _S607 : vec3<f32> = vec3<f32>(_S606);
    varied_0.specular_reflect_0 = _S607 * _S596.specular_reflect_0;
    varied_0.specular_transmit_0 = _S607 * _S596.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S608 : u32,  _S609 : SurfacePoint_0,  _S610 : Albedos_0,  _S611 : f32,  _S612 : f32,  _S613 : bool,  _S614 : f32,  _S615 : f32) -> Albedos_0
{
    var _S616 : u32 = thread_number_0(_S608, _S609, _S611, _S612);
    var _S617 : vec3<f32> = fibre_cell_0(_S609.fibre_across_0, _S609.fibre_along_0, fabrics_0[_S608].fibre_size_0);
    var _S618 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S608].has_detail_0) != u32(0)) & ((_S614 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S608, select(fabrics_0[_S608].weft_0, fabrics_0[_S608].warp_0, _S609.is_warp_0), _S609, vec2<f32>(_S611, _S612), _S613, _S616, _S614) * vec2<f32>(1.0f - _S615, 1.0f);
    }
    else
    {
        gain_3 = _S618;
    }
    return vary_albedos_0(_S608, _S610, _S616, u32(i32(_S617.x)) * u32(65536) + u32(i32(floor(_S617.y))), gain_3);
}

fn turned_frame_0( _S619 : u32,  _S620 : u32,  _S621 : SurfacePoint_0,  _S622 : bool,  _S623 : u32,  _S624 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_5 = _S621.normal_1;
    frame_2.tangent_4 = _S621.tangent_0;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S620].has_plies_0) > 0.0f)
    {
        var _S625 : f32 = fade_0(_S624, 1.0f / families_0[_S620].plies_per_mm_0);
        var _S626 : f32 = _S625 * 0.41999998688697815f * ply_offset_0(_S620, _S621, _S622);
        var _S627 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S628 : vec3<f32> = vec3<f32>(families_0[_S620].ply_cosine_0);
        var _S629 : vec3<f32> = vec3<f32>(select(families_0[_S620].ply_sine_0, - families_0[_S620].ply_sine_0, _S622));
        var _S630 : vec3<f32> = _S628 * _S627 + _S629 * frame_2.tangent_4;
        var _S631 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S626 * _S626));
        var _S632 : vec3<f32> = vec3<f32>(_S626);
        frame_2.tangent_4 = _S628 * (_S628 * frame_2.tangent_4 - _S629 * _S627) + _S629 * (_S631 * _S630 - _S632 * frame_2.normal_5);
        frame_2.normal_5 = _S631 * frame_2.normal_5 + _S632 * _S630;
        frame_2.loss_0 = _S625 * _S625 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S633 : f32 = families_0[_S620].fibre_tilt_0;
    if((families_0[_S620].fibre_tilt_0) > 0.0f)
    {
        var _S634 : FibreNoise_0 = fibre_noise_at_0(_S619, _S620, _S621, _S623, _S624);
        var _S635 : f32 = 1.09858846664428711f * _S633 * (_S634.bundle_weight_0 * _S634.bundle_0.x + _S634.fibre_weight_0 * (_S634.fibre_0.x + _S634.offset_1));
        var _S636 : f32 = _S633 * (1.42099642753601074f * (_S634.bundle_weight_0 * _S634.bundle_0.y + _S634.fibre_weight_0 * _S634.fibre_0.y) - _S634.bundle_weight_0 * _S634.slope_2);
        var _S637 : f32 = square_1(_S634.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S633 * _S633 * ((0.24761904776096344f * (square_1(_S634.bundle_weight_0) + _S637) + _S637 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S638 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S639 : vec2<f32> = sine_cosine_0(_S635);
        var _S640 : vec2<f32> = sine_cosine_0(_S636);
        var _S641 : vec3<f32> = vec3<f32>(_S639.y);
        var _S642 : vec3<f32> = vec3<f32>(_S639.x);
        var _S643 : vec3<f32> = _S641 * _S638 - _S642 * frame_2.normal_5;
        frame_2.normal_5 = _S641 * frame_2.normal_5 + _S642 * _S638;
        frame_2.tangent_4 = vec3<f32>(_S640.y) * frame_2.tangent_4 + vec3<f32>(_S640.x) * _S643;
    }
    return frame_2;
}

fn yarn_point_of_0( _S644 : u32,  _S645 : SurfacePoint_0,  _S646 : f32,  _S647 : f32,  _S648 : bool,  _S649 : bool,  _S650 : f32) -> YarnPoint_0
{
    var _S651 : u32 = select(fabrics_0[_S644].weft_0, fabrics_0[_S644].warp_0, _S645.is_warp_0);
    var _S652 : bool = (((fabrics_0[_S644].has_detail_0) != u32(0)) & ((_S650 >= 0.0f)));
    var _S653 : vec3<f32> = vec3<f32>(0.0f);
    var _S654 : Hair_0 = Hair_x24init_0(0.0f, _S653, _S653);
    var _S655 : bool;
    if(_S652)
    {
        _S655 = has_hairs_0(_S644);
    }
    else
    {
        _S655 = false;
    }
    var hair_2 : Hair_0;
    if(_S655)
    {
        hair_2 = hair_at_0(_S644, vec2<f32>(_S646, _S647), _S648, _S650);
    }
    else
    {
        hair_2 = _S654;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S651, select(_S645.weft_thread_0, _S645.warp_thread_0, _S645.is_warp_0));
    var albedos_8 : Albedos_0;
    if(varies_at_0(_S644, _S650))
    {
        albedos_8 = varied_at_0(_S644, _S645, albedos_7, _S646, _S647, _S648, _S650, hair_2.cover_0);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_5 : YarnPoint_0;
    point_5.back_7 = _S648;
    point_5.hole_6 = _S649;
    point_5.is_warp_3 = _S645.is_warp_0;
    point_5.x_15 = _S646;
    point_5.y_8 = _S647;
    point_5.height_11 = _S645.height_2;
    point_5.normal_10 = _S645.normal_1;
    point_5.tangent_10 = _S645.tangent_0;
    point_5.surface_normal_0 = _S645.normal_1;
    point_5.diffuse_gain_1 = 1.0f;
    if(_S652)
    {
        var _S656 : YarnFrame_0 = turned_frame_0(_S644, _S651, _S645, _S648, thread_number_0(_S644, _S645, _S646, _S647), _S650);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S644))
        {
            frame_3 = under_hair_0(_S656, hair_2);
        }
        else
        {
            frame_3 = _S656;
        }
        point_5.normal_10 = frame_3.normal_5;
        point_5.tangent_10 = frame_3.tangent_4;
        point_5.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S644].diffuse_blend_0);
    }
    point_5.roughness_10 = families_0[_S651].roughness_0;
    point_5.albedos_6 = albedos_8;
    return point_5;
}

fn unoccluded_0( _S657 : u32,  _S658 : SearchQuality_0,  _S659 : f32,  _S660 : f32,  _S661 : f32,  _S662 : vec3<f32>,  _S663 : bool) -> bool
{
    if((_S662.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S657, _S658, vec3<f32>(_S659, _S660, _S661 + fabrics_0[_S657].lift_0), _S662, _S663, max_height_along_0(_S657, _S659, _S660, _S661, _S662, _S663));
}

fn is_lit_0( _S664 : u32,  _S665 : SearchQuality_0,  _S666 : YarnPoint_0,  _S667 : vec3<f32>) -> bool
{
    if(_S666.hole_6)
    {
        return true;
    }
    var _S668 : vec3<f32> = to_face_frame_0(_S667, _S666.back_7);
    var _S669 : f32 = _S668.z;
    var _S670 : bool = _S669 < 0.0f;
    var normal_11 : vec3<f32>;
    var height_12 : f32;
    if(_S670)
    {
        var _S671 : SurfacePoint_0 = surface_at_0(_S664, _S666.x_15, _S666.y_8, !_S666.back_7);
        normal_11 = _S671.normal_1;
        height_12 = _S671.height_2;
    }
    else
    {
        normal_11 = _S666.surface_normal_0;
        height_12 = _S666.height_11;
    }
    var _S672 : vec3<f32> = vec3<f32>(_S668.xy, abs(_S669));
    if((dot(normal_11, _S672)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S664, _S665, _S666.x_15, _S666.y_8, height_12, _S672, (_S666.back_7) != _S670);
}

fn components_of_point_0( _S673 : u32,  _S674 : SearchQuality_0,  _S675 : YarnPoint_0,  _S676 : vec3<f32>,  _S677 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    result_3.hole_2 = select(0.0f, 1.0f, _S675.hole_6);
    var _S678 : bool;
    if(_S675.hole_6)
    {
        _S678 = true;
    }
    else
    {
        _S678 = !is_lit_0(_S673, _S674, _S675, _S676);
    }
    if(_S678)
    {
        return result_3;
    }
    var _S679 : vec3<f32> = to_face_frame_0(_S676, _S675.back_7);
    var _S680 : vec3<f32> = to_face_frame_0(_S677, _S675.back_7);
    var _S681 : bool = (_S679.z) < 0.0f;
    var _S682 : f32 = _S675.diffuse_gain_1 * diffuse_reflection_0(select_vector_1(_S681, (vec3<f32>(0) - _S679), _S679), _S675.normal_10, fabrics_0[_S673].diffuse_blend_0);
    var _S683 : f32;
    if(_S681)
    {
        _S683 = transmission_1(_S679, _S680, _S675.normal_10, _S675.tangent_10, _S675.roughness_10, fabrics_0[_S673].optical_depth_0);
    }
    else
    {
        _S683 = reflection_0(_S679, _S680, _S675.normal_10, _S675.tangent_10, _S675.roughness_10, fabrics_0[_S673].optical_depth_0);
    }
    result_3.diffuse_warp_0 = select(0.0f, _S682, _S675.is_warp_3);
    result_3.diffuse_weft_0 = select(_S682, 0.0f, _S675.is_warp_3);
    result_3.specular_warp_0 = select(0.0f, _S683, _S675.is_warp_3);
    result_3.specular_weft_0 = select(_S683, 0.0f, _S675.is_warp_3);
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S684 : u32,  _S685 : u32) -> f32
{
    return table_number_0(fabrics_0[_S684].openness_0 + _S685);
}

fn blocked_of_terms_0( _S686 : u32,  _S687 : u32,  _S688 : array<f32, i32(6)>,  _S689 : u32) -> Blocked_0
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
            if(term_0 < _S689)
            {
            }
            else
            {
                break;
            }
            shares_0[share_4] = shares_0[share_4] + openness_number_0(_S686, _S687 + share_4 * _S689 + term_0) * _S688[term_0];
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

fn blocked_at_0( _S690 : u32,  _S691 : bool,  _S692 : bool,  _S693 : f32,  _S694 : f32) -> Blocked_0
{
    var _S695 : f32 = _S694 * openness_number_0(_S690, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S693, _S695, _S693 * _S693, _S693 * _S695, _S695 * _S695 );
    return blocked_of_terms_0(_S690, u32(60) + (select(u32(0), u32(2), _S692) + select(u32(1), u32(0), _S691)) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S696 : u32,  _S697 : Blocked_0,  _S698 : YarnPoint_0,  _S699 : bool,  _S700 : f32) -> Blocked_0
{
    if(((_S698.hole_6) | (((_S698.is_warp_3) != _S699))))
    {
        return _S697;
    }
    var _S701 : Blocked_0 = blocked_at_0(_S696, _S699, _S698.back_7, _S698.surface_normal_0.z, _S698.height_11);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S697.by_warp_0 + _S700 * _S701.by_warp_0;
    result_4.by_weft_0 = _S697.by_weft_0 + _S700 * _S701.by_weft_0;
    result_4.far_0 = _S697.far_0 + _S700 * _S701.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S702 : u32,  _S703 : f32) -> vec3<f32>
{
    var _S704 : u32 = fabrics_0[_S702].lobes_0.levels_0 + u32(4) * u32(min(_S703, fabrics_0[_S702].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S704), table_number_0(_S704 + u32(1)), table_number_0(_S704 + u32(2)));
}

fn coverage_taps_0( _S705 : u32,  _S706 : Footprint_0,  _S707 : bool) -> CoverageTaps_0
{
    var _S708 : Lobes_std430_0 = fabrics_0[_S705].lobes_0;
    var _S709 : f32 = Footprint_spread_side_0(_S706) * fabrics_0[_S705].lobes_0.inverse_base_size_0;
    var _S710 : vec3<f32> = pyramid_level_0(_S705, floor(binary_logarithm_0(max(0.68000000715255737f * _S709, 1.0f))));
    var _S711 : f32 = 1.0f / max(_S709, 9.99999997475242708e-07f);
    var _S712 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S705].warp_0].inverse_period_0, families_0[fabrics_0[_S705].weft_0].inverse_period_0);
    var _S713 : vec2<f32> = _S706.centre_0 * _S712;
    var _S714 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S711 * _S711), 0.0f, 1.0f)), 0.3333333432674408f * _S711), 1.0f));
    var _S715 : vec2<f32> = _S706.dx_0 * _S712 * _S714;
    var _S716 : vec2<f32> = _S706.dy_0 * _S712 * _S714;
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
        var _S717 : vec2<f32> = _S713 + vec2<f32>(TAP_OFFSETS_0[number_3].x) * _S715 + vec2<f32>(TAP_OFFSETS_0[number_3].y) * _S716;
        var _S718 : f32 = _S710.y;
        taps_4.nodes_1[number_3] = select(u32(0), _S708.face_nodes_0, _S707) + u32(wrapped_cell_0(_S717.y, _S710.z) * _S718 + wrapped_cell_0(_S717.x, _S718) + _S710.x);
        number_3 = number_3 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S719 : u32,  _S720 : vec3<f32>,  _S721 : vec3<f32>,  _S722 : bool) -> vec2<f32>
{
    var _S723 : NodeTaps_0 = node_taps_of_0(_S721, u32(16));
    var _S724 : NodeTaps_0 = node_taps_of_0(_S720, u32(16));
    var _S725 : u32 = fabrics_0[_S719].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S722) + select(u32(0), u32(1), (_S720.z) < 0.0f)) * u32(512);
    var _S726 : u32 = _S725 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S723, _S725, u32(0)), joint_terms_0(_S724, _S726, u32(0))), dot(joint_terms_0(_S723, _S725, u32(1)), joint_terms_0(_S724, _S726, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S727 : u32,  _S728 : CoverageTaps_0,  _S729 : u32) -> vec4<f32>
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
        var _S730 : u32 = words_0[fabrics_0[_S727].lobes_0.coverage_0 + _S728.nodes_1[number_4] * fabrics_0[_S727].lobes_0.packs_0 + _S729];
        var even_2 : u32 = even_1 + ((_S730 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S730 >> (u32(8)))) & (u32(16711935))));
        number_4 = number_4 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S731 : u32,  _S732 : CoverageTaps_0) -> f32
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
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S731].lobes_0.coverage_holes_0 + _S732.nodes_1[number_5] / u32(4)] >> ((u32(8) * (_S732.nodes_1[number_5] % u32(4)))))) & (u32(255))));
        number_5 = number_5 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S733 : u32,  _S734 : CoverageTaps_0,  _S735 : NodeTaps_0,  _S736 : bool) -> f32
{
    var _S737 : f32 = interpolate_table_0(_S735, fabrics_0[_S733].lobes_0.projected_area_0 + fabrics_0[_S733].lobes_0.packs_0, fabrics_0[_S733].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S733, _S734) * _S737 * _S737 * select(fabrics_0[_S733].lobes_0.front_hole_weight_0, fabrics_0[_S733].lobes_0.back_hole_weight_0, _S736), 1.0f);
}

fn prefiltered_components_0( _S738 : u32,  _S739 : Footprint_0,  _S740 : vec3<f32>,  _S741 : vec3<f32>,  _S742 : bool) -> Components_0
{
    var _S743 : CoverageTaps_0 = coverage_taps_0(_S738, _S739, _S742);
    var _S744 : NodeTaps_0 = node_taps_0(_S741);
    var view_nodes_0 : NodeTaps_0 = _S744;
    var _S745 : NodeTaps_0 = node_taps_0(_S740);
    var light_nodes_0 : NodeTaps_0 = _S745;
    var _S746 : u32 = select(u32(0), u32(1), _S742);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S746 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S746 + select(u32(0), u32(1), (_S740.z) < 0.0f)) * u32(256)));
    var _S747 : vec3<f32> = half_vector_0(_S740, _S741);
    var _S748 : vec2<f32> = joint_ratios_0(_S738, _S740, _S741, _S742);
    var _S749 : Lobes_std430_0 = fabrics_0[_S738].lobes_0;
    var _S750 : u32 = select(fabrics_0[_S738].lobes_0.front_warp_packs_0, fabrics_0[_S738].lobes_0.back_warp_packs_0, _S742);
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
        if(pack_0 < (_S749.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S751 : vec4<f32> = coverage_of_pack_0(_S738, _S743, pack_0);
        var _S752 : vec4<f32> = interpolate_table_0(view_nodes_0, _S749.projected_area_0 + pack_0, _S749.packs_0 + u32(1));
        var _S753 : vec4<f32> = interpolate_table_0(light_nodes_0, _S749.light_visibility_0 + pack_0, _S749.packs_0) / vec4<f32>(255.0f);
        var _S754 : vec4<f32> = interpolate_table_0(light_nodes_0, _S749.irradiance_0 + pack_0, _S749.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S755 : bool = pack_0 < _S750;
        var _S756 : f32 = families_0[select(fabrics_0[_S738].weft_0, fabrics_0[_S738].warp_0, _S755)].roughness_0;
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
            var _S757 : Group_0 = group_at_0(_S749.moments_0 + u32(12) * (u32(4) * (_S746 * _S749.packs_0 + pack_0) + number_6), _S756);
            var _S758 : f32 = _S751[number_6] * _S752[number_6] * _S752[number_6] * _S757.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S758 * _S754[number_6];
            var specular_1 : f32 = specular_0 + _S758 * layer_value_0(_S757, _S747, _S740, _S741, fabrics_0[_S738].optical_depth_0) * _S753[number_6];
            var lit_1 : f32 = lit_0 + _S758 * _S753[number_6];
            var total_3 : f32 = total_2 + _S758;
            number_6 = number_6 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_0 = lit_1;
            total_2 = total_3;
        }
        sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 + select(0.0f, diffuse_0, _S755);
        sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 + select(diffuse_0, 0.0f, _S755);
        sums_4.specular_warp_0 = sums_4.specular_warp_0 + select(0.0f, specular_0, _S755);
        sums_4.specular_weft_0 = sums_4.specular_weft_0 + select(specular_0, 0.0f, _S755);
        sums_4.light_visibility_1 = sums_4.light_visibility_1 + lit_0 * select(_S748.y, _S748.x, _S755);
        pack_0 = pack_0 + u32(1);
    }
    var _S759 : f32 = prefiltered_hole_0(_S738, _S743, view_nodes_0, _S742);
    sums_4.hole_2 = _S759;
    var _S760 : f32 = 1.0f - _S759;
    var _S761 : f32 = _S760 / max(total_2, 9.999999960041972e-13f);
    var _S762 : f32 = _S761 * _S748.x;
    sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 * _S762;
    var _S763 : f32 = _S761 * _S748.y;
    sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 * _S763;
    sums_4.specular_warp_0 = sums_4.specular_warp_0 * _S762;
    sums_4.specular_weft_0 = sums_4.specular_weft_0 * _S763;
    sums_4.light_visibility_1 = min(sums_4.light_visibility_1 * _S761, _S760);
    return sums_4;
}

fn albedos_over_0( _S764 : u32,  _S765 : Footprint_0,  _S766 : bool) -> FamilyAlbedos_0
{
    var _S767 : vec2<f32> = _S765.dx_0;
    var _S768 : vec2<f32> = _S765.dy_0;
    var _S769 : vec2<f32> = sqrt(_S767 * _S767 + _S768 * _S768);
    var _S770 : Stretch_0 = stretch_of_0(fabrics_0[_S764].warp_0, _S765.centre_0.x, _S769.x);
    var _S771 : Stretch_0 = stretch_of_0(fabrics_0[_S764].weft_0, _S765.centre_0.y, _S769.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S764].warp_0, fabrics_0[_S764].weft_0, _S770, _S771, _S766);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S764].weft_0, fabrics_0[_S764].warp_0, _S771, _S770, _S766);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S772 : u32,  _S773 : Footprint_0,  _S774 : f32,  _S775 : vec2<f32>,  _S776 : vec3<f32>,  _S777 : vec3<f32>) -> Estimate_0
{
    var _S778 : f32;
    var _S779 : Regime_0 = regime_of_0(_S772, _S773, _S774);
    var _S780 : bool = (_S777.z) < 0.0f;
    var _S781 : vec3<f32> = to_face_frame_0(_S777, _S780);
    var _S782 : f32 = Footprint_spread_side_0(_S773);
    var _S783 : bool = varies_at_0(_S772, _S782);
    var _S784 : f32 = 1.0f - _S779.prefiltered_0;
    var _S785 : bool = ((_S784 > 0.0f) & (((_S783 | (((((families_0[fabrics_0[_S772].warp_0].quantities_0) > u32(1)) | (((families_0[fabrics_0[_S772].weft_0].quantities_0) > u32(1))))))))));
    var box_0 : Footprint_0 = _S773;
    var _S786 : vec3<f32> = vec3<f32>(0.0f);
    var _S787 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S786, _S786, 0.0f, 0.0f, 0.0f, 0.0f);
    var _S788 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S789 : u32 = select(u32(1), u32(0), _S785);
    var points_1 : Components_0 = _S788;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S787;
    var central_place_0 : vec2<f32> = _S773.centre_0;
    var number_7 : u32 = _S789;
    for(;;)
    {
        var _S790 : f32 = f32(number_7);
        _S778 = _S779.points_0;
        if(_S790 < (_S779.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S791 : bool = number_7 == u32(0);
        var _S792 : u32 = number_7 - u32(1);
        var _S793 : vec2<f32> = POINT_OFFSETS_0[select(_S792, u32(0), _S791)] + _S775;
        var _S794 : vec2<f32> = select_vector_0(_S791, vec2<f32>(0.0f), _S793 - round(_S793));
        var _S795 : vec2<f32> = _S773.centre_0 + vec2<f32>(_S794.x) * _S773.dx_0 + vec2<f32>(_S794.y) * _S773.dy_0;
        var _S796 : SearchQuality_0 = quality_of_0(select(_S779.threads_1, 0.0f, _S791));
        var _S797 : Hit_0 = first_hit_0(_S772, _S796, _S795.x, _S795.y, _S781, _S780);
        var _S798 : SurfacePoint_0 = surface_at_0(_S772, _S797.x_14, _S797.y_7, _S780);
        if(_S791)
        {
            var central_weight_1 : f32 = select(_S784, 0.0f, _S797.hole_5);
            var central_place_1 : vec2<f32> = vec2<f32>(_S797.x_14, _S797.y_7);
            box_0.centre_0 = mix(_S773.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S798;
            central_place_0 = central_place_1;
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S799 : YarnPoint_0 = yarn_point_of_0(_S772, _S798, _S797.x_14, _S797.y_7, _S780, _S797.hole_5, _S782);
        var _S800 : f32 = min(_S779.points_0 - f32(_S792), 1.0f);
        var _S801 : Components_0 = with_added_0(points_1, components_of_point_0(_S772, _S796, _S799, _S776, _S777), _S800);
        if((fabrics_0[_S772].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S772, close_1.warp_1, _S799, true, _S800);
            close_1.weft_1 = with_blocked_0(_S772, close_1.weft_1, _S799, false, _S800);
        }
        points_1 = _S801;
        number_7 = number_7 + u32(1);
    }
    close_1.weight_0 = _S784;
    var _S802 : f32 = max(_S778, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S802);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S802);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S788, points_1, _S784 / _S802);
    if((_S779.prefiltered_0) > 0.0f)
    {
        var _S803 : Components_0 = prefiltered_components_0(_S772, _S773, to_face_frame_0(_S776, _S780), _S781, _S780);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S803, _S779.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S772, box_0, _S780);
    if((_S783 & ((central_weight_0 > 0.0f))))
    {
        var _S804 : SurfacePoint_0 = central_0;
        var _S805 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S805 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S805 = estimate_0.albedos_5.weft_5;
        }
        var _S806 : bool;
        if((fabrics_0[_S772].has_detail_0) != u32(0))
        {
            _S806 = has_hairs_0(_S772);
        }
        else
        {
            _S806 = false;
        }
        var _S807 : f32;
        if(_S806)
        {
            _S807 = hair_at_0(_S772, central_place_0, _S780, _S782).cover_0;
        }
        else
        {
            _S807 = 0.0f;
        }
        var _S808 : Albedos_0 = lerp_albedos_0(_S805, varied_at_0(_S772, central_0, _S805, central_place_0.x, central_place_0.y, _S780, _S782, _S807), central_weight_0);
        if(_S804.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S808;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S808;
        }
    }
    return estimate_0;
}

fn scattered_by_0( _S809 : u32,  _S810 : Albedos_0,  _S811 : u32,  _S812 : vec3<f32>) -> Scattered_0
{
    var _S813 : u32 = u32(159) + u32(2) * _S811;
    var yarn_3 : Scattered_0;
    yarn_3.back_6 = _S812 * _S810.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S809, _S813)) * _S810.specular_reflect_0;
    yarn_3.through_0 = _S812 * _S810.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S809, _S813 + u32(1))) * _S810.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S814 : u32,  _S815 : u32,  _S816 : vec3<f32>,  _S817 : vec3<f32>,  _S818 : vec3<f32>,  _S819 : vec3<f32>,  _S820 : ptr<function, vec3<f32>>,  _S821 : ptr<function, vec3<f32>>)
{
    var _S822 : u32 = u32(146) + u32(4) * _S815;
    var _S823 : f32 = openness_number_0(_S814, _S822 + u32(1));
    var _S824 : f32 = openness_number_0(_S814, _S822 + u32(2));
    var _S825 : vec3<f32> = vec3<f32>(1.0f);
    var _S826 : vec3<f32> = _S825 - _S818 * vec3<f32>(openness_number_0(_S814, _S822));
    var _S827 : vec3<f32> = _S825 - _S819 * vec3<f32>(openness_number_0(_S814, _S822 + u32(3)));
    var _S828 : vec3<f32> = _S825 / (_S826 * _S827 - _S818 * _S819 * vec3<f32>((_S823 * _S824)));
    (*_S820) = (_S816 * _S827 + _S818 * vec3<f32>(_S823) * _S817) * _S828;
    (*_S821) = (_S817 * _S826 + _S819 * vec3<f32>(_S824) * _S816) * _S828;
    return;
}

fn face_sends_0( _S829 : u32,  _S830 : u32,  _S831 : Scattered_0,  _S832 : Scattered_0) -> FaceSends_0
{
    var _S833 : u32 = u32(2) * _S830;
    var _S834 : u32 = u32(142) + _S833;
    var _S835 : f32 = openness_number_0(_S829, _S834);
    var _S836 : f32 = openness_number_0(_S829, _S834 + u32(1));
    var _S837 : vec3<f32> = vec3<f32>((1.0f - _S835)) * _S831.back_6;
    var _S838 : vec3<f32> = vec3<f32>((1.0f - _S836)) * _S832.back_6;
    var sends_1 : FaceSends_0;
    var _S839 : u32 = u32(154) + _S833;
    var _S840 : f32 = openness_number_0(_S829, _S839);
    sends_1.blocks_warp_0 = _S840;
    var _S841 : f32 = openness_number_0(_S829, _S839 + u32(1));
    sends_1.blocks_weft_0 = _S841;
    sends_1.open_0 = _S840 * _S835 + _S841 * _S836;
    var _S842 : vec3<f32> = vec3<f32>(_S835) * _S831.back_6;
    var _S843 : vec3<f32> = vec3<f32>(_S836) * _S832.back_6;
    var _S844 : vec3<f32> = sends_1.sky_warp_0;
    var _S845 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S829, _S830, _S842, _S843, _S837, _S838, &(_S844), &(_S845));
    sends_1.sky_warp_0 = _S844;
    sends_1.sky_weft_0 = _S845;
    var _S846 : vec3<f32> = sends_1.crossing_warp_0;
    var _S847 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S829, _S830, _S831.through_0, _S832.through_0, _S837, _S838, &(_S846), &(_S847));
    sends_1.crossing_warp_0 = _S846;
    sends_1.crossing_weft_0 = _S847;
    return sends_1;
}

fn interior_of_0( _S848 : u32,  _S849 : vec3<f32>,  _S850 : bool) -> Interior_0
{
    var _S851 : Scattered_0 = scattered_by_0(_S848, table_albedos_0(families_0[fabrics_0[_S848].warp_0].colour_mean_0), u32(0), _S849);
    var _S852 : Scattered_0 = scattered_by_0(_S848, table_albedos_0(families_0[fabrics_0[_S848].weft_0].colour_mean_0), u32(1), _S849);
    var _S853 : FaceSends_0 = face_sends_0(_S848, select(u32(0), u32(1), _S850), _S851, _S852);
    var _S854 : FaceSends_0 = face_sends_0(_S848, select(u32(1), u32(0), _S850), _S851, _S852);
    var _S855 : vec3<f32> = vec3<f32>(_S853.blocks_warp_0);
    var _S856 : vec3<f32> = vec3<f32>(_S853.blocks_weft_0);
    var _S857 : vec3<f32> = _S855 * _S853.crossing_warp_0 + _S856 * _S853.crossing_weft_0;
    var _S858 : vec3<f32> = vec3<f32>(_S854.blocks_warp_0);
    var _S859 : vec3<f32> = vec3<f32>(_S854.blocks_weft_0);
    var _S860 : vec3<f32> = _S858 * _S854.crossing_warp_0 + _S859 * _S854.crossing_weft_0;
    var _S861 : f32 = 1.0f - _S853.open_0;
    var _S862 : f32 = 1.0f - _S854.open_0;
    var _S863 : vec3<f32> = vec3<f32>(1.0f);
    var _S864 : vec3<f32> = _S863 / (_S863 - _S857 * _S860 * vec3<f32>((_S861 * _S862)));
    var _S865 : vec3<f32> = _S860 * (vec3<f32>(_S853.open_0) + vec3<f32>(_S861) * (_S855 * _S853.sky_warp_0 + _S856 * _S853.sky_weft_0)) * _S864;
    var _S866 : vec3<f32> = _S857 * (vec3<f32>(_S854.open_0) + vec3<f32>(_S862) * (_S858 * _S854.sky_warp_0 + _S859 * _S854.sky_weft_0)) * _S864;
    var _S867 : FaceRadiance_0 = face_radiance_0(_S853, _S854.open_0, _S865, _S866);
    var _S868 : FaceRadiance_0 = face_radiance_0(_S854, _S853.open_0, _S866, _S865);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S867.warp_3;
    interior_1.weft_4 = _S867.weft_3;
    interior_1.leaked_1 = _S867.leaked_0;
    interior_1.far_1 = _S868.mean_1;
    interior_1.far_leaked_0 = _S868.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S869 : u32,  _S870 : vec3<f32>,  _S871 : bool,  _S872 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S870, &(terms_3));
    return blocked_of_terms_0(_S869, (select(u32(0), u32(2), _S872) + select(u32(1), u32(0), _S871)) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S873 : u32,  _S874 : vec3<f32>,  _S875 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S874, &(terms_4));
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
        var share_6 : f32 = share_5 + openness_number_0(_S873, u32(132) + select(u32(0), u32(5), _S875) + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S876 : u32,  _S877 : FamilyAlbedos_0,  _S878 : vec3<f32>,  _S879 : Interior_0,  _S880 : Blocked_0,  _S881 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S880, scattered_by_0(_S876, _S877.warp_5, u32(0), _S878), _S879), bounced_by_0(_S881, scattered_by_0(_S876, _S877.weft_5, u32(1), _S878), _S879));
}

fn bounced_far_0( _S882 : u32,  _S883 : FamilyAlbedos_0,  _S884 : vec3<f32>,  _S885 : Interior_0,  _S886 : vec3<f32>,  _S887 : bool,  _S888 : f32,  _S889 : f32,  _S890 : f32) -> Bounced_0
{
    var _S891 : Blocked_0 = blocked_from_0(_S882, _S886, true, _S887);
    var _S892 : Blocked_0 = blocked_from_0(_S882, _S886, false, _S887);
    var _S893 : f32 = _S888 / max(1.0f - _S891.by_warp_0 - _S891.by_weft_0, 0.10000000149011612f);
    var _S894 : f32 = (0.0020000000949949f * warp_seen_from_0(_S882, _S886, _S887) + _S893) / (_S893 + _S889 / max(1.0f - _S892.by_warp_0 - _S892.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S895 : f32 = 1.0f - _S890;
    return bounced_of_families_0(_S882, _S883, _S884, _S885, scaled_0(_S891, _S894 * _S895), scaled_0(_S892, (1.0f - _S894) * _S895));
}

fn bounced_over_0( _S896 : u32,  _S897 : Components_0,  _S898 : CloseUp_0,  _S899 : FamilyAlbedos_0,  _S900 : vec3<f32>,  _S901 : vec3<f32>) -> Bounced_0
{
    var _S902 : bool = (_S901.z) < 0.0f;
    var _S903 : Interior_0 = interior_of_0(_S896, _S900, _S902);
    var bounced_2 : Bounced_0 = bounced_far_0(_S896, _S899, _S900, _S903, to_face_frame_0(_S901, _S902), _S902, _S897.diffuse_warp_0, _S897.diffuse_weft_0, _S897.hole_2);
    if((_S898.weight_0) > 0.0f)
    {
        var _S904 : Bounced_0 = bounced_of_families_0(_S896, _S899, _S900, _S903, _S898.warp_1, _S898.weft_1);
        var _S905 : vec3<f32> = vec3<f32>(_S898.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S904.reflected_0, _S905);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S904.transmitted_0, _S905);
    }
    return bounced_2;
}

fn composed_0( _S906 : u32,  _S907 : Components_0,  _S908 : CloseUp_0,  _S909 : FamilyAlbedos_0,  _S910 : vec3<f32>,  _S911 : vec3<f32>,  _S912 : vec3<f32>) -> vec3<f32>
{
    var _S913 : Albedos_0 = tinted_0(_S909.warp_5, _S910);
    var _S914 : Albedos_0 = tinted_0(_S909.weft_5, _S910);
    var _S915 : vec3<f32> = vec3<f32>(_S907.diffuse_warp_0);
    var _S916 : vec3<f32> = vec3<f32>(_S907.diffuse_weft_0);
    var _S917 : vec3<f32> = vec3<f32>(_S907.specular_warp_0);
    var _S918 : vec3<f32> = vec3<f32>(_S907.specular_weft_0);
    var _S919 : vec3<f32> = _S913.diffuse_reflect_0 * _S915 + _S914.diffuse_reflect_0 * _S916 + _S913.specular_reflect_0 * _S917 + _S914.specular_reflect_0 * _S918;
    var _S920 : f32 = _S912.z;
    var body_0 : vec3<f32>;
    if((_S911.z * _S920) < 0.0f)
    {
        body_0 = _S913.diffuse_transmit_0 * _S915 + _S914.diffuse_transmit_0 * _S916 + _S913.specular_transmit_0 * _S917 + _S914.specular_transmit_0 * _S918;
    }
    else
    {
        body_0 = _S919;
    }
    if((fabrics_0[_S906].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S906, _S907, _S908, _S909, _S910, _S912), _S911, _S912);
    }
    var _S921 : f32 = fabrics_0[_S906].sheen_strength_0;
    if((fabrics_0[_S906].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S922 : bool = _S920 < 0.0f;
    var _S923 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S911, _S922), to_face_frame_0(_S912, _S922), _S921, fabrics_0[_S906].sheen_roughness_0);
    return vec3<f32>(_S923.y) * body_0 + vec3<f32>(((_S907.light_visibility_1 + _S907.hole_2) * _S923.x));
}

fn light_of_footprint_0( _S924 : u32,  _S925 : VisiblePoint_0,  _S926 : vec2<u32>,  _S927 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S925.draft_0;
    footprint_0.dx_0 = _S925.draft_dx_0;
    footprint_0.dy_0 = _S925.draft_dy_0;
    var _S928 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S929 : vec3<f32> = to_local_0(_S925, _S925.view_0);
    var _S930 : u32 = light_sample_count_0();
    var _S931 : vec3<f32> = vec3<f32>(0.0f);
    var number_8 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S931;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        if(number_8 < (max(_S930, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S932 : f32;
        if(number_8 < _S930)
        {
            _S932 = visibility_at_0(number_8, _S926);
        }
        else
        {
            _S932 = 0.0f;
        }
        var _S933 : bool;
        if(_S932 <= 0.0f)
        {
            _S933 = number_8 > u32(0);
        }
        else
        {
            _S933 = false;
        }
        if(_S933)
        {
            number_8 = number_8 + u32(1);
            continue;
        }
        var _S934 : LightSample_0 = light_sample_0(number_8, _S926, _S925.position_0);
        var _S935 : vec3<f32> = to_local_0(_S925, _S934.towards_0);
        var _S936 : Estimate_0 = lobes_estimate_of_pass_0(_S924, footprint_0, 1.0f, _S928, _S935, _S929);
        radiance_1 = radiance_1 + vec3<f32>(_S932) * _S934.irradiance_1 * composed_0(_S924, _S936.components_0, _S936.close_0, _S936.albedos_5, _S927, _S935, _S929);
        hole_7 = _S936.components_0.hole_2;
        number_8 = number_8 + u32(1);
    }
    var _S937 : f32 = fabrics_0[_S924].sheen_strength_0;
    if((fabrics_0[_S924].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S937 * sheen_lobe_0(abs(_S929.z), fabrics_0[_S924].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S938 : u32 = id_0.x;
    var _S939 : bool;
    if(_S938 >= (frame_record_0.width_0))
    {
        _S939 = true;
    }
    else
    {
        _S939 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S939)
    {
        return;
    }
    var _S940 : u32 = id_0.y * frame_record_0.width_0 + _S938;
    var _S941 : u32 = layers_0[_S940].face_0;
    if((layers_0[_S940].face_0) == u32(0))
    {
        return;
    }
    var _S942 : u32 = _S941 - u32(1);
    var _S943 : u32 = fabric_of_0(_S942);
    var _S944 : vec2<u32> = id_0.xy;
    var _S945 : VisiblePoint_0 = visible_point_0(_S943, _S942, _S944);
    var _S946 : vec4<f32> = light_of_footprint_0(_S943, _S945, _S944, filtered_albedo_0(_S943, _S945));
    accumulate_0(_S940, _S946);
    return;
}

