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
     x_8 : f32,
     y_2 : f32,
     shown_share_0 : f32,
};

fn SurfacePoint_x24init_0( hole_1 : bool,  is_warp_1 : bool,  warp_thread_1 : u32,  weft_thread_1 : u32,  height_3 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>,  across_1 : f32,  fibre_across_1 : f32,  fibre_along_1 : f32,  x_9 : f32,  y_3 : f32,  shown_share_1 : f32) -> SurfacePoint_0
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
    _S44.x_8 = x_9;
    _S44.y_2 = y_3;
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

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
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
    var _S82 : f32 = 2.0f * _S78;
    var _S83 : f32 = 1.0f / max(_S82, 9.999999960041972e-13f);
    var _S84 : f32 = clamp((_S78 - _S77) * _S83, 0.0f, 1.0f);
    var _S85 : f32 = clamp((0.44999998807907104f - _S82 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S80 + (_S81 - _S80) * (_S84 * _S84 * (3.0f - 2.0f * _S84)), (_S80 - _S81) * (6.0f * _S84 * (1.0f - _S84) * _S83) * select(-1.0f, 1.0f, _S76), _S85 * _S85 * (3.0f - 2.0f * _S85));
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
    var _S86 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S86), 9.99999971718068537e-10f);
    var _S87 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S87), 9.99999971718068537e-10f);
    control_0.right_0 = _S86 > 0.0f;
    control_0.up_0 = _S87 > 0.0f;
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
    var _S88 : f32 = select(- cell_6.across_2, cell_6.across_2, forwards_0);
    var _S89 : f32 = select(cell_6.below_0, cell_6.above_0, forwards_0);
    var _S90 : f32 = - cell_6.half_width_1;
    var _S91 : bool = _S88 < _S90;
    var _S92 : bool = _S88 >= (cell_6.half_width_1);
    var _S93 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_3)));
    var _S94 : f32 = select(cell_6.half_width_1, _S90, _S91) - _S88;
    var _S95 : f32 = select(_S89, 2.0f * _S89 + _S88 - cell_6.half_width_1, ((shown_2.hole_3) | (((_S93 & ((!shown_2.on_top_0)))))));
    if((((_S93 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S91)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S94, _S95, _S92);
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
    var _S96 : f32 = previous_1.rate_0 * step_4;
    var _S97 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_4)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S96) >= 0.0f) & (((3.0f * clearance_1 - _S97) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S98 : f32 = clearance_1 - previous_1.clearance_0;
    var _S99 : f32 = 6.0f * _S98 - 4.0f * _S96 - 2.0f * _S97;
    var _S100 : f32 = -2.0f * _S96 / max(_S99 + sqrt(max(_S99 * _S99 - 4.0f * (3.0f * (_S96 + _S97 - 2.0f * _S98)) * _S96, 0.0f)), 9.99999968265522539e-21f);
    var _S101 : f32 = 1.0f - _S100;
    return select(-1.0f, _S101 * step_4, ((((_S100 > 0.01999999955296516f) & ((_S101 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S100 + 1.0f) + _S96 * _S100) * _S101 * _S101 + (clearance_1 * (2.0f * _S101 + 1.0f) - _S97 * _S101) * _S100 * _S100) < 0.0f))));
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
    var _S102 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S102, 0.0f) + this_2.epsilon_0, _S102 - this_2.epsilon_0, ((((!here_2.hole_4) & (((rate_3 * _S102 + clearance_3) < 0.0f)))) & ((_S102 > (2.0f * this_2.epsilon_0))))));
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
    var _S103 : f32 = end_0 - start_1;
    var _S104 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S103;
    var _S105 : f32 = 3.0f * _S103 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S103, 9.99999968265522539e-21f);
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
        var _S106 : f32 = clamp(share_1 - (((_S104 * share_1 + _S105) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S104 * share_1 + 2.0f * _S105) * share_1 + start_rate_0, 0.10000000149011612f * _S103 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S107 : i32 = i_0 + i32(1);
        share_1 = _S106;
        i_0 = _S107;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S108 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S109 : f32 = rsqrt_0(_S108);
    var _S110 : f32 = sine_1 * _S109 * rsqrt_0(_S108 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S110 * _S108, _S110 * across_slope_0 * along_slope_0 + cosine_0 * _S109);
}

fn arc_sine_0( x_10 : f32) -> f32
{
    var _S111 : f32 = abs(x_10);
    var _S112 : bool = _S111 > 0.5f;
    var _S113 : f32 = select(_S111 * _S111, 0.5f * (1.0f - _S111), _S112);
    var _S114 : f32 = select(_S111, sqrt(max(_S113, 0.0f)), _S112);
    var _S115 : f32 = ((((0.04216320067644119f * _S113 + 0.02418131195008755f) * _S113 + 0.04547002539038658f) * _S113 + 0.07495300471782684f) * _S113 + 0.16666752099990845f) * _S113 * _S114 + _S114;
    var _S116 : f32 = select(_S115, 1.57079637050628662f - 2.0f * _S115, _S112);
    return select(_S116, - _S116, x_10 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S117 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S117 / (_S117 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S118 : f32 = direction_3.x;
    var _S119 : f32 = arc_sine_0(_S118);
    var _S120 : bool = _S118 < 0.0f;
    var _S121 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S120);
    var _S122 : f32 = direction_3.y;
    return select(0.5f * _S121 - select(1.0f, -1.0f, _S120) * arc_sine_0(_S122), select(_S119, _S121 - _S119, _S122 < 0.0f), (abs(_S118)) < 0.69999998807907104f);
}

struct Hair_0
{
     cover_0 : f32,
     normal_3 : vec3<f32>,
     tangent_2 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_4 : vec3<f32>,  tangent_3 : vec3<f32>) -> Hair_0
{
    var _S123 : Hair_0;
    _S123.cover_0 = cover_1;
    _S123.normal_3 = normal_4;
    _S123.tangent_2 = tangent_3;
    return _S123;
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
    var _S124 : f32 = floor(across_4 / width_2);
    return vec3<f32>(_S124, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S124, 2.0f * (across_4 / width_2 - _S124) - 1.0f);
}

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S125 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S125 - floor(_S125)) - 1.0f;
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
    var _S126 : f32 = floor(position_4);
    var _S127 : f32 = position_4 - _S126;
    var _S128 : u32 = u32(i32(_S126));
    var _S129 : f32 = signed_noise_0(hash_bits_0(key_1, _S128));
    var _S130 : f32 = signed_noise_0(hash_bits_0(key_1, _S128 + u32(1)));
    return vec2<f32>(mix(_S129, _S130, smooth_share_0(_S127)), 6.0f * _S127 * (1.0f - _S127) * (_S130 - _S129));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S131 : f32 = cell_7.y;
    var _S132 : f32 = floor(_S131);
    var _S133 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S132));
    var _S134 : u32 = hash_bits_0(key_2, _S133);
    var _S135 : u32 = hash_bits_0(key_2, _S133 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S134), signed_noise_0((_S134 >> (u32(16))))), vec2<f32>(signed_noise_0(_S135), signed_noise_0((_S135 >> (u32(16))))), vec2<f32>(smooth_share_0(_S131 - _S132)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S136 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S136.x, _S136.y), _S136.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S137 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S137.x, _S137.y), _S137.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
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
    var _S138 : vec3<f32> = select_vector_1((dot(frame_0.tangent_4, hair_0.tangent_2)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_2), hair_0.tangent_2);
    var blended_0 : YarnFrame_0;
    var _S139 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S140 : vec3<f32> = normalize(mix(frame_0.normal_5, hair_0.normal_3, _S139));
    blended_0.normal_5 = _S140;
    var _S141 : vec3<f32> = mix(frame_0.tangent_4, _S138, _S139);
    var _S142 : vec3<f32> = _S141 - vec3<f32>(dot(_S141, _S140)) * _S140;
    blended_0.tangent_4 = _S142 * vec3<f32>(rsqrt_0(max(dot(_S142, _S142), 9.999999960041972e-13f)));
    blended_0.loss_0 = frame_0.loss_0 * (1.0f - hair_0.cover_0);
    return blended_0;
}

fn diffuse_gain_0( frame_1 : YarnFrame_0,  blend_0 : f32) -> f32
{
    return min(0.85000002384185791f * blend_0 * frame_1.loss_0 + 1.0f, 1.0f / (0.5f * blend_0 * (frame_1.normal_5.z - 1.0f) + 1.0f));
}

