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
    @align(4) per_half_width_0 : f32,
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
    var _S28 : vec2<f32> = this_0.dx_0;
    var _S29 : vec2<f32> = this_0.dy_0;
    return sqrt(0.5f * (dot(_S28, _S28) + dot(_S29, _S29)));
}

fn to_face_frame_0( direction_1 : vec3<f32>,  back_2 : bool) -> vec3<f32>
{
    var _S30 : f32 = direction_1.z;
    return vec3<f32>(direction_1.xy, select(_S30, - _S30, back_2));
}

fn turns_and_remainder_0( family_0 : u32,  index_2 : f32) -> vec2<f32>
{
    var _S31 : f32 = floor(fma(index_2, families_0[family_0].inverse_count_0, families_0[family_0].half_inverse_count_0));
    return vec2<f32>(_S31, fma(- _S31, families_0[family_0].count_0, index_2));
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
    var _S32 : f32 = floor(position_1 * families_0[family_1].inverse_size_0);
    var cell_2 : Cell_0;
    var _S33 : f32 = fma(- _S32, families_0[family_1].size_0, position_1);
    cell_2.below_0 = _S33;
    cell_2.above_0 = families_0[family_1].size_0 - _S33;
    cell_2.across_0 = _S33 - 0.5f * families_0[family_1].size_0;
    cell_2.half_width_1 = families_0[family_1].half_width_0;
    cell_2.thread_2 = u32(clamp(turns_and_remainder_0(family_1, _S32).y, 0.0f, families_0[family_1].count_0 - 1.0f));
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
    var _S34 : f32 = turns_1 * families_0[family_2].period_0;
    var thread_3 : u32 = words_0[families_0[family_2].first_thread_table_0 + u32(clamp(turns_1 * families_0[family_2].bins_0, 0.0f, families_0[family_2].bins_0 - 1.0f))];
    var _S35 : u32 = min(thread_3 + select(u32(0), u32(1), _S34 >= (table_number_0(families_0[family_2].place_table_0 + thread_3 * u32(4) + u32(1)))), u32(families_0[family_2].count_0) - u32(1));
    var _S36 : u32 = families_0[family_2].place_table_0 + _S35 * u32(4);
    var cell_3 : Cell_0;
    cell_3.thread_2 = _S35;
    cell_3.below_0 = _S34 - table_number_0(_S36);
    cell_3.above_0 = table_number_0(_S36 + u32(1)) - _S34;
    cell_3.across_0 = _S34 - table_number_0(_S36 + u32(2));
    cell_3.half_width_1 = table_number_0(_S36 + u32(3));
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
    var _S37 : bool = (abs(crossing_0.warp_1.across_0)) < (crossing_0.warp_1.half_width_1);
    var shown_0 : Shown_0;
    var _S38 : bool = !((abs(crossing_0.weft_1.across_0)) < (crossing_0.weft_1.half_width_1));
    var _S39 : bool = (_S37 & (((_S38 | ((crossing_0.warp_above_0))))));
    shown_0.is_warp_0 = _S39;
    shown_0.hole_0 = ((!_S37) & (_S38));
    var _S40 : u32 = select(crossing_0.weft_word_0, crossing_0.warp_word_0, _S39);
    shown_0.word_0 = _S40;
    shown_0.on_top_0 = (((_S40 & (u32(1)))) == u32(1)) != back_3;
    return shown_0;
}

fn select_cell_0( is_first_0 : bool,  first_2 : Cell_0,  second_0 : Cell_0) -> Cell_0
{
    var cell_4 : Cell_0;
    cell_4.thread_2 = select(second_0.thread_2, first_2.thread_2, is_first_0);
    cell_4.across_0 = select(second_0.across_0, first_2.across_0, is_first_0);
    cell_4.half_width_1 = select(second_0.half_width_1, first_2.half_width_1, is_first_0);
    cell_4.below_0 = select(second_0.below_0, first_2.below_0, is_first_0);
    cell_4.above_0 = select(second_0.above_0, first_2.above_0, is_first_0);
    return cell_4;
}

fn boundary_0( family_4 : u32,  thread_4 : u32,  step_0 : i32) -> f32
{
    var _S41 : vec2<f32> = turns_and_remainder_0(family_4, f32(i32(thread_4) + step_0));
    return fma(_S41.x, families_0[family_4].period_0, table_number_0(families_0[family_4].place_table_0 + u32(_S41.y) * u32(4)));
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
    var _S42 : u32 = families_0[family_6].bend_table_0 + select(thread_6 * u32(4), u32(0), (families_0[family_6].is_alike_0) != u32(0));
    var bend_0 : Bend_0;
    bend_0.sine_0 = table_number_0(_S42);
    bend_0.half_tangent_0 = table_number_0(_S42 + u32(1));
    bend_0.arc_0 = table_number_0(_S42 + u32(2));
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
    var _S43 : i32 = i32((((word_1 >> (u32(1)))) & (u32(127))));
    var _S44 : i32 = i32((((word_1 >> (u32(8)))) & (u32(127))));
    var _S45 : i32 = i32((((word_1 >> (u32(15)))) & (u32(63))));
    var _S46 : i32 = i32((((word_1 >> (u32(21)))) & (u32(63))));
    var run_0 : Run_0;
    var _S47 : bool = ((((word_1 >> (u32(27)))) & (u32(1)))) == u32(1);
    run_0.straight_0 = _S47;
    var _S48 : i32 = - _S43;
    var _S49 : f32 = crossed_0.below_0 + span_0(other_0, crossed_0.thread_2, _S48, i32(0));
    run_0.from_start_0 = _S49;
    var _S50 : i32 = _S44 + i32(1);
    var _S51 : f32 = crossed_0.above_0 + span_0(other_0, crossed_0.thread_2, i32(1), _S50);
    run_0.to_end_0 = _S51;
    var _S52 : bool = _S49 < _S51;
    run_0.near_start_0 = _S52;
    var _S53 : i32 = select(_S50, _S48 - _S45, _S52);
    var _S54 : i32 = select(_S50 + _S46, _S48, _S52);
    run_0.bend_1 = bend_of_0(own_0, thread_7);
    run_0.distance_0 = select(min(_S49, _S51), 1.0e+06f, _S47);
    run_0.reach_0 = min(0.5f * (_S49 + _S51), run_0.bend_1.arc_0);
    run_0.other_reach_0 = min(0.5f * span_0(other_0, crossed_0.thread_2, _S53, _S54), run_0.bend_1.arc_0);
    run_0.first_crossing_0 = _S43 == i32(0);
    run_0.last_crossing_0 = _S44 == i32(0);
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
    var _S55 : f32 = cell_5.half_width_1 * 1.0154266357421875f;
    var section_0 : Section_0;
    var _S56 : f32 = clamp(cell_5.across_0, - cell_5.half_width_1, cell_5.half_width_1);
    section_0.across_1 = _S56;
    var _S57 : f32 = _S55 * _S55 - square_1(_S56);
    var _S58 : f32 = rsqrt_0(_S57);
    section_0.drop_0 = _S55 - _S57 * _S58;
    section_0.slope_0 = - _S56 * _S58;
    return section_0;
}

fn edge_drop_0( family_7 : u32,  thread_8 : u32,  step_1 : i32) -> f32
{
    return table_number_0(families_0[family_7].bend_table_0 + select(u32(turns_and_remainder_0(family_7, f32(i32(thread_8) + step_1)).y) * u32(4), u32(0), (families_0[family_7].is_alike_0) != u32(0)) + u32(3));
}

fn dive_0( other_1 : u32,  shown_1 : Shown_0,  run_1 : Run_0,  crossed_1 : Cell_0) -> vec3<f32>
{
    var _S59 : bool = (crossed_1.below_0) < (crossed_1.above_0);
    var _S60 : f32 = min(crossed_1.below_0, crossed_1.above_0);
    var _S61 : f32 = select(crossed_1.above_0 + crossed_1.across_0, crossed_1.below_0 - crossed_1.across_0, _S59) - crossed_1.half_width_1;
    var _S62 : bool = select(run_1.last_crossing_0, run_1.first_crossing_0, _S59);
    var _S63 : f32;
    if(shown_1.on_top_0)
    {
        _S63 = 0.0f;
    }
    else
    {
        _S63 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, i32(0));
    }
    var _S64 : f32;
    if((shown_1.on_top_0) != _S62)
    {
        _S64 = 0.0f;
    }
    else
    {
        _S64 = families_0[other_1].height_scale_0 * edge_drop_0(other_1, crossed_1.thread_2, select(i32(1), i32(-1), _S59));
    }
    var _S65 : f32 = 2.0f * _S61;
    var _S66 : f32 = 1.0f / max(_S65, 9.999999960041972e-13f);
    var _S67 : f32 = clamp((_S61 - _S60) * _S66, 0.0f, 1.0f);
    var _S68 : f32 = clamp((0.44999998807907104f - _S65 / crossed_1.half_width_1) * 4.0000004768371582f, 0.0f, 1.0f);
    return vec3<f32>(_S63 + (_S64 - _S63) * (_S67 * _S67 * (3.0f - 2.0f * _S67)), (_S63 - _S64) * (6.0f * _S67 * (1.0f - _S67) * _S66) * select(-1.0f, 1.0f, _S59), _S68 * _S68 * (3.0f - 2.0f * _S68));
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
    var _S69 : f32 = direction_2.x;
    control_0.per_x_0 = 1.0f / max(abs(_S69), 9.99999971718068537e-10f);
    var _S70 : f32 = direction_2.y;
    control_0.per_y_0 = 1.0f / max(abs(_S70), 9.99999971718068537e-10f);
    control_0.right_0 = _S69 > 0.0f;
    control_0.up_0 = _S70 > 0.0f;
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
    var _S71 : f32 = select(- cell_6.across_0, cell_6.across_0, forwards_0);
    var _S72 : f32 = select(cell_6.below_0, cell_6.above_0, forwards_0);
    var _S73 : f32 = - cell_6.half_width_1;
    var _S74 : bool = _S71 < _S73;
    var _S75 : bool = _S71 >= (cell_6.half_width_1);
    var _S76 : bool = (((lengthwise_0 & ((!select(run_2.first_crossing_0, run_2.last_crossing_0, forwards_0))))) & ((!shown_2.hole_0)));
    var _S77 : f32 = select(cell_6.half_width_1, _S73, _S74) - _S71;
    var _S78 : f32 = select(_S72, 2.0f * _S72 + _S71 - cell_6.half_width_1, ((shown_2.hole_0) | (((_S76 & ((!shown_2.on_top_0)))))));
    if((((_S76 & ((shown_2.on_top_0)))) & ((!((select(run_2.last_crossing_0, run_2.first_crossing_0, forwards_0) & (_S74)))))))
    {
        return select(run_2.from_start_0, run_2.to_end_0, forwards_0);
    }
    return select(_S77, _S78, _S75);
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
    var _S79 : f32 = previous_1.rate_0 * step_4;
    var _S80 : f32 = rate_1 * step_4;
    if(((((((((!previous_1.known_0) | ((here_0.hole_1)))) | (((previous_1.yarn_0) != (here_0.yarn_1))))) | (((previous_1.rate_0) >= 0.0f)))) | ((rate_1 <= 0.0f))))
    {
        return -1.0f;
    }
    if((((3.0f * previous_1.clearance_0 + _S79) >= 0.0f) & (((3.0f * clearance_1 - _S80) >= 0.0f))))
    {
        return -1.0f;
    }
    var _S81 : f32 = clearance_1 - previous_1.clearance_0;
    var _S82 : f32 = 6.0f * _S81 - 4.0f * _S79 - 2.0f * _S80;
    var _S83 : f32 = -2.0f * _S79 / max(_S82 + sqrt(max(_S82 * _S82 - 4.0f * (3.0f * (_S79 + _S80 - 2.0f * _S81)) * _S79, 0.0f)), 9.99999968265522539e-21f);
    var _S84 : f32 = 1.0f - _S83;
    return select(-1.0f, _S84 * step_4, ((((_S83 > 0.01999999955296516f) & ((_S84 > 0.01999999955296516f)))) & ((((previous_1.clearance_0 * (2.0f * _S83 + 1.0f) + _S79 * _S83) * _S84 * _S84 + (clearance_1 * (2.0f * _S84 + 1.0f) - _S80 * _S84) * _S83 * _S83) < 0.0f))));
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
    var _S85 : f32 = min(here_2.edge_x_0 * this_2.per_x_0, here_2.edge_y_0 * this_2.per_y_0);
    return min(this_2.step_2, select(max(_S85, 0.0f) + this_2.epsilon_0, _S85 - this_2.epsilon_0, ((((!here_2.hole_1) & (((rate_3 * _S85 + clearance_3) < 0.0f)))) & ((_S85 > (2.0f * this_2.epsilon_0))))));
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
    var _S86 : f32 = end_0 - start_1;
    var _S87 : f32 = start_rate_0 + end_rate_0 - 2.0f * _S86;
    var _S88 : f32 = 3.0f * _S86 - 2.0f * start_rate_0 - end_rate_0;
    var share_1 : f32 = start_1 / max(- _S86, 9.99999968265522539e-21f);
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
        var _S89 : f32 = clamp(share_1 - (((_S87 * share_1 + _S88) * share_1 + start_rate_0) * share_1 + start_1) / min((3.0f * _S87 * share_1 + 2.0f * _S88) * share_1 + start_rate_0, 0.10000000149011612f * _S86 - 9.99999968265522539e-21f), 0.0f, 1.0f);
        var _S90 : i32 = i_0 + i32(1);
        share_1 = _S89;
        i_0 = _S90;
    }
    return share_1;
}

