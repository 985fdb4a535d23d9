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
    @align(4) auxiliary_0 : u32,
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
    @align(4) grazing_gain_0 : f32,
    @align(4) grazing_loss_0 : f32,
    @align(4) sheen_strength_0 : f32,
    @align(4) sheen_roughness_0 : f32,
    @align(4) fibre_noise_0 : f32,
    @align(4) colour_noise_0 : f32,
    @align(4) seed_0 : u32,
    @align(4) layer_bound_0 : f32,
    @align(4) fibre_size_0 : f32,
    @align(4) is_irregular_0 : u32,
    @align(4) warp_on_top_0 : f32,
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
    @align(4) planes_0 : u32,
    @align(4) plane_records_0 : u32,
    @align(4) plane_axes_0 : u32,
    @align(4) stacks_0 : u32,
    @align(4) plane_orders_0 : u32,
    @align(4) regions_0 : u32,
    @align(4) plane_shares_0 : u32,
    @align(4) is_coloured_0 : u32,
};

@binding(0) @group(0) var<storage, read> fabrics_0 : array<Fabric_std430_0>;

@binding(7) @group(0) var<storage, read_write> radiance_0 : array<vec4<f32>>;

fn firstbitlow_0( value_0 : u32) -> u32
{
    var _S1 : u32 = firstTrailingBit(value_0);
    return _S1;
}

fn select_vector_0( condition_0 : bool,  yes_0 : vec2<f32>,  no_0 : vec2<f32>) -> vec2<f32>
{
    var chosen_0 : vec2<f32>;
    chosen_0[i32(0)] = select(no_0[i32(0)], yes_0[i32(0)], condition_0);
    chosen_0[i32(1)] = select(no_0[i32(1)], yes_0[i32(1)], condition_0);
    return chosen_0;
}

fn select_vector_1( condition_1 : bool,  yes_1 : vec3<f32>,  no_1 : vec3<f32>) -> vec3<f32>
{
    var chosen_1 : vec3<f32>;
    chosen_1[i32(0)] = select(no_1[i32(0)], yes_1[i32(0)], condition_1);
    chosen_1[i32(1)] = select(no_1[i32(1)], yes_1[i32(1)], condition_1);
    chosen_1[i32(2)] = select(no_1[i32(2)], yes_1[i32(2)], condition_1);
    return chosen_1;
}

fn arc_tangent_quotient_0( x_0 : f32,  y_0 : f32) -> f32
{
    return ((((((0.0f * x_0 + 0.00809729471802711f) * x_0 + -0.0377517081797123f) * x_0 + 0.08475969731807709f) * x_0 + -0.13537675142288208f) * x_0 + 0.19895026087760925f) * x_0 + -0.33327975869178772f) * x_0 + 0.99999970197677612f;
}

fn arc_tangent_of_ratio_0( ratio_0 : f32) -> f32
{
    return ratio_0 * arc_tangent_quotient_0(ratio_0 * ratio_0, 0.0f);
}

fn arc_tangent_0( y_1 : f32,  x_1 : f32) -> f32
{
    var _S2 : f32 = abs(x_1);
    var _S3 : f32 = abs(y_1);
    var angle_0 : f32 = arc_tangent_of_ratio_0(min(_S2, _S3) / max(max(_S2, _S3), 1.00000000317107685e-30f));
    var angle_1 : f32 = select(angle_0, 1.57079637050628662f - angle_0, _S3 > _S2);
    var angle_2 : f32 = select(angle_1, 3.14159274101257324f - angle_1, x_1 < 0.0f);
    return select(angle_2, - angle_2, y_1 < 0.0f);
}

fn arc_sine_0( x_2 : f32) -> f32
{
    var _S4 : f32 = abs(x_2);
    var _S5 : bool = _S4 > 0.5f;
    var _S6 : f32 = select(_S4 * _S4, 0.5f * (1.0f - _S4), _S5);
    var _S7 : f32 = select(_S4, sqrt(max(_S6, 0.0f)), _S5);
    var _S8 : f32 = ((((0.04216320067644119f * _S6 + 0.02418131195008755f) * _S6 + 0.04547002539038658f) * _S6 + 0.07495300471782684f) * _S6 + 0.16666752099990845f) * _S6 * _S7 + _S7;
    var _S9 : f32 = select(_S8, 1.57079637050628662f - 2.0f * _S8, _S5);
    return select(_S9, - _S9, x_2 < 0.0f);
}

fn scene_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_0])));
}