fn diffuse_reflection_0( light_1 : vec3<f32>,  normal_6 : vec3<f32>,  blend_1 : f32) -> f32
{
    var _S143 : f32 = light_1.z;
    if(_S143 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S143, 0.0f), max(dot(light_1, normal_6), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S144 : f32 = dot(direction_4, tangent_5);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S144 * _S144 + 1.0f, roughness_1 * roughness_1));
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
    var _S145 : f32 = roughness_2 * roughness_2;
    var _S146 : f32 = squared_along_0 * (1.0f - _S145) + _S145;
    return 0.31830987334251404f * _S145 * roughness_2 / (_S146 * _S146);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S147 : vec3<f32> = light_2 + view_1;
    var _S148 : f32 = dot(_S147, tangent_6);
    return flake_density_0(min(_S148 * _S148 / max(square_0(_S147), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn transmission_1( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S149 : f32 = - dot(light_3, normal_7);
    var _S150 : f32 = dot(view_2, normal_7);
    if(((_S149 <= 0.0f) | ((_S150 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S151 : f32 = 1.0f / max(_S150, 9.99999997475242708e-07f);
    var _S152 : f32 = projected_area_1(light_3, tangent_7, roughness_4) / max(_S149, 9.99999997475242708e-07f);
    var _S153 : f32 = projected_area_1(view_2, tangent_7, roughness_4) * _S151;
    return density_between_0(light_3, view_2, tangent_7, roughness_4) * 0.25f * optical_depth_1 * exponential_0(- optical_depth_1 * min(_S152, _S153)) * mean_attenuation_0(optical_depth_1 * abs(_S152 - _S153)) * _S151;
}

fn reflection_0( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_8 : vec3<f32>,  tangent_8 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S154 : f32 = dot(light_4, normal_8);
    var _S155 : f32 = dot(view_3, normal_8);
    if(((_S154 <= 0.0f) | ((_S155 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S156 : f32 = max(_S154, 9.99999997475242708e-07f);
    var _S157 : f32 = max(_S155, 9.99999997475242708e-07f);
    var _S158 : f32 = projected_area_1(light_4, tangent_8, roughness_5) * _S157 + projected_area_1(view_3, tangent_8, roughness_5) * _S156;
    var _S159 : f32 = optical_depth_2 * _S158 / (_S156 * _S157);
    return 0.25f * density_between_0(light_4, view_3, tangent_8, roughness_5) * (_S159 * mean_attenuation_0(_S159)) * _S156 / _S158;
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
    var _S160 : f32 = abs(x_12);
    var _S161 : f32 = abs(y_5);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S160, _S161) / max(max(_S160, _S161), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S161 > _S160);
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
    var _S162 : f32 = arc_tangent_0(direction_5.y, direction_5.x) * (0.5f * f32(azimuths_0) * 0.31830987334251404f);
    var _S163 : f32 = floor(_S162);
    var _S164 : f32 = _S162 - _S163;
    var _S165 : f32 = sqrt(clamp((1.0f - abs(direction_5.z)) / 0.97000002861022949f, 0.0f, 1.0f));
    var _S166 : f32 = 7.0f * _S165 * sqrt(_S165);
    var _S167 : f32 = min(floor(_S166), 6.0f);
    var _S168 : f32 = _S166 - _S167;
    var _S169 : u32 = u32(i32(_S163) + i32(azimuths_0)) % azimuths_0;
    var _S170 : u32 = u32(_S167);
    var _S171 : u32 = _S169 * u32(8) + _S170;
    var _S172 : u32 = (_S169 + u32(1)) % azimuths_0;
    var _S173 : u32 = _S172 * u32(8) + _S170;
    var taps_0 : NodeTaps_0;
    taps_0.nodes_0 = vec4<u32>(_S171, _S171 + u32(1), _S173, _S173 + u32(1));
    var _S174 : f32 = 1.0f - _S164;
    var _S175 : f32 = 1.0f - _S168;
    var _S176 : vec4<u32> = vec4<u32>(vec4<f32>(_S174 * _S175, _S174 * _S168, _S164 * _S175, _S164 * _S168) * vec4<f32>(252.0f) + vec4<f32>(0.5f));
    taps_0.weights_0 = _S176;
    taps_0.inverse_sum_0 = 1.0f / f32(_S176.x + _S176.y + _S176.z + _S176.w);
    return taps_0;
}

fn node_taps_0( direction_6 : vec3<f32>) -> NodeTaps_0
{
    var _S177 : NodeTaps_0 = node_taps_of_0(direction_6, u32(32));
    return _S177;
}

fn half_vector_0( light_5 : vec3<f32>,  view_4 : vec3<f32>) -> vec3<f32>
{
    var _S178 : vec3<f32> = light_5 + view_4;
    return _S178 * vec3<f32>(rsqrt_0(max(square_0(_S178), 9.999999960041972e-13f)));
}

fn joint_terms_0( taps_1 : NodeTaps_0,  table_1 : u32,  ratio_1 : u32) -> vec4<f32>
{
    var _S179 : vec4<f32> = vec4<f32>(0.0f);
    var i_1 : u32 = u32(0);
    var sums_2 : vec4<f32> = _S179;
    for(;;)
    {
        if(i_1 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S180 : u32 = table_1 + u32(4) * taps_1.nodes_0[i_1] + u32(2) * ratio_1;
        var _S181 : vec2<u32> = vec2<u32>(words_0[_S180], words_0[_S180 + u32(1)]);
        var sums_3 : vec4<f32> = sums_2 + vec4<f32>(((vec4<i32>(vec2<i32>((_S181 << (vec2<u32>(u32(16))))), vec2<i32>(_S181)).xzyw) >> (vec4<u32>(u32(16))))) * vec4<f32>(f32(taps_1.weights_0[i_1]));
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
    var _S182 : vec4<u32> = vec4<u32>(u32(16711935));
    var _S183 : vec4<u32> = ((packs_1 & (_S182))) * taps_2.weights_0;
    var _S184 : vec4<u32> = ((((packs_1 >> (vec4<u32>(u32(8))))) & (_S182))) * taps_2.weights_0;
    return bytes_of_sums_0(_S183.x + _S183.y + _S183.z + _S183.w, _S184.x + _S184.y + _S184.z + _S184.w) * vec4<f32>(taps_2.inverse_sum_0);
}

fn interpolate_table_0( taps_3 : NodeTaps_0,  table_2 : u32,  stride_0 : u32) -> vec4<f32>
{
    var _S185 : vec4<u32> = vec4<u32>(table_2) + taps_3.nodes_0 * vec4<u32>(stride_0);
    return interpolate_0(taps_3, vec4<u32>(words_0[_S185.x], words_0[_S185.y], words_0[_S185.z], words_0[_S185.w]));
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
    var _S186 : vec3<f32> = vec3<f32>(table_number_0(row_1 + u32(4)), table_number_0(row_1 + u32(5)), table_number_0(row_1 + u32(6)));
    group_0.tangent_9 = _S186;
    var _S187 : f32 = table_number_0(row_1 + u32(7));
    var _S188 : f32 = table_number_0(row_1 + u32(8));
    group_0.variance_0 = vec3<f32>(_S187, _S188, 1.0f - square_0(_S186) - _S187 - _S188);
    group_0.covariance_0 = vec3<f32>(table_number_0(row_1 + u32(9)), table_number_0(row_1 + u32(10)), table_number_0(row_1 + u32(11)));
    group_0.roughness_6 = roughness_7;
    return group_0;
}

fn Group_variance_along_0( this_5 : Group_0,  direction_7 : vec3<f32>) -> f32
{
    var _S189 : f32 = direction_7.x;
    var _S190 : f32 = direction_7.y;
    var _S191 : f32 = direction_7.z;
    return max(dot(this_5.variance_0, direction_7 * direction_7) + 2.0f * dot(this_5.covariance_0, vec3<f32>(_S189 * _S190, _S189 * _S191, _S190 * _S191)), 0.0f);
}

fn mean_area_0( group_1 : Group_0,  direction_8 : vec3<f32>) -> f32
{
    var _S192 : f32 = dot(direction_8, group_1.tangent_9);
    var _S193 : f32 = group_1.roughness_6;
    var _S194 : f32 = _S193 * _S193;
    return sqrt(max((_S194 - 1.0f) * (_S192 * _S192 + Group_variance_along_0(group_1, direction_8)) + 1.0f, _S194));
}

fn mean_density_0( group_2 : Group_0,  half_0 : vec3<f32>) -> f32
{
    var _S195 : f32 = group_2.roughness_6;
    var _S196 : f32 = max(sqrt(max(1.0f - _S195 * _S195, 0.0f)) / group_2.roughness_6, 0.00100000004749745f);
    var _S197 : f32 = max(sqrt(3.0f * Group_variance_along_0(group_2, half_0)), group_2.roughness_6 * 0.01999999955296516f + 0.00009999999747379f);
    var _S198 : f32 = dot(half_0, group_2.tangent_9);
    var _S199 : f32 = _S196 * (_S198 - _S197);
    var _S200 : f32 = _S196 * (_S198 + _S197);
    var _S201 : f32 = _S199 * _S200;
    var _S202 : f32 = 2.0f * _S197 * _S196;
    return 0.15915493667125702f / group_2.roughness_6 * ((1.0f - _S201) / ((_S199 * _S199 + 1.0f) * (_S200 * _S200 + 1.0f)) + arc_tangent_0(_S202, 1.0f + _S201) / _S202);
}

fn layer_value_0( group_3 : Group_0,  half_1 : vec3<f32>,  light_6 : vec3<f32>,  view_5 : vec3<f32>,  optical_depth_3 : f32) -> f32
{
    var _S203 : bool = (light_6.z) < 0.0f;
    var _S204 : f32 = dot(light_6, group_3.normal_9);
    var _S205 : f32 = max(dot(view_5, group_3.normal_9), 0.01999999955296516f);
    var _S206 : f32 = mean_area_0(group_3, light_6) / max(select(_S204, - _S204, _S203), 0.01999999955296516f);
    var _S207 : f32 = mean_area_0(group_3, view_5) / _S205;
    var _S208 : f32 = optical_depth_3 * max(select(_S206 + _S207, abs(_S206 - _S207), _S203), 0.00100000004749745f);
    return 0.25f * mean_density_0(group_3, half_1) * select(1.0f - 0.34999999403953552f * (1.0f - square_0(group_3.normal_9)), 1.0f, _S203) * (optical_depth_3 * select(1.0f, exponential_0(- optical_depth_3 * min(_S206, _S207)), _S203) * (1.0f - exponential_0(- _S208)) / _S208 / _S205);
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
    var _S209 : Cell_0 = locate_0(family_10, position_6);
    var _S210 : f32 = table_number_0(families_0[family_10].before_0 + u32(2) * _S209.thread_2 + u32(1));
    var bound_0 : Bound_0;
    bound_0.thread_12 = _S209.thread_2;
    bound_0.turns_2 = round((position_6 - families_0[family_10].start_0 - _S210 - _S209.below_0) * families_0[family_10].inverse_period_0);
    bound_0.cell_9 = _S209.below_0;
    var _S211 : f32 = 2.0f * _S209.half_width_1;
    bound_0.width_3 = _S211;
    bound_0.visible_0 = clamp((_S209.across_2 + _S209.half_width_1) / _S211, 0.0f, 1.0f);
    bound_0.gap_0 = min(_S209.below_0, _S209.below_0 - _S209.across_2 - _S209.half_width_1) + max(_S209.across_2 - _S209.half_width_1, 0.0f);
    return bound_0;
}

struct Stretch_0
{
     low_1 : Bound_0,
     high_1 : Bound_0,
};

fn stretch_of_0( family_11 : u32,  centre_1 : f32,  size_2 : f32) -> Stretch_0
{
    var _S212 : f32 = centre_1 - floor((centre_1 - families_0[family_11].start_0) * families_0[family_11].inverse_period_0) * families_0[family_11].period_0;
    var _S213 : f32 = 0.5f * max(size_2, families_0[family_11].smallest_box_0);
    var stretch_0 : Stretch_0;
    stretch_0.low_1 = bound_at_0(family_11, _S212 - _S213);
    stretch_0.high_1 = bound_at_0(family_11, _S212 + _S213);
    return stretch_0;
}

fn Stretch_turns_0( this_6 : Stretch_0) -> f32
{
    return this_6.high_1.turns_2 - this_6.low_1.turns_2;
}

fn lengths_0( family_12 : u32,  stretch_1 : Stretch_0) -> vec3<f32>
{
    var _S214 : f32 = Stretch_turns_0(stretch_1);
    var _S215 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.low_1.thread_12;
    var _S216 : u32 = families_0[family_12].before_0 + u32(2) * stretch_1.high_1.thread_12;
    var _S217 : f32 = table_number_0(_S216) - table_number_0(_S215);
    var _S218 : f32 = table_number_0(_S216 + u32(1)) - table_number_0(_S215 + u32(1));
    return vec3<f32>(_S217 + stretch_1.high_1.visible_0 * stretch_1.high_1.width_3 - stretch_1.low_1.visible_0 * stretch_1.low_1.width_3 + _S214 * families_0[family_12].visible_total_0, _S218 - _S217 + stretch_1.high_1.gap_0 - stretch_1.low_1.gap_0 + _S214 * (families_0[family_12].period_0 - families_0[family_12].visible_total_0), _S218 + stretch_1.high_1.cell_9 - stretch_1.low_1.cell_9 + _S214 * families_0[family_12].period_0);
}

fn integrals_along_0( family_13 : u32,  stretch_2 : Stretch_0,  quantity_0 : u32) -> vec2<f32>
{
    var _S219 : u32 = u32(3) * families_0[family_13].quantities_0;
    var _S220 : u32 = families_0[family_13].colour_threads_0 + _S219 * stretch_2.low_1.thread_12 + quantity_0;
    var _S221 : u32 = families_0[family_13].colour_threads_0 + _S219 * stretch_2.high_1.thread_12 + quantity_0;
    var _S222 : u32 = families_0[family_13].colour_threads_0 + _S219 * u32(families_0[family_13].count_0) + quantity_0;
    var _S223 : f32 = table_number_0(_S220);
    var _S224 : f32 = table_number_0(_S221);
    var _S225 : f32 = Stretch_turns_0(stretch_2);
    var _S226 : u32 = u32(2) * families_0[family_13].quantities_0;
    return vec2<f32>(table_number_0(_S221 + families_0[family_13].quantities_0) - table_number_0(_S220 + families_0[family_13].quantities_0) + _S224 * stretch_2.high_1.visible_0 * stretch_2.high_1.width_3 - _S223 * stretch_2.low_1.visible_0 * stretch_2.low_1.width_3 + _S225 * table_number_0(_S222 + families_0[family_13].quantities_0), table_number_0(_S221 + _S226) - table_number_0(_S220 + _S226) + _S224 * stretch_2.high_1.cell_9 - _S223 * stretch_2.low_1.cell_9 + _S225 * table_number_0(_S222 + _S226));
}

fn Stretch_wraps_0( this_7 : Stretch_0) -> bool
{
    return (this_7.high_1.thread_12) < (this_7.low_1.thread_12);
}

fn Stretch_differences_0( this_8 : Stretch_0,  entries_0 : vec4<u32>,  whole_0 : u32) -> vec4<u32>
{
    var _S227 : u32 = entries_0.z;
    var _S228 : u32 = entries_0.x;
    return vec4<u32>(_S227 - _S228 + select(u32(0), whole_0, Stretch_wraps_0(this_8)), entries_0.w - _S227, entries_0.y - _S228, whole_0);
}

fn row_differences_0( across_5 : Stretch_0,  row_2 : u32,  count_3 : u32,  quantities_1 : u32) -> vec4<u32>
{
    var _S229 : u32 = row_2 + across_5.low_1.thread_12 * quantities_1;
    var _S230 : u32 = row_2 + across_5.high_1.thread_12 * quantities_1;
    return Stretch_differences_0(across_5, vec4<u32>(words_0[_S229], words_0[_S229 + quantities_1], words_0[_S230], words_0[_S230 + quantities_1]), words_0[row_2 + count_3 * quantities_1]);
}

fn Stretch_weights_0( this_9 : Stretch_0) -> vec4<f32>
{
    return vec4<f32>(1.0f, this_9.high_1.visible_0, - this_9.low_1.visible_0, Stretch_turns_0(this_9) - select(0.0f, 1.0f, Stretch_wraps_0(this_9)));
}

fn integral_on_top_0( family_14 : u32,  across_6 : Stretch_0,  along_1 : Stretch_0,  crossing_count_0 : u32,  quantity_1 : u32) -> f32
{
    var _S231 : u32 = u32(families_0[family_14].count_0);
    var _S232 : u32 = (_S231 + u32(1)) * families_0[family_14].quantities_0;
    var _S233 : u32 = families_0[family_14].colour_areas_0 + quantity_1;
    var _S234 : vec4<u32> = row_differences_0(across_6, _S233 + along_1.low_1.thread_12 * _S232, _S231, families_0[family_14].quantities_0);
    var _S235 : vec4<u32> = row_differences_0(across_6, _S233 + along_1.high_1.thread_12 * _S232, _S231, families_0[family_14].quantities_0);
    var _S236 : vec4<u32> = row_differences_0(across_6, _S233 + crossing_count_0 * _S232, _S231, families_0[family_14].quantities_0);
    var _S237 : vec4<f32> = Stretch_weights_0(across_6);
    return dot(vec4<f32>(dot(vec4<f32>(vec4<i32>(_S235 - _S234 + select_vector_2(Stretch_wraps_0(along_1), _S236, vec4<u32>(vec4<i32>(i32(0)))))), _S237), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S233 + (along_1.high_1.thread_12 + u32(1)) * _S232, _S231, families_0[family_14].quantities_0) - _S235)), _S237), dot(vec4<f32>(vec4<i32>(row_differences_0(across_6, _S233 + (along_1.low_1.thread_12 + u32(1)) * _S232, _S231, families_0[family_14].quantities_0) - _S234)), _S237), dot(vec4<f32>(vec4<i32>(_S236)), _S237)), Stretch_weights_0(along_1)) * families_0[family_14].area_unit_0;
}

fn with_added_albedos_0( albedos_1 : Albedos_0,  weight_3 : f32,  row_3 : u32) -> Albedos_0
{
    var _S238 : Albedos_0 = table_albedos_0(row_3);
    var sum_0 : Albedos_0;
    var _S239 : vec3<f32> = vec3<f32>(weight_3);
    sum_0.diffuse_reflect_0 = albedos_1.diffuse_reflect_0 + _S239 * _S238.diffuse_reflect_0;
    sum_0.diffuse_transmit_0 = albedos_1.diffuse_transmit_0 + _S239 * _S238.diffuse_transmit_0;
    sum_0.specular_reflect_0 = albedos_1.specular_reflect_0 + _S239 * _S238.specular_reflect_0;
    sum_0.specular_transmit_0 = albedos_1.specular_transmit_0 + _S239 * _S238.specular_transmit_0;
    return sum_0;
}

fn mean_albedos_0( family_15 : u32,  crossing_1 : u32,  own_1 : Stretch_0,  other_2 : Stretch_0,  back_5 : bool) -> Albedos_0
{
    var albedos_2 : Albedos_0 = table_albedos_0(families_0[family_15].colour_mean_0);
    if((families_0[family_15].quantities_0) == u32(1))
    {
        return albedos_2;
    }
    var _S240 : vec3<f32> = lengths_0(crossing_1, other_2);
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
        var _S241 : vec2<f32> = integrals_along_0(family_15, own_1, quantity_2);
        var _S242 : f32 = integral_on_top_0(family_15, own_1, other_2, u32(families_0[crossing_1].count_0), quantity_2);
        var _S243 : f32 = _S241.x;
        var _S244 : f32 = _S243 * _S240.x;
        var _S245 : f32 = select(_S242, _S244 - _S242, back_5);
        var _S246 : bool = quantity_2 == u32(0);
        if(_S246)
        {
            is_exposed_0 = _S245 > (16.0f * families_0[family_15].area_unit_0 * min(_S244 / families_0[family_15].crossing_area_0, 1.0f) + 0.00000999999974738f * _S244);
        }
        var _S247 : f32 = _S243 * _S240.y + select(0.0f, _S245, is_exposed_0) + 0.000244140625f * _S240.z * _S241.y;
        if(_S246)
        {
            weight_4 = 1.0f / max(_S247, 9.99999968265522539e-21f);
        }
        else
        {
            albedos_2 = with_added_albedos_0(albedos_2, _S247 * weight_4, families_0[family_15].colour_axes_0 + u32(12) * (quantity_2 - u32(1)));
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
    var _S248 : vec3<f32> = vec3<f32>(weight_5);
    albedos_3.diffuse_reflect_0 = mix(first_5.diffuse_reflect_0, second_1.diffuse_reflect_0, _S248);
    albedos_3.diffuse_transmit_0 = mix(first_5.diffuse_transmit_0, second_1.diffuse_transmit_0, _S248);
    albedos_3.specular_reflect_0 = mix(first_5.specular_reflect_0, second_1.specular_reflect_0, _S248);
    albedos_3.specular_transmit_0 = mix(first_5.specular_transmit_0, second_1.specular_transmit_0, _S248);
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
    var _S249 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S250 : vec3<f32> = sends_0.sky_warp_0 + _S249 * sends_0.crossing_warp_0;
    found_0.warp_3 = _S250;
    var _S251 : vec3<f32> = sends_0.sky_weft_0 + _S249 * sends_0.crossing_weft_0;
    found_0.weft_3 = _S251;
    found_0.mean_1 = vec3<f32>(sends_0.blocks_warp_0) * _S250 + vec3<f32>(sends_0.blocks_weft_0) * _S251;
    found_0.leaked_0 = from_other_0;
    return found_0;
}

fn view_terms_0( view_6 : vec3<f32>,  terms_0 : ptr<function, array<f32, i32(6)>>)
{
    var _S252 : f32 = 1.0f - view_6.z;
    var _S253 : f32 = _S252 * _S252;
    (*terms_0)[i32(0)] = 1.0f;
    var _S254 : f32 = view_6.x;
    var _S255 : f32 = _S254 * _S254;
    var _S256 : f32 = view_6.y;
    var _S257 : f32 = _S256 * _S256;
    (*terms_0)[i32(1)] = sqrt(max(_S255 + _S257, 9.999999960041972e-13f));
    (*terms_0)[i32(2)] = _S253;
    (*terms_0)[i32(3)] = _S253 * _S253;
    (*terms_0)[i32(4)] = _S255 - _S257;
    (*terms_0)[i32(5)] = 0.0f;
    return;
}

fn view_terms_1( view_7 : vec3<f32>,  terms_1 : ptr<function, array<f32, i32(6)>>)
{
    var _S258 : f32 = 1.0f - view_7.z;
    var _S259 : f32 = _S258 * _S258;
    (*terms_1)[i32(0)] = 1.0f;
    var _S260 : f32 = view_7.x;
    var _S261 : f32 = _S260 * _S260;
    var _S262 : f32 = view_7.y;
    var _S263 : f32 = _S262 * _S262;
    (*terms_1)[i32(1)] = sqrt(max(_S261 + _S263, 9.999999960041972e-13f));
    (*terms_1)[i32(2)] = _S259;
    (*terms_1)[i32(3)] = _S259 * _S259;
    (*terms_1)[i32(4)] = _S261 - _S263;
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
    var _S264 : vec3<f32> = vec3<f32>((blocked_1.by_warp_0 + blocked_1.by_weft_0)) * interior_0.leaked_1;
    var _S265 : vec3<f32> = vec3<f32>(blocked_1.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_6 * (vec3<f32>(blocked_1.by_warp_0) * interior_0.warp_4 + vec3<f32>(blocked_1.by_weft_0) * interior_0.weft_4) + _S265 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S265 * interior_0.far_1 + yarn_2.back_6 * _S264;
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
    var _S266 : f32 = light_7.z;
    return select_vector_1((_S266 * view_8.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S266) * 0.31830987334251404f));
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
    var _S267 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S268 : f32 = 2.0f * sqrt(_S267) - 1.0f;
    var _S269 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_8, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S268, _S269), 0.00999999977648258f, 1.0f), clamp((1.0f - _S267) * sheen_shear_0(_S268, _S269), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S268, _S269), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_8 : vec3<f32>,  view_9 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S270 : f32 = light_8.z;
    if(((_S270 <= 0.0f) | (((view_9.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S271 : vec2<f32> = view_9.xy;
    var _S272 : f32 = dot(_S271, _S271);
    var _S273 : vec2<f32> = select_vector_0(_S272 > 9.99999968265522539e-21f, _S271 * vec2<f32>(rsqrt_0(max(_S272, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S274 : f32 = scale_0 * dot(light_8.xy, _S273) + shear_0 * _S270;
    var _S275 : f32 = scale_0 * (light_8.y * _S273.x - light_8.x * _S273.y);
    var _S276 : f32 = _S274 * _S274 + _S275 * _S275 + _S270 * _S270;
    return 0.31830987334251404f * scale_0 * scale_0 * _S270 / max(_S276 * _S276, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_9 : vec3<f32>,  view_10 : vec3<f32>,  strength_0 : f32,  roughness_9 : f32) -> vec2<f32>
{
    var _S277 : vec3<f32> = sheen_lobe_0(view_10.z, roughness_9);
    var _S278 : f32 = strength_0 * _S277.z;
    return vec2<f32>(_S278 * transformed_cosine_0(light_9, view_10, _S277.x, _S277.y), 1.0f - _S278);
}

fn accumulate_0( index_7 : u32,  light_10 : vec4<f32>)
{
    var _S279 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_10;
    layers_0[index_7].share_0 = _S279 * (1.0f - light_10.w);
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

fn face_point_0( _S280 : u32,  _S281 : u32,  _S282 : f32,  _S283 : f32) -> VisiblePoint_0
{
    var _S284 : u32 = u32(3) * _S281;
    var _S285 : Vertex_0 = vertex_at_0(_S284);
    var _S286 : Vertex_0 = vertex_at_0(_S284 + u32(1));
    var _S287 : Vertex_0 = vertex_at_0(_S284 + u32(2));
    var _S288 : vec3<f32> = position_of_0(_S285);
    var _S289 : vec3<f32> = position_of_0(_S286) - _S288;
    var _S290 : vec3<f32> = position_of_0(_S287) - _S288;
    var _S291 : f32 = _S286.u_0 - _S285.u_0;
    var _S292 : f32 = _S286.v_0 - _S285.v_0;
    var _S293 : vec2<f32> = vec2<f32>(_S291, _S292);
    var _S294 : f32 = _S287.u_0 - _S285.u_0;
    var _S295 : f32 = _S287.v_0 - _S285.v_0;
    var _S296 : vec2<f32> = vec2<f32>(_S294, _S295);
    var _S297 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S291 * _S295 - _S292 * _S294) < 0.0f));
    var _S298 : vec3<f32> = _S297 * (vec3<f32>(_S295) * _S289 - vec3<f32>(_S292) * _S290);
    var _S299 : vec3<f32> = _S297 * (vec3<f32>(_S291) * _S290 - vec3<f32>(_S294) * _S289);
    var point_2 : VisiblePoint_0;
    var _S300 : vec3<f32> = vec3<f32>(_S282);
    var _S301 : vec3<f32> = vec3<f32>(_S283);
    var _S302 : vec3<f32> = normalize(vec3<f32>((1.0f - _S282 - _S283)) * normal_of_0(_S285) + _S300 * normal_of_0(_S286) + _S301 * normal_of_0(_S287));
    point_2.normal_0 = _S302;
    var _S303 : vec3<f32> = normalize(_S298 - _S302 * vec3<f32>(dot(_S302, _S298)));
    point_2.axis_x_0 = _S303;
    point_2.axis_y_0 = cross(_S302, _S303);
    var _S304 : vec3<f32> = normalize(cross(_S289, _S290));
    point_2.face_normal_0 = select_vector_1((dot(_S304, _S302)) < 0.0f, (vec3<f32>(0) - _S304), _S304);
    point_2.position_0 = _S288 + _S300 * _S289 + _S301 * _S290;
    point_2.view_0 = _S302;
    var _S305 : vec2<f32> = vec2<f32>(_S285.u_0, _S285.v_0) + vec2<f32>(_S282) * _S293 + vec2<f32>(_S283) * _S296;
    point_2.uv_1 = _S305;
    var _S306 : bool = (dot(cross(_S298, _S299), _S302)) < 0.0f;
    var _S307 : vec2<f32> = vec2<f32>(fabrics_0[_S280].uv_width_0, select(fabrics_0[_S280].uv_height_0, - fabrics_0[_S280].uv_height_0, _S306));
    point_2.draft_per_uv_0 = _S307;
    point_2.draft_0 = _S305 * _S307 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S280].uv_height_0, _S306));
    var _S308 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S308;
    point_2.draft_dy_0 = _S308;
    return point_2;
}

fn visible_point_0( _S309 : u32,  _S310 : u32,  _S311 : vec2<u32>) -> VisiblePoint_0
{
    var _S312 : u32 = u32(3) * _S310;
    var _S313 : Vertex_0 = vertex_at_0(_S312);
    var _S314 : Vertex_0 = vertex_at_0(_S312 + u32(1));
    var _S315 : Vertex_0 = vertex_at_0(_S312 + u32(2));
    var _S316 : vec3<f32> = position_of_0(_S313);
    var _S317 : vec3<f32> = position_of_0(_S314) - _S316;
    var _S318 : vec3<f32> = position_of_0(_S315) - _S316;
    var _S319 : vec3<f32> = cross(_S317, _S318);
    var _S320 : f32 = f32(frame_record_0.width_0);
    var _S321 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S320));
    var _S322 : f32 = f32(frame_record_0.height_0);
    var _S323 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S322));
    var _S324 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S311.x) + 0.5f - 0.5f * _S320)) * _S321 + vec3<f32>((f32(_S311.y) + 0.5f - 0.5f * _S322)) * _S323;
    var _S325 : f32 = dot(_S324, _S319);
    var _S326 : f32 = 1.0f / select(1.00000000317107685e-30f, _S325, (abs(_S325)) > 1.00000000317107685e-30f);
    var _S327 : vec3<f32> = _S316 - camera_origin_0();
    var _S328 : vec3<f32> = vec3<f32>((dot(_S327, _S319) * _S326));
    var _S329 : vec3<f32> = _S324 * _S328 - _S327;
    var _S330 : vec3<f32> = _S328 * (_S321 - _S324 * vec3<f32>((dot(_S321, _S319) * _S326)));
    var _S331 : vec3<f32> = _S328 * (_S323 - _S324 * vec3<f32>((dot(_S323, _S319) * _S326)));
    var _S332 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S319), 1.00000000317107685e-30f)));
    var _S333 : vec3<f32> = cross(_S318, _S319) * _S332;
    var _S334 : vec3<f32> = cross(_S319, _S317) * _S332;
    var _S335 : vec2<f32> = vec2<f32>(_S314.u_0 - _S313.u_0, _S314.v_0 - _S313.v_0);
    var _S336 : vec2<f32> = vec2<f32>(_S315.u_0 - _S313.u_0, _S315.v_0 - _S313.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S309, _S310, dot(_S329, _S333), dot(_S329, _S334));
    point_3.position_0 = _S316 + _S329;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S324));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S330, _S333)) * _S335 + vec2<f32>(dot(_S330, _S334)) * _S336) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S331, _S333)) * _S335 + vec2<f32>(dot(_S331, _S334)) * _S336) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S337 : u32,  _S338 : VisiblePoint_0) -> vec3<f32>
{
    var _S339 : u32 = fabrics_0[_S337].albedo_map_levels_0;
    if((fabrics_0[_S337].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S340 : vec2<f32> = vec2<f32>(fabrics_0[_S337].uv_width_0, fabrics_0[_S337].uv_height_0);
    var _S341 : vec2<f32> = _S338.draft_dx_0 / _S340;
    var _S342 : vec2<f32> = _S338.draft_dy_0 / _S340;
    var _S343 : u32 = _S339 - u32(1);
    var _S344 : u32 = (u32(1) << (_S343));
    var _S345 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S341.x * _S342.y - _S341.y * _S342.x), 9.99999968265522539e-21f) * (square_1(f32(_S344)) / 3.0f)), 0.0f, f32(_S339) - 1.0f);
    var _S346 : u32 = min(u32(_S345), max(_S339, u32(2)) - u32(2));
    var _S347 : u32 = min(_S346 + u32(1), _S343);
    var _S348 : u32 = (u32(1) << ((u32(2) * _S339)));
    return mix(map_level_0(fabrics_0[_S337].albedo_map_0 + (_S348 - ((_S348 >> ((u32(2) * _S346))))) / u32(3), (_S344 >> (_S346)), _S338.uv_1), map_level_0(fabrics_0[_S337].albedo_map_0 + (_S348 - ((_S348 >> ((u32(2) * _S347))))) / u32(3), (_S344 >> (_S347)), _S338.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S345 - f32(_S346))) - 1.0f) / 3.0f)));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S349 : u32,  _S350 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S349 * frame_record_0.height_0 + _S350.y) * frame_record_0.width_0 + _S350.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_1 : f32,
};