fn between_0( above_1 : f32,  under_0 : f32,  above_gap_0 : f32,  under_gap_0 : f32) -> f32
{
    return clamp(above_gap_0 / max(above_gap_0 + under_gap_0, 9.99999968265522539e-21f), 0.01999999955296516f, 0.98000001907348633f) * (under_0 - above_1) + above_1;
}

fn fibre_direction_0( across_slope_0 : f32,  along_slope_0 : f32,  sine_1 : f32,  cosine_0 : f32) -> vec2<f32>
{
    var _S91 : f32 = along_slope_0 * along_slope_0 + 1.0f;
    var _S92 : f32 = rsqrt_0(_S91);
    var _S93 : f32 = sine_1 * _S92 * rsqrt_0(_S91 + across_slope_0 * across_slope_0);
    return vec2<f32>(- _S93 * _S91, _S93 * across_slope_0 * along_slope_0 + cosine_0 * _S92);
}

fn arc_sine_0( x_6 : f32) -> f32
{
    var _S94 : f32 = abs(x_6);
    var _S95 : bool = _S94 > 0.5f;
    var _S96 : f32 = select(_S94 * _S94, 0.5f * (1.0f - _S94), _S95);
    var _S97 : f32 = select(_S94, sqrt(max(_S96, 0.0f)), _S95);
    var _S98 : f32 = ((((0.04216320067644119f * _S96 + 0.02418131195008755f) * _S96 + 0.04547002539038658f) * _S96 + 0.07495300471782684f) * _S96 + 0.16666752099990845f) * _S96 * _S97 + _S97;
    var _S99 : f32 = select(_S98, 1.57079637050628662f - 2.0f * _S98, _S95);
    return select(_S99, - _S99, x_6 < 0.0f);
}

fn run_share_0( word_2 : u32) -> f32
{
    var _S100 : f32 = f32(((((word_2 >> (u32(1)))) & (u32(127)))) + ((((word_2 >> (u32(8)))) & (u32(127)))) + u32(1));
    return _S100 / (_S100 + 0.5f * f32(((((word_2 >> (u32(15)))) & (u32(63)))) + ((((word_2 >> (u32(21)))) & (u32(63))))));
}

fn angle_of_0( direction_3 : vec2<f32>) -> f32
{
    var _S101 : f32 = direction_3.x;
    var _S102 : f32 = arc_sine_0(_S101);
    var _S103 : bool = _S101 < 0.0f;
    var _S104 : f32 = select(3.14159274101257324f, -3.14159274101257324f, _S103);
    var _S105 : f32 = direction_3.y;
    return select(0.5f * _S104 - select(1.0f, -1.0f, _S103) * arc_sine_0(_S105), select(_S102, _S104 - _S102, _S105 < 0.0f), (abs(_S101)) < 0.69999998807907104f);
}

struct Hair_0
{
     cover_0 : f32,
     normal_1 : vec3<f32>,
     tangent_0 : vec3<f32>,
};

fn Hair_x24init_0( cover_1 : f32,  normal_2 : vec3<f32>,  tangent_1 : vec3<f32>) -> Hair_0
{
    var _S106 : Hair_0;
    _S106.cover_0 = cover_1;
    _S106.normal_1 = normal_2;
    _S106.tangent_0 = tangent_1;
    return _S106;
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
    var _S107 : f32 = floor(x_7 * 0.63661974668502808f + 0.5f);
    var _S108 : f32 = x_7 - _S107 * 1.5703125f - _S107 * 0.00048375129699707f - _S107 * 7.54979012640433211e-08f;
    var _S109 : f32 = _S108 * _S108;
    var _S110 : f32 = ((-0.00019515295571182f * _S109 + 0.00833216123282909f) * _S109 - 0.16666655242443085f) * _S109 * _S108 + _S108;
    var _S111 : f32 = ((0.00002443315679557f * _S109 - 0.00138873164542019f) * _S109 + 0.04166664555668831f) * _S109 * _S109 - 0.5f * _S109 + 1.0f;
    var _S112 : u32 = (u32(i32(_S107)) & (u32(3)));
    var _S113 : vec2<f32> = select_vector_1(((_S112 & (u32(1)))) != u32(0), vec2<f32>(_S111, _S110), vec2<f32>(_S110, _S111));
    var _S114 : f32 = _S113.x;
    var _S115 : f32 = _S113.y;
    return vec2<f32>(select(_S114, - _S114, ((_S112 & (u32(2)))) != u32(0)), select(_S115, - _S115, (((_S112 + u32(1)) & (u32(2)))) != u32(0)));
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
    var _S116 : f32 = floor(across_2 / width_2);
    return vec3<f32>(_S116, along_0 / (width_2 * 40.0f) + 0.61799997091293335f * _S116, 2.0f * (across_2 / width_2 - _S116) - 1.0f);
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
     x_8 : f32,
     y_1 : f32,
     shown_share_0 : f32,
};

fn ply_offset_0( family_9 : u32,  point_1 : SurfacePoint_0,  back_4 : bool) -> f32
{
    var _S117 : f32 = (point_1.fibre_across_0 * families_0[family_9].ply_cosine_0 + point_1.fibre_along_0 * select(families_0[family_9].ply_sine_0, - families_0[family_9].ply_sine_0, back_4)) * families_0[family_9].plies_per_mm_0;
    return 2.0f * (_S117 - floor(_S117)) - 1.0f;
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
    var _S118 : f32 = floor(position_4);
    var _S119 : f32 = position_4 - _S118;
    var _S120 : u32 = u32(i32(_S118));
    var _S121 : f32 = signed_noise_0(hash_bits_0(key_1, _S120));
    var _S122 : f32 = signed_noise_0(hash_bits_0(key_1, _S120 + u32(1)));
    return vec2<f32>(mix(_S121, _S122, smooth_share_0(_S119)), 6.0f * _S119 * (1.0f - _S119) * (_S122 - _S121));
}

fn cell_noise_0( key_2 : u32,  cell_7 : vec3<f32>) -> vec2<f32>
{
    var _S123 : f32 = cell_7.y;
    var _S124 : f32 = floor(_S123);
    var _S125 : u32 = u32(i32(cell_7.x)) * u32(65536) + u32(i32(_S124));
    var _S126 : u32 = hash_bits_0(key_2, _S125);
    var _S127 : u32 = hash_bits_0(key_2, _S125 + u32(1));
    return mix(vec2<f32>(signed_noise_0(_S126), signed_noise_0((_S126 >> (u32(16))))), vec2<f32>(signed_noise_0(_S127), signed_noise_0((_S127 >> (u32(16))))), vec2<f32>(smooth_share_0(_S123 - _S124)));
}

fn thread_gain_0( thread_10 : u32,  amount_0 : f32,  seed_1 : u32) -> f32
{
    return amount_0 * (2.0f * uniform_hash_0(thread_10, u32(0), (seed_1 ^ (u32(2135587861)))) - 1.0f) + 1.0f;
}

fn bounded_gain_0( gain_1 : f32,  albedo_1 : vec3<f32>,  room_0 : vec3<f32>) -> f32
{
    var _S128 : vec3<f32> = room_0 / max(albedo_1, vec3<f32>(9.99999997475242708e-07f));
    return min(gain_1, max(min(min(_S128.x, _S128.y), _S128.z), 0.0f));
}

fn flattened_0( largest_0 : f32,  albedo_2 : vec3<f32>,  room_1 : vec3<f32>) -> f32
{
    var _S129 : vec3<f32> = room_1 / max(albedo_2, vec3<f32>(9.99999997475242708e-07f)) - vec3<f32>(1.0f);
    return min(max(min(min(_S129.x, _S129.y), _S129.z), 0.0f) / max(largest_0, 9.99999997475242708e-07f), 1.0f);
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
    var _S130 : vec3<f32> = select_vector_0((dot(frame_0.tangent_3, hair_0.tangent_0)) < 0.0f, (vec3<f32>(0) - hair_0.tangent_0), hair_0.tangent_0);
    var blended_0 : YarnFrame_0;
    var _S131 : vec3<f32> = vec3<f32>(hair_0.cover_0);
    var _S132 : vec3<f32> = normalize(mix(frame_0.normal_4, hair_0.normal_1, _S131));
    blended_0.normal_4 = _S132;
    var _S133 : vec3<f32> = mix(frame_0.tangent_3, _S130, _S131);
    var _S134 : vec3<f32> = _S133 - vec3<f32>(dot(_S133, _S132)) * _S132;
    blended_0.tangent_3 = _S134 * vec3<f32>(rsqrt_0(max(dot(_S134, _S134), 9.999999960041972e-13f)));
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
    var _S135 : vec3<f32> = vec3<f32>((1.0f - open_of_other_0)) * passed_0;
    var found_0 : FaceRadiance_0;
    var _S136 : vec3<f32> = sends_0.sky_warp_0 + _S135 * sends_0.crossing_warp_0;
    found_0.warp_2 = _S136;
    var _S137 : vec3<f32> = sends_0.sky_weft_0 + _S135 * sends_0.crossing_weft_0;
    found_0.weft_2 = _S137;
    found_0.mean_0 = vec3<f32>(sends_0.blocks_warp_0) * _S136 + vec3<f32>(sends_0.blocks_weft_0) * _S137;
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
    var _S138 : vec3<f32> = vec3<f32>((blocked_0.by_warp_0 + blocked_0.by_weft_0)) * interior_0.leaked_1;
    var _S139 : vec3<f32> = vec3<f32>(blocked_0.far_0) * yarn_2.through_0;
    var bounced_0 : Bounced_0;
    bounced_0.reflected_0 = yarn_2.back_5 * (vec3<f32>(blocked_0.by_warp_0) * interior_0.warp_3 + vec3<f32>(blocked_0.by_weft_0) * interior_0.weft_3) + _S139 * interior_0.far_leaked_0;
    bounced_0.transmitted_0 = _S139 * interior_0.far_1 + yarn_2.back_5 * _S138;
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
        var _S140 : u32 = (low_0 + high_0) / u32(2);
        if((scene_number_0(table_0 + _S140)) <= number_0)
        {
            low_0 = _S140;
        }
        else
        {
            high_0 = _S140;
        }
    }
    var _S141 : u32 = table_0 + low_0;
    var _S142 : f32 = scene_number_0(_S141);
    var _S143 : f32 = scene_number_0(_S141 + u32(1));
    var choice_0 : Choice_0;
    choice_0.index_6 = low_0;
    choice_0.remainder_0 = saturate((number_0 - _S142) / max(_S143 - _S142, 9.999999960041972e-13f));
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
    var _S144 : f32 = light_1.z;
    if(_S144 <= 0.0f)
    {
        return 0.0f;
    }
    return 0.31830987334251404f * mix(max(_S144, 0.0f), max(dot(light_1, normal_5), 0.0f), blend_1);
}

fn projected_area_1( direction_4 : vec3<f32>,  tangent_4 : vec3<f32>,  roughness_1 : f32) -> f32
{
    var _S145 : f32 = dot(direction_4, tangent_4);
    return sqrt(max((roughness_1 + 1.0f) * (roughness_1 - 1.0f) * _S145 * _S145 + 1.0f, roughness_1 * roughness_1));
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
    var _S146 : f32 = roughness_2 * roughness_2;
    var _S147 : f32 = squared_along_0 * (1.0f - _S146) + _S146;
    return 0.31830987334251404f * _S146 * roughness_2 / (_S147 * _S147);
}

fn density_between_0( light_2 : vec3<f32>,  view_1 : vec3<f32>,  tangent_5 : vec3<f32>,  roughness_3 : f32) -> f32
{
    var _S148 : vec3<f32> = light_2 + view_1;
    var _S149 : f32 = dot(_S148, tangent_5);
    return flake_density_0(min(_S149 * _S149 / max(square_0(_S148), 9.999999960041972e-13f), 1.0f), roughness_3);
}