struct Light_0
{
     is_point_0 : u32,
     x_3 : f32,
     y_2 : f32,
     z_0 : f32,
     red_0 : f32,
     green_0 : f32,
     blue_0 : f32,
};

fn scene_light_0( first_0 : u32) -> Light_0
{
    var record_0 : Light_0;
    record_0.is_point_0 = scene_words_0[first_0];
    record_0.x_3 = (bitcast<f32>((scene_words_0[first_0 + u32(1)])));
    record_0.y_2 = (bitcast<f32>((scene_words_0[first_0 + u32(2)])));
    record_0.z_0 = (bitcast<f32>((scene_words_0[first_0 + u32(3)])));
    record_0.red_0 = (bitcast<f32>((scene_words_0[first_0 + u32(4)])));
    record_0.green_0 = (bitcast<f32>((scene_words_0[first_0 + u32(5)])));
    record_0.blue_0 = (bitcast<f32>((scene_words_0[first_0 + u32(6)])));
    return record_0;
}

fn scramble_0( value_1 : u32) -> u32
{
    var _S10 : u32 = value_1 * u32(747796405) + u32(2891336453);
    var _S11 : u32 = ((((_S10 >> ((((_S10 >> (u32(28)))) + u32(4))))) ^ (_S10))) * u32(277803737);
    return (((_S11 >> (u32(22)))) ^ (_S11));
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
    var _S12 : u32 = pixel_0.x;
    var _S13 : u32 = pixel_0.y;
    return fract(vec2<f32>(uniform_hash_0(_S12, _S13, stream_2), uniform_hash_0(_S12, _S13, stream_2 + u32(1))) + vec2<f32>(f32((index_1 & (u32(65535))))) * vec2<f32>(0.75487768650054932f, 0.56984031200408936f));
}

fn sine_cosine_0( x_4 : f32) -> vec2<f32>
{
    var _S14 : f32 = floor(x_4 * 0.63661974668502808f + 0.5f);
    var _S15 : f32 = x_4 - _S14 * 1.5703125f - _S14 * 0.00048375129699707f - _S14 * 7.54979012640433211e-08f;
    var _S16 : f32 = _S15 * _S15;
    var _S17 : f32 = ((-0.00019515295571182f * _S16 + 0.00833216123282909f) * _S16 - 0.16666655242443085f) * _S16 * _S15 + _S15;
    var _S18 : f32 = ((0.00002443315679557f * _S16 - 0.00138873164542019f) * _S16 + 0.04166664555668831f) * _S16 * _S16 - 0.5f * _S16 + 1.0f;
    var _S19 : u32 = (u32(i32(_S14)) & (u32(3)));
    var _S20 : vec2<f32> = select_vector_0(((_S19 & (u32(1)))) != u32(0), vec2<f32>(_S18, _S17), vec2<f32>(_S17, _S18));
    var _S21 : f32 = _S20.x;
    var _S22 : f32 = _S20.y;
    return vec2<f32>(select(_S21, - _S21, ((_S19 & (u32(2)))) != u32(0)), select(_S22, - _S22, (((_S19 + u32(1)) & (u32(2)))) != u32(0)));
}

fn sphere_point_0( uniform_0 : vec2<f32>) -> vec3<f32>
{
    var _S23 : f32 = 1.0f - 2.0f * uniform_0.y;
    return vec3<f32>(vec2<f32>(sqrt(max(1.0f - _S23 * _S23, 0.0f))) * sine_cosine_0(6.28318548202514648f * uniform_0.x), _S23);
}

fn inverse_of_0( component_0 : f32) -> f32
{
    return 1.0f / select(9.99999968265522539e-21f, component_0, (abs(component_0)) > 9.99999968265522539e-21f);
}

fn meets_node_0( node_0 : u32,  origin_0 : vec3<f32>,  inverse_0 : vec3<f32>,  nearest_0 : f32,  farthest_0 : f32) -> bool
{
    var _S24 : u32 = u32(6) * (node_0 - u32(1));
    var _S25 : vec3<f32> = (vec3<f32>(scene_number_0(_S24), scene_number_0(_S24 + u32(1)), scene_number_0(_S24 + u32(2))) - origin_0) * inverse_0;
    var _S26 : vec3<f32> = (vec3<f32>(scene_number_0(_S24 + u32(3)), scene_number_0(_S24 + u32(4)), scene_number_0(_S24 + u32(5))) - origin_0) * inverse_0;
    var _S27 : vec3<f32> = min(_S25, _S26);
    var _S28 : vec3<f32> = max(_S25, _S26) * vec3<f32>(1.0000004768371582f);
    return (max(max(_S27.x, _S27.y), max(_S27.z, nearest_0))) <= (min(min(_S28.x, _S28.y), min(_S28.z, farthest_0)));
}