fn environment_texel_0( _S351 : u32,  _S352 : u32) -> vec3<f32>
{
    var _S353 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S351 * frame_record_0.environment_columns_0 + _S352);
    return vec3<f32>(scene_number_0(_S353), scene_number_0(_S353 + u32(1)), scene_number_0(_S353 + u32(2)));
}

fn sample_environment_0( _S354 : vec2<f32>,  _S355 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S356 : u32 = frame_record_0.environment_rows_0;
    var _S357 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S354.y);
    var _S358 : u32 = frame_record_0.environment_columns_0;
    var _S359 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S357.index_3 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S354.x);
    var _S360 : vec3<f32> = environment_texel_0(_S357.index_3, _S359.index_3);
    (*_S355) = _S360 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_0(_S360), 9.99999968265522539e-21f)));
    var _S361 : f32 = 3.14159274101257324f / f32(_S356);
    var _S362 : f32 = mix(sine_cosine_0(f32(_S357.index_3) * _S361).y, sine_cosine_0(f32(_S357.index_3 + u32(1)) * _S361).y, _S357.remainder_0);
    var _S363 : f32 = sqrt(max(1.0f - _S362 * _S362, 0.0f));
    var _S364 : vec2<f32> = sine_cosine_0((f32(_S359.index_3) + _S359.remainder_0) * (6.28318548202514648f / f32(_S358)));
    var _S365 : f32 = _S363 * _S364.x;
    var _S366 : f32 = - _S363 * _S364.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S365 + frame_record_0.environment_sine_0 * _S366, _S362, frame_record_0.environment_cosine_0 * _S366 - frame_record_0.environment_sine_0 * _S365);
}

