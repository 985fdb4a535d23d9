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

fn firstbitlow_0( value_0 : u32) -> u32
{
    var _S1 : u32 = firstTrailingBit(value_0);
    return _S1;
}

struct Vertex_0
{
     x_0 : f32,
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
    record_0.x_0 = (bitcast<f32>((scene_words_0[first_0])));
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
    return vec3<f32>(vertex_0.x_0, vertex_0.y_0, vertex_0.z_0);
}

fn inverse_of_0( component_0 : f32) -> f32
{
    return 1.0f / select(9.99999968265522539e-21f, component_0, (abs(component_0)) > 9.99999968265522539e-21f);
}

fn scene_number_0( index_0 : u32) -> f32
{
    return (bitcast<f32>((scene_words_0[index_0])));
}

fn meets_node_0( node_0 : u32,  origin_0 : vec3<f32>,  inverse_0 : vec3<f32>,  nearest_0 : f32,  farthest_0 : f32) -> bool
{
    var _S2 : u32 = u32(6) * (node_0 - u32(1));
    var _S3 : vec3<f32> = (vec3<f32>(scene_number_0(_S2), scene_number_0(_S2 + u32(1)), scene_number_0(_S2 + u32(2))) - origin_0) * inverse_0;
    var _S4 : vec3<f32> = (vec3<f32>(scene_number_0(_S2 + u32(3)), scene_number_0(_S2 + u32(4)), scene_number_0(_S2 + u32(5))) - origin_0) * inverse_0;
    var _S5 : vec3<f32> = min(_S3, _S4);
    var _S6 : vec3<f32> = max(_S3, _S4) * vec3<f32>(1.0000004768371582f);
    return (max(max(_S5.x, _S5.y), max(_S5.z, nearest_0))) <= (min(min(_S6.x, _S6.y), min(_S6.z, farthest_0)));
}

fn following_node_0( node_1 : u32) -> u32
{
    var _S7 : u32 = node_1 + u32(1);
    var _S8 : u32 = (_S7 >> ((firstbitlow_0(_S7))));
    return select(_S8, u32(0), _S8 == u32(1));
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
    var _S9 : u32 = u32(3) * face_2;
    var _S10 : vec3<f32> = position_of_0(vertex_at_0(_S9));
    var _S11 : vec3<f32> = position_of_0(vertex_at_0(_S9 + u32(1))) - _S10;
    var _S12 : vec3<f32> = position_of_0(vertex_at_0(_S9 + u32(2))) - _S10;
    var _S13 : vec3<f32> = cross(direction_0, _S12);
    var _S14 : f32 = dot(_S11, _S13);
    var _S15 : bool = (abs(_S14)) > 1.00000000317107685e-30f;
    var _S16 : f32 = 1.0f / select(1.00000000317107685e-30f, _S14, _S15);
    var _S17 : vec3<f32> = origin_1 - _S10;
    var _S18 : vec3<f32> = cross(_S17, _S11);
    var hit_0 : Hit_0;
    var _S19 : f32 = dot(_S17, _S13) * _S16;
    hit_0.weight_b_0 = _S19;
    var _S20 : f32 = dot(direction_0, _S18) * _S16;
    hit_0.weight_c_0 = _S20;
    hit_0.distance_0 = dot(_S12, _S18) * _S16;
    hit_0.face_1 = select(u32(4294967295), face_2, ((((((_S19 >= 0.0f) & ((_S20 >= 0.0f)))) & (((_S19 + _S20) <= 1.0f)))) & (_S15)));
    return hit_0;
}

fn fabric_of_0( face_3 : u32) -> u32
{
    return scene_words_0[frame_record_0.face_fabrics_0 + face_3];
}