fn following_node_0( node_1 : u32) -> u32
{
    var _S29 : u32 = node_1 + u32(1);
    var _S30 : u32 = (_S29 >> ((firstbitlow_0(_S29))));
    return select(_S30, u32(0), _S30 == u32(1));
}

struct Vertex_0
{
     x_5 : f32,
     y_3 : f32,
     z_1 : f32,
     normal_x_0 : f32,
     normal_y_0 : f32,
     normal_z_0 : f32,
     u_0 : f32,
     v_0 : f32,
};

fn scene_vertex_0( first_1 : u32) -> Vertex_0
{
    var record_1 : Vertex_0;
    record_1.x_5 = (bitcast<f32>((scene_words_0[first_1])));
    record_1.y_3 = (bitcast<f32>((scene_words_0[first_1 + u32(1)])));
    record_1.z_1 = (bitcast<f32>((scene_words_0[first_1 + u32(2)])));
    record_1.normal_x_0 = (bitcast<f32>((scene_words_0[first_1 + u32(3)])));
    record_1.normal_y_0 = (bitcast<f32>((scene_words_0[first_1 + u32(4)])));
    record_1.normal_z_0 = (bitcast<f32>((scene_words_0[first_1 + u32(5)])));
    record_1.u_0 = (bitcast<f32>((scene_words_0[first_1 + u32(6)])));
    record_1.v_0 = (bitcast<f32>((scene_words_0[first_1 + u32(7)])));
    return record_1;
}

fn vertex_at_0( corner_0 : u32) -> Vertex_0
{
    return scene_vertex_0(frame_record_0.vertices_0 + u32(8) * scene_words_0[frame_record_0.corners_0 + corner_0]);
}

fn position_of_0( vertex_0 : Vertex_0) -> vec3<f32>
{
    return vec3<f32>(vertex_0.x_5, vertex_0.y_3, vertex_0.z_1);
}

struct Hit_0
{
     face_1 : u32,
     distance_0 : f32,
     weight_b_0 : f32,
     weight_c_0 : f32,
};

fn meet_face_0( face_2 : u32,  origin_1 : vec3<f32>,  direction_0 : vec3<f32>) -> Hit_0
{
    var _S31 : u32 = u32(3) * face_2;
    var _S32 : vec3<f32> = position_of_0(vertex_at_0(_S31));
    var _S33 : vec3<f32> = position_of_0(vertex_at_0(_S31 + u32(1))) - _S32;
    var _S34 : vec3<f32> = position_of_0(vertex_at_0(_S31 + u32(2))) - _S32;
    var _S35 : vec3<f32> = cross(direction_0, _S34);
    var _S36 : f32 = dot(_S33, _S35);
    var _S37 : bool = (abs(_S36)) > 1.00000000317107685e-30f;
    var _S38 : f32 = 1.0f / select(1.00000000317107685e-30f, _S36, _S37);
    var _S39 : vec3<f32> = origin_1 - _S32;
    var _S40 : vec3<f32> = cross(_S39, _S33);
    var hit_0 : Hit_0;
    var _S41 : f32 = dot(_S39, _S35) * _S38;
    hit_0.weight_b_0 = _S41;
    var _S42 : f32 = dot(direction_0, _S40) * _S38;
    hit_0.weight_c_0 = _S42;
    hit_0.distance_0 = dot(_S34, _S40) * _S38;
    hit_0.face_1 = select(u32(4294967295), face_2, ((((((_S41 >= 0.0f) & ((_S42 >= 0.0f)))) & (((_S41 + _S42) <= 1.0f)))) & (_S37)));
    return hit_0;
}

fn fabric_of_0( face_3 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_3];
}

fn camera_forward_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.forward_x_0, frame_record_0.forward_y_0, frame_record_0.forward_z_0);
}

fn camera_right_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.right_x_0, frame_record_0.right_y_0, frame_record_0.right_z_0);
}

fn camera_up_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.up_x_0, frame_record_0.up_y_0, frame_record_0.up_z_0);
}

fn pixel_direction_0( _S43 : vec2<u32>,  _S44 : vec2<f32>) -> vec3<f32>
{
    return camera_forward_0() + vec3<f32>(((f32(_S43.x) + 0.5f + _S44.x) * 2.0f / f32(frame_record_0.width_0) - 1.0f)) * camera_right_0() + vec3<f32>((1.0f - (f32(_S43.y) + 0.5f + _S44.y) * 2.0f / f32(frame_record_0.height_0))) * camera_up_0();
}