fn light_sample_0( _S367 : u32,  _S368 : vec2<u32>,  _S369 : vec3<f32>) -> LightSample_0
{
    var sample_0 : LightSample_0;
    sample_0.distance_1 = 1.00000001504746622e+30f;
    var _S370 : u32 = frame_record_0.lights_0;
    if(_S367 >= (frame_record_0.lights_0))
    {
        var weight_6 : vec3<f32>;
        var _S371 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S368, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S367 - _S370), u32(3)), &(weight_6));
        sample_0.towards_0 = _S371;
        sample_0.irradiance_1 = weight_6 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_0;
    }
    var _S372 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S367);
    sample_0.irradiance_1 = vec3<f32>(_S372.red_0, _S372.green_0, _S372.blue_0);
    sample_0.towards_0 = vec3<f32>(_S372.x_7, _S372.y_1, _S372.z_1);
    if((_S372.is_point_0) != u32(0))
    {
        var _S373 : vec3<f32> = sample_0.towards_0 - _S369;
        var _S374 : f32 = max(square_0(_S373), 9.999999960041972e-13f);
        sample_0.distance_1 = sqrt(_S374);
        sample_0.irradiance_1 = sample_0.irradiance_1 / vec3<f32>(_S374);
        sample_0.towards_0 = normalize(_S373);
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

fn regime_of_0( _S375 : u32,  _S376 : Footprint_0,  _S377 : f32) -> Regime_0
{
    var _S378 : f32 = Footprint_spread_side_0(_S376);
    var _S379 : f32 = clamp((binary_logarithm_0(max(_S378, 9.99999971718068537e-10f)) - fabrics_0[_S375].lobes_0.unit_level_0 - -0.7369655966758728f) / 1.41503751277923584f, 0.0f, 1.0f);
    var regime_0 : Regime_0;
    var _S380 : f32 = _S379 * _S379 * (3.0f - 2.0f * _S379);
    regime_0.prefiltered_0 = _S380;
    var _S381 : f32 = _S378 * fabrics_0[_S375].lobes_0.threads_per_mm_0;
    regime_0.threads_1 = _S381;
    regime_0.points_0 = select(0.0f, clamp(_S381 * 12.0f, 1.0f, mix(max(8.0f / _S377, 1.0f), 1.0f, _S380)), _S380 < 1.0f);
    return regime_0;
}

fn varies_at_0( _S382 : u32,  _S383 : f32) -> bool
{
    return (((((fabrics_0[_S382].fibre_noise_0) > 0.0f) | (((fabrics_0[_S382].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S382].has_detail_0) != u32(0)) & ((_S383 >= 0.0f))))));
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

fn crossing_at_0( _S384 : u32,  _S385 : f32,  _S386 : f32,  _S387 : bool) -> Crossing_0
{
    var crossing_3 : Crossing_0;
    crossing_3.warp_2 = locate_0(fabrics_0[_S384].warp_0, _S385);
    crossing_3.weft_2 = locate_0(fabrics_0[_S384].weft_0, _S386);
    var _S388 : u32 = fabrics_0[_S384].run_words_0 + u32(2) * (crossing_3.weft_2.thread_2 * fabrics_0[_S384].ends_1 + crossing_3.warp_2.thread_2);
    var _S389 : u32 = words_0[_S388];
    crossing_3.warp_word_0 = _S389;
    crossing_3.weft_word_0 = words_0[_S388 + u32(1)];
    crossing_3.warp_above_0 = (((_S389 & (u32(1)))) == u32(1)) != _S387;
    return crossing_3;
}

fn sample_at_0( _S390 : u32,  _S391 : f32,  _S392 : f32,  _S393 : bool) -> Sample_0
{
    var sample_1 : Sample_0;
    var _S394 : Crossing_0 = crossing_at_0(_S390, _S391, _S392, _S393);
    sample_1.crossing_2 = _S394;
    var _S395 : Shown_0 = shown_at_0(_S394, _S393);
    sample_1.shown_3 = _S395;
    var _S396 : u32 = select(fabrics_0[_S390].weft_0, fabrics_0[_S390].warp_0, _S395.is_warp_2);
    var _S397 : u32 = select(fabrics_0[_S390].warp_0, fabrics_0[_S390].weft_0, _S395.is_warp_2);
    var _S398 : Cell_0 = select_cell_0(_S395.is_warp_2, sample_1.crossing_2.warp_2, sample_1.crossing_2.weft_2);
    var _S399 : Cell_0 = select_cell_0(_S395.is_warp_2, sample_1.crossing_2.weft_2, sample_1.crossing_2.warp_2);
    var _S400 : Run_0 = unpack_0(_S396, _S397, _S398.thread_2, _S399, _S395.word_0);
    var _S401 : Section_0 = section_at_0(_S398);
    var _S402 : bool = ((_S395.on_top_0) & (((_S400.distance_0) < (_S401.drop_0 * _S400.bend_1.sine_0))));
    var _S403 : f32 = select(-1.0f, 1.0f, ((_S395.on_top_0) & ((!_S402))));
    var _S404 : f32 = select(_S400.reach_0, _S400.other_reach_0, _S402);
    var _S405 : f32 = select(max(_S404 - _S400.distance_0, 0.0f), _S404 + _S400.distance_0, _S402);
    var _S406 : f32 = _S404 / _S400.bend_1.sine_0 - _S403 * _S401.drop_0;
    var _S407 : f32 = _S405 * _S405;
    var _S408 : f32 = max(_S406 * _S406 - _S407, 9.99999968265522539e-21f);
    var _S409 : f32 = rsqrt_0(_S408);
    var _S410 : f32 = _S407 / (_S408 * _S409 + _S406);
    var _S411 : bool = _S405 > 0.0f;
    var _S412 : f32 = select(-1.0f, 1.0f, _S395.on_top_0) * select(-1.0f, 1.0f, _S400.near_start_0);
    var _S413 : f32 = _S401.slope_0 * select(1.0f, _S406 * _S409, _S411);
    sample_1.slope_across_0 = _S413;
    var _S414 : f32 = select(0.0f, _S412 * _S405 * _S409, _S411);
    sample_1.slope_along_0 = _S414;
    var _S415 : vec3<f32> = dive_0(_S397, _S395, _S400, _S399);
    sample_1.dive_1 = _S415;
    sample_1.height_7 = select(families_0[_S396].height_scale_0 * _S403, 0.0f, _S400.straight_0) * (_S404 * _S400.bend_1.half_tangent_0 - _S410) - families_0[_S396].height_scale_0 * _S401.drop_0 - _S415.x;
    var _S416 : f32 = families_0[_S396].height_scale_0 * _S413;
    var _S417 : f32 = families_0[_S396].height_scale_0 * _S414 - _S415.y;
    sample_1.slope_x_1 = select(_S417, _S416, _S395.is_warp_2);
    sample_1.slope_y_1 = select(_S416, _S417, _S395.is_warp_2);
    sample_1.run_3 = _S400;
    sample_1.section_1 = _S401;
    return sample_1;
}

fn steps_per_length_0( _S418 : u32,  _S419 : SearchQuality_0,  _S420 : vec3<f32>) -> f32
{
    return max(max(abs(_S420.x) * fabrics_0[_S418].threads_per_x_0, abs(_S420.y) * fabrics_0[_S418].threads_per_y_0) * _S419.steps_per_thread_0, abs(_S420.z) * fabrics_0[_S418].per_relief_0 * _S419.steps_per_relief_0);
}

fn cell_maximum_0( _S421 : u32,  _S422 : Crossing_0) -> f32
{
    var _S423 : u32 = select(fabrics_0[_S421].weft_0, fabrics_0[_S421].warp_0, _S422.warp_above_0);
    return f32((select(_S422.weft_word_0, _S422.warp_word_0, _S422.warp_above_0) >> (u32(28)))) * families_0[_S423].height_scale_0 * families_0[_S423].level_0;
}

fn probe_0( _S424 : u32,  _S425 : f32,  _S426 : f32,  _S427 : bool,  _S428 : bool,  _S429 : bool) -> Probe_0
{
    var _S430 : Sample_0 = sample_at_0(_S424, _S425, _S426, _S427);
    var probe_1 : Probe_0;
    probe_1.height_4 = _S430.height_7;
    probe_1.hole_4 = _S430.shown_3.hole_3;
    probe_1.slope_x_0 = _S430.slope_x_1;
    probe_1.slope_y_0 = _S430.slope_y_1;
    probe_1.yarn_1 = select(_S430.crossing_2.weft_2.thread_2 * u32(2), _S430.crossing_2.warp_2.thread_2 * u32(2) + u32(1), _S430.shown_3.is_warp_2);
    probe_1.cell_max_0 = cell_maximum_0(_S424, _S430.crossing_2);
    probe_1.side_x_0 = select(_S430.crossing_2.warp_2.below_0, _S430.crossing_2.warp_2.above_0, _S428);
    probe_1.side_y_0 = select(_S430.crossing_2.weft_2.below_0, _S430.crossing_2.weft_2.above_0, _S429);
    probe_1.edge_x_0 = outline_distance_0(_S430.crossing_2.warp_2, _S430.shown_3, _S430.run_3, !_S430.shown_3.is_warp_2, _S428);
    probe_1.edge_y_0 = outline_distance_0(_S430.crossing_2.weft_2, _S430.shown_3, _S430.run_3, _S430.shown_3.is_warp_2, _S429);
    return probe_1;
}

fn is_free_0( _S431 : u32,  _S432 : SearchQuality_0,  _S433 : vec3<f32>,  _S434 : vec3<f32>,  _S435 : bool,  _S436 : f32) -> bool
{
    var _S437 : f32 = _S434.z;
    if(_S437 <= 0.0f)
    {
        return false;
    }
    var _S438 : f32 = 1.0f / max(_S432.shadow_share_0 * steps_per_length_0(_S431, _S432, _S434), 9.99999971718068537e-10f);
    var _S439 : StepControl_0 = step_control_0(_S434.xy, _S438);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_4 : u32 = u32(0);
    var distance_2 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_4 < u32(1024)) & (((_S433.z + _S437 * distance_2) < _S436))))
        {
        }
        else
        {
            break;
        }
        var _S440 : vec3<f32> = _S433 + _S434 * vec3<f32>(distance_2);
        var _S441 : Probe_0 = probe_0(_S431, _S440.x, _S440.y, _S435, _S439.right_0, _S439.up_0);
        var _S442 : f32 = _S440.z;
        var _S443 : f32 = _S442 - _S441.height_4;
        var _S444 : f32 = _S437 - _S441.slope_x_0 * _S434.x - _S441.slope_y_0 * _S434.y;
        if(((!_S441.hole_4) & ((_S443 < 0.0f))))
        {
            return false;
        }
        var _S445 : f32 = way_back_to_dip_0(previous_3, _S443, _S444, last_step_0, _S441);
        if(_S445 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S445;
            distance_2 = distance_2 - _S445;
            last_step_0 = last_step_1;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S446 : bool = _S442 > (_S441.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S439, _S441, _S443, _S444), max(StepControl_to_cell_exit_0(_S439, _S441.side_x_0, _S441.side_y_0), _S438), _S446);
        var distance_3 : f32 = distance_2 + last_step_2;
        previous_3 = after_sample_0(_S443, _S444, _S441, _S446);
        distance_2 = distance_3;
        last_step_0 = last_step_2;
        count_4 = count_4 + u32(1);
    }
    return true;
}

fn passes_through_0( _S447 : u32,  _S448 : SearchQuality_0,  _S449 : f32,  _S450 : f32,  _S451 : vec3<f32>,  _S452 : bool) -> bool
{
    if(!sample_at_0(_S447, _S449, _S450, _S452).shown_3.hole_3)
    {
        return false;
    }
    var _S453 : vec3<f32> = vec3<f32>(_S449, _S450, 0.0f);
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
        var _S454 : bool = is_free_0(_S447, _S448, _S453, select_vector_1(side_1 == u32(0), _S451, vec3<f32>(- _S451.x, - _S451.y, _S451.z)), _S452 != (side_1 == u32(1)), fabrics_0[_S447].height_high_0);
        var _S455 : u32 = side_1 + u32(1);
        passes_0 = _S454;
        side_1 = _S455;
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

fn max_height_along_0( _S456 : u32,  _S457 : f32,  _S458 : f32,  _S459 : f32,  _S460 : vec3<f32>,  _S461 : bool) -> f32
{
    var _S462 : f32 = _S460.x;
    var _S463 : f32 = _S460.y;
    var _S464 : u32 = (words_0[fabrics_0[_S456].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S456].weft_0, _S458).thread_2 / u32(2) * fabrics_0[_S456].max_height_columns_0 + locate_0(fabrics_0[_S456].warp_0, _S457).thread_2 / u32(2)) + (select(u32(0), u32(1), _S462 > 0.0f) + select(u32(0), u32(2), _S463 > 0.0f))] >> (u32(select(i32(0), i32(4), _S461))));
    var _S465 : f32 = max(abs(_S462) * fabrics_0[_S456].threads_per_x_0, abs(_S463) * fabrics_0[_S456].threads_per_y_0) / _S460.z;
    var _S466 : f32 = fabrics_0[_S456].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S456].height_high_0;
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
        if(((max_height_0 - _S459) * _S465) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S464 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S466);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S467 : u32,  _S468 : f32,  _S469 : f32,  _S470 : bool,  _S471 : bool,  _S472 : bool) -> vec3<f32>
{
    var _S473 : Crossing_0 = crossing_at_0(_S467, _S468, _S469, _S470);
    return vec3<f32>(cell_maximum_0(_S467, _S473), select(_S473.warp_2.below_0, _S473.warp_2.above_0, _S471), select(_S473.weft_2.below_0, _S473.weft_2.above_0, _S472));
}

fn first_sample_height_0( _S474 : u32,  _S475 : ViewRay_0,  _S476 : StepControl_0,  _S477 : bool) -> f32
{
    var _S478 : f32 = max_height_along_0(_S474, _S475.origin_0.x, _S475.origin_0.y, 0.0f, vec3<f32>(_S475.slope_1, 1.0f), _S477);
    var count_5 : u32 = u32(0);
    var height_9 : f32 = _S478;
    for(;;)
    {
        if(count_5 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S479 : vec2<f32> = ViewRay_at_0(_S475, height_9);
        var _S480 : vec3<f32> = cell_bounds_0(_S474, _S479.x, _S479.y, _S477, _S476.right_0, _S476.up_0);
        var _S481 : f32 = height_9 - _S480.x;
        var _S482 : f32 = StepControl_to_cell_exit_0(_S476, _S480.y, _S480.z);
        var height_10 : f32 = height_9 - clamp(_S481, 0.0f, _S482);
        if(_S481 <= _S482)
        {
            height_9 = height_10;
            break;
        }
        count_5 = count_5 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S483 : u32,  _S484 : ViewRay_0,  _S485 : StepControl_0,  _S486 : bool) -> ViewRayEnd_0
{
    var _S487 : f32 = fabrics_0[_S483].height_low_0 - (fabrics_0[_S483].height_high_0 - fabrics_0[_S483].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S483, _S484, _S485, _S486);
    end_1.last_step_3 = _S485.epsilon_0;
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
        var _S488 : vec2<f32> = ViewRay_at_0(_S484, end_1.height_8);
        var _S489 : Probe_0 = probe_0(_S483, _S488.x, _S488.y, _S486, _S485.right_0, _S485.up_0);
        var _S490 : f32 = end_1.height_8 - _S489.height_4;
        var _S491 : f32 = ViewRay_rate_0(_S484, _S489);
        end_1.depth_1 = - _S490;
        end_1.rate_4 = _S491;
        var _S492 : bool = !_S489.hole_4;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S492))) & (((end_1.previous_4.yarn_0) == (_S489.yarn_1))));
        if((((_S492 & ((_S490 <= 0.0f)))) | (((end_1.height_8) <= _S487))))
        {
            break;
        }
        var _S493 : f32 = way_back_to_dip_0(end_1.previous_4, _S490, _S491, end_1.last_step_3, _S489);
        if(_S493 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S493;
            end_1.last_step_3 = end_1.last_step_3 - _S493;
            count_6 = count_6 + u32(1);
            continue;
        }
        var _S494 : f32 = min(StepControl_to_cell_exit_0(_S485, _S489.side_x_0, _S489.side_y_0), end_1.height_8 - _S489.cell_max_0);
        var _S495 : f32 = StepControl_to_next_sample_0(_S485, _S489, _S490, _S491);
        end_1.previous_4 = after_sample_0(_S490, _S491, _S489, _S494 > _S495);
        var _S496 : f32 = max(_S494, _S495);
        end_1.last_step_3 = _S496;
        end_1.height_8 = end_1.height_8 - _S496;
        count_6 = count_6 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S497 : u32,  _S498 : ViewRay_0,  _S499 : StepControl_0,  _S500 : bool,  _S501 : ViewRayEnd_0,  _S502 : u32) -> f32
{
    var _S503 : f32 = fabrics_0[_S497].height_high_0 - fabrics_0[_S497].height_low_0;
    var above_2 : f32 = _S501.height_8 + _S501.last_step_3;
    var above_gap_1 : f32 = clamp(_S501.previous_4.clearance_0, 0.0f, _S503);
    var under_gap_1 : f32 = clamp(_S501.depth_1, 0.0f, _S503);
    var middle_0 : f32 = select(between_0(above_2, _S501.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S501.previous_4.rate_0 * _S501.last_step_3, _S501.rate_4 * _S501.last_step_3) * _S501.last_step_3, _S501.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S501.height_8;
    var above_3 : f32 = above_2;
    var i_2 : u32 = u32(0);
    for(;;)
    {
        if(i_2 < _S502)
        {
        }
        else
        {
            break;
        }
        var _S504 : vec2<f32> = ViewRay_at_0(_S498, middle_0);
        var _S505 : Probe_0 = probe_0(_S497, _S504.x, _S504.y, _S500, _S499.right_0, _S499.up_0);
        var _S506 : f32 = clamp(middle_0 - select(_S505.height_4, -1.0e+09f, _S505.hole_4), - _S503, _S503);
        if(_S506 <= 0.0f)
        {
            var _S507 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S508 : f32 = - _S506;
            under_1 = middle_0;
            above_gap_2 = _S507;
            under_gap_2 = _S508;
            side_2 = 1.0f;
        }
        else
        {
            var _S509 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S506;
            under_gap_2 = _S509;
            side_2 = -1.0f;
        }
        var _S510 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S506 / min(ViewRay_rate_0(_S498, _S505), -9.99999997475242708e-07f), under_1, above_3), _S501.smooth_0);
        var _S511 : u32 = i_2 + u32(1);
        middle_0 = _S510;
        i_2 = _S511;
    }
    return select(under_1, middle_0, _S501.smooth_0);
}

