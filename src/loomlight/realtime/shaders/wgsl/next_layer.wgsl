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

fn firstbitlow_0( value_0 : u32) -> u32
{
    var _S1 : u32 = firstTrailingBit(value_0);
    return _S1;
}

fn position_of_0( vertex_0 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_0).x_0, (*vertex_0).y_0, (*vertex_0).z_0);
}

fn position_of_1( vertex_1 : ptr<function, Vertex_std430_0>) -> vec3<f32>
{
    return vec3<f32>((*vertex_1).x_0, (*vertex_1).y_0, (*vertex_1).z_0);
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
    var _S10 : Vertex_std430_0 = vertices_0[corners_0[_S9]];
    var _S11 : vec3<f32> = position_of_0(&(_S10));
    var _S12 : Vertex_std430_0 = vertices_0[corners_0[_S9 + u32(1)]];
    var _S13 : vec3<f32> = position_of_0(&(_S12));
    var _S14 : vec3<f32> = _S13 - _S11;
    var _S15 : Vertex_std430_0 = vertices_0[corners_0[_S9 + u32(2)]];
    var _S16 : vec3<f32> = position_of_0(&(_S15));
    var _S17 : vec3<f32> = _S16 - _S11;
    var _S18 : vec3<f32> = cross(direction_0, _S17);
    var _S19 : f32 = dot(_S14, _S18);
    var _S20 : bool = (abs(_S19)) > 1.00000000317107685e-30f;
    var _S21 : f32 = 1.0f / select(1.00000000317107685e-30f, _S19, _S20);
    var _S22 : vec3<f32> = origin_1 - _S11;
    var _S23 : vec3<f32> = cross(_S22, _S14);
    var hit_0 : Hit_0;
    var _S24 : f32 = dot(_S22, _S18) * _S21;
    hit_0.weight_b_0 = _S24;
    var _S25 : f32 = dot(direction_0, _S23) * _S21;
    hit_0.weight_c_0 = _S25;
    hit_0.distance_0 = dot(_S17, _S23) * _S21;
    hit_0.face_1 = select(u32(4294967295), face_2, ((((((_S24 >= 0.0f) & ((_S25 >= 0.0f)))) & (((_S24 + _S25) <= 1.0f)))) & (_S20)));
    return hit_0;
}

fn camera_origin_0( _S26 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S26].origin_x_0, frames_0[_S26].origin_y_0, frames_0[_S26].origin_z_0);
}

fn camera_forward_0( _S27 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S27].forward_x_0, frames_0[_S27].forward_y_0, frames_0[_S27].forward_z_0);
}

fn camera_right_0( _S28 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S28].right_x_0, frames_0[_S28].right_y_0, frames_0[_S28].right_z_0);
}

fn camera_up_0( _S29 : i32) -> vec3<f32>
{
    return vec3<f32>(frames_0[_S29].up_x_0, frames_0[_S29].up_y_0, frames_0[_S29].up_z_0);
}

fn pixel_direction_0( _S30 : i32,  _S31 : vec2<u32>,  _S32 : vec2<f32>) -> vec3<f32>
{
    return camera_forward_0(_S30) + vec3<f32>(((f32(_S31.x) + 0.5f + _S32.x) * 2.0f / f32(frames_0[_S30].width_0) - 1.0f)) * camera_right_0(_S30) + vec3<f32>((1.0f - (f32(_S31.y) + 0.5f + _S32.y) * 2.0f / f32(frames_0[_S30].height_0))) * camera_up_0(_S30);
}