fn reflection_0( light_3 : vec3<f32>,  view_2 : vec3<f32>,  normal_6 : vec3<f32>,  tangent_6 : vec3<f32>,  roughness_4 : f32,  optical_depth_1 : f32) -> f32
{
    var _S150 : f32 = dot(light_3, normal_6);
    var _S151 : f32 = dot(view_2, normal_6);
    if(((_S150 <= 0.0f) | ((_S151 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S152 : f32 = max(_S150, 9.99999997475242708e-07f);
    var _S153 : f32 = max(_S151, 9.99999997475242708e-07f);
    var _S154 : f32 = projected_area_1(light_3, tangent_6, roughness_4) * _S153 + projected_area_1(view_2, tangent_6, roughness_4) * _S152;
    var _S155 : f32 = optical_depth_1 * _S154 / (_S152 * _S153);
    return 0.25f * density_between_0(light_3, view_2, tangent_6, roughness_4) * (_S155 * mean_attenuation_0(_S155)) * _S152 / _S154;
}

fn transmission_1( light_4 : vec3<f32>,  view_3 : vec3<f32>,  normal_7 : vec3<f32>,  tangent_7 : vec3<f32>,  roughness_5 : f32,  optical_depth_2 : f32) -> f32
{
    var _S156 : f32 = - dot(light_4, normal_7);
    var _S157 : f32 = dot(view_3, normal_7);
    if(((_S156 <= 0.0f) | ((_S157 <= 0.0f))))
    {
        return 0.0f;
    }
    var _S158 : f32 = 1.0f / max(_S157, 9.99999997475242708e-07f);
    var _S159 : f32 = projected_area_1(light_4, tangent_7, roughness_5) / max(_S156, 9.99999997475242708e-07f);
    var _S160 : f32 = projected_area_1(view_3, tangent_7, roughness_5) * _S158;
    return density_between_0(light_4, view_3, tangent_7, roughness_5) * 0.25f * optical_depth_2 * exponential_0(- optical_depth_2 * min(_S159, _S160)) * mean_attenuation_0(optical_depth_2 * abs(_S159 - _S160)) * _S158;
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
    var _S161 : f32 = clamp(cos_view_0, 0.00999999977648258f, 1.0f);
    var _S162 : f32 = 2.0f * sqrt(_S161) - 1.0f;
    var _S163 : f32 = 3.0f * sqrt(sqrt(clamp(roughness_6, 0.00999999977648258f, 1.0f))) - 2.0f;
    return vec3<f32>(clamp(sheen_scale_0(_S162, _S163), 0.00999999977648258f, 1.0f), clamp((1.0f - _S161) * sheen_shear_0(_S162, _S163), -0.25f, 0.0f), 0.80000001192092896f / (1.0f + exponential_0(- clamp(sheen_reflectance_0(_S162, _S163), -60.0f, 60.0f))));
}

fn transformed_cosine_0( light_5 : vec3<f32>,  view_4 : vec3<f32>,  scale_0 : f32,  shear_0 : f32) -> f32
{
    var _S164 : f32 = light_5.z;
    if(((_S164 <= 0.0f) | (((view_4.z) <= 0.0f))))
    {
        return 0.0f;
    }
    var _S165 : vec2<f32> = view_4.xy;
    var _S166 : f32 = dot(_S165, _S165);
    var _S167 : vec2<f32> = select_vector_1(_S166 > 9.99999968265522539e-21f, _S165 * vec2<f32>(rsqrt_0(max(_S166, 9.99999968265522539e-21f))), vec2<f32>(1.0f, 0.0f));
    var _S168 : f32 = scale_0 * dot(light_5.xy, _S167) + shear_0 * _S164;
    var _S169 : f32 = scale_0 * (light_5.y * _S167.x - light_5.x * _S167.y);
    var _S170 : f32 = _S168 * _S168 + _S169 * _S169 + _S164 * _S164;
    return 0.31830987334251404f * scale_0 * scale_0 * _S164 / max(_S170 * _S170, 9.99999968265522539e-21f);
}

fn sheen_with_transmittance_0( light_6 : vec3<f32>,  view_5 : vec3<f32>,  strength_0 : f32,  roughness_7 : f32) -> vec2<f32>
{
    var _S171 : vec3<f32> = sheen_lobe_0(view_5.z, roughness_7);
    var _S172 : f32 = strength_0 * _S171.z;
    return vec2<f32>(_S172 * transformed_cosine_0(light_6, view_5, _S171.x, _S171.y), 1.0f - _S172);
}

fn bounced_value_0( bounced_1 : Bounced_0,  light_7 : vec3<f32>,  view_6 : vec3<f32>) -> vec3<f32>
{
    var _S173 : f32 = light_7.z;
    return select_vector_0((_S173 * view_6.z) < 0.0f, bounced_1.transmitted_0, bounced_1.reflected_0) * vec3<f32>((abs(_S173) * 0.31830987334251404f));
}

fn accumulate_0( index_7 : u32,  light_8 : vec4<f32>)
{
    var _S174 : f32 = layers_0[index_7].share_0;
    radiance_0[index_7] = radiance_0[index_7] + vec4<f32>(layers_0[index_7].share_0) * light_8;
    layers_0[index_7].share_0 = _S174 * (1.0f - light_8.w);
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

fn face_point_0( _S175 : u32,  _S176 : u32,  _S177 : f32,  _S178 : f32) -> VisiblePoint_0
{
    var _S179 : u32 = u32(3) * _S176;
    var _S180 : Vertex_0 = vertex_at_0(_S179);
    var _S181 : Vertex_0 = vertex_at_0(_S179 + u32(1));
    var _S182 : Vertex_0 = vertex_at_0(_S179 + u32(2));
    var _S183 : vec3<f32> = position_of_0(_S180);
    var _S184 : vec3<f32> = position_of_0(_S181) - _S183;
    var _S185 : vec3<f32> = position_of_0(_S182) - _S183;
    var _S186 : f32 = _S181.u_0 - _S180.u_0;
    var _S187 : f32 = _S181.v_0 - _S180.v_0;
    var _S188 : vec2<f32> = vec2<f32>(_S186, _S187);
    var _S189 : f32 = _S182.u_0 - _S180.u_0;
    var _S190 : f32 = _S182.v_0 - _S180.v_0;
    var _S191 : vec2<f32> = vec2<f32>(_S189, _S190);
    var _S192 : vec3<f32> = vec3<f32>(select(1.0f, -1.0f, (_S186 * _S190 - _S187 * _S189) < 0.0f));
    var _S193 : vec3<f32> = _S192 * (vec3<f32>(_S190) * _S184 - vec3<f32>(_S187) * _S185);
    var _S194 : vec3<f32> = _S192 * (vec3<f32>(_S186) * _S185 - vec3<f32>(_S189) * _S184);
    var point_2 : VisiblePoint_0;
    var _S195 : vec3<f32> = vec3<f32>(_S177);
    var _S196 : vec3<f32> = vec3<f32>(_S178);
    var _S197 : vec3<f32> = normalize(vec3<f32>((1.0f - _S177 - _S178)) * normal_of_0(_S180) + _S195 * normal_of_0(_S181) + _S196 * normal_of_0(_S182));
    point_2.normal_0 = _S197;
    var _S198 : vec3<f32> = normalize(_S193 - _S197 * vec3<f32>(dot(_S197, _S193)));
    point_2.axis_x_0 = _S198;
    point_2.axis_y_0 = cross(_S197, _S198);
    var _S199 : vec3<f32> = normalize(cross(_S184, _S185));
    point_2.face_normal_0 = select_vector_0((dot(_S199, _S197)) < 0.0f, (vec3<f32>(0) - _S199), _S199);
    point_2.position_0 = _S183 + _S195 * _S184 + _S196 * _S185;
    point_2.view_0 = _S197;
    var _S200 : vec2<f32> = vec2<f32>(_S180.u_0, _S180.v_0) + vec2<f32>(_S177) * _S188 + vec2<f32>(_S178) * _S191;
    point_2.uv_1 = _S200;
    var _S201 : bool = (dot(cross(_S193, _S194), _S197)) < 0.0f;
    var _S202 : vec2<f32> = vec2<f32>(fabrics_0[_S175].uv_width_0, select(fabrics_0[_S175].uv_height_0, - fabrics_0[_S175].uv_height_0, _S201));
    point_2.draft_per_uv_0 = _S202;
    point_2.draft_0 = _S200 * _S202 + vec2<f32>(0.0f, select(0.0f, fabrics_0[_S175].uv_height_0, _S201));
    var _S203 : vec2<f32> = vec2<f32>(0.0f);
    point_2.draft_dx_0 = _S203;
    point_2.draft_dy_0 = _S203;
    return point_2;
}

fn visible_point_0( _S204 : u32,  _S205 : u32,  _S206 : vec2<u32>) -> VisiblePoint_0
{
    var _S207 : u32 = u32(3) * _S205;
    var _S208 : Vertex_0 = vertex_at_0(_S207);
    var _S209 : Vertex_0 = vertex_at_0(_S207 + u32(1));
    var _S210 : Vertex_0 = vertex_at_0(_S207 + u32(2));
    var _S211 : vec3<f32> = position_of_0(_S208);
    var _S212 : vec3<f32> = position_of_0(_S209) - _S211;
    var _S213 : vec3<f32> = position_of_0(_S210) - _S211;
    var _S214 : vec3<f32> = cross(_S212, _S213);
    var _S215 : f32 = f32(frame_record_0.width_0);
    var _S216 : vec3<f32> = camera_right_0() * vec3<f32>((2.0f / _S215));
    var _S217 : f32 = f32(frame_record_0.height_0);
    var _S218 : vec3<f32> = camera_up_0() * vec3<f32>((-2.0f / _S217));
    var _S219 : vec3<f32> = camera_forward_0() + vec3<f32>((f32(_S206.x) + 0.5f - 0.5f * _S215)) * _S216 + vec3<f32>((f32(_S206.y) + 0.5f - 0.5f * _S217)) * _S218;
    var _S220 : f32 = dot(_S219, _S214);
    var _S221 : f32 = 1.0f / select(1.00000000317107685e-30f, _S220, (abs(_S220)) > 1.00000000317107685e-30f);
    var _S222 : vec3<f32> = _S211 - camera_origin_0();
    var _S223 : vec3<f32> = vec3<f32>((dot(_S222, _S214) * _S221));
    var _S224 : vec3<f32> = _S219 * _S223 - _S222;
    var _S225 : vec3<f32> = _S223 * (_S216 - _S219 * vec3<f32>((dot(_S216, _S214) * _S221)));
    var _S226 : vec3<f32> = _S223 * (_S218 - _S219 * vec3<f32>((dot(_S218, _S214) * _S221)));
    var _S227 : vec3<f32> = vec3<f32>((1.0f / max(square_0(_S214), 1.00000000317107685e-30f)));
    var _S228 : vec3<f32> = cross(_S213, _S214) * _S227;
    var _S229 : vec3<f32> = cross(_S214, _S212) * _S227;
    var _S230 : vec2<f32> = vec2<f32>(_S209.u_0 - _S208.u_0, _S209.v_0 - _S208.v_0);
    var _S231 : vec2<f32> = vec2<f32>(_S210.u_0 - _S208.u_0, _S210.v_0 - _S208.v_0);
    var point_3 : VisiblePoint_0 = face_point_0(_S204, _S205, dot(_S224, _S228), dot(_S224, _S229));
    point_3.position_0 = _S211 + _S224;
    point_3.view_0 = (vec3<f32>(0) - normalize(_S219));
    point_3.draft_dx_0 = (vec2<f32>(dot(_S225, _S228)) * _S230 + vec2<f32>(dot(_S225, _S229)) * _S231) * point_3.draft_per_uv_0;
    point_3.draft_dy_0 = (vec2<f32>(dot(_S226, _S228)) * _S230 + vec2<f32>(dot(_S226, _S229)) * _S231) * point_3.draft_per_uv_0;
    return point_3;
}

fn filtered_albedo_0( _S232 : u32,  _S233 : VisiblePoint_0) -> vec3<f32>
{
    var _S234 : u32 = fabrics_0[_S232].albedo_map_levels_0;
    if((fabrics_0[_S232].albedo_map_levels_0) == u32(0))
    {
        return vec3<f32>(1.0f);
    }
    var _S235 : vec2<f32> = vec2<f32>(fabrics_0[_S232].uv_width_0, fabrics_0[_S232].uv_height_0);
    var _S236 : vec2<f32> = _S233.draft_dx_0 / _S235;
    var _S237 : vec2<f32> = _S233.draft_dy_0 / _S235;
    var _S238 : u32 = _S234 - u32(1);
    var _S239 : u32 = (u32(1) << (_S238));
    var _S240 : f32 = clamp(0.5f * binary_logarithm_0(max(abs(_S236.x * _S237.y - _S236.y * _S237.x), 9.99999968265522539e-21f) * (square_1(f32(_S239)) / 3.0f)), 0.0f, f32(_S234) - 1.0f);
    var _S241 : u32 = min(u32(_S240), max(_S234, u32(2)) - u32(2));
    var _S242 : u32 = min(_S241 + u32(1), _S238);
    var _S243 : u32 = (u32(1) << ((u32(2) * _S234)));
    return mix(map_level_0(fabrics_0[_S232].albedo_map_0 + (_S243 - ((_S243 >> ((u32(2) * _S241))))) / u32(3), (_S239 >> (_S241)), _S233.uv_1), map_level_0(fabrics_0[_S232].albedo_map_0 + (_S243 - ((_S243 >> ((u32(2) * _S242))))) / u32(3), (_S239 >> (_S242)), _S233.uv_1), vec3<f32>(((exponential_0(1.38629436492919922f * (_S240 - f32(_S241))) - 1.0f) / 3.0f)));
}

struct YarnPoint_0
{
     back_6 : bool,
     hole_3 : bool,
     is_warp_2 : bool,
     x_13 : f32,
     y_6 : f32,
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

fn crossing_at_0( _S244 : u32,  _S245 : f32,  _S246 : f32,  _S247 : bool) -> Crossing_0
{
    var crossing_2 : Crossing_0;
    crossing_2.warp_1 = locate_0(fabrics_0[_S244].warp_0, _S245);
    crossing_2.weft_1 = locate_0(fabrics_0[_S244].weft_0, _S246);
    var _S248 : u32 = fabrics_0[_S244].run_words_0 + u32(2) * (crossing_2.weft_1.thread_2 * fabrics_0[_S244].ends_1 + crossing_2.warp_1.thread_2);
    var _S249 : u32 = words_0[_S248];
    crossing_2.warp_word_0 = _S249;
    crossing_2.weft_word_0 = words_0[_S248 + u32(1)];
    crossing_2.warp_above_0 = (((_S249 & (u32(1)))) == u32(1)) != _S247;
    return crossing_2;
}

fn sample_at_0( _S250 : u32,  _S251 : f32,  _S252 : f32,  _S253 : bool) -> Sample_0
{
    var sample_0 : Sample_0;
    var _S254 : Crossing_0 = crossing_at_0(_S250, _S251, _S252, _S253);
    sample_0.crossing_1 = _S254;
    var _S255 : Shown_0 = shown_at_0(_S254, _S253);
    sample_0.shown_3 = _S255;
    var _S256 : u32 = select(fabrics_0[_S250].weft_0, fabrics_0[_S250].warp_0, _S255.is_warp_0);
    var _S257 : u32 = select(fabrics_0[_S250].warp_0, fabrics_0[_S250].weft_0, _S255.is_warp_0);
    var _S258 : Cell_0 = select_cell_0(_S255.is_warp_0, sample_0.crossing_1.warp_1, sample_0.crossing_1.weft_1);
    var _S259 : Cell_0 = select_cell_0(_S255.is_warp_0, sample_0.crossing_1.weft_1, sample_0.crossing_1.warp_1);
    var _S260 : Run_0 = unpack_0(_S256, _S257, _S258.thread_2, _S259, _S255.word_0);
    var _S261 : Section_0 = section_at_0(_S258);
    var _S262 : bool = ((_S255.on_top_0) & (((_S260.distance_0) < (_S261.drop_0 * _S260.bend_1.sine_0))));
    var _S263 : f32 = select(-1.0f, 1.0f, ((_S255.on_top_0) & ((!_S262))));
    var _S264 : f32 = select(_S260.reach_0, _S260.other_reach_0, _S262);
    var _S265 : f32 = select(max(_S264 - _S260.distance_0, 0.0f), _S264 + _S260.distance_0, _S262);
    var _S266 : f32 = _S264 / _S260.bend_1.sine_0 - _S263 * _S261.drop_0;
    var _S267 : f32 = _S265 * _S265;
    var _S268 : f32 = max(_S266 * _S266 - _S267, 9.99999968265522539e-21f);
    var _S269 : f32 = rsqrt_0(_S268);
    var _S270 : f32 = _S267 / (_S268 * _S269 + _S266);
    var _S271 : bool = _S265 > 0.0f;
    var _S272 : f32 = select(-1.0f, 1.0f, _S255.on_top_0) * select(-1.0f, 1.0f, _S260.near_start_0);
    var _S273 : f32 = _S261.slope_0 * select(1.0f, _S266 * _S269, _S271);
    sample_0.slope_across_0 = _S273;
    var _S274 : f32 = select(0.0f, _S272 * _S265 * _S269, _S271);
    sample_0.slope_along_0 = _S274;
    var _S275 : vec3<f32> = dive_0(_S257, _S255, _S260, _S259);
    sample_0.dive_1 = _S275;
    sample_0.height_7 = select(families_0[_S256].height_scale_0 * _S263, 0.0f, _S260.straight_0) * (_S264 * _S260.bend_1.half_tangent_0 - _S270) - families_0[_S256].height_scale_0 * _S261.drop_0 - _S275.x;
    var _S276 : f32 = families_0[_S256].height_scale_0 * _S273;
    var _S277 : f32 = families_0[_S256].height_scale_0 * _S274 - _S275.y;
    sample_0.slope_x_1 = select(_S277, _S276, _S255.is_warp_0);
    sample_0.slope_y_1 = select(_S276, _S277, _S255.is_warp_0);
    sample_0.run_3 = _S260;
    sample_0.section_1 = _S261;
    return sample_0;
}

fn steps_per_length_0( _S278 : u32,  _S279 : SearchQuality_0,  _S280 : vec3<f32>) -> f32
{
    return max(max(abs(_S280.x) * fabrics_0[_S278].threads_per_x_0, abs(_S280.y) * fabrics_0[_S278].threads_per_y_0) * _S279.steps_per_thread_0, abs(_S280.z) * fabrics_0[_S278].per_relief_0 * _S279.steps_per_relief_0);
}

fn cell_maximum_0( _S281 : u32,  _S282 : Crossing_0) -> f32
{
    var _S283 : u32 = select(fabrics_0[_S281].weft_0, fabrics_0[_S281].warp_0, _S282.warp_above_0);
    return f32((select(_S282.weft_word_0, _S282.warp_word_0, _S282.warp_above_0) >> (u32(28)))) * families_0[_S283].height_scale_0 * families_0[_S283].level_0;
}

fn probe_0( _S284 : u32,  _S285 : f32,  _S286 : f32,  _S287 : bool,  _S288 : bool,  _S289 : bool) -> Probe_0
{
    var _S290 : Sample_0 = sample_at_0(_S284, _S285, _S286, _S287);
    var probe_1 : Probe_0;
    probe_1.height_2 = _S290.height_7;
    probe_1.hole_1 = _S290.shown_3.hole_0;
    probe_1.slope_x_0 = _S290.slope_x_1;
    probe_1.slope_y_0 = _S290.slope_y_1;
    probe_1.yarn_1 = select(_S290.crossing_1.weft_1.thread_2 * u32(2), _S290.crossing_1.warp_1.thread_2 * u32(2) + u32(1), _S290.shown_3.is_warp_0);
    probe_1.cell_max_0 = cell_maximum_0(_S284, _S290.crossing_1);
    probe_1.side_x_0 = select(_S290.crossing_1.warp_1.below_0, _S290.crossing_1.warp_1.above_0, _S288);
    probe_1.side_y_0 = select(_S290.crossing_1.weft_1.below_0, _S290.crossing_1.weft_1.above_0, _S289);
    probe_1.edge_x_0 = outline_distance_0(_S290.crossing_1.warp_1, _S290.shown_3, _S290.run_3, !_S290.shown_3.is_warp_0, _S288);
    probe_1.edge_y_0 = outline_distance_0(_S290.crossing_1.weft_1, _S290.shown_3, _S290.run_3, _S290.shown_3.is_warp_0, _S289);
    return probe_1;
}

fn is_free_0( _S291 : u32,  _S292 : SearchQuality_0,  _S293 : vec3<f32>,  _S294 : vec3<f32>,  _S295 : bool,  _S296 : f32) -> bool
{
    var _S297 : f32 = _S294.z;
    if(_S297 <= 0.0f)
    {
        return false;
    }
    var _S298 : f32 = 1.0f / max(_S292.shadow_share_0 * steps_per_length_0(_S291, _S292, _S294), 9.99999971718068537e-10f);
    var _S299 : StepControl_0 = step_control_0(_S294.xy, _S298);
    var previous_3 : PreviousSample_0 = no_previous_sample_0();
    var count_2 : u32 = u32(0);
    var distance_1 : f32 = 0.0f;
    var last_step_0 : f32 = 0.0f;
    for(;;)
    {
        if(((count_2 < u32(1024)) & (((_S293.z + _S297 * distance_1) < _S296))))
        {
        }
        else
        {
            break;
        }
        var _S300 : vec3<f32> = _S293 + _S294 * vec3<f32>(distance_1);
        var _S301 : Probe_0 = probe_0(_S291, _S300.x, _S300.y, _S295, _S299.right_0, _S299.up_0);
        var _S302 : f32 = _S300.z;
        var _S303 : f32 = _S302 - _S301.height_2;
        var _S304 : f32 = _S297 - _S301.slope_x_0 * _S294.x - _S301.slope_y_0 * _S294.y;
        if(((!_S301.hole_1) & ((_S303 < 0.0f))))
        {
            return false;
        }
        var _S305 : f32 = way_back_to_dip_0(previous_3, _S303, _S304, last_step_0, _S301);
        if(_S305 >= 0.0f)
        {
            var last_step_1 : f32 = last_step_0 - _S305;
            distance_1 = distance_1 - _S305;
            last_step_0 = last_step_1;
            count_2 = count_2 + u32(1);
            continue;
        }
        var _S306 : bool = _S302 > (_S301.cell_max_0);
        var last_step_2 : f32 = select(StepControl_to_next_sample_0(_S299, _S301, _S303, _S304), max(StepControl_to_cell_exit_0(_S299, _S301.side_x_0, _S301.side_y_0), _S298), _S306);
        var distance_2 : f32 = distance_1 + last_step_2;
        previous_3 = after_sample_0(_S303, _S304, _S301, _S306);
        distance_1 = distance_2;
        last_step_0 = last_step_2;
        count_2 = count_2 + u32(1);
    }
    return true;
}

fn passes_through_0( _S307 : u32,  _S308 : SearchQuality_0,  _S309 : f32,  _S310 : f32,  _S311 : vec3<f32>,  _S312 : bool) -> bool
{
    if(!sample_at_0(_S307, _S309, _S310, _S312).shown_3.hole_0)
    {
        return false;
    }
    var _S313 : vec3<f32> = vec3<f32>(_S309, _S310, 0.0f);
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
        var _S314 : bool = is_free_0(_S307, _S308, _S313, select_vector_0(side_1 == u32(0), _S311, vec3<f32>(- _S311.x, - _S311.y, _S311.z)), _S312 != (side_1 == u32(1)), fabrics_0[_S307].height_high_0);
        var _S315 : u32 = side_1 + u32(1);
        passes_0 = _S314;
        side_1 = _S315;
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

fn max_height_along_0( _S316 : u32,  _S317 : f32,  _S318 : f32,  _S319 : f32,  _S320 : vec3<f32>,  _S321 : bool) -> f32
{
    var _S322 : f32 = _S320.x;
    var _S323 : f32 = _S320.y;
    var _S324 : u32 = (words_0[fabrics_0[_S316].max_heights_0 + u32(4) * (locate_0(fabrics_0[_S316].weft_0, _S318).thread_2 / u32(2) * fabrics_0[_S316].max_height_columns_0 + locate_0(fabrics_0[_S316].warp_0, _S317).thread_2 / u32(2)) + (select(u32(0), u32(1), _S322 > 0.0f) + select(u32(0), u32(2), _S323 > 0.0f))] >> (u32(select(i32(0), i32(4), _S321))));
    var _S325 : f32 = max(abs(_S322) * fabrics_0[_S316].threads_per_x_0, abs(_S323) * fabrics_0[_S316].threads_per_y_0) / _S320.z;
    var _S326 : f32 = fabrics_0[_S316].height_high_0;
    var max_height_0 : f32 = fabrics_0[_S316].height_high_0;
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
        if(((max_height_0 - _S319) * _S325) <= (PYRAMID_RADII_0[number_1]))
        {
            max_height_0 = min(max_height_0, f32((((_S324 >> (u32(i32(8) * number_1)))) & (u32(15)))) * 0.06666667014360428f * _S326);
        }
        number_1 = number_1 - i32(1);
    }
    return max_height_0;
}

fn cell_bounds_0( _S327 : u32,  _S328 : f32,  _S329 : f32,  _S330 : bool,  _S331 : bool,  _S332 : bool) -> vec3<f32>
{
    var _S333 : Crossing_0 = crossing_at_0(_S327, _S328, _S329, _S330);
    return vec3<f32>(cell_maximum_0(_S327, _S333), select(_S333.warp_1.below_0, _S333.warp_1.above_0, _S331), select(_S333.weft_1.below_0, _S333.weft_1.above_0, _S332));
}

fn first_sample_height_0( _S334 : u32,  _S335 : ViewRay_0,  _S336 : StepControl_0,  _S337 : bool) -> f32
{
    var _S338 : f32 = max_height_along_0(_S334, _S335.origin_0.x, _S335.origin_0.y, 0.0f, vec3<f32>(_S335.slope_1, 1.0f), _S337);
    var count_3 : u32 = u32(0);
    var height_9 : f32 = _S338;
    for(;;)
    {
        if(count_3 < u32(1024))
        {
        }
        else
        {
            break;
        }
        var _S339 : vec2<f32> = ViewRay_at_0(_S335, height_9);
        var _S340 : vec3<f32> = cell_bounds_0(_S334, _S339.x, _S339.y, _S337, _S336.right_0, _S336.up_0);
        var _S341 : f32 = height_9 - _S340.x;
        var _S342 : f32 = StepControl_to_cell_exit_0(_S336, _S340.y, _S340.z);
        var height_10 : f32 = height_9 - clamp(_S341, 0.0f, _S342);
        if(_S341 <= _S342)
        {
            height_9 = height_10;
            break;
        }
        count_3 = count_3 + u32(1);
        height_9 = height_10;
    }
    return height_9;
}

fn search_down_0( _S343 : u32,  _S344 : ViewRay_0,  _S345 : StepControl_0,  _S346 : bool) -> ViewRayEnd_0
{
    var _S347 : f32 = fabrics_0[_S343].height_low_0 - (fabrics_0[_S343].height_high_0 - fabrics_0[_S343].height_low_0);
    var end_1 : ViewRayEnd_0;
    end_1.height_8 = first_sample_height_0(_S343, _S344, _S345, _S346);
    end_1.last_step_3 = _S345.epsilon_0;
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
        var _S348 : vec2<f32> = ViewRay_at_0(_S344, end_1.height_8);
        var _S349 : Probe_0 = probe_0(_S343, _S348.x, _S348.y, _S346, _S345.right_0, _S345.up_0);
        var _S350 : f32 = end_1.height_8 - _S349.height_2;
        var _S351 : f32 = ViewRay_rate_0(_S344, _S349);
        end_1.depth_1 = - _S350;
        end_1.rate_4 = _S351;
        var _S352 : bool = !_S349.hole_1;
        end_1.smooth_0 = ((((end_1.previous_4.known_0) & (_S352))) & (((end_1.previous_4.yarn_0) == (_S349.yarn_1))));
        if((((_S352 & ((_S350 <= 0.0f)))) | (((end_1.height_8) <= _S347))))
        {
            break;
        }
        var _S353 : f32 = way_back_to_dip_0(end_1.previous_4, _S350, _S351, end_1.last_step_3, _S349);
        if(_S353 >= 0.0f)
        {
            end_1.height_8 = end_1.height_8 + _S353;
            end_1.last_step_3 = end_1.last_step_3 - _S353;
            count_4 = count_4 + u32(1);
            continue;
        }
        var _S354 : f32 = min(StepControl_to_cell_exit_0(_S345, _S349.side_x_0, _S349.side_y_0), end_1.height_8 - _S349.cell_max_0);
        var _S355 : f32 = StepControl_to_next_sample_0(_S345, _S349, _S350, _S351);
        end_1.previous_4 = after_sample_0(_S350, _S351, _S349, _S354 > _S355);
        var _S356 : f32 = max(_S354, _S355);
        end_1.last_step_3 = _S356;
        end_1.height_8 = end_1.height_8 - _S356;
        count_4 = count_4 + u32(1);
    }
    return end_1;
}

fn refined_height_0( _S357 : u32,  _S358 : ViewRay_0,  _S359 : StepControl_0,  _S360 : bool,  _S361 : ViewRayEnd_0,  _S362 : u32) -> f32
{
    var _S363 : f32 = fabrics_0[_S357].height_high_0 - fabrics_0[_S357].height_low_0;
    var above_2 : f32 = _S361.height_8 + _S361.last_step_3;
    var above_gap_1 : f32 = clamp(_S361.previous_4.clearance_0, 0.0f, _S363);
    var under_gap_1 : f32 = clamp(_S361.depth_1, 0.0f, _S363);
    var middle_0 : f32 = select(between_0(above_2, _S361.height_8, above_gap_1, under_gap_1), above_2 - cubic_root_0(above_gap_1, - under_gap_1, _S361.previous_4.rate_0 * _S361.last_step_3, _S361.rate_4 * _S361.last_step_3) * _S361.last_step_3, _S361.smooth_0);
    var side_2 : f32 = 0.0f;
    var above_gap_2 : f32 = above_gap_1;
    var under_gap_2 : f32 = under_gap_1;
    var under_1 : f32 = _S361.height_8;
    var above_3 : f32 = above_2;
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S362)
        {
        }
        else
        {
            break;
        }
        var _S364 : vec2<f32> = ViewRay_at_0(_S358, middle_0);
        var _S365 : Probe_0 = probe_0(_S357, _S364.x, _S364.y, _S360, _S359.right_0, _S359.up_0);
        var _S366 : f32 = clamp(middle_0 - select(_S365.height_2, -1.0e+09f, _S365.hole_1), - _S363, _S363);
        if(_S366 <= 0.0f)
        {
            var _S367 : f32 = select(above_gap_2, 0.5f * above_gap_2, side_2 > 0.0f);
            var _S368 : f32 = - _S366;
            under_1 = middle_0;
            above_gap_2 = _S367;
            under_gap_2 = _S368;
            side_2 = 1.0f;
        }
        else
        {
            var _S369 : f32 = select(under_gap_2, 0.5f * under_gap_2, side_2 < 0.0f);
            above_3 = middle_0;
            above_gap_2 = _S366;
            under_gap_2 = _S369;
            side_2 = -1.0f;
        }
        var _S370 : f32 = select(between_0(above_3, under_1, above_gap_2, under_gap_2), clamp(middle_0 + _S366 / min(ViewRay_rate_0(_S358, _S365), -9.99999997475242708e-07f), under_1, above_3), _S361.smooth_0);
        var _S371 : u32 = i_1 + u32(1);
        middle_0 = _S370;
        i_1 = _S371;
    }
    return select(under_1, middle_0, _S361.smooth_0);
}

fn first_hit_of_yarn_0( _S372 : u32,  _S373 : SearchQuality_0,  _S374 : f32,  _S375 : f32,  _S376 : vec3<f32>,  _S377 : bool) -> Hit_0
{
    var _S378 : f32 = max(_S376.z, 0.00009999999747379f);
    var ray_0 : ViewRay_0;
    ray_0.origin_0 = vec2<f32>(_S374, _S375);
    var _S379 : vec2<f32> = _S376.xy / vec2<f32>(_S378);
    ray_0.slope_1 = _S379;
    var _S380 : StepControl_0 = step_control_0((vec2<f32>(0) - _S379), 1.0f / max(steps_per_length_0(_S372, _S373, _S376) / _S378, 9.99999971718068537e-10f));
    var _S381 : ViewRayEnd_0 = search_down_0(_S372, ray_0, _S380, _S377);
    var hit_0 : Hit_0;
    hit_0.hole_4 = false;
    var _S382 : f32 = refined_height_0(_S372, ray_0, _S380, _S377, _S381, _S373.refinements_0);
    hit_0.height_6 = _S382;
    var _S383 : vec2<f32> = ViewRay_at_0(ray_0, _S382);
    hit_0.x_14 = _S383.x;
    hit_0.y_7 = _S383.y;
    return hit_0;
}

fn first_hit_0( _S384 : u32,  _S385 : SearchQuality_0,  _S386 : f32,  _S387 : f32,  _S388 : vec3<f32>,  _S389 : bool) -> Hit_0
{
    if(!passes_through_0(_S384, _S385, _S386, _S387, _S388, _S389))
    {
        return first_hit_of_yarn_0(_S384, _S385, _S386, _S387, _S388, _S389);
    }
    var hit_1 : Hit_0;
    hit_1.x_14 = _S386;
    hit_1.y_7 = _S387;
    hit_1.height_6 = 0.0f;
    hit_1.hole_4 = true;
    return hit_1;
}

fn surface_of_0( _S390 : u32,  _S391 : Sample_0,  _S392 : f32,  _S393 : f32,  _S394 : bool) -> SurfacePoint_0
{
    var _S395 : u32 = select(fabrics_0[_S390].weft_0, fabrics_0[_S390].warp_0, _S391.shown_3.is_warp_0);
    var _S396 : f32 = families_0[_S395].twist_sine_0 * select(1.0f, -1.0f, _S394);
    var _S397 : f32 = select(-1.0f, 1.0f, _S391.shown_3.is_warp_0);
    var _S398 : vec2<f32> = fibre_direction_0(_S391.slope_across_0, _S397 * _S391.slope_along_0, _S396, families_0[_S395].twist_cosine_0);
    var _S399 : f32 = _S398.x;
    var _S400 : f32 = _S398.y;
    var _S401 : f32 = select(_S391.slope_y_1, _S391.slope_x_1, _S391.shown_3.is_warp_0) * _S399 + _S397 * select(_S391.slope_x_1, _S391.slope_y_1, _S391.shown_3.is_warp_0) * _S400;
    var _S402 : f32 = select(_S391.crossing_1.weft_1.half_width_1, _S391.crossing_1.warp_1.half_width_1, _S391.shown_3.is_warp_0) * 1.0154266357421875f;
    var _S403 : f32 = _S402 * arc_sine_0(clamp(_S391.section_1.across_1 / _S402, -1.0f, 1.0f));
    var _S404 : f32 = select(- _S392, _S393, _S391.shown_3.is_warp_0);
    var point_4 : SurfacePoint_0;
    point_4.hole_2 = _S391.shown_3.hole_0;
    point_4.is_warp_1 = _S391.shown_3.is_warp_0;
    point_4.warp_thread_0 = _S391.crossing_1.warp_1.thread_2;
    point_4.weft_thread_0 = _S391.crossing_1.weft_1.thread_2;
    point_4.height_4 = _S391.height_7;
    point_4.normal_3 = normalize(vec3<f32>(- _S391.slope_x_1, - _S391.slope_y_1, 1.0f));
    point_4.tangent_2 = normalize(select_vector_0(_S391.shown_3.is_warp_0, vec3<f32>(_S399, _S400, _S401), vec3<f32>(- _S400, _S399, _S401)));
    point_4.across_3 = _S391.section_1.across_1;
    point_4.fibre_across_0 = _S403 * families_0[_S395].twist_cosine_0 + _S404 * _S396;
    point_4.fibre_along_0 = _S404 * families_0[_S395].twist_cosine_0 - _S403 * _S396;
    var _S405 : f32 = run_share_0(_S391.shown_3.word_0);
    point_4.shown_share_0 = select(1.0f - _S405, _S405, _S391.shown_3.on_top_0);
    point_4.x_8 = _S392;
    point_4.y_1 = _S393;
    return point_4;
}

fn surface_met_0( _S406 : u32,  _S407 : f32,  _S408 : f32,  _S409 : f32,  _S410 : vec3<f32>,  _S411 : bool) -> SurfacePoint_0
{
    var _S412 : Sample_0 = sample_at_0(_S406, _S407, _S408, _S411);
    var point_5 : SurfacePoint_0 = surface_of_0(_S406, _S412, _S407, _S408, _S411);
    var _S413 : u32 = select(fabrics_0[_S406].weft_0, fabrics_0[_S406].warp_0, point_5.is_warp_1);
    var _S414 : f32 = select(_S412.crossing_1.weft_1.half_width_1, _S412.crossing_1.warp_1.half_width_1, point_5.is_warp_1) * 1.0154266357421875f;
    var _S415 : f32 = _S412.dive_1.z;
    var _S416 : f32 = _S412.slope_along_0 - (1.0f - _S415) * _S412.dive_1.y / families_0[_S413].height_scale_0;
    var _S417 : f32 = rsqrt_0(_S416 * _S416 + 1.0f);
    var _S418 : f32 = _S410.x;
    var _S419 : f32 = _S410.y;
    var _S420 : f32 = select(_S419, _S418, point_5.is_warp_1);
    var _S421 : f32 = _S410.z;
    var _S422 : f32 = (_S421 / families_0[_S413].height_scale_0 - _S416 * select(_S418, _S419, point_5.is_warp_1)) * _S417;
    var _S423 : f32 = square_1(_S414);
    var _S424 : f32 = sqrt(max(_S423 - square_1(point_5.across_3), 0.0f)) - (_S412.height_7 + _S415 * _S412.dive_1.x - _S409) / families_0[_S413].height_scale_0 * _S417;
    var _S425 : f32 = square_1(_S420) + square_1(_S422) + 9.999999960041972e-13f;
    var _S426 : f32 = point_5.across_3 * _S420 + _S424 * _S422;
    var _S427 : f32 = square_1(point_5.across_3) + square_1(_S424) - _S423;
    var _S428 : f32 = sqrt(max(square_1(_S426) - _S425 * _S427, 0.0f));
    var _S429 : f32 = clamp(select((_S428 - _S426) / _S425, - _S427 / max(_S426 + _S428, 9.999999960041972e-13f), _S426 > 0.0f), - _S414, _S414);
    var _S430 : f32 = point_5.across_3 + _S429 * _S420;
    point_5.across_3 = _S430;
    var _S431 : vec2<f32> = normalize(vec2<f32>(_S430, _S424 + _S429 * _S422));
    var _S432 : f32 = select(-1.0f, 1.0f, point_5.is_warp_1);
    var _S433 : f32 = families_0[_S413].twist_sine_0 * select(1.0f, -1.0f, _S411);
    var _S434 : f32 = _S431.x;
    var _S435 : f32 = _S433 * _S434 * _S417;
    var _S436 : f32 = _S431.y;
    var _S437 : f32 = - _S433 * _S436;
    var _S438 : f32 = families_0[_S413].twist_cosine_0 * _S417 - _S432 * _S416 * _S435;
    var _S439 : f32 = families_0[_S413].height_scale_0 * (families_0[_S413].twist_cosine_0 * _S432 * _S416 * _S417 + _S435);
    var _S440 : f32 = families_0[_S413].height_scale_0 * _S434;
    var _S441 : f32 = - families_0[_S413].height_scale_0 * _S416 * _S417 * _S436;
    point_5.normal_3 = normalize(vec3<f32>(select(_S441, _S440, point_5.is_warp_1), select(_S440, _S441, point_5.is_warp_1), _S417 * _S436));
    point_5.tangent_2 = normalize(vec3<f32>(select(- _S438, _S437, point_5.is_warp_1), select(_S437, _S438, point_5.is_warp_1), _S439));
    var _S442 : f32 = _S414 * angle_of_0(_S431);
    var _S443 : f32 = select(- _S407 - _S429 * _S418, _S408 + _S429 * _S419, point_5.is_warp_1);
    point_5.fibre_across_0 = _S442 * families_0[_S413].twist_cosine_0 + _S443 * _S433;
    point_5.fibre_along_0 = _S443 * families_0[_S413].twist_cosine_0 - _S442 * _S433;
    var _S444 : f32 = 0.00999999977648258f * _S414;
    var _S445 : f32 = - _S444;
    var _S446 : bool = _S429 < _S445;
    var _S447 : f32 = select(_S444, _S445, _S420 < 0.0f);
    var _S448 : f32 = max(_S429, 0.0f);
    point_5.x_8 = point_5.x_8 + select(_S448 * _S418, select(0.0f, _S447, point_5.is_warp_1), _S446);
    point_5.y_1 = point_5.y_1 + select(_S448 * _S419, select(_S447, 0.0f, point_5.is_warp_1), _S446);
    point_5.height_4 = select(_S409 + _S429 * _S421, _S409, _S446);
    return point_5;
}

fn has_hairs_0( _S449 : u32) -> bool
{
    return (((families_0[fabrics_0[_S449].warp_0].hairiness_0) > 0.0f) | (((families_0[fabrics_0[_S449].weft_0].hairiness_0) > 0.0f)));
}

fn hair_at_0( _S450 : u32,  _S451 : vec2<f32>,  _S452 : bool,  _S453 : f32) -> Hair_0
{
    var _S454 : f32 = fabrics_0[_S450].fibre_size_0;
    var _S455 : f32 = 17.0f * fabrics_0[_S450].fibre_size_0;
    var _S456 : f32 = fade_0(_S453, _S455);
    var _S457 : vec2<f32> = _S451 / vec2<f32>(_S455);
    var _S458 : u32 = hash_key_0(select(u32(0), u32(1), _S452), ((fabrics_0[_S450].seed_0) ^ (u32(1013904242))));
    var _S459 : f32 = 1.0f / max(_S453, 0.07999999821186066f * fabrics_0[_S450].fibre_size_0);
    var _S460 : f32 = min(0.63999998569488525f * fabrics_0[_S450].fibre_size_0 * _S459, 1.0f);
    const _S461 : vec2<f32> = vec2<f32>(0.0f, 1.0f);
    var cover_2 : f32 = 0.0f;
    var hair_away_0 : f32 = 0.0f;
    var hair_across_0 : vec2<f32> = _S461;
    var number_2 : u32 = u32(0);
    for(;;)
    {
        if(((_S456 > 0.0f) & ((number_2 < u32(18)))))
        {
        }
        else
        {
            break;
        }
        var _S462 : u32 = number_2 / u32(9);
        var _S463 : u32 = number_2 / u32(3) - u32(3) * _S462;
        var _S464 : vec2<f32> = floor(_S457) + vec2<f32>(f32(number_2 - u32(3) * _S463 - u32(9) * _S462), f32(_S463)) - vec2<f32>(1.0f);
        var _S465 : u32 = hash_bits_0(_S458 + _S462, u32(i32(_S464.x)) * u32(65536) + u32(i32(_S464.y)));
        var _S466 : u32 = hash_bits_0(_S458, _S465);
        var _S467 : vec2<f32> = _S457 - _S464 - vec2<f32>(share_of_0(_S465), share_of_0((_S465 >> (u32(10)))));
        var _S468 : vec2<f32> = sine_cosine_0(3.14159274101257324f * share_of_0((_S465 >> (u32(20)))));
        var _S469 : f32 = mix(5.0f, 16.0f, share_of_0((_S466 >> (u32(10))))) / 17.0f;
        var _S470 : f32 = _S467.x;
        var _S471 : f32 = _S468.y;
        var _S472 : f32 = _S467.y;
        var _S473 : f32 = _S468.x;
        var _S474 : f32 = (_S470 * _S471 + _S472 * _S473) / _S469;
        var _S475 : f32 = 0.69999998807907104f * (2.0f * share_of_0((_S466 >> (u32(20)))) - 1.0f);
        var _S476 : f32 = 2.0f * _S475 * _S474;
        var _S477 : f32 = rsqrt_0(_S476 * _S476 + 1.0f);
        var _S478 : f32 = (_S472 * _S471 - _S470 * _S473 - _S475 * _S469 * _S474 * _S474) * _S477 * 17.0f;
        var _S479 : f32 = clamp((0.31999999284744263f - abs(_S478)) * _S454 * _S459 + 0.5f, 0.0f, _S460);
        if((((((share_of_0(_S466)) < (families_0[select(fabrics_0[_S450].weft_0, fabrics_0[_S450].warp_0, ((((_S466 >> (u32(30)))) & (u32(1)))) == u32(1))].hairiness_0)) & (((abs(_S474)) < 1.0f)))) & ((_S479 > cover_2))))
        {
            var _S480 : vec2<f32> = vec2<f32>(- _S473 - _S476 * _S471, _S471 - _S476 * _S473) * vec2<f32>(_S477);
            cover_2 = _S479;
            hair_away_0 = _S478;
            hair_across_0 = _S480;
        }
        number_2 = number_2 + u32(1);
    }
    var _S481 : f32 = clamp(hair_away_0 * 2.5f, -0.80000001192092896f, 0.80000001192092896f);
    var hair_1 : Hair_0;
    hair_1.cover_0 = _S456 * cover_2;
    hair_1.normal_1 = vec3<f32>(vec2<f32>(_S481) * hair_across_0, sqrt(1.0f - _S481 * _S481));
    hair_1.tangent_0 = vec3<f32>(hair_across_0.y, - hair_across_0.x, 0.0f);
    return hair_1;
}

fn varies_at_0( _S482 : u32,  _S483 : f32) -> bool
{
    return (((((fabrics_0[_S482].fibre_noise_0) > 0.0f) | (((fabrics_0[_S482].colour_noise_0) > 0.0f)))) | (((((fabrics_0[_S482].has_detail_0) != u32(0)) & ((_S483 >= 0.0f))))));
}

fn thread_number_0( _S484 : u32,  _S485 : SurfacePoint_0,  _S486 : f32,  _S487 : f32) -> u32
{
    var _S488 : u32 = select(fabrics_0[_S484].weft_0, fabrics_0[_S484].warp_0, _S485.is_warp_1);
    return u32(i32(floor((select(_S487, _S486, _S485.is_warp_1) - _S485.across_3) / families_0[_S488].period_0)) * i32(families_0[_S488].count_0) + i32(select(_S485.weft_thread_0, _S485.warp_thread_0, _S485.is_warp_1))) * u32(2) + select(u32(0), u32(1), _S485.is_warp_1);
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

fn fibre_noise_at_0( _S489 : u32,  _S490 : u32,  _S491 : SurfacePoint_0,  _S492 : u32,  _S493 : f32) -> FibreNoise_0
{
    var _S494 : f32 = 5.0f * fabrics_0[_S489].fibre_size_0;
    var _S495 : vec2<f32> = wave_noise_0(hash_key_0(_S492, ((fabrics_0[_S489].seed_0) ^ (u32(458671337)))), _S491.fibre_along_0 / (25.0f * fabrics_0[_S489].fibre_size_0));
    var _S496 : f32 = _S491.fibre_across_0 + families_0[_S490].fibre_tilt_0 * 0.5f * 25.0f * fabrics_0[_S489].fibre_size_0 * _S495.x;
    var _S497 : vec3<f32> = fibre_cell_0(_S496, _S491.fibre_along_0, fabrics_0[_S489].fibre_size_0);
    var noise_0 : FibreNoise_0;
    noise_0.bundle_0 = cell_noise_0(hash_key_0(_S492, ((fabrics_0[_S489].seed_0) ^ (u32(1757159915)))), fibre_cell_0(_S496, _S491.fibre_along_0, _S494));
    noise_0.bundle_weight_0 = fade_0(_S493, _S494);
    noise_0.fibre_0 = cell_noise_0(hash_key_0(_S492, ((fabrics_0[_S489].seed_0) ^ (u32(48610963)))), _S497);
    noise_0.fibre_weight_0 = fade_0(_S493, fabrics_0[_S489].fibre_size_0);
    noise_0.offset_1 = _S497.z;
    noise_0.slope_2 = 0.5f * _S495.y;
    return noise_0;
}

fn detail_gain_0( _S498 : u32,  _S499 : u32,  _S500 : SurfacePoint_0,  _S501 : vec2<f32>,  _S502 : bool,  _S503 : u32,  _S504 : f32) -> vec2<f32>
{
    var _S505 : vec2<f32> = vec2<f32>(0.0f);
    var gain_2 : vec2<f32>;
    if((families_0[_S499].has_plies_0) > 0.0f)
    {
        gain_2 = vec2<f32>((0.60000002384185791f * fade_0(_S504, 1.0f / families_0[_S499].plies_per_mm_0))) * vec2<f32>(0.20000000298023224f - square_1(square_1(ply_offset_0(_S499, _S500, _S502))), 0.20000000298023224f);
    }
    else
    {
        gain_2 = _S505;
    }
    if((families_0[_S499].fibre_tone_0) > 0.0f)
    {
        var _S506 : FibreNoise_0 = fibre_noise_at_0(_S498, _S499, _S500, _S503, _S504);
        gain_2 = gain_2 + vec2<f32>(families_0[_S499].fibre_tone_0) * vec2<f32>(_S506.bundle_weight_0 * _S506.bundle_0.y + _S506.fibre_weight_0 * _S506.fibre_0.y, _S506.bundle_weight_0 + _S506.fibre_weight_0);
    }
    if((families_0[_S499].slub_0) > 0.0f)
    {
        gain_2 = gain_2 + vec2<f32>((0.25f * families_0[_S499].slub_0 * fade_0(_S504, 1.0f / families_0[_S499].slubs_per_mm_0))) * vec2<f32>(wave_noise_0(hash_key_0(_S503, ((fabrics_0[_S498].seed_0) ^ (u32(1373058189)))), select(- _S501.x, _S501.y, _S500.is_warp_1) * families_0[_S499].slubs_per_mm_0).x * mix(0.40000000596046448f, 1.0f, min(square_1(_S500.across_3 * families_0[_S499].per_half_width_0), 1.0f)), 1.0f);
    }
    return gain_2;
}

fn vary_albedos_0( _S507 : u32,  _S508 : Albedos_0,  _S509 : u32,  _S510 : u32,  _S511 : vec2<f32>) -> Albedos_0
{
    var _S512 : vec3<f32> = max(_S508.specular_reflect_0, _S508.specular_transmit_0);
    var _S513 : vec3<f32> = _S508.diffuse_reflect_0 + _S508.diffuse_transmit_0;
    var _S514 : vec3<f32> = vec3<f32>(fabrics_0[_S507].layer_bound_0);
    var _S515 : vec3<f32> = vec3<f32>(1.0f);
    var _S516 : vec3<f32> = _S515 - _S514 * _S512;
    var colour_1 : f32 = bounded_gain_0(thread_gain_0(_S509, fabrics_0[_S507].colour_noise_0, fabrics_0[_S507].seed_0), _S513, _S516);
    var _S517 : vec3<f32> = vec3<f32>((colour_1 * (1.0f + flattened_0(_S511.y, vec3<f32>(colour_1) * _S513, _S516) * _S511.x)));
    var _S518 : f32 = bounded_gain_0(fibre_gain_0(_S509, _S510, fabrics_0[_S507].fibre_noise_0, fabrics_0[_S507].seed_0), _S512, min((_S515 - _S517 * _S513) / _S514, vec3<f32>(1.0f)));
    var varied_0 : Albedos_0;
    varied_0.diffuse_reflect_0 = _S517 * _S508.diffuse_reflect_0;
    varied_0.diffuse_transmit_0 = _S517 * _S508.diffuse_transmit_0;
    var _S519 : vec3<f32> = vec3<f32>(_S518);
    varied_0.specular_reflect_0 = _S519 * _S508.specular_reflect_0;
    varied_0.specular_transmit_0 = _S519 * _S508.specular_transmit_0;
    return varied_0;
}

fn varied_at_0( _S520 : u32,  _S521 : SurfacePoint_0,  _S522 : Albedos_0,  _S523 : f32,  _S524 : f32,  _S525 : bool,  _S526 : f32,  _S527 : f32) -> Albedos_0
{
    var _S528 : u32 = thread_number_0(_S520, _S521, _S523, _S524);
    var _S529 : vec3<f32> = fibre_cell_0(_S521.fibre_across_0, _S521.fibre_along_0, fabrics_0[_S520].fibre_size_0);
    var _S530 : vec2<f32> = vec2<f32>(0.0f);
    var gain_3 : vec2<f32>;
    if((((fabrics_0[_S520].has_detail_0) != u32(0)) & ((_S526 >= 0.0f))))
    {
        gain_3 = detail_gain_0(_S520, select(fabrics_0[_S520].weft_0, fabrics_0[_S520].warp_0, _S521.is_warp_1), _S521, vec2<f32>(_S523, _S524), _S525, _S528, _S526) * vec2<f32>(1.0f - _S527, 1.0f);
    }
    else
    {
        gain_3 = _S530;
    }
    return vary_albedos_0(_S520, _S522, _S528, u32(i32(_S529.x)) * u32(65536) + u32(i32(floor(_S529.y))), gain_3);
}

fn turned_frame_0( _S531 : u32,  _S532 : u32,  _S533 : SurfacePoint_0,  _S534 : bool,  _S535 : u32,  _S536 : f32) -> YarnFrame_0
{
    var frame_2 : YarnFrame_0;
    frame_2.normal_4 = _S533.normal_3;
    frame_2.tangent_3 = _S533.tangent_2;
    frame_2.loss_0 = 0.0f;
    if((families_0[_S532].has_plies_0) > 0.0f)
    {
        var _S537 : f32 = fade_0(_S536, 1.0f / families_0[_S532].plies_per_mm_0);
        var _S538 : f32 = _S537 * 0.41999998688697815f * ply_offset_0(_S532, _S533, _S534);
        var _S539 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S540 : vec3<f32> = vec3<f32>(families_0[_S532].ply_cosine_0);
        var _S541 : vec3<f32> = vec3<f32>(select(families_0[_S532].ply_sine_0, - families_0[_S532].ply_sine_0, _S534));
        var _S542 : vec3<f32> = _S540 * _S539 + _S541 * frame_2.tangent_3;
        var _S543 : vec3<f32> = vec3<f32>(sqrt(1.0f - _S538 * _S538));
        var _S544 : vec3<f32> = vec3<f32>(_S538);
        frame_2.tangent_3 = _S540 * (_S540 * frame_2.tangent_3 - _S541 * _S539) + _S541 * (_S543 * _S542 - _S544 * frame_2.normal_4);
        frame_2.normal_4 = _S543 * frame_2.normal_4 + _S544 * _S542;
        frame_2.loss_0 = _S537 * _S537 * 0.41999998688697815f * 0.41999998688697815f / 6.0f;
    }
    var _S545 : f32 = families_0[_S532].fibre_tilt_0;
    if((families_0[_S532].fibre_tilt_0) > 0.0f)
    {
        var _S546 : FibreNoise_0 = fibre_noise_at_0(_S531, _S532, _S533, _S535, _S536);
        var _S547 : f32 = 1.09858846664428711f * _S545 * (_S546.bundle_weight_0 * _S546.bundle_0.x + _S546.fibre_weight_0 * (_S546.fibre_0.x + _S546.offset_1));
        var _S548 : f32 = _S545 * (1.42099642753601074f * (_S546.bundle_weight_0 * _S546.bundle_0.y + _S546.fibre_weight_0 * _S546.fibre_0.y) - _S546.bundle_weight_0 * _S546.slope_2);
        var _S549 : f32 = square_1(_S546.fibre_weight_0);
        frame_2.loss_0 = frame_2.loss_0 + 0.5f * _S545 * _S545 * ((0.24761904776096344f * (square_1(_S546.bundle_weight_0) + _S549) + _S549 / 3.0f) * 1.09858846664428711f * 1.09858846664428711f);
        var _S550 : vec3<f32> = cross(frame_2.tangent_3, frame_2.normal_4);
        var _S551 : vec2<f32> = sine_cosine_0(_S547);
        var _S552 : vec2<f32> = sine_cosine_0(_S548);
        var _S553 : vec3<f32> = vec3<f32>(_S551.y);
        var _S554 : vec3<f32> = vec3<f32>(_S551.x);
        var _S555 : vec3<f32> = _S553 * _S550 - _S554 * frame_2.normal_4;
        frame_2.normal_4 = _S553 * frame_2.normal_4 + _S554 * _S550;
        frame_2.tangent_3 = vec3<f32>(_S552.y) * frame_2.tangent_3 + vec3<f32>(_S552.x) * _S555;
    }
    return frame_2;
}

fn yarn_point_of_0( _S556 : u32,  _S557 : SurfacePoint_0,  _S558 : bool,  _S559 : bool,  _S560 : f32) -> YarnPoint_0
{
    var _S561 : u32 = select(fabrics_0[_S556].weft_0, fabrics_0[_S556].warp_0, _S557.is_warp_1);
    var _S562 : bool = (((fabrics_0[_S556].has_detail_0) != u32(0)) & ((_S560 >= 0.0f)));
    var _S563 : vec3<f32> = vec3<f32>(0.0f);
    var _S564 : Hair_0 = Hair_x24init_0(0.0f, _S563, _S563);
    var _S565 : bool;
    if(_S562)
    {
        _S565 = has_hairs_0(_S556);
    }
    else
    {
        _S565 = false;
    }
    var hair_2 : Hair_0;
    if(_S565)
    {
        hair_2 = hair_at_0(_S556, vec2<f32>(_S557.x_8, _S557.y_1), _S558, _S560);
    }
    else
    {
        hair_2 = _S564;
    }
    var albedos_3 : Albedos_0 = albedos_of_0(_S561, select(_S557.weft_thread_0, _S557.warp_thread_0, _S557.is_warp_1));
    var albedos_4 : Albedos_0;
    if(varies_at_0(_S556, _S560))
    {
        albedos_4 = varied_at_0(_S556, _S557, albedos_3, _S557.x_8, _S557.y_1, _S558, _S560, hair_2.cover_0);
    }
    else
    {
        albedos_4 = albedos_3;
    }
    var point_6 : YarnPoint_0;
    point_6.back_6 = _S558;
    point_6.hole_3 = _S559;
    point_6.is_warp_2 = _S557.is_warp_1;
    point_6.x_13 = _S557.x_8;
    point_6.y_6 = _S557.y_1;
    point_6.height_5 = _S557.height_4;
    point_6.normal_8 = _S557.normal_3;
    point_6.tangent_8 = _S557.tangent_2;
    point_6.surface_normal_0 = _S557.normal_3;
    point_6.diffuse_gain_1 = 1.0f;
    if(_S562)
    {
        var _S566 : YarnFrame_0 = turned_frame_0(_S556, _S561, _S557, _S558, thread_number_0(_S556, _S557, _S557.x_8, _S557.y_1), _S560);
        var frame_3 : YarnFrame_0;
        if(has_hairs_0(_S556))
        {
            frame_3 = under_hair_0(_S566, hair_2);
        }
        else
        {
            frame_3 = _S566;
        }
        point_6.normal_8 = frame_3.normal_4;
        point_6.tangent_8 = frame_3.tangent_3;
        point_6.diffuse_gain_1 = diffuse_gain_0(frame_3, fabrics_0[_S556].diffuse_blend_0);
    }
    point_6.roughness_8 = families_0[_S561].roughness_0;
    point_6.albedos_2 = albedos_4;
    return point_6;
}

fn locate_yarn_0( _S567 : u32,  _S568 : SearchQuality_0,  _S569 : f32,  _S570 : f32,  _S571 : vec3<f32>,  _S572 : f32) -> YarnPoint_0
{
    var _S573 : bool = (_S571.z) < 0.0f;
    var _S574 : vec3<f32> = to_face_frame_0(_S571, _S573);
    var _S575 : Hit_0 = first_hit_0(_S567, _S568, _S569, _S570, _S574, _S573);
    return yarn_point_of_0(_S567, surface_met_0(_S567, _S575.x_14, _S575.y_7, _S575.height_6, _S574, _S573), _S573, _S575.hole_4, _S572);
}

fn openness_number_0( _S576 : u32,  _S577 : u32) -> f32
{
    return table_number_0(fabrics_0[_S576].openness_0 + _S577);
}

fn blocked_of_terms_0( _S578 : u32,  _S579 : u32,  _S580 : array<f32, i32(6)>,  _S581 : u32) -> Blocked_0
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
            if(term_0 < _S581)
            {
            }
            else
            {
                break;
            }
            shares_0[share_3] = shares_0[share_3] + openness_number_0(_S578, _S579 + share_3 * _S581 + term_0) * _S580[term_0];
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

fn blocked_at_0( _S582 : u32,  _S583 : bool,  _S584 : bool,  _S585 : f32,  _S586 : f32) -> Blocked_0
{
    var _S587 : f32 = _S586 * openness_number_0(_S582, u32(158));
    var terms_0 : array<f32, i32(6)> = array<f32, i32(6)>( 1.0f, _S585, _S587, _S585 * _S585, _S585 * _S587, _S587 * _S587 );
    return blocked_of_terms_0(_S582, u32(60) + (select(u32(0), u32(2), _S584) + select(u32(1), u32(0), _S583)) * u32(18), terms_0, u32(6));
}

fn scattered_by_0( _S588 : u32,  _S589 : Albedos_0,  _S590 : u32,  _S591 : vec3<f32>) -> Scattered_0
{
    var _S592 : u32 = u32(159) + u32(2) * _S590;
    var yarn_3 : Scattered_0;
    yarn_3.back_5 = _S591 * _S589.diffuse_reflect_0 + vec3<f32>(openness_number_0(_S588, _S592)) * _S589.specular_reflect_0;
    yarn_3.through_0 = _S591 * _S589.diffuse_transmit_0 + vec3<f32>(openness_number_0(_S588, _S592 + u32(1))) * _S589.specular_transmit_0;
    return yarn_3;
}

fn sent_0( _S593 : u32,  _S594 : u32,  _S595 : vec3<f32>,  _S596 : vec3<f32>,  _S597 : vec3<f32>,  _S598 : vec3<f32>,  _S599 : ptr<function, vec3<f32>>,  _S600 : ptr<function, vec3<f32>>)
{
    var _S601 : u32 = u32(146) + u32(4) * _S594;
    var _S602 : f32 = openness_number_0(_S593, _S601 + u32(1));
    var _S603 : f32 = openness_number_0(_S593, _S601 + u32(2));
    var _S604 : vec3<f32> = vec3<f32>(1.0f);
    var _S605 : vec3<f32> = _S604 - _S597 * vec3<f32>(openness_number_0(_S593, _S601));
    var _S606 : vec3<f32> = _S604 - _S598 * vec3<f32>(openness_number_0(_S593, _S601 + u32(3)));
    var _S607 : vec3<f32> = _S604 / (_S605 * _S606 - _S597 * _S598 * vec3<f32>((_S602 * _S603)));
    (*_S599) = (_S595 * _S606 + _S597 * vec3<f32>(_S602) * _S596) * _S607;
    (*_S600) = (_S596 * _S605 + _S598 * vec3<f32>(_S603) * _S595) * _S607;
    return;
}

fn face_sends_0( _S608 : u32,  _S609 : u32,  _S610 : Scattered_0,  _S611 : Scattered_0) -> FaceSends_0
{
    var _S612 : u32 = u32(2) * _S609;
    var _S613 : u32 = u32(142) + _S612;
    var _S614 : f32 = openness_number_0(_S608, _S613);
    var _S615 : f32 = openness_number_0(_S608, _S613 + u32(1));
    var _S616 : vec3<f32> = vec3<f32>((1.0f - _S614)) * _S610.back_5;
    var _S617 : vec3<f32> = vec3<f32>((1.0f - _S615)) * _S611.back_5;
    var sends_1 : FaceSends_0;
    var _S618 : u32 = u32(154) + _S612;
    var _S619 : f32 = openness_number_0(_S608, _S618);
    sends_1.blocks_warp_0 = _S619;
    var _S620 : f32 = openness_number_0(_S608, _S618 + u32(1));
    sends_1.blocks_weft_0 = _S620;
    sends_1.open_0 = _S619 * _S614 + _S620 * _S615;
    var _S621 : vec3<f32> = vec3<f32>(_S614) * _S610.back_5;
    var _S622 : vec3<f32> = vec3<f32>(_S615) * _S611.back_5;
    var _S623 : vec3<f32> = sends_1.sky_warp_0;
    var _S624 : vec3<f32> = sends_1.sky_weft_0;
    sent_0(_S608, _S609, _S621, _S622, _S616, _S617, &(_S623), &(_S624));
    sends_1.sky_warp_0 = _S623;
    sends_1.sky_weft_0 = _S624;
    var _S625 : vec3<f32> = sends_1.crossing_warp_0;
    var _S626 : vec3<f32> = sends_1.crossing_weft_0;
    sent_0(_S608, _S609, _S610.through_0, _S611.through_0, _S616, _S617, &(_S625), &(_S626));
    sends_1.crossing_warp_0 = _S625;
    sends_1.crossing_weft_0 = _S626;
    return sends_1;
}

fn interior_of_0( _S627 : u32,  _S628 : vec3<f32>,  _S629 : bool) -> Interior_0
{
    var _S630 : Scattered_0 = scattered_by_0(_S627, table_albedos_0(families_0[fabrics_0[_S627].warp_0].colour_mean_0), u32(0), _S628);
    var _S631 : Scattered_0 = scattered_by_0(_S627, table_albedos_0(families_0[fabrics_0[_S627].weft_0].colour_mean_0), u32(1), _S628);
    var _S632 : FaceSends_0 = face_sends_0(_S627, select(u32(0), u32(1), _S629), _S630, _S631);
    var _S633 : FaceSends_0 = face_sends_0(_S627, select(u32(1), u32(0), _S629), _S630, _S631);
    var _S634 : vec3<f32> = vec3<f32>(_S632.blocks_warp_0);
    var _S635 : vec3<f32> = vec3<f32>(_S632.blocks_weft_0);
    var _S636 : vec3<f32> = _S634 * _S632.crossing_warp_0 + _S635 * _S632.crossing_weft_0;
    var _S637 : vec3<f32> = vec3<f32>(_S633.blocks_warp_0);
    var _S638 : vec3<f32> = vec3<f32>(_S633.blocks_weft_0);
    var _S639 : vec3<f32> = _S637 * _S633.crossing_warp_0 + _S638 * _S633.crossing_weft_0;
    var _S640 : f32 = 1.0f - _S632.open_0;
    var _S641 : f32 = 1.0f - _S633.open_0;
    var _S642 : vec3<f32> = vec3<f32>(1.0f);
    var _S643 : vec3<f32> = _S642 / (_S642 - _S636 * _S639 * vec3<f32>((_S640 * _S641)));
    var _S644 : vec3<f32> = _S639 * (vec3<f32>(_S632.open_0) + vec3<f32>(_S640) * (_S634 * _S632.sky_warp_0 + _S635 * _S632.sky_weft_0)) * _S643;
    var _S645 : vec3<f32> = _S636 * (vec3<f32>(_S633.open_0) + vec3<f32>(_S641) * (_S637 * _S633.sky_warp_0 + _S638 * _S633.sky_weft_0)) * _S643;
    var _S646 : FaceRadiance_0 = face_radiance_0(_S632, _S633.open_0, _S644, _S645);
    var _S647 : FaceRadiance_0 = face_radiance_0(_S633, _S632.open_0, _S645, _S644);
    var interior_1 : Interior_0;
    interior_1.warp_3 = _S646.warp_2;
    interior_1.weft_3 = _S646.weft_2;
    interior_1.leaked_1 = _S646.leaked_0;
    interior_1.far_1 = _S647.mean_0;
    interior_1.far_leaked_0 = _S647.leaked_0;
    return interior_1;
}

fn bounced_at_0( _S648 : u32,  _S649 : YarnPoint_0,  _S650 : vec3<f32>) -> Bounced_0
{
    var nothing_0 : Bounced_0;
    var _S651 : vec3<f32> = vec3<f32>(0.0f);
    nothing_0.reflected_0 = _S651;
    nothing_0.transmitted_0 = _S651;
    if((((fabrics_0[_S648].openness_0) == u32(4294967295)) | ((_S649.hole_3))))
    {
        return nothing_0;
    }
    return bounced_by_0(blocked_at_0(_S648, _S649.is_warp_2, _S649.back_6, _S649.surface_normal_0.z, _S649.height_5), scattered_by_0(_S648, _S649.albedos_2, select(u32(1), u32(0), _S649.is_warp_2), _S650), interior_of_0(_S648, _S650, _S649.back_6));
}

fn light_sample_count_0() -> u32
{
    return frame_record_0.lights_0 + frame_record_0.environment_samples_0;
}

fn visibility_at_0( _S652 : u32,  _S653 : vec2<u32>) -> f32
{
    if((frame_record_0.casts_shadows_0) == u32(0))
    {
        return 1.0f;
    }
    return visibilities_0[(_S652 * frame_record_0.height_0 + _S653.y) * frame_record_0.width_0 + _S653.x];
}

struct LightSample_0
{
     towards_0 : vec3<f32>,
     irradiance_1 : vec3<f32>,
     distance_3 : f32,
};

fn environment_texel_0( _S654 : u32,  _S655 : u32) -> vec3<f32>
{
    var _S656 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S654 * frame_record_0.environment_columns_0 + _S655);
    return vec3<f32>(scene_number_0(_S656), scene_number_0(_S656 + u32(1)), scene_number_0(_S656 + u32(2)));
}

fn sample_environment_0( _S657 : vec2<f32>,  _S658 : ptr<function, vec3<f32>>) -> vec3<f32>
{
    var _S659 : u32 = frame_record_0.environment_rows_0;
    var _S660 : Choice_0 = choose_0(frame_record_0.environment_table_0, frame_record_0.environment_rows_0, _S657.y);
    var _S661 : u32 = frame_record_0.environment_columns_0;
    var _S662 : Choice_0 = choose_0(frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + _S660.index_6 * (frame_record_0.environment_columns_0 + u32(1)), frame_record_0.environment_columns_0, _S657.x);
    var _S663 : vec3<f32> = environment_texel_0(_S660.index_6, _S662.index_6);
    (*_S658) = _S663 * vec3<f32>((frame_record_0.environment_total_0 / max(mean_1(_S663), 9.99999968265522539e-21f)));
    var _S664 : f32 = 3.14159274101257324f / f32(_S659);
    var _S665 : f32 = mix(sine_cosine_0(f32(_S660.index_6) * _S664).y, sine_cosine_0(f32(_S660.index_6 + u32(1)) * _S664).y, _S660.remainder_0);
    var _S666 : f32 = sqrt(max(1.0f - _S665 * _S665, 0.0f));
    var _S667 : vec2<f32> = sine_cosine_0((f32(_S662.index_6) + _S662.remainder_0) * (6.28318548202514648f / f32(_S661)));
    var _S668 : f32 = _S666 * _S667.x;
    var _S669 : f32 = - _S666 * _S667.y;
    return vec3<f32>(frame_record_0.environment_cosine_0 * _S668 + frame_record_0.environment_sine_0 * _S669, _S665, frame_record_0.environment_cosine_0 * _S669 - frame_record_0.environment_sine_0 * _S668);
}

fn light_sample_0( _S670 : u32,  _S671 : vec2<u32>,  _S672 : vec3<f32>) -> LightSample_0
{
    var sample_1 : LightSample_0;
    sample_1.distance_3 = 1.00000001504746622e+30f;
    var _S673 : u32 = frame_record_0.lights_0;
    if(_S670 >= (frame_record_0.lights_0))
    {
        var weight_0 : vec3<f32>;
        var _S674 : vec3<f32> = sample_environment_0(pixel_sequence_0(_S671, frame_record_0.pass_number_0 * frame_record_0.environment_samples_0 + (_S670 - _S673), u32(3)), &(weight_0));
        sample_1.towards_0 = _S674;
        sample_1.irradiance_1 = weight_0 / vec3<f32>(f32(frame_record_0.environment_samples_0));
        return sample_1;
    }
    var _S675 : Light_0 = scene_light_0(frame_record_0.light_records_0 + u32(7) * _S670);
    sample_1.irradiance_1 = vec3<f32>(_S675.red_0, _S675.green_0, _S675.blue_0);
    sample_1.towards_0 = vec3<f32>(_S675.x_9, _S675.y_2, _S675.z_1);
    if((_S675.is_point_0) != u32(0))
    {
        var _S676 : vec3<f32> = sample_1.towards_0 - _S672;
        var _S677 : f32 = max(square_0(_S676), 9.999999960041972e-13f);
        sample_1.distance_3 = sqrt(_S677);
        sample_1.irradiance_1 = sample_1.irradiance_1 / vec3<f32>(_S677);
        sample_1.towards_0 = normalize(_S676);
    }
    return sample_1;
}

fn scattered_0( _S678 : u32,  _S679 : YarnPoint_0,  _S680 : vec3<f32>,  _S681 : vec3<f32>) -> vec3<f32>
{
    var _S682 : vec3<f32> = vec3<f32>(0.0f);
    var _S683 : bool = !_S679.hole_3;
    var _S684 : f32 = _S680.z;
    var value_1 : vec3<f32>;
    if((_S683 & ((_S684 > 0.0f))))
    {
        value_1 = _S679.albedos_2.diffuse_reflect_0 * vec3<f32>(_S679.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0(_S680, _S679.normal_8, fabrics_0[_S678].diffuse_blend_0)) + _S679.albedos_2.specular_reflect_0 * vec3<f32>(reflection_0(_S680, _S681, _S679.normal_8, _S679.tangent_8, _S679.roughness_8, fabrics_0[_S678].optical_depth_0));
    }
    else
    {
        if((_S683 & ((_S684 < 0.0f))))
        {
            value_1 = _S679.albedos_2.diffuse_transmit_0 * vec3<f32>(_S679.diffuse_gain_1) * vec3<f32>(diffuse_reflection_0((vec3<f32>(0) - _S680), _S679.normal_8, fabrics_0[_S678].diffuse_blend_0)) + _S679.albedos_2.specular_transmit_0 * vec3<f32>(transmission_1(_S680, _S681, _S679.normal_8, _S679.tangent_8, _S679.roughness_8, fabrics_0[_S678].optical_depth_0));
        }
        else
        {
            value_1 = _S682;
        }
    }
    var _S685 : f32 = fabrics_0[_S678].sheen_strength_0;
    if((fabrics_0[_S678].sheen_strength_0) <= 0.0f)
    {
        return value_1;
    }
    var _S686 : vec2<f32> = sheen_with_transmittance_0(_S680, _S681, _S685, fabrics_0[_S678].sheen_roughness_0);
    return vec3<f32>(_S686.y) * value_1 + vec3<f32>(_S686.x);
}

fn surface_at_0( _S687 : u32,  _S688 : f32,  _S689 : f32,  _S690 : bool) -> SurfacePoint_0
{
    return surface_of_0(_S687, sample_at_0(_S687, _S688, _S689, _S690), _S688, _S689, _S690);
}

fn unoccluded_0( _S691 : u32,  _S692 : SearchQuality_0,  _S693 : f32,  _S694 : f32,  _S695 : f32,  _S696 : vec3<f32>,  _S697 : bool) -> bool
{
    if((_S696.z) <= 0.0f)
    {
        return false;
    }
    return is_free_0(_S691, _S692, vec3<f32>(_S693, _S694, _S695 + fabrics_0[_S691].lift_0), _S696, _S697, max_height_along_0(_S691, _S693, _S694, _S695, _S696, _S697));
}

fn is_lit_0( _S698 : u32,  _S699 : SearchQuality_0,  _S700 : YarnPoint_0,  _S701 : vec3<f32>) -> bool
{
    if(_S700.hole_3)
    {
        return true;
    }
    var _S702 : vec3<f32> = to_face_frame_0(_S701, _S700.back_6);
    var _S703 : f32 = _S702.z;
    var _S704 : bool = _S703 < 0.0f;
    var normal_9 : vec3<f32>;
    var height_11 : f32;
    if(_S704)
    {
        var _S705 : SurfacePoint_0 = surface_at_0(_S698, _S700.x_13, _S700.y_6, !_S700.back_6);
        normal_9 = _S705.normal_3;
        height_11 = _S705.height_4;
    }
    else
    {
        normal_9 = _S700.surface_normal_0;
        height_11 = _S700.height_5;
    }
    var _S706 : vec3<f32> = vec3<f32>(_S702.xy, abs(_S703));
    if((dot(normal_9, _S706)) <= 0.0f)
    {
        return false;
    }
    return unoccluded_0(_S698, _S699, _S700.x_13, _S700.y_6, height_11, _S706, (_S700.back_6) != _S704);
}

fn evaluate_with_0( _S707 : u32,  _S708 : SearchQuality_0,  _S709 : YarnPoint_0,  _S710 : Bounced_0,  _S711 : vec3<f32>,  _S712 : vec3<f32>) -> vec3<f32>
{
    var _S713 : vec3<f32> = to_face_frame_0(_S712, _S709.back_6);
    var _S714 : vec3<f32> = scattered_0(_S707, _S709, to_face_frame_0(_S711, _S709.back_6), _S713);
    var _S715 : bool;
    if((max(_S714.x, max(_S714.y, _S714.z))) <= 0.0f)
    {
        _S715 = true;
    }
    else
    {
        _S715 = !is_lit_0(_S707, _S708, _S709, _S711);
    }
    var value_2 : vec3<f32>;
    if(_S715)
    {
        value_2 = vec3<f32>(0.0f);
    }
    else
    {
        value_2 = _S714;
    }
    var between_1 : vec3<f32> = bounced_value_0(_S710, _S711, _S712);
    var _S716 : f32 = fabrics_0[_S707].sheen_strength_0;
    var between_2 : vec3<f32>;
    if((fabrics_0[_S707].sheen_strength_0) > 0.0f)
    {
        between_2 = between_1 * vec3<f32>((1.0f - _S716 * sheen_lobe_0(abs(_S713.z), fabrics_0[_S707].sheen_roughness_0).z));
    }
    else
    {
        between_2 = between_1;
    }
    return value_2 + between_2;
}

fn straight_through_0( _S717 : u32,  _S718 : YarnPoint_0,  _S719 : vec3<f32>) -> f32
{
    if(!_S718.hole_3)
    {
        return 0.0f;
    }
    var _S720 : f32 = fabrics_0[_S717].sheen_strength_0;
    if((fabrics_0[_S717].sheen_strength_0) <= 0.0f)
    {
        return 1.0f;
    }
    return 1.0f - _S720 * sheen_lobe_0(abs(_S719.z), fabrics_0[_S717].sheen_roughness_0).z;
}

fn light_of_point_0( _S721 : u32,  _S722 : VisiblePoint_0,  _S723 : vec2<u32>,  _S724 : vec3<f32>,  _S725 : vec2<f32>) -> vec4<f32>
{
    var _S726 : SearchQuality_0 = default_quality_0();
    var _S727 : vec3<f32> = to_local_0(_S722, _S722.view_0);
    var footprint_0 : Footprint_0;
    footprint_0.centre_0 = _S725;
    footprint_0.dx_0 = _S722.draft_dx_0;
    footprint_0.dy_0 = _S722.draft_dy_0;
    var _S728 : YarnPoint_0 = locate_yarn_0(_S721, _S726, _S725.x, _S725.y, _S727, Footprint_spread_side_0(footprint_0));
    var point_7 : YarnPoint_0 = _S728;
    var _S729 : Bounced_0 = bounced_at_0(_S721, _S728, _S724);
    point_7.albedos_2 = tinted_0(point_7.albedos_2, _S724);
    var _S730 : vec3<f32> = vec3<f32>(0.0f);
    var number_3 : u32 = u32(0);
    var radiance_1 : vec3<f32> = _S730;
    for(;;)
    {
        if(number_3 < (light_sample_count_0()))
        {
        }
        else
        {
            break;
        }
        var _S731 : f32 = visibility_at_0(number_3, _S723);
        if(_S731 <= 0.0f)
        {
            number_3 = number_3 + u32(1);
            continue;
        }
        var _S732 : LightSample_0 = light_sample_0(number_3, _S723, _S722.position_0);
        radiance_1 = radiance_1 + vec3<f32>(_S731) * _S732.irradiance_1 * evaluate_with_0(_S721, _S726, point_7, _S729, to_local_0(_S722, _S732.towards_0), _S727);
        number_3 = number_3 + u32(1);
    }
    return vec4<f32>(radiance_1, 1.0f - straight_through_0(_S721, point_7, _S727));
}

@compute
@workgroup_size(8, 8, 1)
fn shade_points(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S733 : u32 = id_0.x;
    var _S734 : bool;
    if(_S733 >= (frame_record_0.width_0))
    {
        _S734 = true;
    }
    else
    {
        _S734 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S734)
    {
        return;
    }
    var _S735 : vec2<u32> = id_0.xy;
    var _S736 : u32 = id_0.y * frame_record_0.width_0 + _S733;
    var _S737 : u32 = layers_0[_S736].face_0;
    if((layers_0[_S736].face_0) == u32(0))
    {
        return;
    }
    var _S738 : u32 = _S737 - u32(1);
    var _S739 : u32 = fabric_of_0(_S738);
    var _S740 : VisiblePoint_0 = visible_point_0(_S739, _S738, _S735);
    var _S741 : vec3<f32> = filtered_albedo_0(_S739, _S740);
    var _S742 : vec4<f32> = vec4<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var sum_0 : vec4<f32> = _S742;
    for(;;)
    {
        if(k_0 < (frame_record_0.samples_0))
        {
        }
        else
        {
            break;
        }
        var _S743 : vec2<f32> = pixel_sequence_0(_S735, frame_record_0.pass_number_0 * frame_record_0.samples_0 + k_0, u32(1)) - vec2<f32>(0.5f);
        var sum_1 : vec4<f32> = sum_0 + light_of_point_0(_S739, _S740, _S735, _S741, _S740.draft_0 + vec2<f32>(_S743.x) * _S740.draft_dx_0 + vec2<f32>(_S743.y) * _S740.draft_dy_0);
        k_0 = k_0 + u32(1);
        sum_0 = sum_1;
    }
    accumulate_0(_S736, sum_0 / vec4<f32>(f32(frame_record_0.samples_0)));
    return;
}