fn environment_texel_0( _S45 : u32,  _S46 : u32) -> vec3<f32>
{
    var _S47 : u32 = frame_record_0.environment_table_0 + frame_record_0.environment_rows_0 + u32(1) + frame_record_0.environment_rows_0 * (frame_record_0.environment_columns_0 + u32(1)) + u32(3) * (_S45 * frame_record_0.environment_columns_0 + _S46);
    return vec3<f32>(scene_number_0(_S47), scene_number_0(_S47 + u32(1)), scene_number_0(_S47 + u32(2)));
}

fn environment_radiance_0( _S48 : vec3<f32>) -> vec3<f32>
{
    var _S49 : f32 = _S48.x;
    var _S50 : f32 = _S48.z;
    var _S51 : f32 = arc_tangent_0(frame_record_0.environment_cosine_0 * _S49 - frame_record_0.environment_sine_0 * _S50, - (frame_record_0.environment_sine_0 * _S49 + frame_record_0.environment_cosine_0 * _S50)) / 6.28318548202514648f;
    var _S52 : u32 = frame_record_0.environment_columns_0;
    var _S53 : f32 = (_S51 - floor(_S51)) * f32(frame_record_0.environment_columns_0) - 0.5f;
    var _S54 : u32 = frame_record_0.environment_rows_0 - u32(1);
    var _S55 : f32 = clamp((0.5f - arc_sine_0(clamp(_S48.y, -1.0f, 1.0f)) / 3.14159274101257324f) * f32(frame_record_0.environment_rows_0) - 0.5f, 0.0f, f32(_S54));
    var _S56 : f32 = floor(_S53);
    var _S57 : u32 = u32(i32(_S56) + i32(frame_record_0.environment_columns_0)) % frame_record_0.environment_columns_0;
    var _S58 : u32 = (_S57 + u32(1)) % _S52;
    var _S59 : u32 = u32(_S55);
    var _S60 : u32 = min(_S59 + u32(1), _S54);
    var _S61 : vec3<f32> = vec3<f32>((_S53 - _S56));
    return mix(mix(environment_texel_0(_S59, _S57), environment_texel_0(_S59, _S58), _S61), mix(environment_texel_0(_S60, _S57), environment_texel_0(_S60, _S58), _S61), vec3<f32>((_S55 - f32(_S59))));
}

fn camera_origin_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.origin_x_0, frame_record_0.origin_y_0, frame_record_0.origin_z_0);
}