fn nearest_hit_0( _S33 : i32,  _S34 : vec3<f32>,  _S35 : vec3<f32>,  _S36 : f32,  _S37 : f32,  _S38 : u32,  _S39 : bool) -> Hit_0
{
    var _S40 : vec3<f32> = vec3<f32>(inverse_of_0(_S35.x), inverse_of_0(_S35.y), inverse_of_0(_S35.z));
    var found_0 : Hit_0;
    found_0.face_1 = u32(4294967295);
    found_0.distance_0 = _S37;
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
        if(!meets_node_0(node_2, _S34, _S40, _S36, found_0.distance_0))
        {
            node_3 = following_node_0(node_2);
        }
        else
        {
            var _S41 : u32 = frames_0[_S33].leaves_0;
            if(node_2 < (frames_0[_S33].leaves_0))
            {
                node_3 = node_2 * u32(2);
            }
            else
            {
                var _S42 : u32 = frames_0[_S33].leaf_faces_0 + u32(4) * (node_2 - _S41);
                var _S43 : u32 = following_node_0(node_2);
                var number_0 : u32 = u32(0);
                node_3 = _S43;
                for(;;)
                {
                    if(number_0 < u32(4))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var _S44 : u32 = scene_words_0[_S42 + number_0];
                    if(((_S44 == u32(4294967295)) | ((_S44 == _S38))))
                    {
                        number_0 = number_0 + u32(1);
                        continue;
                    }
                    var _S45 : Hit_0 = meet_face_0(_S44, _S34, _S35);
                    if((((((_S45.face_1) == u32(4294967295)) | (((_S45.distance_0) <= _S36)))) | (((_S45.distance_0) >= (found_0.distance_0)))))
                    {
                        number_0 = number_0 + u32(1);
                        continue;
                    }
                    found_0 = _S45;
                    var _S46 : bool;
                    if(_S39)
                    {
                        _S46 = (fabrics_0[face_fabrics_0[_S44]].is_open_0) == u32(0);
                    }
                    else
                    {
                        _S46 = false;
                    }
                    var node_4 : u32;
                    if(_S46)
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
    var _S47 : u32 = id_0.x;
    var _S48 : u32 = frames_0[i32(0)].width_0;
    var _S49 : bool;
    if(_S47 >= (frames_0[i32(0)].width_0))
    {
        _S49 = true;
    }
    else
    {
        _S49 = (id_0.y) >= (frames_0[i32(0)].height_0);
    }
    if(_S49)
    {
        return;
    }
    var _S50 : u32 = id_0.y * _S48 + _S47;
    var _S51 : Layer_std430_0 = layers_0[_S50];
    if((layers_0[_S50].face_0) == u32(0))
    {
        return;
    }
    var following_0 : u32;
    if((_S51.share_0) > 0.00100000004749745f)
    {
        var _S52 : vec3<f32> = camera_origin_0(i32(0));
        var _S53 : vec3<f32> = pixel_direction_0(i32(0), id_0.xy, vec2<f32>(frames_0[i32(0)].jitter_x_0, frames_0[i32(0)].jitter_y_0));
        var _S54 : u32 = _S51.face_0 - u32(1);
        var _S55 : u32 = u32(3) * _S54;
        var _S56 : Vertex_std430_0 = vertices_0[corners_0[_S55]];
        var _S57 : vec3<f32> = position_of_1(&(_S56));
        var _S58 : Vertex_std430_0 = vertices_0[corners_0[_S55 + u32(1)]];
        var _S59 : vec3<f32> = position_of_1(&(_S58));
        var _S60 : Vertex_std430_0 = vertices_0[corners_0[_S55 + u32(2)]];
        var _S61 : vec3<f32> = position_of_1(&(_S60));
        var _S62 : vec3<f32> = cross(_S59 - _S57, _S61 - _S57);
        var _S63 : f32 = dot(_S53, _S62);
        var _S64 : Hit_0 = nearest_hit_0(i32(0), _S52, _S53, dot(_S57 - _S52, _S62) / select(1.00000000317107685e-30f, _S63, (abs(_S63)) > 1.00000000317107685e-30f) + frames_0[i32(0)].ray_offset_0, 1.00000001504746622e+30f, _S54, false);
        following_0 = select(_S64.face_1 + u32(1), u32(0), (_S64.face_1) == u32(4294967295));
    }
    else
    {
        following_0 = u32(0);
    }
    layers_0[_S50].face_0 = following_0;
    return;
}