fn first_hit_of_yarn_0( _S512 : u32,  _S513 : SearchQuality_0,  _S514 : f32,  _S515 : f32,  _S516 : vec3<f32>,  _S517 : bool) -> Hit_0
{
    var _S518 : f32 = max(_S516.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S514, _S515);
    var _S519 : vec2<f32> = _S516.xy / vec2<f32>(_S518);
    ray_0.slope_1 = _S519;
    var _S520 : StepControl_0 = step_control_0((vec2<f32>(0) - _S519), 1.0f / max(steps_per_length_0(_S512, _S513, _S516) / _S518, 9.99999971718068537e-10f));
    var _S521 : ViewRayEnd_0 = search_down_0(_S512, ray_0, _S520, _S517);
    var hit_0 : Hit_0;
    hit_0.hole_5 = false;
    var _S522 : f32 = refined_height_0(_S512, ray_0, _S520, _S517, _S521, _S513.refinements_0);
    hit_0.height_6 = _S522;
    var _S523 : vec2<f32> = ViewRay_at_0(ray_0, _S522);
    hit_0.x_16 = _S523.x;
    hit_0.y_9 = _S523.y;
    return hit_0;
}

fn first_hit_0( _S524 : u32,  _S525 : SearchQuality_0,  _S526 : f32,  _S527 : f32,  _S528 : vec3<f32>,  _S529 : bool) -> Hit_0
{
    if(!passes_through_0(_S524, _S525, _S526, _S527, _S528, _S529))
    {
        return first_hit_of_yarn_0(_S524, _S525, _S526, _S527, _S528, _S529);
    }
    var hit_1 : Hit_0;
    hit_1.x_16 = _S526;
    hit_1.y_9 = _S527;
    hit_1.height_6 = 0.0f;
    hit_1.hole_5 = true;
    return hit_1;
}

fn surface_of_0( _S530 : u32,  _S531 : Sample_0,  _S532 : f32,  _S533 : f32,  _S534 : bool) -> SurfacePoint_0
{
    var _S535 : u32 = select(fabrics_0[_S530].weft_0, fabrics_0[_S530].warp_0, _S531.shown_3.is_warp_2);
    var _S536 : f32 = families_0[_S535].twist_sine_0 * select(1.0f, -1.0f, _S534);
    var _S537 : f32 = select(-1.0f, 1.0f, _S531.shown_3.is_warp_2);
    var _S538 : vec2<f32> = fibre_direction_0(_S531.slope_across_0, _S537 * _S531.slope_along_0, _S536, families_0[_S535].twist_cosine_0);
    var _S539 : f32 = _S538.x;
    var _S540 : f32 = _S538.y;
    var _S541 : f32 = select(_S531.slope_y_1, _S531.slope_x_1, _S531.shown_3.is_warp_2) * _S539 + _S537 * select(_S531.slope_x_1, _S531.slope_y_1, _S531.shown_3.is_warp_2) * _S540;
    var _S542 : f32 = select(_S531.crossing_2.weft_2.half_width_1, _S531.crossing_2.warp_2.half_width_1, _S531.shown_3.is_warp_2) * 1.0154266357421875f;
    var _S543 : f32 = _S542 * arc_sine_0(clamp(_S531.section_1.across_3 / _S542, -1.0f, 1.0f));
    var _S544 : f32 = select(- _S532, _S533, _S531.shown_3.is_warp_2);
    var point_4 : SurfacePoint_0;
    point_4.hole_0 = _S531.shown_3.hole_3;
    point_4.is_warp_0 = _S531.shown_3.is_warp_2;
    point_4.warp_thread_0 = _S531.crossing_2.warp_2.thread_2;
    point_4.weft_thread_0 = _S531.crossing_2.weft_2.thread_2;
    point_4.height_2 = _S531.height_7;
    point_4.normal_1 = normalize(vec3<f32>(- _S531.slope_x_1, - _S531.slope_y_1, 1.0f));
    point_4.tangent_0 = normalize(select_vector_1(_S531.shown_3.is_warp_2, vec3<f32>(_S539, _S540, _S541), vec3<f32>(- _S540, _S539, _S541)));
    point_4.across_0 = _S531.section_1.across_3;
    point_4.fibre_across_0 = _S543 * families_0[_S535].twist_cosine_0 + _S544 * _S536;
    point_4.fibre_along_0 = _S544 * families_0[_S535].twist_cosine_0 - _S543 * _S536;
    var _S545 : f32 = run_share_0(_S531.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S545, _S545, _S531.shown_3.on_top_0);
    point_4.x_8 = _S532;
    point_4.y_2 = _S533;
    return point_4;
}

fn surface_met_0( _S546 : u32,  _S547 : f32,  _S548 : f32,  _S549 : f32,  _S550 : vec3<f32>,  _S551 : bool) -> SurfacePoint_0
{
    var _S552 : Sample_0 = sample_at_0(_S546, _S547, _S548, _S551);
    var point_5 : SurfacePoint_0 = surface_of_0(_S546, _S552, _S547, _S548, _S551);
    var _S553 : u32 = select(fabrics_0[_S546].weft_0, fabrics_0[_S546].warp_0, point_5.is_warp_0);
    var _S554 : f32 = select(_S552.crossing_2.weft_2.half_width_1, _S552.crossing_2.warp_2.half_width_1, point_5.is_warp_0) * 1.0154266357421875f;
    var _S555 : f32 = _S552.dive_1.z;
    var _S556 : f32 = _S552.slope_along_0 - (1.0f - _S555) * _S552.dive_1.y / families_0[_S553].height_scale_0;
    var _S557 : f32 = rsqrt_0(_S556 * _S556 + 1.0f);
    var _S558 : f32 = _S550.x;
    var _S559 : f32 = _S550.y;
    var _S560 : f32 = select(_S559, _S558, point_5.is_warp_0);
    var _S561 : f32 = _S550.z;
    var _S562 : f32 = (_S561 / families_0[_S553].height_scale_0 - _S556 * select(_S558, _S559, point_5.is_warp_0)) * _S557;
    var _S563 : f32 = square_1(_S554);
    var _S564 : f32 = sqrt(max(_S563 - square_1(point_5.across_0), 0.0f)) - (_S552.height_7 + _S555 * _S552.dive_1.x - _S549) / families_0[_S553].height_scale_0 * _S557;
    var _S565 : f32 = square_1(_S560) + square_1(_S562) + 9.999999960041972e-13f;
    var _S566 : f32 = point_5.across_0 * _S560 + _S564 * _S562;
    var _S567 : f32 = square_1(point_5.across_0) + square_1(_S564) - _S563;
    var _S568 : f32 = sqrt(max(square_1(_S566) - _S565 * _S567, 0.0f));
    var _S569 : f32 = clamp(select((_S568 - _S566) / _S565, - _S567 / max(_S566 + _S568, 9.999999960041972e-13f), _S566 > 0.0f), - _S554, _S554);
    var _S570 : f32 = point_5.across_0 + _S569 * _S560;
    point_5.across_0 = _S570;
    var _S571 : vec2<f32> = normalize(vec2<f32>(_S570, _S564 + _S569 * _S562));
    var _S572 : f32 = select(-1.0f, 1.0f, point_5.is_warp_0);
    var _S573 : f32 = families_0[_S553].twist_sine_0 * select(1.0f, -1.0f, _S551);
    var _S574 : f32 = _S571.x;
    var _S575 : f32 = _S573 * _S574 * _S557;
    var _S576 : f32 = _S571.y;
    var _S577 : f32 = - _S573 * _S576;
    var _S578 : f32 = families_0[_S553].twist_cosine_0 * _S557 - _S572 * _S556 * _S575;
    var _S579 : f32 = families_0[_S553].height_scale_0 * (families_0[_S553].twist_cosine_0 * _S572 * _S556 * _S557 + _S575);
    var _S580 : f32 = families_0[_S553].height_scale_0 * _S574;
    var _S581 : f32 = - families_0[_S553].height_scale_0 * _S556 * _S557 * _S576;
    point_5.normal_1 = normalize(vec3<f32>(select(_S581, _S580, point_5.is_warp_0), select(_S580, _S581, point_5.is_warp_0), _S557 * _S576));
    point_5.tangent_0 = normalize(vec3<f32>(select(- _S578, _S577, point_5.is_warp_0), select(_S577, _S578, point_5.is_warp_0), _S579));
    var _S582 : f32 = _S554 * angle_of_0(_S571);
    var _S583 : f32 = select(- _S547 - _S569 * _S558, _S548 + _S569 * _S559, point_5.is_warp_0);
    point_5.fibre_across_0 = _S582 * families_0[_S553].twist_cosine_0 + _S583 * _S573;
    point_5.fibre_along_0 = _S583 * families_0[_S553].twist_cosine_0 - _S582 * _S573;
    var _S584 : f32 = 0.00999999977648258f * _S554;
    var _S585 : f32 = - _S584;
    var _S586 : bool = _S569 < _S585;
    var _S587 : f32 = select(_S584, _S585, _S560 < 0.0f);
    var _S588 : f32 = max(_S569, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S588 * _S558, select(0.0f, _S587, point_5.is_warp_0), _S586);
    point_5.y_2 = point_5.y_2 + select(_S588 * _S559, select(_S587, 0.0f, point_5.is_warp_0), _S586);
    point_5.height_2 = select(_S549 + _S569 * _S561, _S549, _S586);
    return point_5;
}

struct YarnPoint_0
{
     back_7 : bool,
     hole_6 : bool,
     is_warp_3 : bool,
     x_17 : f32,
     y_10 : f32,
     height_11 : f32,
     normal_10 : vec3<f32>,
     tangent_10 : vec3<f32>,
     surface_normal_0 : vec3<f32>,
     diffuse_gain_1 : f32,
     roughness_10 : f32,
     albedos_6 : Albedos_0,
};

fn has_hairs_0( _S589 : u32) -> bool
{
    return (((families_0[fabrics_0[_S589].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S589].weft_0].hairiness_0) > 0.0f)));
}

fn hair_at_0( _S590 : u32,  _S591 : vec2<f32>,  _S592 : bool,  _S593 : f32) -> Hair_0
{
    var _S594 : f32 = fabrics_0[_S590].fibre_size_0;
    var _S595 : f32 = 17.0f * fabrics_0[_S590].fibre_size_0;
    var _S596 : f32 = fade_0(_S593, _S595);
    var _S597 : vec2<f32> = _S591 / vec2<f32>(_S595);
    var _S598 : u32 = hash_key_0(select(u32(0), u32(1), _S592), ((fabrics_0[_S590].seed_0) ^ (u32(1013904242))));
    var _S599 : f32 = 1.0f / max(_S593, 0.07999999821186066f * fabrics_0[_S590].fibre_size_0);
    var _S600 : f32 = min(0.63999998569488525f * fabrics_0[_S590].fibre_size_0 * _S599, 1.0f);
    const _S601 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S601;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S596 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S602 : u32 = number_2 / u32(9);
        var _S603 : u32 = number_2 / u32(3) - u32(3) * _S602;
        var _S604 : vec2<f32> = floor(_S597) + vec2<f32>(f32(number_2 - u32(3) * _S603 - u32(9) * _S602), f32(_S603)) - vec2<f32>(1.0f);
        var _S605 : u32 = hash_bits_0(_S598 + _S602, u32(i32(_S604.x)) * u32(65536) + u32(i32(_S604.y)));
        var _S606 : u32 = hash_bits_0(_S598, _S605);
        var _S607 : vec2<f32> = _S597 - _S604 - vec2<f32>(share_of_0(_S605), share_of_0((_S605 >> (u32(10)))));
        var _S608 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S605 >> (u32(20)))));
        var _S609 : f32 = mix(5.0f, 16.0f, share_of_0((_S606 >> (u32(10))))) / 17.0f;
        var _S610 : f32 = _S607.x;
        var _S611 : f32 = _S608.y;
        var _S612 : f32 = _S607.y;
        var _S613 : f32 = _S608.x;
        var _S614 : f32 = (_S610 * _S611 + _S612 * _S613) / _S609;
        var _S615 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S606 >> (u32(20)))) - 1.0f);
        var _S616 : f32 = 2.0f * _S615 * _S614;
        var _S617 : f32 = rsqrt_0(_S616 * _S616 + 1.0f);
        var _S618 : f32 = (_S612 * _S611 - _S610 * _S613 - _S615 * _S609 * _S614 * _S614) * _S617 * 17.0f;
        var _S619 : f32 = clamp((0.31999999284744263f - abs(_S618)) * _S594 * _S599 + 0.5f, 0.0f, _S600);
        if((((((share_of_0(_S606)) < (families_0[select(fabrics_0[_S590].weft_0, fabrics_0[_S590].warp_0, ((((_S606 >> (u32(30)))) & (u32(1)))) == u32(1))].hairiness_0)) & (((abs(_S614)) < 1.0f)))) & ((_S619 > cover_2))))
        {
            var _S620 : vec2<f32> = vec2<f32>(- _S613 - _S616 * _S611, _S611 - _S616 * _S613) * vec2<f32>(_S617);
            cover_2 = _S619;
            hair_away_0 = _S618;
            hair_across_0 = _S620;
        }
        number_2 = number_2 + u32(1);
    }
    var _S621 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S596 * cover_2;
    hair_1.normal_3 = vec3<f32>(vec2<f32>(_S621) * hair_across_0, sqrt(1.0f - _S621 * _S621));
    hair_1.tangent_2 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn thread_number_0( _S622 : u32,  _S623 : SurfacePoint_0,  _S624 : f32,  _S625 : f32) -> u32
{
    var _S626 : u32 = select(fabrics_0[_S622].weft_0, fabrics_0[_S622].warp_0, _S623.is_warp_0);
    return u32(i32(floor((select(_S625, _S624, _S623.is_warp_0) - _S623.across_0) / families_0[_S626].period_0)) * i32(families_0[_S626].count_0) + i32(select(_S623.weft_thread_0, _S623.warp_thread_0, _S623.is_warp_0))) * u32(2) + select(u32(0), u32(1), _S623.is_warp_0);
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

fn fibre_noise_at_0( _S627 : u32,  _S628 : u32,  _S629 : SurfacePoint_0,  _S630 : u32,  _S631 : f32) -> FibreNoise_0
{
    var _S632 : f32 = 5.0f * fabrics_0[_S627].fibre_size_0;
    var _S633 : vec2<f32> = wave_noise_0(hash_key_0(_S630, ((fabrics_0[_S627].seed_0) ^ (u32(458671337)))), _S629.fibre_along_0 / (25.0f * fabrics_0[_S627].fibre_size_0));
    var _S634 : f32 = _S629.fibre_across_0 + families_0[_S628].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S627].fibre_size_0 * _S633.x;
    var _S635 : vec3<f32> = fibre_cell_0(_S634, _S629.fibre_along_0, fabrics_0[_S627].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S630, ((fabrics_0[_S627].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S634, _S629.fibre_along_0, _S632));
    noise_0.bundle_weight_0 = fade_0(_S631, _S632);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S630, ((fabrics_0[_S627].seed_0) ^ (u32(48610963)))), _S635);
    noise_0.fibre_weight_0 = fade_0(_S631, fabrics_0[_S627].fibre_size_0);
    noise_0.offset_1 = _S635.z;
    noise_0.slope_2 = 0.5f * _S633.y;
    return noise_0;
}