fn nearest_hit_0( _S62 : vec3<f32>,  _S63 : vec3<f32>,  _S64 : f32,  _S65 : f32,  _S66 : u32,  _S67 : bool) -> Hit_0
{
    var _S68 : vec3<f32> = vec3<f32>(inverse_of_0(_S63.x), inverse_of_0(_S63.y), inverse_of_0(_S63.z));
    var found_0 : Hit_0;
    found_0.face_1 = u32(4294967295);
    found_0.distance_0 = _S65;
    found_0.weight_b_0 = 0.0f;
    found_0.weight_c_0 = 0.0f;
    var node_2 : u32 = u32(1);
    for(;;)
    {
        if(node_2 != u32(0))
        {
        }
        else
        {
            break;
        }
        var node_3 : u32;
        if(!meets_node_0(node_2, _S62, _S68, _S64, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            var _S69 : u32 = frame_record_0.leaves_0;
            if(node_2 < (frame_record_0.leaves_0))
            {
                node_3 = node_2 * u32(2);
            }
            else
            {
                var _S70 : u32 = frame_record_0.leaf_faces_0 + u32(4) * (node_2 - _S69);
                var _S71 : u32 = following_node_0(node_2);
                var number_0 : u32 = u32(0);
                node_3 = _S71;
                for(;;)
                {
                    if(number_0 < u32(4))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var _S72 : u32 = scene_words_0[_S70 + number_0];
                    if(((_S72 == u32(4294967295)) | ((_S72 == _S66))))
                    {
                        number_0 = number_0 + u32(1);
                        continue;
                    }
                    var _S73 : Hit_0 = meet_face_0(_S72, _S62, _S63);
                    if((((((_S73.face_1) == u32(4294967295)) | (((_S73.distance_0) <= _S64)))) | (((_S73.distance_0) >= (found_0.distance_0)))))
                    {
                        number_0 = number_0 + u32(1);
                        continue;
                    }
                    found_0 = _S73;
                    var _S74 : bool;
                    if(_S67)
                    {
                        _S74 = (fabrics_0[fabric_of_0(_S72)].is_open_0) == u32(0);
                    }
                    else
                    {
                        _S74 = false;
                    }
                    var node_4 : u32;
                    if(_S74)
                    {
                        node_4 = u32(0);
                    }
                    else
                    {
                        node_4 = node_3;
                    }
                    node_3 = node_4;
                    number_0 = number_0 + u32(1);
                }
            }
        }
        node_2 = node_3;
    }
    return found_0;
}

fn ground_light_0( _S75 : vec2<u32>,  _S76 : vec3<f32>) -> f32
{
    var _S77 : vec3<f32> = vec3<f32>(frame_record_0.ground_x_0, frame_record_0.ground_y_0, frame_record_0.ground_z_0);
    var _S78 : vec3<f32> = camera_origin_0();
    var _S79 : f32 = dot(_S77, _S78) - frame_record_0.ground_offset_0;
    var _S80 : f32 = dot(_S77, _S76);
    if(((_S79 <= 0.0f) | ((_S80 >= 0.0f))))
    {
        return 1.0f;
    }
    var _S81 : vec3<f32> = _S78 - vec3<f32>((_S79 / _S80)) * _S76;
    var _S82 : Light_0 = scene_light_0(frame_record_0.light_records_0);
    var _S83 : vec3<f32> = normalize(vec3<f32>(_S82.x_3, _S82.y_2, _S82.z_0) - vec3<f32>(f32(_S82.is_point_0)) * _S81);
    var ray_0 : u32 = u32(0);
    var blocked_0 : f32 = 0.0f;
    for(;;)
    {
        if(ray_0 < u32(4))
        {
        }
        else
        {
            break;
        }
        var _S84 : vec2<f32> = pixel_sequence_0(_S75, frame_record_0.pass_number_0 * u32(4) + ray_0, u32(7));
        var number_1 : vec2<f32> = _S84;
        var _S85 : f32 = _S84.x;
        var _S86 : bool = _S85 >= (frame_record_0.ground_lamp_0);
        number_1[i32(0)] = select(_S85 / frame_record_0.ground_lamp_0, (_S85 - frame_record_0.ground_lamp_0) / (1.0f - frame_record_0.ground_lamp_0), _S86);
        var _S87 : Hit_0 = nearest_hit_0(_S81, select_vector_1(_S86, _S77, _S83) + vec3<f32>(select(0.08730000257492065f, 0.99989998340606689f, _S86)) * sphere_point_0(number_1), frame_record_0.ray_offset_0, 1.00000001504746622e+30f, u32(4294967295), true);
        if((_S87.face_1) != u32(4294967295))
        {
            blocked_0 = blocked_0 + (1.0f - fabrics_0[fabric_of_0(_S87.face_1)].mean_hole_0);
        }
        ray_0 = ray_0 + u32(1);
    }
    return 1.0f - blocked_0 / 4.0f;
}

@compute
@workgroup_size(8, 8, 1)
fn add_background(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S88 : u32 = id_0.x;
    var _S89 : bool;
    if(_S88 >= (frame_record_0.width_0))
    {
        _S89 = true;
    }
    else
    {
        _S89 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S89)
    {
        return;
    }
    var _S90 : u32 = id_0.y * frame_record_0.width_0 + _S88;
    var _S91 : f32 = layers_0[_S90].share_0;
    if((layers_0[_S90].share_0) <= 0.0f)
    {
        return;
    }
    var _S92 : vec2<u32> = id_0.xy;
    var _S93 : vec3<f32> = pixel_direction_0(_S92, vec2<f32>(frame_record_0.jitter_x_0, frame_record_0.jitter_y_0));
    var _S94 : vec3<f32> = vec3<f32>(frame_record_0.background_red_0, frame_record_0.background_green_0, frame_record_0.background_blue_0);
    var background_0 : vec3<f32>;
    if((frame_record_0.shows_environment_0) != u32(0))
    {
        var _S95 : vec3<f32> = environment_radiance_0(normalize(_S93));
        background_0 = _S95;
    }
    else
    {
        background_0 = _S94;
    }
    radiance_0[_S90] = radiance_0[_S90] + vec4<f32>(vec3<f32>(_S91) * (background_0 * vec3<f32>(ground_light_0(_S92, _S93))), 0.0f);
    return;
}