fn camera_origin_0() -> vec3<f32>
{
    return vec3<f32>(frame_record_0.origin_x_0, frame_record_0.origin_y_0, frame_record_0.origin_z_0);
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

fn pixel_direction_0( _S21 : vec2<u32>,  _S22 : vec2<f32>) -> vec3<f32>
{
    return camera_forward_0() + vec3<f32>(((f32(_S21.x) + 0.5f + _S22.x) * 2.0f / f32(frame_record_0.width_0) - 1.0f)) * camera_right_0() + vec3<f32>((1.0f - (f32(_S21.y) + 0.5f + _S22.y) * 2.0f / f32(frame_record_0.height_0))) * camera_up_0();
}

fn nearest_hit_0( _S23 : vec3<f32>,  _S24 : vec3<f32>,  _S25 : f32,  _S26 : f32,  _S27 : u32,  _S28 : bool) -> Hit_0
{
    var _S29 : vec3<f32> = vec3<f32>(inverse_of_0(_S24.x), inverse_of_0(_S24.y), inverse_of_0(_S24.z));
    var found_0 : Hit_0;
    found_0.face_1 = u32(4294967295);
    found_0.distance_0 = _S26;
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
        if(!meets_node_0(node_2, _S23, _S29, _S25, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            var _S30 : u32 = frame_record_0.leaves_0;
            if(node_2 < (frame_record_0.leaves_0))
            {
                node_3 = node_2 * u32(2);
            }
            else
            {
                var _S31 : u32 = frame_record_0.leaf_faces_0 + u32(4) * (node_2 - _S30);
                var _S32 : u32 = following_node_0(node_2);
                var number_0 : u32 = u32(0);
                node_3 = _S32;
                for(;;)
                {
                    if(number_0 < u32(4))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var _S33 : u32 = scene_words_0[_S31 + number_0];
                    if(((_S33 == u32(4294967295)) | ((_S33 == _S27))))
                    {
                        number_0 = number_0 + u32(1);
                        continue;
                    }
                    var _S34 : Hit_0 = meet_face_0(_S33, _S23, _S24);
                    if((((((_S34.face_1) == u32(4294967295)) | (((_S34.distance_0) <= _S25)))) | (((_S34.distance_0) >= (found_0.distance_0)))))
                    {
                        number_0 = number_0 + u32(1);
                        continue;
                    }
                    found_0 = _S34;
                    var _S35 : bool;
                    if(_S28)
                    {
                        _S35 = (fabrics_0[fabric_of_0(_S33)].is_open_0) == u32(0);
                    }
                    else
                    {
                        _S35 = false;
                    }
                    var node_4 : u32;
                    if(_S35)
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

@compute
@workgroup_size(8, 8, 1)
fn next_layer(@builtin(global_invocation_id) id_0 : vec3<u32>)
{
    var _S36 : u32 = id_0.x;
    var _S37 : bool;
    if(_S36 >= (frame_record_0.width_0))
    {
        _S37 = true;
    }
    else
    {
        _S37 = (id_0.y) >= (frame_record_0.height_0);
    }
    if(_S37)
    {
        return;
    }
    var _S38 : u32 = id_0.y * frame_record_0.width_0 + _S36;
    var _S39 : Layer_std430_0 = layers_0[_S38];
    if((layers_0[_S38].face_0) == u32(0))
    {
        return;
    }
    var following_0 : u32;
    if((_S39.share_0) > 0.00100000004749745f)
    {
        var _S40 : vec3<f32> = camera_origin_0();
        var _S41 : vec3<f32> = pixel_direction_0(id_0.xy, vec2<f32>(frame_record_0.jitter_x_0, frame_record_0.jitter_y_0));
        var _S42 : u32 = _S39.face_0 - u32(1);
        var _S43 : u32 = u32(3) * _S42;
        var _S44 : vec3<f32> = position_of_0(vertex_at_0(_S43));
        var _S45 : vec3<f32> = cross(position_of_0(vertex_at_0(_S43 + u32(1))) - _S44, position_of_0(vertex_at_0(_S43 + u32(2))) - _S44);
        var _S46 : f32 = dot(_S41, _S45);
        var _S47 : Hit_0 = nearest_hit_0(_S40, _S41, dot(_S44 - _S40, _S45) / select(1.00000000317107685e-30f, _S46, (abs(_S46)) > 1.00000000317107685e-30f) + frame_record_0.ray_offset_0, 1.00000001504746622e+30f, _S42, false);
        if((_S47.face_1) != u32(4294967295))
        {
            following_0 = select(u32(0), _S47.face_1 + u32(1), (fabrics_0[fabric_of_0(_S47.face_1)].uv_width_0) > 0.0f);
        }
        else
        {
            following_0 = u32(0);
        }
    }
    else
    {
        following_0 = u32(0);
    }
    layers_0[_S38].face_0 = following_0;
    return;
}