fn detail_gain_0( _S636 : u32,  _S637 : u32,  _S638 : SurfacePoint_0,  _S639 : vec2<f32>,  _S640 : bool,  _S641 : u32,  _S642 : f32) -> vec2<f32>
{
    var _S643 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S637].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S642, 1.0f / families_0[_S637].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S637, _S638, _S640))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S643;
    }
    if((families_0[_S637].fibre_tone_0) > 0.0f)
    {
        var _S644 : FibreNoise_0 = fibre_noise_at_0(_S636, _S637, _S638, _S641, _S642);
        gain_2 = gain_2 + vec2<f32>(families_0[_S637].fibre_tone_0) * vec2<f32>(_S644.bundle_weight_0 * _S644.bundle_0.y + _S644.fibre_weight_0 * _S644.fibre_0.y, _S644.bundle_weight_0 + _S644.fibre_weight_0);
    }
    if((families_0[_S637].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.25f * families_0[_S637].slub_0 * fade_0(_S642, 1.0f / families_0[_S637].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S641, ((fabrics_0[_S636].seed_0) ^ (u32(1373058189)))), select(- _S639.x, _S639.y, _S638.is_warp_0) * families_0[_S637].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S638.across_0 * families_0[_S637].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S645 : u32,  _S646 : Albedos_0,  _S647 : u32,  _S648 : u32,  _S649 : vec2<f32>) -> Albedos_0
{
    var _S650 : vec3<f32> = max(_S646.specular_reflect_0, _S646.specular_transmit_0);
    var _S651 : vec3<f32> = _S646.diffuse_reflect_0 + _S646.diffuse_transmit_0;
    var _S652 : vec3<f32> = vec3<f32>(fabrics_0[_S645].layer_bound_0);
    var _S653 : vec3<f32> = vec3<f32>(1.0f);
    var _S654 : vec3<f32> = _S653 - _S652 * _S650;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S647, fabrics_0[_S645].colour_noise_0, fabrics_0[_S645].seed_0), _S651, _S654);
    var _S655 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S649.y, vec3<f32>(colour_1) * _S651, _S654) * _S649.x)));
    var _S656 : f32 = bounded_gain_0(fibre_gain_0(_S647, _S648, fabrics_0[_S645].fibre_noise_0, fabrics_0[_S645].seed_0), _S650, min((_S653 - _S655 * _S651) / _S652, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S655 * _S646.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S655 * _S646.diffuse_transmit_0;
    var _S657 : vec3<f32> = vec3<f32>(_S656);
    varied_0.specular_reflect_0 = _S657 * _S646.specular_reflect_0;
    varied_0.specular_transmit_0 = _S657 * _S646.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S658 : u32,  _S659 : SurfacePoint_0,  _S660 : Albedos_0,  _S661 : f32,  _S662 : f32,  _S663 : bool,  _S664 : f32,  _S665 : f32) -> Albedos_0
{
    var _S666 : u32 = thread_number_0(_S658, _S659, _S661, _S662);
    var _S667 : vec3<f32> = fibre_cell_0(_S659.fibre_across_0, _S659.fibre_along_0, fabrics_0[_S658].fibre_size_0);
    var _S668 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S658].has_detail_0) != u32(0)) & ((_S664 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S658, select(fabrics_0[_S658].weft_0, fabrics_0[_S658].warp_0, _S659.is_warp_0), _S659, vec2<f32>(_S661, _S662), _S663, _S666, _S664) * vec2<f32>(1.0f - _S665, 1.0f);
    }
    else
    {
        gain_3 = _S668;
    }
    return vary_albedos_0(_S658, _S660, _S666, u32(i32(_S667.x)) * u32(65536) + u32(i32(floor(_S667.y))), gain_3);
}

fn turned_frame_0( _S669 : u32,  _S670 : u32,  _S671 : SurfacePoint_0,  _S672 : bool,  _S673 : u32,  _S674 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_5 = _S671.normal_1;
    frame_2.tangent_4 = _S671.tangent_0;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S670].has_plies_0) > 0.0f)
    {
        var _S675 : f32 = fade_0(_S674, 1.0f / families_0[_S670].plies_per_mm_0);
        var _S676 : f32 = _S675 * 0.41999998688697815f * ply_offset_0(_S670, _S671, _S672);
        var _S677 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S678 : vec3<f32> = vec3<f32>(families_0[_S670].ply_cosine_0);
        var _S679 : vec3<f32> = vec3<f32>(select(families_0[_S670].ply_sine_0, - families_0[_S670].ply_sine_0, _S672));
        var _S680 : vec3<f32> = _S678 * _S677 + _S679 * frame_2.tangent_4;
        var _S681 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S676 * _S676));
        var _S682 : vec3<f32> = vec3<f32>(_S676);
        frame_2.tangent_4 = _S678 * (_S678 * frame_2.tangent_4 - _S679 * _S677) + _S679 * (_S681 * _S680 - _S682 * frame_2.normal_5);
        frame_2.normal_5 = _S681 * frame_2.normal_5 + _S682 * _S680;
        frame_2.loss_0 = _S675 * _S675 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S683 : f32 = families_0[_S670].fibre_tilt_0;
    if((families_0[_S670].fibre_tilt_0) > 0.0f)
    {
        var _S684 : FibreNoise_0 = fibre_noise_at_0(_S669, _S670, _S671, _S673, _S674);
        var _S685 : f32 = 1.09858846664428711f * _S683 * (_S684.bundle_weight_0 * _S684.bundle_0.x + _S684.fibre_weight_0 * (_S684.fibre_0.x + _S684.offset_1));
        var _S686 : f32 = _S683 * (1.42099642753601074f * (_S684.bundle_weight_0 * _S684.bundle_0.y + _S684.fibre_weight_0 * _S684.fibre_0.y) - _S684.bundle_weight_0 * _S684.slope_2);
        var _S687 : f32 = square_1(_S684.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S683 * _S683 * ((0.24761904776096344f * (square_1(_S684.bundle_weight_0) + _S687) + _S687 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S688 : vec3<f32> = cross(frame_2.tangent_4, frame_2.normal_5);
        var _S689 : vec2<f32> = sine_cosine_0(_S685);
        var _S690 : vec2<f32> = sine_cosine_0(_S686);
        var _S691 : vec3<f32> = vec3<f32>(_S689.y);
        var _S692 : vec3<f32> = vec3<f32>(_S689.x);
        var _S693 : vec3<f32> = _S691 * _S688 - _S692 * frame_2.normal_5;
        frame_2.normal_5 = _S691 * frame_2.normal_5 + _S692 * _S688;
        frame_2.tangent_4 = vec3<f32>(_S690.y) * frame_2.tangent_4 + vec3<f32>(_S690.x) * _S693;
    }
    return frame_2;
}

fn yarn_point_of_0( _S694 : u32,  _S695 : SurfacePoint_0,  _S696 : bool,  _S697 : bool,  _S698 : f32) -> YarnPoint_0
{
    var _S699 : u32 = select(fabrics_0[_S694].weft_0, fabrics_0[_S694].warp_0, _S695.is_warp_0);
    var _S700 : bool = (((fabrics_0[_S694].has_detail_0) != u32(0)) & ((_S698 >= 0.0f)));
    var _S701 : vec3<f32> = vec3<f32>(0.0f);
    var _S702 : Hair_0 = Hair_x24init_0(0.0f, _S701, _S701);
    var _S703 : bool;
    if(_S700)
    {
        _S703 = has_hairs_0(_S694);
    }
    else
    {
        _S703 = false;
    }
    var hair_2 : Hair_0;
    if(_S703)
    {
        hair_2 = hair_at_0(_S694, vec2<f32>(_S695.x_8, _S695.y_2), _S696, _S698);
    }
    else
    {
        hair_2 = _S702;
    }
    var albedos_7 : Albedos_0 = albedos_of_0(_S699, select(_S695.weft_thread_0, _S695.warp_thread_0, _S695.is_warp_0));
    var albedos_8 : Albedos_0;
    if(varies_at_0(_S694, _S698))
    {
        albedos_8 = varied_at_0(_S694, _S695, albedos_7, _S695.x_8, _S695.y_2, _S696, _S698, hair_2.cover_0);
    }
    else
    {
        albedos_8 = albedos_7;
    }
    var point_6 : YarnPoint_0;
    point_6.back_7 = _S696;
    point_6.hole_6 = _S697;
    point_6.is_warp_3 = _S695.is_warp_0;
    point_6.x_17 = _S695.x_8;
    point_6.y_10 = _S695.y_2;
    point_6.height_11 = _S695.height_2;
    point_6.normal_10 = _S695.normal_1;
    point_6.tangent_10 = _S695.tangent_0;
    point_6.surface_normal_0 = _S695.normal_1;
    point_6.diffuse_gain_1 = 1.0f;
    if(_S700)
    {
        var _S704 : YarnFrame_0 = turned_frame_0(_S694, _S699, _S695, _S696, thread_number_0(_S694, _S695, _S695.x_8, _S695.y_2), _S698);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S694))
        {
            frame_3 = under_hair_0(_S704, hair_2);
        }
        else
        {
            frame_3 = _S704;
        }
        point_6.normal_10 = frame_3.normal_5;
        point_6.tangent_10 = frame_3.tangent_4;
        point_6.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S694].diffuse_blend_0);
    }
    point_6.roughness_10 = families_0[_S699].roughness_0;
    point_6.albedos_6 = albedos_8;
    return point_6;
}

fn surface_at_0( _S705 : u32,  _S706 : f32,  _S707 : f32,  _S708 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S705, sample_at_0(_S705, _S706, _S707, _S708), _S706, _S707, _S708);
}

fn unoccluded_0( _S709 : u32,  _S710 : SearchQuality_0,  _S711 : f32,  _S712 : f32,  _S713 : f32,  _S714 : vec3<f32>,  _S715 : bool) -> bool
{
    if((_S714.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S709, _S710, vec3<f32>(_S711, _S712, _S713 + fabrics_0[_S709].lift_0), _S714, _S715, max_height_along_0(_S709, _S711, _S712, _S713, _S714, _S715));
}

fn is_lit_0( _S716 : u32,  _S717 : SearchQuality_0,  _S718 : YarnPoint_0,  _S719 : vec3<f32>) -> bool
{
    if(_S718.hole_6)
    {
        return true;
    }
    var _S720 : vec3<f32> = to_face_frame_0(_S719, _S718.back_7);
    var _S721 : f32 = _S720.z;
    var _S722 : bool = _S721 < 0.0f;
    var normal_11 : vec3<f32>;
    var height_12 : f32;
    if(_S722)
    {
        var _S723 : SurfacePoint_0 = surface_at_0(_S716, _S718.x_17, _S718.y_10, !_S718.back_7);
        normal_11 = _S723.normal_1;
        height_12 = _S723.height_2;
    }
    else
    {
        normal_11 = _S718.surface_normal_0;
        height_12 = _S718.height_11;
    }
    var _S724 : vec3<f32> = vec3<f32>(_S720.xy, abs(_S721));
    if((dot(normal_11, _S724)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S716, _S717, _S718.x_17, _S718.y_10, height_12, _S724, (_S718.back_7) != _S722);
}

fn components_of_point_0( _S725 : u32,  _S726 : SearchQuality_0,  _S727 : YarnPoint_0,  _S728 : vec3<f32>,  _S729 : vec3<f32>) -> Components_0
{
    var result_3 : Components_0 = no_components_0();
    result_3.hole_2 = select(0.0f, 1.0f, _S727.hole_6);
    var _S730 : bool;
    if(_S727.hole_6)
    {
        _S730 = true;
    }
    else
    {
        _S730 = !is_lit_0(_S725, _S726, _S727, _S728);
    }
    if(_S730)
    {
        return result_3;
    }
    var _S731 : vec3<f32> = to_face_frame_0(_S728, _S727.back_7);
    var _S732 : vec3<f32> = to_face_frame_0(_S729, _S727.back_7);
    var _S733 : bool = (_S731.z) < 0.0f;
    var _S734 : f32 = _S727.diffuse_gain_1 * diffuse_reflection_0(select_vector_1(_S733, (vec3<f32>(0) - _S731), _S731), _S727.normal_10, fabrics_0[_S725].diffuse_blend_0);
    var _S735 : f32;
    if(_S733)
    {
        _S735 = transmission_1(_S731, _S732, _S727.normal_10, _S727.tangent_10, _S727.roughness_10, fabrics_0[_S725].optical_depth_0);
    }
    else
    {
        _S735 = reflection_0(_S731, _S732, _S727.normal_10, _S727.tangent_10, _S727.roughness_10, fabrics_0[_S725].optical_depth_0);
    }
    result_3.diffuse_warp_0 = select(0.0f, _S734, _S727.is_warp_3);
    result_3.diffuse_weft_0 = select(_S734, 0.0f, _S727.is_warp_3);
    result_3.specular_warp_0 = select(0.0f, _S735, _S727.is_warp_3);
    result_3.specular_weft_0 = select(_S735, 0.0f, _S727.is_warp_3);
    result_3.light_visibility_1 = 1.0f;
    return result_3;
}

fn openness_number_0( _S736 : u32,  _S737 : u32) -> f32
{
    return table_number_0(fabrics_0[_S736].openness_0 + _S737);
}

fn blocked_of_terms_0( _S738 : u32,  _S739 : u32,  _S740 : array<f32, i32(6)>,  _S741 : u32) -> Blocked_0
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
            if(term_0 < _S741)
            {
            }
            else
            {
                break;
            }
            shares_0[share_4] = shares_0[share_4] + openness_number_0(_S738, _S739 + share_4 * _S741 + term_0) * _S740[term_0];
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

fn blocked_at_0( _S742 : u32,  _S743 : bool,  _S744 : bool,  _S745 : f32,  _S746 : f32) -> Blocked_0
{
    var _S747 : f32 = _S746 * openness_number_0(_S742, u32(158));
    var terms_2 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S745, _S747, _S745 * _S745, _S745 * _S747, _S747 * _S747 );
    return blocked_of_terms_0(_S742, u32(60) + (select(u32(0), u32(2), _S744) + select(u32(1), u32(0), _S743)) * u32(18), terms_2, u32(6));
}

fn with_blocked_0( _S748 : u32,  _S749 : Blocked_0,  _S750 : YarnPoint_0,  _S751 : bool,  _S752 : f32) -> Blocked_0
{
    if(((_S750.hole_6) | (((_S750.is_warp_3) != _S751))))
    {
        return _S749;
    }
    var _S753 : Blocked_0 = blocked_at_0(_S748, _S751, _S750.back_7, _S750.surface_normal_0.z, _S750.height_11);
    var result_4 : Blocked_0;
    result_4.by_warp_0 = _S749.by_warp_0 + _S752 * _S753.by_warp_0;
    result_4.by_weft_0 = _S749.by_weft_0 + _S752 * _S753.by_weft_0;
    result_4.far_0 = _S749.far_0 + _S752 * _S753.far_0;
    return result_4;
}

struct CoverageTaps_0
{
     nodes_1 : array<u32, i32(9)>,
};

fn pyramid_level_0( _S754 : u32,  _S755 : f32) -> vec3<f32>
{
    var _S756 : u32 = fabrics_0[_S754].lobes_0.levels_0 + u32(4) * u32(min(_S755, fabrics_0[_S754].lobes_0.last_level_0));
    return vec3<f32>(table_number_0(_S756), table_number_0(_S756 + u32(1)), table_number_0(_S756 + u32(2)));
}

fn coverage_taps_0( _S757 : u32,  _S758 : Footprint_0,  _S759 : bool) -> CoverageTaps_0
{
    var _S760 : Lobes_std430_0 = fabrics_0[_S757].lobes_0;
    var _S761 : f32 = Footprint_spread_side_0(_S758) * fabrics_0[_S757].lobes_0.inverse_base_size_0;
    var _S762 : vec3<f32> = pyramid_level_0(_S757, floor(binary_logarithm_0(max(0.68000000715255737f * _S761, 1.0f))));
    var _S763 : f32 = 1.0f / max(_S761, 9.99999997475242708e-07f);
    var _S764 : vec2<f32> = vec2<f32>(families_0[fabrics_0[_S757].warp_0].inverse_period_0, families_0[fabrics_0[_S757].weft_0].inverse_period_0);
    var _S765 : vec2<f32> = _S758.centre_0 * _S764;
    var _S766 : vec2<f32> = vec2<f32>(min(max(sqrt(clamp(1.29999995231628418f * (1.0f - _S763 * _S763), 0.0f, 1.0f)), 0.3333333432674408f * _S763), 1.0f));
    var _S767 : vec2<f32> = _S758.dx_0 * _S764 * _S766;
    var _S768 : vec2<f32> = _S758.dy_0 * _S764 * _S766;
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
        var _S769 : vec2<f32> = _S765 + vec2<f32>(TAP_OFFSETS_0[number_3].x) * _S767 + vec2<f32>(TAP_OFFSETS_0[number_3].y) * _S768;
        var _S770 : f32 = _S762.y;
        taps_4.nodes_1[number_3] = select(u32(0), _S760.face_nodes_0, _S759) + u32(wrapped_cell_0(_S769.y, _S762.z) * _S770 + wrapped_cell_0(_S769.x, _S770) + _S762.x);
        number_3 = number_3 + u32(1);
    }
    return taps_4;
}

fn joint_ratios_0( _S771 : u32,  _S772 : vec3<f32>,  _S773 : vec3<f32>,  _S774 : bool) -> vec2<f32>
{
    var _S775 : NodeTaps_0 = node_taps_of_0(_S773, u32(16));
    var _S776 : NodeTaps_0 = node_taps_of_0(_S772, u32(16));
    var _S777 : u32 = fabrics_0[_S771].lobes_0.joint_0 + u32(2) * (select(u32(0), u32(2), _S774) + select(u32(0), u32(1), (_S772.z) < 0.0f)) * u32(512);
    var _S778 : u32 = _S777 + u32(512);
    return clamp(vec2<f32>(1.0f) + vec2<f32>(dot(joint_terms_0(_S775, _S777, u32(0)), joint_terms_0(_S776, _S778, u32(0))), dot(joint_terms_0(_S775, _S777, u32(1)), joint_terms_0(_S776, _S778, u32(1)))), vec2<f32>(0.0f), vec2<f32>(4.0f));
}

fn coverage_of_pack_0( _S779 : u32,  _S780 : CoverageTaps_0,  _S781 : u32) -> vec4<f32>
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
        var _S782 : u32 = words_0[fabrics_0[_S779].lobes_0.coverage_0 + _S780.nodes_1[number_4] * fabrics_0[_S779].lobes_0.packs_0 + _S781];
        var even_2 : u32 = even_1 + ((_S782 & (u32(16711935))));
        var odd_2 : u32 = odd_1 + ((((_S782 >> (u32(8)))) & (u32(16711935))));
        number_4 = number_4 + u32(1);
        even_1 = even_2;
        odd_1 = odd_2;
    }
    return bytes_of_sums_0(even_1, odd_1) / vec4<f32>(9.0f);
}

fn coverage_of_holes_0( _S783 : u32,  _S784 : CoverageTaps_0) -> f32
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
        var total_1 : u32 = total_0 + ((((words_0[fabrics_0[_S783].lobes_0.coverage_holes_0 + _S784.nodes_1[number_5] / u32(4)] >> ((u32(8) * (_S784.nodes_1[number_5] % u32(4)))))) & (u32(255))));
        number_5 = number_5 + u32(1);
        total_0 = total_1;
    }
    return f32(total_0) / 9.0f;
}

fn prefiltered_hole_0( _S785 : u32,  _S786 : CoverageTaps_0,  _S787 : NodeTaps_0,  _S788 : bool) -> f32
{
    var _S789 : f32 = interpolate_table_0(_S787, fabrics_0[_S785].lobes_0.projected_area_0 + fabrics_0[_S785].lobes_0.packs_0, fabrics_0[_S785].lobes_0.packs_0 + u32(1)).x;
    return min(coverage_of_holes_0(_S785, _S786) * _S789 * _S789 * select(fabrics_0[_S785].lobes_0.front_hole_weight_0, fabrics_0[_S785].lobes_0.back_hole_weight_0, _S788), 1.0f);
}

fn prefiltered_components_0( _S790 : u32,  _S791 : Footprint_0,  _S792 : vec3<f32>,  _S793 : vec3<f32>,  _S794 : bool) -> Components_0
{
    var _S795 : CoverageTaps_0 = coverage_taps_0(_S790, _S791, _S794);
    var _S796 : NodeTaps_0 = node_taps_0(_S793);
    var view_nodes_0 : NodeTaps_0 = _S796;
    var _S797 : NodeTaps_0 = node_taps_0(_S792);
    var light_nodes_0 : NodeTaps_0 = _S797;
    var _S798 : u32 = select(u32(0), u32(1), _S794);
    view_nodes_0.nodes_0 = view_nodes_0.nodes_0 + vec4<u32>((_S798 * u32(256)));
    light_nodes_0.nodes_0 = light_nodes_0.nodes_0 + vec4<u32>(((u32(2) * _S798 + select(u32(0), u32(1), (_S792.z) < 0.0f)) * u32(256)));
    var _S799 : vec3<f32> = half_vector_0(_S792, _S793);
    var _S800 : vec2<f32> = joint_ratios_0(_S790, _S792, _S793, _S794);
    var _S801 : Lobes_std430_0 = fabrics_0[_S790].lobes_0;
    var _S802 : u32 = select(fabrics_0[_S790].lobes_0.front_warp_packs_0, fabrics_0[_S790].lobes_0.back_warp_packs_0, _S794);
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
        if(pack_0 < (_S801.packs_0))
        {
        }
        else
        {
            break;
        }
        var _S803 : vec4<f32> = coverage_of_pack_0(_S790, _S795, pack_0);
        var _S804 : vec4<f32> = interpolate_table_0(view_nodes_0, _S801.projected_area_0 + pack_0, _S801.packs_0 + u32(1));
        var _S805 : vec4<f32> = interpolate_table_0(light_nodes_0, _S801.light_visibility_0 + pack_0, _S801.packs_0) / vec4<f32>(255.0f);
        var _S806 : vec4<f32> = interpolate_table_0(light_nodes_0, _S801.irradiance_0 + pack_0, _S801.packs_0) * vec4<f32>(0.00124827399849892f);
        var _S807 : bool = pack_0 < _S802;
        var _S808 : f32 = families_0[select(fabrics_0[_S790].weft_0, fabrics_0[_S790].warp_0, _S807)].roughness_0;
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
            var _S809 : Group_0 = group_at_0(_S801.moments_0 + u32(12) * (u32(4) * (_S798 * _S801.packs_0 + pack_0) + number_6), _S808);
            var _S810 : f32 = _S803[number_6] * _S804[number_6] * _S804[number_6] * _S809.weight_2;
            var diffuse_1 : f32 = diffuse_0 + _S810 * _S806[number_6];
            var specular_1 : f32 = specular_0 + _S810 * layer_value_0(_S809, _S799, _S792, _S793, fabrics_0[_S790].optical_depth_0) * _S805[number_6];
            var lit_1 : f32 = lit_0 + _S810 * _S805[number_6];
            var total_3 : f32 = total_2 + _S810;
            number_6 = number_6 + u32(1);
            diffuse_0 = diffuse_1;
            specular_0 = specular_1;
            lit_0 = lit_1;
            total_2 = total_3;
        }
        sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 + select(0.0f, diffuse_0, _S807);
        sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 + select(diffuse_0, 0.0f, _S807);
        sums_4.specular_warp_0 = sums_4.specular_warp_0 + select(0.0f, specular_0, _S807);
        sums_4.specular_weft_0 = sums_4.specular_weft_0 + select(specular_0, 0.0f, _S807);
        sums_4.light_visibility_1 = sums_4.light_visibility_1 + lit_0 * select(_S800.y, _S800.x, _S807);
        pack_0 = pack_0 + u32(1);
    }
    var _S811 : f32 = prefiltered_hole_0(_S790, _S795, view_nodes_0, _S794);
    sums_4.hole_2 = _S811;
    var _S812 : f32 = 1.0f - _S811;
    var _S813 : f32 = _S812 / max(total_2, 9.999999960041972e-13f);
    var _S814 : f32 = _S813 * _S800.x;
    sums_4.diffuse_warp_0 = sums_4.diffuse_warp_0 * _S814;
    var _S815 : f32 = _S813 * _S800.y;
    sums_4.diffuse_weft_0 = sums_4.diffuse_weft_0 * _S815;
    sums_4.specular_warp_0 = sums_4.specular_warp_0 * _S814;
    sums_4.specular_weft_0 = sums_4.specular_weft_0 * _S815;
    sums_4.light_visibility_1 = min(sums_4.light_visibility_1 * _S813, _S812);
    return sums_4;
}

fn albedos_over_0( _S816 : u32,  _S817 : Footprint_0,  _S818 : bool) -> FamilyAlbedos_0
{
    var _S819 : vec2<f32> = _S817.dx_0;
    var _S820 : vec2<f32> = _S817.dy_0;
    var _S821 : vec2<f32> = sqrt(_S819 * _S819 + _S820 * _S820);
    var _S822 : Stretch_0 = stretch_of_0(fabrics_0[_S816].warp_0, _S817.centre_0.x, _S821.x);
    var _S823 : Stretch_0 = stretch_of_0(fabrics_0[_S816].weft_0, _S817.centre_0.y, _S821.y);
    var albedos_9 : FamilyAlbedos_0;
    albedos_9.warp_5 = mean_albedos_0(fabrics_0[_S816].warp_0, fabrics_0[_S816].weft_0, _S822, _S823, _S818);
    albedos_9.weft_5 = mean_albedos_0(fabrics_0[_S816].weft_0, fabrics_0[_S816].warp_0, _S823, _S822, _S818);
    return albedos_9;
}

fn lobes_estimate_of_pass_0( _S824 : u32,  _S825 : Footprint_0,  _S826 : f32,  _S827 : vec2<f32>,  _S828 : vec3<f32>,  _S829 : vec3<f32>) -> Estimate_0
{
    var _S830 : f32;
    var _S831 : Regime_0 = regime_of_0(_S824, _S825, _S826);
    var _S832 : bool = (_S829.z) < 0.0f;
    var _S833 : vec3<f32> = to_face_frame_0(_S829, _S832);
    var _S834 : f32 = Footprint_spread_side_0(_S825);
    var _S835 : bool = varies_at_0(_S824, _S834);
    var _S836 : f32 = 1.0f - _S831.prefiltered_0;
    var _S837 : bool = ((_S836 > 0.0f) & (((_S835 | (((((families_0[fabrics_0[_S824].warp_0].quantities_0) > u32(1)) | (((families_0[fabrics_0[_S824].weft_0].quantities_0) > u32(1))))))))));
    var box_0 : Footprint_0 = _S825;
    var _S838 : vec3<f32> = vec3<f32>(0.0f);
    var _S839 : SurfacePoint_0 = SurfacePoint_x24init_0(false, false, u32(0), u32(0), 0.0f, _S838, _S838, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f);
    var _S840 : Components_0 = no_components_0();
    var close_1 : CloseUp_0 = no_close_up_0();
    var _S841 : u32 = select(u32(1), u32(0), _S837);
    var points_1 : Components_0 = _S840;
    var central_weight_0 : f32 = 0.0f;
    var central_0 : SurfacePoint_0 = _S839;
    var central_place_0 : vec2<f32> = _S825.centre_0;
    var number_7 : u32 = _S841;
    for(;;)
    {
        var _S842 : f32 = f32(number_7);
        _S830 = _S831.points_0;
        if(_S842 < (_S831.points_0 + 1.0f))
        {
        }
        else
        {
            break;
        }
        var _S843 : bool = number_7 == u32(0);
        var _S844 : u32 = number_7 - u32(1);
        var _S845 : vec2<f32> = POINT_OFFSETS_0[select(_S844, u32(0), _S843)] + _S827;
        var _S846 : vec2<f32> = select_vector_0(_S843, vec2<f32>(0.0f), _S845 - round(_S845));
        var _S847 : vec2<f32> = _S825.centre_0 + vec2<f32>(_S846.x) * _S825.dx_0 + vec2<f32>(_S846.y) * _S825.dy_0;
        var _S848 : SearchQuality_0 = quality_of_0(select(_S831.threads_1, 0.0f, _S843));
        var _S849 : Hit_0 = first_hit_0(_S824, _S848, _S847.x, _S847.y, _S833, _S832);
        var _S850 : SurfacePoint_0 = surface_met_0(_S824, _S849.x_16, _S849.y_9, _S849.height_6, _S833, _S832);
        if(_S843)
        {
            var central_weight_1 : f32 = select(_S836, 0.0f, _S849.hole_5);
            var central_place_1 : vec2<f32> = vec2<f32>(_S849.x_16, _S849.y_9);
            box_0.centre_0 = mix(_S825.centre_0, central_place_1, vec2<f32>(central_weight_1));
            central_weight_0 = central_weight_1;
            central_0 = _S850;
            central_place_0 = central_place_1;
            number_7 = number_7 + u32(1);
            continue;
        }
        var _S851 : YarnPoint_0 = yarn_point_of_0(_S824, _S850, _S832, _S849.hole_5, _S834);
        var _S852 : f32 = min(_S831.points_0 - f32(_S844), 1.0f);
        var _S853 : Components_0 = with_added_0(points_1, components_of_point_0(_S824, _S848, _S851, _S828, _S829), _S852);
        if((fabrics_0[_S824].openness_0) != u32(4294967295))
        {
            close_1.warp_1 = with_blocked_0(_S824, close_1.warp_1, _S851, true, _S852);
            close_1.weft_1 = with_blocked_0(_S824, close_1.weft_1, _S851, false, _S852);
        }
        points_1 = _S853;
        number_7 = number_7 + u32(1);
    }
    close_1.weight_0 = _S836;
    var _S854 : f32 = max(_S830, 1.0f);
    close_1.warp_1 = scaled_0(close_1.warp_1, 1.0f / _S854);
    close_1.weft_1 = scaled_0(close_1.weft_1, 1.0f / _S854);
    var estimate_0 : Estimate_0;
    estimate_0.close_0 = close_1;
    estimate_0.components_0 = with_added_0(_S840, points_1, _S836 / _S854);
    if((_S831.prefiltered_0) > 0.0f)
    {
        var _S855 : Components_0 = prefiltered_components_0(_S824, _S825, to_face_frame_0(_S828, _S832), _S833, _S832);
        estimate_0.components_0 = with_added_0(estimate_0.components_0, _S855, _S831.prefiltered_0);
    }
    estimate_0.albedos_5 = albedos_over_0(_S824, box_0, _S832);
    if((_S835 & ((central_weight_0 > 0.0f))))
    {
        var _S856 : SurfacePoint_0 = central_0;
        var _S857 : Albedos_0;
        if(central_0.is_warp_0)
        {
            _S857 = estimate_0.albedos_5.warp_5;
        }
        else
        {
            _S857 = estimate_0.albedos_5.weft_5;
        }
        var _S858 : bool;
        if((fabrics_0[_S824].has_detail_0) != u32(0))
        {
            _S858 = has_hairs_0(_S824);
        }
        else
        {
            _S858 = false;
        }
        var _S859 : f32;
        if(_S858)
        {
            _S859 = hair_at_0(_S824, central_place_0, _S832, _S834).cover_0;
        }
        else
        {
            _S859 = 0.0f;
        }
        var _S860 : Albedos_0 = lerp_albedos_0(_S857, varied_at_0(_S824, central_0, _S857, central_place_0.x, central_place_0.y, _S832, _S834, _S859), central_weight_0);
        if(_S856.is_warp_0)
        {
            estimate_0.albedos_5.warp_5 = _S860;
        }
        else
        {
            estimate_0.albedos_5.weft_5 = _S860;
        }
    }
    return estimate_0;
}

fn scattered_by_0( _S861 : u32,  _S862 : Albedos_0,  _S863 : u32,  _S864 : vec3<f32>) -> Scattered_0
{
    var _S865 : u32 = u32(159) + u32(2) * _S863;
    var yarn_3 : Scattered_0;
    yarn_3.back_6 = _S864 * _S862.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S861, _S865)) * _S862.specular_reflect_0;
    yarn_3.through_0 = _S864 * _S862.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S861, _S865 + u32(1))) * _S862.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S866 : u32,  _S867 : u32,  _S868 : vec3<f32>,  _S869 : vec3<f32>,  _S870 : vec3<f32>,  _S871 : vec3<f32>,  _S872 : ptr<function, vec3<f32>>,  _S873 : ptr<function, vec3<f32>>)
{
    var _S874 : u32 = u32(146) + u32(4) * _S867;
    var _S875 : f32 = openness_number_0(_S866, _S874 + u32(1));
    var _S876 : f32 = openness_number_0(_S866, _S874 + u32(2));
    var _S877 : vec3<f32> = vec3<f32>(1.0f);
    var _S878 : vec3<f32> = _S877 - _S870 * vec3<f32>(openness_number_0(_S866, _S874));
    var _S879 : vec3<f32> = _S877 - _S871 * vec3<f32>(openness_number_0(_S866, _S874 + u32(3)));
    var _S880 : vec3<f32> = _S877 / (_S878 * _S879 - _S870 * _S871 * vec3<f32>((_S875 * _S876)));
    (*_S872) = (_S868 * _S879 + _S870 * vec3<f32>(_S875) * _S869) * _S880;
    (*_S873) = (_S869 * _S878 + _S871 * vec3<f32>(_S876) * _S868) * _S880;
    return;
}

fn face_sends_0( _S881 : u32,  _S882 : u32,  _S883 : Scattered_0,  _S884 : Scattered_0) -> FaceSends_0
{
    var _S885 : u32 = u32(2) * _S882;
    var _S886 : u32 = u32(142) + _S885;
    var _S887 : f32 = openness_number_0(_S881, _S886);
    var _S888 : f32 = openness_number_0(_S881, _S886 + u32(1));
    var _S889 : vec3<f32> = vec3<f32>((1.0f - _S887)) * _S883.back_6;
    var _S890 : vec3<f32> = vec3<f32>((1.0f - _S888)) * _S884.back_6;
    var sends_1 : FaceSends_0;
    var _S891 : u32 = u32(154) + _S885;
    var _S892 : f32 = openness_number_0(_S881, _S891);
    sends_1.blocks_warp_0 = _S892;
    var _S893 : f32 = openness_number_0(_S881, _S891 + u32(1));
    sends_1.blocks_weft_0 = _S893;
    sends_1.open_0 = _S892 * _S887 + _S893 * _S888;
    var _S894 : vec3<f32> = vec3<f32>(_S887) * _S883.back_6;
    var _S895 : vec3<f32> = vec3<f32>(_S888) * _S884.back_6;
    var _S896 : vec3<f32> = sends_1.sky_warp_0;
    var _S897 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S881, _S882, _S894, _S895, _S889, _S890, &(_S896), &(_S897));
    sends_1.sky_warp_0 = _S896;
    sends_1.sky_weft_0 = _S897;
    var _S898 : vec3<f32> = sends_1.crossing_warp_0;
    var _S899 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S881, _S882, _S883.through_0, _S884.through_0, _S889, _S890, &(_S898), &(_S899));
    sends_1.crossing_warp_0 = _S898;
    sends_1.crossing_weft_0 = _S899;
    return sends_1;
}

fn interior_of_0( _S900 : u32,  _S901 : vec3<f32>,  _S902 : bool) -> Interior_0
{
    var _S903 : Scattered_0 = scattered_by_0(_S900, table_albedos_0(families_0[fabrics_0[_S900].warp_0].colour_mean_0), u32(0), _S901);
    var _S904 : Scattered_0 = scattered_by_0(_S900, table_albedos_0(families_0[fabrics_0[_S900].weft_0].colour_mean_0), u32(1), _S901);
    var _S905 : FaceSends_0 = face_sends_0(_S900, select(u32(0), u32(1), _S902), _S903, _S904);
    var _S906 : FaceSends_0 = face_sends_0(_S900, select(u32(1), u32(0), _S902), _S903, _S904);
    var _S907 : vec3<f32> = vec3<f32>(_S905.blocks_warp_0);
    var _S908 : vec3<f32> = vec3<f32>(_S905.blocks_weft_0);
    var _S909 : vec3<f32> = _S907 * _S905.crossing_warp_0 + _S908 * _S905.crossing_weft_0;
    var _S910 : vec3<f32> = vec3<f32>(_S906.blocks_warp_0);
    var _S911 : vec3<f32> = vec3<f32>(_S906.blocks_weft_0);
    var _S912 : vec3<f32> = _S910 * _S906.crossing_warp_0 + _S911 * _S906.crossing_weft_0;
    var _S913 : f32 = 1.0f - _S905.open_0;
    var _S914 : f32 = 1.0f - _S906.open_0;
    var _S915 : vec3<f32> = vec3<f32>(1.0f);
    var _S916 : vec3<f32> = _S915 / (_S915 - _S909 * _S912 * vec3<f32>((_S913 * _S914)));
    var _S917 : vec3<f32> = _S912 * (vec3<f32>(_S905.open_0) + vec3<f32>(_S913) * (_S907 * _S905.sky_warp_0 + _S908 * _S905.sky_weft_0)) * _S916;
    var _S918 : vec3<f32> = _S909 * (vec3<f32>(_S906.open_0) + vec3<f32>(_S914) * (_S910 * _S906.sky_warp_0 + _S911 * _S906.sky_weft_0)) * _S916;
    var _S919 : FaceRadiance_0 = face_radiance_0(_S905, _S906.open_0, _S917, _S918);
    var _S920 : FaceRadiance_0 = face_radiance_0(_S906, _S905.open_0, _S918, _S917);
    var interior_1 : Interior_0;
    interior_1.warp_4 = _S919.warp_3;
    interior_1.weft_4 = _S919.weft_3;
    interior_1.leaked_1 = _S919.leaked_0;
    interior_1.far_1 = _S920.mean_1;
    interior_1.far_leaked_0 = _S920.leaked_0;
    return interior_1;
}

fn blocked_from_0( _S921 : u32,  _S922 : vec3<f32>,  _S923 : bool,  _S924 : bool) -> Blocked_0
{
    var terms_3 : array<f32, i32(6)>;
    view_terms_0(_S922, &(terms_3));
    return blocked_of_terms_0(_S921, (select(u32(0), u32(2), _S924) + select(u32(1), u32(0), _S923)) * u32(15), terms_3, u32(5));
}

fn warp_seen_from_0( _S925 : u32,  _S926 : vec3<f32>,  _S927 : bool) -> f32
{
    var terms_4 : array<f32, i32(6)>;
    view_terms_1(_S926, &(terms_4));
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
        var share_6 : f32 = share_5 + openness_number_0(_S925, u32(132) + select(u32(0), u32(5), _S927) + term_1) * terms_4[term_1];
        term_1 = term_1 + u32(1);
        share_5 = share_6;
    }
    return saturate(share_5);
}

fn bounced_of_families_0( _S928 : u32,  _S929 : FamilyAlbedos_0,  _S930 : vec3<f32>,  _S931 : Interior_0,  _S932 : Blocked_0,  _S933 : Blocked_0) -> Bounced_0
{
    return sum_of_0(bounced_by_0(_S932, scattered_by_0(_S928, _S929.warp_5, u32(0), _S930), _S931), bounced_by_0(_S933, scattered_by_0(_S928, _S929.weft_5, u32(1), _S930), _S931));
}

fn bounced_far_0( _S934 : u32,  _S935 : FamilyAlbedos_0,  _S936 : vec3<f32>,  _S937 : Interior_0,  _S938 : vec3<f32>,  _S939 : bool,  _S940 : f32,  _S941 : f32,  _S942 : f32) -> Bounced_0
{
    var _S943 : Blocked_0 = blocked_from_0(_S934, _S938, true, _S939);
    var _S944 : Blocked_0 = blocked_from_0(_S934, _S938, false, _S939);
    var _S945 : f32 = _S940 / max(1.0f - _S943.by_warp_0 - _S943.by_weft_0, 0.10000000149011612f);
    var _S946 : f32 = (0.0020000000949949f * warp_seen_from_0(_S934, _S938, _S939) + _S945) / (_S945 + _S941 / max(1.0f - _S944.by_warp_0 - _S944.by_weft_0, 0.10000000149011612f) + 0.0020000000949949f);
    var _S947 : f32 = 1.0f - _S942;
    return bounced_of_families_0(_S934, _S935, _S936, _S937, scaled_0(_S943, _S946 * _S947), scaled_0(_S944, (1.0f - _S946) * _S947));
}

fn bounced_over_0( _S948 : u32,  _S949 : Components_0,  _S950 : CloseUp_0,  _S951 : FamilyAlbedos_0,  _S952 : vec3<f32>,  _S953 : vec3<f32>) -> Bounced_0
{
    var _S954 : bool = (_S953.z) < 0.0f;
    var _S955 : Interior_0 = interior_of_0(_S948, _S952, _S954);
    var bounced_2 : Bounced_0 = bounced_far_0(_S948, _S951, _S952, _S955, to_face_frame_0(_S953, _S954), _S954, _S949.diffuse_warp_0, _S949.diffuse_weft_0, _S949.hole_2);
    if((_S950.weight_0) > 0.0f)
    {
        var _S956 : Bounced_0 = bounced_of_families_0(_S948, _S951, _S952, _S955, _S950.warp_1, _S950.weft_1);
        var _S957 : vec3<f32> = vec3<f32>(_S950.weight_0);
        bounced_2.reflected_0 = mix(bounced_2.reflected_0, _S956.reflected_0, _S957);
        bounced_2.transmitted_0 = mix(bounced_2.transmitted_0, _S956.transmitted_0, _S957);
    }
    return bounced_2;
}

fn composed_0( _S958 : u32,  _S959 : Components_0,  _S960 : CloseUp_0,  _S961 : FamilyAlbedos_0,  _S962 : vec3<f32>,  _S963 : vec3<f32>,  _S964 : vec3<f32>) -> vec3<f32>
{
    var _S965 : Albedos_0 = tinted_0(_S961.warp_5, _S962);
    var _S966 : Albedos_0 = tinted_0(_S961.weft_5, _S962);
    var _S967 : vec3<f32> = vec3<f32>(_S959.diffuse_warp_0);
    var _S968 : vec3<f32> = vec3<f32>(_S959.diffuse_weft_0);
    var _S969 : vec3<f32> = vec3<f32>(_S959.specular_warp_0);
    var _S970 : vec3<f32> = vec3<f32>(_S959.specular_weft_0);
    var _S971 : vec3<f32> = _S965.diffuse_reflect_0 * _S967 + _S966.diffuse_reflect_0 * _S968 + _S965.specular_reflect_0 * _S969 + _S966.specular_reflect_0 * _S970;
    var _S972 : f32 = _S964.z;
    var body_0 : vec3<f32>;
    if((_S963.z * _S972) < 0.0f)
    {
        body_0 = _S965.diffuse_transmit_0 * _S967 + _S966.diffuse_transmit_0 * _S968 + _S965.specular_transmit_0 * _S969 + _S966.specular_transmit_0 * _S970;
    }
    else
    {
        body_0 = _S971;
    }
    if((fabrics_0[_S958].openness_0) != u32(4294967295))
    {
        body_0 = body_0 + bounced_value_0(bounced_over_0(_S958, _S959, _S960, _S961, _S962, _S964), _S963, _S964);
    }
    var _S973 : f32 = fabrics_0[_S958].sheen_strength_0;
    if((fabrics_0[_S958].sheen_strength_0) <= 0.0f)
    {
        return body_0;
    }
    var _S974 : bool = _S972 < 0.0f;
    var _S975 : vec2<f32> = sheen_with_transmittance_0(to_face_frame_0(_S963, _S974), to_face_frame_0(_S964, _S974), _S973, fabrics_0[_S958].sheen_roughness_0);
    return vec3<f32>(_S975.y) * body_0 + vec3<f32>(((_S959.light_visibility_1 + _S959.hole_2) * _S975.x));
}

fn light_of_footprint_0( _S976 : u32,  _S977 : VisiblePoint_0,  _S978 : vec2<u32>,  _S979 : vec3<f32>) -> vec4<f32>
{
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S977.draft_0;
    footprint_0.dx_0 = _S977.draft_dx_0;
    footprint_0.dy_0 = _S977.draft_dy_0;
    var _S980 : vec2<f32> = fract(vec2<f32>(f32(((frame_record_0.pass_number_0) & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
    var _S981 : vec3<f32> = to_local_0(_S977, _S977.view_0);
    var _S982 : u32 = light_sample_count_0();
    var _S983 : vec3<f32> = vec3<f32>(0.0f);
    var number_8 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S983;
    var hole_7 : f32 = 0.0f;
    for(;;)
    {
        if(number_8 < (max(_S982, u32(1))))
        {
        }
        else
        {
            break;
        }
        var _S984 : f32;
        if(number_8 < _S982)
        {
            _S984 = visibility_at_0(number_8, _S978);
        }
        else
        {
            _S984 = 0.0f;
        }
        var _S985 : bool;
        if(_S984 <= 0.0f)
        {
            _S985 = number_8 > u32(0);
        }
        else
        {
            _S985 = false;
        }
        if(_S985)
        {
            number_8 = number_8 + u32(1);
            continue;
        }
        var _S986 : LightSample_0 = light_sample_0(number_8, _S978, _S977.position_0);
        var _S987 : vec3<f32> = to_local_0(_S977, _S986.towards_0);
        var _S988 : Estimate_0 = lobes_estimate_of_pass_0(_S976, footprint_0, 1.0f, _S980, _S987, _S981);
        radiance_1 = radiance_1 + vec3<f32>(_S984) * _S986.irradiance_1 * composed_0(_S976, _S988.components_0, _S988.close_0, _S988.albedos_5, _S979, _S987, _S981);
        hole_7 = _S988.components_0.hole_2;
        number_8 = number_8 + u32(1);
    }
    var _S989 : f32 = fabrics_0[_S976].sheen_strength_0;
    if((fabrics_0[_S976].sheen_strength_0) > 0.0f)
    {
        hole_7 = hole_7 * (1.0f - _S989 * sheen_lobe_0(abs(_S981.z), fabrics_0[_S976].sheen_roughness_0).z);
    }
    return vec4<f32>(radiance_1, 1.0f - hole_7);
}

@compute
@workgroup_size(8, 8, 1)
fn shade_lobes(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S990 : u32 = id_0.x;
    var _S991 : bool;
    if(_S990 >= (frame_record_0.width_0))
    {
        _S991 = true;
    }
    else
    {
        _S991 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S991)
    {
        return;
    }
    var _S992 : u32 = id_0.y * frame_record_0.width_0 + _S990;
    var _S993 : u32 = layers_0[_S992].face_0;
    if((layers_0[_S992].face_0) == u32(0))
    {
        return;
    }
    var _S994 : u32 = _S993 - u32(1);
    var _S995 : u32 = fabric_of_0(_S994);
    var _S996 : vec2<u32> = id_0.xy;
    var _S997 : VisiblePoint_0 = visible_point_0(_S995, _S994, _S996);
    var _S998 : vec4<f32> = light_of_footprint_0(_S995, _S997, _S996, filtered_albedo_0(_S995, _S997));
    accumulate_0(_S992, _S998);
    return;
}

